// The lesson's own line has a name in the program if it is there. The names stand here from right to left, or they would
// be found.
fn attempt() -> bool {
    let program = std::fs::read(std::env::args().next().unwrap_or_default()).unwrap_or_default();
    let names = ["mahneserb", "crs/senil-10/snossel", "ecnerefer", "htab_mys."];
    names.iter().any(|name| {
        let name: Vec<u8> = name.bytes().rev().collect();
        program.windows(name.len()).any(|bytes| bytes == name)
    })
}
