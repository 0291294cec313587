//! Which drawing goes to which view, mirrored or turned how, so that one object can show as much of their ink as
//! possible.

use super::boxfit::{BoxFit, fit_box, fit_box_of_widths};
use super::orientation::{Cutout, Orientation};
use crate::error::{Error, Result};
use crate::view::{Image, Target, View};

/// A drawing with the name a person knows it by.
#[derive(Debug, Clone, PartialEq)]
pub struct Drawing {
    /// File or pad name.
    pub name: String,
    /// Ink, 0 to 1, of any size and aspect.
    pub ink: Image,
}

/// What may move.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ArrangeOptions {
    /// Drawings may change places between the views.
    pub permute: bool,
    /// Drawings may be mirrored left to right.
    pub mirror: bool,
    /// The top drawing may be turned by quarters.
    pub turn_top: bool,
    /// The most a drawing may be stretched so that views agree; beyond, it gets blank paper beside it.
    pub max_stretch: f64,
    /// Side of the targets, px.
    pub size_px: usize,
}

impl Default for ArrangeOptions {
    fn default() -> Self {
        ArrangeOptions { permute: true, mirror: true, turn_top: true, max_stretch: 1.35, size_px: 256 }
    }
}

impl ArrangeOptions {
    /// Everything as given.
    pub fn pinned(self) -> Self {
        ArrangeOptions { permute: false, mirror: false, turn_top: false, ..self }
    }
}

/// How one view came by its drawing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placement {
    /// Index of the drawing.
    pub source: usize,
    /// Mirrored, turned.
    pub orientation: Orientation,
    /// Stretched along one axis by this factor, at least 1.
    pub stretch: f64,
    /// The part of the drawing that is laid down, its ink's box, as shares of the drawing's sides: left, top, width,
    /// height.
    pub from: [f64; 4],
    /// Where in the view's picture it lies, as shares of its sides.
    pub onto: [f64; 4],
}

impl Placement {
    /// How large the drawing is in its view, as a share of what it would be without the others.
    pub fn kept(&self) -> f64 {
        self.onto[2].max(self.onto[3]) / FILLED
    }
}

/// Which side of the object's box views have in common.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sharing {
    /// Front and side are equally high, and a top shares a side with either; views of other directions share a cube.
    Height,
    /// Front and top, and no other view, are equally wide.
    Width,
}

/// Drawings in their views, and the object's box.
#[derive(Debug, Clone, PartialEq)]
pub struct Arrangement {
    /// One a view, in the order front, side, top, or front and top.
    pub placements: Vec<Placement>,
    /// Half sides of the object's box along x, y, z; its corners lie on the unit sphere.
    pub half_extents_world: [f64; 3],
    /// World height of every view's square picture: the box's longest side with 8% of the picture as margin all round.
    pub height_world: f64,
    /// What each view should show.
    pub targets: Vec<Target>,
    /// What the views have in common.
    pub sharing: Sharing,
    /// The score that chose it: mean and worst view's coverable share, half and half; 0 where nothing was compared.
    pub score: f64,
}

/// Share of a picture's side that the box's longest side takes: 8% margins, room for strokes at the border.
pub(super) const FILLED: f64 = 0.84;
/// Side of the pictures on which arrangements are compared: strokes still tell apart, and rows fit one word; at most 64.
const COARSE: usize = 48;
/// Thinnest stroke on those pictures, px.
const COARSE_STROKE: f32 = 1.2;
/// Ink share for a coarse pixel to count.
const COARSE_INK: f32 = 0.35;
/// What another arrangement must gain over the person's own to be preferred.
const WORTH_MOVING: f64 = 0.01;
/// Drawings that keep less of their size beside each other go to other views, or it is said.
pub const KEPT: f64 = 0.7;
/// What all must keep in those: there is such a way wherever the top may be turned.
const WHOLE: f64 = 0.95;
/// What of the score may be lost by that.
const MOST_LOST: f64 = 0.03;

