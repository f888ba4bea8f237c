fn attempt() -> bool { panic!("odd \u{ffff}\u{0}\u{1b}[31m ]]> </pre><script>alert(1)</script>") }
