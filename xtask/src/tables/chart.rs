//! Small multiples as SVG, by hand: bars over names or lines over numbers, spreads as error bars. Greys and hues that
//! read on light and dark ground; the ground itself is left open.

use std::fmt::Write;

/// What lies along a panel's horizontal axis.
pub enum Across {
    /// Bars.
    Names(Vec<String>),
    /// Lines over a logarithmic axis, with its label.
    Numbers(Vec<f64>, &'static str),
}

/// One panel.
pub struct Panel {
    /// Title with the unit.
    pub title: String,
    pub across: Across,
    pub series: Vec<Series>,
    /// Logarithmic upward, from the least positive value on; else from 0.
    pub logarithmic: bool,
}

/// A name and a value with its spread (0 for none) for each place along the axis; `None` leaves it out.
pub struct Series {
    pub name: String,
    pub values: Vec<Option<(f64, f64)>>,
}

const COLOURS: [&str; 5] = ["#2f7fd0", "#d0762f", "#3f9a5f", "#a05fc0", "#808080"];
const INK: &str = "#767676";
const LINES: &str = "#76767655";
/// A panel's width and height with its margins, and the plot's own box in it.
const WIDTH: f64 = 360.0;
const HEIGHT: f64 = 250.0;
const LEFT: f64 = 58.0;
const TOP: f64 = 34.0;
const RIGHT: f64 = 350.0;
const BOTTOM: f64 = 200.0;
const PANELS_A_ROW: usize = 2;

/// A figure of panels with one legend.
pub fn svg(panels: &[Panel]) -> String {
    let rows = panels.len().div_ceil(PANELS_A_ROW);
    let (width, height) = (WIDTH * PANELS_A_ROW.min(panels.len()) as f64, HEIGHT * rows as f64 + 26.0);
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\" font-size=\"12\" fill=\"{INK}\">\n"
    );
    let mut x = LEFT;
    for (i, series) in panels.first().map_or(&[][..], |panel| &panel.series).iter().enumerate() {
        let _ = writeln!(out, "<rect x=\"{x}\" y=\"6\" width=\"12\" height=\"12\" fill=\"{}\"/>", colour(i));
        let _ = writeln!(out, "<text x=\"{}\" y=\"16\">{}</text>", x + 17.0, escaped(&series.name));
        x += 34.0 + 7.0 * series.name.chars().count() as f64;
    }
    for (i, panel) in panels.iter().enumerate() {
        let (x, y) = ((i % PANELS_A_ROW) as f64 * WIDTH, (i / PANELS_A_ROW) as f64 * HEIGHT + 26.0);
        let _ = writeln!(out, "<g transform=\"translate({x} {y})\">");
        draw(panel, &mut out);
        out.push_str("</g>\n");
    }
    out.push_str("</svg>\n");
    out
}

fn colour(i: usize) -> &'static str {
    COLOURS[i % COLOURS.len()]
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// A value's height in the plot.
struct Upward {
    low: f64,
    high: f64,
    logarithmic: bool,
}

impl Upward {
    fn new(panel: &Panel) -> Upward {
        let values = || panel.series.iter().flat_map(|series| series.values.iter().flatten());
        if panel.logarithmic {
            let positive = || values().map(|value| value.0).filter(|&value| value > 0.0);
            let low = positive().fold(f64::INFINITY, f64::min).log10().floor();
            let high = positive().fold(f64::MIN_POSITIVE, f64::max).log10().ceil();
            let low = if low.is_finite() { low } else { high - 1.0 };
            return Upward { low, high: high.max(low + 1.0), logarithmic: true };
        }
        let most = values().map(|(value, spread)| value + spread).fold(0.0, f64::max);
        Upward { low: 0.0, high: if most > 0.0 { most * 1.05 } else { 1.0 }, logarithmic: false }
    }

    fn y(&self, value: f64) -> f64 {
        let value = if self.logarithmic { value.max(f64::MIN_POSITIVE).log10() } else { value };
        BOTTOM - (BOTTOM - TOP) * ((value - self.low) / (self.high - self.low)).clamp(0.0, 1.0)
    }

