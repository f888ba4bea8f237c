//! Who has a mesh: the assignment's scene is to destroy its meshes, and several of its entities may point to one.

use std::sync::{Arc, Weak};

use common::{Color, Format, Image};
use filtering::light::SRGB;
use filtering::{Texture, Wrap};
use scene::{Entity, Levels, Mesh, Paint, cube};

use crate::pictures::{cube_of, lit, seen};

/// Three entities of one mesh, in two scenes: it is there as long as one of the scenes is, and gone, once, with the last.
#[test]
fn meshes_are_gone_with_the_last_scene_that_has_them() {
    let cube = cube_of(Color::WHITE);
    let there: Weak<Levels> = Arc::downgrade(&cube);
    let first = lit(vec![Entity::new(cube.clone()), Entity::new(cube.clone())]);
    let second = lit(vec![Entity::new(cube)]);
    assert_eq!(there.strong_count(), 3);
    drop(first);
    assert_eq!(there.strong_count(), 1);
    let _ = seen(&second);
    assert_eq!(there.strong_count(), 1);
    drop(second);
    assert!(there.upgrade().is_none());
}

/// A texture may be on several meshes, and is gone with the last of them.
#[test]
fn textures_are_gone_with_the_last_mesh_that_has_them() {
    let texture = Arc::new(Texture::new(&Image::new(2, 2, Format::Rgb), Wrap::Repeat, &SRGB));
    let there = Arc::downgrade(&texture);
    let mesh = || Levels::one(Mesh::new(&cube(), Paint::Texture(texture.clone())));
    let [first, second] = [mesh(), mesh()].map(|mesh| lit(vec![Entity::new(mesh)]));
    drop(texture);
    drop(first);
    assert_eq!(there.strong_count(), 1);
    drop(second);
    assert!(there.upgrade().is_none());
}
