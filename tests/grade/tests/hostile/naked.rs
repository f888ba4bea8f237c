// The compiler's lint `unsafe_code` does not see this one.
#[unsafe(naked)]
extern "C" fn answer() -> usize { core::arch::naked_asm!("mov rax, 1", "ret") }
fn attempt() -> bool { answer() == 1 }
