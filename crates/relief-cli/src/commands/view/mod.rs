//! `relief view`: a scene to look at and to change, on a page in a browser, or by a script without one.

mod answer;
mod door;
mod dropped;
mod given;
mod http;
mod page;
mod said;
mod saved;
mod script;
mod serve;
mod viewer;

use std::path::PathBuf;

use clap::Args;
use relief_scene::{SceneSpec, Shown};

use super::render::CacheArguments;
use super::scene_arguments::{MachineArguments, SceneArguments};
use crate::failure::Failure;
use crate::streams::Files;

/// Arguments of `relief view`.
#[derive(Args)]
#[command(
    after_help = "Examples:\n  relief view wall.png                           # a page in the browser\n  \
    relief view scene.toml --method relief,cone    # two methods side by side\n  \
    relief view wall.png --method relief --show picture,error   # where it is wrong, and by how much\n  \
    relief view wall.png --no-open --port 8000     # prints the address of the page\n  \
    relief view wall.png --script actions.json -o out\n  \
    relief view scene.toml --script actions.json --json      # what each action changes\n\n\
    The page is for this machine alone: its address holds a secret. Drop files onto it: height maps, meshes, \
    textures, scenes. Ctrl-C ends it.\n\n\
    A script is a list of actions in JSON:\n  \
    [\n    { \"do\": \"set\", \"key\": \"method\", \"value\": \"cone\" },\n    \
    { \"do\": \"frame\" },\n    \
    { \"do\": \"orbit\", \"degrees\": [30, 10] },\n    \
    { \"do\": \"picture\", \"file\": \"turned.png\" },\n    { \"do\": \"undo\" }\n  ]\n\n\
    set gives a key of a scene file a value, and lose takes it away: scale, set.search.steps, \
    surfaces[1].color.\n\
    orbit turns the eye, turn-light the light, by degrees to the right and up. pan moves the picture by \
    heights of it to the right and up. zoom has a factor: 2 is twice as large. frame shows all from the \
    present direction, fit as the view does; look-at brings a point (point, in metres) to the middle. \
    keep-second takes the method of the second view and closes it. add-surface, remove-surface (number, from \
    0 on), undo, redo, reset. picture draws what the scene is then. Actions in a row with the same \"drag\", \
    a whole number, are undone together."
)]
pub struct Arguments {
    /// Script of actions, in JSON: no page is opened
    #[arg(long, value_name = "FILE.json")]
    script: Option<PathBuf>,
    /// Folder for the scene and the pictures of a script, created if missing [default: nothing is written]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Port of the page [default: a free one]
    #[arg(long, value_name = "N", conflicts_with = "script")]
    port: Option<u16>,
    #[arg(long, value_name = "NAME[,NAME]", value_delimiter = ',', help = show_help())]
    show: Vec<Shown>,
    /// Open no browser
    #[arg(long, conflicts_with = "script")]
    no_open: bool,
    /// Print the result as one JSON object: the keys that each action changed, or the address of the page
    #[arg(long)]
    pub json: bool,

    #[command(flatten)]
    scene: SceneArguments,
    #[command(flatten)]
    machine: MachineArguments,
    #[command(flatten)]
    cache: CacheArguments,
}

impl Arguments {
    /// Returns the files that may be standard input.
    pub fn files(&mut self) -> Files<'_> {
        let Self { script, scene, .. } = self;
        Files { read: scene.files().into_iter().chain(script).collect(), ..Files::default() }
    }
}

fn show_help() -> String {
    let each: Vec<String> =
        Shown::ALL.into_iter().map(|shown| format!("{} ({})", shown.name(), shown.about())).collect();
    format!(
        "What the page shows; a second name shows two views side by side, as two names after --method do: {} \
         [default: picture]",
        each.join("; ")
    )
}

impl Arguments {
    /// Returns the scene's description, with what its views show.
    fn spec(&self) -> Result<SceneSpec, Failure> {
        let mut spec = self.machine.over(self.scene.spec()?);
        for surface in spec.surfaces.iter_mut().chain([&mut spec.surface]) {
            let Some(names) = surface.method.clone() else { continue };
            let Some((first, second)) = names.split_once(',') else { continue };
            if second.contains(',') {
                return Err(Failure::usage("--method: a page shows one method, or two side by side"));
            }
            surface.method = Some(first.to_owned());
            spec.viewer.second = Some(second.to_owned());
        }
        match self.show[..] {
            [] => {}
            [first] => spec.viewer.show = Some(first),
            [first, second] => {
                (spec.viewer.show, spec.viewer.second_show) = (Some(first), Some(second));
            }
            _ => return Err(Failure::usage("--show: a page shows one view, or two side by side")),
        }
        Ok(spec)
    }
}

/// Applies a script, or opens the page.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    match (&arguments.script, &arguments.output) {
        (Some(script), _) => script::run(arguments, script),
        // Another flag that excludes a script would hide this from the reader of the command line.
        (None, Some(_)) => {
            Err(Failure::usage("--output: is of a script: give --script as well, or save from the page"))
        }
        (None, None) => serve::run(arguments),
    }
}
