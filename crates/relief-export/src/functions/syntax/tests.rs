use relief_shaders::Selection;
use relief_shaders::wgsl::{Parts, Root, Sampling};

use super::{ItemKind, parse, print};

#[test]
fn what_is_written_is_read_as_the_same() {
    for method in ["relief", "cone", "quadtree", "shell-map", "view-dependent-svd"] {
        let mut selection = Selection::method(method).expect("a method");
        selection.choose("surface", "plane").expect("a surface");
        for sampling in Sampling::ALL {
            let text = Parts::new(&selection, Root::Functions, sampling).code();
            let unit = parse(&text).expect("our own shaders");
            assert!(unit.functions().count() > 20 && unit.structs().count() > 5);
            assert_eq!(parse(&print(&unit)).as_ref(), Ok(&unit), "{method}, {sampling}");
        }
    }
}

#[test]
fn comments_stay_with_what_they_describe() {
    let text =
        "// A heading.\n\n// Twice.\nfn twice(x: f32) -> f32 {\n    // Not thrice.\n    return x * 2.0;\n}\n";
    let unit = parse(text).expect("a function");
    assert_eq!(unit.items[0].kind, ItemKind::Heading);
    assert_eq!(
        (unit.items[0].comment.as_slice(), unit.items[1].comment.as_slice()),
        (&["A heading.".to_owned()][..], &["Twice.".to_owned()][..],)
    );
    assert_eq!(print(&unit), text);
}

#[test]
fn precedence_is_kept() {
    for expression in ["a - (b - c)", "(a + b) * c", "a && (b || c)", "-a.x + b[2].y", "!(a < b) == c"] {
        let text = format!("fn of() -> f32 {{\n    return {expression};\n}}\n");
        assert_eq!(print(&parse(&text).expect("an expression")), text);
    }
}

#[test]
fn long_lines_are_broken() {
    let sum = ["quite_a_long_name"; 12].join(" + ");
    let text = format!("fn of() -> f32 {{ return other({sum}, {sum}); }}\n");
    let printed = print(&parse(&text).expect("a call"));
    assert!(printed.lines().count() > 4 && printed.lines().all(|line| line.len() <= 110), "{printed}");
    assert_eq!(
        parse(&printed),
        parse(&text).map(|mut unit| {
            unit.items[0].comment.clear();
            unit
        })
    );
}

#[test]
fn what_is_no_shader_is_refused_with_its_line() {
    let error = parse("fn of() -> f32 {\n    return 1.0\n}\n").expect_err("no semicolon");
    assert!(error.contains("line 3") && error.contains("';'"), "{error}");
    assert!(parse("struct {").is_err() && parse("what").is_err() && parse("fn f() -> f32 { #").is_err());
}
