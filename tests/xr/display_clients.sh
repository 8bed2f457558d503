#!/usr/bin/env bash
# Three rows of clients that connect to the X server and leave at once; fails when one of them is refused.
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
