//! `EXT_meshopt_compression`: its three codecs in their first versions, which are the extension's, and its filters for
//! normals and for numbers with a common exponent. The filter for rotations belongs to animations and is left out.
//!
//! Every code word is looked up in what is left of its stream, so that a broken one ends in an error.

use super::json::Compressed;

/// The bytes still to be read.
struct Stream<'a>(&'a [u8]);

impl<'a> Stream<'a> {
    fn take(&mut self, n: usize) -> Result<&'a [u8], String> {
        let (head, rest) = self.0.split_at_checked(n).ok_or("packed data that is cut off")?;
        self.0 = rest;
        Ok(head)
    }

    fn byte(&mut self) -> Result<u8, String> {
        self.take(1).map(|b| b[0])
    }

    /// Seven bits a byte, the lowest first; the eighth says that more follow.
    fn number(&mut self) -> Result<u32, String> {
        let mut value = 0u32;
        for shift in [0, 7, 14, 21, 28] {
            let byte = self.byte()?;
            value |= u32::from(byte & 127) << shift;
            if byte < 128 {
                break;
            }
        }
        Ok(value)
    }

    /// `last` moved by a signed number.
    fn moved(&mut self, last: u32) -> Result<u32, String> {
        self.number().map(|v| last.wrapping_add(signed(v)))
    }
}

/// 0, 1, 2, 3 … for 0, −1, 1, −2 …
fn signed(v: u32) -> u32 {
    (v >> 1) ^ (v & 1).wrapping_neg()
}

/// The `count` elements of `byteStride` bytes that a view stands for.
pub(super) fn decode(view: &Compressed, source: &[u8]) -> Result<Vec<u8>, String> {
    let stride = view.byte_stride as usize;
    let count = usize::try_from(view.count).map_err(|_| "a count beyond all bounds")?;
    // The densest of the codecs spends two bits on sixteen bytes.
    if count.saturating_mul(stride) > source.len().saturating_mul(64) {
        return Err(format!("{} packed bytes cannot hold {count} elements", source.len()));
    }
    let mut bytes = match view.mode.as_str() {
        "ATTRIBUTES" if stride > 0 && stride <= 256 && stride.is_multiple_of(4) => {
            attributes(source, count, stride)?
        }
        "TRIANGLES" if matches!(stride, 2 | 4) && count.is_multiple_of(3) => {
            triangles(source, count, stride)?
        }
        "INDICES" if matches!(stride, 2 | 4) => indices(source, count, stride)?,
        mode => {
            let mode = crate::import::report::quote(mode);
            return Err(format!("mode {mode} does not exist or does not suit its count and stride"));
        }
    };
    match (view.filter.as_deref(), stride) {
        (None | Some("NONE"), _) => {}
        (Some("OCTAHEDRAL"), 4) => bytes.chunks_exact_mut(4).for_each(octahedral_bytes),
        (Some("OCTAHEDRAL"), 8) => bytes.chunks_exact_mut(8).for_each(octahedral_words),
        (Some("EXPONENTIAL"), _) if stride.is_multiple_of(4) => {
            bytes.chunks_exact_mut(4).for_each(exponential);
        }
        (Some(filter), _) => {
            return Err(format!("filter {} is not read", crate::import::report::quote(filter)));
        }
    }
    Ok(bytes)
}

/// Vertices in blocks, a byte of all of them at a time, as differences to the one before.
fn attributes(source: &[u8], count: usize, stride: usize) -> Result<Vec<u8>, String> {
    let mut stream = Stream(source);
    if stream.byte()? != 0xa0 {
        return Err("packed attributes of an unknown version".into());
    }
    let tail = stride.max(32);
    let body = stream.0.len().checked_sub(tail).ok_or("packed data that is cut off")?;
    let (body, end) = stream.0.split_at(body);
    let mut last = end[tail - stride..].to_vec();
    let mut stream = Stream(body);
    let mut out = vec![0; count * stride];
    let block = ((8192 / stride) & !15).min(256);
    for vertices in out.chunks_mut(block * stride) {
        let n = vertices.len() / stride;
        for (k, last) in last.iter_mut().enumerate() {
            let groups = n.div_ceil(16);
            let header = stream.take(groups.div_ceil(4))?;
            for group in 0..groups {
                let values = sixteen(&mut stream, header[group / 4] >> (2 * (group % 4)) & 3)?;
                for (i, value) in (16 * group..n).zip(values) {
                    *last = last.wrapping_add((value >> 1) ^ (value & 1).wrapping_neg());
                    vertices[i * stride + k] = *last;
                }
            }
        }
    }
    if stream.0.is_empty() { Ok(out) } else { Err("packed attributes with bytes to spare".into()) }
}

