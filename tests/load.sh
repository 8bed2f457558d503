#!/usr/bin/env bash
# Runs the tests beside busy processes, for tests must not lean on a quiet machine: tests/load.sh [CTEST ARGUMENTS]
# Eight processes keep the processors busy until the tests are over, MELTPOOL_LOAD sets another number. The tests are
# those that ./test.sh has built. MELTPOOL_REPEAT=3 asks for three passes in a row.
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
