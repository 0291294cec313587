//! Views that other workers compute: both ends of the messages, which JavaScript carries.

use js_sys::{Function, Promise, Uint8Array};
use send_wrapper::SendWrapper;
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::JsFuture;
use wire4d::Error;
use wire4d::optimize::{self, Answer, Courier, Work};

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** Brings a message to a `Mate` at once, and its answer later, in the order of the messages. */
export type Ask = (message: Uint8Array<ArrayBuffer>) => Promise<Uint8Array>;
"#;

#[wasm_bindgen]
extern "C" {
    /// A function after `Ask`.
    #[wasm_bindgen(typescript_type = "Ask")]
    pub type Ask;
}

/// A mate that a function asks. A page's worker is one thread: what it made stays there.
pub struct Asked(SendWrapper<Function>);

impl Asked {
    /// One that `ask` asks.
    pub fn new(ask: Ask) -> Asked {
        Asked(SendWrapper::new(JsValue::from(ask).unchecked_into()))
    }
}

impl Courier for Asked {
    fn ask(&mut self, message: &[u8]) -> Answer {
        let promise = self.0.call1(&JsValue::NULL, &Uint8Array::from(message));
        Work::later(async move {
            let lost = |_| Error::device("the worker that computes views", "it failed", "the run goes on without it");
            let answer = JsFuture::from(Promise::resolve(&promise.map_err(lost)?)).await.map_err(lost)?;
            Ok(answer.dyn_into::<Uint8Array>().map_err(lost)?.to_vec())
        })
    }
}

/// Computes views for the run of another worker: see [`Run::hire`](crate::run::Run::hire).
#[wasm_bindgen]
#[derive(Default)]
pub struct Mate(optimize::Mate);

#[wasm_bindgen]
impl Mate {
    /// One that knows of nothing yet.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Mate {
        Mate::default()
    }

    /// Does what a message says, and answers it.
    pub fn answer(&mut self, message: &[u8]) -> Result<Vec<u8>, JsError> {
        Ok(self.0.answer(message)?)
    }
}
