//! What a program must know of functions: settings, bindings and maps, for programs and in words.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use relief_shaders::{MapSlot, STAGES, Selection};
use serde::Serialize;

use super::names::Prefix;
use super::settings::{STRUCT, Setting};
use super::syntax::{ItemKind, Member};
use super::{Form, FunctionOptions, Reduced, has_footprint};
use crate::manifest::{Bake, ChosenStage, TextureNeed};
use crate::program::Checked;
use crate::{ExportError, Options, Profile, layout, textures};

/// A method as functions. Its JSON is `NAME.json`.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FunctionsManifest {
    /// The files' name before their endings.
    pub name: String,
    /// The version of relief that wrote it.
    pub relief: String,
    /// The prefix of all names.
    pub prefix: String,
    /// The kind of input: `tangent` or `triangle`.
    pub form: &'static str,
    /// The way in which textures are read: `exact` or `fast`.
    pub sampling: &'static str,
    /// The wrap that the functions have; none where a setting says so.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wrap: Option<&'static str>,
    /// The functions to call, as WGSL declares them, and what each does.
    pub functions: Vec<Lent>,
    /// The members of what goes in, in tangent space: a point of the mesh and the ray that sees it.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub point: Vec<Passed>,
    /// The structs that go in, in the form `triangle`: their members by their names.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub structs: BTreeMap<String, Vec<Passed>>,
    /// The members of what comes out.
    pub hit: Vec<Passed>,
    /// The size of the settings' struct in a uniform buffer, in bytes.
    pub settings_size: u32,
    /// The members of the settings' struct.
    pub settings: Vec<SettingPlace>,
    /// The textures, and with `fast` the sampler.
    pub bindings: Vec<BoundTexture>,
    /// The variants that are run, stage by stage.
    pub stages: Vec<ChosenStage>,
    /// The files.
    pub files: Vec<String>,
}

/// A function that programs call.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Lent {
    /// Its declaration in WGSL.
    pub declaration: String,
    /// What it does.
    pub does: String,
}

/// A member of a struct that goes in or comes out.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Passed {
    /// The member's name.
    pub name: String,
    /// Its type in WGSL.
    #[serde(rename = "type")]
    pub of: String,
    /// What it holds; members of one sentence stand together.
    pub holds: String,
}

/// A member of the settings' struct.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SettingPlace {
    /// The member's name.
    pub name: String,
    /// Its type in WGSL.
    #[serde(rename = "type")]
    pub of: String,
    /// Offset from the beginning of the struct, in bytes.
    pub offset: u32,
    /// What it holds.
    pub holds: String,
    /// For a parameter, the value to begin with, the least and the greatest.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub value: Option<f32>,
    /// The least value.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub min: Option<f32>,
    /// The greatest value.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max: Option<f32>,
}

/// A bound texture, or the sampler.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BoundTexture {
    /// The variable.
    pub name: String,
    /// Its type in WGSL.
    #[serde(rename = "type")]
    pub of: String,
    /// The bind group.
    pub group: u32,
    /// The number in it.
    pub binding: u32,
    /// The content, in words.
    pub holds: &'static str,
    /// For a texture, requirements on its texels.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub texture: Option<TextureNeed>,
}

impl Setting {
    /// What it holds, with the value to begin with.
    pub fn comment(&self) -> String {
        match self.param {
            Some((_, value)) => format!("{} Begins with {value}.", self.holds),
            None => self.holds.clone(),
        }
    }
}

