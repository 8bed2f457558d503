#!/usr/bin/env bash
# Runs a test program built with the address sanitizer: leak_check.sh PROGRAM [ARGUMENTS]
# At the end of a program with threads the leak sanitizer's tracer sometimes crashes (google/sanitizers, issue 1353): it
# finds no leaks, and its exit code replaces that of passed tests. Then the program runs once more, with a message. A leak
# or a failed test stays a failure.
set -uo pipefail
output=$(mktemp)
trap 'rm -f "$output"' EXIT
"$@" 2>&1 | tee "$output"
status=${PIPESTATUS[0]}
if [ "$status" -ne 0 ] && grep -q 'LeakSanitizer has encountered a fatal error' "$output" &&
    grep -q '^All tests passed' "$output"; then
    echo 'All tests passed, but the leak check crashed in its own tracer; the program runs once more.'
    "$@"
    status=$?
fi
exit "$status"
