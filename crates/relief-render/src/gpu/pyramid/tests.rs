//! Comparison of built and baked pyramids, and tests of when they are built.

use relief_bake::baked_map;
use relief_core::{BakedMap, ByteSize, Watch, Wrap};
use relief_maps::{Cache, DEFAULT_LIMIT, Maps, Origin};
use relief_shaders::Selection;
use relief_shaders::wgsl::Sampling;
use relief_testing::maps;
use wgpu::{Limits, TexelCopyBufferInfo, TexelCopyBufferLayout};

use super::*;
use crate::Renderer;
use crate::block_on;
use crate::gpu::Work;
use crate::gpu::programs::Programs;
use crate::gpu::tests::{hills, own, rendered, scene, software, three_surfaces};
use crate::gpu::textures::{self, Precision};
use crate::job::Rendering;
use relief_scene::{Scene, Surface};

/// A search that reads a pyramid, and in which detail.
type Reader = (&'static str, &'static str);

/// In the finest level of detail.
const FINEST: Reader = ("pyramid", "none");

/// Methods and settings that read a pyramid, with the samples of its extremes.
const READERS: [(Reader, Over); 3] = [
    (FINEST, Over::Cells),
    (("pyramid-texels", "none"), Over::Texels),
    (("pyramid", "footprint"), Over::Levels),
];

fn selection((search, detail): Reader) -> Selection {
    let mut selection = Selection::method("quadtree").expect("a method");
    selection.choose("search", search).expect("a search");
    selection.choose("refine", if search == "pyramid" { "patch" } else { "none" }).expect("a refinement");
    selection.choose("detail", detail).expect("a detail");
    selection
}

/// The map that a selection reads, as the CPU bakes it.
fn baked(map: &HeightMap, selection: &Selection) -> Arc<BakedMap> {
    let needs = selection.map_needs();
    let mut settings = KIND.defaults();
    for (name, value) in &needs[0].settings {
        settings.set(name, f64::from(*value)).expect("a setting of the kind");
    }
    let levels = needs[0].input.levels;
    let (metric, format) = (Metric::UNIT, MapFormat::F32);
    let wanted = WantedMap { kind: &KIND, texture: "", settings, metric, levels, height_level: 0, format };
    Arc::new(baked_map(map, &wanted, &Watch::none()).expect("a bake"))
}

fn builder(gpu: &Gpu, map: &Arc<HeightMap>) -> Builder {
    let surface = JobSurface {
        settings: relief_shaders::cpu::SurfaceSettings::tracing(
            map,
            &selection(FINEST),
            &relief_shaders::SlotMaps::default(),
        ),
        selection: selection(FINEST),
        triangles: Arc::default(),
        height_map: Arc::clone(map),
        color: None,
        normal_map: None,
        material_maps: None,
        maps: Vec::new(),
        two_sided: false,
    };
    let mut programs = Programs::new(gpu);
    let built = block_on(programs.pyramids(gpu, &[surface], Sampling::Exact));
    built.expect("it is compiled").expect("a pyramid is built")
}

/// All texels of a level of a pyramid, both extremes of each.
fn read_level(gpu: &Gpu, texture: &Texture, level: u32) -> Vec<f32> {
    let mut from = texture.as_image_copy();
    from.mip_level = level;
    let [width, height] = [texture.width(), texture.height()].map(|side| (side >> level).max(1));
    let row = (8 * width).next_multiple_of(256);
    let usage = BufferUsages::COPY_DST | BufferUsages::MAP_READ;
    let buffer = gpu.buffer("to read", u64::from(row) * u64::from(height), usage);
    let layout = TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(row), rows_per_image: None };
    let into = TexelCopyBufferInfo { buffer: &buffer, layout };
    let mut encoder = gpu.device().create_command_encoder(&Default::default());
    encoder.copy_texture_to_buffer(from, into, Extent3d { width, height, depth_or_array_layers: 1 });
    gpu.queue().submit([encoder.finish()]);
    let mut values = Vec::new();
    let read = gpu.read(&buffer, buffer.size(), |bytes| {
        for texels in bytes.chunks(row as usize) {
            let texels = texels[..8 * width as usize].as_chunks::<4>().0;
            values.extend(texels.iter().map(|bytes| f32::from_ne_bytes(*bytes)));
        }
    });
    block_on(read).expect("it is read");
    values
}

/// The pyramid of a map as it is built, level by level.
fn built(gpu: &Gpu, builder: &Builder, map: &Arc<HeightMap>, over: Over) -> Vec<Vec<f32>> {
    let texture = block_on(gpu.guarded(|| {
        let heights = textures::heights(gpu, map, map.levels(), Precision::F32)?;
        builder.build(gpu, "pyramid", &Source { heights: Arc::clone(map), over }, &heights)
    }));
    let texture = texture.expect("it is built");
    (0..texture.mip_level_count()).map(|level| read_level(gpu, &texture, level)).collect()
}

