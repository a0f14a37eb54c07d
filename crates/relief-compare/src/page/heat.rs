//! Colours of differences, and their legend.

use maud::{Markup, html};
use relief_render::false_color::Palette;

/// Palette of differences: FLIP's authors show them by it.
const PALETTE: Palette = Palette::Magma;

/// Number of steps between no difference and the greatest one: few colours make small files.
const STEPS: u32 = 64;

/// Returns the colour of a difference from 0 to 1, in steps of a 64th.
pub fn heat(difference: f32) -> [u8; 3] {
    PALETTE.at((difference * STEPS as f32).round() / STEPS as f32)
}

/// Returns the legend of difference pictures: a bar with the numbers at its ends and between.
pub fn legend() -> Markup {
    let stops = (0..=8).map(|stop| {
        let [r, g, b] = heat(stop as f32 / 8.0);
        format!("rgb({r},{g},{b})")
    });
    let stops: Vec<String> = stops.collect();
    let style = format!("background:linear-gradient(to right,{})", stops.join(","));
    html! {
        div.legend {
            b { "FLIP difference from the reference" }
            div.scale {
                div.bar style=(style) {}
                div.ends { span { "0: equal" } span { "0.5" } span { "1: the greatest" } }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_legend_has_the_colors_of_differences() {
        let text = legend().into_string();
        for difference in [0.0, 0.125, 0.5, 1.0] {
            let [r, g, b] = heat(difference);
            assert!(text.contains(&format!("rgb({r},{g},{b})")), "{difference}: {text}");
        }
        assert_eq!((heat(2.0), heat(f32::NAN)), (heat(1.0), heat(0.0)));
        // A colour of another difference is not in it.
        let [r, g, b] = heat(0.3);
        assert!(!text.contains(&format!("rgb({r},{g},{b})")));
    }
}
