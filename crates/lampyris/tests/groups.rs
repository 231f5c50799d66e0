//! Light groups: lamps told apart add up to the whole, are mixed without a ray, and leave each other alone.

mod stage;

use glam::Vec3;
use lampyris::Rgb;
use lampyris::backend::{Backend, Batch, Settings};
use lampyris::cpu::Cpu;
use lampyris::eye::Eye;
use lampyris::frame::Frame;
use lampyris::light::{Light, LightKind};
use lampyris::scene::{Camera, Edit, Group, Scene, View};
use lampyris::session::Session;
use lampyris::world::World;
use stage::support::{Build, FAST, close, say, settings};
use stage::{Chance, some_edit, stage};

const SIZE: [u32; 2] = [12, 8];

fn separated(scene: Scene, most: usize) -> Scene {
    let mut world = World::new(scene);
    world.separate(most).expect("a scene that was read");
    world.scene().clone()
}

fn picture(scene: Scene, settings: &Settings, batches: u32) -> Frame {
    let mut cpu = Cpu::new(Some(2)).expect("threads");
    let view = View::new(scene.view.as_ref().expect("a view"), SIZE[0], SIZE[1]);
    cpu.begin(scene, Eye::Camera(view), settings).expect("sound");
    (0..batches).for_each(|index| cpu.add(Batch { index }).expect("a batch"));
    cpu.frame().expect("begun").clone()
}

/// A grey room with lamps of different colours under its ceiling, named as a file would.
fn room(lamps: usize) -> Scene {
    let mut b = Build(Scene::default());
    let wall = b.grey(0.5);
    b.room(Vec3::ZERO, Vec3::splat(2.0), [wall; 6]);
    for k in 0..lamps {
        let at = Vec3::new(0.3 + 0.09 * k as f32, 1.8, 0.4 + 0.3 * (k % 4) as f32);
        let intensity = Rgb::new(1.0, 0.2 + 0.1 * (k % 3) as f32, 0.4) * 5.0;
        b.0.lights.push(Light::new(format!("lamp {k}"), LightKind::Point { position: at, intensity }));
    }
    let (eye, target) = (Vec3::new(1.8, 1.2, 1.8), Vec3::new(0.3, 0.4, 0.3));
    b.0.view = Some(Camera { name: String::new(), eye, target, up: Vec3::Y, fov_y: 70.0 });
    b.0
}

/// Only what draws no lamps by chance: then layers hold the very particles of the whole.
fn plain() -> Settings {
    Settings { clamp: 0.0, ..settings(&["emission", "direct", "vpl"], 24, 4, 3) }
}

fn assert_alike(found: &[Rgb], expected: &[Rgb]) {
    let most = expected.iter().map(|v| v.max_channel()).fold(0.0, f32::max);
    for (k, (a, b)) in found.iter().zip(expected).enumerate() {
        let off = (*a - *b).map(f32::abs).max_channel();
        assert!(off <= 3e-5 * most, "pixel {k}: {a:?} for {b:?}");
    }
}

#[test]
fn layers_add_up_to_the_whole_whatever_the_colours() {
    for (scene, most) in [(room(5), 16), (room(5), 2), (room(5), 1), (stage(), 16)] {
        let scene = Scene { view: scene.view.clone(), ..scene };
        let apart = separated(scene.clone(), most);
        assert!((1..=most).contains(&apart.groups.len()), "{:?}", apart.groups);
        // Two-sided glass and mirrors choose by chance, but the same chance for all groups.
        let whole = picture(scene, &plain(), 3);
        let sum = picture(apart, &plain(), 3);
        assert_alike(&sum.mean(), &whole.mean());
        let mut layers = vec![Rgb::BLACK; whole.mean().len()];
        for k in 0..sum.layers() {
            let layer = sum.layer(k).expect("a layer");
            layers.iter_mut().zip(layer).for_each(|(s, v)| *s += v);
        }
        assert_alike(&layers, &sum.mean());
        let shown = (0..sum.layers()).filter_map(|k| sum.shown_layer(k)).flatten().map(|v| v.luminance());
        let (shown, all): (f32, f32) = (shown.sum(), sum.shown().iter().map(|v| v.luminance()).sum());
        close("shown", shown.into(), all.into(), 1e-4);
        assert!((sum.relative_error() / whole.relative_error() - 1.0).abs() < 0.01);
    }
}

