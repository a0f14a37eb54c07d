//! Functions of exports, compiled by others' compilers in a fragment shader that calls them.

use relief_export::Profile;

use crate::compilers::{GLSLANG, run};

/// Has a text compiled in a fragment shader that calls its functions. `body` makes a number `sum`, with the
/// language's vectors, `vec` or `float`; it finds `settings`.
///
/// # Errors
///
/// When the compiler refuses it: what it says.
///
/// # Panics
///
/// When the compiler is not there, or no folder is writable.
pub fn compiled(text: &str, profile: Profile, body: &dyn Fn(&str) -> String) -> Result<(), String> {
    let head = match profile {
        Profile::Core330 => "#version 330\n",
        Profile::Es300 => "#version 300 es\nprecision highp float;\nprecision highp int;\n",
        Profile::Vulkan450 => "#version 450\n",
        _ => "",
    };
    let folder = tempfile::tempdir().expect("a temporary folder");
    let write =
        |text: &str| std::fs::write(folder.path().join("given.frag"), text).expect("a writable folder");
    match profile {
        Profile::Msl20 => Ok(()),
        Profile::Hlsl51 => {
            write(&format!(
                "{text}\ncbuffer Own : register(b9) {{ ReliefSettings settings; }}\n\
                 float4 main() : SV_Target {{\n    {}    return float4(sum, sum, sum, 1.0);\n}}\n",
                body("float")
            ));
            let flags = ["-D", "-V", "-Od", "-S", "frag", "-e", "main", "-o", "out.spv", "given.frag"];
            run(folder.path(), GLSLANG, flags)
        }
        _ => {
            let vulkan = profile == Profile::Vulkan450;
            let [place, out] =
                if vulkan { ["layout(set = 3, binding = 0) ", "layout(location = 0) "] } else { [""; 2] };
            let block = if vulkan || profile == Profile::Es300 { "layout(std140) " } else { "" };
            let block = if vulkan { place } else { block };
            write(&format!(
                "{head}{text}\n{block}uniform Own {{ ReliefSettings settings; }};\n{out}out vec4 color;\n\
                 void main() {{\n    {}    color = vec4(sum);\n}}\n",
                body("vec")
            ));
            let flags: &[&str] =
                if vulkan { &["-V", "-o", "out.spv", "given.frag"] } else { &["given.frag"] };
            run(folder.path(), GLSLANG, flags)
        }
    }
}
