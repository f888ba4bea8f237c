macro_rules! naked { ($($body:tt)*) => { #[unsafe(naked)] $($body)* } }
naked! { extern "C" fn answer() -> usize { core::arch::naked_asm!("mov rax, 1", "ret") } }
fn attempt() -> bool { answer() == 1 }
