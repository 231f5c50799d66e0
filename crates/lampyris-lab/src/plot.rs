//! Curves and points as SVG.
//!
//! Series differ by colour and by mark; the colours are those of Okabe and Ito, which people with any of the usual colour
//! deficiencies tell apart. The ground is white also where the page is dark: a plot is a sheet of paper.

use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, ValueFormatter};
use plotters::prelude::*;
use serde::{Deserialize, Serialize};
use std::error::Error;

/// A diagram.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Plot {
    /// What it shows.
    pub title: String,
    /// Rightwards.
    pub x: Axis,
    /// Upwards.
    pub y: Axis,
    /// What is drawn, in this order.
    pub series: Vec<Series>,
    /// As wide as high: points of the unit square.
    pub square: bool,
}

/// An axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Axis {
    /// What is measured, and in what unit.
    pub label: String,
    /// Logarithmic.
    pub log: bool,
    /// From where to where; else by what is drawn.
    pub range: Option<[f64; 2]>,
    /// Of whole numbers: no mark lies between them.
    #[serde(default)]
    pub whole: bool,
}

impl Axis {
    /// In equal steps.
    pub fn linear(label: impl Into<String>) -> Axis {
        Axis { label: label.into(), log: false, range: None, whole: false }
    }

    /// In equal factors; what is not positive is not drawn.
    pub fn log(label: impl Into<String>) -> Axis {
        Axis { label: label.into(), log: true, range: None, whole: false }
    }

    /// From where to where.
    pub fn from_to(self, low: f64, high: f64) -> Axis {
        Axis { range: Some([low, high]), ..self }
    }

    /// Of whole numbers.
    pub fn of_whole(self) -> Axis {
        Axis { whole: true, ..self }
    }
}

/// A set of points.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Series {
    /// Its name in the legend; where empty none, and it looks like the named one before it.
    pub name: String,
    /// x and y.
    pub points: Vec<[f64; 2]>,
    /// How it is drawn.
    pub mark: Mark,
}

/// How points are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Mark {
    /// Joined, with a mark at each.
    Line,
    /// Joined, without marks: a function.
    Curve,
    /// Joined by dashes, without marks: theory, or what the paper says.
    Dashes,
    /// Marks alone.
    Dots,
}

impl Series {
    /// What is no number is no point.
    pub fn of(name: impl Into<String>, points: Vec<[f64; 2]>, mark: Mark) -> Series {
        let points = points.into_iter().filter(|p| p.iter().all(|v| v.is_finite())).collect();
        Series { name: name.into(), points, mark }
    }

    /// A measured curve.
    pub fn line(name: impl Into<String>, points: Vec<[f64; 2]>) -> Series {
        Series::of(name, points, Mark::Line)
    }

    /// A curve by theory.
    pub fn dashes(name: impl Into<String>, points: Vec<[f64; 2]>) -> Series {
        Series::of(name, points, Mark::Dashes)
    }

    /// Points.
    pub fn dots(name: impl Into<String>, points: Vec<[f64; 2]>) -> Series {
        Series::of(name, points, Mark::Dots)
    }
}

/// Blue, vermilion, green, purple, orange, sky blue, black, grey.
const COLORS: [RGBColor; 8] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(148, 82, 128),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(0, 0, 0),
    RGBColor(130, 130, 130),
];

const FONT: &str = "sans-serif";

impl Plot {
    /// Nothing is drawn as yet.
    pub fn new(title: impl Into<String>, x: Axis, y: Axis) -> Plot {
        Plot { title: title.into(), x, y, series: Vec::new(), square: false }
    }

    /// Points of the unit square.
    pub fn of_points(title: impl Into<String>, x: &str, y: &str, points: &[[f64; 2]]) -> Plot {
        let (x, y) = (Axis::linear(x).from_to(0.0, 1.0), Axis::linear(y).from_to(0.0, 1.0));
        let series = vec![Series::dots("", points.to_vec())];
        Plot { title: title.into(), x, y, series, square: true }
    }

    /// One more series.
    pub fn with(mut self, series: Series) -> Plot {
        self.series.push(series);
        self
    }

    /// Width and height [pixels].
    pub(crate) fn size(&self) -> (u32, u32) {
        if self.square { (330, 350) } else { (660, 420) }
    }

    /// The file.
    ///
    /// # Errors
    /// In words, where it cannot be drawn.
    pub(crate) fn svg(&self) -> Result<String, String> {
        let mut svg = String::new();
        self.draw(&mut svg).map_err(|e| e.to_string())?;
        Ok(svg)
    }

    fn axis(&self, which: usize) -> &Axis {
        if which == 0 { &self.x } else { &self.y }
    }

    fn is_drawn(&self, point: &[f64; 2]) -> bool {
        (0..2).all(|which| point[which].is_finite() && (point[which] > 0.0 || !self.axis(which).log))
    }

