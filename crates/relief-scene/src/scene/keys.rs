//! Readers of values in scene files, and the list of a type's keys.

use super::{BaseThickness, LightDirection, PictureSize};
use crate::background::Background;
use relief_core::ByteSize;
use relief_io::HeightRange;
use serde::de::value::SeqAccessDeserializer;
use serde::de::{self, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer, forward_to_deserialize_any};
use std::fmt::{self, Display};
use std::str::FromStr;

/// Reads a value from a name or another text.
pub fn parsed<'de, D, T>(deserializer: D) -> Result<Option<T>, D::Error>
where
    D: Deserializer<'de>,
    T: FromStr<Err: Display>,
{
    let text = String::deserialize(deserializer)?;
    text.parse().map(Some).map_err(de::Error::custom)
}

/// Reads exactly `N` numbers. An array type would read the first `N` and ignore the rest.
pub fn numbers<'de, D, T, const N: usize>(deserializer: D) -> Result<Option<[T; N]>, D::Error>
where
    D: Deserializer<'de>,
    T: Deserialize<'de>,
{
    numbers_of(deserializer).map(Some)
}

fn numbers_of<'de, D, T, const N: usize>(deserializer: D) -> Result<[T; N], D::Error>
where
    D: Deserializer<'de>,
    T: Deserialize<'de>,
{
    let numbers = Vec::<T>::deserialize(deserializer)?;
    let given = numbers.len();
    numbers.try_into().map_err(|_| de::Error::invalid_length(given, &format!("{N} numbers").as_str()))
}

/// Reads a length: a number of metres, or a text with its unit, as in `"5cm"`.
pub fn length<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<f64>, D::Error> {
    Length::deserialize(deserializer).map(|Length(metres)| Some(metres))
}

/// Reads exactly `N` lengths.
pub fn lengths<'de, D, const N: usize>(deserializer: D) -> Result<Option<[f64; N]>, D::Error>
where
    D: Deserializer<'de>,
{
    numbers_of::<_, Length, N>(deserializer).map(|each| Some(each.map(|Length(metres)| metres)))
}

/// Length in metres.
struct Length(f64);

impl<'de> Deserialize<'de> for Length {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Metres;

        impl Visitor<'_> for Metres {
            type Value = Length;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number of metres, or a text with its unit, as in \"5cm\"")
            }

            fn visit_f64<E: de::Error>(self, metres: f64) -> Result<Length, E> {
                Ok(Length(metres))
            }

            fn visit_i64<E: de::Error>(self, metres: i64) -> Result<Length, E> {
                Ok(Length(metres as f64))
            }

            fn visit_u64<E: de::Error>(self, metres: u64) -> Result<Length, E> {
                Ok(Length(metres as f64))
            }

            fn visit_str<E: de::Error>(self, text: &str) -> Result<Length, E> {
                relief_io::metres(text).map(Length).map_err(E::custom)
            }
        }

        deserializer.deserialize_any(Metres)
    }
}

/// Reads the thickness of a base: a number of metres, or a text such as `"5cm"` or `"5%"`.
pub fn base<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<BaseThickness>, D::Error> {
    struct Base;

    impl Visitor<'_> for Base {
        type Value = BaseThickness;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            f.write_str("a number of metres, or a text such as \"5cm\" or \"5%\"")
        }

        fn visit_f64<E: de::Error>(self, metres: f64) -> Result<BaseThickness, E> {
            Ok(BaseThickness::Metres(metres))
        }

        fn visit_i64<E: de::Error>(self, metres: i64) -> Result<BaseThickness, E> {
            Ok(BaseThickness::Metres(metres as f64))
        }

        fn visit_str<E: de::Error>(self, text: &str) -> Result<BaseThickness, E> {
            text.parse().map_err(E::custom)
        }
    }

    deserializer.deserialize_any(Base).map(Some)
}

/// Reads the values that become heights 0 and 1: two numbers, or `auto`.
pub fn range<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<HeightRange>, D::Error> {
    struct Range;

    impl<'de> Visitor<'de> for Range {
        type Value = HeightRange;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            f.write_str("two numbers, or \"auto\"")
        }

        fn visit_seq<A: SeqAccess<'de>>(self, numbers: A) -> Result<HeightRange, A::Error> {
            let both = numbers_of::<_, f64, 2>(SeqAccessDeserializer::new(numbers))?;
            Ok(HeightRange::Between(both))
        }

        fn visit_str<E: de::Error>(self, text: &str) -> Result<HeightRange, E> {
            let range = text.parse().ok().filter(|range| *range == HeightRange::Extremes);
            range.ok_or_else(|| E::invalid_value(de::Unexpected::Str(text), &self))
        }
    }

    deserializer.deserialize_any(Range).map(Some)
}

