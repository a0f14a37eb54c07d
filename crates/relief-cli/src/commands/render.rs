//! `relief render`: a scene to a picture. A baked map that the method reads is baked first and kept in a
//! cache.

mod baked_maps;
mod stages;

use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use relief_core::ByteSize;
use relief_io::{GreenSign, PngColour};
use relief_render::mesh::Builtin;
use relief_render::picture;
use relief_render::scene::{
    BackendChoice, Sampling, Scene, SceneError, SceneSpec, Surface, SurfaceSpec, ValueError, ValueProblem,
    read_scene,
};
use relief_render::{RenderError, Rendered};
use relief_shaders::METHODS;
use serde_json::json;

use self::baked_maps::CacheArguments;
use self::stages::StageArguments;
use super::maps::HeightArguments;
use crate::advice;
use crate::failure::Failure;
use crate::progress::{Progress, TaskProgress};
use crate::values;

/// What `relief render` is given. Flags override the scene file.
#[derive(Args)]
#[command(after_help = "Examples:\n  relief render --height data/bricks.png -o bricks.png\n  \
    relief render scenes/jacksboro.toml --size 1600x1200 -o jacksboro.png\n  \
    relief render --height map.exr --method occlusion --set search.steps=64 --aov map-aov.exr -o map.png\n\n\
    `relief methods` lists methods, searches and refinements with their settings.")]
pub struct Arguments {
    /// Scene file (TOML): its keys are named like the flags, which override it; paths in it are relative to
    /// it
    scene: Option<PathBuf>,
    /// Picture to write
    #[arg(short, long, value_name = "FILE.png")]
    output: PathBuf,
    /// Write numbers of every pixel, too, as 32-bit float channels: hit (1 or 0), uv.x and uv.y, height (0 to
    /// 1), P.x, P.y and P.z (position), N.x, N.y and N.z (normal), depth (along the view axis) and reads
    /// (of maps; where the CPU renders `exact`, nodes of its tracer)
    #[arg(long, value_name = "FILE.exr")]
    aov: Option<PathBuf>,
    /// Width and height of the picture in pixels [default: 800x600]
    #[arg(long, value_name = "WxH", value_parser = values::size, allow_hyphen_values = true)]
    size: Option<[u32; 2]>,
    /// Print one JSON object about the picture
    #[arg(long)]
    pub json: bool,

    /// Height map: PNG, JPEG, EXR, TIFF, GeoTIFF, HDR, PGM or headerless 16-bit raw
    #[arg(long, value_name = "FILE", help_heading = "Maps and mesh")]
    height: Option<PathBuf>,
    /// Colour map, in sRGB [default: the material alone]
    #[arg(long, value_name = "FILE", help_heading = "Maps and mesh")]
    color: Option<PathBuf>,
    /// Tangent-space normal map [default: normals from the height map]
    #[arg(long, value_name = "FILE", help_heading = "Maps and mesh")]
    normal: Option<PathBuf>,
    /// Where the normal map's green points: +y (up in the picture) or -y [default: +y]
    #[arg(long, value_name = "SIGN", allow_hyphen_values = true, help_heading = "Maps and mesh")]
    green: Option<GreenSign>,
    /// Base mesh: plane (in the proportions of the height map), square, cube, cylinder, sphere or torus
    /// [default: plane]
    #[arg(long, value_name = "MESH", help_heading = "Maps and mesh")]
    mesh: Option<Builtin>,
    /// Metres of displacement between heights 0 and 1 [default: true to the tile where the height map's file
    /// states metres, else 0.05]
    #[arg(long, value_name = "M", allow_hyphen_values = true, help_heading = "Maps and mesh")]
    scale: Option<f64>,
    /// Displacement of height 0 in metres [default: -scale, carved into the surface]
    #[arg(long, value_name = "M", allow_hyphen_values = true, help_heading = "Maps and mesh")]
    bias: Option<f64>,
    /// Tiles along u and v [default: 1,1]
    #[arg(long, value_name = "U,V", value_parser = values::pair, allow_hyphen_values = true, help_heading = "Maps and mesh")]
    tile: Option<[f64; 2]>,
    /// Metres of a tile along u and v [default: as the height map's file states, else its texels are square]
    #[arg(long, value_name = "U,V", value_parser = values::pair, allow_hyphen_values = true, help_heading = "Maps and mesh")]
    tile_size: Option<[f64; 2]>,
    /// Draw back faces, too, turned over
    #[arg(long, help_heading = "Maps and mesh")]
    two_sided: bool,
    #[command(flatten)]
    reading: HeightArguments,

