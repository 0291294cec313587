//! PLY, in words or binary of either order: elements `vertex` (x, y, z), `face` (a list of corners) and `tristrips` (lists
//! of strips, with -1 between them). All else is passed over, whatever it holds.

use super::decimals::{Decimals, Fault};
use super::{MAX_TRIANGLES, Soup, check_count, damaged};
use crate::{Error, Result};

/// A type of number.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Number {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Number {
    fn named(word: &[u8]) -> Option<Number> {
        Some(match word.to_ascii_lowercase().as_slice() {
            b"char" | b"int8" => Number::I8,
            b"uchar" | b"uint8" => Number::U8,
            b"short" | b"int16" => Number::I16,
            b"ushort" | b"uint16" => Number::U16,
            b"int" | b"int32" => Number::I32,
            b"uint" | b"uint32" => Number::U32,
            b"float" | b"float32" => Number::F32,
            b"double" | b"float64" => Number::F64,
            _ => return None,
        })
    }

    fn bytes(self) -> usize {
        match self {
            Number::I8 | Number::U8 => 1,
            Number::I16 | Number::U16 => 2,
            Number::I32 | Number::U32 | Number::F32 => 4,
            Number::F64 => 8,
        }
    }

    /// From its bytes, lowest first.
    fn value(self, b: [u8; 8]) -> f64 {
        match self {
            Number::I8 => f64::from(b[0] as i8),
            Number::U8 => f64::from(b[0]),
            Number::I16 => f64::from(i16::from_le_bytes([b[0], b[1]])),
            Number::U16 => f64::from(u16::from_le_bytes([b[0], b[1]])),
            Number::I32 => f64::from(i32::from_le_bytes([b[0], b[1], b[2], b[3]])),
            Number::U32 => f64::from(u32::from_le_bytes([b[0], b[1], b[2], b[3]])),
            Number::F32 => f64::from(f32::from_le_bytes([b[0], b[1], b[2], b[3]])),
            Number::F64 => f64::from_le_bytes(b),
        }
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Format {
    Words,
    Little,
    Big,
}

/// A property of an element; a list says how many it has first, as another type of number.
#[derive(Debug)]
struct Property {
    name: Vec<u8>,
    list: Option<Number>,
    number: Number,
}

#[derive(Debug)]
struct Element {
    kind: Vec<u8>,
    count: usize,
    properties: Vec<Property>,
}

pub(super) fn is_ply(text: &[u8]) -> bool {
    text.get(..3).is_some_and(|start| start.eq_ignore_ascii_case(b"ply"))
        && text.get(3).is_some_and(u8::is_ascii_whitespace)
}

pub(super) fn read(name: &str, bytes: &[u8]) -> Result<Soup> {
    let (format, elements, rest) = header(name, bytes)?;
    for element in &elements {
        match &element.kind[..] {
            b"face" => check_count(name, element.count)?,
            // As many corners as triangles without a common one have.
            b"vertex" if element.count > 3 * MAX_TRIANGLES => {
                let problem = format!("has {} corners, more than {MAX_TRIANGLES} triangles need", element.count);
                return Err(Error::input(name, problem, "reduce it in a modelling program (decimate, simplify)"));
            }
            _ => {}
        }
    }
    let mut payload = Payload { format, rest, decimals: Decimals::default() };
    let mut soup = Soup::default();
    for element in &elements {
        payload.element(name, element, &mut soup)?;
    }
    if soup.triangles.is_empty() && !soup.positions.is_empty() {
        return Err(Error::input(name, "holds points without faces", "make a surface of them in a modelling program"));
    }
    Ok(soup)
}

/// What the header says, and what follows it.
fn header<'a>(name: &str, bytes: &'a [u8]) -> Result<(Format, Vec<Element>, &'a [u8])> {
    // A line feed ends a line, after a carriage return or not; in old files it is the carriage return alone. The next byte
    // after the last line is data, whatever it is.
    let first = bytes.iter().position(|byte| b"\r\n".contains(byte)).map_or(&[][..], |at| &bytes[at..]);
    let end = if first.starts_with(b"\r") && !first.starts_with(b"\r\n") { b'\r' } else { b'\n' };
    let (mut format, mut elements) = (None, Vec::<Element>::new());
    let mut rest = bytes;
    while let Some(length) = rest.iter().position(|&byte| byte == end) {
        let line = &rest[..length];
        rest = &rest[length + 1..];
        let unclear = || {
            let line: String = String::from_utf8_lossy(line).trim().chars().take(40).collect();
            damaged(name, format!("has a header line that says nothing: \"{line}\""))
        };
        let words: Vec<&[u8]> = line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty()).take(6).collect();
        match words[..] {
            [] | [b"comment" | b"obj_info", ..] => {}
            [magic] if magic.eq_ignore_ascii_case(b"ply") => {}
            [b"format", kind, ..] => {
                format = Some(match kind {
                    b"ascii" => Format::Words,
                    b"binary_little_endian" => Format::Little,
                    b"binary_big_endian" => Format::Big,
                    _ => return Err(unclear()),
                });
            }
            [b"element", kind, count] => {
                let count = std::str::from_utf8(count).ok().and_then(|count| count.parse().ok()).ok_or_else(unclear)?;
                elements.push(Element { kind: kind.to_ascii_lowercase(), count, properties: Vec::new() });
            }
            [b"property", ref about @ ..] => {
                let (list, number, called) = match *about {
                    [b"list", count, number, called] => {
                        (Some(Number::named(count).ok_or_else(unclear)?), number, called)
                    }
                    [number, called] => (None, number, called),
                    _ => return Err(unclear()),
                };
                let number = Number::named(number).ok_or_else(unclear)?;
                let element = elements.last_mut().ok_or_else(unclear)?;
                element.properties.push(Property { name: called.to_ascii_lowercase(), list, number });
            }
            [b"end_header"] => {
                let format = format.ok_or_else(|| damaged(name, "does not say its format"))?;
                return Ok((format, elements, rest));
            }
            _ => return Err(unclear()),
        }
    }
    Err(damaged(name, "ends within its header"))
}

