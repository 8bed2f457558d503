#!/usr/bin/env bash
# Installs missing packages, builds everything and runs the tests:
#   ./test.sh [--quick | --long | --checks] [CTEST ARGUMENTS]
#   ./test.sh --windows [CHECK...]
# A build server (CI is set) goes on, unless arguments choose tests, with sanitizers: the thread sanitizer on the headset's
# threads, the address and undefined-behaviour sanitizers on a quarter of the suites without a window. The quarter changes
# each day. MELTPOOL_TURN=0 to 3 chooses a quarter on any computer, MELTPOOL_TURN=all all four and the tests of the whole
# program.
# --checks implies MELTPOOL_TURN=all, and clang checks all sources.
# --long includes --checks and adds: the soak, fuzzing and long validation tests (hours), the Windows program, and the
# README's commands in bare trees of Debian releases (tests/fresh.sh).
# --quick builds and runs only the suites that take seconds.
# --windows cross-compiles the Windows program with its tests, and checks it under Wine against the Linux program.
set -euo pipefail
cd "$(dirname "$0")"
# shellcheck source=app/setup.sh
. app/setup.sh
configuration=()
checks=
long=
strict=() # a build server stops at a warning; a user's build does not
[ -z "${CI:-}" ] || strict=(-DCMAKE_COMPILE_WARNING_AS_ERROR=ON)
turn=${MELTPOOL_TURN:-${CI:+$((10#$(date +%j) % 4))}} # empty: no sanitizers
if [ "${1:-}" = --long ]; then
    configuration=(-C Long)
    long=fuzz-long
    turn=all
    checks=yes
    shift
fi
if [ "${1:-}" = --checks ]; then
    checks=yes
    turn=all
    shift
fi

# Suites without a window, about a quarter of the time each. Two quarters need no part of app/.
suites0='base gl surface weld xr xr-threads'
suites1='fuzz render scene desktop_parts house'
suites2='metal validation'
suites3='training judging'
suitesOfProgram='app'

# Suites of --quick.
quickSuites='base weld judging house'

# checkQuickly [CTEST ARGUMENTS]: installs and configures only if the build folder has no tests; later Ninja reconfigures.
checkQuickly() {
    local suite targets=()
    if ! grep -qs '^MELTPOOL_TESTS:BOOL=ON' build/release/CMakeCache.txt || [ ! -e build/release/build.ninja ]; then
        meltpoolInstall build test
        meltpoolConfigure release -DMELTPOOL_TESTS=ON "${strict[@]}"
    fi
    for suite in $quickSuites; do
        targets+=("test_$suite")
    done
    cmake --build build/release --target "${targets[@]}"
    ctest --test-dir build/release --output-on-failure --no-tests=error -j 2 \
        -R "^(${quickSuites// /|}|shader-includes)\$" "$@"
}

# checkForWindows [CHECK...]: builds the Windows program with its tests, and compares it with the Linux program.
checkForWindows() {
    meltpoolInstall build
    meltpoolBuild release --target meltpool
    app/packaging/windows.sh --tests
    if command -v clang++ >/dev/null; then
        echo 'Clang looks at all sources as for Windows'
        meltpoolBuild windows-clang -DMELTPOOL_TESTS=ON
    fi
    tests/windows/check.sh "$@"
}

checkWithClang() {
    command -v clang++ >/dev/null || return 0
    echo 'Clang looks at all sources'
    meltpoolBuild clang -DMELTPOOL_TESTS=ON
}

# runSanitized PRESET SUITE...: builds and runs these suites with the sanitizers of the preset.
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

if [ "${1:-}" = --quick ]; then
    shift
    checkQuickly "$@"
    exit
fi
if [ "${1:-}" = --windows ]; then
    shift
    checkForWindows "$@"
    exit
fi
meltpoolInstall build test
meltpoolBuild release -DMELTPOOL_TESTS=ON "${strict[@]}"
# Three suites at a time keep two cores busy: window and headset tests mostly wait for frames.
ctest --test-dir build/release --output-on-failure "${configuration[@]}" -j 3 "$@"

if [ $# -eq 0 ] && [ -n "$turn" ]; then
    [ -z "$checks" ] || checkWithClang
    runSanitized thread xr-threads
    case $turn in
    0) suites=$suites0 ;;
    1) suites=$suites1 ;;
    2) suites=$suites2 ;;
    3) suites=$suites3 ;;
    *) suites="$suites0 $suites1 $suites2 $suites3 $suitesOfProgram $long" ;;
    esac
    # shellcheck disable=SC2086
    runSanitized sanitize $suites
    if [ -n "$long" ]; then
        checkForWindows
        tests/fresh.sh
    fi
fi

known=$(sed 's/#.*//' tests/validation/known_failures.txt | grep -v '^[[:space:]]*$' || true)
[ -z "$known" ] || printf 'Known failures of "meltpool validate" (tests/validation/known_failures.txt):\n%s\n' "$known"
