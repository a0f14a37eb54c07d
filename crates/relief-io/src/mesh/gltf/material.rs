//! Reader of a glTF's materials, with their pictures.

use std::sync::Arc;

use ::gltf::json::Value;
use ::gltf::material::AlphaMode;
use ::gltf::texture::{Info, WrappingMode};
use ::gltf::{Document, Material, Texture};
use relief_core::Wrap;

use super::buffers::Buffers;
use super::damaged;
use super::image::{self, Image};
use crate::mesh::builder::Builder;
use crate::{
    Curve, MaterialTextures, MaterialValues, MeshMaterial, NormalTexture, OcclusionTexture, Picture,
    ReadProblem,
};

/// Cut-off of blended materials, since blending is not supported.
pub const BLENDED: f32 = 0.5;

/// Extensions of materials whose values are read.
const READ: [&str; 4] = [EMISSION, IOR, SPECULAR, TRANSMISSION];
const EMISSION: &str = "KHR_materials_emissive_strength";
const IOR: &str = "KHR_materials_ior";
const SPECULAR: &str = "KHR_materials_specular";
const TRANSMISSION: &str = "KHR_materials_transmission";
const TRANSFORM: &str = "KHR_texture_transform";

/// Pictures of extensions, which are not read, by extension.
const UNREAD: [(&str, &str); 3] = [
    (SPECULAR, "specularTexture"),
    (SPECULAR, "specularColorTexture"),
    (TRANSMISSION, "transmissionTexture"),
];

/// Most notes on parts of materials.
const MOST_UNREAD: usize = 4;

/// Texture as a material uses it.
struct Used<'a> {
    texture: Texture<'a>,
    place: Place,
}

/// Placement of a texture.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Place {
    /// Number of the texture coordinates.
    set: u32,
    transform: [[f32; 3]; 2],
    wrap: [Wrap; 2],
}

impl<'a> Used<'a> {
    fn of(info: &Info<'a>) -> Result<Self, ReadProblem> {
        let moved = info.texture_transform();
        let set = moved.as_ref().and_then(|moved| moved.tex_coord()).unwrap_or(info.tex_coord());
        let transform = match moved {
            Some(given) => transform(given.offset(), given.rotation(), given.scale())?,
            None => MeshMaterial::IDENTITY,
        };
        Ok(Self::new(info.texture(), set, transform))
    }

    /// Returns the use of a texture whose transform is read as JSON.
    fn with_json(texture: Texture<'a>, set: u32, moved: Option<&Value>) -> Result<Self, ReadProblem> {
        let Some(moved) = moved else { return Ok(Self::new(texture, set, MeshMaterial::IDENTITY)) };
        let numbers = |name: &str, default: f32| {
            [0, 1].map(|at| moved[name].get(at).and_then(Value::as_f64).map_or(default, |n| n as f32))
        };
        let turn = moved["rotation"].as_f64().unwrap_or_default() as f32;
        let set = moved["texCoord"].as_u64().map_or(set, |set| u32::try_from(set).unwrap_or(u32::MAX));
        Ok(Self::new(texture, set, transform(numbers("offset", 0.0), turn, numbers("scale", 1.0))?))
    }

    fn new(texture: Texture<'a>, set: u32, transform: [[f32; 3]; 2]) -> Self {
        let sampler = texture.sampler();
        let wrap = [sampler.wrap_s(), sampler.wrap_t()].map(|wrap| match wrap {
            WrappingMode::ClampToEdge => Wrap::Clamp,
            WrappingMode::MirroredRepeat => Wrap::Mirror,
            WrappingMode::Repeat => Wrap::Repeat,
        });
        Self { texture, place: Place { set, transform, wrap } }
    }
}

