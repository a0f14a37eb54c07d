//! Bytes of the values that the GPU shares with the host, little-endian as in WebGPU.

use super::runtime::{Vec2, Vec3, Vec4};

/// A value with a layout in GPU buffers.
pub trait Shared: Sized {
    /// Bytes from one array element to the next.
    const SIZE: usize;

    /// Writes the value to the front of `bytes`, which must hold at least `SIZE` bytes.
    fn write(&self, bytes: &mut [u8]);

    /// Reads a value from the front of `bytes`, which must hold at least `SIZE` bytes.
    fn read(bytes: &[u8]) -> Self;
}

/// Returns the bytes of a slice of values, laid out like an array in a storage buffer.
pub fn write_all<T: Shared>(values: &[T]) -> Vec<u8> {
    let mut bytes = vec![0; values.len() * T::SIZE];
    for (value, place) in values.iter().zip(bytes.chunks_exact_mut(T::SIZE)) {
        value.write(place);
    }
    bytes
}

/// Returns the values of an array in a storage buffer. Bytes after the last whole value are
/// ignored.
pub fn read_all<T: Shared>(bytes: &[u8]) -> Vec<T> {
    bytes.chunks_exact(T::SIZE).map(T::read).collect()
}

macro_rules! scalars {
    ($($scalar:ty),*) => {$(
        impl Shared for $scalar {
            const SIZE: usize = 4;

            fn write(&self, bytes: &mut [u8]) {
                bytes[..4].copy_from_slice(&self.to_le_bytes());
            }

            fn read(bytes: &[u8]) -> Self {
                Self::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]])
            }
        }
    )*};
}

scalars!(f32, i32, u32);

macro_rules! vectors {
    ($($vector:ident $size:literal { $($field:ident),* })*) => {$(
        impl<T: Shared> Shared for $vector<T> {
            const SIZE: usize = $size;

            fn write(&self, bytes: &mut [u8]) {
                let fields = [$(&self.$field),*];
                for (field, place) in fields.into_iter().zip(bytes.chunks_exact_mut(4)) {
                    field.write(place);
                }
            }

            fn read(bytes: &[u8]) -> Self {
                let mut places = bytes.chunks_exact(4);
                let mut next = || T::read(places.next().unwrap_or(&[0; 4]));
                Self { $($field: next()),* }
            }
        }
    )*};
}

vectors! {
    Vec2 8 { x, y }
    Vec3 16 { x, y, z }
    Vec4 16 { x, y, z, w }
}

impl<T: Shared + Copy, const N: usize> Shared for [T; N] {
    const SIZE: usize = N * T::SIZE;

    fn write(&self, bytes: &mut [u8]) {
        for (value, place) in self.iter().zip(bytes.chunks_exact_mut(T::SIZE)) {
            value.write(place);
        }
    }

    fn read(bytes: &[u8]) -> Self {
        std::array::from_fn(|i| T::read(&bytes[i * T::SIZE..]))
    }
}
