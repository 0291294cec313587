//! Sorting where time is not short. Each sort of the standard library's is compiled anew for each type and order, 5 kB in the
//! page's module; these share one.

use std::cmp::Ordering;

/// Sorts by a comparison; what is equal stays in its order.
pub fn sort_by<T: Clone>(items: &mut [T], compare: impl Fn(&T, &T) -> Ordering) {
    let mut order: Vec<u32> = (0..items.len() as u32).collect();
    sort_places(&mut order, &|a, b| compare(&items[a as usize], &items[b as usize]));
    let sorted: Vec<T> = order.into_iter().map(|place| items[place as usize].clone()).collect();
    items.clone_from_slice(&sorted);
}

/// Sorts by a key; what has the same stays in its order.
pub fn sort_by_key<T: Clone, K: Ord>(items: &mut [T], key: impl Fn(&T) -> K) {
    sort_by(items, |a, b| key(a).cmp(&key(b)));
}

fn sort_places(order: &mut [u32], compare: &dyn Fn(u32, u32) -> Ordering) {
    order.sort_unstable_by(|&a, &b| compare(a, b).then(a.cmp(&b)));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sorts_as_the_standard_library_does() {
        let items: Vec<(u32, String)> = (0..200u32).map(|i| (i * 7919 % 13, format!("{i}"))).collect();
        let (mut ours, mut theirs) = (items.clone(), items);
        sort_by_key(&mut ours, |item| item.0);
        theirs.sort_by_key(|item| item.0);
        assert_eq!(ours, theirs);
        sort_by(&mut ours, |a, b| b.1.cmp(&a.1));
        theirs.sort_by(|a, b| b.1.cmp(&a.1));
        assert_eq!(ours, theirs);
    }
}
