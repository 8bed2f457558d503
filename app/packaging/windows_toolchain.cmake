# Compiles for 64-bit Windows on a Debian or Ubuntu machine. app/packaging/windows.sh makes the libraries.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(triple x86_64-w64-mingw32)
if(NOT CMAKE_CXX_COMPILER)
    # "posix" names the variant of the compiler that has std::thread.
    set(CMAKE_C_COMPILER ${triple}-gcc-posix)
    set(CMAKE_CXX_COMPILER ${triple}-g++-posix)
endif()
set(CMAKE_RC_COMPILER ${triple}-windres)

set(cache $ENV{XDG_CACHE_HOME})
if(NOT cache)
    set(cache $ENV{HOME}/.cache)
endif()
set(MELTPOOL_WINDOWS_LIBRARIES ${cache}/meltpool/windows/libraries CACHE PATH "Libraries made by app/packaging/windows.sh")
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES MELTPOOL_WINDOWS_LIBRARIES)

# Only these libraries are looked at, never those of the machine that compiles.
set(CMAKE_FIND_ROOT_PATH ${MELTPOOL_WINDOWS_LIBRARIES} /usr/${triple})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)

# For Windows g++ 12 takes its own copy of an inline function for the one that is linked in. Where that one was compiled
# elsewhere with other options, it may change registers that a caller believes to be left alone.
if(NOT CMAKE_CXX_COMPILER MATCHES "clang")
    add_compile_options(-fno-ipa-ra)
endif()

# The program takes its run-time libraries along inside itself.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static")
set(CMAKE_SHARED_LINKER_FLAGS_INIT "-static")
