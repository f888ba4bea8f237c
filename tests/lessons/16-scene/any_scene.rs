//! What holds for any scene: drawing it ends, and leaves a picture.

use std::sync::Arc;

use clipping::Cull;
use common::{Color, Mat4, Vec2, Vec3};
use lighting::PointLight;
use lighting::light::Falloff;
use proptest::num::f32::ANY;
use proptest::prelude::*;
use scene::versions::orthographic;
use scene::{
    Entity, Filtering, Levels, Mesh, Paint, Scene, Shading, Shape, Style, Target, cube, render_scene,
};

use crate::pictures::{SKY, ahead, covered, cube_of, different, patched_cube, sphere_of};

/// Numbers as scenes have them, and as they should not.
fn number(wild: bool) -> BoxedStrategy<f32> {
    let usual = prop_oneof![
        4 => -5.0..5.0_f32,
        1 => prop::sample::select(vec![0.0, -0.0, 1.0, -1.0, 0.5]),
    ];
    if !wild {
        return usual.boxed();
    }
    let extreme = prop::sample::select(vec![
        f32::NAN,
        f32::INFINITY,
        f32::NEG_INFINITY,
        f32::MAX,
        f32::MIN,
        f32::MIN_POSITIVE,
        1e-45,
        1e30,
        -1e18,
        1e10,
        -65536.0,
    ]);
    prop_oneof![2 => usual, 1 => ANY, 1 => extreme].boxed()
}

fn vector(wild: bool) -> impl Strategy<Value = Vec3> {
    [number(wild), number(wild), number(wild)].prop_map(Vec3::from)
}

fn color() -> impl Strategy<Value = Color> {
    any::<[u8; 4]>().prop_map(|[r, g, b, a]| Color { r, g, b, a })
}

/// What a mesh is made of.
#[derive(Clone, Debug)]
enum Form {
    Cube(Color),
    Sphere(Color),
    Patched,
    /// Any triangles of a cube's vertices, moved anywhere, in any colours.
    Any {
        triangles: Vec<[u32; 3]>,
        positions: Vec<Vec3>,
        colors: Vec<Color>,
    },
}

impl Form {
    fn levels(&self) -> Arc<Levels> {
        match self {
            &Self::Cube(color) => cube_of(color),
            &Self::Sphere(color) => sphere_of(color),
            Self::Patched => patched_cube(),
            Self::Any { triangles, positions, colors } => {
                let mut vertices = cube().vertices;
                vertices.iter_mut().zip(positions).for_each(|(vertex, &position)| vertex.position = position);
                let shape = Shape { vertices, triangles: triangles.clone() };
                Levels::one(Mesh::new(&shape, Paint::Colors(colors.clone())))
            }
        }
    }
}

/// A mesh and its place.
#[derive(Clone, Debug)]
struct Thing {
    form: Form,
    place: [Vec3; 3],
    alpha: f32,
}

/// What a scene is made of.
#[derive(Clone, Debug)]
struct World {
    things: Vec<Thing>,
    lights: Vec<PointLight>,
    background: Color,
    style: Style,
}

impl World {
    fn scene(&self) -> Scene {
        let entity = |thing: &Thing| {
            let [position, degrees, scale] = thing.place;
            Entity { levels: thing.form.levels(), position, degrees, scale, alpha: thing.alpha }
        };
        let Self { lights, background, style, .. } = self.clone();
        Scene { entities: self.things.iter().map(entity).collect(), lights, background, style }
    }
}

fn form(wild: bool) -> impl Strategy<Value = Form> {
    let corners = prop::collection::vec([0..24_u32, 0..24_u32, 0..24_u32], 1..12);
    let parts = (corners, prop::collection::vec(vector(wild), 24), prop::collection::vec(color(), 24));
    let any = parts.prop_map(|(triangles, positions, colors)| Form::Any { triangles, positions, colors });
    prop_oneof![any, color().prop_map(Form::Cube), color().prop_map(Form::Sphere), Just(Form::Patched)]
}

fn thing(wild: bool) -> impl Strategy<Value = Thing> {
    let alpha = prop_oneof![Just(1.0_f32), number(wild), 0.0..1.0_f32];
    let degrees = vector(wild).prop_map(|degrees| degrees * 90.0);
    (form(wild), vector(wild), degrees, vector(wild), alpha).prop_map(
        |(form, position, degrees, scale, alpha)| Thing { form, place: [position, degrees, scale], alpha },
    )
}

fn light(wild: bool) -> impl Strategy<Value = PointLight> {
    let share = || 0.0..2.0_f32;
    let falloff = prop::sample::select(vec![Falloff::None, Falloff::Linear, Falloff::Quadratic]);
    let shininess = prop_oneof![0.0..200.0_f32, Just(0.0), Just(1.0), Just(32.0), Just(1e4)];
    (vector(wild), share(), share(), share(), shininess, falloff).prop_map(
        |(position, ambient, diffuse, specular, shininess, falloff)| PointLight {
            position,
            ambient,
            diffuse,
            specular,
            shininess,
            falloff,
        },
    )
}

fn style() -> impl Strategy<Value = Style> {
    let shading = prop::sample::select(vec![Shading::Unlit, Shading::Phong, Shading::BlinnPhong]);
    let filter = prop::sample::select(vec![Filtering::Nearest, Filtering::Bilinear, Filtering::Trilinear]);
    let cull = prop::sample::select(vec![Cull::Back, Cull::Front, Cull::None]);
    (shading, filter, cull).prop_map(|(shading, filter, cull)| Style { shading, filter, cull })
}

