//! three.js of npm in Chromium without a window, drawn by SwiftShader.

use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

/// Version of the package of npm, and what three.js itself calls it.
pub const VERSION: &str = "0.187.0";
const REVISION: &str = "187";

/// How long a page may work before its answer is read, in milliseconds of its own clock.
const PAGE_MS: &str = "--virtual-time-budget=600000";

const PACKAGE: [(&str, &str); 2] = [
    ("package.json", include_str!("package.json")),
    ("package-lock.json", include_str!("package-lock.json")),
];

/// Installs three.js into a folder.
pub fn install(folder: &Path) -> Result<(), String> {
    for (name, text) in PACKAGE {
        std::fs::write(folder.join(name), text).map_err(|error| format!("{name}: {error}"))?;
    }
    let mut npm = Command::new("npm");
    npm.args(["ci", "--ignore-scripts", "--no-audit", "--no-fund"]).current_dir(folder);
    output(&mut npm, "install Node.js with npm").map(drop)
}

/// Runs a page. `script` is a module that exports by default a function from the input to a text, or to a
/// promise of one. Returns that text.
pub fn answer(chromium: &Path, script: &str, mut input: Value) -> Result<String, String> {
    input["revision"] = REVISION.into();
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let input = format!("export default {input};\n");
    let page = include_str!("page.html");
    for (name, text) in [("page.html", page), ("page.js", script), ("input.js", input.as_str())] {
        std::fs::write(folder.path().join(name), text).map_err(|error| format!("{name}: {error}"))?;
    }
    install(folder.path())?;
    let mut browser = Command::new(chromium);
    browser
        .args(["--headless", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"])
        .args(["--allow-file-access-from-files", PAGE_MS, "--dump-dom"])
        .arg(format!("--user-data-dir={}", folder.path().join("profile").display()))
        .arg(format!("file://{}", folder.path().join("page.html").display()));
    let page = output(&mut browser, "install Chromium, or give it by --chromium")?.stdout;
    let page = String::from_utf8_lossy(&page);
    let answer =
        page.split_once("<pre id=\"answer\" hidden=\"\">").and_then(|(_, rest)| rest.split_once("</pre>"));
    let answer = answer.ok_or("the page has no answer")?.0;
    match answer.strip_prefix("error: ") {
        Some(error) => Err(format!("three.js: {error}")),
        None => Ok(answer.to_owned()),
    }
}

/// Runs a command to its end.
fn output(command: &mut Command, advice: &str) -> Result<Output, String> {
    let name = command.get_program().to_string_lossy().into_owned();
    let output = command.output().map_err(|error| format!("{name} cannot be run ({error}): {advice}"))?;
    if output.status.success() {
        return Ok(output);
    }
    Err(format!("{name} failed: {}", String::from_utf8_lossy(&output.stderr).trim()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_version_is_the_one_that_is_locked() {
        let [package, lock] = PACKAGE.map(|(_, text)| text);
        assert!(package.contains(&format!("\"three\": \"{VERSION}\"")));
        assert!(lock.contains(&format!("\"version\": \"{VERSION}\"")));
        assert_eq!(VERSION.split('.').nth(1), Some(REVISION));
    }
}
