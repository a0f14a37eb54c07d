//! GDAL's own tags: nodata, and the scale, the offset and the unit of each band.

use half::f16;
use tiff_reader::Ifd;

use crate::elevation::UnitOrigin;
use crate::georeference::{Band, Unit};
use crate::layout::{SampleKind, SampleType};

const TAG_METADATA: u16 = 42112;
const TAG_NODATA: u16 = 42113;

/// Reads the nodata value as the file's samples store it. None for NaN, which never counts as a
/// value.
pub(super) fn nodata(ifd: &Ifd, sample: SampleType) -> Result<Option<f64>, String> {
    let Some(tag) = ifd.tag(TAG_NODATA) else { return Ok(None) };
    let value = match tag.value.as_str() {
        Some(text) => match text.trim_matches(|c: char| c == '\0' || c.is_whitespace()) {
            "" => return Ok(None),
            // Old programs on Windows write it this way.
            text if text.trim_start_matches('-').starts_with("1.#") => f64::NAN,
            text => {
                text.parse().map_err(|_| format!("its nodata value '{}' is not a number", shown(text)))?
            }
        },
        None => tag.value.as_f64_vec().and_then(|values| values.first().copied()).unwrap_or(f64::NAN),
    };
    // GDAL writes the number in decimals, which may differ from the nearest f32.
    let stored = match (sample.kind, sample.bits) {
        (SampleKind::Float, 16) => f16::from_f64(value).to_f64(),
        (SampleKind::Float, 32) => f64::from(value as f32),
        _ => value,
    };
    let possible = stored.is_finite() || sample.kind == SampleKind::Float;
    Ok(Some(stored).filter(|stored| possible && !stored.is_nan()))
}

/// Reads the metadata of each band; none if there are none for any.
pub(super) fn bands(ifd: &Ifd, count: usize) -> Result<Option<Vec<Band>>, String> {
    let Some(xml) = ifd.tag(TAG_METADATA).and_then(|tag| tag.value.as_str()) else { return Ok(None) };
    let mut bands = vec![Band::default(); count];
    for item in Items(xml) {
        let of_band = item.attribute("sample").and_then(|sample| sample.trim().parse::<usize>().ok());
        let Some(band) = of_band.and_then(|band| bands.get_mut(band)) else { continue };
        match item.attribute("role") {
            Some("scale") => {
                band.scale = Some(item.number("scale", |scale| scale.is_finite() && scale > 0.0)?);
            }
            Some("offset") => band.offset = Some(item.number("offset", f64::is_finite)?),
            Some("unittype") => {
                let unit = unescaped(item.text.trim());
                if !unit.is_empty() {
                    band.unit = Unit::named(unit, UnitOrigin::Metadata);
                }
            }
            _ => {}
        }
    }
    Ok(Some(bands).filter(|bands| bands.iter().any(|band| *band != Band::default())))
}

/// Element `Item` of the metadata.
struct Item<'a> {
    attributes: &'a str,
    text: &'a str,
}

impl<'a> Item<'a> {
    fn attribute(&self, wanted: &str) -> Option<&'a str> {
        let mut rest = self.attributes;
        while let Some((name, after)) = rest.split_once('=') {
            let after = after.trim_start();
            let quote = after.chars().next().filter(|quote| matches!(quote, '"' | '\''))?;
            let (value, next) = after[1..].split_once(quote)?;
            if name.trim() == wanted {
                return Some(value);
            }
            rest = next;
        }
        None
    }

    /// Parses the text as a number that must be possible.
    fn number(&self, what: &str, is_possible: impl Fn(f64) -> bool) -> Result<f64, String> {
        let text = self.text.trim();
        let number = text.parse().ok().filter(|number| is_possible(*number));
        number.ok_or_else(|| format!("the {what} of its values is '{}'", shown(text)))
    }
}

/// Iterator over the items of metadata.
struct Items<'a>(&'a str);

impl<'a> Iterator for Items<'a> {
    type Item = Item<'a>;

    fn next(&mut self) -> Option<Item<'a>> {
        let (_, rest) = self.0.split_once("<Item")?;
        let (attributes, rest) = rest.split_once('>')?;
        if let Some(attributes) = attributes.strip_suffix('/') {
            self.0 = rest;
            return Some(Item { attributes, text: "" });
        }
        let (text, rest) = rest.split_once("</Item>")?;
        self.0 = rest;
        Some(Item { attributes, text })
    }
}

fn unescaped(text: &str) -> String {
    let entities = [("&lt;", "<"), ("&gt;", ">"), ("&quot;", "\""), ("&apos;", "'"), ("&amp;", "&")];
    entities.iter().fold(shown(text), |text, (entity, character)| text.replace(entity, character))
}

/// Shortens a text of the file for messages, and removes control characters.
fn shown(text: &str) -> String {
    text.chars().filter(|character| !character.is_control()).take(40).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn items_are_found_with_their_attributes() {
        let xml = "<GDALMetadata>\n <Item name=\"A\"/>\n \
                   <Item name='SCALE' sample = \"0\" role=\"scale\"> 0.5 </Item><Item name=\"x=y\" \
                   role=\"unittype\" sample=\"1\">us-ft &amp; more</Item></GDALMetadata>";
        let found: Vec<_> = Items(xml)
            .map(|item| [item.attribute("role"), item.attribute("sample"), Some(item.text.trim())])
            .collect();
        assert_eq!(
            found,
            [
                [None, None, Some("")],
                [Some("scale"), Some("0"), Some("0.5")],
                [Some("unittype"), Some("1"), Some("us-ft &amp; more")],
            ]
        );
        assert_eq!(unescaped("us-ft &amp;lt; more"), "us-ft &lt; more");
        for broken in ["<Item", "<Item >", "<Item name=>x</Item>", "<Item name=\"a>x</Item>", "<Item é=é>"]
        {
            assert!(Items(broken).all(|item| item.attribute("name").is_none()), "{broken}");
        }
    }
}
