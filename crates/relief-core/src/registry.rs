//! Parts of registry entries for stages and map kinds: parameters, sources, guarantees, baked maps,
//! and the error for unknown names.

/// Parameters of an entry that its shader gets, in one vector.
pub const SHADER_PARAMS: usize = 4;

/// Most parameters of an entry. Beyond the first [`SHADER_PARAMS`] they choose baked maps alone.
pub const MAX_PARAMS: usize = 6;

/// A baked map that a stage reads: one texture of a map kind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MapInput {
    /// Name of the map kind.
    pub kind: &'static str,
    /// Name of the texture, for kinds with several; empty for the only one.
    pub texture: &'static str,
    /// Settings of the kind that the stage needs. The other settings keep their defaults.
    pub settings: &'static [(&'static str, MapSetting)],
    /// Metric in which the map is baked.
    pub metric: MapMetric,
    /// Levels of the map.
    pub levels: MapLevels,
    /// Most texels on the longer side of the mip level that the map is baked from. The finest such
    /// level of the height map is used. `None`: the height map itself.
    pub side: Option<MapSetting>,
}

/// The value of a kind's setting that a stage needs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MapSetting {
    /// A constant.
    Fixed(f32),
    /// Value of the stage's own parameter of this name.
    Param(&'static str),
    /// Value for rendering in the finest level of detail only, and value for a map that serves all
    /// levels.
    Levels(f32, f32),
    /// Columns (0), rows (1) or slices (2) of the volume that is shown; 0 without one.
    Volume(usize),
}

/// Metric in which a map for a stage is baked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MapMetric {
    /// Texture units and heights as they are. The map does not depend on the tile's size and the
    /// scale in metres.
    Texture,
    /// Metres on the surface that carries the map.
    Scene,
}

/// Mip levels of a map for a stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MapLevels {
    /// Finest level of the kind's texture.
    One,
    /// Levels of the kind's texture from this one on. Each is padded, to the right and below, to
    /// half the size of the previous one, as in GPU textures: kinds round sizes up, textures round
    /// down.
    ChainFrom(u32),
    /// All levels of the kind's texture, each a mean over areas. They have the sizes of the
    /// height map's mip levels from this one on.
    MeansFrom(u32),
    /// Finest level of the kind's texture for each mip [level](crate::HeightMap::level) of the
    /// height map, baked from the heights of that level.
    EachDetail,
}

impl MapInput {
    /// The finest level of a kind's texture, with default settings, in texture units.
    pub const fn new(kind: &'static str, texture: &'static str) -> Self {
        Self { kind, texture, settings: &[], metric: MapMetric::Texture, levels: MapLevels::One, side: None }
    }

    /// Sets the settings of the kind.
    #[must_use]
    pub const fn with(self, settings: &'static [(&'static str, MapSetting)]) -> Self {
        Self { settings, ..self }
    }
}

/// A weaker guarantee for one value of a parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weakened {
    /// Name of the parameter.
    pub param: &'static str,
    /// Value that weakens the guarantee.
    pub value: f32,
    /// Guarantees with this value.
    pub to: Guarantees,
}

/// Paper and section.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Publication {
    /// Authors, year and short title, or "Relief" for work first published here.
    pub paper: &'static str,
    /// Section that defines the method. Empty if the whole paper does, and for work first published
    /// here.
    pub section: &'static str,
}

/// A number that the user may set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Param {
    /// Name, as in `--set search.NAME=VALUE`.
    pub name: &'static str,
    /// Effect of the parameter, in one line.
    pub summary: &'static str,
    /// Unit; empty for plain numbers.
    pub unit: &'static str,
    /// Least accepted value.
    pub min: f32,
    /// Greatest accepted value.
    pub max: f32,
    /// Default value.
    pub default: f32,
    /// Whether only whole numbers are accepted.
    pub integer: bool,
    /// Names of the values, from 0 on, if they are choices; empty if they are numbers.
    pub names: &'static [&'static str],
}

impl Param {
    /// A choice among names. The first name is the default.
    pub const fn of_names(name: &'static str, summary: &'static str, names: &'static [&'static str]) -> Self {
        let max = (names.len() - 1) as f32;
        Self { name, summary, unit: "", min: 0.0, max, default: 0.0, integer: true, names }
    }
}

/// Strength of an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Guarantee {
    /// The method cannot be used for such rays. Requesting it is an error.
    Impossible,
    /// The answer may miss a hit or be a later one.
    Approximate,
    /// The answer never lies behind a hit; it may lie before one.
    Conservative,
    /// The answer is the first hit, except for rounding.
    Exact,
}

