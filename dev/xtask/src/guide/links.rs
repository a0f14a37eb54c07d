//! Links between the pages of the repository: each leads to a file and a heading that exist.

use std::path::{Component, Path, PathBuf};

use super::{names, read_text};

/// Folders whose pages are checked.
const FOLDERS: [&str; 6] = ["", "data", "docs", "docs/guide", "docs/measurements", "docs/notes"];

/// An error for each link to a file of the repository that does not exist, or to a heading that its page
/// does not have. The changelog is left out, since its entries name files of their time.
pub fn broken(root: &Path) -> Result<Vec<String>, String> {
    let mut errors = Vec::new();
    for folder in FOLDERS {
        let pages = names(&root.join(folder))?;
        for name in pages.iter().filter(|name| name.ends_with(".md") && *name != "CHANGELOG.md") {
            let page = Path::new(folder).join(name);
            for (line, link) in links(&read_text(&root.join(&page))?) {
                if let Err(message) = follow(root, &page, &link) {
                    errors.push(format!("{}:{line}: the link '{link}' {message}", page.display()));
                }
            }
        }
    }
    Ok(errors)
}

/// Line and target of each link outside of blocks of code; other sites are left out.
pub fn links(text: &str) -> Vec<(usize, String)> {
    let mut is_code = false;
    let mut links = Vec::new();
    for (at, line) in text.lines().enumerate() {
        is_code ^= line.trim_start().starts_with("```");
        let targets = line.split("](").skip(1).filter_map(|part| part.split_once(')'));
        let targets = targets.map(|(target, _)| target).filter(|target| !target.contains("://"));
        links.extend(targets.filter(|_| !is_code).map(|target| (at + 1, target.to_owned())));
    }
    links
}

fn follow(root: &Path, page: &Path, link: &str) -> Result<(), String> {
    let (file, heading) = link.split_once('#').map_or((link, None), |(file, heading)| (file, Some(heading)));
    let target = if file.is_empty() { page.to_owned() } else { normal(&page.with_file_name(file)) };
    if !root.join(&target).exists() {
        return Err(format!("leads to no file: there is no {}", target.display()));
    }
    let Some(heading) = heading else { return Ok(()) };
    let text = read_text(&root.join(&target))?;
    let mut headings = text.lines().filter(|line| line.starts_with('#')).map(anchor);
    if headings.any(|anchor| anchor == heading) {
        return Ok(());
    }
    Err(format!("leads to no heading: {} has none of that name", target.display()))
}

/// A path without `..`.
fn normal(path: &Path) -> PathBuf {
    let mut whole = PathBuf::new();
    for part in path.components() {
        match part {
            Component::ParentDir => {
                whole.pop();
            }
            _ => whole.push(part),
        }
    }
    whole
}

/// The name by which a heading is linked.
pub fn anchor(heading: &str) -> String {
    let kept = heading.trim_start_matches('#').trim().to_lowercase();
    let kept = kept.chars().filter(|letter| letter.is_alphanumeric() || " -_".contains(*letter));
    kept.map(|letter| if letter == ' ' { '-' } else { letter }).collect()
}
