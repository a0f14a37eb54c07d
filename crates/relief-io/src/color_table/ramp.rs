//! Colours of a table for the elevations of one map.

use super::{ColorTable, TableElevation};

/// Greatest difference of equal elevations, as a part of the map's range. Heights of a map are
/// `f32` parts of the range, so that an elevation may come back slightly beside an entry.
const SAME: f64 = 1.0 / (1 << 22) as f64;

/// Colours by elevation; see [`ColorTable::ramp`].
#[derive(Clone, Debug, PartialEq)]
pub struct ColorRamp {
    /// Elevations in rising order, and their colours. At least one.
    stops: Vec<(f64, [u8; 4])>,
    outside: Option<[u8; 4]>,
    /// Greatest difference of equal elevations.
    same: f64,
}

impl ColorRamp {
    pub(super) fn new(table: &ColorTable, [least, greatest]: [f64; 2]) -> Self {
        let span = greatest - least;
        let elevation = |elevation: TableElevation| match elevation {
            TableElevation::Absolute(elevation) => elevation,
            TableElevation::Percent(percent) => least + percent / 100.0 * span,
        };
        let mut stops: Vec<(f64, [u8; 4])> =
            table.entries().iter().map(|entry| (elevation(entry.elevation), entry.color)).collect();
        // Falling tables are turned over first, so that both sides of a step stay on their sides.
        if stops.first().zip(stops.last()).is_some_and(|(first, last)| first.0 > last.0) {
            stops.reverse();
        }
        stops.sort_by(|a, b| a.0.total_cmp(&b.0));
        Self { stops, outside: table.outside(), same: SAME * span.abs() }
    }

    /// Returns red, green, blue and opacity of an elevation, from 0 to 255 and not rounded. Colours are
    /// encoded by the sRGB curve, in which they are interpolated, as in GDAL.
    ///
    /// Elevations beyond all entries have the nearest one's colour, or the one of
    /// [`ColorTable::outside`]. Where entries have equal elevations, the first one's colour is the
    /// elevation's own.
    pub fn color(&self, elevation: f64) -> [f64; 4] {
        let plain = |color: [u8; 4]| color.map(f64::from);
        let above = self.stops.partition_point(|(at, _)| *at < elevation - self.same);
        match (above.checked_sub(1).map(|below| self.stops[below]), self.stops.get(above)) {
            (_, Some(&(at, color))) if at <= elevation + self.same => plain(color),
            (Some((low, from)), Some(&(high, to))) => {
                let part = (elevation - low) / (high - low);
                let [from, to] = [plain(from), plain(to)];
                [0, 1, 2, 3].map(|channel| from[channel] + part * (to[channel] - from[channel]))
            }
            (Some((_, nearest)), None) | (None, Some(&(_, nearest))) => {
                plain(self.outside.unwrap_or(nearest))
            }
            (None, None) => [0.0; 4],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{BuiltinRamp, Source, read_color_table};

    fn ramp(text: &str, range: [f64; 2]) -> ColorRamp {
        let table = read_color_table(Source::bytes("table.txt", text.as_bytes()));
        table.unwrap_or_else(|error| panic!("{error}")).ramp(range)
    }

    #[test]
    fn steps_keep_their_sides_in_both_directions() {
        for text in ["0 red\n10 red\n10 blue\n20 blue", "20 blue\n10 blue\n10 red\n0 red"] {
            let ramp = ramp(text, [0.0, 20.0]);
            let [red, blue] = [[255.0, 0.0, 0.0, 255.0], [0.0, 0.0, 255.0, 255.0]];
            let found = [0.0, 9.99, 10.0, 10.0 + 1e-6, 10.01, 20.0].map(|at| ramp.color(at));
            assert_eq!(found, [red, red, red, red, blue, blue], "{text}");
        }
    }

    #[test]
    fn elevations_beyond_the_table_have_the_nearest_colour_or_the_default() {
        let text = "100 10 20 30\n200 40 50 60 70";
        let nearest = ramp(text, [0.0, 300.0]);
        assert_eq!(nearest.color(0.0), [10.0, 20.0, 30.0, 255.0]);
        assert_eq!(nearest.color(300.0), [40.0, 50.0, 60.0, 70.0]);
        let outside = ramp(&format!("{text}\ndefault 1 2 3"), [0.0, 300.0]);
        assert_eq!([0.0, 300.0].map(|at| outside.color(at)), [[1.0, 2.0, 3.0, 255.0]; 2]);
        assert_eq!(outside.color(200.0), [40.0, 50.0, 60.0, 70.0]);
    }

    #[test]
    fn built_in_tables_span_the_range() {
        let grey = ColorTable::from(BuiltinRamp::Grey).ramp([-50.0, 150.0]);
        assert_eq!([-50.0, 50.0, 150.0].map(|at| grey.color(at)[0]), [0.0, 127.5, 255.0]);
        // Ends and middle of matplotlib's table.
        let viridis = ColorTable::from(BuiltinRamp::Viridis).ramp([0.0, 255.0]);
        let found = [0.0, 128.0, 255.0].map(|at| viridis.color(at).map(|part| part as u8));
        let near = |a: [u8; 4], b: [u8; 4]| a.iter().zip(b).all(|(a, b)| a.abs_diff(b) <= 2);
        let expected = [[0x44, 0x01, 0x54, 255], [0x21, 0x91, 0x8c, 255], [0xfd, 0xe7, 0x25, 255]];
        assert!(found.into_iter().zip(expected).all(|(a, b)| near(a, b)), "{found:?}");
        // A level map has one colour.
        let level = ColorTable::from(BuiltinRamp::Terrain).ramp([7.0, 7.0]);
        assert_eq!(level.color(7.0), [88.0, 132.0, 84.0, 255.0]);
    }
}
