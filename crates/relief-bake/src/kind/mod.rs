//! The kinds of baked map, one file each. A new kind is a file here and its name in [`KINDS`]. A
//! kind's folder holds what belongs to that kind alone. Code that several kinds share lies beside
//! `kind`.

pub mod bent_normal;
pub mod bounce;
pub mod cone;
pub mod dilation_erosion;
pub mod distance;
pub mod filter_levels;
pub mod frustum;
pub mod generalised;
pub mod horizon;
pub mod normal;
pub mod occlusion;
pub mod pyramid;
pub mod relaxed_cone;
pub mod seen_normal;
pub mod view_dependent;
pub mod view_dependent_free;
pub mod visibility;
pub mod volume_distance;

use relief_core::Watch;
use relief_core::registry::{Param, Publication, UnknownName};

use crate::{BakeError, BakeInput, Channel, Settings, Shape, Sink, SinkError, quantise};

/// Texels on which a baked texel depends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reach {
    /// Texels at most this far away along either axis.
    Texels(u32),
    /// The whole map.
    Everything,
}

/// Kind of baked map: its name, parameters, guarantee and bake.
#[derive(Clone, Copy)]
pub struct Kind {
    /// Name on the command line.
    pub name: &'static str,
    /// Content in one line.
    pub summary: &'static str,
    /// Revision of the values, raised with every change of them. Cached maps of other revisions are
    /// not used.
    pub revision: u32,
    /// Source of the method.
    pub publication: Publication,
    /// Parameters. One named `bits` quantises: 0 for floats, 8 or 16. One named `mips` adds mip
    /// levels: 1, or 0 for none.
    pub params: &'static [Param],
    /// Promise about the stored values, and the surface for which it holds.
    pub guarantee: &'static str,
    /// Whether other programs can show its texture as a picture: grey, or red, green and blue, over
    /// the whole range of their codes.
    pub is_picture: bool,
    /// Whether it is baked from a volume, whose slices lie side by side in the map. Else it is baked
    /// from heights.
    pub of_volume: bool,
    /// Returns the shapes of its textures, in order, for a map of the given columns and rows.
    pub shapes: fn([u32; 2], &Settings) -> Vec<Shape>,
    /// Returns the texels on which a baked texel depends.
    pub reach: fn(&Settings) -> Reach,
    /// Returns the most memory that a bake takes besides the height map and its result. The unit is
    /// the memory of the height map as 32-bit floats.
    pub working_maps: fn(&Settings) -> f32,
    /// Bakes a map into a sink.
    pub bake: fn(&BakeInput, &Settings, &Watch, &mut dyn Sink) -> Result<(), BakeError>,
}

impl Kind {
    /// Returns the defaults of its parameters.
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
    view_dependent::KIND,
    view_dependent_free::KIND,
    volume_distance::KIND,
    generalised::KIND,
];

/// Names that other programs give to these kinds.
const SYNONYMS: [(&str, &str); 9] = [
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

/// Maps of other programs without a kind of their own, and the kind that is nearest to each.
const RELATED: [(&str, &str); 6] = [
    ("curvature", normal::KIND.name),
    ("roughness", normal::KIND.name),
    ("slope", normal::KIND.name),
    ("hillshade", normal::KIND.name),
    ("cavity", occlusion::KIND.name),
    ("openness", horizon::KIND.name),
];

/// Returns the kind of that name. Names of other programs count, too, such as `ao` for `occlusion`.
///
/// # Errors
///
/// Fails when no kind has that name; the error names the nearest.
pub fn kind(name: &str) -> Result<&'static Kind, UnknownName> {
    let other = |names: &[(&str, &'static str)]| {
        names.iter().find(|(other, _)| other.eq_ignore_ascii_case(name)).map(|(_, kind)| *kind)
    };
    let asked = other(&SYNONYMS).unwrap_or(name);
    KINDS.iter().find(|kind| kind.name == asked).ok_or_else(|| {
        let unknown = UnknownName::new("map kind", name, KINDS.iter().map(|kind| kind.name));
        let nearest = other(&RELATED).map(str::to_owned).or(unknown.nearest);
        UnknownName { nearest, ..unknown }
    })
}

/// Working memory of most kinds, in maps: see [`Kind::working_maps`].
const WORKING_MAPS: f32 = 6.5;

/// Parameter for the bits of stored values, rounded to the safe side.
pub const BITS: Param = Param {
    name: crate::settings::BITS,
    summary: "bits of the stored values, rounded to the side that is safe for heights of as many bits: 8 or \
        16, 0 for floats",
    unit: "bits",
    min: 0.0,
    max: 16.0,
    default: 0.0,
    integer: true,
    names: &[],
};

/// Parameter for the bits of stored values, rounded to the nearest. Kinds use it whose promise has
/// no side. Their heights are not quantised first: an 8-bit normal map is made from the exact
/// heights.
pub const BITS_TO_NEAREST: Param =
    Param { summary: "bits of the stored values, rounded to the nearest: 8 or 16, 0 for floats", ..BITS };

/// Hands a slice to the sink. Each plane is first rounded in place to integers of `bits` bits over
/// its channel's range. With 0 bits it stays as it is.
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
