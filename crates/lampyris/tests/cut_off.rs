//! A limit on the length of paths is a bias that is told of: what it takes from `vpl` is the part `cut-off`.

mod stage;

use lampyris::Rgb;
use lampyris::backend::{Backend, Batch, Settings};
use lampyris::cpu::Cpu;
use lampyris::eye::Eye;
use lampyris::scene::View;
use stage::stage;
use stage::support::settings;

fn part(settings: &Settings, name: &str) -> Vec<Rgb> {
    let mut cpu = Cpu::new(Some(2)).expect("threads");
    let scene = stage();
    let view = View::new(scene.view.as_ref().expect("a view"), 12, 8);
    cpu.begin(scene, Eye::Camera(view), settings).expect("sound");
    (0..2).for_each(|index| cpu.add(Batch { index }).expect("a batch"));
    cpu.frame().expect("begun").part(name).expect("rendered")
}

#[test]
fn what_a_limit_takes_is_the_part_cut_off() {
    let whole = part(&settings(&["vpl"], 32, 4, 5), "vpl");
    let total = |plane: &[Rgb]| plane.iter().map(|v| f64::from(v.luminance())).sum::<f64>();
    let most = whole.iter().map(|v| v.max_channel()).fold(0.0, f32::max);
    let mut last = f64::INFINITY;
    for longest in [2, 3, 4, 6] {
        let limited = Settings { longest: Some(longest), ..settings(&["vpl", "cut-off"], 32, 4, 5) };
        let (kept, cut) = (part(&limited, "vpl"), part(&limited, "cut-off"));
        for ((kept, cut), whole) in kept.iter().zip(&cut).zip(&whole) {
            let off = (*kept + *cut - *whole).map(f32::abs).max_channel();
            assert!(off <= 2e-5 * most, "{longest}: {kept:?} + {cut:?}, not {whole:?}");
        }
        // Alone, `vpl` is the same: nothing of what it draws hangs on the other part.
        let alone = Settings { parts: vec!["vpl".into()], ..limited };
        assert!(part(&alone, "vpl") == kept);
        assert!(total(&cut) > 0.0 && total(&cut) < last, "{longest}");
        last = total(&cut);
    }
    assert!(
        total(&part(&settings(&["vpl", "cut-off"], 32, 4, 5), "cut-off")) == 0.0,
        "no limit takes nothing"
    );
}
