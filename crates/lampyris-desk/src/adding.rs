//! Lamps that were not in the file: what they are when somebody hangs them up.

use crate::color::Color;
use crate::model::{Body, Lamp};
use crate::patch::Place;
use crate::place::place_of;
use crate::wire;
use glam::Vec3;
use lampyris::Rgb;
use lampyris::light::{Beam, Bounds, Emitter, Light, LightKind};
use lampyris::scene::{Group, Scene, Share, Source};
use serde::Deserialize;

/// A lamp to be added.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct NewLamp {
    kind: NewKind,
    name: Option<String>,
    /// [lm]
    flux: Option<f32>,
    place: Place,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
enum NewKind {
    Point,
    Spot,
    Sphere,
    Disc,
}

/// What a lamp sends out unless asked otherwise [lm], its angles [degrees] and its radius [m].
const FLUX: f32 = 800.0;
const ANGLES: [f32; 2] = [36.0, 60.0];
const RADIUS: f32 = 0.1;

impl NewLamp {
    /// The light that it is: white, as bright as its flux asks.
    pub(crate) fn light(&self, number: usize, down: Vec3) -> Result<Light, String> {
        let flux = self.flux.unwrap_or(FLUX);
        if !(flux > 0.0 && flux <= 1e9) {
            return Err("a lamp sends out more than 0 and at most a thousand million lumens".into());
        }
        let place = &self.place;
        let position = place.position.ok_or("need a position")?;
        let direction = place.direction.or(place.aim.and_then(|aim| (aim - position).try_normalize()));
        let direction = direction.unwrap_or(down).try_normalize().ok_or("a direction that is none")?;
        let radius = place.radius.unwrap_or(RADIUS);
        let kind = match self.kind {
            NewKind::Point => LightKind::Point { position, intensity: Rgb::WHITE },
            NewKind::Spot => {
                let [inner, outer] = [place.inner.unwrap_or(ANGLES[0]), place.outer.unwrap_or(ANGLES[1])]
                    .map(|angle| libm::cosf((0.5 * angle).to_radians()));
                let beam = Beam::Cone { cos_inner: inner, cos_outer: outer };
                LightKind::Spot { position, direction, intensity: Rgb::WHITE, beam }
            }
            NewKind::Sphere => LightKind::Sphere { center: position, radius, radiance: Rgb::WHITE },
            NewKind::Disc => {
                LightKind::Disc { center: position, normal: direction, radius, radiance: Rgb::WHITE }
            }
        };
        let kind = as_bright(kind, flux)?;
        let name = match &self.name {
            Some(name) => wire::name(name.clone())?,
            None => format!("lamp {number}"),
        };
        Ok(Light::new(name, kind))
    }
}

/// The same light with a flux [lm].
fn as_bright(kind: LightKind, flux: f32) -> Result<LightKind, String> {
    let kind = kind.with_brightness(Rgb::WHITE);
    let power = Emitter::Lamp(kind.clone()).power(Bounds::default()).luminance();
    if !(power > 0.0 && kind.is_sound()) {
        return Err("a lamp with numbers that make no sense".into());
    }
    Ok(kind.with_brightness(Rgb::grey(flux / power)))
}

/// The flux of a light [lm].
pub(crate) fn flux_of(kind: &LightKind) -> f32 {
    Emitter::Lamp(kind.clone()).power(Bounds::default()).luminance()
}

/// What follows from a light more, in a scene without its geometry as in the world: the next emitter, in a light group of its
/// own as long as there are some.
pub(crate) fn enter(scene: &mut Scene, light: u32) -> u32 {
    if scene.groups.len() < Group::MOST {
        let name = scene.lights[light as usize].name.clone();
        scene.groups.push(Group { name, color: Rgb::WHITE });
    }
    let group = scene.groups.len() as u16 - 1;
    scene.reference.shares.push(Share { source: Source::Light(light), share: 0.0, group });
    scene.reference.shares.len() as u32 - 1
}

/// The lamp that a light more is.
pub(crate) fn lamp(light: u32, own: &Light, emitter: u32, group: u32) -> Lamp {
    let place = place_of(&own.kind);
    Lamp {
        file_name: own.name.clone(),
        name: own.name.clone(),
        body: Body::Light(light, own.kind.clone()),
        on: true,
        level: 1.0,
        color: Color::of_file(Rgb::WHITE),
        group,
        parked: false,
        gone: false,
        own: true,
        file_place: place.clone(),
        file_group: group,
        place,
        flux: Some(flux_of(&own.kind)),
        emitters: vec![(emitter, Rgb::WHITE)],
        shining: Rgb::WHITE,
        bounds: None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lamps_have_the_flux_asked_for() {
        for kind in ["point", "spot", "sphere", "disc"] {
            let text = format!("{{\"kind\":\"{kind}\",\"flux\":450,\"place\":{{\"position\":[1,2,3]}}}}");
            let new: NewLamp = serde_json::from_str(&text).unwrap();
            let light = new.light(1, Vec3::NEG_Z).unwrap();
            assert!((flux_of(&light.kind) - 450.0).abs() < 1e-2, "{kind}");
        }
        for bad in [
            r#"{"kind":"point","place":{}}"#,
            r#"{"kind":"point","flux":-1,"place":{"position":[1,2,3]}}"#,
            r#"{"kind":"spot","place":{"position":[1,2,3],"inner":60,"outer":30}}"#,
            r#"{"kind":"disc","place":{"position":[1,2,3],"radius":-1}}"#,
            r#"{"kind":"disc","place":{"position":[1,2,3],"direction":[0,0,0]}}"#,
        ] {
            let new: NewLamp = serde_json::from_str(bad).unwrap();
            assert!(new.light(1, Vec3::NEG_Z).is_err(), "{bad}");
        }
    }
}
