//! Runs the commands of README and of the guide, and makes the pictures that their pages show.
//!
//! A page's commands stand in blocks of `sh`. They run in a scratch folder that holds copies of `data/`
//! and `scenes/`, on the CPU backend, which makes the same pictures on each machine. A block of `toml`
//! that begins with `# NAME.toml` is written to that file. A picture on a page is made by the command
//! whose output has its name, apart from the ending; the page shows it reduced, as a JPEG. Drawings are
//! shown as SVG. The page of methods is made by the same program, so it is written here, too. All links
//! between pages are followed.

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

mod drawing;
mod links;
mod methods;
mod page;
mod picture;
pub mod run;

use crate::output;
use page::{Item, Page};

/// Endings of the names of pictures.
const PICTURES: [&str; 3] = ["jpg", "jpeg", "png"];

/// A file of Markdown, relative to the workspace, and the width of its pictures in pixels. Smaller pictures
/// keep their size.
struct Source {
    file: PathBuf,
    width: u32,
}

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
    let mut guide =
        Guide { root, relief: &relief, check, times: Vec::new(), shown: Vec::new(), errors: Vec::new() };
    for source in sources(root)? {
        guide.settle_page(&source)?;
    }
    guide.errors.extend(strays(root, &guide.shown)?);
    guide.errors.extend(links::broken(root)?);
    guide.errors.extend(output::settle(root, &[methods::page(&relief)?], check).err());
    guide.summary(begun.elapsed())
}

/// A run over all pages.
struct Guide<'a> {
    root: &'a Path,
    relief: &'a Path,
    check: bool,
    /// Time and place of each command.
    times: Vec<(Duration, String)>,
    /// The pictures of the pages so far, relative to the workspace.
    shown: Vec<PathBuf>,
    /// What is wrong, with page and line.
    errors: Vec<String>,
}

impl Guide<'_> {
    /// Runs a page's commands and settles its pictures.
    fn settle_page(&mut self, source: &Source) -> Result<(), String> {
        let page = page::parse(&source.file, &read_text(&self.root.join(&source.file))?);
        self.errors.extend(page.errors.iter().cloned());
        self.errors.extend(unknown_rust(self.root, &page)?);
        let scratch = run::Scratch::new(self.root)?;
        for item in &page.items {
            match item {
                Item::File { name, text, .. } => scratch.write(name, text)?,
                Item::Command { line, words } => {
                    let started = Instant::now();
                    let ran = scratch.run(self.relief, words);
                    self.times.push((started.elapsed(), page.place(*line)));
                    self.errors.extend(ran.err().map(|message| format!("{}: {message}", page.place(*line))));
                }
            }
        }
        for (line, path) in &page.pictures {
            let file = source.file.with_file_name("").join(path);
            let settled = picture(&scratch, &self.root.join(&file), source.width, self.check);
            self.errors.extend(settled.err().map(|message| format!("{}: {message}", page.place(*line))));
            self.shown.push(file);
        }
        Ok(())
    }

    /// Fails with all errors, or says how many commands ran, how long it took and which were the slowest.
    fn summary(mut self, elapsed: Duration) -> Result<(), String> {
        if !self.errors.is_empty() {
            return Err(self.errors.join("\nxtask: "));
        }
        let [commands, pictures] = [self.times.len(), self.shown.len()];
        println!("{commands} commands, {pictures} pictures, {:.1} s; the slowest:", elapsed.as_secs_f64());
        self.times.sort();
        for (time, place) in self.times.iter().rev().take(3) {
            println!("{:6.1} s  {place}", time.as_secs_f64());
        }
        Ok(())
    }
}

/// README and all pages of the guide, in the order of their names.
fn sources(root: &Path) -> Result<Vec<Source>, String> {
    let mut all = vec![Source { file: "README.md".into(), width: 800 }];
    let names = names(&root.join("docs/guide"))?.into_iter().filter(|name| name.ends_with(".md"));
    all.extend(names.map(|name| Source { file: Path::new("docs/guide").join(name), width: 480 }));
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
    if file.extension().is_some_and(|ending| ending == "svg") {
        let made = std::fs::read(scratch.path(&name));
        let made = made.map_err(|_| format!("{name}: no command of this page makes it"))?;
        return settled(file, &name, &made, check, drawing::same);
    }
    if file.extension().is_none_or(|ending| ending != "jpg") {
        return Err(format!(
            "{name}: the page's pictures are JPEGs, whatever the command writes: {stem}.jpg; drawings are SVG"
        ));
    }
    let made = PICTURES.iter().map(|ending| scratch.path(&format!("{stem}.{ending}")));
    let Some(made) = made.into_iter().find(|path| path.exists()) else {
        return Err(format!("{name}: no command of this page makes {stem}.png or {stem}.jpg"));
    };
    settled(file, &name, &picture::shown(&made, width)?, check, picture::same)
}

/// How two files differ beyond rounding.
type Same = fn(&[u8], &[u8]) -> Result<(), String>;

/// Writes a file, or compares it with the committed one.
fn settled(file: &Path, name: &str, made: &[u8], check: bool, same: Same) -> Result<(), String> {
    if check {
        let there =
            std::fs::read(file).map_err(|error| format!("{name}: {error}; run `cargo xtask guide`"))?;
        return same(&there, made).map_err(|how| format!("{name} {how}; run `cargo xtask guide`"));
    }
    // A picture that is the same but for rounding is not written again.
    if std::fs::read(file).is_ok_and(|there| same(&there, made).is_ok()) {
        return Ok(());
    }
    std::fs::write(file, made).map_err(|error| format!("{}: {error}", file.display()))?;
    println!("wrote {}", file.display());
    Ok(())
}

/// An error for each picture beside the guide's pages that none of them shows.
fn strays(root: &Path, shown: &[PathBuf]) -> Result<Vec<String>, String> {
    let folder = Path::new("docs/guide");
    let files = names(&root.join(folder))?.into_iter().map(|name| folder.join(name));
    let pictures = files.filter(|file| file.extension().is_none_or(|ending| ending != "md"));
    let unshown = pictures.filter(|file| !shown.contains(file));
    Ok(unshown.map(|file| format!("{}: no page of the guide shows it", file.display())).collect())
}

/// An error for each block of Rust that stands in no example of the facade, where it would be compiled. A
/// line `// ...` stands for lines that the page leaves out.
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
        let parts: Vec<&str> = text.split("// ...").map(str::trim).collect();
        !examples.iter().any(|example| parts.iter().all(|part| example.contains(part)))
    });
    let message = "this Rust stands in no file of crates/relief/examples, so nothing compiles it";
    Ok(unknown.map(|(line, _)| format!("{}: {message}", page.place(*line))).collect())
}

#[cfg(test)]
mod tests;
