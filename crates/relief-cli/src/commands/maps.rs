//! Flags for reading a height map, shared by several commands, and the notes on reading it.

use std::collections::BTreeSet;
use std::fmt;
use std::path::Path;

use clap::Args;
use relief_core::{ByteSize, HeightMap, Metric, Wrap};
use relief_io::{
    Convention, DEFAULT_MAX_BYTES, Fill, GivenUnits, Ground, HeightFile, HeightOptions, HeightRange,
    Omission, RawLayout, ReadNote, Remark, guess_by_name, omissions, read_ground, read_notes,
};
use relief_scene::{Scene, SceneSpec, SurfaceSpec, depth_remark};
use serde_json::{Value, json};

use super::lengths;
use crate::{advice, units, values};

/// Flags for reading a height map's file.
#[derive(Args, Clone)]
#[command(next_help_heading = "Reading the height map")]
pub struct FileArguments {
    /// Channel that holds the height: r, g, b, a, y, or the name of an EXR channel [default: the
    /// only one, or the grey]
    #[arg(long, value_name = "NAME", hide_short_help = true)]
    pub channel: Option<String>,
    /// Size and byte order of a headerless 16-bit file, as in 403x344,le
    #[arg(long, value_name = "WxH,le|be", hide_short_help = true)]
    pub raw: Option<RawLayout>,
    /// Value that marks holes (texels without a value), as stored in the file; adds to the value
    /// that the file declares
    #[arg(
        long,
        value_name = "V",
        value_parser = values::nodata,
        allow_hyphen_values = true,
        hide_short_help = true,
    )]
    pub nodata: Option<f64>,
    /// Unit of the heights, if the file states none or a wrong one: m, dm, cm, mm, km, ft, us-ft
    /// and so on. A second unit is for the ground's coordinates, as in cm,ft [default: as the file
    /// or the files beside it state]
    #[arg(long, value_name = "UNIT[,GROUND]", hide_short_help = true)]
    pub unit: Option<GivenUnits>,
    /// Fill holes (nodata, masked, NaN, infinite) from their surroundings [default: they are an
    /// error; render and mesh fill holes of elevation models and of --nodata]
    #[arg(long, hide_short_help = true)]
    pub fill: bool,
}

/// Flags for turning a file's values into heights.
#[derive(Args, Clone)]
#[command(next_help_heading = "Reading the height map")]
pub struct HeightArguments {
    /// Flags for reading the file.
    #[command(flatten)]
    pub file: FileArguments,
    /// Read the file as depth: white is deep
    #[arg(long)]
    pub depth: bool,
    /// Values of the file that become heights 0 and 1; auto takes the least and the greatest
    /// [default: integers: 0 and the type's maximum; floats and elevation models: auto]
    #[arg(
        long,
        value_name = "A,B|auto",
        value_parser = values::range,
        allow_hyphen_values = true,
        hide_short_help = true,
    )]
    pub range: Option<HeightRange>,
    /// Elevations that heights 0 and 1 stand for, in metres or with units, as in 236,1076: for a
    /// picture of ground without a unit. Colour tables in metres then apply, and with --tile-size the
    /// relief is true to the ground
    #[arg(
        long,
        value_name = "LOW,HIGH",
        value_parser = units::elevations,
        allow_hyphen_values = true,
        hide_short_help = true,
    )]
    pub elevation: Option<[f64; 2]>,
    /// Continuation of the maps beyond their edges: repeat, clamp or mirror [default: clamp for
    /// elevation models, else repeat]
    #[arg(long, value_name = "WRAP")]
    pub wrap: Option<Wrap>,
}

