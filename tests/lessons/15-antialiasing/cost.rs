//! What edges cost: depths and colours, but no shading; and no memory from picture to picture.

use antialiasing::area::Area;
use antialiasing::canvas::render_with;
use antialiasing::multisampled::{Multisampled, PerPixel, PerSample};
use antialiasing::ordered::Ordered;
use antialiasing::resolve::Resolve;
use antialiasing::storage::{Compressed, Samples};
use antialiasing::{Canvas, Scene, World, resolve};
use blending::scene::{Entity, View};
use blending::{Operations, State};
use clipping::render::Vertices;
use clipping::{Cull, Mesh};
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

    fn new(size: [usize; 2]) -> Self {
        Self { canvas: C::new(size), calls: 0 }
    }

    fn clear(&mut self, background: Color, alpha_to_coverage: bool) {
        self.canvas.clear(background, alpha_to_coverage);
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

/// Lets `with` have a scene of the head, as the lesson's own picture shows it, in a picture of that size.
fn before_the_head<R>(size: [u16; 2], with: impl FnOnce(&Scene, Image) -> R) -> R {
    let model = head();
    let (eye, center) = (Vec3::new(3.3, 0.25, 1.05), Vec3::new(0.0, -0.03, 0.0));
    let aspect = f32::from(size[0]) / f32::from(size[1]);
    let look = perspective::view(eye, center, Vec3::Y).unwrap();
    let to_clip = perspective(45.0, aspect, 0.1, 100.0).unwrap() * look;
    let view = View { to_clip, eye, light: PointLight::default() };
    let entities = [Entity { model: &model, to_world: Mat4::IDENTITY, alpha: 1.0 }];
    let world = Some(World { entities: &entities, view, cull: Cull::Back });
    let scene = Scene { background: Color::WHITE, triangles: &[], world, alpha_to_coverage: false, resolve };
    with(&scene, Image::new(size[0], size[1], Format::Rgb))
}

/// How often the head is shaded by a canvas.
fn calls<C: Canvas<Stencil = ()>>(size: [u16; 2]) -> f64 {
    before_the_head(size, |scene, image| {
        let mut canvas = Counted::<C>::new(size.map(usize::from));
        scene.draw_to(&image, &mut canvas);
        canvas.calls as f64
    })
}

/// In a picture of the usual size sixteen samples are shaded at most 1.35 times as often as one. The smaller the triangles are
/// on the screen, the more pixels are at the side of one, and are shaded once for each that they share: at a third of the
/// size it is twice as often.
#[test]
fn sixteen_samples_cost_little_more_shading_than_one() {
    let times = [[800, 800], [320, 240]].map(|size| {
        let once = calls::<Multisampled<1, Samples<1>>>(size);
        assert_eq!(
            calls::<Multisampled<16, Compressed<16>>>(size),
            calls::<Multisampled<16, Samples<16>>>(size)
        );
        let times = [
            calls::<Multisampled<2, Samples<2>>>(size),
            calls::<Multisampled<4, Samples<4>>>(size),
            calls::<Multisampled<8, Samples<8>>>(size),
            calls::<Multisampled<16, Samples<16>>>(size),
        ];
        times.map(|calls| calls / once)
    });
    for [two, four, eight, sixteen] in times {
        assert!(1.0 < two && two < four && four < eight && eight < sixteen, "{times:?}");
    }
    assert!(times[0][3] > 1.2 && times[0][3] <= 1.35, "{times:?}");
    assert!((1.8..2.1).contains(&times[1][3]), "{times:?}");
}

/// Where each sample is shaded by itself there are as many calls as samples, but for the luck of what is hidden.
#[test]
fn supersampling_shades_each_sample() {
    let size = [160, 120];
    let once = calls::<Multisampled<1, Samples<1>>>(size);
    let each = calls::<Multisampled<16, Samples<16>, PerSample>>(size) / once;
    let ordered = calls::<Ordered>(size) / once;
    assert!((each - 16.0).abs() < 0.2 && (ordered - 16.0).abs() < 0.2, "{each}, {ordered}");
}

/// From the second picture on a canvas allocates what lesson 11's loop does, its vertices, and nothing for pixels, triangles
/// or samples.
#[test]
fn a_canvas_that_is_kept_allocates_nothing() {
    fn allocations<C: Canvas<Stencil = ()>>(size: [u16; 2]) -> u64 {
        before_the_head(size, |scene, mut image| {
            let mut canvas = C::new(size.map(usize::from));
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

/// Vertices that are kept, too, are not allocated again, and a mesh drawn with what another left in them is the same.
#[test]
fn with_vertices_that_are_kept_nothing_is_allocated() {
    before_the_head([160, 120], |scene, mut image| {
        let World { entities, view, cull } = scene.world.unwrap();
        let shader = entities[0].shader(&view, image.size()).unwrap();
        let mesh = entities[0].mesh();
        let half = Mesh { faces: mesh.faces[..mesh.faces.len() / 2].to_vec(), ..mesh.clone() };
        let mut canvas = Multisampled::<16, Compressed<16>>::new([160, 120]);
        let mut drawn = |vertices: &mut Vertices<_>, mesh: &Mesh| {
            canvas.clear(Color::WHITE, false);
            let counts = render_with(vertices, &shader, mesh, cull, State::OFF, &mut canvas);
            canvas.resolve(resolve, &mut image);
            (counts, image.clone())
        };
        let expected = drawn(&mut Vertices::default(), &half);
        let mut kept = Vertices::default();
        assert_ne!(drawn(&mut kept, mesh), expected);
        assert_eq!(drawn(&mut kept, &half), expected);
        let mut draw = || {
            render_with(&mut kept, &shader, mesh, cull, State::OFF, &mut canvas);
        };
        draw();
        assert_eq!(allocation_counter::measure(draw).count_total, 0);
    });
}
