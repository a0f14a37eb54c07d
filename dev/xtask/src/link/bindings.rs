//! The module of bindings, written from the host's table.

use relief_shaders::bindings::{BINDINGS, BindingKind};

/// The module's source.
pub fn module() -> String {
    let mut text = String::from(
        "import package::shared::records::{Face, Probe, Record, ShellNode};\n\
         import package::shared::settings::{Frame, PassSettings, PointSettings, PyramidPass};\n\
         import package::shared::settings::{ScreenSettings, SurfaceSettings};\n\
         import package::shared::types::{Corner, Hit, Path, PixelIn};\n\n",
    );
    for binding in &BINDINGS {
        if binding.kind == BindingKind::Sampler {
            text += "@if(fast) ";
        }
        text += &binding.declaration();
        text.push('\n');
    }
    text
}
