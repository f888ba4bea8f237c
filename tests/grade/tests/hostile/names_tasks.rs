fn attempt() -> bool { lines_tasks::MISSION.checks.len() == 6 }
