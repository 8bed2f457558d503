# Writes the C++ table of the structs of shaders/shared/, which linked programs are compared with (core/gl/shared_structs.hpp):
# each struct's size and its members' places, as the compiler of the program lays them out. Called with FOLDER, the source
# tree's, and OUTPUT.
cmake_minimum_required(VERSION 3.22)
file(GLOB headers RELATIVE ${FOLDER} ${FOLDER}/shaders/shared/*.h)
set(includes)
set(arrays)
set(rows)
foreach(header ${headers})
    string(APPEND includes "#include \"${header}\"\n")
    file(READ ${FOLDER}/${header} text)
    string(REGEX REPLACE "//[^\n]*" "" text "${text}")
    string(REPLACE ";" "@" text "${text}") # a list's own separator
    string(REGEX MATCHALL "struct [A-Za-z0-9_]+ {[^}]*}" structs "${text}")
    foreach(struct ${structs})
        string(REGEX MATCH "struct ([A-Za-z0-9_]+) {([^}]*)}" struct "${struct}")
        set(name ${CMAKE_MATCH_1})
        string(REPLACE "@" ";" members "${CMAKE_MATCH_2}")
        string(APPEND arrays "constexpr SharedMember k${name}[] = {\n")
        foreach(member ${members})
            string(STRIP "${member}" member)
            if(NOT member MATCHES "^([A-Za-z0-9_]+)[ \n]+(.+)$")
                continue()
            endif()
            set(type ${CMAKE_MATCH_1})
            string(REGEX REPLACE "\\[[^]]*\\]" "" variables "${CMAKE_MATCH_2}")
            string(REGEX REPLACE "[ \n]*,[ \n]*" ";" variables "${variables}")
            foreach(variable ${variables})
                string(APPEND arrays "    {\"${variable}\", \"${type}\", offsetof(${name}, ${variable}), sizeof(${type})},\n")
            endforeach()
        endforeach()
        string(APPEND arrays "};\n")
        string(APPEND rows "    {\"${name}\", sizeof(${name}), k${name}},\n")
    endforeach()
endforeach()
file(WRITE ${OUTPUT} "// Made of shaders/shared/*.h by app/list_shared_structs.cmake.
#include \"core/gl/shared_structs.hpp\"

${includes}
namespace meltpool::gl {

namespace {

${arrays}constexpr SharedStruct kAll[] = {
${rows}};

} // namespace

std::span<const SharedStruct> sharedStructs() {
    return kAll;
}

} // namespace meltpool::gl
")
