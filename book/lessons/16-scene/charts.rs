//! Lesson 16: how many triangles a sphere has.

use std::sync::Arc;

use checks::outline::{Ellipse, hull};
use clipping::Cull;
use common::{Color, DVec2, Mat4, Method, Vec2, Vec3, Vec4Swizzles};
use fastrand::Rng;
use lighting::PointLight;
use perspective::perspective;
use scene::frustum::pixels_per_unit;
use scene::levels::{Sizes, spheres};
use scene::{
    Entity, Filtering, Levels, METHODS, Mesh, Paint, Scene, Shading, Style, Target, orbit, render_scene,
};
use transforms::inverse::rigid;

use crate::measuring::measure::{Effort, Errors, Work};
use crate::measuring::table::{Chart, Quantity, Series, Sizes as Amounts, Stability};

/// The picture that spheres are placed in.
const PICTURE: Vec2 = Vec2::new(1024.0, 768.0);

pub(crate) const METHODS_CHART: Chart = Chart {
    name: "16-scene",
    job: "Lesson 16, choosing a sphere's triangles",
    methods: || METHODS.iter().map(|method| method.name).collect(),
    error: Quantity {
        name: "largest distance of the outline from the true one",
        unit: "px",
        limit: (0.5, "within ½ px"),
    },
    further: &["triangles"],
    samples: "turned spheres anywhere in 1024×768 px, with radii from 2 to 300 px, each as often as twice it",
    exhaustive: false,
    proved: &[],
    errors: method_errors,
    timed: "one sphere with a radius of 32 px, lit at each pixel, in 68×68 px",
    throughput: "Mpx/s",
    work: |radius, _| drawing(radius),
    sizes: Amounts { name: "pixels of radius", all: &[4, 8, 16, 32, 64, 128, 256], usual: 32 },
    stability: Stability {
        stress: "distance of the eye, radii",
        falling: true,
        error: Quantity { name: "largest distance of the outline", unit: "px", limit: (0.5, "½ px") },
        measure: method_stability,
    },
    wrong: &[],
    advice: &[
        ("by-size", "whatever comes nearer, or is seen at any size"),
        ("32x64", "a known size, up to 200 px of radius, where memory is short"),
        ("8x16", "small things, up to 13 px of radius"),
    ],
};

/// The spheres of each row of the table.
fn tables() -> Vec<Arc<Levels>> {
    METHODS.iter().map(|method| spheres(method.run, &Paint::Color(Color::WHITE))).collect()
}

/// The mesh that is taken for an entity.
fn chosen<'a>(entity: &'a Entity, to_clip: &Mat4) -> &'a Mesh {
    let pixels = pixels_per_unit(to_clip, &entity.bounds(), PICTURE);
    entity.levels.choose(pixels * entity.scale.abs().max_element())
}

/// How far the outline of a sphere's mesh is from that of the sphere, in pixels, at most.
fn off(mesh: &Mesh, to_clip: Mat4) -> f64 {
    let rows = to_clip.transpose().as_dmat4();
    let size = PICTURE.as_dvec2();
    let outline = Ellipse::of([rows.x_axis, rows.y_axis, rows.w_axis], size).expect("it is before the eye");
    let place = |corner: &Vec3| {
        let at = rows.transpose() * corner.as_dvec3().extend(1.0);
        (at.xy() / at.w + 1.0) / 2.0 * size
    };
    let corners: Vec<DVec2> = mesh.positions().iter().map(place).collect();
    outline.beyond(&hull(corners))
}

fn projection() -> Mat4 {
    perspective(45.0, PICTURE.x / PICTURE.y, 0.1, 10_000.0).expect("a picture has a width and a height")
}

/// How many pixels of radius a sphere of radius 1 has in the middle of the picture, times its distance, far away.
fn pixels_at_one() -> f32 {
    PICTURE.y / 2.0 / 22.5_f32.to_radians().tan()
}

/// A sphere somewhere in the picture, whole.
fn somewhere(random: &mut Rng) -> [Vec3; 2] {
    let radius = 2.0 * 150.0_f32.powf(random.f32());
    let distance = pixels_at_one() / radius;
    // Beside the middle it is seen a little larger.
    let room = (PICTURE / 2.0 - 1.15 * radius).max(Vec2::ZERO);
    let at = Vec2::new(random.f32(), random.f32()) * 2.0 - 1.0;
    let place = (at * room * distance / pixels_at_one()).extend(-distance);
    [place, Vec3::new(random.f32(), random.f32(), random.f32()) * 360.0]
}

fn method_errors(effort: Effort) -> Vec<Errors> {
    let mut random = effort.random();
    let mut errors = Errors::table(METHODS.len(), METHODS_CHART.further.len());
    let (tables, projection) = (tables(), projection());
    for _ in 0..effort.samples(400) {
        let [position, degrees] = somewhere(&mut random);
        for (levels, errors) in tables.iter().zip(&mut errors) {
            let entity = Entity { position, degrees, ..Entity::new(Arc::clone(levels)) };
            let mesh = chosen(&entity, &projection);
            let off = off(mesh, projection * entity.to_world());
            errors.add(off, off, &[mesh.triangles() as f64]);
        }
    }
    errors
}

fn method_stability(_: Effort) -> Vec<Series> {
    let projection = projection();
    let at = |levels: &Arc<Levels>, distance: f32| {
        let position = Vec3::NEG_Z * distance;
        let entity =
            Entity { position, degrees: Vec3::new(70.0, 20.0, 0.0), ..Entity::new(Arc::clone(levels)) };
        (f64::from(distance), off(chosen(&entity, &projection), projection * entity.to_world()))
    };
    let of = |levels: &Arc<Levels>| {
        [400.0, 200.0, 100.0, 50.0, 25.0, 12.0, 6.0, 3.0].map(|d| at(levels, d)).to_vec()
    };
    tables().iter().map(of).collect()
}

/// A sphere that fills its picture.
fn drawing(radius: usize) -> Vec<Work> {
    const DISTANCE: f32 = 40.0;
    let side = 2 * radius + 4;
    let seen = (1.0 / DISTANCE).asin().tan() * side as f32 / 2.0 / radius as f32;
    let projection = perspective(2.0 * seen.atan().to_degrees(), 1.0, 1.0, 100.0).expect("a camera");
    let work = |method: &Method<Sizes>| {
        let scene = Scene {
            entities: vec![Entity::new(spheres(method.run, &Paint::Color(Color::gray(0.7))))],
            lights: vec![PointLight { position: Vec3::new(20.0, 30.0, 40.0), ..PointLight::default() }],
            background: Color::BLACK,
            style: Style { shading: Shading::BlinnPhong, filter: Filtering::Nearest, cull: Cull::Back },
        };
        let mut target = Target::new(side as u16, side as u16);
        let inverse = rigid(&orbit(20.0, 15.0, DISTANCE));
        let pixels = std::f64::consts::PI * (radius * radius) as f64;
        Work::new(pixels, move || render_scene(&scene, &mut target, &projection, &inverse))
    };
    METHODS.iter().map(work).collect()
}
