//! The matrix of a true camera: from eye space to clip space.
//!
//! What a camera sees is a pyramid without its top, the frustum, between a near plane at depth n before the eye and
//! a far one at f. A point of eye space is projected onto the near plane by similar triangles; l, r, b and t are the
//! sides of the picture there. Four rows bring the frustum to −w ≤ x, y, z ≤ w with w = −z, the depth before the eye
//! (notes, I.1, *From eye space to clip space*):
//!
//! ```text
//! | 2n/(r−l)     0       (r+l)/(r−l)       0      |
//! |    0      2n/(t−b)   (t+b)/(t−b)       0      |
//! |    0         0      −(f+n)/(f−n)  −2fn/(f−n)  |
//! |    0         0           −1            0      |
//! ```
//!
//! **f → ∞.** Divided by f above and below, the third row is −(1+k)/(1−k) and −2n/(1−k) with k = n/f, which has a
//! limit: −1 and −2n. So an infinite far plane is no special case, but k = 0.
//!
//! **n → 0.** The third row tends to −1 and 0, whatever f is, and so to the fourth: z = w, every depth is 1, and no
//! surface is before another. The other rows have a limit where the picture's sides grow with n, as a field of view
//! lets them: [`perspective`] then draws right what needs no depth from z, and a depth buffer that holds w keeps
//! working. Where l, r, b and t are given, everything seen shrinks to a point: [`frustum`] refuses n = 0.

use common::{Mat4, Vec4};

/// The depths before the eye of the planes between which there is something to be seen, in the world's units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Planes {
    /// Of the near one.
    pub near: f32,
    /// Of the far one, which may be infinite.
    pub far: f32,
}

/// Why there is no such camera.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum FrustumError {
    /// The near plane is at the eye or behind it, or nowhere.
    #[error("the near plane is at {0}: it must lie before the eye, at more than 0")]
    Near(f32),
    /// The far plane is not behind the near one.
    #[error("the far plane is at {far}: it must lie behind the near one, which is at {near}")]
    Far {
        /// Where the near plane is.
        near: f32,
        /// Where the far plane is.
        far: f32,
    },
    /// The picture has no width or height, or is not finite.
    #[error("the picture reaches from {0} to {1} on the near plane: it needs two different finite ends")]
    Sides(f32, f32),
    /// The field of view is no angle that a plane picture can show.
    #[error("the field of view is {0} degrees: it must be more than 0 and less than 180")]
    FieldOfView(f32),
    /// The picture's width over its height is not a positive finite number.
    #[error("the picture is {0} times as wide as it is high: that must be a finite number above 0")]
    Aspect(f32),
    /// Some entry is no `f32`.
    #[error("the matrix has an entry too large for 32 bits")]
    TooLarge,
}

// ANCHOR: frustum
/// From eye space to clip space: the camera whose picture has its left, right, bottom and top sides at `l`, `r`, `b`
/// and `t` on the near plane, at depth `n`; the far plane is at `f`, which may be infinite. With `l` > `r` the picture
/// is mirrored.
///
/// Entries are computed in `f64` and rounded once.
///
/// # Errors
/// Where a side is not finite or `l` = `r` or `b` = `t`; where not 0 < `n` < `f`; where an entry is too large.
pub fn frustum(l: f32, r: f32, b: f32, t: f32, n: f32, f: f32) -> Result<Mat4, FrustumError> {
    if n == 0.0 {
        return Err(FrustumError::Near(n));
    }
    for (low, high) in [(l, r), (b, t)] {
        if low == high || !low.is_finite() || !high.is_finite() {
            return Err(FrustumError::Sides(low, high));
        }
    }
    let [l, r, b, t] = [l, r, b, t].map(f64::from);
    let twice_near = 2.0 * f64::from(n);
    let x = [twice_near / (r - l), (r + l) / (r - l)];
    let y = [twice_near / (t - b), (t + b) / (t - b)];
    from_rows(x, y, Planes { near: n, far: f })
}
// ANCHOR_END: frustum

// ANCHOR: perspective
/// The camera that looks straight ahead and sees `fov` degrees from the bottom to the top of a picture `aspect` times
/// as wide as it is high; the near plane is at depth `n`, the far one at `f`, which may be infinite.
///
/// The near plane's t is n·tan(fov/2), so that n cancels in 2n/(t − b) = 1/tan(fov/2): for `n` = 0 this is the limit,
/// in which every depth is 1.
///
/// # Errors
/// Where not 0 < `fov` < 180, not 0 ≤ `n` < `f`, `aspect` is not finite and above 0, or an entry is too large.
pub fn perspective(fov: f32, aspect: f32, n: f32, f: f32) -> Result<Mat4, FrustumError> {
    if !(fov > 0.0 && fov < 180.0) {
        return Err(FrustumError::FieldOfView(fov));
    }
    if !(aspect > 0.0 && aspect.is_finite()) {
        return Err(FrustumError::Aspect(aspect));
    }
    let scale = 1.0 / (f64::from(fov).to_radians() / 2.0).tan();
    from_rows([scale / f64::from(aspect), 0.0], [scale, 0.0], Planes { near: n, far: f })
}
// ANCHOR_END: perspective

// ANCHOR: rows
/// The matrix whose first two rows have these entries, at the corner's own axis and at z.
fn from_rows([x, x_by_z]: [f64; 2], [y, y_by_z]: [f64; 2], planes: Planes) -> Result<Mat4, FrustumError> {
    let Planes { near, far } = planes;
    if !(near >= 0.0 && near.is_finite()) {
        return Err(FrustumError::Near(near));
    }
    if far.is_nan() || far <= near {
        return Err(FrustumError::Far { near, far });
    }
    let n = f64::from(near);
    let k = n / f64::from(far);
    let matrix = Mat4::from_cols(
        Vec4::new(x as f32, 0.0, 0.0, 0.0),
        Vec4::new(0.0, y as f32, 0.0, 0.0),
        Vec4::new(x_by_z as f32, y_by_z as f32, (-(1.0 + k) / (1.0 - k)) as f32, -1.0),
        Vec4::new(0.0, 0.0, (-2.0 * n / (1.0 - k)) as f32, 0.0),
    );
    if matrix.is_finite() { Ok(matrix) } else { Err(FrustumError::TooLarge) }
}
// ANCHOR_END: rows
