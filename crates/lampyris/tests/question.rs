//! What lights a point: lamp by lamp and way by way, against closed forms, against lamps that are switched off, and against
//! a meter that does not ask.

mod stage;

use glam::Vec3;
use lampyris::Rgb;
use lampyris::backend::{Backend, Batch, Settings};
use lampyris::cpu::{Answer, Cpu, Question, Reading};
use lampyris::eye::{Eye, Meter};
use lampyris::light::{LightKind, State};
use lampyris::scene::{Camera, Edit, Scene};
use lampyris::session::Session;
use lampyris::world::World;
use stage::support::{Build, FAST, close, glass, gloss, meter, say, settings};
use std::f32::consts::PI;

fn open(mut scene: Scene) -> Session {
    let (eye, target) = (Vec3::new(1.8, 1.2, 1.8), Vec3::new(0.3, 0.4, 0.3));
    scene.view = Some(Camera { name: String::new(), eye, target, up: Vec3::Y, fov_y: 70.0 });
    let picture = Settings { photons: 100, ..settings(FAST, 8, 1, 1) };
    Session::open(scene, [8, 8], &picture, Some(2)).expect("a view")
}

fn separated(scene: Scene) -> Scene {
    let mut world = World::new(scene);
    world.separate(16).expect("a scene that was read");
    world.scene().clone()
}

fn pursued(session: &mut Session, at: Meter, settings: &Settings, batches: u32) -> (Question, Answer) {
    let mut question = Question::new(at, settings).expect("sound");
    for _ in 0..batches {
        assert!(session.pursue(&mut question, &|| true).expect("a batch"));
    }
    let answer = session.answer(&question).expect("open");
    assert_eq!((answer.batches(), question.batches()), (batches, batches));
    (question, answer)
}

/// A room with a mirror and a ball of glass, lit by lamps of several kinds.
fn room() -> Scene {
    let mut b = Build(Scene::default());
    let (wall, mirror) =
        (b.grey(0.5), b.material(gloss(0.0, 0.9, 0.0), 0.0, lampyris::material::Sides::Both));
    let clear = b.material(glass(), 0.0, lampyris::material::Sides::Both);
    b.room(Vec3::ZERO, Vec3::splat(2.0), [wall, mirror, wall, wall, wall, wall]);
    b.sphere(Vec3::new(1.0, 0.5, 1.0), 0.3, 2, false, |_| clear);
    b.bulb(Vec3::new(0.4, 1.6, 0.5), 200.0);
    b.light(LightKind::Sphere {
        center: Vec3::new(1.0, 1.6, 1.0),
        radius: 0.2,
        radiance: Rgb::new(90.0, 60.0, 30.0),
    });
    let (center, normal) = (Vec3::new(1.7, 1.2, 0.4), Vec3::NEG_X);
    b.light(LightKind::Disc { center, normal, radius: 0.1, radiance: Rgb::grey(400.0) });
    b.bulb(Vec3::new(1.2, 1.7, 1.5), 50.0);
    b.0
}

fn near(found: Reading, expected: Reading, what: &str) {
    let most = 1.5 * (found.error + expected.error) + 1e-4 * expected.lux;
    assert!((found.lux - expected.lux).abs() <= most, "{what}: {found:?} for {expected:?}");
}

