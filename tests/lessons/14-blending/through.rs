use std::collections::BTreeMap;
use std::path::Path;

use assets::torus_knot::torus_knot;
use blending::crates::{self, CRATE};
use blending::scene::{self, View};
use blending::transparency::{Fill, gather};
use blending::{
    Compare, DepthTest, Framebuffer, Over, State, TRANSPARENCY, Translucent, Transparency, TwoShift, plain,
};
use checks::layers::Pixel;
use checks::picture::mean_difference;
use clipping::mesh::indexed;
use clipping::{Clipping, Cull, Mesh, render};
use common::{Attributes, Bounds, Color, Format, Image, Model, Vec2, Vec3, Vec4};
use fastrand::Rng;
use filtering::scene::Filterable;
use filtering::{MIPMAPS, Wrap};
use perspective::scene::Loaded;
use perspective::{perspective, view};
use shaders::shader::{Fragment, Shader};
use shaders::source::White;
use shaders::target::Target;
use shaders::{Lit, Uniforms};
use verify::method;
use zbuffer::{DepthBuffer, Surface};

/// Keeps what it is given, pixel by pixel.
struct Recorder {
    bounds: Bounds,
    fragments: BTreeMap<(i32, i32), Vec<(f64, Color)>>,
}

impl Recorder {
    fn new(image: &Image) -> Self {
        Self { bounds: image.bounds(), fragments: BTreeMap::new() }
    }

    /// What is seen at a pixel over a colour.
    fn seen(&self, x: i32, y: i32, below: Color) -> Color {
        let mut layers = self.fragments.get(&(x, y)).cloned().unwrap_or_default();
        layers.sort_by(|a, b| b.0.total_cmp(&a.0));
        Pixel { below, layers, gap: 0.0 }.rounded()
    }
}

impl Target<Color> for Recorder {
    fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn test(&mut self, _: i32, _: i32, depth: f32) -> bool {
        depth < 1.0
    }

    fn write(&mut self, x: i32, y: i32, depth: f32, color: Color) {
        self.fragments.entry((x, y)).or_default().push((depth.into(), color));
    }

    fn clear(&mut self) {
        self.fragments.clear();
    }
}

/// A shader with holes: each pixel of which x + y is even is dropped.
struct Sieve<S>(S);

impl<S: Shader<Output = Color>> Shader for Sieve<S> {
    type Constant = S::Constant;
    type Varying = S::Varying;
    type Output = Color;

    fn position(&self, vertex: usize) -> Vec4 {
        self.0.position(vertex)
    }

    fn triangle(&self, face: usize) -> Option<S::Constant> {
        self.0.triangle(face)
    }

    fn corner(&self, face: usize, corner: usize) -> S::Varying {
        self.0.corner(face, corner)
    }

    fn fragment(&self, constant: S::Constant, fragment: Fragment<S::Varying>) -> Option<Color> {
        let whole = (fragment.x + fragment.y) % 2 == 1;
        whole.then(|| self.0.fragment(constant, fragment)).flatten()
    }
}

/// A knotted tube of glass, all its windings seen through each other, from so near that some of it is cut away; any alpha at any
/// corner.
struct Glass {
    model: Model,
    mesh: Mesh,
    alphas: Vec<[f32; 3]>,
}

/// White by its face's number, with an alpha at each corner.
type Tube<'a> = Translucent<Lit<'a, White, Lamp>, &'a [[f32; 3]]>;

impl Glass {
    fn new() -> Self {
        let needs = Attributes { normals: false, uvs: false };
        let model = Model::parse(torus_knot(60, 7).to_obj().as_bytes(), needs).unwrap();
        let mesh = indexed(&model, &[], needs);
        let mut rng = Rng::with_seed(14);
        // A vertex has one alpha, whatever triangle it is a corner of.
        let of_vertex: Vec<f32> = model.positions().iter().map(|_| rng.f32()).collect();
        let alphas = model.triangles().iter().map(|t| t.map(|vertex| of_vertex[vertex as usize])).collect();
        Self { model, mesh, alphas }
    }