pub fn of(
    selection: &Selection,
    reduced: &Reduced,
    prefix: &Prefix,
    name: &str,
    options: &FunctionOptions,
) -> Result<FunctionsManifest, ExportError> {
    let checked = Checked::read(&reduced.text)?;
    let mut structs = BTreeMap::new();
    for (handle, _) in checked.module.types.iter() {
        layout::collect(&checked.module, handle, &mut structs);
    }
    let structure = structs.get(&prefix.of(STRUCT));
    let settings = reduced.settings.iter().map(|setting| {
        let member = structure.and_then(|of| of.members.iter().find(|member| member.name == setting.name));
        SettingPlace {
            name: setting.name.clone(),
            of: setting.of.clone(),
            offset: member.map_or(0, |member| member.offset),
            holds: setting.holds.clone(),
            value: setting.param.map(|(_, value)| value),
            min: setting.param.map(|(param, _)| param.min),
            max: setting.param.map(|(param, _)| param.max),
        }
    });
    let settings: Vec<SettingPlace> = settings.collect();
    let mut given: BTreeMap<String, Vec<Passed>> = BTreeMap::new();
    let mut point = Vec::new();
    for name in options.form.given().iter().map(|name| prefix.of(name)) {
        let members = passed(reduced, &name);
        match options.form {
            Form::Tangent => point = members,
            Form::Triangle => drop(given.insert(name, members)),
        }
    }
    Ok(FunctionsManifest {
        name: name.to_owned(),
        relief: env!("CARGO_PKG_VERSION").to_owned(),
        prefix: options.prefix.clone(),
        form: options.form.name(),
        sampling: options.sampling.name(),
        wrap: options.wrap.map(relief_core::Wrap::name),
        functions: lent(selection, reduced, prefix, options.form),
        point,
        structs: given,
        hit: passed(reduced, &prefix.of(options.form.found())),
        settings_size: structure.map_or(0, |of| of.size),
        settings,
        bindings: bound(selection, reduced, prefix, options),
        stages: stages(selection),
        files: Vec::new(),
    })
}

fn lent(selection: &Selection, reduced: &Reduced, prefix: &Prefix, form: Form) -> Vec<Lent> {
    let called = form.called(selection);
    let lent = called.into_iter().filter_map(|name| {
        let name = prefix.of(name);
        let item = reduced.unit.items.iter().find(|item| item.kind.name() == Some(&name))?;
        let ItemKind::Function(function) = &item.kind else { return None };
        let given = function.parameters.iter().map(|of| format!("{}: {}", of.name, of.of));
        let declaration =
            format!("fn {name}({}) -> {}", given.collect::<Vec<_>>().join(", "), function.returns);
        Some(Lent { declaration, does: item.comment.join(" ") })
    });
    lent.collect()
}

/// The members of a struct that goes in or comes out.
fn passed(reduced: &Reduced, name: &str) -> Vec<Passed> {
    let structure = reduced.unit.structs().find(|structure| structure.name == name);
    let members = structure.into_iter().flat_map(|structure| &structure.members);
    let member =
        |of: &Member| Passed { name: of.name.clone(), of: of.of.clone(), holds: of.comment.join(" ") };
    members.map(member).collect()
}

fn bound(
    selection: &Selection,
    reduced: &Reduced,
    prefix: &Prefix,
    options: &FunctionOptions,
) -> Vec<BoundTexture> {
    let needs = selection.map_needs();
    let described = Options { sampling: options.sampling, bake: options.bake, ..Options::default() };
    let bound = reduced.bindings.iter().map(|binding| {
        let name = prefix.of(binding.name);
        let variable = reduced.unit.variables().find(|variable| variable.name == name);
        let of = variable.map_or(String::new(), |variable| variable.of.clone());
        let has_levels = has_footprint(selection);
        let texture = textures::need(binding, &needs, &described);
        let texture = texture.map(|need| plain(need, binding.name, &of, has_levels));
        BoundTexture {
            name,
            of,
            group: binding.group,
            binding: binding.number,
            // A texture is bound because it is read.
            holds: binding.holds.split(';').next().unwrap_or_default(),
            texture,
        }
    });
    bound.collect()
}

/// The requirements of a texture in the words of functions.
fn plain(need: TextureNeed, name: &str, of: &str, has_levels: bool) -> TextureNeed {
    let has_layers = of.contains("array");
    let slot = MapSlot::ALL.into_iter().find(|slot| slot.name() == name);
    let in_settings = |text: &str| {
        let text = text.replace("surface_settings.height_levels", "height_levels");
        match slot {
            Some(slot) => {
                text.replace(&format!("surface_settings.maps[{}].", slot as u32), &format!("{}_", slot.key()))
            }
            None => text,
        }
    };
    TextureNeed {
        dimension: if has_layers { "2d-array" } else { "2d" },
        levels: if has_levels { in_settings(&need.levels) } else { without_levels(&need.levels) },
        layers: if has_layers { in_settings(&need.layers) } else { "1".to_owned() },
        ..need
    }
}

