//! What an experiment yields: comparisons with the paper, and things to look at. Plain data, without a word of HTML.

use crate::plot::Plot;
use lampyris::Rgb;
use lampyris::output::{Display, Exposure, Picture, ToneCurve};
use serde::{Deserialize, Serialize};

/// All that an experiment found.
#[derive(Default)]
pub struct Findings {
    /// The paper's figures beside ours.
    pub comparisons: Vec<Comparison>,
    /// What else there is to see, in this order.
    pub exhibits: Vec<Exhibit>,
    /// Where the paper leaves something open, errs, or cannot be repeated.
    pub gaps: Vec<String>,
}

impl Findings {
    /// One more comparison.
    pub fn compare(&mut self, comparison: Comparison) {
        self.comparisons.push(comparison);
    }

    /// One more thing to look at.
    pub fn show(&mut self, exhibit: impl Into<Exhibit>) {
        self.exhibits.push(exhibit.into());
    }

    /// One more gap of the paper.
    pub fn gap(&mut self, text: impl Into<String>) {
        self.gaps.push(text.into());
    }
}

/// A figure of the paper, ours, and what we ask of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Comparison {
    /// What was measured.
    pub what: String,
    /// In what; empty for a pure number.
    pub unit: String,
    /// What the paper has.
    pub paper: Option<f64>,
    /// What it has instead of a number, or says of it.
    pub says: String,
    /// What we measured; no number where nothing came of it.
    #[serde(with = "number")]
    pub ours: f64,
    /// What ours should be.
    pub demand: Option<Demand>,
}

/// What is no number is null in JSON.
mod number {
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    pub(super) fn serialize<S: Serializer>(value: &f64, to: S) -> Result<S::Ok, S::Error> {
        value.is_finite().then_some(*value).serialize(to)
    }

    pub(super) fn deserialize<'a, D: Deserializer<'a>>(from: D) -> Result<f64, D::Error> {
        Option::deserialize(from).map(|value| value.unwrap_or(f64::NAN))
    }
}

/// What a figure should be.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Demand {
    /// This or more.
    AtLeast(f64),
    /// This or less.
    AtMost(f64),
    /// From the one to the other.
    Within(f64, f64),
}

impl Comparison {
    /// Of ours alone.
    pub fn new(what: impl Into<String>, unit: &str, ours: f64) -> Comparison {
        Comparison {
            what: what.into(),
            unit: unit.into(),
            paper: None,
            says: String::new(),
            ours,
            demand: None,
        }
    }

    /// With the paper's figure.
    pub fn paper(self, paper: f64) -> Comparison {
        Comparison { paper: Some(paper), ..self }
    }

    /// With the paper's words.
    pub fn says(self, says: impl Into<String>) -> Comparison {
        Comparison { says: says.into(), ..self }
    }

    /// With what ours should be.
    pub fn demand(self, demand: Demand) -> Comparison {
        Comparison { demand: Some(demand), ..self }
    }

    /// Ours over the paper's.
    pub fn ratio(&self) -> Option<f64> {
        self.paper.filter(|paper| *paper != 0.0).map(|paper| self.ours / paper)
    }

    /// Whether it is what it should be, where there is something it should be. What is no number is not.
    pub fn held(&self) -> Option<bool> {
        self.demand.map(|demand| match demand {
            Demand::AtLeast(least) => self.ours >= least,
            Demand::AtMost(most) => self.ours <= most,
            Demand::Within(least, most) => (least..=most).contains(&self.ours),
        })
    }
}

/// Something to look at.
pub enum Exhibit {
    /// Rows and columns.
    Table(Table),
    /// Curves or points.
    Plot(Plot),
    /// Pictures side by side.
    Images(Vec<Image>),
    /// Words.
    Note(String),
}

impl From<Table> for Exhibit {
    fn from(table: Table) -> Exhibit {
        Exhibit::Table(table)
    }
}

impl From<Plot> for Exhibit {
    fn from(plot: Plot) -> Exhibit {
        Exhibit::Plot(plot)
    }
}

impl From<Vec<Image>> for Exhibit {
    fn from(images: Vec<Image>) -> Exhibit {
        Exhibit::Images(images)
    }
}

impl From<String> for Exhibit {
    fn from(text: String) -> Exhibit {
        Exhibit::Note(text)
    }
}

impl From<&str> for Exhibit {
    fn from(text: &str) -> Exhibit {
        Exhibit::Note(text.into())
    }
}

/// Rows and columns.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Table {
    /// What it shows.
    pub title: String,
    /// Head of each column, with its unit.
    pub columns: Vec<String>,
    /// Cells, row by row.
    pub rows: Vec<Vec<String>>,
}

impl Table {
    /// Without rows as yet.
    pub fn new<const N: usize>(title: impl Into<String>, columns: [&str; N]) -> Table {
        Table { title: title.into(), columns: columns.map(String::from).into(), rows: Vec::new() }
    }

