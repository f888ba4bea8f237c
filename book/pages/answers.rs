//! The numbers of the pages that are no lesson's, computed by the course's own code.

use common::{Color, Format, Image};

#[test]
fn a_picture_of_eight_pixels_is_a_file_of_thirty_bytes() {
    let mut image = Image::new(4, 2, Format::Rgb);
    for x in 0..4 {
        image.set(x, 0, if x < 3 { Color::RED } else { Color::rgb(0, 0, 255) });
        image.set(x, 1, Color::WHITE);
    }
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("eight.tga");
    image.write(&file).unwrap();
    let bytes = std::fs::read(&file).unwrap();
    let page = include_str!("pictures.md");
    let (_, listing) = page.split_once("```text\n").unwrap();
    let listing = listing.split_once("```").unwrap().0;
    let shown: Vec<u8> = listing
        .lines()
        .flat_map(|line| line.split("    ").next().unwrap_or_default().split(' '))
        .map(|byte| u8::from_str_radix(byte, 16).unwrap())
        .collect();
    assert_eq!(bytes, shown);
    assert_eq!(bytes.len(), 30);
}

#[test]
fn a_pixel_begins_where_the_page_says() {
    let mut image = Image::new(100, 100, Format::Rgb);
    image.set(52, 41, Color::RED);
    assert_eq!(image.buffer().iter().position(|&byte| byte == 255), Some(12_456));
    assert_eq!(image.buffer().len(), 30_000);
}
