//! A grid of square cells that says which polygons may touch a box.

use super::extremes::most;
use super::pieces::{NONE, Node};
use super::shapes::{NegatedBox, Shapes, disc_box, hull};
use wide::f32x4;

/// Side of a cell in pixels (a power of two, so that cell borders are exact in f32).
pub const CELL_PX: f32 = 8.0;
/// Boxes over more cells than this go to a list of their own that every query scans: memory stays bounded.
const MOST_CELLS: usize = 64;
/// Longer pieces are entered in parts of this length (in pixels), so that slanted ones fill no big boxes.
pub(super) const PART_PX: f32 = 16.0;

/// A box and the polygon in it; long pieces have several.
#[derive(Debug, Clone, Copy)]
struct Entry {
    bounds: f32x4,
    order: u32,
}

const NO_ENTRY: Entry = Entry { bounds: f32x4::splat(f32::INFINITY), order: NONE };

/// Which cells, from the first to the last inclusive.
#[derive(Debug, Clone, Copy)]
struct CellRange {
    x: [u16; 2],
    y: [u16; 2],
}

impl CellRange {
    #[inline(always)]
    fn new(bounds: NegatedBox, columns: usize, rows: usize) -> Self {
        // Casts saturate: what sticks out of the picture counts to its border cells.
        let index = |px: f32, count: usize| ((px * (1.0 / CELL_PX)) as i32).clamp(0, count as i32 - 1) as u16;
        CellRange {
            x: [index(bounds[0], columns), index(-bounds[2], columns)],
            y: [index(bounds[1], rows), index(-bounds[3], rows)],
        }
    }

    #[inline(always)]
    fn each_cell(self, columns: usize, mut f: impl FnMut(usize)) {
        for y in self.y[0]..=self.y[1] {
            for x in self.x[0]..=self.x[1] {
                f(usize::from(y) * columns + usize::from(x));
            }
        }
    }
}

/// Entries, and for each cell those that touch it.
#[derive(Debug, Default)]
pub(super) struct Cells {
    columns: usize,
    rows: usize,
    entries: Vec<Entry>,
    starts: Vec<u32>,
    lists: Vec<Entry>,
    large: Vec<Entry>,
}

impl Cells {
    /// Sorts all polygons of a pass into the cells of a picture of `width` x `height` pixels.
    pub fn build(&mut self, width: usize, height: usize, nodes: &[Node], shapes: &Shapes) {
        self.columns = width.div_ceil(CELL_PX as usize);
        self.rows = height.div_ceil(CELL_PX as usize);
        self.entries.clear();
        self.large.clear();
        let picture = [0.0, 0.0, -(width as f32), -(height as f32)];
        for (order, &bounds) in shapes.boxes.iter().enumerate() {
            if !overlap(bounds, picture) {
                continue;
            }
            let long = most(-bounds[2] - bounds[0], -bounds[3] - bounds[1]) > 2.0 * PART_PX;
            if long && order % 2 == 1 {
                self.add_in_parts(order, bounds, picture, nodes);
            } else {
                self.add(order as u32, bounds);
            }
        }
        self.sort();
    }

    fn add(&mut self, order: u32, bounds: NegatedBox) {
        let range = self.range(bounds);
        let cells = usize::from(range.x[1] - range.x[0] + 1) * usize::from(range.y[1] - range.y[0] + 1);
        let list = if cells > MOST_CELLS { &mut self.large } else { &mut self.entries };
        list.push(Entry { bounds: f32x4::new(bounds), order });
    }

    /// Enters a long piece as the boxes of short stretches of it, as far as they touch the picture.
    fn add_in_parts(&mut self, order: usize, bounds: NegatedBox, picture: NegatedBox, nodes: &[Node]) {
        let a = &nodes[order / 2];
        let b = &nodes[a.next as usize];
        let (dx, dy) = (b.center[0] - a.center[0], b.center[1] - a.center[1]);
        // Mitres reach past the discs by less than 4%.
        let reach = |t: f32| (a.radius + t * (b.radius - a.radius)) * 1.05 + 0.01;
        let widest = reach(0.0).max(reach(1.0));
        let (mut first, mut last) = (0.0f32, 1.0f32);
        for (start, step, end) in [(a.center[0], dx, -picture[2]), (a.center[1], dy, -picture[3])] {
            if step != 0.0 {
                let (t, u) = ((-widest - start) / step, (end + widest - start) / step);
                (first, last) = (first.max(t.min(u)), last.min(t.max(u)));
            }
        }
        if first >= last {
            return;
        }
        let length = (dx * dx + dy * dy).sqrt() * (last - first);
        let parts = (length / PART_PX).ceil().max(1.0) as usize;
        let at = |i: usize| first + (last - first) * i as f32 / parts as f32;
        for i in 0..parts {
            let disc = |t: f32| disc_box([a.center[0] + t * dx, a.center[1] + t * dy], reach(t));
            let part = hull(disc(at(i)), disc(at(i + 1)));
            let part = std::array::from_fn(|c| part[c].max(bounds[c]));
            if overlap(part, picture) {
                self.add(order as u32, part);
            }
        }
    }

