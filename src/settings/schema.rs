//! What a row of the table says of a setting.

use super::Task;
use crate::Error;
use serde::Serialize;
use serde_json::Value;

/// Where a control is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum Group {
    /// What is run.
    Run,
    /// The wire's form and width.
    Wire,
    /// How the drawings are read and arranged.
    Views,
    /// How the wire is fitted.
    Fit,
    /// One picture: the solid behind it and what the wire draws of it.
    Stroke,
    /// A mesh: how the wire covers it, and in which style.
    Surface,
    /// For people who know the method.
    Expert,
}

/// What values a setting takes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum Kind {
    /// A whole number in `min..=max`.
    Integer {
        /// Smallest value.
        min: u64,
        /// Largest value.
        max: u64,
    },
    /// A number in `min..=max`.
    Number {
        /// Smallest value.
        min: f64,
        /// Largest value.
        max: f64,
    },
    /// One of a few words.
    Choice {
        /// The words.
        choices: &'static [&'static str],
    },
    /// On or off.
    Switch,
}

/// A task that has a setting.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Of {
    /// The task.
    pub task: Task,
    /// Its choices, where they are not the table's.
    pub choices: Option<&'static [&'static str]>,
}

/// What a setting changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "kebab-case")]
pub enum Affects {
    /// How the fit goes: a run may go on with another value.
    Course,
    /// The pictures that are fitted: a run with others is another run.
    Pictures,
    /// What a run's state consists of: no run goes on with another value.
    State,
    /// Where the curve runs that covers a mesh.
    Curve,
    /// Likewise, where it follows a style.
    StyledCurve,
    /// How the wire on that curve bends and thickens.
    Look,
    /// Likewise, where it takes on a style.
    StyledLook,
}

/// One row of the table.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Setting {
    /// Snake case; the flag is the same with dashes.
    pub name: &'static str,
    /// Where it is shown.
    pub group: Group,
    /// Unit for people, empty where there is none.
    pub unit: &'static str,
    /// One line of help.
    pub help: &'static str,
    /// Range or choices.
    #[serde(flatten)]
    pub kind: Kind,
    /// The tasks that have it.
    #[serde(skip)]
    pub of: &'static [Of],
    /// What other values of it change.
    pub affects: &'static [Affects],
}

impl Setting {
    pub(super) fn impossible(&self, name: &str, text: &str) -> Error {
        Error::setting(name, format!("{text:?} is not a possible value"), format!("give {}", self.kind.words()))
    }
}

impl Kind {
    /// Whether there is more than one value to choose from: what leaves no choice is not shown to people.
    pub fn leaves_choice(&self) -> bool {
        !matches!(self, Kind::Choice { choices: [_] })
    }

    pub(super) fn parse(&self, text: &str) -> Option<Value> {
        match *self {
            Kind::Integer { min, max } => {
                text.trim().parse::<u64>().ok().filter(|n| (min..=max).contains(n)).map(Value::from)
            }
            Kind::Number { min, max } => {
                text.trim().parse::<f64>().ok().filter(|x| (min..=max).contains(x)).map(Value::from)
            }
            Kind::Choice { choices } => choices.contains(&text.trim()).then(|| Value::from(text.trim())),
            Kind::Switch => match text.trim() {
                "on" | "true" | "yes" | "1" => Some(Value::from(true)),
                "off" | "false" | "no" | "0" => Some(Value::from(false)),
                _ => None,
            },
        }
    }

    /// The possible values in words.
    pub fn words(&self) -> String {
        match *self {
            Kind::Integer { min, max } => format!("a whole number from {min} to {max}"),
            Kind::Number { min, max } => format!("a number from {min} to {max}"),
            Kind::Choice { choices } => choices.join(", "),
            Kind::Switch => "on or off".to_owned(),
        }
    }
}
