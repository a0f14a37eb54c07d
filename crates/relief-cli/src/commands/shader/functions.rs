//! `relief shader --entry functions`: a method as functions, for the fragment shaders of engines.

use clap::{Args, ValueEnum};
use relief_core::Wrap;
use relief_core::registry::UnknownName;
use relief_export::{ExportError, File, Form, FunctionOptions, functions};
use relief_shaders::surface::{Proposal, Shown};
use relief_shaders::{DETAIL, Entry, SHADOW, STAGES, SURFACE, Selection};

use super::{bake_line, choose, of_export};
use crate::failure::Failure;

/// What a file holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Entries {
    /// A vertex and a fragment function that draw a surface
    Program,
    /// Functions that a program's own fragment function calls
    Functions,
}

/// Arguments of functions.
#[derive(Args)]
#[command(next_help_heading = "Functions")]
pub struct Arguments {
    /// What to write. program: a vertex and a fragment function; functions: what an engine's own
    /// fragment function calls
    #[arg(long, value_enum, value_name = "program|functions", default_value = "program")]
    entry: Entries,
    /// Input of functions. tangent: a point of the mesh and the ray's direction, in tangent space;
    /// triangle: a triangle with the space above it and a ray, for shells [default: tangent]
    #[arg(long, value_name = "tangent|triangle")]
    form: Option<Form>,
    /// First word of all names of functions: relief gives relief_hit, ReliefHit, relief_height_map
    /// [default: relief]
    #[arg(long, value_name = "NAME")]
    prefix: Option<String>,
    /// Height map of functions beyond its edges: repeat, clamp or mirror. Fixed, it makes them
    /// smaller [default: a setting]
    #[arg(long, value_name = "NAME")]
    wrap: Option<Wrap>,
    /// More of functions. holes: hits in holes pass, by one more texture; footprint: coarser levels
    /// and flatter relief from afar, by the width of the pixel; folds: shells that overlap
    /// themselves, of triangles
    #[arg(long, value_name = "NAME[,NAME...]", value_delimiter = ',')]
    with: Vec<String>,
}

/// What functions can have besides.
const EXTRAS: [&str; 3] = ["holes", "footprint", "folds"];

impl Arguments {
    /// Whether functions are asked for.
    pub fn are_asked(&self) -> bool {
        self.entry == Entries::Functions
    }

    /// Refuses flags that only functions have.
    pub fn check_unused(&self) -> Result<(), Failure> {
        let given = [
            ("--form", self.form.is_some()),
            ("--prefix", self.prefix.is_some()),
            ("--wrap", self.wrap.is_some()),
            ("--with", !self.with.is_empty()),
        ];
        match given.into_iter().find(|(_, is_given)| *is_given) {
            Some((flag, _)) => {
                Err(Failure::Usage(format!("{flag}: only functions have it: add --entry functions")))
            }
            None => Ok(()),
        }
    }

    fn has(&self, extra: &str) -> bool {
        self.with.iter().any(|name| name == extra)
    }

    fn check(&self) -> Result<(), Failure> {
        match self.with.iter().find(|name| !EXTRAS.contains(&name.as_str())) {
            Some(name) => {
                let error = UnknownName::new("part of functions", name, EXTRAS);
                Err(Failure::Usage(format!("--with: {error}")))
            }
            None => Ok(()),
        }
    }
}

/// The functions' files.
pub fn files(arguments: &super::Arguments) -> Result<Vec<File>, Failure> {
    let own = &arguments.functions;
    own.check()?;
    if arguments.depth {
        let message = "--depth: functions give the depth of each hit, and write none: leave it out";
        return Err(Failure::Usage(message.to_owned()));
    }
    if arguments.ambient.is_some() {
        let message = "--ambient: functions have no lights of their own: leave it out";
        return Err(Failure::Usage(message.to_owned()));
    }
    let selection = selection(arguments)?;
    let defaults = FunctionOptions::default();
    let options = FunctionOptions {
        name: arguments.file_name(),
        form: own.form.unwrap_or_default(),
        prefix: own.prefix.clone().unwrap_or(defaults.prefix),
        wrap: own.wrap,
        holes: own.has("holes"),
        folds: own.has("folds"),
        sampling: arguments.sampling,
        profiles: arguments.profiles()?,
        placement: arguments.placement(),
        bake: Some(bake_line),
    };
    let exported = functions(&selection, &options).map_err(|error| match error {
        // The method brought the surface.
        ExportError::NoFunctions { key, .. } if key == STAGES[SURFACE].key && arguments.surface.is_none() => {
            Failure::Usage(format!("--method: {error}"))
        }
        error => of_export(error),
    });
    Ok(exported?.files)
}

/// The chosen stages: without a shadow unless one is asked for, and on a surface that has functions.
fn selection(arguments: &super::Arguments) -> Result<Selection, Failure> {
    let named =
        |place: usize, is_it: fn(&Entry) -> bool| STAGES[place].first(is_it).map(|(_, entry)| entry.name);
    let detail = named(DETAIL, Entry::flattens).filter(|_| arguments.functions.has("footprint"));
    let mut selection = arguments.selection(named(SHADOW, Entry::is_idle), detail)?;
    if arguments.surface.is_none() && selection.paths().shown == Shown::Relief {
        let shells = |entry: &Entry| entry.paths().proposal == Proposal::Shells;
        // A method for bent meshes keeps its own surface.
        let plainest = STAGES[SURFACE].entries[0].name;
        let other = match arguments.functions.form.unwrap_or_default() {
            Form::Tangent if !Form::Tangent.takes(selection.choices[SURFACE].entry) => {
                named(SURFACE, |entry| Form::Tangent.takes(entry))
            }
            Form::Triangle if selection.choices[SURFACE].entry.name == plainest => named(SURFACE, shells),
            _ => None,
        };
        if let Some(surface) = other {
            choose(&mut selection, SURFACE, surface)?;
        }
    }
    Ok(selection)
}
