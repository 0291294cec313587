//! What each task makes of the table: presets of its own, and what it refuses.

use super::{fill, multiview, stroke};
use crate::settings::{Bend, OnOff, Preset, Setting, Settings, TABLE, Task, Width};
use crate::{Error, Result};

/// A task's own part of its settings.
pub(super) struct TaskSettings {
    /// Its defaults.
    pub(super) preset: fn(Preset, OnOff) -> Settings,
    /// Refuses what ranges and choices cannot say.
    pub(super) check: fn(&Settings) -> Result<()>,
}

/// The widest least bend, and the widest least strand, that leave room for anything else in a picture of 256 px.
const WIDEST_BEND_PX: f64 = 64.0;
const WIDEST_STRAND_PX: f64 = 24.0;

impl Task {
    fn registered(self) -> &'static TaskSettings {
        match self {
            Task::Multiview => &multiview::settings::OWN,
            Task::Stroke => &stroke::settings::OWN,
            Task::Fill => &fill::settings::OWN,
        }
    }

    /// Refuses values out of range, and choices of another task.
    ///
    /// # Errors
    /// As [`Settings::check`], and [`Error::Setting`] for a choice that this task does not have.
    pub fn check(self, settings: &Settings) -> Result<()> {
        settings.check()?;
        check_smooth(settings)?;
        (self.registered().check)(settings)?;
        let values = settings.to_texts();
        let foreign = |row: &&Setting| {
            let value = values.get(row.name).map_or("", String::as_str);
            self.choices(row).is_some_and(|choices| !choices.contains(&value))
        };
        TABLE.iter().find(foreign).map_or(Ok(()), |row| Err(self.refused(row.name, settings)))
    }

    /// Its settings of a preset.
    pub fn preset(self, preset: Preset) -> Settings {
        (self.registered().preset)(preset, preset.smooth())
    }

    /// Its settings of a preset, with the wire kept smooth or not.
    pub fn preset_with(self, preset: Preset, smooth: OnOff) -> Settings {
        (self.registered().preset)(preset, smooth)
    }

    /// The preset asked for (`preset` among the pairs, else `best`) with every other pair laid over it in order.
    ///
    /// # Errors
    /// As [`Settings::set`] and [`Task::check`], and [`Error::Setting`] for a setting that this task does not have.
    pub fn settings<'a>(self, pairs: impl IntoIterator<Item = (&'a str, &'a str)> + Clone) -> Result<Settings> {
        for (name, _) in pairs.clone() {
            let is_named = |row: &&Setting| row.name == name.replace('-', "_");
            let foreign = |row: &Setting| !self.has(row);
            if TABLE.iter().find(is_named).is_some_and(foreign) {
                return Err(Error::setting(
                    name,
                    "is for another kind of task and would do nothing here",
                    "leave it out",
                ));
            }
        }
        let given: Vec<&str> = pairs.clone().into_iter().map(|(name, _)| name).collect();
        let mut settings = Settings::laid_over(self.registered().preset, pairs)?;
        if settings.width == Width::Constant {
            settings.one_width(&given)?;
        }
        self.check(&settings)?;
        Ok(settings)
    }
}

/// What the wire cannot be at once.
fn check_smooth(settings: &Settings) -> Result<()> {
    if settings.smooth == OnOff::Off {
        return Ok(());
    }
    let least = settings.bend_radius * settings.min_width;
    if least > WIDEST_BEND_PX {
        let widest = WIDEST_BEND_PX / settings.min_width.max(f64::MIN_POSITIVE);
        let problem = format!(
            "{} diameters of a wire at least {} px wide are {least:.0} px, and no such bend fits into a picture of 256 px",
            settings.bend_radius, settings.min_width
        );
        return Err(Error::setting("bend_radius", problem, format!("give at most {widest:.1}, or a thinner wire")));
    }
    if settings.min_width > WIDEST_STRAND_PX {
        let problem = format!("strands at least {} px wide cannot pass each other", settings.min_width);
        let remedy = format!("give at most {WIDEST_STRAND_PX}, or --smooth off");
        return Err(Error::setting("min_width", problem, remedy));
    }
    Ok(())
}

