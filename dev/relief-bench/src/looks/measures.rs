//! Measures of a picture.

use super::picture::Picture;

/// The least difference of bytes, in the channel that differs most, by which an outline is seen.
pub const SEEN: u8 = 24;

/// How far from an outline, in pixels, the colours to compare are looked for.
const REACH: isize = 4;

/// Side of a window in pixels.
const WINDOW: usize = 8;

/// The part of a window's pixels that must be of one kind.
const ALIKE: f64 = 0.95;

/// The four sides of a pixel.
const SIDES: [[isize; 2]; 4] = [[-1, 0], [1, 0], [0, -1], [0, 1]];

/// Measures by which a picture is judged. A measure is `None` where the picture has nothing to measure.
#[derive(Clone, Debug, PartialEq)]
pub struct Measures {
    /// The part of all pixels that show a surface.
    pub covered: f64,
    /// Pixels between what is shown and the picture's top, bottom, left and right.
    pub margins: Option<[usize; 4]>,
    /// The part of the outline whose colour differs from the background's.
    pub outline: Option<f64>,
    /// The deviations of luma in windows in shadow, ascending.
    pub shadows: Vec<f64>,
    /// The deviations of luma in windows in light, ascending.
    pub lights: Vec<f64>,
    /// The part of the covered pixels that are too bright or too dark to show anything.
    pub clipped: Option<f64>,
}

impl Measures {
    /// Measures a picture.
    pub fn of(picture: &Picture) -> Self {
        let covered = picture.hit.iter().filter(|hit| **hit).count();
        let [shadows, lights] = deviations(picture);
        Self {
            covered: covered as f64 / picture.hit.len() as f64,
            margins: margins(picture),
            outline: outline(picture),
            shadows,
            lights,
            clipped: (covered > 0).then(|| clipped(picture) as f64 / covered as f64),
        }
    }
}

/// The median of ascending values.
pub fn median(values: &[f64]) -> Option<f64> {
    let middle = values.len() / 2;
    match values.len() {
        0 => None,
        count if count % 2 == 1 => Some(values[middle]),
        _ => Some((values[middle - 1] + values[middle]) / 2.0),
    }
}

fn margins(picture: &Picture) -> Option<[usize; 4]> {
    let [columns, rows] = picture.size;
    let hits = || picture.hit.iter().enumerate().filter(|(_, hit)| **hit).map(|(place, _)| place);
    let top = hits().next()? / columns;
    let bottom = rows - 1 - hits().next_back()? / columns;
    let left = hits().map(|place| place % columns).min()?;
    let right = columns - 1 - hits().map(|place| place % columns).max()?;
    Some([top, bottom, left, right])
}

/// Whether a pixel and all around it are covered, or none of them is: an antialiased edge mixes no colours
/// there.
fn is_pure(picture: &Picture, place: usize) -> bool {
    (-1..=1).all(|down| {
        let same = |beside: usize| picture.hit[beside] == picture.hit[place];
        (-1..=1).all(|right| picture.beside(place, [right, down]).is_none_or(same))
    })
}

/// The part of the covered pixels beside uncovered ones at which the nearest pure colours on both sides
/// differ. Where a side is too thin to have a pure pixel, its nearest pixel counts.
fn outline(picture: &Picture) -> Option<f64> {
    let around = || (-REACH..=REACH).flat_map(|down| (-REACH..=REACH).map(move |right| [right, down]));
    let mut offsets: Vec<[isize; 2]> = around().collect();
    offsets.sort_by_key(|[right, down]| right * right + down * down);
    let is_open = |place: &usize| {
        let is_free = |side| picture.beside(*place, side).is_some_and(|beside| !picture.hit[beside]);
        picture.hit[*place] && SIDES.into_iter().any(is_free)
    };
    let nearest = |place: usize, hit: bool| {
        let places = || offsets.iter().filter_map(|offset| picture.beside(place, *offset));
        let of_side = || places().filter(|place| picture.hit[*place] == hit);
        of_side().find(|place| is_pure(picture, *place)).or_else(|| of_side().next())
    };
    let (mut all, mut seen) = (0usize, 0usize);
    for place in (0..picture.hit.len()).filter(is_open) {
        let (Some(inside), Some(outside)) = (nearest(place, true), nearest(place, false)) else { continue };
        let parts = picture.colours[inside].into_iter().zip(picture.colours[outside]);
        all += 1;
        seen += usize::from(parts.map(|(a, b)| a.abs_diff(b)).max().is_some_and(|apart| apart >= SEEN));
    }
    (all > 0).then(|| seen as f64 / all as f64)
}

