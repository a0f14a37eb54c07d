//! Sidecars `.aux.xml` of GDAL, QGIS and ArcGIS: coordinate system, grid, nodata value, and scale,
//! offset and unit of each channel.

use roxmltree::{Document, Node, ParsingOptions};

use super::{Band, Grid, Unit, shown};
use crate::elevation::UnitOrigin;

/// Greatest number of XML nodes that are read: bands have some ten each.
const MAX_NODES: u32 = 1 << 17;

/// Content of an `.aux.xml` file.
#[derive(Debug, Default)]
pub(super) struct Pam {
    /// Coordinate system as text.
    pub system: Option<String>,
    pub grid: Option<Grid>,
    /// One entry for each channel; empty if nothing is stated about any.
    pub bands: Vec<Band>,
    /// Nodata value of the first channel that has one.
    pub nodata: Option<f64>,
}

/// Parses the text of an `.aux.xml` file for a raster of `size` texels and `channels` channels.
pub(super) fn read(text: &str, file: &str, size: [u32; 2], channels: usize) -> Result<Pam, String> {
    let options = ParsingOptions { nodes_limit: MAX_NODES, ..ParsingOptions::default() };
    let document =
        Document::parse_with_options(text, options).map_err(|error| format!("is damaged ({error})"))?;
    let root = document.root_element();
    let mut pam = Pam::default();
    for (attribute, side) in [("rasterXSize", size[0]), ("rasterYSize", size[1])] {
        if let Some(stated) = root.attribute(attribute).filter(|stated| stated.trim().parse() != Ok(side)) {
            let [width, height] = size;
            return Err(format!(
                "belongs to another raster: its {attribute} is {}, but the map has {width}x{height} texels",
                shown(stated)
            ));
        }
    }
    let text_of = |node: Node<'_, '_>| node.text().unwrap_or_default().trim().to_owned();
    for node in root.children().filter(Node::is_element) {
        match node.tag_name().name() {
            "SRS" => pam.system = Some(text_of(node)).filter(|text| !text.is_empty()),
            "GeoTransform" => pam.grid = Some(grid(&text_of(node), size)?),
            "PAMRasterBand" => {
                let number: Option<usize> =
                    node.attribute("band").map_or(Some(1), |band| band.trim().parse().ok());
                let Some(channel) = number.and_then(|number| number.checked_sub(1)) else {
                    return Err(format!(
                        "names the band '{}', which is not a number from 1",
                        shown(node.attribute("band").unwrap_or_default())
                    ));
                };
                if channel >= channels {
                    return Err(format!(
                        "belongs to another raster: it names the band {}, but the map has {channels}",
                        channel + 1
                    ));
                }
                let mut band = Band::default();
                for said in node.children().filter(Node::is_element) {
                    let text = text_of(said);
                    let number = |is_possible: fn(f64) -> bool| {
                        let number = text.parse().ok().filter(|number| is_possible(*number));
                        number.ok_or_else(|| {
                            format!("has an impossible {}, '{}'", said.tag_name().name(), shown(&text))
                        })
                    };
                    match said.tag_name().name() {
                        "NoDataValue" => {
                            let value = number(|_| true)?;
                            pam.nodata = pam.nodata.or(Some(value).filter(|value| !value.is_nan()));
                        }
                        "Scale" => band.scale = Some(number(|scale| scale.is_finite() && scale > 0.0)?),
                        "Offset" => band.offset = Some(number(f64::is_finite)?),
                        "UnitType" if !text.is_empty() => {
                            band.unit = Unit::named(shown(&text), UnitOrigin::Beside(file.to_owned()));
                        }
                        _ => {}
                    }
                }
                if band != Band::default() {
                    pam.bands.resize(channels, Band::default());
                    pam.bands[channel] = band;
                }
            }
            _ => {}
        }
    }
    Ok(pam)
}

/// Parses the six numbers of a grid: `x = a + b column + c row` and `y = d + e column + f row`.
fn grid(text: &str, size: [u32; 2]) -> Result<Grid, String> {
    let numbers: Vec<Option<f64>> = text.split(',').map(|number| number.trim().parse().ok()).collect();
    match numbers[..] {
        [Some(x), Some(a), Some(b), Some(y), Some(d), Some(e)]
            if [x, a, b, y, d, e].iter().all(|number| number.is_finite()) =>
        {
            let grid = Grid::new([[a, d], [b, e]], Some([x, y]), size);
            grid.map_err(|what| format!("has an impossible GeoTransform: {what}"))
        }
        _ => Err(format!("has the GeoTransform '{}', which is not six numbers", shown(text))),
    }
}
