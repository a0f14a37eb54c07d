//! Heights from a normal map.
//!
//! Szirmay-Kalos and Umenhoffer 2008, section 2.2, name normal maps and photographs as sources of
//! height maps. The integration is by least squares: Frankot and Chellappa 1988 and, for maps that
//! do not tile, Simchony, Chellappa and Shao 1990. Its differences are the ones of the kind
//! `normal`.
//!
//! # What is computed
//!
//! The result is the heights `h` whose central differences `D h` are nearest to the slopes `s` of
//! the normals. The differences are taken as in [`kind::normal`](crate::kind::normal) (eq. 9, with
//! the map's wrap). `D` is linear, and the normal equations `DᵀD h = Dᵀs` are diagonal in waves.
//! The waves are of a Hartley transform where the map is tiled. They are of a cosine transform
//! (DCT-II) where it is clamped or mirrored, which makes no difference to a texel's neighbours. (At
//! the edges of a clamped map, `kind::normal` takes twice as much of a difference as `D`. Half of
//! the slope is taken there, so an error counts half.) A wave that turns by `θ` from texel to texel
//! has the eigenvalue `sin²θ / texel² = (2 - 2 cos 2θ) / (2 texel)²` along each axis. There is one
//! transform there and one back, in `f64`.
//!
//! # Limits
//!
//! * *The mean* is not in the normals. It is set to 0.
//! * *Checkerboards*. Central differences skip a texel. In a tiled map of even size they do not see
//!   waves that change their sign from texel to texel: along rows, along columns, or both. These
//!   three waves are set to 0, the least of all heights that fit. Waves near them are seen faintly,
//!   with `sin θ` of their slope. They come back amplified, together with the noise of the normals.
//!   For normals made by eq. 9 this is the exact inverse. Normals from elsewhere do have slopes
//!   there. To suppress these, `damping` adds `damping² |Ph|²` to the minimised sum. `P` takes
//!   `(1 - cos θ) / 2` of a wave, over a texel's side: all of a checkerboard and next to nothing of
//!   smooth relief. 0 is off. 0.1 is good for normals that were painted, scanned or compressed, and
//!   takes 0.25 % of a wave of four texels.
//! * *Overhangs*. No relief has a normal at or below the horizon. Such a normal is counted and
//!   replaced by one of the steepest accepted slope.
//! * *Holes*. Black, white and transparent texels are background, and middle grey has no direction
//!   ([`NormalFaults`]). They do not count ([`heights_from_known_slopes`]), so heights beside them
//!   are right.
//!
//! # Accuracy
//!
//! Round trip from heights in `[0, 1]` through [`normals`](crate::kind::normal::normals): fractal
//! ground of 512² with a relief a tenth of the tile, mean and checkerboards taken out, no damping.
//! The root mean square error is 5e-9 of the relief from normals in `f32`, 4e-7 from 16 bits and
//! 1.1e-4 from 8 bits. Tests accept twice these errors.
//!
//! Round trip through files, with four natural maps (cobbles, bricks, a fault's elevation model, a
//! scan of rock; 256² to 1024², reliefs of 0.03 to 0.1 of the tile) and every wrap: at most 3e-8
//! from floats, 5e-6 from 16 bits and 1.1e-3 from 8 bits. The three waves that a tiled map of even
//! size loses are 8e-5 of the relief there. Damping of 0.1 takes 1e-4 to 1.4e-3, which 8 bits hide.
//! No integer stands for a component of 0. In these figures the code meant as 0 was read as 0
//! (`relief_io::NormalVectors::with_zero_centred`). Read as it stands, a clamped scan comes back
//! from 8 bits with a ramp, and the error is fourteen times as large.
//!
//! Four materials of other programs have height maps beside their normal maps. Correlations with
//! these are 0.95 to 0.998, and misfits 0.8 % to 33 % of the slopes. The right green was found all
//! four times, with a confidence of 0.49 to 1.

mod error;
mod evidence;
mod green;
mod holes;
mod integrate;
mod known;
mod slopes;

use rayon::prelude::*;
use relief_core::Watch;

pub use self::error::{FromNormalsError, SHORTEST};
pub use self::evidence::{Evidence, NormalSource};
pub use self::green::{GreenFit, heights_from_either_green};
pub use self::integrate::{IntegratedHeights, Integration, heights_from_slopes};
pub use self::known::heights_from_known_slopes;
pub use self::slopes::{NormalFaults, NormalSlopes, UNIT_TOLERANCE};

/// Integrates normals of any length, given as planes of `x`, `y` and `z`, row by row from the top.
///
/// # Errors
///
/// When sizes do not fit together, a value is not finite, a number is out of range, or it is
/// cancelled.
pub fn heights_from_normals(
    size: [u32; 2],
    normals: [&[f32]; 3],
    how: &Integration,
    watch: &Watch,
) -> Result<IntegratedHeights, FromNormalsError> {
    integrate::check(size, &normals, how)?;
    let texels = normals[0].len();
    let (mut along_u, mut along_v) = (vec![0.0f32; texels], vec![0.0f32; texels]);
    let too_steep = along_u
        .par_iter_mut()
        .zip(&mut along_v)
        .enumerate()
        .map(|(at, (u, v))| {
            let (slope, fault) = slopes::slope(normals.map(|plane| plane[at]), how.axes, how.steepest as f32);
            [*u, *v] = slope;
            usize::from(fault.is_some())
        })
        .sum();
    let mut integrated = heights_from_slopes(size, [&along_u, &along_v], how, watch)?;
    integrated.too_steep = too_steep;
    Ok(integrated)
}
