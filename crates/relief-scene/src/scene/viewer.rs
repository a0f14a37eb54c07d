//! What a viewer shows of a scene: the table `[viewer]` of a scene file, which pictures do not depend on.

use relief_shaders::{METHODS, method};
use serde::Deserialize;
use std::ops::Bound;

use super::error::{ValueError, ValueProblem};
use super::key_groups::KeyGroup;
use super::keys::parsed;
use super::{Form, Key, KeyNumber, SceneSpec, Shown, SurfaceSpec};

/// Key of the table.
pub(super) const VIEWER: &str = "viewer";

/// What a viewer shows of a scene: one view, or two side by side. A value that is `None` has a default.
///
/// There are two views if [`second`](Self::second) or [`second_show`](Self::second_show) is given.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct ViewerSpec {
    /// What the view shows. Default: the picture.
    #[serde(deserialize_with = "parsed")]
    pub show: Option<Shown>,
    /// Method of the second view. Default: the scene's own.
    pub second: Option<String>,
    /// What the second view shows. Default: what the first one shows.
    #[serde(deserialize_with = "parsed")]
    pub second_show: Option<Shown>,
    /// Place of the divider between the views, from 0, at the left, to 1. Default: 0.5.
    pub divider: Option<f64>,
    /// Whether the second view is at the left. Default: false.
    pub swapped: Option<bool>,
}

/// Default place of the divider.
pub const DEFAULT_DIVIDER: f64 = 0.5;

impl ViewerSpec {
    /// Returns what each view shows: one view, or two.
    pub fn views(&self) -> Vec<Shown> {
        let first = self.show.unwrap_or_default();
        match self.second.is_some() || self.second_show.is_some() {
            true => vec![first, self.second_show.unwrap_or(first)],
            false => vec![first],
        }
    }

    /// Returns this description with the values of `over` in place of its own.
    #[must_use]
    pub fn overridden_by(self, over: Self) -> Self {
        Self {
            show: over.show.or(self.show),
            second: over.second.or(self.second),
            second_show: over.second_show.or(self.second_show),
            divider: over.divider.or(self.divider),
            swapped: over.swapped.or(self.swapped),
        }
    }

    pub(super) fn check(&self) -> Result<(), ValueError> {
        if let Some(Err(unknown)) = self.second.as_deref().map(method) {
            return Err(ValueProblem::UnknownName(Box::new(unknown)).of("viewer.second"));
        }
        match self.divider {
            Some(value) if !(0.0..=1.0).contains(&value) => {
                Err(ValueProblem::Number { value, must: "from 0 to 1" }.of("viewer.divider"))
            }
            _ => Ok(()),
        }
    }

    /// Returns the values as TOML, by key.
    pub(super) fn values(&self) -> Vec<(&'static str, String)> {
        let quoted = |text: &str| toml::Value::String(text.to_owned()).to_string();
        let values = [
            ("show", self.show.map(|shown| quoted(shown.name()))),
            ("second", self.second.as_deref().map(quoted)),
            ("second-show", self.second_show.map(|shown| quoted(shown.name()))),
            ("divider", self.divider.map(|place| format!("{place:?}"))),
            ("swapped", self.swapped.map(|flag| flag.to_string())),
        ];
        values.into_iter().filter_map(|(key, value)| Some((key, value?))).collect()
    }
}

impl SceneSpec {
    /// Returns this description with a method on every surface, in place of each one's own.
    #[must_use]
    pub fn by_method(&self, name: &str) -> SceneSpec {
        let over = SurfaceSpec { method: Some(name.to_owned()), ..SurfaceSpec::default() };
        self.clone().overridden_by(SceneSpec::of_surface(over))
    }

    /// Returns why a viewer cannot show something of the scene, as far as its values tell without its files.
    pub fn why_not_shown(&self, shown: Shown) -> Option<&'static str> {
        let is_of_hits = matches!(shown, Shown::Error | Shown::Passed);
        (is_of_hits && self.surfaces.len() > 1).then_some(
            "surfaces of a scene hide each other, so the exact hit of each is not known: \
             show color-error or flip",
        )
    }

    /// Returns what each view of a viewer shows, and the scene that it shows it of.
    pub fn views(&self) -> Vec<(Shown, SceneSpec)> {
        let second =
            || self.viewer.second.as_deref().map_or_else(|| self.clone(), |name| self.by_method(name));
        let each = self.viewer.views().into_iter().enumerate();
        each.map(|(place, shown)| (shown, if place == 0 { self.clone() } else { second() })).collect()
    }
}

