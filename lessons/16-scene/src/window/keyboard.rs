//! Which key of a keyboard is which of ours.

use winit::keyboard::{Key as Typed, KeyCode, NamedKey, PhysicalKey};

use crate::keys::Key;

// ANCHOR: key
/// What a key does, by what is written on it, in whatever case.
///
/// W and S are told by their letters, not by their places: on a French keyboard the key at W's place has a Z on it. Where
/// keys have other letters than Latin ones, as Greek and Russian keyboards do, the place decides.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_count_where_they_are_latin_else_places() {
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
}
