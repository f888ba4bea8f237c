use std::collections::BTreeMap;
use std::path::Path;

use common::{Attributes, Color, DVec3, Image, Model, Vec3};

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../assets");

#[test]
fn every_asset_is_what_the_code_makes() {
    for asset in assets::ASSETS {
        let committed = std::fs::read(Path::new(FOLDER).join(asset.name)).unwrap_or_default();
        assert!((asset.make)() == committed, "assets/{} is out of date: run cargo run -p assets", asset.name);
    }
}

/// What a lesson relies on, for every model; `second_reader.py` checks the same with code that is not ours.
#[test]
fn every_model_is_closed_and_turned_outwards() {
    for (name, triangles, bodies) in [
        ("sphere.obj", 5000..=5000, 1),
        ("cube.obj", 12..=12, 1),
        ("torus-knot.obj", 5760..=5760, 1),
        // The bust and two eyeballs.
        ("head.obj", 2500..=6000, 3),
        ("head-low.obj", 638..=638, 3),
    ] {
        let model = read(name);
        assert!(triangles.contains(&model.faces().len()), "{name}: {} triangles", model.faces().len());
        assert_eq!(model.skipped(), None, "{name}");
        assert!(model.positions().iter().all(|p| p.abs().max_element() <= 1.0), "{name}");
        assert_eq!(model.face_normals().len(), model.faces().len(), "{name}");
        assert_eq!(model.face_uvs().len(), model.faces().len(), "{name}");
        assert!(model.face_normals().flatten().all(|n| (n.length() - 1.0).abs() < 1e-3), "{name}");
        assert!(
            model.face_uvs().flatten().all(|uv| uv.min_element() >= 0.0 && uv.max_element() <= 1.0),
            "{name}"
        );
        for (corners, [n, m, o]) in model.faces().zip(model.face_normals()) {
            let cross = cross(corners);
            assert!(cross.length() > 0.0, "{name}: {corners:?} has no area");
            assert!(cross.dot(n + m + o) > 0.0, "{name}: {corners:?} faces away from its normals");
        }
        assert_closed(name, &model);
        assert_eq!(volumes(&model).len(), bodies, "{name}");
        assert!(volumes(&model).into_iter().all(|volume| volume > 0.0), "{name} is inside out");
    }
}

/// A closed surface has each edge twice, once in each direction; and no face uses a corner twice.
fn assert_closed(name: &str, model: &Model) {
    let mut edges = BTreeMap::new();
    for &[a, b, c] in model.triangles() {
        assert!(a != b && b != c && c != a, "{name}: a face uses a corner twice");
        for edge in [[a, b], [b, c], [c, a]] {
            *edges.entry(edge).or_insert(0) += 1;
        }
    }
    for (&[a, b], &count) in &edges {
        assert_eq!((count, edges.get(&[b, a])), (1, Some(&1)), "{name}: edge {a} {b}");
    }
}

/// The volume of each body: triangles that share corners, seen as tetrahedra from the origin.
fn volumes(model: &Model) -> Vec<f32> {
    let mut body: Vec<usize> = (0..model.positions().len()).collect();
    let root = |body: &[usize], mut i: usize| {
        while body[i] != i {
            i = body[i];
        }
        i
    };
    for triangle in model.triangles() {
        let roots = triangle.map(|i| root(&body, i as usize));
        roots.iter().for_each(|&i| body[i] = roots[0]);
    }
    let mut volumes = BTreeMap::new();
    for (triangle, [a, b, c]) in model.triangles().iter().zip(model.faces()) {
        *volumes.entry(root(&body, triangle[0] as usize)).or_insert(0.0) += a.cross(b).dot(c) / 6.0;
    }
    volumes.into_values().collect()
}

fn cross([a, b, c]: [Vec3; 3]) -> Vec3 {
    (b - a).cross(c - a)
}

fn read(name: &str) -> Model {
    Model::read(&Path::new(FOLDER).join(name), Attributes { normals: true, uvs: true }).unwrap()
}

#[test]
fn the_sphere_is_round() {
    let sphere = read("sphere.obj");
    assert!(sphere.positions().iter().all(|p| (p.length() - 1.0).abs() < 1e-4));
    // Counterclockwise from outside: the normal of each triangle points away from the centre.
    assert!(sphere.faces().all(|corners| cross(corners).dot(corners[0] + corners[1] + corners[2]) > 0.0));
}

/// The base of the bust is a plane: its rim does not waver.
#[test]
fn the_head_stands_on_a_plane() {
    let head = read("head.obj");
    let lowest = head.positions().iter().map(|p| p.y).fold(f32::INFINITY, f32::min);
    let base = head.faces().filter(|corners| corners.iter().all(|p| p.y == lowest));
    assert!(base.map(|corners| cross(corners).length() / 2.0).sum::<f32>() > 0.5);
}

