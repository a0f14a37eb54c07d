//! Reader of accessors: numbers in buffers.

use ::gltf::Accessor;
use ::gltf::accessor::sparse::IndexType;
use ::gltf::accessor::{DataType, Dimensions};
use ::gltf::buffer;

use super::buffers::Buffers;
use super::damaged;
use crate::ReadProblem;
use crate::input::zeros;
use crate::mesh::builder::Builder;

/// Elements in a buffer, all within its bounds.
struct Elements<'a> {
    bytes: &'a [u8],
    stride: usize,
    size: usize,
}

impl<'a> Elements<'a> {
    /// Locates `count` elements of `size` bytes, `offset` bytes from the beginning of a view.
    fn new(
        view: &buffer::View<'_>,
        [offset, count, size]: [usize; 3],
        buffers: &'a mut Buffers<'_>,
        builder: &mut Builder,
    ) -> Result<Self, ReadProblem> {
        let stride = view.stride().filter(|&stride| stride > 0).unwrap_or(size);
        let end = count.checked_sub(1).map_or(Some(0), |last| last.checked_mul(stride)?.checked_add(size));
        let bytes = buffers.view(view, builder)?;
        let bytes = bytes.get(offset..).filter(|rest| end.is_some_and(|end| end <= rest.len()));
        let bytes = bytes
            .ok_or_else(|| damaged(format!("{count} elements reach beyond buffer view {}", view.index())))?;
        Ok(Self { bytes, stride, size })
    }

    /// Returns the bytes of an element, which must exist.
    fn at(&self, element: usize) -> &'a [u8] {
        &self.bytes[element * self.stride..][..self.size]
    }
}

/// Reads vectors of `N` numbers. Integers are read as they are or, if normalised, as fractions of
/// their type's maximum.
pub(super) fn floats<const N: usize>(
    accessor: &Accessor<'_>,
    buffers: &mut Buffers<'_>,
    builder: &mut Builder,
) -> Result<Vec<[f32; N]>, ReadProblem>
where
    [f32; N]: Default,
{
    let wanted = match N {
        2 => Dimensions::Vec2,
        3 => Dimensions::Vec3,
        4 => Dimensions::Vec4,
        _ => Dimensions::Mat4,
    };
    // Columns of matrices of short numbers are padded; no known file has them.
    let is_padded = wanted == Dimensions::Mat4 && accessor.data_type() != DataType::F32;
    if accessor.dimensions() != wanted || accessor.data_type() == DataType::U32 || is_padded {
        let what = format!("accessor {} has the wrong type for its use", accessor.index());
        return Err(damaged(what));
    }
    let (kind, normalized) = (accessor.data_type(), accessor.normalized());
    let element_bytes = N * bytes_of(kind);
    let element = |bytes: &[u8]| {
        let mut numbers = [0.0; N];
        for (number, bytes) in numbers.iter_mut().zip(bytes.chunks_exact(bytes_of(kind))) {
            *number = float(kind, normalized, bytes);
        }
        numbers
    };
    let count = accessor.count();
    builder.take((size_of::<[f32; N]>() as u64).saturating_mul(count as u64))?;
    let mut list = Vec::new();
    if let Some(view) = accessor.view() {
        let stored = Elements::new(&view, [accessor.offset(), count, element_bytes], buffers, builder)?;
        list = zeros::<[f32; N]>(count)?;
        for (at, vector) in list.iter_mut().enumerate() {
            *vector = element(stored.at(at));
        }
    }
    // If nothing is stored, all is 0, except for the elements that a sparse accessor replaces.
    if list.is_empty() {
        list = zeros::<[f32; N]>(count)?;
    }
    if let Some(sparse) = accessor.sparse() {
        let (places, values) = (sparse.indices(), sparse.values());
        let index_bytes = match places.index_type() {
            IndexType::U8 => 1,
            IndexType::U16 => 2,
            IndexType::U32 => 4,
        };
        for at in 0..sparse.count() {
            let stored =
                Elements::new(&places.view(), [places.offset(), at + 1, index_bytes], buffers, builder)?;
            let place = whole(stored.at(at));
            let stored =
                Elements::new(&values.view(), [values.offset(), at + 1, element_bytes], buffers, builder)?;
            let vector = element(stored.at(at));
            let slot = list.get_mut(place as usize);
            let beyond =
                || damaged(format!("accessor {} replaces element {place} of {count}", accessor.index()));
            *slot.ok_or_else(beyond)? = vector;
        }
    }
    Ok(list)
}

/// Reads indices of vertices, each below `vertices`.
pub(super) fn indices(
    accessor: &Accessor<'_>,
    vertices: usize,
    buffers: &mut Buffers<'_>,
    builder: &mut Builder,
) -> Result<Vec<u32>, ReadProblem> {
    let kind = accessor.data_type();
    let is_index = matches!(kind, DataType::U8 | DataType::U16 | DataType::U32);
    if accessor.dimensions() != Dimensions::Scalar || !is_index || accessor.sparse().is_some() {
        return Err(damaged(format!("accessor {} holds no indices", accessor.index())));
    }
    let count = accessor.count();
    builder.take((size_of::<u32>() as u64).saturating_mul(count as u64))?;
    let view = accessor.view().ok_or_else(|| damaged(format!("accessor {} is empty", accessor.index())))?;
    let stored = Elements::new(&view, [accessor.offset(), count, bytes_of(kind)], buffers, builder)?;
    let mut list = zeros::<u32>(count)?;
    for (at, index) in list.iter_mut().enumerate() {
        *index = whole(stored.at(at));
        if *index as usize >= vertices {
            return Err(damaged(format!("an index is {index}, but there are {vertices} vertices")));
        }
    }
    Ok(list)
}

const fn bytes_of(kind: DataType) -> usize {
    match kind {
        DataType::I8 | DataType::U8 => 1,
        DataType::I16 | DataType::U16 => 2,
        DataType::U32 | DataType::F32 => 4,
    }
}

/// Decodes an unsigned number of up to four bytes, the lowest first.
fn whole(bytes: &[u8]) -> u32 {
    bytes.iter().rev().fold(0, |number, &byte| number << 8 | u32::from(byte))
}

/// Decodes a number. A normalised integer goes from -1 or 0 to 1.
fn float(kind: DataType, normalized: bool, bytes: &[u8]) -> f32 {
    let bits = whole(bytes);
    let (number, most) = match kind {
        DataType::I8 => (f32::from(bits as u8 as i8), 127.0),
        DataType::U8 => (f32::from(bits as u8), 255.0),
        DataType::I16 => (f32::from(bits as u16 as i16), 32767.0),
        DataType::U16 => (f32::from(bits as u16), 65535.0),
        DataType::U32 => (bits as f32, u32::MAX as f32),
        DataType::F32 => return f32::from_bits(bits),
    };
    if normalized { (number / most).max(-1.0) } else { number }
}
