//! All that guides a fit, with weights; what fails is switched off, and the fit goes on.

use super::{Guidance, Progress, Rendered};
use crate::{Error, Result};
use std::fmt;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// What guides a fit, by name. Clones are handles to the same: a session and its engine share one.
#[derive(Clone, Default)]
pub struct Guides(Arc<Mutex<Vec<Guide>>>);

struct Guide {
    name: String,
    weight: f32,
    state: State,
}

enum State {
    Ready(Box<dyn Guidance>),
    /// It is being asked; whoever asks puts it back.
    Asked,
    Off(Error),
}

impl Guides {
    /// `weight` (from 0) times the loss of `guidance` joins the loss from the next iteration on, in place of what has that
    /// name.
    pub fn set(&self, name: &str, weight: f32, guidance: Box<dyn Guidance>) {
        let guide = Guide { name: name.to_owned(), weight, state: State::Ready(guidance) };
        let mut guides = self.lock();
        match guides.iter_mut().find(|guide| guide.name == name) {
            Some(same) => *same = guide,
            None => guides.push(guide),
        }
    }

    /// Goes on without what has that name.
    pub fn remove(&self, name: &str) {
        self.lock().retain(|guide| guide.name != name);
    }

    /// Whether nothing guides.
    pub fn is_empty(&self) -> bool {
        self.lock().iter().all(|guide| matches!(guide.state, State::Off(_)))
    }

    /// Why what no longer guides was switched off, by name.
    pub fn troubles(&self) -> Vec<(String, Error)> {
        let guides = self.lock();
        let trouble = |guide: &Guide| match &guide.state {
            State::Off(error) => Some((guide.name.clone(), error.clone())),
            State::Ready(_) | State::Asked => None,
        };
        guides.iter().filter_map(trouble).collect()
    }

    /// Asks one after the other, in the order in which they came. Returns the weighted sum of their losses and adds their
    /// gradients to each view's; what fails, or answers with what is no number, adds nothing now or later.
    pub async fn guide(&self, views: &mut [Rendered], progress: Progress) -> f32 {
        let mut sum = 0.0;
        let count = self.lock().len();
        for at in 0..count {
            let Some((weight, mut guidance)) = self.take(at) else { continue };
            views.iter_mut().for_each(Rendered::clear_gradient);
            let answer = guidance.guide(views, progress).done().await.and_then(|loss| checked(loss, views));
            if let Ok(loss) = answer {
                sum += weight * loss;
                views.iter_mut().for_each(|view| view.pull(weight));
            }
            self.put_back(at, guidance, answer.err());
        }
        sum
    }

    fn take(&self, at: usize) -> Option<(f32, Box<dyn Guidance>)> {
        let mut guides = self.lock();
        let guide = guides.get_mut(at)?;
        match std::mem::replace(&mut guide.state, State::Asked) {
            State::Ready(guidance) => Some((guide.weight, guidance)),
            other => {
                guide.state = other;
                None
            }
        }
    }

    /// What was exchanged in the meantime stays as it is now.
    fn put_back(&self, at: usize, guidance: Box<dyn Guidance>, trouble: Option<Error>) {
        let mut guides = self.lock();
        let Some(guide) = guides.get_mut(at).filter(|guide| matches!(guide.state, State::Asked)) else { return };
        guide.state = trouble.map_or(State::Ready(guidance), |error| State::Off(named(error, &guide.name)));
    }

    fn lock(&self) -> MutexGuard<'_, Vec<Guide>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl fmt::Debug for Guides {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.lock().iter().map(|guide| (&guide.name, guide.weight))).finish()
    }
}

/// A loss whose gradient fits the views and is made of numbers.
fn checked(loss: f32, views: &[Rendered]) -> Result<f32> {
    let fits = views.iter().all(|view| view.gradient.len() == view.coverage.len());
    let finite = || loss.is_finite() && views.iter().flat_map(|view| &view.gradient).all(|d| d.is_finite());
    let problem = match fits {
        false => "its gradient has not one value for each pixel",
        true if !finite() => "it answered with something that is no number",
        true => return Ok(loss),
    };
    Err(Error::guidance("", problem, REMEDY))
}

const REMEDY: &str = "the wire goes on without it";

/// Under the name by which people know it, where it says none.
fn named(error: Error, by: &str) -> Error {
    match error {
        Error::Guidance { name, problem, remedy } if name.is_empty() => Error::guidance(by, problem, remedy),
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::View;
    use crate::work::{Work, wait};

    /// Answers with `loss` and a gradient of it everywhere, while there is anything left to say.
    struct Says(Vec<f32>);

    impl Guidance for Says {
        fn guide<'a>(&'a mut self, views: &'a mut [Rendered], _: Progress) -> Work<'a, Result<f32>> {
            Work::later(async move {
                let loss = self.0.pop().ok_or_else(|| Error::guidance("", "it has nothing to say", REMEDY))?;
                views.iter_mut().for_each(|view| view.gradient.fill(loss));
                Ok(loss)
            })
        }
    }

    fn views() -> Vec<Rendered> {
        let cameras = View::canonical(2.2, 4).map(|view| view.camera());
        cameras.iter().map(|&camera| Rendered::new(camera, 4, 4, 1.0)).collect()
    }

    #[test]
    fn guidances_add_up_by_their_weights() {
        let guides = Guides::default();
        guides.set("a", 2.0, Box::new(Says(vec![1.0; 3])));
        guides.set("b", 0.5, Box::new(Says(vec![4.0; 3])));
        guides.set("a", 3.0, Box::new(Says(vec![1.0; 3])));
        let mut views = views();
        views[1].d_coverage.fill(1.0);
        assert_eq!(wait(guides.clone().guide(&mut views, Progress::default())), 5.0);
        assert_eq!([views[0].d_coverage[3], views[1].d_coverage[15]], [5.0, 6.0]);
        guides.remove("b");
        assert_eq!(wait(guides.guide(&mut views, Progress::default())), 3.0);
    }

    #[test]
    fn what_fails_is_switched_off_with_a_sentence_and_pulls_no_more() {
        for (words, says) in
            [("nothing to say", vec![]), ("no number", vec![f32::NAN]), ("no number", vec![f32::INFINITY])]
        {
            let guides = Guides::default();
            guides.set("good", 1.0, Box::new(Says(vec![1.0; 3])));
            guides.set("cat.onnx", 1.0, Box::new(Says(says)));
            let mut views = views();
            for _ in 0..2 {
                assert_eq!(wait(guides.guide(&mut views, Progress::default())), 1.0);
            }
            assert!(views.iter().flat_map(|view| &view.d_coverage).all(|&d| d == 2.0));
            let troubles = guides.troubles();
            assert_eq!(troubles.len(), 1);
            let sentence = troubles[0].1.to_string();
            assert!(sentence.starts_with("cat.onnx: ") && sentence.contains(words), "{sentence}");
            assert!(!guides.is_empty());
        }
    }

    #[test]
    fn a_gradient_of_another_size_is_refused() {
        struct Short;
        impl Guidance for Short {
            fn guide<'a>(&'a mut self, views: &'a mut [Rendered], _: Progress) -> Work<'a, Result<f32>> {
                views[1].gradient.pop();
                Work::Done(Ok(1.0))
            }
        }
        let guides = Guides::default();
        guides.set("short", 1.0, Box::new(Short));
        assert_eq!(wait(guides.guide(&mut views(), Progress::default())), 0.0);
        assert!(guides.is_empty() && guides.troubles()[0].1.to_string().contains("each pixel"));
    }
}
