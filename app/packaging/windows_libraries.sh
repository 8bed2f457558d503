# Libraries of the Windows program, built once from the distribution's source packages. Sourced by windows.sh, not run.

windowsCache=${XDG_CACHE_HOME:-$HOME/.cache}/meltpool/windows
windowsTriple=x86_64-w64-mingw32
windowsSources=app/packaging/windows_sources.txt

# Header-only packages: Debian package, CMake package, CMake target, folder below /usr/include.
windowsHeaders=(
    "libglm-dev glm glm::glm glm" "libtomlplusplus-dev tomlplusplus tomlplusplus::tomlplusplus toml++"
    "libcli11-dev CLI11 CLI11::CLI11 CLI" "nlohmann-json3-dev nlohmann_json nlohmann_json::nlohmann_json nlohmann"
    "catch2 Catch2 Catch2::Catch2 catch2" "libstb-dev stb stb::stb stb" "libopenal-dev OpenAL OpenAL::OpenAL AL"
)

# windowsApt COMMAND...: apt-get with source entries in the user's cache, so that the system's apt settings stay unchanged.
windowsApt() {
    local apt=$windowsCache/apt
    apt-get -o Dir::Etc::SourceList=/dev/null -o Dir::Etc::SourceParts="$apt/sources" -o Dir::State::Lists="$apt/lists" \
        -o Dir::Cache="$apt/cache" -o APT::Sandbox::User="$(id -un)" -qq "$@"
}

# Copies the system's archive entries, with source packages for binary ones.
windowsSourceEntries() {
    local apt=$windowsCache/apt entries
    rm -rf "$apt/sources"
    mkdir -p "$apt/sources" "$apt/lists/partial" "$apt/cache/archives/partial"
    for entries in /etc/apt/sources.list.d/*.sources; do
        [ -e "$entries" ] || continue
        sed 's/^Types:.*/Types: deb-src/' "$entries" >"$apt/sources/$(basename "$entries")"
    done
    for entries in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
        [ -e "$entries" ] || continue
        sed -n 's/^deb /deb-src /p' "$entries" >"$apt/sources/lines-$(basename "$entries" .list).list"
    done
}

# windowsFetch FOLDER: downloads the source packages of windows_sources.txt into FOLDER, checks their hashes and unpacks
# each into a folder with the package's name.
windowsFetch() {
    local folder=$1 package file wanted
    mapfile -t wanted < <(awk '!/^#/ { print $1 "=" $2 }' "$windowsSources" | sort -u)
    windowsSourceEntries
    windowsApt update
    mkdir -p "$folder"
    (cd "$folder" && windowsApt source --download-only "${wanted[@]}") || {
        echo "the source packages ${wanted[*]} cannot be downloaded; expected an archive with these versions, or" \
            "other versions and their hashes in $windowsSources" >&2
        return 1
    }
    awk '!/^#/ { print $4 "  " $3 }' "$windowsSources" >"$folder/hashes"
    (cd "$folder" && sha256sum --quiet -c hashes) || {
        echo "a source package has another hash than in $windowsSources; expected the version of that list" >&2
        return 1
    }
    for file in "$folder"/*.dsc; do
        package=$(basename "$file")
        dpkg-source --no-check -x "$file" "$folder/${package%%_*}" >/dev/null
    done
}

# windowsCmake NAME SOURCE OPTION...: builds and installs a library that has CMake files.
windowsCmake() {
    local name=$1 source=$2 log=$windowsWork/$1.log
    shift 2
    echo "  $name"
    {
        cmake -S "$source" -B "$windowsWork/build/$name" -G Ninja -DCMAKE_BUILD_TYPE=Release \
            -DCMAKE_TOOLCHAIN_FILE="$PWD/app/packaging/windows_toolchain.cmake" -DMELTPOOL_WINDOWS_LIBRARIES="$windowsPrefix" \
            -DCMAKE_INSTALL_PREFIX="$windowsPrefix" -DBUILD_SHARED_LIBS=OFF "$@" &&
            cmake --build "$windowsWork/build/$name" -j "$(nproc)" --target install
    } >"$log" 2>&1 || {
        tail -n 40 "$log" >&2
        return 1
    }
}

# windowsPackage NAME TARGET LINES...: writes a CMake package of one interface library, with LINES in its file.
windowsPackage() {
    local folder=$windowsPrefix/lib/cmake/$1 name=$1 target=$2
    shift 2
    mkdir -p "$folder"
    {
        echo "if(NOT TARGET $target)"
        echo "  add_library($target INTERFACE IMPORTED)"
        echo "  target_include_directories($target INTERFACE \${CMAKE_CURRENT_LIST_DIR}/../../../include)"
        printf '  %s\n' "$@"
        echo 'endif()'
    } >"$folder/${name}Config.cmake"
}

# Copies the headers: a path to /usr/include would let the cross compiler see the system's own headers too.
windowsCopyHeaders() {
    local package name target folder
    for entry in "${windowsHeaders[@]}"; do
        read -r package name target folder <<<"$entry"
        mkdir -p "$windowsPrefix/include"
        cp -rL "/usr/include/$folder" "$windowsPrefix/include/"
        windowsPackage "$name" "$target"
    done
}

# Defines JsonCpp, which the loader's CMake files name without searching for it.
windowsJsonOfOpenXr() {
    cat >>"$windowsPrefix/cmake/OpenXRConfig.cmake" <<'END'
if(NOT TARGET JsonCpp::JsonCpp)
    add_library(JsonCpp::JsonCpp INTERFACE IMPORTED)
    target_link_libraries(JsonCpp::JsonCpp INTERFACE ${CMAKE_CURRENT_LIST_DIR}/../lib/libjsoncpp.a)
endif()
END
}

# Compiles Dear ImGui, which has no CMake files, from the sources that its Debian package compiles.
windowsImgui() {
    local source=$1 file objects=()
    echo '  imgui'
    mkdir -p "$windowsWork/build/imgui" "$windowsPrefix/include" "$windowsPrefix/lib"
    for file in "$source"/imgui*.cpp "$source"/backends/imgui_impl_{glfw,opengl3}.cpp; do
        objects+=("$windowsWork/build/imgui/$(basename "$file" .cpp).o")
        $windowsTriple-g++-posix -std=c++20 -O2 -fno-ipa-ra -I"$source" -I"$source/backends" -I"$windowsPrefix/include" \
            -I"$windowsPrefix/include/stb" -c "$file" -o "${objects[-1]}"
    done
    $windowsTriple-ar rcs "$windowsPrefix/lib/libimgui.a" "${objects[@]}"
    cp "$source"/*.h "$source"/backends/imgui_impl_{glfw,opengl3}.h "$windowsPrefix/include/"
    # shellcheck disable=SC2016
    windowsPackage imgui imgui::imgui \
        'target_link_libraries(imgui::imgui INTERFACE ${CMAKE_CURRENT_LIST_DIR}/../../libimgui.a imm32 dwmapi gdi32)'
}

# Copies the copyright files of all linked libraries; notices.sh prints them.
windowsKeepNotices() {
    local sources=$1 folder=$windowsPrefix/share/notices package entry
    mkdir -p "$folder"
    for package in "$sources"/*/debian/copyright; do
        entry=$(basename "$(dirname "$(dirname "$package")")")
        cp "$package" "$folder/$entry"
    done
    for entry in "${windowsHeaders[@]}"; do
        package=${entry%% *}
        case $package in catch2 | libopenal-dev) continue ;; esac # not linked
        cp "/usr/share/doc/$package/copyright" "$folder/$package"
    done
    for package in libz-mingw-w64-dev mingw-w64-common gcc-mingw-w64-base fonts-open-sans fonts-dejavu-core; do
        cp "/usr/share/doc/$package/copyright" "$folder/$package"
    done
}