/// The standard deviations of luma in the windows in shadow, and in those in light, ascending.
fn deviations(picture: &Picture) -> [Vec<f64>; 2] {
    let [columns, rows] = picture.size;
    let (mut shadows, mut lights) = (Vec::new(), Vec::new());
    for row in 0..rows / WINDOW {
        for column in 0..columns / WINDOW {
            let first = row * WINDOW * columns + column * WINDOW;
            let places: Vec<usize> =
                (0..WINDOW * WINDOW).map(|at| first + at / WINDOW * columns + at % WINDOW).collect();
            if !places.iter().all(|place| picture.hit[*place]) {
                continue;
            }
            let part = |lit: f32| {
                let alike = places.iter().filter(|place| picture.lit[**place] == lit).count();
                alike as f64 / places.len() as f64
            };
            let list = match (part(0.0) >= ALIKE, part(1.0) >= ALIKE) {
                (true, _) => &mut shadows,
                (_, true) => &mut lights,
                _ => continue,
            };
            list.push(deviation(places.iter().map(|place| luma(picture.colours[*place]))));
        }
    }
    [shadows, lights].map(|mut list| {
        list.sort_by(f64::total_cmp);
        list
    })
}

fn luma([red, green, blue]: [u8; 3]) -> f64 {
    0.2126 * f64::from(red) + 0.7152 * f64::from(green) + 0.0722 * f64::from(blue)
}

fn deviation(values: impl Iterator<Item = f64> + Clone) -> f64 {
    let count = values.clone().count() as f64;
    let mean = values.clone().sum::<f64>() / count;
    (values.map(|value| (value - mean).powi(2)).sum::<f64>() / count).sqrt()
}

