//! An iteration of a fit allocates nothing once its buffers have grown. One thread, so that each test sees its own.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use wire4d::optimize::{Bending, Problem, RasterKind, Recipe, Session, Stage};

#[path = "support/optimize_common/mod.rs"]
mod common;

thread_local! {
    // Const and without a destructor: reading it allocates nothing.
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
}

struct Counting;

// SAFETY: everything is passed on to the system's allocator; counting touches a thread-local number only.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.set(ALLOCATIONS.get() + 1);
        // SAFETY: as the caller promises.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: as the caller promises.
        unsafe { System.dealloc(pointer, layout) }
    }

    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        ALLOCATIONS.set(ALLOCATIONS.get() + 1);
        // SAFETY: as the caller promises.
        unsafe { System.realloc(pointer, layout, size) }
    }
}

#[global_allocator]
static COUNTING: Counting = Counting;

/// How often `work` asks for memory.
fn allocations(work: impl FnOnce()) -> usize {
    let before = ALLOCATIONS.get();
    work();
    ALLOCATIONS.get() - before
}

/// On this thread or on the only one of a pool.
fn on_one_thread<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    #[cfg(feature = "threads")]
    return rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap().install(work);
    #[cfg(not(feature = "threads"))]
    work()
}

const ITERATIONS: usize = 160;

/// The rasteriser's buffers grow with what it meets, a few times while the wire moves fast.
const WARM: usize = 80;

fn session(raster: RasterKind, bending: Option<Bending>) -> Session {
    let truth = common::random_wire(60, 3);
    let stage = Stage { iterations: ITERATIONS, size_px: 64, raster, samples_per_span: 4, restarts: vec![] };
    let recipe = Recipe { stages: vec![stage], bending, ..Recipe::best() };
    let problem = Problem::for_drawings(common::perturbed(&truth, 0.02, 8), common::targets_of(&truth, 64), recipe);
    Session::new(problem).unwrap()
}

/// Allocations of each iteration but the last, whose event is handed out.
fn counts(raster: RasterKind, bending: Option<Bending>, between: fn(&mut Session)) -> Vec<usize> {
    on_one_thread(|| {
        let mut session = session(raster, bending);
        let mut counts = Vec::with_capacity(ITERATIONS);
        for _ in 1..ITERATIONS {
            counts.push(allocations(|| {
                assert!(session.step(1).len() <= 1);
                between(&mut session);
            }));
        }
        counts
    })
}

#[test]
fn warm_iterations_allocate_nothing() {
    for (raster, bending) in [
        (RasterKind::Exact, None),
        (RasterKind::Exact, Some(Bending { from: 0.0, ..Bending::default() })),
        (RasterKind::Band, None),
    ] {
        let what = format!("{raster:?}, bending {}", bending.is_some());
        let counts = counts(raster, bending, |_| ());
        let growing: usize = counts[1..WARM].iter().sum();
        println!("{what}: {} at first, {growing} in the next {WARM}", counts[0]);
        assert!(counts[0] > 10, "{what}: the first iteration makes the buffers");
        assert!(growing < 100, "{what}: buffers grow {growing} times");
        assert_eq!(counts[WARM..].iter().sum::<usize>(), 0, "{what}: {:?}", &counts[WARM..]);
    }
}

#[test]
fn one_allocation_an_iteration_is_seen() {
    // A copy of one view's picture.
    let counts = counts(RasterKind::Band, None, |session| drop(session.coverage(0)));
    assert!(counts[WARM..].iter().all(|&count| count >= 1), "{:?}", &counts[WARM..]);
}