    /// Of each series the number that its colour and its mark follow from.
    fn looks(&self) -> impl Iterator<Item = usize> {
        let mut named = None;
        self.series.iter().enumerate().map(move |(number, series)| {
            if !series.name.is_empty() {
                named = Some(number);
            }
            named.unwrap_or(number)
        })
    }

    /// From where to where an axis runs.
    fn scale(&self, which: usize) -> Scale {
        let axis = self.axis(which);
        if let Some([low, high]) = axis.range {
            return Scale { low, high, log: axis.log, whole: axis.whole };
        }
        let points = self.series.iter().flat_map(|s| &s.points).filter(|p| self.is_drawn(p));
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        points.for_each(|p| (low, high) = (low.min(p[which]), high.max(p[which])));
        if low > high {
            (low, high) = (1.0, 2.0);
        }
        if axis.log {
            return Scale { low: low / 1.3, high: high * 1.3, log: true, whole: axis.whole };
        }
        let margin = if high > low { (high - low) * 0.05 } else { low.abs().max(1.0) * 0.1 };
        // What is never negative begins at zero.
        let low = if low >= 0.0 && low < 0.5 * high { 0.0 } else { low - margin };
        Scale { low, high: high + margin, log: false, whole: axis.whole }
    }

    fn draw(&self, svg: &mut String) -> Result<(), Box<dyn Error>> {
        let sheet = SVGBackend::with_string(svg, self.size()).into_drawing_area();
        sheet.fill(&WHITE).map_err(words)?;
        let named = self.series.iter().any(|s| !s.name.is_empty());
        let (left, right) = sheet.split_horizontally(self.size().0 - if named { LEGEND } else { 0 });
        let mut builder = ChartBuilder::on(&left);
        builder.margin(12).margin_right(18).x_label_area_size(46).y_label_area_size(66);
        builder.caption(&self.title, (FONT, if self.square { 14 } else { 17 }));
        let mut chart = builder.build_cartesian_2d(self.scale(0), self.scale(1)).map_err(words)?;
        let mut mesh = chart.configure_mesh();
        mesh.x_desc(&self.x.label).y_desc(&self.y.label).axis_desc_style((FONT, 14)).label_style((FONT, 13));
        mesh.light_line_style(WHITE).bold_line_style(RGBColor(224, 224, 224));
        mesh.draw().map_err(words)?;
        for (series, number) in self.series.iter().zip(self.looks()) {
            let stroke = color(number).stroke_width(2);
            let drawn = || series.points.iter().filter(|p| self.is_drawn(p)).map(|p| (p[0], p[1]));
            match series.mark {
                Mark::Line | Mark::Curve => chart.draw_series(LineSeries::new(drawn(), stroke)).map(drop),
                Mark::Dashes => chart.draw_series(DashedLineSeries::new(drawn(), 7, 5, stroke)).map(drop),
                Mark::Dots => Ok(()),
            }
            .map_err(words)?;
            if matches!(series.mark, Mark::Line | Mark::Dots) {
                let radius = if series.points.len() > 100 { 2 } else { 4 };
                for at in drawn().map(|at| chart.backend_coord(&at)) {
                    mark(&sheet, number, at, radius)?;
                }
            }
        }
        if named {
            self.legend(&right, &sheet)?;
        }
        sheet.present().map_err(words)?;
        Ok(())
    }

    /// Names beside the diagram, where they hide nothing.
    fn legend(&self, area: &Area<'_>, sheet: &Area<'_>) -> Result<(), Box<dyn Error>> {
        let left = self.size().0 as i32 - LEGEND as i32;
        let named = self.looks().zip(&self.series).filter(|(_, series)| !series.name.is_empty());
        for (row, (number, series)) in named.enumerate() {
            let y = 60 + 26 * row as i32;
            let stroke = color(number).stroke_width(2);
            let strokes: &[[i32; 2]] = match series.mark {
                Mark::Line | Mark::Curve => &[[0, 24]],
                Mark::Dashes => &[[0, 7], [12, 19]],
                Mark::Dots => &[],
            };
            for [from, to] in strokes {
                area.draw(&PathElement::new(vec![(*from, y), (*to, y)], stroke)).map_err(words)?;
            }
            if matches!(series.mark, Mark::Line | Mark::Dots) {
                mark(sheet, number, (left + 12, y), 4)?;
            }
            area.draw(&Text::new(series.name.clone(), (30, y - 7), (FONT, 13))).map_err(words)?;
        }
        Ok(())
    }
}

/// What an axis maps, with marks at 1, 2 and 5 times powers of ten where it is logarithmic.
#[derive(Clone)]
struct Scale {
    low: f64,
    high: f64,
    log: bool,
    whole: bool,
}

impl Scale {
    fn share(&self, value: f64) -> f64 {
        let of = |v: f64| if self.log { libm::log(v) } else { v };
        (of(value) - of(self.low)) / (of(self.high) - of(self.low))
    }

