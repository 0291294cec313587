//! A look into a run, for the page.

use crate::made::WireData;
use crate::pictures::Ink;
use wasm_bindgen::prelude::*;
use wire4d::optimize;

/// A run at one moment, taken apart.
#[wasm_bindgen]
pub struct Insight(pub(crate) optimize::Insight);

#[wasm_bindgen]
impl Insight {
    /// The wire whose control points are pulled.
    pub fn wire(&self) -> WireData {
        WireData(self.0.wire.clone())
    }

    /// How many views there are.
    #[wasm_bindgen(getter)]
    pub fn view_count(&self) -> usize {
        self.0.views.len()
    }

    /// What pulls, by name: a term for each view first.
    pub fn terms(&self) -> Vec<String> {
        self.0.pulls.iter().map(|pull| pull.name.clone()).collect()
    }

    /// Their weighted losses.
    pub fn losses(&self) -> Vec<f32> {
        self.0.pulls.iter().map(|pull| pull.loss).collect()
    }

    /// The gradient of one of them: x, y, z, width of each control point, again and again. The wire is pulled the other way.
    pub fn gradient(&self, term: usize) -> Vec<f32> {
        self.0.pulls[term].gradient.as_flattened().to_vec()
    }

    /// A view's weighted loss at every scale, finest first.
    pub fn levels(&self, view: usize) -> Vec<f32> {
        self.0.views[view].iter().map(|level| level.loss).collect()
    }

    /// What a view shows of the wire at a scale.
    pub fn seen(&self, view: usize, level: usize) -> Ink {
        Ink::new(&self.0.views[view][level].seen)
    }

    /// What it should show.
    pub fn wanted(&self, view: usize, level: usize) -> Ink {
        Ink::new(&self.0.views[view][level].wanted)
    }
}
