// Relief, linked shader: probe, fast sampling. Written by `cargo xtask link`; do not edit.
// SPDX-License-Identifier: MIT OR Apache-2.0
//
// The constants SURFACE, SEARCH, REFINE and SHADE choose a variant of each stage:
//   SURFACE = 0: plane, the polygon itself, with its frame interpolated: one straight segment a ray (section 4)
//   SEARCH = 0: none, nothing is searched: entry and exit (section 4.1)
//   SEARCH = 1: linear, equal steps until one is below the surface (section 4.3.1)
//     params.x: steps, steps for a ray along the normal (1 to 4096, 32)
//     params.y: grazing, times as many steps for a grazing ray (1 to 64, 1)
//   SEARCH = 2: cells, every dual cell along the path, in order (section 4.3.1)
//     params.x: limit, most cells visited before the search gives up (1 to 16777216, 1048576)
//   SEARCH = 3: frustum, over the empty frustum on each cell that the path comes to (Relief)
//     search_map: frustum slopes
//     params.x: limit, most reads before the search gives up (1 to 16777216, 1048576)
//   SEARCH = 4: cone, over the empty cone on each texel that the path comes to (section 4.3.5)
//     search_map: cone
//     params.x: limit, most reads before the search gives up (1 to 16777216, 1048576)
//   REFINE = 0: none, what the search found: the processed point, or the first sample below (section 4.1.1)
//   REFINE = 1: offset, parallax mapping: a level surface at the starting point's height (section 4.1.2)
//   REFINE = 2: offset-limited, parallax mapping with offset limiting: never farther than the height (section 4.1.3)
//   REFINE = 3: slope, the tangent plane at the starting point (section 4.1.4)
//     params.x: divide, 1 divides by N·V (ray against plane), 0 is the safer form without (0 to 1, 0)
//   REFINE = 4: slope-iterative, iterative parallax mapping: the slope correction, repeated (section 4.2.1)
//     params.x: steps, corrections (1 to 64, 4)
//     params.y: divide, 1 divides by N·V (Newton's method), 0 is the safer form without (0 to 1, 0)
//   REFINE = 5: binary, the interval is halved (section 4.2.2)
//     params.x: steps, halvings (1 to 64, 8)
//   REFINE = 6: secant, false position: the surface between the two ends is a plane (section 4.2.3)
//     params.x: steps, steps; the last needs no read (1 to 64, 2)
//   REFINE = 7: true-secant, the secant method proper: the last two guesses (section 4.2.3)
//     params.x: steps, steps; the last needs no read (1 to 64, 3)
//   REFINE = 8: patch, ray against bilinear patch in closed form, cell by cell (section 4.3.1)
//     params.x: limit, most cells visited before the refinement gives up (1 to 16777216, 1048576)
//   SHADE = 0: blinn-phong, diffuse, and a specular lobe around the half vector (section 2.1)

const BELOW_FLOOR = 1.000001;
const CELL_LIMIT = 1073741824.0;
const CONE_HALF_RATIO = 0.125;
const FLOOR = 1e-6;
const FOUND_ABOVE = 1u;
const FOUND_BELOW = 2u;
const FOUND_BRACKET = 3u;
const FOUND_EXHAUSTED = 4u;
const FOUND_MISS = 0u;
const FOUND_STARTED_BELOW = 5u;
const FOUND_UNBRACKETED = 6u;
const LEAST_SCALE_M = 1e-9;
const MAP_SLOTS = 5u;
const MAX_LIGHTS = 8u;
const NEVER = 3e38;
const RAY_SHADOW = 1u;
const RAY_VIEW = 0u;
override REFINE: u32 = 0u;
const ROUNDING = 9.5367431640625e-7;
const ROW = 65536u;
override SEARCH: u32 = 0u;
const SLOT_AMBIENT = 3u;
const SLOT_ENVIRONMENT = 4u;
const SLOT_SEARCH = 0u;
const SLOT_SHADOW = 2u;
const SLOT_SHADOW_SEARCH = 1u;
const STAGES = 4u;
override SURFACE: u32 = 0u;
const WRAP_CLAMP = 1u;
const WRAP_MIRROR = 2u;
const WRAP_REPEAT = 0u;

struct Choice {
    number: u32,
    params: vec4f
}

struct Corner {
    position: vec3f,
    normal: vec3f,
    tangent: vec3f,
    bitangent: vec3f,
    uv: vec2f
}

struct Entered {
    valid: u32,
    path: Path,
    point: vec3f,
    uv: vec2f,
    tangent: vec3f,
    bitangent: vec3f,
    normal: vec3f
}

struct Found {
    status: u32,
    near: f32,
    far: f32,
    near_gap: f32,
    far_gap: f32,
    reads: u32
}