/// Covered pixels with a channel that is full, or with all of them empty.
fn clipped(picture: &Picture) -> usize {
    let covered = picture.colours.iter().zip(&picture.hit).filter(|(_, hit)| **hit);
    covered.filter(|(colour, _)| colour.contains(&255) || **colour == [0; 3]).count()
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: [usize; 2] = [80, 64];

    /// A lit rectangle of columns 16 to 47 and rows 8 to 55 of one colour before another, whose edge is mixed
    /// as antialiasing does.
    fn rectangle(inside: u8, outside: u8) -> Picture {
        let [columns, rows] = SIZE;
        let within =
            |x: usize, y: usize, by: usize| (16 + by..48 - by).contains(&x) && (8 + by..56 - by).contains(&y);
        let places = || (0..rows).flat_map(|y| (0..columns).map(move |x| (x, y)));
        let colour = |(x, y)| match (within(x, y, 1), within(x, y, 0)) {
            (true, _) => inside,
            (_, true) => inside.midpoint(outside),
            _ => outside,
        };
        Picture {
            size: SIZE,
            colours: places().map(|place| [colour(place); 3]).collect(),
            hit: places().map(|(x, y)| within(x, y, 0)).collect(),
            lit: vec![1.0; columns * rows],
        }
    }

    #[test]
    fn coverage_and_margins_are_those_of_the_rectangle() {
        let measures = Measures::of(&rectangle(200, 100));
        assert_eq!(measures.margins, Some([8, 8, 16, 32]));
        assert!((measures.covered - 32.0 * 48.0 / (80.0 * 64.0)).abs() < 1e-12);
    }

    #[test]
    fn an_empty_picture_has_no_measures() {
        let mut empty = rectangle(200, 100);
        empty.hit.fill(false);
        let measures = Measures::of(&empty);
        assert_eq!((measures.margins, measures.outline, measures.clipped), (None, None, None));
        assert!(measures.shadows.is_empty() && measures.lights.is_empty() && measures.covered == 0.0);
    }

    #[test]
    fn an_outline_is_seen_from_a_difference_of_24_although_its_edge_is_mixed() {
        assert_eq!(Measures::of(&rectangle(124, 100)).outline, Some(1.0));
        assert_eq!(Measures::of(&rectangle(76, 100)).outline, Some(1.0));
        assert_eq!(Measures::of(&rectangle(123, 100)).outline, Some(0.0));
    }

    #[test]
    fn one_channel_is_enough_for_an_outline() {
        let mut picture = rectangle(100, 100);
        let inside = picture.colours.iter_mut().zip(&picture.hit).filter(|(_, hit)| **hit);
        inside.for_each(|(colour, _)| colour[2] = 130);
        assert_eq!(Measures::of(&picture).outline, Some(1.0));
    }

    #[test]
    fn the_background_of_an_outline_is_the_one_beside_it() {
        // The background becomes brighter from left to right: it has the rectangle's byte at the right side.
        let mut picture = rectangle(150, 0);
        let outside = (0..picture.hit.len()).filter(|place| !picture.hit[*place]);
        outside.for_each(|place| picture.colours[place] = [if place % SIZE[0] < 46 { 80 } else { 150 }; 3]);
        let seen = Measures::of(&picture).outline.expect("an outline");
        // All but the right side, of about 48 in 156 pixels.
        assert!((0.6..0.75).contains(&seen), "{seen}");
    }

    #[test]
    fn thin_parts_are_compared_by_their_own_colour() {
        let mut line = rectangle(100, 100);
        for place in 0..line.hit.len() {
            line.hit[place] = place % SIZE[0] == 40;
            line.colours[place] = [if line.hit[place] { 140 } else { 100 }; 3];
        }
        assert_eq!(Measures::of(&line).outline, Some(1.0));
    }

    /// Stripes of two bytes so far apart in the rectangle, left half lit, right half in shadow.
    fn stripes(light: u8, shadow: u8) -> Picture {
        let mut picture = rectangle(100, 20);
        for place in 0..picture.hit.len() {
            let x = place % SIZE[0];
            let (lit, apart) = if x < 32 { (1.0, light) } else { (0.0, shadow) };
            picture.lit[place] = lit;
            picture.colours[place] = [if x.is_multiple_of(2) { 100 } else { 100 + apart }; 3];
        }
        picture
    }

    #[test]
    fn deviations_are_half_of_the_difference_of_stripes() {
        let measures = Measures::of(&stripes(20, 8));
        // 6 rows of 2 windows each.
        assert_eq!([measures.lights.len(), measures.shadows.len()], [12, 12]);
        let [lights, shadows] = [&measures.lights, &measures.shadows].map(|list| median(list).expect("some"));
        assert!((lights - 10.0).abs() < 1e-9 && (shadows - 4.0).abs() < 1e-9);
    }

    #[test]
    fn flat_shadows_have_no_deviation() {
        let measures = Measures::of(&stripes(20, 0));
        assert_eq!(median(&measures.shadows), Some(0.0));
        assert!(median(&measures.lights).is_some_and(|median| median > 9.0));
    }

    #[test]
    fn windows_of_both_kinds_count_for_neither() {
        let mut picture = stripes(20, 8);
        // 4 of the 64 pixels are more than 5 in 100.
        (0..picture.hit.len()).filter(|place| place % 16 == 3).for_each(|place| {
            let y = place / SIZE[0];
            if y % 8 < 4 {
                picture.lit[place] = 0.5;
                picture.lit[place + 8] = 0.5;
            }
        });
        let measures = Measures::of(&picture);
        assert!(measures.shadows.is_empty() && measures.lights.is_empty());
        // 3 are fewer.
        let mut picture = stripes(20, 8);
        (0..3).for_each(|y| picture.lit[(8 + y) * SIZE[0] + 16] = 0.5);
        assert_eq!(Measures::of(&picture).lights.len(), 12);
    }

    #[test]
    fn full_and_black_pixels_are_clipped_and_others_are_not() {
        let clipped = |colour: [u8; 3]| {
            let mut picture = rectangle(100, 0);
            // Half of the rectangle.
            let right = |place: &usize| picture.hit[*place] && place % SIZE[0] >= 32;
            let places: Vec<usize> = (0..picture.hit.len()).filter(right).collect();
            places.into_iter().for_each(|place| picture.colours[place] = colour);
            Measures::of(&picture).clipped.expect("covered pixels")
        };
        assert_eq!(clipped([255, 10, 10]), 0.5);
        assert_eq!(clipped([0, 0, 0]), 0.5);
        assert_eq!(clipped([0, 0, 1]), 0.0);
        assert_eq!(clipped([254; 3]), 0.0);
    }

    #[test]
    fn a_median_is_the_middle() {
        assert_eq!(median(&[]), None);
        assert_eq!(median(&[1.0, 2.0, 9.0]), Some(2.0));
        assert_eq!(median(&[1.0, 2.0, 4.0, 9.0]), Some(3.0));
    }
}
