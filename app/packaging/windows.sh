#!/usr/bin/env bash
# Builds the Windows program, its zip and its installer in build/windows: app/packaging/windows.sh [--tests]
# --tests also builds the tests and installs Wine. Installs missing packages, as ./run.sh does.
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
# Tests are one program for each suite; a release is two programs.
meltpoolBuild windows -DMELTPOOL_TESTS=$tests

# Zip and installer hold this folder.
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
