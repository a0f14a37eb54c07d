//! What comes before and after search and refinement has the answers of the single numbers over lanes, too.

use std::fmt::Debug;
use std::sync::Arc;

use rayon::prelude::*;
use relief_core::rng::Rng;
use relief_core::{HeightMap, Lanes, MapFormat, TexelMask, Wrap};
use relief_io::Picture;
use relief_render::job::JobSurface;
use relief_render::mipmaps::Mipmaps;
use relief_scene::environment::Environment;
use relief_scene::material_maps::{MaterialMap, MaterialMaps, MaterialPictures};
use relief_shaders::cpu::{
    BLOCK, EnteredBlock, Frame, HitBlock, Light, LightPoint, PathBlock, PixelIn, PixelOutBlock, Program, Row,
    SurfaceSettings, Triangle, TriangleRays, Vec4,
};
use relief_shaders::surface::{ENTRIES, Proposal};
use relief_shaders::{
    AMBIENT, DETAIL, MAX_LIGHTS, MapSlot, SHADE, SHADOW, SLICES, STAGES, SURFACE, Selection,
};
use relief_testing::maps;
use relief_tests::baked::maps_in;
use relief_tests::one_source::cases::bare_surface;
use relief_tests::one_source::rays;

/// Triangles of a surface, a detail and a map, each seen by a block of rays.
const TRIANGLES: usize = 40;

/// The most steps of a search: rays without an end are walked to that.
const LONGEST_LOOP: f32 = 128.0;

/// The most tiles along an axis of what has a way through a shell: in more, `f32` does not tell cells apart.
const MOST_TILES: f32 = 1e4;

/// Whether a shadow needs nothing but the surface and its own maps.
fn is_own(name: &str) -> bool {
    !["map", "scene"].contains(&name)
}

/// Everything that lanes give for a block of rays, each number written out: any NaN is like another.
fn answers(
    program: &Program,
    rays: TriangleRays<'_>,
    which: u16,
    lights: u32,
    lanes: Lanes,
) -> [Vec<String>; BLOCK] {
    let (mut at, mut paths, mut hits) = (EnteredBlock::default(), PathBlock::default(), HitBlock::default());
    let (mut keys, mut placed) = ([0.0; BLOCK], EnteredBlock::default());
    let mut said: [Vec<String>; BLOCK] = std::array::from_fn(|_| Vec::new());
    program.enter_block(rays, which, lanes, &mut at, &mut paths);
    // What lanes make of paths that none are is of no use, and may differ.
    let on_way = |place: &usize| at.segments[*place] > 0 && paths.exit[*place] > 0.0;
    let traced = (0..BLOCK).filter(on_way).fold(0, |bits, place| bits | 1 << place) & which;
    say(&mut said, |place| at.get(place));
    say(&mut said, |place| (at.segments[place] > 0).then(|| paths.get(place)));
    program.trace_block(&paths, traced, lanes, &mut hits);
    program.meet_block((rays, 0), traced, lanes, (&at, &paths), &mut hits, &mut keys);
    say(&mut said, |place| (hits.get(place), keys[place]));
    let found = (0..BLOCK).filter(|place| hits.found[*place] == 1);
    let found = found.fold(0, |bits, place| bits | 1 << place) & traced;
    program.place_block(rays, found, lanes, (&at, &paths, &hits), &mut placed);
    say(&mut said, |place| placed.get(place));
    let has_second = (0..BLOCK).filter(|place| at.segments[*place] > 1);
    let has_second = has_second.fold(0, |bits, place| bits | 1 << place) & which;
    let mut second = paths;
    program.segment_block(rays, 1, has_second, lanes, &at, &mut second);
    say(&mut said, |place| (has_second >> place & 1 == 1).then(|| second.get(place)));
    let mut visible = [[0.0; BLOCK]; MAX_LIGHTS];
    for light in 0..lights {
        let (mut states, mut to_light) = ([0; BLOCK], PathBlock::default());
        let to = LightPoint { light, point: light, count: [0, 3][light as usize % 2] };
        program.rays_to_light_block(to, found, lanes, (&placed, &hits), &mut states, &mut to_light);
        say(&mut said, |place| (states[place], to_light.get(place)));
        let visible = &mut visible[light as usize];
        program.visible_block(light, found, lanes, (&placed, &hits), visible);
        say(&mut said, |place| visible[place]);
    }
    let mut pixels = PixelOutBlock::default();
    program.shade_block(rays.points, found, lanes, (&placed, &hits, &visible), &mut pixels);
    say(&mut said, |place| pixels.get(place));
    said
}

