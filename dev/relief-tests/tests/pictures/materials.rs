//! The shading `metallic-roughness` beside the model of glTF in `f64`.

use std::f64::consts::PI;

use glam::DVec3;
use rayon::prelude::*;
use relief_core::rng::Rng;
use relief_core::{HeightMap, Wrap};
use relief_shaders::cpu::{Bound, ColorTexture, Frame, HeightTexture, HoleTexture, Program, SurfaceSettings};
use relief_shaders::{Selection, SlotMaps};

/// A material: base colour, metalness and roughness.
#[derive(Clone, Copy, Debug)]
struct Model {
    base: DVec3,
    metallic: f64,
    roughness: f64,
    /// Exponent of Schlick's formula: 5.
    fresnel: i32,
    /// Whether light that facets reflect more than once is left out.
    once: bool,
}

/// The directions of normal, view and light.
type Directions = [DVec3; 3];

/// The light of each of `columns` x `rows` directions that facets reflect to a view, and the means
/// over all directions.
fn mean_over_facets(
    view: DVec3,
    alpha: f64,
    [columns, rows]: [u32; 2],
    light: impl Fn(DVec3, f64, f64) -> f64,
) -> f64 {
    let mut sum = 0.0;
    for place in 0..columns * rows {
        let [column, row] = [place % columns, place / columns].map(|at| f64::from(at) + 0.5);
        let at = [column / f64::from(columns), row / f64::from(rows)];
        if let Some((toward, weight, cosine)) = facet(view, alpha, at) {
            sum += light(toward, weight, cosine);
        }
    }
    sum / f64::from(columns * rows)
}

/// A direction of light that a facet reflects to the view, drawn by how much facets are seen
/// (Dupuy and Benyoub 2023), with the part of it that others do not hide, and its cosine to the
/// facet's normal.
fn facet(view: DVec3, alpha: f64, at: [f64; 2]) -> Option<(DVec3, f64, f64)> {
    let stretched = DVec3::new(alpha * view.x, alpha * view.y, view.z).normalize();
    let z = (1.0 - at[0]) * (1.0 + stretched.z) - stretched.z;
    let (sine, angle) = ((1.0 - z * z).max(0.0).sqrt(), 2.0 * PI * at[1]);
    let half = DVec3::new(sine * angle.cos(), sine * angle.sin(), z) + stretched;
    let half = DVec3::new(alpha * half.x, alpha * half.y, half.z).normalize();
    let cosine = view.dot(half);
    let toward = half * (2.0 * cosine) - view;
    if toward.z <= 0.0 {
        return None;
    }
    let hidden = |z: f64| ((1.0 + alpha * alpha * (1.0 - z * z) / (z * z)).sqrt() - 1.0) / 2.0;
    let weight = (1.0 + hidden(view.z)) / (1.0 + hidden(view.z) + hidden(toward.z));
    Some((toward, weight, cosine))
}

/// The reflected light under an irradiance of 1: glTF 2.0, appendix B.3, times pi, with Turquin's
/// factor for `all`, the part that white facets reflect once.
fn reflected(model: &Model, [normal, view, toward]: Directions, all: f64) -> DVec3 {
    let half = (view + toward).normalize();
    let (lit, seen) = (normal.dot(toward), normal.dot(view));
    let alpha = model.roughness.max(0.045).powi(2);
    let squared = alpha * alpha;
    let upright = normal.dot(half);
    let spread = upright * upright * squared + normal.cross(half).length_squared();
    let distribution = squared / (PI * spread * spread);
    let hidden = |a: f64, b: f64| a * (b * b * (1.0 - squared) + squared).sqrt();
    let visibility = 0.5 / (hidden(lit, seen) + hidden(seen, lit));
    let specular = DVec3::splat(0.04).lerp(model.base, model.metallic);
    let fresnel = specular + (1.0 - specular) * (1.0 - view.dot(half)).powi(model.fresnel);
    let diffuse = model.base * (1.0 - model.metallic) * (1.0 - fresnel);
    let again = if model.once { DVec3::ONE } else { 1.0 + specular * (1.0 / all - 1.0) };
    (diffuse + fresnel * again * (distribution * visibility * PI)) * lit
}

/// Light reflected by the shaders.
struct Shader {
    map: HeightMap,
    selection: Selection,
}

impl Shader {
    fn new() -> Self {
        let map = HeightMap::new(1, 1, vec![1.0], Wrap::Repeat).expect("a map");
        let mut selection = Selection::method("bump").expect("a method");
        selection.choose("shade", "metallic-roughness").expect("a shading");
        Self { map, selection }
    }

    fn settings(&self, model: &Model) -> SurfaceSettings {
        let [red, green, blue] = model.base.as_vec3().to_array();
        SurfaceSettings {
            diffuse: [red, green, blue, 0.0].into(),
            specular: [0.04, 0.04, 0.04, 0.0].into(),
            roughness: model.roughness as f32,
            metallic: model.metallic as f32,
            ..SurfaceSettings::tracing(&self.map, &self.selection, &SlotMaps::default())
        }
    }

