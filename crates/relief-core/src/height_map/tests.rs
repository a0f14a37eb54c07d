use super::*;

fn ramp(wrap: Wrap) -> HeightMap {
    HeightMap::from_fn(4, 2, wrap, |i, j| (i as f32 + 4.0 * j as f32) / 8.0).expect("a valid map")
}

#[test]
fn reconstruction_is_bilinear_between_texel_centres() {
    let map = ramp(Wrap::Clamp);
    assert_eq!(map.height_at(0.5 / 4.0, 0.5 / 2.0), 0.0);
    assert_eq!(map.height_at(1.0 / 4.0, 0.5 / 2.0), 0.0625);
    assert_eq!(map.height_at(0.5 / 4.0, 1.0 / 2.0), 0.25);
    // Beyond the outermost centres a clamped map is constant.
    assert_eq!(map.height_at(-3.0, 0.25), 0.0);
    // A repeated map interpolates between the last and the first column there: (0.375 + 0) / 2.
    assert_eq!(ramp(Wrap::Repeat).height_at(0.0, 0.25), 0.1875);
    assert_eq!(ramp(Wrap::Mirror).height_at(0.0, 0.25), 0.0);
}

#[test]
fn slopes_are_those_of_the_surface_and_the_mean_of_both_sides_on_its_creases() {
    for wrap in Wrap::ALL {
        let map = HeightMap::from_fn(5, 3, wrap, |i, j| ((7 * i + 3 * j) % 11) as f32 / 11.0);
        let map = map.expect("a valid map");
        for step in 0..300 {
            // Every third place lies on a line between cells.
            let x = if step % 3 == 0 { f64::from(step / 3 - 50) } else { f64::from(step) * 0.0437 - 4.0 };
            let y = 5.3 - f64::from(step) * 0.0371;
            // Beside a line but not on it differences do not see the crease.
            if [x, y].iter().any(|at| (1e-9..1.0 / 2048.0).contains(&(at - at.round()).abs())) {
                continue;
            }
            // At the edge of a clamped map the slope is taken inside, see below.
            let is_out = |at: f64, last: f64| at < 1e-3 || at > last - 1e-3;
            if wrap == Wrap::Clamp && (is_out(x, 4.0) || is_out(y, 2.0)) {
                continue;
            }
            let small = 1e-5;
            let [ahead, behind] = [small, -small].map(|by| map.height_at_place(x + by, y));
            let [below, above] = [small, -small].map(|by| map.height_at_place(x, y + by));
            let slope = map.slope_at_place(x, y);
            let found = [(ahead - behind) / (2.0 * small), (below - above) / (2.0 * small)];
            assert!((0..2).all(|axis| (slope[axis] - found[axis]).abs() < 1e-9), "{wrap} {x} {y}");
        }
    }
}

#[test]
fn an_even_slope_is_even_up_to_the_edge_of_a_clamped_map() {
    let map = ramp(Wrap::Clamp);
    for step in 0..=80 {
        let (x, y) = (f64::from(step) * 0.05 - 0.5, f64::from(step % 21) * 0.1 - 0.5);
        for (x, y) in [(x, y), (x, -0.5), (x, 1.5), (x, 0.0)] {
            for slope in [map.slope_at_place(x, y), map.height_and_slope_at_place(x, y).1] {
                assert!(
                    (slope[0] - 0.125).abs() < 1e-12 && (slope[1] - 0.5).abs() < 1e-12,
                    "{x} {y}: {slope:?}"
                );
            }
        }
        let (u, v) = ((x + 0.5) / 4.0, (y + 0.5) / 2.0);
        let apart = map.texels_apart_at(u, v);
        let rises = [
            map.height_at(u + 0.25, v) - map.height_at(u - 0.25, v),
            map.height_at(u, v + 0.5) - map.height_at(u, v - 0.5),
        ];
        assert!((rises[0] / apart[0] - 0.125).abs() < 1e-12, "{x} {y}");
        assert!((rises[1] / apart[1] - 0.5).abs() < 1e-12, "{x} {y}");
    }
    // Beyond the edge the map is level, and a map of one texel is level everywhere.
    assert_eq!(map.slope_at_place(-0.6, -0.7), [0.0, 0.0]);
    let dot = HeightMap::new(1, 1, vec![0.5], Wrap::Clamp).expect("a valid map");
    assert_eq!(dot.slope_at_place(0.0, 0.2), [0.0, 0.0]);
    assert!(dot.texels_apart_at(0.5, 0.5).iter().all(|&apart| apart > 0.0));
}

