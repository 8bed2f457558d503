#!/usr/bin/env bash
# Prints the licence notices of what a program is linked with: app/packaging/notices.sh COPYRIGHT_FILE...
# A file is named by its own name, or by that of its folder where it is called "copyright".
set -euo pipefail
echo 'Meltpool holds, or was made with, the following works. Their authors and conditions:'
for file in "$@"; do
    name=$(basename "$file")
    [ "$name" != copyright ] || name=$(basename "$(dirname "$file")")
    printf '\n======== %s ========\n\n' "$name"
    cat "$file"
done
