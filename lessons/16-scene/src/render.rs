//! Drawing a scene.

use std::ops::AddAssign;

use antialiasing::canvas::{Canvas, render_with};
use antialiasing::resolve;
use blending::compare::Compare;
use blending::translucent::{Translucent, faded};
use blending::{DepthTest, Over, State, TwoShift};
use clipping::Cull;
use clipping::render::Vertices;
use common::{Color, Image, Mat3, Mat4, Vec2, Vec3};
use transforms::inverse::elimination;

use crate::entity::Entity;
use crate::frustum::{Sphere, pixels_per_unit, sees};
use crate::kept::Kept;
use crate::lamps::Lamps;
use crate::mesh::{Mesh, Paint};
use crate::scene::{Scene, Shading, Style};
use crate::shader::{AtPixels, AtVertices, Base, Lighting, Look, Placed, Textured};
use crate::target::{Many, Queued, Single, Target, canvas};
use crate::wireframe::Wires;

/// What became of entities and of their triangles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Entities outside of the picture, none of whose vertices was computed.
    pub outside: usize,
    /// Entities that their scale makes flat, which are not drawn.
    pub flattened: usize,
    /// Vertices and triangles of the others.
    pub triangles: clipping::Counts,
}

impl AddAssign for Counts {
    fn add_assign(&mut self, other: Self) {
        self.outside += other.outside;
        self.flattened += other.flattened;
        self.triangles += other.triangles;
    }
}

/// Who looks at a scene.
#[derive(Clone, Copy)]
struct View {
    /// From the world to clip space.
    to_clip: Mat4,
    /// The eye in the world.
    eye: Vec3,
    /// The picture's size in pixels.
    size: Vec2,
}

/// What fills triangles: this lesson's loops, or whatever draws the same pixels.
// ANCHOR: renderer
pub trait Renderer {
    /// Draws a frame over a picture of the frame's size, of red, green and blue.
    fn draw(&mut self, frame: &Frame, picture: &mut Image) -> clipping::Counts;
}
// ANCHOR_END: renderer

/// What is to be drawn of a scene.
pub struct Frame<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// Whether a pixel has sixteen samples, or one.
    pub antialiased: bool,
    view: View,
    queue: &'a [Queued],
}

/// Draws a scene over the target's picture: what is opaque first, the nearest first, since what it hides is then not shaded;
/// then what one sees through, the farthest first, which leaves no depths behind. How near what is opaque is, is told by the
/// far end of the sphere that it is within, for the others by its middle. Of surfaces that are equally deep the one drawn first
/// stays.
///
/// `inverse_camera` is the inverse of the camera's own matrix, from the world to eye space; where it has no inverse itself,
/// there is no eye, and nothing but the background is seen.
// ANCHOR: render_scene
pub fn render_scene(scene: &Scene, target: &mut Target, projection: &Mat4, inverse_camera: &Mat4) -> Counts {
    let Target { antialiased, wireframe, picture, queue, wires, renderer } = target;
    let to_clip = *projection * *inverse_camera;
    let camera = elimination(inverse_camera);
    let eye = camera.unwrap_or_default().w_axis.truncate();
    let view = View { to_clip, eye, size: picture.size() };
    let mut counts = Counts::default();
    queue.clear();
    if camera.is_some() {
        enqueue(scene, &view, inverse_camera, *wireframe, queue, &mut counts);
    }
    let renderer = if *wireframe { wires } else { renderer };
    counts.triangles = renderer.draw(&Frame { scene, antialiased: *antialiased, view, queue }, picture);
    counts
}
// ANCHOR_END: render_scene

