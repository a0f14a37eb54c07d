//! Curved surfaces beside the exact judge of displaced meshes: their outlines, where rays hit them, and that
//! nothing shines through.

use std::sync::OnceLock;

use glam::{DVec3, Vec2, Vec3};
use relief_core::HeightMap;
use relief_core::mesh::{Mesh, Vertex, cylinder, sphere, torus};
use relief_core::rng::Rng;
use relief_render::Renderer;
use relief_scene::{BackendChoice, Sampling};
use relief_testing::outline::distances;
use relief_tests::accuracy::maps;
use relief_tests::adapter::has_adapter;
use relief_tests::curved::{Comparison, Curved, Drawn, Judged, Picture};

/// Metres between the heights 0 and 1: a tenth of a tile, a fifth of the torus' tube.
const SCALE_M: f64 = 0.03;

/// Height 1 on the mesh, and height 0.
const BIASES_M: [f64; 2] = [-SCALE_M, 0.0];

/// Tiles over a mesh.
const TILES: Vec2 = Vec2::new(6.0, 3.0);

const SIZE: [u32; 2] = [160, 120];

const TETRAHEDRA: Drawn = Drawn::flat("tetrahedra");
const PRISM: Drawn = Drawn::flat("prism");
const LIFTED: Drawn = Drawn { lifted: true, ..PRISM };

/// Views in which cracks are looked for, of each mesh on the CPU.
const CRACK_VIEWS: usize = 24;

/// Views for each mesh on the GPU, which in tests is the CPU.
const CRACK_VIEWS_GPU: usize = 6;

fn cobbles() -> &'static HeightMap {
    static MAP: OnceLock<HeightMap> = OnceLock::new();
    MAP.get_or_init(|| maps().into_iter().find(|named| named.name == "cobbles").expect("a sample map").map)
}

fn relief(mesh: Mesh, bias_m: f64) -> Curved {
    Curved::new(mesh.tiled(TILES).expect("a few tiles"), cobbles(), SCALE_M, bias_m)
}

