//! Where labels go: next to what they name, over nothing else.

use std::f64::consts::TAU;

/// A rectangle in pixels of a drawing, y down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Rect {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) right: f64,
    pub(crate) bottom: f64,
}

impl Rect {
    /// The rectangle of that size about a point.
    pub(crate) fn about([x, y]: [f64; 2], width: f64, height: f64) -> Self {
        Self {
            left: x - width / 2.0,
            top: y - height / 2.0,
            right: x + width / 2.0,
            bottom: y + height / 2.0,
        }
    }

    /// The rectangle around two points, wider by `margin` on all sides.
    pub(crate) fn around([a, b]: [[f64; 2]; 2], margin: f64) -> Self {
        Self {
            left: a[0].min(b[0]) - margin,
            top: a[1].min(b[1]) - margin,
            right: a[0].max(b[0]) + margin,
            bottom: a[1].max(b[1]) + margin,
        }
    }

    /// Whether two rectangles share more than a border.
    pub(crate) fn overlaps(&self, other: &Self) -> bool {
        self.left < other.right
            && other.left < self.right
            && self.top < other.bottom
            && other.top < self.bottom
    }

    fn within(&self, other: &Self) -> bool {
        self.left >= other.left
            && self.right <= other.right
            && self.top >= other.top
            && self.bottom <= other.bottom
    }

    fn center(&self) -> [f64; 2] {
        [(self.left + self.right) / 2.0, (self.top + self.bottom) / 2.0]
    }

    /// Whether a line from `a` to `b` passes through, looked at in steps of some 2 px.
    fn crossed_by(&self, a: [f64; 2], b: [f64; 2]) -> bool {
        let steps = ((b[0] - a[0]).hypot(b[1] - a[1]) / 2.0).ceil().max(1.0) as u32;
        (0..=steps).any(|n| {
            let t = f64::from(n) / f64::from(steps);
            let [x, y] = [0, 1].map(|i| a[i] + t * (b[i] - a[i]));
            (self.left..self.right).contains(&x) && (self.top..self.bottom).contains(&y)
        })
    }
}

/// A label in its place.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Label {
    /// What it covers.
    pub(crate) place: Rect,
    /// What it names.
    pub(crate) anchor: [f64; 2],
    /// Where a line to what it names begins, if the label is too far away to do without.
    pub(crate) leader: Option<[f64; 2]>,
}

/// Places labels of these sizes next to their anchors, in order: the nearest place that lies in `area` and
/// touches neither another label nor, if that can be, an obstacle or a leader. `None` for one that fits nowhere.
pub(crate) fn place(labels: &[([f64; 2], [f64; 2])], obstacles: &[Rect], area: Rect) -> Vec<Option<Label>> {
    let mut placed: Vec<Option<Label>> = Vec::new();
    for &(anchor, size) in labels {
        let taken: Vec<&Label> = placed.iter().flatten().collect();
        let covers_no_label = |label: &Label| {
            label.place.within(&area) && !taken.iter().any(|other| other.place.overlaps(&label.place))
        };
        let covers_nothing = |label: &Label| {
            covers_no_label(label) && !obstacles.iter().any(|obstacle| obstacle.overlaps(&label.place))
        };
        let crosses = |a: &Label, b: &Label| b.leader.is_some_and(|from| a.place.crossed_by(from, b.anchor));
        let clear = |label: &Label| !taken.iter().any(|other| crosses(label, other) || crosses(other, label));
        let mut places = candidates(anchor, size, area).filter(covers_nothing);
        // Where leaders cannot keep clear of labels, a leader may pass behind one; where all is full of lines, a
        // label may lie on one.
        let anywhere = || candidates(anchor, size, area);
        let found = places.find(clear).or_else(|| anywhere().find(covers_nothing));
        let found = found.or_else(|| anywhere().find(covers_no_label));
        placed.push(found);
    }
    placed
}

/// Places for a label, the best first: beside its anchor, then farther and farther away.
fn candidates(anchor: [f64; 2], size: [f64; 2], area: Rect) -> impl Iterator<Item = Label> {
    /// Beyond this distance a label needs a leader.
    const NEAR: f64 = 14.0;
    (0..40).flat_map(move |ring| {
        let distance = 10.0 + 7.0 * f64::from(ring);
        // To the right first, then the left, then ever steeper ones.
        const ANGLES: [f64; 12] = [0.0, 6.0, 1.0, 11.0, 5.0, 7.0, 2.0, 10.0, 4.0, 8.0, 3.0, 9.0];
        ANGLES.map(|twelfth| {
            let (sin, cos) = (twelfth / 12.0 * TAU).sin_cos();
            let at = [
                anchor[0] + cos * distance + cos.signum() * size[0] / 2.0 * (2.0 * cos.abs()).min(1.0),
                anchor[1] - sin * (distance + size[1] / 2.0),
            ];
            // A long label beside a border is shifted along the line above or below its anchor.
            let half = size[0] / 2.0;
            let x = if sin.abs() < 0.7 { at[0] } else { at[0].max(area.left + half).min(area.right - half) };
            let place = Rect::about([x, at[1]], size[0], size[1]);
            let nearest = [
                anchor[0].clamp(place.left, place.right),
                if anchor[0] < place.left || anchor[0] > place.right {
                    place.center()[1]
                } else {
                    anchor[1].clamp(place.top, place.bottom)
                },
            ];
            Label { place, anchor, leader: (distance > NEAR).then_some(nearest) }
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const AREA: Rect = Rect { left: 0.0, top: 0.0, right: 600.0, bottom: 400.0 };

    #[test]
    fn labels_of_one_point_all_find_a_place_of_their_own() {
        let labels = [([300.0, 200.0], [90.0, 16.0]); 12];
        let marks = [Rect::about([300.0, 200.0], 14.0, 14.0)];
        let placed: Vec<Label> = place(&labels, &marks, AREA).into_iter().flatten().collect();
        assert_eq!(placed.len(), 12);
        for (n, label) in placed.iter().enumerate() {
            assert!(label.place.within(&AREA) && !label.place.overlaps(&marks[0]));
            assert!(!placed[..n].iter().any(|other| other.place.overlaps(&label.place)));
        }
    }

    #[test]
    fn the_first_choice_is_to_the_right_and_needs_no_leader() {
        let placed = place(&[([100.0, 100.0], [40.0, 10.0])], &[], AREA);
        let label = placed[0].as_ref().unwrap();
        assert_eq!((label.place.left, label.place.center()[1], label.leader), (110.0, 100.0, None));
    }

    #[test]
    fn what_does_not_fit_is_not_placed() {
        assert_eq!(place(&[([5.0, 5.0], [900.0, 10.0])], &[], AREA), [None]);
    }
}
