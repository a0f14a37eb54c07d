//! Attacks on distance fields: points from which a point of the surface is nearer than the fetched value
//! says.

use relief_core::HeightMap;

use super::Found;
use relief_core::rng::Rng;

/// A stored distance field: `size[0] x size[1]` texels by `size[2]` slices, in metres of a metric.
#[derive(Clone, Copy, Debug)]
pub struct Field<'a> {
    /// The map that it was made from.
    pub map: &'a HeightMap,
    /// Length of the tile along `u` and `v` in metres.
    pub tile_m: [f64; 2],
    /// Height of texel 1 above texel 0 in metres.
    pub scale_m: f64,
    /// Number of slices.
    pub slices: u32,
    /// The values, slice by slice, row by row.
    pub values: &'a [f32],
}

/// A point above the surface and a point of the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// Texture coordinates and height from which the surface is looked for.
    pub from: [f64; 3],
    /// Texture coordinates and height of a point of the surface.
    pub surface: [f64; 3],
    /// Metres between them, less the fetched distance: negative where the bound is broken.
    pub slack_m: f64,
}

impl Field<'_> {
    /// The trilinear fetch, in `f64`: wrapped as the map is along `u` and `v`, clamped along the height.
    pub fn fetch(&self, [u, v, h]: [f64; 3]) -> f64 {
        let (width, height) = (self.map.width(), self.map.height());
        let [x, y] = [u * f64::from(width) - 0.5, v * f64::from(height) - 0.5];
        let z = (h * f64::from(self.slices) - 0.5).clamp(0.0, f64::from(self.slices - 1));
        let value = |i: i64, j: i64, k: u32| {
            let column = self.map.wrap().index(i, width) as usize;
            let row = self.map.wrap().index(j, height) as usize;
            let row = k as usize * height as usize + row;
            f64::from(self.values[row * width as usize + column])
        };
        let mix = |a: f64, b: f64, part: f64| a + (b - a) * part;
        let (i, j, k) = (x.floor() as i64, y.floor() as i64, z as u32);
        let along_u = |j, k| mix(value(i, j, k), value(i + 1, j, k), x - x.floor());
        let along_v = |k| mix(along_u(j, k), along_u(j + 1, k), y - y.floor());
        mix(along_v(k), along_v((k + 1).min(self.slices - 1)), z - f64::from(k))
    }

    /// The contact between two points.
    pub fn contact(&self, from: [f64; 3], surface: [f64; 3]) -> Contact {
        let unit = [self.tile_m[0], self.tile_m[1], self.scale_m];
        let squared: f64 = (0..3).map(|axis| ((from[axis] - surface[axis]) * unit[axis]).powi(2)).sum();
        Contact { from, surface, slack_m: squared.sqrt() - self.fetch(from) }
    }

    /// Probes `count` contacts. Surface points lie anywhere, on edges and at corners of dual cells; they are
    /// looked at along their normal, straight from above, at random, and from voxel centres near by. Finds
    /// room in metres.
    pub fn attack(&self, count: usize, seed: u64) -> Found<Contact> {
        let mut rng = Rng::new(seed);
        let mut found = Found::default();
        for _ in 0..count {
            let contact = self.draw(&mut rng);
            found.add(contact.slack_m < 0.0, contact.slack_m, contact);
        }
        found
    }

    fn draw(&self, rng: &mut Rng) -> Contact {
        let size = [f64::from(self.map.width()), f64::from(self.map.height())];
        // Places in texel units; now and then outside of the map, on an edge, at a texel centre.
        let place = |rng: &mut Rng, size: f64| {
            let at = rng.between(-1.5, size + 1.5);
            match rng.below(4) {
                0 => at.floor() + 0.5,
                1 => (at * 4.0).floor() / 4.0,
                _ => at,
            }
        };
        let texel = [place(rng, size[0]), place(rng, size[1])];
        let uv = [texel[0] / size[0], texel[1] / size[1]];
        let h = self.map.height_at(uv[0], uv[1]);
        let surface = [uv[0], uv[1], h];
        let unit = [self.tile_m[0], self.tile_m[1], self.scale_m];
        let reach = match rng.below(3) {
            0 => rng.unit() * self.scale_m,
            1 => self.scale_m * rng.unit().powi(6),
            _ => rng.between(0.0, 3.0) * self.scale_m / f64::from(self.slices),
        };
        let direction = match rng.below(4) {
            0 => [0.0, 0.0, 1.0],
            1 => [rng.between(-1.0, 1.0), rng.between(-1.0, 1.0), rng.between(-0.2, 1.0)],
            _ => {
                // The normal of the patch on one side, by small differences that stay within the cell.
                let step = [rng.pick(&[1e-6, -1e-6]), rng.pick(&[1e-6, -1e-6])];
                let slope = |uv: [f64; 2], step: f64, unit: f64| {
                    (self.map.height_at(uv[0], uv[1]) - h) * self.scale_m / (step * unit)
                };
                let du = slope([uv[0] + step[0], uv[1]], step[0], unit[0]);
                let dv = slope([uv[0], uv[1] + step[1]], step[1], unit[1]);
                [-du, -dv, 1.0]
            }
        };
        let length = direction.iter().map(|x| x * x).sum::<f64>().sqrt().max(1e-12);
        let mut from = [0, 1, 2].map(|axis| surface[axis] + direction[axis] / length * reach / unit[axis]);
        if rng.below(4) == 0 {
            // A voxel centre, where nothing is interpolated.
            let counts = [size[0], size[1], f64::from(self.slices)];
            from = [0, 1, 2].map(|axis| ((from[axis] * counts[axis]).floor() + 0.5) / counts[axis]);
        }
        from[2] = from[2].max(0.0);
        self.contact(from, surface)
    }
}
