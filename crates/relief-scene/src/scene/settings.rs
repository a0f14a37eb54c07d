//! Readers of settings in scene files: numbers, or names for values that have names.

use std::collections::BTreeMap;
use std::fmt;

use relief_shaders::Selection;
use serde::Deserializer;
use serde::de::{self, DeserializeSeed, MapAccess, Visitor};

/// Reads `[set]`. In TOML, `search.steps = 64` there is a table in a table.
pub fn settings<'de, D: Deserializer<'de>>(deserializer: D) -> Result<BTreeMap<String, f64>, D::Error> {
    let mut settings = BTreeMap::new();
    deserializer.deserialize_map(Stages(&mut settings))?;
    Ok(settings)
}

/// Reads the settings of all stages.
struct Stages<'a>(&'a mut BTreeMap<String, f64>);

/// Reads the settings of one stage.
struct OfStage<'a> {
    stage: String,
    settings: &'a mut BTreeMap<String, f64>,
}

/// Reads the value of a setting.
struct Value<'a>(&'a str);

impl<'de> Visitor<'de> for Stages<'_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("settings such as search.steps = 64")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<(), A::Error> {
        while let Some(stage) = map.next_key()? {
            map.next_value_seed(OfStage { stage, settings: &mut *self.0 })?;
        }
        Ok(())
    }
}

impl<'de> DeserializeSeed<'de> for OfStage<'_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_map(self)
    }
}

impl<'de> Visitor<'de> for OfStage<'_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "settings such as {}.NAME = VALUE", self.stage)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<(), A::Error> {
        while let Some(name) = map.next_key::<String>()? {
            let key = format!("{}.{name}", self.stage);
            let value = map.next_value_seed(Value(&key))?;
            self.settings.insert(key, value);
        }
        Ok(())
    }
}

impl<'de> DeserializeSeed<'de> for Value<'_> {
    type Value = f64;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<f64, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl Visitor<'_> for Value<'_> {
    type Value = f64;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number, or the name of a value")
    }

    fn visit_f64<E: de::Error>(self, number: f64) -> Result<f64, E> {
        Ok(number)
    }

    fn visit_i64<E: de::Error>(self, number: i64) -> Result<f64, E> {
        Ok(number as f64)
    }

    fn visit_u64<E: de::Error>(self, number: u64) -> Result<f64, E> {
        Ok(number as f64)
    }

    fn visit_str<E: de::Error>(self, name: &str) -> Result<f64, E> {
        match Selection::value_named(self.0, name) {
            Ok(Some(value)) => Ok(value),
            Ok(None) => Err(E::invalid_type(de::Unexpected::Str(name), &self)),
            Err(error) => Err(E::custom(error)),
        }
    }
}
