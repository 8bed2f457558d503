#!/usr/bin/env bash
# Runs the tests next to busy processes, because tests must not rely on an idle computer: tests/load.sh [CTEST ARGUMENTS]
# Starts eight busy processes, or MELTPOOL_LOAD of them, until the tests end. Runs the tests that ./test.sh has built,
# MELTPOOL_REPEAT times in a row.
set -euo pipefail
cd "$(dirname "$0")/.."
[ -e build/release/CTestTestfile.cmake ] || {
    echo "nothing is built; run ./test.sh first" >&2
    exit 2
}
busy=()
stopLoad() { kill "${busy[@]}" 2>/dev/null || true; }
trap stopLoad EXIT
trap 'exit 130' INT
trap 'exit 143' TERM
for ((i = 0; i < ${MELTPOOL_LOAD:-8}; ++i)); do
    (while :; do :; done) &
    busy+=($!)
done
for ((pass = 1; pass <= ${MELTPOOL_REPEAT:-1}; ++pass)); do
    ctest --test-dir build/release --output-on-failure "$@"
done
