//! Grass on a mesh by every method that shows it, beside the same grass as triangles.

use std::sync::Arc;
use std::time::Instant;

use glam::{DVec3, Vec2, Vec3};
use relief_bake::volumes::{Fit, MeshVolumeSettings, volume_from_mesh};
use relief_compare::picture::{Image, PIXELS_PER_DEGREE, flip};
use relief_core::camera::Camera;
use relief_core::mesh::{Mesh, RawMesh, torus};
use relief_core::{HeightMap, Path, Volume, Watch, Wrap};
use relief_maps::Maps;
use relief_mesh::motif::{MotifKind, MotifSettings, motif};
use relief_mesh::shell_map::{ShellMapSettings, map_shells, motif_for_rays};
use relief_render::{Renderer, render};
use relief_scene::material::Material;
use relief_scene::{BackendChoice, Sampling, Scene, Surface};
use relief_shaders::Selection;

use crate::memory;
use crate::table::table;

/// Tiles along the texture of the mesh, and metres of the blades.
const TILES: f32 = 14.0;
const SCALE_M: f64 = 0.05;

/// Columns, rows and slices of the volume; columns and rows of the highest heights.
const VOXELS: [u32; 3] = [64, 64, 32];
const HEIGHTS: u32 = 256;

/// Blades in a tile.
const BLADES: u32 = 90;

/// Samples of a pixel of the reference, and of the others where pictures are compared.
const REFERENCE_SAMPLES: u32 = 256;
const SAMPLES: u32 = 16;

/// Frames that are timed; the fastest counts, so that what compiles and bakes is left out.
const FRAMES: usize = 3;

/// A method with settings and a surface, by its name in the table.
struct Shown {
    name: &'static str,
    method: &'static str,
    surface: Option<&'static str>,
    set: &'static [(&'static str, f64)],
}

const ALL: [Shown; 6] = [
    Shown {
        name: "`slices-surface`, 16 shells",
        method: "slices-surface",
        surface: None,
        set: &[("slices.count", 16.0)],
    },
    Shown {
        name: "`slices-surface`, 64 shells",
        method: "slices-surface",
        surface: None,
        set: &[("slices.count", 64.0)],
    },
    Shown { name: "`voxels`", method: "voxels", surface: Some("tetrahedra"), set: &[] },
    Shown {
        name: "`translucent`",
        method: "translucent",
        surface: None,
        set: &[("search.extinction", 400.0)],
    },
    Shown { name: "`generalised`", method: "generalised", surface: None, set: &[] },
    Shown { name: "`shell-map`", method: "shell-map", surface: None, set: &[] },
];

/// What all methods show.
struct Grass {
    base: Arc<Mesh>,
    blades: RawMesh,
    camera: Camera,
    size: [u32; 2],
}

