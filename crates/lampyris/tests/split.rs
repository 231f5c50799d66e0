//! Eye paths split at the first surface: what is certain there has no variance, and no pixel of a polished floor lacks its
//! dull light. (That the mean stays is the business of tests/partition.rs, which holds polish, mirrors and glass against
//! the path tracer.)

mod support;

use glam::Vec3;
use lampyris::Rgb;
use lampyris::backend::{Backend, Batch, Settings};
use lampyris::cpu::Cpu;
use lampyris::eye::Eye;
use lampyris::frame::Frame;
use lampyris::material::{Bsdf, Class, Dielectric, Pbr, Sides, Transport, Ward, fresnel};
use lampyris::testing::{Moments, sidak};
use support::{Build, diffuse, gloss, say, spread, view};

/// What a frame of some batches tells, rendered on so many threads.
fn frame<T>(
    scene: &Build,
    eye: &Eye,
    settings: &Settings,
    batches: u32,
    threads: Option<usize>,
    tell: impl Fn(&Frame) -> T,
) -> T {
    let mut cpu = Cpu::new(threads).expect("threads");
    cpu.begin(scene.0.clone(), eye.clone(), settings).expect("sound settings");
    (0..batches).for_each(|index| cpu.add(Batch { index }).expect("a batch"));
    tell(cpu.frame().expect("begun"))
}

fn first_frame(parts: &[&str], seed: u32) -> Settings {
    Settings { parts: parts.iter().map(|p| (*p).to_owned()).collect(), seed, ..Settings::interactive() }
}

/// A floor that fills the picture. Behind the eye a lamp shines on it, and in its polish a black wall is seen that glows
/// with 1 cd/m².
fn polished_floor(dull: f32, sharp: f32) -> (Build, Eye) {
    let mut b = Build::default();
    let floor = b.material(gloss(dull, sharp, 0.0), 0.0, Sides::Both);
    let (panel, wall) = (b.glow(10.0), b.glow(1.0));
    b.quad(Vec3::new(-20.0, 0.0, -20.0), Vec3::Z * 40.0, Vec3::X * 40.0, floor);
    b.quad(Vec3::new(-1.0, 3.0, 2.0), Vec3::X * 2.0, Vec3::Z * 2.0, panel);
    b.quad(Vec3::new(-20.0, 0.0, -3.0), Vec3::X * 40.0, Vec3::Y * 40.0, wall);
    (b, view(Vec3::new(0.0, 1.5, 1.0), Vec3::new(0.0, 0.0, -0.5), 40.0, 24, 20))
}

/// Where dull and sharp lobes share a surface, ρ_d and ρ_s, the light in the polish is ρ_s of what is mirrored: in each
/// sample of each pixel where that is at least a tenth of what the surface reflects. A fainter one is followed with
/// probability p = 10 ρ_s/(ρ_s + ρ_d), variance ρ_s² (1/p − 1). (To choose between floor and reflection costs ρ_s ρ_d:
/// 0.08 where ρ_d = 0.4 and ρ_s = 0.2 instead of nothing, and twelve times as much where ρ_s is 2 % of all.)
#[test]
fn reflections_in_polish_are_certain() {
    for (dull, sharp) in [(0.4, 0.2), (0.1, 0.7), (0.5, 0.08), (0.49, 0.01), (0.19, 0.01)] {
        let (scene, eye) = polished_floor(dull, sharp);
        let mut all = Moments::default();
        let mut farthest = 0.0f64;
        for seed in 0..16 {
            let settings = Settings { filter: false, ..first_frame(&["emission"], seed) };
            for v in frame(&scene, &eye, &settings, 1, None, Frame::mean) {
                all.push(f64::from(v.luminance()));
                farthest = farthest.max((f64::from(v.luminance() / sharp) - 1.0).abs());
            }
        }
        let (d, s) = (f64::from(dull), f64::from(sharp));
        let p = (10.0 * s / (s + d)).min(1.0);
        // The square of the standard error is the variance over 16 pictures of 480 pixels.
        let (variance, n) = (all.standard_error().powi(2) * 7680.0, 7680.0);
        let expected = s * s * (1.0 / p - 1.0);
        say(format_args!("{dull} dull, {sharp} sharp: variance {variance:.2e}, of a choice {:.2e}", s * d));
        if p == 1.0 {
            assert!(farthest < 1e-5, "{dull} dull, {sharp} sharp: a sample is off by {farthest}");
        } else {
            let error = (expected / n).sqrt();
            assert!((all.mean() - s).abs() < 4.0 * error, "mean {} for {s} ± {error}", all.mean());
            // Of a value that is taken with probability p, the variance of the variance has a closed form.
            let spread = expected * ((1.0 - 4.0 * p * (1.0 - p)) / (p * (1.0 - p)) / n).sqrt();
            assert!(
                (variance - expected).abs() < 4.0 * spread + 1e-3 * expected,
                "variance {variance} for {expected} ± {spread}"
            );
        }
    }
}

