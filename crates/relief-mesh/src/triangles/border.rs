//! Border of an open base: the sides that belong to one triangle alone.

use std::collections::HashSet;

use relief_core::mesh::Mesh;

use super::edges::{Side, sorted_sides};
use crate::MesherError;

/// Border of a base, and the pieces that have one.
#[derive(Debug)]
pub struct Border {
    /// Triangles of pieces that are not closed. Triangles with two corners at one position are left
    /// out.
    pub patches: Vec<u32>,
    /// Sides without another: the number of the triangle and of its side.
    pub sides: Vec<[u32; 2]>,
}

impl Border {
    /// Finds the border of a mesh, by the positions of its vertices. The border defines an inside
    /// and an outside if no side has more than one other, both run opposite ways, and the border
    /// goes through no position twice. Otherwise this is an error.
    pub fn new(mesh: &Mesh, point_of: &[u32], is_welded: bool) -> Result<Self, MesherError> {
        let all = mesh.triangles();
        let has_extent = |triangle: u32| {
            let [a, b, c] = all[triangle as usize].map(|vertex| point_of[vertex as usize]);
            a != b && b != c && c != a
        };
        let mut sides = sorted_sides(mesh, point_of);
        sides.retain(|side| has_extent(side.number / 3));
        let is_forth = |side: &Side| {
            let [triangle, place] = [side.number / 3, side.number % 3];
            all[triangle as usize][place as usize] == side.ends[0]
        };
        let middle_m = |side: &Side| {
            let [a, b] = side.ends.map(|end| mesh.vertices()[end as usize].position.as_dvec3());
            ((a + b) / 2.0).to_array()
        };
        let (mut border, mut starts) = (Vec::new(), HashSet::new());
        let (mut branching, mut first, mut touching) = (0, None, None);
        // The other triangle at each side.
        let mut beside: Vec<Option<u32>> = vec![None; 3 * all.len()];
        for seam in sides.chunk_by(|a, b| a.points == b.points) {
            match seam {
                [side] => {
                    border.push(side.number);
                    let start = side.points[usize::from(!is_forth(side))];
                    if !starts.insert(start) {
                        let [a, b] = side.ends.map(|end| mesh.vertices()[end as usize].position);
                        touching.get_or_insert(if is_forth(side) { a } else { b });
                    }
                }
                [a, b] if is_forth(a) != is_forth(b) => {
                    if !is_welded && a.ends != b.ends {
                        return Err(MesherError::SolidOfSeams { at_m: middle_m(a) });
                    }
                    beside[a.number as usize] = Some(b.number / 3);
                    beside[b.number as usize] = Some(a.number / 3);
                }
                _ => {
                    branching += 1;
                    first.get_or_insert(middle_m(&seam[0]));
                }
            }
        }
        if let Some(at_m) = first {
            return Err(MesherError::SolidBranches { edges: branching, at_m });
        }
        if let Some(at) = touching {
            return Err(MesherError::SolidTouches { at_m: at.as_dvec3().to_array() });
        }
        if border.is_empty() {
            return Err(MesherError::SolidOfClosed);
        }
        border.sort_unstable();
        let mut is_open = vec![false; all.len()];
        let mut found: Vec<u32> = border.iter().map(|side| side / 3).collect();
        while let Some(triangle) = found.pop() {
            if !std::mem::replace(&mut is_open[triangle as usize], true) {
                let first = 3 * triangle as usize;
                found.extend(beside[first..first + 3].iter().flatten());
            }
        }
        let patches = (0..all.len() as u32).filter(|&triangle| is_open[triangle as usize]).collect();
        Ok(Self { patches, sides: border.into_iter().map(|side| [side / 3, side % 3]).collect() })
    }
}
