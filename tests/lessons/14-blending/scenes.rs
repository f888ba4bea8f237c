//! What the lesson's scenes owe to the stencil and to several outputs.

use blending::blend::BlendStage;
use blending::mirror::{self, reflection};
use blending::outputs::Described;
use blending::scene::{Entity, View};
use blending::{Buffers, Framebuffer, Over, State, Transparency, TwoShift, outline, sheet};
use clipping::{Clipping, Cull, render};
use common::{Color, DVec3, Format, Image, Mat4, Vec3};
use fastrand::Rng;
use filtering::scene::Filterable;

use crate::alike::{FLOOR, HEAD, WOOD, crate_view, read, textured};

fn standing(model: &Filterable) -> Entity<'_> {
    Entity { model, to_world: Mat4::IDENTITY, alpha: 1.0 }
}

fn canvas(background: Color) -> Image {
    let mut image = Image::new(150, 150, Format::Rgb);
    image.set_all(|_| background);
    image
}

/// The world as it is.
fn world(entities: &[Entity], view: &View) -> Image {
    let mut image = canvas(Color::BLACK);
    blending::scene::draw(entities, view, (), &mut image);
    image
}

/// One texel through which anything is seen makes an entity transparent.
#[test]
fn an_entity_is_opaque_where_all_its_texels_are() {
    let texture = |alpha| {
        let mut texture = Image::new(8, 8, Format::Rgba);
        texture.set_all(|_| Color::GREEN);
        texture.set(7, 3, Color { a: alpha, ..Color::RED });
        textured(WOOD[0], texture)
    };
    for (alpha, opaque) in [(255, true), (254, false), (0, false)] {
        let model = texture(alpha);
        assert_eq!(standing(&model).is_opaque(), opaque, "{alpha}");
        assert!(!Entity { alpha: 0.99, ..standing(&model) }.is_opaque());
    }
}

/// Behind a texture without alpha all is seen, though it comes first, and its entity's own alpha is 1.
#[test]
fn a_texture_is_seen_through() {
    let mut nothing = Image::new(8, 8, Format::Rgba);
    nothing.set_all(|_| Color { a: 0, ..Color::RED });
    let (nothing, head, view) = (textured(WOOD[0], nothing), read(HEAD), crate_view());
    let entities = [standing(&nothing), standing(&head)];
    let [mut image, mut listed, mut alone] = [(); 3].map(|()| canvas(Color::rgb(40, 90, 160)));
    let over = Over(TwoShift);
    blending::scene::draw(&entities, &view, over, &mut image);
    blending::scene::draw_by(Transparency::List, &entities, &view, Cull::Back, over, &mut listed);
    blending::scene::draw(&entities[1..], &view, over, &mut alone);
    assert!(image == alone && listed == alone);
}

/// Turned over twice a point is where it was; on the way it crosses the plane, straight, and is as far behind as before.
#[test]
fn a_mirror_turns_the_world_over() {
    let mut rng = Rng::with_seed(14);
    let mut any = |size: f32| Vec3::from_array([(); 3].map(|()| (rng.f32() - 0.5) * size));
    for _ in 0..1000 {
        let (point, normal, at) = (any(4.0), any(2.0).normalize(), any(6.0));
        let over = reflection(point, normal);
        let there = over.transform_point3(at);
        assert!(over.transform_point3(there).distance(at) < 1e-5);
        let before = (at - point).dot(normal);
        assert!((before + (there - point).dot(normal)).abs() < 1e-5);
        assert!((there - at).cross(normal).length() < 1e-5);
        assert!((over.determinant() + 1.0).abs() < 1e-5);
    }
}

/// In the pane there is the world turned over, and nowhere else: beside mirror and frame all is as it is without them.
#[test]
fn a_mirror_shows_the_world_in_its_pane_alone() {
    let (models, wood, view) = ([read(HEAD), read(FLOOR)], read(WOOD), crate_view());
    let (mirror, entities) = mirror::scene(&models, &wood);
    let mut image = canvas(Color::BLACK);
    mirror::draw(&mirror, &entities, &view, &mut image);

    // Whose pixels are whose, by pictures of the parts in one colour.
    let covered = |parts: &[Entity]| {
        let mut image = canvas(Color::BLACK);
        let mut target = Framebuffer::new(&mut image, State::OFF);
        for part in parts {
            part.draw_shape(Color::WHITE, 0.0, &view, &mut target);
        }
        image
    };
    let [pane, frame, head] = [covered(&[mirror.pane]), covered(&mirror.frame), covered(&entities[..1])];
    let plain = world(&entities, &view);
    let (mut inside, mut changed) = (0, 0);
    for (x, y, color) in image.pixels() {
        let is = |of: &Image| of.get(x, y) == Some(Color::WHITE);
        if is(&head) || !is(&pane) && !is(&frame) {
            assert_eq!(Some(color), plain.get(x, y), "({x}, {y})");
        } else if is(&pane) && !is(&frame) {
            inside += 1;
            changed += usize::from(Some(color) != plain.get(x, y));
        }
    }
    assert!(inside > 2000 && changed > inside / 2, "{changed} of {inside}");
    // Without a world the pane shows its glass alone.
    let mut empty = canvas(Color::BLACK);
    mirror::draw(&mirror, &[], &view, &mut empty);
    let (mut glass, mut differs) = (0, 0);
    for (x, y, color) in empty.pixels() {
        if pane.get(x, y) == Some(Color::WHITE) && frame.get(x, y) == Some(Color::BLACK) {
            glass += 1;
            assert!(color.r < 20 && color.g < 20, "({x}, {y}): {color:?}");
            differs += usize::from(image.get(x, y) != Some(color));
        }
    }
    assert!(differs > glass / 2, "{differs} of {glass}");
}