/// A group's picture in its colour is what its lamps alone would give, and any other mix is what lamps of those colours
/// would, also in a channel that the file's lamps do not have.
#[test]
fn a_mix_is_the_picture_of_lamps_so_dimmed_and_coloured() {
    let scene = room(3);
    let apart = separated(scene.clone(), 16);
    let colors = [Rgb::new(0.3, 0.6, 2.0), Rgb::BLACK, Rgb::new(0.0, 4.0, 0.0)];
    let mut session = Session::open(apart, SIZE, &plain(), Some(2)).expect("a scene with a view");
    session.settle(2).expect("batches");
    let traced = session.statistics();
    for (group, color) in (0..).zip(colors) {
        let changes = session.edit(&Edit::Mix { group, color }).expect("a sound edit");
        assert!(changes.mix && changes.any() && !changes.restarts_all() && changes.groups.is_empty());
    }
    assert_eq!(
        (session.frame().expect("open").batches(), session.statistics()),
        (2, traced),
        "no ray, no batch"
    );
    let mixed = session.frame().expect("open").mean();
    let mut lamps = scene;
    for (light, color) in lamps.lights.iter_mut().zip(colors) {
        let luminance = light.kind.brightness().luminance();
        light.kind = light.kind.clone().with_brightness(color * luminance);
    }
    // Shares of the paths are what the file's lamps had.
    lamps.reference = World::new(room(3)).scene().reference.clone();
    assert_alike(&mixed, &picture(lamps, &plain(), 2).mean());
    session.undo().expect("done").expect("an edit");
    session.redo().expect("done").expect("an edit");
    assert_eq!(session.frame().expect("open").mean(), mixed);
}

/// One of sixteen lamps is moved: its layer begins anew, with its share of the rays, and no other's changes by a bit.
#[test]
fn a_lamp_that_moves_leaves_the_others_alone() {
    let shown = Settings { filter: true, replicates: 2, ..Settings::interactive() };
    let fast = Settings { filter: false, picks: Some(4), ..settings(FAST, 64, 2, 1) };
    for (settings, size) in [(shown, [160, 120]), (fast, SIZE)] {
        let mut session = Session::open(separated(room(16), 16), size, &settings, Some(2)).expect("a view");
        session.settle(2).expect("batches");
        let rays = |s: &Session| {
            let r = s.statistics().rays;
            [r.shadow, r.eye + r.shadow + r.compensation + r.particle].map(|n| n as f64)
        };
        let first = rays(&session);
        let before: Vec<_> = (0..16).map(|k| session.frame().expect("open").layer(k)).collect();
        let LightKind::Point { position, intensity } = session.scene().expect("open").lights[5].kind else {
            panic!("a point")
        };
        let kind = LightKind::Point { position: position + Vec3::X * 0.1, intensity };
        let changes = session.edit(&Edit::Light { light: 5, kind }).expect("a sound edit");
        assert_eq!(changes.groups, [5]);
        session.settle(2).expect("batches");
        let second = rays(&session);
        let [shadow, all] = [0, 1].map(|k| (second[k] - first[k]) / first[k]);
        // Eye rays, and short rays that pay back what clamping took, all lamps share.
        say(format_args!("one lamp of sixteen: {shadow:.3} of the shadow rays, {all:.3} of all"));
        assert!(shadow < 1.0 / 16.0 + 0.02 && all < 0.25);
        for (k, before) in before.iter().enumerate() {
            let after = session.frame().expect("open").layer(k);
            assert_eq!(after == *before, k != 5, "layer {k}");
        }
        let scene = session.scene().expect("open").clone();
        let mut fresh = Session::open(scene, size, &settings, Some(1)).expect("a view");
        fresh.settle(2).expect("batches");
        let pictures = [&mut session, &mut fresh].map(|s| {
            let frame = s.frame().expect("open");
            (frame.mean(), frame.shown())
        });
        assert!(pictures[0] == pictures[1], "edited is fresh");
    }
}

