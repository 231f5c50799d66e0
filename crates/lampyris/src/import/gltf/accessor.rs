//! Accessors: arrays of small vectors somewhere in the buffers, with every bound checked before anything is read.
//! Integers become numbers as `KHR_mesh_quantization` and the attribute say; sparse ones are mended in place.

use super::buffers::Buffers;
use super::json;
use super::json::Shape;
use std::cell::Cell;

/// Elements that accessors without a view may have in all: they are zeros that cost their file nothing.
const ZEROS: u64 = 1 << 20;

/// All accessors of a document.
pub(super) struct Accessors<'a> {
    accessors: &'a [json::Accessor],
    buffers: &'a Buffers<'a>,
    zeros: Cell<u64>,
    /// Sparse elements that may still be read, all readings counted.
    sparse: Cell<u64>,
}

/// The type of a component.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Component {
    I8,
    U8,
    I16,
    U16,
    U32,
    F32,
}

impl Component {
    fn new(code: u32) -> Result<Component, String> {
        Ok(match code {
            5120 => Component::I8,
            5121 => Component::U8,
            5122 => Component::I16,
            5123 => Component::U16,
            5125 => Component::U32,
            5126 => Component::F32,
            _ => return Err(format!("componentType {code} does not exist")),
        })
    }

    fn size(self) -> usize {
        match self {
            Component::I8 | Component::U8 => 1,
            Component::I16 | Component::U16 => 2,
            Component::U32 | Component::F32 => 4,
        }
    }

    /// One component as a number; `normalized` maps the whole range of an integer to [0, 1] or [-1, 1].
    fn number(self, bytes: &[u8], normalized: bool) -> f32 {
        let (value, most) = match (self, bytes) {
            (Component::I8, [a, ..]) => (f32::from(*a as i8), 127.0),
            (Component::U8, [a, ..]) => (f32::from(*a), 255.0),
            (Component::I16, [a, b, ..]) => (f32::from(i16::from_le_bytes([*a, *b])), 32767.0),
            (Component::U16, [a, b, ..]) => (f32::from(u16::from_le_bytes([*a, *b])), 65535.0),
            (Component::U32, [a, b, c, d, ..]) => {
                (u32::from_le_bytes([*a, *b, *c, *d]) as f32, u32::MAX as f32)
            }
            (Component::F32, [a, b, c, d, ..]) => return f32::from_le_bytes([*a, *b, *c, *d]),
            _ => (0.0, 1.0),
        };
        if normalized { (value / most).max(-1.0) } else { value }
    }

    fn index(self, bytes: &[u8]) -> u32 {
        match (self, bytes) {
            (Component::U8, [a, ..]) => u32::from(*a),
            (Component::U16, [a, b, ..]) => u32::from(u16::from_le_bytes([*a, *b])),
            (Component::U32, [a, b, c, d, ..]) => u32::from_le_bytes([*a, *b, *c, *d]),
            _ => u32::MAX,
        }
    }
}

/// Equal elements at equal distances; `bytes` holds all `count` of them.
#[derive(Clone, Copy)]
struct Elements<'a> {
    bytes: &'a [u8],
    stride: usize,
    size: usize,
    count: usize,
}

impl<'a> Elements<'a> {
    /// offset + stride·(count − 1) + size ≤ the view's length, or a reason.
    fn new(
        view: (&'a [u8], Option<usize>),
        offset: u64,
        size: usize,
        count: u64,
    ) -> Result<Elements<'a>, String> {
        let stride = view.1.unwrap_or(size);
        if stride < size {
            return Err(format!("a byteStride of {stride} for elements of {size} bytes"));
        }
        let end = match count.checked_sub(1) {
            Some(last) => u128::from(offset) + stride as u128 * u128::from(last) + size as u128,
            None => u128::from(offset),
        };
        let beyond = || format!("{count} elements need {end} bytes of a view of {}", view.0.len());
        if end > view.0.len() as u128 {
            return Err(beyond());
        }
        let bytes = view.0.get(offset as usize..end as usize).ok_or_else(beyond)?;
        Ok(Elements { bytes, stride, size, count: count as usize })
    }

    fn get(&self, k: usize) -> &'a [u8] {
        let at = k * self.stride;
        self.bytes.get(at..at + self.size).unwrap_or_default()
    }
}

/// An accessor whose bounds hold.
pub(super) struct Accessor<'a> {
    elements: Option<Elements<'a>>,
    component: Component,
    normalized: bool,
    width: usize,
    count: usize,
    sparse: Option<(Component, Elements<'a>, Elements<'a>)>,
}

impl<'a> Accessors<'a> {
    /// Those of a document; at most `sparse` sparse elements will be read.
    pub(super) fn new(document: &'a json::Document, buffers: &'a Buffers<'a>, sparse: u64) -> Accessors<'a> {
        let (zeros, sparse) = (Cell::new(ZEROS), Cell::new(sparse));
        Accessors { accessors: &document.accessors, buffers, zeros, sparse }
    }

    /// Whether an accessor has no data of its own, though it promises some.
    pub(super) fn is_empty_promise(&self, index: u32) -> bool {
        let known = self.accessors.get(index as usize);
        known.is_some_and(|a| a.buffer_view.is_none() && a.sparse.is_none() && a.count > 0)
    }

    /// An accessor of one of the shapes allowed.
    pub(super) fn get(&self, index: u32, shapes: &[Shape]) -> Result<Accessor<'a>, String> {
        let a = self.accessors.get(index as usize).ok_or_else(|| format!("there is no accessor {index}"))?;
        self.checked(a, shapes).map_err(|e| format!("accessor {index}: {e}"))
    }

