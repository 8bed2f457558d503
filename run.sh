#!/usr/bin/env bash
# Installs missing packages, builds the trainer and starts it: ./run.sh [ARGUMENTS OF meltpool]
set -euo pipefail
cd "$(dirname "$0")"
# shellcheck source=app/setup.sh
. app/setup.sh
meltpoolInstall build
meltpoolBuild release -DMELTPOOL_TESTS=OFF --target meltpool
exec build/release/bin/meltpool "$@"
