//! Pose of a file: positions of vertices by morph targets and skins.
//!
//! glTF 2.0, 3.7.2.2 (morph targets) and 3.7.3.3 (skins). Animations are not played.

use ::gltf::{Document, Node, Primitive, Semantic};
use glam::{DMat3, DMat4, DVec3, Mat4};

use super::buffers::Buffers;
use super::{accessor, damaged, nodes};
use crate::ReadProblem;
use crate::mesh::builder::Builder;

/// Bytes of a vertex's matrix while a primitive is transformed.
const MATRIX_BYTES: u64 = size_of::<VertexTransform>() as u64;

/// Transform of positions and normals.
#[derive(Clone, Copy)]
pub struct VertexTransform {
    transform: DMat4,
    of_normals: DMat3,
    /// Whether the transform flips triangles.
    pub is_mirrored: bool,
}

impl VertexTransform {
    pub fn new(transform: DMat4) -> Self {
        let linear = DMat3::from_mat4(transform);
        // The transposed inverse up to a factor, which is finite even if there is no inverse.
        let [x, y, z] = [linear.x_axis, linear.y_axis, linear.z_axis];
        let is_mirrored = linear.determinant() < 0.0;
        let sign = if is_mirrored { -1.0 } else { 1.0 };
        let of_normals = DMat3::from_cols(y.cross(z), z.cross(x), x.cross(y)) * sign;
        Self { transform, of_normals, is_mirrored }
    }

    pub fn position(&self, position: [f32; 3]) -> DVec3 {
        self.transform.transform_point3(DVec3::from(position.map(f64::from)))
    }

    pub fn normal(&self, normal: [f32; 3]) -> DVec3 {
        self.of_normals * DVec3::from(normal.map(f64::from))
    }
}

/// Transforms of a primitive's vertices.
pub enum VertexTransforms {
    /// The node's transform for all vertices.
    Node(VertexTransform),
    /// A transform for each vertex, from its joints.
    Joints(Vec<VertexTransform>),
}

impl VertexTransforms {
    /// Returns the transform of a vertex.
    pub fn of(&self, vertex: usize) -> &VertexTransform {
        match self {
            Self::Node(turned) => turned,
            Self::Joints(each) => &each[vertex],
        }
    }

    /// Memory in bytes.
    pub fn bytes(&self) -> u64 {
        match self {
            Self::Node(_) => 0,
            Self::Joints(each) => MATRIX_BYTES * each.len() as u64,
        }
    }
}

/// Joints of a file's skins, with a count of assumptions.
pub struct Poses {
    /// Transforms of all nodes, computed when first needed.
    transforms: Option<Vec<Option<DMat4>>>,
    /// Number of vertices of skins that no joint moves.
    pub unweighted: u64,
}

impl Poses {
    pub fn new() -> Self {
        Self { transforms: None, unweighted: 0 }
    }