    fn ticks(&self) -> Vec<f64> {
        let inside = |t: &f64| (self.low..=self.high).contains(t);
        if !self.log {
            let step = nice((self.high - self.low) / 6.0).max(if self.whole { 1.0 } else { 0.0 });
            let first = (self.low / step).ceil();
            return (0..20).map(|k| (first + f64::from(k)) * step).filter(inside).collect();
        }
        let decades = libm::log10(self.low).floor() as i32..=libm::log10(self.high).ceil() as i32;
        let of = |steps: &[f64]| -> Vec<f64> {
            let powers = decades.clone().map(|e| libm::pow(10.0, f64::from(e)));
            powers.flat_map(|power| steps.iter().map(move |s| s * power)).filter(inside).collect()
        };
        let fine = of(&[1.0, 2.0, 5.0]);
        if fine.len() <= 8 { fine } else { of(&[1.0]) }
    }
}

/// The least of 1, 2 and 5 times powers of ten that is no less.
fn nice(step: f64) -> f64 {
    let power = libm::pow(10.0, libm::log10(step).floor());
    [1.0, 2.0, 5.0].map(|s| s * power).into_iter().find(|s| *s >= step * (1.0 - 1e-9)).unwrap_or(10.0 * power)
}

impl Ranged for Scale {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (from, to): (i32, i32)) -> i32 {
        from + (self.share(*value) * f64::from(to - from)).round() as i32
    }

    fn key_points<H: KeyPointHint>(&self, _: H) -> Vec<f64> {
        self.ticks()
    }

    fn range(&self) -> std::ops::Range<f64> {
        self.low..self.high
    }
}

impl ValueFormatter<f64> for Scale {
    fn format(value: &f64) -> String {
        tick(*value)
    }
}

/// Width of the legend [pixels].
const LEGEND: u32 = 176;

type Area<'a> = DrawingArea<SVGBackend<'a>, plotters::coord::Shift>;

/// A failure that borrows nothing of the sheet.
fn words(error: impl std::fmt::Display) -> String {
    error.to_string()
}

fn color(number: usize) -> RGBColor {
    COLORS[number % COLORS.len()]
}

/// A mark of the series' own shape, at a place in pixels.
fn mark(sheet: &Area<'_>, number: usize, (x, y): (i32, i32), r: i32) -> Result<(), Box<dyn Error>> {
    let fill = color(number).filled();
    let line = color(number).stroke_width(2);
    match number % 5 {
        0 => sheet.draw(&Circle::new((x, y), r, fill)),
        1 => sheet.draw(&Rectangle::new([(x - r, y - r), (x + r, y + r)], fill)),
        2 => sheet.draw(&Polygon::new(vec![(x, y - r - 1), (x + r + 1, y + r), (x - r - 1, y + r)], fill)),
        3 => sheet.draw(&Circle::new((x, y), r, line)),
        _ => {
            let diamond = vec![(x, y - r - 2), (x + r + 2, y), (x, y + r + 2), (x - r - 2, y)];
            sheet.draw(&Polygon::new(diamond, fill))
        }
    }
    .map_err(words)?;
    Ok(())
}

/// A number at an axis, as short as it can be said.
fn tick(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 {
        return "0".into();
    }
    if !(1e-3..1e5).contains(&size) {
        return format!("{value:.0e}");
    }
    let text = format!("{value:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_are_marked_at_round_numbers() {
        let scale = |low, high, log| Scale { low, high, log, whole: false }.ticks();
        assert_eq!(scale(0.0, 1.0, false).len(), 6);
        assert_eq!(scale(0.004, 0.07, true), [0.005, 0.01, 0.02, 0.05]);
        assert_eq!(scale(1.0, 1e6, true).len(), 7);
        assert_eq!(Scale { low: -0.5, high: 2.5, log: false, whole: true }.ticks(), [0.0, 1.0, 2.0]);
    }

    #[test]
    fn ticks_are_short() {
        let told = [0.0, 1.0, 0.25, 1000.0, 0.001, 2e-7, 3e6].map(tick);
        assert_eq!(told, ["0", "1", "0.25", "1000", "0.001", "2e-7", "3e6"]);
    }

    /// Also without a point, with one alone, and with some that an axis cannot show.
    #[test]
    fn every_pair_of_axes_is_drawn() {
        for points in [vec![], vec![[3.0, 4.0]], vec![[1.0, 0.0], [10.0, 5.0], [100.0, f64::NAN]]] {
            for (x, y) in [(false, false), (false, true), (true, false), (true, true)] {
                let axis = |log, label: &str| if log { Axis::log(label) } else { Axis::linear(label) };
                let plot = Plot::new("error & <N>", axis(x, "N"), axis(y, "error [%]"));
                let plot = plot
                    .with(Series::line("measured", points.clone()))
                    .with(Series::dashes("theory", points.clone()))
                    .with(Series::dots("points", points.clone()));
                let svg = plot.svg().unwrap();
                assert!(svg.contains("error &amp; &lt;N&gt;") && svg.contains("theory"), "{svg}");
                assert!(svg.trim_end().ends_with("</svg>"));
            }
        }
    }
}