struct Grid {
    origin: vec2f,
    step: vec2f
}

struct Hit {
    found: u32,
    exhausted: u32,
    uv: vec2f,
    height: f32,
    t: f32,
    reads: u32
}

struct Light {
    place: vec4f,
    color: vec4f
}

struct MapSettings {
    coded: u32,
    layers: u32,
    low: vec4f,
    step: vec4f
}

struct Path {
    uv: vec2f,
    duv: vec2f,
    h: vec3f,
    exit: f32,
    base: f32,
    metric: vec4f,
    ray: u32,
    level: u32
}

struct PixelIn {
    origin: vec3f,
    direction: vec3f,
    side: f32,
    a: Corner,
    b: Corner,
    c: Corner
}

struct PixelOut {
    color: vec4f,
    hit: u32,
    exhausted: u32,
    uv: vec2f,
    height: f32,
    position: vec3f,
    normal: vec3f,
    depth: f32,
    t: f32,
    cell: vec2i,
    reads: u32
}

struct Probe {
    valid: u32,
    entry: vec2f,
    duv: vec2f,
    exit: f32,
    base: f32,
    slope: f32,
    status: u32,
    near: f32,
    far: f32,
    found: u32,
    exhausted: u32,
    uv: vec2f,
    height: f32,
    t: f32,
    reads: u32
}

struct Settings {
    choices: array<Choice, STAGES>,
    maps: array<MapSettings, MAP_SLOTS>,
    eye: vec4f,
    forward: vec4f,
    corner: vec4f,
    right: vec4f,
    down: vec4f,
    ambient: vec4f,
    diffuse: vec4f,
    specular: vec4f,
    lights: array<Light, MAX_LIGHTS>,
    height_size: vec2u,
    color_size: vec2u,
    normal_size: vec2u,
    wrap: u32,
    light_count: u32,
    shininess: u32,
    has_color: u32,
    has_normal: u32,
    scale_m: f32,
    bias_m: f32
}

@group(0) @binding(8)
var ambient_map: texture_2d_array<f32>;
@group(0) @binding(2)
var color_map: texture_2d<f32>;
@group(0) @binding(9)
var environment_map: texture_2d_array<f32>;
@group(0) @binding(1)
var height_map: texture_2d<f32>;
@group(0) @binding(4)
var map_sampler: sampler;
@group(0) @binding(3)
var normal_map: texture_2d_array<f32>;
@group(1) @binding(0)
var<storage, read> pixels: array<PixelIn>;
@group(1) @binding(1)
var<storage, read_write> probes: array<Probe>;
@group(0) @binding(5)
var search_map: texture_2d_array<f32>;
@group(0) @binding(0)
var<uniform> settings: Settings;
@group(0) @binding(6)
var shadow_search_map: texture_2d_array<f32>;
@group(0) @binding(7)
var shadow_texels: texture_2d_array<f32>;

fn ambient_texel(place: vec2i, layer: i32, level: i32) -> vec4f {
    return decoded(textureLoad(ambient_map, place, layer, level), settings.maps[SLOT_AMBIENT]);
}

fn cell_after(grid: Grid, cell: vec2f, leave: vec2f, forward: vec2<bool>, t: f32) -> vec2f {
    let near = cell_of(grid.origin + grid.step * t);
    let ahead = max(near, cell + select(vec2f(0.0, 0.0), vec2f(1.0, 1.0), leave <= vec2f(t, t)));
    let behind = min(near, cell - select(vec2f(0.0, 0.0), vec2f(1.0, 1.0), leave <= vec2f(t, t)));
    return select(behind, ahead, forward);
}

fn cell_gap(path: Path, grid: Grid, cell: vec2f, t: f32) -> vec3f {
    return gap_to(path, grid, cell, height_cell(vec2i(cell)), t);
}

fn cell_leave(grid: Grid, cell: vec2f) -> vec2f {
    var leave = vec2f(NEVER, NEVER);
    if (grid.step.x > 0.0) {
        leave.x = (cell.x + 1.0 - grid.origin.x) / grid.step.x;
    }
    if (grid.step.x < 0.0) {
        leave.x = (cell.x - grid.origin.x) / grid.step.x;
    }
    if (grid.step.y > 0.0) {
        leave.y = (cell.y + 1.0 - grid.origin.y) / grid.step.y;
    }
    if (grid.step.y < 0.0) {
        leave.y = (cell.y - grid.origin.y) / grid.step.y;
    }
    return leave;
}

fn cell_next(grid: Grid, cell: vec2f, leave: vec2f) -> vec2f {
    var next = cell;
    if (leave.x <= leave.y) {
        next.x = cell.x + select(-1.0, 1.0, grid.step.x > 0.0);
    }
    else {
        next.y = cell.y + select(-1.0, 1.0, grid.step.y > 0.0);
    }
    return next;
}

