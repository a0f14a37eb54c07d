//! `relief volume`: makes volumes of meshes, height maps, pictures and a formula.

mod of_heights;
mod of_mesh;
mod of_slices;

use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use clap::{Args, ValueEnum};
use relief_bake::volumes::{Fit, Sponge, VolumesError, volume_of_sponge};
use relief_core::{ByteSize, Volume, Watch, Wrap};
use relief_io::{DEFAULT_MAX_BYTES, MeshFormat, TexelFormat, VolumeFormat, write_volume};
use serde_json::{Map, Value, json};

use super::maps::FileArguments;
use super::motif::missing_motif;
use super::staged::{Staged, format_of};
use crate::failure::Failure;
use crate::pattern::has_placeholder;
use crate::progress::Progress;
use crate::streams::{Files, Written, tell_written};
use crate::{interrupt, say, units, values};

/// Name of the formula.
const SPONGE: &str = "sponge";

/// Columns, rows and slices without --size.
const DEFAULT_SIZE: [u32; 3] = [64, 64, 32];

/// Arguments of `relief volume`.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// Closed mesh by its ending (.gltf, .glb, .obj, .ply, .stl); height map; numbered pictures, as
    /// in slice_%03d.png, the lowest first; or sponge, a solid with pores
    #[arg(value_name = "MESH|HEIGHT|SLICES|sponge")]
    input: PathBuf,
    /// Volume to write
    #[arg(short, long, value_name = "FILE.ktx2")]
    output: PathBuf,
    /// Columns, rows and slices of the volume [default: 64x64x32; pictures have their own]
    #[arg(long, value_name = "WxHxD", value_parser = size, allow_hyphen_values = true)]
    size: Option<[u32; 3]>,
    /// Bits of a value: 8 or 16, integers; or 32, floats
    #[arg(long, value_enum, value_name = "8|16|32", default_value = "16")]
    bits: Bits,
    /// Store the values without compression
    #[arg(long, hide_short_help = true)]
    uncompressed: bool,
    /// Length of the heights 0 to 1, in metres or with a unit [default: as the mesh's proportions,
    /// the motif or the height map say, otherwise 5cm]
    #[arg(
        long,
        value_name = "LENGTH",
        value_parser = units::length,
        allow_hyphen_values = true,
        help_heading = "Lengths"
    )]
    scale: Option<f64>,
    /// Displacement of height 0 along the base's normal [default: 0; of a height map the map's; of
    /// a motif a little below 0, for its free voxels]
    #[arg(
        long,
        value_name = "LENGTH",
        value_parser = units::length,
        allow_hyphen_values = true,
        help_heading = "Lengths"
    )]
    bias: Option<f64>,
    /// Lengths of the tile along u and v [default: 1 m; of a height map as its file says]
    #[arg(
        long,
        value_name = "U[,V]",
        value_parser = units::one_or_two_lengths,
        allow_hyphen_values = true,
        help_heading = "Lengths"
    )]
    tile: Option<[f64; 2]>,
    /// Continuation beyond the edges: repeat, clamp or mirror [default: repeat; of an elevation model
    /// clamp]
    #[arg(long, value_name = "WRAP")]
    wrap: Option<Wrap>,
    /// Place of a mesh in the tile: keep, proportions kept, centred; stretch, filled along all axes;
    /// or tile, where x, z and y are u, v and height from 0 to 1 already [default: tile for files of
    /// relief motif, otherwise keep]
    #[arg(long, value_name = "keep|stretch|tile", help_heading = "Meshes")]
    fit: Option<Fit>,
    /// Empty voxels between a mesh and the tile's sides, 0 or more [default: 1]
    #[arg(long, value_name = "VOXELS", allow_hyphen_values = true, help_heading = "Meshes")]
    margin: Option<f64>,
    /// Distance from a mesh's or the sponge's surface at which values reach 0 and 1, above 0 and at
    /// most 8. More makes surfaces smoother; 0.5 keeps edges sharpest, with terraces on slopes
    /// [default: 1.5]
    #[arg(long, value_name = "VOXELS", allow_hyphen_values = true, help_heading = "Meshes")]
    reach: Option<f64>,
    /// Pores of a sponge in a tile, 1 to 10000 [default: 90]
    #[arg(long, value_name = "N", help_heading = "Sponge")]
    pores: Option<u32>,
    /// Seed of a sponge's pores [default: 1]
    #[arg(long, value_name = "N", help_heading = "Sponge")]
    seed: Option<u64>,
    /// Print the result as one JSON object
    #[arg(long)]
    pub json: bool,
    /// Memory limit, as in 512MiB; work that needs more is refused [default: 4GiB]
    #[arg(long, value_name = "SIZE", allow_hyphen_values = true)]
    max_memory: Option<ByteSize>,
    #[command(flatten)]
    reading: FileArguments,
}

