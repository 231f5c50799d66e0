//! `lampyris measure`: illuminance at points.

use crate::cli::MeasureArgs;
use crate::failure::{Failure, INTERRUPTED};
use crate::progress::Progress;
use crate::{estimate, say, scene_file};
use glam::Vec3;
use lampyris::backend::Backend;
use lampyris::cpu::Cpu;
use lampyris::eye::{Eye, Meter};
use lampyris::frame::Frame;
use lampyris::{Error, Rgb};
use serde::Serialize;
use std::f32::consts::PI;
use std::fmt::Write;
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

/// What one meter shows.
#[derive(Serialize)]
struct Reading {
    x: f32,
    y: f32,
    z: f32,
    nx: f32,
    ny: f32,
    nz: f32,
    /// Illuminance [lx].
    lux: f32,
    /// Of this, straight from the light sources; null where the parts asked for do not tell.
    direct: Option<f32>,
    /// Of this, by way of surfaces.
    indirect: Option<f32>,
    /// Half the 95 % interval of `lux` [lx].
    error: f32,
}

/// Measures and prints.
pub(crate) fn measure(args: &MeasureArgs) -> Result<ExitCode, Failure> {
    let start = Instant::now();
    let meters = read(&args.points)?;
    let settings = estimate::for_meters(&args.estimate, meters.len())?;
    let loaded = scene_file::load(&args.scene, args.quiet)?;
    let mut backend = Cpu::new(args.estimate.threads.map(|n| n as usize))?;
    backend.begin(loaded.scene, Eye::Meters(meters.clone()), &settings)?;
    let progress = Progress::new(&args.estimate, false, args.quiet);
    let interrupted = estimate::run(&mut backend, &args.estimate, false, start, &progress)?;
    let readings = readings(&meters, backend.frame()?);
    if args.json {
        say::json(&readings)?;
    } else {
        say::result(&table(&readings))?;
    }
    Ok(if interrupted { ExitCode::from(INTERRUPTED) } else { ExitCode::SUCCESS })
}

/// Pixels of a meter's frame hold E/π.
fn readings(meters: &[Meter], frame: &Frame) -> Vec<Reading> {
    let mean = frame.mean();
    let direct = frame.part("direct");
    let path = frame.part_names().any(|n| n == "path");
    let lux = |c: Rgb| c.luminance() * PI;
    let reading = |(k, m): (usize, &Meter)| {
        let total = lux(mean[k]);
        let direct = if path { None } else { Some(direct.as_ref().map_or(0.0, |d| lux(d[k]))) };
        Reading {
            x: m.position.x,
            y: m.position.y,
            z: m.position.z,
            nx: m.normal.x,
            ny: m.normal.y,
            nz: m.normal.z,
            lux: total,
            direct,
            indirect: direct.map(|d| total - d),
            error: frame.standard_error(k) * frame.student_factor() * PI,
        }
    };
    meters.iter().enumerate().map(reading).collect()
}

fn table(readings: &[Reading]) -> String {
    let mut text = String::from("# x y z nx ny nz lux direct indirect error\n");
    let or_dash = |v: Option<f32>| v.map_or("-".to_string(), |v| format!("{v:.2}"));
    for r in readings {
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "{} {} {} {} {} {} {:.2} {} {} {:.2}",
            r.x,
            r.y,
            r.z,
            r.nx,
            r.ny,
            r.nz,
            r.lux,
            or_dash(r.direct),
            or_dash(r.indirect),
            r.error
        );
    }
    text
}

/// The meters of a file.
fn read(path: &Path) -> Result<Vec<Meter>, Error> {
    let text = std::fs::read_to_string(path)
        .map_err(|e| Error::CannotRead { file: path.into(), reason: e.to_string() })?;
    let mut meters = Vec::new();
    for (k, line) in text.lines().enumerate() {
        let line = line.trim();
        if !line.is_empty() && !line.starts_with('#') {
            let bad =
                |reason| Error::BadInput { file: path.into(), place: format!("line {}", k + 1), reason };
            meters.push(meter(line).map_err(bad)?);
        }
    }
    if meters.is_empty() {
        return Err(Error::CannotRead { file: path.into(), reason: "it names no point".into() });
    }
    Ok(meters)
}

fn meter(line: &str) -> Result<Meter, String> {
    let numbers: Vec<f32> = line.split_whitespace().take(6).map_while(|w| w.parse().ok()).collect();
    let &[x, y, z, nx, ny, nz] = numbers.as_slice() else {
        return Err(format!("{} numbers, need x y z nx ny nz", numbers.len()));
    };
    let position = Vec3::new(x, y, z);
    match Vec3::new(nx, ny, nz).try_normalize() {
        Some(normal) if position.is_finite() => Ok(Meter { position, normal }),
        _ => Err("need finite numbers and a normal that is not zero".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn further_columns_are_ignored_and_normals_made_unit() {
        let meter = meter("1 2 3\t0 0 5 420.5 desk").unwrap();
        assert_eq!((meter.position, meter.normal), (Vec3::new(1.0, 2.0, 3.0), Vec3::Z));
    }

    #[test]
    fn broken_lines_say_why() {
        for line in ["1 2 3", "1 2 3 0 0 0", "a b c d e f", "1 2 nan 0 0 1", "1 2 3 0 0 inf"] {
            assert!(meter(line).is_err(), "{line:?}");
        }
    }
}
