//! Table of the words that end the names of textures.
//!
//! Sources, in which each scheme was checked:
//!
//! - ambientCG: the files of its archives, such as `Metal014_4K-PNG_NormalGL.png`.
//! - Poly Haven: docs.polyhaven.com, *Technical standards: textures*. `spec`, `bump` and `nor`
//!   without a sign are in older archives.
//! - Substance: the output names of Painter, and *Texture Import* of Sampler (Adobe).
//! - Unreal: the style guide by Michael Allar; `BC`, `ORM`, `AO` and `H` are common beside it.
//! - Unity: the output names of Painter for Unity's pipelines; *Mask and detail maps* of HDRP.
//! - Blender: the words of its add-on Node Wrangler.
//! - Poliigon: *Texture maps explained*, of its help pages.
//! - Bevy: the field `depth_map` of its `StandardMaterial`.

use super::TextureRole;
use super::TextureRole::*;
use crate::GreenSign;

/// Scheme of names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Scheme {
    AmbientCg,
    PolyHaven,
    Substance,
    Unreal,
    Unity,
    Blender,
    Poliigon,
    FreePbr,
    Bevy,
    German,
    Common,
}
use Scheme::*;

/// Place in a name where an ending counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Place {
    /// At the end, or elsewhere if no other ending is in the name.
    Anywhere,
    /// At the end: elsewhere the word describes the material, as in `metallic_paint`.
    End,
    /// At the end, with no number after it, as in `rusty_metal_02`.
    BareEnd,
}

/// Ending of a name, and what it says of the texture.
#[derive(Debug)]
pub struct Row {
    /// Words in lower case without anything between them. Umlauts are written as `ae`, `oe`, `ue`.
    pub ending: &'static str,
    /// Role of the texture.
    pub role: TextureRole,
    /// Direction of green, of a normal map whose name tells it.
    pub green: Option<GreenSign>,
    /// Rank among the endings of this role; the texture with the greatest is taken.
    pub rank: i8,
    place: Place,
    /// Schemes that have this ending. If Unreal's is the only one, the name must begin with `T_`.
    from: &'static [Scheme],
}

const fn row(ending: &'static str, role: TextureRole, from: &'static [Scheme]) -> Row {
    Row { ending, role, green: None, rank: 0, place: Place::Anywhere, from }
}

const fn normals(ending: &'static str, green: GreenSign, from: &'static [Scheme]) -> Row {
    Row { green: Some(green), ..row(ending, Normal, from) }
}

impl Row {
    const fn ranked(self, rank: i8) -> Self {
        Self { rank, ..self }
    }

    const fn at(self, place: Place) -> Self {
        Self { place, ..self }
    }

    /// Whether the ending counts only in names that begin with `T_`.
    fn is_of_unreal(&self) -> bool {
        matches!(self.from, [Unreal])
    }

    /// Whether the ending counts where it is not at the end.
    fn is_free(&self) -> bool {
        self.place == Place::Anywhere && !self.is_of_unreal()
    }
}

