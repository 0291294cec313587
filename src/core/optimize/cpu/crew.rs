//! Views that are computed elsewhere: by workers with memories of their own, each of which holds what it needs of the scene, is
//! sent control points every iteration (some 10 kB) and sends back losses and gradients to the samples.
//!
//! Who computes what changes no bit. Whole views are summed in their own order, wherever they come from; a view that is left over when
//! all have equally many is drawn in parts, whose sums of areas are integers and whose gradients meet at no vertex more
//! than two at a time. The engine keeps all views: what a mate fails to answer it computes itself.

use super::super::{RasterKind, Work};
use super::message::{Order, Reader, Writer, wrong};
use super::view::ViewEngine;
use crate::Result;
use crate::objective::Pyramid;
use crate::raster::Part;
use crate::wire::{LinearMap, Stroke};
use std::collections::VecDeque;

/// Carries messages to a [`Mate`](super::Mate) and its answers back.
pub trait Courier: Send {
    /// Sends `message` at once; the answer comes later, in the order of the messages. After an error nothing more is sent.
    fn ask(&mut self, message: &[u8]) -> Answer;
}

/// What a mate answers to a message, or why it does not.
pub type Answer = Work<'static, Result<Vec<u8>>>;

/// How large the engine's own part of a view that all draw is, in equal parts: it has the curve to look at, too.
const OWN_PART: f64 = 0.6;

/// Those who compute views for an engine, and what each has of the scene.
#[derive(Default)]
pub(super) struct Crew {
    members: Vec<Member>,
    /// Whether views have to be shared out before the next iteration.
    pub is_due: bool,
    /// The view that all draw a part of, and the engine's own part.
    split: Option<(usize, Part)>,
    /// How many compute now, the engine among them; none while it does so alone.
    at_work: usize,
}

struct Member {
    courier: Box<dyn Courier>,
    /// What it has still to be told.
    orders: Writer,
    /// The views that it computes whole, ascending.
    views: Vec<usize>,
    part: Part,
    /// Where that lies in the picture.
    masks: Vec<u32>,
    is_lost: bool,
}

/// What of an iteration is still to be answered, oldest first, by member.
pub(super) struct Asked(Vec<VecDeque<Answer>>);

/// What a view's shares are made from.
pub(super) struct Given<'a> {
    pub sampling: &'a LinearMap<f32>,
    pub strokes: &'a [Stroke],
    pub raster: RasterKind,
    pub pyramid: Pyramid,
}

impl Crew {
    pub fn hire(&mut self, courier: Box<dyn Courier>) {
        let (orders, part) = (Writer::default(), Part { from: 0, to: 0 });
        self.members.push(Member { courier, orders, views: Vec::new(), part, masks: Vec::new(), is_lost: false });
        self.is_due = true;
    }

    /// Whether nobody is there.
    pub fn is_empty(&self) -> bool {
        self.members.is_empty()
    }

    /// How many compute now, the engine among them; none while it does so alone.
    pub fn at_work(&self) -> usize {
        self.at_work
    }

    /// Whether some views are computed elsewhere now.
    pub fn is_at_work(&self) -> bool {
        self.at_work > 0
    }

    /// The engine goes on alone, until it shares out again.
    pub fn rest(&mut self) {
        (self.at_work, self.split, self.is_due) = (0, None, !self.members.is_empty());
        for member in &mut self.members {
            member.views.clear();
            member.orders.0.clear();
        }
    }

