//! Work that is done at once or later: a processor has finished when the call returns, a device while one waits.

use std::future::Future;
use std::pin::{Pin, pin};
use std::task::{Context, Poll, Waker};

/// What an engine was asked to do.
pub enum Work<'a, T = ()> {
    /// It is done. Costs nothing, not even memory.
    Done(T),
    /// It will be done.
    Later(Pin<Box<dyn Future<Output = T> + 'a>>),
}

impl<'a, T> Work<'a, T> {
    /// Work that a future does.
    pub fn later(work: impl Future<Output = T> + 'a) -> Work<'a, T> {
        Work::Later(Box::pin(work))
    }

    /// What came of it, once it is done.
    pub async fn done(self) -> T {
        match self {
            Work::Done(result) => result,
            Work::Later(work) => work.await,
        }
    }
}

/// Drives `work` to its end on this thread, without allocating. For work that does not need the thread's own event loop
/// to get on: a browser's devices do, processors and native devices do not.
pub fn wait<T>(work: impl Future<Output = T>) -> T {
    let mut work = pin!(work);
    let mut context = Context::from_waker(Waker::noop());
    loop {
        if let Poll::Ready(result) = work.as_mut().poll(&mut context) {
            return result;
        }
        std::thread::yield_now();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::future::poll_fn;

    #[test]
    fn work_comes_to_its_end_at_once_or_later() {
        assert_eq!(wait(Work::Done(3).done()), 3);
        let mut polls = 0;
        let later = Work::later(poll_fn(|_| {
            polls += 1;
            if polls < 4 { Poll::Pending } else { Poll::Ready(polls) }
        }));
        assert_eq!(wait(later.done()), 4);
    }
}
