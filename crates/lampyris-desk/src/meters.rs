//! Meters and grids as people lay them out, as points to measure; and what the points read, as what is said of them.

use crate::model::{Model, Notes};
use crate::wire::Look;
use glam::Vec3;
use lampyris::eye::Meter;
use lampyris::measuring::{BORDER, Estimate, Kind, MOST, Rectangle, Statistics};
use serde::Deserialize;
use serde_json::{Map, Value, json};
use std::ops::Range;

/// Points in the order in which they are measured, and whose they are.
#[derive(Clone, Debug, Default)]
pub(crate) struct Layout {
    pub(crate) points: Vec<Meter>,
    meters: Vec<(u32, Range<usize>)>,
    grids: Vec<(u32, Range<usize>, f64)>,
}

/// Points of all meters and grids together.
const POINTS: usize = 4 * MOST as usize;

/// Most that targets are raised by for the ± of what is read, as a share: a reading that has just begun says little.
const UNSURE: f64 = 0.1;

#[derive(Deserialize)]
struct Laid {
    #[serde(default)]
    kind: String,
    point: Vec3,
    normal: Option<Vec3>,
}

#[derive(Deserialize)]
struct Area {
    corner: Vec3,
    u: Vec3,
    v: Vec3,
    normal: Option<Vec3>,
    columns: Option<u32>,
    rows: Option<u32>,
    border: Option<f32>,
    maintenance: Option<f32>,
}

impl Layout {
    /// Of what a model has; what makes no sense is left out.
    pub(crate) fn of(model: &Model, up: Vec3, look: Option<&Look>) -> Layout {
        let mut layout = Layout::default();
        let Notes { meters, grids, .. } = &model.notes;
        for (id, note) in meters {
            let Ok(laid) = Laid::deserialize(note) else { continue };
            let kind = match laid.kind.as_str() {
                "horizontal" => Kind::Horizontal,
                "vertical" => Kind::Vertical { toward: laid.normal.unwrap_or(Vec3::X) },
                "cylindrical" => Kind::Cylindrical,
                "camera" => Kind::Toward { eye: look.map_or(laid.point + up, |look| look.eye) },
                _ => Kind::Surface { normal: laid.normal.unwrap_or(up) },
            };
            layout.add(kind.meters(laid.point, up), |layout, points| layout.meters.push((*id, points)));
        }
        for (id, note) in grids {
            let Ok(area) = Area::deserialize(note) else { continue };
            let factor = f64::from(area.maintenance.filter(|f| *f > 0.0 && *f <= 1.0).unwrap_or(1.0));
            let points = area.points(up);
            layout.add(points, |layout, points| layout.grids.push((*id, points, factor)));
        }
        layout
    }

    fn add(&mut self, points: Vec<Meter>, note: impl FnOnce(&mut Layout, Range<usize>)) {
        let start = self.points.len();
        let sound = points.iter().all(|m| m.position.is_finite() && m.normal.is_finite());
        if points.is_empty() || !sound || start + points.len() > POINTS {
            return;
        }
        self.points.extend(points);
        note(self, start..self.points.len());
    }

    /// Of each meter or area that has a target, what each layer gives it, of what each gives each point, and what it is to
    /// read [lx]: so much that the target is met at the lower end of what its reading, ± and all, may be.
    pub(crate) fn wanted(
        &self,
        notes: &Notes,
        by_layer: &[Vec<f64>],
        readings: &[Estimate],
    ) -> (Vec<Vec<f64>>, Vec<f64>) {
        let mean = |points: &Range<usize>, factor: f64| -> Option<Vec<f64>> {
            let of = |layer: &Vec<f64>| {
                let points = layer.get(points.clone())?;
                Some(points.iter().sum::<f64>() / points.len() as f64 * factor)
            };
            by_layer.iter().map(of).collect()
        };
        // ± is a share of what is read, whatever the levels.
        let least = |points: &Range<usize>| {
            let reading = readings.get(points.clone()).map(Kind::reading);
            let off = reading.and_then(|own| Some(own.error? / own.value)).filter(|off| *off > 0.0);
            1.0 - off.unwrap_or(0.0).min(UNSURE)
        };
        let lux = |target: &Value| {
            target.as_f64().or(target["lux"].as_f64()).filter(|lux| *lux > 0.0 && *lux < 1e9)
        };
        let meters = self.meters.iter().map(|(id, points)| (notes.meters.get(id), points, 1.0));
        let grids = self.grids.iter().map(|(id, points, factor)| (notes.grids.get(id), points, *factor));
        let wanted = |(note, points, factor): (Option<&Value>, &Range<usize>, f64)| {
            Some((mean(points, factor)?, lux(&note?["target"])? / least(points)))
        };
        meters.chain(grids).filter_map(wanted).filter(|(row, _)| !row.is_empty()).unzip()
    }