/// E = I cos θ / d² of each lamp, and nothing by any other way.
#[test]
fn two_lamps_over_a_black_floor() {
    let mut b = Build(Scene::default());
    let black = b.grey(0.0);
    b.quad(Vec3::new(-5.0, 0.0, -5.0), Vec3::Z * 10.0, Vec3::X * 10.0, black);
    let lamps = [(Vec3::new(0.0, 2.0, 0.0), 500.0), (Vec3::new(1.5, 1.0, -2.0), 120.0)];
    lamps.iter().for_each(|(at, flux)| b.bulb(*at, *flux));
    let at = Vec3::new(0.3, 0.0, 0.2);
    let (_, answer) = pursued(&mut open(b.0), meter(at, Vec3::Y), &settings(FAST, 64, 4, 1), 4);
    let mut total = 0.0;
    for (number, (lamp, flux)) in (0..).zip(lamps) {
        let d = lamp - at;
        let expected = flux / (4.0 * PI) * d.normalize().y / d.length_squared();
        let shares = answer.of(&[number]);
        close("direct light", shares.direct.lux.into(), expected.into(), 1e-4);
        assert!(shares.direct.error < 1e-4 * expected, "nothing is left to chance: {shares:?}");
        assert!(shares.all == shares.direct && shares.indirect.lux == 0.0 && shares.caustic.lux == 0.0);
        total += expected;
    }
    close("both", answer.total().all.lux.into(), total.into(), 1e-4);
    assert_eq!(answer.of(&[7, 99]).all.lux, 0.0);
}

/// In a sphere of reflectance ρ each lamp of flux Φ gives Φ ρ / ((1 − ρ) 4πR²) by way of the wall, everywhere on the wall and
/// wherever the lamp is; in the centre of it E = I/R² comes straight.
#[test]
fn lamps_in_a_sphere() {
    let (radius, rho) = (1.5, 0.6);
    let mut b = Build(Scene::default());
    let wall = b.grey(rho);
    b.sphere(Vec3::ZERO, radius, 4, true, |_| wall);
    let lamps = [(Vec3::ZERO, 300.0), (Vec3::new(0.2, -0.5, 0.4), 1000.0), (Vec3::new(-0.6, 0.1, 0.0), 20.0)];
    lamps.iter().for_each(|(at, flux)| b.bulb(*at, *flux));
    let normal = Vec3::new(1.0, 2.0, -0.5).normalize();
    let parts = &["direct", "vpl", "compensation"];
    let at = meter(normal * (radius * -0.99), normal);
    let (_, answer) = pursued(&mut open(b.0), at, &settings(parts, 1024, 64, 1), 16);
    let area = 4.0 * PI * radius * radius;
    for (number, (_, flux)) in (0..).zip(lamps) {
        let shares = answer.of(&[number]);
        let expected = flux * rho / ((1.0 - rho) * area);
        say(format_args!("lamp {number}: {:?}, expected {expected}", shares.indirect));
        let off = (shares.indirect.lux - expected).abs();
        assert!(off < shares.indirect.error + 0.01 * expected, "lamp {number}: {shares:?} for {expected}");
        assert!(shares.indirect.error < 0.1 * expected);
    }
    // The meter stands 1 % before the wall.
    close("direct light", answer.of(&[0]).direct.lux.into(), (300.0 / area / 0.99 / 0.99).into(), 1e-4);
}

/// All lamps and all ways make the meter's figure. Where each lamp's number of light paths is whole, light points and virtual
/// lights are the meter's own, and where these are all, the sum is the same to within rounding; else to within the errors.
#[test]
fn shares_add_up_to_the_meter() {
    let at = meter(Vec3::new(1.3, 0.01, 0.6), Vec3::Y);
    let mut equal = room();
    equal.lights.truncate(1);
    for x in [0.7, 1.1, 1.5] {
        let LightKind::Point { intensity, .. } = equal.lights[0].kind else { unreachable!("a bulb") };
        let position = Vec3::new(x, 1.7, 1.0);
        equal
            .lights
            .push(lampyris::light::Light::new(x.to_string(), LightKind::Point { position, intensity }));
    }
    for (scene, groups, exact) in
        [(equal.clone(), false, true), (equal, true, true), (room(), false, false), (room(), true, false)]
    {
        let scene = if groups { separated(scene) } else { scene };
        let parts = if exact { &["direct", "vpl"][..] } else { FAST };
        let settings = Settings { clamp: if exact { 0.0 } else { 1.5 }, ..settings(parts, 256, 16, 3) };
        let mut session = open(scene);
        session.measure(&[at], &settings).expect("sound");
        session.settle_meters(8).expect("batches");
        let (_, answer) = pursued(&mut session, at, &settings, 8);
        let frame = session.meters().expect("a meter");
        let error = frame.standard_error(0) * frame.student_factor() * PI;
        let plain = Reading { lux: frame.mean()[0].luminance() * PI, error };
        let total = answer.total();
        if exact {
            close("all lamps", total.all.lux.into(), plain.lux.into(), 2e-5);
            close("error", total.all.error.into(), error.into(), 1e-2);
        } else {
            near(total.all, plain, "all lamps");
            assert!(total.caustic.lux > 0.0 && total.indirect.lux > 0.0 && total.direct.lux > 0.0);
        }
        let lamps: Vec<f64> = (0..4).map(|k| answer.of(&[k]).all.lux.into()).collect();
        assert!(lamps.iter().all(|lux| *lux > 0.0));
        close("lamp by lamp", lamps.iter().sum(), total.all.lux.into(), 1e-5);
        let ways: f32 = [total.direct, total.indirect, total.caustic].map(|r| r.lux).iter().sum();
        close("way by way", ways.into(), total.all.lux.into(), 1e-5);
        close("in any order", answer.of(&[3, 1, 0, 2]).all.lux.into(), total.all.lux.into(), 1e-6);
    }
}

