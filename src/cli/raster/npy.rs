//! The one array format scripts exchange pictures in: NumPy's .npy, two dimensions, C order.

use wire4d::view::Image;
use wire4d::{Error, Result};

const MAGIC: &[u8] = b"\x93NUMPY";

/// A picture as .npy, 32-bit floats, rows from the top.
pub fn encode(width: usize, height: usize, data: &[f32]) -> Vec<u8> {
    let mut header = format!("{{'descr': '<f4', 'fortran_order': False, 'shape': ({height}, {width}), }}");
    // Magic, version, length, header and line end together fill whole blocks of 64 bytes.
    let before = MAGIC.len() + 4 + header.len() + 1;
    header.push_str(&" ".repeat(before.next_multiple_of(64) - before));
    header.push('\n');
    let mut bytes = [MAGIC, &[1, 0], &(header.len() as u16).to_le_bytes(), header.as_bytes()].concat();
    bytes.extend(data.iter().flat_map(|value| value.to_le_bytes()));
    bytes
}

/// A picture from .npy: two dimensions, C order, 8-bit unsigned (scaled to 0..1) or 32- or 64-bit floats.
///
/// # Errors
/// [`Error::Input`] if it is anything else, too short, or holds numbers that are not finite.
pub fn decode(name: &str, bytes: &[u8]) -> Result<Image> {
    let fail = |problem: &str| Error::input(name, problem, "give a two-dimensional .npy of floats, rows from the top");
    let (header, data) = split(bytes).ok_or_else(|| fail("is not a .npy file"))?;
    if field(header, "fortran_order").is_none_or(|value| !value.starts_with("False")) {
        return Err(fail("is not in C order"));
    }
    let shape = field(header, "shape").and_then(|value| value.strip_prefix('(')?.split(')').next());
    let sizes: Option<Vec<usize>> =
        shape.map(|s| s.split(',').map(str::trim).filter(|s| !s.is_empty()).flat_map(str::parse).collect());
    let Some([height, width]) = sizes.as_deref().and_then(|sizes| <[usize; 2]>::try_from(sizes).ok()) else {
        return Err(fail("does not have two dimensions"));
    };
    let kind = field(header, "descr").unwrap_or("");
    let count = height.checked_mul(width).filter(|&count| count <= data.len());
    let count = count.ok_or_else(|| fail("ends too early"))?;
    let data: Vec<f32> = if kind.starts_with("'<f4'") {
        data.chunks_exact(4).map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect()
    } else if kind.starts_with("'<f8'") {
        let wide = |b: &[u8]| f64::from_le_bytes([b[0], b[1], b[2], b[3], b[4], b[5], b[6], b[7]]) as f32;
        data.chunks_exact(8).map(wide).collect()
    } else if kind.starts_with("'|u1'") {
        data.iter().map(|&b| f32::from(b) / 255.0).collect()
    } else {
        return Err(fail("holds no floats"));
    };
    if data.len() != count {
        return Err(fail("does not hold as many numbers as it says"));
    }
    if data.iter().any(|value| !value.is_finite()) {
        return Err(fail("holds numbers that are not finite"));
    }
    Ok(Image { width, height, data })
}

fn split(bytes: &[u8]) -> Option<(&str, &[u8])> {
    let rest = bytes.strip_prefix(MAGIC)?;
    let (length, rest) = match rest.first()? {
        1 => (usize::from(u16::from_le_bytes([*rest.get(2)?, *rest.get(3)?])), rest.get(4..)?),
        2 | 3 => {
            let length = u32::from_le_bytes([*rest.get(2)?, *rest.get(3)?, *rest.get(4)?, *rest.get(5)?]);
            (length as usize, rest.get(6..)?)
        }
        _ => return None,
    };
    Some((std::str::from_utf8(rest.get(..length)?).ok()?, &rest[length..]))
}

/// What follows `'name':` in the header.
fn field<'a>(header: &'a str, name: &str) -> Option<&'a str> {
    let after = header.split(&format!("'{name}'")).nth(1)?;
    Some(after.trim_start().strip_prefix(':')?.trim_start())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::few_cases::few_cases;
    use proptest::prelude::*;

    #[test]
    fn round_trip_and_damage() {
        let data: Vec<f32> = (0..6).map(|i| i as f32 / 7.0).collect();
        let bytes = encode(3, 2, &data);
        assert_eq!(bytes.len() % 64, 24);
        assert_eq!(decode("a.npy", &bytes).unwrap(), Image { width: 3, height: 2, data });
        for end in 0..bytes.len() {
            assert!(decode("a.npy", &bytes[..end]).is_err(), "cut at {end}");
        }
        for i in 0..bytes.len() {
            let mut damaged = bytes.clone();
            damaged[i] ^= 0x41;
            let _ = decode("a.npy", &damaged);
        }
        let mut nan = bytes.clone();
        nan.splice(bytes.len() - 4.., f32::NAN.to_le_bytes());
        assert!(decode("a.npy", &nan).unwrap_err().to_string().contains("finite"));
    }

    /// Whatever was read is a picture of the size it says.
    fn sound(bytes: &[u8]) -> bool {
        match decode("any.npy", bytes) {
            Ok(image) => image.data.len() == image.width * image.height && image.data.iter().all(|v| v.is_finite()),
            Err(error) => error.is_bad_input(),
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 500, ..few_cases() })]

        #[test]
        fn any_bytes_are_survived(start in 0usize..4, bytes in prop::collection::vec(any::<u8>(), 0..200)) {
            // From nothing at all to a header that promises two megabytes of numbers.
            let starts: [&[u8]; 4] = [b"", MAGIC, b"\x93NUMPY\x01\0\x76\0", b"\x93NUMPY\x02\0\xff\xff\x1f\0"];
            prop_assert!(sound(&[starts[start], &bytes].concat()));
        }

        #[test]
        fn any_header_is_survived(
            descr in prop::sample::select(vec!["<f4", "<f8", "|u1", ">f4", "<f2", ""]),
            (height, width) in (any::<u64>(), any::<u64>()), small in any::<bool>(),
            data in prop::collection::vec(any::<u8>(), 0..128),
        ) {
            let (height, width) = if small { (height % 5, width % 5) } else { (height, width) };
            let header = format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': ({height}, {width}), }}\n");
            let bytes = [MAGIC, &[1, 0], &(header.len() as u16).to_le_bytes(), header.as_bytes(), &data].concat();
            prop_assert!(sound(&bytes));
            // Sibling: with just the data it promises, the header is fine.
            if small && descr == "|u1" {
                let whole = [&bytes[..bytes.len() - data.len()], &vec![255; (height * width) as usize]].concat();
                prop_assert_eq!(decode("any.npy", &whole).unwrap().data, vec![1.0; (height * width) as usize]);
            }
        }
    }
}
