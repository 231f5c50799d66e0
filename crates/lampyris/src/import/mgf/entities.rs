//! The entities of MGF that set contexts and fields; those that make surfaces are in `geometry`.
//! Wrong arguments are errors, unknown keywords and `ies` are not: they are told and left out.
//! Values are checked here, so that what the contexts hold is always usable.

use super::args::{exactly, number, numbers};
use super::material::Share;
use super::reader::{Fault, Reader};
use crate::chromaticity::Chromaticity;
use crate::import::BRIGHTEST;
use crate::import::report::quote;
use glam::DVec3;

impl Reader<'_> {
    /// Carries out one line.
    pub(super) fn entity(&mut self, keyword: &str, words: &[&str]) -> Result<(), Fault> {
        match keyword {
            comment if comment.starts_with('#') => {}
            "i" => match words {
                [] => return Err("\"i\" takes a file name, found nothing".to_string().into()),
                [name, transform @ ..] => self.include(name, transform)?,
            },
            "ies" => self.warn("\"ies\" light distributions are not read yet; the luminaire is left out"),
            "xf" if words.is_empty() => self.pop_transform()?,
            "xf" => self.push_transform(words)?,
            "o" if words.is_empty() => self.close_object()?,
            "o" => {
                let [name] = exactly(keyword, words)?;
                self.open_object(name);
            }
            "v" => self.vertices.select(words)?,
            "p" => self.vertices.current_mut().point = DVec3::from_array(numbers(keyword, words)?),
            "n" => self.vertices.current_mut().normal = DVec3::from_array(numbers(keyword, words)?),
            "c" => self.colors.select(words)?,
            "cxy" | "cspec" | "cct" | "cmix" => self.color(keyword, words)?,
            "m" => {
                self.material = None;
                self.surfaces.select(words)?;
            }
            "sides" | "rd" | "td" | "ed" | "rs" | "ts" | "ir" => {
                self.material = None;
                self.field(keyword, words)?;
            }
            "f" | "fh" | "sph" | "cyl" | "cone" | "prism" | "ring" | "torus" => {
                self.geometry(keyword, words)?
            }
            unknown => self.warn(&format!("unknown entity {} is left out", quote(unknown))),
        }
        Ok(())
    }

    fn color(&mut self, keyword: &str, words: &[&str]) -> Result<(), Fault> {
        let color = match keyword {
            "cxy" => {
                let [x, y] = numbers(keyword, words)?;
                if x < 0.0 || y < 0.0 || x + y > 1.0 {
                    return Err(format!("({x}, {y}) is no chromaticity: x, y ≥ 0 and x + y ≤ 1").into());
                }
                Some(Chromaticity { x, y })
            }
            "cct" => {
                let [kelvin] = numbers(keyword, words)?;
                if kelvin <= 0.0 {
                    return Err("a colour temperature is above 0 K".to_string().into());
                }
                Chromaticity::from_temperature(kelvin)
            }
            "cspec" => {
                let values = words.iter().map(|w| number(w)).collect::<Result<Vec<_>, _>>()?;
                let [first, last, values @ ..] = &values[..] else {
                    return Err("\"cspec\" takes two wavelengths and two values or more".to_string().into());
                };
                if values.len() < 2 {
                    return Err("\"cspec\" takes two values or more".to_string().into());
                }
                if first >= last {
                    return Err("\"cspec\" takes the shorter wavelength first".to_string().into());
                }
                Chromaticity::from_spectrum(*first, *last, values)
            }
            _ => {
                if words.len() < 4 || words.len() % 2 == 1 {
                    return Err("\"cmix\" takes two pairs or more of a weight and a colour"
                        .to_string()
                        .into());
                }
                let mut parts = Vec::with_capacity(words.len() / 2);
                for pair in words.chunks_exact(2) {
                    parts.push((number(pair[0])?, *self.colors.get(pair[1])?));
                }
                if parts.iter().map(|p| p.0).sum::<f64>() <= 0.0 {
                    return Err("the weights of \"cmix\" sum to nothing".to_string().into());
                }
                Chromaticity::mix(&parts)
            }
        };
        if color.is_none() {
            self.warn("a colour without any light; neutral grey takes its place");
        }
        *self.colors.current_mut() = color.unwrap_or_default();
        Ok(())
    }

    fn field(&mut self, keyword: &str, words: &[&str]) -> Result<(), Fault> {
        let color = *self.colors.current();
        let share = |amount: f64, most: f64| {
            let share = Share { amount, color };
            (0.0..=most).contains(&amount).then_some(share).ok_or_else(|| match most {
                1.0 => format!("{} is a share of light: from 0 to 1", quote(keyword)),
                _ => format!("{} lies from 0 to {most:e}", quote(keyword)),
            })
        };
        let slope = |alpha: f64| {
            let good = (0.0..=1e6).contains(&alpha);
            good.then_some(alpha).ok_or_else(|| "the roughness of a surface is not negative".to_string())
        };
        let surface = self.surfaces.current_mut();
        match keyword {
            "sides" => {
                let [sides] = exactly(keyword, words)?;
                surface.two_sided = match *sides {
                    "1" => false,
                    "2" => true,
                    other => return Err(format!("\"sides\" takes 1 or 2, found {}", quote(other)).into()),
                };
            }
            "rd" => surface.rd = share(numbers::<1>(keyword, words)?[0], 1.0)?,
            "td" => surface.td = share(numbers::<1>(keyword, words)?[0], 1.0)?,
            "ed" => surface.ed = share(numbers::<1>(keyword, words)?[0], f64::from(BRIGHTEST))?,
            "rs" => {
                let [amount, alpha] = numbers(keyword, words)?;
                (surface.rs, surface.alpha[0]) = (share(amount, 1.0)?, slope(alpha)?);
            }
            "ts" => {
                let [amount, alpha] = numbers(keyword, words)?;
                (surface.ts, surface.alpha[1]) = (share(amount, 1.0)?, slope(alpha)?);
            }
            _ => {
                let ir: [f64; 2] = numbers(keyword, words)?;
                if !(0.0..=1e6).contains(&ir[0]) || ir[0] == 0.0 {
                    return Err("an index of refraction is above 0".to_string().into());
                }
                surface.ir = ir;
            }
        }
        Ok(())
    }
}
