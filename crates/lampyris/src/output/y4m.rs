//! YUV4MPEG2: films as plain bytes, a line of text and three planes a frame, which every tool for films reads.
//!
//! 4:4:4, so that no pixel shares its colour. The format has no word for the matrix of its colours; by custom it is that
//! of Rec. ITU-R BT.601 with black at 16 and white at 235, and so it is here.

/// The line that a film begins with; `rate` in frames a second.
pub fn header(width: u32, height: u32, rate: u32) -> Vec<u8> {
    format!("YUV4MPEG2 W{width} H{height} F{rate}:1 Ip A1:1 C444 XCOLORRANGE=LIMITED\n").into_bytes()
}

/// The bytes of a frame: pixels of [`super::display`], row by row from the top.
pub fn frame(pixels: &[[u8; 3]]) -> Vec<u8> {
    let planes = [luma, blue_difference, red_difference];
    let values = planes.iter().flat_map(|plane| pixels.iter().map(plane));
    b"FRAME\n".iter().copied().chain(values).collect()
}

fn luma(&[r, g, b]: &[u8; 3]) -> u8 {
    quantize(16.0, 219.0 * y(r, g, b))
}

fn blue_difference(&[r, g, b]: &[u8; 3]) -> u8 {
    quantize(128.0, 224.0 * (f32::from(b) / 255.0 - y(r, g, b)) / 1.772)
}

fn red_difference(&[r, g, b]: &[u8; 3]) -> u8 {
    quantize(128.0, 224.0 * (f32::from(r) / 255.0 - y(r, g, b)) / 1.402)
}

/// Y' of R'G'B', 0 to 1.
fn y(r: u8, g: u8, b: u8) -> f32 {
    (0.299 * f32::from(r) + 0.587 * f32::from(g) + 0.114 * f32::from(b)) / 255.0
}

fn quantize(zero: f32, value: f32) -> u8 {
    (zero + value).round() as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn planes_hold_the_standards_values() {
        // Bars of 100 %: values of Rec. ITU-R BT.601 by its formulas.
        let pixels = [[0, 0, 0], [255, 255, 255], [255, 0, 0], [0, 255, 0], [0, 0, 255]];
        let bytes = frame(&pixels);
        let (mark, planes) = bytes.split_at(6);
        assert_eq!(mark, b"FRAME\n");
        assert_eq!(planes[..5], [16, 235, 81, 145, 41]);
        assert_eq!(planes[5..10], [128, 128, 90, 54, 240]);
        assert_eq!(planes[10..], [128, 128, 240, 34, 110]);
    }
}