/// The floor faces up, without a gap, and reaches to 128 on each side; the head's base lies on it, a hair above, so that
/// the two are never equally far.
#[test]
fn the_floor_lies_under_the_head() {
    let floor = read("floor.obj");
    let level = floor.positions()[0].y;
    assert!(floor.positions().iter().all(|p| p.y == level));
    let areas: Vec<f32> = floor.faces().map(|corners| cross(corners).y / 2.0).collect();
    assert!(areas.iter().all(|&area| area > 0.0));
    assert_eq!((areas.iter().sum::<f32>(), floor.reach()), (256.0 * 256.0, 128.0));
    let lowest = read("head.obj").positions().iter().map(|p| p.y).fold(f32::INFINITY, f32::min);
    assert!((1e-4..1e-3).contains(&(lowest - level)), "{lowest} {level}");
    // Four texels of the checks to a unit of floor.
    for (corners, uvs) in floor.faces().zip(floor.face_uvs()) {
        assert!(corners.iter().zip(uvs).all(|(p, uv)| (uv.x, uv.y) == (p.x, -p.z)));
    }
}

#[test]
fn files_are_small() {
    let maps = ["head-normals.png", "head-tangents.png", "head-low-tangents.png", "head-shine.png"];
    for (names, limit) in [(&["head.obj"][..], 600_000), (&["head.tga"], 3_000_000), (&maps, 2_700_000)] {
        let size = |name: &&str| std::fs::metadata(Path::new(FOLDER).join(name)).unwrap().len();
        let size: u64 = names.iter().map(size).sum();
        assert!(size <= limit, "{names:?}: {size} bytes");
    }
}

#[test]
fn the_textures_are_pictures() {
    for (name, size) in [
        ("crate.png", (256, 256)),
        ("head.tga", (1024, 1024)),
        ("checks.png", (2, 2)),
        ("head-normals.png", (1024, 1024)),
        ("head-tangents.png", (1024, 1024)),
        ("head-low-tangents.png", (1024, 1024)),
        ("head-shine.png", (512, 512)),
    ] {
        let picture = Image::read(&Path::new(FOLDER).join(name)).unwrap();
        assert_eq!((picture.width(), picture.height()), size, "{name}");
    }
}

/// Between the patches of the head's texture nothing is left black, and a smaller copy of it has no dark seams.
#[test]
fn the_head_s_texture_is_padded() {
    let texture = Image::read(&Path::new(FOLDER).join("head.tga")).unwrap();
    assert_eq!(texture.pixels().find(|(.., color)| *color == Color::BLACK), None);
}

/// A texel of a map of normals is a direction: 1 long but for the rounding to 8 bits.
#[test]
fn the_maps_of_normals_hold_unit_vectors() {
    for name in ["head-normals.png", "head-tangents.png", "head-low-tangents.png"] {
        let map = Image::read(&Path::new(FOLDER).join(name)).unwrap();
        let channel = |code: u8| (f32::from(code) - 128.0) / 127.0;
        for (x, y, Color { r, g, b, .. }) in map.pixels() {
            let length = Vec3::new(channel(r), channel(g), channel(b)).length();
            assert!((0.99..1.01).contains(&length), "{name} ({x}, {y}): {length}");
        }
    }
}

/// What 8 bits a channel cost of a direction.
#[test]
fn a_texel_is_off_by_four_tenths_of_a_degree_at_most() {
    let (mut sum, mut most, count) = (0.0, 0.0_f64, 100_000);
    for n in 0..count {
        // Points of a spiral, evenly over the sphere (Vogel 1979).
        let z = 1.0 - (2.0 * f64::from(n) + 1.0) / f64::from(count);
        let around = 2.399_963_229_728_653 * f64::from(n);
        let flat = (1.0 - z * z).sqrt();
        let normal = DVec3::new(flat * around.cos(), flat * around.sin(), z);
        let Color { r, g, b, .. } = assets::head::normals::encoded(normal);
        let channel = |code: u8| (f64::from(code) - 128.0) / 127.0;
        let off = normal.angle_between(DVec3::new(channel(r), channel(g), channel(b))).to_degrees();
        sum += off;
        most = most.max(off);
    }
    // Half a step along each channel at most: 0.5·√3/127, which is 0.39°.
    let mean = sum / f64::from(count);
    assert!((0.16..0.18).contains(&mean) && (0.36..0.391).contains(&most), "mean {mean}, most {most}");
}
