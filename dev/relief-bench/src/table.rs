//! Tables as documents have them.

use comfy_table::Table;
use comfy_table::presets::ASCII_MARKDOWN;

/// An empty table with these columns.
pub fn table(header: &[&str]) -> Table {
    let mut table = Table::new();
    table.load_style(ASCII_MARKDOWN).set_header(header.iter().copied());
    table
}