fn say<T: Debug>(said: &mut [Vec<String>; BLOCK], of: impl Fn(usize) -> T) {
    for (place, said) in said.iter_mut().enumerate() {
        said.push(format!("{:?}", of(place)));
    }
}

/// A frame whose rays are about that one, from an eye or side by side, with lights of both kinds.
fn frame(ray: &PixelIn, rng: &mut Rng) -> Frame {
    let four = |v: relief_shaders::cpu::Vec3<f32>| Vec4::from([v.x, v.y, v.z, 0.0]);
    let size = (ray.direction.x.abs() + ray.direction.y.abs() + ray.direction.z.abs()) * 0.003;
    let mut aside = |scale: f32| {
        let mut number = || rng.between(-1.0, 1.0) as f32 * scale;
        Vec4::from([number(), number(), number(), 0.0])
    };
    let [right, down, eye_right, eye_down, forward] = [size, size, 0.01, 0.01, 1.0].map(&mut aside);
    let lights: [Light; MAX_LIGHTS] = std::array::from_fn(|number| {
        let mut place = aside(3.0);
        place.w = (number % 2) as f32;
        let color = Vec4::from([1.0, 0.5, 0.25, 0.1]);
        Light { place, color, first_view: 0, views: 0 }
    });
    let is_parallel = rng.below(2) == 0;
    let nothing = Vec4::from([0.0; 4]);
    Frame {
        eye: four(ray.origin),
        eye_right: if is_parallel { eye_right } else { nothing },
        eye_down: if is_parallel { eye_down } else { nothing },
        corner: four(ray.direction),
        right: if is_parallel { nothing } else { right },
        down: if is_parallel { nothing } else { down },
        forward,
        ambient: Vec4::from([0.3, 0.2, 0.1, 0.0]),
        sample_width: rng.pick(&[1.0, 8.0]) as f32,
        lights,
        light_count: 3,
        ..Frame::none()
    }
}