/// Who is to be drawn, in this order. Through a wireframe one sees, so all are drawn from the farthest on.
// ANCHOR: enqueue
fn enqueue(
    scene: &Scene,
    view: &View,
    inverse_camera: &Mat4,
    wireframe: bool,
    queue: &mut Vec<Queued>,
    counts: &mut Counts,
) {
    queue.reserve(scene.entities.len());
    for (number, entity) in scene.entities.iter().enumerate() {
        let bounds = entity.bounds();
        let Some(normals_to_world) = entity.normals_to_world() else {
            counts.flattened += 1;
            continue;
        };
        if !sees(&view.to_clip, &bounds) {
            counts.outside += 1;
        } else if entity.alpha > 0.0 {
            let middle = -inverse_camera.transform_point3(bounds.center).z;
            let transparent = wireframe || !entity.is_opaque();
            // What is large, a floor, is behind most of what is near its middle.
            let depth = if transparent { middle } else { middle + bounds.radius };
            let to_world = entity.to_world();
            queue.push(Queued { transparent, depth, entity: number, bounds, to_world, normals_to_world });
        }
    }
    queue.sort_unstable_by(|a, b| {
        let by_depth = if a.transparent { b.depth.total_cmp(&a.depth) } else { a.depth.total_cmp(&b.depth) };
        a.transparent.cmp(&b.transparent).then(by_depth).then(a.entity.cmp(&b.entity))
    });
}
// ANCHOR_END: enqueue

/// The sides of triangles, which are smooth where edges are.
impl Renderer for Wires {
    fn draw(&mut self, frame: &Frame, picture: &mut Image) -> clipping::Counts {
        let &Frame { scene, antialiased, view, queue } = frame;
        picture.set_all(|_| scene.background);
        scene.entities.iter().for_each(|entity| self.reserve(entity.levels.finest()));
        let mut counts = clipping::Counts::default();
        for queued in queue {
            let entity = &scene.entities[queued.entity];
            let mesh = level(entity, &view, &queued.bounds, WIRE_SHARE);
            let to_clip = view.to_clip * queued.to_world;
            let color = faded(mesh.mean(), entity.alpha);
            counts += self.mesh(mesh, &to_clip, cull(scene, entity), color, antialiased, picture);
        }
        counts
    }
}

impl<'a> Frame<'a> {
    /// The entities that are drawn, in this order.
    pub fn passes(&self) -> impl Iterator<Item = Pass<'a>> {
        let &Self { scene, view, queue, .. } = self;
        queue.iter().map(move |queued| {
            let entity = &scene.entities[queued.entity];
            let &Queued { to_world, normals_to_world, .. } = queued;
            Pass {
                mesh: level(entity, &view, &queued.bounds, 1.0),
                to_clip: view.to_clip * to_world,
                to_world,
                normals_to_world,
                eye: view.eye,
                cull: cull(scene, entity),
                alpha: queued.transparent.then_some(entity.alpha),
            }
        })
    }
}

/// This lesson's renderer: one mesh after the other, each by a loop compiled for its look, to lesson 15's samples.
#[derive(Default)]
pub struct Loops {
    single: Option<Single>,
    many: Option<Many>,
    /// Lists of vertices.
    kept: Kept,
    lamps: Lamps,
}

impl Renderer for Loops {
    fn draw(&mut self, frame: &Frame, picture: &mut Image) -> clipping::Counts {
        let Self { single, many, kept, lamps } = self;
        lamps.set(&frame.scene.lights);
        if frame.antialiased {
            draw(frame, lamps, kept, canvas(many, picture), picture)
        } else {
            draw(frame, lamps, kept, canvas(single, picture), picture)
        }
    }
}

// ANCHOR: draw
fn draw<C: Canvas<Stencil = ()>>(
    frame: &Frame,
    lamps: &Lamps,
    kept: &mut Kept,
    canvas: &mut C,
    picture: &mut Image,
) -> clipping::Counts {
    let scene = frame.scene;
    canvas.clear(scene.background, false);
    scene.entities.iter().for_each(|entity| reserve(entity, scene.style.shading, kept));
    let mut counts = clipping::Counts::default();
    for pass in frame.passes() {
        counts += pass.draw(scene.style, lamps, kept, canvas);
    }
    canvas.resolve(resolve, picture);
    counts
}
// ANCHOR_END: draw

