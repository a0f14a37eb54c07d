//! Claims of Kautz and Seidel about slices, measured on pictures of planes, of an
//! object's images and of a cup's.

use std::sync::Arc;

use glam::DVec3;
use relief_core::camera::{Camera, Projection};
use relief_core::object::{ImageObject, JumpCells, View};
use relief_core::raycast::Ray;
use relief_core::{HeightMap, Watch, Wrap};
use relief_mesh::{BoxSlicer, SliceAnchor, SliceDirection, SliceSettings};
use relief_scene::BackendChoice;
use relief_shaders::cpu::PixelOut;

use crate::accuracy;
use crate::object_pictures::{EYES, pixels, selection};
use crate::slices::PlaneView;
use crate::spheres::{CUBE, object_of_spheres};

/// Columns and rows of the pictures of planes.
const SIZE: u32 = 160;

/// Metres of relief on a plane of a metre.
const SCALE_M: f64 = 0.15;

/// The part of the way by which the eye comes nearer, to see whether slices jump.
const DOLLY: f64 = 0.001;

/// A claim about pictures: one has less of something than a part of what another has.
#[derive(Clone, Copy, Debug)]
pub struct PictureClaim {
    /// Section or figure.
    pub section: &'static str,
    /// The claim in words.
    pub text: &'static str,
    /// Subjects that are said to have less and more.
    pub of: [&'static str; 2],
    /// Compared quantity.
    pub measure: &'static str,
    /// The part of the second that the first stays below.
    pub factor: f64,
    /// Measured result.
    pub holds: bool,
    /// Both, measured.
    figures: fn() -> [f64; 2],
}

/// A claim measured.
#[derive(Clone, Copy, Debug)]
pub struct PictureVerdict {
    /// The claim.
    pub claim: &'static PictureClaim,
    /// Values of the subject with less and of the one with more.
    pub figures: [f64; 2],
}

impl PictureVerdict {
    /// Whether what was measured bears the claim out.
    pub fn holds(&self) -> bool {
        self.figures[0] < self.claim.factor * self.figures[1]
    }
}

/// Measures all of them.
pub fn picture_verdicts() -> Vec<PictureVerdict> {
    CLAIMS.iter().map(|claim| PictureVerdict { claim, figures: (claim.figures)() }).collect()
}

/// All of them. Where nothing else is said 16 slices are drawn over cobbles.
pub const CLAIMS: &[PictureClaim] = &[
    PictureClaim {
        section: "3.1, Figure 4",
        text: "along the base one looks between the slices at grazing angles",
        of: ["slices-surface at 20°", "slices-surface at 80°"],
        measure: "seen through, share",
        factor: 0.1,
        holds: true,
        figures: || [through("slices-surface", 20.0), through("slices-surface", 80.0)],
    },
    PictureClaim {
        section: "3.2, Figure 7",
        text: "orthogonal slicing closes what is open at grazing angles",
        of: ["slices-orthogonal at 80°", "slices-surface at 80°"],
        measure: "seen through, share",
        factor: 0.5,
        holds: true,
        figures: || [through("slices-orthogonal", 80.0), through("slices-surface", 80.0)],
    },
    PictureClaim {
        section: "3.4, Figure 10",
        text: "few slices are acceptable along the base, as many upright ones are not, seen from above",
        of: ["slices-surface at 20°", "20 upright ones there"],
        measure: "median texels",
        factor: 0.5,
        holds: true,
        figures: along_and_upright,
    },
    PictureClaim {
        section: "3.4",
        text: "with as many metres between upright slices the fill stays almost the same, in a picture",
        of: ["slices-orthogonal at 80°", "slices-surface at 80°"],
        measure: "fragments a pixel",
        factor: 1.25,
        holds: false,
        figures: || [fragments("slices-orthogonal", 80.0), fragments("slices-surface", 80.0)],
    },
    PictureClaim {
        section: "3.3, Figure 10",
        text: "slices at equal depths are the best, slice for slice",
        of: ["slices-screen at 60°", "slices-orthogonal at 60°"],
        measure: "median texels",
        factor: 1.0,
        holds: true,
        figures: || [median("slices-screen", 60.0), median("slices-orthogonal", 60.0)],
    },
    PictureClaim {
        section: "3.3, Figure 10",
        text: "they are the best, fragment for fragment",
        of: ["slices-screen at 60°", "slices-orthogonal at 60°"],
        measure: "median x fragments",
        factor: 0.9,
        holds: false,
        figures: || ["slices-screen", "slices-orthogonal"].map(|of| median(of, 60.0) * fragments(of, 60.0)),
    },
    PictureClaim {
        section: "3.3",
        text: "slices of one size that a texture's border clips take up a lot of fill rate",
        of: ["slices-screen at 60°", "clipped by a border"],
        measure: "fragments of the picture",
        factor: 0.8,
        holds: true,
        figures: cut_off_and_clipped,
    },
    PictureClaim {
        section: "3.4",
        text: "they flicker when the eye moves, others hardly do",
        of: ["slices-orthogonal at 60°", "slices-screen at 60°"],
        measure: "jumping, share",
        factor: 0.5,
        holds: true,
        figures: || [jumps("slices-orthogonal", 60.0), jumps("slices-screen", 60.0)],
    },
    PictureClaim {
        section: "5",
        text: "an object's slices from an angle fill up to 20 % less, and are as much faster",
        of: ["from between two axes", "from along one"],
        measure: "fragments",
        factor: 0.83,
        holds: true,
        figures: from_an_angle,
    },
    PictureClaim {
        section: "5, Figure 15",
        text: "the visual hull of the same images is another object",
        of: ["depth-object", "visual-hull"],
        measure: "pixels apart, share",
        factor: 0.5,
        holds: true,
        figures: || [of_spheres("depth-object"), of_spheres("visual-hull")],
    },
    PictureClaim {
        section: "5",
        text: "a visual hull has no cups, which images with depth have",
        of: ["depth-object", "visual-hull"],
        measure: "heights in the cup",
        factor: 0.5,
        holds: true,
        figures: || [height_in_cup("depth-object"), height_in_cup("visual-hull")],
    },
    PictureClaim {
        section: "5",
        text: "70 slices are good where the object is 150 pixels wide: no farther behind it than two pixels",
        of: ["depth-object-slices", "a pixel"],
        measure: "pixels behind, median",
        factor: 2.0,
        holds: true,
        figures: || [behind(70.0), 1.0],
    },
];

fn cobbles() -> Arc<HeightMap> {
    let map = accuracy::maps().into_iter().find(|map| map.name == "cobbles").expect("a listed map").map;
    Arc::new(map.with_displacement(SCALE_M, -SCALE_M).expect("lengths"))
}

/// Makes something of the view of a plane from that many degrees beside its normal.
fn on_plane<T>(degrees: f64, of: impl FnOnce(&PlaneView) -> T) -> T {
    of(&PlaneView { map: &cobbles(), degrees, away_m: 2.0, size: SIZE })
}

fn exact(view: &PlaneView) -> Vec<PixelOut> {
    view.pixels("exact", &[], BackendChoice::Cpu)
}

fn drawn(view: &PlaneView, method: &str) -> Vec<PixelOut> {
    view.pixels(method, &[("slices.count", 16.0)], BackendChoice::Cpu)
}

fn through(method: &str, degrees: f64) -> f64 {
    on_plane(degrees, |view| {
        view.errors(&exact(view), &drawn(view, method), view.along_m(method, 1.0 / 16.0)).see_through
    })
}

fn median(method: &str, degrees: f64) -> f64 {
    on_plane(degrees, |view| {
        view.errors(&exact(view), &drawn(view, method), view.along_m(method, 1.0 / 16.0)).median
    })
}

fn fragments(method: &str, degrees: f64) -> f64 {
    on_plane(degrees, |view| view.fragments(&exact(view), view.settings(method, 16)))
}

fn jumps(method: &str, degrees: f64) -> f64 {
    on_plane(degrees, |view| {
        let nearer = PlaneView { away_m: view.away_m * (1.0 - DOLLY), ..*view };
        let [before, after] = [view, &nearer].map(|view| (exact(view), drawn(view, method)));
        view.jumps([&before.0, &before.1], [&after.0, &after.1], view.along_m(method, 1.0 / 16.0))
    })
}

/// Fragments of slices at equal depths that end where the relief does, and of those that a border clips.
fn cut_off_and_clipped() -> [f64; 2] {
    let map = Arc::new((*cobbles()).clone().with_wrap(Wrap::Clamp));
    let view = PlaneView { map: &map, degrees: 60.0, away_m: 2.0, size: SIZE };
    [SliceDirection::Screen, SliceDirection::Quads].map(|of| {
        view.fragments_of_all(SliceSettings { count: 16, direction: of(view.camera(), SliceAnchor::Eye) })
    })
}

/// Sixteen slices along the base, and twenty upright ones over the whole plane.
fn along_and_upright() -> [f64; 2] {
    on_plane(20.0, |view| {
        let upright = [("slices.count", 3.0), ("slices.direction", 2.0)];
        [("slices-surface", &[("slices.count", 16.0)][..]), ("slices-orthogonal", &upright)].map(
            |(method, set)| {
                let slices = view.pixels(method, set, BackendChoice::Cpu);
                view.errors(&exact(view), &slices, 1.0).median
            },
        )
    })
}

/// Fragments of the slices through a box, from between two axes and from along one.
fn from_an_angle() -> [f64; 2] {
    let bounds = [DVec3::splat(-1.0), DVec3::splat(1.0)];
    [DVec3::new(1.0, 0.0, 1.0), DVec3::Z].map(|from| {
        let camera =
            Camera::with(from.normalize() * 4.0, DVec3::ZERO, Projection::Orthographic { height_m: 4.0 });
        let camera = camera.expect("a camera");
        let slicer = BoxSlicer::new(bounds, 0.02, SliceDirection::Facing(camera)).expect("slices");
        let mut area = 0.0;
        let take = |slice: &relief_mesh::BoxSlice| {
            let turned = (2..slice.len()).map(|k| (slice[k - 1] - slice[0]).cross(slice[k] - slice[0]));
            area += 0.5 * turned.sum::<DVec3>().dot(camera.forward()).abs();
        };
        slicer.each(&Watch::none(), take).expect("slices");
        area
    })
}

/// The share of pixels that do not show the spheres where they do, or the other way round.
fn of_spheres(method: &str) -> f64 {
    let object = object_of_spheres(&CUBE, 96, JumpCells::Highest);
    let each = EYES.map(|eye| {
        let shown = pixels(&object, selection(method, &[]), eye, BackendChoice::Cpu);
        1.0 - crate::object_pictures::beside_truth(&shown, eye).0
    });
    each.iter().sum::<f64>() / 3.0
}

/// How high something is seen in the middle of a cup, from above: from 0 at its floor to 1 at its rim.
fn height_in_cup(method: &str) -> f64 {
    // Walls from a radius of a half on, the floor half a metre below the rim.
    let seen = |ray: &Ray| {
        let steps = (0..4000).map(|step| f64::from(step) * 1e-3);
        steps.map(|t| ray.at(t)).find(|at| {
            let radius = at.x.hypot(at.z);
            radius < 0.7 && at.y.abs() < 0.5 && (radius > 0.5 || at.y < 0.0)
        })
    };
    let (views, maps): (Vec<View>, Vec<HeightMap>) = CUBE
        .iter()
        .map(|from| {
            let view = View::orthographic(DVec3::ZERO, 1.0, *from, None, [48; 2]).expect("a view");
            let texel = |x: u32, y: u32| {
                let [u, v] = [x, y].map(|at| (f64::from(at) + 0.5) / 48.0);
                let point = seen(&view.ray(u, v)).and_then(|point| view.see(point));
                point.map_or(0.0, |at| at.z.clamp(0.0, 1.0) as f32)
            };
            let map = HeightMap::from_fn(48, 48, Wrap::Clamp, texel).expect("a map");
            (view, map)
        })
        .unzip();
    let object = ImageObject::new(views, &maps, JumpCells::Highest, 4.0).expect("an object");
    let eye = DVec3::new(0.02, 4.0, 0.03);
    let shown = pixels(&object, selection(method, &[]), eye, BackendChoice::Cpu);
    let middle = shown.iter().filter(|pixel| {
        pixel.hit == 1 && f64::from(pixel.position.x).hypot(f64::from(pixel.position.z)) < 0.3
    });
    let heights: Vec<f64> = middle.map(|pixel| f64::from(pixel.position.y) / 0.5).collect();
    heights.iter().sum::<f64>() / heights.len() as f64
}

/// Distance of the median pixel behind the object with a number of slices, in pixels of a picture in which
/// the ball is 150 pixels wide.
fn behind(count: f64) -> f64 {
    let object = object_of_spheres(&CUBE, 96, JumpCells::Highest);
    let [slices, whole] = [("depth-object-slices", &[("slices.count", count)][..]), ("depth-object", &[])]
        .map(|(method, set)| pixels(&object, selection(method, set), EYES[0], BackendChoice::Cpu));
    let both = slices.iter().zip(&whole).filter(|(slice, whole)| slice.hit == 1 && whole.hit == 1);
    let mut behind: Vec<f64> = both.map(|(slice, whole)| f64::from(slice.depth - whole.depth)).collect();
    behind.sort_by(f64::total_cmp);
    behind.get(behind.len() / 2).copied().unwrap_or(f64::INFINITY) / (2.0 / 150.0)
}
