#!/usr/bin/env bash
# Gradescope runs this once, as root, when it builds the image in which submissions are graded.
set -euo pipefail
root=${AUTOGRADER:-/autograder}
export RUSTUP_HOME=$root/rust/rustup CARGO_HOME=$root/rust/cargo PATH=$root/rust/cargo/bin:$PATH
apt-get update
apt-get install --yes --no-install-recommends build-essential ca-certificates curl
curl --proto '=https' --tlsv1.2 --silent --show-error --fail https://sh.rustup.rs |
    sh -s -- -y --no-modify-path --profile minimal --default-toolchain {{ rust }}
cd "$root/source/course"
cargo fetch --locked
cargo build --locked --release --package grade
cargo build --locked{% for package in packages %} --package {{ package }}{% endfor %}
