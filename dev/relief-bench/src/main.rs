//! Measurements of Relief: `cargo relief-bench accuracy`, `adapt`, `bake`, `cost`, `cracks`, `detail`,
//! `embree`, `frame`, `functions`, `fuzz`, `ground`, `impostors`, `judge`, `kits`, `lanes`, `levels`,
//! `loaders`, `look`, `looks`, `materials`, `mesh`, `object-slices`, `probe`, `pyramid`, `quadrics`,
//! `readers`, `remesh`, `shadow`, `shell-map`, `sheet`, `slices`, `solids`, `surfaces`, `tessellate`,
//! `trace`, `units`, `view`, `view-dependent` and `volumes`. Results are kept in `docs/measurements/`.

use std::process::ExitCode;

use clap::{Parser, Subcommand};

mod accuracy;
mod adapt;
mod bake;
mod chromium;
mod claims;
mod compare;
mod cost;
mod cracks;
mod detail;
mod embree;
mod fit;
mod frame;
mod functions;
mod fuzz;
mod ground;
mod impostors;
mod judge;
mod kits;
mod lanes;
mod levels;
mod loaders;
mod look;
mod looks;
mod materials;
mod memory;
mod mesh;
mod object_slices;
mod parallax;
mod probe;
mod pyramid;
mod python;
mod quadrics;
mod readers;
mod remesh;
mod samples;
mod shadow;
mod sheet;
mod slices;
mod solids;
mod surfaces;
mod table;
mod tessellate;
mod trace;
mod units;
mod view;
mod view_dependent;
mod volumes;

#[derive(Parser)]
#[command(
    name = "relief-bench",
    about = "Measures Relief's methods against the truth and against other programs"
)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Error of every method against the truth, and the cost of its rays
    Accuracy(accuracy::Arguments),
    /// Triangles and seconds that a plane to an error takes, beside packages of PyPI
    Adapt(adapt::Arguments),
    /// Time and memory of every kind of map
    Bake(bake::Arguments),
    /// What the papers say of the methods, one by one, and whether it holds
    Claims(claims::Arguments),
    /// All methods on several maps, their errors against their times, their times against the map's size
    Compare(compare::Arguments),
    /// Time of a frame of every surface, beside one of `plane`
    Cost(cost::Arguments),
    /// What shines through reliefs on closed meshes: fails where something does
    Cracks(cracks::Arguments),
    /// How near levels of detail come to many samples
    Detail(detail::Arguments),
    /// Memory, preparation and rays a second of shells, beside Embree over as many triangles as they show
    Embree(embree::Arguments),
    /// Rays to a motif in shells beside Embree over the same motif as triangles: memory, preparation, rays a
    /// second
    ShellMap(embree::links::Arguments),
    /// Time of a second frame beside a whole rendering, and what it uploads and compiles
    Frame(frame::Arguments),
    /// Methods as functions: their hits beside the renderer's, and their sizes; fails where a hit differs
    Functions(functions::Arguments),
    /// Readers, bakes and the mesher over seeded changes of valid inputs: fails where one panics
    Fuzz(fuzz::Arguments),
    /// Whether meshes of maps lie where the maps do, judged by trimesh and pyproj: fails where one does not
    Ground(ground::Arguments),
    /// The exact judge of displaced meshes beside a tessellation: fails where they disagree
    Judge(judge::Arguments),
    /// Kits for engines beside Relief, in Chromium: fails where a bound is missed
    Kits(kits::Arguments),
    /// What the machine's vectors bring the CPU, beside the same work without them
    Lanes(lanes::Arguments),
    /// What is between filter levels and their map: volume, skylines, and seconds to make them
    Levels(levels::Arguments),
    /// What is written for engines, read by three.js, OpenImageIO and pygltflib: fails
    /// where one reads it otherwise
    Loaders(loaders::Arguments),
    /// A sphere by roughness and metalness beside three.js: fails where a bound is missed
    Look(look::Arguments),
    /// First pictures by what makes them good to look at, and their times: fails where a bound is missed
    Looks(looks::Arguments),
    /// Time of a frame shaded by roughness and metalness, beside Blinn-Phong: fails where the bound is missed
    Materials(materials::Arguments),
    /// Triangles a second that height maps become, in memory and in files
    Mesh(mesh::Arguments),
    /// Engines' own parallax beside Relief's methods in their shaders: errors of hits and times
    Parallax(parallax::Arguments),
    /// Attacks on the promises of baked maps: fails if one is broken
    Probe(probe::Arguments),
    /// A pyramid of changed heights built on the GPU, beside one that is baked and uploaded
    Pyramid(pyramid::Arguments),
    /// What Oliveira and Policarpo 2005 say of their quadrics, beside what they are
    Quadrics(quadrics::Arguments),
    /// PNG, TIFF and EXR files beside Pillow, tifffile and OpenEXR: fails where values differ silently
    Readers(readers::Arguments),
    /// What Gumhold and Hüttner 1999 say of their remesher, beside what it does
    Remesh(remesh::Arguments),
    /// Error of every shadow against rays of the exact search
    Shadow(shadow::Arguments),
    /// What a new user sees of every map in a folder
    Sheet(sheet::Arguments),
    /// How near objects of images come to the meshes that they were captured from, and engines' blends
    Impostors(impostors::Arguments),
    /// How near slices through an object of images come to it, and what they cost
    ObjectSlices(object_slices::Arguments),
    /// How near slices through the relief come to the truth, and how many a pixel shows
    Slices(slices::Arguments),
    /// Solids around holes in every format, read by trimesh and manifold3d: fails where one is open
    Solids(solids::Arguments),
    /// Error of every surface against the exact judge on curved meshes
    Surfaces(surfaces::Arguments),
    /// Triangles per second that a GPU makes from a height map
    Tessellate(tessellate::Arguments),
    /// Rays a second of the exact tracer, beside other tracers and two other programs
    Trace(trace::Arguments),
    /// Units of coordinate systems by their EPSG codes, beside pyproj: fails where one differs
    Units(units::Arguments),
    /// Times of the page of `relief view`: to the first picture, and from the pointer to the picture
    View(view::Arguments),
    /// View-dependent maps of several sizes beside other methods: fails where a free way ends behind a hit
    ViewDependent(view_dependent::Arguments),
    /// Rays through volumes beside the judge, and what each method over volumes costs:
    /// fails where `voxels` errs
    Volumes(volumes::Arguments),
}

