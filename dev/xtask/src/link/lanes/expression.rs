//! Expressions over lanes. A vector is written component by component.

use naga::{Expression, Handle, Literal, MathFunction, TypeInner};

use super::function::{Refusal, Writer};
use super::operation;
use super::reach;
use super::types::{self, COMPONENTS, Kind};

type Text = Result<String, Refusal>;

impl Writer<'_> {
    pub fn is_uniform(&self, expression: Handle<Expression>) -> bool {
        self.facts().is_uniform(expression)
    }

    /// Names a value that has been worked out here where it is used more than once, or where it changes.
    pub fn emit(&mut self, handle: Handle<Expression>) -> Result<(), Refusal> {
        let wanted = match &self.function.expressions[handle] {
            Expression::Load { pointer } => reach::local_of(self.function, *pointer).is_some(),
            Expression::ImageLoad { .. } | Expression::Math { fun: MathFunction::Normalize, .. } => true,
            Expression::Literal(_)
            | Expression::Constant(_)
            | Expression::ZeroValue(_)
            | Expression::AccessIndex { .. }
            | Expression::Access { .. }
            | Expression::Swizzle { .. }
            | Expression::Splat { .. } => false,
            _ => {
                self.info[handle].ref_count > 1
                    || (self.info[handle].ref_count > 0
                        && self.function.named_expressions.contains_key(&handle))
            }
        };
        if wanted && self.named(handle).is_none() {
            self.name(handle)?;
        }
        Ok(())
    }

    fn name(&mut self, handle: Handle<Expression>) -> Text {
        let text = match self.function.expressions[handle] {
            Expression::Load { pointer } => self.place(pointer)?,
            Expression::ImageLoad { image, coordinate, array_index, level, .. } => {
                self.image_load(handle, image, coordinate, array_index, level)?
            }
            Expression::Math { fun: MathFunction::Normalize, arg, .. } => self.normalized(handle, arg)?,
            _ => self.value(handle, !self.is_uniform(handle))?,
        };
        Ok(self.bind(handle, &text))
    }

    /// Has a value a name, or a text that costs nothing to repeat.
    fn atom(&mut self, handle: Handle<Expression>) -> Result<(), Refusal> {
        let is_free = match self.function.expressions[handle] {
            Expression::Literal(_)
            | Expression::Constant(_)
            | Expression::ZeroValue(_)
            | Expression::FunctionArgument(_)
            | Expression::LocalVariable(_)
            | Expression::GlobalVariable(_) => true,
            Expression::AccessIndex { base, .. } => return self.atom(base),
            Expression::Splat { value, .. } => return self.atom(value),
            Expression::Swizzle { vector, .. } => return self.atom(vector),
            Expression::Load { pointer } => reach::local_of(self.function, pointer).is_none(),
            _ => false,
        };
        if !is_free && self.named(handle).is_none() {
            self.name(handle)?;
        }
        Ok(())
    }

    /// A whole value, of lanes or single.
    pub fn value(&mut self, handle: Handle<Expression>, is_lanes: bool) -> Text {
        if let Some((_, size)) = self.vector_of(handle) {
            if self.is_uniform(handle) != is_lanes {
                if let Some(name) = self.named(handle) {
                    return Ok(name.to_owned());
                }
                match self.function.expressions[handle] {
                    Expression::FunctionArgument(number) => return Ok(self.argument_name(number as usize)),
                    Expression::Load { pointer } => return self.place(pointer),
                    _ => {}
                }
            }
            let parts = (0..size).map(|at| self.part(handle, at, is_lanes)).collect::<Result<Vec<_>, _>>()?;
            return Ok(types::made(size, parts.into_iter()));
        }
        if let Expression::Compose { ty, ref components } = self.function.expressions[handle]
            && self.named(handle).is_none()
        {
            return self.structure(ty, components);
        }
        self.struct_place(handle)
    }

    /// A whole value that is no reference.
    pub fn owned(&mut self, handle: Handle<Expression>, is_lanes: bool) -> Text {
        let value = self.value(handle, is_lanes)?;
        if let (true, Some(structure)) = (is_lanes, self.shared_struct(handle)) {
            return Ok(format!("{}(&{value})", types::function_of("splat", structure)));
        }
        Ok(if self.is_reference(handle) { format!("*{value}") } else { value })
    }

    /// The name of the struct that a value is where all lanes share it: a member that they share, or of such
    /// a member one.
    fn shared_struct(&self, handle: Handle<Expression>) -> Option<&str> {
        let ty = self.info[handle].ty.handle()?;
        let is_struct = matches!(self.module.types[ty].inner, TypeInner::Struct { .. });
        let mut at = handle;
        while is_struct && self.named(at).is_none() {
            at = match self.function.expressions[at] {
                Expression::AccessIndex { base, index } => {
                    if types::is_shared_member(self.module, self.program.text, &self.info[base].ty, index) {
                        return self.module.types[ty].name.as_deref();
                    }
                    base
                }
                Expression::Load { pointer } => pointer,
                _ => return None,
            };
        }
        None
    }

    /// A struct made of these members.
    fn structure(&mut self, ty: Handle<naga::Type>, components: &[Handle<Expression>]) -> Text {
        let module = self.module;
        let TypeInner::Struct { members, .. } = &module.types[ty].inner else {
            return Err(Refusal::from("an array made in a stage is not known in lanes".to_owned()));
        };
        let structure = self.type_name(ty, true)?;
        let mut text = format!("{structure} {{ ");
        for (member, component) in members.iter().zip(components) {
            let name = member.name.as_deref().unwrap_or_default();
            let shared = self.program.text.is_shared(&structure, name);
            if shared && !self.is_uniform(*component) {
                return self.refuse(*component, "a member that all lanes share, made of what differs, is");
            }
            let value = self.owned(*component, !shared)?;
            text.push_str(&format!("{name}: {value}, "));
        }
        Ok(text + "}")
    }

    /// Where a struct or an array stands.
    fn struct_place(&mut self, handle: Handle<Expression>) -> Text {
        if let Some(name) = self.named(handle) {
            return Ok(name.to_owned());
        }
        match self.function.expressions[handle] {
            Expression::FunctionArgument(number) => Ok(self.argument_name(number as usize)),
            Expression::Load { pointer } => self.place(pointer),
            Expression::AccessIndex { base, index } => {
                let base_place = self.struct_place(base)?;
                Ok(format!("{base_place}{}", self.step(base, index)))
            }
            Expression::Access { base, index } => self.indexed(base, index),
            _ => self.refuse(handle, "this value of a struct is"),
        }
    }

    fn indexed(&mut self, base: Handle<Expression>, index: Handle<Expression>) -> Text {
        if !self.is_uniform(index) {
            return self.refuse(index, "an index that differs is");
        }
        let base = match self.function.expressions[base] {
            Expression::FunctionArgument(_) | Expression::Load { .. } => self.struct_place(base)?,
            _ => self.place(base)?,
        };
        let index = self.part(index, 0, false)?;
        Ok(format!("{base}[{index} as usize]"))
    }

    /// Returns the target of a pointer.
    pub fn place(&mut self, pointer: Handle<Expression>) -> Text {
        match self.function.expressions[pointer] {
            Expression::LocalVariable(local) => Ok(self.local_name(local)),
            Expression::GlobalVariable(global) => {
                let name = self.module.global_variables[global].name.as_deref().unwrap_or_default();
                Ok(format!("r.{name}"))
            }
            Expression::AccessIndex { base, index } => {
                let place = self.place(base)?;
                Ok(format!("{place}{}", self.step(base, index)))
            }
            Expression::Access { base, index } => self.indexed(base, index),
            _ => self.refuse(pointer, "this pointer is"),
        }
    }

    /// From a value, or a pointer at one, to a part of it.
    fn step(&self, base: Handle<Expression>, index: u32) -> String {
        let types = &self.module.types;
        let inner = match *self.info[base].ty.inner_with(types) {
            TypeInner::Pointer { base, .. } => &types[base].inner,
            ref inner => inner,
        };
        match inner {
            TypeInner::Struct { members, .. } => {
                format!(".{}", members[index as usize].name.as_deref().unwrap_or_default())
            }
            TypeInner::Vector { .. } => format!(".{}", COMPONENTS[index as usize]),
            _ => format!("[{index}]"),
        }
    }

    /// A component of a number or vector, of lanes or single.
    pub fn part(&mut self, handle: Handle<Expression>, at: usize, is_lanes: bool) -> Text {
        let text = self.own_part(handle, at)?;
        match (self.is_uniform(handle), is_lanes, self.vector_of(handle)) {
            (true, true, Some((kind, _))) => Ok(format!("splat{}({text})", kind.suffix())),
            (false, false, _) => self.refuse(handle, "a value that differs where all lanes need the same is"),
            _ => Ok(text),
        }
    }

    /// A component as it is: single where it is the same in all lanes.
    fn own_part(&mut self, handle: Handle<Expression>, at: usize) -> Text {
        let Some((kind, size)) = self.vector_of(handle) else {
            return self.refuse(handle, "a value of this type is");
        };
        let of = |place: String| if size == 1 { place } else { format!("{place}.{}", COMPONENTS[at]) };
        if let Some(name) = self.named(handle) {
            return Ok(of(name.to_owned()));
        }
        let is_lanes = !self.is_uniform(handle);
        let module = self.module;
        match self.function.expressions[handle] {
            Expression::Literal(literal) => self.literal(handle, literal),
            Expression::Constant(constant) => self.constant(handle, module.constants[constant].init, at),
            Expression::ZeroValue(_) => Ok(kind.zero().to_owned()),
            Expression::FunctionArgument(number) => Ok(of(self.argument_name(number as usize))),
            Expression::Compose { ref components, .. } => {
                let mut at = at;
                for &component in components {
                    let size = self.vector_of(component).map_or(1, |(_, size)| size);
                    if at < size {
                        return self.part(component, at, is_lanes);
                    }
                    at -= size;
                }
                self.refuse(handle, "this vector is")
            }
            Expression::Splat { value, .. } => {
                self.atom(value)?;
                self.own_part(value, 0)
            }
            Expression::Swizzle { vector, pattern, .. } => self.own_part(vector, pattern[at] as usize),
            Expression::AccessIndex { base, index } if self.vector_of(base).is_some() => {
                self.own_part(base, index as usize)
            }
            Expression::AccessIndex { base, index } => {
                let place = self.struct_place(base)?;
                Ok(of(format!("{place}{}", self.step(base, index))))
            }
            Expression::Access { base, index } => Ok(of(self.indexed(base, index)?)),
            Expression::Load { pointer } => Ok(of(self.place(pointer)?)),
            Expression::Unary { op, expr } => {
                let operand = self.part(expr, at, is_lanes)?;
                self.known(handle, operation::unary(op, kind, is_lanes, &operand))
            }
            Expression::Binary { op, left, right } => {
                let Some((kind, _)) = self.vector_of(left) else {
                    return self.refuse(handle, "this operation is");
                };
                let left = self.broadcast(left, at, size, is_lanes)?;
                let right = self.broadcast(right, at, size, is_lanes)?;
                let text = if is_lanes {
                    operation::binary_lanes(op, kind, &left, &right)
                } else {
                    operation::binary_single(op, kind, &left, &right)
                };
                self.known(handle, text)
            }
            Expression::Select { condition, accept, reject } => {
                let condition = self.broadcast(condition, at, size, is_lanes)?;
                let (accept, reject) = (self.part(accept, at, is_lanes)?, self.part(reject, at, is_lanes)?);
                Ok(if is_lanes {
                    format!("sel{}({condition}, {accept}, {reject})", kind.suffix())
                } else {
                    format!("(if {condition} {{ {accept} }} else {{ {reject} }})")
                })
            }
            Expression::As { expr, .. } => {
                let Some((from, _)) = self.vector_of(expr) else {
                    return self.refuse(handle, "this conversion is");
                };
                let operand = self.part(expr, at, is_lanes)?;
                let is_small = is_lanes && self.is_small(self.function, expr);
                self.known(handle, operation::convert(from, kind, is_lanes, is_small, &operand))
            }
            Expression::Math { fun, arg, arg1, arg2, .. } => {
                self.math(handle, fun, [Some(arg), arg1, arg2], at)
            }
            _ => self.refuse(handle, "this expression is"),
        }
    }

    /// A component of an operand of something of that size; a number goes with every component.
    fn broadcast(&mut self, handle: Handle<Expression>, at: usize, size: usize, is_lanes: bool) -> Text {
        if size > 1 && self.vector_of(handle).is_some_and(|(_, size)| size == 1) {
            self.atom(handle)?;
            return self.part(handle, 0, is_lanes);
        }
        self.part(handle, at, is_lanes)
    }

    fn known(&self, handle: Handle<Expression>, text: Option<String>) -> Text {
        match text {
            Some(text) => Ok(text),
            None => self.refuse(handle, "this operation is"),
        }
    }

    fn literal(&self, handle: Handle<Expression>, literal: Literal) -> Text {
        match literal {
            Literal::F32(value) if value.is_sign_negative() => Ok(format!("({value:?}f32)")),
            Literal::F32(value) => Ok(format!("{value:?}f32")),
            Literal::I32(value) if value < 0 => Ok(format!("({value}i32)")),
            Literal::I32(value) => Ok(format!("{value}i32")),
            Literal::U32(value) => Ok(format!("{value}u32")),
            Literal::Bool(value) => Ok(value.to_string()),
            _ => self.refuse(handle, "this literal is"),
        }
    }

    /// A component of a constant of the module.
    fn constant(&self, handle: Handle<Expression>, init: Handle<Expression>, at: usize) -> Text {
        match &self.module.global_expressions[init] {
            Expression::Literal(literal) => self.literal(handle, *literal),
            Expression::Constant(constant) => {
                self.constant(handle, self.module.constants[*constant].init, at)
            }
            Expression::Compose { components, .. } if at < components.len() => {
                self.constant(handle, components[at], 0)
            }
            Expression::Splat { value, .. } => self.constant(handle, *value, 0),
            _ => self.refuse(handle, "this constant is"),
        }
    }

    /// Whether a component is a number known here, and no NaN.
    fn is_constant(&self, handle: Handle<Expression>, at: usize) -> bool {
        match self.function.expressions[handle] {
            Expression::Literal(_) | Expression::Constant(_) | Expression::ZeroValue(_) => true,
            Expression::Splat { value, .. } => self.is_constant(value, 0),
            Expression::Compose { ref components, .. } => {
                components.get(at).is_some_and(|component| self.is_constant(*component, 0))
            }
            _ => false,
        }
    }

    /// Whether each component is a float that has been clamped between numbers that fit into an integer, in
    /// that function or in one that it calls.
    fn is_small(&self, function: &naga::Function, handle: Handle<Expression>) -> bool {
        let fits =
            |bound: Option<Handle<Expression>>| bound.is_some_and(|bound| is_small_literal(function, bound));
        match function.expressions[handle] {
            Expression::Math { fun: MathFunction::Clamp, arg1, arg2, .. } => fits(arg1) && fits(arg2),
            Expression::CallResult(callee) => {
                let callee = &self.module.functions[callee];
                let mut are_small = true;
                reach::statements(&callee.body, &mut |statement| {
                    if let naga::Statement::Return { value } = statement {
                        are_small &= value.is_some_and(|value| self.is_small(callee, value));
                    }
                });
                are_small
            }
            _ => false,
        }
    }

    /// A component of what a function of the language gives.
    fn math(
        &mut self,
        handle: Handle<Expression>,
        function: MathFunction,
        [a, b, c]: [Option<Handle<Expression>>; 3],
        at: usize,
    ) -> Text {
        let is_lanes = !self.is_uniform(handle);
        let (Some(a), Some((kind, size))) = (a, a.and_then(|a| self.vector_of(a))) else {
            return self.refuse(handle, "this function is");
        };
        match (function, b, c) {
            (MathFunction::Min, Some(b), _) => self.extreme(handle, "min", a, b, at),
            (MathFunction::Max, Some(b), _) => self.extreme(handle, "max", a, b, at),
            (MathFunction::Clamp, Some(low), Some(high)) => {
                let (x, low_part, high_part) = (
                    self.part(a, at, is_lanes)?,
                    self.part(low, at, is_lanes)?,
                    self.part(high, at, is_lanes)?,
                );
                let is_known = self.is_constant(low, at);
                let raised = operation::extreme("max", kind, is_lanes, &x, &low_part, is_known);
                let raised = self.known(handle, raised)?;
                let is_known = self.is_constant(high, at);
                let text = operation::extreme("min", kind, is_lanes, &raised, &high_part, is_known);
                self.known(handle, text)
            }
            (MathFunction::Mix, Some(b), Some(share)) if kind == Kind::Float => {
                self.atom(share)?;
                let (x, y) = (self.part(a, at, is_lanes)?, self.part(b, at, is_lanes)?);
                let share = self.broadcast(share, at, size, is_lanes)?;
                Ok(if is_lanes {
                    format!("add(mul({x}, sub(splat(1.0f32), {share})), mul({y}, {share}))")
                } else {
                    format!("({x} * (1.0f32 - {share}) + {y} * {share})")
                })
            }
            (MathFunction::Dot, Some(b), _) if kind == Kind::Float => {
                // The translation to single numbers adds to zero, which makes -0 to 0.
                let sum = self.dot(a, b, size, is_lanes)?;
                Ok(if is_lanes { format!("add({sum}, splat(0.0f32))") } else { format!("({sum} + 0.0f32)") })
            }
            (MathFunction::Length, ..) if kind == Kind::Float => {
                self.atom(a)?;
                let squared = self.dot(a, a, size, is_lanes)?;
                Ok(if is_lanes { format!("sqrt({squared})") } else { format!("{squared}.sqrt()") })
            }
            (MathFunction::Cross, Some(b), _) if kind == Kind::Float => {
                self.atom(a)?;
                self.atom(b)?;
                let (next, last) = ((at + 1) % 3, (at + 2) % 3);
                let (a_next, b_last) = (self.part(a, next, is_lanes)?, self.part(b, last, is_lanes)?);
                let (a_last, b_next) = (self.part(a, last, is_lanes)?, self.part(b, next, is_lanes)?);
                Ok(if is_lanes {
                    format!("sub(mul({a_next}, {b_last}), mul({a_last}, {b_next}))")
                } else {
                    format!("({a_next} * {b_last} - {a_last} * {b_next})")
                })
            }
            _ => {
                let x = self.part(a, at, is_lanes)?;
                self.known(handle, operation::math_one(function, kind, is_lanes, &x))
            }
        }
    }

    /// A vector of length 1, all of it: its parts have their length in common.
    fn normalized(&mut self, handle: Handle<Expression>, a: Handle<Expression>) -> Text {
        let (is_lanes, Some((_, size))) = (!self.is_uniform(handle), self.vector_of(a)) else {
            return self.refuse(handle, "this function is");
        };
        self.atom(a)?;
        let squared = self.dot(a, a, size, is_lanes)?;
        let length = self.fresh("length");
        let root = if is_lanes { format!("sqrt({squared})") } else { format!("{squared}.sqrt()") };
        self.line(&format!("let {length} = {root};"));
        let parts = (0..size).map(|at| self.part(a, at, is_lanes)).collect::<Result<Vec<_>, _>>()?;
        let divided = |part: String| {
            if is_lanes { format!("div({part}, {length})") } else { format!("{part} / {length}") }
        };
        Ok(types::made(size, parts.into_iter().map(divided)))
    }

    fn dot(&mut self, a: Handle<Expression>, b: Handle<Expression>, size: usize, is_lanes: bool) -> Text {
        let mut sum = String::new();
        for at in 0..size {
            let (x, y) = (self.part(a, at, is_lanes)?, self.part(b, at, is_lanes)?);
            let product = if is_lanes { format!("mul({x}, {y})") } else { format!("({x} * {y})") };
            sum = match (at, is_lanes) {
                (0, _) => product,
                (_, true) => format!("add({sum}, {product})"),
                (_, false) => format!("({sum} + {product})"),
            };
        }
        Ok(sum)
    }

    /// The smaller or the greater of two. With a number that is known, it stands second, as compilers put it.
    fn extreme(
        &mut self,
        handle: Handle<Expression>,
        name: &str,
        a: Handle<Expression>,
        b: Handle<Expression>,
        at: usize,
    ) -> Text {
        let is_lanes = !self.is_uniform(handle);
        let (a, b) = if self.is_constant(a, at) { (b, a) } else { (a, b) };
        let Some((kind, _)) = self.vector_of(a) else { return self.refuse(handle, "this function is") };
        let is_known = self.is_constant(b, at);
        let (x, y) = (self.part(a, at, is_lanes)?, self.part(b, at, is_lanes)?);
        self.known(handle, operation::extreme(name, kind, is_lanes, &x, &y, is_known))
    }

    /// A texel in each lane.
    fn image_load(
        &mut self,
        handle: Handle<Expression>,
        image: Handle<Expression>,
        coordinate: Handle<Expression>,
        layer: Option<Handle<Expression>>,
        level: Option<Handle<Expression>>,
    ) -> Text {
        let place = self.place(image)?;
        let (x, y) = (self.part(coordinate, 0, true)?, self.part(coordinate, 1, true)?);
        let (Some((Kind::Signed, 2)), Some(level)) = (self.vector_of(coordinate), level) else {
            return self.refuse(handle, "this read of a texture is");
        };
        match layer {
            None if place == "r.height_map" => {
                let is_lanes = !self.is_uniform(level);
                let level = self.part(level, 0, is_lanes)?;
                Ok(if is_lanes {
                    format!("height_texel_of_each(&{place}, ex, {x}, {y}, {level})")
                } else {
                    format!("height_texel(&{place}, {x}, {y}, {level})")
                })
            }
            _ if ["r.color_map", "r.normal_map", "r.material_map"].contains(&place.as_str()) => {
                let is_lanes = !self.is_uniform(level) || layer.is_some_and(|layer| !self.is_uniform(layer));
                let level = self.part(level, 0, is_lanes)?;
                let layer = match layer {
                    Some(layer) => self.part(layer, 0, is_lanes)?,
                    None if is_lanes => "splat_i(0i32)".to_owned(),
                    None => "0i32".to_owned(),
                };
                Ok(if is_lanes {
                    format!("color_texel_of_each(&{place}, ex, {x}, {y}, {layer}, {level})")
                } else {
                    format!("color_texel(&{place}, {x}, {y}, {layer}, {level})")
                })
            }
            Some(layer) if place != "r.hole_map" => {
                if self.is_uniform(layer) && self.is_uniform(level) {
                    let (layer, level) = (self.part(layer, 0, false)?, self.part(level, 0, false)?);
                    return Ok(format!("map_texel(&{place}, {x}, {y}, {layer}, {level})"));
                }
                let (layer, level) = (self.part(layer, 0, true)?, self.part(level, 0, true)?);
                Ok(format!("map_texel_of_each(&{place}, ex, {x}, {y}, {layer}, {level})"))
            }
            _ => self.refuse(handle, "a read of this texture is"),
        }
    }
}

/// Whether an expression is made of literals well within the range of integers.
fn is_small_literal(function: &naga::Function, handle: Handle<Expression>) -> bool {
    match &function.expressions[handle] {
        Expression::Literal(Literal::F32(value)) => value.abs() <= 1_073_741_824.0,
        Expression::Splat { value, .. } => is_small_literal(function, *value),
        Expression::Compose { components, .. } => {
            components.iter().all(|component| is_small_literal(function, *component))
        }
        _ => false,
    }
}
