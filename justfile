# Recipes; `just` lists them. `just` itself: `cargo install just`, or from PyPI as `rust-just`.

default:
    @just --list

# Run GT Example 5.1 and print its table.
example:
    cargo run --release -- run fixtures/gt-5.1.toml

# All tests, as CI runs them.
test:
    cargo test --workspace --release

# SIGKILL at 200 random moments of a batch: nothing finished is lost, resumed runs have the bytes of undisturbed ones. A minute, three on a busy machine.
kill:
    cargo test --release -p plateau-cli --test crashes -- --ignored --nocapture

# The same bytes for 1 to 16 threads, 20 seeds, 3 fixtures. A minute.
repeat:
    cargo test --release -p plateau-cli --test reproducibility -- --ignored --nocapture

# Two hundred random loops of one to twelve corners, each cut in three ways: no fold without a word, the same area. Half an hour.
loops:
    cargo test --release -p plateau-patches --test any_loop -- --ignored --nocapture

# How often the swarm finds known minima, 100 seeds each; `just success-rates-peer` asks pyswarms the same.
success-rates:
    cargo run --release -p plateau-optim --example success_rates

# The same of pyswarms. Two minutes.
success-rates-peer:
    python3 -m venv target/peer-venv
    target/peer-venv/bin/pip install --quiet -r benches/peer/requirements.txt
    target/peer-venv/bin/python benches/peer/success_rates.py

# The Python package: wheel, tests, types.
python:
    bash .ci/python

# Wheels and sources of the Python package for people, into target/wheels: for every Linux with glibc 2.28 or later where zig is (`pip install ziglang`), else for Linux as new as this one.
wheels:
    python3 -m venv target/wheels-venv
    target/wheels-venv/bin/pip install --quiet 'maturin[zig]'
    PATH="$PWD/target/wheels-venv/bin:$PATH" maturin build --release --strip --zig --compatibility manylinux_2_28 --manifest-path bindings/python/Cargo.toml --out target/wheels
    target/wheels-venv/bin/maturin sdist --manifest-path bindings/python/Cargo.toml --out target/wheels

# Everything CI checks.
ci:
    bash .ci/run

# An archive for people without Rust into target/archive: the command, its manual page, completions, licences.
archive:
    #!/usr/bin/env bash
    set -euo pipefail
    cargo build --release -p plateau-cli
    version=$(target/release/plateau --version | cut -d' ' -f2)
    name=plateau-$version-$(rustc -vV | sed -n 's/^host: //p')
    rm -rf "target/archive/$name"
    mkdir -p "target/archive/$name/completions" "target/archive/$name/man/man1"
    cp target/release/plateau README.md CHANGELOG.md LICENSE-MIT LICENSE-APACHE "target/archive/$name/"
    target/release/plateau man > "target/archive/$name/man/man1/plateau.1"
    target/release/plateau completions bash > "target/archive/$name/completions/plateau.bash"
    target/release/plateau completions zsh > "target/archive/$name/completions/_plateau"
    target/release/plateau completions fish > "target/archive/$name/completions/plateau.fish"
    target/release/plateau completions powershell > "target/archive/$name/completions/_plateau.ps1"
    tar -C target/archive -czf "target/archive/$name.tar.gz" "$name"
    tar -tzf "target/archive/$name.tar.gz"

# The first five minutes of somebody new, timed step by step: README, a boundary of one's own, a STEP file.
first-minutes:
    bash .ci/first-minutes

# Criterion benchmarks; `just bench parametric` runs one group.
bench *FILTER:
    cargo bench -p plateau-benches -- {{FILTER}}

# The same search by NumPy and pyswarms, timed in the same sitting.
bench-peer:
    cargo build --release -p plateau-benches --example search_time
    python3 -m venv target/peer-venv
    target/peer-venv/bin/pip install --quiet -r benches/peer/requirements.txt
    target/peer-venv/bin/python benches/peer/compare.py target/release/examples/search_time

