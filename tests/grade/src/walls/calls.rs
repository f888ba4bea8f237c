//! Which system calls may be made behind the walls.

use std::collections::BTreeMap;

use anyhow::{Context, anyhow};
use seccompiler::{
    BpfProgram, SeccompAction, SeccompCmpArgLen, SeccompCmpOp, SeccompCondition, SeccompFilter, SeccompRule,
    apply_filter,
};

use super::Role;

/// What a calculation needs: its memory, the files that the other wall leaves it, the clock, an end. A list of
/// what is allowed, since a program is no longer a matter of what its source could name.
///
/// Nothing in it waits, since a limit on CPU time would never end that: a sleep is over at once.
const CALCULATION: &[i64] = &[
    libc::SYS_brk,
    libc::SYS_clock_getres,
    libc::SYS_clock_gettime,
    libc::SYS_clock_nanosleep,
    libc::SYS_close,
    libc::SYS_dup,
    libc::SYS_exit,
    libc::SYS_exit_group,
    libc::SYS_fstat,
    libc::SYS_getpid,
    libc::SYS_getrandom,
    libc::SYS_gettid,
    libc::SYS_lseek,
    libc::SYS_madvise,
    libc::SYS_mmap,
    libc::SYS_mprotect,
    libc::SYS_mremap,
    libc::SYS_munmap,
    libc::SYS_nanosleep,
    libc::SYS_openat,
    libc::SYS_pread64,
    libc::SYS_read,
    libc::SYS_readv,
    libc::SYS_restart_syscall,
    libc::SYS_rseq,
    libc::SYS_rt_sigaction,
    libc::SYS_rt_sigprocmask,
    libc::SYS_rt_sigreturn,
    libc::SYS_sched_getaffinity,
    libc::SYS_sched_yield,
    libc::SYS_set_robust_list,
    libc::SYS_set_tid_address,
    libc::SYS_sigaltstack,
    libc::SYS_sysinfo,
    libc::SYS_uname,
    libc::SYS_write,
    libc::SYS_writev,
];

/// The same under the names that only this processor has.
#[cfg(target_arch = "x86_64")]
const CALCULATION_HERE: &[i64] = &[libc::SYS_arch_prctl, libc::SYS_open];
/// Here what looks at descriptors when a program starts could also wait; how long stands in memory, where a filter
/// cannot look.
#[cfg(not(target_arch = "x86_64"))]
const CALCULATION_HERE: &[i64] = &[libc::SYS_ppoll];

/// What neither a compiler nor a linker has to do.
const NOT_FOR_COMPILERS: &[i64] = &[
    libc::SYS_bpf,
    libc::SYS_connect,
    libc::SYS_io_uring_setup,
    libc::SYS_kill,
    libc::SYS_mount,
    libc::SYS_perf_event_open,
    libc::SYS_pidfd_send_signal,
    libc::SYS_process_vm_writev,
    libc::SYS_ptrace,
    libc::SYS_setns,
    libc::SYS_socket,
    libc::SYS_tkill,
    libc::SYS_unshare,
];

/// New processes under the names that only this processor has.
#[cfg(target_arch = "x86_64")]
const FORK_HERE: &[i64] = &[libc::SYS_fork, libc::SYS_vfork];
#[cfg(not(target_arch = "x86_64"))]
const FORK_HERE: &[i64] = &[];

/// The number under which the launcher has the program's file open. No program has such a high one.
pub(super) const PROGRAM: i32 = 100;

type Rules = BTreeMap<i64, Vec<SeccompRule>>;

