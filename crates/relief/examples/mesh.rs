//! Displaces a torus by a height map, finds no crack in it, and streams it into a file that any viewer opens.

use std::error::Error;

use relief::displace::{MeshSettings, Mesher, Stream, StreamError};
use relief::io::{MeshCounts, MeshFormat, write_mesh};
use relief::{HeightMap, Watch, Wrap, mesh};

fn main() -> Result<(), Box<dyn Error>> {
    let heights = HeightMap::from_fn(128, 64, Wrap::Repeat, |i, j| ((i ^ j) & 8) as f32 / 8.0)?;
    let heights = heights.with_displacement(0.02, 0.0)?;
    let base = mesh::torus(32, 16)?.tiled([3.0, 1.0].into())?;

    // Counted first: so large a mesh could still be refused.
    let mesher = Mesher::new(&base, &heights, &MeshSettings { texels: 2, ..MeshSettings::default() })?;
    let counts = MeshCounts { vertices: mesher.vertices(), triangles: mesher.triangles() };
    println!("{counts:?}, {} bytes", MeshFormat::Gltf.bytes(counts));

    let file = std::env::temp_dir().join("relief-torus.glb");
    let how = Stream { size: 1.0, check: true, grid: None, cache_order: true, watch: Watch::none() };
    let mut streamed = None;
    write_mesh(&file, MeshFormat::Gltf, counts, |sink| {
        let made = mesher.stream(&how, |block| sink(block)).map_err(|error| match error {
            StreamError::Sink(error) => error,
            other => std::io::Error::other(other.to_string()),
        })?;
        streamed = Some(made);
        Ok(())
    })?;
    assert!(streamed.and_then(|made| made.cracks).is_some_and(|cracks| cracks.is_closed()));
    Ok(())
}
