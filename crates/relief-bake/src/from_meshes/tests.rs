use super::*;
use relief_core::Watch;
use relief_core::mesh::{sphere, square};

#[test]
fn layers_have_names() {
    for layer in Layer::ALL {
        assert_eq!(layer.name().parse(), Ok(layer));
    }
    let error = "outer".parse::<Layer>().expect_err("no such layer").to_string();
    assert!(error.contains("outermost"), "{error}");
}

#[test]
fn texels_are_fractions_of_what_they_displace() {
    let (low, high) = (square(1).expect("a mesh"), sphere(24, 12).expect("a mesh"));
    let how = MeshPair { cage_m: Some(1.0), wrap: Wrap::Clamp, ..MeshPair::new([40, 40]) };
    let heights = heights_from_meshes(&low, &RayCaster::new(&high), &how, &Watch::none()).expect("heights");
    // A disc of the square lies under the sphere.
    let part = heights.holes as f64 / heights.covered as f64;
    assert!((0.15..0.3).contains(&part), "{part}");
    let [least, greatest] = heights.range_m;
    assert!(least < 0.15 && (0.48..0.5).contains(&greatest), "{least} {greatest}");
    let map = heights.to_map(Wrap::Clamp).expect("every texel has a value");
    for (texel, metres) in map.texels().iter().zip(&heights.metres) {
        assert!((map.displacement_m(f64::from(*texel)) - f64::from(*metres)).abs() < 1e-7);
    }
    assert_eq!(map.stated_displacement_m(), Some(heights.displacement_m()));
    // Beyond a gutter there is no map.
    let low = low.tiled([0.25, 0.25].into()).expect("a mesh");
    let how = MeshPair { gutter: Some(1), ..how };
    let heights = heights_from_meshes(&low, &RayCaster::new(&high), &how, &Watch::none()).expect("heights");
    assert!(heights.without_value > 1000 && heights.to_map(Wrap::Clamp).is_err());
}