/// Textures of a material. All but the normals lie alike.
struct AllUsed<'a> {
    color: Option<Used<'a>>,
    metallic_roughness: Option<Used<'a>>,
    occlusion: Option<(Used<'a>, f32)>,
    emission: Option<Used<'a>>,
    normal: Option<(Used<'a>, f32)>,
}

impl<'a> AllUsed<'a> {
    fn of(material: &Material<'a>) -> Result<Self, ReadProblem> {
        let base = material.pbr_metallic_roughness();
        let used = |info: Option<Info<'a>>| info.map(|info| Used::of(&info)).transpose();
        let occlusion = match material.occlusion_texture() {
            Some(of) => {
                let moved = of.extension_value(TRANSFORM);
                Some((Used::with_json(of.texture(), of.tex_coord(), moved)?, part(of.strength(), 1.0)))
            }
            None => None,
        };
        let normal = match material.normal_texture() {
            Some(of) => {
                let moved = of.extension_value(TRANSFORM);
                let scale = Some(of.scale()).filter(|scale| scale.is_finite()).unwrap_or(1.0);
                Some((Used::with_json(of.texture(), of.tex_coord(), moved)?, scale))
            }
            None => None,
        };
        Ok(Self {
            color: used(base.base_color_texture())?,
            metallic_roughness: used(base.metallic_roughness_texture())?,
            occlusion,
            emission: used(material.emissive_texture())?,
            normal,
        })
    }

    /// Placement of the colours, or of the first other picture if there are none.
    fn place(&self, all: bool) -> Option<Place> {
        let of_occlusion = self.occlusion.as_ref().map(|(used, _)| used);
        let others = [self.metallic_roughness.as_ref(), of_occlusion, self.emission.as_ref()];
        let others = others.into_iter().flatten().filter(|_| all);
        self.color.iter().chain(others).next().map(|used| used.place)
    }
}

/// Returns the number of the texture coordinates that a material's pictures use. `all` includes
/// pictures other than of colours.
pub fn set_of(material: &Material<'_>, all: bool) -> Result<Option<u32>, ReadProblem> {
    Ok(AllUsed::of(material)?.place(all).map(|place| place.set))
}

/// Returns a number from 0 to 1, or the default if it is not finite.
fn part(number: f32, default: f32) -> f32 {
    if number.is_finite() { number.clamp(0.0, 1.0) } else { default }
}

/// Whether a material has pictures of roughness, metalness, occlusion or emission.
pub fn has_maps(material: &Material<'_>) -> bool {
    material.pbr_metallic_roughness().metallic_roughness_texture().is_some()
        || material.occlusion_texture().is_some()
        || material.emissive_texture().is_some()
}

/// Reads the values of a material, without its pictures.
pub fn values_of(material: &Material<'_>) -> Result<MaterialValues, ReadProblem> {
    let base = material.pbr_metallic_roughness();
    let number = |extension: &str, name: &str, default: f32, least: f32| {
        let Some(value) = material.extension_value(extension).and_then(|of| of.get(name)) else {
            return Ok(default);
        };
        let number = value.as_f64().map(|number| number as f32);
        number.filter(|number| number.is_finite() && *number >= least).ok_or_else(|| {
            damaged(format!("{extension}.{name} is {value}, which must be a number from {least}"))
        })
    };
    let ior = number(IOR, "ior", 1.5, 0.0)?;
    if ior > 0.0 && ior < 1.0 {
        return Err(damaged(format!("{IOR}.ior is {ior}, which must be 0 or a number from 1")));
    }
    let mut specular_color = [1.0; 3];
    if let Some(given) = material.extension_value(SPECULAR).and_then(|of| of.get("specularColorFactor")) {
        for (at, color) in specular_color.iter_mut().enumerate() {
            let given = given.get(at).and_then(Value::as_f64).map(|number| number as f32);
            let given = given.filter(|number| number.is_finite() && *number >= 0.0);
            *color = given.ok_or_else(|| {
                damaged(format!("{SPECULAR}.specularColorFactor must be three numbers from 0"))
            })?;
        }
    }
    Ok(MaterialValues {
        metallic: part(base.metallic_factor(), 1.0),
        roughness: part(base.roughness_factor(), 1.0),
        emission: material.emissive_factor().map(|light| part(light, 0.0)),
        emission_strength: number(EMISSION, "emissiveStrength", 1.0, 0.0)?,
        ior,
        specular: number(SPECULAR, "specularFactor", 1.0, 0.0)?.min(1.0),
        specular_color,
        transmission: number(TRANSMISSION, "transmissionFactor", 0.0, 0.0)?.min(1.0),
        textures: MaterialTextures::default(),
    })
}

/// Pictures and materials while they are read.
pub struct Reading<'a> {
    document: &'a Document,
    /// Whether pictures other than of colours are read.
    reads_all: bool,
    /// Whether the mesh's own texture coordinates will be replaced.
    replaces_uvs: bool,
    /// Images that were read, with their numbers and curves.
    images: Vec<(usize, Curve, Arc<Picture>)>,
    /// Reasons why pictures were left out, each once.
    pub left_out: Vec<String>,
    /// Parts of materials that are not read, each once.
    pub unread: Vec<String>,
    /// Number of blended materials.
    pub blended: u64,
    /// Whether a material has pictures other than its colours, which are not read.
    pub has_others: bool,
}

