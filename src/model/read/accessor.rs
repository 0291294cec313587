//! The numbers of a glTF, in buffers that lie in the file: every offset is checked.

use super::damaged;
use super::scene::{Accessor, Scene};
use crate::{Error, Result};

/// How many numbers make an element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Shape {
    Scalar,
    Vec3,
    Vec4,
    Mat4,
}

impl Shape {
    fn name(self) -> &'static str {
        match self {
            Shape::Scalar => "SCALAR",
            Shape::Vec3 => "VEC3",
            Shape::Vec4 => "VEC4",
            Shape::Mat4 => "MAT4",
        }
    }

    fn width(self) -> usize {
        match self {
            Shape::Scalar => 1,
            Shape::Vec3 => 3,
            Shape::Vec4 => 4,
            Shape::Mat4 => 16,
        }
    }
}

/// A scene with its buffers.
pub(super) struct Store<'a> {
    pub(super) name: &'a str,
    pub(super) scene: &'a Scene,
    pub(super) buffers: Vec<&'a [u8]>,
}

/// An accessor whose elements all lie in their data.
pub(super) struct Numbers<'a> {
    pub(super) count: usize,
    component: Component,
    /// None where all are 0 but those put in their place.
    dense: Option<Strided<'a>>,
    /// Places, in rising order, and what is there instead.
    sparse: Option<(usize, Component, Strided<'a>, Strided<'a>)>,
}

/// Elements so many bytes apart.
struct Strided<'a> {
    data: &'a [u8],
    stride: usize,
}

/// A type of number, and whether whole ones stand for shares.
#[derive(Debug, Clone, Copy)]
struct Component {
    kind: u32,
    bytes: usize,
    normalized: bool,
}

impl<'a> Store<'a> {
    /// The numbers of accessor `at`, which must be of that shape.
    ///
    /// # Errors
    /// For one that is not there whole, or is compressed.
    pub(super) fn numbers(&self, at: usize, shape: Shape) -> Result<Numbers<'a>> {
        let missing = || damaged(self.name, format!("accessor {at} is not there whole"));
        let accessor: &Accessor = self.scene.accessors.get(at).ok_or_else(missing)?;
        let component = Component::new(accessor.component_type, accessor.normalized).ok_or_else(missing)?;
        // What has no data of its own can claim any length.
        let held: usize = self.buffers.iter().map(|buffer| buffer.len()).sum();
        if accessor.kind != shape.name() || accessor.count > held {
            return Err(missing());
        }
        let whole = |view: usize, offset: usize, count: usize, width: usize| {
            let strided = self.strided(view, offset, count, width);
            strided.ok_or_else(|| match self.scene.buffer_views.get(view) {
                Some(view) if view.extensions.is_meshopt() => unsupported(self.name, "meshopt compression"),
                _ => missing(),
            })
        };
        let width = component.bytes * shape.width();
        let dense =
            accessor.buffer_view.map(|view| whole(view, accessor.byte_offset, accessor.count, width)).transpose()?;
        let sparse = match &accessor.sparse {
            None => None,
            Some(sparse) => {
                let places = Component::new(sparse.indices.component_type, false).ok_or_else(missing)?;
                let indices =
                    whole(sparse.indices.buffer_view, sparse.indices.byte_offset, sparse.count, places.bytes)?;
                let values = whole(sparse.values.buffer_view, sparse.values.byte_offset, sparse.count, width)?;
                Some((sparse.count, places, indices, values))
            }
        };
        Ok(Numbers { count: accessor.count, component, dense, sparse })
    }

    /// The numbers of an accessor that names things: corners, joints.
    pub(super) fn names(&self, at: usize, shape: Shape) -> Result<Numbers<'a>> {
        let numbers = self.numbers(at, shape)?;
        if !matches!(numbers.component.kind, 5121 | 5123 | 5125) {
            return Err(damaged(self.name, format!("accessor {at} names things by other than whole numbers from 0")));
        }
        Ok(Numbers { component: Component { normalized: false, ..numbers.component }, ..numbers })
    }

    fn strided(&self, view: usize, offset: usize, count: usize, width: usize) -> Option<Strided<'a>> {
        let view = self.scene.buffer_views.get(view)?;
        let buffer: &'a [u8] = self.buffers.get(view.buffer)?;
        let data = buffer.get(view.byte_offset..)?.get(..view.byte_length)?.get(offset..)?;
        let stride = view.byte_stride.unwrap_or(width);
        let end = stride.checked_mul(count.saturating_sub(1))?.checked_add(width)?;
        (stride >= width && (count == 0 || end <= data.len())).then_some(Strided { data, stride })
    }
}

impl Numbers<'_> {
    /// Number `axis` of an element.
    ///
    /// # Panics
    /// If there is no such element.
    pub(super) fn get(&self, element: usize, axis: usize) -> f64 {
        if let Some((count, places, indices, values)) = &self.sparse {
            let place = |at: usize| places.value(indices, at, 0) as usize;
            let (mut low, mut high) = (0, *count);
            while low < high {
                let middle = low.midpoint(high);
                if place(middle) < element { low = middle + 1 } else { high = middle }
            }
            if low < *count && place(low) == element {
                return self.component.value(values, low, axis);
            }
        }
        self.dense.as_ref().map_or(0.0, |dense| self.component.value(dense, element, axis))
    }

    /// All numbers of an element.
    ///
    /// # Panics
    /// As [`Numbers::get`].
    pub(super) fn all<const WIDTH: usize>(&self, element: usize) -> [f64; WIDTH] {
        std::array::from_fn(|axis| self.get(element, axis))
    }
}

impl Component {
    fn new(kind: u32, normalized: bool) -> Option<Component> {
        let bytes = match kind {
            5120 | 5121 => 1,
            5122 | 5123 => 2,
            5125 | 5126 => 4,
            _ => return None,
        };
        Some(Component { kind, bytes, normalized })
    }

    fn value(self, strided: &Strided, element: usize, axis: usize) -> f64 {
        let bytes = &strided.data[element * strided.stride + axis * self.bytes..][..self.bytes];
        let (value, most) = match (self.kind, bytes) {
            (5120, &[a]) => (f64::from(a as i8), 127.0),
            (5121, &[a]) => (f64::from(a), 255.0),
            (5122, &[a, b]) => (f64::from(i16::from_le_bytes([a, b])), 32_767.0),
            (5123, &[a, b]) => (f64::from(u16::from_le_bytes([a, b])), 65_535.0),
            (5125, &[a, b, c, d]) => return f64::from(u32::from_le_bytes([a, b, c, d])),
            (_, &[a, b, c, d]) => return f64::from(f32::from_le_bytes([a, b, c, d])),
            _ => return f64::NAN,
        };
        if self.normalized { (value / most).max(-1.0) } else { value }
    }
}

pub(super) fn unsupported(name: &str, what: &str) -> Error {
    Error::input(name, format!("{what} is not supported"), "save it as a GLB without compression, all data inside")
}
