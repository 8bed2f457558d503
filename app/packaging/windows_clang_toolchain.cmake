# Has Clang read the sources as for 64-bit Windows, beside the libraries of windows_toolchain.cmake. Clang does not know
# where Debian keeps the headers of MinGW's C++ library, and it links nothing here.
find_program(MELTPOOL_MINGW x86_64-w64-mingw32-g++-posix REQUIRED)
execute_process(COMMAND ${MELTPOOL_MINGW} -print-file-name=include/c++ OUTPUT_VARIABLE cxxHeaders
    OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
set(CMAKE_C_COMPILER clang)
set(CMAKE_CXX_COMPILER clang++)
set(CMAKE_C_COMPILER_TARGET x86_64-w64-mingw32)
set(CMAKE_CXX_COMPILER_TARGET x86_64-w64-mingw32)
set(CMAKE_C_FLAGS_INIT "-nostdlibinc -idirafter /usr/x86_64-w64-mingw32/include")
set(CMAKE_CXX_FLAGS_INIT "-nostdlibinc -nostdinc++ -isystem ${cxxHeaders} -isystem ${cxxHeaders}/x86_64-w64-mingw32 \
-idirafter /usr/x86_64-w64-mingw32/include")
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
include(${CMAKE_CURRENT_LIST_DIR}/windows_toolchain.cmake)