/// What one picture and one mesh share: there is nothing to agree with.
pub(super) fn one_thing(preset: Preset, smooth: OnOff) -> Settings {
    let several = (multiview::settings::OWN.preset)(preset, OnOff::Off);
    Settings { smooth, bend: Bend::None, arrange: OnOff::Off, ..several }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::settings::Start;

    #[test]
    fn tasks_share_settings_but_not_all_of_their_choices() {
        let of = |task: Task, name: &str| task.rows().find(|row| row.name == name).map(|row| row.kind);
        assert_eq!(of(Task::Multiview, "hatch"), None);
        assert_eq!(of(Task::Stroke, "density"), None);
        assert!(of(Task::Fill, "density").is_some());
        assert_eq!(of(Task::Stroke, "may_swap"), None);
        for name in ["spacing", "shorter", "grid"] {
            assert!(of(Task::Multiview, name).is_some());
            assert_eq!(of(Task::Fill, name), None, "a curve over a mesh asks for no {name}");
        }
        assert!(of(Task::Stroke, "spacing").is_some());
        assert_eq!(of(Task::Stroke, "size"), of(Task::Multiview, "size"));
        assert_ne!(of(Task::Stroke, "start"), of(Task::Multiview, "start"));
        for task in [Task::Multiview, Task::Stroke, Task::Fill] {
            for &preset in Preset::ALL {
                task.check(&task.preset(preset)).unwrap();
            }
        }
    }

    #[test]
    fn a_start_of_another_task_is_refused() {
        for (task, start) in
            [(Task::Multiview, Start::Contour), (Task::Stroke, Start::Circuit), (Task::Fill, Start::Hull)]
        {
            let settings = Settings { start, ..task.preset(Preset::Best) };
            let line = task.check(&settings).unwrap_err().to_string();
            assert!(line.starts_with("start: ") && line.contains("another kind of task; give "), "{line}");
        }
    }

    #[test]
    fn a_setting_of_another_task_is_refused_by_its_name() {
        let foreign = [
            (Task::Fill, "object", "3"),
            (Task::Fill, "hatch", "5"),
            (Task::Fill, "grid", "64"),
            (Task::Stroke, "may-swap", "on"),
            (Task::Stroke, "shorter", "on"),
            (Task::Multiview, "density", "0.2"),
        ];
        for (task, name, value) in foreign {
            let error = task.settings([(name, value)]).unwrap_err().to_string();
            assert!(error.starts_with(&format!("{name}: is for another kind of task")), "{error}");
        }
        assert!(Task::Fill.settings([("densitty", "3")]).unwrap_err().to_string().contains("did you mean density?"));
    }

    #[test]
    fn a_wire_that_no_hand_could_bend_is_refused_with_what_would_work() {
        let refused = |task: Task, pairs: &[(&str, &str)]| match task.settings(pairs.iter().copied()) {
            Err(Error::Setting { name, remedy, .. }) => (name, remedy),
            other => panic!("{pairs:?} gave {other:?}"),
        };
        let (name, remedy) = refused(Task::Multiview, &[("bend-radius", "20"), ("min-width", "5")]);
        assert!(name == "bend_radius" && remedy.contains("at most 12.8"), "{name}: {remedy}");
        let wide = [("min-width", "30"), ("max-width", "40")];
        let (name, remedy) = refused(Task::Multiview, &wide);
        assert!(name == "min_width" && remedy.contains("at most 24"), "{name}: {remedy}");
        assert!(Task::Multiview.settings(wide.into_iter().chain([("smooth", "off")])).is_ok());
        let (name, remedy) = refused(Task::Fill, &[("min-width", "4"), ("curve-spacing", "0.03")]);
        assert!(name == "min_width" && remedy.contains("curve_spacing"), "{name}: {remedy}");
    }

    #[test]
    fn of_a_constant_width_one_bound_stands_for_both_and_two_must_agree() {
        let widths = |pairs: &[(&str, &str)]| {
            let all = pairs.iter().copied().chain([("width", "constant")]).collect::<Vec<_>>();
            Task::Multiview.settings(all).map(|settings| [settings.min_width, settings.max_width])
        };
        assert_eq!(widths(&[("min-width", "3")]), Ok([3.0, 3.0]));
        assert_eq!(widths(&[("max-width", "1")]), Ok([1.0, 1.0]), "below the usual least");
        assert_eq!(widths(&[("min-width", "2"), ("max-width", "2")]), Ok([2.0, 2.0]));
        assert_eq!(widths(&[]), Task::Multiview.settings([]).map(|usual| [usual.min_width, usual.max_width]));
        let error = widths(&[("min-width", "2"), ("max-width", "3")]).unwrap_err().to_string();
        assert!(error.starts_with("width: constant, but from 2 to 3"), "{error}");
    }

    #[test]
    fn smooth_off_brings_the_numbers_of_before_back_whatever_the_order() {
        for pairs in [[("smooth", "off"), ("preset", "fast")], [("preset", "fast"), ("smooth", "off")]] {
            let settings = Task::Multiview.settings(pairs).unwrap();
            assert_eq!((settings.iterations, settings.spacing, settings.max_width), (220, 3.5, 20.0));
        }
        assert_eq!(Task::Multiview.settings([("preset", "paper")]).unwrap().smooth, OnOff::Off);
        assert_eq!(Task::Multiview.settings([("preset", "paper"), ("smooth", "on")]).unwrap().smooth, OnOff::On);
    }

    #[test]
    fn a_choice_of_another_task_is_refused_and_the_own_ones_named() {
        let refused = |task: Task, name, value| match task.settings([(name, value)]) {
            Err(Error::Setting { name: named, remedy, .. }) => (named, remedy),
            other => panic!("{other:?}"),
        };
        assert_eq!(refused(Task::Stroke, "start", "tree"), ("start".into(), "give contour or hull or ball".into()));
        assert_eq!(
            refused(Task::Multiview, "start", "contour"),
            ("start".into(), "give circuit or tree or hull or ball".into())
        );
        assert_eq!(refused(Task::Stroke, "bend", "free"), ("bend".into(), "give none".into()));
        assert!(Task::Stroke.settings([("bend", "none"), ("arrange", "off"), ("start", "ball")]).is_ok());
    }
}
