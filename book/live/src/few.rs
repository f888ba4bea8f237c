//! Few values by keys.

/// A list of values with their keys, in the order in which these came. A search through few takes no time; a tree would be more code
/// than all else in a figure.
pub(crate) struct Few<K, V>(Vec<(K, V)>);

impl<K: PartialEq, V: Default> Few<K, V> {
    pub(crate) fn new() -> Self {
        Self(Vec::new())
    }

    /// The value of a key, the default one where it has none yet.
    pub(crate) fn of(&mut self, key: K) -> &mut V {
        let known = self.0.iter().position(|(other, _)| *other == key);
        let at = known.unwrap_or(self.0.len());
        if known.is_none() {
            self.0.push((key, V::default()));
        }
        &mut self.0[at].1
    }

    /// All of them.
    pub(crate) fn all(&self) -> &[(K, V)] {
        &self.0
    }
}
