use relief_core::Wrap;

use std::sync::atomic::AtomicBool;

use super::*;

fn heights(step: u32) -> HeightMap {
    let texel = |i: u32, j: u32| ((i * step + j * 3) % 17) as f32 / 16.0;
    HeightMap::from_fn(19, 13, Wrap::Mirror, texel).expect("a valid map")
}

fn provided(maps: &mut Maps, method: &str, heights: &HeightMap) -> Provided {
    let selection = Selection::method(method).expect("a method");
    let provided = maps.provide(&selection, heights, Metric::UNIT, &Watch::none()).expect("a bake");
    // The provided maps are the maps that the selection reads.
    let given: Vec<&BakedMap> = provided.maps().iter().map(|(_, map)| &**map).collect();
    selection.slot_maps(given, heights, Metric::UNIT).expect("the right maps");
    provided
}

fn origins(provided: &Provided) -> Vec<Origin> {
    provided.accounts().iter().map(|account| account.origin).collect()
}

#[test]
fn a_map_is_baked_once_and_found_in_memory_and_in_the_folder_after_that() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let maps = || Maps::with_cache(Cache::new(folder.path(), ByteSize(1 << 20)));
    let mut first = maps();
    let baked = provided(&mut first, "cone", &heights(5));
    assert_eq!(origins(&baked), [Origin::Bake]);
    let file = baked.accounts()[0].file.clone().expect("the file is stored");
    assert_eq!(origins(&provided(&mut first, "cone", &heights(5))), [Origin::Memory]);
    // Another scale or bias does not change the map. Other heights or another kind do.
    let scaled = heights(5).with_displacement(0.3, 0.1).expect("proper numbers");
    assert_eq!(origins(&provided(&mut first, "cone", &scaled)), [Origin::Memory]);
    assert_eq!(origins(&provided(&mut first, "cone", &heights(7))), [Origin::Bake]);
    assert_eq!(origins(&provided(&mut first, "frustum", &heights(5))), [Origin::Bake]);
    assert!(origins(&provided(&mut first, "exact", &heights(5))).is_empty());

    let mut second = maps();
    let read = provided(&mut second, "cone", &heights(5));
    assert_eq!((origins(&read), read.accounts()[0].file.as_ref()), (vec![Origin::Cache], Some(&file)));
    assert_eq!(read.maps(), baked.maps());
    std::fs::write(&file, "nothing of use").expect("the folder is writable");
    let again = provided(&mut maps(), "cone", &heights(5));
    assert!(origins(&again) == [Origin::Bake] && again.accounts()[0].was_damaged);
    assert_eq!(origins(&provided(&mut maps(), "cone", &heights(5))), [Origin::Cache]);
}

#[test]
fn formats_are_maps_of_their_own() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let cache = || Cache::new(folder.path(), ByteSize(1 << 20));
    for (format, bytes) in [(MapFormat::F32, 4), (MapFormat::F16, 2), (MapFormat::Unorm8, 1)] {
        let maps = || Maps::with_cache(cache()).with_format(format);
        let baked = provided(&mut maps(), "cone", &heights(5));
        assert_eq!(origins(&baked), [Origin::Bake]);
        assert_eq!(baked.maps()[0].1.layout().bytes(), 19 * 13 * bytes);
        let selection = Selection::method("cone").expect("a method");
        assert_eq!(maps().bytes(&selection, [19, 13]).expect("a cone map"), 19 * 13 * bytes);
        let read = provided(&mut maps(), "cone", &heights(5));
        assert_eq!((origins(&read), read.maps()), (vec![Origin::Cache], baked.maps()));
    }
}

