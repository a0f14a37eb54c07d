//! Volumes: the shaders' walk beside the judge's in `f64`, and what goes with a volume.

use std::sync::Arc;

use glam::{DVec3, Vec3};
use relief_bake::volumes::{Directions, Fit, MeshVolumeSettings, volume_from_mesh};
use relief_core::camera::Camera;
use relief_core::mesh::{RawCorner, RawMesh, torus};
use relief_core::rng::Rng;
use relief_core::{BakedMap, HeightMap, Hit, Lanes, MapTexels, Path, Volume, Watch, Wrap};
use relief_maps::Maps;
use relief_mesh::motif::MotifKind;
use relief_render::render;
use relief_scene::{BackendChoice, Scene, Surface};
use relief_shaders::Selection;
use relief_shaders::cpu::{MethodTracer, PixelOut};
use relief_shaders::field::Solids;
use relief_testing::motifs::to_triangle;
use relief_testing::volumes;
use relief_tests::adapter::{Leeway, has_adapter};
use relief_tests::volume_rays::{
    baked, hits, hits_over, motif_volume, parts_off, paths, ray_from_above, wrong,
};

/// Rays over a volume in one wrap. Times scale with it.
const RAYS: usize = 4_000;

/// A baked map with other values.
fn changed(map: &BakedMap, change: impl Fn(usize, f32) -> f32) -> Vec<Arc<BakedMap>> {
    let MapTexels::F32(values) = map.texels() else { panic!("maps are baked as floats") };
    let values = values.iter().enumerate().map(|(at, value)| change(at, *value)).collect();
    let (identity, layout) = (map.identity().clone(), *map.layout());
    vec![Arc::new(BakedMap::new(identity, layout, *map.codes(), MapTexels::F32(values)).expect("a map"))]
}

#[test]
fn voxels_find_the_first_hit_of_the_judge() {
    let selection = Selection::method("voxels").expect("a method");
    for (number, named) in volumes::ALL.iter().enumerate() {
        for wrap in Wrap::ALL {
            let volume = named.build(wrap).expect("a volume");
            let paths = paths(number as u64, RAYS);
            let found = hits(&volume, &selection, &paths, Lanes::widest());
            let hit = found.iter().filter(|hit| hit.found).count();
            let wrong = wrong(&volume, &paths, &found);
            println!("{} {wrap}: {hit} hits of {RAYS}, {wrong} wrong", named.name);
            assert_eq!(wrong, 0, "{} {wrap}", named.name);
            let expected = if named.name == "empty" { 0..1 } else { RAYS / 1000..RAYS + 1 };
            assert!(expected.contains(&hit), "{} {wrap}: {hit} hits", named.name);
            assert!(found.iter().all(|hit| !hit.exhausted), "{} {wrap}", named.name);
        }
    }
}

#[test]
fn another_volume_is_noticed() {
    let selection = Selection::method("voxels").expect("a method");
    let volume = volumes::ALL[0].build(Wrap::Repeat).expect("a volume");
    let paths = paths(1, RAYS);
    let mut values = volume.values();
    values[100] = 1.0 - values[100];
    let changed = Volume::new(volume.size(), &values, Wrap::Repeat).expect("a volume");
    let clamped = volume.clone().with_wrap(Wrap::Clamp);
    for other in [changed, clamped] {
        let found = hits(&other, &selection, &paths, Lanes::widest());
        assert!(wrong(&volume, &paths, &found) > 10);
    }
}

