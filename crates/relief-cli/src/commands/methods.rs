//! `relief methods`: prints the registry of methods as tables.

use std::io::{self, Write};

use clap::Args;
use comfy_table::presets::ASCII_MARKDOWN;
use comfy_table::{ContentArrangement, Table};
use relief_core::registry::{Param, Publication, RayClass};
use relief_shaders::{Entry, METHODS, REFINE, SEARCH, STAGES, Selection, Stage};
use serde_json::{Value, json};

use crate::failure::Failure;

/// Arguments of `relief methods`.
#[derive(Args)]
#[command(after_help = "Examples:\n  relief methods\n  relief methods --pairs\n  \
    relief methods --json > methods.json")]
pub struct Arguments {
    /// Print which refinements go with which searches, and the guarantee of each pair
    #[arg(long)]
    pairs: bool,
    /// Print the result as one JSON object
    #[arg(long)]
    pub json: bool,
}

/// Prints the tables.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    match (arguments.pairs, arguments.json) {
        (true, true) => return Ok(writeln!(out, "{:#}", pairs_as_json()?)?),
        (true, false) => return Ok(write!(out, "{}", pairs_text()?)?),
        (false, true) => return Ok(writeln!(out, "{:#}", as_json())?),
        (false, false) => {}
    }
    writeln!(
        out,
        "Methods: pairs of a search and a refinement, displaced triangles, or slices, for --method\n{}\n",
        methods_table()
    )?;
    for stage in &STAGES {
        writeln!(out, "{}", heading(stage))?;
        let mut before = STAGES.iter().take_while(|other| other.key != stage.key);
        match before.find(|other| other.folder == stage.folder) {
            Some(same) => writeln!(out, "The {} above.\n", same.plural)?,
            None => writeln!(out, "{}\n", entries_table(stage.entries))?,
        }
    }
    writeln!(out, "Section: of {}", METHODS[0].publication.paper)?;
    writeln!(out, "Guarantees: for view rays / bent rays / shadow rays")?;
    Ok(())
}

/// Returns the name of a stage's variants, with the flags that choose one and set its parameters.
fn heading(stage: &Stage) -> String {
    let Stage { key, plural, entries, .. } = stage;
    let mut flags = Vec::new();
    if entries.len() > 1 {
        flags.push(match stage.chosen_as {
            None => format!("--{key}"),
            Some(setting) => format!("--set {key}.{setting}=NAME"),
        });
    }
    if entries.iter().any(|entry| !entry.params.is_empty()) {
        flags.push(format!("--set {key}.NAME=VALUE"));
    }
    let mut heading = plural[..1].to_uppercase() + &plural[1..];
    if !flags.is_empty() {
        heading += &format!(", for {}", flags.join(" and "));
    }
    heading
}

fn table(header: &[&str]) -> Table {
    let mut table = Table::new();
    table.load_style(ASCII_MARKDOWN).set_content_arrangement(ContentArrangement::Dynamic).set_header(header);
    table
}

fn methods_table() -> Table {
    let mut table = table(&["method", "family", "geometry", "search", "refinement", "section", "what it is"]);
    for method in METHODS {
        table.add_row([
            method.name,
            method.family().name(),
            method.geometry,
            method.search,
            method.refine,
            section(&method.publication),
            method.summary,
        ]);
    }
    table
}

/// Pair of a search and a refinement, and the reason if it is refused.
struct Pair {
    selection: Selection,
    refused: Option<String>,
}

/// Returns every search with every refinement, in the order of the lists.
fn pairs() -> Result<Vec<Pair>, Failure> {
    let pair = |search: &Entry, refine: &Entry| {
        let selection = Selection::pair(search.name, refine.name).map_err(Failure::work)?;
        Ok(Pair { refused: selection.check_pair().err().map(|error| error.to_string()), selection })
    };
    let [searches, refinements] = [SEARCH, REFINE].map(|stage| STAGES[stage].entries);
    searches.iter().flat_map(|search| refinements.iter().map(move |refine| pair(search, refine))).collect()
}