#[test]
fn memory_is_limited_and_the_last_maps_stay() {
    let mut maps = Maps::in_memory().with_memory(ByteSize(19 * 13 * 4 * 2));
    for step in [1, 2, 3] {
        provided(&mut maps, "cone", &heights(step));
    }
    assert_eq!(origins(&provided(&mut maps, "cone", &heights(2))), [Origin::Memory]);
    assert_eq!(origins(&provided(&mut maps, "cone", &heights(3))), [Origin::Memory]);
    assert_eq!(origins(&provided(&mut maps, "cone", &heights(1))), [Origin::Bake]);
    assert_eq!(origins(&provided(&mut maps, "cone", &heights(2))), [Origin::Bake]);
    let mut none = Maps::in_memory().with_memory(ByteSize(0));
    provided(&mut none, "cone", &heights(1));
    assert_eq!(origins(&provided(&mut none, "cone", &heights(1))), [Origin::Memory]);
}

#[test]
fn a_map_of_the_callers_own_is_taken() {
    let baked = provided(&mut Maps::in_memory(), "frustum", &heights(5));
    let mut maps = Maps::in_memory();
    maps.insert(Arc::clone(&baked.maps()[0].1));
    assert_eq!(origins(&provided(&mut maps, "frustum", &heights(5))), [Origin::Memory]);
}

#[test]
fn a_cancelled_bake_is_an_error_and_keeps_nothing() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut maps = Maps::with_cache(Cache::new(folder.path(), ByteSize(1 << 20)));
    let cancel = AtomicBool::new(true);
    let selection = Selection::method("cone").expect("a method");
    let refused = maps.provide(&selection, &heights(5), Metric::UNIT, &Watch::cancelled_by(&cancel));
    assert!(matches!(refused, Err(MapsError::Cancelled(_))), "{refused:?}");
    assert_eq!(std::fs::read_dir(folder.path()).expect("a folder").count(), 0);
}

#[test]
fn what_the_caller_builds_is_provided_only_where_it_is_in_memory_or_of_fewer_bits() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let maps = || Maps::with_cache(Cache::new(folder.path(), ByteSize(1 << 20)));
    let selection = Selection::method("quadtree").expect("a method");
    let provided_except = |maps: &mut Maps, kind: &str, heights: &HeightMap| {
        let built = |need: &MapNeed| need.input.kind == kind;
        let provided = maps.provide_except(&selection, heights, Metric::UNIT, &built, &Watch::none());
        origins(&provided.expect("a bake"))
    };
    let files = || std::fs::read_dir(folder.path()).map_or(0, Iterator::count);
    let before = {
        maps();
        files()
    };
    assert!(provided_except(&mut maps(), "pyramid", &heights(5)).is_empty());
    assert_eq!(files(), before);
    assert_eq!(provided_except(&mut maps(), "cone", &heights(5)), [Origin::Bake]);
    // Maps in the folder are not read either.
    assert!(provided_except(&mut maps(), "pyramid", &heights(5)).is_empty());
    let mut own = Maps::in_memory();
    own.insert(Arc::clone(&provided(&mut maps(), "quadtree", &heights(5)).maps()[0].1));
    assert_eq!(provided_except(&mut own, "pyramid", &heights(5)), [Origin::Memory]);
    assert!(provided_except(&mut own, "pyramid", &heights(7)).is_empty());
    let mut fewer = Maps::in_memory().with_format(MapFormat::F16);
    assert_eq!(provided_except(&mut fewer, "pyramid", &heights(5)), [Origin::Bake]);
}

/// A selection whose ambient light is baked from a level of at most `side` texels per side.
fn sky(side: f64, detail: &str) -> Selection {
    let mut selection = Selection::exact();
    selection.choose("ambient", "sky").expect("an ambient light");
    selection.choose("detail", detail).expect("a detail");
    selection.set("ambient.side", side).expect("a setting");
    selection
}

