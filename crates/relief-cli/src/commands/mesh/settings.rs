//! Settings of the mesher from the flags of `relief mesh`, and which flags go together.

use relief_io::{MeshFormat, Up};
use relief_mesh::{
    EDGE_RULES, EdgeRule, INTERIORS, Interior, MeshSettings, Mesher, MesherError, Shading, Side, Spacing,
    Weights,
};

use super::baked_maps::{self, MeshMap};
use super::refused::of_mesher;
use super::write::Source;
use super::{Arguments, BYTES_TO_WRITE, bytes_of};
use crate::failure::Failure;

impl Arguments {
    /// Checks the arguments before anything is read.
    pub(super) fn check(&self, format: MeshFormat) -> Result<(), Failure> {
        if let Some(size) = self.print_size.filter(|size| !(1e-3..=1e9).contains(size)) {
            let must = "it must be from 0.001 to 1e9 millimetres";
            return Err(Failure::Usage(format!("--print-size: {size} cannot be used: {must}")));
        }
        if let Some(solid) = self.solid.filter(|solid| *solid <= 0.0) {
            return Err(Failure::Usage(format!(
                "--solid: {solid} cannot be used: it must be greater than 0"
            )));
        }
        if self.texels == Some(0) {
            return Err(of_mesher(MesherError::NoTexels));
        }
        if self.triangles == Some(0) {
            return Err(Failure::Usage("--triangles: 0 cannot be used: it must be at least 1".to_owned()));
        }
        let (edges, interior) = self.rules(self.is_measured());
        relief_mesh::check_pair(edges, interior).map_err(of_mesher)?;
        let [is_even, is_measured, is_viewed] =
            [Spacing::Even, Spacing::Uneven, Spacing::Voxels].map(|spacing| edges.spacing == spacing);
        if is_viewed && self.view.is_none() {
            return Err(of_mesher(MesherError::NoView { edges: edges.name }));
        }
        let idle = [
            ("--error", self.error.is_some() && !is_measured),
            ("--triangles", self.triangles.is_some() && !is_measured),
            ("--judge", self.judge.is_some() && !is_measured),
            ("--fit", self.fit.is_some() && !is_measured),
            ("--side", self.side.is_some() && !is_measured),
            ("--texels", self.texels.is_some() && !is_even),
            ("--view", self.view.is_some() && !is_viewed),
        ];
        if let Some((flag, _)) = idle.into_iter().find(|(_, is_idle)| *is_idle) {
            let (edges, interior) = (edges.name, interior.name);
            return Err(Failure::Usage(format!(
                "{flag} does not go with the edges '{edges}' and the interior '{interior}', which --texels, \
                 --view, --edges or --interior ask for: leave one out"
            )));
        }
        self.check_storage(format)?;
        if let Some(shading) = self.shading.filter(|shading| *shading != Shading::Base)
            && self.maps.contains(&MeshMap::Normal)
        {
            return Err(Failure::Usage(format!(
                "--shading {shading}: --maps normal needs the normals of the base: leave one out"
            )));
        }
        if self.tiles.is_some() && self.shading == Some(Shading::Mesh) {
            let why = "normals of triangles would differ where two files meet";
            return Err(Failure::Usage(format!(
                "--tiles: does not go with --shading mesh: {why}: leave one out"
            )));
        }
        Ok(())
    }