fn world(wild: bool) -> impl Strategy<Value = World> {
    let things = prop::collection::vec(thing(wild), 0..6);
    let background = any::<[u8; 3]>().prop_map(|[r, g, b]| Color::rgb(r, g, b));
    (things, prop::collection::vec(light(wild), 0..4), background, style())
        .prop_map(|(things, lights, background, style)| World { things, lights, background, style })
}

/// Cameras that turn and move, and matrices of any numbers.
fn camera(wild: bool) -> BoxedStrategy<Mat4> {
    let usual = (vector(false), vector(false)).prop_map(|(position, degrees)| {
        transforms::inverse::rigid(&transforms::affine::model(position, degrees * 90.0, Vec3::ONE))
    });
    if !wild {
        return usual.boxed();
    }
    let any = prop::collection::vec(number(true), 16).prop_map(|numbers| Mat4::from_cols_slice(&numbers));
    prop_oneof![usual, any].boxed()
}

fn size() -> impl Strategy<Value = [u16; 2]> {
    prop_oneof![[1..40_u16, 1..40_u16], Just([1, 1]), Just([300, 2])]
}

/// Draws and checks what holds for any scene.
fn check(
    scene: &Scene,
    target: &mut Target,
    projection: &Mat4,
    inverse_camera: &Mat4,
) -> Result<(), TestCaseError> {
    let size = [target.picture().width(), target.picture().height()];
    let counts = render_scene(scene, target, projection, inverse_camera);
    prop_assert!(counts.outside + counts.flattened <= scene.entities.len());
    let triangles: usize = scene.entities.iter().map(|entity| entity.levels.finest().triangles()).sum();
    let clipping::Counts { outside, culled, .. } = counts.triangles;
    prop_assert!(outside + culled <= triangles);
    prop_assert_eq!([target.picture().width(), target.picture().height()], size);
    prop_assert!(target.picture().pixels().all(|pixel| pixel.2.a == 255));
    let first = target.picture().clone();
    prop_assert_eq!(render_scene(scene, target, projection, inverse_camera), counts);
    prop_assert_eq!(different(&first, target.picture()), 0, "drawn again it is another picture");
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1500))]

    /// Any scene of usual numbers, and a second time the same.
    #[test]
    fn scenes_are_drawn(world in world(false), camera in camera(false), size in size(), antialiased: bool, wireframe: bool) {
        let (scene, mut target) = (world.scene(), Target::new(size[0], size[1]));
        (target.antialiased, target.wireframe) = (antialiased, wireframe);
        for projection in [ahead as fn(Vec2) -> Mat4, orthographic] {
            let projection = projection(target.picture().size());
            check(&scene, &mut target, &projection, &camera)?;
        }
    }

    /// Any numbers at all, in places, lights, meshes, cameras and projections: nothing panics, nothing takes for ever.
    #[test]
    fn no_numbers_stop_it(world in world(true), camera in camera(true), projection in camera(true), size in size(), antialiased: bool, wireframe: bool) {
        let (scene, mut target) = (world.scene(), Target::new(size[0], size[1]));
        (target.antialiased, target.wireframe) = (antialiased, wireframe);
        let usual = ahead(target.picture().size());
        check(&scene, &mut target, &usual, &camera)?;
        check(&scene, &mut target, &projection, &camera)?;
    }

    /// What is wholly outside of the picture changes no pixel: without the entities that are left out unseen, the picture is
    /// the same.
    #[test]
    fn what_is_left_out_would_not_be_seen(world in world(false), camera in camera(false)) {
        let drawn = |scene: &Scene| {
            let mut target = Target::new(33, 21);
            let projection = ahead(target.picture().size());
            let counts = render_scene(scene, &mut target, &projection, &camera);
            (target.into_picture(), counts)
        };
        let (whole, counts) = drawn(&world.scene());
        let is_outside = |thing: &Thing| {
            let alone = World { things: vec![thing.clone()], ..world.clone() };
            drawn(&alone.scene()).1.outside == 1
        };
        let (outside, seen): (Vec<Thing>, Vec<Thing>) = world.things.iter().cloned().partition(is_outside);
        prop_assert_eq!(outside.len(), counts.outside);
        prop_assert_eq!(different(&whole, &drawn(&World { things: seen, ..world.clone() }.scene()).0), 0);
    }
}

/// The strategies above make pictures of something, in most cases.
#[test]
fn random_scenes_show_something() {
    use proptest::strategy::ValueTree;
    use proptest::test_runner::TestRunner;
    let mut runner = TestRunner::deterministic();
    let shows = (0..100).filter(|_| {
        let world = world(false).new_tree(&mut runner).expect("a scene").current();
        let scene = Scene { background: SKY, ..world.scene() };
        let mut target = Target::new(33, 21);
        let projection = ahead(target.picture().size());
        let camera = transforms::affine::translate(Vec3::new(0.0, 0.0, -8.0));
        render_scene(&scene, &mut target, &projection, &camera);
        covered(target.picture()) > 0
    });
    let shows = shows.count();
    assert!(shows > 50, "{shows}");
}
