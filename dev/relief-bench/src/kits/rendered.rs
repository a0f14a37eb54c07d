//! What engines draw, drawn by the renderer, and its mesh in words of a page.

use std::sync::Arc;

use relief_core::camera::Camera;
use relief_core::mesh::{Mesh, Vertex};
use relief_core::{HeightMap, Watch};
use relief_io::VertexFrames;
use relief_maps::Maps;
use relief_render::Renderer;
use relief_scene::{Look, Scene, Surface};
use relief_shaders::Selection;
use relief_shaders::cpu::PixelOut;
use serde_json::{Value, json};

/// A pixel's hit, in texture coordinates.
pub type Shown = Vec<Option<[f64; 2]>>;

/// The renderer's hits.
pub fn shown(
    mesh: &Arc<Mesh>,
    heights: &HeightMap,
    selection: &Selection,
    camera: Camera,
    size: [u32; 2],
) -> Result<Shown, String> {
    let hit = |pixel: &PixelOut| (pixel.hit == 1).then(|| [f64::from(pixel.uv.x), f64::from(pixel.uv.y)]);
    Ok(pixels(mesh, heights, selection, camera, size)?.iter().map(hit).collect())
}

/// All that the renderer knows of each pixel.
pub fn pixels(
    mesh: &Arc<Mesh>,
    heights: &HeightMap,
    selection: &Selection,
    camera: Camera,
    [width, height]: [u32; 2],
) -> Result<Vec<PixelOut>, String> {
    let surface = Surface::new(Arc::clone(mesh), heights.clone()).with_selection(*selection);
    let scene = Scene::builder(surface).look(Look::Plain).camera(camera).size(width, height).samples(1);
    let scene = scene.build().map_err(|error| error.to_string())?;
    let rendered = Renderer::on_cpu().render(&scene, &mut Maps::in_memory(), &Watch::none());
    Ok(rendered.map_err(|error| error.to_string())?.rendering.pixels)
}

/// A mesh for a page's script, with frames of its own at its vertices if asked for.
pub fn mesh_json(mesh: &Mesh, frames: bool) -> Value {
    let flat =
        |part: fn(&Vertex) -> Vec<f32>| -> Vec<f32> { mesh.vertices().iter().flat_map(part).collect() };
    json!({
        "positions": flat(|vertex| vertex.position.to_array().to_vec()),
        "normals": flat(|vertex| vertex.normal.to_array().to_vec()),
        "uvs": flat(|vertex| vertex.uv.to_array().to_vec()),
        "triangles": mesh.triangles().as_flattened(),
        "frames": frames.then(|| {
            let VertexFrames { tangents, tiles_m, curvatures } = VertexFrames::of(mesh);
            json!({
                "tangents": tangents.as_flattened(),
                "tiles": tiles_m.as_flattened(),
                "curvatures": curvatures.as_flattened(),
            })
        }),
    })
}