/// All endings.
const ROWS: &[Row] = &[
    row("color", Color, &[AmbientCg, Substance, Blender]),
    row("basecolor", Color, &[Substance, Blender, Poliigon]),
    row("colour", Color, &[Substance]),
    row("basecolour", Color, &[Substance]),
    row("col", Color, &[Substance, Blender, Poliigon]),
    row("diff", Color, &[PolyHaven, Substance, Blender]),
    row("diffuse", Color, &[Substance, Blender]),
    row("albedo", Color, &[Unity, Substance, Blender, FreePbr]),
    row("albedotransparency", Color, &[Unity]),
    row("basemap", Color, &[Unity]),
    row("d", Color, &[Unreal]),
    row("bc", Color, &[Unreal]),
    row("farbe", Color, &[German]),
    row("grundfarbe", Color, &[German]),
    row("basisfarbe", Color, &[German]),
    row("displacement", Height, &[AmbientCg, Substance, Blender, Poliigon]),
    row("disp", Height, &[PolyHaven, Substance, Blender, Poliigon]),
    row("disp16", Height, &[Poliigon]).ranked(1),
    row("displace", Height, &[Blender]),
    row("dsp", Height, &[Blender]),
    row("height", Height, &[Substance, Unity, Blender, FreePbr]),
    row("heightmap", Height, &[Substance, Blender]),
    row("heights", Height, &[Common]),
    row("ht", Height, &[Common]),
    row("h", Height, &[Unreal]),
    row("bump", Height, &[PolyHaven, Blender]).ranked(-1),
    row("b", Height, &[Unreal]).ranked(-1),
    row("hoehe", Height, &[German]),
    row("hoehenkarte", Height, &[German]),
    row("verschiebung", Height, &[German]),
    row("depthmap", Depth, &[Bevy]).at(Place::End),
    row("normal", Normal, &[Substance, Unity, Blender, Poliigon]),
    row("normals", Normal, &[Common]),
    row("normalmap", Normal, &[Common]),
    row("nor", Normal, &[PolyHaven, Blender]),
    row("norm", Normal, &[Blender]),
    row("nrm", Normal, &[Substance, Blender, Poliigon]),
    row("nrml", Normal, &[Blender]),
    row("nrm16", Normal, &[Poliigon]).ranked(1),
    normals("normalgl", GreenSign::PlusY, &[AmbientCg]),
    normals("normaldx", GreenSign::MinusY, &[AmbientCg, FreePbr]),
    normals("norgl", GreenSign::PlusY, &[PolyHaven]),
    normals("nordx", GreenSign::MinusY, &[PolyHaven]),
    normals("normalopengl", GreenSign::PlusY, &[Substance]),
    normals("normaldirectx", GreenSign::MinusY, &[Substance]),
    normals("normalogl", GreenSign::PlusY, &[FreePbr]),
    normals("n", GreenSign::MinusY, &[Unreal]),
    row("normale", Normal, &[German]),
    row("normalen", Normal, &[German]),
    row("normalenkarte", Normal, &[German]),
    row("roughness", Roughness, &[AmbientCg, Substance, Blender, Poliigon, FreePbr]),
    row("rough", Roughness, &[PolyHaven, Substance, Blender]).at(Place::BareEnd),
    row("rgh", Roughness, &[Blender]),
    row("r", Roughness, &[Unreal]),
    row("rauheit", Roughness, &[German]),
    row("rauigkeit", Roughness, &[German]),
    row("rauhigkeit", Roughness, &[German]),
    row("gloss", Glossiness, &[Substance, Blender, Poliigon]),
    row("glossiness", Glossiness, &[Substance, Blender]),
    row("glossy", Glossiness, &[Blender]).at(Place::BareEnd),
    row("smoothness", Glossiness, &[Unity]),
    row("glanz", Glossiness, &[German]),
    row("glaette", Glossiness, &[German]),
    row("metalness", Metallic, &[AmbientCg, Substance, Blender, Poliigon]),
    row("metallic", Metallic, &[Substance, Blender, FreePbr]).at(Place::End),
    row("metal", Metallic, &[PolyHaven, Blender]).at(Place::BareEnd),
    row("mtl", Metallic, &[Substance, Blender]),
    row("m", Metallic, &[Unreal]),
    row("metall", Metallic, &[German]).at(Place::BareEnd),
    row("metallisch", Metallic, &[German]).at(Place::End),
    row("ambientocclusion", Occlusion, &[AmbientCg, Substance, Blender, Poliigon]),
    row("occlusion", Occlusion, &[Unity, Substance]),
    row("ao", Occlusion, &[PolyHaven, Unreal, Substance, Blender, Poliigon, FreePbr]),
    row("mixedao", Occlusion, &[Substance]),
    row("o", Occlusion, &[Unreal]),
    row("umgebungsverdeckung", Occlusion, &[German]),
    row("umgebungsokklusion", Occlusion, &[German]),
    row("verdeckung", Occlusion, &[German]),
    row("emission", Emission, &[AmbientCg, PolyHaven, Unity, Blender]),
    row("emissive", Emission, &[Substance, Blender]),
    row("emit", Emission, &[Blender]),
    row("e", Emission, &[Unreal]),
    row("emissiv", Emission, &[German]),
    row("opacity", Opacity, &[AmbientCg, Substance, Blender]),
    row("alpha", Opacity, &[PolyHaven, Substance, Blender]),
    row("a", Opacity, &[Unreal]),
    row("deckkraft", Opacity, &[German]),
    row("specular", Specular, &[Substance, Blender]),
    row("specularlevel", Specular, &[Substance]),
    row("specularity", Specular, &[Blender]),
    row("spec", Specular, &[PolyHaven, Substance, Blender]),
    row("spc", Specular, &[Blender]),
    row("refl", Specular, &[Poliigon]),
    row("reflection", Specular, &[Poliigon]),
    row("specularsmoothness", Specular, &[Unity]),
    row("s", Specular, &[Unreal]),
    row("orm", Orm, &[Unreal, Common]),
    row("occlusionroughnessmetallic", Orm, &[Substance]),
    row("arm", Orm, &[PolyHaven]).at(Place::End),
    row("metallicsmoothness", MetallicSmoothness, &[Unity]),
    row("maskmap", MaskMap, &[Unity]),
];

/// Most words of an ending, as in `Normal_OpenGL`, which has three.
const MOST_WORDS: usize = 4;

/// Ending that was found: its first word, the number of its words, and its row.
pub type Found = (usize, usize, &'static Row);

/// Longest of the `counted` endings that ends `words`.
fn longest(words: &[String], counted: impl Fn(&Row) -> bool) -> Option<Found> {
    (1..=MOST_WORDS.min(words.len())).rev().find_map(|count| {
        let first = words.len() - count;
        let text = words[first..].concat();
        let row = ROWS.iter().find(|row| row.ending == text && counted(row))?;
        Some((first, count, row))
    })
}

/// Finds the longest ending of a name. `is_unreal`: the name begins with `T_`; `is_numbered`: a
/// number follows the last word.
pub fn at_end(words: &[String], is_unreal: bool, is_numbered: bool) -> Option<Found> {
    longest(words, |row| (is_unreal || !row.is_of_unreal()) && !(is_numbered && row.place == Place::BareEnd))
}

/// Whether the words end in an ending that would count anywhere.
pub fn ends_in_role(words: &[String]) -> bool {
    longest(words, Row::is_free).is_some()
}

/// Finds the only ending that is anywhere in a name. None if there are several.
pub fn only_one(words: &[String]) -> Option<Found> {
    let mut found = None;
    let mut end = words.len();
    while end > 0 {
        match longest(&words[..end], Row::is_free) {
            Some(_) if found.is_some() => return None,
            Some(ending) => {
                end = ending.0;
                found = Some(ending);
            }
            None => end -= 1,
        }
    }
    found
}

/// Whether a word, in lower case, names a height map in any scheme but Unreal's.
pub fn is_height_word(word: &str) -> bool {
    ROWS.iter().any(|row| row.role == Height && row.ending == word && !row.is_of_unreal())
}