    fn bound<'a>(&'a self, settings: SurfaceSettings, materials: ColorTexture<'a>) -> Bound<'a> {
        Bound {
            frame: Frame::none(),
            surface_settings: settings,
            height_map: HeightTexture::new(&self.map, 1),
            hole_map: HoleTexture::new(None),
            color_map: ColorTexture::BLANK,
            normal_map: ColorTexture::BLANK,
            material_map: materials,
            maps: SlotMaps::default(),
        }
    }

    fn light(&self, model: &Model, directions: Directions) -> DVec3 {
        let program = Program::new(&self.bound(self.settings(model), ColorTexture::BLANK));
        light(&program, directions)
    }
}

fn light(program: &Program, directions: Directions) -> DVec3 {
    let directions = directions.map(|direction| direction.as_vec3().to_array());
    let light = program.reflected([1.0; 3], [0.5; 2], directions);
    DVec3::new(light.x.into(), light.y.into(), light.z.into())
}

/// A random direction.
fn random(rng: &mut Rng) -> DVec3 {
    loop {
        let [x, y, z] = [(); 3].map(|()| rng.between(-1.0, 1.0));
        let vector = DVec3::new(x, y, z);
        if (0.01..1.0).contains(&vector.length_squared()) {
            return vector.normalize();
        }
    }
}

/// Random directions on the side of a random normal, at cosines of at least 0.02; every other light
/// is near the mirrored view.
fn directions(rng: &mut Rng, roughness: f64) -> Directions {
    loop {
        let (normal, view, other) = (random(rng), random(rng), random(rng));
        let is_near = rng.below(2) == 0;
        let aside = roughness * roughness * rng.between(0.0, 4.0);
        let near = normal * (2.0 * normal.dot(view)) - view + other * aside;
        let toward = if is_near { near.normalize() } else { other };
        // What the shaders get: vectors of f32. Their length is 1 but for rounding, which the model is not to
        // undo: where both directions are opposite, it turns the half vector.
        let directions = [normal, view, toward].map(|direction| direction.as_vec3().as_dvec3());
        if directions[1].dot(directions[0]) > 0.02 && directions[2].dot(directions[0]) > 0.02 {
            return directions;
        }
    }
}

/// Greatest relative error of `light` beside `truth` over random directions and materials. The part
/// that white facets reflect is the shaders' own: another test judges it.
fn greatest_error(
    count: u64,
    truth: fn(&mut Model),
    light: impl Fn(&Shader, &Model, Directions) -> DVec3 + Sync,
) -> f64 {
    let shader = Shader::new();
    let errors = (0..64u64).into_par_iter().map(|part| {
        let mut rng = Rng::new(part);
        let mut greatest = 0.0f64;
        for _ in 0..count / 64 {
            let mut part = || f64::from(rng.between(0.0, 1.0) as f32);
            let (base, metallic) = (DVec3::new(part(), part(), part()), part());
            let roughness = f64::from((0.045 + 0.955 * part() * part()) as f32);
            let model = Model { base, metallic, roughness, fresnel: 5, once: false };
            let directions = directions(&mut rng, roughness);
            let mut right = model;
            truth(&mut right);
            let own = light(&shader, &model, directions);
            let all = all_of(&shader, roughness, directions);
            let right = reflected(&right, directions, all);
            let error = ((own - right).abs() / right).max_element();
            greatest = greatest.max(if error.is_nan() { f64::INFINITY } else { error });
        }
        greatest
    });
    errors.reduce(|| 0.0, f64::max)
}

/// The part that white facets reflect once, as the shaders have it. It depends on the view alone. So
/// it is taken from light of another direction, for which `f32` has all digits.
fn all_of(shader: &Shader, roughness: f64, [normal, view, _]: Directions) -> f64 {
    let aside = normal.any_orthonormal_vector();
    let toward =
        if normal.dot(view) < 0.9 { view } else { (normal * 0.5 + aside * 0.75f64.sqrt()).normalize() };
    let directions = [normal, view, toward];
    let white = Model { base: DVec3::ONE, metallic: 1.0, roughness, fresnel: 5, once: true };
    reflected(&white, directions, 1.0).x / shader.light(&white, directions).x
}

#[test]
fn light_is_what_the_model_of_gltf_reflects() {
    let error =
        greatest_error(1_000_000, |_| {}, |shader, model, directions| shader.light(model, directions));
    println!("greatest relative error: {error:.2e}");
    assert!(error <= 1e-4, "{error:e}");
}

