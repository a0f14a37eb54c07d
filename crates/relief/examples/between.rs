//! Makes the height map that a coarse sphere lacks to a fine one, displaces the coarse one by it, and writes
//! it to a file that says its metres.

use std::error::Error;

use relief::Watch;
use relief::bake::from_meshes::{MeshPair, heights_from_meshes};
use relief::io::{HeightNote, HeightOptions, read_height, write_exr_rows};
use relief::mesh::{BasePoint, sphere};
use relief::raycast::RayCaster;

fn main() -> Result<(), Box<dyn Error>> {
    let (low, high) = (sphere(16, 8)?, sphere(256, 128)?);
    let pair = MeshPair::new([128, 64]);
    let heights = heights_from_meshes(&low, &RayCaster::new(&high), &pair, &Watch::none())?;
    println!("{} texels, {} holes, {:?} m", heights.covered, heights.holes, heights.range_m);

    // The middle of a triangle is displaced onto the round one.
    let map = heights.to_map(pair.wrap)?;
    let base = BasePoint::weighted(low.corners(100).map(BasePoint::from), [0.25, 0.5, 0.25]);
    let metres = map.displacement_m(map.height_at(base.uv.x, base.uv.y));
    assert!((base.displaced(metres).length() - 0.5).abs() < 1e-3);
    assert!((base.position.length() - 0.5).abs() > 1e-2);

    let [bias_m, top_m] = heights.displacement_m();
    let note = HeightNote { tile_m: low.tile_m(), scale_m: top_m - bias_m, bias_m, of_mesh: true };
    let file = std::env::temp_dir().join("relief-between.exr");
    write_exr_rows(&file, 128, 64, &["height"], &note.metadata(Vec::new())?, &mut |row, texels| {
        texels.copy_from_slice(&map.texels()[row.row as usize * 128..][..128]);
        Ok(())
    })?;
    let read = read_height(&file, &HeightOptions::default())?;
    assert_eq!((read.scale_m(), read.bias_m()), (map.scale_m(), map.bias_m()));
    Ok(())
}
