// The blocks of linked programs: all shipped ones have the layout of the C++ structs, and shaders of another version
// are refused with a sentence.
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/gl/block_layout.hpp"
#include "core/gl/program.hpp"
#include "shaders/shared/heat.h"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <algorithm>
#include <chrono>
#include <set>

namespace meltpool::gl {

namespace {

namespace fs = std::filesystem;

/// Copies the shipped shaders and replaces `before` in `file` by `after`.
fs::path changedShaders(const std::string& file, const std::string& before, const std::string& after) {
    const fs::path folder = test::scratchFolder("other-shaders");
    fs::copy(test::testFolder() / ".." / "shaders", folder, fs::copy_options::recursive);
    std::string text = readTextFile(folder / file);
    const size_t at = text.find(before);
    REQUIRE(at != std::string::npos);
    writeTextFileAtomically(folder / file, text.replace(at, before.size(), after));
    return folder;
}

/// Returns the sentence that refuses `shader` after that change; empty if the shader is accepted.
std::string refusal(const std::string& shader, const std::string& file, const std::string& before,
                    const std::string& after) {
    ShaderLibrary library(changedShaders(file, before, after));
    try {
        library.compute(shader);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

struct ShaderForm {
    std::string file;
    Defines defines;
};

/// Returns all shaders, each as a program of its own, in the variant that contains a block if only one does.
std::vector<ShaderForm> shippedShaders() {
    const fs::path root = test::testFolder() / ".." / "shaders";
    std::vector<ShaderForm> forms{{"surface/vertices.comp", {{"SURFACE_FREEZING", "1"}}}};
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root))
        if (const fs::path ending = entry.path().extension();
            ending == ".comp" || ending == ".vert" || ending == ".frag")
            forms.push_back({entry.path().lexically_relative(root).generic_string(), {}});
    return forms;
}

/// Returns the table of structs, each longer by a vector.
std::vector<SharedStruct> longerStructs() {
    std::vector<SharedStruct> structs(sharedStructs().begin(), sharedStructs().end());
    for (SharedStruct& each : structs)
        each.bytes += 16;
    return structs;
}

} // namespace

TEST_CASE("blocks with one member are found in GLSL text, whatever else it says") {
    const auto blocks = findBlocks("// uniform Told { Nothing here; }\n"
                                   "uniform uint count;\n"
                                   "layout(std140, binding = 1) uniform Frame {\n    FrameData frame; // why\n};\n"
                                   "layout(std430, binding = 2) readonly buffer Drops { Spark drops[]; };\n"
                                   "layout(std430) buffer Pair { uint a; uint b; };\n"
                                   "layout(std140) uniform Named { FrameData frame; } here;\n"
                                   "uniform samplerBuffer Texels;");
    REQUIRE(blocks.size() == 2);
    CHECK(blocks[0].name == "Frame");
    CHECK(blocks[0].type == "FrameData");
    CHECK(blocks[0].variable == "frame");
    CHECK_FALSE(blocks[0].storage);
    CHECK(blocks[1].name == "Drops");
    CHECK(blocks[1].type == "Spark");
    CHECK(blocks[1].storage);
}

TEST_CASE("the table of shared structs knows their sizes and places") {
    const auto structs = sharedStructs();
    const auto found =
        std::find_if(structs.begin(), structs.end(), [](const auto& s) { return s.name == "HeatBlock"; });
    REQUIRE(found != structs.end());
    CHECK(found->bytes == sizeof(HeatBlock));
    CHECK(found->members.back().name == "sources");
    CHECK(found->members.back().type == "HeatSourceData");
    CHECK(found->members.back().offset == offsetof(HeatBlock, sources));
    CHECK(found->members.back().bytes == sizeof(HeatSourceData));
}

TEST_CASE("all shipped shaders have the layout of this program, and each of their blocks is compared") {
    test::context();
    const std::vector<SharedStruct> longer = longerStructs();
    std::set<std::string> compared;
    for (const auto& [file, defines] : shippedShaders()) {
        INFO(file);
        const Program* program = nullptr;
        REQUIRE_NOTHROW(program = &test::shaders().load({file}, defines));
        for (const BlockDeclaration& block : findBlocks(loadShaderSource(test::shaders().root(), file, defines).text)) {
            CHECK(blockDifference(program->name(), block, sharedStructs()).empty());
            if (!blockDifference(program->name(), block, longer).empty()) compared.insert(block.type);
        }
    }
    // Structs that exist only inside others are left out: views, bodies, sources, and draw commands.
    const std::set<std::string> parts{"ViewData",    "ShadowBox",      "TorchPart",   "RolledPlate",
                                      "OxideIsland", "HeatSourceData", "SurfaceDraw", "SurfaceDispatch"};
    for (const SharedStruct& each : sharedStructs()) {
        INFO(each.name);
        CHECK(compared.count(std::string(each.name)) + parts.count(std::string(each.name)) == 1);
    }
}

TEST_CASE("a shader whose shared struct has another size is refused with file, block, both sizes and a remedy") {
    test::context();
    const std::string uniform = refusal("metal/heat/deposit.comp", "shared/heat.h", "    float timeStep; ",
                                        "    vec4 more;\n    float timeStep; ");
    CHECK_THAT(uniform, test::containsText("deposit.comp: block 'Heat' (struct HeatBlock) has "));
    CHECK_THAT(uniform, test::containsText(std::to_string(sizeof(HeatBlock) + 16) + " bytes, but " +
                                           std::to_string(sizeof(HeatBlock)) + " in this program"));
    CHECK_THAT(uniform, test::containsText("install it again, or set MELTPOOL_DATA"));
    CHECK_THAT(refusal("metal/heat/deposit.comp", "shared/heat.h", "    uint reserved;\n", "    uint reserved[5];\n"),
               test::containsText("block 'Tiles' (struct HeatTile) has 48 bytes an element, but 32 in this program"));
    CHECK_THAT(
        refusal("metal/solid/link_free.comp", "shared/metal.h", "    uint reserved;\n", "    uint reserved[5];\n"),
        test::containsText("block 'Counters' (struct MetalCounters) has 32 bytes, but 16 in this program"));
}

TEST_CASE("a shader whose shared struct has other members in the same bytes is refused too") {
    test::context();
    CHECK_THAT(
        refusal("metal/heat/deposit.comp", "shared/metal.h", "    float meltsAbove; ", "    float meltsFrom; "),
        test::containsText("block 'Metal' (struct MetalBlock) has a member 'meltsFrom' that this program does not"));
    CHECK_THAT(refusal("metal/heat/deposit.comp", "shared/heat.h",
                       "    float power;   // W\n    vec3 travel;   // unit vector of travel\n    float size; ",
                       "    float size;   // W\n    vec3 travel;   // unit vector of travel\n    float power; "),
               test::containsText("has 'sources[0].size' at byte 172, but at byte 188 in this program"));
    CHECK(refusal("metal/heat/deposit.comp", "shared/heat.h", "// s since the start", "// s").empty());
}

TEST_CASE("a reload with another layout is refused, and the old program runs on") {
    test::context();
    const fs::path folder = changedShaders("shared/heat.h", "// s since the start", "// s");
    ShaderLibrary library(folder);
    const Program& program = library.compute("metal/heat/deposit.comp");
    const GLuint before = program.name();
    std::string text = readTextFile(folder / "shared/heat.h");
    text.replace(text.find("    float timeStep; "), 0, "    vec4 more;\n");
    writeTextFileAtomically(folder / "shared/heat.h", text);
    fs::last_write_time(folder / "shared/heat.h", fs::file_time_type::clock::now() + std::chrono::seconds(5));
    const auto failures = library.reloadChanged();
    REQUIRE(failures.size() == 1);
    CHECK_THAT(failures[0], test::containsText("block 'Heat' (struct HeatBlock) has "));
    CHECK(library.standingFaults() == failures);
    CHECK(program.name() == before);
}

} // namespace meltpool::gl
