//! The `relief` command: everything but its first step is in the library.

use std::process::ExitCode;

/// Keeps graphics drivers from complaining on standard error that there is no desktop, among `--json`'s
/// errors, too: a layer of Mesa's drivers looks for the desktop's GPU when it lists adapters.
#[cfg(target_os = "linux")]
fn quieten_drivers() {
    let desktop = ["XDG_RUNTIME_DIR", "WAYLAND_DISPLAY", "DISPLAY"];
    if desktop.iter().all(|name| std::env::var_os(name).is_none()) {
        // SAFETY: this is the first thing that the program does, so no other thread reads the environment.
        #[allow(unsafe_code)]
        unsafe {
            std::env::set_var("NODEVICE_SELECT", "1");
        }
    }
}

fn main() -> ExitCode {
    #[cfg(target_os = "linux")]
    quieten_drivers();
    relief_cli::run()
}