    fn shader(&self, size: Vec2) -> Sieve<Tube<'_>> {
        let camera = perspective(60.0, size.x / size.y, 0.3, 10.0).unwrap();
        let eye = view(Vec3::new(0.6, 0.3, 0.6), Vec3::new(-0.2, -0.1, 0.0), Vec3::Y).unwrap();
        let uniforms = Uniforms { to_clip: camera * eye, ..Uniforms::new(&self.model) };
        Sieve(Translucent { shader: Lit::new(uniforms, White, Lamp), alpha: 0.8, vertices: &self.alphas })
    }
}

/// As bright as the face's number, so that layers differ.
#[derive(Clone, Copy)]
struct Lamp;

impl shaders::lighting::Lighting for Lamp {
    type Constant = f32;
    type Varying = ();

    fn triangle(&self, _: &Uniforms, face: usize) -> Option<f32> {
        Some(f32::from(Color::random(face as u64).r) / 255.0)
    }

    fn corner(&self, _: &Uniforms, _: usize, _: usize) {}

    fn intensity(&self, constant: f32, (): ()) -> f32 {
        constant
    }
}

/// Through the whole pipeline, perspective, clipping, varyings and dropped fragments: what lesson 11's loop draws, sorted.
#[test]
fn any_shader_is_drawn_in_its_order() {
    let glass = Glass::new();
    let mut image = Image::new(61, 47, Format::Rgb);
    for (x, y, _) in image.clone().pixels() {
        image.set(x, y, Color::random((61 * y + x) as u64));
    }
    let (behind, depths) = (image.clone(), DepthBuffer::new(&image, 1.0));
    let shader = glass.shader(image.size());
    let mut recorder = Recorder::new(&image);
    let counts = render(&shader, &glass.mesh, Cull::None, Clipping::GuardBand, &mut recorder);
    assert!(counts.cut > 5, "{counts:?}");
    let layers: Vec<usize> = recorder.fragments.values().map(Vec::len).collect();
    let deep = layers.iter().filter(|&&count| count > 3).count();
    assert!(layers.len() > 600 && deep > 100, "{} pixels, {deep} deep", layers.len());
    let mut triangles = Vec::new();
    assert_eq!(gather(&shader, &glass.mesh, Cull::None, image.size(), &mut triangles), counts);
    let drawn = |way: Transparency| {
        let mut image = behind.clone();
        way.draw(&triangles, Over(TwoShift), &mut image, &depths);
        image
    };
    let [peeled, listed] = [Transparency::Peeling, Transparency::List].map(drawn);
    for (x, y, below) in behind.pixels() {
        let seen = Some(recorder.seen(x, y, below));
        assert_eq!([peeled.get(x, y), listed.get(x, y)], [seen; 2], "({x}, {y})");
    }
    // Triangles as small as these are nearly in order once they are sorted.
    let off = |way| mean_difference(&drawn(way), &listed, |_, _| true);
    let [unsorted, sorted] = [Transparency::Drawn, Transparency::Sorted].map(off);
    assert!(unsorted > 5.0 && sorted < 0.2 * unsorted, "{unsorted} {sorted}");
}

/// Faces that are culled are not gathered, and what is gathered keeps its order.
#[test]
fn a_list_of_triangles_is_what_the_loop_fills() {
    let glass = Glass::new();
    let shader = glass.shader(Vec2::new(61.0, 47.0));
    for cull in [Cull::None, Cull::Back, Cull::Front] {
        let image = Image::new(61, 47, Format::Rgb);
        let [mut one, mut other] = [(); 2].map(|()| Recorder::new(&image));
        let counts = render(&shader, &glass.mesh, cull, Clipping::GuardBand, &mut one);
        let mut list = Vec::new();
        assert_eq!(gather(&shader, &glass.mesh, cull, image.size(), &mut list), counts);
        assert_eq!(list.len(), counts.filled);
        list.iter().for_each(|triangle| triangle.fill(&mut other));
        assert_eq!(one.fragments, other.fragments);
    }
}