/// The surface that a number stands for: all shadows and lights from all around in turn.
fn surface(surface: usize, detail: usize, number: usize, named: &maps::NamedMap) -> Option<JobSurface> {
    let own = |stage: usize| -> Vec<&'static str> {
        STAGES[stage].entries.iter().map(|entry| entry.name).filter(|name| is_own(name)).collect()
    };
    let (shadows, ambients) = (own(SHADOW), own(AMBIENT));
    let surface = STAGES[SURFACE].entries[surface].name;
    let is_sliced = surface == "slices";
    let method = if is_sliced { "slices-surface" } else { ["relief", "exact", "cone"][number % 3] };
    let mut selection = Selection::method(method).expect("a method");
    if is_sliced {
        for (key, value) in [("slices.test", number % 3), ("slices.refine", number / 3 % 3)] {
            selection.set(key, value as f64).expect("a setting");
        }
    }
    let chosen = [
        (SURFACE, surface),
        (DETAIL, STAGES[DETAIL].entries[detail].name),
        (SHADOW, shadows[number % shadows.len()]),
        (AMBIENT, ambients[number / 2 % ambients.len()]),
        (SHADE, STAGES[SHADE].entries[number % STAGES[SHADE].entries.len()].name),
    ];
    for (stage, name) in chosen {
        selection.choose(STAGES[stage].key, name).expect("a listed name");
    }
    selection.check().ok()?;
    for value in selection.choices.iter_mut().flat_map(|choice| &mut choice.params) {
        *value = value.min(LONGEST_LOOP);
    }
    let wrap = Wrap::ALL[number % Wrap::ALL.len()];
    let (scale_m, bias_m) = [(0.06, -0.06), (0.1, -0.04), (0.3, 0.0)][number % 3];
    let map = named.build(wrap).with_displacement(scale_m, bias_m).expect("lengths");
    let map = Arc::new(with_holes(map));
    let format = MapFormat::ALL[number % MapFormat::ALL.len()];
    let mut made = bare_surface(Arc::clone(&map), selection, maps_in(format, &map, &selection));
    if selection.choices[AMBIENT].entry.name == "environment" {
        made.maps.push((MapSlot::Environment, Arc::clone(Environment::sky().map())));
        let with_sky = SurfaceSettings::tracing(&map, &selection, &made.slots());
        made.settings =
            SurfaceSettings { shell_m: made.settings.shell_m, ior: 1.3, transmission: 0.4, ..with_sky };
    }
    made.settings.diffuse = [0.7, 0.6, 0.5, 0.0].into();
    made.settings.specular = [0.2, 0.3, 0.4, 0.0].into();
    made.settings.shininess = [1, 30, 999][number % 3];
    let (materials, size) = material_maps(wrap);
    made.settings.emission = [0.2, 0.1, 0.3, 0.0].into();
    made.settings.roughness = [0.0, 0.5, 1.0][number % 3];
    made.settings.metallic = 0.8;
    made.settings.has_material = (number / 2 % 4) as u32;
    (made.settings.material_size, made.settings.material_levels) = (size.into(), materials.levels());
    made.material_maps = Some(Arc::new(materials));
    made.settings.has_creases = u32::from(number.is_multiple_of(2));
    made.settings.has_holes = u32::from(number.is_multiple_of(3));
    Some(made)
}

/// Maps of a material with all kinds, with their levels and their size.
fn material_maps(wrap: Wrap) -> (Mipmaps, [u32; 2]) {
    let texel = |at: u32| std::array::from_fn(|part| (at as f32 * 0.37 + part as f32 * 0.21).fract());
    let picture = || Some(Picture { width: 5, height: 3, texels: (0..15).map(texel).collect() });
    let mut pictures = MaterialPictures::default();
    for kind in [MaterialMap::Packed, MaterialMap::Emission] {
        pictures[kind as usize] = picture();
    }
    let maps = MaterialMaps::new(&pictures, wrap).expect("maps of a material");
    (Mipmaps::of_materials(&maps, true), maps.size())
}

/// The map with a texel in seven that is a hole.
fn with_holes(map: HeightMap) -> HeightMap {
    let (width, height) = (map.width(), map.height());
    let holes = TexelMask::from_fn(width, height, |i, j| (i * 3 + j * 5) % 7 == 0);
    map.with_holes(holes).expect("a mask of the map's size")
}

/// Blocks of 4 x 4 pixels.
fn points() -> [Row<f32>; 2] {
    let of = |place: fn(usize) -> usize| std::array::from_fn(|at| place(at) as f32);
    [of(|at| at % 4), of(|at| at / 4)]
}

