//! A still shows what its frame showed, in any colours, whatever becomes of the frame.

mod stage;

use lampyris::Rgb;
use lampyris::backend::Settings;
use lampyris::frame::Still;
use lampyris::scene::{Edit, Scene};
use lampyris::session::Session;
use lampyris::world::World;
use stage::support::{FAST, settings};
use stage::{Chance, some_edit, stage};

const SIZE: [u32; 2] = [24, 16];

fn separated(most: usize) -> Scene {
    let mut world = World::new(stage());
    world.separate(most).expect("a scene that was read");
    world.scene().clone()
}

fn plain() -> Settings {
    Settings { photons: 100, ..settings(&["emission", "direct", "vpl"], 16, 1, 1) }
}

fn shown() -> Settings {
    let filter =
        Settings { interleave: [2, 2], picks: Some(4), light_points: Some(8), filter: true, ..plain() };
    Settings {
        parts: FAST.iter().map(|part| (*part).to_owned()).collect(),
        window: 2,
        replicates: 2,
        ..filter
    }
}

fn still(session: &mut Session) -> (Still, Vec<Rgb>) {
    let frame = session.frame().expect("open");
    (frame.still(), frame.shown())
}

fn bits(picture: &[Rgb]) -> Vec<[u32; 3]> {
    picture.iter().map(|v| v.to_array().map(f32::to_bits)).collect()
}

/// With batches given up, layers held, past images in the window: the frame's own colours give its picture, bit for bit, and
/// go on giving it when the frame has become another one.
#[test]
fn a_still_is_the_picture_and_stays_it() {
    let mut c = Chance::new(3);
    let (mut stills, mut held) = (Vec::new(), 0);
    for settings in [plain(), shown()] {
        let mut session = Session::open(separated(5), SIZE, &settings, Some(2)).expect("a view");
        for step in 0..60 {
            let scene = session.scene().expect("open").clone();
            let group = c.below(scene.groups.len()) as u16;
            let edit = match c.below(5) {
                0 | 1 => Edit::Mix { group, color: Rgb::new(c.unit(), c.unit(), c.unit()) },
                2 => {
                    let emitter = c.below(scene.reference.shares.len()) as u32;
                    Edit::Regroup { emitters: vec![emitter], group: group + c.below(2) as u16 }
                }
                _ if step % 3 == 0 => some_edit(&scene, &mut c),
                _ => Edit::Mix { group, color: Rgb::WHITE },
            };
            session.edit(&edit).expect("a sound edit");
            stills.push(still(&mut session));
            session.step().expect("a batch");
            stills.push(still(&mut session));
            held += usize::from(stills[stills.len() - 1].0.progress().iter().any(|p| p.held));
        }
        let (last, _) = &stills[stills.len() - 1];
        let frame = session.frame().expect("open");
        let told = (frame.batches(), frame.relative_error(), frame.progress(), frame.layers());
        assert_eq!(told, (last.batches(), last.relative_error(), last.progress().to_vec(), last.layers()));
        assert_eq!(last.size(), SIZE);
    }
    assert!(held > 5, "{held}");
    std::thread::scope(|scope| {
        for (still, picture) in &stills {
            scope.spawn(|| {
                let own = bits(picture);
                assert!(bits(&still.mix(&[])) == own && bits(&still.mix(&still.colors())) == own);
            });
        }
    });
}

/// In other colours it is what the frame would show in them: to the bit where it does not depend on the mix how much of a
/// layer is shown filtered, that is before two randomisations have a batch, and without a filter.
#[test]
fn a_still_is_mixed_as_the_frame_would_be() {
    let mut c = Chance::new(9);
    for (settings, batches) in [(plain(), 3), (shown(), 1)] {
        let mut session = Session::open(separated(5), SIZE, &settings, Some(2)).expect("a view");
        session.settle(batches).expect("batches");
        // One lamp is on its way into a group of its own.
        session.edit(&Edit::Regroup { emitters: vec![0], group: 5 }).expect("sound");
        let (still, picture) = still(&mut session);
        for _ in 0..5 {
            let colors: Vec<Rgb> =
                (0..still.layers()).map(|_| Rgb::new(c.unit(), 2.0 * c.unit(), 0.0)).collect();
            for (group, color) in (0..).zip(&colors) {
                session.edit(&Edit::Mix { group, color: *color }).expect("sound");
            }
            let mixed = session.frame().expect("open").shown();
            assert!(bits(&still.mix(&colors)) == bits(&mixed) && mixed != picture);
        }
    }
}

/// Layers in white, each in its colour, add up to the mix to within rounding.
#[test]
fn layers_of_a_still_add_up() {
    let mut session = Session::open(separated(5), SIZE, &shown(), Some(2)).expect("a view");
    session.settle(6).expect("batches");
    let (still, _) = still(&mut session);
    let colors: Vec<Rgb> =
        (0..still.layers()).map(|k| Rgb::new(k as f32, 1.0, 1.0 / (1.0 + k as f32))).collect();
    let mut sum = vec![Rgb::BLACK; still.mix(&[]).len()];
    for (number, color) in colors.iter().enumerate() {
        let layer = still.layer(number).expect("a layer");
        sum.iter_mut().zip(layer).for_each(|(sum, v)| *sum += v * *color);
    }
    assert!(still.layer(still.layers()).is_none());
    for (sum, mixed) in sum.iter().zip(still.mix(&colors)) {
        let off = (*sum - mixed).map(f32::abs).max_channel();
        assert!(off <= 4e-6 * mixed.max_channel(), "{sum:?} for {mixed:?}");
    }
}
