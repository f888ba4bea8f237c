//! Mission 12: what a surface reflects of a point light.

pub use lighting_given as given;

use common::{Color, Mat4, Vec2, Vec3, Vec4Swizzles};
use fastrand::Rng;
use perspective::{perspective, view, window};
use tasks::scenery::{MODEL, MODEL_CODE, canvas, direction, point, signed};
use tasks::{Check, Code, Mission, Precision, Raw, Shape, Task};

use given::{PointLight, Reflect, Reflected, draw};

/// What the student writes.
#[derive(Clone, Copy)]
pub struct Lighting {
    /// The lesson's `blinn_phong`.
    pub blinn_phong: Reflect,
}

/// The mission.
pub const MISSION: Mission<Lighting> = Mission {
    lesson: "12-lighting",
    checks: &[
        Check {
            name: "body",
            asks: "ambient and diffuse light, from in front of the surface",
            points: 2,
            tasks: |rng| (0..5).map(|_| Place::lit(rng).asks("body", |reflected| [reflected.body])).collect(),
            precision: Precision::NUMBERS,
        },
        Check {
            name: "highlight",
            asks: "the highlight, with small exponents and large ones",
            points: 3,
            tasks: |rng| {
                [1.0, 2.5, 8.0, 40.0, 200.0]
                    .map(|about| {
                        let shininess = about * (0.8 + 0.4 * rng.f32());
                        highlight(Place::shining(rng, shininess))
                    })
                    .into()
            },
            precision: Precision::NUMBERS,
        },
        Check {
            name: "behind",
            asks: "ambient light alone where the light is behind the surface",
            points: 1,
            tasks: |rng| (0..3).map(|_| both(Place::behind(rng))).collect(),
            precision: Precision::NUMBERS,
        },
        Check {
            name: "below",
            asks: "no highlight where the half-way vector is behind the surface, one where it is not",
            points: 1,
            tasks: |rng| {
                // To an even power, to an odd one, and to one that no negative number has.
                let mut tasks: Vec<_> =
                    [2.0, 3.0, 4.5].map(|shininess| highlight(Place::below(rng, shininess))).into();
                tasks.push(highlight(Place::shining(rng, 3.0)));
                tasks
            },
            precision: Precision::NUMBERS,
        },
        Check {
            name: "lengths",
            asks: "normals of any length, and no direction where there is none",
            points: 1,
            tasks: |rng| {
                let scaled = |rng: &mut Rng, factor: f32| {
                    let place = Place::shining(rng, 6.0);
                    both(Place { normal: place.normal * factor, ..place })
                };
                let (short, long) = (0.3 + 0.5 * rng.f32(), 2.0 + 3.0 * rng.f32());
                let mut tasks = vec![scaled(rng, short), scaled(rng, long), scaled(rng, 0.0)];
                let mut at_the_light = Place::shining(rng, 6.0);
                at_the_light.light.position = at_the_light.point;
                tasks.push(both(at_the_light));
                tasks
            },
            precision: Precision::NUMBERS,
        },
        Check {
            name: "picture",
            asks: "the head under a lamp on one side, and on the other",
            points: 2,
            tasks: |rng| [1.0, -1.0].map(|side| head(rng, side)).into(),
            // In some pixels the last bit decides which of two triangles is seen.
            precision: Precision { tolerance: 2.0, strays: 40 },
        },
    ],
};

/// A point of a surface, an eye and a light.
#[derive(Clone, Copy)]
struct Place {
    point: Vec3,
    normal: Vec3,
    eye: Vec3,
    light: PointLight,
}

/// To a hundredth, to be read.
fn hundredths(v: Vec3) -> Vec3 {
    (v * 100.0).round() / 100.0
}

impl Place {
    /// Anywhere, the normal and the light's numbers at random.
    fn any(rng: &mut Rng) -> Self {
        let mut share = |low: f32, high: f32| ((low + (high - low) * rng.f32()) * 100.0).round() / 100.0;
        let light = PointLight {
            position: Vec3::ZERO,
            ambient: share(0.05, 0.3),
            diffuse: share(0.3, 0.6),
            specular: share(0.3, 0.7),
            shininess: share(4.0, 12.0),
        };
        let [point, to_light, to_eye] = [0.5, 2.0, 3.0].map(|far| hundredths(point(rng) * far));
        let light = PointLight { position: point + to_light, ..light };
        Self { point, normal: direction(rng), eye: point + to_eye, light }
    }

    /// The first of random places that is as wished: of the cosines to the light, to the eye and to the half-way vector.
    fn where_(rng: &mut Rng, wish: impl Fn(f32, f32, f32) -> bool) -> Self {
        loop {
            let place = Self::any(rng);
            let [l, v] = [place.light.position, place.eye].map(|end| (end - place.point).normalize_or_zero());
            let [light, eye, half_way] = [l, v, (l + v).normalize_or_zero()].map(|d| d.dot(place.normal));
            // Light and eye neither at one place nor opposite, nor as far: directions must be made 1 long.
            let far =
                place.light.position.distance(place.point) > 0.5 && place.eye.distance(place.point) > 1.2;
            if far && l.dot(v).abs() < 0.95 && wish(light, eye, half_way) {
                return place;
            }
        }
    }