#[test]
fn wrong_models_are_noticed() {
    let light = |shader: &Shader, model: &Model, directions| shader.light(model, directions);
    type Change = fn(&mut Model);
    let wrong: [(&str, Change); 3] = [
        ("another exponent of Fresnel's", |model| model.fresnel = 4),
        ("roughness for metalness", |model| std::mem::swap(&mut model.roughness, &mut model.metallic)),
        ("red for blue", |model| std::mem::swap(&mut model.base.x, &mut model.base.z)),
    ];
    for (what, change) in wrong {
        let error = greatest_error(20_000, change, light);
        assert!(error > 1e-2, "{what}: {error:e}");
    }
    // The sine of the half vector as 1 less the squared cosine, in f32.
    let subtracted = |shader: &Shader, model: &Model, directions: Directions| {
        let [normal, view, toward] = directions.map(|direction| direction.as_vec3());
        let half = (view + toward).normalize();
        let squared = (model.roughness as f32).powi(4);
        let upright = normal.dot(half);
        let by = |squared_sine: f32| f64::from(upright * upright * squared + squared_sine);
        let ratio = by(normal.cross(half).length_squared()) / by((1.0 - upright * upright).max(0.0));
        shader.light(model, directions) * ratio * ratio
    };
    let error = greatest_error(20_000, |_| {}, subtracted);
    assert!(error > 1e-3, "subtraction: {error:e}");
}

#[test]
fn white_metals_reflect_all_light() {
    let shader = Shader::new();
    for roughness in (0..20).map(|at| 0.045 + 0.955 * f64::from(at) / 19.0) {
        let white = Model { base: DVec3::ONE, metallic: 1.0, roughness, fresnel: 5, once: true };
        let program = Program::new(&shader.bound(shader.settings(&white), ColorTexture::BLANK));
        for degrees in (0..20).map(|at| 88.0 * f64::from(at) / 19.0) {
            let view = view_at(degrees);
            let all = mean_over_facets(view, roughness * roughness, [48, 96], |toward, weight, _| {
                // Directions are drawn as often as white facets send light there.
                let directions = [DVec3::Z, view, toward];
                light(&program, directions).x / reflected(&white, directions, 1.0).x * weight
            });
            assert!((all - 1.0).abs() <= 0.01, "roughness {roughness}, {degrees} degrees: {all}");
        }
    }
}

#[test]
fn light_from_all_around_is_the_integral_over_its_directions() {
    let shader = Shader::new();
    for roughness in [0.045f64, 0.1, 0.2, 0.4, 0.6, 0.8, 1.0] {
        for degrees in [0.0f64, 20.0, 40.0, 60.0, 75.0, 85.0] {
            let view = view_at(degrees);
            let alpha = roughness * roughness;
            let all = mean_over_facets(view, alpha, [64, 128], |_, weight, _| weight);
            for (base, metallic) in [(0.0, 0.0), (0.5, 0.0), (0.5, 1.0), (1.0, 1.0)] {
                let specular = 0.04 + (base - 0.04) * metallic;
                let once = mean_over_facets(view, alpha, [64, 128], |_, weight, cosine| {
                    weight * (specular + (1.0 - specular) * (1.0 - cosine).powi(5))
                });
                let mirrored = once * (1.0 + specular * (1.0 / all - 1.0));
                let right = base * (1.0 - metallic) * (1.0 - mirrored) + mirrored;
                let model = Model { base: DVec3::splat(base), metallic, roughness, fresnel: 5, once: false };
                let program = Program::new(&shader.bound(shader.settings(&model), ColorTexture::BLANK));
                let directions = [DVec3::Z, view].map(|direction| direction.as_vec3().to_array());
                let own = f64::from(program.reflected_from_around([1.0; 3], [0.5; 2], directions).x);
                let what =
                    format!("roughness {roughness}, {degrees} degrees, base {base}, metallic {metallic}");
                assert!((own - right).abs() <= 0.01, "{what}: {own} instead of {right}");
            }
        }
    }
}

fn view_at(degrees: f64) -> DVec3 {
    let angle = degrees.to_radians();
    DVec3::new(angle.sin(), 0.0, angle.cos())
}

#[test]
fn maps_multiply_the_values_of_the_material() {
    let shader = Shader::new();
    let mut rng = Rng::new(7);
    let model =
        Model { base: DVec3::new(0.5, 0.25, 0.75), metallic: 0.5, roughness: 0.25, fresnel: 5, once: false };
    let by_factors = Program::new(&shader.bound(shader.settings(&model), ColorTexture::BLANK));
    let texels = [[0.5f32, 0.5, 0.625, 0.0]];
    let materials = ColorTexture::new([1, 1], 1, &texels, &[]);
    let halves = Model { roughness: 0.5, metallic: 0.8, ..model };
    let settings = SurfaceSettings { has_material: 1, ..shader.settings(&halves) };
    let by_maps = Program::new(&shader.bound(settings, materials));
    for _ in 0..100 {
        let directions = directions(&mut rng, 0.25);
        assert_eq!(light(&by_factors, directions), light(&by_maps, directions));
    }
}
