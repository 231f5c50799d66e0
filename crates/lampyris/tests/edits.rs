//! Edited is fresh: after any sequence of edits a world is, as light sees it, the world built anew of the edited scene.

mod stage;

use glam::{Affine3A, Vec3};
use lampyris::Rgb;
use lampyris::backend::{Batch, Settings};
use lampyris::geometry::Ray;
use lampyris::import;
use lampyris::light::{Light, LightKind, State};
use lampyris::material::Material;
use lampyris::particle::{Plan, Vpl, Walk};
use lampyris::scene::{Camera, Edit, Instance, Scene};
use lampyris::world::World;
use stage::support::{diffuse, glass, say};
use stage::{Chance, some_edit, stage};
use std::collections::HashSet;

/// Everything but rays.
fn same_figures(edited: &World, fresh: &World, when: &str) {
    let bits = |w: &World| {
        let b = w.bounds();
        let [x, y, z] = b.center.to_array();
        [x, y, z, b.radius, w.area(), w.mean_reflectance()].map(f32::to_bits)
    };
    assert_eq!(bits(edited), bits(fresh), "{when}");
    assert_eq!(edited.shares(), fresh.shares(), "{when}");
    assert_eq!(edited.mix(), fresh.mix(), "{when}");
    assert_eq!(edited.mirrors(), fresh.mirrors(), "{when}");
    assert_eq!(edited.bodies().all(), fresh.bodies().all(), "{when}");
    let told = |w: &World| (w.has_lamps(), w.has_environment(), w.has_sharp_surfaces());
    assert_eq!(told(edited), told(fresh), "{when}");
    for (k, (a, b)) in edited.emitters().iter().zip(fresh.emitters()).enumerate() {
        assert_eq!(format!("{a:?}"), format!("{b:?}"), "emitter {k} {when}");
    }
    assert_eq!(edited.scene().reference, fresh.scene().reference, "{when}");
}

/// Rays by chance: what they meet, what it is made of, what they pass, and packets of them.
fn same_rays(edited: &World, fresh: &World, rays: usize, c: &mut Chance, when: &str) -> usize {
    let mut hits = 0;
    for _ in 0..rays {
        let (origin, direction, target) = (c.point(), c.direction(), c.point());
        let ray = Ray::new(origin, direction);
        let (a, b) = (edited.tracer().closest(&ray), fresh.tracer().closest(&ray));
        assert_eq!(a, b, "{when}");
        let blocked = |w: &World| w.tracer().blocked(origin, target);
        assert_eq!(blocked(edited), blocked(fresh), "{when}");
        let Some(hit) = a else { continue };
        let seen = |w: &World| {
            let s = w.surface(direction, &hit);
            let side = w.emitter_of(&s);
            let body = w.bodies().of(&s);
            format!("{s:?} {side:?} {body:?} {} {:?}", w.pdf_toward(&s, origin), w.all_flat(hit.instance))
        };
        assert_eq!(seen(edited), seen(fresh), "{when}");
        let glows = |w: &World| {
            let mut all = String::new();
            w.glows(origin, direction, hit.t, |glow| all += &format!("{glow:?}"));
            let chosen = w.choose_emitters(direction.x.abs());
            (all, chosen.map(|(k, chance)| (k, chance.to_bits())).collect::<Vec<_>>())
        };
        assert_eq!(glows(edited), glows(fresh), "{when}");
        hits += 1;
    }
    let origin = c.point();
    let mut vectors = || {
        let all: [Vec3; 16] = std::array::from_fn(|_| c.point());
        [0, 1, 2].map(|axis| all.map(|p| p[axis]))
    };
    let (directions, targets) = (vectors(), vectors());
    let packet = |w: &World| w.tracer().closest16(origin, &directions, u16::MAX);
    assert_eq!(packet(edited), packet(fresh), "{when}");
    let shadows = |w: &World| w.tracer().occluded16(origin, &targets, u16::MAX);
    assert_eq!(shadows(edited), shadows(fresh), "{when}");
    hits
}