# Builds the libraries unless they exist, and sets windowsPrefix. A change of their list, of this file or of the compiler
# rebuilds them.
windowsLibraries() {
    local key sources
    key=$(cat "$windowsSources" app/packaging/windows_libraries.sh app/packaging/windows_toolchain.cmake \
        <($windowsTriple-g++-posix --version) | sha256sum | cut -c 1-12)
    windowsPrefix=$windowsCache/libraries-$key
    if [ ! -e "$windowsPrefix/complete" ]; then
        echo "Making the libraries for Windows in $windowsPrefix"
        windowsWork=$windowsCache/work-$key
        sources=$windowsWork/sources
        rm -rf "$windowsPrefix" "$windowsWork"
        windowsFetch "$sources"
        windowsCopyHeaders
        cp /usr/$windowsTriple/include/{zlib,zconf}.h "$windowsPrefix/include/"
        mkdir -p "$windowsPrefix/lib"
        cp /usr/$windowsTriple/lib/libz.a "$windowsPrefix/lib/"
        windowsCmake glfw3 "$sources/glfw3" -DGLFW_BUILD_EXAMPLES=OFF -DGLFW_BUILD_TESTS=OFF -DGLFW_BUILD_DOCS=OFF
        windowsCmake glew "$sources/glew/build/cmake" -DBUILD_UTILS=OFF
        windowsCmake pugixml "$sources/pugixml"
        windowsCmake libjsoncpp "$sources/libjsoncpp" -DJSONCPP_WITH_TESTS=OFF -DJSONCPP_WITH_POST_BUILD_UNITTEST=OFF \
            -DBUILD_OBJECT_LIBS=OFF -DJSONCPP_WITH_PKGCONFIG_SUPPORT=OFF
        windowsCmake openxr "$sources/openxr-sdk-source" -DDYNAMIC_LOADER=OFF -DBUILD_TESTS=OFF -DBUILD_API_LAYERS=OFF \
            -DBUILD_LOADER=ON -DBUILD_WITH_SYSTEM_JSONCPP=ON
        windowsJsonOfOpenXr
        cp "$sources/openxr-sdk-source/src/common/loader_interfaces.h" "$windowsPrefix/include/openxr/" # for tests
        windowsImgui "$sources/imgui"
        windowsKeepNotices "$sources"
        touch "$windowsPrefix/complete"
        rm -rf "$windowsWork"
    fi
    ln -sfn "$windowsPrefix" "$windowsCache/libraries"
}
