#!/usr/bin/env bash
# Prints counts of the source tree as JSON: folders, files, checks of the process, largest classes, hottest headers.
#   tests/house/thermometers.sh [BUILD]     BUILD: a folder with bin/test_house; build/release where it is left out
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
build=${1:-build/release}
if [[ ! -x $build/bin/test_house ]]; then
    echo "$build/bin/test_house is missing; expected 'ninja -C $build test_house' first" >&2
    exit 2
fi
figures=$(mktemp)
trap 'rm -f "$figures"' EXIT
MELTPOOL_COMMIT=$(git describe --always --dirty) MELTPOOL_THERMOMETERS=$figures \
    "$build/bin/test_house" '[.thermometers]' >&2
cat "$figures"
