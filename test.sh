#!/usr/bin/env bash
# Sets up what is missing, builds everything and runs every test: ./test.sh [--long] [CTEST ARGUMENTS]
# --long adds the soak, fuzzing and validation runs that take hours of patience rather than minutes.
set -euo pipefail
cd "$(dirname "$0")"
# shellcheck source=app/setup.sh
. app/setup.sh
configuration=()
if [ "${1:-}" = --long ]; then
    configuration=(-C Long)
    shift
fi
meltpoolInstall build test
meltpoolBuild release -DMELTPOOL_TESTS=ON
ctest --test-dir build/release --output-on-failure "${configuration[@]}" "$@"

known=$(sed 's/#.*//' tests/validation/known_failures.txt | grep -v '^[[:space:]]*$' || true)
[ -z "$known" ] || printf 'Known failures of "meltpool validate" (tests/validation/known_failures.txt):\n%s\n' "$known"
