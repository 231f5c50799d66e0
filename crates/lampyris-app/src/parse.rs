//! Values of arguments: small texts to numbers that make sense.

use glam::Vec3;
use lampyris::output::{Exposure, ToneCurve};
use std::time::Duration;

/// Pixels a picture may have: its sums take some hundred bytes each.
pub(crate) const PIXELS: u64 = 1 << 26;

/// `x,y,z`, finite.
pub(crate) fn vector(text: &str) -> Result<Vec3, String> {
    let numbers: Result<Vec<f32>, String> = text.split(',').map(number).collect();
    match numbers?.as_slice() {
        &[x, y, z] => Ok(Vec3::new(x, y, z)),
        other => Err(format!("{} numbers, need x,y,z", other.len())),
    }
}

/// `WxH` pixels.
pub(crate) fn size(text: &str) -> Result<(u32, u32), String> {
    let parts = text.split_once(['x', 'X']).and_then(|(w, h)| Some((w.parse().ok()?, h.parse().ok()?)));
    match parts {
        Some((w, h)) if w > 0 && h > 0 && u64::from(w) * u64::from(h) <= PIXELS => Ok((w, h)),
        Some(_) => Err(format!("need at least 1x1 and at most {PIXELS} pixels")),
        None => Err("need WxH, for example 640x480".into()),
    }
}

/// A vertical field of view [degrees].
pub(crate) fn fov(text: &str) -> Result<f32, String> {
    let fov = number(text)?;
    if fov > 0.0 && fov < 179.0 { Ok(fov) } else { Err("need more than 0 and less than 179 degrees".into()) }
}

/// A number above 0.
pub(crate) fn positive(text: &str) -> Result<f32, String> {
    let number = number(text)?;
    if number > 0.0 { Ok(number) } else { Err("need more than 0".into()) }
}

/// A number of seconds.
pub(crate) fn seconds(text: &str) -> Result<Duration, String> {
    let seconds = number(text)?;
    if seconds > 0.0 && seconds < 1e9 {
        Ok(Duration::from_secs_f32(seconds))
    } else {
        Err("need more than 0".into())
    }
}

/// `auto` or an exposure value.
pub(crate) fn exposure(text: &str) -> Result<Exposure, String> {
    if text == "auto" {
        return Ok(Exposure::Auto);
    }
    let ev = number(text).map_err(|e| format!("{e}, need a number or auto"))?;
    if ev.abs() <= 60.0 { Ok(Exposure::Ev(ev)) } else { Err("need a value from -60 to 60".into()) }
}

/// A tone curve's name.
pub(crate) fn tone(text: &str) -> Result<ToneCurve, String> {
    let known = ToneCurve::ALL.map(ToneCurve::name).join(", ");
    ToneCurve::from_name(text).ok_or(format!("known: {known}"))
}

fn number(text: &str) -> Result<f32, String> {
    match text.trim().parse::<f32>() {
        Ok(n) if n.is_finite() => Ok(n),
        _ => Err(format!("\"{text}\" is no finite number")),
    }
}

/// `auto` or `off`.
pub(crate) fn filter(text: &str) -> Result<bool, String> {
    match text {
        "auto" => Ok(true),
        "off" => Ok(false),
        _ => Err("say auto or off".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn good_texts() {
        assert_eq!(vector("1,-2.5, 3e1"), Ok(Vec3::new(1.0, -2.5, 30.0)));
        assert_eq!(size("640x480"), Ok((640, 480)));
        assert_eq!(exposure("auto"), Ok(Exposure::Auto));
        assert_eq!(exposure("-1.5"), Ok(Exposure::Ev(-1.5)));
        assert_eq!(seconds("0.5"), Ok(Duration::from_millis(500)));
    }

    #[test]
    fn bad_texts() {
        for text in ["", "1,2", "1,2,3,4", "1,2,nan", "1,2,inf", "a,b,c"] {
            assert!(vector(text).is_err(), "{text:?}");
        }
        for text in ["", "640", "0x5", "5x0", "-1x5", "65536x65536", "4294967296x1", "1.5x2"] {
            assert!(size(text).is_err(), "{text:?}");
        }
        for text in ["0", "-5", "nan", "1e30", ""] {
            assert!(seconds(text).is_err(), "{text:?}");
        }
        for text in ["0", "-5", "nan", "inf", ""] {
            assert!(positive(text).is_err(), "{text:?}");
        }
        assert!(
            fov("180").is_err()
                && fov("0").is_err()
                && exposure("bright").is_err()
                && exposure("1e9").is_err()
        );
    }
}
