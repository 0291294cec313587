//! `--words`: what each view is to show.

use wire4d::tasks::Run;
use wire4d::{Error, Result};

/// Words for views, in the order in which they were said.
pub struct Wording(Vec<Words>);

struct Words {
    /// The only view that they are for; all without.
    view: Option<String>,
    words: String,
}

impl Wording {
    /// Of texts `WORDS` or `VIEW=WORDS`.
    pub fn new<'a>(texts: impl Iterator<Item = &'a String>) -> Wording {
        let words = |text: &String| match text.split_once('=') {
            Some((view, words)) => Words { view: Some(view.trim().to_owned()), words: words.trim().to_owned() },
            None => Words { view: None, words: text.trim().to_owned() },
        };
        Wording(texts.map(words).collect())
    }

    /// Whether nothing was said.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// All words.
    pub fn iter(&self) -> impl Iterator<Item = &str> {
        self.0.iter().map(|words| words.words.as_str())
    }

    /// Views that have words of their own, each once.
    pub fn views(&self) -> Vec<&str> {
        let mut views: Vec<&str> = Vec::new();
        for view in self.0.iter().filter_map(|words| words.view.as_deref()) {
            if !views.contains(&view) {
                views.push(view);
            }
        }
        views
    }

    /// A view's own words.
    pub fn own(&self, view: &str) -> Option<&str> {
        self.last(Some(view))
    }

    /// What a view is to show: its own words before those of all.
    pub fn of(&self, view: &str) -> Option<&str> {
        self.own(view).or_else(|| self.last(None))
    }

    fn last(&self, view: Option<&str>) -> Option<&str> {
        self.0.iter().rev().find(|words| words.view.as_deref() == view).map(|words| words.words.as_str())
    }

    /// # Errors
    /// [`Error::Setting`] for words of a view that is not there.
    pub fn check(&self, run: &Run) -> Result<()> {
        let names = fitted(run);
        match self.views().into_iter().find(|view| !names.contains(view)) {
            None => Ok(()),
            Some(stray) => {
                let problem = format!("there is no view {stray:?}");
                Err(Error::setting("--words", problem, format!("its views are {}", names.join(", "))))
            }
        }
    }
}

/// Names of the views that are fitted.
pub fn fitted(run: &Run) -> Vec<&str> {
    run.session().problem().targets.iter().map(|target| target.view.name.as_str()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_views_own_words_come_before_those_of_all() {
        let texts = ["a cat", "side = a dog", "front=a=b", "side=a bird"].map(str::to_owned);
        let wording = Wording::new(texts.iter());
        assert_eq!(["front", "side", "top"].map(|view| wording.of(view)), [Some("a=b"), Some("a bird"), Some("a cat")]);
        assert_eq!((wording.views(), wording.own("top")), (vec!["side", "front"], None));
    }
}