/// Sixteen bytes of 0, 2, 4 or 8 bits; all ones stands for a byte that follows.
fn sixteen(stream: &mut Stream<'_>, mode: u8) -> Result<[u8; 16], String> {
    let mut out = [0; 16];
    let bits = match mode {
        0 => return Ok(out),
        1 => 2,
        2 => 4,
        _ => {
            out.copy_from_slice(stream.take(16)?);
            return Ok(out);
        }
    };
    let packed = stream.take(2 * bits)?;
    let escape = (1u8 << bits) - 1;
    for (k, value) in out.iter_mut().enumerate() {
        let at = k * bits;
        let code = packed[at / 8] >> (8 - bits - at % 8) & escape;
        *value = if code == escape { stream.byte()? } else { code };
    }
    Ok(out)
}

/// The sixteen things seen last.
#[derive(Clone, Copy)]
struct Recent<T> {
    items: [T; 16],
    next: usize,
}

impl<T: Copy> Recent<T> {
    fn new(item: T) -> Recent<T> {
        Recent { items: [item; 16], next: 0 }
    }

    fn push(&mut self, item: T) {
        self.items[self.next] = item;
        self.next = (self.next + 1) & 15;
    }

    /// The one seen `back` before the last.
    fn get(&self, back: u8) -> T {
        self.items[self.next.wrapping_sub(1 + usize::from(back)) & 15]
    }
}

/// Where corners of triangles come from.
struct Corners<'a> {
    stream: Stream<'a>,
    seen: Recent<u32>,
    next: u32,
    last: u32,
}

impl Corners<'_> {
    /// The first vertex that was never met.
    fn fresh(&mut self) -> u32 {
        let new = self.next;
        self.next = new.wrapping_add(1);
        self.seen.push(new);
        new
    }

    /// Any vertex, by its distance from the last that came so.
    fn free(&mut self) -> Result<u32, String> {
        self.last = self.stream.moved(self.last)?;
        self.seen.push(self.last);
        Ok(self.last)
    }
}

/// Triangles that share an edge or corners with those before.
fn triangles(source: &[u8], count: usize, stride: usize) -> Result<Vec<u8>, String> {
    let mut stream = Stream(source);
    // Version 0 has no codes for the neighbours of the last free corner.
    let known = match stream.byte()? {
        0xe0 => 15,
        0xe1 => 13,
        _ => return Err("packed triangles of an unknown version".into()),
    };
    let codes = stream.take(count / 3)?;
    let body = stream.0.len().checked_sub(16).ok_or("packed data that is cut off")?;
    let (body, table) = stream.0.split_at(body);
    let mut from = Corners { stream: Stream(body), seen: Recent::new(0), next: 0, last: 0 };
    let mut edges = Recent::new([0u32; 2]);
    let mut out = Vec::with_capacity(count * stride);
    for &code in codes {
        let [a, b, c] = match code {
            0..0xf0 => {
                let [a, b] = edges.get(code >> 4);
                let c = match code & 15 {
                    0 => from.fresh(),
                    which if which < known => from.seen.get(which),
                    15 => from.free()?,
                    which => {
                        let step = if which == 13 { u32::MAX } else { 1 };
                        from.last = from.last.wrapping_add(step);
                        from.seen.push(from.last);
                        from.last
                    }
                };
                [a, b, c]
            }
            0xf0..0xfe => {
                // What was seen is counted from before this triangle, new corners are seen in their order.
                let (pair, before) = (table[usize::from(code & 15)], from.seen);
                let a = from.fresh();
                let [b, c] = [pair >> 4, pair & 15].map(|which| match which {
                    0 => from.fresh(),
                    which => before.get(which - 1),
                });
                edges.push([b, a]);
                [a, b, c]
            }
            _ => {
                let (pair, before) = (from.stream.byte()?, from.seen);
                if pair == 0 {
                    from.next = 0;
                }
                let a = if code == 0xfe { from.fresh() } else { from.free()? };
                let mut corner = |which| match which {
                    0 => Ok(from.fresh()),
                    15 => from.free(),
                    which => Ok(before.get(which - 1)),
                };
                let (b, c) = (corner(pair >> 4)?, corner(pair & 15)?);
                edges.push([b, a]);
                [a, b, c]
            }
        };
        edges.push([c, b]);
        edges.push([a, c]);
        [a, b, c].into_iter().for_each(|v| write(&mut out, v, stride));
    }
    if from.stream.0.is_empty() { Ok(out) } else { Err("packed triangles with bytes to spare".into()) }
}

