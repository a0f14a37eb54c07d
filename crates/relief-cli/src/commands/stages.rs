//! Flags for the stages with more than one variant, from the shaders' table of stages.

use std::collections::BTreeMap;

use clap::error::ErrorKind;
use clap::{Arg, ArgMatches, Args, Command, Error, FromArgMatches};
use relief_shaders::{AMBIENT, DETAIL, GEOMETRY, REFINE, SEARCH, SHADOW, SHADOW_SEARCH, STAGES, Stage};

use crate::values;

/// Variants that are asked for, by their stages' keys.
#[derive(Clone, Debug, Default)]
pub struct StageArguments(BTreeMap<String, String>);

/// Returns the stages whose choice has a flag of its own, with their places.
fn choosable() -> impl Iterator<Item = (usize, &'static Stage)> {
    STAGES.iter().enumerate().filter(|(_, stage)| stage.entries.len() > 1 && stage.has_key())
}

fn help(place: usize, stage: &Stage) -> String {
    let title = stage.title[..1].to_uppercase() + &stage.title[1..];
    // A method names these two; one of them alone leaves the other open.
    let other = match place {
        SEARCH => Some(STAGES[REFINE].key),
        REFINE => Some(STAGES[SEARCH].key),
        _ => None,
    };
    if place == SHADOW_SEARCH {
        let of = STAGES[SEARCH].key;
        return format!(
            "Search for shadow rays, one of --{of} [default: the view's search where it can, else cells]"
        );
    }
    match other {
        Some(other) => format!("{title}, together with --{other} instead of --method"),
        None => {
            let names: Vec<&str> = stage.entries.iter().map(|entry| entry.name).collect();
            let default = match place {
                DETAIL => "footprint with several samples where the search can, else none",
                AMBIENT => "the look's; environment with --environment or --transmission",
                GEOMETRY => "the method's, else none",
                SHADOW => "ray; map with displaced triangles, and with several surfaces unless --look plain",
                _ => names[0],
            };
            let or_color = match place {
                AMBIENT => ", or R,G,B for a constant colour",
                _ => "",
            };
            format!("{title}: {}{or_color} [default: {default}]", names.join(", "))
        }
    }
}

/// Reads the name of an ambient light; a text with a comma is a colour.
fn name_or_color(text: &str) -> Result<String, String> {
    if text.contains(',') {
        values::point(text)?;
    }
    Ok(text.to_owned())
}

impl StageArguments {
    /// Returns the variants, and the colour that is given in place of an ambient light's name.
    pub fn and_color(&self) -> (BTreeMap<String, String>, Option<[f64; 3]>) {
        let (mut stages, ambient) = (self.0.clone(), &STAGES[AMBIENT]);
        let color = stages.get(ambient.key).and_then(|text| values::point(text).ok());
        if color.is_some() {
            stages.insert(ambient.key.to_owned(), ambient.entries[0].name.to_owned());
        }
        (stages, color)
    }
}

impl Args for StageArguments {
    fn augment_args(command: Command) -> Command {
        choosable().fold(command, |command, (place, stage)| {
            let argument = Arg::new(stage.key).long(stage.key).help(help(place, stage));
            command.arg(if place == AMBIENT {
                let argument = argument.value_name("NAME|R,G,B").help_heading("Camera and light");
                argument.value_parser(name_or_color).allow_hyphen_values(true)
            } else {
                argument.value_name("NAME").help_heading("Method")
            })
        })
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for StageArguments {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, Error> {
        let mut asked = BTreeMap::new();
        for (_, stage) in choosable() {
            let name = matches.try_get_one::<String>(stage.key);
            let name = name.map_err(|error| Error::raw(ErrorKind::InvalidValue, error.to_string()))?;
            asked.extend(name.map(|name| (stage.key.to_owned(), name.clone())));
        }
        Ok(Self(asked))
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}