/// Leaves this process, and the program that it becomes, the system calls of its role.
pub(super) fn restrict(role: Role) -> anyhow::Result<()> {
    let refuse = SeccompAction::Errno(libc::EPERM as u32);
    let filters = match role {
        Role::Program => {
            let sleep = [libc::SYS_clock_nanosleep, libc::SYS_nanosleep].map(|call| (call, vec![]));
            // No error: it is done, and nothing was done.
            let done = SeccompAction::Errno(0);
            vec![
                filter(Rules::from(sleep), SeccompAction::Allow, done)?,
                filter(calculation()?, refuse, SeccompAction::Allow)?,
            ]
        }
        Role::Linker => vec![filter(for_compilers()?, SeccompAction::Allow, refuse)?],
        Role::Compiler => {
            let mut rules = for_compilers()?;
            rules.extend(FORK_HERE.iter().map(|&call| (call, vec![])));
            let flags = SeccompCmpOp::MaskedEq(libc::CLONE_THREAD as u64);
            rules.insert(libc::SYS_clone, vec![only_if(0, flags, 0)?]);
            // What clone3 is asked stands in memory, where a filter cannot look. As if the kernel were an old
            // one, libc then calls clone.
            let clone3 = Rules::from([(libc::SYS_clone3, vec![])]);
            let absent = SeccompAction::Errno(libc::ENOSYS as u32);
            vec![filter(clone3, SeccompAction::Allow, absent)?, filter(rules, SeccompAction::Allow, refuse)?]
        }
    };
    filters.iter().try_for_each(|filter| apply_filter(filter)).context("seccomp is not there")
}

fn calculation() -> anyhow::Result<Rules> {
    let mut rules: Rules = CALCULATION.iter().chain(CALCULATION_HERE).map(|&call| (call, vec![])).collect();
    // To wake a thread is harmless; to wait for one would last for ever.
    let command = SeccompCmpOp::MaskedEq(0x7f);
    rules.insert(libc::SYS_futex, vec![only_if(1, command, libc::FUTEX_WAKE as u64)?]);
    #[cfg(target_arch = "x86_64")]
    rules.insert(libc::SYS_poll, vec![only_if(2, SeccompCmpOp::Eq, 0)?]);
    // abort() signals the process itself; nothing signals another one.
    let own = u64::from(std::process::id());
    // The launcher itself is to become the program, and no program another one.
    let program = only_if(0, SeccompCmpOp::Eq, PROGRAM as u64)?;
    rules.insert(libc::SYS_execveat, vec![program]);
    // Of a file that is open. Of any other one, a submission would learn that it is there.
    let of_open = SeccompCmpOp::MaskedEq(libc::AT_EMPTY_PATH as u64);
    for (call, flags) in [(libc::SYS_newfstatat, 3), (libc::SYS_statx, 2)] {
        rules.insert(call, vec![only_if(flags, of_open.clone(), libc::AT_EMPTY_PATH as u64)?]);
    }
    rules.insert(libc::SYS_tgkill, vec![only_if(0, SeccompCmpOp::Eq, own)?]);
    rules.insert(libc::SYS_prlimit64, vec![only_if(2, SeccompCmpOp::Eq, 0)?]);
    Ok(rules)
}

fn for_compilers() -> anyhow::Result<Rules> {
    let mut rules: Rules = NOT_FOR_COMPILERS.iter().map(|&call| (call, vec![])).collect();
    // Limits may be asked for; root could raise them.
    rules.insert(libc::SYS_prlimit64, vec![only_if(2, SeccompCmpOp::Ne, 0)?]);
    Ok(rules)
}

fn only_if(argument: u8, is: SeccompCmpOp, value: u64) -> anyhow::Result<SeccompRule> {
    let condition = SeccompCondition::new(argument, SeccompCmpArgLen::Qword, is, value)?;
    Ok(SeccompRule::new(vec![condition])?)
}

fn filter(rules: Rules, others: SeccompAction, these: SeccompAction) -> anyhow::Result<BpfProgram> {
    let machine =
        std::env::consts::ARCH.try_into().map_err(|_| anyhow!("no seccomp filter for this processor"))?;
    Ok(SeccompFilter::new(rules, others, these, machine)?.try_into()?)
}
