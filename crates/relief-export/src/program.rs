//! The assembled shader of a selection as naga's module, whole or for one of its stages.

use naga::compact::{KeepUnused, compact};
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use naga::{GlobalVariable, Handle, Module, ShaderStage};
use relief_shaders::Selection;
use relief_shaders::bindings::Binding;
use relief_shaders::surface::{Paths, Proposal, Shown};
use relief_shaders::wgsl::{Parts, Root};

use crate::{ExportError, Options, Placement, Target, binding_points};

/// A shader, parsed.
pub struct Program {
    /// The shader's parts, with the final numbers of the bindings.
    pub parts: Parts,
    /// The place where the relief may be seen.
    pub proposal: Proposal,
    /// Whether fragments write depth.
    pub depth: bool,
    /// The vertex and the fragment function.
    pub entry_points: [&'static str; 2],
    /// The declarations, as WGSL.
    pub code: String,
    pub checked: Checked,
}

/// A valid module.
pub struct Checked {
    pub module: Module,
    pub info: ModuleInfo,
}

impl Program {
    /// Assembles the shader that draws a selection.
    pub fn new(selection: &Selection, options: &Options) -> Result<Self, ExportError> {
        let Paths { proposal, shown, .. } = *selection.paths();
        let (root, depth) = match proposal {
            Proposal::Shells if selection.is_translucent() => (Root::DrawTranslucent, true),
            Proposal::Shells if shown == Shown::Object => (Root::DrawObjects, true),
            Proposal::Shells => (Root::DrawShells, true),
            Proposal::Polygons if options.depth => (Root::DrawDepth, true),
            Proposal::Polygons => (Root::Draw, false),
        };
        let mut parts = Parts::new(selection, root, options.sampling);
        if let Some(Placement { group, first_binding }) = options.placement {
            for (place, binding) in (0u32..).zip(&mut parts.bindings) {
                (binding.group, binding.number) = (group, first_binding.saturating_add(place));
            }
        }
        // A target that lacks a function is named as the fault, not the shader.
        for profile in &options.profiles {
            binding_points::points(profile.target(), &parts.bindings, options)?;
        }
        let code = parts.code();
        let checked = Checked::read(&code)?;
        let [vertex, fragment] = [ShaderStage::Vertex, ShaderStage::Fragment].map(|stage| {
            let name = |name: &&str| checked.entry(stage).is_some_and(|(found, _)| found == *name);
            root.functions().iter().copied().find(name)
        });
        let missing = || ExportError::Invalid("it has no vertex or no fragment function".to_owned());
        let entry_points = [vertex.ok_or_else(missing)?, fragment.ok_or_else(missing)?];
        Ok(Self { parts, proposal, depth, entry_points, code, checked })
    }
}

impl Checked {
    /// Reads a text without entry points.
    pub fn read(text: &str) -> Result<Self, ExportError> {
        let parsed = naga::front::wgsl::parse_str(text);
        Self::of(parsed.map_err(|error| ExportError::Invalid(error.emit_to_string(text)))?)
    }

    fn of(module: Module) -> Result<Self, ExportError> {
        let mut validator = Validator::new(ValidationFlags::all(), Capabilities::empty());
        let info = validator.validate(&module);
        let info = info.map_err(|error| ExportError::Invalid(error.into_inner().to_string()))?;
        Ok(Self { module, info })
    }

    /// Returns the name of a stage's function, and its place among all of them.
    pub fn entry(&self, stage: ShaderStage) -> Option<(&str, usize)> {
        let mut entries = self.module.entry_points.iter().enumerate();
        entries.find(|(_, entry)| entry.stage == stage).map(|(place, entry)| (entry.name.as_str(), place))
    }

    /// Returns the program with one stage alone, and only with what it calls.
    pub fn of_stage(&self, stage: ShaderStage) -> Result<Self, ExportError> {
        let mut module = self.module.clone();
        module.entry_points.retain(|entry| entry.stage == stage);
        compact(&mut module, KeepUnused::No);
        Self::of(module)
    }

    /// Returns the variable of a binding.
    pub fn variable(&self, binding: &Binding) -> Option<(Handle<GlobalVariable>, &GlobalVariable)> {
        let is_it = |variable: &GlobalVariable| {
            variable.binding.is_some_and(|at| (at.group, at.binding) == (binding.group, binding.number))
        };
        self.module.global_variables.iter().find(|(_, variable)| is_it(variable))
    }

    /// Whether a stage reads a binding.
    pub fn reads(&self, stage: ShaderStage, binding: &Binding) -> bool {
        let place = self.entry(stage).map(|(_, place)| place);
        place
            .zip(self.variable(binding))
            .is_some_and(|(place, (variable, _))| !self.info.get_entry_point(place)[variable].is_empty())
    }

    /// Returns the error of a writer that refused this module, with the function at fault: the
    /// writer refuses that function with all others empty.
    pub fn refused<T>(
        &self,
        target: Target,
        error: String,
        write: impl Fn(&Module, &ModuleInfo) -> Result<T, String>,
    ) -> ExportError {
        let emptied = |of: &naga::Function| naga::Function {
            name: of.name.clone(),
            arguments: of.arguments.clone(),
            result: of.result.clone(),
            ..naga::Function::default()
        };
        let functions: Vec<_> = self.module.functions.iter().map(|(handle, _)| handle).collect();
        let found = functions.iter().find_map(|kept| {
            let mut module = self.module.clone();
            for entry in &mut module.entry_points {
                entry.function = emptied(&entry.function);
            }
            for other in functions.iter().filter(|other| *other != kept) {
                module.functions[*other] = emptied(&module.functions[*other]);
            }
            let reason = write(&module, &self.info).err()?;
            let function = module.functions[*kept].name.clone()?;
            Some(ExportError::Inexpressible { target, function, reason })
        });
        found.unwrap_or_else(|| {
            let function = self.module.entry_points.last().map_or(String::new(), |entry| entry.name.clone());
            ExportError::Inexpressible { target, function, reason: error }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_function_that_a_writer_refuses_is_named() {
        let text = "fn fine(x: f32) -> f32 { return x + 1.0; }\n\
                    fn odd(x: f32) -> f32 { return x * 2.0; }\n\
                    @fragment fn main() -> @location(0) vec4f { return vec4f(fine(odd(1.0))); }";
        let checked = Checked::of(naga::front::wgsl::parse_str(text).expect("valid")).expect("valid");
        // A writer that knows no product.
        let write = |module: &Module, _: &ModuleInfo| {
            let is_product = |expression: &naga::Expression| {
                matches!(expression, naga::Expression::Binary { op: naga::BinaryOperator::Multiply, .. })
            };
            let mut functions = module.functions.iter();
            let refused = functions.any(|(_, of)| of.expressions.iter().any(|(_, each)| is_product(each)));
            if refused { Err("a product".to_owned()) } else { Ok(()) }
        };
        let error = checked.refused(Target::Glsl, "a product".to_owned(), write);
        let ExportError::Inexpressible { function, reason, .. } = &error else { panic!("{error}") };
        assert_eq!((function.as_str(), reason.as_str()), ("odd", "a product"));
    }
}
