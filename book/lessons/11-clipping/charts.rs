//! Lesson 11: triangles that reach behind the eye, the side that is seen, and meshes.

use checks::clipspace::{nearest, side};
use clipping::assembly::Topology;
use clipping::facing::{Facing, View};
use clipping::mesh::{Assemble, Vertex};
use clipping::{ASSEMBLIES, Clipping, Cull, FACINGS, METHODS, Mesh, draw, render};
use common::{Bounds, Format, IVec2, Image, Mat4, Method, Model, Vec2, Vec3, Vec4};
use fastrand::Rng;
use glam::DVec3;
use gouraud::corner_normals;
use perspective::perspective;
use perspective::scene::Loaded;
use shaders::Uniforms;
use shaders::shader::{Fragment, Shader};
use shaders::target::Target;
use textures::Wrap;

use crate::lessons::clipping::figures::{ALL, CENTER, EYE, floor, to_clip};
use crate::measuring::measure::{Effort, Errors, Work};
use crate::measuring::models::{TRIANGLES, USUAL, scene_model, sphere, texture};
use crate::measuring::table::{Chart, Quantity, Series, Sizes, Stability};

pub(crate) const METHODS_CHART: Chart = Chart {
    name: "11-clipping",
    job: "Lesson 11, triangles that reach behind the eye",
    methods: || METHODS.iter().map(|method| method.name).collect(),
    error: Quantity { name: "wrong pixels", unit: "of 10,000", limit: (1.0, "within one of 10,000") },
    further: &[],
    samples: "pictures of 100×100 px of eight triangles about the eye, each corner in front of it or behind",
    exhaustive: false,
    proved: &[],
    errors: method_errors,
    timed: "a textured ball on the lesson's floor from the lesson's eye, 800×800 px",
    throughput: "Mtri/s",
    work: method_work,
    sizes: Sizes { name: "triangles of the ball", all: TRIANGLES, usual: USUAL },
    stability: Stability {
        stress: "height of the eye over the floor",
        falling: true,
        error: Quantity { name: "wrong pixels", unit: "of 10,000", limit: (1.0, "one of 10,000") },
        measure: method_stability,
    },
    wrong: &["leave-out"],
    advice: &[
        ("guard-band", "always, with a fill that holds its numbers exactly"),
        ("homogeneous", "where pixels are asked one by one anyhow, as in a ray tracer or on a GPU"),
        ("six-planes", "where a fill takes no corner outside of the picture"),
        ("near", "small scenes, whose corners stay near the picture"),
        ("leave-out", "as long as everything is in front of the eye"),
    ],
};

pub(crate) const FACINGS_CHART: Chart = Chart {
    name: "11-clipping-facings",
    job: "Lesson 11, the side that is seen",
    methods: || FACINGS.iter().map(|method| method.name).collect(),
    error: Quantity { name: "wrong signs", unit: "%", limit: (1.0, "within one in a hundred") },
    further: &[],
    samples: "lots of 1,000 triangles, each corner in front of the eye or behind; a lot's own are up to 10⁻¹ to 10⁻⁶ from edge-on",
    exhaustive: false,
    proved: &[],
    errors: facing_errors,
    timed: "1,000 triangles in a list",
    throughput: "Mtri/s",
    work: facing_work,
    sizes: Sizes { name: "triangles", all: &[1000], usual: 1000 },
    stability: Stability {
        stress: "how far from edge-on",
        falling: true,
        error: Quantity { name: "wrong signs", unit: "%", limit: (1.0, "one in a hundred") },
        measure: facing_stability,
    },
    wrong: &["signed-area"],
    advice: &[
        ("determinant", "always"),
        ("signed-area", "after clipping, as GPUs do it"),
        ("world-normal", "before any vertex is computed, for what is far from edge-on"),
    ],
};

pub(crate) const ASSEMBLIES_CHART: Chart = Chart {
    name: "11-clipping-assemblies",
    job: "Lesson 11, handing over a mesh",
    methods: || ASSEMBLIES.iter().map(|method| method.name).collect(),
    error: Quantity { name: "vertices computed", unit: "a triangle", limit: (1.0, "within one a triangle") },
    further: &["numbers_read"],
    samples: "the head, with normals and texture coordinates",
    exhaustive: true,
    proved: &[],
    errors: assembly_errors,
    timed: "a textured ball in a picture of 100×100 px",
    throughput: "Mtri/s",
    work: assembly_work,
    sizes: Sizes { name: "triangles", all: TRIANGLES, usual: USUAL },
    stability: Stability {
        stress: "triangles with normals of their own, %",
        falling: false,
        error: Quantity { name: "vertices computed", unit: "a triangle", limit: (1.0, "one a triangle") },
        measure: assembly_stability,
    },
    wrong: &[],
    advice: &[
        ("indexed", "always"),
        ("strip", "where the index buffer itself must be small"),
        ("per-corner", "facets, whose corners have nothing in common"),
    ],
};

