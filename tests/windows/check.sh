#!/usr/bin/env bash
# Uses the Windows program like a person, under Wine and Xvfb: tests/windows/check.sh [CHECK...]
# Needs the results of app/packaging/windows.sh --tests; ./test.sh --windows runs both. Without arguments all checks run.
# Compares with the Linux program of build/release, or with MELTPOOL_LINUX.
set -euo pipefail
cd "$(dirname "$0")/../.."
root=$PWD
linux=${MELTPOOL_LINUX:-build/release/bin/meltpool}
work=$root/build/windows/check
folder="$work/Größe und Länge" # a folder name with spaces and umlauts
program=
failed=()

export LC_ALL=C.UTF-8 WINEPREFIX=$work/wine WINEDEBUG=-all WINEDLLOVERRIDES='mscoree=;mshtml=;winedbg.exe=d' ALSOFT_DRIVERS=null
unset MELTPOOL_DATA

fail() {
    echo "    $*" >&2
    return 1
}

# runs CODE ARGUMENT...: checks the program's exit code; writes its output to $work/output and $work/errors.
runs() {
    local wanted=$1 code=0
    shift
    timeout 1800 wine "$program" "$@" >"$work/output" 2>"$work/errors" </dev/null || code=$?
    sed -i 's/\r$//' "$work/output" "$work/errors"
    [ "$code" = "$wanted" ] && return
    tail -n 5 "$work/output" "$work/errors" >&2
    fail "meltpool $* ended with $code; expected $wanted"
}

says() {
    grep -qF -- "$1" "$work/output" "$work/errors" || fail "not said: $1"
}

# value FILE KEY: prints a number or text of a result file.
value() {
    sed -n "/^ *\"$2\": /{s/^ *\"$2\": \"\{0,1\}\([^\",]*\)\"\{0,1\},\{0,1\}\r\{0,1\}$/\1/p;q}" "$1"
}

# found CONDITION...: succeeds if the user's folders under Wine have a file that meets these conditions of find.
found() {
    [ -n "$(find "$WINEPREFIX/drive_c/users" "$@" -print -quit)" ]
}

# agree A B KEY SHARE: checks that the values of two result files differ by at most this share.
agree() {
    local a b
    a=$(value "$1" "$3") b=$(value "$2" "$3")
    awk -v a="$a" -v b="$b" -v share="$4" -v key="$3" 'BEGIN {
        d = a - b; if (d < 0) d = -d; m = (b < 0 ? -b : b);
        printf "    %s: Windows %s, Linux %s\n", key, a, b
        exit !(a != "" && b != "" && d <= share * m) }' || fail "$3 differs by more than $4"
}

check_doctor() {
    runs 0 doctor
    says 'OpenGL'
    says 'WGL'
    says 'Everything that a lesson needs is here.'
    sed -n '2,4p' "$work/output"
}

check_lessons() {
    runs 0 lessons
    says 'gmaw-bead'
    says 'classic'
    runs 0 lessons gmaw-bead
}

check_classic() {
    runs 0 run classic --out "$work/Übung eins/classic" --seconds 1 --pictures 0 --size 320x180
    "$linux" run classic --out "$work/linux-classic" --seconds 1 --pictures 0 --size 320x180 >/dev/null
    local here=$work/Übung\ eins/classic/result.json there=$work/linux-classic/result.json key
    echo "    state: Windows $(value "$here" state_hash), Linux $(value "$there" state_hash)"
    for key in molten mean_temperature max_temperature; do
        agree "$here" "$there" $key 0.001
    done
}

check_gmaw() {
    runs 0 run gmaw-bead --out "$work/gmaw" --seconds 2 --pictures 0 --size 640x360
    "$linux" run gmaw-bead --out "$work/linux-gmaw" --seconds 2 --pictures 0 --size 640x360 >/dev/null
    echo "    state: Windows $(value "$work/gmaw/result.json" state_hash), Linux $(value "$work/linux-gmaw/result.json" state_hash)"
    agree "$work/gmaw/result.json" "$work/linux-gmaw/result.json" mean_temperature_c 0.001
    [ -s "$work/gmaw/"*metal.png ] || fail 'no picture'
}

