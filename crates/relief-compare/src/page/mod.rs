//! Page of a comparison: one self-contained HTML file, which needs no network.

mod heat;
mod methods;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use image::codecs::jpeg::JpegEncoder;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder, ImageError};
use maud::{DOCTYPE, Markup, PreEscaped, html};
use serde_json::json;

use self::heat::{heat, legend};
use self::methods::{methods, sentence};
use crate::columns::{COLUMNS, Cell, Column, Row};
use crate::picture::{Flip, Image};
use crate::record::{About, LeftOut, PictureRecord, Records};
use crate::run::{Compared, MethodPicture};

/// Quality of the pictures in the page. Its effect is invisible beside the differences that are
/// shown.
const JPEG_QUALITY: u8 = 90;

const STYLE: &str = include_str!("style.css");
const SCRIPT: &str = include_str!("script.js");

/// Returns the HTML of a comparison's page.
///
/// # Errors
///
/// When a picture cannot be encoded.
pub fn page(compared: &Compared) -> Result<String, ImageError> {
    let records = &compared.records;
    let title = format!("Displacement methods on {}", records.about.map);
    let pictures = pictures(compared)?;
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width";
                title { (title) }
                style { (PreEscaped(STYLE)) }
            }
            body {
                h1 { (title) }
                (about(&records.about))
                (methods(compared))
                (plot())
                (table(records))
                (left_out(&records.left_out))
                (pictures)
                script type="application/json" id="columns" { (PreEscaped(columns())) }
                script { (PreEscaped(SCRIPT)) }
            }
        }
    };
    Ok(page.into_string())
}

fn about(about: &About) -> Markup {
    let About { map, map_size: [columns, rows], tile_m: [u, v], surfaces, .. } = about;
    let About { program, command, machines, reference, .. } = about;
    html! {
        dl {
            dt { "Map" }
            dd {
                (map) ", " (columns) " x " (rows) " texels on a tile of "
                (rounded(*u)) " x " (rounded(*v)) " m"
                @if *surfaces > 1 { ", the first of " (surfaces) " surfaces" }
            }
            dt { "Truth" }
            dd { "Rays: the cell walk in f64. Pictures: " (reference) "." }
            @for machine in machines {
                dt { (machine.backend) ", " (machine.sampling) }
                dd { (machine.device) }
            }
            dt { "Made by" }
            dd { (program) @if !command.is_empty() { ": " code { (command) } } }
        }
    }
}

