//! Drawing a scene.

use std::ops::AddAssign;

use antialiasing::canvas::{Canvas, render_with};
use antialiasing::resolve;
use blending::compare::Compare;
use blending::translucent::{Translucent, faded};
use blending::{DepthTest, Over, State, TwoShift};
use clipping::Cull;
use common::{Image, Mat4, Vec2, Vec3};
use filtering::filter::{Bilinear, Nearest, Trilinear};
use transforms::inverse::elimination;

use crate::entity::Entity;
use crate::frustum::{pixels_per_unit, sees};
use crate::kept::Kept;
use crate::mesh::{Mesh, Paint};
use crate::scene::{Filtering, Scene, Shading};
use crate::shader::{AtPixels, AtVertices, Base, Lamps, Lighting, Look, Placed, Textured};
use crate::target::{Queued, Target, canvas};
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

/// Draws a scene over the target's picture: what is opaque first, the nearest first, since what it hides is then not shaded;
/// then what one sees through, the farthest first, which leaves no depths behind. How near an entity is, is told by its
/// middle. Of surfaces that are equally deep the one drawn first stays.
///
/// `inverse_camera` is the inverse of the camera's own matrix, from the world to eye space; where it has no inverse itself,
/// there is no eye, and nothing but the background is seen.
// ANCHOR: render_scene
pub fn render_scene(scene: &Scene, target: &mut Target, projection: &Mat4, inverse_camera: &Mat4) -> Counts {
    let Target { antialiased, wireframe, picture, single, many, queue, kept, lamps, wires } = target;
    let to_clip = *projection * *inverse_camera;
    let camera = elimination(inverse_camera);
    let eye = camera.unwrap_or_default().w_axis.truncate();
    let view = View { to_clip, eye, size: picture.size() };
    let mut counts = Counts::default();
    queue.clear();
    if camera.is_some() {
        enqueue(scene, &view, inverse_camera, *wireframe, queue, &mut counts);
    }
    lamps.set(&scene.lights);
    counts.triangles = if *wireframe {
        draw_wires(scene, &view, queue, *antialiased, wires, picture)
    } else if *antialiased {
        draw(scene, &view, queue, lamps, kept, canvas(many, picture), picture)
    } else {
        draw(scene, &view, queue, lamps, kept, canvas(single, picture), picture)
    };
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
    for (number, entity) in scene.entities.iter().enumerate() {
        let bounds = entity.bounds();
        if entity.normals_to_world().is_none() {
            counts.flattened += 1;
        } else if !sees(&view.to_clip, &bounds) {
            counts.outside += 1;
        } else if entity.alpha > 0.0 {
            let depth = -inverse_camera.transform_point3(bounds.center).z;
            let transparent = wireframe || !entity.is_opaque();
            queue.push(Queued { transparent, depth, entity: number });
        }
    }
    queue.sort_unstable_by(|a, b| {
        let by_depth = if a.transparent { b.depth.total_cmp(&a.depth) } else { a.depth.total_cmp(&b.depth) };
        a.transparent.cmp(&b.transparent).then(by_depth).then(a.entity.cmp(&b.entity))
    });
}
// ANCHOR_END: enqueue

fn draw_wires(
    scene: &Scene,
    view: &View,
    queue: &[Queued],
    smooth: bool,
    wires: &mut Wires,
    picture: &mut Image,
) -> clipping::Counts {
    picture.set_all(|_| scene.background);
    let mut counts = clipping::Counts::default();
    for queued in queue {
        let entity = &scene.entities[queued.entity];
        let mesh = level(entity, view);
        let to_clip = view.to_clip * entity.to_world();
        let color = faded(mesh.mean(), entity.alpha);
        counts += wires.draw(mesh, &to_clip, cull(scene, entity), color, smooth, picture);
    }
    counts
}

fn draw<C: Canvas<Stencil = ()>>(
    scene: &Scene,
    view: &View,
    queue: &[Queued],
    lamps: &Lamps,
    kept: &mut Kept,
    canvas: &mut C,
    picture: &mut Image,
) -> clipping::Counts {
    canvas.clear(scene.background, false);
    let mut counts = clipping::Counts::default();
    for queued in queue {
        let entity = &scene.entities[queued.entity];
        let Some(normals_to_world) = entity.normals_to_world() else { continue };
        let mesh = level(entity, view);
        let placed = Placed { mesh, to_world: entity.to_world(), normals_to_world, eye: view.eye, lamps };
        let pass = Pass { scene, view, entity, placed, transparent: queued.transparent };
        counts += pass.draw(kept, canvas);
    }
    canvas.resolve(resolve, picture);
    counts
}

/// The mesh of an entity that is fine enough.
fn level<'a>(entity: &'a Entity, view: &View) -> &'a Mesh {
    let pixels = pixels_per_unit(&view.to_clip, &entity.bounds(), view.size);
    entity.levels.choose(pixels * entity.scale.abs().max_element())
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
struct Pass<'a> {
    scene: &'a Scene,
    view: &'a View,
    entity: &'a Entity,
    placed: Placed<'a>,
    transparent: bool,
}

// ANCHOR: pass
impl Pass<'_> {
    fn draw<C: Canvas<Stencil = ()>>(&self, kept: &mut Kept, canvas: &mut C) -> clipping::Counts {
        let mesh = self.placed.mesh;
        match mesh.paint() {
            Paint::Color(color) => self.colored(*color, kept, canvas),
            Paint::Colors(colors) => self.colored(&colors[..], kept, canvas),
            Paint::Texture(texture) => {
                let (uvs, size) = (mesh.uvs(), canvas.size());
                match self.scene.style.filter {
                    Filtering::Nearest => {
                        self.colored(Textured { texture, uvs, filter: Nearest, size }, kept, canvas)
                    }
                    Filtering::Bilinear => {
                        self.colored(Textured { texture, uvs, filter: Bilinear, size }, kept, canvas)
                    }
                    Filtering::Trilinear => {
                        self.colored(Textured { texture, uvs, filter: Trilinear, size }, kept, canvas)
                    }
                }
            }
        }
    }

    fn colored<C: Canvas<Stencil = ()>>(
        &self,
        base: impl Base,
        kept: &mut Kept,
        canvas: &mut C,
    ) -> clipping::Counts {
        match self.scene.style.shading {
            Shading::Unlit => self.lit(base, (), kept, canvas),
            Shading::Phong => self.lit(base, AtVertices(self.placed), kept, canvas),
            Shading::BlinnPhong => self.lit(base, AtPixels(self.placed), kept, canvas),
        }
    }

    fn lit<C: Canvas<Stencil = ()>>(
        &self,
        base: impl Base,
        lighting: impl Lighting,
        kept: &mut Kept,
        canvas: &mut C,
    ) -> clipping::Counts {
        let Placed { mesh, to_world, .. } = self.placed;
        let to_clip = self.view.to_clip * to_world;
        let look = Look { mesh, to_clip, base, lighting };
        let (mesh, cull) = (mesh.assembled(), cull(self.scene, self.entity));
        if !self.transparent {
            return render_with(kept.of(), &look, mesh, cull, State::OFF, canvas);
        }
        let shader = Translucent { shader: look, alpha: self.entity.alpha, vertices: () };
        let state = State {
            scissor: (),
            stencil: (),
            depth: DepthTest { function: Compare::Less, write: false },
            blend: Over::<TwoShift>::default(),
            mask: (),
        };
        render_with(kept.of(), &shader, mesh, cull, state, canvas)
    }
}
// ANCHOR_END: pass
