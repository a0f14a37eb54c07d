//! What the compared methods are: a sentence for each, and a drawing of its way to a hit.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use maud::{Markup, html};
use relief_shaders::{REFINE, SEARCH, STAGES, method};

use crate::columns::Row;
use crate::record::MethodRecord;
use crate::run::Compared;

/// Returns the list of the methods, in the order in which they were compared.
pub fn methods(compared: &Compared) -> Markup {
    let Compared { records, drawings, .. } = compared;
    let mut known: Vec<&MethodRecord> = Vec::new();
    for of in Row::all(records).map(|row| row.method()) {
        if !known.iter().any(|other| other.method == of.method) {
            known.push(of);
        }
    }
    html! {
        @if !known.is_empty() {
            h2 { "The methods" }
            dl.methods { @for of in known {
                dt { (of.method) }
                dd {
                    (sentence(of))
                    @for drawing in drawings.iter().filter(|drawing| drawing.method == of.method) {
                        details {
                            summary { "How it finds a hit" }
                            img class="drawing"
                                alt=(format!("A cut along a ray, with the turns of {}", of.method))
                                src=(format!("data:image/svg+xml;base64,{}", STANDARD.encode(&drawing.svg)));
                            p { code { "relief explain" } " draws it along any ray, turn by turn." }
                        }
                    }
                }
            } }
        }
    }
}

/// Describes a method in a sentence: by the table of methods, or by its search and its refinement.
pub fn sentence(of: &MethodRecord) -> String {
    if let Ok(known) = method(&of.method) {
        return capital(known.summary) + ".";
    }
    let summary = |stage: usize, name: &str| {
        let entry = STAGES[stage].first(|entry| entry.name == name);
        entry.map_or(String::new(), |(_, entry)| entry.summary.to_owned())
    };
    let [search, refine] = [summary(SEARCH, &of.search), summary(REFINE, &of.refine)];
    format!("Search: {search}. Refinement: {refine}.")
}

fn capital(text: &str) -> String {
    let mut rest = text.chars();
    rest.next().map_or(String::new(), |first| first.to_uppercase().chain(rest).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contender::Contender;

    #[test]
    fn every_method_has_a_sentence() {
        for contender in Contender::all() {
            let of = MethodRecord { method: contender.name, ..MethodRecord::default() };
            let text = sentence(&of);
            assert!(text.len() > 12 && text.ends_with('.') && !text.starts_with("Search"), "{text}");
        }
        let names = ["linear+true-secant", "linear", "true-secant"].map(str::to_owned);
        let [method, search, refine] = names;
        let pair = sentence(&MethodRecord { method, search, refine, ..MethodRecord::default() });
        assert!(pair.starts_with("Search: ") && !pair.contains(": ."), "{pair}");
    }
}
