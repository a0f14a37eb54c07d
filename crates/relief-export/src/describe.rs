//! The manifest of a program.

use std::collections::BTreeMap;

use naga::ShaderStage;
use relief_shaders::bindings::{Binding, BindingKind};
use relief_shaders::surface::Proposal;
use relief_shaders::wgsl::BOX_VERTICES;
use relief_shaders::{MapNeed, STAGES, Selection};

use crate::manifest::{Bound, ChosenStage, Draw, Manifest, ParamPlace, Struct};
use crate::program::Program;
use crate::writers::stage_name;
use crate::{Options, layout, textures};

/// The uniform buffer of the parameters, and the members on the way to them.
const SETTINGS: &str = "surface_settings";
const CHOICES: (&str, &str) = ("SurfaceSettings", "choices");
const PARAMS: (&str, &str) = ("Choice", "params");

/// Makes the manifest, without the files.
pub fn manifest(selection: &Selection, program: &Program, name: &str, options: &Options) -> Manifest {
    let mut structs = BTreeMap::new();
    for binding in &program.parts.bindings {
        if let Some((_, variable)) = program.checked.variable(binding) {
            layout::collect(&program.checked.module, variable.ty, &mut structs);
        }
    }
    let needs = selection.map_needs();
    let bound = |binding: &Binding| bound(program, binding, &needs, options);
    Manifest {
        name: name.to_owned(),
        relief: env!("CARGO_PKG_VERSION").to_owned(),
        sampling: options.sampling.name(),
        draw: draw(selection, program),
        stages: stages(selection, program, &structs),
        bindings: program.parts.bindings.iter().map(bound).collect(),
        structs,
        targets: Vec::new(),
    }
}

fn draw(selection: &Selection, program: &Program) -> Draw {
    let (vertices_per_triangle, instances, cull) = match program.proposal {
        // Slices have no back.
        Proposal::Polygons if selection.paths().is_sliced() => (3, "1", "none"),
        Proposal::Polygons => (3, "1", "back, of a two-sided mesh none"),
        Proposal::Shells => (BOX_VERTICES, "1, of a two-sided mesh 2", "front"),
    };
    let depth = program.depth;
    let blend = if selection.is_translucent() { "premultiplied" } else { "none" };
    Draw { vertices_per_triangle, instances, cull, front_face: "counter-clockwise", depth, blend }
}

fn bound(program: &Program, binding: &Binding, needs: &[MapNeed], options: &Options) -> Bound {
    let Binding { group, number, name, kind, holds } = *binding;
    let kind_name = match kind {
        BindingKind::Uniform(_) => "uniform",
        BindingKind::Storage { .. } => "storage",
        BindingKind::Sampler => "sampler",
        BindingKind::Texture { .. } | BindingKind::IntegerTexture | BindingKind::Picture => "texture",
    };
    let declared = binding.declaration();
    let of = declared.rsplit_once(": ").map_or("", |(_, of)| of.trim_end_matches(';')).to_owned();
    let stages = [ShaderStage::Vertex, ShaderStage::Fragment];
    let read = stages.into_iter().filter(|stage| program.checked.reads(*stage, binding));
    Bound {
        name,
        group,
        binding: number,
        kind: kind_name,
        of,
        holds,
        stages: read.map(stage_name).collect(),
        texture: textures::need(binding, needs, options),
        structure: binding.structure().map(str::to_owned),
    }
}

/// The stages that are run, with the parameters that the shader reads.
fn stages(selection: &Selection, program: &Program, structs: &BTreeMap<String, Struct>) -> Vec<ChosenStage> {
    let member = |(structure, name): (&str, &str)| {
        structs.get(structure)?.members.iter().find(|member| member.name == name)
    };
    let places = member(CHOICES).and_then(|choices| Some((choices.offset, choices.array?.stride)));
    let places = places.zip(member(PARAMS).map(|params| params.offset));
    let chosen = STAGES.iter().zip(&selection.choices).enumerate();
    let chosen = chosen.filter(|(place, _)| program.parts.has_stage(*place));
    chosen
        .map(|(place, (stage, choice))| {
            let entry = choice.entry;
            let params = entry.params.iter().zip(choice.params).zip((0u32..).zip(["x", "y", "z", "w"]));
            let at = |component: u32| {
                places.map_or(0, |((first, stride), params)| {
                    first + place as u32 * stride + params + 4 * component
                })
            };
            let params = params.map(|((param, value), (component, letter))| ParamPlace {
                name: param.name,
                summary: param.summary,
                unit: param.unit,
                value,
                min: param.min,
                max: param.max,
                integer: param.integer,
                uniform: SETTINGS,
                member: format!("choices[{place}].params.{letter}"),
                offset: at(component),
            });
            let published = [entry.publication.paper, entry.publication.section].join(", ");
            ChosenStage {
                stage: stage.key,
                name: entry.name,
                summary: entry.summary,
                published: published.trim_end_matches(", ").to_owned(),
                params: params.collect(),
            }
        })
        .collect()
}
