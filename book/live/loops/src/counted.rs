//! Lesson 17's methods, with what they shade counted.

use std::cell::{Cell, RefCell};

use common::{Color, Image, Method, Vec2};
use fearless_simd::{Simd, f32x8, u32x8};
use filtering::Texture;
use filtering::filter::{Filter, Nearest};
use filtering::layout::Layout;
use speed::filters::{Textured, WideFilter};
use speed::{Drawer, Picture, Renderer};

/// How much was shaded.
#[derive(Clone, Copy, Debug, Default)]
pub struct Shaded {
    /// How many fragments.
    pub fragments: u32,
    /// How often a shader was called for them, each time for one or for up to eight.
    pub calls: u32,
}

thread_local! {
    static SHADED: Cell<Shaded> = const { Cell::new(Shaded { fragments: 0, calls: 0 }) };
    /// Who drew last, by which method and in which size: memory is kept from one picture to the next.
    static LAST: RefCell<Option<(&'static str, [i32; 2], Drawer)>> = const { RefCell::new(None) };
}

/// Draws by a method on this thread, with the nearest texel. Tells what was shaded.
pub fn draw(method: &Method<Renderer>, picture: &Picture, image: &mut Image) -> Shaded {
    SHADED.set(Shaded::default());
    let size = [image.width(), image.height()];
    LAST.with_borrow_mut(|last| {
        let drawer = match last.take() {
            Some((name, of, drawer)) if (name, of) == (method.name, size) => drawer,
            _ => method.run.drawer_by::<Counted>(size, 1),
        };
        let (.., drawer) = last.insert((method.name, size, drawer));
        drawer(picture, image);
    });
    SHADED.get()
}

/// Lesson 13's nearest texel, counted.
#[derive(Clone, Copy, Default)]
struct Counted;

fn count(fragments: u32) {
    let Shaded { fragments: before, calls } = SHADED.get();
    SHADED.set(Shaded { fragments: before + fragments, calls: calls + 1 });
}

impl Filter for Counted {
    type Footprint = ();

    #[inline]
    fn color<L: Layout>(self, texture: &Texture<L>, uv: Vec2, (): ()) -> Color {
        count(1);
        Nearest.color(texture, uv, ())
    }
}

impl WideFilter for Counted {
    // In the code once, as it is asked for in several places.
    #[inline(never)]
    fn colors<S: Simd>(
        self,
        simd: S,
        texture: &Texture,
        uv: [f32x8<S>; 2],
        eight: &Textured<S, Self>,
    ) -> u32x8<S> {
        count(eight.asked.count_ones());
        Nearest.colors(simd, texture, uv, eight)
    }
}
