//! Pages and drawings that several pages share, put together.

use super::Paper;
use super::sheet::{Sheet, pt};
use glam::DVec2;
use pdf_writer::{Content, Finish, Name, Pdf, Rect, Ref, TextStr};

/// A PDF being made.
pub struct Document {
    pub paper: Paper,
    pages: Vec<Content>,
    drawings: Vec<(Rect, Content)>,
}

/// A drawing that pages can show.
#[derive(Debug, Clone, Copy)]
pub struct Drawing(usize);

impl Document {
    /// Without a page yet.
    pub fn new(paper: Paper) -> Document {
        Document { paper, pages: Vec::new(), drawings: Vec::new() }
    }

    /// Adds a page.
    pub fn page(&mut self, sheet: Sheet) {
        self.pages.push(sheet.0);
    }

    /// Keeps a drawing, whose places lie between `low` and `high`, for pages to show.
    pub fn drawing(&mut self, sheet: Sheet, low: DVec2, high: DVec2) -> Drawing {
        self.drawings.push((Rect::new(pt(low.x), pt(low.y), pt(high.x), pt(high.y)), sheet.0));
        Drawing(self.drawings.len() - 1)
    }

    /// The file.
    pub fn finish(self, title: &str) -> Vec<u8> {
        let mut pdf = Pdf::new();
        let mut last = 0;
        let mut next = || {
            last += 1;
            Ref::new(last)
        };
        let [catalog, tree, info, plain, bold] = [(); 5].map(|()| next());
        let drawings: Vec<Ref> = self.drawings.iter().map(|_| next()).collect();
        let pages: Vec<[Ref; 2]> = self.pages.iter().map(|_| [next(), next()]).collect();
        pdf.catalog(catalog).pages(tree);
        pdf.pages(tree).kids(pages.iter().map(|[page, _]| *page)).count(pages.len() as i32);
        pdf.document_info(info).title(TextStr(title)).creator(TextStr("Wire4D"));
        for (font, name) in [(plain, b"Helvetica" as &[u8]), (bold, b"Helvetica-Bold")] {
            pdf.type1_font(font).base_font(Name(name)).encoding_predefined(Name(b"WinAnsiEncoding"));
        }
        for (id, (bounds, content)) in drawings.iter().zip(self.drawings) {
            let bytes = content.finish();
            let mut form = pdf.form_xobject(*id, &bytes);
            form.bbox(bounds);
            form.resources().fonts().pair(Name(b"F0"), plain).pair(Name(b"F1"), bold);
        }
        let [width, height] = self.paper.size_mm().map(pt);
        for ([id, stream], content) in pages.iter().zip(self.pages) {
            let mut page = pdf.page(*id);
            page.media_box(Rect::new(0.0, 0.0, width, height)).parent(tree).contents(*stream);
            let mut resources = page.resources();
            resources.fonts().pair(Name(b"F0"), plain).pair(Name(b"F1"), bold);
            let mut shared = resources.x_objects();
            for (i, drawing) in drawings.iter().enumerate() {
                shared.pair(Name(name(i).as_bytes()), *drawing);
            }
            shared.finish();
            resources.finish();
            page.finish();
            pdf.stream(*stream, &content.finish());
        }
        pdf.finish()
    }
}

impl Sheet {
    /// Shows the part of a drawing that lies in a window of the page, moved by `by`.
    pub fn show(&mut self, drawing: Drawing, window: [DVec2; 2], by: DVec2) {
        let [low, high] = window;
        let size = high - low;
        self.0.save_state().rect(pt(low.x), pt(low.y), pt(size.x), pt(size.y)).clip_nonzero().end_path();
        self.0.transform([1.0, 0.0, 0.0, 1.0, pt(by.x), pt(by.y)]);
        self.0.x_object(Name(name(drawing.0).as_bytes())).restore_state();
    }
}

fn name(drawing: usize) -> String {
    format!("D{drawing}")
}
