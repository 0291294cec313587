//! Settings from texts and back, and what values they may have.

use super::words::*;
use super::{Affects, Settings, TABLE};
use crate::{Error, Result};
use serde_json::Value;
use std::collections::BTreeMap;

impl Settings {
    /// The preset asked for (`preset` among the pairs, else `best`) with every other pair laid over it in order, not yet
    /// checked. Whether the wire is kept smooth chooses among presets, too.
    ///
    /// # Errors
    /// As [`Settings::set`].
    pub(crate) fn laid_over<'a>(
        presets: fn(Preset, OnOff) -> Settings,
        pairs: impl IntoIterator<Item = (&'a str, &'a str)> + Clone,
    ) -> Result<Settings> {
        let mut settings = presets(Preset::Best, OnOff::On);
        let (mut preset, mut smooth) = (Preset::Best, None);
        for (name, text) in pairs.clone() {
            match &*name.replace('-', "_") {
                "preset" => {
                    settings.set(name, text)?;
                    preset = settings.preset;
                }
                "smooth" => {
                    settings.set(name, text)?;
                    smooth = Some(settings.smooth);
                }
                _ => {}
            }
        }
        settings = presets(preset, smooth.unwrap_or(preset.smooth()));
        for (name, text) in pairs {
            settings.set(name, text)?;
        }
        Ok(settings)
    }

    /// Sets one value from text. Dashes and underscores are the same.
    ///
    /// # Errors
    /// [`Error::Setting`] when the name is unknown, or the value is not of its kind or out of range.
    pub fn set(&mut self, name: &str, text: &str) -> Result<()> {
        let key = name.replace('-', "_");
        let Some(row) = TABLE.iter().find(|row| row.name == key) else {
            let nearest = nearest_name(&key);
            return Err(Error::setting(name, "there is no such setting", format!("did you mean {nearest}?")));
        };
        let value = row.kind.parse(text).ok_or_else(|| row.impossible(name, text))?;
        let mut all = serde_json::to_value(&*self).map_err(|_| row.impossible(name, text))?;
        all[row.name] = value;
        *self = serde_json::from_value(all).map_err(|_| row.impossible(name, text))?;
        Ok(())
    }

    /// Checks every range, and what single ranges cannot say.
    ///
    /// # Errors
    /// [`Error::Setting`] for a value out of its range, and when settings contradict each other.
    pub fn check(&self) -> Result<()> {
        let texts = self.to_texts();
        for row in TABLE {
            let text = texts.get(row.name).map_or("", String::as_str);
            row.kind.parse(text).ok_or_else(|| row.impossible(row.name, text))?;
        }
        if self.min_width > self.max_width {
            return Err(Error::setting(
                "min_width",
                format!("{} is more than max_width {}", self.min_width, self.max_width),
                "lower it or raise max_width",
            ));
        }
        if (1..4).contains(&self.control_points) {
            return Err(Error::setting(
                "control_points",
                format!("a wire needs at least 4, not {}", self.control_points),
                "give 4 to 20000, or 0 to let the start choose",
            ));
        }
        Ok(())
    }

    /// For a wire of constant width: of least and greatest width one given stands for both.
    pub(crate) fn one_width(&mut self, given: &[&str]) -> Result<()> {
        let is_given = |name: &str| given.iter().any(|given| given.replace('-', "_") == name);
        match (is_given("min_width"), is_given("max_width")) {
            (true, true) if self.min_width != self.max_width => {
                let problem = format!("constant, but from {} to {}", self.min_width, self.max_width);
                Err(Error::setting("width", problem, "give one of min_width and max_width, both the same, or neither"))
            }
            (true, false) => {
                self.max_width = self.min_width;
                Ok(())
            }
            (false, true) => {
                self.min_width = self.max_width;
                Ok(())
            }
            _ => Ok(()),
        }
    }

    /// Every value by name, for files and reports.
    pub fn to_map(&self) -> serde_json::Map<String, Value> {
        match serde_json::to_value(self) {
            Ok(Value::Object(map)) => map,
            _ => serde_json::Map::new(),
        }
    }

    /// Values of the settings that affect something, in the table's order.
    pub fn texts_affecting(&self, what: Affects) -> Vec<String> {
        let mut texts = self.to_texts();
        let rows = TABLE.iter().filter(|row| row.affects.contains(&what));
        rows.map(|row| texts.remove(row.name).unwrap_or_default()).collect()
    }

    /// Every value by name as the text that [`Settings::set`] takes.
    pub fn to_texts(&self) -> BTreeMap<String, String> {
        let text = |value: Value| value.as_str().map_or_else(|| value.to_string(), str::to_owned);
        let mut texts = BTreeMap::new();
        texts.extend(self.to_map().into_iter().map(|(name, value)| (name, text(value))));
        texts
    }
}