/// Whatever is done, the picture has the bits of one begun anew; mixes, splits and ordinary edits in any order.
#[test]
fn edited_is_fresh_layer_by_layer() {
    let shown = Settings {
        photons: 200,
        interleave: [2, 2],
        picks: Some(4),
        light_points: Some(8),
        filter: true,
        window: 2,
        ..settings(FAST, 24, 1, 1)
    };
    let fast = Settings { photons: 200, ..settings(FAST, 12, 4, 1) };
    let mut c = Chance::new(29);
    let mut regrouped = 0;
    for round in 0..16 {
        let settings = if round % 2 == 0 { &fast } else { &shown };
        let most = [2, 5, 16][round % 3];
        let mut session = Session::open(separated(stage(), most), [8, 8], settings, Some(2)).expect("a view");
        for step in 0..60 {
            let scene = session.scene().expect("open").clone();
            let group = c.below(scene.groups.len()) as u16;
            let edit = match c.below(4) {
                0 => Edit::Mix { group, color: Rgb::new(c.unit(), c.unit(), c.unit()) },
                1 => {
                    let emitter = c.below(scene.reference.shares.len()) as u32;
                    Edit::Regroup { emitters: vec![emitter], group: group + c.below(2) as u16 }
                }
                _ => some_edit(&scene, &mut c),
            };
            match session.edit(&edit) {
                Ok(changes) => regrouped += u32::from(matches!(edit, Edit::Regroup { .. }) && changes.any()),
                Err(error) => panic!("{error}: {edit:?}"),
            }
            if step % 20 == 7 {
                session.step().expect("a batch");
            }
            if step % 30 == 20 {
                session.undo().expect("what was done can be undone");
            }
        }
        session.settle(3).expect("batches");
        let mut fresh =
            Session::open(session.scene().expect("open").clone(), [8, 8], settings, Some(1)).expect("a view");
        fresh.settle(3).expect("batches");
        let all = [&mut session, &mut fresh].map(|s| {
            let frame = s.frame().expect("open");
            let layers: Vec<_> = (0..frame.layers()).map(|k| (frame.batches_of(k), frame.layer(k))).collect();
            let errors = (frame.relative_error().to_bits(), frame.standard_error(9).to_bits());
            (frame.mean(), frame.shown(), layers, errors)
        });
        assert!(all[0] == all[1], "round {round}");
    }
    assert!(regrouped > 100, "{regrouped}");
}

#[test]
fn groups_are_luminaires_then_materials() {
    let names = |scene: &Scene| scene.groups.iter().map(|g| g.name.clone()).collect::<Vec<_>>();
    let scene = separated(room(5), 16);
    assert_eq!(names(&scene), ["lamp 0", "lamp 1", "lamp 2", "lamp 3", "lamp 4"]);
    // Lamps are white of the luminance that they had, and their colours the mix.
    for (group, (light, file)) in scene.groups.iter().zip(scene.lights.iter().zip(&room(5).lights)) {
        let (white, color) = (light.kind.brightness(), file.kind.brightness());
        assert_eq!([white.r, white.g], [white.b; 2]);
        close("luminance", white.luminance().into(), color.luminance().into(), 1e-6);
        close("colour", (group.color.r * white.r).into(), color.r.into(), 1e-5);
        close("of luminance 1", group.color.luminance().into(), 1.0, 1e-5);
    }
    // What is too many shares a group, in its own colours; one group is no colour at all.
    let two = separated(room(5), 2);
    let others = two.groups.iter().find(|g| g.name == "others").expect("a group");
    assert_eq!((two.groups.len(), others.color), (2, Rgb::WHITE));
    assert_eq!(names(&separated(room(5), 1)), ["others"]);
    // Separating again changes nothing; where nothing shines there is a group for what may be added.
    assert_eq!(separated(scene.clone(), 2).groups, scene.groups);
    assert_eq!(names(&separated(room(0), 16)), ["none"]);
}

/// A luminaire of several colours is one group all the same, and keeps them; its colour in the mix is a tint.
#[test]
fn a_luminaire_of_two_colours_is_one_group() {
    let mut file = room(3);
    file.lights[1].name = file.lights[0].name.clone();
    let scene = separated(file.clone(), 16);
    assert_eq!(scene.groups.len(), 2);
    assert_eq!(scene.groups[0].color, Rgb::WHITE);
    assert_eq!(scene.lights[0].kind, file.lights[0].kind);
    assert_eq!(scene.lights[1].kind, file.lights[1].kind);
    assert_ne!(scene.lights[2].kind, file.lights[2].kind);
}