#[test]
fn ten_thousand_random_edits() {
    let mut c = Chance::new(7);
    let mut world = World::new(stage());
    let (mut hits, mut refused) = (0, 0);
    let mut kinds = std::collections::HashMap::new();
    for step in 0..10_000 {
        // Now and then it all begins anew, lest everything ends up far away and dark.
        if step % 250 == 0 {
            world = World::new(stage());
        }
        let edit = some_edit(world.scene(), &mut c);
        let when = format!("at step {step}, after {edit:?}");
        match world.apply(&edit) {
            Ok(changes) => *kinds.entry((std::mem::discriminant(&edit), changes.any())).or_insert(0) += 1,
            Err(_) => refused += 1,
        }
        if step % 5 == 0 || step % 250 > 244 {
            let fresh = World::new(world.scene().clone());
            same_figures(&world, &fresh, &when);
            hits += same_rays(&world, &fresh, if step % 250 == 249 { 400 } else { 8 }, &mut c, &when);
        }
    }
    assert!(hits > 8_000 && refused < 100, "{hits} hits, {refused} refused");
    assert!(kinds.len() >= 12, "{kinds:?}");
}

/// The inverse of an edit takes all of it back, also of one that takes something away.
#[test]
fn what_was_done_is_undone() {
    let mut c = Chance::new(3);
    let mut world = World::new(stage());
    let mut inverses = Vec::new();
    let mut states = Vec::new();
    for _ in 0..300 {
        let edit = some_edit(world.scene(), &mut c);
        states.push(format!("{:?} {:?}", world.scene().lights, world.scene().materials));
        inverses.push(world.apply(&edit).expect("a sound edit").inverse);
    }
    for (inverse, state) in inverses.into_iter().zip(states).rev() {
        world.apply(&inverse).expect("an inverse");
        let scene = world.scene();
        // What was added is away now: its number is all that is left.
        let lights = scene.lights.iter().filter(|l| l.name != "new" || l.state != State::Away);
        let now = format!("{:?} {:?}", lights.collect::<Vec<_>>(), scene.materials);
        assert!(now == state || state.contains("\"new\""), "{now}\n{state}");
    }
    let first = stage();
    let scene = world.scene();
    assert_eq!(scene.instances[..first.instances.len()], first.instances[..]);
    assert!(scene.instances[first.instances.len()..].iter().all(|i| i.mesh == Instance::AWAY));
    assert_eq!(scene.lights[..first.lights.len()], first.lights[..]);
    assert_eq!(scene.materials, first.materials);
    let fresh = World::new(first);
    let rays = same_rays(&world, &World::new(scene.clone()), 500, &mut c, "undone");
    assert!(rays > 300);
    // Who shone meanwhile keeps an entry; the shares of the others are what they were.
    assert_eq!(world.shares()[..fresh.shares().len()], fresh.shares()[..]);
    assert!(
        world.shares()[fresh.shares().len()..].iter().all(|p| *p == 0.0)
            || scene.lights[1] == stage().lights[1]
    );
}

/// The particles of a batch, without those of emitters that the edits are about, are in every walk after them.
#[test]
fn nobody_elses_particles_change() {
    let settings = Settings { paths: 400, ..Settings::default() };
    let mut world = World::new(stage());
    let walk = |world: &World| {
        let plan = Plan::new(world, &settings);
        let walk = Walk::new(world, &settings, &plan, Batch { index: 5 });
        let bits = |v: &Vpl<'_>| {
            let [x, y, z] = v.position.to_array();
            let [r, g, b] = v.intensity.to_array();
            [x, y, z, r, g, b].map(f32::to_bits)
        };
        walk.lights.iter().chain(&walk.vpls).map(bits).collect::<HashSet<_>>()
    };
    let lamp = |x: f32| LightKind::Point { position: Vec3::new(x, 1.1, 1.1), intensity: Rgb::grey(2.0) };
    let off = |light: u32| Edit::Switch { light, state: State::Off };
    world.apply(&off(0)).expect("a sound edit");
    let others = walk(&world);
    let edits = [
        Edit::Switch { light: 0, state: State::On },
        Edit::Light { light: 0, kind: lamp(0.3) },
        Edit::Light { light: 0, kind: lamp(0.4) },
        Edit::Light { light: 1, kind: lamp(0.5) },
        Edit::AddLight { light: Light::new("", lamp(0.9)) },
        Edit::Switch { light: 0, state: State::Away },
    ];
    let mut before = others.clone();
    for edit in &edits {
        world.apply(edit).expect("a sound edit");
        let now = walk(&world);
        assert!(others.len() > 300 && now != before, "{edit:?}");
        assert!(
            others.is_subset(&now),
            "{} of {} after {edit:?}",
            others.intersection(&now).count(),
            others.len()
        );
        before = now;
    }
}

