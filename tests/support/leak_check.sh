#!/usr/bin/env bash
# Runs a test program that was built with the address sanitizer: leak_check.sh PROGRAM [ARGUMENTS]
# At the end of a program with threads the leak sanitizer's tracer crashes now and then (google/sanitizers, issue 1353):
# no leak is looked for, and its exit code takes the place of that of tests that passed. Then the program runs once
# more, and this is told; a leak or a failed test stays a failure.
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
