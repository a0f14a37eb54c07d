//! Checks of a linked shader: naga's validation, and constructs that the translation to Rust would get wrong.

use naga::valid::{Capabilities, FunctionInfo, ModuleInfo, ValidationFlags, Validator};
use naga::{
    BinaryOperator, Block, Expression, Handle, MathFunction, Module, ScalarKind, Statement, SwizzleComponent,
    TypeInner,
};

use super::modules::Modules;

/// Parses and validates WGSL.
pub fn validate(text: &str) -> Result<(Module, ModuleInfo), String> {
    let module = naga::front::wgsl::parse_str(text).map_err(|error| error.emit_to_string(text))?;
    let info = Validator::new(ValidationFlags::all(), Capabilities::empty())
        .validate(&module)
        .map_err(|error| error.emit_to_string(text))?;
    Ok((module, info))
}

/// The functions whose translation has the bits of the GPU.
const SAME_BITS: [MathFunction; 14] = [
    MathFunction::Abs,
    MathFunction::Min,
    MathFunction::Max,
    MathFunction::Clamp,
    MathFunction::Saturate,
    MathFunction::Sign,
    MathFunction::Floor,
    MathFunction::Ceil,
    MathFunction::Dot,
    MathFunction::Cross,
    MathFunction::Length,
    MathFunction::Normalize,
    MathFunction::Mix,
    MathFunction::Sqrt,
];

/// Refuses what the translation does not know, gets wrong, or rounds differently from a GPU.
pub fn refuse_untranslatable(
    module: &Module,
    info: &ModuleInfo,
    text: &str,
    modules: &Modules,
) -> Result<(), String> {
    let mut refused = Vec::new();
    for (_, global) in module.global_variables.iter() {
        if global.space == naga::AddressSpace::Private
            || matches!(global.space, naga::AddressSpace::Storage { .. })
        {
            let name = global.name.as_deref().unwrap_or("?");
            refused.push(format!("variable {name}: only uniforms and textures translate"));
        }
    }
    for (handle, function) in module.functions.iter() {
        let name = function.name.as_deref().unwrap_or("?");
        let checker = Checker { module, info: &info[handle] };
        for argument in &function.arguments {
            if matches!(module.types[argument.ty].inner, TypeInner::Pointer { .. }) {
                refused.push(format!("{}: a pointer argument does not translate", modules.locate(name, "")));
            }
        }
        let mut say = |span: naga::Span, what: &str| {
            let code = span.to_range().and_then(|range| text.get(range)).unwrap_or_default();
            refused.push(format!("{}: {what}: {code}", modules.locate(name, code)));
        };
        for (expression, kind) in function.expressions.iter() {
            if let Some(what) = checker.expression(kind) {
                say(function.expressions.get_span(expression), what);
            }
        }
        checker.block(&function.body, &mut say);
    }
    if refused.is_empty() { Ok(()) } else { Err(refused.join("\n")) }
}

struct Checker<'a> {
    module: &'a Module,
    info: &'a FunctionInfo,
}

impl Checker<'_> {
    fn is_float(&self, expression: Handle<Expression>) -> bool {
        let inner = self.info[expression].ty.inner_with(&self.module.types);
        inner.scalar_kind() == Some(ScalarKind::Float)
    }

    /// Why an expression cannot be translated, if it cannot.
    fn expression(&self, expression: &Expression) -> Option<&'static str> {
        match expression {
            Expression::Math { fun, .. } if !SAME_BITS.contains(fun) => {
                Some("this function differs between the GPU and its translation")
            }
            Expression::Binary { op: BinaryOperator::Modulo, left, .. } if self.is_float(*left) => {
                Some("% on floats differs between the GPU and its translation")
            }
            Expression::Swizzle { size, pattern, .. } if !leading(*size as usize, pattern) => {
                Some("only swizzles that permute the leading components translate")
            }
            Expression::ImageSample { .. } => Some("sampling does not translate"),
            Expression::Derivative { .. } => Some("derivatives do not translate"),
            Expression::Override(_) => Some("pipeline constants do not translate"),
            Expression::ArrayLength(_) => Some("runtime-sized arrays do not translate"),
            Expression::As { convert: None, .. } => Some("bitcasts do not translate"),
            _ => None,
        }
    }

    fn block(&self, block: &Block, say: &mut impl FnMut(naga::Span, &str)) {
        for (statement, span) in block.span_iter() {
            match statement {
                Statement::Block(inner) => self.block(inner, say),
                Statement::If { accept, reject, .. } => {
                    self.block(accept, say);
                    self.block(reject, say);
                }
                Statement::Switch { cases, .. } => {
                    for case in cases {
                        self.block(&case.body, say);
                    }
                }
                Statement::Loop { body, continuing, break_if } => {
                    if !continuing.is_empty() || break_if.is_some() {
                        say(
                            *span,
                            "a continuing block (or a for loop) does not see the loop's locals: use while",
                        );
                    }
                    self.block(body, say);
                }
                Statement::Kill => say(*span, "discard becomes a panic"),
                Statement::Emit(_)
                | Statement::Break
                | Statement::Continue
                | Statement::Return { .. }
                | Statement::Store { .. }
                | Statement::Call { .. } => {}
                _ => say(*span, "this statement does not translate"),
            }
        }
    }
}

/// Whether the components taken are the first `size` ones, in any order.
fn leading(size: usize, pattern: &[SwizzleComponent; 4]) -> bool {
    let mut seen = [false; 4];
    for component in &pattern[..size] {
        seen[*component as usize] = true;
    }
    seen[..size].iter().all(|&seen| seen)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is said of a module that holds just this function.
    fn refused(source: &str) -> Option<String> {
        let modules = Modules::from_sources([("search/trial", source)]);
        let (module, info) = validate(source).expect("valid WGSL");
        refuse_untranslatable(&module, &info, source, &modules).err()
    }

    #[test]
    fn what_translates_passes() {
        let source = "fn trial(x: vec3f) -> f32 {\n    var sum = 0.0;\n    var k = 0.0;\n    \
            while (k < 3.0) {\n        \
            sum = sum + sqrt(dot(x, x)) * x.xy.x;\n        k = k + 1.0;\n    }\n    \
            return clamp(sum, 0.0, 1.0);\n}\n";
        assert_eq!(refused(source), None);
    }

    #[test]
    fn what_rounds_differently_or_does_not_translate_is_refused_with_file_and_line() {
        let bodies = [
            "return pow(x, 2.0);",
            "return sin(x);",
            "return fract(x);",
            "return x % 2.0;",
            "return fma(x, x, x);",
            "return vec3f(x, x, x).yz.x;",
            "return bitcast<f32>(u32(x));",
            "return dpdx(x);",
        ];
        for body in bodies {
            let said = refused(&format!("// A trial.\n\nfn trial(x: f32) -> f32 {{\n    {body}\n}}\n"));
            let said = said.unwrap_or_else(|| panic!("{body} was not refused"));
            assert!(said.starts_with("search/trial.wesl:4: "), "{body}: {said}");
        }
    }

    #[test]
    fn loops_with_a_continuing_block_and_private_variables_are_refused() {
        let counted = "fn trial(x: f32) -> f32 {\n    var y = x;\n    for (var k = 0; k < 3; k++) {\n        \
                       y = y + x;\n    }\n    return y;\n}\n";
        assert!(refused(counted).is_some_and(|said| said.contains("use while")));
        let private = "var<private> state: f32;\nfn trial(x: f32) -> f32 {\n    return x + state;\n}\n";
        assert!(refused(private).is_some_and(|said| said.contains("state")));
    }
}
