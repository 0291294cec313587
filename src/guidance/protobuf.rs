//! As much of protobuf's wire format as it takes to walk an ONNX file and to write a changed one.
//!
//! Source: the encoding chapter of protobuf's documentation. A message is a row of fields; a field is a key (its number
//! and how its value is stored), then the value.

/// Why a walk ended early.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Damaged;

/// A field's value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Value<'a> {
    /// An integer of up to 64 bits.
    Integer(u64),
    /// Eight bytes, little-endian.
    Eight(u64),
    /// Text, bytes, a message, or numbers one after the other.
    Bytes(&'a [u8]),
    /// Four bytes, little-endian: in ONNX always a float32.
    Four(u32),
}

/// A field of a message.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Field<'a> {
    /// Its number, by which a message's description tells what it is.
    pub number: u64,
    /// Its value.
    pub value: Value<'a>,
    /// Key and value as they stand in the message.
    pub whole: &'a [u8],
}

impl<'a> Field<'a> {
    /// The value's bytes; none of a number.
    pub fn bytes(&self) -> &'a [u8] {
        if let Value::Bytes(bytes) = self.value { bytes } else { &[] }
    }

    /// The value as text; nothing of a number or of what is not UTF-8.
    pub fn text(&self) -> &'a str {
        std::str::from_utf8(self.bytes()).unwrap_or("")
    }

    /// The value as a number; zero of bytes.
    pub fn integer(&self) -> i64 {
        if let Value::Integer(value) = self.value { value as i64 } else { 0 }
    }
}

/// The fields of a message, in their order. Ends after the first [`Damaged`].
pub fn fields(message: &[u8]) -> impl Iterator<Item = Result<Field<'_>, Damaged>> {
    let mut rest = message;
    std::iter::from_fn(move || {
        if rest.is_empty() {
            return None;
        }
        let begin = rest;
        let field = value(&mut rest);
        if field.is_none() {
            rest = &[];
        }
        let whole = &begin[..begin.len() - rest.len()];
        Some(field.map(|(number, value)| Field { number, value, whole }).ok_or(Damaged))
    })
}

fn value<'a>(rest: &mut &'a [u8]) -> Option<(u64, Value<'a>)> {
    let key = varint(rest)?;
    let value = match key & 7 {
        0 => Value::Integer(varint(rest)?),
        1 => Value::Eight(u64::from_le_bytes(rest.split_off(..8)?.try_into().ok()?)),
        2 => {
            let length = usize::try_from(varint(rest)?).ok()?;
            Value::Bytes(rest.split_off(..length)?)
        }
        5 => Value::Four(u32::from_le_bytes(rest.split_off(..4)?.try_into().ok()?)),
        _ => return None,
    };
    Some((key >> 3, value))
}

/// Seven bits a byte, lowest first; the eighth says whether more follow.
fn varint(rest: &mut &[u8]) -> Option<u64> {
    let mut value = 0;
    for shift in (0..64).step_by(7) {
        let byte = *rest.split_off_first()?;
        value |= u64::from(byte & 127) << shift;
        if byte < 128 {
            return Some(value);
        }
    }
    None
}

/// A message being written.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Message(pub Vec<u8>);

impl Message {
    /// Adds an integer.
    pub fn integer(&mut self, number: u64, value: i64) {
        self.varint(number << 3);
        self.varint(value as u64);
    }

    /// Adds a float32.
    pub fn float(&mut self, number: u64, value: f32) {
        self.varint(number << 3 | 5);
        self.0.extend_from_slice(&value.to_le_bytes());
    }

    /// Adds text, bytes or a message.
    pub fn bytes(&mut self, number: u64, value: &[u8]) {
        self.varint(number << 3 | 2);
        self.varint(value.len() as u64);
        self.0.extend_from_slice(value);
    }

    fn varint(&mut self, mut value: u64) {
        while value >= 128 {
            self.0.push(value as u8 | 128);
            value >>= 7;
        }
        self.0.push(value as u8);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read() {
        let mut message = Message::default();
        message.integer(1, 300);
        message.integer(20, -1);
        message.float(2, 0.5);
        message.bytes(4000, b"text");
        let read: Vec<_> = fields(&message.0).collect::<Result<_, _>>().unwrap();
        assert_eq!(read.iter().map(|field| field.number).collect::<Vec<_>>(), [1, 20, 2, 4000]);
        assert_eq!((read[0].integer(), read[1].integer(), read[3].text()), (300, -1, "text"));
        assert_eq!(read[2].value, Value::Four(0.5f32.to_bits()));
        assert_eq!(read.iter().flat_map(|field| field.whole).copied().collect::<Vec<_>>(), message.0);
        // The example of protobuf's documentation: field 1 holds 150.
        assert_eq!(fields(&[0x08, 0x96, 0x01]).next().unwrap().unwrap().integer(), 150);
    }

    #[test]
    fn a_message_cut_anywhere_ends_or_is_damaged() {
        let mut message = Message::default();
        message.bytes(3, &[7; 200]);
        message.float(5, 1.0);
        for length in 1..message.0.len() {
            let whole = fields(&message.0[..length]).all(|field| field.is_ok());
            assert_eq!(whole, length == 203, "{length}");
        }
        assert!(fields(&[255; 12]).next().unwrap().is_err());
        assert!(fields(&[0x0a, 255, 255, 255, 255, 255, 255, 255, 255, 255, 1]).next().unwrap().is_err());
    }
}
