//! Reader of materials and colours of a glTF's triangles.

use ::gltf::{Document, Primitive, Semantic};

use super::buffers::Buffers;
use super::material::{BLENDED, Reading, set_of};
use super::{accessor, damaged};
use crate::mesh::builder::Builder;
use crate::{MeshColors, MeshMaterial, MeshOptions, ReadProblem, Remark, omissions};

/// Greatest memory of a triangle's colours: its material, and coordinates and colours of its
/// corners.
const BYTES_PER_TRIANGLE: u64 = 2 * (4 + 24 + 48);

/// Greatest number of notes on materials of one kind.
const MOST_NAMED: usize = 3;

/// Collects the materials and colours of a file's triangles.
pub struct Colors {
    /// Numbers of the file's materials in the order of their use; none for triangles without a
    /// material.
    materials: Vec<Option<usize>>,
    /// Index in `materials` of each of the file's materials; last, the index of no material.
    places: Vec<Option<u32>>,
    of_triangles: Vec<u32>,
    uvs: Vec<[[f32; 2]; 3]>,
    tints: Vec<[[f32; 4]; 3]>,
    /// Whether the file's coordinates are stored even if the mesh's are the same.
    keeps_uvs: bool,
    /// Whether pictures other than of colours are read.
    reads_all: bool,
    /// Whether a material's picture uses coordinates that a primitive lacks.
    without_uvs: bool,
}

/// Material and colours of a primitive's triangles.
pub struct OfPrimitive {
    material: u32,
    /// Texture coordinates of the picture; none if they are the mesh's own.
    uvs: Option<Vec<[f32; 2]>>,
    tints: Option<Vec<[f32; 4]>>,
}

impl OfPrimitive {
    /// Memory of the lists in bytes.
    pub fn bytes(&self) -> u64 {
        let of_uvs = self.uvs.as_ref().map_or(0, |list| size_of_val(&list[..]));
        let of_tints = self.tints.as_ref().map_or(0, |list| size_of_val(&list[..]));
        (of_uvs + of_tints) as u64
    }
}

impl Colors {
    /// Creates an empty collection.
    pub fn new(document: &Document, options: &MeshOptions) -> Self {
        Self {
            materials: Vec::new(),
            places: vec![None; document.materials().len() + 1],
            of_triangles: Vec::new(),
            uvs: Vec::new(),
            tints: Vec::new(),
            keeps_uvs: options.projection.is_some(),
            reads_all: options.materials,
            without_uvs: false,
        }
    }

    /// Reads the material and colours of a primitive with `count` vertices. The memory of its lists
    /// counts against the limit of `builder`.
    pub fn of_primitive(
        &mut self,
        primitive: &Primitive<'_>,
        count: usize,
        buffers: &mut Buffers<'_>,
        builder: &mut Builder,
    ) -> Result<OfPrimitive, ReadProblem> {
        let material = primitive.material();
        let slot = material.index().unwrap_or(self.places.len() - 1);
        let place = self.places.get(slot).copied();
        let place = place.ok_or_else(|| damaged(format!("material {slot} does not exist")))?;
        let place = place.unwrap_or_else(|| {
            let place = self.materials.len() as u32;
            self.materials.push(material.index());
            self.places[slot] = Some(place);
            place
        });
        let set = set_of(&material, self.reads_all)?;
        let uvs = match set.filter(|set| *set != 0 || self.keeps_uvs) {
            None => None,
            Some(set) => match primitive.get(&Semantic::TexCoords(set)) {
                Some(accessor) if accessor.count() == count => {
                    Some(accessor::floats::<2>(&accessor, buffers, builder)?)
                }
                Some(_) => {
                    return Err(damaged(format!("TEXCOORD_{set} and the positions differ in length")));
                }
                None => {
                    self.without_uvs = true;
                    None
                }
            },
        };
        let tints = match primitive.get(&Semantic::Colors(0)) {
            None => None,
            Some(accessor) if accessor.count() != count => {
                return Err(damaged("COLOR_0 and the positions differ in length"));
            }
            Some(accessor) => {
                let is_opaque = accessor.dimensions() == ::gltf::accessor::Dimensions::Vec3;
                let tints = if is_opaque {
                    let three = accessor::floats::<3>(&accessor, buffers, builder)?;
                    builder.take(size_of::<[f32; 4]>() as u64 * three.len() as u64)?;
                    let four = three.iter().map(|&[red, green, blue]| [red, green, blue, 1.0]).collect();
                    builder.give_back(size_of_val(&three[..]) as u64);
                    four
                } else {
                    accessor::floats::<4>(&accessor, buffers, builder)?
                };
                Some(tints)
            }
        };
        if tints.iter().flatten().flatten().any(|part| !part.is_finite()) {
            return Err(damaged("a colour of a vertex is not a finite number"));
        }
        Ok(OfPrimitive { material: place, uvs, tints })
    }

