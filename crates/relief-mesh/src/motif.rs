//! Motifs: closed meshes in the space of one tile, which surfaces repeat: cloth, chain mail, grass.
//!
//! A position is `(u, height, v)`: `u` and `v` from 0 to 1 along the tile, heights from 0 to 1 above
//! the surface, `y` up as in all meshes. Parts that cross the tile's edges reach into the tiles beside
//! it. A thread that runs through the whole tile ends on its edges, with caps that meet the next
//! tile's.
//!
//! Every motif is closed: each edge has two triangles, which run along it in opposite directions. No
//! triangle is degenerate, and all look outward.
//!
//! A vector displacement map becomes a motif, too: [`vector_sheet`] makes an open sheet of it, which joins
//! its images in the tiles beside it.
//!
//! Source: Szirmay-Kalos and Umenhoffer 2008, section 5.2, which puts such meshes on surfaces.

mod grass;
mod mail;
mod tube;
mod vectors;
mod weave;

use std::fmt;
use std::str::FromStr;

use relief_core::mesh::Mesh;
use relief_core::registry::UnknownName;

pub use self::vectors::{VectorSheet, VectorSheetError, vector_sheet};

/// Least and greatest number of sides around a thread or a link.
pub const MOTIF_DETAIL: [u32; 2] = [4, 64];

/// Most threads, links or blades along a tile or in it.
const MOST: [u32; 3] = [256, 128, 20_000];

/// A kind of motif.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum MotifKind {
    /// Cloth in plain weave: threads along `u` and `v` that pass over and under each other.
    Weave,
    /// Chain mail: each link passes through four others, two on either side.
    Mail,
    /// Blades of grass at random places.
    Grass,
}

impl MotifKind {
    /// Every kind.
    pub const ALL: [MotifKind; 3] = [MotifKind::Weave, MotifKind::Mail, MotifKind::Grass];

    /// Returns the name of this kind: `weave`, `mail` or `grass`.
    pub const fn name(self) -> &'static str {
        match self {
            MotifKind::Weave => "weave",
            MotifKind::Mail => "mail",
            MotifKind::Grass => "grass",
        }
    }
}

impl fmt::Display for MotifKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for MotifKind {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        let known = MotifKind::ALL.into_iter().find(|kind| kind.name() == name);
        known.ok_or_else(|| UnknownName::new("motif", name, MotifKind::ALL.map(MotifKind::name)))
    }
}

/// Settings of a motif.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotifSettings {
    /// Kind of motif.
    pub kind: MotifKind,
    /// Threads of cloth along each side of the tile, an even number from 2 to 256; links of mail
    /// along `u`, 1 to 128; blades of grass in the tile, 1 to 20,000.
    pub count: u32,
    /// Thickness of threads, links and blades, above 0 and at most 1. At 1 threads and links nearly
    /// touch their neighbours, and blades are
    /// 7 % of the tile wide at their roots.
    pub thickness: f64,
    /// Sides around a thread or a link, 4 to 64: an even number. A blade has half as many pieces
    /// along its length.
    pub detail: u32,
    /// Seed of the blades' places and shapes.
    pub seed: u64,
}

impl MotifSettings {
    /// Returns the usual settings of a kind.
    pub const fn new(kind: MotifKind) -> Self {
        let (count, thickness, detail) = match kind {
            MotifKind::Weave => (4, 0.9, 12),
            MotifKind::Mail => (3, 0.8, 12),
            MotifKind::Grass => (160, 0.6, 10),
        };
        Self { kind, count, thickness, detail, seed: 1 }
    }

    /// Number of triangles of the motif. At most 32-bit numbers count, for settings that are
    /// accepted.
    pub fn triangles(&self) -> u64 {
        let (count, detail) = (u64::from(self.count), u64::from(self.detail));
        match self.kind {
            MotifKind::Weave => 2 * count * weave::triangles_a_thread(count, detail),
            MotifKind::Mail => count * mail::rows(self.count) * mail::triangles_a_link(detail),
            MotifKind::Grass => count * grass::triangles_a_blade(detail),
        }
    }

    fn check(&self) -> Result<(), MotifError> {
        let bad = |what, value, must: String| Err(MotifError { what, value, must });
        let (most, least, what) = match self.kind {
            MotifKind::Weave => (MOST[0], 2, "the number of threads"),
            MotifKind::Mail => (MOST[1], 1, "the number of links"),
            MotifKind::Grass => (MOST[2], 1, "the number of blades"),
        };
        let is_even = self.kind != MotifKind::Weave || self.count.is_multiple_of(2);
        if !(least..=most).contains(&self.count) || !is_even {
            let even = if self.kind == MotifKind::Weave { "an even number " } else { "" };
            return bad(what, f64::from(self.count), format!("{even}from {least} to {most}"));
        }
        if !(self.thickness > 0.0 && self.thickness <= 1.0) {
            return bad("the thickness", self.thickness, "above 0 and at most 1".to_owned());
        }
        let [fewest, most] = MOTIF_DETAIL;
        if !(fewest..=most).contains(&self.detail) || !self.detail.is_multiple_of(2) {
            let must = format!("an even number from {fewest} to {most}");
            return bad("the detail", f64::from(self.detail), must);
        }
        if self.triangles() > u64::from(u32::MAX / 4) {
            return bad(
                "the number of triangles",
                self.triangles() as f64,
                format!("below {}", u32::MAX / 4),
            );
        }
        Ok(())
    }
}

/// Setting of a motif that is outside its range.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{what} is {value}: it must be {must}")]
pub struct MotifError {
    /// Name of the setting.
    pub what: &'static str,
    /// Value given.
    pub value: f64,
    /// Range of the setting.
    pub must: String,
}

/// Closed mesh in the space of one tile.
#[derive(Clone, Debug, PartialEq)]
pub struct Motif {
    /// The mesh: a vertex for each position, smooth normals. Texture coordinates run along and around
    /// each part, there and back.
    pub mesh: Mesh,
    /// Length of the heights 0 to 1 in tiles at which threads, links and blades have their natural
    /// proportions.
    pub depth: f64,
}

/// Makes a motif. The same settings give the same mesh.
///
/// ```
/// use relief_mesh::motif::{MotifKind, MotifSettings, motif};
///
/// let mail = motif(&MotifSettings::new(MotifKind::Mail))?;
/// assert_eq!(mail.mesh.measures().open_edges, 0);
/// # Ok::<(), relief_mesh::motif::MotifError>(())
/// ```
///
/// # Errors
///
/// When a setting is outside its range.
pub fn motif(settings: &MotifSettings) -> Result<Motif, MotifError> {
    settings.check()?;
    let mut parts = tube::Parts::default();
    let depth = match settings.kind {
        MotifKind::Weave => weave::make(settings, &mut parts),
        MotifKind::Mail => mail::make(settings, &mut parts),
        MotifKind::Grass => grass::make(settings, &mut parts),
    };
    Ok(Motif { mesh: parts.finish(), depth })
}

#[cfg(test)]
mod tests;
