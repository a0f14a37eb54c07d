use relief_core::encoding::code::Codes;
use relief_core::{HeightMap, MapFormat, MapTexels, Metric, Wrap};

use super::*;

/// A map of `side` x `side` texels whose key depends on `number`.
fn map(number: u32, side: u32, format: MapFormat) -> BakedMap {
    let heights =
        HeightMap::from_fn(2, 1, Wrap::Clamp, |i, _| (number + i) as f32 / 1e4).expect("a valid map");
    let identity = MapIdentity {
        kind: "kind".to_owned(),
        revision: 1,
        texture: "texture".to_owned(),
        settings: vec![("setting".to_owned(), 0.5)],
        heights: heights.heights_hash(),
        wrap: Wrap::Clamp,
        metric: Metric::UNIT,
        first_level: 0,
        height_level: 0,
    };
    let layout = MapLayout { size: [side, side], levels: 1, layers: 2, channels: 2, format };
    let values = 0..4 * side * side;
    let texels = match format {
        MapFormat::F32 => MapTexels::F32(values.map(|value| value as f32 - 1.5).collect()),
        MapFormat::F16 => MapTexels::F16(values.map(|value| value as u16).collect()),
        MapFormat::Unorm8 => MapTexels::Unorm8(values.map(|value| value as u8).collect()),
    };
    let codes = [Codes { low: -0.5, step: number as f32 }; 4];
    BakedMap::new(identity, layout, codes, texels).expect("a map of that shape")
}

fn cache(limit: u64) -> (tempfile::TempDir, Cache) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let cache = Cache::new(folder.path().join("made when needed"), ByteSize(limit));
    (folder, cache)
}

fn read(cache: &Cache, map: &BakedMap) -> CacheEntry {
    cache.read(map.identity(), map.layout())
}

fn names(cache: &Cache) -> Vec<String> {
    let mut names: Vec<String> =
        cache.files().expect("a readable folder").into_iter().map(|file| file.name).collect();
    names.sort();
    names
}

fn held(cache: &Cache) -> u64 {
    cache.files().expect("a readable folder").iter().map(|file| file.bytes).sum()
}

#[test]
fn stored_maps_are_read_and_no_other_files_are_mistaken_for_them() {
    let (_folder, cache) = cache(1 << 30);
    for format in [MapFormat::F32, MapFormat::F16, MapFormat::Unorm8] {
        for side in [1, 3, 200] {
            let map = map(7, side, format);
            assert_eq!(read(&cache, &map), CacheEntry::Missing);
            let path = cache.write(&map).expect("a writable folder");
            assert_eq!(path, cache.path(map.identity(), map.layout()));
            assert_eq!(fs::metadata(path).expect("the file").len(), file::length(map.layout()));
            assert_eq!(read(&cache, &map), CacheEntry::Valid(Box::new(map)));
        }
    }
    assert_eq!(read(&cache, &map(8, 3, MapFormat::F32)), CacheEntry::Missing);
    assert_eq!(names(&cache).iter().filter(|name| is_map(name)).count(), 9);
}

#[test]
fn every_changed_byte_and_every_cut_is_seen_and_mended() {
    let (_folder, cache) = cache(1 << 30);
    let map = map(1, 2, MapFormat::F32);
    let path = cache.write(&map).expect("a writable folder");
    let right = fs::read(&path).expect("the file");
    for at in 0..right.len() {
        let mut wrong = right.clone();
        wrong[at] ^= 4;
        fs::write(&path, &wrong).expect("the folder is writable");
        assert_eq!(read(&cache, &map), CacheEntry::Damaged, "byte {at}");
        fs::write(&path, &right[..at]).expect("the folder is writable");
        assert_eq!(read(&cache, &map), CacheEntry::Damaged, "cut at {at}");
    }
    fs::write(&path, [&right[..], &[0]].concat()).expect("the folder is writable");
    assert_eq!(read(&cache, &map), CacheEntry::Damaged);
    cache.write(&map).expect("a writable folder");
    assert_eq!(read(&cache, &map), CacheEntry::Valid(Box::new(map.clone())));
    fs::remove_file(&path).expect("the file");
    fs::create_dir(&path).expect("the folder is writable");
    assert_eq!(read(&cache, &map), CacheEntry::Damaged);
    assert!(matches!(cache.write(&map), Err(CacheError::Folder { .. })));
    assert!(!names(&cache).iter().any(|name| is_unfinished(name)));
}

