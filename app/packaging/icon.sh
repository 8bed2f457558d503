#!/usr/bin/env bash
# Draws the program's icon (a torch's arc on a glowing pool) with ImageMagick: app/packaging/icon.sh OUTPUT.ico
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
convert -size 256x256 xc:none \
    -fill '#1c2129' -draw 'roundrectangle 4,4 251,251 44,44' \
    -fill '#4a5260' -draw 'rectangle 4,172 251,206' \
    -fill '#7a2a12' -draw 'ellipse 128,178 78,26 0,360' \
    -fill '#e2571b' -draw 'ellipse 128,176 60,20 0,360' \
    -fill '#ffb347' -draw 'ellipse 128,174 40,13 0,360' \
    -fill '#ffffff' -draw 'ellipse 128,172 18,7 0,360' \
    -fill '#9ad0ff' -draw 'polygon 124,118 132,118 150,170 106,170' \
    -fill '#f4fbff' -draw 'polygon 126,118 130,118 136,170 120,170' \
    -fill '#c98a4b' -draw 'polygon 120,88 136,88 132,120 124,120' \
    -fill '#9aa3b2' -draw 'polygon 100,30 156,30 148,92 108,92' \
    -fill '#c3cad6' -draw 'polygon 112,30 126,30 124,92 116,92' "$work/icon.png"
convert "$work/icon.png" -define icon:auto-resize=256,64,48,32,24,16 "$1"
