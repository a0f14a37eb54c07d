//! A method as functions, for the fragment functions of other programs.
//!
//! [`functions`] makes a small text that holds one method and nothing else: a point of a mesh and the
//! direction of a ray go in, the hit on the relief comes out, and the part of a light that arrives there.
//! It has no vertices, no lights and no entry points; all names begin with a prefix.
//!
//! The text is the shaders' own, reduced: choices that are made are put in their places, and what is then not
//! needed is left out. Arithmetic on floats is never done or moved, so hits keep their bits.

mod form;
mod languages;
mod manifest;
mod names;
mod parameters;
mod reduce;
mod settings;
mod syntax;
mod textures;
mod unreal_node;

use relief_core::{RayUse, Wrap};
use relief_shaders::bindings::Binding;
use relief_shaders::shadow::ShadowRole;
use relief_shaders::wgsl::{Parts, Sampling};
use relief_shaders::{
    DETAIL, Entry, GEOMETRY, MapNeed, MapSlot, SEARCH, SHADOW, STAGES, SURFACE, Selection, Variants,
};

pub use self::form::Form;
pub use self::manifest::{BoundTexture, FunctionsManifest, Lent, Passed, SettingPlace};
pub use self::names::Prefix;
use self::reduce::{Kept, reduce};
use self::settings::Setting;
use self::syntax::{Item, ItemKind, Member, Struct, Unit};
pub use self::unreal_node::{unreal_input, unreal_node};
use crate::{ExportError, File, Placement, Profile, Target};

/// Options of a method as functions.
#[derive(Clone, Debug)]
pub struct FunctionOptions {
    /// The files' name before their endings; by default the names of search and refinement.
    pub name: Option<String>,
    /// The kind of input.
    pub form: Form,
    /// What all names begin with, in small letters: `relief` gives `relief_hit` and `ReliefHit`.
    pub prefix: String,
    /// The height map beyond its edges. `None`: a setting says so.
    pub wrap: Option<Wrap>,
    /// Whether hits in holes are misses: one more texture is read.
    pub holes: bool,
    /// Whether shells may overlap themselves; in the form [`Form::Triangle`] alone.
    pub folds: bool,
    /// The way in which textures are read.
    pub sampling: Sampling,
    /// The profiles to write, each in a file of its own.
    pub profiles: Vec<Profile>,
    /// The place of all bindings; by default group 0, from 0 on.
    pub placement: Option<Placement>,
    /// A function that returns instructions for baking a map. Heads and manifests quote it.
    pub bake: Option<fn(&MapNeed) -> String>,
}

impl Default for FunctionOptions {
    /// WGSL in tangent space with exact sampling, any wrap, without holes.
    fn default() -> Self {
        Self {
            name: None,
            form: Form::Tangent,
            prefix: "relief".to_owned(),
            wrap: None,
            holes: false,
            folds: false,
            sampling: Sampling::Exact,
            profiles: vec![Profile::Wgsl],
            placement: None,
            bake: None,
        }
    }
}

/// A method as functions, in memory.
#[derive(Clone, Debug, PartialEq)]
pub struct ExportedFunctions {
    /// The texts, and last the manifest as JSON.
    pub files: Vec<File>,
    /// The content of the last file.
    pub manifest: FunctionsManifest,
}

