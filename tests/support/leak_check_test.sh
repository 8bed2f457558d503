#!/usr/bin/env bash
# Tests leak_check.sh: it repeats a program only if the leak check crashed after passed tests.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
check=$(dirname "$0")/leak_check.sh

# expect NAME CODE RUNS LINE...: checks exit code and number of runs of a program that prints the lines and fails in its
# first run only.
expect() {
    local name=$1 code=$2 runs=$3
    shift 3
    printf '%s\n' "$@" >"$folder/lines"
    rm -f "$folder/runs"
    cat >"$folder/program" <<PROGRAM
#!/usr/bin/env bash
echo run >>"$folder/runs"
[ "\$(wc -l <"$folder/runs")" -gt 1 ] && exit 0
cat "$folder/lines"
exit 7
PROGRAM
    chmod +x "$folder/program"
    local got=0
    "$check" "$folder/program" >/dev/null || got=$?
    [ "$got" -eq "$code" ] && [ "$(wc -l <"$folder/runs")" -eq "$runs" ] && return
    echo "$name: exit code $got after $(wc -l <"$folder/runs") runs, expected $code after $runs" >&2
    exit 1
}

crashed='==1==LeakSanitizer has encountered a fatal error.'
expect 'a crashed leak check' 0 2 'All tests passed (3 assertions in 1 test case)' "$crashed"
expect 'a failed test with a crashed leak check' 7 1 'test cases: 2 | 1 passed | 1 failed' "$crashed"
expect 'a leak' 7 1 'All tests passed (3 assertions in 1 test case)' '==1==ERROR: LeakSanitizer: detected memory leaks'
