//! Known formats of heights that are not supported. They are recognised so that an error can name
//! them.

use std::fmt;
use std::path::Path;

/// Known format of heights that is not supported.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ForeignFormat {
    /// An array of NumPy, `.npy`.
    Npy,
    /// Arrays of NumPy in a ZIP file, `.npz`.
    Npz,
    /// An Arc ASCII grid, `.asc`.
    ArcGrid,
    /// A texture in KTX2: a volume or a baked map.
    Ktx2,
    /// A tile of SRTM, `.hgt`: big-endian signed 16-bit metres without a header.
    Srtm {
        /// Samples along each side: 3601 or 1201.
        side: u32,
    },
}

impl ForeignFormat {
    /// Recognises a format by the file's name, length and first bytes. None if it is unknown.
    pub(crate) fn of(name: &Path, len: u64, start: &[u8]) -> Option<Self> {
        let extension = name.extension().map(|extension| extension.to_string_lossy().to_ascii_lowercase());
        let extension = extension.as_deref().unwrap_or_default();
        let text = start.trim_ascii_start().to_ascii_lowercase();
        let is_grid = |key: &[u8]| {
            text.strip_prefix(key).is_some_and(|rest| rest.starts_with(b" ") || rest.starts_with(b"\t"))
        };
        match start {
            [0x93, b'N', b'U', b'M', b'P', b'Y', ..] => Some(Self::Npy),
            [0xAB, b'K', b'T', b'X', b' ', b'2', ..] => Some(Self::Ktx2),
            [b'P', b'K', 3, 4, ..] if extension == "npz" => Some(Self::Npz),
            _ if is_grid(b"ncols") || is_grid(b"nrows") => Some(Self::ArcGrid),
            _ if extension == "hgt" => [3601, 1201]
                .into_iter()
                .find(|side| 2 * side * side == len)
                .map(|side| Self::Srtm { side: side as u32 }),
            _ => None,
        }
    }
}

impl fmt::Display for ForeignFormat {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Npy => f.write_str(
                "is a NumPy array: write it as a TIFF of 32-bit floats, for instance with \
                 tifffile.imwrite(\"out.tif\", array.astype(\"float32\"))",
            ),
            Self::Npz => f.write_str(
                "is an archive of NumPy arrays: write one as a TIFF of 32-bit floats, for instance with \
                 tifffile.imwrite(\"out.tif\", archive[\"NAME\"].astype(\"float32\"))",
            ),
            Self::ArcGrid => f.write_str(
                "is an Arc ASCII grid: convert it, for instance with gdal_translate -ot Float32 in.asc \
                 out.tif",
            ),
            Self::Ktx2 => f.write_str(
                "is a KTX2 texture, which holds a volume or a baked map, not heights: take the file that it \
                 was made from",
            ),
            Self::Srtm { side } => write!(
                f,
                "is a tile of SRTM, {side}x{side} heights without a header: convert it, for instance with \
                 gdal_translate in.hgt out.tif"
            ),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formats_are_known_by_content_and_tiles_by_their_length() {
        let of = |name: &str, len: u64, start: &[u8]| ForeignFormat::of(Path::new(name), len, start);
        assert_eq!(of("a", 100, b"\x93NUMPY\x01\0v\0{'descr'"), Some(ForeignFormat::Npy));
        assert_eq!(of("a.npz", 100, b"PK\x03\x04"), Some(ForeignFormat::Npz));
        assert_eq!(of("a.zip", 100, b"PK\x03\x04"), None);
        assert_eq!(of("a", 100, b"\xABKTX 20\xBB\r\n\x1A\n"), Some(ForeignFormat::Ktx2));
        for start in [&b"ncols         4\n"[..], b"NCOLS 4", b"\r\nnrows\t3"] {
            assert_eq!(of("a.txt", 100, start), Some(ForeignFormat::ArcGrid));
        }
        assert_eq!(of("a.asc", 100, b"ncolsX 4"), None);
        assert_eq!(of("N46E007.hgt", 25_934_402, &[0; 16]), Some(ForeignFormat::Srtm { side: 3601 }));
        assert_eq!(of("n46e007.HGT", 2_884_802, &[0; 16]), Some(ForeignFormat::Srtm { side: 1201 }));
        assert_eq!(of("a.hgt", 2_884_800, &[0; 16]), None);
        assert_eq!(of("a.dat", 2_884_802, &[0; 16]), None);
    }
}