/// Writes a method as functions. The bytes are the same on every run.
///
/// # Errors
///
/// When the stages do not go together or have no functions in that form, when the prefix is no name, or when
/// a target cannot express them.
///
/// # Examples
///
/// ```
/// use relief_core::{RayUse, Wrap};
/// use relief_export::{FunctionOptions, functions};
/// use relief_shaders::Selection;
///
/// let mut cone = Selection::method("cone")?;
/// cone.choose("shadow", "none")?;
/// let options = FunctionOptions {
///     prefix: "rock".to_owned(),
///     wrap: Some(Wrap::Repeat),
///     ..FunctionOptions::default()
/// };
/// let exported = functions(&cone, &options)?;
/// let text = String::from_utf8_lossy(&exported.files[0].bytes);
/// assert!(text.contains("fn rock_hit(settings: RockSettings, at: RockPoint) -> RockHit {"));
/// let textures: Vec<&str> = exported.manifest.bindings.iter().map(|bound| bound.name.as_str()).collect();
/// assert_eq!(textures, ["rock_height_map", "rock_search_map"]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn functions(selection: &Selection, options: &FunctionOptions) -> Result<ExportedFunctions, ExportError> {
    check(selection, options.form)?;
    if options.profiles.is_empty() {
        return Err(ExportError::NoTarget);
    }
    let derived = || format!("{}-{}", selection.search().name, selection.refine().name);
    let name = options.name.clone().unwrap_or_else(derived);
    let name = crate::options::checked_name(&name)?;
    let prefix = Prefix::new(&options.prefix)?;
    let reduced = Reduced::new(selection, options, &prefix)?;
    let mut manifest = manifest::of(selection, &reduced, &prefix, name, options)?;
    let mut files: Vec<File> = Vec::new();
    for profile in &options.profiles {
        let (ending, text) = match profile.target() {
            Target::Wgsl => ("wgsl", reduced.text.clone()),
            Target::Wesl => ("wesl", reduced.text.clone()),
            target @ (Target::Glsl | Target::Hlsl | Target::Msl | Target::Godot | Target::Unreal) => {
                let text = languages::write(selection, &reduced, &prefix, *profile, options)?;
                let ending = match target {
                    Target::Msl => "metal",
                    Target::Godot => "gdshaderinc",
                    Target::Unreal => "ush",
                    _ => target.name(),
                };
                (ending, text)
            }
            target @ Target::Spirv => return Err(ExportError::NoFunctionsIn { target }),
        };
        let head = manifest::head(selection, &reduced, &manifest, *profile, &text);
        let file = File { name: format!("{name}.{ending}"), bytes: (head + "\n" + &text).into_bytes() };
        if files.iter().any(|other| other.name == file.name) {
            return Err(ExportError::SameFile(file.name));
        }
        manifest.files.push(file.name.clone());
        files.push(file);
    }
    let json = serde_json::to_string_pretty(&manifest);
    let json = json.map_err(|error| ExportError::Invalid(error.to_string()))?;
    files.push(File { name: format!("{name}.json"), bytes: (json + "\n").into_bytes() });
    Ok(ExportedFunctions { files, manifest })
}

/// Checks that a selection has functions in a form.
fn check(selection: &Selection, form: Form) -> Result<(), ExportError> {
    let refused = |place: usize, reason: String| {
        let (stage, entry) = (STAGES[place].title, selection.choices[place].entry.name);
        Err(ExportError::NoFunctions { stage, entry, key: STAGES[place].key, reason })
    };
    if selection.geometry().is_some() {
        let reason = "its triangles are made on the CPU, and no ray is traced through a relief on them: \
                      choose a method that traces rays, as 'cone' or 'relief'";
        return refused(GEOMETRY, reason.to_owned());
    }
    if selection.is_translucent() {
        return refused(SEARCH, "nothing is hit in a translucent volume".to_owned());
    }
    let surface = selection.choices[SURFACE].entry;
    if !form.takes(surface) {
        let mut reason = match form {
            Form::Tangent => "its rays need more than a point of the mesh".to_owned(),
            Form::Triangle => "its triangles have no relief on them".to_owned(),
        };
        let others = Variants::of(SURFACE, |entry| form.takes(entry)).or();
        reason += &format!(": choose {others}");
        if let Some(other) = Form::ALL.into_iter().find(|other| other.takes(surface)) {
            reason += &format!(", or the form '{other}'");
        }
        return refused(SURFACE, reason);
    }
    let shadow = selection.choices[SHADOW].entry;
    let knows_light = |entry: &Entry| !entry.shadow().is_some_and(ShadowRole::sees_scene);
    if !knows_light(shadow) {
        let others = Variants::of(SHADOW, knows_light);
        return refused(
            SHADOW,
            format!("it knows more than the relief at a point: choose {}", others.active().or()),
        );
    }
    Ok(selection.check()?)
}

/// The use of rays whose map all rays read; none if view rays and shadow rays read different ones.
fn one_map(selection: &Selection) -> Option<RayUse> {
    let needs = selection.map_needs();
    let content = |slot: MapSlot| {
        let needs = needs.iter().filter(|need| need.slot == slot);
        let content =
            |need: &MapNeed| (need.input.kind, need.input.texture, need.settings.clone(), need.side);
        needs.map(content).collect::<Vec<_>>()
    };
    let [view, shadow] = [MapSlot::Search, MapSlot::ShadowSearch].map(content);
    match (view.is_empty(), shadow.is_empty()) {
        (_, true) => Some(RayUse::View),
        (true, false) => Some(RayUse::Shadow),
        (false, false) => (view == shadow).then_some(RayUse::View),
    }
}

