//! What a scene should look like: a ray through each pixel's centre, in `f64`, every entity placed in the assignment's own
//! left-handed space. From the lesson come numbers alone: vertices, texels, where entities stand.

use checks::assignment::{Placement, mirrored, shown};
use checks::footprint::{Outside, Texture, code};
use checks::lamp::{Highlight, Lamp, level};
use checks::ray::{self, Screen};
use checks::{texel, view};
use clipping::Cull;
use common::{Color, DVec2, DVec3, Format, Image, Vec2, Vec3};
use lighting::PointLight;
use lighting::light::Falloff;
use scene::{Entity, Filtering, Mesh, Orbit, Paint, Scene, Shading, Style};

/// Who looks, and how.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Eye {
    /// By version 0's formula, which shows x/5 and y/5, from the origin.
    Orthographic,
    /// The same, but as if its eye were infinitely far away, and so in one direction from all that it lights.
    AlongZ,
    /// From the origin along −z, so many degrees from bottom to top.
    Ahead(f64),
    /// From an orbit to the origin, likewise.
    Around(Orbit, f64),
}

/// A ray in the world.
#[derive(Clone, Copy)]
struct Ray {
    from: DVec3,
    along: DVec3,
}

impl Eye {
    /// Where it is.
    fn place(self) -> DVec3 {
        match self {
            Self::Orthographic | Self::Ahead(_) => DVec3::ZERO,
            Self::AlongZ => DVec3::Z * 1e9,
            Self::Around(orbit, _) => {
                let [azimuth, elevation] =
                    [orbit.azimuth(), orbit.elevation()].map(|angle| f64::from(angle).to_radians());
                let level = DVec3::new(azimuth.sin(), 0.0, azimuth.cos());
                f64::from(orbit.distance()) * (level * elevation.cos() + DVec3::Y * elevation.sin())
            }
        }
    }

    /// The ray through a place of a picture, in pixels from its lower left corner.
    fn through(self, at: DVec2, size: DVec2) -> Ray {
        let from = self.place();
        match self {
            Self::Orthographic | Self::AlongZ => {
                let DVec2 { x, y } = shown(DVec2::new(at.x, size.y - at.y), size);
                Ray { from: DVec3::new(x, y, 0.0), along: DVec3::NEG_Z }
            }
            Self::Ahead(fov) => Ray { from, along: Screen::ahead(fov, size).direction(at) },
            Self::Around(_, fov) => {
                let [right, up, back] = view::basis(from.as_vec3(), Vec3::ZERO, Vec3::Y);
                let DVec3 { x, y, z } = Screen::ahead(fov, size).direction(at);
                Ray { from, along: right * x + up * y + back * z }
            }
        }
    }
}

/// A triangle in the world.
struct Face {
    corners: [DVec3; 3],
    normals: [DVec3; 3],
    /// Out of the mesh, of some length.
    outward: DVec3,
    colors: [[f64; 4]; 3],
    uvs: [DVec2; 3],
    /// What each corner sends to the eye, of its colour and of white.
    reflected: [[f64; 2]; 3],
}

/// What a texture is read from.
struct Wood {
    image: Image,
    filtered: Texture,
}

struct Thing {
    faces: Vec<Face>,
    wood: Option<Wood>,
    /// Of 255.
    alpha: f64,
}

/// A scene in `f64`, and who looks at it.
pub(crate) struct Truth {
    things: Vec<Thing>,
    lamps: Vec<Lamp>,
    background: [f64; 3],
    style: Style,
    eye: Eye,
    /// How far before the eye there is something to be seen.
    pub(crate) depths: [f64; 2],
}

/// A point that a ray meets.
#[derive(Clone, Copy, Debug)]
struct Hit {
    thing: usize,
    face: usize,
    weights: DVec3,
    distance: f64,
}

/// The assignment's placement of an entity, and that of a mesh in its space.
pub(crate) fn placement(entity: &Entity) -> Placement {
    let Vec3 { x, y, z } = entity.degrees;
    Placement {
        position: mirrored(entity.position.as_dvec3()),
        degrees: DVec3::new(-f64::from(x), -f64::from(y), z.into()),
        scale: entity.scale.as_dvec3(),
    }
}

/// A lamp as the reference takes it.
pub(crate) fn lamp(light: &PointLight) -> Lamp {
    let [ambient, diffuse, specular, shininess] =
        [light.ambient, light.diffuse, light.specular, light.shininess].map(f64::from);
    let fading = match light.falloff {
        Falloff::None => 0,
        Falloff::Linear => 1,
        Falloff::Quadratic => 2,
    };
    Lamp { position: light.position.as_dvec3(), ambient, diffuse, specular, shininess, fading }
}

/// Red, green, blue and alpha of a colour, as numbers.
pub(crate) fn codes(Color { r, g, b, a }: Color) -> [f64; 4] {
    [r, g, b, a].map(f64::from)
}

