#!/usr/bin/env bash
# Prints the licence notices of the linked libraries: app/packaging/notices.sh COPYRIGHT_FILE...
# A heading has the file's name; for a file called "copyright" that of its folder.
set -euo pipefail
echo 'Meltpool holds, or was made with, the following works. Their authors and conditions:'
for file in "$@"; do
    name=$(basename "$file")
    [ "$name" != copyright ] || name=$(basename "$(dirname "$file")")
    printf '\n======== %s ========\n\n' "$name"
    cat "$file"
done
