//! Texels in lanes, included once for each width. Lanes whose place lies outside get any number.

use super::stages::wrapped_cell;
use super::*;

lanes! {
    /// Reads a texel of a height map in a level.
    pub(super) fn height_texel(map: &HeightTexture<'_>, x: I, y: I, level: i32) -> Vec4<F> {
        let (width, texels) = map.level(level);
        let height = gather(texels, add_i(mul_i(y, splat_i(width)), x));
        Vec4 { x: height, y: splat(0.0), z: splat(0.0), w: splat(1.0) }
    }
}

lanes! {
    /// Reads a texel of a height map, with a level for each lane.
    pub(super) fn height_texel_of_each(map: &HeightTexture<'_>, within: M, x: I, y: I, level: I) -> Vec4<F> {
        let mut height = splat(0.0);
        let mut rest = bits_of(within);
        while let Some((_, level_here, same)) = next_alike(splat_i(0), level, &mut rest) {
            height = sel(same, height_texel(map, x, y, level_here).x, height);
        }
        Vec4 { x: height, y: splat(0.0), z: splat(0.0), w: splat(1.0) }
    }
}

lanes! {
    /// The function `whole_cell` of the shaders. All numbers are in range here, so that none is
    /// checked.
    pub(super) fn whole_cell(_r: &Resources<'_>, _within: M, cell: Vec2<F>) -> Vec2<I> {
        Vec2 { x: i_of_small(cell.x), y: i_of_small(cell.y) }
    }
}

lanes! {
    /// The function `height_cell` of the shaders. Mostly all cells lie inside the map, where no index is
    /// wrapped.
    pub(super) fn height_cell(r: &Resources<'_>, within: M, cell: Vec2<I>, level: u32) -> Vec4<F> {
        let n = r.height_texels(level);
        let inside = and(
            lt_u(u_of_i(cell.x), splat_u((n.x - 1) as u32)),
            lt_u(u_of_i(cell.y), splat_u((n.y - 1) as u32)),
        );
        if any(and_not(within, inside)) {
            return cell_anywhere(r, within, cell, level);
        }
        let (width, texels) = r.height_map.level(level as i32);
        gather_cell(texels, width as usize, add_i(mul_i(cell.y, splat_i(width)), cell.x))
    }
}

stage! {
    /// Reads cells, some of them outside.
    fn cell_anywhere(r: &Resources<'_>, within: M, cell: Vec2<I>, level: u32) -> Vec4<F> {
        wrapped_cell(r, within, cell, level)
    }
}

lanes! {
    /// Reads a texel of four numbers in a layer and a level.
    pub(super) fn color_texel(map: &ColorTexture<'_>, x: I, y: I, layer: i32, level: i32) -> Vec4<F> {
        let (width, texels) = map.layer(layer, level);
        gather_four(texels, add_i(mul_i(y, splat_i(width)), x))
    }
}

lanes! {
    /// Reads a texel of four numbers, with a layer and a level for each lane.
    pub(super) fn color_texel_of_each(
        map: &ColorTexture<'_>,
        within: M,
        x: I,
        y: I,
        layer: I,
        level: I
    ) -> Vec4<F> {
        let zero = splat(0.0);
        let mut texel = Vec4 { x: zero, y: zero, z: zero, w: zero };
        let mut rest = bits_of(within);
        while let Some((layer_here, level_here, same)) = next_alike(layer, level, &mut rest) {
            let here = color_texel(map, x, y, layer_here, level_here);
            texel = Vec4 {
                x: sel(same, here.x, texel.x),
                y: sel(same, here.y, texel.y),
                z: sel(same, here.z, texel.z),
                w: sel(same, here.w, texel.w),
            };
        }
        texel
    }
}

lanes! {
    /// Reads a texel of a baked map in a layer and a level.
    pub(super) fn map_texel(map: &MapTexture<'_>, x: I, y: I, layer: i32, level: i32) -> Vec4<F> {
        texel_at(map, place_in(map, x, y, layer, level))
    }
}

lanes! {
    /// Reads a texel of a baked map, with a layer and a level for each lane.
    pub(super) fn map_texel_of_each(
        map: &MapTexture<'_>,
        within: M,
        x: I,
        y: I,
        layer: I,
        level: I
    ) -> Vec4<F> {
        let mut at = splat_i(-1);
        let mut rest = bits_of(within);
        while let Some((layer_here, level_here, same)) = next_alike(layer, level, &mut rest) {
            at = sel_i(same, place_in(map, x, y, layer_here, level_here), at);
        }
        texel_at(map, at)
    }
}

