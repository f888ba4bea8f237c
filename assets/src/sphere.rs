//! A sphere of latitudes and longitudes.

use std::f64::consts::{PI, TAU};

use glam::{DVec2, DVec3};

use crate::mesh::{Corner, Mesh};

/// The sphere of radius 1, cut into `bands` of latitude and `sectors` of longitude: triangles at the two
/// poles, two triangles to a field elsewhere, 2·`sectors`·(`bands` − 1) in all.
///
/// u goes once around the y axis, eastwards, from the seam at −z; v from the south pole up to the north
/// pole. Normals are the positions. At a pole a triangle's u is that of its middle.
#[must_use]
pub fn sphere(bands: usize, sectors: usize) -> Mesh {
    let south = DVec3::NEG_Y;
    let inner = (1..bands).flat_map(|band| {
        let latitude = PI * (band as f64 / bands as f64 - 0.5);
        (0..sectors).map(move |sector| point(latitude, TAU * sector as f64 / sectors as f64))
    });
    let positions: Vec<DVec3> = [south].into_iter().chain(inner).chain([DVec3::Y]).collect();
    let north = positions.len() - 1;

    let uv_row = sectors + 1;
    let mut uvs: Vec<DVec2> = (0..=bands)
        .flat_map(|band| (0..uv_row).map(move |s| DVec2::new(s as f64, band as f64)))
        .map(|uv| uv / DVec2::new(sectors as f64, bands as f64))
        .collect();
    // One more row for the poles' corners, half a sector to the east.
    let polar = uvs.len();
    for v in [0.0, 1.0] {
        uvs.extend((0..sectors).map(|s| DVec2::new((s as f64 + 0.5) / sectors as f64, v)));
    }

    let on_grid = |band: usize, sector: usize| {
        let position = 1 + (band - 1) * sectors + sector % sectors;
        Corner { position, uv: band * uv_row + sector, normal: position }
    };
    let pole = |position: usize, uv: usize| Corner { position, uv, normal: position };

    let mut triangles = Vec::with_capacity(2 * sectors * (bands - 1));
    for east in 0..sectors {
        triangles.push([on_grid(1, east + 1), on_grid(1, east), pole(0, polar + east)]);
    }
    for band in 1..bands - 1 {
        for west in 0..sectors {
            let [a, b] = [on_grid(band, west), on_grid(band, west + 1)];
            let [d, c] = [on_grid(band + 1, west), on_grid(band + 1, west + 1)];
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    for west in 0..sectors {
        let top = bands - 1;
        triangles.push([on_grid(top, west), on_grid(top, west + 1), pole(north, polar + sectors + west)]);
    }
    Mesh { normals: positions.clone(), positions, uvs, triangles }
}

/// The point of the unit sphere at a latitude and at an angle eastwards from −z, in radians.
fn point(latitude: f64, longitude: f64) -> DVec3 {
    let (sin, cos) = (libm::sin(latitude), libm::cos(latitude));
    DVec3::new(-cos * libm::sin(longitude), sin, -cos * libm::cos(longitude))
}
