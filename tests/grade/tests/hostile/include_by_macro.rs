// The two words of the macro's name stand apart.
macro_rules! of { ($what:ident) => { $what!("CANARY") } }
const FILE: &[u8] = of!(include_bytes);
fn attempt() -> bool { !FILE.is_empty() }