/// The share of a lamp is what the meter shows where all others are off.
#[test]
fn a_lamps_share_is_its_light_alone() {
    let at = meter(Vec3::new(1.3, 0.01, 0.6), Vec3::Y);
    let settings = settings(FAST, 256, 16, 3);
    let mut session = open(separated(room()));
    let (_, answer) = pursued(&mut session, at, &settings, 16);
    for lamp in 0..4 {
        for light in 0..4 {
            let state = if light == lamp { State::On } else { State::Off };
            session.edit(&Edit::Switch { light, state }).expect("sound");
        }
        let (_, alone) = pursued(&mut session, at, &settings, 16);
        let (share, alone) = (answer.of(&[lamp]), alone.total());
        say(format_args!("lamp {lamp}: {share:?}"));
        near(share.all, alone.all, "in all");
        near(share.direct, alone.direct, "direct");
        near(share.indirect, alone.indirect, "indirect");
        near(share.caustic, alone.caustic, "caustic");
    }
}

/// A question disturbs nobody, is asked anew when light changes, and follows levels at once.
#[test]
fn questions_keep_to_themselves() {
    let at = meter(Vec3::new(1.3, 0.01, 0.6), Vec3::Y);
    let settings = settings(FAST, 64, 4, 3);
    let (mut session, mut alone) = (open(separated(room())), open(separated(room())));
    let mut question = Question::new(at, &settings).expect("sound");
    assert_eq!(session.answer(&question).expect("open").total().all.error, f32::INFINITY);
    for step in 0..6 {
        session.step().expect("a batch");
        alone.step().expect("a batch");
        session.pursue(&mut question, &|| true).expect("a batch");
        assert!(!session.pursue(&mut question, &|| false).expect("given up"));
        assert_eq!(question.batches(), step + 1);
    }
    let pictures = [&mut session, &mut alone].map(|s| s.frame().expect("open").mean());
    assert!(pictures[0] == pictures[1]);

    // The bulb's level changes: its share does, by as much, without a batch; one that looks elsewhere changes nothing.
    let before = session.answer(&question).expect("open");
    let group = session.world().expect("open").group_of(0);
    let color = session.scene().expect("open").groups[group].color;
    session.edit(&Edit::Mix { group: group as u16, color: color * 0.25 }).expect("sound");
    session.edit(&Edit::View { camera: session.scene().expect("open").view.clone() }).expect("sound");
    let dimmed = session.answer(&question).expect("open");
    assert_eq!(dimmed.batches(), 6);
    let [old, new] = [&before, &dimmed].map(|answer| answer.of(&[0]).all);
    close("dimmed", new.lux.into(), (0.25 * old.lux).into(), 1e-5);
    close("its error", new.error.into(), (0.25 * old.error).into(), 1e-4);
    assert_eq!(dimmed.of(&[1, 2, 3]), before.of(&[1, 2, 3]));

    // Light changes: what was known is not known any more, and what is found is what a fresh question finds.
    session.edit(&Edit::Switch { light: 2, state: State::Off }).expect("sound");
    assert_eq!(session.answer(&question).expect("open").batches(), 0);
    session.pursue(&mut question, &|| true).expect("a batch");
    session.pursue(&mut question, &|| true).expect("a batch");
    let edited = session.answer(&question).expect("open");
    let mut fresh = open(session.scene().expect("open").clone());
    let (_, fresh) = pursued(&mut fresh, at, &settings, 2);
    let told = |answer: &Answer| (0..4).map(|k| answer.of(&[k])).collect::<Vec<_>>();
    assert_eq!((edited.batches(), told(&edited), edited.total()), (2, told(&fresh), fresh.total()));
    assert_eq!(edited.of(&[2]).all.lux, 0.0);
    assert!(Question::new(at, &Settings { parts: vec!["path".into()], ..settings }).is_err());
}

