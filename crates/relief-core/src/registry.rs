//! What registry entries of stages and of map kinds are made of: parameters, sources, promises, the baked maps
//! that they read, and names that nothing has.

/// The most parameters of an entry: they travel to the shader in one vector of four.
pub const MAX_PARAMS: usize = 4;

/// A baked map that a stage reads: a texture of a map kind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MapInput {
    /// Name of the map kind.
    pub kind: &'static str,
    /// Name of the texture among those of the kind; empty for the only one.
    pub texture: &'static str,
    /// The kind's settings that it needs. Of the others it takes the defaults.
    pub settings: &'static [(&'static str, MapSetting)],
    /// The metric that the map is baked in.
    pub metric: MapMetric,
    /// The levels that it has.
    pub levels: MapLevels,
    /// The most texels of the longer side of the height map's level that it is baked from: of the finest such
    /// level. None: it is baked from the height map itself.
    pub side: Option<MapSetting>,
}

/// The value of a kind's setting that a stage needs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MapSetting {
    /// Always this one.
    Fixed(f32),
    /// That of the stage's own parameter of this name.
    Param(&'static str),
    /// The first where all is seen in the finest level of detail, else the second, with which one map serves
    /// all levels.
    Levels(f32, f32),
}

/// The metric that a map for a stage is baked in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MapMetric {
    /// Texture units and heights as they are: the map is the same whatever the tile's size and the scale in
    /// metres.
    Texture,
    /// The metres of the surface that the map lies on.
    Scene,
}

/// The levels of a map for a stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MapLevels {
    /// The finest level of the kind's texture.
    One,
    /// The levels of the kind's texture from that one on. Each is padded, to the right and below, to half the
    /// size of the one before, as textures of GPUs have it: kinds round sizes up, textures round down.
    ChainFrom(u32),
    /// All levels of the kind's texture, each a mean over areas. They have the sizes of the levels of detail
    /// from that one on.
    MeansFrom(u32),
    /// The finest level of the kind's texture for each [level](crate::HeightMap::level) of the height map,
    /// baked from that level's heights.
    EachDetail,
}

impl MapInput {
    /// The finest level of a kind's texture, with default settings, in texture units.
    pub const fn new(kind: &'static str, texture: &'static str) -> Self {
        Self { kind, texture, settings: &[], metric: MapMetric::Texture, levels: MapLevels::One, side: None }
    }

    /// The same with settings.
    #[must_use]
    pub const fn with(self, settings: &'static [(&'static str, MapSetting)]) -> Self {
        Self { settings, ..self }
    }
}

/// What is promised where a parameter has a value that takes something away.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weakened {
    /// The parameter's name.
    pub param: &'static str,
    /// The value.
    pub value: f32,
    /// What is promised then.
    pub to: Guarantees,
}

/// Paper and section.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Publication {
    /// Authors, year and short title, or "Relief" for what was published first here.
    pub paper: &'static str,
    /// The section that defines it; empty when the whole text does, and for what was published here.
    pub section: &'static str,
}

/// A number that the user may set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Param {
    /// Its name, as in `--set search.NAME=VALUE`.
    pub name: &'static str,
    /// What it does, in one line.
    pub summary: &'static str,
    /// Its unit; empty for plain numbers.
    pub unit: &'static str,
    /// The least accepted value.
    pub min: f32,
    /// The greatest accepted value.
    pub max: f32,
    /// The value used when nobody sets it.
    pub default: f32,
    /// Whether only whole numbers are accepted.
    pub integer: bool,
    /// Names of its values, from 0 on, where these stand for choices; empty where they are numbers.
    pub names: &'static [&'static str],
}

impl Param {
    /// A choice among names, of which the first is the default.
    pub const fn of_names(name: &'static str, summary: &'static str, names: &'static [&'static str]) -> Self {
        let max = (names.len() - 1) as f32;
        Self { name, summary, unit: "", min: 0.0, max, default: 0.0, integer: true, names }
    }
}

/// How strong an answer is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Guarantee {
    /// It cannot be used for such rays; asking for it is an error.
    Impossible,
    /// It may miss a hit or find a later one.
    Approximate,
    /// It never passes a hit; it may stop before one.
    Conservative,
    /// It ends at the first hit, to rounding.
    Exact,
}

impl Guarantee {
    /// The word used in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Guarantee::Impossible => "impossible",
            Guarantee::Approximate => "approximate",
            Guarantee::Conservative => "conservative",
            Guarantee::Exact => "exact",
        }
    }
}

/// A class of rays, for which a stage has a guarantee of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum RayClass {
    /// Rays from above that descend.
    View,
    /// Rays whose height has a quadratic term (curved surfaces).
    Bent,
    /// Rays that start on the surface or above it and ascend.
    Shadow,
}

impl RayClass {
    /// Every class, in the order in which tables list them.
    pub const ALL: [RayClass; 3] = [RayClass::View, RayClass::Bent, RayClass::Shadow];

    /// The word used in tables.
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
    /// The same guarantee for every class of rays.
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

/// A name that nothing has, with the nearest name that something has.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("unknown {kind} '{name}'{}; known: {}", nearest.as_ref().map(|n| format!(": did you mean '{n}'?")).unwrap_or_default(), listed(known))]
pub struct UnknownName {
    /// What was asked for: "search", "method" and so on.
    pub kind: &'static str,
    /// The unknown name.
    pub name: String,
    /// The known name nearest to it, if any is near.
    pub nearest: Option<String>,
    /// All known names.
    pub known: Vec<String>,
}

impl UnknownName {
    /// An error that suggests the nearest of the known names.
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

/// The most names that an error lists.
const MOST_NAMES: usize = 24;

/// Names between commas; of very many only the first, and how many more there are.
pub fn listed(names: &[String]) -> String {
    let shown = names.len().min(MOST_NAMES);
    let rest = names.len() - shown;
    let text = names[..shown].join(", ");
    if rest == 0 { text } else { format!("{text} and {rest} more") }
}

/// Levenshtein distance in characters; a name longer than any of ours is cut first, so that hostile input
/// stays cheap.
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
