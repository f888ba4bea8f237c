//! Scenes before an eye that looks along −z, drawn by the lesson, and what `f64` says of each of their pixels.

use assets::sphere::sphere;
use checks::lamp::{self, Ellipsoid, Face, Highlight, Lamp};
use checks::ray::{self, Screen};
use clipping::mesh::indexed;
use clipping::{Cull, Mesh};
use common::{Attributes, Color, DVec2, DVec3, Format, Image, Mat3, Mat4, Model, Vec3};
use lighting::{Draw, Falloff, PointLight, Scene};
use perspective::scene::Loaded;
use perspective::{perspective, view};
use textures::Wrap;

pub(crate) const BOTH: Attributes = Attributes { normals: true, uvs: true };

/// Width and height of the pictures: odd, so that one pixel's centre is straight ahead.
pub(crate) const SIDE: u16 = 49;

/// Degrees from the bottom to the top.
const FOV: f32 = 45.0;

/// A white model, its place, its light and the eye.
pub(crate) struct Stage {
    pub(crate) loaded: Loaded,
    pub(crate) mesh: Mesh,
    pub(crate) to_world: Mat4,
    /// What turns normals, where it is not what the lesson says.
    pub(crate) normals_by: Option<Mat3>,
    pub(crate) light: PointLight,
    pub(crate) eye: Vec3,
    pub(crate) cull: Cull,
    /// What the triangles stand for, if not for themselves.
    pub(crate) smooth: Option<Ellipsoid>,
}

impl Stage {
    /// A model from the text of an OBJ file.
    pub(crate) fn new(obj: &str, light: PointLight) -> Self {
        let model = Model::parse(obj.as_bytes(), BOTH).unwrap();
        let mut white = Image::new(1, 1, Format::Rgb);
        white.set(0, 0, Color::WHITE);
        let loaded = Loaded::new(model, white, Wrap::Clamp);
        let mesh = indexed(&loaded.model, &loaded.normals, BOTH);
        Self {
            loaded,
            mesh,
            to_world: Mat4::IDENTITY,
            normals_by: None,
            light,
            eye: Vec3::new(0.0, 0.0, 3.0),
            cull: Cull::Back,
            smooth: None,
        }
    }

    /// Two triangles, the square from −1 to 1 at z = 0, with these normals at its corners, counterclockwise from the bottom
    /// left.
    pub(crate) fn wall(normals: [Vec3; 4], light: PointLight) -> Self {
        let mut text = String::from("v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\n");
        normals.iter().for_each(|n| text += &format!("vn {} {} {}\n", n.x, n.y, n.z));
        Self::new(&(text + "f 1/1/1 2/1/2 3/1/3\nf 1/1/1 3/1/3 4/1/4\n"), light)
    }

    /// The wall with no normal at any corner.
    pub(crate) fn without_normals(light: PointLight) -> Self {
        let mut stage = Self::wall([Vec3::Z; 4], light);
        stage.loaded.normals.iter_mut().for_each(|corners| *corners = [Vec3::ZERO; 3]);
        stage.mesh = indexed(&stage.loaded.model, &stage.loaded.normals, BOTH);
        stage
    }

    /// A sphere of radius 1 in so many bands and sectors, stretched along the axes.
    pub(crate) fn sphere([bands, sectors]: [usize; 2], stretch: Vec3, light: PointLight) -> Self {
        Self {
            to_world: transforms::scale(stretch),
            smooth: Some(Ellipsoid(stretch.as_dvec3())),
            ..Self::new(&sphere(bands, sectors).to_obj(), light)
        }
    }

    /// From the world to clip space.
    fn camera(&self) -> Mat4 {
        let center = self.eye - Vec3::Z;
        // Near and far are as far off as the eye asks for.
        let scale = self.eye.length();
        perspective(FOV, 1.0, scale / 100.0, scale * 100.0).unwrap()
            * view(self.eye, center, Vec3::Y).unwrap()
    }

