//! How a height map is to be read: the flags that commands share.

use std::collections::BTreeSet;
use std::path::Path;

use clap::Args;
use relief_core::{ByteSize, HeightMap, Wrap};
use relief_io::{
    Convention, DEFAULT_MAX_BYTES, Fill, GivenUnits, Ground, HeightOptions, HeightRange, RawLayout,
    guess_by_name, read_ground,
};
use relief_render::scene::{Scene, SceneSpec, SurfaceSpec};

use super::lengths;
use crate::values;

/// How the height map's file is read.
#[derive(Args)]
#[command(next_help_heading = "Reading the height map")]
pub struct FileArguments {
    /// Channel that holds the height: r, g, b, a, y, or an EXR channel's name
    /// [default: the only one, or the grey]
    #[arg(long, value_name = "NAME", hide_short_help = true)]
    pub channel: Option<String>,
    /// Size and byte order of a headerless 16-bit file, as in 403x344,le
    #[arg(long, value_name = "WxH,le|be", hide_short_help = true)]
    pub raw: Option<RawLayout>,
    /// Value of texels without one, as the file stores it, beside the value that the file declares
    #[arg(
        long,
        value_name = "V",
        value_parser = values::nodata,
        allow_hyphen_values = true,
        hide_short_help = true,
    )]
    pub nodata: Option<f64>,
    /// Unit of the heights, where the file does not say it or says it wrong: m, dm, cm, mm, km, ft, us-ft and
    /// so on. A second unit is for the ground's coordinates, as in cm,ft
    /// [default: as the file or those beside it say]
    #[arg(long, value_name = "UNIT[,GROUND]", hide_short_help = true)]
    pub unit: Option<GivenUnits>,
    /// Fill texels without a value (nodata, masked, NaN, infinite) from their surroundings
    /// [default: they are an error; render and mesh fill those of elevation models and of --nodata]
    #[arg(long, hide_short_help = true)]
    pub fill: bool,
}

/// How a height map is made of what the file holds.
#[derive(Args)]
#[command(next_help_heading = "Reading the height map")]
pub struct HeightArguments {
    /// How the file is read.
    #[command(flatten)]
    pub file: FileArguments,
    /// The file holds depth: white is deep
    #[arg(long)]
    pub depth: bool,
    /// Values of the file that become heights 0 and 1; auto takes the least and the greatest [default: of
    /// integers 0 and their type's maximum, of floats and elevation models auto]
    #[arg(
        long,
        value_name = "A,B|auto",
        value_parser = values::range,
        allow_hyphen_values = true,
        hide_short_help = true,
    )]
    pub range: Option<HeightRange>,
    /// How the maps go on beyond their edges: repeat, clamp or mirror
    /// [default: of elevation models clamp, else repeat]
    #[arg(long, value_name = "WRAP")]
    pub wrap: Option<Wrap>,
}

impl FileArguments {
    /// What becomes of texels without a value, where they have to be asked for.
    pub fn fill(&self) -> Fill {
        if self.fill { Fill::Always } else { Fill::Never }
    }
}

impl HeightArguments {
    /// The reader's options.
    pub fn options(&self, max_memory: Option<ByteSize>) -> HeightOptions {
        HeightOptions {
            channel: self.file.channel.clone(),
            convention: self.depth.then_some(Convention::Depth),
            range: self.range,
            nodata: self.file.nodata,
            unit: self.file.unit,
            raw: self.file.raw,
            fill: self.file.fill(),
            wrap: self.wrap,
            max_bytes: max_memory.map_or(DEFAULT_MAX_BYTES, |size| size.0),
        }
    }
}

/// What is said of a picture whose red, green and blue are not quite equal.
pub fn nearly_grey(name: &str, map: &HeightMap) -> Option<String> {
    let count = map.nearly_grey_texels();
    (count > 0).then(|| {
        format!(
            "{name}: nearly grey; the mean of red, green and blue is taken for the height ({count} texels \
             differ)"
        )
    })
}

/// What is said of a map that is named as depths are and read as heights.
pub fn inside_out(path: &Path) -> Option<String> {
    let guess = guess_by_name(path).filter(|guess| guess.convention == Convention::Depth)?;
    let percent = 100.0 * guess.confidence;
    Some(format!(
        "{}: is named like a depth map ({percent:.0} % of such maps are), and read as heights: if the relief \
         is inside out, give --depth",
        path.display()
    ))
}

/// What the header of a surface's height map says of the ground; none where there is no such file.
pub fn ground_of(surface: &SurfaceSpec) -> Option<Ground> {
    let options = HeightOptions {
        channel: surface.channel.clone(),
        unit: surface.unit,
        raw: surface.raw,
        ..HeightOptions::default()
    };
    read_ground(surface.height.as_ref()?, &options).ok()
}

/// Whether a file itself says that it holds depths.
pub fn is_depth(ground: &Ground) -> bool {
    ground.elevation.as_ref().is_some_and(|elevation| elevation.downward)
}

/// Of each height map how it was read where that was not asked for, once.
pub fn of_reading(spec: &SceneSpec, scene: &Scene) -> BTreeSet<String> {
    let surfaces = spec.each_surface().into_iter().zip(scene.surfaces());
    let notes = surfaces.flat_map(|(described, surface)| {
        let ground = ground_of(&described);
        let path = described.height.unwrap_or_default();
        let is_depth = ground.as_ref().is_some_and(is_depth);
        let turned = inside_out(&path).filter(|_| described.depth.is_none() && !is_depth);
        let name = path.display().to_string();
        let count = surface.height_map().filled_texels();
        let filled = match (surface.has_holes(), described.fill.is_none(), count) {
            (true, _, 0) => Some(format!("{name}: every texel has a value: there are no holes to be seen")),
            (true, _, _) => Some(format!("{name}: {count} of its texels have no value; they are holes")),
            (false, true, 1..) => Some(format!(
                "{name}: {count} of its texels have no value; they are filled from their surroundings"
            )),
            _ => None,
        };
        let of_units = ground.iter().flat_map(|ground| lengths::of_map(ground, surface.height_map()));
        let of_units: Vec<String> = of_units.map(|note| format!("{name}: {note}")).collect();
        filled.into_iter().chain(nearly_grey(&name, surface.height_map())).chain(turned).chain(of_units)
    });
    notes.collect()
}
