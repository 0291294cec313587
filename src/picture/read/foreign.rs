//! Files that people take for pictures and that are not read here, told by their first bytes.

/// A signature: where it is, what it is, what is wrong with such a file, what to do.
type Foreign = (usize, &'static [u8], &'static str, &'static str);

const AS_PNG: &str = "save or export it as a PNG picture";
const AS_JPEG: &str = "share or export it as a JPEG (phones: camera settings, “most compatible”)";
const HEIC: &str = "is a HEIC photo, which cannot be read";
const RAW: &str = "is a camera's raw file, which cannot be read";

const KNOWN: [Foreign; 22] = [
    (4, b"ftyphei", HEIC, AS_JPEG),
    (4, b"ftyphev", HEIC, AS_JPEG),
    (4, b"ftypmif1", HEIC, AS_JPEG),
    (4, b"ftypmsf1", HEIC, AS_JPEG),
    (4, b"ftypavi", "is an AVIF picture, which only the page can read", "save it as a PNG, or give it to the page"),
    (4, b"ftypcrx", RAW, AS_JPEG),
    (0, b"FUJIFILMCCD-RAW", RAW, AS_JPEG),
    (4, b"ftyp", "is a film", "take a still picture of it"),
    (0, b"%PDF", "is a PDF, not a picture", "export its page as an SVG or PNG picture"),
    (0, b"%!PS", "is a PostScript file, which cannot be read", "export it as an SVG or PNG picture"),
    (0, b"\xc5\xd0\xd3\xc6", "is a PostScript file, which cannot be read", "export it as an SVG or PNG picture"),
    (0, b"8BPS", "is a Photoshop file, which cannot be read", AS_PNG),
    (0, b"gimp xcf", "is a GIMP file, which cannot be read", AS_PNG),
    (0, b"\xff\x0a", "is a JPEG XL picture, which cannot be read", AS_PNG),
    (0, b"\0\0\0\x0cJXL ", "is a JPEG XL picture, which cannot be read", AS_PNG),
    (0, b"\0\0\0\x0cjP  ", "is a JPEG 2000 picture, which cannot be read", AS_PNG),
    (0, b"\xff\x4f\xff\x51", "is a JPEG 2000 picture, which cannot be read", AS_PNG),
    (0, b"\0\0\x01\0", "is an icon file, which cannot be read", AS_PNG),
    (0, b"PK\x03\x04", "is an archive, not a picture", "unpack it, or export the drawing as a PNG picture"),
    (0, b"<!DOCTYPE html", "is a web page, not a picture", "save the picture that the page shows"),
    (0, b"<!doctype html", "is a web page, not a picture", "save the picture that the page shows"),
    (0, b"<html", "is a web page, not a picture", "save the picture that the page shows"),
];

/// What is wrong with such a file, and what to do; `None` if it may be a picture.
pub fn named(bytes: &[u8]) -> Option<(&'static str, &'static str)> {
    let is = |&&(at, signature, ..): &&Foreign| bytes.get(at..).is_some_and(|rest| rest.starts_with(signature));
    KNOWN.iter().find(is).map(|&(_, _, problem, remedy)| (problem, remedy))
}
