//! Drawings as SVG.

use std::fmt::Write as _;

use super::{Anchor, Color, Figure, Place, Shape};

impl Figure {
    /// Returns the drawing as an SVG document. The same drawing gives the same text.
    pub fn svg(&self) -> String {
        let [width, height] = self.size;
        let [[left, top], [right, bottom]] = self.frame;
        let mut text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 \
             {width} {height}\" font-family=\"'Noto Sans Mono', 'DejaVu Sans Mono', monospace\">\n\
             <rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>\n\
             <clipPath id=\"frame\"><rect x=\"{left:.1}\" y=\"{top:.1}\" width=\"{:.1}\" height=\"{:.1}\"/>\
             </clipPath>\n<g clip-path=\"url(#frame)\">\n",
            right - left,
            bottom - top
        );
        self.inside.iter().for_each(|shape| write(&mut text, shape));
        text += "</g>\n";
        self.over.iter().for_each(|shape| write(&mut text, shape));
        text + "</svg>\n"
    }
}

/// Width of a character of the fonts, as a part of their size.
const ADVANCE: f64 = 0.6;

fn hex([red, green, blue]: Color) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

fn list(places: &[Place]) -> String {
    let each: Vec<String> = places.iter().map(|[x, y]| format!("{x:.1},{y:.1}")).collect();
    each.join(" ")
}

fn write(out: &mut String, shape: &Shape) {
    // Writing to a string does not fail.
    let _ = match shape {
        Shape::Area { corners, color, opacity } => writeln!(
            out,
            "<polygon points=\"{}\" fill=\"{}\" fill-opacity=\"{opacity:.3}\"/>",
            list(corners),
            hex(*color)
        ),
        Shape::Line { places, color, width, dashed } => writeln!(
            out,
            "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{width:.1}\" \
             stroke-linejoin=\"round\"{}/>",
            list(places),
            hex(*color),
            if *dashed { " stroke-dasharray=\"5 3\"" } else { "" }
        ),
        Shape::Ellipse { centre: [x, y], radii: [across, up], color, opacity } => {
            let color = hex(*color);
            writeln!(
                out,
                "<ellipse cx=\"{x:.1}\" cy=\"{y:.1}\" rx=\"{across:.1}\" ry=\"{up:.1}\" fill=\"{color}\" \
                 fill-opacity=\"{opacity:.3}\" stroke=\"{color}\"/>"
            )
        }
        Shape::Text { at: [x, y], text, size, color, anchor } => {
            let anchor = match anchor {
                Anchor::Start => "start",
                Anchor::Middle => "middle",
                Anchor::End => "end",
            };
            let escaped = text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
            writeln!(
                out,
                "<text x=\"{x:.1}\" y=\"{y:.1}\" font-size=\"{:.1}\" fill=\"{}\" \
                 text-anchor=\"{anchor}\">{escaped}</text>",
                size.advance() / ADVANCE,
                hex(*color)
            )
        }
    };
}