fn cell_of(point: vec2f) -> vec2f {
    return clamp(floor(point), vec2f(-CELL_LIMIT, -CELL_LIMIT), vec2f(CELL_LIMIT, CELL_LIMIT));
}

fn chosen_refine() -> u32 {
    return REFINE;
}

fn chosen_search() -> u32 {
    return SEARCH;
}

fn chosen_surface() -> u32 {
    return SURFACE;
}

fn color_at(uv: vec2f) -> vec4f {
    return textureSampleLevel(color_map, map_sampler, uv, 0.0);
}

fn cone_slope(path: Path, texel: vec2f) -> f32 {
    let n = vec2i(settings.height_size);
    let place = vec2i(texel);
    let wrapped = vec2i(wrap_index(place.x, n.x), wrap_index(place.y, n.y));
    let value = search_texel(path, wrapped, 0, i32(path.level)).x;
    let squared = CONE_HALF_RATIO * value * value;
    if (squared > 0.0) {
        return (1.0 - value) * (1.0 + value) / squared;
    }
    return -1.0;
}

fn decoded(texel: vec4f, map: MapSettings) -> vec4f {
    if (map.coded == 1u) {
        return map.low + map.step * floor(texel * 255.0 + vec4f(0.5, 0.5, 0.5, 0.5));
    }
    return texel;
}

fn environment_texel(place: vec2i, face: i32, level: i32) -> vec4f {
    return decoded(textureLoad(environment_map, place, face, level), settings.maps[SLOT_ENVIRONMENT]);
}

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
    if (quadratic(c, span) <= 0.0) {
        return span;
    }
    return NEVER;
}

fn folded_cell(i: i32, n: i32) -> vec2i {
    if (i >= 0 && i < n) {
        return vec2i(i, 0);
    }
    if (settings.wrap == WRAP_REPEAT) {
        return vec2i(((i % n) + n) % n, 0);
    }
    if (settings.wrap == WRAP_MIRROR) {
        let period = 2 * n;
        let folded = ((i % period) + period) % period;
        if (folded < n) {
            return vec2i(folded, 0);
        }
        return vec2i(select(-1, period - 2 - folded, folded < period - 1), 1);
    }
    return vec2i(-1, 0);
}

fn found_in_cell(c: vec3f, t: f32, span: f32, first: bool, reads: u32) -> Found {
    if (c.x <= 0.0) {
        if (first && c.x < 0.0) {
            return Found(FOUND_STARTED_BELOW, 0.0, 0.0, c.x, c.x, reads);
        }
        return Found(FOUND_BRACKET, t, t, c.x, c.x, reads);
    }
    let s = least_at(c, span);
    let gap = quadratic(c, s);
    if (gap <= 0.0) {
        return Found(FOUND_BRACKET, t, t + s, c.x, gap, reads);
    }
    return Found(FOUND_ABOVE, t, t + span, c.x, quadratic(c, span), reads);
}

fn frustum_slope(path: Path, cell: vec2i, forward: vec2<bool>) -> f32 {
    let u = folded_cell(cell.x, i32(settings.height_size.x));
    let v = folded_cell(cell.y, i32(settings.height_size.y));
    if (u.x < 0 || v.x < 0) {
        return -1.0;
    }
    let slopes = search_texel(path, vec2i(u.x, v.x), 0, i32(path.level));
    let right = forward.x == (u.y == 0);
    let down = forward.y == (v.y == 0);
    return select(select(slopes.w, slopes.z, right), select(slopes.y, slopes.x, right), down);
}

fn gap_to(path: Path, grid: Grid, cell: vec2f, h: vec4f, t: f32) -> vec3f {
    let bx = h.y - h.x;
    let by = h.z - h.x;
    let twist = (h.x - h.y) + (h.w - h.z);
    let at = (grid.origin - cell) + grid.step * t;
    let z = path.h.x + t * (path.h.y + t * path.h.z);
    let dz = path.h.y + 2.0 * t * path.h.z;
    return vec3f(z - (h.x + bx * at.x + by * at.y + twist * at.x * at.y), dz - (bx * grid.step.x + by * grid.step.y + twist * (at.x * grid.step.y + at.y * grid.step.x)), path.h.z - twist * grid.step.x * grid.step.y);
}

fn grid_of(path: Path) -> Grid {
    let size = height_size();
    return Grid(path.uv * size - vec2f(0.5, 0.5), path.duv * size);
}

fn has_interval(found: Found) -> bool {
    return found.far > found.near && (found.status == FOUND_BRACKET || found.status == FOUND_UNBRACKETED || found.status == FOUND_ABOVE);
}