    pub(crate) fn scene(&self) -> Scene<'_> {
        let scene = Scene::placed(&self.loaded, self.to_world, self.camera(), self.eye, self.light).unwrap();
        Scene { normals_to_world: self.normals_by.unwrap_or(scene.normals_to_world), ..scene }
    }

    pub(crate) fn drawn(&self, draw: Draw) -> Image {
        let mut image = Image::new(SIDE, SIDE, Format::Rgb);
        draw(&self.scene(), &self.mesh, self.cull, &mut image);
        image
    }

    /// The triangles in the world. Normals go by the cofactors of the matrix, which are the cross products of its columns.
    fn faces(&self) -> Vec<Face> {
        let [x, y, z, by] = [0, 1, 2, 3].map(|n| self.to_world.col(n).truncate().as_dvec3());
        let side = x.cross(y).dot(z).signum();
        let place = |p: Vec3| {
            let p = p.as_dvec3();
            x * p.x + y * p.y + z * p.z + by
        };
        let turn = |n: Vec3| {
            let n = n.as_dvec3();
            let turned = y.cross(z) * n.x + z.cross(x) * n.y + x.cross(y) * n.z;
            if turned == DVec3::ZERO { turned } else { side * turned.normalize() }
        };
        let faces = self.loaded.model.faces().zip(&self.loaded.normals);
        faces
            .map(|(corners, normals)| Face { corners: corners.map(place), normals: normals.map(turn) })
            .collect()
    }

    /// What is seen at each pixel: of what the triangles stand for, if for anything.
    fn seen(&self) -> Vec<Seen> {
        let Some(egg) = self.smooth else { return self.seen_of_triangles() };
        let (screen, eye) = (screen(), self.eye.as_dvec3());
        let at = |(x, y)| {
            let point = egg.hit(eye, screen.through(x, y))?;
            let normal = egg.normal(point).normalize();
            // Near its outline the triangles cannot be mistaken for it.
            let clear = normal.dot((eye - point).normalize()) > 0.4;
            clear.then_some(Seen { x, y, point, normal, face: 0 })
        };
        pixels().filter_map(at).collect()
    }

    /// What is seen of the triangles themselves, where no side is near, and normals do not cancel, which leaves no direction.
    fn seen_of_triangles(&self) -> Vec<Seen> {
        let (screen, eye, faces) = (screen(), self.eye.as_dvec3(), self.faces());
        let nearest = |direction: DVec3| {
            let hits = faces.iter().enumerate().filter_map(|(n, face)| Some((n, face.hit(eye, direction)?)));
            hits.min_by(|a, b| a.1.0.total_cmp(&b.1.0))
        };
        let at = |(x, y)| {
            let (face, (_, point, normal)) = nearest(screen.through(x, y))?;
            let near = |(dx, dy)| {
                let at = DVec2::new(f64::from(x) + 0.5 + dx, f64::from(y) + 0.5 + dy);
                nearest(screen.direction(at)).is_some_and(|near| near.0 == face)
            };
            let around = [(-0.1, -0.1), (0.1, -0.1), (-0.1, 0.1), (0.1, 0.1)];
            let left = normal.length() > 1e-6 || faces[face].normals == [DVec3::ZERO; 3];
            (left && around.into_iter().all(near)).then_some(Seen { x, y, point, normal, face })
        };
        pixels().filter_map(at).collect()
    }

    /// The lamp in `f64`.
    pub(crate) fn lamp(&self) -> Lamp {
        let PointLight { position, ambient, diffuse, specular, shininess, falloff } = self.light;
        Lamp {
            position: position.as_dvec3(),
            ambient: ambient.into(),
            diffuse: diffuse.into(),
            specular: specular.into(),
            shininess: shininess.into(),
            fading: match falloff {
                Falloff::None => 0,
                Falloff::Linear => 1,
                Falloff::Quadratic => 2,
            },
        }
    }

    /// By how many grey levels a picture is off, at worst, and how many pixels were looked at.
    pub(crate) fn error(&self, image: &Image, highlight: Highlight) -> (f64, usize) {
        let (lamp, seen) = (self.lamp(), self.seen());
        let errors = seen.iter().map(|seen| {
            let lit = lamp.on(seen.point, seen.normal, self.eye.as_dvec3(), highlight);
            off(image, seen, lit)
        });
        (errors.fold(0.0, f64::max), seen.len())
    }

    /// The same against what Phong's model gives once a triangle, at its middle and with its own normal; or at its corners, the
    /// two sums interpolated.
    pub(crate) fn error_of_promise(&self, image: &Image, at_corners: bool) -> (f64, usize) {
        let (lamp, eye, faces) = (self.lamp(), self.eye.as_dvec3(), self.faces());
        let on = |point, normal| lamp.on(point, normal, eye, Highlight::Mirrored);
        let seen = self.seen_of_triangles();
        let errors = seen.iter().map(|seen| {
            let Face { corners: [a, b, c], normals } = faces[seen.face];
            let lit = if at_corners {
                let met = ray::hit([a, b, c].map(|corner| corner - eye), screen().through(seen.x, seen.y));
                let [p, q, r] = [on(a, normals[0]), on(b, normals[1]), on(c, normals[2])];
                [0, 1].map(|n| met.weights.dot(DVec3::new(p[n], q[n], r[n])))
            } else {
                on((a + b + c) / 3.0, (b - a).cross(c - a))
            };
            off(image, seen, lit)
        });
        (errors.fold(0.0, f64::max), seen.len())
    }
}

/// A point that is seen at a pixel.
struct Seen {
    x: i32,
    y: i32,
    point: DVec3,
    normal: DVec3,
    /// The number of the triangle.
    face: usize,
}

fn screen() -> Screen {
    Screen::ahead(FOV.into(), DVec2::splat(SIDE.into()))
}

fn pixels() -> impl Iterator<Item = (i32, i32)> {
    (0..i32::from(SIDE)).flat_map(|y| (0..i32::from(SIDE)).map(move |x| (x, y)))
}

/// By how many grey levels a white surface is off at a pixel.
fn off(image: &Image, seen: &Seen, lit: [f64; 2]) -> f64 {
    let drawn = image.get(seen.x, seen.y).map_or(f64::NAN, |color| color.r.into());
    (drawn - lamp::level(255.0, lit)).abs()
}
