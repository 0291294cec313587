//! What a browser says of its graphics card. `wgpu` passes little of it on.

use super::absence::Absence;
use js_sys::{Object, Promise, Reflect};
use wasm_bindgen::prelude::Closure;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::JsFuture;

/// How long a browser may take to find an adapter.
const PATIENCE_MS: i32 = 15_000;

/// What a browser calls its adapter.
pub(super) struct BrowserAdapter {
    pub name: String,
    /// Whether it computes on the processor and says so.
    pub is_fallback: bool,
}

/// The adapter that this page or worker would get.
///
/// # Errors
/// Every [`Absence`] but [`Absence::Unfit`] and [`Absence::Software`].
pub(super) async fn browser_adapter() -> Result<BrowserAdapter, Absence> {
    let global = js_sys::global();
    let gpu = get(&get(&global, "navigator"), "gpu");
    if !gpu.is_truthy() {
        let insecure = get(&global, "isSecureContext").as_bool() == Some(false);
        return Err(if insecure { Absence::Insecure } else { Absence::NoInterface });
    }
    let blocked = |error: JsValue| {
        let words = error.dyn_ref::<js_sys::Error>().map(|error| String::from(error.message()));
        Absence::Blocked(words.unwrap_or_else(|| "the browser does not say why".into()))
    };
    let options = Object::new();
    let _ = Reflect::set(&options, &"powerPreference".into(), &"high-performance".into());
    let request = get(&gpu, "requestAdapter").unchecked_into::<js_sys::Function>().call1(&gpu, &options);
    let answers = js_sys::Array::of2(&request.map_err(blocked)?, &silence());
    let adapter = JsFuture::from(Promise::race(&answers)).await.map_err(blocked)?;
    if !adapter.is_truthy() {
        return Err(Absence::NoAdapter);
    }
    let info = get(&adapter, "info");
    let word = |name: &str| get(&info, name).as_string().filter(|word| !word.is_empty());
    let parts: Vec<String> = [word("vendor"), word("architecture")].into_iter().flatten().collect();
    let name = word("description").unwrap_or_else(|| parts.join(" "));
    let is_fallback = [&info, &adapter].iter().any(|of| get(of, "isFallbackAdapter").is_truthy());
    Ok(BrowserAdapter { name, is_fallback })
}

/// Fails when a browser has had long enough to answer.
fn silence() -> Promise {
    Promise::new(&mut |_, reject| {
        let give_up = Closure::once_into_js(move || {
            let _ = reject.call1(&JsValue::NULL, &js_sys::Error::new("the browser does not answer"));
        });
        let set_timeout = get(&js_sys::global(), "setTimeout").unchecked_into::<js_sys::Function>();
        let _ = set_timeout.call2(&JsValue::NULL, &give_up, &PATIENCE_MS.into());
    })
}

/// A property, or undefined where there is none.
fn get(object: &JsValue, name: &str) -> JsValue {
    Reflect::get(object, &name.into()).unwrap_or(JsValue::UNDEFINED)
}