/// Indices as differences to one of two before.
fn indices(source: &[u8], count: usize, stride: usize) -> Result<Vec<u8>, String> {
    let mut stream = Stream(source);
    if stream.byte()? & 0xfe != 0xd0 {
        return Err("packed indices of an unknown version".into());
    }
    let mut last = [0u32; 2];
    let mut out = Vec::with_capacity(count.min(source.len()) * stride);
    for _ in 0..count {
        let value = stream.number()?;
        let base = &mut last[(value & 1) as usize];
        *base = base.wrapping_add(signed(value >> 1));
        write(&mut out, *base, stride);
    }
    if stream.0.len() == 4 { Ok(out) } else { Err("packed indices of a wrong length".into()) }
}

fn write(out: &mut Vec<u8>, index: u32, stride: usize) {
    out.extend_from_slice(&index.to_le_bytes()[..stride]);
}

fn octahedral_bytes(v: &mut [u8]) {
    let [x, y, one] = [0, 1, 2].map(|k| f32::from(v[k] as i8));
    for (slot, value) in v.iter_mut().zip(unfolded(x, y, one, 127.0)) {
        *slot = value as i8 as u8;
    }
}

fn octahedral_words(v: &mut [u8]) {
    let [x, y, one] = [0, 2, 4].map(|k| f32::from(i16::from_le_bytes([v[k], v[k + 1]])));
    for (slot, value) in v.chunks_exact_mut(2).zip(unfolded(x, y, one, 32767.0)) {
        slot.copy_from_slice(&(value as i16).to_le_bytes());
    }
}

/// The unit vector, times `most`, that an octahedron unfolded to a square shows at (x, y)/one.
fn unfolded(x: f32, y: f32, one: f32, most: f32) -> [f32; 3] {
    let z = one - x.abs() - y.abs();
    let fold = z.min(0.0);
    let x = x + if x >= 0.0 { fold } else { -fold };
    let y = y + if y >= 0.0 { fold } else { -fold };
    let scale = most / (x * x + y * y + z * z).sqrt();
    [x, y, z].map(|v| (v * scale).round())
}

/// A whole number of 24 bits times two to the power of the upper 8.
fn exponential(v: &mut [u8]) {
    let bits = i32::from_le_bytes([v[0], v[1], v[2], v[3]]);
    let value = libm::ldexpf(((bits << 8) >> 8) as f32, bits >> 24);
    v.copy_from_slice(&value.to_le_bytes());
}

#[cfg(test)]
mod tests {
    use super::*;

    fn view(mode: &str, stride: u32, count: u64, filter: Option<&str>) -> Compressed {
        Compressed {
            byte_stride: stride,
            count,
            mode: mode.into(),
            filter: filter.map(String::from),
            ..Compressed::default()
        }
    }