/// A reduced shader.
struct Reduced {
    text: String,
    unit: Unit,
    settings: Vec<Setting>,
    /// The bound variables, under their names in the sources.
    bindings: Vec<Binding>,
}

impl Reduced {
    fn new(selection: &Selection, options: &FunctionOptions, prefix: &Prefix) -> Result<Self, ExportError> {
        let form = options.form;
        let parts = Parts::new(selection, form.root(), options.sampling);
        let code = parts.code();
        let mut unit = syntax::parse(&code).map_err(ExportError::Invalid)?;
        let called = form.called(selection);
        let kept = Kept { functions: &called, structs: form.given(), whole: &[form.found()] };
        let fixed = settings::fixed(options.wrap, options.holes, one_map(selection));
        settings::fix(&mut unit, &fixed);
        if form == Form::Triangle && !options.folds {
            settings::fix_unfolded(&mut unit);
        }
        parameters::separate(&mut unit, selection);
        reduce(&mut unit, &kept);
        let settings = settings::gather(&mut unit, selection)?;
        textures::flatten(&mut unit);
        reduce(&mut unit, &kept);
        without_empty_structs(&mut unit);
        settings::hand_over(&mut unit);
        arrange(&mut unit, &settings, form);
        let bindings = place(&mut unit, &parts, options.placement);
        prefix.rename(&mut unit);
        Ok(Self { text: syntax::print(&unit), unit, settings, bindings })
    }
}

/// Leaves out structs without members, and the members that have such a type. No value is made of them: one
/// that is read keeps its members.
fn without_empty_structs(unit: &mut Unit) {
    let is_empty = |item: &Item| matches!(&item.kind, ItemKind::Struct(of) if of.members.is_empty());
    while let Some(place) = unit.items.iter().position(is_empty) {
        let item = unit.items.remove(place);
        let Some(name) = item.kind.name() else { continue };
        for item in &mut unit.items {
            if let ItemKind::Struct(of) = &mut item.kind {
                of.members.retain(|member| member.of != name);
            }
        }
    }
}

/// Puts what programs use first: the settings, then the section of the functions that they call.
fn arrange(unit: &mut Unit, settings: &[Setting], form: Form) {
    let is_called = |item: &Item| item.kind.name() == Some(form.hit());
    let place = unit.items.iter().position(is_called).unwrap_or_default();
    let is_heading = |item: &Item| item.kind == ItemKind::Heading;
    let begin = unit.items[..place].iter().rposition(is_heading).unwrap_or_default();
    let end = unit.items[place..].iter().position(is_heading).map_or(unit.items.len(), |end| place + end);
    let mut section: Vec<Item> = unit.items.drain(begin..end).collect();
    let members = settings.iter().map(|setting| Member {
        comment: wrapped(&setting.comment()),
        name: setting.name.clone(),
        of: setting.of.clone(),
    });
    let structure = Struct { name: settings::STRUCT.to_owned(), members: members.collect() };
    let comment = vec!["What is the same for all points of a surface.".to_owned()];
    section.insert(1, Item { comment, kind: ItemKind::Struct(structure) });
    unit.items.splice(0..0, section);
}

/// A sentence in lines.
fn wrapped(text: &str) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if line.len() + word.len() < 100 => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// Numbers the bindings, in the order of the sources' table.
fn place(unit: &mut Unit, parts: &Parts, placement: Option<Placement>) -> Vec<Binding> {
    let Placement { group, first_binding } = placement.unwrap_or(Placement { group: 0, first_binding: 0 });
    let is_bound = |binding: &&Binding| unit.variables().any(|variable| variable.name == binding.name);
    let mut bindings: Vec<Binding> = parts.bindings.iter().filter(is_bound).copied().collect();
    for (number, binding) in (first_binding..).zip(&mut bindings) {
        (binding.group, binding.number) = (group, number);
    }
    for item in &mut unit.items {
        if let ItemKind::Variable(variable) = &mut item.kind
            && let Some(binding) = bindings.iter().find(|binding| binding.name == variable.name)
        {
            (variable.group, variable.binding) = (binding.group, binding.number);
        }
    }
    bindings
}

/// Whether pixels choose a level of detail.
fn has_footprint(selection: &Selection) -> bool {
    !selection.choices[DETAIL].entry.is_idle()
}