fn height_and_slope(uv: vec2f) -> vec3f {
    let size = height_size();
    let point = uv * size - vec2f(0.5, 0.5);
    let cell = cell_of(point);
    let f = point - cell;
    let h = height_cell(vec2i(cell));
    let top = h.x + (h.y - h.x) * f.x;
    let bottom = h.z + (h.w - h.z) * f.x;
    let left = h.x + (h.z - h.x) * f.y;
    let right = h.y + (h.w - h.y) * f.y;
    return vec3f(top + (bottom - top) * f.y, (right - left) * size.x, (bottom - top) * size.y);
}

fn height_at(uv: vec2f) -> f32 {
    return textureSampleLevel(height_map, map_sampler, uv, 0.0).x;
}

fn height_cell(cell: vec2i) -> vec4f {
    let n = vec2i(settings.height_size);
    let i0 = wrap_index(cell.x, n.x);
    let i1 = wrap_index(cell.x + 1, n.x);
    let j0 = wrap_index(cell.y, n.y);
    let j1 = wrap_index(cell.y + 1, n.y);
    return vec4f(textureLoad(height_map, vec2i(i0, j0), 0).x, textureLoad(height_map, vec2i(i1, j0), 0).x, textureLoad(height_map, vec2i(i0, j1), 0).x, textureLoad(height_map, vec2i(i1, j1), 0).x);
}

fn height_size() -> vec2f {
    return vec2f(settings.height_size);
}

fn hit_on_path(path: Path, t: f32, exhausted: u32, reads: u32) -> Hit {
    if (t > path.exit && path_height(path, path.exit) > FLOOR) {
        return miss(reads);
    }
    let inside = clamp(t, 0.0, path.exit);
    return Hit(1u, exhausted, path_uv(path, inside), path_height(path, inside), inside, reads);
}

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
}

fn least_at(c: vec3f, span: f32) -> f32 {
    if (c.z > 0.0) {
        return clamp((0.0 - c.y) / (2.0 * c.z), 0.0, span);
    }
    return span;
}

fn miss(reads: u32) -> Hit {
    return Hit(0u, 0u, vec2f(0.0, 0.0), 0.0, 0.0, reads);
}

fn normal_at(uv: vec2f) -> vec3f {
    return textureSampleLevel(normal_map, map_sampler, uv, 0, 0.0).xyz;
}

fn normal_z(path: Path, slope: vec2f) -> f32 {
    let m = path.metric;
    let area = m.x * m.z - m.y * m.y;
    let squared = (slope.x * slope.x * m.z - 2.0 * slope.x * slope.y * m.y + slope.y * slope.y * m.x) / area;
    return 1.0 / sqrt(1.0 + m.w * m.w * squared);
}

fn path_gap(path: Path, t: f32) -> f32 {
    return path_height(path, t) - height_at(path_uv(path, t));
}

fn path_height(path: Path, t: f32) -> f32 {
    return path.h.x + t * (path.h.y + t * path.h.z);
}

fn path_slope(path: Path, t: f32) -> f32 {
    return path.h.y + 2.0 * t * path.h.z;
}

fn path_uv(path: Path, t: f32) -> vec2f {
    return path.uv + path.duv * t;
}

fn pixel_direction(pixel: vec2f) -> vec3f {
    return settings.corner.xyz + settings.right.xyz * pixel.x + settings.down.xyz * pixel.y;
}

@compute @workgroup_size(64)
fn probe_main(@builtin(global_invocation_id) id: vec3u) {
    let index = id.y * ROW + id.x;
    if (index >= arrayLength(&pixels)) {
        return;
    }
    let at = surface_stage(pixels[index]);
    if (at.valid == 0u) {
        return;
    }
    let path = at.path;
    let found = search_stage(path);
    let hit = refine_stage(path, found);
    probes[index] = Probe(at.valid, path.uv, path.duv, path.exit, path.base, path.h.y, found.status, found.near, found.far, hit.found, hit.exhausted, hit.uv, hit.height, hit.t, hit.reads);
}

fn quadratic(c: vec3f, s: f32) -> f32 {
    return c.x + s * (c.y + s * c.z);
}

fn refine_binary(path: Path, found: Found, params: vec4f) -> Hit {
    if (!has_interval(found)) {
        return refine_none(path, found, params);
    }
    var near = found.near;
    var far = found.far;
    var reads = found.reads;
    var crossed = found.status == FOUND_BRACKET || path_height(path, far) <= FLOOR;
    var k = 0.0;
    while ((k < params.x)) {
        let middle = 0.5 * (near + far);
        reads = reads + 1u;
        if (path_gap(path, middle) <= 0.0) {
            far = middle;
            crossed = true;
        }
        else {
            near = middle;
        }
        k = k + 1.0;
    }
    if (!crossed) {
        return miss(reads);
    }
    return hit_on_path(path, 0.5 * (near + far), 0u, reads);
}

