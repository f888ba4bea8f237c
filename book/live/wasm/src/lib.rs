//! What a page calls of the figures that move: six functions for all of them, compiled to WebAssembly.
//!
//! Numbers go in one by one; what was drawn comes out as bytes in the memory that the page can read. Only names are
//! exported here, which the language calls unsafe; nothing else is.

use std::sync::{Mutex, MutexGuard, PoisonError};

use live::{Rendered, Values};

/// What the inputs of the figure to be drawn are set to.
static VALUES: Mutex<Vec<f64>> = Mutex::new(Vec::new());
/// What was drawn last.
static RENDERED: Mutex<Option<Rendered>> = Mutex::new(None);

fn locked<T>(what: &Mutex<T>) -> MutexGuard<'_, T> {
    what.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Adds a number to what the inputs are set to.
#[unsafe(no_mangle)]
pub extern "C" fn push(value: f64) {
    locked(&VALUES).push(value);
}

/// Takes what was pushed as the bytes of `live::HEAD`, before anything is drawn, and forgets that.
#[unsafe(no_mangle)]
pub extern "C" fn give() {
    let values = std::mem::take(&mut *locked(&VALUES));
    live::give(values.iter().map(|&byte| byte as u8).collect());
}

/// Draws the figure of that number in `live::FIGURES`, its inputs set to what was pushed, a number for each value and within its
/// range, and forgets that. A `coarse` picture may have fewer pixels.
#[unsafe(no_mangle)]
pub extern "C" fn draw(figure: usize, coarse: bool) {
    let values = std::mem::take(&mut *locked(&VALUES));
    *locked(&RENDERED) =
        live::DRAWINGS.get(figure).map(|draw| Rendered::of(draw(Values::new(&values, coarse))));
}

/// Where the bytes of a part begin, of those that `live::Rendered` lists, until something else is drawn.
#[unsafe(no_mangle)]
pub extern "C" fn start(part: usize) -> *const u8 {
    locked(&RENDERED).as_ref().map_or(&[][..], |rendered| rendered.part(part)).as_ptr()
}

/// How many bytes a part has.
#[unsafe(no_mangle)]
pub extern "C" fn length(part: usize) -> usize {
    locked(&RENDERED).as_ref().map_or(0, |rendered| rendered.part(part).len())
}

/// A number of the drawing, of those that `live::Rendered` lists; 0 of one that it has not.
#[unsafe(no_mangle)]
pub extern "C" fn number(n: usize) -> f64 {
    locked(&RENDERED).as_ref().and_then(|rendered| rendered.numbers.get(n).copied()).unwrap_or_default()
}

/// Functions that the standard library calls by C's names. The lessons have the crate `libm` anyway, and the compiler's own copy
/// would be loaded as well; a linker takes what is defined here before that. They are exported, too, and no page calls them.
#[cfg(target_family = "wasm")]
mod math {
    macro_rules! by_libm {
        ($($name:ident($($x:ident),+: $number:ty))*) => {$(
            #[unsafe(no_mangle)]
            extern "C" fn $name($($x: $number),+) -> $number {
                libm::$name($($x),+)
            }
        )*};
    }

    by_libm! {
        cos(x: f64)
        cosf(x: f32)
        exp2f(x: f32)
        hypot(x, y: f64)
        log2(x: f64)
        log2f(x: f32)
        powf(x, y: f32)
        sin(x: f64)
        sinf(x: f32)
        tan(x: f64)
    }
}
