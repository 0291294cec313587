//! The tasks there are, and what each has of the table: which settings, and which of their choices.

use super::{Kind, Setting, Settings, TABLE};
use crate::Error;

/// A task with settings of its own.
///
/// ```
/// use wire4d::settings::Task;
///
/// # fn main() -> wire4d::Result<()> {
/// // By their names, as text, over those of a preset.
/// let settings = Task::Multiview.settings([("preset", "fast"), ("seed", "7")])?;
/// assert_eq!(settings.seed, 7);
/// let refused = Task::Multiview.settings([("seed", "seven")]).unwrap_err();
/// assert!(refused.to_string().contains("seed"));
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Task {
    /// Drawings for several sides.
    Multiview,
    /// One picture.
    Stroke,
    /// A mesh.
    Fill,
}

impl Task {
    /// All of them.
    pub const ALL: [Task; 3] = [Task::Multiview, Task::Stroke, Task::Fill];

    /// Its name in files, reports and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Task::Multiview => "multiview",
            Task::Stroke => "stroke",
            Task::Fill => "fill",
        }
    }

    /// The settings it has, in the order people should see them, with the choices that it has.
    pub fn rows(self) -> impl Iterator<Item = Setting> {
        TABLE.iter().filter(move |row| self.has(row)).map(move |row| match self.choices(row) {
            Some(choices) => Setting { kind: Kind::Choice { choices }, ..*row },
            None => *row,
        })
    }

    pub(crate) fn has(self, row: &Setting) -> bool {
        row.of.iter().any(|of| of.task == self)
    }

    /// The choices it has where they are not the table's.
    pub(crate) fn choices(self, row: &Setting) -> Option<&'static [&'static str]> {
        row.of.iter().find(|of| of.task == self)?.choices
    }

    /// Says that a choice is another task's.
    pub(crate) fn refused(self, name: &'static str, settings: &Settings) -> Error {
        let value = settings.to_texts().remove(name).unwrap_or_default();
        let row = TABLE.iter().find(|row| row.name == name);
        let choices = row.and_then(|row| self.choices(row)).unwrap_or_default().join(" or ");
        Error::setting(name, format!("{value:?} is for another kind of task"), format!("give {choices}"))
    }
}