/// A first frame of a polished floor shows in every pixel the light that it reflects dully; by chance a third would be
/// black where ρ_d = 0.4 and ρ_s = 0.2.
#[test]
fn no_pixel_of_a_polished_floor_is_black() {
    for (dull, sharp) in [(0.4, 0.2), (0.05, 0.6)] {
        let (scene, eye) = polished_floor(dull, sharp);
        for seed in 0..4 {
            let [exact, shown] = frame(&scene, &eye, &first_frame(&["direct"], seed), 1, None, |frame| {
                [frame.mean(), frame.shown()]
            });
            let black = |picture: &[Rgb]| picture.iter().filter(|v| v.luminance() <= 0.0).count();
            assert_eq!([black(&exact), black(&shown)], [0, 0], "{dull} dull, {sharp} sharp, seed {seed}");
        }
    }
}

/// Where a surface is sharp alone, what it reflects and what it lets pass are seen together: through a pane, and an interface
/// of glass, from 70° off its normal, with a wall of 1 cd/m² in reflection and one of ¼ behind.
#[test]
fn glass_shows_what_is_before_and_behind_it() {
    let cos = libm::cosf(70f32.to_radians());
    let pane =
        Pbr { transmission: 1.0, metallic: 0.0, roughness: 0.0, base_color: Rgb::WHITE, ..Pbr::default() };
    let of_pane = Bsdf::Pbr(pane).mirror_reflectance(cos).luminance();
    let (of_glass, _) = fresnel(cos, 1.0 / 1.5);
    // Radiance that leaves glass is spread over n² times the solid angle.
    let cases = [
        (Bsdf::Pbr(pane), of_pane + 0.25 * (1.0 - of_pane)),
        (support::glass(), of_glass + 0.25 * (1.0 - of_glass) / (1.5 * 1.5)),
    ];
    for (number, (bsdf, expected)) in cases.into_iter().enumerate() {
        let mut b = Build::default();
        let sheet = b.material(bsdf, 0.0, Sides::Both);
        let (before, behind) = (b.glow(1.0), b.glow(0.25));
        let wide = |x: f32| Vec3::new(x, -100.0, -100.0);
        b.quad(wide(0.0), Vec3::Y * 200.0, Vec3::Z * 200.0, sheet);
        b.quad(wide(5.0), Vec3::Z * 200.0, Vec3::Y * 200.0, before);
        b.quad(wide(-5.0), Vec3::Y * 200.0, Vec3::Z * 200.0, behind);
        let target = Vec3::new(1.0 - cos, 0.0, -(1.0 - cos * cos).sqrt());
        let eye = view(Vec3::new(1.0, 0.0, 0.0), target, 0.05, 16, 12);
        for seed in 0..4 {
            let settings = Settings { filter: false, ..first_frame(&["emission"], seed) };
            for v in frame(&b, &eye, &settings, 1, None, Frame::mean) {
                let off = v.luminance() / expected - 1.0;
                assert!(off.abs() < 2e-3, "case {number}: a sample of {} for {expected}", v.luminance());
            }
        }
    }
}

/// Sheets of narrow lobes between two glowing walls, against the path tracer: both paths find the walls by their lobes and by
/// points on them, and neither finds any light twice. Welch's t-test over seeds at a common level of 1 %.
#[test]
fn narrow_lobes_keep_their_mean() {
    const SEEDS: u32 = 24;
    let rough = Dielectric { alpha: 0.1, ..Dielectric::new(1.5, Rgb::grey(0.9)) };
    let pane = Pbr { transmission: 0.9, metallic: 0.1, roughness: 0.35, ..Pbr::default() };
    let Bsdf::Ward(polish) = gloss(0.0, 0.3, 0.1) else { unreachable!("gloss is Ward's") };
    let both = Ward { transmission: Rgb::grey(0.5), transmission_alpha: 0.05, ..polish };
    let sheets = [
        Bsdf::Dielectric(rough),
        Bsdf::Pbr(pane),
        Bsdf::Ward(both),
        gloss(0.3, 0.2, 0.1),
        gloss(0.6, 0.02, 0.1),
    ];
    let least = sheets.map(|bsdf| {
        let mut b = Build::default();
        let sheet = b.material(bsdf, 0.0, Sides::Both);
        let (before, behind) = (b.glow(1.0), b.glow(4.0));
        b.quad(Vec3::new(0.0, -2.0, -2.0), Vec3::Y * 4.0, Vec3::Z * 4.0, sheet);
        b.quad(Vec3::new(2.0, -1.0, -3.0), Vec3::Z * 3.0, Vec3::Y * 2.0, before);
        b.quad(Vec3::new(-2.0, -1.0, -3.0), Vec3::Y * 2.0, Vec3::Z * 3.0, behind);
        let eye = view(Vec3::new(1.0, 0.1, 0.8), Vec3::new(0.0, 0.0, -0.3), 50.0, 16, 12);
        let mut sides = [Moments::default(); 2];
        for seed in 0..SEEDS {
            let fast = Settings { filter: false, ..first_frame(support::UNBIASED, 2 * seed) };
            let oracle = support::settings(support::ORACLE, 1, 8, 2 * seed + 1);
            for (side, settings) in sides.iter_mut().zip([fast, oracle]) {
                let mean = frame(&b, &eye, &settings, 4, None, Frame::mean);
                side.push(mean.iter().map(|v| f64::from(v.luminance())).sum());
            }
        }
        let [fast, path] = sides;
        let noise = fast.standard_error().max(path.standard_error()) / path.mean();
        say(format_args!("{:+.4} of path, noise {noise:.4}", fast.mean() / path.mean() - 1.0));
        assert!(noise < 0.02, "too noisy to tell anything: {noise}");
        fast.p_value_against(&path)
    });
    assert!(least.iter().all(|p| *p > sidak(0.01, least.len())), "{least:?}");
}