    /// Packs vertices, each group of sixteen differences in as few bits as hold it.
    fn packed(bytes: &[u8], stride: usize) -> Vec<u8> {
        let mut out = vec![0xa0];
        let mut last = vec![0u8; stride];
        let block = ((8192 / stride) & !15).min(256);
        for vertices in bytes.chunks(block * stride) {
            for (k, last) in last.iter_mut().enumerate() {
                let mut codes: Vec<u8> = Vec::new();
                for vertex in vertices.chunks(stride) {
                    let d = vertex[k].wrapping_sub(*last) as i8;
                    codes.push(((d << 1) ^ (d >> 7)) as u8);
                    *last = vertex[k];
                }
                codes.resize(codes.len().next_multiple_of(16), 0);
                let mode = |group: &[u8]| match group.iter().max() {
                    Some(0) => 0u8,
                    Some(1..=4) => 1,
                    Some(5..=40) => 2,
                    _ => 3,
                };
                let modes: Vec<u8> = codes.chunks(16).map(mode).collect();
                out.extend(modes.chunks(4).map(|m| (0..).zip(m).map(|(i, m)| m << (2 * i)).sum::<u8>()));
                for (group, mode) in codes.chunks(16).zip(modes) {
                    let bits = [0, 2, 4, 8][usize::from(mode)];
                    if bits == 8 {
                        out.extend(group);
                    } else if bits > 0 {
                        let most = (1u8 << bits) - 1;
                        for part in group.chunks(8 / bits) {
                            out.push(part.iter().fold(0, |byte, v| (byte << bits) | (*v).min(most)));
                        }
                        out.extend(group.iter().filter(|v| **v >= most));
                    }
                }
            }
        }
        out.extend(vec![0; stride.max(32)]);
        out
    }

    #[test]
    fn packed_vertices_come_back() {
        for (stride, count) in [(4, 1), (12, 300), (16, 1000), (64, 129), (256, 40)] {
            let wave = |k: usize| ((k / stride) * (k % stride % 5) / 3 + (k * k / 97) % (1 + k % 60)) as u8;
            let bytes: Vec<u8> = (0..stride * count).map(wave).collect();
            let source = packed(&bytes, stride);
            let view = view("ATTRIBUTES", stride as u32, count as u64, None);
            assert_eq!(decode(&view, &source).unwrap(), bytes, "{stride} × {count}");
            for end in 0..source.len() {
                assert!(decode(&view, &source[..end]).is_err());
            }
        }
    }

    #[test]
    fn triangles_share_edges_and_corners() {
        // Three new corners; a neighbour over the edge (1, 2) with a new corner; one over the last edge with the corner
        // seen one before; three free corners at 9, 9 + 2 and 11 − 3.
        let mut source = vec![0xe0, 0xf0, 0x10, 0x01, 0xff, 0xff, 18, 4, 5];
        source.extend([0; 16]);
        let want: Vec<u8> =
            [0u16, 1, 2, 2, 1, 3, 2, 3, 2, 9, 11, 8].iter().flat_map(|i| i.to_le_bytes()).collect();
        assert_eq!(decode(&view("TRIANGLES", 2, 12, None), &source).unwrap(), want);
        for end in 0..source.len() {
            assert!(decode(&view("TRIANGLES", 2, 12, None), &source[..end]).is_err());
        }
    }

    #[test]
    fn sequences_go_on_from_either_of_two() {
        // +5 on the first, +300 on the second, −1 on the first.
        let source = [0xd1, 5 << 2, 0xb1, 0x09, 1 << 1, 0, 0, 0, 0];
        let want: Vec<u8> = [5u32, 300, 4].iter().flat_map(|i| i.to_le_bytes()).collect();
        assert_eq!(decode(&view("INDICES", 4, 3, None), &source).unwrap(), want);
    }

    #[test]
    fn filters_make_unit_vectors_and_numbers() {
        let mut north = [0, 0, 127, 9];
        octahedral_bytes(&mut north);
        assert_eq!(north, [0, 0, 127, 9]);
        let mut south = [127, 127, 127, 9];
        octahedral_bytes(&mut south);
        assert_eq!(south, [0, 0, -127i8 as u8, 9]);
        let mut number = ((-4i32 << 24) | 40).to_le_bytes();
        exponential(&mut number);
        assert_eq!(f32::from_le_bytes(number), 2.5);
    }
}