const AFTER_HELP: &str = "Examples:\n  relief volume spot.obj --size 128x128x128 -o spot.ktx2\n  \
    relief volume mail.glb --size 128x128x64 -o mail.ktx2    # of `relief motif mail`\n  \
    relief volume wall.png --size 128x128x64 -o wall.ktx2\n  \
    relief volume slice_%03d.png -o scan.ktx2\n  \
    relief volume sponge --size 64x64x32 -o sponge.ktx2\n\n\
    A value is ½ less the distance to the surface in voxels, negative inside, divided by twice --reach, \
    between 0 and 1: the surface is at ½, and greater values are solid. Of pictures it is the opacity, or \
    the grey of pictures without opacity; the first is number 0 or 1, and the last is before the first \
    number without a file.\n\n\
    A mesh must be closed. Where it is not, what lies below an odd number of faces is solid, and the open \
    edges are counted. With --wrap repeat, parts beyond the tile's edges come back on the other side.\n\n\
    The file is a 3-D texture in KTX2, slice 0 the lowest. It states scale, bias, tile and wrap; `relief \
    inspect` shows them.";

/// Storage of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Bits {
    #[value(name = "8")]
    Eight,
    #[value(name = "16")]
    Sixteen,
    #[value(name = "32")]
    ThirtyTwo,
}

impl Bits {
    const fn texel(self) -> TexelFormat {
        match self {
            Bits::Eight => TexelFormat::R8,
            Bits::Sixteen => TexelFormat::R16,
            Bits::ThirtyTwo => TexelFormat::R32F,
        }
    }
}

/// Reads a size in voxels `WxHxD`.
fn size(text: &str) -> Result<[u32; 3], String> {
    let wrong = || "write it as WxHxD, as in 64x64x32".to_owned();
    let sides: Vec<u32> =
        text.split(['x', 'X']).map(|side| side.parse().map_err(|_| wrong())).collect::<Result<_, _>>()?;
    sides.try_into().map_err(|_| wrong())
}

/// Origin of a volume.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Origin {
    Mesh,
    Heights,
    Slices,
    Sponge,
}

/// A volume, and what is said of it.
struct Made {
    volume: Volume,
    tile_m: [f64; 2],
    /// Lines of the answer: a name and a text.
    lines: Vec<(&'static str, String)>,
    /// Entries of the answer as JSON.
    about: Map<String, Value>,
    notes: Vec<String>,
}

/// Reads, computes and writes.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let started = Instant::now();
    let origin = arguments.origin();
    arguments.check(origin)?;
    let inputs = [arguments.input.as_path()];
    let read: &[&Path] = if origin == Origin::Sponge { &[] } else { &inputs };
    format_of("--output", &arguments.output, &[("ktx2", ())], read)?;
    let cancel = interrupt::catch()?;
    let made = match origin {
        Origin::Mesh => of_mesh::make(arguments, cancel),
        Origin::Heights => of_heights::make(arguments, cancel),
        Origin::Slices => of_slices::make(arguments, cancel),
        Origin::Sponge => arguments.sponge(cancel),
    }?;
    let mut made = arguments.with_lengths(origin, made)?;
    if made.volume.atlas().texels().iter().all(|value| f64::from(*value) < Volume::SURFACE) {
        let what = "no value is one half or more, so nothing will be seen";
        let thin = "parts thinner than a voxel fall between voxels: take more with --size";
        made.notes.push(match origin {
            Origin::Mesh => format!("{what}; {thin}"),
            _ => what.to_owned(),
        });
    }
    if !arguments.json {
        made.notes.iter().for_each(say::note);
    }
    let mut staged = Staged::open(&[&arguments.output], arguments.json, cancel)?;
    let aside = staged.aside(&arguments.output)?;
    let format = VolumeFormat {
        texel: arguments.bits.texel(),
        zstd: !arguments.uncompressed,
        tile_m: made.tile_m,
        more: vec![
            ("generator".to_owned(), concat!("relief ", env!("CARGO_PKG_VERSION")).to_owned()),
            ("published".to_owned(), "Szirmay-Kalos and Umenhoffer 2008 5.2".to_owned()),
        ],
    };
    {
        let _writing = Progress::spinner("writing", arguments.json);
        let written = write_volume(&aside, &made.volume, &format);
        written
            .map_err(|error| Failure::Work(format!("{}: {}", arguments.output.display(), error.problem)))?;
    }
    if cancel.load(Ordering::Relaxed) {
        return Err(interrupt::cancelled());
    }
    staged.finish()?;
    arguments.tell(&made, started.elapsed().as_secs_f64())
}