/// Returns the first flag that is given.
fn first_given(flags: &[(&'static str, bool)]) -> Option<&'static str> {
    flags.iter().find(|(_, given)| *given).map(|(flag, _)| *flag)
}

impl FileArguments {
    /// Returns the first of these flags that is given: all are about height maps.
    pub fn flag_of_heights(&self) -> Option<&'static str> {
        first_given(&[
            ("--channel", self.channel.is_some()),
            ("--raw", self.raw.is_some()),
            ("--unit", self.unit.is_some()),
            ("--nodata", self.nodata.is_some()),
            ("--fill", self.fill),
        ])
    }

    /// Returns what happens to holes, where filling must be asked for.
    pub fn fill(&self) -> Fill {
        if self.fill { Fill::Always } else { Fill::Never }
    }
}

impl HeightArguments {
    /// Returns the first flag that only height maps have, if one is given: volumes have none but the
    /// wrap.
    pub fn flag_of_heights(&self) -> Option<&'static str> {
        let of_heights = [
            ("--depth", self.depth),
            ("--range", self.range.is_some()),
            ("--elevation", self.elevation.is_some()),
        ];
        self.file.flag_of_heights().or(first_given(&of_heights))
    }

    /// Returns the reader's options.
    pub fn options(&self, max_memory: Option<ByteSize>) -> HeightOptions {
        HeightOptions {
            channel: self.file.channel.clone(),
            convention: self.depth.then_some(Convention::Depth),
            range: self.range,
            elevation_m: self.elevation,
            nodata: self.file.nodata,
            unit: self.file.unit,
            raw: self.file.raw,
            fill: self.file.fill(),
            wrap: self.wrap,
            max_bytes: max_memory.map_or(DEFAULT_MAX_BYTES, |size| size.0),
        }
    }
}

/// Note on reading a file.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Note {
    text: String,
    /// Row of [`OMISSIONS`](relief_io::OMISSIONS).
    about: &'static str,
}

impl Note {
    /// Whether it belongs to `row`.
    pub fn is_about(&self, row: &Omission) -> bool {
        self.about == row.name
    }
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

/// Way in which a user changes how a file is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    /// Flags of the command.
    Flags,
    /// Keys of the scene file alone.
    Keys,
}

impl By {
    /// Returns a reader's note, with the flag or key that reads the file in another way.
    pub fn note(self, note: &ReadNote) -> Note {
        let text = format!("{note}{}", self.advice(note));
        // Notes on units name the flag themselves.
        let text = match self {
            By::Keys if *note.remark.row == omissions::UNITS => text.replace("--unit", "the key unit"),
            _ => text,
        };
        Note { text, about: note.remark.row.name }
    }

    /// Returns the advice behind a note.
    pub fn advice(self, note: &ReadNote) -> String {
        let [flag, key] = advice::of_note(note).unwrap_or_default();
        match self {
            By::Flags => flag,
            By::Keys => key,
        }
    }
}

/// Formats notes as JSON.
pub fn as_json(notes: &BTreeSet<Note>) -> Value {
    notes.iter().map(|Note { text, about }| json!({ "about": about, "text": text })).collect()
}

/// Returns a remark on a picture whose red, green and blue are not quite equal.
fn nearly_grey(map: &HeightMap) -> Option<Remark> {
    let count = map.nearly_grey_texels();
    (count > 0).then(|| {
        let what = "nearly grey; the mean of red, green and blue is the height";
        Remark::new(&omissions::NEARLY_GREY, format!("{what} ({count} texels differ)"))
    })
}

/// Returns a remark on a map that is named like a depth map and read as heights.
fn inside_out(path: &Path) -> Option<Remark> {
    let guess = guess_by_name(path).filter(|guess| guess.convention == Convention::Depth)?;
    let percent = 100.0 * guess.confidence;
    let text = format!(
        "is named like a depth map ({percent:.0} % of such maps are), and read as heights: if the relief is \
         inside out,"
    );
    Some(Remark::new(&omissions::NAMED_LIKE_DEPTH, text))
}

/// Returns notes on a height map's file: how it was read where that was not asked for.
pub fn of_file(path: &Path, file: &HeightFile, reading: &HeightArguments) -> BTreeSet<Note> {
    of_file_read_as(path, file, reading, reading.depth)
}