#[test]
fn wrong_texels_are_refused() {
    assert!(matches!(HeightMap::new(0, 3, vec![], Wrap::Clamp), Err(HeightMapError::Empty { .. })));
    assert!(matches!(
        HeightMap::new(2, 2, vec![0.0; 3], Wrap::Clamp),
        Err(HeightMapError::WrongLength { given: 3, .. })
    ));
    for bad in [f32::NAN, f32::INFINITY, -0.1, 1.1] {
        let error = HeightMap::new(2, 1, vec![0.0, bad], Wrap::Clamp);
        assert!(matches!(error, Err(HeightMapError::OutOfRange { column: 1, row: 0, .. })), "{bad}");
    }
    assert!(matches!(HeightMap::check_size(100_000, 100_000), Err(HeightMapError::TooLarge { .. })));
    assert!(ramp(Wrap::Clamp).with_displacement(f64::NAN, 0.0).is_err());
    assert!(ramp(Wrap::Clamp).with_texel_size_m([1.0, 0.0]).is_err());
}

#[test]
fn levels_lie_as_the_map_does() {
    let map = ramp(Wrap::Mirror).with_displacement(0.5, -0.25).expect("lengths");
    assert_eq!(map.levels(), 3);
    assert_eq!(map.level(0), map);
    let level = map.level(1);
    assert_eq!((level.width(), level.height(), level.texels()), (2, 1, &[0.3125, 0.5625][..]));
    assert_eq!((level.wrap(), level.scale_m(), level.bias_m()), (Wrap::Mirror, 0.5, -0.25));
    // Clones share them, and each has its own wrap.
    let clamped = map.clone().with_wrap(Wrap::Clamp).level(1);
    assert!(clamped.shares_texels(&level) && clamped.wrap() == Wrap::Clamp);
    assert_eq!(map.level(2).texels(), [0.4375]);
    assert_eq!(map.level(9), map.level(2));
    assert_eq!(HeightMap::new(1, 1, vec![0.5], Wrap::Clamp).map(|map| map.level(1).levels()), Ok(1));
}

#[test]
fn holes_are_those_of_the_map_and_not_of_its_levels() {
    let holes = |width| TexelMask::from_fn(width, 2, |column, _| column == 1);
    let map = ramp(Wrap::Clamp).with_holes(holes(4)).expect("of its size");
    assert_eq!(map.holes().map(|holes| holes.count()), Some(2));
    assert!(map.level(1).holes().is_none() && map.clone().with_wrap(Wrap::Mirror).holes().is_some());
    let error = ramp(Wrap::Clamp).with_holes(holes(5));
    assert_eq!(error, Err(HeightMapError::OtherHoles { holes: [5, 2], map: [4, 2] }));
    let none = ramp(Wrap::Clamp).with_holes(TexelMask::from_fn(4, 2, |_, _| false));
    assert_eq!(none.expect("of its size").holes(), None);
}

#[test]
fn clones_share_their_texels() {
    let map = ramp(Wrap::Clamp);
    let other = map.clone().with_wrap(Wrap::Mirror);
    assert!(map.shares_texels(&other) && !map.shares_texels(&ramp(Wrap::Clamp)));
    assert_eq!(map, ramp(Wrap::Clamp));
    let texels = map.texels().to_vec();
    assert_eq!((map.into_texels(), other.into_texels()), (texels.clone(), texels));
}

#[test]
fn world_lengths_are_known_where_both_are_stated() {
    let map = ramp(Wrap::Clamp);
    assert_eq!(map.stated_lengths_m(), None);
    let map = map.with_texel_size_m([2.0, 5.0]).expect("positive");
    assert_eq!((map.stated_lengths_m(), map.stated_tile_m()), (None, Some([8.0, 10.0])));
    let depth = map.clone().with_physical_range([40.0, 10.0]).expect("finite");
    assert_eq!(depth.stated_lengths_m(), Some(([8.0, 10.0], 30.0)));
    assert_eq!(map.with_physical_range([7.0, 7.0]).expect("finite").stated_lengths_m(), None);
}