#[test]
fn a_volume_of_a_mesh_shows_the_mesh() {
    const SIDE: f64 = 128.0;
    let Some(spot) = relief_tests::spot("spot_triangulated.obj") else { return };
    let places: Vec<Vec3> = spot.vertices().iter().map(|vertex| vertex.position).collect();
    let low = places.iter().fold(Vec3::INFINITY, |low, at| low.min(*at));
    let high = places.iter().fold(Vec3::NEG_INFINITY, |high, at| high.max(*at));
    // In the middle of the tile, nine tenths as long as it.
    let placed = |at: &Vec3| 0.5 + 0.9 * (*at - 0.5 * (low + high)) / (high - low).max_element();
    let corner = |position| RawCorner { position, normal: RawCorner::NONE, uv: RawCorner::NONE };
    let raw = RawMesh {
        positions: places.iter().map(placed).collect(),
        triangles: spot.triangles().iter().map(|corners| corners.map(corner)).collect(),
        ..RawMesh::default()
    };
    let settings = MeshVolumeSettings { fit: Fit::Tile, ..MeshVolumeSettings::new([SIDE as u32; 3]) };
    let volume = volume_from_mesh(&raw, &settings, &Watch::none()).expect("a volume").volume;
    let selection = Selection::method("voxels").expect("a method");
    let mut rng = Rng::new(17);
    let straight = (0..RAYS).map(|_| {
        let mut at = |high: f64| [rng.unit(), rng.unit(), high];
        Path::from(&relief_shaders::cpu::Path::from(&Path::between(at(1.0), at(0.0))))
    });
    let paths: Vec<Path> = straight.collect();
    let found = hits(&volume, &selection, &paths, Lanes::widest());
    // In voxels; the mesh's y is the height.
    let voxels = |u: f64, v: f64, h: f64| DVec3::new(u, v, h) * SIDE;
    let at = |number: u32| {
        let place = raw.positions[number as usize];
        voxels(place.x.into(), place.z.into(), place.y.into())
    };
    let triangles: Vec<[DVec3; 3]> = spot.triangles().iter().map(|corners| corners.map(at)).collect();
    let mut apart: Vec<f64> = paths
        .iter()
        .zip(&found)
        .filter(|(_, hit)| hit.found)
        .take(600)
        .map(|(path, hit)| {
            let [u, v, h] = path.at(hit.t);
            let point = voxels(u, v, h);
            triangles.iter().map(|corners| to_triangle(point, *corners)).fold(f64::INFINITY, f64::min)
        })
        .collect();
    apart.sort_by(f64::total_cmp);
    assert!(apart.len() > 300, "{} hits", apart.len());
    let [median, p99] = [0.5, 0.99].map(|part| apart[(part * apart.len() as f64) as usize]);
    println!("{} hits: median {median}, p99 {p99} voxels", apart.len());
    assert!(p99 < 0.5, "{p99}");
}

/// Szirmay-Kalos and Umenhoffer 2008, section 5.2, with the distances of Cohen and Sheffer 1994.
#[test]
fn distances_skip_most_cells_and_a_spoiled_one_is_noticed() {
    let selection = Selection::method("voxels").expect("a method");
    let paths: Vec<Path> = paths(3, 2 * RAYS).into_iter().filter(|path| path.h[2] == 0.0).collect();
    // Dense cloth has little that is empty.
    for (kind, size, most) in [
        (MotifKind::Weave, [64, 64, 32], 0.65),
        (MotifKind::Mail, [64, 64, 32], 0.75),
        (MotifKind::Grass, [128, 128, 32], 0.5),
    ] {
        let volume = motif_volume(kind, size);
        let maps = baked(&volume, &selection);
        let with = |maps: &[Arc<BakedMap>]| hits_over(&volume, &selection, maps, &paths, Lanes::widest());
        let steps = |hits: &[Hit]| hits.iter().map(|hit| f64::from(hit.cost.steps)).sum::<f64>();
        let skipped = with(&maps);
        // Without a distance every cell is visited; the hits are the same.
        let visited = with(&changed(&maps[0], |_, _| 0.0));
        let [some, all] = [&skipped, &visited].map(|hits| steps(hits) / hits.len() as f64);
        println!("{kind}: {some:.1} steps of {all:.1}, {:.2}", some / all);
        assert!(some <= most * all, "{kind}: {some} of {all}");
        let is_same = |(a, b): (&Hit, &Hit)| a.found == b.found && (a.t - b.t).abs() < 1e-5;
        let same = skipped.iter().zip(&visited).filter(|pair| is_same(*pair)).count();
        assert!(same as f64 >= 0.999 * paths.len() as f64, "{kind}: {same} of {}", paths.len());
        // One cell in a hundred says too much.
        let spoiled = changed(&maps[0], |at, value| if at % 100 == 0 { value + 2.0 } else { value });
        assert!(wrong(&volume, &paths, &with(&spoiled)) > 10, "{kind}");
    }
}

#[test]
fn every_width_has_the_bits_of_one_by_one() {
    let pairs = [("voxels", "trilinear"), ("voxels", "none"), ("linear", "binary"), ("linear", "secant")];
    let more = [("linear", "true-secant"), ("linear", "trilinear")];
    let looked_up = [("generalised", "none"), ("generalised", "trilinear")];
    for (search, refine) in pairs.into_iter().chain(more).chain(looked_up) {
        let mut selection =
            Selection::pair(search, refine).expect("listed names").with_solids(Solids::Volumes);
        if search == "generalised" {
            for key in ["search.azimuths", "search.elevations"] {
                selection.set(key, 4.0).expect("a number of directions");
            }
        }
        assert_eq!(selection.check(), Ok(()), "{search} {refine}");
        for named in volumes::ALL {
            let volume = named.build(Wrap::Mirror).expect("a volume");
            let paths = paths(5, 500);
            let maps = baked(&volume, &selection);
            let maps = maps.iter().map(|map| &**map);
            let tracer = MethodTracer::of_volume(&volume, &selection, maps).expect("its maps");
            let alone: Vec<Hit> = paths.iter().map(|path| tracer.first_hit(path)).collect();
            for lanes in Lanes::available() {
                let together = hits(&volume, &selection, &paths, lanes);
                assert_eq!(alone, together, "{search} {refine} {} {lanes:?}", named.name);
            }
        }
    }
}

