//! Loops over cores where there are any: with and without threads the same results, bit for bit.

/// `make` of every item, in their order; a thread takes at least `least` of them at a time.
#[cfg(feature = "threads")]
pub fn map<T: Sync, R: Send>(items: &[T], least: usize, make: impl Fn(&T) -> R + Sync + Send) -> Vec<R> {
    use rayon::prelude::*;
    items.par_iter().with_min_len(least).map(make).collect()
}

/// `make` of every item, in their order.
#[cfg(not(feature = "threads"))]
pub fn map<T, R>(items: &[T], _least: usize, make: impl Fn(&T) -> R) -> Vec<R> {
    items.iter().map(make).collect()
}

/// `make` of every item, in their order; each thread with a state of its own.
#[cfg(feature = "threads")]
pub fn map_with<T: Sync, S: Send, R: Send>(
    items: &[T],
    state: impl Fn() -> S + Sync + Send,
    make: impl Fn(&mut S, &T) -> R + Sync + Send,
) -> Vec<R> {
    use rayon::prelude::*;
    items.par_iter().map_init(state, make).collect()
}

/// `make` of every item, in their order; each thread with a state of its own.
#[cfg(not(feature = "threads"))]
pub fn map_with<T, S, R>(items: &[T], state: impl Fn() -> S, make: impl Fn(&mut S, &T) -> R) -> Vec<R> {
    let mut state = state();
    items.iter().map(|item| make(&mut state, item)).collect()
}

/// `work` on every item and its index; on several threads where there are at least `least` of them.
pub fn each_mut<T: Send>(items: &mut [T], least: usize, work: impl Fn(usize, &mut T) + Send + Sync) {
    #[cfg(feature = "threads")]
    if items.len() >= least && rayon::current_num_threads() > 1 {
        use rayon::prelude::*;
        items.par_iter_mut().enumerate().for_each(|(i, item)| work(i, item));
        return;
    }
    let _ = least;
    items.iter_mut().enumerate().for_each(|(i, item)| work(i, item));
}