/// What follows the header, as far as it is not read yet.
struct Payload<'a> {
    format: Format,
    rest: &'a [u8],
    decimals: Decimals,
}

/// Why there is no number.
enum Gap {
    End,
    Bad(Fault),
}

impl<'a> Payload<'a> {
    /// Reads all of an element into the soup, or past it.
    fn element(&mut self, name: &str, element: &Element, soup: &mut Soup) -> Result<()> {
        let kind = String::from_utf8_lossy(&element.kind[..element.kind.len().min(30)]).into_owned();
        let (corner, face, strips) = (kind == "vertex", kind == "face", kind == "tristrips");
        if element.properties.is_empty() {
            // There is nothing to read, however many there are.
            return Ok(());
        }
        let axis = |property: &Property| [b"x", b"y", b"z"].iter().position(|axis| property.name == *axis);
        if corner && (0..3).any(|c| !element.properties.iter().any(|p| p.list.is_none() && axis(p) == Some(c))) {
            return Err(damaged(name, "has corners without x, y and z"));
        }
        let is_corners = |property: &Property| {
            (face || strips)
                && property.list.is_some()
                && matches!(&property.name[..], b"vertex_indices" | b"vertex_index")
        };
        let mut corners = Vec::new();
        for i in 0..element.count {
            let gap = |gap: Gap| match gap {
                Gap::End => damaged(name, format!("ends after {i} of {} times {kind}", element.count)),
                Gap::Bad(fault) => fault.at(name, &format!("{kind} {i}")),
            };
            let mut point = [0.0; 3];
            for property in &element.properties {
                match property.list {
                    Some(count) if is_corners(property) => {
                        self.list(count, property.number, &mut corners).map_err(gap)?;
                        check_count(name, soup.triangles.len() + corners.len().saturating_sub(2))?;
                        if face {
                            soup.add_polygon(&corners);
                        } else {
                            soup.add_strips(&corners);
                        }
                    }
                    Some(count) => {
                        let count = self.count(count).map_err(gap)?;
                        self.skip(count, property.number).map_err(gap)?;
                    }
                    None => match axis(property).filter(|_| corner) {
                        Some(c) => point[c] = self.number(property.number).map_err(gap)?,
                        None => self.skip(1, property.number).map_err(gap)?,
                    },
                }
            }
            if corner {
                soup.positions.push(point);
            }
        }
        Ok(())
    }