    /// Gives everybody as many views as the others, and a part of the one that may be left over.
    pub fn share_out(&mut self, given: &Given, views: &[ViewEngine]) {
        self.rest();
        self.is_due = false;
        let count = views.len();
        let workers = count.min(1 + self.members.len());
        if workers < 2 {
            return;
        }
        self.at_work = workers;
        let is_split = count % workers == 1 && given.raster == RasterKind::Exact;
        let whole = if is_split { count - 1 } else { count };
        // What cannot be shared equally goes to the mates: the engine has more to do.
        let first_of = |worker: usize| whole * worker / workers;
        let border = |worker: usize| {
            let own = OWN_PART / workers as f64;
            let share = own + (1.0 - own) * worker as f64 / (workers - 1) as f64;
            (share * f64::from(Part::WHOLE)).round() as u32
        };
        self.split = is_split.then(|| (whole, Part { from: 0, to: border(0) }));
        for (k, member) in self.members.iter_mut().take(workers - 1).enumerate() {
            member.orders.scene(given.sampling, given.strokes, given.raster, given.pyramid);
            member.views = (first_of(k + 1)..first_of(k + 2)).collect();
            member.part = Part { from: border(k), to: border(k + 1) };
            for &view in &member.views {
                member.orders.view(view, Part::ALL, &views[view]);
            }
            if is_split {
                member.orders.view(whole, member.part, &views[whole]);
            }
        }
    }

    /// View `number` is another now.
    pub fn look(&mut self, number: usize, view: &ViewEngine) {
        let is_split = self.split.is_some_and(|(split, _)| split == number);
        for member in &mut self.members {
            if is_split {
                member.orders.view(number, member.part, view);
            } else if member.views.contains(&number) {
                member.orders.view(number, Part::ALL, view);
            }
        }
    }

    /// View `number` has another target.
    pub fn set_target(&mut self, number: usize, ink: &[f32]) {
        for member in self.members.iter_mut().filter(|member| member.views.contains(&number)) {
            member.orders.order(Order::Target);
            member.orders.count(number);
            member.orders.all(ink);
        }
    }

    /// Has everybody begin an iteration.
    pub fn begin(&mut self, points: &[[f32; 4]], level_ratio: f32) -> Asked {
        let is_split = self.split.is_some();
        let mut asked = Asked(Vec::new());
        for member in self.members.iter_mut().take(self.at_work - 1) {
            member.orders.order(Order::Points);
            member.orders.all(&[level_ratio]);
            member.orders.all(points);
            if !is_split {
                member.orders.order(Order::Draw);
            }
            asked.0.push([member.send()].into());
        }
        if is_split {
            // Only once all have begun what others wait for.
            for (member, answers) in
                self.members.iter_mut().zip(&mut asked.0).filter(|(member, _)| !member.views.is_empty())
            {
                member.orders.order(Order::Draw);
                answers.push_back(member.send());
            }
        }
        asked
    }

    /// The view that all draw a part of, and the engine's own part.
    pub fn split(&self) -> Option<(usize, Part)> {
        self.split
    }

    /// Whether view `number` is the engine's own, whole.
    pub fn is_own(&self, number: usize) -> bool {
        self.split.is_none_or(|(split, _)| split != number)
            && !self.members.iter().any(|member| member.views.contains(&number))
    }

    /// Adds the others' parts of the divided view; false if one of them does not come.
    pub async fn gather_parts(&mut self, asked: &mut Asked, view: &mut ViewEngine) -> bool {
        let mut is_whole = true;
        for (member, answers) in self.members.iter_mut().zip(&mut asked.0) {
            let pixels = view.target.data.len();
            let read = |reader: &mut Reader| {
                let masks = reader.list::<u32>(pixels.div_ceil(32))?;
                let mut sums = vec![0; pixels];
                reader.sparse(&masks, &mut sums)?;
                Ok((masks, sums))
            };
            match member.answer(answers, read).await {
                Some((masks, sums)) => {
                    member.masks = masks;
                    view.add_part(&sums);
                }
                None => is_whole = false,
            }
        }
        is_whole
    }

    /// Has the others pull back their parts of view `number`.
    pub fn pull_back(&mut self, asked: &mut Asked, number: usize, d_coverage: &[f32]) {
        for (member, answers) in self.members.iter_mut().zip(&mut asked.0) {
            member.orders.order(Order::PullBack);
            member.orders.count(number);
            member.orders.sparse(&member.masks, d_coverage);
            answers.push_back(member.send());
        }
    }

