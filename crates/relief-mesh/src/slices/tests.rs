use std::sync::atomic::AtomicBool;

use relief_core::Wrap;
use relief_core::mesh::{square, torus};

use super::*;

fn map(scale_m: f64, bias_m: f64) -> HeightMap {
    let map = HeightMap::from_fn(8, 8, Wrap::Repeat, |i, _| i as f32 / 7.0).expect("a map");
    map.with_displacement(scale_m, bias_m).expect("lengths")
}

fn blocks(slicer: &Slicer) -> Vec<SliceBlock> {
    let mut blocks = Vec::new();
    slicer.each(&Watch::NOBODY, |block| blocks.push(block.clone())).expect("slices");
    blocks
}

#[test]
fn slices_of_the_surface_lie_at_equal_heights_down_to_the_floor() {
    let (base, map) = (torus(12, 8).expect("a mesh"), map(0.03, -0.01));
    let slicer = Slicer::new(&base, &map, SliceSettings { count: 5 }).expect("slices");
    let blocks = blocks(&slicer);
    let heights: Vec<f32> = blocks.iter().map(|block| block.vertices[0].height).collect();
    assert_eq!(heights, [0.8, 0.6, 0.4, 0.2, 0.0].map(|height: f64| height as f32));
    for block in &blocks {
        for (corner, of_base) in block.vertices.iter().zip(base.vertices()) {
            let out = of_base.normal.dot(corner.vertex.position - of_base.position);
            assert!((out - (0.03 * corner.height - 0.01)).abs() < 1e-7, "{out} {}", corner.height);
        }
        assert_eq!(block.triangles, base.triangles());
    }
    let triangles: usize = blocks.iter().map(|block| block.triangles.len()).sum();
    assert_eq!((triangles as u64, slicer.vertices()), (slicer.triangles(), 5 * base.vertices().len() as u64));
}

#[test]
fn what_cannot_be_sliced_is_refused_and_what_is_cancelled_ends() {
    let base = square(1).expect("a mesh");
    let slicer = |map: &HeightMap, count| Slicer::new(&base, map, SliceSettings { count }).map(|_| ());
    assert_eq!(slicer(&map(0.1, 0.0), 0), Err(SliceError::None));
    let huge = map(0.1, 0.0);
    let many = Slicer::new(&base, &huge, SliceSettings { count: u32::MAX }).expect("a slicer");
    assert_eq!(many.triangles(), 2 * u64::from(u32::MAX));
    let cancel = AtomicBool::new(true);
    let watch = Watch { cancel: &cancel, ..Watch::NOBODY };
    assert_eq!(many.each(&watch, |_| unreachable!("nothing is made")), Err(SliceError::Cancelled));
    let far = map(1e39, 0.0);
    let slicer = Slicer::new(&base, &far, SliceSettings { count: 2 }).expect("a slicer");
    assert_eq!(slicer.each(&Watch::NOBODY, |_| {}), Err(SliceError::NotFinite));
}
