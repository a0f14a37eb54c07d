//! The visual hull: the shape that the images' silhouettes alone define.

use super::patch::Solid;
use super::{EMPTY_HEIGHT, ImageObject, ObjectHit};
use crate::raycast::Ray;

/// Greatest distance between a direction and another, or its opposite, for the two to count as
/// parallel.
const ALONG: f64 = 1e-12;

/// Why an object's silhouettes do not have the symmetry of a cube, whose opposite sides show
/// mirrored silhouettes.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SilhouetteError {
    /// The object does not have six images.
    #[error("a cube has 6 images, this object {0}")]
    NotSix(usize),
    /// An image is perspective. Then the opposite side has another silhouette.
    #[error("image {0} is perspective: opposite silhouettes are the same only by parallel rays")]
    Perspective(usize),
    /// There are no two images from opposite sides along each of three orthogonal axes.
    #[error("image {0} has no opposite of its own, or is at no right angle to the others")]
    NoOpposite(usize),
    /// Two opposite silhouettes are not mirror images of each other.
    #[error("the silhouettes of images {} and {} are not mirror images of each other", pair[0], pair[1])]
    NotMirrored {
        /// Numbers of the two images.
        pair: [usize; 2],
    },
}

impl ImageObject {
    /// Returns the first point of the visual hull on a ray, from its parameter 0 on, in `f64`
    /// (Kautz and Seidel 2001, section 5).
    ///
    /// The hull is the intersection of all silhouettes. A silhouette is the region where a mask is
    /// at least 1/2. The mask is 1 at the centres of texels above [`EMPTY_HEIGHT`], 0 at the
    /// centres of all other texels and beside the image, and bilinear between. The treatment of
    /// cells with height jumps has no influence. As silhouettes have no depth, each extends from
    /// that height to the plane of height 1 of its image.
    ///
    /// Of two [opposite silhouettes](Self::opposite_silhouette) that are mirror images only the
    /// first is tested. In all other respects it is like [`first_hit`](Self::first_hit).
    pub fn hull_first_hit(&self, ray: &Ray) -> Option<ObjectHit> {
        self.enter(ray, Solid::Silhouette, self.silhouettes.iter().copied())
    }

    /// Images, in ascending order, whose silhouettes define the visual hull. Mirror images of an
    /// [opposite silhouette](Self::opposite_silhouette) with a lower number are left out.
    pub fn silhouettes(&self) -> &[usize] {
        &self.silhouettes
    }

    /// Returns the three images whose silhouettes define the visual hull of a cube of six: the
    /// shortcut of Kautz and Seidel 2001, section 5.
    ///
    /// # Errors
    ///
    /// When the object does not have six images with parallel rays, two each from opposite sides
    /// along three orthogonal axes. Also when two opposite silhouettes are not mirror images.
    pub fn cube_silhouettes(&self) -> Result<[usize; 3], SilhouetteError> {
        let views = &self.views;
        if views.len() != 6 {
            return Err(SilhouetteError::NotSix(views.len()));
        }
        if let Some(number) = views.iter().position(|view| view.eye().is_some()) {
            return Err(SilhouetteError::Perspective(number));
        }
        let mut found = Vec::new();
        for (number, view) in views.iter().enumerate() {
            let toward = view.axes()[2];
            let others = || (0..6).filter(|other| *other != number);
            let mut along = others().filter(|other| {
                let other = views[*other].axes()[2];
                (toward.dot(other).abs() - 1.0).abs() < ALONG
            });
            let opposite = along.next().filter(|other| self.sees_from_behind(number, *other));
            let (Some(opposite), None) = (opposite, along.next()) else {
                return Err(SilhouetteError::NoOpposite(number));
            };
            let at_right_angles = |other: usize| toward.dot(views[other].axes()[2]).abs() < ALONG;
            if !others().all(|other| other == opposite || at_right_angles(other)) {
                return Err(SilhouetteError::NoOpposite(number));
            }
            if number < opposite {
                if !self.is_mirrored(number, opposite) {
                    return Err(SilhouetteError::NotMirrored { pair: [number, opposite] });
                }
                found.push(number);
            }
        }
        found.try_into().map_err(|_| SilhouetteError::NoOpposite(0))
    }

    /// Image with a lower number that shows the same ball with parallel rays from the other side,
    /// if its silhouette is the mirror image of this one's.
    pub fn opposite_silhouette(&self, number: usize) -> Option<usize> {
        (0..number.min(self.views.len()))
            .find(|other| self.sees_from_behind(*other, number) && self.is_mirrored(*other, number))
    }

    /// Whether two images show the same ball with parallel rays from opposite sides, in the same
    /// size, with equal or opposite directions downward.
    fn sees_from_behind(&self, one: usize, other: usize) -> bool {
        let (Some(one), Some(other)) = (self.views.get(one), self.views.get(other)) else { return false };
        let ([_, down, toward], [_, other_down, other_toward]) = (one.axes(), other.axes());
        one.eye().is_none()
            && other.eye().is_none()
            && one.ball() == other.ball()
            && one.size() == other.size()
            && (toward + other_toward).length() < ALONG
            && (down.dot(other_down).abs() - 1.0).abs() < ALONG
    }

    /// Whether the silhouettes of two images from opposite sides are mirror images of each other.
    fn is_mirrored(&self, one: usize, other: usize) -> bool {
        let down = |number: usize| self.views[number].axes()[1];
        let upright = down(one).dot(down(other)) > 0.0;
        let [columns, rows] = self.views[one].size();
        let is_seen = |number: usize, x: u32, y: u32| {
            let place = self.layout.places()[number];
            let height = self.heights.texel(i64::from(place[0] + x), i64::from(place[1] + y));
            f64::from(height) > EMPTY_HEIGHT
        };
        (0..rows).all(|y| {
            (0..columns).all(|x| {
                let mirrored = if upright { [columns - 1 - x, y] } else { [x, rows - 1 - y] };
                is_seen(one, x, y) == is_seen(other, mirrored[0], mirrored[1])
            })
        })
    }
}
