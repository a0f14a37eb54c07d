//! Packs of files that Godot starts from.

/// The version of the format, and the version of Godot that it says it is from.
const VERSIONS: [u32; 4] = [3, 4, 6, 0];

/// Offsets of files are counted from their beginning.
const RELATIVE: u32 = 2;

/// Bytes before the files.
const HEAD: usize = 112;

/// Files and the directory begin at multiples of this.
const ALIGNED: usize = 16;

/// Packs files of these names below `res://`. The sums of their contents are left empty: Godot reads
/// them only in its editor.
pub fn pack(files: &[(&str, &[u8])]) -> Vec<u8> {
    let mut contents = Vec::new();
    let mut directory = number(files.len()).to_vec();
    for (name, bytes) in files {
        let mut name = name.as_bytes().to_vec();
        name.resize(name.len().next_multiple_of(4), 0);
        directory.extend(number(name.len()));
        directory.extend(&name);
        directory.extend((contents.len() as u64).to_le_bytes());
        directory.extend((bytes.len() as u64).to_le_bytes());
        directory.extend([0; 16]);
        directory.extend(number(0));
        contents.extend(*bytes);
        contents.resize(contents.len().next_multiple_of(ALIGNED), 0);
    }
    let mut packed = b"GDPC".to_vec();
    packed.extend(VERSIONS.into_iter().chain([RELATIVE]).flat_map(u32::to_le_bytes));
    packed.extend((HEAD as u64).to_le_bytes());
    packed.extend(((HEAD + contents.len()) as u64).to_le_bytes());
    packed.resize(HEAD, 0);
    packed.extend(contents);
    packed.extend(directory);
    packed
}

fn number(count: usize) -> [u8; 4] {
    (count as u32).to_le_bytes()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_stand_where_the_directory_says() {
        let packed = pack(&[("a.txt", b"first"), ("longer.txt", b"second")]);
        let at = |place: usize| {
            let bytes: [u8; 8] = packed[place..place + 8].try_into().expect("eight bytes");
            u64::from_le_bytes(bytes) as usize
        };
        let (base, directory) = (at(24), at(32));
        assert_eq!(&packed[base..base + 5], b"first");
        assert_eq!(packed[directory..directory + 4], [2, 0, 0, 0]);
        // The second entry follows the first, which has a name of eight bytes.
        let second = directory + 4 + (4 + 8 + 8 + 8 + 16 + 4);
        assert_eq!(&packed[second + 4..second + 14], b"longer.txt");
        let [offset, length] = [at(second + 16), at(second + 24)];
        assert_eq!(&packed[base + offset..base + offset + length], b"second");
    }
}