    #[arg(long, value_name = "NAME", conflicts_with_all = ["search", "refine"], help_heading = "Method", help = method_help())]
    method: Option<String>,
    #[command(flatten)]
    stages: StageArguments,
    /// Setting of the search or the refinement, as in search.steps=64; may be repeated
    #[arg(long, value_name = "STAGE.NAME=VALUE", value_parser = values::setting, help_heading = "Method")]
    set: Vec<(String, f64)>,

    /// Position of the eye in metres [default: 0.6,0.9,1.1]
    #[arg(long, value_name = "X,Y,Z", value_parser = values::point, allow_hyphen_values = true, help_heading = "Camera and light")]
    eye: Option<[f64; 3]>,
    /// Point looked at [default: 0,0,0]
    #[arg(long, value_name = "X,Y,Z", value_parser = values::point, allow_hyphen_values = true, help_heading = "Camera and light")]
    target: Option<[f64; 3]>,
    /// Vertical field of view in degrees [default: 40]
    #[arg(long, value_name = "DEGREES", allow_hyphen_values = true, help_heading = "Camera and light")]
    fov: Option<f64>,
    /// Direction toward a directional light [default: 0.5,0.8,0.3]
    #[arg(long, value_name = "X,Y,Z", value_parser = values::point, allow_hyphen_values = true, help_heading = "Camera and light")]
    light: Option<[f64; 3]>,

    /// What computes the picture: auto takes a GPU if there is one, else the CPU; gpu also takes a software
    /// adapter [default: auto]
    #[arg(long, value_name = "auto|cpu|gpu", help_heading = "Machine")]
    backend: Option<BackendChoice>,
    /// exact has the same bits everywhere; fast uses the GPU's texture sampler [default: exact]
    #[arg(long, value_name = "exact|fast", help_heading = "Machine")]
    sampling: Option<Sampling>,
    /// Refuse to take more memory than this, as in 512MiB [default: 4GiB]
    #[arg(long, value_name = "SIZE", allow_hyphen_values = true, help_heading = "Machine")]
    max_memory: Option<ByteSize>,
    #[command(flatten)]
    cache: CacheArguments,
}

fn method_help() -> String {
    let names: Vec<&str> = METHODS.iter().map(|method| method.name).collect();
    format!("Method: {} [default: exact]", names.join(", "))
}

/// Renders and writes.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let flags = arguments.flags();
    let spec = match &arguments.scene {
        Some(path) => read_scene(path).map_err(of_scene)?.overridden_by(flags),
        None => flags,
    };
    check_outputs(arguments, &spec)?;
    let scene = {
        let _reading = Progress::spinner("reading", arguments.json);
        spec.load().map_err(of_scene)?
    };
    let (mut maps, no_cache) = arguments.cache.maps();
    let rendered = {
        let progress = TaskProgress::new(arguments.json);
        relief_render::render(&scene, &mut maps, &|task, part| progress.show(task, part))
            .map_err(|error| arguments.of_render(error))?
    };
    // Where no map was baked nobody misses a place to keep it.
    let no_cache = no_cache.filter(|_| !rendered.maps.is_empty());
    if !arguments.json {
        let notes = filled(&spec, &scene).into_iter().chain(no_cache);
        for note in notes.chain(rendered.maps.iter().filter_map(baked_maps::note)) {
            eprintln!("note: {note}");
        }
    }
    write(arguments, &scene, &rendered)?;
    report(arguments, &spec, &scene, &rendered)
}

