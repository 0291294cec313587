//! Everything on paper, as a PDF: what was checked, the wire at true size, the bend list, and the steps as pictures.

mod document;
mod pages;
mod sheet;
mod views;

#[cfg(test)]
mod tests;

use crate::{BendList, Centreline, Check, Step, Stock};
use document::Document;
use glam::DVec2;

/// What is in the printer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Paper {
    /// 210 x 297 mm.
    #[default]
    A4,
    /// 8.5 x 11 inches.
    Letter,
}

impl Paper {
    /// All of them.
    pub const ALL: [Paper; 2] = [Paper::A4, Paper::Letter];

    /// As people write it.
    pub fn name(self) -> &'static str {
        match self {
            Paper::A4 => "a4",
            Paper::Letter => "letter",
        }
    }

    /// The paper of that name.
    pub fn named(name: &str) -> Option<Paper> {
        Paper::ALL.into_iter().find(|paper| paper.name() == name)
    }

    /// Width and height, mm.
    pub fn size_mm(self) -> [f64; 2] {
        match self {
            Paper::A4 => [210.0, 297.0],
            Paper::Letter => [215.9, 279.4],
        }
    }

    fn size(self) -> DVec2 {
        DVec2::from_array(self.size_mm())
    }
}

/// A wire, what it is bent from, and how.
#[derive(Debug, Clone, Copy)]
pub struct Job<'a> {
    /// What people call it.
    pub name: &'a str,
    /// The wire at its size.
    pub line: &'a Centreline,
    /// What it is bent from.
    pub stock: &'a Stock,
    /// Whether it can be.
    pub check: &'a Check,
    /// How.
    pub bends: &'a BendList,
    /// In what steps.
    pub steps: &'a [Step],
}

impl Job<'_> {
    /// All pages as a PDF. Print it at 100%, without fitting it to the page: a ruler of 100 mm on it says whether that went well.
    pub fn pdf(&self, paper: Paper) -> Vec<u8> {
        let mut document = Document::new(paper);
        let views = views::views(self.line);
        let sheets = views.iter().map(|view| view.tiles(paper).len()).sum::<usize>();
        pages::cover(&mut document, self, (sheets > views::MOST_SHEETS).then_some(sheets));
        if sheets <= views::MOST_SHEETS {
            for view in &views {
                view.draw(&mut document);
            }
        }
        pages::bends(&mut document, self);
        pages::steps(&mut document, self);
        document.finish(self.name)
    }
}
