# SPDX-License-Identifier: MIT
# The runs that take hours, of ./check --long, after the preset `release` was built. To be sourced.

# write_commit FILE: that of the sources, "-dirty" where they are not what it says.
write_commit() {
    local commit
    commit=$(git describe --always --dirty --exclude '*') && echo "{\"commit\": \"$commit\"}" >"$1"
}

# run_long FOLDER: figures go there. Every run is made, whatever the one before it found.
run_long() {
    local figures=$1 release=build/release
    stage commit write_commit "$figures/commit.json"
    if is_here clang fuzzing && stage "fuzz targets" build fuzz; then
        stage fuzzing python3 -B tests/fuzz/run.py build/fuzz \
            --minutes "${OPENRT_FUZZ_MINUTES:-10}" --json "$figures/fuzz.jsonl"
    fi
    stage "every call" $release/bin/every_call --whole --json "$figures/every_call.json"
    stage "every call of rtut" \
        $release/bin/every_rtut_call --whole --json "$figures/every_rtut_call.json"
    stage "failing allocations" \
        $release/bin/failing_scenes --whole --json "$figures/failing_scenes.json"
    stage "failing allocations of samples" python3 -B tests/memory/failing_samples.py \
        $release $release/lib/failing_preload.so --whole --json "$figures/failing_samples.json"
    stage "many frames" $release/bin/many_frames 100000 --json "$figures/many_frames.json"
    stage accuracy $release/bin/openrt-accuracy --rays 10000000 --json "$figures/accuracy.json"
    stage "model of ranks" $release/bin/openrt-bench remote --scene generated:200000
    stage "queue of frames, its times" $release/bin/queue_figures_test times
    stage start python3 -B tests/figures/start.py $release --json "$figures/start.json"
    if is_here valgrind valgrind; then
        stage valgrind python3 -B tests/figures/valgrind.py $release \
            --json "$figures/valgrind.json"
    fi
    if is_here lintian packages; then
        stage packages python3 -B tests/figures/packages.py build/package \
            --json "$figures/packages.json"
    fi
    if is_here root "bare Debian" && is_here debootstrap "bare Debian"; then
        stage "bare Debian" python3 -B tests/figures/bare.py build/bare \
            --json "$figures/bare.json"
    fi
    stage "reproducible build" python3 -B tests/figures/reproducible.py \
        --json "$figures/reproducible.json"
    stage coverage python3 -B tests/figures/coverage.py build/coverage \
        --json "$figures/coverage.json"
}