/// The numbers that choose a sharp lobe lead to reflection below the share that a surface states, and nowhere above it.
#[test]
fn the_share_of_reflection_divides_the_choice() {
    let pbr = |transmission: f32, roughness: f32| {
        let base_color = Rgb::new(0.9, 0.7, 0.4);
        Bsdf::Pbr(Pbr { transmission, roughness, metallic: 0.2, base_color, ..Pbr::default() })
    };
    let rough = |alpha: f32| Bsdf::Dielectric(Dielectric { alpha, ..Dielectric::new(1.5, Rgb::grey(0.9)) });
    let two = |alpha: f32, transmission_alpha: f32| {
        let Bsdf::Ward(base) = gloss(0.1, 0.2, alpha) else { unreachable!("gloss is Ward's") };
        Bsdf::Ward(Ward { transmission: Rgb::grey(0.5), transmission_alpha, ..base })
    };
    let materials = [
        pbr(0.0, 0.2),
        pbr(0.6, 0.3),
        pbr(1.0, 0.0),
        rough(0.0),
        rough(0.1),
        two(0.0, 0.0),
        two(0.1, 0.05),
        two(0.3, 0.1),
        gloss(0.2, 0.3, 0.1),
    ];
    let (mut reflected, mut passed) = (0, 0);
    for (number, bsdf) in materials.iter().enumerate() {
        for i in 0..256 {
            let [u, v] = spread(i, 1);
            let z = 2.0 * u - 1.0;
            let r = (1.0 - z * z).sqrt();
            let wo = Vec3::new(r * libm::cosf(6.0 * v), r * libm::sinf(6.0 * v), z);
            let at = spread(i, 2);
            let share = bsdf.reflected_sharply(wo, at);
            assert!((0.0..=1.0).contains(&share), "{number}: a share of {share}");
            for choice in (0..64).map(|k| (k as f32 + 0.5) / 64.0).filter(|c| (c - share).abs() > 1e-4) {
                if let Some(s) = bsdf.sample(Class::Sharp, wo, at, choice, Transport::Radiance) {
                    let same = (s.wi.z > 0.0) == (wo.z > 0.0);
                    assert_eq!(same, choice < share, "{number}: {wo} by {choice}, share {share}");
                    reflected += u32::from(same);
                    passed += u32::from(!same);
                }
            }
        }
    }
    assert!(reflected > 10_000 && passed > 10_000, "{reflected} and {passed} samples prove little");
}

/// A room of polish and glass has the same bits on any number of threads, exact and shown.
#[test]
fn threads_do_not_matter() {
    let mut b = Build::default();
    let wall = b.grey(0.5);
    let floor = b.material(gloss(0.3, 0.2, 0.05), 0.0, Sides::Both);
    let faint = b.material(gloss(0.6, 0.02, 0.0), 0.0, Sides::Both);
    let clear = b.material(support::glass(), 0.0, Sides::Both);
    let panel = b.material(diffuse(0.0), 10.0, Sides::EmitFront);
    b.room(Vec3::ZERO, Vec3::splat(2.0), [faint, wall, floor, wall, wall, wall]);
    b.sphere(Vec3::new(1.2, 0.5, 0.8), 0.4, 2, false, |_| clear);
    b.quad(Vec3::new(0.5, 1.99, 0.5), Vec3::X, Vec3::Z, panel);
    let eye = view(Vec3::new(1.0, 1.2, 1.9), Vec3::new(0.9, 0.4, 0.6), 60.0, 48, 40);
    let settings = first_frame(support::FAST, 3);
    let bits = |threads| {
        frame(&b, &eye, &settings, 2, Some(threads), |frame| {
            let all = frame.mean().into_iter().chain(frame.shown());
            all.flat_map(|v| [v.r.to_bits(), v.g.to_bits(), v.b.to_bits()]).collect::<Vec<_>>()
        })
    };
    let one = bits(1);
    assert!(one == bits(2) && one == bits(3), "the bits differ");
}