check_bad_input() {
    runs 2 run nosuch --out "$work/nothing"
    says "lesson 'nosuch' is not in the catalogue"
    printf 'title = "x"\nmodel = \n' >"$work/Schlechte Übung.toml"
    runs 2 run "Z:$work/Schlechte Übung.toml" --out "$work/nothing"
    says 'Schlechte Übung.toml'
    [ "$(wc -l <"$work/errors")" = 1 ] || fail 'more than one line'
    runs 2 run classic --out 'Q:\nowhere\at all'
    runs 2 --nosuch
    runs 2 validate "$work/Schlechte Übung.toml"
    runs 2 lessons 'Öffnung'
    says "'Öffnung'"
}

check_long_path() {
    local long=$work/lang i
    for i in 1 2 3 4 5 6; do
        long=$long/eine-recht-lange-Bezeichnung-eines-Ordners-mit-Umlauten-äöü-$i
    done
    runs 0 run classic --out "$long" --seconds 0.1 --pictures 0 --size 64x64
    [ -s "$long/result.json" ] || fail 'no result in a folder with a long name'
    echo "    a path of ${#long} characters"
}

check_lesson_file() {
    sed 's/^title = .*/title = "Eigene Übung"/' app/data/lessons/classic.toml >"$work/Eigene Übung.meltpool"
    cp app/data/paths/classic-corner.toml "$work/" 2>/dev/null || true
    sed -i "s#\"\(\.\./\)*paths/#\"$root/app/data/paths/#" "$work/Eigene Übung.meltpool"
    runs 0 run "$work/Eigene Übung.meltpool" --out "$work/eigene" --seconds 0.1 --pictures 0 --size 64x64
}

check_ctrl_c() {
    local helper=build/windows/bin/test_interrupt.exe code=0
    rm -rf "$work/interrupted"
    timeout 300 wine "$helper" "$work/interrupted/telemetry.csv" 2000 "$program" run gmaw-bead \
        --out "$work/interrupted" --seconds 60 --pictures 0 --size 320x180 >"$work/output" 2>"$work/errors" </dev/null || code=$?
    sed -i 's/\r$//' "$work/output" "$work/errors"
    tail -n 2 "$work/errors" | sed 's/^/    /'
    [ "$code" = 1 ] || fail "Ctrl-C ended the run with code $code; expected 1"
    says 'the run was stopped before its end'
    [ "$(value "$work/interrupted/result.json" finished)" = false ] || fail 'Ctrl-C did not end the run early'
}

# place NAME: prints the middle of a control in the window, from the newest telemetry row.
place() {
    tail -n 2 "$work/window.jsonl" 2>/dev/null | grep -o "\"$1\":\[[^]]*" | tail -n 1 | tr ':[,' '   ' |
        awk '{ printf "%d %d", $2 + $4 / 2, $3 + $5 / 2 }'
}

# open_window PROGRAM: opens the trainer's window on gmaw-bead, waits for its start menu, sets $window to its number.
open_window() {
    rm -f "$work/window.jsonl" "$work/window"
    wine "$1" --desktop --lesson gmaw-bead --telemetry "Z:$work/window.jsonl" >"$work/output" 2>"$work/errors" </dev/null &
    local tries
    for tries in $(seq 300); do
        xdotool search --onlyvisible --name '^Meltpool' >"$work/window" 2>/dev/null && [ -s "$work/window" ] && break
        sleep 0.2
    done
    [ -s "$work/window" ] || fail 'no window came'
    window=$(tail -n 1 "$work/window")
    for tries in $(seq 100); do
        [ -n "$(place start.start)" ] && break
        sleep 0.3
    done
    [ -n "$(place start.start)" ] || fail 'no start menu came'
}

close_window() {
    xdotool key alt+F4 || true
    local tries
    for tries in $(seq 100); do
        [ -z "$(processes)" ] && return
        sleep 0.2
    done
    fail 'the window did not close'
}

