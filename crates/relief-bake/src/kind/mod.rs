//! The map kinds, one file each. A new one is a file here and its name in the list below. A kind's folder
//! holds what belongs to that kind alone; what several kinds share lies beside `kind`.

pub mod bent_normal;
pub mod bounce;
pub mod cone;
pub mod dilation_erosion;
pub mod distance;
pub mod filter_levels;
pub mod frustum;
pub mod horizon;
pub mod normal;
pub mod occlusion;
pub mod pyramid;
pub mod relaxed_cone;
pub mod seen_normal;
pub mod visibility;

use relief_core::Watch;
use relief_core::registry::{Param, Publication, UnknownName};

use crate::{BakeError, BakeInput, Channel, Settings, Shape, Sink, SinkError, quantise};

/// Which texels a baked texel depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reach {
    /// Those at most so many texels away, along either axis.
    Texels(u32),
    /// All of the map.
    Everything,
}

/// A kind of map: what it is, where it comes from, what it promises, and how it is made.
#[derive(Clone, Copy)]
pub struct Kind {
    /// The name on the command line.
    pub name: &'static str,
    /// One line on what it holds.
    pub summary: &'static str,
    /// Raised with every change of the values that are baked, so that maps kept from before are told apart.
    pub revision: u32,
    /// Where it was published.
    pub publication: Publication,
    /// Its parameters; one named `bits` quantises: 0 for floats, 8 or 16. One named `mips` adds mip levels:
    /// 1, or 0 for none.
    pub params: &'static [Param],
    /// What is promised of the stored values, and for which surface.
    pub guarantee: &'static str,
    /// Whether other programs take its texture for a picture: grey, or red, green and blue, over the whole
    /// range of their codes.
    pub is_picture: bool,
    /// The textures that it bakes from a map of so many columns and rows, in their order.
    pub shapes: fn([u32; 2], &Settings) -> Vec<Shape>,
    /// How far a texel's value looks.
    pub reach: fn(&Settings) -> Reach,
    /// What a bake takes at most besides the height map and what it hands out, in maps of 32-bit floats of
    /// the height map's size.
    pub working_maps: fn(&Settings) -> f32,
    /// Bakes it.
    pub bake: fn(&BakeInput, &Settings, &Watch, &mut dyn Sink) -> Result<(), BakeError>,
}

impl Kind {
    /// The defaults of its parameters.
    pub fn defaults(&self) -> Settings {
        Settings::defaults(self.name, self.params)
    }
}

/// All kinds.
pub static KINDS: &[Kind] = &[
    normal::KIND,
    pyramid::KIND,
    dilation_erosion::KIND,
    cone::KIND,
    relaxed_cone::KIND,
    distance::KIND,
    frustum::KIND,
    horizon::KIND,
    occlusion::KIND,
    bent_normal::KIND,
    visibility::KIND,
    bounce::KIND,
    seen_normal::KIND,
    filter_levels::KIND,
];

/// What other programs call the same maps.
const SAME: [(&str, &str); 9] = [
    ("ao", occlusion::KIND.name),
    ("ambient-occlusion", occlusion::KIND.name),
    // Over a level plane both are the mean of cos² of the horizons.
    ("sky-view", occlusion::KIND.name),
    ("sky-view-factor", occlusion::KIND.name),
    ("svf", occlusion::KIND.name),
    ("normals", normal::KIND.name),
    ("bent-normals", bent_normal::KIND.name),
    ("horizons", horizon::KIND.name),
    ("sdf", distance::KIND.name),
];

/// Maps of other programs that no kind is, with the kind that tells most of the same.
const NEAREST: [(&str, &str); 6] = [
    ("curvature", normal::KIND.name),
    ("roughness", normal::KIND.name),
    ("slope", normal::KIND.name),
    ("hillshade", normal::KIND.name),
    ("cavity", occlusion::KIND.name),
    ("openness", horizon::KIND.name),
];

/// The kind of that name, or of the name that other programs give it, as `ao` for `occlusion`.
///
/// # Errors
///
/// When no kind has that name; the error names the nearest.
pub fn kind(name: &str) -> Result<&'static Kind, UnknownName> {
    let other = |names: &[(&str, &'static str)]| {
        names.iter().find(|(other, _)| other.eq_ignore_ascii_case(name)).map(|(_, kind)| *kind)
    };
    let asked = other(&SAME).unwrap_or(name);
    KINDS.iter().find(|kind| kind.name == asked).ok_or_else(|| {
        let unknown = UnknownName::new("map kind", name, KINDS.iter().map(|kind| kind.name));
        let nearest = other(&NEAREST).map(str::to_owned).or(unknown.nearest);
        UnknownName { nearest, ..unknown }
    })
}

/// What most kinds take while they are baked: see [`Kind::working_maps`].
const WORKING_MAPS: f32 = 6.5;

/// The parameter that quantises.
pub const BITS: Param = Param {
    name: crate::settings::BITS,
    summary: "bits of the stored values, rounded to the side that is safe for heights of as many bits: 8 or 16, \
        0 for floats",
    unit: "bits",
    min: 0.0,
    max: 16.0,
    default: 0.0,
    integer: true,
    names: &[],
};

/// The same for kinds whose promise has no side: heights are not quantised first, so that an 8-bit normal
/// map, say, is made from the heights as they are.
pub const BITS_TO_NEAREST: Param =
    Param { summary: "bits of the stored values, rounded to the nearest: 8 or 16, 0 for floats", ..BITS };

/// Hands a slice to the sink, each plane rounded in place to integers of so many bits of its channel's range;
/// with 0 bits as it is.
fn to_nearest(
    sink: &mut dyn Sink,
    channels: &[Channel],
    bits: u32,
    planes: &mut [&mut [f32]],
) -> Result<(), SinkError> {
    for (plane, channel) in planes.iter_mut().zip(channels) {
        quantise::to_nearest(plane, channel.range, bits);
    }
    let planes: Vec<&[f32]> = planes.iter().map(|plane| &**plane).collect();
    sink.slice(&planes)
}