# The figures of accuracy that the book quotes, in full: two minutes.
figures:
    cargo test --release -p plateau-bases --test accuracy -- --ignored --nocapture
    cargo test --release -p plateau-surfaces --test accuracy -- --ignored --nocapture
    cargo test --release -p plateau-energy --test area_bounds --test galerkin -- --nocapture --test-threads 1
    cargo test --release -p plateau-energy --test minimality -- --include-ignored --nocapture --test-threads 1
    cargo test --release -p plateau-solve --test ratio --test certificate -- --nocapture --test-threads 1
    cargo test --release -p plateau-solve --test agreement --test gradient -- --nocapture --test-threads 1

# Least areas beside those of the Surface Evolver (Debian package `evolver`).
evolver:
    cargo build --release -p plateau-cli
    python3 benches/peer/evolver.py target/release/plateau

# Open reports in a headless Chromium (CHROMIUM names it): no console errors, switching methods changes the picture.
check-report *REPORTS:
    cd crates/show/web && npm install --silent
    node crates/show/web/check-report.mjs {{REPORTS}}

# Format, lint, document.
lint:
    cargo fmt --all
    cargo clippy --workspace --all-targets -- -D warnings
    RUSTDOCFLAGS="-D warnings" cargo doc --workspace --no-deps

# The book into target/book; `just book --open` shows it. mdBook: `cargo install mdbook --locked`.
book *ARGUMENTS:
    mdbook build docs {{ARGUMENTS}}

# Every figure of docs/reliability.md: under twenty minutes after the build. The Evolver, LLVM's tools and cargo-fuzz are used where they are there.
reliability: figures success-rates repeat kill
    cargo test --release -p plateau-optim --test search_laws -- --nocapture
    cargo test --release -p plateau-solve --lib error
    cargo test --release -p plateau-record -p plateau-cli --test fixtures --test reproducibility --test crashes --test full_disk
    cargo test --release -p plateau-experiment -p plateau-record -p plateau-cli --test high_degree --test spec_corpus --test limits --test magnitudes --test degenerate -- --nocapture --test-threads 1
    cargo run --release --quiet -p plateau-patches --example effectivity
    if python3 -c 'import mpmath'; then python3 docs/reliability/certificates.py target/release/plateau; else echo "left out: certificates need mpmath"; fi
    cargo run --release --quiet -- reproduce
    if command -v evolver; then just evolver; else echo "left out: the Surface Evolver is not installed"; fi
    if command -v cargo-llvm-cov; then just coverage; else echo "left out: coverage needs cargo-llvm-cov"; fi
    if command -v cargo-fuzz; then just fuzz 60; else echo "left out: fuzzing needs cargo-fuzz"; fi

# Lines covered by tests, crate by crate. `cargo install cargo-llvm-cov --locked`; LLVM_COV and LLVM_PROFDATA name LLVM's tools where rustup has none.
coverage:
    mkdir -p target
    # Under a limit of the size of files the counts of the program itself cannot be written, and it says so.
    cargo llvm-cov --release --workspace --exclude plateau-benches --json --summary-only --output-path target/coverage.json -- --skip a_limit_of_the_size_of_files
    python3 docs/reliability/coverage.py target/coverage.json

# Fuzz experiment files, bases and the reader of results, SECONDS each (`cargo install cargo-fuzz --locked` first). Stable compilers
# are told to accept the flags; nothing in the workspace has unsafe code, so no sanitizer is needed beyond the checks.
fuzz SECONDS="600":
    #!/usr/bin/env bash
    set -euo pipefail
    cd crates/plateau-cli
    export RUSTC_BOOTSTRAP=1
    for target in experiment basis result; do
        mkdir -p fuzz/corpus/$target
        seeds=(); options=(-max_total_time={{SECONDS}} -print_final_stats=1)
        case $target in
            experiment) seeds=(../../fixtures ../experiment/templates); options+=(-dict=fuzz/experiment.dict -max_len=4096) ;;
            result) seeds=(fuzz/seeds/result) ;;
        esac
        cargo fuzz run --sanitizer none --debug-assertions $target fuzz/corpus/$target "${seeds[@]}" -- "${options[@]}"
    done