/// Returns notes like [`of_file`], on a file that was read as depths or as heights.
pub fn of_file_read_as(
    path: &Path,
    file: &HeightFile,
    reading: &HeightArguments,
    as_depth: bool,
) -> BTreeSet<Note> {
    let ground = read_ground(path, &reading.options(None)).ok();
    let is_depth = as_depth || ground.as_ref().is_some_and(is_depth);
    let turned = inside_out(path).filter(|_| !is_depth);
    let more = nearly_grey(&file.map).into_iter().chain(turned).chain(of_units(
        ground.as_ref(),
        &file.map,
        &file.notes,
    ));
    let more = more.map(|remark| remark.of(path));
    file.notes.iter().cloned().chain(more).map(|note| By::Flags.note(&note)).collect()
}

/// Returns a note on a map whose relief is too deep for its tile.
pub fn of_depth(path: &Path, map: &HeightMap, metric: Metric) -> Option<Note> {
    depth_remark(map, metric).map(|remark| By::Flags.note(&remark.of(path)))
}

/// Returns notes on a picture without heights: header fields that are not followed. A file that
/// cannot be read is an error elsewhere.
pub fn of_picture(path: &Path) -> BTreeSet<Note> {
    read_notes(path).unwrap_or_default().iter().map(|note| By::Flags.note(note)).collect()
}

/// Returns remarks on the units of a map. They are not doubted where an undeclared value of holes
/// may be among the heights.
fn of_units(ground: Option<&Ground>, map: &HeightMap, noted: &[ReadNote]) -> Vec<Remark> {
    let has_no_value = noted.iter().any(|note| *note.remark.row == omissions::UNDECLARED_NODATA);
    let units = |ground| {
        let doubt = lengths::doubt_of(ground, map).filter(|_| !has_no_value);
        lengths::notes(ground).into_iter().chain(doubt).collect::<Vec<_>>()
    };
    let notes = ground.map(units).unwrap_or_default();
    notes.into_iter().map(|note| Remark::new(&omissions::UNITS, note)).collect()
}

/// Returns what the header of a surface's height map says of the ground; none if there is no such
/// file.
pub fn ground_of(surface: &SurfaceSpec) -> Option<Ground> {
    let options = HeightOptions {
        channel: surface.channel.clone(),
        unit: surface.unit,
        raw: surface.raw,
        ..HeightOptions::default()
    };
    read_ground(surface.height.as_ref()?, &options).ok()
}

/// Whether a file itself states that it holds depths.
pub fn is_depth(ground: &Ground) -> bool {
    ground.elevation.as_ref().is_some_and(|elevation| elevation.downward)
}

/// Returns notes on each height map: how it was read where that was not asked for, each once.
pub fn of_reading(spec: &SceneSpec, scene: &Scene, by: By) -> BTreeSet<Note> {
    let surfaces = spec.each_surface().into_iter().zip(scene.surfaces());
    let notes = surfaces.flat_map(|(described, surface)| {
        let ground = ground_of(&described);
        // Heights of a folder of textures have no name of their own here.
        let path = described.height.or(described.textures).unwrap_or_default();
        let is_depth = ground.as_ref().is_some_and(is_depth);
        let turned = inside_out(&path).filter(|_| described.depth.is_none() && !is_depth);
        let count = surface.height_map().filled_texels();
        let missing = format!("{count} of its texels have no value");
        let filled = match (surface.has_holes(), described.fill.is_none(), count) {
            (true, _, 0) => {
                let text = "every texel has a value: there are no holes";
                Some(Remark::new(&omissions::NO_HOLES, text))
            }
            (true, _, _) => Some(Remark::new(&omissions::HOLES, format!("{missing}; they are holes"))),
            (false, true, 1..) => {
                let text = format!("{missing}; they are filled from their surroundings");
                Some(Remark::new(&omissions::FILLED, text))
            }
            _ => None,
        };
        let map = surface.height_map();
        let remarks = filled.into_iter().chain(nearly_grey(map)).chain(turned);
        let remarks = remarks.chain(of_units(ground.as_ref(), map, scene.notes()));
        remarks.map(|remark| remark.of(&path)).collect::<Vec<_>>()
    });
    scene.notes().iter().cloned().chain(notes).map(|note| by.note(&note)).collect()
}
