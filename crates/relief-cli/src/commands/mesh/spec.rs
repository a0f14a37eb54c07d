//! The scene that `relief mesh` reads: the height map on its mesh, and the view that sets the fineness.

use std::path::{Path, PathBuf};

use relief_mesh::View;
use relief_scene::{NO_MAP, Scene, SceneSpec, SurfaceSpec, read_scene};

use super::Arguments;
use super::ground::Metres;
use crate::commands::maps;
use crate::failure::Failure;

impl Arguments {
    /// Returns the scene of the height map on its mesh: seen by the camera of --view, or in the
    /// smallest of pictures.
    ///
    /// A scene's plane is 1 m long, so lengths of the written mesh are converted.
    pub(super) fn spec(&self, metres: &Metres) -> Result<SceneSpec, Failure> {
        let surface = self.placement.surface(&self.reading);
        let in_scene = |length_m: Option<f64>| length_m.map(|length_m| length_m / metres.factor);
        let (scale, bias) = (in_scene(surface.scale), in_scene(surface.bias));
        let surface = SurfaceSpec { scale, bias, ..surface };
        // A file may itself state that it holds depths.
        let of_file = || {
            let surface = SurfaceSpec { height: Some(self.height_file().into_owned()), ..surface.clone() };
            self.is_set_of_depths() || maps::ground_of(&surface).is_some_and(|ground| maps::is_depth(&ground))
        };
        let depth = if self.invert { Some(!(self.reading.depth || of_file())) } else { surface.depth };
        let holes = self.holes.then_some(true);
        let textures = self.textures().map(Path::to_owned);
        // The triangles show the relief.
        let normal = textures.is_some().then(|| PathBuf::from(NO_MAP));
        let height = (!self.is_set()).then(|| self.height.clone());
        let surface = SurfaceSpec { height, textures, udim: self.udim, normal, depth, holes, ..surface };
        let viewed = match &self.view {
            Some(file) => read_scene(file).map_err(Failure::work)?,
            None => SceneSpec { size: Some([1, 1].into()), ..SceneSpec::default() },
        };
        let SceneSpec { view, eye, target, projection, fov, view_height, near, far, size, .. } = viewed;
        Ok(SceneSpec {
            view,
            eye,
            target,
            projection,
            fov,
            view_height,
            near,
            far,
            size,
            samples: Some(1),
            max_memory: self.max_memory,
            ..SceneSpec::of_surface(surface)
        })
    }

    /// Returns the view of --view.
    pub(super) fn view_of(&self, spec: &SceneSpec, scene: &Scene) -> Option<View> {
        self.view.as_ref()?;
        let view = View::new(*scene.camera(), scene.size());
        // An orthographic camera shows near things no larger than others.
        let near_m = spec.near.filter(|_| !view.camera.is_orthographic()).unwrap_or(view.near_m);
        Some(View { pixels: self.pixels.unwrap_or(view.pixels), near_m, ..view })
    }
}