/// Prints the table.
pub fn run(size: [u32; 2]) -> Result<(), String> {
    let (name, base) = match relief_tests::spot("spot_triangulated.obj") {
        Some(spot) => ("spot", spot),
        None => ("a torus", torus(64, 32).map_err(|error| error.to_string())?),
    };
    let base = base.tiled(Vec2::splat(TILES)).map_err(|error| error.to_string())?;
    let settings = MotifSettings { count: BLADES, thickness: 1.0, ..MotifSettings::new(MotifKind::Grass) };
    let blades: RawMesh = (&motif(&settings).map_err(|error| error.to_string())?.mesh).into();
    let eye = DVec3::new(1.8, 1.3, -2.7);
    let camera = Camera::new(eye, DVec3::new(0.0, 0.1, 0.0), 26.0).map_err(|error| error.to_string())?;
    let grass = Grass { base: Arc::new(base), blades, camera, size };
    println!(
        "{name}, {} triangles, {TILES}x{TILES} tiles of {BLADES} blades, {} triangles; {}x{} pixels without \
         shadows.\n",
        grass.base.triangles().len(),
        grass.blades.triangles.len(),
        size[0],
        size[1]
    );
    let mut rows = table(&[
        "method",
        "silhouettes, IoU",
        "FLIP",
        "bytes held",
        "prepared in, s",
        "frame CPU, ms",
        "frame GPU, ms",
    ]);
    let judge = Kit::new(&grass, BackendChoice::Cpu, &|| grass.forward())?;
    let truth = judge.outline(&grass)?;
    let picture = judge.picture(REFERENCE_SAMPLES)?;
    let mut add = |name: &str, make: &dyn Fn() -> Result<Surface, String>| {
        let kit = Kit::new(&grass, BackendChoice::Cpu, make)?;
        let outline = kit.outline(&grass)?;
        let count = |keep: fn(bool, bool) -> bool| {
            truth.iter().zip(&outline).filter(|(a, b)| keep(**a, **b)).count() as f64
        };
        let overlap = count(|a, b| a && b) / count(|a, b| a || b);
        let off =
            flip(&picture, &kit.picture(SAMPLES)?, PIXELS_PER_DEGREE).map_err(|error| error.to_string())?;
        let cpu_ms = kit.frame_ms()?;
        let gpu = Kit::new(&grass, BackendChoice::Gpu, make).and_then(|kit| kit.frame_ms());
        rows.add_row([
            name.to_owned(),
            format!("{overlap:.3}"),
            format!("{:.3}", off.mean()),
            format!("{:.1} MB", kit.bytes as f64 / 1e6),
            format!("{:.2}", kit.prepared_s),
            format!("{cpu_ms:.0}"),
            gpu.map_or_else(|_| "-".to_owned(), |ms| format!("{ms:.0}")),
        ]);
        Ok::<(), String>(())
    };
    add("triangles", &|| grass.forward())?;
    for shown in &ALL {
        add(shown.name, &|| grass.shown(shown))?;
    }
    println!("{rows}\n");
    Ok(())
}

impl Grass {
    /// The grass as triangles.
    fn forward(&self) -> Result<Surface, String> {
        let shells = ShellMapSettings { scale_m: SCALE_M, ..ShellMapSettings::default() };
        let made = map_shells(&self.base, &self.blades, &shells, &Watch::none());
        let mesh = made.map_err(|error| error.to_string())?.mesh;
        Ok(green(Surface::new(mesh, ground()?))?
            .with_selection(without_shadow(Selection::exact())?)
            .with_two_sided(true))
    }

    /// The grass by a method.
    fn shown(&self, shown: &Shown) -> Result<Surface, String> {
        let mut selection = Selection::method(shown.method).map_err(|error| error.to_string())?;
        if let Some(surface) = shown.surface {
            selection.choose("surface", surface).map_err(|error| error.to_string())?;
        }
        for (key, value) in shown.set {
            selection.set(key, *value).map_err(|error| error.to_string())?;
        }
        let selection = without_shadow(selection)?;
        let base = Arc::clone(&self.base);
        let surface = match shown.method {
            "shell-map" => {
                let tree = motif_for_rays(&self.blades).map_err(|error| error.to_string())?.tree;
                Surface::new(base, ground()?)
                    .with_motif(tree, SCALE_M, 0.0)
                    .map_err(|error| error.to_string())?
            }
            "slices-surface" => Surface::new(base, highest(&self.volume()?)?),
            _ => Surface::new(base, ground()?).with_volume(self.volume()?),
        };
        Ok(green(surface)?.with_selection(selection))
    }

    fn volume(&self) -> Result<Volume, String> {
        let settings = MeshVolumeSettings { fit: Fit::Tile, ..MeshVolumeSettings::new(VOXELS) };
        let made = volume_from_mesh(&self.blades, &settings, &Watch::none());
        let volume = made.map_err(|error| error.to_string())?.volume;
        volume.with_displacement(SCALE_M, 0.0).map_err(|error| error.to_string())
    }

    /// The mesh below, on which the grass stands.
    fn earth(&self) -> Result<Surface, String> {
        let surface = Surface::new(Arc::clone(&self.base), ground()?);
        Ok(surface
            .with_material(of_color([0.25, 0.16, 0.1])?)
            .with_selection(without_shadow(Selection::exact())?))
    }
}

fn green(surface: Surface) -> Result<Surface, String> {
    Ok(surface.with_material(of_color([0.2, 0.5, 0.1])?))
}

fn of_color(color: [f32; 3]) -> Result<Material, String> {
    Material::new(color.into(), Vec3::ZERO, 1).map_err(|error| error.to_string())
}