/// Makes room for an entity's vertices, of what its paint and its shading interpolate, in the finest of its levels: a frame in
/// which it comes nearer, or into the picture, allocates nothing.
// ANCHOR: reserve
fn reserve(entity: &Entity, shading: Shading, kept: &mut Kept) {
    fn of<B: Base, L: Lighting>(vertices: usize, opaque: bool, kept: &mut Kept) {
        if opaque {
            kept.of::<Vertices<(B::Varying, L::Varying)>>().reserve(vertices);
        } else {
            kept.of::<Vertices<((B::Varying, L::Varying), ())>>().reserve(vertices);
        }
    }
    let mesh = entity.levels.finest();
    let of = match (mesh.paint(), shading) {
        (Paint::Color(_), Shading::Unlit) => of::<Color, ()>,
        (Paint::Color(_), Shading::Phong) => of::<Color, AtVertices>,
        (Paint::Color(_), Shading::BlinnPhong) => of::<Color, AtPixels>,
        (Paint::Colors(_), Shading::Unlit) => of::<&[Color], ()>,
        (Paint::Colors(_), Shading::Phong) => of::<&[Color], AtVertices>,
        (Paint::Colors(_), Shading::BlinnPhong) => of::<&[Color], AtPixels>,
        (Paint::Texture(_), Shading::Unlit) => of::<Textured, ()>,
        (Paint::Texture(_), Shading::Phong) => of::<Textured, AtVertices>,
        (Paint::Texture(_), Shading::BlinnPhong) => of::<Textured, AtPixels>,
    };
    of(mesh.assembled().vertices.len(), entity.is_opaque(), kept);
}
// ANCHOR_END: reserve

/// A wireframe may be 8 times as far off as a surface: four pixels. Where that is half a pixel, sides are so short that lines
/// cover all between them, and nothing is seen of the triangles.
const WIRE_SHARE: f32 = 1.0 / 8.0;

/// The mesh of an entity that is fine enough, where each of its pixels counts for such a share of one.
fn level<'a>(entity: &'a Entity, view: &View, bounds: &Sphere, share: f32) -> &'a Mesh {
    let pixels = pixels_per_unit(&view.to_clip, bounds, view.size);
    entity.levels.choose(share * pixels * entity.scale.abs().max_element())
}

/// What is left out of an entity: mirrored, its triangles run the other way round.
fn cull(scene: &Scene, entity: &Entity) -> Cull {
    match scene.style.cull {
        Cull::Back if entity.is_mirrored() => Cull::Front,
        Cull::Front if entity.is_mirrored() => Cull::Back,
        cull => cull,
    }
}

/// An entity that is drawn.
#[derive(Clone, Copy)]
pub struct Pass<'a> {
    /// Its mesh, as fine as is needed.
    pub mesh: &'a Mesh,
    /// From the model's space to clip space.
    pub to_clip: Mat4,
    /// From the model's space to the world.
    pub to_world: Mat4,
    /// What turns normals likewise.
    pub normals_to_world: Mat3,
    /// The eye in the world.
    pub eye: Vec3,
    /// Which of its triangles are left out.
    pub cull: Cull,
    /// What its colours' alpha is multiplied by where one sees through it: then it is laid over what is there, and leaves no
    /// depths behind.
    pub alpha: Option<f32>,
}

// ANCHOR: pass
impl<'a> Pass<'a> {
    /// Its place, lit by these.
    #[must_use]
    pub fn placed(&self, lamps: &'a Lamps) -> Placed<'a> {
        let Self { mesh, to_world, normals_to_world, eye, .. } = *self;
        Placed { mesh, to_world, normals_to_world, eye, lamps }
    }

    fn draw<C: Canvas<Stencil = ()>>(
        &self,
        style: Style,
        lamps: &Lamps,
        kept: &mut Kept,
        canvas: &mut C,
    ) -> clipping::Counts {
        let (placed, shading) = (self.placed(lamps), style.shading);
        match self.mesh.paint() {
            Paint::Color(color) => self.colored(*color, placed, shading, kept, canvas),
            Paint::Colors(colors) => self.colored(&colors[..], placed, shading, kept, canvas),
            Paint::Texture(texture) => {
                let (uvs, filter, size) = (self.mesh.uvs(), style.filter, canvas.size());
                self.colored(Textured { texture, uvs, filter, size }, placed, shading, kept, canvas)
            }
        }
    }

    fn colored<C: Canvas<Stencil = ()>>(
        &self,
        base: impl Base,
        placed: Placed,
        shading: Shading,
        kept: &mut Kept,
        canvas: &mut C,
    ) -> clipping::Counts {
        match shading {
            Shading::Unlit => self.lit(base, (), kept, canvas),
            Shading::Phong => self.lit(base, AtVertices(placed), kept, canvas),
            Shading::BlinnPhong => self.lit(base, AtPixels(placed), kept, canvas),
        }
    }

    fn lit<C: Canvas<Stencil = ()>>(
        &self,
        base: impl Base,
        lighting: impl Lighting,
        kept: &mut Kept,
        canvas: &mut C,
    ) -> clipping::Counts {
        let Self { mesh, to_clip, cull, .. } = *self;
        let look = Look { mesh, to_clip, base, lighting };
        let Some(alpha) = self.alpha else {
            return render_with(kept.of(), &look, mesh.assembled(), cull, State::OFF, canvas);
        };
        let shader = Translucent { shader: look, alpha, vertices: () };
        let state = State {
            scissor: (),
            stencil: (),
            depth: DepthTest { function: Compare::Less, write: false },
            blend: Over::<TwoShift>::default(),
            mask: (),
        };
        render_with(kept.of(), &shader, mesh.assembled(), cull, state, canvas)
    }
}
// ANCHOR_END: pass

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use lighting::PointLight;

