//! A run as bytes: the session's state and what it must be resumed with.

use crate::optimize::Checkpoint;
use crate::settings::{Affects, Settings, TABLE};
use crate::view::Target;
use crate::{Error, Result};
use std::collections::BTreeMap;

/// The first bytes, the last of them the format's version.
const HEADING: [u8; 4] = *b"W4R\x02";
/// Heading and checksum.
const HEADING_BYTES: usize = 8;

/// What a run leaves behind.
#[derive(serde::Serialize, serde::Deserialize)]
pub(super) struct SavedRun {
    /// Fingerprint of the arranged drawings.
    pictures: u64,
    settings: BTreeMap<String, String>,
    session: Checkpoint,
}

impl SavedRun {
    pub(super) fn new(targets: &[Target], settings: &Settings, session: Checkpoint) -> SavedRun {
        SavedRun { pictures: fingerprint(targets), settings: settings.to_texts(), session }
    }

    pub(super) fn to_bytes(&self) -> Vec<u8> {
        let body = postcard::to_allocvec(self).expect("plain numbers, texts and lists always serialise");
        let mut bytes = Vec::with_capacity(HEADING_BYTES + body.len());
        bytes.extend(HEADING);
        bytes.extend(crc32fast::hash(&body).to_le_bytes());
        bytes.extend(body);
        bytes
    }

    /// # Errors
    /// [`Error::Input`] for anything but what [`SavedRun::to_bytes`] wrote.
    pub(super) fn from_bytes(bytes: &[u8]) -> Result<SavedRun> {
        let (name, version) = HEADING.split_at(3);
        if bytes.len() < HEADING_BYTES || !bytes.starts_with(name) {
            return Err(refused("these bytes are none of a run of Wire4D"));
        }
        if bytes[3] != version[0] {
            return Err(refused("it was saved by another version of Wire4D"));
        }
        let (heading, body) = bytes.split_at(HEADING_BYTES);
        if heading[4..] != crc32fast::hash(body).to_le_bytes() {
            return Err(refused("it is damaged"));
        }
        match postcard::take_from_bytes(body) {
            Ok((saved, [])) => Ok(saved),
            _ => Err(refused("it is damaged")),
        }
    }

    /// The session's state, if it can go on as part of this run.
    ///
    /// # Errors
    /// [`Error::Input`] for other drawings, [`Error::Setting`] for a setting that makes it another run.
    pub(super) fn for_run(self, targets: &[Target], settings: &Settings) -> Result<Checkpoint> {
        let now = settings.to_texts();
        let changed = |affected: Affects| {
            let differs = |name: &str| self.settings.get(name) != now.get(name);
            TABLE.iter().find(|row| row.affects.contains(&affected) && differs(row.name)).map(|row| row.name)
        };
        let refuse = |name: &str| {
            let text = |of: &BTreeMap<String, String>| of.get(name).cloned().unwrap_or_default();
            let (before, now) = (text(&self.settings), text(&now));
            let remedy = format!("set it back to {before}, or start a new run");
            Error::setting(name, format!("the run was begun with {before} and cannot go on with {now}"), remedy)
        };
        if let Some(name) = changed(Affects::State) {
            return Err(refuse(name));
        }
        if self.pictures != fingerprint(targets) {
            return Err(changed(Affects::Pictures).map_or_else(
                || Error::input("checkpoint", "it is of other drawings", "bring those back, or start a new run"),
                refuse,
            ));
        }
        let done = self.session.iteration();
        if settings.iterations < done {
            let problem = format!("the run has done {done} already, more than {}", settings.iterations);
            return Err(Error::setting("iterations", problem, format!("give at least {done}, or start a new run")));
        }
        Ok(if self.settings == now { self.session } else { self.session.without_best() })
    }
}

fn refused(problem: &str) -> Error {
    Error::input("checkpoint", problem, "start a new run")
}

/// A number that differs where the pictures or the sides they are seen from do (FNV-1a over words).
fn fingerprint(targets: &[Target]) -> u64 {
    let mut hash = 0xcbf2_9ce4_8422_2325u64;
    let mut mix = |word: u64| hash = (hash ^ word).wrapping_mul(0x0000_0100_0000_01b3).rotate_left(23);
    for Target { view, ink } in targets {
        let camera = view.camera::<f64>();
        for probe in [[0.0; 4], [0.3, 0.0, 0.0, 0.0], [0.0, 0.4, 0.0, 0.0], [0.0, 0.0, 0.5, 0.1]] {
            // To a thousandth of a pixel: the last bit of a sine is no other side.
            camera.project(&probe).iter().for_each(|c| mix((c * 1000.0).round() as i64 as u64));
        }
        mix(ink.width as u64);
        ink.data.iter().for_each(|value| mix(value.to_bits().into()));
    }
    hash
}
