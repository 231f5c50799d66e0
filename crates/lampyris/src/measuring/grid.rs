//! Points over a surface, as close as EN 12464-1 asks: p = 0.2 · 5^(log₁₀ d) with cells near squares.

use super::statistics::{Estimate, Statistics};
use crate::error::{Error, Result};
use crate::eye::Meter;
use glam::Vec3;
use serde::{Deserialize, Serialize};
use std::fmt::Write;

/// What is usually left off along the edges of a room [m].
pub const BORDER: f32 = 0.5;

/// Most points of a grid.
pub const MOST: u32 = 100_000;

/// Widest distance of points [m].
const WIDEST: f64 = 10.0;

/// A surface to be measured.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rectangle {
    /// A corner [m].
    pub corner: Vec3,
    /// The two edges from there [m].
    pub edges: [Vec3; 2],
    /// The side that is lit.
    pub normal: Vec3,
    /// What is left off along all edges [m], as long as they are longer than two of it: [`BORDER`] in rooms, 0 where people
    /// work.
    pub border: f32,
    /// What is left of the light when lamps and walls have aged, 0 to 1: readings are multiplied by it.
    pub maintenance: f32,
}

/// Points over a rectangle, row by row along its first edge, each in the middle of its cell.
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    /// Points along the first edge.
    pub columns: u32,
    /// Points along the second edge.
    pub rows: u32,
    /// The points.
    pub meters: Vec<Meter>,
    maintenance: f64,
}

/// The widest distance of points on a surface of that length [m].
pub fn spacing(length: f64) -> f64 {
    (0.2 * libm::pow(5.0, libm::log10(length))).min(WIDEST)
}

/// Points along both edges: the longer one says how close they are, the shorter one of surfaces at least twice as long as
/// wide; along the other they are as close as that, to the nearest whole number.
fn counts(lengths: [f64; 2]) -> [f64; 2] {
    let [short, long] = [lengths[0].min(lengths[1]), lengths[0].max(lengths[1])];
    let leading = if long >= 2.0 * short { short } else { long };
    let cell = leading / (leading / spacing(leading)).round().max(1.0);
    lengths.map(|length| (length / cell).round().max(1.0))
}

impl Rectangle {
    /// Its points.
    ///
    /// # Errors
    /// [`Error::BadSetting`] for numbers that make no sense, edges that span nothing, and more than [`MOST`] points.
    pub fn grid(&self) -> Result<Grid> {
        let bad = |what: &str| Error::BadSetting(format!("cannot measure this surface: {what}"));
        let Rectangle { corner, edges: [u, v], normal, border, maintenance } = *self;
        let finite = corner.is_finite() && u.is_finite() && v.is_finite();
        let lengths = [u, v].map(|edge| f64::from(edge.length()));
        let across = f64::from(u.cross(v).length());
        if !finite || !across.is_finite() || across <= 1e-6 * lengths[0] * lengths[1] {
            return Err(bad("its edges span no area"));
        }
        let normal = normal.try_normalize().ok_or_else(|| bad("it has no normal"))?;
        if !(border >= 0.0 && border.is_finite() && maintenance > 0.0 && maintenance <= 1.0) {
            return Err(bad("a border is not negative, a maintenance factor lies between 0 and 1"));
        }
        let off = lengths.map(|length| {
            let border = f64::from(border);
            if length > 2.0 * border { border / length } else { 0.0 }
        });
        let [columns, rows] = counts([0, 1].map(|k| lengths[k] * (1.0 - 2.0 * off[k])));
        if columns * rows > f64::from(MOST) {
            return Err(bad(&format!("it would take {} points, and {MOST} are the most", columns * rows)));
        }
        let (columns, rows) = (columns as u32, rows as u32);
        let along = |k: u32, count: u32, off: f64| {
            (off + (1.0 - 2.0 * off) * (f64::from(k) + 0.5) / f64::from(count)) as f32
        };
        let place = |(x, y): (u32, u32)| corner + u * along(x, columns, off[0]) + v * along(y, rows, off[1]);
        let cells = (0..rows).flat_map(|y| (0..columns).map(move |x| (x, y)));
        let meters = cells.map(|cell| Meter { position: place(cell), normal }).collect();
        Ok(Grid { columns, rows, meters, maintenance: f64::from(maintenance) })
    }
}

impl Grid {
    /// What is to be said of its readings [lx], the maintenance factor included; `None` unless there is one for each point.
    pub fn statistics(&self, readings: &[Estimate]) -> Option<Statistics> {
        (readings.len() == self.meters.len()).then(|| Statistics::of(readings, self.maintenance)).flatten()
    }

