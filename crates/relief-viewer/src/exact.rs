//! What views are compared with: the exact hits of their pixels, or the exact picture, too.

use relief_compare::picture::Image;
use relief_compare::{CompareError, ExactHits, ExactPicture};
use relief_core::{Lanes, Watch};
use relief_maps::Maps;
use relief_render::false_color::{Judge, Quantity, ValueOf};
use relief_scene::Scene;

/// What views are compared with.
#[derive(Debug)]
pub enum Exact {
    /// For quantities of hits alone, which is less work.
    Hits(ExactHits),
    Picture(Box<ExactPicture>),
}

impl Exact {
    /// Finds what these quantities of a scene are compared with.
    pub fn of(
        mut quantities: impl Iterator<Item = &'static Quantity>,
        scene: &Scene,
        lanes: Lanes,
        maps: &mut Maps,
        watch: &Watch,
    ) -> Result<Self, CompareError> {
        match quantities.any(|quantity| matches!(quantity.value, ValueOf::OfColors)) {
            true => Ok(Exact::Picture(Box::new(ExactPicture::new(scene, lanes, maps, watch)?))),
            false => Ok(Exact::Hits(ExactHits::new(scene, lanes, maps, watch)?)),
        }
    }

    pub fn judge(&self) -> &dyn Judge {
        match self {
            Exact::Hits(hits) => hits,
            Exact::Picture(picture) => &**picture,
        }
    }

    /// The hits; none with several surfaces.
    pub fn hits(&self) -> Option<&ExactHits> {
        match self {
            Exact::Hits(hits) => Some(hits),
            Exact::Picture(picture) => picture.hits(),
        }
    }

    /// The picture, if colours are compared.
    pub fn image(&self) -> Option<&Image> {
        match self {
            Exact::Hits(_) => None,
            Exact::Picture(picture) => Some(picture.image()),
        }
    }
}