/// What makes no sense is refused, and changes nothing.
#[test]
fn unsound_edits_change_nothing() {
    let scene = stage();
    let nan = f32::NAN;
    let far = scene.instances.len() as u32;
    let flat = Affine3A::from_scale(Vec3::new(1.0, 0.0, 1.0));
    let point = |intensity| LightKind::Point { position: Vec3::ZERO, intensity };
    let object = |mesh, transform| Instance { name: String::new(), mesh, transform };
    let camera = |fov_y| Some(Camera { fov_y, ..scene.view.clone().expect("a view") });
    let glow = |emission| Material { emission, ..Material::new("", diffuse(0.5)) };
    let boxed = Box::new;
    let edits = [
        Edit::Light { light: 5, kind: point(Rgb::WHITE) },
        Edit::Light { light: 0, kind: point(Rgb::grey(nan)) },
        Edit::Light { light: 0, kind: point(Rgb::grey(1e19)) },
        Edit::Switch { light: u32::MAX, state: State::Off },
        Edit::AddLight { light: Light::new("", point(Rgb::grey(f32::INFINITY))) },
        Edit::Move { instance: far, transform: Affine3A::IDENTITY },
        Edit::Move { instance: 0, transform: flat },
        Edit::Move { instance: 0, transform: Affine3A::from_translation(Vec3::splat(nan)) },
        Edit::Mesh { instance: far, mesh: None },
        Edit::Mesh { instance: 0, mesh: Some(99) },
        Edit::Mesh { instance: 0, mesh: Some(Instance::AWAY) },
        Edit::AddInstance { instance: object(99, Affine3A::IDENTITY) },
        Edit::AddInstance { instance: object(0, flat) },
        Edit::Material { material: 99, to: boxed(Material::new("", glass())) },
        Edit::Material { material: 0, to: boxed(Material::new("", diffuse(1.5))) },
        Edit::Material { material: 0, to: boxed(glow(Rgb::grey(nan))) },
        Edit::Emission { material: 99, emission: Rgb::WHITE },
        Edit::Emission { material: 0, emission: Rgb::grey(2e18) },
        Edit::View { camera: camera(180.0) },
        Edit::View { camera: camera(nan) },
    ];
    let mut world = World::new(scene.clone());
    let before = format!("{:?}", world.scene());
    for edit in &edits {
        let error = world.apply(edit).expect_err("unsound").to_string();
        assert!(error.starts_with("cannot edit: "), "{error}");
        assert_eq!(format!("{:?}", world.scene()), before, "{edit:?}");
    }
    let fresh = World::new(world.scene().clone());
    same_figures(&world, &fresh, "refused");
    assert!(same_rays(&world, &fresh, 500, &mut Chance::new(1), "refused") > 300);
}