/// Number of values of each level that differ in a bit; zeros of either sign are the same. `None`
/// where the levels are not of the same sizes.
fn differences(built: &[Vec<f32>], baked: &BakedMap) -> Option<Vec<usize>> {
    let relief_core::MapTexels::F32(values) = baked.texels() else { return None };
    let same_levels = built.len() == baked.places().len();
    let each = built.iter().zip(baked.places()).map(|(level, place)| {
        let baked = &values[2 * place.start..2 * (place.start + place.width * place.height)];
        let is_same = |a: f32, b: f32| a.to_bits() == b.to_bits() || (a == 0.0 && b == 0.0);
        let differ = |(a, b): &(&f32, &f32)| !is_same(**a, **b);
        (level.len() == baked.len()).then(|| level.iter().zip(baked).filter(differ).count())
    });
    each.collect::<Option<Vec<_>>>().filter(|_| same_levels)
}

/// Adversarial maps, and some for what a pyramid does at its edges and with extreme floats.
fn adversarial(wrap: Wrap) -> Vec<(String, Arc<HeightMap>)> {
    let mut all: Vec<(String, HeightMap)> =
        maps::ALL.iter().map(|map| (map.name.to_owned(), map.build(wrap))).collect();
    let noise = |i: u32, j: u32| (i.wrapping_mul(0x9e37_79b9) ^ j.wrapping_mul(0x85eb_ca6b)).rotate_left(9);
    let unit = |i, j| (noise(i, j) >> 8) as f32 / (1u32 << 24) as f32;
    for [width, height] in [[127, 61], [2, 3], [3, 2], [1, 2], [257, 1], [1, 300], [255, 130]] {
        let map = HeightMap::from_fn(width, height, wrap, unit).expect("a valid map");
        all.push((format!("noise {width}x{height}"), map));
    }
    // Zeros of both signs, the least floats that there are, and others below what some adapters keep.
    let extreme = |i, j| {
        [0.0, -0.0, f32::from_bits(1), f32::from_bits(2), 1e-40, f32::MIN_POSITIVE, 1e-30, 1.0]
            [(noise(i, j) >> 20) as usize % 8]
    };
    let texels = (0..19 * 23).map(|at| extreme(at % 19, at / 19)).collect();
    all.push(("extreme floats".to_owned(), HeightMap::new(19, 23, texels, wrap).expect("a valid map")));
    all.into_iter().map(|(name, map)| (name, Arc::new(map))).collect()
}

#[test]
fn every_level_has_the_bits_of_the_baked_map_within_the_least_limits() {
    let Some(gpu) = own(Limits::downlevel_defaults()) else { return };
    let builder = builder(&gpu, &hills(4, 4, Wrap::Repeat));
    for wrap in Wrap::ALL {
        for (name, map) in adversarial(wrap) {
            for (reader, over) in READERS {
                let found = differences(&built(&gpu, &builder, &map, over), &baked(&map, &selection(reader)));
                let found = found.unwrap_or_else(|| panic!("{reader:?} {name} {wrap}: other levels"));
                assert!(found.iter().all(|count| *count == 0), "{reader:?} {name} {wrap}: {found:?} differ");
            }
        }
    }
}

#[test]
fn a_single_other_texel_and_another_wrap_are_noticed() {
    let Some(gpu) = software() else { return };
    let map = maps::ALL[0].build(Wrap::Repeat);
    let builder = builder(&gpu, &Arc::new(map.clone()));
    let [width, height] = [map.width(), map.height()];
    // The height and the corner that lie at the end of every other.
    for place in [0, (width * height - 1) as usize, (width * height / 2) as usize] {
        let mut texels = map.texels().to_vec();
        texels[place] = 1.0;
        let other = HeightMap::new(width, height, texels, Wrap::Repeat).expect("a valid map");
        for (reader, over) in READERS {
            let built = built(&gpu, &builder, &Arc::new(other.clone()), over);
            let found = differences(&built, &baked(&map, &selection(reader))).expect("the same levels");
            assert!(found.iter().all(|count| *count > 0), "{reader:?}, texel {place}: {found:?} differ");
        }
    }
    let mirrored = Arc::new(map.clone().with_wrap(Wrap::Mirror));
    let found = differences(&built(&gpu, &builder, &mirrored, Over::Cells), &baked(&map, &selection(FINEST)));
    assert!(found.is_some_and(|counts| counts[0] > 0));
}

/// The sample scene with a search for each surface, and for the shadows.
fn searched(reader: Reader) -> Scene {
    let surfaces = three_surfaces().into_iter().map(|surface| surface.with_selection(selection(reader)));
    scene(surfaces.collect())
}

/// Picture of a scene with the maps that the CPU bakes.
fn with_baked_maps(renderer: &mut Renderer, scene: &Scene) -> Rendering {
    let mut maps = Maps::in_memory();
    for surface in scene.surfaces() {
        maps.insert(baked(surface.height_map(), surface.selection()));
    }
    let picture = renderer.render(scene, &mut maps, &Watch::none()).expect("a picture");
    let origins: Vec<Origin> = picture.info.maps.iter().map(|account| account.origin).collect();
    assert_eq!((origins, renderer.last_work().built), (vec![Origin::Memory; 3], 0));
    picture.rendering
}