/// Each pixel of the light is one ring's colour over what was there: none is drawn to twice, though each ring covers all that
/// is inside of it; and the head is as it is without.
#[test]
fn an_outline_lies_around_the_head_once() {
    let (model, view) = (read(HEAD), crate_view());
    let background = Color::rgb(40, 90, 160);
    let light = Color::rgb(255, 196, 96);
    let [mut image, mut plain] = [canvas(background), canvas(background)];
    let drawn = outline::draw(&standing(&model), &view, light, &mut image);
    blending::scene::draw(&[standing(&model)], &view, (), &mut plain);
    let rings: Vec<Color> = (1..=16_u32)
        .map(|ring| Color { a: (255 * (17 - ring) * (17 - ring) / 256) as u8, ..light })
        .map(|color| Over(TwoShift).color(color, background))
        .collect();
    let mut counts = vec![0; rings.len()];
    for (x, y, color) in image.pixels() {
        if drawn.depths.get(x, y) < 1.0 {
            assert_eq!(Some(color), plain.get(x, y), "({x}, {y}) is the head's");
        } else if color != background {
            let ring = rings.iter().position(|&ring| ring == color);
            counts[ring.unwrap_or_else(|| panic!("({x}, {y}): {color:?}"))] += 1;
        }
    }
    assert!(counts[..8].iter().all(|&count| count > 50), "{counts:?}");
}

/// Of a floor: colours as by themselves, the normal that it has, and the distance that a ray from the eye has to it.
#[test]
fn outputs_are_what_is_seen() {
    let (floor, view) = (read(FLOOR), crate_view());
    let entity = standing(&floor);
    let mut image = canvas(Color::BLACK);
    let size = image.size();
    let mut target = Buffers::new(Framebuffer::new(&mut image, State::OFF));
    let shader =
        Described { shader: entity.shader(&view, size).unwrap(), scene: entity.scene(&view).unwrap() };
    render(&shader, entity.mesh(), Cull::Back, Clipping::GuardBand, &mut target);
    let Buffers { framebuffer, normals, distances } = target;
    assert!(*framebuffer.image == world(&[entity], &view));

    let eye = view.eye.as_dvec3();
    let forward = -eye.normalize();
    let right = forward.cross(DVec3::Y).normalize();
    let up = right.cross(forward);
    let half = (22.5_f64).to_radians().tan();
    let mut seen = 0;
    for (x, y, _) in framebuffer.image.pixels() {
        let at = |n: i32| (f64::from(n) + 0.5) / 75.0 - 1.0;
        let ray = (forward + half * (at(x) * right + at(y) * up)).normalize();
        let (normal, distance) = (normals[(y * 150 + x) as usize], distances.get(x, y));
        if distance.is_infinite() {
            assert_eq!((normal, framebuffer.depths.get(x, y)), (Vec3::ZERO, 1.0));
            continue;
        }
        seen += 1;
        let expected = (-0.996 - eye.y) / ray.y;
        // In f32, between corners that are 128 away.
        assert!((f64::from(distance) / expected - 1.0).abs() < 1e-3, "({x}, {y}): {distance} {expected}");
        assert_eq!(normal, Vec3::Y);
    }
    assert!(seen > 10_000, "{seen}");
}

/// What a hidden surface gave is overwritten in every buffer, and one that comes later and is hidden gives nothing.
#[test]
fn every_buffer_keeps_the_nearest() {
    let (models, view) = ([read(HEAD), read(FLOOR)], crate_view());
    let buffers = |order: [usize; 2]| {
        let mut image = canvas(Color::BLACK);
        let size = image.size();
        let mut target = Buffers::new(Framebuffer::new(&mut image, State::OFF));
        for n in order {
            let entity = standing(&models[n]);
            let shader = Described {
                shader: entity.shader(&view, size).unwrap(),
                scene: entity.scene(&view).unwrap(),
            };
            render(&shader, entity.mesh(), Cull::Back, Clipping::GuardBand, &mut target);
        }
        let Buffers { normals, distances, .. } = target;
        (normals, distances, image)
    };
    let (a, b) = (buffers([0, 1]), buffers([1, 0]));
    assert!(a == b);
    assert!(a.0.iter().any(|&normal| normal != Vec3::Y && normal != Vec3::ZERO));
}

/// The sheet's quarters are colours, normals, distances and what is made of them; a size that is odd, or too small for
/// quarters, is no harm.
#[test]
fn a_sheet_of_any_size() {
    let (models, view) = ([read(HEAD), read(FLOOR)], crate_view());
    let entities = models.each_ref().map(standing);
    for (width, height) in [(0, 0), (1, 1), (2, 2), (3, 1), (61, 40)] {
        let mut image = Image::new(width, height, Format::Rgb);
        let drawn = sheet::draw(&entities, &view, &mut image);
        assert_eq!(
            drawn.depths.bounds().max + 1,
            common::IVec2::new(i32::from(width) / 2, i32::from(height) / 2)
        );
    }
    let mut image = Image::new(100, 100, Format::Rgb);
    sheet::draw(&entities, &view, &mut image);
    // Low in the picture there is the floor: its normal is up, and it is nearer, so lighter, the lower.
    assert_eq!(image.get(99, 52), Some(Color::rgb(128, 255, 128)));
    let grey = |y: i32| image.get(2, y).unwrap();
    assert!((1..25).all(|y| grey(y).r <= grey(y - 1).r && grey(y).r == grey(y).b) && grey(0).r > grey(24).r);
}
