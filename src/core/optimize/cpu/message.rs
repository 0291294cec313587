//! What goes to and fro between an engine and its mates: words of four bytes, as the machine has them. Both ends are on
//! one machine and of one build; still, nothing is believed that was not counted.

use super::super::RasterKind;
use super::super::engine::SceneView;
use super::view::ViewEngine;
use crate::objective::Pyramid;
use crate::raster::Part;
use crate::view::{Camera, Image, MAX_PICTURE_PX, Occluder};
use crate::wire::{LinearMap, Row, Stroke};
use crate::{Error, Result};
use bytemuck::Pod;

/// What a mate is told. A message holds any number of them; what they answer follows each other likewise.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Order {
    /// A new scene without views.
    Scene,
    /// A view, all of it or a part, in place of the one of that number.
    View,
    /// Another target for a view.
    Target,
    /// Control points; answered by each part's sums.
    Points,
    /// To draw whole views and go all the way back; answered by each one's loss and gradient to the samples.
    Draw,
    /// The gradient to the picture of a view drawn in parts, where the part lies; answered by the part's gradient to the vertices.
    PullBack,
    /// Answered by whole views' coverage.
    Coverage,
    /// Answered by the gradient to it.
    DCoverage,
}

impl Order {
    const ALL: [Order; 8] = [
        Order::Scene,
        Order::View,
        Order::Target,
        Order::Points,
        Order::Draw,
        Order::PullBack,
        Order::Coverage,
        Order::DCoverage,
    ];
}

pub(super) fn wrong(problem: &str) -> Error {
    Error::device("the worker that computes views", problem, "the others go on without it")
}

/// Which values are not 0, a bit each: of a part's sums most are.
pub(super) fn masks_of(sums: &[i32]) -> Vec<u32> {
    let mask = |sums: &[i32]| sums.iter().enumerate().map(|(i, &sum)| u32::from(sum != 0) << i).sum();
    sums.chunks(32).map(mask).collect()
}

/// Where the bits are set.
fn places(masks: &[u32]) -> impl Iterator<Item = usize> + '_ {
    masks.iter().enumerate().flat_map(|(i, &mask)| {
        let left = std::iter::successors(Some(mask), |left| Some(left & left.wrapping_sub(1)));
        left.take_while(|&left| left != 0).map(move |left| 32 * i + left.trailing_zeros() as usize)
    })
}

/// Writes a message.
#[derive(Default)]
pub(super) struct Writer(pub Vec<u8>);

impl Writer {
    pub fn order(&mut self, order: Order) {
        self.count(order as usize);
    }

    pub fn count(&mut self, count: usize) {
        self.all(&[count as u32]);
    }

    pub fn all<T: Pod>(&mut self, values: &[T]) {
        self.0.extend_from_slice(bytemuck::cast_slice(values));
    }

    /// The values where bits are set.
    pub fn sparse<T: Pod>(&mut self, masks: &[u32], values: &[T]) {
        let set: usize = masks.iter().map(|mask| mask.count_ones() as usize).sum();
        self.0.reserve(set * size_of::<T>());
        places(masks).for_each(|place| self.all(&[values[place]]));
    }

    pub fn scene(&mut self, sampling: &LinearMap<f32>, strokes: &[Stroke], raster: RasterKind, pyramid: Pyramid) {
        self.order(Order::Scene);
        self.count(usize::from(raster == RasterKind::Exact));
        self.count(usize::from(pyramid == Pyramid::AveragePool));
        self.count(sampling.columns());
        self.count(sampling.rows().len());
        for Row { first, weights } in sampling.rows() {
            self.all(&[*first]);
            self.all(weights);
        }
        self.count(strokes.len());
        for Stroke { start, count, closed } in strokes {
            [*start, *count, usize::from(*closed)].iter().for_each(|&number| self.count(number));
        }
    }

    pub fn view(&mut self, number: usize, part: Part, view: &ViewEngine) {
        self.order(Order::View);
        self.count(number);
        self.all(&[part.from, part.to]);
        let Camera { right, down, forward, scale, centre_px, perspective } = view.seen.camera;
        [right, down, forward].iter().for_each(|row| self.all(row));
        self.all(&[scale, centre_px[0], centre_px[1], view.seen.weight]);
        self.count(usize::from(perspective));
        self.count(view.target.width);
        self.count(view.target.height);
        self.all(&view.target.data);
        self.count(usize::from(view.occluder.is_some()));
        if let Some(occluder) = &view.occluder {
            self.all(&[occluder.steepness, occluder.bias_world]);
            self.all(&occluder.depth.data);
        }
    }
}

