//! Ways to the solid of a volume from its voxels, by direction: a generalised displacement map.
//!
//! A volume lies in a map slice beside slice ([`Volume::atlas`](relief_core::Volume::atlas)), and so
//! does each direction's layer. Directions are [`Directions`], in voxels.
//!
//! * Wang, Tong, Lin, Hu, Guo and Shum 2004, "Generalized displacement maps".
//! * Szirmay-Kalos and Umenhoffer 2008, section 6.3.
//!
//! # Guarantee
//!
//! *A stored way is the way from the voxel's centre to the first place where the field is ½, to the
//! nearest code.* The longest way says that nothing is hit on it; hits on its last two hundredth and
//! fiftieth part are stored as the code before. What is stored is [`ways_to_solid`].

use relief_core::registry::{Param, Publication};
use relief_core::{Rounding, Volume, Watch};

use super::{BITS_TO_NEAREST, Kind, Reach, to_nearest};
use crate::volumes::params::{VOLUME_PARAMS, volume_notes, volume_of};
use crate::volumes::{Directions, volume_distance, ways_to_solid};
use crate::{BakeError, BakeInput, Channel, Settings, Shape, Sink, Texture};

/// Longest way to a hit, as a part of the longest way: the last code but one of 8 bits.
const LAST_HIT: f32 = 254.0 / 255.0;

/// Most directions: layers that every GPU takes.
const MOST_DIRECTIONS: u32 = 256;

const AZIMUTHS: Param = Param {
    name: "azimuths",
    summary: "directions around the base's normal",
    unit: "",
    min: 4.0,
    max: 64.0,
    default: 16.0,
    integer: true,
    names: &[],
};

const ELEVATIONS: Param = Param {
    name: "elevations",
    summary: "directions from straight down to straight up; layers are azimuths times these",
    min: 2.0,
    ..AZIMUTHS
};

const WAY: Param = Param {
    name: "way",
    summary: "longest way that is looked at; at it or beyond nothing is hit",
    unit: "voxels",
    min: 4.0,
    max: 1024.0,
    default: 64.0,
    integer: true,
    names: &[],
};

/// The kind `generalised`.
pub const KIND: Kind = Kind {
    name: "generalised",
    summary: "for each voxel of a volume and each direction, the way to the solid: a look-up finds a hit",
    revision: 1,
    publication: Publication {
        paper: "Wang et al. 2004, Generalized displacement maps; Szirmay-Kalos and Umenhoffer 2008",
        section: "6.3",
    },
    params: &[
        VOLUME_PARAMS[0],
        VOLUME_PARAMS[1],
        VOLUME_PARAMS[2],
        AZIMUTHS,
        ELEVATIONS,
        WAY,
        BITS_TO_NEAREST,
    ],
    guarantee: "From a voxel's centre, in the direction of the layer, the field is first one half at the way \
        that is stored, to the nearest code.",
    is_picture: false,
    of_volume: true,
    shapes: |size, settings| vec![Shape::slices("", size, directions(settings).count(), 1)],
    reach: |_| Reach::Everything,
    working_maps: |_| 4.0,
    bake,
};

fn directions(settings: &Settings) -> Directions {
    Directions { azimuths: settings.count(3), elevations: settings.count(4) }
}

fn bake(
    source: &BakeInput,
    settings: &Settings,
    watch: &Watch,
    sink: &mut dyn Sink,
) -> Result<(), BakeError> {
    let volume = volume_of(source, settings, KIND.name)?;
    let count = directions(settings).count();
    if count > MOST_DIRECTIONS {
        let reason = format!(
            "azimuths times elevations are {count}, but a map has at most {MOST_DIRECTIONS} layers: take \
             fewer"
        );
        return Err(BakeError::Impossible { kind: KIND.name, reason });
    }
    let (directions, most) = (directions(settings), settings.count(5) as f32);
    let range = [0.0, most];
    let channels = [Channel { name: "way", unit: "voxels", range, rounding: Rounding::Nearest }];
    let mut notes = volume_notes(&volume);
    notes.push(("azimuths", directions.azimuths.to_string()));
    notes.push(("elevations", directions.elevations.to_string()));
    let size = [source.map.width(), source.map.height(), directions.count()];
    sink.begin(&Texture { name: "", size, mips: Vec::new(), channels: channels.to_vec(), notes })?;
    let distance = volume_distance(&volume, Volume::SURFACE as f32, &Watch::none())?;
    for direction in 0..directions.count() {
        let toward = directions.toward(direction);
        let mut ways = ways_to_solid(&volume, &distance, toward, f64::from(most), watch)?;
        for way in &mut ways {
            *way = if way.is_finite() { way.min(most * LAST_HIT) } else { most };
        }
        to_nearest(sink, &channels, settings.count(6), &mut [&mut ways])?;
        watch.at(f64::from(direction + 1) as f32 / directions.count() as f32)?;
    }
    Ok(())
}
