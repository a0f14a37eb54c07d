//! Includes for Unreal: HLSL whose functions are methods of a struct, compiled by somebody else's compiler.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use relief_export::unreal_input;

use crate::compilers::{GLSLANG, SPIRV_OPT, SPIRV_VAL, run};

/// The file of the kit that lies between a Custom node and functions.
const SURFACE: &str = include_str!("../../../../crates/relief-cli/engines/unreal/relief_surface.ush");

/// The struct that holds textures and functions, and a value of it in compute passes.
const OWNER: [&str; 2] = ["Relief", "relief"];

/// An include with functions.
pub struct Include {
    text: String,
    methods: BTreeSet<String>,
    /// Types and names of textures, in the order of their bindings.
    textures: Vec<(String, String)>,
}

impl Include {
    /// Reads the text of an include.
    ///
    /// # Panics
    ///
    /// When there is no struct in it.
    pub fn new(text: &str) -> Self {
        let (_, members) = text.split_once(&format!("\nstruct {}\n{{\n", OWNER[0])).expect("a struct");
        let members = members.lines().filter(|line| line.starts_with("    ") && !line.starts_with("     "));
        let member = |line: &str| {
            let (of, name) = line.trim().strip_suffix(';')?.split_once(' ')?;
            of.starts_with("Texture").then(|| (of.to_owned(), name.to_owned()))
        };
        let method = |line: &str| {
            let (head, _) = line.split_once('(').filter(|_| !line.ends_with(';'))?;
            let (_, name) = head.rsplit_once(' ').filter(|_| !line.trim_start().starts_with('/'))?;
            Some(name.to_owned())
        };
        let textures = members.clone().filter_map(member).collect();
        Self { text: text.to_owned(), methods: members.filter_map(method).collect(), textures }
    }

    /// The names of all methods.
    pub fn methods(&self) -> &BTreeSet<String> {
        &self.methods
    }

    /// The text as glslang 12 compiles it: it is safe with calls of methods whose struct is named.
    fn named(&self) -> String {
        let line = |line: &str| match line.starts_with("        ") {
            true => self.calls(line, "this."),
            false => line.to_owned(),
        };
        self.text.lines().map(|of| line(of) + "\n").collect()
    }

    /// A text with an owner before each call of a method.
    fn calls(&self, text: &str, owner: &str) -> String {
        let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let mut owned = String::with_capacity(2 * text.len());
        let mut rest = text;
        while let Some(start) = rest.find(is_part) {
            let (before, from) = rest.split_at(start);
            let (word, after) = from.split_at(from.find(|c| !is_part(c)).unwrap_or(from.len()));
            let is_call = after.starts_with('(') && !before.ends_with('.') && self.methods.contains(word);
            owned += before;
            owned += if is_call { owner } else { "" };
            owned += word;
            rest = after;
        }
        owned + rest
    }

    /// The include with textures that a compute pass binds, without methods that take derivatives; and a body
    /// of statements that calls methods.
    pub(super) fn in_compute(&self, body: &str) -> [String; 2] {
        let [of, value] = OWNER;
        let named = self.named();
        let mut text: String =
            named.split_inclusive("\n    }\n").filter(|method| !method.contains("ddx(")).collect();
        let mut filled = format!("{of} {value};\n");
        for (place, (of, name)) in self.textures.iter().enumerate() {
            let _ = writeln!(text, "{of} given_{name} : register(t{place});");
            let _ = writeln!(filled, "    {value}.{name} = given_{name};");
        }
        [text, format!("{filled}    {}", self.calls(body, &format!("{value}.")))]
    }

    /// A fragment shader with a function as Unreal makes it of a Custom node with this code. `shown` makes
    /// four numbers of what the node gives.
    pub fn in_node(&self, code: &str, scale: f32, shown: &str) -> String {
        let mut text = format!("{}{SURFACE}", self.named());
        let [mut inputs, mut given] = [String::new(), String::new()];
        for (place, (of, name)) in self.textures.iter().enumerate() {
            let input = unreal_input(name);
            let sampler = place + self.textures.len();
            let _ = writeln!(text, "{of} Given{input} : register(t{place});");
            let _ = writeln!(text, "SamplerState Given{input}Sampler : register(s{sampler});");
            inputs += &format!(", {} {input}, SamplerState {input}Sampler", of.replace("<float4>", ""));
            given += &format!(", Given{input}, Given{input}Sampler");
        }
        text + &format!(
            "float3 CustomExpression0(float2 UV, float3 Way, float3 Normal, float PixelDepth, float Scale, \
             float3 Sun{inputs}, inout float Mask, inout float2 HitUV, inout float DepthOffset, \
             inout float Light)\n{{\n{code}\n}}\n\
             float4 main(float2 uv : TEXCOORD0, float3 way : TEXCOORD1, float3 normal : TEXCOORD2, \
             float depth : TEXCOORD3, float3 sun : TEXCOORD4) : SV_Target\n{{\n    \
             float mask = 0.0;\n    float2 at = float2(0.0, 0.0);\n    float offset = 0.0;\n    \
             float light = 1.0;\n    \
             float3 bent = CustomExpression0(uv, way, normal, depth, {scale:?}, sun{given}, mask, at, \
             offset, light);\n    return {shown};\n}}\n"
        )
    }
}

/// Compiles HLSL that has textures in structs: the bytes of valid SPIR-V.
///
/// # Errors
///
/// When a compiler refuses it: what it says.
///
/// # Panics
///
/// When a compiler is not there, or no folder is writable.
pub fn compiled(text: &str, stage: &str) -> Result<Vec<u8>, String> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    std::fs::write(folder.path().join("given"), text).expect("the folder is writable");
    let flags = ["-D", "-V", "-Od", "-S", stage, "-e", "main", "-o", "copied.spv", "given"];
    run(folder.path(), GLSLANG, flags)?;
    run(folder.path(), SPIRV_OPT, ["--legalize-hlsl", "copied.spv", "-o", "out.spv"])?;
    run(folder.path(), SPIRV_VAL, ["out.spv"])?;
    Ok(std::fs::read(folder.path().join("out.spv")).expect("it was compiled"))
}