#[test]
fn samples_of_linear_search_come_near() {
    let mut selection =
        Selection::pair("linear", "binary").expect("listed names").with_solids(Solids::Volumes);
    selection.set("search.steps", 512.0).expect("a setting");
    let volume = volumes::ALL[6].build(Wrap::Repeat).expect("a volume");
    let paths: Vec<Path> = paths(8, RAYS).into_iter().filter(|path| path.h[2] == 0.0).collect();
    let found = hits(&volume, &selection, &paths, Lanes::widest());
    let near = paths.iter().zip(&found).filter(|(path, hit)| match volume.first_hit(path) {
        Some(judge) => hit.found && (hit.t - judge.t).abs() < 0.01 * path.exit,
        None => !hit.found,
    });
    let share = near.count() as f64 / paths.len() as f64;
    assert!(share > 0.95, "{share}");
}

#[test]
fn what_needs_heights_is_refused() {
    let volume = Selection::method("voxels").expect("a method");
    assert_eq!(volume.check(), Ok(()));
    for (key, name) in [
        ("refine", "patch"),
        ("shadow", "horizon"),
        ("shadow", "entry"),
        ("ambient", "occlusion"),
        ("detail", "footprint"),
    ] {
        let mut selection = volume;
        selection.choose(key, name).expect("a listed name");
        assert!(selection.check().is_err(), "{key} {name}");
    }
    // Triangles and searches of heights go back to heights.
    let mut triangles = volume;
    triangles.choose("geometry", "vertex").expect("a listed name");
    assert!(triangles.solids() == Solids::Heights && triangles.with_solids(Solids::Volumes).check().is_err());
    let mut heights = volume;
    heights.choose("search", "cells").expect("a listed name");
    assert!(heights.solids() == Solids::Heights && heights.check().is_err());
    for (key, name) in [("shadow", "soft"), ("shadow", "map"), ("shadow", "none"), ("ambient", "hemisphere")]
    {
        assert_eq!(volume.goes_with(key, name), Ok(true), "{key} {name}");
    }
    for surface in ["plane", "prism", "tetrahedra", "quadric-vertical"] {
        assert_eq!(volume.goes_with("surface", surface), Ok(true), "{surface}");
    }
}

/// The picture of a weave on a torus, with shadows.
fn pixels(surface: &str, shadow: &str, backend: BackendChoice) -> Vec<PixelOut> {
    let volume = volumes::ALL[6].build(Wrap::Repeat).expect("a volume");
    let volume = volume.with_displacement(0.06, 0.0).expect("lengths");
    let mut selection = Selection::method("voxels").expect("a method");
    selection.choose("surface", surface).expect("a listed name");
    selection.choose("shadow", shadow).expect("a listed name");
    let mesh = torus(24, 12).expect("a mesh").tiled([6.0, 3.0].into()).expect("tiles");
    let ground = HeightMap::new(1, 1, vec![0.0], Wrap::Repeat).expect("a map");
    let shown = Surface::new(mesh, ground).with_volume(volume).with_selection(selection);
    let camera = Camera::new([0.5, 0.9, 1.0].into(), [0.0; 3].into(), 40.0).expect("a camera");
    let scene = Scene::builder(shown).camera(camera).size(96, 72).samples(1).backend(backend);
    let scene = scene.build().expect("a proper scene");
    render(&scene, &mut Maps::in_memory(), &Watch::none()).expect("a picture").rendering.pixels
}

#[test]
fn the_backends_show_the_same_on_every_surface() {
    let mut before: Vec<PixelOut> = Vec::new();
    for (surface, shadow) in
        [("plane", "ray"), ("quadric-vertical", "soft"), ("tetrahedra", "map"), ("prism", "ray")]
    {
        let cpu = pixels(surface, shadow, BackendChoice::Cpu);
        let covered = cpu.iter().filter(|pixel| pixel.hit == 1).count();
        assert!(covered > 1000, "{surface}: {covered} pixels");
        let holes = cpu.iter().filter(|pixel| pixel.hit == 1 && pixel.height < 0.2).count();
        println!("{surface} {shadow}: {covered} pixels, {holes} low");
        let alike = |other: &[PixelOut]| {
            let same = |(a, b): &(&PixelOut, &PixelOut)| {
                let bits = |pixel: &PixelOut| {
                    [pixel.uv.x, pixel.uv.y, pixel.t, pixel.lit, pixel.normal.x].map(f32::to_bits)
                };
                a.hit == b.hit && bits(a) == bits(b)
            };
            cpu.iter().zip(other).filter(same).count() as f64 / cpu.len() as f64
        };
        assert!(before.is_empty() || alike(&before) < 0.9, "{surface} shows what another did");
        // Programs of other surfaces compile for longer, and differ in their surfaces alone.
        if has_adapter() && ["plane", "tetrahedra"].contains(&surface) {
            let share = alike(&pixels(surface, shadow, BackendChoice::Gpu));
            println!("{surface} {shadow}: {share:.5} alike");
            assert!(share >= Leeway::of_any().share(0.999), "{surface} {shadow}: {share}");
        }
        before = cpu;
    }
}

