//! Maps, settings and stages to send rays through.

use std::sync::Arc;

use crate::baked::{in_slots, maps_in, slots};
use relief_core::registry::MAX_PARAMS;
use relief_core::rng::Rng;
use relief_core::{BakedMap, HeightMap, MapFormat, Wrap};
use relief_render::job::JobSurface;
use relief_shaders::cpu::{Entered, Frame, Path, PixelIn, Probe, Program, Shared, SurfaceSettings};
use relief_shaders::{DETAIL, Entry, SEARCH, SHADOW, SHADOW_SEARCH, STAGES, Selection, surface};
use relief_testing::maps::NamedMap;

/// The most steps of axes and terms of compressed maps that are baked, more than the least.
const MOST_DIRECTIONS: [(&str, f32); 5] =
    [("azimuths", 1.0), ("elevations", 1.0), ("bends", 2.0), ("rank", 5.0), ("clusters", 3.0)];

/// The most cells or steps that a stage may take in these tests. A software adapter (Mesa's llvmpipe) leaves
/// a shader's loops after 65,535 turns, all loops counted together; search and refinement must stay below
/// that.
const LONGEST_LOOP: f32 = 16_384.0;

/// Longest loop for each ray of a shadow, which may have many rays.
const LONGEST_LOOP_OF_SHADOW: f32 = 1_024.0;

/// The most rays of a shadow in these tests.
const MOST_RAYS_OF_SHADOW: f32 = 3.0;

/// The thickness of shells of relief without any, in metres.
pub(super) const LEAST_SHELL_M: f32 = 1e-3;

/// A map and the settings of a search and a refinement.
pub struct Case {
    /// Name of the selection, for messages.
    pub name: String,
    /// The map, with its displacement.
    pub map: Arc<HeightMap>,
    surface: JobSurface,
}

/// Stages with parameters, a displacement and rays that are drawn at random.
pub struct Draw {
    selection: Selection,
    scale_m: f64,
    bias_m: f64,
    /// Seed of the rays.
    pub seed: u64,
}

impl Draw {
    /// The next draw; in the finest level where the search's map has no other.
    pub fn new(pair: [&Entry; 2], shadow: [&Entry; 2], detail: &Entry, rng: &mut Rng) -> Self {
        Self::on(&surface::ENTRIES[0], pair, shadow, detail, rng)
    }

    /// Returns the next draw on a surface.
    pub fn on(
        surface: &Entry,
        [search, refine]: [&Entry; 2],
        shadow: [&Entry; 2],
        detail: &Entry,
        rng: &mut Rng,
    ) -> Self {
        let scale_m = rng.pick(&[1.0, 1.0, 0.1, 0.02, 3.0, 0.0]);
        let bias_m = rng.pick(&[-1.0, -1.0, 0.0, -0.3, 0.5]) * scale_m;
        let mut selection = Selection::pair(search.name, refine.name).expect("listed names");
        selection.choose("surface", surface.name).expect("a listed name");
        for (stage, entry) in [SHADOW, SHADOW_SEARCH].into_iter().zip(shadow) {
            selection.choose(STAGES[stage].key, entry.name).expect("a listed name");
        }
        let finest = selection;
        selection.choose(STAGES[DETAIL].key, detail.name).expect("a listed name");
        if selection.check_levels().is_err() {
            selection = finest;
        }
        for choice in &mut selection.choices {
            choice.params = params(choice.entry, rng);
        }
        shorten(&mut selection);
        Self { selection, scale_m, bias_m, seed: rng.bits() }
    }

    /// The case of that draw over a map.
    pub fn over(&self, map: &NamedMap, wrap: Wrap, format: MapFormat) -> Case {
        let Draw { selection, scale_m, bias_m, .. } = self;
        let stages = selection.choices.map(|choice| format!("{} {:?}", choice.entry.name, choice.params));
        let name = format!("{}, {} {wrap}, scale {scale_m}, bias {bias_m}", stages.join(", "), map.name);
        let map = map.build(wrap).with_displacement(*scale_m, *bias_m).expect("proper numbers");
        Case::with(name, map, *selection, format)
    }
}

impl Case {
    fn with(name: String, map: HeightMap, selection: Selection, format: MapFormat) -> Self {
        let map = Arc::new(map);
        let surface = bare_surface(Arc::clone(&map), selection, maps_in(format, &map, &selection));
        Self { name, map, surface }
    }

    /// A case of two stages by name, with default parameters.
    pub fn of(search: &str, refine: &str, map: HeightMap) -> Self {
        Self::on("plane", search, refine, map)
    }

    /// Creates a case on a surface.
    pub fn on(surface: &str, search: &str, refine: &str, map: HeightMap) -> Self {
        let mut selection = Selection::pair(search, refine).expect("listed names");
        selection.choose("surface", surface).expect("a listed name");
        shorten(&mut selection);
        let name = format!("{surface}, {search}, {refine}, {}", map.wrap());
        Self::with(name, map, selection, MapFormat::F32)
    }