    fn ticks(&self) -> Vec<f64> {
        if self.logarithmic {
            return (self.low as i32..=self.high as i32).map(|power| 10f64.powi(power)).collect();
        }
        let rough = self.high / 4.0;
        let power = 10f64.powf(rough.log10().floor());
        let step = [1.0, 2.0, 5.0, 10.0].into_iter().map(|f| f * power).find(|&step| step >= rough).unwrap_or(rough);
        (0..).map(|i| f64::from(i) * step).take_while(|&tick| tick <= self.high).collect()
    }
}

fn draw(panel: &Panel, out: &mut String) {
    let up = Upward::new(panel);
    let _ = writeln!(out, "<text x=\"{LEFT}\" y=\"20\" font-weight=\"bold\">{}</text>", escaped(&panel.title));
    for tick in up.ticks() {
        let y = up.y(tick);
        // Shortest text of the number as it was meant, not as it was added up.
        let label = format!("{:.6}", tick).trim_end_matches('0').trim_end_matches('.').to_owned();
        let _ = writeln!(out, "<path d=\"M{LEFT} {y:.1} H{RIGHT}\" stroke=\"{LINES}\"/>");
        let _ = writeln!(out, "<text x=\"{}\" y=\"{:.1}\" text-anchor=\"end\">{label}</text>", LEFT - 6.0, y + 4.0);
    }
    match &panel.across {
        Across::Names(names) => bars(panel, names, &up, out),
        Across::Numbers(numbers, label) => lines(panel, numbers, label, &up, out),
    }
}

fn bars(panel: &Panel, names: &[String], up: &Upward, out: &mut String) {
    let group = (RIGHT - LEFT) / names.len().max(1) as f64;
    let bar = group * 0.8 / panel.series.len().max(1) as f64;
    for (g, name) in names.iter().enumerate() {
        let left = LEFT + group * (g as f64 + 0.1);
        for (s, series) in panel.series.iter().enumerate() {
            let Some((value, spread)) = series.values.get(g).copied().flatten() else { continue };
            let (x, y) = (left + bar * s as f64, up.y(value));
            let _ = writeln!(
                out,
                "<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"{:.1}\" height=\"{:.1}\" fill=\"{}\" fill-opacity=\".75\"/>",
                bar * 0.92,
                (BOTTOM - y).max(0.0),
                colour(s)
            );
            error_bar(x + bar * 0.46, value, spread, up, out);
        }
        // Long names in two lines, cut at the space nearest the middle.
        let middle = left + group * 0.4;
        for (line, part) in in_two(name, group / 6.2).iter().enumerate() {
            let y = BOTTOM + 16.0 + 14.0 * line as f64;
            let _ = writeln!(out, "<text x=\"{middle:.1}\" y=\"{y}\" text-anchor=\"middle\">{}</text>", escaped(part));
        }
    }
}

fn in_two(text: &str, room: f64) -> Vec<&str> {
    let fits = text.chars().count() as f64 <= room;
    let middle = |at: &usize| at.abs_diff(text.len() / 2);
    match text.match_indices(' ').map(|(at, _)| at).min_by_key(middle) {
        Some(at) if !fits => vec![&text[..at], &text[at + 1..]],
        _ => vec![text],
    }
}

