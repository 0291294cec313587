//! The core as the page's worker sees it: a wasm-bindgen façade and no maths. Numbers cross as typed arrays, small
//! things as JSON, errors as the core's own sentences.

mod crew;
mod guidance;
mod hands;
mod insight;
mod made;
mod pictures;
mod preview;
mod run;
mod subject;
mod surface;

use std::collections::BTreeMap;
use wasm_bindgen::prelude::*;
use wire4d::settings::{OnOff, Preset, Settings, Task};
use wire4d::{Error, Result};

/// Panics become readable errors in the browser's console.
#[wasm_bindgen(start)]
fn start() {
    console_error_panic_hook::set_once();
}

/// The settings table of a task, `multiview`, `stroke` or `fill`, and each preset's values, as JSON: by its word, and by its
/// word and the other choice of `smooth` (`best/off`).
#[wasm_bindgen]
pub fn settings_table(task: &str) -> Result<String, JsError> {
    let task = task_of(task)?;
    let mut presets = BTreeMap::new();
    for (&preset, word) in Preset::ALL.iter().zip(Preset::WORDS) {
        for (&smooth, choice) in OnOff::ALL.iter().zip(OnOff::WORDS) {
            let name = if smooth == preset.smooth() { (*word).to_owned() } else { format!("{word}/{choice}") };
            presets.insert(name, task.preset_with(preset, smooth).to_texts());
        }
    }
    let rows: Vec<_> = task.rows().filter(|row| row.kind.leaves_choice()).collect();
    Ok(json(&serde_json::json!({ "rows": rows, "presets": presets })))
}

fn task_of(word: &str) -> Result<Task> {
    let unknown =
        || Error::setting("task", format!("there is none called {word:?}"), Task::ALL.map(Task::name).join(" or "));
    Task::ALL.into_iter().find(|task| task.name() == word).ok_or_else(unknown)
}

/// Where a fit with this `backend` (a word of the setting) will be computed, and why, as JSON: `{backend, device, why}`.
#[wasm_bindgen]
pub async fn place(backend: String) -> Result<String, JsError> {
    let settings = Task::Multiview.settings([("backend", backend.as_str())])?;
    Ok(json(&wire4d::tasks::place(settings.backend).await?))
}

/// The browser's device (a `GPUDevice`) that fits are computed on, if there is one by now: for others to compute on the same
/// card. It is lent, and not to be destroyed.
#[cfg(target_arch = "wasm32")]
#[wasm_bindgen(unchecked_return_type = "GPUDevice | undefined")]
pub fn graphics_device() -> JsValue {
    wire4d::tasks::browser_device().unwrap_or(JsValue::UNDEFINED)
}

/// How far the best device, be it a program, is from the processor on a spiral and on hostile wires, as JSON. With a
/// `skew` other than 1 every comparison must fail.
#[wasm_bindgen]
pub async fn parities(skew: f32) -> Result<String, JsError> {
    use wire4d::gpu::{Device, GpuEngine, Kind};
    let device = Device::acquire_async(Kind::Any).await.map_err(Error::from)?;
    Ok(json(&wire4d::gpu::parities(&mut GpuEngine::new(&device, ""), skew).await))
}

/// Settings from a JSON object of texts by name.
fn parse_settings(task: Task, text: &str) -> Result<Settings> {
    let pairs: BTreeMap<String, String> = serde_json::from_str(text)
        .map_err(|error| Error::setting("settings", error.to_string(), "give an object of texts by name"))?;
    task.settings(pairs.iter().map(|(name, value)| (name.as_str(), value.as_str())))
}

/// JSON of values whose serialisation cannot fail: plain numbers, texts and lists.
fn json(value: &impl serde::Serialize) -> String {
    serde_json::to_string(value).unwrap_or_default()
}
