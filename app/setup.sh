# Functions of run.sh and test.sh that install missing packages and build a preset. Sourced, not run.

# Debian and Ubuntu packages by purpose.
meltpoolBuildPackages=(
    g++ cmake ninja-build pkg-config glslang-tools git
    libglfw3-dev libglew-dev libglm-dev libopenxr-dev libimgui-dev libgl-dev libegl-dev
    libtomlplusplus-dev libcli11-dev nlohmann-json3-dev libpugixml-dev zlib1g-dev libstb-dev libopenal-dev catch2
    libgl1-mesa-dri libegl1 libglx-mesa0 fonts-open-sans fonts-dejavu-core
)
meltpoolTestPackages=(
    assimp-utils dpkg-dev file xvfb xauth xdotool libx11-dev x11-apps x11-utils imagemagick mmdebstrap
)
# Packages to build the Windows program, and to run it under Wine.
meltpoolWindowsPackages=(
    g++-mingw-w64-x86-64-posix libz-mingw-w64-dev nsis dpkg-dev cmake ninja-build glslang-tools git imagemagick
    python3-jinja2 libglm-dev libtomlplusplus-dev libcli11-dev nlohmann-json3-dev libstb-dev libopenal-dev catch2 fonts-open-sans
    fonts-dejavu-core
)
meltpoolWindowsTestPackages=(wine wine64 xvfb xauth xdotool libgl1-mesa-dri imagemagick unzip)
# Optional packages, installed if the distribution has them.
meltpoolOptionalTestPackages=(clang)

# meltpoolInstall KIND...: installs missing packages of these kinds (build, test, windows, windows-test). Calls sudo only if
# a package is missing.
meltpoolInstall() {
    local wanted=() optional=() missing=() kind package
    for kind in "$@"; do
        case $kind in
        build) wanted+=("${meltpoolBuildPackages[@]}") ;;
        test) wanted+=("${meltpoolTestPackages[@]}") optional+=("${meltpoolOptionalTestPackages[@]}") ;;
        windows) wanted+=("${meltpoolWindowsPackages[@]}") ;;
        windows-test) wanted+=("${meltpoolWindowsTestPackages[@]}") optional+=("${meltpoolOptionalTestPackages[@]}") ;;
        esac
    done
    if ! command -v apt-get >/dev/null; then
        meltpoolListNeeds
        return
    fi
    for package in "${wanted[@]}"; do
        meltpoolInstalled "$package" || missing+=("$package")
    done
    [ ${#missing[@]} -eq 0 ] && ! meltpoolOffers "${optional[@]}" >/dev/null && return
    local asRoot=()
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || {
            echo "run as root: apt-get install ${missing[*]}" >&2
            exit 2
        }
        asRoot=(sudo)
    fi
    "${asRoot[@]}" apt-get update -qq
    mapfile -t -O ${#missing[@]} missing < <(meltpoolOffers "${optional[@]}")
    echo "Installing: ${missing[*]}"
    "${asRoot[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"
}

meltpoolInstalled() {
    dpkg-query -W -f '${Status}' "$1" 2>/dev/null | grep -q 'ok installed'
}

# meltpoolOffers PACKAGE...: prints packages that the distribution has and this computer lacks; fails if there are none.
meltpoolOffers() {
    local package any=1
    for package in "$@"; do
        meltpoolInstalled "$package" && continue
        # Not grep -q: it would break the pipe, and pipefail would count that as a failure of apt-cache.
        apt-cache policy "$package" 2>/dev/null | grep 'Candidate: [0-9]' >/dev/null || continue
        echo "$package"
        any=0
    done
    return $any
}

# Lists missing tools for a system without apt, before CMake fails with a less clear message.
meltpoolListNeeds() {
    local tool absent=()
    for tool in c++ cmake ninja pkg-config glslangValidator; do
        command -v $tool >/dev/null || absent+=("$tool")
    done
    [ ${#absent[@]} -eq 0 ] && return
    echo "Please install ${absent[*]}, and the development files of GLFW, GLEW, GLM, OpenXR, Dear ImGui, toml++," >&2
    echo "CLI11, nlohmann-json, stb, zlib, OpenAL Soft, Catch2 and EGL; then start this again." >&2
    exit 2
}

# meltpoolConfigure PRESET [CMAKE CACHE OPTIONS]: configures; prints CMake's output only on failure.
meltpoolConfigure() {
    local preset=$1 log
    shift
    log=$(mktemp)
    if ! { cmake --preset "$preset" "$@" >"$log" 2>&1; }; then
        cat "$log" >&2
        rm -f "$log"
        exit 1
    fi
    rm -f "$log"
}

# meltpoolBuild PRESET [CMAKE CACHE OPTIONS] [--target NAME]: configures and builds.
meltpoolBuild() {
    local preset=$1 options=() target=()
    shift
    while [ $# -gt 0 ]; do
        if [ "$1" = --target ]; then
            target=(--target "$2")
            shift 2
        else
            options+=("$1")
            shift
        fi
    done
    meltpoolConfigure "$preset" "${options[@]}"
    cmake --build "build/$preset" "${target[@]}"
}
