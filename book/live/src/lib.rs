//! The book's figures that move: what a reader drags, the lessons' own code draws, compiled to WebAssembly.
//!
//! **To add a figure**, write a [`Figure`] in the file of its lesson and a row of [`FIGURES`]; there is nothing to write in
//! JavaScript or HTML, and nothing in the chapter. Its name is that of the still figure (a row of `FIGURES` beside the chapter)
//! in whose place it stands, or below which if it stays; the still one is there for print, and for readers without scripts.
//! Its inputs are what a reader can move: points of the drawing, sliders, choices from a table of methods, a picture that is
//! turned. Its function takes their values in the same order, calls the lesson, and returns a [`View`]: a
//! [`Sheet`](sheet::Sheet), as still figures are drawn on, or a picture of pixels; a sentence that says what is to be seen, and
//! perhaps a table of numbers. The first values should give what the still figure shows. `lines` has one with points and a
//! choice, `heads` have the head, which is turned.
//!
//! **To test it**, add five states to `states.json`: the name, the values of the inputs (a point has two, what is turned has
//! two, a choice the number of its row), and what is told. The test here compares that with what the function returns, and
//! `book/browser/live.js` with what the page shows, moved by mouse and keys. A change must take less than 16 ms, so draw on some
//! hundred shapes or 400 × 400 pixels at most, or as many pixels as [`Values::side`] says, which are fewer while they are dragged. A page loads the code of all figures: where a lesson has a loop for each of its
//! methods, a figure has one for all, as in `looks`; what takes longest is in `live-loops`. `cargo run -p book` builds the code
//! (`book/src/moving.rs` says how), `package live-wasm` exports it, `book/theme/live.js` is all that runs in the page besides.

mod antialiasing;
mod camera;
mod clipping;
mod few;
mod filtering;
mod gouraud;
mod head;
mod heads;
mod input;
mod kept;
mod lines;
mod looks;
mod packed;
mod perspective;
mod scene;
mod scenes;
mod textures;
mod transforms;
mod triangles;
mod view;
mod ways;
mod zbuffer;

pub use input::{Input, Range, Values};
pub use packed::{HEAD, give};
pub use textures::strips;
pub use transforms::LETTER;
pub use view::{Drawing, Rendered, View};

use sheet::fixed;

/// All figures that move. The page's script calls one by its number here, out of [`DRAWINGS`], whose length is to be told.
///
/// As a constant all that it calls would be compiled a second time in the crate that exports it.
pub static FIGURES: &[Figure] = &[
    heads::LINES,
    lines::IDEAL,
    lines::WU,
    heads::WIREFRAME,
    triangles::SWEEP,
    triangles::AREAS,
    triangles::SIGN,
    triangles::TOP_LEFT,
    heads::TRIANGLES,
    heads::ZBUFFER,
    zbuffer::CUT,
    zbuffer::FIGHTING,
    heads::TEXTURES,
    textures::STRIPS,
    heads::GOURAUD,
    gouraud::LIGHT,
    gouraud::COARSE,
    heads::TRANSFORMS,
    transforms::HOMOGENEOUS,
    transforms::ORDER,
    transforms::GIMBAL,
    transforms::DISTANCES,
    heads::CAMERA,
    camera::POLE,
    heads::SHADERS,
    scenes::PERSPECTIVE,
    perspective::FLOOR,
    scenes::CLIPPING,
    clipping::CASES,
    scenes::LIGHTING,
    scenes::FILTERING,
    filtering::FOOTPRINTS,
    scenes::BLENDING,
    antialiasing::HEAD,
    antialiasing::EDGE,
    scene::SCENE,
    scenes::SPEED,
];

/// What draws them, in the same order: all that a page calls. The words that go with figures and methods are in the page's
/// script, and would be loaded a second time with the code.
pub static DRAWINGS: [fn(Values) -> View; 37] = {
    let mut drawings = [FIGURES[0].draw; 37];
    assert!(drawings.len() == FIGURES.len());
    let mut n = 0;
    while n < drawings.len() {
        drawings[n] = FIGURES[n].draw;
        n += 1;
    }
    drawings
};

