//! Which key of a keyboard is which of ours, and which are down.

use winit::keyboard::{Key as Typed, KeyCode, NamedKey, PhysicalKey};

use crate::keys::Key;

// ANCHOR: key
/// What a key does, by what is written on it, in whatever case.
///
/// W and S are told by their letters, not by their places: on a French keyboard the key at W's place has a Z on it. Where
/// a key has a letter that is not ASCII, as all of a Greek or Russian keyboard's and some of others, the place decides.
pub(super) fn key(typed: &Typed, place: PhysicalKey) -> Option<Key> {
    match typed {
        Typed::Named(NamedKey::Escape) => Some(Key::Escape),
        Typed::Named(NamedKey::F1) => Some(Key::F1),
        Typed::Named(NamedKey::F2) => Some(Key::F2),
        Typed::Named(NamedKey::ArrowLeft) => Some(Key::Left),
        Typed::Named(NamedKey::ArrowRight) => Some(Key::Right),
        Typed::Named(NamedKey::ArrowUp) => Some(Key::Up),
        Typed::Named(NamedKey::ArrowDown) => Some(Key::Down),
        Typed::Character(letter) if letter.eq_ignore_ascii_case("w") => Some(Key::W),
        Typed::Character(letter) if letter.eq_ignore_ascii_case("s") => Some(Key::S),
        Typed::Character(letter) if !letter.is_ascii() => match place {
            PhysicalKey::Code(KeyCode::KeyW) => Some(Key::W),
            PhysicalKey::Code(KeyCode::KeyS) => Some(Key::S),
            _ => None,
        },
        _ => None,
    }
}
// ANCHOR_END: key

/// The keys that are down, by their places: between press and release Num Lock, Alt Gr or another layout may change what is
/// written on them.
#[derive(Default)]
pub(super) struct Down(Vec<(PhysicalKey, Key)>);

impl Down {
    /// Key down.
    pub(super) fn press(&mut self, place: PhysicalKey, key: Key) {
        self.0.push((place, key));
    }

    /// The key at a place up: what it was when it went down, unless another place still holds the same, as the arrows of the
    /// keypad do.
    pub(super) fn release(&mut self, place: PhysicalKey) -> Option<Key> {
        let at = self.0.iter().position(|&(down, _)| down == place)?;
        let (_, key) = self.0.swap_remove(at);
        (!self.0.iter().any(|&(_, other)| other == key)).then_some(key)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_count_where_they_are_ascii_else_places() {
        for (letter, place, expected) in [
            ("w", KeyCode::KeyW, Some(Key::W)),
            ("W", KeyCode::KeyW, Some(Key::W)),
            ("S", KeyCode::KeyS, Some(Key::S)),
            // French: Z is where W is elsewhere, and W where Z is.
            ("z", KeyCode::KeyW, None),
            ("w", KeyCode::KeyZ, Some(Key::W)),
            // Dvorak.
            (",", KeyCode::KeyW, None),
            ("s", KeyCode::Semicolon, Some(Key::S)),
            // Russian, Greek.
            ("ц", KeyCode::KeyW, Some(Key::W)),
            ("Ы", KeyCode::KeyS, Some(Key::S)),
            ("ς", KeyCode::KeyW, Some(Key::W)),
            ("я", KeyCode::KeyZ, None),
            // French as bépo has it.
            ("é", KeyCode::KeyW, Some(Key::W)),
            ("x", KeyCode::KeyX, None),
        ] {
            assert_eq!(key(&Typed::Character(letter.into()), PhysicalKey::Code(place)), expected, "{letter}");
        }
    }

    #[test]
    fn named_keys_are_told_by_their_names_wherever_they_are() {
        for (named, place, expected) in [
            (NamedKey::Escape, KeyCode::Escape, Some(Key::Escape)),
            (NamedKey::F1, KeyCode::F1, Some(Key::F1)),
            (NamedKey::F2, KeyCode::F2, Some(Key::F2)),
            (NamedKey::ArrowLeft, KeyCode::ArrowLeft, Some(Key::Left)),
            (NamedKey::ArrowLeft, KeyCode::Numpad4, Some(Key::Left)),
            (NamedKey::ArrowRight, KeyCode::ArrowRight, Some(Key::Right)),
            (NamedKey::ArrowUp, KeyCode::ArrowUp, Some(Key::Up)),
            (NamedKey::ArrowDown, KeyCode::ArrowDown, Some(Key::Down)),
            (NamedKey::F3, KeyCode::F3, None),
            (NamedKey::Shift, KeyCode::KeyW, None),
        ] {
            assert_eq!(key(&Typed::Named(named), PhysicalKey::Code(place)), expected, "{named:?}");
        }
    }

    #[test]
    fn a_key_is_down_until_the_last_place_that_has_it_is_released() {
        let [arrow, keypad, other] =
            [KeyCode::ArrowLeft, KeyCode::Numpad4, KeyCode::KeyW].map(PhysicalKey::Code);
        let mut down = Down::default();
        assert_eq!(down.release(arrow), None);
        for (place, key) in [(arrow, Key::Left), (keypad, Key::Left), (other, Key::W)] {
            down.press(place, key);
        }
        let released = [arrow, arrow, other, keypad, keypad].map(|place| down.release(place));
        assert_eq!(released, [None, None, Some(Key::W), Some(Key::Left), None]);
    }
}
