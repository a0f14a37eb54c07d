//! Parser of tables of colours.

use super::problem::ColorTableProblem;
use super::{ColorEntry, ColorTable, TableElevation, names};
use crate::ReadProblem;

/// Most entries of a table.
const MOST_ENTRIES: usize = 1 << 16;

/// Most characters of a line in an error.
const MOST_SHOWN: usize = 40;

/// Line that a palette of GMT has in its head.
const GMT_MODEL: &str = "COLOR_MODEL";

/// Advice for palettes of GMT with another colour model.
const NO_RGB: &str = "export the palette with COLOR_MODEL = RGB";

/// Advice for tables of QGIS with steps.
const NO_STEPS: &str = "choose the interpolation Linear when you export it";

/// Entries of a table with the line of the last one.
#[derive(Default)]
struct Parser {
    entries: Vec<ColorEntry>,
    nodata: Option<[u8; 4]>,
    outside: Option<[u8; 4]>,
    /// Whether the table is a palette of GMT.
    is_gmt: bool,
    /// Last elevation, and last percentage, with the direction of the elevations before it.
    last: [Option<(f64, Option<bool>)>; 2],
    /// Last elevation of the line before, in a palette of GMT.
    end: Option<f64>,
}

/// Reads a table.
pub(super) fn table(text: &str) -> Result<ColorTable, ReadProblem> {
    let mut parser = Parser::default();
    for (at, line) in text.lines().enumerate() {
        parser.line(line.trim()).map_err(|problem| problem.at(at + 1))?;
        if parser.entries.len() > MOST_ENTRIES {
            return Err(ColorTableProblem::TooMany { most: MOST_ENTRIES }.at(at + 1));
        }
    }
    let Parser { entries, nodata, outside, .. } = parser;
    if entries.is_empty() {
        return Err(ColorTableProblem::Empty.whole());
    }
    Ok(ColorTable { entries, nodata, outside })
}

impl Parser {
    /// Reads a line without the spaces around it.
    fn line(&mut self, line: &str) -> Result<(), ColorTableProblem> {
        if line.starts_with('#') && line.contains(GMT_MODEL) {
            let model = line.rsplit('=').next().unwrap_or_default().trim();
            if !model.trim_start_matches('+').eq_ignore_ascii_case("rgb") {
                let said = shown(line.trim_start_matches('#').trim());
                return Err(ColorTableProblem::Unsupported { said, advice: NO_RGB });
            }
            self.is_gmt = true;
        }
        if line.is_empty() || line.starts_with(['#', '/']) {
            return Ok(());
        }
        let pieces: Vec<&str> = line.split(',').collect();
        let is_gap = |(at, piece): (usize, &&str)| piece.trim().is_empty() && at + 1 < pieces.len();
        if pieces.iter().enumerate().any(is_gap) {
            return Err(ColorTableProblem::Gap { text: shown(line) });
        }
        let is_separator = |letter: char| letter.is_whitespace() || matches!(letter, ',' | ':');
        let fields: Vec<&str> = line.split(is_separator).filter(|field| !field.is_empty()).collect();
        if let ["INTERPOLATION", how] = fields[..] {
            let is_linear = how.eq_ignore_ascii_case("interpolated");
            let unsupported = ColorTableProblem::Unsupported { said: shown(line), advice: NO_STEPS };
            return if is_linear { Ok(()) } else { Err(unsupported) };
        }
        if self.is_gmt { self.palette(line, &fields) } else { self.entry(line, &fields) }
    }

    /// Reads a line of GDAL, GRASS or QGIS.
    fn entry(&mut self, line: &str, fields: &[&str]) -> Result<(), ColorTableProblem> {
        let [place, rest @ ..] = fields else { return Ok(()) };
        // A comment may follow the colour, which may itself begin with the sign.
        let is_comment =
            |(at, field): (usize, &&str)| field.starts_with('#') && (at > 0 || hex(field).is_none());
        let end = rest.iter().enumerate().position(is_comment).unwrap_or(rest.len());
        let rest = &rest[..end];
        let is_name = |field: &&str| field.starts_with(|letter: char| letter.is_ascii_alphabetic());
        let opacity = |rest: &[&str]| rest.first().map_or(Ok(255), |field| channel(field));
        let color = match rest {
            [text, rest @ ..] if text.starts_with('#') => {
                let unclear = || ColorTableProblem::BadColor(shown(text));
                let [red, green, blue] = hex(text).ok_or_else(unclear)?;
                [red, green, blue, opacity(rest)?]
            }
            [name, rest @ ..] if is_name(name) && !is_number(name) => {
                let [red, green, blue] = names::color(name).map_err(ColorTableProblem::UnknownColor)?;
                [red, green, blue, opacity(rest)?]
            }
            [red, green, blue, rest @ ..] => [channel(red)?, channel(green)?, channel(blue)?, opacity(rest)?],
            _ => return Err(ColorTableProblem::TooFew { text: shown(line), fields: rest.len() + 1 }),
        };
        match *place {
            place if place.eq_ignore_ascii_case("nv") => self.nodata = Some(color),
            place if place.eq_ignore_ascii_case("default") => self.outside = Some(color),
            place => {
                let elevation = elevation(place)?;
                self.check_order(elevation, place)?;
                self.entries.push(ColorEntry { elevation, color });
            }
        }
        Ok(())
    }