/// Three hundred lamps have the light paths of one meter, and one more each at most; and what comes straight from each is
/// exact.
#[test]
fn many_lamps_take_few_more_paths() {
    let mut b = Build(Scene::default());
    let wall = b.grey(0.5);
    b.room(Vec3::ZERO, Vec3::splat(2.0), [wall; 6]);
    let place = |k: u32| Vec3::new(0.1 + 0.1 * (k % 18) as f32, 1.8, 0.1 + 0.1 * (k / 18) as f32);
    let flux = |k: u32| if k.is_multiple_of(7) { 0.01 } else { 5.0 };
    (0..300).for_each(|k| b.bulb(place(k), flux(k)));
    let at = meter(Vec3::new(1.3, 0.01, 0.6), Vec3::Y);
    let settings = Settings { replicates: 2, ..settings(FAST, 1024, 64, 3) };
    let mut session = open(b.0.clone());
    let (question, answer) = pursued(&mut session, at, &settings, 2);
    for k in 0..300 {
        let d = place(k) - at.position;
        let expected = flux(k) / (4.0 * PI) * d.normalize().y / d.length_squared();
        let direct = answer.of(&[k]).direct.lux;
        assert!((direct - expected).abs() < 1e-4 * expected, "lamp {k}: {direct} for {expected}");
    }
    let mut cpu = Cpu::new(Some(2)).expect("threads");
    cpu.begin(b.0, Eye::Meters(vec![at]), &settings).expect("sound");
    (0..2).for_each(|index| cpu.add(Batch { index }).expect("a batch"));
    let [asked, plain] = [question.statistics(), cpu.statistics()].map(|s| s.rays.particle as f64);
    say(format_args!("{asked} rays of particles, a meter has {plain}"));
    assert!(asked < (1.0 + 300.0 / 1024.0) * plain);
}

/// More lamps than a scene may have light groups, with mirrors and glass: by every way they add up to the meter.
#[test]
fn many_lamps_add_up_by_every_way() {
    let mut b = Build(room());
    (0..100).for_each(|k| b.bulb(Vec3::new(0.1 + 0.018 * k as f32, 1.8, 0.7), 5.0));
    let (at, settings) = (meter(Vec3::new(1.3, 0.01, 0.6), Vec3::Y), settings(FAST, 512, 32, 3));
    let mut session = open(b.0);
    session.measure(&[at], &settings).expect("sound");
    session.settle_meters(8).expect("batches");
    let (_, answer) = pursued(&mut session, at, &settings, 8);
    let frame = session.meters().expect("a meter");
    let error = frame.standard_error(0) * frame.student_factor() * PI;
    near(answer.total().all, Reading { lux: frame.mean()[0].luminance() * PI, error }, "all lamps");
    assert!((0..104).all(|k| answer.of(&[k]).all.lux > 0.0));
}
