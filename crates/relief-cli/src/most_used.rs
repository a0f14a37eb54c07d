//! Order of flags in help: the most used ones come first.

use clap::Command;

/// Most used flags of the commands with many flags, by the names of their arguments.
const MOST_USED: [(&str, &[&str]); 6] = [
    ("render", &["output", "height", "mesh", "color", "method", "scale", "size", "view", "light", "shadow"]),
    (
        "mesh",
        &["output", "error", "triangles", "texels", "mesh", "scale", "print_size", "solid", "tiles", "view"],
    ),
    ("bake", &["kind", "engine", "output", "format", "set", "scale", "tile_size", "wrap", "fill", "force"]),
    (
        "capture",
        &["output", "views", "grid", "size", "cover", "bits", "color", "verify", "json", "max_memory"],
    ),
    (
        "compare",
        &["output", "height", "methods", "steps", "budget_ms", "max_error", "size", "quick", "csv", "json"],
    ),
    (
        "bench",
        &["height", "methods", "frames", "warm", "size", "backend", "sampling", "scale", "mesh", "json"],
    ),
];

/// Heading of the other flags that have no heading of their own.
const OTHERS: &str = "More options";

/// Returns `command` with help that begins with the most used flags.
pub fn first(mut command: Command) -> Command {
    for (name, most_used) in MOST_USED {
        command = command.mut_subcommand(name, |command| {
            let command = command.mut_args(|argument| match argument.get_help_heading() {
                None if !argument.is_positional() => argument.help_heading(OTHERS),
                _ => argument,
            });
            most_used.iter().enumerate().fold(command, |command, (place, id)| {
                command.mut_arg(id, |argument| {
                    argument.help_heading(None::<&str>).display_order(place).hide_short_help(false)
                })
            })
        });
    }
    command
}
