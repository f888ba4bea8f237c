use std::path::Path;

use common::{Attributes, Image, Model};

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../assets");

#[test]
fn every_asset_is_what_the_code_makes() {
    for asset in assets::ASSETS {
        let committed = std::fs::read(Path::new(FOLDER).join(asset.name)).unwrap_or_default();
        assert!((asset.make)() == committed, "assets/{} is out of date: run cargo run -p assets", asset.name);
    }
}

#[test]
fn the_sphere_is_round_and_whole() {
    let wanted = Attributes { normals: true, uvs: true };
    let sphere = Model::read(&Path::new(FOLDER).join("sphere.obj"), wanted).unwrap();
    assert_eq!((sphere.faces().len(), sphere.skipped()), (5000, None));
    assert!(sphere.positions().iter().all(|p| (p.length() - 1.0).abs() < 1e-4));
    assert!(sphere.face_normals().flatten().all(|n| (n.length() - 1.0).abs() < 1e-4));
    assert!(sphere.face_uvs().flatten().all(|uv| uv.min_element() >= 0.0 && uv.max_element() <= 1.0));
    // Counterclockwise from outside: the normal of each triangle points away from the centre.
    assert!(sphere.faces().all(|[a, b, c]| (b - a).cross(c - a).dot(a + b + c) > 0.0));
}

#[test]
fn the_crate_is_a_picture() {
    let wood = Image::read(&Path::new(FOLDER).join("crate.png")).unwrap();
    assert_eq!((wood.width(), wood.height()), (256, 256));
}
