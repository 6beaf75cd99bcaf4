//! Bytes that are held now, as the C library hands them out, counted as ../s_table/counted_memory.h counts those of others.

use std::alloc::{GlobalAlloc, Layout, System};
use std::ffi::c_void;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

extern "C" {
    fn malloc_usable_size(block: *mut c_void) -> usize;
}

struct Counted;
static LIVE: AtomicUsize = AtomicUsize::new(0);

#[global_allocator]
static ALLOCATOR: Counted = Counted;

pub fn live() -> usize {
    LIVE.load(Relaxed)
}

unsafe fn size(block: *mut u8) -> usize {
    malloc_usable_size(block.cast())
}

unsafe impl GlobalAlloc for Counted {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let block = System.alloc(layout);
        LIVE.fetch_add(size(block), Relaxed);
        block
    }
    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        let block = System.alloc_zeroed(layout);
        LIVE.fetch_add(size(block), Relaxed);
        block
    }
    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        LIVE.fetch_sub(size(block), Relaxed);
        System.dealloc(block, layout);
    }
    unsafe fn realloc(&self, block: *mut u8, layout: Layout, new_size: usize) -> *mut u8 {
        LIVE.fetch_sub(size(block), Relaxed);
        let moved = System.realloc(block, layout, new_size);
        LIVE.fetch_add(size(if moved.is_null() { block } else { moved }), Relaxed);
        moved
    }
}
