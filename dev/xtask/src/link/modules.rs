//! The shader sources, and the modules that are written from the host's tables and constants.

use std::collections::BTreeMap;
use std::path::Path;

use wesl::ModulePath;
use wgsl_parse::syntax::PathOrigin;

use super::{bindings, constants, dispatch};

/// Every module by its path below `src`, such as `search/linear`.
pub struct Modules {
    sources: BTreeMap<String, String>,
}

impl Modules {
    /// Reads every `.wesl` file below a folder.
    pub fn read(folder: &Path) -> Result<Self, String> {
        let mut sources = BTreeMap::new();
        collect(folder, "", &mut sources)?;
        sources.insert("constants".to_owned(), constants::module());
        sources.insert("bindings".to_owned(), bindings::module());
        sources.extend(dispatch::modules());
        Ok(Self { sources })
    }

    /// Modules of those names and sources.
    #[cfg(test)]
    pub fn from_sources<const N: usize>(sources: [(&str, &str); N]) -> Self {
        Self { sources: sources.map(|(name, source)| (name.to_owned(), source.to_owned())).into() }
    }

    /// The paths of all modules.
    pub fn paths(&self) -> impl Iterator<Item = &str> {
        self.sources.keys().map(String::as_str)
    }

    /// The source of a module that there is.
    pub fn source(&self, path: &str) -> &str {
        &self.sources[path]
    }

    /// A resolver that knows all modules.
    pub fn resolver(&self) -> wesl::VirtualResolver<'static> {
        let mut resolver = wesl::VirtualResolver::new();
        for (name, source) in &self.sources {
            resolver.add_module(module_path(name), source.clone().into());
        }
        resolver
    }

    /// File and line of the line of a function that reads like `code`, or of the function when no line does.
    pub fn locate(&self, function: &str, code: &str) -> String {
        let head = format!("fn {function}(");
        let bare = |line: &str| line.chars().filter(|c| !c.is_whitespace()).collect::<String>();
        for (name, source) in &self.sources {
            let lines: Vec<&str> = source.lines().collect();
            let Some(start) = lines.iter().position(|line| line.contains(&head)) else { continue };
            let length = lines[start..].iter().position(|line| line.starts_with('}')).unwrap_or(0);
            let wanted = bare(code);
            let within = lines[start..=start + length].iter().position(|line| bare(line).contains(&wanted));
            return format!("{name}.wesl:{}", start + within.unwrap_or(0) + 1);
        }
        format!("function {function}")
    }
}

/// The import path of a module.
pub fn module_path(name: &str) -> ModulePath {
    ModulePath::new(PathOrigin::Absolute, name.split('/').map(str::to_owned).collect())
}

fn collect(folder: &Path, prefix: &str, sources: &mut BTreeMap<String, String>) -> Result<(), String> {
    let said = |error: std::io::Error| format!("{}: {error}", folder.display());
    for entry in std::fs::read_dir(folder).map_err(said)? {
        let path = entry.map_err(said)?.path();
        let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        if path.is_dir() {
            collect(&path, &format!("{prefix}{stem}/"), sources)?;
        } else if path.extension().is_some_and(|extension| extension == "wesl") {
            let source = std::fs::read_to_string(&path).map_err(said)?;
            sources.insert(format!("{prefix}{stem}"), source);
        }
    }
    Ok(())
}
