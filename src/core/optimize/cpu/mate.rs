//! The other end of a [`Crew`](super::crew::Crew): computes some views of somebody else's scene.

use super::super::RasterKind;
use super::message::{Order, Reader, Writer, masks_of, wrong};
use super::view::ViewEngine;
use crate::Result;
use crate::objective::Pyramid;
use crate::raster::Part;
use crate::wire::{LinearMap, Stroke};

/// Computes views for an engine whose memory it does not share, from messages alone. See
/// [`Courier`](super::crew::Courier) for how they come here.
#[derive(Default)]
pub struct Mate {
    scene: Option<Scene>,
    seats: Vec<Seat>,
    samples: Vec<[f32; 4]>,
    level_ratio: f32,
}

struct Scene {
    sampling: LinearMap<f32>,
    strokes: Vec<Stroke>,
    raster: RasterKind,
    pyramid: Pyramid,
}

/// A view, or a part of one.
struct Seat {
    number: usize,
    part: Part,
    view: ViewEngine,
    /// Where the part that it drew last lies; empty before.
    masks: Vec<u32>,
}

impl Mate {
    /// One that knows of nothing yet.
    pub fn new() -> Mate {
        Mate::default()
    }

    /// Does what a message says, and answers it.
    ///
    /// # Errors
    /// [`Error::Device`](crate::Error::Device) for a message that no engine sends; what came before the fault in it is done.
    pub fn answer(&mut self, message: &[u8]) -> Result<Vec<u8>> {
        let (mut reader, mut writer) = (Reader(message), Writer::default());
        while !reader.is_empty() {
            self.obey(&mut reader, &mut writer)?;
        }
        Ok(writer.0)
    }

    fn obey(&mut self, reader: &mut Reader, writer: &mut Writer) -> Result<()> {
        match reader.order()? {
            Order::Scene => {
                let (sampling, strokes, raster, pyramid) = reader.scene()?;
                self.seats.clear();
                self.samples.clear();
                self.samples.resize(sampling.rows().len(), [0.0; 4]);
                self.scene = Some(Scene { sampling, strokes, raster, pyramid });
            }
            Order::View => self.sit(reader)?,
            Order::Target => {
                let number = reader.count()?;
                let seat = self.seat(number)?;
                reader.fill(&mut seat.view.target.data)?;
            }
            Order::Points => self.move_to(reader, writer)?,
            Order::Draw => {
                let Scene { strokes, .. } = self.scene.as_ref().ok_or_else(absent)?;
                for Seat { view, .. } in self.seats.iter_mut().filter(|seat| seat.part == Part::ALL) {
                    view.draw(&self.samples, strokes, self.level_ratio);
                    view.pull_back(&self.samples);
                    writer.all(&[view.loss]);
                    writer.all(&view.d_samples);
                }
            }
            Order::PullBack => {
                let number = reader.count()?;
                let Seat { view, masks, .. } = self.seat(number)?;
                if masks.is_empty() {
                    return Err(wrong("it was asked to pull back what it has not drawn"));
                }
                reader.sparse(masks, &mut view.seen.d_coverage)?;
                view.pull_back_part();
                writer.all(&view.d_vertices);
            }
            Order::Coverage => self.show(writer, |view| &view.seen.coverage),
            Order::DCoverage => self.show(writer, |view| &view.seen.d_coverage),
        }
        Ok(())
    }

    fn seat(&mut self, number: usize) -> Result<&mut Seat> {
        self.seats.iter_mut().find(|seat| seat.number == number).ok_or_else(|| wrong("it was asked of a view it lacks"))
    }

    fn sit(&mut self, reader: &mut Reader) -> Result<()> {
        let (number, part, view) = reader.view()?;
        let Scene { raster, pyramid, .. } = self.scene.as_ref().ok_or_else(absent)?;
        if part != Part::ALL && *raster == RasterKind::Band {
            return Err(wrong("bands have no parts"));
        }
        let size = (view.target.width, view.target.height);
        let new = |view| Seat { number, part, view: ViewEngine::new(view, *raster, *pyramid), masks: Vec::new() };
        match self.seats.iter_mut().find(|seat| seat.number == number) {
            Some(seat) if (seat.view.target.width, seat.view.target.height) == size => {
                seat.part = part;
                seat.view.look(view);
            }
            Some(seat) => *seat = new(view),
            None => self.seats.push(new(view)),
        }
        Ok(())
    }

    fn move_to(&mut self, reader: &mut Reader, writer: &mut Writer) -> Result<()> {
        let Scene { sampling, strokes, .. } = self.scene.as_ref().ok_or_else(absent)?;
        [self.level_ratio] = reader.few()?;
        let points = reader.list::<[f32; 4]>(sampling.columns())?;
        sampling.apply(&points, &mut self.samples);
        for Seat { view, part, masks, .. } in self.seats.iter_mut().filter(|seat| seat.part != Part::ALL) {
            view.draw_part(&self.samples, strokes, *part);
            view.take_part(|sums| {
                *masks = masks_of(sums);
                writer.all(masks);
                writer.sparse(masks, sums);
            });
        }
        Ok(())
    }

    fn show(&self, writer: &mut Writer, picture: impl Fn(&ViewEngine) -> &Vec<f32>) {
        self.seats.iter().filter(|seat| seat.part == Part::ALL).for_each(|seat| writer.all(picture(&seat.view)));
    }
}

fn absent() -> crate::Error {
    wrong("it was given no scene")
}
