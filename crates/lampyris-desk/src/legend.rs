//! False colour: which quantity is shown in which colours, and the legend that says so. The palette is the desk's; pages have
//! none of their own.

use lampyris::Rgb;
use lampyris::measuring::illuminance;
use lampyris::output::false_color::{FalseColor, Painted, Palette, Scale};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

/// What is shown instead of light.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Legend {
    pub(crate) quantity: Quantity,
    pub(crate) colors: FalseColor,
    asked: Asked,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Quantity {
    /// What surfaces receive [lx].
    Illuminance,
    /// What comes to the eye [cd/m²].
    Luminance,
    /// What surfaces receive more than in a look, or less [lx].
    Difference,
    /// The share of what comes to the eye that clamping takes from virtual lights, and short rays pay back [%].
    Clamped,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Asked {
    quantity: Quantity,
    low: f32,
    high: f32,
    scale: AskedScale,
    #[serde(default)]
    palette: String,
    #[serde(default)]
    lines: bool,
    #[serde(default)]
    steps: Option<u8>,
    #[serde(default)]
    target: Option<f32>,
    /// The look that is compared with.
    #[serde(default)]
    against: Option<u32>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
enum AskedScale {
    Log,
    Linear,
}

/// Palettes by name.
const PALETTES: [(&str, Palette); 4] = [
    ("even", Palette::Even),
    ("rainbow", Palette::Rainbow),
    ("grey", Palette::Grey),
    ("diverging", Palette::Diverging),
];

/// Colours of the legend that pages draw, and lines that there are about.
const SHOWN: usize = 33;
const LINES: usize = 8;

impl Legend {
    /// What a page asks for; null for none.
    pub(crate) fn read(value: &Value) -> Result<Option<Legend>, String> {
        if value.is_null() {
            return Ok(None);
        }
        let mut asked = Asked::deserialize(value).map_err(|e| e.to_string())?;
        if (asked.quantity == Quantity::Difference) != asked.against.is_some() {
            return Err("a difference is one to a look, and nothing else is".into());
        }
        let about_zero = asked.scale == AskedScale::Linear && asked.low == -asked.high;
        if asked.against.is_some() && !about_zero {
            return Err("the legend of a difference is linear, and runs from -n to n".into());
        }
        let known = PALETTES.iter().find(|(name, _)| *name == asked.palette).unwrap_or(&PALETTES[0]);
        asked.palette = known.0.into();
        let scale = match asked.scale {
            AskedScale::Log => Scale::Log,
            AskedScale::Linear => Scale::Linear,
        };
        let mut colors = FalseColor {
            low: asked.low,
            high: asked.high,
            scale,
            steps: asked.steps,
            palette: known.1,
            lines: Vec::new(),
        };
        colors.paint(&[asked.low], [1, 1]).map_err(|e| e.to_string())?;
        if asked.lines {
            let target = asked.target;
            let ticks = colors.ticks(LINES).into_iter().map(|tick| tick.value as f32);
            colors.lines = ticks
                .filter(|tick| Some(*tick) != target && (*tick != 0.0 || asked.against.is_none()))
                .map(|tick| (tick, false))
                .collect();
            colors.lines.extend(target.map(|target| (target, true)));
        }
        Ok(Some(Legend { quantity: asked.quantity, colors, asked }))
    }

    /// The look that is compared with.
    pub(crate) fn against(&self) -> Option<u32> {
        self.asked.against
    }

    /// What pages are told.
    pub(crate) fn told(&self) -> Value {
        let color = |k: usize| {
            let [r, g, b] = self.colors.color(k as f32 / (SHOWN - 1) as f32);
            format!("#{r:02x}{g:02x}{b:02x}")
        };
        let mut told = json!(self.asked);
        told["colors"] = (0..SHOWN).map(color).collect();
        told["palettes"] = PALETTES.iter().map(|(name, _)| *name).collect();
        let ticks = self.colors.ticks(LINES);
        told["ticks"] = ticks.iter().map(|tick| json!([tick.value, tick.place])).collect();
        told
    }

    /// A picture in its colours; `None` where it has not what it takes. Where nothing can be said of a pixel it is hatched.
    pub(crate) fn paint(&self, picture: &Picture<'_>) -> Option<Painted> {
        let Picture { radiance, against, albedos, clamped, size } = *picture;
        let lux = |(c, albedo): (&Rgb, &Rgb)| illuminance(*c, *albedo).unwrap_or(f32::NAN);
        let values: Vec<f32> = match self.quantity {
            Quantity::Luminance => radiance.iter().map(|c| c.luminance()).collect(),
            Quantity::Illuminance => radiance.iter().zip(albedos?).map(lux).collect(),
            Quantity::Difference => {
                let pixels = radiance.iter().zip(against?).zip(albedos?);
                pixels.map(|((now, then), albedo)| lux((now, albedo)) - lux((then, albedo))).collect()
            }
            // Black of black is no share of it.
            Quantity::Clamped => {
                let share = |(all, taken): (&Rgb, &Rgb)| 100.0 * taken.luminance() / all.luminance();
                radiance.iter().zip(clamped?).map(share).collect()
            }
        };
        self.colors.paint(&values, size).ok()
    }
}

/// What there is to be told of by a legend, row by row from the top.
#[derive(Clone, Copy, Default)]
pub(crate) struct Picture<'a> {
    /// What comes to the eye [cd/m²].
    pub(crate) radiance: &'a [Rgb],
    /// The same of the picture that it is compared with.
    pub(crate) against: Option<&'a [Rgb]>,
    /// What surfaces reflect, black where that does not tell what they receive.
    pub(crate) albedos: Option<&'a [Rgb]>,
    /// What of `radiance` clamping takes from virtual lights [cd/m²].
    pub(crate) clamped: Option<&'a [Rgb]>,
    /// Width and height [pixels].
    pub(crate) size: [u32; 2],
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn legends_are_told_as_they_were_asked_for() {
        let asked = json!({"quantity": "illuminance", "low": 1.0, "high": 1000.0, "scale": "log", "palette": "even", "lines": true});
        let legend = Legend::read(&asked).unwrap().unwrap();
        let told = legend.told();
        for field in ["quantity", "low", "high", "scale", "palette", "lines"] {
            assert_eq!(told[field], asked[field], "{field}");
        }
        assert_eq!(told["colors"].as_array().unwrap().len(), SHOWN);
        assert_eq!(Legend::read(&told).unwrap().unwrap(), legend);
        assert_eq!(Legend::read(&Value::Null).unwrap(), None);
        for (low, high) in [(0.0, 10.0), (10.0, 1.0), (5.0, 5.0)] {
            let mut bad = asked.clone();
            (bad["low"], bad["high"]) = (low.into(), high.into());
            assert!(Legend::read(&bad).is_err(), "{low} to {high}");
        }
    }

    #[test]
    fn what_receives_nothing_that_can_be_told_is_hatched() {
        let asked = json!({"quantity": "illuminance", "low": 1, "high": 100, "scale": "log"});
        let legend = Legend::read(&asked).unwrap().unwrap();
        let radiance = vec![Rgb::grey(3.0); 256];
        let painted = |albedos: Option<&[Rgb]>| {
            let picture = Picture { radiance: &radiance, albedos, size: [16, 16], ..Picture::default() };
            legend.paint(&picture)
        };
        let matt = painted(Some(&[Rgb::grey(0.5); 256])).unwrap();
        assert!(matt.pixels.iter().all(|p| *p == matt.pixels[0]));
        let none = painted(Some(&[Rgb::BLACK; 256])).unwrap();
        assert!(none.pixels.iter().all(|p| *p != matt.pixels[0]));
        assert!(painted(None).is_none());
    }

    /// Each pixel has the colour of what its surface receives more than in the other picture, whatever it reflects.
    #[test]
    fn differences_have_signs() {
        let asked = json!({"quantity": "difference", "against": 3, "low": -100, "high": 100, "scale": "linear",
                           "palette": "diverging", "lines": true});
        let legend = Legend::read(&asked).unwrap().unwrap();
        assert_eq!((legend.against(), legend.told()["against"].as_u64()), (Some(3), Some(3)));
        assert!(
            legend.colors.lines.iter().all(|(value, _)| *value != 0.0) && !legend.colors.lines.is_empty()
        );
        let count = 201;
        let albedos: Vec<Rgb> = (0..count).map(|k| Rgb::grey(0.1 + 0.004 * k as f32)).collect();
        let lit = |lux: f32, albedo: Rgb| albedo * (lux / std::f32::consts::PI);
        let changes: Vec<f32> = (0..count).map(|k| k as f32 - 100.0).collect();
        let then: Vec<Rgb> = albedos.iter().map(|albedo| lit(150.0, *albedo)).collect();
        let now: Vec<Rgb> = albedos.iter().zip(&changes).map(|(a, change)| lit(150.0 + change, *a)).collect();
        let plain = Legend { colors: FalseColor { lines: Vec::new(), ..legend.colors.clone() }, ..legend };
        let picture =
            Picture { radiance: &now, albedos: Some(&albedos), size: [count, 1], ..Picture::default() };
        let painted = plain.paint(&Picture { against: Some(&then), ..picture }).unwrap();
        for (pixel, change) in painted.pixels.iter().zip(&changes) {
            let wanted = (0.5 + 0.5 * change / 100.0) * 247.0;
            assert!((f32::from(*pixel) - wanted).abs() < 0.51, "{change}: {pixel}");
        }
        assert!(plain.paint(&picture).is_none());
        for (field, value) in [
            ("against", Value::Null),
            ("quantity", "illuminance".into()),
            ("scale", "log".into()),
            ("low", 1.into()),
            ("low", (-50).into()),
        ] {
            let mut bad = asked.clone();
            bad[field] = value;
            assert!(Legend::read(&bad).is_err(), "{field}");
        }
    }

    /// Each pixel has the colour of the share that was taken, and where nothing comes from nobody can tell.
    #[test]
    fn what_was_clamped_is_a_share() {
        let asked =
            json!({"quantity": "clamped", "low": 0, "high": 50, "scale": "linear", "palette": "grey"});
        let legend = Legend::read(&asked).unwrap().unwrap();
        let radiance: Vec<Rgb> = (1..=51).map(|k| Rgb::grey(k as f32)).collect();
        let clamped: Vec<Rgb> = radiance.iter().enumerate().map(|(k, c)| *c * (0.01 * k as f32)).collect();
        let picture = Picture { radiance: &radiance, size: [51, 1], ..Picture::default() };
        let painted = legend.paint(&Picture { clamped: Some(&clamped), ..picture }).unwrap();
        for (k, pixel) in painted.pixels.iter().enumerate() {
            assert!((f32::from(*pixel) - 247.0 * k as f32 / 50.0).abs() < 0.51, "{k} %: {pixel}");
        }
        assert!(legend.paint(&picture).is_none());
        let black = [Rgb::BLACK; 51];
        let dark = legend.paint(&Picture { radiance: &black, clamped: Some(&black), ..picture }).unwrap();
        assert!(dark.pixels.iter().all(|pixel| *pixel >= 248));
    }
}
