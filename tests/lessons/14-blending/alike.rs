//! What is left out costs nothing, and changes nothing: with everything off the pixels are lesson 13's.

use std::path::Path;

use allocation_counter::measure;
use blending::blend::BlendStage;
use blending::crates::CRATE;
use blending::flags::StateFlags;
use blending::scene::View;
use blending::{
    AnyState, Compare, DepthTest, Framebuffer, METHODS, Operations, Over, State, StencilTest, TwoShift,
    WriteMask, crates, plain,
};
use clap::{Args, Command, FromArgMatches};
use clipping::{Clipping, Cull, SLABS, render};
use common::{Attributes, Color, Format, Image, Mat4, Model, Vec3};
use filtering::filter::{Anisotropic, Nearest, Trilinear};
use filtering::scene::{Filterable, fine};
use filtering::shader::Filtered;
use filtering::{MIPMAPS, Surface, Wrap};
use lighting::PointLight;
use perspective::lighting::Clamped;
use perspective::scene::Loaded;
use perspective::{perspective, view};
use verify::method;

pub(crate) fn read([model, texture]: [&str; 2]) -> Filterable {
    let texture = Image::read(Path::new(texture)).unwrap();
    textured(model, if texture.width() < 16 { fine(&texture) } else { texture })
}

pub(crate) fn textured(model: &str, texture: Image) -> Filterable {
    let model = Model::read(Path::new(model), Attributes { normals: true, uvs: true }).unwrap();
    Filterable::new(
        Loaded::new(model, texture, Default::default()),
        *method(MIPMAPS, "box-linear"),
        Wrap::Repeat,
    )
}

pub(crate) const HEAD: [&str; 2] =
    [common::program::model::DEFAULT_MODEL, common::program::model::DEFAULT_TEXTURE];

pub(crate) const FLOOR: [&str; 2] = SLABS;
pub(crate) const WOOD: [&str; 2] = CRATE;

/// Lesson 13's view, of a picture that is wider than high.
fn to_clip() -> Mat4 {
    let looks = view(Vec3::new(2.0, 0.2, 3.3), Vec3::new(0.3, -0.35, 0.0), Vec3::Y);
    perspective(45.0, 160.0 / 120.0, 0.1, 100.0).unwrap() * looks.unwrap()
}

/// Draws lesson 13's scene into this lesson's framebuffer, under that state.
fn drawn<F: filtering::filter::Filter>(
    surfaces: &[Surface],
    filter: F,
    state: impl Operations,
) -> (Image, Vec<f32>) {
    let mut image = Image::new(160, 120, Format::Rgb);
    let size = image.size();
    let mut target = Framebuffer::new(&mut image, state);
    for &Surface { uniforms, mesh, texture } in surfaces {
        let shader = Filtered { uniforms, texture, filter, lighting: Clamped, size };
        render(&shader, mesh, Cull::Back, Clipping::GuardBand, &mut target);
    }
    let depths = target.depths;
    let depths = image.pixels().map(|(x, y, _)| depths.get(x, y)).collect();
    (image, depths)
}

#[test]
fn with_everything_off_pixels_and_depths_are_lesson_13s() {
    let models = [read(HEAD), read(SLABS)];
    let surfaces = models.each_ref().map(|model| model.surface(Vec3::new(0.3, 0.7, 0.6), to_clip()));
    let lesson_13s = |filter: fn(&[Surface], Cull, &mut Image) -> clipping::Drawn| {
        let mut image = Image::new(160, 120, Format::Rgb);
        let depths = filter(&surfaces, Cull::Back, &mut image).depths;
        let depths: Vec<f32> = image.pixels().map(|(x, y, _)| depths.get(x, y)).collect();
        (image, depths)
    };
    let draw = |name| method(filtering::METHODS, name).draw;
    assert!(drawn(&surfaces, Nearest, State::OFF) == lesson_13s(draw("nearest")));
    assert!(drawn(&surfaces, Trilinear, State::OFF) == lesson_13s(draw("trilinear")));
    assert!(drawn(&surfaces, Anisotropic, State::OFF) == lesson_13s(draw("anisotropic")));
    // Nor does it matter whether a part is left out by its type, or when the program runs, or does nothing.
    let expected = lesson_13s(draw("nearest"));
    let nothing = State::<_, _, _, _, _> {
        scissor: None::<common::Bounds>,
        stencil: None::<StencilTest>,
        depth: Some(DepthTest { function: Compare::Less, write: true }),
        blend: None::<Over>,
        mask: None::<WriteMask>,
    };
    assert!(drawn(&surfaces, Nearest, nothing) == expected);
    assert!(drawn(&surfaces, Nearest, AnyState::USUAL) == expected, "what is opaque replaces");
    let whole = common::Bounds { min: common::IVec2::ZERO, max: common::IVec2::new(159, 119) };
    let state = State {
        scissor: whole,
        stencil: StencilTest::ALWAYS,
        depth: nothing.depth,
        blend: (),
        mask: WriteMask::ALL,
    };
    assert!(drawn(&surfaces, Nearest, state) == expected);
}

