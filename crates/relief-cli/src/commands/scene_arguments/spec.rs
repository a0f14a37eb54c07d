//! Description of a scene from a scene file and the flags over it.

use std::collections::BTreeMap;
use std::path::Path;

use relief_io::decode_text;
use relief_scene::{
    LightDirection, LightSpec, MeshChoice, SceneError, SceneSpec, SurfaceSpec, parse_scene, read_scene,
};

use super::{SceneArguments, of_scene};
use crate::commands::motif::missing_motif;
use crate::failure::Failure;
use crate::file_kind::FileKind;
use crate::streams::{INPUT, is_input};

impl SceneArguments {
    /// Returns the scene's description: the flags over the scene file.
    pub fn spec(&self) -> Result<SceneSpec, Failure> {
        if self.ambient_color.is_some() && self.stages.and_color().1.is_some() {
            return Err(Failure::usage(
                "--ambient and --ambient-color both set a colour: give --ambient a name, or leave one out",
            ));
        }
        if let Some(volume) = &self.volume
            && matches!(FileKind::of(volume)?, FileKind::Mesh | FileKind::HeightMap)
        {
            let file = volume.display();
            return Err(Failure::Usage(format!(
                "--volume: {file} is no volume: make the volume of a mesh or a height map with `relief \
                 volume {file} -o NAME.ktx2`, and give that"
            )));
        }
        self.check_motif()?;
        let Some(path) = &self.scene else { return Ok(self.flags()) };
        let kind = FileKind::of(path)?;
        let named = match kind {
            FileKind::Scene => {
                let scene = if is_input(path) { scene_of_input(path) } else { read_scene(path) };
                return Ok(scene.map_err(of_scene)?.overridden_by(self.flags()));
            }
            FileKind::Object | FileKind::HeightMap | FileKind::Volume => {
                [&self.object, &self.height, &self.volume, &self.motif].into_iter().any(Option::is_some)
            }
            FileKind::Mesh => self.object.is_some() || self.placement.mesh.is_some(),
            FileKind::Textures => self.object.is_some() || self.material.names_textures(),
        };
        if named {
            let (flag, file) = (kind.flag(), path.display());
            let motif = if kind == FileKind::Mesh {
                format!("; a mesh that repeats on another is given with --motif {file}")
            } else {
                String::new()
            };
            return Err(Failure::Usage(format!(
                "{file} is read as {flag}, and another flag names the surface, too: leave one of them \
                 out{motif}"
            )));
        }
        let mut spec = self.flags();
        match kind {
            FileKind::Volume => spec.surface.volume = Some(path.clone()),
            FileKind::Object => spec.surface.object = Some(FileKind::object_at(path)),
            FileKind::Textures => spec.surface.textures = Some(path.clone()),
            FileKind::Mesh => spec.surface.mesh = Some(MeshChoice::File(path.clone())),
            FileKind::HeightMap | FileKind::Scene => spec.surface.height = Some(path.clone()),
        }
        Ok(spec)
    }

    /// Refuses what is no motif's file.
    fn check_motif(&self) -> Result<(), Failure> {
        let Some(motif) = &self.motif else { return Ok(()) };
        if let Some(missing) = missing_motif(motif) {
            return Err(missing);
        }
        let file = motif.display();
        match FileKind::of(motif)? {
            FileKind::Mesh | FileKind::HeightMap => Ok(()),
            FileKind::Volume => {
                Err(Failure::Usage(format!("--motif: {file} is a volume: give it with --volume")))
            }
            _ => Err(Failure::Usage(format!(
                "--motif: {file} is neither a mesh nor a vector displacement map: give a GLB, OBJ, PLY or \
                 STL file, or an EXR; `relief motif` makes meshes"
            ))),
        }
    }

    /// Returns the flags as a description that overrides the scene file.
    fn flags(&self) -> SceneSpec {
        let (stages, color_of_ambient) = self.stages.and_color();
        let given = |flag: bool| flag.then_some(true);
        let surface = SurfaceSpec {
            height: self.height.clone(),
            volume: self.volume.clone(),
            motif: self.motif.clone(),
            axes: self.axes,
            object: self.object.clone(),
            holes: given(self.holes),
            creases: given(self.creases),
            color: self.color.clone(),
            ramp: self.ramp.clone(),
            walls: given(self.walls),
            base: self.base,
            normal: self.normal.clone(),
            green: self.green,
            method: self.method.clone(),
            stages,
            set: BTreeMap::from_iter(self.set.iter().cloned()),
            two_sided: given(self.two_sided),
            ..self.material.surface(self.placement.surface(&self.reading))
        };
        let light = self.light.map(|LightDirection(toward)| toward);
        let directional =
            light.map(|direction| LightSpec { direction: Some(direction), ..LightSpec::default() });
        let lights = || directional.into_iter().chain(self.point_light.iter().cloned()).collect();
        let colour = |colour: [f64; 3]| colour.map(|part| part as f32);
        SceneSpec {
            look: self.look,
            view: self.view,
            eye: self.eye,
            target: self.target,
            projection: self.projection,
            fov: self.fov,
            view_height: self.view_height,
            clip: self.clip,
            near: self.near,
            far: self.far,
            size: self.size,
            samples: self.samples,
            exposure: self.exposure,
            tone: self.tone,
            light: light.filter(|_| self.point_light.is_empty()),
            lights: (!self.point_light.is_empty()).then(lights),
            light_angle: self.light_angle,
            ambient_color: self.ambient_color.or(color_of_ambient).map(colour),
            environment: self.environment.clone(),
            background: self.background,
            max_memory: self.max_memory,
            ..SceneSpec::of_surface(surface)
        }
    }
}

/// Reads a scene file that came by standard input. Its paths start at the current folder.
fn scene_of_input(copy: &Path) -> Result<SceneSpec, SceneError> {
    let text = std::fs::read(copy).and_then(|bytes| {
        let no_text = || {
            std::io::Error::new(std::io::ErrorKind::InvalidData, "it holds no text, so it is no scene file")
        };
        decode_text(bytes).ok_or_else(no_text)
    });
    let text = text.map_err(|source| SceneError::Io { path: INPUT.into(), source })?;
    parse_scene(&text, Path::new(INPUT))
}