impl Arguments {
    /// Returns the files that may be standard streams.
    pub fn files(&mut self) -> Files<'_> {
        // There is one format, which standard output gets, too.
        let format = (self.output.as_os_str() == "-").then_some("ktx2");
        let output = Written { flag: "--output", path: &mut self.output, format };
        Files { read: vec![&mut self.input], written: vec![output], ..Files::default() }
    }

    fn max_bytes(&self) -> u64 {
        self.max_memory.map_or(DEFAULT_MAX_BYTES, |size| size.0)
    }

    fn size(&self) -> [u32; 3] {
        self.size.unwrap_or(DEFAULT_SIZE)
    }

    fn origin(&self) -> Origin {
        if self.input.as_os_str() == SPONGE {
            Origin::Sponge
        } else if MeshFormat::by_name(&self.input).is_some() {
            Origin::Mesh
        } else if self.input.to_str().is_some_and(has_placeholder) {
            Origin::Slices
        } else {
            Origin::Heights
        }
    }

    /// Refuses flags that the input does not use, and sizes that are impossible.
    fn check(&self, origin: Origin) -> Result<(), Failure> {
        if let Some(missing) = missing_motif(&self.input) {
            return Err(missing);
        }
        let reading = &self.reading;
        let of_meshes = [("--fit", self.fit.is_some()), ("--margin", self.margin.is_some())];
        if self.reach.is_some() && !matches!(origin, Origin::Mesh | Origin::Sponge) {
            return Err(Failure::usage("--reach is for meshes and the sponge: leave it out"));
        }
        let of_sponges = [("--pores", self.pores.is_some()), ("--seed", self.seed.is_some())];
        let of_maps = [
            ("--channel", reading.channel.is_some()),
            ("--raw", reading.raw.is_some()),
            ("--nodata", reading.nodata.is_some()),
            ("--unit", reading.unit.is_some()),
            ("--fill", reading.fill),
        ];
        for (whose, flags, wanted) in [
            ("meshes", of_meshes.as_slice(), Origin::Mesh),
            ("the sponge", of_sponges.as_slice(), Origin::Sponge),
            ("height maps", of_maps.as_slice(), Origin::Heights),
        ] {
            if let Some((flag, _)) = flags.iter().find(|(_, given)| *given && origin != wanted) {
                return Err(Failure::Usage(format!("{flag} is for {whose}: leave it out")));
            }
        }
        if let Some(side) = self.tile.iter().flatten().find(|side| !(1e-12..=1e9).contains(*side)) {
            return Err(Failure::Usage(format!(
                "--tile: {side} cannot be used: it must be from 1e-12 to 1e9 metres"
            )));
        }
        if let Some(scale) = self.scale.filter(|scale| *scale < 0.0) {
            return Err(Failure::Usage(format!("--scale: {scale} cannot be used: it must be 0 or more")));
        }
        Volume::check_size(self.size()).map_err(|error| Failure::Usage(format!("--size: {error}")))?;
        Ok(())
    }

    /// Checks that the memory limit allows `bytes_per_voxel` for each voxel, and `more` bytes.
    fn check_memory(&self, size: [u32; 3], bytes_per_voxel: u64, more: u64) -> Result<(), Failure> {
        let voxels = size.iter().map(|side| u64::from(*side)).fold(1, u64::saturating_mul);
        let needed = voxels.saturating_mul(bytes_per_voxel).saturating_add(more);
        if needed <= self.max_bytes() {
            return Ok(());
        }
        let [width, height, slices] = size;
        Err(Failure::Work(format!(
            "{width}x{height}x{slices} voxels need {} MiB of memory, more than the {} MiB allowed: make the \
             volume smaller or raise --max-memory",
            needed.div_ceil(1 << 20),
            self.max_bytes() >> 20
        )))
    }

    /// Returns the volume with the lengths that flags give. Of a height map they are the map's, and
    /// the volume follows from them.
    fn with_lengths(&self, origin: Origin, made: Made) -> Result<Made, Failure> {
        if origin == Origin::Heights {
            return Ok(made);
        }
        let atlas = made.volume.atlas();
        let (usual_m, low_m) = (atlas.scale_m(), atlas.bias_m());
        let scale_m = self.scale.unwrap_or(usual_m);
        // The part of the heights that lies below the base stays the same.
        let low_m = if usual_m > 0.0 { low_m / usual_m * scale_m } else { low_m };
        let bias_m = self.bias.unwrap_or(low_m);
        let volume = made.volume.clone().with_displacement(scale_m, bias_m).map_err(Failure::work)?;
        Ok(Made { volume, tile_m: self.tile.unwrap_or(made.tile_m), ..made })
    }

    fn sponge(&self, cancel: &AtomicBool) -> Result<Made, Failure> {
        self.check_memory(self.size(), 16, 0)?;
        let usual = Sponge::default();
        let tile_m = self.tile.unwrap_or([1.0; 2]);
        let depth = self.scale.map_or(usual.depth, |scale| scale / tile_m[0]);
        let pores = self.pores.unwrap_or(usual.pores);
        let (seed, reach) = (self.seed.unwrap_or(usual.seed), self.reach.unwrap_or(usual.reach));
        let sponge = Sponge { pores, seed, depth, reach, ..usual };
        let bar = Progress::bar("computing", self.json);
        let tell = |_: &str, part: f32| bar.show(part);
        let volume =
            volume_of_sponge(&sponge, self.size(), &Watch::new(&tell, cancel)).map_err(of_volumes)?;
        let volume = volume.with_displacement(depth * tile_m[0], 0.0).map_err(Failure::work)?;
        let volume = volume.with_wrap(self.wrap.unwrap_or_default());
        let about =
            Map::from_iter([("pores".to_owned(), json!(pores)), ("seed".to_owned(), json!(sponge.seed))]);
        Ok(Made { volume, tile_m, lines: Vec::new(), about, notes: Vec::new() })
    }

    fn tell(&self, made: &Made, seconds: f64) -> Result<(), Failure> {
        let Made { volume, tile_m, lines, about, notes } = made;
        let ([width, height, slices], wrap) = (volume.size(), volume.wrap());
        let (scale, bias) = (volume.atlas().scale_m(), volume.atlas().bias_m());
        let solid = share_solid(volume);
        tell_written(self.json, |out| {
            if self.json {
                let mut all = Map::from_iter(
                    [
                        ("input", json!(self.input.display().to_string())),
                        ("output", json!(self.output.display().to_string())),
                        ("size", json!([width, height, slices])),
                        ("solid", json!(solid)),
                        ("scale_m", json!(scale)),
                        ("bias_m", json!(bias)),
                        ("tile_m", json!(tile_m)),
                        ("wrap", json!(wrap.name())),
                        ("notes", json!(notes)),
                        ("seconds", json!(seconds)),
                    ]
                    .map(|(name, value)| (name.to_owned(), value)),
                );
                all.extend(about.clone());
                return Ok(writeln!(out, "{:#}", Value::Object(all))?);
            }
            let name = self.output.display();
            writeln!(out, "{name}: {width}x{height}x{slices} voxels in {seconds:.2} s")?;
            for (name, text) in lines {
                writeln!(out, "  {name:<12}{text}")?;
            }
            print_volume(out, volume, Some(*tile_m))?;
            Ok(())
        })
    }
}

