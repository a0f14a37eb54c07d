//! How a height map is to be read: the flags that commands share.

use clap::Args;
use relief_io::RawLayout;

/// How the height map's file is read.
#[derive(Args)]
#[command(next_help_heading = "Reading the height map")]
pub struct FileArguments {
    /// Channel that holds the height: r, g, b, a, y, or an EXR channel's name [default: the only one, or the grey]
    #[arg(long, value_name = "NAME")]
    pub channel: Option<String>,
    /// Size and byte order of a headerless 16-bit file, as in 403x344,le
    #[arg(long, value_name = "WxH,le|be")]
    pub raw: Option<RawLayout>,
    /// Fill texels without a value (nodata, NaN, infinite) from their surroundings [default: they are an error]
    #[arg(long)]
    pub fill: bool,
}
