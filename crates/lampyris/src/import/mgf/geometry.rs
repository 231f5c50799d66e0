//! The entities of MGF that make surfaces: arguments in, a patch of triangles into the scene.
//! Triangles are counted against the limit before they are made.
//! What a shape looks like is in `shapes`.

use super::args::{Reason, exactly, number};
use super::reader::{Fault, Reader};
use super::shapes::{
    Flaws, Patch, Station, Vertex, cone_profile, polygon, prism, revolve, revolved_triangles, ring_profile,
    sphere_profile, torus_profile,
};
use crate::import::report::quote;
use glam::DVec3;

impl Reader<'_> {
    /// Carries out one geometric entity.
    pub(super) fn geometry(&mut self, keyword: &str, words: &[&str]) -> Result<(), Fault> {
        let patch = match keyword {
            "f" => self.face(words)?,
            "fh" => self.face_with_holes(words)?,
            "prism" => self.prism(words)?,
            _ => Some(self.round(keyword, words)?),
        };
        let Some(patch) = patch else {
            self.warn(&format!("{} without area is left out", quote(keyword)));
            return Ok(());
        };
        let material = match self.material {
            Some(material) => material,
            None => {
                let (material, mended) =
                    self.sink.material(self.surfaces.current_name(), self.surfaces.current());
                if let Some(mended) = mended {
                    let name = quote(self.surfaces.current_name());
                    self.warn(&format!("material {name}: {mended}"));
                }
                *self.material.insert(material)
            }
        };
        let place = self.place();
        self.sink.add(&patch, &place, material)?;
        Ok(())
    }

    fn face(&mut self, words: &[&str]) -> Result<Option<Patch>, Fault> {
        if words.len() < 3 {
            return Err(format!("\"f\" takes 3 vertices or more, found {}", words.len()).into());
        }
        let vertices = self.corners(words)?;
        let contours = [vertices.len()];
        let made = polygon(vertices, &contours);
        Ok(self.told(made))
    }

    fn face_with_holes(&mut self, words: &[&str]) -> Result<Option<Patch>, Fault> {
        let mut vertices = Vec::new();
        let mut contours = Vec::new();
        for contour in words.split(|w| *w == "-") {
            if contour.len() < 3 {
                return Err(
                    format!("a contour of \"fh\" has 3 vertices or more, found {}", contour.len()).into()
                );
            }
            vertices.extend(self.corners(contour)?);
            contours.push(vertices.len());
        }
        let (corners, holes) = (vertices.len() as u64, contours.len() as u64 - 1);
        self.within_polygon(corners)?;
        self.room_for(corners + 2 * holes - 2)?;
        // Each hole looks for its seam along the whole outline.
        self.charge(corners * holes / 4096)?;
        let made = polygon(vertices, &contours);
        Ok(self.told(made))
    }

    fn prism(&mut self, words: &[&str]) -> Result<Option<Patch>, Fault> {
        let [corners @ .., length] = words else {
            return Err("\"prism\" takes 3 vertices or more and a length, found nothing".to_string().into());
        };
        if corners.len() < 3 {
            return Err(
                format!("\"prism\" takes 3 vertices or more and a length, found {}", corners.len()).into()
            );
        }
        let length = number(length)?;
        if length == 0.0 {
            return Err("a prism's length is not 0".to_string().into());
        }
        // Two ends of n − 2 triangles, n sides of two.
        self.room_for(4 * corners.len() as u64 - 4)?;
        let vertices = self.corners(corners)?;
        let made = prism(&vertices, length);
        Ok(self.told(made))
    }

    /// The shapes of revolution.
    fn round(&mut self, keyword: &str, words: &[&str]) -> Result<Patch, Fault> {
        let steps = self.options.circle_steps;
        let (origin, axis, profile, inward): (DVec3, DVec3, Vec<Station>, bool) = match keyword {
            "sph" => {
                let [center, radius] = exactly(keyword, words)?;
                let (center, radius) = (self.vertex(center)?, nonzero(radius, "radius")?);
                (center.point, DVec3::Z, sphere_profile(radius.abs(), steps), radius < 0.0)
            }
            "cyl" => {
                let [low, radius, high] = exactly(keyword, words)?;
                let radius = nonzero(radius, "radius")?;
                self.cone(low, radius, high, radius)?
            }
            "cone" => {
                let [low, r1, high, r2] = exactly(keyword, words)?;
                self.cone(low, number(r1)?, high, number(r2)?)?
            }
            _ => {
                let [center, inner, outer] = exactly(keyword, words)?;
                let (center, inner, outer) = (self.vertex(center)?, number(inner)?, number(outer)?);
                let inward = keyword == "torus" && outer < 0.0;
                let (r1, r2) = if inward { (-inner, -outer) } else { (inner, outer) };
                if !(0.0 <= r1 && r1 < r2) {
                    return Err(format!(
                        "{} takes its inner radius first, 0 ≤ inner < outer",
                        quote(keyword)
                    )
                    .into());
                }
                if center.normal == DVec3::ZERO {
                    return Err(format!(
                        "the centre of {} needs a normal; give its vertex \"n\"",
                        quote(keyword)
                    )
                    .into());
                }
                let profile =
                    if keyword == "ring" { ring_profile(r1, r2) } else { torus_profile(r1, r2, steps) };
                (center.point, center.normal, profile, inward)
            }
        };
        self.room_for(revolved_triangles(&profile, steps))?;
        Ok(revolve(origin, axis, &profile, steps, inward))
    }

    fn cone(&self, low: &str, r1: f64, high: &str, r2: f64) -> Reason<(DVec3, DVec3, Vec<Station>, bool)> {
        let (low, high) = (self.vertex(low)?.point, self.vertex(high)?.point);
        if r1 * r2 < 0.0 || (r1 == 0.0 && r2 == 0.0) {
            return Err("a cone's radii have the same sign, and at most one is 0".into());
        }
        let axis = high - low;
        if axis == DVec3::ZERO {
            return Err("both ends are the same point; an axis needs two".into());
        }
        let inward = r1 < 0.0 || r2 < 0.0;
        Ok((low, axis, cone_profile(r1.abs(), r2.abs(), axis.length()), inward))
    }

    fn vertex(&self, name: &str) -> Reason<Vertex> {
        self.vertices.get(name).copied()
    }

    /// The vertices of a contour of 3 or more.
    fn corners(&self, names: &[&str]) -> Result<Vec<Vertex>, Fault> {
        let count = names.len() as u64;
        self.within_polygon(count)?;
        self.room_for(count - 2)?;
        Ok(names.iter().map(|name| self.vertex(name)).collect::<Reason<_>>()?)
    }

    fn within_polygon(&self, count: u64) -> Result<(), Fault> {
        let limit = self.options.limits.polygon;
        if count <= limit {
            return Ok(());
        }
        Err(self.over(format!("a polygon of {count} vertices"), limit, "--max-polygon").into())
    }

    /// A patch, its flaws told.
    fn told(&mut self, made: Option<(Patch, Flaws)>) -> Option<Patch> {
        let (patch, flaws) = made?;
        if flaws.bent {
            self.warn("a polygon is not planar; its triangles follow its corners");
        }
        if flaws.crossed {
            self.warn("a polygon's outline crosses itself; its triangles may overlap");
        }
        Some(patch)
    }
}

fn nonzero(word: &str, what: &str) -> Reason<f64> {
    let value = number(word)?;
    if value == 0.0 { Err(format!("a {what} is not 0")) } else { Ok(value) }
}
