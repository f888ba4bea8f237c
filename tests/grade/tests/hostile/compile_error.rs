compile_error!("</pre><script>alert(1)</script>");
fn attempt() -> bool { true }
