//! Bend lists as text: a table for hands, and rows for machines.

use crate::{BendList, Check, Stock};
use std::fmt::Write;

/// What is told of a bend to hands, in this order.
pub const HEADINGS: [&str; 7] =
    ["bend", "mm from start", "go straight mm", "turn deg", "bend deg", "round a radius of mm", "bend to deg"];

impl BendList {
    /// A row of words for each bend, in the order of the headings. The radius is that of the bend's inside: of the rod to bend round.
    pub fn rows(&self, stock: &Stock) -> impl Iterator<Item = [String; 7]> {
        self.bends.iter().enumerate().map(move |(i, bend)| {
            [
                format!("{}", i + 1),
                format!("{:.0}", bend.at_mm),
                format!("{:.1}", bend.feed_mm),
                format!("{:+.1}", bend.turn_deg),
                format!("{:.1}", bend.angle_deg),
                format!("{:.1}", (bend.radius_mm - 0.5 * stock.gauge_mm).max(0.0)),
                format!("{:.1}", bend.bend_to_deg),
            ]
        })
    }

    /// A table in Markdown, with what to know before it.
    pub fn table(&self, check: &Check, stock: &Stock) -> String {
        let mut text = String::from("# Bend list\n\n");
        // Writing to a String cannot fail.
        for sentence in check.sentences(stock) {
            let _ = writeln!(text, "{sentence}");
        }
        let _ = writeln!(
            text,
            "\nFor each row: go straight, turn the wire about itself (anticlockwise as you look along it, where it is +), and bend it \
             round a rod of that radius until it stands at \"bend to\"; it springs back to \"bend\".\n"
        );
        let _ = writeln!(text, "| {} |", HEADINGS.join(" | "));
        let _ = writeln!(text, "|{}", "---:|".repeat(HEADINGS.len()));
        for row in self.rows(stock) {
            let _ = writeln!(text, "| {} |", row.join(" | "));
        }
        let _ = writeln!(text, "\nAt the end, go straight for {:.1} mm.", self.last_feed_mm);
        text
    }

    /// CSV of the feed/rotate/bend kind (also called LRA or YBC): lengths and radii of the wire's middle, mm; angles in degrees, once as they
    /// are to be and once with spring-back. The last row only feeds.
    pub fn csv(&self) -> String {
        let mut text = String::from("feed_mm,rotate_deg,bend_deg,radius_mm,bend_with_springback_deg\n");
        for bend in &self.bends {
            let _ = writeln!(
                text,
                "{:.2},{:.1},{:.1},{:.2},{:.2}",
                bend.feed_mm, bend.turn_deg, bend.angle_deg, bend.radius_mm, bend.bend_to_deg
            );
        }
        let _ = writeln!(text, "{:.2},0.0,0.0,0.00,0.00", self.last_feed_mm);
        text
    }
}