/// The largest difference of a channel.
pub(crate) fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|n| (a[n] - b[n]).abs()).fold(0.0, f64::max)
}

/// The sum of three things with weights.
fn mean<const N: usize>(weights: DVec3, of: [[f64; N]; 3]) -> [f64; N] {
    std::array::from_fn(|n| (0..3).map(|corner| weights[corner] * of[corner][n]).sum())
}

impl Truth {
    /// Of a scene all of whose meshes are in their finest resolution.
    pub(crate) fn new(scene: &Scene, eye: Eye) -> Self {
        let lamps: Vec<Lamp> = scene.lights.iter().map(lamp).collect();
        let [r, g, b, _] = codes(scene.background);
        let mut truth = Self {
            things: Vec::new(),
            lamps,
            background: [r, g, b],
            style: scene.style,
            eye,
            depths: [0.0, f64::INFINITY],
        };
        truth.things = scene.entities.iter().map(|entity| truth.thing(entity)).collect();
        truth
    }

    fn thing(&self, entity: &Entity) -> Thing {
        let (mesh, placement) = (entity.levels.finest(), placement(entity));
        let faces = (0..mesh.triangles()).map(|face| self.face(mesh, &placement, face)).collect();
        let wood = match mesh.paint() {
            Paint::Texture(texture) => {
                let base = texture.base();
                let mut image = Image::new(base.width() as u16, base.height() as u16, Format::Rgba);
                for y in 0..base.height() {
                    (0..base.width()).for_each(|x| image.set(x, y, base.texel(x, y)));
                }
                let filtered = Texture::new(&image, Outside::Border);
                Some(Wood { image, filtered })
            }
            Paint::Color(_) | Paint::Colors(_) => None,
        };
        // A half is rounded down: half of 255 is 127.
        Thing { faces, wood, alpha: (255.0 * f64::from(entity.alpha) - 0.5).ceil().clamp(0.0, 255.0) }
    }

    fn face(&self, mesh: &Mesh, placement: &Placement, face: usize) -> Face {
        let vertices = [0, 1, 2].map(|corner| mesh.vertex(face, corner));
        let own = vertices.map(|vertex| mesh.positions()[vertex].as_dvec3());
        let corners = own.map(|point| mirrored(placement.place(mirrored(point))));
        let carried = |normal: DVec3| mirrored(placement.normal(mirrored(normal)));
        let normals = vertices.map(|vertex| carried(mesh.normals()[vertex].as_dvec3()).normalize());
        let color = |vertex: usize| match mesh.paint() {
            Paint::Color(color) => codes(*color),
            Paint::Colors(colors) => codes(colors[vertex]),
            Paint::Texture(_) => [255.0; 4],
        };
        let uv = |vertex: usize| mesh.uvs().get(vertex).copied().unwrap_or(Vec2::ZERO).as_dvec2();
        let reflected = |n: usize| self.reflected(corners[n], normals[n], Highlight::Mirrored);
        Face {
            corners,
            normals,
            outward: carried((own[1] - own[0]).cross(own[2] - own[0])),
            colors: vertices.map(color),
            uvs: vertices.map(uv),
            reflected: [0, 1, 2].map(reflected),
        }
    }

    /// What all lamps together make a point send to the eye.
    fn reflected(&self, point: DVec3, normal: DVec3, highlight: Highlight) -> [f64; 2] {
        let on = self.lamps.iter().map(|lamp| lamp.on(point, normal, self.eye.place(), highlight));
        on.fold([0.0; 2], |sum, [body, shine]| [sum[0] + body, sum[1] + shine])
    }

    /// All that a ray meets, the nearest first.
    fn hits(&self, ray: Ray) -> Vec<Hit> {
        let mut hits = Vec::new();
        for (n, thing) in self.things.iter().enumerate() {
            for (m, face) in thing.faces.iter().enumerate() {
                let from = face.corners.map(|corner| corner - ray.from);
                let weights = ray::hit(from, ray.along).weights;
                let point = weights.x * from[0] + weights.y * from[1] + weights.z * from[2];
                // Rays are 1 long along the way that the eye looks.
                let distance = point.dot(ray.along) / ray.along.length_squared();
                let [near, far] = self.depths;
                let shows_back = face.outward.dot(ray.along) > 0.0;
                let left_out = match self.style.cull {
                    Cull::None => false,
                    Cull::Back => shows_back,
                    Cull::Front => !shows_back,
                };
                if weights.min_element() >= 0.0 && (near..=far).contains(&distance) && !left_out {
                    hits.push(Hit { thing: n, face: m, weights, distance });
                }
            }
        }
        hits.sort_by(|a, b| a.distance.total_cmp(&b.distance));
        hits
    }