# Starts the trainer's window, welds until the recording grows, and sets $recording to its name. The mouse button stays
# down.
start_welding() {
    xdotool mouseup 1 # an earlier check may have failed halfway
    rm -rf "$WINEPREFIX"/drive_c/users/*/AppData/*/meltpool
    open_window "$program"
    local tries
    # shellcheck disable=SC2046
    xdotool mousemove --window "$window" $(place start.start) sleep 0.5 click 1
    for tries in $(seq 100); do
        grep -q '"page":"start"' <<<"$(tail -n 1 "$work/window.jsonl")" || break
        sleep 0.3
    done
    xdotool mousemove --window "$window" 600 380 sleep 0.5 mousedown 1
    for tries in $(seq 200); do
        recording=$(find "$WINEPREFIX/drive_c/users" -name '*.meltrec' -size +20k -print -quit 2>/dev/null)
        [ -n "$recording" ] && break
        sleep 0.3
    done
    [ -n "$recording" ] || fail 'no recording grew'
}

# Prints the Linux process ids of the program under this Wine.
processes() {
    local process
    for process in $(pgrep -f 'meltpool\.exe --(desktop|headset)' || true); do # its folder's name has spaces
        grep -qzxF "WINEPREFIX=$WINEPREFIX" "/proc/$process/environ" 2>/dev/null && echo "$process"
    done
    return 0
}

# end_processes SIGNAL: sends it to each process; ending one may end others.
end_processes() {
    local process
    for process in $(processes); do kill "$1" "$process" 2>/dev/null || true; done
}

check_window() {
    start_welding
    sleep 2 # the arc burns
    import -window root "$work/window.png"
    xdotool mouseup 1
    echo "    picture: $work/window.png"
    [ "$(identify -format %k "$work/window.png")" -gt 500 ] || fail 'the picture shows next to nothing'
    close_window
    found -path '*AppData/Roaming/meltpool/*' -name '*.toml' || fail 'no settings in %APPDATA%'
}

check_kill() {
    start_welding
    end_processes -KILL
    wait 2>/dev/null || true
    runs 0 recordings --check "Z:$recording"
    head -n 2 "$work/output" | sed 's/^/    /'
}

check_crash() {
    start_welding
    local report process tries ended=$SECONDS
    process=$(wine build/windows/bin/test_crash.exe Meltpool | tr -d '\r') || fail "no crash could be made ($?)"
    for tries in $(seq 600); do # Wine needs about ten seconds for the minidump
        [ -z "$(processes)" ] && break
        sleep 0.2
    done
    [ -z "$(processes)" ] || fail 'the program goes on after its crash'
    echo "    ended $((SECONDS - ended)) s after its crash"
    find "$WINEPREFIX/drive_c/users" -path '*Roaming/meltpool/crash-*' -printf '    %f, %s bytes\n'
    report=$(find "$WINEPREFIX/drive_c/users" -path "*Roaming/meltpool/crash-*-$process.txt" -print -quit)
    [ -n "$report" ] || fail "no report of the crash of process $process"
    sed -n '1,8 { s/\r$//; s/^/    /; p }' "$report"
    grep -q 'last lesson: gmaw-bead' "$report" || fail 'the report does not name the lesson'
    grep -q 'driver: 4\.' "$report" || fail 'the report does not name the driver'
    tail -n 1 "$report" | sed 's/\r$//; s/^/    /'
    grep -q 'minidump: beside this file' "$report" || fail 'the report does not tell of its minidump'
    [ -n "$(find "${report%.txt}.dmp" -size +100k)" ] || fail 'no whole minidump'
    runs 0 recordings --check "Z:$recording"
}

openxr_key='HKLM\SOFTWARE\Khronos\OpenXR\1'

