#!/usr/bin/env bash
# Prints counts of a source tree as JSON: folders, files, checks of the process, largest classes, hottest headers.
#   tests/house/thermometers.sh [BUILD [TREE]]
# BUILD: folder with bin/test_house, by default build/release. TREE: a checkout of any version, by default this one.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=$(realpath -m "${1:-$here/build/release}")
tree=$(realpath "${2:-$here}")
if [[ ! -x $build/bin/test_house ]]; then
    echo "$build/bin/test_house is missing; expected 'ninja -C $build test_house' first" >&2
    exit 2
fi
figures=$(mktemp)
trap 'rm -f "$figures"' EXIT
MELTPOOL_COMMIT=$(git -C "$tree" describe --always --dirty) MELTPOOL_TREE=$tree MELTPOOL_THERMOMETERS=$figures \
    "$build/bin/test_house" '[thermometers]' >&2
cat "$figures"