#[test]
fn a_pyramid_is_built_once_and_again_when_the_heights_or_their_wrap_change() {
    let Some(gpu) = software() else { return };
    for (reader, _) in READERS {
        let (mut renderer, mut maps) = (Renderer::on_gpu(gpu.clone(), Sampling::Exact), Maps::in_memory());
        let mut other = Renderer::on_gpu(gpu.clone(), Sampling::Exact);
        let mut scene = searched(reader);
        let first = rendered(&mut renderer, &scene, &mut maps);
        // One for each surface, which the searches of view and shadow both read.
        assert_eq!(renderer.last_work().built, 3, "{reader:?}");
        assert_eq!(first, with_baked_maps(&mut other, &scene), "{reader:?}");
        assert_eq!(rendered(&mut renderer, &scene, &mut maps), first);
        assert_eq!(renderer.last_work(), Work::default());

        let change = |scene: &Scene, map: Arc<HeightMap>| {
            let [first, rest @ ..] = scene.surfaces() else { panic!("three surfaces") };
            let changed = first.clone().with_height_map(map);
            let surfaces: Vec<Surface> = [changed].into_iter().chain(rest.iter().cloned()).collect();
            scene.to_builder().surfaces(surfaces).build().expect("a proper scene")
        };
        // Other heights, the same ones with another wrap, and with another displacement.
        let heights = hills(61, 40, Wrap::Repeat);
        let wrapped = Arc::new((*heights).clone().with_wrap(Wrap::Mirror));
        let deeper = Arc::new((*wrapped).clone().with_displacement(0.1, -0.1).expect("proper numbers"));
        for (map, count) in [(heights, 1), (wrapped, 1), (deeper, 0)] {
            scene = change(&scene, map);
            let picture = rendered(&mut renderer, &scene, &mut maps);
            let work = renderer.last_work();
            assert_eq!((work.built, work.compiled), (count, 0), "{reader:?}");
            assert_eq!(picture, with_baked_maps(&mut other, &scene), "{reader:?}");
        }
    }
}

#[test]
fn nothing_is_baked_or_kept_where_pyramids_are_built() {
    let Some(gpu) = software() else { return };
    let folder = tempfile::tempdir().expect("a temporary folder");
    let provider = || Maps::with_cache(Cache::new(folder.path(), DEFAULT_LIMIT));
    let scene = searched(FINEST);
    let origins = |renderer: &mut Renderer, maps: &mut Maps| -> Vec<Origin> {
        let picture = renderer.render(&scene, maps, &Watch::none()).expect("a picture");
        picture.info.maps.iter().map(|account| account.origin).collect()
    };
    let files = || {
        std::fs::read_dir(folder.path())
            .expect("a folder")
            .flatten()
            .filter(|file| file.path().extension().is_some())
            .count()
    };
    let mut on_gpu = Renderer::on_gpu(gpu.clone(), Sampling::Exact);
    assert_eq!((origins(&mut on_gpu, &mut provider()), files()), (vec![], 0));
    assert_eq!(on_gpu.last_work().built, 3);
    // Fewer bits are baked, of pyramids that are built nothing is left over; the CPU bakes.
    let mut fewer = Maps::in_memory().with_format(MapFormat::F16).with_memory(ByteSize(1 << 20));
    assert_eq!(origins(&mut on_gpu, &mut fewer)[0], Origin::Bake);
    assert_eq!(on_gpu.last_work().built, 0);
    assert!(origins(&mut Renderer::on_cpu(), &mut provider()).contains(&Origin::Bake));
    assert!(files() > 0);
}

#[test]
fn where_heights_have_16_bits_on_the_gpu_their_pyramid_is_baked() {
    // Without the feature that filters 32 bits.
    let Some(gpu) = own(Limits::downlevel_defaults()) else { return };
    let scene = searched(FINEST);
    for (sampling, built) in [(Sampling::Fast, 0), (Sampling::Exact, 3), (Sampling::Fast, 0)] {
        let mut renderer = Renderer::on_gpu(gpu.clone(), sampling);
        let picture = renderer.render(&scene, &mut Maps::in_memory(), &Watch::none()).expect("a picture");
        assert_eq!(picture.info.maps.is_empty(), built > 0);
        assert_eq!(renderer.last_work().built, built);
    }
}

#[test]
fn only_pyramids_with_settings_that_are_known_are_built() {
    let needs: Vec<MapNeed> = READERS.map(|(reader, _)| selection(reader).map_needs().swap_remove(0)).into();
    for (need, (_, wanted)) in needs.iter().zip(READERS) {
        assert_eq!(over(need), Some(wanted));
    }
    for method in ["cone", "frustum"] {
        let needs = Selection::method(method).expect("a method").map_needs();
        assert!(needs.iter().all(|need| over(need).is_none()), "{method}");
    }
    let bits = MapNeed { settings: vec![("bits", 8.0)], ..needs[0].clone() };
    let other = MapNeed { settings: vec![("over", 1.5)], ..needs[1].clone() };
    assert_eq!((over(&bits), over(&other)), (None, None));
}
