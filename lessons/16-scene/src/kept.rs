//! What drawing needs for itself, and should not allocate in each frame.

use std::any::Any;

/// One value of each type that was asked for. There are few, so they are looked through.
///
/// How a mesh is drawn tells the type of what its vertices interpolate: a list of these cannot be a field, as there is one for
/// each combination of colours and light.
#[derive(Default)]
pub struct Kept(Vec<Box<dyn Any>>);

impl Kept {
    /// The one of that type, as it was left; a new one the first time.
    ///
    /// ```
    /// # use scene::kept::Kept;
    /// let mut kept = Kept::default();
    /// kept.of::<Vec<u32>>().push(7);
    /// assert_eq!(kept.of::<Vec<f32>>(), &[]);
    /// assert_eq!(kept.of::<Vec<u32>>(), &[7]);
    /// ```
    #[expect(clippy::missing_panics_doc, reason = "what is found by its type is of that type")]
    pub fn of<T: Default + 'static>(&mut self) -> &mut T {
        let place = self.0.iter().position(|value| value.is::<T>()).unwrap_or_else(|| {
            self.0.push(Box::<T>::default());
            self.0.len() - 1
        });
        self.0[place].downcast_mut().expect("it was found by its type")
    }
}