    /// Checks that the format can store what is asked for.
    fn check_storage(&self, format: MeshFormat) -> Result<(), Failure> {
        let for_glb = [
            ("--quantize", self.quantize.is_some(), "has no scaled integers"),
            ("--lods", self.lods.is_some(), "has no levels of detail"),
            ("--strips", self.strips, "has no triangle strips"),
            ("--maps", !self.maps.is_empty(), "holds no pictures"),
            ("--place", self.place, "has no node to move"),
        ];
        let asked = for_glb.into_iter().find(|(_, is_asked, _)| *is_asked && format != MeshFormat::Gltf);
        if let Some((flag, _, why)) = asked {
            return Err(Failure::Usage(format!("{flag}: {} {why}: write a GLB", format.name())));
        }
        if self.place && self.print_size.is_some() {
            let why = "a mesh of another size than the ground has no place on it";
            return Err(Failure::Usage(format!(
                "--place: does not go with --print-size: {why}: leave one out"
            )));
        }
        if format == MeshFormat::Gltf && self.up == Some(Up::Z) {
            let why = "glTF has y up, and programs with z up turn it when they read it";
            return Err(Failure::Usage(format!("--up z: does not go with a GLB: {why}: leave it out")));
        }
        if self.quantize.is_none() {
            return Ok(());
        }
        if let Some(side @ (Side::Above | Side::Below)) = self.side {
            let why = "rounding would move vertices to the other side";
            return Err(Failure::Usage(format!(
                "--quantize: does not go with --side {side}: {why}: leave one out"
            )));
        }
        Ok(())
    }

    /// Whether triangles are made to a tolerance.
    pub(super) fn is_measured(&self) -> bool {
        let asks = self.judge.is_some() || self.fit.is_some() || self.side.is_some();
        self.error.is_some() || self.triangles.is_some() || (self.texels.is_none() && asks)
    }

    /// Returns the edge rule and the interior. Defaults follow from a tolerance or a fixed spacing.
    pub(super) fn rules(&self, is_measured: bool) -> (&'static EdgeRule, &'static Interior) {
        let usual = if is_measured { MeshSettings::within(1.0) } else { MeshSettings::default() };
        let viewed =
            || EDGE_RULES.iter().find(|edges| self.view.is_some() && edges.spacing == Spacing::Voxels);
        let edges = self.edges.or_else(viewed);
        // Weights are for interiors that take any number of points.
        let patterned = |interior: &&Interior| interior.takes.contains(&Spacing::Even);
        let weighted = || self.weights.and_then(|_| INTERIORS.iter().find(patterned));
        match (edges, self.interior.or_else(weighted)) {
            // Of two that belong together one is enough. Interiors that take one rule alone are
            // meant for that rule.
            (Some(edges), None) => {
                let fits = |interior: &&Interior| relief_mesh::check_pair(edges, interior).is_ok();
                (edges, INTERIORS.iter().rfind(fits).unwrap_or(usual.interior))
            }
            (None, Some(interior)) => {
                let fits = |edges: &&EdgeRule| relief_mesh::check_pair(edges, interior).is_ok();
                (EDGE_RULES.iter().find(fits).unwrap_or(usual.edges), interior)
            }
            (edges, interior) => (edges.unwrap_or(usual.edges), interior.unwrap_or(usual.interior)),
        }
    }

    /// Returns the mesher's settings for `source`. The written mesh is larger by the factor `size`.
    pub(super) fn settings(&self, Source { surface, view, metres, .. }: &Source, size: f64) -> MeshSettings {
        let usual = MeshSettings::default();
        let is_plane = Mesher::is_plane(surface.mesh());
        let (edges, interior) = self.rules(self.is_measured() || (is_plane && self.texels.is_none()));
        let map = surface.height_map();
        let held = bytes_of(surface) + BYTES_TO_WRITE;
        MeshSettings {
            edges,
            interior,
            texels: self.texels.unwrap_or(usual.texels),
            view: *view,
            weights: self.weights(),
            error_m: self.error.unwrap_or_default().metres(map.scale_m(), size),
            judge: self.judge.unwrap_or_default(),
            fit: self.fit.unwrap_or_default(),
            side: self.side.unwrap_or_default(),
            solid_m: self.solid.map(|mm| mm / 1000.0 / size),
            max_bytes: self.limit().saturating_sub(held),
            base: self.base.unwrap_or_default(),
            directions: self.directions.unwrap_or_default(),
            shading: self.shading.unwrap_or(baked_maps::shading(&self.maps)),
            seams: self.seams.unwrap_or_default(),
            holes: self.holes,
            pose: metres.put(self, surface),
            ..usual
        }
    }

    fn weights(&self) -> Weights {
        let [silhouette, slope, variation] = self.weights.unwrap_or_default();
        Weights { silhouette, slope, variation }
    }
}