# Registers the tests' own OpenXR runtime. The loader ignores XR_RUNTIME_JSON in a process with administrator's rights,
# and under Wine each process has them.
install_runtime() {
    local manifest=$work/runtime.json
    printf '{"file_format_version": "1.0.0", "runtime": {"library_path": "Z:%s"}}' \
        "${root//\//\\\\}\\\\build\\\\windows\\\\bin\\\\test_runtime.dll" >"$manifest"
    : >"$work/calls"
    wine reg add "$openxr_key" /v ActiveRuntime /t REG_SZ /d "Z:${manifest//\//\\}" /f >/dev/null 2>&1
    export MELTPOOL_TEST_RUNTIME_LOG=Z:$work/calls
}

remove_runtime() {
    wine reg delete "$openxr_key" /v ActiveRuntime /f >/dev/null 2>&1
}

# in_order CALL...: checks that the first occurrences of these calls are in this order.
in_order() {
    local call line before=0
    for call in "$@"; do
        line=$(awk -v call="$call" '{ sub(/\r$/, "") } $0 == call { print NR; exit }' "$work/calls")
        [ -n "$line" ] || fail "the runtime saw no $call"
        [ "$line" -gt "$before" ] || fail "$call came too early"
        before=$line
    done
}

check_headset() {
    install_runtime
    MELTPOOL_TEST_RUNTIME_NO_OPENGL=1 runs 0 doctor
    says 'SteamVR has it'
    : >"$work/calls"
    XR_RUNTIME_JSON='Z:\nowhere\other.json' runs 0 doctor
    remove_runtime
    says 'runtime.json'
    says 'other.json is ignored'
    says 'stub headset'
    says 'OpenGL binding                       WGL'
    in_order xrNegotiateLoaderRuntimeInterface xrGetOpenGLGraphicsRequirementsKHR xrCreateSession xrCreateSwapchain xrWaitFrame \
        xrBeginFrame xrEndFrame xrDestroySession
    ! grep FAULT "$work/calls" || fail 'the runtime complains'
}

# Runs the trainer in the headset, with a runtime that loses the session after 40 frames.
check_headset_trainer() {
    install_runtime
    MELTPOOL_TEST_RUNTIME_LOSE=40 wine "$program" --headset --lesson gmaw-bead >"$work/output" 2>"$work/errors" </dev/null &
    local tries
    for tries in $(seq 300); do
        [ "$(tr -d '\r' <"$work/calls" | grep -cx xrCreateSession || true)" -ge 2 ] &&
            [ "$(tr -d '\r' <"$work/calls" | sed '1,/the session is lost/d' | grep -c 'xrEndFrame with layers')" -ge 5 ] && break
        sleep 0.3
    done
    end_processes -TERM
    wait 2>/dev/null || true
    remove_runtime
    in_order xrGetOpenGLGraphicsRequirementsKHR xrCreateSession xrCreateSwapchain xrWaitFrame xrBeginFrame \
        xrAcquireSwapchainImage xrWaitSwapchainImage xrReleaseSwapchainImage 'xrEndFrame with layers' 'the session is lost'
    tr -d '\r' <"$work/calls" | sed '1,/the session is lost/d' >"$work/after"
    grep -qx xrDestroySession "$work/after" || fail 'the lost session was not destroyed'
    grep -qx xrCreateSession "$work/after" || fail 'no session was made after the lost one'
    grep -qx 'xrEndFrame with layers' "$work/after" || fail 'no pictures after the lost session'
    ! grep FAULT "$work/calls" || fail 'the runtime complains'
}

check_registry() {
    wine reg add "$openxr_key" /v ActiveRuntime /t REG_SZ /d 'Z:\nowhere\runtime.json' /f >/dev/null 2>&1
    runs 0 doctor
    remove_runtime
    says 'runtime.json'
    says 'does not exist'
}

# kept KEY: succeeds if the user's registry has this key.
kept() {
    wine reg query "HKCU\\Software\\$1" >/dev/null 2>&1
}

