//! Building as the page's worker sees it: a module of its own, which takes wires as wire.json files.

use serde::{Deserialize, Serialize};
use wasm_bindgen::prelude::*;
use wire4d::sculpture::Sculpture;
use wire4d::{Error, Result};
use wire4d_fabrication::{BendList, Centreline, Check, Job, Metal, Paper, Stock, steps};
use wire4d_printing::{Gauge, Plate, Printer, Strands, jig, print, stl, three_mf};

/// What somebody wants to build it of, and how large; millimetres.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
struct Wishes {
    /// What it is called on paper and on a plate.
    name: String,
    size_mm: f64,
    wire_mm: f64,
    metal: String,
    stock_mm: f64,
    paper: String,
    /// Whether a print stands on a plate with its name.
    plate: bool,
}

/// What the page shows of it.
#[derive(Serialize)]
struct Told<'a> {
    passes: bool,
    sentences: &'a [String],
    length_mm: f64,
    mass_g: f64,
    bends: usize,
    /// The centreline, mm from the middle of its box: x, y, z of each point.
    points: Vec<[f32; 3]>,
    closed: bool,
    steps: Vec<ToldStep>,
}

/// A step of bending: points `from` to `to` are new.
#[derive(Serialize)]
struct ToldStep {
    from: usize,
    to: usize,
    azimuth_deg: f64,
    elevation_deg: f64,
    sentence: String,
}

/// Whether and how it can be built, as JSON.
#[wasm_bindgen]
pub fn check(file: &[u8], wishes: &str) -> Result<String, JsError> {
    let bench = Bench::new(file, wishes)?;
    let (list, check) = (bench.bends(), bench.check()?);
    let sentences = check.sentences(&bench.stock);
    let line = &bench.line;
    let at = |mm: f64| ((mm / line.step_mm()).round() as usize).min(line.points().len() - 1);
    let steps = steps(line, &list).into_iter().map(|step| ToldStep {
        from: at(step.from_mm),
        to: at(step.to_mm),
        azimuth_deg: step.side.azimuth_deg,
        elevation_deg: step.side.elevation_deg,
        sentence: step.sentence(),
    });
    let told = Told {
        passes: check.passes,
        sentences: &sentences,
        length_mm: check.length_mm,
        mass_g: check.mass_g,
        bends: list.bends.len(),
        points: line.points().iter().map(|point| point.as_vec3().to_array()).collect(),
        closed: line.closed(),
        steps: steps.collect(),
    };
    Ok(serde_json::to_string(&told).unwrap_or_default())
}

/// A file of it: `pdf`, `csv` or `md` of the bends, `stl` or `3mf` of the print, `jig` for the jig's parts as one 3MF.
#[wasm_bindgen]
pub fn made(file: &[u8], wishes: &str, kind: &str) -> Result<Vec<u8>, JsError> {
    Ok(Bench::new(file, wishes)?.made(kind)?)
}

struct Bench {
    sculpture: Sculpture,
    wishes: Wishes,
    stock: Stock,
    line: Centreline,
}

impl Bench {
    fn new(file: &[u8], wishes: &str) -> Result<Bench> {
        let sculpture = Sculpture::from_json("wire.json", file)?;
        let wishes: Wishes = serde_json::from_str(wishes)
            .map_err(|problem| Error::setting("build", problem.to_string(), "reload the page"))?;
        let metal = Metal::named(&wishes.metal).unwrap_or_default();
        let stock = Stock { metal, gauge_mm: wishes.wire_mm, length_mm: wishes.stock_mm };
        let line = Centreline::new(&sculpture.wire, wishes.size_mm, wishes.wire_mm)?;
        Ok(Bench { sculpture, wishes, stock, line })
    }

    fn check(&self) -> Result<Check> {
        Check::new(&self.sculpture.wire, &self.line, &self.stock)
    }

    fn bends(&self) -> BendList {
        BendList::new(&self.line, self.stock.metal)
    }

    fn strands(&self) -> Result<Strands> {
        Strands::new(&self.sculpture.wire, self.wishes.size_mm, Gauge::Constant(self.wishes.wire_mm))
    }

    fn made(&self, kind: &str) -> Result<Vec<u8>> {
        match kind {
            "stl" => Ok(stl(&self.print()?.mesh)),
            "3mf" => {
                Ok(three_mf(&[wire4d_printing::Part { name: self.wishes.name.clone(), mesh: self.print()?.mesh }]))
            }
            "jig" => Ok(three_mf(&jig(&self.strands()?, &Printer::default())?.parts)),
            "csv" => Ok(self.bends().csv().into_bytes()),
            "md" => Ok(self.bends().table(&self.check()?, &self.stock).into_bytes()),
            _ => {
                let (bends, check) = (self.bends(), self.check()?);
                let steps = steps(&self.line, &bends);
                let job = Job {
                    name: &self.wishes.name,
                    line: &self.line,
                    stock: &self.stock,
                    check: &check,
                    bends: &bends,
                    steps: &steps,
                };
                Ok(job.pdf(Paper::named(&self.wishes.paper).unwrap_or_default()))
            }
        }
    }

    fn print(&self) -> Result<wire4d_printing::Print> {
        let plate =
            self.wishes.plate.then(|| Plate { name: Some(self.wishes.name.clone()).filter(|name| !name.is_empty()) });
        print(&self.strands()?, plate.as_ref())
    }
}
