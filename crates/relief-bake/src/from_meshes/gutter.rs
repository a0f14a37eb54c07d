//! Texels beyond the gutter, which no one sees.

use super::charts::{Charts, Owner};

/// Sets texels beyond the gutter to NaN: those more than `gutter` texels, diagonals included,
/// beside texels read on the charts. Returns their number.
pub(super) fn leave_out(metres: &mut [f32], charts: &Charts, gutter: u32) -> u64 {
    let reach = i64::from(gutter);
    let is_near = |near: &[bool], along: usize| -> Vec<bool> {
        // Distance to the last near texel, one way and the other; twice round, for the wrap.
        let [width, height] = charts.size.map(|side| side as usize);
        let (lines, length) = if along == 0 { (height, width) } else { (width, height) };
        let place = |line: usize, at: usize| if along == 0 { line * width + at } else { at * width + line };
        let mut within = vec![false; near.len()];
        for line in 0..lines {
            for by in [1, -1] {
                let step = if along == 0 { [by, 0] } else { [0, by] };
                let mut at = place(line, if by > 0 { 0 } else { length - 1 });
                let mut since = i64::MAX;
                for _ in 0..2 * length {
                    since = if near[at] { 0 } else { since.saturating_add(1) };
                    within[at] |= since <= reach;
                    at = charts.beside(at, step);
                }
            }
        }
        within
    };
    let read: Vec<bool> = charts.owners.iter().map(|owner: &Owner| owner.on().is_some()).collect();
    let within = is_near(&is_near(&read, 0), 1);
    let mut count = 0;
    for (metres, _) in metres.iter_mut().zip(within).filter(|(_, is_within)| !is_within) {
        *metres = f32::NAN;
        count += 1;
    }
    count
}
