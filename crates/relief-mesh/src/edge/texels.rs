//! Edge rule `texels`: a point every N texels.
//!
//! Source: Szirmay-Kalos and Umenhoffer 2008, section 3.1, which displaces the vertices of a mesh
//! that was finely divided before.

use relief_core::registry::Publication;

use super::{Divides, EdgeRule, Evenly, Spacing};
use crate::MeshSettings;

pub const RULE: EdgeRule = EdgeRule {
    name: "texels",
    summary: "a point every N texels; on a plane at the centres of every N-th one, and at the plane's border",
    publication: Publication {
        paper: "Szirmay-Kalos and Umenhoffer 2008, Displacement Mapping on the GPU - State of the Art",
        section: "3.1",
    },
    spacing: Spacing::Even,
    divides: Divides::Evenly(Evenly { parts, step, lines }),
};

/// Rounding of a distance in texels, as texture coordinates are stored.
const ROUNDING: f64 = 1.0 / 1024.0;

fn parts([across, down]: [f64; 2], settings: &MeshSettings) -> u64 {
    let texels = across.abs().max(down.abs());
    // A float that is too large becomes the greatest number.
    (texels / step(settings) - ROUNDING).ceil().max(1.0) as u64
}

fn step(settings: &MeshSettings) -> f64 {
    f64::from(settings.texels.max(1))
}

fn lines(from: f64, to: f64, settings: &MeshSettings) -> Vec<f64> {
    let mut lines = vec![from];
    // The first line inside: the first centre, or one step from an end that is a centre.
    let inside = (from - 0.5 + ROUNDING).ceil() + 0.5;
    let first = if inside - from > 1.0 - ROUNDING { from + step(settings) } else { inside };
    let inside = (0..).map(|k| first + f64::from(k) * step(settings)).take_while(|at| *at < to - ROUNDING);
    lines.extend(inside.filter(|at| *at > from + ROUNDING));
    lines.push(to);
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sides_have_a_point_every_n_texels() {
        let every = |texels| MeshSettings { texels, ..MeshSettings::default() };
        for (along, texels, expected) in [
            ([8.0, 0.0], 1, 8),
            ([-8.000_01, 3.0], 1, 8),
            ([8.1, 0.0], 1, 9),
            ([8.0, -24.0], 5, 5),
            ([0.0, 0.0], 1, 1),
            ([0.3, 0.2], 1, 1),
        ] {
            assert_eq!(parts(along, &every(texels)), expected, "{along:?} {texels}");
        }
    }

    #[test]
    fn lines_go_through_centres_and_end_at_the_border() {
        let every = |texels| MeshSettings { texels, ..MeshSettings::default() };
        assert_eq!(lines(0.0, 3.0, &every(1)), [0.0, 0.5, 1.5, 2.5, 3.0]);
        assert_eq!(lines(0.0, 5.0, &every(2)), [0.0, 0.5, 2.5, 4.5, 5.0]);
        assert_eq!(lines(0.0, 1.0, &every(1)), [0.0, 0.5, 1.0]);
        // A border on a centre is one line.
        assert_eq!(lines(0.5, 2.5, &every(1)), [0.5, 1.5, 2.5]);
        assert_eq!(lines(-1.2, 0.3, &every(1)), [-1.2, -0.5, 0.3]);
        assert_eq!(lines(0.0, 0.2, &every(7)), [0.0, 0.2]);
    }
}