    /// Slices by a method, with settings, over a map.
    pub fn of_slices(method: &str, set: &[(&str, f64)], map: HeightMap) -> Self {
        let mut selection = Selection::method(method).expect("a method");
        for (key, value) in set {
            selection.set(key, *value).expect("a setting");
        }
        Self::with(format!("{method} {set:?}"), map, selection, MapFormat::F32)
    }

    /// Another value of a setting, by its key. Maps that the stages read stay as they are.
    pub fn set(&mut self, key: &str, value: f64) {
        self.surface.selection.set(key, value).expect("a setting");
        let surface = &mut self.surface;
        let choices = surface.selection.choices.map(|choice| (&choice).into());
        surface.settings = SurfaceSettings { choices, ..surface.settings };
    }

    /// Returns the input of the probe.
    pub fn surface(&self) -> &JobSurface {
        &self.surface
    }

    /// Returns the program of the translated stages.
    pub fn program(&self) -> Program<'_> {
        self.surface.program(Frame::none(), None)
    }

    /// Returns the results of the translated stages for rays.
    pub fn on_cpu(&self, rays: &[PixelIn]) -> Vec<Probe> {
        let program = self.program();
        rays.iter().map(|ray| probe(&program, ray, 0.0)).collect()
    }
}

/// A surface without a mesh, a light or a colour.
pub fn bare_surface(map: Arc<HeightMap>, selection: Selection, maps: Vec<BakedMap>) -> JobSurface {
    let settings = SurfaceSettings::tracing(&map, &selection, &slots(&map, &selection, &maps));
    let settings = settings.with_least_shell(&map, LEAST_SHELL_M);
    JobSurface {
        settings,
        selection,
        triangles: Arc::default(),
        height_map: map,
        color: None,
        normal_map: None,
        material_maps: None,
        maps: in_slots(&selection, maps),
        two_sided: false,
    }
}

/// The stages over a ray whose path lies `higher` heights above the ray's own, as the probe shader writes
/// them down.
pub fn probe(program: &Program, ray: &PixelIn, higher: f32) -> Probe {
    let at = program.enter(*ray);
    let mut probe = Probe::read(&[0; Probe::SIZE]);
    for number in 0..at.segments {
        let mut path = program.segment(*ray, at, number);
        if path.exit > 0.0 {
            path.h.x += higher;
            probe = probe_segment(program, ray, at, number, path);
        }
        if probe.found == 1 {
            break;
        }
    }
    probe
}

/// The stages over a segment of a ray.
fn probe_segment(program: &Program, ray: &PixelIn, at: Entered, number: u32, path: Path) -> Probe {
    let found = program.search(path);
    let mut hit = program.refine(path, found);
    if hit.found == 1 {
        hit = program.polish(*ray, at, path, hit);
    }
    Probe {
        segment: number + 1,
        entry: path.uv,
        duv: path.duv,
        exit: path.exit,
        base: path.base,
        h: path.h,
        status: found.status,
        near: found.near,
        far: found.far,
        found: hit.found,
        exhausted: hit.exhausted,
        uv: hit.uv,
        height: hit.height,
        t: hit.t,
        reads: hit.cost.x,
        steps: hit.cost.y,
        bytes: hit.cost.z,
        lit: program.mirrored_light(*ray, program.place(*ray, at, number, hit), hit),
        key: program.key(*ray, path, hit),
    }
}

/// An entry's parameters: a third of them drawn from their range, the others at their default.
fn params(entry: &Entry, rng: &mut Rng) -> [f32; MAX_PARAMS] {
    let mut values = entry.defaults();
    for (value, param) in values.iter_mut().zip(entry.params) {
        if rng.below(3) == 0 {
            *value = rng.between(param.min.into(), param.max.min(16.0).into()) as f32;
            if param.integer {
                *value = value.round();
            }
        }
    }
    values
}

/// Caps cells, steps and rays, so that a software adapter does not leave the loops.
fn shorten(selection: &mut Selection) {
    for value in selection.choices.iter_mut().flat_map(|choice| &mut choice.params) {
        *value = value.min(LONGEST_LOOP);
    }
    // Every direction is baked, of every texel.
    let search = &mut selection.choices[SEARCH];
    for (name, most) in MOST_DIRECTIONS {
        if let Some((place, param)) = search.entry.param(name) {
            search.params[place] = search.params[place].min(param.min + most);
        }
    }
    if selection.uses(SHADOW_SEARCH) {
        let rays = &mut selection.choices[SHADOW].params[0];
        *rays = rays.min(MOST_RAYS_OF_SHADOW);
    }
    for value in &mut selection.choices[SHADOW_SEARCH].params {
        *value = value.min(LONGEST_LOOP_OF_SHADOW);
    }
}