/// Formats a length in metres without trailing zeros.
fn rounded(metres: f64) -> String {
    let text = format!("{metres:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

fn plot() -> Markup {
    html! {
        h2 { "Error against cost" }
        p.controls {
            label { "conditions " select #rows {} }
            label { "horizontal axis " select #across {} }
            label { "vertical axis " select #up {} }
        }
        svg #plot viewBox="0 0 900 420" role="img" {}
        p #frontier {}
    }
}

/// Table of all records; the script sorts and filters it.
fn table(records: &Records) -> Markup {
    html! {
        h2 { "All results" }
        p.controls {
            label {
                "show only rows with "
                input #filter placeholder="a method, an angle, a scale" size="30";
            }
            span #count {}
        }
        div.wide {
            table #records {
                thead { tr { @for column in COLUMNS {
                    th title=(column.summary) { button type="button" { (column.title) } }
                } } }
                tbody { @for row in Row::all(records) {
                    tr { @for column in COLUMNS { (cell(column, &row)) } }
                } }
            }
        }
    }
}

fn cell(column: &Column, row: &Row) -> Markup {
    match (column.cell)(row) {
        Cell::Empty => html! { td {} },
        Cell::Text(text) => html! { td { (text) } },
        Cell::Number(number) => html! {
            td.number data-value=(number) { (format!("{:.*}", column.digits, number * column.factor)) }
        },
    }
}

/// Keys, titles and factors of columns for the script, as JSON that cannot close an HTML element.
fn columns() -> String {
    let columns: Vec<_> = COLUMNS
        .iter()
        .map(|Column { key, title, factor, .. }| json!({ "key": key, "title": title, "factor": factor }))
        .collect();
    json!(columns).to_string().replace('<', "\\u003c")
}

fn left_out(left_out: &[LeftOut]) -> Markup {
    html! {
        @if !left_out.is_empty() {
            h2 { "Not compared" }
            ul { @for LeftOut { what, reason } in left_out { li { (what) ": " (reason) } } }
        }
    }
}

/// Pictures, grouped by reference, each with its difference image.
fn pictures(compared: &Compared) -> Result<Markup, ImageError> {
    let Compared { records, shown, references, shown_look, .. } = compared;
    let mut groups = Vec::new();
    for (place, reference) in references.iter().enumerate() {
        let of_reference = records.pictures.iter().zip(shown).filter(|(_, shown)| shown.reference == place);
        let figures =
            of_reference.map(|(record, shown)| picture(record, shown)).collect::<Result<Vec<_>, _>>()?;
        let [columns, rows] = reference.map_size;
        groups.push(html! {
            h3 {
                (rounded(reference.scale_m)) " m deep, height map of " (columns) " x " (rows) " texels"
                ", shadow " (reference.shadow)
                @if let Some(distance_m) = reference.distance_m { ", from " (rounded(distance_m)) " m" }
            }
            div.grid {
                figure {
                    (element(&jpeg(&reference.image)?, "image/jpeg", "reference", reference.image.size()))
                    figcaption { "The exact picture, beside which all others are put." }
                }
                @for figure in figures { (figure) }
            }
        });
    }
    Ok(html! {
        @if !groups.is_empty() {
            h2 { "Pictures, each with its FLIP difference from the reference" }
            (legend())
            @if let Some(look) = shown_look {
                p {
                    "The pictures shown here have the light and the background of the look " (look)
                    ". Differences are measured in the scene's own light."
                }
            }
            @for group in groups { (group) }
        }
    })
}

fn picture(record: &PictureRecord, shown: &MethodPicture) -> Result<Markup, ImageError> {
    let label = record.method.label();
    let size = shown.image.size();
    Ok(html! {
        figure {
            (element(&jpeg(&shown.image)?, "image/jpeg", &label, size))
            (element(&map(&shown.difference)?, "image/png", &format!("FLIP of {label}"), size))
            figcaption {
                (sentence(&record.method))
                br;
                (record.backend) " " (record.sampling)
                " · FLIP " (format!("{:.4}", record.flip))
                @if let Some(error) = &record.error {
                    " · p99 " (format!("{:.2}", error.p99_texels)) " texels"
                    " · went through " (format!("{:.2}", error.passed * 100.0)) " %"
                }
            }
        }
    })
}

fn element(bytes: &[u8], kind: &str, name: &str, [width, height]: [u32; 2]) -> Markup {
    let source = format!("data:{kind};base64,{}", STANDARD.encode(bytes));
    html! {
        span.shot {
            img src=(source) alt=(name) title=(name) width=(width) height=(height) loading="lazy";
            span.name { (name) }
        }
    }
}

fn jpeg(image: &Image) -> Result<Vec<u8>, ImageError> {
    let mut bytes = Vec::new();
    let [width, height] = image.size();
    let encoder = JpegEncoder::new_with_quality(&mut bytes, JPEG_QUALITY);
    encoder.write_image(image.srgb8().as_flattened(), width, height, ExtendedColorType::Rgb8)?;
    Ok(bytes)
}

fn map(flip: &Flip) -> Result<Vec<u8>, ImageError> {
    let mut bytes = Vec::new();
    let [width, height] = flip.size;
    let colors: Vec<[u8; 3]> = flip.differences.iter().copied().map(heat).collect();
    let encoder = PngEncoder::new_with_quality(&mut bytes, CompressionType::Best, FilterType::Adaptive);
    encoder.write_image(colors.as_flattened(), width, height, ExtendedColorType::Rgb8)?;
    Ok(bytes)
}
