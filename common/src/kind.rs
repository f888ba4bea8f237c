//! What a file is that is not what it was taken for.

/// What a PNG file begins with.
pub(crate) const PNG: &[u8] = b"\x89PNG\r\n\x1a\n";

/// What bytes of a kind begin with, what they are, and what can be done.
const KINDS: &[(&[u8], &str)] = &[
    (b"\xff\xfe", "text in UTF-16: save it as UTF-8"),
    (b"\xfe\xff", "text in UTF-16: save it as UTF-8"),
    (b"\x1f\x8b", "compressed by gzip: unpack it first"),
    (b"PK\x03\x04", "a ZIP archive: unpack it first"),
    (b"7z\xbc\xaf\x27\x1c", "a 7z archive: unpack it first"),
    (
        b"version https://git-lfs.github.com/",
        "a pointer of Git LFS, which stands for the file: `git lfs pull` fetches it",
    ),
    (PNG, "a PNG picture, whose name ends in .png"),
    (b"\xff\xd8\xff", "a JPEG picture: convert it to PNG"),
    (b"GIF8", "a GIF picture: convert it to PNG"),
    (b"RIFF", "a WebP picture, or another RIFF file: convert it to PNG"),
    (b"BM", "a BMP picture: convert it to PNG"),
    (b"II*\0", "a TIFF picture: convert it to PNG"),
    (b"MM\0*", "a TIFF picture: convert it to PNG"),
    (b"%PDF-", "a PDF document"),
    (b"glTF", "a model in glTF's binary form: export it as OBJ"),
    (b"ply\n", "a PLY model: export it as OBJ"),
    (b"ply\r\n", "a PLY model: export it as OBJ"),
    (b"solid ", "an STL model: export it as OBJ"),
    (b"Kaydara FBX Binary", "an FBX model: export it as OBJ"),
    (b"BLENDER", "a Blender file: export it as OBJ"),
];

/// A sentence that says what bytes are, if that is known; it begins with "it is".
pub(crate) fn told(bytes: &[u8]) -> Option<String> {
    let known = KINDS.iter().find(|(begins, _)| bytes.starts_with(begins)).map(|kind| kind.1);
    let known = known
        .or_else(|| is_html(bytes).then_some("a page in HTML: download the file itself"))
        .or_else(|| is_wide(bytes).then_some("text in UTF-16: save it as UTF-8"));
    known.map(|kind| format!("it is {kind}"))
}

/// Whether bytes begin with four characters of ASCII in UTF-16, without the mark that should come first.
fn is_wide(bytes: &[u8]) -> bool {
    let all = |at: usize, test: fn(&u8) -> bool| bytes.len() >= 8 && bytes[at..8].iter().step_by(2).all(test);
    [(0, 1), (1, 0)]
        .iter()
        .any(|&(low, high)| all(low, |b| (b' '..=b'~').contains(b)) && all(high, |&b| b == 0))
}

/// Whether bytes begin, blanks aside, as pages do.
fn is_html(bytes: &[u8]) -> bool {
    let text = bytes.trim_ascii_start();
    ["<!doctype html", "<html"].iter().any(|begins| {
        text.get(..begins.len()).is_some_and(|text| text.eq_ignore_ascii_case(begins.as_bytes()))
    })
}
