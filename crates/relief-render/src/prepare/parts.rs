//! Division of surfaces with several materials into one part for each material.

use std::sync::Arc;

use crate::prepare::Triangles;
use relief_scene::SurfaceColors;

/// Cache of the parts of a scene's surfaces, from one picture to the next.
#[derive(Debug, Default)]
pub struct Parts {
    known: Vec<(Arc<Triangles>, Arc<SurfaceColors>, Vec<Part>)>,
}

/// The triangles of one material.
#[derive(Clone, Debug)]
pub struct Part {
    pub triangles: Arc<Triangles>,
    /// Number of the material.
    pub material: usize,
}

impl Parts {
    /// Returns the triangles of each material of a surface, cached or new. `whole` holds all of its
    /// triangles.
    pub fn of(&mut self, colors: &Arc<SurfaceColors>, whole: &Arc<Triangles>, before: &Self) -> Vec<Part> {
        let is = |(of, with, _): &&(Arc<Triangles>, Arc<SurfaceColors>, _)| {
            Arc::ptr_eq(of, whole) && Arc::ptr_eq(with, colors)
        };
        let known = self.known.iter().chain(&before.known).find(is).map(|(.., parts)| parts.clone());
        let parts = known.unwrap_or_else(|| split(whole, colors));
        self.known.push((Arc::clone(whole), Arc::clone(colors), parts.clone()));
        parts
    }
}

/// Divides triangles by material. Materials without triangles are left out; triangles of a part
/// share corners.
fn split(whole: &Triangles, colors: &SurfaceColors) -> Vec<Part> {
    let mut of_materials = vec![Vec::new(); colors.materials.len()];
    for (triangle, material) in colors.of_triangles.iter().enumerate().take(whole.len()) {
        of_materials[*material as usize].push(triangle);
    }
    let mut places = vec![u32::MAX; whole.corners().len()];
    let part = |(material, numbers): (usize, Vec<usize>)| {
        let (mut corners, mut faces) = (Vec::new(), Vec::with_capacity(numbers.len()));
        let mut used = Vec::new();
        for number in numbers {
            let face = whole.faces()[number];
            let at = [face.corners.x, face.corners.y, face.corners.z].map(|corner| {
                let place = &mut places[corner as usize];
                if *place == u32::MAX {
                    *place = corners.len() as u32;
                    corners.push(whole.corners()[corner as usize]);
                    used.push(corner);
                }
                *place
            });
            faces.push((at, face.shell));
        }
        for corner in used {
            places[corner as usize] = u32::MAX;
        }
        Part { triangles: Arc::new(Triangles::new(corners, faces.into_iter())), material }
    };
    let with_triangles = of_materials.into_iter().enumerate().filter(|(_, numbers)| !numbers.is_empty());
    with_triangles.map(part).collect()
}
