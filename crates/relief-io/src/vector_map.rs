//! Reader of vector displacement maps.

use crate::image_file::ImageFile;
use crate::layout::SampleKind;
use crate::picture::collect;
use crate::{ReadError, ReadProblem, Source};

/// Vector displacement map, row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct VectorMap {
    /// Width in texels.
    pub width: u32,
    /// Height in texels.
    pub height: u32,
    /// The three channels of each texel, finite, in the order of the file: red, green and blue, or
    /// `x`, `y` and `z`. Programs disagree about which is the normal.
    pub vectors: Vec<[f32; 3]>,
    /// Greatest integer of the components, such as 65535; none for floats.
    pub most: Option<u32>,
}

const BYTES_PER_TEXEL: u64 = 12;

/// Reads a vector displacement map from a file or from the bytes of one. It uses the channels red, green
/// and blue, or `x`, `y` and `z`.
///
/// Floats are used unchanged. Unsigned integers `s` of up to 16 bit stand for `2 s / maximum - 1`: the middle
/// is no displacement. At most `max_bytes` of memory are used: 12 bytes a texel.
///
/// ```no_run
/// let map = relief_io::read_vector_map(std::path::Path::new("ear.exr"), 1 << 30)?;
/// println!("{} x {} vectors, the first {:?}", map.width, map.height, map.vectors[0]);
/// # Ok::<(), relief_io::ReadError>(())
/// ```
///
/// # Errors
///
/// When the file cannot be read, is damaged, too large, not a picture, lacks these channels, or holds a NaN
/// or an infinite value.
pub fn read_vector_map<'a>(source: impl Into<Source<'a>>, max_bytes: u64) -> Result<VectorMap, ReadError> {
    let source = source.into();
    read(source, max_bytes).map_err(|problem| source.error(problem))
}

fn read(source: Source<'_>, max_bytes: u64) -> Result<VectorMap, ReadProblem> {
    let file = ImageFile::open(source, None, BYTES_PER_TEXEL, max_bytes)?;
    let layout = file.layout().clone();
    let named = |names: [&str; 3]| match names.map(|name| layout.channel(name)) {
        [Some(x), Some(y), Some(z)] => Some([x, y, z]),
        _ => None,
    };
    let Some(channels) = named(["r", "g", "b"]).or_else(|| named(["x", "y", "z"])) else {
        let what = "vector displacement map";
        return Err(ReadProblem::NoColour { what, channels: layout.channel_names() });
    };
    let sample = layout.channels[channels[0]].sample;
    if layout.full_scale.is_none() && sample.kind != SampleKind::Float {
        return Err(ReadProblem::Unsupported {
            what: format!("vectors of {sample} samples"),
            advice: "export floats, or 8 or 16-bit unsigned integers",
        });
    }
    let decoded = |sample: f64| match layout.full_scale {
        Some(full_scale) => (2.0 * sample / full_scale - 1.0) as f32,
        None => sample as f32,
    };
    let vectors = collect(file, &channels, [0.0; 3], |samples| [0, 1, 2].map(|axis| decoded(samples[axis])))?;
    let is_bad = |vector: &[f32; 3]| vector.iter().any(|part| !part.is_finite());
    if let Some(at) = vectors.iter().position(is_bad) {
        let not_finite = vectors.iter().filter(|vector| is_bad(vector)).count() as u64;
        let width = layout.width as usize;
        let (column, row) = ((at % width) as u32, (at / width) as u32);
        return Err(ReadProblem::NotFinite { not_finite, column, row });
    }
    let most = layout.full_scale.map(|full_scale| full_scale as u32);
    Ok(VectorMap { width: layout.width, height: layout.height, vectors, most })
}