fn refine_none(path: Path, found: Found, params: vec4f) -> Hit {
    if (found.status == FOUND_MISS) {
        return miss(found.reads);
    }
    let exhausted = select(0u, 1u, found.status == FOUND_EXHAUSTED);
    return hit_on_path(path, starting_point(path, found), exhausted, found.reads);
}

fn refine_offset(path: Path, found: Found, params: vec4f) -> Hit {
    if (found.status == FOUND_MISS) {
        return miss(found.reads);
    }
    let start = starting_point(path, found);
    let level = height_at(path_uv(path, start));
    let slope = path_slope(path, start);
    var t = start;
    if (slope != 0.0) {
        t = start + (level - path_height(path, start)) / slope;
    }
    return hit_on_path(path, t, select(0u, 1u, found.status == FOUND_EXHAUSTED), found.reads + 1u);
}

fn refine_offset_limited(path: Path, found: Found, params: vec4f) -> Hit {
    if (found.status == FOUND_MISS) {
        return miss(found.reads);
    }
    let start = starting_point(path, found);
    let level = height_at(path_uv(path, start));
    let rise_m = (level - path_height(path, start)) * path.metric.w;
    var hit = hit_on_path(path, start - rise_m, select(0u, 1u, found.status == FOUND_EXHAUSTED), found.reads + 1u);
    if (hit.found == 1u) {
        hit.height = level;
    }
    return hit;
}

fn refine_patch(path: Path, found: Found, params: vec4f) -> Hit {
    if (found.status == FOUND_MISS) {
        return miss(found.reads);
    }
    if (found.status == FOUND_EXHAUSTED) {
        return hit_on_path(path, found.near, 1u, found.reads);
    }
    if (found.status == FOUND_STARTED_BELOW) {
        return hit_on_path(path, found.near, 0u, found.reads);
    }
    let grid = grid_of(path);
    var t = found.near;
    var cell = cell_of(grid.origin + grid.step * t);
    var reads = found.reads;
    let limit = reads + u32(params.x);
    while ((reads < limit)) {
        let leave = cell_leave(grid, cell);
        let end = min(min(leave.x, leave.y), found.far);
        let span = max(end - t, 0.0);
        let c = cell_gap(path, grid, cell, t);
        reads = reads + 1u;
        if (c.x <= 0.0) {
            return hit_on_path(path, t, 0u, reads);
        }
        let s = first_root(c, span);
        if (s < NEVER) {
            return hit_on_path(path, t + s, 0u, reads);
        }
        if (end >= found.far) {
            if (found.status == FOUND_BRACKET || found.status == FOUND_BELOW) {
                return hit_on_path(path, found.far, 0u, reads);
            }
            return miss(reads);
        }
        cell = cell_next(grid, cell, leave);
        t = max(t, end);
    }
    return hit_on_path(path, t, 1u, reads);
}

fn refine_secant(path: Path, found: Found, params: vec4f) -> Hit {
    if (!has_interval(found)) {
        return refine_none(path, found, params);
    }
    var near = found.near;
    var far = found.far;
    var near_gap = found.near_gap;
    var far_gap = found.far_gap;
    var reads = found.reads;
    if (found.status != FOUND_BRACKET) {
        near_gap = path_gap(path, near);
        far_gap = path_gap(path, far);
        reads = reads + 2u;
        if (far_gap > 0.0) {
            return miss(reads);
        }
    }
    var t = far;
    var k = 1.0;
    while ((k <= params.x)) {
        let drop = near_gap - far_gap;
        if (!(drop > 0.0)) {
            break;
        }
        t = near + (far - near) * (near_gap / drop);
        if (k < params.x) {
            let gap = path_gap(path, t);
            reads = reads + 1u;
            if (gap <= 0.0) {
                far = t;
                far_gap = gap;
            }
            else {
                near = t;
                near_gap = gap;
            }
        }
        k = k + 1.0;
    }
    return hit_on_path(path, t, 0u, reads);
}

fn refine_slope(path: Path, found: Found, params: vec4f) -> Hit {
    if (found.status == FOUND_MISS) {
        return miss(found.reads);
    }
    let start = starting_point(path, found);
    let plane = height_and_slope(path_uv(path, start));
    let rise = plane.x - path_height(path, start);
    var t = start;
    if (params.x > 0.5) {
        let closing = path_slope(path, start) - (plane.y * path.duv.x + plane.z * path.duv.y);
        if (closing < 0.0) {
            t = start + rise / closing;
        }
    }
    else {
        t = start - rise * path.metric.w * normal_z(path, vec2f(plane.y, plane.z));
    }
    return hit_on_path(path, t, select(0u, 1u, found.status == FOUND_EXHAUSTED), found.reads + 1u);
}