/// Reads one.
pub(super) struct Reader<'a>(pub &'a [u8]);

impl Reader<'_> {
    /// Whether all is read.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    pub fn end(&self) -> Result<()> {
        if self.is_empty() { Ok(()) } else { Err(wrong("its answer is too long")) }
    }

    pub fn order(&mut self) -> Result<Order> {
        Order::ALL.get(self.count()?).copied().ok_or_else(|| wrong("it was told what it does not know"))
    }

    pub fn count(&mut self) -> Result<usize> {
        Ok(self.few::<u32, 1>()?[0] as usize)
    }

    fn is_so(&mut self) -> Result<bool> {
        match self.count()? {
            0 => Ok(false),
            1 => Ok(true),
            _ => Err(wrong("something is neither so nor otherwise")),
        }
    }

    pub fn few<T: Pod, const N: usize>(&mut self) -> Result<[T; N]> {
        let mut values = [T::zeroed(); N];
        self.fill(&mut values)?;
        Ok(values)
    }

    /// As many as `values` has room for.
    pub fn fill<T: Pod>(&mut self, values: &mut [T]) -> Result<()> {
        let bytes: &mut [u8] = bytemuck::cast_slice_mut(values);
        let (mine, rest) = self.0.split_at_checked(bytes.len()).ok_or_else(|| wrong("a message ends too early"))?;
        bytes.copy_from_slice(mine);
        self.0 = rest;
        Ok(())
    }

    /// `count` of them, if there are as many.
    pub fn list<T: Pod>(&mut self, count: usize) -> Result<Vec<T>> {
        if count.checked_mul(size_of::<T>()).is_none_or(|bytes| bytes > self.0.len()) {
            return Err(wrong("a message ends too early"));
        }
        let mut values = vec![T::zeroed(); count];
        self.fill(&mut values)?;
        Ok(values)
    }

    pub fn counted<T: Pod>(&mut self) -> Result<Vec<T>> {
        let count = self.count()?;
        self.list(count)
    }

    /// What [`Writer::sparse`] wrote; other values stay.
    pub fn sparse<T: Pod>(&mut self, masks: &[u32], values: &mut [T]) -> Result<()> {
        for place in places(masks) {
            let value = values.get_mut(place).ok_or_else(|| wrong("a pixel lies beside its picture"))?;
            [*value] = self.few()?;
        }
        Ok(())
    }

    pub fn scene(&mut self) -> Result<(LinearMap<f32>, Vec<Stroke>, RasterKind, Pyramid)> {
        let raster = if self.is_so()? { RasterKind::Exact } else { RasterKind::Band };
        let pyramid = if self.is_so()? { Pyramid::AveragePool } else { Pyramid::Gaussian };
        let (columns, rows) = (self.count()?, self.count()?);
        let rows: Vec<Row<f32>> = self
            .list::<[u32; 5]>(rows)?
            .into_iter()
            .map(|[first, weights @ ..]| Row { first, weights: weights.map(f32::from_bits) })
            .collect();
        if columns < 4 || rows.iter().any(|row| row.first as usize >= columns) {
            return Err(wrong("a map does not fit its points"));
        }
        let strokes = self.counted::<[u32; 3]>()?.into_iter().map(|[start, count, closed]| Stroke {
            start: start as usize,
            count: count as usize,
            closed: closed != 0,
        });
        Ok((LinearMap::new(columns, rows), strokes.collect(), raster, pyramid))
    }

    pub fn view(&mut self) -> Result<(usize, Part, SceneView)> {
        let number = self.count()?;
        let [from, to] = self.few()?;
        let [right, down, forward] = self.few::<[f32; 4], 3>()?;
        let [scale, x, y, weight] = self.few()?;
        let camera = Camera { right, down, forward, scale, centre_px: [x, y], perspective: self.is_so()? };
        let (width, height) = (self.count()?, self.count()?);
        if ![width, height].iter().all(|side| (1..=MAX_PICTURE_PX).contains(side)) {
            return Err(wrong("a picture has a size that none has"));
        }
        let target = Image { width, height, data: self.list(width * height)? };
        let occluder = match self.is_so()? {
            false => None,
            true => {
                let [steepness, bias_world] = self.few()?;
                let depth = Image { width, height, data: self.list(width * height)? };
                Some(Occluder { depth, steepness, bias_world })
            }
        };
        Ok((number, Part { from, to }, SceneView { occluder, ..SceneView::new(camera, target, weight) }))
    }
}
