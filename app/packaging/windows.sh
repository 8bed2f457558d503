#!/usr/bin/env bash
# Makes the program for Windows, its zip and its installer, in build/windows: app/packaging/windows.sh [--tests]
# --tests also compiles the tests and installs what running them takes. Installs what is missing, as ./run.sh does.
set -euo pipefail
cd "$(dirname "$0")/../.."
# shellcheck source=app/setup.sh
. app/setup.sh
# shellcheck source=app/packaging/windows_libraries.sh
. app/packaging/windows_libraries.sh

kinds=(windows)
tests=OFF
if [ "${1:-}" = --tests ]; then
    kinds+=(windows-test)
    tests=ON
fi
meltpoolInstall "${kinds[@]}"
windowsLibraries
# Tests link one program for each suite; the release holds two programs.
meltpoolBuild windows -DMELTPOOL_TESTS=$tests

# What the zip holds lies in one folder; the installer takes the same.
version=$(sed -n 's/^project(meltpool VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
name=meltpool-$version-windows
folder=build/windows/package/$name
rm -rf build/windows/package
cmake --install build/windows --prefix "$PWD/$folder" --strip >/dev/null
mkdir -p "$folder/fonts"
cp /usr/share/fonts/truetype/open-sans/OpenSans-{Regular,Semibold}.ttf "$folder/fonts/"
cp /usr/share/fonts/truetype/dejavu/DejaVuSans{,-Bold}.ttf "$folder/fonts/"
app/packaging/notices.sh "$windowsPrefix/share/notices"/* >"$folder/licences.txt"
find "$folder" -exec touch -d "@${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2>/dev/null || date +%s)}" {} +
(cd build/windows/package && cmake -E tar cf "../$name.zip" --format=zip "$name")
makensis -V2 -DVERSION="$version" -DFILES="$PWD/$folder" -DOUTPUT="$PWD/build/windows/$name-setup.exe" \
    -INPUTCHARSET UTF8 app/packaging/installer.nsi
ls -l "build/windows/$name.zip" "build/windows/$name-setup.exe"