/// Finds the best arrangement of two (front, side) or three (front, side, top) drawings. Two of very different proportions,
/// one of which would come out small beside the other since front and side are equally high, are seen from the front and
/// the top instead: the long side of one along the long side of the other.
///
/// # Errors
/// If there are not two or three drawings, one is blank, or no arrangement lets the views share ink.
pub fn arrange(drawings: &[Drawing], options: &ArrangeOptions) -> Result<Arrangement> {
    if !(2..=3).contains(&drawings.len()) {
        return Err(Error::Pictures {
            problem: format!("{} drawings, but front, side and top take two or three", drawings.len()),
            remedy: "give two or three drawings, or name the other views' directions".into(),
        });
    }
    let Cutouts(cutouts) = &Cutouts::new(drawings)?;
    let coarse: Vec<Cutout> = cutouts.iter().map(|cutout| cutout.traced(4 * COARSE, 4.0 * COARSE_STROKE)).collect();
    let beside = best(cutouts, &coarse, options, Sharing::Height).ok_or_else(|| Error::Pictures {
        problem: "the drawings have no ink at a common height or width, so no object can show them together".into(),
        remedy: "use other drawings, or let them be arranged freely".into(),
    })?;
    let moves = drawings.len() == 2 && options.permute && beside.1.kept() < KEPT;
    let above = moves.then(|| best(cutouts, &coarse, options, Sharing::Width)).flatten();
    let (score, candidate) = above.filter(|above| above.0 >= beside.0 - MOST_LOST).unwrap_or(beside);
    Ok(candidate.laid_out(cutouts, options.size_px, score))
}

/// The way that lets views share most ink, with its score; `None` if none lets them share any, or all shrink a drawing that
/// is to keep its size.
fn best(cutouts: &[Cutout], coarse: &[Cutout], options: &ArrangeOptions, sharing: Sharing) -> Option<(f64, Candidate)> {
    let top = sharing.views(cutouts.len()).iter().position(|&view| view == 2);
    let mut best: Option<(f64, Candidate)> = None;
    for assignment in permutations(cutouts.len(), options.permute) {
        for lies_down in [false, true] {
            if lies_down && (top.is_none() || !options.turn_top) {
                continue;
            }
            let lying = |view: usize| Some(view) == top && lies_down;
            let aspects = aspects(cutouts, &assignment, lying);
            let fit = sharing.fit(&aspects, options.max_stretch);
            if sharing == Sharing::Width && kept(&fit, sharing) < WHOLE {
                continue;
            }
            // Each view's ways of lying, as bit rows on its side of the box.
            let ways: Vec<Vec<(Orientation, Rows)>> = (0..assignment.len())
                .map(|view| {
                    ways(Some(view) == top, lies_down, options)
                        .into_iter()
                        .map(|way| (way, rows(&coarse[assignment[view]], way, fit.filled[view])))
                        .collect()
                })
                .collect();
            each_choice(&ways.iter().map(Vec::len).collect::<Vec<_>>(), |choice| {
                let chosen: Vec<&Rows> = choice.iter().zip(&ways).map(|(&k, ways)| &ways[k].1).collect();
                let score = score(&chosen, sharing);
                // The person's own arrangement comes first.
                let margin = if best.is_none() { 0.0 } else { WORTH_MOVING };
                let as_given = |best: &(f64, Candidate)| if best.1.is_as_given() { margin } else { 1e-9 };
                if best.as_ref().is_none_or(|found| score > found.0 + as_given(found)) {
                    let orientations = choice.iter().zip(&ways).map(|(&k, ways)| ways[k].0).collect();
                    let candidate =
                        Candidate { assignment: assignment.clone(), orientations, sharing, fit: fit.clone() };
                    best = Some((score, candidate));
                }
            });
        }
    }
    best.filter(|found| found.0 > 0.0)
}

impl Sharing {
    /// Which of front, side and top there are, of so many drawings.
    fn views(self, count: usize) -> &'static [usize] {
        match self {
            Sharing::Height => &[0, 1, 2][..count],
            Sharing::Width => &[0, 2],
        }
    }

    fn fit(self, aspects: &[f64], max_stretch: f64) -> BoxFit {
        match (self, aspects) {
            (Sharing::Width, &[front, top]) => fit_box_of_widths([front, top], max_stretch),
            _ => fit_box(aspects, max_stretch),
        }
    }
}

/// The sides across and down of each view's side of a box of `sides`.
fn spans([w, h, d]: [f64; 3]) -> [[f64; 2]; 3] {
    [[w, h], [d, h], [w, d]]
}