    /// Light falls on it.
    fn lit(rng: &mut Rng) -> Self {
        Self::where_(rng, |light, _, _| (0.2..0.9).contains(&light))
    }

    /// There is a highlight for the eye, which this exponent does not make invisible.
    fn shining(rng: &mut Rng, shininess: f32) -> Self {
        let faintest = 0.15_f32.powf(1.0 / shininess);
        let brightest = 0.9_f32.powf(1.0 / shininess);
        let place = Self::where_(rng, |light, eye, half_way| {
            light > 0.1 && eye > 0.1 && (faintest..brightest).contains(&half_way)
        });
        Self { light: PointLight { shininess, ..place.light }, ..place }
    }

    /// The light is behind the surface, and the half-way vector is not.
    fn behind(rng: &mut Rng) -> Self {
        Self::where_(rng, |light, _, half_way| (-0.6..-0.1).contains(&light) && half_way > 0.3)
    }

    /// Light falls on it, the eye is behind it, and so is the half-way vector.
    fn below(rng: &mut Rng, shininess: f32) -> Self {
        let place = Self::where_(rng, |light, _, half_way| light > 0.1 && half_way < -0.3);
        Self { light: PointLight { shininess, ..place.light }, ..place }
    }

    fn of(&self, functions: &Lighting) -> Reflected {
        (functions.blinn_phong)(self.point, self.normal, self.eye, &self.light)
    }

    fn call(&self) -> String {
        let Self { point, normal, eye, light } = self;
        format!("blinn_phong({}, {}, {}, &{})", point.code(), normal.code(), eye.code(), light_code(light))
    }

    /// What of the result is asked for.
    fn asks<const N: usize>(self, what: &str, part: fn(Reflected) -> [f32; N]) -> Task<Lighting> {
        let call = format!("{}{}{what}", self.call(), if what.is_empty() { "" } else { "." });
        Task::call("", call, move |student: &Lighting| Raw::value(part(self.of(student))))
    }
}

fn highlight(place: Place) -> Task<Lighting> {
    place.asks("highlight", |reflected| [reflected.highlight])
}

fn both(place: Place) -> Task<Lighting> {
    place.asks("", |reflected| [reflected.body, reflected.highlight])
}

fn light_code(light: &PointLight) -> String {
    let PointLight { position, ambient, diffuse, specular, shininess } = light;
    let [ambient, diffuse, specular, shininess] = [ambient, diffuse, specular, shininess].map(Code::code);
    format!(
        "PointLight {{ position: {}, ambient: {ambient}, diffuse: {diffuse}, specular: {specular}, \
         shininess: {shininess} }}",
        position.code()
    )
}

/// Width and height of the pictures.
const SIZE: [u16; 2] = [300, 320];

/// The colour of the clay that the head is made of.
pub const CLAY: Color = Color::rgb(190, 105, 70);

/// A camera at that place, which looks at the head.
#[must_use]
pub fn camera(eye: Vec3) -> Mat4 {
    let [width, height] = SIZE.map(f32::from);
    let matrices = perspective(40.0, width / height, 0.1, 10.0).ok().zip(view(eye, Vec3::ZERO, Vec3::Y));
    matrices.map_or(Mat4::IDENTITY, |(projection, view)| projection * view)
}

/// The head of clay, with a lamp on that side.
fn head(rng: &mut Rng, side: f32) -> Task<Lighting> {
    let [width, height] = SIZE;
    let eye = hundredths(Vec3::new(0.6 * signed(rng), 0.3 * signed(rng), 2.8));
    let light = PointLight {
        position: hundredths(Vec3::new(side * (1.0 + rng.f32()), 1.0 + rng.f32(), 2.0 + 0.5 * rng.f32())),
        ambient: 0.15,
        diffuse: 0.65,
        specular: 0.5,
        shininess: (10.0 + 30.0 * rng.f32()).round(),
    };
    let code = format!(
        "{MODEL_CODE}let (eye, light) = ({}, {});\n\
         let mut got = Image::new({width}, {height}, Format::Rgb);\n\
         draw(&model, lighting_tasks::CLAY, lighting_tasks::camera(eye), eye, &light, blinn_phong, &mut got);",
        eye.code(),
        light_code(&light)
    );
    let input =
        format!("the head, {width}x{height}, from {}, lit from {}", eye.code(), light.position.code());
    Task::new(input, code, move |student: &Lighting| {
        let mut image = canvas(width, height);
        draw(&MODEL, CLAY, camera(eye), eye, &light, student.blinn_phong, &mut image);
        Raw::Picture(image)
    })
    .of(move |_| {
        let size = Vec2::new(width.into(), height.into());
        let corner = |corner: Vec3| Some(window(camera(eye) * corner.extend(1.0), size)?.xyz());
        (0..MODEL.triangles().len())
            .filter_map(|face| {
                [0, 1, 2].into_iter().map(|n| corner(MODEL.position(face, n))).collect::<Option<Shape>>()
            })
            .collect()
    })
}
