//! Texts of the help of `relief mesh`: examples, and its lists of rules.

use relief_mesh::{EDGE_RULES, INTERIORS};

pub(super) const AFTER_HELP: &str = "Examples:\n  \
    relief mesh dem.tif -o dem.glb                                # to half a percent of the scale\n  \
    relief mesh dem.tif --error 2m --tiles 4x4 -o dem.glb         # to 2 m of the ground, in 16 files\n  \
    relief mesh dem.tif --exaggerate 2 -o dem.glb                 # twice as high\n  \
    relief mesh dem.tif --print-size 150 --solid 3 -o dem.stl     # 15 cm long, to print\n  \
    relief mesh island.tif --holes --solid 3 --print-size 150 -o island.stl  # the outline cut out\n  \
    relief mesh bark.png --mesh panel.obj --scale 1mm --solid 2 -o panel.stl  # a curved sheet\n  \
    relief mesh dem.tif --texels 1 -o dem.glb                     # one vertex per texel\n  \
    relief mesh dem.tif --error 2m --quantize 12 -o dem.glb       # a third smaller, in integers\n  \
    relief mesh dem.tif --error 2m --strips -o dem.glb            # a fifth smaller, as strips\n  \
    relief mesh dem.tif --error 5% --maps normal -o dem.glb       # few triangles, all of the shading\n  \
    relief mesh Bricks090 --scale 2cm --error 5% --maps normal -o bricks.glb  # with a folder's material\n  \
    relief mesh dem.tif --error 1m --lods 4 -o dem.glb            # and three coarser levels\n  \
    relief mesh dem.tif --view flight.toml --pixels 2 -o dem.glb  # one vertex per two pixels\n  \
    relief mesh bark.png --mesh tree.obj --scale 2cm -o tree.glb  # on a textured mesh\n  \
    relief mesh bark.png --mesh tree.obj --scale 2cm --error 1% -o tree.glb  # with few triangles\n  \
    relief mesh wall.png --mesh sphere --tile 8,4 --base lift -o ball.ply\n  \
    relief mesh --motif mail.glb --mesh torus --tile 9,3 -o armour.glb  # chain mail of `relief motif`\n  \
    relief mesh --motif data/mushrooms.exr --mesh panel.obj --tile 2,2 -o grown.glb  # a vector displacement map\n\n\
    The triangles show the same relief as `relief render` with the same --scale and --bias. By default it is \
    carved into the mesh; --bias 0 puts it on top.\n\n\
    A plane whose map knows its metres (by its file or --tile-size) is as long as the ground. Its lowest \
    height is then at y = 0, x is east and z south. --scale, --bias and --error are lengths of it, and \
    --exaggerate N makes heights N times as high. Other planes are 1 m long.\n\n\
    On planes, and with --error elsewhere, triangles are as large as the tolerance allows. No point of the \
    relief is farther from them, measured from the same point of the mesh; the answer says how far it is and \
    where. --shading mesh smooths the effect on normals of texels much finer than the triangles.\n\n\
    Without --seams keep the file has no cracks where the mesh has none. The answer counts open edges (a \
    sheet's border is open) and folded triangles, with the numbers of the mesh's triangles, from 0, that \
    they belong to. Look at the file with `relief render --mesh FILE`, `relief inspect FILE`, or any viewer \
    of glTF.";

pub(super) fn edges_help() -> String {
    let rows = EDGE_RULES.iter().map(|rule| (rule.name, rule.summary));
    listed("Edge rule, which divides the mesh's edges", rows)
}

pub(super) fn interior_help() -> String {
    let rows = INTERIORS.iter().map(|interior| (interior.name, interior.summary));
    listed("Interior, which fills the mesh's triangles", rows)
}

fn listed<'a>(what: &str, rows: impl Iterator<Item = (&'a str, &'a str)>) -> String {
    let rows: Vec<(&str, &str)> = rows.collect();
    let listed: Vec<String> = rows.iter().map(|(name, summary)| format!("{name} ({summary})")).collect();
    let default = rows.first().map_or("", |(name, _)| name);
    format!("{what}: {} [default: {default}]", listed.join(", "))
}