    /// Computes the transforms of the `count` vertices of a primitive, on a node with the given
    /// transform.
    pub fn transforms(
        &mut self,
        document: &Document,
        (node, transform): (&Node<'_>, DMat4),
        (primitive, count): (&Primitive<'_>, usize),
        buffers: &mut Buffers<'_>,
        builder: &mut Builder,
    ) -> Result<VertexTransforms, ReadProblem> {
        let Some(skin) = node.skin() else {
            return Ok(VertexTransforms::Node(VertexTransform::new(transform)));
        };
        let number = skin.index();
        if self.transforms.is_none() {
            self.transforms = Some(nodes::transforms(document)?);
        }
        let transforms = self.transforms.as_deref().unwrap_or_default();
        let mut joints = Vec::new();
        for joint in skin.joints() {
            let place = transforms.get(joint.index()).copied().flatten();
            joints.push(place.ok_or_else(|| damaged(format!("a joint of skin {number} is its own parent")))?);
        }
        if let Some(accessor) = skin.inverse_bind_matrices() {
            let inverse = accessor::floats::<16>(&accessor, buffers, builder)?;
            if inverse.len() < joints.len() {
                let what =
                    format!("skin {number} has {} joints and {} matrices", joints.len(), inverse.len());
                return Err(damaged(what));
            }
            for (joint, inverse) in joints.iter_mut().zip(&inverse) {
                *joint *= Mat4::from_cols_array(inverse).as_dmat4();
            }
            builder.give_back(size_of_val(&inverse[..]) as u64);
        }
        let bytes = MATRIX_BYTES.saturating_mul(count as u64);
        builder.take(bytes)?;
        let mut sums = vec![(DMat4::ZERO, 0.0, 0); count];
        let mut sets = 0;
        for set in 0.. {
            let pair = (primitive.get(&Semantic::Joints(set)), primitive.get(&Semantic::Weights(set)));
            let (of_joints, of_weights) = match pair {
                (Some(joints), Some(weights)) => (joints, weights),
                (None, None) => break,
                _ => return Err(damaged(format!("a skin has only one of joints {set} and weights {set}"))),
            };
            if of_joints.count() != count || of_weights.count() != count {
                return Err(damaged(format!("joints or weights {set} and the positions differ in number")));
            }
            let places = accessor::floats::<4>(&of_joints, buffers, builder)?;
            let weights = accessor::floats::<4>(&of_weights, buffers, builder)?;
            for ((sum, places), weights) in sums.iter_mut().zip(&places).zip(&weights) {
                add_joints(sum, &joints, *places, *weights, number, set == 0)?;
            }
            builder.give_back(2 * size_of_val(&places[..]) as u64);
            sets += 1;
        }
        if sets == 0 {
            return Err(damaged(format!("a primitive of skin {number} has no joints")));
        }
        let mut each = Vec::with_capacity(count);
        for (sum, weight, first) in sums {
            let is_unweighted = weight <= 0.0;
            self.unweighted += u64::from(is_unweighted);
            // Weights should add up to 1; they are normalised here.
            let transform = if is_unweighted { joints[first] } else { sum * (1.0 / weight) };
            each.push(VertexTransform::new(transform));
        }
        Ok(VertexTransforms::Joints(each))
    }
}

/// Adds four joints of a vertex to its sums: the sum of their matrices, the sum of their weights,
/// and the first joint.
fn add_joints(
    (sum, all, first): &mut (DMat4, f64, usize),
    joints: &[DMat4],
    places: [f32; 4],
    weights: [f32; 4],
    skin: usize,
    is_first: bool,
) -> Result<(), ReadProblem> {
    for (at, (place, weight)) in places.into_iter().zip(weights).enumerate() {
        let place = place as usize;
        let joint = joints.get(place).filter(|_| weight.is_finite() && weight >= 0.0);
        let is_unused = weight == 0.0 && !(is_first && at == 0);
        let Some(joint) = joint else {
            if is_unused {
                continue;
            }
            let count = joints.len();
            let what = format!("a vertex of skin {skin} has joint {place} of {count} with weight {weight}");
            return Err(damaged(what));
        };
        if is_first && at == 0 {
            *first = place;
        }
        *sum += *joint * f64::from(weight);
        *all += f64::from(weight);
    }
    Ok(())
}

/// Moves positions and normals by the weighted morph targets of a primitive.
pub fn morph(
    node: &Node<'_>,
    primitive: &Primitive<'_>,
    positions: &mut [[f32; 3]],
    mut normals: Option<&mut [[f32; 3]]>,
    buffers: &mut Buffers<'_>,
    builder: &mut Builder,
) -> Result<(), ReadProblem> {
    let of_mesh = node.mesh().and_then(|mesh| mesh.weights());
    let weights = node.weights().or(of_mesh).unwrap_or_default();
    for (target, weight) in primitive.morph_targets().zip(weights.iter().copied()) {
        if !weight.is_finite() {
            return Err(damaged(format!("a morph target has the weight {weight}")));
        }
        if weight == 0.0 {
            continue;
        }
        let lists = [(target.positions(), Some(&mut *positions)), (target.normals(), normals.as_deref_mut())];
        for (accessor, list) in lists {
            let (Some(accessor), Some(list)) = (accessor, list) else { continue };
            if accessor.count() != list.len() {
                let what =
                    format!("a morph target has {} elements, the positions {}", accessor.count(), list.len());
                return Err(damaged(what));
            }
            let moves = accessor::floats::<3>(&accessor, buffers, builder)?;
            for (vector, by) in list.iter_mut().zip(&moves) {
                *vector = [0, 1, 2].map(|axis| vector[axis] + weight * by[axis]);
            }
            builder.give_back(size_of_val(&moves[..]) as u64);
        }
    }
    Ok(())
}
