//! Program `relief`. Everything but its first step is in the library.

use std::process::ExitCode;

/// Keeps graphics drivers from complaining about a missing desktop on standard error, which would
/// also mix with the errors of `--json`. A layer of Mesa looks for the desktop's GPU when it lists
/// adapters.
#[cfg(target_os = "linux")]
fn quieten_drivers() {
    let desktop = ["XDG_RUNTIME_DIR", "WAYLAND_DISPLAY", "DISPLAY"];
    if desktop.iter().all(|name| std::env::var_os(name).is_none()) {
        // SAFETY: this is the first thing that the program does, so no other thread reads the
        // environment.
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