    /// What is said of meters and grids whose points read so, by slice and number; `done` where they will not read otherwise.
    pub(crate) fn told(&self, readings: &[Estimate], done: bool) -> Value {
        let told = |reading: Estimate| json!([reading.value, reading.error]);
        let meters = self.meters.iter().filter_map(|(id, points)| {
            let reading = Kind::reading(readings.get(points.clone())?);
            Some((id.to_string(), json!({"lux": told(reading), "done": done})))
        });
        let grids = self.grids.iter().filter_map(|(id, points, factor)| {
            let readings = readings.get(points.clone())?;
            let s = Statistics::of(readings, *factor)?;
            let lux: Vec<f64> = readings.iter().map(|reading| reading.value * factor).collect();
            let told = json!({
                "lux": lux, "mean": s.mean.value, "error": s.mean.error, "min": s.least.value, "max": s.greatest.value,
                "uniformity": s.uniformity.value, "uniformity_error": s.uniformity.error, "diversity": s.diversity.value,
                "count": s.count, "done": done,
            });
            Some((id.to_string(), told))
        });
        let (meters, grids): (Map<String, Value>, Map<String, Value>) = (meters.collect(), grids.collect());
        json!({"meters": meters, "grids": grids})
    }
}

impl Area {
    /// As many points as it says, or as the standard asks.
    fn points(&self, up: Vec3) -> Vec<Meter> {
        let normal = self.normal.unwrap_or(up).normalize_or(up);
        let (Some(columns), Some(rows)) = (self.columns, self.rows) else {
            let (border, maintenance) = (self.border.unwrap_or(BORDER), 1.0);
            let area =
                Rectangle { corner: self.corner, edges: [self.u, self.v], normal, border, maintenance };
            return area.grid().map_or(Vec::new(), |grid| grid.meters);
        };
        if columns == 0 || rows == 0 || u64::from(columns) * u64::from(rows) > u64::from(MOST) {
            return Vec::new();
        }
        let border = self.border.filter(|border| *border > 0.0).unwrap_or(0.0);
        let off = |edge: Vec3| if edge.length() > 2.0 * border { border / edge.length() } else { 0.0 };
        let along = |edge: Vec3, k: u32, count: u32| {
            edge * (off(edge) + (1.0 - 2.0 * off(edge)) * (k as f32 + 0.5) / count as f32)
        };
        let cells = (0..rows).flat_map(|y| (0..columns).map(move |x| (x, y)));
        cells
            .map(|(x, y)| Meter {
                position: self.corner + along(self.u, x, columns) + along(self.v, y, rows),
                normal,
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_keep_off_the_border_where_there_is_room_for_one() {
        let text = r#"{"corner":[1,2,3],"u":[4,0,0],"v":[0,0.8,0],"columns":3,"rows":2,"border":0.5}"#;
        let points = |text: &str| serde_json::from_str::<Area>(text).unwrap().points(Vec3::Z);
        let laid = points(text);
        assert_eq!(laid.len(), 6);
        assert!((laid[0].position - Vec3::new(2.0, 2.2, 3.0)).length() < 1e-6);
        assert!((laid[5].position - Vec3::new(4.0, 2.6, 3.0)).length() < 1e-6);
        // Without one, cells are even over the whole of it.
        for none in ["0", "-1", "null"] {
            let laid = points(&text.replace("0.5}", &format!("{none}}}")));
            assert!((laid[0].position - Vec3::new(1.0 + 4.0 / 6.0, 2.2, 3.0)).length() < 1e-6, "{none}");
        }
    }
}