impl<'a> Reading<'a> {
    /// Creates a reader. `reads_all` includes pictures other than of colours; `replaces_uvs` is set if
    /// the mesh's texture coordinates will be replaced.
    pub fn new(document: &'a Document, reads_all: bool, replaces_uvs: bool) -> Self {
        Self {
            document,
            reads_all,
            replaces_uvs,
            images: Vec::new(),
            left_out: Vec::new(),
            unread: Vec::new(),
            blended: 0,
            has_others: false,
        }
    }

    /// Reads a material and its pictures.
    pub fn material(
        &mut self,
        material: &Material<'_>,
        buffers: &mut Buffers<'_>,
        builder: &mut Builder,
    ) -> Result<MeshMaterial, ReadProblem> {
        let base = material.pbr_metallic_roughness();
        let factor = base.base_color_factor().map(|factor| part(factor, 1.0));
        let cutoff = match material.alpha_mode() {
            AlphaMode::Opaque => None,
            AlphaMode::Mask => {
                let cutoff = material.alpha_cutoff().unwrap_or(0.5);
                if !(cutoff >= 0.0 && cutoff.is_finite()) {
                    return Err(damaged(format!("an alphaCutoff is {cutoff}, not a number from 0")));
                }
                Some(cutoff)
            }
            AlphaMode::Blend => {
                self.blended += 1;
                Some(BLENDED)
            }
        };
        self.note_extensions(material);
        let used = AllUsed::of(material)?;
        let place = used.place(self.reads_all);
        let picture =
            self.placed(used.color.as_ref(), place, ("colours", Curve::Srgb), (buffers, builder))?;
        let mut values = values_of(material)?;
        if self.reads_all {
            let linear = |what| (what, Curve::Linear);
            let rough = linear("roughness and metalness");
            values.textures.metallic_roughness =
                self.placed(used.metallic_roughness.as_ref(), place, rough, (buffers, builder))?;
            if let Some((used, strength)) = &used.occlusion {
                let picture = self.placed(Some(used), place, linear("occlusion"), (buffers, builder))?;
                values.textures.occlusion =
                    picture.map(|picture| OcclusionTexture { picture, strength: *strength });
            }
            values.textures.emission =
                self.placed(used.emission.as_ref(), place, ("emission", Curve::Srgb), (buffers, builder))?;
            if let Some((used, scale)) = &used.normal {
                let Place { set, transform, wrap } = used.place;
                if set != 0 || transform != MeshMaterial::IDENTITY || self.replaces_uvs {
                    let why = "it does not lie by the mesh's own texture coordinates";
                    self.note_unread(format!("the picture of its normals is left out: {why}"));
                } else {
                    let picture = self.texture(&used.texture, linear("normals"), buffers, builder)?;
                    values.textures.normal =
                        picture.map(|picture| NormalTexture { picture, scale: *scale, wrap });
                }
            }
        } else {
            self.has_others |= has_maps(material) || used.normal.is_some();
        }
        let Place { transform, wrap, .. } = place
            .filter(|_| picture.is_some() || values.textures.has_maps())
            .unwrap_or(Place { set: 0, transform: MeshMaterial::IDENTITY, wrap: [Wrap::Repeat; 2] });
        let name = material.name().map(Arc::from);
        Ok(MeshMaterial { name, factor, cutoff, picture, wrap, transform, values })
    }

