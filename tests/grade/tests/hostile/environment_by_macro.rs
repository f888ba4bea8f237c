// What the grader was started with: a folder of the instructor's, or a key. The compiler's own PATH tells nothing.
fn attempt() -> bool {
    let variables = [option_env!("HOME"), option_env!("USER"), option_env!("PWD"), option_env!("CARGO_MANIFEST_DIR")];
    variables.iter().any(Option::is_some) || option_env!("PATH").is_some_and(|path| path != "/usr/bin:/bin")
}
