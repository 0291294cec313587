//! Once warm, a pass of a rasteriser allocates nothing. Alone in its program: it counts every allocation.

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering};
use wire4d::raster::{BandRaster, ExactRaster, Raster};

#[path = "support/raster_wires/mod.rs"]
mod raster_wires;
use raster_wires::{FAMILIES, SIZE, wires};

struct Counting;
static ALLOCATIONS: AtomicUsize = AtomicUsize::new(0);

// SAFETY: passes everything on to the system's allocator.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.fetch_add(1, Ordering::Relaxed);
        // SAFETY: the caller keeps alloc's contract.
        unsafe { System.alloc(layout) }
    }
    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: the caller keeps dealloc's contract.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static COUNTING: Counting = Counting;

#[test]
fn warm_passes_allocate_nothing() {
    let scenes: Vec<_> = FAMILIES.iter().map(|family| wires(family, 1)).collect();
    let adjoint = vec![1.0; SIZE * SIZE];
    let mut d_vertices = Vec::new();
    let rasters: [&mut dyn Raster; 2] = [&mut ExactRaster::new(), &mut BandRaster::new()];
    for raster in rasters {
        let mut pass = || {
            let before = ALLOCATIONS.load(Ordering::Relaxed);
            for scene in &scenes {
                raster.forward(SIZE, SIZE, &scene.vertices, &scene.strokes);
                raster.backward(&adjoint, &mut d_vertices);
            }
            ALLOCATIONS.load(Ordering::Relaxed) - before
        };
        assert!(pass() > 0, "the first pass must grow its buffers, else nothing is counted");
        assert_eq!(pass(), 0);
    }
}