fn lines(panel: &Panel, numbers: &[f64], label: &str, up: &Upward, out: &mut String) {
    let (first, last) = (numbers.first().copied().unwrap_or(1.0), numbers.last().copied().unwrap_or(1.0));
    let range = (last / first).ln().max(f64::MIN_POSITIVE);
    let x = |number: f64| LEFT + 12.0 + (RIGHT - LEFT - 24.0) * (number / first).ln() / range;
    for &number in numbers {
        let at = x(number);
        let _ = writeln!(out, "<text x=\"{at:.1}\" y=\"{}\" text-anchor=\"middle\">{number}</text>", BOTTOM + 16.0);
    }
    let middle = 0.5 * (LEFT + RIGHT);
    let _ = writeln!(out, "<text x=\"{middle}\" y=\"{}\" text-anchor=\"middle\">{label}</text>", BOTTOM + 34.0);
    for (s, series) in panel.series.iter().enumerate() {
        let mut path = String::new();
        for (&number, value) in numbers.iter().zip(&series.values) {
            let Some((value, spread)) = *value else { continue };
            let (x, y) = (x(number), up.y(value));
            let _ = write!(path, "{}{x:.1} {y:.1} ", if path.is_empty() { 'M' } else { 'L' });
            let _ = writeln!(out, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"3\" fill=\"{}\"/>", colour(s));
            error_bar(x, value, spread, up, out);
        }
        let path = path.trim_end();
        let _ = writeln!(out, "<path d=\"{path}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"/>", colour(s));
    }
}

fn error_bar(x: f64, value: f64, spread: f64, up: &Upward, out: &mut String) {
    if spread > 0.0 {
        let (high, low) = (up.y(value + spread), up.y(value - spread));
        let _ = writeln!(
            out,
            "<path d=\"M{:.1} {high:.1} h6 m-3 0 V{low:.1} m-3 0 h6\" fill=\"none\" stroke=\"{INK}\"/>",
            x - 3.0
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn panels() -> Vec<Panel> {
        let series = |name: &str| Series { name: name.into(), values: vec![Some((0.5, 0.2)), None, Some((2.0, 0.0))] };
        let panel = |across, logarithmic| Panel {
            title: "error < 1 px & more".into(),
            across,
            series: vec![series("a"), series("b <i>")],
            logarithmic,
        };
        vec![
            panel(Across::Names(vec!["one".into(), "two long words".into(), "three".into()]), false),
            panel(Across::Numbers(vec![40.0, 100.0, 400.0], "control points"), true),
        ]
    }

    /// Every element opened is closed, in order, and there is no bare `<` or `&`.
    fn well_formed(text: &str) -> bool {
        let mut open: Vec<String> = Vec::new();
        let mut rest = text;
        while let Some(at) = rest.find('<') {
            let Some(length) = rest[at..].find('>') else { return false };
            let tag = &rest[at + 1..at + length];
            if tag.contains('<') || !tag.matches('"').count().is_multiple_of(2) {
                return false;
            }
            let name = tag.trim_start_matches('/').split([' ', '/']).next().unwrap_or_default().to_owned();
            if tag.starts_with('/') {
                if open.pop() != Some(name) {
                    return false;
                }
            } else if !tag.ends_with('/') {
                open.push(name);
            }
            rest = &rest[at + length + 1..];
        }
        let entities =
            text.match_indices('&').all(|(at, _)| ["amp;", "lt;", "gt;"].iter().any(|e| text[at + 1..].starts_with(e)));
        open.is_empty() && entities && !text.contains("NaN") && !text.contains("inf")
    }

    #[test]
    fn figures_are_well_formed() {
        let text = svg(&panels());
        assert!(well_formed(&text), "{text}");
        assert!(!well_formed(&text.replace("</g>", "")) && !well_formed(&text.replace("&lt;", "<")));
        assert!(well_formed(&svg(&[])));
    }

    #[test]
    fn bars_are_as_high_as_their_values_and_spreads_are_drawn() {
        let text = svg(&panels()[..1]);
        let heights: Vec<f64> = text
            .lines()
            .filter(|line| line.starts_with("<rect") && !line.contains("height=\"12\""))
            .filter_map(|line| line.split("height=\"").nth(1)?.split('"').next()?.parse().ok())
            .collect();
        assert_eq!(heights.len(), 4);
        assert!((heights[2] / heights[0] - 4.0).abs() < 0.02, "{heights:?}");
        assert_eq!(text.matches("h6 m-3").count(), 2, "only where there is a spread");
    }
}