#[test]
fn a_map_is_baked_from_the_finest_level_that_is_small_enough() {
    let metric = Metric { tile_m: [2.0, 1.0], scale_m: 0.2 };
    let sizes = [
        ([1, 1], 512.0, 0, [1, 1]),
        ([1, 5], 512.0, 0, [1, 5]),
        ([1, 33], 16.0, 1, [1, 16]),
        ([512, 100], 512.0, 0, [512, 100]),
        ([513, 100], 512.0, 1, [256, 50]),
        ([300, 700], 512.0, 1, [150, 350]),
        ([300, 700], 16.0, 6, [4, 10]),
        ([1024, 512], 128.0, 3, [128, 64]),
    ];
    for (number, (size, side, level, baked_size)) in sizes.into_iter().enumerate() {
        let wrap = Wrap::ALL[number % Wrap::ALL.len()];
        let texel = |i: u32, j: u32| ((i * 7 + j * j * 3) % 17) as f32 / 16.0;
        let heights = HeightMap::from_fn(size[0], size[1], wrap, texel).expect("a valid map");
        for detail in ["none", "footprint"] {
            let selection = sky(side, detail);
            let mut maps = Maps::in_memory();
            let provided = maps.provide(&selection, &heights, metric, &Watch::none()).expect("a bake");
            let map = provided.slots().get(MapSlot::Ambient).expect("a map");
            let levels = if detail == "none" { 1 } else { heights.levels() - level };
            let layout = map.layout();
            assert_eq!((layout.size, layout.levels), (baked_size, levels), "{size:?} {side}");
            assert_eq!(map.identity().height_level, level, "{size:?} {side}");
            assert_eq!(maps.bytes(&selection, size).expect("a shape"), layout.bytes());
            selection.slot_maps([map], &heights, metric).expect("the right map");
            // The map equals the map of the level's heights, in the same metres.
            let coarse = heights.level(level);
            let of_level = maps.provide(&sky(16384.0, detail), &coarse, metric, &Watch::none());
            let of_level = of_level.expect("a bake");
            let same = of_level.slots().get(MapSlot::Ambient).expect("a map");
            assert!(same.texels() == map.texels() && same.identity().height_level == 0, "{size:?} {side}");
        }
    }
}

#[test]
fn maps_of_different_levels_are_not_taken_for_each_other() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let texel = |i: u32, j: u32| ((i * 5 + j * 3) % 17) as f32 / 16.0;
    // A constant map is the same in all its levels except for their sizes.
    let constant = HeightMap::from_fn(64, 64, Wrap::Repeat, |_, _| 0.5).expect("a valid map");
    for heights in [HeightMap::from_fn(64, 64, Wrap::Repeat, texel).expect("a valid map"), constant] {
        for again in [false, true] {
            let mut maps = Maps::with_cache(Cache::new(folder.path(), ByteSize(1 << 22)));
            for (side, first) in [(16.0, true), (32.0, true), (64.0, true), (512.0, false), (40.0, false)] {
                let selection = sky(side, "none");
                let provided = maps.provide(&selection, &heights, Metric::UNIT, &Watch::none());
                let provided = provided.expect("a bake");
                let origin = match (first, again) {
                    (true, false) => Origin::Bake,
                    (true, true) => Origin::Cache,
                    (false, _) => Origin::Memory,
                };
                assert_eq!(origins(&provided), [origin], "{side}");
                let map = provided.slots().get(MapSlot::Ambient).expect("a map");
                // The map of another level is refused.
                let other = sky(if side == 16.0 { 32.0 } else { 16.0 }, "none");
                assert!(other.slot_maps([map], &heights, Metric::UNIT).is_err(), "{side}");
            }
        }
    }
    // A bake from a coarser level needs less memory than one from the map itself, and includes the
    // memory of the levels.
    let maps = Maps::in_memory();
    let working = |side| maps.working_bytes(&sky(side, "none"), [4096, 4096]).expect("a kind");
    let levels = 4 * (4096 * 4096 - 1) / 3;
    assert!(working(512.0) > levels && working(512.0) < working(4096.0) / 2, "{}", working(512.0));
}