    /// Takes over what whole views came to, and gives the parts' gradients to the vertices, if a view was divided to the end: nothing
    /// where one of them is missing.
    pub async fn gather(
        &mut self,
        mut asked: Asked,
        views: &mut [ViewEngine],
        samples: usize,
        is_divided: bool,
    ) -> Option<Vec<Vec<[f32; 3]>>> {
        let mut parts = Some(Vec::new());
        for (member, answers) in self.members.iter_mut().zip(&mut asked.0) {
            if !member.views.is_empty() {
                let each = |reader: &mut Reader| Ok((reader.few::<f32, 1>()?[0], reader.list::<[f32; 4]>(samples)?));
                let results = member.answer_of_each(answers, |reader, _| each(reader)).await;
                for (view, (loss, d_samples)) in results {
                    (views[view].loss, views[view].d_samples) = (loss, d_samples);
                }
            }
            if is_divided {
                let part = member.answer(answers, |reader| reader.list::<[f32; 3]>(samples)).await;
                parts = parts.zip(part).map(|(mut parts, part)| {
                    parts.push(part);
                    parts
                });
            }
        }
        parts
    }

    /// Fetches pictures of whole views that are drawn elsewhere.
    pub async fn fetch(&mut self, order: Order, views: &mut [ViewEngine]) {
        let mut asked = Vec::new();
        for member in self.members.iter_mut().filter(|member| !member.views.is_empty()) {
            member.orders.order(order);
            asked.push(VecDeque::from([member.send()]));
        }
        let busy = self.members.iter_mut().filter(|member| !member.views.is_empty());
        for (member, answers) in busy.zip(&mut asked) {
            let picture = |reader: &mut Reader, view: usize| reader.list::<f32>(views[view].target.data.len());
            for (view, picture) in member.answer_of_each(answers, picture).await {
                let seen = &mut views[view].seen;
                *if order == Order::Coverage { &mut seen.coverage } else { &mut seen.d_coverage } = picture;
            }
        }
    }

    /// Goes on without those who failed; their whole views, of which they can no longer show anything either.
    pub fn drop_lost(&mut self) -> Vec<usize> {
        let lost = self.members.extract_if(.., |member| member.is_lost);
        let views: Vec<Vec<usize>> = lost.map(|member| member.views).collect();
        self.is_due |= !views.is_empty();
        if self.members.is_empty() {
            self.rest();
        }
        views.concat()
    }
}

impl Member {
    /// Sends what it has still to be told.
    fn send(&mut self) -> Answer {
        if self.is_lost {
            return Work::Done(Err(wrong("it failed before")));
        }
        let answer = self.courier.ask(&self.orders.0);
        self.orders.0.clear();
        answer
    }

    /// The next answer; who fails once is not asked again.
    async fn answer<T>(
        &mut self,
        answers: &mut VecDeque<Answer>,
        read: impl FnOnce(&mut Reader) -> Result<T>,
    ) -> Option<T> {
        let answer = answers.pop_front().filter(|_| !self.is_lost)?;
        let result = answer.done().await.and_then(|bytes| {
            let mut reader = Reader(&bytes);
            let result = read(&mut reader)?;
            reader.end().map(|()| result)
        });
        self.is_lost = result.is_err();
        result.ok()
    }

    /// The next answer, which has an entry for each whole view; nothing where it fails.
    async fn answer_of_each<T>(
        &mut self,
        answers: &mut VecDeque<Answer>,
        each: impl Fn(&mut Reader, usize) -> Result<T>,
    ) -> Vec<(usize, T)> {
        let mine = self.views.clone();
        let read = |reader: &mut Reader| {
            mine.into_iter().map(|view| Ok((view, each(reader, view)?))).collect::<Result<Vec<_>>>()
        };
        self.answer(answers, read).await.unwrap_or_default()
    }
}