#[test]
fn what_is_unused_longest_makes_room() {
    let one = file::length(map(0, 8, MapFormat::F32).layout());
    let (_folder, cache) = cache(3 * one + one / 2);
    let maps: Vec<BakedMap> = (0..5).map(|number| map(number, 8, MapFormat::F32)).collect();
    let used = |map: &BakedMap, seconds: u64| {
        let file = File::options().append(true).open(cache.path(map.identity(), map.layout()));
        let when = SystemTime::UNIX_EPOCH + Duration::from_secs(seconds);
        file.and_then(|file| file.set_modified(when)).expect("the file");
    };
    for (seconds, map) in (1..).zip(&maps[..3]) {
        cache.write(map).expect("a writable folder");
        used(map, seconds);
    }
    // Reading makes the least recently used map the most recently used one.
    assert!(matches!(read(&cache, &maps[0]), CacheEntry::Valid(_)));
    cache.write(&maps[3]).expect("a writable folder");
    let there = |map: &BakedMap| cache.path(map.identity(), map.layout()).exists();
    assert_eq!(maps.each_there(&there), [true, false, true, true, false]);
    assert!(held(&cache) <= cache.limit);
    used(&maps[0], 10);
    used(&maps[3], 11);
    used(&maps[2], 12);
    cache.write(&maps[4]).expect("a writable folder");
    assert_eq!(maps.each_there(&there), [false, false, true, true, true]);
    // A map that exists already needs no space.
    cache.write(&maps[4]).expect("a writable folder");
    assert_eq!(maps.each_there(&there), [false, false, true, true, true]);
    // A lower limit applies from the next run on.
    Cache::new(cache.folder.clone(), ByteSize(one)).tidy();
    assert_eq!(maps.each_there(&there), [false, false, false, false, true]);
    let refused = Cache::new(cache.folder.clone(), ByteSize(one - 1)).write(&maps[0]);
    assert!(matches!(refused, Err(CacheError::TooLarge { .. })), "{refused:?}");
}

trait EachThere {
    fn each_there(&self, there: &dyn Fn(&BakedMap) -> bool) -> Vec<bool>;
}

impl EachThere for Vec<BakedMap> {
    fn each_there(&self, there: &dyn Fn(&BakedMap) -> bool) -> Vec<bool> {
        self.iter().map(there).collect()
    }
}

#[test]
fn what_a_killed_process_left_is_removed_and_what_others_put_there_stays() {
    let (_folder, cache) = cache(1 << 30);
    let map = map(3, 4, MapFormat::F32);
    cache.write(&map).expect("a writable folder");
    let aside =
        format!("{UNFINISHED}{}", names(&cache).into_iter().find(|name| is_map(name)).expect("a map"));
    let strangers = ["notes.map", "kind-0123.map", "picture.png"];
    for name in strangers.iter().copied().chain([aside.as_str()]) {
        fs::write(cache.folder.join(name), vec![1; 1 << 20]).expect("the folder is writable");
    }
    // While another process holds the lock, unfinished files may belong to it.
    let lock = cache.locked(Duration::ZERO).expect("a writable folder");
    cache.tidy();
    assert!(names(&cache).contains(&aside));
    assert!(matches!(cache.locked(Duration::ZERO), Err(CacheError::Busy(_))));
    drop(lock);
    Cache::new(cache.folder.clone(), ByteSize(1 << 10)).tidy();
    let names = names(&cache);
    assert!(!names.contains(&aside) && strangers.iter().all(|name| names.contains(&(*name).to_owned())));
    assert!(matches!(read(&cache, &map), CacheEntry::Valid(_)));
}

#[test]
fn a_folder_that_cannot_be_made_is_an_error() {
    let (folder, _) = cache(1 << 20);
    let file = folder.path().join("a file");
    fs::write(&file, "no folder").expect("the folder is writable");
    for place in [file.clone(), file.join("below")] {
        let cache = Cache::new(place, ByteSize(1 << 20));
        cache.tidy();
        assert_eq!(read(&cache, &map(1, 1, MapFormat::F32)), CacheEntry::Missing);
        let refused = cache.write(&map(1, 1, MapFormat::F32));
        assert!(matches!(refused, Err(CacheError::Folder { .. })), "{refused:?}");
    }
    assert_eq!(fs::read(file).expect("the file"), b"no folder");
}
