//! Support for floats of 16 bits. The decoder needs its feature `f16` for them, which requires an
//! older `half` than other crates do. Therefore it gets a header that declares integers, whose
//! bytes are the same.

use tiff_reader::header::TiffHeader;
use tiff_reader::ifd::parse_ifd_at;
use tiff_reader::source::BytesSource;
use tiff_reader::{ByteOrder, Ifd, TagValue, TiffError};

const TAG_BITS: u16 = 258;
const TAG_FORMAT: u16 = 339;

const INTEGER: u16 = 1;
const FLOAT: u16 = 3;

/// Bytes in a BigTIFF's header: of the number of entries, of an entry, of the link after them, and
/// of a value that is stored in its entry.
const COUNT: usize = 8;
const ENTRY: usize = 20;
const LINK: usize = 8;
const INLINE: usize = 8;

/// Converts the header of a picture of 16-bit floats to a header of 16-bit integers; none for other
/// samples.
pub(super) fn as_integers(header: &Ifd) -> Result<Option<Ifd>, TiffError> {
    let shorts = |tag: u16| header.tag(tag).and_then(|tag| tag.value.as_u16_slice()).unwrap_or_default();
    let all =
        |tag: u16, wanted: u16| !shorts(tag).is_empty() && shorts(tag).iter().all(|&short| short == wanted);
    if !(all(TAG_BITS, 16) && all(TAG_FORMAT, FLOAT)) {
        return Ok(None);
    }
    let integers = TagValue::Short(vec![INTEGER]);
    let tags: Vec<_> = header
        .tags()
        .iter()
        .map(|tag| (tag.code, if tag.code == TAG_FORMAT { &integers } else { &tag.value }))
        .filter(|(_, value)| !matches!(value, TagValue::Ascii(_)))
        .collect();
    let order = ByteOrder::LittleEndian;
    let mut bytes = (tags.len() as u64).to_le_bytes().to_vec();
    // Longer values follow the entries.
    let after = COUNT + tags.len() * ENTRY + LINK;
    let mut values = Vec::new();
    for (code, value) in tags {
        bytes.extend(code.to_le_bytes());
        bytes.extend(value.tag_type().to_code().to_le_bytes());
        bytes.extend(value.count().to_le_bytes());
        let mut encoded = value.encode(order);
        if encoded.len() <= INLINE {
            encoded.resize(INLINE, 0);
            bytes.extend(encoded);
        } else {
            bytes.extend(((after + values.len()) as u64).to_le_bytes());
            values.extend(encoded);
        }
    }
    bytes.extend([0; LINK]);
    bytes.extend(values);
    let big = TiffHeader { byte_order: order, version: 43, first_ifd_offset: 0 };
    parse_ifd_at(&BytesSource::new(bytes), &big, 0).map(Some)
}
