//! OpenEXR: the radiance itself, 32-bit floats in cd/m², and every layer as a part of its own.
//! The header states the colour space: Rec. 709 primaries and D65 white as `chromaticities`, and `whiteLuminance` 1,
//! since a pixel of (1, 1, 1) is 1 cd/m². Exposure and tone curve do not act here.

use super::{Display, Layer, Picture, Plane};
use crate::color::Rgb;
use exr::image::{AnyChannel, AnyChannels, Encoding, FlatSamples, Image, Layer as Part, Layers};
use exr::meta::attribute::{Chromaticities, IntegerBounds, Text};
use exr::meta::header::{ImageAttributes, LayerAttributes};
use exr::prelude::{Compression, LineOrder, Vec2, WritableImage};
use std::io::Cursor;

/// The bytes of the file.
pub(super) fn encode(picture: &Picture, _: &Display) -> Result<Vec<u8>, String> {
    let size = (picture.width as usize, picture.height as usize);
    let attributes = ImageAttributes {
        chromaticities: Some(Chromaticities {
            red: Vec2(0.64, 0.33),
            green: Vec2(0.3, 0.6),
            blue: Vec2(0.15, 0.06),
            white: Vec2(0.3127, 0.329),
        }),
        ..ImageAttributes::new(IntegerBounds::from_dimensions(size))
    };
    let mut first = part("picture", rgb(&picture.radiance), size);
    first.attributes.comments = Some(text(&comments(picture)));
    let further = picture.layers.iter().map(|Layer { name, plane }| part(name, channels(plane), size));
    let image =
        Image { attributes, layer_data: std::iter::once(first).chain(further).collect::<Layers<_>>() };
    let mut bytes = Cursor::new(Vec::new());
    image.write().to_buffered(&mut bytes).map_err(|e| e.to_string())?;
    Ok(bytes.into_inner())
}

/// One standard attribute holds all metadata: the order of several of our own would change from run to run.
fn comments(picture: &Picture) -> String {
    let lines: Vec<String> = picture.metadata.iter().map(|(key, value)| format!("{key}: {value}")).collect();
    lines.join("\n")
}

/// The format counts bytes and its readers take them for UTF-8.
fn text(utf8: &str) -> Text {
    Text::from_slice_unchecked(utf8.as_bytes())
}

fn part(
    name: &str,
    channels: Vec<AnyChannel<FlatSamples>>,
    size: (usize, usize),
) -> Part<AnyChannels<FlatSamples>> {
    let attributes = LayerAttributes {
        white_luminance: Some(1.0),
        software_name: Some(text(concat!("lampyris ", env!("CARGO_PKG_VERSION")))),
        ..LayerAttributes::named(text(name))
    };
    let encoding = Encoding {
        compression: Compression::ZIP16,
        line_order: LineOrder::Increasing,
        ..Encoding::FAST_LOSSLESS
    };
    Part::new(size, attributes, encoding, AnyChannels::sort(channels.into_iter().collect()))
}

fn channels(plane: &Plane) -> Vec<AnyChannel<FlatSamples>> {
    match plane {
        Plane::Color(p) => rgb(p),
        Plane::Normal(p) => {
            ["X", "Y", "Z"].into_iter().enumerate().map(|(k, c)| float(c, p.iter().map(|n| n[k]))).collect()
        }
        Plane::Depth(p) => vec![float("Z", p.iter().copied())],
        Plane::Id(p) => vec![AnyChannel::new("id", FlatSamples::U32(p.clone()))],
    }
}

fn rgb(pixels: &[Rgb]) -> Vec<AnyChannel<FlatSamples>> {
    ["R", "G", "B"].into_iter().enumerate().map(|(k, c)| float(c, pixels.iter().map(|p| p[k]))).collect()
}

fn float(name: &str, values: impl Iterator<Item = f32>) -> AnyChannel<FlatSamples> {
    AnyChannel::new(name, FlatSamples::F32(values.collect()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use exr::prelude::{ReadChannels, ReadLayers};
    use glam::Vec3;

    fn picture() -> Picture {
        let radiance = (0..35).map(|i| Rgb::new(i as f32, -0.25, 1e-30 * i as f32)).collect();
        let mut picture = Picture::new(7, 5, radiance);
        picture.metadata = vec![("scene".into(), "a.mgf".into()), ("seed".into(), "7".into())];
        picture.layers = vec![
            Layer { name: "direct".into(), plane: Plane::Color(vec![Rgb::grey(2.5); 35]) },
            Layer { name: "normal".into(), plane: Plane::Normal(vec![Vec3::new(1.0, 2.0, 3.0); 35]) },
            Layer { name: "depth".into(), plane: Plane::Depth(vec![f32::INFINITY; 35]) },
            Layer { name: "object".into(), plane: Plane::Id((0..35).map(|i| i << 24).collect()) },
        ];
        picture
    }

    fn round_trip(picture: &Picture) -> Image<Layers<AnyChannels<FlatSamples>>> {
        let bytes = encode(picture, &Display::default()).unwrap();
        let read = exr::prelude::read().no_deep_data().largest_resolution_level().all_channels();
        read.all_layers().all_attributes().from_buffered(Cursor::new(bytes)).unwrap()
    }

    #[test]
    fn every_number_comes_back() {
        let (picture, image) = (picture(), round_trip(&picture()));
        let names: Vec<_> =
            image.layer_data.iter().map(|l| l.attributes.layer_name.clone().unwrap().to_string()).collect();
        assert_eq!(names, ["picture", "direct", "normal", "depth", "object"]);
        let planes = [Plane::Color(picture.radiance.clone())];
        for (part, plane) in
            image.layer_data.iter().zip(planes.iter().chain(picture.layers.iter().map(|l| &l.plane)))
        {
            let mut expected = channels(plane);
            expected.sort_by_key(|c| c.name.to_string());
            assert_eq!(part.channel_data.list.to_vec(), expected);
        }
    }

    #[test]
    fn the_header_states_units_and_colour_space() {
        let image = round_trip(&picture());
        let c = image.attributes.chromaticities.unwrap();
        assert_eq!((c.red, c.white), (Vec2(0.64, 0.33), Vec2(0.3127, 0.329)));
        let first = &image.layer_data[0].attributes;
        assert_eq!(first.white_luminance, Some(1.0));
        assert_eq!(first.comments.clone().unwrap().to_string(), "scene: a.mgf\nseed: 7");
    }

    #[test]
    fn the_same_picture_is_the_same_file() {
        let bytes = |_| encode(&picture(), &Display::default()).unwrap();
        assert!((0..8).map(bytes).all(|b| b == bytes(0)));
    }

    #[test]
    fn text_is_utf8() {
        let mut foreign = picture();
        foreign.metadata[0].1 = "büro-事務所.mgf".into();
        let comments = round_trip(&foreign).layer_data[0].attributes.comments.clone().unwrap();
        assert_eq!(comments.as_slice(), "scene: büro-事務所.mgf\nseed: 7".as_bytes());
    }
}