/// The levels of a texture where the finest level of the heights alone is read: maps of every level have
/// one, other maps all of theirs.
fn without_levels(levels: &str) -> String {
    let is_of_heights = levels.starts_with("surface_settings.") || levels.starts_with("one for each level");
    if is_of_heights { "1".to_owned() } else { levels.to_owned() }
}

fn stages(selection: &Selection) -> Vec<ChosenStage> {
    let is_run = |place: &usize| {
        let is_other = ["geometry", "slices", "object", "shade", "ambient"].contains(&STAGES[*place].key);
        let is_idle = match STAGES[*place].key {
            "detail" => !has_footprint(selection),
            "shadow" | "shadow-search" => !selection.has_shadows() || !selection.uses(*place),
            _ => false,
        };
        !is_other && !is_idle
    };
    let chosen = (0..STAGES.len()).filter(is_run).map(|place| {
        let entry = selection.choices[place].entry;
        let published = [entry.publication.paper, entry.publication.section].join(", ");
        ChosenStage {
            stage: STAGES[place].key,
            name: entry.name,
            summary: entry.summary,
            published: published.trim_end_matches(", ").to_owned(),
            params: Vec::new(),
        }
    });
    chosen.collect()
}

/// The comment at the head of a text.
pub fn head(
    selection: &Selection,
    reduced: &Reduced,
    manifest: &FunctionsManifest,
    profile: Profile,
    code: &str,
) -> String {
    let mut text = format!(
        "// Relief: displacement mapping, a method as functions. {}, {} sampling.\n\
         // SPDX-License-Identifier: MIT OR Apache-2.0\n//\n",
        profile.title(),
        manifest.sampling
    );
    if matches!(profile, Profile::Es300 | Profile::Es310) {
        text += "// Put `precision highp float; precision highp int;` before it.\n//\n";
    }
    for stage in &manifest.stages {
        let _ = writeln!(text, "// {}: {}, {} ({})", stage.stage, stage.name, stage.summary, stage.published);
    }
    text += "//\n// Functions:\n";
    // Methods of a struct begin behind it.
    let behind = if profile == Profile::Unreal5 { "    " } else { "" };
    let mut lines = code.lines().map(|line| line.strip_prefix(behind).unwrap_or(line));
    while let Some(line) = lines.next() {
        if declares(line, manifest) {
            // Some languages have a line for each parameter.
            let mut declared = line.to_owned();
            while !declared.contains(')')
                && let Some(more) = lines.next()
            {
                declared += &format!(" {}", more.trim());
            }
            let declared = declared.replace("( ", "(").replace(" )", ")");
            let _ = writeln!(text, "//   {}", declared.trim_end_matches([' ', '{']));
        }
    }
    text += "//\n// Textures:\n";
    for bound in &manifest.bindings {
        let (name, of, holds) = (&bound.name, &bound.of, bound.holds);
        let _ = writeln!(text, "//   {name}: {of}; {holds}");
        if let Some(need) = &bound.texture {
            let formats = need.formats.join(", ");
            let _ =
                writeln!(text, "//     formats: {formats}; levels: {}; layers: {}", need.levels, need.layers);
            if let Some(bake) = &need.bake {
                baked(&mut text, bake);
            }
        }
    }
    if !reduced.settings.is_empty() && !selection.map_needs().is_empty() {
        text += "//   Baked maps hold values: floats, or the texels of 8-bit files as they are.\n";
    }
    text
}

fn baked(text: &mut String, bake: &Bake) {
    let map = [bake.kind, bake.texture].join(" ");
    let settings = bake.settings.iter().map(|(name, value)| format!(", {name} = {value}"));
    let settings: String = settings.collect();
    let _ = writeln!(text, "//     baked map: {}{settings}, in {}", map.trim_end(), bake.metric);
    if let Some(how) = &bake.how {
        let _ = writeln!(text, "//     {how}");
    }
}

/// Whether a line begins a function that programs call.
fn declares(line: &str, manifest: &FunctionsManifest) -> bool {
    let is_begin = line.starts_with(|c: char| c.is_ascii_alphabetic());
    let is_it = |lent: &Lent| {
        let name = lent.declaration.trim_start_matches("fn ").split('(').next().unwrap_or_default();
        line.contains(&format!(" {name}("))
    };
    is_begin && manifest.functions.iter().any(is_it)
}
