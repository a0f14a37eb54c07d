//! What is under a pixel of the views that are shown.

use relief_core::Watch;
use relief_maps::Maps;
use relief_render::false_color::{Content, NOT_COMPARABLE, Quantity};
use relief_scene::Scene;
use relief_shaders::cpu::PixelOut;
use serde_json::{Value, json};

use crate::NotDrawn;
use crate::exact::Exact;
use crate::pane::{Painted, Pane};

/// The last views at rest.
#[derive(Debug)]
pub struct Looked {
    views: Vec<Option<OfView>>,
    exact: Option<Exact>,
}

/// A view, and the numbers of its pixels once they have been asked for.
#[derive(Debug)]
struct OfView {
    scene: Scene,
    pixels: Option<Vec<PixelOut>>,
    /// What the view shows, and the number of each pixel; none of pictures and directions.
    shown: Option<(&'static Quantity, Vec<f32>)>,
}

impl Looked {
    pub fn new(
        views: impl Iterator<Item = Option<(Scene, Painted, Option<&'static Quantity>)>>,
        exact: Option<Exact>,
    ) -> Self {
        let view = |(scene, painted, quantity)| {
            let (pixels, content) = match painted {
                Painted::Quantity(content, pixels) => (Some(pixels), Some(content)),
                Painted::Picture(..) => (None, None),
            };
            let numbers = content.and_then(|content| match content {
                Content::Numbers(numbers) => Some(numbers),
                Content::Picture(_) | Content::Directions(_) => None,
            });
            OfView { scene, pixels, shown: Option::zip(quantity, numbers) }
        };
        Self { views: views.map(|known| known.map(view)).collect(), exact }
    }

    /// The scene of each view that could be drawn.
    pub fn scenes(&self) -> impl Iterator<Item = Option<&Scene>> {
        self.views.iter().map(|view| view.as_ref().map(|view| &view.scene))
    }

    /// What is under a pixel, in each view; none outside of the picture.
    pub async fn at(
        &mut self,
        [column, row]: [u32; 2],
        panes: &mut [Pane],
        maps: &mut Maps,
        watch: &Watch<'_>,
    ) -> Result<Option<Value>, NotDrawn> {
        let Self { views, exact } = self;
        let mut each = Vec::with_capacity(views.len());
        for (view, pane) in views.iter_mut().zip(panes) {
            let Some(OfView { scene, pixels, shown }) = view else {
                each.push(Value::Null);
                continue;
            };
            let [columns, rows] = scene.size();
            if column >= columns || row >= rows {
                return Ok(None);
            }
            let pixels = match pixels {
                Some(pixels) => pixels,
                none => none.insert(pane.pixels(scene, maps, true, watch).await?),
            };
            let number = column as usize + row as usize * columns as usize;
            let Some(pixel) = pixels.get(number) else { return Ok(None) };
            let mut all = numbers(pixel, scene, exact.as_ref(), number);
            if let Some((quantity, value)) = shown.as_ref().and_then(|(of, all)| Some((of, all.get(number)?)))
            {
                // A pixel may have no such number.
                let value = Some(*value).filter(|value| value.is_finite() && *value != NOT_COMPARABLE);
                all["shown"] = json!({ "name": quantity.name, "unit": quantity.unit, "value": value });
            }
            each.push(all);
        }
        Ok(Some(json!({ "at": [column, row], "views": each })))
    }
}

/// The numbers of a pixel, in the units of AOVs.
fn numbers(pixel: &PixelOut, scene: &Scene, exact: Option<&Exact>, number: usize) -> Value {
    let hits = exact.and_then(Exact::hits);
    let error = hits.map(|hits| hits.error_texels(number, pixel)).filter(|error| error.is_finite());
    let exact_uv = hits.and_then(|hits| hits.hit(number)).map(|hit| hit.uv);
    if pixel.hit == 0 {
        return json!({ "hit": false, "exact_uv": exact_uv });
    }
    let PixelOut { uv, height, position, normal, depth, reads, steps, level, surface, .. } = pixel;
    let height_m =
        scene.surfaces().get(*surface as usize).filter(|surface| surface.object().is_none()).map(|surface| {
            let map = surface.height_map();
            f64::from(*height) * map.scale_m() + map.bias_m()
        });
    let own = scene.surfaces().get(*surface as usize).filter(|_| scene.surfaces().len() > 1);
    let method = own.map(|surface| surface.selection().method_name());
    json!({
        "hit": true, "uv": [uv.x, uv.y], "height_m": height_m, "depth_m": depth,
        "position_m": [position.x, position.y, position.z], "normal": [normal.x, normal.y, normal.z],
        "reads": reads, "steps": steps, "level": level, "surface": surface, "method": method,
        "error_texels": error, "exact_uv": exact_uv,
    })
}
