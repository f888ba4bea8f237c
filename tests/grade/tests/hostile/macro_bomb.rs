// Bounded: 2 to the 25 tokens.
macro_rules! bomb {
    (. $($deeper:tt)*) => { bomb!([$($deeper)*] 1 1) };
    ([] $($token:tt)*) => { 0 };
    ([. $($deeper:tt)*] $($token:tt)*) => { bomb!([$($deeper)*] $($token)* $($token)*) };
}
const BOMB: u32 = bomb!(. . . . . . . . . . . . . . . . . . . . . . . . .);
fn attempt() -> bool { BOMB == 0 }