/// Triangles of clip space, each with three vertices of its own, drawn as their numbers.
struct Soup<'a>(&'a [[Vec4; 3]]);

impl Shader for Soup<'_> {
    type Constant = usize;
    type Varying = ();
    type Output = usize;

    fn position(&self, vertex: usize) -> Vec4 {
        self.0[vertex / 3][vertex % 3]
    }

    fn triangle(&self, face: usize) -> Option<usize> {
        Some(face)
    }

    fn corner(&self, _: usize, _: usize) {}

    fn fragment(&self, face: usize, _: Fragment<()>) -> Option<usize> {
        Some(face)
    }
}

/// The nearest triangle at each pixel of a square picture.
struct Numbers {
    side: i32,
    nearest: Vec<(f32, Option<usize>)>,
}

impl Target<usize> for Numbers {
    fn bounds(&self) -> Bounds {
        Bounds { min: IVec2::ZERO, max: IVec2::splat(self.side - 1) }
    }

    fn test(&mut self, x: i32, y: i32, depth: f32) -> bool {
        depth < self.nearest[(y * self.side + x) as usize].0
    }

    fn write(&mut self, x: i32, y: i32, depth: f32, face: usize) {
        self.nearest[(y * self.side + x) as usize] = (depth, Some(face));
    }

    fn clear(&mut self) {
        self.nearest.fill((1.0, None));
    }
}

/// Side of a picture that is checked.
const SIDE: i32 = 100;

/// What rays through the centres of a picture's pixels meet.
fn by_rays(triangles: &[[Vec4; 3]]) -> Vec<Option<usize>> {
    let at = |n: i32| (2.0 * f64::from(n) + 1.0) / f64::from(SIDE) - 1.0;
    let pixels = (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| [at(x), at(y)]));
    pixels.map(|at| nearest(triangles, at).map(|(face, _)| face)).collect()
}

/// How many pixels of a picture of 100×100 show another triangle than a ray meets, or none, or one where there is none.
fn wrong_pixels(clipping: Clipping, triangles: &[[Vec4; 3]], rays: &[Option<usize>]) -> f64 {
    let numbers = 0..triangles.len() as u32;
    let vertices: Vec<Vertex> = numbers
        .clone()
        .flat_map(|face| (0..3).map(move |corner| Vertex { position: 3 * face + corner, face, corner }))
        .collect();
    let indices = (0..vertices.len() as u32).collect();
    let mesh = Mesh { vertices, topology: Topology::List, indices, faces: numbers.collect() };
    let mut target = Numbers { side: SIDE, nearest: vec![(1.0, None); rays.len()] };
    render(&Soup(triangles), &mesh, Cull::None, clipping, &mut target);
    target.nearest.iter().zip(rays).filter(|(drawn, ray)| drawn.1 != **ray).count() as f64
}

fn method_errors(effort: Effort) -> Vec<Errors> {
    let to_clip = perspective(90.0, 1.0, 0.1, 100.0).expect("it is a camera");
    let mut random = effort.random();
    let mut errors = Errors::table(METHODS.len(), 0);
    for _ in 0..effort.samples(400) {
        let mut corner = || {
            let [x, y, z] = [(); 3].map(|()| 8.0 * random.f32() - 4.0);
            to_clip * Vec4::new(x, y, z, 1.0)
        };
        let triangles = [(); 8].map(|()| [(); 3].map(|()| corner()));
        let rays = by_rays(&triangles);
        for (method, errors) in METHODS.iter().zip(&mut errors) {
            let wrong = wrong_pixels(method.run, &triangles, &rays);
            errors.add(wrong, wrong, &[]);
        }
    }
    errors
}