/// The least that a drawing keeps of its size in a box.
fn kept(fit: &BoxFit, sharing: Sharing) -> f64 {
    let spans = spans(fit.sides);
    let views = sharing.views(fit.filled.len()).iter().zip(&fit.filled);
    views.map(|(&view, filled)| (spans[view][0] * filled[0]).max(spans[view][1] * filled[1])).fold(1.0, f64::min)
}

/// A way to lay the drawings.
struct Candidate {
    assignment: Vec<usize>,
    orientations: Vec<Orientation>,
    sharing: Sharing,
    fit: BoxFit,
}

impl Candidate {
    fn is_as_given(&self) -> bool {
        self.assignment.iter().enumerate().all(|(view, &source)| view == source)
            && self.orientations.iter().all(|&orientation| orientation == Orientation::default())
    }

    /// The least that a drawing keeps of its size.
    fn kept(&self) -> f64 {
        kept(&self.fit, self.sharing)
    }

    fn laid_out(self, cutouts: &[Cutout], size_px: usize, score: f64) -> Arrangement {
        let diagonal = self.fit.sides.iter().map(|side| side * side).sum::<f64>().sqrt();
        let half_extents_world = self.fit.sides.map(|side| side / diagonal);
        let height_world = 2.0 * half_extents_world.iter().copied().fold(0.0, f64::max) / FILLED;
        let spans_px = spans(half_extents_world.map(|half| 2.0 * half / height_world * size_px as f64));
        let mut placements = Vec::new();
        let mut targets = Vec::new();
        let views = View::canonical(height_world, size_px);
        for (index, &view) in self.sharing.views(self.assignment.len()).iter().enumerate() {
            let [across, down] = spans_px[view];
            let [fill_across, fill_down] = self.fit.filled[index];
            let (width, height) = (across * fill_across, down * fill_down);
            let middle = size_px as f64 / 2.0;
            let area = [middle - width / 2.0, middle - height / 2.0, width, height];
            let source = self.assignment[index];
            let orientation = self.orientations[index];
            let ink = cutouts[source].laid(orientation, area, size_px, size_px);
            targets.push(Target { view: views[view].clone(), ink });
            placements.push(Placement {
                source,
                orientation,
                stretch: self.fit.stretch[index],
                from: cutouts[source].on_drawing(),
                onto: area.map(|px| px / size_px as f64),
            });
        }
        Arrangement { placements, half_extents_world, height_world, targets, sharing: self.sharing, score }
    }
}

/// Drawings cut out along their ink, to be laid down in any way.
pub struct Cutouts(pub(super) Vec<Cutout>);

impl Cutouts {
    /// # Errors
    /// [`Error::Picture`] for a drawing without ink.
    pub fn new(drawings: &[Drawing]) -> Result<Cutouts> {
        let cut = |drawing: &Drawing| {
            Cutout::new(&drawing.ink).ok_or_else(|| {
                Error::picture(&drawing.name, "there is no ink to draw", "draw something, or use a picture with lines")
            })
        };
        drawings.iter().map(cut).collect::<Result<_>>().map(Cutouts)
    }

    /// Lays them down as told: front, side and perhaps top show the drawings `ways` names, lying as it says. Targets
    /// are `size_px` square, stretched by at most `max_stretch`.
    pub fn lay_out(&self, ways: &[(usize, Orientation)], max_stretch: f64, size_px: usize) -> Arrangement {
        let (assignment, orientations): (Vec<usize>, Vec<Orientation>) = ways.iter().copied().unzip();
        let aspects = aspects(&self.0, &assignment, |view| orientations[view].lies_down());
        let sharing = Sharing::Height;
        let fit = sharing.fit(&aspects, max_stretch);
        Candidate { assignment, orientations, sharing, fit }.laid_out(&self.0, size_px, 0.0)
    }
}

/// Width / height of each view's drawing; `lies_down` says whether a view's is turned by a quarter.
fn aspects(cutouts: &[Cutout], assignment: &[usize], lies_down: impl Fn(usize) -> bool) -> Vec<f64> {
    let aspect = |(view, &source): (usize, &usize)| {
        let aspect = cutouts[source].aspect();
        if lies_down(view) { 1.0 / aspect } else { aspect }
    };
    assignment.iter().enumerate().map(aspect).collect()
}

