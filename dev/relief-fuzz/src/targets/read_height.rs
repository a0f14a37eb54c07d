use relief_io::{Convention, Fill, HeightOptions, HeightRange, Source, inspect, read_height};

use super::{MAX_BYTES, with_choice};
use crate::Target;
use crate::common::broken::valid_files;

/// Any bytes as a height map's file: an error or a valid map, never more memory than allowed.
pub const READ_HEIGHT: Target = Target { name: "read_height", run, make };

/// The layout of files without a header.
const RAW: &str = "37x29,be";

fn options(choice: u8) -> HeightOptions {
    let channel = [None, Some("r"), Some("a"), Some("single")][usize::from(choice & 3)];
    let mut options = HeightOptions {
        channel: channel.map(str::to_owned),
        fill: if choice & 4 == 0 { Fill::Always } else { Fill::Never },
        max_bytes: MAX_BYTES,
        ..HeightOptions::default()
    };
    match choice >> 3 {
        1 => options.nodata = Some(-9999.0),
        2 => options.range = Some(HeightRange::Extremes),
        3 => options.convention = Some(Convention::Depth),
        4 => options.raw = RAW.parse().ok(),
        _ => {}
    }
    options
}

fn run(bytes: &[u8]) -> bool {
    let Some((&choice, bytes)) = bytes.split_first() else { return false };
    let (source, options) = (Source::bytes("a", bytes), options(choice));
    let _ = inspect(source, &options);
    let Ok(map) = read_height(source, &options) else { return false };
    assert!(map.texels().iter().all(|texel| (0.0..=1.0).contains(texel)));
    true
}

fn make() -> Vec<Vec<u8>> {
    let choice = |name: &str, count: usize| match name {
        "raw" => 4 << 3,
        name if name.ends_with("exr") => 3,
        _ => (count as u8 % 4) << 3,
    };
    let files = valid_files().into_iter().enumerate();
    files.map(|(count, file)| with_choice(choice(&file.name, count), &file.bytes)).collect()
}