/// What is opaque must come first. After a transparent pane that keeps its depth, what is behind it is missing; after one that
/// does not, it covers the pane.
#[test]
fn opaque_after_transparent_is_wrong_either_way() {
    let far = |color| pane_at(0.6, color);
    let (wall, glass) = (far(Color::GREEN), pane_at(0.4, Color { a: 127, ..Color::RED }));
    let not_kept = DepthTest { function: Compare::Less, write: false };
    let drawn = |opaque_first: bool, keeps: bool| {
        let mut image = Image::new(9, 7, Format::Rgb);
        let mut target = Framebuffer::new(&mut image, State::OFF);
        if opaque_first {
            plain::draw(&[wall], &mut target);
        }
        let test = if keeps { DepthTest { write: true, ..not_kept } } else { not_kept };
        let mut target =
            target.under(State { scissor: (), stencil: (), depth: test, blend: Over(TwoShift), mask: () });
        plain::draw(&[glass], &mut target);
        if !opaque_first {
            plain::draw(&[wall], &mut target.under(State::OFF));
        }
        image.get(4, 3)
    };
    let right = Some(Color::rgb(127, 128, 0));
    assert_eq!([drawn(true, true), drawn(true, false)], [right; 2]);
    assert_eq!([drawn(false, true), drawn(false, false)], [Some(Color::rgb(127, 0, 0)), Some(Color::GREEN)]);
}

/// A triangle over all of a small picture.
fn pane_at(depth: f32, color: Color) -> Surface {
    let corners = [(-9.0, -9.0), (40.0, -9.0), (-9.0, 40.0)].map(|(x, y)| Vec3::new(x, y, depth));
    Surface { corners, color }
}

/// The lesson's crates: the small one shows its front alone, one layer, so that in whatever way it is drawn the picture is the
/// same, and so are the counts.
#[test]
fn one_crate_is_one_layer() {
    let needs = Attributes { normals: true, uvs: true };
    let [cube, wood] = CRATE.map(Path::new);
    let loaded =
        Loaded::new(Model::read(cube, needs).unwrap(), Image::read(wood).unwrap(), Default::default());
    let model = Filterable::new(loaded, *method(MIPMAPS, "box-linear"), Wrap::Repeat);
    let eye = Vec3::new(0.6, 1.2, 3.25);
    let to_clip = perspective(45.0, 1.3, 0.1, 100.0).unwrap() * view(eye, Vec3::ZERO, Vec3::Y).unwrap();
    let view = View { to_clip, eye, light: Default::default() };
    let entities = crates::entities(&model);
    let blank = Image::new(130, 100, Format::Rgb);
    let mut expected = blank.clone();
    let drawn = scene::draw(&entities, &view, Over(TwoShift), &mut expected);
    let alone = scene::draw(&entities[..1], &view, Over(TwoShift), &mut blank.clone());
    for row in TRANSPARENCY {
        let mut image = blank.clone();
        let got = scene::draw_by(row.run, &entities, &view, Cull::Back, Over(TwoShift), &mut image);
        assert!(image == expected, "{}", row.name);
        assert_eq!(got.counts, drawn.counts, "{}", row.name);
        // The glass keeps its depth there, and here the opaque one alone.
        assert_ne!(got.depths, drawn.depths, "{}", row.name);
        assert_eq!(got.depths, alone.depths, "{}", row.name);
    }
    // Its back, too, is seen by those that need no order.
    let all = [Transparency::Drawn, Transparency::Peeling, Transparency::List].map(|way| {
        let mut image = blank.clone();
        scene::draw_by(way, &entities, &view, Cull::None, Over(TwoShift), &mut image);
        image
    });
    assert!(all[1] == all[2] && all[0] != all[2] && all[2] != expected);
}
