//! What edges cost: depths and colours, but no shading; and no memory from picture to picture.

use antialiasing::area::Area;
use antialiasing::multisampled::{Multisampled, PerPixel, PerSample};
use antialiasing::ordered::Ordered;
use antialiasing::resolve::Resolve;
use antialiasing::storage::{Compressed, Samples};
use antialiasing::{Canvas, Scene, World, resolve};
use blending::Operations;
use blending::scene::{Entity, View};
use clipping::Cull;
use common::{Attributes, Color, Format, Image, Mat4, Model, Vec2, Vec3, Vec4};
use filtering::scene::Filterable;
use filtering::{MIPMAPS, Wrap};
use lighting::PointLight;
use perspective::perspective;
use perspective::scene::Loaded;
use shaders::shader::{Fragment, Varying};
use verify::{CRATE, method};
use zbuffer::DepthBuffer;

/// A canvas whose calls for a colour are counted.
struct Counted<C> {
    canvas: C,
    calls: usize,
}

impl<C: Canvas> Canvas for Counted<C> {
    type Stencil = C::Stencil;

    fn new(size: [usize; 2], alpha_to_coverage: bool) -> Self {
        Self { canvas: C::new(size, alpha_to_coverage), calls: 0 }
    }

    fn clear(&mut self, background: Color) {
        self.canvas.clear(background);
    }

    fn size(&self) -> Vec2 {
        self.canvas.size()
    }

    fn fill<V: Varying>(
        &mut self,
        state: impl Operations<Stencil = C::Stencil>,
        corners: [Vec4; 3],
        varyings: [V; 3],
        mut shade: impl FnMut(Fragment<V>) -> Option<Color>,
    ) {
        let calls = &mut self.calls;
        self.canvas.fill(state, corners, varyings, |fragment| {
            *calls += 1;
            shade(fragment)
        });
    }

    fn resolve(&self, resolve: Resolve, picture: &mut Image) {
        self.canvas.resolve(resolve, picture);
    }

    fn depths(&self, picture: &Image) -> DepthBuffer<f32> {
        self.canvas.depths(picture)
    }
}

/// The course's head.
fn head() -> Filterable {
    let needs = Attributes { normals: true, uvs: true };
    let model = Model::read(common::program::model::DEFAULT_MODEL.as_ref(), needs).unwrap();
    let loaded = Loaded::new(model, Image::read(CRATE.as_ref()).unwrap(), textures::Wrap::Repeat);
    Filterable::new(loaded, *method(MIPMAPS, "box-linear"), Wrap::Repeat)
}

/// Lets `with` have a scene of the head, as from (1, 1, 2), in a picture of that size.
fn before_the_head<R>(size: [u16; 2], with: impl FnOnce(&Scene, Image) -> R) -> R {
    let model = head();
    let eye = Vec3::new(1.0, 1.0, 2.0);
    let aspect = f32::from(size[0]) / f32::from(size[1]);
    let to_clip = perspective(45.0, aspect, 0.1, 100.0).unwrap() * perspective::view(eye, Vec3::ZERO, Vec3::Y).unwrap();
    let view = View { to_clip, eye, light: PointLight { position: eye, ..PointLight::default() } };
    let entities = [Entity { model: &model, to_world: Mat4::IDENTITY, alpha: 1.0 }];
    let world = Some(World { entities: &entities, view, cull: Cull::Back });
    let scene = Scene { background: Color::WHITE, triangles: &[], world, alpha_to_coverage: false, resolve };
    with(&scene, Image::new(size[0], size[1], Format::Rgb))
}

/// How often the head is shaded by a canvas, in pictures of 640×480.
fn calls<C: Canvas<Stencil = ()>>() -> usize {
    before_the_head([640, 480], |scene, image| {
        let mut canvas = Counted::<C>::new([640, 480], false);
        scene.draw_to(&image, &mut canvas);
        canvas.calls
    })
}

/// Sixteen samples are shaded 1.35 times as often as one at most, where each by itself would be shaded 16 times as often.
#[test]
fn sixteen_samples_cost_little_more_shading_than_one() {
    let once = calls::<Multisampled<1, Samples<1>>>();
    let times = |calls: usize| calls as f64 / once as f64;
    assert!(once > 50_000, "{once}");
    let sixteen = times(calls::<Multisampled<16, Samples<16>>>());
    assert!(sixteen > 1.1 && sixteen <= 1.35, "{sixteen}");
    assert_eq!(calls::<Multisampled<16, Compressed<16>>>(), calls::<Multisampled<16, Samples<16>>>());
    let [two, four, eight] = [
        calls::<Multisampled<2, Samples<2>>>(),
        calls::<Multisampled<4, Samples<4>>>(),
        calls::<Multisampled<8, Samples<8>>>(),
    ]
    .map(times);
    assert!(1.0 < two && two < four && four < eight && eight < sixteen, "{two}, {four}, {eight}, {sixteen}");
    let each = times(calls::<Multisampled<16, Samples<16>, PerSample>>());
    assert!((each - 16.0).abs() < 0.5, "{each}");
    let ordered = times(calls::<Ordered>());
    assert!((ordered - 16.0).abs() < 0.5, "{ordered}");
}

/// From the second picture on a canvas allocates what lesson 11's loop does, its vertices, and nothing for pixels, triangles
/// or samples.
#[test]
fn a_canvas_that_is_kept_allocates_nothing() {
    fn allocations<C: Canvas<Stencil = ()>>(size: [u16; 2]) -> u64 {
        before_the_head(size, |scene, mut image| {
            let mut canvas = C::new(size.map(usize::from), false);
            let mut draw = || {
                scene.draw_to(&image, &mut canvas);
                canvas.resolve(scene.resolve, &mut image);
            };
            draw();
            allocation_counter::measure(draw).count_total
        })
    }
    type Count = fn([u16; 2]) -> u64;
    let canvases: [Count; 6] = [
        allocations::<Multisampled<1, Samples<1>>>,
        allocations::<Multisampled<4, Samples<4>, PerSample>>,
        allocations::<Multisampled<16, Samples<16>>>,
        allocations::<Multisampled<16, Compressed<16>, PerPixel>>,
        allocations::<Ordered>,
        allocations::<Area>,
    ];
    for (n, canvas) in canvases.into_iter().enumerate() {
        assert_eq!([[60, 40], [160, 120]].map(canvas), [1; 2], "{n}");
    }
}
