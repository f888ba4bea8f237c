//! A list of all layers in each pixel.
//!
//! L. Carpenter's A-buffer keeps a list of fragments for each pixel and sorts it at the end (*The A-buffer, an antialiased
//! hidden surface method*, SIGGRAPH 1984). As graphics hardware does it (J. C. Yang, J. Hensley, H. Grün and N. Thibieroz,
//! *Real-time concurrent linked list construction on the GPU*, Computer Graphics Forum 29, 2010), all fragments are in one
//! array as they come, each with the place of the one before it in its pixel.

use common::{Bounds, Color, Image};
use shaders::target::Target;
use zbuffer::DepthBuffer;

use super::Fill;
use super::drawn::lay;
use crate::blend::BlendStage;

// ANCHOR: list
/// Keeps all fragments, then lays each pixel's over the picture, from far to near; of equal depths in the order in which they
/// were drawn.
pub(super) fn draw(
    transparent: &[impl Fill],
    blend: impl BlendStage,
    image: &mut Image,
    depths: &DepthBuffer<f32>,
) {
    let last = vec![NONE; image.width() as usize * image.height() as usize];
    let mut lists = Lists { depths, last, fragments: Vec::new() };
    transparent.iter().for_each(|triangle| triangle.fill(&mut lists));
    let columns = 0..image.width();
    let pixels = (0..image.height()).flat_map(|y| columns.clone().map(move |x| (x, y)));
    let mut layers: Vec<u32> = Vec::new();
    for ((x, y), &last) in pixels.zip(&lists.last) {
        layers.clear();
        let mut next = last;
        while next != NONE {
            layers.push(next);
            next = lists.fragments[next as usize].before;
        }
        let fragment = |n: u32| &lists.fragments[n as usize];
        layers.sort_unstable_by(|&a, &b| fragment(b).depth.total_cmp(&fragment(a).depth).then(a.cmp(&b)));
        layers.iter().for_each(|&layer| lay(fragment(layer).color, blend, image, x, y));
    }
}

/// A fragment as it is kept: 12 bytes.
struct Kept {
    depth: f32,
    color: Color,
    /// The fragment before it in its pixel, or `NONE`.
    before: u32,
}

const NONE: u32 = u32::MAX;

/// What is in front of the opaque picture.
struct Lists<'a> {
    depths: &'a DepthBuffer<f32>,
    /// The last fragment of each pixel, rows from the bottom.
    last: Vec<u32>,
    fragments: Vec<Kept>,
}

impl Target<Color> for Lists<'_> {
    fn bounds(&self) -> Bounds {
        self.depths.bounds()
    }

    #[inline]
    fn test(&mut self, x: i32, y: i32, depth: f32) -> bool {
        depth < self.depths.get(x, y)
    }

    /// # Panics
    /// With more than 2³² − 1 fragments.
    #[inline]
    fn write(&mut self, x: i32, y: i32, depth: f32, color: Color) {
        let width = self.depths.bounds().max.x as usize + 1;
        let last = &mut self.last[y as usize * width + x as usize];
        let number = u32::try_from(self.fragments.len()).ok().filter(|&number| number != NONE);
        self.fragments.push(Kept { depth, color, before: *last });
        *last = number.expect("fewer than 2³² fragments");
    }

    fn clear(&mut self) {
        self.last.fill(NONE);
        self.fragments.clear();
    }
}
// ANCHOR_END: list

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fragment_takes_as_much_as_the_table_says() {
        assert_eq!(size_of::<Kept>(), 12);
    }

    #[test]
    fn what_is_cleared_is_forgotten() {
        let image = Image::new(2, 3, common::Format::Rgb);
        let depths = DepthBuffer::new(&image, 1.0);
        let mut lists = Lists { depths: &depths, last: vec![NONE; 6], fragments: Vec::new() };
        [0.5, 0.25].into_iter().for_each(|depth| lists.write(1, 2, depth, Color::RED));
        assert_eq!((lists.last[5], lists.fragments.len(), lists.fragments[1].before), (1, 2, 0));
        lists.clear();
        assert!(lists.last == [NONE; 6] && lists.fragments.is_empty());
    }
}