/// Whatever is done to one lamp, the shares of the others stay; an added one brings its own by the same scale.
#[test]
fn shares_are_fixed_by_what_shone_first() {
    let mut scene = Scene { ..stage() };
    scene.environment = Rgb::BLACK;
    let mut world = World::new(scene);
    let at_first = world.shares().to_vec();
    let total: f32 = at_first.iter().sum();
    assert!((total - 1.0).abs() < 1e-5, "{total}");
    let lamp = |lumens: f32| LightKind::Point {
        position: Vec3::splat(0.9),
        intensity: Rgb::grey(lumens / (4.0 * std::f32::consts::PI)),
    };
    let mut apply = |edit: Edit| {
        let changes = world.apply(&edit).expect("a sound edit");
        (changes, world.shares().to_vec())
    };
    // A hundredfold power, no power, another kind in another place, switched off: the shares are what they were.
    for kind in
        [lamp(2000.0), lamp(0.0), LightKind::Sphere { center: Vec3::ONE, radius: 0.1, radiance: Rgb::WHITE }]
    {
        let (changes, shares) = apply(Edit::Light { light: 0, kind });
        assert_eq!((shares, changes.emitters), (at_first.clone(), vec![0]));
    }
    assert_eq!(apply(Edit::Switch { light: 0, state: State::Off }).1, at_first);
    // Taken away, it takes its own along; brought back, it has it again.
    let (_, gone) = apply(Edit::Switch { light: 0, state: State::Away });
    assert_eq!((gone[0], &gone[1..]), (0.0, &at_first[1..]));
    assert_eq!(apply(Edit::Switch { light: 0, state: State::On }).1, at_first);
    // The flux of the whole file, of which light 0 had 20 lm.
    let all = 20.0 / at_first[0];
    let (changes, added) = apply(Edit::AddLight { light: Light::new("", lamp(40.0)) });
    let number = at_first.len();
    assert_eq!((&added[..number], changes.emitters), (&at_first[..], vec![number as u32]));
    assert!((added[number] * all / 40.0 - 1.0).abs() < 1e-5);
    // One that was dark in the file refers to what it is given first.
    apply(Edit::Light { light: 1, kind: lamp(10.0) });
    let (_, lit) = apply(Edit::Light { light: 1, kind: lamp(300.0) });
    assert_eq!(&lit[..=number], &added[..]);
    assert!((lit[number + 1] * all / 10.0 - 1.0).abs() < 1e-5);
    // However bright, none brings more paths than the file has.
    let (_, sun) = apply(Edit::AddLight { light: Light::new("", lamp(1e12)) });
    assert_eq!((&sun[..number + 2], sun[number + 2]), (&lit[..], 1.0));
}

/// An object of 10 000 triangles in a room of 135 000, moved for the first time and again.
#[test]
#[ignore = "needs LAMPYRIS_SCENES"]
fn an_object_moves_within_a_frame() {
    let folder = std::env::var_os("LAMPYRIS_SCENES").expect("LAMPYRIS_SCENES names the folder of scenes");
    let file = std::path::Path::new(&folder).join("generated/room/room.glb");
    let mut scene = import::load(&file, &import::Options::default()).expect("a scene").scene;
    let triangles = |scene: &Scene, k: usize| scene.meshes[scene.instances[k].mesh as usize].triangles.len();
    let object = (0..scene.instances.len()).max_by_key(|k| triangles(&scene, *k)).expect("an object");
    let mesh = scene.instances[object].mesh as usize;
    scene.meshes[mesh].triangles.truncate(10_000);
    scene.meshes[mesh].materials.truncate(10_000);
    assert_eq!(triangles(&scene, object), 10_000);
    let mut least = [f64::INFINITY; 2];
    for _ in 0..5 {
        let mut world = World::new(scene.clone());
        for step in 0..5 {
            let shift = Affine3A::from_translation(Vec3::X * (0.01 * (step + 1) as f32));
            let transform = shift * scene.instances[object].transform;
            let start = std::time::Instant::now();
            world.apply(&Edit::Move { instance: object as u32, transform }).expect("a sound edit");
            let least = &mut least[usize::from(step > 0)];
            *least = start.elapsed().as_secs_f64().min(*least);
        }
    }
    let [first, again] = least.map(|t| 1e3 * t);
    say(format_args!("the first time {first:.1} ms, again {again:.1} ms"));
    assert!(first < 20.0 && again < 20.0);
}