fn refine_slope_iterative(path: Path, found: Found, params: vec4f) -> Hit {
    if (found.status == FOUND_MISS) {
        return miss(found.reads);
    }
    var t = starting_point(path, found);
    var reads = found.reads;
    var k = 0.0;
    while ((k < params.x)) {
        let plane = height_and_slope(path_uv(path, t));
        reads = reads + 1u;
        let rise = plane.x - path_height(path, t);
        if (params.y > 0.5) {
            let closing = path_slope(path, t) - (plane.y * path.duv.x + plane.z * path.duv.y);
            if (closing < 0.0) {
                t = t + rise / closing;
            }
        }
        else {
            t = t - rise * path.metric.w * normal_z(path, vec2f(plane.y, plane.z));
        }
        t = clamp(t, 0.0, path.exit);
        k = k + 1.0;
    }
    return hit_on_path(path, t, select(0u, 1u, found.status == FOUND_EXHAUSTED), reads);
}

fn refine_stage(path: Path, found: Found) -> Hit {
    switch (chosen_refine()) {
        case 0u {
            return refine_none(path, found, settings.choices[2].params);
        }
        case 1u {
            return refine_offset(path, found, settings.choices[2].params);
        }
        case 2u {
            return refine_offset_limited(path, found, settings.choices[2].params);
        }
        case 3u {
            return refine_slope(path, found, settings.choices[2].params);
        }
        case 4u {
            return refine_slope_iterative(path, found, settings.choices[2].params);
        }
        case 5u {
            return refine_binary(path, found, settings.choices[2].params);
        }
        case 6u {
            return refine_secant(path, found, settings.choices[2].params);
        }
        case 7u {
            return refine_true_secant(path, found, settings.choices[2].params);
        }
        case default {
            return refine_patch(path, found, settings.choices[2].params);
        }
    }
}

fn refine_true_secant(path: Path, found: Found, params: vec4f) -> Hit {
    if (!has_interval(found)) {
        return refine_none(path, found, params);
    }
    var before = found.near;
    var last = found.far;
    var before_gap = found.near_gap;
    var last_gap = found.far_gap;
    var reads = found.reads;
    if (found.status != FOUND_BRACKET) {
        before_gap = path_gap(path, before);
        last_gap = path_gap(path, last);
        reads = reads + 2u;
        if (last_gap > 0.0) {
            return miss(reads);
        }
    }
    var k = 1.0;
    while ((k <= params.x)) {
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
            reads = reads + 1u;
        }
        k = k + 1.0;
    }
    return hit_on_path(path, last, 0u, reads);
}

fn search_cells(path: Path, params: vec4f) -> Found {
    let grid = grid_of(path);
    var cell = cell_of(grid.origin);
    var t = 0.0;
    var reads = 0u;
    let limit = u32(params.x);
    while ((reads < limit)) {
        let leave = cell_leave(grid, cell);
        let end = min(min(leave.x, leave.y), path.exit);
        let c = cell_gap(path, grid, cell, t);
        reads = reads + 1u;
        let span = max(end - t, 0.0);
        let found = found_in_cell(c, t, span, reads == 1u, reads);
        if (found.status != FOUND_ABOVE) {
            return found;
        }
        if (end >= path.exit) {
            return Found(FOUND_MISS, t, path.exit, c.x, found.far_gap, reads);
        }
        cell = cell_next(grid, cell, leave);
        t = max(t, end);
    }
    return Found(FOUND_EXHAUSTED, t, path.exit, 0.0, 0.0, reads);
}

fn search_cone(path: Path, params: vec4f) -> Found {
    let grid = grid_of(path);
    let forward = grid.step >= vec2f(0.0, 0.0);
    var cell = cell_of(grid.origin);
    var t = 0.0;
    var reads = 0u;
    let limit = u32(params.x);
    while ((reads < limit)) {
        let first = reads == 0u;
        let heights = height_cell(vec2i(cell));
        reads = reads + 1u;
        let leave = cell_leave(grid, cell);
        let end = min(min(leave.x, leave.y), path.exit);
        let span = max(end - t, 0.0);
        let at = (grid.origin - cell) + grid.step * t;
        let corner = select(vec2f(0.0, 0.0), vec2f(1.0, 1.0), at >= vec2f(0.5, 0.5));
        let above = select(heights.x, heights.y, at.x >= 0.5);
        let below = select(heights.z, heights.w, at.x >= 0.5);
        let apex = select(above, below, at.y >= 0.5);
        var next = t;
        if (path_height(path, t) > apex) {
            let texel = cell + corner;
            let slope = cone_slope(path, texel);
            reads = reads + 1u;
            if (slope >= 0.0) {
                next = t + stays_inside(path, grid, texel, apex, slope, t);
            }
        }
        if (next < end) {
            let found = found_in_cell(gap_to(path, grid, cell, heights, t), t, span, first, reads);
            if (found.status != FOUND_ABOVE) {
                return found;
            }
            next = max(t, end);
        }
        if (next >= path.exit) {
            return Found(FOUND_MISS, t, path.exit, 0.0, 0.0, reads);
        }
        cell = cell_after(grid, cell, leave, forward, next);
        t = next;
    }
    return Found(FOUND_EXHAUSTED, t, path.exit, 0.0, 0.0, reads);
}