lanes! {
    /// The layer and the level of the first of the lanes that `rest` has bits for, and all lanes that have
    /// both. These are taken out of `rest`.
    fn next_alike(layer: I, level: I, rest: &mut u32) -> Option<(i32, i32, M)> {
        if *rest == 0 {
            return None;
        }
        let lane = rest.trailing_zeros() as usize;
        let (layer_here, level_here) = (row_i(layer)[lane], row_i(level)[lane]);
        let same = and(eq_i(layer, splat_i(layer_here)), eq_i(level, splat_i(level_here)));
        *rest &= !bits_of(same);
        Some((layer_here, level_here, same))
    }
}

lanes! {
    /// The number of a texel among all.
    fn place_in(map: &MapTexture<'_>, x: I, y: I, layer: i32, level: i32) -> I {
        if layer | level == 0 {
            return add_i(mul_i(y, splat_i(map.width as i32)), x);
        }
        let (Ok(layer), Ok(level)) = (usize::try_from(layer), usize::try_from(level)) else {
            return splat_i(-1);
        };
        let Some(place) = map.places.get(level).filter(|_| layer < map.layers) else { return splat_i(-1) };
        let is_in = and(
            lt_u(u_of_i(x), splat_u(place.width as u32)),
            lt_u(u_of_i(y), splat_u(place.height as u32)),
        );
        let first = (place.start + layer * place.height * place.width) as i32;
        let at = add_i(add_i(mul_i(y, splat_i(place.width as i32)), x), splat_i(first));
        sel_i(is_in, at, splat_i(-1))
    }
}

lanes! {
    fn texel_at(map: &MapTexture<'_>, at: I) -> Vec4<F> {
        let (zero, one) = (splat(0.0), splat(1.0));
        match map.texels {
            Texels::One(values) => Vec4 { x: gather(values, at), y: zero, z: zero, w: one },
            Texels::Two(texels) => {
                let (values, first) = (texels.as_flattened(), add_i(at, at));
                let both = gather_two(values, first);
                Vec4 { x: both.x, y: both.y, z: zero, w: one }
            }
            Texels::Four(texels) => gather_four(texels, at),
            Texels::Half { values, channels } => halves(values, channels, at),
            Texels::Codes { values, channels } => codes(values, channels, at),
        }
    }
}

lanes! {
    /// The place `by` places after the first, if that is inside.
    fn next(first: I, by: i32) -> I {
        add_i(first, splat_i(by))
    }
}

stage! {
    fn halves(values: &[u16], channels: usize, at: I) -> Vec4<F> {
        let padded;
        let values = match values {
            &[only] => {
                padded = [only, 0];
                &padded
            }
            values => values,
        };
        let texel = mul_i(at, splat_i(2 * channels as i32));
        // Two numbers at once; the last place has nothing after it, and is read from the one before on.
        let last = (size_of_val(values) as i32).wrapping_sub(4);
        let pair = |byte: I| {
            let from = min_i(byte, splat_i(last));
            shr_u(gather_of_16(values, from), mul_i(sub_i(byte, from), splat_i(8)))
        };
        let low = |word: U| f_of_half(and_u(word, splat_u(0xffff)));
        let high = |word: U| f_of_half(shr_u(word, splat_i(16)));
        let first = pair(texel);
        let (zero, one) = (splat(0.0), splat(1.0));
        match channels {
            1 => Vec4 { x: low(first), y: zero, z: zero, w: one },
            2 => Vec4 { x: low(first), y: high(first), z: zero, w: one },
            _ => {
                let second = pair(next(texel, 4));
                Vec4 { x: low(first), y: high(first), z: low(second), w: high(second) }
            }
        }
    }
}

stage! {
    fn codes(values: &[u8], channels: usize, at: I) -> Vec4<F> {
        let mut padded = [0; 4];
        let values = if values.len() < 4 {
            padded[..values.len()].copy_from_slice(values);
            &padded
        } else {
            values
        };
        let texel = mul_i(at, splat_i(channels as i32));
        // Four bytes at once; the last places have less after them, and are read from before them on.
        let last = (values.len() as i32).wrapping_sub(4);
        let from = min_i(texel, splat_i(last));
        let word = shr_u(gather_of_8(values, from), mul_i(sub_i(texel, from), splat_i(8)));
        let code = |by: i32| {
            let code = and_u(shr_u(word, splat_i(8 * by)), splat_u(0xff));
            div(f_of_i(i_of_u(code)), splat(255.0))
        };
        let (zero, one) = (splat(0.0), splat(1.0));
        match channels {
            1 => Vec4 { x: code(0), y: zero, z: zero, w: one },
            2 => Vec4 { x: code(0), y: code(1), z: zero, w: one },
            _ => Vec4 { x: code(0), y: code(1), z: code(2), w: code(3) },
        }
    }
}