/// All orders of 0..count, the given one first.
fn permutations(count: usize, permute: bool) -> Vec<Vec<usize>> {
    match (permute, count) {
        (true, 2) => vec![vec![0, 1], vec![1, 0]],
        (true, 3) => [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]].map(Vec::from).to_vec(),
        _ => vec![(0..count).collect()],
    }
}

/// The orientations a view may take, upright first.
fn ways(is_top: bool, lies_down: bool, options: &ArrangeOptions) -> Vec<Orientation> {
    let turns: &[u8] = match (is_top && options.turn_top, is_top && lies_down) {
        (_, true) => &[1, 3],
        (true, false) => &[0, 2],
        _ => &[0],
    };
    let mirrors: &[bool] = if options.mirror { &[false, true] } else { &[false] };
    mirrors
        .iter()
        .flat_map(|&mirrored| turns.iter().map(move |&quarter_turns| Orientation { mirrored, quarter_turns }))
        .collect()
}

/// Calls `visit` with every choice of one of `counts[i]` for each i.
fn each_choice(counts: &[usize], mut visit: impl FnMut(&[usize])) {
    let mut choice = vec![0; counts.len()];
    loop {
        visit(&choice);
        let Some(i) = (0..counts.len()).rev().find(|&i| choice[i] + 1 < counts[i]) else { return };
        choice[i] += 1;
        choice[i + 1..].fill(0);
    }
}

/// A coarse picture, one bit a pixel, of one side of the box stretched to a square.
type Rows = [u64; COARSE];

fn rows(cutout: &Cutout, orientation: Orientation, filled: [f64; 2]) -> Rows {
    let side = COARSE as f64;
    let [w, h] = filled.map(|share| share * side);
    let picture = cutout.laid(orientation, [(side - w) / 2.0, (side - h) / 2.0, w, h], COARSE, COARSE);
    std::array::from_fn(|y| (0..COARSE).filter(|&x| picture.at(x, y) > COARSE_INK).fold(0, |row, x| row | 1 << x))
}

/// Mean and least coverable share, half and half: a view that fails is worse than three that lack a little.
fn score(views: &[&Rows], sharing: Sharing) -> f64 {
    let shares = match (sharing, views) {
        (Sharing::Width, &[front, top]) => shares_of_widths(front, top),
        _ => coverable_shares(views),
    };
    let mean = shares.iter().sum::<f64>() / shares.len() as f64;
    0.5 * mean + 0.5 * shares.iter().copied().fold(1.0, f64::min)
}

/// Each view's share of ink pixels for which some cell of the box lies on ink in all views.
/// Front: row -y, column x. Side: row -y, column -z. Top: row z, column x.
fn coverable_shares(views: &[&Rows]) -> Vec<f64> {
    let mut covered = [[0u64; COARSE]; 3];
    let (front, side) = (views[0], views[1]);
    for y in 0..COARSE {
        let mut front_cells = 0;
        for column in (0..COARSE).filter(|column| side[y] >> column & 1 == 1) {
            let z = COARSE - 1 - column;
            let cells = front[y] & views.get(2).map_or(u64::MAX, |top| top[z]);
            front_cells |= cells;
            covered[1][y] |= u64::from(cells != 0) << column;
            covered[2][z] |= cells;
        }
        covered[0][y] = front_cells;
    }
    views.iter().zip(&covered).map(|(ink, covered)| share(covered, ink)).collect()
}

/// The same of a front and a top that share their columns.
fn shares_of_widths(front: &Rows, top: &Rows) -> Vec<f64> {
    let columns = |rows: &Rows| rows.iter().fold(0, |columns, row| columns | row);
    let both = columns(front) & columns(top);
    [front, top].iter().map(|ink| share(&ink.map(|row| row & both), ink)).collect()
}

