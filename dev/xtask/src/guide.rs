//! Runs the commands of README and of the guide, and makes the pictures that their pages show.
//!
//! A page's commands stand in blocks of `sh`. They run in a scratch folder that holds copies of `data/` and
//! `scenes/`, on the CPU backend, which makes the same pictures on each machine. A block of `toml` that begins
//! with `# NAME.toml` is written to that file. A picture on a page is made by the command whose output has
//! its name, apart from the ending; the page shows it reduced, as a JPEG. The page of methods is made by
//! the same program, so it is written here, too.

use std::path::{Path, PathBuf};
use std::time::Instant;

mod methods;
mod page;
mod picture;
mod run;

use crate::output;
use page::{Item, Page};

/// Where the pages are and what they show.
struct Pages {
    /// Relative to the workspace.
    file: PathBuf,
    /// Width of its pictures in pixels; smaller ones keep their size.
    width: u32,
}

/// Endings of the names of pictures.
const PICTURES: [&str; 3] = ["jpg", "jpeg", "png"];

/// Makes the pictures anew, or with `check` fails where one differs from the committed one. `relief` is the
/// program to run; by default it is built in the profile of this program.
///
/// # Errors
///
/// Lists each command that fails, each picture that differs or that no command makes, each block that
/// cannot be run, with page and line.
pub fn settle(root: &Path, relief: Option<&Path>, check: bool) -> Result<(), String> {
    let begun = Instant::now();
    let relief = match relief {
        Some(path) => std::path::absolute(path).map_err(|error| format!("{}: {error}", path.display()))?,
        None => run::build()?,
    };
    let mut errors = Vec::new();
    let (mut commands, mut shown) = (Vec::new(), Vec::new());
    for pages in pages(root)? {
        let text = read_text(&root.join(&pages.file))?;
        let page = page::parse(&pages.file, &text);
        errors.extend(page.errors.iter().cloned());
        errors.extend(unknown_rust(root, &page)?);
        let scratch = run::Scratch::new(root)?;
        for item in &page.items {
            match item {
                Item::File { name, text, .. } => scratch.write(name, text)?,
                Item::Command { line, words } => {
                    let started = Instant::now();
                    if let Err(message) = scratch.run(&relief, words) {
                        errors.push(format!("{}:{line}: {message}", page.file.display()));
                    }
                    commands.push((started.elapsed(), format!("{}:{line}", page.file.display())));
                }
            }
        }
        for (line, path) in &page.pictures {
            let file = pages.file.with_file_name("").join(path);
            let settled = picture(&scratch, &root.join(&file), pages.width, check);
            errors.extend(settled.err().map(|message| format!("{}:{line}: {message}", page.file.display())));
            shown.push(file);
        }
    }
    errors.extend(strays(root, &shown)?);
    errors.extend(output::settle(root, &[methods::page(&relief)?], check).err());
    if !errors.is_empty() {
        return Err(errors.join("\nxtask: "));
    }
    let seconds = begun.elapsed().as_secs_f64();
    println!("{} commands, {} pictures, {seconds:.1} s; the slowest:", commands.len(), shown.len());
    commands.sort();
    for (time, place) in commands.iter().rev().take(3) {
        println!("{:6.1} s  {place}", time.as_secs_f64());
    }
    Ok(())
}

/// README and all pages of the guide, in the order of their names.
fn pages(root: &Path) -> Result<Vec<Pages>, String> {
    let mut all = vec![Pages { file: "README.md".into(), width: 800 }];
    let names = names(&root.join("docs/guide"))?.into_iter().filter(|name| name.ends_with(".md"));
    all.extend(names.map(|name| Pages { file: Path::new("docs/guide").join(name), width: 480 }));
    Ok(all)
}

/// Names of the files in a folder, sorted.
fn names(folder: &Path) -> Result<Vec<String>, String> {
    let entries = std::fs::read_dir(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let mut names: Vec<String> =
        entries.flatten().map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    Ok(names)
}

fn read_text(file: &Path) -> Result<String, String> {
    std::fs::read_to_string(file).map_err(|error| format!("{}: {error}", file.display()))
}

/// Writes a page's picture from the one in the scratch folder, or compares it with the committed one.
fn picture(scratch: &run::Scratch, file: &Path, width: u32, check: bool) -> Result<(), String> {
    let name = file.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let stem = file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    if file.extension().is_none_or(|ending| ending != "jpg") {
        return Err(format!(
            "{name}: the page's pictures are JPEGs, whatever the command writes: {stem}.jpg"
        ));
    }
    let made = PICTURES.iter().map(|ending| scratch.path(&format!("{stem}.{ending}")));
    let Some(made) = made.into_iter().find(|path| path.exists()) else {
        return Err(format!("{name}: no command of this page makes {stem}.png or {stem}.jpg"));
    };
    let made = picture::shown(&made, width)?;
    if check {
        let there =
            std::fs::read(file).map_err(|error| format!("{name}: {error}; run `cargo xtask guide`"))?;
        return picture::same(&there, &made).map_err(|how| format!("{name} {how}; run `cargo xtask guide`"));
    }
    // A picture that is the same but for rounding is not written again.
    if std::fs::read(file).is_ok_and(|there| picture::same(&there, &made).is_ok()) {
        return Ok(());
    }
    std::fs::write(file, &made).map_err(|error| format!("{}: {error}", file.display()))?;
    println!("wrote {}", file.display());
    Ok(())
}

/// An error for each picture beside the guide's pages that none of them shows.
fn strays(root: &Path, shown: &[PathBuf]) -> Result<Vec<String>, String> {
    let folder = Path::new("docs/guide");
    let files = names(&root.join(folder))?.into_iter().map(|name| folder.join(name));
    let pictures = files.filter(|file| !file.extension().is_some_and(|ending| ending == "md"));
    let unshown = pictures.filter(|file| !shown.contains(file));
    Ok(unshown.map(|file| format!("{}: no page of the guide shows it", file.display())).collect())
}

/// An error for each block of Rust that stands in no example of the facade, where it would be compiled.
fn unknown_rust(root: &Path, page: &Page) -> Result<Vec<String>, String> {
    if page.rust.is_empty() {
        return Ok(Vec::new());
    }
    let folder = root.join("crates/relief/examples");
    let trimmed = |text: &str| text.lines().map(str::trim).collect::<Vec<_>>().join("\n");
    let mut examples = Vec::new();
    for name in names(&folder)? {
        examples.push(trimmed(&read_text(&folder.join(name))?));
    }
    let unknown = page.rust.iter().filter(|(_, text)| {
        let text = trimmed(text);
        !examples.iter().any(|example| example.contains(text.trim()))
    });
    let message = "this Rust stands in no file of crates/relief/examples, so nothing compiles it";
    Ok(unknown.map(|(line, _)| format!("{}:{line}: {message}", page.file.display())).collect())
}

#[cfg(test)]
mod tests;
