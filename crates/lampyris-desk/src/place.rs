//! Where lamps and things stand: the places that a scene gives them, and what another place makes of a transform.

use crate::patch::Place;
use glam::{Affine3A, Quat, Vec3};
use lampyris::light::{Beam, LightKind};

/// The place of what has surfaces: about the middle of its box.
pub(crate) fn surface_place([low, high]: [Vec3; 2]) -> Place {
    let position = Some(low + (high - low) * 0.5);
    Place { position, rotation: Some(Quat::IDENTITY), scale: Some(1.0), ..Place::default() }
}

/// The place of a light.
pub(crate) fn place_of(kind: &LightKind) -> Place {
    let none = Place::default();
    let aim = |p: Vec3, d: Vec3| Some(p + d * 2.0);
    match *kind {
        LightKind::Point { position, .. } => Place { position: Some(position), ..none },
        LightKind::Spot { position, direction, beam, .. } => {
            let (inner, outer) = match beam {
                Beam::Cone { cos_inner, cos_outer } => {
                    let angle = |cosine: f32| Some(2.0 * libm::acosf(cosine).to_degrees());
                    (angle(cos_inner), angle(cos_outer))
                }
                Beam::Cosine { .. } => (None, None),
            };
            let (position, direction, aim) = (Some(position), Some(direction), aim(position, direction));
            Place { position, direction, aim, inner, outer, ..none }
        }
        LightKind::Directional { direction, .. } => Place { direction: Some(direction), ..none },
        LightKind::Sphere { center, radius, .. } => {
            Place { position: Some(center), radius: Some(radius), ..none }
        }
        LightKind::Disc { center, normal, radius, .. } => Place {
            position: Some(center),
            direction: Some(normal),
            aim: aim(center, normal),
            radius: Some(radius),
            ..none
        },
    }
}

/// Where a place takes what stood as `transform`, its box's middle at `middle`; the same bits where it takes it nowhere.
pub(crate) fn moved(transform: Affine3A, middle: Vec3, place: &Place) -> Affine3A {
    let position = place.position.unwrap_or(middle);
    let (rotation, scale) = (place.rotation.unwrap_or(Quat::IDENTITY), place.scale.unwrap_or(1.0));
    if position == middle && rotation == Quat::IDENTITY && scale == 1.0 {
        return transform;
    }
    let about = Affine3A::from_scale_rotation_translation(Vec3::splat(scale), rotation, position);
    about * Affine3A::from_translation(-middle) * transform
}
