// The shaders' declarations as they are written, and the names that each uses. Written by `cargo xtask link`;
// do not edit.

use crate::wgsl::{Declaration, Module, Sampling};

pub const MODULES: &[Module] = &[
    Module { path: "bindings", head: r#""# },
    Module { path: "constants", head: r#""# },
    Module { path: "shared/angle", head: r#"// Angles in turns (1 turn is the whole circle), in plain arithmetic. The trigonometric functions of
// GPUs differ from one GPU to the next.
"# },
    Module { path: "shared/background", head: r#"// The background of a picture: the colour of pixels without a surface.
"# },
    Module { path: "shared/base", head: r#"// A pixel's base triangle, as a plane.
"# },
    Module { path: "shared/bounding_box", head: r#"// Boxes around the shells of base triangles, for the rasteriser.
"# },
    Module { path: "shared/cell", head: r#"// Ray against one dual cell, shared by the searches that visit cells and the patch refinement.
//
// In a cell the bilinear surface along the path is a quadratic. The gap between path and surface is
// c.x + c.y s + c.z s², where s counts from the parameter t at which the path enters the cell.
"# },
    Module { path: "shared/cone", head: r#"// Cones on texels, shared by the searches that step over them.
"# },
    Module { path: "shared/cost", head: r#"// The cost of search and refinement so far, in one vector: reads, steps, and bytes that the reads
// fetched. Heights count as 32-bit floats, texels of baked maps as they are stored. Caches are not
// taken into account.
"# },
    Module { path: "shared/dice", head: r#"// A fixed pattern that fills a triangle whose sides are divided into any numbers of parts.
//
// The triangle is cut in rows along its side of fewest parts, from the corner across from it. Let
// `m` be the larger and `n` the smaller number of parts of the two other sides. Row `r` of `m` goes
// from point `ceil(r n / m)` of one of them to point `r` of the other. It is divided into `r / m`
// of the short side's parts, rounded up. Two neighbouring rows are zipped: of the two next points
// the one that lies less far along its row comes first.
//
// The numbers of points and triangles before a row are sums of quotients that are rounded down,
// which have a formula. So any point and any triangle is found by its number.
"# },
    Module { path: "shared/disc", head: r#"// The disc of a light, as a point of the surface sees it.
"# },
    Module { path: "shared/displacement", head: r#"// The space that the relief fills above the base surface: its depth, the base's height in it, the
// directions of the world in it, and the edges of its footprint.
"# },
    Module { path: "shared/environment", head: r#"// The environment map: light that comes from far away, on the faces of a cube.
//
// The texels at a face's border lie on the edges of the cube. So faces that meet have the same
// texels there, and light changes without a seam. Each level after the first holds the light within
// lobes twice as wide as in the level before. In the last one they are cosines.
"# },
    Module { path: "shared/facets", head: r#"// The part of the light from all around that a rough surface reflects.
//
// The integral of facets after Trowbridge and Reitz, with Smith's hidden part, over all directions of
// the light, split into a factor of the colour along the normal and a rest (Karis 2013). Both are
// polynomials of the view's cosine over itself plus the width of the lobe, fitted to the integral from
// roughness 0.045 to 1. The sum of both differs by at most 0.65 %, the rest by at most 0.007 up to 88
// degrees.
"# },
    Module { path: "shared/factors", head: r#"// Ways of compressed view-dependent maps: sums of products, a factor of the texel times a factor of the view.
//
// A layer has four terms. Below the factors of the texels lie the views' factors, row after row, and the
// scales of the terms. relief-bake's module `view_dependent` has the layout.
"# },
    Module { path: "shared/folded", head: r#"// Ways of a ray through a shell that overlaps itself.
//
// The points of a shell that are as far out along the interpolated normals are a flat triangle. The
// ray's line meets it in one point however the shell is folded, so the way is a function of that
// offset. The weights of the triangle's corners q_k = p_k + n_k o there are d·(q_i × q_j) over the
// sum of the three. These are quadratics in the offset o. The roots of the same quadratics for a
// triangle that is larger by rounding cut the offsets into pieces: over each, the way is inside the
// shell or it is not.
"# },
    Module { path: "shared/footprint", head: r#"// The area of a surface that a sample of a pixel covers.
//
// Footprints follow from the rays of the neighbouring pixels, not from derivatives, so that any ray
// has a footprint.
"# },
    Module { path: "shared/frames", head: r#"// The frames of a grid in the order of an octahedral mapping. Three of them surround each
// direction.
//
// Engelhardt and Dachsbacher 2008; Brucks 2018.
"# },
    Module { path: "shared/fresnel", head: r#"// Light at a smooth surface between air and a material: Snell's law and Fresnel's equations.
"# },
    Module { path: "shared/height", head: r#"// The one module that reads the textures of a surface: heights, holes, colours, normals, materials.
//
// `exact` loads texels and interpolates in plain arithmetic, which gives the same bits on every machine.
// `fast` lets a sampler do it, in the precision and with the wrap of the sampler.
//
// Texel (i, j) has its centre at ((i + ½) / W, (j + ½) / H); dual cell (i, j) lies between the centres of the
// texels (i, j) and (i + 1, j + 1).
"# },
    Module { path: "shared/hemisphere", head: r#"// The light of a sky above and ground below.
"# },
    Module { path: "shared/image", head: r#"// Dual cells beside the map, and the cells of the map over which the surface is the same.
"# },
    Module { path: "shared/image_cell", head: r#"// The surface between the texels of an object's images.
"# },
    Module { path: "shared/interval", head: r#"// The interval that the bracketing refinements begin with.
"# },
    Module { path: "shared/levels", head: r#"// Levels of detail of a map.
"# },
    Module { path: "shared/light", head: r#"// Lights, as a point of the surface sees them.
"# },
    Module { path: "shared/light_map", head: r#"// Shadow maps, looked up from a point of a surface.
//
// A texel holds the key of the nearest hit of its ray. The point is compared with it where the
// texel's ray meets the surface's tangent plane. Where the surface is that plane, no texel is
// nearer.
"# },
    Module { path: "shared/light_ray", head: r#"// Rays from a hit toward a light, through the relief of the same surface.
"# },
    Module { path: "shared/maps", head: r#"// The one module that reads baked maps.
//
// Slices, azimuths, directions and the faces of a cube are layers. A map of 8 bits holds codes.
// They are recovered from the normalised texels of the GPU and turned into values here, so that
// values have the same bits everywhere.
"# },
    Module { path: "shared/material", head: r#"// Material maps: what a surface is made of, from texel to texel.
"# },
    Module { path: "shared/motif", head: r#"// Motifs: triangles in the space of a tile, in a tree of boxes. A texture holds both, in the slot of an
// object's images.
//
// Porumbescu, Budge, Feng and Joy 2005; Szirmay-Kalos and Umenhoffer 2008, section 5.2. The walk through the
// tree needs no stack: each node knows the one behind its children. Which rays meet a triangle is decided as
// by Woop, Benthin and Wald 2013: seen along the ray, by the sides of its edges.
"# },
    Module { path: "shared/normal", head: r#"// The mesostructure's normal in the finest level, in the world, and tangent space.
//
// Szirmay-Kalos and Umenhoffer 2008, section 2.1, equation 9: derivatives of the height by central
// differences over two texels, or a tangent-space normal map.
//
// A normal field that is interpolated shows artefacts where it is discontinuous, as at creases
// (section 2.2). A central difference is a mean of slopes. Half of it is the slope of the point's
// own dual cell, the rest the slopes of the cells before and behind, by how near they are. With
// creases kept, the own cell replaces a neighbour as far as there is a crease between both. Between
// two creases that leaves the derivative of the own bilinear patch, beside one a difference to the
// other side, and elsewhere the central one.
//
// At the edges of a clamped map differences are taken inside, since nothing is known of the ground
// beyond. An even slope has one normal everywhere, and tiles of a terrain have no rim.
"# },
    Module { path: "shared/numbered", head: r#"// The base triangles of a surface, by their number.
"# },
    Module { path: "shared/object", head: r#"// Images of an object, and the object's colour.
"# },
    Module { path: "shared/object_color", head: r#"// The colour of an object's material.
//
// Kautz and Seidel 2001, section 4.2.
"# },
    Module { path: "shared/object_path", head: r#"// Rays on their way through the images of an object. Each image is a relief on a plane of its own.
//
// Kautz and Seidel 2001, section 4.
"# },
    Module { path: "shared/patch_normal", head: r#"// Normals of the surface's patches, without a pixel's footprint.
"# },
    Module { path: "shared/path", head: r#"// Points of a path, and the hit at one of them.
"# },
    Module { path: "shared/path_axes", head: r#"// Axes of view-dependent maps: azimuth, elevation and bend of a path, from where it comes in at the top.
//
// A path that comes in at height 1 has the height 1 - F + β F² at the part F of the way after which a
// straight path of the same slope is at height 0. relief-bake's module `view_dependent` has the same axes.
"# },
    Module { path: "shared/pixel", head: r#"// A pixel as one pure function: surface, search, refinement and shading in a row.
"# },
    Module { path: "shared/quadric", head: r#"// Quadrics that a base surface follows around a point of a triangle, and rays above and under them.
//
// A ray goes through texture coordinates in a straight line; its height over a quadric is a quadratic in the
// metres along it, which is solved without cancellation.
"# },
    Module { path: "shared/quartic", head: r#"// The first root of a polynomial of degree 4 between 0 and 1.
"# },
    Module { path: "shared/random", head: r#"// Random numbers by mixing bits: the same everywhere.
"# },
    Module { path: "shared/rasterised", head: r#"// Vertices for a rasteriser: the base triangles, or boxes around their shells. Nothing is
// interpolated, so that rays do not depend on a rasteriser's exactness.
"# },
    Module { path: "shared/records", head: r#"// Data that the host and the GPU exchange in buffers besides the settings. The Rust side of these
// structs is written by the linker.
"# },
    Module { path: "shared/seen_normals", head: r#"// The normals within a pixel's footprint, as an eye sees them.
//
// Where several texels lie in a footprint, their normals are known by means over the area. An eye
// at the side sees more of what faces it (Becker and Max 1993), and what faces away from a light
// gets none. For both, five normals stand for all of them. They have the same means, and weights as
// five slopes of a normal distribution have (a cubature of third degree).
"# },
    Module { path: "shared/seen_table", head: r#"// The visible normals in an area, looked up by the direction of view (Becker and Max 1993): the
// means that the map kind `seen-normal` holds.
"# },
    Module { path: "shared/settings", head: r#"// Uniform data, the same for all pixels: of a picture, of a surface in it, and of a pass over some
// of its rows.
"# },
    Module { path: "shared/shadow_ray", head: r#"// Whether a ray to a light is free, by the search for shadows.
"# },
    Module { path: "shared/shell", head: r#"// The shell of a base triangle: the space between its corners moved along their normals, from
// height 0 to height 1.
"# },
    Module { path: "shared/shell_hull", head: r#"// Slabs around the hull of a triangle's shell: a quick test whether a ray may meet it. Boxes along
// the axes are mostly much larger than a shell.
"# },
    Module { path: "shared/shell_point", head: r#"// Points of a shell that interpolated normals, not normalised, span.
"# },
    Module { path: "shared/shell_tree", head: r#"// Traversal of the BVH of shells, from near to far. It only proposes triangles; the surface finds
// the hits in their shells.
//
// Hapala, Davidovic, Wald, Havran and Slusallek 2011, Efficient Stack-less BVH Traversal for Ray
// Tracing. A node knows its parent. So a ray remembers only its node and the node before, however
// deep the BVH is.
"# },
    Module { path: "shared/sweep", head: r#"// The sweep of a triangle through a grid of voxels: the grid's own points, column by column.
//
// Gumhold and Hüttner 1999, section 3.4. Each side of the triangle is divided along the direction
// in which it is longest, one part a voxel. A primary edge is one between whose ends the third
// corner lies. The longest one gives the axis of the sweep. Two coordinate planes hold that axis;
// the triangle is cut in the one that it covers more of. The primary edge has one point in each
// column, at the column's bottom. The other two sides make the top: each of their points belongs to
// the column that it rounds to. Between are the grid's points. Neighbouring columns are zipped from
// below, by the shorter diagonal of the two that turn nothing over. Points of the top before the
// third corner go with the next column, those behind it with the one before. Where a column has
// both, they are closed there, as a roof.
//
// All numbers are whole, of 32 bits; products of two of them are compared in 64. So sides have at
// most `SWEPT_PARTS` parts. Each column follows from the three corners alone.
"# },
    Module { path: "shared/tangent_plane", head: r#"// The surface's tangent plane at a point, for the refinements that take the slope into account.
"# },
    Module { path: "shared/tessellation", head: r#"// Base triangles that are cut into smaller ones for a view, and displaced.
//
// Gumhold and Hüttner 1999, section 3.1: a side is divided by the voxels of the camera's grid space
// that its ends lie in, and its points lie at equal distances in the picture. Or it is divided by
// texels, and its points lie at equal distances on the base. A fixed pattern fills the inside, or
// the voxels themselves do. All data of a side follows from its two ends, so that neighbours meet.
"# },
    Module { path: "shared/tone", head: r#"// Colours of a screen: tone curves, and the bytes of sRGB. The CPU has the same in 64 bits (`relief-scene`, `tone`).
"# },
    Module { path: "shared/translucent", head: r#"// Light through a volume that absorbs and scatters it, as far as the volume's values say: no surface is
// hit, and the light that is scattered toward the eye is gathered along the ray.
//
// Szirmay-Kalos and Umenhoffer 2008, section 5.2, after Dufort, Leblanc and Poulin 2005: the ray walks
// through the voxels in the shells of the triangles. What is nearer hides what is farther, by the
// transmittance up to there; the volume absorbs the light on its way to the eye, and shadows itself by
// walks toward the lights.
//
// The parameters of the search say: `x` the extinction, per metre, where the volume is 1; `y` how often
// a ray looks at the light until nothing comes through, besides once in each segment; `z` the most cells
// of a walk.
"# },
    Module { path: "shared/transmittance", head: r#"// The part of light that comes through an optical depth: e to the power of minus that depth (Beer and
// Lambert).
"# },
    Module { path: "shared/types", head: r#"// Structs that the stages hand to each other. The Rust side of these structs is written by the
// linker.
"# },
    Module { path: "shared/under", head: r#"// Paths that begin under the surface, such as rays that enter a shell from the inside of a mesh.
"# },
    Module { path: "shared/views", head: r#"// The steps of a view-dependent map's axes around a path: the views between which its way is joined.
//
// A view is a direction and a bend. Ways are joined along the elevations first, then along the azimuths, then
// along the bends.
"# },
    Module { path: "shared/volume", head: r#"// The trilinear field of a volume: values and normals at a place, and rays from a hit toward a light.
"# },
    Module { path: "shared/voxel_cells", head: r#"// The dual cells of a volume along a path, in order; the cells that a baked map promises to be empty
// together.
"# },
    Module { path: "shared/voxel_walk", head: r#"// Walks over the dual cells of a volume along a path, in order.
//
// In a cell the field is linear along each axis. So along a path, whose height may bend, it is a polynomial
// of degree 4, and its first root is found in the cell.
"# },
    Module { path: "surface/facets", head: r#"// Triangles without relief: a ray ends on the triangle that it meets.
//
// Szirmay-Kalos and Umenhoffer 2008, section 3: a mesh that is displaced vertex by vertex is drawn
// like any mesh, with normals that are interpolated over its triangles.
"# },
    Module { path: "surface/frames", head: r#"// The frames of a grid that looks from all around. A ray goes through the three frames that look
// along it most. Its segments are its ways through these, as in the surface `object`.
"# },
    Module { path: "surface/object", head: r#"// Images of an object. The segments of a ray are its ways through the images, and each image is a
// relief. The segments are not parts of one way; the stage `object` combines them.
//
// Kautz and Seidel 2001, section 4.
"# },
    Module { path: "surface/object_slices", head: r#"// Slices through an object: a ray ends on the first slice at which all images see something at
// least as high.
//
// Kautz and Seidel 2001, sections 4.1 and 5: the product of the tests of all images.
"# },
    Module { path: "surface/plane", head: r#"// The flat base surface: one straight segment per ray.
//
// Szirmay-Kalos and Umenhoffer 2008, section 4, equations 7 and 11. The frame is interpolated over
// the triangle, so that relief runs smoothly from one triangle to the next. The segment lies in the
// frame of the base point.
"# },
    Module { path: "surface/prism", head: r#"// Shells of the base triangles, spanned by normals that are interpolated and not normalised.
//
// After Ogaki 2023, Nonlinear Ray Tracing for Displacement and Shell Mapping. The ray's way through
// texture coordinates and heights is curved. It is cut into chords: straight in texture
// coordinates, with heights that bend through their middle. The ray's own parameter gives a chord's
// place along the ray, and also serves where the ray runs along the shell. In a shell that overlaps
// itself the offset along its normals replaces that parameter: a place in the world may be in such
// a shell twice. `params.x` is the greatest distance of chords from the way, in texels. With
// `params.y` of 1 the base is smooth.
"# },
    Module { path: "surface/quadric_perpendicular", head: r#"// The base as quadrics, from which distances are measured across the view.
//
// Oliveira and Policarpo 2005, section 3.1, equations 3 to 7. The depth of a point of the ray under
// the quadric is a distance from the quadric. It is measured at right angles to the ray, in the
// plane of the ray and the normal. Where that line misses the quadric, the depth is the distance
// along the normal. The distance is no quadratic in the metres along the ray, and jumps from one
// measure to the other. So the ray is cut into chords, whose heights are right at their ends and in
// their middle. `params.x` is the number of coefficients of the quadrics, which the host fits. With
// `params.y` of 1 the base is smooth. `params.z` is the number of chords.
"# },
    Module { path: "surface/quadric_vertical", head: r#"// The base as quadrics, over which heights are measured along the normal of the base point.
//
// Oliveira and Policarpo 2005, sections 3.2 to 3.4, equations 7 to 9; Szirmay-Kalos and Umenhoffer
// 2008, section 5.1. The ray goes through the frame of the base point; its depth under the quadric
// is quadratic in the metres along it. `params.x` is the number of coefficients of the quadrics,
// which the host fits. With `params.y` of 1 the base is smooth.
"# },
    Module { path: "surface/slices", head: r#"// Slices: triangles through the space above the base that the relief fills. A ray ends on the first
// slice that the relief reaches, or between it and the slice before.
//
// Kautz and Seidel 2001, section 3. The segment from the slice before to the slice itself is ours:
// a refinement finds the hit in it.
"# },
    Module { path: "surface/tetrahedra", head: r#"// Shells of the base triangles in three tetrahedra each: the ray is straight in each of them.
//
// Szirmay-Kalos and Umenhoffer 2008, section 5.2. The corners of a shell are the triangle's
// corners, moved along their normals. Texture coordinates and heights are linear in a tetrahedron.
// They are continuous over the whole mesh where neighbours cut their common side along the same
// diagonal. It runs from the lower corner that comes first in the order of both triangles to the
// other upper corner.
"# },
    Module { path: "slice/at_least", head: r#"// A slice is drawn where the relief is as high or higher: the alpha test of the basic method.
//
// Kautz and Seidel 2001, section 3.1, after Dietrich 2000.
"# },
    Module { path: "slice/band", head: r#"// A slice is drawn where the relief is within half of the slices' distance of it. Neighbouring heights that
// differ by more are not joined.
//
// Kautz and Seidel 2001, section 3.1, after Schaufler 1998.
"# },
    Module { path: "slice/inside", head: r#"// A slice is drawn where the relief is higher. Height 0 is never drawn, so that zeros mask parts out.
//
// Kautz and Seidel 2001, section 3.2.
"# },
    Module { path: "object/blend", head: r#"// An octahedral impostor as game engines draw it. In each of the three frames that look along the
// ray most, the ray is cut with the plane through the middle. Then it is moved some times to the
// plane of the height that the frame shows there. The results of all three are blended by their
// weights: coverage, and distance.
//
// Brucks 2018. Frames do not agree on what is visible, so that outlines are mixed and depths lie
// between them.
"# },
    Module { path: "object/depth", head: r#"// The object that all images allow. The ray goes on to its first point in an image's solid, then to
// its first point in the next image's. It goes round the images until all have the same place.
//
// Kautz and Seidel 2001, section 4. Their alpha tests ask all images at the points of slices; rays
// that ask each image for the next point are ours. No image lets a ray go on too far, so that no
// ray passes a point that all agree on.
"# },
    Module { path: "object/hull", head: r#"// The visual hull: the intersection of all silhouettes. Rays go round the images as in the object
// `depth`. In each image the silhouette is where the mask, bilinear between texels, is at least a
// half.
//
// Kautz and Seidel 2001, section 5; Matusik et al. 2000.
"# },
    Module { path: "object/none", head: r#"// No object: a relief, whose segments are searched in their order. A segment whose hit lies in a
// hole has no hit. In a shell that overlaps itself segments overlap, too: there the nearest hit of
// all counts.
"# },
    Module { path: "field/heights", head: r#"// Heights: what lies below the bilinear surface of the height map is solid.
"# },
    Module { path: "field/motif", head: r#"// A motif: a closed mesh or a sheet in the space of a tile, which repeats with the tiles. Only rays meet its
// triangles: a sheet has no inside, so every point is outside.
//
// Szirmay-Kalos and Umenhoffer 2008, section 5.2; Porumbescu, Budge, Feng and Joy 2005.
"# },
    Module { path: "field/volume", head: r#"// A volume: what is solid is where the trilinear field between the voxels is half or more. The gap is what
// the field lacks there, positive outside.
//
// Szirmay-Kalos and Umenhoffer 2008, section 5.2.
"# },
    Module { path: "detail/fade", head: r#"// From displacement to bump mapping with distance: like `footprint`, and relief that is hardly
// deeper than a pixel is traced flatter.
//
// Szirmay-Kalos and Umenhoffer 2008, section 4.1.1, after Becker and Max 1993. `params.x` and
// `params.y` are as for `footprint`. A relief that is `params.z` samples deep is flat; one that is
// `params.w` times as deep is not flattened at all.
"# },
    Module { path: "detail/footprint", head: r#"// The level of detail with about two texels side by side in a pixel's footprint on the base
// surface.
//
// Oh, Ki and Lee 2006, section 3.4. `params.x` is the greatest length of the footprint in multiples
// of its width. `params.y` is the number of the level's texels side by side in it. With one texel,
// visible shadows are lost.
"# },
    Module { path: "detail/none", head: r#"// No level of detail: the finest level of all maps.
"# },
    Module { path: "search/cells", head: r#"// Cell walk: every dual cell along the path, in order, until the path dips below the surface in
// one.
//
// Szirmay-Kalos and Umenhoffer 2008, section 4.3.1, ask for this safe form: every texel visited. In
// a cell the gap is a quadratic, so whether it falls to zero is known without sampling. The bracket
// ends where the gap is least. `params.x` caps the number of cells.
"# },
    Module { path: "search/cone", head: r#"// Cone stepping: from texel to texel, over the empty cone that stands on the nearest one.
//
// Dummer 2006; Szirmay-Kalos and Umenhoffer 2008, section 4.3.5. As published the cone is moved to
// the ray, and cuts the surface where it was made for the texel's centre. Here it stays where it
// was made. A ray inside the cone, anywhere in the texel, meets no surface until it leaves the
// cone. Where the ray is outside, or leaves the cone within the cell, the cell's patch is tested,
// as `cells` does. So no surface is passed, with the widest cones that there are. `params.x` caps
// the reads.
//
// A cone is convex, so a ray that is inside at two places is inside between. However a step was
// rounded, its end is tested before it is taken. A path that bends is replaced by a line that is
// not above it.
"# },
    Module { path: "search/cone_moved", head: r#"// Cone stepping as published: the cone is moved to the surface under the ray, through a bilinear
// filter.
//
// Dummer 2006; Szirmay-Kalos and Umenhoffer 2008, section 4.3.5. `params.x` is the number of steps.
// The last point is the answer. With cones that are safe through a filter it is never behind the
// surface.
"# },
    Module { path: "search/dilation_erosion", head: r#"// Dilation and erosion: over the greatest height around each cell, and cell by cell between it and
// the least.
//
// Kolb and Rezk-Salama 2005; Szirmay-Kalos and Umenhoffer 2008, section 4.3.2. Above the dilation
// of a cell the path meets nothing until it sinks to the dilation or leaves the cell's window.
// Between dilation and erosion the cell's patch is tested, as `cells` does. `params.x` caps the
// reads, `params.z` is the radius of the windows in texels. With `params.y` 0 it is as published:
// no patch is tested, and the bracket ends where the path is below the erosion.
"# },
    Module { path: "search/frustum", head: r#"// Quadrant frusta: from every dual cell on, over the empty frustum that stands on it in the
// quadrant of the ray.
//
// Published here first. The map is relief-bake's kind `frustum`, whose head has the proof. For
// every cell and quadrant it holds the least slope S, in heights a texel, such that the surface is
// nowhere above top + S d. The top is the greatest of the cell's four heights, and d the Chebyshev
// distance from the cell in texels. Where the ray leaves the cell above the top, it is safe until
// it meets that frustum, one division an axis away. Where it sinks to the top over the cell, the
// cell's patch is tested, as `cells` does. Cells outside the map are images of cells inside. The
// flat half cells beside the edges of a clamped or mirrored map are not images; they are visited
// one by one. `params.x` caps the reads.
//
// All rounding of floats is taken off the gap to the frustum before the division, so that a step
// may end early, never late.
"# },
    Module { path: "search/generalised", head: r#"// The distance to the solid of a volume by place and direction, baked: a generalised displacement map.
//
// Szirmay-Kalos and Umenhoffer 2008, section 6.3, after Wang and others 2004. One look-up says how far the
// ray goes before it hits, wherever it begins. The map is relief-bake's kind `generalised`, a layer a
// direction. `params.x` is the most look-ups, `params.y` and `params.z` are the azimuths and elevations of
// the map, and `params.w` is the way in voxels up to which it looks.
"# },
    Module { path: "search/linear", head: r#"// Linear search: equal steps from the entry to the exit until one is below the surface.
//
// Szirmay-Kalos and Umenhoffer 2008, section 4.3.1. `params.x` is the number of steps for a ray
// along the normal, `params.y` the factor on it for a grazing ray. If a way through the relief has
// several segments, each takes its share of the steps.
"# },
    Module { path: "search/none", head: r#"// No search: the entry and the exit, with nothing known between them.
"# },
    Module { path: "search/pyramid", head: r#"// Maximum pyramid: over the nodes of a quadtree that the path stays above, down where it sinks to
// one, and up again where it has left a parent.
//
// Oh, Ki and Lee 2006; Tevs, Ihrke and Seidel 2008; Szirmay-Kalos and Umenhoffer 2008, section
// 4.3.3. A node of level k holds the greatest height over 2^k by 2^k dual cells. On level 0 the
// cell's own patch is tested, as `cells` does. `params.x` caps the reads.
//
// One chain of nodes serves all levels of detail. The nodes of level k also lie over the cells of
// the traced level, 2^(k - level) by 2^(k - level) each. Levels are counted from the traced one
// here.
"# },
    Module { path: "search/pyramid_texels", head: r#"// Pyramidal displacement mapping as published: the maximum pyramid of the texels, each a level
// column.
//
// Oh, Ki and Lee 2006, section 3.2 and Figure 13. Where the ray is above a node, it goes on to the
// node's height and down a level, or to the node's edge. Where it is not, it goes down a level. It
// never goes up again, so that from the first texel on it goes from texel to texel. `params.x` caps
// the reads. Columns are not the bilinear surface: `half-texel` goes on from their hit. View rays
// do not go below the level `params.y` (section 3.4). Its nodes are the columns then: the coarser
// they are, the flatter is the surface.
"# },
    Module { path: "search/relaxed_cone", head: r#"// Relaxed cone stepping: over cones that a view ray leaves after at most one entry into the
// surface.
//
// Policarpo and Oliveira 2007; Szirmay-Kalos and Umenhoffer 2008, section 4.4.3. The cone of the
// nearest texel is moved to the surface under the ray, and holds there from anywhere in the texel's
// square. Where the ray is below the surface behind a step, it has entered once on the way; where
// it is above, not at all. In each cell in which a step ends the patch is tested first, as `cells`
// does. `params.x` caps the reads. With `params.y` 0 it is as published, by steps alone. These
// shrink toward the surface, and a step that gets no further ends the search.
"# },
    Module { path: "search/relaxed_cone_resting", head: r#"// Relaxed cones that stay on their texel: the search `cone` over the wider cones of texel centres.
//
// Published here first. The cones hold for rays over the texel's centre alone. Beside it the
// horizontal direction at a peak is another, so that a ray may enter and come out again within a
// cone: hits are passed, rarely. `params.x` caps the reads.
"# },
    Module { path: "search/shell_map", head: r#"// The first triangle of a motif on the path, tile by tile.
//
// Porumbescu, Budge, Feng and Joy 2005, "Shell maps"; Szirmay-Kalos and Umenhoffer 2008, section 5.2: a
// volume, here a mesh, is mapped onto the surface by the shells of its triangles. `params.x` is the most
// boxes.
"# },
    Module { path: "search/sphere", head: r#"// Sphere tracing: each step is as long as the distance field allows in any direction.
//
// Hart 1993; Donnelly 2005; Szirmay-Kalos and Umenhoffer 2008, section 4.3.4. The map is
// relief-bake's kind `distance` in texture units: a fetch between its voxels is nowhere more than
// the distance to the surface. Where a step ends within the cell, the cell's patch is tested, as
// `cells` does. `params.x` caps the reads, `params.z` is the number of slices. With `params.y` 0 it
// is as published: the search ends where the field allows no further step.
"# },
    Module { path: "search/translucent", head: r#"// Where a path comes upon a translucent volume: the first cell in which it is not empty.
//
// Szirmay-Kalos and Umenhoffer 2008, section 5.2. Renderers gather light from there on, see
// `shared/translucent`. The map is relief-bake's kind `volume-distance`, to cells that are not empty.
// `params.z` is the most cells.
"# },
    Module { path: "search/view_dependent", head: r#"// The first hit by place, azimuth, elevation and bend, baked: a view-dependent displacement map.
//
// Szirmay-Kalos and Umenhoffer 2008, section 6.3, after Wang and others 2003. One look-up gives the hit of a
// ray that comes in at the top. A path that begins lower is looked up where it would have come in. The map is
// relief-bake's kind `view-dependent`, a layer a direction. `params.x`, `params.y` and `params.z` are its
// azimuths, elevations and bends, and `params.w` is its depth.
"# },
    Module { path: "search/view_dependent_clusters", head: r#"// The first hit of paths by place, azimuth, elevation and bend, out of non-negative factors of groups of
// texels.
//
// Szirmay-Kalos and Umenhoffer 2008, section 6.3, after Wang and Dana 2005. As `view-dependent`, but each way
// is a sum of products, and texels that are alike have factors of views in common. The map is relief-bake's
// kind `view-dependent` with a rank and clusters. `params.x`, `params.y` and `params.z` are its azimuths,
// elevations and bends, and `params.w` is its depth.
"# },
    Module { path: "search/view_dependent_free", head: r#"// Over the way on which all rays are free that come in over the same texel in nearly the
// same direction, by one read.
//
// Published here first. The map is relief-bake's kind `view-dependent-free`, whose head has the proof; a
// layer is a direction. Its ways are shorter than the free ones by more than rounding may add. Paths that do
// not come in at the top, that bend where the map holds straight paths alone, or that come in so near to the
// side of a texel's square that rounding may take the other one, do not use the map. `params.x`, `params.y`
// and `params.z` are its azimuths, elevations and bends, and `params.w` is its depth.
"# },
    Module { path: "search/view_dependent_svd", head: r#"// The first hit of paths by place, azimuth, elevation and bend, out of factors by a singular value
// decomposition.
//
// Szirmay-Kalos and Umenhoffer 2008, section 6.3. As `view-dependent`, but each way is a sum of products. The
// map is relief-bake's kind `view-dependent` with a rank. `params.x`, `params.y` and `params.z` are its
// azimuths, elevations and bends, and `params.w` is its depth.
"# },
    Module { path: "search/voxels", head: r#"// The dual cells of a volume along the path, in order, but for the empty ones that the baked distances skip.
//
// Szirmay-Kalos and Umenhoffer 2008, section 5.2: the ray walks through the voxels of a volume on the
// surface. Cohen and Sheffer 1994: a cell stores how many cells around it are empty, and the ray leaves their
// box in one step. The map is relief-bake's kind `volume-distance`. `params.x` is the most cells.
"# },
    Module { path: "refine/binary", head: r#"// Binary search: the interval is halved; its near end stays above the surface and its far end
// below.
//
// Szirmay-Kalos and Umenhoffer 2008, section 4.2.2. `params.x` is the number of halvings. Without a
// search it starts with the whole path and may find any crossing.
"# },
    Module { path: "refine/half_texel", head: r#"// Half a texel before and behind the hit of a texel's column: between the two the gap is taken to
// be linear.
//
// Oh, Ki and Lee 2006, section 3.3 and Figure 16. Two reads. If both places are on the same side of
// the surface, the sizes of the gaps say nothing, and the answer is wrong, as published.
"# },
    Module { path: "refine/none", head: r#"// No refinement: the search's result is the hit.
//
// Without a search this is bump mapping: the processed point (Szirmay-Kalos and Umenhoffer 2008,
// section 4.1.1). After linear search it is steep parallax mapping: the first sample below (section
// 4.3.1).
"# },
    Module { path: "refine/offset", head: r#"// Parallax mapping: the surface is taken for a level plane at the height of the starting point.
//
// Szirmay-Kalos and Umenhoffer 2008, section 4.1.2. The published offset h (Vx, Vy) / Vz is the point where
// the ray reaches that level.
"# },
    Module { path: "refine/offset_limited", head: r#"// Parallax mapping with offset limiting: the offset is h (Vx, Vy), without the division by Vz.
//
// Szirmay-Kalos and Umenhoffer 2008, section 4.1.3. The offset never exceeds the height, and the point it
// gives lies beside the ray.
"# },
    Module { path: "refine/patch", head: r#"// Exact refinement: ray against bilinear patch in closed form, in every dual cell of the search's interval,
// in order.
//
// `params.x` caps the number of cells. After a search that ends above the surface it goes on to the end of
// the path and may end in a miss.
"# },
    Module { path: "refine/secant", head: r#"// The secant method of displacement mapping, which is false position: the surface between the two ends is
// taken for a plane, and the end on the same side as the new point is replaced.
//
// Szirmay-Kalos and Umenhoffer 2008, section 4.2.3. `params.x` is the number of steps. The last one needs no
// read.
"# },
    Module { path: "refine/slope", head: r#"// Parallax mapping taking into account the slope: the surface is taken for its tangent plane at the starting
// point.
//
// Szirmay-Kalos and Umenhoffer 2008, section 4.1.4. With `params.x` 0 the offset is h Nz (Vx, Vy), the safer
// form that the section ends with; with 1 it is divided by N·V, which solves ray against plane.
"# },
    Module { path: "refine/slope_iterative", head: r#"// Iterative parallax mapping: the slope correction, repeated from the point that it gave.
//
// Szirmay-Kalos and Umenhoffer 2008, section 4.2.1. `params.x` is the number of corrections. With
// `params.y` 1 each is divided by N·V, which makes it Newton's method.
"# },
    Module { path: "refine/trilinear", head: r#"// The first root of the trilinear field along the path in the search's interval, cell by cell.
// `params.x` is the most cells.
"# },
    Module { path: "refine/true_secant", head: r#"// The secant method proper: always the last two guesses, whether or not they enclose the crossing.
//
// Suggested by Szirmay-Kalos and Umenhoffer 2008, section 4.2.3. `params.x` is the number of steps.
// It converges faster than false position, but without its certainty. A guess outside the search's
// interval is brought back to its ends.
"# },
    Module { path: "shade/blinn_phong", head: r#"// Blinn-Phong: diffuse, and a specular lobe around the half vector.
//
// Blinn 1977, as named by Szirmay-Kalos and Umenhoffer 2008, section 2.1. The exponent is a whole
// number, so that the power is a product of squares and has the same bits everywhere. If the normal
// is the mean of several, its length is `mean`: the shorter it is, the wider and dimmer is the lobe
// (Toksvig 2005). `cosine` is the mean of the several cosines, 0 for normals that face away.
"# },
    Module { path: "shade/metallic_roughness", head: r#"// Metallic-roughness: the material model of glTF 2.0 and of most engines.
//
// glTF 2.0, appendix B: facets distributed after Trowbridge and Reitz ("GGX"), which hide each other
// after Smith, with heights correlated (Heitz 2014), and reflect after Schlick 1994. What they do not
// reflect is scattered. All is multiplied by pi, so that a white surface under an irradiance of 1
// shows as 1.
//
// Facets reflect some light more than once, above all where they are rough. The specular part is
// multiplied by 1 + F0 (1 / E - 1), where E is the part that white facets reflect once (Turquin
// 2019). E and the light from all around come from the same constants.
//
// A footprint that holds several normals is rougher, as it widens the lobe of `blinn-phong` (Toksvig
// 2005).
"# },
    Module { path: "shadow/entry", head: r#"// A ray from where the light enters the relief down to the hit: a view ray.
//
// Oliveira and Policarpo 2005, section 2.1.
"# },
    Module { path: "shadow/heuristic", head: r#"// The heuristic of interactive engines: relief that stands out of the ray to the light darkens, the
// nearer the more.
//
// Tatarchuk 2006, as named by Szirmay-Kalos and Umenhoffer 2008, section 6.
"# },
    Module { path: "shadow/horizon", head: r#"// Horizons around the hit, baked for some azimuths and interpolated between them.
//
// Max 1988; Szirmay-Kalos and Umenhoffer 2008, section 6.1. The horizon's slope holds along a
// direction of the texture. So it is turned into the hit's own frame, which changes from point to
// point on a curved mesh. The shadow of the hit's own cell is computed, and not left to texels
// beside it.
"# },
    Module { path: "shadow/map", head: r#"// A shadow map: a picture of the depths that the light sees. Points hidden in it get no light.
//
// Williams 1978; Oliveira and Policarpo 2005, section 3.5. `params.x` and `params.y` are the size
// of the shadow map and the number of cascades, which the host draws. `params.z` and `params.w` are
// the width of the filter and the bias, in texels.
"# },
    Module { path: "shadow/none", head: r#"// No shadows: all of a light arrives.
"# },
    Module { path: "shadow/ray", head: r#"// A ray from the hit to the light, through the relief of the same surface.
//
// Szirmay-Kalos and Umenhoffer 2008, section 6.
"# },
    Module { path: "shadow/scene", head: r#"// Rays through all surfaces of the scene. A surface's shader does not know the other surfaces: the
// host traces the rays and replaces this result.
"# },
    Module { path: "shadow/soft", head: r#"// Rays from the hit to points of the light's disc.
//
// Szirmay-Kalos and Umenhoffer 2008, section 6: several light vectors for a light.
"# },
    Module { path: "shadow/visibility", head: r#"// Precomputed visibility: whether something is seen in fixed directions.
//
// Heidrich et al. 2000; Szirmay-Kalos and Umenhoffer 2008, section 6.2: the nearest direction, or
// the three that are close to the light's, interpolated.
"# },
    Module { path: "ambient/bent_normal", head: r#"// Bent normals: the ambient light that arrives is the part of the sky that the relief's own normal
// sees.
//
// Landis 2002. The baked vector is the integral over the directions to the sky, over pi. A point
// does not see what is behind its own surface, so all visible sky is before its normal. The product
// of normal and vector is the light of a uniform sky without any further integral.
"# },
    Module { path: "ambient/bounce", head: r#"// Light that bounces: the ambient light that arrives comes from the visible sky, and from other
// points of the relief that reflect theirs, about the base's normal.
//
// Heidrich, Daubert, Kautz and Seidel 2000; Szirmay-Kalos and Umenhoffer 2008, section 6.2.
"# },
    Module { path: "ambient/constant", head: r#"// Constant ambient light, the same everywhere.
"# },
    Module { path: "ambient/environment", head: r#"// An environment map. The relief's surface reflects it; light that enters the surface is scattered,
// or refracted and seen through it.
//
// Environment maps after Blinn and Newell 1976, filtered beforehand as in Heidrich and Seidel 1999;
// on a transparent object as in Oh, Ki and Lee 2006, Figure 22. The shading says which part is
// reflected.
"# },
    Module { path: "ambient/hemisphere", head: r#"// Hemisphere lighting: a sky above and ground below, each weighted by the part that a normal sees.
//
// A plane with normal n sees the part (1 + n.y) / 2 of an even sky above the horizon, weighted by
// the cosine.
"# },
    Module { path: "ambient/occlusion", head: r#"// Ambient occlusion: the ambient light that arrives is the part of the sky above the horizons,
// about the base's normal.
//
// Zhukov, Iones and Kronin 1998; horizons as in Szirmay-Kalos and Umenhoffer 2008, section 6.1.
"# },
    Module { path: "ambient/sky", head: r#"// A sky above and ground below, as far as the relief leaves them open.
//
// Bent normals give the part of the light that arrives (Landis 2002). Its radiance is hemisphere
// lighting, half along the bent normal and half along the normal. Along the bent normal alone all
// slopes in a shadow look the same.
"# },
    Module { path: "procedure/bumps", head: r#"// Round bumps on level ground, each in a cell of a lattice. In time each grows and shrinks by
// itself, and all return to their beginning together.
//
// Szirmay-Kalos and Umenhoffer 2008, section 3.1: displacement by a formula.
"# },
    Module { path: "procedure/fbm", head: r#"// Fractal ground: gradient noise in octaves, each twice as fine as the one before and weaker. In
// time the gradients turn, finer ones more often, so that it flows and returns to its beginning.
//
// Szirmay-Kalos and Umenhoffer 2008, section 3.1: displacement by a formula. Noise of turning
// gradients: Perlin and Neyret 2001, Flow Noise.
"# },
    Module { path: "procedure/waves", head: r#"// Waves on water, of many lengths, that run about the same way, each as fast as its length lets it.
// All of them fit the tile and return to their beginning in a unit of time.
//
// Szirmay-Kalos and Umenhoffer 2008, section 3.1: displacement by a formula.
"# },
    Module { path: "roots/compose", head: r#"// The passes before and behind those over translucent surfaces on the GPU: one says how far a ray may
// go, the other lays what was gathered over the opaque surface, from the farthest to the nearest.
"# },
    Module { path: "roots/draw", head: r#"// A surface in a single pass, for any engine: the base mesh is rasterised, every fragment's ray
// traced, and its hit shaded. A program with other meshes calls `shade_pixel` from a fragment
// function of its own.
"# },
    Module { path: "roots/functions", head: r#"// A method as functions, for the fragment functions of other programs: a point of a mesh and the direction of
// a ray go in, the hit on the relief comes out, and the part of a light that arrives there.
//
// All is in the tangent space of the point: along +u, along +v, and along the mesh's normal. Lengths have the
// unit of the scale.
"# },
    Module { path: "roots/functions_of_triangles", head: r#"// A method as functions, for the fragment functions of other programs: a triangle with the space above it and
// a ray go in, the hit on the relief comes out, and the part of a light that arrives there.
//
// All is in one space, in which the triangle is given, and lengths have its unit. That may be the mesh's own:
// then a ray's direction is turned and stretched by the mesh's place in the world, and keeps its length.
"# },
    Module { path: "roots/gather", head: r#"// A pass over a translucent surface on the GPU, after the opaque ones: every pixel's ray goes through
// the segments of all shells that it meets, in the order in which they begin.
//
// A ray remembers the next few segments. When it is through with them, it looks for the next.
"# },
    Module { path: "roots/paths", head: r#"// Search and refinement over a list of paths: for programs that trace on a GPU without drawing, and
// for measurements of different searches over the same paths.
"# },
    Module { path: "roots/probe", head: r#"// The stages one after the other over a list of rays, with every stage's result: for tests that
// compare the GPU with the translation, and for measurements of single stages.
"# },
    Module { path: "roots/pyramid", head: r#"// A level of the pyramid of least and greatest heights, built on the GPU from the height map and
// the level before. It has the very bits that the kind `pyramid` bakes.
//
// Oh, Ki and Lee 2006, section 3.1. Heights are not negative, so that their bits are in the order
// of their values. The bits are compared, because adapters may take the smallest floats for zeros.
"# },
    Module { path: "roots/resolve", head: r#"// The pass after each sample of some rows: it adds the sample's colour to those before. The last
// one leaves the pixel's colour in the records.
"# },
    Module { path: "roots/screen", head: r#"// The picture for screens: the bytes of sRGB of the records of some rows, with exposure and tone curve, over the
// background.
"# },
    Module { path: "roots/shade", head: r#"// The second pass of a picture on the GPU: every pixel that the first pass traced is shaded once.
// The first pass leaves out hits behind another surface. The first surface's pass writes all
// pixels, so that nothing of an earlier picture remains.
"# },
    Module { path: "roots/show", head: r#"// The picture for programs that show it: linear colours of the records of some rows, over the
// background.
"# },
    Module { path: "roots/stencil", head: r#"// Slices through an object, if no program may read several of its images at once: slice by slice,
// from front to back, one pass per image, counted in the stencil buffer. A point whose count is the
// number of images is in the object; all other counts are cleared after each slice.
//
// Kautz and Seidel 2001, section 4.1.
"# },
    Module { path: "roots/tessellate", head: r#"// Displaced triangles of a base, made anew for each view on the GPU: culled, counted, numbered,
// made, and drawn. If there is no memory for all points or triangles, the grid gets coarser;
// nothing is dropped.
//
// The list of tallies has those for the base's edges first, then those for its triangles.
"# },
    Module { path: "roots/trace", head: r#"// The first pass of a picture on the GPU: the base mesh is rasterised, and every fragment's ray
// traced. It also fills depths alone: shadow maps, and a depth buffer before a program's own pass.
//
// Rays are made from the pixel and the triangle's corners, not from interpolated attributes. So
// both backends trace the same ray to the last bit, whatever the rasteriser's precision.
"# },
    Module { path: "roots/trace_shells", head: r#"// The first pass of a picture of shells on the GPU. Every pixel's ray traverses a BVH of shells
// from near to far, and traces each shell that it meets until nothing nearer is left. A rasteriser
// would trace all shells that cover the pixel, however deep they lie behind the visible ones.
// Shadow maps are made in the same way.
"# },
];

pub const DECLARATIONS: &[Declaration] = &[
    Declaration {
        module: "bindings",
        name: "surface_settings",
        sampling: None,
        uses: &["SurfaceSettings"],
        text: r#"@group(0) @binding(0) var<uniform> surface_settings: SurfaceSettings;"#,
    },
    Declaration {
        module: "bindings",
        name: "height_map",
        sampling: None,
        uses: &[],
        text: r#"@group(0) @binding(1) var height_map: texture_2d<f32>;"#,
    },
    Declaration {
        module: "bindings",
        name: "color_map",
        sampling: None,
        uses: &[],
        text: r#"@group(0) @binding(2) var color_map: texture_2d<f32>;"#,
    },
    Declaration {
        module: "bindings",
        name: "normal_map",
        sampling: None,
        uses: &[],
        text: r#"@group(0) @binding(3) var normal_map: texture_2d_array<f32>;"#,
    },
    Declaration {
        module: "bindings",
        name: "map_sampler",
        sampling: Some(Sampling::Fast),
        uses: &[],
        text: r#"@group(0) @binding(4) var map_sampler: sampler;"#,
    },
    Declaration {
        module: "bindings",
        name: "detail_map",
        sampling: None,
        uses: &[],
        text: r#"@group(0) @binding(5) var detail_map: texture_2d_array<f32>;"#,
    },
    Declaration {
        module: "bindings",
        name: "search_map",
        sampling: None,
        uses: &[],
        text: r#"@group(0) @binding(6) var search_map: texture_2d_array<f32>;"#,
    },
    Declaration {
        module: "bindings",
        name: "shadow_search_map",
        sampling: None,
        uses: &[],
        text: r#"@group(0) @binding(7) var shadow_search_map: texture_2d_array<f32>;"#,
    },
    Declaration {
        module: "bindings",
        name: "shadow_texels",
        sampling: None,
        uses: &[],
        text: r#"@group(0) @binding(8) var shadow_texels: texture_2d_array<f32>;"#,
    },
    Declaration {
        module: "bindings",
        name: "ambient_map",
        sampling: None,
        uses: &[],
        text: r#"@group(0) @binding(9) var ambient_map: texture_2d_array<f32>;"#,
    },
    Declaration {
        module: "bindings",
        name: "environment_map",
        sampling: None,
        uses: &[],
        text: r#"@group(0) @binding(10) var environment_map: texture_2d_array<f32>;"#,
    },
    Declaration {
        module: "bindings",
        name: "light_map",
        sampling: None,
        uses: &[],
        text: r#"@group(0) @binding(11) var light_map: texture_2d_array<f32>;"#,
    },
    Declaration {
        module: "bindings",
        name: "object_map",
        sampling: None,
        uses: &[],
        text: r#"@group(0) @binding(12) var object_map: texture_2d_array<f32>;"#,
    },
    Declaration {
        module: "bindings",
        name: "frame",
        sampling: None,
        uses: &["Frame"],
        text: r#"@group(0) @binding(13) var<uniform> frame: Frame;"#,
    },
    Declaration {
        module: "bindings",
        name: "pass_settings",
        sampling: None,
        uses: &["PassSettings"],
        text: r#"@group(0) @binding(14) var<uniform> pass_settings: PassSettings;"#,
    },
    Declaration {
        module: "bindings",
        name: "hole_map",
        sampling: None,
        uses: &[],
        text: r#"@group(0) @binding(15) var hole_map: texture_2d<f32>;"#,
    },
    Declaration {
        module: "bindings",
        name: "material_map",
        sampling: None,
        uses: &[],
        text: r#"@group(0) @binding(16) var material_map: texture_2d_array<f32>;"#,
    },
    Declaration {
        module: "bindings",
        name: "mesh_faces",
        sampling: None,
        uses: &["Face"],
        text: r#"@group(1) @binding(0) var<storage, read> mesh_faces: array<Face>;"#,
    },
    Declaration {
        module: "bindings",
        name: "mesh_corners",
        sampling: None,
        uses: &["Corner"],
        text: r#"@group(1) @binding(1) var<storage, read> mesh_corners: array<Corner>;"#,
    },
    Declaration {
        module: "bindings",
        name: "pixels",
        sampling: None,
        uses: &["PixelIn"],
        text: r#"@group(1) @binding(8) var<storage, read> pixels: array<PixelIn>;"#,
    },
    Declaration {
        module: "bindings",
        name: "probes",
        sampling: None,
        uses: &["Probe"],
        text: r#"@group(1) @binding(2) var<storage, read_write> probes: array<Probe>;"#,
    },
    Declaration {
        module: "bindings",
        name: "given_paths",
        sampling: None,
        uses: &["Path"],
        text: r#"@group(1) @binding(19) var<storage, read> given_paths: array<Path>;"#,
    },
    Declaration {
        module: "bindings",
        name: "found_hits",
        sampling: None,
        uses: &["Hit"],
        text: r#"@group(1) @binding(20) var<storage, read_write> found_hits: array<Hit>;"#,
    },
    Declaration {
        module: "bindings",
        name: "traced_hit",
        sampling: None,
        uses: &[],
        text: r#"@group(2) @binding(0) var traced_hit: texture_2d<f32>;"#,
    },
    Declaration {
        module: "bindings",
        name: "traced_what",
        sampling: None,
        uses: &[],
        text: r#"@group(2) @binding(1) var traced_what: texture_2d<i32>;"#,
    },
    Declaration {
        module: "bindings",
        name: "records",
        sampling: None,
        uses: &["Record"],
        text: r#"@group(2) @binding(2) var<storage, read_write> records: array<Record>;"#,
    },
    Declaration {
        module: "bindings",
        name: "sums",
        sampling: None,
        uses: &[],
        text: r#"@group(2) @binding(3) var<storage, read_write> sums: array<vec4f>;"#,
    },
    Declaration {
        module: "bindings",
        name: "shell_nodes",
        sampling: None,
        uses: &["ShellNode"],
        text: r#"@group(2) @binding(4) var<storage, read> shell_nodes: array<ShellNode>;"#,
    },
    Declaration {
        module: "bindings",
        name: "gathered",
        sampling: None,
        uses: &["Gathered"],
        text: r#"@group(2) @binding(5) var<storage, read_write> gathered: array<Gathered>;"#,
    },
    Declaration {
        module: "bindings",
        name: "shown_records",
        sampling: None,
        uses: &["Record"],
        text: r#"@group(1) @binding(3) var<storage, read> shown_records: array<Record>;"#,
    },
    Declaration {
        module: "bindings",
        name: "picture",
        sampling: None,
        uses: &[],
        text: r#"@group(1) @binding(4) var picture: texture_storage_2d<rgba16float, write>;"#,
    },
    Declaration {
        module: "bindings",
        name: "finer_level",
        sampling: None,
        uses: &[],
        text: r#"@group(1) @binding(5) var finer_level: texture_2d<f32>;"#,
    },
    Declaration {
        module: "bindings",
        name: "heights_below",
        sampling: None,
        uses: &[],
        text: r#"@group(1) @binding(6) var heights_below: texture_2d<f32>;"#,
    },
    Declaration {
        module: "bindings",
        name: "pyramid_pass",
        sampling: None,
        uses: &["PyramidPass"],
        text: r#"@group(1) @binding(7) var<uniform> pyramid_pass: PyramidPass;"#,
    },
    Declaration {
        module: "bindings",
        name: "tessellation",
        sampling: None,
        uses: &["Tessellation"],
        text: r#"@group(1) @binding(9) var<uniform> tessellation: Tessellation;"#,
    },
    Declaration {
        module: "bindings",
        name: "base_vertices",
        sampling: None,
        uses: &["BaseVertex"],
        text: r#"@group(1) @binding(10) var<storage, read> base_vertices: array<BaseVertex>;"#,
    },
    Declaration {
        module: "bindings",
        name: "base_edges",
        sampling: None,
        uses: &["BaseEdge"],
        text: r#"@group(1) @binding(11) var<storage, read> base_edges: array<BaseEdge>;"#,
    },
    Declaration {
        module: "bindings",
        name: "base_patches",
        sampling: None,
        uses: &["BasePatch"],
        text: r#"@group(1) @binding(12) var<storage, read> base_patches: array<BasePatch>;"#,
    },
    Declaration {
        module: "bindings",
        name: "voxels",
        sampling: None,
        uses: &["Voxel"],
        text: r#"@group(1) @binding(13) var<storage, read_write> voxels: array<Voxel>;"#,
    },
    Declaration {
        module: "bindings",
        name: "tallies",
        sampling: None,
        uses: &["Tally"],
        text: r#"@group(1) @binding(14) var<storage, read_write> tallies: array<Tally>;"#,
    },
    Declaration {
        module: "bindings",
        name: "tally_blocks",
        sampling: None,
        uses: &[],
        text: r#"@group(1) @binding(15) var<storage, read_write> tally_blocks: array<vec2u>;"#,
    },
    Declaration {
        module: "bindings",
        name: "made_totals",
        sampling: None,
        uses: &["TessellationTotals"],
        text: r#"@group(1) @binding(16) var<storage, read_write> made_totals: array<TessellationTotals>;"#,
    },
    Declaration {
        module: "bindings",
        name: "made_corners",
        sampling: None,
        uses: &["Corner"],
        text: r#"@group(1) @binding(17) var<storage, read_write> made_corners: array<Corner>;"#,
    },
    Declaration {
        module: "bindings",
        name: "made_faces",
        sampling: None,
        uses: &["Face"],
        text: r#"@group(1) @binding(18) var<storage, read_write> made_faces: array<Face>;"#,
    },
    Declaration {
        module: "bindings",
        name: "point_settings",
        sampling: None,
        uses: &["PointSettings"],
        text: r#"@group(1) @binding(21) var<uniform> point_settings: PointSettings;"#,
    },
    Declaration {
        module: "bindings",
        name: "screen_settings",
        sampling: None,
        uses: &["ScreenSettings"],
        text: r#"@group(1) @binding(22) var<uniform> screen_settings: ScreenSettings;"#,
    },
    Declaration {
        module: "bindings",
        name: "screen",
        sampling: None,
        uses: &[],
        text: r#"@group(1) @binding(23) var<storage, read_write> screen: array<u32>;"#,
    },
    Declaration {
        module: "constants",
        name: "FOUND_MISS",
        sampling: None,
        uses: &[],
        text: r#"const FOUND_MISS = 0u;"#,
    },
    Declaration {
        module: "constants",
        name: "FOUND_ABOVE",
        sampling: None,
        uses: &[],
        text: r#"const FOUND_ABOVE = 1u;"#,
    },
    Declaration {
        module: "constants",
        name: "FOUND_BELOW",
        sampling: None,
        uses: &[],
        text: r#"const FOUND_BELOW = 2u;"#,
    },
    Declaration {
        module: "constants",
        name: "FOUND_BRACKET",
        sampling: None,
        uses: &[],
        text: r#"const FOUND_BRACKET = 3u;"#,
    },
    Declaration {
        module: "constants",
        name: "FOUND_EXHAUSTED",
        sampling: None,
        uses: &[],
        text: r#"const FOUND_EXHAUSTED = 4u;"#,
    },
    Declaration {
        module: "constants",
        name: "FOUND_STARTED_BELOW",
        sampling: None,
        uses: &[],
        text: r#"const FOUND_STARTED_BELOW = 5u;"#,
    },
    Declaration {
        module: "constants",
        name: "FOUND_UNBRACKETED",
        sampling: None,
        uses: &[],
        text: r#"const FOUND_UNBRACKETED = 6u;"#,
    },
    Declaration {
        module: "constants",
        name: "WRAP_REPEAT",
        sampling: None,
        uses: &[],
        text: r#"const WRAP_REPEAT = 0u;"#,
    },
    Declaration {
        module: "constants",
        name: "WRAP_CLAMP",
        sampling: None,
        uses: &[],
        text: r#"const WRAP_CLAMP = 1u;"#,
    },
    Declaration {
        module: "constants",
        name: "WRAP_MIRROR",
        sampling: None,
        uses: &[],
        text: r#"const WRAP_MIRROR = 2u;"#,
    },
    Declaration {
        module: "constants",
        name: "RAY_VIEW",
        sampling: None,
        uses: &[],
        text: r#"const RAY_VIEW = 0u;"#,
    },
    Declaration {
        module: "constants",
        name: "RAY_SHADOW",
        sampling: None,
        uses: &[],
        text: r#"const RAY_SHADOW = 1u;"#,
    },
    Declaration {
        module: "constants",
        name: "SLICES_ALONG_HEIGHT",
        sampling: None,
        uses: &[],
        text: r#"const SLICES_ALONG_HEIGHT = 0u;"#,
    },
    Declaration {
        module: "constants",
        name: "SLICES_ALONG_U",
        sampling: None,
        uses: &[],
        text: r#"const SLICES_ALONG_U = 1u;"#,
    },
    Declaration {
        module: "constants",
        name: "SLICES_ALONG_V",
        sampling: None,
        uses: &[],
        text: r#"const SLICES_ALONG_V = 2u;"#,
    },
    Declaration {
        module: "constants",
        name: "SLICES_ALONG_DEPTH",
        sampling: None,
        uses: &[],
        text: r#"const SLICES_ALONG_DEPTH = 3u;"#,
    },
    Declaration {
        module: "constants",
        name: "LIGHT_RAY_LIT",
        sampling: None,
        uses: &[],
        text: r#"const LIGHT_RAY_LIT = 0u;"#,
    },
    Declaration {
        module: "constants",
        name: "LIGHT_RAY_DARK",
        sampling: None,
        uses: &[],
        text: r#"const LIGHT_RAY_DARK = 1u;"#,
    },
    Declaration {
        module: "constants",
        name: "LIGHT_RAY_OPEN",
        sampling: None,
        uses: &[],
        text: r#"const LIGHT_RAY_OPEN = 2u;"#,
    },
    Declaration {
        module: "constants",
        name: "SLOT_DETAIL",
        sampling: None,
        uses: &[],
        text: r#"const SLOT_DETAIL = 0u;"#,
    },
    Declaration {
        module: "constants",
        name: "SLOT_SEARCH",
        sampling: None,
        uses: &[],
        text: r#"const SLOT_SEARCH = 1u;"#,
    },
    Declaration {
        module: "constants",
        name: "SLOT_SHADOW_SEARCH",
        sampling: None,
        uses: &[],
        text: r#"const SLOT_SHADOW_SEARCH = 2u;"#,
    },
    Declaration {
        module: "constants",
        name: "SLOT_SHADOW",
        sampling: None,
        uses: &[],
        text: r#"const SLOT_SHADOW = 3u;"#,
    },
    Declaration {
        module: "constants",
        name: "SLOT_AMBIENT",
        sampling: None,
        uses: &[],
        text: r#"const SLOT_AMBIENT = 4u;"#,
    },
    Declaration {
        module: "constants",
        name: "SLOT_ENVIRONMENT",
        sampling: None,
        uses: &[],
        text: r#"const SLOT_ENVIRONMENT = 5u;"#,
    },
    Declaration {
        module: "constants",
        name: "SLOT_LIGHTS",
        sampling: None,
        uses: &[],
        text: r#"const SLOT_LIGHTS = 6u;"#,
    },
    Declaration {
        module: "constants",
        name: "SLOT_OBJECT",
        sampling: None,
        uses: &[],
        text: r#"const SLOT_OBJECT = 7u;"#,
    },
    Declaration {
        module: "constants",
        name: "MAP_SLOTS",
        sampling: None,
        uses: &[],
        text: r#"const MAP_SLOTS = 8u;"#,
    },
    Declaration {
        module: "constants",
        name: "MAX_LIGHTS",
        sampling: None,
        uses: &[],
        text: r#"const MAX_LIGHTS = 8u;"#,
    },
    Declaration {
        module: "constants",
        name: "MAX_LIGHT_VIEWS",
        sampling: None,
        uses: &[],
        text: r#"const MAX_LIGHT_VIEWS = 48u;"#,
    },
    Declaration {
        module: "constants",
        name: "SHADE_GROUP",
        sampling: None,
        uses: &[],
        text: r#"const SHADE_GROUP = 8u;"#,
    },
    Declaration {
        module: "constants",
        name: "PROBE_GROUP",
        sampling: None,
        uses: &[],
        text: r#"const PROBE_GROUP = 64u;"#,
    },
    Declaration {
        module: "constants",
        name: "PROBE_ROW",
        sampling: None,
        uses: &[],
        text: r#"const PROBE_ROW = 65536u;"#,
    },
    Declaration {
        module: "constants",
        name: "TESSELLATE_GROUP",
        sampling: None,
        uses: &[],
        text: r#"const TESSELLATE_GROUP = 64u;"#,
    },
    Declaration {
        module: "constants",
        name: "TESSELLATE_ROW",
        sampling: None,
        uses: &[],
        text: r#"const TESSELLATE_ROW = 65536u;"#,
    },
    Declaration {
        module: "constants",
        name: "TESSELLATE_BLOCK",
        sampling: None,
        uses: &[],
        text: r#"const TESSELLATE_BLOCK = 256u;"#,
    },
    Declaration {
        module: "constants",
        name: "COARSEST",
        sampling: None,
        uses: &[],
        text: r#"const COARSEST = 20u;"#,
    },
    Declaration {
        module: "constants",
        name: "INSIDE",
        sampling: None,
        uses: &[],
        text: r#"const INSIDE = 3u;"#,
    },
    Declaration {
        module: "constants",
        name: "COUNTLESS",
        sampling: None,
        uses: &[],
        text: r#"const COUNTLESS = 4294967295u;"#,
    },
    Declaration {
        module: "constants",
        name: "BOX_VERTICES",
        sampling: None,
        uses: &[],
        text: r#"const BOX_VERTICES = 36u;"#,
    },
    Declaration {
        module: "constants",
        name: "SHELL_FOLDED",
        sampling: None,
        uses: &[],
        text: r#"const SHELL_FOLDED = 64u;"#,
    },
    Declaration {
        module: "constants",
        name: "SHELL_BOTH_SIDES",
        sampling: None,
        uses: &[],
        text: r#"const SHELL_BOTH_SIDES = 1u;"#,
    },
    Declaration {
        module: "constants",
        name: "SHELL_TRIANGLE",
        sampling: None,
        uses: &[],
        text: r#"const SHELL_TRIANGLE = 2u;"#,
    },
    Declaration {
        module: "constants",
        name: "SEEN_AZIMUTHS",
        sampling: None,
        uses: &[],
        text: r#"const SEEN_AZIMUTHS = 8u;"#,
    },
    Declaration {
        module: "constants",
        name: "SEEN_ELEVATIONS",
        sampling: None,
        uses: &[],
        text: r#"const SEEN_ELEVATIONS = 4u;"#,
    },
    Declaration {
        module: "constants",
        name: "CELLS_BILINEAR",
        sampling: None,
        uses: &[],
        text: r#"const CELLS_BILINEAR = 0u;"#,
    },
    Declaration {
        module: "constants",
        name: "CELLS_STEP",
        sampling: None,
        uses: &[],
        text: r#"const CELLS_STEP = 1u;"#,
    },
    Declaration {
        module: "constants",
        name: "CELLS_HIGHEST",
        sampling: None,
        uses: &[],
        text: r#"const CELLS_HIGHEST = 2u;"#,
    },
    Declaration {
        module: "constants",
        name: "CELLS_NEAREST",
        sampling: None,
        uses: &[],
        text: r#"const CELLS_NEAREST = 3u;"#,
    },
    Declaration {
        module: "constants",
        name: "CELLS_MASK",
        sampling: None,
        uses: &[],
        text: r#"const CELLS_MASK = 4u;"#,
    },
    Declaration {
        module: "constants",
        name: "TREE_SHIFT",
        sampling: None,
        uses: &[],
        text: r#"const TREE_SHIFT = 10u;"#,
    },
    Declaration {
        module: "constants",
        name: "TREE_COLUMNS",
        sampling: None,
        uses: &[],
        text: r#"const TREE_COLUMNS = 1024u;"#,
    },
    Declaration {
        module: "constants",
        name: "STAGES",
        sampling: None,
        uses: &[],
        text: r#"const STAGES = 12u;"#,
    },
    Declaration {
        module: "constants",
        name: "SURFACE_STAGE",
        sampling: None,
        uses: &[],
        text: r#"const SURFACE_STAGE = 1u;"#,
    },
    Declaration {
        module: "constants",
        name: "SEARCH_STAGE",
        sampling: None,
        uses: &[],
        text: r#"const SEARCH_STAGE = 6u;"#,
    },
    Declaration {
        module: "constants",
        name: "SHADOW_STAGE",
        sampling: None,
        uses: &[],
        text: r#"const SHADOW_STAGE = 9u;"#,
    },
    Declaration {
        module: "constants",
        name: "SHELL_SLACK",
        sampling: None,
        uses: &[],
        text: r#"const SHELL_SLACK = 5e-6;"#,
    },
    Declaration {
        module: "constants",
        name: "DEPTH_SLACK",
        sampling: None,
        uses: &[],
        text: r#"const DEPTH_SLACK = 1e-5;"#,
    },
    Declaration {
        module: "constants",
        name: "EMPTY_HEIGHT",
        sampling: None,
        uses: &[],
        text: r#"const EMPTY_HEIGHT = 1e-5;"#,
    },
    Declaration {
        module: "constants",
        name: "LEAST_FRAME_FACING",
        sampling: None,
        uses: &[],
        text: r#"const LEAST_FRAME_FACING = 0.05;"#,
    },
    Declaration {
        module: "constants",
        name: "LEAST_FRAME_COVER",
        sampling: None,
        uses: &[],
        text: r#"const LEAST_FRAME_COVER = 0.5;"#,
    },
    Declaration {
        module: "constants",
        name: "CONE_HALF_RATIO",
        sampling: None,
        uses: &[],
        text: r#"const CONE_HALF_RATIO = 0.125;"#,
    },
    Declaration {
        module: "shared/angle",
        name: "eighth_turn",
        sampling: None,
        uses: &[],
        text: r#"// A polynomial for the arc tangent over the circle's radians, up to an eighth of a turn, off by 2e-6 turns at
// most (Abramowitz and Stegun 1964, 4.4.49).
fn eighth_turn(tangent: f32) -> f32 {
    let s = tangent * tangent;
    let series = 0.9998660 + s * (-0.3302995 + s * (0.1801410 + s * (-0.0851330 + s * 0.0208351)));
    return tangent * series * 0.159154943;
}"#,
    },
    Declaration {
        module: "shared/angle",
        name: "turn_of",
        sampling: None,
        uses: &["eighth_turn"],
        text: r#"// The angle of a vector in turns, from 0 up to 1, counted from the first axis to the second. The
// zero vector gives 0.
fn turn_of(v: vec2f) -> f32 {
    let x = abs(v.x);
    let y = abs(v.y);
    if (!(x + y > 0.0)) {
        return 0.0;
    }
    var turn = eighth_turn(min(x, y) / max(x, y));
    if (y > x) {
        turn = 0.25 - turn;
    }
    if (v.x < 0.0) {
        turn = 0.5 - turn;
    }
    if (v.y < 0.0) {
        turn = 1.0 - turn;
    }
    return select(turn, 0.0, turn >= 1.0);
}"#,
    },
    Declaration {
        module: "shared/angle",
        name: "quarter_sine",
        sampling: None,
        uses: &[],
        text: r#"// The sine of an angle of up to a quarter of a turn, off by 4e-6 at most.
fn quarter_sine(turn: f32) -> f32 {
    let x = turn * 6.28318531;
    let s = x * x;
    let last = -0.000198412698 + s * 0.00000275573192;
    return x * (1.0 + s * (-0.166666667 + s * (0.00833333333 + s * last)));
}"#,
    },
    Declaration {
        module: "shared/angle",
        name: "sine_of",
        sampling: None,
        uses: &["quarter_sine"],
        text: r#"// The sine of any angle.
fn sine_of(turn: f32) -> f32 {
    let part = turn - floor(turn);
    let sine = quarter_sine(0.25 - abs(0.25 - abs(part - 0.5)));
    return select(sine, 0.0 - sine, part > 0.5);
}"#,
    },
    Declaration {
        module: "shared/angle",
        name: "turned",
        sampling: None,
        uses: &["sine_of"],
        text: r#"// The unit vector at an angle.
fn turned(turn: f32) -> vec2f {
    return vec2f(sine_of(turn + 0.25), sine_of(turn));
}"#,
    },
    Declaration {
        module: "shared/background",
        name: "background_at",
        sampling: None,
        uses: &["environment_of_level", "frame", "pixel_direction"],
        text: r#"// The linear colour at a point in pixels from the picture's top-left corner, in a picture of `rows` rows.
fn background_at(point: vec2f, rows: f32) -> vec3f {
    if (frame.background.w > 0.0) {
        return environment_of_level(pixel_direction(point), 0u) * frame.background.w;
    }
    let top = frame.background.xyz;
    return top + (frame.background_below.xyz - top) * (point.y / rows);
}"#,
    },
    Declaration {
        module: "shared/base",
        name: "plane_distance",
        sampling: None,
        uses: &["PixelIn"],
        text: r#"// The ray's parameter on the plane with that normal, of any length, through the triangle.
fn plane_distance(pixel: PixelIn, normal: vec3f) -> f32 {
    return dot(normal, pixel.a.position - pixel.origin) / dot(normal, pixel.direction);
}"#,
    },
    Declaration {
        module: "shared/base",
        name: "plane_normal",
        sampling: None,
        uses: &["PixelIn"],
        text: r#"// The triangle's normal, of any length.
fn plane_normal(pixel: PixelIn) -> vec3f {
    let a = pixel.a.position;
    return cross(pixel.b.position - a, pixel.c.position - a);
}"#,
    },
    Declaration {
        module: "shared/base",
        name: "weights_of",
        sampling: None,
        uses: &[],
        text: r#"// The barycentric weights of three points at a point of their plane. `normal` is the plane's.
fn weights_of(a: vec3f, b: vec3f, c: vec3f, normal: vec3f, point: vec3f) -> vec3f {
    let nn = dot(normal, normal);
    let from_a = point - a;
    let wb = dot(cross(from_a, c - a), normal) / nn;
    let wc = dot(cross(b - a, from_a), normal) / nn;
    return vec3f(1.0 - wb - wc, wb, wc);
}"#,
    },
    Declaration {
        module: "shared/base",
        name: "plane_weights",
        sampling: None,
        uses: &["PixelIn", "weights_of"],
        text: r#"// The weights of the corners at a point of the plane with that normal.
fn plane_weights(pixel: PixelIn, normal: vec3f, point: vec3f) -> vec3f {
    return weights_of(pixel.a.position, pixel.b.position, pixel.c.position, normal, point);
}"#,
    },
    Declaration {
        module: "shared/base",
        name: "triangle_weights",
        sampling: None,
        uses: &["PixelIn", "plane_weights"],
        text: r#"// The weights of the corners at a point of the triangle, at least 0 each. By rounding the point may
// lie beside a small triangle.
fn triangle_weights(pixel: PixelIn, normal: vec3f, point: vec3f) -> vec3f {
    let inside = max(plane_weights(pixel, normal, point), vec3f(0.0, 0.0, 0.0));
    return inside / (inside.x + inside.y + inside.z);
}"#,
    },
    Declaration {
        module: "shared/base",
        name: "triangle_distance",
        sampling: None,
        uses: &["PixelIn"],
        text: r#"// The ray's parameter on the triangle, whose plane has that normal. For a triangle seen edge-on the
// result stays between its corners.
fn triangle_distance(pixel: PixelIn, normal: vec3f) -> f32 {
    let a = pixel.a.position - pixel.origin;
    let b = pixel.b.position - pixel.origin;
    let c = pixel.c.position - pixel.origin;
    let along = pixel.direction / dot(pixel.direction, pixel.direction);
    let places = vec3f(dot(a, along), dot(b, along), dot(c, along));
    let least = min(min(places.x, places.y), places.z);
    let most = max(max(places.x, places.y), places.z);
    let across = dot(normal, pixel.direction);
    if (across == 0.0) {
        return least;
    }
    return clamp(dot(normal, a) / across, least, most);
}"#,
    },
    Declaration {
        module: "shared/bounding_box",
        name: "BOX_MARGIN",
        sampling: None,
        uses: &[],
        text: r#"// Pixels by which a box is larger than its shell: rasterisers know places to some hundredths of a pixel.
const BOX_MARGIN = 0.0625;"#,
    },
    Declaration {
        module: "shared/bounding_box",
        name: "BOX_ROUNDING",
        sampling: None,
        uses: &[],
        text: r#"// The same margin relative to the distances in play, for rounding.
const BOX_ROUNDING = 0.000002;"#,
    },
    Declaration {
        module: "shared/bounding_box",
        name: "widened",
        sampling: None,
        uses: &["Corner", "moved_out"],
        text: r#"// An extent along an axis, widened to hold a corner at both offsets.
fn widened(extent: vec2f, axis: vec3f, corner: Corner, offsets: vec2f, side: f32) -> vec2f {
    let low = dot(moved_out(corner, side, offsets.x), axis);
    let high = dot(moved_out(corner, side, offsets.y), axis);
    return vec2f(min(extent.x, min(low, high)), max(extent.y, max(low, high)));
}"#,
    },
    Declaration {
        module: "shared/bounding_box",
        name: "extent_along",
        sampling: None,
        uses: &["Triangle", "moved_out", "offsets_of", "widened"],
        text: r#"// The extent of a triangle's shell along an axis, with a margin.
fn extent_along(triangle: Triangle, axis: vec3f, side: f32, margin: f32) -> vec2f {
    let offsets = offsets_of(triangle.shell);
    let first = dot(moved_out(triangle.a, side, offsets.x), axis);
    var extent = vec2f(first, first);
    extent = widened(extent, axis, triangle.a, offsets, side);
    extent = widened(extent, axis, triangle.b, offsets, side);
    extent = widened(extent, axis, triangle.c, offsets, side);
    return extent + vec2f(0.0 - margin, margin);
}"#,
    },
    Declaration {
        module: "shared/bounding_box",
        name: "depth_of",
        sampling: None,
        uses: &["frame"],
        text: r#"// Metres from the eye to a position, along the view axis.
fn depth_of(position: vec3f) -> f32 {
    return dot(position - frame.eye.xyz, frame.forward.xyz);
}"#,
    },
    Declaration {
        module: "shared/bounding_box",
        name: "margin_of",
        sampling: None,
        uses: &["BOX_MARGIN", "BOX_ROUNDING", "Triangle", "depth_of", "frame", "offsets_of"],
        text: r#"// Metres by which a box is larger than a shell.
fn margin_of(triangle: Triangle) -> f32 {
    let first = max(depth_of(triangle.a.position), depth_of(triangle.b.position));
    let offsets = offsets_of(triangle.shell);
    let beyond = abs(offsets.x) + abs(offsets.y);
    let depth = max(max(first, depth_of(triangle.c.position)), 0.0) + beyond;
    let pixel = length(frame.eye_right.xyz + frame.right.xyz * depth);
    let place = abs(triangle.a.position);
    return BOX_MARGIN * pixel + BOX_ROUNDING * (max(max(place.x, place.y), place.z) + depth);
}"#,
    },
    Declaration {
        module: "shared/bounding_box",
        name: "box_corner",
        sampling: None,
        uses: &["Triangle", "extent_along", "margin_of"],
        text: r#"// A vertex of the box around a triangle's shell, along the triangle's own axes. Seen from outside,
// the vertices of each side run counter-clockwise.
fn box_corner(triangle: Triangle, side: f32, vertex: u32) -> vec3f {
    let edge = triangle.b.position - triangle.a.position;
    let across = cross(edge, triangle.c.position - triangle.a.position);
    var x = vec3f(1.0, 0.0, 0.0);
    var z = vec3f(0.0, 0.0, 1.0);
    if (dot(across, across) > 0.0) {
        x = normalize(edge);
        z = normalize(across);
    }
    let y = cross(z, x);
    let margin = margin_of(triangle);
    let along_x = extent_along(triangle, x, side, margin);
    let along_y = extent_along(triangle, y, side, margin);
    let along_z = extent_along(triangle, z, side, margin);

    // The corners of a side are numbered by rows, from 0 to 3. Its triangles are 0, 1, 2 and 2, 1,
    // 3.
    let place = vertex % 6u;
    var corner = select(place, 5u - place, place > 2u);
    if (place == 5u) {
        corner = 3u;
    }
    let number = vertex / 6u;
    let is_upper = number % 2u;
    // The lower side is seen from the other side.
    let u = select(corner / 2u, corner % 2u, is_upper == 1u);
    let v = select(corner % 2u, corner / 2u, is_upper == 1u);
    var upper = vec3u(is_upper, u, v);
    if (number / 2u == 1u) {
        upper = vec3u(v, is_upper, u);
    }
    if (number / 2u == 2u) {
        upper = vec3u(u, v, is_upper);
    }
    return x * select(along_x.x, along_x.y, upper.x == 1u) + y * select(along_y.x, along_y.y, upper.y == 1u)
        + z * select(along_z.x, along_z.y, upper.z == 1u);
}"#,
    },
    Declaration {
        module: "shared/cell",
        name: "NEVER",
        sampling: None,
        uses: &[],
        text: r#"// Larger than any parameter; stands for "never crossed".
const NEVER = 3.0e38;"#,
    },
    Declaration {
        module: "shared/cell",
        name: "ROUNDING",
        sampling: None,
        uses: &[],
        text: r#"// Share of a sum's terms that is taken off for rounding: 8 roundings, of the sum and of its inputs.
// Smaller, and steps may pass what `cells` sees; larger, and rays that graze plateaus look at more
// patches.
const ROUNDING = 0.00000095367431640625;"#,
    },
    Declaration {
        module: "shared/cell",
        name: "Grid",
        sampling: None,
        uses: &[],
        text: r#"// The path in cell units: position at t = 0 and change per unit of t.
struct Grid {
    origin: vec2f,
    step: vec2f,
}"#,
    },
    Declaration {
        module: "shared/cell",
        name: "grid_of",
        sampling: None,
        uses: &["Grid", "Path", "height_size", "object_parts_stage"],
        text: r#"fn grid_of(path: Path) -> Grid {
    let size = height_size(path.level);
    let parts = f32(object_parts_stage(path.level));
    return Grid((path.uv * size - vec2f(0.5, 0.5)) * parts, path.duv * size * parts);
}"#,
    },
    Declaration {
        module: "shared/cell",
        name: "cell_leave",
        sampling: None,
        uses: &["Grid", "NEVER"],
        text: r#"// The parameter where the path leaves the cell through its sides across u and across v. Computed from the
// cell number each time, so that nothing accumulates.
fn cell_leave(grid: Grid, cell: vec2f) -> vec2f {
    let ahead = select(vec2f(0.0, 0.0), vec2f(1.0, 1.0), grid.step > vec2f(0.0, 0.0));
    let leave = (cell + ahead - grid.origin) / grid.step;
    return select(vec2f(NEVER, NEVER), leave, abs(grid.step) > vec2f(0.0, 0.0));
}"#,
    },
    Declaration {
        module: "shared/cell",
        name: "cell_next",
        sampling: None,
        uses: &["Grid"],
        text: r#"// The next cell, behind the side through which the path leaves.
fn cell_next(grid: Grid, cell: vec2f, leave: vec2f) -> vec2f {
    var next = cell;
    if (leave.x <= leave.y) {
        next.x = cell.x + select(-1.0, 1.0, grid.step.x > 0.0);
    } else {
        next.y = cell.y + select(-1.0, 1.0, grid.step.y > 0.0);
    }
    return next;
}"#,
    },
    Declaration {
        module: "shared/cell",
        name: "cell_after",
        sampling: None,
        uses: &["Grid", "cell_of"],
        text: r#"// The cell that holds the ray at t, after a step through the side of `cell` along each axis that it
// has left by then. Rounding may put the ray before a line that it has crossed; then it still is in
// the cell behind that line.
fn cell_after(grid: Grid, cell: vec2f, leave: vec2f, forward: vec2<bool>, t: f32) -> vec2f {
    let near = cell_of(grid.origin + grid.step * t);
    let ahead = max(near, cell + select(vec2f(0.0, 0.0), vec2f(1.0, 1.0), leave <= vec2f(t, t)));
    let behind = min(near, cell - select(vec2f(0.0, 0.0), vec2f(1.0, 1.0), leave <= vec2f(t, t)));
    return select(behind, ahead, forward);
}"#,
    },
    Declaration {
        module: "shared/cell",
        name: "cell_gap",
        sampling: None,
        uses: &["Grid", "Path", "gap_to", "object_cell_stage", "whole_cell"],
        text: r#"// The coefficients of the gap in a cell, from parameter t on. One read.
fn cell_gap(path: Path, grid: Grid, cell: vec2f, t: f32) -> vec3f {
    return gap_to(path, grid, cell, object_cell_stage(whole_cell(cell), path.level), t);
}"#,
    },
    Declaration {
        module: "shared/cell",
        name: "gap_to",
        sampling: None,
        uses: &["Grid", "Path"],
        text: r#"// The coefficients of the gap in a cell with known corners, from parameter t on.
fn gap_to(path: Path, grid: Grid, cell: vec2f, h: vec4f, t: f32) -> vec3f {
    let bx = h.y - h.x;
    let by = h.z - h.x;
    let twist = (h.x - h.y) + (h.w - h.z);
    let at = (grid.origin - cell) + grid.step * t;
    let z = path.h.x + t * (path.h.y + t * path.h.z);
    let dz = path.h.y + 2.0 * t * path.h.z;
    return vec3f(
        z - (h.x + bx * at.x + by * at.y + twist * at.x * at.y),
        dz - (bx * grid.step.x + by * grid.step.y + twist * (at.x * grid.step.y + at.y * grid.step.x)),
        path.h.z - twist * grid.step.x * grid.step.y,
    );
}"#,
    },
    Declaration {
        module: "shared/cell",
        name: "quadratic",
        sampling: None,
        uses: &[],
        text: r#"fn quadratic(c: vec3f, s: f32) -> f32 {
    return c.x + s * (c.y + s * c.z);
}"#,
    },
    Declaration {
        module: "shared/cell",
        name: "least_at",
        sampling: None,
        uses: &[],
        text: r#"// The place in [0, span] where a quadratic that is positive at 0 is least. It is not positive there
// if it is not positive anywhere in the interval.
fn least_at(c: vec3f, span: f32) -> f32 {
    if (c.z > 0.0) {
        return clamp((0.0 - c.y) / (2.0 * c.z), 0.0, span);
    }
    return span;
}"#,
    },
    Declaration {
        module: "shared/cell",
        name: "first_root",
        sampling: None,
        uses: &["NEVER", "quadratic"],
        text: r#"// The first root of c in [0, span], or NEVER. c.x is positive.
fn first_root(c: vec3f, span: f32) -> f32 {
    let discriminant = c.y * c.y - 4.0 * c.z * c.x;
    if (discriminant >= 0.0) {
        let root = sqrt(discriminant);
        let q = -0.5 * (c.y + select(0.0 - root, root, c.y >= 0.0));
        var a = NEVER;
        var b = NEVER;
        if (c.z != 0.0) {
            a = q / c.z;
        }
        if (q != 0.0) {
            b = c.x / q;
        }
        a = select(NEVER, a, a >= 0.0);
        b = select(NEVER, b, b >= 0.0);
        let first = min(a, b);
        if (first <= span) {
            return first;
        }
    }
    // Rounding may push a root past the cell's end, where the gap itself still tells.
    if (quadratic(c, span) <= 0.0) {
        return span;
    }
    return NEVER;
}"#,
    },
    Declaration {
        module: "shared/cell",
        name: "falls_in_cell",
        sampling: None,
        uses: &["least_at", "quadratic"],
        text: r#"// Whether a gap of c falls to zero in [0, span].
fn falls_in_cell(c: vec3f, span: f32) -> bool {
    return c.x <= 0.0 || quadratic(c, least_at(c, span)) <= 0.0;
}"#,
    },
    Declaration {
        module: "shared/cell",
        name: "found_in_cell",
        sampling: None,
        uses: &["FOUND_BRACKET", "FOUND_STARTED_BELOW", "SearchResult", "least_at", "quadratic"],
        text: r#"// The search result of a cell in which the gap c falls to zero between t and t + span: a bracket
// that ends where the gap is least. `first` says that the path begins in this cell.
fn found_in_cell(c: vec3f, t: f32, span: f32, first: bool, cost: vec3u) -> SearchResult {
    if (c.x <= 0.0) {
        if (first && c.x < 0.0) {
            return SearchResult(FOUND_STARTED_BELOW, 0.0, 0.0, c.x, c.x, cost);
        }
        return SearchResult(FOUND_BRACKET, t, t, c.x, c.x, cost);
    }
    let s = least_at(c, span);
    return SearchResult(FOUND_BRACKET, t, t + s, c.x, quadratic(c, s), cost);
}"#,
    },
    Declaration {
        module: "shared/cone",
        name: "FEW_CELLS",
        sampling: None,
        uses: &[],
        text: r#"// The most cells of a bracket that a refinement may go through one by one.
const FEW_CELLS = 3.0;"#,
    },
    Declaration {
        module: "shared/cone",
        name: "slope_of",
        sampling: None,
        uses: &["CONE_HALF_RATIO"],
        text: r#"// The slope of a cone by its stored value, in heights per tile; negative for a cone without a known
// width.
fn slope_of(value: f32) -> f32 {
    // The ratio, in tiles for each unit of height, is half v² / (1 - v²).
    let squared = CONE_HALF_RATIO * value * value;
    if (squared > 0.0) {
        return (1.0 - value) * (1.0 + value) / squared;
    }
    return -1.0;
}"#,
    },
    Declaration {
        module: "shared/cone",
        name: "cone_slope",
        sampling: None,
        uses: &["Path", "height_texels", "search_texel", "slope_of", "whole_cell", "wrap_index"],
        text: r#"// Slope of the cone on a texel. One read.
fn cone_slope(path: Path, texel: vec2f) -> f32 {
    let n = height_texels(path.level);
    let place = whole_cell(texel);
    let wrapped = vec2i(wrap_index(place.x, n.x), wrap_index(place.y, n.y));
    return slope_of(search_texel(path, wrapped, 0, i32(path.level)).x);
}"#,
    },
    Declaration {
        module: "shared/cone",
        name: "nearest_corner",
        sampling: None,
        uses: &[],
        text: r#"// The corner of a cell that is nearest to a place in it.
fn nearest_corner(at: vec2f) -> vec2f {
    return select(vec2f(0.0, 0.0), vec2f(1.0, 1.0), at >= vec2f(0.5, 0.5));
}"#,
    },
    Declaration {
        module: "shared/cone",
        name: "corner_height",
        sampling: None,
        uses: &[],
        text: r#"// The height at a corner of a cell.
fn corner_height(heights: vec4f, corner: vec2f) -> f32 {
    let above = select(heights.x, heights.y, corner.x > 0.5);
    let below = select(heights.z, heights.w, corner.x > 0.5);
    return select(above, below, corner.y > 0.5);
}"#,
    },
    Declaration {
        module: "shared/cone",
        name: "stays_inside",
        sampling: None,
        uses: &["Grid", "NEVER", "Path", "ROUNDING", "height_size", "path_height", "path_slope"],
        text: r#"// The length along the ray, from t, that stays inside the cone with that slope on an apex, with a
// margin for rounding. `offset` is the texel's centre, in texels, as the origin of the path's
// places.
fn stays_inside(path: Path, grid: Grid, offset: vec2f, apex: f32, slope: f32, t: f32) -> f32 {
    let rest = path.exit - t;
    let height = path_height(path, t) - apex;
    // A path that bends down is above its chord, one that bends up above its tangent.
    let terms = abs(path.h.y) + 2.0 * path.exit * abs(path.h.z);
    let rise = path_slope(path, t) + min(path.h.z, 0.0) * rest - ROUNDING * terms;
    var most = rest;
    if (rise < 0.0) {
        most = min(most, height / (0.0 - rise));
    }
    let end = t + most;
    let far = (abs(grid.origin) + abs(grid.step) * end + vec2f(1.0, 1.0)) / height_size(path.level);
    let of_heights = ROUNDING * (abs(path.h.x) + end * (abs(path.h.y) + end * abs(path.h.z)));
    let lost = of_heights + ROUNDING * slope * (far.x + far.y);
    let gap = height - 2.0 * lost;
    let aside = ((grid.origin - offset) + grid.step * t) / height_size(path.level);
    let c = (slope * length(aside) - gap) * (slope * length(aside) + gap);
    if (gap <= 0.0 || c >= 0.0) {
        return 0.0;
    }
    // Where slope |aside + duv s| is gap + rise s.
    let b = slope * slope * dot(aside, path.duv) - gap * rise;
    let a = slope * slope * dot(path.duv, path.duv) - rise * rise;
    let discriminant = b * b - a * c;
    var leave = NEVER;
    if (discriminant >= 0.0) {
        let root = sqrt(discriminant);
        if (b >= 0.0) {
            leave = (0.0 - c) / (b + root);
        } else if (a > 0.0) {
            leave = (root - b) / a;
        }
    }
    leave = min(leave, most);
    if (slope * length(aside + path.duv * leave) + lost <= height + rise * leave) {
        return leave;
    }
    return 0.0;
}"#,
    },
    Declaration {
        module: "shared/cone",
        name: "entered_once",
        sampling: None,
        uses: &["FEW_CELLS", "FOUND_BRACKET", "Grid", "HEIGHTS_READ", "Path", "STEP", "SearchResult", "path_gap"],
        text: r#"// The bracket of the only entry between two places, one above and one below the surface. It is
// halved until few cells are left.
fn entered_once(
    path: Path,
    grid: Grid,
    above: f32,
    below: f32,
    above_gap: f32,
    below_gap: f32,
    so_far: vec3u,
) -> SearchResult {
    var near = above;
    var far = below;
    var near_gap = above_gap;
    var far_gap = below_gap;
    var cost = so_far;
    let wide = abs(grid.step.x) + abs(grid.step.y);
    while (wide * (far - near) > FEW_CELLS) {
        cost = cost + STEP;
        let middle = 0.5 * (near + far);
        if (!(middle > near && middle < far)) {
            break;
        }
        let gap = path_gap(path, middle);
        cost = cost + HEIGHTS_READ;
        if (gap <= 0.0) {
            far = middle;
            far_gap = gap;
        } else {
            near = middle;
            near_gap = gap;
        }
    }
    return SearchResult(FOUND_BRACKET, near, far, near_gap, far_gap, cost);
}"#,
    },
    Declaration {
        module: "shared/cost",
        name: "NO_COST",
        sampling: None,
        uses: &[],
        text: r#"const NO_COST = vec3u(0u, 0u, 0u);"#,
    },
    Declaration {
        module: "shared/cost",
        name: "STEP",
        sampling: None,
        uses: &[],
        text: r#"// One step: a turn of a loop.
const STEP = vec3u(0u, 1u, 0u);"#,
    },
    Declaration {
        module: "shared/cost",
        name: "HEIGHTS_READ",
        sampling: None,
        uses: &[],
        text: r#"// One read of the four heights of a cell, or between four texels.
const HEIGHTS_READ = vec3u(1u, 0u, 16u);"#,
    },
    Declaration {
        module: "shared/cost",
        name: "VOXELS_READ",
        sampling: None,
        uses: &[],
        text: r#"// One read of the eight voxels around a place.
const VOXELS_READ = vec3u(1u, 0u, 32u);"#,
    },
    Declaration {
        module: "shared/cost",
        name: "HEIGHT_READ",
        sampling: None,
        uses: &[],
        text: r#"// One read of a single height.
const HEIGHT_READ = vec3u(1u, 0u, 4u);"#,
    },
    Declaration {
        module: "shared/dice",
        name: "DICE_PARTS",
        sampling: None,
        uses: &[],
        text: r#"// The most parts of a side: with as many the numbers of points and triangles fit 32 bits.
const DICE_PARTS = 32767u;"#,
    },
    Declaration {
        module: "shared/dice",
        name: "DiceRows",
        sampling: None,
        uses: &[],
        text: r#"// A triangle seen from the corner where its two longer sides meet.
struct DiceRows {
    // The side from that corner onward, the side of fewest parts, and the side back to the corner;
    // then the parts of each.
    sides: vec3u,
    parts: vec3u,
    // Number of rows after the corner.
    count: u32,
}"#,
    },
    Declaration {
        module: "shared/dice",
        name: "DicePoint",
        sampling: None,
        uses: &[],
        text: r#"// A point of a triangle.
struct DicePoint {
    // The triangle's side that the point lies on, and the number of parts before it there, fewer
    // than the side has; or `INSIDE`, and its number among the points inside.
    side: u32,
    at: u32,
    // The weights of the triangle's corners; not set for a point on a side.
    weights: vec3f,
}"#,
    },
    Declaration {
        module: "shared/dice",
        name: "DicePlace",
        sampling: None,
        uses: &[],
        text: r#"// Where a point lies in its row.
struct DicePlace {
    row: u32,
    at: u32,
}"#,
    },
    Declaration {
        module: "shared/dice",
        name: "DiceTriangle",
        sampling: None,
        uses: &["DicePlace"],
        text: r#"// A triangle of the pattern, with the winding of the whole one.
struct DiceTriangle {
    a: DicePlace,
    b: DicePlace,
    c: DicePlace,
}"#,
    },
    Declaration {
        module: "shared/dice",
        name: "one_of",
        sampling: None,
        uses: &[],
        text: r#"// One of three numbers.
fn one_of(numbers: vec3u, place: u32) -> u32 {
    return select(select(numbers.z, numbers.y, place == 1u), numbers.x, place == 0u);
}"#,
    },
    Declaration {
        module: "shared/dice",
        name: "around_three",
        sampling: None,
        uses: &[],
        text: r#"// The number that follows another of three after `on` steps, cyclically.
fn around_three(place: u32, on: u32) -> u32 {
    return (place + on) % 3u;
}"#,
    },
    Declaration {
        module: "shared/dice",
        name: "dice_rows",
        sampling: None,
        uses: &["DiceRows", "around_three", "one_of"],
        text: r#"fn dice_rows(parts: vec3u) -> DiceRows {
    let of_last = select(2u, 1u, parts.y <= parts.z);
    let short = select(of_last, 0u, parts.x <= parts.y && parts.x <= parts.z);
    let sides = vec3u(around_three(short, 2u), short, around_three(short, 1u));
    let sorted = vec3u(one_of(parts, sides.x), one_of(parts, sides.y), one_of(parts, sides.z));
    return DiceRows(sides, sorted, max(sorted.x, sorted.z));
}"#,
    },
    Declaration {
        module: "shared/dice",
        name: "dice_share",
        sampling: None,
        uses: &["DiceRows"],
        text: r#"// The number of parts that belong to the rows up to `row`, where all rows have `parts`.
fn dice_share(rows: DiceRows, row: u32, parts: u32) -> u32 {
    return (row * parts + rows.count - 1u) / rows.count;
}"#,
    },
    Declaration {
        module: "shared/dice",
        name: "dice_row_parts",
        sampling: None,
        uses: &["DiceRows", "dice_share"],
        text: r#"// The number of parts of a row.
fn dice_row_parts(rows: DiceRows, row: u32) -> u32 {
    return dice_share(rows, row, rows.parts.y);
}"#,
    },
    Declaration {
        module: "shared/dice",
        name: "sum_of_quotients",
        sampling: None,
        uses: &[],
        text: r#"// The sum of (slope i + offset) / by, rounded down, for i from 0 to count - 1.
fn sum_of_quotients(count: u32, by: u32, slope: u32, offset: u32) -> u32 {
    var n = count;
    var m = by;
    var a = slope;
    var b = offset;
    var sum = 0u;
    while (n > 0u) {
        sum = sum + n * (n - 1u) / 2u * (a / m) + n * (b / m);
        a = a % m;
        b = b % m;
        let last = a * n + b;
        n = last / m;
        b = last % m;
        let swapped = m;
        m = max(a, 1u);
        a = swapped;
    }
    return sum;
}"#,
    },
    Declaration {
        module: "shared/dice",
        name: "dice_parts_before",
        sampling: None,
        uses: &["DiceRows", "sum_of_quotients"],
        text: r#"// The number of parts in the first `count` rows, less one for each row.
fn dice_parts_before(rows: DiceRows, count: u32) -> u32 {
    return sum_of_quotients(count, rows.count, rows.parts.y, rows.parts.y - 1u);
}"#,
    },
    Declaration {
        module: "shared/dice",
        name: "dice_points_before",
        sampling: None,
        uses: &["DiceRows", "dice_parts_before"],
        text: r#"// The number of points inside the triangle before a row, which is one after the corner.
fn dice_points_before(rows: DiceRows, row: u32) -> u32 {
    return dice_parts_before(rows, row - 1u);
}"#,
    },
    Declaration {
        module: "shared/dice",
        name: "dice_points",
        sampling: None,
        uses: &["DiceRows", "dice_points_before"],
        text: r#"// The number of points inside the triangle.
fn dice_points(rows: DiceRows) -> u32 {
    return dice_points_before(rows, rows.count);
}"#,
    },
    Declaration {
        module: "shared/dice",
        name: "dice_triangles_before",
        sampling: None,
        uses: &["DiceRows", "dice_parts_before", "dice_row_parts", "dice_share"],
        text: r#"// The number of triangles before the end of row `row`. Rows that share an end have one less between
// them.
fn dice_triangles_before(rows: DiceRows, row: u32) -> u32 {
    let ends = dice_share(rows, row, rows.parts.x) + dice_share(rows, row, rows.parts.z);
    return 2u * dice_parts_before(rows, row) + ends - dice_row_parts(rows, row);
}"#,
    },
    Declaration {
        module: "shared/dice",
        name: "dice_triangles",
        sampling: None,
        uses: &["DiceRows", "dice_triangles_before"],
        text: r#"// The number of triangles.
fn dice_triangles(rows: DiceRows) -> u32 {
    return dice_triangles_before(rows, rows.count);
}"#,
    },
    Declaration {
        module: "shared/dice",
        name: "dice_guess",
        sampling: None,
        uses: &["DiceRows"],
        text: r#"// A guess at the row where a number that grows as the square of the row reaches `before`. At the
// end of all rows it is `all`.
fn dice_guess(rows: DiceRows, before: u32, all: u32) -> u32 {
    let part = sqrt((f32(before) + 0.5) / f32(max(all, 1u)));
    return clamp(u32(part * f32(rows.count)), 0u, rows.count - 1u);
}"#,
    },
    Declaration {
        module: "shared/dice",
        name: "dice_row_of_point",
        sampling: None,
        uses: &["DiceRows", "dice_guess", "dice_points", "dice_points_before"],
        text: r#"// The row that a point inside of the triangle lies in.
fn dice_row_of_point(rows: DiceRows, number: u32) -> u32 {
    var row = max(dice_guess(rows, number, dice_points(rows)), 1u);
    while (dice_points_before(rows, row) > number) {
        row = row - 1u;
    }
    while (dice_points_before(rows, row + 1u) <= number) {
        row = row + 1u;
    }
    return row;
}"#,
    },
    Declaration {
        module: "shared/dice",
        name: "dice_row_of_triangle",
        sampling: None,
        uses: &["DiceRows", "dice_guess", "dice_triangles", "dice_triangles_before"],
        text: r#"// The row that a triangle lies before.
fn dice_row_of_triangle(rows: DiceRows, number: u32) -> u32 {
    var row = dice_guess(rows, number, dice_triangles(rows));
    while (dice_triangles_before(rows, row) > number) {
        row = row - 1u;
    }
    while (dice_triangles_before(rows, row + 1u) <= number) {
        row = row + 1u;
    }
    return row + 1u;
}"#,
    },
    Declaration {
        module: "shared/dice",
        name: "dice_border",
        sampling: None,
        uses: &["DicePoint", "DiceRows", "around_three", "one_of"],
        text: r#"// The point of a side with `at` parts before it, counted from the corner, or on the short side from
// its first end. The last point of a side is the first one of the next.
fn dice_border(rows: DiceRows, side: u32, at: u32) -> DicePoint {
    let number = one_of(rows.sides, side);
    let parts = one_of(rows.parts, side);
    let on_side = select(at, parts - at, side == 2u);
    let no_weights = vec3f(0.0, 0.0, 0.0);
    if (on_side == parts) {
        return DicePoint(around_three(number, 1u), 0u, no_weights);
    }
    return DicePoint(number, on_side, no_weights);
}"#,
    },
    Declaration {
        module: "shared/dice",
        name: "dice_point",
        sampling: None,
        uses: &["DicePlace", "DicePoint", "DiceRows", "INSIDE", "dice_border", "dice_points_before", "dice_row_parts", "dice_share"],
        text: r#"// The point at a place.
fn dice_point(rows: DiceRows, place: DicePlace) -> DicePoint {
    if (place.row == 0u) {
        return dice_border(rows, 0u, 0u);
    }
    if (place.row == rows.count) {
        return dice_border(rows, 1u, place.at);
    }
    let parts = dice_row_parts(rows, place.row);
    let first = dice_share(rows, place.row, rows.parts.x);
    let last = dice_share(rows, place.row, rows.parts.z);
    if (place.at == 0u) {
        return dice_border(rows, 0u, first);
    }
    if (place.at == parts) {
        return dice_border(rows, 2u, last);
    }
    // The weights of the two ends of the short side, then of the corner.
    let on_short = f32(parts - place.at) / f32(parts) * (f32(first) / f32(rows.parts.x));
    let on_other = f32(place.at) / f32(parts) * (f32(last) / f32(rows.parts.z));
    let on_corner = 1.0 - on_short - on_other;
    let x = select(select(on_other, on_short, rows.sides.y == 0u), on_corner, rows.sides.x == 0u);
    let y = select(select(on_other, on_short, rows.sides.y == 1u), on_corner, rows.sides.x == 1u);
    let z = select(select(on_other, on_short, rows.sides.y == 2u), on_corner, rows.sides.x == 2u);
    let number = dice_points_before(rows, place.row) + place.at - 1u;
    return DicePoint(INSIDE, number, vec3f(x, y, z));
}"#,
    },
    Declaration {
        module: "shared/dice",
        name: "dice_place",
        sampling: None,
        uses: &["DicePlace", "DiceRows", "dice_points_before", "dice_row_of_point"],
        text: r#"// The place of a point inside of the triangle.
fn dice_place(rows: DiceRows, number: u32) -> DicePlace {
    let row = dice_row_of_point(rows, number);
    return DicePlace(row, number - dice_points_before(rows, row) + 1u);
}"#,
    },
    Declaration {
        module: "shared/dice",
        name: "dice_steps_below",
        sampling: None,
        uses: &[],
        text: r#"// The number of the first `steps` steps between two rows that go along the lower row. A step goes
// to the point that is reached first halfway to it; ties go to the lower row. `above` and `below`
// are the parts of the two rows.
fn dice_steps_below(above: u32, below: u32, steps: u32) -> u32 {
    let least = select(0u, steps - above, steps > above);
    let most = min(below, steps);
    var j = clamp((2u * steps * below + above + below) / (2u * (above + below)), least, most);
    while (j > least && (2u * j - 1u) * above > (2u * (steps - j) + 1u) * below) {
        j = j - 1u;
    }
    while (j < most && (2u * j + 1u) * above <= (2u * (steps - j) - 1u) * below) {
        j = j + 1u;
    }
    return j;
}"#,
    },
    Declaration {
        module: "shared/dice",
        name: "dice_triangle",
        sampling: None,
        uses: &["DicePlace", "DiceRows", "DiceTriangle", "dice_row_of_triangle", "dice_row_parts", "dice_share", "dice_steps_below", "dice_triangles_before"],
        text: r#"// A triangle by its number.
fn dice_triangle(rows: DiceRows, number: u32) -> DiceTriangle {
    let row = dice_row_of_triangle(rows, number);
    let above = dice_row_parts(rows, row - 1u);
    let below = dice_row_parts(rows, row);
    let is_shared = row > 1u
        && dice_share(rows, row - 1u, rows.parts.x) == dice_share(rows, row, rows.parts.x);
    let step = number - dice_triangles_before(rows, row - 1u) + select(0u, 1u, is_shared);
    let j = dice_steps_below(above, below, step);
    let i = step - j;
    let goes_below = dice_steps_below(above, below, step + 1u) > j;
    let next = DicePlace(select(row - 1u, row, goes_below), select(i + 1u, j + 1u, goes_below));
    return DiceTriangle(DicePlace(row - 1u, i), DicePlace(row, j), next);
}"#,
    },
    Declaration {
        module: "shared/disc",
        name: "GOLDEN_TURN",
        sampling: None,
        uses: &[],
        text: r#"// The golden section of a turn: points at multiples of it lie evenly around a disc.
const GOLDEN_TURN = 0.618033989;"#,
    },
    Declaration {
        module: "shared/disc",
        name: "seed_of",
        sampling: None,
        uses: &["Hit", "UNITS", "mixed"],
        text: r#"// The seed of a hit's random numbers.
fn seed_of(hit: Hit) -> u32 {
    let place = vec2u((hit.uv - floor(hit.uv)) * UNITS);
    return mixed(place.x ^ mixed(place.y));
}"#,
    },
    Declaration {
        module: "shared/disc",
        name: "point_of_disc",
        sampling: None,
        uses: &["GOLDEN_TURN", "Toward", "mixed", "turned", "unit_of"],
        text: r#"// The light, seen as the point of its disc that is number `k` of `count`. The points lie at random
// in rings of equal area, each one golden section after the last, and are turned at random
// together.
fn point_of_disc(light: Toward, seed: u32, k: u32, count: u32) -> Toward {
    let ring = (f32(k) + unit_of(mixed(seed + k + 1u))) / f32(count);
    let place = turned(f32(k) * GOLDEN_TURN + unit_of(seed)) * (sqrt(ring) * light.radius);
    // Two unit vectors across the direction to the light's centre.
    let other = select(0.0, 1.0, abs(light.direction.x) > 0.6);
    let right = normalize(cross(vec3f(1.0 - other, other, 0.0), light.direction));
    let up = cross(light.direction, right);
    let toward = light.direction + right * place.x + up * place.y;
    let along = length(toward);
    return Toward(toward / along, light.falloff, light.distance * along, 0.0, light.number);
}"#,
    },
    Declaration {
        module: "shared/disc",
        name: "part_above",
        sampling: None,
        uses: &[],
        text: r#"// The part of a disc of radius 1 that is above a straight line, where the centre is `height` above
// the line. An odd polynomial stands for x sqrt(1 - x²) + asin(x), over pi; it is off by 5e-4 at
// most.
fn part_above(height: f32) -> f32 {
    let x = clamp(height, -1.0, 1.0);
    let s = x * x;
    return 0.5 + x * (0.64010741 + s * (-0.13985065 + s * (0.06702511 + s * -0.06728186)));
}"#,
    },
    Declaration {
        module: "shared/displacement",
        name: "LEAST_SCALE_M",
        sampling: None,
        uses: &[],
        text: r#"// A relief flatter than this, in metres, is traced as if it were this deep: its slope in t must stay finite.
const LEAST_SCALE_M = 1.0e-9;"#,
    },
    Declaration {
        module: "shared/displacement",
        name: "BESIDE_TILE",
        sampling: None,
        uses: &[],
        text: r#"// Tiles by which rounding may move a point at the edge of an unrepeated map beside it.
const BESIDE_TILE = 0.000001;"#,
    },
    Declaration {
        module: "shared/displacement",
        name: "is_on_map",
        sampling: None,
        uses: &["BESIDE_TILE", "WRAP_CLAMP", "surface_settings"],
        text: r#"// Whether the map is at a place.
fn is_on_map(uv: vec2f) -> bool {
    let beyond = max(abs(uv.x - 0.5), abs(uv.y - 0.5)) - 0.5;
    return surface_settings.wrap != WRAP_CLAMP || beyond <= BESIDE_TILE;
}"#,
    },
    Declaration {
        module: "shared/displacement",
        name: "traced_scale_m",
        sampling: None,
        uses: &["LEAST_SCALE_M", "surface_settings"],
        text: r#"// Metres between the heights 0 and 1, as paths are made with them.
fn traced_scale_m() -> f32 {
    return max(surface_settings.scale_m, LEAST_SCALE_M);
}"#,
    },
    Declaration {
        module: "shared/displacement",
        name: "base_height",
        sampling: None,
        uses: &["surface_settings", "traced_scale_m"],
        text: r#"// The height at which the base surface lies.
fn base_height() -> f32 {
    return (0.0 - surface_settings.bias_m) / traced_scale_m();
}"#,
    },
    Declaration {
        module: "shared/displacement",
        name: "climb",
        sampling: None,
        uses: &["Entered", "traced_scale_m"],
        text: r#"// Change of the texture coordinates, and of the normalised height, with a metre in a direction of the world.
fn climb(at: Entered, direction: vec3f) -> vec3f {
    let metric = at.metric;
    let td = dot(at.tangent, direction);
    let bd = dot(at.bitangent, direction);
    let area = metric.x * metric.z - metric.y * metric.y;
    let duv = vec2f(td * metric.z - bd * metric.y, bd * metric.x - td * metric.y) / area;
    return vec3f(duv, dot(at.normal, direction) / traced_scale_m());
}"#,
    },
    Declaration {
        module: "shared/displacement",
        name: "covector",
        sampling: None,
        uses: &["Entered", "surface_settings"],
        text: r#"// The direction in the world of a gradient along u, v and the height, times a positive number.
fn covector(at: Entered, gradient: vec3f) -> vec3f {
    let metric = at.metric;
    let area = metric.x * metric.z - metric.y * metric.y;
    let along_u = (at.tangent * metric.z - at.bitangent * metric.y) / area;
    let along_v = (at.bitangent * metric.x - at.tangent * metric.y) / area;
    let rise = at.normal * (gradient.z / surface_settings.scale_m);
    return along_u * gradient.x + along_v * gradient.y + rise;
}"#,
    },
    Declaration {
        module: "shared/displacement",
        name: "inside_unit",
        sampling: None,
        uses: &[],
        text: r#"// The parameter interval in which x(t) = x0 + dx t stays in [0, 1].
fn inside_unit(x0: f32, dx: f32, interval: vec2f) -> vec2f {
    if (dx == 0.0) {
        if (x0 < 0.0 || x0 > 1.0) {
            return vec2f(1.0, -1.0);
        }
        return interval;
    }
    let a = (0.0 - x0) / dx;
    let b = (1.0 - x0) / dx;
    return vec2f(max(interval.x, min(a, b)), min(interval.y, max(a, b)));
}"#,
    },
    Declaration {
        module: "shared/displacement",
        name: "placed_over",
        sampling: None,
        uses: &["Entered", "Hit", "field_height_stage", "surface_settings"],
        text: r#"// The frame of the relief at a hit, over a point beside the one at which the ray is on the base.
fn placed_over(at: Entered, hit: Hit) -> Entered {
    let uv = hit.uv;
    let aside = uv - at.uv;
    let level = field_height_stage(uv, hit.height, at.level);
    let height = surface_settings.bias_m + surface_settings.scale_m * level;
    var placed = at;
    placed.point = at.point + at.tangent * aside.x + at.bitangent * aside.y + at.normal * height;
    placed.uv = uv;
    return placed;
}"#,
    },
    Declaration {
        module: "shared/environment",
        name: "COSINES",
        sampling: None,
        uses: &[],
        text: r#"// 1 radian over the deviation of the last level's lobes, which are cosines.
const COSINES = 1.2247449;"#,
    },
    Declaration {
        module: "shared/environment",
        name: "FacePlace",
        sampling: None,
        uses: &[],
        text: r#"// A place on a face of the cube, from -1 to 1 from edge to edge.
struct FacePlace {
    face: i32,
    place: vec2f,
}"#,
    },
    Declaration {
        module: "shared/environment",
        name: "face_place",
        sampling: None,
        uses: &["FacePlace"],
        text: r#"// The point at which a direction of any length meets the cube. Faces and their axes are as in the
// cube maps of GPUs.
fn face_place(d: vec3f) -> FacePlace {
    let size = abs(d);
    if (size.x >= size.y && size.x >= size.z) {
        if (d.x > 0.0) {
            return FacePlace(0, vec2f(-d.z, -d.y) / size.x);
        }
        return FacePlace(1, vec2f(d.z, -d.y) / size.x);
    }
    if (size.y >= size.z) {
        if (d.y > 0.0) {
            return FacePlace(2, vec2f(d.x, d.z) / size.y);
        }
        return FacePlace(3, vec2f(d.x, -d.z) / size.y);
    }
    if (d.z > 0.0) {
        return FacePlace(4, vec2f(d.x, -d.y) / size.z);
    }
    return FacePlace(5, vec2f(-d.x, -d.y) / size.z);
}"#,
    },
    Declaration {
        module: "shared/environment",
        name: "environment_of_level",
        sampling: None,
        uses: &["bilinear", "environment_texel", "face_place", "surface_settings"],
        text: r#"// The light of a level that comes from a direction.
fn environment_of_level(direction: vec3f, level: u32) -> vec3f {
    let at = face_place(direction);
    let last = max(i32(surface_settings.environment_side >> level), 1) - 1;
    let point = (at.place + vec2f(1.0, 1.0)) * (0.5 * f32(last));
    let most = f32(max(last - 1, 0));
    let corner = clamp(floor(point), vec2f(0.0, 0.0), vec2f(most, most));
    let texel = vec2i(corner);
    let k = i32(level);
    return bilinear(
        environment_texel(texel, at.face, k),
        environment_texel(texel + vec2i(1, 0), at.face, k),
        environment_texel(texel + vec2i(0, 1), at.face, k),
        environment_texel(texel + vec2i(1, 1), at.face, k),
        point - corner,
    ).xyz;
}"#,
    },
    Declaration {
        module: "shared/environment",
        name: "environment_in_lobe",
        sampling: None,
        uses: &["COSINES", "environment_of_level", "levels_of", "surface_settings"],
        text: r#"// The light within a lobe around a direction. `deviation` is the lobe's, in radians.
fn environment_in_lobe(direction: vec3f, deviation: f32) -> vec3f {
    let width = deviation * (COSINES * f32(1u << (surface_settings.environment_levels - 1u)));
    let levels = levels_of(width, surface_settings.environment_levels);
    let fine = environment_of_level(direction, levels.fine);
    if (levels.part > 0.0) {
        return fine + (environment_of_level(direction, levels.fine + 1u) - fine) * levels.part;
    }
    return fine;
}"#,
    },
    Declaration {
        module: "shared/environment",
        name: "environment_on",
        sampling: None,
        uses: &["environment_of_level", "surface_settings"],
        text: r#"// The light that falls on a surface with that normal from all around: the light that a white
// surface reflects.
fn environment_on(normal: vec3f) -> vec3f {
    return environment_of_level(normal, surface_settings.environment_levels - 1u);
}"#,
    },
    Declaration {
        module: "shared/facets",
        name: "WIDTH",
        sampling: None,
        uses: &[],
        text: r#"// The share of the lobe's width in the denominator.
const WIDTH = 0.65;"#,
    },
    Declaration {
        module: "shared/facets",
        name: "facet_reflection",
        sampling: None,
        uses: &["WIDTH"],
        text: r#"// For a view with that cosine, above 0, and the square root of alpha as roughness: x, the part that
// facets reflect if they reflect all light, and y, the part of it for facets that reflect no light
// along the normal. All others lie between both.
fn facet_reflection(cosine: f32, alpha: f32, roughness: f32) -> vec2f {
    let x = cosine / (cosine + WIDTH * alpha);
    let a6 = 0.1878 + alpha * (-0.9742 + alpha * (1.3709 + alpha * -0.6017));
    let a0 = 1.0034 + alpha * (0.0071 + alpha * a6);
    let a1 = -0.4137 + alpha * (-0.4144 + alpha * (-0.877 + alpha * (-1.6058 + alpha * 0.9124)));
    let a2 = 2.5855 + alpha * (0.3239 + alpha * (2.4708 + alpha * 0.7166));
    let a3 = -8.9277 + alpha * (-0.5518 + alpha * -3.0114);
    let a4 = 11.8249 + alpha * 0.937;
    let all = a0 + x * (a1 + x * (a2 + x * (a3 + x * (a4 + x * -5.0796))));
    let b5 = 3.4396 + roughness * (-0.7093 + roughness * -0.4004);
    let b0 = 1.1487 + roughness * (-3.4586 + roughness * b5);
    let b1 = -0.6771 + roughness * (5.7828 + roughness * (-8.8951 + roughness * 4.2115));
    let b2 = 0.558 + roughness * (-7.0899 + roughness * 4.2721);
    let b3 = 0.1714 + roughness * 5.0718;
    let rest = b0 + x * (b1 + x * (b2 + x * (b3 + x * -0.1958)));
    let slant = 1.0 - min(cosine, 1.0);
    let squared = slant * slant;
    let grazing = squared * squared * slant * rest;
    return vec2f(all, grazing);
}"#,
    },
    Declaration {
        module: "shared/factors",
        name: "MOST_SCALE",
        sampling: None,
        uses: &[],
        text: r#"// Greatest scale of a term.
const MOST_SCALE = 512.0;"#,
    },
    Declaration {
        module: "shared/factors",
        name: "NO_HIT_SUM",
        sampling: None,
        uses: &[],
        text: r#"// Sums from here on say that nothing is hit.
const NO_HIT_SUM = 1.125;"#,
    },
    Declaration {
        module: "shared/factors",
        name: "LAST_WAY",
        sampling: None,
        uses: &[],
        text: r#"// The last way that a map has for a hit, as a part of the whole way.
const LAST_WAY = 0.99607843;"#,
    },
    Declaration {
        module: "shared/factors",
        name: "factor_place",
        sampling: None,
        uses: &[],
        text: r#"// The texel with that number below the factors of the texels, of a map of n columns and rows of these.
fn factor_place(number: i32, n: vec2i) -> vec2i {
    let row = i32((f32(number) + 0.5) / f32(n.x));
    return vec2i(number - row * n.x, n.y + row);
}"#,
    },
    Declaration {
        module: "shared/factors",
        name: "term_scales",
        sampling: None,
        uses: &["MOST_SCALE", "Path", "factor_place", "search_texel"],
        text: r#"// The scales of a layer's terms, from the texel with that number and the next.
fn term_scales(path: Path, number: i32, n: vec2i, layer: i32) -> vec4f {
    let level = i32(path.level);
    let high = search_texel(path, factor_place(number, n), layer, level);
    let low = search_texel(path, factor_place(number + 1, n), layer, level);
    let root = high + low * 0.003921569;
    return root * root * MOST_SCALE;
}"#,
    },
    Declaration {
        module: "shared/factors",
        name: "FourTerms",
        sampling: None,
        uses: &[],
        text: r#"// Factors of four terms, each for four texels.
struct FourTerms {
    first: vec4f,
    second: vec4f,
    third: vec4f,
    fourth: vec4f,
}"#,
    },
    Declaration {
        module: "shared/factors",
        name: "four_terms",
        sampling: None,
        uses: &["FourTerms"],
        text: r#"// The factors of four texels, term by term.
fn four_terms(t00: vec4f, t10: vec4f, t01: vec4f, t11: vec4f) -> FourTerms {
    return FourTerms(
        vec4f(t00.x, t10.x, t01.x, t11.x),
        vec4f(t00.y, t10.y, t01.y, t11.y),
        vec4f(t00.z, t10.z, t01.z, t11.z),
        vec4f(t00.w, t10.w, t01.w, t11.w),
    );
}"#,
    },
    Declaration {
        module: "shared/factors",
        name: "with_terms",
        sampling: None,
        uses: &["FourTerms"],
        text: r#"// Sums of four texels with four terms more. They are added one by one: compilers may change the order of
// other sums.
fn with_terms(before: vec4f, texels: FourTerms, view: vec4f) -> vec4f {
    let one = before + texels.first * view.x;
    let two = one + texels.second * view.y;
    let three = two + texels.third * view.z;
    return three + texels.fourth * view.w;
}"#,
    },
    Declaration {
        module: "shared/factors",
        name: "joined_texels",
        sampling: None,
        uses: &["bilinear", "flagged_ways"],
        text: r#"// Ways of the four texels around, at the lower and the upper elevation: joined between the texels, each with
// the weight of the texels that are hits.
fn joined_texels(lower: vec4f, upper: vec4f, part: vec2f) -> vec4f {
    return bilinear(
        flagged_ways(lower.x, upper.x),
        flagged_ways(lower.y, upper.y),
        flagged_ways(lower.z, upper.z),
        flagged_ways(lower.w, upper.w),
        part,
    );
}"#,
    },
    Declaration {
        module: "shared/factors",
        name: "flagged_ways",
        sampling: None,
        uses: &["LAST_WAY", "NO_HIT_SUM"],
        text: r#"// Two sums as ways with their weights: 1 for a hit, and 0 for none.
fn flagged_ways(lower: f32, upper: f32) -> vec4f {
    let is_lower = lower < NO_HIT_SUM;
    let is_upper = upper < NO_HIT_SUM;
    return vec4f(
        select(0.0, clamp(lower, 0.0, LAST_WAY), is_lower),
        select(0.0, 1.0, is_lower),
        select(0.0, clamp(upper, 0.0, LAST_WAY), is_upper),
        select(0.0, 1.0, is_upper),
    );
}"#,
    },
    Declaration {
        module: "shared/folded",
        name: "MOST_PIECES",
        sampling: None,
        uses: &[],
        text: r#"// The most pieces of the offsets: three quadratics have six roots.
const MOST_PIECES = 7u;"#,
    },
    Declaration {
        module: "shared/folded",
        name: "MOST_FOLDED_CHORDS",
        sampling: None,
        uses: &[],
        text: r#"// The most chords of a piece, and the number of chords of a piece that turns back along the ray.
const MOST_FOLDED_CHORDS = 16.0;"#,
    },
    Declaration {
        module: "shared/folded",
        name: "TURN_STEPS",
        sampling: None,
        uses: &[],
        text: r#"// Halvings of the chord in which a way turns back.
const TURN_STEPS = 12u;"#,
    },
    Declaration {
        module: "shared/folded",
        name: "BEYOND_OFFSETS",
        sampling: None,
        uses: &[],
        text: r#"// The part of all heights that is added to the offsets below the least height and above the
// greatest. Rays that end at a floor must cross it.
const BEYOND_OFFSETS = 0.000001;"#,
    },
    Declaration {
        module: "shared/folded",
        name: "LEAST_AREA",
        sampling: None,
        uses: &[],
        text: r#"// A triangle with a smaller area, in square metres, is never hit.
const LEAST_AREA = 1.0e-30;"#,
    },
    Declaration {
        module: "shared/folded",
        name: "Way",
        sampling: None,
        uses: &[],
        text: r#"// The line through the shell: coefficients, by powers of the offset, of the weights over their sum.
struct Way {
    first: vec3f,
    second: vec3f,
    third: vec3f,
    // 1, or -1 where the order of the corners turns the triangle over.
    turn: f32,
}"#,
    },
    Declaration {
        module: "shared/folded",
        name: "WayPoint",
        sampling: None,
        uses: &["ShellPoint"],
        text: r#"// A point of the way.
struct WayPoint {
    point: ShellPoint,
    // Metres along the ray from its nearest place to the triangle, and metres beside the ray.
    t: f32,
    beside: f32,
    // Positive where the shell is not turned inside out.
    volume: f32,
}"#,
    },
    Declaration {
        module: "shared/folded",
        name: "WayChord",
        sampling: None,
        uses: &[],
        text: r#"// A chord of the way: the offsets of its ends, and the number of chords in all.
struct WayChord {
    offsets: vec2f,
    count: u32,
}"#,
    },
    Declaration {
        module: "shared/folded",
        name: "way_weight",
        sampling: None,
        uses: &["NEVER"],
        text: r#"// The coefficients of d·(q_i × q_j). Here and below there are limits that are never reached:
// compilers would take common factors out of sums, which gives other bits.
fn way_weight(along: vec3f, p: vec3f, n: vec3f, q: vec3f, m: vec3f) -> vec3f {
    let most = vec3f(NEVER, NEVER, NEVER);
    let middle = min(cross(p, m), most) + min(cross(n, q), most);
    return min(vec3f(dot(along, cross(p, q)), dot(along, middle), dot(along, cross(n, m))), most);
}"#,
    },
    Declaration {
        module: "shared/folded",
        name: "way_of",
        sampling: None,
        uses: &["PixelIn", "Prism", "Way", "way_weight"],
        text: r#"fn way_of(pixel: PixelIn, prism: Prism, along: vec3f) -> Way {
    let first = pixel.shell.order & 3u;
    let second = (pixel.shell.order >> 2u) & 3u;
    let is_turned = (second + 3u - first) % 3u != 1u;
    return Way(
        way_weight(along, prism.p1, prism.n1, prism.p2, prism.n2),
        way_weight(along, prism.p2, prism.n2, prism.p0, prism.n0),
        way_weight(along, prism.p0, prism.n0, prism.p1, prism.n1),
        select(pixel.side, 0.0 - pixel.side, is_turned),
    );
}"#,
    },
    Declaration {
        module: "shared/folded",
        name: "grown_way",
        sampling: None,
        uses: &["Way"],
        text: r#"// The way through a triangle that is larger by these weights.
fn grown_way(way: Way, beyond: vec3f) -> Way {
    let sum = way.first + way.second + way.third;
    return Way(
        way.first + sum * beyond.x,
        way.second + sum * beyond.y,
        way.third + sum * beyond.z,
        way.turn,
    );
}"#,
    },
    Declaration {
        module: "shared/folded",
        name: "way_point",
        sampling: None,
        uses: &["NEVER", "Prism", "ShellPoint", "Way", "WayPoint", "lift_of", "quadratic", "surface_settings"],
        text: r#"// The way at an offset.
fn way_point(prism: Prism, along: vec3f, way: Way, offset: f32) -> WayPoint {
    let low = surface_settings.shell_m.x;
    let width = min(surface_settings.shell_m.y - low, NEVER);
    let parts = vec3f(
        quadratic(way.first, offset),
        quadratic(way.second, offset),
        quadratic(way.third, offset),
    );
    let limited = min(parts, vec3f(NEVER, NEVER, NEVER));
    let w = limited / (limited.x + limited.y + limited.z);
    let normal = prism.n0 * w.x + prism.n1 * w.y + prism.n2 * w.z;
    let place = prism.p0 * w.x + prism.p1 * w.y + prism.p2 * w.z + normal * offset;
    let t = min(dot(place, along), NEVER);
    let second = (prism.p1 - prism.p0) + (prism.n1 - prism.n0) * offset;
    let third = (prism.p2 - prism.p0) + (prism.n2 - prism.n0) * offset;
    let volume = dot(cross(second, third), normal) * way.turn;
    let height = min((offset - low - lift_of(prism.lift, w)) / width, NEVER);
    return WayPoint(ShellPoint(w, height), t, length(place - along * t), volume);
}"#,
    },
    Declaration {
        module: "shared/folded",
        name: "both_roots",
        sampling: None,
        uses: &["NEVER"],
        text: r#"// The roots of a quadratic, in no order; NEVER in place of missing ones.
fn both_roots(c: vec3f) -> vec2f {
    var roots = vec2f(NEVER, NEVER);
    let discriminant = c.y * c.y - 4.0 * c.z * c.x;
    if (discriminant >= 0.0) {
        let root = sqrt(discriminant);
        let q = -0.5 * (c.y + select(0.0 - root, root, c.y >= 0.0));
        if (c.z != 0.0) {
            roots.x = q / c.z;
        }
        if (q != 0.0) {
            roots.y = c.x / q;
        }
    }
    return roots;
}"#,
    },
    Declaration {
        module: "shared/folded",
        name: "root_behind",
        sampling: None,
        uses: &["both_roots"],
        text: r#"// The first root of a quadratic behind a place, or `end`.
fn root_behind(c: vec3f, place: f32, end: f32) -> f32 {
    let roots = both_roots(c);
    var first = end;
    if (roots.x > place) {
        first = min(first, roots.x);
    }
    if (roots.y > place) {
        first = min(first, roots.y);
    }
    return first;
}"#,
    },
    Declaration {
        module: "shared/folded",
        name: "is_inside",
        sampling: None,
        uses: &["Way", "quadratic"],
        text: r#"// Whether a line is inside the triangle at an offset: all weights have the sign of their sum.
fn is_inside(way: Way, offset: f32) -> bool {
    let a = quadratic(way.first, offset);
    let b = quadratic(way.second, offset);
    let c = quadratic(way.third, offset);
    return min(min(a, b), c) > 0.0 || max(max(a, b), c) < 0.0;
}"#,
    },
    Declaration {
        module: "shared/folded",
        name: "way_bend",
        sampling: None,
        uses: &[],
        text: r#"// The deviation of heights from a chord, at a point between its ends. `part` is the part of the
// chord before the point.
fn way_bend(a: f32, m: f32, b: f32, part: f32) -> f32 {
    if (part > 0.125 && part < 0.875) {
        return (m - a - (b - a) * part) / (part * (part - 1.0));
    }
    return 0.0;
}"#,
    },
    Declaration {
        module: "shared/folded",
        name: "beside_way",
        sampling: None,
        uses: &["HEIGHTS_A_TEXEL", "NEVER", "PixelIn", "WayPoint", "height_size", "uv_of"],
        text: r#"// The distance of a point of the way from the chord, in units of the tolerance's texels.
fn beside_way(pixel: PixelIn, a: WayPoint, b: WayPoint, bend: f32, at: WayPoint) -> f32 {
    let part = (at.t - a.t) / (b.t - a.t);
    let line = a.point.weights + min(b.point.weights - a.point.weights, vec3f(NEVER, NEVER, NEVER)) * part;
    let apart = abs(uv_of(pixel, at.point.weights - line) * height_size(0u));
    let slope = b.point.height - a.point.height - bend;
    let height = a.point.height + part * (slope + part * bend);
    return max(max(apart.x, apart.y), abs(at.point.height - height) / HEIGHTS_A_TEXEL);
}"#,
    },
    Declaration {
        module: "shared/folded",
        name: "chords_of_piece",
        sampling: None,
        uses: &["MOST_FOLDED_CHORDS", "NEVER", "PixelIn", "Prism", "Way", "beside_way", "way_bend", "way_point"],
        text: r#"// The number of chords that a piece of the way takes.
fn chords_of_piece(
    pixel: PixelIn,
    prism: Prism,
    along: vec3f,
    way: Way,
    piece: vec2f,
    tolerance: f32,
) -> u32 {
    let long = min(piece.y - piece.x, NEVER);
    let a = way_point(prism, along, way, piece.x);
    let before = way_point(prism, along, way, piece.x + 0.25 * long);
    let m = way_point(prism, along, way, piece.x + 0.5 * long);
    let after = way_point(prism, along, way, piece.x + 0.75 * long);
    let b = way_point(prism, along, way, piece.y);
    let rises = a.t < before.t && before.t < m.t && m.t < after.t && after.t < b.t;
    let falls = a.t > before.t && before.t > m.t && m.t > after.t && after.t > b.t;
    if (!rises && !falls) {
        return u32(MOST_FOLDED_CHORDS);
    }
    let bend = way_bend(a.point.height, m.point.height, b.point.height, (m.t - a.t) / (b.t - a.t));
    let quarters = max(beside_way(pixel, a, b, bend, before), beside_way(pixel, a, b, bend, after));
    let most = max(beside_way(pixel, a, b, bend, m), quarters);
    // With half the chords the way is four times as far beside them.
    return u32(clamp(ceil(sqrt(most / tolerance)), 1.0, MOST_FOLDED_CHORDS));
}"#,
    },
    Declaration {
        module: "shared/folded",
        name: "way_offsets",
        sampling: None,
        uses: &["BEYOND_OFFSETS", "PixelIn", "Prism", "offsets_of", "surface_settings"],
        text: r#"// The offsets between which the relief of a shell lies, and a little beyond.
fn way_offsets(pixel: PixelIn, prism: Prism, slack: f32) -> vec2f {
    var shell = pixel.shell;
    shell.lift = prism.lift;
    let more = slack + BEYOND_OFFSETS * (surface_settings.shell_m.y - surface_settings.shell_m.x);
    return offsets_of(shell) + vec2f(0.0 - more, more);
}"#,
    },
    Declaration {
        module: "shared/folded",
        name: "sides_over_area",
        sampling: None,
        uses: &["LEAST_AREA", "Prism"],
        text: r#"// Lengths of the sides of the triangle at an offset over twice its area, opposite to the corners.
fn sides_over_area(prism: Prism, offset: f32) -> vec3f {
    let a = prism.p2 - prism.p1 + (prism.n2 - prism.n1) * offset;
    let b = prism.p0 - prism.p2 + (prism.n0 - prism.n2) * offset;
    let c = prism.p1 - prism.p0 + (prism.n1 - prism.n0) * offset;
    return vec3f(length(a), length(b), length(c)) / max(length(cross(b, c)), LEAST_AREA);
}"#,
    },
    Declaration {
        module: "shared/folded",
        name: "way_beyond",
        sampling: None,
        uses: &["Prism", "sides_over_area"],
        text: r#"// The weights by which a shell is larger where it reaches `metres` beyond its sides at its widest.
fn way_beyond(prism: Prism, offsets: vec2f, metres: f32) -> vec3f {
    return min(sides_over_area(prism, offsets.x), sides_over_area(prism, offsets.y)) * metres;
}"#,
    },
    Declaration {
        module: "shared/folded",
        name: "way_chord",
        sampling: None,
        uses: &["MOST_PIECES", "NEVER", "PixelIn", "Prism", "Way", "WayChord", "chords_of_piece", "grown_way", "is_inside", "root_behind"],
        text: r#"// A chord by its number, of a way through a shell that is larger by `beyond`, among the chords
// between `offsets`.
fn way_chord(
    pixel: PixelIn,
    prism: Prism,
    along: vec3f,
    way: Way,
    offsets: vec2f,
    beyond: vec3f,
    tolerance: f32,
    number: u32,
) -> WayChord {
    let grown = grown_way(way, beyond);
    var chosen = vec2f(0.0, 0.0);
    var count = 0u;
    var begin = offsets.x;
    var pieces = 0u;
    while (pieces < MOST_PIECES && begin < offsets.y) {
        pieces = pieces + 1u;
        let first = root_behind(grown.first, begin, offsets.y);
        let second = root_behind(grown.second, begin, offsets.y);
        let end = min(min(first, second), root_behind(grown.third, begin, offsets.y));
        if (is_inside(grown, 0.5 * (begin + end))) {
            let chords = chords_of_piece(pixel, prism, along, way, vec2f(begin, end), tolerance);
            if (number >= count && number < count + chords) {
                let long = min(end - begin, NEVER);
                let part = f32(number - count) / f32(chords);
                let next = f32(number - count + 1u) / f32(chords);
                chosen = vec2f(begin + long * part, begin + long * next);
            }
            count = count + chords;
        }
        begin = end;
    }
    return WayChord(chosen, count);
}"#,
    },
    Declaration {
        module: "shared/folded",
        name: "before_turn",
        sampling: None,
        uses: &["Prism", "TURN_STEPS", "Way", "way_point"],
        text: r#"// The part of a chord that is not turned inside out, if the way turns back in it; otherwise the
// whole chord.
fn before_turn(prism: Prism, along: vec3f, way: Way, chord: vec2f) -> vec2f {
    let is_first = way_point(prism, along, way, chord.x).volume > 0.0;
    let is_last = way_point(prism, along, way, chord.y).volume > 0.0;
    if (is_first == is_last) {
        return chord;
    }
    var inner = select(chord.y, chord.x, is_first);
    var outer = select(chord.x, chord.y, is_first);
    var step = 0u;
    while (step < TURN_STEPS) {
        step = step + 1u;
        let between = 0.5 * (inner + outer);
        if (way_point(prism, along, way, between).volume > 0.0) {
            inner = between;
        } else {
            outer = between;
        }
    }
    if (is_first) {
        return vec2f(chord.x, inner);
    }
    return vec2f(inner, chord.y);
}"#,
    },
    Declaration {
        module: "shared/footprint",
        name: "footprint_axis",
        sampling: None,
        uses: &["Entered", "PixelIn", "climb", "surface_settings"],
        text: r#"// The movement of the base point, in texels, when the ray's origin and direction change by these.
fn footprint_axis(
    pixel: PixelIn,
    at: Entered,
    normal: vec3f,
    t: f32,
    origin: vec3f,
    direction: vec3f,
) -> vec2f {
    let aside = origin + direction * t;
    let along = dot(normal, aside) / dot(normal, pixel.direction);
    return climb(at, aside - pixel.direction * along).xy * vec2f(surface_settings.height_size);
}"#,
    },
    Declaration {
        module: "shared/footprint",
        name: "footprint_of",
        sampling: None,
        uses: &["Entered", "PixelIn", "footprint_axis", "frame", "plane_distance"],
        text: r#"// Width of the footprint on the base surface, in texels of the height map's finest level. The
// footprint is an ellipse. Its shorter axis decides, as in anisotropic filtering; the longer one
// may be `anisotropy` times as long.
fn footprint_of(pixel: PixelIn, at: Entered, anisotropy: f32) -> f32 {
    let normal = at.facing;
    let t = plane_distance(pixel, normal);
    let right = footprint_axis(pixel, at, normal, t, frame.eye_right.xyz, frame.right.xyz);
    let down = footprint_axis(pixel, at, normal, t, frame.eye_down.xyz, frame.down.xyz);
    // One product of four. Compilers would turn two sums that are added into another sum, which
    // gives other bits.
    let both = vec4f(right, down);
    let sum = dot(both, both);
    let area = right.x * down.y - right.y * down.x;
    // The sum of the ellipse's squared axes is known, and their product: the area squared.
    let apart = sqrt(max((sum - 2.0 * area) * (sum + 2.0 * area), 0.0));
    let longer = 0.5 * (sum + apart);
    let shorter = area * area / longer;
    let squared = max(shorter, longer / (anisotropy * anisotropy));
    return sqrt(squared) * frame.sample_width;
}"#,
    },
    Declaration {
        module: "shared/footprint",
        name: "depth_in_samples",
        sampling: None,
        uses: &["Entered", "PixelIn", "frame", "plane_distance", "surface_settings"],
        text: r#"// The depth of the relief in widths of a pixel's sample, seen from the distance of the base point.
fn depth_in_samples(pixel: PixelIn, at: Entered) -> f32 {
    let t = plane_distance(pixel, at.facing);
    let width = length(frame.eye_right.xyz + frame.right.xyz * t) * frame.sample_width;
    return surface_settings.scale_m / width;
}"#,
    },
    Declaration {
        module: "shared/footprint",
        name: "depth_in_footprints",
        sampling: None,
        uses: &["Entered", "NEVER", "surface_settings"],
        text: r#"// The depth of the relief in widths of a footprint, which is given in texels. The relief of a footprint of
// no width is as deep as any.
fn depth_in_footprints(at: Entered, footprint: f32) -> f32 {
    let metric = at.metric;
    let tile = sqrt(max(metric.x * metric.z - metric.y * metric.y, 0.0));
    let size = vec2f(surface_settings.height_size);
    let width = footprint * sqrt(tile / (size.x * size.y));
    if (width > 0.0) {
        return surface_settings.scale_m / width;
    }
    return NEVER;
}"#,
    },
    Declaration {
        module: "shared/frames",
        name: "FRAMES",
        sampling: None,
        uses: &[],
        text: r#"// Number of frames around a direction.
const FRAMES = 3u;"#,
    },
    Declaration {
        module: "shared/frames",
        name: "Frames",
        sampling: None,
        uses: &[],
        text: r#"// The numbers of the frames, and the weight of each: barycentric coordinates of the direction
// between them.
struct Frames {
    numbers: vec3u,
    weights: vec3f,
}"#,
    },
    Declaration {
        module: "shared/frames",
        name: "frames_around",
        sampling: None,
        uses: &["Frames", "LEAST_SUM", "object_texel", "surface_settings"],
        text: r#"// The frames around a direction. The grid's data is in the row of the map of images after the last
// image: the mapping's axes in the world, then the number of frames along a side, and 1 if only the
// upper half is mapped.
fn frames_around(toward: vec3f) -> Frames {
    let row = i32(surface_settings.images);
    let axis_x = object_texel(vec2i(0, row));
    let axis_y = object_texel(vec2i(1, row));
    let axis_z = object_texel(vec2i(2, row));
    let last = max(axis_x.w - 1.0, 1.0);
    let is_hemi = axis_y.w > 0.0;
    let up = dot(axis_y.xyz, toward);
    let y = select(up, max(up, 0.0), is_hemi);
    let right = dot(axis_x.xyz, toward);
    let front = dot(axis_z.xyz, toward);
    let sum = max(abs(right) + abs(y) + abs(front), LEAST_SUM);
    var x = right / sum;
    var z = front / sum;
    if (y < 0.0) {
        // The lower half is folded outward over the diagonals.
        let folded_x = (1.0 - abs(z)) * select(-1.0, 1.0, x >= 0.0);
        let folded_z = (1.0 - abs(x)) * select(-1.0, 1.0, z >= 0.0);
        x = folded_x;
        z = folded_z;
    }
    let across = select(x + 1.0, x + z + 1.0, is_hemi) * (0.5 * last);
    let along = select(z + 1.0, z - x + 1.0, is_hemi) * (0.5 * last);
    let place = clamp(vec2f(across, along), vec2f(0.0, 0.0), vec2f(last, last));
    let cell = min(floor(place), vec2f(last - 1.0, last - 1.0));
    let part = place - cell;
    let side = u32(last) + 1u;
    let first = u32(cell.y) * side + u32(cell.x);
    let beside = select(first + side, first + 1u, part.x > part.y);
    let least = min(part.x, part.y);
    let most = max(part.x, part.y);
    return Frames(vec3u(first, beside, first + side + 1u), vec3f(1.0 - most, most - least, least));
}"#,
    },
    Declaration {
        module: "shared/frames",
        name: "LEAST_SUM",
        sampling: None,
        uses: &[],
        text: r#"// The least sum of parts of a unit direction. Only a direction straight from below has less, where
// the lower half is not mapped.
const LEAST_SUM = 0.000001;"#,
    },
    Declaration {
        module: "shared/frames",
        name: "frame_number",
        sampling: None,
        uses: &["Frames"],
        text: r#"fn frame_number(frames: Frames, k: u32) -> u32 {
    return select(select(frames.numbers.z, frames.numbers.y, k == 1u), frames.numbers.x, k == 0u);
}"#,
    },
    Declaration {
        module: "shared/frames",
        name: "frame_weight",
        sampling: None,
        uses: &["Frames"],
        text: r#"fn frame_weight(frames: Frames, k: u32) -> f32 {
    return select(select(frames.weights.z, frames.weights.y, k == 1u), frames.weights.x, k == 0u);
}"#,
    },
    Declaration {
        module: "shared/frames",
        name: "color_of_frames",
        sampling: None,
        uses: &["Entered", "FRAMES", "color_at", "frame_number", "frame_weight", "frames_around", "image_of_object", "place_in_image"],
        text: r#"// The weighted colour of the frames at a point.
fn color_of_frames(at: Entered, view: vec3f) -> vec3f {
    let frames = frames_around(view);
    var sum = vec3f(0.0, 0.0, 0.0);
    var k = 0u;
    while (k < FRAMES) {
        let image = image_of_object(frame_number(frames, k));
        sum = sum + color_at(place_in_image(image, at.point).xy, 0u).xyz * frame_weight(frames, k);
        k = k + 1u;
    }
    return sum;
}"#,
    },
    Declaration {
        module: "shared/frames",
        name: "normal_of_frames",
        sampling: None,
        uses: &["Entered", "FRAMES", "Frames", "bitangent_of_image", "finest_normal", "frame_number", "frame_weight", "image_of_object", "place_in_image", "tangent_of_image"],
        text: r#"// The weighted normal of the frames at a point.
fn normal_of_frames(at: Entered, frames: Frames) -> vec3f {
    var sum = vec3f(0.0, 0.0, 0.0);
    var k = 0u;
    while (k < FRAMES) {
        let image = image_of_object(frame_number(frames, k));
        var seen = at;
        seen.tangent = tangent_of_image(image);
        seen.bitangent = bitangent_of_image(image);
        seen.normal = image.toward;
        let uv = place_in_image(image, at.point).xy;
        sum = sum + finest_normal(seen, uv) * frame_weight(frames, k);
        k = k + 1u;
    }
    let square = dot(sum, sum);
    if (square > 0.0) {
        return sum / sqrt(square);
    }
    return at.normal;
}"#,
    },
    Declaration {
        module: "shared/fresnel",
        name: "LEAST",
        sampling: None,
        uses: &[],
        text: r#"// The least divisor, against division by 0.
const LEAST = 0.000001;"#,
    },
    Declaration {
        module: "shared/fresnel",
        name: "cosine_inside",
        sampling: None,
        uses: &["surface_settings"],
        text: r#"// The cosine between the normal and a ray that was refracted into the material. `cosine` is the one
// outside.
fn cosine_inside(cosine: f32) -> f32 {
    let eta = 1.0 / surface_settings.ior;
    return sqrt(max(1.0 - eta * eta * (1.0 - cosine * cosine), 0.0));
}"#,
    },
    Declaration {
        module: "shared/fresnel",
        name: "fresnel",
        sampling: None,
        uses: &["LEAST", "cosine_inside", "surface_settings"],
        text: r#"// The reflected part of light that is not polarised.
fn fresnel(cosine: f32) -> f32 {
    let ior = surface_settings.ior;
    let inside = cosine_inside(cosine);
    let across = (cosine - ior * inside) / max(cosine + ior * inside, LEAST);
    let along = (ior * cosine - inside) / max(ior * cosine + inside, LEAST);
    let waves = vec2f(across, along);
    return 0.5 * dot(waves, waves);
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "CELL_LIMIT",
        sampling: None,
        uses: &[],
        text: r#"// Farther out than this a cell number would not fit an integer; larger values only matter for paths that are
// already meaningless in f32.
const CELL_LIMIT = 1073741824.0;"#,
    },
    Declaration {
        module: "shared/height",
        name: "continued_index",
        sampling: None,
        uses: &["WRAP_CLAMP", "WRAP_REPEAT", "unfolded"],
        text: r#"// The texel that stands for index i in a row of n that this wrap continues. Shaders hold this text and the
// next many times over, and a division is long: there is one in each.
fn continued_index(i: i32, n: i32, wrap: u32) -> i32 {
    if (wrap == WRAP_CLAMP) {
        return clamp(i, 0, n - 1);
    }
    if (i >= 0 && i < n) {
        return i;
    }
    let period = select(2 * n, n, wrap == WRAP_REPEAT);
    let rest = i % period;
    return unfolded(select(rest, rest + period, rest < 0), n, period);
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "continued_pair",
        sampling: None,
        uses: &["WRAP_CLAMP", "WRAP_REPEAT", "unfolded"],
        text: r#"// The texels that stand for index i and for the next one.
fn continued_pair(i: i32, n: i32, wrap: u32) -> vec2i {
    if (wrap == WRAP_CLAMP) {
        return vec2i(clamp(i, 0, n - 1), clamp(i + 1, 0, n - 1));
    }
    if (i >= 0 && i + 1 < n) {
        return vec2i(i, i + 1);
    }
    let period = select(2 * n, n, wrap == WRAP_REPEAT);
    let rest = i % period;
    let first = select(rest, rest + period, rest < 0);
    let second = select(first + 1, 0, first + 1 == period);
    return vec2i(unfolded(first, n, period), unfolded(second, n, period));
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "unfolded",
        sampling: None,
        uses: &[],
        text: r#"// The texel at a place of a row's period, whose second half goes back.
fn unfolded(i: i32, n: i32, period: i32) -> i32 {
    return select(period - 1 - i, i, i < n);
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "wrap_index",
        sampling: None,
        uses: &["continued_index", "surface_settings"],
        text: r#"// The texel of the height map, or of a map of its wrap, that stands for index i in a row of n.
fn wrap_index(i: i32, n: i32) -> i32 {
    return continued_index(i, n, surface_settings.wrap);
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "wrap_pair",
        sampling: None,
        uses: &["continued_pair", "surface_settings"],
        text: r#"// The texels that stand for index i and for the next one.
fn wrap_pair(i: i32, n: i32) -> vec2i {
    return continued_pair(i, n, surface_settings.wrap);
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "level_texels",
        sampling: None,
        uses: &[],
        text: r#"// Columns and rows of a level of a map. Each level has half as many as the one before, rounded
// down, and at least 1.
fn level_texels(finest: vec2u, level: u32) -> vec2i {
    return vec2i(max(i32(finest.x >> level), 1), max(i32(finest.y >> level), 1));
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "height_texels",
        sampling: None,
        uses: &["level_texels", "surface_settings"],
        text: r#"// Columns and rows of a level of the height map.
fn height_texels(level: u32) -> vec2i {
    return level_texels(surface_settings.height_size, level);
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "height_size",
        sampling: None,
        uses: &["height_texels"],
        text: r#"// Columns and rows of a level of the height map, as floats.
fn height_size(level: u32) -> vec2f {
    return vec2f(height_texels(level));
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "cell_of",
        sampling: None,
        uses: &["CELL_LIMIT"],
        text: r#"// The dual cell that holds a point, in cell units (texture coordinate times size, minus a half), as whole
// numbers.
fn cell_of(point: vec2f) -> vec2f {
    return clamp(floor(point), vec2f(-CELL_LIMIT, -CELL_LIMIT), vec2f(CELL_LIMIT, CELL_LIMIT));
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "whole_cell",
        sampling: None,
        uses: &[],
        text: r#"// A dual cell as integers. The cells that a path goes through fit into them.
fn whole_cell(cell: vec2f) -> vec2i {
    return vec2i(cell);
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "height_cell",
        sampling: None,
        uses: &["wrapped_cell"],
        text: r#"// The corners h00, h10, h01, h11 of a dual cell of a level. One read.
fn height_cell(cell: vec2i, level: u32) -> vec4f {
    return wrapped_cell(cell, level);
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "wrapped_cell",
        sampling: None,
        uses: &["height_map", "height_texels", "wrap_pair"],
        text: r#"// The corners of a cell that may lie outside the map. SIMD code has a shorter way for cells inside,
// and comes here for the others.
fn wrapped_cell(cell: vec2i, level: u32) -> vec4f {
    let n = height_texels(level);
    let k = i32(level);
    let i = wrap_pair(cell.x, n.x);
    let j = wrap_pair(cell.y, n.y);
    return vec4f(
        textureLoad(height_map, vec2i(i.x, j.x), k).x,
        textureLoad(height_map, vec2i(i.y, j.x), k).x,
        textureLoad(height_map, vec2i(i.x, j.y), k).x,
        textureLoad(height_map, vec2i(i.y, j.y), k).x,
    );
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "volume_size",
        sampling: None,
        uses: &["surface_settings"],
        text: r#"// Columns, rows and slices of a volume.
fn volume_size() -> vec3f {
    return vec3f(surface_settings.volume.xyz);
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "slice_begin",
        sampling: None,
        uses: &["surface_settings"],
        text: r#"// The first texel of a slice of a volume. The outermost slices continue.
fn slice_begin(slice: i32) -> vec2i {
    let size = vec3i(surface_settings.volume.xyz);
    let in_row = i32(surface_settings.volume.w);
    let k = clamp(slice, 0, size.z - 1);
    // There are few slices, so floats give the whole number of rows before.
    let row = i32((f32(k) + 0.5) / f32(in_row));
    return vec2i((k - row * in_row) * size.x, row * size.y);
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "slice_cell",
        sampling: None,
        uses: &["height_map", "slice_begin", "surface_settings", "wrap_pair"],
        text: r#"// The corners of a dual cell in a slice of a volume, in the order of `height_cell`.
fn slice_cell(cell: vec2i, slice: i32) -> vec4f {
    let size = vec3i(surface_settings.volume.xyz);
    let begin = slice_begin(slice);
    let i = vec2i(begin.x, begin.x) + wrap_pair(cell.x, size.x);
    let j = vec2i(begin.y, begin.y) + wrap_pair(cell.y, size.y);
    return vec4f(
        textureLoad(height_map, vec2i(i.x, j.x), 0).x,
        textureLoad(height_map, vec2i(i.y, j.x), 0).x,
        textureLoad(height_map, vec2i(i.x, j.y), 0).x,
        textureLoad(height_map, vec2i(i.y, j.y), 0).x,
    );
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "voxel_texel",
        sampling: None,
        uses: &["slice_begin", "surface_settings", "wrap_cell"],
        text: r#"// The texel of a baked map of a volume that stands for a dual cell.
fn voxel_texel(cell: vec3i) -> vec2i {
    let size = vec3i(surface_settings.volume.xyz);
    return slice_begin(cell.z) + vec2i(wrap_cell(cell.x, size.x), wrap_cell(cell.y, size.y));
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "wrap_cell",
        sampling: None,
        uses: &["WRAP_REPEAT", "surface_settings", "wrap_index", "wrap_pair"],
        text: r#"// The dual cell that stands for cell i in a row of n. Where a map is mirrored, so are its cells: cell n lies
// between the images of the texels n - 1 and n - 2.
fn wrap_cell(i: i32, n: i32) -> i32 {
    if (surface_settings.wrap == WRAP_REPEAT) {
        return wrap_index(i, n);
    }
    let pair = wrap_pair(i, n);
    return min(pair.x, pair.y);
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "in_hole",
        sampling: None,
        uses: &["is_in_hole", "surface_settings"],
        text: r#"// Whether texture coordinates lie in a hole: in a dual cell with a texel that is one, or where the
// colour map's opacity is below the cut-off. The finest level of these maps decides, whichever
// level is traced, so that holes keep their size from afar.
fn in_hole(uv: vec2f) -> bool {
    if (surface_settings.has_holes == 0u) {
        return false;
    }
    return is_in_hole(uv);
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "is_in_hole",
        sampling: None,
        uses: &["cell_of", "color_at", "height_size", "height_texels", "hole_map", "surface_settings", "wrap_pair"],
        text: r#"// The same test for a surface that has holes.
fn is_in_hole(uv: vec2f) -> bool {
    if ((surface_settings.has_holes & 2u) != 0u) {
        if (color_at(uv, 0u).w < surface_settings.cutoff) {
            return true;
        }
    }
    if ((surface_settings.has_holes & 1u) == 0u) {
        return false;
    }
    let n = height_texels(0u);
    let cell = vec2i(cell_of(uv * height_size(0u) - vec2f(0.5, 0.5)));
    let i = wrap_pair(cell.x, n.x);
    let j = wrap_pair(cell.y, n.y);
    let above = max(textureLoad(hole_map, vec2i(i.x, j.x), 0).x, textureLoad(hole_map, vec2i(i.y, j.x), 0).x);
    let below = max(textureLoad(hole_map, vec2i(i.x, j.y), 0).x, textureLoad(hole_map, vec2i(i.y, j.y), 0).x);
    return max(above, below) > 0.0;
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "height_at",
        sampling: Some(Sampling::Exact),
        uses: &["cell_of", "height_cell", "height_size"],
        text: r#"// The bilinear surface of a level at texture coordinates. One read.
fn height_at(uv: vec2f, level: u32) -> f32 {
    let point = uv * height_size(level) - vec2f(0.5, 0.5);
    let cell = cell_of(point);
    let f = point - cell;
    let h = height_cell(vec2i(cell), level);
    let top = h.x + (h.y - h.x) * f.x;
    let bottom = h.z + (h.w - h.z) * f.x;
    return top + (bottom - top) * f.y;
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "height_at",
        sampling: Some(Sampling::Fast),
        uses: &["height_map", "map_sampler"],
        text: r#"fn height_at(uv: vec2f, level: u32) -> f32 {
    return textureSampleLevel(height_map, map_sampler, uv, f32(level)).x;
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "Around",
        sampling: None,
        uses: &[],
        text: r#"// The four texels around a point of a level of a map other than the height map, and where the point lies
// between them.
struct Around {
    columns: vec2i,
    rows: vec2i,
    part: vec2f,
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "texels_around",
        sampling: None,
        uses: &["Around", "cell_of", "wrap_pair"],
        text: r#"fn texels_around(uv: vec2f, n: vec2i) -> Around {
    let point = uv * vec2f(n) - vec2f(0.5, 0.5);
    let cell = cell_of(point);
    let i = vec2i(cell);
    return Around(wrap_pair(i.x, n.x), wrap_pair(i.y, n.y), point - cell);
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "bilinear",
        sampling: None,
        uses: &[],
        text: r#"fn bilinear(h00: vec4f, h10: vec4f, h01: vec4f, h11: vec4f, part: vec2f) -> vec4f {
    let top = h00 + (h10 - h00) * part.x;
    let bottom = h01 + (h11 - h01) * part.x;
    return top + (bottom - top) * part.y;
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "color_place",
        sampling: None,
        uses: &["surface_settings"],
        text: r#"// The colour map's coordinates at texture coordinates.
fn color_place(uv: vec2f) -> vec2f {
    let u = surface_settings.color_u.x * uv.x + surface_settings.color_u.y * uv.y;
    let v = surface_settings.color_v.x * uv.x + surface_settings.color_v.y * uv.y;
    return vec2f(u + surface_settings.color_u.z, v + surface_settings.color_v.z);
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "color_texels_around",
        sampling: None,
        uses: &["Around", "cell_of", "continued_pair", "surface_settings"],
        text: r#"// The four texels around a place of a map of that size with the colour map's wrap.
fn color_texels_around(place: vec2f, n: vec2i) -> Around {
    let point = place * vec2f(n) - vec2f(0.5, 0.5);
    let cell = cell_of(point);
    let i = vec2i(cell);
    let u = surface_settings.color_wrap_u;
    let v = surface_settings.color_wrap_v;
    return Around(continued_pair(i.x, n.x, u), continued_pair(i.y, n.y, v), point - cell);
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "color_of_texels",
        sampling: None,
        uses: &["bilinear", "color_map", "color_texels_around", "level_texels", "surface_settings"],
        text: r#"// A level of the colour map at coordinates of its own, by its texels.
fn color_of_texels(place: vec2f, level: u32) -> vec4f {
    let at = color_texels_around(place, level_texels(surface_settings.color_size, level));
    let k = i32(level);
    return bilinear(
        textureLoad(color_map, vec2i(at.columns.x, at.rows.x), k),
        textureLoad(color_map, vec2i(at.columns.y, at.rows.x), k),
        textureLoad(color_map, vec2i(at.columns.x, at.rows.y), k),
        textureLoad(color_map, vec2i(at.columns.y, at.rows.y), k),
        at.part,
    );
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "color_at",
        sampling: Some(Sampling::Exact),
        uses: &["color_of_texels", "color_place"],
        text: r#"// A level of the colour map at texture coordinates, linear RGBA.
fn color_at(uv: vec2f, level: u32) -> vec4f {
    return color_of_texels(color_place(uv), level);
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "color_at",
        sampling: Some(Sampling::Fast),
        uses: &["color_map", "color_of_texels", "color_place", "map_sampler", "surface_settings"],
        text: r#"fn color_at(uv: vec2f, level: u32) -> vec4f {
    let place = color_place(uv);
    // The sampler has the height map's wrap.
    if (surface_settings.color_wrap_u == surface_settings.wrap) {
        if (surface_settings.color_wrap_v == surface_settings.wrap) {
            return textureSampleLevel(color_map, map_sampler, place, f32(level));
        }
    }
    return color_of_texels(place, level);
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "material_of_texels",
        sampling: None,
        uses: &["bilinear", "color_texels_around", "level_texels", "material_map", "surface_settings"],
        text: r#"// A layer of a level of the material map at coordinates of the colour map, by its texels. It has the
// colour map's wrap.
fn material_of_texels(place: vec2f, layer: i32, level: u32) -> vec4f {
    let at = color_texels_around(place, level_texels(surface_settings.material_size, level));
    let k = i32(level);
    return bilinear(
        textureLoad(material_map, vec2i(at.columns.x, at.rows.x), layer, k),
        textureLoad(material_map, vec2i(at.columns.y, at.rows.x), layer, k),
        textureLoad(material_map, vec2i(at.columns.x, at.rows.y), layer, k),
        textureLoad(material_map, vec2i(at.columns.y, at.rows.y), layer, k),
        at.part,
    );
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "material_at",
        sampling: Some(Sampling::Exact),
        uses: &["color_place", "material_of_texels"],
        text: r#"// A layer of a level of the material map at texture coordinates. The first is occlusion, roughness
// and metalness, the second emission, linear RGB.
fn material_at(uv: vec2f, layer: i32, level: u32) -> vec4f {
    return material_of_texels(color_place(uv), layer, level);
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "material_at",
        sampling: Some(Sampling::Fast),
        uses: &["color_place", "map_sampler", "material_map", "material_of_texels", "surface_settings"],
        text: r#"fn material_at(uv: vec2f, layer: i32, level: u32) -> vec4f {
    let place = color_place(uv);
    if (surface_settings.color_wrap_u == surface_settings.wrap) {
        if (surface_settings.color_wrap_v == surface_settings.wrap) {
            return textureSampleLevel(material_map, map_sampler, place, layer, f32(level));
        }
    }
    return material_of_texels(place, layer, level);
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "normal_between",
        sampling: None,
        uses: &["Around", "bilinear", "normal_map"],
        text: r#"// A layer of a level of the normal map, between the four texels around a place.
fn normal_between(at: Around, layer: i32, level: u32) -> vec4f {
    let k = i32(level);
    return bilinear(
        textureLoad(normal_map, vec2i(at.columns.x, at.rows.x), layer, k),
        textureLoad(normal_map, vec2i(at.columns.y, at.rows.x), layer, k),
        textureLoad(normal_map, vec2i(at.columns.x, at.rows.y), layer, k),
        textureLoad(normal_map, vec2i(at.columns.y, at.rows.y), layer, k),
        at.part,
    );
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "normal_at",
        sampling: Some(Sampling::Exact),
        uses: &["level_texels", "normal_between", "surface_settings", "texels_around"],
        text: r#"// The first layer of a level of the normal map at texture coordinates. It begins with a vector in tangent
// space, +Y along -B, not normalised.
fn normal_at(uv: vec2f, level: u32) -> vec4f {
    return normal_between(texels_around(uv, level_texels(surface_settings.normal_size, level)), 0, level);
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "normal_at",
        sampling: Some(Sampling::Fast),
        uses: &["map_sampler", "normal_map"],
        text: r#"fn normal_at(uv: vec2f, level: u32) -> vec4f {
    return textureSampleLevel(normal_map, map_sampler, uv, 0, f32(level));
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "NormalLayers",
        sampling: None,
        uses: &[],
        text: r#"// The two layers that the normal map has from level 1 on.
struct NormalLayers {
    first: vec4f,
    second: vec4f,
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "normal_layers",
        sampling: Some(Sampling::Exact),
        uses: &["NormalLayers", "level_texels", "normal_between", "surface_settings", "texels_around"],
        text: r#"fn normal_layers(uv: vec2f, level: u32) -> NormalLayers {
    let at = texels_around(uv, level_texels(surface_settings.normal_size, level));
    return NormalLayers(normal_between(at, 0, level), normal_between(at, 1, level));
}"#,
    },
    Declaration {
        module: "shared/height",
        name: "normal_layers",
        sampling: Some(Sampling::Fast),
        uses: &["NormalLayers", "map_sampler", "normal_map"],
        text: r#"fn normal_layers(uv: vec2f, level: u32) -> NormalLayers {
    return NormalLayers(
        textureSampleLevel(normal_map, map_sampler, uv, 0, f32(level)),
        textureSampleLevel(normal_map, map_sampler, uv, 1, f32(level)),
    );
}"#,
    },
    Declaration {
        module: "shared/hemisphere",
        name: "hemisphere_grade",
        sampling: None,
        uses: &[],
        text: r#"// The light on a plane with a normal, under a sky of radiance 1 above ground of radiance `ground`. It is
// linear in the normal: a mean of normals, shorter than 1, gets the mean of their light.
fn hemisphere_grade(normal: vec3f, ground: f32) -> f32 {
    return ground + (1.0 - ground) * (0.5 + 0.5 * normal.y);
}"#,
    },
    Declaration {
        module: "shared/image",
        name: "UPRIGHT",
        sampling: None,
        uses: &[],
        text: r#"// The relation of a dual cell to its image in the map: as it is, mirrored, or none.
const UPRIGHT = 0;"#,
    },
    Declaration {
        module: "shared/image",
        name: "MIRRORED",
        sampling: None,
        uses: &[],
        text: r#"const MIRRORED = 1;"#,
    },
    Declaration {
        module: "shared/image",
        name: "BESIDE",
        sampling: None,
        uses: &[],
        text: r#"// No image. Along the axis the surface is level over the cell, and as high as at the edge of the
// map's cell.
const BESIDE = 2;"#,
    },
    Declaration {
        module: "shared/image",
        name: "image_of",
        sampling: None,
        uses: &["BESIDE", "MIRRORED", "UPRIGHT", "WRAP_CLAMP", "WRAP_REPEAT", "surface_settings"],
        text: r#"// Along an axis of n texels, the map's cell that has a dual cell as its image, and the relation of
// both. Cells beside a clamped map are not images, nor are the half cells between a mirrored map
// and its images.
fn image_of(cell: i32, n: i32) -> vec2i {
    if (cell >= 0 && cell < n) {
        return vec2i(cell, UPRIGHT);
    }
    if (surface_settings.wrap == WRAP_CLAMP) {
        return vec2i(clamp(cell, 0, n - 1), BESIDE);
    }
    if (surface_settings.wrap == WRAP_REPEAT) {
        return vec2i(((cell % n) + n) % n, UPRIGHT);
    }
    let period = 2 * n;
    let folded = ((cell % period) + period) % period;
    if (folded < n) {
        return vec2i(folded, UPRIGHT);
    }
    if (folded == period - 1) {
        return vec2i(0, BESIDE);
    }
    return vec2i(period - 2 - folded, MIRRORED);
}"#,
    },
    Declaration {
        module: "shared/image",
        name: "leaves_extent",
        sampling: None,
        uses: &["NEVER"],
        text: r#"// The parameter at which a path leaves an extent of cells or texels along an axis, from its first
// to before its second number; like `cell_leave` for one cell.
fn leaves_extent(origin: f32, step: f32, extent: vec2i) -> f32 {
    if (step > 0.0) {
        return (f32(extent.y) - origin) / step;
    }
    if (step < 0.0) {
        return (f32(extent.x) - origin) / step;
    }
    return NEVER;
}"#,
    },
    Declaration {
        module: "shared/image_cell",
        name: "parts_of_images",
        sampling: None,
        uses: &["CELLS_NEAREST", "CELLS_STEP", "surface_settings"],
        text: r#"// Cells between two texels: 2 if each quarter of a dual cell may be as high as its own texel.
fn parts_of_images() -> i32 {
    let cells = surface_settings.cells;
    return select(1, 2, cells == CELLS_STEP || cells == CELLS_NEAREST);
}"#,
    },
    Declaration {
        module: "shared/image_cell",
        name: "cell_of_images",
        sampling: None,
        uses: &["CELLS_BILINEAR", "CELLS_HIGHEST", "CELLS_NEAREST", "height_cell", "surface_settings"],
        text: r#"// The corners of a cell where heights may jump, in the order of `height_cell`. One read.
fn cell_of_images(cell: vec2i, level: u32) -> vec4f {
    if (surface_settings.cells == CELLS_BILINEAR) {
        return height_cell(cell, level);
    }
    if (surface_settings.cells == CELLS_HIGHEST) {
        let h = height_cell(cell, level);
        let most = max(max(h.x, h.y), max(h.z, h.w));
        let least = min(min(h.x, h.y), min(h.z, h.w));
        if (most - least > surface_settings.jump) {
            return vec4f(most, most, most, most);
        }
        return h;
    }
    // The quarters of a dual cell, each at one of its texels.
    let dual = vec2i(cell.x >> 1u, cell.y >> 1u);
    let h = height_cell(dual, level);
    let most = max(max(h.x, h.y), max(h.z, h.w));
    let least = min(min(h.x, h.y), min(h.z, h.w));
    let right = cell.x - dual.x - dual.x == 1;
    let lower = cell.y - dual.y - dual.y == 1;
    if (surface_settings.cells == CELLS_NEAREST || most - least > surface_settings.jump) {
        let nearest = select(select(h.x, h.y, right), select(h.z, h.w, right), lower);
        return vec4f(nearest, nearest, nearest, nearest);
    }
    let top = 0.5 * (h.x + h.y);
    let bottom = 0.5 * (h.z + h.w);
    let left = 0.5 * (h.x + h.z);
    let side = 0.5 * (h.y + h.w);
    let middle = 0.5 * (top + bottom);
    return vec4f(
        select(select(h.x, top, right), select(left, middle, right), lower),
        select(select(top, h.y, right), select(middle, side, right), lower),
        select(select(left, middle, right), select(h.z, bottom, right), lower),
        select(select(middle, side, right), select(bottom, h.w, right), lower),
    );
}"#,
    },
    Declaration {
        module: "shared/image_cell",
        name: "cell_of_mask",
        sampling: None,
        uses: &["EMPTY_HEIGHT", "height_cell"],
        text: r#"// The corners of a cell of the mask.
fn cell_of_mask(cell: vec2i, level: u32) -> vec4f {
    let h = height_cell(cell, level);
    return vec4f(
        select(0.0, 1.0, h.x > EMPTY_HEIGHT),
        select(0.0, 1.0, h.y > EMPTY_HEIGHT),
        select(0.0, 1.0, h.z > EMPTY_HEIGHT),
        select(0.0, 1.0, h.w > EMPTY_HEIGHT),
    );
}"#,
    },
    Declaration {
        module: "shared/interval",
        name: "has_interval",
        sampling: None,
        uses: &["FOUND_ABOVE", "FOUND_BRACKET", "FOUND_UNBRACKETED", "SearchResult"],
        text: r#"// Whether the search left an interval that can be narrowed; if not, its one point is the hit.
fn has_interval(found: SearchResult) -> bool {
    return found.far > found.near
        && (found.status == FOUND_BRACKET || found.status == FOUND_UNBRACKETED
            || found.status == FOUND_ABOVE);
}"#,
    },
    Declaration {
        module: "shared/levels",
        name: "Levels",
        sampling: None,
        uses: &[],
        text: r#"// The two levels of a map between which a footprint lies.
struct Levels {
    // The finer one.
    fine: u32,
    // The weight of the next level, below 1.
    part: f32,
}"#,
    },
    Declaration {
        module: "shared/levels",
        name: "levels_of",
        sampling: None,
        uses: &["Levels"],
        text: r#"// The levels for a footprint, given in texels of the finest level, of a map with `count` levels. A
// level's texels are at most as wide as the footprint. There is no logarithm, since its bits differ
// between machines.
fn levels_of(footprint: f32, count: u32) -> Levels {
    var texels = footprint;
    var level = 0u;
    while (texels >= 2.0 && level + 1u < count) {
        texels = texels * 0.5;
        level = level + 1u;
    }
    if (texels > 1.0 && level + 1u < count) {
        return Levels(level, texels - 1.0);
    }
    return Levels(level, 0.0);
}"#,
    },
    Declaration {
        module: "shared/light",
        name: "NEAREST_LIGHT",
        sampling: None,
        uses: &[],
        text: r#"// The least distance of a light, squared, in square metres: nearer ones would be brighter than any
// number.
const NEAREST_LIGHT = 0.000001;"#,
    },
    Declaration {
        module: "shared/light",
        name: "toward_light",
        sampling: None,
        uses: &["NEAREST_LIGHT", "NEVER", "Toward", "frame"],
        text: r#"// The light of that number, from a point.
fn toward_light(number: u32, position: vec3f) -> Toward {
    let light = frame.lights[number];
    if (light.place.w > 0.5) {
        let toward = light.place.xyz - position;
        let squared = dot(toward, toward);
        let distance = sqrt(squared);
        let falloff = 1.0 / max(squared, NEAREST_LIGHT);
        return Toward(normalize(toward), falloff, distance, light.color.w / distance, number);
    }
    return Toward(normalize(light.place.xyz), 1.0, NEVER, light.color.w, number);
}"#,
    },
    Declaration {
        module: "shared/light_map",
        name: "LEAST_FILTER",
        sampling: None,
        uses: &[],
        text: r#"// The least width of a filter, in texels: practically a point.
const LEAST_FILTER = 0.001;"#,
    },
    Declaration {
        module: "shared/light_map",
        name: "PLANE_REACH",
        sampling: None,
        uses: &[],
        text: r#"// The texel widths by which a texel's ray may meet the plane before or behind the point. A plane
// seen edge-on has no end.
const PLANE_REACH = 16.0;"#,
    },
    Declaration {
        module: "shared/light_map",
        name: "light_place",
        sampling: None,
        uses: &["LightView"],
        text: r#"// Column and row of a point in texels, and its depth in metres.
fn light_place(view: LightView, point: vec3f) -> vec3f {
    let at = vec4f(point, 1.0);
    let depth = dot(view.depth, at);
    let over = select(1.0, depth, view.from_point == 1u);
    return vec3f(vec2f(dot(view.column, at), dot(view.row, at)) / over, depth);
}"#,
    },
    Declaration {
        module: "shared/light_map",
        name: "holds_filter",
        sampling: None,
        uses: &["LightView"],
        text: r#"// Whether a view sees all of a filter around a place.
fn holds_filter(view: LightView, place: vec3f, half: f32) -> bool {
    let least = min(place.x, place.y) - half;
    let most = max(place.x, place.y) + half;
    return place.z > 0.0 && least >= 0.0 && most <= f32(view.size);
}"#,
    },
    Declaration {
        module: "shared/light_map",
        name: "plane_depth",
        sampling: None,
        uses: &["LightView"],
        text: r#"// The depth of a plane, given by a point and a normal, on a texel's ray.
fn plane_depth(view: LightView, point: vec3f, normal: vec3f, texel: vec2f) -> f32 {
    let corner = view.corner.xyz + view.across.xyz * texel.x + view.along.xyz * texel.y;
    if (view.from_point == 1u) {
        return dot(normal, point - view.eye.xyz) / dot(normal, corner);
    }
    return dot(normal, point - corner) / dot(normal, view.depth.xyz);
}"#,
    },
    Declaration {
        module: "shared/light_map",
        name: "footprint_m",
        sampling: None,
        uses: &["Entered", "height_size"],
        text: r#"// Width of the pixel's footprint at a placed hit, in metres.
fn footprint_m(at: Entered) -> f32 {
    return at.footprint * sqrt(at.metric.x) / height_size(0u).x;
}"#,
    },
    Declaration {
        module: "shared/light_map",
        name: "InView",
        sampling: None,
        uses: &[],
        text: r#"// A point of a surface in a light's view, and the square around it whose texels count.
struct InView {
    number: u32,
    point: vec3f,
    normal: vec3f,
    low: vec2f,
    high: vec2f,
    // The least and the greatest depth of planes.
    least_depth: f32,
    most_depth: f32,
}"#,
    },
    Declaration {
        module: "shared/light_map",
        name: "row_sees",
        sampling: None,
        uses: &["InView", "frame", "light_texel", "plane_depth"],
        text: r#"// The width of the part of a row of texels that sees the point, in texels.
fn row_sees(at: InView, row: f32, last: f32) -> f32 {
    let view = frame.light_views[at.number];
    var sees = 0.0;
    var column = floor(at.low.x);
    while (column <= last) {
        let wide = min(at.high.x, column + 1.0) - max(at.low.x, column);
        let place = vec2f(column, row);
        let plane = plane_depth(view, at.point, at.normal, place + vec2f(0.5, 0.5));
        let depth = clamp(plane, at.least_depth, at.most_depth);
        let key = view.near / (view.near + max(depth, 0.0));
        if (!(light_texel(vec2i(place), i32(at.number)) > key)) {
            sees = sees + wide;
        }
        column = column + 1.0;
    }
    return sees;
}"#,
    },
    Declaration {
        module: "shared/light_map",
        name: "seen_part",
        sampling: None,
        uses: &["Entered", "InView", "PLANE_REACH", "footprint_m", "frame", "row_sees"],
        text: r#"// The part of a light's view that sees a placed hit, around its place there. `filter_width` is the
// filter's, in texels. `bias` moves the point above the surface by that many texel widths.
fn seen_part(number: u32, at: Entered, normal: vec3f, place: vec3f, filter_width: f32, bias: f32) -> f32 {
    let view = frame.light_views[number];
    let texel_m = view.texel_m * select(1.0, place.z, view.from_point == 1u);
    let point = at.point + normal * (bias * max(texel_m, footprint_m(at)));
    let reach = PLANE_REACH * texel_m;
    let low = place.xy - vec2f(0.5, 0.5) * filter_width;
    let high = low + vec2f(filter_width, filter_width);
    let last = min(floor(high), vec2f(f32(view.size), f32(view.size)) - vec2f(1.0, 1.0));
    let in_view = InView(number, point, normal, low, high, place.z - reach, place.z + reach);
    var seen = 0.0;
    var row = floor(low.y);
    while (row <= last.y) {
        let tall = min(high.y, row + 1.0) - max(low.y, row);
        seen = seen + row_sees(in_view, row, last.x) * tall;
        row = row + 1.0;
    }
    return min(seen / (filter_width * filter_width), 1.0);
}"#,
    },
    Declaration {
        module: "shared/light_map",
        name: "light_seen",
        sampling: None,
        uses: &["Entered", "Hit", "field_patch_normal_stage", "frame", "patch_seen"],
        text: r#"// The part of a light that arrives at a placed hit, by the first of the light's shadow maps that
// holds the hit. A hit in none of them is lit.
fn light_seen(at: Entered, hit: Hit, number: u32, toward: vec3f, filter_texels: f32, bias: f32) -> f32 {
    if (frame.lights[number].views == 0u) {
        return 1.0;
    }
    let normal = field_patch_normal_stage(at, hit);
    if (!(dot(normal, toward) > 0.0)) {
        return 0.0;
    }
    return patch_seen(at, normal, number, filter_texels, bias);
}"#,
    },
    Declaration {
        module: "shared/light_map",
        name: "patch_seen",
        sampling: None,
        uses: &["Entered", "LEAST_FILTER", "frame", "holds_filter", "light_place", "seen_part"],
        text: r#"// The part of a light that arrives at a placed point of a patch with that normal.
fn patch_seen(at: Entered, normal: vec3f, number: u32, filter_texels: f32, bias: f32) -> f32 {
    let light = frame.lights[number];
    let width = max(filter_texels, LEAST_FILTER);
    var k = light.first_view;
    while (k < light.first_view + light.views) {
        let place = light_place(frame.light_views[k], at.point);
        if (holds_filter(frame.light_views[k], place, 0.5 * width)) {
            return seen_part(k, at, normal, place, width, bias);
        }
        k = k + 1u;
    }
    return 1.0;
}"#,
    },
    Declaration {
        module: "shared/light_ray",
        name: "near_uv",
        sampling: None,
        uses: &["WRAP_MIRROR", "WRAP_REPEAT", "surface_settings"],
        text: r#"// The same place of the map, as near to its origin as possible: where the relief is tiled many
// times, texture coordinates have few bits left.
fn near_uv(uv: vec2f) -> vec2f {
    if (surface_settings.wrap == WRAP_REPEAT) {
        return uv - floor(uv);
    }
    if (surface_settings.wrap == WRAP_MIRROR) {
        return uv - 2.0 * floor(0.5 * uv);
    }
    return uv;
}"#,
    },
    Declaration {
        module: "shared/light_ray",
        name: "from_hit",
        sampling: None,
        uses: &["Entered", "Hit", "Path", "RAY_SHADOW", "Toward", "climb", "height_at", "near_uv"],
        text: r#"// The straight way from a hit toward a light, begun on the surface, and without an end.
fn from_hit(at: Entered, hit: Hit, light: Toward) -> Path {
    let change = climb(at, light.direction);
    let uv = near_uv(hit.uv);
    let h = vec3f(height_at(uv, at.level), change.z, 0.0);
    return Path(uv, change.xy, h, 0.0, 0.0, at.metric, RAY_SHADOW, at.level, 0.0, 1.0, 0.0);
}"#,
    },
    Declaration {
        module: "shared/light_ray",
        name: "way_out",
        sampling: None,
        uses: &["Path", "Toward", "WRAP_CLAMP", "inside_unit", "surface_settings"],
        text: r#"// The length of a rising way through the relief: to the highest level, the footprint's edge or the
// light.
fn way_out(path: Path, light: Toward) -> f32 {
    var way = min((1.0 - path.h.x) / path.h.y, light.distance);
    if (surface_settings.wrap == WRAP_CLAMP) {
        var interval = inside_unit(path.uv.x, path.duv.x, vec2f(0.0, way));
        interval = inside_unit(path.uv.y, path.duv.y, interval);
        way = interval.y;
    }
    return way;
}"#,
    },
    Declaration {
        module: "shared/light_ray",
        name: "light_ray_from",
        sampling: None,
        uses: &["Entered", "LIGHT_RAY_DARK", "LIGHT_RAY_LIT", "LIGHT_RAY_OPEN", "LightRay", "Path", "RAY_SHADOW", "Toward", "way_out"],
        text: r#"// The ray from a place over the surface, along u, v and the height, whose change is known. A light below the
// base plane lights nothing.
fn light_ray_from(at: Entered, begin: vec3f, change: vec3f, light: Toward) -> LightRay {
    let h = vec3f(begin.z, change.z, 0.0);
    let way = Path(begin.xy, change.xy, h, 0.0, 0.0, at.metric, RAY_SHADOW, at.level, 0.0, 1.0, 0.0);
    if (!(change.z > 0.0)) {
        return LightRay(LIGHT_RAY_DARK, way);
    }
    let exit = way_out(way, light);
    if (!(exit > 0.0)) {
        return LightRay(LIGHT_RAY_LIT, way);
    }
    let path = Path(begin.xy, change.xy, h, exit, 0.0, at.metric, RAY_SHADOW, at.level, 0.0, 1.0, 0.0);
    return LightRay(LIGHT_RAY_OPEN, path);
}"#,
    },
    Declaration {
        module: "shared/light_ray",
        name: "light_ray_over_heights",
        sampling: None,
        uses: &["Entered", "Hit", "LIGHT_RAY_DARK", "LIGHT_RAY_LIT", "LIGHT_RAY_OPEN", "LightRay", "Path", "ROUNDING", "Toward", "cell_leave", "cell_of", "from_hit", "gap_to", "grid_of", "height_at", "height_cell", "path_uv", "way_out"],
        text: r#"// The ray from a hit on heights to a light. A light below the base plane lights nothing.
//
// In the hit's own cell the gap to the surface, s from the hit, is s (c.y + c.z s): the root at the hit is
// taken out. The path begins where the ray leaves the cell.
fn light_ray_over_heights(at: Entered, hit: Hit, light: Toward) -> LightRay {
    let way = from_hit(at, hit, light);
    if (!(way.h.y > 0.0)) {
        return LightRay(LIGHT_RAY_DARK, way);
    }
    let exit = way_out(way, light);
    if (!(exit > 0.0)) {
        return LightRay(LIGHT_RAY_LIT, way);
    }
    let grid = grid_of(way);
    let cell = cell_of(grid.origin);
    let leave = cell_leave(grid, cell);
    let end = max(min(min(leave.x, leave.y), exit), 0.0);
    let c = gap_to(way, grid, cell, height_cell(vec2i(cell), way.level), 0.0);
    if (c.y < 0.0 || c.y + c.z * end < 0.0) {
        return LightRay(LIGHT_RAY_DARK, way);
    }
    if (end >= exit) {
        return LightRay(LIGHT_RAY_LIT, way);
    }
    let start = path_uv(way, end);
    let gap = end * (c.y + c.z * end);
    let h = vec3f(height_at(start, way.level) + gap + ROUNDING, way.h.y, 0.0);
    let path = Path(start, way.duv, h, exit - end, 0.0, way.metric, way.ray, way.level, end, 1.0, 0.0);
    return LightRay(LIGHT_RAY_OPEN, path);
}"#,
    },
    Declaration {
        module: "shared/maps",
        name: "decoded",
        sampling: None,
        uses: &["MapSettings"],
        text: r#"// The values of a texel.
fn decoded(texel: vec4f, map: MapSettings) -> vec4f {
    if (map.coded == 1u) {
        return map.low + map.step * floor(texel * 255.0 + vec4f(0.5, 0.5, 0.5, 0.5));
    }
    return texel;
}"#,
    },
    Declaration {
        module: "shared/maps",
        name: "search_texel",
        sampling: None,
        uses: &["Path", "RAY_SHADOW", "SLOT_SEARCH", "SLOT_SHADOW_SEARCH", "decoded", "search_map", "shadow_search_map", "surface_settings"],
        text: r#"// A texel of the map that the search of a path's rays reads, by its place in a level. One read.
fn search_texel(path: Path, place: vec2i, layer: i32, level: i32) -> vec4f {
    if (path.ray == RAY_SHADOW) {
        let texel = textureLoad(shadow_search_map, place, layer, level);
        return decoded(texel, surface_settings.maps[SLOT_SHADOW_SEARCH]);
    }
    return decoded(textureLoad(search_map, place, layer, level), surface_settings.maps[SLOT_SEARCH]);
}"#,
    },
    Declaration {
        module: "shared/maps",
        name: "search_layers",
        sampling: None,
        uses: &["Path", "RAY_SHADOW", "SLOT_SEARCH", "SLOT_SHADOW_SEARCH", "surface_settings"],
        text: r#"// The layers of that map.
fn search_layers(path: Path) -> u32 {
    let slot = select(SLOT_SEARCH, SLOT_SHADOW_SEARCH, path.ray == RAY_SHADOW);
    return surface_settings.maps[slot].layers;
}"#,
    },
    Declaration {
        module: "shared/maps",
        name: "map_read",
        sampling: None,
        uses: &["Path", "RAY_SHADOW", "SLOT_SEARCH", "SLOT_SHADOW_SEARCH", "surface_settings"],
        text: r#"// The cost of one read of `texels` texels of that map.
fn map_read(path: Path, texels: u32) -> vec3u {
    let slot = select(SLOT_SEARCH, SLOT_SHADOW_SEARCH, path.ray == RAY_SHADOW);
    return vec3u(1u, 0u, texels * surface_settings.maps[slot].texel_bytes);
}"#,
    },
    Declaration {
        module: "shared/maps",
        name: "texel_reads",
        sampling: None,
        uses: &["Path", "map_read"],
        text: r#"// The cost of that many reads of one texel of that map.
fn texel_reads(path: Path, reads: u32) -> vec3u {
    return map_read(path, reads) + vec3u(reads - 1u, 0u, 0u);
}"#,
    },
    Declaration {
        module: "shared/maps",
        name: "search_texel_between",
        sampling: None,
        uses: &["Path", "bilinear", "height_texels", "search_texel", "texels_around"],
        text: r#"// The map that the search of a path's rays reads, between the four texels around a place. One read.
fn search_texel_between(path: Path, uv: vec2f, layer: i32) -> vec4f {
    let at = texels_around(uv, height_texels(path.level));
    let level = i32(path.level);
    return bilinear(
        search_texel(path, vec2i(at.columns.x, at.rows.x), layer, level),
        search_texel(path, vec2i(at.columns.y, at.rows.x), layer, level),
        search_texel(path, vec2i(at.columns.x, at.rows.y), layer, level),
        search_texel(path, vec2i(at.columns.y, at.rows.y), layer, level),
        at.part,
    );
}"#,
    },
    Declaration {
        module: "shared/maps",
        name: "shadow_texel",
        sampling: None,
        uses: &["SLOT_SHADOW", "decoded", "shadow_texels", "surface_settings"],
        text: r#"// A texel of the map that the shadow stage reads. One read.
fn shadow_texel(place: vec2i, layer: i32, level: i32) -> vec4f {
    return decoded(textureLoad(shadow_texels, place, layer, level), surface_settings.maps[SLOT_SHADOW]);
}"#,
    },
    Declaration {
        module: "shared/maps",
        name: "shadow_texel_between",
        sampling: None,
        uses: &["bilinear", "height_texels", "shadow_texel", "texels_around"],
        text: r#"// A level of the map that the shadow stage reads, between the four texels around a place. One read.
fn shadow_texel_between(uv: vec2f, layer: i32, level: u32) -> vec4f {
    let at = texels_around(uv, height_texels(level));
    let k = i32(level);
    return bilinear(
        shadow_texel(vec2i(at.columns.x, at.rows.x), layer, k),
        shadow_texel(vec2i(at.columns.y, at.rows.x), layer, k),
        shadow_texel(vec2i(at.columns.x, at.rows.y), layer, k),
        shadow_texel(vec2i(at.columns.y, at.rows.y), layer, k),
        at.part,
    );
}"#,
    },
    Declaration {
        module: "shared/maps",
        name: "ambient_texel",
        sampling: None,
        uses: &["SLOT_AMBIENT", "ambient_map", "decoded", "surface_settings"],
        text: r#"// A texel of the map of light from all around. One read.
fn ambient_texel(place: vec2i, layer: i32, level: i32) -> vec4f {
    return decoded(textureLoad(ambient_map, place, layer, level), surface_settings.maps[SLOT_AMBIENT]);
}"#,
    },
    Declaration {
        module: "shared/maps",
        name: "ambient_texel_between",
        sampling: None,
        uses: &["SLOT_AMBIENT", "ambient_texel", "bilinear", "height_texels", "surface_settings", "texels_around"],
        text: r#"// The ambient map, between the four texels around a place, for a level of detail. Levels finer than
// the map's first read the first. One read.
fn ambient_texel_between(uv: vec2f, level: u32) -> vec4f {
    let first = surface_settings.maps[SLOT_AMBIENT].first_level;
    let seen = select(first, level, level > first);
    let at = texels_around(uv, height_texels(seen));
    let k = i32(seen - first);
    return bilinear(
        ambient_texel(vec2i(at.columns.x, at.rows.x), 0, k),
        ambient_texel(vec2i(at.columns.y, at.rows.x), 0, k),
        ambient_texel(vec2i(at.columns.x, at.rows.y), 0, k),
        ambient_texel(vec2i(at.columns.y, at.rows.y), 0, k),
        at.part,
    );
}"#,
    },
    Declaration {
        module: "shared/maps",
        name: "environment_texel",
        sampling: None,
        uses: &["SLOT_ENVIRONMENT", "decoded", "environment_map", "surface_settings"],
        text: r#"// A texel of the environment map, on a face of the cube. One read.
fn environment_texel(place: vec2i, face: i32, level: i32) -> vec4f {
    return decoded(textureLoad(environment_map, place, face, level), surface_settings.maps[SLOT_ENVIRONMENT]);
}"#,
    },
    Declaration {
        module: "shared/maps",
        name: "light_texel",
        sampling: None,
        uses: &["light_map"],
        text: r#"// A texel of the shadow map with that number: the key of the nearest hit. One read.
fn light_texel(place: vec2i, view: i32) -> f32 {
    return textureLoad(light_map, place, view, 0).x;
}"#,
    },
    Declaration {
        module: "shared/maps",
        name: "object_texel",
        sampling: None,
        uses: &["object_map"],
        text: r#"// A texel of the map of an object's images.
fn object_texel(place: vec2i) -> vec4f {
    return textureLoad(object_map, place, 0, 0);
}"#,
    },
    Declaration {
        module: "shared/maps",
        name: "detail_texel",
        sampling: None,
        uses: &["SLOT_DETAIL", "decoded", "detail_map", "surface_settings"],
        text: r#"// A texel of the map of visible normals. One read.
fn detail_texel(place: vec2i, layer: i32, level: i32) -> vec4f {
    return decoded(textureLoad(detail_map, place, layer, level), surface_settings.maps[SLOT_DETAIL]);
}"#,
    },
    Declaration {
        module: "shared/maps",
        name: "detail_texel_between",
        sampling: None,
        uses: &["Around", "SLOT_DETAIL", "bilinear", "detail_texel", "surface_settings"],
        text: r#"// The map of visible normals between four texels, for a level of detail from its first one on. One read.
fn detail_texel_between(at: Around, layer: i32, level: u32) -> vec4f {
    let k = i32(level - surface_settings.maps[SLOT_DETAIL].first_level);
    return bilinear(
        detail_texel(vec2i(at.columns.x, at.rows.x), layer, k),
        detail_texel(vec2i(at.columns.y, at.rows.x), layer, k),
        detail_texel(vec2i(at.columns.x, at.rows.y), layer, k),
        detail_texel(vec2i(at.columns.y, at.rows.y), layer, k),
        at.part,
    );
}"#,
    },
    Declaration {
        module: "shared/material",
        name: "material_layer",
        sampling: None,
        uses: &["levels_of", "material_at", "surface_settings"],
        text: r#"// A layer of the material map within a footprint.
fn material_layer(uv: vec2f, footprint: f32, layer: i32) -> vec3f {
    let levels = levels_of(footprint * surface_settings.material_texels, surface_settings.material_levels);
    let fine = material_at(uv, layer, levels.fine).xyz;
    if (levels.part > 0.0) {
        return fine + (material_at(uv, layer, levels.fine + 1u).xyz - fine) * levels.part;
    }
    return fine;
}"#,
    },
    Declaration {
        module: "shared/material",
        name: "occlusion_roughness_metalness",
        sampling: None,
        uses: &["material_layer", "surface_settings"],
        text: r#"// Occlusion, roughness and metalness, each from 0 to 1; 1 without a map.
fn occlusion_roughness_metalness(uv: vec2f, footprint: f32) -> vec3f {
    if ((surface_settings.has_material & 1u) == 0u) {
        return vec3f(1.0, 1.0, 1.0);
    }
    return material_layer(uv, footprint, 0);
}"#,
    },
    Declaration {
        module: "shared/material",
        name: "emission_at",
        sampling: None,
        uses: &["material_layer", "surface_settings"],
        text: r#"// The light that the surface gives by itself, linear RGB.
fn emission_at(uv: vec2f, footprint: f32) -> vec3f {
    if ((surface_settings.has_material & 2u) == 0u) {
        return surface_settings.emission.xyz;
    }
    return surface_settings.emission.xyz * material_layer(uv, footprint, 1);
}"#,
    },
    Declaration {
        module: "shared/motif",
        name: "NODE_READ",
        sampling: None,
        uses: &[],
        text: r#"// The reads of a node and of a triangle.
const NODE_READ = vec3u(1u, 0u, 32u);"#,
    },
    Declaration {
        module: "shared/motif",
        name: "TRIANGLE_READ",
        sampling: None,
        uses: &[],
        text: r#"const TRIANGLE_READ = vec3u(1u, 0u, 48u);"#,
    },
    Declaration {
        module: "shared/motif",
        name: "EDGE_SLACK",
        sampling: None,
        uses: &[],
        text: r#"// The parts of an edge function's products by which a ray may lie beyond an edge: some roundings. Smaller,
// and rays pass between triangles; larger, and outlines grow.
const EDGE_SLACK = 0.0000005;"#,
    },
    Declaration {
        module: "shared/motif",
        name: "LEAST_STEP",
        sampling: None,
        uses: &[],
        text: r#"// A step along an axis that is smaller, in tiles, is none: its inverse would overflow.
const LEAST_STEP = 1.0e-30;"#,
    },
    Declaration {
        module: "shared/motif",
        name: "AT_HIT",
        sampling: None,
        uses: &[],
        text: r#"// The distance in tiles up to which a hit is on a triangle. Smaller, and rounding far from the first tile
// loses it; larger, and more triangles are looked at.
const AT_HIT = 0.0001;"#,
    },
    Declaration {
        module: "shared/motif",
        name: "OUTSIDE_TILES",
        sampling: None,
        uses: &[],
        text: r#"// Tiles by which a ray to a light begins outside of the triangle that it leaves. Smaller, and rounding throws
// shadows; larger, and light comes through what is thin.
const OUTSIDE_TILES = 0.0002;"#,
    },
    Declaration {
        module: "shared/motif",
        name: "motif_texel",
        sampling: None,
        uses: &["TREE_COLUMNS", "TREE_SHIFT", "object_texel"],
        text: r#"fn motif_texel(place: u32) -> vec4f {
    let row = place >> TREE_SHIFT;
    return object_texel(vec2i(i32(place - row * TREE_COLUMNS), i32(row)));
}"#,
    },
    Declaration {
        module: "shared/motif",
        name: "motif_is_closed",
        sampling: None,
        uses: &["motif_texel"],
        text: r#"// Whether every edge of the motif has two triangles.
fn motif_is_closed() -> bool {
    return motif_texel(0u).z == 1.0;
}"#,
    },
    Declaration {
        module: "shared/motif",
        name: "MotifRay",
        sampling: None,
        uses: &[],
        text: r#"// A straight way in a tile, seen along its longest axis, which comes last. `shear` takes a place to the two
// axes across the way; its third part is the parameter of one along the axis.
struct MotifRay {
    origin: vec3f,
    inverse: vec3f,
    axis: u32,
    shear: vec3f,
}"#,
    },
    Declaration {
        module: "shared/motif",
        name: "with_axis_last",
        sampling: None,
        uses: &[],
        text: r#"fn with_axis_last(v: vec3f, axis: u32) -> vec3f {
    if (axis == 0u) {
        return vec3f(v.y, v.z, v.x);
    }
    if (axis == 1u) {
        return vec3f(v.z, v.x, v.y);
    }
    return v;
}"#,
    },
    Declaration {
        module: "shared/motif",
        name: "motif_ray",
        sampling: None,
        uses: &["LEAST_STEP", "MotifRay", "NEVER", "with_axis_last"],
        text: r#"fn motif_ray(origin: vec3f, step: vec3f) -> MotifRay {
    let size = abs(step);
    var axis = select(2u, 1u, size.y > size.z);
    axis = select(axis, 0u, size.x > max(size.y, size.z));
    let way = with_axis_last(step, axis);
    let least = vec3f(LEAST_STEP, LEAST_STEP, LEAST_STEP);
    let inverse = select(vec3f(NEVER, NEVER, NEVER), vec3f(1.0, 1.0, 1.0) / step, size > least);
    return MotifRay(origin, inverse, axis, vec3f(way.x / way.z, way.y / way.z, 1.0 / way.z));
}"#,
    },
    Declaration {
        module: "shared/motif",
        name: "meets_box",
        sampling: None,
        uses: &["MotifRay"],
        text: r#"// Whether a way goes through a box between two parameters.
fn meets_box(ray: MotifRay, low: vec3f, high: vec3f, near: f32, far: f32) -> bool {
    let a = (low - ray.origin) * ray.inverse;
    let b = (high - ray.origin) * ray.inverse;
    let first = min(a, b);
    let last = max(a, b);
    let enter = max(max(first.x, first.y), max(first.z, near));
    let leave = min(min(last.x, last.y), min(last.z, far));
    return enter <= leave;
}"#,
    },
    Declaration {
        module: "shared/motif",
        name: "seen_beside",
        sampling: None,
        uses: &["MotifRay", "with_axis_last"],
        text: r#"// A corner as the way sees it: beside the way, and along it.
fn seen_beside(ray: MotifRay, corner: vec3f) -> vec3f {
    let at = with_axis_last(corner - ray.origin, ray.axis);
    return vec3f(at.x - ray.shear.x * at.z, at.y - ray.shear.y * at.z, at.z);
}"#,
    },
    Declaration {
        module: "shared/motif",
        name: "meets_triangle",
        sampling: None,
        uses: &["EDGE_SLACK", "MotifRay", "NEVER", "seen_beside"],
        text: r#"// The parameter at which a way meets a triangle; NEVER if it does not.
fn meets_triangle(ray: MotifRay, first: vec3f, second: vec3f, third: vec3f) -> f32 {
    let a = seen_beside(ray, first);
    let b = seen_beside(ray, second);
    let c = seen_beside(ray, third);
    let left = vec3f(c.x * b.y, a.x * c.y, b.x * a.y);
    let right = vec3f(c.y * b.x, a.y * c.x, b.y * a.x);
    let sides = left - right;
    let slack = (abs(left) + abs(right)) * EDGE_SLACK;
    let most = sides + slack;
    let least = sides - slack;
    let is_front = min(min(most.x, most.y), most.z) >= 0.0;
    let is_back = max(max(least.x, least.y), least.z) <= 0.0;
    let all = sides.x + sides.y + sides.z;
    if (!(is_front || is_back) || all == 0.0) {
        return NEVER;
    }
    let along = (sides.x * a.z + sides.y * b.z + sides.z * c.z) / all;
    let least_z = min(min(a.z, b.z), c.z);
    let most_z = max(max(a.z, b.z), c.z);
    return clamp(along, least_z, most_z) * ray.shear.z;
}"#,
    },
    Declaration {
        module: "shared/motif",
        name: "MotifHit",
        sampling: None,
        uses: &[],
        text: r#"// The first triangle on a way in a tile.
struct MotifHit {
    // NEVER without one.
    t: f32,
    cost: vec3u,
}"#,
    },
    Declaration {
        module: "shared/motif",
        name: "first_of_leaf",
        sampling: None,
        uses: &["MotifHit", "MotifRay", "NEVER", "NO_COST", "TRIANGLE_READ", "meets_triangle", "motif_texel"],
        text: r#"// The first triangle of a leaf, by its first texel, that the way meets between the parameters `near` and
// `far`.
fn first_of_leaf(ray: MotifRay, leaf: u32, near: f32, far: f32) -> MotifHit {
    var found = NEVER;
    var cost = NO_COST;
    var triangle = leaf;
    while (triangle != 0u) {
        let a = motif_texel(triangle);
        let b = motif_texel(triangle + 1u);
        let c = motif_texel(triangle + 2u);
        cost = cost + TRIANGLE_READ;
        let t = meets_triangle(ray, a.xyz, b.xyz, c.xyz);
        if (t >= near && t < min(found, far)) {
            found = t;
        }
        triangle = select(triangle + 3u, 0u, a.w == 0.0);
    }
    return MotifHit(found, cost);
}"#,
    },
    Declaration {
        module: "shared/motif",
        name: "first_of_motif",
        sampling: None,
        uses: &["MotifHit", "MotifRay", "NEVER", "NODE_READ", "STEP", "first_of_leaf", "meets_box", "motif_texel"],
        text: r#"// The first triangle of the motif between the parameters `near` and `far`. Costs are added to `before`, until
// they are `limit` steps.
fn first_of_motif(ray: MotifRay, near: f32, far: f32, before: vec3u, limit: u32) -> MotifHit {
    var cost = before;
    var found = NEVER;
    var node = 1u;
    while (node != 0u && cost.y < limit) {
        let low = motif_texel(node);
        let high = motif_texel(node + 1u);
        cost = cost + STEP + NODE_READ;
        let best = min(found, far);
        var next = u32(low.w);
        if (meets_box(ray, low.xyz, high.xyz, near, best)) {
            if (high.w == 0.0) {
                next = node + 2u;
            } else {
                let of_leaf = first_of_leaf(ray, u32(high.w), near, best);
                found = min(found, of_leaf.t);
                cost = cost + of_leaf.cost;
            }
        }
        node = next;
    }
    return MotifHit(found, cost);
}"#,
    },
    Declaration {
        module: "shared/motif",
        name: "MotifPoint",
        sampling: None,
        uses: &[],
        text: r#"// The motif at a place on it, along u, v and the height: the mean of the corners' normals, and the
// triangle's own on the same side, of length 1.
struct MotifPoint {
    normal: vec3f,
    facet: vec3f,
}"#,
    },
    Declaration {
        module: "shared/motif",
        name: "apart_from_edge",
        sampling: None,
        uses: &[],
        text: r#"// The squared distance between a place and an edge.
fn apart_from_edge(place: vec3f, a: vec3f, b: vec3f) -> f32 {
    let way = b - a;
    let part = clamp(dot(place - a, way) / dot(way, way), 0.0, 1.0);
    let apart = a + way * part - place;
    return dot(apart, apart);
}"#,
    },
    Declaration {
        module: "shared/motif",
        name: "weights_under",
        sampling: None,
        uses: &[],
        text: r#"// The weights of a triangle's corners at the place in its plane below a place, times a positive number.
fn weights_under(place: vec3f, a: vec3f, b: vec3f, c: vec3f) -> vec3f {
    let normal = cross(b - a, c - a);
    return vec3f(
        dot(cross(c - b, place - b), normal),
        dot(cross(a - c, place - c), normal),
        dot(cross(b - a, place - a), normal),
    );
}"#,
    },
    Declaration {
        module: "shared/motif",
        name: "apart_from_triangle",
        sampling: None,
        uses: &["apart_from_edge", "weights_under"],
        text: r#"// The squared distance between a place and a triangle.
fn apart_from_triangle(place: vec3f, a: vec3f, b: vec3f, c: vec3f) -> f32 {
    let weights = weights_under(place, a, b, c);
    if (min(min(weights.x, weights.y), weights.z) >= 0.0) {
        let normal = cross(b - a, c - a);
        let above = dot(place - a, normal);
        return above * above / dot(normal, normal);
    }
    let first = min(apart_from_edge(place, a, b), apart_from_edge(place, b, c));
    return min(first, apart_from_edge(place, c, a));
}"#,
    },
    Declaration {
        module: "shared/motif",
        name: "NearTriangle",
        sampling: None,
        uses: &[],
        text: r#"// A triangle by its first texel, and the squared distance between a place and it.
struct NearTriangle {
    triangle: u32,
    apart: f32,
}"#,
    },
    Declaration {
        module: "shared/motif",
        name: "nearest_of_leaf",
        sampling: None,
        uses: &["NearTriangle", "apart_from_triangle", "motif_texel"],
        text: r#"// The nearest triangle of a leaf, if it is nearer than the given one.
fn nearest_of_leaf(place: vec3f, leaf: u32, before: NearTriangle) -> NearTriangle {
    var nearest = before;
    var triangle = leaf;
    while (triangle != 0u) {
        let a = motif_texel(triangle);
        let b = motif_texel(triangle + 1u);
        let c = motif_texel(triangle + 2u);
        let apart = apart_from_triangle(place, a.xyz, b.xyz, c.xyz);
        if (apart < nearest.apart) {
            nearest = NearTriangle(triangle, apart);
        }
        triangle = select(triangle + 3u, 0u, a.w == 0.0);
    }
    return nearest;
}"#,
    },
    Declaration {
        module: "shared/motif",
        name: "motif_at",
        sampling: None,
        uses: &["AT_HIT", "MotifPoint", "NearTriangle", "motif_texel", "nearest_of_leaf", "point_of_triangle"],
        text: r#"// The motif at a place in the first tile: the nearest triangle's. Upright where there is none.
fn motif_at(place: vec3f) -> MotifPoint {
    let reach = vec3f(AT_HIT, AT_HIT, AT_HIT);
    var nearest = NearTriangle(0u, AT_HIT * AT_HIT);
    var node = 1u;
    while (node != 0u) {
        let low = motif_texel(node);
        let high = motif_texel(node + 1u);
        var next = u32(low.w);
        let beyond = max(low.xyz - reach - place, place - high.xyz - reach);
        if (max(max(beyond.x, beyond.y), beyond.z) <= 0.0) {
            if (high.w == 0.0) {
                next = node + 2u;
            } else {
                nearest = nearest_of_leaf(place, u32(high.w), nearest);
            }
        }
        node = next;
    }
    if (nearest.triangle == 0u) {
        return MotifPoint(vec3f(0.0, 0.0, 1.0), vec3f(0.0, 0.0, 1.0));
    }
    return point_of_triangle(nearest.triangle, place);
}"#,
    },
    Declaration {
        module: "shared/motif",
        name: "point_of_triangle",
        sampling: None,
        uses: &["MotifPoint", "motif_texel", "weights_under"],
        text: r#"// The motif at a place on one of its triangles.
fn point_of_triangle(triangle: u32, place: vec3f) -> MotifPoint {
    let a = motif_texel(triangle).xyz;
    let b = motif_texel(triangle + 1u).xyz;
    let c = motif_texel(triangle + 2u).xyz;
    let normals = triangle + u32(motif_texel(0u).x);
    let weights = max(weights_under(place, a, b, c), vec3f(0.0, 0.0, 0.0));
    let first = motif_texel(normals).xyz * weights.x;
    let second = motif_texel(normals + 1u).xyz * weights.y;
    let sum = first + second + motif_texel(normals + 2u).xyz * weights.z;
    let flat_normal = normalize(cross(b - a, c - a));
    let facet = flat_normal * select(1.0, -1.0, dot(flat_normal, sum) < 0.0);
    let size = length(sum);
    if (size > 0.0) {
        return MotifPoint(sum / size, facet);
    }
    return MotifPoint(facet, facet);
}"#,
    },
    Declaration {
        module: "shared/motif",
        name: "motif_of",
        sampling: None,
        uses: &["Hit", "MotifPoint", "motif_at"],
        text: r#"// The motif at a hit.
fn motif_of(hit: Hit) -> MotifPoint {
    return motif_at(vec3f(hit.uv - floor(hit.uv), hit.height));
}"#,
    },
    Declaration {
        module: "shared/motif",
        name: "light_ray_out_of_motif",
        sampling: None,
        uses: &["Entered", "Hit", "LightRay", "OUTSIDE_TILES", "Toward", "climb", "light_ray_from", "motif_of", "near_uv"],
        text: r#"// The ray from a hit to a light, which begins a little outside of the motif, on the light's side. A light
// below the base plane lights nothing.
fn light_ray_out_of_motif(at: Entered, hit: Hit, light: Toward) -> LightRay {
    let change = climb(at, light.direction);
    let facet = motif_of(hit).facet;
    let aside = facet * select(0.0 - OUTSIDE_TILES, OUTSIDE_TILES, dot(facet, change) > 0.0);
    return light_ray_from(at, vec3f(near_uv(hit.uv), hit.height) + aside, change, light);
}"#,
    },
    Declaration {
        module: "shared/normal",
        name: "LEAST_CREASE",
        sampling: None,
        uses: &[],
        text: r#"// Tangents of the angle between two slopes at which a crease begins and at which it is complete:
// some 27 and 45 degrees. Smaller, and round things become facets; larger, and edges are smeared.
const LEAST_CREASE = 0.5;"#,
    },
    Declaration {
        module: "shared/normal",
        name: "WHOLE_CREASE",
        sampling: None,
        uses: &[],
        text: r#"const WHOLE_CREASE = 1.0;"#,
    },
    Declaration {
        module: "shared/normal",
        name: "slope_beside",
        sampling: None,
        uses: &["LEAST_CREASE", "WHOLE_CREASE"],
        text: r#"// The slope of a neighbouring cell, as far as there is no crease between it and the own one. `rate`
// turns a difference of heights into a slope in metres.
fn slope_beside(own: f32, beside: f32, rate: f32) -> f32 {
    let a = own * rate;
    let b = beside * rate;
    // The tangent of the angle between both is |a - b| over this. From a right angle on it is not
    // positive.
    let along = 1.0 + a * b;
    let apart = abs(a - b);
    if (apart <= LEAST_CREASE * along) {
        return beside;
    }
    if (apart >= WHOLE_CREASE * along) {
        return own;
    }
    let part = (apart / along - LEAST_CREASE) / (WHOLE_CREASE - LEAST_CREASE);
    return beside + (own - beside) * part;
}"#,
    },
    Declaration {
        module: "shared/normal",
        name: "cell_slopes",
        sampling: None,
        uses: &[],
        text: r#"// The changes of the height from texel to texel along u and v in a dual cell, at that place in it.
fn cell_slopes(h: vec4f, part: vec2f) -> vec2f {
    let top = h.y - h.x;
    let left = h.z - h.x;
    let twist = (h.w - h.z) - top;
    return vec2f(top + twist * part.y, left + twist * part.x);
}"#,
    },
    Declaration {
        module: "shared/normal",
        name: "sloped_cell",
        sampling: None,
        uses: &["WRAP_CLAMP", "height_texels", "surface_settings"],
        text: r#"// The dual cell whose slopes stand for a cell: of a clamped map the nearest cell inside.
fn sloped_cell(i: vec2i, level: u32) -> vec2i {
    if (surface_settings.wrap != WRAP_CLAMP) {
        return i;
    }
    let last = max(height_texels(level) - vec2i(2, 2), vec2i(0, 0));
    return clamp(i, vec2i(0, 0), last);
}"#,
    },
    Declaration {
        module: "shared/normal",
        name: "slopes_between_creases",
        sampling: None,
        uses: &["Entered", "WRAP_CLAMP", "cell_of", "cell_slopes", "height_cell", "height_size", "slope_beside", "sloped_cell", "surface_settings"],
        text: r#"// The same changes by central differences, but not across creases.
fn slopes_between_creases(at: Entered, uv: vec2f, level: u32) -> vec2f {
    let size = height_size(level);
    let point = uv * size - vec2f(0.5, 0.5);
    let cell = vec2f(sloped_cell(vec2i(cell_of(point)), level));
    var part = point - cell;
    if (surface_settings.wrap == WRAP_CLAMP) {
        part = clamp(part, vec2f(0.0, 0.0), vec2f(1.0, 1.0));
    }
    let i = vec2i(cell);
    let own = cell_slopes(height_cell(i, level), part);
    let before_u = cell_slopes(height_cell(sloped_cell(i - vec2i(1, 0), level), level), part).x;
    let behind_u = cell_slopes(height_cell(sloped_cell(i + vec2i(1, 0), level), level), part).x;
    let before_v = cell_slopes(height_cell(sloped_cell(i - vec2i(0, 1), level), level), part).y;
    let behind_v = cell_slopes(height_cell(sloped_cell(i + vec2i(0, 1), level), level), part).y;
    let rate_u = size.x * surface_settings.scale_m / length(at.tangent);
    let rate_v = size.y * surface_settings.scale_m / length(at.bitangent);
    let before = vec2f(slope_beside(own.x, before_u, rate_u), slope_beside(own.y, before_v, rate_v));
    let behind = vec2f(slope_beside(own.x, behind_u, rate_u), slope_beside(own.y, behind_v, rate_v));
    return 0.5 * (own + before + (behind - before) * part);
}"#,
    },
    Declaration {
        module: "shared/normal",
        name: "texels_apart",
        sampling: None,
        uses: &["WRAP_CLAMP", "surface_settings"],
        text: r#"// Texels between the heights a texel before and a texel behind a place, along a side of `side`
// texels: 2, or less at the edges of a clamped map, whose heights do not change beyond the
// outermost centres. At the very edge half a texel is left. Farther out slopes fall to 0.
fn texels_apart(place: f32, side: f32) -> f32 {
    if (surface_settings.wrap != WRAP_CLAMP) {
        return 2.0;
    }
    return max(2.0 - max(1.5 - place, 0.0) - max(place + 1.5 - side, 0.0), 0.5);
}"#,
    },
    Declaration {
        module: "shared/normal",
        name: "normal_from_height",
        sampling: None,
        uses: &["Entered", "height_at", "height_size", "normal_of_slopes", "slopes_between_creases", "surface_settings", "texels_apart"],
        text: r#"// The normal of a level of the heights, in the world.
fn normal_from_height(at: Entered, uv: vec2f, level: u32) -> vec3f {
    let size = height_size(level);
    if (surface_settings.has_creases == 1u) {
        let slopes = slopes_between_creases(at, uv, level) * size * surface_settings.scale_m;
        return normal_of_slopes(at, slopes.x, slopes.y);
    }
    let du = vec2f(1.0 / size.x, 0.0);
    let dv = vec2f(0.0, 1.0 / size.y);
    let rise_u = height_at(uv + du, level) - height_at(uv - du, level);
    let rise_v = height_at(uv + dv, level) - height_at(uv - dv, level);
    let rate_u = 1.0 / texels_apart(uv.x * size.x, size.x);
    let rate_v = 1.0 / texels_apart(uv.y * size.y, size.y);
    let slope_u = rise_u * (rate_u * size.x * surface_settings.scale_m);
    let slope_v = rise_v * (rate_v * size.y * surface_settings.scale_m);
    return normal_of_slopes(at, slope_u, slope_v);
}"#,
    },
    Declaration {
        module: "shared/normal",
        name: "normal_of_slopes",
        sampling: None,
        uses: &["Entered"],
        text: r#"// The normal of a relief that rises along u and v by these slopes, in metres per tile.
fn normal_of_slopes(at: Entered, slope_u: f32, slope_v: f32) -> vec3f {
    let along_u = at.tangent + at.normal * slope_u;
    let along_v = at.bitangent + at.normal * slope_v;
    let across = normalize(cross(along_v, along_u));
    return across * select(-1.0, 1.0, dot(across, at.normal) >= 0.0);
}"#,
    },
    Declaration {
        module: "shared/normal",
        name: "from_tangent_space",
        sampling: None,
        uses: &["Entered"],
        text: r#"// A vector of tangent space, in the world.
fn from_tangent_space(at: Entered, n: vec3f) -> vec3f {
    let along_u = normalize(at.tangent);
    let along_v = normalize(at.bitangent);
    return along_u * n.x - along_v * n.y + at.normal * n.z;
}"#,
    },
    Declaration {
        module: "shared/normal",
        name: "to_tangent_space",
        sampling: None,
        uses: &["Entered"],
        text: r#"// A vector of the world, in tangent space.
fn to_tangent_space(at: Entered, v: vec3f) -> vec3f {
    let along_u = normalize(at.tangent);
    let along_v = normalize(at.bitangent);
    return vec3f(dot(along_u, v), -dot(along_v, v), dot(at.normal, v));
}"#,
    },
    Declaration {
        module: "shared/normal",
        name: "finest_normal",
        sampling: None,
        uses: &["Entered", "from_tangent_space", "normal_at", "normal_from_height", "surface_settings"],
        text: r#"// The normal in the finest level.
fn finest_normal(at: Entered, uv: vec2f) -> vec3f {
    if (surface_settings.has_normal == 1u) {
        return normalize(from_tangent_space(at, normal_at(uv, 0u).xyz));
    }
    return normal_from_height(at, uv, 0u);
}"#,
    },
    Declaration {
        module: "shared/numbered",
        name: "EXHAUSTED_BIT",
        sampling: None,
        uses: &[],
        text: r#"// A traced pixel's data in integers: the triangle's number plus 1, negative for a back face; the
// reads, with EXHAUSTED_BIT set if the search was exhausted; the steps, and above the lowest
// STEPS_BITS bits the number of the segment; the bytes.
const EXHAUSTED_BIT = 1073741824i;"#,
    },
    Declaration {
        module: "shared/numbered",
        name: "STEPS_BITS",
        sampling: None,
        uses: &[],
        text: r#"const STEPS_BITS = 25u;"#,
    },
    Declaration {
        module: "shared/numbered",
        name: "Traced",
        sampling: None,
        uses: &[],
        text: r#"// Result of the first pass for a pixel: uv, height and t of the hit, the triangle and the cost.
// Zeros without a hit.
struct Traced {
    @location(0) hit: vec4f,
    @location(1) what: vec4i,
    @builtin(frag_depth) key: f32,
}"#,
    },
    Declaration {
        module: "shared/numbered",
        name: "SeenByLight",
        sampling: None,
        uses: &[],
        text: r#"// A texel of a shadow map.
struct SeenByLight {
    @location(0) key: f32,
    @builtin(frag_depth) depth: f32,
}"#,
    },
    Declaration {
        module: "shared/numbered",
        name: "traced_hit_of",
        sampling: None,
        uses: &["EXHAUSTED_BIT", "FirstHit", "STEPS_BITS", "Traced"],
        text: r#"// A first hit of a triangle's relief as the first pass knows it.
fn traced_hit_of(triangle: u32, side: f32, first: FirstHit) -> Traced {
    let hit = first.hit;
    let number = i32(triangle) + 1;
    let reads = i32(hit.cost.x) + select(0, EXHAUSTED_BIT, hit.exhausted == 1u);
    let steps = i32(hit.cost.y + (first.segment << STEPS_BITS));
    let what = vec4i(select(-number, number, side > 0.0), reads, steps, i32(hit.cost.z));
    return Traced(vec4f(hit.uv, hit.height, hit.t), what, first.key);
}"#,
    },
    Declaration {
        module: "shared/numbered",
        name: "numbered_triangle",
        sampling: None,
        uses: &["Triangle", "mesh_corners", "mesh_faces"],
        text: r#"// The triangle of that number.
fn numbered_triangle(number: u32) -> Triangle {
    let face = mesh_faces[number];
    let at = face.corners;
    return Triangle(mesh_corners[at.x], mesh_corners[at.y], mesh_corners[at.z], face.shell);
}"#,
    },
    Declaration {
        module: "shared/numbered",
        name: "numbered_pixel",
        sampling: None,
        uses: &["PixelIn", "numbered_triangle", "pixel_of"],
        text: r#"// The ray through a point of the picture that meets the triangle of that number.
fn numbered_pixel(triangle: u32, side: f32, point: vec2f) -> PixelIn {
    let met = numbered_triangle(triangle);
    return pixel_of(met.a, met.b, met.c, met.shell, side, point);
}"#,
    },
    Declaration {
        module: "shared/object",
        name: "Image",
        sampling: None,
        uses: &[],
        text: r#"// An image: the rows that give a point's texture coordinates, its height and its depth, by products
// with (x, y, z, 1). Texture coordinates and height come multiplied by the depth, which is 1 for
// parallel rays. Then its place among the images (first corner and extent, in texture coordinates
// of all); the unit direction against which it looks; and whether it looks from an eye, that eye,
// and the depth at which its view begins.
struct Image {
    u: vec4f,
    v: vec4f,
    height: vec4f,
    depth: vec4f,
    corner: vec2f,
    extent: vec2f,
    toward: vec3f,
    has_eye: bool,
    eye: vec3f,
    nearest: f32,
}"#,
    },
    Declaration {
        module: "shared/object",
        name: "image_of_object",
        sampling: None,
        uses: &["Image", "object_texel"],
        text: r#"fn image_of_object(number: u32) -> Image {
    let row = i32(number);
    let place = object_texel(vec2i(3, row));
    let toward = object_texel(vec2i(4, row));
    let has_eye = toward.w == 1.0;
    var depth = vec4f(0.0, 0.0, 0.0, 1.0);
    var eye = vec4f(0.0, 0.0, 0.0, 0.0);
    if (has_eye) {
        depth = object_texel(vec2i(5, row));
        eye = object_texel(vec2i(6, row));
    }
    return Image(
        object_texel(vec2i(0, row)),
        object_texel(vec2i(1, row)),
        object_texel(vec2i(2, row)),
        depth,
        place.xy,
        vec2f(place.z, place.w),
        toward.xyz,
        has_eye,
        eye.xyz,
        eye.w,
    );
}"#,
    },
    Declaration {
        module: "shared/object",
        name: "depth_in_image",
        sampling: None,
        uses: &["Image"],
        text: r#"// The depth of a point in front of an image's eye.
fn depth_in_image(image: Image, point: vec3f) -> f32 {
    return dot(image.depth.xyz, point) + image.depth.w;
}"#,
    },
    Declaration {
        module: "shared/object",
        name: "toward_image",
        sampling: None,
        uses: &["Image"],
        text: r#"// The unit direction from a point toward an image's viewer.
fn toward_image(image: Image, point: vec3f) -> vec3f {
    if (image.has_eye) {
        return normalize(image.eye - point);
    }
    return image.toward;
}"#,
    },
    Declaration {
        module: "shared/object",
        name: "tangent_of_image",
        sampling: None,
        uses: &["Image"],
        text: r#"// The tangent of an image: the vector in the world along one tile, which is as large as all images
// together, at depth 1. An eye looks at the middle of its image.
fn tangent_of_image(image: Image) -> vec3f {
    let across = image.u.xyz - 0.5 * image.depth.xyz;
    return across / (dot(across, across) * image.extent.x);
}"#,
    },
    Declaration {
        module: "shared/object",
        name: "bitangent_of_image",
        sampling: None,
        uses: &["Image"],
        text: r#"fn bitangent_of_image(image: Image) -> vec3f {
    let along = image.v.xyz - 0.5 * image.depth.xyz;
    return along / (dot(along, along) * image.extent.y);
}"#,
    },
    Declaration {
        module: "shared/object",
        name: "stretch_in_image",
        sampling: None,
        uses: &["Image", "depth_in_image", "surface_settings", "toward_image"],
        text: r#"// The metres toward the viewer over which the height in an image changes by 1 at a point, relative
// to parallel rays.
fn stretch_in_image(image: Image, point: vec3f, height: f32) -> f32 {
    if (!image.has_eye) {
        return 1.0;
    }
    let toward = toward_image(image, point);
    let change = dot(image.height.xyz, toward) - height * dot(image.depth.xyz, toward);
    return depth_in_image(image, point) / (change * surface_settings.scale_m);
}"#,
    },
    Declaration {
        module: "shared/object",
        name: "SEEN_TEXELS",
        sampling: None,
        uses: &[],
        text: r#"// For an image to show a place, the greatest distance between the place and the surface that the
// image has there, in texel widths of the image. Smaller, and slopes are not seen; larger, and what
// lies close behind is.
const SEEN_TEXELS = 2.0;"#,
    },
    Declaration {
        module: "shared/object",
        name: "UNSEEN",
        sampling: None,
        uses: &[],
        text: r#"// The angle, in turns, that is added for an image that does not see a place: more than any angle.
const UNSEEN = 2.0;"#,
    },
    Declaration {
        module: "shared/object",
        name: "place_in_image",
        sampling: None,
        uses: &["Image", "depth_in_image"],
        text: r#"// Where a point is in an image: texture coordinates in all of them, and a height.
fn place_in_image(image: Image, point: vec3f) -> vec3f {
    let depth = depth_in_image(image, point);
    let u = clamp((dot(image.u.xyz, point) + image.u.w) / depth, 0.0, 1.0);
    let v = clamp((dot(image.v.xyz, point) + image.v.w) / depth, 0.0, 1.0);
    let h = (dot(image.height.xyz, point) + image.height.w) / depth;
    return vec3f(image.corner + image.extent * vec2f(u, v), h);
}"#,
    },
    Declaration {
        module: "shared/object",
        name: "angle_to_image",
        sampling: None,
        uses: &["Image", "SEEN_TEXELS", "UNSEEN", "depth_in_image", "height_at", "place_in_image", "stretch_in_image", "surface_settings", "tangent_of_image", "toward_image", "turn_of"],
        text: r#"// The angle, in turns, between the view and the image's view. It is larger than any angle if
// `asked` and the image does not see the place.
fn angle_to_image(image: Image, point: vec3f, view: vec3f, asked: bool) -> f32 {
    let toward = toward_image(image, point);
    let beside = cross(toward, view);
    let angle = turn_of(vec2f(dot(toward, view), sqrt(dot(beside, beside))));
    if (!asked) {
        return angle;
    }
    let place = place_in_image(image, point);
    // Distance over which a texel is wide there.
    let width = image.extent.x * f32(surface_settings.height_size.x);
    let wider = length(tangent_of_image(image)) * image.extent.x * depth_in_image(image, point);
    let deeper = stretch_in_image(image, point, place.z) * surface_settings.scale_m;
    let off = abs(place.z - height_at(place.xy, 0u));
    return angle + select(UNSEEN, 0.0, off * width * (deeper / wider) <= SEEN_TEXELS);
}"#,
    },
    Declaration {
        module: "shared/object",
        name: "object_color",
        sampling: None,
        uses: &["Entered", "UNSEEN", "angle_to_image", "color_at", "image_of_object", "place_in_image", "surface_settings"],
        text: r#"// The colour of the object at a point, seen along `view`. It mixes the three images whose
// directions are nearest to the view. Their weights fall with the angle, to 0 at the angle of the
// fourth image.
//
// Kautz and Seidel 2001, section 4.2. There the weights are proportional to the angles, as printed,
// and jump when another image becomes the third; these neither do.
fn object_color(at: Entered, view: vec3f, asked: bool) -> vec3f {
    var angle1 = 4.0;
    var angle2 = 4.0;
    var angle3 = 4.0;
    var angle4 = 4.0;
    var image1 = 0u;
    var image2 = 0u;
    var image3 = 0u;
    var k = 0u;
    while (k < surface_settings.images) {
        let angle = angle_to_image(image_of_object(k), at.point, view, asked);
        if (angle < angle1) {
            angle4 = angle3;
            angle3 = angle2;
            image3 = image2;
            angle2 = angle1;
            image2 = image1;
            angle1 = angle;
            image1 = k;
        } else if (angle < angle2) {
            angle4 = angle3;
            angle3 = angle2;
            image3 = image2;
            angle2 = angle;
            image2 = k;
        } else if (angle < angle3) {
            angle4 = angle3;
            angle3 = angle;
            image3 = k;
        } else if (angle < angle4) {
            angle4 = angle;
        }
        k = k + 1u;
    }
    // If no image sees the place, all count.
    let less = select(0.0, UNSEEN, angle1 >= UNSEEN);
    let last = min(angle4 - less, 0.5);
    var weight1 = max(1.0 - (angle1 - less) / last, 0.0);
    var weight2 = max(1.0 - (angle2 - less) / last, 0.0);
    var weight3 = max(1.0 - (angle3 - less) / last, 0.0);
    if (!(weight1 + weight2 + weight3 > 0.0)) {
        weight1 = 1.0;
        weight2 = select(0.0, 1.0, angle2 == angle1);
        weight3 = select(0.0, 1.0, angle3 == angle1);
    }
    let uv1 = place_in_image(image_of_object(image1), at.point).xy;
    let uv2 = place_in_image(image_of_object(image2), at.point).xy;
    let uv3 = place_in_image(image_of_object(image3), at.point).xy;
    let first = color_at(uv1, 0u).xyz * weight1;
    let sum = first + color_at(uv2, 0u).xyz * weight2 + color_at(uv3, 0u).xyz * weight3;
    return sum * (1.0 / (weight1 + weight2 + weight3));
}"#,
    },
    Declaration {
        module: "shared/object",
        name: "AGREED",
        sampling: None,
        uses: &[],
        text: r#"// The part of a distance by which two images may differ about a place: a few roundings. Smaller,
// and rays go round for long between images of the same surface; larger, and rays pass what is
// thinner.
const AGREED = 0.000002;"#,
    },
    Declaration {
        module: "shared/object",
        name: "MOST_ROUNDS",
        sampling: None,
        uses: &[],
        text: r#"// The most rounds of a ray. Images of the same surface send it on between them by ever less.
const MOST_ROUNDS = 256u;"#,
    },
    Declaration {
        module: "shared/object",
        name: "first_in_all",
        sampling: None,
        uses: &["AGREED", "Entered", "FirstHit", "Hit", "MOST_ROUNDS", "NO_COST", "PixelIn", "beginning_at", "hit_on_segment", "metres_on", "miss", "segment_of", "trace"],
        text: r#"// The first point of a ray at which all images allow the object.
fn first_in_all(pixel: PixelIn, at: Entered) -> FirstHit {
    var cost = NO_COST;
    var first = FirstHit(miss(cost), 0u, 0.0);
    var reached = 0.0;
    var agreed = 0u;
    var k = 0u;
    var turns = 0u;
    let most = at.segments * MOST_ROUNDS;
    while (agreed < at.segments && turns < most) {
        let path = segment_of(pixel, at, k);
        let passed_m = max(reached - path.start, 0.0);
        let ahead = 1.0 + path.bend * passed_m;
        let passed = passed_m / ahead;
        if (!(ahead > 0.0 && passed < path.exit)) {
            first.hit = miss(cost);
            return first;
        }
        let hit = trace(beginning_at(path, passed));
        cost = cost + hit.cost;
        if (hit.found == 0u) {
            first.hit = miss(cost);
            return first;
        }
        let t = passed + hit.t;
        let at_m = path.start + metres_on(path, t);
        if (first.hit.found == 0u || at_m > reached + reached * AGREED) {
            reached = at_m;
            agreed = 0u;
            first = hit_on_segment(pixel, at, path, Hit(1u, 0u, hit.uv, hit.height, t, cost), k);
            cost = first.hit.cost;
        }
        agreed = agreed + 1u;
        k = select(k + 1u, 0u, k + 1u == at.segments);
        turns = turns + 1u;
    }
    first.hit.exhausted = select(0u, 1u, agreed < at.segments);
    first.hit.cost = cost;
    return first;
}"#,
    },
    Declaration {
        module: "shared/object_color",
        name: "color_of_object",
        sampling: None,
        uses: &["Entered", "color_of_frames", "object_color", "surface_settings"],
        text: r#"// The colour of the object seen along `view`. `how` is the setting `object.color`, which chooses
// the images.
fn color_of_object(at: Entered, view: vec3f, how: f32) -> vec3f {
    if (surface_settings.has_color != 1u || how == 2.0) {
        return vec3f(1.0, 1.0, 1.0);
    }
    if (how == 3.0) {
        return color_of_frames(at, view);
    }
    return object_color(at, view, how == 1.0);
}"#,
    },
    Declaration {
        module: "shared/object_path",
        name: "within_bounds",
        sampling: None,
        uses: &["NEVER"],
        text: r#"// The part of an interval in which x + dx t is between two bounds.
fn within_bounds(x: f32, dx: f32, low: f32, high: f32, interval: vec2f) -> vec2f {
    if (dx == 0.0) {
        if (x < low || x > high) {
            return vec2f(NEVER, 0.0);
        }
        return interval;
    }
    let a = (low - x) / dx;
    let b = (high - x) / dx;
    return vec2f(max(interval.x, min(a, b)), min(interval.y, max(a, b)));
}"#,
    },
    Declaration {
        module: "shared/object_path",
        name: "beyond_image",
        sampling: None,
        uses: &["Image", "height_size"],
        text: r#"// The width of an image's border, in its own texture coordinates: to the centres of the texels
// around it, which see nothing.
fn beyond_image(image: Image) -> vec2f {
    return vec2f(0.5, 0.5) / (image.extent * height_size(0u));
}"#,
    },
    Declaration {
        module: "shared/object_path",
        name: "metric_of_image",
        sampling: None,
        uses: &["Image", "bitangent_of_image", "surface_settings", "tangent_of_image"],
        text: r#"// `Path.metric` of an image at that depth.
fn metric_of_image(image: Image, depth: f32) -> vec4f {
    let tangent = tangent_of_image(image) * depth;
    let bitangent = bitangent_of_image(image) * depth;
    return vec4f(
        dot(tangent, tangent),
        dot(tangent, bitangent),
        dot(bitangent, bitangent),
        surface_settings.scale_m,
    );
}"#,
    },
    Declaration {
        module: "shared/object_path",
        name: "OnImage",
        sampling: None,
        uses: &[],
        text: r#"// A point as an image sees it: the texture coordinates, the value that is compared with the map,
// and the map.
struct OnImage {
    uv: vec2f,
    height: f32,
    map: f32,
    // Whether it is in the space that the image looks at.
    is_inside: bool,
}"#,
    },
    Declaration {
        module: "shared/object_path",
        name: "on_image",
        sampling: None,
        uses: &["CELLS_MASK", "EMPTY_HEIGHT", "Image", "OnImage", "beyond_image", "cell_of", "depth_in_image", "height_size", "object_cell_stage", "object_parts_stage", "surface_settings"],
        text: r#"fn on_image(image: Image, point: vec3f) -> OnImage {
    let depth = depth_in_image(image, point);
    let u = (dot(image.u.xyz, point) + image.u.w) / depth;
    let v = (dot(image.v.xyz, point) + image.v.w) / depth;
    let h = (dot(image.height.xyz, point) + image.height.w) / depth;
    let beyond = beyond_image(image);
    let beside = max(abs(u - 0.5) - beyond.x, abs(v - 0.5) - beyond.y);
    let uv = image.corner + image.extent * vec2f(u, v);
    let at = (uv * height_size(0u) - vec2f(0.5, 0.5)) * f32(object_parts_stage(0u));
    let cell = cell_of(at);
    let part = at - cell;
    let heights = object_cell_stage(vec2i(cell), 0u);
    let top = heights.x + (heights.y - heights.x) * part.x;
    let bottom = heights.z + (heights.w - heights.z) * part.x;
    let map = top + (bottom - top) * part.y;
    let is_inside = depth > 0.0 && beside <= 0.5 && h > EMPTY_HEIGHT && h <= 1.0;
    return OnImage(uv, select(h, 0.5, surface_settings.cells == CELLS_MASK), map, is_inside);
}"#,
    },
    Declaration {
        module: "shared/object_path",
        name: "BEFORE_EYE",
        sampling: None,
        uses: &[],
        text: r#"// The part of the way from an eye to its nearest visible point at which rays begin.
const BEFORE_EYE = 0.01;"#,
    },
    Declaration {
        module: "shared/object_path",
        name: "path_through_image",
        sampling: None,
        uses: &["BEFORE_EYE", "CELLS_MASK", "EMPTY_HEIGHT", "NEVER", "Path", "PixelIn", "RAY_VIEW", "beyond_image", "depth_in_image", "image_of_object", "metric_of_image", "surface_settings", "within_bounds"],
        text: r#"// A ray's path through image `k`. The path has the image's number in place of `base`.
fn path_through_image(pixel: PixelIn, k: u32) -> Path {
    let along = normalize(pixel.direction);
    let image = image_of_object(k);
    // An image does not see behind its eye.
    let deepens = dot(image.depth.xyz, along);
    let before = depth_in_image(image, pixel.origin);
    var begin = 0.0;
    if (image.has_eye) {
        let nearest = BEFORE_EYE * image.nearest;
        begin = select(0.0, NEVER, before < nearest);
        if (before < nearest && deepens > 0.0) {
            begin = (nearest - before) / deepens;
        }
    }
    let origin = pixel.origin + along * begin;
    let depth = depth_in_image(image, origin);
    let bend = deepens / depth;
    let u = (dot(image.u.xyz, origin) + image.u.w) / depth;
    let v = (dot(image.v.xyz, origin) + image.v.w) / depth;
    let h = (dot(image.height.xyz, origin) + image.height.w) / depth;
    let du = (dot(image.u.xyz, along) - u * deepens) / depth;
    let dv = (dot(image.v.xyz, along) - v * deepens) / depth;
    let dh = (dot(image.height.xyz, along) - h * deepens) / depth;
    let beyond = beyond_image(image);
    var interval = vec2f(0.0, NEVER);
    interval = within_bounds(u, du, 0.0 - beyond.x, 1.0 + beyond.x, interval);
    interval = within_bounds(v, dv, 0.0 - beyond.y, 1.0 + beyond.y, interval);
    interval = within_bounds(h, dh, EMPTY_HEIGHT, 1.0, interval);
    // From there on the parameter is again about metres.
    let start = interval.x;
    let nearer = 1.0 - bend * start;
    let change = nearer * nearer;
    var height = vec3f(h + dh * start, dh * change, 0.0);
    if (surface_settings.cells == CELLS_MASK) {
        // The surface of the mask is where it is a half.
        height = vec3f(0.5, 0.0, 0.0);
    }
    return Path(
        image.corner + image.extent * vec2f(u + du * start, v + dv * start),
        image.extent * vec2f(du, dv) * change,
        height,
        (interval.y - start) / change,
        f32(k),
        metric_of_image(image, depth / nearer),
        RAY_VIEW,
        0u,
        begin + start / nearer,
        1.0,
        bend * nearer,
    );
}"#,
    },
    Declaration {
        module: "shared/object_path",
        name: "rise_of_mask",
        sampling: None,
        uses: &["cell_of", "height_size", "object_cell_stage"],
        text: r#"// The change of a mask from texel to texel at texture coordinates, along u and v.
fn rise_of_mask(uv: vec2f) -> vec2f {
    let at = uv * height_size(0u) - vec2f(0.5, 0.5);
    let cell = cell_of(at);
    let h = object_cell_stage(vec2i(cell), 0u);
    let part = at - cell;
    return vec2f(
        (h.y - h.x) * (1.0 - part.y) + (h.w - h.z) * part.y,
        (h.z - h.x) * (1.0 - part.x) + (h.w - h.y) * part.x,
    );
}"#,
    },
    Declaration {
        module: "shared/object_path",
        name: "normal_of_mask",
        sampling: None,
        uses: &["Image", "rise_of_mask"],
        text: r#"// The normal of a silhouette: across the view, away from where the mask grows. Where the mask is
// level, `within` stands in for it.
fn normal_of_mask(image: Image, uv: vec2f, within: vec3f) -> vec3f {
    let rise = rise_of_mask(uv);
    let place = (uv - image.corner) / image.extent;
    let along_u = normalize(image.u.xyz - image.depth.xyz * place.x);
    let along_v = normalize(image.v.xyz - image.depth.xyz * place.y);
    let outward = vec3f(0.0, 0.0, 0.0) - along_u * rise.x - along_v * rise.y;
    let square = dot(outward, outward);
    if (square > 0.0) {
        return outward / sqrt(square);
    }
    return within;
}"#,
    },
    Declaration {
        module: "shared/object_path",
        name: "polished_on_image",
        sampling: None,
        uses: &["Hit", "Path", "metres_on"],
        text: r#"// A hit of a path through an image, with t in metres.
fn polished_on_image(path: Path, hit: Hit) -> Hit {
    var polished = hit;
    polished.t = metres_on(path, hit.t);
    return polished;
}"#,
    },
    Declaration {
        module: "shared/object_path",
        name: "placed_in_image",
        sampling: None,
        uses: &["CELLS_MASK", "Entered", "Hit", "Path", "PixelIn", "bitangent_of_image", "depth_in_image", "image_of_object", "normal_of_mask", "stretch_in_image", "surface_settings", "tangent_of_image", "toward_image"],
        text: r#"// The placed hit: on the ray, in the image's own frame.
fn placed_in_image(pixel: PixelIn, at: Entered, path: Path, hit: Hit) -> Entered {
    let image = image_of_object(u32(path.base));
    var placed = at;
    placed.point = pixel.origin + normalize(pixel.direction) * (path.start + hit.t);
    placed.uv = hit.uv;
    let depth = depth_in_image(image, placed.point);
    let nearer = stretch_in_image(image, placed.point, hit.height);
    placed.tangent = tangent_of_image(image) * depth / nearer;
    placed.bitangent = bitangent_of_image(image) * depth / nearer;
    placed.normal = toward_image(image, placed.point);
    if (surface_settings.has_normal == 1u) {
        // Normal maps have the image's own axes.
        placed.normal = image.toward;
    }
    placed.metric = path.metric;
    placed.facing = image.toward;
    if (surface_settings.cells == CELLS_MASK) {
        // Silhouettes run along the view.
        placed.normal = normal_of_mask(image, hit.uv, image.toward);
        placed.facing = placed.normal;
    }
    return placed;
}"#,
    },
    Declaration {
        module: "shared/patch_normal",
        name: "patch_normal",
        sampling: None,
        uses: &["Entered", "height_and_slope", "surface_settings"],
        text: r#"// The unit normal of the surface's patch, or of the triangle, at a placed hit.
fn patch_normal(at: Entered, uv: vec2f) -> vec3f {
    if (surface_settings.has_vertex_normals == 1u) {
        let facet = normalize(at.facing);
        return facet * select(-1.0, 1.0, dot(facet, at.normal) >= 0.0);
    }
    let known = height_and_slope(uv, at.level);
    let along_u = at.tangent + at.normal * (known.y * surface_settings.scale_m);
    let along_v = at.bitangent + at.normal * (known.z * surface_settings.scale_m);
    let across = normalize(cross(along_v, along_u));
    return across * select(-1.0, 1.0, dot(across, at.normal) >= 0.0);
}"#,
    },
    Declaration {
        module: "shared/path",
        name: "FLOOR",
        sampling: None,
        uses: &[],
        text: r#"// A path that ends at or below this height has crossed every level of the map; it misses only by
// rounding. Larger, and paths that end at the footprint's edge hit what is not there; smaller, and
// paths through a valley floor leak.
const FLOOR = 0.000001;"#,
    },
    Declaration {
        module: "shared/path",
        name: "BELOW_FLOOR",
        sampling: None,
        uses: &[],
        text: r#"// A descending path ends this much, relatively, below the lowest level of the map, so that rounding cannot
// let it end above a floor. Larger costs steps below the floor; smaller than an ulp of f32 lets paths leak
// through.
const BELOW_FLOOR = 1.000001;"#,
    },
    Declaration {
        module: "shared/path",
        name: "path_uv",
        sampling: None,
        uses: &["Path"],
        text: r#"fn path_uv(path: Path, t: f32) -> vec2f {
    return path.uv + path.duv * t;
}"#,
    },
    Declaration {
        module: "shared/path",
        name: "path_height",
        sampling: None,
        uses: &["Path"],
        text: r#"fn path_height(path: Path, t: f32) -> f32 {
    return path.h.x + t * (path.h.y + t * path.h.z);
}"#,
    },
    Declaration {
        module: "shared/path",
        name: "metres_on",
        sampling: None,
        uses: &["Path"],
        text: r#"// Metres along the ray from the entry to t.
fn metres_on(path: Path, t: f32) -> f32 {
    return t / (1.0 - path.bend * t);
}"#,
    },
    Declaration {
        module: "shared/path",
        name: "path_slope",
        sampling: None,
        uses: &["Path"],
        text: r#"// Change of the height with t.
fn path_slope(path: Path, t: f32) -> f32 {
    return path.h.y + 2.0 * t * path.h.z;
}"#,
    },
    Declaration {
        module: "shared/path",
        name: "path_gap",
        sampling: None,
        uses: &["Path", "field_gap_stage"],
        text: r#"// The path's gap to the surface: positive outside. Over heights it is the height of the path above the
// surface. One read.
fn path_gap(path: Path, t: f32) -> f32 {
    return field_gap_stage(path, t);
}"#,
    },
    Declaration {
        module: "shared/path",
        name: "flattened",
        sampling: None,
        uses: &["BELOW_FLOOR", "NEVER", "Path", "first_root", "path_slope", "path_uv"],
        text: r#"// The path through a relief whose heights are drawn toward `middle` by `part`, which is below 1.
// The path is steeper by as much, so that it meets the relief where the given path meets the
// flatter one.
fn flattened(path: Path, middle: f32, part: f32) -> Path {
    let kept = 1.0 - part;
    let top = middle + (1.0 - middle) * kept;
    // The path begins where the given path comes down to the flatter relief's top.
    let above = path.h.x - top;
    let begins = above > 0.0;
    var start = 0.0;
    if (begins) {
        start = min(first_root(vec3f(above, path.h.y, path.h.z), path.exit), path.exit);
    }
    let height = select(middle + (path.h.x - middle) / kept, 1.0, begins);
    let h = vec3f(height, path_slope(path, start) / kept, path.h.z / kept);
    // It ends a little below the floor, as paths do, unless it ends elsewhere.
    let rest = path.exit - start;
    let exit = min(first_root(vec3f(max(h.x, 0.0), h.y, h.z), rest) * BELOW_FLOOR, rest);
    // A limit that is never reached: compilers would cancel the summand of `uv` here against `base`
    // there.
    let base = clamp(path.base - start, 0.0 - NEVER, NEVER);
    return Path(
        path_uv(path, start),
        path.duv,
        h,
        exit,
        base,
        path.metric,
        path.ray,
        path.level,
        path.start + start,
        path.share,
        path.bend,
    );
}"#,
    },
    Declaration {
        module: "shared/path",
        name: "beginning_at",
        sampling: None,
        uses: &["Path", "path_height", "path_slope", "path_uv"],
        text: r#"// The path from a parameter on.
fn beginning_at(path: Path, t: f32) -> Path {
    return Path(
        path_uv(path, t),
        path.duv,
        vec3f(path_height(path, t), path_slope(path, t), path.h.z),
        path.exit - t,
        path.base,
        path.metric,
        path.ray,
        path.level,
        path.start + t,
        path.share,
        path.bend,
    );
}"#,
    },
    Declaration {
        module: "shared/path",
        name: "miss",
        sampling: None,
        uses: &["Hit"],
        text: r#"fn miss(cost: vec3u) -> Hit {
    return Hit(0u, 0u, vec2f(0.0, 0.0), 0.0, 0.0, cost);
}"#,
    },
    Declaration {
        module: "shared/path",
        name: "leaves_at_exit",
        sampling: None,
        uses: &["FLOOR", "Path", "field_is_ground_stage", "path_height"],
        text: r#"// Whether a path has left the relief without a hit when it ends. Over heights one that has crossed the floor
// by then has hit it.
fn leaves_at_exit(path: Path) -> bool {
    return path_height(path, path.exit) > FLOOR || !field_is_ground_stage(path.level);
}"#,
    },
    Declaration {
        module: "shared/path",
        name: "hit_on_path",
        sampling: None,
        uses: &["Hit", "Path", "leaves_at_exit", "miss", "path_height", "path_uv"],
        text: r#"// A hit on the path. Beyond the exit there is none, unless the path has crossed the floor by then.
fn hit_on_path(path: Path, t: f32, exhausted: u32, cost: vec3u) -> Hit {
    if (t > path.exit && leaves_at_exit(path)) {
        return miss(cost);
    }
    let inside = clamp(t, 0.0, path.exit);
    return Hit(1u, exhausted, path_uv(path, inside), path_height(path, inside), inside, cost);
}"#,
    },
    Declaration {
        module: "shared/path",
        name: "starting_point",
        sampling: None,
        uses: &["FOUND_BELOW", "FOUND_BRACKET", "FOUND_UNBRACKETED", "Path", "SearchResult"],
        text: r#"// The point where the one-point refinements begin: the processed point if nothing was searched,
// otherwise the known point nearest to the hit.
fn starting_point(path: Path, found: SearchResult) -> f32 {
    if (found.status == FOUND_UNBRACKETED) {
        return path.base;
    }
    if (found.status == FOUND_BRACKET || found.status == FOUND_BELOW) {
        return found.far;
    }
    return found.near;
}"#,
    },
    Declaration {
        module: "shared/path_axes",
        name: "TOUCHING_BEND",
        sampling: None,
        uses: &[],
        text: r#"// The bend β at which a path just touches height 0. Paths of a greater bend come back to height 1.
const TOUCHING_BEND = 0.25;"#,
    },
    Declaration {
        module: "shared/path_axes",
        name: "PathAxes",
        sampling: None,
        uses: &[],
        text: r#"// A path's axes, each from 0 to 1.
struct PathAxes {
    // 1 if the path comes in at the top, or would have come in there before it begins.
    comes_in: u32,
    // Azimuth in turns, elevation from upright to level, and the place of the bend: ½ for a straight path.
    turn: f32,
    elevation: f32,
    bend: f32,
    // The parameter at height 1, not above 0, and its change on the whole way to
    // height 0, or back to height 1.
    start: f32,
    whole: f32,
    // The part F of the way per unit of t: the height's fall at the top.
    fall: f32,
}"#,
    },
    Declaration {
        module: "shared/path_axes",
        name: "path_axes",
        sampling: None,
        uses: &["Path", "PathAxes", "TOUCHING_BEND", "turn_of", "upright"],
        text: r#"// The axes of a path, of a map for that depth of a relief as a part of a tile's side. Where the place at the
// top lies in a mirrored image of the map, the azimuth is the mirrored path's.
fn path_axes(path: Path, depth: f32) -> PathAxes {
    let below = path.h.x - 1.0;
    var start = 0.0;
    var fall = 0.0 - path.h.y;
    if (below < 0.0) {
        let discriminant = path.h.y * path.h.y - 4.0 * path.h.z * below;
        fall = sqrt(max(discriminant, 0.0));
        start = 2.0 * below / (fall - path.h.y);
    }
    let bend = path.h.z / (fall * fall);
    let speed = length(path.duv);
    var way = 1.0 / bend;
    if (bend < TOUCHING_BEND) {
        way = 2.0 / (1.0 + sqrt(1.0 - 4.0 * bend));
    }
    let whole = way / fall;
    // No path has been inside for longer than the whole way.
    let comes_in = fall > 0.0 && whole > 0.0 && start >= whole * -1.001;
    return PathAxes(
        select(0u, 1u, comes_in),
        turn_of(path.duv * upright(path.uv + path.duv * start)),
        speed / (speed + depth * fall),
        0.5 + 0.5 * (bend / (TOUCHING_BEND + abs(bend))),
        start,
        whole,
        fall,
    );
}"#,
    },
    Declaration {
        module: "shared/path_axes",
        name: "upright",
        sampling: None,
        uses: &["WRAP_MIRROR", "surface_settings"],
        text: r#"// -1 along each axis on which a place lies in a mirrored image of the map; otherwise 1.
fn upright(uv: vec2f) -> vec2f {
    let tile = floor(uv);
    let is_odd = tile - 2.0 * floor(tile * 0.5) > vec2f(0.5, 0.5);
    if (surface_settings.wrap != WRAP_MIRROR) {
        return vec2f(1.0, 1.0);
    }
    return select(vec2f(1.0, 1.0), vec2f(-1.0, -1.0), is_odd);
}"#,
    },
    Declaration {
        module: "shared/path_axes",
        name: "step_of_axis",
        sampling: None,
        uses: &[],
        text: r#"// The number of a step of an axis of `count` steps, counted from 0, that a place from 0 to 1 lies in.
fn step_of_axis(place: f32, count: f32) -> f32 {
    return clamp(floor(place * count), 0.0, count - 1.0);
}"#,
    },
    Declaration {
        module: "shared/path_axes",
        name: "longest_of_step",
        sampling: None,
        uses: &[],
        text: r#"// The longest whole way F of paths whose bend lies in a step of that axis of `count` steps, as
// the map of free ways has it.
fn longest_of_step(bend: f32, count: f32) -> f32 {
    if (count == 1.0) {
        return 1.0;
    }
    let low = 2.0 * bend / count - 1.0;
    let high = low + 2.0 / count;
    // Up to ½ paths reach height 0, the last of them after twice the way of a straight one.
    if (high < 0.500001) {
        return 2.0 / (1.0 + sqrt(max(1.0 - high / (1.0 - abs(high)), 0.0)));
    }
    let least = max(low, 0.5);
    return 4.0 * (1.0 - least) / least;
}"#,
    },
    Declaration {
        module: "shared/path_axes",
        name: "row_of_bend",
        sampling: None,
        uses: &[],
        text: r#"// The row of a texel of the map in the block of a bend.
fn row_of_bend(row: i32, bend: f32, rows: i32) -> i32 {
    return row + i32(bend) * rows;
}"#,
    },
    Declaration {
        module: "shared/pixel",
        name: "pixel_eye",
        sampling: None,
        uses: &["frame"],
        text: r#"// Origin of the ray through a point of the picture, in pixels from its top-left corner.
fn pixel_eye(pixel: vec2f) -> vec3f {
    return frame.eye.xyz + frame.eye_right.xyz * pixel.x + frame.eye_down.xyz * pixel.y;
}"#,
    },
    Declaration {
        module: "shared/pixel",
        name: "pixel_direction",
        sampling: None,
        uses: &["frame"],
        text: r#"// Direction of the ray through a point of the picture.
fn pixel_direction(pixel: vec2f) -> vec3f {
    return frame.corner.xyz + frame.right.xyz * pixel.x + frame.down.xyz * pixel.y;
}"#,
    },
    Declaration {
        module: "shared/pixel",
        name: "pixel_of",
        sampling: None,
        uses: &["Corner", "PixelIn", "Shell", "pixel_direction", "pixel_eye"],
        text: r#"// A pixel's ray, through a point in pixels from the picture's top-left corner, and the triangle that it
// meets.
fn pixel_of(a: Corner, b: Corner, c: Corner, shell: Shell, side: f32, point: vec2f) -> PixelIn {
    return PixelIn(pixel_eye(point), pixel_direction(point), side, a, b, c, shell);
}"#,
    },
    Declaration {
        module: "shared/pixel",
        name: "enter_relief",
        sampling: None,
        uses: &["Entered", "PixelIn", "detail_stage", "surface_enter_stage"],
        text: r#"// The ray at the base surface, with its level of detail.
fn enter_relief(pixel: PixelIn) -> Entered {
    var at = surface_enter_stage(pixel);
    if (at.segments == 0u) {
        return at;
    }
    let detail = detail_stage(pixel, at);
    at.level = detail.level;
    at.footprint = detail.footprint;
    at.fade = detail.fade;
    return at;
}"#,
    },
    Declaration {
        module: "shared/pixel",
        name: "segment_of",
        sampling: None,
        uses: &["Entered", "Path", "PixelIn", "faded", "surface_segment_stage"],
        text: r#"// A segment of the ray's way through the relief, by its number. A segment that ends where it
// begins, or before, is empty.
fn segment_of(pixel: PixelIn, at: Entered, k: u32) -> Path {
    return faded(surface_segment_stage(pixel, at, k), at.fade);
}"#,
    },
    Declaration {
        module: "shared/pixel",
        name: "faded",
        sampling: None,
        uses: &["Path", "flattened", "surface_settings"],
        text: r#"// A segment through the relief that is drawn toward its mean by a part, below 1.
fn faded(segment: Path, part: f32) -> Path {
    var path = segment;
    if (part > 0.0) {
        path = flattened(path, surface_settings.mean_height, part);
        // Where the map ends, a ray may come in below the floor of the flatter relief.
        if (!(path.h.x > 0.0)) {
            path.exit = 0.0;
        }
    }
    return path;
}"#,
    },
    Declaration {
        module: "shared/pixel",
        name: "trace",
        sampling: None,
        uses: &["Hit", "Path", "refine_stage", "search_stage"],
        text: r#"// Search and refinement: the part that another tracer may replace.
fn trace(path: Path) -> Hit {
    return refine_stage(path, search_stage(path));
}"#,
    },
    Declaration {
        module: "shared/pixel",
        name: "first_hit",
        sampling: None,
        uses: &["Entered", "FirstHit", "PixelIn", "object_stage"],
        text: r#"// The first hit of a pixel's ray.
fn first_hit(pixel: PixelIn, at: Entered) -> FirstHit {
    return object_stage(pixel, at);
}"#,
    },
    Declaration {
        module: "shared/pixel",
        name: "polish_hit",
        sampling: None,
        uses: &["Entered", "Hit", "Path", "PixelIn", "surface_polish_stage"],
        text: r#"// A hit on a segment, moved onto the segment's ray.
fn polish_hit(pixel: PixelIn, at: Entered, path: Path, hit: Hit) -> Hit {
    return surface_polish_stage(pixel, at, path, hit);
}"#,
    },
    Declaration {
        module: "shared/pixel",
        name: "hit_on_segment",
        sampling: None,
        uses: &["Entered", "FirstHit", "Hit", "Path", "PixelIn", "depth_on_ray", "in_hole", "key_of", "polish_hit"],
        text: r#"// The result of search and refinement on segment `k`, as the first hit of the ray: moved onto the
// ray, and a miss in a hole.
fn hit_on_segment(pixel: PixelIn, at: Entered, path: Path, found: Hit, k: u32) -> FirstHit {
    var first = FirstHit(found, k, 0.0);
    if (found.found == 1u) {
        let hit = polish_hit(pixel, at, path, found);
        first = FirstHit(hit, k, key_of(depth_on_ray(pixel, path, hit)));
        if (in_hole(hit.uv)) {
            first.hit.found = 0u;
        }
    }
    return first;
}"#,
    },
    Declaration {
        module: "shared/pixel",
        name: "depth_on_ray",
        sampling: None,
        uses: &["Hit", "Path", "PixelIn"],
        text: r#"// Distance of a hit on its ray: metres along the view axis.
fn depth_on_ray(pixel: PixelIn, path: Path, hit: Hit) -> f32 {
    return (path.start + hit.t) / length(pixel.direction);
}"#,
    },
    Declaration {
        module: "shared/pixel",
        name: "key_of",
        sampling: None,
        uses: &["frame"],
        text: r#"// A key that orders the hits of a pixel's ray: the greater, the nearer. It has as many bits for far
// hits as for near ones.
fn key_of(depth: f32) -> f32 {
    return frame.near / (frame.near + max(depth, 0.0));
}"#,
    },
    Declaration {
        module: "shared/pixel",
        name: "z_of",
        sampling: None,
        uses: &["frame"],
        text: r#"// The value of a depth buffer for a depth. Beyond the planes of the clip space it is not clamped.
//
// Oliveira and Policarpo 2005, section 3.5.
fn z_of(depth: f32) -> f32 {
    if (frame.clip.y == 0.0) {
        return clamp(frame.clip.x + frame.clip.z * depth, 0.0, 1.0);
    }
    return clamp(frame.clip.x + frame.clip.y / max(depth, 0.0), 0.0, 1.0);
}"#,
    },
    Declaration {
        module: "shared/pixel",
        name: "place_hit",
        sampling: None,
        uses: &["Entered", "Hit", "PixelIn", "place_on_segment", "segment_of"],
        text: r#"// A hit on the displaced surface: its place in the world, and the frame there.
fn place_hit(pixel: PixelIn, at: Entered, segment: u32, hit: Hit) -> Entered {
    return place_on_segment(pixel, at, segment_of(pixel, at, segment), hit);
}"#,
    },
    Declaration {
        module: "shared/pixel",
        name: "place_on_segment",
        sampling: None,
        uses: &["Entered", "Hit", "Path", "PixelIn", "depth_on_ray", "surface_place_stage"],
        text: r#"// The placed hit of a segment.
fn place_on_segment(pixel: PixelIn, at: Entered, path: Path, hit: Hit) -> Entered {
    var placed = surface_place_stage(pixel, at, path, hit);
    placed.depth = depth_on_ray(pixel, path, hit);
    return placed;
}"#,
    },
    Declaration {
        module: "shared/pixel",
        name: "color_or_white",
        sampling: None,
        uses: &["color_at", "levels_of", "surface_settings"],
        text: r#"fn color_or_white(uv: vec2f, footprint: f32) -> vec3f {
    if (surface_settings.has_color != 1u) {
        return vec3f(1.0, 1.0, 1.0);
    }
    let levels = levels_of(footprint * surface_settings.color_texels, surface_settings.color_levels);
    let fine = color_at(uv, levels.fine).xyz;
    if (levels.part > 0.0) {
        return fine + (color_at(uv, levels.fine + 1u).xyz - fine) * levels.part;
    }
    return fine;
}"#,
    },
    Declaration {
        module: "shared/pixel",
        name: "reflected_light",
        sampling: None,
        uses: &["Entered", "Hit", "MAX_LIGHTS", "SeenNormals", "ambient_stage", "frame", "seen_cosine", "shade_light_stage", "shade_material_stage", "toward_light"],
        text: r#"// The light that leaves a hit along `view`, toward the eye, in linear RGB: the ambient light, the
// surface's own light, and the shading of each light, times the part of it that arrives.
fn reflected_light(
    at: Entered,
    hit: Hit,
    seen: SeenNormals,
    view: vec3f,
    color: vec3f,
    visible: array<vec4f, MAX_LIGHTS>,
) -> vec3f {
    let material = shade_material_stage(at, hit, seen.normal, seen.length, view, color);
    let around = ambient_stage(at, hit, seen.normal * seen.length, view, material);
    var light = around * material.occlusion + material.emission;
    var k = 0u;
    while (k < frame.light_count) {
        let toward = toward_light(k, at.point);
        let cosine = seen_cosine(at, seen, toward.direction);
        let reflected = shade_light_stage(material, seen.normal, seen.length, cosine, view, toward.direction);
        light = light + reflected * frame.lights[k].color.xyz * (toward.falloff * visible[k].x);
        k = k + 1u;
    }
    return light;
}"#,
    },
    Declaration {
        module: "shared/pixel",
        name: "point_of_light",
        sampling: None,
        uses: &["Entered", "Hit", "Toward", "point_of_disc", "seed_of", "toward_light"],
        text: r#"// The light of that number from a placed hit: point `k` of `count` on its disc, or its centre where `count`
// is 0.
fn point_of_light(at: Entered, hit: Hit, number: u32, k: u32, count: u32) -> Toward {
    let toward = toward_light(number, at.point);
    if (count > 0u) {
        return point_of_disc(toward, seed_of(hit), k, count);
    }
    return toward;
}"#,
    },
    Declaration {
        module: "shared/pixel",
        name: "ray_to_light",
        sampling: None,
        uses: &["Entered", "Hit", "LightRay", "field_light_ray_stage", "point_of_light"],
        text: r#"// The ray from a placed hit to that point of the light.
fn ray_to_light(at: Entered, hit: Hit, number: u32, k: u32, count: u32) -> LightRay {
    return field_light_ray_stage(at, hit, point_of_light(at, hit, number, k, count));
}"#,
    },
    Declaration {
        module: "shared/pixel",
        name: "visible_lights",
        sampling: None,
        uses: &["Entered", "Hit", "MAX_LIGHTS", "frame", "visible_light"],
        text: r#"// The part of each light that arrives at a placed hit, from 0 to 1, as the first of four numbers.
fn visible_lights(at: Entered, hit: Hit) -> array<vec4f, MAX_LIGHTS> {
    var visible = array<vec4f, MAX_LIGHTS>();
    if (hit.found == 0u) {
        return visible;
    }
    var k = 0u;
    while (k < frame.light_count) {
        visible[k] = vec4f(visible_light(at, hit, k), 0.0, 0.0, 0.0);
        k = k + 1u;
    }
    return visible;
}"#,
    },
    Declaration {
        module: "shared/pixel",
        name: "visible_light",
        sampling: None,
        uses: &["Entered", "Hit", "shadow_stage", "toward_light"],
        text: r#"// The part of one light that arrives at a placed hit, from 0 to 1.
fn visible_light(at: Entered, hit: Hit, number: u32) -> f32 {
    return shadow_stage(at, hit, toward_light(number, at.point));
}"#,
    },
    Declaration {
        module: "shared/pixel",
        name: "mirrored_light",
        sampling: None,
        uses: &["Entered", "Hit", "NEVER", "PixelIn", "Toward", "shadow_stage"],
        text: r#"// The part of a light that arrives at a placed hit. The light has a disc of some degrees, and its
// direction is the pixel's ray after a mirror in the base surface. So it is above the relief
// wherever the ray came from.
fn mirrored_light(pixel: PixelIn, at: Entered, hit: Hit) -> f32 {
    if (hit.found == 0u) {
        return 0.0;
    }
    let down = normalize(pixel.direction);
    let up = down - at.normal * (2.0 * dot(down, at.normal));
    return shadow_stage(at, hit, Toward(up, 1.0, NEVER, 0.125 * abs(down.x), 0u));
}"#,
    },
    Declaration {
        module: "shared/pixel",
        name: "shade_hit",
        sampling: None,
        uses: &["Entered", "Hit", "MAX_LIGHTS", "PixelOut", "cell_of", "field_height_stage", "field_normals_stage", "frame", "height_size", "object_color_stage", "reflected_light", "surface_settings", "z_of"],
        text: r#"// The shaded pixel at a placed hit. `visible` holds the parts of the lights that arrive, `origin`
// is the beginning of the ray.
fn shade_hit(origin: vec3f, at: Entered, hit: Hit, visible: array<vec4f, MAX_LIGHTS>) -> PixelOut {
    if (hit.found == 0u) {
        return PixelOut(
            vec4f(0.0, 0.0, 0.0, 0.0),
            0u,
            0u,
            vec2f(0.0, 0.0),
            0.0,
            vec3f(0.0, 0.0, 0.0),
            vec3f(0.0, 0.0, 0.0),
            0.0,
            0.0,
            vec2i(0, 0),
            hit.cost.x,
            hit.cost.y,
            hit.cost.z,
            0.0,
            0u,
            0.0,
            0u,
            1.0,
        );
    }
    let height = field_height_stage(hit.uv, hit.height, at.level);
    let view = normalize(origin - at.point);
    let seen = field_normals_stage(at, hit, view);
    let color = reflected_light(at, hit, seen, view, object_color_stage(at, hit, view), visible);
    let depth = dot(at.point - origin, frame.forward.xyz);
    let cell = cell_of(hit.uv * height_size(0u) - vec2f(0.5, 0.5));
    return PixelOut(
        vec4f(color, 1.0),
        1u,
        hit.exhausted,
        hit.uv,
        height,
        at.point,
        seen.normal,
        depth,
        hit.t,
        vec2i(cell),
        hit.cost.x,
        hit.cost.y,
        hit.cost.z,
        visible[0].x,
        at.level,
        z_of(at.depth),
        surface_settings.number,
        1.0,
    );
}"#,
    },
    Declaration {
        module: "shared/pixel",
        name: "shade_pixel",
        sampling: None,
        uses: &["PixelIn", "PixelOut", "enter_relief", "first_hit", "place_hit", "shade_hit", "visible_lights"],
        text: r#"fn shade_pixel(pixel: PixelIn) -> PixelOut {
    let base = enter_relief(pixel);
    let first = first_hit(pixel, base);
    let at = place_hit(pixel, base, first.segment, first.hit);
    return shade_hit(pixel.origin, at, first.hit, visible_lights(at, first.hit));
}"#,
    },
    Declaration {
        module: "shared/pixel",
        name: "add_sample",
        sampling: None,
        uses: &[],
        text: r#"// The colour of a pixel's samples so far, with one more sample of that weight. The fourth part is
// the covered part of the pixel.
fn add_sample(sum: vec4f, color: vec4f, weight: f32) -> vec4f {
    return sum + color * weight;
}"#,
    },
    Declaration {
        module: "shared/quadric",
        name: "quadric_at",
        sampling: None,
        uses: &[],
        text: r#"// The height of a quadric at an offset in texture coordinates, in metres.
fn quadric_at(quadric: vec3f, duv: vec2f) -> f32 {
    return dot(quadric, vec3f(duv.x * duv.x, duv.x * duv.y, duv.y * duv.y));
}"#,
    },
    Declaration {
        module: "shared/quadric",
        name: "quadric_slope",
        sampling: None,
        uses: &[],
        text: r#"// The change of a quadric's height with texture coordinates.
fn quadric_slope(quadric: vec3f, duv: vec2f) -> vec2f {
    return vec2f(
        2.0 * quadric.x * duv.x + quadric.y * duv.y,
        quadric.y * duv.x + 2.0 * quadric.z * duv.y,
    );
}"#,
    },
    Declaration {
        module: "shared/quadric",
        name: "quadric_of",
        sampling: None,
        uses: &["PixelIn", "base_height", "lift_of", "ordered_weights", "plane_normal", "plane_weights", "surface_settings", "traced_scale_m"],
        text: r#"// The quadric at a point of the triangle, and the height of that point in the relief.
//
// Where relief would rise above its base, the host has moved the triangle out to height 1, as it is seen from
// its front; `lift` is 1 where the relief lies on a smooth base.
fn quadric_of(pixel: PixelIn, point: vec3f, lift: f32) -> vec4f {
    let w = plane_weights(pixel, plane_normal(pixel), point);
    let quadric = pixel.a.of_surface * w.x + pixel.b.of_surface * w.y + pixel.c.of_surface * w.z;
    var height = base_height();
    if (surface_settings.bias_m + surface_settings.scale_m > 0.0) {
        height = select(2.0 * height - 1.0, 1.0, pixel.side > 0.0);
    }
    let lifted = lift_of(pixel.shell.lift, ordered_weights(pixel.shell, w)) * (lift * pixel.side);
    return vec4f(quadric * pixel.side, height - lifted / traced_scale_m());
}"#,
    },
    Declaration {
        module: "shared/quadric",
        name: "bent_descent",
        sampling: None,
        uses: &["NEVER"],
        text: r#"// Metres along a ray to where it comes down to `depth` metres under the quadric, or NEVER.
// `descent` is the descent per metre at the quadric's point, `bend` the quadric's height there.
fn bent_descent(depth: f32, descent: f32, bend: f32) -> f32 {
    var t = NEVER;
    if (bend == 0.0) {
        if (descent > 0.0) {
            t = depth / descent;
        }
        return t;
    }
    let discriminant = descent * descent + 4.0 * bend * depth;
    if (discriminant > 0.0) {
        let root = sqrt(discriminant);
        if (descent > 0.0) {
            t = 2.0 * depth / (descent + root);
        } else {
            t = (root - descent) / (2.0 * bend);
        }
    }
    return t;
}"#,
    },
    Declaration {
        module: "shared/quadric",
        name: "bent_exit",
        sampling: None,
        uses: &["BELOW_FLOOR", "NEVER"],
        text: r#"// The parameter at which a path of these heights, the first of them at most 1, is a little below the floor or
// above the relief again.
fn bent_exit(h: vec3f) -> f32 {
    var exit = NEVER;
    let floor = h.x + (BELOW_FLOOR - 1.0);
    let under = h.y * h.y - 4.0 * h.z * floor;
    if (under >= 0.0) {
        if (h.y < 0.0) {
            exit = 2.0 * floor / (sqrt(under) - h.y);
        } else {
            if (h.z < 0.0) {
                exit = (h.y + sqrt(under)) / (-2.0 * h.z);
            }
        }
    }
    let room = 1.0 - h.x;
    let above = h.y * h.y + 4.0 * h.z * room;
    if (above >= 0.0) {
        if (h.y > 0.0) {
            exit = min(exit, 2.0 * room / (h.y + sqrt(above)));
        } else {
            if (h.z > 0.0) {
                exit = min(exit, (sqrt(above) - h.y) / (2.0 * h.z));
            }
        }
    }
    return exit;
}"#,
    },
    Declaration {
        module: "shared/quadric",
        name: "quadric_frame",
        sampling: None,
        uses: &["Entered", "quadric_slope"],
        text: r#"// The frame at an offset from the point, on the quadric: its tangents, and its normal.
fn quadric_frame(at: Entered, aside: vec2f) -> Entered {
    var placed = at;
    let slope = quadric_slope(at.of_surface.xyz, aside);
    if (slope.x == 0.0 && slope.y == 0.0) {
        return placed;
    }
    let m = at.metric;
    let area = m.x * m.z - m.y * m.y;
    let along_t = (slope.x * m.z - slope.y * m.y) / area;
    let along_b = (slope.y * m.x - slope.x * m.y) / area;
    placed.tangent = at.tangent + at.normal * slope.x;
    placed.bitangent = at.bitangent + at.normal * slope.y;
    placed.normal = normalize(at.normal - at.tangent * along_t - at.bitangent * along_b);
    let tt = dot(placed.tangent, placed.tangent);
    let tb = dot(placed.tangent, placed.bitangent);
    let bb = dot(placed.bitangent, placed.bitangent);
    placed.metric = vec4f(tt, tb, bb, m.w);
    return placed;
}"#,
    },
    Declaration {
        module: "shared/quartic",
        name: "Quartic",
        sampling: None,
        uses: &[],
        text: r#"// a + b x + c x² + d x³ + e x⁴
struct Quartic {
    a: f32,
    b: f32,
    c: f32,
    d: f32,
    e: f32,
}"#,
    },
    Declaration {
        module: "shared/quartic",
        name: "HALVINGS",
        sampling: None,
        uses: &[],
        text: r#"// Halvings of an interval from 0 to 1 until a place is known to the last bits.
const HALVINGS = 24u;"#,
    },
    Declaration {
        module: "shared/quartic",
        name: "quartic_at",
        sampling: None,
        uses: &["Quartic"],
        text: r#"fn quartic_at(q: Quartic, x: f32) -> f32 {
    return q.a + x * (q.b + x * (q.c + x * (q.d + x * q.e)));
}"#,
    },
    Declaration {
        module: "shared/quartic",
        name: "quartic_slope",
        sampling: None,
        uses: &["Quartic"],
        text: r#"fn quartic_slope(q: Quartic, x: f32) -> f32 {
    return q.b + x * (2.0 * q.c + x * (3.0 * q.d + x * (4.0 * q.e)));
}"#,
    },
    Declaration {
        module: "shared/quartic",
        name: "is_above_zero",
        sampling: None,
        uses: &["Quartic"],
        text: r#"// Whether a polynomial is above 0 from 0 to 1 for sure: its five control points are.
fn is_above_zero(q: Quartic) -> bool {
    let p1 = q.a + 0.25 * q.b;
    let p2 = q.a + 0.5 * q.b + q.c / 6.0;
    let p3 = q.a + 0.75 * q.b + 0.5 * q.c + 0.25 * q.d;
    let p4 = q.a + q.b + q.c + q.d + q.e;
    return min(min(min(q.a, p1), min(p2, p3)), p4) > 0.0;
}"#,
    },
    Declaration {
        module: "shared/quartic",
        name: "inflections",
        sampling: None,
        uses: &["Quartic"],
        text: r#"// The places at which the slope stops rising or falling, in order; 1 for each that is not between 0 and 1.
fn inflections(q: Quartic) -> vec2f {
    // Half of the second derivative is c + 3 d x + 6 e x².
    let b = 3.0 * q.d;
    let a = 6.0 * q.e;
    let discriminant = b * b - 4.0 * a * q.c;
    if (!(discriminant >= 0.0)) {
        return vec2f(1.0, 1.0);
    }
    let root = sqrt(discriminant);
    let s = -0.5 * (b + select(0.0 - root, root, b >= 0.0));
    let first = select(1.0, s / a, a != 0.0);
    let second = select(1.0, q.c / s, s != 0.0);
    let x = select(1.0, first, first > 0.0 && first < 1.0);
    let y = select(1.0, second, second > 0.0 && second < 1.0);
    return vec2f(min(x, y), max(x, y));
}"#,
    },
    Declaration {
        module: "shared/quartic",
        name: "extremum_between",
        sampling: None,
        uses: &["HALVINGS", "Quartic", "quartic_slope"],
        text: r#"// Where a polynomial is least or greatest between two places. Its slope has other signs there.
fn extremum_between(q: Quartic, from_x: f32, to_x: f32) -> f32 {
    var low = from_x;
    var high = to_x;
    let rises = quartic_slope(q, from_x) > 0.0;
    var k = 0u;
    while (k < HALVINGS) {
        let middle = 0.5 * (low + high);
        if ((quartic_slope(q, middle) > 0.0) == rises) {
            low = middle;
        } else {
            high = middle;
        }
        k = k + 1u;
    }
    return high;
}"#,
    },
    Declaration {
        module: "shared/quartic",
        name: "root_between",
        sampling: None,
        uses: &["HALVINGS", "Quartic", "quartic_at"],
        text: r#"// The root between a place where the polynomial is above 0 and one where it is not.
fn root_between(q: Quartic, above: f32, below: f32) -> f32 {
    var near = above;
    var far = below;
    var k = 0u;
    while (k < HALVINGS) {
        let middle = 0.5 * (near + far);
        if (quartic_at(q, middle) > 0.0) {
            near = middle;
        } else {
            far = middle;
        }
        k = k + 1u;
    }
    return far;
}"#,
    },
    Declaration {
        module: "shared/quartic",
        name: "first_root_of_quartic",
        sampling: None,
        uses: &["NEVER", "Quartic", "extremum_between", "inflections", "is_above_zero", "quartic_at", "quartic_slope", "root_between"],
        text: r#"// The first place from 0 to 1 at which a polynomial is not above 0; NEVER if there is none. Between two
// inflections it has one extremum at most, and is monotone on either side.
fn first_root_of_quartic(q: Quartic) -> f32 {
    if (!(q.a > 0.0)) {
        return 0.0;
    }
    if (is_above_zero(q)) {
        return NEVER;
    }
    let inner = inflections(q);
    var begin = 0.0;
    var k = 0u;
    while (k < 3u) {
        let end = select(select(1.0, inner.y, k == 1u), inner.x, k == 0u);
        if (end > begin) {
            let first = quartic_slope(q, begin);
            let last = quartic_slope(q, end);
            if (first < 0.0 && last > 0.0) {
                let least = extremum_between(q, begin, end);
                if (!(quartic_at(q, least) > 0.0)) {
                    return root_between(q, begin, least);
                }
            }
            if (!(quartic_at(q, end) > 0.0)) {
                return root_between(q, begin, end);
            }
        }
        begin = max(begin, end);
        k = k + 1u;
    }
    return NEVER;
}"#,
    },
    Declaration {
        module: "shared/random",
        name: "UNITS",
        sampling: None,
        uses: &[],
        text: r#"// Number of different values from 0 up to 1.
const UNITS = 16777216.0;"#,
    },
    Declaration {
        module: "shared/random",
        name: "mixed",
        sampling: None,
        uses: &[],
        text: r#"// Mixes the bits of a number; the same everywhere.
fn mixed(seed: u32) -> u32 {
    var x = seed ^ (seed >> 16u);
    x = x * 0x7feb352du;
    x = x ^ (x >> 15u);
    x = x * 0x846ca68bu;
    return x ^ (x >> 16u);
}"#,
    },
    Declaration {
        module: "shared/random",
        name: "unit_of",
        sampling: None,
        uses: &["UNITS"],
        text: r#"// A number from 0 up to 1.
fn unit_of(bits: u32) -> f32 {
    return f32(bits >> 8u) / UNITS;
}"#,
    },
    Declaration {
        module: "shared/random",
        name: "bits_of_point",
        sampling: None,
        uses: &["mixed"],
        text: r#"// The random bits of a point of a lattice that begins again after every `count` points.
fn bits_of_point(point: vec2f, count: f32, seed: u32) -> u32 {
    let within = point - floor(point / count) * count;
    return mixed(u32(within.x) + mixed(u32(within.y) + mixed(seed)));
}"#,
    },
    Declaration {
        module: "shared/rasterised",
        name: "Varying",
        sampling: None,
        uses: &[],
        text: r#"struct Varying {
    @builtin(position) position: vec4f,
    @location(0) @interpolate(flat) triangle: u32,
    // 1 or -1 if the side of the triangle is known, 0 if its winding decides.
    @location(1) @interpolate(flat) side: f32,
}"#,
    },
    Declaration {
        module: "shared/rasterised",
        name: "clip_of",
        sampling: None,
        uses: &["frame"],
        text: r#"// A point of the world in clip space.
fn clip_of(position: vec3f) -> vec4f {
    let columns = frame.view_projection;
    let view_projection = mat4x4f(columns[0], columns[1], columns[2], columns[3]);
    return view_projection * vec4f(position, 1.0);
}"#,
    },
    Declaration {
        module: "shared/rasterised",
        name: "clip_of_pass",
        sampling: None,
        uses: &["pass_settings"],
        text: r#"// A point of clip space, moved to the clip space of the pass.
fn clip_of_pass(clip: vec4f) -> vec4f {
    let x = clip.x + pass_settings.shift.x * clip.w;
    let y = clip.y * pass_settings.zoom + pass_settings.shift.y * clip.w;
    return vec4f(x, y, clip.z, clip.w);
}"#,
    },
    Declaration {
        module: "shared/rasterised",
        name: "point_of_pass",
        sampling: None,
        uses: &["pass_settings"],
        text: r#"// The point of the picture, in pixels from its top-left corner, for a point of the pass.
fn point_of_pass(position: vec2f) -> vec2f {
    return position + vec2f(0.0, f32(pass_settings.first_row)) + pass_settings.offset;
}"#,
    },
    Declaration {
        module: "shared/rasterised",
        name: "corner_varying",
        sampling: None,
        uses: &["Varying", "clip_of", "mesh_corners", "mesh_faces"],
        text: r#"// The vertex of that number, of three for each triangle.
fn corner_varying(vertex: u32) -> Varying {
    let triangle = vertex / 3u;
    let corner = vertex % 3u;
    let corners = mesh_faces[triangle].corners;
    let place = select(select(corners.z, corners.y, corner == 1u), corners.x, corner == 0u);
    return Varying(clip_of(mesh_corners[place].position), triangle, 0.0);
}"#,
    },
    Declaration {
        module: "shared/rasterised",
        name: "box_varying",
        sampling: None,
        uses: &["BOX_VERTICES", "Varying", "box_corner", "clip_of", "numbered_triangle"],
        text: r#"// A vertex of the box around a triangle's shell. The far sides of the box are drawn, and its whole
// volume is searched for the shell. If `turned` is 1, the triangle is turned over.
fn box_varying(vertex: u32, turned: u32) -> Varying {
    let triangle = vertex / BOX_VERTICES;
    let side = select(1.0, -1.0, turned == 1u);
    let position = box_corner(numbered_triangle(triangle), side, vertex % BOX_VERTICES);
    let clip = clip_of(position);
    // The hits decide about visibility; no plane cuts a box off.
    return Varying(vec4f(clip.xy, 0.5 * clip.w, clip.w), triangle, side);
}"#,
    },
    Declaration {
        module: "shared/rasterised",
        name: "side_of",
        sampling: None,
        uses: &["Varying"],
        text: r#"// The side of its triangle that a fragment sees.
fn side_of(in: Varying, front: bool) -> f32 {
    return select(select(-1.0, 1.0, front), in.side, in.side != 0.0);
}"#,
    },
    Declaration {
        module: "shared/records",
        name: "Face",
        sampling: None,
        uses: &["Shell"],
        text: r#"// A base triangle in buffers: the places of its corners among all of the mesh.
struct Face {
    corners: vec3u,
    shell: Shell,
}"#,
    },
    Declaration {
        module: "shared/records",
        name: "Triangle",
        sampling: None,
        uses: &["Corner", "Shell"],
        text: r#"// A base triangle, in the world.
struct Triangle {
    a: Corner,
    b: Corner,
    c: Corner,
    shell: Shell,
}"#,
    },
    Declaration {
        module: "shared/records",
        name: "ShellNode",
        sampling: None,
        uses: &[],
        text: r#"// A node of the hierarchy of boxes around the shells of triangles. The root is the first; the two children
// of a node follow each other, the first at an odd place, and along the node's axis it lies lower.
struct ShellNode {
    low: vec3f,
    // For a node with children the place of the first. For a leaf SHELL_TRIANGLE times its
    // triangle's number, plus SHELL_BOTH_SIDES if the triangle is seen turned over, too.
    first: u32,
    high: vec3f,
    // 16 times the place of the parent, plus 4 times the parent's axis, plus the node's own axis; a
    // leaf has 3 as its axis.
    above: u32,
}"#,
    },
    Declaration {
        module: "shared/records",
        name: "Record",
        sampling: None,
        uses: &[],
        text: r#"// A pixel as it is read back: 24 words.
struct Record {
    color: vec4f,
    position: vec3f,
    depth: f32,
    normal: vec3f,
    height: f32,
    uv: vec2f,
    t: f32,
    // 0 where the pixel shows no surface, 1 where it does, 3 where the search ran out of steps. To these,
    // 4 times the level of detail and 256 times the surface's number are added.
    hit: u32,
    cell: vec2i,
    reads: u32,
    steps: u32,
    bytes: u32,
    lit: f32,
    z: f32,
    transmittance: f32,
}"#,
    },
    Declaration {
        module: "shared/records",
        name: "Probe",
        sampling: None,
        uses: &[],
        text: r#"// Every stage's result for a ray, on the last segment that was traced.
struct Probe {
    // The number of that segment, counted from 1; 0 if there was none.
    segment: u32,
    entry: vec2f,
    duv: vec2f,
    exit: f32,
    base: f32,
    h: vec3f,
    status: u32,
    near: f32,
    far: f32,
    found: u32,
    exhausted: u32,
    uv: vec2f,
    height: f32,
    t: f32,
    reads: u32,
    steps: u32,
    bytes: u32,
    // The part of `mirrored_light` that arrives at the hit.
    lit: f32,
    // The key that orders the hit among others of the ray.
    key: f32,
}"#,
    },
    Declaration {
        module: "shared/records",
        name: "nothing_seen",
        sampling: None,
        uses: &["Record"],
        text: r#"// The record of a pixel that shows no surface.
fn nothing_seen() -> Record {
    var record = Record();
    record.transmittance = 1.0;
    return record;
}"#,
    },
    Declaration {
        module: "shared/seen_normals",
        name: "LEAST_UPRIGHT",
        sampling: None,
        uses: &[],
        text: r#"// Three lower limits: of the upright part of a normal that is turned into a slope; of the deviation
// of slopes; of the visible part of an area.
const LEAST_UPRIGHT = 0.05;"#,
    },
    Declaration {
        module: "shared/seen_normals",
        name: "LEAST_DEVIATION",
        sampling: None,
        uses: &[],
        text: r#"const LEAST_DEVIATION = 0.0001;"#,
    },
    Declaration {
        module: "shared/seen_normals",
        name: "LEAST_SEEN",
        sampling: None,
        uses: &[],
        text: r#"const LEAST_SEEN = 0.001;"#,
    },
    Declaration {
        module: "shared/seen_normals",
        name: "MOST",
        sampling: None,
        uses: &[],
        text: r#"// An upper limit of any visible part of a normal times a cosine.
const MOST = 1000000.0;"#,
    },
    Declaration {
        module: "shared/seen_normals",
        name: "TABLE_TEXELS",
        sampling: None,
        uses: &[],
        text: r#"// The reciprocal of the width of a table's texel, in texels of the height map.
const TABLE_TEXELS = 0.25;"#,
    },
    Declaration {
        module: "shared/seen_normals",
        name: "LEAST_WIDTH",
        sampling: None,
        uses: &[],
        text: r#"// The least width of a footprint whose normals are taken together.
const LEAST_WIDTH = 0.5;"#,
    },
    Declaration {
        module: "shared/seen_normals",
        name: "APART",
        sampling: None,
        uses: &[],
        text: r#"// Deviations between the mean slope and the four outer slopes; then the parts of the area with the
// mean slope and with each of the others.
const APART = 1.7320508;"#,
    },
    Declaration {
        module: "shared/seen_normals",
        name: "MIDDLE",
        sampling: None,
        uses: &[],
        text: r#"const MIDDLE = 0.33333334;"#,
    },
    Declaration {
        module: "shared/seen_normals",
        name: "OUTER",
        sampling: None,
        uses: &[],
        text: r#"const OUTER = 0.16666667;"#,
    },
    Declaration {
        module: "shared/seen_normals",
        name: "Normals",
        sampling: None,
        uses: &[],
        text: r#"// The means of the normals n and the slopes s in an area, in tangent space. n is (-sx, -sy, 1) nz.
struct Normals {
    // nx, ny, nz, sx
    first: vec4f,
    // sx² nz, sx sy nz, sy² nz, sy
    second: vec4f,
}"#,
    },
    Declaration {
        module: "shared/seen_normals",
        name: "SeenNormals",
        sampling: None,
        uses: &["SeenTable"],
        text: r#"// The normals within a footprint as an eye sees them.
struct SeenNormals {
    // The direction of the mean normal, in the world.
    normal: vec3f,
    // The length of the mean normal: 1 where all are the same.
    length: f32,
    // 1 where the normals differ. The members below are known only then, in tangent space.
    differ: u32,
    // The normal in the middle and its slope, and the change of normals and slopes in a deviation
    // along two axes. The others are APART of these changes beside it, two on each axis.
    middle: vec3f,
    along: vec3f,
    across: vec3f,
    slope: vec2f,
    slope_along: vec2f,
    slope_across: vec2f,
    // The squared cosine between the base's normal and the view.
    upright: f32,
    // The visible part of a slope for each of the five, relative to all of them.
    middle_seen: f32,
    others_seen: vec4f,
    // The weight of the table of directions in place of the five normals, and the table's values.
    table_part: f32,
    table: SeenTable,
}"#,
    },
    Declaration {
        module: "shared/seen_normals",
        name: "one_seen",
        sampling: None,
        uses: &["SeenNormals", "no_table"],
        text: r#"// A single normal, as every eye sees it.
fn one_seen(normal: vec3f) -> SeenNormals {
    let nothing = vec2f(0.0, 0.0);
    let none = vec3f(0.0, 0.0, 0.0);
    let parts = vec4f(0.0, 0.0, 0.0, 0.0);
    let table = no_table();
    return SeenNormals(
        normal, 1.0, 0u, none, none, none, nothing, nothing, nothing, 1.0, 0.0, parts, 0.0, table
    );
}"#,
    },
    Declaration {
        module: "shared/seen_normals",
        name: "no_table",
        sampling: None,
        uses: &["SeenTable"],
        text: r#"fn no_table() -> SeenTable {
    let none = vec3f(0.0, 0.0, 0.0);
    return SeenTable(none, none, none);
}"#,
    },
    Declaration {
        module: "shared/seen_normals",
        name: "means_of_one",
        sampling: None,
        uses: &["LEAST_UPRIGHT", "Normals"],
        text: r#"// The means of one normal.
fn means_of_one(n: vec3f) -> Normals {
    let upright = max(n.z, LEAST_UPRIGHT);
    let slope = vec2f(-n.x, -n.y) / upright;
    let square = slope * slope * upright;
    return Normals(
        vec4f(n, slope.x),
        vec4f(square.x, slope.x * slope.y * upright, square.y, slope.y),
    );
}"#,
    },
    Declaration {
        module: "shared/seen_normals",
        name: "normals_of_level",
        sampling: None,
        uses: &["Entered", "Normals", "normal_layers", "surface_settings"],
        text: r#"// The normals in the texels of a level from 1 on.
fn normals_of_level(at: Entered, uv: vec2f, level: u32) -> Normals {
    let has_normal = surface_settings.has_normal == 1u;
    let read = normal_layers(uv, select(level - 1u, level, has_normal));
    if (has_normal) {
        return Normals(read.first, read.second);
    }
    // Derived normals hold for tiles of other lengths: where a tile is longer, slopes are as much flatter.
    let tile = surface_settings.normal_tile_m;
    let x = tile.x * dot(normalize(at.tangent), at.tangent) / dot(at.tangent, at.tangent);
    let y = tile.y * dot(normalize(at.bitangent), at.bitangent) / dot(at.bitangent, at.bitangent);
    let first = read.first;
    let second = read.second;
    // The tangential parts keep their length. So the normal stands more upright, and with it
    // everything that it weights.
    let flatter = vec3f(first.x * x, first.y * y, first.z);
    let longer = sqrt(dot(first.xyz, first.xyz) / dot(flatter, flatter));
    let squares = vec3f(second.x * x * x, second.y * x * y, second.z * y * y) * longer;
    return Normals(vec4f(flatter * longer, first.w * x), vec4f(squares, second.w * y));
}"#,
    },
    Declaration {
        module: "shared/seen_normals",
        name: "facing_four",
        sampling: None,
        uses: &["APART"],
        text: r#"// The greater of 0 and each of the four values beside `middle`, which differ from it by these along
// the axes.
fn facing_four(middle: f32, along: f32, across: f32) -> vec4f {
    let x = along * APART;
    let y = across * APART;
    return max(vec4f(middle + x, middle - x, middle + y, middle - y), vec4f(0.0, 0.0, 0.0, 0.0));
}"#,
    },
    Declaration {
        module: "shared/seen_normals",
        name: "mean_of_five",
        sampling: None,
        uses: &["MIDDLE", "OUTER"],
        text: r#"// The mean of five values. `four` is the sum of the four outer ones. Constants are factors of sums,
// not of summands: compilers turn the latter into the former.
fn mean_of_five(middle: f32, four: f32) -> f32 {
    return middle * MIDDLE + four * OUTER;
}"#,
    },
    Declaration {
        module: "shared/seen_normals",
        name: "sum_of_four",
        sampling: None,
        uses: &[],
        text: r#"fn sum_of_four(four: vec4f) -> f32 {
    return (four.x + four.y) + (four.z + four.w);
}"#,
    },
    Declaration {
        module: "shared/seen_normals",
        name: "seen_normals",
        sampling: None,
        uses: &["APART", "Entered", "LEAST_DEVIATION", "LEAST_SEEN", "LEAST_UPRIGHT", "Normals", "OUTER", "SeenNormals", "facing_four", "from_tangent_space", "mean_of_five", "no_table", "sum_of_four", "to_tangent_space"],
        text: r#"// The normals of an area as an eye in direction `view` sees them. A part of the area with slope s
// covers as much of its view as v - s, that is vz - (vx sx + vy sy). It covers nothing where that
// is below 0.
fn seen_normals(at: Entered, normals: Normals, view: vec3f) -> SeenNormals {
    let first = normals.first;
    let second = normals.second;
    let slope = vec2f(first.w, second.w);
    // The spread of slopes: the root of their covariance in triangular form.
    let upright = max(first.z, LEAST_UPRIGHT);
    let x = first.x / upright;
    let y = first.y / upright;
    let a = max(sqrt(max(second.x / upright - x * x, 0.0)), LEAST_DEVIATION);
    let b = (second.y / upright - x * y) / a;
    // Below 0 by rounding alone.
    let spread = max(second.z / upright - y * y, 0.0);
    let d = max(sqrt(max(spread - b * b, 0.0)), LEAST_DEVIATION);
    // The covariance of normals and slopes: the mean of n times s, less the product of the means.
    let with_x = -vec3f(second.x, second.y, first.x) - first.xyz * slope.x;
    let with_y = -vec3f(second.y, second.z, first.y) - first.xyz * slope.y;
    // In a deviation of the slopes normals change by no more than slopes do in all, and by 1 at
    // most. Larger values come from dividing rounding errors by tiny numbers.
    let most = min(sqrt(a * a + spread), 1.0);
    let along = with_x / max(a, length(with_x) / most);
    let rest = with_y - along * b;
    let across = rest / max(d, length(rest) / most);

    let v = to_tangent_space(at, view);
    let middle = v.z - dot(v.xy, slope);
    let four = facing_four(middle, -(v.x * a + v.y * b), -(v.y * d));
    let one = max(middle, 0.0);
    let all = max(mean_of_five(one, sum_of_four(four)), LEAST_SEEN);
    let aside = along * ((four.x - four.y) / all) + across * ((four.z - four.w) / all);
    let mean = from_tangent_space(at, first.xyz + aside * (APART * OUTER));
    return SeenNormals(
        normalize(mean),
        min(length(mean), 1.0),
        1u,
        first.xyz,
        along,
        across,
        slope,
        vec2f(a, b),
        vec2f(0.0, d),
        max(v.z, 0.0) * max(v.z, 0.0),
        one / all,
        four / all,
        0.0,
        no_table(),
    );
}"#,
    },
    Declaration {
        module: "shared/seen_normals",
        name: "table_part",
        sampling: None,
        uses: &["Entered", "TABLE_TEXELS", "surface_settings"],
        text: r#"// The weight of the table of directions: as far as the relief is traced flat, and where a footprint
// is wider than the table's texels.
fn table_part(at: Entered) -> f32 {
    if (surface_settings.has_normal == 1u) {
        return 0.0;
    }
    return at.fade * clamp(at.footprint * TABLE_TEXELS - 1.0, 0.0, 1.0);
}"#,
    },
    Declaration {
        module: "shared/seen_normals",
        name: "with_table",
        sampling: None,
        uses: &["Entered", "SeenNormals", "SeenTable", "from_tangent_space"],
        text: r#"// The same normals, with the table of directions mixed in by that weight.
fn with_table(at: Entered, seen: SeenNormals, table: SeenTable, part: f32) -> SeenNormals {
    var blended = seen;
    let before = seen.normal * seen.length;
    let mean = before + (from_tangent_space(at, table.mean) - before) * part;
    blended.normal = normalize(mean);
    blended.length = min(length(mean), 1.0);
    blended.table_part = part;
    blended.table = table;
    return blended;
}"#,
    },
    Declaration {
        module: "shared/seen_normals",
        name: "seen_cosine",
        sampling: None,
        uses: &["Entered", "LEAST_SEEN", "MOST", "SeenNormals", "facing_four", "mean_of_five", "sum_of_four", "surface_settings", "table_cosine", "to_tangent_space"],
        text: r#"// The mean cosine between the visible normals and a light's direction; normals that face away count
// 0. Where the relief casts shadows, less of it is lit: as much light falls on all parts as on the
// base. What is seen from the side lies high, and less of it is in shadow.
fn seen_cosine(at: Entered, seen: SeenNormals, toward: vec3f) -> f32 {
    if (seen.differ == 0u) {
        return max(dot(seen.normal, toward), 0.0);
    }
    let l = to_tangent_space(at, toward);
    let middle = dot(seen.middle, l);
    let four = facing_four(middle, dot(seen.along, l), dot(seen.across, l));
    // Limits that are never reached: compilers would add these products in another order.
    let one = min(seen.middle_seen * max(middle, 0.0), MOST);
    let others = min(dot(seen.others_seen, four), MOST);
    var cosine = mean_of_five(one, others);
    if (seen.table_part > 0.0) {
        cosine = cosine + (table_cosine(seen.table, l) - cosine) * seen.table_part;
    }
    if (surface_settings.has_shadows == 1u) {
        let falls = l.z - dot(l.xy, seen.slope);
        let facing = facing_four(falls, -dot(l.xy, seen.slope_along), -dot(l.xy, seen.slope_across));
        let all = mean_of_five(max(falls, 0.0), sum_of_four(facing));
        let lit = max(falls, 0.0) / max(all, LEAST_SEEN);
        return cosine * (1.0 - (1.0 - lit) * seen.upright);
    }
    return cosine;
}"#,
    },
    Declaration {
        module: "shared/seen_normals",
        name: "mesostructure_normals",
        sampling: None,
        uses: &["Entered", "LEAST_WIDTH", "Normals", "SeenNormals", "finest_normal", "has_table", "levels_of", "means_of_one", "normals_of_level", "one_seen", "seen_normals", "surface_settings", "table_of", "table_part", "to_tangent_space", "with_table"],
        text: r#"// The normals within the footprint of a point that an eye in direction `view` sees.
fn mesostructure_normals(at: Entered, uv: vec2f, view: vec3f) -> SeenNormals {
    if (surface_settings.has_vertex_normals == 1u) {
        return one_seen(at.normal);
    }
    // At the side the traced level shows by itself which of its parts face the eye: only what is finer than
    // it is left to be weighed. A flat one shows nothing.
    let upright = dot(at.normal, view);
    let shown = max(upright, LEAST_WIDTH);
    let width = shown + (1.0 - shown) * at.fade;
    let texels = at.footprint * surface_settings.normal_texels * width;
    let levels = levels_of(texels, surface_settings.normal_levels);
    var first = vec4f(0.0, 0.0, 0.0, 0.0);
    var second = first;
    if (levels.fine == 0u) {
        let normal = finest_normal(at, uv);
        if (!(levels.part > 0.0)) {
            return one_seen(normal);
        }
        let fine = means_of_one(to_tangent_space(at, normal));
        first = fine.first;
        second = fine.second;
    } else {
        let fine = normals_of_level(at, uv, levels.fine);
        first = fine.first;
        second = fine.second;
    }
    if (levels.part > 0.0) {
        let coarse = normals_of_level(at, uv, levels.fine + 1u);
        first = first + (coarse.first - first) * levels.part;
        second = second + (coarse.second - second) * levels.part;
    }
    let seen = seen_normals(at, Normals(first, second), view);
    let part = table_part(at);
    if (part > 0.0) {
        let of_table = levels_of(at.footprint, surface_settings.height_levels);
        if (has_table(of_table)) {
            return with_table(at, seen, table_of(at, uv, view, of_table), part);
        }
    }
    return seen;
}"#,
    },
    Declaration {
        module: "shared/seen_table",
        name: "MOST_SEEN",
        sampling: None,
        uses: &[],
        text: r#"// An upper limit of all means.
const MOST_SEEN = 16.0;"#,
    },
    Declaration {
        module: "shared/seen_table",
        name: "INNER_DEVIATIONS",
        sampling: None,
        uses: &[],
        text: r#"// Four cosines stand for a cosine that is spread by a deviation: two pairs at these numbers of
// deviations beside it, each with its part of the whole (Gauss and Hermite).
const INNER_DEVIATIONS = 0.7419638;"#,
    },
    Declaration {
        module: "shared/seen_table",
        name: "OUTER_DEVIATIONS",
        sampling: None,
        uses: &[],
        text: r#"const OUTER_DEVIATIONS = 2.3344142;"#,
    },
    Declaration {
        module: "shared/seen_table",
        name: "PARTS_OF_FOUR",
        sampling: None,
        uses: &[],
        text: r#"const PARTS_OF_FOUR = vec4f(0.45412415, 0.45412415, 0.04587585, 0.04587585);"#,
    },
    Declaration {
        module: "shared/seen_table",
        name: "SeenTable",
        sampling: None,
        uses: &[],
        text: r#"// Means of the visible normals, in tangent space, and of the products of their parts.
struct SeenTable {
    mean: vec3f,
    // x², y², z²
    squares: vec3f,
    // xy, xz, yz
    products: vec3f,
}"#,
    },
    Declaration {
        module: "shared/seen_table",
        name: "SeenTexel",
        sampling: None,
        uses: &[],
        text: r#"// One direction's values in a texel.
struct SeenTexel {
    // x, y, z, x²
    first: vec4f,
    // xy, y², xz, yz
    second: vec4f,
}"#,
    },
    Declaration {
        module: "shared/seen_table",
        name: "seen_between",
        sampling: None,
        uses: &["SeenTexel"],
        text: r#"fn seen_between(a: SeenTexel, b: SeenTexel, part: f32) -> SeenTexel {
    return SeenTexel(a.first + (b.first - a.first) * part, a.second + (b.second - a.second) * part);
}"#,
    },
    Declaration {
        module: "shared/seen_table",
        name: "SeenPlace",
        sampling: None,
        uses: &["Around", "Levels"],
        text: r#"// A place between two levels of detail: the texels around it in either.
struct SeenPlace {
    fine: Around,
    coarse: Around,
    levels: Levels,
}"#,
    },
    Declaration {
        module: "shared/seen_table",
        name: "seen_texel",
        sampling: None,
        uses: &["Around", "SEEN_ELEVATIONS", "SeenTexel", "detail_texel_between"],
        text: r#"// The values of a direction around a place, in a level of detail.
fn seen_texel(at: Around, azimuth: i32, elevation: i32, level: u32) -> SeenTexel {
    let layer = 2 * (azimuth * i32(SEEN_ELEVATIONS) + elevation);
    return SeenTexel(detail_texel_between(at, layer, level), detail_texel_between(at, layer + 1, level));
}"#,
    },
    Declaration {
        module: "shared/seen_table",
        name: "seen_in_levels",
        sampling: None,
        uses: &["SeenPlace", "SeenTexel", "seen_between", "seen_texel"],
        text: r#"// The values of a direction around a place, between two levels.
fn seen_in_levels(at: SeenPlace, azimuth: i32, elevation: i32) -> SeenTexel {
    let fine = seen_texel(at.fine, azimuth, elevation, at.levels.fine);
    if (at.levels.part > 0.0) {
        return seen_between(
            fine, seen_texel(at.coarse, azimuth, elevation, at.levels.fine + 1u), at.levels.part
        );
    }
    return fine;
}"#,
    },
    Declaration {
        module: "shared/seen_table",
        name: "has_table",
        sampling: None,
        uses: &["Levels", "SLOT_DETAIL", "surface_settings"],
        text: r#"// Whether levels of detail have a table.
fn has_table(levels: Levels) -> bool {
    return levels.fine >= surface_settings.maps[SLOT_DETAIL].first_level;
}"#,
    },
    Declaration {
        module: "shared/seen_table",
        name: "table_of",
        sampling: None,
        uses: &["Entered", "Levels", "SEEN_AZIMUTHS", "SEEN_ELEVATIONS", "SLOT_DETAIL", "SeenPlace", "SeenTable", "climb", "height_texels", "seen_between", "seen_in_levels", "surface_settings", "texels_around", "turn_of"],
        text: r#"// The visible normals around a place for an eye in direction `view`, between the four directions of
// the table around it.
fn table_of(at: Entered, uv: vec2f, view: vec3f, levels: Levels) -> SeenTable {
    // The view in the metric that the map was baked in.
    let change = climb(at, view);
    let tile = surface_settings.maps[SLOT_DETAIL].tile_m;
    let toward = vec3f(change.xy * tile, change.z * surface_settings.scale_m);
    let up = toward.z / length(toward);
    let elevation = clamp(up * f32(SEEN_ELEVATIONS) - 1.0, 0.0, f32(SEEN_ELEVATIONS) - 1.0);
    let azimuth = turn_of(toward.xy) * f32(SEEN_AZIMUTHS);
    let a0 = i32(floor(azimuth)) % i32(SEEN_AZIMUTHS);
    let a1 = (a0 + 1) % i32(SEEN_AZIMUTHS);
    let e0 = i32(floor(elevation));
    let e1 = min(e0 + 1, i32(SEEN_ELEVATIONS) - 1);
    let across = azimuth - floor(azimuth);
    let place = SeenPlace(
        texels_around(uv, height_texels(levels.fine)),
        texels_around(uv, height_texels(levels.fine + 1u)),
        levels,
    );
    let low = seen_between(seen_in_levels(place, a0, e0), seen_in_levels(place, a1, e0), across);
    let high = seen_between(seen_in_levels(place, a0, e1), seen_in_levels(place, a1, e1), across);
    let seen = seen_between(low, high, elevation - floor(elevation));
    // Where a tile is longer than it was baked for, slopes are as much flatter; normals stay as long.
    let x = tile.x * dot(normalize(at.tangent), at.tangent) / dot(at.tangent, at.tangent);
    let y = tile.y * dot(normalize(at.bitangent), at.bitangent) / dot(at.bitangent, at.bitangent);
    let mean = seen.first.xyz;
    let flatter = vec3f(mean.x * x, mean.y * y, mean.z);
    let squared = dot(mean, mean) / dot(flatter, flatter);
    let upright = max(1.0 - seen.first.w - seen.second.y, 0.0);
    return SeenTable(
        flatter * sqrt(squared),
        vec3f(seen.first.w * x * x, seen.second.y * y * y, upright) * squared,
        vec3f(seen.second.x * x * y, seen.second.z * x, seen.second.w * y) * squared,
    );
}"#,
    },
    Declaration {
        module: "shared/seen_table",
        name: "table_cosine",
        sampling: None,
        uses: &["INNER_DEVIATIONS", "MOST_SEEN", "OUTER_DEVIATIONS", "PARTS_OF_FOUR", "SeenTable"],
        text: r#"// The mean cosine between those normals and a direction in tangent space, 0 for those that face away.
fn table_cosine(table: SeenTable, toward: vec3f) -> f32 {
    let mean = dot(table.mean, toward);
    // Limits that are never reached: compilers would add these products in another order.
    let squares = min(dot(table.squares, toward * toward), MOST_SEEN);
    let pairs = vec3f(toward.x * toward.y, toward.x * toward.z, toward.y * toward.z);
    let products = min(2.0 * dot(table.products, pairs), MOST_SEEN);
    let deviation = sqrt(max(squares + products - mean * mean, 0.0));
    let inner = deviation * INNER_DEVIATIONS;
    let outer = deviation * OUTER_DEVIATIONS;
    let four = vec4f(mean + inner, mean - inner, mean + outer, mean - outer);
    return dot(max(four, vec4f(0.0, 0.0, 0.0, 0.0)), PARTS_OF_FOUR);
}"#,
    },
    Declaration {
        module: "shared/settings",
        name: "Light",
        sampling: None,
        uses: &[],
        text: r#"// A light: infinitely far away, or at a point.
struct Light {
    // Direction toward the light (w = 0), or its position (w = 1).
    place: vec4f,
    // Linear RGB: irradiance of a directional light, intensity of a point light. The fourth part is
    // the size of the light's disc: the tangent of half its angular diameter for a directional
    // light, its radius in metres for a point light.
    color: vec4f,
    // The first of the light's shadow maps among the frame's views, and their number.
    first_view: u32,
    views: u32,
}"#,
    },
    Declaration {
        module: "shared/settings",
        name: "LightView",
        sampling: None,
        uses: &[],
        text: r#"// A shadow map's camera: square, with parallel rays, or with rays from a point.
struct LightView {
    // Rows that give column and row in texels, and metres along the view axis, of a point of the
    // world. For rays from a point, divide column and row by the latter.
    column: vec4f,
    row: vec4f,
    depth: vec4f,
    // Origin of the ray through the upper left corner; for rays from a point its direction. Then
    // its change per texel to the right and downward, and the origin of rays from a point.
    corner: vec4f,
    across: vec4f,
    along: vec4f,
    eye: vec4f,
    // See `Frame`.
    near: f32,
    // Width of a texel in metres; at a distance of 1 m for rays from a point.
    texel_m: f32,
    // 1 if all rays begin in one point.
    from_point: u32,
    // Texels of a side.
    size: u32,
}"#,
    },
    Declaration {
        module: "shared/settings",
        name: "Frame",
        sampling: None,
        uses: &["Light", "LightView", "MAX_LIGHTS", "MAX_LIGHT_VIEWS"],
        text: r#"// Data that changes from frame to frame.
struct Frame {
    // The columns of the matrix from the world to clip space.
    view_projection: array<vec4f, 4>,
    // Origin of the ray through the picture's top-left corner, and its change per pixel to the
    // right and downward. The change is zero if all rays begin in one eye.
    eye: vec4f,
    eye_right: vec4f,
    eye_down: vec4f,
    // Unit view axis.
    forward: vec4f,
    // The direction of that ray, and its change per pixel; the component along the view axis is 1.
    corner: vec4f,
    right: vec4f,
    down: vec4f,
    ambient: vec4f,
    // The part of a pixel's width that a sample stands for.
    sample_width: f32,
    // Depth in metres; nearer hits are ordered less finely than farther ones.
    near: f32,
    // The depth buffer's value for a depth d is x + y / d + z d.
    clip: vec4f,
    // Linear RGB of the background, at the picture's upper and lower edge. If the fourth part is
    // above 0, the environment map is seen there instead, times that part.
    background: vec4f,
    background_below: vec4f,
    lights: array<Light, MAX_LIGHTS>,
    light_count: u32,
    // The shadow maps' cameras.
    light_views: array<LightView, MAX_LIGHT_VIEWS>,
}"#,
    },
    Declaration {
        module: "shared/settings",
        name: "Choice",
        sampling: None,
        uses: &[],
        text: r#"// The chosen variant of a stage.
struct Choice {
    // The variant's place in the stage's list.
    number: u32,
    // The variant's parameters, in the order of its registry entry.
    params: vec4f,
}"#,
    },
    Declaration {
        module: "shared/settings",
        name: "MapSettings",
        sampling: None,
        uses: &[],
        text: r#"// Settings of a baked map.
struct MapSettings {
    // 1 where its texels are codes of 8 bits: the value of code c is low + step c.
    coded: u32,
    // Layers of each level.
    layers: u32,
    // Bytes of a texel.
    texel_bytes: u32,
    // The level of the height map whose place and size the map's finest level has.
    first_level: u32,
    low: vec4f,
    step: vec4f,
    // Metres of a tile along u and v in the metric that it was baked in.
    tile_m: vec2f,
}"#,
    },
    Declaration {
        module: "shared/settings",
        name: "SurfaceSettings",
        sampling: None,
        uses: &["Choice", "MAP_SLOTS", "MapSettings", "STAGES"],
        text: r#"// Settings of a surface: its maps, displacement, material and method.
struct SurfaceSettings {
    // For each stage, in the order in which a pixel goes through them.
    choices: array<Choice, STAGES>,
    // For each slot of baked maps.
    maps: array<MapSettings, MAP_SLOTS>,
    // Linear RGB. For `metallic-roughness`, the base colour, and the reflection of materials that
    // are no metals.
    diffuse: vec4f,
    specular: vec4f,
    // Light that the surface gives by itself, linear RGB.
    emission: vec4f,
    // Rows that turn texture coordinates (u, v) into the colour map's coordinates: x u + y v + z
    // each.
    color_u: vec4f,
    color_v: vec4f,
    // Columns and rows of the height map, the colour map, the normal map and the material map.
    height_size: vec2u,
    color_size: vec2u,
    normal_size: vec2u,
    material_size: vec2u,
    // Levels of detail of each, at least 1. Normals derived from heights begin at level 1 of the
    // height map, which is the finest level of the normal map.
    height_levels: u32,
    color_levels: u32,
    normal_levels: u32,
    material_levels: u32,
    // Texels of the colour map, the normal map and the material map per texel of the height map.
    color_texels: f32,
    normal_texels: f32,
    material_texels: f32,
    // Metres of a tile along u and v for which normals were derived.
    normal_tile_m: vec2f,
    // Wrap of the height map and the normal map, then of the colour map along both of its axes.
    wrap: u32,
    color_wrap_u: u32,
    color_wrap_v: u32,
    shininess: u32,
    // Roughness and metalness, each from 0 to 1; factors on the material map's.
    roughness: f32,
    metallic: f32,
    // 1 if the first layer of the material map is read: occlusion, roughness and metalness. 2 if
    // the second one is: emission. 3 for both.
    has_material: u32,
    has_color: u32,
    has_normal: u32,
    // 1 if hits in holes of the height map are misses; 2 if hits where the colour map's opacity is
    // below the cut-off are; 3 for both.
    has_holes: u32,
    // 1 if normals that are derived from heights are not taken across creases.
    has_creases: u32,
    // 1 if the vertices of the triangles give the normals.
    has_vertex_normals: u32,
    // 0 if the relief casts no shadows.
    has_shadows: u32,
    scale_m: f32,
    bias_m: f32,
    // Metres along the normals at which heights 0 and 1 lie in shells. Shells always have a
    // thickness.
    shell_m: vec2f,
    // The mean of the height map, if pixels have levels of detail.
    mean_height: f32,
    // The part of the light that is refracted where it enters the surface, not scattered, and the index of
    // refraction.
    transmission: f32,
    ior: f32,
    // Number among the surfaces that are drawn: a surface of several materials is drawn as one for
    // each.
    number: u32,
    // Texels of a face's side in the finest level of the environment map, and its levels; at least
    // 1 each.
    environment_side: u32,
    environment_levels: u32,
    // Images of an object, and the number of the first ones among them that define the solid; 0 for
    // a relief.
    images: u32,
    solids: u32,
    // One of CELLS_*, and the difference of heights beyond which a cell of an image jumps.
    cells: u32,
    jump: f32,
    // Columns, rows and slices of a volume, whose slices lie side by side in the height map, and the
    // slices in a row of that map; zeros for heights.
    volume: vec4u,
    // Opacities of the colour map below this are holes.
    cutoff: f32,
    // The surface's number among the translucent ones, and how many there are; zeros for opaque ones.
    translucent: vec2u,
}"#,
    },
    Declaration {
        module: "shared/settings",
        name: "PointSettings",
        sampling: None,
        uses: &[],
        text: r#"// Settings of a method as a function, beside the surface's.
struct PointSettings {
    // Radius of the light's disc over its distance: the tangent of half its angular diameter.
    light_radius: f32,
}"#,
    },
    Declaration {
        module: "shared/settings",
        name: "PassSettings",
        sampling: None,
        uses: &[],
        text: r#"// Settings of one pass: some rows of the picture, and one sample of their pixels. The host keeps
// 256 bytes for each pass, so more members fit.
struct PassSettings {
    // Offset in pixels from a pixel's centre to its sample point.
    offset: vec2f,
    // From clip space to the clip space of the rows: y is multiplied by the zoom, then the shift is
    // added.
    shift: vec2f,
    zoom: f32,
    // The weight of the sample in the pixel's colour.
    weight: f32,
    // The rows of the picture that are traced, shaded and read back at once. The records fit the
    // least buffer that adapters offer.
    first_row: u32,
    rows: u32,
    // 1 for the last sample of a pixel.
    is_last: u32,
}"#,
    },
    Declaration {
        module: "shared/settings",
        name: "ScreenSettings",
        sampling: None,
        uses: &[],
        text: r#"// Settings of the pass that makes the picture for screens.
struct ScreenSettings {
    // Columns and rows of the picture.
    size: vec2u,
    // The factor on light, from the exposure.
    gain: f32,
    // The number of the tone curve; 0 is none.
    tone: u32,
}"#,
    },
    Declaration {
        module: "shared/settings",
        name: "PyramidPass",
        sampling: None,
        uses: &[],
        text: r#"// Settings of a pass over a level of a pyramid.
struct PyramidPass {
    // Columns and rows of the previous level of nodes, without padding; zeros for the first level.
    nodes_size: vec2u,
    // Columns and rows of the level of the height map that is read; zeros if none is.
    heights_size: vec2u,
    // The column and the row that stand for those after the last.
    beyond: vec2u,
    // Columns and rows of the height map that a node covers besides its own two: 1 for a pyramid
    // over dual cells, which reach to the next texels.
    reach: u32,
    // The number of the level of the height map.
    level: u32,
}"#,
    },
    Declaration {
        module: "shared/shadow_ray",
        name: "free_way",
        sampling: None,
        uses: &["Entered", "FOUND_MISS", "Hit", "LIGHT_RAY_DARK", "LIGHT_RAY_LIT", "Toward", "field_light_ray_stage", "shadow_search_stage"],
        text: r#"// 1 if nothing is between the hit and the light, otherwise 0.
fn free_way(at: Entered, hit: Hit, light: Toward) -> f32 {
    let ray = field_light_ray_stage(at, hit, light);
    if (ray.state == LIGHT_RAY_LIT) {
        return 1.0;
    }
    if (ray.state == LIGHT_RAY_DARK) {
        return 0.0;
    }
    let found = shadow_search_stage(ray.path);
    return select(0.0, 1.0, found.status == FOUND_MISS);
}"#,
    },
    Declaration {
        module: "shared/shell",
        name: "SHELL_ROUNDING",
        sampling: None,
        uses: &[],
        text: r#"// Roundings, relative to the distances in play, by which a shell is enlarged. Smaller, and rays
// pass between neighbours; larger, and what lies beside a triangle is seen through its edge.
const SHELL_ROUNDING = 0.00000095367431640625;"#,
    },
    Declaration {
        module: "shared/shell",
        name: "LEAST_FACING",
        sampling: None,
        uses: &[],
        text: r#"// Cosine of the angle between ray and base below which footprints do not get longer.
const LEAST_FACING = 0.0625;"#,
    },
    Declaration {
        module: "shared/shell",
        name: "corner_value",
        sampling: None,
        uses: &[],
        text: r#"// One of three vectors, by its number.
fn corner_value(number: u32, a: vec3f, b: vec3f, c: vec3f) -> vec3f {
    let is_first = number == 0u;
    let is_second = number == 1u;
    let second = select(c, b, vec3<bool>(is_second, is_second, is_second));
    return select(second, a, vec3<bool>(is_first, is_first, is_first));
}"#,
    },
    Declaration {
        module: "shared/shell",
        name: "ordered",
        sampling: None,
        uses: &["Corner", "PixelIn", "corner_value"],
        text: r#"// Corner of the triangle, by its place in the order that all triangles at an edge agree on. It is
// chosen number by number: compilers drop unused ones, and there are no branches.
fn ordered(pixel: PixelIn, place: u32) -> Corner {
    let number = (pixel.shell.order >> (2u * place)) & 3u;
    let a = pixel.a;
    let b = pixel.b;
    let c = pixel.c;
    return Corner(
        corner_value(number, a.position, b.position, c.position),
        corner_value(number, a.normal, b.normal, c.normal),
        corner_value(number, a.tangent, b.tangent, c.tangent),
        corner_value(number, a.bitangent, b.bitangent, c.bitangent),
        corner_value(number, vec3f(a.uv, 0.0), vec3f(b.uv, 0.0), vec3f(c.uv, 0.0)).xy,
        corner_value(number, a.of_surface, b.of_surface, c.of_surface),
    );
}"#,
    },
    Declaration {
        module: "shared/shell",
        name: "ordered_weights",
        sampling: None,
        uses: &["Shell", "weight_at"],
        text: r#"// The weights of the corners in that order.
fn ordered_weights(shell: Shell, weights: vec3f) -> vec3f {
    return vec3f(
        weight_at(shell.order, weights),
        weight_at(shell.order >> 2u, weights),
        weight_at(shell.order >> 4u, weights),
    );
}"#,
    },
    Declaration {
        module: "shared/shell",
        name: "weight_at",
        sampling: None,
        uses: &[],
        text: r#"fn weight_at(order: u32, weights: vec3f) -> f32 {
    let corner = order & 3u;
    return select(select(weights.z, weights.y, corner == 1u), weights.x, corner == 0u);
}"#,
    },
    Declaration {
        module: "shared/shell",
        name: "raised",
        sampling: None,
        uses: &["Corner", "NEVER", "moved_out", "surface_settings"],
        text: r#"// The position of a corner raised to a height.
fn raised(corner: Corner, side: f32, height: f32) -> vec3f {
    let shell = surface_settings.shell_m;
    // A limit that is never reached: compilers would make another mean, which gives other bits.
    return moved_out(corner, side, shell.x + min(shell.y - shell.x, NEVER) * height);
}"#,
    },
    Declaration {
        module: "shared/shell",
        name: "moved_out",
        sampling: None,
        uses: &["Corner"],
        text: r#"// The position of a corner moved out by an offset in metres.
fn moved_out(corner: Corner, side: f32, offset: f32) -> vec3f {
    return corner.position + corner.normal * (side * offset);
}"#,
    },
    Declaration {
        module: "shared/shell",
        name: "offsets_of",
        sampling: None,
        uses: &["NEVER", "Shell", "surface_settings"],
        text: r#"// The offsets along the normals, in metres, between which the relief of a shell lies.
fn offsets_of(shell: Shell) -> vec2f {
    let width = min(surface_settings.shell_m.y - surface_settings.shell_m.x, NEVER);
    let quarter = vec3f(0.25, 0.25, 0.25);
    let zero = vec3f(0.0, 0.0, 0.0);
    // A product of two weights is at most a quarter.
    let lowered = dot(min(shell.lift, zero), quarter);
    let lifted = dot(max(shell.lift, zero), quarter);
    return surface_settings.shell_m.x + width * shell.heights + vec2f(lowered, lifted);
}"#,
    },
    Declaration {
        module: "shared/shell",
        name: "lift_of",
        sampling: None,
        uses: &[],
        text: r#"// The height of the smooth base above the triangle at a point. In this order: with a common factor
// taken out compilers give other bits.
fn lift_of(lift: vec3f, w: vec3f) -> f32 {
    return lift.x * w.y * w.z + lift.y * w.z * w.x + lift.z * w.x * w.y;
}"#,
    },
    Declaration {
        module: "shared/shell",
        name: "middle_of",
        sampling: None,
        uses: &["PixelIn"],
        text: r#"// Metres along the ray to its nearest place to the triangle. Distances from there keep all of their
// bits.
fn middle_of(pixel: PixelIn, along: vec3f) -> f32 {
    let centre = (pixel.a.position + pixel.b.position + pixel.c.position) * (1.0 / 3.0);
    return dot(centre - pixel.origin, along);
}"#,
    },
    Declaration {
        module: "shared/shell",
        name: "shell_slack",
        sampling: None,
        uses: &["PixelIn", "SHELL_ROUNDING"],
        text: r#"// Metres by which rounding may move a ray beside a shell.
fn shell_slack(pixel: PixelIn, middle: f32) -> f32 {
    let origin = abs(pixel.origin);
    return SHELL_ROUNDING * (max(max(origin.x, origin.y), origin.z) + abs(middle));
}"#,
    },
    Declaration {
        module: "shared/shell",
        name: "facing_of",
        sampling: None,
        uses: &["LEAST_FACING", "PixelIn", "plane_normal"],
        text: r#"// The normal of the plane in which footprints of pixels are measured: the triangle's, turned toward the eye
// where that sees it from the side or from behind.
fn facing_of(pixel: PixelIn, along: vec3f) -> vec3f {
    let normal = plane_normal(pixel);
    let unit = normal * (pixel.side / sqrt(dot(normal, normal)));
    let cosine = 0.0 - dot(unit, along);
    return unit - along * max(LEAST_FACING - cosine, 0.0);
}"#,
    },
    Declaration {
        module: "shared/shell",
        name: "frame_at",
        sampling: None,
        uses: &["Entered", "PixelIn", "ordered", "surface_settings"],
        text: r#"// The frame at a point of the triangle, by the weights of its corners in their order. The level of
// detail is the finest.
fn frame_at(pixel: PixelIn, weights: vec3f, point: vec3f, uv: vec2f, facing: vec3f) -> Entered {
    let a = ordered(pixel, 0u);
    let b = ordered(pixel, 1u);
    let c = ordered(pixel, 2u);
    let tangent = a.tangent * weights.x + b.tangent * weights.y + c.tangent * weights.z;
    let bitangent = a.bitangent * weights.x + b.bitangent * weights.y + c.bitangent * weights.z;
    let normal = a.normal * weights.x + b.normal * weights.y + c.normal * weights.z;
    let metric = vec4f(
        dot(tangent, tangent),
        dot(tangent, bitangent),
        dot(bitangent, bitangent),
        surface_settings.scale_m,
    );
    let unit = normalize(normal) * pixel.side;
    return Entered(
        1u,
        point,
        uv,
        tangent,
        bitangent,
        unit,
        metric,
        0u,
        facing,
        vec2f(0.0, 0.0),
        vec4f(0.0, 0.0, 0.0, 0.0),
        0.0,
        0.0,
        0.0,
    );
}"#,
    },
    Declaration {
        module: "shared/shell",
        name: "passed_by",
        sampling: None,
        uses: &["Entered"],
        text: r#"// The result for a shell that the ray does not enter.
fn passed_by() -> Entered {
    let zero = vec3f(0.0, 0.0, 0.0);
    let zeros = vec4f(0.0, 0.0, 0.0, 0.0);
    let uv = vec2f(0.0, 0.0);
    return Entered(0u, zero, uv, zero, zero, zero, zeros, 0u, zero, uv, zeros, 0.0, 0.0, 0.0);
}"#,
    },
    Declaration {
        module: "shared/shell",
        name: "shell_middle",
        sampling: None,
        uses: &["Entered", "PixelIn", "facing_of", "frame_at", "middle_of"],
        text: r#"// The frame in the middle of the triangle, before it is known whether the ray enters the shell.
fn shell_middle(pixel: PixelIn, along: vec3f) -> Entered {
    let third = vec3f(1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0);
    let uv = (pixel.a.uv + pixel.b.uv + pixel.c.uv) * (1.0 / 3.0);
    let point = pixel.origin + along * middle_of(pixel, along);
    var at = frame_at(pixel, third, point, uv, facing_of(pixel, along));
    at.segments = 0u;
    return at;
}"#,
    },
    Declaration {
        module: "shared/shell",
        name: "placed_at",
        sampling: None,
        uses: &["Entered", "PixelIn", "frame_at"],
        text: r#"// The frame at a hit, in the ray's level of detail.
fn placed_at(pixel: PixelIn, at: Entered, weights: vec3f, point: vec3f, uv: vec2f) -> Entered {
    var placed = frame_at(pixel, weights, point, uv, at.facing);
    placed.level = at.level;
    placed.footprint = at.footprint;
    placed.fade = at.fade;
    return placed;
}"#,
    },
    Declaration {
        module: "shared/shell_hull",
        name: "ACROSS",
        sampling: None,
        uses: &[],
        text: r#"// The reciprocal of a direction's component that is zero.
const ACROSS = 1.0e20;"#,
    },
    Declaration {
        module: "shared/shell_hull",
        name: "LEAST_LENGTH",
        sampling: None,
        uses: &[],
        text: r#"// Lengths below this are roundings.
const LEAST_LENGTH = 1.0e-18;"#,
    },
    Declaration {
        module: "shared/shell_hull",
        name: "HullRay",
        sampling: None,
        uses: &[],
        text: r#"// A ray, and the metres by which hulls are larger for it.
struct HullRay {
    origin: vec3f,
    direction: vec3f,
    slack: f32,
}"#,
    },
    Declaration {
        module: "shared/shell_hull",
        name: "beyond_sides",
        sampling: None,
        uses: &["SURFACE_STAGE", "Triangle", "height_size", "surface_settings"],
        text: r#"// Metres by which segments of prisms reach beyond their sides, besides rounding.
fn beyond_sides(triangle: Triangle) -> f32 {
    let tangent = (triangle.a.tangent + triangle.b.tangent + triangle.c.tangent) * (1.0 / 3.0);
    let bitangent = (triangle.a.bitangent + triangle.b.bitangent + triangle.c.bitangent) * (1.0 / 3.0);
    let tile = sqrt(max(dot(tangent, tangent), dot(bitangent, bitangent)));
    let texels = max(height_size(0u).x, height_size(0u).y);
    return 2.0 * surface_settings.choices[SURFACE_STAGE].params.x * tile / texels;
}"#,
    },
    Declaration {
        module: "shared/shell_hull",
        name: "hull_ray",
        sampling: None,
        uses: &["HullRay", "SHELL_SLACK", "Triangle", "beyond_sides", "offsets_of", "pixel_direction", "pixel_eye"],
        text: r#"// The ray through a point of the picture, for the hull of a triangle's shell.
fn hull_ray(point: vec2f, triangle: Triangle) -> HullRay {
    let origin = pixel_eye(point);
    let shell = offsets_of(triangle.shell);
    let a = abs(triangle.a.position);
    let b = abs(triangle.b.position);
    let c = abs(triangle.c.position);
    let largest = max(max(abs(origin), a), max(b, c));
    let beyond = max(abs(shell.x), abs(shell.y));
    let rounding = SHELL_SLACK * (max(max(largest.x, largest.y), largest.z) + beyond);
    let slack = rounding + beyond_sides(triangle);
    return HullRay(origin, pixel_direction(point), slack);
}"#,
    },
    Declaration {
        module: "shared/shell_hull",
        name: "inside_slab",
        sampling: None,
        uses: &["ACROSS", "HullRay", "LEAST_LENGTH", "Triangle", "moved_out", "offsets_of"],
        text: r#"// The part of a ray, between two parameters, in a slab around a triangle's shell. `across` is the
// slab's normal.
fn inside_slab(inside: vec2f, ray: HullRay, triangle: Triangle, side: f32, across: vec3f) -> vec2f {
    let axis = across / max(length(across), LEAST_LENGTH);
    let offsets = offsets_of(triangle.shell);
    let a = dot(moved_out(triangle.a, side, offsets.x), axis);
    let b = dot(moved_out(triangle.b, side, offsets.x), axis);
    let c = dot(moved_out(triangle.c, side, offsets.x), axis);
    let d = dot(moved_out(triangle.a, side, offsets.y), axis);
    let e = dot(moved_out(triangle.b, side, offsets.y), axis);
    let f = dot(moved_out(triangle.c, side, offsets.y), axis);
    let low = min(min(min(a, b), min(c, d)), min(e, f)) - ray.slack;
    let high = max(max(max(a, b), max(c, d)), max(e, f)) + ray.slack;
    let origin = dot(ray.origin, axis);
    let along = dot(ray.direction, axis);
    let inverse = select(ACROSS, 1.0 / along, abs(along) > 1.0 / ACROSS);
    let one = (low - origin) * inverse;
    let other = (high - origin) * inverse;
    return vec2f(max(inside.x, min(one, other)), min(inside.y, max(one, other)));
}"#,
    },
    Declaration {
        module: "shared/shell_hull",
        name: "may_meet",
        sampling: None,
        uses: &["LEAST_LENGTH", "NEVER", "Triangle", "hull_ray", "inside_slab"],
        text: r#"// Whether the ray through a point of the picture may meet the hull of a side's shell, before the
// parameter `reach`. There is one slab along the triangle's normal and one along the normal of each
// side.
fn may_meet(point: vec2f, triangle: Triangle, side: f32, reach: f32) -> bool {
    let ray = hull_ray(point, triangle);
    let ab = triangle.b.position - triangle.a.position;
    let bc = triangle.c.position - triangle.b.position;
    let ca = triangle.a.position - triangle.c.position;
    let across = cross(ab, bc);
    let normal = across / max(length(across), LEAST_LENGTH);
    var inside = vec2f(0.0 - NEVER, reach);
    inside = inside_slab(inside, ray, triangle, side, normal);
    inside = inside_slab(inside, ray, triangle, side, cross(normal, ab));
    inside = inside_slab(inside, ray, triangle, side, cross(normal, bc));
    inside = inside_slab(inside, ray, triangle, side, cross(normal, ca));
    return inside.x <= inside.y && inside.y >= 0.0;
}"#,
    },
    Declaration {
        module: "shared/shell_point",
        name: "NEWTON_STEPS",
        sampling: None,
        uses: &[],
        text: r#"// The most steps of Newton's method from the middle of a shell to a point of it. Fewer, and hits are beside
// the ray where shells are strongly curved.
const NEWTON_STEPS = 6u;"#,
    },
    Declaration {
        module: "shared/shell_point",
        name: "NEWTON_END",
        sampling: None,
        uses: &[],
        text: r#"// After a step shorter than this, in weights and heights, the point is exact up to rounding: each
// step squares the error.
const NEWTON_END = 0.001;"#,
    },
    Declaration {
        module: "shared/shell_point",
        name: "HEIGHTS_A_TEXEL",
        sampling: None,
        uses: &[],
        text: r#"// Heights that count as much as a distance of one texel from the way.
const HEIGHTS_A_TEXEL = 0.0625;"#,
    },
    Declaration {
        module: "shared/shell_point",
        name: "SAME_SHEET",
        sampling: None,
        uses: &[],
        text: r#"// The greatest distance, in weights and heights, from the start of Newton's method to its end in a
// shell that overlaps itself. Farther away it has come to another sheet of the shell.
const SAME_SHEET = 0.5;"#,
    },
    Declaration {
        module: "shared/shell_point",
        name: "Prism",
        sampling: None,
        uses: &[],
        text: r#"// A shell, seen from the place of the ray that is nearest to the triangle: corners, their normals,
// and the coefficients of the smooth base.
struct Prism {
    p0: vec3f,
    p1: vec3f,
    p2: vec3f,
    n0: vec3f,
    n1: vec3f,
    n2: vec3f,
    lift: vec3f,
}"#,
    },
    Declaration {
        module: "shared/shell_point",
        name: "ShellPoint",
        sampling: None,
        uses: &[],
        text: r#"// A point of a shell: weights of the corners, and the height.
struct ShellPoint {
    weights: vec3f,
    height: f32,
}"#,
    },
    Declaration {
        module: "shared/shell_point",
        name: "prism_of",
        sampling: None,
        uses: &["PixelIn", "Prism", "ordered"],
        text: r#"fn prism_of(pixel: PixelIn, along: vec3f, middle: f32, params: vec4f) -> Prism {
    let origin = pixel.origin + along * middle;
    let a = ordered(pixel, 0u);
    let b = ordered(pixel, 1u);
    let c = ordered(pixel, 2u);
    return Prism(
        a.position - origin,
        b.position - origin,
        c.position - origin,
        a.normal * pixel.side,
        b.normal * pixel.side,
        c.normal * pixel.side,
        pixel.shell.lift * (params.y * pixel.side),
    );
}"#,
    },
    Declaration {
        module: "shared/shell_point",
        name: "shell_point",
        sampling: None,
        uses: &["Prism", "ShellPoint", "shell_point_from"],
        text: r#"// The point of a shell at a place, by Newton's method from the middle of the triangle.
fn shell_point(prism: Prism, place: vec3f, height: f32) -> ShellPoint {
    // Near the middle, and no two alike: compilers would take a common factor out of the first
    // step's sums, which gives other bits.
    return shell_point_from(prism, place, ShellPoint(vec3f(0.28125, 0.375, 0.34375), height));
}"#,
    },
    Declaration {
        module: "shared/shell_point",
        name: "shell_point_from",
        sampling: None,
        uses: &["NEVER", "NEWTON_END", "NEWTON_STEPS", "Prism", "ShellPoint", "lift_of", "surface_settings"],
        text: r#"// The point of a shell at a place, by Newton's method from another point.
fn shell_point_from(prism: Prism, place: vec3f, from_point: ShellPoint) -> ShellPoint {
    let low = surface_settings.shell_m.x;
    // A limit that is never reached: compilers would make another mean of both, which gives other
    // bits.
    let width = min(surface_settings.shell_m.y - low, NEVER);
    let l = prism.lift;
    var w = from_point.weights;
    var h = from_point.height;
    var step = 0u;
    while (step < NEWTON_STEPS) {
        step = step + 1u;
        let offset = low + width * h + lift_of(l, w);
        let normal = prism.n0 * w.x + prism.n1 * w.y + prism.n2 * w.z;
        let base = prism.p0 * w.x + prism.p1 * w.y + prism.p2 * w.z;
        let rest = place - base - normal * offset;
        // The change of the point with the second weight and with the third, at the cost of the first, and
        // with the height.
        let second = (l.z * (w.x - w.y) + w.z * (l.x - l.y));
        let third = (l.y * (w.x - w.z) + w.y * (l.x - l.z));
        let a = (prism.p1 - prism.p0) + (prism.n1 - prism.n0) * offset + normal * second;
        let b = (prism.p2 - prism.p0) + (prism.n2 - prism.n0) * offset + normal * third;
        let c = normal * width;
        let across = cross(b, c);
        let one_over = 1.0 / dot(a, across);
        let db = dot(rest, across) * one_over;
        let dc = dot(rest, cross(c, a)) * one_over;
        let dh = dot(rest, cross(a, b)) * one_over;
        w = vec3f(w.x - db - dc, w.y + db, w.z + dc);
        h = h + dh;
        if (max(max(abs(db), abs(dc)), abs(dh)) < NEWTON_END) {
            break;
        }
    }
    return ShellPoint(w, h);
}"#,
    },
    Declaration {
        module: "shared/shell_point",
        name: "weights_at_offset",
        sampling: None,
        uses: &["Prism"],
        text: r#"// The weights of the corners of the triangle at an offset where a place is, or where it is seen along the
// triangle's normal.
fn weights_at_offset(prism: Prism, place: vec3f, offset: f32) -> vec3f {
    let corner = prism.p0 + prism.n0 * offset;
    let a = (prism.p1 - prism.p0) + (prism.n1 - prism.n0) * offset;
    let b = (prism.p2 - prism.p0) + (prism.n2 - prism.n0) * offset;
    let rest = place - corner;
    let across = cross(a, b);
    let square = dot(across, across);
    if (!(square > 0.0)) {
        return vec3f(0.28125, 0.375, 0.34375);
    }
    let second = dot(cross(rest, b), across) / square;
    let third = dot(cross(a, rest), across) / square;
    return vec3f(1.0 - second - third, second, third);
}"#,
    },
    Declaration {
        module: "shared/shell_point",
        name: "shell_point_near",
        sampling: None,
        uses: &["NEVER", "Prism", "SAME_SHEET", "ShellPoint", "lift_of", "shell_point_from", "surface_settings", "weights_at_offset"],
        text: r#"// The point of a shell at a place. In a shell that overlaps itself it is the one at about that
// height.
fn shell_point_near(prism: Prism, place: vec3f, height: f32) -> ShellPoint {
    let low = surface_settings.shell_m.x;
    let offset = low + min(surface_settings.shell_m.y - low, NEVER) * height;
    let flat = weights_at_offset(prism, place, offset);
    let near = ShellPoint(weights_at_offset(prism, place, offset + lift_of(prism.lift, flat)), height);
    let point = shell_point_from(prism, place, near);
    let moved = abs(point.weights - near.weights);
    let away = max(max(moved.x, moved.y), max(moved.z, abs(point.height - height)));
    if (away < SAME_SHEET) {
        return point;
    }
    return near;
}"#,
    },
    Declaration {
        module: "shared/shell_point",
        name: "between",
        sampling: None,
        uses: &["ShellPoint"],
        text: r#"// A point halfway between two points, near the point of a shell that is seen halfway.
fn between(a: ShellPoint, b: ShellPoint) -> ShellPoint {
    return ShellPoint(0.5 * (a.weights + b.weights), 0.5 * (a.height + b.height));
}"#,
    },
    Declaration {
        module: "shared/shell_point",
        name: "uv_of",
        sampling: None,
        uses: &["PixelIn", "ordered"],
        text: r#"// The texture coordinates at these weights.
fn uv_of(pixel: PixelIn, weights: vec3f) -> vec2f {
    return ordered(pixel, 0u).uv * weights.x + ordered(pixel, 1u).uv * weights.y
        + ordered(pixel, 2u).uv * weights.z;
}"#,
    },
    Declaration {
        module: "shared/shell_tree",
        name: "NOWHERE",
        sampling: None,
        uses: &[],
        text: r#"// No node.
const NOWHERE = 0xffffffffu;"#,
    },
    Declaration {
        module: "shared/shell_tree",
        name: "FROM_ABOVE",
        sampling: None,
        uses: &[],
        text: r#"// Where a ray came from: from the parent, for the first time; from the sibling, which is nearer;
// from a child, below which all was visited.
const FROM_ABOVE = 0u;"#,
    },
    Declaration {
        module: "shared/shell_tree",
        name: "FROM_BESIDE",
        sampling: None,
        uses: &[],
        text: r#"const FROM_BESIDE = 1u;"#,
    },
    Declaration {
        module: "shared/shell_tree",
        name: "FROM_BELOW",
        sampling: None,
        uses: &[],
        text: r#"const FROM_BELOW = 2u;"#,
    },
    Declaration {
        module: "shared/shell_tree",
        name: "TreeRay",
        sampling: None,
        uses: &[],
        text: r#"// A ray, and the metres by which boxes are larger for it.
struct TreeRay {
    origin: vec3f,
    direction: vec3f,
    inverse: vec3f,
    slack: f32,
}"#,
    },
    Declaration {
        module: "shared/shell_tree",
        name: "TreeWalk",
        sampling: None,
        uses: &[],
        text: r#"// A ray's place in the BVH, and the leaf that it met last: NOWHERE at the end.
struct TreeWalk {
    node: u32,
    came: u32,
    leaf: u32,
}"#,
    },
    Declaration {
        module: "shared/shell_tree",
        name: "inverse_of",
        sampling: None,
        uses: &["ACROSS"],
        text: r#"// The reciprocals of a direction's components.
fn inverse_of(direction: vec3f) -> vec3f {
    let across = vec3f(ACROSS, ACROSS, ACROSS);
    return select(across, 1.0 / direction, abs(direction) > 1.0 / across);
}"#,
    },
    Declaration {
        module: "shared/shell_tree",
        name: "tree_ray",
        sampling: None,
        uses: &["SHELL_SLACK", "TreeRay", "inverse_of", "pixel_direction", "pixel_eye", "shell_nodes"],
        text: r#"// The ray through a point of the picture.
fn tree_ray(point: vec2f) -> TreeRay {
    let origin = pixel_eye(point);
    let direction = pixel_direction(point);
    let root = shell_nodes[0];
    let largest = max(max(abs(root.low), abs(root.high)), abs(origin));
    let slack = SHELL_SLACK * max(max(largest.x, largest.y), largest.z);
    return TreeRay(origin, direction, inverse_of(direction), slack);
}"#,
    },
    Declaration {
        module: "shared/shell_tree",
        name: "walk_begin",
        sampling: None,
        uses: &["FROM_ABOVE", "NOWHERE", "TreeWalk"],
        text: r#"// The beginning of a traversal.
fn walk_begin() -> TreeWalk {
    return TreeWalk(0u, FROM_ABOVE, NOWHERE);
}"#,
    },
    Declaration {
        module: "shared/shell_tree",
        name: "reach_of",
        sampling: None,
        uses: &["DEPTH_SLACK", "frame"],
        text: r#"// The parameter of a ray beyond which nothing is nearer than a key.
fn reach_of(key: f32) -> f32 {
    return frame.near / key * (1.0 + DEPTH_SLACK) - frame.near;
}"#,
    },
    Declaration {
        module: "shared/shell_tree",
        name: "goes_down",
        sampling: None,
        uses: &["TreeRay"],
        text: r#"// Whether the ray goes against the axis with that number.
fn goes_down(ray: TreeRay, axis: u32) -> bool {
    let along = select(select(ray.direction.z, ray.direction.y, axis == 1u), ray.direction.x, axis == 0u);
    return along < 0.0;
}"#,
    },
    Declaration {
        module: "shared/shell_tree",
        name: "walk_on",
        sampling: None,
        uses: &["FROM_ABOVE", "FROM_BELOW", "FROM_BESIDE", "NOWHERE", "TreeRay", "TreeWalk", "goes_down", "shell_nodes"],
        text: r#"// Goes on to the next leaf that the ray may meet up to a parameter.
fn walk_on(ray: TreeRay, before: TreeWalk, reach: f32) -> TreeWalk {
    var node = before.node;
    var came = before.came;
    while (node != NOWHERE) {
        let known = shell_nodes[node];
        var leaf = NOWHERE;
        if (came != FROM_BELOW) {
            let one = (known.low - ray.slack - ray.origin) * ray.inverse;
            let other = (known.high + ray.slack - ray.origin) * ray.inverse;
            let near = min(one, other);
            let far = max(one, other);
            let entry = max(max(near.x, near.y), near.z);
            let exit = min(min(far.x, far.y), min(far.z, reach));
            let axis = known.above & 3u;
            if (entry <= exit && exit >= 0.0) {
                if (axis < 3u) {
                    node = known.first + select(0u, 1u, goes_down(ray, axis));
                    came = FROM_ABOVE;
                    continue;
                }
                leaf = node;
            }
        }
        // All below was visited. The nearer child of a node is its first where the ray goes along
        // the axis.
        let is_nearer = (node & 1u) == select(1u, 0u, goes_down(ray, (known.above >> 2u) & 3u));
        if (node == 0u) {
            node = NOWHERE;
        } else if (came == FROM_ABOVE || (came == FROM_BELOW && is_nearer)) {
            node = select(node - 1u, node + 1u, (node & 1u) == 1u);
            came = FROM_BESIDE;
        } else {
            node = known.above >> 4u;
            came = FROM_BELOW;
        }
        if (leaf != NOWHERE) {
            return TreeWalk(node, came, leaf);
        }
    }
    return TreeWalk(NOWHERE, FROM_BELOW, NOWHERE);
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "SWEPT_PARTS",
        sampling: None,
        uses: &[],
        text: r#"// The most parts of a side: their third power fits 31 bits.
const SWEPT_PARTS = 1023;"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "TOP_NEXT",
        sampling: None,
        uses: &[],
        text: r#"// The partner of a column's top: the next column, the one before, or, for both ways, itself.
const TOP_NEXT = 0u;"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "TOP_BEFORE",
        sampling: None,
        uses: &[],
        text: r#"const TOP_BEFORE = 1u;"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "TOP_ROOF",
        sampling: None,
        uses: &[],
        text: r#"const TOP_ROOF = 2u;"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "ROOF_UP",
        sampling: None,
        uses: &[],
        text: r#"// The two ways of a roof.
const ROOF_UP = 3u;"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "ROOF_DOWN",
        sampling: None,
        uses: &[],
        text: r#"const ROOF_DOWN = 4u;"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "ON_PRIMARY",
        sampling: None,
        uses: &[],
        text: r#"// Sides as bits: the primary edge, the side from its first end to the third corner, the side from
// there to its other end.
const ON_PRIMARY = 1u;"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "ON_FIRST",
        sampling: None,
        uses: &[],
        text: r#"const ON_FIRST = 2u;"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "ON_SECOND",
        sampling: None,
        uses: &[],
        text: r#"const ON_SECOND = 4u;"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "Sweep",
        sampling: None,
        uses: &[],
        text: r#"// A triangle as it is swept. Coordinates run along the sweep and across it. They count from the
// first end of the primary edge, and the third corner lies above it.
struct Sweep {
    // The ends of the primary edge and the third corner, as numbers of the triangle's corners.
    corners: vec3u,
    // The end of the primary edge; its first coordinate is the number of strips between columns, 0 where all
    // corners lie in one voxel.
    end: vec2i,
    // The third corner.
    apex: vec2i,
    // Parts of the sides from the first end to the third corner, and from there to the other end.
    parts: vec2i,
    // 1 where pieces are turned over, as seen from the triangle.
    is_turned: u32,
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "SweptPoint",
        sampling: None,
        uses: &[],
        text: r#"// A point of a triangle.
struct SweptPoint {
    // The triangle's side that the point lies on, and the number of parts before it there, fewer
    // than the side has; or `INSIDE`, and its number among the points inside.
    side: u32,
    at: u32,
    // The point is (x / w, y / w).
    x: i32,
    y: i32,
    w: i32,
    // The sides that the point lies on.
    sides: u32,
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "SweptColumn",
        sampling: None,
        uses: &[],
        text: r#"// A column of points: the point of the primary edge, the points inside from below, the points of
// the top along the sweep.
struct SweptColumn {
    column: i32,
    // The lowest point inside, their number, and the number of the first.
    inside: i32,
    inner: i32,
    first: u32,
    // The first point of the top, their number, and their partner.
    from_top: i32,
    of_top: i32,
    top: u32,
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "SweptChain",
        sampling: None,
        uses: &["SweptColumn"],
        text: r#"// Some of a column's points, from below.
struct SweptChain {
    column: SweptColumn,
    // The partner of these points.
    way: u32,
    count: i32,
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "Zip",
        sampling: None,
        uses: &["SweptChain", "SweptPoint"],
        text: r#"// Two chains that are zipped, the first one to the left: its place, and the next points on each.
struct Zip {
    left: SweptChain,
    right: SweptChain,
    at_left: SweptPoint,
    at_right: SweptPoint,
    next_left: SweptPoint,
    next_right: SweptPoint,
    i: i32,
    j: i32,
    // 1 where the end of that chain comes last, as it lies on the side on which the other chain ends.
    keeps_left: u32,
    keeps_right: u32,
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "axis_of",
        sampling: None,
        uses: &[],
        text: r#"fn axis_of(at: vec3i, axis: u32) -> i32 {
    return select(select(at.z, at.y, axis == 1u), at.x, axis == 0u);
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "main_axis",
        sampling: None,
        uses: &[],
        text: r#"// The axis along which two voxels are farthest apart, of several the first.
fn main_axis(start: vec3i, to: vec3i) -> u32 {
    let along = abs(to - start);
    let of_last = select(2u, 1u, along.y >= along.z);
    return select(of_last, 0u, along.x >= along.y && along.x >= along.z);
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "primary_length",
        sampling: None,
        uses: &["axis_of", "main_axis"],
        text: r#"// The length of an edge along its main direction; by far longer for a primary edge.
fn primary_length(start: vec3i, to: vec3i, third: vec3i) -> i32 {
    let axis = main_axis(start, to);
    let a = axis_of(start, axis);
    let b = axis_of(to, axis);
    let c = axis_of(third, axis);
    let is_primary = min(a, b) <= c && c <= max(a, b);
    return abs(b - a) + select(0, 1048576, is_primary);
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "seen_along",
        sampling: None,
        uses: &[],
        text: r#"// The coordinates in cyclic order, beginning with an axis.
fn seen_along(at: vec3i, axis: u32) -> vec3i {
    if (axis == 0u) {
        return at;
    }
    if (axis == 1u) {
        return vec3i(at.y, at.z, at.x);
    }
    return vec3i(at.z, at.x, at.y);
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "longest_of",
        sampling: None,
        uses: &[],
        text: r#"// The distance of two voxels along the axis along which they are farthest apart.
fn longest_of(between: vec3i) -> i32 {
    let along = abs(between);
    return max(max(along.x, along.y), along.z);
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "sweep_from",
        sampling: None,
        uses: &["Sweep", "around_three", "axis_of", "longest_of", "main_axis", "seen_along"],
        text: r#"// The sweep of a triangle whose longest primary edge begins at its first corner.
fn sweep_from(primary: u32, a: vec3i, b: vec3i, c: vec3i) -> Sweep {
    let axis = main_axis(a, b);
    let is_back = axis_of(b, axis) < axis_of(a, axis);
    var first = a;
    var end = b;
    var corners = vec3u(primary, around_three(primary, 1u), around_three(primary, 2u));
    if (is_back) {
        first = b;
        end = a;
        corners = vec3u(corners.y, corners.x, corners.z);
    }
    let to_end = seen_along(end - first, axis);
    let to_apex = seen_along(c - first, axis);
    // Twice the area of the triangle in each plane.
    let in_first = to_end.x * to_apex.y - to_end.y * to_apex.x;
    let in_second = to_end.x * to_apex.z - to_end.z * to_apex.x;
    let is_first = abs(in_first) >= abs(in_second);
    let upward = select(1, -1, select(in_second, in_first, is_first) < 0);
    return Sweep(
        corners,
        vec2i(to_end.x, select(to_end.z, to_end.y, is_first) * upward),
        vec2i(to_apex.x, select(to_apex.z, to_apex.y, is_first) * upward),
        vec2i(max(longest_of(c - first), 1), max(longest_of(c - end), 1)),
        select(0u, 1u, is_back),
    );
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "sweep_of",
        sampling: None,
        uses: &["Sweep", "primary_length", "sweep_from"],
        text: r#"// The sweep of a triangle with corners in those voxels.
fn sweep_of(a: vec3i, b: vec3i, c: vec3i) -> Sweep {
    let of_a = primary_length(a, b, c);
    let of_b = primary_length(b, c, a);
    let of_c = primary_length(c, a, b);
    if (of_a >= of_b && of_a >= of_c) {
        return sweep_from(0u, a, b, c);
    }
    if (of_b >= of_c) {
        return sweep_from(1u, b, c, a);
    }
    return sweep_from(2u, c, a, b);
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "quotient_up",
        sampling: None,
        uses: &[],
        text: r#"// A quotient rounded up. The dividend is at least 0, the divisor above 0.
fn quotient_up(dividend: i32, by: i32) -> i32 {
    return (dividend + by - 1) / by;
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "quotient_near",
        sampling: None,
        uses: &[],
        text: r#"// A quotient rounded to the nearest whole number. The divisor is above 0.
fn quotient_near(dividend: i32, by: i32) -> i32 {
    let doubled = 2 * dividend + by;
    let whole = doubled / (2 * by);
    return select(whole, whole - 1, whole * 2 * by > doubled);
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "first_of_top",
        sampling: None,
        uses: &["Sweep", "quotient_up"],
        text: r#"// The number of the first point of a column's top. Points of the top, the third corner and both
// ends among them, are counted along the sweep.
fn first_of_top(sweep: Sweep, column: i32) -> i32 {
    let n = sweep.parts.x;
    let m = sweep.parts.y;
    // A point belongs to the column if it lies at most half a voxel before its middle.
    let doubled = 2 * column - 1;
    if (column <= 0) {
        return 0;
    }
    if (column > sweep.end.x) {
        return n + m + 1;
    }
    if (doubled <= 2 * sweep.apex.x) {
        return quotient_up(n * doubled, 2 * sweep.apex.x);
    }
    return n + quotient_up(m * (doubled - 2 * sweep.apex.x), 2 * (sweep.end.x - sweep.apex.x));
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "swept_border",
        sampling: None,
        uses: &["Sweep", "around_three"],
        text: r#"// The point between two corners of the sweep with `at` of `parts` parts before it.
fn swept_border(sweep: Sweep, start: u32, to: u32, at: i32, parts: i32) -> vec2u {
    if (at == 0) {
        return vec2u(start, 0u);
    }
    if (at == parts) {
        return vec2u(to, 0u);
    }
    if (to == around_three(start, 1u)) {
        return vec2u(start, u32(at));
    }
    return vec2u(to, u32(parts - at));
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "top_point",
        sampling: None,
        uses: &["ON_FIRST", "ON_SECOND", "Sweep", "SweptPoint", "swept_border"],
        text: r#"// The point of the top with that number.
fn top_point(sweep: Sweep, number: i32) -> SweptPoint {
    let n = sweep.parts.x;
    let m = sweep.parts.y;
    let apex = sweep.apex;
    if (number <= n) {
        let place = swept_border(sweep, sweep.corners.x, sweep.corners.z, number, n);
        let sides = select(ON_FIRST, ON_FIRST + ON_SECOND, number == n);
        return SweptPoint(place.x, place.y, apex.x * number, apex.y * number, n, sides);
    }
    let k = number - n;
    let place = swept_border(sweep, sweep.corners.z, sweep.corners.y, k, m);
    let x = apex.x * (m - k) + sweep.end.x * k;
    let y = apex.y * (m - k) + sweep.end.y * k;
    return SweptPoint(place.x, place.y, x, y, m, ON_SECOND);
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "swept_column",
        sampling: None,
        uses: &["Sweep", "SweptColumn", "TOP_BEFORE", "TOP_NEXT", "TOP_ROOF", "first_of_top", "quotient_near", "top_point"],
        text: r#"// A column. `first` is the number of its first point inside.
fn swept_column(sweep: Sweep, column: i32, first: u32) -> SweptColumn {
    let n = sweep.parts.x;
    let m = sweep.parts.y;
    let own = first_of_top(sweep, column);
    let next = first_of_top(sweep, column + 1);
    let is_behind = next - 1 > n;
    let top = select(TOP_NEXT, select(TOP_BEFORE, TOP_ROOF, own < n), is_behind);
    // The ends of the primary edge are at the bottom.
    let from_top = max(own, 1);
    let of_top = min(next, n + m) - from_top;
    if (column <= 0 || column >= sweep.end.x) {
        return SweptColumn(column, 0, 0, first, from_top, of_top, top);
    }
    let inside = quotient_near(sweep.end.y * column, sweep.end.x) + 1;
    let a = top_point(sweep, from_top);
    let b = top_point(sweep, from_top + of_top - 1);
    let above = min(quotient_near(a.y, a.w), quotient_near(b.y, b.w));
    return SweptColumn(column, inside, max(above - inside, 0), first, from_top, of_top, top);
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "swept_points_of",
        sampling: None,
        uses: &["Sweep", "swept_column"],
        text: r#"// The number of points inside a triangle.
fn swept_points_of(sweep: Sweep) -> u32 {
    var points = 0u;
    var column = 1;
    while (column < sweep.end.x) {
        points = points + u32(swept_column(sweep, column, 0u).inner);
        column = column + 1;
    }
    return points;
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "swept_weights",
        sampling: None,
        uses: &["Sweep"],
        text: r#"// The weights of the triangle's corners at a point of the grid.
fn swept_weights(sweep: Sweep, x: i32, y: i32) -> vec3f {
    let end = sweep.end;
    let apex = sweep.apex;
    let twice = f32(end.x * apex.y - end.y * apex.x);
    let of_end = f32(x * apex.y - y * apex.x) / twice;
    let of_apex = f32(end.x * y - end.y * x) / twice;
    let of_first = 1.0 - of_end - of_apex;
    let corners = sweep.corners;
    return vec3f(
        select(select(of_apex, of_end, corners.y == 0u), of_first, corners.x == 0u),
        select(select(of_apex, of_end, corners.y == 1u), of_first, corners.x == 1u),
        select(select(of_apex, of_end, corners.y == 2u), of_first, corners.x == 2u),
    );
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "roof_left",
        sampling: None,
        uses: &["Sweep", "SweptColumn"],
        text: r#"// The number of points of a roof's left way that belong to its top. The third corner goes with the
// side that has more room for it.
fn roof_left(sweep: Sweep, column: SweptColumn) -> i32 {
    return max(sweep.parts.x - column.from_top, 1);
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "swept_chain",
        sampling: None,
        uses: &["ROOF_DOWN", "ROOF_UP", "Sweep", "SweptChain", "SweptColumn", "roof_left"],
        text: r#"// The points of a column in the order in which they are zipped that way.
fn swept_chain(sweep: Sweep, column: SweptColumn, way: u32) -> SweptChain {
    if (way == ROOF_UP) {
        // The point under the roof comes first.
        return SweptChain(column, way, 1 + roof_left(sweep, column));
    }
    if (way == ROOF_DOWN) {
        return SweptChain(column, way, column.of_top - roof_left(sweep, column));
    }
    // A top that is not zipped that way has only its nearest end here.
    let of_top = select(min(column.of_top, 1), column.of_top, column.top == way);
    return SweptChain(column, way, 1 + column.inner + of_top);
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "low_point",
        sampling: None,
        uses: &["INSIDE", "ON_FIRST", "ON_PRIMARY", "ON_SECOND", "Sweep", "SweptColumn", "SweptPoint", "swept_border"],
        text: r#"// The lowest points of a column: the point of the primary edge, then the points inside.
fn low_point(sweep: Sweep, column: SweptColumn, at: i32) -> SweptPoint {
    let x = column.column;
    if (at > 0) {
        let y = column.inside + at - 1;
        return SweptPoint(INSIDE, column.first + u32(at - 1), x, y, 1, 0u);
    }
    let columns = sweep.end.x;
    let place = swept_border(sweep, sweep.corners.x, sweep.corners.y, x, columns);
    let sides = ON_PRIMARY + select(0u, ON_FIRST, x == 0) + select(0u, ON_SECOND, x == columns);
    return SweptPoint(place.x, place.y, x * columns, sweep.end.y * x, columns, sides);
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "chain_point",
        sampling: None,
        uses: &["ROOF_DOWN", "ROOF_UP", "Sweep", "SweptChain", "SweptPoint", "TOP_BEFORE", "low_point", "top_point"],
        text: r#"// The point of a chain with that number.
fn chain_point(sweep: Sweep, chain: SweptChain, number: i32) -> SweptPoint {
    let column = chain.column;
    let last = column.from_top + column.of_top - 1;
    if (chain.way == ROOF_DOWN) {
        return top_point(sweep, last - number);
    }
    if (chain.way == ROOF_UP) {
        if (number == 0) {
            return low_point(sweep, column, column.inner);
        }
        return top_point(sweep, column.from_top + number - 1);
    }
    if (number <= column.inner) {
        return low_point(sweep, column, number);
    }
    let on = number - column.inner - 1;
    let is_from_behind = (chain.way == TOP_BEFORE) == (column.top == chain.way);
    return top_point(sweep, select(column.from_top + on, last - on, is_from_behind));
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "ends_on",
        sampling: None,
        uses: &["Sweep", "SweptChain", "chain_point"],
        text: r#"// Whether the end of a chain lies on the same side as another chain's end.
fn ends_on(sweep: Sweep, chain: SweptChain, other: SweptChain) -> bool {
    if (other.count < 2) {
        return false;
    }
    let end = chain_point(sweep, chain, chain.count - 1).sides;
    let last = chain_point(sweep, other, other.count - 1).sides;
    let before = chain_point(sweep, other, other.count - 2).sides;
    return (end & last & before) != 0u;
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "zip_of",
        sampling: None,
        uses: &["ROOF_DOWN", "ROOF_UP", "Sweep", "SweptColumn", "TOP_BEFORE", "TOP_NEXT", "TOP_ROOF", "Zip", "chain_point", "ends_on", "swept_chain"],
        text: r#"// The zip between a column and the next. `which` is 0 for the roof of the first column of all, 1
// for the strip between both, 2 for the roof of the next. If there is none, both chains have one
// point.
fn zip_of(sweep: Sweep, column: SweptColumn, next: SweptColumn, which: u32) -> Zip {
    var left = swept_chain(sweep, column, TOP_NEXT);
    var right = swept_chain(sweep, next, TOP_BEFORE);
    if (which != 1u) {
        let under = which == 0u;
        let has_none = select(next.top != TOP_ROOF, column.top != TOP_ROOF || column.column != 0, under);
        if (under) {
            left = swept_chain(sweep, column, ROOF_UP);
            right = swept_chain(sweep, column, ROOF_DOWN);
        } else {
            left = swept_chain(sweep, next, ROOF_UP);
            right = swept_chain(sweep, next, ROOF_DOWN);
        }
        if (has_none) {
            left.count = 1;
            right.count = 1;
        }
    }
    let keeps_left = left.count > 1 && ends_on(sweep, left, right);
    let keeps_right = right.count > 1 && ends_on(sweep, right, left);
    return Zip(
        left,
        right,
        chain_point(sweep, left, 0),
        chain_point(sweep, right, 0),
        chain_point(sweep, left, min(1, left.count - 1)),
        chain_point(sweep, right, min(1, right.count - 1)),
        0,
        0,
        select(0u, 1u, keeps_left),
        select(0u, 1u, keeps_right),
    );
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "zip_rest",
        sampling: None,
        uses: &["Zip"],
        text: r#"// The number of pieces left to zip.
fn zip_rest(zip: Zip) -> i32 {
    return zip.left.count + zip.right.count - 2 - zip.i - zip.j;
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "wide_product",
        sampling: None,
        uses: &[],
        text: r#"// The upper and the lower 32 bits of a product.
fn wide_product(a: u32, b: u32) -> vec2u {
    let a_high = a >> 16u;
    let a_low = a & 65535u;
    let b_high = b >> 16u;
    let b_low = b & 65535u;
    let low = a_low * b_low;
    let one = a_low * b_high + (low >> 16u);
    let two = a_high * b_low + (one & 65535u);
    return vec2u(a_high * b_high + (one >> 16u) + (two >> 16u), (two << 16u) | (low & 65535u));
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "compared",
        sampling: None,
        uses: &["wide_product"],
        text: r#"// Compares a * b with c * d: -1 where it is less, 0 where both are the same, 1 where it is more.
fn compared(a: u32, b: u32, c: u32, d: u32) -> i32 {
    let first = wide_product(a, b);
    let second = wide_product(c, d);
    let by_low = select(select(0, 1, first.y > second.y), -1, first.y < second.y);
    return select(select(by_low, 1, first.x > second.x), -1, first.x < second.x);
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "magnitude",
        sampling: None,
        uses: &[],
        text: r#"fn magnitude(number: i32) -> u32 {
    return u32(abs(number));
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "sign_of",
        sampling: None,
        uses: &[],
        text: r#"fn sign_of(number: i32) -> i32 {
    return clamp(number, -1, 1);
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "turn_of_piece",
        sampling: None,
        uses: &["SweptPoint", "compared", "magnitude", "sign_of"],
        text: r#"// The sign of twice the area of a triangle.
fn turn_of_piece(a: SweptPoint, b: SweptPoint, c: SweptPoint) -> i32 {
    let bx = b.x * a.w - a.x * b.w;
    let by = b.y * a.w - a.y * b.w;
    let cx = c.x * a.w - a.x * c.w;
    let cy = c.y * a.w - a.y * c.w;
    let of_first = sign_of(bx) * sign_of(cy);
    let of_second = sign_of(by) * sign_of(cx);
    if (of_first != of_second) {
        return select(1, -1, of_first < of_second);
    }
    return of_first * compared(magnitude(bx), magnitude(cy), magnitude(by), magnitude(cx));
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "stretch_of",
        sampling: None,
        uses: &["SweptPoint", "magnitude"],
        text: r#"// The length of a way, along and up together, times the product of the denominators.
fn stretch_of(a: SweptPoint, b: SweptPoint) -> u32 {
    return magnitude(b.x * a.w - a.x * b.w) + magnitude(b.y * a.w - a.y * b.w);
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "is_no_longer",
        sampling: None,
        uses: &["SweptPoint", "compared", "stretch_of"],
        text: r#"// Whether a way is no longer than another one.
fn is_no_longer(a: SweptPoint, b: SweptPoint, c: SweptPoint, d: SweptPoint) -> bool {
    return compared(stretch_of(a, b), u32(c.w * d.w), stretch_of(c, d), u32(a.w * b.w)) <= 0;
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "zip_goes_left",
        sampling: None,
        uses: &["ROOF_UP", "Zip", "is_no_longer", "turn_of_piece"],
        text: r#"// Whether the next point to zip is one to the left.
fn zip_goes_left(zip: Zip) -> bool {
    let on_left = zip.left.count - 1 - zip.i;
    let on_right = zip.right.count - 1 - zip.j;
    if (on_left == 0) {
        return false;
    }
    if (on_right == 0) {
        return true;
    }
    // Under a roof its lowest point goes first.
    if (zip.left.way == ROOF_UP && zip.i == 0) {
        return true;
    }
    // The end comes last, or the triangles with it would have three corners on that side.
    if (zip.keeps_right == 1u && on_right == 1) {
        return true;
    }
    if (zip.keeps_left == 1u && on_left == 1) {
        return false;
    }
    let of_left = turn_of_piece(zip.at_left, zip.at_right, zip.next_left);
    let of_right = turn_of_piece(zip.at_left, zip.at_right, zip.next_right);
    let is_shorter = is_no_longer(zip.next_left, zip.at_right, zip.at_left, zip.next_right);
    if (of_left == of_right) {
        return is_shorter;
    }
    return of_left > 0 && (of_right <= 0 || is_shorter);
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "zip_next",
        sampling: None,
        uses: &["Sweep", "Zip", "chain_point"],
        text: r#"// The zip after its next point.
fn zip_next(sweep: Sweep, zip: Zip, goes_left: bool) -> Zip {
    var next = zip;
    if (goes_left) {
        next.i = zip.i + 1;
        next.at_left = zip.next_left;
        next.next_left = chain_point(sweep, zip.left, min(zip.i + 2, zip.left.count - 1));
    } else {
        next.j = zip.j + 1;
        next.at_right = zip.next_right;
        next.next_right = chain_point(sweep, zip.right, min(zip.j + 2, zip.right.count - 1));
    }
    return next;
}"#,
    },
    Declaration {
        module: "shared/sweep",
        name: "swept_triangles",
        sampling: None,
        uses: &["Sweep", "SweptColumn", "TOP_BEFORE", "TOP_NEXT", "TOP_ROOF", "swept_chain"],
        text: r#"// The number of triangles between a column and the next, including the roofs that close there.
fn swept_triangles(sweep: Sweep, column: SweptColumn, next: SweptColumn) -> u32 {
    let strip = swept_chain(sweep, column, TOP_NEXT).count + swept_chain(sweep, next, TOP_BEFORE).count - 2;
    let own = select(0, column.of_top - 1, column.column == 0 && column.top == TOP_ROOF);
    return u32(strip + own + select(0, next.of_top - 1, next.top == TOP_ROOF));
}"#,
    },
    Declaration {
        module: "shared/tangent_plane",
        name: "height_and_slope",
        sampling: None,
        uses: &["cell_of", "height_cell", "height_size"],
        text: r#"// Height and its derivatives by u and v at texture coordinates, from the dual cell of that level. One read.
fn height_and_slope(uv: vec2f, level: u32) -> vec3f {
    let size = height_size(level);
    let point = uv * size - vec2f(0.5, 0.5);
    let cell = cell_of(point);
    let f = point - cell;
    let h = height_cell(vec2i(cell), level);
    let top = h.x + (h.y - h.x) * f.x;
    let bottom = h.z + (h.w - h.z) * f.x;
    let left = h.x + (h.z - h.x) * f.y;
    let right = h.y + (h.w - h.y) * f.y;
    return vec3f(top + (bottom - top) * f.y, (right - left) * size.x, (bottom - top) * size.y);
}"#,
    },
    Declaration {
        module: "shared/tangent_plane",
        name: "normal_z",
        sampling: None,
        uses: &["Path"],
        text: r#"// The component of the unit surface normal along the base normal, for slopes in normalised height per texture
// unit.
fn normal_z(path: Path, slope: vec2f) -> f32 {
    let m = path.metric;
    let area = m.x * m.z - m.y * m.y;
    let squared = (slope.x * slope.x * m.z - 2.0 * slope.x * slope.y * m.y + slope.y * slope.y * m.x) / area;
    return 1.0 / sqrt(1.0 + m.w * m.w * squared);
}"#,
    },
    Declaration {
        module: "shared/tessellation",
        name: "PARTS_ROUNDING",
        sampling: None,
        uses: &[],
        text: r#"// The rounding error of a number of parts, as texture coordinates are stored.
const PARTS_ROUNDING = 0.0009765625;"#,
    },
    Declaration {
        module: "shared/tessellation",
        name: "FARTHEST_VOXEL",
        sampling: None,
        uses: &[],
        text: r#"// The greatest distance of a corner from the middle of the picture, in voxels; farther ones are
// moved to it.
const FARTHEST_VOXEL = 262144.0;"#,
    },
    Declaration {
        module: "shared/tessellation",
        name: "ROOT_OF_TWO",
        sampling: None,
        uses: &[],
        text: r#"// The greatest number below which square roots of 2 and of 1/2 are no matter.
const ROOT_OF_TWO = 1.4142135;"#,
    },
    Declaration {
        module: "shared/tessellation",
        name: "TEXELS_INSIDE",
        sampling: None,
        uses: &[],
        text: r#"// The distance from the edge of a clamped map, in texels, at which its cells are surely reached:
// half a texel, and a 64th.
const TEXELS_INSIDE = 0.515625;"#,
    },
    Declaration {
        module: "shared/tessellation",
        name: "Tessellation",
        sampling: None,
        uses: &[],
        text: r#"// Settings of a tessellated base: the view, and the sizes of the base.
struct Tessellation {
    // The eye, and unit vectors of the camera.
    eye: vec4f,
    right: vec4f,
    up: vec4f,
    forward: vec4f,
    // Planes that cull: nothing is made at a position p where dot(plane, (p, 1)) > 0.
    planes: array<vec4f, 5>,
    // The middle of the picture, in voxels.
    middle: vec2f,
    // Voxels of a metre, in perspective at a depth of 1 m.
    per_m: f32,
    // Voxels along the view axis from a depth to twice that.
    per_doubling: f32,
    // The least depth; nearer sides are divided as if they were there.
    near_m: f32,
    // 1 where rays are parallel.
    is_parallel: u32,
    // Levels of the height map that are seen, at least 1.
    levels: u32,
    // Vertices, edges and triangles of the base.
    vertices: u32,
    edges: u32,
    patches: u32,
    // The most points besides the base's vertices, and the most triangles: with more the grid is coarser.
    most_points: u32,
    most_triangles: u32,
    // Parts for a unit of u and of v; 0 where sides are divided by voxels.
    parts_of_uv: vec2f,
    // 1 if voxels fill the inside, too.
    is_swept: u32,
}"#,
    },
    Declaration {
        module: "shared/tessellation",
        name: "BaseVertex",
        sampling: None,
        uses: &[],
        text: r#"// A vertex of the base.
struct BaseVertex {
    position: vec3f,
    // The vertex whose place on the map gives the displacement: one for each position.
    seen: u32,
    // The direction of displacement, of any length: the same for all vertices at a position.
    direction: vec3f,
    // Texels of the map per metre around it.
    texels_per_m: f32,
    normal: vec3f,
    tangent: vec3f,
    bitangent: vec3f,
    // The derivatives of the direction by u and v.
    turn_u: vec3f,
    turn_v: vec3f,
    uv: vec2f,
}"#,
    },
    Declaration {
        module: "shared/tessellation",
        name: "BaseEdge",
        sampling: None,
        uses: &[],
        text: r#"// An edge between two vertices of the base.
struct BaseEdge {
    // The ends, in an order that all edges between the same positions agree on.
    ends: vec2u,
    // The ends of the edge between these positions that gives the points' places.
    seen: vec2u,
    // The change of u and v along the edge; the greatest among all edges between the same
    // positions.
    along: vec2f,
    // The triangles at the edge. An edge with one triangle has it twice; an edge with more than two
    // has COUNTLESS twice.
    patches: vec2u,
}"#,
    },
    Declaration {
        module: "shared/tessellation",
        name: "BasePatch",
        sampling: None,
        uses: &[],
        text: r#"// A triangle of the base.
struct BasePatch {
    corners: vec3u,
    // The least displacement on it, in metres.
    low_m: f32,
    // The edges between its corners, from the first on.
    edges: vec3u,
    // The greatest.
    high_m: f32,
}"#,
    },
    Declaration {
        module: "shared/tessellation",
        name: "Voxel",
        sampling: None,
        uses: &[],
        text: r#"// A vertex in grid space.
struct Voxel {
    // The voxel of the vertex: right, down and away from the eye.
    at: vec3i,
    // The weight where points are divided in the picture: the inverse of its depth in perspective;
    // 1 where they are divided on the base.
    share: f32,
}"#,
    },
    Declaration {
        module: "shared/tessellation",
        name: "BaseSite",
        sampling: None,
        uses: &[],
        text: r#"// A point of the base, with its data.
struct BaseSite {
    position: vec3f,
    direction: vec3f,
    // The place on the map that gives the displacement, and the point's own place on the map.
    seen_uv: vec2f,
    uv: vec2f,
    // Texels of the map per metre, and the depth. Their product gives the level of the map.
    texels_per_m: f32,
    depth: f32,
    normal: vec3f,
    tangent: vec3f,
    bitangent: vec3f,
    turn_u: vec3f,
    turn_v: vec3f,
}"#,
    },
    Declaration {
        module: "shared/tessellation",
        name: "log2_of",
        sampling: None,
        uses: &["ROOT_OF_TWO"],
        text: r#"// The logarithm of a number above 0 to the base 2, by additions, products and quotients alone.
fn log2_of(number: f32) -> f32 {
    var rest = number;
    var exponent = 0.0;
    while (rest > ROOT_OF_TWO) {
        rest = rest * 0.5;
        exponent = exponent + 1.0;
    }
    while (rest * ROOT_OF_TWO < 1.0) {
        rest = rest * 2.0;
        exponent = exponent - 1.0;
    }
    // ln x = 2 artanh((x - 1) / (x + 1)), and its argument is at most 0.172.
    let part = (rest - 1.0) / (rest + 1.0);
    let square = part * part;
    let sum = 1.0 + square * (0.33333334 + square * (0.2 + square * (0.14285715 + square * 0.11111111)));
    return exponent + 2.8853900 * part * sum;
}"#,
    },
    Declaration {
        module: "shared/tessellation",
        name: "voxel_of",
        sampling: None,
        uses: &["FARTHEST_VOXEL", "Tessellation", "Voxel", "log2_of"],
        text: r#"// A position in grid space.
fn voxel_of(grid: Tessellation, position: vec3f) -> Voxel {
    let from_eye = position - grid.eye.xyz;
    let depth = dot(grid.forward.xyz, from_eye);
    let seen = max(depth, grid.near_m);
    var share = 1.0;
    var away = depth * grid.per_m;
    if (grid.is_parallel == 0u) {
        share = 1.0 / seen;
        away = log2_of(seen / grid.near_m) * grid.per_doubling;
    }
    let right = dot(grid.right.xyz, from_eye) * grid.per_m * share + grid.middle.x;
    let down = grid.middle.y - dot(grid.up.xyz, from_eye) * grid.per_m * share;
    let far = vec3f(FARTHEST_VOXEL, FARTHEST_VOXEL, FARTHEST_VOXEL);
    let at = clamp(vec3f(right, down, away), -far, far);
    return Voxel(vec3i(floor(at + vec3f(0.5, 0.5, 0.5))), select(share, 1.0, grid.parts_of_uv.x > 0.0));
}"#,
    },
    Declaration {
        module: "shared/tessellation",
        name: "coarser_voxel",
        sampling: None,
        uses: &[],
        text: r#"// A voxel of a grid that is coarser by `level` doublings.
fn coarser_voxel(at: vec3i, level: u32) -> vec3i {
    return vec3i(at.x >> level, at.y >> level, at.z >> level);
}"#,
    },
    Declaration {
        module: "shared/tessellation",
        name: "parts_by_voxels",
        sampling: None,
        uses: &["DICE_PARTS", "Voxel", "coarser_voxel", "longest_of"],
        text: r#"// The number of parts of an edge between two voxels, in a grid that is coarser by `level`
// doublings.
fn parts_by_voxels(a: Voxel, b: Voxel, level: u32) -> u32 {
    let apart = longest_of(coarser_voxel(b.at, level) - coarser_voxel(a.at, level));
    return clamp(u32(apart), 1u, DICE_PARTS);
}"#,
    },
    Declaration {
        module: "shared/tessellation",
        name: "parts_by_uv",
        sampling: None,
        uses: &["DICE_PARTS", "PARTS_ROUNDING", "Tessellation"],
        text: r#"// The number of parts of an edge by its change of u and v.
fn parts_by_uv(grid: Tessellation, along: vec2f, level: u32) -> u32 {
    let both = along * grid.parts_of_uv;
    let parts = ceil(max(both.x, both.y) / f32(1u << level) - PARTS_ROUNDING);
    return u32(clamp(parts, 1.0, f32(DICE_PARTS)));
}"#,
    },
    Declaration {
        module: "shared/tessellation",
        name: "parts_between",
        sampling: None,
        uses: &["Tessellation", "Voxel", "parts_by_uv", "parts_by_voxels"],
        text: r#"// The number of parts of an edge between two voxels. `along` is its change of u and v.
fn parts_between(grid: Tessellation, a: Voxel, b: Voxel, along: vec2f, level: u32) -> u32 {
    if (grid.parts_of_uv.x > 0.0) {
        return parts_by_uv(grid, along, level);
    }
    return parts_by_voxels(a, b, level);
}"#,
    },
    Declaration {
        module: "shared/tessellation",
        name: "is_swept",
        sampling: None,
        uses: &["SWEPT_PARTS", "Tessellation", "Voxel", "coarser_voxel", "longest_of"],
        text: r#"// Whether voxels fill the inside of a triangle.
fn is_swept(grid: Tessellation, a: Voxel, b: Voxel, c: Voxel, level: u32) -> bool {
    let first = coarser_voxel(a.at, level);
    let second = coarser_voxel(b.at, level);
    let third = coarser_voxel(c.at, level);
    let longest = max(max(longest_of(second - first), longest_of(third - second)), longest_of(first - third));
    return longest > 0 && longest <= SWEPT_PARTS && grid.is_swept == 1u;
}"#,
    },
    Declaration {
        module: "shared/tessellation",
        name: "sweep_on",
        sampling: None,
        uses: &["Sweep", "Voxel", "coarser_voxel", "sweep_of"],
        text: r#"// The sweep of a triangle in a grid that is coarser by `level` doublings.
fn sweep_on(a: Voxel, b: Voxel, c: Voxel, level: u32) -> Sweep {
    return sweep_of(coarser_voxel(a.at, level), coarser_voxel(b.at, level), coarser_voxel(c.at, level));
}"#,
    },
    Declaration {
        module: "shared/tessellation",
        name: "is_before",
        sampling: None,
        uses: &[],
        text: r#"// Whether a corner lies before a plane at both the least and the greatest displacement.
fn is_before(plane: vec4f, position: vec3f, direction: vec3f, low_m: f32, high_m: f32) -> bool {
    let low = dot(plane.xyz, position + direction * low_m) + plane.w;
    let high = dot(plane.xyz, position + direction * high_m) + plane.w;
    return low > 0.0 && high > 0.0;
}"#,
    },
    Declaration {
        module: "shared/tessellation",
        name: "is_left_out",
        sampling: None,
        uses: &["BaseVertex", "Tessellation", "is_before"],
        text: r#"// Whether all of a displaced triangle lies before one of the planes. It is within the hull of its
// corners at the least and the greatest displacement.
fn is_left_out(
    grid: Tessellation,
    a: BaseVertex,
    b: BaseVertex,
    c: BaseVertex,
    low_m: f32,
    high_m: f32,
) -> bool {
    var k = 0u;
    while (k < 5u) {
        let plane = grid.planes[k];
        k = k + 1u;
        if (is_before(plane, a.position, a.direction, low_m, high_m)
            && is_before(plane, b.position, b.direction, low_m, high_m)
            && is_before(plane, c.position, c.direction, low_m, high_m)) {
            return true;
        }
    }
    return false;
}"#,
    },
    Declaration {
        module: "shared/tessellation",
        name: "site_of_vertex",
        sampling: None,
        uses: &["BaseSite", "BaseVertex", "Voxel"],
        text: r#"// A vertex of the base with the displacement of another one.
fn site_of_vertex(vertex: BaseVertex, seen: BaseVertex, voxel: Voxel) -> BaseSite {
    return BaseSite(
        vertex.position,
        vertex.direction,
        seen.uv,
        vertex.uv,
        seen.texels_per_m,
        1.0 / voxel.share,
        vertex.normal,
        vertex.tangent,
        vertex.bitangent,
        vertex.turn_u,
        vertex.turn_v,
    );
}"#,
    },
    Declaration {
        module: "shared/tessellation",
        name: "site_between",
        sampling: None,
        uses: &["BaseSite", "weighted_site"],
        text: r#"// The point of an edge with `at` of its `parts` parts before it, between the sites of its two ends.
// `shares` are the weights of the ends in the picture.
fn site_between(a: BaseSite, b: BaseSite, shares: vec2f, at: u32, parts: u32) -> BaseSite {
    let of_a = f32(parts - at) * shares.x;
    let of_b = f32(at) * shares.y;
    let sum = of_a + of_b;
    return weighted_site(a, b, b, vec3f(of_a / sum, of_b / sum, 0.0));
}"#,
    },
    Declaration {
        module: "shared/tessellation",
        name: "site_inside",
        sampling: None,
        uses: &["BaseSite", "weighted_site"],
        text: r#"// The point inside a triangle with those weights in the picture.
fn site_inside(a: BaseSite, b: BaseSite, c: BaseSite, shares: vec3f, weights: vec3f) -> BaseSite {
    let shared_out = weights * shares;
    let sum = shared_out.x + shared_out.y + shared_out.z;
    return weighted_site(a, b, c, shared_out / sum);
}"#,
    },
    Declaration {
        module: "shared/tessellation",
        name: "weighted_site",
        sampling: None,
        uses: &["BaseSite"],
        text: r#"fn weighted_site(a: BaseSite, b: BaseSite, c: BaseSite, w: vec3f) -> BaseSite {
    return BaseSite(
        a.position * w.x + b.position * w.y + c.position * w.z,
        a.direction * w.x + b.direction * w.y + c.direction * w.z,
        a.seen_uv * w.x + b.seen_uv * w.y + c.seen_uv * w.z,
        a.uv * w.x + b.uv * w.y + c.uv * w.z,
        a.texels_per_m * w.x + b.texels_per_m * w.y + c.texels_per_m * w.z,
        a.depth * w.x + b.depth * w.y + c.depth * w.z,
        a.normal * w.x + b.normal * w.y + c.normal * w.z,
        a.tangent * w.x + b.tangent * w.y + c.tangent * w.z,
        a.bitangent * w.x + b.bitangent * w.y + c.bitangent * w.z,
        a.turn_u * w.x + b.turn_u * w.y + c.turn_u * w.z,
        a.turn_v * w.x + b.turn_v * w.y + c.turn_v * w.z,
    );
}"#,
    },
    Declaration {
        module: "shared/tessellation",
        name: "relief_between_levels",
        sampling: None,
        uses: &["height_and_slope"],
        text: r#"// The height of the map and its derivatives by u and v, at a level between two mip levels.
fn relief_between_levels(uv: vec2f, level: f32) -> vec3f {
    let finer = u32(level);
    let part = level - f32(finer);
    let fine = height_and_slope(uv, finer);
    if (part == 0.0) {
        return fine;
    }
    return fine + (height_and_slope(uv, finer + 1u) - fine) * part;
}"#,
    },
    Declaration {
        module: "shared/tessellation",
        name: "sloped_uv",
        sampling: None,
        uses: &["TEXELS_INSIDE", "WRAP_CLAMP", "height_size", "surface_settings"],
        text: r#"// The place where the slope of a vertex is taken: on the edge of a clamped map in the cells inside.
// Nothing is known of the ground beyond, and tiles of a terrain must meet without a rim.
fn sloped_uv(uv: vec2f, level: f32) -> vec2f {
    let is_inside = min(uv.x, uv.y) >= 0.0 && max(uv.x, uv.y) <= 1.0;
    if (surface_settings.wrap != WRAP_CLAMP || !is_inside) {
        return uv;
    }
    let least = TEXELS_INSIDE / height_size(u32(ceil(level)));
    return clamp(uv, least, max(vec2f(1.0, 1.0) - least, least));
}"#,
    },
    Declaration {
        module: "shared/tessellation",
        name: "level_at",
        sampling: None,
        uses: &["BaseSite", "Tessellation", "log2_of"],
        text: r#"// The level whose texels are as wide as a voxel.
fn level_at(grid: Tessellation, site: BaseSite) -> f32 {
    if (grid.levels <= 1u) {
        return 0.0;
    }
    let texels = max(site.texels_per_m * site.depth / grid.per_m, 1.0);
    return min(log2_of(texels), f32(grid.levels - 1u));
}"#,
    },
    Declaration {
        module: "shared/tessellation",
        name: "displaced_derivative",
        sampling: None,
        uses: &[],
        text: r#"// The derivative of a displaced position by a texture coordinate: of the base in the plane at right
// angles to its normal, of the displacement, and of its direction.
fn displaced_derivative(along: vec3f, up: vec3f, rise: vec3f, turned: vec3f) -> vec3f {
    return along - up * dot(up, along) + rise + turned;
}"#,
    },
    Declaration {
        module: "shared/tessellation",
        name: "displaced_site",
        sampling: None,
        uses: &["BaseSite", "Corner", "Tessellation", "displaced_derivative", "level_at", "relief_between_levels", "sloped_uv", "surface_settings"],
        text: r#"// The displaced corner at a point of the base. Its normal is the displaced surface's (Szirmay-Kalos
// and Umenhoffer 2008, equation 9, with the turning of the direction of displacement).
fn displaced_site(grid: Tessellation, site: BaseSite) -> Corner {
    let level = level_at(grid, site);
    let seen = relief_between_levels(site.seen_uv, level);
    let own = relief_between_levels(sloped_uv(site.uv, level), level);
    let scale_m = surface_settings.scale_m;
    let position = site.position + site.direction * (seen.x * scale_m + surface_settings.bias_m);
    let metres = own.x * scale_m + surface_settings.bias_m;
    var up = site.normal;
    if (dot(up, up) > 0.0) {
        up = normalize(up);
    }
    let rise_u = site.direction * (own.y * scale_m);
    let rise_v = site.direction * (own.z * scale_m);
    let along = displaced_derivative(site.tangent, up, rise_u, site.turn_u * metres);
    let down = displaced_derivative(site.bitangent, up, rise_v, site.turn_v * metres);
    let is_mirrored = dot(cross(site.bitangent, site.tangent), up) < 0.0;
    var normal = cross(down, along) * select(1.0, -1.0, is_mirrored);
    if (dot(normal, normal) > 0.0) {
        normal = normalize(normal);
    } else {
        normal = up;
    }
    return Corner(position, normal, along, down, site.uv, vec3f(0.0, 0.0, 0.0));
}"#,
    },
    Declaration {
        module: "shared/tone",
        name: "TONE_AGX",
        sampling: None,
        uses: &[],
        text: r#"// The curve AgX among all curves; 0 leaves colours as they are.
const TONE_AGX: u32 = 1u;"#,
    },
    Declaration {
        module: "shared/tone",
        name: "toned",
        sampling: None,
        uses: &["TONE_AGX", "agx"],
        text: r#"// The colour of light by a tone curve; both are linear sRGB.
fn toned(tone: u32, light: vec3f) -> vec3f {
    if (tone == TONE_AGX) {
        return agx(light);
    }
    return light;
}"#,
    },
    Declaration {
        module: "shared/tone",
        name: "agx",
        sampling: None,
        uses: &[],
        text: r#"// AgX (Troy Sobotka, 2022) as in three.js. Bright colours become pale; none is clipped.
fn agx(light: vec3f) -> vec3f {
    // Columns: what red, green and blue give.
    let to_rec2020 = mat3x3f(0.6274, 0.0691, 0.0164, 0.3293, 0.9195, 0.0880, 0.0433, 0.0113, 0.8956);
    let from_rec2020 =
        mat3x3f(1.6605, -0.1246, -0.0182, -0.5876, 1.1329, -0.1006, -0.0728, -0.0083, 1.1187);
    let inset = mat3x3f(
        0.85662715, 0.13731897, 0.11189821, 0.09512124, 0.761242, 0.07679942, 0.048251606, 0.10143904,
        0.81130237,
    );
    let outset = mat3x3f(
        1.1271006, -0.14132976, -0.14132976, -0.11060664, 1.1578237, -0.11060664, -0.016493939, -0.016493939,
        1.2519364,
    );
    let stops = log2(max(inset * (to_rec2020 * light), vec3f(1e-10)));
    let part = clamp((stops + 12.47393) / 16.499999, vec3f(0.0), vec3f(1.0));
    var curve = 15.5 * part - 40.14;
    curve = curve * part + 31.96;
    curve = curve * part - 6.868;
    curve = curve * part + 0.4298;
    curve = curve * part + 0.1191;
    curve = curve * part - 0.00232;
    let shown = pow(max(outset * curve, vec3f(0.0)), vec3f(2.2));
    return clamp(from_rec2020 * shown, vec3f(0.0), vec3f(1.0));
}"#,
    },
    Declaration {
        module: "shared/tone",
        name: "srgb_bytes",
        sampling: None,
        uses: &[],
        text: r#"// Red, green, blue and 255 in sRGB (IEC 61966-2-1), the first in the lowest byte.
fn srgb_bytes(linear: vec3f) -> u32 {
    let inside = clamp(linear, vec3f(0.0), vec3f(1.0));
    let curved = 1.055 * pow(inside, vec3f(1.0 / 2.4)) - 0.055;
    let encoded = select(curved, 12.92 * inside, inside <= vec3f(0.0031308));
    let bytes = vec3u(encoded * 255.0 + 0.5);
    return bytes.x | (bytes.y << 8u) | (bytes.z << 16u) | (255u << 24u);
}"#,
    },
    Declaration {
        module: "shared/translucent",
        name: "LEAST_TRANSMITTANCE",
        sampling: None,
        uses: &[],
        text: r#"// The transmittance from which on nothing more is gathered: less than 1/255 of what a picture can show.
const LEAST_TRANSMITTANCE = 0.00006103515625;"#,
    },
    Declaration {
        module: "shared/translucent",
        name: "PIECE_HALVINGS",
        sampling: None,
        uses: &[],
        text: r#"// Halvings of a way through a cell. Where a volume is so dense that they do not suffice, it is a surface.
const PIECE_HALVINGS = 24u;"#,
    },
    Declaration {
        module: "shared/translucent",
        name: "MOST_CELLS",
        sampling: None,
        uses: &[],
        text: r#"// Cells that are looked at together, unless what they scatter is less than this part of a look's share.
// The light changes from voxel to voxel where a volume shadows itself.
const MOST_CELLS = 2u;"#,
    },
    Declaration {
        module: "shared/translucent",
        name: "LEAST_SHARE",
        sampling: None,
        uses: &[],
        text: r#"const LEAST_SHARE = 0.125;"#,
    },
    Declaration {
        module: "shared/translucent",
        name: "DARK_DEPTH",
        sampling: None,
        uses: &[],
        text: r#"// The optical depth at which a walk toward a light ends: the light is gone.
const DARK_DEPTH = 8.0;"#,
    },
    Declaration {
        module: "shared/translucent",
        name: "EVENLY",
        sampling: None,
        uses: &[],
        text: r#"// The part of a light's irradiance that leaves toward the eye, for each part that is scattered: the same
// in all directions. A white surface that faces the light scatters four times as much toward its own
// side.
const EVENLY = 0.25;"#,
    },
    Declaration {
        module: "shared/translucent",
        name: "nothing_gathered",
        sampling: None,
        uses: &["Gathered", "NEVER"],
        text: r#"// A ray before it comes upon a volume, and up to which place of the ray something opaque lets it.
fn nothing_gathered(reach_m: f32) -> Gathered {
    return Gathered(vec3f(0.0, 0.0, 0.0), 1.0, NEVER, 0.0 - NEVER, reach_m, 0.0);
}"#,
    },
    Declaration {
        module: "shared/translucent",
        name: "reach_of_hit",
        sampling: None,
        uses: &["NEVER"],
        text: r#"// Metres along a ray to an opaque hit, from its depth along the view axis; NEVER without one.
fn reach_of_hit(found: u32, depth: f32, direction: vec3f) -> f32 {
    return select(NEVER, depth * length(direction), found == 1u);
}"#,
    },
    Declaration {
        module: "shared/translucent",
        name: "goes_on",
        sampling: None,
        uses: &["Gathered", "LEAST_TRANSMITTANCE"],
        text: r#"// Whether there may be more to gather.
fn goes_on(seen: Gathered) -> bool {
    return seen.transmittance > LEAST_TRANSMITTANCE;
}"#,
    },
    Declaration {
        module: "shared/translucent",
        name: "field_between",
        sampling: None,
        uses: &["SURFACE_VALUE", "VoxelCell", "VoxelPath", "gap_in_cell"],
        text: r#"// The integral of the field along a path between two parameters in a cell.
fn field_between(way: VoxelPath, cell: vec3f, corners: VoxelCell, begin: f32, end: f32) -> f32 {
    let gap = gap_in_cell(way, cell, corners, begin, end - begin);
    let mean = gap.a + gap.b * 0.5 + gap.c * 0.33333334 + gap.d * 0.25 + gap.e * 0.2;
    return max(SURFACE_VALUE - mean, 0.0) * (end - begin);
}"#,
    },
    Declaration {
        module: "shared/translucent",
        name: "field_along",
        sampling: None,
        uses: &["DARK_DEPTH", "NEVER", "Path", "field_between", "first_part", "next_part", "turning_point", "voxel_cell", "voxel_path"],
        text: r#"// The integral of the field along a path, in metres; but for the rest of it once its optical depth is
// DARK_DEPTH.
fn field_along(path: Path, params: vec4f) -> f32 {
    let way = voxel_path(path);
    let turn = turning_point(way);
    let enough = DARK_DEPTH / max(params.x, 1.0 / NEVER);
    let limit = u32(params.z);
    var sum = 0.0;
    var part = first_part(path, way, turn);
    var cells = 1u;
    var goes = true;
    while (goes) {
        if (part.empty < 0.0) {
            sum = sum + field_between(way, part.cell, voxel_cell(vec3i(part.cell)), part.begin, part.end);
        }
        goes = part.is_last == 0u && cells < limit && sum < enough;
        if (goes) {
            part = next_part(path, way, turn, part);
            cells = cells + 1u;
        }
    }
    return sum;
}"#,
    },
    Declaration {
        module: "shared/translucent",
        name: "optical_depth",
        sampling: None,
        uses: &["Path", "SEARCH_STAGE", "field_along", "surface_settings"],
        text: r#"// The optical depth of a volume along a path, up to a little more than DARK_DEPTH.
fn optical_depth(path: Path) -> f32 {
    let params = surface_settings.choices[SEARCH_STAGE].params;
    return field_along(path, params) * params.x;
}"#,
    },
    Declaration {
        module: "shared/translucent",
        name: "arriving",
        sampling: None,
        uses: &["Entered", "Hit", "NEVER", "Path", "RAY_VIEW", "SHADOW_STAGE", "Toward", "WRAP_CLAMP", "climb", "inside_unit", "near_uv", "optical_depth", "patch_seen", "surface_settings", "transmittance_of"],
        text: r#"// The part of a light that arrives at a place in the volume: through the volume of the same surface, in
// the frame of the place, and by the shadow maps if they are looked up.
fn arriving(at: Entered, hit: Hit, toward: Toward) -> f32 {
    if (surface_settings.has_shadows == 0u) {
        return 1.0;
    }
    let change = climb(at, toward.direction);
    let end = select(0.0, 1.0, change.z > 0.0);
    let across = (end - hit.height) / change.z;
    let uv = near_uv(hit.uv);
    var interval = vec2f(0.0, min(select(NEVER, across, change.z != 0.0), toward.distance));
    if (surface_settings.wrap == WRAP_CLAMP) {
        interval = inside_unit(uv.x, change.x, interval);
        interval = inside_unit(uv.y, change.y, interval);
    }
    let h = vec3f(hit.height, change.z, 0.0);
    let path = Path(uv, change.xy, h, interval.y, 0.0, at.metric, RAY_VIEW, at.level, 0.0, 1.0, 0.0);
    var part = 1.0;
    if (path.exit > 0.0) {
        part = transmittance_of(optical_depth(path));
    }
    let shadow = surface_settings.choices[SHADOW_STAGE].params;
    if (shadow.x > 0.0) {
        // A small disc that faces the light.
        part = part * patch_seen(at, toward.direction, toward.number, shadow.z, shadow.w);
    }
    return part;
}"#,
    },
    Declaration {
        module: "shared/translucent",
        name: "light_around",
        sampling: None,
        uses: &["Entered", "Hit", "Material", "NO_COST", "Path", "ambient_stage"],
        text: r#"// The light from all around that a white volume scatters: the mean over six directions, which serves all
// lights that change slowly with the direction.
fn light_around(at: Entered, path: Path) -> vec3f {
    let hit = Hit(1u, 0u, path.uv, path.h.x, 0.0, NO_COST);
    let zero = vec3f(0.0, 0.0, 0.0);
    let white = vec3f(1.0, 1.0, 1.0);
    let material = Material(white, zero, zero, white, zero, 1.0, 1.0, 1.0, 1.0, 1.0, 0.5, 0.0);
    var light = zero;
    var k = 0u;
    while (k < 6u) {
        let along = select(-1.0, 1.0, (k & 1u) == 0u);
        let axis = k >> 1u;
        let normal = vec3f(
            select(0.0, along, axis == 0u), select(0.0, along, axis == 1u), select(0.0, along, axis == 2u)
        );
        light = light + ambient_stage(at, hit, normal, normal, material);
        k = k + 1u;
    }
    return light * 0.16666667;
}"#,
    },
    Declaration {
        module: "shared/translucent",
        name: "scattered",
        sampling: None,
        uses: &["EVENLY", "Entered", "Hit", "NO_COST", "Path", "PixelIn", "arriving", "color_or_white", "frame", "path_height", "path_uv", "place_on_segment", "surface_settings", "toward_light"],
        text: r#"// The light that the volume scatters toward the eye at a place of a path, where it is dense. Light is
// scattered once, the same in all directions. The volume's own light is added.
fn scattered(pixel: PixelIn, at: Entered, path: Path, t: f32, around: vec3f) -> vec3f {
    let hit = Hit(1u, 0u, path_uv(path, t), path_height(path, t), t, NO_COST);
    let placed = place_on_segment(pixel, at, path, hit);
    let albedo = surface_settings.diffuse.xyz * color_or_white(hit.uv, at.footprint);
    var light = around;
    var k = 0u;
    while (k < frame.light_count) {
        let toward = toward_light(k, placed.point);
        let part = arriving(placed, hit, toward) * toward.falloff;
        light = light + frame.lights[k].color.xyz * (EVENLY * part);
        k = k + 1u;
    }
    return albedo * light + surface_settings.emission.xyz;
}"#,
    },
    Declaration {
        module: "shared/translucent",
        name: "Gathering",
        sampling: None,
        uses: &["Gathered"],
        text: r#"// What a ray sees so far, and how much light is still to be looked at on this segment: its part, the sum
// of its places, each times its part, and the cells in which it was scattered.
struct Gathering {
    seen: Gathered,
    part: f32,
    places: f32,
    cells: u32,
}"#,
    },
    Declaration {
        module: "shared/translucent",
        name: "looked_at",
        sampling: None,
        uses: &["Entered", "Gathering", "Path", "PixelIn", "scattered"],
        text: r#"// Looks at the light that arrives, if it makes a difference, for all that was scattered since the last look.
fn looked_at(before: Gathering, pixel: PixelIn, at: Entered, path: Path, around: vec3f) -> Gathering {
    if (!(before.part > 0.0)) {
        return before;
    }
    let light = scattered(pixel, at, path, before.places / before.part, around);
    var now = Gathering(before.seen, 0.0, 0.0, 0u);
    now.seen.light = now.seen.light + light * (before.part + now.seen.pending);
    now.seen.pending = 0.0;
    return now;
}"#,
    },
    Declaration {
        module: "shared/translucent",
        name: "end_of_piece",
        sampling: None,
        uses: &["CellPart", "PIECE_HALVINGS", "VoxelCell", "VoxelPath", "field_between", "transmittance_of"],
        text: r#"// The end of the piece of a cell that begins at a parameter: as far as it scatters no more than a part
// of the light.
fn end_of_piece(
    way: VoxelPath,
    part: CellPart,
    corners: VoxelCell,
    begin: f32,
    extinction: f32,
    most: f32,
) -> f32 {
    var end = part.end;
    var k = 0u;
    while (k < PIECE_HALVINGS
        && 1.0 - transmittance_of(field_between(way, part.cell, corners, begin, end) * extinction) > most) {
        end = begin + 0.5 * (end - begin);
        k = k + 1u;
    }
    return end;
}"#,
    },
    Declaration {
        module: "shared/translucent",
        name: "gathered_in_cell",
        sampling: None,
        uses: &["CellPart", "Entered", "Gathering", "Hit", "LEAST_SHARE", "MOST_CELLS", "NEVER", "NO_COST", "Path", "PixelIn", "SEARCH_STAGE", "VoxelPath", "depth_on_ray", "end_of_piece", "field_between", "goes_on", "looked_at", "surface_settings", "transmittance_of", "voxel_cell"],
        text: r#"// What a ray sees behind one more cell, piece by piece.
fn gathered_in_cell(
    before: Gathering,
    pixel: PixelIn,
    at: Entered,
    path: Path,
    way: VoxelPath,
    part: CellPart,
    around: vec3f,
) -> Gathering {
    let params = surface_settings.choices[SEARCH_STAGE].params;
    let corners = voxel_cell(vec3i(part.cell));
    let share = 1.0 / params.y;
    var now = before;
    var begin = part.begin;
    while (begin < part.end && goes_on(now.seen)) {
        let end = end_of_piece(way, part, corners, begin, params.x, share / now.seen.transmittance);
        let depth = field_between(way, part.cell, corners, begin, end) * params.x;
        if (depth > 0.0 && now.seen.entry == NEVER) {
            now.seen.entry = depth_on_ray(pixel, path, Hit(1u, 0u, path.uv, path.h.x, begin, NO_COST));
        }
        let through = transmittance_of(depth);
        let scattered_part = now.seen.transmittance * (1.0 - through);
        now.seen.transmittance = now.seen.transmittance * through;
        now.part = now.part + scattered_part;
        now.places = now.places + scattered_part * (0.5 * (begin + end));
        if (now.part >= share) {
            now = looked_at(now, pixel, at, path, around);
        }
        begin = select(part.end, end, end > begin);
    }
    now.cells = now.cells + 1u;
    if (now.cells >= MOST_CELLS && now.part >= share * LEAST_SHARE) {
        now = looked_at(now, pixel, at, path, around);
    }
    return now;
}"#,
    },
    Declaration {
        module: "shared/translucent",
        name: "way_into_heights",
        sampling: None,
        uses: &[],
        text: r#"// The way from a height beyond 0 or 1 back to it, along a slope; 0 from a height between. Shells reach
// beyond their ends by rounding.
fn way_into_heights(height: f32, slope: f32) -> f32 {
    let beyond = height - clamp(height, 0.0, 1.0);
    return select(0.0, abs(beyond / slope), abs(beyond) > 0.0 && abs(slope) > 0.0);
}"#,
    },
    Declaration {
        module: "shared/translucent",
        name: "rest_of_segment",
        sampling: None,
        uses: &["Path", "beginning_at", "path_height", "path_slope", "way_into_heights"],
        text: r#"// A segment without what is gathered already, and without what something opaque hides. Neighbouring
// shells overlap by rounding.
fn rest_of_segment(path: Path, until_m: f32, reach_m: f32) -> Path {
    let before = way_into_heights(path.h.x, path.h.y);
    let behind = way_into_heights(path_height(path, path.exit), path_slope(path, path.exit));
    let begin = max(before, until_m - path.start);
    var rest = path;
    if (begin > 0.0) {
        rest = beginning_at(path, begin);
    }
    rest.exit = min(path.exit - behind - max(begin, 0.0), reach_m - rest.start);
    return rest;
}"#,
    },
    Declaration {
        module: "shared/translucent",
        name: "gather_segment",
        sampling: None,
        uses: &["Entered", "Gathered", "Gathering", "LEAST_TRANSMITTANCE", "PixelIn", "SEARCH_STAGE", "first_part", "gathered_in_cell", "goes_on", "light_around", "looked_at", "next_part", "rest_of_segment", "segment_of", "surface_settings", "turning_point", "voxel_path"],
        text: r#"// What a ray sees behind segment `k` of a shell. The segments of all shells are to be given in the order
// in which they begin.
fn gather_segment(before: Gathered, pixel: PixelIn, at: Entered, k: u32) -> Gathered {
    let path = rest_of_segment(segment_of(pixel, at, k), before.until_m, before.reach_m);
    if (!(path.exit > 0.0)) {
        return before;
    }
    let way = voxel_path(path);
    let turn = turning_point(way);
    let limit = u32(surface_settings.choices[SEARCH_STAGE].params.z);
    let around = light_around(at, path);
    var now = Gathering(before, 0.0, 0.0, 0u);
    now.seen.until_m = path.start + path.exit;
    var part = first_part(path, way, turn);
    var cells = 1u;
    var goes = true;
    while (goes) {
        if (part.empty < 0.0) {
            now = gathered_in_cell(now, pixel, at, path, way, part, around);
        } else if (now.part > LEAST_TRANSMITTANCE) {
            // What lies on both sides of a gap is lit by itself.
            now = looked_at(now, pixel, at, path, around);
        }
        goes = part.is_last == 0u && cells < limit && goes_on(now.seen);
        if (goes) {
            part = next_part(path, way, turn, part);
            cells = cells + 1u;
        }
    }
    // What hardly counts waits for the next look.
    if (now.part + now.seen.pending > LEAST_TRANSMITTANCE) {
        return looked_at(now, pixel, at, path, around).seen;
    }
    now.seen.pending = now.seen.pending + now.part;
    return now.seen;
}"#,
    },
    Declaration {
        module: "shared/translucent",
        name: "pass_segment",
        sampling: None,
        uses: &["Entered", "Gathered", "PixelIn", "optical_depth", "rest_of_segment", "segment_of", "transmittance_of"],
        text: r#"// The part of light that comes through segment `k` of a shell, as the transmittance of what is gathered. See
// `gather_segment`.
fn pass_segment(before: Gathered, pixel: PixelIn, at: Entered, k: u32) -> Gathered {
    let path = rest_of_segment(segment_of(pixel, at, k), before.until_m, before.reach_m);
    if (!(path.exit > 0.0)) {
        return before;
    }
    var seen = before;
    seen.until_m = path.start + path.exit;
    seen.transmittance = seen.transmittance * transmittance_of(optical_depth(path));
    return seen;
}"#,
    },
    Declaration {
        module: "shared/translucent",
        name: "seen_through",
        sampling: None,
        uses: &["Gathered"],
        text: r#"// A colour seen through a translucent volume. The fourth part is the covered part of the pixel.
fn seen_through(behind: vec4f, seen: Gathered) -> vec4f {
    let part = 1.0 - seen.transmittance;
    return vec4f(seen.light + behind.xyz * seen.transmittance, part + behind.w * seen.transmittance);
}"#,
    },
    Declaration {
        module: "shared/transmittance",
        name: "LOG2_E",
        sampling: None,
        uses: &[],
        text: r#"// The binary logarithm of e.
const LOG2_E = 1.44269504;"#,
    },
    Declaration {
        module: "shared/transmittance",
        name: "OPAQUE_DEPTH",
        sampling: None,
        uses: &[],
        text: r#"// Nothing that a picture can show comes through this depth. Powers of two stay far from the least float.
const OPAQUE_DEPTH = 80.0;"#,
    },
    Declaration {
        module: "shared/transmittance",
        name: "power_of_half",
        sampling: None,
        uses: &[],
        text: r#"// A power of two with a whole exponent from -0 to -127, by the digits of the exponent. The products are
// exact.
fn power_of_half(exponent: u32) -> f32 {
    var power = select(1.0, 0.5, (exponent & 1u) != 0u);
    power = power * select(1.0, 0.25, (exponent & 2u) != 0u);
    power = power * select(1.0, 0.0625, (exponent & 4u) != 0u);
    power = power * select(1.0, 0.00390625, (exponent & 8u) != 0u);
    power = power * select(1.0, 0.0000152587890625, (exponent & 16u) != 0u);
    power = power * select(1.0, 2.3283064365386962890625e-10, (exponent & 32u) != 0u);
    return power * select(1.0, 5.42101086242752217003726400434970855712890625e-20, (exponent & 64u) != 0u);
}"#,
    },
    Declaration {
        module: "shared/transmittance",
        name: "transmittance_of",
        sampling: None,
        uses: &["LOG2_E", "OPAQUE_DEPTH", "power_of_half"],
        text: r#"// e to the power of -depth, for depths from 0 on: 2 to a whole power times 2 to one from -1/2 to 1/2, by
// its series. It errs by at most 1.5e-7, and is 0 from OPAQUE_DEPTH on.
fn transmittance_of(depth: f32) -> f32 {
    if (!(depth < OPAQUE_DEPTH)) {
        return 0.0;
    }
    let twos = max(depth, 0.0) * LOG2_E;
    let whole = floor(twos + 0.5);
    let f = whole - twos;
    let high = 0.009618129 + f * (0.0013333558 + f * (0.00015403530 + f * 0.000015252734));
    let power = 1.0 + f * (0.69314718 + f * (0.24022651 + f * (0.055504109 + f * high)));
    return power * power_of_half(u32(whole));
}"#,
    },
    Declaration {
        module: "shared/types",
        name: "Path",
        sampling: None,
        uses: &[],
        text: r#"// A ray segment in texture space: (u, v) is linear in t, the normalised height is h.x + h.y t + h.z
// t². t is in metres along the ray, 0 at the entry (but see `bend`).
struct Path {
    uv: vec2f,
    duv: vec2f,
    h: vec3f,
    exit: f32,
    // The parameter t where the ray crosses the base surface. For an object's image: the image's
    // number.
    base: f32,
    // T·T, T·B, B·B in square metres per tile, and the displacement scale in metres.
    metric: vec4f,
    // Purpose of the ray: RAY_VIEW or RAY_SHADOW.
    ray: u32,
    // The level of detail of the maps that are read.
    level: u32,
    // Metres along the pixel's ray, from its origin, to the entry.
    start: f32,
    // The part of the ray's whole way through the relief that this segment is. Searches that spread
    // a number of steps over the whole way take that part of them.
    share: f32,
    // Curvature of the parameter for an image with perspective: metres along the ray are t / (1 -
    // bend t). In such an image rays are straight, and farther things look smaller. 0 otherwise.
    bend: f32,
}"#,
    },
    Declaration {
        module: "shared/types",
        name: "SearchResult",
        sampling: None,
        uses: &[],
        text: r#"// The result of a search. `status` is one of FOUND_*. `near` and `far` are parameters of the path,
// and the gaps are its heights above the surface there.
struct SearchResult {
    status: u32,
    near: f32,
    far: f32,
    near_gap: f32,
    far_gap: f32,
    // Reads, steps and bytes of the search.
    cost: vec3u,
}"#,
    },
    Declaration {
        module: "shared/types",
        name: "Hit",
        sampling: None,
        uses: &[],
        text: r#"// The end of a path. `uv` is not derived from t: offset limiting lands beside the ray.
struct Hit {
    found: u32,
    exhausted: u32,
    uv: vec2f,
    height: f32,
    t: f32,
    // Reads, steps and bytes of the search and the refinement.
    cost: vec3u,
}"#,
    },
    Declaration {
        module: "shared/types",
        name: "FirstHit",
        sampling: None,
        uses: &["Hit"],
        text: r#"// The first hit of a pixel's ray with a triangle's relief.
struct FirstHit {
    hit: Hit,
    // The number of its segment.
    segment: u32,
    // Orders the hits of a pixel's ray: the greater, the nearer. From 0, infinitely far away, to 1
    // at the eye.
    key: f32,
}"#,
    },
    Declaration {
        module: "shared/types",
        name: "Corner",
        sampling: None,
        uses: &[],
        text: r#"// A corner of a base triangle, in the world. Tangent and bitangent are as long as one tile in the
// world.
struct Corner {
    position: vec3f,
    normal: vec3f,
    tangent: vec3f,
    bitangent: vec3f,
    uv: vec2f,
    // Data for the surface stage alone; zeros for surfaces without any. Quadrics: x, y and z are
    // the coefficients of q(du, dv) = x du² + y du dv + z dv², which the base follows around the
    // corner. It is in metres a tile squared, positive along the normal. Slices: their height at
    // the corner, the distance between neighbours along an axis, and that axis, one of
    // SLICES_ALONG_*.
    of_surface: vec3f,
}"#,
    },
    Declaration {
        module: "shared/types",
        name: "Shell",
        sampling: None,
        uses: &[],
        text: r#"// The space that the relief of a base triangle may fill, between its corners moved along their
// normals.
struct Shell {
    // The least and the greatest height under the triangle.
    heights: vec2f,
    // The places of the corners, 0 to 2, in an order that all triangles at an edge agree on: two
    // bits for each, the first lowest. SHELL_FOLDED is added if the shell overlaps itself.
    order: u32,
    // The height of the smooth base above the triangle, in metres. Each number belongs to the edge
    // opposite to a corner, in that order, and is multiplied by the weights of the edge's ends.
    lift: vec3f,
}"#,
    },
    Declaration {
        module: "shared/types",
        name: "PixelIn",
        sampling: None,
        uses: &["Corner", "Shell"],
        text: r#"// A pixel's ray and the base triangle that it meets. The direction's component along the view axis is 1.
struct PixelIn {
    origin: vec3f,
    direction: vec3f,
    // -1 turns the triangle over: a back face seen two-sided.
    side: f32,
    a: Corner,
    b: Corner,
    c: Corner,
    shell: Shell,
}"#,
    },
    Declaration {
        module: "shared/types",
        name: "Entered",
        sampling: None,
        uses: &[],
        text: r#"// A ray's place on a surface: at first on its base; on the displaced surface after a hit has been
// placed.
struct Entered {
    // Number of segments of the way through the relief; 0 if the ray never enters it.
    segments: u32,
    // The point, in the world and in texture space, and the frame there.
    point: vec3f,
    uv: vec2f,
    tangent: vec3f,
    bitangent: vec3f,
    normal: vec3f,
    // See `Path`.
    metric: vec4f,
    level: u32,
    // The normal, of any length, of the plane in which footprints of pixels are measured.
    facing: vec3f,
    // The extent of the ray in a shell: metres from its nearest place to the triangle.
    span: vec2f,
    // `Corner.of_surface` at the point. For quadrics positive toward the ray's side; the fourth
    // number is the height of the point in the relief.
    of_surface: vec4f,
    // Width of the pixel's footprint in texels of the height map's finest level; 0 if everything is
    // seen in the finest level.
    footprint: f32,
    // The part, below 1, by which the traced relief is flattened: its heights are drawn toward
    // their mean.
    fade: f32,
    // For a placed hit: metres along the view axis, from the origin of the ray to the hit on the
    // ray.
    depth: f32,
}"#,
    },
    Declaration {
        module: "shared/types",
        name: "Gathered",
        sampling: None,
        uses: &[],
        text: r#"// What a ray sees of a translucent surface on its way so far.
struct Gathered {
    // Linear RGB: the light that is scattered toward the eye.
    light: vec3f,
    // The part of the light from behind that comes through.
    transmittance: f32,
    // Metres along the view axis to the first place that is not empty; NEVER without one.
    entry: f32,
    // Metres along the ray up to which its segments are gathered, and to something opaque.
    until_m: f32,
    reach_m: f32,
    // The part of the light that is scattered where it was not yet looked at.
    pending: f32,
}"#,
    },
    Declaration {
        module: "shared/types",
        name: "Detail",
        sampling: None,
        uses: &[],
        text: r#"// The level of detail of a pixel.
struct Detail {
    // The level of the maps that are traced.
    level: u32,
    // See `Entered`.
    footprint: f32,
    fade: f32,
}"#,
    },
    Declaration {
        module: "shared/types",
        name: "Toward",
        sampling: None,
        uses: &[],
        text: r#"// A light as a point of the surface sees it.
struct Toward {
    // Unit direction toward the light.
    direction: vec3f,
    // The factor on the light's colour at that distance.
    falloff: f32,
    // Metres to the light; more than any other number for a light that is infinitely far away.
    distance: f32,
    // Radius of the light's disc over its distance: the tangent of half its angular diameter.
    radius: f32,
    // The light's number in the frame.
    number: u32,
}"#,
    },
    Declaration {
        module: "shared/types",
        name: "Material",
        sampling: None,
        uses: &[],
        text: r#"// The material at a hit, read once for all lights. All colours are linear RGB.
struct Material {
    // The part of the light that is scattered in all directions, and the part that passes through the
    // surface.
    diffuse: vec3f,
    transmitted: vec3f,
    // The highlight's colour, or the part of the light that is reflected along the normal.
    specular: vec3f,
    // The part of a light that is the same from all around that leaves toward the eye.
    around: vec3f,
    // Light that the surface gives by itself.
    emission: vec3f,
    // The part of the light from all around that arrives, by the material's map.
    occlusion: f32,
    // The roughness in the footprint; its square alpha, the width of the facets' distribution; and the
    // square of alpha.
    roughness: f32,
    alpha: f32,
    squared_alpha: f32,
    // The cosine between the normal and the view, at least a little, and its share in the part of facets
    // that others hide.
    upright: f32,
    masking: f32,
    // The light that facets reflect more than once, as a part of the light reflected once by facets of
    // specular colour 1.
    again: f32,
}"#,
    },
    Declaration {
        module: "shared/types",
        name: "Mirrored",
        sampling: None,
        uses: &[],
        text: r#"// The mirrored part of the light from all around.
struct Mirrored {
    // The part of the light that is reflected.
    part: vec3f,
    // The deviation of facets from the normal, in radians.
    lean: f32,
    // The deviations of two lobes around the mirrored view, and the weight of the second.
    lobes: vec2f,
    second: f32,
    // How far the lobes are turned from the mirrored view, 0, to the normal, 1.
    turn: f32,
}"#,
    },
    Declaration {
        module: "shared/types",
        name: "LightRay",
        sampling: None,
        uses: &["Path"],
        text: r#"// A ray from a hit toward a light.
struct LightRay {
    // One of LIGHT_RAY_*.
    state: u32,
    // The path to search, for an open ray.
    path: Path,
}"#,
    },
    Declaration {
        module: "shared/types",
        name: "PixelOut",
        sampling: None,
        uses: &[],
        text: r#"// The result for a pixel. Zeros if `hit` is 0.
struct PixelOut {
    // Linear RGB, and 1.
    color: vec4f,
    // 1 if the pixel shows the surface.
    hit: u32,
    // 1 if the search ran out of steps: the hit is the last point that it reached.
    exhausted: u32,
    // Texture coordinates and normalised height of the hit, and its parameter on the path.
    uv: vec2f,
    height: f32,
    // The hit in the world, and the displaced surface's unit normal there.
    position: vec3f,
    normal: vec3f,
    // Metres from the eye along the view axis.
    depth: f32,
    t: f32,
    // Column and row of the first texel of the dual cell that the hit lies in.
    cell: vec2i,
    // Reads of the search and the refinement: of a cell, a place between texels, a texel or a node
    // each.
    reads: u32,
    // Steps of the search and the refinement.
    steps: u32,
    // Bytes that the reads fetched, caches aside.
    bytes: u32,
    // The part of the first light that arrives, from 0 to 1, whichever way the surface faces; 0 without
    // lights.
    lit: f32,
    // The level of detail that was traced.
    level: u32,
    // The hit's value in a depth buffer of the frame's clip space, from 0 to 1.
    z: f32,
    // The surface's number in the scene.
    surface: u32,
    // The part of the hit's light that comes through the translucent surfaces before it.
    transmittance: f32,
}"#,
    },
    Declaration {
        module: "shared/under",
        name: "rounded_gap",
        sampling: None,
        uses: &["Path", "ROUNDING", "cell_of", "height_cell", "height_size"],
        text: r#"// The depth below the surface, in heights, at which rounding may put a path that is on it. `slack`
// is the movement by rounding, in metres, `texels` the movement by other causes.
fn rounded_gap(path: Path, slack: f32, texels: f32) -> f32 {
    let size = height_size(path.level);
    let h = height_cell(vec2i(cell_of(path.uv * size - vec2f(0.5, 0.5))), path.level);
    let range = max(max(h.x, h.y), max(h.z, h.w)) - min(min(h.x, h.y), min(h.z, h.w));
    let change = abs(path.duv) * size;
    let places = abs(path.uv) * size * ROUNDING;
    let aside = (change.x + change.y) * slack + places.x + places.y + texels;
    return abs(path.h.y) * slack + range * aside + ROUNDING;
}"#,
    },
    Declaration {
        module: "shared/under",
        name: "out_of_ground",
        sampling: None,
        uses: &["NEVER", "Path", "cell_gap", "cell_leave", "cell_next", "cell_of", "field_is_ground_stage", "first_root", "grid_of", "quadratic", "rounded_gap"],
        text: r#"// The parameter at which a path that begins under the surface is above it by more than rounding: 0
// if it does not begin so, its exit if it never comes out. A path that rounding and `texels`
// explain counts as under the surface only on its way out, and only if it does not go deeper first.
// Otherwise the way there may have met the surface. In a volume it is cut open: what is solid there is hit.
fn out_of_ground(path: Path, slack: f32, texels: f32) -> f32 {
    if (!field_is_ground_stage(path.level)) {
        return 0.0;
    }
    let grid = grid_of(path);
    let least = rounded_gap(path, slack, texels);
    var cell = cell_of(grid.origin);
    var t = 0.0;
    let begin = cell_gap(path, grid, cell, 0.0);
    let is_near = begin.x >= 0.0 - least;
    let comes_out = begin.x <= 0.0 && begin.y > 0.0;
    if (is_near && !comes_out) {
        return 0.0;
    }
    let above = rounded_gap(path, slack, 0.0);
    while (t < path.exit) {
        let leave = cell_leave(grid, cell);
        let end = min(min(leave.x, leave.y), path.exit);
        let below = vec3f(above, 0.0, 0.0) - cell_gap(path, grid, cell, t);
        if (!(below.x > 0.0)) {
            return t;
        }
        let span = max(end - t, 0.0);
        let s = first_root(below, span);
        if (s < NEVER) {
            return t + s;
        }
        if (is_near && quadratic(below, span) > above + least) {
            return 0.0;
        }
        cell = cell_next(grid, cell, leave);
        t = max(t, end);
    }
    return path.exit;
}"#,
    },
    Declaration {
        module: "shared/under",
        name: "path_from",
        sampling: None,
        uses: &["Path", "path_uv"],
        text: r#"// The rest of a path from a parameter on.
fn path_from(path: Path, t: f32) -> Path {
    var rest = path;
    rest.uv = path_uv(path, t);
    rest.h = vec3f(path.h.x + t * (path.h.y + t * path.h.z), path.h.y + 2.0 * t * path.h.z, path.h.z);
    rest.exit = path.exit - t;
    rest.start = path.start + t;
    return rest;
}"#,
    },
    Declaration {
        module: "shared/views",
        name: "ViewsAround",
        sampling: None,
        uses: &[],
        text: r#"// The views around a path. Two elevations are beside each other for each of two azimuths and two bends.
struct ViewsAround {
    // 2 pairs of elevations for straight paths, or 4: azimuths run faster than bends.
    pairs: u32,
    before: f32,
    azimuths: f32,
    below: f32,
    elevations: f32,
    lower: f32,
    // The parts of the way to the next azimuth, elevation and bend.
    part: vec3f,
}"#,
    },
    Declaration {
        module: "shared/views",
        name: "ViewPair",
        sampling: None,
        uses: &[],
        text: r#"// A pair of elevations: the layer of the lower one, and its bend.
struct ViewPair {
    layer: i32,
    bend: f32,
}"#,
    },
    Declaration {
        module: "shared/views",
        name: "views_around",
        sampling: None,
        uses: &["PathAxes", "ViewsAround"],
        text: r#"// The views around, of a map whose azimuths, elevations and bends `params` has.
fn views_around(axes: PathAxes, params: vec4f) -> ViewsAround {
    let elevation = clamp(axes.elevation * params.y - 0.5, 0.0, params.y - 1.0);
    let below = min(floor(elevation), params.y - 2.0);
    let bend = clamp(axes.bend * params.z - 0.5, 0.0, params.z - 1.0);
    let lower = min(floor(bend), max(params.z - 2.0, 0.0));
    // The first step's middle is half a step from 0.
    let turn = axes.turn * params.x - 0.5;
    let before = floor(turn);
    return ViewsAround(
        select(4u, 2u, params.z == 1.0),
        before,
        params.x,
        below,
        params.y,
        lower,
        vec3f(turn - before, elevation - below, bend - lower),
    );
}"#,
    },
    Declaration {
        module: "shared/views",
        name: "view_pair",
        sampling: None,
        uses: &["ViewPair", "ViewsAround"],
        text: r#"// The pair with that number.
fn view_pair(views: ViewsAround, k: u32) -> ViewPair {
    let is_next = (k & 1u) == 1u;
    var azimuth = views.before + select(0.0, 1.0, is_next);
    azimuth = select(azimuth, azimuth + views.azimuths, azimuth < 0.0);
    azimuth = select(azimuth, azimuth - views.azimuths, azimuth >= views.azimuths);
    let layer = i32(azimuth * views.elevations + views.below);
    return ViewPair(layer, views.lower + select(0.0, 1.0, k > 1u));
}"#,
    },
    Declaration {
        module: "shared/views",
        name: "JoinedViews",
        sampling: None,
        uses: &[],
        text: r#"// What the pairs so far make: a way and its weight.
struct JoinedViews {
    first: vec2f,
    low: vec2f,
    high: vec2f,
}"#,
    },
    Declaration {
        module: "shared/views",
        name: "no_views",
        sampling: None,
        uses: &["JoinedViews"],
        text: r#"fn no_views() -> JoinedViews {
    return JoinedViews(vec2f(0.0, 0.0), vec2f(0.0, 0.0), vec2f(0.0, 0.0));
}"#,
    },
    Declaration {
        module: "shared/views",
        name: "with_pair",
        sampling: None,
        uses: &["JoinedViews", "ViewsAround"],
        text: r#"// With pair `k`: way and weight at its lower elevation, and at its upper one.
fn with_pair(joined: JoinedViews, views: ViewsAround, k: u32, ways: vec4f) -> JoinedViews {
    let of_below = vec2f(ways.x, ways.y);
    let of_azimuth = of_below + (vec2f(ways.z, ways.w) - of_below) * views.part.y;
    let of_bend = joined.first + (of_azimuth - joined.first) * views.part.x;
    if (k == 1u) {
        return JoinedViews(of_azimuth, of_bend, of_bend);
    }
    return JoinedViews(of_azimuth, joined.low, of_bend);
}"#,
    },
    Declaration {
        module: "shared/views",
        name: "joined_way",
        sampling: None,
        uses: &["JoinedViews", "ViewsAround"],
        text: r#"// The way, and the weight of the views and texels that hit something, out of all pairs.
fn joined_way(joined: JoinedViews, views: ViewsAround) -> vec2f {
    return joined.low + (joined.high - joined.low) * views.part.z;
}"#,
    },
    Declaration {
        module: "shared/views",
        name: "hit_on_way",
        sampling: None,
        uses: &["FOUND_ABOVE", "FOUND_MISS", "Path", "PathAxes", "SearchResult"],
        text: r#"// The hit on a path at a joined way and its weight. A way that ends nowhere is no number to be joined with
// others: the greater part of the weights decides whether there is a hit.
fn hit_on_way(path: Path, axes: PathAxes, way: vec2f, cost: vec3u) -> SearchResult {
    let t = axes.start + way.x / way.y * axes.whole;
    if (way.y < 0.5 || t < 0.0 || t > path.exit) {
        return SearchResult(FOUND_MISS, path.exit, path.exit, 1.0, 1.0, cost);
    }
    return SearchResult(FOUND_ABOVE, t, path.exit, 0.0, 1.0, cost);
}"#,
    },
    Declaration {
        module: "shared/volume",
        name: "SURFACE_VALUE",
        sampling: None,
        uses: &[],
        text: r#"// The value at the surface. Greater values are solid.
const SURFACE_VALUE = 0.5;"#,
    },
    Declaration {
        module: "shared/volume",
        name: "SLOPE_VOXELS",
        sampling: None,
        uses: &[],
        text: r#"// Voxels between the places whose values give a slope. Smaller, and every cell has a facet of its own;
// larger, and threads lose their roundness.
const SLOPE_VOXELS = 0.5;"#,
    },
    Declaration {
        module: "shared/volume",
        name: "CUT_OPEN",
        sampling: None,
        uses: &[],
        text: r#"// A hit at which the field is this much above the surface's value is inside of something solid. Smaller, and
// rounding takes hits for cuts; larger, and edges of cuts have normals of the inside.
const CUT_OPEN = 0.01;"#,
    },
    Declaration {
        module: "shared/volume",
        name: "OUTSIDE_VOXELS",
        sampling: None,
        uses: &[],
        text: r#"// Voxels by which a ray to a light begins outside of the surface that it leaves. Smaller, and rounding throws
// shadows; larger, and light comes through what is thin.
const OUTSIDE_VOXELS = 0.125;"#,
    },
    Declaration {
        module: "shared/volume",
        name: "VoxelCell",
        sampling: None,
        uses: &[],
        text: r#"// The values at the corners of a dual cell, in the order of `height_cell`: in the
// lower and in the upper slice.
struct VoxelCell {
    low: vec4f,
    high: vec4f,
}"#,
    },
    Declaration {
        module: "shared/volume",
        name: "voxel_cell",
        sampling: None,
        uses: &["VoxelCell", "slice_cell"],
        text: r#"// A dual cell of voxels. One read.
fn voxel_cell(cell: vec3i) -> VoxelCell {
    return VoxelCell(slice_cell(cell.xy, cell.z), slice_cell(cell.xy, cell.z + 1));
}"#,
    },
    Declaration {
        module: "shared/volume",
        name: "voxel_place",
        sampling: None,
        uses: &["volume_size"],
        text: r#"// Where the voxels' centres are whole numbers: from texture coordinates and a height.
fn voxel_place(at: vec3f) -> vec3f {
    return at * volume_size() - vec3f(0.5, 0.5, 0.5);
}"#,
    },
    Declaration {
        module: "shared/volume",
        name: "in_slice",
        sampling: None,
        uses: &[],
        text: r#"// The bilinear mean of four corners.
fn in_slice(corners: vec4f, part: vec2f) -> f32 {
    let top = corners.x + (corners.y - corners.x) * part.x;
    let bottom = corners.z + (corners.w - corners.z) * part.x;
    return top + (bottom - top) * part.y;
}"#,
    },
    Declaration {
        module: "shared/volume",
        name: "field_at_voxel",
        sampling: None,
        uses: &["in_slice", "voxel_cell"],
        text: r#"// The field at a place in voxels. One read.
fn field_at_voxel(place: vec3f) -> f32 {
    let first = floor(place);
    let part = place - first;
    let cell = voxel_cell(vec3i(first));
    let low = in_slice(cell.low, part.xy);
    return low + (in_slice(cell.high, part.xy) - low) * part.z;
}"#,
    },
    Declaration {
        module: "shared/volume",
        name: "field_at",
        sampling: None,
        uses: &["field_at_voxel", "voxel_place"],
        text: r#"// The field at texture coordinates and a height. One read.
fn field_at(at: vec3f) -> f32 {
    return field_at_voxel(voxel_place(at));
}"#,
    },
    Declaration {
        module: "shared/volume",
        name: "field_slopes",
        sampling: None,
        uses: &["SLOPE_VOXELS", "field_at_voxel"],
        text: r#"// The changes of the field per voxel at a place in voxels, by central differences.
fn field_slopes(place: vec3f) -> vec3f {
    let i = vec3f(SLOPE_VOXELS, 0.0, 0.0);
    let j = vec3f(0.0, SLOPE_VOXELS, 0.0);
    let k = vec3f(0.0, 0.0, SLOPE_VOXELS);
    let along_i = field_at_voxel(place + i) - field_at_voxel(place - i);
    let along_j = field_at_voxel(place + j) - field_at_voxel(place - j);
    let along_k = field_at_voxel(place + k) - field_at_voxel(place - k);
    return vec3f(along_i, along_j, along_k) / (2.0 * SLOPE_VOXELS);
}"#,
    },
    Declaration {
        module: "shared/volume",
        name: "normal_of_field",
        sampling: None,
        uses: &["CUT_OPEN", "Entered", "Hit", "NEVER", "SURFACE_VALUE", "covector", "field_at_voxel", "field_slopes", "volume_size", "voxel_place"],
        text: r#"// The unit normal of the surface at a hit, in the world: the way on which the field falls fastest. Where
// something solid is cut open by the volume's end, the base's normal.
fn normal_of_field(at: Entered, hit: Hit) -> vec3f {
    let place = voxel_place(vec3f(hit.uv, hit.height));
    if (field_at_voxel(place) > SURFACE_VALUE + CUT_OPEN) {
        return at.normal;
    }
    let rising = covector(at, field_slopes(place) * volume_size());
    let steepness = length(rising);
    if (steepness > 0.0 && steepness < NEVER) {
        return rising * (-1.0 / steepness);
    }
    return at.normal;
}"#,
    },
    Declaration {
        module: "shared/volume",
        name: "light_ray_out_of_volume",
        sampling: None,
        uses: &["Entered", "Hit", "LightRay", "OUTSIDE_VOXELS", "Toward", "climb", "field_slopes", "light_ray_from", "near_uv", "volume_size", "voxel_place"],
        text: r#"// The ray from a hit to a light, which begins a little outside of the surface. A light below the base plane
// lights nothing.
fn light_ray_out_of_volume(at: Entered, hit: Hit, light: Toward) -> LightRay {
    let change = climb(at, light.direction);
    let place = voxel_place(vec3f(near_uv(hit.uv), hit.height));
    let slopes = field_slopes(place);
    let steepness = length(slopes);
    var outside = place;
    if (steepness > 0.0) {
        outside = place - slopes * (OUTSIDE_VOXELS / steepness);
    }
    return light_ray_from(at, (outside + vec3f(0.5, 0.5, 0.5)) / volume_size(), change, light);
}"#,
    },
    Declaration {
        module: "shared/voxel_cells",
        name: "CellPart",
        sampling: None,
        uses: &[],
        text: r#"// A part of a path: in one cell, or in a box of empty ones around it.
struct CellPart {
    cell: vec3f,
    // The parameters between which the path is there.
    begin: f32,
    end: f32,
    // The parameters at which it leaves the cells, along u, v and the height.
    leave: vec3f,
    // Cells around this one that are empty, as is the cell; below 0 where it may not be.
    empty: f32,
    // 1 behind the place where the height stops rising or falling.
    past_turn: u32,
    // 1 where the path ends with this part, before it leaves the cells.
    is_last: u32,
}"#,
    },
    Declaration {
        module: "shared/voxel_cells",
        name: "part_from",
        sampling: None,
        uses: &["CellPart", "Path", "VoxelPath", "search_texel", "voxel_leave", "voxel_texel"],
        text: r#"// The part that begins in a cell at a parameter. `turn` is where the path's height turns.
fn part_from(path: Path, way: VoxelPath, turn: f32, cell: vec3f, begin: f32, past_turn: u32) -> CellPart {
    let empty = search_texel(path, voxel_texel(vec3i(cell)), 0, 0).x - 1.0;
    let leave = voxel_leave(way, cell, max(empty, 0.0), past_turn == 1u);
    let side = min(min(leave.x, leave.y), leave.z);
    let last = select(min(turn, path.exit), path.exit, past_turn == 1u);
    let end = max(min(side, last), begin);
    return CellPart(cell, begin, end, leave, empty, past_turn, select(0u, 1u, end >= path.exit));
}"#,
    },
    Declaration {
        module: "shared/voxel_cells",
        name: "first_part",
        sampling: None,
        uses: &["CellPart", "Path", "VoxelPath", "part_from", "voxel_place_on"],
        text: r#"// The first part of a path.
fn first_part(path: Path, way: VoxelPath, turn: f32) -> CellPart {
    return part_from(path, way, turn, floor(voxel_place_on(way, 0.0)), 0.0, 0u);
}"#,
    },
    Declaration {
        module: "shared/voxel_cells",
        name: "next_part",
        sampling: None,
        uses: &["CellPart", "Path", "VoxelPath", "next_voxel_cell", "part_from", "rises_on", "voxel_cell_at"],
        text: r#"// The part behind one that is not the last.
fn next_part(path: Path, way: VoxelPath, turn: f32, before: CellPart) -> CellPart {
    let reach = max(before.empty, 0.0);
    let has_turned = before.past_turn == 1u;
    let leave = before.leave;
    let end = before.end;
    let side = min(min(leave.x, leave.y), leave.z);
    if (!has_turned && side > min(turn, path.exit)) {
        return part_from(path, way, turn, voxel_cell_at(way, before.cell, reach, end), end, 1u);
    }
    let next = next_voxel_cell(way, before.cell, reach, leave, rises_on(way, has_turned), end);
    return part_from(path, way, turn, next, end, before.past_turn);
}"#,
    },
    Declaration {
        module: "shared/voxel_walk",
        name: "VoxelPath",
        sampling: None,
        uses: &[],
        text: r#"// A path in voxels: its place at t = 0, its change, and the bend of its height.
struct VoxelPath {
    origin: vec3f,
    step: vec3f,
    bend: f32,
}"#,
    },
    Declaration {
        module: "shared/voxel_walk",
        name: "voxel_path",
        sampling: None,
        uses: &["Path", "VoxelPath", "volume_size"],
        text: r#"fn voxel_path(path: Path) -> VoxelPath {
    let size = volume_size();
    return VoxelPath(
        vec3f(path.uv, path.h.x) * size - vec3f(0.5, 0.5, 0.5),
        vec3f(path.duv, path.h.y) * size,
        path.h.z * size.z,
    );
}"#,
    },
    Declaration {
        module: "shared/voxel_walk",
        name: "voxel_place_on",
        sampling: None,
        uses: &["VoxelPath"],
        text: r#"fn voxel_place_on(way: VoxelPath, t: f32) -> vec3f {
    return way.origin + (way.step + vec3f(0.0, 0.0, way.bend * t)) * t;
}"#,
    },
    Declaration {
        module: "shared/voxel_walk",
        name: "RootInCell",
        sampling: None,
        uses: &[],
        text: r#"// The first root in a cell, and the gap where the path enters it.
struct RootInCell {
    root: f32,
    gap: f32,
}"#,
    },
    Declaration {
        module: "shared/voxel_walk",
        name: "turning_point",
        sampling: None,
        uses: &["NEVER", "VoxelPath"],
        text: r#"// The parameter at which the height stops rising or falling; NEVER on a straight path.
fn turning_point(way: VoxelPath) -> f32 {
    if (way.bend == 0.0) {
        return NEVER;
    }
    let t = (0.0 - way.step.z) / (2.0 * way.bend);
    return select(NEVER, t, t > 0.0);
}"#,
    },
    Declaration {
        module: "shared/voxel_walk",
        name: "meets_plane",
        sampling: None,
        uses: &["NEVER", "VoxelPath"],
        text: r#"// The parameter at which the height reaches a plane between cells, on the way before the turning point or on
// the way behind it; NEVER if it stays on one side.
fn meets_plane(way: VoxelPath, plane: f32, rises: bool, has_turned: bool) -> f32 {
    let gap = plane - way.origin.z;
    let discriminant = way.step.z * way.step.z + 4.0 * way.bend * gap;
    if (!(discriminant >= 0.0)) {
        return NEVER;
    }
    let root = select(0.0 - sqrt(discriminant), sqrt(discriminant), rises);
    // The slope at the plane is that root. Both forms add numbers of one sign.
    if (has_turned) {
        return (root - way.step.z) / (2.0 * way.bend);
    }
    let both = way.step.z + root;
    return select(NEVER, 2.0 * gap / both, both != 0.0);
}"#,
    },
    Declaration {
        module: "shared/voxel_walk",
        name: "voxel_leave",
        sampling: None,
        uses: &["NEVER", "VoxelPath", "meets_plane", "rises_on"],
        text: r#"// The parameters where a path leaves the box of the cells up to `reach` cells from a cell, along u, v and the
// height.
fn voxel_leave(way: VoxelPath, cell: vec3f, reach: f32, has_turned: bool) -> vec3f {
    let none = vec2f(0.0, 0.0);
    let last = vec2f(1.0 + reach, 1.0 + reach);
    let ahead = cell.xy + select(vec2f(0.0 - reach, 0.0 - reach), last, way.step.xy > none);
    let beside = (ahead - way.origin.xy) / way.step.xy;
    let across = select(vec2f(NEVER, NEVER), beside, abs(way.step.xy) > none);
    let rises = rises_on(way, has_turned);
    let plane = cell.z + select(0.0 - reach, 1.0 + reach, rises);
    return vec3f(across, meets_plane(way, plane, rises, has_turned));
}"#,
    },
    Declaration {
        module: "shared/voxel_walk",
        name: "rises_on",
        sampling: None,
        uses: &["VoxelPath"],
        text: r#"// Whether the height rises before or behind the turning point.
fn rises_on(way: VoxelPath, has_turned: bool) -> bool {
    if (has_turned) {
        return way.bend > 0.0;
    }
    return way.step.z > 0.0 || (way.step.z == 0.0 && way.bend > 0.0);
}"#,
    },
    Declaration {
        module: "shared/voxel_walk",
        name: "greatest_value",
        sampling: None,
        uses: &["VoxelCell"],
        text: r#"// The greatest value at the corners of a cell.
fn greatest_value(cell: VoxelCell) -> f32 {
    let most = max(cell.low, cell.high);
    return max(max(most.x, most.y), max(most.z, most.w));
}"#,
    },
    Declaration {
        module: "shared/voxel_walk",
        name: "gap_in_cell",
        sampling: None,
        uses: &["Quartic", "SURFACE_VALUE", "VoxelCell", "VoxelPath", "along_slice", "voxel_place_on"],
        text: r#"// The gap in a cell along a path from t on, as a polynomial that is at 1 after `span`.
fn gap_in_cell(way: VoxelPath, cell: vec3f, corners: VoxelCell, t: f32, span: f32) -> Quartic {
    let at = voxel_place_on(way, t) - cell;
    let slope = (way.step.z + 2.0 * way.bend * t) * span;
    let bend = way.bend * (span * span);
    let dx = way.step.x * span;
    let dy = way.step.y * span;
    let low = along_slice(corners.low, at.xy, dx, dy);
    let rise = along_slice(corners.high, at.xy, dx, dy) - low;
    return Quartic(
        SURFACE_VALUE - (low.x + rise.x * at.z),
        0.0 - (low.y + rise.y * at.z + rise.x * slope),
        0.0 - (low.z + rise.z * at.z + rise.y * slope + rise.x * bend),
        0.0 - (rise.z * slope + rise.y * bend),
        0.0 - rise.z * bend,
    );
}"#,
    },
    Declaration {
        module: "shared/voxel_walk",
        name: "along_slice",
        sampling: None,
        uses: &[],
        text: r#"// The bilinear mean of four corners along a straight way: a polynomial of degree 2.
fn along_slice(h: vec4f, at: vec2f, dx: f32, dy: f32) -> vec3f {
    let bx = h.y - h.x;
    let by = h.z - h.x;
    let twist = (h.x - h.y) + (h.w - h.z);
    return vec3f(
        h.x + bx * at.x + by * at.y + twist * at.x * at.y,
        bx * dx + by * dy + twist * (at.x * dy + at.y * dx),
        twist * dx * dy,
    );
}"#,
    },
    Declaration {
        module: "shared/voxel_walk",
        name: "voxel_cell_at",
        sampling: None,
        uses: &["VoxelPath", "voxel_place_on"],
        text: r#"// The cell at a parameter inside of such a box, which rounding does not take out of it.
fn voxel_cell_at(way: VoxelPath, cell: vec3f, reach: f32, t: f32) -> vec3f {
    let far = vec3f(reach, reach, reach);
    return clamp(floor(voxel_place_on(way, t)), cell - far, cell + far);
}"#,
    },
    Declaration {
        module: "shared/voxel_walk",
        name: "next_voxel_cell",
        sampling: None,
        uses: &["VoxelPath", "voxel_cell_at"],
        text: r#"// The next cell, behind the side through which the path leaves such a box first, at t.
fn next_voxel_cell(way: VoxelPath, cell: vec3f, reach: f32, leave: vec3f, rises: bool, t: f32) -> vec3f {
    var next = voxel_cell_at(way, cell, reach, t);
    let far = reach + 1.0;
    if (leave.x <= leave.y && leave.x <= leave.z) {
        next.x = cell.x + select(0.0 - far, far, way.step.x > 0.0);
    } else if (leave.y <= leave.z) {
        next.y = cell.y + select(0.0 - far, far, way.step.y > 0.0);
    } else {
        next.z = cell.z + select(0.0 - far, far, rises);
    }
    return next;
}"#,
    },
    Declaration {
        module: "shared/voxel_walk",
        name: "root_in_voxel_cell",
        sampling: None,
        uses: &["NEVER", "RootInCell", "SURFACE_VALUE", "VoxelPath", "first_root_of_quartic", "gap_in_cell", "greatest_value", "voxel_cell"],
        text: r#"// The parameter of the first place in a cell where the field reaches the surface, as a part of the way from t
// to `span` behind it; NEVER without one.
fn root_in_voxel_cell(way: VoxelPath, cell: vec3f, t: f32, span: f32) -> RootInCell {
    let corners = voxel_cell(vec3i(cell));
    if (greatest_value(corners) < SURFACE_VALUE) {
        return RootInCell(NEVER, 1.0);
    }
    let gap = gap_in_cell(way, cell, corners, t, span);
    return RootInCell(first_root_of_quartic(gap), gap.a);
}"#,
    },
    Declaration {
        module: "surface/facets",
        name: "surface_facets_enter",
        sampling: None,
        uses: &["Entered", "PixelIn", "is_on_map", "plane_normal", "surface_settings", "triangle_distance", "triangle_weights"],
        text: r#"fn surface_facets_enter(pixel: PixelIn, params: vec4f) -> Entered {
    let n = plane_normal(pixel);
    let point = pixel.origin + pixel.direction * triangle_distance(pixel, n);
    let w = triangle_weights(pixel, n, point);
    let uv = pixel.a.uv * w.x + pixel.b.uv * w.y + pixel.c.uv * w.z;
    let tangent = pixel.a.tangent * w.x + pixel.b.tangent * w.y + pixel.c.tangent * w.z;
    let bitangent = pixel.a.bitangent * w.x + pixel.b.bitangent * w.y + pixel.c.bitangent * w.z;
    let sum = (pixel.a.normal * w.x + pixel.b.normal * w.y + pixel.c.normal * w.z) * pixel.side;
    let tt = dot(tangent, tangent);
    let tb = dot(tangent, bitangent);
    let bb = dot(bitangent, bitangent);
    return Entered(
        select(0u, 1u, dot(n, n) > 0.0 && is_on_map(uv)),
        point,
        uv,
        tangent,
        bitangent,
        normalize(sum),
        vec4f(tt, tb, bb, surface_settings.scale_m),
        0u,
        n,
        vec2f(0.0, 0.0),
        vec4f(0.0, 0.0, 0.0, 0.0),
        0.0,
        0.0,
        0.0,
    );
}"#,
    },
    Declaration {
        module: "surface/facets",
        name: "surface_facets_segment",
        sampling: None,
        uses: &["Entered", "Path", "PixelIn", "RAY_VIEW", "height_at", "plane_normal", "triangle_distance"],
        text: r#"// A segment that begins at the triangle; its length is not used.
fn surface_facets_segment(pixel: PixelIn, at: Entered, k: u32, params: vec4f) -> Path {
    let start = triangle_distance(pixel, plane_normal(pixel)) * length(pixel.direction);
    let height = height_at(at.uv, at.level);
    let duv = vec2f(0.0, 0.0);
    let h = vec3f(height, 0.0, 0.0);
    return Path(at.uv, duv, h, 1.0, 0.0, at.metric, RAY_VIEW, at.level, start, 1.0, 0.0);
}"#,
    },
    Declaration {
        module: "surface/facets",
        name: "surface_facets_polish",
        sampling: None,
        uses: &["Entered", "Hit", "Path", "PixelIn"],
        text: r#"fn surface_facets_polish(pixel: PixelIn, at: Entered, path: Path, hit: Hit, params: vec4f) -> Hit {
    return hit;
}"#,
    },
    Declaration {
        module: "surface/facets",
        name: "surface_facets_place",
        sampling: None,
        uses: &["Entered", "Hit", "Path", "PixelIn"],
        text: r#"fn surface_facets_place(pixel: PixelIn, at: Entered, path: Path, hit: Hit, params: vec4f) -> Entered {
    return at;
}"#,
    },
    Declaration {
        module: "surface/frames",
        name: "surface_frames_enter",
        sampling: None,
        uses: &["Entered", "FRAMES", "PixelIn", "passed_by"],
        text: r#"fn surface_frames_enter(pixel: PixelIn, params: vec4f) -> Entered {
    var at = passed_by();
    at.segments = FRAMES;
    at.point = pixel.origin;
    return at;
}"#,
    },
    Declaration {
        module: "surface/frames",
        name: "surface_frames_segment",
        sampling: None,
        uses: &["Entered", "Path", "PixelIn", "frame_number", "frames_around", "path_through_image"],
        text: r#"fn surface_frames_segment(pixel: PixelIn, at: Entered, k: u32, params: vec4f) -> Path {
    return path_through_image(pixel, frame_number(frames_around(-normalize(pixel.direction)), k));
}"#,
    },
    Declaration {
        module: "surface/frames",
        name: "surface_frames_polish",
        sampling: None,
        uses: &["Entered", "Hit", "Path", "PixelIn", "polished_on_image"],
        text: r#"fn surface_frames_polish(pixel: PixelIn, at: Entered, path: Path, hit: Hit, params: vec4f) -> Hit {
    return polished_on_image(path, hit);
}"#,
    },
    Declaration {
        module: "surface/frames",
        name: "surface_frames_place",
        sampling: None,
        uses: &["CELLS_MASK", "Entered", "Hit", "Path", "PixelIn", "frames_around", "normal_of_frames", "placed_in_image", "surface_settings"],
        text: r#"fn surface_frames_place(pixel: PixelIn, at: Entered, path: Path, hit: Hit, params: vec4f) -> Entered {
    var placed = placed_in_image(pixel, at, path, hit);
    // For a relief or a silhouette the path gives the normal.
    if (surface_settings.has_vertex_normals == 1u && surface_settings.cells != CELLS_MASK) {
        placed.normal = normal_of_frames(placed, frames_around(-normalize(pixel.direction)));
    }
    return placed;
}"#,
    },
    Declaration {
        module: "surface/object",
        name: "surface_object_enter",
        sampling: None,
        uses: &["Entered", "PixelIn", "passed_by", "surface_settings"],
        text: r#"fn surface_object_enter(pixel: PixelIn, params: vec4f) -> Entered {
    var at = passed_by();
    at.segments = surface_settings.solids;
    at.point = pixel.origin;
    return at;
}"#,
    },
    Declaration {
        module: "surface/object",
        name: "surface_object_segment",
        sampling: None,
        uses: &["Entered", "Path", "PixelIn", "path_through_image"],
        text: r#"fn surface_object_segment(pixel: PixelIn, at: Entered, k: u32, params: vec4f) -> Path {
    return path_through_image(pixel, k);
}"#,
    },
    Declaration {
        module: "surface/object",
        name: "surface_object_polish",
        sampling: None,
        uses: &["Entered", "Hit", "Path", "PixelIn", "polished_on_image"],
        text: r#"fn surface_object_polish(pixel: PixelIn, at: Entered, path: Path, hit: Hit, params: vec4f) -> Hit {
    return polished_on_image(path, hit);
}"#,
    },
    Declaration {
        module: "surface/object",
        name: "surface_object_place",
        sampling: None,
        uses: &["Entered", "Hit", "Path", "PixelIn", "placed_in_image"],
        text: r#"fn surface_object_place(pixel: PixelIn, at: Entered, path: Path, hit: Hit, params: vec4f) -> Entered {
    return placed_in_image(pixel, at, path, hit);
}"#,
    },
    Declaration {
        module: "surface/object_slices",
        name: "SLIVER",
        sampling: None,
        uses: &[],
        text: r#"// The length of a segment, as a part of its distance: the only hit on it is its end.
const SLIVER = 0.0000005;"#,
    },
    Declaration {
        module: "surface/object_slices",
        name: "HIGHEST",
        sampling: None,
        uses: &[],
        text: r#"// Higher than any map is over a slice.
const HIGHEST = 2.0;"#,
    },
    Declaration {
        module: "surface/object_slices",
        name: "surface_object_slices_enter",
        sampling: None,
        uses: &["Entered", "PixelIn", "passed_by", "plane_normal", "triangle_distance"],
        text: r#"fn surface_object_slices_enter(pixel: PixelIn, params: vec4f) -> Entered {
    let n = plane_normal(pixel);
    var at = passed_by();
    at.segments = select(0u, 1u, dot(n, n) > 0.0);
    at.point = pixel.origin + pixel.direction * triangle_distance(pixel, n);
    at.normal = normalize(n) * select(1.0, -1.0, dot(n, pixel.direction) > 0.0);
    return at;
}"#,
    },
    Declaration {
        module: "surface/object_slices",
        name: "is_in_image",
        sampling: None,
        uses: &["OnImage", "slices_stage"],
        text: r#"// Whether a point is in the solid of an image that sees it there.
fn is_in_image(at: OnImage) -> bool {
    return at.is_inside && slices_stage(at.map, at.height, 0.0);
}"#,
    },
    Declaration {
        module: "surface/object_slices",
        name: "passes_image",
        sampling: None,
        uses: &["image_of_object", "is_in_image", "on_image"],
        text: r#"// Whether a point is in the solid of one image.
fn passes_image(number: u32, point: vec3f) -> bool {
    return is_in_image(on_image(image_of_object(number), point));
}"#,
    },
    Declaration {
        module: "surface/object_slices",
        name: "OnSlice",
        sampling: None,
        uses: &["OnImage"],
        text: r#"// A point of a slice in the image whose surface is nearest to it.
struct OnSlice {
    // Whether it is in the solids of all images.
    passes: bool,
    number: u32,
    nearest: OnImage,
    // Height of that surface above the point.
    over: f32,
}"#,
    },
    Declaration {
        module: "surface/object_slices",
        name: "with_image",
        sampling: None,
        uses: &["OnSlice", "image_of_object", "is_in_image", "on_image"],
        text: r#"// The point with one more image taken into account.
fn with_image(slice: OnSlice, number: u32, point: vec3f) -> OnSlice {
    let at = on_image(image_of_object(number), point);
    let over = at.map - at.height;
    let passes = is_in_image(at);
    if (over < slice.over) {
        return OnSlice(passes, number, at, over);
    }
    return OnSlice(passes, slice.number, slice.nearest, slice.over);
}"#,
    },
    Declaration {
        module: "surface/object_slices",
        name: "slice_at",
        sampling: None,
        uses: &["HIGHEST", "OnImage", "OnSlice", "surface_settings", "with_image"],
        text: r#"// The point with all images taken into account, or those up to the first that sees nothing as high.
fn slice_at(point: vec3f) -> OnSlice {
    var slice = OnSlice(true, 0u, OnImage(vec2f(0.0, 0.0), 0.0, 0.0, false), HIGHEST);
    var number = 0u;
    while (number < surface_settings.solids && slice.passes) {
        slice = with_image(slice, number, point);
        number = number + 1u;
    }
    return slice;
}"#,
    },
    Declaration {
        module: "surface/object_slices",
        name: "surface_object_slices_segment",
        sampling: None,
        uses: &["Entered", "Path", "PixelIn", "RAY_VIEW", "SLIVER", "depth_in_image", "image_of_object", "metric_of_image", "slice_at"],
        text: r#"fn surface_object_slices_segment(pixel: PixelIn, at: Entered, k: u32, params: vec4f) -> Path {
    let slice = slice_at(at.point);
    let image = image_of_object(slice.number);
    let far = length(at.point - pixel.origin);
    let lead = far * SLIVER;
    return Path(
        slice.nearest.uv,
        vec2f(0.0, 0.0),
        vec3f(slice.nearest.height, 0.0, 0.0),
        select(0.0, lead, slice.passes),
        lead,
        metric_of_image(image, depth_in_image(image, at.point)),
        RAY_VIEW,
        0u,
        far - lead,
        1.0,
        0.0,
    );
}"#,
    },
    Declaration {
        module: "surface/object_slices",
        name: "surface_object_slices_polish",
        sampling: None,
        uses: &["Entered", "Hit", "Path", "PixelIn", "surface_settings"],
        text: r#"// Where a slice is drawn, all images have been read.
fn surface_object_slices_polish(pixel: PixelIn, at: Entered, path: Path, hit: Hit, params: vec4f) -> Hit {
    var counted = hit;
    counted.cost = hit.cost + vec3u(surface_settings.solids, 0u, 16u * surface_settings.solids);
    return counted;
}"#,
    },
    Declaration {
        module: "surface/object_slices",
        name: "surface_object_slices_place",
        sampling: None,
        uses: &["CELLS_MASK", "Entered", "Hit", "Path", "PixelIn", "image_of_object", "normal_of_mask", "placed_in_image", "slice_at", "surface_settings"],
        text: r#"fn surface_object_slices_place(pixel: PixelIn, at: Entered, path: Path, hit: Hit, params: vec4f) -> Entered {
    let number = slice_at(at.point).number;
    var of_image = path;
    of_image.base = f32(number);
    var placed = placed_in_image(pixel, at, of_image, hit);
    if (surface_settings.cells == CELLS_MASK) {
        // A slice within all silhouettes is a section of the hull.
        placed.normal = normal_of_mask(image_of_object(number), hit.uv, at.normal);
        placed.facing = placed.normal;
    }
    return placed;
}"#,
    },
    Declaration {
        module: "surface/plane",
        name: "LEAST_DESCENT",
        sampling: None,
        uses: &[],
        text: r#"// The least descent of a ray to a triangle without a relief. Smaller, and the way through its depth of
// nothing grows.
const LEAST_DESCENT = 0.001;"#,
    },
    Declaration {
        module: "surface/plane",
        name: "surface_plane_enter",
        sampling: None,
        uses: &["Entered", "PixelIn", "plane_distance", "plane_normal", "plane_weights", "surface_settings"],
        text: r#"fn surface_plane_enter(pixel: PixelIn, params: vec4f) -> Entered {
    let n = plane_normal(pixel);
    let point = pixel.origin + pixel.direction * plane_distance(pixel, n);
    let w = plane_weights(pixel, n, point);
    let wa = w.x;
    let wb = w.y;
    let wc = w.z;

    let uv = pixel.a.uv * wa + pixel.b.uv * wb + pixel.c.uv * wc;
    let tangent = pixel.a.tangent * wa + pixel.b.tangent * wb + pixel.c.tangent * wc;
    let bitangent = pixel.a.bitangent * wa + pixel.b.bitangent * wb + pixel.c.bitangent * wc;
    let normal = normalize(pixel.a.normal * wa + pixel.b.normal * wb + pixel.c.normal * wc) * pixel.side;
    let tt = dot(tangent, tangent);
    let tb = dot(tangent, bitangent);
    let bb = dot(bitangent, bitangent);
    let area = tt * bb - tb * tb;
    let metric = vec4f(tt, tb, bb, surface_settings.scale_m);
    // By the unit direction, as for the segment: a longer one may descend where the unit one does
    // not.
    let descent = 0.0 - dot(normal, pixel.direction / length(pixel.direction));
    // A triangle without a relief is seen wherever it faces the eye, also where its normal does not.
    let is_entered = descent > 0.0 || surface_settings.scale_m == 0.0;
    let segments = select(0u, 1u, area > 0.0 && is_entered);
    return Entered(
        segments,
        point,
        uv,
        tangent,
        bitangent,
        normal,
        metric,
        0u,
        n,
        vec2f(0.0, 0.0),
        vec4f(0.0, 0.0, 0.0, 0.0),
        0.0,
        0.0,
        0.0,
    );
}"#,
    },
    Declaration {
        module: "surface/plane",
        name: "surface_plane_segment",
        sampling: None,
        uses: &["Entered", "Path", "PixelIn", "plane_distance", "plane_normal", "surface_plane_way"],
        text: r#"fn surface_plane_segment(pixel: PixelIn, at: Entered, k: u32, params: vec4f) -> Path {
    let along = length(pixel.direction);
    // Metres along the ray, to the base.
    let distance = plane_distance(pixel, plane_normal(pixel)) * along;
    return surface_plane_way(at, pixel.direction / along, distance, 0.0 - distance, k, params);
}"#,
    },
    Declaration {
        module: "surface/plane",
        name: "surface_plane_crossed",
        sampling: None,
        uses: &["Entered"],
        text: r#"fn surface_plane_crossed(at: Entered, direction: vec3f, eye: f32, params: vec4f) -> Entered {
    return at;
}"#,
    },
    Declaration {
        module: "surface/plane",
        name: "surface_plane_way",
        sampling: None,
        uses: &["BELOW_FLOOR", "Entered", "LEAST_DESCENT", "NEVER", "Path", "RAY_VIEW", "WRAP_CLAMP", "base_height", "climb", "inside_unit", "surface_settings", "traced_scale_m"],
        text: r#"// Equation 7 with the ray's unit direction: texture coordinates and height per metre. A ray that does not
// come down has no way.
fn surface_plane_way(
    at: Entered,
    direction: vec3f,
    distance: f32,
    eye: f32,
    k: u32,
    params: vec4f,
) -> Path {
    let duv = climb(at, direction).xy;
    let is_flat = surface_settings.scale_m == 0.0;
    let descent = max(0.0 - dot(at.normal, direction), select(0.0 - NEVER, LEAST_DESCENT, is_flat));
    let scale = traced_scale_m();
    let base_height = base_height();
    let slope = (0.0 - descent) / scale;

    // Metres along the ray, counted from the base: entry at height 1 but not behind the eye, exit at
    // height 0.
    let top = (base_height - 1.0) * scale / descent;
    var enter = max(top, eye);
    var leave = base_height * scale / descent;
    leave = leave + (leave - top) * (BELOW_FLOOR - 1.0);
    if (surface_settings.wrap == WRAP_CLAMP) {
        var interval = inside_unit(at.uv.x, duv.x, vec2f(enter, leave));
        interval = inside_unit(at.uv.y, duv.y, interval);
        enter = interval.x;
        leave = interval.y;
    }
    let entry_height = select(base_height + slope * enter, 1.0, enter == top);
    // Limits that are never reached. Where compilers may reorder arithmetic they would cancel `uv +
    // duv enter` against `duv base`. Methods that begin at the base would then differ from machine
    // to machine.
    let base = clamp(0.0 - enter, 0.0 - NEVER, NEVER);
    return Path(
        at.uv + duv * enter,
        duv,
        vec3f(entry_height, slope, 0.0),
        select(0.0, leave - enter, descent > 0.0),
        base,
        at.metric,
        RAY_VIEW,
        at.level,
        distance + enter,
        1.0,
        0.0,
    );
}"#,
    },
    Declaration {
        module: "surface/plane",
        name: "surface_plane_frame",
        sampling: None,
        uses: &["Entered"],
        text: r#"fn surface_plane_frame(at: Entered, aside: vec2f, params: vec4f) -> Entered {
    return at;
}"#,
    },
    Declaration {
        module: "surface/plane",
        name: "surface_plane_polish",
        sampling: None,
        uses: &["Entered", "Hit", "Path", "PixelIn"],
        text: r#"fn surface_plane_polish(pixel: PixelIn, at: Entered, path: Path, hit: Hit, params: vec4f) -> Hit {
    return hit;
}"#,
    },
    Declaration {
        module: "surface/plane",
        name: "surface_plane_place",
        sampling: None,
        uses: &["Entered", "Hit", "Path", "PixelIn", "placed_over"],
        text: r#"// On the surface, whatever the height of the path there, in the frame of the base point.
fn surface_plane_place(pixel: PixelIn, at: Entered, path: Path, hit: Hit, params: vec4f) -> Entered {
    return placed_over(at, hit);
}"#,
    },
    Declaration {
        module: "surface/prism",
        name: "POLISH_STEPS",
        sampling: None,
        uses: &[],
        text: r#"// Steps from a chord's hit to the way's hit.
const POLISH_STEPS = 3u;"#,
    },
    Declaration {
        module: "surface/prism",
        name: "MOST_BESIDE",
        sampling: None,
        uses: &[],
        text: r#"// The greatest distance of a point of the way from the ray, in roundings; farther points are
// dropped.
const MOST_BESIDE = 4.0;"#,
    },
    Declaration {
        module: "surface/prism",
        name: "MOST_CHORDS",
        sampling: None,
        uses: &[],
        text: r#"// The most chords of a ray in a shell.
const MOST_CHORDS = 32.0;"#,
    },
    Declaration {
        module: "surface/prism",
        name: "in_slab",
        sampling: None,
        uses: &["where_positive"],
        text: r#"// The part of an interval in which the ray is in the slab with that normal that holds all of a
// shell. For corners that are equally far along the normal one is given.
fn in_slab(
    interval: vec2f,
    normal: vec3f,
    a: vec3f,
    b: vec3f,
    c: vec3f,
    d: vec3f,
    along: vec3f,
    slack: f32,
) -> vec2f {
    let far = vec4f(dot(normal, a), dot(normal, b), dot(normal, c), dot(normal, d));
    let least = min(min(far.x, far.y), min(far.z, far.w));
    let most = max(max(far.x, far.y), max(far.z, far.w));
    let beyond = slack * length(normal);
    let change = dot(normal, along);
    let inside = where_positive(interval, 0.0 - least, change, beyond);
    return where_positive(inside, most, 0.0 - change, beyond);
}"#,
    },
    Declaration {
        module: "surface/prism",
        name: "span_of",
        sampling: None,
        uses: &["NEVER", "PixelIn", "Prism", "in_slab", "offsets_of", "shell_slack"],
        text: r#"// The extent of the ray in the shell, in metres from the place nearest to the triangle.
fn span_of(pixel: PixelIn, prism: Prism, along: vec3f, middle: f32, params: vec4f) -> vec2f {
    var shell = pixel.shell;
    shell.lift = shell.lift * params.y;
    let offsets = offsets_of(shell);
    let slack = shell_slack(pixel, middle);
    let low0 = prism.p0 + prism.n0 * offsets.x;
    let low1 = prism.p1 + prism.n1 * offsets.x;
    let low2 = prism.p2 + prism.n2 * offsets.x;
    let high0 = prism.p0 + prism.n0 * offsets.y;
    let high1 = prism.p1 + prism.n1 * offsets.y;
    let high2 = prism.p2 + prism.n2 * offsets.y;
    var span = vec2f(0.0 - middle, NEVER);
    // All corners of the lower side lie in a plane across the normal, and so do all of the upper
    // side. For the other sides the ends of each diagonal do.
    span = in_slab(span, cross(low1 - low0, low2 - low0), low0, high0, high1, high2, along, slack);
    span = in_slab(span, cross(high1 - high0, high2 - high0), high0, low0, low1, low2, along, slack);
    if (!(span.y > span.x)) {
        return span;
    }
    span = in_slab(span, cross(high1 - low0, low1 - high0), low0, low1, low2, high2, along, slack);
    span = in_slab(span, cross(high2 - low1, low2 - high1), low1, low2, low0, high0, along, slack);
    if (!(span.y > span.x)) {
        return span;
    }
    span = in_slab(span, cross(high0 - low2, low0 - high2), low2, low0, low1, high1, along, slack);
    return span;
}"#,
    },
    Declaration {
        module: "surface/prism",
        name: "beside_chord",
        sampling: None,
        uses: &["HEIGHTS_A_TEXEL", "NEVER", "PixelIn", "ShellPoint", "height_size", "uv_of"],
        text: r#"// The distance of a point of the way from the straight line, in units of the tolerance's texels.
// `part` is its place between the ends; heights are a quadratic through the middle there.
fn beside_chord(
    pixel: PixelIn,
    a: ShellPoint,
    m: ShellPoint,
    b: ShellPoint,
    at: ShellPoint,
    part: f32,
) -> f32 {
    // A limit that is never reached, as in `shell_point`.
    let line = a.weights + min(b.weights - a.weights, vec3f(NEVER, NEVER, NEVER)) * part;
    let apart = abs(uv_of(pixel, at.weights - line) * height_size(0u));
    let bend = 2.0 * (a.height + b.height - 2.0 * m.height);
    let slope = b.height - a.height - bend;
    let height = a.height + part * (slope + part * bend);
    return max(max(apart.x, apart.y), abs(at.height - height) / HEIGHTS_A_TEXEL);
}"#,
    },
    Declaration {
        module: "surface/prism",
        name: "surface_prism_enter",
        sampling: None,
        uses: &["Entered", "MOST_CHORDS", "NEVER", "PixelIn", "SHELL_FOLDED", "beside_chord", "between", "folded_enter", "middle_of", "passed_by", "prism_of", "shell_middle", "shell_point", "shell_point_from", "span_of"],
        text: r#"fn surface_prism_enter(pixel: PixelIn, params: vec4f) -> Entered {
    if (pixel.shell.order >= SHELL_FOLDED) {
        return folded_enter(pixel, params);
    }
    let along = normalize(pixel.direction);
    let middle = middle_of(pixel, along);
    let prism = prism_of(pixel, along, middle, params);
    let span = span_of(pixel, prism, along, middle, params);
    // A limit that is never reached, as in `shell_point`.
    let long = min(span.y - span.x, NEVER);
    if (!(long > 0.0) || !(long < NEVER)) {
        return passed_by();
    }
    var at = shell_middle(pixel, along);
    at.span = span;
    let height = 0.5 * (pixel.shell.heights.x + pixel.shell.heights.y);
    let a = shell_point(prism, along * at.span.x, height);
    let b = shell_point(prism, along * at.span.y, height);
    let m = shell_point_from(prism, along * (at.span.x + 0.5 * long), between(a, b));
    let before = shell_point_from(prism, along * (at.span.x + 0.25 * long), between(a, m));
    let after = shell_point_from(prism, along * (at.span.x + 0.75 * long), between(m, b));
    let quarters = max(beside_chord(pixel, a, m, b, before, 0.25), beside_chord(pixel, a, m, b, after, 0.75));
    let most = max(beside_chord(pixel, a, m, b, m, 0.5), quarters);
    // With half the chords the way is four times as far beside them.
    at.segments = u32(clamp(ceil(sqrt(most / params.x)), 1.0, MOST_CHORDS));
    return at;
}"#,
    },
    Declaration {
        module: "surface/prism",
        name: "chord_end",
        sampling: None,
        uses: &["Entered", "NEVER"],
        text: r#"// The end of a chord on the ray, in metres from the place nearest to the triangle.
fn chord_end(at: Entered, k: u32) -> f32 {
    // A limit that is never reached, as in `shell_point`.
    return at.span.x + min(at.span.y - at.span.x, NEVER) * (f32(k) / f32(at.segments));
}"#,
    },
    Declaration {
        module: "surface/prism",
        name: "surface_prism_segment",
        sampling: None,
        uses: &["Entered", "Path", "PixelIn", "SHELL_FOLDED", "between", "chord_end", "chord_path", "chord_reach", "folded_segment", "middle_of", "prism_of", "shell_point", "shell_point_from"],
        text: r#"fn surface_prism_segment(pixel: PixelIn, at: Entered, k: u32, params: vec4f) -> Path {
    if (pixel.shell.order >= SHELL_FOLDED) {
        return folded_segment(pixel, at, k, params);
    }
    let along = normalize(pixel.direction);
    let middle = middle_of(pixel, along);
    let prism = prism_of(pixel, along, middle, params);
    let heights = pixel.shell.heights;
    let mean = 0.5 * (heights.x + heights.y);
    let first = chord_end(at, k);
    let last = chord_end(at, k + 1u);
    let a = shell_point(prism, along * first, mean);
    let b = shell_point(prism, along * last, mean);
    let m = shell_point_from(prism, along * (0.5 * (first + last)), between(a, b));
    let bend = 2.0 * (a.height + b.height - 2.0 * m.height);
    let beyond = vec3f(
        length(prism.p2 - prism.p1),
        length(prism.p0 - prism.p2),
        length(prism.p1 - prism.p0),
    ) * (chord_reach(pixel, at, middle, params) / length(cross(prism.p1 - prism.p0, prism.p2 - prism.p0)));
    return chord_path(pixel, at, middle, params, a, b, bend, vec2f(first, last), beyond);
}"#,
    },
    Declaration {
        module: "surface/prism",
        name: "folded_enter",
        sampling: None,
        uses: &["Entered", "PixelIn", "chord_reach", "middle_of", "prism_of", "shell_middle", "shell_slack", "way_beyond", "way_chord", "way_of", "way_offsets"],
        text: r#"// The ways through a shell that overlaps itself. All chords of these ways are segments.
fn folded_enter(pixel: PixelIn, params: vec4f) -> Entered {
    let along = normalize(pixel.direction);
    let middle = middle_of(pixel, along);
    let prism = prism_of(pixel, along, middle, params);
    var at = shell_middle(pixel, along);
    let way = way_of(pixel, prism, along);
    let offsets = way_offsets(pixel, prism, shell_slack(pixel, middle));
    let beyond = way_beyond(prism, offsets, chord_reach(pixel, at, middle, params));
    at.segments = way_chord(pixel, prism, along, way, offsets, beyond, params.x, 0u).count;
    return at;
}"#,
    },
    Declaration {
        module: "surface/prism",
        name: "folded_segment",
        sampling: None,
        uses: &["Entered", "MOST_BESIDE", "Path", "PixelIn", "before_turn", "chord_path", "chord_reach", "middle_of", "prism_of", "shell_slack", "way_bend", "way_beyond", "way_chord", "way_of", "way_offsets", "way_point"],
        text: r#"fn folded_segment(pixel: PixelIn, at: Entered, k: u32, params: vec4f) -> Path {
    let along = normalize(pixel.direction);
    let middle = middle_of(pixel, along);
    let prism = prism_of(pixel, along, middle, params);
    let slack = shell_slack(pixel, middle);
    let way = way_of(pixel, prism, along);
    let offsets = way_offsets(pixel, prism, slack);
    let beyond = way_beyond(prism, offsets, chord_reach(pixel, at, middle, params));
    let chord = way_chord(pixel, prism, along, way, offsets, beyond, params.x, k);
    let ends = before_turn(prism, along, way, chord.offsets);
    var a = way_point(prism, along, way, ends.x);
    let m = way_point(prism, along, way, 0.5 * (ends.x + ends.y));
    var b = way_point(prism, along, way, ends.y);
    if (b.t < a.t) {
        let turned = b;
        b = a;
        a = turned;
    }
    let part = (m.t - a.t) / (b.t - a.t);
    let bend = way_bend(a.point.height, m.point.height, b.point.height, part);
    var path = chord_path(pixel, at, middle, params, a.point, b.point, bend, vec2f(a.t, b.t), beyond);
    // Where a triangle shrinks to nothing, its weights say nothing about the ray.
    if (!(a.beside < MOST_BESIDE * slack) || !(b.beside < MOST_BESIDE * slack)) {
        path.exit = 0.0;
    }
    return path;
}"#,
    },
    Declaration {
        module: "surface/prism",
        name: "chord_reach",
        sampling: None,
        uses: &["Entered", "PixelIn", "height_size", "shell_slack"],
        text: r#"// Metres by which a chord reaches beyond the triangle's sides: by rounding, and by the greatest
// distance of chords from the way.
fn chord_reach(pixel: PixelIn, at: Entered, middle: f32, params: vec4f) -> f32 {
    let texel = sqrt(max(at.metric.x, at.metric.z)) / max(height_size(0u).x, height_size(0u).y);
    return shell_slack(pixel, middle) + 2.0 * params.x * texel;
}"#,
    },
    Declaration {
        module: "surface/prism",
        name: "chord_path",
        sampling: None,
        uses: &["Entered", "Path", "PixelIn", "RAY_VIEW", "ShellPoint", "WRAP_CLAMP", "first_root", "inside_unit", "out_of_ground", "path_from", "shell_slack", "surface_settings", "uv_of", "where_positive"],
        text: r#"// The path of a chord between two points of the shell, where the ray is at `ends`: as far as the weights are
// not negative but for `beyond`.
fn chord_path(
    pixel: PixelIn,
    at: Entered,
    middle: f32,
    params: vec4f,
    a: ShellPoint,
    b: ShellPoint,
    bend: f32,
    ends: vec2f,
    beyond: vec3f,
) -> Path {
    let heights = pixel.shell.heights;
    let first = ends.x;
    let long = ends.y - ends.x;
    let uv = uv_of(pixel, a.weights);
    let duv = (uv_of(pixel, b.weights) - uv) / long;
    let slope = b.height - a.height - bend;
    let slack = shell_slack(pixel, middle);
    let change = (b.weights - a.weights) / long;
    // Nothing behind the eye is visible.
    var inside = vec2f(max(0.0, 0.0 - middle - first), long);
    inside = where_positive(inside, a.weights.x, change.x, beyond.x);
    inside = where_positive(inside, a.weights.y, change.y, beyond.y);
    inside = where_positive(inside, a.weights.z, change.z, beyond.z);
    if (surface_settings.wrap == WRAP_CLAMP) {
        inside = inside_unit(uv.x, duv.x, inside);
        inside = inside_unit(uv.y, duv.y, inside);
    }
    var path = Path(
        uv,
        duv,
        vec3f(a.height, slope / long, bend / (long * long)),
        inside.y,
        0.0,
        at.metric,
        RAY_VIEW,
        at.level,
        middle + first,
        1.0 / f32(at.segments),
        0.0,
    );
    if (!(inside.y > inside.x)) {
        path.exit = 0.0;
        return path;
    }
    path = path_from(path, inside.x);
    // Above the greatest height there is nothing to hit.
    let above = path.h.x - heights.y;
    if (above > 0.0) {
        path = path_from(path, min(first_root(vec3f(above, path.h.y, path.h.z), path.exit), path.exit));
    }
    if (path.exit > 0.0) {
        path = path_from(path, out_of_ground(path, 4.0 * slack, params.x));
    }
    return path;
}"#,
    },
    Declaration {
        module: "surface/prism",
        name: "point_of_way",
        sampling: None,
        uses: &["PixelIn", "Prism", "SHELL_FOLDED", "ShellPoint", "shell_point", "shell_point_near"],
        text: r#"// The point of the shell at a place of the ray, at about that height.
fn point_of_way(pixel: PixelIn, prism: Prism, place: vec3f, height: f32) -> ShellPoint {
    if (pixel.shell.order >= SHELL_FOLDED) {
        return shell_point_near(prism, place, height);
    }
    return shell_point(prism, place, height);
}"#,
    },
    Declaration {
        module: "surface/prism",
        name: "surface_prism_polish",
        sampling: None,
        uses: &["Entered", "HEIGHTS_A_TEXEL", "Hit", "POLISH_STEPS", "Path", "PixelIn", "SHELL_FOLDED", "cell_gap", "cell_of", "field_is_ground_stage", "grid_of", "height_at", "middle_of", "path_gap", "path_height", "point_of_way", "prism_of", "shell_point_from", "shell_point_near", "uv_of"],
        text: r#"// Moves the chord's hit along the ray until the way is as high above the surface there as the chord
// was. In a volume the hit stays on the chord, no farther from the way than the tolerance.
fn surface_prism_polish(pixel: PixelIn, at: Entered, path: Path, hit: Hit, params: vec4f) -> Hit {
    if (!field_is_ground_stage(path.level)) {
        return hit;
    }
    let along = normalize(pixel.direction);
    let middle = middle_of(pixel, along);
    let prism = prism_of(pixel, along, middle, params);
    let wanted = path_gap(path, hit.t);
    let grid = grid_of(path);
    let texels = abs(grid.step);
    // Not farther than chords may be from the way.
    let most = 2.0 * params.x / max(max(texels.x, texels.y), abs(path.h.y) / HEIGHTS_A_TEXEL);
    var t = hit.t;
    var point = point_of_way(pixel, prism, along * (path.start + t - middle), path_height(path, t));
    var step = 0u;
    while (step < POLISH_STEPS) {
        step = step + 1u;
        let gap = point.height - height_at(uv_of(pixel, point.weights), path.level) - wanted;
        let change = cell_gap(path, grid, cell_of(grid.origin + grid.step * t), t).y;
        if (change < 0.0) {
            t = clamp(t - gap / change, hit.t - most, hit.t + most);
        }
        let place = along * (path.start + t - middle);
        if (pixel.shell.order >= SHELL_FOLDED) {
            point = shell_point_near(prism, place, path_height(path, t));
        } else {
            point = shell_point_from(prism, place, point);
        }
    }
    return Hit(1u, hit.exhausted, uv_of(pixel, point.weights), point.height, t, hit.cost);
}"#,
    },
    Declaration {
        module: "surface/prism",
        name: "surface_prism_place",
        sampling: None,
        uses: &["Entered", "Hit", "Path", "PixelIn", "middle_of", "placed_at", "point_of_way", "prism_of"],
        text: r#"fn surface_prism_place(pixel: PixelIn, at: Entered, path: Path, hit: Hit, params: vec4f) -> Entered {
    let along = normalize(pixel.direction);
    let middle = middle_of(pixel, along);
    let prism = prism_of(pixel, along, middle, params);
    let s = path.start + hit.t - middle;
    let weights = point_of_way(pixel, prism, along * s, hit.height).weights;
    return placed_at(pixel, at, weights, pixel.origin + along * (path.start + hit.t), hit.uv);
}"#,
    },
    Declaration {
        module: "surface/quadric_perpendicular",
        name: "LEAST_SINE",
        sampling: None,
        uses: &[],
        text: r#"// The least sine of the angle between ray and normal: a ray along the normal has no way across it to the
// base.
const LEAST_SINE = 0.0009765625;"#,
    },
    Declaration {
        module: "surface/quadric_perpendicular",
        name: "SAME_DEPTH",
        sampling: None,
        uses: &[],
        text: r#"// The greatest rounding error of the ray's depth, in heights.
const SAME_DEPTH = 0.0009765625;"#,
    },
    Declaration {
        module: "surface/quadric_perpendicular",
        name: "Across",
        sampling: None,
        uses: &[],
        text: r#"// A ray over a quadric: along it and across it the changes of the texture coordinates and of the quadric.
struct Across {
    duv: vec2f,
    // The ray's descent per metre.
    descent: f32,
    // The quadric's height at the end of a metre along the ray, of one across it, and the sum's
    // mixed term.
    along: f32,
    across: f32,
    mixed: f32,
    // The rise of a metre across the ray.
    sine: f32,
}"#,
    },
    Declaration {
        module: "surface/quadric_perpendicular",
        name: "across_of",
        sampling: None,
        uses: &["Across", "Entered", "LEAST_SINE", "climb", "quadric_at", "quadric_slope"],
        text: r#"fn across_of(at: Entered, direction: vec3f) -> Across {
    let duv = climb(at, direction).xy;
    let descent = 0.0 - dot(at.normal, direction);
    let aside = at.normal + direction * descent;
    let sine = max(length(aside), LEAST_SINE);
    let q = at.of_surface.xyz;
    let beside = climb(at, aside / sine).xy;
    let mixed = dot(quadric_slope(q, duv), beside);
    return Across(duv, descent, quadric_at(q, duv), quadric_at(q, beside), mixed, sine);
}"#,
    },
    Declaration {
        module: "surface/quadric_perpendicular",
        name: "across_roots",
        sampling: None,
        uses: &["Across"],
        text: r#"// The radicand of equation 6, as a quadratic in the parameter.
fn across_roots(ray: Across) -> vec3f {
    return vec3f(
        ray.sine * ray.sine,
        -2.0 * ray.mixed * ray.sine - 4.0 * ray.across * ray.descent,
        ray.mixed * ray.mixed - 4.0 * ray.across * ray.along,
    );
}"#,
    },
    Declaration {
        module: "surface/quadric_perpendicular",
        name: "across_discriminant",
        sampling: None,
        uses: &["Across", "across_roots", "quadratic"],
        text: r#"fn across_discriminant(ray: Across, t: f32) -> f32 {
    return quadratic(across_roots(ray), t);
}"#,
    },
    Declaration {
        module: "surface/quadric_perpendicular",
        name: "across_depth",
        sampling: None,
        uses: &["Across", "across_discriminant"],
        text: r#"// The depth of the ray under the quadric, in metres.
fn across_depth(ray: Across, t: f32) -> f32 {
    let c = t * (ray.descent + t * ray.along);
    let discriminant = across_discriminant(ray, t);
    if (!(discriminant >= 0.0)) {
        return c;
    }
    let b = t * ray.mixed - ray.sine;
    let root = sqrt(discriminant);
    if (b < 0.0) {
        return 2.0 * c / (root - b);
    }
    if (ray.across != 0.0) {
        return (0.0 - b - root) / (2.0 * ray.across);
    }
    return c;
}"#,
    },
    Declaration {
        module: "surface/quadric_perpendicular",
        name: "down_across",
        sampling: None,
        uses: &["Across", "bent_descent", "reached"],
        text: r#"// The parameter where the ray comes down to that depth, in metres, by equation 6, or NEVER.
fn down_across(ray: Across, depth: f32) -> f32 {
    let under = depth * (ray.sine - depth * ray.across);
    return reached(ray, depth, bent_descent(under, ray.descent + depth * ray.mixed, ray.along));
}"#,
    },
    Declaration {
        module: "surface/quadric_perpendicular",
        name: "down_along",
        sampling: None,
        uses: &["Across", "bent_descent", "reached"],
        text: r#"// The parameter where the ray comes down to that depth by equation 7.
fn down_along(ray: Across, depth: f32) -> f32 {
    return reached(ray, depth, bent_descent(depth, ray.descent, ray.along));
}"#,
    },
    Declaration {
        module: "surface/quadric_perpendicular",
        name: "reached",
        sampling: None,
        uses: &["Across", "NEVER", "SAME_DEPTH", "across_depth", "traced_scale_m"],
        text: r#"// A parameter where the ray should be at that depth, or NEVER where the other equation or the other root
// holds.
fn reached(ray: Across, depth: f32, t: f32) -> f32 {
    let off = abs(across_depth(ray, t) - depth);
    return select(NEVER, t, t < NEVER && off <= SAME_DEPTH * (traced_scale_m() + abs(depth)));
}"#,
    },
    Declaration {
        module: "surface/quadric_perpendicular",
        name: "jumps_below",
        sampling: None,
        uses: &["Across", "NEVER", "across_roots", "first_root"],
        text: r#"// The parameter where the distance jumps to more than that depth, or NEVER.
fn jumps_below(ray: Across, depth: f32) -> f32 {
    let t = first_root(across_roots(ray), NEVER);
    let below = t < NEVER && t * (ray.descent + t * ray.along) >= depth;
    return select(NEVER, t, below);
}"#,
    },
    Declaration {
        module: "surface/quadric_perpendicular",
        name: "across_span",
        sampling: None,
        uses: &["Across", "BELOW_FLOOR", "Entered", "NEVER", "down_across", "down_along", "jumps_below", "traced_scale_m"],
        text: r#"// The extent of the ray in the relief, in metres from the base; empty if it ends before it begins.
fn across_span(at: Entered, ray: Across, eye: f32) -> vec2f {
    let nowhere = vec2f(1.0, -1.0);
    let scale = traced_scale_m();
    let height = at.of_surface.w;
    let over = (height - 1.0) * scale;
    let begin = min(min(down_across(ray, over), down_along(ray, over)), jumps_below(ray, over));
    if (!(begin < NEVER) || (height >= 1.0 && begin < 0.0)) {
        return nowhere;
    }
    let enter = max(begin, eye);
    let floor = height * scale;
    let by_across = down_across(ray, floor);
    let by_along = down_along(ray, floor);
    let by_jump = jumps_below(ray, floor);
    var leave = select(NEVER, by_across, by_across > enter);
    leave = min(leave, select(NEVER, by_along, by_along > enter));
    leave = min(leave, select(NEVER, by_jump, by_jump > enter));
    // The ray is above a convex quadric again.
    if (ray.along < 0.0) {
        let under = ray.descent * ray.descent + 4.0 * ray.along * over;
        if (under >= 0.0) {
            leave = min(leave, (ray.descent + sqrt(under)) / (-2.0 * ray.along));
        }
    }
    if (!(leave < NEVER)) {
        return nowhere;
    }
    return vec2f(enter, leave + (leave - enter) * (BELOW_FLOOR - 1.0));
}"#,
    },
    Declaration {
        module: "surface/quadric_perpendicular",
        name: "surface_quadric_perpendicular_enter",
        sampling: None,
        uses: &["Entered", "PixelIn", "plane_distance", "plane_normal", "surface_quadric_perpendicular_crossed", "surface_quadric_vertical_enter"],
        text: r#"fn surface_quadric_perpendicular_enter(pixel: PixelIn, params: vec4f) -> Entered {
    let at = surface_quadric_vertical_enter(pixel, params);
    let along = length(pixel.direction);
    let eye = 0.0 - plane_distance(pixel, plane_normal(pixel)) * along;
    return surface_quadric_perpendicular_crossed(at, pixel.direction / along, eye, params);
}"#,
    },
    Declaration {
        module: "surface/quadric_perpendicular",
        name: "surface_quadric_perpendicular_crossed",
        sampling: None,
        uses: &["Entered", "across_of", "across_span"],
        text: r#"fn surface_quadric_perpendicular_crossed(
    at: Entered,
    direction: vec3f,
    eye: f32,
    params: vec4f,
) -> Entered {
    var crossed = at;
    crossed.span = across_span(at, across_of(at, direction), eye);
    crossed.segments = select(0u, at.segments * u32(params.z), crossed.span.y > crossed.span.x);
    return crossed;
}"#,
    },
    Declaration {
        module: "surface/quadric_perpendicular",
        name: "surface_quadric_perpendicular_segment",
        sampling: None,
        uses: &["Entered", "Path", "PixelIn", "plane_distance", "plane_normal", "surface_quadric_perpendicular_way"],
        text: r#"fn surface_quadric_perpendicular_segment(pixel: PixelIn, at: Entered, k: u32, params: vec4f) -> Path {
    let along = length(pixel.direction);
    let distance = plane_distance(pixel, plane_normal(pixel)) * along;
    return surface_quadric_perpendicular_way(
        at, pixel.direction / along, distance, 0.0 - distance, k, params
    );
}"#,
    },
    Declaration {
        module: "surface/quadric_perpendicular",
        name: "surface_quadric_perpendicular_way",
        sampling: None,
        uses: &["BELOW_FLOOR", "Entered", "NEVER", "Path", "RAY_VIEW", "WRAP_CLAMP", "across_depth", "across_of", "inside_unit", "path_from", "surface_settings", "traced_scale_m"],
        text: r#"// One chord of the ray's extent.
fn surface_quadric_perpendicular_way(
    at: Entered,
    direction: vec3f,
    distance: f32,
    eye: f32,
    k: u32,
    params: vec4f,
) -> Path {
    let ray = across_of(at, direction);
    let scale = traced_scale_m();
    let whole = at.span.y - at.span.x;
    let first = at.span.x + whole * (f32(k) / params.z);
    let last = at.span.x + whole * (f32(k + 1u) / params.z);
    let long = last - first;
    var begin = at.of_surface.w - across_depth(ray, first) / scale;
    // Later it may be above the relief, where the distance has jumped.
    if (k == 0u) {
        begin = min(begin, 1.0);
    }
    let middle = at.of_surface.w - across_depth(ray, 0.5 * (first + last)) / scale;
    var end = at.of_surface.w - across_depth(ray, last) / scale;
    // Rounding must not let a ray end above a floor that it has come to.
    if (k + 1u == u32(params.z) && end < 0.5) {
        end = min(end, 1.0 - BELOW_FLOOR);
    }
    let bend = 2.0 * (begin + end - 2.0 * middle);
    let slope = end - begin - bend;
    let base = clamp(0.0 - first, 0.0 - NEVER, NEVER);
    var path = Path(
        at.uv + ray.duv * first,
        ray.duv,
        vec3f(begin, slope / long, bend / (long * long)),
        long,
        base,
        at.metric,
        RAY_VIEW,
        at.level,
        distance + first,
        1.0 / params.z,
        0.0,
    );
    var inside = vec2f(0.0, long);
    if (surface_settings.wrap == WRAP_CLAMP) {
        inside = inside_unit(path.uv.x, ray.duv.x, inside);
        inside = inside_unit(path.uv.y, ray.duv.y, inside);
        path.exit = inside.y;
        path = path_from(path, inside.x);
    }
    if (!(path.exit > 0.0)) {
        path.exit = 0.0;
    }
    return path;
}"#,
    },
    Declaration {
        module: "surface/quadric_perpendicular",
        name: "surface_quadric_perpendicular_frame",
        sampling: None,
        uses: &["Entered", "quadric_frame"],
        text: r#"fn surface_quadric_perpendicular_frame(at: Entered, aside: vec2f, params: vec4f) -> Entered {
    return quadric_frame(at, aside);
}"#,
    },
    Declaration {
        module: "surface/quadric_perpendicular",
        name: "surface_quadric_perpendicular_polish",
        sampling: None,
        uses: &["Entered", "Hit", "Path", "PixelIn"],
        text: r#"fn surface_quadric_perpendicular_polish(
    pixel: PixelIn,
    at: Entered,
    path: Path,
    hit: Hit,
    params: vec4f,
) -> Hit {
    return hit;
}"#,
    },
    Declaration {
        module: "surface/quadric_perpendicular",
        name: "surface_quadric_perpendicular_place",
        sampling: None,
        uses: &["Entered", "Hit", "Path", "PixelIn", "quadric_frame"],
        text: r#"// On the ray, in the frame that the quadric has there.
fn surface_quadric_perpendicular_place(
    pixel: PixelIn,
    at: Entered,
    path: Path,
    hit: Hit,
    params: vec4f,
) -> Entered {
    var placed = quadric_frame(at, hit.uv - at.uv);
    placed.point = pixel.origin + normalize(pixel.direction) * (path.start + hit.t);
    placed.uv = hit.uv;
    return placed;
}"#,
    },
    Declaration {
        module: "surface/quadric_vertical",
        name: "surface_quadric_vertical_enter",
        sampling: None,
        uses: &["Entered", "PixelIn", "quadric_of", "surface_plane_enter"],
        text: r#"fn surface_quadric_vertical_enter(pixel: PixelIn, params: vec4f) -> Entered {
    var at = surface_plane_enter(pixel, params);
    at.of_surface = quadric_of(pixel, at.point, params.y);
    // Where the interpolated normal is turned away, a ray may still come down into a hollow.
    let area = at.metric.x * at.metric.z - at.metric.y * at.metric.y;
    at.segments = select(0u, 1u, area > 0.0);
    return at;
}"#,
    },
    Declaration {
        module: "surface/quadric_vertical",
        name: "surface_quadric_vertical_segment",
        sampling: None,
        uses: &["Entered", "Path", "PixelIn", "plane_distance", "plane_normal", "surface_quadric_vertical_way"],
        text: r#"fn surface_quadric_vertical_segment(pixel: PixelIn, at: Entered, k: u32, params: vec4f) -> Path {
    let along = length(pixel.direction);
    // Metres along the ray, to the base.
    let distance = plane_distance(pixel, plane_normal(pixel)) * along;
    return surface_quadric_vertical_way(at, pixel.direction / along, distance, 0.0 - distance, k, params);
}"#,
    },
    Declaration {
        module: "surface/quadric_vertical",
        name: "surface_quadric_vertical_crossed",
        sampling: None,
        uses: &["Entered"],
        text: r#"// A ray may come down into a hollow wherever it meets the mesh.
fn surface_quadric_vertical_crossed(at: Entered, direction: vec3f, eye: f32, params: vec4f) -> Entered {
    return at;
}"#,
    },
    Declaration {
        module: "surface/quadric_vertical",
        name: "surface_quadric_vertical_way",
        sampling: None,
        uses: &["BELOW_FLOOR", "Entered", "NEVER", "Path", "RAY_VIEW", "WRAP_CLAMP", "bent_descent", "bent_exit", "climb", "inside_unit", "quadric_at", "surface_settings", "traced_scale_m"],
        text: r#"fn surface_quadric_vertical_way(
    at: Entered,
    direction: vec3f,
    distance: f32,
    eye: f32,
    k: u32,
    params: vec4f,
) -> Path {
    let duv = climb(at, direction).xy;
    let descent = 0.0 - dot(at.normal, direction);
    let scale = traced_scale_m();
    let height = at.of_surface.w;
    let slope = (0.0 - descent) / scale;
    let bend = quadric_at(at.of_surface.xyz, duv);
    let curve = (0.0 - bend) / scale;

    // Metres along the ray, counted from the base: entry at height 1 but not behind the eye.
    let top = bent_descent((height - 1.0) * scale, descent, bend);
    // Under a base that is higher than the triangle rays come down before they reach it, otherwise
    // behind it.
    let comes_down = top < NEVER && (height < 1.0 || top >= 0.0);
    var enter = max(top, eye);
    let begin = select(height + enter * (slope + curve * enter), 1.0, enter == top);
    var leave = enter + bent_exit(vec3f(begin, slope + 2.0 * curve * enter, curve));
    if (bend == 0.0) {
        leave = height * scale / descent;
        leave = leave + (leave - top) * (BELOW_FLOOR - 1.0);
    }
    if (surface_settings.wrap == WRAP_CLAMP) {
        var interval = inside_unit(at.uv.x, duv.x, vec2f(enter, leave));
        interval = inside_unit(at.uv.y, duv.y, interval);
        enter = interval.x;
        leave = interval.y;
    }
    let entry_height = select(height + enter * (slope + curve * enter), 1.0, enter == top);
    // Limits that are never reached, as on the plane.
    let base = clamp(0.0 - enter, 0.0 - NEVER, NEVER);
    var path = Path(
        at.uv + duv * enter,
        duv,
        vec3f(entry_height, slope + 2.0 * curve * enter, curve),
        leave - enter,
        base,
        at.metric,
        RAY_VIEW,
        at.level,
        distance + enter,
        1.0,
        0.0,
    );
    if (!comes_down || !(path.exit > 0.0)) {
        path.exit = 0.0;
    }
    return path;
}"#,
    },
    Declaration {
        module: "surface/quadric_vertical",
        name: "surface_quadric_vertical_frame",
        sampling: None,
        uses: &["Entered", "quadric_frame"],
        text: r#"fn surface_quadric_vertical_frame(at: Entered, aside: vec2f, params: vec4f) -> Entered {
    return quadric_frame(at, aside);
}"#,
    },
    Declaration {
        module: "surface/quadric_vertical",
        name: "surface_quadric_vertical_polish",
        sampling: None,
        uses: &["Entered", "Hit", "Path", "PixelIn"],
        text: r#"fn surface_quadric_vertical_polish(pixel: PixelIn, at: Entered, path: Path, hit: Hit, params: vec4f) -> Hit {
    return hit;
}"#,
    },
    Declaration {
        module: "surface/quadric_vertical",
        name: "surface_quadric_vertical_place",
        sampling: None,
        uses: &["Entered", "Hit", "Path", "PixelIn", "base_height", "field_height_stage", "quadric_at", "quadric_frame", "surface_settings", "traced_scale_m"],
        text: r#"// On the surface, whatever the height of the path there, in the frame that the quadric has there.
fn surface_quadric_vertical_place(
    pixel: PixelIn,
    at: Entered,
    path: Path,
    hit: Hit,
    params: vec4f,
) -> Entered {
    let aside = hit.uv - at.uv;
    let level = field_height_stage(hit.uv, hit.height, at.level);
    let height = surface_settings.bias_m + surface_settings.scale_m * level;
    let lifted = (base_height() - at.of_surface.w) * traced_scale_m() + quadric_at(at.of_surface.xyz, aside);
    var placed = quadric_frame(at, aside);
    placed.point =
        at.point + at.tangent * aside.x + at.bitangent * aside.y + at.normal * (height + lifted);
    placed.uv = hit.uv;
    return placed;
}"#,
    },
    Declaration {
        module: "surface/slices",
        name: "BESIDE_HEIGHTS",
        sampling: None,
        uses: &[],
        text: r#"// The greatest height, below 0 or above 1, at which rounding may put a drawn point.
const BESIDE_HEIGHTS = 0.000001;"#,
    },
    Declaration {
        module: "surface/slices",
        name: "SHORTEST",
        sampling: None,
        uses: &[],
        text: r#"// The length of a segment whose beginning is not known, as a part of its distance: the only hit on
// it is its end.
const SHORTEST = 0.0000005;"#,
    },
    Declaration {
        module: "surface/slices",
        name: "FARTHEST_M",
        sampling: None,
        uses: &[],
        text: r#"// Slices whose predecessor is farther away than this, in metres, are seen edge-on.
const FARTHEST_M = 1.0e9;"#,
    },
    Declaration {
        module: "surface/slices",
        name: "surface_slices_enter",
        sampling: None,
        uses: &["BESIDE_HEIGHTS", "Entered", "PixelIn", "is_on_map", "plane_normal", "surface_settings", "triangle_distance", "triangle_weights"],
        text: r#"fn surface_slices_enter(pixel: PixelIn, params: vec4f) -> Entered {
    let n = plane_normal(pixel);
    let point = pixel.origin + pixel.direction * triangle_distance(pixel, n);
    let w = triangle_weights(pixel, n, point);
    let uv = pixel.a.uv * w.x + pixel.b.uv * w.y + pixel.c.uv * w.z;
    let tangent = pixel.a.tangent * w.x + pixel.b.tangent * w.y + pixel.c.tangent * w.z;
    let bitangent = pixel.a.bitangent * w.x + pixel.b.bitangent * w.y + pixel.c.bitangent * w.z;
    let raw = pixel.a.normal * w.x + pixel.b.normal * w.y + pixel.c.normal * w.z;
    let slice = pixel.a.of_surface * w.x + pixel.b.of_surface * w.y + pixel.c.of_surface * w.z;
    let tt = dot(tangent, tangent);
    let tb = dot(tangent, bitangent);
    let bb = dot(bitangent, bitangent);
    let area = tt * bb - tb * tb;
    let height_m = surface_settings.bias_m + surface_settings.scale_m * slice.x;
    let normal = normalize(raw);
    // A slice that is larger than what the relief fills is clipped by the map's edge and by its heights.
    let is_within = is_on_map(uv) && abs(slice.x - 0.5) - 0.5 <= BESIDE_HEIGHTS;
    return Entered(
        select(0u, 1u, dot(n, n) > 0.0 && area > 0.0 && is_within),
        point - raw * height_m,
        uv,
        tangent,
        bitangent,
        normal,
        vec4f(tt, tb, bb, surface_settings.scale_m),
        0u,
        normal,
        vec2f(0.0, 0.0),
        vec4f(slice, 0.0),
        0.0,
        0.0,
        0.0,
    );
}"#,
    },
    Declaration {
        module: "surface/slices",
        name: "slice_above",
        sampling: None,
        uses: &["Entered", "FARTHEST_M", "PixelIn", "SHORTEST", "surface_settings", "weights_of"],
        text: r#"// From a slice of equal height back to the one before: the change of texture coordinates and height
// per metre of the ray, and the distance in metres. Zeros if that is not known. The slice before is
// the triangle moved along its normals.
fn slice_above(pixel: PixelIn, at: Entered, along: f32, far: f32) -> vec4f {
    let upward = select(-1.0, 1.0, dot(pixel.direction, at.normal) < 0.0) * at.of_surface.y;
    let step_m = upward * surface_settings.scale_m;
    let a = pixel.a.position + pixel.a.normal * step_m;
    let b = pixel.b.position + pixel.b.normal * step_m;
    let c = pixel.c.position + pixel.c.normal * step_m;
    let n = cross(b - a, c - a);
    let t = dot(n, a - pixel.origin) / dot(n, pixel.direction);
    let lead = far - t * along;
    if (!(lead > far * SHORTEST && abs(t) <= FARTHEST_M)) {
        return vec4f(0.0, 0.0, 0.0, 0.0);
    }
    let w = weights_of(a, b, c, n, pixel.origin + pixel.direction * t);
    let aside = pixel.a.uv * w.x + pixel.b.uv * w.y + pixel.c.uv * w.z - at.uv;
    return vec4f(vec3f(aside, upward) / lead, lead);
}"#,
    },
    Declaration {
        module: "surface/slices",
        name: "slice_beside",
        sampling: None,
        uses: &["Entered", "FARTHEST_M"],
        text: r#"// From a slice back to the one before where slices follow each other along another axis. `pace` is
// the ray's movement along that axis per metre. The part of the way before the relief is left out.
fn slice_beside(at: Entered, climbs: vec3f, pace: f32) -> vec4f {
    let up = select(at.of_surface.x, 1.0 - at.of_surface.x, climbs.z < 0.0) / abs(climbs.z);
    let lead = min(at.of_surface.y / pace, select(FARTHEST_M, up, abs(climbs.z) > 0.0));
    if (!(lead > 0.0 && lead <= FARTHEST_M)) {
        return vec4f(0.0, 0.0, 0.0, 0.0);
    }
    return vec4f(vec3f(0.0, 0.0, 0.0) - climbs, lead);
}"#,
    },
    Declaration {
        module: "surface/slices",
        name: "slice_before",
        sampling: None,
        uses: &["Entered", "PixelIn", "SLICES_ALONG_HEIGHT", "SLICES_ALONG_U", "SLICES_ALONG_V", "climb", "slice_above", "slice_beside"],
        text: r#"// From a slice back to the one before, along the axis of the triangle's slices.
fn slice_before(pixel: PixelIn, at: Entered, axis: u32, along: f32, far: f32) -> vec4f {
    if (axis == SLICES_ALONG_HEIGHT) {
        return slice_above(pixel, at, along, far);
    }
    let climbs = climb(at, pixel.direction / along);
    if (axis == SLICES_ALONG_U) {
        return slice_beside(at, climbs, abs(climbs.x));
    }
    if (axis == SLICES_ALONG_V) {
        return slice_beside(at, climbs, abs(climbs.y));
    }
    return slice_beside(at, climbs, 1.0 / along);
}"#,
    },
    Declaration {
        module: "surface/slices",
        name: "slice_spacing",
        sampling: None,
        uses: &["Entered", "SLICES_ALONG_HEIGHT", "SLICES_ALONG_U", "SLICES_ALONG_V", "traced_scale_m"],
        text: r#"// The distance of slices, as a height.
fn slice_spacing(at: Entered, axis: u32) -> f32 {
    let step = at.of_surface.y;
    if (axis == SLICES_ALONG_HEIGHT) {
        return step;
    }
    if (axis == SLICES_ALONG_U) {
        return step * sqrt(at.metric.x) / traced_scale_m();
    }
    if (axis == SLICES_ALONG_V) {
        return step * sqrt(at.metric.z) / traced_scale_m();
    }
    return step / traced_scale_m();
}"#,
    },
    Declaration {
        module: "surface/slices",
        name: "surface_slices_segment",
        sampling: None,
        uses: &["Entered", "Path", "PixelIn", "RAY_VIEW", "SHORTEST", "height_at", "plane_normal", "slice_before", "slice_spacing", "slices_stage", "triangle_distance"],
        text: r#"// From the slice before to this one, where the ray ends. Where it passes, there is no segment.
fn surface_slices_segment(pixel: PixelIn, at: Entered, k: u32, params: vec4f) -> Path {
    let along = length(pixel.direction);
    let far = triangle_distance(pixel, plane_normal(pixel)) * along;
    let axis = u32(pixel.a.of_surface.z);
    let height = at.of_surface.x;
    let passes = slices_stage(height_at(at.uv, at.level), height, slice_spacing(at, axis));
    let before = slice_before(pixel, at, axis, along, far);
    // Nothing is seen before the eye.
    let lead = select(far * SHORTEST, min(before.w, far), before.w > 0.0);
    return Path(
        at.uv + before.xy * lead,
        vec2f(0.0, 0.0) - before.xy,
        vec3f(height + before.z * lead, 0.0 - before.z, 0.0),
        select(0.0, lead, passes),
        lead,
        at.metric,
        RAY_VIEW,
        at.level,
        far - lead,
        1.0,
        0.0,
    );
}"#,
    },
    Declaration {
        module: "surface/slices",
        name: "surface_slices_polish",
        sampling: None,
        uses: &["Entered", "HEIGHTS_READ", "Hit", "Path", "PixelIn"],
        text: r#"fn surface_slices_polish(pixel: PixelIn, at: Entered, path: Path, hit: Hit, params: vec4f) -> Hit {
    var counted = hit;
    counted.cost = hit.cost + HEIGHTS_READ;
    return counted;
}"#,
    },
    Declaration {
        module: "surface/slices",
        name: "surface_slices_place",
        sampling: None,
        uses: &["Entered", "Hit", "Path", "PixelIn", "placed_over"],
        text: r#"// On the surface above the hit, in the frame of the point of the base under the slice.
fn surface_slices_place(pixel: PixelIn, at: Entered, path: Path, hit: Hit, params: vec4f) -> Entered {
    return placed_over(at, hit);
}"#,
    },
    Declaration {
        module: "surface/tetrahedra",
        name: "BEYOND_HEIGHTS",
        sampling: None,
        uses: &[],
        text: r#"// The heights by which segments go below the least height and above the greatest. Rays that end at
// a floor must cross it.
const BEYOND_HEIGHTS = 0.000001;"#,
    },
    Declaration {
        module: "surface/tetrahedra",
        name: "Tetrahedron",
        sampling: None,
        uses: &[],
        text: r#"// A tetrahedron along a ray, in metres from the ray's middle: the extent of the ray inside, and the
// weights of the triangle's corners, in their order, with the weight of the upper side.
struct Tetrahedron {
    inside: vec2f,
    weights: vec4f,
    // The change of the weights per metre.
    change: vec4f,
}"#,
    },
    Declaration {
        module: "surface/tetrahedra",
        name: "where_positive",
        sampling: None,
        uses: &["NEVER"],
        text: r#"// The part of an interval in which a weight is not negative, but for some slack.
fn where_positive(interval: vec2f, weight: f32, change: f32, slack: f32) -> vec2f {
    if (change == 0.0) {
        return vec2f(select(NEVER, interval.x, weight >= 0.0 - slack), interval.y);
    }
    let t = (0.0 - slack - weight) / change;
    if (change > 0.0) {
        return vec2f(max(interval.x, t), interval.y);
    }
    return vec2f(interval.x, min(interval.y, t));
}"#,
    },
    Declaration {
        module: "surface/tetrahedra",
        name: "tetrahedron",
        sampling: None,
        uses: &["NEVER", "PixelIn", "Tetrahedron", "ordered", "raised", "shell_slack", "where_positive"],
        text: r#"// One of three tetrahedra, by its number. It reaches as far beyond its faces as rounding may move
// the ray, so that no ray passes between two.
//
// Its corners are lower ones from the first on and upper ones to the last: one lower corner in
// number 2, all three in number 0.
fn tetrahedron(pixel: PixelIn, along: vec3f, middle: f32, number: u32) -> Tetrahedron {
    let origin = pixel.origin + along * middle;
    let is_first = number == 0u;
    let is_last = number == 2u;
    let q0 = raised(ordered(pixel, 0u), pixel.side, 0.0) - origin;
    let q1 = raised(ordered(pixel, select(1u, 0u, is_last)), pixel.side, select(0.0, 1.0, is_last)) - origin;
    let third = ordered(pixel, select(1u, 2u, is_first));
    let q2 = raised(third, pixel.side, select(1.0, 0.0, is_first)) - origin;
    let q3 = raised(ordered(pixel, 2u), pixel.side, 1.0) - origin;
    let e1 = q1 - q0;
    let e2 = q2 - q0;
    let e3 = q3 - q0;
    let n1 = cross(e2, e3);
    let n2 = cross(e3, e1);
    let n3 = cross(e1, e2);
    let n0 = cross(e2 - e1, e3 - e1);
    let volume = dot(e1, n1);
    let w1 = (0.0 - dot(q0, n1)) / volume;
    let w2 = (0.0 - dot(q0, n2)) / volume;
    let w3 = (0.0 - dot(q0, n3)) / volume;
    let w0 = dot(q1, n0) / volume;
    let g1 = dot(along, n1) / volume;
    let g2 = dot(along, n2) / volume;
    let g3 = dot(along, n3) / volume;
    let g0 = 0.0 - dot(along, n0) / volume;

    let slack = shell_slack(pixel, middle) / abs(volume);
    var inside = vec2f(0.0 - middle, NEVER);
    inside = where_positive(inside, w0, g0, slack * length(n0));
    inside = where_positive(inside, w1, g1, slack * length(n1));
    inside = where_positive(inside, w2, g2, slack * length(n2));
    inside = where_positive(inside, w3, g3, slack * length(n3));
    if (!(abs(volume) > 0.0) || !(inside.y < NEVER)) {
        inside = vec2f(NEVER, 0.0 - NEVER);
    }
    if (is_first) {
        return Tetrahedron(inside, vec4f(w0, w1, w2 + w3, w3), vec4f(g0, g1, g2 + g3, g3));
    }
    if (is_last) {
        let upper = vec2f(w1 + w2 + w3, g1 + g2 + g3);
        return Tetrahedron(inside, vec4f(w0 + w1, w2, w3, upper.x), vec4f(g0 + g1, g2, g3, upper.y));
    }
    return Tetrahedron(inside, vec4f(w0, w1 + w2, w3, w2 + w3), vec4f(g0, g1 + g2, g3, g2 + g3));
}"#,
    },
    Declaration {
        module: "surface/tetrahedra",
        name: "comes_before",
        sampling: None,
        uses: &[],
        text: r#"// Whether the ray reaches the first of two intervals first. If both begin together, the first one
// counts.
fn comes_before(a: vec2f, b: vec2f) -> u32 {
    return select(0u, 1u, a.x <= b.x);
}"#,
    },
    Declaration {
        module: "surface/tetrahedra",
        name: "is_met",
        sampling: None,
        uses: &["PixelIn", "tetrahedron"],
        text: r#"// Whether the ray goes through a tetrahedron.
fn is_met(pixel: PixelIn, along: vec3f, middle: f32, number: u32) -> bool {
    let inside = tetrahedron(pixel, along, middle, number).inside;
    return inside.y > inside.x;
}"#,
    },
    Declaration {
        module: "surface/tetrahedra",
        name: "surface_tetrahedra_enter",
        sampling: None,
        uses: &["Entered", "PixelIn", "is_met", "middle_of", "passed_by", "shell_middle"],
        text: r#"fn surface_tetrahedra_enter(pixel: PixelIn, params: vec4f) -> Entered {
    let along = normalize(pixel.direction);
    let middle = middle_of(pixel, along);
    let is_passed_by = !is_met(pixel, along, middle, 0u) && !is_met(pixel, along, middle, 1u)
        && !is_met(pixel, along, middle, 2u);
    if (is_passed_by) {
        return passed_by();
    }
    var at = shell_middle(pixel, along);
    at.segments = 3u;
    return at;
}"#,
    },
    Declaration {
        module: "surface/tetrahedra",
        name: "surface_tetrahedra_segment",
        sampling: None,
        uses: &["BEYOND_HEIGHTS", "Entered", "Path", "PixelIn", "RAY_VIEW", "WRAP_CLAMP", "comes_before", "inside_unit", "middle_of", "ordered", "out_of_ground", "path_from", "shell_slack", "surface_settings", "tetrahedron", "where_positive"],
        text: r#"fn surface_tetrahedra_segment(pixel: PixelIn, at: Entered, k: u32, params: vec4f) -> Path {
    let along = normalize(pixel.direction);
    let middle = middle_of(pixel, along);
    let first = tetrahedron(pixel, along, middle, 0u);
    let second = tetrahedron(pixel, along, middle, 1u);
    let third = tetrahedron(pixel, along, middle, 2u);
    // The number of tetrahedra before each.
    let first_second = comes_before(first.inside, second.inside);
    let first_third = comes_before(first.inside, third.inside);
    let second_third = comes_before(second.inside, third.inside);
    var chosen = first;
    if (first_second + (1u - second_third) == k) {
        chosen = second;
    }
    if (first_third + second_third == k) {
        chosen = third;
    }

    let a = ordered(pixel, 0u);
    let b = ordered(pixel, 1u);
    let c = ordered(pixel, 2u);
    let w = chosen.weights;
    let g = chosen.change;
    let uv = a.uv * w.x + b.uv * w.y + c.uv * w.z;
    let duv = a.uv * g.x + b.uv * g.y + c.uv * g.z;
    // Only the heights under the triangle can be hit.
    let slack = shell_slack(pixel, middle);
    let beyond = BEYOND_HEIGHTS + slack * abs(g.w);
    var inside = chosen.inside;
    inside = where_positive(inside, w.w - pixel.shell.heights.x, g.w, beyond);
    inside = where_positive(inside, pixel.shell.heights.y - w.w, 0.0 - g.w, beyond);
    if (surface_settings.wrap == WRAP_CLAMP) {
        inside = inside_unit(uv.x, duv.x, inside);
        inside = inside_unit(uv.y, duv.y, inside);
    }
    let whole = max(first.inside.y - first.inside.x, 0.0) + max(second.inside.y - second.inside.x, 0.0)
        + max(third.inside.y - third.inside.x, 0.0);
    var path = Path(
        uv + duv * inside.x,
        duv,
        vec3f(w.w + g.w * inside.x, g.w, 0.0),
        inside.y - inside.x,
        0.0,
        at.metric,
        RAY_VIEW,
        at.level,
        middle + inside.x,
        (inside.y - inside.x) / whole,
        0.0,
    );
    if (path.exit > 0.0) {
        path = path_from(path, out_of_ground(path, 4.0 * slack, 0.0));
    }
    return path;
}"#,
    },
    Declaration {
        module: "surface/tetrahedra",
        name: "surface_tetrahedra_polish",
        sampling: None,
        uses: &["Entered", "Hit", "Path", "PixelIn"],
        text: r#"fn surface_tetrahedra_polish(pixel: PixelIn, at: Entered, path: Path, hit: Hit, params: vec4f) -> Hit {
    return hit;
}"#,
    },
    Declaration {
        module: "surface/tetrahedra",
        name: "surface_tetrahedra_place",
        sampling: None,
        uses: &["Entered", "Hit", "Path", "PixelIn", "middle_of", "placed_at", "tetrahedron"],
        text: r#"// Where the ray is at the hit, with the frame of that point of the triangle.
fn surface_tetrahedra_place(pixel: PixelIn, at: Entered, path: Path, hit: Hit, params: vec4f) -> Entered {
    let along = normalize(pixel.direction);
    let middle = middle_of(pixel, along);
    let t = path.start + hit.t - middle;
    // The tetrahedron that the hit lies in, or is nearest to.
    var nearest = tetrahedron(pixel, along, middle, 0u);
    var beside = max(nearest.inside.x - t, t - nearest.inside.y);
    var number = 1u;
    while (number < 3u) {
        let other = tetrahedron(pixel, along, middle, number);
        let aside = max(other.inside.x - t, t - other.inside.y);
        if (aside < beside) {
            nearest = other;
            beside = aside;
        }
        number = number + 1u;
    }
    let weights = nearest.weights + nearest.change * t;
    let point = pixel.origin + along * (path.start + hit.t);
    return placed_at(pixel, at, weights.xyz, point, hit.uv);
}"#,
    },
    Declaration {
        module: "slice/at_least",
        name: "slice_at_least",
        sampling: None,
        uses: &[],
        text: r#"fn slice_at_least(map: f32, slice: f32, spacing: f32, params: vec4f) -> bool {
    return map >= slice;
}"#,
    },
    Declaration {
        module: "slice/band",
        name: "slice_band",
        sampling: None,
        uses: &[],
        text: r#"fn slice_band(map: f32, slice: f32, spacing: f32, params: vec4f) -> bool {
    return abs(map - slice) <= 0.5 * spacing;
}"#,
    },
    Declaration {
        module: "slice/inside",
        name: "slice_inside",
        sampling: None,
        uses: &[],
        text: r#"fn slice_inside(map: f32, slice: f32, spacing: f32, params: vec4f) -> bool {
    return map > slice;
}"#,
    },
    Declaration {
        module: "object/blend",
        name: "MIDDLE_HEIGHT",
        sampling: None,
        uses: &[],
        text: r#"// The height of the plane through the middle of the ball that all frames show.
const MIDDLE_HEIGHT = 0.5;"#,
    },
    Declaration {
        module: "object/blend",
        name: "LOOK",
        sampling: None,
        uses: &["HEIGHTS_READ", "STEP"],
        text: r#"// The cost of one read of a frame.
const LOOK = HEIGHTS_READ + STEP;"#,
    },
    Declaration {
        module: "object/blend",
        name: "look_into_frame",
        sampling: None,
        uses: &["EMPTY_HEIGHT", "cell_of", "height_cell", "height_size"],
        text: r#"// The part of the four texels around a place that shows something, and the mean height of that
// part.
fn look_into_frame(uv: vec2f) -> vec2f {
    let at = uv * height_size(0u) - vec2f(0.5, 0.5);
    let cell = cell_of(at);
    let part = at - cell;
    let h = height_cell(vec2i(cell), 0u);
    let x = 1.0 - part.x;
    let y = 1.0 - part.y;
    let weights = vec4f(
        select(0.0, x * y, h.x > EMPTY_HEIGHT),
        select(0.0, part.x * y, h.y > EMPTY_HEIGHT),
        select(0.0, x * part.y, h.z > EMPTY_HEIGHT),
        select(0.0, part.x * part.y, h.w > EMPTY_HEIGHT),
    );
    let cover = (weights.x + weights.y) + (weights.z + weights.w);
    if (cover > 0.0) {
        return vec2f(cover, dot(weights, h) / cover);
    }
    return vec2f(0.0, 0.0);
}"#,
    },
    Declaration {
        module: "object/blend",
        name: "look_along",
        sampling: None,
        uses: &["Image", "MIDDLE_HEIGHT", "Path", "height_size", "look_into_frame", "path_uv"],
        text: r#"// The coverage and the height that a frame shows along a ray, after `steps` moves, as described
// above.
fn look_along(path: Path, image: Image, steps: u32) -> vec2f {
    // Around the frame nothing is visible.
    let beyond = vec2f(0.5, 0.5) / height_size(0u);
    let low = image.corner - beyond;
    let high = image.corner + image.extent + beyond;
    var height = MIDDLE_HEIGHT;
    var cover = 0.0;
    var step = 0u;
    while (step <= steps) {
        let uv = path_uv(path, (height - path.h.x) / path.h.y);
        let look = look_into_frame(clamp(uv, low, high));
        cover = look.x;
        height = select(height, look.y, cover > 0.0);
        step = step + 1u;
    }
    return vec2f(cover, height);
}"#,
    },
    Declaration {
        module: "object/blend",
        name: "object_blend",
        sampling: None,
        uses: &["Entered", "FRAMES", "FirstHit", "Hit", "LEAST_FRAME_COVER", "LEAST_FRAME_FACING", "LOOK", "NO_COST", "PixelIn", "frame_number", "frame_weight", "frames_around", "hit_on_segment", "image_of_object", "look_along", "miss", "path_height", "path_uv", "segment_of"],
        text: r#"fn object_blend(pixel: PixelIn, at: Entered, params: vec4f) -> FirstHit {
    let toward = -normalize(pixel.direction);
    let frames = frames_around(toward);
    var cost = NO_COST;
    var cover = 0.0;
    var along = 0.0;
    var heaviest = 0u;
    var most = 0.0;
    var k = 0u;
    while (k < FRAMES) {
        let image = image_of_object(frame_number(frames, k));
        let weight = frame_weight(frames, k);
        if (dot(image.toward, toward) >= LEAST_FRAME_FACING) {
            let path = segment_of(pixel, at, k);
            let look = look_along(path, image, u32(params.w));
            let seen = weight * look.x;
            cost = cost + LOOK * (u32(params.w) + 1u);
            cover = cover + seen;
            along = along + seen * (path.start + (look.y - path.h.x) / path.h.y);
            if (seen > most) {
                most = seen;
                heaviest = k;
            }
        }
        k = k + 1u;
    }
    var first = FirstHit(miss(cost), 0u, 0.0);
    if (cover < LEAST_FRAME_COVER || along < 0.0) {
        return first;
    }
    // A hit of the frame with the greatest part of it.
    let path = segment_of(pixel, at, heaviest);
    let t = along / cover - path.start;
    let hit = Hit(1u, 0u, path_uv(path, t), path_height(path, t), t, cost);
    return hit_on_segment(pixel, at, path, hit, heaviest);
}"#,
    },
    Declaration {
        module: "object/blend",
        name: "object_blend_parts",
        sampling: None,
        uses: &[],
        text: r#"fn object_blend_parts(level: u32, params: vec4f) -> i32 {
    return 1;
}"#,
    },
    Declaration {
        module: "object/blend",
        name: "object_blend_cell",
        sampling: None,
        uses: &["height_cell"],
        text: r#"fn object_blend_cell(cell: vec2i, level: u32, params: vec4f) -> vec4f {
    return height_cell(cell, level);
}"#,
    },
    Declaration {
        module: "object/blend",
        name: "object_blend_color",
        sampling: None,
        uses: &["Entered", "Hit", "color_of_object"],
        text: r#"fn object_blend_color(at: Entered, hit: Hit, view: vec3f, params: vec4f) -> vec3f {
    return color_of_object(at, view, params.z);
}"#,
    },
    Declaration {
        module: "object/depth",
        name: "object_depth",
        sampling: None,
        uses: &["Entered", "FirstHit", "PixelIn", "first_in_all"],
        text: r#"fn object_depth(pixel: PixelIn, at: Entered, params: vec4f) -> FirstHit {
    return first_in_all(pixel, at);
}"#,
    },
    Declaration {
        module: "object/depth",
        name: "object_depth_parts",
        sampling: None,
        uses: &["parts_of_images"],
        text: r#"fn object_depth_parts(level: u32, params: vec4f) -> i32 {
    return parts_of_images();
}"#,
    },
    Declaration {
        module: "object/depth",
        name: "object_depth_cell",
        sampling: None,
        uses: &["cell_of_images"],
        text: r#"fn object_depth_cell(cell: vec2i, level: u32, params: vec4f) -> vec4f {
    return cell_of_images(cell, level);
}"#,
    },
    Declaration {
        module: "object/depth",
        name: "object_depth_color",
        sampling: None,
        uses: &["Entered", "Hit", "color_of_object"],
        text: r#"fn object_depth_color(at: Entered, hit: Hit, view: vec3f, params: vec4f) -> vec3f {
    return color_of_object(at, view, params.z);
}"#,
    },
    Declaration {
        module: "object/hull",
        name: "object_hull",
        sampling: None,
        uses: &["Entered", "FirstHit", "PixelIn", "first_in_all"],
        text: r#"fn object_hull(pixel: PixelIn, at: Entered, params: vec4f) -> FirstHit {
    return first_in_all(pixel, at);
}"#,
    },
    Declaration {
        module: "object/hull",
        name: "object_hull_parts",
        sampling: None,
        uses: &[],
        text: r#"fn object_hull_parts(level: u32, params: vec4f) -> i32 {
    return 1;
}"#,
    },
    Declaration {
        module: "object/hull",
        name: "object_hull_cell",
        sampling: None,
        uses: &["cell_of_mask"],
        text: r#"fn object_hull_cell(cell: vec2i, level: u32, params: vec4f) -> vec4f {
    return cell_of_mask(cell, level);
}"#,
    },
    Declaration {
        module: "object/hull",
        name: "object_hull_color",
        sampling: None,
        uses: &["Entered", "Hit", "color_of_object"],
        text: r#"fn object_hull_color(at: Entered, hit: Hit, view: vec3f, params: vec4f) -> vec3f {
    return color_of_object(at, view, params.z);
}"#,
    },
    Declaration {
        module: "object/none",
        name: "object_none",
        sampling: None,
        uses: &["Entered", "FirstHit", "NO_COST", "PixelIn", "SHELL_FOLDED", "hit_on_segment", "miss", "segment_of", "trace"],
        text: r#"fn object_none(pixel: PixelIn, at: Entered, params: vec4f) -> FirstHit {
    var cost = NO_COST;
    var first = FirstHit(miss(cost), 0u, 0.0);
    var k = 0u;
    while (k < at.segments) {
        let path = segment_of(pixel, at, k);
        if (path.exit > 0.0) {
            let here = hit_on_segment(pixel, at, path, trace(path), k);
            cost = cost + here.hit.cost;
            if (here.hit.found == 1u) {
                if (first.hit.found == 0u || here.key > first.key) {
                    first = here;
                }
                if (pixel.shell.order < SHELL_FOLDED) {
                    break;
                }
            }
        }
        k = k + 1u;
    }
    first.hit.cost = cost;
    return first;
}"#,
    },
    Declaration {
        module: "object/none",
        name: "object_none_parts",
        sampling: None,
        uses: &[],
        text: r#"fn object_none_parts(level: u32, params: vec4f) -> i32 {
    return 1;
}"#,
    },
    Declaration {
        module: "object/none",
        name: "object_none_cell",
        sampling: None,
        uses: &["height_cell"],
        text: r#"fn object_none_cell(cell: vec2i, level: u32, params: vec4f) -> vec4f {
    return height_cell(cell, level);
}"#,
    },
    Declaration {
        module: "object/none",
        name: "object_none_color",
        sampling: None,
        uses: &["Entered", "Hit", "color_or_white"],
        text: r#"fn object_none_color(at: Entered, hit: Hit, view: vec3f, params: vec4f) -> vec3f {
    return color_or_white(hit.uv, at.footprint);
}"#,
    },
    Declaration {
        module: "field/heights",
        name: "field_heights_gap",
        sampling: None,
        uses: &["Path", "height_at", "path_height", "path_uv"],
        text: r#"fn field_heights_gap(path: Path, t: f32, params: vec4f) -> f32 {
    return path_height(path, t) - height_at(path_uv(path, t), path.level);
}"#,
    },
    Declaration {
        module: "field/heights",
        name: "field_heights_cost",
        sampling: None,
        uses: &["HEIGHTS_READ"],
        text: r#"fn field_heights_cost(level: u32, params: vec4f) -> vec3u {
    return HEIGHTS_READ;
}"#,
    },
    Declaration {
        module: "field/heights",
        name: "field_heights_is_ground",
        sampling: None,
        uses: &[],
        text: r#"fn field_heights_is_ground(level: u32, params: vec4f) -> bool {
    return true;
}"#,
    },
    Declaration {
        module: "field/heights",
        name: "field_heights_height",
        sampling: None,
        uses: &["height_at"],
        text: r#"fn field_heights_height(uv: vec2f, height: f32, level: u32, params: vec4f) -> f32 {
    return height_at(uv, level);
}"#,
    },
    Declaration {
        module: "field/heights",
        name: "field_heights_normals",
        sampling: None,
        uses: &["Entered", "Hit", "SeenNormals", "mesostructure_normals"],
        text: r#"fn field_heights_normals(at: Entered, hit: Hit, view: vec3f, params: vec4f) -> SeenNormals {
    return mesostructure_normals(at, hit.uv, view);
}"#,
    },
    Declaration {
        module: "field/heights",
        name: "field_heights_normal",
        sampling: None,
        uses: &["Entered", "Hit", "normal_from_height"],
        text: r#"fn field_heights_normal(at: Entered, hit: Hit, view: vec3f, params: vec4f) -> vec3f {
    return normal_from_height(at, hit.uv, at.level);
}"#,
    },
    Declaration {
        module: "field/heights",
        name: "field_heights_patch_normal",
        sampling: None,
        uses: &["Entered", "Hit", "patch_normal"],
        text: r#"fn field_heights_patch_normal(at: Entered, hit: Hit, params: vec4f) -> vec3f {
    return patch_normal(at, hit.uv);
}"#,
    },
    Declaration {
        module: "field/heights",
        name: "field_heights_light_ray",
        sampling: None,
        uses: &["Entered", "Hit", "LightRay", "Toward", "light_ray_over_heights"],
        text: r#"fn field_heights_light_ray(at: Entered, hit: Hit, light: Toward, params: vec4f) -> LightRay {
    return light_ray_over_heights(at, hit, light);
}"#,
    },
    Declaration {
        module: "field/motif",
        name: "field_motif_gap",
        sampling: None,
        uses: &["Path"],
        text: r#"fn field_motif_gap(path: Path, t: f32, params: vec4f) -> f32 {
    return 1.0;
}"#,
    },
    Declaration {
        module: "field/motif",
        name: "field_motif_cost",
        sampling: None,
        uses: &["NO_COST"],
        text: r#"fn field_motif_cost(level: u32, params: vec4f) -> vec3u {
    return NO_COST;
}"#,
    },
    Declaration {
        module: "field/motif",
        name: "field_motif_is_ground",
        sampling: None,
        uses: &[],
        text: r#"fn field_motif_is_ground(level: u32, params: vec4f) -> bool {
    return false;
}"#,
    },
    Declaration {
        module: "field/motif",
        name: "field_motif_height",
        sampling: None,
        uses: &[],
        text: r#"fn field_motif_height(uv: vec2f, height: f32, level: u32, params: vec4f) -> f32 {
    return height;
}"#,
    },
    Declaration {
        module: "field/motif",
        name: "field_motif_normals",
        sampling: None,
        uses: &["Entered", "Hit", "SeenNormals", "field_motif_normal", "one_seen"],
        text: r#"// The normal on the side of the triangle that is seen. A closed motif is seen from its outside: at its
// outline the frame of the base would say otherwise here and there.
fn field_motif_normals(at: Entered, hit: Hit, view: vec3f, params: vec4f) -> SeenNormals {
    return one_seen(field_motif_normal(at, hit, view, params));
}"#,
    },
    Declaration {
        module: "field/motif",
        name: "field_motif_normal",
        sampling: None,
        uses: &["Entered", "Hit", "covector", "motif_is_closed", "motif_of"],
        text: r#"fn field_motif_normal(at: Entered, hit: Hit, view: vec3f, params: vec4f) -> vec3f {
    let point = motif_of(hit);
    let is_front = motif_is_closed() || dot(covector(at, point.facet), view) >= 0.0;
    let side = select(-1.0, 1.0, is_front);
    return normalize(covector(at, point.normal)) * side;
}"#,
    },
    Declaration {
        module: "field/motif",
        name: "field_motif_patch_normal",
        sampling: None,
        uses: &["Entered", "Hit", "covector", "motif_of"],
        text: r#"fn field_motif_patch_normal(at: Entered, hit: Hit, params: vec4f) -> vec3f {
    return normalize(covector(at, motif_of(hit).facet));
}"#,
    },
    Declaration {
        module: "field/motif",
        name: "field_motif_light_ray",
        sampling: None,
        uses: &["Entered", "Hit", "LightRay", "Toward", "light_ray_out_of_motif"],
        text: r#"fn field_motif_light_ray(at: Entered, hit: Hit, light: Toward, params: vec4f) -> LightRay {
    return light_ray_out_of_motif(at, hit, light);
}"#,
    },
    Declaration {
        module: "field/volume",
        name: "field_volume_gap",
        sampling: None,
        uses: &["Path", "SURFACE_VALUE", "field_at", "path_height", "path_uv"],
        text: r#"fn field_volume_gap(path: Path, t: f32, params: vec4f) -> f32 {
    return SURFACE_VALUE - field_at(vec3f(path_uv(path, t), path_height(path, t)));
}"#,
    },
    Declaration {
        module: "field/volume",
        name: "field_volume_cost",
        sampling: None,
        uses: &["VOXELS_READ"],
        text: r#"fn field_volume_cost(level: u32, params: vec4f) -> vec3u {
    return VOXELS_READ;
}"#,
    },
    Declaration {
        module: "field/volume",
        name: "field_volume_is_ground",
        sampling: None,
        uses: &[],
        text: r#"fn field_volume_is_ground(level: u32, params: vec4f) -> bool {
    return false;
}"#,
    },
    Declaration {
        module: "field/volume",
        name: "field_volume_height",
        sampling: None,
        uses: &[],
        text: r#"fn field_volume_height(uv: vec2f, height: f32, level: u32, params: vec4f) -> f32 {
    return height;
}"#,
    },
    Declaration {
        module: "field/volume",
        name: "field_volume_normals",
        sampling: None,
        uses: &["Entered", "Hit", "SeenNormals", "normal_of_field", "one_seen"],
        text: r#"fn field_volume_normals(at: Entered, hit: Hit, view: vec3f, params: vec4f) -> SeenNormals {
    return one_seen(normal_of_field(at, hit));
}"#,
    },
    Declaration {
        module: "field/volume",
        name: "field_volume_normal",
        sampling: None,
        uses: &["Entered", "Hit", "normal_of_field"],
        text: r#"fn field_volume_normal(at: Entered, hit: Hit, view: vec3f, params: vec4f) -> vec3f {
    return normal_of_field(at, hit);
}"#,
    },
    Declaration {
        module: "field/volume",
        name: "field_volume_patch_normal",
        sampling: None,
        uses: &["Entered", "Hit", "normal_of_field"],
        text: r#"fn field_volume_patch_normal(at: Entered, hit: Hit, params: vec4f) -> vec3f {
    return normal_of_field(at, hit);
}"#,
    },
    Declaration {
        module: "field/volume",
        name: "field_volume_light_ray",
        sampling: None,
        uses: &["Entered", "Hit", "LightRay", "Toward", "light_ray_out_of_volume"],
        text: r#"fn field_volume_light_ray(at: Entered, hit: Hit, light: Toward, params: vec4f) -> LightRay {
    return light_ray_out_of_volume(at, hit, light);
}"#,
    },
    Declaration {
        module: "detail/fade",
        name: "FLATTEST",
        sampling: None,
        uses: &[],
        text: r#"// Flatter than this, a path has too few bits left between its entry and its exit.
const FLATTEST = 0.9990234375;"#,
    },
    Declaration {
        module: "detail/fade",
        name: "LEAST_RANGE",
        sampling: None,
        uses: &[],
        text: r#"// Less than any difference of depths that counts.
const LEAST_RANGE = 0.000001;"#,
    },
    Declaration {
        module: "detail/fade",
        name: "detail_fade",
        sampling: None,
        uses: &["Detail", "Entered", "PixelIn", "depth_in_samples", "faded_detail", "footprint_of"],
        text: r#"fn detail_fade(pixel: PixelIn, at: Entered, params: vec4f) -> Detail {
    return faded_detail(footprint_of(pixel, at, params.x), depth_in_samples(pixel, at), params);
}"#,
    },
    Declaration {
        module: "detail/fade",
        name: "detail_fade_of_footprint",
        sampling: None,
        uses: &["Detail", "Entered", "depth_in_footprints", "faded_detail"],
        text: r#"fn detail_fade_of_footprint(at: Entered, footprint: f32, params: vec4f) -> Detail {
    return faded_detail(footprint, depth_in_footprints(at, footprint), params);
}"#,
    },
    Declaration {
        module: "detail/fade",
        name: "faded_detail",
        sampling: None,
        uses: &["Detail", "FLATTEST", "LEAST_RANGE", "levels_of", "surface_settings"],
        text: r#"// The detail of a footprint, for a relief that is as many samples deep.
fn faded_detail(footprint: f32, depth: f32, params: vec4f) -> Detail {
    let begin = params.z * params.w;
    let part = (begin - depth) / max(begin - params.z, LEAST_RANGE);
    let level = levels_of(footprint / params.y, surface_settings.height_levels).fine;
    return Detail(level, footprint, clamp(part, 0.0, FLATTEST));
}"#,
    },
    Declaration {
        module: "detail/footprint",
        name: "detail_footprint",
        sampling: None,
        uses: &["Detail", "Entered", "PixelIn", "detail_footprint_of_footprint", "footprint_of"],
        text: r#"fn detail_footprint(pixel: PixelIn, at: Entered, params: vec4f) -> Detail {
    return detail_footprint_of_footprint(at, footprint_of(pixel, at, params.x), params);
}"#,
    },
    Declaration {
        module: "detail/footprint",
        name: "detail_footprint_of_footprint",
        sampling: None,
        uses: &["Detail", "Entered", "levels_of", "surface_settings"],
        text: r#"fn detail_footprint_of_footprint(at: Entered, footprint: f32, params: vec4f) -> Detail {
    return Detail(levels_of(footprint / params.y, surface_settings.height_levels).fine, footprint, 0.0);
}"#,
    },
    Declaration {
        module: "detail/none",
        name: "detail_none",
        sampling: None,
        uses: &["Detail", "Entered", "PixelIn"],
        text: r#"fn detail_none(pixel: PixelIn, at: Entered, params: vec4f) -> Detail {
    return Detail(0u, 0.0, 0.0);
}"#,
    },
    Declaration {
        module: "detail/none",
        name: "detail_none_of_footprint",
        sampling: None,
        uses: &["Detail", "Entered"],
        text: r#"fn detail_none_of_footprint(at: Entered, footprint: f32, params: vec4f) -> Detail {
    return Detail(0u, 0.0, 0.0);
}"#,
    },
    Declaration {
        module: "search/cells",
        name: "search_cells",
        sampling: None,
        uses: &["FOUND_EXHAUSTED", "FOUND_MISS", "HEIGHTS_READ", "NO_COST", "Path", "STEP", "SearchResult", "cell_gap", "cell_leave", "cell_next", "cell_of", "falls_in_cell", "found_in_cell", "grid_of", "quadratic"],
        text: r#"fn search_cells(path: Path, params: vec4f) -> SearchResult {
    let grid = grid_of(path);
    var cell = cell_of(grid.origin);
    var t = 0.0;
    var cost = NO_COST;
    let limit = u32(params.x);
    while (cost.x < limit) {
        cost = cost + STEP;
        let c = cell_gap(path, grid, cell, t);
        cost = cost + HEIGHTS_READ;
        let leave = cell_leave(grid, cell);
        let end = min(min(leave.x, leave.y), path.exit);
        let span = max(end - t, 0.0);
        if (falls_in_cell(c, span)) {
            return found_in_cell(c, t, span, cost.x == 1u, cost);
        }
        if (end >= path.exit) {
            return SearchResult(FOUND_MISS, t, path.exit, c.x, quadratic(c, span), cost);
        }
        cell = cell_next(grid, cell, leave);
        t = max(t, end);
    }
    return SearchResult(FOUND_EXHAUSTED, t, path.exit, 0.0, 0.0, cost);
}"#,
    },
    Declaration {
        module: "search/cone",
        name: "search_cone",
        sampling: None,
        uses: &["FOUND_EXHAUSTED", "FOUND_MISS", "HEIGHTS_READ", "NO_COST", "Path", "STEP", "SearchResult", "cell_after", "cell_leave", "cell_of", "cone_slope", "corner_height", "falls_in_cell", "found_in_cell", "gap_to", "grid_of", "height_cell", "map_read", "nearest_corner", "path_height", "stays_inside", "whole_cell"],
        text: r#"fn search_cone(path: Path, params: vec4f) -> SearchResult {
    let grid = grid_of(path);
    let forward = grid.step >= vec2f(0.0, 0.0);
    var cell = cell_of(grid.origin);
    var t = 0.0;
    var cost = NO_COST;
    let limit = u32(params.x);
    while (cost.x < limit) {
        cost = cost + STEP;
        let first = cost.x == 0u;
        let heights = height_cell(whole_cell(cell), path.level);
        cost = cost + HEIGHTS_READ;
        let leave = cell_leave(grid, cell);
        let end = min(min(leave.x, leave.y), path.exit);
        let span = max(end - t, 0.0);
        let at = (grid.origin - cell) + grid.step * t;
        let corner = nearest_corner(at);
        let apex = corner_height(heights, corner);
        var next = t;
        if (path_height(path, t) > apex) {
            let texel = cell + corner;
            let slope = cone_slope(path, texel);
            cost = cost + map_read(path, 1u);
            if (slope >= 0.0) {
                next = t + stays_inside(path, grid, texel, apex, slope, t);
            }
        }
        if (next < end) {
            let c = gap_to(path, grid, cell, heights, t);
            if (falls_in_cell(c, span)) {
                return found_in_cell(c, t, span, first, cost);
            }
            next = max(t, end);
        }
        if (next >= path.exit) {
            return SearchResult(FOUND_MISS, t, path.exit, 0.0, 0.0, cost);
        }
        cell = cell_after(grid, cell, leave, forward, next);
        t = next;
    }
    return SearchResult(FOUND_EXHAUSTED, t, path.exit, 0.0, 0.0, cost);
}"#,
    },
    Declaration {
        module: "search/cone_moved",
        name: "search_cone_moved",
        sampling: None,
        uses: &["FOUND_ABOVE", "FOUND_BRACKET", "FOUND_MISS", "FOUND_STARTED_BELOW", "HEIGHTS_READ", "NO_COST", "Path", "ROUNDING", "STEP", "SearchResult", "map_read", "path_gap", "path_height", "path_slope", "path_uv", "search_texel_between", "slope_of"],
        text: r#"fn search_cone_moved(path: Path, params: vec4f) -> SearchResult {
    let aside = length(path.duv);
    var t = 0.0;
    var near = 0.0;
    var near_gap = 0.0;
    var cost = NO_COST;
    var k = 0.0;
    while (k < params.x) {
        cost = cost + STEP;
        let gap = path_gap(path, t);
        cost = cost + HEIGHTS_READ;
        if (gap <= 0.0) {
            if (t == 0.0 && gap < 0.0) {
                return SearchResult(FOUND_STARTED_BELOW, 0.0, 0.0, gap, gap, cost);
            }
            return SearchResult(FOUND_BRACKET, near, t, near_gap, gap, cost);
        }
        near = t;
        near_gap = gap;
        let slope = slope_of(search_texel_between(path, path_uv(path, t), 0).x);
        cost = cost + map_read(path, 4u);
        if (slope < 0.0) {
            break;
        }
        // A path that bends down is above its chord, one that bends up above its tangent.
        let rest = path.exit - t;
        let rise = path_slope(path, t) + min(path.h.z, 0.0) * rest;
        let terms = abs(path.h.x) + path.exit * (abs(path.h.y) + path.exit * abs(path.h.z));
        let far = (abs(path.uv) + abs(path.duv) * path.exit + vec2f(1.0, 1.0)) * slope;
        let lost = ROUNDING * (terms + far.x + far.y);
        let nearing = slope * aside - rise;
        let closing = nearing + ROUNDING * nearing;
        if (closing <= 0.0) {
            return SearchResult(FOUND_MISS, t, path.exit, 0.0, 0.0, cost);
        }
        t = t + max(gap - lost, 0.0) / closing;
        if (t >= path.exit) {
            return SearchResult(FOUND_MISS, near, path.exit, 0.0, 0.0, cost);
        }
        k = k + 1.0;
    }
    return SearchResult(FOUND_ABOVE, t, path.exit, path_height(path, t), 0.0, cost);
}"#,
    },
    Declaration {
        module: "search/dilation_erosion",
        name: "leaves_window",
        sampling: None,
        uses: &["Grid", "cell_leave"],
        text: r#"// The parameter at which the path leaves the square of cells within the radius of a cell.
fn leaves_window(grid: Grid, cell: vec2f, radius: f32) -> f32 {
    let wide = vec2f(radius, radius);
    let leave_low = cell_leave(grid, cell - wide);
    let leave_high = cell_leave(grid, cell + wide);
    let leave = select(leave_low, leave_high, grid.step > vec2f(0.0, 0.0));
    return min(leave.x, leave.y);
}"#,
    },
    Declaration {
        module: "search/dilation_erosion",
        name: "bracket_between",
        sampling: None,
        uses: &["FOUND_BRACKET", "FOUND_STARTED_BELOW", "HEIGHTS_READ", "Path", "SearchResult", "path_gap"],
        text: r#"// A bracket with both gaps read. Two reads.
fn bracket_between(path: Path, near: f32, far: f32, cost: vec3u) -> SearchResult {
    let gap = path_gap(path, near);
    if (near == 0.0 && gap < 0.0) {
        return SearchResult(FOUND_STARTED_BELOW, 0.0, 0.0, gap, gap, cost + HEIGHTS_READ);
    }
    return SearchResult(
        FOUND_BRACKET, near, far, gap, path_gap(path, far), cost + HEIGHTS_READ + HEIGHTS_READ
    );
}"#,
    },
    Declaration {
        module: "search/dilation_erosion",
        name: "search_dilation_erosion",
        sampling: None,
        uses: &["BESIDE", "FOUND_EXHAUSTED", "FOUND_MISS", "HEIGHTS_READ", "NO_COST", "Path", "ROUNDING", "STEP", "SearchResult", "bracket_between", "cell_after", "cell_leave", "cell_of", "falls_in_cell", "first_root", "found_in_cell", "gap_to", "grid_of", "height_cell", "height_texels", "image_of", "least_at", "leaves_window", "map_read", "path_height", "path_slope", "quadratic", "search_texel", "whole_cell"],
        text: r#"fn search_dilation_erosion(path: Path, params: vec4f) -> SearchResult {
    let grid = grid_of(path);
    let n = height_texels(path.level);
    let forward = grid.step >= vec2f(0.0, 0.0);
    var cell = cell_of(grid.origin);
    var t = 0.0;
    // The last place where the path is known to be above the surface.
    var safe = 0.0;
    var cost = NO_COST;
    let limit = u32(params.x);
    while (cost.x < limit) {
        cost = cost + STEP;
        let leave = cell_leave(grid, cell);
        let end = min(min(leave.x, leave.y), path.exit);
        let span = max(end - t, 0.0);
        var next = t;
        var looks = params.y > 0.5;
        let place = whole_cell(cell);
        let u = image_of(place.x, n.x);
        let v = image_of(place.y, n.y);
        if (u.y == BESIDE || v.y == BESIDE) {
            looks = true;
        } else {
            let bounds = search_texel(path, vec2i(u.x, v.x), 0, i32(path.level));
            cost = cost + map_read(path, 1u);
            let reach = max(min(leaves_window(grid, cell, params.z), path.exit) - t, 0.0);
            let furthest = t + reach;
            let rounded = abs(path.h.x) + furthest * (abs(path.h.y) + furthest * abs(path.h.z));
            let gap = vec3f(
                path_height(path, t) - bounds.y - ROUNDING * rounded,
                path_slope(path, t),
                path.h.z,
            );
            if (gap.x > 0.0) {
                safe = t;
                next = t + reach;
                if (quadratic(gap, least_at(gap, reach)) <= 0.0) {
                    next = t + min(first_root(gap, reach), reach);
                }
            }
            if (!looks && next < end && path_height(path, end) < bounds.x) {
                return bracket_between(path, safe, end, cost);
            }
        }
        if (next < end || !(end > t)) {
            if (looks) {
                cost = cost + HEIGHTS_READ;
                let heights = height_cell(place, path.level);
                let c = gap_to(path, grid, cell, heights, t);
                if (falls_in_cell(c, span)) {
                    return found_in_cell(c, t, span, t == 0.0, cost);
                }
            }
            next = max(t, end);
        }
        if (next >= path.exit) {
            return SearchResult(FOUND_MISS, t, path.exit, 0.0, 0.0, cost);
        }
        cell = cell_after(grid, cell, leave, forward, next);
        t = next;
    }
    return SearchResult(FOUND_EXHAUSTED, t, path.exit, 0.0, 0.0, cost);
}"#,
    },
    Declaration {
        module: "search/frustum",
        name: "frustum_slope",
        sampling: None,
        uses: &["BESIDE", "Path", "UPRIGHT", "height_texels", "image_of", "search_texel"],
        text: r#"// The slope of the frustum that stands on a cell, toward larger u and v if `forward` says so. One
// read; none, and a negative slope, where the map has no frustum.
fn frustum_slope(path: Path, cell: vec2i, forward: vec2<bool>) -> f32 {
    let n = height_texels(path.level);
    let u = image_of(cell.x, n.x);
    let v = image_of(cell.y, n.y);
    if (u.y == BESIDE || v.y == BESIDE) {
        return -1.0;
    }
    let slopes = search_texel(path, vec2i(u.x, v.x), 0, i32(path.level));
    // In a mirrored image forward is backward.
    let right = forward.x == (u.y == UPRIGHT);
    let down = forward.y == (v.y == UPRIGHT);
    return select(select(slopes.w, slopes.z, right), select(slopes.y, slopes.x, right), down);
}"#,
    },
    Declaration {
        module: "search/frustum",
        name: "stays_above",
        sampling: None,
        uses: &["NEVER", "ROUNDING", "first_root"],
        text: r#"// The length of the ray, from a height `above.x` over the frustum's top on, that stays above the
// frustum, as measured along one axis. `left` is the number of texels of the cell that are left
// along the axis. `speed` is in texels per unit of t. `lost` is what rounding may have taken off
// the gap.
fn stays_above(above: vec3f, slope: f32, left: f32, speed: f32, lost: f32, span: f32) -> f32 {
    let rise = slope * abs(speed);
    let gap = above.x + slope * left - lost;
    if (gap <= 0.0) {
        return 0.0;
    }
    let closing = (rise - above.y) + ROUNDING * (rise + abs(above.y));
    if (above.z != 0.0) {
        return first_root(vec3f(gap, 0.0 - closing, above.z), span);
    }
    if (closing > 0.0) {
        return gap / closing;
    }
    return NEVER;
}"#,
    },
    Declaration {
        module: "search/frustum",
        name: "search_frustum",
        sampling: None,
        uses: &["FOUND_EXHAUSTED", "FOUND_MISS", "HEIGHTS_READ", "NO_COST", "Path", "ROUNDING", "STEP", "SearchResult", "cell_after", "cell_leave", "cell_next", "cell_of", "falls_in_cell", "found_in_cell", "frustum_slope", "gap_to", "grid_of", "height_cell", "least_at", "map_read", "path_height", "path_slope", "quadratic", "stays_above", "whole_cell"],
        text: r#"fn search_frustum(path: Path, params: vec4f) -> SearchResult {
    let grid = grid_of(path);
    let forward = grid.step >= vec2f(0.0, 0.0);
    var cell = cell_of(grid.origin);
    var t = 0.0;
    var cost = NO_COST;
    let limit = u32(params.x);
    while (cost.x < limit) {
        cost = cost + STEP;
        let first = cost.x == 0u;
        let heights = height_cell(whole_cell(cell), path.level);
        cost = cost + HEIGHTS_READ;
        let leave = cell_leave(grid, cell);
        let end = min(min(leave.x, leave.y), path.exit);
        let span = max(end - t, 0.0);
        let top = max(max(heights.x, heights.y), max(heights.z, heights.w));
        let above = vec3f(path_height(path, t) - top, path_slope(path, t), path.h.z);
        let of_heights = ROUNDING * (abs(path.h.x) + t * (abs(path.h.y) + t * abs(path.h.z)));
        var next = max(t, end);
        var slope = -1.0;
        if (quadratic(above, least_at(above, span)) > of_heights && above.x > of_heights) {
            if (end < path.exit) {
                slope = frustum_slope(path, whole_cell(cell), forward);
                if (slope >= 0.0) {
                    cost = cost + map_read(path, 1u);
                }
            }
        } else {
            let c = gap_to(path, grid, cell, heights, t);
            if (falls_in_cell(c, span)) {
                return found_in_cell(c, t, span, first, cost);
            }
        }
        if (slope >= 0.0) {
            let at = (grid.origin - cell) + grid.step * t;
            let left = select(at, vec2f(1.0, 1.0) - at, forward);
            let far = abs(grid.origin) + abs(grid.step) * t + vec2f(1.0, 1.0);
            let lost = vec2f(of_heights, of_heights) + ROUNDING * slope * far;
            let rest = path.exit - t;
            let u = stays_above(above, slope, left.x, grid.step.x, lost.x, rest);
            let v = stays_above(above, slope, left.y, grid.step.y, lost.y, rest);
            next = max(next, t + min(u, v));
        }
        if (next >= path.exit) {
            return SearchResult(FOUND_MISS, t, path.exit, 0.0, 0.0, cost);
        }
        if (slope >= 0.0) {
            cell = cell_after(grid, cell, leave, forward, next);
        } else {
            cell = cell_next(grid, cell, leave);
        }
        t = next;
    }
    return SearchResult(FOUND_EXHAUSTED, t, path.exit, 0.0, 0.0, cost);
}"#,
    },
    Declaration {
        module: "search/generalised",
        name: "CLEAR_PART",
        sampling: None,
        uses: &[],
        text: r#"// Ways from here on, as parts of the longest, say that nothing is hit on the longest way.
const CLEAR_PART = 0.998;"#,
    },
    Declaration {
        module: "search/generalised",
        name: "BEFORE_HIT",
        sampling: None,
        uses: &[],
        text: r#"// Voxels by which the point that is returned lies before the hit of the map. Fewer, and the surface throws
// shadows on itself; more, and it becomes thicker.
const BEFORE_HIT = 0.5;"#,
    },
    Declaration {
        module: "search/generalised",
        name: "WayToSolid",
        sampling: None,
        uses: &[],
        text: r#"// What a look-up tells: the way to the solid in voxels, if something solid is on it.
struct WayToSolid {
    is_solid: u32,
    way: f32,
}"#,
    },
    Declaration {
        module: "search/generalised",
        name: "search_generalised",
        sampling: None,
        uses: &["BEFORE_HIT", "FOUND_ABOVE", "FOUND_EXHAUSTED", "FOUND_MISS", "FOUND_STARTED_BELOW", "Path", "STEP", "SURFACE_VALUE", "SearchResult", "VOXELS_READ", "field_at_voxel", "map_read", "volume_size", "voxel_path", "voxel_place_on", "way_to_solid"],
        text: r#"fn search_generalised(path: Path, params: vec4f) -> SearchResult {
    let walk = voxel_path(path);
    var t = 0.0;
    var cost = VOXELS_READ;
    if (field_at_voxel(voxel_place_on(walk, t)) > SURFACE_VALUE) {
        return SearchResult(FOUND_STARTED_BELOW, t, t, 0.0, 0.0, cost);
    }
    let last = volume_size().z - 1.0;
    let limit = u32(params.x);
    var looked = 0u;
    while (looked < limit) {
        let toward = walk.step + vec3f(0.0, 0.0, 2.0 * walk.bend * t);
        let speed = length(toward);
        let direction = toward / speed;
        // The map begins at the centres of the outermost slices.
        let place = voxel_place_on(walk, t);
        let beyond = place.z - clamp(place.z, 0.0, last);
        let is_inward = beyond * direction.z < 0.0;
        let before = select(0.0, abs(beyond / direction.z), is_inward);
        let ahead = way_to_solid(path, place + direction * before, direction, params);
        cost = cost + STEP + map_read(path, 32u);
        looked = looked + 1u;
        let far = t + (before + ahead.way) / speed;
        if (!(far < path.exit)) {
            return SearchResult(FOUND_MISS, path.exit, path.exit, 1.0, 1.0, cost);
        }
        if (ahead.is_solid == 1u) {
            return SearchResult(FOUND_ABOVE, max(far - BEFORE_HIT / speed, t), path.exit, 0.0, 1.0, cost);
        }
        t = far;
    }
    return SearchResult(FOUND_EXHAUSTED, t, t, 1.0, 1.0, cost);
}"#,
    },
    Declaration {
        module: "search/generalised",
        name: "way_to_solid",
        sampling: None,
        uses: &["CLEAR_PART", "Path", "WayToSolid", "search_texel", "slice_begin", "turn_of", "volume_size", "wrap_pair"],
        text: r#"// The way to the solid from a place in voxels, between the eight voxels and the four directions
// around. A way that ends nowhere is no number to be mixed with others: the greater part of the
// weights decides whether there is a hit.
fn way_to_solid(path: Path, place: vec3f, direction: vec3f, params: vec4f) -> WayToSolid {
    let last = volume_size().z - 1.0;
    let inside = vec3f(place.xy, clamp(place.z, 0.0, last));
    let first = floor(inside);
    let part = inside - first;
    let size = vec2i(volume_size().xy);
    let cell = vec3i(first);
    let columns = wrap_pair(cell.x, size.x);
    let rows = wrap_pair(cell.y, size.y);
    let elevation = clamp((0.5 + 0.5 * direction.z) * (params.z - 1.0), 0.0, params.z - 1.0);
    let below = min(floor(elevation), params.z - 2.0);
    let turn = turn_of(direction.xy) * params.y;
    let before = floor(turn);
    let most = params.w * CLEAR_PART;
    var sum = 0.0;
    var weights = 0.0;
    var k = 0u;
    // Two directions beside each other, below and above; for each two slices.
    while (k < 8u) {
        let is_next = (k & 1u) == 1u;
        let is_above = (k & 2u) == 2u;
        let is_upper = (k & 4u) == 4u;
        let behind = select(before + 1.0, 0.0, before + 1.0 >= params.y);
        let azimuth = select(before, behind, is_next);
        let layer = i32(azimuth * params.z + below + select(0.0, 1.0, is_above));
        let of_azimuth = select(1.0 - (turn - before), turn - before, is_next);
        let of_elevation = select(1.0 - (elevation - below), elevation - below, is_above);
        let of_slice = select(1.0 - part.z, part.z, is_upper);
        let weight = of_azimuth * of_elevation * of_slice;
        let begin = slice_begin(cell.z + select(0, 1, is_upper));
        let ways = vec4f(
            search_texel(path, begin + vec2i(columns.x, rows.x), layer, 0).x,
            search_texel(path, begin + vec2i(columns.y, rows.x), layer, 0).x,
            search_texel(path, begin + vec2i(columns.x, rows.y), layer, 0).x,
            search_texel(path, begin + vec2i(columns.y, rows.y), layer, 0).x,
        );
        let beside = vec2f(1.0 - part.x, part.x);
        let corners = vec4f(beside * (1.0 - part.y), beside * part.y) * weight;
        let limit = vec4f(most, most, most, most);
        let none = vec4f(0.0, 0.0, 0.0, 0.0);
        let solid = select(none, corners, ways < limit);
        let way = solid * ways;
        weights = weights + ((solid.x + solid.y) + (solid.z + solid.w));
        sum = sum + ((way.x + way.y) + (way.z + way.w));
        k = k + 1u;
    }
    if (weights >= 0.5) {
        return WayToSolid(1u, sum / weights);
    }
    return WayToSolid(0u, params.w);
}"#,
    },
    Declaration {
        module: "search/linear",
        name: "search_linear",
        sampling: None,
        uses: &["FOUND_BRACKET", "FOUND_MISS", "FOUND_STARTED_BELOW", "Path", "STEP", "SearchResult", "field_cost_stage", "path_gap"],
        text: r#"fn search_linear(path: Path, params: vec4f) -> SearchResult {
    // Cosine between ray and normal: the descent of a metre of the ray.
    let cosine = clamp(abs(path.h.y) * path.metric.w, 0.0, 1.0);
    let steps = max(1.0, ceil(params.x * mix(params.y, 1.0, cosine) * path.share));
    var near = 0.0;
    var near_gap = path_gap(path, 0.0);
    var cost = field_cost_stage(path.level);
    if (near_gap < 0.0) {
        return SearchResult(FOUND_STARTED_BELOW, 0.0, 0.0, near_gap, near_gap, cost);
    }
    var k = 1.0;
    while (k <= steps) {
        cost = cost + STEP;
        let t = path.exit * (k / steps);
        let gap = path_gap(path, t);
        cost = cost + field_cost_stage(path.level);
        if (gap <= 0.0) {
            return SearchResult(FOUND_BRACKET, near, t, near_gap, gap, cost);
        }
        near = t;
        near_gap = gap;
        k = k + 1.0;
    }
    return SearchResult(FOUND_MISS, near, near, near_gap, near_gap, cost);
}"#,
    },
    Declaration {
        module: "search/none",
        name: "search_none",
        sampling: None,
        uses: &["FOUND_UNBRACKETED", "NO_COST", "Path", "SearchResult"],
        text: r#"fn search_none(path: Path, params: vec4f) -> SearchResult {
    return SearchResult(FOUND_UNBRACKETED, 0.0, path.exit, 0.0, 0.0, NO_COST);
}"#,
    },
    Declaration {
        module: "search/pyramid",
        name: "FAR_OUT",
        sampling: None,
        uses: &[],
        text: r#"// No cell farther out is read.
const FAR_OUT = 1073741824;"#,
    },
    Declaration {
        module: "search/pyramid",
        name: "node_extent",
        sampling: None,
        uses: &["FAR_OUT", "MIRRORED", "UPRIGHT", "WRAP_CLAMP", "surface_settings"],
        text: r#"// Along an axis, the extent of a node: its first cell and the cell after its last. `cell` is any
// cell in it.
fn node_extent(cell: i32, image: vec2i, n: i32, level: u32) -> vec2i {
    let first = (image.x >> level) << level;
    let side = 1 << level;
    if (image.y == UPRIGHT) {
        let low = cell - (image.x - first);
        return vec2i(low, low + min(side, n - first));
    }
    if (image.y == MIRRORED) {
        // The last cell of the map is its own image, not an image of the other side.
        let high = cell + (image.x - first) + 1;
        return vec2i(high - min(side, n - 1 - first), high);
    }
    if (level > 0u && surface_settings.wrap == WRAP_CLAMP) {
        return vec2i(select(-FAR_OUT, n, cell >= n), select(0, FAR_OUT, cell >= n));
    }
    return vec2i(cell, cell + 1);
}"#,
    },
    Declaration {
        module: "search/pyramid",
        name: "search_pyramid",
        sampling: None,
        uses: &["FOUND_EXHAUSTED", "FOUND_MISS", "HEIGHTS_READ", "NO_COST", "Path", "ROUNDING", "STEP", "SearchResult", "cell_of", "falls_in_cell", "first_root", "found_in_cell", "gap_to", "grid_of", "height_texels", "image_of", "leaves_extent", "map_read", "node_extent", "object_cell_stage", "path_height", "path_slope", "search_texel"],
        text: r#"fn search_pyramid(path: Path, params: vec4f) -> SearchResult {
    let grid = grid_of(path);
    let n = height_texels(path.level);
    // Nodes that are wider than the path is long give no more than narrower ones.
    let long = max(abs(grid.step.x), abs(grid.step.y)) * path.exit;
    var top = 0u;
    var level = 0u;
    while ((1 << top) < max(n.x, n.y)) {
        top = top + 1u;
        if (f32(1 << level) < long) {
            level = level + 1u;
        }
    }
    var cell = vec2i(cell_of(grid.origin));
    var parent = vec2i(-1, -1);
    var t = 0.0;
    var cost = NO_COST;
    let limit = u32(params.x);
    while (cost.x < limit) {
        cost = cost + STEP;
        let u = image_of(cell.x, n.x);
        let v = image_of(cell.y, n.y);
        let place = vec2i(u.x, v.x);
        let above_level = level + 1u;
        let over = vec2i(place.x >> above_level, place.y >> above_level);
        let left = parent.x >= 0 && (parent.x != over.x || parent.y != over.y);
        if (left && level < top) {
            level = above_level;
        }
        let columns = node_extent(cell.x, u, n.x, level);
        let rows = node_extent(cell.y, v, n.y, level);
        let leave_u = leaves_extent(grid.origin.x, grid.step.x, columns);
        let leave_v = leaves_extent(grid.origin.y, grid.step.y, rows);
        let end = min(min(leave_u, leave_v), path.exit);
        let span = max(end - t, 0.0);
        let low = vec2i(columns.x, rows.x);
        let last = vec2i(columns.y - 1, rows.y - 1);
        if (level == 0u) {
            cost = cost + HEIGHTS_READ;
            let c = gap_to(path, grid, vec2f(cell), object_cell_stage(cell, path.level), t);
            if (falls_in_cell(c, span)) {
                return found_in_cell(c, t, span, t == 0.0, cost);
            }
        } else {
            cost = cost + map_read(path, 1u);
            let node = vec2i(place.x >> level, place.y >> level);
            let highest = search_texel(path, node, 0, i32(level + path.level) - 1).y;
            let furthest = t + span;
            let rounded = abs(path.h.x) + furthest * (abs(path.h.y) + furthest * abs(path.h.z));
            let gap = vec3f(
                path_height(path, t) - highest - ROUNDING * rounded,
                path_slope(path, t),
                path.h.z,
            );
            if (falls_in_cell(gap, span)) {
                // Down, to the child over which the path sinks to the maximum.
                if (gap.x > 0.0) {
                    t = t + min(first_root(gap, span), span);
                }
                cell = clamp(vec2i(cell_of(grid.origin + grid.step * t)), low, last);
                level = level - 1u;
                parent = vec2i(-1, -1);
                continue;
            }
        }
        if (end >= path.exit) {
            return SearchResult(FOUND_MISS, t, path.exit, 0.0, 0.0, cost);
        }
        cell = clamp(vec2i(cell_of(grid.origin + grid.step * end)), low, last);
        if (leave_u <= end) {
            cell.x = select(low.x - 1, columns.y, grid.step.x > 0.0);
        }
        if (leave_v <= end) {
            cell.y = select(low.y - 1, rows.y, grid.step.y > 0.0);
        }
        parent = vec2i(place.x >> (level + 1u), place.y >> (level + 1u));
        t = max(t, end);
    }
    return SearchResult(FOUND_EXHAUSTED, t, path.exit, 0.0, 0.0, cost);
}"#,
    },
    Declaration {
        module: "search/pyramid_texels",
        name: "texel_extent",
        sampling: None,
        uses: &["WRAP_MIRROR", "WRAP_REPEAT", "surface_settings", "wrap_index"],
        text: r#"// Along an axis of n texels, the extent of a node: its first texel and the texel after its last.
// `texel` is any texel in it. Beside a clamped map the extent is 1 texel.
fn texel_extent(texel: i32, n: i32, level: u32) -> vec2i {
    let place = wrap_index(texel, n);
    let first = (place >> level) << level;
    let last = min(first + (1 << level), n);
    if (texel == place || surface_settings.wrap == WRAP_REPEAT) {
        return vec2i(texel - place + first, texel - place + last);
    }
    if (surface_settings.wrap == WRAP_MIRROR) {
        let period = 2 * n;
        let folded = ((texel % period) + period) % period;
        if (folded < n) {
            return vec2i(texel - place + first, texel - place + last);
        }
        return vec2i(texel + place - last + 1, texel + place - first + 1);
    }
    return vec2i(texel, texel + 1);
}"#,
    },
    Declaration {
        module: "search/pyramid_texels",
        name: "search_pyramid_texels",
        sampling: None,
        uses: &["FOUND_BELOW", "FOUND_EXHAUSTED", "FOUND_MISS", "HEIGHT_READ", "NEVER", "NO_COST", "Path", "RAY_SHADOW", "STEP", "SearchResult", "cell_of", "first_root", "height_map", "height_size", "height_texels", "leaves_extent", "map_read", "path_height", "path_slope", "search_texel", "texel_extent", "wrap_index"],
        text: r#"fn search_pyramid_texels(path: Path, params: vec4f) -> SearchResult {
    let n = height_texels(path.level);
    let origin = path.uv * height_size(path.level);
    let step = path.duv * height_size(path.level);
    var level = 0u;
    while ((1 << level) < max(n.x, n.y)) {
        level = level + 1u;
    }
    var texel = vec2i(cell_of(origin));
    var t = 0.0;
    var cost = NO_COST;
    let limit = u32(params.x);
    var finest = min(u32(params.y), level);
    if (path.ray == RAY_SHADOW) {
        // Shadow rays begin on the surface, which coarse columns bury.
        finest = 0u;
    }
    while (cost.x < limit) {
        cost = cost + STEP;
        let place = vec2i(wrap_index(texel.x, n.x), wrap_index(texel.y, n.y));
        var highest = 0.0;
        if (level == 0u) {
            cost = cost + HEIGHT_READ;
            highest = textureLoad(height_map, place, 0).x;
        } else {
            let node = vec2i(place.x >> level, place.y >> level);
            cost = cost + map_read(path, 1u);
            highest = search_texel(path, node, 0, i32(level) - 1).y;
        }
        let columns = texel_extent(texel.x, n.x, level);
        let rows = texel_extent(texel.y, n.y, level);
        let leave = vec2f(
            leaves_extent(origin.x, step.x, columns),
            leaves_extent(origin.y, step.y, rows),
        );
        let end = max(min(min(leave.x, leave.y), path.exit), t);
        let gap = vec3f(path_height(path, t) - highest, path_slope(path, t), path.h.z);
        var sinks = 0.0;
        if (gap.x > 0.0) {
            sinks = first_root(gap, end - t);
        }
        let low = vec2i(columns.x, rows.x);
        let last = vec2i(columns.y - 1, rows.y - 1);
        if (sinks < NEVER) {
            t = t + sinks;
            if (level == finest) {
                return SearchResult(FOUND_BELOW, 0.0, t, 0.0, 0.0, cost);
            }
            level = level - 1u;
            texel = clamp(vec2i(cell_of(origin + step * t)), low, last);
        } else {
            if (end >= path.exit) {
                return SearchResult(FOUND_MISS, t, path.exit, 0.0, 0.0, cost);
            }
            texel = clamp(vec2i(cell_of(origin + step * end)), low, last);
            if (leave.x <= end) {
                texel.x = select(low.x - 1, columns.y, step.x > 0.0);
            }
            if (leave.y <= end) {
                texel.y = select(low.y - 1, rows.y, step.y > 0.0);
            }
            t = end;
        }
    }
    return SearchResult(FOUND_EXHAUSTED, t, path.exit, 0.0, 0.0, cost);
}"#,
    },
    Declaration {
        module: "search/relaxed_cone",
        name: "search_relaxed_cone",
        sampling: None,
        uses: &["FOUND_ABOVE", "FOUND_EXHAUSTED", "FOUND_MISS", "HEIGHTS_READ", "NEVER", "NO_COST", "Path", "ROUNDING", "STEP", "SearchResult", "cell_after", "cell_leave", "cell_of", "cone_slope", "entered_once", "falls_in_cell", "found_in_cell", "gap_to", "grid_of", "height_cell", "height_size", "map_read", "nearest_corner", "path_gap", "path_slope", "quadratic", "whole_cell"],
        text: r#"fn search_relaxed_cone(path: Path, params: vec4f) -> SearchResult {
    let grid = grid_of(path);
    let forward = grid.step >= vec2f(0.0, 0.0);
    let aside = length(path.duv);
    let rise = path_slope(path, 0.0);
    let terms = abs(path.h.x) + path.exit * abs(path.h.y);
    let far = (abs(grid.origin) + abs(grid.step) * path.exit + vec2f(1.0, 1.0)) / height_size(path.level);
    var cell = cell_of(grid.origin);
    var t = 0.0;
    // The last place known to be above the surface, and the gap there.
    var near = 0.0;
    var near_gap = 0.0;
    var cost = NO_COST;
    let limit = u32(params.x);
    while (cost.x < limit) {
        cost = cost + STEP;
        let leave = cell_leave(grid, cell);
        let end = min(min(leave.x, leave.y), path.exit);
        let span = max(end - t, 0.0);
        let c = gap_to(path, grid, cell, height_cell(whole_cell(cell), path.level), t);
        cost = cost + HEIGHTS_READ;
        if (c.x <= 0.0) {
            if (near < t && near_gap > 0.0) {
                return entered_once(path, grid, near, t, near_gap, c.x, cost);
            }
            return found_in_cell(c, t, span, t == 0.0, cost);
        }
        // The cone is read where the patch is done: where the path leaves the cell.
        var start = t;
        var gap = c.x;
        if (params.y > 0.5) {
            if (falls_in_cell(c, span)) {
                return found_in_cell(c, t, span, t == 0.0, cost);
            }
            start = max(t, end);
            gap = quadratic(c, span);
        }
        if (start >= path.exit) {
            return SearchResult(FOUND_MISS, t, path.exit, 0.0, 0.0, cost);
        }
        near = start;
        near_gap = gap;
        let slope = cone_slope(path, cell + nearest_corner((grid.origin - cell) + grid.step * start));
        cost = cost + map_read(path, 1u);
        var next = start;
        if (slope >= 0.0) {
            let nearing = slope * aside - rise;
            let closing = nearing + ROUNDING * nearing;
            let room = gap - ROUNDING * (terms + slope * (far.x + far.y));
            next = NEVER;
            if (closing > 0.0) {
                next = start + max(room, 0.0) / closing;
            }
        }
        if (params.y < 0.5 && !(next - t > ROUNDING * path.exit)) {
            return SearchResult(FOUND_ABOVE, t, path.exit, gap, 0.0, cost);
        }
        if (next >= path.exit) {
            let last = path_gap(path, path.exit);
            cost = cost + HEIGHTS_READ;
            if (last <= 0.0) {
                return entered_once(path, grid, start, path.exit, gap, last, cost);
            }
            return SearchResult(FOUND_MISS, start, path.exit, 0.0, 0.0, cost);
        }
        cell = cell_after(grid, cell, leave, forward, next);
        t = next;
    }
    return SearchResult(FOUND_EXHAUSTED, t, path.exit, 0.0, 0.0, cost);
}"#,
    },
    Declaration {
        module: "search/relaxed_cone_resting",
        name: "search_relaxed_cone_resting",
        sampling: None,
        uses: &["FOUND_EXHAUSTED", "FOUND_MISS", "HEIGHTS_READ", "NO_COST", "Path", "STEP", "SearchResult", "cell_after", "cell_leave", "cell_of", "cone_slope", "corner_height", "entered_once", "falls_in_cell", "found_in_cell", "gap_to", "grid_of", "height_cell", "map_read", "nearest_corner", "path_gap", "path_height", "quadratic", "stays_inside", "whole_cell"],
        text: r#"fn search_relaxed_cone_resting(path: Path, params: vec4f) -> SearchResult {
    let grid = grid_of(path);
    let forward = grid.step >= vec2f(0.0, 0.0);
    var cell = cell_of(grid.origin);
    var t = 0.0;
    // The last place known to be above the surface, and the gap there.
    var near = 0.0;
    var near_gap = 0.0;
    var cost = NO_COST;
    let limit = u32(params.x);
    while (cost.x < limit) {
        cost = cost + STEP;
        let heights = height_cell(whole_cell(cell), path.level);
        cost = cost + HEIGHTS_READ;
        let leave = cell_leave(grid, cell);
        let end = min(min(leave.x, leave.y), path.exit);
        let span = max(end - t, 0.0);
        let c = gap_to(path, grid, cell, heights, t);
        if (c.x <= 0.0) {
            if (near < t && near_gap > 0.0) {
                return entered_once(path, grid, near, t, near_gap, c.x, cost);
            }
            return found_in_cell(c, t, span, t == 0.0, cost);
        }
        if (falls_in_cell(c, span)) {
            return found_in_cell(c, t, span, t == 0.0, cost);
        }
        let start = max(t, end);
        if (start >= path.exit) {
            return SearchResult(FOUND_MISS, t, path.exit, 0.0, 0.0, cost);
        }
        near = start;
        near_gap = quadratic(c, span);
        // The cone is read where the patch is done: where the path leaves the cell.
        let corner = nearest_corner((grid.origin - cell) + grid.step * start);
        let apex = corner_height(heights, corner);
        var next = start;
        if (path_height(path, start) > apex) {
            let texel = cell + corner;
            let slope = cone_slope(path, texel);
            cost = cost + map_read(path, 1u);
            if (slope >= 0.0) {
                next = start + stays_inside(path, grid, texel, apex, slope, start);
            }
        }
        if (next >= path.exit) {
            let last = path_gap(path, path.exit);
            cost = cost + HEIGHTS_READ;
            if (last <= 0.0) {
                return entered_once(path, grid, start, path.exit, near_gap, last, cost);
            }
            return SearchResult(FOUND_MISS, start, path.exit, 0.0, 0.0, cost);
        }
        cell = cell_after(grid, cell, leave, forward, next);
        t = next;
    }
    return SearchResult(FOUND_EXHAUSTED, t, path.exit, 0.0, 0.0, cost);
}"#,
    },
    Declaration {
        module: "search/shell_map",
        name: "BEYOND_TILE",
        sampling: None,
        uses: &[],
        text: r#"// Tiles by which a hit may lie beyond the end of its tile. Smaller, and rounding loses hits at the edges of
// tiles far from the first; larger, and the order of two hits that are nearer to each other may change.
const BEYOND_TILE = 0.00002;"#,
    },
    Declaration {
        module: "search/shell_map",
        name: "search_shell_map",
        sampling: None,
        uses: &["BEYOND_TILE", "FOUND_BRACKET", "FOUND_EXHAUSTED", "FOUND_MISS", "NEVER", "NO_COST", "Path", "SearchResult", "first_of_motif", "motif_ray", "path_height", "path_uv"],
        text: r#"fn search_shell_map(path: Path, params: vec4f) -> SearchResult {
    let step = vec3f(path.duv, path.h.y);
    let slack = BEYOND_TILE / max(max(abs(step.x), abs(step.y)), abs(step.z));
    let limit = u32(params.x);
    var cost = NO_COST;
    var tile = floor(path.uv);
    var t = 0.0;
    while (cost.y < limit) {
        let ahead = tile + select(vec2f(0.0, 0.0), vec2f(1.0, 1.0), path.duv > vec2f(0.0, 0.0));
        let beside = (ahead - path.uv) / path.duv;
        let leave = select(vec2f(NEVER, NEVER), beside, abs(path.duv) > vec2f(0.0, 0.0));
        let end = max(min(min(leave.x, leave.y), path.exit), t);
        let ray = motif_ray(vec3f(path_uv(path, t) - tile, path_height(path, t)), step);
        let found = first_of_motif(ray, 0.0 - slack, end - t + slack, cost, limit);
        cost = found.cost;
        if (found.t < NEVER) {
            let at = clamp(t + found.t, 0.0, path.exit);
            return SearchResult(FOUND_BRACKET, at, at, 0.0, 0.0, cost);
        }
        if (!(end < path.exit)) {
            return SearchResult(FOUND_MISS, end, end, 1.0, 1.0, cost);
        }
        let next = select(vec2f(-1.0, -1.0), vec2f(1.0, 1.0), path.duv > vec2f(0.0, 0.0));
        if (leave.x <= leave.y) {
            tile.x = tile.x + next.x;
        } else {
            tile.y = tile.y + next.y;
        }
        t = end;
    }
    return SearchResult(FOUND_EXHAUSTED, t, t, 1.0, 1.0, cost);
}"#,
    },
    Declaration {
        module: "search/sphere",
        name: "distance_at",
        sampling: None,
        uses: &["Path", "search_texel_between"],
        text: r#"// The distance field at texture coordinates and a height. Two reads.
fn distance_at(path: Path, uv: vec2f, height: f32, slices: f32) -> f32 {
    let place = clamp(height * slices - 0.5, 0.0, slices - 1.0);
    let below = floor(place);
    let lower = search_texel_between(path, uv, i32(below)).x;
    let upper = search_texel_between(path, uv, i32(min(below + 1.0, slices - 1.0))).x;
    return lower + (upper - lower) * (place - below);
}"#,
    },
    Declaration {
        module: "search/sphere",
        name: "search_sphere",
        sampling: None,
        uses: &["FOUND_ABOVE", "FOUND_EXHAUSTED", "FOUND_MISS", "HEIGHTS_READ", "NO_COST", "Path", "ROUNDING", "STEP", "SearchResult", "cell_after", "cell_leave", "cell_of", "distance_at", "falls_in_cell", "found_in_cell", "gap_to", "grid_of", "height_cell", "map_read", "path_height", "path_slope", "path_uv", "whole_cell"],
        text: r#"fn search_sphere(path: Path, params: vec4f) -> SearchResult {
    let grid = grid_of(path);
    let forward = grid.step >= vec2f(0.0, 0.0);
    // A bent path is fastest at one of its ends.
    let climb = max(abs(path_slope(path, 0.0)), abs(path_slope(path, path.exit)));
    let fastest = length(vec3f(path.duv, climb));
    let speed = fastest + ROUNDING * fastest;
    // The rounding error of the path's places, in texture units and heights.
    let far = abs(path.uv) + abs(path.duv) * path.exit;
    let height_terms = abs(path.h.x) + path.exit * (abs(path.h.y) + path.exit * abs(path.h.z));
    let lost = ROUNDING * (far.x + far.y + height_terms + 1.0);
    var cell = cell_of(grid.origin);
    var t = 0.0;
    var cost = NO_COST;
    let limit = u32(params.x);
    while (cost.x < limit) {
        cost = cost + STEP;
        let leave = cell_leave(grid, cell);
        let end = min(min(leave.x, leave.y), path.exit);
        let span = max(end - t, 0.0);
        let free = distance_at(path, path_uv(path, t), path_height(path, t), params.z) - lost;
        cost = cost + map_read(path, 4u) + map_read(path, 4u);
        var next = t;
        if (free > 0.0) {
            next = t + free / speed;
        }
        if (params.y < 0.5) {
            if (!(next - t > ROUNDING * path.exit)) {
                return SearchResult(FOUND_ABOVE, t, path.exit, 0.0, 0.0, cost);
            }
        } else if (next < end || !(end > t)) {
            cost = cost + HEIGHTS_READ;
            let c = gap_to(path, grid, cell, height_cell(whole_cell(cell), path.level), t);
            if (falls_in_cell(c, span)) {
                return found_in_cell(c, t, span, t == 0.0, cost);
            }
            next = max(t, end);
        }
        if (next >= path.exit) {
            return SearchResult(FOUND_MISS, t, path.exit, 0.0, 0.0, cost);
        }
        cell = cell_after(grid, cell, leave, forward, next);
        t = next;
    }
    return SearchResult(FOUND_EXHAUSTED, t, path.exit, 0.0, 0.0, cost);
}"#,
    },
    Declaration {
        module: "search/translucent",
        name: "search_translucent",
        sampling: None,
        uses: &["FOUND_ABOVE", "FOUND_EXHAUSTED", "FOUND_MISS", "NO_COST", "Path", "STEP", "SearchResult", "first_part", "map_read", "next_part", "turning_point", "voxel_path"],
        text: r#"fn search_translucent(path: Path, params: vec4f) -> SearchResult {
    let way = voxel_path(path);
    let turn = turning_point(way);
    let limit = u32(params.z);
    var part = first_part(path, way, turn);
    var cost = NO_COST;
    while (cost.y < limit) {
        cost = cost + STEP + map_read(path, 1u);
        if (part.empty < 0.0) {
            return SearchResult(FOUND_ABOVE, part.begin, part.begin, 0.0, 1.0, cost);
        }
        if (part.is_last == 1u) {
            return SearchResult(FOUND_MISS, part.end, part.end, 1.0, 1.0, cost);
        }
        part = next_part(path, way, turn, part);
    }
    return SearchResult(FOUND_EXHAUSTED, part.begin, part.begin, 1.0, 1.0, cost);
}"#,
    },
    Declaration {
        module: "search/view_dependent",
        name: "NOTHING_HIT",
        sampling: None,
        uses: &[],
        text: r#"// Ways from here on, as parts of the whole way, say that nothing is hit.
const NOTHING_HIT = 0.998;"#,
    },
    Declaration {
        module: "search/view_dependent",
        name: "search_view_dependent",
        sampling: None,
        uses: &["FOUND_MISS", "Path", "STEP", "SearchResult", "height_texels", "hit_on_way", "joined_way", "map_read", "no_views", "path_axes", "path_uv", "texels_around", "view_pair", "views_around", "ways_of_bend", "with_pair"],
        text: r#"fn search_view_dependent(path: Path, params: vec4f) -> SearchResult {
    let axes = path_axes(path, params.w);
    let views = views_around(axes, params);
    let cost = STEP + map_read(path, views.pairs * 8u);
    if (axes.comes_in == 0u) {
        return SearchResult(FOUND_MISS, path.exit, path.exit, 1.0, 1.0, STEP);
    }
    let around = texels_around(path_uv(path, axes.start), height_texels(path.level));
    var joined = no_views();
    var k = 0u;
    while (k < views.pairs) {
        let pair = view_pair(views, k);
        joined = with_pair(joined, views, k, ways_of_bend(path, around, pair.layer, pair.bend));
        k = k + 1u;
    }
    return hit_on_way(path, axes, joined_way(joined, views), cost);
}"#,
    },
    Declaration {
        module: "search/view_dependent",
        name: "ways_of_bend",
        sampling: None,
        uses: &["Around", "Path", "bilinear", "height_texels", "row_of_bend", "ways_of_texel"],
        text: r#"// Ways at a place for a layer and the next, each with the weight of its texels that are hits. Where
// nothing is hit both are 0.
fn ways_of_bend(path: Path, around: Around, layer: i32, bend: f32) -> vec4f {
    let rows = height_texels(path.level).y;
    let first = row_of_bend(around.rows.x, bend, rows);
    let second = row_of_bend(around.rows.y, bend, rows);
    return bilinear(
        ways_of_texel(path, vec2i(around.columns.x, first), layer),
        ways_of_texel(path, vec2i(around.columns.y, first), layer),
        ways_of_texel(path, vec2i(around.columns.x, second), layer),
        ways_of_texel(path, vec2i(around.columns.y, second), layer),
        around.part,
    );
}"#,
    },
    Declaration {
        module: "search/view_dependent",
        name: "ways_of_texel",
        sampling: None,
        uses: &["NOTHING_HIT", "Path", "search_texel"],
        text: r#"fn ways_of_texel(path: Path, texel: vec2i, layer: i32) -> vec4f {
    let level = i32(path.level);
    let below = search_texel(path, texel, layer, level).x;
    let above = search_texel(path, texel, layer + 1, level).x;
    let is_below = below < NOTHING_HIT;
    let is_above = above < NOTHING_HIT;
    return vec4f(
        select(0.0, below, is_below),
        select(0.0, 1.0, is_below),
        select(0.0, above, is_above),
        select(0.0, 1.0, is_above),
    );
}"#,
    },
    Declaration {
        module: "search/view_dependent_clusters",
        name: "search_view_dependent_clusters",
        sampling: None,
        uses: &["FOUND_MISS", "Path", "STEP", "SearchResult", "clustered_ways", "height_texels", "hit_on_way", "joined_way", "no_views", "path_axes", "path_uv", "search_layers", "texel_reads", "texels_around", "view_pair", "views_around", "with_pair"],
        text: r#"fn search_view_dependent_clusters(path: Path, params: vec4f) -> SearchResult {
    let axes = path_axes(path, params.w);
    if (axes.comes_in == 0u) {
        return SearchResult(FOUND_MISS, path.exit, path.exit, 1.0, 1.0, STEP);
    }
    let views = views_around(axes, params);
    let around = texels_around(path_uv(path, axes.start), height_texels(path.level));
    let layers = search_layers(path);
    var joined = no_views();
    var k = 0u;
    while (k < views.pairs) {
        let ways = clustered_ways(path, around, view_pair(views, k), params, layers);
        joined = with_pair(joined, views, k, ways);
        k = k + 1u;
    }
    // For each pair and texel its cluster; its factors, two views and a scale in two texels, layer by layer.
    let cost = STEP + texel_reads(path, views.pairs * 4u * (1u + (layers - 1u) * 5u));
    return hit_on_way(path, axes, joined_way(joined, views), cost);
}"#,
    },
    Declaration {
        module: "search/view_dependent_clusters",
        name: "clustered_ways",
        sampling: None,
        uses: &["Around", "Path", "ViewPair", "clustered_way", "joined_texels"],
        text: r#"// Ways at a place for a pair of views, each with its weight.
fn clustered_ways(path: Path, around: Around, pair: ViewPair, params: vec4f, layers: u32) -> vec4f {
    let t00 = clustered_way(path, vec2i(around.columns.x, around.rows.x), pair, params, layers);
    let t10 = clustered_way(path, vec2i(around.columns.y, around.rows.x), pair, params, layers);
    let t01 = clustered_way(path, vec2i(around.columns.x, around.rows.y), pair, params, layers);
    let t11 = clustered_way(path, vec2i(around.columns.y, around.rows.y), pair, params, layers);
    return joined_texels(vec4f(t00.x, t10.x, t01.x, t11.x), vec4f(t00.y, t10.y, t01.y, t11.y), around.part);
}"#,
    },
    Declaration {
        module: "search/view_dependent_clusters",
        name: "clustered_way",
        sampling: None,
        uses: &["Path", "ViewPair", "factor_place", "height_texels", "search_texel", "term_scales"],
        text: r#"// A texel's sums for a pair of views, by the factors of its cluster.
fn clustered_way(path: Path, texel: vec2i, pair: ViewPair, params: vec4f, layers: u32) -> vec2f {
    let n = height_texels(path.level);
    let level = i32(path.level);
    let bends = i32(params.z);
    let count = i32(params.x * params.y) * bends;
    let cluster = i32(floor(search_texel(path, texel, 0, level).x * 255.0 + 0.5));
    let first = cluster * (count + 2);
    let lower_view = first + pair.layer * bends + i32(pair.bend);
    let of_lower = factor_place(lower_view, n);
    let of_upper = factor_place(lower_view + bends, n);
    var both = vec2f(0.0, 0.0);
    var layer = 1;
    while (layer < i32(layers)) {
        let scaled = search_texel(path, texel, layer, level) * term_scales(path, first + count, n, layer);
        let lower = search_texel(path, of_lower, layer, level);
        let upper = search_texel(path, of_upper, layer, level);
        // One by one, as in `with_terms`.
        both = both + vec2f(lower.x, upper.x) * scaled.x;
        both = both + vec2f(lower.y, upper.y) * scaled.y;
        both = both + vec2f(lower.z, upper.z) * scaled.z;
        both = both + vec2f(lower.w, upper.w) * scaled.w;
        layer = layer + 1;
    }
    return both;
}"#,
    },
    Declaration {
        module: "search/view_dependent_free",
        name: "search_view_dependent_free",
        sampling: None,
        uses: &["FOUND_ABOVE", "Path", "ROUNDING", "STEP", "SearchResult", "cell_of", "free_way_of_step", "height_size", "is_in_footprint", "map_read", "path_axes", "whole_cell"],
        text: r#"fn search_view_dependent_free(path: Path, params: vec4f) -> SearchResult {
    let axes = path_axes(path, params.w);
    let place = path.uv * height_size(path.level);
    let square = cell_of(place);
    let inside = place - square;
    let near = min(min(inside.x, 1.0 - inside.x), min(inside.y, 1.0 - inside.y));
    let rounded = ROUNDING * (max(abs(place.x), abs(place.y)) + 1.0);
    let is_in_map = is_in_footprint(square, height_size(path.level));
    let is_known = path.h.x == 1.0 && axes.comes_in == 1u && near > rounded && is_in_map;
    if (!is_known || (params.z == 1.0 && path.h.z != 0.0)) {
        return SearchResult(FOUND_ABOVE, 0.0, path.exit, 0.0, 1.0, STEP);
    }
    let free = free_way_of_step(path, axes, whole_cell(square), params) / axes.fall;
    return SearchResult(FOUND_ABOVE, min(free, path.exit), path.exit, 0.0, 1.0, STEP + map_read(path, 1u));
}"#,
    },
    Declaration {
        module: "search/view_dependent_free",
        name: "is_in_footprint",
        sampling: None,
        uses: &["WRAP_CLAMP", "surface_settings"],
        text: r#"// Whether a square has an image in the map that the wrap takes to it.
fn is_in_footprint(square: vec2f, size: vec2f) -> bool {
    let holds_square = square.x >= 0.0 && square.y >= 0.0 && square.x < size.x && square.y < size.y;
    return holds_square || surface_settings.wrap != WRAP_CLAMP;
}"#,
    },
    Declaration {
        module: "search/view_dependent_free",
        name: "free_way_of_step",
        sampling: None,
        uses: &["Path", "PathAxes", "height_texels", "longest_of_step", "row_of_bend", "search_texel", "step_of_axis", "wrap_index"],
        text: r#"// The free way F of all paths that come in over a texel's square, by the steps of their axes.
fn free_way_of_step(path: Path, axes: PathAxes, square: vec2i, params: vec4f) -> f32 {
    let n = height_texels(path.level);
    let azimuth = step_of_axis(axes.turn, params.x);
    let elevation = step_of_axis(axes.elevation, params.y);
    let bend = step_of_axis(axes.bend, params.z);
    let row = row_of_bend(wrap_index(square.y, n.y), bend, n.y);
    let at = vec2i(wrap_index(square.x, n.x), row);
    let part = search_texel(path, at, i32(azimuth * params.y + elevation), i32(path.level)).x;
    return part * longest_of_step(bend, params.z);
}"#,
    },
    Declaration {
        module: "search/view_dependent_svd",
        name: "search_view_dependent_svd",
        sampling: None,
        uses: &["FOUND_MISS", "Path", "STEP", "SearchResult", "height_texels", "hit_on_way", "joined_way", "no_views", "path_axes", "path_uv", "search_layers", "summed_ways", "texel_reads", "texels_around", "view_pair", "views_around", "with_pair"],
        text: r#"fn search_view_dependent_svd(path: Path, params: vec4f) -> SearchResult {
    let axes = path_axes(path, params.w);
    if (axes.comes_in == 0u) {
        return SearchResult(FOUND_MISS, path.exit, path.exit, 1.0, 1.0, STEP);
    }
    let views = views_around(axes, params);
    let around = texels_around(path_uv(path, axes.start), height_texels(path.level));
    let layers = search_layers(path);
    var joined = no_views();
    var k = 0u;
    while (k < views.pairs) {
        let ways = summed_ways(path, around, view_pair(views, k), params, layers);
        joined = with_pair(joined, views, k, ways);
        k = k + 1u;
    }
    // Four texels, two views and a scale in two texels, for each pair and layer.
    let cost = STEP + texel_reads(path, views.pairs * layers * 8u);
    return hit_on_way(path, axes, joined_way(joined, views), cost);
}"#,
    },
    Declaration {
        module: "search/view_dependent_svd",
        name: "summed_ways",
        sampling: None,
        uses: &["Around", "Path", "ViewPair", "factor_place", "four_terms", "height_texels", "joined_texels", "signed_factors", "term_scales", "with_terms"],
        text: r#"// Ways at a place for a pair of views, each with its weight.
fn summed_ways(path: Path, around: Around, pair: ViewPair, params: vec4f, layers: u32) -> vec4f {
    let n = height_texels(path.level);
    let level = i32(path.level);
    let bends = i32(params.z);
    let lower_view = pair.layer * bends + i32(pair.bend);
    let of_lower = factor_place(lower_view, n);
    let of_upper = factor_place(lower_view + bends, n);
    let scale_number = i32(params.x * params.y) * bends;
    var lower = vec4f(0.0, 0.0, 0.0, 0.0);
    var upper = vec4f(0.0, 0.0, 0.0, 0.0);
    var layer = 0;
    while (layer < i32(layers)) {
        let scales = term_scales(path, scale_number, n, layer);
        let a = signed_factors(path, of_lower, layer, level) * scales;
        let b = signed_factors(path, of_upper, layer, level) * scales;
        let texels = four_terms(
            signed_factors(path, vec2i(around.columns.x, around.rows.x), layer, level),
            signed_factors(path, vec2i(around.columns.y, around.rows.x), layer, level),
            signed_factors(path, vec2i(around.columns.x, around.rows.y), layer, level),
            signed_factors(path, vec2i(around.columns.y, around.rows.y), layer, level),
        );
        lower = with_terms(lower, texels, a);
        upper = with_terms(upper, texels, b);
        layer = layer + 1;
    }
    return joined_texels(lower, upper, around.part);
}"#,
    },
    Declaration {
        module: "search/view_dependent_svd",
        name: "signed_factors",
        sampling: None,
        uses: &["Path", "search_texel"],
        text: r#"// Factors of both signs, which are stored from 0 to 1.
fn signed_factors(path: Path, texel: vec2i, layer: i32, level: i32) -> vec4f {
    return 2.0 * search_texel(path, texel, layer, level) - vec4f(1.0, 1.0, 1.0, 1.0);
}"#,
    },
    Declaration {
        module: "search/voxels",
        name: "search_voxels",
        sampling: None,
        uses: &["FOUND_BRACKET", "FOUND_EXHAUSTED", "FOUND_MISS", "FOUND_STARTED_BELOW", "NEVER", "NO_COST", "Path", "STEP", "SearchResult", "VOXELS_READ", "map_read", "next_voxel_cell", "rises_on", "root_in_voxel_cell", "search_texel", "turning_point", "voxel_cell_at", "voxel_leave", "voxel_path", "voxel_place_on", "voxel_texel"],
        text: r#"fn search_voxels(path: Path, params: vec4f) -> SearchResult {
    let way = voxel_path(path);
    let turn = turning_point(way);
    var has_turned = false;
    var t = 0.0;
    var cell = floor(voxel_place_on(way, t));
    var cost = NO_COST;
    let limit = u32(params.x);
    while (cost.y < limit) {
        let empty = search_texel(path, voxel_texel(vec3i(cell)), 0, 0).x;
        cost = cost + STEP + map_read(path, 1u);
        // In all cells of this box the field stays below the surface, unless the cell itself may reach it.
        let reach = max(empty - 1.0, 0.0);
        let end_of_part = select(min(turn, path.exit), path.exit, has_turned);
        let leave = voxel_leave(way, cell, reach, has_turned);
        let side = min(min(leave.x, leave.y), leave.z);
        let end = max(min(side, end_of_part), t);
        if (empty < 0.5) {
            cost = cost + VOXELS_READ;
            let found = root_in_voxel_cell(way, cell, t, end - t);
            if (found.root < NEVER) {
                let begins_inside = found.gap < 0.0 && t == 0.0;
                let status = select(FOUND_BRACKET, FOUND_STARTED_BELOW, begins_inside);
                let far = t + found.root * (end - t);
                return SearchResult(status, t, far, found.gap, min(found.gap, 0.0), cost);
            }
        }
        if (end >= path.exit) {
            return SearchResult(FOUND_MISS, end, end, 1.0, 1.0, cost);
        }
        if (side > end_of_part) {
            has_turned = true;
            cell = voxel_cell_at(way, cell, reach, end);
        } else {
            cell = next_voxel_cell(way, cell, reach, leave, rises_on(way, has_turned), end);
        }
        t = end;
    }
    return SearchResult(FOUND_EXHAUSTED, t, t, 1.0, 1.0, cost);
}"#,
    },
    Declaration {
        module: "refine/binary",
        name: "refine_binary",
        sampling: None,
        uses: &["FLOOR", "FOUND_BRACKET", "Hit", "Path", "STEP", "SearchResult", "field_cost_stage", "has_interval", "hit_on_path", "miss", "path_gap", "path_height", "refine_none"],
        text: r#"fn refine_binary(path: Path, found: SearchResult, params: vec4f) -> Hit {
    if (!has_interval(found)) {
        return refine_none(path, found, params);
    }
    var near = found.near;
    var far = found.far;
    var cost = found.cost;
    var crossed = found.status == FOUND_BRACKET || path_height(path, far) <= FLOOR;
    var k = 0.0;
    while (k < params.x) {
        cost = cost + STEP;
        let middle = 0.5 * (near + far);
        cost = cost + field_cost_stage(path.level);
        if (path_gap(path, middle) <= 0.0) {
            far = middle;
            crossed = true;
        } else {
            near = middle;
        }
        k = k + 1.0;
    }
    if (!crossed) {
        return miss(cost);
    }
    return hit_on_path(path, 0.5 * (near + far), 0u, cost);
}"#,
    },
    Declaration {
        module: "refine/half_texel",
        name: "refine_half_texel",
        sampling: None,
        uses: &["FOUND_BELOW", "HEIGHTS_READ", "Hit", "Path", "SearchResult", "height_size", "hit_on_path", "path_gap", "refine_none"],
        text: r#"fn refine_half_texel(path: Path, found: SearchResult, params: vec4f) -> Hit {
    if (found.status != FOUND_BELOW) {
        return refine_none(path, found, params);
    }
    let speed = length(path.duv * height_size(path.level));
    // A path along the normal stays over one place.
    if (!(speed * path.exit > 0.5)) {
        return refine_none(path, found, params);
    }
    let half = 0.5 / speed;
    let backward = max(found.far - half, 0.0);
    let forward = min(found.far + half, path.exit);
    let before = abs(path_gap(path, backward));
    let behind = abs(path_gap(path, forward));
    var part = 0.5;
    if (before + behind > 0.0) {
        part = before / (before + behind);
    }
    let cost = found.cost + HEIGHTS_READ + HEIGHTS_READ;
    return hit_on_path(path, backward + (forward - backward) * part, 0u, cost);
}"#,
    },
    Declaration {
        module: "refine/none",
        name: "refine_none",
        sampling: None,
        uses: &["FOUND_EXHAUSTED", "FOUND_MISS", "Hit", "Path", "SearchResult", "hit_on_path", "miss", "starting_point"],
        text: r#"fn refine_none(path: Path, found: SearchResult, params: vec4f) -> Hit {
    if (found.status == FOUND_MISS) {
        return miss(found.cost);
    }
    let exhausted = select(0u, 1u, found.status == FOUND_EXHAUSTED);
    return hit_on_path(path, starting_point(path, found), exhausted, found.cost);
}"#,
    },
    Declaration {
        module: "refine/offset",
        name: "refine_offset",
        sampling: None,
        uses: &["FOUND_EXHAUSTED", "FOUND_MISS", "HEIGHTS_READ", "Hit", "Path", "SearchResult", "height_at", "hit_on_path", "miss", "path_height", "path_slope", "path_uv", "starting_point"],
        text: r#"fn refine_offset(path: Path, found: SearchResult, params: vec4f) -> Hit {
    if (found.status == FOUND_MISS) {
        return miss(found.cost);
    }
    let start = starting_point(path, found);
    let level = height_at(path_uv(path, start), path.level);
    let slope = path_slope(path, start);
    var t = start;
    if (slope != 0.0) {
        t = start + (level - path_height(path, start)) / slope;
    }
    return hit_on_path(path, t, select(0u, 1u, found.status == FOUND_EXHAUSTED), found.cost + HEIGHTS_READ);
}"#,
    },
    Declaration {
        module: "refine/offset_limited",
        name: "refine_offset_limited",
        sampling: None,
        uses: &["FOUND_EXHAUSTED", "FOUND_MISS", "HEIGHTS_READ", "Hit", "Path", "SearchResult", "height_at", "hit_on_path", "miss", "path_height", "path_uv", "starting_point"],
        text: r#"fn refine_offset_limited(path: Path, found: SearchResult, params: vec4f) -> Hit {
    if (found.status == FOUND_MISS) {
        return miss(found.cost);
    }
    let start = starting_point(path, found);
    let level = height_at(path_uv(path, start), path.level);
    // Metres above the starting point, moved as many metres along the view ray.
    let rise_m = (level - path_height(path, start)) * path.metric.w;
    let exhausted = select(0u, 1u, found.status == FOUND_EXHAUSTED);
    var hit = hit_on_path(path, start - rise_m, exhausted, found.cost + HEIGHTS_READ);
    if (hit.found == 1u) {
        hit.height = level;
    }
    return hit;
}"#,
    },
    Declaration {
        module: "refine/patch",
        name: "refine_patch",
        sampling: None,
        uses: &["FOUND_BELOW", "FOUND_BRACKET", "FOUND_EXHAUSTED", "FOUND_MISS", "FOUND_STARTED_BELOW", "HEIGHTS_READ", "Hit", "NEVER", "Path", "STEP", "SearchResult", "cell_gap", "cell_leave", "cell_next", "cell_of", "first_root", "grid_of", "hit_on_path", "miss"],
        text: r#"fn refine_patch(path: Path, found: SearchResult, params: vec4f) -> Hit {
    if (found.status == FOUND_MISS) {
        return miss(found.cost);
    }
    if (found.status == FOUND_EXHAUSTED) {
        return hit_on_path(path, found.near, 1u, found.cost);
    }
    if (found.status == FOUND_STARTED_BELOW) {
        return hit_on_path(path, found.near, 0u, found.cost);
    }
    let grid = grid_of(path);
    var t = found.near;
    var cell = cell_of(grid.origin + grid.step * t);
    var cost = found.cost;
    let limit = cost.x + u32(params.x);
    while (cost.x < limit) {
        cost = cost + STEP;
        let leave = cell_leave(grid, cell);
        let end = min(min(leave.x, leave.y), found.far);
        let span = max(end - t, 0.0);
        let c = cell_gap(path, grid, cell, t);
        cost = cost + HEIGHTS_READ;
        if (c.x <= 0.0) {
            return hit_on_path(path, t, 0u, cost);
        }
        let s = first_root(c, span);
        if (s < NEVER) {
            return hit_on_path(path, t + s, 0u, cost);
        }
        if (end >= found.far) {
            if (found.status == FOUND_BRACKET || found.status == FOUND_BELOW) {
                // The search saw the far end below; here it touches zero from above, to rounding.
                return hit_on_path(path, found.far, 0u, cost);
            }
            return miss(cost);
        }
        cell = cell_next(grid, cell, leave);
        t = max(t, end);
    }
    return hit_on_path(path, t, 1u, cost);
}"#,
    },
    Declaration {
        module: "refine/secant",
        name: "refine_secant",
        sampling: None,
        uses: &["FOUND_BRACKET", "Hit", "Path", "STEP", "SearchResult", "field_cost_stage", "has_interval", "hit_on_path", "miss", "path_gap", "refine_none"],
        text: r#"fn refine_secant(path: Path, found: SearchResult, params: vec4f) -> Hit {
    if (!has_interval(found)) {
        return refine_none(path, found, params);
    }
    var near = found.near;
    var far = found.far;
    var near_gap = found.near_gap;
    var far_gap = found.far_gap;
    var cost = found.cost;
    if (found.status != FOUND_BRACKET) {
        near_gap = path_gap(path, near);
        far_gap = path_gap(path, far);
        cost = cost + field_cost_stage(path.level) + field_cost_stage(path.level);
        if (far_gap > 0.0) {
            return miss(cost);
        }
    }
    var t = far;
    var k = 1.0;
    while (k <= params.x) {
        cost = cost + STEP;
        let drop = near_gap - far_gap;
        if (!(drop > 0.0)) {
            break;
        }
        t = near + (far - near) * (near_gap / drop);
        if (k < params.x) {
            let gap = path_gap(path, t);
            cost = cost + field_cost_stage(path.level);
            if (gap <= 0.0) {
                far = t;
                far_gap = gap;
            } else {
                near = t;
                near_gap = gap;
            }
        }
        k = k + 1.0;
    }
    return hit_on_path(path, t, 0u, cost);
}"#,
    },
    Declaration {
        module: "refine/slope",
        name: "refine_slope",
        sampling: None,
        uses: &["FOUND_EXHAUSTED", "FOUND_MISS", "HEIGHTS_READ", "Hit", "Path", "SearchResult", "height_and_slope", "hit_on_path", "miss", "normal_z", "path_height", "path_slope", "path_uv", "starting_point"],
        text: r#"fn refine_slope(path: Path, found: SearchResult, params: vec4f) -> Hit {
    if (found.status == FOUND_MISS) {
        return miss(found.cost);
    }
    let start = starting_point(path, found);
    let plane = height_and_slope(path_uv(path, start), path.level);
    let rise = plane.x - path_height(path, start);
    var t = start;
    if (params.x > 0.5) {
        let closing = path_slope(path, start) - (plane.y * path.duv.x + plane.z * path.duv.y);
        if (closing < 0.0) {
            t = start + rise / closing;
        }
    } else {
        t = start - rise * path.metric.w * normal_z(path, vec2f(plane.y, plane.z));
    }
    return hit_on_path(path, t, select(0u, 1u, found.status == FOUND_EXHAUSTED), found.cost + HEIGHTS_READ);
}"#,
    },
    Declaration {
        module: "refine/slope_iterative",
        name: "refine_slope_iterative",
        sampling: None,
        uses: &["FOUND_EXHAUSTED", "FOUND_MISS", "HEIGHTS_READ", "Hit", "Path", "STEP", "SearchResult", "height_and_slope", "hit_on_path", "miss", "normal_z", "path_height", "path_slope", "path_uv", "starting_point"],
        text: r#"fn refine_slope_iterative(path: Path, found: SearchResult, params: vec4f) -> Hit {
    if (found.status == FOUND_MISS) {
        return miss(found.cost);
    }
    var t = starting_point(path, found);
    var cost = found.cost;
    var k = 0.0;
    while (k < params.x) {
        cost = cost + STEP;
        let plane = height_and_slope(path_uv(path, t), path.level);
        cost = cost + HEIGHTS_READ;
        let rise = plane.x - path_height(path, t);
        if (params.y > 0.5) {
            let closing = path_slope(path, t) - (plane.y * path.duv.x + plane.z * path.duv.y);
            if (closing < 0.0) {
                t = t + rise / closing;
            }
        } else {
            t = t - rise * path.metric.w * normal_z(path, vec2f(plane.y, plane.z));
        }
        t = clamp(t, 0.0, path.exit);
        k = k + 1.0;
    }
    return hit_on_path(path, t, select(0u, 1u, found.status == FOUND_EXHAUSTED), cost);
}"#,
    },
    Declaration {
        module: "refine/trilinear",
        name: "refine_trilinear",
        sampling: None,
        uses: &["FOUND_BRACKET", "FOUND_EXHAUSTED", "Hit", "Path", "SearchResult", "first_root_on_path", "has_interval", "hit_on_path", "miss", "refine_none"],
        text: r#"fn refine_trilinear(path: Path, found: SearchResult, params: vec4f) -> Hit {
    if (!has_interval(found)) {
        return refine_none(path, found, params);
    }
    let root = first_root_on_path(path, found.near, found.far, u32(params.x));
    let cost = found.cost + root.cost;
    if (root.status == FOUND_BRACKET) {
        return hit_on_path(path, root.far, 0u, cost);
    }
    if (found.status == FOUND_BRACKET) {
        // By rounding the root lies at the far end.
        return hit_on_path(path, found.far, select(0u, 1u, root.status == FOUND_EXHAUSTED), cost);
    }
    return miss(cost);
}"#,
    },
    Declaration {
        module: "refine/trilinear",
        name: "first_root_on_path",
        sampling: None,
        uses: &["FOUND_BRACKET", "FOUND_EXHAUSTED", "FOUND_MISS", "NEVER", "NO_COST", "Path", "STEP", "SearchResult", "VOXELS_READ", "next_voxel_cell", "rises_on", "root_in_voxel_cell", "turning_point", "voxel_leave", "voxel_path", "voxel_place_on"],
        text: r#"// The first root on a path from one parameter to another, as the far end of a bracket. Every cell is visited.
fn first_root_on_path(path: Path, from_t: f32, to_t: f32, limit: u32) -> SearchResult {
    let way = voxel_path(path);
    let turn = turning_point(way);
    var has_turned = from_t >= turn;
    var t = from_t;
    var cell = floor(voxel_place_on(way, t));
    var cost = NO_COST;
    while (cost.y < limit) {
        cost = cost + STEP + VOXELS_READ;
        let end_of_part = select(min(turn, to_t), to_t, has_turned);
        let leave = voxel_leave(way, cell, 0.0, has_turned);
        let side = min(min(leave.x, leave.y), leave.z);
        let end = max(min(side, end_of_part), t);
        let found = root_in_voxel_cell(way, cell, t, end - t);
        if (found.root < NEVER) {
            return SearchResult(FOUND_BRACKET, t, t + found.root * (end - t), found.gap, 0.0, cost);
        }
        if (end >= to_t) {
            return SearchResult(FOUND_MISS, end, end, 1.0, 1.0, cost);
        }
        if (side > end_of_part) {
            has_turned = true;
        } else {
            cell = next_voxel_cell(way, cell, 0.0, leave, rises_on(way, has_turned), end);
        }
        t = end;
    }
    return SearchResult(FOUND_EXHAUSTED, t, t, 1.0, 1.0, cost);
}"#,
    },
    Declaration {
        module: "refine/true_secant",
        name: "refine_true_secant",
        sampling: None,
        uses: &["FOUND_BRACKET", "Hit", "Path", "STEP", "SearchResult", "field_cost_stage", "has_interval", "hit_on_path", "miss", "path_gap", "refine_none"],
        text: r#"fn refine_true_secant(path: Path, found: SearchResult, params: vec4f) -> Hit {
    if (!has_interval(found)) {
        return refine_none(path, found, params);
    }
    var before = found.near;
    var last = found.far;
    var before_gap = found.near_gap;
    var last_gap = found.far_gap;
    var cost = found.cost;
    if (found.status != FOUND_BRACKET) {
        before_gap = path_gap(path, before);
        last_gap = path_gap(path, last);
        cost = cost + field_cost_stage(path.level) + field_cost_stage(path.level);
        if (last_gap > 0.0) {
            return miss(cost);
        }
    }
    var k = 1.0;
    while (k <= params.x) {
        cost = cost + STEP;
        let change = before_gap - last_gap;
        if (change == 0.0) {
            break;
        }
        let t = clamp(last + (last - before) * (last_gap / change), found.near, found.far);
        before = last;
        before_gap = last_gap;
        last = t;
        if (k < params.x) {
            last_gap = path_gap(path, t);
            cost = cost + field_cost_stage(path.level);
        }
        k = k + 1.0;
    }
    return hit_on_path(path, last, 0u, cost);
}"#,
    },
    Declaration {
        module: "shade/blinn_phong",
        name: "LOBE",
        sampling: None,
        uses: &[],
        text: r#"// The number that is added to an exponent so that lobes in proportion to the sum reflect the same
// light.
const LOBE = 8.0;"#,
    },
    Declaration {
        module: "shade/blinn_phong",
        name: "whole_power",
        sampling: None,
        uses: &[],
        text: r#"fn whole_power(base: f32, exponent: u32) -> f32 {
    var result = 1.0;
    var square = base;
    var rest = exponent;
    while (rest > 0u) {
        if ((rest & 1u) == 1u) {
            result = result * square;
        }
        square = square * square;
        rest = rest >> 1u;
    }
    return result;
}"#,
    },
    Declaration {
        module: "shade/blinn_phong",
        name: "shade_blinn_phong_material",
        sampling: None,
        uses: &["Entered", "Hit", "Material", "surface_settings"],
        text: r#"fn shade_blinn_phong_material(
    at: Entered,
    hit: Hit,
    normal: vec3f,
    mean: f32,
    view: vec3f,
    color: vec3f,
    params: vec4f,
) -> Material {
    let transmission = surface_settings.transmission;
    // Refracted light is not scattered.
    let diffuse = surface_settings.diffuse.xyz * color * (1.0 - transmission);
    let none = vec3f(0.0, 0.0, 0.0);
    let transmitted = vec3f(transmission, transmission, transmission);
    let specular = surface_settings.specular.xyz;
    return Material(diffuse, transmitted, specular, diffuse, none, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
}"#,
    },
    Declaration {
        module: "shade/blinn_phong",
        name: "shade_blinn_phong_light",
        sampling: None,
        uses: &["LOBE", "Material", "surface_settings", "whole_power"],
        text: r#"fn shade_blinn_phong_light(
    material: Material,
    normal: vec3f,
    mean: f32,
    cosine: f32,
    view: vec3f,
    toward: vec3f,
    params: vec4f,
) -> vec3f {
    if (cosine > 0.0) {
        var exponent = surface_settings.shininess;
        var dimmed = 1.0;
        if (mean < 1.0) {
            let sharp = f32(surface_settings.shininess);
            let wide = max(floor(sharp * mean / (mean + sharp * (1.0 - mean))), 1.0);
            exponent = u32(wide);
            dimmed = (wide + LOBE) / (sharp + LOBE);
        }
        let lobe = max(dot(normal, normalize(toward + view)), 0.0);
        let specular = material.specular * (whole_power(lobe, exponent) * dimmed);
        return material.diffuse * cosine + specular;
    }
    return vec3f(0.0, 0.0, 0.0);
}"#,
    },
    Declaration {
        module: "shade/blinn_phong",
        name: "shade_blinn_phong_mirrored",
        sampling: None,
        uses: &["Material", "Mirrored", "fresnel", "surface_settings"],
        text: r#"// The deviation of facets follows from the highlight's exponent and from the normals in a footprint.
fn shade_blinn_phong_mirrored(material: Material, mean: f32, cosine: f32, params: vec4f) -> Mirrored {
    let part = fresnel(cosine);
    let lean = sqrt(2.0 / (f32(surface_settings.shininess) + 2.0) + 2.0 * max(1.0 - mean, 0.0));
    return Mirrored(vec3f(part, part, part), lean, vec2f(2.0 * lean, 2.0 * lean), 0.0, 0.0);
}"#,
    },
    Declaration {
        module: "shade/metallic_roughness",
        name: "LEAST_ROUGHNESS",
        sampling: None,
        uses: &[],
        text: r#"// The least roughness. Lobes of smoother facets are narrower than any light, and f32 cannot tell
// their directions apart.
const LEAST_ROUGHNESS = 0.045;"#,
    },
    Declaration {
        module: "shade/metallic_roughness",
        name: "LEAST_COSINE",
        sampling: None,
        uses: &[],
        text: r#"// The least cosine between a normal and the view. Normals between texels may face away.
const LEAST_COSINE = 0.0001;"#,
    },
    Declaration {
        module: "shade/metallic_roughness",
        name: "NARROW",
        sampling: None,
        uses: &[],
        text: r#"// Surroundings are looked up in two lobes, since one of facets has a long tail: the deviations of both
// over alpha, and the weight of the wide one. They are turned to the normal by the third power of the
// roughness, since rough facets reflect less light from near the horizon. Fitted to the integral.
const NARROW = 1.4;"#,
    },
    Declaration {
        module: "shade/metallic_roughness",
        name: "WIDE",
        sampling: None,
        uses: &[],
        text: r#"const WIDE = 5.6;"#,
    },
    Declaration {
        module: "shade/metallic_roughness",
        name: "WIDE_PART",
        sampling: None,
        uses: &[],
        text: r#"const WIDE_PART = 0.25;"#,
    },
    Declaration {
        module: "shade/metallic_roughness",
        name: "LEAST_SQUARED_SUM",
        sampling: None,
        uses: &[],
        text: r#"// The least squared length of the sum of two directions. They are opposite where it is 0.
const LEAST_SQUARED_SUM = 0.000001;"#,
    },
    Declaration {
        module: "shade/metallic_roughness",
        name: "reflected_by",
        sampling: None,
        uses: &[],
        text: r#"// The part of the light from all around that facets of that colour reflect once.
fn reflected_by(once: vec2f, specular: vec3f) -> vec3f {
    let least = vec3f(once.y, once.y, once.y);
    return least + specular * max(once.x - once.y, 0.0);
}"#,
    },
    Declaration {
        module: "shade/metallic_roughness",
        name: "shade_metallic_roughness_material",
        sampling: None,
        uses: &["Entered", "Hit", "LEAST_COSINE", "LEAST_ROUGHNESS", "Material", "emission_at", "facet_reflection", "occlusion_roughness_metalness", "reflected_by", "surface_settings"],
        text: r#"fn shade_metallic_roughness_material(
    at: Entered,
    hit: Hit,
    normal: vec3f,
    mean: f32,
    view: vec3f,
    color: vec3f,
    params: vec4f,
) -> Material {
    let maps = occlusion_roughness_metalness(hit.uv, at.footprint);
    var roughness = max(surface_settings.roughness * maps.y, LEAST_ROUGHNESS);
    let metallic = surface_settings.metallic * maps.z;
    let base = surface_settings.diffuse.xyz * color;
    let transmission = surface_settings.transmission;
    let diffuse = base * ((1.0 - metallic) * (1.0 - transmission));
    let transmitted = base * ((1.0 - metallic) * transmission);
    let dielectric = surface_settings.specular.xyz;
    // Limits that are never reached, here and below: compilers would add products in another order.
    let specular = dielectric + max(base - dielectric, vec3f(-1.0, -1.0, -1.0)) * metallic;
    // No root is taken of a square: compilers leave out both.
    var alpha = roughness * roughness;
    var squared_alpha = alpha * alpha;
    if (mean < 1.0) {
        squared_alpha = min(squared_alpha + 2.0 * (1.0 - mean) / mean, 1.0);
        alpha = sqrt(squared_alpha);
        roughness = sqrt(alpha);
    }
    let upright = max(dot(normal, view), LEAST_COSINE);
    let aside = max(1.0 - upright * upright, 0.0);
    let masking = sqrt(upright * upright + squared_alpha * aside);
    let once = facet_reflection(upright, alpha, roughness);
    let again = max(1.0 / once.x - 1.0, 0.0);
    let white = vec3f(1.0, 1.0, 1.0);
    let reflected = reflected_by(once, specular) * (white + specular * again);
    return Material(
        diffuse,
        transmitted,
        specular,
        reflected + diffuse * max(white - reflected, vec3f(0.0, 0.0, 0.0)),
        emission_at(hit.uv, at.footprint),
        maps.x,
        roughness,
        alpha,
        squared_alpha,
        upright,
        masking,
        again,
    );
}"#,
    },
    Declaration {
        module: "shade/metallic_roughness",
        name: "shade_metallic_roughness_light",
        sampling: None,
        uses: &["LEAST_SQUARED_SUM", "Material"],
        text: r#"fn shade_metallic_roughness_light(
    material: Material,
    normal: vec3f,
    mean: f32,
    cosine: f32,
    view: vec3f,
    toward: vec3f,
    params: vec4f,
) -> vec3f {
    if (cosine > 0.0) {
        // The half vector, not normalised. Its sine comes of the cross product: 1 less the squared
        // cosine has hardly a digit left where the lobe is narrow.
        let sum = toward + view;
        let squared_sum = max(dot(sum, sum), LEAST_SQUARED_SUM);
        let along = dot(normal, sum);
        let across = cross(normal, sum);
        let a = material.squared_alpha;
        let spread = (along * along * a + dot(across, across)) / squared_sum;
        let shadowing = sqrt(cosine * cosine + a * max(1.0 - cosine * cosine, 0.0));
        let visible = cosine * material.masking + material.upright * shadowing;
        let facets = 0.5 * a / (spread * spread * visible);
        // The cosine between both directions and the half vector is half the length of the sum.
        let rest = max(1.0 - 0.5 * sqrt(squared_sum), 0.0);
        let squared_rest = rest * rest;
        let white = vec3f(1.0, 1.0, 1.0);
        let more = max(white - material.specular, vec3f(0.0, 0.0, 0.0));
        let fresnel = material.specular + more * (squared_rest * squared_rest * rest);
        let specular = fresnel * (white + material.specular * material.again) * facets;
        return (material.diffuse * (white - fresnel) + specular) * cosine;
    }
    return vec3f(0.0, 0.0, 0.0);
}"#,
    },
    Declaration {
        module: "shade/metallic_roughness",
        name: "shade_metallic_roughness_mirrored",
        sampling: None,
        uses: &["Material", "Mirrored", "NARROW", "WIDE", "WIDE_PART", "facet_reflection", "reflected_by"],
        text: r#"fn shade_metallic_roughness_mirrored(
    material: Material,
    mean: f32,
    cosine: f32,
    params: vec4f,
) -> Mirrored {
    let white = vec3f(1.0, 1.0, 1.0);
    let once = facet_reflection(material.upright, material.alpha, material.roughness);
    let part = reflected_by(once, material.specular) * (white + material.specular * material.again);
    let alpha = material.alpha;
    let turn = alpha * material.roughness;
    return Mirrored(part, alpha, vec2f(NARROW * alpha, WIDE * alpha), WIDE_PART, turn);
}"#,
    },
    Declaration {
        module: "shadow/entry",
        name: "shadow_entry",
        sampling: None,
        uses: &["Entered", "Hit", "Path", "RAY_VIEW", "Toward", "base_height", "from_hit", "height_size", "path_height", "path_uv", "refine_stage", "search_stage", "way_out"],
        text: r#"fn shadow_entry(at: Entered, hit: Hit, light: Toward, params: vec4f) -> f32 {
    let up = from_hit(at, hit, light);
    if (!(up.h.y > 0.0)) {
        return 0.0;
    }
    let way = way_out(up, light);
    if (!(way > 0.0)) {
        return 1.0;
    }
    let top = path_height(up, way);
    let down = Path(
        path_uv(up, way),
        vec2f(0.0, 0.0) - up.duv,
        vec3f(top, 0.0 - up.h.y, 0.0),
        way,
        (top - base_height()) / up.h.y,
        up.metric,
        RAY_VIEW,
        up.level,
        0.0,
        1.0,
        0.0,
    );
    let end = refine_stage(down, search_stage(down));
    if (end.found == 0u) {
        return 1.0;
    }
    let apart = abs(end.uv - up.uv) * height_size(up.level);
    return select(0.0, 1.0, max(apart.x, apart.y) <= params.x);
}"#,
    },
    Declaration {
        module: "shadow/heuristic",
        name: "shadow_heuristic",
        sampling: None,
        uses: &["Entered", "Hit", "Toward", "from_hit", "path_gap", "way_out"],
        text: r#"fn shadow_heuristic(at: Entered, hit: Hit, light: Toward, params: vec4f) -> f32 {
    let path = from_hit(at, hit, light);
    if (!(path.h.y > 0.0)) {
        return 0.0;
    }
    let way = way_out(path, light);
    var most = 0.0;
    var k = 1.0;
    while (k < params.x) {
        let part = k / params.x;
        most = max(most, (0.0 - path_gap(path, part * way)) * (1.0 - part));
        k = k + 1.0;
    }
    return 1.0 - min(params.y * most, 1.0);
}"#,
    },
    Declaration {
        module: "shadow/horizon",
        name: "LEAST_SQUARED_COSINE",
        sampling: None,
        uses: &[],
        text: r#"// The square of the least cosine of a horizon: stored sines have no more bits to tell it from 0.
const LEAST_SQUARED_COSINE = 1.0e-7;"#,
    },
    Declaration {
        module: "shadow/horizon",
        name: "own_slope",
        sampling: None,
        uses: &["Path", "cell_leave", "cell_of", "gap_to", "grid_of", "height_cell"],
        text: r#"// The slope under which the surface of the hit's own cell is seen from the hit along a way, in
// heights per unit of the path's parameter. There the gap between a level ray and the surface has
// no constant: the hit is on the surface.
fn own_slope(way: Path) -> f32 {
    let grid = grid_of(way);
    let cell = cell_of(grid.origin);
    let leave = cell_leave(grid, cell);
    let end = max(min(leave.x, leave.y), 0.0);
    var level = way;
    level.h = vec3f(way.h.x, 0.0, 0.0);
    level.exit = end;
    let c = gap_to(level, grid, cell, height_cell(vec2i(cell), way.level), 0.0);
    return 0.0 - min(c.y, c.y + c.z * end);
}"#,
    },
    Declaration {
        module: "shadow/horizon",
        name: "shadow_horizon",
        sampling: None,
        uses: &["Entered", "Hit", "LEAST_SQUARED_COSINE", "SLOT_SHADOW", "Toward", "climb", "from_hit", "own_slope", "part_above", "shadow_texel_between", "surface_settings", "turn_of"],
        text: r#"// Nothing is divided by a square root, and no root is squared: compilers have other ways for these,
// which give other bits.
fn shadow_horizon(at: Entered, hit: Hit, light: Toward, params: vec4f) -> f32 {
    let change = climb(at, light.direction);
    let map = surface_settings.maps[SLOT_SHADOW];
    let along = change.xy * map.tile_m;
    let azimuth = turn_of(along) * params.x;
    let first = floor(azimuth);
    let count = i32(params.x);
    let before = i32(first) % count;
    let part = azimuth - first;
    let low = shadow_texel_between(hit.uv, before, at.level).x;
    let sine = low + (shadow_texel_between(hit.uv, (before + 1) % count, at.level).x - low) * part;
    // In metres, per metre of the light's ray: the rise of the horizon, and the rise of the ray.
    let squared = sine * sine / max((1.0 - sine) * (1.0 + sine), LEAST_SQUARED_COSINE);
    let far = sqrt(squared * dot(along, along));
    let near = own_slope(from_hit(at, hit, light)) * surface_settings.scale_m;
    let horizon = max(far, near);
    let up = dot(at.normal, light.direction);
    if (!(light.radius > 0.0)) {
        return select(0.0, 1.0, up > horizon);
    }
    // Tangent of the angle from the horizon up to the light's centre.
    let flat = max(1.0 - up * up, 0.0);
    let beside = flat + up * horizon;
    if (!(beside > 0.0)) {
        return select(0.0, 1.0, up > horizon);
    }
    return part_above(sqrt(flat) * (up - horizon) / (beside * light.radius));
}"#,
    },
    Declaration {
        module: "shadow/map",
        name: "shadow_map",
        sampling: None,
        uses: &["Entered", "Hit", "Toward", "light_seen"],
        text: r#"fn shadow_map(at: Entered, hit: Hit, light: Toward, params: vec4f) -> f32 {
    return light_seen(at, hit, light.number, light.direction, params.z, params.w);
}"#,
    },
    Declaration {
        module: "shadow/none",
        name: "shadow_none",
        sampling: None,
        uses: &["Entered", "Hit", "Toward"],
        text: r#"fn shadow_none(at: Entered, hit: Hit, light: Toward, params: vec4f) -> f32 {
    return 1.0;
}"#,
    },
    Declaration {
        module: "shadow/ray",
        name: "shadow_ray",
        sampling: None,
        uses: &["Entered", "Hit", "Toward", "free_way"],
        text: r#"fn shadow_ray(at: Entered, hit: Hit, light: Toward, params: vec4f) -> f32 {
    return free_way(at, hit, light);
}"#,
    },
    Declaration {
        module: "shadow/scene",
        name: "shadow_scene",
        sampling: None,
        uses: &["Entered", "Hit", "Toward"],
        text: r#"fn shadow_scene(at: Entered, hit: Hit, light: Toward, params: vec4f) -> f32 {
    return 1.0;
}"#,
    },
    Declaration {
        module: "shadow/soft",
        name: "shadow_soft",
        sampling: None,
        uses: &["Entered", "Hit", "Toward", "free_way", "point_of_disc", "seed_of"],
        text: r#"fn shadow_soft(at: Entered, hit: Hit, light: Toward, params: vec4f) -> f32 {
    let count = u32(params.x);
    let seed = seed_of(hit);
    var free = 0.0;
    var k = 0u;
    while (k < count) {
        free = free + free_way(at, hit, point_of_disc(light, seed, k, count));
        k = k + 1u;
    }
    return free / f32(count);
}"#,
    },
    Declaration {
        module: "shadow/visibility",
        name: "open_part",
        sampling: None,
        uses: &["Entered", "Hit", "shadow_texel_between"],
        text: r#"// The part of the texels around a hit that see the sky in a direction.
fn open_part(at: Entered, hit: Hit, azimuth: i32, elevation: i32, elevations: i32) -> f32 {
    return 1.0 - shadow_texel_between(hit.uv, azimuth * elevations + elevation, at.level).z;
}"#,
    },
    Declaration {
        module: "shadow/visibility",
        name: "shadow_visibility",
        sampling: None,
        uses: &["Entered", "Hit", "SLOT_SHADOW", "Toward", "climb", "open_part", "surface_settings", "turn_of"],
        text: r#"fn shadow_visibility(at: Entered, hit: Hit, light: Toward, params: vec4f) -> f32 {
    let change = climb(at, light.direction);
    if (!(change.z > 0.0)) {
        return 0.0;
    }
    let map = surface_settings.maps[SLOT_SHADOW];
    let along = change.xy * map.tile_m;
    let height = change.z * surface_settings.scale_m;
    let squared = height * height / (dot(along, along) + height * height);
    let azimuths = i32(params.x);
    let elevations = i32(params.y);
    let azimuth = turn_of(along) * params.x;
    let elevation = clamp(squared * params.y - 0.5, 0.0, params.y - 1.0);
    if (params.z < 2.0) {
        let a = i32(floor(azimuth + 0.5)) % azimuths;
        return open_part(at, hit, a, i32(floor(elevation + 0.5)), elevations);
    }
    let a0 = i32(floor(azimuth)) % azimuths;
    let a1 = (a0 + 1) % azimuths;
    let e0 = i32(floor(elevation));
    let e1 = min(e0 + 1, elevations - 1);
    let along_azimuth = azimuth - floor(azimuth);
    let along_elevation = elevation - floor(elevation);
    let right = open_part(at, hit, a1, e0, elevations);
    let above = open_part(at, hit, a0, e1, elevations);
    if (along_azimuth + along_elevation <= 1.0) {
        let corner = open_part(at, hit, a0, e0, elevations);
        return corner + (right - corner) * along_azimuth + (above - corner) * along_elevation;
    }
    let corner = open_part(at, hit, a1, e1, elevations);
    return corner + (above - corner) * (1.0 - along_azimuth) + (right - corner) * (1.0 - along_elevation);
}"#,
    },
    Declaration {
        module: "ambient/bent_normal",
        name: "ambient_bent_normal",
        sampling: None,
        uses: &["Entered", "Hit", "Material", "ambient_texel_between", "frame", "from_tangent_space"],
        text: r#"fn ambient_bent_normal(
    at: Entered,
    hit: Hit,
    normal: vec3f,
    view: vec3f,
    material: Material,
    params: vec4f,
) -> vec3f {
    let sky = from_tangent_space(at, ambient_texel_between(hit.uv, at.level).xyz);
    return frame.ambient.xyz * material.around * max(dot(normal, sky), 0.0);
}"#,
    },
    Declaration {
        module: "ambient/bounce",
        name: "ambient_bounce",
        sampling: None,
        uses: &["Entered", "Hit", "Material", "ambient_texel_between", "frame"],
        text: r#"fn ambient_bounce(
    at: Entered,
    hit: Hit,
    normal: vec3f,
    view: vec3f,
    material: Material,
    params: vec4f,
) -> vec3f {
    return frame.ambient.xyz * material.around * ambient_texel_between(hit.uv, at.level).x;
}"#,
    },
    Declaration {
        module: "ambient/constant",
        name: "ambient_constant",
        sampling: None,
        uses: &["Entered", "Hit", "Material", "frame"],
        text: r#"fn ambient_constant(
    at: Entered,
    hit: Hit,
    normal: vec3f,
    view: vec3f,
    material: Material,
    params: vec4f,
) -> vec3f {
    return frame.ambient.xyz * material.around;
}"#,
    },
    Declaration {
        module: "ambient/environment",
        name: "ambient_environment",
        sampling: None,
        uses: &["Entered", "Hit", "Material", "cosine_inside", "environment_in_lobe", "environment_on", "shade_mirrored_stage", "surface_settings"],
        text: r#"fn ambient_environment(
    at: Entered,
    hit: Hit,
    normal: vec3f,
    view: vec3f,
    material: Material,
    params: vec4f,
) -> vec3f {
    let mean = length(normal);
    let n = normalize(normal);
    let cosine = clamp(dot(n, view), 0.0, 1.0);
    let mirror = shade_mirrored_stage(material, mean, cosine);
    let reflected = n * (2.0 * cosine) - view;
    let axis = reflected + (n - reflected) * mirror.turn;
    var light = environment_in_lobe(axis, mirror.lobes.x);
    if (mirror.second > 0.0) {
        light = light + (environment_in_lobe(axis, mirror.lobes.y) - light) * mirror.second;
    }
    light = light * mirror.part;
    let enters = vec3f(1.0, 1.0, 1.0) - mirror.part;
    light = light + environment_on(n) * material.diffuse * enters;
    if (surface_settings.transmission > 0.0) {
        // Snell's law. The index is at least 1: no light that enters is reflected totally.
        let eta = 1.0 / surface_settings.ior;
        let refracted = n * (eta * cosine - cosine_inside(cosine)) - view * eta;
        let seen = environment_in_lobe(refracted, (1.0 - eta) * mirror.lean);
        light = light + seen * (material.transmitted * enters);
    }
    return light * params.x;
}"#,
    },
    Declaration {
        module: "ambient/hemisphere",
        name: "ambient_hemisphere",
        sampling: None,
        uses: &["Entered", "Hit", "Material", "frame", "hemisphere_grade"],
        text: r#"fn ambient_hemisphere(
    at: Entered,
    hit: Hit,
    normal: vec3f,
    view: vec3f,
    material: Material,
    params: vec4f,
) -> vec3f {
    return frame.ambient.xyz * material.around * hemisphere_grade(normal, params.x);
}"#,
    },
    Declaration {
        module: "ambient/occlusion",
        name: "ambient_occlusion",
        sampling: None,
        uses: &["Entered", "Hit", "Material", "ambient_texel_between", "frame"],
        text: r#"fn ambient_occlusion(
    at: Entered,
    hit: Hit,
    normal: vec3f,
    view: vec3f,
    material: Material,
    params: vec4f,
) -> vec3f {
    return frame.ambient.xyz * material.around * ambient_texel_between(hit.uv, at.level).x;
}"#,
    },
    Declaration {
        module: "ambient/sky",
        name: "LEAST_OPEN",
        sampling: None,
        uses: &[],
        text: r#"// The least length of a vector that has a direction.
const LEAST_OPEN = 0.000001;"#,
    },
    Declaration {
        module: "ambient/sky",
        name: "ambient_sky",
        sampling: None,
        uses: &["Entered", "Hit", "LEAST_OPEN", "Material", "ambient_texel_between", "frame", "from_tangent_space", "hemisphere_grade"],
        text: r#"fn ambient_sky(
    at: Entered,
    hit: Hit,
    normal: vec3f,
    view: vec3f,
    material: Material,
    params: vec4f,
) -> vec3f {
    let open = from_tangent_space(at, ambient_texel_between(hit.uv, at.level).xyz);
    let toward = 0.5 * (open / max(length(open), LEAST_OPEN) + normal);
    let part = max(dot(normal, open), 0.0);
    return frame.ambient.xyz * material.around * (part * hemisphere_grade(toward, params.x));
}"#,
    },
    Declaration {
        module: "procedure/bumps",
        name: "BUMP_BESIDE",
        sampling: None,
        uses: &[],
        text: r#"// The greatest distance of a bump from the middle of its cell, in cells.
const BUMP_BESIDE = 0.25;"#,
    },
    Declaration {
        module: "procedure/bumps",
        name: "BUMP_LEAST",
        sampling: None,
        uses: &[],
        text: r#"// The least part of its height that a bump has at any time.
const BUMP_LEAST = 0.3;"#,
    },
    Declaration {
        module: "procedure/bumps",
        name: "procedure_bumps",
        sampling: None,
        uses: &["BUMP_BESIDE", "BUMP_LEAST", "bits_of_point", "mixed", "sine_of", "unit_of"],
        text: r#"// The parameters: bumps along a tile, their radius, and their distance from the middles of cells.
fn procedure_bumps(place: vec2f, time: f32, seed: u32, params: vec4f) -> f32 {
    let at = place * params.x;
    let own = floor(at);
    var height = 0.0;
    var k = 0u;
    while (k < 9u) {
        let cell = own + vec2f(f32(k % 3u), f32(k / 3u)) - vec2f(1.0, 1.0);
        let bits = bits_of_point(cell, params.x, seed);
        let beside = vec2f(unit_of(bits), unit_of(mixed(bits + 1u))) - vec2f(0.5, 0.5);
        let middle = cell + vec2f(0.5, 0.5) + beside * (2.0 * BUMP_BESIDE * params.z);
        let away = (at - middle) / params.y;
        let wave = 0.5 + 0.5 * sine_of(time + unit_of(mixed(bits + 2u)));
        let high = BUMP_LEAST + (1.0 - BUMP_LEAST) * wave;
        height = max(height, high * sqrt(max(1.0 - dot(away, away), 0.0)));
        k = k + 1u;
    }
    return height;
}"#,
    },
    Declaration {
        module: "procedure/fbm",
        name: "NOISE_MOST",
        sampling: None,
        uses: &[],
        text: r#"// The greatest value of the noise.
const NOISE_MOST = 0.7071068;"#,
    },
    Declaration {
        module: "procedure/fbm",
        name: "gradient_at",
        sampling: None,
        uses: &["bits_of_point", "turned", "unit_of"],
        text: r#"// The contribution of a lattice point's gradient at a place `way` from it.
fn gradient_at(point: vec2f, way: vec2f, count: f32, turns: f32, seed: u32) -> f32 {
    return dot(turned(unit_of(bits_of_point(point, count, seed)) + turns), way);
}"#,
    },
    Declaration {
        module: "procedure/fbm",
        name: "gradient_noise",
        sampling: None,
        uses: &["gradient_at"],
        text: r#"// Gradient noise on a lattice with `count` points along a tile.
fn gradient_noise(at: vec2f, count: f32, turns: f32, seed: u32) -> f32 {
    let cell = floor(at);
    let part = at - cell;
    let fade = part * part * part * (part * (part * 6.0 - 15.0) + 10.0);
    let right = vec2f(1.0, 0.0);
    let down = vec2f(0.0, 1.0);
    let a = gradient_at(cell, part, count, turns, seed);
    let b = gradient_at(cell + right, part - right, count, turns, seed);
    let c = gradient_at(cell + down, part - down, count, turns, seed);
    let d = gradient_at(cell + right + down, part - right - down, count, turns, seed);
    let above = a + (b - a) * fade.x;
    let below = c + (d - c) * fade.x;
    return above + (below - above) * fade.y;
}"#,
    },
    Declaration {
        module: "procedure/fbm",
        name: "procedure_fbm",
        sampling: None,
        uses: &["NOISE_MOST", "gradient_noise"],
        text: r#"// The parameters: points of the coarsest lattice along a tile, octaves, and the strength of each
// octave relative to the one before.
fn procedure_fbm(place: vec2f, time: f32, seed: u32, params: vec4f) -> f32 {
    var height = 0.0;
    var sum = 0.0;
    var strength = 1.0;
    var count = params.x;
    var octave = 0u;
    while (f32(octave) < params.y) {
        let turns = time * f32(octave + 1u);
        height = height + strength * gradient_noise(place * count, count, turns, seed + octave);
        sum = sum + strength;
        strength = strength * params.z;
        count = count * 2.0;
        octave = octave + 1u;
    }
    return 0.5 + 0.5 * height / (sum * NOISE_MOST);
}"#,
    },
    Declaration {
        module: "procedure/waves",
        name: "WAVE_RANGE",
        sampling: None,
        uses: &[],
        text: r#"// Ratio of the longest to the shortest wave's length.
const WAVE_RANGE = 7.0;"#,
    },
    Declaration {
        module: "procedure/waves",
        name: "WAVE_PACE",
        sampling: None,
        uses: &[],
        text: r#"// Number of times that the longest wave goes by in a unit of time.
const WAVE_PACE = 2.0;"#,
    },
    Declaration {
        module: "procedure/waves",
        name: "procedure_waves",
        sampling: None,
        uses: &["WAVE_PACE", "WAVE_RANGE", "mixed", "sine_of", "unit_of"],
        text: r#"// The parameters: longest waves along a tile, number of waves, spread of their directions, and
// sharpness of their crests.
fn procedure_waves(place: vec2f, time: f32, seed: u32, params: vec4f) -> f32 {
    var height = 0.0;
    var sum = 0.0;
    var k = 0u;
    while (f32(k) < params.y) {
        let bits = mixed(seed + 4u * k);
        let part = f32(k) / params.y;
        let size = params.x * (1.0 + (WAVE_RANGE - 1.0) * part * part);
        let along = max(floor(size + 0.5), 1.0);
        let across = floor(2.0 * size * params.z * (unit_of(bits) - 0.5) + 0.5);
        let length = sqrt(along * along + across * across);
        let pace = max(floor(WAVE_PACE * sqrt(length / params.x) + 0.5), 1.0);
        let phase = unit_of(mixed(bits + 1u));
        let crest = 0.5 + 0.5 * sine_of(along * place.x + across * place.y - pace * time + phase);
        height = height + (crest + params.w * (crest * crest - crest)) / length;
        sum = sum + 1.0 / length;
        k = k + 1u;
    }
    return height / sum;
}"#,
    },
    Declaration {
        module: "roots/compose",
        name: "begin_gather_main",
        sampling: None,
        uses: &["SHADE_GROUP", "gathered", "nothing_gathered", "pass_settings", "pixel_direction", "reach_of_hit", "records", "surface_settings", "traced_what"],
        text: r#"@compute @workgroup_size(SHADE_GROUP, SHADE_GROUP)
fn begin_gather_main(@builtin(global_invocation_id) id: vec3u) {
    let size = textureDimensions(traced_what);
    if (id.y >= pass_settings.rows || id.x >= size.x) {
        return;
    }
    let place = id.y * size.x + id.x;
    let row = pass_settings.first_row + id.y;
    let point = vec2f(vec2u(id.x, row)) + vec2f(0.5, 0.5) + pass_settings.offset;
    let record = records[place];
    let nothing = nothing_gathered(reach_of_hit(record.hit & 1u, record.depth, pixel_direction(point)));
    let count = surface_settings.translucent.y;
    var k = 0u;
    while (k < count) {
        gathered[place * count + k] = nothing;
        k = k + 1u;
    }
}"#,
    },
    Declaration {
        module: "roots/compose",
        name: "compose_main",
        sampling: None,
        uses: &["SHADE_GROUP", "gathered", "pass_settings", "records", "seen_through", "surface_settings", "traced_what"],
        text: r#"@compute @workgroup_size(SHADE_GROUP, SHADE_GROUP)
fn compose_main(@builtin(global_invocation_id) id: vec3u) {
    let size = textureDimensions(traced_what);
    if (id.y >= pass_settings.rows || id.x >= size.x) {
        return;
    }
    let place = id.y * size.x + id.x;
    let count = surface_settings.translucent.y;
    var color = records[place].color;
    var transmittance = 1.0;
    var k = 0u;
    while (k < count) {
        // The farthest that is not yet laid; of those that begin together, the last.
        var farthest = 0u;
        var entry = -1.0;
        var j = 0u;
        while (j < count) {
            let other = gathered[place * count + j].entry;
            if (other >= entry) {
                entry = other;
                farthest = j;
            }
            j = j + 1u;
        }
        let seen = gathered[place * count + farthest];
        color = seen_through(color, seen);
        transmittance = transmittance * seen.transmittance;
        gathered[place * count + farthest].entry = -2.0;
        k = k + 1u;
    }
    records[place].color = color;
    records[place].transmittance = transmittance;
}"#,
    },
    Declaration {
        module: "roots/draw",
        name: "draw_vertex",
        sampling: None,
        uses: &["Varying", "corner_varying"],
        text: r#"// Three vertices for each triangle.
@vertex
fn draw_vertex(@builtin(vertex_index) vertex: u32) -> Varying {
    return corner_varying(vertex);
}"#,
    },
    Declaration {
        module: "roots/draw",
        name: "draw_box_vertex",
        sampling: None,
        uses: &["Varying", "box_varying"],
        text: r#"// BOX_VERTICES for each triangle; a second instance is the mesh turned over.
@vertex
fn draw_box_vertex(@builtin(vertex_index) vertex: u32, @builtin(instance_index) turned: u32) -> Varying {
    return box_varying(vertex, turned);
}"#,
    },
    Declaration {
        module: "roots/draw",
        name: "drawn_pixel",
        sampling: None,
        uses: &["PixelOut", "Varying", "numbered_pixel", "shade_pixel", "side_of"],
        text: r#"// The shaded pixel of a fragment.
fn drawn_pixel(in: Varying, front: bool) -> PixelOut {
    return shade_pixel(numbered_pixel(in.triangle, side_of(in, front), in.position.xy));
}"#,
    },
    Declaration {
        module: "roots/draw",
        name: "draw_fragment",
        sampling: None,
        uses: &["Varying", "drawn_pixel"],
        text: r#"// The linear colour.
@fragment
fn draw_fragment(in: Varying, @builtin(front_facing) front: bool) -> @location(0) vec4f {
    let out = drawn_pixel(in, front);
    if (out.hit == 0u) {
        discard;
    }
    return out.color;
}"#,
    },
    Declaration {
        module: "roots/draw",
        name: "Drawn",
        sampling: None,
        uses: &[],
        text: r#"struct Drawn {
    @location(0) color: vec4f,
    @builtin(frag_depth) z: f32,
}"#,
    },
    Declaration {
        module: "roots/draw",
        name: "drawn_with_depth",
        sampling: None,
        uses: &["Drawn", "PixelOut"],
        text: r#"fn drawn_with_depth(out: PixelOut) -> Drawn {
    if (out.hit == 0u) {
        discard;
    }
    return Drawn(out.color, out.z);
}"#,
    },
    Declaration {
        module: "roots/draw",
        name: "draw_depth_fragment",
        sampling: None,
        uses: &["Drawn", "Varying", "drawn_pixel", "drawn_with_depth"],
        text: r#"// The linear colour, and the hit's value for the depth buffer.
@fragment
fn draw_depth_fragment(in: Varying, @builtin(front_facing) front: bool) -> Drawn {
    return drawn_with_depth(drawn_pixel(in, front));
}"#,
    },
    Declaration {
        module: "roots/draw",
        name: "draw_box_fragment",
        sampling: None,
        uses: &["Drawn", "NEVER", "Varying", "drawn_with_depth", "may_meet", "numbered_pixel", "numbered_triangle", "shade_pixel"],
        text: r#"// The colour and the depth of a fragment of a box around a shell.
@fragment
fn draw_box_fragment(in: Varying) -> Drawn {
    if (!may_meet(in.position.xy, numbered_triangle(in.triangle), in.side, NEVER)) {
        discard;
    }
    return drawn_with_depth(shade_pixel(numbered_pixel(in.triangle, in.side, in.position.xy)));
}"#,
    },
    Declaration {
        module: "roots/draw",
        name: "gathered_in_shell",
        sampling: None,
        uses: &["Gathered", "NEVER", "PixelIn", "enter_relief", "gather_segment", "nothing_gathered"],
        text: r#"// What a ray sees of one translucent shell.
fn gathered_in_shell(pixel: PixelIn) -> Gathered {
    let at = enter_relief(pixel);
    var seen = nothing_gathered(NEVER);
    var k = 0u;
    while (k < at.segments) {
        seen = gather_segment(seen, pixel, at, k);
        k = k + 1u;
    }
    return seen;
}"#,
    },
    Declaration {
        module: "roots/draw",
        name: "draw_translucent_fragment",
        sampling: None,
        uses: &["Drawn", "NEVER", "Varying", "gathered_in_shell", "may_meet", "numbered_pixel", "numbered_triangle", "seen_through", "z_of"],
        text: r#"// The light that a translucent shell scatters toward a fragment of the box around it, its opacity, and
// the depth where the ray comes upon it. It is laid over what is behind: light + (1 - opacity) behind.
@fragment
fn draw_translucent_fragment(in: Varying) -> Drawn {
    if (!may_meet(in.position.xy, numbered_triangle(in.triangle), in.side, NEVER)) {
        discard;
    }
    let seen = gathered_in_shell(numbered_pixel(in.triangle, in.side, in.position.xy));
    if (seen.entry == NEVER) {
        discard;
    }
    return Drawn(seen_through(vec4f(0.0, 0.0, 0.0, 0.0), seen), z_of(seen.entry));
}"#,
    },
    Declaration {
        module: "roots/functions",
        name: "ReliefPoint",
        sampling: None,
        uses: &[],
        text: r#"// A point of a mesh that is seen, and the ray that sees it.
struct ReliefPoint {
    // The point's texture coordinates.
    uv: vec2f,
    // The ray's direction, of length 1, from the eye to the point.
    view: vec3f,
    // The length of a tile of the height map along u and along v.
    tile: vec2f,
    // x, y and z of the height x du² + y du dv + z dv² of the mesh beside the point, (du, dv) away in texture
    // coordinates. Positive along the normal; zeros for a flat mesh.
    curvature: vec3f,
    // The width of the pixel on the mesh, in texels of the height map.
    footprint: f32,
}"#,
    },
    Declaration {
        module: "roots/functions",
        name: "ReliefHit",
        sampling: None,
        uses: &[],
        text: r#"// Where a ray meets the relief.
struct ReliefHit {
    // Whether it does. It passes at silhouettes, in holes and beyond the edge of a map that ends there.
    hit: bool,
    // The hit's texture coordinates, and its height there, from 0 to 1.
    uv: vec2f,
    height: f32,
    // The way from the point of the mesh to the hit along the ray; negative before the mesh.
    depth: f32,
    // The relief's unit normal.
    normal: vec3f,
}"#,
    },
    Declaration {
        module: "roots/functions",
        name: "base_of_point",
        sampling: None,
        uses: &["Entered", "ReliefPoint", "base_height", "detail_of_footprint_stage", "surface_settings"],
        text: r#"// The frame of a point of the mesh, with its level of detail.
fn base_of_point(at: ReliefPoint) -> Entered {
    let tile = at.tile;
    var base = Entered(
        1u,
        vec3f(0.0, 0.0, 0.0),
        at.uv,
        vec3f(tile.x, 0.0, 0.0),
        vec3f(0.0, tile.y, 0.0),
        vec3f(0.0, 0.0, 1.0),
        vec4f(tile.x * tile.x, 0.0, tile.y * tile.y, surface_settings.scale_m),
        0u,
        vec3f(0.0, 0.0, 1.0),
        vec2f(0.0, 0.0),
        vec4f(at.curvature, base_height()),
        0.0,
        0.0,
        0.0,
    );
    let detail = detail_of_footprint_stage(base, at.footprint);
    base.level = detail.level;
    base.footprint = detail.footprint;
    base.fade = detail.fade;
    return base;
}"#,
    },
    Declaration {
        module: "roots/functions",
        name: "relief_hit",
        sampling: None,
        uses: &["NEVER", "ReliefHit", "ReliefPoint", "base_of_point", "faded", "field_height_stage", "field_normal_stage", "in_hole", "surface_crossed_stage", "surface_frame_stage", "surface_way_stage", "trace"],
        text: r#"// Where the ray through a point of the mesh meets the relief first.
fn relief_hit(at: ReliefPoint) -> ReliefHit {
    let base = surface_crossed_stage(base_of_point(at), at.view, 0.0 - NEVER);
    var k = 0u;
    while (k < base.segments) {
        let path = faded(surface_way_stage(base, at.view, 0.0, 0.0 - NEVER, k), base.fade);
        if (path.exit > 0.0) {
            let found = trace(path);
            if (found.found == 1u && !in_hole(found.uv)) {
                let placed = surface_frame_stage(base, found.uv - at.uv);
                let height = field_height_stage(found.uv, found.height, base.level);
                let normal = field_normal_stage(placed, found, vec3f(0.0, 0.0, 0.0) - at.view);
                return ReliefHit(true, found.uv, height, path.start + found.t, normal);
            }
        }
        k = k + 1u;
    }
    return ReliefHit(false, at.uv, 0.0, 0.0, vec3f(0.0, 0.0, 1.0));
}"#,
    },
    Declaration {
        module: "roots/functions",
        name: "relief_light",
        sampling: None,
        uses: &["Hit", "NEVER", "NO_COST", "ReliefHit", "ReliefPoint", "Toward", "base_of_point", "point_settings", "shadow_stage", "surface_frame_stage"],
        text: r#"// The part of a light that arrives at a hit, from 0 to 1, through the relief alone. `toward` is the unit
// direction from the hit to the light.
fn relief_light(at: ReliefPoint, hit: ReliefHit, toward: vec3f) -> f32 {
    let placed = surface_frame_stage(base_of_point(at), hit.uv - at.uv);
    let found = Hit(1u, 0u, hit.uv, hit.height, 0.0, NO_COST);
    return shadow_stage(placed, found, Toward(toward, 1.0, NEVER, point_settings.light_radius, 0u));
}"#,
    },
    Declaration {
        module: "roots/functions",
        name: "relief_tile",
        sampling: None,
        uses: &[],
        text: r#"// The length of a tile along u and along v, of a mesh whose position and texture coordinates are given. Right
// to the last bits on flat triangles, where both are linear over the picture; elsewhere off by as much as
// they bend from a pixel to the next. For fragment functions alone.
fn relief_tile(position: vec3f, uv: vec2f) -> vec2f {
    let dx = dpdx(position);
    let dy = dpdy(position);
    let du = vec2f(dpdx(uv.x), dpdy(uv.x));
    let dv = vec2f(dpdx(uv.y), dpdy(uv.y));
    let area = du.x * dv.y - du.y * dv.x;
    return vec2f(length(dx * dv.y - dy * dv.x), length(dy * du.x - dx * du.y)) / abs(area);
}"#,
    },
    Declaration {
        module: "roots/functions",
        name: "relief_curvature",
        sampling: None,
        uses: &[],
        text: r#"// The curvature of a mesh, for `ReliefPoint`, from its position, its normal and its texture coordinates. A
// normal that is interpolated over a triangle, and not brought to the length 1 again, gives the mean
// curvature of the triangle. Unit normals do where the triangle is seen from its face; from its edge they
// bend from a pixel to the next. For fragment functions alone.
fn relief_curvature(position: vec3f, normal: vec3f, uv: vec2f) -> vec3f {
    let du = vec2f(dpdx(uv.x), dpdy(uv.x));
    let dv = vec2f(dpdx(uv.y), dpdy(uv.y));
    let area = du.x * dv.y - du.y * dv.x;
    let along_u = (dpdx(position) * dv.y - dpdy(position) * dv.x) / area;
    let along_v = (dpdy(position) * du.x - dpdx(position) * du.y) / area;
    let n = normalize(normal);
    let change_u = (dpdx(normal) * dv.y - dpdy(normal) * dv.x) / area;
    let change_v = (dpdy(normal) * du.x - dpdx(normal) * du.y) / area;
    // How the direction turns, whatever the length.
    let turn_u = (change_u - n * dot(n, change_u)) / length(normal);
    let turn_v = (change_v - n * dot(n, change_v)) / length(normal);
    return vec3f(
        -0.5 * dot(turn_u, along_u),
        -0.5 * (dot(turn_u, along_v) + dot(turn_v, along_u)),
        -0.5 * dot(turn_v, along_v),
    );
}"#,
    },
    Declaration {
        module: "roots/functions_of_triangles",
        name: "ReliefTriangle",
        sampling: None,
        uses: &["Corner", "Shell"],
        text: r#"// A triangle of the mesh, and the space above it.
struct ReliefTriangle {
    a: Corner,
    b: Corner,
    c: Corner,
    shell: Shell,
}"#,
    },
    Declaration {
        module: "roots/functions_of_triangles",
        name: "ReliefRay",
        sampling: None,
        uses: &[],
        text: r#"// A ray.
struct ReliefRay {
    origin: vec3f,
    // The direction, of any length but 0. The hit's depth counts in this length.
    direction: vec3f,
    // 1; -1 for the back of the triangle, whose relief rises from there.
    side: f32,
    // The width of the pixel on the triangle, in texels of the height map.
    footprint: f32,
}"#,
    },
    Declaration {
        module: "roots/functions_of_triangles",
        name: "ReliefTriangleHit",
        sampling: None,
        uses: &[],
        text: r#"// Where a ray meets the relief of a triangle.
struct ReliefTriangleHit {
    // Whether it does. It passes beside the relief, in holes and beyond the edge of a map that ends there.
    hit: bool,
    // The hit's texture coordinates, and its height there, from 0 to 1.
    uv: vec2f,
    height: f32,
    // The way from the ray's origin to the hit, in lengths of the ray's direction.
    depth: f32,
    position: vec3f,
    // The relief's unit normal.
    normal: vec3f,
    // The frame of the mesh at the hit: a tile along u, a tile along v, and the unit normal.
    tangent: vec3f,
    bitangent: vec3f,
    up: vec3f,
}"#,
    },
    Declaration {
        module: "roots/functions_of_triangles",
        name: "relief_triangle_hit",
        sampling: None,
        uses: &["NEVER", "NO_COST", "PixelIn", "ReliefRay", "ReliefTriangle", "ReliefTriangleHit", "SHELL_FOLDED", "detail_of_footprint_stage", "field_height_stage", "field_normal_stage", "in_hole", "miss", "polish_hit", "segment_of", "surface_enter_stage", "surface_place_stage", "trace"],
        text: r#"// Where a ray meets the relief of a triangle first.
fn relief_triangle_hit(at: ReliefTriangle, ray: ReliefRay) -> ReliefTriangleHit {
    let pixel = PixelIn(ray.origin, ray.direction, ray.side, at.a, at.b, at.c, at.shell);
    var base = surface_enter_stage(pixel);
    let detail = detail_of_footprint_stage(base, ray.footprint);
    base.level = detail.level;
    base.footprint = detail.footprint;
    base.fade = detail.fade;
    var first = miss(NO_COST);
    var segment = 0u;
    var depth = NEVER;
    var k = 0u;
    while (k < base.segments) {
        let path = segment_of(pixel, base, k);
        if (path.exit > 0.0) {
            let found = trace(path);
            if (found.found == 1u) {
                let hit = polish_hit(pixel, base, path, found);
                let far = (path.start + hit.t) / length(ray.direction);
                if (!in_hole(hit.uv) && far < depth) {
                    first = hit;
                    segment = k;
                    depth = far;
                    if (at.shell.order < SHELL_FOLDED) {
                        break;
                    }
                }
            }
        }
        k = k + 1u;
    }
    let zero = vec3f(0.0, 0.0, 0.0);
    if (first.found == 0u) {
        return ReliefTriangleHit(false, vec2f(0.0, 0.0), 0.0, 0.0, zero, zero, zero, zero, zero);
    }
    let placed = surface_place_stage(pixel, base, segment_of(pixel, base, segment), first);
    let height = field_height_stage(first.uv, first.height, base.level);
    let normal = field_normal_stage(placed, first, zero - normalize(ray.direction));
    return ReliefTriangleHit(
        true,
        first.uv,
        height,
        depth,
        placed.point,
        normal,
        placed.tangent,
        placed.bitangent,
        placed.normal,
    );
}"#,
    },
    Declaration {
        module: "roots/functions_of_triangles",
        name: "relief_triangle_light",
        sampling: None,
        uses: &["Entered", "Hit", "NEVER", "NO_COST", "ReliefRay", "ReliefTriangleHit", "Toward", "detail_of_footprint_stage", "point_settings", "shadow_stage", "surface_settings"],
        text: r#"// The part of a light that arrives at a hit, from 0 to 1, through the relief alone. `toward` is the unit
// direction from the hit to the light; `ray` is the one that found the hit.
fn relief_triangle_light(ray: ReliefRay, hit: ReliefTriangleHit, toward: vec3f) -> f32 {
    let t = hit.tangent;
    let b = hit.bitangent;
    var placed = Entered(
        1u,
        hit.position,
        hit.uv,
        t,
        b,
        hit.up,
        vec4f(dot(t, t), dot(t, b), dot(b, b), surface_settings.scale_m),
        0u,
        hit.up,
        vec2f(0.0, 0.0),
        vec4f(0.0, 0.0, 0.0, 0.0),
        0.0,
        0.0,
        0.0,
    );
    let detail = detail_of_footprint_stage(placed, ray.footprint);
    placed.level = detail.level;
    placed.footprint = detail.footprint;
    placed.fade = detail.fade;
    let found = Hit(1u, 0u, hit.uv, hit.height, 0.0, NO_COST);
    return shadow_stage(placed, found, Toward(toward, 1.0, NEVER, point_settings.light_radius, 0u));
}"#,
    },
    Declaration {
        module: "roots/gather",
        name: "AHEAD",
        sampling: None,
        uses: &[],
        text: r#"// Segments that a ray remembers. More, and rays that end early search for nothing; fewer, and they
// search more often.
const AHEAD = 8u;"#,
    },
    Declaration {
        module: "roots/gather",
        name: "ShellSegment",
        sampling: None,
        uses: &[],
        text: r#"// A segment of a shell: where it begins on the ray, in metres, its triangle and side, and its number there.
struct ShellSegment {
    start: f32,
    triangle: u32,
    side: f32,
    number: u32,
}"#,
    },
    Declaration {
        module: "roots/gather",
        name: "precedes",
        sampling: None,
        uses: &["ShellSegment"],
        text: r#"// Whether a segment comes before another. Of those that begin together, the lower triangle comes first,
// then the side that is not turned over.
fn precedes(one: ShellSegment, other: ShellSegment) -> bool {
    if (one.start != other.start) {
        return one.start < other.start;
    }
    if (one.triangle != other.triangle) {
        return one.triangle < other.triangle;
    }
    if (one.side != other.side) {
        return one.side > other.side;
    }
    return one.number < other.number;
}"#,
    },
    Declaration {
        module: "roots/gather",
        name: "NextSegments",
        sampling: None,
        uses: &["AHEAD", "ShellSegment"],
        text: r#"// The next segments of a ray, in order.
struct NextSegments {
    count: u32,
    segments: array<ShellSegment, AHEAD>,
}"#,
    },
    Declaration {
        module: "roots/gather",
        name: "with_segment",
        sampling: None,
        uses: &["AHEAD", "NextSegments", "ShellSegment", "precedes"],
        text: r#"// The segments with one more, unless it comes after as many as are remembered.
fn with_segment(before: NextSegments, segment: ShellSegment) -> NextSegments {
    var next = before;
    if (next.count == AHEAD && !precedes(segment, next.segments[AHEAD - 1u])) {
        return next;
    }
    var place = min(next.count, AHEAD - 1u);
    while (place > 0u && precedes(segment, next.segments[place - 1u])) {
        next.segments[place] = next.segments[place - 1u];
        place = place - 1u;
    }
    next.segments[place] = segment;
    next.count = min(next.count + 1u, AHEAD);
    return next;
}"#,
    },
    Declaration {
        module: "roots/gather",
        name: "reach_before",
        sampling: None,
        uses: &["DEPTH_SLACK", "frame"],
        text: r#"// The parameter of a ray up to which shells may begin before a place on it, in metres.
fn reach_before(start_m: f32, length_m: f32) -> f32 {
    return start_m / length_m * (1.0 + DEPTH_SLACK) + frame.near * DEPTH_SLACK;
}"#,
    },
    Declaration {
        module: "roots/gather",
        name: "segments_after",
        sampling: None,
        uses: &["AHEAD", "NOWHERE", "NextSegments", "SHELL_BOTH_SIDES", "SHELL_TRIANGLE", "ShellSegment", "TreeRay", "enter_relief", "may_meet", "numbered_pixel", "numbered_triangle", "precedes", "reach_before", "segment_of", "shell_nodes", "walk_begin", "walk_on", "with_segment"],
        text: r#"// The first segments behind another, up to a place on the ray, in metres.
fn segments_after(point: vec2f, ray: TreeRay, last: ShellSegment, reach_m: f32) -> NextSegments {
    let length_m = length(ray.direction);
    var next = NextSegments();
    var reach = reach_before(reach_m, length_m);
    var walk = walk_on(ray, walk_begin(), reach);
    while (walk.leaf != NOWHERE) {
        let leaf = shell_nodes[walk.leaf].first;
        let triangle = leaf / SHELL_TRIANGLE;
        var side = 1.0;
        let least_side = select(1.0, -1.0, (leaf & SHELL_BOTH_SIDES) != 0u);
        while (side >= least_side) {
            if (may_meet(point, numbered_triangle(triangle), side, reach)) {
                let pixel = numbered_pixel(triangle, side, point);
                let at = enter_relief(pixel);
                var k = 0u;
                while (k < at.segments) {
                    let path = segment_of(pixel, at, k);
                    let segment = ShellSegment(path.start, triangle, side, k);
                    if (path.exit > 0.0 && path.start < reach_m && precedes(last, segment)) {
                        next = with_segment(next, segment);
                    }
                    k = k + 1u;
                }
            }
            side = side - 2.0;
        }
        if (next.count == AHEAD) {
            reach = min(reach, reach_before(next.segments[AHEAD - 1u].start, length_m));
        }
        walk = walk_on(ray, walk, reach);
    }
    return next;
}"#,
    },
    Declaration {
        module: "roots/gather",
        name: "gathered_in_shells",
        sampling: None,
        uses: &["AHEAD", "Gathered", "NEVER", "ShellSegment", "enter_relief", "gather_segment", "goes_on", "numbered_pixel", "segments_after", "tree_ray"],
        text: r#"// What the ray through a point of the picture sees of all shells.
fn gathered_in_shells(point: vec2f, before: Gathered) -> Gathered {
    let ray = tree_ray(point);
    var seen = before;
    var last = ShellSegment(0.0 - NEVER, 0u, 1.0, 0u);
    var count = AHEAD;
    while (count == AHEAD && goes_on(seen)) {
        let next = segments_after(point, ray, last, seen.reach_m);
        var k = 0u;
        while (k < next.count && goes_on(seen)) {
            last = next.segments[k];
            let pixel = numbered_pixel(last.triangle, last.side, point);
            seen = gather_segment(seen, pixel, enter_relief(pixel), last.number);
            k = k + 1u;
        }
        count = next.count;
    }
    return seen;
}"#,
    },
    Declaration {
        module: "roots/gather",
        name: "gather_main",
        sampling: None,
        uses: &["SHADE_GROUP", "gathered", "gathered_in_shells", "pass_settings", "surface_settings", "traced_what"],
        text: r#"@compute @workgroup_size(SHADE_GROUP, SHADE_GROUP)
fn gather_main(@builtin(global_invocation_id) id: vec3u) {
    let size = textureDimensions(traced_what);
    if (id.y >= pass_settings.rows || id.x >= size.x) {
        return;
    }
    let place = (id.y * size.x + id.x) * surface_settings.translucent.y + surface_settings.translucent.x;
    let row = pass_settings.first_row + id.y;
    let point = vec2f(vec2u(id.x, row)) + vec2f(0.5, 0.5) + pass_settings.offset;
    gathered[place] = gathered_in_shells(point, gathered[place]);
}"#,
    },
    Declaration {
        module: "roots/paths",
        name: "paths_main",
        sampling: None,
        uses: &["PROBE_GROUP", "PROBE_ROW", "found_hits", "given_paths", "refine_stage", "search_stage"],
        text: r#"@compute @workgroup_size(PROBE_GROUP)
fn paths_main(@builtin(global_invocation_id) id: vec3u) {
    let index = id.y * PROBE_ROW + id.x;
    if (index >= arrayLength(&given_paths)) {
        return;
    }
    let path = given_paths[index];
    found_hits[index] = refine_stage(path, search_stage(path));
}"#,
    },
    Declaration {
        module: "roots/probe",
        name: "probe_main",
        sampling: None,
        uses: &["PROBE_GROUP", "PROBE_ROW", "Probe", "depth_on_ray", "enter_relief", "key_of", "mirrored_light", "pixels", "place_hit", "polish_hit", "probes", "refine_stage", "search_stage", "segment_of"],
        text: r#"@compute @workgroup_size(PROBE_GROUP)
fn probe_main(@builtin(global_invocation_id) id: vec3u) {
    let index = id.y * PROBE_ROW + id.x;
    if (index >= arrayLength(&pixels)) {
        return;
    }
    let pixel = pixels[index];
    let at = enter_relief(pixel);
    // The same loop as in `first_hit`, with the results in between.
    var k = 0u;
    while (k < at.segments) {
        let path = segment_of(pixel, at, k);
        k = k + 1u;
        if (!(path.exit > 0.0)) {
            continue;
        }
        let found = search_stage(path);
        var hit = refine_stage(path, found);
        if (hit.found == 1u) {
            hit = polish_hit(pixel, at, path, hit);
        }
        probes[index] = Probe(
            k,
            path.uv,
            path.duv,
            path.exit,
            path.base,
            path.h,
            found.status,
            found.near,
            found.far,
            hit.found,
            hit.exhausted,
            hit.uv,
            hit.height,
            hit.t,
            hit.cost.x,
            hit.cost.y,
            hit.cost.z,
            mirrored_light(pixel, place_hit(pixel, at, k - 1u, hit), hit),
            key_of(depth_on_ray(pixel, path, hit)),
        );
        if (hit.found == 1u) {
            return;
        }
    }
}"#,
    },
    Declaration {
        module: "roots/pyramid",
        name: "pyramid_vertex",
        sampling: None,
        uses: &[],
        text: r#"// A triangle that covers the level.
@vertex
fn pyramid_vertex(@builtin(vertex_index) vertex: u32) -> @builtin(position) vec4f {
    return vec4f(select(-1.0, 3.0, vertex == 1u), select(-1.0, 3.0, vertex == 2u), 0.0, 1.0);
}"#,
    },
    Declaration {
        module: "roots/pyramid",
        name: "height_bits",
        sampling: None,
        uses: &["heights_below", "pyramid_pass"],
        text: r#"// The bits of a height without the sign, which a zero may have.
fn height_bits(column: u32, row: u32) -> u32 {
    let texel = textureLoad(heights_below, vec2i(vec2u(column, row)), i32(pyramid_pass.level)).x;
    return bitcast<u32>(texel) & 0x7fffffffu;
}"#,
    },
    Declaration {
        module: "roots/pyramid",
        name: "node_bits",
        sampling: None,
        uses: &["finer_level"],
        text: r#"// The bits of the least and the greatest height of a node.
fn node_bits(column: u32, row: u32) -> vec2u {
    return bitcast<vec2u>(textureLoad(finer_level, vec2i(vec2u(column, row)), 0).xy);
}"#,
    },
    Declaration {
        module: "roots/pyramid",
        name: "extremes_of_children",
        sampling: None,
        uses: &["node_bits", "pyramid_pass"],
        text: r#"// The extremes of the node's children; of the empty set if it has none.
fn extremes_of_children(first: vec2u) -> vec2u {
    let size = pyramid_pass.nodes_size;
    if (any(first >= size)) {
        return vec2u(0xffffffffu, 0u);
    }
    let second = min(first + vec2u(1u, 1u), size - vec2u(1u, 1u));
    let a = node_bits(first.x, first.y);
    let b = node_bits(second.x, first.y);
    let c = node_bits(first.x, second.y);
    let d = node_bits(second.x, second.y);
    return vec2u(min(min(a.x, b.x), min(c.x, d.x)), max(max(a.y, b.y), max(c.y, d.y)));
}"#,
    },
    Declaration {
        module: "roots/pyramid",
        name: "extremes_of_heights",
        sampling: None,
        uses: &["height_bits", "pyramid_pass"],
        text: r#"// The extremes of the heights that are new in the node; of the empty set if none are.
fn extremes_of_heights(first: vec2u) -> vec2u {
    let size = pyramid_pass.heights_size;
    var least = 0xffffffffu;
    var greatest = 0u;
    if (any(first >= size)) {
        return vec2u(least, greatest);
    }
    let second = min(first + vec2u(1u, 1u), size - vec2u(1u, 1u));
    let after = second + vec2u(pyramid_pass.reach, pyramid_pass.reach);
    let third = select(after, pyramid_pass.beyond, after >= size);
    for (var line = 0u; line < 2u + pyramid_pass.reach; line++) {
        let row = select(select(first.y, second.y, line == 1u), third.y, line == 2u);
        let a = height_bits(first.x, row);
        let b = height_bits(second.x, row);
        let c = height_bits(third.x, row);
        least = min(min(least, a), min(b, c));
        greatest = max(max(greatest, a), max(b, c));
    }
    return vec2u(least, greatest);
}"#,
    },
    Declaration {
        module: "roots/pyramid",
        name: "pyramid_fragment",
        sampling: None,
        uses: &["extremes_of_children", "extremes_of_heights"],
        text: r#"@fragment
fn pyramid_fragment(@builtin(position) position: vec4f) -> @location(0) vec2f {
    let first = 2u * vec2u(position.xy);
    let children = extremes_of_children(first);
    let heights = extremes_of_heights(first);
    return bitcast<vec2f>(vec2u(min(children.x, heights.x), max(children.y, heights.y)));
}"#,
    },
    Declaration {
        module: "roots/resolve",
        name: "resolve_main",
        sampling: None,
        uses: &["SHADE_GROUP", "add_sample", "pass_settings", "records", "sums", "traced_what"],
        text: r#"@compute @workgroup_size(SHADE_GROUP, SHADE_GROUP)
fn resolve_main(@builtin(global_invocation_id) id: vec3u) {
    let size = textureDimensions(traced_what);
    if (id.y >= pass_settings.rows || id.x >= size.x) {
        return;
    }
    let place = id.y * size.x + id.x;
    let sum = add_sample(sums[place], records[place].color, pass_settings.weight);
    sums[place] = sum;
    if (pass_settings.is_last == 1u) {
        records[place].color = sum;
    }
}"#,
    },
    Declaration {
        module: "roots/screen",
        name: "screen_main",
        sampling: None,
        uses: &["SHADE_GROUP", "background_at", "frame", "pass_settings", "screen", "screen_settings", "shown_records", "srgb_bytes", "toned"],
        text: r#"@compute @workgroup_size(SHADE_GROUP, SHADE_GROUP)
fn screen_main(@builtin(global_invocation_id) id: vec3u) {
    let size = screen_settings.size;
    let at = vec2u(id.x, pass_settings.first_row + id.y);
    if (id.y >= pass_settings.rows || at.x >= size.x || at.y >= size.y) {
        return;
    }
    let color = shown_records[id.y * size.x + id.x].color;
    let tone = screen_settings.tone;
    var shown = background_at(vec2f(at) + vec2f(0.5, 0.5), f32(size.y));
    if (frame.background.w > 0.0) {
        // An environment is light.
        shown = toned(tone, shown * screen_settings.gain);
    }
    if (color.w > 0.0) {
        let light = toned(tone, color.xyz * (screen_settings.gain / color.w));
        shown = light * color.w + shown * (1.0 - color.w);
    }
    screen[at.y * size.x + at.x] = srgb_bytes(shown);
}"#,
    },
    Declaration {
        module: "roots/shade",
        name: "shade_main",
        sampling: None,
        uses: &["EXHAUSTED_BIT", "Hit", "Record", "SHADE_GROUP", "STEPS_BITS", "enter_relief", "nothing_seen", "numbered_pixel", "pass_settings", "place_hit", "records", "shade_hit", "surface_settings", "traced_hit", "traced_what", "visible_lights"],
        text: r#"@compute @workgroup_size(SHADE_GROUP, SHADE_GROUP)
fn shade_main(@builtin(global_invocation_id) id: vec3u) {
    let size = textureDimensions(traced_what);
    if (id.y >= pass_settings.rows || id.x >= size.x) {
        return;
    }
    let place = id.y * size.x + id.x;
    let what = textureLoad(traced_what, vec2i(id.xy), 0);
    if (what.x == 0) {
        if (surface_settings.number == 0u) {
            records[place] = nothing_seen();
        }
        return;
    }
    let traced = textureLoad(traced_hit, vec2i(id.xy), 0);
    let exhausted = select(0u, 1u, what.y >= EXHAUSTED_BIT);
    let reads = u32(select(what.y, what.y - EXHAUSTED_BIT, exhausted == 1u));
    let segment = u32(what.z) >> STEPS_BITS;
    let cost = vec3u(reads, u32(what.z) - (segment << STEPS_BITS), u32(what.w));
    let hit = Hit(1u, exhausted, traced.xy, traced.z, traced.w, cost);
    let side = select(-1.0, 1.0, what.x > 0);
    let row = pass_settings.first_row + id.y;
    let point = vec2f(vec2u(id.x, row)) + vec2f(0.5, 0.5) + pass_settings.offset;
    let pixel = numbered_pixel(u32(abs(what.x)) - 1u, side, point);
    let at = place_hit(pixel, enter_relief(pixel), segment, hit);
    let out = shade_hit(pixel.origin, at, hit, visible_lights(at, hit));
    records[place] = Record(
        out.color,
        out.position,
        out.depth,
        out.normal,
        out.height,
        out.uv,
        out.t,
        out.hit + 2u * out.exhausted + 4u * out.level + 256u * out.surface,
        out.cell,
        out.reads,
        out.steps,
        out.bytes,
        out.lit,
        out.z,
        out.transmittance,
    );
}"#,
    },
    Declaration {
        module: "roots/show",
        name: "show_main",
        sampling: None,
        uses: &["SHADE_GROUP", "background_at", "pass_settings", "picture", "shown_records"],
        text: r#"@compute @workgroup_size(SHADE_GROUP, SHADE_GROUP)
fn show_main(@builtin(global_invocation_id) id: vec3u) {
    let size = textureDimensions(picture);
    let at = vec2u(id.x, pass_settings.first_row + id.y);
    if (id.y >= pass_settings.rows || at.x >= size.x || at.y >= size.y) {
        return;
    }
    let place = id.y * size.x + id.x;
    let color = shown_records[place].color;
    let behind = background_at(vec2f(at) + vec2f(0.5, 0.5), f32(size.y));
    let shown = color.xyz + behind * (1.0 - color.w);
    textureStore(picture, vec2i(at), vec4f(shown, 1.0));
}"#,
    },
    Declaration {
        module: "roots/stencil",
        name: "OnStencil",
        sampling: None,
        uses: &[],
        text: r#"struct OnStencil {
    @builtin(position) position: vec4f,
    @location(0) @interpolate(flat) triangle: u32,
    @location(1) @interpolate(flat) image: u32,
}"#,
    },
    Declaration {
        module: "roots/stencil",
        name: "stencil_vertex",
        sampling: None,
        uses: &["OnStencil", "clip_of_pass", "corner_varying"],
        text: r#"// The number of the instance is the image.
@vertex
fn stencil_vertex(@builtin(vertex_index) vertex: u32, @builtin(instance_index) image: u32) -> OnStencil {
    let corner = corner_varying(vertex);
    return OnStencil(clip_of_pass(corner.position), corner.triangle, image);
}"#,
    },
    Declaration {
        module: "roots/stencil",
        name: "stencil_pixel",
        sampling: None,
        uses: &["OnStencil", "PixelIn", "numbered_pixel", "point_of_pass"],
        text: r#"fn stencil_pixel(in: OnStencil, side: f32) -> PixelIn {
    return numbered_pixel(in.triangle, side, point_of_pass(in.position.xy));
}"#,
    },
    Declaration {
        module: "roots/stencil",
        name: "stencil_test_fragment",
        sampling: None,
        uses: &["OnStencil", "enter_relief", "passes_image", "stencil_pixel"],
        text: r#"// Keeps a point where the image sees something at least as high as the slice.
@fragment
fn stencil_test_fragment(in: OnStencil, @builtin(front_facing) front: bool) {
    let at = enter_relief(stencil_pixel(in, select(-1.0, 1.0, front)));
    if (at.segments == 0u || !passes_image(in.image, at.point)) {
        discard;
    }
}"#,
    },
    Declaration {
        module: "roots/stencil",
        name: "stencil_hit_fragment",
        sampling: None,
        uses: &["Hit", "NO_COST", "OnStencil", "Traced", "enter_relief", "hit_on_segment", "passes_image", "segment_of", "stencil_pixel", "traced_hit_of"],
        text: r#"// The last image's test; points that pass it and the count are hits.
@fragment
fn stencil_hit_fragment(in: OnStencil, @builtin(front_facing) front: bool) -> Traced {
    let side = select(-1.0, 1.0, front);
    let pixel = stencil_pixel(in, side);
    let at = enter_relief(pixel);
    if (at.segments == 0u || !passes_image(in.image, at.point)) {
        discard;
    }
    let path = segment_of(pixel, at, 0u);
    let hit = Hit(1u, 0u, path.uv, path.h.x, path.base, NO_COST);
    return traced_hit_of(in.triangle, side, hit_on_segment(pixel, at, path, hit, 0u));
}"#,
    },
    Declaration {
        module: "roots/stencil",
        name: "stencil_clear_fragment",
        sampling: None,
        uses: &["OnStencil"],
        text: r#"// Covers all of a slice.
@fragment
fn stencil_clear_fragment(in: OnStencil) {
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "Tally",
        sampling: None,
        uses: &[],
        text: r#"// The number of points and triangles that an edge or a triangle of the base yields.
struct Tally {
    // For an edge its parts. For a triangle 0 if it is culled, SWEPT if the grid fills it,
    // otherwise 1.
    parts: u32,
    // Its points and triangles; in the end the points and triangles of all tallies before it.
    points: u32,
    triangles: u32,
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "TessellationTotals",
        sampling: None,
        uses: &[],
        text: r#"// Totals of all points and triangles, and the arguments of the draw call.
struct TessellationTotals {
    // Vertices, instances, and the first of each.
    drawn: vec4u,
    // Workgroups that make points, and workgroups that make triangles.
    point_groups: vec4u,
    triangle_groups: vec4u,
    // Points besides the base's vertices, and triangles.
    points: u32,
    triangles: u32,
    // Number of doublings by which the grid is coarser.
    level: u32,
    // 1 when the totals are known.
    is_known: u32,
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "SWEPT",
        sampling: None,
        uses: &[],
        text: r#"// The tally's mark of a triangle that is swept.
const SWEPT = 2u;"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "sums_of_group",
        sampling: None,
        uses: &["TESSELLATE_GROUP"],
        text: r#"// Sums of each invocation in a group, to be added up.
var<workgroup> sums_of_group: array<vec2u, TESSELLATE_GROUP>;"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "added",
        sampling: None,
        uses: &["COUNTLESS"],
        text: r#"// A sum that saturates at the greatest number.
fn added(a: vec2u, b: vec2u) -> vec2u {
    let sum = a + b;
    return select(sum, vec2u(COUNTLESS, COUNTLESS), sum < a);
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "number_of",
        sampling: None,
        uses: &["TESSELLATE_ROW"],
        text: r#"fn number_of(id: vec3u) -> u32 {
    return id.y * TESSELLATE_ROW + id.x;
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "begin_main",
        sampling: None,
        uses: &["TessellationTotals", "made_totals"],
        text: r#"// Begins: no totals are known yet.
@compute @workgroup_size(1)
fn begin_main() {
    made_totals[0] = TessellationTotals(vec4u(0u), vec4u(0u), vec4u(0u), 0u, 0u, 0u, 0u);
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "voxels_main",
        sampling: None,
        uses: &["TESSELLATE_GROUP", "base_vertices", "number_of", "tessellation", "voxel_of", "voxels"],
        text: r#"// Places each vertex in grid space.
@compute @workgroup_size(TESSELLATE_GROUP)
fn voxels_main(@builtin(global_invocation_id) id: vec3u) {
    let vertex = number_of(id);
    if (vertex < tessellation.vertices) {
        voxels[vertex] = voxel_of(tessellation, base_vertices[vertex].position);
    }
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "seen_main",
        sampling: None,
        uses: &["TESSELLATE_GROUP", "base_patches", "base_vertices", "is_left_out", "number_of", "tallies", "tessellation"],
        text: r#"// Culls triangles.
@compute @workgroup_size(TESSELLATE_GROUP)
fn seen_main(@builtin(global_invocation_id) id: vec3u) {
    let number = number_of(id);
    if (number >= tessellation.patches) {
        return;
    }
    let patch_of = base_patches[number];
    let at = patch_of.corners;
    let a = base_vertices[at.x];
    let b = base_vertices[at.y];
    let c = base_vertices[at.z];
    let is_out = is_left_out(tessellation, a, b, c, patch_of.low_m, patch_of.high_m);
    tallies[tessellation.edges + number].parts = select(1u, 0u, is_out);
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "edges_main",
        sampling: None,
        uses: &["COUNTLESS", "TESSELLATE_GROUP", "Tally", "base_edges", "made_totals", "number_of", "parts_between", "tallies", "tessellation", "voxels"],
        text: r#"// Counts the parts of edges. An edge whose triangles are all culled has no points.
@compute @workgroup_size(TESSELLATE_GROUP)
fn edges_main(@builtin(global_invocation_id) id: vec3u) {
    let number = number_of(id);
    if (number >= tessellation.edges || made_totals[0].is_known == 1u) {
        return;
    }
    let edge = base_edges[number];
    let a = voxels[edge.ends.x];
    let b = voxels[edge.ends.y];
    let parts = parts_between(tessellation, a, b, edge.along, made_totals[0].level);
    var is_made = edge.patches.x == COUNTLESS;
    if (!is_made) {
        let first = tallies[tessellation.edges + edge.patches.x].parts;
        let second = tallies[tessellation.edges + edge.patches.y].parts;
        is_made = first + second > 0u;
    }
    tallies[number] = Tally(parts, select(0u, parts - 1u, is_made), 0u);
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "rows_of",
        sampling: None,
        uses: &["DiceRows", "base_patches", "dice_rows", "tallies"],
        text: r#"// The rows of a triangle of the base.
fn rows_of(number: u32) -> DiceRows {
    let edges = base_patches[number].edges;
    return dice_rows(vec3u(tallies[edges.x].parts, tallies[edges.y].parts, tallies[edges.z].parts));
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "sweep_of_patch",
        sampling: None,
        uses: &["Sweep", "base_patches", "made_totals", "sweep_on", "voxels"],
        text: r#"// The sweep of a triangle of the base.
fn sweep_of_patch(number: u32) -> Sweep {
    let at = base_patches[number].corners;
    return sweep_on(voxels[at.x], voxels[at.y], voxels[at.z], made_totals[0].level);
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "tally_of_swept",
        sampling: None,
        uses: &["SWEPT", "Tally", "base_patches", "tallies"],
        text: r#"// The tally of a swept triangle of the base with that number of points inside. All corners of its
// triangles lie inside or on its border.
fn tally_of_swept(number: u32, points: u32) -> Tally {
    let edges = base_patches[number].edges;
    let border = tallies[edges.x].parts + tallies[edges.y].parts + tallies[edges.z].parts;
    return Tally(SWEPT, points, 2u * points + border - 2u);
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "patches_main",
        sampling: None,
        uses: &["TESSELLATE_GROUP", "Tally", "base_patches", "dice_points", "dice_triangles", "is_swept", "made_totals", "number_of", "rows_of", "sweep_of_patch", "swept_points_of", "tallies", "tally_of_swept", "tessellation", "voxels"],
        text: r#"// Counts the points and triangles of the base's triangles.
@compute @workgroup_size(TESSELLATE_GROUP)
fn patches_main(@builtin(global_invocation_id) id: vec3u) {
    let number = number_of(id);
    if (number >= tessellation.patches || made_totals[0].is_known == 1u) {
        return;
    }
    let place = tessellation.edges + number;
    if (tallies[place].parts == 0u) {
        tallies[place] = Tally(0u, 0u, 0u);
        return;
    }
    let at = base_patches[number].corners;
    if (is_swept(tessellation, voxels[at.x], voxels[at.y], voxels[at.z], made_totals[0].level)) {
        tallies[place] = tally_of_swept(number, swept_points_of(sweep_of_patch(number)));
        return;
    }
    let rows = rows_of(number);
    tallies[place] = Tally(1u, dice_points(rows), dice_triangles(rows));
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "tally_count",
        sampling: None,
        uses: &["tessellation"],
        text: r#"// The number of tallies.
fn tally_count() -> u32 {
    return tessellation.edges + tessellation.patches;
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "blocks_main",
        sampling: None,
        uses: &["TESSELLATE_BLOCK", "TESSELLATE_GROUP", "added", "made_totals", "number_of", "tallies", "tally_blocks", "tally_count"],
        text: r#"// Sums up blocks of tallies.
@compute @workgroup_size(TESSELLATE_GROUP)
fn blocks_main(@builtin(global_invocation_id) id: vec3u) {
    let block = number_of(id);
    let first = block * TESSELLATE_BLOCK;
    if (first >= tally_count() || made_totals[0].is_known == 1u) {
        return;
    }
    let end = min(first + TESSELLATE_BLOCK, tally_count());
    var sum = vec2u(0u, 0u);
    for (var place = first; place < end; place++) {
        sum = added(sum, vec2u(tallies[place].points, tallies[place].triangles));
    }
    tally_blocks[block] = sum;
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "groups_for",
        sampling: None,
        uses: &["TESSELLATE_GROUP", "TESSELLATE_ROW"],
        text: r#"// Workgroups, in a row or in rows, for `count` invocations.
fn groups_for(count: u32) -> vec4u {
    let groups = (count + TESSELLATE_GROUP - 1u) / TESSELLATE_GROUP;
    let in_row = TESSELLATE_ROW / TESSELLATE_GROUP;
    return vec4u(min(groups, in_row), (groups + in_row - 1u) / in_row, 1u, 0u);
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "totals_main",
        sampling: None,
        uses: &["COARSEST", "TESSELLATE_BLOCK", "TESSELLATE_GROUP", "TessellationTotals", "added", "groups_for", "made_totals", "sums_of_group", "tally_blocks", "tally_count", "tessellation"],
        text: r#"// Sums up what comes before each block, and checks that all fits into memory. One workgroup.
@compute @workgroup_size(TESSELLATE_GROUP)
fn totals_main(@builtin(local_invocation_index) lane: u32) {
    let is_known = made_totals[0].is_known == 1u;
    let level = made_totals[0].level;
    let blocks = (tally_count() + TESSELLATE_BLOCK - 1u) / TESSELLATE_BLOCK;
    let each = (blocks + TESSELLATE_GROUP - 1u) / TESSELLATE_GROUP;
    let first = min(lane * each, blocks);
    let end = min(first + each, blocks);
    var sum = vec2u(0u, 0u);
    if (!is_known) {
        for (var block = first; block < end; block++) {
            sum = added(sum, tally_blocks[block]);
        }
    }
    sums_of_group[lane] = sum;
    workgroupBarrier();
    if (is_known) {
        return;
    }
    var before = vec2u(0u, 0u);
    for (var other = 0u; other < lane; other++) {
        before = added(before, sums_of_group[other]);
    }
    if (lane == TESSELLATE_GROUP - 1u) {
        let all = added(before, sum);
        let fits = all.x <= tessellation.most_points && all.y <= tessellation.most_triangles;
        if (fits || level == COARSEST) {
            let points = groups_for(tessellation.vertices + all.x);
            let drawn = vec4u(3u * all.y, 1u, 0u, 0u);
            made_totals[0] = TessellationTotals(drawn, points, groups_for(all.y), all.x, all.y, level, 1u);
        } else {
            made_totals[0].level = level + 1u;
        }
    }
    for (var block = first; block < end; block++) {
        let of_block = tally_blocks[block];
        tally_blocks[block] = before;
        before = added(before, of_block);
    }
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "starts_main",
        sampling: None,
        uses: &["TESSELLATE_BLOCK", "TESSELLATE_GROUP", "Tally", "number_of", "tallies", "tally_blocks", "tally_count"],
        text: r#"// Turns each tally into the sums of all tallies before it.
@compute @workgroup_size(TESSELLATE_GROUP)
fn starts_main(@builtin(global_invocation_id) id: vec3u) {
    let block = number_of(id);
    let first = block * TESSELLATE_BLOCK;
    if (first >= tally_count()) {
        return;
    }
    let end = min(first + TESSELLATE_BLOCK, tally_count());
    var before = tally_blocks[block];
    for (var place = first; place < end; place++) {
        let tally = tallies[place];
        tallies[place] = Tally(tally.parts, before.x, before.y);
        before = before + vec2u(tally.points, tally.triangles);
    }
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "tally_of_point",
        sampling: None,
        uses: &["tallies", "tally_count"],
        text: r#"// The last tally whose number of points before it is at most `point`.
fn tally_of_point(point: u32) -> u32 {
    var first = 0u;
    var end = tally_count();
    while (end - first > 1u) {
        let middle = (first + end) / 2u;
        if (tallies[middle].points <= point) {
            first = middle;
        } else {
            end = middle;
        }
    }
    return first;
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "patch_of_triangle",
        sampling: None,
        uses: &["tallies", "tally_count", "tessellation"],
        text: r#"// The triangle of the base that yields the triangle of that number.
fn patch_of_triangle(triangle: u32) -> u32 {
    var first = tessellation.edges;
    var end = tally_count();
    while (end - first > 1u) {
        let middle = (first + end) / 2u;
        if (tallies[middle].triangles <= triangle) {
            first = middle;
        } else {
            end = middle;
        }
    }
    return first - tessellation.edges;
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "vertex_site",
        sampling: None,
        uses: &["BaseSite", "base_vertices", "site_of_vertex", "voxels"],
        text: r#"fn vertex_site(vertex: u32, seen: u32) -> BaseSite {
    return site_of_vertex(base_vertices[vertex], base_vertices[seen], voxels[seen]);
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "edge_site",
        sampling: None,
        uses: &["BaseEdge", "BaseSite", "site_between", "vertex_site", "voxels"],
        text: r#"// The point of an edge with `at` of `parts` parts before it.
fn edge_site(edge: BaseEdge, at: u32, parts: u32) -> BaseSite {
    let a = vertex_site(edge.ends.x, edge.seen.x);
    let b = vertex_site(edge.ends.y, edge.seen.y);
    let shares = vec2f(voxels[edge.seen.x].share, voxels[edge.seen.y].share);
    return site_between(a, b, shares, at, parts);
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "weights_inside",
        sampling: None,
        uses: &["SWEPT", "dice_place", "dice_point", "made_corners", "rows_of", "tallies", "tessellation"],
        text: r#"// The weights of a point inside a triangle of the base, by its number there. A swept point's
// weights are stored in the point's place in `made_corners`.
fn weights_inside(number: u32, point: u32) -> vec3f {
    let tally = tallies[tessellation.edges + number];
    if (tally.parts == SWEPT) {
        return made_corners[tessellation.vertices + tally.points + point].position;
    }
    let rows = rows_of(number);
    return dice_point(rows, dice_place(rows, point)).weights;
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "patch_site",
        sampling: None,
        uses: &["BaseSite", "base_patches", "site_inside", "vertex_site", "voxels", "weights_inside"],
        text: r#"// A point inside a triangle of the base, by its number there.
fn patch_site(number: u32, point: u32) -> BaseSite {
    let at = base_patches[number].corners;
    let weights = weights_inside(number, point);
    let shares = vec3f(voxels[at.x].share, voxels[at.y].share, voxels[at.z].share);
    let a = vertex_site(at.x, at.x);
    let b = vertex_site(at.y, at.y);
    let c = vertex_site(at.z, at.z);
    return site_inside(a, b, c, shares, weights);
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "site_of_point",
        sampling: None,
        uses: &["BaseSite", "base_edges", "base_vertices", "edge_site", "patch_site", "tallies", "tally_of_point", "tessellation", "vertex_site"],
        text: r#"fn site_of_point(point: u32) -> BaseSite {
    if (point < tessellation.vertices) {
        return vertex_site(point, base_vertices[point].seen);
    }
    let place = tally_of_point(point - tessellation.vertices);
    let number = point - tessellation.vertices - tallies[place].points;
    if (place < tessellation.edges) {
        return edge_site(base_edges[place], number + 1u, tallies[place].parts);
    }
    return patch_site(place - tessellation.edges, number);
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "points_main",
        sampling: None,
        uses: &["TESSELLATE_GROUP", "displaced_site", "made_corners", "made_totals", "number_of", "site_of_point", "tessellation"],
        text: r#"// Makes points: first the base's vertices, then points of its edges, then points inside its
// triangles.
@compute @workgroup_size(TESSELLATE_GROUP)
fn points_main(@builtin(global_invocation_id) id: vec3u) {
    let point = number_of(id);
    if (point < tessellation.vertices + made_totals[0].points) {
        made_corners[point] = displaced_site(tessellation, site_of_point(point));
    }
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "numbered_point",
        sampling: None,
        uses: &["INSIDE", "base_edges", "base_patches", "one_of", "tallies", "tessellation"],
        text: r#"// The number of a point of a triangle of the base: of one of its sides, or inside.
fn numbered_point(number: u32, side: u32, at: u32) -> u32 {
    if (side == INSIDE) {
        return tessellation.vertices + tallies[tessellation.edges + number].points + at;
    }
    let corners = base_patches[number].corners;
    if (at == 0u) {
        return one_of(corners, side);
    }
    let edge = one_of(base_patches[number].edges, side);
    let is_forth = base_edges[edge].ends.x == one_of(corners, side);
    let along = select(tallies[edge].parts - at, at, is_forth);
    return tessellation.vertices + tallies[edge].points + along - 1u;
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "diced_point",
        sampling: None,
        uses: &["DicePlace", "DiceRows", "dice_point", "numbered_point"],
        text: r#"fn diced_point(number: u32, rows: DiceRows, place: DicePlace) -> u32 {
    let point = dice_point(rows, place);
    return numbered_point(number, point.side, point.at);
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "write_face",
        sampling: None,
        uses: &["Face", "Shell", "made_faces"],
        text: r#"fn write_face(triangle: u32, corners: vec3u) {
    made_faces[triangle] = Face(corners, Shell(vec2f(0.0, 1.0), 36u, vec3f(0.0, 0.0, 0.0)));
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "triangles_main",
        sampling: None,
        uses: &["SWEPT", "TESSELLATE_GROUP", "dice_triangle", "diced_point", "made_totals", "number_of", "patch_of_triangle", "rows_of", "tallies", "tessellation", "write_face"],
        text: r#"// Makes triangles by the pattern that finds each by its number.
@compute @workgroup_size(TESSELLATE_GROUP)
fn triangles_main(@builtin(global_invocation_id) id: vec3u) {
    let triangle = number_of(id);
    if (triangle >= made_totals[0].triangles) {
        return;
    }
    let number = patch_of_triangle(triangle);
    if (tallies[tessellation.edges + number].parts == SWEPT) {
        return;
    }
    let rows = rows_of(number);
    let cut = dice_triangle(rows, triangle - tallies[tessellation.edges + number].triangles);
    let a = diced_point(number, rows, cut.a);
    let b = diced_point(number, rows, cut.b);
    let c = diced_point(number, rows, cut.c);
    write_face(triangle, vec3u(a, b, c));
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "swept_point",
        sampling: None,
        uses: &["SweptPoint", "numbered_point"],
        text: r#"fn swept_point(number: u32, point: SweptPoint) -> u32 {
    return numbered_point(number, point.side, point.at);
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "write_zip",
        sampling: None,
        uses: &["Sweep", "Zip", "swept_point", "write_face", "zip_goes_left", "zip_next", "zip_rest"],
        text: r#"// Makes the triangles of a zip, beginning with the number `first`. Returns the number after the
// last.
fn write_zip(number: u32, sweep: Sweep, zipped: Zip, first: u32) -> u32 {
    var zip = zipped;
    var triangle = first;
    while (zip_rest(zip) > 0) {
        let goes_left = zip_goes_left(zip);
        let a = swept_point(number, zip.at_left);
        let b = swept_point(number, zip.at_right);
        zip = zip_next(sweep, zip, goes_left);
        var c = swept_point(number, zip.at_right);
        if (goes_left) {
            c = swept_point(number, zip.at_left);
        }
        write_face(triangle, select(vec3u(a, b, c), vec3u(b, a, c), sweep.is_turned == 1u));
        triangle = triangle + 1u;
    }
    return triangle;
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "write_strips",
        sampling: None,
        uses: &["Sweep", "made_corners", "swept_column", "swept_weights", "tallies", "tessellation", "write_zip", "zip_of"],
        text: r#"// Makes the strips of a swept triangle of the base between some columns: the weights of the points
// inside each next column, which are displaced later, and triangles. `before` counts the points and
// triangles before these columns.
fn write_strips(number: u32, sweep: Sweep, first: i32, end: i32, before: vec2u) {
    let tally = tallies[tessellation.edges + number];
    var triangle = tally.triangles + before.y;
    var column = swept_column(sweep, first, 0u);
    column.first = before.x - u32(column.inner);
    for (var strip = first; strip < end; strip++) {
        let next = swept_column(sweep, strip + 1, column.first + u32(column.inner));
        for (var k = 0; k < next.inner; k++) {
            let point = tessellation.vertices + tally.points + next.first + u32(k);
            made_corners[point].position = swept_weights(sweep, next.column, next.inside + k);
        }
        for (var which = 0u; which < 3u; which++) {
            triangle = write_zip(number, sweep, zip_of(sweep, column, next, which), triangle);
        }
        column = next;
    }
}"#,
    },
    Declaration {
        module: "roots/tessellate",
        name: "swept_main",
        sampling: None,
        uses: &["SWEPT", "TESSELLATE_GROUP", "TESSELLATE_ROW", "sweep_of_patch", "swept_column", "swept_triangles", "tallies", "tessellation", "write_strips"],
        text: r#"// Makes swept triangles. A workgroup takes a triangle of the base, and each of its invocations some
// of the strips between columns. It counts the strips before these by itself, which is less work
// than to make them.
@compute @workgroup_size(TESSELLATE_GROUP)
fn swept_main(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) lane: u32) {
    let number = group.y * (TESSELLATE_ROW / TESSELLATE_GROUP) + group.x;
    if (number >= tessellation.patches || tallies[tessellation.edges + number].parts != SWEPT) {
        return;
    }
    let sweep = sweep_of_patch(number);
    let each = (sweep.end.x + i32(TESSELLATE_GROUP) - 1) / i32(TESSELLATE_GROUP);
    let first = i32(lane) * each;
    if (first >= sweep.end.x) {
        return;
    }
    var before = vec2u(0u, 0u);
    var column = swept_column(sweep, 0, 0u);
    // Points are counted with the column after them.
    for (var strip = 0; strip < first; strip++) {
        let next = swept_column(sweep, strip + 1, 0u);
        before = before + vec2u(u32(next.inner), swept_triangles(sweep, column, next));
        column = next;
    }
    write_strips(number, sweep, first, min(first + each, sweep.end.x), before);
}"#,
    },
    Declaration {
        module: "roots/trace",
        name: "vertex_main",
        sampling: None,
        uses: &["Varying", "clip_of_pass", "corner_varying"],
        text: r#"@vertex
fn vertex_main(@builtin(vertex_index) vertex: u32) -> Varying {
    var out = corner_varying(vertex);
    out.position = clip_of_pass(out.position);
    return out;
}"#,
    },
    Declaration {
        module: "roots/trace",
        name: "shell_vertex",
        sampling: None,
        uses: &["Varying", "box_varying", "clip_of_pass"],
        text: r#"@vertex
fn shell_vertex(@builtin(vertex_index) vertex: u32, @builtin(instance_index) turned: u32) -> Varying {
    var out = box_varying(vertex, turned);
    out.position = clip_of_pass(out.position);
    return out;
}"#,
    },
    Declaration {
        module: "roots/trace",
        name: "fragment_pixel",
        sampling: None,
        uses: &["PixelIn", "Varying", "numbered_pixel", "point_of_pass"],
        text: r#"// The ray of a fragment.
fn fragment_pixel(in: Varying, side: f32) -> PixelIn {
    return numbered_pixel(in.triangle, side, point_of_pass(in.position.xy));
}"#,
    },
    Declaration {
        module: "roots/trace",
        name: "fragment_main",
        sampling: None,
        uses: &["Traced", "Varying", "enter_relief", "first_hit", "fragment_pixel", "side_of", "traced_hit_of"],
        text: r#"@fragment
fn fragment_main(in: Varying, @builtin(front_facing) front: bool) -> Traced {
    let side = side_of(in, front);
    let pixel = fragment_pixel(in, side);
    let first = first_hit(pixel, enter_relief(pixel));
    if (first.hit.found == 0u) {
        discard;
    }
    return traced_hit_of(in.triangle, side, first);
}"#,
    },
    Declaration {
        module: "roots/trace",
        name: "light_main",
        sampling: None,
        uses: &["SeenByLight", "Varying", "enter_relief", "first_hit", "fragment_pixel", "side_of"],
        text: r#"@fragment
fn light_main(in: Varying, @builtin(front_facing) front: bool) -> SeenByLight {
    let pixel = fragment_pixel(in, side_of(in, front));
    let first = first_hit(pixel, enter_relief(pixel));
    if (first.hit.found == 0u) {
        discard;
    }
    return SeenByLight(first.key, first.key);
}"#,
    },
    Declaration {
        module: "roots/trace",
        name: "BeforeShading",
        sampling: None,
        uses: &[],
        text: r#"// The depth buffer's value before the surfaces are shaded.
struct BeforeShading {
    @builtin(frag_depth) z: f32,
}"#,
    },
    Declaration {
        module: "roots/trace",
        name: "prepass_of",
        sampling: None,
        uses: &["BeforeShading", "PixelIn", "depth_on_ray", "enter_relief", "first_hit", "segment_of", "z_of"],
        text: r#"fn prepass_of(pixel: PixelIn) -> BeforeShading {
    let at = enter_relief(pixel);
    let first = first_hit(pixel, at);
    if (first.hit.found == 0u) {
        discard;
    }
    return BeforeShading(z_of(depth_on_ray(pixel, segment_of(pixel, at, first.segment), first.hit)));
}"#,
    },
    Declaration {
        module: "roots/trace",
        name: "prepass_main",
        sampling: None,
        uses: &["BeforeShading", "Varying", "fragment_pixel", "prepass_of", "side_of"],
        text: r#"@fragment
fn prepass_main(in: Varying, @builtin(front_facing) front: bool) -> BeforeShading {
    return prepass_of(fragment_pixel(in, side_of(in, front)));
}"#,
    },
    Declaration {
        module: "roots/trace",
        name: "shell_prepass_main",
        sampling: None,
        uses: &["BeforeShading", "NEVER", "Varying", "may_meet", "numbered_pixel", "numbered_triangle", "point_of_pass", "prepass_of"],
        text: r#"// The depth of a fragment of a box around a shell.
@fragment
fn shell_prepass_main(in: Varying) -> BeforeShading {
    let point = point_of_pass(in.position.xy);
    if (!may_meet(point, numbered_triangle(in.triangle), in.side, NEVER)) {
        discard;
    }
    return prepass_of(numbered_pixel(in.triangle, in.side, point));
}"#,
    },
    Declaration {
        module: "roots/trace_shells",
        name: "cover_vertex",
        sampling: None,
        uses: &[],
        text: r#"// A triangle that covers the picture.
@vertex
fn cover_vertex(@builtin(vertex_index) vertex: u32) -> @builtin(position) vec4f {
    return vec4f(select(-1.0, 3.0, vertex == 1u), select(-1.0, 3.0, vertex == 2u), 0.5, 1.0);
}"#,
    },
    Declaration {
        module: "roots/trace_shells",
        name: "NearestInShells",
        sampling: None,
        uses: &["FirstHit"],
        text: r#"// The first hit of a ray in all shells, with its triangle and side.
struct NearestInShells {
    first: FirstHit,
    triangle: u32,
    side: f32,
}"#,
    },
    Declaration {
        module: "roots/trace_shells",
        name: "nothing_in_shells",
        sampling: None,
        uses: &["FirstHit", "NO_COST", "NearestInShells", "miss"],
        text: r#"fn nothing_in_shells() -> NearestInShells {
    return NearestInShells(FirstHit(miss(NO_COST), 0u, 0.0), 0u, 1.0);
}"#,
    },
    Declaration {
        module: "roots/trace_shells",
        name: "nearer_in_shells",
        sampling: None,
        uses: &["NearestInShells"],
        text: r#"// The nearer of two hits. Ties go to the lower triangle number, and to the side that is not turned
// over.
fn nearer_in_shells(known: NearestInShells, other: NearestInShells) -> NearestInShells {
    let is_before = other.side > known.side || (other.side == known.side && other.triangle < known.triangle);
    let is_nearer = other.first.key > known.first.key || (other.first.key == known.first.key && is_before);
    if (other.first.hit.found == 1u && is_nearer) {
        return other;
    }
    return known;
}"#,
    },
    Declaration {
        module: "roots/trace_shells",
        name: "last_side",
        sampling: None,
        uses: &["SHELL_BOTH_SIDES"],
        text: r#"// The last side of a leaf's triangle that is traced; the first is 1.
fn last_side(leaf: u32) -> f32 {
    return select(1.0, -1.0, (leaf & SHELL_BOTH_SIDES) != 0u);
}"#,
    },
    Declaration {
        module: "roots/trace_shells",
        name: "nearest_in_shells",
        sampling: None,
        uses: &["FirstHit", "NEVER", "NOWHERE", "NO_COST", "NearestInShells", "PixelIn", "SHELL_FOLDED", "SHELL_TRIANGLE", "enter_relief", "hit_on_segment", "last_side", "may_meet", "miss", "nearer_in_shells", "nothing_in_shells", "numbered_pixel", "numbered_triangle", "passed_by", "reach_of", "segment_of", "shell_nodes", "trace", "tree_ray", "walk_begin", "walk_on"],
        text: r#"// The nearest hit of the ray through a point of the picture in the relief of all shells.
//
// One step of the loop is a segment. Rays that are traced side by side wait for each other in every
// step. So a ray that is through with its shell goes on to the next, instead of waiting for the
// others.
fn nearest_in_shells(point: vec2f) -> NearestInShells {
    let ray = tree_ray(point);
    var nearest = nothing_in_shells();
    var walk = walk_begin();
    var here = nearest;
    var reach = NEVER;
    var last = 1.0;
    var pixel: PixelIn;
    var at = passed_by();
    var k = 0u;
    var cost = NO_COST;
    while (true) {
        while (k >= at.segments) {
            if (here.side > last) {
                here.side = last;
            } else {
                walk = walk_on(ray, walk, reach);
                if (walk.leaf == NOWHERE) {
                    break;
                }
                let leaf = shell_nodes[walk.leaf].first;
                here.triangle = leaf / SHELL_TRIANGLE;
                here.side = 1.0;
                last = last_side(leaf);
            }
            if (may_meet(point, numbered_triangle(here.triangle), here.side, reach)) {
                pixel = numbered_pixel(here.triangle, here.side, point);
                at = enter_relief(pixel);
                k = 0u;
                cost = NO_COST;
                here.first = FirstHit(miss(NO_COST), 0u, 0.0);
            }
        }
        if (walk.leaf == NOWHERE) {
            break;
        }
        let path = segment_of(pixel, at, k);
        if (path.exit > 0.0) {
            let found = hit_on_segment(pixel, at, path, trace(path), k);
            cost = cost + found.hit.cost;
            if (found.hit.found == 1u) {
                if (here.first.hit.found == 0u || found.key > here.first.key) {
                    here.first = found;
                }
                if (pixel.shell.order < SHELL_FOLDED) {
                    k = at.segments;
                }
            }
        }
        k = k + 1u;
        if (k >= at.segments) {
            here.first.hit.cost = cost;
            nearest = nearer_in_shells(nearest, here);
            if (nearest.first.hit.found == 1u) {
                reach = reach_of(nearest.first.key);
            }
        }
    }
    return nearest;
}"#,
    },
    Declaration {
        module: "roots/trace_shells",
        name: "nearest_of_objects",
        sampling: None,
        uses: &["NEVER", "NOWHERE", "NearestInShells", "SHELL_TRIANGLE", "enter_relief", "first_hit", "last_side", "nearer_in_shells", "nothing_in_shells", "numbered_pixel", "reach_of", "shell_nodes", "tree_ray", "walk_begin", "walk_on"],
        text: r#"// The nearest hit of the ray through a point of the picture in all objects. Objects fill all of
// their boxes, and find their first hit themselves.
fn nearest_of_objects(point: vec2f) -> NearestInShells {
    let ray = tree_ray(point);
    var nearest = nothing_in_shells();
    var reach = NEVER;
    var walk = walk_on(ray, walk_begin(), reach);
    while (walk.leaf != NOWHERE) {
        let leaf = shell_nodes[walk.leaf].first;
        let triangle = leaf / SHELL_TRIANGLE;
        var side = 1.0;
        while (side >= last_side(leaf)) {
            let pixel = numbered_pixel(triangle, side, point);
            let first = first_hit(pixel, enter_relief(pixel));
            nearest = nearer_in_shells(nearest, NearestInShells(first, triangle, side));
            side = side - 2.0;
        }
        if (nearest.first.hit.found == 1u) {
            reach = reach_of(nearest.first.key);
        }
        walk = walk_on(ray, walk, reach);
    }
    return nearest;
}"#,
    },
    Declaration {
        module: "roots/trace_shells",
        name: "traced_in_shells",
        sampling: None,
        uses: &["NearestInShells", "Traced", "traced_hit_of"],
        text: r#"fn traced_in_shells(nearest: NearestInShells) -> Traced {
    if (nearest.first.hit.found == 0u) {
        discard;
    }
    return traced_hit_of(nearest.triangle, nearest.side, nearest.first);
}"#,
    },
    Declaration {
        module: "roots/trace_shells",
        name: "seen_in_shells",
        sampling: None,
        uses: &["NearestInShells", "SeenByLight"],
        text: r#"fn seen_in_shells(nearest: NearestInShells) -> SeenByLight {
    if (nearest.first.hit.found == 0u) {
        discard;
    }
    return SeenByLight(nearest.first.key, nearest.first.key);
}"#,
    },
    Declaration {
        module: "roots/trace_shells",
        name: "shells_main",
        sampling: None,
        uses: &["Traced", "nearest_in_shells", "point_of_pass", "traced_in_shells"],
        text: r#"@fragment
fn shells_main(@builtin(position) position: vec4f) -> Traced {
    return traced_in_shells(nearest_in_shells(point_of_pass(position.xy)));
}"#,
    },
    Declaration {
        module: "roots/trace_shells",
        name: "objects_main",
        sampling: None,
        uses: &["Traced", "nearest_of_objects", "point_of_pass", "traced_in_shells"],
        text: r#"@fragment
fn objects_main(@builtin(position) position: vec4f) -> Traced {
    return traced_in_shells(nearest_of_objects(point_of_pass(position.xy)));
}"#,
    },
    Declaration {
        module: "roots/trace_shells",
        name: "shells_light_main",
        sampling: None,
        uses: &["SeenByLight", "nearest_in_shells", "point_of_pass", "seen_in_shells"],
        text: r#"@fragment
fn shells_light_main(@builtin(position) position: vec4f) -> SeenByLight {
    return seen_in_shells(nearest_in_shells(point_of_pass(position.xy)));
}"#,
    },
    Declaration {
        module: "roots/trace_shells",
        name: "objects_light_main",
        sampling: None,
        uses: &["SeenByLight", "nearest_of_objects", "point_of_pass", "seen_in_shells"],
        text: r#"@fragment
fn objects_light_main(@builtin(position) position: vec4f) -> SeenByLight {
    return seen_in_shells(nearest_of_objects(point_of_pass(position.xy)));
}"#,
    },
];