    fn range(&self, bounds: NegatedBox) -> CellRange {
        CellRange::new(bounds, self.columns, self.rows)
    }

    /// Counting sort of the entries by cell; within a cell they keep their order.
    fn sort(&mut self) {
        let (columns, rows) = (self.columns, self.rows);
        self.starts.clear();
        self.starts.resize(columns * rows + 2, 0);
        for entry in &self.entries {
            let range = CellRange::new(entry.bounds.to_array(), columns, rows);
            range.each_cell(columns, |cell| self.starts[cell + 2] += 1);
        }
        for i in 2..self.starts.len() {
            self.starts[i] += self.starts[i - 1];
        }
        let total = self.starts[self.starts.len() - 1] as usize;
        self.lists.resize(total, NO_ENTRY);
        for entry in &self.entries {
            CellRange::new(entry.bounds.to_array(), columns, rows).each_cell(columns, |cell| {
                let place = &mut self.starts[cell + 1];
                self.lists[*place as usize] = *entry;
                *place += 1;
            });
        }
    }

    /// Replaces `near` by the polygons whose boxes touch `query` (which must overlap the picture).
    #[inline]
    pub fn gather(&self, query: NegatedBox, near: &mut Near) {
        near.count = 0;
        let range = self.range(query);
        // Overlap in one comparison: box minimum <= query maximum and the negated reverse.
        let greatest = f32x4::new(greatest(query));
        for y in range.y[0]..=range.y[1] {
            for x in range.x[0]..=range.x[1] {
                let cell = usize::from(y) * self.columns + usize::from(x);
                // A box in several cells of the query counts only in the first: where it begins, or the query does.
                let border = |c: u16, first: u16| if c == first { f32::NEG_INFINITY } else { f32::from(c) * CELL_PX };
                let least =
                    f32x4::new([border(x, range.x[0]), border(y, range.y[0]), f32::NEG_INFINITY, f32::NEG_INFINITY]);
                let list = &self.lists[self.starts[cell] as usize..self.starts[cell + 1] as usize];
                near.add(list, |bounds| (bounds.simd_le(greatest) & bounds.simd_ge(least)).all());
            }
        }
        near.add(&self.large, |bounds| bounds.simd_le(greatest).all());
    }
}

/// The greatest box values, one by one, that still overlap `query`.
fn greatest(query: NegatedBox) -> [f32; 4] {
    [-query[2], -query[3], -query[0], -query[1]]
}

/// The polygons near a stretch of stroke. Both loops are without branches: which boxes touch is anyone's guess.
#[derive(Debug, Default)]
pub(super) struct Near {
    /// The first `count` count.
    entries: Vec<Entry>,
    count: usize,
}

impl Near {
    #[inline(always)]
    fn add(&mut self, list: &[Entry], touches: impl Fn(f32x4) -> bool) {
        let most = self.count + list.len();
        if self.entries.len() < most {
            self.entries.resize(most, NO_ENTRY);
        }
        let free = &mut self.entries[self.count..most];
        let mut added = 0;
        for entry in list {
            let place = &mut free[added];
            (place.bounds, place.order) = (entry.bounds, entry.order);
            added += usize::from(touches(entry.bounds));
        }
        self.count += added;
    }

    /// Replaces `found` by those whose boxes touch `query`, without those to skip.
    #[inline(always)]
    pub fn select(&self, query: NegatedBox, skip: [u32; 3], found: &mut Vec<u32>) {
        found.resize(self.count, NONE);
        let greatest = f32x4::new(greatest(query));
        let mut count = 0;
        for &Entry { bounds, order } in &self.entries[..self.count] {
            found[count] = order;
            let skipped = (order == skip[0]) | (order == skip[1]) | (order == skip[2]);
            count += usize::from(bounds.simd_le(greatest).all() & !skipped);
        }
        found.truncate(count);
    }
}

pub(super) fn overlap(a: NegatedBox, b: NegatedBox) -> bool {
    a[0] <= -b[2] && a[1] <= -b[3] && b[0] <= -a[2] && b[1] <= -a[3]
}
