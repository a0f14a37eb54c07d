//! Meshes as text.

use relief_core::mesh::Mesh;

/// A mesh as an OBJ file, with all that `f32` holds.
pub fn obj(mesh: &Mesh) -> String {
    let mut text = String::new();
    for vertex in mesh.vertices() {
        let [[x, y, z], [nx, ny, nz]] = [vertex.position, vertex.normal].map(|vector| vector.to_array());
        text += &format!("v {x} {y} {z}\nvn {nx} {ny} {nz}\n");
        text += &format!("vt {} {}\n", vertex.uv.x, 1.0 - f64::from(vertex.uv.y));
    }
    for [a, b, c] in mesh.triangles().iter().map(|corners| corners.map(|index| index + 1)) {
        text += &format!("f {a}/{a}/{a} {b}/{b}/{b} {c}/{c}/{c}\n");
    }
    text
}