fn pairs_text() -> Result<String, Failure> {
    let (pairs, refinements) = (pairs()?, STAGES[REFINE].entries);
    let names = refinements.iter().map(|entry| entry.name);
    let mut table = Table::new();
    table.load_style(ASCII_MARKDOWN).set_header(std::iter::once("search").chain(names));
    for row in pairs.chunks(refinements.len()) {
        let cells = row.iter().map(|pair| match pair.refused {
            Some(_) => "no".to_owned(),
            None => RayClass::ALL.map(|rays| &pair.selection.guarantee(rays).name()[..1]).join(" "),
        });
        let search = row.first().map(|pair| pair.selection.search().name.to_owned());
        table.add_row(search.into_iter().chain(cells));
    }
    let mut text = format!(
        "Guarantees of a search and a refinement together for view, bent and shadow rays, with their default \
         settings: e exact, c conservative (never passes a hit, can stop before one), a approximate, i \
         impossible; no for refused pairs.\n\n{table}\n\nReasons for refused pairs:\n\n"
    );
    for reason in pairs.iter().filter_map(|pair| pair.refused.as_ref()) {
        text += &format!("- {reason}\n");
    }
    Ok(text)
}

fn pairs_as_json() -> Result<Value, Failure> {
    let pair = |Pair { selection, refused }: Pair| {
        let promised = |rays| selection.guarantee(rays).name();
        let [view, bent, shadow] = RayClass::ALL.map(promised);
        let promises = refused.is_none().then(|| json!({ "view": view, "bent": bent, "shadow": shadow }));
        let (search, refine) = (selection.search().name, selection.refine().name);
        json!({ "search": search, "refine": refine, "guarantee": promises, "refused": refused })
    };
    Ok(pairs()?.into_iter().map(pair).collect())
}

fn entries_table(entries: &[Entry]) -> Table {
    let mut table = table(&["name", "section", "what it does", "parameters", "guarantees"]);
    for entry in entries {
        let params: Vec<String> = entry.params.iter().map(param_text).collect();
        table.add_row([
            entry.name.to_owned(),
            section(&entry.publication).to_owned(),
            summary(entry),
            params.join("\n"),
            guarantees(entry).join(" / "),
        ]);
    }
    table
}

/// Returns the survey's section, or the paper of what was published elsewhere.
fn section(source: &Publication) -> &'static str {
    if source.section.is_empty() { source.paper } else { source.section }
}

fn summary(entry: &Entry) -> String {
    let maps: Vec<&str> = entry.maps.iter().map(|map| map.kind).collect();
    if maps.is_empty() {
        return entry.summary.to_owned();
    }
    format!("{}; reads the baked map {}", entry.summary, maps.join(", "))
}

fn param_text(param: &Param) -> String {
    let Param { name, summary, min, max, default, names, .. } = param;
    match names.get(*default as usize) {
        Some(default) => format!("{name} = {default} ({}): {summary}", names.join(", ")),
        None => format!("{name} = {default} ({min} to {max}): {summary}"),
    }
}

fn guarantees(entry: &Entry) -> [&'static str; 3] {
    RayClass::ALL.map(|rays| entry.guarantee.of(rays).name())
}

fn as_json() -> Value {
    let source = |source: &Publication| json!({ "paper": source.paper, "section": source.section });
    let methods: Vec<Value> = METHODS
        .iter()
        .map(|method| {
            let settings: serde_json::Map<String, Value> =
                method.settings.iter().map(|&(key, value)| (key.to_owned(), json!(value))).collect();
            json!({
                "name": method.name, "family": method.family().name(),
                "geometry": method.geometry, "search": method.search,
                "refine": method.refine,
                "settings": settings, "summary": method.summary, "source": source(&method.publication),
            })
        })
        .collect();
    let mut all = serde_json::Map::from_iter([("methods".to_owned(), Value::from(methods))]);
    for Stage { title, entries, .. } in &STAGES {
        let listed: Vec<Value> = entries
            .iter()
            .enumerate()
            .map(|(number, entry)| {
                let [view, bent, shadow] = guarantees(entry);
                let maps: Vec<Value> = entry
                    .maps
                    .iter()
                    .map(|map| json!({ "kind": map.kind, "texture": map.texture }))
                    .collect();
                let params: Vec<Value> = entry
                    .params
                    .iter()
                    .map(|param| {
                        json!({
                            "name": param.name, "summary": param.summary,
                            "unit": param.unit, "min": param.min,
                            "max": param.max, "default": param.default, "integer": param.integer,
                            "names": param.names,
                        })
                    })
                    .collect();
                json!({
                    "id": number, "name": entry.name, "summary": entry.summary,
                    "source": source(&entry.publication),
                    "maps": maps, "params": params, "argument": entry.argument,
                    "guarantee": { "view": view, "bent": bent, "shadow": shadow },
                })
            })
            .collect();
        all.insert((*title).to_owned(), Value::from(listed));
    }
    Value::Object(all)
}
