//! Values as Rust, to be pasted into a test.

use common::{Color, DVec3, IVec2, Mat4, Vec2, Vec3, Vec4};

/// A value that can be written as Rust. The types are those that `common` has.
pub trait Code {
    /// An expression of that value.
    fn code(&self) -> String;
}

impl Code for f32 {
    fn code(&self) -> String {
        match self {
            n if n.is_nan() => "f32::NAN".into(),
            n if n.is_infinite() => if *n > 0.0 { "f32::INFINITY" } else { "f32::NEG_INFINITY" }.into(),
            n => format!("{n:?}"),
        }
    }
}

impl Code for IVec2 {
    fn code(&self) -> String {
        format!("IVec2::new({}, {})", self.x, self.y)
    }
}

impl Code for Vec2 {
    fn code(&self) -> String {
        format!("Vec2::new({}, {})", self.x.code(), self.y.code())
    }
}

impl Code for Vec3 {
    fn code(&self) -> String {
        format!("Vec3::new({}, {}, {})", self.x.code(), self.y.code(), self.z.code())
    }
}

impl Code for Vec4 {
    fn code(&self) -> String {
        format!("Vec4::new({})", self.to_array().map(|n| n.code()).join(", "))
    }
}

impl Code for DVec3 {
    fn code(&self) -> String {
        format!("DVec3::new({})", self.to_array().map(|n| format!("{n:?}")).join(", "))
    }
}

impl Code for Mat4 {
    fn code(&self) -> String {
        format!("Mat4::from_cols_array(&{})", self.to_cols_array().code())
    }
}

impl Code for Color {
    fn code(&self) -> String {
        format!("Color::rgb({}, {}, {})", self.r, self.g, self.b)
    }
}

impl<T: Code, const N: usize> Code for [T; N] {
    fn code(&self) -> String {
        format!("[{}]", self.each_ref().map(T::code).join(", "))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_number_is_itself_again() {
        for n in [0.1, -0.0, 1e-45, f32::MAX, 1.0 / 3.0] {
            assert_eq!(n.code().parse(), Ok(n));
        }
        assert_eq!(Vec2::new(f32::NEG_INFINITY, 1.0).code(), "Vec2::new(f32::NEG_INFINITY, 1.0)");
        assert_eq!([IVec2::X, IVec2::Y].code(), "[IVec2::new(1, 0), IVec2::new(0, 1)]");
    }
}
