#!/usr/bin/env bash
# Sets up what is missing, builds everything and runs every test: ./test.sh [--long] [--checks] [CTEST ARGUMENTS]
# Then, unless arguments chose tests: the headset's threads under the thread sanitizer; under address and
# undefined-behaviour sanitizers the damage to all text formats and half of the suites that need no window.
# The halves take turns from day to day; MELTPOOL_TURN=0 or 1 chooses, MELTPOOL_TURN=all takes both.
# --checks takes both and has clang check all sources.
# --long does so too, and adds the soak, fuzzing and validation runs that take hours of patience rather than minutes.
# --windows alone cross-compiles the program for Windows with its tests and checks it under Wine beside the Linux program.
set -euo pipefail
cd "$(dirname "$0")"
# shellcheck source=app/setup.sh
. app/setup.sh
configuration=()
checks=
always=fuzz
turn=${MELTPOOL_TURN:-$((10#$(date +%j) % 2))}
if [ "${1:-}" = --windows ]; then
    shift
    meltpoolInstall build
    meltpoolBuild release
    app/packaging/windows.sh --tests
    exec tests/windows/check.sh "$@"
fi
if [ "${1:-}" = --long ]; then
    configuration=(-C Long)
    always='fuzz fuzz-long'
    turn=all
    checks=yes
    shift
fi
if [ "${1:-}" = --checks ]; then
    checks=yes
    turn=all
    shift
fi

# The suites that need no window, about half of the time each.
suites0='base gl weld surface render app desktop_parts'
suites1='house metal validation training xr xr-threads'

checkWithClang() {
    command -v clang++ >/dev/null || return 0
    echo 'Clang looks at all sources'
    meltpoolBuild clang -DMELTPOOL_TESTS=ON
}

# runSanitized PRESET SUITE...: builds and runs these suites, as far as there are such.
runSanitized() {
    local preset=$1 suite names=() targets=()
    shift
    meltpoolConfigure "$preset" -DMELTPOOL_TESTS=ON
    for suite in "$@"; do
        names+=("$suite")
        suite=${suite%-long}
        targets+=("test_${suite//-/_}")
    done
    echo "Under the sanitizers of the preset $preset: ${names[*]}"
    cmake --build "build/$preset" --target "${targets[@]}"
    ctest --test-dir "build/$preset" --output-on-failure "${configuration[@]}" -j 2 -R "^($(IFS='|'; echo "${names[*]}"))\$"
}

meltpoolInstall build test
meltpoolBuild release -DMELTPOOL_TESTS=ON
ctest --test-dir build/release --output-on-failure "${configuration[@]}" -j 2 "$@"

if [ $# -eq 0 ]; then
    [ -z "$checks" ] || checkWithClang
    runSanitized thread xr-threads
    case $turn in
    0) suites=$suites0 ;;
    1) suites=$suites1 ;;
    *) suites="$suites0 $suites1" ;;
    esac
    # shellcheck disable=SC2086
    runSanitized sanitize $always $suites
fi

known=$(sed 's/#.*//' tests/validation/known_failures.txt | grep -v '^[[:space:]]*$' || true)
[ -z "$known" ] || printf 'Known failures of "meltpool validate" (tests/validation/known_failures.txt):\n%s\n' "$known"