fn main() -> ExitCode {
    let done = match Arguments::parse().command {
        Command::Accuracy(arguments) => accuracy::run(&arguments).map(|()| ExitCode::SUCCESS),
        Command::Adapt(arguments) => adapt::run(&arguments).map(|()| ExitCode::SUCCESS),
        Command::Bake(arguments) => bake::run(&arguments),
        Command::Claims(arguments) => claims::run(&arguments).map(|()| ExitCode::SUCCESS),
        Command::Compare(arguments) => compare::run(&arguments).map(|()| ExitCode::SUCCESS),
        Command::Cost(arguments) => cost::run(&arguments).map(|()| ExitCode::SUCCESS),
        Command::Cracks(arguments) => cracks::run(&arguments),
        Command::Detail(arguments) => detail::run(&arguments).map(|()| ExitCode::SUCCESS),
        Command::Embree(arguments) => embree::run(&arguments).map(|()| ExitCode::SUCCESS),
        Command::ShellMap(arguments) => embree::links::run(&arguments).map(|()| ExitCode::SUCCESS),
        Command::Frame(arguments) => frame::run(&arguments).map(|()| ExitCode::SUCCESS),
        Command::Functions(arguments) => functions::run(&arguments),
        Command::Fuzz(arguments) => fuzz::run(&arguments),
        Command::Ground(arguments) => ground::run(&arguments),
        Command::Judge(arguments) => judge::run(&arguments),
        Command::Kits(arguments) => kits::run(&arguments),
        Command::Lanes(arguments) => lanes::run(&arguments).map(|()| ExitCode::SUCCESS),
        Command::Levels(arguments) => levels::run(&arguments).map(|()| ExitCode::SUCCESS),
        Command::Loaders(arguments) => loaders::run(&arguments),
        Command::Look(arguments) => look::run(&arguments),
        Command::Looks(arguments) => looks::run(&arguments),
        Command::Materials(arguments) => materials::run(&arguments),
        Command::Mesh(arguments) => mesh::run(&arguments).map(|()| ExitCode::SUCCESS),
        Command::Parallax(arguments) => parallax::run(&arguments),
        Command::Probe(arguments) => probe::run(&arguments),
        Command::Pyramid(arguments) => pyramid::run(&arguments).map(|()| ExitCode::SUCCESS),
        Command::Quadrics(arguments) => quadrics::run(&arguments).map(|()| ExitCode::SUCCESS),
        Command::Readers(arguments) => readers::run(&arguments),
        Command::Remesh(arguments) => remesh::run(&arguments).map(|()| ExitCode::SUCCESS),
        Command::Shadow(arguments) => shadow::run(&arguments).map(|()| ExitCode::SUCCESS),
        Command::Sheet(arguments) => sheet::run(&arguments).map(|()| ExitCode::SUCCESS),
        Command::Impostors(arguments) => impostors::run(&arguments).map(|()| ExitCode::SUCCESS),
        Command::ObjectSlices(arguments) => object_slices::run(&arguments).map(|()| ExitCode::SUCCESS),
        Command::Slices(arguments) => slices::run(&arguments).map(|()| ExitCode::SUCCESS),
        Command::Solids(arguments) => solids::run(&arguments),
        Command::Surfaces(arguments) => surfaces::run(&arguments).map(|()| ExitCode::SUCCESS),
        Command::Tessellate(arguments) => tessellate::run(&arguments).map(|()| ExitCode::SUCCESS),
        Command::Trace(arguments) => trace::run(&arguments).map(|()| ExitCode::SUCCESS),
        Command::Units(arguments) => units::run(&arguments),
        Command::View(arguments) => view::run(&arguments).map(|()| ExitCode::SUCCESS),
        Command::ViewDependent(arguments) => view_dependent::run(&arguments),
        Command::Volumes(arguments) => volumes::run(&arguments),
    };
    match done {
        Ok(code) => code,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}