impl Arguments {
    /// The flags as a description that overrides the scene file's.
    fn flags(&self) -> SceneSpec {
        let given = |flag: bool| flag.then_some(true);
        let surface = SurfaceSpec {
            height: self.height.clone(),
            channel: self.reading.file.channel.clone(),
            depth: given(self.reading.depth),
            range: self.reading.range,
            raw: self.reading.file.raw,
            fill: given(self.reading.file.fill),
            wrap: self.reading.wrap,
            scale: self.scale,
            bias: self.bias,
            color: self.color.clone(),
            normal: self.normal.clone(),
            green: self.green,
            mesh: self.mesh,
            tile: self.tile.map(|tile| tile.map(|count| count as f32)),
            tile_size: self.tile_size,
            method: self.method.clone(),
            stages: self.stages.0.clone(),
            set: BTreeMap::from_iter(self.set.iter().cloned()),
            two_sided: given(self.two_sided),
            ..SurfaceSpec::default()
        };
        SceneSpec {
            eye: self.eye,
            target: self.target,
            fov: self.fov,
            size: self.size,
            light: self.light,
            backend: self.backend,
            sampling: self.sampling,
            max_memory: self.max_memory,
            ..SceneSpec::of_surface(surface)
        }
    }

    /// A sampling that the backend does not have is the command line's fault when the command line named one
    /// of them.
    fn of_render(&self, error: RenderError) -> Failure {
        match error {
            RenderError::FastOnCpu { .. } if self.sampling.is_some() || self.backend.is_some() => {
                Failure::Usage(advice::with(&error, advice::of_render(&error)))
            }
            other => Failure::Work(advice::with(&other, advice::of_render(&other))),
        }
    }
}

/// A value that cannot be used came from the flags, since a scene file's values are checked when it is read.
fn of_scene(error: SceneError) -> Failure {
    match error {
        SceneError::Value(ValueError { key, problem: ValueProblem::Needs(other), .. }) => {
            Failure::Usage(format!("--{key}: needs --{other} as well"))
        }
        // A flag holds for every surface: which of them it fails by first says nothing.
        SceneError::Value(ValueError { key, problem, .. }) => Failure::Usage(format!("--{key}: {problem}")),
        SceneError::NoHeightMap(_) => Failure::Usage(advice::with(&error, advice::of_scene(&error))),
        other => Failure::Work(advice::with(&other, advice::of_scene(&other))),
    }
}

/// Outputs that cannot be written, and those that would replace what is read, are found before the work, not
/// after it.
fn check_outputs(arguments: &Arguments, spec: &SceneSpec) -> Result<(), Failure> {
    let outputs = [(Some(&arguments.output), "png", "--output"), (arguments.aov.as_ref(), "exr", "--aov")];
    let surfaces = spec.each_surface();
    let maps = surfaces.iter().flat_map(|surface| [&surface.height, &surface.color, &surface.normal]);
    let inputs: Vec<&PathBuf> = maps.chain([&arguments.scene]).flatten().collect();
    for (path, extension, flag) in outputs {
        let Some(path) = path else { continue };
        let name = path.display();
        let fits = path.extension().is_some_and(|found| found.eq_ignore_ascii_case(extension));
        if !fits {
            return Err(Failure::Usage(format!("{flag} {name}: give it a name that ends in .{extension}")));
        }
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        if !folder.is_dir() {
            let folder = folder.display();
            return Err(Failure::Work(format!("{name}: cannot be written: there is no folder {folder}")));
        }
        if path.is_dir() {
            return Err(Failure::Work(format!("{name}: cannot be written: it is a folder")));
        }
        // A path that does not exist has no canonical form, and is no input.
        let place = path.canonicalize().ok();
        let is_same = |input: &&PathBuf| place.is_some() && input.canonicalize().ok() == place;
        if let Some(input) = inputs.iter().copied().find(is_same) {
            let input = input.display();
            return Err(Failure::Usage(format!("{flag} {name}: would replace {input}, which is read")));
        }
    }
    Ok(())
}

/// Of each height map whose holes were filled without being asked for that it was so, once.
fn filled(spec: &SceneSpec, scene: &Scene) -> BTreeSet<String> {
    let surfaces = spec.each_surface().into_iter().zip(scene.surfaces());
    let notes = surfaces.filter_map(|(described, surface)| {
        let (path, count) = (described.height?, surface.height_map().filled_texels());
        let note = || {
            let name = path.display();
            format!("{name}: {count} of its texels have no value; they are filled from their surroundings")
        };
        (count > 0 && described.fill.is_none()).then(note)
    });
    notes.collect()
}

