//! Entities that lessons 14 and 15 draw, too: the scene adds a scene, not a renderer.

use std::path::Path;
use std::sync::Arc;

use antialiasing::{METHODS, World, resolve};
use blending::scene::View;
use blending::{Over, TwoShift};
use clipping::Cull;
use common::placement::Placement;
use common::{Attributes, Color, Format, Image, Mat4, Model, Vec3};
use filtering::scene::Filterable;
use filtering::{MIPMAPS, Wrap};
use perspective::scene::Loaded;
use scene::{Entity, Filtering, Levels, Mesh, Paint, Scene, Shape, Target, render_scene};
use transforms::inverse::rigid;
use verify::{CRATE, SPHERE, method};

use crate::pictures::{ORBIT, SIZE, SKY, ahead, different, lit};

/// A model of the course's with the wooden texture, as lesson 14 has it and as this one does.
fn both(file: &str) -> (Filterable, Arc<Levels>) {
    let needs = Attributes { normals: true, uvs: true };
    let model =
        Model::read_placed(Path::new(file), needs, &Placement::default()).expect("the asset is there");
    let wood = Image::read(Path::new(CRATE)).expect("the asset is there");
    let mipmap = *method(MIPMAPS, "box-linear");
    let loaded = Loaded::new(model, wood.clone(), Default::default());
    let shape = Shape::of(&loaded.model, &loaded.normals);
    let paint = Paint::Texture(Arc::new(mipmap.texture(&wood, Wrap::Repeat)));
    (Filterable::new(loaded, mipmap, Wrap::Repeat), Levels::one(Mesh::new(&shape, paint)))
}

/// A sphere, opaque, and a smaller cube before it, at half alpha: scene and model are the same for all.
const PLACES: [(f32, Vec3, Vec3, Vec3); 2] = [
    (1.0, Vec3::new(-0.3, 0.1, 0.0), Vec3::new(20.0, 50.0, 10.0), Vec3::new(1.3, 1.0, 1.1)),
    (0.5, Vec3::new(0.9, 0.5, 1.6), Vec3::new(-30.0, 15.0, 40.0), Vec3::splat(0.7)),
];

/// What this lesson draws, and what another one does of the same entities.
fn pair(antialiased: bool, by_other: impl Fn(&[blending::scene::Entity], &View, &mut Image)) -> [Image; 2] {
    let cube = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../assets/cube.obj");
    let [(sphere, levels), (small, small_levels)] = [both(SPHERE), both(cube)];
    let placed = |levels: &Arc<Levels>, (alpha, position, degrees, scale)| Entity {
        alpha,
        position,
        degrees,
        scale,
        ..Entity::new(levels.clone())
    };
    let mut scene: Scene = lit(vec![placed(&small_levels, PLACES[1]), placed(&levels, PLACES[0])]);
    scene.style.filter = Filtering::Trilinear;
    // Their lamp has no highlight, which would not be a multiple of the surface's colour.
    scene.lights[0].specular = 0.0;
    // Their lamp has no highlight, which would not be a multiple of the surface's colour.
    scene.lights[0].specular = 0.0;
    let camera = ORBIT.camera();
    let mut target = Target::new(SIZE[0], SIZE[1]);
    target.antialiased = antialiased;
    let projection = ahead(target.picture().size());
    render_scene(&scene, &mut target, &projection, &rigid(&camera));

    let to_clip = projection * rigid(&camera);
    let view = View { to_clip, eye: camera.w_axis.truncate(), light: scene.lights[0] };
    let other = |model, n: usize| {
        let (alpha, at, degrees, size) = PLACES[n];
        let to_world: Mat4 = transforms::affine::model(at, degrees, size);
        blending::scene::Entity { model, to_world, alpha }
    };
    let mut image = Image::new(SIZE[0], SIZE[1], Format::Rgb);
    image.set_all(|_| SKY);
    by_other(&[other(&sphere, 0), other(&small, 1)], &view, &mut image);
    [target.into_picture(), image]
}

/// As many pixels show something as should, and none differs.
#[track_caller]
fn assert_same([this, other]: &[Image; 2]) {
    assert!(other.pixels().filter(|pixel| pixel.2 != SKY).count() > 200);
    assert_eq!(different(this, other), 0);
}

#[test]
fn lesson_14_draws_the_same() {
    assert_same(&pair(false, |entities, view, image| {
        blending::scene::draw(entities, view, Over::<TwoShift>::default(), image);
    }));
}

#[test]
fn lesson_15_draws_the_same() {
    for (antialiased, name) in [(false, "none"), (true, "msaa-16")] {
        assert_same(&pair(antialiased, |entities, view, image| {
            let world = World { entities, view: *view, cull: Cull::Back };
            let background: Color = SKY;
            let scene = antialiasing::Scene {
                background,
                triangles: &[],
                world: Some(world),
                alpha_to_coverage: false,
                resolve,
            };
            (method(METHODS, name).picture)(&scene, image);
        }));
    }
}
