use super::{Kept, reduce};
use crate::functions::syntax::{parse, print};

/// A text reduced to what its function `main` needs.
fn reduced(text: &str) -> String {
    let mut unit = parse(text).expect("a shader");
    reduce(&mut unit, &Kept { functions: &["main"], structs: &["In"], whole: &["Out"] });
    print(&unit)
}

#[test]
fn known_choices_go_in_their_places() {
    let text = "const CLAMP = 1u;\nfn main(x: f32) -> f32 {\n    return wrapped(x, 0u);\n}\n\
                fn wrapped(x: f32, wrap: u32) -> f32 {\n    if (wrap == CLAMP) {\n        \
                return clamp(x, 0.0, 1.0);\n    }\n    \
                let part = x - floor(x);\n    return select(part, 0.0, wrap == 2u);\n}\n";
    // What is left is short and called once.
    assert_eq!(reduced(text), "fn main(x: f32) -> f32 {\n    return x - floor(x);\n}\n");
}

#[test]
fn members_that_nothing_reads_go_away_with_what_makes_them() {
    let text = "struct Hit { t: f32, cost: u32, kind: u32 }\n\
                fn main(x: f32) -> f32 {\n    let hit = found(x);\n    if (hit.kind == 3u) {\n        \
                return 0.0;\n    }\n    \
                return hit.t;\n}\n\
                fn found(x: f32) -> Hit {\n    var cost = 0u;\n    var t = x;\n    \
                while (t < 1.0) {\n        \
                cost = cost + 1u;\n        t = t + x;\n    }\n    return Hit(t, cost, 2u);\n}\n";
    let reduced = reduced(text);
    assert!(!reduced.contains("cost") && !reduced.contains("kind") && reduced.contains("while (t < 1.0)"));
}

#[test]
fn floats_are_neither_computed_nor_moved() {
    let text = "const LEAST = 0.001;\nfn main(x: f32) -> f32 {\n    \
                return (0.0 - x) * (1.0 + 0.0) + (x + 0.5 - 0.5) + LEAST * 2.0;\n}\n";
    assert_eq!(
        reduced(text),
        "const LEAST = 0.001;\n\nfn main(x: f32) -> f32 {\n    \
         return (0.0 - x) * (1.0 + 0.0) + (x + 0.5 - 0.5) + LEAST * 2.0;\n}\n"
    );
}

#[test]
fn what_is_read_later_in_a_loop_stays() {
    let text = "fn main(x: f32) -> f32 {\n    var last = x;\n    var sum = 0.0;\n    var k = 0u;\n    \
                while (k < 4u) {\n        \
                sum = sum + last;\n        last = sum;\n        k = k + 1u;\n    }\n    return sum;\n}\n";
    assert_eq!(reduced(text), text);
}

#[test]
fn an_assignment_that_nothing_reads_goes_away() {
    let text = "fn main(x: f32) -> f32 {\n    var gap = x;\n    if (gap < 0.0) {\n        return 0.0;\n    \
                }\n    \
                var k = 0.0;\n    while (k < x) {\n        k = k + 1.0;\n        gap = k;\n    }\n    \
                return k;\n}\n";
    let reduced = reduced(text);
    assert!(reduced.contains("if (x < 0.0)") && !reduced.contains("gap"), "{reduced}");
}

#[test]
fn names_of_inner_blocks_do_not_meet_others() {
    let text = "fn main(x: f32) -> f32 {\n    let y = x + 1.0;\n    var sum = y;\n    if (true) {\n        \
                let y = x * x;\n        \
                sum = sum + y;\n    }\n    return sum;\n}\n";
    let reduced = reduced(text);
    assert!(reduced.contains("    {\n        let y = x * x;"), "{reduced}");
    // The same with a name of its own.
    let other = text.replace("let y = x * x", "let z = x * x").replace("sum + y;\n    }", "sum + z;\n    }");
    assert!(self::reduced(&other).contains("    let z = x * x;\n    sum = sum + z;"));
}

#[test]
fn what_goes_in_may_lose_members_and_what_comes_out_may_not() {
    let text = "struct In { a: f32, b: f32 }\nstruct Out { a: f32, b: f32 }\n\
                fn main(at: In) -> Out {\n    return Out(at.a, 1.0);\n}\n";
    let reduced = reduced(text);
    assert!(
        reduced.contains("struct In {\n    a: f32,\n}") && reduced.contains("Out(at.a, 1.0)"),
        "{reduced}"
    );
}