fn without_shadow(mut selection: Selection) -> Result<Selection, String> {
    selection.choose("shadow", "none").map_err(|error| error.to_string())?;
    Ok(selection)
}

fn ground() -> Result<HeightMap, String> {
    HeightMap::new(1, 1, vec![0.0], Wrap::Repeat).map_err(|error| error.to_string())
}

/// The highest heights of a volume.
fn highest(volume: &Volume) -> Result<HeightMap, String> {
    let height = |i: u32, j: u32| {
        let [u, v] = [i, j].map(|at| (f64::from(at) + 0.5) / f64::from(HEIGHTS));
        let path = Path::between([u, v, 1.0], [u, v, 0.0]);
        volume.first_hit(&path).map_or(0.0, |hit| path.at(hit.t)[2] as f32)
    };
    let map =
        HeightMap::from_fn(HEIGHTS, HEIGHTS, Wrap::Repeat, height).map_err(|error| error.to_string())?;
    map.with_displacement(SCALE_M, 0.0).map_err(|error| error.to_string())
}

/// Everything that a frame needs, and what it took to make it.
struct Kit {
    scene: Scene,
    backend: BackendChoice,
    bytes: usize,
    prepared_s: f64,
}

impl Kit {
    /// A scene, and the bytes and the time of it with all that a picture of one pixel needs on the CPU.
    fn new(
        grass: &Grass,
        backend: BackendChoice,
        make: &dyn Fn() -> Result<Surface, String>,
    ) -> Result<Self, String> {
        let started = Instant::now();
        let (made, bytes) = memory::held(|| {
            let surfaces = vec![make()?, grass.earth()?];
            let builder = Scene::builder(grass.earth()?).surfaces(surfaces).camera(grass.camera);
            let scene = builder.size(grass.size[0], grass.size[1]).samples(1).backend(backend).build();
            let scene = scene.map_err(|error| error.to_string())?;
            let one = scene.to_builder().size(1, 1).backend(BackendChoice::Cpu).build();
            let one = one.map_err(|error| error.to_string())?;
            let (mut renderer, mut maps) = (Renderer::on_cpu(), Maps::in_memory());
            let drawn = renderer.render(&one, &mut maps, &Watch::none());
            drawn.map_err(|error| error.to_string())?;
            Ok::<_, String>((scene, renderer, maps))
        });
        let prepared_s = started.elapsed().as_secs_f64();
        Ok(Self { scene: made?.0, backend, bytes, prepared_s })
    }

    /// Whether each pixel's centre shows the mesh or its grass.
    fn outline(&self, grass: &Grass) -> Result<Vec<bool>, String> {
        let rendered = render(&self.scene, &mut Maps::in_memory(), &Watch::none());
        let pixels = rendered.map_err(|error| error.to_string())?.rendering.pixels;
        assert_eq!(pixels.len() as u32, grass.size[0] * grass.size[1]);
        // Light from behind a volume that is half opaque is no outline.
        Ok(pixels.iter().map(|pixel| pixel.hit == 1 || pixel.transmittance < 0.5).collect())
    }

    fn picture(&self, samples: u32) -> Result<Image, String> {
        let scene = self.scene.to_builder().samples(samples).build().map_err(|error| error.to_string())?;
        let rendered = render(&scene, &mut Maps::in_memory(), &Watch::none());
        let rendering = rendered.map_err(|error| error.to_string())?.rendering;
        Image::of(&rendering, &scene).map_err(|error| error.to_string())
    }

    /// Milliseconds of a frame of one sample by a renderer that has made one.
    fn frame_ms(&self) -> Result<f64, String> {
        let mut renderer = Renderer::new(self.backend, Sampling::Exact).map_err(|error| error.to_string())?;
        let mut maps = Maps::in_memory();
        let mut fastest = f64::INFINITY;
        for _ in 0..FRAMES {
            let started = Instant::now();
            let drawn = renderer.render(&self.scene, &mut maps, &Watch::none());
            drawn.map_err(|error| error.to_string())?;
            fastest = fastest.min(1e3 * started.elapsed().as_secs_f64());
        }
        Ok(fastest)
    }
}