    /// One more row.
    pub fn row<const N: usize>(&mut self, cells: [String; N]) {
        debug_assert_eq!(N, self.columns.len(), "{}", self.title);
        self.rows.push(cells.into());
    }
}

/// A picture as a display shows it.
pub struct Image {
    /// What it shows.
    pub caption: String,
    /// Its light.
    pub picture: Picture,
    /// How that is displayed.
    pub display: Display,
    /// How many pixels of the page each of its pixels is wide.
    pub zoom: u32,
}

impl Image {
    /// Of light [cd/m²], by an exposure that is the same for all that shall be compared.
    pub fn of_light(caption: impl Into<String>, picture: Picture, exposure: Exposure) -> Image {
        let display = Display { exposure, tone: Some(ToneCurve::Filmic), despeckle: false };
        Image { caption: caption.into(), picture, display, zoom: 1 }
    }

    /// Of numbers, 0 black and 1 white, `width` in a row.
    pub fn of_numbers(caption: impl Into<String>, width: u32, numbers: &[f64]) -> Image {
        // At 0 EV 100 cd/m² are white.
        let radiance: Vec<Rgb> = numbers.iter().map(|v| Rgb::grey(100.0 * *v as f32)).collect();
        let picture = Picture::new(width, numbers.len() as u32 / width.max(1), radiance);
        let display =
            Display { exposure: Exposure::Ev(0.0), tone: Some(ToneCurve::Linear), despeckle: false };
        Image { caption: caption.into(), picture, display, zoom: 1 }
    }

    /// Half as wide and as high, each pixel the mean of four.
    pub fn halved(self) -> Image {
        let (width, height) = (self.picture.width / 2, self.picture.height / 2);
        let at = |x: u32, y: u32| self.picture.radiance[(y * self.picture.width + x) as usize];
        let four = |k: u32| {
            let (x, y) = (2 * (k % width), 2 * (k / width));
            (at(x, y) + at(x + 1, y) + at(x, y + 1) + at(x + 1, y + 1)) * 0.25
        };
        let radiance = (0..width * height).map(four).collect();
        Image { picture: Picture::new(width, height, radiance), ..self }
    }

    /// Larger on the page.
    pub fn zoomed(self, zoom: u32) -> Image {
        Image { zoom, ..self }
    }
}

/// A number for people, to three digits.
pub(crate) fn digits(value: f64) -> String {
    let size = value.abs();
    let text = match size {
        _ if !size.is_finite() => "–".into(),
        _ if size == 0.0 => "0".into(),
        _ if !(1e-4..1e6).contains(&size) => {
            let text = format!("{size:.2e}");
            let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
            format!("{digits} · 10{}", raised(exponent))
        }
        // As many places as leave three digits once it is rounded.
        _ => {
            let leading = libm::log10(size * 1.0005).floor();
            format!("{size:.*}", (2.0 - leading).max(0.0) as usize)
        }
    };
    if value < 0.0 { format!("−{text}") } else { text }
}

/// A number with its sign, to hundredths.
pub(crate) fn signed(value: f64) -> String {
    format!("{value:+.2}").replace('-', "−")
}

/// A whole number as an exponent is written.
fn raised(number: &str) -> String {
    let raise = |c: char| match c.to_digit(10) {
        Some(digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(digit as usize).unwrap_or(c),
        None => '⁻',
    };
    number.chars().map(raise).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_told_in_three_digits() {
        let told = [0.0, 1.0, -12.34, 123.4, 0.0456, 1.5e-5, 12_345_678.0, f64::NAN].map(digits);
        assert_eq!(told, ["0", "1.00", "−12.3", "123", "0.0456", "1.50 · 10⁻⁵", "1.23 · 10⁷", "–"]);
        let told = [0.99999, 9.999, 0.1, 99.96, 4321.0, 0.001, 0.000_999_9, 0.000_25].map(digits);
        assert_eq!(told, ["1.00", "10.0", "0.100", "100", "4321", "0.00100", "0.00100", "0.000250"]);
        assert_eq!([-0.5, 0.0, 2.345].map(signed), ["−0.50", "+0.00", "+2.35"]);
    }

    #[test]
    fn what_is_no_number_holds_nothing_and_survives_a_file() {
        let figure = Comparison::new("N", "", f64::NAN).paper(2.0).demand(Demand::AtLeast(0.0));
        assert_eq!(figure.held(), Some(false));
        let back: Comparison = serde_json::from_str(&serde_json::to_string(&figure).unwrap()).unwrap();
        assert!(back.ours.is_nan() && back.paper == Some(2.0));
        let held = Comparison::new("N", "", 1.0).paper(2.0).demand(Demand::Within(1.0, 2.0));
        assert_eq!((held.held(), held.ratio()), (Some(true), Some(0.5)));
    }
}