#[test]
fn groups_that_do_not_exist_are_refused() {
    let whole = World::new(room(3)).scene().clone();
    let mut apart = separated(room(3), 16);
    let mut world = World::new(whole);
    let white = Rgb::WHITE;
    assert!(world.apply(&Edit::Mix { group: 0, color: white }).is_err(), "lamps are not told apart");
    assert!(world.apply(&Edit::Regroup { emitters: vec![0], group: 0 }).is_err());
    let bad = [
        Edit::Mix { group: 3, color: white },
        Edit::Mix { group: 0, color: Rgb::grey(f32::NAN) },
        Edit::Regroup { emitters: vec![0], group: 4 },
        Edit::Regroup { emitters: vec![9], group: 0 },
        Edit::Regroup { emitters: vec![], group: 0 },
        Edit::Regroup { emitters: vec![0, 1], group: 2 },
    ];
    let mut world = World::new(apart.clone());
    for edit in &bad {
        let error = world.apply(edit).expect_err("unsound").to_string();
        assert!(error.starts_with("cannot edit: "), "{error}");
        assert_eq!(world.scene().groups, apart.groups);
    }
    // The last possible group is shared by what is added.
    let more = vec![apart.lights[0].clone(); Group::MOST];
    apart.lights.extend(more);
    let crowded = World::new(apart);
    assert_eq!((crowded.groups(), crowded.group_of(Group::MOST as u32 + 2)), (Group::MOST, Group::MOST - 1));
}

/// Sums of pictures, each times a factor.
fn total(planes: &[(f32, Vec<Rgb>)]) -> Vec<Rgb> {
    let pixel = |k: usize| planes.iter().fold(Rgb::BLACK, |sum, (by, plane)| sum + plane[k] * *by);
    (0..planes[0].1.len()).map(pixel).collect()
}

/// A lamp is taken out of a group that it shares: each new batch of both takes the place of one before, what is dimmed
/// meanwhile is seen at once, and in the end the picture has the bits of one begun anew.
#[test]
fn what_is_regrouped_is_held_until_it_has_caught_up() {
    const BEFORE: u32 = 4;
    let shown = Settings { filter: true, passes: Some(1), replicates: 2, ..plain() };
    for settings in [plain(), shown] {
        let mut session =
            Session::open(separated(room(5), 2), SIZE, &settings, Some(2)).expect("a scene with a view");
        let others = session.scene().expect("open").reference.shares.clone();
        let shared = session.scene().expect("open").groups.iter().position(|g| g.name == "others");
        let (shared, apart, new) = (shared.expect("a group"), 1 - shared.expect("a group"), 2);
        let lamps: Vec<u32> = (0..5).filter(|k| usize::from(others[*k as usize].group) == shared).collect();
        session.settle(BEFORE).expect("batches");
        let first = session.frame().expect("open").clone();
        session.edit(&Edit::Regroup { emitters: vec![lamps[0]], group: new as u16 }).expect("sound");
        let (old, alone) = (first.shown_layer(shared).expect("a layer"), first.shown_layer(apart));
        let alone = alone.expect("a layer");
        assert_alike(&session.frame().expect("open").shown(), &first.shown());

        let dimmed = Rgb::new(0.25, 0.5, 3.0);
        for step in 0..BEFORE {
            let frame = session.frame().expect("open");
            let progress = frame.progress();
            let [held, free] = [shared, apart].map(|k| progress[k]);
            assert_eq!((held.batches, held.of, held.held), (step, BEFORE, true));
            assert_eq!((free.batches, free.of, free.held), (BEFORE, BEFORE, false));
            assert_eq!(progress[new], held);
            let place = step as f32 / BEFORE as f32;
            let layers = [shared, new].map(|k| frame.shown_layer(k).expect("a layer"));
            let expected = [
                (1.0, alone.clone()),
                (1.0 - place, old.clone()),
                (place, layers[0].clone()),
                (place, layers[1].clone()),
            ];
            assert_alike(&frame.shown(), &total(&expected));
            // Exact sums know nothing of it.
            let own = [shared, apart, new].map(|k| (1.0, frame.layer(k).expect("a layer")));
            assert_alike(&frame.mean(), &total(&own));

            let (shown, layer) = (frame.shown(), frame.shown_layer(new).expect("a layer"));
            let white = Edit::Mix { group: new as u16, color: Rgb::WHITE };
            session.edit(&Edit::Mix { group: new as u16, color: dimmed }).expect("sound");
            let change = layer.iter().map(|v| *v * (dimmed - Rgb::WHITE)).collect();
            assert_alike(&session.frame().expect("open").shown(), &total(&[(1.0, shown), (1.0, change)]));
            session.edit(&white).expect("sound");
            session.step().expect("a batch");
        }
        let scene = session.scene().expect("open").clone();
        let mut fresh = Session::open(scene, SIZE, &settings, Some(1)).expect("a view");
        fresh.settle(BEFORE).expect("batches");
        let frames = [&mut session, &mut fresh].map(|s| s.frame().expect("open").clone());
        assert!(frames[0].progress().iter().all(|p| !p.held));
        assert!(frames[0].shown() == frames[1].shown() && frames[0].mean() == frames[1].mean());
    }
}