    /// Reads a line of a palette of GMT.
    fn palette(&mut self, line: &str, fields: &[&str]) -> Result<(), ColorTableProblem> {
        let color = |fields: &[&str]| match fields {
            [red, green, blue] => Ok([channel(red)?, channel(green)?, channel(blue)?, 255]),
            _ => Err(ColorTableProblem::TooFew { text: shown(line), fields: fields.len() }),
        };
        match fields {
            // Colours below and above all elevations are not read, as in GDAL.
            ["B" | "F", ..] => Ok(()),
            ["N", rest @ ..] => {
                self.nodata = Some(color(rest)?);
                Ok(())
            }
            [from, r0, g0, b0, to, r1, g1, b1, ..] => {
                let ends = [(from, [*r0, *g0, *b0]), (to, [*r1, *g1, *b1])];
                for (at, (place, parts)) in ends.into_iter().enumerate() {
                    let elevation = elevation(place)?;
                    let TableElevation::Absolute(number) = elevation else {
                        return Err(ColorTableProblem::BadElevation(shown(place)));
                    };
                    if let (0, Some(before)) = (at, self.end.filter(|end| *end < number)) {
                        return Err(ColorTableProblem::GapOfElevations { at: number, before });
                    }
                    self.check_order(elevation, place)?;
                    self.entries.push(ColorEntry { elevation, color: color(&parts)? });
                    self.end = Some(number);
                }
                Ok(())
            }
            _ => Err(ColorTableProblem::TooFew { text: shown(line), fields: fields.len() }),
        }
    }

    /// Refuses an elevation that is on the wrong side of the one before. Percentages have an order of
    /// their own.
    fn check_order(&mut self, elevation: TableElevation, text: &str) -> Result<(), ColorTableProblem> {
        let (kind, at, unit) = match elevation {
            TableElevation::Absolute(at) => (0, at, ""),
            TableElevation::Percent(at) => (1, at, "%"),
        };
        let Some((before, rise)) = self.last[kind] else {
            self.last[kind] = Some((at, None));
            return Ok(());
        };
        let rises = if at == before { rise } else { Some(at > before) };
        if let (Some(rise), Some(false)) = (rise, rise.zip(rises).map(|(a, b)| a == b)) {
            return Err(ColorTableProblem::Order {
                at: shown(text),
                before: format!("{before}{unit}"),
                rise,
            });
        }
        self.last[kind] = Some((at, rises));
        Ok(())
    }
}

/// Reads an elevation or a percentage.
fn elevation(word: &str) -> Result<TableElevation, ColorTableProblem> {
    let finite = |text: &str| text.parse::<f64>().ok().filter(|number| number.is_finite());
    if let Some(number) = word.strip_suffix('%') {
        let percent = finite(number).filter(|percent| (0.0..=100.0).contains(percent));
        return percent
            .map(TableElevation::Percent)
            .ok_or_else(|| ColorTableProblem::BadPercentage(shown(word)));
    }
    finite(word).map(TableElevation::Absolute).ok_or_else(|| ColorTableProblem::BadElevation(shown(word)))
}

/// Reads a part of a colour.
fn channel(word: &str) -> Result<u8, ColorTableProblem> {
    word.parse().map_err(|_| ColorTableProblem::BadColor(shown(word)))
}

/// Returns red, green and blue of `#rrggbb`.
fn hex(word: &str) -> Option<[u8; 3]> {
    let digits = word.strip_prefix('#').filter(|digits| digits.len() == 6 && digits.is_ascii())?;
    let part = |at: usize| u8::from_str_radix(digits.get(at..at + 2)?, 16).ok();
    Some([part(0)?, part(2)?, part(4)?])
}

/// Whether a word is a number, such as `nan`, which is no name of a colour.
fn is_number(word: &str) -> bool {
    word.parse::<f64>().is_ok()
}

/// Returns the beginning of a text in a readable form.
fn shown(text: &str) -> String {
    let cut: String =
        text.chars().filter(|letter| !letter.is_control() || *letter == '\t').take(MOST_SHOWN).collect();
    if text.chars().count() > MOST_SHOWN { format!("{cut}...") } else { cut }
}
