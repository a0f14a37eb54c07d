//! Pictures of yes and no: which pixels show a thing, and how far others show it from there.

use std::path::Path;

use glam::DVec2;
use relief_io::{PngColour, write_png8};

/// Which pixels show a thing, from the upper row down.
#[derive(Clone)]
pub struct Mask {
    pub size: [u32; 2],
    pub on: Vec<bool>,
}

/// How far what is shown is from an exact mask.
#[derive(Debug, PartialEq)]
pub struct Apart {
    /// Pixels of the exact mask whose right or lower neighbour differs.
    pub edge: usize,
    /// Places that show what the exact mask does not show there.
    pub differing: usize,
    /// The longest way from such a place to a pixel of the exact mask that shows the same, in pixels.
    pub farthest: f64,
}

impl Mask {
    /// What the pixel shows whose centre is nearest. Nothing is shown beyond the picture.
    pub fn at(&self, place: DVec2) -> bool {
        let [x, y] = place.round().to_array();
        let [width, height] = self.size.map(f64::from);
        let is_inside = x >= 0.0 && y >= 0.0 && x < width && y < height;
        is_inside && self.on[y as usize * self.size[0] as usize + x as usize]
    }

    /// How far it is to the centre of the nearest pixel that shows this. Beyond the limit it is infinite.
    fn distance(&self, place: DVec2, shows: bool, limit: f64) -> f64 {
        let reach = limit.ceil() as i32 + 1;
        let around = (-reach..=reach).flat_map(|y| (-reach..=reach).map(move |x| [x, y]));
        let centres = around.map(|aside| place.round() + DVec2::from(aside.map(f64::from)));
        let nearest = centres
            .filter(|centre| self.at(*centre) == shows)
            .map(|centre| centre.distance(place))
            .fold(f64::INFINITY, f64::min);
        if nearest <= limit { nearest } else { f64::INFINITY }
    }

    /// Compares with what is shown at places, in pixels of this mask. Ways beyond the limit are infinite.
    pub fn compare(&self, shown: impl IntoIterator<Item = (DVec2, bool)>, limit: f64) -> Apart {
        let differing: Vec<_> =
            shown.into_iter().filter(|(place, shows)| self.at(*place) != *shows).collect();
        let ways = differing.iter().map(|(place, shows)| self.distance(*place, *shows, limit));
        Apart { edge: self.edge(), differing: differing.len(), farthest: ways.fold(0.0, f64::max) }
    }

    fn edge(&self) -> usize {
        let [width, height] = self.size.map(|side| side as usize);
        let differs = |place: &usize| {
            let right = place % width + 1 < width && self.on[*place] != self.on[place + 1];
            right || place / width + 1 < height && self.on[*place] != self.on[place + width]
        };
        (0..self.on.len()).filter(differs).count()
    }

    /// All pixels as places, with what they show.
    pub fn places(&self) -> impl Iterator<Item = (DVec2, bool)> {
        pixels(self.size).into_iter().zip(self.on.iter().copied())
    }

    /// Writes what is shown at places of the exact mask: white, and red where the mask differs.
    pub fn write(&self, path: &Path, exact: &Mask, places: &[DVec2]) -> Result<(), String> {
        let colour = |(shows, place): (&bool, &DVec2)| match (*shows, exact.at(*place)) {
            (true, true) => [255; 3],
            (false, false) => [0; 3],
            _ => [255, 0, 0],
        };
        let bytes: Vec<u8> = self.on.iter().zip(places).flat_map(colour).collect();
        let [width, height] = self.size;
        write_png8(path, width, height, PngColour::Rgb, &bytes).map_err(|error| error.to_string())
    }
}

/// The centres of all pixels, as places.
pub fn pixels([width, height]: [u32; 2]) -> Vec<DVec2> {
    (0..width * height).map(|k| DVec2::new(f64::from(k % width), f64::from(k / width))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn disc(aside: f64) -> Mask {
        let centre = DVec2::new(20.0 + aside, 15.0);
        let place = |k: u32| DVec2::new(f64::from(k % 40), f64::from(k / 40));
        Mask { size: [40, 30], on: (0..1200).map(|k| place(k).distance(centre) < 8.2).collect() }
    }

    #[test]
    fn what_is_moved_is_as_far_away() {
        let exact = disc(0.0);
        let of = |aside| exact.compare(disc(aside).places(), 6.0);
        assert_eq!((of(0.0).differing, of(0.0).farthest), (0, 0.0));
        assert!(of(0.0).edge > 40);
        assert!(of(0.4).differing > 0 && of(0.4).farthest == 1.0);
        assert_eq!(of(3.0).farthest, 3.0);
        assert_eq!(of(9.0).farthest, f64::INFINITY);
    }

    #[test]
    fn a_thing_that_is_not_shown_is_no_match() {
        let exact = disc(0.0);
        let none = Mask { on: vec![false; 1200], ..exact.clone() };
        assert_eq!(exact.compare(none.places(), 3.0).farthest, f64::INFINITY);
        assert_eq!(none.compare(exact.places(), 3.0).edge, 0);
    }
}
