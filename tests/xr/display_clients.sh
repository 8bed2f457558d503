#!/usr/bin/env bash
# Connects three rows of clients to the X server, each for a moment; fails if the server refuses one.
set -u
come_and_go() {
    local i
    for i in {1..60}; do
        xdotool getdisplaygeometry >/dev/null || exit 1
    done
}
rows=()
for _ in 1 2 3; do
    come_and_go &
    rows+=($!)
done
status=0
for row in "${rows[@]}"; do wait "$row" || status=1; done
exit $status