#[test]
fn look_ups_by_direction_err_as_the_docs_say() {
    let volume = Volume::from_fn([32, 32, 16], Wrap::Repeat, volumes::weave).expect("a volume");
    let size = volume.size().map(f64::from);
    let mut rng = Rng::new(3);
    let paths: Vec<Path> = (0..RAYS).map(|_| ray_from_above(&mut rng, size, 0.17)).collect();
    let mut parts = Vec::new();
    for (azimuths, elevations) in [(4.0, 4.0), (8.0, 32.0), (16.0, 16.0)] {
        for refine in ["none", "trilinear"] {
            let mut selection = Selection::method("generalised").expect("a method");
            selection.choose("refine", refine).expect("a refinement of volumes");
            selection.set("search.azimuths", azimuths).expect("a number of azimuths");
            selection.set("search.elevations", elevations).expect("a number of elevations");
            let found = hits(&volume, &selection, &paths, Lanes::widest());
            let off = [0.75, 2.0].map(|voxels| parts_off(&volume, &paths, &found, voxels));
            println!("{:?} {azimuths} x {elevations}, {refine}: off {off:?}", volume.size());
            parts.push(off[0]);
        }
    }
    // More directions help, elevations more than azimuths; a refinement mends hits that are a little early.
    let [few, few_refined, steep, steep_refined, usual, refined] = parts[..] else { panic!("{parts:?}") };
    assert!(usual < steep && steep < 0.6 * few, "{parts:?}");
    assert!(refined < 0.5 * usual && refined < steep_refined && steep_refined < few_refined, "{parts:?}");
    assert!(usual < 0.26 && refined < 0.09, "{parts:?}");
}

#[test]
fn a_way_from_a_voxel_in_a_baked_direction_is_looked_up_as_it_is() {
    for named in volumes::ALL {
        let volume = named.build(Wrap::Repeat).expect("a volume");
        let size = volume.size().map(f64::from);
        let mut selection = Selection::method("generalised").expect("a method");
        selection.set("search.azimuths", 8.0).expect("a number of azimuths");
        selection.set("search.elevations", 5.0).expect("a number of elevations");
        let directions = Directions { azimuths: 8, elevations: 5 };
        let mut rng = Rng::new(7);
        let mut paths = Vec::new();
        for _ in 0..1000 {
            let voxel = volume.size().map(|side| f64::from(rng.below(side)));
            let toward = directions.toward(rng.below(directions.count()));
            let at = [0, 1, 2].map(|axis| (voxel[axis] + 0.5) / size[axis]);
            if volume.value_at(at) > 0.45 || toward[2] == 0.0 {
                continue;
            }
            let level = if toward[2] > 0.0 { 1.0 } else { 0.0 };
            let mut path = Path::between(at, [0.0, 0.0, level]);
            path.duv = [toward[0] / size[0], toward[1] / size[1]];
            path.h = [at[2], toward[2] / size[2], 0.0];
            path.exit = (level - at[2]) / path.h[1];
            paths.push(path);
        }
        let found = hits(&volume, &selection, &paths, Lanes::widest());
        let off = parts_off(&volume, &paths, &found, 0.75);
        println!("{}: {off} of {}", named.name, paths.len());
        // Codes are a quarter of a voxel: what is hit that near to the end of a path may be missed.
        assert!(paths.is_empty() || off < 0.06, "{}: {off}", named.name);
        let others =
            named.build(Wrap::Repeat).expect("a volume").values().into_iter().map(|value| 1.0 - value);
        let other = Volume::new(volume.size(), &others.collect::<Vec<_>>(), Wrap::Repeat).expect("a volume");
        // The first map is the view's; shadows have one of their own.
        let [mut maps, others] = [&volume, &other].map(|volume| baked(volume, &selection));
        let (own, other) = (&maps[0], &others[0]);
        let swapped =
            BakedMap::new(own.identity().clone(), *own.layout(), *own.codes(), other.texels().clone());
        maps[0] = Arc::new(swapped.expect("a map"));
        let found = hits_over(&volume, &selection, &maps, &paths, Lanes::widest());
        assert!(paths.is_empty() || parts_off(&volume, &paths, &found, 0.75) > 0.3, "{}", named.name);
    }
}
