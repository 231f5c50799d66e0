//! A sketch beside the picture follows edits as the picture does, and neither knows of the other; and a section shows what
//! stands behind it, in the light of the whole.

mod stage;

use glam::Vec3;
use lampyris::Rgb;
use lampyris::backend::Settings;
use lampyris::cpu::Cpu;
use lampyris::scene::{Camera, Edit, Scene, View};
use lampyris::session::{Session, Sketch};
use lampyris::testing::{Moments, sidak};
use lampyris::world::World;
use stage::support::{FAST, say, settings};
use stage::{Chance, some_edit, stage};

const SIZE: [u32; 2] = [12, 8];
const SMALL: [u32; 2] = [6, 4];

fn own(filter: bool) -> Settings {
    Settings { photons: 200, interleave: [2, 2], filter, ..settings(FAST, 24, 1, 1) }
}

fn sketchy() -> Settings {
    Settings { paths: 12, edges: 0, ..own(true) }
}

fn open(scene: Scene) -> Session {
    Session::open(scene, SIZE, &own(true), Some(2)).expect("a scene with a view")
}

fn bits(plane: &[Rgb]) -> Vec<u32> {
    plane.iter().flat_map(|v| v.to_array().map(f32::to_bits)).collect()
}

#[test]
fn a_sketch_is_a_picture_of_its_own() {
    let mut c = Chance::new(3);
    let mut session = open(stage());
    session.sketch(Some(Sketch { size: SMALL, settings: sketchy(), melted: None })).unwrap();
    for round in 0..12 {
        for _ in 0..3 {
            // Some edits make no sense in the scene as it stands.
            let edit = some_edit(session.scene().unwrap(), &mut c);
            let _ = session.edit(&edit);
            if c.unit() < 0.5 {
                session.step_sketch(&|| true).unwrap();
            }
            if c.unit() < 0.3 {
                session.step().unwrap();
            }
        }
        let scene = session.scene().unwrap().clone();
        // What stood in for layers that were dealt anew is let go by settling a picture, of which a sketch knows nothing.
        while session.sketched().unwrap().progress().iter().any(|p| p.held || p.batches < 3) {
            session.step_sketch(&|| true).unwrap();
        }
        let batches = session.sketched().unwrap().batches();
        let sketch = bits(&session.sketched().unwrap().mean());
        let mut alone = Session::open(scene.clone(), SMALL, &sketchy(), Some(1)).unwrap();
        alone.settle(batches).unwrap();
        assert!(sketch == bits(&alone.frame().unwrap().mean()), "round {round}: another sketch");
        session.settle(3).unwrap();
        let mut fresh = open(scene);
        fresh.settle(3).unwrap();
        let shown = |session: &mut Session| bits(&session.frame().unwrap().shown());
        if session.frame().unwrap().batches() == 3 {
            assert!(shown(&mut session) == shown(&mut fresh), "round {round}: another picture");
        }
    }
    session.sketch(None).unwrap();
    assert!(session.sketched().is_none());
    assert!(!session.step_sketch(&|| true).unwrap());
}

/// Each pixel of a section shows what its ray meets first behind the plane, and as bright as it is seen from elsewhere.
#[test]
fn a_section_shows_what_is_behind_it() {
    let scene = stage();
    let target = Vec3::ONE;
    let eye = Vec3::new(1.0, 1.0, 30.0);
    let camera = Camera { name: String::new(), eye, target, up: Vec3::Y, fov_y: 5.0 };
    let settings = Settings { auxiliary: true, ..own(false) };
    let scene = Scene { view: Some(camera.clone()), ..scene };
    let mut session = Session::open(scene, SIZE, &settings, Some(2)).unwrap();
    let mut differ = 0;
    for near in [0.0, 28.2, 29.0, 29.6] {
        session.cut(near).unwrap();
        // One sample a pixel: the mean of a near and a far one lies between.
        session.settle(1).unwrap();
        let view = View::new(&camera, SIZE[0], SIZE[1]);
        let world = session.world().unwrap();
        let expected: Vec<f32> = (0..SIZE[0] * SIZE[1])
            .map(|k| {
                let mut ray = view.ray((k % SIZE[0]) as f32 + 0.5, (k / SIZE[0]) as f32 + 0.5);
                let skipped = near / ray.direction.dot(Vec3::NEG_Z);
                ray.origin += ray.direction * skipped;
                world.closest(&ray).map_or(0.0, |s| (s.position - eye).length())
            })
            .collect();
        let frame = session.frame().unwrap();
        let seen = frame.auxiliary().unwrap();
        for (depth, expected) in seen.depth.iter().zip(&expected) {
            let depth = depth / seen.samples as f32;
            assert!(depth == 0.0 || depth >= near - 1e-3, "{depth} m lies before {near} m");
            differ += u32::from((depth - expected).abs() > 0.3);
        }
    }
    // Samples lie within pixels, not in their middle: edges differ.
    assert!(differ < 4 * SIZE[0] * SIZE[1] / 4, "{differ} pixels show something else");
    for bad in [-1.0, f32::NAN, f32::INFINITY] {
        assert!(session.cut(bad).is_err());
    }
    session.edit(&Edit::View { camera: Some(camera) }).unwrap();
}

