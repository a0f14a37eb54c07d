use image::{Rgb, RgbImage};

use super::page::{Item, parse};
use super::picture::{encoded, same};
use super::*;

fn commands(text: &str) -> Vec<(usize, String)> {
    let items = parse(Path::new("page.md"), text).items;
    let commands = items.into_iter().filter_map(|item| match item {
        Item::Command { line, words } => Some((line, words.join("|"))),
        Item::File { .. } => None,
    });
    commands.collect()
}

#[test]
fn commands_are_read_with_their_lines() {
    let page = "text `relief no`\n\n```sh\n# why\nrelief render a.png \\\n    -o 'b c.png'  # so\n\n\
                cargo test\n\
                cargo run --release --bin relief -- methods\n```\n```text\nrelief not run\n```\n";
    let expected = [(5, "render|a.png|-o|b c.png".to_owned()), (9, "methods".to_owned())];
    assert_eq!(commands(page), expected);
    assert!(parse(Path::new("page.md"), page).errors.is_empty());
}

#[test]
fn what_cannot_be_run_is_an_error_with_its_line() {
    let page = parse(Path::new("page.md"), "```\nx\n```\n\n```sh\nls\nrelief a > b\nrelief 'a\n```\n");
    let begins = ["page.md:1: a block needs", "page.md:6: only", "page.md:7: '>'", "page.md:8: a quote"];
    assert_eq!(page.errors.len(), begins.len());
    for (error, begin) in page.errors.iter().zip(begins) {
        assert!(error.starts_with(begin), "{error}");
    }
}

#[test]
fn files_pictures_and_rust_are_found() {
    let page = "![a [b]](x.jpg) and ![](y.jpg)\n```toml\n# s.toml\na = 1\n```\n```toml\nb = 1\n```\n```rust\n\
                f();\n```\n";
    let page = parse(Path::new("page.md"), page);
    assert_eq!(page.pictures, [(1, "x.jpg".to_owned()), (1, "y.jpg".to_owned())]);
    let text = "# s.toml\na = 1\n".to_owned();
    assert_eq!(page.items, [Item::File { line: 2, name: "s.toml".to_owned(), text }]);
    assert_eq!(page.rust, [(9, "f();\n".to_owned())]);
}

fn gradient(change: impl Fn(u32, u32) -> i32) -> Vec<u8> {
    let picture = RgbImage::from_fn(64, 52, |x, y| {
        let value = (60 + 2 * x as i32 + change(x, y)).clamp(0, 255) as u8;
        Rgb([value, (y * 3) as u8, 128])
    });
    encoded(&picture).expect("a JPEG")
}

#[test]
fn rounding_is_no_difference_and_a_change_is_one() {
    let there = gradient(|_, _| 0);
    assert_eq!(same(&there, &there), Ok(()));
    assert_eq!(same(&there, &gradient(|x, y| (x * 7 + y * 3) as i32 % 3 - 1)), Ok(()));
    assert_eq!(same(&there, &gradient(|x, y| if (x, y) == (20, 21) { 60 } else { 0 })), Ok(()));
    assert!(same(&there, &gradient(|x, y| if x / 8 == 3 && y / 8 == 2 { 8 } else { 0 })).is_err());
    assert!(same(&there, &gradient(|_, _| 3)).is_err());
    let small = encoded(&RgbImage::new(8, 8)).expect("a JPEG");
    assert!(same(&there, &small).is_err_and(|how| how.contains("8x8")));
    assert!(same(b"none", &there).is_err());
}

#[test]
fn printed_tables_become_a_page() {
    let printed =
        "Searches\n| name   | what |\n|--------|------|\n| linear | a    |\n|        | b    |\n\nNote\n";
    let page = methods::markdown(printed);
    assert!(
        page.ends_with("\n\n## Searches\n\n| name | what |\n| --- | --- |\n| linear | a<br>b |\n\nNote\n"),
        "{page}"
    );
}

#[test]
fn links_are_followed() {
    let text = "[a](b.md#c) and [d](https://e.f)\n```text\n[g](h.md)\n```\n![i](j.jpg)\n";
    assert_eq!(links::links(text), [(1, "b.md#c".to_owned()), (5, "j.jpg".to_owned())]);
    assert_eq!(links::anchor("## A `surface` on a geometry, its own"), "a-surface-on-a-geometry-its-own");
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
    assert_eq!(links::broken(root), Ok(Vec::new()));
}
