//! Why a face of an OBJ file is left out, found out from its text.

use super::contents::{Contents, Element};
use super::elements::{Corner, KINDS, NONE, NUMBERS, corner, no_numbers, used};
use super::polygon::CORNER_LIMIT;
use super::words::{Words, line_number, shown};
use crate::model::Attributes;

impl Contents<'_> {
    /// Why a face cannot be used, with its line.
    pub(super) fn why(&self, bytes: &[u8], face: &Element, corners: &[Corner], wanted: Attributes) -> String {
        let mut words = Words::at(bytes, face.offset as usize);
        words.word();
        let mut count = 0;
        let reason = loop {
            let Some(word) = words.word() else {
                break match count {
                    0..3 => format!("a face needs 3 corners, this has {count}"),
                    _ => {
                        format!("a face that is not convex may have {CORNER_LIMIT} corners, this has {count}")
                    }
                };
            };
            match corner(word, used(wanted)) {
                Err(reason) => break reason,
                Ok(indices) => {
                    if let Some(kind) = corners.get(count).and_then(|corner| self.fault(corner)) {
                        let index = indices[kind].unwrap_or_default();
                        break format!(
                            "corner `{}`: {}",
                            shown(word),
                            self.lack(bytes, corners[count][kind], kind, index)
                        );
                    }
                }
            }
            count += 1;
        };
        format!("line {}: {reason}", line_number(bytes, face.offset as usize))
    }

    /// What is wrong with the place of a list that an index names.
    fn lack(&self, bytes: &[u8], place: u32, kind: usize, index: i64) -> String {
        let (name, length) = (KINDS[kind], self.lengths()[kind]);
        if place as usize > length || place == NONE {
            return format!("there is no {name} {index} among {length}");
        }
        let mut words = Words::new(bytes);
        let mut left = place;
        loop {
            let offset = words.offset();
            if words.word() == Some(NUMBERS[kind].0.as_bytes()) {
                left -= 1;
                if left == 0 {
                    let line = line_number(bytes, offset);
                    return format!("{name} {index}, in line {line}: {}", no_numbers(&mut words, kind));
                }
            }
            if !words.next_line() {
                return format!("{name} {index} is not made of finite numbers");
            }
        }
    }
}