pub(crate) fn crate_view() -> View {
    let eye = Vec3::new(0.6, 1.2, 3.25);
    let to_clip = perspective(45.0, 1.0, 0.1, 100.0).unwrap() * view(eye, Vec3::ZERO, Vec3::Y).unwrap();
    View { to_clip, eye, light: PointLight::default() }
}

/// By each way to divide, what is compiled for layers alone and what is decided when the program runs.
#[test]
fn options_and_types_draw_the_same() {
    let model = read(CRATE);
    for row in METHODS {
        let [mut a, mut b] = [(); 2].map(|()| Image::new(150, 150, Format::Rgba));
        let drawn = (row.run.entities)(&crates::entities(&model), &crate_view(), &mut a);
        let target = Framebuffer::new(&mut b, AnyState::USUAL);
        let (target, counts) = (row.run.entities_under)(target, &crates::entities(&model), &crate_view());
        assert!(target.depths == drawn.depths && counts == drawn.counts, "{}", row.name);
        // What is opaque is divided, too, when the program runs; one way does not leave it as it is.
        assert_eq!(a == b, row.name != "shift-8", "{}", row.name);
    }
}

/// What is seen through the small crate is the large one, and half of each.
#[test]
fn half_of_the_small_crate_is_seen() {
    let model = read(CRATE);
    let [large, small] = crates::entities(&model);
    let draw = |entities: &[_]| {
        let mut image = Image::new(150, 150, Format::Rgb);
        (method(METHODS, "two-shift").entities)(entities, &crate_view(), &mut image);
        image
    };
    let (behind, both) = (draw(&[large]), draw(&[large, small]));
    let alone = draw(&[blending::scene::Entity { alpha: 1.0, ..small }]);
    let mut count = 0;
    for (x, y, color) in both.pixels() {
        let [behind, alone] = [&behind, &alone].map(|image| image.get(x, y).unwrap());
        if alone == Color::BLACK {
            assert_eq!(color, behind);
        } else {
            count += 1;
            assert_eq!(color, Over(TwoShift).color(Color { a: 127, ..alone }, behind), "({x}, {y})");
        }
    }
    assert!(count > 1000, "{count}");
    // The order of the two is the program's: the opaque one comes first, whichever is named first.
    assert!(draw(&[small, large]) == both);
}

/// Where there is no stencil there is no memory for one, and no triangle or fragment allocates.
#[test]
fn what_is_left_out_takes_no_memory_and_drawing_none() {
    assert_eq!(size_of::<State>(), 0);
    let mut image = Image::new(100, 80, Format::Rgb);
    let bytes =
        |state: &dyn Fn(&mut Image)| measure(|| state(&mut Image::new(100, 80, Format::Rgb))).bytes_total;
    let without = bytes(&|image| drop(Framebuffer::new(image, State::OFF)));
    let with = bytes(&|image| drop(Framebuffer::new(image, AnyState::USUAL)));
    assert_eq!(with - without, 100 * 80);
    let mut target = Framebuffer::new(&mut image, AnyState::USUAL);
    let corners = [Vec3::new(-9.0, -3.0, 0.5), Vec3::new(120.0, 1.0, 0.25), Vec3::new(3.0, 90.0, 0.75)];
    let surfaces = [zbuffer::Surface { corners, color: Color { a: 90, ..Color::RED } }; 10];
    assert_eq!(measure(|| plain::draw(&surfaces, &mut target)).count_total, 0);
}

/// The flags' defaults are the usual state, and each flag makes another one.
#[test]
fn flags_say_the_usual_state_unless_told_otherwise() {
    let flags = |arguments: &[&str]| {
        let command = StateFlags::augment_args(Command::new("test").no_binary_name(true));
        StateFlags::from_arg_matches(&command.try_get_matches_from(arguments).unwrap()).unwrap()
    };
    assert!(flags(&[]).state() == AnyState::USUAL && !flags(&[]).are_given());
    for arguments in [
        ["--scissor", "0,0,800,800"],
        ["--stencil", "a.png"],
        ["--depth-test", "lequal"],
        ["--blend", "one,one"],
        ["--blend-alpha", "one,one"],
        ["--blend-color", "ff0000"],
        ["--equation", "reverse-subtract"],
        ["--logic", "copy"],
        ["--write-mask", "rgb"],
    ] {
        assert!(flags(&arguments).are_given(), "{arguments:?}");
    }
}
