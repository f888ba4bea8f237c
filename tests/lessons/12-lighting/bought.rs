//! What a map of normals buys: heads of few triangles with one, against the head of very many.

use assets::head;
use checks::picture::{distance, mean_difference};
use clipping::Cull;
use clipping::mesh::indexed;
use common::{Color, Format, Image, Mat4, Model, Vec3};
use lighting::{LOOKS, Maps, PointLight, Scene};
use perspective::scene::Loaded;
use perspective::{perspective, view};
use textures::Wrap;
use verify::method;

use crate::stage::BOTH;

/// Width and height of the pictures.
const SIDE: u16 = 400;

/// A head and where it is drawn.
struct Drawn {
    image: Image,
    covered: Vec<bool>,
}

/// The white head under the program's light, before the program's eye.
fn drawn(mesh: &assets::mesh::Mesh, look: &str, normals: Option<Image>) -> Drawn {
    let mut white = Image::new(1, 1, Format::Rgb);
    white.set(0, 0, Color::WHITE);
    let model = Model::parse(mesh.to_obj().as_bytes(), BOTH).unwrap();
    let loaded = Loaded::new(model, white, Wrap::Clamp);
    let mesh = indexed(&loaded.model, &loaded.normals, BOTH);
    let eye = Vec3::new(0.55, 0.35, 2.35);
    let look_at = view(eye, Vec3::new(0.0, 0.12, 0.0), Vec3::Y).unwrap();
    let camera = perspective(45.0, 1.0, 0.1, 100.0).unwrap() * look_at;
    let scene = Scene::placed(&loaded, Mat4::IDENTITY, camera, eye, PointLight::default()).unwrap();
    let maps = normals.map_or_else(Maps::default, |normals| Maps { normals, ..Maps::default() });
    let mut image = Image::new(SIDE, SIDE, Format::Rgb);
    let drawn = (method(LOOKS, look).draw)(&scene, &maps, &mesh, Cull::Back, &mut image);
    let covered = image.pixels().map(|(x, y, _)| drawn.depths.get(x, y) < 1.0).collect();
    Drawn { image, covered }
}

/// The mean difference of what both show, from a row on up, in grey levels.
fn off(got: &Drawn, right: &Drawn, from: i32) -> f64 {
    let both = |x: i32, y: i32| {
        let at = y as usize * usize::from(SIDE) + x as usize;
        y >= from && got.covered[at] && right.covered[at]
    };
    mean_difference(&got.image, &right.image, both)
}

/// Where the chin is.
const CHIN: i32 = 70;

/// Where the maps in the two spaces do not agree. The frames of two triangles differ where these meet, and a texel on their side is
/// in the frame of one: pixels of the other, with that texel, are off by as much as the frames are apart. And where two surfaces
/// have one patch, as a lid's two sides have, one of them has the other's normal in object space.
fn specks(object: &Drawn, tangent: &Drawn) -> usize {
    let both = object.image.pixels().zip(tangent.image.pixels());
    both.filter(|((.., a), (.., b))| distance(*a, *b) > 25).count()
}

/// Maps without relief, since no mesh has it. (Of the error that is left most is on the shoulders: where a triangle is large, what
/// the atlas bends the map cannot follow, and a fold is found beside its place.)
///
/// Of each head the means are of all that both show, and of what is above the chin: plain, with the map in object space, and with
/// that in tangent space.
#[test]
fn a_map_of_normals_buys_triangles() {
    let fine = head::model_of(22_400);
    assert_eq!(fine.triangles.len(), 22_688);
    let right = drawn(&fine, "plain", None);
    let normals = head::fine_normals(0.0);
    let object = head::normal_map(&normals);
    let low = (head::low_model(), head::low_tangent_map(&normals));
    let usual = (head::model(), head::tangent_map(&normals));
    for ((mesh, tangents), expected, specked) in [
        (low, [[17.9, 15.3], [11.0, 6.98], [11.1, 7.07]], 70..=100),
        (usual, [[3.15, 2.22], [1.78, 1.56], [1.48, 1.19]], 200..=260),
    ] {
        let maps =
            [("plain", None), ("object-normals", Some(object.clone())), ("tangent-normals", Some(tangents))];
        let heads = maps.map(|(look, map)| drawn(&mesh, look, map));
        let errors = heads.each_ref().map(|head| [0, CHIN].map(|from| off(head, &right, from)));
        let specks = specks(&heads[1], &heads[2]);
        println!("{} triangles: {errors:.2?}, {specks} specks", mesh.triangles.len());
        let near = |(off, expected): (&f64, &f64)| (off / expected - 1.0).abs() < 0.03;
        assert!(errors.as_flattened().iter().zip(expected.as_flattened()).all(near), "{errors:?}");
        assert!(specked.contains(&specks), "{specks}");
    }
}
