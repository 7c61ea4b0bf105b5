# SPDX-License-Identifier: MIT
# The runs that take hours, of ./check --long. To be sourced, in the root of the project, after the
# preset `release` was built. Every run is made, whatever the one before it found.

long_failures=()

# long_step NAME COMMAND...: the command, and what became of it.
long_step() {
    local name=$1
    shift
    echo "== $name"
    "$@" || long_failures+=("$name")
}

build_fuzzers() {
    cmake --preset fuzz && cmake --build --preset fuzz
}

# run_long FOLDER: figures go there.
run_long() {
    local figures=$1 release=build/release
    if command -v clang >/dev/null; then
        long_step "fuzz targets" build_fuzzers
        long_step fuzzing python3 -B tests/fuzz/run.py build/fuzz \
            --minutes "${OPENRT_FUZZ_MINUTES:-10}" --json "$figures/fuzz.jsonl"
    else
        echo "== fuzzing: not run, there is no clang"
    fi
    long_step "every call" $release/bin/every_call --whole --json "$figures/every_call.json"
    long_step "failing allocations" \
        $release/bin/failing_scenes --whole --json "$figures/failing_scenes.json"
    if [ -e $release/lib/failing_preload.so ]; then
        long_step "failing allocations of samples" python3 -B tests/memory/failing_samples.py \
            $release $release/lib/failing_preload.so --whole \
            --json "$figures/failing_samples.json"
    fi
    long_step "many frames" $release/bin/many_frames 100000 --json "$figures/many_frames.json"
    long_step accuracy $release/bin/openrt-accuracy --rays 10000000 \
        --json "$figures/accuracy.json"
    long_step "model of ranks" $release/bin/openrt-bench remote --scene generated:200000
    long_step "queue of frames, its times" $release/bin/queue_figures_test times
    long_step start python3 -B tests/figures/start.py $release --json "$figures/start.json"
    if command -v valgrind >/dev/null; then
        long_step valgrind python3 -B tests/figures/valgrind.py $release \
            --json "$figures/valgrind.json"
    fi
    if command -v lintian >/dev/null; then
        long_step packages python3 -B tests/figures/packages.py build/package \
            --json "$figures/packages.json"
    else
        echo "== packages: not judged, there is no lintian"
    fi
    if command -v debootstrap >/dev/null && [ "$(id -u)" -eq 0 ]; then
        long_step "bare Debian" python3 -B tests/figures/bare.py build/bare \
            --json "$figures/bare.json"
    else
        echo "== bare Debian: not run, that takes root and debootstrap"
    fi
    if cmake --build $release --target help | grep -q '^docs:'; then
        long_step site cmake --build $release --target docs
        long_step "links of the site" python3 -B tests/docs/site_links.py $release/docs/html
    else
        echo "== site: not made, there is no Doxygen"
    fi
    long_step "reproducible build" python3 -B tests/figures/reproducible.py \
        --json "$figures/reproducible.json"
    long_step coverage python3 -B tests/figures/coverage.py build/coverage \
        --json "$figures/coverage.json"
    if [ ${#long_failures[@]} -gt 0 ]; then
        printf 'failed: %s\n' "${long_failures[@]}" >&2
        return 1
    fi
}