/// Reads the direction toward a light: three numbers, or a text such as `az=315,alt=45`.
pub fn light_direction<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<[f64; 3]>, D::Error> {
    struct Direction;

    impl<'de> Visitor<'de> for Direction {
        type Value = [f64; 3];

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            f.write_str("three numbers, or \"az=DEGREES,alt=DEGREES\"")
        }

        fn visit_seq<A: SeqAccess<'de>>(self, numbers: A) -> Result<[f64; 3], A::Error> {
            numbers_of(SeqAccessDeserializer::new(numbers))
        }

        fn visit_str<E: de::Error>(self, text: &str) -> Result<[f64; 3], E> {
            text.parse().map(|LightDirection(vector)| vector).map_err(E::custom)
        }
    }

    deserializer.deserialize_any(Direction).map(Some)
}

/// Reads the size of a picture: two whole numbers, or `map`.
pub fn picture_size<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<PictureSize>, D::Error> {
    struct Size;

    impl<'de> Visitor<'de> for Size {
        type Value = PictureSize;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            f.write_str("two whole numbers, or \"map\"")
        }

        fn visit_seq<A: SeqAccess<'de>>(self, numbers: A) -> Result<PictureSize, A::Error> {
            numbers_of(SeqAccessDeserializer::new(numbers)).map(PictureSize::Pixels)
        }

        fn visit_str<E: de::Error>(self, text: &str) -> Result<PictureSize, E> {
            let size = text.parse().ok().filter(|size| *size == PictureSize::Map);
            size.ok_or_else(|| E::invalid_value(de::Unexpected::Str(text), &self))
        }
    }

    deserializer.deserialize_any(Size).map(Some)
}

/// Reads a background: three numbers, or a name such as `gradient`.
pub fn background<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<Background>, D::Error> {
    struct Behind;

    impl<'de> Visitor<'de> for Behind {
        type Value = Background;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            f.write_str("three numbers, \"gradient\" or \"environment\"")
        }

        fn visit_seq<A: SeqAccess<'de>>(self, numbers: A) -> Result<Background, A::Error> {
            let colour: [f32; 3] = numbers_of(SeqAccessDeserializer::new(numbers))?;
            Ok(Background::Color(colour.into()))
        }

        fn visit_str<E: de::Error>(self, text: &str) -> Result<Background, E> {
            text.parse().map_err(E::custom)
        }
    }

    deserializer.deserialize_any(Behind).map(Some)
}

/// Reads an amount of memory: a number of bytes, or a text such as `4GiB`.
pub fn amount<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<ByteSize>, D::Error> {
    struct Amount;

    impl Visitor<'_> for Amount {
        type Value = ByteSize;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            f.write_str("an amount of memory such as \"4GiB\"")
        }

        fn visit_i64<E: de::Error>(self, bytes: i64) -> Result<ByteSize, E> {
            bytes.to_string().parse().map_err(E::custom)
        }

        fn visit_str<E: de::Error>(self, text: &str) -> Result<ByteSize, E> {
            text.parse().map_err(E::custom)
        }
    }

    deserializer.deserialize_any(Amount).map(Some)
}

/// Returns the keys from which a struct is read, as its derived reader names them.
pub fn keys_of<T: for<'de> Deserialize<'de>>() -> &'static [&'static str] {
    let mut keys: &'static [&'static str] = &[];
    // Nothing is read: the reader passes its static list of fields and receives no value.
    let _ = T::deserialize(Fields(&mut keys));
    keys
}

/// Deserializer that records a struct's fields.
struct Fields<'a>(&'a mut &'static [&'static str]);

impl<'de> Deserializer<'de> for Fields<'_> {
    type Error = de::value::Error;

    fn deserialize_any<V: Visitor<'de>>(self, _: V) -> Result<V::Value, Self::Error> {
        Err(de::Error::custom("nothing to read"))
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        fields: &'static [&'static str],
        _: V,
    ) -> Result<V::Value, Self::Error> {
        *self.0 = fields;
        Err(de::Error::custom("nothing to read"))
    }

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option unit
        unit_struct newtype_struct seq tuple tuple_struct map enum identifier ignored_any
    }
}