    fn number(&mut self, number: Number) -> Result<f64, Gap> {
        if self.format == Format::Words {
            let word = self.word()?;
            return self.decimals.number(word).map_err(Gap::Bad);
        }
        let (here, rest) = self.rest.split_at_checked(number.bytes()).ok_or(Gap::End)?;
        self.rest = rest;
        let mut bytes = [0; 8];
        bytes[..here.len()].copy_from_slice(here);
        if self.format == Format::Big {
            bytes[..here.len()].reverse();
        }
        Ok(number.value(bytes))
    }

    /// How many a list has.
    fn count(&mut self, number: Number) -> Result<usize, Gap> {
        let count = self.number(number)?;
        if count >= 0.0 && count.fract() == 0.0 { Ok(count as usize) } else { Err(Gap::Bad(Fault::Word)) }
    }

    /// The corners of a list; what is no corner's number is as far out of range as can be.
    fn list(&mut self, count: Number, number: Number, corners: &mut Vec<u32>) -> Result<(), Gap> {
        corners.clear();
        for _ in 0..self.count(count)? {
            let corner = self.number(number)?;
            let whole = corner >= 0.0 && corner.fract() == 0.0;
            corners.push(if whole { corner as u32 } else { u32::MAX });
        }
        Ok(())
    }

    fn skip(&mut self, count: usize, number: Number) -> Result<(), Gap> {
        if self.format == Format::Words {
            for _ in 0..count {
                self.word()?;
            }
        } else {
            let bytes = count.checked_mul(number.bytes()).ok_or(Gap::End)?;
            self.rest = self.rest.get(bytes..).ok_or(Gap::End)?;
        }
        Ok(())
    }

    /// The next word, in whatever line.
    fn word(&mut self) -> Result<&'a [u8], Gap> {
        let start = self.rest.iter().position(|byte| !byte.is_ascii_whitespace()).ok_or(Gap::End)?;
        let words = &self.rest[start..];
        let (word, rest) = words.split_at(words.iter().position(u8::is_ascii_whitespace).unwrap_or(words.len()));
        self.rest = rest;
        Ok(word)
    }
}

