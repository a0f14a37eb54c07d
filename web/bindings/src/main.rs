//! Writes the JavaScript side of a module, as the command `wasm-bindgen` does.
//!
//! `relief-web-bindings MODULE.wasm FOLDER`: the folder gets `relief_web.js`, `relief_web_bg.wasm` and the
//! types of both. This is a program of its own because the library is large: neither tests nor the command
//! should wait for it.

use std::process::ExitCode;

use wasm_bindgen_cli_support::Bindgen;

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [module, folder] = &words[..] else {
        eprintln!("usage: relief-web-bindings MODULE.wasm FOLDER");
        return ExitCode::from(2);
    };
    let written = Bindgen::new().input_path(module).web(true).and_then(|bindgen| {
        bindgen.typescript(true).remove_name_section(true).remove_producers_section(true).generate(folder)
    });
    match written {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{module}: the JavaScript side cannot be written: {error:#}");
            ExitCode::FAILURE
        }
    }
}
