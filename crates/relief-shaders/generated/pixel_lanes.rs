// The stages over lanes. Written by `cargo xtask link`; do not edit.

use super::*;

#[derive(Clone, Copy)]
pub struct Across {
    pub duv: Vec2<F>,
    pub descent: F,
    pub along: F,
    pub across: F,
    pub mixed: F,
    pub sine: F,
}
lanes! { fn sel_across(m: M, a: &Across, b: &Across) -> Across {
    Across {
        duv: Vec2 { x: sel(m, a.duv.x, b.duv.x), y: sel(m, a.duv.y, b.duv.y) },
        descent: sel(m, a.descent, b.descent),
        along: sel(m, a.along, b.along),
        across: sel(m, a.across, b.across),
        mixed: sel(m, a.mixed, b.mixed),
        sine: sel(m, a.sine, b.sine),
    }
} }
lanes! { fn zero_across() -> Across {
    Across {
        duv: Vec2 { x: splat(0f32), y: splat(0f32) },
        descent: splat(0f32),
        along: splat(0f32),
        across: splat(0f32),
        mixed: splat(0f32),
        sine: splat(0f32),
    }
} }

#[derive(Clone, Copy)]
pub struct Around {
    pub columns: Vec2<I>,
    pub rows: Vec2<I>,
    pub part: Vec2<F>,
}
lanes! { fn sel_around(m: M, a: &Around, b: &Around) -> Around {
    Around {
        columns: Vec2 { x: sel_i(m, a.columns.x, b.columns.x), y: sel_i(m, a.columns.y, b.columns.y) },
        rows: Vec2 { x: sel_i(m, a.rows.x, b.rows.x), y: sel_i(m, a.rows.y, b.rows.y) },
        part: Vec2 { x: sel(m, a.part.x, b.part.x), y: sel(m, a.part.y, b.part.y) },
    }
} }
lanes! { fn zero_around() -> Around {
    Around {
        columns: Vec2 { x: splat_i(0i32), y: splat_i(0i32) },
        rows: Vec2 { x: splat_i(0i32), y: splat_i(0i32) },
        part: Vec2 { x: splat(0f32), y: splat(0f32) },
    }
} }

#[derive(Clone, Copy)]
pub struct Corner {
    pub position: Vec3<F>,
    pub normal: Vec3<F>,
    pub tangent: Vec3<F>,
    pub bitangent: Vec3<F>,
    pub uv: Vec2<F>,
    pub of_surface: Vec3<F>,
}
lanes! { fn sel_corner(m: M, a: &Corner, b: &Corner) -> Corner {
    Corner {
        position: Vec3 { x: sel(m, a.position.x, b.position.x), y: sel(m, a.position.y, b.position.y), z: sel(m, a.position.z, b.position.z) },
        normal: Vec3 { x: sel(m, a.normal.x, b.normal.x), y: sel(m, a.normal.y, b.normal.y), z: sel(m, a.normal.z, b.normal.z) },
        tangent: Vec3 { x: sel(m, a.tangent.x, b.tangent.x), y: sel(m, a.tangent.y, b.tangent.y), z: sel(m, a.tangent.z, b.tangent.z) },
        bitangent: Vec3 { x: sel(m, a.bitangent.x, b.bitangent.x), y: sel(m, a.bitangent.y, b.bitangent.y), z: sel(m, a.bitangent.z, b.bitangent.z) },
        uv: Vec2 { x: sel(m, a.uv.x, b.uv.x), y: sel(m, a.uv.y, b.uv.y) },
        of_surface: Vec3 { x: sel(m, a.of_surface.x, b.of_surface.x), y: sel(m, a.of_surface.y, b.of_surface.y), z: sel(m, a.of_surface.z, b.of_surface.z) },
    }
} }
lanes! { fn zero_corner() -> Corner {
    Corner {
        position: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        normal: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        tangent: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        bitangent: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        uv: Vec2 { x: splat(0f32), y: splat(0f32) },
        of_surface: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
    }
} }
lanes! { fn splat_corner(value: &single::Corner) -> Corner {
    Corner {
        position: Vec3 { x: splat(value.position.x), y: splat(value.position.y), z: splat(value.position.z) },
        normal: Vec3 { x: splat(value.normal.x), y: splat(value.normal.y), z: splat(value.normal.z) },
        tangent: Vec3 { x: splat(value.tangent.x), y: splat(value.tangent.y), z: splat(value.tangent.z) },
        bitangent: Vec3 { x: splat(value.bitangent.x), y: splat(value.bitangent.y), z: splat(value.bitangent.z) },
        uv: Vec2 { x: splat(value.uv.x), y: splat(value.uv.y) },
        of_surface: Vec3 { x: splat(value.of_surface.x), y: splat(value.of_surface.y), z: splat(value.of_surface.z) },
    }
} }

#[derive(Clone, Copy)]
pub struct Detail {
    pub level: U,
    pub footprint: F,
    pub fade: F,
}
lanes! { fn sel_detail(m: M, a: &Detail, b: &Detail) -> Detail {
    Detail {
        level: sel_u(m, a.level, b.level),
        footprint: sel(m, a.footprint, b.footprint),
        fade: sel(m, a.fade, b.fade),
    }
} }
lanes! { fn zero_detail() -> Detail {
    Detail {
        level: splat_u(0u32),
        footprint: splat(0f32),
        fade: splat(0f32),
    }
} }

#[derive(Clone, Copy)]
pub struct Entered {
    pub segments: U,
    pub point: Vec3<F>,
    pub uv: Vec2<F>,
    pub tangent: Vec3<F>,
    pub bitangent: Vec3<F>,
    pub normal: Vec3<F>,
    pub metric: Vec4<F>,
    pub level: U,
    pub facing: Vec3<F>,
    pub span: Vec2<F>,
    pub of_surface: Vec4<F>,
    pub footprint: F,
    pub fade: F,
    pub depth: F,
}
lanes! { fn sel_entered(m: M, a: &Entered, b: &Entered) -> Entered {
    Entered {
        segments: sel_u(m, a.segments, b.segments),
        point: Vec3 { x: sel(m, a.point.x, b.point.x), y: sel(m, a.point.y, b.point.y), z: sel(m, a.point.z, b.point.z) },
        uv: Vec2 { x: sel(m, a.uv.x, b.uv.x), y: sel(m, a.uv.y, b.uv.y) },
        tangent: Vec3 { x: sel(m, a.tangent.x, b.tangent.x), y: sel(m, a.tangent.y, b.tangent.y), z: sel(m, a.tangent.z, b.tangent.z) },
        bitangent: Vec3 { x: sel(m, a.bitangent.x, b.bitangent.x), y: sel(m, a.bitangent.y, b.bitangent.y), z: sel(m, a.bitangent.z, b.bitangent.z) },
        normal: Vec3 { x: sel(m, a.normal.x, b.normal.x), y: sel(m, a.normal.y, b.normal.y), z: sel(m, a.normal.z, b.normal.z) },
        metric: Vec4 { x: sel(m, a.metric.x, b.metric.x), y: sel(m, a.metric.y, b.metric.y), z: sel(m, a.metric.z, b.metric.z), w: sel(m, a.metric.w, b.metric.w) },
        level: sel_u(m, a.level, b.level),
        facing: Vec3 { x: sel(m, a.facing.x, b.facing.x), y: sel(m, a.facing.y, b.facing.y), z: sel(m, a.facing.z, b.facing.z) },
        span: Vec2 { x: sel(m, a.span.x, b.span.x), y: sel(m, a.span.y, b.span.y) },
        of_surface: Vec4 { x: sel(m, a.of_surface.x, b.of_surface.x), y: sel(m, a.of_surface.y, b.of_surface.y), z: sel(m, a.of_surface.z, b.of_surface.z), w: sel(m, a.of_surface.w, b.of_surface.w) },
        footprint: sel(m, a.footprint, b.footprint),
        fade: sel(m, a.fade, b.fade),
        depth: sel(m, a.depth, b.depth),
    }
} }
lanes! { fn zero_entered() -> Entered {
    Entered {
        segments: splat_u(0u32),
        point: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        uv: Vec2 { x: splat(0f32), y: splat(0f32) },
        tangent: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        bitangent: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        normal: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        metric: Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) },
        level: splat_u(0u32),
        facing: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        span: Vec2 { x: splat(0f32), y: splat(0f32) },
        of_surface: Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) },
        footprint: splat(0f32),
        fade: splat(0f32),
        depth: splat(0f32),
    }
} }

#[derive(Clone, Copy)]
pub struct FacePlace {
    pub face: I,
    pub place: Vec2<F>,
}
lanes! { fn sel_face_place(m: M, a: &FacePlace, b: &FacePlace) -> FacePlace {
    FacePlace {
        face: sel_i(m, a.face, b.face),
        place: Vec2 { x: sel(m, a.place.x, b.place.x), y: sel(m, a.place.y, b.place.y) },
    }
} }
lanes! { fn zero_face_place() -> FacePlace {
    FacePlace {
        face: splat_i(0i32),
        place: Vec2 { x: splat(0f32), y: splat(0f32) },
    }
} }

#[derive(Clone, Copy)]
pub struct Hit {
    pub found: U,
    pub exhausted: U,
    pub uv: Vec2<F>,
    pub height: F,
    pub t: F,
    pub cost: Vec3<U>,
}
lanes! { fn sel_hit(m: M, a: &Hit, b: &Hit) -> Hit {
    Hit {
        found: sel_u(m, a.found, b.found),
        exhausted: sel_u(m, a.exhausted, b.exhausted),
        uv: Vec2 { x: sel(m, a.uv.x, b.uv.x), y: sel(m, a.uv.y, b.uv.y) },
        height: sel(m, a.height, b.height),
        t: sel(m, a.t, b.t),
        cost: Vec3 { x: sel_u(m, a.cost.x, b.cost.x), y: sel_u(m, a.cost.y, b.cost.y), z: sel_u(m, a.cost.z, b.cost.z) },
    }
} }
lanes! { fn zero_hit() -> Hit {
    Hit {
        found: splat_u(0u32),
        exhausted: splat_u(0u32),
        uv: Vec2 { x: splat(0f32), y: splat(0f32) },
        height: splat(0f32),
        t: splat(0f32),
        cost: Vec3 { x: splat_u(0u32), y: splat_u(0u32), z: splat_u(0u32) },
    }
} }

#[derive(Clone, Copy)]
pub struct FirstHit {
    pub hit: Hit,
    pub segment: U,
    pub key: F,
}
lanes! { fn sel_first_hit(m: M, a: &FirstHit, b: &FirstHit) -> FirstHit {
    FirstHit {
        hit: sel_hit(m, &a.hit, &b.hit),
        segment: sel_u(m, a.segment, b.segment),
        key: sel(m, a.key, b.key),
    }
} }
lanes! { fn zero_first_hit() -> FirstHit {
    FirstHit {
        hit: zero_hit(),
        segment: splat_u(0u32),
        key: splat(0f32),
    }
} }

#[derive(Clone, Copy)]
pub struct Frames {
    pub numbers: Vec3<U>,
    pub weights: Vec3<F>,
}
lanes! { fn sel_frames(m: M, a: &Frames, b: &Frames) -> Frames {
    Frames {
        numbers: Vec3 { x: sel_u(m, a.numbers.x, b.numbers.x), y: sel_u(m, a.numbers.y, b.numbers.y), z: sel_u(m, a.numbers.z, b.numbers.z) },
        weights: Vec3 { x: sel(m, a.weights.x, b.weights.x), y: sel(m, a.weights.y, b.weights.y), z: sel(m, a.weights.z, b.weights.z) },
    }
} }
lanes! { fn zero_frames() -> Frames {
    Frames {
        numbers: Vec3 { x: splat_u(0u32), y: splat_u(0u32), z: splat_u(0u32) },
        weights: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
    }
} }

#[derive(Clone, Copy)]
pub struct Grid {
    pub origin: Vec2<F>,
    pub step: Vec2<F>,
}
lanes! { fn sel_grid(m: M, a: &Grid, b: &Grid) -> Grid {
    Grid {
        origin: Vec2 { x: sel(m, a.origin.x, b.origin.x), y: sel(m, a.origin.y, b.origin.y) },
        step: Vec2 { x: sel(m, a.step.x, b.step.x), y: sel(m, a.step.y, b.step.y) },
    }
} }
lanes! { fn zero_grid() -> Grid {
    Grid {
        origin: Vec2 { x: splat(0f32), y: splat(0f32) },
        step: Vec2 { x: splat(0f32), y: splat(0f32) },
    }
} }

#[derive(Clone, Copy)]
pub struct Image {
    pub u: Vec4<F>,
    pub v: Vec4<F>,
    pub height: Vec4<F>,
    pub depth: Vec4<F>,
    pub corner: Vec2<F>,
    pub extent: Vec2<F>,
    pub toward: Vec3<F>,
    pub has_eye: M,
    pub eye: Vec3<F>,
    pub nearest: F,
}
lanes! { fn sel_image(m: M, a: &Image, b: &Image) -> Image {
    Image {
        u: Vec4 { x: sel(m, a.u.x, b.u.x), y: sel(m, a.u.y, b.u.y), z: sel(m, a.u.z, b.u.z), w: sel(m, a.u.w, b.u.w) },
        v: Vec4 { x: sel(m, a.v.x, b.v.x), y: sel(m, a.v.y, b.v.y), z: sel(m, a.v.z, b.v.z), w: sel(m, a.v.w, b.v.w) },
        height: Vec4 { x: sel(m, a.height.x, b.height.x), y: sel(m, a.height.y, b.height.y), z: sel(m, a.height.z, b.height.z), w: sel(m, a.height.w, b.height.w) },
        depth: Vec4 { x: sel(m, a.depth.x, b.depth.x), y: sel(m, a.depth.y, b.depth.y), z: sel(m, a.depth.z, b.depth.z), w: sel(m, a.depth.w, b.depth.w) },
        corner: Vec2 { x: sel(m, a.corner.x, b.corner.x), y: sel(m, a.corner.y, b.corner.y) },
        extent: Vec2 { x: sel(m, a.extent.x, b.extent.x), y: sel(m, a.extent.y, b.extent.y) },
        toward: Vec3 { x: sel(m, a.toward.x, b.toward.x), y: sel(m, a.toward.y, b.toward.y), z: sel(m, a.toward.z, b.toward.z) },
        has_eye: sel_m(m, a.has_eye, b.has_eye),
        eye: Vec3 { x: sel(m, a.eye.x, b.eye.x), y: sel(m, a.eye.y, b.eye.y), z: sel(m, a.eye.z, b.eye.z) },
        nearest: sel(m, a.nearest, b.nearest),
    }
} }
lanes! { fn zero_image() -> Image {
    Image {
        u: Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) },
        v: Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) },
        height: Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) },
        depth: Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) },
        corner: Vec2 { x: splat(0f32), y: splat(0f32) },
        extent: Vec2 { x: splat(0f32), y: splat(0f32) },
        toward: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        has_eye: splat_m(false),
        eye: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        nearest: splat(0f32),
    }
} }

#[derive(Clone, Copy)]
pub struct Levels {
    pub fine: U,
    pub part: F,
}
lanes! { fn sel_levels(m: M, a: &Levels, b: &Levels) -> Levels {
    Levels {
        fine: sel_u(m, a.fine, b.fine),
        part: sel(m, a.part, b.part),
    }
} }
lanes! { fn zero_levels() -> Levels {
    Levels {
        fine: splat_u(0u32),
        part: splat(0f32),
    }
} }

#[derive(Clone, Copy)]
pub struct Path {
    pub uv: Vec2<F>,
    pub duv: Vec2<F>,
    pub h: Vec3<F>,
    pub exit: F,
    pub base: F,
    pub metric: Vec4<F>,
    pub ray: U,
    pub level: U,
    pub start: F,
    pub share: F,
    pub bend: F,
}
lanes! { fn sel_path(m: M, a: &Path, b: &Path) -> Path {
    Path {
        uv: Vec2 { x: sel(m, a.uv.x, b.uv.x), y: sel(m, a.uv.y, b.uv.y) },
        duv: Vec2 { x: sel(m, a.duv.x, b.duv.x), y: sel(m, a.duv.y, b.duv.y) },
        h: Vec3 { x: sel(m, a.h.x, b.h.x), y: sel(m, a.h.y, b.h.y), z: sel(m, a.h.z, b.h.z) },
        exit: sel(m, a.exit, b.exit),
        base: sel(m, a.base, b.base),
        metric: Vec4 { x: sel(m, a.metric.x, b.metric.x), y: sel(m, a.metric.y, b.metric.y), z: sel(m, a.metric.z, b.metric.z), w: sel(m, a.metric.w, b.metric.w) },
        ray: sel_u(m, a.ray, b.ray),
        level: sel_u(m, a.level, b.level),
        start: sel(m, a.start, b.start),
        share: sel(m, a.share, b.share),
        bend: sel(m, a.bend, b.bend),
    }
} }
lanes! { fn zero_path() -> Path {
    Path {
        uv: Vec2 { x: splat(0f32), y: splat(0f32) },
        duv: Vec2 { x: splat(0f32), y: splat(0f32) },
        h: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        exit: splat(0f32),
        base: splat(0f32),
        metric: Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) },
        ray: splat_u(0u32),
        level: splat_u(0u32),
        start: splat(0f32),
        share: splat(0f32),
        bend: splat(0f32),
    }
} }

#[derive(Clone, Copy)]
pub struct LightRay {
    pub state: U,
    pub path: Path,
}
lanes! { fn sel_light_ray(m: M, a: &LightRay, b: &LightRay) -> LightRay {
    LightRay {
        state: sel_u(m, a.state, b.state),
        path: sel_path(m, &a.path, &b.path),
    }
} }
lanes! { fn zero_light_ray() -> LightRay {
    LightRay {
        state: splat_u(0u32),
        path: zero_path(),
    }
} }

#[derive(Clone, Copy)]
pub struct Material {
    pub diffuse: Vec3<F>,
    pub transmitted: Vec3<F>,
    pub specular: Vec3<F>,
    pub around: Vec3<F>,
    pub emission: Vec3<F>,
    pub occlusion: F,
    pub roughness: F,
    pub alpha: F,
    pub squared_alpha: F,
    pub upright: F,
    pub masking: F,
    pub again: F,
}
lanes! { fn sel_material(m: M, a: &Material, b: &Material) -> Material {
    Material {
        diffuse: Vec3 { x: sel(m, a.diffuse.x, b.diffuse.x), y: sel(m, a.diffuse.y, b.diffuse.y), z: sel(m, a.diffuse.z, b.diffuse.z) },
        transmitted: Vec3 { x: sel(m, a.transmitted.x, b.transmitted.x), y: sel(m, a.transmitted.y, b.transmitted.y), z: sel(m, a.transmitted.z, b.transmitted.z) },
        specular: Vec3 { x: sel(m, a.specular.x, b.specular.x), y: sel(m, a.specular.y, b.specular.y), z: sel(m, a.specular.z, b.specular.z) },
        around: Vec3 { x: sel(m, a.around.x, b.around.x), y: sel(m, a.around.y, b.around.y), z: sel(m, a.around.z, b.around.z) },
        emission: Vec3 { x: sel(m, a.emission.x, b.emission.x), y: sel(m, a.emission.y, b.emission.y), z: sel(m, a.emission.z, b.emission.z) },
        occlusion: sel(m, a.occlusion, b.occlusion),
        roughness: sel(m, a.roughness, b.roughness),
        alpha: sel(m, a.alpha, b.alpha),
        squared_alpha: sel(m, a.squared_alpha, b.squared_alpha),
        upright: sel(m, a.upright, b.upright),
        masking: sel(m, a.masking, b.masking),
        again: sel(m, a.again, b.again),
    }
} }
lanes! { fn zero_material() -> Material {
    Material {
        diffuse: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        transmitted: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        specular: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        around: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        emission: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        occlusion: splat(0f32),
        roughness: splat(0f32),
        alpha: splat(0f32),
        squared_alpha: splat(0f32),
        upright: splat(0f32),
        masking: splat(0f32),
        again: splat(0f32),
    }
} }

#[derive(Clone, Copy)]
pub struct Mirrored {
    pub part: Vec3<F>,
    pub lean: F,
    pub lobes: Vec2<F>,
    pub second: F,
    pub turn: F,
}
lanes! { fn sel_mirrored(m: M, a: &Mirrored, b: &Mirrored) -> Mirrored {
    Mirrored {
        part: Vec3 { x: sel(m, a.part.x, b.part.x), y: sel(m, a.part.y, b.part.y), z: sel(m, a.part.z, b.part.z) },
        lean: sel(m, a.lean, b.lean),
        lobes: Vec2 { x: sel(m, a.lobes.x, b.lobes.x), y: sel(m, a.lobes.y, b.lobes.y) },
        second: sel(m, a.second, b.second),
        turn: sel(m, a.turn, b.turn),
    }
} }
lanes! { fn zero_mirrored() -> Mirrored {
    Mirrored {
        part: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        lean: splat(0f32),
        lobes: Vec2 { x: splat(0f32), y: splat(0f32) },
        second: splat(0f32),
        turn: splat(0f32),
    }
} }

#[derive(Clone, Copy)]
pub struct MotifPoint {
    pub normal: Vec3<F>,
    pub facet: Vec3<F>,
}
lanes! { fn sel_motif_point(m: M, a: &MotifPoint, b: &MotifPoint) -> MotifPoint {
    MotifPoint {
        normal: Vec3 { x: sel(m, a.normal.x, b.normal.x), y: sel(m, a.normal.y, b.normal.y), z: sel(m, a.normal.z, b.normal.z) },
        facet: Vec3 { x: sel(m, a.facet.x, b.facet.x), y: sel(m, a.facet.y, b.facet.y), z: sel(m, a.facet.z, b.facet.z) },
    }
} }
lanes! { fn zero_motif_point() -> MotifPoint {
    MotifPoint {
        normal: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        facet: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
    }
} }

#[derive(Clone, Copy)]
pub struct NearTriangle {
    pub triangle: U,
    pub apart: F,
}
lanes! { fn sel_near_triangle(m: M, a: &NearTriangle, b: &NearTriangle) -> NearTriangle {
    NearTriangle {
        triangle: sel_u(m, a.triangle, b.triangle),
        apart: sel(m, a.apart, b.apart),
    }
} }
lanes! { fn zero_near_triangle() -> NearTriangle {
    NearTriangle {
        triangle: splat_u(0u32),
        apart: splat(0f32),
    }
} }

#[derive(Clone, Copy)]
pub struct NormalLayers {
    pub first: Vec4<F>,
    pub second: Vec4<F>,
}
lanes! { fn sel_normal_layers(m: M, a: &NormalLayers, b: &NormalLayers) -> NormalLayers {
    NormalLayers {
        first: Vec4 { x: sel(m, a.first.x, b.first.x), y: sel(m, a.first.y, b.first.y), z: sel(m, a.first.z, b.first.z), w: sel(m, a.first.w, b.first.w) },
        second: Vec4 { x: sel(m, a.second.x, b.second.x), y: sel(m, a.second.y, b.second.y), z: sel(m, a.second.z, b.second.z), w: sel(m, a.second.w, b.second.w) },
    }
} }
lanes! { fn zero_normal_layers() -> NormalLayers {
    NormalLayers {
        first: Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) },
        second: Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) },
    }
} }

#[derive(Clone, Copy)]
pub struct Normals {
    pub first: Vec4<F>,
    pub second: Vec4<F>,
}
lanes! { fn sel_normals(m: M, a: &Normals, b: &Normals) -> Normals {
    Normals {
        first: Vec4 { x: sel(m, a.first.x, b.first.x), y: sel(m, a.first.y, b.first.y), z: sel(m, a.first.z, b.first.z), w: sel(m, a.first.w, b.first.w) },
        second: Vec4 { x: sel(m, a.second.x, b.second.x), y: sel(m, a.second.y, b.second.y), z: sel(m, a.second.z, b.second.z), w: sel(m, a.second.w, b.second.w) },
    }
} }
lanes! { fn zero_normals() -> Normals {
    Normals {
        first: Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) },
        second: Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) },
    }
} }

#[derive(Clone, Copy)]
pub struct OnImage {
    pub uv: Vec2<F>,
    pub height: F,
    pub map: F,
    pub is_inside: M,
}
lanes! { fn sel_on_image(m: M, a: &OnImage, b: &OnImage) -> OnImage {
    OnImage {
        uv: Vec2 { x: sel(m, a.uv.x, b.uv.x), y: sel(m, a.uv.y, b.uv.y) },
        height: sel(m, a.height, b.height),
        map: sel(m, a.map, b.map),
        is_inside: sel_m(m, a.is_inside, b.is_inside),
    }
} }
lanes! { fn zero_on_image() -> OnImage {
    OnImage {
        uv: Vec2 { x: splat(0f32), y: splat(0f32) },
        height: splat(0f32),
        map: splat(0f32),
        is_inside: splat_m(false),
    }
} }

#[derive(Clone, Copy)]
pub struct OnSlice {
    pub passes: M,
    pub number: U,
    pub nearest: OnImage,
    pub over: F,
}
lanes! { fn sel_on_slice(m: M, a: &OnSlice, b: &OnSlice) -> OnSlice {
    OnSlice {
        passes: sel_m(m, a.passes, b.passes),
        number: sel_u(m, a.number, b.number),
        nearest: sel_on_image(m, &a.nearest, &b.nearest),
        over: sel(m, a.over, b.over),
    }
} }
lanes! { fn zero_on_slice() -> OnSlice {
    OnSlice {
        passes: splat_m(false),
        number: splat_u(0u32),
        nearest: zero_on_image(),
        over: splat(0f32),
    }
} }

#[derive(Clone, Copy)]
pub struct Shell {
    pub heights: Vec2<F>,
    pub order: U,
    pub lift: Vec3<F>,
}
lanes! { fn sel_shell(m: M, a: &Shell, b: &Shell) -> Shell {
    Shell {
        heights: Vec2 { x: sel(m, a.heights.x, b.heights.x), y: sel(m, a.heights.y, b.heights.y) },
        order: sel_u(m, a.order, b.order),
        lift: Vec3 { x: sel(m, a.lift.x, b.lift.x), y: sel(m, a.lift.y, b.lift.y), z: sel(m, a.lift.z, b.lift.z) },
    }
} }
lanes! { fn zero_shell() -> Shell {
    Shell {
        heights: Vec2 { x: splat(0f32), y: splat(0f32) },
        order: splat_u(0u32),
        lift: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
    }
} }
lanes! { fn splat_shell(value: &single::Shell) -> Shell {
    Shell {
        heights: Vec2 { x: splat(value.heights.x), y: splat(value.heights.y) },
        order: splat_u(value.order),
        lift: Vec3 { x: splat(value.lift.x), y: splat(value.lift.y), z: splat(value.lift.z) },
    }
} }

#[derive(Clone, Copy)]
pub struct PixelIn {
    pub origin: Vec3<F>,
    pub direction: Vec3<F>,
    pub side: f32,
    pub a: single::Corner,
    pub b: single::Corner,
    pub c: single::Corner,
    pub shell: single::Shell,
}
lanes! { fn sel_pixel_in(m: M, a: &PixelIn, b: &PixelIn) -> PixelIn {
    PixelIn {
        origin: Vec3 { x: sel(m, a.origin.x, b.origin.x), y: sel(m, a.origin.y, b.origin.y), z: sel(m, a.origin.z, b.origin.z) },
        direction: Vec3 { x: sel(m, a.direction.x, b.direction.x), y: sel(m, a.direction.y, b.direction.y), z: sel(m, a.direction.z, b.direction.z) },
        side: a.side,
        a: a.a,
        b: a.b,
        c: a.c,
        shell: a.shell,
    }
} }

#[derive(Clone, Copy)]
pub struct PixelOut {
    pub color: Vec4<F>,
    pub hit: U,
    pub exhausted: U,
    pub uv: Vec2<F>,
    pub height: F,
    pub position: Vec3<F>,
    pub normal: Vec3<F>,
    pub depth: F,
    pub t: F,
    pub cell: Vec2<I>,
    pub reads: U,
    pub steps: U,
    pub bytes: U,
    pub lit: F,
    pub level: U,
    pub z: F,
    pub surface: U,
    pub transmittance: F,
}
lanes! { fn sel_pixel_out(m: M, a: &PixelOut, b: &PixelOut) -> PixelOut {
    PixelOut {
        color: Vec4 { x: sel(m, a.color.x, b.color.x), y: sel(m, a.color.y, b.color.y), z: sel(m, a.color.z, b.color.z), w: sel(m, a.color.w, b.color.w) },
        hit: sel_u(m, a.hit, b.hit),
        exhausted: sel_u(m, a.exhausted, b.exhausted),
        uv: Vec2 { x: sel(m, a.uv.x, b.uv.x), y: sel(m, a.uv.y, b.uv.y) },
        height: sel(m, a.height, b.height),
        position: Vec3 { x: sel(m, a.position.x, b.position.x), y: sel(m, a.position.y, b.position.y), z: sel(m, a.position.z, b.position.z) },
        normal: Vec3 { x: sel(m, a.normal.x, b.normal.x), y: sel(m, a.normal.y, b.normal.y), z: sel(m, a.normal.z, b.normal.z) },
        depth: sel(m, a.depth, b.depth),
        t: sel(m, a.t, b.t),
        cell: Vec2 { x: sel_i(m, a.cell.x, b.cell.x), y: sel_i(m, a.cell.y, b.cell.y) },
        reads: sel_u(m, a.reads, b.reads),
        steps: sel_u(m, a.steps, b.steps),
        bytes: sel_u(m, a.bytes, b.bytes),
        lit: sel(m, a.lit, b.lit),
        level: sel_u(m, a.level, b.level),
        z: sel(m, a.z, b.z),
        surface: sel_u(m, a.surface, b.surface),
        transmittance: sel(m, a.transmittance, b.transmittance),
    }
} }
lanes! { fn zero_pixel_out() -> PixelOut {
    PixelOut {
        color: Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) },
        hit: splat_u(0u32),
        exhausted: splat_u(0u32),
        uv: Vec2 { x: splat(0f32), y: splat(0f32) },
        height: splat(0f32),
        position: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        normal: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        depth: splat(0f32),
        t: splat(0f32),
        cell: Vec2 { x: splat_i(0i32), y: splat_i(0i32) },
        reads: splat_u(0u32),
        steps: splat_u(0u32),
        bytes: splat_u(0u32),
        lit: splat(0f32),
        level: splat_u(0u32),
        z: splat(0f32),
        surface: splat_u(0u32),
        transmittance: splat(0f32),
    }
} }

#[derive(Clone, Copy)]
pub struct Prism {
    pub p0: Vec3<F>,
    pub p1: Vec3<F>,
    pub p2: Vec3<F>,
    pub n0: Vec3<F>,
    pub n1: Vec3<F>,
    pub n2: Vec3<F>,
    pub lift: Vec3<F>,
}
lanes! { fn sel_prism(m: M, a: &Prism, b: &Prism) -> Prism {
    Prism {
        p0: Vec3 { x: sel(m, a.p0.x, b.p0.x), y: sel(m, a.p0.y, b.p0.y), z: sel(m, a.p0.z, b.p0.z) },
        p1: Vec3 { x: sel(m, a.p1.x, b.p1.x), y: sel(m, a.p1.y, b.p1.y), z: sel(m, a.p1.z, b.p1.z) },
        p2: Vec3 { x: sel(m, a.p2.x, b.p2.x), y: sel(m, a.p2.y, b.p2.y), z: sel(m, a.p2.z, b.p2.z) },
        n0: Vec3 { x: sel(m, a.n0.x, b.n0.x), y: sel(m, a.n0.y, b.n0.y), z: sel(m, a.n0.z, b.n0.z) },
        n1: Vec3 { x: sel(m, a.n1.x, b.n1.x), y: sel(m, a.n1.y, b.n1.y), z: sel(m, a.n1.z, b.n1.z) },
        n2: Vec3 { x: sel(m, a.n2.x, b.n2.x), y: sel(m, a.n2.y, b.n2.y), z: sel(m, a.n2.z, b.n2.z) },
        lift: Vec3 { x: sel(m, a.lift.x, b.lift.x), y: sel(m, a.lift.y, b.lift.y), z: sel(m, a.lift.z, b.lift.z) },
    }
} }
lanes! { fn zero_prism() -> Prism {
    Prism {
        p0: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        p1: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        p2: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        n0: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        n1: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        n2: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        lift: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
    }
} }

#[derive(Clone, Copy)]
pub struct SeenTable {
    pub mean: Vec3<F>,
    pub squares: Vec3<F>,
    pub products: Vec3<F>,
}
lanes! { fn sel_seen_table(m: M, a: &SeenTable, b: &SeenTable) -> SeenTable {
    SeenTable {
        mean: Vec3 { x: sel(m, a.mean.x, b.mean.x), y: sel(m, a.mean.y, b.mean.y), z: sel(m, a.mean.z, b.mean.z) },
        squares: Vec3 { x: sel(m, a.squares.x, b.squares.x), y: sel(m, a.squares.y, b.squares.y), z: sel(m, a.squares.z, b.squares.z) },
        products: Vec3 { x: sel(m, a.products.x, b.products.x), y: sel(m, a.products.y, b.products.y), z: sel(m, a.products.z, b.products.z) },
    }
} }
lanes! { fn zero_seen_table() -> SeenTable {
    SeenTable {
        mean: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        squares: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        products: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
    }
} }

#[derive(Clone, Copy)]
pub struct SeenNormals {
    pub normal: Vec3<F>,
    pub length: F,
    pub differ: U,
    pub middle: Vec3<F>,
    pub along: Vec3<F>,
    pub across: Vec3<F>,
    pub slope: Vec2<F>,
    pub slope_along: Vec2<F>,
    pub slope_across: Vec2<F>,
    pub upright: F,
    pub middle_seen: F,
    pub others_seen: Vec4<F>,
    pub table_part: F,
    pub table: SeenTable,
}
lanes! { fn sel_seen_normals(m: M, a: &SeenNormals, b: &SeenNormals) -> SeenNormals {
    SeenNormals {
        normal: Vec3 { x: sel(m, a.normal.x, b.normal.x), y: sel(m, a.normal.y, b.normal.y), z: sel(m, a.normal.z, b.normal.z) },
        length: sel(m, a.length, b.length),
        differ: sel_u(m, a.differ, b.differ),
        middle: Vec3 { x: sel(m, a.middle.x, b.middle.x), y: sel(m, a.middle.y, b.middle.y), z: sel(m, a.middle.z, b.middle.z) },
        along: Vec3 { x: sel(m, a.along.x, b.along.x), y: sel(m, a.along.y, b.along.y), z: sel(m, a.along.z, b.along.z) },
        across: Vec3 { x: sel(m, a.across.x, b.across.x), y: sel(m, a.across.y, b.across.y), z: sel(m, a.across.z, b.across.z) },
        slope: Vec2 { x: sel(m, a.slope.x, b.slope.x), y: sel(m, a.slope.y, b.slope.y) },
        slope_along: Vec2 { x: sel(m, a.slope_along.x, b.slope_along.x), y: sel(m, a.slope_along.y, b.slope_along.y) },
        slope_across: Vec2 { x: sel(m, a.slope_across.x, b.slope_across.x), y: sel(m, a.slope_across.y, b.slope_across.y) },
        upright: sel(m, a.upright, b.upright),
        middle_seen: sel(m, a.middle_seen, b.middle_seen),
        others_seen: Vec4 { x: sel(m, a.others_seen.x, b.others_seen.x), y: sel(m, a.others_seen.y, b.others_seen.y), z: sel(m, a.others_seen.z, b.others_seen.z), w: sel(m, a.others_seen.w, b.others_seen.w) },
        table_part: sel(m, a.table_part, b.table_part),
        table: sel_seen_table(m, &a.table, &b.table),
    }
} }
lanes! { fn zero_seen_normals() -> SeenNormals {
    SeenNormals {
        normal: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        length: splat(0f32),
        differ: splat_u(0u32),
        middle: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        along: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        across: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        slope: Vec2 { x: splat(0f32), y: splat(0f32) },
        slope_along: Vec2 { x: splat(0f32), y: splat(0f32) },
        slope_across: Vec2 { x: splat(0f32), y: splat(0f32) },
        upright: splat(0f32),
        middle_seen: splat(0f32),
        others_seen: Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) },
        table_part: splat(0f32),
        table: zero_seen_table(),
    }
} }

#[derive(Clone, Copy)]
pub struct SeenPlace {
    pub fine: Around,
    pub coarse: Around,
    pub levels: Levels,
}
lanes! { fn sel_seen_place(m: M, a: &SeenPlace, b: &SeenPlace) -> SeenPlace {
    SeenPlace {
        fine: sel_around(m, &a.fine, &b.fine),
        coarse: sel_around(m, &a.coarse, &b.coarse),
        levels: sel_levels(m, &a.levels, &b.levels),
    }
} }
lanes! { fn zero_seen_place() -> SeenPlace {
    SeenPlace {
        fine: zero_around(),
        coarse: zero_around(),
        levels: zero_levels(),
    }
} }

#[derive(Clone, Copy)]
pub struct SeenTexel {
    pub first: Vec4<F>,
    pub second: Vec4<F>,
}
lanes! { fn sel_seen_texel(m: M, a: &SeenTexel, b: &SeenTexel) -> SeenTexel {
    SeenTexel {
        first: Vec4 { x: sel(m, a.first.x, b.first.x), y: sel(m, a.first.y, b.first.y), z: sel(m, a.first.z, b.first.z), w: sel(m, a.first.w, b.first.w) },
        second: Vec4 { x: sel(m, a.second.x, b.second.x), y: sel(m, a.second.y, b.second.y), z: sel(m, a.second.z, b.second.z), w: sel(m, a.second.w, b.second.w) },
    }
} }
lanes! { fn zero_seen_texel() -> SeenTexel {
    SeenTexel {
        first: Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) },
        second: Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) },
    }
} }

#[derive(Clone, Copy)]
pub struct ShellPoint {
    pub weights: Vec3<F>,
    pub height: F,
}
lanes! { fn sel_shell_point(m: M, a: &ShellPoint, b: &ShellPoint) -> ShellPoint {
    ShellPoint {
        weights: Vec3 { x: sel(m, a.weights.x, b.weights.x), y: sel(m, a.weights.y, b.weights.y), z: sel(m, a.weights.z, b.weights.z) },
        height: sel(m, a.height, b.height),
    }
} }
lanes! { fn zero_shell_point() -> ShellPoint {
    ShellPoint {
        weights: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        height: splat(0f32),
    }
} }

#[derive(Clone, Copy)]
pub struct Tetrahedron {
    pub inside: Vec2<F>,
    pub weights: Vec4<F>,
    pub change: Vec4<F>,
}
lanes! { fn sel_tetrahedron(m: M, a: &Tetrahedron, b: &Tetrahedron) -> Tetrahedron {
    Tetrahedron {
        inside: Vec2 { x: sel(m, a.inside.x, b.inside.x), y: sel(m, a.inside.y, b.inside.y) },
        weights: Vec4 { x: sel(m, a.weights.x, b.weights.x), y: sel(m, a.weights.y, b.weights.y), z: sel(m, a.weights.z, b.weights.z), w: sel(m, a.weights.w, b.weights.w) },
        change: Vec4 { x: sel(m, a.change.x, b.change.x), y: sel(m, a.change.y, b.change.y), z: sel(m, a.change.z, b.change.z), w: sel(m, a.change.w, b.change.w) },
    }
} }
lanes! { fn zero_tetrahedron() -> Tetrahedron {
    Tetrahedron {
        inside: Vec2 { x: splat(0f32), y: splat(0f32) },
        weights: Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) },
        change: Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) },
    }
} }

#[derive(Clone, Copy)]
pub struct Toward {
    pub direction: Vec3<F>,
    pub falloff: F,
    pub distance: F,
    pub radius: F,
    pub number: U,
}
lanes! { fn sel_toward(m: M, a: &Toward, b: &Toward) -> Toward {
    Toward {
        direction: Vec3 { x: sel(m, a.direction.x, b.direction.x), y: sel(m, a.direction.y, b.direction.y), z: sel(m, a.direction.z, b.direction.z) },
        falloff: sel(m, a.falloff, b.falloff),
        distance: sel(m, a.distance, b.distance),
        radius: sel(m, a.radius, b.radius),
        number: sel_u(m, a.number, b.number),
    }
} }
lanes! { fn zero_toward() -> Toward {
    Toward {
        direction: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        falloff: splat(0f32),
        distance: splat(0f32),
        radius: splat(0f32),
        number: splat_u(0u32),
    }
} }

#[derive(Clone, Copy)]
pub struct VoxelCell {
    pub low: Vec4<F>,
    pub high: Vec4<F>,
}
lanes! { fn sel_voxel_cell(m: M, a: &VoxelCell, b: &VoxelCell) -> VoxelCell {
    VoxelCell {
        low: Vec4 { x: sel(m, a.low.x, b.low.x), y: sel(m, a.low.y, b.low.y), z: sel(m, a.low.z, b.low.z), w: sel(m, a.low.w, b.low.w) },
        high: Vec4 { x: sel(m, a.high.x, b.high.x), y: sel(m, a.high.y, b.high.y), z: sel(m, a.high.z, b.high.z), w: sel(m, a.high.w, b.high.w) },
    }
} }
lanes! { fn zero_voxel_cell() -> VoxelCell {
    VoxelCell {
        low: Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) },
        high: Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) },
    }
} }

lanes! { fn singles_corner(value: &Corner) -> [single::Corner; LANES] {
    let position = { let rows = (row(value.position.x), row(value.position.y), row(value.position.z)); std::array::from_fn::<_, LANES, _>(|lane| Vec3 { x: rows.0[lane], y: rows.1[lane], z: rows.2[lane] }) };
    let normal = { let rows = (row(value.normal.x), row(value.normal.y), row(value.normal.z)); std::array::from_fn::<_, LANES, _>(|lane| Vec3 { x: rows.0[lane], y: rows.1[lane], z: rows.2[lane] }) };
    let tangent = { let rows = (row(value.tangent.x), row(value.tangent.y), row(value.tangent.z)); std::array::from_fn::<_, LANES, _>(|lane| Vec3 { x: rows.0[lane], y: rows.1[lane], z: rows.2[lane] }) };
    let bitangent = { let rows = (row(value.bitangent.x), row(value.bitangent.y), row(value.bitangent.z)); std::array::from_fn::<_, LANES, _>(|lane| Vec3 { x: rows.0[lane], y: rows.1[lane], z: rows.2[lane] }) };
    let uv = { let rows = (row(value.uv.x), row(value.uv.y)); std::array::from_fn::<_, LANES, _>(|lane| Vec2 { x: rows.0[lane], y: rows.1[lane] }) };
    let of_surface = { let rows = (row(value.of_surface.x), row(value.of_surface.y), row(value.of_surface.z)); std::array::from_fn::<_, LANES, _>(|lane| Vec3 { x: rows.0[lane], y: rows.1[lane], z: rows.2[lane] }) };
    std::array::from_fn(|lane| single::Corner { position: position[lane], normal: normal[lane], tangent: tangent[lane], bitangent: bitangent[lane], uv: uv[lane], of_surface: of_surface[lane], })
} }
lanes! { fn lanes_of_corner(values: &[single::Corner; LANES]) -> Corner {
    let position = std::array::from_fn::<_, LANES, _>(|lane| values[lane].position);
    let position_of_all = Vec3 { x: load(&std::array::from_fn(|lane| position[lane].x)), y: load(&std::array::from_fn(|lane| position[lane].y)), z: load(&std::array::from_fn(|lane| position[lane].z)) };
    let normal = std::array::from_fn::<_, LANES, _>(|lane| values[lane].normal);
    let normal_of_all = Vec3 { x: load(&std::array::from_fn(|lane| normal[lane].x)), y: load(&std::array::from_fn(|lane| normal[lane].y)), z: load(&std::array::from_fn(|lane| normal[lane].z)) };
    let tangent = std::array::from_fn::<_, LANES, _>(|lane| values[lane].tangent);
    let tangent_of_all = Vec3 { x: load(&std::array::from_fn(|lane| tangent[lane].x)), y: load(&std::array::from_fn(|lane| tangent[lane].y)), z: load(&std::array::from_fn(|lane| tangent[lane].z)) };
    let bitangent = std::array::from_fn::<_, LANES, _>(|lane| values[lane].bitangent);
    let bitangent_of_all = Vec3 { x: load(&std::array::from_fn(|lane| bitangent[lane].x)), y: load(&std::array::from_fn(|lane| bitangent[lane].y)), z: load(&std::array::from_fn(|lane| bitangent[lane].z)) };
    let uv = std::array::from_fn::<_, LANES, _>(|lane| values[lane].uv);
    let uv_of_all = Vec2 { x: load(&std::array::from_fn(|lane| uv[lane].x)), y: load(&std::array::from_fn(|lane| uv[lane].y)) };
    let of_surface = std::array::from_fn::<_, LANES, _>(|lane| values[lane].of_surface);
    let of_surface_of_all = Vec3 { x: load(&std::array::from_fn(|lane| of_surface[lane].x)), y: load(&std::array::from_fn(|lane| of_surface[lane].y)), z: load(&std::array::from_fn(|lane| of_surface[lane].z)) };
    Corner { position: position_of_all, normal: normal_of_all, tangent: tangent_of_all, bitangent: bitangent_of_all, uv: uv_of_all, of_surface: of_surface_of_all }
} }

lanes! { fn singles_entered(value: &Entered) -> [single::Entered; LANES] {
    let segments = row_u(value.segments);
    let point = { let rows = (row(value.point.x), row(value.point.y), row(value.point.z)); std::array::from_fn::<_, LANES, _>(|lane| Vec3 { x: rows.0[lane], y: rows.1[lane], z: rows.2[lane] }) };
    let uv = { let rows = (row(value.uv.x), row(value.uv.y)); std::array::from_fn::<_, LANES, _>(|lane| Vec2 { x: rows.0[lane], y: rows.1[lane] }) };
    let tangent = { let rows = (row(value.tangent.x), row(value.tangent.y), row(value.tangent.z)); std::array::from_fn::<_, LANES, _>(|lane| Vec3 { x: rows.0[lane], y: rows.1[lane], z: rows.2[lane] }) };
    let bitangent = { let rows = (row(value.bitangent.x), row(value.bitangent.y), row(value.bitangent.z)); std::array::from_fn::<_, LANES, _>(|lane| Vec3 { x: rows.0[lane], y: rows.1[lane], z: rows.2[lane] }) };
    let normal = { let rows = (row(value.normal.x), row(value.normal.y), row(value.normal.z)); std::array::from_fn::<_, LANES, _>(|lane| Vec3 { x: rows.0[lane], y: rows.1[lane], z: rows.2[lane] }) };
    let metric = { let rows = (row(value.metric.x), row(value.metric.y), row(value.metric.z), row(value.metric.w)); std::array::from_fn::<_, LANES, _>(|lane| Vec4 { x: rows.0[lane], y: rows.1[lane], z: rows.2[lane], w: rows.3[lane] }) };
    let level = row_u(value.level);
    let facing = { let rows = (row(value.facing.x), row(value.facing.y), row(value.facing.z)); std::array::from_fn::<_, LANES, _>(|lane| Vec3 { x: rows.0[lane], y: rows.1[lane], z: rows.2[lane] }) };
    let span = { let rows = (row(value.span.x), row(value.span.y)); std::array::from_fn::<_, LANES, _>(|lane| Vec2 { x: rows.0[lane], y: rows.1[lane] }) };
    let of_surface = { let rows = (row(value.of_surface.x), row(value.of_surface.y), row(value.of_surface.z), row(value.of_surface.w)); std::array::from_fn::<_, LANES, _>(|lane| Vec4 { x: rows.0[lane], y: rows.1[lane], z: rows.2[lane], w: rows.3[lane] }) };
    let footprint = row(value.footprint);
    let fade = row(value.fade);
    let depth = row(value.depth);
    std::array::from_fn(|lane| single::Entered { segments: segments[lane], point: point[lane], uv: uv[lane], tangent: tangent[lane], bitangent: bitangent[lane], normal: normal[lane], metric: metric[lane], level: level[lane], facing: facing[lane], span: span[lane], of_surface: of_surface[lane], footprint: footprint[lane], fade: fade[lane], depth: depth[lane], })
} }
lanes! { fn lanes_of_entered(values: &[single::Entered; LANES]) -> Entered {
    let segments = std::array::from_fn::<_, LANES, _>(|lane| values[lane].segments);
    let segments_of_all = load_u(&std::array::from_fn(|lane| segments[lane]));
    let point = std::array::from_fn::<_, LANES, _>(|lane| values[lane].point);
    let point_of_all = Vec3 { x: load(&std::array::from_fn(|lane| point[lane].x)), y: load(&std::array::from_fn(|lane| point[lane].y)), z: load(&std::array::from_fn(|lane| point[lane].z)) };
    let uv = std::array::from_fn::<_, LANES, _>(|lane| values[lane].uv);
    let uv_of_all = Vec2 { x: load(&std::array::from_fn(|lane| uv[lane].x)), y: load(&std::array::from_fn(|lane| uv[lane].y)) };
    let tangent = std::array::from_fn::<_, LANES, _>(|lane| values[lane].tangent);
    let tangent_of_all = Vec3 { x: load(&std::array::from_fn(|lane| tangent[lane].x)), y: load(&std::array::from_fn(|lane| tangent[lane].y)), z: load(&std::array::from_fn(|lane| tangent[lane].z)) };
    let bitangent = std::array::from_fn::<_, LANES, _>(|lane| values[lane].bitangent);
    let bitangent_of_all = Vec3 { x: load(&std::array::from_fn(|lane| bitangent[lane].x)), y: load(&std::array::from_fn(|lane| bitangent[lane].y)), z: load(&std::array::from_fn(|lane| bitangent[lane].z)) };
    let normal = std::array::from_fn::<_, LANES, _>(|lane| values[lane].normal);
    let normal_of_all = Vec3 { x: load(&std::array::from_fn(|lane| normal[lane].x)), y: load(&std::array::from_fn(|lane| normal[lane].y)), z: load(&std::array::from_fn(|lane| normal[lane].z)) };
    let metric = std::array::from_fn::<_, LANES, _>(|lane| values[lane].metric);
    let metric_of_all = Vec4 { x: load(&std::array::from_fn(|lane| metric[lane].x)), y: load(&std::array::from_fn(|lane| metric[lane].y)), z: load(&std::array::from_fn(|lane| metric[lane].z)), w: load(&std::array::from_fn(|lane| metric[lane].w)) };
    let level = std::array::from_fn::<_, LANES, _>(|lane| values[lane].level);
    let level_of_all = load_u(&std::array::from_fn(|lane| level[lane]));
    let facing = std::array::from_fn::<_, LANES, _>(|lane| values[lane].facing);
    let facing_of_all = Vec3 { x: load(&std::array::from_fn(|lane| facing[lane].x)), y: load(&std::array::from_fn(|lane| facing[lane].y)), z: load(&std::array::from_fn(|lane| facing[lane].z)) };
    let span = std::array::from_fn::<_, LANES, _>(|lane| values[lane].span);
    let span_of_all = Vec2 { x: load(&std::array::from_fn(|lane| span[lane].x)), y: load(&std::array::from_fn(|lane| span[lane].y)) };
    let of_surface = std::array::from_fn::<_, LANES, _>(|lane| values[lane].of_surface);
    let of_surface_of_all = Vec4 { x: load(&std::array::from_fn(|lane| of_surface[lane].x)), y: load(&std::array::from_fn(|lane| of_surface[lane].y)), z: load(&std::array::from_fn(|lane| of_surface[lane].z)), w: load(&std::array::from_fn(|lane| of_surface[lane].w)) };
    let footprint = std::array::from_fn::<_, LANES, _>(|lane| values[lane].footprint);
    let footprint_of_all = load(&std::array::from_fn(|lane| footprint[lane]));
    let fade = std::array::from_fn::<_, LANES, _>(|lane| values[lane].fade);
    let fade_of_all = load(&std::array::from_fn(|lane| fade[lane]));
    let depth = std::array::from_fn::<_, LANES, _>(|lane| values[lane].depth);
    let depth_of_all = load(&std::array::from_fn(|lane| depth[lane]));
    Entered { segments: segments_of_all, point: point_of_all, uv: uv_of_all, tangent: tangent_of_all, bitangent: bitangent_of_all, normal: normal_of_all, metric: metric_of_all, level: level_of_all, facing: facing_of_all, span: span_of_all, of_surface: of_surface_of_all, footprint: footprint_of_all, fade: fade_of_all, depth: depth_of_all }
} }

lanes! { fn singles_hit(value: &Hit) -> [single::Hit; LANES] {
    let found = row_u(value.found);
    let exhausted = row_u(value.exhausted);
    let uv = { let rows = (row(value.uv.x), row(value.uv.y)); std::array::from_fn::<_, LANES, _>(|lane| Vec2 { x: rows.0[lane], y: rows.1[lane] }) };
    let height = row(value.height);
    let t = row(value.t);
    let cost = { let rows = (row_u(value.cost.x), row_u(value.cost.y), row_u(value.cost.z)); std::array::from_fn::<_, LANES, _>(|lane| Vec3 { x: rows.0[lane], y: rows.1[lane], z: rows.2[lane] }) };
    std::array::from_fn(|lane| single::Hit { found: found[lane], exhausted: exhausted[lane], uv: uv[lane], height: height[lane], t: t[lane], cost: cost[lane], })
} }
lanes! { fn lanes_of_hit(values: &[single::Hit; LANES]) -> Hit {
    let found = std::array::from_fn::<_, LANES, _>(|lane| values[lane].found);
    let found_of_all = load_u(&std::array::from_fn(|lane| found[lane]));
    let exhausted = std::array::from_fn::<_, LANES, _>(|lane| values[lane].exhausted);
    let exhausted_of_all = load_u(&std::array::from_fn(|lane| exhausted[lane]));
    let uv = std::array::from_fn::<_, LANES, _>(|lane| values[lane].uv);
    let uv_of_all = Vec2 { x: load(&std::array::from_fn(|lane| uv[lane].x)), y: load(&std::array::from_fn(|lane| uv[lane].y)) };
    let height = std::array::from_fn::<_, LANES, _>(|lane| values[lane].height);
    let height_of_all = load(&std::array::from_fn(|lane| height[lane]));
    let t = std::array::from_fn::<_, LANES, _>(|lane| values[lane].t);
    let t_of_all = load(&std::array::from_fn(|lane| t[lane]));
    let cost = std::array::from_fn::<_, LANES, _>(|lane| values[lane].cost);
    let cost_of_all = Vec3 { x: load_u(&std::array::from_fn(|lane| cost[lane].x)), y: load_u(&std::array::from_fn(|lane| cost[lane].y)), z: load_u(&std::array::from_fn(|lane| cost[lane].z)) };
    Hit { found: found_of_all, exhausted: exhausted_of_all, uv: uv_of_all, height: height_of_all, t: t_of_all, cost: cost_of_all }
} }

lanes! { fn singles_path(value: &Path) -> [single::Path; LANES] {
    let uv = { let rows = (row(value.uv.x), row(value.uv.y)); std::array::from_fn::<_, LANES, _>(|lane| Vec2 { x: rows.0[lane], y: rows.1[lane] }) };
    let duv = { let rows = (row(value.duv.x), row(value.duv.y)); std::array::from_fn::<_, LANES, _>(|lane| Vec2 { x: rows.0[lane], y: rows.1[lane] }) };
    let h = { let rows = (row(value.h.x), row(value.h.y), row(value.h.z)); std::array::from_fn::<_, LANES, _>(|lane| Vec3 { x: rows.0[lane], y: rows.1[lane], z: rows.2[lane] }) };
    let exit = row(value.exit);
    let base = row(value.base);
    let metric = { let rows = (row(value.metric.x), row(value.metric.y), row(value.metric.z), row(value.metric.w)); std::array::from_fn::<_, LANES, _>(|lane| Vec4 { x: rows.0[lane], y: rows.1[lane], z: rows.2[lane], w: rows.3[lane] }) };
    let ray = row_u(value.ray);
    let level = row_u(value.level);
    let start = row(value.start);
    let share = row(value.share);
    let bend = row(value.bend);
    std::array::from_fn(|lane| single::Path { uv: uv[lane], duv: duv[lane], h: h[lane], exit: exit[lane], base: base[lane], metric: metric[lane], ray: ray[lane], level: level[lane], start: start[lane], share: share[lane], bend: bend[lane], })
} }
lanes! { fn lanes_of_path(values: &[single::Path; LANES]) -> Path {
    let uv = std::array::from_fn::<_, LANES, _>(|lane| values[lane].uv);
    let uv_of_all = Vec2 { x: load(&std::array::from_fn(|lane| uv[lane].x)), y: load(&std::array::from_fn(|lane| uv[lane].y)) };
    let duv = std::array::from_fn::<_, LANES, _>(|lane| values[lane].duv);
    let duv_of_all = Vec2 { x: load(&std::array::from_fn(|lane| duv[lane].x)), y: load(&std::array::from_fn(|lane| duv[lane].y)) };
    let h = std::array::from_fn::<_, LANES, _>(|lane| values[lane].h);
    let h_of_all = Vec3 { x: load(&std::array::from_fn(|lane| h[lane].x)), y: load(&std::array::from_fn(|lane| h[lane].y)), z: load(&std::array::from_fn(|lane| h[lane].z)) };
    let exit = std::array::from_fn::<_, LANES, _>(|lane| values[lane].exit);
    let exit_of_all = load(&std::array::from_fn(|lane| exit[lane]));
    let base = std::array::from_fn::<_, LANES, _>(|lane| values[lane].base);
    let base_of_all = load(&std::array::from_fn(|lane| base[lane]));
    let metric = std::array::from_fn::<_, LANES, _>(|lane| values[lane].metric);
    let metric_of_all = Vec4 { x: load(&std::array::from_fn(|lane| metric[lane].x)), y: load(&std::array::from_fn(|lane| metric[lane].y)), z: load(&std::array::from_fn(|lane| metric[lane].z)), w: load(&std::array::from_fn(|lane| metric[lane].w)) };
    let ray = std::array::from_fn::<_, LANES, _>(|lane| values[lane].ray);
    let ray_of_all = load_u(&std::array::from_fn(|lane| ray[lane]));
    let level = std::array::from_fn::<_, LANES, _>(|lane| values[lane].level);
    let level_of_all = load_u(&std::array::from_fn(|lane| level[lane]));
    let start = std::array::from_fn::<_, LANES, _>(|lane| values[lane].start);
    let start_of_all = load(&std::array::from_fn(|lane| start[lane]));
    let share = std::array::from_fn::<_, LANES, _>(|lane| values[lane].share);
    let share_of_all = load(&std::array::from_fn(|lane| share[lane]));
    let bend = std::array::from_fn::<_, LANES, _>(|lane| values[lane].bend);
    let bend_of_all = load(&std::array::from_fn(|lane| bend[lane]));
    Path { uv: uv_of_all, duv: duv_of_all, h: h_of_all, exit: exit_of_all, base: base_of_all, metric: metric_of_all, ray: ray_of_all, level: level_of_all, start: start_of_all, share: share_of_all, bend: bend_of_all }
} }

lanes! { fn singles_shell(value: &Shell) -> [single::Shell; LANES] {
    let heights = { let rows = (row(value.heights.x), row(value.heights.y)); std::array::from_fn::<_, LANES, _>(|lane| Vec2 { x: rows.0[lane], y: rows.1[lane] }) };
    let order = row_u(value.order);
    let lift = { let rows = (row(value.lift.x), row(value.lift.y), row(value.lift.z)); std::array::from_fn::<_, LANES, _>(|lane| Vec3 { x: rows.0[lane], y: rows.1[lane], z: rows.2[lane] }) };
    std::array::from_fn(|lane| single::Shell { heights: heights[lane], order: order[lane], lift: lift[lane], })
} }
lanes! { fn lanes_of_shell(values: &[single::Shell; LANES]) -> Shell {
    let heights = std::array::from_fn::<_, LANES, _>(|lane| values[lane].heights);
    let heights_of_all = Vec2 { x: load(&std::array::from_fn(|lane| heights[lane].x)), y: load(&std::array::from_fn(|lane| heights[lane].y)) };
    let order = std::array::from_fn::<_, LANES, _>(|lane| values[lane].order);
    let order_of_all = load_u(&std::array::from_fn(|lane| order[lane]));
    let lift = std::array::from_fn::<_, LANES, _>(|lane| values[lane].lift);
    let lift_of_all = Vec3 { x: load(&std::array::from_fn(|lane| lift[lane].x)), y: load(&std::array::from_fn(|lane| lift[lane].y)), z: load(&std::array::from_fn(|lane| lift[lane].z)) };
    Shell { heights: heights_of_all, order: order_of_all, lift: lift_of_all }
} }

lanes! { fn singles_pixel_in(value: &PixelIn) -> [single::PixelIn; LANES] {
    let origin = { let rows = (row(value.origin.x), row(value.origin.y), row(value.origin.z)); std::array::from_fn::<_, LANES, _>(|lane| Vec3 { x: rows.0[lane], y: rows.1[lane], z: rows.2[lane] }) };
    let direction = { let rows = (row(value.direction.x), row(value.direction.y), row(value.direction.z)); std::array::from_fn::<_, LANES, _>(|lane| Vec3 { x: rows.0[lane], y: rows.1[lane], z: rows.2[lane] }) };
    std::array::from_fn(|lane| single::PixelIn { origin: origin[lane], direction: direction[lane], side: value.side, a: value.a, b: value.b, c: value.c, shell: value.shell, })
} }
lanes! { fn lanes_of_pixel_in(values: &[single::PixelIn; LANES]) -> PixelIn {
    let origin = std::array::from_fn::<_, LANES, _>(|lane| values[lane].origin);
    let origin_of_all = Vec3 { x: load(&std::array::from_fn(|lane| origin[lane].x)), y: load(&std::array::from_fn(|lane| origin[lane].y)), z: load(&std::array::from_fn(|lane| origin[lane].z)) };
    let direction = std::array::from_fn::<_, LANES, _>(|lane| values[lane].direction);
    let direction_of_all = Vec3 { x: load(&std::array::from_fn(|lane| direction[lane].x)), y: load(&std::array::from_fn(|lane| direction[lane].y)), z: load(&std::array::from_fn(|lane| direction[lane].z)) };
    PixelIn { origin: origin_of_all, direction: direction_of_all, side: values[0].side, a: values[0].a, b: values[0].b, c: values[0].c, shell: values[0].shell }
} }

lanes! { fn singles_toward(value: &Toward) -> [single::Toward; LANES] {
    let direction = { let rows = (row(value.direction.x), row(value.direction.y), row(value.direction.z)); std::array::from_fn::<_, LANES, _>(|lane| Vec3 { x: rows.0[lane], y: rows.1[lane], z: rows.2[lane] }) };
    let falloff = row(value.falloff);
    let distance = row(value.distance);
    let radius = row(value.radius);
    let number = row_u(value.number);
    std::array::from_fn(|lane| single::Toward { direction: direction[lane], falloff: falloff[lane], distance: distance[lane], radius: radius[lane], number: number[lane], })
} }
lanes! { fn lanes_of_toward(values: &[single::Toward; LANES]) -> Toward {
    let direction = std::array::from_fn::<_, LANES, _>(|lane| values[lane].direction);
    let direction_of_all = Vec3 { x: load(&std::array::from_fn(|lane| direction[lane].x)), y: load(&std::array::from_fn(|lane| direction[lane].y)), z: load(&std::array::from_fn(|lane| direction[lane].z)) };
    let falloff = std::array::from_fn::<_, LANES, _>(|lane| values[lane].falloff);
    let falloff_of_all = load(&std::array::from_fn(|lane| falloff[lane]));
    let distance = std::array::from_fn::<_, LANES, _>(|lane| values[lane].distance);
    let distance_of_all = load(&std::array::from_fn(|lane| distance[lane]));
    let radius = std::array::from_fn::<_, LANES, _>(|lane| values[lane].radius);
    let radius_of_all = load(&std::array::from_fn(|lane| radius[lane]));
    let number = std::array::from_fn::<_, LANES, _>(|lane| values[lane].number);
    let number_of_all = load_u(&std::array::from_fn(|lane| number[lane]));
    Toward { direction: direction_of_all, falloff: falloff_of_all, distance: distance_of_all, radius: radius_of_all, number: number_of_all }
} }

lanes! { pub fn load_path(block: &PathBlock, part: usize) -> Path {
    Path {
        uv: Vec2 { x: load(&block.uv[0].as_chunks().0[part]), y: load(&block.uv[1].as_chunks().0[part]) },
        duv: Vec2 { x: load(&block.duv[0].as_chunks().0[part]), y: load(&block.duv[1].as_chunks().0[part]) },
        h: Vec3 { x: load(&block.h[0].as_chunks().0[part]), y: load(&block.h[1].as_chunks().0[part]), z: load(&block.h[2].as_chunks().0[part]) },
        exit: load(&block.exit.as_chunks().0[part]),
        base: load(&block.base.as_chunks().0[part]),
        metric: Vec4 { x: load(&block.metric[0].as_chunks().0[part]), y: load(&block.metric[1].as_chunks().0[part]), z: load(&block.metric[2].as_chunks().0[part]), w: load(&block.metric[3].as_chunks().0[part]) },
        ray: load_u(&block.ray.as_chunks().0[part]),
        level: load_u(&block.level.as_chunks().0[part]),
        start: load(&block.start.as_chunks().0[part]),
        share: load(&block.share.as_chunks().0[part]),
        bend: load(&block.bend.as_chunks().0[part]),
    }
} }
lanes! { pub fn store_path(block: &mut PathBlock, part: usize, which: M, value: &Path) {
    store(&mut block.uv[0].as_chunks_mut().0[part], which, value.uv.x);
    store(&mut block.uv[1].as_chunks_mut().0[part], which, value.uv.y);
    store(&mut block.duv[0].as_chunks_mut().0[part], which, value.duv.x);
    store(&mut block.duv[1].as_chunks_mut().0[part], which, value.duv.y);
    store(&mut block.h[0].as_chunks_mut().0[part], which, value.h.x);
    store(&mut block.h[1].as_chunks_mut().0[part], which, value.h.y);
    store(&mut block.h[2].as_chunks_mut().0[part], which, value.h.z);
    store(&mut block.exit.as_chunks_mut().0[part], which, value.exit);
    store(&mut block.base.as_chunks_mut().0[part], which, value.base);
    store(&mut block.metric[0].as_chunks_mut().0[part], which, value.metric.x);
    store(&mut block.metric[1].as_chunks_mut().0[part], which, value.metric.y);
    store(&mut block.metric[2].as_chunks_mut().0[part], which, value.metric.z);
    store(&mut block.metric[3].as_chunks_mut().0[part], which, value.metric.w);
    store_u(&mut block.ray.as_chunks_mut().0[part], which, value.ray);
    store_u(&mut block.level.as_chunks_mut().0[part], which, value.level);
    store(&mut block.start.as_chunks_mut().0[part], which, value.start);
    store(&mut block.share.as_chunks_mut().0[part], which, value.share);
    store(&mut block.bend.as_chunks_mut().0[part], which, value.bend);
} }

lanes! { pub fn load_hit(block: &HitBlock, part: usize) -> Hit {
    Hit {
        found: load_u(&block.found.as_chunks().0[part]),
        exhausted: load_u(&block.exhausted.as_chunks().0[part]),
        uv: Vec2 { x: load(&block.uv[0].as_chunks().0[part]), y: load(&block.uv[1].as_chunks().0[part]) },
        height: load(&block.height.as_chunks().0[part]),
        t: load(&block.t.as_chunks().0[part]),
        cost: Vec3 { x: load_u(&block.cost[0].as_chunks().0[part]), y: load_u(&block.cost[1].as_chunks().0[part]), z: load_u(&block.cost[2].as_chunks().0[part]) },
    }
} }
lanes! { pub fn store_hit(block: &mut HitBlock, part: usize, which: M, value: &Hit) {
    store_u(&mut block.found.as_chunks_mut().0[part], which, value.found);
    store_u(&mut block.exhausted.as_chunks_mut().0[part], which, value.exhausted);
    store(&mut block.uv[0].as_chunks_mut().0[part], which, value.uv.x);
    store(&mut block.uv[1].as_chunks_mut().0[part], which, value.uv.y);
    store(&mut block.height.as_chunks_mut().0[part], which, value.height);
    store(&mut block.t.as_chunks_mut().0[part], which, value.t);
    store_u(&mut block.cost[0].as_chunks_mut().0[part], which, value.cost.x);
    store_u(&mut block.cost[1].as_chunks_mut().0[part], which, value.cost.y);
    store_u(&mut block.cost[2].as_chunks_mut().0[part], which, value.cost.z);
} }

lanes! { pub fn load_entered(block: &EnteredBlock, part: usize) -> Entered {
    Entered {
        segments: load_u(&block.segments.as_chunks().0[part]),
        point: Vec3 { x: load(&block.point[0].as_chunks().0[part]), y: load(&block.point[1].as_chunks().0[part]), z: load(&block.point[2].as_chunks().0[part]) },
        uv: Vec2 { x: load(&block.uv[0].as_chunks().0[part]), y: load(&block.uv[1].as_chunks().0[part]) },
        tangent: Vec3 { x: load(&block.tangent[0].as_chunks().0[part]), y: load(&block.tangent[1].as_chunks().0[part]), z: load(&block.tangent[2].as_chunks().0[part]) },
        bitangent: Vec3 { x: load(&block.bitangent[0].as_chunks().0[part]), y: load(&block.bitangent[1].as_chunks().0[part]), z: load(&block.bitangent[2].as_chunks().0[part]) },
        normal: Vec3 { x: load(&block.normal[0].as_chunks().0[part]), y: load(&block.normal[1].as_chunks().0[part]), z: load(&block.normal[2].as_chunks().0[part]) },
        metric: Vec4 { x: load(&block.metric[0].as_chunks().0[part]), y: load(&block.metric[1].as_chunks().0[part]), z: load(&block.metric[2].as_chunks().0[part]), w: load(&block.metric[3].as_chunks().0[part]) },
        level: load_u(&block.level.as_chunks().0[part]),
        facing: Vec3 { x: load(&block.facing[0].as_chunks().0[part]), y: load(&block.facing[1].as_chunks().0[part]), z: load(&block.facing[2].as_chunks().0[part]) },
        span: Vec2 { x: load(&block.span[0].as_chunks().0[part]), y: load(&block.span[1].as_chunks().0[part]) },
        of_surface: Vec4 { x: load(&block.of_surface[0].as_chunks().0[part]), y: load(&block.of_surface[1].as_chunks().0[part]), z: load(&block.of_surface[2].as_chunks().0[part]), w: load(&block.of_surface[3].as_chunks().0[part]) },
        footprint: load(&block.footprint.as_chunks().0[part]),
        fade: load(&block.fade.as_chunks().0[part]),
        depth: load(&block.depth.as_chunks().0[part]),
    }
} }
lanes! { pub fn store_entered(block: &mut EnteredBlock, part: usize, which: M, value: &Entered) {
    store_u(&mut block.segments.as_chunks_mut().0[part], which, value.segments);
    store(&mut block.point[0].as_chunks_mut().0[part], which, value.point.x);
    store(&mut block.point[1].as_chunks_mut().0[part], which, value.point.y);
    store(&mut block.point[2].as_chunks_mut().0[part], which, value.point.z);
    store(&mut block.uv[0].as_chunks_mut().0[part], which, value.uv.x);
    store(&mut block.uv[1].as_chunks_mut().0[part], which, value.uv.y);
    store(&mut block.tangent[0].as_chunks_mut().0[part], which, value.tangent.x);
    store(&mut block.tangent[1].as_chunks_mut().0[part], which, value.tangent.y);
    store(&mut block.tangent[2].as_chunks_mut().0[part], which, value.tangent.z);
    store(&mut block.bitangent[0].as_chunks_mut().0[part], which, value.bitangent.x);
    store(&mut block.bitangent[1].as_chunks_mut().0[part], which, value.bitangent.y);
    store(&mut block.bitangent[2].as_chunks_mut().0[part], which, value.bitangent.z);
    store(&mut block.normal[0].as_chunks_mut().0[part], which, value.normal.x);
    store(&mut block.normal[1].as_chunks_mut().0[part], which, value.normal.y);
    store(&mut block.normal[2].as_chunks_mut().0[part], which, value.normal.z);
    store(&mut block.metric[0].as_chunks_mut().0[part], which, value.metric.x);
    store(&mut block.metric[1].as_chunks_mut().0[part], which, value.metric.y);
    store(&mut block.metric[2].as_chunks_mut().0[part], which, value.metric.z);
    store(&mut block.metric[3].as_chunks_mut().0[part], which, value.metric.w);
    store_u(&mut block.level.as_chunks_mut().0[part], which, value.level);
    store(&mut block.facing[0].as_chunks_mut().0[part], which, value.facing.x);
    store(&mut block.facing[1].as_chunks_mut().0[part], which, value.facing.y);
    store(&mut block.facing[2].as_chunks_mut().0[part], which, value.facing.z);
    store(&mut block.span[0].as_chunks_mut().0[part], which, value.span.x);
    store(&mut block.span[1].as_chunks_mut().0[part], which, value.span.y);
    store(&mut block.of_surface[0].as_chunks_mut().0[part], which, value.of_surface.x);
    store(&mut block.of_surface[1].as_chunks_mut().0[part], which, value.of_surface.y);
    store(&mut block.of_surface[2].as_chunks_mut().0[part], which, value.of_surface.z);
    store(&mut block.of_surface[3].as_chunks_mut().0[part], which, value.of_surface.w);
    store(&mut block.footprint.as_chunks_mut().0[part], which, value.footprint);
    store(&mut block.fade.as_chunks_mut().0[part], which, value.fade);
    store(&mut block.depth.as_chunks_mut().0[part], which, value.depth);
} }

lanes! { pub fn load_pixel_out(block: &PixelOutBlock, part: usize) -> PixelOut {
    PixelOut {
        color: Vec4 { x: load(&block.color[0].as_chunks().0[part]), y: load(&block.color[1].as_chunks().0[part]), z: load(&block.color[2].as_chunks().0[part]), w: load(&block.color[3].as_chunks().0[part]) },
        hit: load_u(&block.hit.as_chunks().0[part]),
        exhausted: load_u(&block.exhausted.as_chunks().0[part]),
        uv: Vec2 { x: load(&block.uv[0].as_chunks().0[part]), y: load(&block.uv[1].as_chunks().0[part]) },
        height: load(&block.height.as_chunks().0[part]),
        position: Vec3 { x: load(&block.position[0].as_chunks().0[part]), y: load(&block.position[1].as_chunks().0[part]), z: load(&block.position[2].as_chunks().0[part]) },
        normal: Vec3 { x: load(&block.normal[0].as_chunks().0[part]), y: load(&block.normal[1].as_chunks().0[part]), z: load(&block.normal[2].as_chunks().0[part]) },
        depth: load(&block.depth.as_chunks().0[part]),
        t: load(&block.t.as_chunks().0[part]),
        cell: Vec2 { x: load_i(&block.cell[0].as_chunks().0[part]), y: load_i(&block.cell[1].as_chunks().0[part]) },
        reads: load_u(&block.reads.as_chunks().0[part]),
        steps: load_u(&block.steps.as_chunks().0[part]),
        bytes: load_u(&block.bytes.as_chunks().0[part]),
        lit: load(&block.lit.as_chunks().0[part]),
        level: load_u(&block.level.as_chunks().0[part]),
        z: load(&block.z.as_chunks().0[part]),
        surface: load_u(&block.surface.as_chunks().0[part]),
        transmittance: load(&block.transmittance.as_chunks().0[part]),
    }
} }
lanes! { pub fn store_pixel_out(block: &mut PixelOutBlock, part: usize, which: M, value: &PixelOut) {
    store(&mut block.color[0].as_chunks_mut().0[part], which, value.color.x);
    store(&mut block.color[1].as_chunks_mut().0[part], which, value.color.y);
    store(&mut block.color[2].as_chunks_mut().0[part], which, value.color.z);
    store(&mut block.color[3].as_chunks_mut().0[part], which, value.color.w);
    store_u(&mut block.hit.as_chunks_mut().0[part], which, value.hit);
    store_u(&mut block.exhausted.as_chunks_mut().0[part], which, value.exhausted);
    store(&mut block.uv[0].as_chunks_mut().0[part], which, value.uv.x);
    store(&mut block.uv[1].as_chunks_mut().0[part], which, value.uv.y);
    store(&mut block.height.as_chunks_mut().0[part], which, value.height);
    store(&mut block.position[0].as_chunks_mut().0[part], which, value.position.x);
    store(&mut block.position[1].as_chunks_mut().0[part], which, value.position.y);
    store(&mut block.position[2].as_chunks_mut().0[part], which, value.position.z);
    store(&mut block.normal[0].as_chunks_mut().0[part], which, value.normal.x);
    store(&mut block.normal[1].as_chunks_mut().0[part], which, value.normal.y);
    store(&mut block.normal[2].as_chunks_mut().0[part], which, value.normal.z);
    store(&mut block.depth.as_chunks_mut().0[part], which, value.depth);
    store(&mut block.t.as_chunks_mut().0[part], which, value.t);
    store_i(&mut block.cell[0].as_chunks_mut().0[part], which, value.cell.x);
    store_i(&mut block.cell[1].as_chunks_mut().0[part], which, value.cell.y);
    store_u(&mut block.reads.as_chunks_mut().0[part], which, value.reads);
    store_u(&mut block.steps.as_chunks_mut().0[part], which, value.steps);
    store_u(&mut block.bytes.as_chunks_mut().0[part], which, value.bytes);
    store(&mut block.lit.as_chunks_mut().0[part], which, value.lit);
    store_u(&mut block.level.as_chunks_mut().0[part], which, value.level);
    store(&mut block.z.as_chunks_mut().0[part], which, value.z);
    store_u(&mut block.surface.as_chunks_mut().0[part], which, value.surface);
    store(&mut block.transmittance.as_chunks_mut().0[part], which, value.transmittance);
} }

lanes! { fn quadratic(r: &Resources<'_>, c_a0: Vec3<F>, s_a1: F) -> F {
    return add(c_a0.x, mul(s_a1, add(c_a0.y, mul(s_a1, c_a0.z))));
} }
lanes! { fn across_roots(r: &Resources<'_>, ray_a0: &Across) -> Vec3<F> {
    return Vec3 { x: mul(ray_a0.sine, ray_a0.sine), y: sub(mul(mul(splat((-2.0f32)), ray_a0.mixed), ray_a0.sine), mul(mul(splat(4.0f32), ray_a0.across), ray_a0.descent)), z: sub(mul(ray_a0.mixed, ray_a0.mixed), mul(mul(splat(4.0f32), ray_a0.across), ray_a0.along)) };
} }
lanes! { fn across_discriminant(r: &Resources<'_>, ray_a0: &Across, t_a1: F) -> F {
    let e_2 = across_roots(r, ray_a0);
    let e_3 = quadratic(r, e_2, t_a1);
    return e_3;
} }
lanes! { fn across_depth(r: &Resources<'_>, within: M, ray_a0: &Across, t_a1: F) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let c_6 = mul(t_a1, add(ray_a0.descent, mul(t_a1, ray_a0.along)));
    let discriminant_7 = across_discriminant(r, ray_a0, t_a1);
    let c1 = not(ge(discriminant_7, splat(0.0f32)));
    ret = c_6;
    ex = and_not(ex, c1);
    let b_14 = sub(mul(t_a1, ray_a0.mixed), ray_a0.sine);
    let root_15 = sqrt(discriminant_7);
    let c2 = lt(b_14, splat(0.0f32));
    ret = sel(and(ex, c2), div(mul(splat(2.0f32), c_6), sub(root_15, b_14)), ret);
    ex = and_not(ex, c2);
    let c3 = ne(ray_a0.across, splat(0.0f32));
    ret = sel(and(ex, c3), div(sub(sub(splat(0.0f32), b_14), root_15), mul(splat(2.0f32), ray_a0.across)), ret);
    ex = and_not(ex, c3);
    return sel(ex, c_6, ret);
} }
lanes! { fn climb(r: &Resources<'_>, at_a0: &Entered, direction_a1: Vec3<F>) -> Vec3<F> {
    let td_4 = add(add(add(mul(at_a0.tangent.x, direction_a1.x), mul(at_a0.tangent.y, direction_a1.y)), mul(at_a0.tangent.z, direction_a1.z)), splat(0.0f32));
    let bd_6 = add(add(add(mul(at_a0.bitangent.x, direction_a1.x), mul(at_a0.bitangent.y, direction_a1.y)), mul(at_a0.bitangent.z, direction_a1.z)), splat(0.0f32));
    let area_13 = sub(mul(at_a0.metric.x, at_a0.metric.z), mul(at_a0.metric.y, at_a0.metric.y));
    let duv_26 = Vec2 { x: div(sub(mul(td_4, at_a0.metric.z), mul(bd_6, at_a0.metric.y)), area_13), y: div(sub(mul(bd_6, at_a0.metric.x), mul(td_4, at_a0.metric.y)), area_13) };
    let e_29 = r.traced_scale_m();
    return Vec3 { x: duv_26.x, y: duv_26.y, z: div(add(add(add(mul(at_a0.normal.x, direction_a1.x), mul(at_a0.normal.y, direction_a1.y)), mul(at_a0.normal.z, direction_a1.z)), splat(0.0f32)), splat(e_29)) };
} }
lanes! { fn quadric_slope(r: &Resources<'_>, quadric_a0: Vec3<F>, duv_a1: Vec2<F>) -> Vec2<F> {
    return Vec2 { x: add(mul(mul(splat(2.0f32), quadric_a0.x), duv_a1.x), mul(quadric_a0.y, duv_a1.y)), y: add(mul(quadric_a0.y, duv_a1.x), mul(mul(splat(2.0f32), quadric_a0.z), duv_a1.y)) };
} }
lanes! { fn quadric_at(r: &Resources<'_>, quadric_a0: Vec3<F>, duv_a1: Vec2<F>) -> F {
    return add(add(add(mul(quadric_a0.x, mul(duv_a1.x, duv_a1.x)), mul(quadric_a0.y, mul(duv_a1.x, duv_a1.y))), mul(quadric_a0.z, mul(duv_a1.y, duv_a1.y))), splat(0.0f32));
} }
lanes! { fn across_of(r: &Resources<'_>, at_a0: &Entered, direction_a1: Vec3<F>) -> Across {
    let e_2 = climb(r, at_a0, direction_a1);
    let descent_7 = sub(splat(0.0f32), add(add(add(mul(at_a0.normal.x, direction_a1.x), mul(at_a0.normal.y, direction_a1.y)), mul(at_a0.normal.z, direction_a1.z)), splat(0.0f32)));
    let aside_10 = Vec3 { x: add(at_a0.normal.x, mul(direction_a1.x, descent_7)), y: add(at_a0.normal.y, mul(direction_a1.y, descent_7)), z: add(at_a0.normal.z, mul(direction_a1.z, descent_7)) };
    let sine_13 = max_with(sqrt(add(add(mul(aside_10.x, aside_10.x), mul(aside_10.y, aside_10.y)), mul(aside_10.z, aside_10.z))), splat(0.0009765625f32));
    let e_18 = climb(r, at_a0, Vec3 { x: div(aside_10.x, sine_13), y: div(aside_10.y, sine_13), z: div(aside_10.z, sine_13) });
    let e_20 = quadric_slope(r, Vec3 { x: at_a0.of_surface.x, y: at_a0.of_surface.y, z: at_a0.of_surface.z }, Vec2 { x: e_2.x, y: e_2.y });
    let mixed_21 = add(add(mul(e_20.x, e_18.x), mul(e_20.y, e_18.y)), splat(0.0f32));
    let e_22 = quadric_at(r, Vec3 { x: at_a0.of_surface.x, y: at_a0.of_surface.y, z: at_a0.of_surface.z }, Vec2 { x: e_2.x, y: e_2.y });
    let e_23 = quadric_at(r, Vec3 { x: at_a0.of_surface.x, y: at_a0.of_surface.y, z: at_a0.of_surface.z }, Vec2 { x: e_18.x, y: e_18.y });
    return Across { duv: Vec2 { x: e_2.x, y: e_2.y }, descent: descent_7, along: e_22, across: e_23, mixed: mixed_21, sine: sine_13, };
} }
lanes! { fn reached(r: &Resources<'_>, within: M, ray_a0: &Across, depth_a1: F, t_a2: F) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let mut both_v0: M = splat_m(false);
    let e_3 = across_depth(r, ex, ray_a0, t_a2);
    let off_5 = abs(sub(e_3, depth_a1));
    let (b1, c2) = (ex, lt(t_a2, splat(3e38f32)));
    ex = and(b1, c2);
    if any(ex) {
        let e_10 = r.traced_scale_m();
        both_v0 = sel_m(ex, le(off_5, mul(splat(0.0009765625f32), add(splat(e_10), abs(depth_a1)))), both_v0);
    }
    ex = and_not(b1, c2);
    if any(ex) {
        both_v0 = sel_m(ex, splat_m(false), both_v0);
    }
    ex = b1;
    let e_17 = both_v0;
    return sel(e_17, t_a2, splat(3e38f32));
} }
lanes! { fn bent_descent(r: &Resources<'_>, within: M, depth_a0: F, descent_a1: F, bend_a2: F) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let mut t_v0: F = splat(3e38f32);
    let (b1, c2) = (ex, eq(bend_a2, splat(0.0f32)));
    ex = and(b1, c2);
    if any(ex) {
        let c3 = gt(descent_a1, splat(0.0f32));
        t_v0 = sel(and(ex, c3), div(depth_a0, descent_a1), t_v0);
        let e_10 = t_v0;
        ret = e_10;
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    let discriminant_15 = add(mul(descent_a1, descent_a1), mul(mul(splat(4.0f32), bend_a2), depth_a0));
    if none(ex) { return ret; }
    let (b4, c5) = (ex, gt(discriminant_15, splat(0.0f32)));
    ex = and(b4, c5);
    if any(ex) {
        let root_18 = sqrt(discriminant_15);
        let n6 = div(sub(root_18, descent_a1), mul(splat(2.0f32), bend_a2));
        t_v0 = sel(ex, sel(gt(descent_a1, splat(0.0f32)), div(mul(splat(2.0f32), depth_a0), add(descent_a1, root_18)), n6), t_v0);
    }
    ex = b4;
    let e_29 = t_v0;
    return sel(ex, e_29, ret);
} }
lanes! { fn down_across(r: &Resources<'_>, within: M, ray_a0: &Across, depth_a1: F) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let under_6 = mul(depth_a1, sub(ray_a0.sine, mul(depth_a1, ray_a0.across)));
    let e_12 = bent_descent(r, ex, under_6, add(ray_a0.descent, mul(depth_a1, ray_a0.mixed)), ray_a0.along);
    let e_13 = reached(r, ex, ray_a0, depth_a1, e_12);
    return e_13;
} }
lanes! { fn down_along(r: &Resources<'_>, within: M, ray_a0: &Across, depth_a1: F) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let e_4 = bent_descent(r, ex, depth_a1, ray_a0.descent, ray_a0.along);
    let e_5 = reached(r, ex, ray_a0, depth_a1, e_4);
    return e_5;
} }
lanes! { fn first_root(r: &Resources<'_>, within: M, c_a0: Vec3<F>, span_a1: F) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let mut a_v0: F = splat(3e38f32);
    let mut b_v1: F = splat(3e38f32);
    let discriminant_10 = sub(mul(c_a0.y, c_a0.y), mul(mul(splat(4.0f32), c_a0.z), c_a0.x));
    let (b1, c2) = (ex, ge(discriminant_10, splat(0.0f32)));
    ex = and(b1, c2);
    if any(ex) {
        let root_13 = sqrt(discriminant_10);
        let q_23 = mul(splat((-0.5f32)), add(c_a0.y, sel(ge(c_a0.y, splat(0.0f32)), root_13, sub(splat(0.0f32), root_13))));
        let c3 = ne(c_a0.z, splat(0.0f32));
        a_v0 = sel(c3, div(q_23, c_a0.z), a_v0);
        let c4 = ne(q_23, splat(0.0f32));
        b_v1 = sel(c4, div(c_a0.x, q_23), b_v1);
        let e_37 = a_v0;
        let e_38 = a_v0;
        a_v0 = sel(ge(e_38, splat(0.0f32)), e_37, splat(3e38f32));
        let e_43 = b_v1;
        let e_44 = b_v1;
        b_v1 = sel(ge(e_44, splat(0.0f32)), e_43, splat(3e38f32));
        let e_49 = a_v0;
        let e_50 = b_v1;
        let first_51 = min(e_49, e_50);
        let (b5, c6) = (ex, le(first_51, span_a1));
        ex = and(b5, c6);
        if any(ex) {
            ret = first_51;
            ex = no_lane();
        }
        ex = and_not(b5, c6);
    }
    let x7 = ex;
    ex = and_not(b1, c2);
    ex = or(ex, x7);
    if none(ex) { return ret; }
    let e_53 = quadratic(r, c_a0, span_a1);
    let c8 = le(e_53, splat(0.0f32));
    ret = sel(and(ex, c8), span_a1, ret);
    ex = and_not(ex, c8);
    return sel(ex, splat(3e38f32), ret);
} }
lanes! { fn jumps_below(r: &Resources<'_>, within: M, ray_a0: &Across, depth_a1: F) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let mut both_v0: M = splat_m(false);
    let e_2 = across_roots(r, ray_a0);
    let t_4 = first_root(r, ex, e_2, splat(3e38f32));
    both_v0 = and(lt(t_4, splat(3e38f32)), ge(mul(t_4, add(ray_a0.descent, mul(t_4, ray_a0.along))), depth_a1));
    let below_16 = both_v0;
    return sel(below_16, t_4, splat(3e38f32));
} }
lanes! { fn across_span(r: &Resources<'_>, within: M, at_a0: &Entered, ray_a1: &Across, eye_a2: F) -> Vec2<F> {
    let mut ex = within;
    let mut ret: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    let mut both_v0: M = splat_m(false);
    let mut both_v1: M = splat_m(false);
    let mut leave_v2: F = splat(0f32);
    let nowhere_5 = Vec2 { x: 1.0f32, y: (-1.0f32) };
    let scale_6 = r.traced_scale_m();
    let over_11 = mul(sub(at_a0.of_surface.w, splat(1.0f32)), splat(scale_6));
    let e_12 = down_across(r, ex, ray_a1, over_11);
    let e_13 = down_along(r, ex, ray_a1, over_11);
    let e_15 = jumps_below(r, ex, ray_a1, over_11);
    let begin_16 = min(min(e_12, e_13), e_15);
    both_v1 = and(ge(at_a0.of_surface.w, splat(1.0f32)), lt(begin_16, splat(0.0f32)));
    let e_30 = both_v1;
    both_v0 = or(not(lt(begin_16, splat(3e38f32))), e_30);
    let e_32 = both_v0;
    let c1 = e_32;
    ret = Vec2 { x: splat(nowhere_5.x), y: splat(nowhere_5.y) };
    ex = and_not(ex, c1);
    let enter_33 = max(begin_16, eye_a2);
    let floor_34 = mul(at_a0.of_surface.w, splat(scale_6));
    if none(ex) { return ret; }
    let by_across_35 = down_across(r, ex, ray_a1, floor_34);
    let by_along_36 = down_along(r, ex, ray_a1, floor_34);
    let by_jump_37 = jumps_below(r, ex, ray_a1, floor_34);
    leave_v2 = sel(gt(by_across_35, enter_33), by_across_35, splat(3e38f32));
    let e_42 = leave_v2;
    leave_v2 = min(e_42, sel(gt(by_along_36, enter_33), by_along_36, splat(3e38f32)));
    let e_47 = leave_v2;
    leave_v2 = min(e_47, sel(gt(by_jump_37, enter_33), by_jump_37, splat(3e38f32)));
    let (b2, c3) = (ex, lt(ray_a1.along, splat(0.0f32)));
    ex = and(b2, c3);
    if any(ex) {
        let under_62 = add(mul(ray_a1.descent, ray_a1.descent), mul(mul(splat(4.0f32), ray_a1.along), over_11));
        let c4 = ge(under_62, splat(0.0f32));
        let e_65 = leave_v2;
        leave_v2 = sel(and(ex, c4), min(e_65, div(add(ray_a1.descent, sqrt(under_62)), mul(splat((-2.0f32)), ray_a1.along))), leave_v2);
    }
    ex = b2;
    let e_74 = leave_v2;
    let c5 = not(lt(e_74, splat(3e38f32)));
    let y6 = Vec2 { x: splat(nowhere_5.x), y: splat(nowhere_5.y) };
    ret = Vec2 { x: sel(and(ex, c5), y6.x, ret.x), y: sel(and(ex, c5), y6.y, ret.y) };
    ex = and_not(ex, c5);
    let e_78 = leave_v2;
    let e_79 = leave_v2;
    let y7 = Vec2 { x: enter_33, y: add(e_78, mul(sub(e_79, enter_33), splat(1e-6f32))) };
    return Vec2 { x: sel(ex, y7.x, ret.x), y: sel(ex, y7.y, ret.y) };
} }
lanes! { fn from_tangent_space(r: &Resources<'_>, at_a0: &Entered, n_a1: Vec3<F>) -> Vec3<F> {
    let length1 = sqrt(add(add(mul(at_a0.tangent.x, at_a0.tangent.x), mul(at_a0.tangent.y, at_a0.tangent.y)), mul(at_a0.tangent.z, at_a0.tangent.z)));
    let along_u_3 = Vec3 { x: div(at_a0.tangent.x, length1), y: div(at_a0.tangent.y, length1), z: div(at_a0.tangent.z, length1) };
    let length2 = sqrt(add(add(mul(at_a0.bitangent.x, at_a0.bitangent.x), mul(at_a0.bitangent.y, at_a0.bitangent.y)), mul(at_a0.bitangent.z, at_a0.bitangent.z)));
    let along_v_5 = Vec3 { x: div(at_a0.bitangent.x, length2), y: div(at_a0.bitangent.y, length2), z: div(at_a0.bitangent.z, length2) };
    return Vec3 { x: add(sub(mul(along_u_3.x, n_a1.x), mul(along_v_5.x, n_a1.y)), mul(at_a0.normal.x, n_a1.z)), y: add(sub(mul(along_u_3.y, n_a1.x), mul(along_v_5.y, n_a1.y)), mul(at_a0.normal.y, n_a1.z)), z: add(sub(mul(along_u_3.z, n_a1.x), mul(along_v_5.z, n_a1.y)), mul(at_a0.normal.z, n_a1.z)) };
} }
lanes! { fn cell_of(r: &Resources<'_>, point_a0: Vec2<F>) -> Vec2<F> {
    return Vec2 { x: min_with(max_with(floor(point_a0.x), splat((-1073741800.0f32))), splat(1073741800.0f32)), y: min_with(max_with(floor(point_a0.y), splat((-1073741800.0f32))), splat(1073741800.0f32)) };
} }
lanes! { fn unfolded(r: &Resources<'_>, i_a0: I, n_a1: I, period_a2: I) -> I {
    return sel_i(lt_i(i_a0, n_a1), i_a0, sub_i(sub_i(period_a2, splat_i(1i32)), i_a0));
} }
lanes! { fn continued_pair(r: &Resources<'_>, within: M, i_a0: I, n_a1: I, wrap_a2: u32) -> Vec2<I> {
    let mut ex = within;
    let mut ret: Vec2<I> = Vec2 { x: splat_i(0i32), y: splat_i(0i32) };
    let mut both_v0: M = splat_m(false);
    if (wrap_a2 == 1u32) {
        return Vec2 { x: min_i(max_i(i_a0, splat_i(0i32)), sub_i(n_a1, splat_i(1i32))), y: min_i(max_i(add_i(i_a0, splat_i(1i32)), splat_i(0i32)), sub_i(n_a1, splat_i(1i32))) };
    }
    both_v0 = and(ge_i(i_a0, splat_i(0i32)), lt_i(add_i(i_a0, splat_i(1i32)), n_a1));
    let e_24 = both_v0;
    let c1 = e_24;
    ret = Vec2 { x: i_a0, y: add_i(i_a0, splat_i(1i32)) };
    ex = and_not(ex, c1);
    let period_32 = sel_i(splat_m((wrap_a2 == 0u32)), n_a1, mul_i(splat_i(2i32), n_a1));
    if none(ex) { return ret; }
    let rest_33 = rem_i(i_a0, period_32);
    let first_37 = sel_i(lt_i(rest_33, splat_i(0i32)), add_i(rest_33, period_32), rest_33);
    let second_44 = sel_i(eq_i(add_i(first_37, splat_i(1i32)), period_32), splat_i(0i32), add_i(first_37, splat_i(1i32)));
    let e_45 = unfolded(r, first_37, n_a1, period_32);
    let e_46 = unfolded(r, second_44, n_a1, period_32);
    let y2 = Vec2 { x: e_45, y: e_46 };
    return Vec2 { x: sel_i(ex, y2.x, ret.x), y: sel_i(ex, y2.y, ret.y) };
} }
lanes! { fn wrap_pair(r: &Resources<'_>, within: M, i_a0: I, n_a1: I) -> Vec2<I> {
    let mut ex = within;
    let mut ret: Vec2<I> = Vec2 { x: splat_i(0i32), y: splat_i(0i32) };
    let e_5 = continued_pair(r, ex, i_a0, n_a1, r.surface_settings.wrap);
    return e_5;
} }
lanes! { fn texels_around(r: &Resources<'_>, within: M, uv_a0: Vec2<F>, n_a1: Vec2<I>) -> Around {
    let mut ex = within;
    let mut ret: Around = zero_around();
    let point_7 = Vec2 { x: sub(mul(uv_a0.x, f_of_i(n_a1.x)), splat(0.5f32)), y: sub(mul(uv_a0.y, f_of_i(n_a1.y)), splat(0.5f32)) };
    let cell_8 = cell_of(r, point_7);
    let i_9 = Vec2 { x: i_of_small(cell_8.x), y: i_of_small(cell_8.y) };
    let e_12 = wrap_pair(r, ex, i_9.x, n_a1.x);
    let e_15 = wrap_pair(r, ex, i_9.y, n_a1.y);
    return Around { columns: e_12, rows: e_15, part: Vec2 { x: sub(point_7.x, cell_8.x), y: sub(point_7.y, cell_8.y) }, };
} }
lanes! { fn level_texels(r: &Resources<'_>, finest_a0: Vec2<u32>, level_a1: U) -> Vec2<I> {
    return Vec2 { x: max_i(i_of_u(shr_u(splat_u(finest_a0.x), i_of_u(level_a1))), splat_i(1i32)), y: max_i(i_of_u(shr_u(splat_u(finest_a0.y), i_of_u(level_a1))), splat_i(1i32)) };
} }
lanes! { fn height_texels(r: &Resources<'_>, level_a0: U) -> Vec2<I> {
    let e_4 = level_texels(r, r.surface_settings.height_size, level_a0);
    return e_4;
} }
lanes! { fn bilinear(r: &Resources<'_>, h00_a0: Vec4<F>, h10_a1: Vec4<F>, h01_a2: Vec4<F>, h11_a3: Vec4<F>, part_a4: Vec2<F>) -> Vec4<F> {
    let top_8 = Vec4 { x: add(h00_a0.x, mul(sub(h10_a1.x, h00_a0.x), part_a4.x)), y: add(h00_a0.y, mul(sub(h10_a1.y, h00_a0.y), part_a4.x)), z: add(h00_a0.z, mul(sub(h10_a1.z, h00_a0.z), part_a4.x)), w: add(h00_a0.w, mul(sub(h10_a1.w, h00_a0.w), part_a4.x)) };
    let bottom_12 = Vec4 { x: add(h01_a2.x, mul(sub(h11_a3.x, h01_a2.x), part_a4.x)), y: add(h01_a2.y, mul(sub(h11_a3.y, h01_a2.y), part_a4.x)), z: add(h01_a2.z, mul(sub(h11_a3.z, h01_a2.z), part_a4.x)), w: add(h01_a2.w, mul(sub(h11_a3.w, h01_a2.w), part_a4.x)) };
    return Vec4 { x: add(top_8.x, mul(sub(bottom_12.x, top_8.x), part_a4.y)), y: add(top_8.y, mul(sub(bottom_12.y, top_8.y), part_a4.y)), z: add(top_8.z, mul(sub(bottom_12.z, top_8.z), part_a4.y)), w: add(top_8.w, mul(sub(bottom_12.w, top_8.w), part_a4.y)) };
} }
lanes! { fn decoded(r: &Resources<'_>, texel_a0: Vec4<F>, map_a1: &single::MapSettings) -> Vec4<F> {
    if (map_a1.coded == 1u32) {
        return Vec4 { x: add(splat(map_a1.low.x), mul(splat(map_a1.step.x), floor(add(mul(texel_a0.x, splat(255.0f32)), splat(0.5f32))))), y: add(splat(map_a1.low.y), mul(splat(map_a1.step.y), floor(add(mul(texel_a0.y, splat(255.0f32)), splat(0.5f32))))), z: add(splat(map_a1.low.z), mul(splat(map_a1.step.z), floor(add(mul(texel_a0.z, splat(255.0f32)), splat(0.5f32))))), w: add(splat(map_a1.low.w), mul(splat(map_a1.step.w), floor(add(mul(texel_a0.w, splat(255.0f32)), splat(0.5f32))))) };
    }
    return texel_a0;
} }
lanes! { fn ambient_texel(r: &Resources<'_>, within: M, place_a0: Vec2<I>, layer_a1: i32, level_a2: I) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let e_4 = map_texel_of_each(&r.ambient_map, ex, place_a0.x, place_a0.y, splat_i(layer_a1), level_a2);
    let e_9 = decoded(r, e_4, &r.surface_settings.maps[4]);
    return e_9;
} }
lanes! { fn ambient_texel_between(r: &Resources<'_>, within: M, uv_a0: Vec2<F>, level_a1: U) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let seen_8 = sel_u(gt_u(level_a1, splat_u(r.surface_settings.maps[4].first_level)), level_a1, splat_u(r.surface_settings.maps[4].first_level));
    let e_9 = height_texels(r, seen_8);
    let at_10 = texels_around(r, ex, uv_a0, e_9);
    let k_12 = i_of_u(sub_u(seen_8, splat_u(r.surface_settings.maps[4].first_level)));
    let e_19 = ambient_texel(r, ex, Vec2 { x: at_10.columns.x, y: at_10.rows.x }, 0i32, k_12);
    let e_26 = ambient_texel(r, ex, Vec2 { x: at_10.columns.y, y: at_10.rows.x }, 0i32, k_12);
    let e_33 = ambient_texel(r, ex, Vec2 { x: at_10.columns.x, y: at_10.rows.y }, 0i32, k_12);
    let e_40 = ambient_texel(r, ex, Vec2 { x: at_10.columns.y, y: at_10.rows.y }, 0i32, k_12);
    let e_42 = bilinear(r, e_19, e_26, e_33, e_40, Vec2 { x: at_10.part.x, y: at_10.part.y });
    return e_42;
} }
lanes! { fn ambient_bent_normal(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, normal_a2: Vec3<F>, view_a3: Vec3<F>, material_a4: &Material, params_a5: Vec4<f32>) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let e_8 = ambient_texel_between(r, ex, Vec2 { x: hit_a1.uv.x, y: hit_a1.uv.y }, at_a0.level);
    let sky_10 = from_tangent_space(r, at_a0, Vec3 { x: e_8.x, y: e_8.y, z: e_8.z });
    let e_19 = max_with(add(add(add(mul(normal_a2.x, sky_10.x), mul(normal_a2.y, sky_10.y)), mul(normal_a2.z, sky_10.z)), splat(0.0f32)), splat(0.0f32));
    return Vec3 { x: mul(mul(splat(r.frame.ambient.x), material_a4.around.x), e_19), y: mul(mul(splat(r.frame.ambient.y), material_a4.around.y), e_19), z: mul(mul(splat(r.frame.ambient.z), material_a4.around.z), e_19) };
} }
lanes! { fn ambient_bounce(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, normal_a2: Vec3<F>, view_a3: Vec3<F>, material_a4: &Material, params_a5: Vec4<f32>) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let e_14 = ambient_texel_between(r, ex, Vec2 { x: hit_a1.uv.x, y: hit_a1.uv.y }, at_a0.level);
    return Vec3 { x: mul(mul(splat(r.frame.ambient.x), material_a4.around.x), e_14.x), y: mul(mul(splat(r.frame.ambient.y), material_a4.around.y), e_14.x), z: mul(mul(splat(r.frame.ambient.z), material_a4.around.z), e_14.x) };
} }
lanes! { fn ambient_constant(r: &Resources<'_>, at_a0: &Entered, hit_a1: &Hit, normal_a2: Vec3<F>, view_a3: Vec3<F>, material_a4: &Material, params_a5: Vec4<f32>) -> Vec3<F> {
    return Vec3 { x: mul(splat(r.frame.ambient.x), material_a4.around.x), y: mul(splat(r.frame.ambient.y), material_a4.around.y), z: mul(splat(r.frame.ambient.z), material_a4.around.z) };
} }
lanes! { fn cosine_inside(r: &Resources<'_>, cosine_a0: F) -> F {
    let eta_5 = (1.0f32 / r.surface_settings.ior);
    return sqrt(max_with(sub(splat(1.0f32), mul(splat((eta_5 * eta_5)), sub(splat(1.0f32), mul(cosine_a0, cosine_a0)))), splat(0.0f32)));
} }
lanes! { fn fresnel(r: &Resources<'_>, cosine_a0: F) -> F {
    let inside_4 = cosine_inside(r, cosine_a0);
    let across_11 = div(sub(cosine_a0, mul(splat(r.surface_settings.ior), inside_4)), max_with(add(cosine_a0, mul(splat(r.surface_settings.ior), inside_4)), splat(1e-6f32)));
    let along_18 = div(sub(mul(splat(r.surface_settings.ior), cosine_a0), inside_4), max_with(add(mul(splat(r.surface_settings.ior), cosine_a0), inside_4), splat(1e-6f32)));
    let waves_19 = Vec2 { x: across_11, y: along_18 };
    return mul(splat(0.5f32), add(add(mul(waves_19.x, waves_19.x), mul(waves_19.y, waves_19.y)), splat(0.0f32)));
} }
lanes! { fn shade_blinn_phong_mirrored(r: &Resources<'_>, material_a0: &Material, mean_a1: F, cosine_a2: F, params_a3: Vec4<f32>) -> Mirrored {
    let part_4 = fresnel(r, cosine_a2);
    let lean_20 = sqrt(add(splat((2.0f32 / ((r.surface_settings.shininess as f32) + 2.0f32))), mul(splat(2.0f32), max_with(sub(splat(1.0f32), mean_a1), splat(0.0f32)))));
    return Mirrored { part: Vec3 { x: part_4, y: part_4, z: part_4 }, lean: lean_20, lobes: Vec2 { x: mul(splat(2.0f32), lean_20), y: mul(splat(2.0f32), lean_20) }, second: splat(0.0f32), turn: splat(0.0f32), };
} }
lanes! { fn facet_reflection(r: &Resources<'_>, cosine_a0: F, alpha_a1: F, roughness_a2: F) -> Vec2<F> {
    let x_6 = div(cosine_a0, add(cosine_a0, mul(splat(0.65f32), alpha_a1)));
    let a6_16 = add(splat(0.1878f32), mul(alpha_a1, add(splat((-0.9742f32)), mul(alpha_a1, add(splat(1.3709f32), mul(alpha_a1, splat((-0.6017f32))))))));
    let a0_22 = add(splat(1.0034f32), mul(alpha_a1, add(splat(0.0071f32), mul(alpha_a1, a6_16))));
    let a1_35 = add(splat((-0.4137f32)), mul(alpha_a1, add(splat((-0.4144f32)), mul(alpha_a1, add(splat((-0.877f32)), mul(alpha_a1, add(splat((-1.6058f32)), mul(alpha_a1, splat(0.9124f32)))))))));
    let a2_45 = add(splat(2.5855f32), mul(alpha_a1, add(splat(0.3239f32), mul(alpha_a1, add(splat(2.4708f32), mul(alpha_a1, splat(0.7166f32)))))));
    let a3_52 = add(splat((-8.9277f32)), mul(alpha_a1, add(splat((-0.5518f32)), mul(alpha_a1, splat((-3.0114f32))))));
    let a4_56 = add(splat(11.8249f32), mul(alpha_a1, splat(0.937f32)));
    let all_67 = add(a0_22, mul(x_6, add(a1_35, mul(x_6, add(a2_45, mul(x_6, add(a3_52, mul(x_6, add(a4_56, mul(x_6, splat((-5.0796f32))))))))))));
    let b5_74 = add(splat(3.4396f32), mul(roughness_a2, add(splat((-0.7093f32)), mul(roughness_a2, splat((-0.4004f32))))));
    let b0_80 = add(splat(1.1487f32), mul(roughness_a2, add(splat((-3.4586f32)), mul(roughness_a2, b5_74))));
    let b1_90 = add(splat((-0.6771f32)), mul(roughness_a2, add(splat(5.7828f32), mul(roughness_a2, add(splat((-8.8951f32)), mul(roughness_a2, splat(4.2115f32)))))));
    let b2_97 = add(splat(0.558f32), mul(roughness_a2, add(splat((-7.0899f32)), mul(roughness_a2, splat(4.2721f32)))));
    let b3_101 = add(splat(0.1714f32), mul(roughness_a2, splat(5.0718f32)));
    let rest_110 = add(b0_80, mul(x_6, add(b1_90, mul(x_6, add(b2_97, mul(x_6, add(b3_101, mul(x_6, splat((-0.1958f32))))))))));
    let slant_114 = sub(splat(1.0f32), min_with(cosine_a0, splat(1.0f32)));
    let squared_115 = mul(slant_114, slant_114);
    let grazing_118 = mul(mul(mul(squared_115, squared_115), slant_114), rest_110);
    return Vec2 { x: all_67, y: grazing_118 };
} }
lanes! { fn reflected_by(r: &Resources<'_>, once_a0: Vec2<F>, specular_a1: Vec3<F>) -> Vec3<F> {
    let least_5 = Vec3 { x: once_a0.y, y: once_a0.y, z: once_a0.y };
    let e_10 = max_with(sub(once_a0.x, once_a0.y), splat(0.0f32));
    return Vec3 { x: add(least_5.x, mul(specular_a1.x, e_10)), y: add(least_5.y, mul(specular_a1.y, e_10)), z: add(least_5.z, mul(specular_a1.z, e_10)) };
} }
lanes! { fn shade_metallic_roughness_mirrored(r: &Resources<'_>, material_a0: &Material, mean_a1: F, cosine_a2: F, params_a3: Vec4<f32>) -> Mirrored {
    let white_7 = Vec3 { x: 1.0f32, y: 1.0f32, z: 1.0f32 };
    let once_11 = facet_reflection(r, material_a0.upright, material_a0.alpha, material_a0.roughness);
    let e_13 = reflected_by(r, once_11, Vec3 { x: material_a0.specular.x, y: material_a0.specular.y, z: material_a0.specular.z });
    let part_18 = Vec3 { x: mul(e_13.x, add(splat(white_7.x), mul(material_a0.specular.x, material_a0.again))), y: mul(e_13.y, add(splat(white_7.y), mul(material_a0.specular.y, material_a0.again))), z: mul(e_13.z, add(splat(white_7.z), mul(material_a0.specular.z, material_a0.again))) };
    let turn_21 = mul(material_a0.alpha, material_a0.roughness);
    return Mirrored { part: part_18, lean: material_a0.alpha, lobes: Vec2 { x: mul(splat(1.4f32), material_a0.alpha), y: mul(splat(5.6f32), material_a0.alpha) }, second: splat(0.25f32), turn: turn_21, };
} }
lanes! { fn shade_mirrored_stage(r: &Resources<'_>, material_a0: &Material, mean_a1: F, cosine_a2: F) -> Mirrored {
    match r.surface_settings.choices[8].number {
        0u32 => {
            let e_13 = shade_blinn_phong_mirrored(r, material_a0, mean_a1, cosine_a2, r.surface_settings.choices[8].params);
            return e_13;
        }
        _ => {
            let e_19 = shade_metallic_roughness_mirrored(r, material_a0, mean_a1, cosine_a2, r.surface_settings.choices[8].params);
            return e_19;
        }
    }
} }
stage! { fn levels_of(r: &Resources<'_>, within: M, footprint_a0: F, count_a1: u32) -> Levels {
    let mut ex = within;
    let mut ret: Levels = zero_levels();
    let mut texels_v0: F = splat(0f32);
    let mut level_v1: U = splat_u(0u32);
    let mut both_v2: M = splat_m(false);
    let mut both_v3: M = splat_m(false);
    texels_v0 = footprint_a0;
    let b2 = ex;
    'l1: loop {
        let e_5 = texels_v0;
        let e_10 = level_v1;
        both_v2 = and(ge(e_5, splat(2.0f32)), lt_u(add_u(e_10, splat_u(1u32)), splat_u(count_a1)));
        let e_15 = both_v2;
        let c3 = e_15;
        ex = and(ex, c3);
        let e_16 = texels_v0;
        texels_v0 = sel(ex, mul(e_16, splat(0.5f32)), texels_v0);
        let e_19 = level_v1;
        level_v1 = sel_u(ex, add_u(e_19, splat_u(1u32)), level_v1);
        if none(ex) { break 'l1; }
    }
    ex = b2;
    let e_22 = texels_v0;
    let e_27 = level_v1;
    both_v3 = and(gt(e_22, splat(1.0f32)), lt_u(add_u(e_27, splat_u(1u32)), splat_u(count_a1)));
    let e_32 = both_v3;
    let (b4, c5) = (ex, e_32);
    ex = and(b4, c5);
    if any(ex) {
        let e_33 = level_v1;
        let e_34 = texels_v0;
        ret = Levels { fine: e_33, part: sub(e_34, splat(1.0f32)), };
        ex = no_lane();
    }
    ex = and_not(b4, c5);
    let e_38 = level_v1;
    return sel_levels(ex, &Levels { fine: e_38, part: splat(0.0f32), }, &ret);
} }
lanes! { fn face_place(r: &Resources<'_>, within: M, d_a0: Vec3<F>) -> FacePlace {
    let mut ex = within;
    let mut ret: FacePlace = zero_face_place();
    let mut both_v0: M = splat_m(false);
    let size_1 = Vec3 { x: abs(d_a0.x), y: abs(d_a0.y), z: abs(d_a0.z) };
    both_v0 = and(ge(size_1.x, size_1.y), ge(size_1.x, size_1.z));
    let e_11 = both_v0;
    let (b1, c2) = (ex, e_11);
    ex = and(b1, c2);
    if any(ex) {
        let (b3, c4) = (ex, gt(d_a0.x, splat(0.0f32)));
        ex = and(b3, c4);
        if any(ex) {
            ret = FacePlace { face: splat_i(0i32), place: Vec2 { x: div(neg(d_a0.z), size_1.x), y: div(neg(d_a0.y), size_1.x) }, };
            ex = no_lane();
        }
        ex = and_not(b3, c4);
        ret = sel_face_place(ex, &FacePlace { face: splat_i(1i32), place: Vec2 { x: div(d_a0.z, size_1.x), y: div(neg(d_a0.y), size_1.x) }, }, &ret);
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    if none(ex) { return ret; }
    let (b5, c6) = (ex, ge(size_1.y, size_1.z));
    ex = and(b5, c6);
    if any(ex) {
        let (b7, c8) = (ex, gt(d_a0.y, splat(0.0f32)));
        ex = and(b7, c8);
        if any(ex) {
            ret = sel_face_place(ex, &FacePlace { face: splat_i(2i32), place: Vec2 { x: div(d_a0.x, size_1.y), y: div(d_a0.z, size_1.y) }, }, &ret);
            ex = no_lane();
        }
        ex = and_not(b7, c8);
        ret = sel_face_place(ex, &FacePlace { face: splat_i(3i32), place: Vec2 { x: div(d_a0.x, size_1.y), y: div(neg(d_a0.z), size_1.y) }, }, &ret);
        ex = no_lane();
    }
    ex = and_not(b5, c6);
    if none(ex) { return ret; }
    let (b9, c10) = (ex, gt(d_a0.z, splat(0.0f32)));
    ex = and(b9, c10);
    if any(ex) {
        ret = sel_face_place(ex, &FacePlace { face: splat_i(4i32), place: Vec2 { x: div(d_a0.x, size_1.z), y: div(neg(d_a0.y), size_1.z) }, }, &ret);
        ex = no_lane();
    }
    ex = and_not(b9, c10);
    return sel_face_place(ex, &FacePlace { face: splat_i(5i32), place: Vec2 { x: div(neg(d_a0.x), size_1.z), y: div(neg(d_a0.y), size_1.z) }, }, &ret);
} }
lanes! { fn environment_texel_lll(r: &Resources<'_>, within: M, place_a0: Vec2<I>, face_a1: I, level_a2: I) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let e_4 = map_texel_of_each(&r.environment_map, ex, place_a0.x, place_a0.y, face_a1, level_a2);
    let e_9 = decoded(r, e_4, &r.surface_settings.maps[5]);
    return e_9;
} }
lanes! { fn environment_texel_lls(r: &Resources<'_>, within: M, place_a0: Vec2<I>, face_a1: I, level_a2: i32) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let e_4 = map_texel_of_each(&r.environment_map, ex, place_a0.x, place_a0.y, face_a1, splat_i(level_a2));
    let e_9 = decoded(r, e_4, &r.surface_settings.maps[5]);
    return e_9;
} }
lanes! { fn environment_of_level_ll(r: &Resources<'_>, within: M, direction_a0: Vec3<F>, level_a1: U) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let at_2 = face_place(r, ex, direction_a0);
    let last_11 = sub_i(max_i(i_of_u(shr_u(splat_u(r.surface_settings.environment_side), i_of_u(level_a1))), splat_i(1i32)), splat_i(1i32));
    let e_19 = mul(splat(0.5f32), f_of_i(last_11));
    let point_20 = Vec2 { x: mul(add(at_2.place.x, splat(1.0f32)), e_19), y: mul(add(at_2.place.y, splat(1.0f32)), e_19) };
    let most_25 = f_of_i(max_i(sub_i(last_11, splat_i(1i32)), splat_i(0i32)));
    let corner_31 = Vec2 { x: min(max_with(floor(point_20.x), splat(0.0f32)), most_25), y: min(max_with(floor(point_20.y), splat(0.0f32)), most_25) };
    let texel_32 = Vec2 { x: i_of_f(corner_31.x), y: i_of_f(corner_31.y) };
    let k_33 = i_of_u(level_a1);
    let e_35 = environment_texel_lll(r, ex, texel_32, at_2.face, k_33);
    let e_41 = environment_texel_lll(r, ex, Vec2 { x: add_i(texel_32.x, splat_i(1i32)), y: add_i(texel_32.y, splat_i(0i32)) }, at_2.face, k_33);
    let e_47 = environment_texel_lll(r, ex, Vec2 { x: add_i(texel_32.x, splat_i(0i32)), y: add_i(texel_32.y, splat_i(1i32)) }, at_2.face, k_33);
    let e_53 = environment_texel_lll(r, ex, Vec2 { x: add_i(texel_32.x, splat_i(1i32)), y: add_i(texel_32.y, splat_i(1i32)) }, at_2.face, k_33);
    let e_55 = bilinear(r, e_35, e_41, e_47, e_53, Vec2 { x: sub(point_20.x, corner_31.x), y: sub(point_20.y, corner_31.y) });
    return Vec3 { x: e_55.x, y: e_55.y, z: e_55.z };
} }
lanes! { fn environment_of_level_ls(r: &Resources<'_>, within: M, direction_a0: Vec3<F>, level_a1: u32) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let at_2 = face_place(r, ex, direction_a0);
    let last_11 = (r.surface_settings.environment_side.unbounded_shr(level_a1) as i32).max(1i32).wrapping_sub(1i32);
    let e_19 = (0.5f32 * (last_11 as f32));
    let point_20 = Vec2 { x: mul(add(at_2.place.x, splat(1.0f32)), splat(e_19)), y: mul(add(at_2.place.y, splat(1.0f32)), splat(e_19)) };
    let most_25 = (last_11.wrapping_sub(1i32).max(0i32) as f32);
    let corner_31 = Vec2 { x: min(max_with(floor(point_20.x), splat(0.0f32)), splat(most_25)), y: min(max_with(floor(point_20.y), splat(0.0f32)), splat(most_25)) };
    let texel_32 = Vec2 { x: i_of_f(corner_31.x), y: i_of_f(corner_31.y) };
    let k_33 = (level_a1 as i32);
    let e_35 = environment_texel_lls(r, ex, texel_32, at_2.face, k_33);
    let e_41 = environment_texel_lls(r, ex, Vec2 { x: add_i(texel_32.x, splat_i(1i32)), y: add_i(texel_32.y, splat_i(0i32)) }, at_2.face, k_33);
    let e_47 = environment_texel_lls(r, ex, Vec2 { x: add_i(texel_32.x, splat_i(0i32)), y: add_i(texel_32.y, splat_i(1i32)) }, at_2.face, k_33);
    let e_53 = environment_texel_lls(r, ex, Vec2 { x: add_i(texel_32.x, splat_i(1i32)), y: add_i(texel_32.y, splat_i(1i32)) }, at_2.face, k_33);
    let e_55 = bilinear(r, e_35, e_41, e_47, e_53, Vec2 { x: sub(point_20.x, corner_31.x), y: sub(point_20.y, corner_31.y) });
    return Vec3 { x: e_55.x, y: e_55.y, z: e_55.z };
} }
lanes! { fn environment_in_lobe(r: &Resources<'_>, within: M, direction_a0: Vec3<F>, deviation_a1: F) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let width_12 = mul(deviation_a1, splat((1.2247449f32 * (1u32.unbounded_shl(r.surface_settings.environment_levels.wrapping_sub(1u32)) as f32))));
    let levels_16 = levels_of(r, ex, width_12, r.surface_settings.environment_levels);
    let fine_18 = environment_of_level_ll(r, ex, direction_a0, levels_16.fine);
    let (b1, c2) = (ex, gt(levels_16.part, splat(0.0f32)));
    ex = and(b1, c2);
    if any(ex) {
        let e_25 = environment_of_level_ll(r, ex, direction_a0, add_u(levels_16.fine, splat_u(1u32)));
        ret = Vec3 { x: add(fine_18.x, mul(sub(e_25.x, fine_18.x), levels_16.part)), y: add(fine_18.y, mul(sub(e_25.y, fine_18.y), levels_16.part)), z: add(fine_18.z, mul(sub(e_25.z, fine_18.z), levels_16.part)) };
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    let y3 = fine_18;
    return Vec3 { x: sel(ex, y3.x, ret.x), y: sel(ex, y3.y, ret.y), z: sel(ex, y3.z, ret.z) };
} }
lanes! { fn environment_on(r: &Resources<'_>, within: M, normal_a0: Vec3<F>) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let e_6 = environment_of_level_ls(r, ex, normal_a0, r.surface_settings.environment_levels.wrapping_sub(1u32));
    return e_6;
} }
lanes! { fn ambient_environment(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, normal_a2: Vec3<F>, view_a3: Vec3<F>, material_a4: &Material, params_a5: Vec4<f32>) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let mut light_v0: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let mean_6 = sqrt(add(add(mul(normal_a2.x, normal_a2.x), mul(normal_a2.y, normal_a2.y)), mul(normal_a2.z, normal_a2.z)));
    let length1 = sqrt(add(add(mul(normal_a2.x, normal_a2.x), mul(normal_a2.y, normal_a2.y)), mul(normal_a2.z, normal_a2.z)));
    let n_7 = Vec3 { x: div(normal_a2.x, length1), y: div(normal_a2.y, length1), z: div(normal_a2.z, length1) };
    let cosine_11 = min_with(max_with(add(add(add(mul(n_7.x, view_a3.x), mul(n_7.y, view_a3.y)), mul(n_7.z, view_a3.z)), splat(0.0f32)), splat(0.0f32)), splat(1.0f32));
    let mirror_12 = shade_mirrored_stage(r, material_a4, mean_6, cosine_11);
    let e_14 = mul(splat(2.0f32), cosine_11);
    let reflected_16 = Vec3 { x: sub(mul(n_7.x, e_14), view_a3.x), y: sub(mul(n_7.y, e_14), view_a3.y), z: sub(mul(n_7.z, e_14), view_a3.z) };
    let axis_20 = Vec3 { x: add(reflected_16.x, mul(sub(n_7.x, reflected_16.x), mirror_12.turn)), y: add(reflected_16.y, mul(sub(n_7.y, reflected_16.y), mirror_12.turn)), z: add(reflected_16.z, mul(sub(n_7.z, reflected_16.z), mirror_12.turn)) };
    let e_23 = environment_in_lobe(r, ex, axis_20, mirror_12.lobes.x);
    light_v0 = e_23;
    let (b2, c3) = (ex, gt(mirror_12.second, splat(0.0f32)));
    ex = and(b2, c3);
    if any(ex) {
        let e_28 = light_v0;
        let e_31 = environment_in_lobe(r, ex, axis_20, mirror_12.lobes.y);
        let e_32 = light_v0;
        let (m4, y5) = (ex, Vec3 { x: add(e_28.x, mul(sub(e_31.x, e_32.x), mirror_12.second)), y: add(e_28.y, mul(sub(e_31.y, e_32.y), mirror_12.second)), z: add(e_28.z, mul(sub(e_31.z, e_32.z), mirror_12.second)) });
        light_v0 = Vec3 { x: sel(m4, y5.x, light_v0.x), y: sel(m4, y5.y, light_v0.y), z: sel(m4, y5.z, light_v0.z) };
    }
    ex = b2;
    let e_37 = light_v0;
    light_v0 = Vec3 { x: mul(e_37.x, mirror_12.part.x), y: mul(e_37.y, mirror_12.part.y), z: mul(e_37.z, mirror_12.part.z) };
    let enters_45 = Vec3 { x: sub(splat(1.0f32), mirror_12.part.x), y: sub(splat(1.0f32), mirror_12.part.y), z: sub(splat(1.0f32), mirror_12.part.z) };
    let e_46 = light_v0;
    let e_47 = environment_on(r, ex, n_7);
    light_v0 = Vec3 { x: add(e_46.x, mul(mul(e_47.x, material_a4.diffuse.x), enters_45.x)), y: add(e_46.y, mul(mul(e_47.y, material_a4.diffuse.y), enters_45.y)), z: add(e_46.z, mul(mul(e_47.z, material_a4.diffuse.z), enters_45.z)) };
    if (r.surface_settings.transmission > 0.0f32) {
        let eta_61 = (1.0f32 / r.surface_settings.ior);
        let e_63 = cosine_inside(r, cosine_11);
        let e_64 = sub(mul(splat(eta_61), cosine_11), e_63);
        let refracted_67 = Vec3 { x: sub(mul(n_7.x, e_64), mul(view_a3.x, splat(eta_61))), y: sub(mul(n_7.y, e_64), mul(view_a3.y, splat(eta_61))), z: sub(mul(n_7.z, e_64), mul(view_a3.z, splat(eta_61))) };
        let seen_72 = environment_in_lobe(r, ex, refracted_67, mul(splat((1.0f32 - eta_61)), mirror_12.lean));
        let e_73 = light_v0;
        light_v0 = Vec3 { x: add(e_73.x, mul(seen_72.x, mul(material_a4.transmitted.x, enters_45.x))), y: add(e_73.y, mul(seen_72.y, mul(material_a4.transmitted.y, enters_45.y))), z: add(e_73.z, mul(seen_72.z, mul(material_a4.transmitted.z, enters_45.z))) };
    }
    let e_78 = light_v0;
    return Vec3 { x: mul(e_78.x, splat(params_a5.x)), y: mul(e_78.y, splat(params_a5.x)), z: mul(e_78.z, splat(params_a5.x)) };
} }
lanes! { fn hemisphere_grade(r: &Resources<'_>, normal_a0: Vec3<F>, ground_a1: f32) -> F {
    return add(splat(ground_a1), mul(splat((1.0f32 - ground_a1)), add(splat(0.5f32), mul(splat(0.5f32), normal_a0.y))));
} }
lanes! { fn ambient_hemisphere(r: &Resources<'_>, at_a0: &Entered, hit_a1: &Hit, normal_a2: Vec3<F>, view_a3: Vec3<F>, material_a4: &Material, params_a5: Vec4<f32>) -> Vec3<F> {
    let e_13 = hemisphere_grade(r, normal_a2, params_a5.x);
    return Vec3 { x: mul(mul(splat(r.frame.ambient.x), material_a4.around.x), e_13), y: mul(mul(splat(r.frame.ambient.y), material_a4.around.y), e_13), z: mul(mul(splat(r.frame.ambient.z), material_a4.around.z), e_13) };
} }
lanes! { fn ambient_occlusion(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, normal_a2: Vec3<F>, view_a3: Vec3<F>, material_a4: &Material, params_a5: Vec4<f32>) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let e_14 = ambient_texel_between(r, ex, Vec2 { x: hit_a1.uv.x, y: hit_a1.uv.y }, at_a0.level);
    return Vec3 { x: mul(mul(splat(r.frame.ambient.x), material_a4.around.x), e_14.x), y: mul(mul(splat(r.frame.ambient.y), material_a4.around.y), e_14.x), z: mul(mul(splat(r.frame.ambient.z), material_a4.around.z), e_14.x) };
} }
lanes! { fn ambient_sky(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, normal_a2: Vec3<F>, view_a3: Vec3<F>, material_a4: &Material, params_a5: Vec4<f32>) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let e_8 = ambient_texel_between(r, ex, Vec2 { x: hit_a1.uv.x, y: hit_a1.uv.y }, at_a0.level);
    let open_10 = from_tangent_space(r, at_a0, Vec3 { x: e_8.x, y: e_8.y, z: e_8.z });
    let e_13 = max_with(sqrt(add(add(mul(open_10.x, open_10.x), mul(open_10.y, open_10.y)), mul(open_10.z, open_10.z))), splat(1e-6f32));
    let toward_18 = Vec3 { x: mul(splat(0.5f32), add(div(open_10.x, e_13), normal_a2.x)), y: mul(splat(0.5f32), add(div(open_10.y, e_13), normal_a2.y)), z: mul(splat(0.5f32), add(div(open_10.z, e_13), normal_a2.z)) };
    let part_21 = max_with(add(add(add(mul(normal_a2.x, open_10.x), mul(normal_a2.y, open_10.y)), mul(normal_a2.z, open_10.z)), splat(0.0f32)), splat(0.0f32));
    let e_29 = hemisphere_grade(r, toward_18, params_a5.x);
    let e_30 = mul(part_21, e_29);
    return Vec3 { x: mul(mul(splat(r.frame.ambient.x), material_a4.around.x), e_30), y: mul(mul(splat(r.frame.ambient.y), material_a4.around.y), e_30), z: mul(mul(splat(r.frame.ambient.z), material_a4.around.z), e_30) };
} }
lanes! { fn ambient_stage(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, normal_a2: Vec3<F>, view_a3: Vec3<F>, material_a4: &Material) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    match r.surface_settings.choices[11].number {
        0u32 => {
            let e_15 = ambient_constant(r, at_a0, hit_a1, normal_a2, view_a3, material_a4, r.surface_settings.choices[11].params);
            return e_15;
        }
        1u32 => {
            let e_21 = ambient_occlusion(r, ex, at_a0, hit_a1, normal_a2, view_a3, material_a4, r.surface_settings.choices[11].params);
            return e_21;
        }
        2u32 => {
            let e_27 = ambient_bent_normal(r, ex, at_a0, hit_a1, normal_a2, view_a3, material_a4, r.surface_settings.choices[11].params);
            return e_27;
        }
        3u32 => {
            let e_33 = ambient_bounce(r, ex, at_a0, hit_a1, normal_a2, view_a3, material_a4, r.surface_settings.choices[11].params);
            return e_33;
        }
        4u32 => {
            let e_39 = ambient_environment(r, ex, at_a0, hit_a1, normal_a2, view_a3, material_a4, r.surface_settings.choices[11].params);
            return e_39;
        }
        5u32 => {
            let e_45 = ambient_hemisphere(r, at_a0, hit_a1, normal_a2, view_a3, material_a4, r.surface_settings.choices[11].params);
            return e_45;
        }
        _ => {
            let e_51 = ambient_sky(r, ex, at_a0, hit_a1, normal_a2, view_a3, material_a4, r.surface_settings.choices[11].params);
            return e_51;
        }
    }
} }
lanes! { fn toward_image(r: &Resources<'_>, within: M, image_a0: &Image, point_a1: Vec3<F>) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let c1 = image_a0.has_eye;
    let e_4 = Vec3 { x: sub(image_a0.eye.x, point_a1.x), y: sub(image_a0.eye.y, point_a1.y), z: sub(image_a0.eye.z, point_a1.z) };
    let length2 = sqrt(add(add(mul(e_4.x, e_4.x), mul(e_4.y, e_4.y)), mul(e_4.z, e_4.z)));
    let e_5 = Vec3 { x: div(e_4.x, length2), y: div(e_4.y, length2), z: div(e_4.z, length2) };
    ret = e_5;
    ex = and_not(ex, c1);
    let y3 = Vec3 { x: image_a0.toward.x, y: image_a0.toward.y, z: image_a0.toward.z };
    return Vec3 { x: sel(ex, y3.x, ret.x), y: sel(ex, y3.y, ret.y), z: sel(ex, y3.z, ret.z) };
} }
lanes! { fn eighth_turn(r: &Resources<'_>, tangent_a0: F) -> F {
    let s_1 = mul(tangent_a0, tangent_a0);
    let series_14 = add(splat(0.999866f32), mul(s_1, add(splat((-0.3302995f32)), mul(s_1, add(splat(0.180141f32), mul(s_1, add(splat((-0.085133f32)), mul(s_1, splat(0.0208351f32)))))))));
    return mul(mul(tangent_a0, series_14), splat(0.15915494f32));
} }
lanes! { fn turn_of(r: &Resources<'_>, within: M, v_a0: Vec2<F>) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let mut turn_v0: F = splat(0f32);
    let x_2 = abs(v_a0.x);
    let y_4 = abs(v_a0.y);
    let c1 = not(gt(add(x_2, y_4), splat(0.0f32)));
    ret = splat(0.0f32);
    ex = and_not(ex, c1);
    if none(ex) { return ret; }
    let e_13 = eighth_turn(r, div(min(x_2, y_4), max(x_2, y_4)));
    turn_v0 = e_13;
    let c2 = gt(y_4, x_2);
    let e_16 = turn_v0;
    turn_v0 = sel(c2, sub(splat(0.25f32), e_16), turn_v0);
    let c3 = lt(v_a0.x, splat(0.0f32));
    let e_22 = turn_v0;
    turn_v0 = sel(c3, sub(splat(0.5f32), e_22), turn_v0);
    let c4 = lt(v_a0.y, splat(0.0f32));
    let e_28 = turn_v0;
    turn_v0 = sel(c4, sub(splat(1.0f32), e_28), turn_v0);
    let e_31 = turn_v0;
    let e_32 = turn_v0;
    return sel(ex, sel(ge(e_32, splat(1.0f32)), splat(0.0f32), e_31), ret);
} }
lanes! { fn depth_in_image(r: &Resources<'_>, image_a0: &Image, point_a1: Vec3<F>) -> F {
    return add(add(add(add(mul(image_a0.depth.x, point_a1.x), mul(image_a0.depth.y, point_a1.y)), mul(image_a0.depth.z, point_a1.z)), splat(0.0f32)), image_a0.depth.w);
} }
lanes! { fn place_in_image(r: &Resources<'_>, image_a0: &Image, point_a1: Vec3<F>) -> Vec3<F> {
    let depth_2 = depth_in_image(r, image_a0, point_a1);
    let u_12 = min_with(max_with(div(add(add(add(add(mul(image_a0.u.x, point_a1.x), mul(image_a0.u.y, point_a1.y)), mul(image_a0.u.z, point_a1.z)), splat(0.0f32)), image_a0.u.w), depth_2), splat(0.0f32)), splat(1.0f32));
    let v_22 = min_with(max_with(div(add(add(add(add(mul(image_a0.v.x, point_a1.x), mul(image_a0.v.y, point_a1.y)), mul(image_a0.v.z, point_a1.z)), splat(0.0f32)), image_a0.v.w), depth_2), splat(0.0f32)), splat(1.0f32));
    let h_29 = div(add(add(add(add(mul(image_a0.height.x, point_a1.x), mul(image_a0.height.y, point_a1.y)), mul(image_a0.height.z, point_a1.z)), splat(0.0f32)), image_a0.height.w), depth_2);
    return Vec3 { x: add(image_a0.corner.x, mul(image_a0.extent.x, u_12)), y: add(image_a0.corner.y, mul(image_a0.extent.y, v_22)), z: h_29 };
} }
lanes! { fn tangent_of_image(r: &Resources<'_>, image_a0: &Image) -> Vec3<F> {
    let across_7 = Vec3 { x: sub(image_a0.u.x, mul(splat(0.5f32), image_a0.depth.x)), y: sub(image_a0.u.y, mul(splat(0.5f32), image_a0.depth.y)), z: sub(image_a0.u.z, mul(splat(0.5f32), image_a0.depth.z)) };
    let e_11 = mul(add(add(add(mul(across_7.x, across_7.x), mul(across_7.y, across_7.y)), mul(across_7.z, across_7.z)), splat(0.0f32)), image_a0.extent.x);
    return Vec3 { x: div(across_7.x, e_11), y: div(across_7.y, e_11), z: div(across_7.z, e_11) };
} }
lanes! { fn stretch_in_image(r: &Resources<'_>, within: M, image_a0: &Image, point_a1: Vec3<F>, height_a2: F) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let c1 = not(image_a0.has_eye);
    ret = splat(1.0f32);
    ex = and_not(ex, c1);
    if none(ex) { return ret; }
    let toward_6 = toward_image(r, ex, image_a0, point_a1);
    let change_14 = sub(add(add(add(mul(image_a0.height.x, toward_6.x), mul(image_a0.height.y, toward_6.y)), mul(image_a0.height.z, toward_6.z)), splat(0.0f32)), mul(height_a2, add(add(add(mul(image_a0.depth.x, toward_6.x), mul(image_a0.depth.y, toward_6.y)), mul(image_a0.depth.z, toward_6.z)), splat(0.0f32))));
    let e_15 = depth_in_image(r, image_a0, point_a1);
    return sel(ex, div(e_15, mul(change_14, splat(r.surface_settings.scale_m))), ret);
} }
lanes! { fn height_size(r: &Resources<'_>, level_a0: U) -> Vec2<F> {
    let e_1 = height_texels(r, level_a0);
    return Vec2 { x: f_of_i(e_1.x), y: f_of_i(e_1.y) };
} }
lanes! { fn wrapped_cell_ll(r: &Resources<'_>, within: M, cell_a0: Vec2<I>, level_a1: U) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let n_2 = height_texels(r, level_a1);
    let k_3 = i_of_u(level_a1);
    let i_6 = wrap_pair(r, ex, cell_a0.x, n_2.x);
    let j_9 = wrap_pair(r, ex, cell_a0.y, n_2.y);
    let e_14 = height_texel_of_each(&r.height_map, ex, i_6.x, j_9.x, k_3);
    let e_20 = height_texel_of_each(&r.height_map, ex, i_6.y, j_9.x, k_3);
    let e_26 = height_texel_of_each(&r.height_map, ex, i_6.x, j_9.y, k_3);
    let e_32 = height_texel_of_each(&r.height_map, ex, i_6.y, j_9.y, k_3);
    return Vec4 { x: e_14.x, y: e_20.x, z: e_26.x, w: e_32.x };
} }
lanes! { fn wrapped_cell_ls(r: &Resources<'_>, within: M, cell_a0: Vec2<I>, level_a1: u32) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let n_2 = height_texels(r, splat_u(level_a1));
    let k_3 = (level_a1 as i32);
    let i_6 = wrap_pair(r, ex, cell_a0.x, n_2.x);
    let j_9 = wrap_pair(r, ex, cell_a0.y, n_2.y);
    let e_14 = height_texel(&r.height_map, i_6.x, j_9.x, k_3);
    let e_20 = height_texel(&r.height_map, i_6.y, j_9.x, k_3);
    let e_26 = height_texel(&r.height_map, i_6.x, j_9.y, k_3);
    let e_32 = height_texel(&r.height_map, i_6.y, j_9.y, k_3);
    return Vec4 { x: e_14.x, y: e_20.x, z: e_26.x, w: e_32.x };
} }
lanes! { fn height_cell_ll(r: &Resources<'_>, within: M, cell_a0: Vec2<I>, level_a1: U) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let e_2 = wrapped_cell_ll(r, ex, cell_a0, level_a1);
    return e_2;
} }
lanes! { fn height_cell_ls(r: &Resources<'_>, within: M, cell_a0: Vec2<I>, level_a1: u32) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let e_2 = wrapped_cell_ls(r, ex, cell_a0, level_a1);
    return e_2;
} }
lanes! { fn height_at_ll(r: &Resources<'_>, within: M, uv_a0: Vec2<F>, level_a1: U) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let e_2 = height_size(r, level_a1);
    let point_7 = Vec2 { x: sub(mul(uv_a0.x, e_2.x), splat(0.5f32)), y: sub(mul(uv_a0.y, e_2.y), splat(0.5f32)) };
    let cell_8 = cell_of(r, point_7);
    let f_9 = Vec2 { x: sub(point_7.x, cell_8.x), y: sub(point_7.y, cell_8.y) };
    let h_11 = height_cell_ll(r, ex, Vec2 { x: i_of_small(cell_8.x), y: i_of_small(cell_8.y) }, level_a1);
    let top_18 = add(h_11.x, mul(sub(h_11.y, h_11.x), f_9.x));
    let bottom_25 = add(h_11.z, mul(sub(h_11.w, h_11.z), f_9.x));
    return add(top_18, mul(sub(bottom_25, top_18), f_9.y));
} }
lanes! { fn height_at_ls(r: &Resources<'_>, within: M, uv_a0: Vec2<F>, level_a1: u32) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let e_2 = height_size(r, splat_u(level_a1));
    let point_7 = Vec2 { x: sub(mul(uv_a0.x, e_2.x), splat(0.5f32)), y: sub(mul(uv_a0.y, e_2.y), splat(0.5f32)) };
    let cell_8 = cell_of(r, point_7);
    let f_9 = Vec2 { x: sub(point_7.x, cell_8.x), y: sub(point_7.y, cell_8.y) };
    let h_11 = height_cell_ls(r, ex, Vec2 { x: i_of_small(cell_8.x), y: i_of_small(cell_8.y) }, level_a1);
    let top_18 = add(h_11.x, mul(sub(h_11.y, h_11.x), f_9.x));
    let bottom_25 = add(h_11.z, mul(sub(h_11.w, h_11.z), f_9.x));
    return add(top_18, mul(sub(bottom_25, top_18), f_9.y));
} }
lanes! { fn angle_to_image(r: &Resources<'_>, within: M, image_a0: &Image, point_a1: Vec3<F>, view_a2: Vec3<F>, asked_a3: bool) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let toward_4 = toward_image(r, ex, image_a0, point_a1);
    let beside_5 = Vec3 { x: sub(mul(toward_4.y, view_a2.z), mul(toward_4.z, view_a2.y)), y: sub(mul(toward_4.z, view_a2.x), mul(toward_4.x, view_a2.z)), z: sub(mul(toward_4.x, view_a2.y), mul(toward_4.y, view_a2.x)) };
    let angle_10 = turn_of(r, ex, Vec2 { x: add(add(add(mul(toward_4.x, view_a2.x), mul(toward_4.y, view_a2.y)), mul(toward_4.z, view_a2.z)), splat(0.0f32)), y: sqrt(add(add(add(mul(beside_5.x, beside_5.x), mul(beside_5.y, beside_5.y)), mul(beside_5.z, beside_5.z)), splat(0.0f32))) });
    if !asked_a3 {
        return angle_10;
    }
    let place_12 = place_in_image(r, image_a0, point_a1);
    let width_20 = mul(image_a0.extent.x, splat((r.surface_settings.height_size.x as f32)));
    let e_21 = tangent_of_image(r, image_a0);
    let e_26 = depth_in_image(r, image_a0, point_a1);
    let wider_27 = mul(mul(sqrt(add(add(mul(e_21.x, e_21.x), mul(e_21.y, e_21.y)), mul(e_21.z, e_21.z))), image_a0.extent.x), e_26);
    let e_29 = stretch_in_image(r, ex, image_a0, point_a1, place_12.z);
    let deeper_33 = mul(e_29, splat(r.surface_settings.scale_m));
    let e_37 = height_at_ls(r, ex, Vec2 { x: place_12.x, y: place_12.y }, 0u32);
    let off_39 = abs(sub(place_12.z, e_37));
    return add(angle_10, sel(le(mul(mul(off_39, width_20), div(deeper_33, wider_27)), splat(2.0f32)), splat(0.0f32), splat(2.0f32)));
} }
lanes! { fn apart_from_edge(r: &Resources<'_>, place_a0: Vec3<F>, a_a1: Vec3<F>, b_a2: Vec3<F>) -> F {
    let way_3 = Vec3 { x: sub(b_a2.x, a_a1.x), y: sub(b_a2.y, a_a1.y), z: sub(b_a2.z, a_a1.z) };
    let part_10 = min_with(max_with(div(add(add(add(mul(sub(place_a0.x, a_a1.x), way_3.x), mul(sub(place_a0.y, a_a1.y), way_3.y)), mul(sub(place_a0.z, a_a1.z), way_3.z)), splat(0.0f32)), add(add(add(mul(way_3.x, way_3.x), mul(way_3.y, way_3.y)), mul(way_3.z, way_3.z)), splat(0.0f32))), splat(0.0f32)), splat(1.0f32));
    let apart_13 = Vec3 { x: sub(add(a_a1.x, mul(way_3.x, part_10)), place_a0.x), y: sub(add(a_a1.y, mul(way_3.y, part_10)), place_a0.y), z: sub(add(a_a1.z, mul(way_3.z, part_10)), place_a0.z) };
    return add(add(add(mul(apart_13.x, apart_13.x), mul(apart_13.y, apart_13.y)), mul(apart_13.z, apart_13.z)), splat(0.0f32));
} }
lanes! { fn weights_under(r: &Resources<'_>, place_a0: Vec3<F>, a_a1: Vec3<F>, b_a2: Vec3<F>, c_a3: Vec3<F>) -> Vec3<F> {
    let e_4 = Vec3 { x: sub(b_a2.x, a_a1.x), y: sub(b_a2.y, a_a1.y), z: sub(b_a2.z, a_a1.z) };
    let e_5 = Vec3 { x: sub(c_a3.x, a_a1.x), y: sub(c_a3.y, a_a1.y), z: sub(c_a3.z, a_a1.z) };
    let normal_6 = Vec3 { x: sub(mul(e_4.y, e_5.z), mul(e_4.z, e_5.y)), y: sub(mul(e_4.z, e_5.x), mul(e_4.x, e_5.z)), z: sub(mul(e_4.x, e_5.y), mul(e_4.y, e_5.x)) };
    let e_7 = Vec3 { x: sub(c_a3.x, b_a2.x), y: sub(c_a3.y, b_a2.y), z: sub(c_a3.z, b_a2.z) };
    let e_8 = Vec3 { x: sub(place_a0.x, b_a2.x), y: sub(place_a0.y, b_a2.y), z: sub(place_a0.z, b_a2.z) };
    let e_11 = Vec3 { x: sub(a_a1.x, c_a3.x), y: sub(a_a1.y, c_a3.y), z: sub(a_a1.z, c_a3.z) };
    let e_12 = Vec3 { x: sub(place_a0.x, c_a3.x), y: sub(place_a0.y, c_a3.y), z: sub(place_a0.z, c_a3.z) };
    let e_15 = Vec3 { x: sub(b_a2.x, a_a1.x), y: sub(b_a2.y, a_a1.y), z: sub(b_a2.z, a_a1.z) };
    let e_16 = Vec3 { x: sub(place_a0.x, a_a1.x), y: sub(place_a0.y, a_a1.y), z: sub(place_a0.z, a_a1.z) };
    return Vec3 { x: add(add(add(mul(sub(mul(e_7.y, e_8.z), mul(e_7.z, e_8.y)), normal_6.x), mul(sub(mul(e_7.z, e_8.x), mul(e_7.x, e_8.z)), normal_6.y)), mul(sub(mul(e_7.x, e_8.y), mul(e_7.y, e_8.x)), normal_6.z)), splat(0.0f32)), y: add(add(add(mul(sub(mul(e_11.y, e_12.z), mul(e_11.z, e_12.y)), normal_6.x), mul(sub(mul(e_11.z, e_12.x), mul(e_11.x, e_12.z)), normal_6.y)), mul(sub(mul(e_11.x, e_12.y), mul(e_11.y, e_12.x)), normal_6.z)), splat(0.0f32)), z: add(add(add(mul(sub(mul(e_15.y, e_16.z), mul(e_15.z, e_16.y)), normal_6.x), mul(sub(mul(e_15.z, e_16.x), mul(e_15.x, e_16.z)), normal_6.y)), mul(sub(mul(e_15.x, e_16.y), mul(e_15.y, e_16.x)), normal_6.z)), splat(0.0f32)) };
} }
lanes! { fn apart_from_triangle(r: &Resources<'_>, within: M, place_a0: Vec3<F>, a_a1: Vec3<F>, b_a2: Vec3<F>, c_a3: Vec3<F>) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let weights_4 = weights_under(r, place_a0, a_a1, b_a2, c_a3);
    let (b1, c2) = (ex, ge(min(min(weights_4.x, weights_4.y), weights_4.z), splat(0.0f32)));
    ex = and(b1, c2);
    if any(ex) {
        let e_12 = Vec3 { x: sub(b_a2.x, a_a1.x), y: sub(b_a2.y, a_a1.y), z: sub(b_a2.z, a_a1.z) };
        let e_13 = Vec3 { x: sub(c_a3.x, a_a1.x), y: sub(c_a3.y, a_a1.y), z: sub(c_a3.z, a_a1.z) };
        let normal_14 = Vec3 { x: sub(mul(e_12.y, e_13.z), mul(e_12.z, e_13.y)), y: sub(mul(e_12.z, e_13.x), mul(e_12.x, e_13.z)), z: sub(mul(e_12.x, e_13.y), mul(e_12.y, e_13.x)) };
        let above_16 = add(add(add(mul(sub(place_a0.x, a_a1.x), normal_14.x), mul(sub(place_a0.y, a_a1.y), normal_14.y)), mul(sub(place_a0.z, a_a1.z), normal_14.z)), splat(0.0f32));
        ret = div(mul(above_16, above_16), add(add(add(mul(normal_14.x, normal_14.x), mul(normal_14.y, normal_14.y)), mul(normal_14.z, normal_14.z)), splat(0.0f32)));
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    if none(ex) { return ret; }
    let e_20 = apart_from_edge(r, place_a0, a_a1, b_a2);
    let e_21 = apart_from_edge(r, place_a0, b_a2, c_a3);
    let first_22 = min(e_20, e_21);
    let e_23 = apart_from_edge(r, place_a0, c_a3, a_a1);
    return sel(ex, min(first_22, e_23), ret);
} }
lanes! { fn near_uv(r: &Resources<'_>, uv_a0: Vec2<F>) -> Vec2<F> {
    if (r.surface_settings.wrap == 0u32) {
        return Vec2 { x: sub(uv_a0.x, floor(uv_a0.x)), y: sub(uv_a0.y, floor(uv_a0.y)) };
    }
    if (r.surface_settings.wrap == 2u32) {
        return Vec2 { x: sub(uv_a0.x, mul(splat(2.0f32), floor(mul(splat(0.5f32), uv_a0.x)))), y: sub(uv_a0.y, mul(splat(2.0f32), floor(mul(splat(0.5f32), uv_a0.y)))) };
    }
    return uv_a0;
} }
lanes! { fn inside_unit(r: &Resources<'_>, within: M, x0_a0: F, dx_a1: F, interval_a2: Vec2<F>) -> Vec2<F> {
    let mut ex = within;
    let mut ret: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    let mut both_v0: M = splat_m(false);
    let (b1, c2) = (ex, eq(dx_a1, splat(0.0f32)));
    ex = and(b1, c2);
    if any(ex) {
        both_v0 = or(lt(x0_a0, splat(0.0f32)), gt(x0_a0, splat(1.0f32)));
        let e_13 = both_v0;
        let (b3, c4) = (ex, e_13);
        ex = and(b3, c4);
        if any(ex) {
            ret = Vec2 { x: splat(1.0f32), y: splat((-1.0f32)) };
            ex = no_lane();
        }
        ex = and_not(b3, c4);
        let y5 = interval_a2;
        ret = Vec2 { x: sel(ex, y5.x, ret.x), y: sel(ex, y5.y, ret.y) };
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    let a_19 = div(sub(splat(0.0f32), x0_a0), dx_a1);
    let b_22 = div(sub(splat(1.0f32), x0_a0), dx_a1);
    let y6 = Vec2 { x: max(interval_a2.x, min(a_19, b_22)), y: min(interval_a2.y, max(a_19, b_22)) };
    return Vec2 { x: sel(ex, y6.x, ret.x), y: sel(ex, y6.y, ret.y) };
} }
lanes! { fn slice_begin(r: &Resources<'_>, slice_a0: I) -> Vec2<I> {
    let size_5 = Vec3 { x: (r.surface_settings.volume.x as i32), y: (r.surface_settings.volume.y as i32), z: (r.surface_settings.volume.z as i32) };
    let in_row_10 = (r.surface_settings.volume.w as i32);
    let k_15 = min_i(max_i(slice_a0, splat_i(0i32)), splat_i(size_5.z.wrapping_sub(1i32)));
    let row_21 = i_of_f(div(add(f_of_i(k_15), splat(0.5f32)), splat((in_row_10 as f32))));
    return Vec2 { x: mul_i(sub_i(k_15, mul_i(row_21, splat_i(in_row_10))), splat_i(size_5.x)), y: mul_i(row_21, splat_i(size_5.y)) };
} }
lanes! { fn slice_cell(r: &Resources<'_>, within: M, cell_a0: Vec2<I>, slice_a1: I) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let size_6 = Vec3 { x: (r.surface_settings.volume.x as i32), y: (r.surface_settings.volume.y as i32), z: (r.surface_settings.volume.z as i32) };
    let begin_7 = slice_begin(r, slice_a1);
    let e_13 = wrap_pair(r, ex, cell_a0.x, splat_i(size_6.x));
    let i_14 = Vec2 { x: add_i(begin_7.x, e_13.x), y: add_i(begin_7.x, e_13.y) };
    let e_20 = wrap_pair(r, ex, cell_a0.y, splat_i(size_6.y));
    let j_21 = Vec2 { x: add_i(begin_7.y, e_20.x), y: add_i(begin_7.y, e_20.y) };
    let e_27 = height_texel(&r.height_map, i_14.x, j_21.x, 0i32);
    let e_34 = height_texel(&r.height_map, i_14.y, j_21.x, 0i32);
    let e_41 = height_texel(&r.height_map, i_14.x, j_21.y, 0i32);
    let e_48 = height_texel(&r.height_map, i_14.y, j_21.y, 0i32);
    return Vec4 { x: e_27.x, y: e_34.x, z: e_41.x, w: e_48.x };
} }
lanes! { fn voxel_cell(r: &Resources<'_>, within: M, cell_a0: Vec3<I>) -> VoxelCell {
    let mut ex = within;
    let mut ret: VoxelCell = zero_voxel_cell();
    let e_3 = slice_cell(r, ex, Vec2 { x: cell_a0.x, y: cell_a0.y }, cell_a0.z);
    let e_8 = slice_cell(r, ex, Vec2 { x: cell_a0.x, y: cell_a0.y }, add_i(cell_a0.z, splat_i(1i32)));
    return VoxelCell { low: e_3, high: e_8, };
} }
stage! { pub(super) fn pixel_direction(r: &Resources<'_>, pixel_a0: Vec2<F>) -> Vec3<F> {
    return Vec3 { x: add(add(splat(r.frame.corner.x), mul(splat(r.frame.right.x), pixel_a0.x)), mul(splat(r.frame.down.x), pixel_a0.y)), y: add(add(splat(r.frame.corner.y), mul(splat(r.frame.right.y), pixel_a0.x)), mul(splat(r.frame.down.y), pixel_a0.y)), z: add(add(splat(r.frame.corner.z), mul(splat(r.frame.right.z), pixel_a0.x)), mul(splat(r.frame.down.z), pixel_a0.y)) };
} }
lanes! { fn lift_of(r: &Resources<'_>, lift_a0: Vec3<F>, w_a1: Vec3<F>) -> F {
    return add(add(mul(mul(lift_a0.x, w_a1.y), w_a1.z), mul(mul(lift_a0.y, w_a1.z), w_a1.x)), mul(mul(lift_a0.z, w_a1.x), w_a1.y));
} }
lanes! { fn path_uv(r: &Resources<'_>, path_a0: &Path, t_a1: F) -> Vec2<F> {
    return Vec2 { x: add(path_a0.uv.x, mul(path_a0.duv.x, t_a1)), y: add(path_a0.uv.y, mul(path_a0.duv.y, t_a1)) };
} }
lanes! { fn path_height(r: &Resources<'_>, path_a0: &Path, t_a1: F) -> F {
    return add(path_a0.h.x, mul(t_a1, add(path_a0.h.y, mul(t_a1, path_a0.h.z))));
} }
lanes! { fn path_slope(r: &Resources<'_>, path_a0: &Path, t_a1: F) -> F {
    return add(path_a0.h.y, mul(mul(splat(2.0f32), t_a1), path_a0.h.z));
} }
lanes! { fn bent_exit(r: &Resources<'_>, within: M, h_a0: Vec3<F>) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let mut exit_v0: F = splat(3e38f32);
    let floor_5 = add(h_a0.x, splat(1e-6f32));
    let under_13 = sub(mul(h_a0.y, h_a0.y), mul(mul(splat(4.0f32), h_a0.z), floor_5));
    let (b1, c2) = (ex, ge(under_13, splat(0.0f32)));
    ex = and(b1, c2);
    if any(ex) {
        let (b3, c4) = (ex, lt(h_a0.y, splat(0.0f32)));
        ex = and(b3, c4);
        if any(ex) {
            exit_v0 = sel(ex, div(mul(splat(2.0f32), floor_5), sub(sqrt(under_13), h_a0.y)), exit_v0);
        }
        ex = and_not(b3, c4);
        if any(ex) {
            let c5 = lt(h_a0.z, splat(0.0f32));
            exit_v0 = sel(and(ex, c5), div(add(h_a0.y, sqrt(under_13)), mul(splat((-2.0f32)), h_a0.z)), exit_v0);
        }
        ex = b3;
    }
    ex = b1;
    let room_37 = sub(splat(1.0f32), h_a0.x);
    let above_45 = add(mul(h_a0.y, h_a0.y), mul(mul(splat(4.0f32), h_a0.z), room_37));
    let (b6, c7) = (ex, ge(above_45, splat(0.0f32)));
    ex = and(b6, c7);
    if any(ex) {
        let (b8, c9) = (ex, gt(h_a0.y, splat(0.0f32)));
        ex = and(b8, c9);
        if any(ex) {
            let e_51 = exit_v0;
            exit_v0 = sel(ex, min(e_51, div(mul(splat(2.0f32), room_37), add(h_a0.y, sqrt(above_45)))), exit_v0);
        }
        ex = and_not(b8, c9);
        if any(ex) {
            let c10 = gt(h_a0.z, splat(0.0f32));
            let e_62 = exit_v0;
            exit_v0 = sel(and(ex, c10), min(e_62, div(sub(sqrt(above_45), h_a0.y), mul(splat(2.0f32), h_a0.z))), exit_v0);
        }
        ex = b8;
    }
    ex = b6;
    let e_71 = exit_v0;
    return e_71;
} }
lanes! { fn ordered(r: &Resources<'_>, pixel_a0: &PixelIn, place_a1: u32) -> Corner {
    let number_8 = (pixel_a0.shell.order.unbounded_shr(2u32.wrapping_mul(place_a1)) & 3u32);
    let e_15 = r.corner_value(number_8, Vec3 { x: pixel_a0.a.position.x, y: pixel_a0.a.position.y, z: pixel_a0.a.position.z }, Vec3 { x: pixel_a0.b.position.x, y: pixel_a0.b.position.y, z: pixel_a0.b.position.z }, Vec3 { x: pixel_a0.c.position.x, y: pixel_a0.c.position.y, z: pixel_a0.c.position.z });
    let e_19 = r.corner_value(number_8, Vec3 { x: pixel_a0.a.normal.x, y: pixel_a0.a.normal.y, z: pixel_a0.a.normal.z }, Vec3 { x: pixel_a0.b.normal.x, y: pixel_a0.b.normal.y, z: pixel_a0.b.normal.z }, Vec3 { x: pixel_a0.c.normal.x, y: pixel_a0.c.normal.y, z: pixel_a0.c.normal.z });
    let e_23 = r.corner_value(number_8, Vec3 { x: pixel_a0.a.tangent.x, y: pixel_a0.a.tangent.y, z: pixel_a0.a.tangent.z }, Vec3 { x: pixel_a0.b.tangent.x, y: pixel_a0.b.tangent.y, z: pixel_a0.b.tangent.z }, Vec3 { x: pixel_a0.c.tangent.x, y: pixel_a0.c.tangent.y, z: pixel_a0.c.tangent.z });
    let e_27 = r.corner_value(number_8, Vec3 { x: pixel_a0.a.bitangent.x, y: pixel_a0.a.bitangent.y, z: pixel_a0.a.bitangent.z }, Vec3 { x: pixel_a0.b.bitangent.x, y: pixel_a0.b.bitangent.y, z: pixel_a0.b.bitangent.z }, Vec3 { x: pixel_a0.c.bitangent.x, y: pixel_a0.c.bitangent.y, z: pixel_a0.c.bitangent.z });
    let e_37 = r.corner_value(number_8, Vec3 { x: pixel_a0.a.uv.x, y: pixel_a0.a.uv.y, z: 0.0f32 }, Vec3 { x: pixel_a0.b.uv.x, y: pixel_a0.b.uv.y, z: 0.0f32 }, Vec3 { x: pixel_a0.c.uv.x, y: pixel_a0.c.uv.y, z: 0.0f32 });
    let e_42 = r.corner_value(number_8, Vec3 { x: pixel_a0.a.of_surface.x, y: pixel_a0.a.of_surface.y, z: pixel_a0.a.of_surface.z }, Vec3 { x: pixel_a0.b.of_surface.x, y: pixel_a0.b.of_surface.y, z: pixel_a0.b.of_surface.z }, Vec3 { x: pixel_a0.c.of_surface.x, y: pixel_a0.c.of_surface.y, z: pixel_a0.c.of_surface.z });
    return Corner { position: Vec3 { x: splat(e_15.x), y: splat(e_15.y), z: splat(e_15.z) }, normal: Vec3 { x: splat(e_19.x), y: splat(e_19.y), z: splat(e_19.z) }, tangent: Vec3 { x: splat(e_23.x), y: splat(e_23.y), z: splat(e_23.z) }, bitangent: Vec3 { x: splat(e_27.x), y: splat(e_27.y), z: splat(e_27.z) }, uv: Vec2 { x: splat(e_37.x), y: splat(e_37.y) }, of_surface: Vec3 { x: splat(e_42.x), y: splat(e_42.y), z: splat(e_42.z) }, };
} }
lanes! { fn uv_of(r: &Resources<'_>, pixel_a0: &PixelIn, weights_a1: Vec3<F>) -> Vec2<F> {
    let e_3 = ordered(r, pixel_a0, 0u32);
    let e_8 = ordered(r, pixel_a0, 1u32);
    let e_14 = ordered(r, pixel_a0, 2u32);
    return Vec2 { x: add(add(mul(e_3.uv.x, weights_a1.x), mul(e_8.uv.x, weights_a1.y)), mul(e_14.uv.x, weights_a1.z)), y: add(add(mul(e_3.uv.y, weights_a1.x), mul(e_8.uv.y, weights_a1.y)), mul(e_14.uv.y, weights_a1.z)) };
} }
lanes! { fn beside_chord(r: &Resources<'_>, pixel_a0: &PixelIn, a_a1: &ShellPoint, m_a2: &ShellPoint, b_a3: &ShellPoint, at_a4: &ShellPoint, part_a5: f32) -> F {
    let line_16 = Vec3 { x: add(a_a1.weights.x, mul(min_with(sub(b_a3.weights.x, a_a1.weights.x), splat(3e38f32)), splat(part_a5))), y: add(a_a1.weights.y, mul(min_with(sub(b_a3.weights.y, a_a1.weights.y), splat(3e38f32)), splat(part_a5))), z: add(a_a1.weights.z, mul(min_with(sub(b_a3.weights.z, a_a1.weights.z), splat(3e38f32)), splat(part_a5))) };
    let e_19 = uv_of(r, pixel_a0, Vec3 { x: sub(at_a4.weights.x, line_16.x), y: sub(at_a4.weights.y, line_16.y), z: sub(at_a4.weights.z, line_16.z) });
    let e_21 = height_size(r, splat_u(0u32));
    let apart_23 = Vec2 { x: abs(mul(e_19.x, e_21.x)), y: abs(mul(e_19.y, e_21.y)) };
    let bend_32 = mul(splat(2.0f32), sub(add(a_a1.height, b_a3.height), mul(splat(2.0f32), m_a2.height)));
    let slope_36 = sub(sub(b_a3.height, a_a1.height), bend_32);
    let height_41 = add(a_a1.height, mul(splat(part_a5), add(slope_36, mul(splat(part_a5), bend_32))));
    return max(max(apart_23.x, apart_23.y), div(abs(sub(at_a4.height, height_41)), splat(0.0625f32)));
} }
lanes! { fn between(r: &Resources<'_>, a_a0: &ShellPoint, b_a1: &ShellPoint) -> ShellPoint {
    return ShellPoint { weights: Vec3 { x: mul(splat(0.5f32), add(a_a0.weights.x, b_a1.weights.x)), y: mul(splat(0.5f32), add(a_a0.weights.y, b_a1.weights.y)), z: mul(splat(0.5f32), add(a_a0.weights.z, b_a1.weights.z)) }, height: mul(splat(0.5f32), add(a_a0.height, b_a1.height)), };
} }
lanes! { fn beyond_image(r: &Resources<'_>, image_a0: &Image) -> Vec2<F> {
    let e_6 = height_size(r, splat_u(0u32));
    return Vec2 { x: div(splat(0.5f32), mul(image_a0.extent.x, e_6.x)), y: div(splat(0.5f32), mul(image_a0.extent.y, e_6.y)) };
} }
lanes! { fn bitangent_of_image(r: &Resources<'_>, image_a0: &Image) -> Vec3<F> {
    let along_7 = Vec3 { x: sub(image_a0.v.x, mul(splat(0.5f32), image_a0.depth.x)), y: sub(image_a0.v.y, mul(splat(0.5f32), image_a0.depth.y)), z: sub(image_a0.v.z, mul(splat(0.5f32), image_a0.depth.z)) };
    let e_11 = mul(add(add(add(mul(along_7.x, along_7.x), mul(along_7.y, along_7.y)), mul(along_7.z, along_7.z)), splat(0.0f32)), image_a0.extent.y);
    return Vec3 { x: div(along_7.x, e_11), y: div(along_7.y, e_11), z: div(along_7.z, e_11) };
} }
lanes! { fn mixed(r: &Resources<'_>, seed_a0: U) -> U {
    let mut x_v0: U = splat_u(0u32);
    x_v0 = xor_u(seed_a0, shr_u(seed_a0, i_of_u(splat_u(16u32))));
    let e_5 = x_v0;
    x_v0 = mul_u(e_5, splat_u(2146121005u32));
    let e_8 = x_v0;
    let e_9 = x_v0;
    x_v0 = xor_u(e_8, shr_u(e_9, i_of_u(splat_u(15u32))));
    let e_13 = x_v0;
    x_v0 = mul_u(e_13, splat_u(2221713035u32));
    let e_16 = x_v0;
    let e_17 = x_v0;
    return xor_u(e_16, shr_u(e_17, i_of_u(splat_u(16u32))));
} }
lanes! { fn field_heights_gap(r: &Resources<'_>, within: M, path_a0: &Path, t_a1: F, params_a2: Vec4<f32>) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let e_3 = path_height(r, path_a0, t_a1);
    let e_4 = path_uv(r, path_a0, t_a1);
    let e_6 = height_at_ll(r, ex, e_4, path_a0.level);
    return sub(e_3, e_6);
} }
lanes! { fn in_slice(r: &Resources<'_>, corners_a0: Vec4<F>, part_a1: Vec2<F>) -> F {
    let top_8 = add(corners_a0.x, mul(sub(corners_a0.y, corners_a0.x), part_a1.x));
    let bottom_15 = add(corners_a0.z, mul(sub(corners_a0.w, corners_a0.z), part_a1.x));
    return add(top_8, mul(sub(bottom_15, top_8), part_a1.y));
} }
lanes! { fn field_at_voxel(r: &Resources<'_>, within: M, place_a0: Vec3<F>) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let first_1 = Vec3 { x: floor(place_a0.x), y: floor(place_a0.y), z: floor(place_a0.z) };
    let part_2 = Vec3 { x: sub(place_a0.x, first_1.x), y: sub(place_a0.y, first_1.y), z: sub(place_a0.z, first_1.z) };
    let cell_4 = voxel_cell(r, ex, Vec3 { x: i_of_f(first_1.x), y: i_of_f(first_1.y), z: i_of_f(first_1.z) });
    let low_7 = in_slice(r, Vec4 { x: cell_4.low.x, y: cell_4.low.y, z: cell_4.low.z, w: cell_4.low.w }, Vec2 { x: part_2.x, y: part_2.y });
    let e_10 = in_slice(r, Vec4 { x: cell_4.high.x, y: cell_4.high.y, z: cell_4.high.z, w: cell_4.high.w }, Vec2 { x: part_2.x, y: part_2.y });
    return add(low_7, mul(sub(e_10, low_7), part_2.z));
} }
lanes! { fn voxel_place(r: &Resources<'_>, at_a0: Vec3<F>) -> Vec3<F> {
    let e_1 = r.volume_size();
    return Vec3 { x: sub(mul(at_a0.x, splat(e_1.x)), splat(0.5f32)), y: sub(mul(at_a0.y, splat(e_1.y)), splat(0.5f32)), z: sub(mul(at_a0.z, splat(e_1.z)), splat(0.5f32)) };
} }
lanes! { fn field_at(r: &Resources<'_>, within: M, at_a0: Vec3<F>) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let e_1 = voxel_place(r, at_a0);
    let e_2 = field_at_voxel(r, ex, e_1);
    return e_2;
} }
lanes! { fn field_volume_gap(r: &Resources<'_>, within: M, path_a0: &Path, t_a1: F, params_a2: Vec4<f32>) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let e_3 = path_uv(r, path_a0, t_a1);
    let e_4 = path_height(r, path_a0, t_a1);
    let e_6 = field_at(r, ex, Vec3 { x: e_3.x, y: e_3.y, z: e_4 });
    return sub(splat(0.5f32), e_6);
} }
lanes! { fn field_motif_gap(r: &Resources<'_>, path_a0: &Path, t_a1: F, params_a2: Vec4<f32>) -> F {
    return splat(1.0f32);
} }
lanes! { fn field_gap_stage(r: &Resources<'_>, within: M, path_a0: &Path, t_a1: F) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    match r.surface_settings.choices[4].number {
        0u32 => {
            let e_12 = field_heights_gap(r, ex, path_a0, t_a1, r.surface_settings.choices[4].params);
            return e_12;
        }
        1u32 => {
            let e_18 = field_volume_gap(r, ex, path_a0, t_a1, r.surface_settings.choices[4].params);
            return e_18;
        }
        _ => {
            let e_24 = field_motif_gap(r, path_a0, t_a1, r.surface_settings.choices[4].params);
            return e_24;
        }
    }
} }
lanes! { fn path_gap(r: &Resources<'_>, within: M, path_a0: &Path, t_a1: F) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let e_2 = field_gap_stage(r, ex, path_a0, t_a1);
    return e_2;
} }
lanes! { fn gap_to(r: &Resources<'_>, path_a0: &Path, grid_a1: &Grid, cell_a2: Vec2<F>, h_a3: Vec4<F>, t_a4: F) -> Vec3<F> {
    let bx_7 = sub(h_a3.y, h_a3.x);
    let by_10 = sub(h_a3.z, h_a3.x);
    let twist_17 = add(sub(h_a3.x, h_a3.y), sub(h_a3.w, h_a3.z));
    let at_22 = Vec2 { x: add(sub(grid_a1.origin.x, cell_a2.x), mul(grid_a1.step.x, t_a4)), y: add(sub(grid_a1.origin.y, cell_a2.y), mul(grid_a1.step.y, t_a4)) };
    let z_32 = add(path_a0.h.x, mul(t_a4, add(path_a0.h.y, mul(t_a4, path_a0.h.z))));
    let dz_40 = add(path_a0.h.y, mul(mul(splat(2.0f32), t_a4), path_a0.h.z));
    return Vec3 { x: sub(z_32, add(add(add(h_a3.x, mul(bx_7, at_22.x)), mul(by_10, at_22.y)), mul(mul(twist_17, at_22.x), at_22.y))), y: sub(dz_40, add(add(mul(bx_7, grid_a1.step.x), mul(by_10, grid_a1.step.y)), mul(twist_17, add(mul(at_22.x, grid_a1.step.y), mul(at_22.y, grid_a1.step.x))))), z: sub(path_a0.h.z, mul(mul(twist_17, grid_a1.step.x), grid_a1.step.y)) };
} }
lanes! { fn object_none_cell_lls(r: &Resources<'_>, within: M, cell_a0: Vec2<I>, level_a1: U, params_a2: Vec4<f32>) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let e_3 = height_cell_ll(r, ex, cell_a0, level_a1);
    return e_3;
} }
lanes! { fn object_none_cell_lss(r: &Resources<'_>, within: M, cell_a0: Vec2<I>, level_a1: u32, params_a2: Vec4<f32>) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let e_3 = height_cell_ls(r, ex, cell_a0, level_a1);
    return e_3;
} }
lanes! { fn cell_of_images_ll(r: &Resources<'_>, within: M, cell_a0: Vec2<I>, level_a1: U) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let mut both_v0: M = splat_m(false);
    if (r.surface_settings.cells == 0u32) {
        let e_7 = height_cell_ll(r, ex, cell_a0, level_a1);
        return e_7;
    }
    if (r.surface_settings.cells == 2u32) {
        let h_13 = height_cell_ll(r, ex, cell_a0, level_a1);
        let most_20 = max(max(h_13.x, h_13.y), max(h_13.z, h_13.w));
        let least_27 = min(min(h_13.x, h_13.y), min(h_13.z, h_13.w));
        let c1 = gt(sub(most_20, least_27), splat(r.surface_settings.jump));
        ret = Vec4 { x: most_20, y: most_20, z: most_20, w: most_20 };
        ex = and_not(ex, c1);
        let y2 = h_13;
        return Vec4 { x: sel(ex, y2.x, ret.x), y: sel(ex, y2.y, ret.y), z: sel(ex, y2.z, ret.z), w: sel(ex, y2.w, ret.w) };
    }
    let dual_40 = Vec2 { x: shr_i(cell_a0.x, splat_u(1u32)), y: shr_i(cell_a0.y, splat_u(1u32)) };
    if none(ex) { return ret; }
    let h_41 = height_cell_ll(r, ex, dual_40, level_a1);
    let most_48 = max(max(h_41.x, h_41.y), max(h_41.z, h_41.w));
    let least_55 = min(min(h_41.x, h_41.y), min(h_41.z, h_41.w));
    let right_62 = eq_i(sub_i(sub_i(cell_a0.x, dual_40.x), dual_40.x), splat_i(1i32));
    let lower_69 = eq_i(sub_i(sub_i(cell_a0.y, dual_40.y), dual_40.y), splat_i(1i32));
    if !(r.surface_settings.cells == 3u32) {
        both_v0 = gt(sub(most_48, least_55), splat(r.surface_settings.jump));
    } else {
        both_v0 = splat_m(true);
    }
    let e_84 = both_v0;
    let c3 = e_84;
    let nearest_91 = sel(lower_69, sel(right_62, h_41.w, h_41.z), sel(right_62, h_41.y, h_41.x));
    let y4 = Vec4 { x: nearest_91, y: nearest_91, z: nearest_91, w: nearest_91 };
    ret = Vec4 { x: sel(and(ex, c3), y4.x, ret.x), y: sel(and(ex, c3), y4.y, ret.y), z: sel(and(ex, c3), y4.z, ret.z), w: sel(and(ex, c3), y4.w, ret.w) };
    ex = and_not(ex, c3);
    let top_97 = mul(splat(0.5f32), add(h_41.x, h_41.y));
    let bottom_102 = mul(splat(0.5f32), add(h_41.z, h_41.w));
    let left_107 = mul(splat(0.5f32), add(h_41.x, h_41.z));
    let side_112 = mul(splat(0.5f32), add(h_41.y, h_41.w));
    let middle_115 = mul(splat(0.5f32), add(top_97, bottom_102));
    let y5 = Vec4 { x: sel(lower_69, sel(right_62, middle_115, left_107), sel(right_62, top_97, h_41.x)), y: sel(lower_69, sel(right_62, side_112, middle_115), sel(right_62, h_41.y, top_97)), z: sel(lower_69, sel(right_62, bottom_102, h_41.z), sel(right_62, middle_115, left_107)), w: sel(lower_69, sel(right_62, h_41.w, bottom_102), sel(right_62, side_112, middle_115)) };
    return Vec4 { x: sel(ex, y5.x, ret.x), y: sel(ex, y5.y, ret.y), z: sel(ex, y5.z, ret.z), w: sel(ex, y5.w, ret.w) };
} }
lanes! { fn cell_of_images_ls(r: &Resources<'_>, within: M, cell_a0: Vec2<I>, level_a1: u32) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let mut both_v0: M = splat_m(false);
    if (r.surface_settings.cells == 0u32) {
        let e_7 = height_cell_ls(r, ex, cell_a0, level_a1);
        return e_7;
    }
    if (r.surface_settings.cells == 2u32) {
        let h_13 = height_cell_ls(r, ex, cell_a0, level_a1);
        let most_20 = max(max(h_13.x, h_13.y), max(h_13.z, h_13.w));
        let least_27 = min(min(h_13.x, h_13.y), min(h_13.z, h_13.w));
        let c1 = gt(sub(most_20, least_27), splat(r.surface_settings.jump));
        ret = Vec4 { x: most_20, y: most_20, z: most_20, w: most_20 };
        ex = and_not(ex, c1);
        let y2 = h_13;
        return Vec4 { x: sel(ex, y2.x, ret.x), y: sel(ex, y2.y, ret.y), z: sel(ex, y2.z, ret.z), w: sel(ex, y2.w, ret.w) };
    }
    let dual_40 = Vec2 { x: shr_i(cell_a0.x, splat_u(1u32)), y: shr_i(cell_a0.y, splat_u(1u32)) };
    if none(ex) { return ret; }
    let h_41 = height_cell_ls(r, ex, dual_40, level_a1);
    let most_48 = max(max(h_41.x, h_41.y), max(h_41.z, h_41.w));
    let least_55 = min(min(h_41.x, h_41.y), min(h_41.z, h_41.w));
    let right_62 = eq_i(sub_i(sub_i(cell_a0.x, dual_40.x), dual_40.x), splat_i(1i32));
    let lower_69 = eq_i(sub_i(sub_i(cell_a0.y, dual_40.y), dual_40.y), splat_i(1i32));
    if !(r.surface_settings.cells == 3u32) {
        both_v0 = gt(sub(most_48, least_55), splat(r.surface_settings.jump));
    } else {
        both_v0 = splat_m(true);
    }
    let e_84 = both_v0;
    let c3 = e_84;
    let nearest_91 = sel(lower_69, sel(right_62, h_41.w, h_41.z), sel(right_62, h_41.y, h_41.x));
    let y4 = Vec4 { x: nearest_91, y: nearest_91, z: nearest_91, w: nearest_91 };
    ret = Vec4 { x: sel(and(ex, c3), y4.x, ret.x), y: sel(and(ex, c3), y4.y, ret.y), z: sel(and(ex, c3), y4.z, ret.z), w: sel(and(ex, c3), y4.w, ret.w) };
    ex = and_not(ex, c3);
    let top_97 = mul(splat(0.5f32), add(h_41.x, h_41.y));
    let bottom_102 = mul(splat(0.5f32), add(h_41.z, h_41.w));
    let left_107 = mul(splat(0.5f32), add(h_41.x, h_41.z));
    let side_112 = mul(splat(0.5f32), add(h_41.y, h_41.w));
    let middle_115 = mul(splat(0.5f32), add(top_97, bottom_102));
    let y5 = Vec4 { x: sel(lower_69, sel(right_62, middle_115, left_107), sel(right_62, top_97, h_41.x)), y: sel(lower_69, sel(right_62, side_112, middle_115), sel(right_62, h_41.y, top_97)), z: sel(lower_69, sel(right_62, bottom_102, h_41.z), sel(right_62, middle_115, left_107)), w: sel(lower_69, sel(right_62, h_41.w, bottom_102), sel(right_62, side_112, middle_115)) };
    return Vec4 { x: sel(ex, y5.x, ret.x), y: sel(ex, y5.y, ret.y), z: sel(ex, y5.z, ret.z), w: sel(ex, y5.w, ret.w) };
} }
lanes! { fn object_depth_cell_lls(r: &Resources<'_>, within: M, cell_a0: Vec2<I>, level_a1: U, params_a2: Vec4<f32>) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let e_3 = cell_of_images_ll(r, ex, cell_a0, level_a1);
    return e_3;
} }
lanes! { fn object_depth_cell_lss(r: &Resources<'_>, within: M, cell_a0: Vec2<I>, level_a1: u32, params_a2: Vec4<f32>) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let e_3 = cell_of_images_ls(r, ex, cell_a0, level_a1);
    return e_3;
} }
lanes! { fn cell_of_mask_ll(r: &Resources<'_>, within: M, cell_a0: Vec2<I>, level_a1: U) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let h_2 = height_cell_ll(r, ex, cell_a0, level_a1);
    return Vec4 { x: sel(gt(h_2.x, splat(1e-5f32)), splat(1.0f32), splat(0.0f32)), y: sel(gt(h_2.y, splat(1e-5f32)), splat(1.0f32), splat(0.0f32)), z: sel(gt(h_2.z, splat(1e-5f32)), splat(1.0f32), splat(0.0f32)), w: sel(gt(h_2.w, splat(1e-5f32)), splat(1.0f32), splat(0.0f32)) };
} }
lanes! { fn cell_of_mask_ls(r: &Resources<'_>, within: M, cell_a0: Vec2<I>, level_a1: u32) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let h_2 = height_cell_ls(r, ex, cell_a0, level_a1);
    return Vec4 { x: sel(gt(h_2.x, splat(1e-5f32)), splat(1.0f32), splat(0.0f32)), y: sel(gt(h_2.y, splat(1e-5f32)), splat(1.0f32), splat(0.0f32)), z: sel(gt(h_2.z, splat(1e-5f32)), splat(1.0f32), splat(0.0f32)), w: sel(gt(h_2.w, splat(1e-5f32)), splat(1.0f32), splat(0.0f32)) };
} }
lanes! { fn object_hull_cell_lls(r: &Resources<'_>, within: M, cell_a0: Vec2<I>, level_a1: U, params_a2: Vec4<f32>) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let e_3 = cell_of_mask_ll(r, ex, cell_a0, level_a1);
    return e_3;
} }
lanes! { fn object_hull_cell_lss(r: &Resources<'_>, within: M, cell_a0: Vec2<I>, level_a1: u32, params_a2: Vec4<f32>) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let e_3 = cell_of_mask_ls(r, ex, cell_a0, level_a1);
    return e_3;
} }
lanes! { fn object_blend_cell_lls(r: &Resources<'_>, within: M, cell_a0: Vec2<I>, level_a1: U, params_a2: Vec4<f32>) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let e_3 = height_cell_ll(r, ex, cell_a0, level_a1);
    return e_3;
} }
lanes! { fn object_blend_cell_lss(r: &Resources<'_>, within: M, cell_a0: Vec2<I>, level_a1: u32, params_a2: Vec4<f32>) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let e_3 = height_cell_ls(r, ex, cell_a0, level_a1);
    return e_3;
} }
lanes! { fn object_cell_stage_ll(r: &Resources<'_>, within: M, cell_a0: Vec2<I>, level_a1: U) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    match r.surface_settings.choices[3].number {
        0u32 => {
            let e_12 = object_none_cell_lls(r, ex, cell_a0, level_a1, r.surface_settings.choices[3].params);
            return e_12;
        }
        1u32 => {
            let e_18 = object_depth_cell_lls(r, ex, cell_a0, level_a1, r.surface_settings.choices[3].params);
            return e_18;
        }
        2u32 => {
            let e_24 = object_hull_cell_lls(r, ex, cell_a0, level_a1, r.surface_settings.choices[3].params);
            return e_24;
        }
        _ => {
            let e_30 = object_blend_cell_lls(r, ex, cell_a0, level_a1, r.surface_settings.choices[3].params);
            return e_30;
        }
    }
} }
lanes! { fn object_cell_stage_ls(r: &Resources<'_>, within: M, cell_a0: Vec2<I>, level_a1: u32) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    match r.surface_settings.choices[3].number {
        0u32 => {
            let e_12 = object_none_cell_lss(r, ex, cell_a0, level_a1, r.surface_settings.choices[3].params);
            return e_12;
        }
        1u32 => {
            let e_18 = object_depth_cell_lss(r, ex, cell_a0, level_a1, r.surface_settings.choices[3].params);
            return e_18;
        }
        2u32 => {
            let e_24 = object_hull_cell_lss(r, ex, cell_a0, level_a1, r.surface_settings.choices[3].params);
            return e_24;
        }
        _ => {
            let e_30 = object_blend_cell_lss(r, ex, cell_a0, level_a1, r.surface_settings.choices[3].params);
            return e_30;
        }
    }
} }
lanes! { fn whole_cell(r: &Resources<'_>, cell_a0: Vec2<F>) -> Vec2<I> {
    return Vec2 { x: i_of_f(cell_a0.x), y: i_of_f(cell_a0.y) };
} }
lanes! { fn cell_gap_llll(r: &Resources<'_>, within: M, path_a0: &Path, grid_a1: &Grid, cell_a2: Vec2<F>, t_a3: F) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let e_4 = whole_cell(r, cell_a2);
    let e_6 = object_cell_stage_ll(r, ex, e_4, path_a0.level);
    let e_7 = gap_to(r, path_a0, grid_a1, cell_a2, e_6, t_a3);
    return e_7;
} }
lanes! { fn cell_gap_llls(r: &Resources<'_>, within: M, path_a0: &Path, grid_a1: &Grid, cell_a2: Vec2<F>, t_a3: f32) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let e_4 = whole_cell(r, cell_a2);
    let e_6 = object_cell_stage_ll(r, ex, e_4, path_a0.level);
    let e_7 = gap_to(r, path_a0, grid_a1, cell_a2, e_6, splat(t_a3));
    return e_7;
} }
lanes! { fn cell_leave(r: &Resources<'_>, grid_a0: &Grid, cell_a1: Vec2<F>) -> Vec2<F> {
    let ahead_13 = Vec2 { x: sel(gt(grid_a0.step.x, splat(0.0f32)), splat(1.0f32), splat(0.0f32)), y: sel(gt(grid_a0.step.y, splat(0.0f32)), splat(1.0f32), splat(0.0f32)) };
    let leave_18 = Vec2 { x: div(sub(add(cell_a1.x, ahead_13.x), grid_a0.origin.x), grid_a0.step.x), y: div(sub(add(cell_a1.y, ahead_13.y), grid_a0.origin.y), grid_a0.step.y) };
    return Vec2 { x: sel(gt(abs(grid_a0.step.x), splat(0.0f32)), leave_18.x, splat(3e38f32)), y: sel(gt(abs(grid_a0.step.y), splat(0.0f32)), leave_18.y, splat(3e38f32)) };
} }
lanes! { fn cell_next(r: &Resources<'_>, within: M, grid_a0: &Grid, cell_a1: Vec2<F>, leave_a2: Vec2<F>) -> Vec2<F> {
    let mut ex = within;
    let mut ret: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    let mut next_v0: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    next_v0 = cell_a1;
    let c1 = le(leave_a2.x, leave_a2.y);
    next_v0.x = sel(c1, add(cell_a1.x, sel(gt(grid_a0.step.x, splat(0.0f32)), splat(1.0f32), splat((-1.0f32)))), next_v0.x);
    next_v0.y = sel(not(c1), add(cell_a1.y, sel(gt(grid_a0.step.y, splat(0.0f32)), splat(1.0f32), splat((-1.0f32)))), next_v0.y);
    let e_27 = next_v0;
    return e_27;
} }
lanes! { fn cell_slopes(r: &Resources<'_>, h_a0: Vec4<F>, part_a1: Vec2<F>) -> Vec2<F> {
    let top_4 = sub(h_a0.y, h_a0.x);
    let left_7 = sub(h_a0.z, h_a0.x);
    let twist_11 = sub(sub(h_a0.w, h_a0.z), top_4);
    return Vec2 { x: add(top_4, mul(twist_11, part_a1.y)), y: add(left_7, mul(twist_11, part_a1.x)) };
} }
lanes! { fn chord_end(r: &Resources<'_>, at_a0: &Entered, k_a1: u32) -> F {
    return add(at_a0.span.x, mul(min_with(sub(at_a0.span.y, at_a0.span.x), splat(3e38f32)), div(splat((k_a1 as f32)), f_of_u(at_a0.segments))));
} }
lanes! { fn shell_slack(r: &Resources<'_>, pixel_a0: &PixelIn, middle_a1: F) -> F {
    let origin_3 = Vec3 { x: abs(pixel_a0.origin.x), y: abs(pixel_a0.origin.y), z: abs(pixel_a0.origin.z) };
    return mul(splat(9.536743e-7f32), add(max(max(origin_3.x, origin_3.y), origin_3.z), abs(middle_a1)));
} }
lanes! { fn where_positive(r: &Resources<'_>, within: M, interval_a0: Vec2<F>, weight_a1: F, change_a2: F, slack_a3: F) -> Vec2<F> {
    let mut ex = within;
    let mut ret: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    let c1 = eq(change_a2, splat(0.0f32));
    ret = Vec2 { x: sel(ge(weight_a1, sub(splat(0.0f32), slack_a3)), interval_a0.x, splat(3e38f32)), y: interval_a0.y };
    ex = and_not(ex, c1);
    let t_17 = div(sub(sub(splat(0.0f32), slack_a3), weight_a1), change_a2);
    let c2 = gt(change_a2, splat(0.0f32));
    let y3 = Vec2 { x: max(interval_a0.x, t_17), y: interval_a0.y };
    ret = Vec2 { x: sel(and(ex, c2), y3.x, ret.x), y: sel(and(ex, c2), y3.y, ret.y) };
    ex = and_not(ex, c2);
    let y4 = Vec2 { x: interval_a0.x, y: min(interval_a0.y, t_17) };
    return Vec2 { x: sel(ex, y4.x, ret.x), y: sel(ex, y4.y, ret.y) };
} }
lanes! { fn path_from(r: &Resources<'_>, path_a0: &Path, t_a1: F) -> Path {
    let mut rest_v0: Path = zero_path();
    rest_v0 = *path_a0;
    let e_4 = path_uv(r, path_a0, t_a1);
    rest_v0.uv = e_4;
    rest_v0.h = Vec3 { x: add(path_a0.h.x, mul(t_a1, add(path_a0.h.y, mul(t_a1, path_a0.h.z)))), y: add(path_a0.h.y, mul(mul(splat(2.0f32), t_a1), path_a0.h.z)), z: path_a0.h.z };
    rest_v0.exit = sub(path_a0.exit, t_a1);
    rest_v0.start = add(path_a0.start, t_a1);
    let e_33 = rest_v0;
    return e_33;
} }
lanes! { fn field_heights_is_ground(r: &Resources<'_>, level_a0: U, params_a1: Vec4<f32>) -> M {
    return splat_m(true);
} }
lanes! { fn field_volume_is_ground(r: &Resources<'_>, level_a0: U, params_a1: Vec4<f32>) -> M {
    return splat_m(false);
} }
lanes! { fn field_motif_is_ground(r: &Resources<'_>, level_a0: U, params_a1: Vec4<f32>) -> M {
    return splat_m(false);
} }
lanes! { fn field_is_ground_stage(r: &Resources<'_>, level_a0: U) -> M {
    match r.surface_settings.choices[4].number {
        0u32 => {
            let e_11 = field_heights_is_ground(r, level_a0, r.surface_settings.choices[4].params);
            return e_11;
        }
        1u32 => {
            let e_17 = field_volume_is_ground(r, level_a0, r.surface_settings.choices[4].params);
            return e_17;
        }
        _ => {
            let e_23 = field_motif_is_ground(r, level_a0, r.surface_settings.choices[4].params);
            return e_23;
        }
    }
} }
lanes! { fn object_none_parts(r: &Resources<'_>, level_a0: U, params_a1: Vec4<f32>) -> I {
    return splat_i(1i32);
} }
lanes! { fn object_depth_parts(r: &Resources<'_>, level_a0: U, params_a1: Vec4<f32>) -> I {
    let e_2 = r.parts_of_images();
    return splat_i(e_2);
} }
lanes! { fn object_hull_parts(r: &Resources<'_>, level_a0: U, params_a1: Vec4<f32>) -> I {
    return splat_i(1i32);
} }
lanes! { fn object_blend_parts(r: &Resources<'_>, level_a0: U, params_a1: Vec4<f32>) -> I {
    return splat_i(1i32);
} }
lanes! { fn object_parts_stage(r: &Resources<'_>, level_a0: U) -> I {
    match r.surface_settings.choices[3].number {
        0u32 => {
            let e_11 = object_none_parts(r, level_a0, r.surface_settings.choices[3].params);
            return e_11;
        }
        1u32 => {
            let e_17 = object_depth_parts(r, level_a0, r.surface_settings.choices[3].params);
            return e_17;
        }
        2u32 => {
            let e_23 = object_hull_parts(r, level_a0, r.surface_settings.choices[3].params);
            return e_23;
        }
        _ => {
            let e_29 = object_blend_parts(r, level_a0, r.surface_settings.choices[3].params);
            return e_29;
        }
    }
} }
lanes! { fn grid_of(r: &Resources<'_>, path_a0: &Path) -> Grid {
    let size_2 = height_size(r, path_a0.level);
    let e_4 = object_parts_stage(r, path_a0.level);
    let parts_5 = f_of_i(e_4);
    return Grid { origin: Vec2 { x: mul(sub(mul(path_a0.uv.x, size_2.x), splat(0.5f32)), parts_5), y: mul(sub(mul(path_a0.uv.y, size_2.y), splat(0.5f32)), parts_5) }, step: Vec2 { x: mul(mul(path_a0.duv.x, size_2.x), parts_5), y: mul(mul(path_a0.duv.y, size_2.y), parts_5) }, };
} }
lanes! { fn rounded_gap(r: &Resources<'_>, within: M, path_a0: &Path, slack_a1: F, texels_a2: f32) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let size_4 = height_size(r, path_a0.level);
    let e_11 = cell_of(r, Vec2 { x: sub(mul(path_a0.uv.x, size_4.x), splat(0.5f32)), y: sub(mul(path_a0.uv.y, size_4.y), splat(0.5f32)) });
    let h_14 = height_cell_ll(r, ex, Vec2 { x: i_of_small(e_11.x), y: i_of_small(e_11.y) }, path_a0.level);
    let range_29 = sub(max(max(h_14.x, h_14.y), max(h_14.z, h_14.w)), min(min(h_14.x, h_14.y), min(h_14.z, h_14.w)));
    let change_32 = Vec2 { x: mul(abs(path_a0.duv.x), size_4.x), y: mul(abs(path_a0.duv.y), size_4.y) };
    let places_37 = Vec2 { x: mul(mul(abs(path_a0.uv.x), size_4.x), splat(9.536743e-7f32)), y: mul(mul(abs(path_a0.uv.y), size_4.y), splat(9.536743e-7f32)) };
    let aside_46 = add(add(add(mul(add(change_32.x, change_32.y), slack_a1), places_37.x), places_37.y), splat(texels_a2));
    return add(add(mul(abs(path_a0.h.y), slack_a1), mul(range_29, aside_46)), splat(9.536743e-7f32));
} }
stage! { fn out_of_ground(r: &Resources<'_>, within: M, path_a0: &Path, slack_a1: F, texels_a2: f32) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let mut alive = ex;
    let mut cell_v0: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    let mut t_v1: F = splat(0.0f32);
    let mut both_v2: M = splat_m(false);
    let mut both_v3: M = splat_m(false);
    let mut both_v4: M = splat_m(false);
    let e_4 = field_is_ground_stage(r, path_a0.level);
    let c1 = not(e_4);
    ret = splat(0.0f32);
    ex = and_not(ex, c1);
    if none(ex) { return ret; }
    let grid_7 = grid_of(r, path_a0);
    let least_8 = rounded_gap(r, ex, path_a0, slack_a1, texels_a2);
    let e_10 = cell_of(r, Vec2 { x: grid_7.origin.x, y: grid_7.origin.y });
    cell_v0 = e_10;
    let e_14 = cell_v0;
    let begin_16 = cell_gap_llls(r, ex, path_a0, &grid_7, e_14, 0.0f32);
    let is_near_20 = ge(begin_16.x, sub(splat(0.0f32), least_8));
    both_v2 = and(le(begin_16.x, splat(0.0f32)), gt(begin_16.y, splat(0.0f32)));
    let comes_out_30 = both_v2;
    both_v3 = and(is_near_20, not(comes_out_30));
    let e_35 = both_v3;
    let c2 = e_35;
    ret = sel(and(ex, c2), splat(0.0f32), ret);
    ex = and_not(ex, c2);
    if none(ex) { return ret; }
    let above_38 = rounded_gap(r, ex, path_a0, slack_a1, 0.0f32);
    let b4 = ex;
    'l3: loop {
        let e_39 = t_v1;
        let c5 = lt(e_39, path_a0.exit);
        ex = and(ex, c5);
        let e_42 = cell_v0;
        if none(ex) { break 'l3; }
        let leave_43 = cell_leave(r, &grid_7, e_42);
        let end_48 = min(min(leave_43.x, leave_43.y), path_a0.exit);
        let e_52 = cell_v0;
        let e_53 = t_v1;
        let e_54 = cell_gap_llll(r, ex, path_a0, &grid_7, e_52, e_53);
        let below_55 = Vec3 { x: sub(above_38, e_54.x), y: sub(splat(0.0f32), e_54.y), z: sub(splat(0.0f32), e_54.z) };
        let (b6, c7) = (ex, not(gt(below_55.x, splat(0.0f32))));
        ex = and(b6, c7);
        if any(ex) {
            let e_60 = t_v1;
            ret = sel(ex, e_60, ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b6, c7);
        let e_61 = t_v1;
        let span_64 = max_with(sub(end_48, e_61), splat(0.0f32));
        if none(ex) { break 'l3; }
        let s_65 = first_root(r, ex, below_55, span_64);
        let (b8, c9) = (ex, lt(s_65, splat(3e38f32)));
        ex = and(b8, c9);
        if any(ex) {
            let e_68 = t_v1;
            ret = sel(ex, add(e_68, s_65), ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b8, c9);
        if none(ex) { break 'l3; }
        let (b10, c11) = (ex, is_near_20);
        ex = and(b10, c11);
        if any(ex) {
            let e_72 = quadratic(r, below_55, span_64);
            both_v4 = sel_m(ex, gt(e_72, add(above_38, least_8)), both_v4);
        }
        ex = and_not(b10, c11);
        if any(ex) {
            both_v4 = sel_m(ex, splat_m(false), both_v4);
        }
        ex = b10;
        let e_76 = both_v4;
        let (b12, c13) = (ex, e_76);
        ex = and(b12, c13);
        if any(ex) {
            ret = sel(ex, splat(0.0f32), ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b12, c13);
        let e_78 = cell_v0;
        if none(ex) { break 'l3; }
        let e_79 = cell_next(r, ex, &grid_7, e_78, leave_43);
        cell_v0 = e_79;
        let e_80 = t_v1;
        t_v1 = max(e_80, end_48);
    }
    ex = and(b4, alive);
    return sel(ex, path_a0.exit, ret);
} }
lanes! { fn chord_path(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, middle_a2: F, params_a3: Vec4<f32>, a_a4: &ShellPoint, b_a5: &ShellPoint, bend_a6: F, ends_a7: Vec2<F>, beyond_a8: Vec3<F>) -> Path {
    let mut ex = within;
    let mut ret: Path = zero_path();
    let mut inside_v0: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    let mut path_v1: Path = zero_path();
    let long_14 = sub(ends_a7.y, ends_a7.x);
    let uv_16 = uv_of(r, pixel_a0, Vec3 { x: a_a4.weights.x, y: a_a4.weights.y, z: a_a4.weights.z });
    let e_18 = uv_of(r, pixel_a0, Vec3 { x: b_a5.weights.x, y: b_a5.weights.y, z: b_a5.weights.z });
    let duv_21 = Vec2 { x: div(sub(e_18.x, uv_16.x), long_14), y: div(sub(e_18.y, uv_16.y), long_14) };
    let slope_25 = sub(sub(b_a5.height, a_a4.height), bend_a6);
    let slack_26 = shell_slack(r, pixel_a0, middle_a2);
    let change_31 = Vec3 { x: div(sub(b_a5.weights.x, a_a4.weights.x), long_14), y: div(sub(b_a5.weights.y, a_a4.weights.y), long_14), z: div(sub(b_a5.weights.z, a_a4.weights.z), long_14) };
    inside_v0 = Vec2 { x: max_with(sub(sub(splat(0.0f32), middle_a2), ends_a7.x), splat(0.0f32)), y: long_14 };
    let e_39 = inside_v0;
    let e_44 = where_positive(r, ex, e_39, a_a4.weights.x, change_31.x, beyond_a8.x);
    inside_v0 = e_44;
    let e_45 = inside_v0;
    let e_50 = where_positive(r, ex, e_45, a_a4.weights.y, change_31.y, beyond_a8.y);
    inside_v0 = e_50;
    let e_51 = inside_v0;
    let e_56 = where_positive(r, ex, e_51, a_a4.weights.z, change_31.z, beyond_a8.z);
    inside_v0 = e_56;
    if (r.surface_settings.wrap == 1u32) {
        let e_64 = inside_v0;
        let e_65 = inside_unit(r, ex, uv_16.x, duv_21.x, e_64);
        inside_v0 = e_65;
        let e_68 = inside_v0;
        let e_69 = inside_unit(r, ex, uv_16.y, duv_21.y, e_68);
        inside_v0 = e_69;
    }
    let e_76 = inside_v0.y;
    path_v1 = Path { uv: uv_16, duv: duv_21, h: Vec3 { x: a_a4.height, y: div(slope_25, long_14), z: div(bend_a6, mul(long_14, long_14)) }, exit: e_76, base: splat(0.0f32), metric: Vec4 { x: at_a1.metric.x, y: at_a1.metric.y, z: at_a1.metric.z, w: at_a1.metric.w }, ray: splat_u(0u32), level: at_a1.level, start: add(middle_a2, ends_a7.x), share: div(splat(1.0f32), f_of_u(at_a1.segments)), bend: splat(0.0f32), };
    let e_90 = inside_v0.y;
    let e_92 = inside_v0.x;
    let (b1, c2) = (ex, not(gt(e_90, e_92)));
    ex = and(b1, c2);
    if any(ex) {
        path_v1.exit = sel(ex, splat(0.0f32), path_v1.exit);
        let e_97 = path_v1;
        ret = e_97;
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    let e_98 = path_v1;
    let e_100 = inside_v0.x;
    if none(ex) { return ret; }
    let e_101 = path_from(r, &e_98, e_100);
    path_v1 = e_101;
    let e_104 = path_v1.h.x;
    let above_106 = sub(e_104, splat(pixel_a0.shell.heights.y));
    let (b3, c4) = (ex, gt(above_106, splat(0.0f32)));
    ex = and(b3, c4);
    if any(ex) {
        let e_109 = path_v1;
        let e_112 = path_v1.h.y;
        let e_115 = path_v1.h.z;
        let e_118 = path_v1.exit;
        let e_119 = first_root(r, ex, Vec3 { x: above_106, y: e_112, z: e_115 }, e_118);
        let e_121 = path_v1.exit;
        let e_123 = path_from(r, &e_109, min(e_119, e_121));
        path_v1 = sel_path(ex, &e_123, &path_v1);
    }
    ex = b3;
    let e_125 = path_v1.exit;
    let (b5, c6) = (ex, gt(e_125, splat(0.0f32)));
    ex = and(b5, c6);
    if any(ex) {
        let e_128 = path_v1;
        let e_129 = path_v1;
        let e_133 = out_of_ground(r, ex, &e_129, mul(splat(4.0f32), slack_26), params_a3.x);
        let e_134 = path_from(r, &e_128, e_133);
        path_v1 = sel_path(ex, &e_134, &path_v1);
    }
    ex = b5;
    let e_135 = path_v1;
    return sel_path(ex, &e_135, &ret);
} }
lanes! { fn chord_reach(r: &Resources<'_>, pixel_a0: &PixelIn, at_a1: &Entered, middle_a2: F, params_a3: Vec4<f32>) -> F {
    let e_11 = height_size(r, splat_u(0u32));
    let e_14 = height_size(r, splat_u(0u32));
    let texel_17 = div(sqrt(max(at_a1.metric.x, at_a1.metric.z)), max(e_11.x, e_14.y));
    let e_18 = shell_slack(r, pixel_a0, middle_a2);
    return add(e_18, mul(splat((2.0f32 * params_a3.x)), texel_17));
} }
lanes! { fn color_texels_around(r: &Resources<'_>, within: M, place_a0: Vec2<F>, n_a1: Vec2<I>) -> Around {
    let mut ex = within;
    let mut ret: Around = zero_around();
    let point_7 = Vec2 { x: sub(mul(place_a0.x, f_of_i(n_a1.x)), splat(0.5f32)), y: sub(mul(place_a0.y, f_of_i(n_a1.y)), splat(0.5f32)) };
    let cell_8 = cell_of(r, point_7);
    let i_9 = Vec2 { x: i_of_small(cell_8.x), y: i_of_small(cell_8.y) };
    let e_18 = continued_pair(r, ex, i_9.x, n_a1.x, r.surface_settings.color_wrap_u);
    let e_21 = continued_pair(r, ex, i_9.y, n_a1.y, r.surface_settings.color_wrap_v);
    return Around { columns: e_18, rows: e_21, part: Vec2 { x: sub(point_7.x, cell_8.x), y: sub(point_7.y, cell_8.y) }, };
} }
lanes! { fn color_of_texels_ll(r: &Resources<'_>, within: M, place_a0: Vec2<F>, level_a1: U) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let e_5 = level_texels(r, r.surface_settings.color_size, level_a1);
    let at_6 = color_texels_around(r, ex, place_a0, e_5);
    let k_7 = i_of_u(level_a1);
    let e_14 = color_texel_of_each(&r.color_map, ex, at_6.columns.x, at_6.rows.x, splat_i(0i32), k_7);
    let e_21 = color_texel_of_each(&r.color_map, ex, at_6.columns.y, at_6.rows.x, splat_i(0i32), k_7);
    let e_28 = color_texel_of_each(&r.color_map, ex, at_6.columns.x, at_6.rows.y, splat_i(0i32), k_7);
    let e_35 = color_texel_of_each(&r.color_map, ex, at_6.columns.y, at_6.rows.y, splat_i(0i32), k_7);
    let e_37 = bilinear(r, e_14, e_21, e_28, e_35, Vec2 { x: at_6.part.x, y: at_6.part.y });
    return e_37;
} }
lanes! { fn color_of_texels_ls(r: &Resources<'_>, within: M, place_a0: Vec2<F>, level_a1: u32) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let e_5 = level_texels(r, r.surface_settings.color_size, splat_u(level_a1));
    let at_6 = color_texels_around(r, ex, place_a0, e_5);
    let k_7 = (level_a1 as i32);
    let e_14 = color_texel(&r.color_map, at_6.columns.x, at_6.rows.x, 0i32, k_7);
    let e_21 = color_texel(&r.color_map, at_6.columns.y, at_6.rows.x, 0i32, k_7);
    let e_28 = color_texel(&r.color_map, at_6.columns.x, at_6.rows.y, 0i32, k_7);
    let e_35 = color_texel(&r.color_map, at_6.columns.y, at_6.rows.y, 0i32, k_7);
    let e_37 = bilinear(r, e_14, e_21, e_28, e_35, Vec2 { x: at_6.part.x, y: at_6.part.y });
    return e_37;
} }
lanes! { fn color_place(r: &Resources<'_>, uv_a0: Vec2<F>) -> Vec2<F> {
    let u_13 = add(mul(splat(r.surface_settings.color_u.x), uv_a0.x), mul(splat(r.surface_settings.color_u.y), uv_a0.y));
    let v_26 = add(mul(splat(r.surface_settings.color_v.x), uv_a0.x), mul(splat(r.surface_settings.color_v.y), uv_a0.y));
    return Vec2 { x: add(u_13, splat(r.surface_settings.color_u.z)), y: add(v_26, splat(r.surface_settings.color_v.z)) };
} }
lanes! { fn color_at_ll(r: &Resources<'_>, within: M, uv_a0: Vec2<F>, level_a1: U) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let e_2 = color_place(r, uv_a0);
    let e_3 = color_of_texels_ll(r, ex, e_2, level_a1);
    return e_3;
} }
lanes! { fn color_at_ls(r: &Resources<'_>, within: M, uv_a0: Vec2<F>, level_a1: u32) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let e_2 = color_place(r, uv_a0);
    let e_3 = color_of_texels_ls(r, ex, e_2, level_a1);
    return e_3;
} }
lanes! { fn object_texel_l(r: &Resources<'_>, place_a0: Vec2<I>) -> Vec4<F> {
    let e_4 = map_texel(&r.object_map, place_a0.x, place_a0.y, 0i32, 0i32);
    return e_4;
} }
lanes! { fn object_texel_s(r: &Resources<'_>, place_a0: Vec2<i32>) -> Vec4<F> {
    let e_4 = map_texel(&r.object_map, splat_i(place_a0.x), splat_i(place_a0.y), 0i32, 0i32);
    return e_4;
} }
lanes! { fn frames_around(r: &Resources<'_>, within: M, toward_a0: Vec3<F>) -> Frames {
    let mut ex = within;
    let mut ret: Frames = zero_frames();
    let mut x_v0: F = splat(0f32);
    let mut z_v1: F = splat(0f32);
    let row_4 = (r.surface_settings.images as i32);
    let axis_x_7 = object_texel_s(r, Vec2 { x: 0i32, y: row_4 });
    let axis_y_10 = object_texel_s(r, Vec2 { x: 1i32, y: row_4 });
    let axis_z_13 = object_texel_s(r, Vec2 { x: 2i32, y: row_4 });
    let last_18 = max_with(sub(axis_x_7.w, splat(1.0f32)), splat(1.0f32));
    let is_hemi_21 = gt(axis_y_10.w, splat(0.0f32));
    let up_23 = add(add(add(mul(axis_y_10.x, toward_a0.x), mul(axis_y_10.y, toward_a0.y)), mul(axis_y_10.z, toward_a0.z)), splat(0.0f32));
    let y_26 = sel(is_hemi_21, max_with(up_23, splat(0.0f32)), up_23);
    let right_28 = add(add(add(mul(axis_x_7.x, toward_a0.x), mul(axis_x_7.y, toward_a0.y)), mul(axis_x_7.z, toward_a0.z)), splat(0.0f32));
    let front_30 = add(add(add(mul(axis_z_13.x, toward_a0.x), mul(axis_z_13.y, toward_a0.y)), mul(axis_z_13.z, toward_a0.z)), splat(0.0f32));
    let sum_37 = max_with(add(add(abs(right_28), abs(y_26)), abs(front_30)), splat(1e-6f32));
    x_v0 = div(right_28, sum_37);
    z_v1 = div(front_30, sum_37);
    let (b1, c2) = (ex, lt(y_26, splat(0.0f32)));
    ex = and(b1, c2);
    if any(ex) {
        let e_44 = z_v1;
        let e_48 = x_v0;
        let folded_x_54 = mul(sub(splat(1.0f32), abs(e_44)), sel(ge(e_48, splat(0.0f32)), splat(1.0f32), splat((-1.0f32))));
        let e_55 = x_v0;
        let e_59 = z_v1;
        let folded_z_65 = mul(sub(splat(1.0f32), abs(e_55)), sel(ge(e_59, splat(0.0f32)), splat(1.0f32), splat((-1.0f32))));
        x_v0 = sel(ex, folded_x_54, x_v0);
        z_v1 = sel(ex, folded_z_65, z_v1);
    }
    ex = b1;
    let e_66 = x_v0;
    let e_69 = x_v0;
    let e_70 = z_v1;
    let across_77 = mul(sel(is_hemi_21, add(add(e_69, e_70), splat(1.0f32)), add(e_66, splat(1.0f32))), mul(splat(0.5f32), last_18));
    let e_78 = z_v1;
    let e_81 = z_v1;
    let e_82 = x_v0;
    let along_89 = mul(sel(is_hemi_21, add(sub(e_81, e_82), splat(1.0f32)), add(e_78, splat(1.0f32))), mul(splat(0.5f32), last_18));
    let place_95 = Vec2 { x: min(max_with(across_77, splat(0.0f32)), last_18), y: min(max_with(along_89, splat(0.0f32)), last_18) };
    let cell_102 = Vec2 { x: min(floor(place_95.x), sub(last_18, splat(1.0f32))), y: min(floor(place_95.y), sub(last_18, splat(1.0f32))) };
    let part_103 = Vec2 { x: sub(place_95.x, cell_102.x), y: sub(place_95.y, cell_102.y) };
    let side_106 = add_u(u_of_f(last_18), splat_u(1u32));
    let first_112 = add_u(mul_u(u_of_f(cell_102.y), side_106), u_of_f(cell_102.x));
    let beside_119 = sel_u(gt(part_103.x, part_103.y), add_u(first_112, splat_u(1u32)), add_u(first_112, side_106));
    let least_122 = min(part_103.x, part_103.y);
    let most_125 = max(part_103.x, part_103.y);
    return Frames { numbers: Vec3 { x: first_112, y: beside_119, z: add_u(add_u(first_112, side_106), splat_u(1u32)) }, weights: Vec3 { x: sub(splat(1.0f32), most_125), y: sub(most_125, least_122), z: least_122 }, };
} }
lanes! { fn image_of_object_l(r: &Resources<'_>, within: M, number_a0: U) -> Image {
    let mut ex = within;
    let mut ret: Image = zero_image();
    let mut depth_v0: Vec4<F> = Vec4 { x: splat(0.0f32), y: splat(0.0f32), z: splat(0.0f32), w: splat(1.0f32) };
    let mut eye_v1: Vec4<F> = Vec4 { x: splat(0.0f32), y: splat(0.0f32), z: splat(0.0f32), w: splat(0.0f32) };
    let row_1 = i_of_u(number_a0);
    let place_4 = object_texel_l(r, Vec2 { x: splat_i(3i32), y: row_1 });
    let toward_7 = object_texel_l(r, Vec2 { x: splat_i(4i32), y: row_1 });
    let has_eye_10 = eq(toward_7.w, splat(1.0f32));
    let (b1, c2) = (ex, has_eye_10);
    ex = and(b1, c2);
    if any(ex) {
        let e_25 = object_texel_l(r, Vec2 { x: splat_i(5i32), y: row_1 });
        let (m3, y4) = (ex, e_25);
        depth_v0 = Vec4 { x: sel(m3, y4.x, depth_v0.x), y: sel(m3, y4.y, depth_v0.y), z: sel(m3, y4.z, depth_v0.z), w: sel(m3, y4.w, depth_v0.w) };
        let e_28 = object_texel_l(r, Vec2 { x: splat_i(6i32), y: row_1 });
        let (m5, y6) = (ex, e_28);
        eye_v1 = Vec4 { x: sel(m5, y6.x, eye_v1.x), y: sel(m5, y6.y, eye_v1.y), z: sel(m5, y6.z, eye_v1.z), w: sel(m5, y6.w, eye_v1.w) };
    }
    ex = b1;
    let e_31 = object_texel_l(r, Vec2 { x: splat_i(0i32), y: row_1 });
    let e_34 = object_texel_l(r, Vec2 { x: splat_i(1i32), y: row_1 });
    let e_37 = object_texel_l(r, Vec2 { x: splat_i(2i32), y: row_1 });
    let e_38 = depth_v0;
    let e_44 = eye_v1;
    let e_47 = eye_v1.w;
    return Image { u: e_31, v: e_34, height: e_37, depth: e_38, corner: Vec2 { x: place_4.x, y: place_4.y }, extent: Vec2 { x: place_4.z, y: place_4.w }, toward: Vec3 { x: toward_7.x, y: toward_7.y, z: toward_7.z }, has_eye: has_eye_10, eye: Vec3 { x: e_44.x, y: e_44.y, z: e_44.z }, nearest: e_47, };
} }
lanes! { fn image_of_object_s(r: &Resources<'_>, within: M, number_a0: u32) -> Image {
    let mut ex = within;
    let mut ret: Image = zero_image();
    let mut depth_v0: Vec4<F> = Vec4 { x: splat(0.0f32), y: splat(0.0f32), z: splat(0.0f32), w: splat(1.0f32) };
    let mut eye_v1: Vec4<F> = Vec4 { x: splat(0.0f32), y: splat(0.0f32), z: splat(0.0f32), w: splat(0.0f32) };
    let row_1 = (number_a0 as i32);
    let place_4 = object_texel_s(r, Vec2 { x: 3i32, y: row_1 });
    let toward_7 = object_texel_s(r, Vec2 { x: 4i32, y: row_1 });
    let has_eye_10 = eq(toward_7.w, splat(1.0f32));
    let (b1, c2) = (ex, has_eye_10);
    ex = and(b1, c2);
    if any(ex) {
        let e_25 = object_texel_s(r, Vec2 { x: 5i32, y: row_1 });
        let (m3, y4) = (ex, e_25);
        depth_v0 = Vec4 { x: sel(m3, y4.x, depth_v0.x), y: sel(m3, y4.y, depth_v0.y), z: sel(m3, y4.z, depth_v0.z), w: sel(m3, y4.w, depth_v0.w) };
        let e_28 = object_texel_s(r, Vec2 { x: 6i32, y: row_1 });
        let (m5, y6) = (ex, e_28);
        eye_v1 = Vec4 { x: sel(m5, y6.x, eye_v1.x), y: sel(m5, y6.y, eye_v1.y), z: sel(m5, y6.z, eye_v1.z), w: sel(m5, y6.w, eye_v1.w) };
    }
    ex = b1;
    let e_31 = object_texel_s(r, Vec2 { x: 0i32, y: row_1 });
    let e_34 = object_texel_s(r, Vec2 { x: 1i32, y: row_1 });
    let e_37 = object_texel_s(r, Vec2 { x: 2i32, y: row_1 });
    let e_38 = depth_v0;
    let e_44 = eye_v1;
    let e_47 = eye_v1.w;
    return Image { u: e_31, v: e_34, height: e_37, depth: e_38, corner: Vec2 { x: place_4.x, y: place_4.y }, extent: Vec2 { x: place_4.z, y: place_4.w }, toward: Vec3 { x: toward_7.x, y: toward_7.y, z: toward_7.z }, has_eye: has_eye_10, eye: Vec3 { x: e_44.x, y: e_44.y, z: e_44.z }, nearest: e_47, };
} }
lanes! { fn frame_number(r: &Resources<'_>, frames_a0: &Frames, k_a1: u32) -> U {
    return sel_u(splat_m((k_a1 == 0u32)), frames_a0.numbers.x, sel_u(splat_m((k_a1 == 1u32)), frames_a0.numbers.y, frames_a0.numbers.z));
} }
lanes! { fn frame_weight(r: &Resources<'_>, frames_a0: &Frames, k_a1: u32) -> F {
    return sel(splat_m((k_a1 == 0u32)), frames_a0.weights.x, sel(splat_m((k_a1 == 1u32)), frames_a0.weights.y, frames_a0.weights.z));
} }
stage! { fn color_of_frames(r: &Resources<'_>, within: M, at_a0: &Entered, view_a1: Vec3<F>) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let mut sum_v0: Vec3<F> = Vec3 { x: splat(0.0f32), y: splat(0.0f32), z: splat(0.0f32) };
    let mut k_v1: u32 = 0u32;
    let frames_2 = frames_around(r, ex, view_a1);
    'l1: loop {
        let e_10 = k_v1;
        if (e_10 < 3u32) {
        } else {
            break 'l1;
        }
        let e_13 = k_v1;
        let e_14 = frame_number(r, &frames_2, e_13);
        let image_15 = image_of_object_l(r, ex, e_14);
        let e_16 = sum_v0;
        let e_18 = place_in_image(r, &image_15, Vec3 { x: at_a0.point.x, y: at_a0.point.y, z: at_a0.point.z });
        let e_21 = color_at_ls(r, ex, Vec2 { x: e_18.x, y: e_18.y }, 0u32);
        let e_23 = k_v1;
        let e_24 = frame_weight(r, &frames_2, e_23);
        sum_v0 = Vec3 { x: add(e_16.x, mul(e_21.x, e_24)), y: add(e_16.y, mul(e_21.y, e_24)), z: add(e_16.z, mul(e_21.z, e_24)) };
        let e_27 = k_v1;
        k_v1 = e_27.wrapping_add(1u32);
    }
    let e_30 = sum_v0;
    return e_30;
} }
stage! { fn object_color(r: &Resources<'_>, within: M, at_a0: &Entered, view_a1: Vec3<F>, asked_a2: bool) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let mut angle1_v0: F = splat(4.0f32);
    let mut angle2_v1: F = splat(4.0f32);
    let mut angle3_v2: F = splat(4.0f32);
    let mut angle4_v3: F = splat(4.0f32);
    let mut image1_v4: U = splat_u(0u32);
    let mut image2_v5: U = splat_u(0u32);
    let mut image3_v6: U = splat_u(0u32);
    let mut k_v7: u32 = 0u32;
    let mut weight1_v8: F = splat(0f32);
    let mut weight2_v9: F = splat(0f32);
    let mut weight3_v10: F = splat(0f32);
    'l1: loop {
        let e_19 = k_v7;
        if (e_19 < r.surface_settings.images) {
        } else {
            break 'l1;
        }
        let e_24 = k_v7;
        let e_25 = image_of_object_s(r, ex, e_24);
        let angle_27 = angle_to_image(r, ex, &e_25, Vec3 { x: at_a0.point.x, y: at_a0.point.y, z: at_a0.point.z }, view_a1, asked_a2);
        let e_28 = angle1_v0;
        let (b2, c3) = (ex, lt(angle_27, e_28));
        ex = and(b2, c3);
        if any(ex) {
            let e_30 = angle3_v2;
            angle4_v3 = sel(ex, e_30, angle4_v3);
            let e_31 = angle2_v1;
            angle3_v2 = sel(ex, e_31, angle3_v2);
            let e_32 = image2_v5;
            image3_v6 = sel_u(ex, e_32, image3_v6);
            let e_33 = angle1_v0;
            angle2_v1 = sel(ex, e_33, angle2_v1);
            let e_34 = image1_v4;
            image2_v5 = sel_u(ex, e_34, image2_v5);
            angle1_v0 = sel(ex, angle_27, angle1_v0);
            let e_35 = k_v7;
            image1_v4 = sel_u(ex, splat_u(e_35), image1_v4);
        }
        ex = and_not(b2, c3);
        if any(ex) {
            let e_36 = angle2_v1;
            let (b4, c5) = (ex, lt(angle_27, e_36));
            ex = and(b4, c5);
            if any(ex) {
                let e_38 = angle3_v2;
                angle4_v3 = sel(ex, e_38, angle4_v3);
                let e_39 = angle2_v1;
                angle3_v2 = sel(ex, e_39, angle3_v2);
                let e_40 = image2_v5;
                image3_v6 = sel_u(ex, e_40, image3_v6);
                angle2_v1 = sel(ex, angle_27, angle2_v1);
                let e_41 = k_v7;
                image2_v5 = sel_u(ex, splat_u(e_41), image2_v5);
            }
            ex = and_not(b4, c5);
            if any(ex) {
                let e_42 = angle3_v2;
                let c6 = lt(angle_27, e_42);
                let e_44 = angle3_v2;
                angle4_v3 = sel(and(ex, c6), e_44, angle4_v3);
                angle3_v2 = sel(and(ex, c6), angle_27, angle3_v2);
                let e_45 = k_v7;
                image3_v6 = sel_u(and(ex, c6), splat_u(e_45), image3_v6);
                let e_46 = angle4_v3;
                let c7 = lt(angle_27, e_46);
                angle4_v3 = sel(and(ex, and(not(c6), c7)), angle_27, angle4_v3);
            }
            ex = b4;
        }
        ex = b2;
        let e_48 = k_v7;
        k_v7 = e_48.wrapping_add(1u32);
    }
    let e_51 = angle1_v0;
    let less_56 = sel(ge(e_51, splat(2.0f32)), splat(2.0f32), splat(0.0f32));
    let e_57 = angle4_v3;
    let last_60 = min_with(sub(e_57, less_56), splat(0.5f32));
    let e_61 = angle1_v0;
    weight1_v8 = max_with(sub(splat(1.0f32), div(sub(e_61, less_56), last_60)), splat(0.0f32));
    let e_69 = angle2_v1;
    weight2_v9 = max_with(sub(splat(1.0f32), div(sub(e_69, less_56), last_60)), splat(0.0f32));
    let e_77 = angle3_v2;
    weight3_v10 = max_with(sub(splat(1.0f32), div(sub(e_77, less_56), last_60)), splat(0.0f32));
    let e_85 = weight1_v8;
    let e_86 = weight2_v9;
    let e_88 = weight3_v10;
    let c8 = not(gt(add(add(e_85, e_86), e_88), splat(0.0f32)));
    weight1_v8 = sel(c8, splat(1.0f32), weight1_v8);
    let e_94 = angle2_v1;
    let e_95 = angle1_v0;
    weight2_v9 = sel(c8, sel(eq(e_94, e_95), splat(1.0f32), splat(0.0f32)), weight2_v9);
    let e_100 = angle3_v2;
    let e_101 = angle1_v0;
    weight3_v10 = sel(c8, sel(eq(e_100, e_101), splat(1.0f32), splat(0.0f32)), weight3_v10);
    let e_106 = image1_v4;
    let e_107 = image_of_object_l(r, ex, e_106);
    let e_109 = place_in_image(r, &e_107, Vec3 { x: at_a0.point.x, y: at_a0.point.y, z: at_a0.point.z });
    let e_111 = image2_v5;
    let e_112 = image_of_object_l(r, ex, e_111);
    let e_114 = place_in_image(r, &e_112, Vec3 { x: at_a0.point.x, y: at_a0.point.y, z: at_a0.point.z });
    let e_116 = image3_v6;
    let e_117 = image_of_object_l(r, ex, e_116);
    let e_119 = place_in_image(r, &e_117, Vec3 { x: at_a0.point.x, y: at_a0.point.y, z: at_a0.point.z });
    let e_122 = color_at_ls(r, ex, Vec2 { x: e_109.x, y: e_109.y }, 0u32);
    let e_124 = weight1_v8;
    let first_125 = Vec3 { x: mul(e_122.x, e_124), y: mul(e_122.y, e_124), z: mul(e_122.z, e_124) };
    let e_127 = color_at_ls(r, ex, Vec2 { x: e_114.x, y: e_114.y }, 0u32);
    let e_129 = weight2_v9;
    let e_133 = color_at_ls(r, ex, Vec2 { x: e_119.x, y: e_119.y }, 0u32);
    let e_135 = weight3_v10;
    let sum_137 = Vec3 { x: add(add(first_125.x, mul(e_127.x, e_129)), mul(e_133.x, e_135)), y: add(add(first_125.y, mul(e_127.y, e_129)), mul(e_133.y, e_135)), z: add(add(first_125.z, mul(e_127.z, e_129)), mul(e_133.z, e_135)) };
    let e_138 = weight1_v8;
    let e_139 = weight2_v9;
    let e_141 = weight3_v10;
    let e_144 = div(splat(1.0f32), add(add(e_138, e_139), e_141));
    return Vec3 { x: mul(sum_137.x, e_144), y: mul(sum_137.y, e_144), z: mul(sum_137.z, e_144) };
} }
lanes! { fn color_of_object(r: &Resources<'_>, within: M, at_a0: &Entered, view_a1: Vec3<F>, how_a2: f32) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let mut both_v0: bool = false;
    if !(r.surface_settings.has_color != 1u32) {
        both_v0 = (how_a2 == 2.0f32);
    } else {
        both_v0 = true;
    }
    let e_14 = both_v0;
    if e_14 {
        return Vec3 { x: splat(1.0f32), y: splat(1.0f32), z: splat(1.0f32) };
    }
    if (how_a2 == 3.0f32) {
        let e_21 = color_of_frames(r, ex, at_a0, view_a1);
        return e_21;
    }
    let e_24 = object_color(r, ex, at_a0, view_a1, (how_a2 == 1.0f32));
    return e_24;
} }
lanes! { fn color_or_white(r: &Resources<'_>, within: M, uv_a0: Vec2<F>, footprint_a1: F) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    if (r.surface_settings.has_color != 1u32) {
        return Vec3 { x: splat(1.0f32), y: splat(1.0f32), z: splat(1.0f32) };
    }
    let levels_18 = levels_of(r, ex, mul(footprint_a1, splat(r.surface_settings.color_texels)), r.surface_settings.color_levels);
    let e_20 = color_at_ll(r, ex, uv_a0, levels_18.fine);
    let (b1, c2) = (ex, gt(levels_18.part, splat(0.0f32)));
    ex = and(b1, c2);
    if any(ex) {
        let e_28 = color_at_ll(r, ex, uv_a0, add_u(levels_18.fine, splat_u(1u32)));
        ret = Vec3 { x: add(e_20.x, mul(sub(e_28.x, e_20.x), levels_18.part)), y: add(e_20.y, mul(sub(e_28.y, e_20.y), levels_18.part)), z: add(e_20.z, mul(sub(e_28.z, e_20.z), levels_18.part)) };
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    let y3 = Vec3 { x: e_20.x, y: e_20.y, z: e_20.z };
    return Vec3 { x: sel(ex, y3.x, ret.x), y: sel(ex, y3.y, ret.y), z: sel(ex, y3.z, ret.z) };
} }
lanes! { fn comes_before(r: &Resources<'_>, a_a0: Vec2<F>, b_a1: Vec2<F>) -> U {
    return sel_u(le(a_a0.x, b_a1.x), splat_u(1u32), splat_u(0u32));
} }
lanes! { fn covector(r: &Resources<'_>, at_a0: &Entered, gradient_a1: Vec3<F>) -> Vec3<F> {
    let area_9 = sub(mul(at_a0.metric.x, at_a0.metric.z), mul(at_a0.metric.y, at_a0.metric.y));
    let along_u_18 = Vec3 { x: div(sub(mul(at_a0.tangent.x, at_a0.metric.z), mul(at_a0.bitangent.x, at_a0.metric.y)), area_9), y: div(sub(mul(at_a0.tangent.y, at_a0.metric.z), mul(at_a0.bitangent.y, at_a0.metric.y)), area_9), z: div(sub(mul(at_a0.tangent.z, at_a0.metric.z), mul(at_a0.bitangent.z, at_a0.metric.y)), area_9) };
    let along_v_27 = Vec3 { x: div(sub(mul(at_a0.bitangent.x, at_a0.metric.x), mul(at_a0.tangent.x, at_a0.metric.y)), area_9), y: div(sub(mul(at_a0.bitangent.y, at_a0.metric.x), mul(at_a0.tangent.y, at_a0.metric.y)), area_9), z: div(sub(mul(at_a0.bitangent.z, at_a0.metric.x), mul(at_a0.tangent.z, at_a0.metric.y)), area_9) };
    let e_33 = div(gradient_a1.z, splat(r.surface_settings.scale_m));
    let rise_34 = Vec3 { x: mul(at_a0.normal.x, e_33), y: mul(at_a0.normal.y, e_33), z: mul(at_a0.normal.z, e_33) };
    return Vec3 { x: add(add(mul(along_u_18.x, gradient_a1.x), mul(along_v_27.x, gradient_a1.y)), rise_34.x), y: add(add(mul(along_u_18.y, gradient_a1.x), mul(along_v_27.y, gradient_a1.y)), rise_34.y), z: add(add(mul(along_u_18.z, gradient_a1.x), mul(along_v_27.z, gradient_a1.y)), rise_34.z) };
} }
lanes! { fn plane_distance(r: &Resources<'_>, pixel_a0: &PixelIn, normal_a1: Vec3<F>) -> F {
    return div(add(add(add(mul(normal_a1.x, sub(splat(pixel_a0.a.position.x), pixel_a0.origin.x)), mul(normal_a1.y, sub(splat(pixel_a0.a.position.y), pixel_a0.origin.y))), mul(normal_a1.z, sub(splat(pixel_a0.a.position.z), pixel_a0.origin.z))), splat(0.0f32)), add(add(add(mul(normal_a1.x, pixel_a0.direction.x), mul(normal_a1.y, pixel_a0.direction.y)), mul(normal_a1.z, pixel_a0.direction.z)), splat(0.0f32)));
} }
lanes! { fn depth_in_samples(r: &Resources<'_>, pixel_a0: &PixelIn, at_a1: &Entered) -> F {
    let t_3 = plane_distance(r, pixel_a0, Vec3 { x: at_a1.facing.x, y: at_a1.facing.y, z: at_a1.facing.z });
    let e_13 = Vec3 { x: add(splat(r.frame.eye_right.x), mul(splat(r.frame.right.x), t_3)), y: add(splat(r.frame.eye_right.y), mul(splat(r.frame.right.y), t_3)), z: add(splat(r.frame.eye_right.z), mul(splat(r.frame.right.z), t_3)) };
    let width_18 = mul(sqrt(add(add(mul(e_13.x, e_13.x), mul(e_13.y, e_13.y)), mul(e_13.z, e_13.z))), splat(r.frame.sample_width));
    return div(splat(r.surface_settings.scale_m), width_18);
} }
lanes! { fn depth_on_ray(r: &Resources<'_>, pixel_a0: &PixelIn, path_a1: &Path, hit_a2: &Hit) -> F {
    return div(add(path_a1.start, hit_a2.t), sqrt(add(add(mul(pixel_a0.direction.x, pixel_a0.direction.x), mul(pixel_a0.direction.y, pixel_a0.direction.y)), mul(pixel_a0.direction.z, pixel_a0.direction.z))));
} }
lanes! { fn faded_detail(r: &Resources<'_>, within: M, footprint_a0: F, depth_a1: F, params_a2: Vec4<f32>) -> Detail {
    let mut ex = within;
    let mut ret: Detail = zero_detail();
    let begin_5 = (params_a2.z * params_a2.w);
    let part_11 = div(sub(splat(begin_5), depth_a1), splat((begin_5 - params_a2.z).max(1e-6f32)));
    let e_17 = levels_of(r, ex, div(footprint_a0, splat(params_a2.y)), r.surface_settings.height_levels);
    return Detail { level: e_17.fine, footprint: footprint_a0, fade: min_with(max_with(part_11, splat(0.0f32)), splat(0.99902344f32)), };
} }
lanes! { fn footprint_axis(r: &Resources<'_>, pixel_a0: &PixelIn, at_a1: &Entered, normal_a2: Vec3<F>, t_a3: F, origin_a4: Vec3<f32>, direction_a5: Vec3<f32>) -> Vec2<F> {
    let aside_7 = Vec3 { x: add(splat(origin_a4.x), mul(splat(direction_a5.x), t_a3)), y: add(splat(origin_a4.y), mul(splat(direction_a5.y), t_a3)), z: add(splat(origin_a4.z), mul(splat(direction_a5.z), t_a3)) };
    let along_11 = div(add(add(add(mul(normal_a2.x, aside_7.x), mul(normal_a2.y, aside_7.y)), mul(normal_a2.z, aside_7.z)), splat(0.0f32)), add(add(add(mul(normal_a2.x, pixel_a0.direction.x), mul(normal_a2.y, pixel_a0.direction.y)), mul(normal_a2.z, pixel_a0.direction.z)), splat(0.0f32)));
    let e_15 = climb(r, at_a1, Vec3 { x: sub(aside_7.x, mul(pixel_a0.direction.x, along_11)), y: sub(aside_7.y, mul(pixel_a0.direction.y, along_11)), z: sub(aside_7.z, mul(pixel_a0.direction.z, along_11)) });
    return Vec2 { x: mul(e_15.x, splat((r.surface_settings.height_size.x as f32))), y: mul(e_15.y, splat((r.surface_settings.height_size.y as f32))) };
} }
lanes! { fn footprint_of(r: &Resources<'_>, pixel_a0: &PixelIn, at_a1: &Entered, anisotropy_a2: f32) -> F {
    let t_4 = plane_distance(r, pixel_a0, Vec3 { x: at_a1.facing.x, y: at_a1.facing.y, z: at_a1.facing.z });
    let right_13 = footprint_axis(r, pixel_a0, at_a1, Vec3 { x: at_a1.facing.x, y: at_a1.facing.y, z: at_a1.facing.z }, t_4, Vec3 { x: r.frame.eye_right.x, y: r.frame.eye_right.y, z: r.frame.eye_right.z }, Vec3 { x: r.frame.right.x, y: r.frame.right.y, z: r.frame.right.z });
    let down_22 = footprint_axis(r, pixel_a0, at_a1, Vec3 { x: at_a1.facing.x, y: at_a1.facing.y, z: at_a1.facing.z }, t_4, Vec3 { x: r.frame.eye_down.x, y: r.frame.eye_down.y, z: r.frame.eye_down.z }, Vec3 { x: r.frame.down.x, y: r.frame.down.y, z: r.frame.down.z });
    let both_23 = Vec4 { x: right_13.x, y: right_13.y, z: down_22.x, w: down_22.y };
    let sum_24 = add(add(add(add(mul(both_23.x, both_23.x), mul(both_23.y, both_23.y)), mul(both_23.z, both_23.z)), mul(both_23.w, both_23.w)), splat(0.0f32));
    let area_31 = sub(mul(right_13.x, down_22.y), mul(right_13.y, down_22.x));
    let apart_41 = sqrt(max_with(mul(sub(sum_24, mul(splat(2.0f32), area_31)), add(sum_24, mul(splat(2.0f32), area_31))), splat(0.0f32)));
    let longer_44 = mul(splat(0.5f32), add(sum_24, apart_41));
    let shorter_46 = div(mul(area_31, area_31), longer_44);
    let squared_49 = max(shorter_46, div(longer_44, splat((anisotropy_a2 * anisotropy_a2))));
    return mul(sqrt(squared_49), splat(r.frame.sample_width));
} }
lanes! { fn detail_fade(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, params_a2: Vec4<f32>) -> Detail {
    let mut ex = within;
    let mut ret: Detail = zero_detail();
    let e_4 = footprint_of(r, pixel_a0, at_a1, params_a2.x);
    let e_5 = depth_in_samples(r, pixel_a0, at_a1);
    let e_6 = faded_detail(r, ex, e_4, e_5, params_a2);
    return e_6;
} }
lanes! { fn detail_footprint_of_footprint(r: &Resources<'_>, within: M, at_a0: &Entered, footprint_a1: F, params_a2: Vec4<f32>) -> Detail {
    let mut ex = within;
    let mut ret: Detail = zero_detail();
    let e_8 = levels_of(r, ex, div(footprint_a1, splat(params_a2.y)), r.surface_settings.height_levels);
    return Detail { level: e_8.fine, footprint: footprint_a1, fade: splat(0.0f32), };
} }
lanes! { fn detail_footprint(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, params_a2: Vec4<f32>) -> Detail {
    let mut ex = within;
    let mut ret: Detail = zero_detail();
    let e_4 = footprint_of(r, pixel_a0, at_a1, params_a2.x);
    let e_5 = detail_footprint_of_footprint(r, ex, at_a1, e_4, params_a2);
    return e_5;
} }
lanes! { fn detail_none(r: &Resources<'_>, pixel_a0: &PixelIn, at_a1: &Entered, params_a2: Vec4<f32>) -> Detail {
    return Detail { level: splat_u(0u32), footprint: splat(0.0f32), fade: splat(0.0f32), };
} }
lanes! { fn detail_stage(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered) -> Detail {
    let mut ex = within;
    let mut ret: Detail = zero_detail();
    match r.surface_settings.choices[5].number {
        0u32 => {
            let e_12 = detail_none(r, pixel_a0, at_a1, r.surface_settings.choices[5].params);
            return e_12;
        }
        1u32 => {
            let e_18 = detail_footprint(r, ex, pixel_a0, at_a1, r.surface_settings.choices[5].params);
            return e_18;
        }
        _ => {
            let e_24 = detail_fade(r, ex, pixel_a0, at_a1, r.surface_settings.choices[5].params);
            return e_24;
        }
    }
} }
lanes! { fn detail_texel(r: &Resources<'_>, within: M, place_a0: Vec2<I>, layer_a1: I, level_a2: I) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let e_4 = map_texel_of_each(&r.detail_map, ex, place_a0.x, place_a0.y, layer_a1, level_a2);
    let e_9 = decoded(r, e_4, &r.surface_settings.maps[0]);
    return e_9;
} }
lanes! { fn detail_texel_between(r: &Resources<'_>, within: M, at_a0: &Around, layer_a1: I, level_a2: U) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let k_9 = i_of_u(sub_u(level_a2, splat_u(r.surface_settings.maps[0].first_level)));
    let e_15 = detail_texel(r, ex, Vec2 { x: at_a0.columns.x, y: at_a0.rows.x }, layer_a1, k_9);
    let e_21 = detail_texel(r, ex, Vec2 { x: at_a0.columns.y, y: at_a0.rows.x }, layer_a1, k_9);
    let e_27 = detail_texel(r, ex, Vec2 { x: at_a0.columns.x, y: at_a0.rows.y }, layer_a1, k_9);
    let e_33 = detail_texel(r, ex, Vec2 { x: at_a0.columns.y, y: at_a0.rows.y }, layer_a1, k_9);
    let e_35 = bilinear(r, e_15, e_21, e_27, e_33, Vec2 { x: at_a0.part.x, y: at_a0.part.y });
    return e_35;
} }
lanes! { fn material_of_texels(r: &Resources<'_>, within: M, place_a0: Vec2<F>, layer_a1: i32, level_a2: U) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let e_6 = level_texels(r, r.surface_settings.material_size, level_a2);
    let at_7 = color_texels_around(r, ex, place_a0, e_6);
    let k_8 = i_of_u(level_a2);
    let e_15 = color_texel_of_each(&r.material_map, ex, at_7.columns.x, at_7.rows.x, splat_i(layer_a1), k_8);
    let e_22 = color_texel_of_each(&r.material_map, ex, at_7.columns.y, at_7.rows.x, splat_i(layer_a1), k_8);
    let e_29 = color_texel_of_each(&r.material_map, ex, at_7.columns.x, at_7.rows.y, splat_i(layer_a1), k_8);
    let e_36 = color_texel_of_each(&r.material_map, ex, at_7.columns.y, at_7.rows.y, splat_i(layer_a1), k_8);
    let e_38 = bilinear(r, e_15, e_22, e_29, e_36, Vec2 { x: at_7.part.x, y: at_7.part.y });
    return e_38;
} }
lanes! { fn material_at(r: &Resources<'_>, within: M, uv_a0: Vec2<F>, layer_a1: i32, level_a2: U) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let e_3 = color_place(r, uv_a0);
    let e_4 = material_of_texels(r, ex, e_3, layer_a1, level_a2);
    return e_4;
} }
lanes! { fn material_layer(r: &Resources<'_>, within: M, uv_a0: Vec2<F>, footprint_a1: F, layer_a2: i32) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let levels_10 = levels_of(r, ex, mul(footprint_a1, splat(r.surface_settings.material_texels)), r.surface_settings.material_levels);
    let e_12 = material_at(r, ex, uv_a0, layer_a2, levels_10.fine);
    let (b1, c2) = (ex, gt(levels_10.part, splat(0.0f32)));
    ex = and(b1, c2);
    if any(ex) {
        let e_20 = material_at(r, ex, uv_a0, layer_a2, add_u(levels_10.fine, splat_u(1u32)));
        ret = Vec3 { x: add(e_12.x, mul(sub(e_20.x, e_12.x), levels_10.part)), y: add(e_12.y, mul(sub(e_20.y, e_12.y), levels_10.part)), z: add(e_12.z, mul(sub(e_20.z, e_12.z), levels_10.part)) };
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    let y3 = Vec3 { x: e_12.x, y: e_12.y, z: e_12.z };
    return Vec3 { x: sel(ex, y3.x, ret.x), y: sel(ex, y3.y, ret.y), z: sel(ex, y3.z, ret.z) };
} }
lanes! { fn emission_at(r: &Resources<'_>, within: M, uv_a0: Vec2<F>, footprint_a1: F) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    if ((r.surface_settings.has_material & 2u32) == 0u32) {
        return Vec3 { x: splat(r.surface_settings.emission.x), y: splat(r.surface_settings.emission.y), z: splat(r.surface_settings.emission.z) };
    }
    let e_18 = material_layer(r, ex, uv_a0, footprint_a1, 1i32);
    return Vec3 { x: mul(splat(r.surface_settings.emission.x), e_18.x), y: mul(splat(r.surface_settings.emission.y), e_18.y), z: mul(splat(r.surface_settings.emission.z), e_18.z) };
} }
lanes! { fn plane_normal(r: &Resources<'_>, pixel_a0: &PixelIn) -> Vec3<F> {
    let e_5 = Vec3 { x: (pixel_a0.b.position.x - pixel_a0.a.position.x), y: (pixel_a0.b.position.y - pixel_a0.a.position.y), z: (pixel_a0.b.position.z - pixel_a0.a.position.z) };
    let e_8 = Vec3 { x: (pixel_a0.c.position.x - pixel_a0.a.position.x), y: (pixel_a0.c.position.y - pixel_a0.a.position.y), z: (pixel_a0.c.position.z - pixel_a0.a.position.z) };
    return Vec3 { x: splat((e_5.y * e_8.z - e_5.z * e_8.y)), y: splat((e_5.z * e_8.x - e_5.x * e_8.z)), z: splat((e_5.x * e_8.y - e_5.y * e_8.x)) };
} }
lanes! { fn weights_of(r: &Resources<'_>, a_a0: Vec3<F>, b_a1: Vec3<F>, c_a2: Vec3<F>, normal_a3: Vec3<F>, point_a4: Vec3<F>) -> Vec3<F> {
    let nn_5 = add(add(add(mul(normal_a3.x, normal_a3.x), mul(normal_a3.y, normal_a3.y)), mul(normal_a3.z, normal_a3.z)), splat(0.0f32));
    let from_a_6 = Vec3 { x: sub(point_a4.x, a_a0.x), y: sub(point_a4.y, a_a0.y), z: sub(point_a4.z, a_a0.z) };
    let e_7 = Vec3 { x: sub(c_a2.x, a_a0.x), y: sub(c_a2.y, a_a0.y), z: sub(c_a2.z, a_a0.z) };
    let wb_10 = div(add(add(add(mul(sub(mul(from_a_6.y, e_7.z), mul(from_a_6.z, e_7.y)), normal_a3.x), mul(sub(mul(from_a_6.z, e_7.x), mul(from_a_6.x, e_7.z)), normal_a3.y)), mul(sub(mul(from_a_6.x, e_7.y), mul(from_a_6.y, e_7.x)), normal_a3.z)), splat(0.0f32)), nn_5);
    let e_11 = Vec3 { x: sub(b_a1.x, a_a0.x), y: sub(b_a1.y, a_a0.y), z: sub(b_a1.z, a_a0.z) };
    let wc_14 = div(add(add(add(mul(sub(mul(e_11.y, from_a_6.z), mul(e_11.z, from_a_6.y)), normal_a3.x), mul(sub(mul(e_11.z, from_a_6.x), mul(e_11.x, from_a_6.z)), normal_a3.y)), mul(sub(mul(e_11.x, from_a_6.y), mul(e_11.y, from_a_6.x)), normal_a3.z)), splat(0.0f32)), nn_5);
    return Vec3 { x: sub(sub(splat(1.0f32), wb_10), wc_14), y: wb_10, z: wc_14 };
} }
lanes! { fn plane_weights(r: &Resources<'_>, pixel_a0: &PixelIn, normal_a1: Vec3<F>, point_a2: Vec3<F>) -> Vec3<F> {
    let e_9 = weights_of(r, Vec3 { x: splat(pixel_a0.a.position.x), y: splat(pixel_a0.a.position.y), z: splat(pixel_a0.a.position.z) }, Vec3 { x: splat(pixel_a0.b.position.x), y: splat(pixel_a0.b.position.y), z: splat(pixel_a0.b.position.z) }, Vec3 { x: splat(pixel_a0.c.position.x), y: splat(pixel_a0.c.position.y), z: splat(pixel_a0.c.position.z) }, normal_a1, point_a2);
    return e_9;
} }
lanes! { fn surface_plane_enter(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, params_a1: Vec4<f32>) -> Entered {
    let mut ex = within;
    let mut ret: Entered = zero_entered();
    let mut both_v0: M = splat_m(false);
    let mut both_v1: M = splat_m(false);
    let n_2 = plane_normal(r, pixel_a0);
    let e_5 = plane_distance(r, pixel_a0, n_2);
    let point_7 = Vec3 { x: add(pixel_a0.origin.x, mul(pixel_a0.direction.x, e_5)), y: add(pixel_a0.origin.y, mul(pixel_a0.direction.y, e_5)), z: add(pixel_a0.origin.z, mul(pixel_a0.direction.z, e_5)) };
    let w_8 = plane_weights(r, pixel_a0, n_2, point_7);
    let uv_22 = Vec2 { x: add(add(mul(splat(pixel_a0.a.uv.x), w_8.x), mul(splat(pixel_a0.b.uv.x), w_8.y)), mul(splat(pixel_a0.c.uv.x), w_8.z)), y: add(add(mul(splat(pixel_a0.a.uv.y), w_8.x), mul(splat(pixel_a0.b.uv.y), w_8.y)), mul(splat(pixel_a0.c.uv.y), w_8.z)) };
    let tangent_33 = Vec3 { x: add(add(mul(splat(pixel_a0.a.tangent.x), w_8.x), mul(splat(pixel_a0.b.tangent.x), w_8.y)), mul(splat(pixel_a0.c.tangent.x), w_8.z)), y: add(add(mul(splat(pixel_a0.a.tangent.y), w_8.x), mul(splat(pixel_a0.b.tangent.y), w_8.y)), mul(splat(pixel_a0.c.tangent.y), w_8.z)), z: add(add(mul(splat(pixel_a0.a.tangent.z), w_8.x), mul(splat(pixel_a0.b.tangent.z), w_8.y)), mul(splat(pixel_a0.c.tangent.z), w_8.z)) };
    let bitangent_44 = Vec3 { x: add(add(mul(splat(pixel_a0.a.bitangent.x), w_8.x), mul(splat(pixel_a0.b.bitangent.x), w_8.y)), mul(splat(pixel_a0.c.bitangent.x), w_8.z)), y: add(add(mul(splat(pixel_a0.a.bitangent.y), w_8.x), mul(splat(pixel_a0.b.bitangent.y), w_8.y)), mul(splat(pixel_a0.c.bitangent.y), w_8.z)), z: add(add(mul(splat(pixel_a0.a.bitangent.z), w_8.x), mul(splat(pixel_a0.b.bitangent.z), w_8.y)), mul(splat(pixel_a0.c.bitangent.z), w_8.z)) };
    let e_55 = Vec3 { x: add(add(mul(splat(pixel_a0.a.normal.x), w_8.x), mul(splat(pixel_a0.b.normal.x), w_8.y)), mul(splat(pixel_a0.c.normal.x), w_8.z)), y: add(add(mul(splat(pixel_a0.a.normal.y), w_8.x), mul(splat(pixel_a0.b.normal.y), w_8.y)), mul(splat(pixel_a0.c.normal.y), w_8.z)), z: add(add(mul(splat(pixel_a0.a.normal.z), w_8.x), mul(splat(pixel_a0.b.normal.z), w_8.y)), mul(splat(pixel_a0.c.normal.z), w_8.z)) };
    let length1 = sqrt(add(add(mul(e_55.x, e_55.x), mul(e_55.y, e_55.y)), mul(e_55.z, e_55.z)));
    let e_56 = Vec3 { x: div(e_55.x, length1), y: div(e_55.y, length1), z: div(e_55.z, length1) };
    let normal_58 = Vec3 { x: mul(e_56.x, splat(pixel_a0.side)), y: mul(e_56.y, splat(pixel_a0.side)), z: mul(e_56.z, splat(pixel_a0.side)) };
    let tt_59 = add(add(add(mul(tangent_33.x, tangent_33.x), mul(tangent_33.y, tangent_33.y)), mul(tangent_33.z, tangent_33.z)), splat(0.0f32));
    let tb_60 = add(add(add(mul(tangent_33.x, bitangent_44.x), mul(tangent_33.y, bitangent_44.y)), mul(tangent_33.z, bitangent_44.z)), splat(0.0f32));
    let bb_61 = add(add(add(mul(bitangent_44.x, bitangent_44.x), mul(bitangent_44.y, bitangent_44.y)), mul(bitangent_44.z, bitangent_44.z)), splat(0.0f32));
    let area_64 = sub(mul(tt_59, bb_61), mul(tb_60, tb_60));
    let metric_68 = Vec4 { x: tt_59, y: tb_60, z: bb_61, w: splat(r.surface_settings.scale_m) };
    let e_71 = sqrt(add(add(mul(pixel_a0.direction.x, pixel_a0.direction.x), mul(pixel_a0.direction.y, pixel_a0.direction.y)), mul(pixel_a0.direction.z, pixel_a0.direction.z)));
    let descent_76 = sub(splat(0.0f32), add(add(add(mul(normal_58.x, div(pixel_a0.direction.x, e_71)), mul(normal_58.y, div(pixel_a0.direction.y, e_71))), mul(normal_58.z, div(pixel_a0.direction.z, e_71))), splat(0.0f32)));
    both_v0 = or(gt(descent_76, splat(0.0f32)), splat_m((r.surface_settings.scale_m == 0.0f32)));
    let is_entered_88 = both_v0;
    both_v1 = and(gt(area_64, splat(0.0f32)), is_entered_88);
    let e_96 = both_v1;
    let segments_97 = sel_u(e_96, splat_u(1u32), splat_u(0u32));
    return Entered { segments: segments_97, point: point_7, uv: uv_22, tangent: tangent_33, bitangent: bitangent_44, normal: normal_58, metric: metric_68, level: splat_u(0u32), facing: n_2, span: Vec2 { x: splat(0.0f32), y: splat(0.0f32) }, of_surface: Vec4 { x: splat(0.0f32), y: splat(0.0f32), z: splat(0.0f32), w: splat(0.0f32) }, footprint: splat(0.0f32), fade: splat(0.0f32), depth: splat(0.0f32), };
} }
lanes! { fn middle_of(r: &Resources<'_>, pixel_a0: &PixelIn, along_a1: Vec3<F>) -> F {
    let centre_11 = Vec3 { x: (((pixel_a0.a.position.x + pixel_a0.b.position.x) + pixel_a0.c.position.x) * 0.33333334f32), y: (((pixel_a0.a.position.y + pixel_a0.b.position.y) + pixel_a0.c.position.y) * 0.33333334f32), z: (((pixel_a0.a.position.z + pixel_a0.b.position.z) + pixel_a0.c.position.z) * 0.33333334f32) };
    return add(add(add(mul(sub(splat(centre_11.x), pixel_a0.origin.x), along_a1.x), mul(sub(splat(centre_11.y), pixel_a0.origin.y), along_a1.y)), mul(sub(splat(centre_11.z), pixel_a0.origin.z), along_a1.z)), splat(0.0f32));
} }
lanes! { fn prism_of(r: &Resources<'_>, pixel_a0: &PixelIn, along_a1: Vec3<F>, middle_a2: F, params_a3: Vec4<f32>) -> Prism {
    let origin_6 = Vec3 { x: add(pixel_a0.origin.x, mul(along_a1.x, middle_a2)), y: add(pixel_a0.origin.y, mul(along_a1.y, middle_a2)), z: add(pixel_a0.origin.z, mul(along_a1.z, middle_a2)) };
    let a_8 = ordered(r, pixel_a0, 0u32);
    let b_10 = ordered(r, pixel_a0, 1u32);
    let c_12 = ordered(r, pixel_a0, 2u32);
    let e_32 = (params_a3.y * pixel_a0.side);
    return Prism { p0: Vec3 { x: sub(a_8.position.x, origin_6.x), y: sub(a_8.position.y, origin_6.y), z: sub(a_8.position.z, origin_6.z) }, p1: Vec3 { x: sub(b_10.position.x, origin_6.x), y: sub(b_10.position.y, origin_6.y), z: sub(b_10.position.z, origin_6.z) }, p2: Vec3 { x: sub(c_12.position.x, origin_6.x), y: sub(c_12.position.y, origin_6.y), z: sub(c_12.position.z, origin_6.z) }, n0: Vec3 { x: mul(a_8.normal.x, splat(pixel_a0.side)), y: mul(a_8.normal.y, splat(pixel_a0.side)), z: mul(a_8.normal.z, splat(pixel_a0.side)) }, n1: Vec3 { x: mul(b_10.normal.x, splat(pixel_a0.side)), y: mul(b_10.normal.y, splat(pixel_a0.side)), z: mul(b_10.normal.z, splat(pixel_a0.side)) }, n2: Vec3 { x: mul(c_12.normal.x, splat(pixel_a0.side)), y: mul(c_12.normal.y, splat(pixel_a0.side)), z: mul(c_12.normal.z, splat(pixel_a0.side)) }, lift: Vec3 { x: splat((pixel_a0.shell.lift.x * e_32)), y: splat((pixel_a0.shell.lift.y * e_32)), z: splat((pixel_a0.shell.lift.z * e_32)) }, };
} }
lanes! { fn frame_at(r: &Resources<'_>, pixel_a0: &PixelIn, weights_a1: Vec3<F>, point_a2: Vec3<F>, uv_a3: Vec2<F>, facing_a4: Vec3<F>) -> Entered {
    let a_6 = ordered(r, pixel_a0, 0u32);
    let b_8 = ordered(r, pixel_a0, 1u32);
    let c_10 = ordered(r, pixel_a0, 2u32);
    let tangent_21 = Vec3 { x: add(add(mul(a_6.tangent.x, weights_a1.x), mul(b_8.tangent.x, weights_a1.y)), mul(c_10.tangent.x, weights_a1.z)), y: add(add(mul(a_6.tangent.y, weights_a1.x), mul(b_8.tangent.y, weights_a1.y)), mul(c_10.tangent.y, weights_a1.z)), z: add(add(mul(a_6.tangent.z, weights_a1.x), mul(b_8.tangent.z, weights_a1.y)), mul(c_10.tangent.z, weights_a1.z)) };
    let bitangent_32 = Vec3 { x: add(add(mul(a_6.bitangent.x, weights_a1.x), mul(b_8.bitangent.x, weights_a1.y)), mul(c_10.bitangent.x, weights_a1.z)), y: add(add(mul(a_6.bitangent.y, weights_a1.x), mul(b_8.bitangent.y, weights_a1.y)), mul(c_10.bitangent.y, weights_a1.z)), z: add(add(mul(a_6.bitangent.z, weights_a1.x), mul(b_8.bitangent.z, weights_a1.y)), mul(c_10.bitangent.z, weights_a1.z)) };
    let normal_43 = Vec3 { x: add(add(mul(a_6.normal.x, weights_a1.x), mul(b_8.normal.x, weights_a1.y)), mul(c_10.normal.x, weights_a1.z)), y: add(add(mul(a_6.normal.y, weights_a1.x), mul(b_8.normal.y, weights_a1.y)), mul(c_10.normal.y, weights_a1.z)), z: add(add(mul(a_6.normal.z, weights_a1.x), mul(b_8.normal.z, weights_a1.y)), mul(c_10.normal.z, weights_a1.z)) };
    let metric_50 = Vec4 { x: add(add(add(mul(tangent_21.x, tangent_21.x), mul(tangent_21.y, tangent_21.y)), mul(tangent_21.z, tangent_21.z)), splat(0.0f32)), y: add(add(add(mul(tangent_21.x, bitangent_32.x), mul(tangent_21.y, bitangent_32.y)), mul(tangent_21.z, bitangent_32.z)), splat(0.0f32)), z: add(add(add(mul(bitangent_32.x, bitangent_32.x), mul(bitangent_32.y, bitangent_32.y)), mul(bitangent_32.z, bitangent_32.z)), splat(0.0f32)), w: splat(r.surface_settings.scale_m) };
    let length1 = sqrt(add(add(mul(normal_43.x, normal_43.x), mul(normal_43.y, normal_43.y)), mul(normal_43.z, normal_43.z)));
    let e_51 = Vec3 { x: div(normal_43.x, length1), y: div(normal_43.y, length1), z: div(normal_43.z, length1) };
    let unit_53 = Vec3 { x: mul(e_51.x, splat(pixel_a0.side)), y: mul(e_51.y, splat(pixel_a0.side)), z: mul(e_51.z, splat(pixel_a0.side)) };
    return Entered { segments: splat_u(1u32), point: point_a2, uv: uv_a3, tangent: tangent_21, bitangent: bitangent_32, normal: unit_53, metric: metric_50, level: splat_u(0u32), facing: facing_a4, span: Vec2 { x: splat(0.0f32), y: splat(0.0f32) }, of_surface: Vec4 { x: splat(0.0f32), y: splat(0.0f32), z: splat(0.0f32), w: splat(0.0f32) }, footprint: splat(0.0f32), fade: splat(0.0f32), depth: splat(0.0f32), };
} }
lanes! { fn facing_of(r: &Resources<'_>, pixel_a0: &PixelIn, along_a1: Vec3<F>) -> Vec3<F> {
    let normal_2 = plane_normal(r, pixel_a0);
    let e_6 = div(splat(pixel_a0.side), sqrt(add(add(add(mul(normal_2.x, normal_2.x), mul(normal_2.y, normal_2.y)), mul(normal_2.z, normal_2.z)), splat(0.0f32))));
    let unit_7 = Vec3 { x: mul(normal_2.x, e_6), y: mul(normal_2.y, e_6), z: mul(normal_2.z, e_6) };
    let cosine_10 = sub(splat(0.0f32), add(add(add(mul(unit_7.x, along_a1.x), mul(unit_7.y, along_a1.y)), mul(unit_7.z, along_a1.z)), splat(0.0f32)));
    let e_14 = max_with(sub(splat(0.0625f32), cosine_10), splat(0.0f32));
    return Vec3 { x: sub(unit_7.x, mul(along_a1.x, e_14)), y: sub(unit_7.y, mul(along_a1.y, e_14)), z: sub(unit_7.z, mul(along_a1.z, e_14)) };
} }
lanes! { fn shell_middle(r: &Resources<'_>, pixel_a0: &PixelIn, along_a1: Vec3<F>) -> Entered {
    let mut at_v0: Entered = zero_entered();
    let third_5 = Vec3 { x: 0.33333334f32, y: 0.33333334f32, z: 0.33333334f32 };
    let uv_15 = Vec2 { x: (((pixel_a0.a.uv.x + pixel_a0.b.uv.x) + pixel_a0.c.uv.x) * 0.33333334f32), y: (((pixel_a0.a.uv.y + pixel_a0.b.uv.y) + pixel_a0.c.uv.y) * 0.33333334f32) };
    let e_17 = middle_of(r, pixel_a0, along_a1);
    let point_19 = Vec3 { x: add(pixel_a0.origin.x, mul(along_a1.x, e_17)), y: add(pixel_a0.origin.y, mul(along_a1.y, e_17)), z: add(pixel_a0.origin.z, mul(along_a1.z, e_17)) };
    let e_20 = facing_of(r, pixel_a0, along_a1);
    let e_21 = frame_at(r, pixel_a0, Vec3 { x: splat(third_5.x), y: splat(third_5.y), z: splat(third_5.z) }, point_19, Vec2 { x: splat(uv_15.x), y: splat(uv_15.y) }, e_20);
    at_v0 = e_21;
    at_v0.segments = splat_u(0u32);
    let e_25 = at_v0;
    return e_25;
} }
lanes! { fn offsets_of(r: &Resources<'_>, shell_a0: &Shell) -> Vec2<F> {
    let width_11 = (r.surface_settings.shell_m.y - r.surface_settings.shell_m.x).min(3e38f32);
    let quarter_15 = Vec3 { x: 0.25f32, y: 0.25f32, z: 0.25f32 };
    let zero_19 = Vec3 { x: 0.0f32, y: 0.0f32, z: 0.0f32 };
    let lowered_22 = add(add(add(mul(min_with(shell_a0.lift.x, splat(zero_19.x)), splat(quarter_15.x)), mul(min_with(shell_a0.lift.y, splat(zero_19.y)), splat(quarter_15.y))), mul(min_with(shell_a0.lift.z, splat(zero_19.z)), splat(quarter_15.z))), splat(0.0f32));
    let lifted_25 = add(add(add(mul(max_with(shell_a0.lift.x, splat(zero_19.x)), splat(quarter_15.x)), mul(max_with(shell_a0.lift.y, splat(zero_19.y)), splat(quarter_15.y))), mul(max_with(shell_a0.lift.z, splat(zero_19.z)), splat(quarter_15.z))), splat(0.0f32));
    return Vec2 { x: add(add(splat(r.surface_settings.shell_m.x), mul(splat(width_11), shell_a0.heights.x)), lowered_22), y: add(add(splat(r.surface_settings.shell_m.x), mul(splat(width_11), shell_a0.heights.y)), lifted_25) };
} }
stage! { fn folded_enter(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, params_a1: Vec4<f32>) -> Entered {
    if none(within) { return zero_entered(); }
    let pixel_a0 = singles_pixel_in(pixel_a0);
    let one = |lane: usize| r.folded_enter(pixel_a0[lane], params_a1);
    let mut rest = bits_of(within);
    let mut results = [one(rest.trailing_zeros() as usize); LANES];
    rest &= rest - 1;
    while rest != 0 {
        let lane = rest.trailing_zeros() as usize;
        results[lane] = one(lane);
        rest &= rest - 1;
    }
    lanes_of_entered(&results)
} }
lanes! { fn in_slab(r: &Resources<'_>, within: M, interval_a0: Vec2<F>, normal_a1: Vec3<F>, a_a2: Vec3<F>, b_a3: Vec3<F>, c_a4: Vec3<F>, d_a5: Vec3<F>, along_a6: Vec3<F>, slack_a7: F) -> Vec2<F> {
    let mut ex = within;
    let mut ret: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    let far_12 = Vec4 { x: add(add(add(mul(normal_a1.x, a_a2.x), mul(normal_a1.y, a_a2.y)), mul(normal_a1.z, a_a2.z)), splat(0.0f32)), y: add(add(add(mul(normal_a1.x, b_a3.x), mul(normal_a1.y, b_a3.y)), mul(normal_a1.z, b_a3.z)), splat(0.0f32)), z: add(add(add(mul(normal_a1.x, c_a4.x), mul(normal_a1.y, c_a4.y)), mul(normal_a1.z, c_a4.z)), splat(0.0f32)), w: add(add(add(mul(normal_a1.x, d_a5.x), mul(normal_a1.y, d_a5.y)), mul(normal_a1.z, d_a5.z)), splat(0.0f32)) };
    let least_19 = min(min(far_12.x, far_12.y), min(far_12.z, far_12.w));
    let most_26 = max(max(far_12.x, far_12.y), max(far_12.z, far_12.w));
    let beyond_28 = mul(slack_a7, sqrt(add(add(mul(normal_a1.x, normal_a1.x), mul(normal_a1.y, normal_a1.y)), mul(normal_a1.z, normal_a1.z))));
    let change_29 = add(add(add(mul(normal_a1.x, along_a6.x), mul(normal_a1.y, along_a6.y)), mul(normal_a1.z, along_a6.z)), splat(0.0f32));
    let inside_32 = where_positive(r, ex, interval_a0, sub(splat(0.0f32), least_19), change_29, beyond_28);
    let e_35 = where_positive(r, ex, inside_32, most_26, sub(splat(0.0f32), change_29), beyond_28);
    return e_35;
} }
lanes! { fn span_of(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, prism_a1: &Prism, along_a2: Vec3<F>, middle_a3: F, params_a4: Vec4<f32>) -> Vec2<F> {
    let mut ex = within;
    let mut ret: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    let mut shell_v0: Shell = zero_shell();
    let mut span_v1: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    shell_v0 = splat_shell(&pixel_a0.shell);
    let e_9 = shell_v0.lift;
    shell_v0.lift = Vec3 { x: mul(e_9.x, splat(params_a4.y)), y: mul(e_9.y, splat(params_a4.y)), z: mul(e_9.z, splat(params_a4.y)) };
    let e_12 = shell_v0;
    let offsets_13 = offsets_of(r, &e_12);
    let slack_14 = shell_slack(r, pixel_a0, middle_a3);
    let low0_19 = Vec3 { x: add(prism_a1.p0.x, mul(prism_a1.n0.x, offsets_13.x)), y: add(prism_a1.p0.y, mul(prism_a1.n0.y, offsets_13.x)), z: add(prism_a1.p0.z, mul(prism_a1.n0.z, offsets_13.x)) };
    let low1_24 = Vec3 { x: add(prism_a1.p1.x, mul(prism_a1.n1.x, offsets_13.x)), y: add(prism_a1.p1.y, mul(prism_a1.n1.y, offsets_13.x)), z: add(prism_a1.p1.z, mul(prism_a1.n1.z, offsets_13.x)) };
    let low2_29 = Vec3 { x: add(prism_a1.p2.x, mul(prism_a1.n2.x, offsets_13.x)), y: add(prism_a1.p2.y, mul(prism_a1.n2.y, offsets_13.x)), z: add(prism_a1.p2.z, mul(prism_a1.n2.z, offsets_13.x)) };
    let high0_34 = Vec3 { x: add(prism_a1.p0.x, mul(prism_a1.n0.x, offsets_13.y)), y: add(prism_a1.p0.y, mul(prism_a1.n0.y, offsets_13.y)), z: add(prism_a1.p0.z, mul(prism_a1.n0.z, offsets_13.y)) };
    let high1_39 = Vec3 { x: add(prism_a1.p1.x, mul(prism_a1.n1.x, offsets_13.y)), y: add(prism_a1.p1.y, mul(prism_a1.n1.y, offsets_13.y)), z: add(prism_a1.p1.z, mul(prism_a1.n1.z, offsets_13.y)) };
    let high2_44 = Vec3 { x: add(prism_a1.p2.x, mul(prism_a1.n2.x, offsets_13.y)), y: add(prism_a1.p2.y, mul(prism_a1.n2.y, offsets_13.y)), z: add(prism_a1.p2.z, mul(prism_a1.n2.z, offsets_13.y)) };
    span_v1 = Vec2 { x: sub(splat(0.0f32), middle_a3), y: splat(3e38f32) };
    let e_50 = span_v1;
    let e_51 = Vec3 { x: sub(low1_24.x, low0_19.x), y: sub(low1_24.y, low0_19.y), z: sub(low1_24.z, low0_19.z) };
    let e_52 = Vec3 { x: sub(low2_29.x, low0_19.x), y: sub(low2_29.y, low0_19.y), z: sub(low2_29.z, low0_19.z) };
    let e_54 = in_slab(r, ex, e_50, Vec3 { x: sub(mul(e_51.y, e_52.z), mul(e_51.z, e_52.y)), y: sub(mul(e_51.z, e_52.x), mul(e_51.x, e_52.z)), z: sub(mul(e_51.x, e_52.y), mul(e_51.y, e_52.x)) }, low0_19, high0_34, high1_39, high2_44, along_a2, slack_14);
    span_v1 = e_54;
    let e_55 = span_v1;
    let e_56 = Vec3 { x: sub(high1_39.x, high0_34.x), y: sub(high1_39.y, high0_34.y), z: sub(high1_39.z, high0_34.z) };
    let e_57 = Vec3 { x: sub(high2_44.x, high0_34.x), y: sub(high2_44.y, high0_34.y), z: sub(high2_44.z, high0_34.z) };
    let e_59 = in_slab(r, ex, e_55, Vec3 { x: sub(mul(e_56.y, e_57.z), mul(e_56.z, e_57.y)), y: sub(mul(e_56.z, e_57.x), mul(e_56.x, e_57.z)), z: sub(mul(e_56.x, e_57.y), mul(e_56.y, e_57.x)) }, high0_34, low0_19, low1_24, low2_29, along_a2, slack_14);
    span_v1 = e_59;
    let e_61 = span_v1.y;
    let e_63 = span_v1.x;
    let c1 = not(gt(e_61, e_63));
    let e_66 = span_v1;
    ret = e_66;
    ex = and_not(ex, c1);
    let e_67 = span_v1;
    if none(ex) { return ret; }
    let e_68 = Vec3 { x: sub(high1_39.x, low0_19.x), y: sub(high1_39.y, low0_19.y), z: sub(high1_39.z, low0_19.z) };
    let e_69 = Vec3 { x: sub(low1_24.x, high0_34.x), y: sub(low1_24.y, high0_34.y), z: sub(low1_24.z, high0_34.z) };
    let e_71 = in_slab(r, ex, e_67, Vec3 { x: sub(mul(e_68.y, e_69.z), mul(e_68.z, e_69.y)), y: sub(mul(e_68.z, e_69.x), mul(e_68.x, e_69.z)), z: sub(mul(e_68.x, e_69.y), mul(e_68.y, e_69.x)) }, low0_19, low1_24, low2_29, high2_44, along_a2, slack_14);
    span_v1 = e_71;
    let e_72 = span_v1;
    let e_73 = Vec3 { x: sub(high2_44.x, low1_24.x), y: sub(high2_44.y, low1_24.y), z: sub(high2_44.z, low1_24.z) };
    let e_74 = Vec3 { x: sub(low2_29.x, high1_39.x), y: sub(low2_29.y, high1_39.y), z: sub(low2_29.z, high1_39.z) };
    let e_76 = in_slab(r, ex, e_72, Vec3 { x: sub(mul(e_73.y, e_74.z), mul(e_73.z, e_74.y)), y: sub(mul(e_73.z, e_74.x), mul(e_73.x, e_74.z)), z: sub(mul(e_73.x, e_74.y), mul(e_73.y, e_74.x)) }, low1_24, low2_29, low0_19, high0_34, along_a2, slack_14);
    span_v1 = e_76;
    let e_78 = span_v1.y;
    let e_80 = span_v1.x;
    let c2 = not(gt(e_78, e_80));
    let e_83 = span_v1;
    let y3 = e_83;
    ret = Vec2 { x: sel(and(ex, c2), y3.x, ret.x), y: sel(and(ex, c2), y3.y, ret.y) };
    ex = and_not(ex, c2);
    let e_84 = span_v1;
    if none(ex) { return ret; }
    let e_85 = Vec3 { x: sub(high0_34.x, low2_29.x), y: sub(high0_34.y, low2_29.y), z: sub(high0_34.z, low2_29.z) };
    let e_86 = Vec3 { x: sub(low0_19.x, high2_44.x), y: sub(low0_19.y, high2_44.y), z: sub(low0_19.z, high2_44.z) };
    let e_88 = in_slab(r, ex, e_84, Vec3 { x: sub(mul(e_85.y, e_86.z), mul(e_85.z, e_86.y)), y: sub(mul(e_85.z, e_86.x), mul(e_85.x, e_86.z)), z: sub(mul(e_85.x, e_86.y), mul(e_85.y, e_86.x)) }, low2_29, low0_19, low1_24, high1_39, along_a2, slack_14);
    span_v1 = e_88;
    let e_89 = span_v1;
    let y4 = e_89;
    return Vec2 { x: sel(ex, y4.x, ret.x), y: sel(ex, y4.y, ret.y) };
} }
lanes! { fn passed_by(r: &Resources<'_>) -> Entered {
    let zero_3 = Vec3 { x: 0.0f32, y: 0.0f32, z: 0.0f32 };
    let zeros_8 = Vec4 { x: 0.0f32, y: 0.0f32, z: 0.0f32, w: 0.0f32 };
    let uv_11 = Vec2 { x: 0.0f32, y: 0.0f32 };
    return Entered { segments: splat_u(0u32), point: Vec3 { x: splat(zero_3.x), y: splat(zero_3.y), z: splat(zero_3.z) }, uv: Vec2 { x: splat(uv_11.x), y: splat(uv_11.y) }, tangent: Vec3 { x: splat(zero_3.x), y: splat(zero_3.y), z: splat(zero_3.z) }, bitangent: Vec3 { x: splat(zero_3.x), y: splat(zero_3.y), z: splat(zero_3.z) }, normal: Vec3 { x: splat(zero_3.x), y: splat(zero_3.y), z: splat(zero_3.z) }, metric: Vec4 { x: splat(zeros_8.x), y: splat(zeros_8.y), z: splat(zeros_8.z), w: splat(zeros_8.w) }, level: splat_u(0u32), facing: Vec3 { x: splat(zero_3.x), y: splat(zero_3.y), z: splat(zero_3.z) }, span: Vec2 { x: splat(uv_11.x), y: splat(uv_11.y) }, of_surface: Vec4 { x: splat(zeros_8.x), y: splat(zeros_8.y), z: splat(zeros_8.z), w: splat(zeros_8.w) }, footprint: splat(0.0f32), fade: splat(0.0f32), depth: splat(0.0f32), };
} }
stage! { fn shell_point_from(r: &Resources<'_>, within: M, prism_a0: &Prism, place_a1: Vec3<F>, from_point_a2: &ShellPoint) -> ShellPoint {
    let mut ex = within;
    let mut ret: ShellPoint = zero_shell_point();
    let mut w_v0: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let mut h_v1: F = splat(0f32);
    let mut step_v2: U = splat_u(0u32);
    let width_13 = (r.surface_settings.shell_m.y - r.surface_settings.shell_m.x).min(3e38f32);
    w_v0 = Vec3 { x: from_point_a2.weights.x, y: from_point_a2.weights.y, z: from_point_a2.weights.z };
    h_v1 = from_point_a2.height;
    let b2 = ex;
    'l1: loop {
        let e_21 = step_v2;
        let c3 = lt_u(e_21, splat_u(6u32));
        ex = and(ex, c3);
        let e_24 = step_v2;
        step_v2 = add_u(e_24, splat_u(1u32));
        let e_27 = h_v1;
        let e_30 = w_v0;
        if none(ex) { break 'l1; }
        let e_31 = lift_of(r, Vec3 { x: prism_a0.lift.x, y: prism_a0.lift.y, z: prism_a0.lift.z }, e_30);
        let offset_32 = add(add(splat(r.surface_settings.shell_m.x), mul(splat(width_13), e_27)), e_31);
        let e_35 = w_v0.x;
        let e_39 = w_v0.y;
        let e_44 = w_v0.z;
        let normal_46 = Vec3 { x: add(add(mul(prism_a0.n0.x, e_35), mul(prism_a0.n1.x, e_39)), mul(prism_a0.n2.x, e_44)), y: add(add(mul(prism_a0.n0.y, e_35), mul(prism_a0.n1.y, e_39)), mul(prism_a0.n2.y, e_44)), z: add(add(mul(prism_a0.n0.z, e_35), mul(prism_a0.n1.z, e_39)), mul(prism_a0.n2.z, e_44)) };
        let e_49 = w_v0.x;
        let e_53 = w_v0.y;
        let e_58 = w_v0.z;
        let base_60 = Vec3 { x: add(add(mul(prism_a0.p0.x, e_49), mul(prism_a0.p1.x, e_53)), mul(prism_a0.p2.x, e_58)), y: add(add(mul(prism_a0.p0.y, e_49), mul(prism_a0.p1.y, e_53)), mul(prism_a0.p2.y, e_58)), z: add(add(mul(prism_a0.p0.z, e_49), mul(prism_a0.p1.z, e_53)), mul(prism_a0.p2.z, e_58)) };
        let rest_63 = Vec3 { x: sub(sub(place_a1.x, base_60.x), mul(normal_46.x, offset_32)), y: sub(sub(place_a1.y, base_60.y), mul(normal_46.y, offset_32)), z: sub(sub(place_a1.z, base_60.z), mul(normal_46.z, offset_32)) };
        let e_66 = w_v0.x;
        let e_68 = w_v0.y;
        let e_72 = w_v0.z;
        let second_77 = add(mul(prism_a0.lift.z, sub(e_66, e_68)), mul(e_72, sub(prism_a0.lift.x, prism_a0.lift.y)));
        let e_80 = w_v0.x;
        let e_82 = w_v0.z;
        let e_86 = w_v0.y;
        let third_91 = add(mul(prism_a0.lift.y, sub(e_80, e_82)), mul(e_86, sub(prism_a0.lift.x, prism_a0.lift.z)));
        let a_101 = Vec3 { x: add(add(sub(prism_a0.p1.x, prism_a0.p0.x), mul(sub(prism_a0.n1.x, prism_a0.n0.x), offset_32)), mul(normal_46.x, second_77)), y: add(add(sub(prism_a0.p1.y, prism_a0.p0.y), mul(sub(prism_a0.n1.y, prism_a0.n0.y), offset_32)), mul(normal_46.y, second_77)), z: add(add(sub(prism_a0.p1.z, prism_a0.p0.z), mul(sub(prism_a0.n1.z, prism_a0.n0.z), offset_32)), mul(normal_46.z, second_77)) };
        let b_111 = Vec3 { x: add(add(sub(prism_a0.p2.x, prism_a0.p0.x), mul(sub(prism_a0.n2.x, prism_a0.n0.x), offset_32)), mul(normal_46.x, third_91)), y: add(add(sub(prism_a0.p2.y, prism_a0.p0.y), mul(sub(prism_a0.n2.y, prism_a0.n0.y), offset_32)), mul(normal_46.y, third_91)), z: add(add(sub(prism_a0.p2.z, prism_a0.p0.z), mul(sub(prism_a0.n2.z, prism_a0.n0.z), offset_32)), mul(normal_46.z, third_91)) };
        let c_112 = Vec3 { x: mul(normal_46.x, splat(width_13)), y: mul(normal_46.y, splat(width_13)), z: mul(normal_46.z, splat(width_13)) };
        let across_113 = Vec3 { x: sub(mul(b_111.y, c_112.z), mul(b_111.z, c_112.y)), y: sub(mul(b_111.z, c_112.x), mul(b_111.x, c_112.z)), z: sub(mul(b_111.x, c_112.y), mul(b_111.y, c_112.x)) };
        let one_over_116 = div(splat(1.0f32), add(add(add(mul(a_101.x, across_113.x), mul(a_101.y, across_113.y)), mul(a_101.z, across_113.z)), splat(0.0f32)));
        let db_118 = mul(add(add(add(mul(rest_63.x, across_113.x), mul(rest_63.y, across_113.y)), mul(rest_63.z, across_113.z)), splat(0.0f32)), one_over_116);
        let dc_121 = mul(add(add(add(mul(rest_63.x, sub(mul(c_112.y, a_101.z), mul(c_112.z, a_101.y))), mul(rest_63.y, sub(mul(c_112.z, a_101.x), mul(c_112.x, a_101.z)))), mul(rest_63.z, sub(mul(c_112.x, a_101.y), mul(c_112.y, a_101.x)))), splat(0.0f32)), one_over_116);
        let dh_124 = mul(add(add(add(mul(rest_63.x, sub(mul(a_101.y, b_111.z), mul(a_101.z, b_111.y))), mul(rest_63.y, sub(mul(a_101.z, b_111.x), mul(a_101.x, b_111.z)))), mul(rest_63.z, sub(mul(a_101.x, b_111.y), mul(a_101.y, b_111.x)))), splat(0.0f32)), one_over_116);
        let e_126 = w_v0.x;
        let e_130 = w_v0.y;
        let e_133 = w_v0.z;
        let (m4, y5) = (ex, Vec3 { x: sub(sub(e_126, db_118), dc_121), y: add(e_130, db_118), z: add(e_133, dc_121) });
        w_v0 = Vec3 { x: sel(m4, y5.x, w_v0.x), y: sel(m4, y5.y, w_v0.y), z: sel(m4, y5.z, w_v0.z) };
        let e_136 = h_v1;
        h_v1 = sel(ex, add(e_136, dh_124), h_v1);
        let c6 = lt(max(max(abs(db_118), abs(dc_121)), abs(dh_124)), splat(0.001f32));
        ex = and_not(ex, c6);
        if none(ex) { break 'l1; }
    }
    ex = b2;
    let e_145 = w_v0;
    let e_146 = h_v1;
    return ShellPoint { weights: e_145, height: e_146, };
} }
lanes! { fn shell_point(r: &Resources<'_>, within: M, prism_a0: &Prism, place_a1: Vec3<F>, height_a2: F) -> ShellPoint {
    let mut ex = within;
    let mut ret: ShellPoint = zero_shell_point();
    let e_8 = shell_point_from(r, ex, prism_a0, place_a1, &ShellPoint { weights: Vec3 { x: splat(0.28125f32), y: splat(0.375f32), z: splat(0.34375f32) }, height: height_a2, });
    return e_8;
} }
lanes! { fn surface_prism_enter(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, params_a1: Vec4<f32>) -> Entered {
    let mut ex = within;
    let mut ret: Entered = zero_entered();
    let mut both_v0: M = splat_m(false);
    let mut at_v1: Entered = zero_entered();
    if (pixel_a0.shell.order >= 64u32) {
        let e_6 = folded_enter(r, ex, pixel_a0, params_a1);
        return e_6;
    }
    let length1 = sqrt(add(add(mul(pixel_a0.direction.x, pixel_a0.direction.x), mul(pixel_a0.direction.y, pixel_a0.direction.y)), mul(pixel_a0.direction.z, pixel_a0.direction.z)));
    let along_8 = Vec3 { x: div(pixel_a0.direction.x, length1), y: div(pixel_a0.direction.y, length1), z: div(pixel_a0.direction.z, length1) };
    let middle_9 = middle_of(r, pixel_a0, along_8);
    let prism_10 = prism_of(r, pixel_a0, along_8, middle_9, params_a1);
    let span_11 = span_of(r, ex, pixel_a0, &prism_10, along_8, middle_9, params_a1);
    let long_16 = min_with(sub(span_11.y, span_11.x), splat(3e38f32));
    both_v0 = or(not(gt(long_16, splat(0.0f32))), not(lt(long_16, splat(3e38f32))));
    let e_27 = both_v0;
    let (b2, c3) = (ex, e_27);
    ex = and(b2, c3);
    if any(ex) {
        let e_28 = passed_by(r);
        ret = e_28;
        ex = no_lane();
    }
    ex = and_not(b2, c3);
    if none(ex) { return ret; }
    let e_29 = shell_middle(r, pixel_a0, along_8);
    at_v1 = e_29;
    at_v1.span = span_11;
    let height_40 = (0.5f32 * (pixel_a0.shell.heights.x + pixel_a0.shell.heights.y));
    let e_43 = at_v1.span.x;
    let a_45 = shell_point(r, ex, &prism_10, Vec3 { x: mul(along_8.x, e_43), y: mul(along_8.y, e_43), z: mul(along_8.z, e_43) }, splat(height_40));
    let e_48 = at_v1.span.y;
    let b_50 = shell_point(r, ex, &prism_10, Vec3 { x: mul(along_8.x, e_48), y: mul(along_8.y, e_48), z: mul(along_8.z, e_48) }, splat(height_40));
    let e_53 = at_v1.span.x;
    let e_58 = between(r, &a_45, &b_50);
    let e_56 = add(e_53, mul(splat(0.5f32), long_16));
    let m_59 = shell_point_from(r, ex, &prism_10, Vec3 { x: mul(along_8.x, e_56), y: mul(along_8.y, e_56), z: mul(along_8.z, e_56) }, &e_58);
    let e_62 = at_v1.span.x;
    let e_67 = between(r, &a_45, &m_59);
    let e_65 = add(e_62, mul(splat(0.25f32), long_16));
    let before_68 = shell_point_from(r, ex, &prism_10, Vec3 { x: mul(along_8.x, e_65), y: mul(along_8.y, e_65), z: mul(along_8.z, e_65) }, &e_67);
    let e_71 = at_v1.span.x;
    let e_76 = between(r, &m_59, &b_50);
    let e_74 = add(e_71, mul(splat(0.75f32), long_16));
    let after_77 = shell_point_from(r, ex, &prism_10, Vec3 { x: mul(along_8.x, e_74), y: mul(along_8.y, e_74), z: mul(along_8.z, e_74) }, &e_76);
    let e_79 = beside_chord(r, pixel_a0, &a_45, &m_59, &b_50, &before_68, 0.25f32);
    let e_81 = beside_chord(r, pixel_a0, &a_45, &m_59, &b_50, &after_77, 0.75f32);
    let quarters_82 = max(e_79, e_81);
    let e_84 = beside_chord(r, pixel_a0, &a_45, &m_59, &b_50, &m_59, 0.5f32);
    let most_85 = max(e_84, quarters_82);
    at_v1.segments = u_of_f(min_with(max_with(ceil(sqrt(div(most_85, splat(params_a1.x)))), splat(1.0f32)), splat(32.0f32)));
    let e_95 = at_v1;
    return sel_entered(ex, &e_95, &ret);
} }
lanes! { fn weight_at(r: &Resources<'_>, order_a0: u32, weights_a1: Vec3<F>) -> F {
    let corner_3 = (order_a0 & 3u32);
    return sel(splat_m((corner_3 == 0u32)), weights_a1.x, sel(splat_m((corner_3 == 1u32)), weights_a1.y, weights_a1.z));
} }
lanes! { fn ordered_weights(r: &Resources<'_>, shell_a0: &single::Shell, weights_a1: Vec3<F>) -> Vec3<F> {
    let e_3 = weight_at(r, shell_a0.order, weights_a1);
    let e_7 = weight_at(r, shell_a0.order.unbounded_shr(2u32), weights_a1);
    let e_11 = weight_at(r, shell_a0.order.unbounded_shr(4u32), weights_a1);
    return Vec3 { x: e_3, y: e_7, z: e_11 };
} }
lanes! { fn quadric_of(r: &Resources<'_>, pixel_a0: &PixelIn, point_a1: Vec3<F>, lift_a2: f32) -> Vec4<F> {
    let mut height_v0: f32 = 0f32;
    let e_3 = plane_normal(r, pixel_a0);
    let w_4 = plane_weights(r, pixel_a0, e_3, point_a1);
    let quadric_18 = Vec3 { x: add(add(mul(splat(pixel_a0.a.of_surface.x), w_4.x), mul(splat(pixel_a0.b.of_surface.x), w_4.y)), mul(splat(pixel_a0.c.of_surface.x), w_4.z)), y: add(add(mul(splat(pixel_a0.a.of_surface.y), w_4.x), mul(splat(pixel_a0.b.of_surface.y), w_4.y)), mul(splat(pixel_a0.c.of_surface.y), w_4.z)), z: add(add(mul(splat(pixel_a0.a.of_surface.z), w_4.x), mul(splat(pixel_a0.b.of_surface.z), w_4.y)), mul(splat(pixel_a0.c.of_surface.z), w_4.z)) };
    let e_19 = r.base_height();
    height_v0 = e_19;
    if ((r.surface_settings.bias_m + r.surface_settings.scale_m) > 0.0f32) {
        let e_30 = height_v0;
        height_v0 = (if (pixel_a0.side > 0.0f32) { 1.0f32 } else { ((2.0f32 * e_30) - 1.0f32) });
    }
    let e_43 = ordered_weights(r, &pixel_a0.shell, w_4);
    let e_44 = lift_of(r, Vec3 { x: splat(pixel_a0.shell.lift.x), y: splat(pixel_a0.shell.lift.y), z: splat(pixel_a0.shell.lift.z) }, e_43);
    let lifted_47 = mul(e_44, splat((lift_a2 * pixel_a0.side)));
    let e_50 = height_v0;
    let e_51 = r.traced_scale_m();
    return Vec4 { x: mul(quadric_18.x, splat(pixel_a0.side)), y: mul(quadric_18.y, splat(pixel_a0.side)), z: mul(quadric_18.z, splat(pixel_a0.side)), w: sub(splat(e_50), div(lifted_47, splat(e_51))) };
} }
lanes! { fn surface_quadric_vertical_enter(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, params_a1: Vec4<f32>) -> Entered {
    let mut ex = within;
    let mut ret: Entered = zero_entered();
    let mut at_v0: Entered = zero_entered();
    let e_2 = surface_plane_enter(r, ex, pixel_a0, params_a1);
    at_v0 = e_2;
    let e_6 = at_v0.point;
    let e_8 = quadric_of(r, pixel_a0, e_6, params_a1.y);
    at_v0.of_surface = e_8;
    let e_11 = at_v0.metric.x;
    let e_14 = at_v0.metric.z;
    let e_18 = at_v0.metric.y;
    let e_21 = at_v0.metric.y;
    let area_23 = sub(mul(e_11, e_14), mul(e_18, e_21));
    at_v0.segments = sel_u(gt(area_23, splat(0.0f32)), splat_u(1u32), splat_u(0u32));
    let e_30 = at_v0;
    return e_30;
} }
lanes! { fn surface_quadric_perpendicular_crossed(r: &Resources<'_>, within: M, at_a0: &Entered, direction_a1: Vec3<F>, eye_a2: F, params_a3: Vec4<f32>) -> Entered {
    let mut ex = within;
    let mut ret: Entered = zero_entered();
    let mut crossed_v0: Entered = zero_entered();
    crossed_v0 = *at_a0;
    let e_6 = across_of(r, at_a0, direction_a1);
    let e_7 = across_span(r, ex, at_a0, &e_6, eye_a2);
    crossed_v0.span = e_7;
    let e_16 = crossed_v0.span.y;
    let e_19 = crossed_v0.span.x;
    crossed_v0.segments = sel_u(gt(e_16, e_19), mul_u(at_a0.segments, splat_u((params_a3.z as u32))), splat_u(0u32));
    let e_22 = crossed_v0;
    return e_22;
} }
lanes! { fn surface_quadric_perpendicular_enter(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, params_a1: Vec4<f32>) -> Entered {
    let mut ex = within;
    let mut ret: Entered = zero_entered();
    let at_2 = surface_quadric_vertical_enter(r, ex, pixel_a0, params_a1);
    let along_4 = sqrt(add(add(mul(pixel_a0.direction.x, pixel_a0.direction.x), mul(pixel_a0.direction.y, pixel_a0.direction.y)), mul(pixel_a0.direction.z, pixel_a0.direction.z)));
    let e_5 = plane_normal(r, pixel_a0);
    let e_6 = plane_distance(r, pixel_a0, e_5);
    let eye_9 = sub(splat(0.0f32), mul(e_6, along_4));
    let e_13 = surface_quadric_perpendicular_crossed(r, ex, &at_2, Vec3 { x: div(pixel_a0.direction.x, along_4), y: div(pixel_a0.direction.y, along_4), z: div(pixel_a0.direction.z, along_4) }, eye_9, params_a1);
    return e_13;
} }
lanes! { fn moved_out(r: &Resources<'_>, corner_a0: &Corner, side_a1: f32, offset_a2: f32) -> Vec3<F> {
    let e_5 = (side_a1 * offset_a2);
    return Vec3 { x: add(corner_a0.position.x, mul(corner_a0.normal.x, splat(e_5))), y: add(corner_a0.position.y, mul(corner_a0.normal.y, splat(e_5))), z: add(corner_a0.position.z, mul(corner_a0.normal.z, splat(e_5))) };
} }
lanes! { fn raised(r: &Resources<'_>, corner_a0: &Corner, side_a1: f32, height_a2: f32) -> Vec3<F> {
    let e_14 = moved_out(r, corner_a0, side_a1, (r.surface_settings.shell_m.x + ((r.surface_settings.shell_m.y - r.surface_settings.shell_m.x).min(3e38f32) * height_a2)));
    return e_14;
} }
lanes! { fn tetrahedron(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, along_a1: Vec3<F>, middle_a2: F, number_a3: u32) -> Tetrahedron {
    let mut ex = within;
    let mut ret: Tetrahedron = zero_tetrahedron();
    let mut inside_v0: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    let mut both_v1: M = splat_m(false);
    let origin_6 = Vec3 { x: add(pixel_a0.origin.x, mul(along_a1.x, middle_a2)), y: add(pixel_a0.origin.y, mul(along_a1.y, middle_a2)), z: add(pixel_a0.origin.z, mul(along_a1.z, middle_a2)) };
    let is_first_8 = (number_a3 == 0u32);
    let is_last_10 = (number_a3 == 2u32);
    let e_12 = ordered(r, pixel_a0, 0u32);
    let e_15 = raised(r, &e_12, pixel_a0.side, 0.0f32);
    let q0_16 = Vec3 { x: sub(e_15.x, origin_6.x), y: sub(e_15.y, origin_6.y), z: sub(e_15.z, origin_6.z) };
    let e_20 = ordered(r, pixel_a0, (if is_last_10 { 0u32 } else { 1u32 }));
    let e_25 = raised(r, &e_20, pixel_a0.side, (if is_last_10 { 1.0f32 } else { 0.0f32 }));
    let q1_26 = Vec3 { x: sub(e_25.x, origin_6.x), y: sub(e_25.y, origin_6.y), z: sub(e_25.z, origin_6.z) };
    let third_30 = ordered(r, pixel_a0, (if is_first_8 { 2u32 } else { 1u32 }));
    let e_35 = raised(r, &third_30, pixel_a0.side, (if is_first_8 { 0.0f32 } else { 1.0f32 }));
    let q2_36 = Vec3 { x: sub(e_35.x, origin_6.x), y: sub(e_35.y, origin_6.y), z: sub(e_35.z, origin_6.z) };
    let e_38 = ordered(r, pixel_a0, 2u32);
    let e_41 = raised(r, &e_38, pixel_a0.side, 1.0f32);
    let q3_42 = Vec3 { x: sub(e_41.x, origin_6.x), y: sub(e_41.y, origin_6.y), z: sub(e_41.z, origin_6.z) };
    let e1_43 = Vec3 { x: sub(q1_26.x, q0_16.x), y: sub(q1_26.y, q0_16.y), z: sub(q1_26.z, q0_16.z) };
    let e2_44 = Vec3 { x: sub(q2_36.x, q0_16.x), y: sub(q2_36.y, q0_16.y), z: sub(q2_36.z, q0_16.z) };
    let e3_45 = Vec3 { x: sub(q3_42.x, q0_16.x), y: sub(q3_42.y, q0_16.y), z: sub(q3_42.z, q0_16.z) };
    let n1_46 = Vec3 { x: sub(mul(e2_44.y, e3_45.z), mul(e2_44.z, e3_45.y)), y: sub(mul(e2_44.z, e3_45.x), mul(e2_44.x, e3_45.z)), z: sub(mul(e2_44.x, e3_45.y), mul(e2_44.y, e3_45.x)) };
    let n2_47 = Vec3 { x: sub(mul(e3_45.y, e1_43.z), mul(e3_45.z, e1_43.y)), y: sub(mul(e3_45.z, e1_43.x), mul(e3_45.x, e1_43.z)), z: sub(mul(e3_45.x, e1_43.y), mul(e3_45.y, e1_43.x)) };
    let n3_48 = Vec3 { x: sub(mul(e1_43.y, e2_44.z), mul(e1_43.z, e2_44.y)), y: sub(mul(e1_43.z, e2_44.x), mul(e1_43.x, e2_44.z)), z: sub(mul(e1_43.x, e2_44.y), mul(e1_43.y, e2_44.x)) };
    let e_49 = Vec3 { x: sub(e2_44.x, e1_43.x), y: sub(e2_44.y, e1_43.y), z: sub(e2_44.z, e1_43.z) };
    let e_50 = Vec3 { x: sub(e3_45.x, e1_43.x), y: sub(e3_45.y, e1_43.y), z: sub(e3_45.z, e1_43.z) };
    let n0_51 = Vec3 { x: sub(mul(e_49.y, e_50.z), mul(e_49.z, e_50.y)), y: sub(mul(e_49.z, e_50.x), mul(e_49.x, e_50.z)), z: sub(mul(e_49.x, e_50.y), mul(e_49.y, e_50.x)) };
    let volume_52 = add(add(add(mul(e1_43.x, n1_46.x), mul(e1_43.y, n1_46.y)), mul(e1_43.z, n1_46.z)), splat(0.0f32));
    let w1_56 = div(sub(splat(0.0f32), add(add(add(mul(q0_16.x, n1_46.x), mul(q0_16.y, n1_46.y)), mul(q0_16.z, n1_46.z)), splat(0.0f32))), volume_52);
    let w2_60 = div(sub(splat(0.0f32), add(add(add(mul(q0_16.x, n2_47.x), mul(q0_16.y, n2_47.y)), mul(q0_16.z, n2_47.z)), splat(0.0f32))), volume_52);
    let w3_64 = div(sub(splat(0.0f32), add(add(add(mul(q0_16.x, n3_48.x), mul(q0_16.y, n3_48.y)), mul(q0_16.z, n3_48.z)), splat(0.0f32))), volume_52);
    let w0_66 = div(add(add(add(mul(q1_26.x, n0_51.x), mul(q1_26.y, n0_51.y)), mul(q1_26.z, n0_51.z)), splat(0.0f32)), volume_52);
    let g1_68 = div(add(add(add(mul(along_a1.x, n1_46.x), mul(along_a1.y, n1_46.y)), mul(along_a1.z, n1_46.z)), splat(0.0f32)), volume_52);
    let g2_70 = div(add(add(add(mul(along_a1.x, n2_47.x), mul(along_a1.y, n2_47.y)), mul(along_a1.z, n2_47.z)), splat(0.0f32)), volume_52);
    let g3_72 = div(add(add(add(mul(along_a1.x, n3_48.x), mul(along_a1.y, n3_48.y)), mul(along_a1.z, n3_48.z)), splat(0.0f32)), volume_52);
    let g0_76 = sub(splat(0.0f32), div(add(add(add(mul(along_a1.x, n0_51.x), mul(along_a1.y, n0_51.y)), mul(along_a1.z, n0_51.z)), splat(0.0f32)), volume_52));
    let e_77 = shell_slack(r, pixel_a0, middle_a2);
    let slack_79 = div(e_77, abs(volume_52));
    inside_v0 = Vec2 { x: sub(splat(0.0f32), middle_a2), y: splat(3e38f32) };
    let e_85 = inside_v0;
    let e_88 = where_positive(r, ex, e_85, w0_66, g0_76, mul(slack_79, sqrt(add(add(mul(n0_51.x, n0_51.x), mul(n0_51.y, n0_51.y)), mul(n0_51.z, n0_51.z)))));
    inside_v0 = e_88;
    let e_89 = inside_v0;
    let e_92 = where_positive(r, ex, e_89, w1_56, g1_68, mul(slack_79, sqrt(add(add(mul(n1_46.x, n1_46.x), mul(n1_46.y, n1_46.y)), mul(n1_46.z, n1_46.z)))));
    inside_v0 = e_92;
    let e_93 = inside_v0;
    let e_96 = where_positive(r, ex, e_93, w2_60, g2_70, mul(slack_79, sqrt(add(add(mul(n2_47.x, n2_47.x), mul(n2_47.y, n2_47.y)), mul(n2_47.z, n2_47.z)))));
    inside_v0 = e_96;
    let e_97 = inside_v0;
    let e_100 = where_positive(r, ex, e_97, w3_64, g3_72, mul(slack_79, sqrt(add(add(mul(n3_48.x, n3_48.x), mul(n3_48.y, n3_48.y)), mul(n3_48.z, n3_48.z)))));
    inside_v0 = e_100;
    let e_109 = inside_v0.y;
    both_v1 = or(not(gt(abs(volume_52), splat(0.0f32))), not(lt(e_109, splat(3e38f32))));
    let e_114 = both_v1;
    let c1 = e_114;
    let (m2, y3) = (c1, Vec2 { x: splat(3e38f32), y: splat((-3e38f32)) });
    inside_v0 = Vec2 { x: sel(m2, y3.x, inside_v0.x), y: sel(m2, y3.y, inside_v0.y) };
    if is_first_8 {
        let e_118 = inside_v0;
        return Tetrahedron { inside: e_118, weights: Vec4 { x: w0_66, y: w1_56, z: add(w2_60, w3_64), w: w3_64 }, change: Vec4 { x: g0_76, y: g1_68, z: add(g2_70, g3_72), w: g3_72 }, };
    }
    if is_last_10 {
        let upper_128 = Vec2 { x: add(add(w1_56, w2_60), w3_64), y: add(add(g1_68, g2_70), g3_72) };
        let e_129 = inside_v0;
        return Tetrahedron { inside: e_129, weights: Vec4 { x: add(w0_66, w1_56), y: w2_60, z: w3_64, w: upper_128.x }, change: Vec4 { x: add(g0_76, g1_68), y: g2_70, z: g3_72, w: upper_128.y }, };
    }
    let e_137 = inside_v0;
    return Tetrahedron { inside: e_137, weights: Vec4 { x: w0_66, y: add(w1_56, w2_60), z: w3_64, w: add(w2_60, w3_64) }, change: Vec4 { x: g0_76, y: add(g1_68, g2_70), z: g3_72, w: add(g2_70, g3_72) }, };
} }
lanes! { fn is_met(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, along_a1: Vec3<F>, middle_a2: F, number_a3: u32) -> M {
    let mut ex = within;
    let mut ret: M = splat_m(false);
    let e_4 = tetrahedron(r, ex, pixel_a0, along_a1, middle_a2, number_a3);
    return gt(e_4.inside.y, e_4.inside.x);
} }
lanes! { fn surface_tetrahedra_enter(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, params_a1: Vec4<f32>) -> Entered {
    let mut ex = within;
    let mut ret: Entered = zero_entered();
    let mut both_v0: M = splat_m(false);
    let mut both_v1: M = splat_m(false);
    let mut at_v2: Entered = zero_entered();
    let length1 = sqrt(add(add(mul(pixel_a0.direction.x, pixel_a0.direction.x), mul(pixel_a0.direction.y, pixel_a0.direction.y)), mul(pixel_a0.direction.z, pixel_a0.direction.z)));
    let along_3 = Vec3 { x: div(pixel_a0.direction.x, length1), y: div(pixel_a0.direction.y, length1), z: div(pixel_a0.direction.z, length1) };
    let middle_4 = middle_of(r, pixel_a0, along_3);
    let e_6 = is_met(r, ex, pixel_a0, along_3, middle_4, 0u32);
    let (b2, c3) = (ex, not(e_6));
    ex = and(b2, c3);
    if any(ex) {
        let e_11 = is_met(r, ex, pixel_a0, along_3, middle_4, 1u32);
        both_v0 = sel_m(ex, not(e_11), both_v0);
    }
    ex = and_not(b2, c3);
    if any(ex) {
        both_v0 = sel_m(ex, splat_m(false), both_v0);
    }
    ex = b2;
    let e_14 = both_v0;
    let (b4, c5) = (ex, e_14);
    ex = and(b4, c5);
    if any(ex) {
        let e_18 = is_met(r, ex, pixel_a0, along_3, middle_4, 2u32);
        both_v1 = sel_m(ex, not(e_18), both_v1);
    }
    ex = and_not(b4, c5);
    if any(ex) {
        both_v1 = sel_m(ex, splat_m(false), both_v1);
    }
    ex = b4;
    let is_passed_by_21 = both_v1;
    let (b6, c7) = (ex, is_passed_by_21);
    ex = and(b6, c7);
    if any(ex) {
        let e_22 = passed_by(r);
        ret = e_22;
        ex = no_lane();
    }
    ex = and_not(b6, c7);
    if none(ex) { return ret; }
    let e_23 = shell_middle(r, pixel_a0, along_3);
    at_v2 = e_23;
    at_v2.segments = splat_u(3u32);
    let e_27 = at_v2;
    return sel_entered(ex, &e_27, &ret);
} }
lanes! { fn triangle_distance(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, normal_a1: Vec3<F>) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let a_5 = Vec3 { x: sub(splat(pixel_a0.a.position.x), pixel_a0.origin.x), y: sub(splat(pixel_a0.a.position.y), pixel_a0.origin.y), z: sub(splat(pixel_a0.a.position.z), pixel_a0.origin.z) };
    let b_9 = Vec3 { x: sub(splat(pixel_a0.b.position.x), pixel_a0.origin.x), y: sub(splat(pixel_a0.b.position.y), pixel_a0.origin.y), z: sub(splat(pixel_a0.b.position.z), pixel_a0.origin.z) };
    let c_13 = Vec3 { x: sub(splat(pixel_a0.c.position.x), pixel_a0.origin.x), y: sub(splat(pixel_a0.c.position.y), pixel_a0.origin.y), z: sub(splat(pixel_a0.c.position.z), pixel_a0.origin.z) };
    let e_17 = add(add(add(mul(pixel_a0.direction.x, pixel_a0.direction.x), mul(pixel_a0.direction.y, pixel_a0.direction.y)), mul(pixel_a0.direction.z, pixel_a0.direction.z)), splat(0.0f32));
    let along_19 = Vec3 { x: div(pixel_a0.direction.x, e_17), y: div(pixel_a0.direction.y, e_17), z: div(pixel_a0.direction.z, e_17) };
    let places_23 = Vec3 { x: add(add(add(mul(a_5.x, along_19.x), mul(a_5.y, along_19.y)), mul(a_5.z, along_19.z)), splat(0.0f32)), y: add(add(add(mul(b_9.x, along_19.x), mul(b_9.y, along_19.y)), mul(b_9.z, along_19.z)), splat(0.0f32)), z: add(add(add(mul(c_13.x, along_19.x), mul(c_13.y, along_19.y)), mul(c_13.z, along_19.z)), splat(0.0f32)) };
    let least_28 = min(min(places_23.x, places_23.y), places_23.z);
    let most_33 = max(max(places_23.x, places_23.y), places_23.z);
    let across_35 = add(add(add(mul(normal_a1.x, pixel_a0.direction.x), mul(normal_a1.y, pixel_a0.direction.y)), mul(normal_a1.z, pixel_a0.direction.z)), splat(0.0f32));
    let c1 = eq(across_35, splat(0.0f32));
    ret = least_28;
    ex = and_not(ex, c1);
    return sel(ex, min(max(div(add(add(add(mul(normal_a1.x, a_5.x), mul(normal_a1.y, a_5.y)), mul(normal_a1.z, a_5.z)), splat(0.0f32)), across_35), least_28), most_33), ret);
} }
lanes! { fn triangle_weights(r: &Resources<'_>, pixel_a0: &PixelIn, normal_a1: Vec3<F>, point_a2: Vec3<F>) -> Vec3<F> {
    let e_3 = plane_weights(r, pixel_a0, normal_a1, point_a2);
    let inside_8 = Vec3 { x: max_with(e_3.x, splat(0.0f32)), y: max_with(e_3.y, splat(0.0f32)), z: max_with(e_3.z, splat(0.0f32)) };
    let e_13 = add(add(inside_8.x, inside_8.y), inside_8.z);
    return Vec3 { x: div(inside_8.x, e_13), y: div(inside_8.y, e_13), z: div(inside_8.z, e_13) };
} }
lanes! { fn is_on_map(r: &Resources<'_>, uv_a0: Vec2<F>) -> M {
    let mut both_v0: M = splat_m(false);
    let beyond_11 = sub(max(abs(sub(uv_a0.x, splat(0.5f32))), abs(sub(uv_a0.y, splat(0.5f32)))), splat(0.5f32));
    if !(r.surface_settings.wrap != 1u32) {
        both_v0 = le(beyond_11, splat(1e-6f32));
    } else {
        both_v0 = splat_m(true);
    }
    let e_23 = both_v0;
    return e_23;
} }
lanes! { fn surface_facets_enter(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, params_a1: Vec4<f32>) -> Entered {
    let mut ex = within;
    let mut ret: Entered = zero_entered();
    let mut both_v0: M = splat_m(false);
    let n_2 = plane_normal(r, pixel_a0);
    let e_5 = triangle_distance(r, ex, pixel_a0, n_2);
    let point_7 = Vec3 { x: add(pixel_a0.origin.x, mul(pixel_a0.direction.x, e_5)), y: add(pixel_a0.origin.y, mul(pixel_a0.direction.y, e_5)), z: add(pixel_a0.origin.z, mul(pixel_a0.direction.z, e_5)) };
    let w_8 = triangle_weights(r, pixel_a0, n_2, point_7);
    let uv_22 = Vec2 { x: add(add(mul(splat(pixel_a0.a.uv.x), w_8.x), mul(splat(pixel_a0.b.uv.x), w_8.y)), mul(splat(pixel_a0.c.uv.x), w_8.z)), y: add(add(mul(splat(pixel_a0.a.uv.y), w_8.x), mul(splat(pixel_a0.b.uv.y), w_8.y)), mul(splat(pixel_a0.c.uv.y), w_8.z)) };
    let tangent_36 = Vec3 { x: add(add(mul(splat(pixel_a0.a.tangent.x), w_8.x), mul(splat(pixel_a0.b.tangent.x), w_8.y)), mul(splat(pixel_a0.c.tangent.x), w_8.z)), y: add(add(mul(splat(pixel_a0.a.tangent.y), w_8.x), mul(splat(pixel_a0.b.tangent.y), w_8.y)), mul(splat(pixel_a0.c.tangent.y), w_8.z)), z: add(add(mul(splat(pixel_a0.a.tangent.z), w_8.x), mul(splat(pixel_a0.b.tangent.z), w_8.y)), mul(splat(pixel_a0.c.tangent.z), w_8.z)) };
    let bitangent_50 = Vec3 { x: add(add(mul(splat(pixel_a0.a.bitangent.x), w_8.x), mul(splat(pixel_a0.b.bitangent.x), w_8.y)), mul(splat(pixel_a0.c.bitangent.x), w_8.z)), y: add(add(mul(splat(pixel_a0.a.bitangent.y), w_8.x), mul(splat(pixel_a0.b.bitangent.y), w_8.y)), mul(splat(pixel_a0.c.bitangent.y), w_8.z)), z: add(add(mul(splat(pixel_a0.a.bitangent.z), w_8.x), mul(splat(pixel_a0.b.bitangent.z), w_8.y)), mul(splat(pixel_a0.c.bitangent.z), w_8.z)) };
    let sum_66 = Vec3 { x: mul(add(add(mul(splat(pixel_a0.a.normal.x), w_8.x), mul(splat(pixel_a0.b.normal.x), w_8.y)), mul(splat(pixel_a0.c.normal.x), w_8.z)), splat(pixel_a0.side)), y: mul(add(add(mul(splat(pixel_a0.a.normal.y), w_8.x), mul(splat(pixel_a0.b.normal.y), w_8.y)), mul(splat(pixel_a0.c.normal.y), w_8.z)), splat(pixel_a0.side)), z: mul(add(add(mul(splat(pixel_a0.a.normal.z), w_8.x), mul(splat(pixel_a0.b.normal.z), w_8.y)), mul(splat(pixel_a0.c.normal.z), w_8.z)), splat(pixel_a0.side)) };
    let tt_67 = add(add(add(mul(tangent_36.x, tangent_36.x), mul(tangent_36.y, tangent_36.y)), mul(tangent_36.z, tangent_36.z)), splat(0.0f32));
    let tb_68 = add(add(add(mul(tangent_36.x, bitangent_50.x), mul(tangent_36.y, bitangent_50.y)), mul(tangent_36.z, bitangent_50.z)), splat(0.0f32));
    let bb_69 = add(add(add(mul(bitangent_50.x, bitangent_50.x), mul(bitangent_50.y, bitangent_50.y)), mul(bitangent_50.z, bitangent_50.z)), splat(0.0f32));
    let (b1, c2) = (ex, gt(add(add(add(mul(n_2.x, n_2.x), mul(n_2.y, n_2.y)), mul(n_2.z, n_2.z)), splat(0.0f32)), splat(0.0f32)));
    ex = and(b1, c2);
    if any(ex) {
        let e_77 = is_on_map(r, uv_22);
        both_v0 = sel_m(ex, e_77, both_v0);
    }
    ex = and_not(b1, c2);
    if any(ex) {
        both_v0 = sel_m(ex, splat_m(false), both_v0);
    }
    ex = b1;
    let e_79 = both_v0;
    let length3 = sqrt(add(add(mul(sum_66.x, sum_66.x), mul(sum_66.y, sum_66.y)), mul(sum_66.z, sum_66.z)));
    let e_81 = Vec3 { x: div(sum_66.x, length3), y: div(sum_66.y, length3), z: div(sum_66.z, length3) };
    return Entered { segments: sel_u(e_79, splat_u(1u32), splat_u(0u32)), point: point_7, uv: uv_22, tangent: tangent_36, bitangent: bitangent_50, normal: e_81, metric: Vec4 { x: tt_67, y: tb_68, z: bb_69, w: splat(r.surface_settings.scale_m) }, level: splat_u(0u32), facing: n_2, span: Vec2 { x: splat(0.0f32), y: splat(0.0f32) }, of_surface: Vec4 { x: splat(0.0f32), y: splat(0.0f32), z: splat(0.0f32), w: splat(0.0f32) }, footprint: splat(0.0f32), fade: splat(0.0f32), depth: splat(0.0f32), };
} }
lanes! { fn surface_slices_enter(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, params_a1: Vec4<f32>) -> Entered {
    let mut ex = within;
    let mut ret: Entered = zero_entered();
    let mut both_v0: M = splat_m(false);
    let mut both_v1: M = splat_m(false);
    let mut both_v2: M = splat_m(false);
    let n_2 = plane_normal(r, pixel_a0);
    let e_5 = triangle_distance(r, ex, pixel_a0, n_2);
    let point_7 = Vec3 { x: add(pixel_a0.origin.x, mul(pixel_a0.direction.x, e_5)), y: add(pixel_a0.origin.y, mul(pixel_a0.direction.y, e_5)), z: add(pixel_a0.origin.z, mul(pixel_a0.direction.z, e_5)) };
    let w_8 = triangle_weights(r, pixel_a0, n_2, point_7);
    let uv_22 = Vec2 { x: add(add(mul(splat(pixel_a0.a.uv.x), w_8.x), mul(splat(pixel_a0.b.uv.x), w_8.y)), mul(splat(pixel_a0.c.uv.x), w_8.z)), y: add(add(mul(splat(pixel_a0.a.uv.y), w_8.x), mul(splat(pixel_a0.b.uv.y), w_8.y)), mul(splat(pixel_a0.c.uv.y), w_8.z)) };
    let tangent_36 = Vec3 { x: add(add(mul(splat(pixel_a0.a.tangent.x), w_8.x), mul(splat(pixel_a0.b.tangent.x), w_8.y)), mul(splat(pixel_a0.c.tangent.x), w_8.z)), y: add(add(mul(splat(pixel_a0.a.tangent.y), w_8.x), mul(splat(pixel_a0.b.tangent.y), w_8.y)), mul(splat(pixel_a0.c.tangent.y), w_8.z)), z: add(add(mul(splat(pixel_a0.a.tangent.z), w_8.x), mul(splat(pixel_a0.b.tangent.z), w_8.y)), mul(splat(pixel_a0.c.tangent.z), w_8.z)) };
    let bitangent_50 = Vec3 { x: add(add(mul(splat(pixel_a0.a.bitangent.x), w_8.x), mul(splat(pixel_a0.b.bitangent.x), w_8.y)), mul(splat(pixel_a0.c.bitangent.x), w_8.z)), y: add(add(mul(splat(pixel_a0.a.bitangent.y), w_8.x), mul(splat(pixel_a0.b.bitangent.y), w_8.y)), mul(splat(pixel_a0.c.bitangent.y), w_8.z)), z: add(add(mul(splat(pixel_a0.a.bitangent.z), w_8.x), mul(splat(pixel_a0.b.bitangent.z), w_8.y)), mul(splat(pixel_a0.c.bitangent.z), w_8.z)) };
    let raw_64 = Vec3 { x: add(add(mul(splat(pixel_a0.a.normal.x), w_8.x), mul(splat(pixel_a0.b.normal.x), w_8.y)), mul(splat(pixel_a0.c.normal.x), w_8.z)), y: add(add(mul(splat(pixel_a0.a.normal.y), w_8.x), mul(splat(pixel_a0.b.normal.y), w_8.y)), mul(splat(pixel_a0.c.normal.y), w_8.z)), z: add(add(mul(splat(pixel_a0.a.normal.z), w_8.x), mul(splat(pixel_a0.b.normal.z), w_8.y)), mul(splat(pixel_a0.c.normal.z), w_8.z)) };
    let slice_78 = Vec3 { x: add(add(mul(splat(pixel_a0.a.of_surface.x), w_8.x), mul(splat(pixel_a0.b.of_surface.x), w_8.y)), mul(splat(pixel_a0.c.of_surface.x), w_8.z)), y: add(add(mul(splat(pixel_a0.a.of_surface.y), w_8.x), mul(splat(pixel_a0.b.of_surface.y), w_8.y)), mul(splat(pixel_a0.c.of_surface.y), w_8.z)), z: add(add(mul(splat(pixel_a0.a.of_surface.z), w_8.x), mul(splat(pixel_a0.b.of_surface.z), w_8.y)), mul(splat(pixel_a0.c.of_surface.z), w_8.z)) };
    let tt_79 = add(add(add(mul(tangent_36.x, tangent_36.x), mul(tangent_36.y, tangent_36.y)), mul(tangent_36.z, tangent_36.z)), splat(0.0f32));
    let tb_80 = add(add(add(mul(tangent_36.x, bitangent_50.x), mul(tangent_36.y, bitangent_50.y)), mul(tangent_36.z, bitangent_50.z)), splat(0.0f32));
    let bb_81 = add(add(add(mul(bitangent_50.x, bitangent_50.x), mul(bitangent_50.y, bitangent_50.y)), mul(bitangent_50.z, bitangent_50.z)), splat(0.0f32));
    let area_84 = sub(mul(tt_79, bb_81), mul(tb_80, tb_80));
    let height_m_93 = add(splat(r.surface_settings.bias_m), mul(splat(r.surface_settings.scale_m), slice_78.x));
    let length1 = sqrt(add(add(mul(raw_64.x, raw_64.x), mul(raw_64.y, raw_64.y)), mul(raw_64.z, raw_64.z)));
    let normal_94 = Vec3 { x: div(raw_64.x, length1), y: div(raw_64.y, length1), z: div(raw_64.z, length1) };
    let e_95 = is_on_map(r, uv_22);
    both_v0 = and(e_95, le(sub(abs(sub(slice_78.x, splat(0.5f32))), splat(0.5f32)), splat(1e-6f32)));
    let is_within_107 = both_v0;
    both_v1 = and(gt(add(add(add(mul(n_2.x, n_2.x), mul(n_2.y, n_2.y)), mul(n_2.z, n_2.z)), splat(0.0f32)), splat(0.0f32)), gt(area_84, splat(0.0f32)));
    let e_118 = both_v1;
    both_v2 = and(e_118, is_within_107);
    let e_122 = both_v2;
    return Entered { segments: sel_u(e_122, splat_u(1u32), splat_u(0u32)), point: Vec3 { x: sub(point_7.x, mul(raw_64.x, height_m_93)), y: sub(point_7.y, mul(raw_64.y, height_m_93)), z: sub(point_7.z, mul(raw_64.z, height_m_93)) }, uv: uv_22, tangent: tangent_36, bitangent: bitangent_50, normal: normal_94, metric: Vec4 { x: tt_79, y: tb_80, z: bb_81, w: splat(r.surface_settings.scale_m) }, level: splat_u(0u32), facing: normal_94, span: Vec2 { x: splat(0.0f32), y: splat(0.0f32) }, of_surface: Vec4 { x: slice_78.x, y: slice_78.y, z: slice_78.z, w: splat(0.0f32) }, footprint: splat(0.0f32), fade: splat(0.0f32), depth: splat(0.0f32), };
} }
lanes! { fn surface_object_enter(r: &Resources<'_>, pixel_a0: &PixelIn, params_a1: Vec4<f32>) -> Entered {
    let mut at_v0: Entered = zero_entered();
    let e_2 = passed_by(r);
    at_v0 = e_2;
    at_v0.segments = splat_u(r.surface_settings.solids);
    at_v0.point = Vec3 { x: pixel_a0.origin.x, y: pixel_a0.origin.y, z: pixel_a0.origin.z };
    let e_10 = at_v0;
    return e_10;
} }
lanes! { fn surface_frames_enter(r: &Resources<'_>, pixel_a0: &PixelIn, params_a1: Vec4<f32>) -> Entered {
    let mut at_v0: Entered = zero_entered();
    let e_2 = passed_by(r);
    at_v0 = e_2;
    at_v0.segments = splat_u(3u32);
    at_v0.point = Vec3 { x: pixel_a0.origin.x, y: pixel_a0.origin.y, z: pixel_a0.origin.z };
    let e_8 = at_v0;
    return e_8;
} }
lanes! { fn surface_object_slices_enter(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, params_a1: Vec4<f32>) -> Entered {
    let mut ex = within;
    let mut ret: Entered = zero_entered();
    let mut at_v0: Entered = zero_entered();
    let n_2 = plane_normal(r, pixel_a0);
    let e_3 = passed_by(r);
    at_v0 = e_3;
    at_v0.segments = sel_u(gt(add(add(add(mul(n_2.x, n_2.x), mul(n_2.y, n_2.y)), mul(n_2.z, n_2.z)), splat(0.0f32)), splat(0.0f32)), splat_u(1u32), splat_u(0u32));
    let e_15 = triangle_distance(r, ex, pixel_a0, n_2);
    at_v0.point = Vec3 { x: add(pixel_a0.origin.x, mul(pixel_a0.direction.x, e_15)), y: add(pixel_a0.origin.y, mul(pixel_a0.direction.y, e_15)), z: add(pixel_a0.origin.z, mul(pixel_a0.direction.z, e_15)) };
    let length1 = sqrt(add(add(mul(n_2.x, n_2.x), mul(n_2.y, n_2.y)), mul(n_2.z, n_2.z)));
    let e_19 = Vec3 { x: div(n_2.x, length1), y: div(n_2.y, length1), z: div(n_2.z, length1) };
    let e_26 = sel(gt(add(add(add(mul(n_2.x, pixel_a0.direction.x), mul(n_2.y, pixel_a0.direction.y)), mul(n_2.z, pixel_a0.direction.z)), splat(0.0f32)), splat(0.0f32)), splat((-1.0f32)), splat(1.0f32));
    at_v0.normal = Vec3 { x: mul(e_19.x, e_26), y: mul(e_19.y, e_26), z: mul(e_19.z, e_26) };
    let e_28 = at_v0;
    return e_28;
} }
lanes! { fn surface_enter_stage(r: &Resources<'_>, within: M, pixel_a0: &PixelIn) -> Entered {
    let mut ex = within;
    let mut ret: Entered = zero_entered();
    match r.surface_settings.choices[1].number {
        0u32 => {
            let e_11 = surface_plane_enter(r, ex, pixel_a0, r.surface_settings.choices[1].params);
            return e_11;
        }
        1u32 => {
            let e_17 = surface_prism_enter(r, ex, pixel_a0, r.surface_settings.choices[1].params);
            return e_17;
        }
        2u32 => {
            let e_23 = surface_quadric_perpendicular_enter(r, ex, pixel_a0, r.surface_settings.choices[1].params);
            return e_23;
        }
        3u32 => {
            let e_29 = surface_quadric_vertical_enter(r, ex, pixel_a0, r.surface_settings.choices[1].params);
            return e_29;
        }
        4u32 => {
            let e_35 = surface_tetrahedra_enter(r, ex, pixel_a0, r.surface_settings.choices[1].params);
            return e_35;
        }
        5u32 => {
            let e_41 = surface_facets_enter(r, ex, pixel_a0, r.surface_settings.choices[1].params);
            return e_41;
        }
        6u32 => {
            let e_47 = surface_slices_enter(r, ex, pixel_a0, r.surface_settings.choices[1].params);
            return e_47;
        }
        7u32 => {
            let e_53 = surface_object_enter(r, pixel_a0, r.surface_settings.choices[1].params);
            return e_53;
        }
        8u32 => {
            let e_59 = surface_frames_enter(r, pixel_a0, r.surface_settings.choices[1].params);
            return e_59;
        }
        _ => {
            let e_65 = surface_object_slices_enter(r, ex, pixel_a0, r.surface_settings.choices[1].params);
            return e_65;
        }
    }
} }
stage! { pub(super) fn enter_relief(r: &Resources<'_>, within: M, pixel_a0: &PixelIn) -> Entered {
    let mut ex = within;
    let mut ret: Entered = zero_entered();
    let mut at_v0: Entered = zero_entered();
    let e_1 = surface_enter_stage(r, ex, pixel_a0);
    at_v0 = e_1;
    let e_4 = at_v0.segments;
    let (b1, c2) = (ex, eq_u(e_4, splat_u(0u32)));
    ex = and(b1, c2);
    if any(ex) {
        let e_7 = at_v0;
        ret = e_7;
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    let e_8 = at_v0;
    if none(ex) { return ret; }
    let detail_9 = detail_stage(r, ex, pixel_a0, &e_8);
    at_v0.level = detail_9.level;
    at_v0.footprint = detail_9.footprint;
    at_v0.fade = detail_9.fade;
    let e_16 = at_v0;
    return sel_entered(ex, &e_16, &ret);
} }
lanes! { fn facing_four(r: &Resources<'_>, middle_a0: F, along_a1: F, across_a2: F) -> Vec4<F> {
    let x_4 = mul(along_a1, splat(1.7320508f32));
    let y_6 = mul(across_a2, splat(1.7320508f32));
    return Vec4 { x: max_with(add(middle_a0, x_4), splat(0.0f32)), y: max_with(sub(middle_a0, x_4), splat(0.0f32)), z: max_with(add(middle_a0, y_6), splat(0.0f32)), w: max_with(sub(middle_a0, y_6), splat(0.0f32)) };
} }
lanes! { fn flattened(r: &Resources<'_>, within: M, path_a0: &Path, middle_a1: f32, part_a2: F) -> Path {
    let mut ex = within;
    let mut ret: Path = zero_path();
    let mut start_v0: F = splat(0.0f32);
    let kept_4 = sub(splat(1.0f32), part_a2);
    let top_8 = add(splat(middle_a1), mul(splat((1.0f32 - middle_a1)), kept_4));
    let above_11 = sub(path_a0.h.x, top_8);
    let begins_13 = gt(above_11, splat(0.0f32));
    let (b1, c2) = (ex, begins_13);
    ex = and(b1, c2);
    if any(ex) {
        let e_22 = first_root(r, ex, Vec3 { x: above_11, y: path_a0.h.y, z: path_a0.h.z }, path_a0.exit);
        start_v0 = sel(ex, min(e_22, path_a0.exit), start_v0);
    }
    ex = b1;
    let height_31 = sel(begins_13, splat(1.0f32), add(splat(middle_a1), div(sub(path_a0.h.x, splat(middle_a1)), kept_4)));
    let e_32 = start_v0;
    let e_33 = path_slope(r, path_a0, e_32);
    let h_38 = Vec3 { x: height_31, y: div(e_33, kept_4), z: div(path_a0.h.z, kept_4) };
    let e_40 = start_v0;
    let rest_41 = sub(path_a0.exit, e_40);
    let e_48 = first_root(r, ex, Vec3 { x: max_with(h_38.x, splat(0.0f32)), y: h_38.y, z: h_38.z }, rest_41);
    let exit_51 = min(mul(e_48, splat(1.000001f32)), rest_41);
    let e_53 = start_v0;
    let base_57 = min_with(max_with(sub(path_a0.base, e_53), splat((-3e38f32))), splat(3e38f32));
    let e_58 = start_v0;
    let e_59 = path_uv(r, path_a0, e_58);
    let e_65 = start_v0;
    return Path { uv: e_59, duv: Vec2 { x: path_a0.duv.x, y: path_a0.duv.y }, h: h_38, exit: exit_51, base: base_57, metric: Vec4 { x: path_a0.metric.x, y: path_a0.metric.y, z: path_a0.metric.z, w: path_a0.metric.w }, ray: path_a0.ray, level: path_a0.level, start: add(path_a0.start, e_65), share: path_a0.share, bend: path_a0.bend, };
} }
lanes! { fn faded(r: &Resources<'_>, within: M, segment_a0: &Path, part_a1: F) -> Path {
    let mut ex = within;
    let mut ret: Path = zero_path();
    let mut path_v0: Path = zero_path();
    path_v0 = *segment_a0;
    let (b1, c2) = (ex, gt(part_a1, splat(0.0f32)));
    ex = and(b1, c2);
    if any(ex) {
        let e_5 = path_v0;
        let e_9 = flattened(r, ex, &e_5, r.surface_settings.mean_height, part_a1);
        path_v0 = sel_path(ex, &e_9, &path_v0);
        let e_12 = path_v0.h.x;
        let c3 = not(gt(e_12, splat(0.0f32)));
        path_v0.exit = sel(and(ex, c3), splat(0.0f32), path_v0.exit);
    }
    ex = b1;
    let e_18 = path_v0;
    return e_18;
} }
lanes! { fn field_heights_height(r: &Resources<'_>, within: M, uv_a0: Vec2<F>, height_a1: F, level_a2: U, params_a3: Vec4<f32>) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let e_4 = height_at_ll(r, ex, uv_a0, level_a2);
    return e_4;
} }
lanes! { fn field_volume_height(r: &Resources<'_>, uv_a0: Vec2<F>, height_a1: F, level_a2: U, params_a3: Vec4<f32>) -> F {
    return height_a1;
} }
lanes! { fn field_motif_height(r: &Resources<'_>, uv_a0: Vec2<F>, height_a1: F, level_a2: U, params_a3: Vec4<f32>) -> F {
    return height_a1;
} }
lanes! { fn field_height_stage(r: &Resources<'_>, within: M, uv_a0: Vec2<F>, height_a1: F, level_a2: U) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    match r.surface_settings.choices[4].number {
        0u32 => {
            let e_13 = field_heights_height(r, ex, uv_a0, height_a1, level_a2, r.surface_settings.choices[4].params);
            return e_13;
        }
        1u32 => {
            let e_19 = field_volume_height(r, uv_a0, height_a1, level_a2, r.surface_settings.choices[4].params);
            return e_19;
        }
        _ => {
            let e_25 = field_motif_height(r, uv_a0, height_a1, level_a2, r.surface_settings.choices[4].params);
            return e_25;
        }
    }
} }
lanes! { fn from_hit(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, light_a2: &Toward) -> Path {
    let mut ex = within;
    let mut ret: Path = zero_path();
    let change_4 = climb(r, at_a0, Vec3 { x: light_a2.direction.x, y: light_a2.direction.y, z: light_a2.direction.z });
    let uv_6 = near_uv(r, Vec2 { x: hit_a1.uv.x, y: hit_a1.uv.y });
    let e_8 = height_at_ll(r, ex, uv_6, at_a0.level);
    let h_11 = Vec3 { x: e_8, y: change_4.z, z: splat(0.0f32) };
    return Path { uv: uv_6, duv: Vec2 { x: change_4.x, y: change_4.y }, h: h_11, exit: splat(0.0f32), base: splat(0.0f32), metric: Vec4 { x: at_a0.metric.x, y: at_a0.metric.y, z: at_a0.metric.z, w: at_a0.metric.w }, ray: splat_u(1u32), level: at_a0.level, start: splat(0.0f32), share: splat(1.0f32), bend: splat(0.0f32), };
} }
lanes! { fn way_out(r: &Resources<'_>, within: M, path_a0: &Path, light_a1: &Toward) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let mut way_v0: F = splat(0f32);
    let mut interval_v1: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    way_v0 = min(div(sub(splat(1.0f32), path_a0.h.x), path_a0.h.y), light_a1.distance);
    if (r.surface_settings.wrap == 1u32) {
        let e_21 = way_v0;
        let e_24 = inside_unit(r, ex, path_a0.uv.x, path_a0.duv.x, Vec2 { x: splat(0.0f32), y: e_21 });
        interval_v1 = e_24;
        let e_30 = interval_v1;
        let e_31 = inside_unit(r, ex, path_a0.uv.y, path_a0.duv.y, e_30);
        interval_v1 = e_31;
        let e_33 = interval_v1.y;
        way_v0 = e_33;
    }
    let e_34 = way_v0;
    return e_34;
} }
lanes! { fn light_ray_over_heights(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, light_a2: &Toward) -> LightRay {
    let mut ex = within;
    let mut ret: LightRay = zero_light_ray();
    let mut both_v0: M = splat_m(false);
    let way_3 = from_hit(r, ex, at_a0, hit_a1, light_a2);
    let (b1, c2) = (ex, not(gt(way_3.h.y, splat(0.0f32))));
    ex = and(b1, c2);
    if any(ex) {
        ret = LightRay { state: splat_u(1u32), path: way_3, };
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    if none(ex) { return ret; }
    let exit_11 = way_out(r, ex, &way_3, light_a2);
    let (b3, c4) = (ex, not(gt(exit_11, splat(0.0f32))));
    ex = and(b3, c4);
    if any(ex) {
        ret = sel_light_ray(ex, &LightRay { state: splat_u(0u32), path: way_3, }, &ret);
        ex = no_lane();
    }
    ex = and_not(b3, c4);
    if none(ex) { return ret; }
    let grid_17 = grid_of(r, &way_3);
    let cell_19 = cell_of(r, Vec2 { x: grid_17.origin.x, y: grid_17.origin.y });
    let leave_20 = cell_leave(r, &grid_17, cell_19);
    let end_26 = max_with(min(min(leave_20.x, leave_20.y), exit_11), splat(0.0f32));
    let e_29 = height_cell_ll(r, ex, Vec2 { x: i_of_small(cell_19.x), y: i_of_small(cell_19.y) }, way_3.level);
    let c_31 = gap_to(r, &way_3, &grid_17, cell_19, e_29, splat(0.0f32));
    both_v0 = or(lt(c_31.y, splat(0.0f32)), lt(add(c_31.y, mul(c_31.z, end_26)), splat(0.0f32)));
    let e_45 = both_v0;
    let (b5, c6) = (ex, e_45);
    ex = and(b5, c6);
    if any(ex) {
        ret = sel_light_ray(ex, &LightRay { state: splat_u(1u32), path: way_3, }, &ret);
        ex = no_lane();
    }
    ex = and_not(b5, c6);
    if none(ex) { return ret; }
    let (b7, c8) = (ex, ge(end_26, exit_11));
    ex = and(b7, c8);
    if any(ex) {
        ret = sel_light_ray(ex, &LightRay { state: splat_u(0u32), path: way_3, }, &ret);
        ex = no_lane();
    }
    ex = and_not(b7, c8);
    if none(ex) { return ret; }
    let start_51 = path_uv(r, &way_3, end_26);
    let gap_56 = mul(end_26, add(c_31.y, mul(c_31.z, end_26)));
    let e_58 = height_at_ll(r, ex, start_51, way_3.level);
    let h_65 = Vec3 { x: add(add(e_58, gap_56), splat(9.536743e-7f32)), y: way_3.h.y, z: splat(0.0f32) };
    let path_74 = Path { uv: start_51, duv: Vec2 { x: way_3.duv.x, y: way_3.duv.y }, h: h_65, exit: sub(exit_11, end_26), base: splat(0.0f32), metric: Vec4 { x: way_3.metric.x, y: way_3.metric.y, z: way_3.metric.z, w: way_3.metric.w }, ray: way_3.ray, level: way_3.level, start: end_26, share: splat(1.0f32), bend: splat(0.0f32), };
    return sel_light_ray(ex, &LightRay { state: splat_u(2u32), path: path_74, }, &ret);
} }
lanes! { fn field_heights_light_ray(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, light_a2: &Toward, params_a3: Vec4<f32>) -> LightRay {
    let mut ex = within;
    let mut ret: LightRay = zero_light_ray();
    let e_4 = light_ray_over_heights(r, ex, at_a0, hit_a1, light_a2);
    return e_4;
} }
lanes! { fn no_table(r: &Resources<'_>) -> SeenTable {
    let none_3 = Vec3 { x: 0.0f32, y: 0.0f32, z: 0.0f32 };
    return SeenTable { mean: Vec3 { x: splat(none_3.x), y: splat(none_3.y), z: splat(none_3.z) }, squares: Vec3 { x: splat(none_3.x), y: splat(none_3.y), z: splat(none_3.z) }, products: Vec3 { x: splat(none_3.x), y: splat(none_3.y), z: splat(none_3.z) }, };
} }
lanes! { fn one_seen(r: &Resources<'_>, normal_a0: Vec3<F>) -> SeenNormals {
    let nothing_3 = Vec2 { x: 0.0f32, y: 0.0f32 };
    let none_7 = Vec3 { x: 0.0f32, y: 0.0f32, z: 0.0f32 };
    let parts_12 = Vec4 { x: 0.0f32, y: 0.0f32, z: 0.0f32, w: 0.0f32 };
    let table_13 = no_table(r);
    return SeenNormals { normal: normal_a0, length: splat(1.0f32), differ: splat_u(0u32), middle: Vec3 { x: splat(none_7.x), y: splat(none_7.y), z: splat(none_7.z) }, along: Vec3 { x: splat(none_7.x), y: splat(none_7.y), z: splat(none_7.z) }, across: Vec3 { x: splat(none_7.x), y: splat(none_7.y), z: splat(none_7.z) }, slope: Vec2 { x: splat(nothing_3.x), y: splat(nothing_3.y) }, slope_along: Vec2 { x: splat(nothing_3.x), y: splat(nothing_3.y) }, slope_across: Vec2 { x: splat(nothing_3.x), y: splat(nothing_3.y) }, upright: splat(1.0f32), middle_seen: splat(0.0f32), others_seen: Vec4 { x: splat(parts_12.x), y: splat(parts_12.y), z: splat(parts_12.z), w: splat(parts_12.w) }, table_part: splat(0.0f32), table: table_13, };
} }
lanes! { fn normal_between_lsl(r: &Resources<'_>, within: M, at_a0: &Around, layer_a1: i32, level_a2: U) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let k_3 = i_of_u(level_a2);
    let e_10 = color_texel_of_each(&r.normal_map, ex, at_a0.columns.x, at_a0.rows.x, splat_i(layer_a1), k_3);
    let e_17 = color_texel_of_each(&r.normal_map, ex, at_a0.columns.y, at_a0.rows.x, splat_i(layer_a1), k_3);
    let e_24 = color_texel_of_each(&r.normal_map, ex, at_a0.columns.x, at_a0.rows.y, splat_i(layer_a1), k_3);
    let e_31 = color_texel_of_each(&r.normal_map, ex, at_a0.columns.y, at_a0.rows.y, splat_i(layer_a1), k_3);
    let e_33 = bilinear(r, e_10, e_17, e_24, e_31, Vec2 { x: at_a0.part.x, y: at_a0.part.y });
    return e_33;
} }
lanes! { fn normal_between_lss(r: &Resources<'_>, at_a0: &Around, layer_a1: i32, level_a2: u32) -> Vec4<F> {
    let k_3 = (level_a2 as i32);
    let e_10 = color_texel(&r.normal_map, at_a0.columns.x, at_a0.rows.x, layer_a1, k_3);
    let e_17 = color_texel(&r.normal_map, at_a0.columns.y, at_a0.rows.x, layer_a1, k_3);
    let e_24 = color_texel(&r.normal_map, at_a0.columns.x, at_a0.rows.y, layer_a1, k_3);
    let e_31 = color_texel(&r.normal_map, at_a0.columns.y, at_a0.rows.y, layer_a1, k_3);
    let e_33 = bilinear(r, e_10, e_17, e_24, e_31, Vec2 { x: at_a0.part.x, y: at_a0.part.y });
    return e_33;
} }
lanes! { fn normal_at(r: &Resources<'_>, within: M, uv_a0: Vec2<F>, level_a1: u32) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let e_5 = level_texels(r, r.surface_settings.normal_size, splat_u(level_a1));
    let e_6 = texels_around(r, ex, uv_a0, e_5);
    let e_8 = normal_between_lss(r, &e_6, 0i32, level_a1);
    return e_8;
} }
lanes! { fn sloped_cell(r: &Resources<'_>, i_a0: Vec2<I>, level_a1: u32) -> Vec2<I> {
    if (r.surface_settings.wrap != 1u32) {
        return i_a0;
    }
    let e_7 = height_texels(r, splat_u(level_a1));
    let last_15 = Vec2 { x: max_i(sub_i(e_7.x, splat_i(2i32)), splat_i(0i32)), y: max_i(sub_i(e_7.y, splat_i(2i32)), splat_i(0i32)) };
    return Vec2 { x: min_i(max_i(i_a0.x, splat_i(0i32)), last_15.x), y: min_i(max_i(i_a0.y, splat_i(0i32)), last_15.y) };
} }
lanes! { fn slope_beside(r: &Resources<'_>, within: M, own_a0: F, beside_a1: F, rate_a2: F) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let a_3 = mul(own_a0, rate_a2);
    let b_4 = mul(beside_a1, rate_a2);
    let along_7 = add(splat(1.0f32), mul(a_3, b_4));
    let apart_9 = abs(sub(a_3, b_4));
    let c1 = le(apart_9, mul(splat(0.5f32), along_7));
    ret = beside_a1;
    ex = and_not(ex, c1);
    let c2 = ge(apart_9, mul(splat(1.0f32), along_7));
    ret = sel(and(ex, c2), own_a0, ret);
    ex = and_not(ex, c2);
    let part_20 = div(sub(div(apart_9, along_7), splat(0.5f32)), splat(0.5f32));
    return sel(ex, add(beside_a1, mul(sub(own_a0, beside_a1), part_20)), ret);
} }
lanes! { fn slopes_between_creases(r: &Resources<'_>, within: M, at_a0: &Entered, uv_a1: Vec2<F>, level_a2: u32) -> Vec2<F> {
    let mut ex = within;
    let mut ret: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    let mut part_v0: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    let size_3 = height_size(r, splat_u(level_a2));
    let point_8 = Vec2 { x: sub(mul(uv_a1.x, size_3.x), splat(0.5f32)), y: sub(mul(uv_a1.y, size_3.y), splat(0.5f32)) };
    let e_9 = cell_of(r, point_8);
    let e_11 = sloped_cell(r, Vec2 { x: i_of_small(e_9.x), y: i_of_small(e_9.y) }, level_a2);
    let cell_12 = Vec2 { x: f_of_i(e_11.x), y: f_of_i(e_11.y) };
    part_v0 = Vec2 { x: sub(point_8.x, cell_12.x), y: sub(point_8.y, cell_12.y) };
    if (r.surface_settings.wrap == 1u32) {
        let e_20 = part_v0;
        part_v0 = Vec2 { x: min_with(max_with(e_20.x, splat(0.0f32)), splat(1.0f32)), y: min_with(max_with(e_20.y, splat(0.0f32)), splat(1.0f32)) };
    }
    let i_28 = Vec2 { x: i_of_f(cell_12.x), y: i_of_f(cell_12.y) };
    let e_29 = height_cell_ls(r, ex, i_28, level_a2);
    let e_30 = part_v0;
    let own_31 = cell_slopes(r, e_29, e_30);
    let e_36 = sloped_cell(r, Vec2 { x: sub_i(i_28.x, splat_i(1i32)), y: sub_i(i_28.y, splat_i(0i32)) }, level_a2);
    let e_37 = height_cell_ls(r, ex, e_36, level_a2);
    let e_38 = part_v0;
    let e_39 = cell_slopes(r, e_37, e_38);
    let e_45 = sloped_cell(r, Vec2 { x: add_i(i_28.x, splat_i(1i32)), y: add_i(i_28.y, splat_i(0i32)) }, level_a2);
    let e_46 = height_cell_ls(r, ex, e_45, level_a2);
    let e_47 = part_v0;
    let e_48 = cell_slopes(r, e_46, e_47);
    let e_54 = sloped_cell(r, Vec2 { x: sub_i(i_28.x, splat_i(0i32)), y: sub_i(i_28.y, splat_i(1i32)) }, level_a2);
    let e_55 = height_cell_ls(r, ex, e_54, level_a2);
    let e_56 = part_v0;
    let e_57 = cell_slopes(r, e_55, e_56);
    let e_63 = sloped_cell(r, Vec2 { x: add_i(i_28.x, splat_i(0i32)), y: add_i(i_28.y, splat_i(1i32)) }, level_a2);
    let e_64 = height_cell_ls(r, ex, e_63, level_a2);
    let e_65 = part_v0;
    let e_66 = cell_slopes(r, e_64, e_65);
    let rate_u_75 = div(mul(size_3.x, splat(r.surface_settings.scale_m)), sqrt(add(add(mul(at_a0.tangent.x, at_a0.tangent.x), mul(at_a0.tangent.y, at_a0.tangent.y)), mul(at_a0.tangent.z, at_a0.tangent.z))));
    let rate_v_83 = div(mul(size_3.y, splat(r.surface_settings.scale_m)), sqrt(add(add(mul(at_a0.bitangent.x, at_a0.bitangent.x), mul(at_a0.bitangent.y, at_a0.bitangent.y)), mul(at_a0.bitangent.z, at_a0.bitangent.z))));
    let e_85 = slope_beside(r, ex, own_31.x, e_39.x, rate_u_75);
    let e_87 = slope_beside(r, ex, own_31.y, e_57.y, rate_v_83);
    let before_88 = Vec2 { x: e_85, y: e_87 };
    let e_90 = slope_beside(r, ex, own_31.x, e_48.x, rate_u_75);
    let e_92 = slope_beside(r, ex, own_31.y, e_66.y, rate_v_83);
    let behind_93 = Vec2 { x: e_90, y: e_92 };
    let e_96 = part_v0;
    return Vec2 { x: mul(splat(0.5f32), add(add(own_31.x, before_88.x), mul(sub(behind_93.x, before_88.x), e_96.x))), y: mul(splat(0.5f32), add(add(own_31.y, before_88.y), mul(sub(behind_93.y, before_88.y), e_96.y))) };
} }
lanes! { fn normal_of_slopes(r: &Resources<'_>, at_a0: &Entered, slope_u_a1: F, slope_v_a2: F) -> Vec3<F> {
    let along_u_6 = Vec3 { x: add(at_a0.tangent.x, mul(at_a0.normal.x, slope_u_a1)), y: add(at_a0.tangent.y, mul(at_a0.normal.y, slope_u_a1)), z: add(at_a0.tangent.z, mul(at_a0.normal.z, slope_u_a1)) };
    let along_v_10 = Vec3 { x: add(at_a0.bitangent.x, mul(at_a0.normal.x, slope_v_a2)), y: add(at_a0.bitangent.y, mul(at_a0.normal.y, slope_v_a2)), z: add(at_a0.bitangent.z, mul(at_a0.normal.z, slope_v_a2)) };
    let e_11 = Vec3 { x: sub(mul(along_v_10.y, along_u_6.z), mul(along_v_10.z, along_u_6.y)), y: sub(mul(along_v_10.z, along_u_6.x), mul(along_v_10.x, along_u_6.z)), z: sub(mul(along_v_10.x, along_u_6.y), mul(along_v_10.y, along_u_6.x)) };
    let length1 = sqrt(add(add(mul(e_11.x, e_11.x), mul(e_11.y, e_11.y)), mul(e_11.z, e_11.z)));
    let across_12 = Vec3 { x: div(e_11.x, length1), y: div(e_11.y, length1), z: div(e_11.z, length1) };
    let e_19 = sel(ge(add(add(add(mul(across_12.x, at_a0.normal.x), mul(across_12.y, at_a0.normal.y)), mul(across_12.z, at_a0.normal.z)), splat(0.0f32)), splat(0.0f32)), splat(1.0f32), splat((-1.0f32)));
    return Vec3 { x: mul(across_12.x, e_19), y: mul(across_12.y, e_19), z: mul(across_12.z, e_19) };
} }
lanes! { fn texels_apart(r: &Resources<'_>, place_a0: F, side_a1: F) -> F {
    if (r.surface_settings.wrap != 1u32) {
        return splat(2.0f32);
    }
    return max_with(sub(sub(splat(2.0f32), max_with(sub(splat(1.5f32), place_a0), splat(0.0f32))), max_with(sub(add(place_a0, splat(1.5f32)), side_a1), splat(0.0f32))), splat(0.5f32));
} }
lanes! { fn normal_from_height(r: &Resources<'_>, within: M, at_a0: &Entered, uv_a1: Vec2<F>, level_a2: u32) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let size_3 = height_size(r, splat_u(level_a2));
    if (r.surface_settings.has_creases == 1u32) {
        let e_9 = slopes_between_creases(r, ex, at_a0, uv_a1, level_a2);
        let slopes_14 = Vec2 { x: mul(mul(e_9.x, size_3.x), splat(r.surface_settings.scale_m)), y: mul(mul(e_9.y, size_3.y), splat(r.surface_settings.scale_m)) };
        let e_17 = normal_of_slopes(r, at_a0, slopes_14.x, slopes_14.y);
        return e_17;
    }
    let du_22 = Vec2 { x: div(splat(1.0f32), size_3.x), y: splat(0.0f32) };
    let dv_27 = Vec2 { x: splat(0.0f32), y: div(splat(1.0f32), size_3.y) };
    let e_29 = height_at_ls(r, ex, Vec2 { x: add(uv_a1.x, du_22.x), y: add(uv_a1.y, du_22.y) }, level_a2);
    let e_31 = height_at_ls(r, ex, Vec2 { x: sub(uv_a1.x, du_22.x), y: sub(uv_a1.y, du_22.y) }, level_a2);
    let rise_u_32 = sub(e_29, e_31);
    let e_34 = height_at_ls(r, ex, Vec2 { x: add(uv_a1.x, dv_27.x), y: add(uv_a1.y, dv_27.y) }, level_a2);
    let e_36 = height_at_ls(r, ex, Vec2 { x: sub(uv_a1.x, dv_27.x), y: sub(uv_a1.y, dv_27.y) }, level_a2);
    let rise_v_37 = sub(e_34, e_36);
    let e_42 = texels_apart(r, mul(uv_a1.x, size_3.x), size_3.x);
    let rate_u_44 = div(splat(1.0f32), e_42);
    let e_49 = texels_apart(r, mul(uv_a1.y, size_3.y), size_3.y);
    let rate_v_51 = div(splat(1.0f32), e_49);
    let slope_u_58 = mul(rise_u_32, mul(mul(rate_u_44, size_3.x), splat(r.surface_settings.scale_m)));
    let slope_v_65 = mul(rise_v_37, mul(mul(rate_v_51, size_3.y), splat(r.surface_settings.scale_m)));
    let e_66 = normal_of_slopes(r, at_a0, slope_u_58, slope_v_65);
    return e_66;
} }
lanes! { fn finest_normal(r: &Resources<'_>, within: M, at_a0: &Entered, uv_a1: Vec2<F>) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    if (r.surface_settings.has_normal == 1u32) {
        let e_8 = normal_at(r, ex, uv_a1, 0u32);
        let e_10 = from_tangent_space(r, at_a0, Vec3 { x: e_8.x, y: e_8.y, z: e_8.z });
        let length1 = sqrt(add(add(mul(e_10.x, e_10.x), mul(e_10.y, e_10.y)), mul(e_10.z, e_10.z)));
        let e_11 = Vec3 { x: div(e_10.x, length1), y: div(e_10.y, length1), z: div(e_10.z, length1) };
        return e_11;
    }
    let e_13 = normal_from_height(r, ex, at_a0, uv_a1, 0u32);
    return e_13;
} }
lanes! { fn means_of_one(r: &Resources<'_>, n_a0: Vec3<F>) -> Normals {
    let upright_3 = max_with(n_a0.z, splat(0.05f32));
    let slope_10 = Vec2 { x: div(neg(n_a0.x), upright_3), y: div(neg(n_a0.y), upright_3) };
    let square_12 = Vec2 { x: mul(mul(slope_10.x, slope_10.x), upright_3), y: mul(mul(slope_10.y, slope_10.y), upright_3) };
    return Normals { first: Vec4 { x: n_a0.x, y: n_a0.y, z: n_a0.z, w: slope_10.x }, second: Vec4 { x: square_12.x, y: mul(mul(slope_10.x, slope_10.y), upright_3), z: square_12.y, w: slope_10.y }, };
} }
lanes! { fn to_tangent_space(r: &Resources<'_>, at_a0: &Entered, v_a1: Vec3<F>) -> Vec3<F> {
    let length1 = sqrt(add(add(mul(at_a0.tangent.x, at_a0.tangent.x), mul(at_a0.tangent.y, at_a0.tangent.y)), mul(at_a0.tangent.z, at_a0.tangent.z)));
    let along_u_3 = Vec3 { x: div(at_a0.tangent.x, length1), y: div(at_a0.tangent.y, length1), z: div(at_a0.tangent.z, length1) };
    let length2 = sqrt(add(add(mul(at_a0.bitangent.x, at_a0.bitangent.x), mul(at_a0.bitangent.y, at_a0.bitangent.y)), mul(at_a0.bitangent.z, at_a0.bitangent.z)));
    let along_v_5 = Vec3 { x: div(at_a0.bitangent.x, length2), y: div(at_a0.bitangent.y, length2), z: div(at_a0.bitangent.z, length2) };
    return Vec3 { x: add(add(add(mul(along_u_3.x, v_a1.x), mul(along_u_3.y, v_a1.y)), mul(along_u_3.z, v_a1.z)), splat(0.0f32)), y: neg(add(add(add(mul(along_v_5.x, v_a1.x), mul(along_v_5.y, v_a1.y)), mul(along_v_5.z, v_a1.z)), splat(0.0f32))), z: add(add(add(mul(at_a0.normal.x, v_a1.x), mul(at_a0.normal.y, v_a1.y)), mul(at_a0.normal.z, v_a1.z)), splat(0.0f32)) };
} }
lanes! { fn normal_layers(r: &Resources<'_>, within: M, uv_a0: Vec2<F>, level_a1: U) -> NormalLayers {
    let mut ex = within;
    let mut ret: NormalLayers = zero_normal_layers();
    let e_5 = level_texels(r, r.surface_settings.normal_size, level_a1);
    let at_6 = texels_around(r, ex, uv_a0, e_5);
    let e_8 = normal_between_lsl(r, ex, &at_6, 0i32, level_a1);
    let e_10 = normal_between_lsl(r, ex, &at_6, 1i32, level_a1);
    return NormalLayers { first: e_8, second: e_10, };
} }
lanes! { fn normals_of_level(r: &Resources<'_>, within: M, at_a0: &Entered, uv_a1: Vec2<F>, level_a2: U) -> Normals {
    let mut ex = within;
    let mut ret: Normals = zero_normals();
    let has_normal_7 = (r.surface_settings.has_normal == 1u32);
    let read_11 = normal_layers(r, ex, uv_a1, sel_u(splat_m(has_normal_7), level_a2, sub_u(level_a2, splat_u(1u32))));
    if has_normal_7 {
        return Normals { first: Vec4 { x: read_11.first.x, y: read_11.first.y, z: read_11.first.z, w: read_11.first.w }, second: Vec4 { x: read_11.second.x, y: read_11.second.y, z: read_11.second.z, w: read_11.second.w }, };
    }
    let length1 = sqrt(add(add(mul(at_a0.tangent.x, at_a0.tangent.x), mul(at_a0.tangent.y, at_a0.tangent.y)), mul(at_a0.tangent.z, at_a0.tangent.z)));
    let e_20 = Vec3 { x: div(at_a0.tangent.x, length1), y: div(at_a0.tangent.y, length1), z: div(at_a0.tangent.z, length1) };
    let x_27 = div(mul(splat(r.surface_settings.normal_tile_m.x), add(add(add(mul(e_20.x, at_a0.tangent.x), mul(e_20.y, at_a0.tangent.y)), mul(e_20.z, at_a0.tangent.z)), splat(0.0f32))), add(add(add(mul(at_a0.tangent.x, at_a0.tangent.x), mul(at_a0.tangent.y, at_a0.tangent.y)), mul(at_a0.tangent.z, at_a0.tangent.z)), splat(0.0f32)));
    let length2 = sqrt(add(add(mul(at_a0.bitangent.x, at_a0.bitangent.x), mul(at_a0.bitangent.y, at_a0.bitangent.y)), mul(at_a0.bitangent.z, at_a0.bitangent.z)));
    let e_30 = Vec3 { x: div(at_a0.bitangent.x, length2), y: div(at_a0.bitangent.y, length2), z: div(at_a0.bitangent.z, length2) };
    let y_37 = div(mul(splat(r.surface_settings.normal_tile_m.y), add(add(add(mul(e_30.x, at_a0.bitangent.x), mul(e_30.y, at_a0.bitangent.y)), mul(e_30.z, at_a0.bitangent.z)), splat(0.0f32))), add(add(add(mul(at_a0.bitangent.x, at_a0.bitangent.x), mul(at_a0.bitangent.y, at_a0.bitangent.y)), mul(at_a0.bitangent.z, at_a0.bitangent.z)), splat(0.0f32)));
    let flatter_45 = Vec3 { x: mul(read_11.first.x, x_27), y: mul(read_11.first.y, y_37), z: read_11.first.z };
    let longer_51 = sqrt(div(add(add(add(mul(read_11.first.x, read_11.first.x), mul(read_11.first.y, read_11.first.y)), mul(read_11.first.z, read_11.first.z)), splat(0.0f32)), add(add(add(mul(flatter_45.x, flatter_45.x), mul(flatter_45.y, flatter_45.y)), mul(flatter_45.z, flatter_45.z)), splat(0.0f32))));
    let squares_62 = Vec3 { x: mul(mul(mul(read_11.second.x, x_27), x_27), longer_51), y: mul(mul(mul(read_11.second.y, x_27), y_37), longer_51), z: mul(mul(mul(read_11.second.z, y_37), y_37), longer_51) };
    return Normals { first: Vec4 { x: mul(flatter_45.x, longer_51), y: mul(flatter_45.y, longer_51), z: mul(flatter_45.z, longer_51), w: mul(read_11.first.w, x_27) }, second: Vec4 { x: squares_62.x, y: squares_62.y, z: squares_62.z, w: mul(read_11.second.w, y_37) }, };
} }
lanes! { fn mean_of_five(r: &Resources<'_>, middle_a0: F, four_a1: F) -> F {
    return add(mul(middle_a0, splat(0.33333334f32)), mul(four_a1, splat(0.16666667f32)));
} }
lanes! { fn sum_of_four(r: &Resources<'_>, four_a0: Vec4<F>) -> F {
    return add(add(four_a0.x, four_a0.y), add(four_a0.z, four_a0.w));
} }
lanes! { fn seen_normals(r: &Resources<'_>, at_a0: &Entered, normals_a1: &Normals, view_a2: Vec3<F>) -> SeenNormals {
    let slope_7 = Vec2 { x: normals_a1.first.w, y: normals_a1.second.w };
    let upright_10 = max_with(normals_a1.first.z, splat(0.05f32));
    let x_12 = div(normals_a1.first.x, upright_10);
    let y_14 = div(normals_a1.first.y, upright_10);
    let a_23 = max_with(sqrt(max_with(sub(div(normals_a1.second.x, upright_10), mul(x_12, x_12)), splat(0.0f32))), splat(0.0001f32));
    let b_28 = div(sub(div(normals_a1.second.y, upright_10), mul(x_12, y_14)), a_23);
    let spread_34 = max_with(sub(div(normals_a1.second.z, upright_10), mul(y_14, y_14)), splat(0.0f32));
    let d_41 = max_with(sqrt(max_with(sub(spread_34, mul(b_28, b_28)), splat(0.0f32))), splat(0.0001f32));
    let with_x_50 = Vec3 { x: sub(neg(normals_a1.second.x), mul(normals_a1.first.x, slope_7.x)), y: sub(neg(normals_a1.second.y), mul(normals_a1.first.y, slope_7.x)), z: sub(neg(normals_a1.first.x), mul(normals_a1.first.z, slope_7.x)) };
    let with_y_59 = Vec3 { x: sub(neg(normals_a1.second.y), mul(normals_a1.first.x, slope_7.y)), y: sub(neg(normals_a1.second.z), mul(normals_a1.first.y, slope_7.y)), z: sub(neg(normals_a1.first.y), mul(normals_a1.first.z, slope_7.y)) };
    let most_64 = min_with(sqrt(add(mul(a_23, a_23), spread_34)), splat(1.0f32));
    let e_67 = max(a_23, div(sqrt(add(add(mul(with_x_50.x, with_x_50.x), mul(with_x_50.y, with_x_50.y)), mul(with_x_50.z, with_x_50.z))), most_64));
    let along_69 = Vec3 { x: div(with_x_50.x, e_67), y: div(with_x_50.y, e_67), z: div(with_x_50.z, e_67) };
    let rest_71 = Vec3 { x: sub(with_y_59.x, mul(along_69.x, b_28)), y: sub(with_y_59.y, mul(along_69.y, b_28)), z: sub(with_y_59.z, mul(along_69.z, b_28)) };
    let e_74 = max(d_41, div(sqrt(add(add(mul(rest_71.x, rest_71.x), mul(rest_71.y, rest_71.y)), mul(rest_71.z, rest_71.z))), most_64));
    let across_76 = Vec3 { x: div(rest_71.x, e_74), y: div(rest_71.y, e_74), z: div(rest_71.z, e_74) };
    let v_77 = to_tangent_space(r, at_a0, view_a2);
    let middle_81 = sub(v_77.z, add(add(mul(v_77.x, slope_7.x), mul(v_77.y, slope_7.y)), splat(0.0f32)));
    let four_91 = facing_four(r, middle_81, neg(add(mul(v_77.x, a_23), mul(v_77.y, b_28))), neg(mul(v_77.y, d_41)));
    let one_93 = max_with(middle_81, splat(0.0f32));
    let e_94 = sum_of_four(r, four_91);
    let e_95 = mean_of_five(r, one_93, e_94);
    let all_97 = max_with(e_95, splat(0.001f32));
    let e_101 = div(sub(four_91.x, four_91.y), all_97);
    let e_106 = div(sub(four_91.z, four_91.w), all_97);
    let aside_108 = Vec3 { x: add(mul(along_69.x, e_101), mul(across_76.x, e_106)), y: add(mul(along_69.y, e_101), mul(across_76.y, e_106)), z: add(mul(along_69.z, e_101), mul(across_76.z, e_106)) };
    let mean_113 = from_tangent_space(r, at_a0, Vec3 { x: add(normals_a1.first.x, mul(aside_108.x, splat(0.28867513f32))), y: add(normals_a1.first.y, mul(aside_108.y, splat(0.28867513f32))), z: add(normals_a1.first.z, mul(aside_108.z, splat(0.28867513f32))) });
    let length1 = sqrt(add(add(mul(mean_113.x, mean_113.x), mul(mean_113.y, mean_113.y)), mul(mean_113.z, mean_113.z)));
    let e_114 = Vec3 { x: div(mean_113.x, length1), y: div(mean_113.y, length1), z: div(mean_113.z, length1) };
    let e_133 = no_table(r);
    return SeenNormals { normal: e_114, length: min_with(sqrt(add(add(mul(mean_113.x, mean_113.x), mul(mean_113.y, mean_113.y)), mul(mean_113.z, mean_113.z))), splat(1.0f32)), differ: splat_u(1u32), middle: Vec3 { x: normals_a1.first.x, y: normals_a1.first.y, z: normals_a1.first.z }, along: along_69, across: across_76, slope: slope_7, slope_along: Vec2 { x: a_23, y: b_28 }, slope_across: Vec2 { x: splat(0.0f32), y: d_41 }, upright: mul(max_with(v_77.z, splat(0.0f32)), max_with(v_77.z, splat(0.0f32))), middle_seen: div(one_93, all_97), others_seen: Vec4 { x: div(four_91.x, all_97), y: div(four_91.y, all_97), z: div(four_91.z, all_97), w: div(four_91.w, all_97) }, table_part: splat(0.0f32), table: e_133, };
} }
lanes! { fn table_part(r: &Resources<'_>, at_a0: &Entered) -> F {
    if (r.surface_settings.has_normal == 1u32) {
        return splat(0.0f32);
    }
    return mul(at_a0.fade, min_with(max_with(sub(mul(at_a0.footprint, splat(0.25f32)), splat(1.0f32)), splat(0.0f32)), splat(1.0f32)));
} }
lanes! { fn has_table(r: &Resources<'_>, levels_a0: &Levels) -> M {
    return ge_u(levels_a0.fine, splat_u(r.surface_settings.maps[0].first_level));
} }
lanes! { fn with_table(r: &Resources<'_>, at_a0: &Entered, seen_a1: &SeenNormals, table_a2: &SeenTable, part_a3: F) -> SeenNormals {
    let mut blended_v0: SeenNormals = zero_seen_normals();
    blended_v0 = *seen_a1;
    let before_7 = Vec3 { x: mul(seen_a1.normal.x, seen_a1.length), y: mul(seen_a1.normal.y, seen_a1.length), z: mul(seen_a1.normal.z, seen_a1.length) };
    let e_9 = from_tangent_space(r, at_a0, Vec3 { x: table_a2.mean.x, y: table_a2.mean.y, z: table_a2.mean.z });
    let mean_12 = Vec3 { x: add(before_7.x, mul(sub(e_9.x, before_7.x), part_a3)), y: add(before_7.y, mul(sub(e_9.y, before_7.y), part_a3)), z: add(before_7.z, mul(sub(e_9.z, before_7.z), part_a3)) };
    let length1 = sqrt(add(add(mul(mean_12.x, mean_12.x), mul(mean_12.y, mean_12.y)), mul(mean_12.z, mean_12.z)));
    let e_14 = Vec3 { x: div(mean_12.x, length1), y: div(mean_12.y, length1), z: div(mean_12.z, length1) };
    blended_v0.normal = e_14;
    blended_v0.length = min_with(sqrt(add(add(mul(mean_12.x, mean_12.x), mul(mean_12.y, mean_12.y)), mul(mean_12.z, mean_12.z))), splat(1.0f32));
    blended_v0.table_part = part_a3;
    blended_v0.table = *table_a2;
    let e_21 = blended_v0;
    return e_21;
} }
lanes! { fn seen_between(r: &Resources<'_>, a_a0: &SeenTexel, b_a1: &SeenTexel, part_a2: F) -> SeenTexel {
    return SeenTexel { first: Vec4 { x: add(a_a0.first.x, mul(sub(b_a1.first.x, a_a0.first.x), part_a2)), y: add(a_a0.first.y, mul(sub(b_a1.first.y, a_a0.first.y), part_a2)), z: add(a_a0.first.z, mul(sub(b_a1.first.z, a_a0.first.z), part_a2)), w: add(a_a0.first.w, mul(sub(b_a1.first.w, a_a0.first.w), part_a2)) }, second: Vec4 { x: add(a_a0.second.x, mul(sub(b_a1.second.x, a_a0.second.x), part_a2)), y: add(a_a0.second.y, mul(sub(b_a1.second.y, a_a0.second.y), part_a2)), z: add(a_a0.second.z, mul(sub(b_a1.second.z, a_a0.second.z), part_a2)), w: add(a_a0.second.w, mul(sub(b_a1.second.w, a_a0.second.w), part_a2)) }, };
} }
lanes! { fn seen_texel(r: &Resources<'_>, within: M, at_a0: &Around, azimuth_a1: I, elevation_a2: I, level_a3: U) -> SeenTexel {
    let mut ex = within;
    let mut ret: SeenTexel = zero_seen_texel();
    let layer_8 = mul_i(splat_i(2i32), add_i(mul_i(azimuth_a1, splat_i(4i32)), elevation_a2));
    let e_9 = detail_texel_between(r, ex, at_a0, layer_8, level_a3);
    let e_12 = detail_texel_between(r, ex, at_a0, add_i(layer_8, splat_i(1i32)), level_a3);
    return SeenTexel { first: e_9, second: e_12, };
} }
lanes! { fn seen_in_levels(r: &Resources<'_>, within: M, at_a0: &SeenPlace, azimuth_a1: I, elevation_a2: I) -> SeenTexel {
    let mut ex = within;
    let mut ret: SeenTexel = zero_seen_texel();
    let fine_6 = seen_texel(r, ex, &at_a0.fine, azimuth_a1, elevation_a2, at_a0.levels.fine);
    let (b1, c2) = (ex, gt(at_a0.levels.part, splat(0.0f32)));
    ex = and(b1, c2);
    if any(ex) {
        let e_16 = seen_texel(r, ex, &at_a0.coarse, azimuth_a1, elevation_a2, add_u(at_a0.levels.fine, splat_u(1u32)));
        let e_19 = seen_between(r, &fine_6, &e_16, at_a0.levels.part);
        ret = e_19;
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    return sel_seen_texel(ex, &fine_6, &ret);
} }
lanes! { fn table_of(r: &Resources<'_>, within: M, at_a0: &Entered, uv_a1: Vec2<F>, view_a2: Vec3<F>, levels_a3: &Levels) -> SeenTable {
    let mut ex = within;
    let mut ret: SeenTable = zero_seen_table();
    let change_4 = climb(r, at_a0, view_a2);
    let toward_17 = Vec3 { x: mul(change_4.x, splat(r.surface_settings.maps[0].tile_m.x)), y: mul(change_4.y, splat(r.surface_settings.maps[0].tile_m.y)), z: mul(change_4.z, splat(r.surface_settings.scale_m)) };
    let up_20 = div(toward_17.z, sqrt(add(add(mul(toward_17.x, toward_17.x), mul(toward_17.y, toward_17.y)), mul(toward_17.z, toward_17.z))));
    let elevation_27 = min_with(max_with(sub(mul(up_20, splat(4.0f32)), splat(1.0f32)), splat(0.0f32)), splat(3.0f32));
    let e_29 = turn_of(r, ex, Vec2 { x: toward_17.x, y: toward_17.y });
    let azimuth_31 = mul(e_29, splat(8.0f32));
    let a0_35 = rem_i(i_of_f(floor(azimuth_31)), splat_i(8i32));
    let a1_39 = rem_i(add_i(a0_35, splat_i(1i32)), splat_i(8i32));
    let e0_41 = i_of_f(floor(elevation_27));
    let e1_45 = min_i(add_i(e0_41, splat_i(1i32)), splat_i(3i32));
    let across_47 = sub(azimuth_31, floor(azimuth_31));
    let e_49 = height_texels(r, levels_a3.fine);
    let e_50 = texels_around(r, ex, uv_a1, e_49);
    let e_54 = height_texels(r, add_u(levels_a3.fine, splat_u(1u32)));
    let e_55 = texels_around(r, ex, uv_a1, e_54);
    let place_56 = SeenPlace { fine: e_50, coarse: e_55, levels: *levels_a3, };
    let e_57 = seen_in_levels(r, ex, &place_56, a0_35, e0_41);
    let e_58 = seen_in_levels(r, ex, &place_56, a1_39, e0_41);
    let low_59 = seen_between(r, &e_57, &e_58, across_47);
    let e_60 = seen_in_levels(r, ex, &place_56, a0_35, e1_45);
    let e_61 = seen_in_levels(r, ex, &place_56, a1_39, e1_45);
    let high_62 = seen_between(r, &e_60, &e_61, across_47);
    let seen_65 = seen_between(r, &low_59, &high_62, sub(elevation_27, floor(elevation_27)));
    let length1 = sqrt(add(add(mul(at_a0.tangent.x, at_a0.tangent.x), mul(at_a0.tangent.y, at_a0.tangent.y)), mul(at_a0.tangent.z, at_a0.tangent.z)));
    let e_68 = Vec3 { x: div(at_a0.tangent.x, length1), y: div(at_a0.tangent.y, length1), z: div(at_a0.tangent.z, length1) };
    let x_75 = div(mul(splat(r.surface_settings.maps[0].tile_m.x), add(add(add(mul(e_68.x, at_a0.tangent.x), mul(e_68.y, at_a0.tangent.y)), mul(e_68.z, at_a0.tangent.z)), splat(0.0f32))), add(add(add(mul(at_a0.tangent.x, at_a0.tangent.x), mul(at_a0.tangent.y, at_a0.tangent.y)), mul(at_a0.tangent.z, at_a0.tangent.z)), splat(0.0f32)));
    let length2 = sqrt(add(add(mul(at_a0.bitangent.x, at_a0.bitangent.x), mul(at_a0.bitangent.y, at_a0.bitangent.y)), mul(at_a0.bitangent.z, at_a0.bitangent.z)));
    let e_78 = Vec3 { x: div(at_a0.bitangent.x, length2), y: div(at_a0.bitangent.y, length2), z: div(at_a0.bitangent.z, length2) };
    let y_85 = div(mul(splat(r.surface_settings.maps[0].tile_m.y), add(add(add(mul(e_78.x, at_a0.bitangent.x), mul(e_78.y, at_a0.bitangent.y)), mul(e_78.z, at_a0.bitangent.z)), splat(0.0f32))), add(add(add(mul(at_a0.bitangent.x, at_a0.bitangent.x), mul(at_a0.bitangent.y, at_a0.bitangent.y)), mul(at_a0.bitangent.z, at_a0.bitangent.z)), splat(0.0f32)));
    let flatter_93 = Vec3 { x: mul(seen_65.first.x, x_75), y: mul(seen_65.first.y, y_85), z: seen_65.first.z };
    let squared_96 = div(add(add(add(mul(seen_65.first.x, seen_65.first.x), mul(seen_65.first.y, seen_65.first.y)), mul(seen_65.first.z, seen_65.first.z)), splat(0.0f32)), add(add(add(mul(flatter_93.x, flatter_93.x), mul(flatter_93.y, flatter_93.y)), mul(flatter_93.z, flatter_93.z)), splat(0.0f32)));
    let upright_105 = max_with(sub(sub(splat(1.0f32), seen_65.first.w), seen_65.second.y), splat(0.0f32));
    let e_106 = sqrt(squared_96);
    return SeenTable { mean: Vec3 { x: mul(flatter_93.x, e_106), y: mul(flatter_93.y, e_106), z: mul(flatter_93.z, e_106) }, squares: Vec3 { x: mul(mul(mul(seen_65.first.w, x_75), x_75), squared_96), y: mul(mul(mul(seen_65.second.y, y_85), y_85), squared_96), z: mul(upright_105, squared_96) }, products: Vec3 { x: mul(mul(mul(seen_65.second.x, x_75), y_85), squared_96), y: mul(mul(seen_65.second.z, x_75), squared_96), z: mul(mul(seen_65.second.w, y_85), squared_96) }, };
} }
lanes! { fn mesostructure_normals(r: &Resources<'_>, within: M, at_a0: &Entered, uv_a1: Vec2<F>, view_a2: Vec3<F>) -> SeenNormals {
    let mut ex = within;
    let mut ret: SeenNormals = zero_seen_normals();
    let mut first_v0: Vec4<F> = Vec4 { x: splat(0.0f32), y: splat(0.0f32), z: splat(0.0f32), w: splat(0.0f32) };
    let mut second_v1: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    if (r.surface_settings.has_vertex_normals == 1u32) {
        let e_9 = one_seen(r, Vec3 { x: at_a0.normal.x, y: at_a0.normal.y, z: at_a0.normal.z });
        return e_9;
    }
    let upright_11 = add(add(add(mul(at_a0.normal.x, view_a2.x), mul(at_a0.normal.y, view_a2.y)), mul(at_a0.normal.z, view_a2.z)), splat(0.0f32));
    let shown_13 = max_with(upright_11, splat(0.5f32));
    let width_18 = add(shown_13, mul(sub(splat(1.0f32), shown_13), at_a0.fade));
    let texels_24 = mul(mul(at_a0.footprint, splat(r.surface_settings.normal_texels)), width_18);
    let levels_28 = levels_of(r, ex, texels_24, r.surface_settings.normal_levels);
    let e_35 = first_v0;
    second_v1 = e_35;
    let (b1, c2) = (ex, eq_u(levels_28.fine, splat_u(0u32)));
    ex = and(b1, c2);
    if any(ex) {
        let normal_40 = finest_normal(r, ex, at_a0, uv_a1);
        let (b3, c4) = (ex, not(gt(levels_28.part, splat(0.0f32))));
        ex = and(b3, c4);
        if any(ex) {
            let e_45 = one_seen(r, normal_40);
            ret = e_45;
            ex = no_lane();
        }
        ex = and_not(b3, c4);
        let e_46 = to_tangent_space(r, at_a0, normal_40);
        let fine_47 = means_of_one(r, e_46);
        let (m5, y6) = (ex, Vec4 { x: fine_47.first.x, y: fine_47.first.y, z: fine_47.first.z, w: fine_47.first.w });
        first_v0 = Vec4 { x: sel(m5, y6.x, first_v0.x), y: sel(m5, y6.y, first_v0.y), z: sel(m5, y6.z, first_v0.z), w: sel(m5, y6.w, first_v0.w) };
        let (m7, y8) = (ex, Vec4 { x: fine_47.second.x, y: fine_47.second.y, z: fine_47.second.z, w: fine_47.second.w });
        second_v1 = Vec4 { x: sel(m7, y8.x, second_v1.x), y: sel(m7, y8.y, second_v1.y), z: sel(m7, y8.z, second_v1.z), w: sel(m7, y8.w, second_v1.w) };
    }
    let x9 = ex;
    ex = and_not(b1, c2);
    if any(ex) {
        let fine_51 = normals_of_level(r, ex, at_a0, uv_a1, levels_28.fine);
        let (m10, y11) = (ex, Vec4 { x: fine_51.first.x, y: fine_51.first.y, z: fine_51.first.z, w: fine_51.first.w });
        first_v0 = Vec4 { x: sel(m10, y11.x, first_v0.x), y: sel(m10, y11.y, first_v0.y), z: sel(m10, y11.z, first_v0.z), w: sel(m10, y11.w, first_v0.w) };
        let (m12, y13) = (ex, Vec4 { x: fine_51.second.x, y: fine_51.second.y, z: fine_51.second.z, w: fine_51.second.w });
        second_v1 = Vec4 { x: sel(m12, y13.x, second_v1.x), y: sel(m12, y13.y, second_v1.y), z: sel(m12, y13.z, second_v1.z), w: sel(m12, y13.w, second_v1.w) };
    }
    ex = or(ex, x9);
    if none(ex) { return ret; }
    let (b14, c15) = (ex, gt(levels_28.part, splat(0.0f32)));
    ex = and(b14, c15);
    if any(ex) {
        let coarse_60 = normals_of_level(r, ex, at_a0, uv_a1, add_u(levels_28.fine, splat_u(1u32)));
        let e_61 = first_v0;
        let e_63 = first_v0;
        let (m16, y17) = (ex, Vec4 { x: add(e_61.x, mul(sub(coarse_60.first.x, e_63.x), levels_28.part)), y: add(e_61.y, mul(sub(coarse_60.first.y, e_63.y), levels_28.part)), z: add(e_61.z, mul(sub(coarse_60.first.z, e_63.z), levels_28.part)), w: add(e_61.w, mul(sub(coarse_60.first.w, e_63.w), levels_28.part)) });
        first_v0 = Vec4 { x: sel(m16, y17.x, first_v0.x), y: sel(m16, y17.y, first_v0.y), z: sel(m16, y17.z, first_v0.z), w: sel(m16, y17.w, first_v0.w) };
        let e_68 = second_v1;
        let e_70 = second_v1;
        let (m18, y19) = (ex, Vec4 { x: add(e_68.x, mul(sub(coarse_60.second.x, e_70.x), levels_28.part)), y: add(e_68.y, mul(sub(coarse_60.second.y, e_70.y), levels_28.part)), z: add(e_68.z, mul(sub(coarse_60.second.z, e_70.z), levels_28.part)), w: add(e_68.w, mul(sub(coarse_60.second.w, e_70.w), levels_28.part)) });
        second_v1 = Vec4 { x: sel(m18, y19.x, second_v1.x), y: sel(m18, y19.y, second_v1.y), z: sel(m18, y19.z, second_v1.z), w: sel(m18, y19.w, second_v1.w) };
    }
    ex = b14;
    let e_75 = first_v0;
    let e_76 = second_v1;
    let seen_78 = seen_normals(r, at_a0, &Normals { first: e_75, second: e_76, }, view_a2);
    let part_79 = table_part(r, at_a0);
    let (b20, c21) = (ex, gt(part_79, splat(0.0f32)));
    ex = and(b20, c21);
    if any(ex) {
        let of_table_86 = levels_of(r, ex, at_a0.footprint, r.surface_settings.height_levels);
        let e_87 = has_table(r, &of_table_86);
        let (b22, c23) = (ex, e_87);
        ex = and(b22, c23);
        if any(ex) {
            let e_88 = table_of(r, ex, at_a0, uv_a1, view_a2, &of_table_86);
            let e_89 = with_table(r, at_a0, &seen_78, &e_88, part_79);
            ret = sel_seen_normals(ex, &e_89, &ret);
            ex = no_lane();
        }
        ex = and_not(b22, c23);
    }
    let x24 = ex;
    ex = and_not(b20, c21);
    ex = or(ex, x24);
    return sel_seen_normals(ex, &seen_78, &ret);
} }
lanes! { fn field_heights_normals(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, view_a2: Vec3<F>, params_a3: Vec4<f32>) -> SeenNormals {
    let mut ex = within;
    let mut ret: SeenNormals = zero_seen_normals();
    let e_5 = mesostructure_normals(r, ex, at_a0, Vec2 { x: hit_a1.uv.x, y: hit_a1.uv.y }, view_a2);
    return e_5;
} }
lanes! { fn field_slopes(r: &Resources<'_>, within: M, place_a0: Vec3<F>) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let i_4 = Vec3 { x: 0.5f32, y: 0.0f32, z: 0.0f32 };
    let j_8 = Vec3 { x: 0.0f32, y: 0.5f32, z: 0.0f32 };
    let k_12 = Vec3 { x: 0.0f32, y: 0.0f32, z: 0.5f32 };
    let e_14 = field_at_voxel(r, ex, Vec3 { x: add(place_a0.x, splat(i_4.x)), y: add(place_a0.y, splat(i_4.y)), z: add(place_a0.z, splat(i_4.z)) });
    let e_16 = field_at_voxel(r, ex, Vec3 { x: sub(place_a0.x, splat(i_4.x)), y: sub(place_a0.y, splat(i_4.y)), z: sub(place_a0.z, splat(i_4.z)) });
    let along_i_17 = sub(e_14, e_16);
    let e_19 = field_at_voxel(r, ex, Vec3 { x: add(place_a0.x, splat(j_8.x)), y: add(place_a0.y, splat(j_8.y)), z: add(place_a0.z, splat(j_8.z)) });
    let e_21 = field_at_voxel(r, ex, Vec3 { x: sub(place_a0.x, splat(j_8.x)), y: sub(place_a0.y, splat(j_8.y)), z: sub(place_a0.z, splat(j_8.z)) });
    let along_j_22 = sub(e_19, e_21);
    let e_24 = field_at_voxel(r, ex, Vec3 { x: add(place_a0.x, splat(k_12.x)), y: add(place_a0.y, splat(k_12.y)), z: add(place_a0.z, splat(k_12.z)) });
    let e_26 = field_at_voxel(r, ex, Vec3 { x: sub(place_a0.x, splat(k_12.x)), y: sub(place_a0.y, splat(k_12.y)), z: sub(place_a0.z, splat(k_12.z)) });
    let along_k_27 = sub(e_24, e_26);
    return Vec3 { x: div(along_i_17, splat(1.0f32)), y: div(along_j_22, splat(1.0f32)), z: div(along_k_27, splat(1.0f32)) };
} }
lanes! { fn light_ray_from(r: &Resources<'_>, within: M, at_a0: &Entered, begin_a1: Vec3<F>, change_a2: Vec3<F>, light_a3: &Toward) -> LightRay {
    let mut ex = within;
    let mut ret: LightRay = zero_light_ray();
    let h_7 = Vec3 { x: begin_a1.z, y: change_a2.z, z: splat(0.0f32) };
    let way_18 = Path { uv: Vec2 { x: begin_a1.x, y: begin_a1.y }, duv: Vec2 { x: change_a2.x, y: change_a2.y }, h: h_7, exit: splat(0.0f32), base: splat(0.0f32), metric: Vec4 { x: at_a0.metric.x, y: at_a0.metric.y, z: at_a0.metric.z, w: at_a0.metric.w }, ray: splat_u(1u32), level: at_a0.level, start: splat(0.0f32), share: splat(1.0f32), bend: splat(0.0f32), };
    let (b1, c2) = (ex, not(gt(change_a2.z, splat(0.0f32))));
    ex = and(b1, c2);
    if any(ex) {
        ret = LightRay { state: splat_u(1u32), path: way_18, };
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    if none(ex) { return ret; }
    let exit_25 = way_out(r, ex, &way_18, light_a3);
    let (b3, c4) = (ex, not(gt(exit_25, splat(0.0f32))));
    ex = and(b3, c4);
    if any(ex) {
        ret = sel_light_ray(ex, &LightRay { state: splat_u(0u32), path: way_18, }, &ret);
        ex = no_lane();
    }
    ex = and_not(b3, c4);
    let path_40 = Path { uv: Vec2 { x: begin_a1.x, y: begin_a1.y }, duv: Vec2 { x: change_a2.x, y: change_a2.y }, h: h_7, exit: exit_25, base: splat(0.0f32), metric: Vec4 { x: at_a0.metric.x, y: at_a0.metric.y, z: at_a0.metric.z, w: at_a0.metric.w }, ray: splat_u(1u32), level: at_a0.level, start: splat(0.0f32), share: splat(1.0f32), bend: splat(0.0f32), };
    return sel_light_ray(ex, &LightRay { state: splat_u(2u32), path: path_40, }, &ret);
} }
lanes! { fn light_ray_out_of_volume(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, light_a2: &Toward) -> LightRay {
    let mut ex = within;
    let mut ret: LightRay = zero_light_ray();
    let mut outside_v0: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let change_4 = climb(r, at_a0, Vec3 { x: light_a2.direction.x, y: light_a2.direction.y, z: light_a2.direction.z });
    let e_6 = near_uv(r, Vec2 { x: hit_a1.uv.x, y: hit_a1.uv.y });
    let place_9 = voxel_place(r, Vec3 { x: e_6.x, y: e_6.y, z: hit_a1.height });
    let slopes_10 = field_slopes(r, ex, place_9);
    let steepness_11 = sqrt(add(add(mul(slopes_10.x, slopes_10.x), mul(slopes_10.y, slopes_10.y)), mul(slopes_10.z, slopes_10.z)));
    outside_v0 = place_9;
    let c1 = gt(steepness_11, splat(0.0f32));
    let e_16 = div(splat(0.125f32), steepness_11);
    let (m2, y3) = (c1, Vec3 { x: sub(place_9.x, mul(slopes_10.x, e_16)), y: sub(place_9.y, mul(slopes_10.y, e_16)), z: sub(place_9.z, mul(slopes_10.z, e_16)) });
    outside_v0 = Vec3 { x: sel(m2, y3.x, outside_v0.x), y: sel(m2, y3.y, outside_v0.y), z: sel(m2, y3.z, outside_v0.z) };
    let e_19 = outside_v0;
    let e_25 = r.volume_size();
    let e_27 = light_ray_from(r, ex, at_a0, Vec3 { x: div(add(e_19.x, splat(0.5f32)), splat(e_25.x)), y: div(add(e_19.y, splat(0.5f32)), splat(e_25.y)), z: div(add(e_19.z, splat(0.5f32)), splat(e_25.z)) }, change_4, light_a2);
    return e_27;
} }
lanes! { fn field_volume_light_ray(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, light_a2: &Toward, params_a3: Vec4<f32>) -> LightRay {
    let mut ex = within;
    let mut ret: LightRay = zero_light_ray();
    let e_4 = light_ray_out_of_volume(r, ex, at_a0, hit_a1, light_a2);
    return e_4;
} }
lanes! { fn motif_texel_l(r: &Resources<'_>, place_a0: U) -> Vec4<F> {
    let row_2 = shr_u(place_a0, i_of_u(splat_u(10u32)));
    let e_9 = object_texel_l(r, Vec2 { x: i_of_u(sub_u(place_a0, mul_u(row_2, splat_u(1024u32)))), y: i_of_u(row_2) });
    return e_9;
} }
lanes! { fn motif_texel_s(r: &Resources<'_>, place_a0: u32) -> Vec4<F> {
    let row_2 = place_a0.unbounded_shr(10u32);
    let e_9 = object_texel_s(r, Vec2 { x: (place_a0.wrapping_sub(row_2.wrapping_mul(1024u32)) as i32), y: (row_2 as i32) });
    return e_9;
} }
stage! { fn nearest_of_leaf(r: &Resources<'_>, within: M, place_a0: Vec3<F>, leaf_a1: U, before_a2: &NearTriangle) -> NearTriangle {
    let mut ex = within;
    let mut ret: NearTriangle = zero_near_triangle();
    let mut nearest_v0: NearTriangle = zero_near_triangle();
    let mut triangle_v1: U = splat_u(0u32);
    nearest_v0 = *before_a2;
    triangle_v1 = leaf_a1;
    let b2 = ex;
    'l1: loop {
        let e_5 = triangle_v1;
        let c3 = ne_u(e_5, splat_u(0u32));
        ex = and(ex, c3);
        let e_8 = triangle_v1;
        if none(ex) { break 'l1; }
        let a_9 = motif_texel_l(r, e_8);
        let e_10 = triangle_v1;
        let b_13 = motif_texel_l(r, add_u(e_10, splat_u(1u32)));
        let e_14 = triangle_v1;
        let c_17 = motif_texel_l(r, add_u(e_14, splat_u(2u32)));
        let apart_21 = apart_from_triangle(r, ex, place_a0, Vec3 { x: a_9.x, y: a_9.y, z: a_9.z }, Vec3 { x: b_13.x, y: b_13.y, z: b_13.z }, Vec3 { x: c_17.x, y: c_17.y, z: c_17.z });
        let e_23 = nearest_v0.apart;
        let c4 = lt(apart_21, e_23);
        let e_25 = triangle_v1;
        nearest_v0 = sel_near_triangle(and(ex, c4), &NearTriangle { triangle: e_25, apart: apart_21, }, &nearest_v0);
        let e_27 = triangle_v1;
        triangle_v1 = sel_u(eq(a_9.w, splat(0.0f32)), splat_u(0u32), add_u(e_27, splat_u(3u32)));
    }
    ex = b2;
    let e_35 = nearest_v0;
    return e_35;
} }
lanes! { fn point_of_triangle(r: &Resources<'_>, within: M, triangle_a0: U, place_a1: Vec3<F>) -> MotifPoint {
    let mut ex = within;
    let mut ret: MotifPoint = zero_motif_point();
    let e_2 = motif_texel_l(r, triangle_a0);
    let e_6 = motif_texel_l(r, add_u(triangle_a0, splat_u(1u32)));
    let e_10 = motif_texel_l(r, add_u(triangle_a0, splat_u(2u32)));
    let e_13 = motif_texel_s(r, 0u32);
    let normals_16 = add_u(triangle_a0, u_of_f(e_13.x));
    let e_17 = weights_under(r, place_a1, Vec3 { x: e_2.x, y: e_2.y, z: e_2.z }, Vec3 { x: e_6.x, y: e_6.y, z: e_6.z }, Vec3 { x: e_10.x, y: e_10.y, z: e_10.z });
    let weights_22 = Vec3 { x: max_with(e_17.x, splat(0.0f32)), y: max_with(e_17.y, splat(0.0f32)), z: max_with(e_17.z, splat(0.0f32)) };
    let e_23 = motif_texel_l(r, normals_16);
    let first_26 = Vec3 { x: mul(e_23.x, weights_22.x), y: mul(e_23.y, weights_22.x), z: mul(e_23.z, weights_22.x) };
    let e_29 = motif_texel_l(r, add_u(normals_16, splat_u(1u32)));
    let second_32 = Vec3 { x: mul(e_29.x, weights_22.y), y: mul(e_29.y, weights_22.y), z: mul(e_29.z, weights_22.y) };
    let e_36 = motif_texel_l(r, add_u(normals_16, splat_u(2u32)));
    let sum_40 = Vec3 { x: add(add(first_26.x, second_32.x), mul(e_36.x, weights_22.z)), y: add(add(first_26.y, second_32.y), mul(e_36.y, weights_22.z)), z: add(add(first_26.z, second_32.z), mul(e_36.z, weights_22.z)) };
    let e_41 = Vec3 { x: sub(e_6.x, e_2.x), y: sub(e_6.y, e_2.y), z: sub(e_6.z, e_2.z) };
    let e_42 = Vec3 { x: sub(e_10.x, e_2.x), y: sub(e_10.y, e_2.y), z: sub(e_10.z, e_2.z) };
    let e_43 = Vec3 { x: sub(mul(e_41.y, e_42.z), mul(e_41.z, e_42.y)), y: sub(mul(e_41.z, e_42.x), mul(e_41.x, e_42.z)), z: sub(mul(e_41.x, e_42.y), mul(e_41.y, e_42.x)) };
    let length1 = sqrt(add(add(mul(e_43.x, e_43.x), mul(e_43.y, e_43.y)), mul(e_43.z, e_43.z)));
    let flat_normal_44 = Vec3 { x: div(e_43.x, length1), y: div(e_43.y, length1), z: div(e_43.z, length1) };
    let e_50 = sel(lt(add(add(add(mul(flat_normal_44.x, sum_40.x), mul(flat_normal_44.y, sum_40.y)), mul(flat_normal_44.z, sum_40.z)), splat(0.0f32)), splat(0.0f32)), splat((-1.0f32)), splat(1.0f32));
    let facet_51 = Vec3 { x: mul(flat_normal_44.x, e_50), y: mul(flat_normal_44.y, e_50), z: mul(flat_normal_44.z, e_50) };
    let size_52 = sqrt(add(add(mul(sum_40.x, sum_40.x), mul(sum_40.y, sum_40.y)), mul(sum_40.z, sum_40.z)));
    let (b2, c3) = (ex, gt(size_52, splat(0.0f32)));
    ex = and(b2, c3);
    if any(ex) {
        ret = MotifPoint { normal: Vec3 { x: div(sum_40.x, size_52), y: div(sum_40.y, size_52), z: div(sum_40.z, size_52) }, facet: facet_51, };
        ex = no_lane();
    }
    ex = and_not(b2, c3);
    return sel_motif_point(ex, &MotifPoint { normal: facet_51, facet: facet_51, }, &ret);
} }
stage! { fn motif_at(r: &Resources<'_>, within: M, place_a0: Vec3<F>) -> MotifPoint {
    let mut ex = within;
    let mut ret: MotifPoint = zero_motif_point();
    let mut nearest_v0: NearTriangle = NearTriangle { triangle: splat_u(0u32), apart: splat(1e-8f32), };
    let mut node_v1: U = splat_u(1u32);
    let mut next_v2: U = splat_u(0u32);
    let reach_4 = Vec3 { x: 0.0001f32, y: 0.0001f32, z: 0.0001f32 };
    let b2 = ex;
    'l1: loop {
        let e_11 = node_v1;
        let c3 = ne_u(e_11, splat_u(0u32));
        ex = and(ex, c3);
        let e_14 = node_v1;
        if none(ex) { break 'l1; }
        let low_15 = motif_texel_l(r, e_14);
        let e_16 = node_v1;
        let high_19 = motif_texel_l(r, add_u(e_16, splat_u(1u32)));
        next_v2 = u_of_f(low_15.w);
        let beyond_29 = Vec3 { x: max(sub(sub(low_15.x, splat(reach_4.x)), place_a0.x), sub(sub(place_a0.x, high_19.x), splat(reach_4.x))), y: max(sub(sub(low_15.y, splat(reach_4.y)), place_a0.y), sub(sub(place_a0.y, high_19.y), splat(reach_4.y))), z: max(sub(sub(low_15.z, splat(reach_4.z)), place_a0.z), sub(sub(place_a0.z, high_19.z), splat(reach_4.z))) };
        let (b4, c5) = (ex, le(max(max(beyond_29.x, beyond_29.y), beyond_29.z), splat(0.0f32)));
        ex = and(b4, c5);
        if any(ex) {
            let (b6, c7) = (ex, eq(high_19.w, splat(0.0f32)));
            ex = and(b6, c7);
            if any(ex) {
                let e_40 = node_v1;
                next_v2 = sel_u(ex, add_u(e_40, splat_u(2u32)), next_v2);
            }
            ex = and_not(b6, c7);
            if any(ex) {
                let e_45 = nearest_v0;
                let e_46 = nearest_of_leaf(r, ex, place_a0, u_of_f(high_19.w), &e_45);
                nearest_v0 = sel_near_triangle(ex, &e_46, &nearest_v0);
            }
            ex = b6;
        }
        ex = b4;
        let e_47 = next_v2;
        node_v1 = e_47;
    }
    ex = b2;
    let e_49 = nearest_v0.triangle;
    let (b8, c9) = (ex, eq_u(e_49, splat_u(0u32)));
    ex = and(b8, c9);
    if any(ex) {
        ret = MotifPoint { normal: Vec3 { x: splat(0.0f32), y: splat(0.0f32), z: splat(1.0f32) }, facet: Vec3 { x: splat(0.0f32), y: splat(0.0f32), z: splat(1.0f32) }, };
        ex = no_lane();
    }
    ex = and_not(b8, c9);
    let e_62 = nearest_v0.triangle;
    if none(ex) { return ret; }
    let e_63 = point_of_triangle(r, ex, e_62, place_a0);
    return sel_motif_point(ex, &e_63, &ret);
} }
lanes! { fn motif_of(r: &Resources<'_>, within: M, hit_a0: &Hit) -> MotifPoint {
    let mut ex = within;
    let mut ret: MotifPoint = zero_motif_point();
    let e_7 = motif_at(r, ex, Vec3 { x: sub(hit_a0.uv.x, floor(hit_a0.uv.x)), y: sub(hit_a0.uv.y, floor(hit_a0.uv.y)), z: hit_a0.height });
    return e_7;
} }
lanes! { fn light_ray_out_of_motif(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, light_a2: &Toward) -> LightRay {
    let mut ex = within;
    let mut ret: LightRay = zero_light_ray();
    let change_4 = climb(r, at_a0, Vec3 { x: light_a2.direction.x, y: light_a2.direction.y, z: light_a2.direction.z });
    let e_5 = motif_of(r, ex, hit_a1);
    let e_12 = sel(gt(add(add(add(mul(e_5.facet.x, change_4.x), mul(e_5.facet.y, change_4.y)), mul(e_5.facet.z, change_4.z)), splat(0.0f32)), splat(0.0f32)), splat(0.0002f32), splat((-0.0002f32)));
    let aside_13 = Vec3 { x: mul(e_5.facet.x, e_12), y: mul(e_5.facet.y, e_12), z: mul(e_5.facet.z, e_12) };
    let e_15 = near_uv(r, Vec2 { x: hit_a1.uv.x, y: hit_a1.uv.y });
    let e_19 = light_ray_from(r, ex, at_a0, Vec3 { x: add(e_15.x, aside_13.x), y: add(e_15.y, aside_13.y), z: add(hit_a1.height, aside_13.z) }, change_4, light_a2);
    return e_19;
} }
lanes! { fn field_motif_light_ray(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, light_a2: &Toward, params_a3: Vec4<f32>) -> LightRay {
    let mut ex = within;
    let mut ret: LightRay = zero_light_ray();
    let e_4 = light_ray_out_of_motif(r, ex, at_a0, hit_a1, light_a2);
    return e_4;
} }
lanes! { fn field_light_ray_stage(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, light_a2: &Toward) -> LightRay {
    let mut ex = within;
    let mut ret: LightRay = zero_light_ray();
    match r.surface_settings.choices[4].number {
        0u32 => {
            let e_13 = field_heights_light_ray(r, ex, at_a0, hit_a1, light_a2, r.surface_settings.choices[4].params);
            return e_13;
        }
        1u32 => {
            let e_19 = field_volume_light_ray(r, ex, at_a0, hit_a1, light_a2, r.surface_settings.choices[4].params);
            return e_19;
        }
        _ => {
            let e_25 = field_motif_light_ray(r, ex, at_a0, hit_a1, light_a2, r.surface_settings.choices[4].params);
            return e_25;
        }
    }
} }
lanes! { fn motif_is_closed(r: &Resources<'_>) -> M {
    let e_1 = motif_texel_s(r, 0u32);
    return eq(e_1.z, splat(1.0f32));
} }
lanes! { fn field_motif_normal(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, view_a2: Vec3<F>, params_a3: Vec4<f32>) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let mut both_v0: M = splat_m(false);
    let point_4 = motif_of(r, ex, hit_a1);
    let e_5 = motif_is_closed(r);
    let (b1, c2) = (ex, not(e_5));
    ex = and(b1, c2);
    if any(ex) {
        let e_10 = covector(r, at_a0, Vec3 { x: point_4.facet.x, y: point_4.facet.y, z: point_4.facet.z });
        both_v0 = sel_m(ex, ge(add(add(add(mul(e_10.x, view_a2.x), mul(e_10.y, view_a2.y)), mul(e_10.z, view_a2.z)), splat(0.0f32)), splat(0.0f32)), both_v0);
    }
    ex = and_not(b1, c2);
    if any(ex) {
        both_v0 = sel_m(ex, splat_m(true), both_v0);
    }
    ex = b1;
    let is_front_15 = both_v0;
    let side_18 = sel(is_front_15, splat(1.0f32), splat((-1.0f32)));
    let e_20 = covector(r, at_a0, Vec3 { x: point_4.normal.x, y: point_4.normal.y, z: point_4.normal.z });
    let length3 = sqrt(add(add(mul(e_20.x, e_20.x), mul(e_20.y, e_20.y)), mul(e_20.z, e_20.z)));
    let e_21 = Vec3 { x: div(e_20.x, length3), y: div(e_20.y, length3), z: div(e_20.z, length3) };
    return Vec3 { x: mul(e_21.x, side_18), y: mul(e_21.y, side_18), z: mul(e_21.z, side_18) };
} }
lanes! { fn field_motif_normals(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, view_a2: Vec3<F>, params_a3: Vec4<f32>) -> SeenNormals {
    let mut ex = within;
    let mut ret: SeenNormals = zero_seen_normals();
    let e_4 = field_motif_normal(r, ex, at_a0, hit_a1, view_a2, params_a3);
    let e_5 = one_seen(r, e_4);
    return e_5;
} }
lanes! { fn normal_of_field(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let mut both_v0: M = splat_m(false);
    let place_5 = voxel_place(r, Vec3 { x: hit_a1.uv.x, y: hit_a1.uv.y, z: hit_a1.height });
    let e_6 = field_at_voxel(r, ex, place_5);
    let c1 = gt(e_6, splat(0.51f32));
    ret = Vec3 { x: at_a0.normal.x, y: at_a0.normal.y, z: at_a0.normal.z };
    ex = and_not(ex, c1);
    if none(ex) { return ret; }
    let e_10 = field_slopes(r, ex, place_5);
    let e_11 = r.volume_size();
    let rising_13 = covector(r, at_a0, Vec3 { x: mul(e_10.x, splat(e_11.x)), y: mul(e_10.y, splat(e_11.y)), z: mul(e_10.z, splat(e_11.z)) });
    let steepness_14 = sqrt(add(add(mul(rising_13.x, rising_13.x), mul(rising_13.y, rising_13.y)), mul(rising_13.z, rising_13.z)));
    both_v0 = and(gt(steepness_14, splat(0.0f32)), lt(steepness_14, splat(3e38f32)));
    let e_22 = both_v0;
    let c2 = e_22;
    let e_24 = div(splat((-1.0f32)), steepness_14);
    let y3 = Vec3 { x: mul(rising_13.x, e_24), y: mul(rising_13.y, e_24), z: mul(rising_13.z, e_24) };
    ret = Vec3 { x: sel(and(ex, c2), y3.x, ret.x), y: sel(and(ex, c2), y3.y, ret.y), z: sel(and(ex, c2), y3.z, ret.z) };
    ex = and_not(ex, c2);
    let y4 = Vec3 { x: at_a0.normal.x, y: at_a0.normal.y, z: at_a0.normal.z };
    return Vec3 { x: sel(ex, y4.x, ret.x), y: sel(ex, y4.y, ret.y), z: sel(ex, y4.z, ret.z) };
} }
lanes! { fn field_volume_normals(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, view_a2: Vec3<F>, params_a3: Vec4<f32>) -> SeenNormals {
    let mut ex = within;
    let mut ret: SeenNormals = zero_seen_normals();
    let e_4 = normal_of_field(r, ex, at_a0, hit_a1);
    let e_5 = one_seen(r, e_4);
    return e_5;
} }
lanes! { fn field_normals_stage(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, view_a2: Vec3<F>) -> SeenNormals {
    let mut ex = within;
    let mut ret: SeenNormals = zero_seen_normals();
    match r.surface_settings.choices[4].number {
        0u32 => {
            let e_13 = field_heights_normals(r, ex, at_a0, hit_a1, view_a2, r.surface_settings.choices[4].params);
            return e_13;
        }
        1u32 => {
            let e_19 = field_volume_normals(r, ex, at_a0, hit_a1, view_a2, r.surface_settings.choices[4].params);
            return e_19;
        }
        _ => {
            let e_25 = field_motif_normals(r, ex, at_a0, hit_a1, view_a2, r.surface_settings.choices[4].params);
            return e_25;
        }
    }
} }
lanes! { fn surface_plane_way(r: &Resources<'_>, within: M, at_a0: &Entered, direction_a1: Vec3<F>, distance_a2: F, eye_a3: F, k_a4: u32, params_a5: Vec4<f32>) -> Path {
    let mut ex = within;
    let mut ret: Path = zero_path();
    let mut enter_v0: F = splat(0f32);
    let mut leave_v1: F = splat(0f32);
    let mut interval_v2: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    let e_6 = climb(r, at_a0, direction_a1);
    let is_flat_12 = (r.surface_settings.scale_m == 0.0f32);
    let descent_20 = max(sub(splat(0.0f32), add(add(add(mul(at_a0.normal.x, direction_a1.x), mul(at_a0.normal.y, direction_a1.y)), mul(at_a0.normal.z, direction_a1.z)), splat(0.0f32))), splat((if is_flat_12 { 0.001f32 } else { (-3e38f32) })));
    let scale_21 = r.traced_scale_m();
    let base_height_22 = r.base_height();
    let slope_25 = div(sub(splat(0.0f32), descent_20), splat(scale_21));
    let top_29 = div(splat(((base_height_22 - 1.0f32) * scale_21)), descent_20);
    enter_v0 = max(top_29, eye_a3);
    leave_v1 = div(splat((base_height_22 * scale_21)), descent_20);
    let e_35 = leave_v1;
    let e_36 = leave_v1;
    leave_v1 = add(e_35, mul(sub(e_36, top_29), splat(1e-6f32)));
    if (r.surface_settings.wrap == 1u32) {
        let e_49 = enter_v0;
        let e_50 = leave_v1;
        let e_52 = inside_unit(r, ex, at_a0.uv.x, e_6.x, Vec2 { x: e_49, y: e_50 });
        interval_v2 = e_52;
        let e_57 = interval_v2;
        let e_58 = inside_unit(r, ex, at_a0.uv.y, e_6.y, e_57);
        interval_v2 = e_58;
        let e_60 = interval_v2.x;
        enter_v0 = e_60;
        let e_62 = interval_v2.y;
        leave_v1 = e_62;
    }
    let e_63 = enter_v0;
    let e_66 = enter_v0;
    let entry_height_69 = sel(eq(e_66, top_29), splat(1.0f32), add(splat(base_height_22), mul(slope_25, e_63)));
    let e_70 = enter_v0;
    let base_75 = min_with(max_with(sub(splat(0.0f32), e_70), splat((-3e38f32))), splat(3e38f32));
    let e_77 = enter_v0;
    let e_82 = leave_v1;
    let e_83 = enter_v0;
    let e_92 = enter_v0;
    return Path { uv: Vec2 { x: add(at_a0.uv.x, mul(e_6.x, e_77)), y: add(at_a0.uv.y, mul(e_6.y, e_77)) }, duv: Vec2 { x: e_6.x, y: e_6.y }, h: Vec3 { x: entry_height_69, y: slope_25, z: splat(0.0f32) }, exit: sel(gt(descent_20, splat(0.0f32)), sub(e_82, e_83), splat(0.0f32)), base: base_75, metric: Vec4 { x: at_a0.metric.x, y: at_a0.metric.y, z: at_a0.metric.z, w: at_a0.metric.w }, ray: splat_u(0u32), level: at_a0.level, start: add(distance_a2, e_92), share: splat(1.0f32), bend: splat(0.0f32), };
} }
lanes! { fn surface_plane_segment(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, k_a2: u32, params_a3: Vec4<f32>) -> Path {
    let mut ex = within;
    let mut ret: Path = zero_path();
    let along_5 = sqrt(add(add(mul(pixel_a0.direction.x, pixel_a0.direction.x), mul(pixel_a0.direction.y, pixel_a0.direction.y)), mul(pixel_a0.direction.z, pixel_a0.direction.z)));
    let e_6 = plane_normal(r, pixel_a0);
    let e_7 = plane_distance(r, pixel_a0, e_6);
    let distance_8 = mul(e_7, along_5);
    let e_14 = surface_plane_way(r, ex, at_a1, Vec3 { x: div(pixel_a0.direction.x, along_5), y: div(pixel_a0.direction.y, along_5), z: div(pixel_a0.direction.z, along_5) }, distance_8, sub(splat(0.0f32), distance_8), k_a2, params_a3);
    return e_14;
} }
stage! { fn folded_segment(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, k_a2: u32, params_a3: Vec4<f32>) -> Path {
    if none(within) { return zero_path(); }
    let pixel_a0 = singles_pixel_in(pixel_a0);
    let at_a1 = singles_entered(at_a1);
    let one = |lane: usize| r.folded_segment(pixel_a0[lane], at_a1[lane], k_a2, params_a3);
    let mut rest = bits_of(within);
    let mut results = [one(rest.trailing_zeros() as usize); LANES];
    rest &= rest - 1;
    while rest != 0 {
        let lane = rest.trailing_zeros() as usize;
        results[lane] = one(lane);
        rest &= rest - 1;
    }
    lanes_of_path(&results)
} }
lanes! { fn surface_prism_segment(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, k_a2: u32, params_a3: Vec4<f32>) -> Path {
    let mut ex = within;
    let mut ret: Path = zero_path();
    if (pixel_a0.shell.order >= 64u32) {
        let e_8 = folded_segment(r, ex, pixel_a0, at_a1, k_a2, params_a3);
        return e_8;
    }
    let length1 = sqrt(add(add(mul(pixel_a0.direction.x, pixel_a0.direction.x), mul(pixel_a0.direction.y, pixel_a0.direction.y)), mul(pixel_a0.direction.z, pixel_a0.direction.z)));
    let along_10 = Vec3 { x: div(pixel_a0.direction.x, length1), y: div(pixel_a0.direction.y, length1), z: div(pixel_a0.direction.z, length1) };
    let middle_11 = middle_of(r, pixel_a0, along_10);
    let prism_12 = prism_of(r, pixel_a0, along_10, middle_11, params_a3);
    let mean_19 = (0.5f32 * (pixel_a0.shell.heights.x + pixel_a0.shell.heights.y));
    let first_20 = chord_end(r, at_a1, k_a2);
    let last_23 = chord_end(r, at_a1, k_a2.wrapping_add(1u32));
    let a_25 = shell_point(r, ex, &prism_12, Vec3 { x: mul(along_10.x, first_20), y: mul(along_10.y, first_20), z: mul(along_10.z, first_20) }, splat(mean_19));
    let b_27 = shell_point(r, ex, &prism_12, Vec3 { x: mul(along_10.x, last_23), y: mul(along_10.y, last_23), z: mul(along_10.z, last_23) }, splat(mean_19));
    let e_32 = between(r, &a_25, &b_27);
    let e_30 = mul(splat(0.5f32), add(first_20, last_23));
    let m_33 = shell_point_from(r, ex, &prism_12, Vec3 { x: mul(along_10.x, e_30), y: mul(along_10.y, e_30), z: mul(along_10.z, e_30) }, &e_32);
    let bend_42 = mul(splat(2.0f32), sub(add(a_25.height, b_27.height), mul(splat(2.0f32), m_33.height)));
    let e_56 = chord_reach(r, pixel_a0, at_a1, middle_11, params_a3);
    let e_45 = Vec3 { x: sub(prism_12.p2.x, prism_12.p1.x), y: sub(prism_12.p2.y, prism_12.p1.y), z: sub(prism_12.p2.z, prism_12.p1.z) };
    let e_59 = Vec3 { x: sub(prism_12.p1.x, prism_12.p0.x), y: sub(prism_12.p1.y, prism_12.p0.y), z: sub(prism_12.p1.z, prism_12.p0.z) };
    let e_62 = Vec3 { x: sub(prism_12.p2.x, prism_12.p0.x), y: sub(prism_12.p2.y, prism_12.p0.y), z: sub(prism_12.p2.z, prism_12.p0.z) };
    let e_63 = Vec3 { x: sub(mul(e_59.y, e_62.z), mul(e_59.z, e_62.y)), y: sub(mul(e_59.z, e_62.x), mul(e_59.x, e_62.z)), z: sub(mul(e_59.x, e_62.y), mul(e_59.y, e_62.x)) };
    let e_65 = div(e_56, sqrt(add(add(mul(e_63.x, e_63.x), mul(e_63.y, e_63.y)), mul(e_63.z, e_63.z))));
    let e_49 = Vec3 { x: sub(prism_12.p0.x, prism_12.p2.x), y: sub(prism_12.p0.y, prism_12.p2.y), z: sub(prism_12.p0.z, prism_12.p2.z) };
    let e_53 = Vec3 { x: sub(prism_12.p1.x, prism_12.p0.x), y: sub(prism_12.p1.y, prism_12.p0.y), z: sub(prism_12.p1.z, prism_12.p0.z) };
    let beyond_66 = Vec3 { x: mul(sqrt(add(add(mul(e_45.x, e_45.x), mul(e_45.y, e_45.y)), mul(e_45.z, e_45.z))), e_65), y: mul(sqrt(add(add(mul(e_49.x, e_49.x), mul(e_49.y, e_49.y)), mul(e_49.z, e_49.z))), e_65), z: mul(sqrt(add(add(mul(e_53.x, e_53.x), mul(e_53.y, e_53.y)), mul(e_53.z, e_53.z))), e_65) };
    let e_68 = chord_path(r, ex, pixel_a0, at_a1, middle_11, params_a3, &a_25, &b_27, bend_42, Vec2 { x: first_20, y: last_23 }, beyond_66);
    return e_68;
} }
lanes! { fn surface_quadric_perpendicular_way(r: &Resources<'_>, within: M, at_a0: &Entered, direction_a1: Vec3<F>, distance_a2: F, eye_a3: F, k_a4: u32, params_a5: Vec4<f32>) -> Path {
    let mut ex = within;
    let mut ret: Path = zero_path();
    let mut begin_v0: F = splat(0f32);
    let mut end_v1: F = splat(0f32);
    let mut both_v2: M = splat_m(false);
    let mut path_v3: Path = zero_path();
    let mut inside_v4: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    let ray_6 = across_of(r, at_a0, direction_a1);
    let scale_7 = r.traced_scale_m();
    let whole_12 = sub(at_a0.span.y, at_a0.span.x);
    let first_19 = add(at_a0.span.x, mul(whole_12, splat(((k_a4 as f32) / params_a5.z))));
    let last_28 = add(at_a0.span.x, mul(whole_12, splat(((k_a4.wrapping_add(1u32) as f32) / params_a5.z))));
    let long_29 = sub(last_28, first_19);
    let e_32 = across_depth(r, ex, &ray_6, first_19);
    begin_v0 = sub(at_a0.of_surface.w, div(e_32, splat(scale_7)));
    if (k_a4 == 0u32) {
        let e_38 = begin_v0;
        begin_v0 = min_with(e_38, splat(1.0f32));
    }
    let e_46 = across_depth(r, ex, &ray_6, mul(splat(0.5f32), add(first_19, last_28)));
    let middle_48 = sub(at_a0.of_surface.w, div(e_46, splat(scale_7)));
    let e_51 = across_depth(r, ex, &ray_6, last_28);
    end_v1 = sub(at_a0.of_surface.w, div(e_51, splat(scale_7)));
    if (k_a4.wrapping_add(1u32) == (params_a5.z as u32)) {
        let e_62 = end_v1;
        both_v2 = lt(e_62, splat(0.5f32));
    } else {
        both_v2 = splat_m(false);
    }
    let e_66 = both_v2;
    let c1 = e_66;
    let e_67 = end_v1;
    end_v1 = sel(c1, min_with(e_67, splat((-1e-6f32))), end_v1);
    let e_70 = begin_v0;
    let e_71 = end_v1;
    let bend_77 = mul(splat(2.0f32), sub(add(e_70, e_71), mul(splat(2.0f32), middle_48)));
    let e_78 = end_v1;
    let e_79 = begin_v0;
    let slope_81 = sub(sub(e_78, e_79), bend_77);
    let base_86 = min_with(max_with(sub(splat(0.0f32), first_19), splat((-3e38f32))), splat(3e38f32));
    let e_92 = begin_v0;
    path_v3 = Path { uv: Vec2 { x: add(at_a0.uv.x, mul(ray_6.duv.x, first_19)), y: add(at_a0.uv.y, mul(ray_6.duv.y, first_19)) }, duv: Vec2 { x: ray_6.duv.x, y: ray_6.duv.y }, h: Vec3 { x: e_92, y: div(slope_81, long_29), z: div(bend_77, mul(long_29, long_29)) }, exit: long_29, base: base_86, metric: Vec4 { x: at_a0.metric.x, y: at_a0.metric.y, z: at_a0.metric.z, w: at_a0.metric.w }, ray: splat_u(0u32), level: at_a0.level, start: add(distance_a2, first_19), share: splat((1.0f32 / params_a5.z)), bend: splat(0.0f32), };
    inside_v4 = Vec2 { x: splat(0.0f32), y: long_29 };
    if (r.surface_settings.wrap == 1u32) {
        let e_117 = path_v3.uv.x;
        let e_120 = inside_v4;
        let e_121 = inside_unit(r, ex, e_117, ray_6.duv.x, e_120);
        inside_v4 = e_121;
        let e_124 = path_v3.uv.y;
        let e_127 = inside_v4;
        let e_128 = inside_unit(r, ex, e_124, ray_6.duv.y, e_127);
        inside_v4 = e_128;
        let e_131 = inside_v4.y;
        path_v3.exit = e_131;
        let e_132 = path_v3;
        let e_134 = inside_v4.x;
        let e_135 = path_from(r, &e_132, e_134);
        path_v3 = e_135;
    }
    let e_137 = path_v3.exit;
    let c2 = not(gt(e_137, splat(0.0f32)));
    path_v3.exit = sel(c2, splat(0.0f32), path_v3.exit);
    let e_143 = path_v3;
    return e_143;
} }
lanes! { fn surface_quadric_perpendicular_segment(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, k_a2: u32, params_a3: Vec4<f32>) -> Path {
    let mut ex = within;
    let mut ret: Path = zero_path();
    let along_5 = sqrt(add(add(mul(pixel_a0.direction.x, pixel_a0.direction.x), mul(pixel_a0.direction.y, pixel_a0.direction.y)), mul(pixel_a0.direction.z, pixel_a0.direction.z)));
    let e_6 = plane_normal(r, pixel_a0);
    let e_7 = plane_distance(r, pixel_a0, e_6);
    let distance_8 = mul(e_7, along_5);
    let e_14 = surface_quadric_perpendicular_way(r, ex, at_a1, Vec3 { x: div(pixel_a0.direction.x, along_5), y: div(pixel_a0.direction.y, along_5), z: div(pixel_a0.direction.z, along_5) }, distance_8, sub(splat(0.0f32), distance_8), k_a2, params_a3);
    return e_14;
} }
lanes! { fn surface_quadric_vertical_way(r: &Resources<'_>, within: M, at_a0: &Entered, direction_a1: Vec3<F>, distance_a2: F, eye_a3: F, k_a4: u32, params_a5: Vec4<f32>) -> Path {
    let mut ex = within;
    let mut ret: Path = zero_path();
    let mut both_v0: M = splat_m(false);
    let mut both_v1: M = splat_m(false);
    let mut enter_v2: F = splat(0f32);
    let mut leave_v3: F = splat(0f32);
    let mut interval_v4: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    let mut path_v5: Path = zero_path();
    let mut both_v6: M = splat_m(false);
    let e_6 = climb(r, at_a0, direction_a1);
    let descent_11 = sub(splat(0.0f32), add(add(add(mul(at_a0.normal.x, direction_a1.x), mul(at_a0.normal.y, direction_a1.y)), mul(at_a0.normal.z, direction_a1.z)), splat(0.0f32)));
    let scale_12 = r.traced_scale_m();
    let slope_17 = div(sub(splat(0.0f32), descent_11), splat(scale_12));
    let bend_20 = quadric_at(r, Vec3 { x: at_a0.of_surface.x, y: at_a0.of_surface.y, z: at_a0.of_surface.z }, Vec2 { x: e_6.x, y: e_6.y });
    let curve_23 = div(sub(splat(0.0f32), bend_20), splat(scale_12));
    let top_27 = bent_descent(r, ex, mul(sub(at_a0.of_surface.w, splat(1.0f32)), splat(scale_12)), descent_11, bend_20);
    both_v1 = or(lt(at_a0.of_surface.w, splat(1.0f32)), ge(top_27, splat(0.0f32)));
    let e_40 = both_v1;
    both_v0 = and(lt(top_27, splat(3e38f32)), e_40);
    let comes_down_42 = both_v0;
    enter_v2 = max(top_27, eye_a3);
    let e_45 = enter_v2;
    let e_46 = enter_v2;
    let e_51 = enter_v2;
    let begin_54 = sel(eq(e_51, top_27), splat(1.0f32), add(at_a0.of_surface.w, mul(e_45, add(slope_17, mul(curve_23, e_46)))));
    let e_55 = enter_v2;
    let e_58 = enter_v2;
    let e_62 = bent_exit(r, ex, Vec3 { x: begin_54, y: add(slope_17, mul(mul(splat(2.0f32), curve_23), e_58)), z: curve_23 });
    leave_v3 = add(e_55, e_62);
    let c1 = eq(bend_20, splat(0.0f32));
    leave_v3 = sel(c1, div(mul(at_a0.of_surface.w, splat(scale_12)), descent_11), leave_v3);
    let e_69 = leave_v3;
    let e_70 = leave_v3;
    leave_v3 = sel(c1, add(e_69, mul(sub(e_70, top_27), splat(1e-6f32))), leave_v3);
    if (r.surface_settings.wrap == 1u32) {
        let e_83 = enter_v2;
        let e_84 = leave_v3;
        let e_86 = inside_unit(r, ex, at_a0.uv.x, e_6.x, Vec2 { x: e_83, y: e_84 });
        interval_v4 = e_86;
        let e_91 = interval_v4;
        let e_92 = inside_unit(r, ex, at_a0.uv.y, e_6.y, e_91);
        interval_v4 = e_92;
        let e_94 = interval_v4.x;
        enter_v2 = e_94;
        let e_96 = interval_v4.y;
        leave_v3 = e_96;
    }
    let e_97 = enter_v2;
    let e_98 = enter_v2;
    let e_103 = enter_v2;
    let entry_height_106 = sel(eq(e_103, top_27), splat(1.0f32), add(at_a0.of_surface.w, mul(e_97, add(slope_17, mul(curve_23, e_98)))));
    let e_107 = enter_v2;
    let base_112 = min_with(max_with(sub(splat(0.0f32), e_107), splat((-3e38f32))), splat(3e38f32));
    let e_114 = enter_v2;
    let e_119 = enter_v2;
    let e_123 = leave_v3;
    let e_124 = enter_v2;
    let e_129 = enter_v2;
    path_v5 = Path { uv: Vec2 { x: add(at_a0.uv.x, mul(e_6.x, e_114)), y: add(at_a0.uv.y, mul(e_6.y, e_114)) }, duv: Vec2 { x: e_6.x, y: e_6.y }, h: Vec3 { x: entry_height_106, y: add(slope_17, mul(mul(splat(2.0f32), curve_23), e_119)), z: curve_23 }, exit: sub(e_123, e_124), base: base_112, metric: Vec4 { x: at_a0.metric.x, y: at_a0.metric.y, z: at_a0.metric.z, w: at_a0.metric.w }, ray: splat_u(0u32), level: at_a0.level, start: add(distance_a2, e_129), share: splat(1.0f32), bend: splat(0.0f32), };
    let e_140 = path_v5.exit;
    both_v6 = or(not(comes_down_42), not(gt(e_140, splat(0.0f32))));
    let e_145 = both_v6;
    let c2 = e_145;
    path_v5.exit = sel(c2, splat(0.0f32), path_v5.exit);
    let e_148 = path_v5;
    return e_148;
} }
lanes! { fn surface_quadric_vertical_segment(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, k_a2: u32, params_a3: Vec4<f32>) -> Path {
    let mut ex = within;
    let mut ret: Path = zero_path();
    let along_5 = sqrt(add(add(mul(pixel_a0.direction.x, pixel_a0.direction.x), mul(pixel_a0.direction.y, pixel_a0.direction.y)), mul(pixel_a0.direction.z, pixel_a0.direction.z)));
    let e_6 = plane_normal(r, pixel_a0);
    let e_7 = plane_distance(r, pixel_a0, e_6);
    let distance_8 = mul(e_7, along_5);
    let e_14 = surface_quadric_vertical_way(r, ex, at_a1, Vec3 { x: div(pixel_a0.direction.x, along_5), y: div(pixel_a0.direction.y, along_5), z: div(pixel_a0.direction.z, along_5) }, distance_8, sub(splat(0.0f32), distance_8), k_a2, params_a3);
    return e_14;
} }
lanes! { fn surface_tetrahedra_segment(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, k_a2: u32, params_a3: Vec4<f32>) -> Path {
    let mut ex = within;
    let mut ret: Path = zero_path();
    let mut chosen_v0: Tetrahedron = zero_tetrahedron();
    let mut inside_v1: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    let mut path_v2: Path = zero_path();
    let length1 = sqrt(add(add(mul(pixel_a0.direction.x, pixel_a0.direction.x), mul(pixel_a0.direction.y, pixel_a0.direction.y)), mul(pixel_a0.direction.z, pixel_a0.direction.z)));
    let along_5 = Vec3 { x: div(pixel_a0.direction.x, length1), y: div(pixel_a0.direction.y, length1), z: div(pixel_a0.direction.z, length1) };
    let middle_6 = middle_of(r, pixel_a0, along_5);
    let first_8 = tetrahedron(r, ex, pixel_a0, along_5, middle_6, 0u32);
    let second_10 = tetrahedron(r, ex, pixel_a0, along_5, middle_6, 1u32);
    let third_12 = tetrahedron(r, ex, pixel_a0, along_5, middle_6, 2u32);
    let first_second_15 = comes_before(r, Vec2 { x: first_8.inside.x, y: first_8.inside.y }, Vec2 { x: second_10.inside.x, y: second_10.inside.y });
    let first_third_18 = comes_before(r, Vec2 { x: first_8.inside.x, y: first_8.inside.y }, Vec2 { x: third_12.inside.x, y: third_12.inside.y });
    let second_third_21 = comes_before(r, Vec2 { x: second_10.inside.x, y: second_10.inside.y }, Vec2 { x: third_12.inside.x, y: third_12.inside.y });
    chosen_v0 = first_8;
    let c2 = eq_u(add_u(first_second_15, sub_u(splat_u(1u32), second_third_21)), splat_u(k_a2));
    chosen_v0 = sel_tetrahedron(c2, &second_10, &chosen_v0);
    let c3 = eq_u(add_u(first_third_18, second_third_21), splat_u(k_a2));
    chosen_v0 = sel_tetrahedron(c3, &third_12, &chosen_v0);
    let a_30 = ordered(r, pixel_a0, 0u32);
    let b_32 = ordered(r, pixel_a0, 1u32);
    let c_34 = ordered(r, pixel_a0, 2u32);
    let w_36 = chosen_v0.weights;
    let g_38 = chosen_v0.change;
    let uv_49 = Vec2 { x: add(add(mul(a_30.uv.x, w_36.x), mul(b_32.uv.x, w_36.y)), mul(c_34.uv.x, w_36.z)), y: add(add(mul(a_30.uv.y, w_36.x), mul(b_32.uv.y, w_36.y)), mul(c_34.uv.y, w_36.z)) };
    let duv_60 = Vec2 { x: add(add(mul(a_30.uv.x, g_38.x), mul(b_32.uv.x, g_38.y)), mul(c_34.uv.x, g_38.z)), y: add(add(mul(a_30.uv.y, g_38.x), mul(b_32.uv.y, g_38.y)), mul(c_34.uv.y, g_38.z)) };
    let slack_61 = shell_slack(r, pixel_a0, middle_6);
    let beyond_66 = add(splat(1e-6f32), mul(slack_61, abs(g_38.w)));
    let e_68 = chosen_v0.inside;
    inside_v1 = e_68;
    let e_70 = inside_v1;
    let e_77 = where_positive(r, ex, e_70, sub(w_36.w, splat(pixel_a0.shell.heights.x)), g_38.w, beyond_66);
    inside_v1 = e_77;
    let e_78 = inside_v1;
    let e_87 = where_positive(r, ex, e_78, sub(splat(pixel_a0.shell.heights.y), w_36.w), sub(splat(0.0f32), g_38.w), beyond_66);
    inside_v1 = e_87;
    if (r.surface_settings.wrap == 1u32) {
        let e_95 = inside_v1;
        let e_96 = inside_unit(r, ex, uv_49.x, duv_60.x, e_95);
        inside_v1 = e_96;
        let e_99 = inside_v1;
        let e_100 = inside_unit(r, ex, uv_49.y, duv_60.y, e_99);
        inside_v1 = e_100;
    }
    let whole_123 = add(add(max_with(sub(first_8.inside.y, first_8.inside.x), splat(0.0f32)), max_with(sub(second_10.inside.y, second_10.inside.x), splat(0.0f32))), max_with(sub(third_12.inside.y, third_12.inside.x), splat(0.0f32)));
    let e_125 = inside_v1.x;
    let e_131 = inside_v1.x;
    let e_138 = inside_v1.y;
    let e_140 = inside_v1.x;
    let e_146 = inside_v1.x;
    let e_149 = inside_v1.y;
    let e_151 = inside_v1.x;
    path_v2 = Path { uv: Vec2 { x: add(uv_49.x, mul(duv_60.x, e_125)), y: add(uv_49.y, mul(duv_60.y, e_125)) }, duv: duv_60, h: Vec3 { x: add(w_36.w, mul(g_38.w, e_131)), y: g_38.w, z: splat(0.0f32) }, exit: sub(e_138, e_140), base: splat(0.0f32), metric: Vec4 { x: at_a1.metric.x, y: at_a1.metric.y, z: at_a1.metric.z, w: at_a1.metric.w }, ray: splat_u(0u32), level: at_a1.level, start: add(middle_6, e_146), share: div(sub(e_149, e_151), whole_123), bend: splat(0.0f32), };
    let e_159 = path_v2.exit;
    let (b4, c5) = (ex, gt(e_159, splat(0.0f32)));
    ex = and(b4, c5);
    if any(ex) {
        let e_162 = path_v2;
        let e_163 = path_v2;
        let e_167 = out_of_ground(r, ex, &e_163, mul(splat(4.0f32), slack_61), 0.0f32);
        let e_168 = path_from(r, &e_162, e_167);
        path_v2 = sel_path(ex, &e_168, &path_v2);
    }
    ex = b4;
    let e_169 = path_v2;
    return e_169;
} }
lanes! { fn surface_facets_segment(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, k_a2: u32, params_a3: Vec4<f32>) -> Path {
    let mut ex = within;
    let mut ret: Path = zero_path();
    let e_4 = plane_normal(r, pixel_a0);
    let e_5 = triangle_distance(r, ex, pixel_a0, e_4);
    let start_8 = mul(e_5, sqrt(add(add(mul(pixel_a0.direction.x, pixel_a0.direction.x), mul(pixel_a0.direction.y, pixel_a0.direction.y)), mul(pixel_a0.direction.z, pixel_a0.direction.z))));
    let height_11 = height_at_ll(r, ex, Vec2 { x: at_a1.uv.x, y: at_a1.uv.y }, at_a1.level);
    let duv_14 = Vec2 { x: 0.0f32, y: 0.0f32 };
    let h_17 = Vec3 { x: height_11, y: splat(0.0f32), z: splat(0.0f32) };
    return Path { uv: Vec2 { x: at_a1.uv.x, y: at_a1.uv.y }, duv: Vec2 { x: splat(duv_14.x), y: splat(duv_14.y) }, h: h_17, exit: splat(1.0f32), base: splat(0.0f32), metric: Vec4 { x: at_a1.metric.x, y: at_a1.metric.y, z: at_a1.metric.z, w: at_a1.metric.w }, ray: splat_u(0u32), level: at_a1.level, start: start_8, share: splat(1.0f32), bend: splat(0.0f32), };
} }
lanes! { fn slice_inside(r: &Resources<'_>, map_a0: F, slice_a1: F, spacing_a2: F, params_a3: Vec4<f32>) -> M {
    return gt(map_a0, slice_a1);
} }
lanes! { fn slice_at_least(r: &Resources<'_>, map_a0: F, slice_a1: F, spacing_a2: F, params_a3: Vec4<f32>) -> M {
    return ge(map_a0, slice_a1);
} }
lanes! { fn slice_band(r: &Resources<'_>, map_a0: F, slice_a1: F, spacing_a2: F, params_a3: Vec4<f32>) -> M {
    return le(abs(sub(map_a0, slice_a1)), mul(splat(0.5f32), spacing_a2));
} }
lanes! { fn slices_stage(r: &Resources<'_>, map_a0: F, slice_a1: F, spacing_a2: F) -> M {
    match r.surface_settings.choices[2].number {
        0u32 => {
            let e_13 = slice_inside(r, map_a0, slice_a1, spacing_a2, r.surface_settings.choices[2].params);
            return e_13;
        }
        1u32 => {
            let e_19 = slice_at_least(r, map_a0, slice_a1, spacing_a2, r.surface_settings.choices[2].params);
            return e_19;
        }
        _ => {
            let e_25 = slice_band(r, map_a0, slice_a1, spacing_a2, r.surface_settings.choices[2].params);
            return e_25;
        }
    }
} }
lanes! { fn slice_spacing(r: &Resources<'_>, at_a0: &Entered, axis_a1: u32) -> F {
    if (axis_a1 == 0u32) {
        return at_a0.of_surface.y;
    }
    if (axis_a1 == 1u32) {
        let e_12 = r.traced_scale_m();
        return div(mul(at_a0.of_surface.y, sqrt(at_a0.metric.x)), splat(e_12));
    }
    if (axis_a1 == 2u32) {
        let e_20 = r.traced_scale_m();
        return div(mul(at_a0.of_surface.y, sqrt(at_a0.metric.z)), splat(e_20));
    }
    let e_22 = r.traced_scale_m();
    return div(at_a0.of_surface.y, splat(e_22));
} }
lanes! { fn slice_above(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, along_a2: F, far_a3: F) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let mut both_v0: M = splat_m(false);
    let upward_14 = mul(sel(lt(add(add(add(mul(pixel_a0.direction.x, at_a1.normal.x), mul(pixel_a0.direction.y, at_a1.normal.y)), mul(pixel_a0.direction.z, at_a1.normal.z)), splat(0.0f32)), splat(0.0f32)), splat(1.0f32), splat((-1.0f32))), at_a1.of_surface.y);
    let step_m_18 = mul(upward_14, splat(r.surface_settings.scale_m));
    let a_24 = Vec3 { x: add(splat(pixel_a0.a.position.x), mul(splat(pixel_a0.a.normal.x), step_m_18)), y: add(splat(pixel_a0.a.position.y), mul(splat(pixel_a0.a.normal.y), step_m_18)), z: add(splat(pixel_a0.a.position.z), mul(splat(pixel_a0.a.normal.z), step_m_18)) };
    let b_30 = Vec3 { x: add(splat(pixel_a0.b.position.x), mul(splat(pixel_a0.b.normal.x), step_m_18)), y: add(splat(pixel_a0.b.position.y), mul(splat(pixel_a0.b.normal.y), step_m_18)), z: add(splat(pixel_a0.b.position.z), mul(splat(pixel_a0.b.normal.z), step_m_18)) };
    let c_36 = Vec3 { x: add(splat(pixel_a0.c.position.x), mul(splat(pixel_a0.c.normal.x), step_m_18)), y: add(splat(pixel_a0.c.position.y), mul(splat(pixel_a0.c.normal.y), step_m_18)), z: add(splat(pixel_a0.c.position.z), mul(splat(pixel_a0.c.normal.z), step_m_18)) };
    let e_37 = Vec3 { x: sub(b_30.x, a_24.x), y: sub(b_30.y, a_24.y), z: sub(b_30.z, a_24.z) };
    let e_38 = Vec3 { x: sub(c_36.x, a_24.x), y: sub(c_36.y, a_24.y), z: sub(c_36.z, a_24.z) };
    let n_39 = Vec3 { x: sub(mul(e_37.y, e_38.z), mul(e_37.z, e_38.y)), y: sub(mul(e_37.z, e_38.x), mul(e_37.x, e_38.z)), z: sub(mul(e_37.x, e_38.y), mul(e_37.y, e_38.x)) };
    let t_45 = div(add(add(add(mul(n_39.x, sub(a_24.x, pixel_a0.origin.x)), mul(n_39.y, sub(a_24.y, pixel_a0.origin.y))), mul(n_39.z, sub(a_24.z, pixel_a0.origin.z))), splat(0.0f32)), add(add(add(mul(n_39.x, pixel_a0.direction.x), mul(n_39.y, pixel_a0.direction.y)), mul(n_39.z, pixel_a0.direction.z)), splat(0.0f32)));
    let lead_47 = sub(far_a3, mul(t_45, along_a2));
    both_v0 = and(gt(lead_47, mul(far_a3, splat(5e-7f32))), le(abs(t_45), splat(1000000000.0f32)));
    let e_57 = both_v0;
    let c1 = not(e_57);
    ret = Vec4 { x: splat(0.0f32), y: splat(0.0f32), z: splat(0.0f32), w: splat(0.0f32) };
    ex = and_not(ex, c1);
    if none(ex) { return ret; }
    let w_68 = weights_of(r, a_24, b_30, c_36, n_39, Vec3 { x: add(pixel_a0.origin.x, mul(pixel_a0.direction.x, t_45)), y: add(pixel_a0.origin.y, mul(pixel_a0.direction.y, t_45)), z: add(pixel_a0.origin.z, mul(pixel_a0.direction.z, t_45)) });
    let aside_84 = Vec2 { x: sub(add(add(mul(splat(pixel_a0.a.uv.x), w_68.x), mul(splat(pixel_a0.b.uv.x), w_68.y)), mul(splat(pixel_a0.c.uv.x), w_68.z)), at_a1.uv.x), y: sub(add(add(mul(splat(pixel_a0.a.uv.y), w_68.x), mul(splat(pixel_a0.b.uv.y), w_68.y)), mul(splat(pixel_a0.c.uv.y), w_68.z)), at_a1.uv.y) };
    let y2 = Vec4 { x: div(aside_84.x, lead_47), y: div(aside_84.y, lead_47), z: div(upward_14, lead_47), w: lead_47 };
    return Vec4 { x: sel(ex, y2.x, ret.x), y: sel(ex, y2.y, ret.y), z: sel(ex, y2.z, ret.z), w: sel(ex, y2.w, ret.w) };
} }
lanes! { fn slice_beside(r: &Resources<'_>, within: M, at_a0: &Entered, climbs_a1: Vec3<F>, pace_a2: F) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let mut both_v0: M = splat_m(false);
    let up_15 = div(sel(lt(climbs_a1.z, splat(0.0f32)), sub(splat(1.0f32), at_a0.of_surface.x), at_a0.of_surface.x), abs(climbs_a1.z));
    let lead_25 = min(div(at_a0.of_surface.y, pace_a2), sel(gt(abs(climbs_a1.z), splat(0.0f32)), up_15, splat(1000000000.0f32)));
    both_v0 = and(gt(lead_25, splat(0.0f32)), le(lead_25, splat(1000000000.0f32)));
    let e_33 = both_v0;
    let c1 = not(e_33);
    ret = Vec4 { x: splat(0.0f32), y: splat(0.0f32), z: splat(0.0f32), w: splat(0.0f32) };
    ex = and_not(ex, c1);
    let y2 = Vec4 { x: sub(splat(0.0f32), climbs_a1.x), y: sub(splat(0.0f32), climbs_a1.y), z: sub(splat(0.0f32), climbs_a1.z), w: lead_25 };
    return Vec4 { x: sel(ex, y2.x, ret.x), y: sel(ex, y2.y, ret.y), z: sel(ex, y2.z, ret.z), w: sel(ex, y2.w, ret.w) };
} }
lanes! { fn slice_before(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, axis_a2: u32, along_a3: F, far_a4: F) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    if (axis_a2 == 0u32) {
        let e_7 = slice_above(r, ex, pixel_a0, at_a1, along_a3, far_a4);
        return e_7;
    }
    let climbs_11 = climb(r, at_a1, Vec3 { x: div(pixel_a0.direction.x, along_a3), y: div(pixel_a0.direction.y, along_a3), z: div(pixel_a0.direction.z, along_a3) });
    if (axis_a2 == 1u32) {
        let e_16 = slice_beside(r, ex, at_a1, climbs_11, abs(climbs_11.x));
        return e_16;
    }
    if (axis_a2 == 2u32) {
        let e_21 = slice_beside(r, ex, at_a1, climbs_11, abs(climbs_11.y));
        return e_21;
    }
    let e_24 = slice_beside(r, ex, at_a1, climbs_11, div(splat(1.0f32), along_a3));
    return e_24;
} }
lanes! { fn surface_slices_segment(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, k_a2: u32, params_a3: Vec4<f32>) -> Path {
    let mut ex = within;
    let mut ret: Path = zero_path();
    let along_5 = sqrt(add(add(mul(pixel_a0.direction.x, pixel_a0.direction.x), mul(pixel_a0.direction.y, pixel_a0.direction.y)), mul(pixel_a0.direction.z, pixel_a0.direction.z)));
    let e_6 = plane_normal(r, pixel_a0);
    let e_7 = triangle_distance(r, ex, pixel_a0, e_6);
    let far_8 = mul(e_7, along_5);
    let axis_12 = (pixel_a0.a.of_surface.z as u32);
    let e_17 = height_at_ll(r, ex, Vec2 { x: at_a1.uv.x, y: at_a1.uv.y }, at_a1.level);
    let e_18 = slice_spacing(r, at_a1, axis_12);
    let passes_19 = slices_stage(r, e_17, at_a1.of_surface.x, e_18);
    let before_20 = slice_before(r, ex, pixel_a0, at_a1, axis_12, along_5, far_8);
    let lead_28 = sel(gt(before_20.w, splat(0.0f32)), min(before_20.w, far_8), mul(far_8, splat(5e-7f32)));
    return Path { uv: Vec2 { x: add(at_a1.uv.x, mul(before_20.x, lead_28)), y: add(at_a1.uv.y, mul(before_20.y, lead_28)) }, duv: Vec2 { x: sub(splat(0.0f32), before_20.x), y: sub(splat(0.0f32), before_20.y) }, h: Vec3 { x: add(at_a1.of_surface.x, mul(before_20.z, lead_28)), y: sub(splat(0.0f32), before_20.z), z: splat(0.0f32) }, exit: sel(passes_19, lead_28, splat(0.0f32)), base: lead_28, metric: Vec4 { x: at_a1.metric.x, y: at_a1.metric.y, z: at_a1.metric.z, w: at_a1.metric.w }, ray: splat_u(0u32), level: at_a1.level, start: sub(far_8, lead_28), share: splat(1.0f32), bend: splat(0.0f32), };
} }
lanes! { fn within_bounds(r: &Resources<'_>, within: M, x_a0: F, dx_a1: F, low_a2: F, high_a3: F, interval_a4: Vec2<F>) -> Vec2<F> {
    let mut ex = within;
    let mut ret: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    let mut both_v0: M = splat_m(false);
    let (b1, c2) = (ex, eq(dx_a1, splat(0.0f32)));
    ex = and(b1, c2);
    if any(ex) {
        both_v0 = or(lt(x_a0, low_a2), gt(x_a0, high_a3));
        let e_13 = both_v0;
        let (b3, c4) = (ex, e_13);
        ex = and(b3, c4);
        if any(ex) {
            ret = Vec2 { x: splat(3e38f32), y: splat(0.0f32) };
            ex = no_lane();
        }
        ex = and_not(b3, c4);
        let y5 = interval_a4;
        ret = Vec2 { x: sel(ex, y5.x, ret.x), y: sel(ex, y5.y, ret.y) };
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    let a_18 = div(sub(low_a2, x_a0), dx_a1);
    let b_20 = div(sub(high_a3, x_a0), dx_a1);
    let y6 = Vec2 { x: max(interval_a4.x, min(a_18, b_20)), y: min(interval_a4.y, max(a_18, b_20)) };
    return Vec2 { x: sel(ex, y6.x, ret.x), y: sel(ex, y6.y, ret.y) };
} }
lanes! { fn metric_of_image(r: &Resources<'_>, image_a0: &Image, depth_a1: F) -> Vec4<F> {
    let e_2 = tangent_of_image(r, image_a0);
    let tangent_3 = Vec3 { x: mul(e_2.x, depth_a1), y: mul(e_2.y, depth_a1), z: mul(e_2.z, depth_a1) };
    let e_4 = bitangent_of_image(r, image_a0);
    let bitangent_5 = Vec3 { x: mul(e_4.x, depth_a1), y: mul(e_4.y, depth_a1), z: mul(e_4.z, depth_a1) };
    return Vec4 { x: add(add(add(mul(tangent_3.x, tangent_3.x), mul(tangent_3.y, tangent_3.y)), mul(tangent_3.z, tangent_3.z)), splat(0.0f32)), y: add(add(add(mul(tangent_3.x, bitangent_5.x), mul(tangent_3.y, bitangent_5.y)), mul(tangent_3.z, bitangent_5.z)), splat(0.0f32)), z: add(add(add(mul(bitangent_5.x, bitangent_5.x), mul(bitangent_5.y, bitangent_5.y)), mul(bitangent_5.z, bitangent_5.z)), splat(0.0f32)), w: splat(r.surface_settings.scale_m) };
} }
lanes! { fn path_through_image_ll(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, k_a1: U) -> Path {
    let mut ex = within;
    let mut ret: Path = zero_path();
    let mut begin_v0: F = splat(0.0f32);
    let mut both_v1: M = splat_m(false);
    let mut interval_v2: Vec2<F> = Vec2 { x: splat(0.0f32), y: splat(3e38f32) };
    let mut height_v3: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let length1 = sqrt(add(add(mul(pixel_a0.direction.x, pixel_a0.direction.x), mul(pixel_a0.direction.y, pixel_a0.direction.y)), mul(pixel_a0.direction.z, pixel_a0.direction.z)));
    let along_3 = Vec3 { x: div(pixel_a0.direction.x, length1), y: div(pixel_a0.direction.y, length1), z: div(pixel_a0.direction.z, length1) };
    let image_4 = image_of_object_l(r, ex, k_a1);
    let deepens_7 = add(add(add(mul(image_4.depth.x, along_3.x), mul(image_4.depth.y, along_3.y)), mul(image_4.depth.z, along_3.z)), splat(0.0f32));
    let before_9 = depth_in_image(r, &image_4, Vec3 { x: pixel_a0.origin.x, y: pixel_a0.origin.y, z: pixel_a0.origin.z });
    let (b2, c3) = (ex, image_4.has_eye);
    ex = and(b2, c3);
    if any(ex) {
        let nearest_15 = mul(splat(0.01f32), image_4.nearest);
        begin_v0 = sel(ex, sel(lt(before_9, nearest_15), splat(3e38f32), splat(0.0f32)), begin_v0);
        both_v1 = and(lt(before_9, nearest_15), gt(deepens_7, splat(0.0f32)));
        let e_26 = both_v1;
        let c4 = e_26;
        begin_v0 = sel(and(ex, c4), div(sub(nearest_15, before_9), deepens_7), begin_v0);
    }
    ex = b2;
    let e_30 = begin_v0;
    let origin_32 = Vec3 { x: add(pixel_a0.origin.x, mul(along_3.x, e_30)), y: add(pixel_a0.origin.y, mul(along_3.y, e_30)), z: add(pixel_a0.origin.z, mul(along_3.z, e_30)) };
    let depth_33 = depth_in_image(r, &image_4, origin_32);
    let bend_34 = div(deepens_7, depth_33);
    let u_41 = div(add(add(add(add(mul(image_4.u.x, origin_32.x), mul(image_4.u.y, origin_32.y)), mul(image_4.u.z, origin_32.z)), splat(0.0f32)), image_4.u.w), depth_33);
    let v_48 = div(add(add(add(add(mul(image_4.v.x, origin_32.x), mul(image_4.v.y, origin_32.y)), mul(image_4.v.z, origin_32.z)), splat(0.0f32)), image_4.v.w), depth_33);
    let h_55 = div(add(add(add(add(mul(image_4.height.x, origin_32.x), mul(image_4.height.y, origin_32.y)), mul(image_4.height.z, origin_32.z)), splat(0.0f32)), image_4.height.w), depth_33);
    let du_61 = div(sub(add(add(add(mul(image_4.u.x, along_3.x), mul(image_4.u.y, along_3.y)), mul(image_4.u.z, along_3.z)), splat(0.0f32)), mul(u_41, deepens_7)), depth_33);
    let dv_67 = div(sub(add(add(add(mul(image_4.v.x, along_3.x), mul(image_4.v.y, along_3.y)), mul(image_4.v.z, along_3.z)), splat(0.0f32)), mul(v_48, deepens_7)), depth_33);
    let dh_73 = div(sub(add(add(add(mul(image_4.height.x, along_3.x), mul(image_4.height.y, along_3.y)), mul(image_4.height.z, along_3.z)), splat(0.0f32)), mul(h_55, deepens_7)), depth_33);
    let beyond_74 = beyond_image(r, &image_4);
    let e_85 = interval_v2;
    let e_86 = within_bounds(r, ex, u_41, du_61, sub(splat(0.0f32), beyond_74.x), add(splat(1.0f32), beyond_74.x), e_85);
    interval_v2 = e_86;
    let e_93 = interval_v2;
    let e_94 = within_bounds(r, ex, v_48, dv_67, sub(splat(0.0f32), beyond_74.y), add(splat(1.0f32), beyond_74.y), e_93);
    interval_v2 = e_94;
    let e_97 = interval_v2;
    let e_98 = within_bounds(r, ex, h_55, dh_73, splat(1e-5f32), splat(1.0f32), e_97);
    interval_v2 = e_98;
    let start_100 = interval_v2.x;
    let nearer_103 = sub(splat(1.0f32), mul(bend_34, start_100));
    let change_104 = mul(nearer_103, nearer_103);
    height_v3 = Vec3 { x: add(h_55, mul(dh_73, start_100)), y: mul(dh_73, change_104), z: splat(0.0f32) };
    if (r.surface_settings.cells == 4u32) {
        height_v3 = Vec3 { x: splat(0.5f32), y: splat(0.0f32), z: splat(0.0f32) };
    }
    let e_133 = height_v3;
    let e_135 = interval_v2.y;
    let e_140 = metric_of_image(r, &image_4, div(depth_33, nearer_103));
    let e_143 = begin_v0;
    return Path { uv: Vec2 { x: add(image_4.corner.x, mul(image_4.extent.x, add(u_41, mul(du_61, start_100)))), y: add(image_4.corner.y, mul(image_4.extent.y, add(v_48, mul(dv_67, start_100)))) }, duv: Vec2 { x: mul(mul(image_4.extent.x, du_61), change_104), y: mul(mul(image_4.extent.y, dv_67), change_104) }, h: e_133, exit: div(sub(e_135, start_100), change_104), base: f_of_u(k_a1), metric: e_140, ray: splat_u(0u32), level: splat_u(0u32), start: add(e_143, div(start_100, nearer_103)), share: splat(1.0f32), bend: mul(bend_34, nearer_103), };
} }
lanes! { fn path_through_image_ls(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, k_a1: u32) -> Path {
    let mut ex = within;
    let mut ret: Path = zero_path();
    let mut begin_v0: F = splat(0.0f32);
    let mut both_v1: M = splat_m(false);
    let mut interval_v2: Vec2<F> = Vec2 { x: splat(0.0f32), y: splat(3e38f32) };
    let mut height_v3: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let length1 = sqrt(add(add(mul(pixel_a0.direction.x, pixel_a0.direction.x), mul(pixel_a0.direction.y, pixel_a0.direction.y)), mul(pixel_a0.direction.z, pixel_a0.direction.z)));
    let along_3 = Vec3 { x: div(pixel_a0.direction.x, length1), y: div(pixel_a0.direction.y, length1), z: div(pixel_a0.direction.z, length1) };
    let image_4 = image_of_object_s(r, ex, k_a1);
    let deepens_7 = add(add(add(mul(image_4.depth.x, along_3.x), mul(image_4.depth.y, along_3.y)), mul(image_4.depth.z, along_3.z)), splat(0.0f32));
    let before_9 = depth_in_image(r, &image_4, Vec3 { x: pixel_a0.origin.x, y: pixel_a0.origin.y, z: pixel_a0.origin.z });
    let (b2, c3) = (ex, image_4.has_eye);
    ex = and(b2, c3);
    if any(ex) {
        let nearest_15 = mul(splat(0.01f32), image_4.nearest);
        begin_v0 = sel(ex, sel(lt(before_9, nearest_15), splat(3e38f32), splat(0.0f32)), begin_v0);
        both_v1 = and(lt(before_9, nearest_15), gt(deepens_7, splat(0.0f32)));
        let e_26 = both_v1;
        let c4 = e_26;
        begin_v0 = sel(and(ex, c4), div(sub(nearest_15, before_9), deepens_7), begin_v0);
    }
    ex = b2;
    let e_30 = begin_v0;
    let origin_32 = Vec3 { x: add(pixel_a0.origin.x, mul(along_3.x, e_30)), y: add(pixel_a0.origin.y, mul(along_3.y, e_30)), z: add(pixel_a0.origin.z, mul(along_3.z, e_30)) };
    let depth_33 = depth_in_image(r, &image_4, origin_32);
    let bend_34 = div(deepens_7, depth_33);
    let u_41 = div(add(add(add(add(mul(image_4.u.x, origin_32.x), mul(image_4.u.y, origin_32.y)), mul(image_4.u.z, origin_32.z)), splat(0.0f32)), image_4.u.w), depth_33);
    let v_48 = div(add(add(add(add(mul(image_4.v.x, origin_32.x), mul(image_4.v.y, origin_32.y)), mul(image_4.v.z, origin_32.z)), splat(0.0f32)), image_4.v.w), depth_33);
    let h_55 = div(add(add(add(add(mul(image_4.height.x, origin_32.x), mul(image_4.height.y, origin_32.y)), mul(image_4.height.z, origin_32.z)), splat(0.0f32)), image_4.height.w), depth_33);
    let du_61 = div(sub(add(add(add(mul(image_4.u.x, along_3.x), mul(image_4.u.y, along_3.y)), mul(image_4.u.z, along_3.z)), splat(0.0f32)), mul(u_41, deepens_7)), depth_33);
    let dv_67 = div(sub(add(add(add(mul(image_4.v.x, along_3.x), mul(image_4.v.y, along_3.y)), mul(image_4.v.z, along_3.z)), splat(0.0f32)), mul(v_48, deepens_7)), depth_33);
    let dh_73 = div(sub(add(add(add(mul(image_4.height.x, along_3.x), mul(image_4.height.y, along_3.y)), mul(image_4.height.z, along_3.z)), splat(0.0f32)), mul(h_55, deepens_7)), depth_33);
    let beyond_74 = beyond_image(r, &image_4);
    let e_85 = interval_v2;
    let e_86 = within_bounds(r, ex, u_41, du_61, sub(splat(0.0f32), beyond_74.x), add(splat(1.0f32), beyond_74.x), e_85);
    interval_v2 = e_86;
    let e_93 = interval_v2;
    let e_94 = within_bounds(r, ex, v_48, dv_67, sub(splat(0.0f32), beyond_74.y), add(splat(1.0f32), beyond_74.y), e_93);
    interval_v2 = e_94;
    let e_97 = interval_v2;
    let e_98 = within_bounds(r, ex, h_55, dh_73, splat(1e-5f32), splat(1.0f32), e_97);
    interval_v2 = e_98;
    let start_100 = interval_v2.x;
    let nearer_103 = sub(splat(1.0f32), mul(bend_34, start_100));
    let change_104 = mul(nearer_103, nearer_103);
    height_v3 = Vec3 { x: add(h_55, mul(dh_73, start_100)), y: mul(dh_73, change_104), z: splat(0.0f32) };
    if (r.surface_settings.cells == 4u32) {
        height_v3 = Vec3 { x: splat(0.5f32), y: splat(0.0f32), z: splat(0.0f32) };
    }
    let e_133 = height_v3;
    let e_135 = interval_v2.y;
    let e_140 = metric_of_image(r, &image_4, div(depth_33, nearer_103));
    let e_143 = begin_v0;
    return Path { uv: Vec2 { x: add(image_4.corner.x, mul(image_4.extent.x, add(u_41, mul(du_61, start_100)))), y: add(image_4.corner.y, mul(image_4.extent.y, add(v_48, mul(dv_67, start_100)))) }, duv: Vec2 { x: mul(mul(image_4.extent.x, du_61), change_104), y: mul(mul(image_4.extent.y, dv_67), change_104) }, h: e_133, exit: div(sub(e_135, start_100), change_104), base: splat((k_a1 as f32)), metric: e_140, ray: splat_u(0u32), level: splat_u(0u32), start: add(e_143, div(start_100, nearer_103)), share: splat(1.0f32), bend: mul(bend_34, nearer_103), };
} }
lanes! { fn surface_object_segment(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, k_a2: u32, params_a3: Vec4<f32>) -> Path {
    let mut ex = within;
    let mut ret: Path = zero_path();
    let e_4 = path_through_image_ls(r, ex, pixel_a0, k_a2);
    return e_4;
} }
lanes! { fn surface_frames_segment(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, k_a2: u32, params_a3: Vec4<f32>) -> Path {
    let mut ex = within;
    let mut ret: Path = zero_path();
    let length1 = sqrt(add(add(mul(pixel_a0.direction.x, pixel_a0.direction.x), mul(pixel_a0.direction.y, pixel_a0.direction.y)), mul(pixel_a0.direction.z, pixel_a0.direction.z)));
    let e_5 = Vec3 { x: div(pixel_a0.direction.x, length1), y: div(pixel_a0.direction.y, length1), z: div(pixel_a0.direction.z, length1) };
    let e_7 = frames_around(r, ex, Vec3 { x: neg(e_5.x), y: neg(e_5.y), z: neg(e_5.z) });
    let e_8 = frame_number(r, &e_7, k_a2);
    let e_9 = path_through_image_ll(r, ex, pixel_a0, e_8);
    return e_9;
} }
lanes! { fn on_image(r: &Resources<'_>, within: M, image_a0: &Image, point_a1: Vec3<F>) -> OnImage {
    let mut ex = within;
    let mut ret: OnImage = zero_on_image();
    let mut both_v0: M = splat_m(false);
    let mut both_v1: M = splat_m(false);
    let mut both_v2: M = splat_m(false);
    let depth_2 = depth_in_image(r, image_a0, point_a1);
    let u_9 = div(add(add(add(add(mul(image_a0.u.x, point_a1.x), mul(image_a0.u.y, point_a1.y)), mul(image_a0.u.z, point_a1.z)), splat(0.0f32)), image_a0.u.w), depth_2);
    let v_16 = div(add(add(add(add(mul(image_a0.v.x, point_a1.x), mul(image_a0.v.y, point_a1.y)), mul(image_a0.v.z, point_a1.z)), splat(0.0f32)), image_a0.v.w), depth_2);
    let h_23 = div(add(add(add(add(mul(image_a0.height.x, point_a1.x), mul(image_a0.height.y, point_a1.y)), mul(image_a0.height.z, point_a1.z)), splat(0.0f32)), image_a0.height.w), depth_2);
    let beyond_24 = beyond_image(r, image_a0);
    let beside_35 = max(sub(abs(sub(u_9, splat(0.5f32))), beyond_24.x), sub(abs(sub(v_16, splat(0.5f32))), beyond_24.y));
    let uv_40 = Vec2 { x: add(image_a0.corner.x, mul(image_a0.extent.x, u_9)), y: add(image_a0.corner.y, mul(image_a0.extent.y, v_16)) };
    let e_42 = height_size(r, splat_u(0u32));
    let e_49 = object_parts_stage(r, splat_u(0u32));
    let e_50 = f_of_i(e_49);
    let at_51 = Vec2 { x: mul(sub(mul(uv_40.x, e_42.x), splat(0.5f32)), e_50), y: mul(sub(mul(uv_40.y, e_42.y), splat(0.5f32)), e_50) };
    let cell_52 = cell_of(r, at_51);
    let part_53 = Vec2 { x: sub(at_51.x, cell_52.x), y: sub(at_51.y, cell_52.y) };
    let heights_56 = object_cell_stage_ls(r, ex, Vec2 { x: i_of_small(cell_52.x), y: i_of_small(cell_52.y) }, 0u32);
    let top_63 = add(heights_56.x, mul(sub(heights_56.y, heights_56.x), part_53.x));
    let bottom_70 = add(heights_56.z, mul(sub(heights_56.w, heights_56.z), part_53.x));
    let map_74 = add(top_63, mul(sub(bottom_70, top_63), part_53.y));
    both_v0 = and(gt(depth_2, splat(0.0f32)), le(beside_35, splat(0.5f32)));
    let e_82 = both_v0;
    both_v1 = and(e_82, gt(h_23, splat(1e-5f32)));
    let e_88 = both_v1;
    both_v2 = and(e_88, le(h_23, splat(1.0f32)));
    let is_inside_94 = both_v2;
    return OnImage { uv: uv_40, height: sel(splat_m((r.surface_settings.cells == 4u32)), splat(0.5f32), h_23), map: map_74, is_inside: is_inside_94, };
} }
lanes! { fn is_in_image(r: &Resources<'_>, within: M, at_a0: &OnImage) -> M {
    let mut ex = within;
    let mut ret: M = splat_m(false);
    let mut both_v0: M = splat_m(false);
    let (b1, c2) = (ex, at_a0.is_inside);
    ex = and(b1, c2);
    if any(ex) {
        let e_7 = slices_stage(r, at_a0.map, at_a0.height, splat(0.0f32));
        both_v0 = sel_m(ex, e_7, both_v0);
    }
    ex = and_not(b1, c2);
    if any(ex) {
        both_v0 = sel_m(ex, splat_m(false), both_v0);
    }
    ex = b1;
    let e_9 = both_v0;
    return e_9;
} }
lanes! { fn with_image(r: &Resources<'_>, within: M, slice_a0: &OnSlice, number_a1: U, point_a2: Vec3<F>) -> OnSlice {
    let mut ex = within;
    let mut ret: OnSlice = zero_on_slice();
    let e_3 = image_of_object_l(r, ex, number_a1);
    let at_4 = on_image(r, ex, &e_3, point_a2);
    let over_7 = sub(at_4.map, at_4.height);
    let passes_8 = is_in_image(r, ex, &at_4);
    let (b1, c2) = (ex, lt(over_7, slice_a0.over));
    ex = and(b1, c2);
    if any(ex) {
        ret = OnSlice { passes: passes_8, number: number_a1, nearest: at_4, over: over_7, };
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    return sel_on_slice(ex, &OnSlice { passes: passes_8, number: slice_a0.number, nearest: slice_a0.nearest, over: slice_a0.over, }, &ret);
} }
stage! { fn slice_at(r: &Resources<'_>, within: M, point_a0: Vec3<F>) -> OnSlice {
    let mut ex = within;
    let mut ret: OnSlice = zero_on_slice();
    let mut slice_v0: OnSlice = OnSlice { passes: splat_m(true), number: splat_u(0u32), nearest: OnImage { uv: Vec2 { x: splat(0.0f32), y: splat(0.0f32) }, height: splat(0.0f32), map: splat(0.0f32), is_inside: splat_m(false), }, over: splat(2.0f32), };
    let mut number_v1: U = splat_u(0u32);
    let mut both_v2: M = splat_m(false);
    let b2 = ex;
    'l1: loop {
        let e_15 = number_v1;
        let e_23 = slice_v0.passes;
        both_v2 = and(lt_u(e_15, splat_u(r.surface_settings.solids)), e_23);
        let e_25 = both_v2;
        let c3 = e_25;
        ex = and(ex, c3);
        let e_26 = slice_v0;
        let e_27 = number_v1;
        if none(ex) { break 'l1; }
        let e_28 = with_image(r, ex, &e_26, e_27, point_a0);
        slice_v0 = sel_on_slice(ex, &e_28, &slice_v0);
        let e_29 = number_v1;
        number_v1 = add_u(e_29, splat_u(1u32));
    }
    ex = b2;
    let e_32 = slice_v0;
    return e_32;
} }
lanes! { fn surface_object_slices_segment(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, k_a2: u32, params_a3: Vec4<f32>) -> Path {
    let mut ex = within;
    let mut ret: Path = zero_path();
    let slice_5 = slice_at(r, ex, Vec3 { x: at_a1.point.x, y: at_a1.point.y, z: at_a1.point.z });
    let image_7 = image_of_object_l(r, ex, slice_5.number);
    let e_10 = Vec3 { x: sub(at_a1.point.x, pixel_a0.origin.x), y: sub(at_a1.point.y, pixel_a0.origin.y), z: sub(at_a1.point.z, pixel_a0.origin.z) };
    let far_11 = sqrt(add(add(mul(e_10.x, e_10.x), mul(e_10.y, e_10.y)), mul(e_10.z, e_10.z)));
    let lead_13 = mul(far_11, splat(5e-7f32));
    let e_28 = depth_in_image(r, &image_7, Vec3 { x: at_a1.point.x, y: at_a1.point.y, z: at_a1.point.z });
    let e_29 = metric_of_image(r, &image_7, e_28);
    return Path { uv: Vec2 { x: slice_5.nearest.uv.x, y: slice_5.nearest.uv.y }, duv: Vec2 { x: splat(0.0f32), y: splat(0.0f32) }, h: Vec3 { x: slice_5.nearest.height, y: splat(0.0f32), z: splat(0.0f32) }, exit: sel(slice_5.passes, lead_13, splat(0.0f32)), base: lead_13, metric: e_29, ray: splat_u(0u32), level: splat_u(0u32), start: sub(far_11, lead_13), share: splat(1.0f32), bend: splat(0.0f32), };
} }
lanes! { fn surface_segment_stage(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, k_a2: u32) -> Path {
    let mut ex = within;
    let mut ret: Path = zero_path();
    match r.surface_settings.choices[1].number {
        0u32 => {
            let e_13 = surface_plane_segment(r, ex, pixel_a0, at_a1, k_a2, r.surface_settings.choices[1].params);
            return e_13;
        }
        1u32 => {
            let e_19 = surface_prism_segment(r, ex, pixel_a0, at_a1, k_a2, r.surface_settings.choices[1].params);
            return e_19;
        }
        2u32 => {
            let e_25 = surface_quadric_perpendicular_segment(r, ex, pixel_a0, at_a1, k_a2, r.surface_settings.choices[1].params);
            return e_25;
        }
        3u32 => {
            let e_31 = surface_quadric_vertical_segment(r, ex, pixel_a0, at_a1, k_a2, r.surface_settings.choices[1].params);
            return e_31;
        }
        4u32 => {
            let e_37 = surface_tetrahedra_segment(r, ex, pixel_a0, at_a1, k_a2, r.surface_settings.choices[1].params);
            return e_37;
        }
        5u32 => {
            let e_43 = surface_facets_segment(r, ex, pixel_a0, at_a1, k_a2, r.surface_settings.choices[1].params);
            return e_43;
        }
        6u32 => {
            let e_49 = surface_slices_segment(r, ex, pixel_a0, at_a1, k_a2, r.surface_settings.choices[1].params);
            return e_49;
        }
        7u32 => {
            let e_55 = surface_object_segment(r, ex, pixel_a0, at_a1, k_a2, r.surface_settings.choices[1].params);
            return e_55;
        }
        8u32 => {
            let e_61 = surface_frames_segment(r, ex, pixel_a0, at_a1, k_a2, r.surface_settings.choices[1].params);
            return e_61;
        }
        _ => {
            let e_67 = surface_object_slices_segment(r, ex, pixel_a0, at_a1, k_a2, r.surface_settings.choices[1].params);
            return e_67;
        }
    }
} }
stage! { pub(super) fn segment_of(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, k_a2: u32) -> Path {
    let mut ex = within;
    let mut ret: Path = zero_path();
    let e_3 = surface_segment_stage(r, ex, pixel_a0, at_a1, k_a2);
    let e_5 = faded(r, ex, &e_3, at_a1.fade);
    return e_5;
} }
lanes! { fn surface_plane_polish(r: &Resources<'_>, pixel_a0: &PixelIn, at_a1: &Entered, path_a2: &Path, hit_a3: &Hit, params_a4: Vec4<f32>) -> Hit {
    return *hit_a3;
} }
lanes! { fn weights_at_offset(r: &Resources<'_>, within: M, prism_a0: &Prism, place_a1: Vec3<F>, offset_a2: F) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let corner_6 = Vec3 { x: add(prism_a0.p0.x, mul(prism_a0.n0.x, offset_a2)), y: add(prism_a0.p0.y, mul(prism_a0.n0.y, offset_a2)), z: add(prism_a0.p0.z, mul(prism_a0.n0.z, offset_a2)) };
    let a_14 = Vec3 { x: add(sub(prism_a0.p1.x, prism_a0.p0.x), mul(sub(prism_a0.n1.x, prism_a0.n0.x), offset_a2)), y: add(sub(prism_a0.p1.y, prism_a0.p0.y), mul(sub(prism_a0.n1.y, prism_a0.n0.y), offset_a2)), z: add(sub(prism_a0.p1.z, prism_a0.p0.z), mul(sub(prism_a0.n1.z, prism_a0.n0.z), offset_a2)) };
    let b_22 = Vec3 { x: add(sub(prism_a0.p2.x, prism_a0.p0.x), mul(sub(prism_a0.n2.x, prism_a0.n0.x), offset_a2)), y: add(sub(prism_a0.p2.y, prism_a0.p0.y), mul(sub(prism_a0.n2.y, prism_a0.n0.y), offset_a2)), z: add(sub(prism_a0.p2.z, prism_a0.p0.z), mul(sub(prism_a0.n2.z, prism_a0.n0.z), offset_a2)) };
    let rest_23 = Vec3 { x: sub(place_a1.x, corner_6.x), y: sub(place_a1.y, corner_6.y), z: sub(place_a1.z, corner_6.z) };
    let across_24 = Vec3 { x: sub(mul(a_14.y, b_22.z), mul(a_14.z, b_22.y)), y: sub(mul(a_14.z, b_22.x), mul(a_14.x, b_22.z)), z: sub(mul(a_14.x, b_22.y), mul(a_14.y, b_22.x)) };
    let square_25 = add(add(add(mul(across_24.x, across_24.x), mul(across_24.y, across_24.y)), mul(across_24.z, across_24.z)), splat(0.0f32));
    let c1 = not(gt(square_25, splat(0.0f32)));
    ret = Vec3 { x: splat(0.28125f32), y: splat(0.375f32), z: splat(0.34375f32) };
    ex = and_not(ex, c1);
    let second_35 = div(add(add(add(mul(sub(mul(rest_23.y, b_22.z), mul(rest_23.z, b_22.y)), across_24.x), mul(sub(mul(rest_23.z, b_22.x), mul(rest_23.x, b_22.z)), across_24.y)), mul(sub(mul(rest_23.x, b_22.y), mul(rest_23.y, b_22.x)), across_24.z)), splat(0.0f32)), square_25);
    let third_38 = div(add(add(add(mul(sub(mul(a_14.y, rest_23.z), mul(a_14.z, rest_23.y)), across_24.x), mul(sub(mul(a_14.z, rest_23.x), mul(a_14.x, rest_23.z)), across_24.y)), mul(sub(mul(a_14.x, rest_23.y), mul(a_14.y, rest_23.x)), across_24.z)), splat(0.0f32)), square_25);
    let y2 = Vec3 { x: sub(sub(splat(1.0f32), second_35), third_38), y: second_35, z: third_38 };
    return Vec3 { x: sel(ex, y2.x, ret.x), y: sel(ex, y2.y, ret.y), z: sel(ex, y2.z, ret.z) };
} }
lanes! { fn shell_point_near(r: &Resources<'_>, within: M, prism_a0: &Prism, place_a1: Vec3<F>, height_a2: F) -> ShellPoint {
    let mut ex = within;
    let mut ret: ShellPoint = zero_shell_point();
    let offset_15 = add(splat(r.surface_settings.shell_m.x), mul(splat((r.surface_settings.shell_m.y - r.surface_settings.shell_m.x).min(3e38f32)), height_a2));
    let flat_16 = weights_at_offset(r, ex, prism_a0, place_a1, offset_15);
    let e_18 = lift_of(r, Vec3 { x: prism_a0.lift.x, y: prism_a0.lift.y, z: prism_a0.lift.z }, flat_16);
    let e_20 = weights_at_offset(r, ex, prism_a0, place_a1, add(offset_15, e_18));
    let near_21 = ShellPoint { weights: e_20, height: height_a2, };
    let point_22 = shell_point_from(r, ex, prism_a0, place_a1, &near_21);
    let moved_26 = Vec3 { x: abs(sub(point_22.weights.x, near_21.weights.x)), y: abs(sub(point_22.weights.y, near_21.weights.y)), z: abs(sub(point_22.weights.z, near_21.weights.z)) };
    let away_35 = max(max(moved_26.x, moved_26.y), max(moved_26.z, abs(sub(point_22.height, height_a2))));
    let (b1, c2) = (ex, lt(away_35, splat(0.5f32)));
    ex = and(b1, c2);
    if any(ex) {
        ret = point_22;
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    return sel_shell_point(ex, &near_21, &ret);
} }
lanes! { fn point_of_way(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, prism_a1: &Prism, place_a2: Vec3<F>, height_a3: F) -> ShellPoint {
    let mut ex = within;
    let mut ret: ShellPoint = zero_shell_point();
    if (pixel_a0.shell.order >= 64u32) {
        let e_8 = shell_point_near(r, ex, prism_a1, place_a2, height_a3);
        return e_8;
    }
    let e_9 = shell_point(r, ex, prism_a1, place_a2, height_a3);
    return e_9;
} }
stage! { fn surface_prism_polish(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, path_a2: &Path, hit_a3: &Hit, params_a4: Vec4<f32>) -> Hit {
    let mut ex = within;
    let mut ret: Hit = zero_hit();
    let mut t_v0: F = splat(0f32);
    let mut point_v1: ShellPoint = zero_shell_point();
    let mut step_v2: u32 = 0u32;
    let e_6 = field_is_ground_stage(r, path_a2.level);
    let (b1, c2) = (ex, not(e_6));
    ex = and(b1, c2);
    if any(ex) {
        ret = *hit_a3;
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    let length3 = sqrt(add(add(mul(pixel_a0.direction.x, pixel_a0.direction.x), mul(pixel_a0.direction.y, pixel_a0.direction.y)), mul(pixel_a0.direction.z, pixel_a0.direction.z)));
    let along_9 = Vec3 { x: div(pixel_a0.direction.x, length3), y: div(pixel_a0.direction.y, length3), z: div(pixel_a0.direction.z, length3) };
    if none(ex) { return ret; }
    let middle_10 = middle_of(r, pixel_a0, along_9);
    let prism_11 = prism_of(r, pixel_a0, along_9, middle_10, params_a4);
    let wanted_13 = path_gap(r, ex, path_a2, hit_a3.t);
    let grid_14 = grid_of(r, path_a2);
    let texels_16 = Vec2 { x: abs(grid_14.step.x), y: abs(grid_14.step.y) };
    let most_29 = div(splat((2.0f32 * params_a4.x)), max(max(texels_16.x, texels_16.y), div(abs(path_a2.h.y), splat(0.0625f32))));
    t_v0 = hit_a3.t;
    let e_33 = t_v0;
    let e_37 = t_v0;
    let e_38 = path_height(r, path_a2, e_37);
    let e_35 = sub(add(path_a2.start, e_33), middle_10);
    let e_39 = point_of_way(r, ex, pixel_a0, &prism_11, Vec3 { x: mul(along_9.x, e_35), y: mul(along_9.y, e_35), z: mul(along_9.z, e_35) }, e_38);
    point_v1 = e_39;
    'l4: loop {
        let e_43 = step_v2;
        if (e_43 < 3u32) {
        } else {
            break 'l4;
        }
        let e_46 = step_v2;
        step_v2 = e_46.wrapping_add(1u32);
        let e_50 = point_v1.height;
        let e_52 = point_v1.weights;
        let e_53 = uv_of(r, pixel_a0, e_52);
        let e_55 = height_at_ll(r, ex, e_53, path_a2.level);
        let gap_57 = sub(sub(e_50, e_55), wanted_13);
        let e_60 = t_v0;
        let e_63 = cell_of(r, Vec2 { x: add(grid_14.origin.x, mul(grid_14.step.x, e_60)), y: add(grid_14.origin.y, mul(grid_14.step.y, e_60)) });
        let e_64 = t_v0;
        let e_65 = cell_gap_llll(r, ex, path_a2, &grid_14, e_63, e_64);
        let c5 = lt(e_65.y, splat(0.0f32));
        let e_69 = t_v0;
        t_v0 = sel(c5, min(max(sub(e_69, div(gap_57, e_65.y)), sub(hit_a3.t, most_29)), add(hit_a3.t, most_29)), t_v0);
        let e_78 = t_v0;
        let e_80 = sub(add(path_a2.start, e_78), middle_10);
        let place_81 = Vec3 { x: mul(along_9.x, e_80), y: mul(along_9.y, e_80), z: mul(along_9.z, e_80) };
        if (pixel_a0.shell.order >= 64u32) {
            let e_86 = t_v0;
            let e_87 = path_height(r, path_a2, e_86);
            let e_88 = shell_point_near(r, ex, &prism_11, place_81, e_87);
            point_v1 = e_88;
        } else {
            let e_89 = point_v1;
            let e_90 = shell_point_from(r, ex, &prism_11, place_81, &e_89);
            point_v1 = e_90;
        }
    }
    let e_94 = point_v1.weights;
    let e_95 = uv_of(r, pixel_a0, e_94);
    let e_97 = point_v1.height;
    let e_98 = t_v0;
    return sel_hit(ex, &Hit { found: splat_u(1u32), exhausted: hit_a3.exhausted, uv: e_95, height: e_97, t: e_98, cost: Vec3 { x: hit_a3.cost.x, y: hit_a3.cost.y, z: hit_a3.cost.z }, }, &ret);
} }
lanes! { fn surface_quadric_perpendicular_polish(r: &Resources<'_>, pixel_a0: &PixelIn, at_a1: &Entered, path_a2: &Path, hit_a3: &Hit, params_a4: Vec4<f32>) -> Hit {
    return *hit_a3;
} }
lanes! { fn surface_quadric_vertical_polish(r: &Resources<'_>, pixel_a0: &PixelIn, at_a1: &Entered, path_a2: &Path, hit_a3: &Hit, params_a4: Vec4<f32>) -> Hit {
    return *hit_a3;
} }
lanes! { fn surface_tetrahedra_polish(r: &Resources<'_>, pixel_a0: &PixelIn, at_a1: &Entered, path_a2: &Path, hit_a3: &Hit, params_a4: Vec4<f32>) -> Hit {
    return *hit_a3;
} }
lanes! { fn surface_facets_polish(r: &Resources<'_>, pixel_a0: &PixelIn, at_a1: &Entered, path_a2: &Path, hit_a3: &Hit, params_a4: Vec4<f32>) -> Hit {
    return *hit_a3;
} }
lanes! { fn surface_slices_polish(r: &Resources<'_>, pixel_a0: &PixelIn, at_a1: &Entered, path_a2: &Path, hit_a3: &Hit, params_a4: Vec4<f32>) -> Hit {
    let mut counted_v0: Hit = zero_hit();
    counted_v0 = *hit_a3;
    counted_v0.cost = Vec3 { x: add_u(hit_a3.cost.x, splat_u(1u32)), y: add_u(hit_a3.cost.y, splat_u(0u32)), z: add_u(hit_a3.cost.z, splat_u(16u32)) };
    let e_10 = counted_v0;
    return e_10;
} }
lanes! { fn metres_on(r: &Resources<'_>, path_a0: &Path, t_a1: F) -> F {
    return div(t_a1, sub(splat(1.0f32), mul(path_a0.bend, t_a1)));
} }
lanes! { fn polished_on_image(r: &Resources<'_>, path_a0: &Path, hit_a1: &Hit) -> Hit {
    let mut polished_v0: Hit = zero_hit();
    polished_v0 = *hit_a1;
    let e_5 = metres_on(r, path_a0, hit_a1.t);
    polished_v0.t = e_5;
    let e_6 = polished_v0;
    return e_6;
} }
lanes! { fn surface_object_polish(r: &Resources<'_>, pixel_a0: &PixelIn, at_a1: &Entered, path_a2: &Path, hit_a3: &Hit, params_a4: Vec4<f32>) -> Hit {
    let e_5 = polished_on_image(r, path_a2, hit_a3);
    return e_5;
} }
lanes! { fn surface_frames_polish(r: &Resources<'_>, pixel_a0: &PixelIn, at_a1: &Entered, path_a2: &Path, hit_a3: &Hit, params_a4: Vec4<f32>) -> Hit {
    let e_5 = polished_on_image(r, path_a2, hit_a3);
    return e_5;
} }
lanes! { fn surface_object_slices_polish(r: &Resources<'_>, pixel_a0: &PixelIn, at_a1: &Entered, path_a2: &Path, hit_a3: &Hit, params_a4: Vec4<f32>) -> Hit {
    let mut counted_v0: Hit = zero_hit();
    counted_v0 = *hit_a3;
    counted_v0.cost = Vec3 { x: add_u(hit_a3.cost.x, splat_u(r.surface_settings.solids)), y: add_u(hit_a3.cost.y, splat_u(0u32)), z: add_u(hit_a3.cost.z, splat_u(16u32.wrapping_mul(r.surface_settings.solids))) };
    let e_19 = counted_v0;
    return e_19;
} }
lanes! { fn surface_polish_stage(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, path_a2: &Path, hit_a3: &Hit) -> Hit {
    let mut ex = within;
    let mut ret: Hit = zero_hit();
    match r.surface_settings.choices[1].number {
        0u32 => {
            let e_14 = surface_plane_polish(r, pixel_a0, at_a1, path_a2, hit_a3, r.surface_settings.choices[1].params);
            return e_14;
        }
        1u32 => {
            let e_20 = surface_prism_polish(r, ex, pixel_a0, at_a1, path_a2, hit_a3, r.surface_settings.choices[1].params);
            return e_20;
        }
        2u32 => {
            let e_26 = surface_quadric_perpendicular_polish(r, pixel_a0, at_a1, path_a2, hit_a3, r.surface_settings.choices[1].params);
            return e_26;
        }
        3u32 => {
            let e_32 = surface_quadric_vertical_polish(r, pixel_a0, at_a1, path_a2, hit_a3, r.surface_settings.choices[1].params);
            return e_32;
        }
        4u32 => {
            let e_38 = surface_tetrahedra_polish(r, pixel_a0, at_a1, path_a2, hit_a3, r.surface_settings.choices[1].params);
            return e_38;
        }
        5u32 => {
            let e_44 = surface_facets_polish(r, pixel_a0, at_a1, path_a2, hit_a3, r.surface_settings.choices[1].params);
            return e_44;
        }
        6u32 => {
            let e_50 = surface_slices_polish(r, pixel_a0, at_a1, path_a2, hit_a3, r.surface_settings.choices[1].params);
            return e_50;
        }
        7u32 => {
            let e_56 = surface_object_polish(r, pixel_a0, at_a1, path_a2, hit_a3, r.surface_settings.choices[1].params);
            return e_56;
        }
        8u32 => {
            let e_62 = surface_frames_polish(r, pixel_a0, at_a1, path_a2, hit_a3, r.surface_settings.choices[1].params);
            return e_62;
        }
        _ => {
            let e_68 = surface_object_slices_polish(r, pixel_a0, at_a1, path_a2, hit_a3, r.surface_settings.choices[1].params);
            return e_68;
        }
    }
} }
lanes! { fn polish_hit(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, path_a2: &Path, hit_a3: &Hit) -> Hit {
    let mut ex = within;
    let mut ret: Hit = zero_hit();
    let e_4 = surface_polish_stage(r, ex, pixel_a0, at_a1, path_a2, hit_a3);
    return e_4;
} }
lanes! { fn key_of(r: &Resources<'_>, depth_a0: F) -> F {
    return div(splat(r.frame.near), add(splat(r.frame.near), max_with(depth_a0, splat(0.0f32))));
} }
stage! { fn is_in_hole(r: &Resources<'_>, within: M, uv_a0: Vec2<F>) -> M {
    if none(within) { return splat_m(false); }
    let uv_a0 = { let rows = (row(uv_a0.x), row(uv_a0.y)); std::array::from_fn::<_, LANES, _>(|lane| Vec2 { x: rows.0[lane], y: rows.1[lane] }) };
    let one = |lane: usize| r.is_in_hole(uv_a0[lane]);
    let mut rest = bits_of(within);
    let mut results = [one(rest.trailing_zeros() as usize); LANES];
    rest &= rest - 1;
    while rest != 0 {
        let lane = rest.trailing_zeros() as usize;
        results[lane] = one(lane);
        rest &= rest - 1;
    }
    load_m(&std::array::from_fn(|lane| results[lane]))
} }
lanes! { fn in_hole(r: &Resources<'_>, within: M, uv_a0: Vec2<F>) -> M {
    let mut ex = within;
    let mut ret: M = splat_m(false);
    if (r.surface_settings.has_holes == 0u32) {
        return splat_m(false);
    }
    let e_7 = is_in_hole(r, ex, uv_a0);
    return e_7;
} }
stage! { pub(super) fn hit_on_segment(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, path_a2: &Path, found_a3: &Hit, k_a4: u32) -> FirstHit {
    let mut ex = within;
    let mut ret: FirstHit = zero_first_hit();
    let mut first_v0: FirstHit = zero_first_hit();
    first_v0 = FirstHit { hit: *found_a3, segment: splat_u(k_a4), key: splat(0.0f32), };
    let (b1, c2) = (ex, eq_u(found_a3.found, splat_u(1u32)));
    ex = and(b1, c2);
    if any(ex) {
        let hit_11 = polish_hit(r, ex, pixel_a0, at_a1, path_a2, found_a3);
        let e_12 = depth_on_ray(r, pixel_a0, path_a2, &hit_11);
        let e_13 = key_of(r, e_12);
        first_v0 = sel_first_hit(ex, &FirstHit { hit: hit_11, segment: splat_u(k_a4), key: e_13, }, &first_v0);
        let e_16 = in_hole(r, ex, Vec2 { x: hit_11.uv.x, y: hit_11.uv.y });
        let c3 = e_16;
        first_v0.hit.found = sel_u(and(ex, c3), splat_u(0u32), first_v0.hit.found);
    }
    ex = b1;
    let e_20 = first_v0;
    return e_20;
} }
lanes! { fn placed_over(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit) -> Entered {
    let mut ex = within;
    let mut ret: Entered = zero_entered();
    let mut placed_v0: Entered = zero_entered();
    let aside_4 = Vec2 { x: sub(hit_a1.uv.x, at_a0.uv.x), y: sub(hit_a1.uv.y, at_a0.uv.y) };
    let level_7 = field_height_stage(r, ex, Vec2 { x: hit_a1.uv.x, y: hit_a1.uv.y }, hit_a1.height, at_a0.level);
    let height_15 = add(splat(r.surface_settings.bias_m), mul(splat(r.surface_settings.scale_m), level_7));
    placed_v0 = *at_a0;
    placed_v0.point = Vec3 { x: add(add(add(at_a0.point.x, mul(at_a0.tangent.x, aside_4.x)), mul(at_a0.bitangent.x, aside_4.y)), mul(at_a0.normal.x, height_15)), y: add(add(add(at_a0.point.y, mul(at_a0.tangent.y, aside_4.x)), mul(at_a0.bitangent.y, aside_4.y)), mul(at_a0.normal.y, height_15)), z: add(add(add(at_a0.point.z, mul(at_a0.tangent.z, aside_4.x)), mul(at_a0.bitangent.z, aside_4.y)), mul(at_a0.normal.z, height_15)) };
    placed_v0.uv = Vec2 { x: hit_a1.uv.x, y: hit_a1.uv.y };
    let e_31 = placed_v0;
    return e_31;
} }
lanes! { fn surface_plane_place(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, path_a2: &Path, hit_a3: &Hit, params_a4: Vec4<f32>) -> Entered {
    let mut ex = within;
    let mut ret: Entered = zero_entered();
    let e_5 = placed_over(r, ex, at_a1, hit_a3);
    return e_5;
} }
lanes! { fn placed_at(r: &Resources<'_>, pixel_a0: &PixelIn, at_a1: &Entered, weights_a2: Vec3<F>, point_a3: Vec3<F>, uv_a4: Vec2<F>) -> Entered {
    let mut placed_v0: Entered = zero_entered();
    let e_6 = frame_at(r, pixel_a0, weights_a2, point_a3, uv_a4, Vec3 { x: at_a1.facing.x, y: at_a1.facing.y, z: at_a1.facing.z });
    placed_v0 = e_6;
    placed_v0.level = at_a1.level;
    placed_v0.footprint = at_a1.footprint;
    placed_v0.fade = at_a1.fade;
    let e_14 = placed_v0;
    return e_14;
} }
lanes! { fn surface_prism_place(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, path_a2: &Path, hit_a3: &Hit, params_a4: Vec4<f32>) -> Entered {
    let mut ex = within;
    let mut ret: Entered = zero_entered();
    let length1 = sqrt(add(add(mul(pixel_a0.direction.x, pixel_a0.direction.x), mul(pixel_a0.direction.y, pixel_a0.direction.y)), mul(pixel_a0.direction.z, pixel_a0.direction.z)));
    let along_6 = Vec3 { x: div(pixel_a0.direction.x, length1), y: div(pixel_a0.direction.y, length1), z: div(pixel_a0.direction.z, length1) };
    let middle_7 = middle_of(r, pixel_a0, along_6);
    let prism_8 = prism_of(r, pixel_a0, along_6, middle_7, params_a4);
    let s_12 = sub(add(path_a2.start, hit_a3.t), middle_7);
    let e_15 = point_of_way(r, ex, pixel_a0, &prism_8, Vec3 { x: mul(along_6.x, s_12), y: mul(along_6.y, s_12), z: mul(along_6.z, s_12) }, hit_a3.height);
    let e_20 = add(path_a2.start, hit_a3.t);
    let e_24 = placed_at(r, pixel_a0, at_a1, Vec3 { x: e_15.weights.x, y: e_15.weights.y, z: e_15.weights.z }, Vec3 { x: add(pixel_a0.origin.x, mul(along_6.x, e_20)), y: add(pixel_a0.origin.y, mul(along_6.y, e_20)), z: add(pixel_a0.origin.z, mul(along_6.z, e_20)) }, Vec2 { x: hit_a3.uv.x, y: hit_a3.uv.y });
    return e_24;
} }
lanes! { fn quadric_frame(r: &Resources<'_>, within: M, at_a0: &Entered, aside_a1: Vec2<F>) -> Entered {
    let mut ex = within;
    let mut ret: Entered = zero_entered();
    let mut placed_v0: Entered = zero_entered();
    let mut both_v1: M = splat_m(false);
    placed_v0 = *at_a0;
    let slope_5 = quadric_slope(r, Vec3 { x: at_a0.of_surface.x, y: at_a0.of_surface.y, z: at_a0.of_surface.z }, aside_a1);
    both_v1 = and(eq(slope_5.x, splat(0.0f32)), eq(slope_5.y, splat(0.0f32)));
    let e_15 = both_v1;
    let (b1, c2) = (ex, e_15);
    ex = and(b1, c2);
    if any(ex) {
        let e_16 = placed_v0;
        ret = e_16;
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    let area_24 = sub(mul(at_a0.metric.x, at_a0.metric.z), mul(at_a0.metric.y, at_a0.metric.y));
    let along_t_32 = div(sub(mul(slope_5.x, at_a0.metric.z), mul(slope_5.y, at_a0.metric.y)), area_24);
    let along_b_40 = div(sub(mul(slope_5.y, at_a0.metric.x), mul(slope_5.x, at_a0.metric.y)), area_24);
    placed_v0.tangent = Vec3 { x: add(at_a0.tangent.x, mul(at_a0.normal.x, slope_5.x)), y: add(at_a0.tangent.y, mul(at_a0.normal.y, slope_5.x)), z: add(at_a0.tangent.z, mul(at_a0.normal.z, slope_5.x)) };
    placed_v0.bitangent = Vec3 { x: add(at_a0.bitangent.x, mul(at_a0.normal.x, slope_5.y)), y: add(at_a0.bitangent.y, mul(at_a0.normal.y, slope_5.y)), z: add(at_a0.bitangent.z, mul(at_a0.normal.z, slope_5.y)) };
    let e_60 = Vec3 { x: sub(sub(at_a0.normal.x, mul(at_a0.tangent.x, along_t_32)), mul(at_a0.bitangent.x, along_b_40)), y: sub(sub(at_a0.normal.y, mul(at_a0.tangent.y, along_t_32)), mul(at_a0.bitangent.y, along_b_40)), z: sub(sub(at_a0.normal.z, mul(at_a0.tangent.z, along_t_32)), mul(at_a0.bitangent.z, along_b_40)) };
    let length3 = sqrt(add(add(mul(e_60.x, e_60.x), mul(e_60.y, e_60.y)), mul(e_60.z, e_60.z)));
    let e_61 = Vec3 { x: div(e_60.x, length3), y: div(e_60.y, length3), z: div(e_60.z, length3) };
    placed_v0.normal = e_61;
    let e_63 = placed_v0.tangent;
    let e_65 = placed_v0.tangent;
    let tt_66 = add(add(add(mul(e_63.x, e_65.x), mul(e_63.y, e_65.y)), mul(e_63.z, e_65.z)), splat(0.0f32));
    let e_68 = placed_v0.tangent;
    let e_70 = placed_v0.bitangent;
    let tb_71 = add(add(add(mul(e_68.x, e_70.x), mul(e_68.y, e_70.y)), mul(e_68.z, e_70.z)), splat(0.0f32));
    let e_73 = placed_v0.bitangent;
    let e_75 = placed_v0.bitangent;
    let bb_76 = add(add(add(mul(e_73.x, e_75.x), mul(e_73.y, e_75.y)), mul(e_73.z, e_75.z)), splat(0.0f32));
    placed_v0.metric = Vec4 { x: tt_66, y: tb_71, z: bb_76, w: at_a0.metric.w };
    let e_80 = placed_v0;
    return sel_entered(ex, &e_80, &ret);
} }
lanes! { fn surface_quadric_perpendicular_place(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, path_a2: &Path, hit_a3: &Hit, params_a4: Vec4<f32>) -> Entered {
    let mut ex = within;
    let mut ret: Entered = zero_entered();
    let mut placed_v0: Entered = zero_entered();
    let e_8 = quadric_frame(r, ex, at_a1, Vec2 { x: sub(hit_a3.uv.x, at_a1.uv.x), y: sub(hit_a3.uv.y, at_a1.uv.y) });
    placed_v0 = e_8;
    let length1 = sqrt(add(add(mul(pixel_a0.direction.x, pixel_a0.direction.x), mul(pixel_a0.direction.y, pixel_a0.direction.y)), mul(pixel_a0.direction.z, pixel_a0.direction.z)));
    let e_13 = Vec3 { x: div(pixel_a0.direction.x, length1), y: div(pixel_a0.direction.y, length1), z: div(pixel_a0.direction.z, length1) };
    let e_16 = add(path_a2.start, hit_a3.t);
    placed_v0.point = Vec3 { x: add(pixel_a0.origin.x, mul(e_13.x, e_16)), y: add(pixel_a0.origin.y, mul(e_13.y, e_16)), z: add(pixel_a0.origin.z, mul(e_13.z, e_16)) };
    placed_v0.uv = Vec2 { x: hit_a3.uv.x, y: hit_a3.uv.y };
    let e_21 = placed_v0;
    return e_21;
} }
lanes! { fn surface_quadric_vertical_place(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, path_a2: &Path, hit_a3: &Hit, params_a4: Vec4<f32>) -> Entered {
    let mut ex = within;
    let mut ret: Entered = zero_entered();
    let mut placed_v0: Entered = zero_entered();
    let aside_7 = Vec2 { x: sub(hit_a3.uv.x, at_a1.uv.x), y: sub(hit_a3.uv.y, at_a1.uv.y) };
    let level_11 = field_height_stage(r, ex, Vec2 { x: hit_a3.uv.x, y: hit_a3.uv.y }, hit_a3.height, at_a1.level);
    let height_19 = add(splat(r.surface_settings.bias_m), mul(splat(r.surface_settings.scale_m), level_11));
    let e_20 = r.base_height();
    let e_24 = r.traced_scale_m();
    let e_28 = quadric_at(r, Vec3 { x: at_a1.of_surface.x, y: at_a1.of_surface.y, z: at_a1.of_surface.z }, aside_7);
    let lifted_29 = add(mul(sub(splat(e_20), at_a1.of_surface.w), splat(e_24)), e_28);
    let e_30 = quadric_frame(r, ex, at_a1, aside_7);
    placed_v0 = e_30;
    let e_43 = add(height_19, lifted_29);
    placed_v0.point = Vec3 { x: add(add(add(at_a1.point.x, mul(at_a1.tangent.x, aside_7.x)), mul(at_a1.bitangent.x, aside_7.y)), mul(at_a1.normal.x, e_43)), y: add(add(add(at_a1.point.y, mul(at_a1.tangent.y, aside_7.x)), mul(at_a1.bitangent.y, aside_7.y)), mul(at_a1.normal.y, e_43)), z: add(add(add(at_a1.point.z, mul(at_a1.tangent.z, aside_7.x)), mul(at_a1.bitangent.z, aside_7.y)), mul(at_a1.normal.z, e_43)) };
    placed_v0.uv = Vec2 { x: hit_a3.uv.x, y: hit_a3.uv.y };
    let e_48 = placed_v0;
    return e_48;
} }
stage! { fn surface_tetrahedra_place(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, path_a2: &Path, hit_a3: &Hit, params_a4: Vec4<f32>) -> Entered {
    let mut ex = within;
    let mut ret: Entered = zero_entered();
    let mut nearest_v0: Tetrahedron = zero_tetrahedron();
    let mut beside_v1: F = splat(0f32);
    let mut number_v2: u32 = 1u32;
    let length1 = sqrt(add(add(mul(pixel_a0.direction.x, pixel_a0.direction.x), mul(pixel_a0.direction.y, pixel_a0.direction.y)), mul(pixel_a0.direction.z, pixel_a0.direction.z)));
    let along_6 = Vec3 { x: div(pixel_a0.direction.x, length1), y: div(pixel_a0.direction.y, length1), z: div(pixel_a0.direction.z, length1) };
    let middle_7 = middle_of(r, pixel_a0, along_6);
    let t_11 = sub(add(path_a2.start, hit_a3.t), middle_7);
    let e_13 = tetrahedron(r, ex, pixel_a0, along_6, middle_7, 0u32);
    nearest_v0 = e_13;
    let e_17 = nearest_v0.inside.x;
    let e_21 = nearest_v0.inside.y;
    beside_v1 = max(sub(e_17, t_11), sub(t_11, e_21));
    'l2: loop {
        let e_27 = number_v2;
        if (e_27 < 3u32) {
        } else {
            break 'l2;
        }
        let e_30 = number_v2;
        let other_31 = tetrahedron(r, ex, pixel_a0, along_6, middle_7, e_30);
        let aside_38 = max(sub(other_31.inside.x, t_11), sub(t_11, other_31.inside.y));
        let e_39 = beside_v1;
        let c3 = lt(aside_38, e_39);
        nearest_v0 = sel_tetrahedron(c3, &other_31, &nearest_v0);
        beside_v1 = sel(c3, aside_38, beside_v1);
        let e_41 = number_v2;
        number_v2 = e_41.wrapping_add(1u32);
    }
    let e_45 = nearest_v0.weights;
    let e_47 = nearest_v0.change;
    let weights_49 = Vec4 { x: add(e_45.x, mul(e_47.x, t_11)), y: add(e_45.y, mul(e_47.y, t_11)), z: add(e_45.z, mul(e_47.z, t_11)), w: add(e_45.w, mul(e_47.w, t_11)) };
    let e_53 = add(path_a2.start, hit_a3.t);
    let point_55 = Vec3 { x: add(pixel_a0.origin.x, mul(along_6.x, e_53)), y: add(pixel_a0.origin.y, mul(along_6.y, e_53)), z: add(pixel_a0.origin.z, mul(along_6.z, e_53)) };
    let e_58 = placed_at(r, pixel_a0, at_a1, Vec3 { x: weights_49.x, y: weights_49.y, z: weights_49.z }, point_55, Vec2 { x: hit_a3.uv.x, y: hit_a3.uv.y });
    return e_58;
} }
lanes! { fn surface_facets_place(r: &Resources<'_>, pixel_a0: &PixelIn, at_a1: &Entered, path_a2: &Path, hit_a3: &Hit, params_a4: Vec4<f32>) -> Entered {
    return *at_a1;
} }
lanes! { fn surface_slices_place(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, path_a2: &Path, hit_a3: &Hit, params_a4: Vec4<f32>) -> Entered {
    let mut ex = within;
    let mut ret: Entered = zero_entered();
    let e_5 = placed_over(r, ex, at_a1, hit_a3);
    return e_5;
} }
lanes! { fn rise_of_mask(r: &Resources<'_>, within: M, uv_a0: Vec2<F>) -> Vec2<F> {
    let mut ex = within;
    let mut ret: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    let e_2 = height_size(r, splat_u(0u32));
    let at_7 = Vec2 { x: sub(mul(uv_a0.x, e_2.x), splat(0.5f32)), y: sub(mul(uv_a0.y, e_2.y), splat(0.5f32)) };
    let cell_8 = cell_of(r, at_7);
    let h_11 = object_cell_stage_ls(r, ex, Vec2 { x: i_of_small(cell_8.x), y: i_of_small(cell_8.y) }, 0u32);
    let part_12 = Vec2 { x: sub(at_7.x, cell_8.x), y: sub(at_7.y, cell_8.y) };
    return Vec2 { x: add(mul(sub(h_11.y, h_11.x), sub(splat(1.0f32), part_12.y)), mul(sub(h_11.w, h_11.z), part_12.y)), y: add(mul(sub(h_11.z, h_11.x), sub(splat(1.0f32), part_12.x)), mul(sub(h_11.w, h_11.y), part_12.x)) };
} }
lanes! { fn normal_of_mask(r: &Resources<'_>, within: M, image_a0: &Image, uv_a1: Vec2<F>, within_a2: Vec3<F>) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let rise_3 = rise_of_mask(r, ex, uv_a1);
    let place_7 = Vec2 { x: div(sub(uv_a1.x, image_a0.corner.x), image_a0.extent.x), y: div(sub(uv_a1.y, image_a0.corner.y), image_a0.extent.y) };
    let e_14 = Vec3 { x: sub(image_a0.u.x, mul(image_a0.depth.x, place_7.x)), y: sub(image_a0.u.y, mul(image_a0.depth.y, place_7.x)), z: sub(image_a0.u.z, mul(image_a0.depth.z, place_7.x)) };
    let length1 = sqrt(add(add(mul(e_14.x, e_14.x), mul(e_14.y, e_14.y)), mul(e_14.z, e_14.z)));
    let along_u_15 = Vec3 { x: div(e_14.x, length1), y: div(e_14.y, length1), z: div(e_14.z, length1) };
    let e_22 = Vec3 { x: sub(image_a0.v.x, mul(image_a0.depth.x, place_7.y)), y: sub(image_a0.v.y, mul(image_a0.depth.y, place_7.y)), z: sub(image_a0.v.z, mul(image_a0.depth.z, place_7.y)) };
    let length2 = sqrt(add(add(mul(e_22.x, e_22.x), mul(e_22.y, e_22.y)), mul(e_22.z, e_22.z)));
    let along_v_23 = Vec3 { x: div(e_22.x, length2), y: div(e_22.y, length2), z: div(e_22.z, length2) };
    let outward_33 = Vec3 { x: sub(sub(splat(0.0f32), mul(along_u_15.x, rise_3.x)), mul(along_v_23.x, rise_3.y)), y: sub(sub(splat(0.0f32), mul(along_u_15.y, rise_3.x)), mul(along_v_23.y, rise_3.y)), z: sub(sub(splat(0.0f32), mul(along_u_15.z, rise_3.x)), mul(along_v_23.z, rise_3.y)) };
    let square_34 = add(add(add(mul(outward_33.x, outward_33.x), mul(outward_33.y, outward_33.y)), mul(outward_33.z, outward_33.z)), splat(0.0f32));
    let c3 = gt(square_34, splat(0.0f32));
    let e_37 = sqrt(square_34);
    ret = Vec3 { x: div(outward_33.x, e_37), y: div(outward_33.y, e_37), z: div(outward_33.z, e_37) };
    ex = and_not(ex, c3);
    let y4 = within_a2;
    return Vec3 { x: sel(ex, y4.x, ret.x), y: sel(ex, y4.y, ret.y), z: sel(ex, y4.z, ret.z) };
} }
lanes! { fn placed_in_image(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, path_a2: &Path, hit_a3: &Hit) -> Entered {
    let mut ex = within;
    let mut ret: Entered = zero_entered();
    let mut placed_v0: Entered = zero_entered();
    let image_6 = image_of_object_l(r, ex, u_of_f(path_a2.base));
    placed_v0 = *at_a1;
    let length1 = sqrt(add(add(mul(pixel_a0.direction.x, pixel_a0.direction.x), mul(pixel_a0.direction.y, pixel_a0.direction.y)), mul(pixel_a0.direction.z, pixel_a0.direction.z)));
    let e_11 = Vec3 { x: div(pixel_a0.direction.x, length1), y: div(pixel_a0.direction.y, length1), z: div(pixel_a0.direction.z, length1) };
    let e_14 = add(path_a2.start, hit_a3.t);
    placed_v0.point = Vec3 { x: add(pixel_a0.origin.x, mul(e_11.x, e_14)), y: add(pixel_a0.origin.y, mul(e_11.y, e_14)), z: add(pixel_a0.origin.z, mul(e_11.z, e_14)) };
    placed_v0.uv = Vec2 { x: hit_a3.uv.x, y: hit_a3.uv.y };
    let e_20 = placed_v0.point;
    let depth_21 = depth_in_image(r, &image_6, e_20);
    let e_23 = placed_v0.point;
    let nearer_25 = stretch_in_image(r, ex, &image_6, e_23, hit_a3.height);
    let e_27 = tangent_of_image(r, &image_6);
    placed_v0.tangent = Vec3 { x: div(mul(e_27.x, depth_21), nearer_25), y: div(mul(e_27.y, depth_21), nearer_25), z: div(mul(e_27.z, depth_21), nearer_25) };
    let e_32 = bitangent_of_image(r, &image_6);
    placed_v0.bitangent = Vec3 { x: div(mul(e_32.x, depth_21), nearer_25), y: div(mul(e_32.y, depth_21), nearer_25), z: div(mul(e_32.z, depth_21), nearer_25) };
    let e_38 = placed_v0.point;
    let e_39 = toward_image(r, ex, &image_6, e_38);
    placed_v0.normal = e_39;
    if (r.surface_settings.has_normal == 1u32) {
        placed_v0.normal = Vec3 { x: image_6.toward.x, y: image_6.toward.y, z: image_6.toward.z };
    }
    placed_v0.metric = Vec4 { x: path_a2.metric.x, y: path_a2.metric.y, z: path_a2.metric.z, w: path_a2.metric.w };
    placed_v0.facing = Vec3 { x: image_6.toward.x, y: image_6.toward.y, z: image_6.toward.z };
    if (r.surface_settings.cells == 4u32) {
        let e_59 = normal_of_mask(r, ex, &image_6, Vec2 { x: hit_a3.uv.x, y: hit_a3.uv.y }, Vec3 { x: image_6.toward.x, y: image_6.toward.y, z: image_6.toward.z });
        placed_v0.normal = e_59;
        let e_62 = placed_v0.normal;
        placed_v0.facing = e_62;
    }
    let e_63 = placed_v0;
    return e_63;
} }
lanes! { fn surface_object_place(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, path_a2: &Path, hit_a3: &Hit, params_a4: Vec4<f32>) -> Entered {
    let mut ex = within;
    let mut ret: Entered = zero_entered();
    let e_5 = placed_in_image(r, ex, pixel_a0, at_a1, path_a2, hit_a3);
    return e_5;
} }
stage! { fn normal_of_frames(r: &Resources<'_>, within: M, at_a0: &Entered, frames_a1: &Frames) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let mut sum_v0: Vec3<F> = Vec3 { x: splat(0.0f32), y: splat(0.0f32), z: splat(0.0f32) };
    let mut k_v1: u32 = 0u32;
    let mut seen_v2: Entered = zero_entered();
    'l1: loop {
        let e_9 = k_v1;
        if (e_9 < 3u32) {
        } else {
            break 'l1;
        }
        let e_12 = k_v1;
        let e_13 = frame_number(r, frames_a1, e_12);
        let image_14 = image_of_object_l(r, ex, e_13);
        seen_v2 = *at_a0;
        let e_17 = tangent_of_image(r, &image_14);
        seen_v2.tangent = e_17;
        let e_19 = bitangent_of_image(r, &image_14);
        seen_v2.bitangent = e_19;
        seen_v2.normal = Vec3 { x: image_14.toward.x, y: image_14.toward.y, z: image_14.toward.z };
        let e_23 = place_in_image(r, &image_14, Vec3 { x: at_a0.point.x, y: at_a0.point.y, z: at_a0.point.z });
        let e_25 = sum_v0;
        let e_26 = seen_v2;
        let e_27 = finest_normal(r, ex, &e_26, Vec2 { x: e_23.x, y: e_23.y });
        let e_28 = k_v1;
        let e_29 = frame_weight(r, frames_a1, e_28);
        sum_v0 = Vec3 { x: add(e_25.x, mul(e_27.x, e_29)), y: add(e_25.y, mul(e_27.y, e_29)), z: add(e_25.z, mul(e_27.z, e_29)) };
        let e_32 = k_v1;
        k_v1 = e_32.wrapping_add(1u32);
    }
    let e_35 = sum_v0;
    let e_36 = sum_v0;
    let square_37 = add(add(add(mul(e_35.x, e_36.x), mul(e_35.y, e_36.y)), mul(e_35.z, e_36.z)), splat(0.0f32));
    let c2 = gt(square_37, splat(0.0f32));
    let e_40 = sum_v0;
    let e_41 = sqrt(square_37);
    ret = Vec3 { x: div(e_40.x, e_41), y: div(e_40.y, e_41), z: div(e_40.z, e_41) };
    ex = and_not(ex, c2);
    let y3 = Vec3 { x: at_a0.normal.x, y: at_a0.normal.y, z: at_a0.normal.z };
    return Vec3 { x: sel(ex, y3.x, ret.x), y: sel(ex, y3.y, ret.y), z: sel(ex, y3.z, ret.z) };
} }
lanes! { fn surface_frames_place(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, path_a2: &Path, hit_a3: &Hit, params_a4: Vec4<f32>) -> Entered {
    let mut ex = within;
    let mut ret: Entered = zero_entered();
    let mut placed_v0: Entered = zero_entered();
    let mut both_v1: bool = false;
    let e_5 = placed_in_image(r, ex, pixel_a0, at_a1, path_a2, hit_a3);
    placed_v0 = e_5;
    if (r.surface_settings.has_vertex_normals == 1u32) {
        both_v1 = (r.surface_settings.cells != 4u32);
    } else {
        both_v1 = false;
    }
    let e_20 = both_v1;
    if e_20 {
        let e_22 = placed_v0;
        let length1 = sqrt(add(add(mul(pixel_a0.direction.x, pixel_a0.direction.x), mul(pixel_a0.direction.y, pixel_a0.direction.y)), mul(pixel_a0.direction.z, pixel_a0.direction.z)));
        let e_24 = Vec3 { x: div(pixel_a0.direction.x, length1), y: div(pixel_a0.direction.y, length1), z: div(pixel_a0.direction.z, length1) };
        let e_26 = frames_around(r, ex, Vec3 { x: neg(e_24.x), y: neg(e_24.y), z: neg(e_24.z) });
        let e_27 = normal_of_frames(r, ex, &e_22, &e_26);
        placed_v0.normal = e_27;
    }
    let e_28 = placed_v0;
    return e_28;
} }
lanes! { fn surface_object_slices_place(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, path_a2: &Path, hit_a3: &Hit, params_a4: Vec4<f32>) -> Entered {
    let mut ex = within;
    let mut ret: Entered = zero_entered();
    let mut of_image_v0: Path = zero_path();
    let mut placed_v1: Entered = zero_entered();
    let e_6 = slice_at(r, ex, Vec3 { x: at_a1.point.x, y: at_a1.point.y, z: at_a1.point.z });
    of_image_v0 = *path_a2;
    of_image_v0.base = f_of_u(e_6.number);
    let e_11 = of_image_v0;
    let e_12 = placed_in_image(r, ex, pixel_a0, at_a1, &e_11, hit_a3);
    placed_v1 = e_12;
    if (r.surface_settings.cells == 4u32) {
        let e_20 = image_of_object_l(r, ex, e_6.number);
        let e_23 = normal_of_mask(r, ex, &e_20, Vec2 { x: hit_a3.uv.x, y: hit_a3.uv.y }, Vec3 { x: at_a1.normal.x, y: at_a1.normal.y, z: at_a1.normal.z });
        placed_v1.normal = e_23;
        let e_26 = placed_v1.normal;
        placed_v1.facing = e_26;
    }
    let e_27 = placed_v1;
    return e_27;
} }
lanes! { fn surface_place_stage(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, path_a2: &Path, hit_a3: &Hit) -> Entered {
    let mut ex = within;
    let mut ret: Entered = zero_entered();
    match r.surface_settings.choices[1].number {
        0u32 => {
            let e_14 = surface_plane_place(r, ex, pixel_a0, at_a1, path_a2, hit_a3, r.surface_settings.choices[1].params);
            return e_14;
        }
        1u32 => {
            let e_20 = surface_prism_place(r, ex, pixel_a0, at_a1, path_a2, hit_a3, r.surface_settings.choices[1].params);
            return e_20;
        }
        2u32 => {
            let e_26 = surface_quadric_perpendicular_place(r, ex, pixel_a0, at_a1, path_a2, hit_a3, r.surface_settings.choices[1].params);
            return e_26;
        }
        3u32 => {
            let e_32 = surface_quadric_vertical_place(r, ex, pixel_a0, at_a1, path_a2, hit_a3, r.surface_settings.choices[1].params);
            return e_32;
        }
        4u32 => {
            let e_38 = surface_tetrahedra_place(r, ex, pixel_a0, at_a1, path_a2, hit_a3, r.surface_settings.choices[1].params);
            return e_38;
        }
        5u32 => {
            let e_44 = surface_facets_place(r, pixel_a0, at_a1, path_a2, hit_a3, r.surface_settings.choices[1].params);
            return e_44;
        }
        6u32 => {
            let e_50 = surface_slices_place(r, ex, pixel_a0, at_a1, path_a2, hit_a3, r.surface_settings.choices[1].params);
            return e_50;
        }
        7u32 => {
            let e_56 = surface_object_place(r, ex, pixel_a0, at_a1, path_a2, hit_a3, r.surface_settings.choices[1].params);
            return e_56;
        }
        8u32 => {
            let e_62 = surface_frames_place(r, ex, pixel_a0, at_a1, path_a2, hit_a3, r.surface_settings.choices[1].params);
            return e_62;
        }
        _ => {
            let e_68 = surface_object_slices_place(r, ex, pixel_a0, at_a1, path_a2, hit_a3, r.surface_settings.choices[1].params);
            return e_68;
        }
    }
} }
stage! { pub(super) fn place_on_segment(r: &Resources<'_>, within: M, pixel_a0: &PixelIn, at_a1: &Entered, path_a2: &Path, hit_a3: &Hit) -> Entered {
    let mut ex = within;
    let mut ret: Entered = zero_entered();
    let mut placed_v0: Entered = zero_entered();
    let e_4 = surface_place_stage(r, ex, pixel_a0, at_a1, path_a2, hit_a3);
    placed_v0 = e_4;
    let e_7 = depth_on_ray(r, pixel_a0, path_a2, hit_a3);
    placed_v0.depth = e_7;
    let e_8 = placed_v0;
    return e_8;
} }
lanes! { fn toward_light(r: &Resources<'_>, number_a0: u32, position_a1: Vec3<F>) -> Toward {
    if (r.frame.lights[number_a0 as usize].place.w > 0.5f32) {
        let toward_12 = Vec3 { x: sub(splat(r.frame.lights[number_a0 as usize].place.x), position_a1.x), y: sub(splat(r.frame.lights[number_a0 as usize].place.y), position_a1.y), z: sub(splat(r.frame.lights[number_a0 as usize].place.z), position_a1.z) };
        let squared_13 = add(add(add(mul(toward_12.x, toward_12.x), mul(toward_12.y, toward_12.y)), mul(toward_12.z, toward_12.z)), splat(0.0f32));
        let distance_14 = sqrt(squared_13);
        let falloff_18 = div(splat(1.0f32), max_with(squared_13, splat(1e-6f32)));
        let length1 = sqrt(add(add(mul(toward_12.x, toward_12.x), mul(toward_12.y, toward_12.y)), mul(toward_12.z, toward_12.z)));
        let e_19 = Vec3 { x: div(toward_12.x, length1), y: div(toward_12.y, length1), z: div(toward_12.z, length1) };
        return Toward { direction: e_19, falloff: falloff_18, distance: distance_14, radius: div(splat(r.frame.lights[number_a0 as usize].color.w), distance_14), number: splat_u(number_a0), };
    }
    let length2 = (((r.frame.lights[number_a0 as usize].place.x * r.frame.lights[number_a0 as usize].place.x) + (r.frame.lights[number_a0 as usize].place.y * r.frame.lights[number_a0 as usize].place.y)) + (r.frame.lights[number_a0 as usize].place.z * r.frame.lights[number_a0 as usize].place.z)).sqrt();
    let e_26 = Vec3 { x: r.frame.lights[number_a0 as usize].place.x / length2, y: r.frame.lights[number_a0 as usize].place.y / length2, z: r.frame.lights[number_a0 as usize].place.z / length2 };
    return Toward { direction: Vec3 { x: splat(e_26.x), y: splat(e_26.y), z: splat(e_26.z) }, falloff: splat(1.0f32), distance: splat(3e38f32), radius: splat(r.frame.lights[number_a0 as usize].color.w), number: splat_u(number_a0), };
} }
lanes! { fn quarter_sine(r: &Resources<'_>, turn_a0: F) -> F {
    let x_2 = mul(turn_a0, splat(6.2831855f32));
    let s_3 = mul(x_2, x_2);
    let last_7 = add(splat((-0.0001984127f32)), mul(s_3, splat(2.7557319e-6f32)));
    return mul(x_2, add(splat(1.0f32), mul(s_3, add(splat((-0.16666667f32)), mul(s_3, add(splat(0.008333334f32), mul(s_3, last_7)))))));
} }
lanes! { fn sine_of(r: &Resources<'_>, turn_a0: F) -> F {
    let part_2 = sub(turn_a0, floor(turn_a0));
    let sine_11 = quarter_sine(r, sub(splat(0.25f32), abs(sub(splat(0.25f32), abs(sub(part_2, splat(0.5f32)))))));
    return sel(gt(part_2, splat(0.5f32)), sub(splat(0.0f32), sine_11), sine_11);
} }
lanes! { fn turned(r: &Resources<'_>, turn_a0: F) -> Vec2<F> {
    let e_3 = sine_of(r, add(turn_a0, splat(0.25f32)));
    let e_4 = sine_of(r, turn_a0);
    return Vec2 { x: e_3, y: e_4 };
} }
lanes! { fn unit_of(r: &Resources<'_>, bits_a0: U) -> F {
    return div(f_of_u(shr_u(bits_a0, i_of_u(splat_u(8u32)))), splat(16777216.0f32));
} }
stage! { fn shadow_ray(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, light_a2: &Toward, params_a3: Vec4<f32>) -> F {
    if none(within) { return splat(0f32); }
    let at_a0 = singles_entered(at_a0);
    let hit_a1 = singles_hit(hit_a1);
    let light_a2 = singles_toward(light_a2);
    let one = |lane: usize| r.shadow_ray(at_a0[lane], hit_a1[lane], light_a2[lane], params_a3);
    let mut rest = bits_of(within);
    let mut results = [one(rest.trailing_zeros() as usize); LANES];
    rest &= rest - 1;
    while rest != 0 {
        let lane = rest.trailing_zeros() as usize;
        results[lane] = one(lane);
        rest &= rest - 1;
    }
    load(&std::array::from_fn(|lane| results[lane]))
} }
lanes! { fn shadow_none(r: &Resources<'_>, at_a0: &Entered, hit_a1: &Hit, light_a2: &Toward, params_a3: Vec4<f32>) -> F {
    return splat(1.0f32);
} }
stage! { fn shadow_entry(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, light_a2: &Toward, params_a3: Vec4<f32>) -> F {
    if none(within) { return splat(0f32); }
    let at_a0 = singles_entered(at_a0);
    let hit_a1 = singles_hit(hit_a1);
    let light_a2 = singles_toward(light_a2);
    let one = |lane: usize| r.shadow_entry(at_a0[lane], hit_a1[lane], light_a2[lane], params_a3);
    let mut rest = bits_of(within);
    let mut results = [one(rest.trailing_zeros() as usize); LANES];
    rest &= rest - 1;
    while rest != 0 {
        let lane = rest.trailing_zeros() as usize;
        results[lane] = one(lane);
        rest &= rest - 1;
    }
    load(&std::array::from_fn(|lane| results[lane]))
} }
lanes! { fn seed_of(r: &Resources<'_>, hit_a0: &Hit) -> U {
    let place_7 = Vec2 { x: u_of_f(mul(sub(hit_a0.uv.x, floor(hit_a0.uv.x)), splat(16777216.0f32))), y: u_of_f(mul(sub(hit_a0.uv.y, floor(hit_a0.uv.y)), splat(16777216.0f32))) };
    let e_10 = mixed(r, place_7.y);
    let e_12 = mixed(r, xor_u(place_7.x, e_10));
    return e_12;
} }
lanes! { fn point_of_disc(r: &Resources<'_>, light_a0: &Toward, seed_a1: U, k_a2: u32, count_a3: u32) -> Toward {
    let e_8 = mixed(r, add_u(add_u(seed_a1, splat_u(k_a2)), splat_u(1u32)));
    let e_9 = unit_of(r, e_8);
    let ring_12 = div(add(splat((k_a2 as f32)), e_9), splat((count_a3 as f32)));
    let e_16 = unit_of(r, seed_a1);
    let e_18 = turned(r, add(splat(((k_a2 as f32) * 0.618034f32)), e_16));
    let e_21 = mul(sqrt(ring_12), light_a0.radius);
    let place_22 = Vec2 { x: mul(e_18.x, e_21), y: mul(e_18.y, e_21) };
    let other_30 = sel(gt(abs(light_a0.direction.x), splat(0.6f32)), splat(1.0f32), splat(0.0f32));
    let e_34 = Vec3 { x: sub(splat(1.0f32), other_30), y: other_30, z: splat(0.0f32) };
    let e_36 = Vec3 { x: sub(mul(e_34.y, light_a0.direction.z), mul(e_34.z, light_a0.direction.y)), y: sub(mul(e_34.z, light_a0.direction.x), mul(e_34.x, light_a0.direction.z)), z: sub(mul(e_34.x, light_a0.direction.y), mul(e_34.y, light_a0.direction.x)) };
    let length1 = sqrt(add(add(mul(e_36.x, e_36.x), mul(e_36.y, e_36.y)), mul(e_36.z, e_36.z)));
    let right_37 = Vec3 { x: div(e_36.x, length1), y: div(e_36.y, length1), z: div(e_36.z, length1) };
    let up_39 = Vec3 { x: sub(mul(light_a0.direction.y, right_37.z), mul(light_a0.direction.z, right_37.y)), y: sub(mul(light_a0.direction.z, right_37.x), mul(light_a0.direction.x, right_37.z)), z: sub(mul(light_a0.direction.x, right_37.y), mul(light_a0.direction.y, right_37.x)) };
    let toward_46 = Vec3 { x: add(add(light_a0.direction.x, mul(right_37.x, place_22.x)), mul(up_39.x, place_22.y)), y: add(add(light_a0.direction.y, mul(right_37.y, place_22.x)), mul(up_39.y, place_22.y)), z: add(add(light_a0.direction.z, mul(right_37.z, place_22.x)), mul(up_39.z, place_22.y)) };
    let along_47 = sqrt(add(add(mul(toward_46.x, toward_46.x), mul(toward_46.y, toward_46.y)), mul(toward_46.z, toward_46.z)));
    return Toward { direction: Vec3 { x: div(toward_46.x, along_47), y: div(toward_46.y, along_47), z: div(toward_46.z, along_47) }, falloff: light_a0.falloff, distance: mul(light_a0.distance, along_47), radius: splat(0.0f32), number: light_a0.number, };
} }
stage! { fn shadow_soft(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, light_a2: &Toward, params_a3: Vec4<f32>) -> F {
    if none(within) { return splat(0f32); }
    let at_a0 = singles_entered(at_a0);
    let hit_a1 = singles_hit(hit_a1);
    let light_a2 = singles_toward(light_a2);
    let one = |lane: usize| r.shadow_soft(at_a0[lane], hit_a1[lane], light_a2[lane], params_a3);
    let mut rest = bits_of(within);
    let mut results = [one(rest.trailing_zeros() as usize); LANES];
    rest &= rest - 1;
    while rest != 0 {
        let lane = rest.trailing_zeros() as usize;
        results[lane] = one(lane);
        rest &= rest - 1;
    }
    load(&std::array::from_fn(|lane| results[lane]))
} }
stage! { fn shadow_heuristic(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, light_a2: &Toward, params_a3: Vec4<f32>) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let mut most_v0: F = splat(0.0f32);
    let mut k_v1: f32 = 1.0f32;
    let path_4 = from_hit(r, ex, at_a0, hit_a1, light_a2);
    let c1 = not(gt(path_4.h.y, splat(0.0f32)));
    ret = splat(0.0f32);
    ex = and_not(ex, c1);
    if none(ex) { return ret; }
    let way_11 = way_out(r, ex, &path_4, light_a2);
    'l2: loop {
        let e_16 = k_v1;
        if (e_16 < params_a3.x) {
        } else {
            break 'l2;
        }
        let e_19 = k_v1;
        let part_21 = (e_19 / params_a3.x);
        let e_22 = most_v0;
        let e_24 = path_gap(r, ex, &path_4, mul(splat(part_21), way_11));
        most_v0 = max(e_22, mul(sub(splat(0.0f32), e_24), splat((1.0f32 - part_21))));
        let e_31 = k_v1;
        k_v1 = (e_31 + 1.0f32);
    }
    let e_35 = most_v0;
    return sel(ex, sub(splat(1.0f32), min_with(mul(splat(params_a3.y), e_35), splat(1.0f32))), ret);
} }
lanes! { fn shadow_texel(r: &Resources<'_>, within: M, place_a0: Vec2<I>, layer_a1: I, level_a2: I) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let e_4 = map_texel_of_each(&r.shadow_texels, ex, place_a0.x, place_a0.y, layer_a1, level_a2);
    let e_9 = decoded(r, e_4, &r.surface_settings.maps[3]);
    return e_9;
} }
lanes! { fn shadow_texel_between(r: &Resources<'_>, within: M, uv_a0: Vec2<F>, layer_a1: I, level_a2: U) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let e_3 = height_texels(r, level_a2);
    let at_4 = texels_around(r, ex, uv_a0, e_3);
    let k_5 = i_of_u(level_a2);
    let e_11 = shadow_texel(r, ex, Vec2 { x: at_4.columns.x, y: at_4.rows.x }, layer_a1, k_5);
    let e_17 = shadow_texel(r, ex, Vec2 { x: at_4.columns.y, y: at_4.rows.x }, layer_a1, k_5);
    let e_23 = shadow_texel(r, ex, Vec2 { x: at_4.columns.x, y: at_4.rows.y }, layer_a1, k_5);
    let e_29 = shadow_texel(r, ex, Vec2 { x: at_4.columns.y, y: at_4.rows.y }, layer_a1, k_5);
    let e_31 = bilinear(r, e_11, e_17, e_23, e_29, Vec2 { x: at_4.part.x, y: at_4.part.y });
    return e_31;
} }
lanes! { fn own_slope(r: &Resources<'_>, within: M, way_a0: &Path) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let mut level_v0: Path = zero_path();
    let grid_1 = grid_of(r, way_a0);
    let cell_3 = cell_of(r, Vec2 { x: grid_1.origin.x, y: grid_1.origin.y });
    let leave_4 = cell_leave(r, &grid_1, cell_3);
    let end_9 = max_with(min(leave_4.x, leave_4.y), splat(0.0f32));
    level_v0 = *way_a0;
    level_v0.h = Vec3 { x: way_a0.h.x, y: splat(0.0f32), z: splat(0.0f32) };
    level_v0.exit = end_9;
    let e_18 = level_v0;
    let e_21 = height_cell_ll(r, ex, Vec2 { x: i_of_small(cell_3.x), y: i_of_small(cell_3.y) }, way_a0.level);
    let c_23 = gap_to(r, &e_18, &grid_1, cell_3, e_21, splat(0.0f32));
    return sub(splat(0.0f32), min(c_23.y, add(c_23.y, mul(c_23.z, end_9))));
} }
lanes! { fn part_above(r: &Resources<'_>, height_a0: F) -> F {
    let x_3 = min_with(max_with(height_a0, splat((-1.0f32))), splat(1.0f32));
    let s_4 = mul(x_3, x_3);
    return add(splat(0.5f32), mul(x_3, add(splat(0.6401074f32), mul(s_4, add(splat((-0.13985065f32)), mul(s_4, add(splat(0.06702511f32), mul(s_4, splat((-0.06728186f32))))))))));
} }
lanes! { fn shadow_horizon(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, light_a2: &Toward, params_a3: Vec4<f32>) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let change_5 = climb(r, at_a0, Vec3 { x: light_a2.direction.x, y: light_a2.direction.y, z: light_a2.direction.z });
    let along_12 = Vec2 { x: mul(change_5.x, splat(r.surface_settings.maps[3].tile_m.x)), y: mul(change_5.y, splat(r.surface_settings.maps[3].tile_m.y)) };
    let e_13 = turn_of(r, ex, along_12);
    let azimuth_15 = mul(e_13, splat(params_a3.x));
    let first_16 = floor(azimuth_15);
    let count_18 = (params_a3.x as i32);
    let before_20 = rem_i(i_of_f(first_16), splat_i(count_18));
    let part_21 = sub(azimuth_15, first_16);
    let e_24 = shadow_texel_between(r, ex, Vec2 { x: hit_a1.uv.x, y: hit_a1.uv.y }, before_20, at_a0.level);
    let e_31 = shadow_texel_between(r, ex, Vec2 { x: hit_a1.uv.x, y: hit_a1.uv.y }, rem_i(add_i(before_20, splat_i(1i32)), splat_i(count_18)), at_a0.level);
    let sine_35 = add(e_24.x, mul(sub(e_31.x, e_24.x), part_21));
    let squared_44 = div(mul(sine_35, sine_35), max_with(mul(sub(splat(1.0f32), sine_35), add(splat(1.0f32), sine_35)), splat(1e-7f32)));
    let far_47 = sqrt(mul(squared_44, add(add(mul(along_12.x, along_12.x), mul(along_12.y, along_12.y)), splat(0.0f32))));
    let e_48 = from_hit(r, ex, at_a0, hit_a1, light_a2);
    let e_49 = own_slope(r, ex, &e_48);
    let near_53 = mul(e_49, splat(r.surface_settings.scale_m));
    let horizon_54 = max(far_47, near_53);
    let up_57 = add(add(add(mul(at_a0.normal.x, light_a2.direction.x), mul(at_a0.normal.y, light_a2.direction.y)), mul(at_a0.normal.z, light_a2.direction.z)), splat(0.0f32));
    let c1 = not(gt(light_a2.radius, splat(0.0f32)));
    ret = sel(gt(up_57, horizon_54), splat(1.0f32), splat(0.0f32));
    ex = and_not(ex, c1);
    let flat_70 = max_with(sub(splat(1.0f32), mul(up_57, up_57)), splat(0.0f32));
    let beside_72 = add(flat_70, mul(up_57, horizon_54));
    let c2 = not(gt(beside_72, splat(0.0f32)));
    ret = sel(and(ex, c2), sel(gt(up_57, horizon_54), splat(1.0f32), splat(0.0f32)), ret);
    ex = and_not(ex, c2);
    if none(ex) { return ret; }
    let e_86 = part_above(r, div(mul(sqrt(flat_70), sub(up_57, horizon_54)), mul(beside_72, light_a2.radius)));
    return sel(ex, e_86, ret);
} }
lanes! { fn open_part(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, azimuth_a2: I, elevation_a3: I, elevations_a4: i32) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let e_9 = shadow_texel_between(r, ex, Vec2 { x: hit_a1.uv.x, y: hit_a1.uv.y }, add_i(mul_i(azimuth_a2, splat_i(elevations_a4)), elevation_a3), at_a0.level);
    return sub(splat(1.0f32), e_9.z);
} }
lanes! { fn shadow_visibility(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, light_a2: &Toward, params_a3: Vec4<f32>) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let change_5 = climb(r, at_a0, Vec3 { x: light_a2.direction.x, y: light_a2.direction.y, z: light_a2.direction.z });
    let c1 = not(gt(change_5.z, splat(0.0f32)));
    ret = splat(0.0f32);
    ex = and_not(ex, c1);
    let along_17 = Vec2 { x: mul(change_5.x, splat(r.surface_settings.maps[3].tile_m.x)), y: mul(change_5.y, splat(r.surface_settings.maps[3].tile_m.y)) };
    let height_22 = mul(change_5.z, splat(r.surface_settings.scale_m));
    let squared_27 = div(mul(height_22, height_22), add(add(add(mul(along_17.x, along_17.x), mul(along_17.y, along_17.y)), splat(0.0f32)), mul(height_22, height_22)));
    let azimuths_29 = (params_a3.x as i32);
    let elevations_31 = (params_a3.y as i32);
    if none(ex) { return ret; }
    let e_32 = turn_of(r, ex, along_17);
    let azimuth_34 = mul(e_32, splat(params_a3.x));
    let elevation_43 = min(max_with(sub(mul(squared_27, splat(params_a3.y)), splat(0.5f32)), splat(0.0f32)), splat((params_a3.y - 1.0f32)));
    if (params_a3.z < 2.0f32) {
        let a_51 = rem_i(i_of_f(floor(add(azimuth_34, splat(0.5f32)))), splat_i(azimuths_29));
        let e_56 = open_part(r, ex, at_a0, hit_a1, a_51, i_of_f(floor(add(elevation_43, splat(0.5f32)))), elevations_31);
        return sel(ex, e_56, ret);
    }
    let a0_59 = rem_i(i_of_f(floor(azimuth_34)), splat_i(azimuths_29));
    let a1_62 = rem_i(add_i(a0_59, splat_i(1i32)), splat_i(azimuths_29));
    let e0_64 = i_of_f(floor(elevation_43));
    let e1_69 = min_i(add_i(e0_64, splat_i(1i32)), splat_i(elevations_31.wrapping_sub(1i32)));
    let along_azimuth_71 = sub(azimuth_34, floor(azimuth_34));
    let along_elevation_73 = sub(elevation_43, floor(elevation_43));
    let right_74 = open_part(r, ex, at_a0, hit_a1, a1_62, e0_64, elevations_31);
    let above_75 = open_part(r, ex, at_a0, hit_a1, a0_59, e1_69, elevations_31);
    let (b2, c3) = (ex, le(add(along_azimuth_71, along_elevation_73), splat(1.0f32)));
    ex = and(b2, c3);
    if any(ex) {
        let corner_79 = open_part(r, ex, at_a0, hit_a1, a0_59, e0_64, elevations_31);
        ret = sel(ex, add(add(corner_79, mul(sub(right_74, corner_79), along_azimuth_71)), mul(sub(above_75, corner_79), along_elevation_73)), ret);
        ex = no_lane();
    }
    ex = and_not(b2, c3);
    if none(ex) { return ret; }
    let corner_86 = open_part(r, ex, at_a0, hit_a1, a1_62, e1_69, elevations_31);
    return sel(ex, add(add(corner_86, mul(sub(above_75, corner_86), sub(splat(1.0f32), along_azimuth_71))), mul(sub(right_74, corner_86), sub(splat(1.0f32), along_elevation_73))), ret);
} }
stage! { fn shadow_map(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, light_a2: &Toward, params_a3: Vec4<f32>) -> F {
    if none(within) { return splat(0f32); }
    let at_a0 = singles_entered(at_a0);
    let hit_a1 = singles_hit(hit_a1);
    let light_a2 = singles_toward(light_a2);
    let one = |lane: usize| r.shadow_map(at_a0[lane], hit_a1[lane], light_a2[lane], params_a3);
    let mut rest = bits_of(within);
    let mut results = [one(rest.trailing_zeros() as usize); LANES];
    rest &= rest - 1;
    while rest != 0 {
        let lane = rest.trailing_zeros() as usize;
        results[lane] = one(lane);
        rest &= rest - 1;
    }
    load(&std::array::from_fn(|lane| results[lane]))
} }
lanes! { fn shadow_scene(r: &Resources<'_>, at_a0: &Entered, hit_a1: &Hit, light_a2: &Toward, params_a3: Vec4<f32>) -> F {
    return splat(1.0f32);
} }
lanes! { fn shadow_stage(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, light_a2: &Toward) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    match r.surface_settings.choices[9].number {
        0u32 => {
            let e_13 = shadow_ray(r, ex, at_a0, hit_a1, light_a2, r.surface_settings.choices[9].params);
            return e_13;
        }
        1u32 => {
            let e_19 = shadow_none(r, at_a0, hit_a1, light_a2, r.surface_settings.choices[9].params);
            return e_19;
        }
        2u32 => {
            let e_25 = shadow_entry(r, ex, at_a0, hit_a1, light_a2, r.surface_settings.choices[9].params);
            return e_25;
        }
        3u32 => {
            let e_31 = shadow_soft(r, ex, at_a0, hit_a1, light_a2, r.surface_settings.choices[9].params);
            return e_31;
        }
        4u32 => {
            let e_37 = shadow_heuristic(r, ex, at_a0, hit_a1, light_a2, r.surface_settings.choices[9].params);
            return e_37;
        }
        5u32 => {
            let e_43 = shadow_horizon(r, ex, at_a0, hit_a1, light_a2, r.surface_settings.choices[9].params);
            return e_43;
        }
        6u32 => {
            let e_49 = shadow_visibility(r, ex, at_a0, hit_a1, light_a2, r.surface_settings.choices[9].params);
            return e_49;
        }
        7u32 => {
            let e_55 = shadow_map(r, ex, at_a0, hit_a1, light_a2, r.surface_settings.choices[9].params);
            return e_55;
        }
        _ => {
            let e_61 = shadow_scene(r, at_a0, hit_a1, light_a2, r.surface_settings.choices[9].params);
            return e_61;
        }
    }
} }
lanes! { fn object_blend_color(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, view_a2: Vec3<F>, params_a3: Vec4<f32>) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let e_5 = color_of_object(r, ex, at_a0, view_a2, params_a3.z);
    return e_5;
} }
lanes! { fn object_none_color(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, view_a2: Vec3<F>, params_a3: Vec4<f32>) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let e_6 = color_or_white(r, ex, Vec2 { x: hit_a1.uv.x, y: hit_a1.uv.y }, at_a0.footprint);
    return e_6;
} }
lanes! { fn object_depth_color(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, view_a2: Vec3<F>, params_a3: Vec4<f32>) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let e_5 = color_of_object(r, ex, at_a0, view_a2, params_a3.z);
    return e_5;
} }
lanes! { fn object_hull_color(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, view_a2: Vec3<F>, params_a3: Vec4<f32>) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let e_5 = color_of_object(r, ex, at_a0, view_a2, params_a3.z);
    return e_5;
} }
lanes! { fn object_color_stage(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, view_a2: Vec3<F>) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    match r.surface_settings.choices[3].number {
        0u32 => {
            let e_13 = object_none_color(r, ex, at_a0, hit_a1, view_a2, r.surface_settings.choices[3].params);
            return e_13;
        }
        1u32 => {
            let e_19 = object_depth_color(r, ex, at_a0, hit_a1, view_a2, r.surface_settings.choices[3].params);
            return e_19;
        }
        2u32 => {
            let e_25 = object_hull_color(r, ex, at_a0, hit_a1, view_a2, r.surface_settings.choices[3].params);
            return e_25;
        }
        _ => {
            let e_31 = object_blend_color(r, ex, at_a0, hit_a1, view_a2, r.surface_settings.choices[3].params);
            return e_31;
        }
    }
} }
lanes! { fn occlusion_roughness_metalness(r: &Resources<'_>, within: M, uv_a0: Vec2<F>, footprint_a1: F) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    if ((r.surface_settings.has_material & 1u32) == 0u32) {
        return Vec3 { x: splat(1.0f32), y: splat(1.0f32), z: splat(1.0f32) };
    }
    let e_14 = material_layer(r, ex, uv_a0, footprint_a1, 0i32);
    return e_14;
} }
stage! { pub(super) fn pixel_eye(r: &Resources<'_>, pixel_a0: Vec2<F>) -> Vec3<F> {
    return Vec3 { x: add(add(splat(r.frame.eye.x), mul(splat(r.frame.eye_right.x), pixel_a0.x)), mul(splat(r.frame.eye_down.x), pixel_a0.y)), y: add(add(splat(r.frame.eye.y), mul(splat(r.frame.eye_right.y), pixel_a0.x)), mul(splat(r.frame.eye_down.y), pixel_a0.y)), z: add(add(splat(r.frame.eye.z), mul(splat(r.frame.eye_right.z), pixel_a0.x)), mul(splat(r.frame.eye_down.z), pixel_a0.y)) };
} }
lanes! { fn point_of_light(r: &Resources<'_>, at_a0: &Entered, hit_a1: &Hit, number_a2: u32, k_a3: u32, count_a4: u32) -> Toward {
    let toward_6 = toward_light(r, number_a2, Vec3 { x: at_a0.point.x, y: at_a0.point.y, z: at_a0.point.z });
    if (count_a4 > 0u32) {
        let e_9 = seed_of(r, hit_a1);
        let e_10 = point_of_disc(r, &toward_6, e_9, k_a3, count_a4);
        return e_10;
    }
    return toward_6;
} }
stage! { pub(super) fn ray_to_light(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, number_a2: u32, k_a3: u32, count_a4: u32) -> LightRay {
    let mut ex = within;
    let mut ret: LightRay = zero_light_ray();
    let e_5 = point_of_light(r, at_a0, hit_a1, number_a2, k_a3, count_a4);
    let e_6 = field_light_ray_stage(r, ex, at_a0, hit_a1, &e_5);
    return e_6;
} }
lanes! { fn shade_blinn_phong_material(r: &Resources<'_>, at_a0: &Entered, hit_a1: &Hit, normal_a2: Vec3<F>, mean_a3: F, view_a4: Vec3<F>, color_a5: Vec3<F>, params_a6: Vec4<f32>) -> Material {
    let e_16 = (1.0f32 - r.surface_settings.transmission);
    let diffuse_17 = Vec3 { x: mul(mul(splat(r.surface_settings.diffuse.x), color_a5.x), splat(e_16)), y: mul(mul(splat(r.surface_settings.diffuse.y), color_a5.y), splat(e_16)), z: mul(mul(splat(r.surface_settings.diffuse.z), color_a5.z), splat(e_16)) };
    let none_21 = Vec3 { x: 0.0f32, y: 0.0f32, z: 0.0f32 };
    let transmitted_22 = Vec3 { x: r.surface_settings.transmission, y: r.surface_settings.transmission, z: r.surface_settings.transmission };
    return Material { diffuse: diffuse_17, transmitted: Vec3 { x: splat(transmitted_22.x), y: splat(transmitted_22.y), z: splat(transmitted_22.z) }, specular: Vec3 { x: splat(r.surface_settings.specular.x), y: splat(r.surface_settings.specular.y), z: splat(r.surface_settings.specular.z) }, around: diffuse_17, emission: Vec3 { x: splat(none_21.x), y: splat(none_21.y), z: splat(none_21.z) }, occlusion: splat(1.0f32), roughness: splat(0.0f32), alpha: splat(0.0f32), squared_alpha: splat(0.0f32), upright: splat(0.0f32), masking: splat(0.0f32), again: splat(0.0f32), };
} }
lanes! { fn shade_metallic_roughness_material(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, normal_a2: Vec3<F>, mean_a3: F, view_a4: Vec3<F>, color_a5: Vec3<F>, params_a6: Vec4<f32>) -> Material {
    let mut ex = within;
    let mut ret: Material = zero_material();
    let mut roughness_v0: F = splat(0f32);
    let mut alpha_v1: F = splat(0f32);
    let mut squared_alpha_v2: F = splat(0f32);
    let maps_9 = occlusion_roughness_metalness(r, ex, Vec2 { x: hit_a1.uv.x, y: hit_a1.uv.y }, at_a0.footprint);
    roughness_v0 = max_with(mul(splat(r.surface_settings.roughness), maps_9.y), splat(0.045f32));
    let metallic_22 = mul(splat(r.surface_settings.metallic), maps_9.z);
    let base_27 = Vec3 { x: mul(splat(r.surface_settings.diffuse.x), color_a5.x), y: mul(splat(r.surface_settings.diffuse.y), color_a5.y), z: mul(splat(r.surface_settings.diffuse.z), color_a5.z) };
    let e_35 = mul(sub(splat(1.0f32), metallic_22), splat((1.0f32 - r.surface_settings.transmission)));
    let diffuse_36 = Vec3 { x: mul(base_27.x, e_35), y: mul(base_27.y, e_35), z: mul(base_27.z, e_35) };
    let e_39 = mul(sub(splat(1.0f32), metallic_22), splat(r.surface_settings.transmission));
    let transmitted_40 = Vec3 { x: mul(base_27.x, e_39), y: mul(base_27.y, e_39), z: mul(base_27.z, e_39) };
    let specular_52 = Vec3 { x: add(splat(r.surface_settings.specular.x), mul(max_with(sub(base_27.x, splat(r.surface_settings.specular.x)), splat((-1.0f32))), metallic_22)), y: add(splat(r.surface_settings.specular.y), mul(max_with(sub(base_27.y, splat(r.surface_settings.specular.y)), splat((-1.0f32))), metallic_22)), z: add(splat(r.surface_settings.specular.z), mul(max_with(sub(base_27.z, splat(r.surface_settings.specular.z)), splat((-1.0f32))), metallic_22)) };
    let e_53 = roughness_v0;
    let e_54 = roughness_v0;
    alpha_v1 = mul(e_53, e_54);
    let e_57 = alpha_v1;
    let e_58 = alpha_v1;
    squared_alpha_v2 = mul(e_57, e_58);
    let (b1, c2) = (ex, lt(mean_a3, splat(1.0f32)));
    ex = and(b1, c2);
    if any(ex) {
        let e_63 = squared_alpha_v2;
        squared_alpha_v2 = sel(ex, min_with(add(e_63, div(mul(splat(2.0f32), sub(splat(1.0f32), mean_a3)), mean_a3)), splat(1.0f32)), squared_alpha_v2);
        let e_72 = squared_alpha_v2;
        alpha_v1 = sel(ex, sqrt(e_72), alpha_v1);
        let e_74 = alpha_v1;
        roughness_v0 = sel(ex, sqrt(e_74), roughness_v0);
    }
    ex = b1;
    let upright_78 = max_with(add(add(add(mul(normal_a2.x, view_a4.x), mul(normal_a2.y, view_a4.y)), mul(normal_a2.z, view_a4.z)), splat(0.0f32)), splat(0.0001f32));
    let aside_83 = max_with(sub(splat(1.0f32), mul(upright_78, upright_78)), splat(0.0f32));
    let e_85 = squared_alpha_v2;
    let masking_88 = sqrt(add(mul(upright_78, upright_78), mul(e_85, aside_83)));
    let e_89 = alpha_v1;
    let e_90 = roughness_v0;
    let once_91 = facet_reflection(r, upright_78, e_89, e_90);
    let again_98 = max_with(sub(div(splat(1.0f32), once_91.x), splat(1.0f32)), splat(0.0f32));
    let white_102 = Vec3 { x: 1.0f32, y: 1.0f32, z: 1.0f32 };
    let e_103 = reflected_by(r, once_91, specular_52);
    let reflected_106 = Vec3 { x: mul(e_103.x, add(splat(white_102.x), mul(specular_52.x, again_98))), y: mul(e_103.y, add(splat(white_102.y), mul(specular_52.y, again_98))), z: mul(e_103.z, add(splat(white_102.z), mul(specular_52.z, again_98))) };
    let e_117 = emission_at(r, ex, Vec2 { x: hit_a1.uv.x, y: hit_a1.uv.y }, at_a0.footprint);
    let e_119 = roughness_v0;
    let e_120 = alpha_v1;
    let e_121 = squared_alpha_v2;
    return Material { diffuse: diffuse_36, transmitted: transmitted_40, specular: specular_52, around: Vec3 { x: add(reflected_106.x, mul(diffuse_36.x, max_with(sub(splat(white_102.x), reflected_106.x), splat(0.0f32)))), y: add(reflected_106.y, mul(diffuse_36.y, max_with(sub(splat(white_102.y), reflected_106.y), splat(0.0f32)))), z: add(reflected_106.z, mul(diffuse_36.z, max_with(sub(splat(white_102.z), reflected_106.z), splat(0.0f32)))) }, emission: e_117, occlusion: maps_9.x, roughness: e_119, alpha: e_120, squared_alpha: e_121, upright: upright_78, masking: masking_88, again: again_98, };
} }
lanes! { fn shade_material_stage(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, normal_a2: Vec3<F>, mean_a3: F, view_a4: Vec3<F>, color_a5: Vec3<F>) -> Material {
    let mut ex = within;
    let mut ret: Material = zero_material();
    match r.surface_settings.choices[8].number {
        0u32 => {
            let e_16 = shade_blinn_phong_material(r, at_a0, hit_a1, normal_a2, mean_a3, view_a4, color_a5, r.surface_settings.choices[8].params);
            return e_16;
        }
        _ => {
            let e_22 = shade_metallic_roughness_material(r, ex, at_a0, hit_a1, normal_a2, mean_a3, view_a4, color_a5, r.surface_settings.choices[8].params);
            return e_22;
        }
    }
} }
lanes! { fn table_cosine(r: &Resources<'_>, table_a0: &SeenTable, toward_a1: Vec3<F>) -> F {
    let mean_3 = add(add(add(mul(table_a0.mean.x, toward_a1.x), mul(table_a0.mean.y, toward_a1.y)), mul(table_a0.mean.z, toward_a1.z)), splat(0.0f32));
    let squares_8 = min_with(add(add(add(mul(table_a0.squares.x, mul(toward_a1.x, toward_a1.x)), mul(table_a0.squares.y, mul(toward_a1.y, toward_a1.y))), mul(table_a0.squares.z, mul(toward_a1.z, toward_a1.z))), splat(0.0f32)), splat(16.0f32));
    let pairs_18 = Vec3 { x: mul(toward_a1.x, toward_a1.y), y: mul(toward_a1.x, toward_a1.z), z: mul(toward_a1.y, toward_a1.z) };
    let products_24 = min_with(mul(splat(2.0f32), add(add(add(mul(table_a0.products.x, pairs_18.x), mul(table_a0.products.y, pairs_18.y)), mul(table_a0.products.z, pairs_18.z)), splat(0.0f32))), splat(16.0f32));
    let deviation_30 = sqrt(max_with(sub(add(squares_8, products_24), mul(mean_3, mean_3)), splat(0.0f32)));
    let inner_32 = mul(deviation_30, splat(0.7419638f32));
    let outer_34 = mul(deviation_30, splat(2.3344142f32));
    let four_39 = Vec4 { x: add(mean_3, inner_32), y: sub(mean_3, inner_32), z: add(mean_3, outer_34), w: sub(mean_3, outer_34) };
    return add(add(add(add(mul(max_with(four_39.x, splat(0.0f32)), splat(0.45412415f32)), mul(max_with(four_39.y, splat(0.0f32)), splat(0.45412415f32))), mul(max_with(four_39.z, splat(0.0f32)), splat(0.04587585f32))), mul(max_with(four_39.w, splat(0.0f32)), splat(0.04587585f32))), splat(0.0f32));
} }
lanes! { fn seen_cosine(r: &Resources<'_>, within: M, at_a0: &Entered, seen_a1: &SeenNormals, toward_a2: Vec3<F>) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let mut cosine_v0: F = splat(0f32);
    let c1 = eq_u(seen_a1.differ, splat_u(0u32));
    ret = max_with(add(add(add(mul(seen_a1.normal.x, toward_a2.x), mul(seen_a1.normal.y, toward_a2.y)), mul(seen_a1.normal.z, toward_a2.z)), splat(0.0f32)), splat(0.0f32));
    ex = and_not(ex, c1);
    if none(ex) { return ret; }
    let l_10 = to_tangent_space(r, at_a0, toward_a2);
    let middle_12 = add(add(add(mul(seen_a1.middle.x, l_10.x), mul(seen_a1.middle.y, l_10.y)), mul(seen_a1.middle.z, l_10.z)), splat(0.0f32));
    let four_17 = facing_four(r, middle_12, add(add(add(mul(seen_a1.along.x, l_10.x), mul(seen_a1.along.y, l_10.y)), mul(seen_a1.along.z, l_10.z)), splat(0.0f32)), add(add(add(mul(seen_a1.across.x, l_10.x), mul(seen_a1.across.y, l_10.y)), mul(seen_a1.across.z, l_10.z)), splat(0.0f32)));
    let one_23 = min_with(mul(seen_a1.middle_seen, max_with(middle_12, splat(0.0f32))), splat(1000000.0f32));
    let others_27 = min_with(add(add(add(add(mul(seen_a1.others_seen.x, four_17.x), mul(seen_a1.others_seen.y, four_17.y)), mul(seen_a1.others_seen.z, four_17.z)), mul(seen_a1.others_seen.w, four_17.w)), splat(0.0f32)), splat(1000000.0f32));
    let e_28 = mean_of_five(r, one_23, others_27);
    cosine_v0 = e_28;
    let (b2, c3) = (ex, gt(seen_a1.table_part, splat(0.0f32)));
    ex = and(b2, c3);
    if any(ex) {
        let e_33 = cosine_v0;
        let e_35 = table_cosine(r, &seen_a1.table, l_10);
        let e_36 = cosine_v0;
        cosine_v0 = sel(ex, add(e_33, mul(sub(e_35, e_36), seen_a1.table_part)), cosine_v0);
    }
    ex = b2;
    if (r.surface_settings.has_shadows == 1u32) {
        let falls_50 = sub(l_10.z, add(add(mul(l_10.x, seen_a1.slope.x), mul(l_10.y, seen_a1.slope.y)), splat(0.0f32)));
        let facing_59 = facing_four(r, falls_50, neg(add(add(mul(l_10.x, seen_a1.slope_along.x), mul(l_10.y, seen_a1.slope_along.y)), splat(0.0f32))), neg(add(add(mul(l_10.x, seen_a1.slope_across.x), mul(l_10.y, seen_a1.slope_across.y)), splat(0.0f32))));
        let e_62 = sum_of_four(r, facing_59);
        let all_63 = mean_of_five(r, max_with(falls_50, splat(0.0f32)), e_62);
        let lit_68 = div(max_with(falls_50, splat(0.0f32)), max_with(all_63, splat(0.001f32)));
        let e_69 = cosine_v0;
        return sel(ex, mul(e_69, sub(splat(1.0f32), mul(sub(splat(1.0f32), lit_68), seen_a1.upright))), ret);
    }
    let e_77 = cosine_v0;
    return sel(ex, e_77, ret);
} }
stage! { fn whole_power(r: &Resources<'_>, within: M, base_a0: F, exponent_a1: U) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let mut result_v0: F = splat(1.0f32);
    let mut square_v1: F = splat(0f32);
    let mut rest_v2: U = splat_u(0u32);
    square_v1 = base_a0;
    rest_v2 = exponent_a1;
    let b2 = ex;
    'l1: loop {
        let e_6 = rest_v2;
        let c3 = gt_u(e_6, splat_u(0u32));
        ex = and(ex, c3);
        let e_9 = rest_v2;
        let c4 = eq_u(and_u(e_9, splat_u(1u32)), splat_u(1u32));
        let e_14 = result_v0;
        let e_15 = square_v1;
        result_v0 = sel(and(ex, c4), mul(e_14, e_15), result_v0);
        let e_17 = square_v1;
        let e_18 = square_v1;
        square_v1 = mul(e_17, e_18);
        let e_20 = rest_v2;
        rest_v2 = shr_u(e_20, i_of_u(splat_u(1u32)));
        if none(ex) { break 'l1; }
    }
    ex = b2;
    let e_23 = result_v0;
    return e_23;
} }
lanes! { fn shade_blinn_phong_light(r: &Resources<'_>, within: M, material_a0: &Material, normal_a1: Vec3<F>, mean_a2: F, cosine_a3: F, view_a4: Vec3<F>, toward_a5: Vec3<F>, params_a6: Vec4<f32>) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let mut exponent_v0: U = splat_u(0u32);
    let mut dimmed_v1: F = splat(1.0f32);
    let (b1, c2) = (ex, gt(cosine_a3, splat(0.0f32)));
    ex = and(b1, c2);
    if any(ex) {
        exponent_v0 = splat_u(r.surface_settings.shininess);
        let (b3, c4) = (ex, lt(mean_a2, splat(1.0f32)));
        ex = and(b3, c4);
        if any(ex) {
            let sharp_20 = (r.surface_settings.shininess as f32);
            let wide_29 = max_with(floor(div(mul(splat(sharp_20), mean_a2), add(mean_a2, mul(splat(sharp_20), sub(splat(1.0f32), mean_a2))))), splat(1.0f32));
            exponent_v0 = sel_u(ex, u_of_f(wide_29), exponent_v0);
            dimmed_v1 = sel(ex, div(add(wide_29, splat(8.0f32)), splat((sharp_20 + 8.0f32))), dimmed_v1);
        }
        ex = b3;
        let e_36 = Vec3 { x: add(toward_a5.x, view_a4.x), y: add(toward_a5.y, view_a4.y), z: add(toward_a5.z, view_a4.z) };
        let length5 = sqrt(add(add(mul(e_36.x, e_36.x), mul(e_36.y, e_36.y)), mul(e_36.z, e_36.z)));
        let e_37 = Vec3 { x: div(e_36.x, length5), y: div(e_36.y, length5), z: div(e_36.z, length5) };
        let lobe_40 = max_with(add(add(add(mul(normal_a1.x, e_37.x), mul(normal_a1.y, e_37.y)), mul(normal_a1.z, e_37.z)), splat(0.0f32)), splat(0.0f32));
        let e_42 = exponent_v0;
        let e_43 = whole_power(r, ex, lobe_40, e_42);
        let e_44 = dimmed_v1;
        let e_45 = mul(e_43, e_44);
        let specular_46 = Vec3 { x: mul(material_a0.specular.x, e_45), y: mul(material_a0.specular.y, e_45), z: mul(material_a0.specular.z, e_45) };
        ret = Vec3 { x: add(mul(material_a0.diffuse.x, cosine_a3), specular_46.x), y: add(mul(material_a0.diffuse.y, cosine_a3), specular_46.y), z: add(mul(material_a0.diffuse.z, cosine_a3), specular_46.z) };
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    let y6 = Vec3 { x: splat(0.0f32), y: splat(0.0f32), z: splat(0.0f32) };
    return Vec3 { x: sel(ex, y6.x, ret.x), y: sel(ex, y6.y, ret.y), z: sel(ex, y6.z, ret.z) };
} }
lanes! { fn shade_metallic_roughness_light(r: &Resources<'_>, within: M, material_a0: &Material, normal_a1: Vec3<F>, mean_a2: F, cosine_a3: F, view_a4: Vec3<F>, toward_a5: Vec3<F>, params_a6: Vec4<f32>) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let (b1, c2) = (ex, gt(cosine_a3, splat(0.0f32)));
    ex = and(b1, c2);
    if any(ex) {
        let sum_9 = Vec3 { x: add(toward_a5.x, view_a4.x), y: add(toward_a5.y, view_a4.y), z: add(toward_a5.z, view_a4.z) };
        let squared_sum_12 = max_with(add(add(add(mul(sum_9.x, sum_9.x), mul(sum_9.y, sum_9.y)), mul(sum_9.z, sum_9.z)), splat(0.0f32)), splat(1e-6f32));
        let along_13 = add(add(add(mul(normal_a1.x, sum_9.x), mul(normal_a1.y, sum_9.y)), mul(normal_a1.z, sum_9.z)), splat(0.0f32));
        let across_14 = Vec3 { x: sub(mul(normal_a1.y, sum_9.z), mul(normal_a1.z, sum_9.y)), y: sub(mul(normal_a1.z, sum_9.x), mul(normal_a1.x, sum_9.z)), z: sub(mul(normal_a1.x, sum_9.y), mul(normal_a1.y, sum_9.x)) };
        let spread_20 = div(add(mul(mul(along_13, along_13), material_a0.squared_alpha), add(add(add(mul(across_14.x, across_14.x), mul(across_14.y, across_14.y)), mul(across_14.z, across_14.z)), splat(0.0f32))), squared_sum_12);
        let shadowing_29 = sqrt(add(mul(cosine_a3, cosine_a3), mul(material_a0.squared_alpha, max_with(sub(splat(1.0f32), mul(cosine_a3, cosine_a3)), splat(0.0f32)))));
        let visible_34 = add(mul(cosine_a3, material_a0.masking), mul(material_a0.upright, shadowing_29));
        let facets_39 = div(mul(splat(0.5f32), material_a0.squared_alpha), mul(mul(spread_20, spread_20), visible_34));
        let rest_46 = max_with(sub(splat(1.0f32), mul(splat(0.5f32), sqrt(squared_sum_12))), splat(0.0f32));
        let squared_rest_47 = mul(rest_46, rest_46);
        let white_51 = Vec3 { x: 1.0f32, y: 1.0f32, z: 1.0f32 };
        let more_58 = Vec3 { x: max_with(sub(splat(white_51.x), material_a0.specular.x), splat(0.0f32)), y: max_with(sub(splat(white_51.y), material_a0.specular.y), splat(0.0f32)), z: max_with(sub(splat(white_51.z), material_a0.specular.z), splat(0.0f32)) };
        let e_61 = mul(mul(squared_rest_47, squared_rest_47), rest_46);
        let fresnel_63 = Vec3 { x: add(material_a0.specular.x, mul(more_58.x, e_61)), y: add(material_a0.specular.y, mul(more_58.y, e_61)), z: add(material_a0.specular.z, mul(more_58.z, e_61)) };
        let specular_69 = Vec3 { x: mul(mul(fresnel_63.x, add(splat(white_51.x), mul(material_a0.specular.x, material_a0.again))), facets_39), y: mul(mul(fresnel_63.y, add(splat(white_51.y), mul(material_a0.specular.y, material_a0.again))), facets_39), z: mul(mul(fresnel_63.z, add(splat(white_51.z), mul(material_a0.specular.z, material_a0.again))), facets_39) };
        ret = Vec3 { x: mul(add(mul(material_a0.diffuse.x, sub(splat(white_51.x), fresnel_63.x)), specular_69.x), cosine_a3), y: mul(add(mul(material_a0.diffuse.y, sub(splat(white_51.y), fresnel_63.y)), specular_69.y), cosine_a3), z: mul(add(mul(material_a0.diffuse.z, sub(splat(white_51.z), fresnel_63.z)), specular_69.z), cosine_a3) };
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    let y3 = Vec3 { x: splat(0.0f32), y: splat(0.0f32), z: splat(0.0f32) };
    return Vec3 { x: sel(ex, y3.x, ret.x), y: sel(ex, y3.y, ret.y), z: sel(ex, y3.z, ret.z) };
} }
lanes! { fn shade_light_stage(r: &Resources<'_>, within: M, material_a0: &Material, normal_a1: Vec3<F>, mean_a2: F, cosine_a3: F, view_a4: Vec3<F>, toward_a5: Vec3<F>) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    match r.surface_settings.choices[8].number {
        0u32 => {
            let e_16 = shade_blinn_phong_light(r, ex, material_a0, normal_a1, mean_a2, cosine_a3, view_a4, toward_a5, r.surface_settings.choices[8].params);
            return e_16;
        }
        _ => {
            let e_22 = shade_metallic_roughness_light(r, ex, material_a0, normal_a1, mean_a2, cosine_a3, view_a4, toward_a5, r.surface_settings.choices[8].params);
            return e_22;
        }
    }
} }
stage! { fn reflected_light(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, seen_a2: &SeenNormals, view_a3: Vec3<F>, color_a4: Vec3<F>, visible_a5: &[Vec4<F>; 8]) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let mut light_v0: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let mut k_v1: u32 = 0u32;
    let material_8 = shade_material_stage(r, ex, at_a0, hit_a1, Vec3 { x: seen_a2.normal.x, y: seen_a2.normal.y, z: seen_a2.normal.z }, seen_a2.length, view_a3, color_a4);
    let around_12 = ambient_stage(r, ex, at_a0, hit_a1, Vec3 { x: mul(seen_a2.normal.x, seen_a2.length), y: mul(seen_a2.normal.y, seen_a2.length), z: mul(seen_a2.normal.z, seen_a2.length) }, view_a3, &material_8);
    light_v0 = Vec3 { x: add(mul(around_12.x, material_8.occlusion), material_8.emission.x), y: add(mul(around_12.y, material_8.occlusion), material_8.emission.y), z: add(mul(around_12.z, material_8.occlusion), material_8.emission.z) };
    'l1: loop {
        let e_20 = k_v1;
        if (e_20 < r.frame.light_count) {
        } else {
            break 'l1;
        }
        let e_25 = k_v1;
        let toward_27 = toward_light(r, e_25, Vec3 { x: at_a0.point.x, y: at_a0.point.y, z: at_a0.point.z });
        let cosine_29 = seen_cosine(r, ex, at_a0, seen_a2, Vec3 { x: toward_27.direction.x, y: toward_27.direction.y, z: toward_27.direction.z });
        let reflected_33 = shade_light_stage(r, ex, &material_8, Vec3 { x: seen_a2.normal.x, y: seen_a2.normal.y, z: seen_a2.normal.z }, seen_a2.length, cosine_29, view_a3, Vec3 { x: toward_27.direction.x, y: toward_27.direction.y, z: toward_27.direction.z });
        let e_34 = light_v0;
        let e_37 = k_v1;
        let e_44 = k_v1;
        let e_47 = mul(toward_27.falloff, visible_a5[e_44 as usize].x);
        light_v0 = Vec3 { x: add(e_34.x, mul(mul(reflected_33.x, splat(r.frame.lights[e_37 as usize].color.x)), e_47)), y: add(e_34.y, mul(mul(reflected_33.y, splat(r.frame.lights[e_37 as usize].color.y)), e_47)), z: add(e_34.z, mul(mul(reflected_33.z, splat(r.frame.lights[e_37 as usize].color.z)), e_47)) };
        let e_50 = k_v1;
        k_v1 = e_50.wrapping_add(1u32);
    }
    let e_53 = light_v0;
    return e_53;
} }
lanes! { fn z_of(r: &Resources<'_>, depth_a0: F) -> F {
    if (r.frame.clip.y == 0.0f32) {
        return min_with(max_with(add(splat(r.frame.clip.x), mul(splat(r.frame.clip.z), depth_a0)), splat(0.0f32)), splat(1.0f32));
    }
    return min_with(max_with(add(splat(r.frame.clip.x), div(splat(r.frame.clip.y), max_with(depth_a0, splat(0.0f32)))), splat(0.0f32)), splat(1.0f32));
} }
stage! { pub(super) fn shade_hit(r: &Resources<'_>, within: M, origin_a0: Vec3<F>, at_a1: &Entered, hit_a2: &Hit, visible_a3: &[Vec4<F>; 8]) -> PixelOut {
    let mut ex = within;
    let mut ret: PixelOut = zero_pixel_out();
    let (b1, c2) = (ex, eq_u(hit_a2.found, splat_u(0u32)));
    ex = and(b1, c2);
    if any(ex) {
        ret = PixelOut { color: Vec4 { x: splat(0.0f32), y: splat(0.0f32), z: splat(0.0f32), w: splat(0.0f32) }, hit: splat_u(0u32), exhausted: splat_u(0u32), uv: Vec2 { x: splat(0.0f32), y: splat(0.0f32) }, height: splat(0.0f32), position: Vec3 { x: splat(0.0f32), y: splat(0.0f32), z: splat(0.0f32) }, normal: Vec3 { x: splat(0.0f32), y: splat(0.0f32), z: splat(0.0f32) }, depth: splat(0.0f32), t: splat(0.0f32), cell: Vec2 { x: splat_i(0i32), y: splat_i(0i32) }, reads: hit_a2.cost.x, steps: hit_a2.cost.y, bytes: hit_a2.cost.z, lit: splat(0.0f32), level: splat_u(0u32), z: splat(0.0f32), surface: splat_u(0u32), transmittance: splat(1.0f32), };
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    if none(ex) { return ret; }
    let height_46 = field_height_stage(r, ex, Vec2 { x: hit_a2.uv.x, y: hit_a2.uv.y }, hit_a2.height, at_a1.level);
    let e_48 = Vec3 { x: sub(origin_a0.x, at_a1.point.x), y: sub(origin_a0.y, at_a1.point.y), z: sub(origin_a0.z, at_a1.point.z) };
    let length3 = sqrt(add(add(mul(e_48.x, e_48.x), mul(e_48.y, e_48.y)), mul(e_48.z, e_48.z)));
    let view_49 = Vec3 { x: div(e_48.x, length3), y: div(e_48.y, length3), z: div(e_48.z, length3) };
    let seen_50 = field_normals_stage(r, ex, at_a1, hit_a2, view_49);
    let e_51 = object_color_stage(r, ex, at_a1, hit_a2, view_49);
    let color_52 = reflected_light(r, ex, at_a1, hit_a2, &seen_50, view_49, e_51, visible_a3);
    let depth_59 = add(add(add(mul(sub(at_a1.point.x, origin_a0.x), splat(r.frame.forward.x)), mul(sub(at_a1.point.y, origin_a0.y), splat(r.frame.forward.y))), mul(sub(at_a1.point.z, origin_a0.z), splat(r.frame.forward.z))), splat(0.0f32));
    let e_62 = height_size(r, splat_u(0u32));
    let cell_68 = cell_of(r, Vec2 { x: sub(mul(hit_a2.uv.x, e_62.x), splat(0.5f32)), y: sub(mul(hit_a2.uv.y, e_62.y), splat(0.5f32)) });
    let e_88 = z_of(r, at_a1.depth);
    return sel_pixel_out(ex, &PixelOut { color: Vec4 { x: color_52.x, y: color_52.y, z: color_52.z, w: splat(1.0f32) }, hit: splat_u(1u32), exhausted: hit_a2.exhausted, uv: Vec2 { x: hit_a2.uv.x, y: hit_a2.uv.y }, height: height_46, position: Vec3 { x: at_a1.point.x, y: at_a1.point.y, z: at_a1.point.z }, normal: Vec3 { x: seen_50.normal.x, y: seen_50.normal.y, z: seen_50.normal.z }, depth: depth_59, t: hit_a2.t, cell: Vec2 { x: i_of_small(cell_68.x), y: i_of_small(cell_68.y) }, reads: hit_a2.cost.x, steps: hit_a2.cost.y, bytes: hit_a2.cost.z, lit: visible_a3[0].x, level: at_a1.level, z: e_88, surface: splat_u(r.surface_settings.number), transmittance: splat(1.0f32), }, &ret);
} }
stage! { pub(super) fn visible_light(r: &Resources<'_>, within: M, at_a0: &Entered, hit_a1: &Hit, number_a2: u32) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let e_4 = toward_light(r, number_a2, Vec3 { x: at_a0.point.x, y: at_a0.point.y, z: at_a0.point.z });
    let e_5 = shadow_stage(r, ex, at_a0, hit_a1, &e_4);
    return e_5;
} }
