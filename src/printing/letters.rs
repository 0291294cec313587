//! Letters of single strokes, which a nozzle draws well.

use crate::body::{self, Body};
use glam::DVec2;
use wire4d_core::{Error, Result};

/// Each with its strokes on a grid 4 wide and 6 high, a digit a coordinate.
const LETTERS: [(char, &str); 48] = [
    ('A', "00 26 40|12 32"),
    ('B', "00 06 36 45 44 33 03|33 42 41 30 00"),
    ('C', "45 36 16 05 01 10 30 41"),
    ('D', "00 06 26 44 42 20 00"),
    ('E', "40 00 06 46|03 33"),
    ('F', "00 06 46|03 33"),
    ('G', "45 36 16 05 01 10 30 41 43 23"),
    ('H', "00 06|40 46|03 43"),
    ('I', "20 26|10 30|16 36"),
    ('J', "46 41 30 10 01"),
    ('K', "00 06|46 03 40"),
    ('L', "06 00 40"),
    ('M', "00 06 23 46 40"),
    ('N', "00 06 40 46"),
    ('O', "10 01 05 16 36 45 41 30 10"),
    ('P', "00 06 36 45 44 33 03"),
    ('Q', "10 01 05 16 36 45 41 30 10|22 40"),
    ('R', "00 06 36 45 44 33 03|23 40"),
    ('S', "45 36 16 05 04 13 33 42 41 30 10 01"),
    ('T', "20 26|06 46"),
    ('U', "06 01 10 30 41 46"),
    ('V', "06 20 46"),
    ('W', "06 10 23 30 46"),
    ('X', "00 46|06 40"),
    ('Y', "06 23 46|23 20"),
    ('Z', "06 46 00 40"),
    ('0', "10 01 05 16 36 45 41 30 10|12 34"),
    ('1', "15 26 20|10 30"),
    ('2', "05 16 36 45 44 00 40"),
    ('3', "05 16 36 45 44 33 13|33 42 41 30 10 01"),
    ('4', "30 36 02 42"),
    ('5', "46 06 03 33 42 41 30 10 01"),
    ('6', "45 36 16 05 01 10 30 41 42 33 03"),
    ('7', "06 46 10"),
    ('8', "13 04 05 16 36 45 44 33 13 02 01 10 30 41 42 33"),
    ('9', "01 10 30 41 45 36 16 05 04 13 43"),
    (' ', ""),
    ('-', "13 33"),
    ('.', "20 20"),
    (',', "21 10"),
    ('\'', "26 25"),
    ('!', "26 22|20 20"),
    ('?', "05 16 36 45 44 23 22|20 20"),
    ('&', "40 05 16 36 35 01 10 20 42"),
    ('+', "03 43|21 25"),
    ('/', "00 46"),
    (':', "21 21|24 24"),
    ('=', "02 42|04 44"),
];
/// From a letter's left side to the next one's, in grid steps.
const ADVANCE: f64 = 5.8;
/// Of a stroke, in grid steps.
const STROKE: f64 = 1.1;

/// A line of text, as letters can be printed.
#[derive(Debug, Clone, PartialEq)]
pub struct Line(Vec<&'static str>);

impl Line {
    /// Small letters become capitals.
    ///
    /// # Errors
    /// [`Error::Setting`] for an empty or very long text, or a letter that there is not.
    pub fn new(setting: &str, text: &str) -> Result<Line> {
        /// More do not fit a plate.
        const MOST: usize = 40;
        let text = text.trim();
        if text.is_empty() || text.chars().count() > MOST {
            let problem = format!("a name has 1 to {MOST} letters, not {}", text.chars().count());
            return Err(Error::setting(setting, problem, "give another name"));
        }
        let strokes = |c: char| {
            let capital = c.to_ascii_uppercase();
            LETTERS.iter().find(|(letter, _)| *letter == capital).map(|(_, strokes)| *strokes).ok_or_else(|| {
                let remedy = "use A to Z, 0 to 9, spaces and - . , ' ! ? & + / : =";
                Error::setting(setting, format!("{c:?} is no letter that can be printed"), remedy)
            })
        };
        text.chars().map(strokes).collect::<Result<_>>().map(Line)
    }

    /// How wide it is, as a share of its height.
    pub fn aspect(&self) -> f64 {
        (ADVANCE * (self.0.len() as f64 - 1.0) + 4.0 + STROKE) / (6.0 + STROKE)
    }

    /// Standing letters, their box's left lower corner at `corner`; one body a stroke's stretch.
    pub fn bodies(&self, corner: DVec2, height: f64, levels: [f64; 2]) -> Vec<Body> {
        let step = height / (6.0 + STROKE);
        let place = |letter: usize, digits: &str| {
            let digit = |i: usize| f64::from(digits.as_bytes()[i] - b'0');
            corner + step * (DVec2::new(digit(0) + ADVANCE * letter as f64, digit(1)) + 0.5 * STROKE)
        };
        let mut bodies = Vec::new();
        for (letter, strokes) in self.0.iter().enumerate() {
            for stroke in strokes.split('|').filter(|stroke| !stroke.is_empty()) {
                let places: Vec<DVec2> = stroke.split(' ').map(|digits| place(letter, digits)).collect();
                for ends in places.windows(2) {
                    let corners = ends.iter().flat_map(|&end| body::round(end, 0.5 * step * STROKE, 12));
                    let corners = corners.flat_map(|p| levels.map(|level| p.extend(level)));
                    bodies.push(Body::hull(&corners.collect::<Vec<_>>()));
                }
            }
        }
        bodies
    }
}