    /// Reads the picture of a texture that lies at `place`. `None`, with a note, if it lies elsewhere.
    fn placed(
        &mut self,
        used: Option<&Used<'_>>,
        place: Option<Place>,
        (what, curve): (&str, Curve),
        (buffers, builder): (&mut Buffers<'_>, &mut Builder),
    ) -> Result<Option<Arc<Picture>>, ReadProblem> {
        let Some(used) = used else { return Ok(None) };
        if Some(used.place) == place {
            return self.texture(&used.texture, (what, curve), buffers, builder);
        }
        let why = "it lies otherwise than the other pictures of its material";
        self.note_unread(format!("the picture of its {what} is left out: {why}"));
        Ok(None)
    }

    /// Notes extensions of a material that are not read, and pictures of those that are.
    fn note_extensions(&mut self, material: &Material<'_>) {
        let extensions = material.extensions().into_iter().flat_map(|all| all.keys());
        let unread: Vec<&String> = extensions.filter(|name| !READ.contains(&name.as_str())).collect();
        for name in unread {
            let name: String = name.chars().take(60).collect();
            self.note_unread(format!("its extension {name} is not read"));
        }
        for (extension, name) in UNREAD {
            if material.extension_value(extension).is_some_and(|of| of.get(name).is_some()) {
                self.note_unread(format!("the {name} of {extension} is not read, only its factor"));
            }
        }
    }

    /// Adds a note on a part of a material.
    fn note_unread(&mut self, what: String) {
        if self.unread.len() < MOST_UNREAD && !self.unread.contains(&what) {
            self.unread.push(what);
        }
    }

    /// Reads the picture of a texture. `None`, with a note, if its format is not supported.
    fn texture(
        &mut self,
        texture: &Texture<'_>,
        (what, curve): (&str, Curve),
        buffers: &mut Buffers<'_>,
        builder: &mut Builder,
    ) -> Result<Option<Arc<Picture>>, ReadProblem> {
        let why = match Image::of(texture) {
            Image::Read(number) => return self.picture((number, curve), buffers, builder).map(Some),
            Image::LeftOut(format) => {
                format!("{format} is not read (`gltf-transform ktxdecompress` converts Basis to PNG)")
            }
            Image::None => "its texture names no image".to_owned(),
        };
        let why = format!("the picture of its {what} is left out: {why}");
        if !self.left_out.contains(&why) {
            self.left_out.push(why);
        }
        Ok(None)
    }

    /// Returns an image, which is read only once by each curve.
    fn picture(
        &mut self,
        (number, curve): (usize, Curve),
        buffers: &mut Buffers<'_>,
        builder: &mut Builder,
    ) -> Result<Arc<Picture>, ReadProblem> {
        let is = |(known, with, _): &&(usize, Curve, _)| (*known, *with) == (number, curve);
        if let Some((.., known)) = self.images.iter().find(is) {
            return Ok(Arc::clone(known));
        }
        let picture = Arc::new(image::read(self.document, (number, curve), buffers, builder)?);
        self.images.push((number, curve, Arc::clone(&picture)));
        Ok(picture)
    }
}

/// Builds the rows of a texture transform: scaled, then turned counter-clockwise as `v` runs down,
/// then moved (KHR_texture_transform).
fn transform([x, y]: [f32; 2], turn: f32, scale: [f32; 2]) -> Result<[[f32; 3]; 2], ReadProblem> {
    let (sin, cos) = f64::from(turn).sin_cos();
    let [along_u, along_v] = scale.map(f64::from);
    let rows = [
        [(cos * along_u) as f32, (sin * along_v) as f32, x],
        [(-sin * along_u) as f32, (cos * along_v) as f32, y],
    ];
    if rows.iter().flatten().all(|number| number.is_finite()) {
        return Ok(rows);
    }
    Err(damaged("the transform of a texture has numbers that are not finite"))
}