fn write(arguments: &Arguments, scene: &Scene, rendered: &Rendered) -> Result<(), Failure> {
    let rendering = &rendered.rendering;
    if let Some(path) = &arguments.aov {
        let channels = picture::aov(rendering);
        let channels: Vec<(&str, &[f32])> =
            channels.iter().map(|(name, values)| (*name, values.as_slice())).collect();
        relief_io::write_exr(path, rendering.width, rendering.height, &channels).map_err(Failure::work)?;
    }
    let bytes = picture::srgb8(rendering, scene.background().to_array());
    relief_io::write_png8(&arguments.output, rendering.width, rendering.height, PngColour::Rgb, &bytes)
        .map_err(Failure::work)
}

/// What is counted as reads: those of the method's own shader, or where the CPU answers `exact` by the exact
/// tracer, which is not that shader, the nodes and cells that the tracer looks at.
fn what_reads_are(scene: &Scene, backend: &str) -> &'static str {
    let traced = |surface: &&Surface| backend == "cpu" && surface.selection().is_exact();
    match (scene.surfaces().iter().filter(traced).count(), scene.surfaces().len()) {
        (0, _) => "reads",
        (some, all) if some == all => "tracer nodes",
        _ => "reads and tracer nodes",
    }
}

fn report(
    arguments: &Arguments,
    spec: &SceneSpec,
    scene: &Scene,
    rendered: &Rendered,
) -> Result<(), Failure> {
    let Rendered { rendering, backend, device, reason, elapsed, .. } = rendered;
    let reason = reason.as_ref().map(|reason| advice::with(reason, advice::of_reason(reason)));
    let covered = rendering.pixels.iter().filter(|pixel| pixel.hit == 1);
    let exhausted = covered.clone().filter(|pixel| pixel.exhausted == 1).count();
    let reads: u64 = covered.clone().map(|pixel| u64::from(pixel.reads)).sum();
    let covered = covered.count();
    let mean = if covered == 0 { 0.0 } else { reads as f64 / covered as f64 };
    let counted = what_reads_are(scene, backend);
    let seconds = elapsed.as_secs_f64();
    let mut out = io::stdout().lock();
    if arguments.json {
        // Names that are no Unicode have no exact form in JSON.
        let name = |path: &Path| path.display().to_string();
        let surface = |surface: &Surface| {
            let (selection, map) = (surface.selection(), surface.height_map());
            json!({
                "search": selection.search().name, "refine": selection.refine().name,
                "scale_m": map.scale_m(), "bias_m": map.bias_m(), "wrap": map.wrap().name(),
                "filled_texels": map.filled_texels(),
            })
        };
        let about = json!({
            "output": name(&arguments.output), "aov": arguments.aov.as_deref().map(name), "width": rendering.width, "height": rendering.height,
            "backend": backend, "device": device, "reason": reason, "seconds": seconds,
            "surfaces": scene.surfaces().iter().map(surface).collect::<Vec<_>>(),
            "covered": covered, "exhausted": exhausted,
            "mean_reads": mean, "reads_are": counted,
            "maps": rendered.maps.iter().map(baked_maps::as_json).collect::<Vec<_>>(),
        });
        writeln!(out, "{about:#}")?;
        return Ok(());
    }
    let (width, height) = (rendering.width, rendering.height);
    let run = match scene.surfaces() {
        [surface] => format!("{} + {}", surface.selection().search().name, surface.selection().refine().name),
        surfaces => format!("{} surfaces", surfaces.len()),
    };
    writeln!(
        out,
        "{}: {width}x{height}, {run}, on the {backend} ({device}) in {seconds:.2} s, {mean:.1} {counted} a pixel",
        arguments.output.display()
    )?;
    for (described, surface) in spec.each_surface().iter().zip(scene.surfaces()) {
        let map = surface.height_map();
        if described.scale.is_none() && map.stated_lengths_m().is_some() {
            let scale_m = values::six_digits(map.scale_m());
            writeln!(
                out,
                "scale {scale_m} m: true to the metres that the height map's file states; --scale exaggerates"
            )?;
        }
    }
    for account in &rendered.maps {
        writeln!(out, "{}", baked_maps::line(account))?;
    }
    if let Some(reason) = reason {
        writeln!(out, "backend auto chose the {backend}: {reason}")?;
    }
    if covered == 0 {
        writeln!(
            out,
            "no pixel shows the surface: check --eye, --target and --fov; backs show with --two-sided only"
        )?;
    }
    if exhausted > 0 {
        writeln!(
            out,
            "{exhausted} of {covered} pixels ran out of steps: raise search.limit or search.steps with --set"
        )?;
    }
    Ok(())
}
