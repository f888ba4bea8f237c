//! The price of `generic`: a loop for each shader.
#![cfg(unix)]

use escargot::CargoBuild;
use object::{Object, ObjectSymbol};

/// How many loops there are in an example of this package, which draws with three shaders of the same types.
fn loops(example: &str) -> usize {
    let build = CargoBuild::new().package("shaders-tests").example(example).arg("--package=verify");
    let program = build.manifest_path(concat!(env!("CARGO_MANIFEST_DIR"), "/../../../Cargo.toml")).run();
    let program = program.unwrap_or_else(|error| panic!("{example}: {error}"));
    let bytes = std::fs::read(program.path()).unwrap();
    let file = object::File::parse(&*bytes).unwrap();
    // A mangled name has each part of the path after its length.
    file.symbols().filter(|symbol| symbol.name().is_ok_and(|name| name.contains("6shader6render"))).count()
}

#[test]
fn generic_has_a_loop_for_each_shader_and_dyn_one_for_all_of_the_same_types() {
    assert_eq!(["generic", "dyn"].map(loops), [3, 1]);
}