/// The lesson's eye lower and lower over the floor.
fn method_stability(_: Effort) -> Vec<Series> {
    let (floor, _) = floor().expect("the lesson has a floor");
    let ground = floor.model.positions()[0].y;
    let pictures: Vec<_> = (0..=10)
        .map(|n| {
            let height = 10f32.powf(1.0 - n as f32 * 0.3);
            let to_clip = to_clip(45.0, EYE.with_y(ground + height), CENTER).expect("it looks somewhere");
            let triangles: Vec<[Vec4; 3]> =
                floor.model.faces().map(|corners| corners.map(|p| to_clip * p.extend(1.0))).collect();
            let rays = by_rays(&triangles);
            (f64::from(height), triangles, rays)
        })
        .collect();
    let series = |method: &Method<Clipping>| {
        let wrong = |(height, triangles, rays): &(f64, Vec<_>, Vec<_>)| {
            (*height, wrong_pixels(method.run, triangles, rays))
        };
        pictures.iter().map(wrong).collect()
    };
    METHODS.iter().map(series).collect()
}

/// A textured model, kept until the program ends.
fn textured(model: &Model) -> &'static Loaded {
    let normals = corner_normals(model);
    Box::leak(Box::new(Loaded { model: model.clone(), normals, texture: texture(), wrap: Wrap::Clamp }))
}

/// The light of what is timed.
const LIGHT: Vec3 = Vec3::Z;

/// Draws meshes, again and again; what is counted are their triangles.
fn drawing(models: Vec<(Uniforms<'static>, Mesh)>, clipping: Clipping, side: u16) -> Work {
    let mut image = Image::new(side, side, Format::Rgb);
    let triangles: usize = models.iter().map(|(_, mesh)| mesh.faces.len()).sum();
    Work::new(triangles as f64, move || {
        let models: Vec<(Uniforms, &Mesh)> =
            models.iter().map(|(uniforms, mesh)| (*uniforms, mesh)).collect();
        draw(&models, Cull::Back, clipping, &mut image).counts
    })
}

fn method_work(size: usize, _: Effort) -> Vec<Work> {
    let (floor, floor_mesh) = floor().expect("the lesson has a floor");
    let floor: &Loaded = Box::leak(Box::new(floor));
    let ball = textured(sphere(size));
    let mesh = clipping::mesh::indexed(&ball.model, &ball.normals, ALL);
    let to_clip = to_clip(45.0, EYE, CENTER).expect("it looks somewhere");
    let work = |method: &Method<Clipping>| {
        let models = vec![
            (ball.uniforms(LIGHT, to_clip), mesh.clone()),
            (floor.uniforms(LIGHT, to_clip), floor_mesh.clone()),
        ];
        drawing(models, method.run, 800)
    };
    METHODS.iter().map(work).collect()
}

/// How far corners are from the eye, at most, along each axis: whole numbers that an `f32` holds with the eye's added.
const REACH: f64 = (1 << 22) as f64;

/// A triangle in the world, in whole numbers, whose corners are on either side of the eye at random, and which side of it is
/// seen. Its third corner is off the plane of the eye and the two others by about that share of the reach.
fn nearly_edge_on(random: &mut Rng, off: f64, to_clip: Mat4) -> (View, i32) {
    loop {
        let mut place = || DVec3::from([(); 3].map(|()| REACH * (2.0 * random.f64() - 1.0)));
        let (a, b, eye) = (place(), place(), place());
        let [s, t] = [(); 2].map(|()| 2.0 * random.f64() - 1.0);
        let away = a.cross(b).normalize_or_zero() * off * REACH * (2.0 * random.f64() - 1.0);
        let c = a * s * 0.5 + b * t * 0.5 + away;
        let [corners, eye] = [[a, b, c], [eye; 3]].map(|list| list.map(DVec3::round));
        let exact = side(corners.map(|corner| corner.to_array().map(|x| x as i64)));
        if exact != 0 {
            let clip = corners.map(|corner| to_clip * corner.as_vec3().extend(1.0));
            let world = corners.map(|corner| (corner + eye[0]).as_vec3());
            let view = View { world, eye: eye[0].as_vec3(), clip, size: Vec2::splat(800.0) };
            return (view, exact);
        }
    }
}

/// The camera: one whose matrix rounds.
fn camera() -> Mat4 {
    perspective(60.0, 1.0, 0.1, f32::INFINITY).expect("it is a camera")
}

/// The share of wrong signs, in percent, of a lot of triangles.
fn wrong_signs(facing: Facing, lot: &[(View, i32)]) -> f64 {
    let is_wrong = |(view, exact): &&(View, i32)| {
        let facing = facing(view);
        let sign = i32::from(facing > 0.0) - i32::from(facing < 0.0);
        sign != *exact
    };
    100.0 * lot.iter().filter(is_wrong).count() as f64 / lot.len() as f64
}

fn lot(random: &mut Rng, off: f64) -> Vec<(View, i32)> {
    let to_clip = camera();
    (0..1000).map(|_| nearly_edge_on(random, off, to_clip)).collect()
}

fn facing_errors(effort: Effort) -> Vec<Errors> {
    let mut random = effort.random();
    let mut errors = Errors::table(FACINGS.len(), 0);
    for _ in 0..effort.samples(1000) {
        let off = 10f64.powf(-1.0 - 5.0 * random.f64());
        let lot = lot(&mut random, off);
        for (method, errors) in FACINGS.iter().zip(&mut errors) {
            let wrong = wrong_signs(method.run, &lot);
            errors.add(wrong, wrong, &[]);
        }
    }
    errors
}

fn facing_work(size: usize, effort: Effort) -> Vec<Work> {
    let mut random = effort.random();
    let to_clip = camera();
    let views: Vec<View> = (0..size).map(|_| nearly_edge_on(&mut random, 0.1, to_clip).0).collect();
    let work = |method: &'static Method<Facing>| {
        let views = views.clone();
        Work::new(size as f64, move || views.iter().filter(|view| (method.run)(view) > 0.0).count())
    };
    FACINGS.iter().map(work).collect()
}