    /// Adds the next triangle of the mesh. `corners` are indices of its vertices in the primitive
    /// `of`. The memory counts against the limit of `builder`.
    pub fn triangle(
        &mut self,
        of: &OfPrimitive,
        corners: [usize; 3],
        builder: &mut Builder,
    ) -> Result<(), ReadProblem> {
        builder.take(BYTES_PER_TRIANGLE)?;
        let before = self.of_triangles.len();
        // NaN stands for the mesh's own coordinates, which are filled in later.
        if of.uvs.is_some() || !self.uvs.is_empty() {
            self.uvs.resize(before, [[f32::NAN; 2]; 3]);
            self.uvs.push(match &of.uvs {
                Some(uvs) => corners.map(|corner| uvs[corner]),
                None => [[f32::NAN; 2]; 3],
            });
        }
        if of.tints.is_some() || !self.tints.is_empty() {
            self.tints.resize(before, [[1.0; 4]; 3]);
            self.tints.push(match &of.tints {
                Some(tints) => corners.map(|corner| tints[corner].map(|part| part.clamp(0.0, 1.0))),
                None => [[1.0; 4]; 3],
            });
        }
        self.of_triangles.push(of.material);
        Ok(())
    }

    /// Returns the colours of all triangles, with their pictures. `None` if no triangle has a
    /// material and no vertex has a colour.
    ///
    /// Call it after [`triangle`](Self::triangle) for every triangle. `document` is the glTF file.
    /// Pictures are read from `buffers`, and their memory counts against the limit of `builder`.
    /// Remarks on everything left out are added to `notes`.
    ///
    /// Factors and colours of vertices are linear. Where a triangle's first texture coordinate is
    /// NaN, the triangle has the mesh's own coordinates: the caller fills them in.
    ///
    /// # Errors
    ///
    /// When a material or a picture is damaged, or the memory exceeds its limit.
    pub fn finish(
        mut self,
        document: &Document,
        buffers: &mut Buffers<'_>,
        builder: &mut Builder,
        notes: &mut Vec<Remark>,
    ) -> Result<Option<MeshColors>, ReadProblem> {
        if self.materials.iter().all(Option::is_none) && self.tints.is_empty() {
            return Ok(None);
        }
        let mut reading = Reading::new(document, self.reads_all, self.keeps_uvs);
        let mut materials = Vec::with_capacity(self.materials.len());
        for number in &self.materials {
            let material = number.and_then(|number| document.materials().nth(number));
            materials.push(match material {
                Some(material) => reading.material(&material, buffers, builder)?,
                None => MeshMaterial::default(),
            });
        }
        if self.without_uvs {
            let what = "a picture needs texture coordinates that the mesh lacks: other ones are used";
            notes.push(Remark::new(&omissions::ABSENT_COORDINATES, what));
        }
        let Reading { left_out, unread, blended, has_others, .. } = reading;
        for what in unread {
            notes.push(Remark::new(&omissions::UNREAD_MATERIAL, what));
        }
        if has_others {
            let what = "its pictures of normals, metal, roughness, occlusion and emission are not read";
            notes.push(Remark::new(&omissions::OTHER_PICTURES, what));
        }
        for why in left_out.iter().take(MOST_NAMED) {
            notes.push(Remark::new(&omissions::UNREAD_PICTURE, why.as_str()));
        }
        if let Some(more) = left_out.len().checked_sub(MOST_NAMED).filter(|more| *more > 0) {
            let what = format!("{more} more of its pictures are left out");
            notes.push(Remark::new(&omissions::UNREAD_PICTURE, what));
        }
        if blended > 0 {
            let which =
                if blended == 1 { "a material is".to_owned() } else { format!("{blended} materials are") };
            let what = "shown where the opacity is at least";
            let what = format!("{which} blended (BLEND): {what} {BLENDED}, and opaque");
            notes.push(Remark::new(&omissions::BLENDED, what));
        }
        if materials.len() == 1 {
            self.of_triangles = Vec::new();
        }
        let Self { of_triangles, uvs, tints, .. } = self;
        Ok(Some(MeshColors { materials, of_triangles, uvs, tints }))
    }
}
