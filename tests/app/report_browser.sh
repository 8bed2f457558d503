#!/usr/bin/env bash
# Opens the page of a run in a real browser: report_browser.sh MELTPOOL [FOLDER]
# Prints it as PDF, which must have two pages, and takes screenshots in mm and of a narrow window, without a network.
# Exits with 77 if no browser is installed. With FOLDER its files stay there.
set -euo pipefail
meltpool=$1
folder=${2:-}

browser=
for name in chromium chromium-browser google-chrome; do
    if command -v "$name" >/dev/null; then
        browser=$name
        break
    fi
done
if [ -z "$browser" ]; then
    echo 'There is no chromium here: the page is not looked at by a browser.'
    exit 77
fi

if [ -z "$folder" ]; then
    folder=$(mktemp -d)
    trap 'rm -rf "$folder"' EXIT
fi
mkdir -p "$folder"
"$meltpool" run tee-fillet --out "$folder/run" --pictures 0 --size 960x540
"$meltpool" report "$folder/run"

look() {
    timeout 120 "$browser" --headless --no-sandbox --disable-gpu --user-data-dir="$folder/browser" \
        --host-resolver-rules='MAP * ~NOTFOUND' --no-pdf-header-footer "$@" "file://$(realpath "$folder")/run/report.html" \
        >"$folder/browser.log" 2>&1 || {
        cat "$folder/browser.log"
        exit 1
    }
}
look --print-to-pdf="$folder/report.pdf"
look --screenshot="$folder/report.png" --window-size=900,2400
look --screenshot="$folder/narrow.png" --window-size=420,3000
rm -rf "$folder/browser"

pages=$(grep -ac '/Type */Page$\|/Type */Page[^s]' "$folder/report.pdf" || true)
echo "The report has $pages pages in print."
[ "$pages" -eq 2 ]
[ -s "$folder/report.png" ] && [ -s "$folder/narrow.png" ]