/// One figure.
pub struct Figure {
    /// That of its still figure.
    pub name: &'static str,
    /// Whether the still figure stays above it: where its caption tells of pictures that this one does not show.
    pub stays: bool,
    /// What a reader can do, in a sentence or two.
    pub hint: &'static str,
    /// What can be moved.
    pub inputs: &'static [Input],
    /// Draws it. The values are within the inputs' ranges.
    pub draw: fn(Values) -> View,
}

impl Figure {
    /// What it shows with its inputs set to these values. What is missing or no number is as at first, what is out of its
    /// range at the range's end.
    #[must_use]
    pub fn view(&self, values: &[f64]) -> View {
        let ranges = self.inputs.iter().flat_map(Input::ranges);
        let mut given = values.iter().copied();
        let values: Vec<f64> = ranges.map(|range| range.nearest(given.next().unwrap_or(f64::NAN))).collect();
        (self.draw)(Values::new(&values, false))
    }
}

/// A number with three digits behind the point and a true minus.
pub(crate) fn number(x: f32) -> String {
    fixed(x, 3).replace('-', "−")
}

/// A whole number with a true minus.
pub(crate) fn whole(x: f32) -> String {
    (x as i32).to_string().replace('-', "−")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(serde::Deserialize)]
    struct State {
        figure: String,
        values: Vec<f64>,
        told: String,
    }

    fn states() -> Vec<State> {
        serde_json::from_str(include_str!("../states.json")).unwrap()
    }

    #[test]
    fn figures_tell_what_the_states_say() {
        for State { figure, values, told } in states() {
            let figure = FIGURES.iter().find(|known| known.name == figure).unwrap();
            assert_eq!(figure.view(&values).told, told, "{} {values:?}", figure.name);
        }
    }

    #[test]
    fn what_may_take_long_has_half_the_width_while_it_is_dragged() {
        let mut halved = Vec::new();
        for figure in FIGURES {
            let first: Vec<f64> =
                figure.inputs.iter().flat_map(Input::ranges).map(|range| range.from).collect();
            let [whole, coarse] =
                [false, true].map(|coarse| (figure.draw)(Values::new(&first, coarse)).drawing);
            if let (Drawing::Pixels(whole), Drawing::Pixels(coarse)) = (whole, coarse) {
                if 2 * coarse.width() == whole.width() {
                    halved.push(figure.name.split('-').next().unwrap());
                } else {
                    assert!(whole == coarse, "{}", figure.name);
                }
            }
        }
        let lessons = ["perspective", "clipping", "lighting", "filtering", "blending", "scene", "speed"];
        assert_eq!(halved, lessons);
    }

    #[test]
    fn each_figure_has_five_states_that_differ() {
        for figure in FIGURES {
            let states = states();
            let own: Vec<_> = states.iter().filter(|state| state.figure == figure.name).collect();
            let width: usize = figure.inputs.iter().map(|input| input.ranges().count()).sum();
            let told: std::collections::BTreeSet<_> = own.iter().map(|state| &state.told).collect();
            assert!(told.len() >= 5, "{}: {} different states", figure.name, told.len());
            assert!(own.iter().all(|state| state.values.len() == width), "{}: {width} values", figure.name);
        }
    }

    /// What no slider gives does no harm: it is as if the slider were at its end, or had not been touched.
    #[test]
    fn any_numbers_are_values() {
        for figure in FIGURES {
            let first = figure.view(&[]).told;
            assert_eq!(figure.view(&[f64::NAN; 40]).told, first, "{}", figure.name);
            for value in [f64::INFINITY, f64::NEG_INFINITY, 1e300, -1e300, 0.1] {
                assert!(!figure.view(&[value; 40]).told.is_empty(), "{}", figure.name);
            }
        }
    }
}