/// Sums of all pixels, channel by channel.
fn sums(plane: &[Rgb]) -> [f64; 3] {
    plane.iter().fold([0.0; 3], |sum, v| std::array::from_fn(|k| sum[k] + f64::from(v.to_array()[k])))
}

/// A sketch of some parts of the stage's light sorted into groups, after some batches.
fn sketched(settings: &Settings, batches: u32, melt: impl Fn(usize) -> Option<Vec<Rgb>>) -> Session {
    let cpu = Cpu::new(Some(2)).unwrap();
    let mut world = World::new(stage());
    world.separate(16).unwrap();
    let melted = melt(world.groups());
    let mut session = Session::begin(cpu, world, SIZE, settings).unwrap();
    session.sketch(Some(Sketch { size: SIZE, settings: settings.clone(), melted })).unwrap();
    (0..batches).for_each(|_| assert!(session.step_sketch(&|| true).unwrap()));
    session
}

/// Light that is summed in one layer is twice as bright in colours twice as bright, to the bit, as it is shown and in each
/// part: no light is left out.
#[test]
fn melted_light_takes_its_colour_everywhere() {
    for part in ["emission", "direct", "vpl", "compensation", "mirror", "caustic", "path"] {
        for filter in [false, true] {
            let settings = Settings { parts: vec![part.into()], filter, ..own(true) };
            let shown = |level: f32| {
                let session = sketched(&settings, 3, |groups| Some(vec![Rgb::grey(level); groups]));
                session.sketched().unwrap().shown()
            };
            let twice: Vec<Rgb> = shown(1.0).iter().map(|v| *v * 2.0).collect();
            assert!(twice.iter().any(|v| v.luminance() > 0.0), "{part}: no light");
            assert!(bits(&shown(2.0)) == bits(&twice), "{part}, filtered: {filter}");
        }
    }
}

/// In the mean the light of one layer, each group in a colour of its own, is the mix of a layer a group.
#[test]
fn melted_light_is_the_mix_of_the_layers() {
    let colors = |groups: usize| -> Vec<Rgb> {
        let mut c = Chance::new(5);
        let color = |k: usize| Rgb::new(c.within(0.0, 4.0), c.within(0.0, 4.0), c.unit()) * (k % 4) as f32;
        (0..groups).map(color).collect()
    };
    for part in ["emission", "direct", "vpl", "compensation", "mirror", "caustic"] {
        let mut moments: [Moments; 3] = Default::default();
        let mut whole = [0.0; 3];
        // Short rays find a light here and there.
        let batches = if part == "compensation" { 32 } else { 4 };
        for seed in 0..24 {
            let settings = Settings { parts: vec![part.into()], seed, ..own(false) };
            let one = sketched(&settings, batches, |groups| Some(colors(groups)));
            let one = sums(&one.sketched().unwrap().mean());
            let layered = sketched(&settings, batches, |_| None);
            let still = layered.sketched().unwrap().still();
            assert!(still.layers() > 4);
            let mixed = sums(&still.mix(&colors(still.layers())));
            for k in 0..3 {
                moments[k].push(one[k] - mixed[k]);
                whole[k] += mixed[k] / 24.0;
            }
        }
        for (own, whole) in moments.iter().zip(whole) {
            let (off, error) = (own.mean() / whole, own.standard_error() / whole);
            say(format_args!("{part}: off by {off:+.4} ± {error:.4}"));
            // What is the same light in both is the same but for rounding.
            let same = own.p_value(0.0) > sidak(0.01, 18) || off.abs() < 1e-5;
            assert!(same && error < 0.06, "{part}: off by {off:+.4} ± {error:.4}");
        }
    }
}