    /// What is seen at a place: all that lets light through, and the first that does not, the nearest first.
    fn seen(&self, at: DVec2, size: DVec2) -> Vec<Hit> {
        let hits = self.hits(self.eye.through(at, size));
        let opaque = hits.iter().position(|hit| self.things[hit.thing].alpha == 255.0);
        hits[..opaque.map_or(hits.len(), |first| first + 1)].to_vec()
    }

    /// The colour of a point.
    fn color(&self, hit: &Hit) -> [f64; 3] {
        let thing = &self.things[hit.thing];
        let face = &thing.faces[hit.face];
        let base = match &thing.wood {
            None => {
                let [r, g, b, _] = mean(hit.weights, face.colors);
                [r, g, b]
            }
            Some(wood) => {
                let [u, v] = mean(hit.weights, face.uvs.map(<[f64; 2]>::from));
                wood.color(DVec2::new(u, v), self.style.filter)
            }
        };
        let shares = match self.style.shading {
            Shading::Unlit => return base,
            Shading::Phong => mean(hit.weights, face.reflected),
            Shading::BlinnPhong => {
                let of = |of: [DVec3; 3]| DVec3::from(mean(hit.weights, of.map(<[f64; 3]>::from)));
                self.reflected(of(face.corners), of(face.normals), Highlight::Halfway)
            }
        };
        base.map(|channel| level(channel, shares))
    }

    /// The colour that is seen through a place, laid over each other.
    fn over(&self, hits: &[Hit]) -> [f64; 3] {
        hits.iter().rev().fold(self.background, |below, hit| {
            let (color, alpha) = (self.color(hit), self.things[hit.thing].alpha / 255.0);
            std::array::from_fn(|n| alpha * color[n] + (1.0 - alpha) * below[n])
        })
    }

    /// The colour of the pixel in this column and row, rows from the bottom; `None` where a corner's rounding to 1/256 px
    /// may decide which triangle or which texel is seen.
    pub(crate) fn pixel(&self, x: i32, y: i32, size: DVec2) -> Option<[f64; 3]> {
        let center = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
        let faces = |hits: &[Hit]| hits.iter().map(|hit| [hit.thing, hit.face]).collect::<Vec<_>>();
        let seen = self.seen(center, size);
        let color = self.over(&seen);
        let certain = [DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y].iter().all(|way| {
            let beside = self.seen(center + way / 100.0, size);
            faces(&beside) == faces(&seen) && distance(self.over(&beside), color) < 0.5
        });
        certain.then_some(color)
    }

    /// The colour at a place, in pixels from the lower left corner.
    pub(crate) fn at(&self, at: DVec2, size: DVec2) -> [f64; 3] {
        self.over(&self.seen(at, size))
    }

    /// By how many levels a channel of a picture is off at most, where no rounding decides.
    pub(crate) fn worst(&self, picture: &Image) -> f64 {
        let size = picture.size().as_dvec2();
        let off = picture.pixels().filter_map(|(x, y, color)| {
            let [r, g, b, _] = codes(color);
            Some(distance([r, g, b], self.pixel(x, y, size)?))
        });
        off.fold(0.0, f64::max)
    }

    /// Checks that a picture shows it, each channel to within so many levels, and that no more than that share of its pixels
    /// was too near to a side to tell.
    #[track_caller]
    pub(crate) fn check(&self, picture: &Image, tolerance: f64, uncertain: f64) {
        let size = picture.size().as_dvec2();
        let (mut wrong, mut unknown, mut shown) = (Vec::new(), 0, 0);
        for (x, y, color) in picture.pixels() {
            let Some(expected) = self.pixel(x, y, size) else {
                unknown += 1;
                continue;
            };
            let [r, g, b, _] = codes(color);
            if distance([r, g, b], expected) > tolerance {
                wrong.push(format!("({x}, {y}) is {color:?}, not {expected:.2?}"));
            }
            shown += usize::from(expected != self.background);
        }
        let all = size.x * size.y;
        assert!(wrong.is_empty(), "{} of {all} pixels: {:#?}", wrong.len(), &wrong[..wrong.len().min(5)]);
        assert!(f64::from(unknown) <= uncertain * all, "{unknown} of {all} pixels are uncertain");
        assert!(shown > 0, "nothing but the background is to be seen");
    }
}

impl Wood {
    /// The codes at (u, v).
    fn color(&self, uv: DVec2, filter: Filtering) -> [f64; 3] {
        match filter {
            Filtering::Nearest => {
                let along = |c: f64, n: i32| texel::clamped(c as f32, n as u16).expect("finite coordinates");
                let [i, j] = [along(uv.x, self.image.width()), along(uv.y, self.image.height())];
                let [r, g, b, _] = codes(self.image.get(i, j).expect("inside"));
                [r, g, b]
            }
            Filtering::Bilinear => self.filtered.at(uv).map(code),
            Filtering::Trilinear => unimplemented!("no version of the assignment has levels"),
        }
    }
}
