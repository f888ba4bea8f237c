//! A lit model under a camera, in `f64`: each point of the picture by itself.
//!
//! The surface is smooth: normals are interpolated and made 1 long before the brightness is computed, and
//! everything is interpolated on the surface, not in the picture.

use common::{Color, DVec3, Image, Vec2, Vec3};

use crate::view::seen;

/// A triangle in space with what lies on it.
#[derive(Clone, Copy, Debug)]
pub struct Face {
    /// Its corners.
    pub corners: [Vec3; 3],
    /// The unit normals there.
    pub normals: [Vec3; 3],
    /// The texture coordinates there, v up.
    pub uvs: [Vec2; 3],
}

/// What is looked at, and how.
pub struct Subject<'a> {
    /// The triangles.
    pub faces: Vec<Face>,
    /// The texture; without one all is white.
    pub texture: Option<&'a Image>,
    /// Unit vector to the light.
    pub light: DVec3,
    /// Where the eye is.
    pub eye: Vec3,
    /// Where it looks, the middle of the picture.
    pub center: Vec3,
    /// What is up in the picture.
    pub up: Vec3,
    /// What of the picture's side a length of 1 takes up.
    pub zoom: f64,
    /// What is made of a brightness from 0 to 1.
    pub tone: fn(f64) -> f64,
}

/// A corner in the picture.
#[derive(Clone, Copy)]
struct Corner {
    /// In pixels.
    at: [f64; 2],
    /// Larger is nearer.
    depth: f64,
    /// What the perspective divides by.
    w: f64,
}

/// The picture of it, `side`×`side` pixels in rows from the bottom, as red, green and blue from 0 to 255.
/// Each is the mean of `samples`×`samples` points, evenly spread over the pixel. Black where nothing is seen:
/// what faces away from the light is left out, and so are triangles with a corner at w ≤ 1e-6.
#[must_use]
pub fn sampled(subject: &Subject, side: usize, samples: usize) -> Vec<[f64; 3]> {
    let distance = (subject.eye.as_dvec3() - subject.center.as_dvec3()).length();
    let place = |point: Vec3| {
        let p = seen(point.as_dvec3(), subject.eye, subject.center, subject.up);
        let w = 1.0 - p.z / distance;
        let pixel = |coordinate: f64| side as f64 * (0.5 + subject.zoom * coordinate / w);
        Corner { at: [pixel(p.x), pixel(p.y)], depth: p.z / w, w }
    };
    let placed: Vec<(&Face, [Corner; 3])> = subject
        .faces
        .iter()
        .map(|face| (face, face.corners.map(place)))
        .filter(|(_, corners)| corners.iter().all(|corner| corner.w > 1e-6))
        .collect();
    // The triangles that reach into each row of pixels.
    let mut rows: Vec<Vec<usize>> = vec![Vec::new(); side];
    for (n, (_, corners)) in placed.iter().enumerate() {
        let [low, high] = span(corners, 1);
        let last = (high.floor() as usize).min(side.saturating_sub(1));
        if high >= 0.0 {
            rows.iter_mut().take(last + 1).skip(low.max(0.0) as usize).for_each(|row| row.push(n));
        }
    }
    let points = side * samples;
    let mut picture = Vec::with_capacity(side * side);
    for (row, faces) in rows.iter().enumerate() {
        let mut nearest = vec![(f64::NEG_INFINITY, [0.0; 3]); points * samples];
        for &n in faces {
            for line in 0..samples {
                let y = row as f64 + (line as f64 + 0.5) / samples as f64;
                let seen = &mut nearest[line * points..][..points];
                draw_line(subject, placed[n].0, &placed[n].1, y, samples as f64, seen);
            }
        }
        for column in 0..side {
            let pixel = (0..samples).flat_map(|line| &nearest[line * points + column * samples..][..samples]);
            let sum = pixel.fold([0.0; 3], |sum, (_, color)| [0, 1, 2].map(|c| sum[c] + color[c]));
            picture.push(sum.map(|channel| channel / (samples * samples) as f64));
        }
    }
    picture
}

/// The least and the largest coordinate of three corners.
fn span(corners: &[Corner; 3], axis: usize) -> [f64; 2] {
    let all = corners.map(|corner| corner.at[axis]);
    [all.into_iter().fold(f64::INFINITY, f64::min), all.into_iter().fold(f64::NEG_INFINITY, f64::max)]
}