/// Returns the keys of the table `[viewer]`, as actions name them.
pub fn viewer_keys() -> Vec<Key> {
    let key = |rank, name, form, default, about, number| Key {
        name,
        of_surface: false,
        group: KeyGroup::Views,
        rank,
        form,
        default,
        about,
        number,
    };
    let shown = || Form::Name(Shown::ALL.map(Shown::name).to_vec());
    let methods = METHODS.iter().map(|method| method.name).collect();
    let divider = KeyNumber { unit: "", range: (Bound::Included(0.0), Bound::Included(1.0)), step: 0.05 };
    vec![
        key(0, "viewer.show", shown(), "\"picture\"", "what the view shows", None),
        key(1, "viewer.second", Form::Name(methods), "", "method of a second view beside it", None),
        key(
            2,
            "viewer.second-show",
            shown(),
            "",
            "what the second view shows (default: what the first one shows)",
            None,
        ),
        key(
            3,
            "viewer.divider",
            Form::Number,
            "0.5",
            "place of the divider between two views, from 0 (left) to 1",
            Some(divider),
        ),
        key(4, "viewer.swapped", Form::Flag, "false", "whether the second view is at the left", None),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse_scene;
    use crate::scene::keys::keys_of;
    use std::path::Path;

    fn read(text: &str) -> Result<SceneSpec, String> {
        parse_scene(text, Path::new("scene.toml")).map_err(|error| error.to_string())
    }

    #[test]
    fn every_key_of_the_table_is_listed_with_a_default_that_holds() {
        let listed: Vec<String> =
            viewer_keys().iter().map(|key| key.name.trim_start_matches("viewer.").to_owned()).collect();
        assert_eq!(listed, keys_of::<ViewerSpec>());
        for key in viewer_keys().iter().filter(|key| !key.default.is_empty()) {
            let spec = read(&format!("{} = {}", key.name, key.default)).expect("a default");
            assert_eq!(spec.viewer.views(), [Shown::Picture], "{}", key.name);
        }
        let spec = read("viewer.divider = 0.5").expect("a divider");
        assert_eq!(spec.viewer.divider, Some(DEFAULT_DIVIDER));
    }

    #[test]
    fn a_second_view_has_its_own_method_and_quantity() {
        let views = |text: &str| {
            let of = |(shown, spec): (Shown, SceneSpec)| (shown, spec.surface.method.unwrap_or_default());
            read(text).expect("a scene").views().into_iter().map(of).collect::<Vec<_>>()
        };
        let own = "method = \"relief\"\nset.search.steps = 3\n";
        let relief = |shown| (shown, "relief".to_owned());
        let cone = |shown| (shown, "cone".to_owned());
        assert_eq!(views(own), [relief(Shown::Picture)]);
        assert_eq!(
            views(&format!("{own}viewer.show = \"error\"\nviewer.second = \"cone\"")),
            [relief(Shown::Error), cone(Shown::Error)]
        );
        let same = views(&format!("{own}viewer.second-show = \"flip\""));
        assert_eq!(same, [relief(Shown::Picture), relief(Shown::Flip)]);
        let settings = read(&format!("{own}viewer.second = \"cone\"")).expect("a scene").views();
        assert_eq!(settings.iter().map(|(_, spec)| spec.surface.set.len()).collect::<Vec<_>>(), [1, 0]);
    }

    #[test]
    fn errors_of_hits_are_not_shown_of_several_surfaces() {
        let one = read("method = \"relief\"").expect("a scene");
        let two = read("[[surfaces]]\n[[surfaces]]\n").expect("a scene");
        for shown in Shown::ALL {
            let is_of_hits = [Shown::Error, Shown::Passed].contains(&shown);
            assert_eq!(two.why_not_shown(shown).is_some(), is_of_hits, "{shown}");
            assert_eq!(one.why_not_shown(shown), None, "{shown}");
        }
    }

    #[test]
    fn values_that_no_viewer_can_show_are_refused() {
        for (text, said) in [
            ("viewer.show = \"eror\"", "'error'"),
            ("viewer.second = \"relif\"", "'relief'"),
            ("viewer.second = \"linear+binary\"", "method"),
            ("viewer.divider = 1.5", "from 0 to 1"),
            ("viewer.third = 1", "third"),
        ] {
            let error = read(text).expect_err("refused");
            assert!(error.contains(said), "{text}: {error}");
        }
    }
}