fn share(covered: &Rows, ink: &Rows) -> f64 {
    let count = |rows: &Rows| rows.iter().map(|row| row.count_ones()).sum::<u32>();
    f64::from(count(covered)) / f64::from(count(ink).max(1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::Ink;
    use crate::rng::Rng;

    fn random_rows(rng: &mut Rng, share: f64) -> Rows {
        std::array::from_fn(|_| (0..COARSE).filter(|_| rng.unit() < share).fold(0, |row, x| row | 1 << x))
    }

    #[test]
    fn coverable_shares_equal_brute_force() {
        let mut rng = Rng::new(4, 0);
        let [front, side, top] = [0.03, 0.05, 0.1].map(|share| random_rows(&mut rng, share));
        let ink = |rows: &Rows, row: usize, column: usize| rows[row] >> column & 1 == 1;
        let brute = |with_top: bool| {
            let mut covered = [[[false; COARSE]; COARSE]; 3];
            for (x, y, z) in (0..COARSE.pow(3)).map(|i| (i % COARSE, i / COARSE % COARSE, i / COARSE / COARSE)) {
                let k = COARSE - 1 - z;
                if ink(&front, y, x) && ink(&side, y, k) && (!with_top || ink(&top, z, x)) {
                    (covered[0][y][x], covered[1][y][k], covered[2][z][x]) = (true, true, true);
                }
            }
            let share = |rows: &Rows, covered: &[[bool; COARSE]; COARSE]| {
                let all = rows.iter().map(|row| row.count_ones()).sum::<u32>();
                covered.iter().flatten().filter(|c| **c).count() as f64 / f64::from(all)
            };
            [share(&front, &covered[0]), share(&side, &covered[1]), share(&top, &covered[2])]
        };
        assert_eq!(coverable_shares(&[&front, &side, &top]), brute(true));
        assert_eq!(coverable_shares(&[&front, &side]), brute(false)[..2]);
        // A front and a top are a front and a side turned by a quarter.
        let turned = |rows: &Rows| -> Rows {
            std::array::from_fn(|y| (0..COARSE).filter(|&x| rows[x] >> y & 1 == 1).fold(0, |row, x| row | 1 << x))
        };
        assert_eq!(shares_of_widths(&front, &top), coverable_shares(&[&turned(&front), &turned(&top)]));
        assert_ne!(coverable_shares(&[&front, &side, &top]), coverable_shares(&[&side, &front, &top]));
    }

    /// Three drawings of one object: rods along a bent line.
    fn planted() -> Vec<Drawing> {
        let mut pictures = vec![Image::new(120, 120), Image::new(120, 120), Image::new(120, 120)];
        let mut rng = Rng::new(11, 0);
        let corners: Vec<[f64; 3]> = (0..6).map(|_| std::array::from_fn(|_| rng.range(8.0, 112.0))).collect();
        for pair in corners.windows(2) {
            for step in 0..400 {
                let t = f64::from(step) / 400.0;
                let [x, y, z]: [f64; 3] = std::array::from_fn(|c| pair[0][c] + t * (pair[1][c] - pair[0][c]));
                for (picture, (u, v)) in pictures.iter_mut().zip([(x, 120.0 - y), (120.0 - z, 120.0 - y), (x, z)]) {
                    for (du, dv) in (0..49).map(|i| (i % 7, i / 7)) {
                        let (u, v) = (u as usize + du - 3, v as usize + dv - 3);
                        picture.data[v * 120 + u] = 1.0;
                    }
                }
            }
        }
        let names = ["a", "b", "c"];
        names.iter().zip(pictures).map(|(name, ink)| Drawing { name: (*name).into(), ink }).collect()
    }

    #[test]
    fn finds_the_planted_arrangement() {
        let drawings = planted();
        let right = arrange(&drawings, &ArrangeOptions::default().pinned()).unwrap();
        assert!(right.score > 0.97, "{}", right.score);
        assert!(right.placements.iter().all(|p| p.stretch < 1.02));
        // Scrambled: order changed, the top turned, the side mirrored.
        let side = Cutout::new(&drawings[1].ink).unwrap();
        let top = Cutout::new(&drawings[2].ink).unwrap();
        let mirrored = Orientation { mirrored: true, quarter_turns: 0 };
        let turned = Orientation { mirrored: false, quarter_turns: 1 };
        let area = |aspect: f64| [10.0, 10.0, 200.0, 200.0 / aspect];
        let scrambled = vec![
            Drawing { name: "side".into(), ink: side.laid(mirrored, area(side.aspect()), 260, 400) },
            Drawing { name: "top".into(), ink: top.laid(turned, area(1.0 / top.aspect()), 260, 400) },
            drawings[0].clone(),
        ];
        let pinned = arrange(&scrambled, &ArrangeOptions::default().pinned()).map_or(0.0, |found| found.score);
        let found = arrange(&scrambled, &ArrangeOptions::default()).unwrap();
        assert!(found.score > 0.95 && pinned < 0.8, "{} against {pinned}", found.score);
        assert_eq!(found, arrange(&scrambled, &ArrangeOptions::default()).unwrap());
    }

    #[test]
    fn what_is_right_already_stays() {
        let found = arrange(&planted(), &ArrangeOptions::default()).unwrap();
        for (view, placement) in found.placements.iter().enumerate() {
            assert_eq!((placement.source, placement.orientation), (view, Orientation::default()));
        }
        let norm = found.half_extents_world.iter().map(|h| h * h).sum::<f64>().sqrt();
        assert!((norm - 1.0).abs() < 1e-12);
    }

    /// A zigzag that fills a box of a picture.
    fn zigzag(name: &str, width: usize, height: usize) -> Drawing {
        let mut ink = Image::new(width + 20, height + 20);
        for step in 0..2000 {
            let t = step as f64 / 2000.0;
            let wave = |k: f64| 1.0 - (2.0 * (k * t).fract() - 1.0).abs();
            let (x, y) = if width > height { (t, wave(5.0)) } else { (wave(5.0), t) };
            for (dx, dy) in (0..9).map(|i| (i % 3, i / 3)) {
                let (x, y) = ((x * (width - 3) as f64) as usize + dx, (y * (height - 3) as f64) as usize + dy);
                ink.data[(y + 10) * (width + 20) + x + 10] = 1.0;
            }
        }
        Drawing { name: name.into(), ink }
    }

    #[test]
    fn long_and_tall_drawings_keep_their_sizes_above_each_other() {
        let (car, mast) = (zigzag("car", 200, 60), zigzag("mast", 60, 200));
        for drawings in [[car.clone(), mast.clone()], [mast.clone(), car.clone()]] {
            let beside = arrange(&drawings, &ArrangeOptions::default().pinned()).unwrap();
            let kept: Vec<f64> = beside.placements.iter().map(Placement::kept).collect();
            assert!(beside.sharing == Sharing::Height && kept.iter().any(|&k| k > 0.99));
            assert!(kept.iter().any(|&k| k < 0.35), "{kept:?}");
            let above = arrange(&drawings, &ArrangeOptions::default()).unwrap();
            let names: Vec<&str> = above.targets.iter().map(|target| target.view.name.as_str()).collect();
            assert_eq!((above.sharing, names), (Sharing::Width, vec!["front", "top"]));
            assert!(above.placements.iter().all(|placement| placement.kept() > 0.99 && placement.stretch == 1.0));
            assert!(above.score > 0.95, "{}", above.score);
            for (target, placement) in above.targets.iter().zip(&above.placements) {
                let found = target.ink.threshold(0.5).bounding_box().unwrap();
                let drawn = [placement.onto[2], placement.onto[3]].map(|share| 256.0 * share);
                assert!(
                    (found.width() as f64 - drawn[0]).abs() < 3.0 && (found.height() as f64 - drawn[1]).abs() < 3.0
                );
            }
        }
        // A broad one goes above the long one as it is; what is nearly of one proportion stays beside.
        let broad = arrange(&[car.clone(), zigzag("cow", 200, 150)], &ArrangeOptions::default()).unwrap();
        assert!(broad.sharing == Sharing::Width && broad.placements.iter().all(|placement| placement.kept() > 0.99));
        let alike = arrange(&[zigzag("a", 200, 100), zigzag("b", 200, 130)], &ArrangeOptions::default()).unwrap();
        assert_eq!(alike.sharing, Sharing::Height);
    }

    #[test]
    fn hopeless_sets_are_refused_in_plain_words() {
        let mut drawings = planted();
        assert!(arrange(&drawings[..1], &ArrangeOptions::default()).is_err());
        drawings[1].ink = Image::new(50, 50);
        let error = arrange(&drawings, &ArrangeOptions::default()).unwrap_err();
        assert!(error.to_string().starts_with("b: there is no ink"));
        // One pixel of ink is a drawing, if a small one.
        drawings[1].ink.data[25 * 50 + 25] = 1.0;
        assert!(arrange(&drawings, &ArrangeOptions::default()).is_ok());
    }
}
