//! The text of an export: its size, names of its types, and values of its structs.

use relief_export::ExportedFunctions;

/// Returns the lines and bytes of a text without comments and empty lines.
///
/// # Panics
///
/// When it is no text.
pub fn size_of(exported: &ExportedFunctions) -> [usize; 2] {
    let text = String::from_utf8(exported.files[0].bytes.clone()).expect("a text");
    let code = text.lines().filter(|line| !line.trim().is_empty() && !line.trim().starts_with("//"));
    code.fold([0, 0], |[lines, bytes], line| [lines + 1, bytes + line.len() + 1])
}

/// The WGSL of an export.
pub(super) fn text_of(exported: &ExportedFunctions) -> String {
    String::from_utf8(exported.files[0].bytes.clone()).expect("a text")
}

/// A type's name, with the prefix.
pub(super) fn type_of(exported: &ExportedFunctions, name: &str) -> String {
    let (first, rest) = exported.manifest.prefix.split_at(1);
    format!("{}{rest}{name}", first.to_uppercase())
}

/// A value of a struct, from what stands for each of its members.
pub(super) fn made(text: &str, name: &str, known: &[(&str, &str)]) -> String {
    let declared = text.split(&format!("struct {name} {{\n")).nth(1).expect("a struct");
    let members = declared.lines().take_while(|line| !line.starts_with('}'));
    let members = members.map(str::trim).filter(|line| !line.starts_with("//"));
    let members = members.filter_map(|line| line.split(':').next()).map(|member| {
        let (_, value) = known.iter().find(|(name, _)| *name == member).expect("a known member");
        *value
    });
    format!("{name}({})", members.collect::<Vec<_>>().join(", "))
}