    use super::*;
    use crate::levels::Levels;
    use crate::scene::{Filtering, Style};
    use crate::shapes::{cube, sphere};
    use crate::versions::in_perspective;

    const BACKGROUND: Color = Color::rgb(10, 20, 30);

    fn scene(entities: Vec<Entity>, shading: Shading) -> Scene {
        let style = Style { shading, filter: Filtering::Nearest, cull: Cull::Back };
        let lights = vec![PointLight { position: Vec3::new(1.0, 2.0, 3.0), ..PointLight::default() }];
        Scene { entities, lights, background: BACKGROUND, style }
    }

    fn painted(color: Color) -> Arc<Levels> {
        Levels::one(Mesh::new(&cube(), Paint::Color(color)))
    }

    /// A cube straight ahead, so far away.
    fn ahead(color: Color, distance: f32) -> Entity {
        Entity { position: Vec3::new(0.0, 0.0, -distance), ..Entity::new(painted(color)) }
    }

    /// What an eye at the origin sees, which looks along −z.
    fn drawn(scene: &Scene, target: &mut Target) -> Counts {
        let projection = in_perspective(60.0, target.picture().size());
        render_scene(scene, target, &projection, &Mat4::IDENTITY)
    }

    /// The middle of a picture, smooth and not, which must agree.
    fn middle(scene: &Scene) -> Color {
        let mut target = Target::new(9, 9);
        drawn(scene, &mut target);
        let rough = target.picture().get(4, 4);
        target.antialiased = true;
        drawn(scene, &mut target);
        assert_eq!(target.picture().get(4, 4), rough);
        rough.unwrap()
    }

    fn all(target: &Target, color: Color) -> bool {
        target.picture().pixels().all(|pixel| pixel.2 == color)
    }

    #[test]
    fn nothing_to_be_drawn_leaves_the_background_and_no_light_black() {
        let mut target = Target::new(1, 1);
        for (antialiased, wireframe) in [(false, false), (true, false), (false, true), (true, true)] {
            (target.antialiased, target.wireframe) = (antialiased, wireframe);
            assert_eq!(drawn(&scene(vec![], Shading::Phong), &mut target), Counts::default());
            assert!(all(&target, BACKGROUND));
        }
        for shading in [Shading::Phong, Shading::BlinnPhong] {
            let dark = Scene { lights: vec![], ..scene(vec![ahead(Color::WHITE, 2.0)], shading) };
            assert_eq!(middle(&dark), Color::BLACK);
        }
    }

    /// The assignment's own example, (0, 200, 0, 255) at half alpha: 127 of 255 of it are seen.
    #[test]
    fn what_one_sees_through_is_laid_over_what_is_behind_whatever_was_added_first() {
        let green = Entity { alpha: 0.5, ..ahead(Color::rgb(0, 200, 0), 2.0) };
        let red = Entity { alpha: 0.25, ..ahead(Color::RED, 4.0) };
        let blue = ahead(Color::rgb(0, 0, 255), 6.0);
        let over = |top: Color, alpha: f32, below: Color| {
            let share = (255.0 * alpha).floor() / 255.0;
            let mix = |a: u8, b: u8| (f32::from(a) * share + f32::from(b) * (1.0 - share)).round() as u8;
            Color::rgb(mix(top.r, below.r), mix(top.g, below.g), mix(top.b, below.b))
        };
        let behind = over(Color::RED, 0.25, Color::rgb(0, 0, 255));
        let expected = over(Color::rgb(0, 200, 0), 0.5, behind);
        let orders = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
        for order in orders {
            let entities = order.map(|n| [&green, &red, &blue][n].clone()).to_vec();
            assert_eq!(middle(&scene(entities, Shading::Unlit)), expected, "{order:?}");
        }
        let gone = Entity { alpha: 0.0, ..green };
        assert_eq!(middle(&scene(vec![gone, blue], Shading::Unlit)), Color::rgb(0, 0, 255));
    }

