//! The orientation in EXIF metadata (JEITA CP-3451, a TIFF of tags alone).

/// Bytes before the metadata in a JPEG, and in PNG files of some programs.
pub(crate) const HEAD: &[u8] = b"Exif\0\0";

const TAG_ORIENTATION: u16 = 0x112;

/// Bytes in a directory's entry.
const ENTRY: usize = 12;

/// Reads the orientation's number, of any value. None if the metadata have none or are damaged.
pub(crate) fn orientation(bytes: &[u8]) -> Option<u32> {
    let bytes = bytes.strip_prefix(HEAD).unwrap_or(bytes);
    let big_endian = match bytes {
        [b'I', b'I', 42, 0, ..] => false,
        [b'M', b'M', 0, 42, ..] => true,
        _ => return None,
    };
    let short = |at: usize| {
        let bytes = *bytes.get(at..)?.first_chunk()?;
        Some(if big_endian { u16::from_be_bytes(bytes) } else { u16::from_le_bytes(bytes) })
    };
    let long = |at: usize| {
        let bytes = *bytes.get(at..)?.first_chunk()?;
        Some(if big_endian { u32::from_be_bytes(bytes) } else { u32::from_le_bytes(bytes) })
    };
    let directory = long(4)? as usize;
    let entries = (0..usize::from(short(directory)?)).map(|entry| directory + 2 + entry * ENTRY);
    let mut entries = entries.take_while(|&entry| entry + ENTRY <= bytes.len());
    let entry = entries.find(|&entry| short(entry) == Some(TAG_ORIENTATION))?;
    // The standard type is a short; some programs write a byte or a long.
    match short(entry + 2)? {
        1 => bytes.get(entry + 8).map(|&byte| u32::from(byte)),
        3 => short(entry + 8).map(u32::from),
        4 => long(entry + 8),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::orientation;

    /// Metadata of one entry.
    fn exif(big_endian: bool, tag: u16, kind: u16, value: [u8; 4]) -> Vec<u8> {
        let short = |value: u16| if big_endian { value.to_be_bytes() } else { value.to_le_bytes() };
        let long = |value: u32| if big_endian { value.to_be_bytes() } else { value.to_le_bytes() };
        let mut bytes = if big_endian { b"MM\0*".to_vec() } else { b"II*\0".to_vec() };
        bytes.extend(long(8));
        bytes.extend([short(1), short(tag), short(kind)].concat());
        bytes.extend(long(1));
        bytes.extend(value);
        bytes.extend([0; 4]);
        bytes
    }

    #[test]
    fn it_is_found_in_either_byte_order_and_nonsense_is_not() {
        assert_eq!(orientation(&exif(false, 0x112, 3, [6, 0, 0, 0])), Some(6));
        assert_eq!(orientation(&exif(true, 0x112, 3, [0, 8, 0, 0])), Some(8));
        assert_eq!(orientation(&exif(true, 0x112, 4, [0, 0, 0, 3])), Some(3));
        assert_eq!(orientation(&exif(true, 0x112, 1, [5, 0, 0, 0])), Some(5));
        assert_eq!(orientation(&[b"Exif\0\0", &exif(true, 0x112, 3, [1, 0, 0, 0])[..]].concat()), Some(256));
        assert_eq!(orientation(&exif(false, 0x110, 3, [6, 0, 0, 0])), None);
        assert_eq!(orientation(&exif(false, 0x112, 5, [6, 0, 0, 0])), None);
        let whole = exif(false, 0x112, 3, [6, 0, 0, 0]);
        for len in 0..22 {
            assert_eq!(orientation(&whole[..len]), None, "{len}");
        }
        let mut far = whole;
        far[4..8].fill(0xff);
        assert_eq!(orientation(&far), None);
    }
}
