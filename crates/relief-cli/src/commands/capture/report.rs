//! Report on a capture.

use std::io::{self, Write};
use std::path::PathBuf;

use comfy_table::Table;
use comfy_table::presets::ASCII_MARKDOWN;
use glam::DVec3;
use relief_core::object::View;
use relief_object::{Captured, Cover, Measured};
use serde_json::{Value, json};

use super::Arguments;
use super::subject::Subject;
use crate::values::six_digits;

/// Capture that was written.
pub struct CaptureReport<'a> {
    pub captured: &'a Captured,
    /// All comparisons with the mesh, also of the written images.
    pub compared: &'a [(Cover, Measured)],
    pub files: &'a [PathBuf],
    /// Whether anything of the object is solid.
    pub is_solid: bool,
    /// Edges of the mesh with only one triangle.
    pub open_edges: usize,
    pub seconds: f64,
}

impl CaptureReport<'_> {
    pub fn tell(&self, arguments: &Arguments, subject: &Subject, out: &mut dyn Write) -> io::Result<()> {
        if arguments.json {
            return writeln!(out, "{:#}", self.as_json(arguments, subject));
        }
        let captured = self.captured;
        let size = captured.images.first().map_or(0, |image| image.heights.width());
        writeln!(
            out,
            "{}: {} {} images of {size}x{size}, {} bit, in {:.2} s",
            arguments.output.display(),
            captured.images.len(),
            captured.kind(),
            captured.bits,
            self.seconds
        )?;
        let (centre, radius) = self.ball();
        let texel = captured.views.first().map_or(0.0, View::texel_m);
        let [radius, texel] = [radius, texel].map(six_digits);
        writeln!(out, "  ball        radius {radius} m around {}, a texel {texel} m", point(centre))?;
        writeln!(out, "  seen        {} texels, cover {}", captured.seen, captured.cover)?;
        if !self.is_solid {
            writeln!(out, "  solid       none: the object is empty")?;
        }
        if self.open_edges > 0 {
            writeln!(
                out,
                "  open        {} edges of the mesh are open, {:.2} % of the texels seen show backs",
                self.open_edges,
                100.0 * self.back_share()
            )?;
        }
        let colors = if subject.colors.is_some() { "color.png" } else { "none" };
        writeln!(out, "  colours     {colors}")?;
        if let Some((_, Measured { views, size, cells, jump_texels, .. })) = self.compared.first() {
            writeln!(
                out,
                "  compared    in {views} pictures of {size}x{size}, cells {cells} from {jump_texels} texels"
            )?;
            writeln!(out, "{}", self.table())?;
        }
        Ok(())
    }

    fn table(&self) -> Table {
        let mut table = Table::new();
        table.load_style(ASCII_MARKDOWN);
        table.set_header(["", "cover", "IoU", "apart", "worst IoU", "from", "worst apart"]);
        let percent = |error: Option<f64>| error.map_or("-".to_owned(), |error| format!("{error:.3} %"));
        for (cover, measured) in self.compared {
            let written = if *cover == self.captured.cover { "written" } else { "" };
            table.add_row([
                written.to_owned(),
                cover.to_string(),
                format!("{:.4}", measured.iou),
                percent(measured.depth_error_percent),
                format!("{:.4}", measured.worst_iou),
                rounded(measured.worst_from),
                percent(measured.worst_depth_error_percent),
            ]);
        }
        table
    }

    fn ball(&self) -> (DVec3, f64) {
        self.captured.views.first().map_or((DVec3::ZERO, 0.0), View::ball)
    }

    fn back_share(&self) -> f64 {
        self.captured.backs as f64 / (self.captured.seen as f64).max(1.0)
    }

    fn as_json(&self, arguments: &Arguments, subject: &Subject) -> Value {
        let captured = self.captured;
        let (centre, radius) = self.ball();
        let compared: Vec<Value> =
            self.compared.iter().map(|(cover, measured)| row(*cover, measured)).collect();
        let written = self.compared.iter().find(|(cover, _)| *cover == captured.cover);
        json!({
            "input": arguments.input.display().to_string(),
            "output": arguments.output.display().to_string(),
            "files": self.files.iter().map(|file| file.display().to_string()).collect::<Vec<_>>(),
            "kind": captured.kind().name(), "views": captured.images.len(),
            "size": captured.images.first().map(|image| image.heights.width()),
            "bits": captured.bits, "cover": captured.cover.name(), "centre_m": centre.to_array(),
            "radius_m": radius, "texel_m": captured.views.first().map(View::texel_m),
            "triangles": subject.mesh.triangles().len(), "open_edges": self.open_edges,
            "seen": captured.seen, "solid": self.is_solid,
            "backs": captured.backs, "colors": subject.colors.is_some(),
            "measured": written.map(|(cover, measured)| row(*cover, measured)), "compared": compared,
            "seconds": self.seconds,
        })
    }
}

fn row(cover: Cover, measured: &Measured) -> Value {
    json!({
        "cover": cover.name(), "views": measured.views, "size": measured.size,
        "cells": measured.cells.name(), "jump": measured.jump_texels, "iou": measured.iou,
        "depth_error_percent": measured.depth_error_percent,
        "worst_from": measured.worst_from.to_array(), "worst_iou": measured.worst_iou,
        "worst_depth_error_percent": measured.worst_depth_error_percent,
    })
}

fn point(at: DVec3) -> String {
    let [x, y, z] = at.to_array().map(six_digits);
    format!("({x}, {y}, {z})")
}

fn rounded(at: DVec3) -> String {
    let [x, y, z] = at.to_array();
    format!("({x:.2}, {y:.2}, {z:.2})")
}
