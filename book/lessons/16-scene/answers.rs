//! The numbers of the chapter's worked examples and of its quizzes, computed by the lesson's own code.

// TEMPORARY
#[test]
fn tmp_draw() {
    let wanted = std::env::var("FIG").unwrap_or_default();
    std::fs::create_dir_all("/tmp/fig16").unwrap();
    std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).unwrap();
    for figure in super::figures::FIGURES.iter().filter(|f| wanted.split(',').any(|w| f.name.contains(w))) {
        match (figure.draw)() {
            Ok(drawing) => {
                let d = crate::figures::Drawn { figure, drawing };
                println!("{} {:?}", figure.name, d.drawing.size());
                crate::figures::write(&[d], std::path::Path::new("/tmp/fig16")).unwrap();
            }
            Err(e) => println!("{}: {e:#}", figure.name),
        }
    }
}