impl Guarantee {
    /// Word used in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Guarantee::Impossible => "impossible",
            Guarantee::Approximate => "approximate",
            Guarantee::Conservative => "conservative",
            Guarantee::Exact => "exact",
        }
    }
}

/// A class of rays. A stage has a guarantee for each class.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum RayClass {
    /// Descending rays from above.
    View,
    /// Rays with a quadratic term in their height (curved surfaces).
    Bent,
    /// Ascending rays that start on the surface or above it.
    Shadow,
}

impl RayClass {
    /// All classes, in the order of the tables.
    pub const ALL: [RayClass; 3] = [RayClass::View, RayClass::Bent, RayClass::Shadow];

    /// Word used in tables.
    pub const fn name(self) -> &'static str {
        match self {
            RayClass::View => "view",
            RayClass::Bent => "bent",
            RayClass::Shadow => "shadow",
        }
    }
}

/// The guarantee for each class of rays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Guarantees {
    /// For view rays.
    pub view: Guarantee,
    /// For bent rays.
    pub bent: Guarantee,
    /// For shadow rays.
    pub shadow: Guarantee,
}

impl Guarantees {
    /// Returns one guarantee for all classes of rays.
    pub const fn all(guarantee: Guarantee) -> Self {
        Self { view: guarantee, bent: guarantee, shadow: guarantee }
    }

    /// The guarantee for a class of rays.
    pub const fn of(&self, rays: RayClass) -> Guarantee {
        match rays {
            RayClass::View => self.view,
            RayClass::Bent => self.bent,
            RayClass::Shadow => self.shadow,
        }
    }
}

/// The name is unknown. The error holds the nearest known name.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "unknown {kind} '{name}'{}; known: {}",
    nearest.as_ref().map(|n| format!(": did you mean '{n}'?")).unwrap_or_default(),
    listed(known)
)]
pub struct UnknownName {
    /// Kind of the name: "search", "method" and so on.
    pub kind: &'static str,
    /// The unknown name.
    pub name: String,
    /// Known name nearest to it, if any is near.
    pub nearest: Option<String>,
    /// All known names.
    pub known: Vec<String>,
}

impl UnknownName {
    /// Creates an error that suggests the nearest of the known names.
    pub fn new<'a>(kind: &'static str, name: &str, known: impl IntoIterator<Item = &'a str>) -> Self {
        let known: Vec<String> = known.into_iter().map(str::to_owned).collect();
        let nearest = known
            .iter()
            .map(|candidate| (edit_distance(name, candidate), candidate))
            .filter(|(distance, candidate)| *distance <= 2.max(candidate.len() / 3))
            .min_by_key(|(distance, _)| *distance)
            .map(|(_, candidate)| candidate.clone());
        Self { kind, name: name.to_owned(), nearest, known }
    }
}

/// Most names that an error lists.
const MOST_NAMES: usize = 24;

/// Joins names with commas. Long lists are cut, with the number of the names left out.
pub fn listed(names: &[String]) -> String {
    let shown = names.len().min(MOST_NAMES);
    let rest = names.len() - shown;
    let text = names[..shown].join(", ");
    if rest == 0 { text } else { format!("{text} and {rest} more") }
}

/// Levenshtein distance in characters. Names longer than any known one are cut first, so that
/// hostile input stays cheap.
fn edit_distance(a: &str, b: &str) -> usize {
    let a: Vec<char> = a.chars().take(64).collect();
    let mut row: Vec<usize> = (0..=a.len()).collect();
    for (j, cb) in b.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = j + 1;
        for (i, ca) in a.iter().enumerate() {
            let substituted = diagonal + usize::from(*ca != cb);
            diagonal = row[i + 1];
            row[i + 1] = substituted.min(row[i] + 1).min(diagonal + 1);
        }
    }
    row[a.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_name_is_suggested_only_when_it_is_near() {
        let known = ["parallax", "relief", "occlusion"];
        let nearest = |name: &str| UnknownName::new("method", name, known).nearest;
        assert_eq!(nearest("paralax").as_deref(), Some("parallax"));
        assert_eq!(nearest("relif").as_deref(), Some("relief"));
        assert_eq!(nearest("zzzzzzzzz"), None);
    }

    #[test]
    fn very_many_names_are_not_all_listed() {
        let names: Vec<String> = (0..10_000).map(|k| format!("band{k}")).collect();
        assert_eq!(listed(&names[..2]), "band0, band1");
        let said = listed(&names);
        assert!(said.len() < 400 && said.ends_with(" more"), "{said}");
    }
}
