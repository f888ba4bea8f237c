fn attempt() -> bool { checks::missions::lines::MISSION.checks.len() == 6 }