/// Returns the share of the voxels that are solid, 0 to 1.
pub fn share_solid(volume: &Volume) -> f64 {
    let values = volume.values();
    let solid = values.iter().filter(|value| f64::from(**value) >= Volume::SURFACE).count();
    solid as f64 / values.len() as f64
}

/// Prints the lines on a volume that `relief volume` and `relief inspect` share.
pub fn print_volume(out: &mut impl Write, volume: &Volume, tile_m: Option<[f64; 2]>) -> std::io::Result<()> {
    let (scale, bias) = (volume.atlas().scale_m(), volume.atlas().bias_m());
    writeln!(out, "  solid       {:.1} % of the voxels", 100.0 * share_solid(volume))?;
    let [zero, one, scale] = [bias, bias + scale, scale].map(values::six_digits);
    writeln!(out, "  heights     0 stands for {zero} m, 1 for {one} m: --scale {scale}")?;
    let tile = tile_m.map(|tile| tile.map(values::six_digits));
    let tile = tile.map_or("of unknown length".to_owned(), |[u, v]| format!("{u} m x {v} m"));
    writeln!(out, "  tile        {tile}, --wrap {}", volume.wrap())
}

fn of_volumes(error: VolumesError) -> Failure {
    match error {
        VolumesError::Cancelled(_) => interrupt::cancelled(),
        setting @ VolumesError::BadSetting { .. } => Failure::usage(setting),
        other => Failure::work(other),
    }
}