    #[test]
    fn what_is_flat_is_not_drawn_and_counted() {
        let flat = Entity { scale: Vec3::new(1.0, 1.0, 0.0), ..ahead(Color::RED, 2.0) };
        let mut target = Target::new(8, 6);
        let counts = drawn(&scene(vec![flat, ahead(Color::GREEN, 3.0)], Shading::Unlit), &mut target);
        assert_eq!((counts.flattened, counts.triangles.vertices), (1, 24));
        assert_eq!(target.picture().get(4, 3), Some(Color::GREEN));
    }

    /// A sphere is its own mirror image, so it looks the same mirrored along any number of its axes: the same side is culled,
    /// and the same side is lit.
    #[test]
    fn a_mirrored_sphere_is_culled_and_lit_as_it_was() {
        let mesh = Levels::one(Mesh::new(&sphere(64, 128), Paint::Color(Color::WHITE)));
        let placed = |scale: [f32; 3]| Entity {
            levels: mesh.clone(),
            scale: scale.into(),
            ..ahead(Color::WHITE, 4.0)
        };
        for shading in [Shading::Phong, Shading::BlinnPhong] {
            let mut expected = Target::new(48, 36);
            drawn(&scene(vec![placed([1.0; 3])], shading), &mut expected);
            for scale in [[-1.0, 1.0, 1.0], [1.0, -1.0, 1.0], [1.0, -1.0, -1.0], [-1.0; 3]] {
                let mut mirrored = Target::new(48, 36);
                drawn(&scene(vec![placed(scale)], shading), &mut mirrored);
                let pixels = expected.picture().pixels().zip(mirrored.picture().pixels());
                let far = pixels.filter(|(a, b)| {
                    // Diagonals run the other way, and so do roundings.
                    let [a, b] = [a.2, b.2].map(|color| [color.r, color.g, color.b]);
                    (0..3).any(|n| a[n].abs_diff(b[n]) > 2)
                });
                assert!(far.count() <= 4, "{shading:?} {scale:?}");
            }
        }
    }

    /// Within a cube one sees its far sides from inside, if these are not culled, and nothing of one behind the eye.
    #[test]
    fn the_eye_may_be_inside() {
        let mut target = Target::new(20, 20);
        let around = Entity { scale: Vec3::splat(3.0), ..ahead(Color::RED, 0.0) };
        for (cull, color) in [(Cull::None, Color::RED), (Cull::Front, Color::RED), (Cull::Back, BACKGROUND)] {
            let mut scene = scene(vec![around.clone(), ahead(Color::GREEN, -2.0)], Shading::Unlit);
            scene.style.cull = cull;
            drawn(&scene, &mut target);
            assert!(all(&target, color), "{cull:?}");
            // Mirrored, the other side of each triangle is its inside.
            scene.entities[0].scale.x = -3.0;
            drawn(&scene, &mut target);
            assert!(all(&target, color), "{cull:?}");
        }
    }

    /// A matrix that flattens the world is no camera's.
    #[test]
    fn without_a_camera_nothing_is_seen() {
        let mut target = Target::new(5, 4);
        let flat = Mat4::from_diagonal(Vec3::new(1.0, 0.0, 1.0).extend(1.0));
        for inverse_camera in [flat, Mat4::ZERO, Mat4::NAN] {
            let scene = scene(vec![ahead(Color::RED, 2.0)], Shading::Unlit);
            render_scene(&scene, &mut target, &in_perspective(60.0, Vec2::new(5.0, 4.0)), &inverse_camera);
            assert!(all(&target, BACKGROUND));
        }
    }
}