fn search_frustum(path: Path, params: vec4f) -> Found {
    let grid = grid_of(path);
    let forward = grid.step >= vec2f(0.0, 0.0);
    var cell = cell_of(grid.origin);
    var t = 0.0;
    var reads = 0u;
    let limit = u32(params.x);
    while ((reads < limit)) {
        let first = reads == 0u;
        let heights = height_cell(vec2i(cell));
        reads = reads + 1u;
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
                slope = frustum_slope(path, vec2i(cell), forward);
                reads = reads + select(0u, 1u, slope >= 0.0);
            }
        }
        else {
            let c = gap_to(path, grid, cell, heights, t);
            let found = found_in_cell(c, t, span, first, reads);
            if (found.status != FOUND_ABOVE) {
                return found;
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
            return Found(FOUND_MISS, t, path.exit, 0.0, 0.0, reads);
        }
        if (slope >= 0.0) {
            cell = cell_after(grid, cell, leave, forward, next);
        }
        else {
            cell = cell_next(grid, cell, leave);
        }
        t = next;
    }
    return Found(FOUND_EXHAUSTED, t, path.exit, 0.0, 0.0, reads);
}

fn search_linear(path: Path, params: vec4f) -> Found {
    let cosine = clamp(abs(path.h.y) * path.metric.w, 0.0, 1.0);
    let steps = max(1.0, ceil(params.x * mix(params.y, 1.0, cosine)));
    var near = 0.0;
    var near_gap = path_gap(path, 0.0);
    var reads = 1u;
    if (near_gap < 0.0) {
        return Found(FOUND_STARTED_BELOW, 0.0, 0.0, near_gap, near_gap, reads);
    }
    var k = 1.0;
    while ((k <= steps)) {
        let t = path.exit * (k / steps);
        let gap = path_gap(path, t);
        reads = reads + 1u;
        if (gap <= 0.0) {
            return Found(FOUND_BRACKET, near, t, near_gap, gap, reads);
        }
        near = t;
        near_gap = gap;
        k = k + 1.0;
    }
    return Found(FOUND_MISS, near, near, near_gap, near_gap, reads);
}

fn search_none(path: Path, params: vec4f) -> Found {
    return Found(FOUND_UNBRACKETED, 0.0, path.exit, 0.0, 0.0, 0u);
}

fn search_stage(path: Path) -> Found {
    switch (chosen_search()) {
        case 0u {
            return search_none(path, settings.choices[1].params);
        }
        case 1u {
            return search_linear(path, settings.choices[1].params);
        }
        case 2u {
            return search_cells(path, settings.choices[1].params);
        }
        case 3u {
            return search_frustum(path, settings.choices[1].params);
        }
        case default {
            return search_cone(path, settings.choices[1].params);
        }
    }
}

fn search_texel(path: Path, place: vec2i, layer: i32, level: i32) -> vec4f {
    if (path.ray == RAY_SHADOW) {
        let texel = textureLoad(shadow_search_map, place, layer, level);
        return decoded(texel, settings.maps[SLOT_SHADOW_SEARCH]);
    }
    return decoded(textureLoad(search_map, place, layer, level), settings.maps[SLOT_SEARCH]);
}

fn shadow_texel(place: vec2i, layer: i32, level: i32) -> vec4f {
    return decoded(textureLoad(shadow_texels, place, layer, level), settings.maps[SLOT_SHADOW]);
}

fn starting_point(path: Path, found: Found) -> f32 {
    if (found.status == FOUND_UNBRACKETED) {
        return path.base;
    }
    if (found.status == FOUND_BRACKET || found.status == FOUND_BELOW) {
        return found.far;
    }
    return found.near;
}

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
}

