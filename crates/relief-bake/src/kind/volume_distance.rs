//! Distances of the cells of a volume to its solid, by which a walk skips what is empty.
//!
//! A volume lies in a map slice beside slice (its [atlas](relief_core::Volume::atlas)), and so do the
//! distances. The parameters say how many columns, rows and slices it has. Without them the whole map
//! is one slice.
//!
//! * Cohen and Sheffer 1994, "Proximity clouds: an acceleration technique for 3D grid traversal".
//! * Szirmay-Kalos and Umenhoffer 2008, section 5.2: volumes on surfaces.
//!
//! The distances themselves are [`volume_distance`].
//!
//! # Guarantee
//!
//! *In every cell that is less than the distance away along every axis, the field is below `above`:
//! by default ½, the surface.*
//!
//! Proof. In a cell the field is the trilinear mean of its corners, so it reaches a value only where a
//! corner does. The distance is the least over all such cells, by the greatest of the differences
//! along the axes, with the volume's wrap. Distances are integers up to 255, which every format
//! stores exactly; a greater one is stored as 255, which promises less.

use relief_core::registry::{Param, Publication};
use relief_core::{Rounding, Volume, Watch};

use super::{BITS_TO_NEAREST, Kind, Reach, to_nearest};
use crate::volumes::params::{VOLUME_PARAMS, volume_notes, volume_of};
use crate::volumes::{VolumeDistance, volume_distance};
use crate::{BakeError, BakeInput, Channel, Settings, Shape, Sink, Texture};

/// The kind `volume-distance`.
pub const KIND: Kind = Kind {
    name: "volume-distance",
    summary: "for each cell of a volume, how many cells around it are empty, so that rays skip them",
    revision: 1,
    publication: Publication {
        paper: "Cohen and Sheffer 1994, Proximity clouds; Szirmay-Kalos and Umenhoffer 2008, Displacement \
            mapping on the GPU",
        section: "5.2",
    },
    params: &[VOLUME_PARAMS[0], VOLUME_PARAMS[1], VOLUME_PARAMS[2], BITS_TO_NEAREST, ABOVE],
    guarantee: "In every cell less than the distance away, along every axis, the trilinear field is below \
        `above`, by default one half. Exact in every format.",
    is_picture: false,
    of_volume: true,
    shapes: |size, _| vec![Shape::slices("", size, 1, 1)],
    reach: |_| Reach::Everything,
    working_maps: |_| 2.0,
    bake,
};

/// The parameter for the least value of what is not empty.
const ABOVE: Param = Param {
    name: "above",
    summary: "least value that is not empty: the surface's, or next to 0 for translucent volumes",
    unit: "",
    min: 1e-6,
    max: 1.0,
    default: Volume::SURFACE as f32,
    integer: false,
    names: &[],
};

fn bake(
    source: &BakeInput,
    settings: &Settings,
    watch: &Watch,
    sink: &mut dyn Sink,
) -> Result<(), BakeError> {
    let volume = volume_of(source, settings, KIND.name)?;
    let range = [0.0, f32::from(VolumeDistance::MOST)];
    let channels = [Channel { name: "distance", unit: "cells", range, rounding: Rounding::Down }];
    let size = [source.map.width(), source.map.height(), 1];
    let notes = volume_notes(&volume);
    sink.begin(&Texture { name: "", size, mips: Vec::new(), channels: channels.to_vec(), notes })?;
    let distance = volume_distance(&volume, settings.get(4), watch)?;
    let mut plane: Vec<f32> = distance.texels().iter().map(|&cells| f32::from(cells)).collect();
    Ok(to_nearest(sink, &channels, settings.count(3), &mut [&mut plane])?)
}