/// Draws what of a triangle lies at the height y, `density` points a pixel.
fn draw_line(
    subject: &Subject,
    face: &Face,
    corners: &[Corner; 3],
    y: f64,
    density: f64,
    seen: &mut [(f64, [f64; 3])],
) {
    let [a, b, c] = corners.map(|corner| corner.at);
    let cross =
        |o: [f64; 2], p: [f64; 2], q: [f64; 2]| (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0]);
    let area = cross(a, b, c);
    let [left, right] = span(corners, 0);
    let first = (left * density - 0.5).ceil().max(0.0) as usize;
    let last = (right * density - 0.5).floor().min(seen.len() as f64 - 1.0);
    if area == 0.0 || last < 0.0 {
        return;
    }
    for (n, nearest) in seen.iter_mut().enumerate().take(last as usize + 1).skip(first) {
        let p = [(n as f64 + 0.5) / density, y];
        let weights = [cross(p, b, c) / area, cross(a, p, c) / area, cross(a, b, p) / area];
        if weights.iter().any(|&weight| weight < 0.0) {
            continue;
        }
        let depth = (0..3).map(|i| weights[i] * corners[i].depth).sum();
        if depth > nearest.0
            && let Some(color) = color(subject, face, [0, 1, 2].map(|i| weights[i] / corners[i].w))
        {
            *nearest = (depth, color);
        }
    }
}

/// The colour of a point of a triangle by its weights, which need not add up to 1; `None` in the dark.
fn color(subject: &Subject, face: &Face, weights: [f64; 3]) -> Option<[f64; 3]> {
    let sum: f64 = weights.iter().sum();
    let normal: DVec3 = (0..3).map(|i| face.normals[i].as_dvec3() * weights[i]).sum();
    let intensity = normal.normalize().dot(subject.light);
    if intensity < 0.0 {
        return None;
    }
    let white = [255.0; 3];
    let base = subject.texture.map_or(white, |texture| {
        let coordinate = |of: fn(Vec2) -> f32, size: i32| {
            let mean: f64 = (0..3).map(|i| f64::from(of(face.uvs[i])) * weights[i] / sum).sum();
            ((mean * f64::from(size)).floor() as i32).clamp(0, size - 1)
        };
        let texel =
            texture.get(coordinate(|uv| uv.x, texture.width()), coordinate(|uv| uv.y, texture.height()));
        let Color { r, g, b, .. } = texel.unwrap_or(Color::BLACK);
        [r, g, b].map(f64::from)
    });
    let tone = (subject.tone)(intensity.min(1.0));
    Some(base.map(|channel| channel * tone))
}

#[cfg(test)]
mod tests {
    use super::*;
    use common::Format;

    fn square(texture: Option<&Image>) -> Subject<'_> {
        let [a, b, c, d] = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(Vec2::from);
        let face = |corners: [Vec2; 3]| Face {
            corners: corners.map(|corner| corner.extend(0.0)),
            normals: [Vec3::Z; 3],
            uvs: corners.map(|corner| corner / 2.0 + 0.5),
        };
        Subject {
            faces: vec![face([a, b, c]), face([a, c, d])],
            texture,
            light: DVec3::new(0.0, 0.6, 0.8),
            eye: Vec3::Z * 3.0,
            center: Vec3::ZERO,
            up: Vec3::Y,
            zoom: 0.25,
            tone: |intensity| intensity,
        }
    }

    #[test]
    fn a_square_is_as_large_and_as_bright_as_it_should_be() {
        let picture = sampled(&square(None), 8, 2);
        for (n, pixel) in picture.iter().enumerate() {
            let inside = (2..6).contains(&(n % 8)) && (2..6).contains(&(n / 8));
            let expected = if inside { 255.0 * 0.8 } else { 0.0 };
            assert!(pixel.iter().all(|channel| (channel - expected).abs() < 1e-5), "{n}: {pixel:?}");
        }
    }

    #[test]
    fn half_a_pixel_is_half_as_bright() {
        // The square takes up 5/2 of 5 pixels: the outermost ones by 3/4 in one direction.
        let picture = sampled(&square(None), 5, 4);
        let row: Vec<f64> = (0..5).map(|x| picture[2 * 5 + x][0] / 255.0 / 0.8).collect();
        for (got, expected) in row.iter().zip([0.0, 0.75, 1.0, 0.75, 0.0]) {
            assert!((got - expected).abs() < 1e-6, "{row:?}");
        }
    }

    #[test]
    fn a_texture_is_seen_in_perspective() {
        // Two columns, black and white. Seen from the right, the middle of the square stays in the middle.
        let mut texture = Image::new(2, 1, Format::Rgb);
        texture.set(1, 0, Color::WHITE);
        let subject = Subject { eye: Vec3::new(1.5, 0.0, 2.0), light: DVec3::Z, ..square(Some(&texture)) };
        let picture = sampled(&subject, 64, 1);
        let row = |x: usize| picture[32 * 64 + x][0];
        assert!(row(31) == 0.0 && (row(32) - 255.0).abs() < 1e-9);
    }
}