fn meshes() -> [(&'static str, Mesh); 4] {
    [
        ("torus 32x16", torus(32, 16)),
        ("torus 16x8", torus(16, 8)),
        ("sphere 32x16", sphere(32, 16)),
        ("cylinder 32", cylinder(32, 1)),
    ]
    .map(|(name, mesh)| (name, mesh.expect("a mesh")))
}

/// A torus whose tube swells and narrows so often that a relief is deeper than it is bent: inward on the
/// ridges, outward in the valleys.
fn rippled_torus() -> Mesh {
    let torus = torus(96, 24).expect("a mesh");
    let swell = |vertex: &Vertex| 0.03 * (12.0 * std::f32::consts::TAU * vertex.uv.x).cos();
    let positions = torus.vertices().iter().map(|vertex| vertex.position + vertex.normal * swell(vertex));
    let positions: Vec<Vec3> = positions.collect();
    let welded = torus.welded();
    let mut normals = vec![Vec3::ZERO; positions.len()];
    for triangle in torus.triangles() {
        let [a, b, c] = triangle.map(|vertex| positions[vertex as usize]);
        for vertex in triangle {
            normals[welded[*vertex as usize] as usize] += (b - a).cross(c - a);
        }
    }
    let vertices =
        torus.vertices().iter().zip(&positions).zip(&welded).map(|((vertex, position), welded)| {
            let normal = normals[*welded as usize].normalize();
            Vertex { position: *position, normal, ..*vertex }
        });
    Mesh::new(vertices.collect(), torus.triangles().to_vec()).expect("a mesh")
}

/// A relief from two sides, drawn so, beside the judge of another; or, without `hits`, its outlines alone.
fn compared(of: &Curved, drawn: Drawn, truth: &Curved, hits: bool) -> Comparison {
    let (mut renderer, mut comparison, judge) = (Renderer::on_cpu(), Comparison::default(), truth.judge());
    for from in [DVec3::new(0.6, 0.9, 1.1), DVec3::new(-1.0, 0.3, 0.2)] {
        let camera = of.camera(from, 1.0);
        let scene = of.scene(drawn, camera, SIZE, BackendChoice::Cpu);
        let judged = Judged::new(&judge, camera, SIZE);
        let picture = Picture::rendered(&scene, &mut renderer);
        if hits {
            comparison.add(&picture, &judged, of);
        } else {
            comparison.add_outline(&picture, &judged.picture);
        }
    }
    let outline = [0.5, 0.95, 0.99].map(|part| comparison.outline_at(part));
    println!("{drawn:?}: outline {outline:.2?}, overlap {:.4}", comparison.overlap());
    comparison
}

#[test]
fn shells_as_they_are_show_what_the_judge_sees() {
    for (name, mesh) in meshes() {
        for bias_m in BIASES_M {
            println!("prism on {name}, from {bias_m} m");
            let relief = relief(mesh.clone(), bias_m);
            let comparison = compared(&relief, PRISM, &relief, true);
            let Comparison { inside, both, open, behind, all, .. } = &comparison;
            println!(
                "of {both} hits {}: texels {:.5} {:.4}, beyond half {:.5} (of all {:.5}), \
                 depths {:.6} {:.5}; {open} open, {behind} behind",
                inside.texels.len(),
                inside.texels_at(0.5),
                inside.texels_at(0.99),
                inside.beyond_half(),
                all.beyond_half(),
                inside.depths_at(0.5),
                inside.depths_at(0.99),
            );
            assert!(comparison.outline_at(0.95) <= 1.0 && comparison.outline_at(0.99) <= 2.0, "{name}");
            // Little lies at a silhouette or behind an open hard edge.
            assert!(inside.texels.len() as f64 > 0.95 * *both as f64, "{name}");
            assert!(inside.texels_at(0.5) <= 0.005 && inside.texels_at(0.99) <= 0.05, "{name}");
            assert!(inside.depths_at(0.5) <= 0.0005 && inside.depths_at(0.99) <= 0.005, "{name}");
            assert!(inside.beyond_half() <= 0.001 && all.beyond_half() <= 0.005, "{name}");
            assert_eq!([*open, *behind], [0, 0], "{name}");
        }
    }
}

#[test]
fn tetrahedra_have_the_judges_outlines() {
    for (name, mesh) in meshes() {
        for bias_m in BIASES_M {
            println!("tetrahedra on {name}, from {bias_m} m");
            let relief = relief(mesh.clone(), bias_m);
            let comparison = compared(&relief, TETRAHEDRA, &relief, false);
            assert!(comparison.outline_at(0.95) <= 1.5, "{name}");
        }
    }
}

#[test]
fn a_smooth_base_has_the_outline_of_the_smooth_torus() {
    let smooth = torus(512, 256).expect("a mesh");
    for ([around, tube], most) in [([32, 16], 1.5), ([16, 8], 4.0)] {
        for bias_m in BIASES_M {
            println!("torus {around}x{tube}, from {bias_m} m");
            let coarse = relief(torus(around, tube).expect("a mesh"), bias_m);
            let smooth = relief(smooth.clone(), bias_m);
            let [flat, lifted] = [PRISM, LIFTED].map(|drawn| compared(&coarse, drawn, &smooth, false));
            assert!(lifted.outline_at(0.95) <= most, "{around}x{tube}");
            assert!(1.0 - lifted.overlap() < 0.4 * (1.0 - flat.overlap()), "{around}x{tube}");
        }
    }
}

/// Looks for background that shows through reliefs, from a number of random sides, far and near.
fn look_for_cracks(backend: BackendChoice, views: usize) {
    let mut rng = Rng::new(3);
    let mut renderer = Renderer::new(backend, Sampling::default()).expect("a renderer");
    for (name, mesh) in
        meshes().into_iter().filter(|(name, _)| ["torus 32x16", "sphere 32x16"].contains(name))
    {
        for bias_m in BIASES_M {
            let relief = relief(mesh.clone(), bias_m);
            let (judge, mut comparison) = (relief.judge(), Comparison::default());
            for view in 0..views / 2 {
                let closeness = if view % 2 == 0 { 1.0 } else { rng.between(1.0, 2.0) };
                let camera = relief.random_camera(&mut rng, closeness);
                let scene = relief.scene(PRISM, camera, SIZE, backend);
                let judged = Judged::new(&judge, camera, SIZE);
                comparison.add(&Picture::rendered(&scene, &mut renderer), &judged, &relief);
            }
            let Comparison { both, open, behind, all_behind, .. } = comparison;
            println!(
                "{name}, from {bias_m} m: {both} hits, {open} open, {behind} behind (of all {all_behind})"
            );
            assert!(both > views * 1000, "{name}: hardly anything is seen");
            assert_eq!([open, behind], [0, 0], "{name}");
        }
    }
}

#[test]
fn nothing_shines_through_on_the_cpu() {
    look_for_cracks(BackendChoice::Cpu, CRACK_VIEWS);
}

#[test]
fn nothing_shines_through_on_the_gpu() {
    if has_adapter() {
        look_for_cracks(BackendChoice::Gpu, CRACK_VIEWS_GPU);
    }
}

#[test]
fn shells_that_overlap_themselves_show_what_the_judge_sees() {
    let (mut rng, mut renderer) = (Rng::new(5), Renderer::on_cpu());
    let mesh = rippled_torus();
    for bias_m in BIASES_M {
        let folded = mesh.folded([bias_m, bias_m + SCALE_M]);
        assert!(folded > 200 && folded < mesh.triangles().len() / 2, "{folded} shells are folded");
        let relief = relief(mesh.clone(), bias_m);
        let (judge, mut comparison) = (relief.judge(), Comparison::default());
        let mut in_pieces = Comparison::default();
        for closeness in [1.0, 1.5] {
            let camera = relief.random_camera(&mut rng, closeness);
            let judged = Judged::new(&judge, camera, SIZE);
            for (drawn, comparison) in [(PRISM, &mut comparison), (TETRAHEDRA, &mut in_pieces)] {
                let scene = relief.scene(drawn, camera, SIZE, BackendChoice::Cpu);
                comparison.add(&Picture::rendered(&scene, &mut renderer), &judged, &relief);
            }
        }
        let Comparison { inside, both, open, behind, .. } = &comparison;
        println!(
            "from {bias_m} m: {folded} shells folded, {both} hits, {} compared, beyond half {:.5}, {open} \
             open, {behind} behind; tetrahedra {} open, {} behind",
            inside.texels.len(),
            inside.beyond_half(),
            in_pieces.open,
            in_pieces.behind
        );
        assert!(inside.texels.len() > 10_000 && inside.beyond_half() <= 0.001);
        assert_eq!([*open, *behind], [0, 0], "from {bias_m} m");
    }
}

#[test]
fn the_comparison_notices_changes() {
    let relief = relief(torus(16, 8).expect("a mesh"), 0.0);
    let camera = relief.camera(DVec3::new(0.6, 0.9, 1.1), 1.0);
    let judge = relief.judge();
    let judged = Judged::new(&judge, camera, SIZE);
    let seen = &judged.picture;
    let compared = |changed: &Picture| {
        let mut comparison = Comparison::default();
        comparison.add(changed, &judged, &relief);
        comparison
    };
    let same = compared(seen);
    assert_eq!((same.outline_at(1.0), same.overlap(), same.open, same.behind), (0.0, 1.0, 0, 0));
    assert_eq!((same.inside.texels_at(1.0), same.inside.depths_at(1.0)), (0.0, 0.0));
    assert!(same.inside.texels.len() > same.both * 9 / 10 && same.all.texels.len() == same.both);

    // Three pixels to the right.
    let mask = seen.mask().filled();
    let apart = distances(&mask, &mask.moved(3));
    assert!(apart.iter().filter(|apart| **apart > 2.0).count() > apart.len() / 4);
    let moved = |by: usize| {
        let mut moved = seen.clone();
        moved.met.rotate_right(by);
        compared(&moved)
    };
    assert!(moved(3).outline_at(0.95) > 2.0 && moved(3).overlap() < 0.97);

    // A tenth of a texel, and a whole tile with it, which does not count.
    let mut aside = seen.clone();
    for met in aside.met.iter_mut().flatten() {
        met.uv = [met.uv[0] + 0.1 / f64::from(cobbles().width()), met.uv[1] - 1.0];
    }
    let aside = compared(&aside);
    assert!((aside.inside.texels_at(0.5) - 0.1).abs() < 1e-6 && aside.inside.beyond_half() == 0.0);

    // One pixel in the middle of what is seen, open or far behind.
    let inner = seen.mask().eroded();
    let [columns, rows] = SIZE;
    let is_inner = |pixel: &u32| inner.at((pixel % columns).into(), (pixel / columns).into());
    let inner: Vec<u32> = (0..columns * rows).filter(is_inner).collect();
    let mut open = seen.clone();
    open.met[inner[inner.len() / 2] as usize] = None;
    let open = compared(&open);
    assert_eq!((open.open, open.all_open, open.outline_at(1.0)), (1, 1, 0.0));
    let mut behind = seen.clone();
    for pixel in inner {
        if let Some(met) = &mut behind.met[pixel as usize] {
            met.depth_m += 1.1 * SCALE_M;
        }
    }
    let behind = compared(&behind);
    assert!(behind.behind > behind.both / 2 && behind.all_behind > behind.behind);
}