    fn checked(&self, a: &json::Accessor, shapes: &[Shape]) -> Result<Accessor<'a>, String> {
        let component = Component::new(a.component_type)?;
        if !shapes.contains(&a.shape) {
            return Err("its type does not suit its use".into());
        }
        let width = match a.shape {
            Shape::Scalar | Shape::Other => 1,
            Shape::Vec2 => 2,
            Shape::Vec3 => 3,
            Shape::Vec4 => 4,
        };
        let size = width * component.size();
        let elements = match a.buffer_view {
            Some(view) => Some(Elements::new(self.buffers.view(view)?, a.byte_offset, size, a.count)?),
            None => {
                let left = spend(&self.zeros, a.count);
                left.ok_or_else(|| format!("more than {ZEROS} elements without a bufferView"))?;
                None
            }
        };
        let sparse = a.sparse.as_ref().map(|s| self.sparse(s, size)).transpose()?;
        let (normalized, count) = (a.normalized && component != Component::F32, a.count as usize);
        Ok(Accessor { elements, component, normalized, width, count, sparse })
    }

    fn sparse(
        &self,
        s: &json::Sparse,
        size: usize,
    ) -> Result<(Component, Elements<'a>, Elements<'a>), String> {
        spend(&self.sparse, s.count).ok_or("too many sparse elements in all")?;
        let component = Component::new(s.indices.component_type)?;
        let packed = |view: u32, offset, size| {
            let (bytes, _) = self.buffers.view(view)?;
            Elements::new((bytes, None), offset, size, s.count)
        };
        let places = packed(s.indices.buffer_view, s.indices.byte_offset, component.size())?;
        Ok((component, places, packed(s.values.buffer_view, s.values.byte_offset, size)?))
    }
}

fn spend(purse: &Cell<u64>, amount: u64) -> Option<()> {
    purse.set(purse.get().checked_sub(amount)?);
    Some(())
}

impl Accessor<'_> {
    /// How many elements.
    pub(super) fn count(&self) -> usize {
        self.count
    }

    /// Adds the elements called `only` (ascending), or all, to `out`; missing components are `fill`.
    pub(super) fn read<const N: usize, T>(
        &self,
        only: Option<&[u32]>,
        fill: f32,
        out: &mut Vec<T>,
        make: impl Fn([f32; N]) -> T,
    ) {
        let element = |bytes: &[u8]| {
            let mut v = [fill; N];
            for (value, part) in v.iter_mut().zip(bytes.chunks_exact(self.component.size())) {
                *value = self.component.number(part, self.normalized);
            }
            make(v)
        };
        let base = out.len();
        out.reserve(only.map_or(self.count, <[u32]>::len));
        match (&self.elements, only) {
            (Some(e), None) if self.component == Component::F32 && self.width == N => {
                // The last element may end before a whole stride does.
                let float = |b: &[u8]| Component::F32.number(b, false);
                let straight = |bytes: &[u8]| make(std::array::from_fn(|k| float(&bytes[4 * k..4 * k + 4])));
                let whole = e.bytes.chunks_exact(e.stride);
                let rest = whole.remainder();
                out.extend(whole.map(|bytes| straight(&bytes[..4 * N])));
                out.extend(rest.get(..4 * N).map(straight));
            }
            (Some(e), None) => out.extend((0..e.count).map(|k| element(e.get(k)))),
            (Some(e), Some(only)) => out.extend(only.iter().map(|&k| element(e.get(k as usize)))),
            (None, _) => {
                let zeros = [0; 16];
                let bytes = &zeros[..self.width * self.component.size()];
                out.extend((0..only.map_or(self.count, <[u32]>::len)).map(|_| element(bytes)));
            }
        }
        let Some((component, places, values)) = &self.sparse else { return };
        for k in 0..places.count {
            let place = component.index(places.get(k));
            let at = match only {
                Some(only) => only.binary_search(&place).ok(),
                None => Some(place as usize),
            };
            if let Some(slot) = at.and_then(|at| out.get_mut(base.checked_add(at)?)) {
                *slot = element(values.get(k));
            }
        }
    }

    /// The elements as indices, each through `each`; fails if one reaches beyond `vertices`.
    pub(super) fn indices(&self, vertices: usize) -> Result<Vec<u32>, String> {
        if !matches!(self.component, Component::U8 | Component::U16 | Component::U32) {
            return Err("indices of a type that is none".into());
        }
        let mut out = Vec::with_capacity(self.count);
        match &self.elements {
            Some(e) if self.component == Component::U32 && e.stride == 4 => {
                let word = |b: &[u8]| u32::from_le_bytes([b[0], b[1], b[2], b[3]]);
                out.extend(e.bytes.chunks_exact(4).map(word));
            }
            Some(e) => out.extend((0..e.count).map(|k| self.component.index(e.get(k)))),
            None => out.resize(self.count, 0),
        }
        if let Some((component, places, values)) = &self.sparse {
            for k in 0..places.count {
                if let Some(slot) = out.get_mut(component.index(places.get(k)) as usize) {
                    *slot = self.component.index(values.get(k));
                }
            }
        }
        match out.iter().max() {
            Some(&most) if most as usize >= vertices => {
                Err(format!("index {most} reaches beyond {vertices} vertices"))
            }
            _ => Ok(out),
        }
    }
}