    /// A table with a line for each point, and the maintenance factor in all readings, which are divided by `unit` [lx]: 1, or
    /// [`super::FOOTCANDLE`].
    pub fn csv(&self, readings: &[Estimate], unit: f64) -> String {
        let scale = self.maintenance / unit;
        let mut text = String::from("column,row,x,y,z,nx,ny,nz,illuminance,error\n");
        for (k, (meter, reading)) in (0..).zip(self.meters.iter().zip(readings)) {
            let (p, n) = (meter.position, meter.normal);
            let error = reading.error.map_or(String::new(), |e| format!("{:.4}", e * scale));
            // Writing to a string cannot fail.
            let _ = writeln!(
                text,
                "{},{},{},{},{},{},{},{},{:.4},{error}",
                k % self.columns + 1,
                k / self.columns + 1,
                p.x,
                p.y,
                p.z,
                n.x,
                n.y,
                n.z,
                reading.value * scale
            );
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rectangle(width: f32, depth: f32, border: f32) -> Rectangle {
        let edges = [Vec3::X * width, Vec3::Y * depth];
        Rectangle {
            corner: Vec3::new(1.0, 2.0, 0.75),
            edges,
            normal: Vec3::Z * 2.0,
            border,
            maintenance: 0.8,
        }
    }

    /// Powers of ten come out round, and small surfaces have some points too.
    #[test]
    fn spacings_are_those_of_the_standard() {
        for (length, expected) in
            [(0.1, 0.04), (1.0, 0.2), (10.0, 1.0), (100.0, 5.0), (1e4, 10.0), (1e9, 10.0)]
        {
            assert!((spacing(length) - expected).abs() < 1e-9, "{length}");
        }
        for (length, points) in
            [(0.4, 4.0), (0.6, 4.0), (1.0, 5.0), (2.0, 6.0), (5.0, 8.0), (10.0, 10.0), (50.0, 16.0)]
        {
            assert_eq!(counts([length, length]), [points; 2], "{length}");
        }
        // A corridor goes by its width: 2 m ask for 6 points, cells of 1/3 m.
        assert_eq!(counts([30.0, 2.0]), [90.0, 6.0]);
        assert_eq!(counts([2.0, 30.0]), [6.0, 90.0]);
    }

    #[test]
    fn cells_are_near_squares_and_close_enough() {
        for a in 1..60 {
            for b in 1..60 {
                let lengths = [0.17 * f64::from(a), 0.31 * f64::from(b)];
                let counts = counts(lengths);
                let cells = [lengths[0] / counts[0], lengths[1] / counts[1]];
                let ratio = cells[0] / cells[1];
                assert!((0.5..=2.0).contains(&ratio), "{lengths:?}: {cells:?}");
                // A whole number of cells may be half a point short.
                let [short, long] = [lengths[0].min(lengths[1]), lengths[0].max(lengths[1])];
                let leading = if long >= 2.0 * short { short } else { long };
                let widest = spacing(leading) * 1.5;
                assert!(cells.iter().all(|cell| *cell <= widest), "{lengths:?}: {cells:?}");
            }
        }
    }

    #[test]
    fn points_fill_what_is_inside_the_border() {
        for (width, depth, border) in [(6.0, 4.0, 0.5), (1.6, 0.8, 0.0), (0.9, 3.0, 0.5)] {
            let grid = rectangle(width, depth, border).grid().expect("a surface");
            assert_eq!(grid.meters.len() as u32, grid.columns * grid.rows);
            let off = |length: f32| if length > 2.0 * border { border } else { 0.0 };
            let inner = [width - 2.0 * off(width), depth - 2.0 * off(depth)];
            let cell = Vec3::new(inner[0] / grid.columns as f32, inner[1] / grid.rows as f32, 0.0);
            for (k, meter) in (0..).zip(&grid.meters) {
                let at = Vec3::new((k % grid.columns) as f32 + 0.5, (k / grid.columns) as f32 + 0.5, 0.0);
                let expected = Vec3::new(1.0 + off(width), 2.0 + off(depth), 0.75) + at * cell;
                assert!((meter.position - expected).length() < 1e-5 && meter.normal == Vec3::Z);
            }
            let readings = vec![Estimate { value: 100.0, error: Some(1.0) }; grid.meters.len()];
            let statistics = grid.statistics(&readings).expect("a reading each");
            assert!((statistics.mean.value - 80.0).abs() < 1e-5 && statistics.count == grid.meters.len());
            assert!(grid.statistics(&readings[1..]).is_none());
            let table = grid.csv(&readings, super::super::FOOTCANDLE);
            assert_eq!(table.lines().count(), 1 + readings.len());
            assert!(table.lines().skip(1).all(|line| line.ends_with(",7.4322,0.0743")), "{table}");
        }
    }

    #[test]
    fn senseless_surfaces_are_refused() {
        let good = rectangle(2.0, 1.0, 0.0);
        let edges = |u: Vec3, v: Vec3| Rectangle { edges: [u, v], ..good };
        let broken = [
            edges(Vec3::X, Vec3::X * 2.0),
            edges(Vec3::ZERO, Vec3::Y),
            edges(Vec3::X * f32::NAN, Vec3::Y),
            edges(Vec3::X * 1e30, Vec3::Y * 1e30),
            edges(Vec3::X * 1e5, Vec3::Y * 1e5),
            Rectangle { corner: Vec3::splat(f32::INFINITY), ..good },
            Rectangle { normal: Vec3::ZERO, ..good },
            Rectangle { border: -1.0, ..good },
            Rectangle { border: f32::NAN, ..good },
            Rectangle { maintenance: 0.0, ..good },
            Rectangle { maintenance: 1.1, ..good },
        ];
        for rectangle in broken {
            assert!(matches!(rectangle.grid(), Err(Error::BadSetting(_))), "{rectangle:?}");
        }
        assert!(good.grid().is_ok());
    }
}