/// The setting whose name shares the most letter pairs with `name`.
fn nearest_name(name: &str) -> &'static str {
    let pairs = |s: &str| s.as_bytes().windows(2).map(<[u8]>::to_vec).collect::<Vec<_>>();
    let given = pairs(name);
    TABLE
        .iter()
        .max_by_key(|row| {
            let shared = pairs(row.name).iter().filter(|pair| given.contains(pair)).count();
            (shared * 100).checked_div(row.name.len() + name.len()).unwrap_or(0)
        })
        .map_or("preset", |row| row.name)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn from_pairs<'a>(pairs: impl IntoIterator<Item = (&'a str, &'a str)> + Clone) -> Result<Settings> {
        let presets = |preset, _| {
            let start = if preset == Preset::Paper { Start::Ball } else { Start::Circuit };
            Settings { preset, start, ..Settings::default() }
        };
        let settings = Settings::laid_over(presets, pairs)?;
        settings.check().map(|()| settings)
    }

    #[test]
    fn table_and_struct_name_the_same_settings_and_defaults_are_in_range() {
        for settings in
            [Settings::default(), Settings { preset: Preset::Paper, start: Start::Ball, ..Settings::default() }]
        {
            let texts = settings.to_texts();
            assert_eq!(texts.len(), TABLE.len());
            let pairs = texts.iter().map(|(name, text)| (name.as_str(), text.as_str()));
            assert_eq!(from_pairs(pairs), Ok(settings), "texts say it all");
            for row in TABLE {
                let text = &texts[row.name];
                assert!(row.kind.parse(text).is_some(), "{}: {text} is outside {}", row.name, row.kind.words());
                assert!(!row.help.is_empty() && row.help.ends_with('.'), "{} needs a line of help", row.name);
            }
        }
    }

    #[test]
    fn pairs_lie_over_the_preset_whatever_their_order() {
        let settings = from_pairs([("iterations", "7"), ("preset", "paper"), ("min-width", "0.5")]).unwrap();
        assert_eq!((settings.iterations, settings.start, settings.min_width), (7, Start::Ball, 0.5));
    }

    #[test]
    fn nonsense_is_refused_with_the_name_and_a_remedy() {
        for (name, text) in [
            ("itterations", "5"),
            ("iterations", "-1"),
            ("iterations", "NaN"),
            ("min-width", "inf"),
            ("bend", "lots"),
            ("control-points", "3"),
            ("control-points", "20001"),
            ("reinit", "perhaps"),
        ] {
            let error = from_pairs([(name, text)]).unwrap_err();
            assert!(matches!(error, Error::Setting { .. }), "{name}={text} gave {error:?}");
        }
        let error = from_pairs([("itterations", "5")]).unwrap_err().to_string();
        assert!(error.contains("did you mean iterations?"), "{error}");
        assert!(from_pairs([("min-width", "9"), ("max-width", "2")]).is_err());
    }

    #[test]
    fn what_was_set_by_hand_is_held_to_the_same_ranges() {
        assert_eq!(Settings::default().check(), Ok(()));
        for (name, settings) in [
            ("size", Settings { size: 0, ..Settings::default() }),
            ("smoothness", Settings { smoothness: f64::NAN, ..Settings::default() }),
            ("smoothness", Settings { smoothness: -1.0, ..Settings::default() }),
            ("max_width", Settings { max_width: f64::INFINITY, ..Settings::default() }),
        ] {
            let line = settings.check().unwrap_err().to_string();
            assert!(line.starts_with(name) && line.contains("give a"), "{line}");
        }
    }
}
