//! What is drawn on: lengths in millimetres from the lower left corner, y up.

use glam::DVec2;
use pdf_writer::types::{LineCapStyle, LineJoinStyle};
use pdf_writer::{Content, Name, Str};

/// Points of a printer, 1/72 inch, in a millimetre.
pub const PT_PER_MM: f64 = 72.0 / 25.4;

/// A colour, 0 to 1.
#[derive(Debug, Clone, Copy)]
pub enum Ink {
    /// 0 is black.
    Grey(f64),
    /// What is new.
    Copper,
}

/// How a line looks.
#[derive(Debug, Clone, Copy)]
pub struct Pen {
    /// mm.
    pub width: f64,
    /// Its colour.
    pub ink: Ink,
    /// Length of dashes and of what is between them, mm.
    pub dash: Option<f64>,
}

impl Pen {
    /// Unbroken.
    pub fn new(width: f64, ink: Ink) -> Pen {
        Pen { width, ink, dash: None }
    }

    /// In dashes.
    pub fn dashed(self, mm: f64) -> Pen {
        Pen { dash: Some(mm), ..self }
    }
}

/// A page or a part of one.
pub struct Sheet(pub Content);

impl Sheet {
    /// A blank one.
    pub fn new() -> Sheet {
        let mut content = Content::new();
        content.set_line_cap(LineCapStyle::ButtCap).set_line_join(LineJoinStyle::RoundJoin);
        Sheet(content)
    }

    /// A line through places.
    pub fn line(&mut self, places: &[DVec2], pen: Pen) {
        let [first, rest @ ..] = places else { return };
        if rest.is_empty() {
            return;
        }
        match pen.ink {
            Ink::Grey(grey) => self.0.set_stroke_gray(grey as f32),
            Ink::Copper => self.0.set_stroke_rgb(0.72, 0.36, 0.14),
        };
        self.0.set_line_width(pt(pen.width)).set_dash_pattern(pen.dash.map(pt), 0.0);
        self.0.move_to(pt(first.x), pt(first.y));
        for place in rest {
            self.0.line_to(pt(place.x), pt(place.y));
        }
        self.0.stroke();
    }

    /// A filled dot.
    pub fn dot(&mut self, at: DVec2, radius: f64) {
        // A line of no length with round ends.
        self.0.save_state().set_line_cap(LineCapStyle::RoundCap);
        self.line(&[at, at], Pen::new(2.0 * radius, Ink::Grey(0.0)));
        self.0.restore_state();
    }

    /// Words, from their lower left; `height` mm is that of the letters with room for a line.
    pub fn text(&mut self, at: DVec2, height: f64, words: &str) {
        self.words(b"F0", at, height, words);
    }

    /// Words that stand out.
    pub fn heading(&mut self, at: DVec2, height: f64, words: &str) {
        self.words(b"F1", at, height, words);
    }

    /// A number that ends at a place.
    pub fn number(&mut self, ends: DVec2, height: f64, digits: &str) {
        self.text(ends - DVec2::new(width_of(digits) * height, 0.0), height, digits);
    }

    fn words(&mut self, font: &[u8], at: DVec2, height: f64, words: &str) {
        // What the built-in fonts have no letter for.
        let bytes: Vec<u8> =
            words.chars().map(|c| if c.is_ascii() && !c.is_ascii_control() { c as u8 } else { b'?' }).collect();
        self.0.set_fill_gray(0.0).begin_text().set_font(Name(font), pt(height));
        self.0.next_line(pt(at.x), pt(at.y)).show(Str(&bytes)).end_text();
    }

    /// A ruler of 100 mm, from its left end, with a mark every 10 mm.
    pub fn ruler(&mut self, at: DVec2) {
        let pen = Pen::new(0.25, Ink::Grey(0.0));
        self.line(&[at, at + DVec2::new(100.0, 0.0)], pen);
        for tenth in 0..=10 {
            let x = DVec2::new(10.0 * f64::from(tenth), 0.0);
            let height = if tenth % 5 == 0 { 4.0 } else { 2.5 };
            self.line(&[at + x, at + x + DVec2::new(0.0, height)], pen);
        }
        self.text(at + DVec2::new(102.0, 0.5), 2.8, "100 mm: measure it. Print at 100%, not fitted to the page.");
    }
}

/// Points of a printer.
pub fn pt(mm: f64) -> f32 {
    (mm * PT_PER_MM) as f32
}

/// Width of digits and signs in heights of Helvetica (Adobe's font metrics).
fn width_of(digits: &str) -> f64 {
    let wide = |c| match c {
        '.' | ' ' => 0.278,
        '-' => 0.333,
        '+' => 0.584,
        _ => 0.556,
    };
    digits.chars().map(wide).sum()
}

/// Lines of at most `width` mm, broken between words; letters are taken as wide as they are on average.
pub fn wrapped(words: &str, height: f64, width: f64) -> Vec<String> {
    let most = (width / (0.5 * height)) as usize;
    let mut lines: Vec<String> = Vec::new();
    for word in words.split_whitespace() {
        match lines.last_mut().filter(|line| line.len() + 1 + word.len() <= most) {
            Some(line) => {
                line.push(' ');
                line.push_str(word);
            }
            None => lines.push(word.to_owned()),
        }
    }
    lines
}
