//! The sides of triangles instead of what is within them.

use blending::translucent::faded;
use clipping::Cull;
use clipping::clip::{ClipVertex, cut};
use clipping::facing::facing;
use clipping::plane::{PLANES, distance};
use common::{Color, IVec2, Image, Mat4, Vec2, Vec4, Vec4Swizzles};
use lines::{bresenham, wu};
use perspective::window;

use crate::mesh::Mesh;

/// Draws the sides of a mesh's triangles, but of those that are left out for the side that they show, by lesson 1's lines.
pub fn draw(mesh: &Mesh, to_clip: &Mat4, cull: Cull, alpha: f32, smooth: bool, picture: &mut Image) {
    let color = faded(Color::WHITE, alpha);
    let (size, bounds) = (picture.size(), picture.bounds());
    for (_, triangle) in mesh.assembled().triangles() {
        let corners = triangle.map(|vertex| {
            let position = mesh.assembled().vertices[vertex as usize].position;
            *to_clip * mesh.positions()[position as usize].extend(1.0)
        });
        if cull.leaves_out(facing(corners)) {
            continue;
        }
        let [a, b, c] = corners;
        for [from, to] in [[a, b], [b, c], [c, a]].into_iter().filter_map(|side| pixels(side, size)) {
            let plot = |x, y, coverage: u8| {
                picture.blend(x, y, color, (u16::from(coverage) * u16::from(color.a) / 255) as u8);
            };
            if smooth { wu(from, to, bounds, plot) } else { bresenham(from, to, bounds, plot) }
        }
    }
}

/// The pixels at the ends of what can be seen of a side.
fn pixels(mut ends: [Vec4; 2], size: Vec2) -> Option<[IVec2; 2]> {
    for plane in PLANES {
        let distances = ends.map(|end| distance(plane, end));
        let outside = distances.map(|distance| distance < 0.0);
        match outside {
            [true, true] => return None,
            [false, false] => {}
            [first, _] => {
                let vertices = ends.map(|position| ClipVertex { position, varying: () });
                ends[usize::from(!first)] = cut(vertices, distances).position;
            }
        }
    }
    let [from, to] = ends.map(|end| window(end, size));
    let last = size.as_ivec2() - 1;
    let pixel = |end: Vec4| end.xy().floor().as_ivec2().min(last);
    Some([pixel(from?), pixel(to?)])
}
