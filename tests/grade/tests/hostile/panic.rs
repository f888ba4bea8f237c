fn attempt() -> bool { panic!("\u{1b}[31m</details><script>alert(1)</script> \0 too bad") }