check_installer() {
    local before=$program folder tries key
    wine build/windows/meltpool-*-setup.exe /S || fail 'the installer ended with a fault'
    program=$(find "$WINEPREFIX/drive_c/users" -path '*Local/Programs/Meltpool/meltpool.exe' -print -quit)
    [ -n "$program" ] || fail 'nothing was installed'
    folder=$(dirname "$program")
    found -name 'Meltpool.lnk' || fail 'no entry in the start menu'
    wine reg query 'HKCU\Software\Classes\Meltpool.Lesson\shell\open\command' 2>/dev/null |
        grep meltpool-window >/dev/null || fail 'lessons are not associated'
    runs 0 run classic --out 'C:\results of mine' --seconds 0.1 --pictures 0 --size 64x64
    runs 0 doctor
    open_window "$folder/meltpool-window.exe"
    close_window
    local attempts=${folder%/Programs/Meltpool}/meltpool
    mkdir -p "$attempts"
    echo kept >"$attempts/kept.txt"
    # The uninstaller continues in a copy of itself, to delete its own file.
    wine "$folder/uninstall.exe" /S || fail 'the uninstaller ended with a fault'
    for tries in $(seq 100); do
        [ -e "$folder" ] || break
        sleep 0.3
    done
    [ ! -e "$folder" ] || fail "left behind: $(find "$folder" | head -n 5)"
    ! found -name 'Meltpool*.lnk' || fail 'left in the start menu'
    for key in Meltpool 'Classes\Meltpool.Lesson' 'Classes\.meltpool' 'Microsoft\Windows\CurrentVersion\Uninstall\Meltpool'; do
        ! kept "$key" || fail "left in the registry: $key"
    done
    [ -s "$WINEPREFIX/drive_c/results of mine/result.json" ] || fail 'the results are gone'
    [ -s "$attempts/kept.txt" ] || fail 'what the trainee kept is gone'
    program=$before
}

# Ten shipped cases, each a few seconds at most on Linux.
quickest=(conduction_step conduction_flux stefan_one_phase stefan_one_phase_1mm stefan_two_phase energy energy_insulated
    energy_weld poiseuille droplet_oscillation)
check_validate() {
    local case
    for case in "${quickest[@]}"; do
        runs 0 validate "$(dirname "$program")/validation/$case.toml" || return 1
        echo "    $case holds"
    done
}

check_units() {
    local suite broken=()
    for suite in house base gl metal validation surface render weld judging training desktop_parts; do
        SECONDS=0
        (cd build/windows && MELTPOOL_DATA="Z:$root/build/windows/share/meltpool" timeout 1800 wine bin/test_$suite.exe '~[long]' '~[by_hand]') \
            >"$work/suite-$suite" 2>&1 || broken+=("$suite")
        echo "    $suite, $SECONDS s: $(tail -n 3 "$work/suite-$suite" | grep -a assertions)"
    done
    for suite in "${broken[@]}"; do tail -n 30 "$work/suite-$suite" >&2; done
    [ ${#broken[@]} -eq 0 ] || fail "suites ${broken[*]}"
}

prepare() {
    rm -rf "$folder"
    mkdir -p "$work" "$folder"
    unzip -q -o build/windows/meltpool-*-windows.zip -d "$folder"
    program=$(find "$folder" -name meltpool.exe)
    timeout 300 wineboot -i >/dev/null 2>&1
    remove_runtime || true # an earlier check may have failed halfway
}

main() {
    local name code started
    prepare
    for name in "$@"; do
        echo "$name"
        started=$(date +%s)
        set +e # errexit has no effect inside a condition
        (
            set -e
            "check_$name"
        )
        code=$?
        set -e
        echo "    $(($(date +%s) - started)) s"
        [ $code -eq 0 ] || failed+=("$name")
    done
    [ ${#failed[@]} -eq 0 ] || {
        echo "Failed under Wine: ${failed[*]}" >&2
        exit 1
    }
    echo 'Everything holds under Wine.'
}

all=(doctor lessons classic gmaw bad_input long_path lesson_file ctrl_c window kill crash headset headset_trainer registry
    installer units validate)
[ $# -gt 0 ] || set -- "${all[@]}"
if [ -z "${DISPLAY:-}" ] || [ -z "${MELTPOOL_SHOWN:-}" ]; then
    export MELTPOOL_SHOWN=1
    exec xvfb-run -a -s '-screen 0 1600x1000x24' "$0" "$@"
fi
main "$@"
