//! HTML by hand: the little that both figures and pages need.

/// Text with the characters that mean something in HTML written as entities.
pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// HTML that can stand in Markdown: what that would take for markup, outside of tags, written as character
/// references.
pub(crate) fn guarded(html: &str) -> String {
    let mut guarded = String::with_capacity(html.len());
    let mut in_tag = false;
    for c in html.chars() {
        match c {
            '<' => in_tag = true,
            '>' if in_tag => in_tag = false,
            '\n' => {
                guarded.push(' ');
                continue;
            }
            _ if !in_tag && c.is_ascii_punctuation() && !matches!(c, '&' | ';' | '#' | '>') => {
                guarded.push_str(&format!("&#{};", u32::from(c)));
                continue;
            }
            _ => {}
        }
        guarded.push(c);
    }
    guarded
}