fn stays_inside(path: Path, grid: Grid, offset: vec2f, apex: f32, slope: f32, t: f32) -> f32 {
    let rest = path.exit - t;
    let height = path_height(path, t) - apex;
    let terms = abs(path.h.y) + 2.0 * path.exit * abs(path.h.z);
    let rise = path_slope(path, t) + min(path.h.z, 0.0) * rest - ROUNDING * terms;
    var most = rest;
    if (rise < 0.0) {
        most = min(most, height / (0.0 - rise));
    }
    let end = t + most;
    let far = (abs(grid.origin) + abs(grid.step) * end + vec2f(1.0, 1.0)) / height_size();
    let of_heights = ROUNDING * (abs(path.h.x) + end * (abs(path.h.y) + end * abs(path.h.z)));
    let lost = of_heights + ROUNDING * slope * (far.x + far.y);
    let gap = height - 2.0 * lost;
    let aside = ((grid.origin - offset) + grid.step * t) / height_size();
    let c = (slope * length(aside) - gap) * (slope * length(aside) + gap);
    if (gap <= 0.0 || c >= 0.0) {
        return 0.0;
    }
    let b = slope * slope * dot(aside, path.duv) - gap * rise;
    let a = slope * slope * dot(path.duv, path.duv) - rise * rise;
    let discriminant = b * b - a * c;
    var leave = NEVER;
    if (discriminant >= 0.0) {
        let root = sqrt(discriminant);
        if (b >= 0.0) {
            leave = (0.0 - c) / (b + root);
        }
        else if (a > 0.0) {
            leave = (root - b) / a;
        }
    }
    leave = min(leave, most);
    if (slope * length(aside + path.duv * leave) + lost <= height + rise * leave) {
        return leave;
    }
    return 0.0;
}

fn surface_plane(pixel: PixelIn, params: vec4f) -> Entered {
    let a = pixel.a.position;
    let e1 = pixel.b.position - a;
    let e2 = pixel.c.position - a;
    let n = cross(e1, e2);
    let nn = dot(n, n);
    let toward = dot(n, pixel.direction);
    let distance = dot(n, a - pixel.origin) / toward;
    let point = pixel.origin + pixel.direction * distance;
    let from_a = point - a;
    let wb = dot(cross(from_a, e2), n) / nn;
    let wc = dot(cross(e1, from_a), n) / nn;
    let wa = 1.0 - wb - wc;
    let uv = pixel.a.uv * wa + pixel.b.uv * wb + pixel.c.uv * wc;
    let tangent = pixel.a.tangent * wa + pixel.b.tangent * wb + pixel.c.tangent * wc;
    let bitangent = pixel.a.bitangent * wa + pixel.b.bitangent * wb + pixel.c.bitangent * wc;
    let normal = normalize(pixel.a.normal * wa + pixel.b.normal * wb + pixel.c.normal * wc) * pixel.side;
    let along = length(pixel.direction);
    let direction = pixel.direction / along;
    let tt = dot(tangent, tangent);
    let tb = dot(tangent, bitangent);
    let bb = dot(bitangent, bitangent);
    let td = dot(tangent, direction);
    let bd = dot(bitangent, direction);
    let area = tt * bb - tb * tb;
    let descent = 0.0 - dot(normal, direction);
    var valid = 1u;
    if (!(descent > 0.0) || !(area > 0.0)) {
        valid = 0u;
    }
    let duv = vec2f(td * bb - bd * tb, bd * tt - td * tb) / area;
    let scale = max(settings.scale_m, LEAST_SCALE_M);
    let base_height = (0.0 - settings.bias_m) / scale;
    let slope = (0.0 - descent) / scale;
    let eye = (0.0 - distance) * along;
    let top = (base_height - 1.0) * scale / descent;
    var enter = max(top, eye);
    var leave = base_height * scale / descent;
    leave = leave + (leave - top) * (BELOW_FLOOR - 1.0);
    if (settings.wrap == WRAP_CLAMP) {
        var interval = inside_unit(uv.x, duv.x, vec2f(enter, leave));
        interval = inside_unit(uv.y, duv.y, interval);
        enter = interval.x;
        leave = interval.y;
    }
    if (!(leave > enter)) {
        valid = 0u;
    }
    let entry_height = select(base_height + slope * enter, 1.0, enter == top);
    let base = clamp(0.0 - enter, 0.0 - NEVER, NEVER);
    let path = Path(uv + duv * enter, duv, vec3f(entry_height, slope, 0.0), leave - enter, base, vec4f(tt, tb, bb, settings.scale_m), RAY_VIEW, 0u);
    return Entered(valid, path, point, uv, tangent, bitangent, normal);
}

fn surface_stage(pixel: PixelIn) -> Entered {
    switch (chosen_surface()) {
        case default {
            return surface_plane(pixel, settings.choices[0].params);
        }
    }
}

fn wrap_index(i: i32, n: i32) -> i32 {
    if (i >= 0 && i < n) {
        return i;
    }
    if (settings.wrap == WRAP_CLAMP) {
        return clamp(i, 0, n - 1);
    }
    if (settings.wrap == WRAP_REPEAT) {
        return ((i % n) + n) % n;
    }
    let period = 2 * n;
    let folded = ((i % period) + period) % period;
    return select(period - 1 - folded, folded, folded < n);
}