impl Soup {
    /// Adds strips of triangles, each turned against the one before it, with [`u32::MAX`] between strips. Corners that are
    /// there twice only lead on.
    fn add_strips(&mut self, corners: &[u32]) {
        for strip in corners.split(|&corner| corner == u32::MAX) {
            for (i, triangle) in strip.windows(3).enumerate() {
                let [a, b, c] = [triangle[0], triangle[1 + i % 2], triangle[2 - i % 2]];
                if a != b && b != c && c != a {
                    self.triangles.push([a, b, c]);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CORNERS: &str = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
    const POINTS: &str = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n";
    const FACE: &str = "element face 1\nproperty list uchar int vertex_indices\n";

    fn triangles(words: &str) -> Vec<[u32; 3]> {
        read("a.ply", words.as_bytes()).unwrap_or_else(|error| panic!("{words}: {error}")).triangles
    }

    fn problem(words: &str) -> String {
        read("a.ply", words.as_bytes()).expect_err(words).to_string()
    }

    #[test]
    fn more_corners_than_a_mesh_needs_are_refused() {
        let start = format!("ply\nformat ascii 1.0\n{}", CORNERS.replace('4', "1500001"));
        let error = problem(&format!("{start}{FACE}end_header\n"));
        assert!(error.contains("1500001 corners, more than 500000 triangles need"), "{error}");
        let error = problem(&format!("ply\nformat ascii 1.0\n{}end_header\n", FACE.replace('1', "500001")));
        assert!(error.contains("500001 triangles"), "{error}");
    }

    #[test]
    fn headers_of_all_kinds() {
        let plain = format!("ply\nformat ascii 1.0\n{CORNERS}{FACE}end_header\n{POINTS}3 0 1 2\n");
        for (what, instead) in [
            ("", ""),
            ("ply\n", "ply \n\n"),
            ("ply\n", "PLY\n"),
            ("format", "comment\ncomment  caf\u{e9} end_header\nobj_info num_cols 512\nformat"),
            ("element face", "\n  element\tface"),
            ("float", "float32"),
            ("float", "DOUBLE"),
            ("uchar int", "uint8 int32"),
            ("uchar int", "int uint16"),
            ("vertex_indices", "vertex_index"),
            ("end_header\n", "end_header \n\n"),
            ("\n0 1 0", "\n\n\t0  1\t0 \n"),
            ("element face", "element junk 99999999999\nelement face"),
            ("element face", "element FACE"),
            ("ascii 1.0\n", "ascii 1.0\r\n"),
            ("element face", "element junk 0\nproperty float x\nelement face"),
        ] {
            let words = plain.replace(what, instead);
            for words in [words.replace('\n', "\r\n"), words.replace('\n', "\r"), words] {
                assert_eq!(triangles(&words), [[0, 1, 2]], "{words:?}");
            }
        }
    }

    #[test]
    fn what_nobody_needs_may_be_anything() {
        let words = format!(
            "ply\nformat ascii 1.0\nelement camera 2\nproperty float f\nproperty list uchar float x\n\
             {CORNERS}property float quality\n\
             element face 1\nproperty int flags\nproperty list uchar int vertex_indices\nproperty list uchar float uv\n\
             end_header\nnan 0\n-1.#IND 2 x y\n{}7 3 0 1 2 6 nan 0 -inf 0 1 2,5\n",
            POINTS.replace('\n', " nan\n")
        );
        assert_eq!(triangles(&words), [[0, 1, 2]]);
        let error = problem(&words.replacen("1 0 0", "1 0 1,#QNAN", 1));
        assert!(error.contains("vertex 1 has a corner that is not three numbers"), "{error}");
    }

    #[test]
    fn strips_part_at_minus_one() {
        let strips = "element tristrips 1\nproperty list int int vertex_indices\n";
        let words = |list: &str| format!("ply\nformat ascii 1.0\n{CORNERS}{strips}end_header\n{POINTS}{list}\n");
        assert_eq!(triangles(&words("4 0 1 2 3")), [[0, 1, 2], [1, 3, 2]]);
        assert_eq!(triangles(&words("8 0 1 2 -1 1 2 3 -1")), [[0, 1, 2], [1, 2, 3]]);
        assert_eq!(triangles(&words("6 0 1 2 2 2 3")), [[0, 1, 2]], "corners that are there twice lead on");
    }

    #[test]
    fn what_is_wrong_is_said() {
        let plain = format!("ply\nformat ascii 1.0\n{CORNERS}{FACE}end_header\n{POINTS}3 0 1 2\n");
        for (what, instead, says) in [
            ("format ascii", "format klingon", "\"format klingon 1.0\""),
            ("format ascii 1.0\n", "", "does not say its format"),
            ("float y", "floaty y", "\"property floaty y\""),
            ("float y", "float w", "without x, y and z"),
            ("vertex 4", "vertex four", "\"element vertex four\""),
            ("vertex 4", "vertex 9", "ends after 5 of 9 times vertex"),
            ("end_header", "", "header"),
            ("3 0 1 2", "3 0 1", "ends after 0 of 1 times face"),
            ("3 0 1 2", "-3 0 1 2", "face 0"),
            ("1 0 0", "1,5 0.5 0", "decimal commas"),
            ("3 0 1 2", "0", "points without faces"),
        ] {
            let error = problem(&plain.replacen(what, instead, 1));
            assert!(error.contains(says), "{instead}: {error}");
        }
    }
}