#[test]
fn pixels_have_the_bits_of_one_by_one() {
    // Objects of images are asked for one ray at a time.
    let of_meshes = ENTRIES.iter().enumerate().filter(|(_, entry)| !entry.paths().shown.is_of_images());
    let of_meshes: Vec<usize> = of_meshes.map(|(place, _)| place).collect();
    let surfaces = of_meshes.len();
    let details = STAGES[DETAIL].entries.len();
    let cases: Vec<[usize; 3]> = (0..surfaces * details * maps::ALL.len())
        .map(|case| [of_meshes[case % surfaces], case / surfaces % details, case / surfaces / details])
        .collect();
    let counts = cases.par_iter().enumerate().map(|(case, &[on, detail, map])| {
        let number = case * 5 + case / 7;
        let Some(surface) = surface(on, detail, number, &maps::ALL[map]) else { return [0; 3] };
        let mut rng = Rng::new(number as u64);
        let map = &surface.height_map;
        let mut counts = [1, 0, 0];
        let pixels = match surface.selection.uses(SLICES) {
            true => rays::sliced_pixels(map, TRIANGLES, number as u64),
            false => rays::bent_pixels(map, TRIANGLES, number as u64),
        };
        for (turn, mut ray) in pixels.into_iter().enumerate() {
            let is_shell = surface.selection.paths().proposal == Proposal::Shells;
            if is_shell && ray.a.uv.x.abs().max(ray.a.uv.y.abs()) > MOST_TILES {
                continue;
            }
            match (number + turn) % 23 {
                // A way through a shell has no end where the ray has none.
                _ if is_shell => {}
                3 => ray.b = ray.c,
                7 => ray.origin.y = f32::NAN,
                13 => ray.a.position.x = f32::INFINITY,
                17 => ray.direction = [0.0; 3].into(),
                _ => {}
            }
            let frame = frame(&ray, &mut rng);
            let program = surface.program(frame, None);
            let triangle = Triangle { a: ray.a, b: ray.b, c: ray.c, shell: ray.shell };
            let points = points();
            let rays = TriangleRays { triangle: &triangle, side: ray.side, points: &points };
            let which = if turn % 3 == 0 { rng.bits() as u16 } else { u16::MAX };
            let one = answers(&program, rays, which, frame.light_count, Lanes::One);
            counts[1] += which.count_ones() as usize;
            counts[2] += one.iter().filter(|said| said[2].contains("found: 1")).count();
            for lanes in Lanes::available() {
                let many = answers(&program, rays, which, frame.light_count, lanes);
                for (place, (many, one)) in many.iter().zip(&one).enumerate() {
                    let step = many.iter().zip(one).position(|(many, one)| many != one);
                    assert!(
                        step.is_none(),
                        "{lanes} lanes, place {place} of {which:016b}, turn {turn}, {:?}\n{:?}\n{:?}",
                        surface.selection.choices.map(|choice| choice.entry.name),
                        step.map(|step| &many[step]),
                        step.map(|step| &one[step]),
                    );
                }
            }
        }
        counts
    });
    let sum = |a: [usize; 3], b: [usize; 3]| [0, 1, 2].map(|k| a[k] + b[k]);
    let [surfaces, rays, hits] = counts.reduce(|| [0; 3], sum);
    println!("{surfaces} surfaces, {rays} rays, {hits} hits");
    assert!(surfaces > cases.len() / 2 && hits > rays / 5, "{surfaces} of {}, {hits} of {rays}", cases.len());
}

#[test]
fn a_setting_that_is_another_one_is_noticed() {
    let named = maps::ALL.iter().find(|map| map.name == "natural 101x67").expect("it is listed");
    let own = surface(0, 1, 12, named).expect("a surface");
    type Change = fn(&mut JobSurface);
    let changes: [Change; 3] = [
        |surface| surface.settings.scale_m *= 1.001,
        |surface| surface.settings.shininess += 1,
        |surface| surface.settings.has_creases ^= 1,
    ];
    let (mut rng, points) = (Rng::new(3), points());
    let mut noticed = [0; 3];
    for ray in rays::pixels(&own.height_map, 60, 3) {
        let frame = frame(&ray, &mut rng);
        let triangle = Triangle { a: ray.a, b: ray.b, c: ray.c, shell: ray.shell };
        let rays = TriangleRays { triangle: &triangle, side: ray.side, points: &points };
        let of = |surface: &JobSurface, lanes| {
            answers(&surface.program(frame, None), rays, u16::MAX, frame.light_count, lanes)
        };
        let one = of(&own, Lanes::One);
        for (noticed, change) in noticed.iter_mut().zip(changes) {
            let mut other = own.clone();
            change(&mut other);
            *noticed += usize::from(of(&other, Lanes::widest()) != one);
        }
    }
    assert!(noticed.iter().all(|noticed| *noticed > 5), "{noticed:?}");
}