/// Nearer and nearer to edge-on.
fn facing_stability(effort: Effort) -> Vec<Series> {
    let mut random = effort.random();
    let lots: Vec<(f64, Vec<(View, i32)>)> = (0..=12)
        .map(|n| {
            let off = 10f64.powf(-0.5 * f64::from(n));
            let lots = (0..effort.samples(20)).flat_map(|_| lot(&mut random, off)).collect();
            (off, lots)
        })
        .collect();
    let series = |method: &Method<Facing>| {
        lots.iter().map(|(off, lot)| (*off, wrong_signs(method.run, lot))).collect()
    };
    FACINGS.iter().map(series).collect()
}

/// Vertices computed and numbers read for a triangle.
fn costs(mesh: &Mesh) -> [f64; 2] {
    [mesh.vertices.len(), mesh.indices.len()].map(|count| count as f64 / mesh.faces.len() as f64)
}

fn assembly_errors(_: Effort) -> Vec<Errors> {
    let (_, head, _) = scene_model().expect("the course has its head");
    let normals = corner_normals(head);
    let of = |method: &Method<Assemble>| {
        let [vertices, numbers] = costs(&(method.run)(head, &normals, ALL));
        let mut errors = Errors::new(1);
        errors.add(vertices, vertices, &[numbers]);
        errors
    };
    ASSEMBLIES.iter().map(of).collect()
}

fn assembly_work(size: usize, _: Effort) -> Vec<Work> {
    let ball = textured(sphere(size));
    let to_clip = to_clip(45.0, EYE, Vec3::ZERO).expect("it looks somewhere");
    let work = |method: &Method<Assemble>| {
        let mesh = (method.run)(&ball.model, &ball.normals, ALL);
        drawing(vec![(ball.uniforms(LIGHT, to_clip), mesh)], Clipping::GuardBand, 100)
    };
    ASSEMBLIES.iter().map(work).collect()
}

/// More and more triangles with the normal of their plane at their corners.
fn assembly_stability(effort: Effort) -> Vec<Series> {
    let (_, head, _) = scene_model().expect("the course has its head");
    let smooth = corner_normals(head);
    let mut random = effort.random();
    let marks: Vec<f64> = smooth.iter().map(|_| 100.0 * random.f64()).collect();
    let with = |share: f64| -> Vec<[Vec3; 3]> {
        let faces = head.faces().zip(&smooth).zip(&marks);
        faces
            .map(
                |(([a, b, c], &smooth), &mark)| {
                    if mark < share { [(b - a).cross(c - a).normalize_or_zero(); 3] } else { smooth }
                },
            )
            .collect()
    };
    let shares = [0.0, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0];
    let series = |method: &Method<Assemble>| {
        shares.map(|share| (share, costs(&(method.run)(head, &with(share), ALL))[0])).to_vec()
    };
    ASSEMBLIES.iter().map(series).collect()
}