/// To touch a lamp of a group gives it one of its own, once.
#[test]
fn a_lamp_is_split_off_once() {
    let mut session = Session::open(separated(room(4), 2), SIZE, &plain(), Some(2)).expect("a view");
    let groups = |s: &Session| {
        let scene = s.scene().expect("open");
        scene.reference.shares.iter().map(|share| share.group).collect::<Vec<_>>()
    };
    let before = groups(&session);
    let alone = (0..4).find(|k| before.iter().filter(|g| **g == before[*k]).count() == 1).expect("a lamp");
    let shared: Vec<u32> = (0..4).filter(|k| *k != alone as u32).collect();
    assert_eq!(session.split(&[alone as u32]).expect("alone"), before[alone]);
    assert_eq!(session.split(&shared).expect("all of a group"), before[shared[0] as usize]);
    assert!(session.log().is_empty() && groups(&session) == before);
    for _ in 0..2 {
        assert_eq!(session.split(&shared[1..2]).expect("sound"), 2);
    }
    assert_eq!((session.log().len(), groups(&session)[shared[1] as usize]), (1, 2));
    for bad in [&[][..], &[9], &[shared[0], alone as u32]] {
        assert!(session.split(bad).is_err(), "{bad:?}");
    }
    let mut whole = Session::open(room(4), SIZE, &plain(), Some(2)).expect("a view");
    assert!(whole.split(&[0]).is_err() && whole.split(&[0, 1, 2, 3]).is_err(), "no groups");
}

/// Held as long as it is true: through further splits, without what is another light, and not when somebody asks for
/// the picture of so many batches.
#[test]
fn what_is_no_longer_true_is_not_held() {
    let open = || {
        let mut session =
            Session::open(separated(room(5), 1), SIZE, &plain(), Some(2)).expect("a scene with a view");
        session.settle(3).expect("batches");
        session.edit(&Edit::Regroup { emitters: vec![0], group: 1 }).expect("sound");
        session.step().expect("a batch");
        session
    };
    let held = |s: &mut Session| -> Vec<bool> {
        s.frame().expect("open").progress().iter().map(|p| p.held).collect()
    };
    let shown = |s: &mut Session| s.frame().expect("open").shown();

    let mut split = open();
    let before = shown(&mut split);
    split.edit(&Edit::Regroup { emitters: vec![1], group: 2 }).expect("sound");
    assert_alike(&shown(&mut split), &before);
    split.undo().expect("done").expect("an edit");
    assert_alike(&shown(&mut split), &before);
    assert_eq!(held(&mut split), [true, true, true]);

    // The lamp that was split off moves: the others are held without it, if a batch tells what it gave.
    let mut moved = open();
    let LightKind::Point { position, intensity } = moved.scene().expect("open").lights[0].kind else {
        panic!("a point")
    };
    let kind = LightKind::Point { position: position + Vec3::X * 0.1, intensity };
    let (before, lamp) = (shown(&mut moved), moved.frame().expect("open").shown_layer(1).expect("a layer"));
    moved.edit(&Edit::Light { light: 0, kind: kind.clone() }).expect("sound");
    assert_eq!(held(&mut moved), [true, false]);
    assert_alike(&shown(&mut moved), &total(&[(1.0, before), (-1.0, lamp)]));

    let mut at_once = open();
    at_once.edit(&Edit::Regroup { emitters: vec![1], group: 2 }).expect("sound");
    at_once.edit(&Edit::Light { light: 1, kind }).expect("sound");
    assert_eq!(held(&mut at_once), [false, false, false]);
    let frame = at_once.frame().expect("open").clone();
    assert!(frame.shown() == frame.mean());

    // Into a group of another colour: the picture is another one.
    let mut colored = open();
    colored.settle(3).expect("batches");
    colored.edit(&Edit::Mix { group: 1, color: Rgb::grey(0.5) }).expect("sound");
    colored.edit(&Edit::Regroup { emitters: vec![1], group: 1 }).expect("sound");
    assert_eq!(held(&mut colored), [false, false]);

    let mut settled = open();
    settled.settle(1).expect("nothing to do");
    assert_eq!(held(&mut settled), [false, false]);
}
