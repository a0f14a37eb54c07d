//! The compilers and validators of shaders that tests run: `glslangValidator`, and `spirv-val` and
//! `spirv-opt`, which Debian has in `glslang-tools` and `spirv-tools`.

use std::ffi::OsStr;
use std::path::Path;
use std::process::Command;

/// Compiler of GLSL and HLSL.
pub const GLSLANG: &str = "glslangValidator";

/// Validator of SPIR-V.
pub const SPIRV_VAL: &str = "spirv-val";

/// Optimiser of SPIR-V, which makes valid SPIR-V of HLSL that copies textures.
pub const SPIRV_OPT: &str = "spirv-opt";

/// Whether all are there. Where one is not the test says that it skips, unless the environment variable
/// `RELIEF_REQUIRE_COMPILERS` is 1.
///
/// # Panics
///
/// When they are required and one is missing.
pub fn are_there() -> bool {
    let missing = [GLSLANG, SPIRV_VAL, SPIRV_OPT]
        .iter()
        .find(|tool| Command::new(tool).arg("--version").output().is_err());
    let Some(tool) = missing else { return true };
    let is_required = std::env::var_os("RELIEF_REQUIRE_COMPILERS").is_some_and(|value| value == "1");
    assert!(!is_required, "RELIEF_REQUIRE_COMPILERS is 1: there is no {tool}");
    println!("skipped: there is no {tool}");
    false
}

/// Runs a tool in a folder.
///
/// # Errors
///
/// When it does not succeed: what it says.
///
/// # Panics
///
/// When it is not there.
pub fn run<A: AsRef<OsStr>>(
    folder: &Path,
    tool: &str,
    arguments: impl IntoIterator<Item = A>,
) -> Result<(), String> {
    let output = Command::new(tool).args(arguments).current_dir(folder).output().expect("the tool is there");
    if output.status.success() {
        return Ok(());
    }
    let said = [output.stdout, output.stderr].concat();
    Err(format!("{tool}: {}", String::from_utf8_lossy(&said)))
}
