// The wrappers of core/gl: buffers preserve their contents, dispatches cover every index, shader errors name file and
// line.
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/gl/buffer.hpp"
#include "core/gl/order.hpp"
#include "core/gl/profiler.hpp"
#include "core/gl/readback.hpp"
#include "core/gl/software_driver/software_driver.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace meltpool::gl {

namespace {

const char* kCountShader = R"(#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "shared/dispatch.h"
layout(local_size_x = GROUP_SIZE) in;
layout(std430, binding = 0) buffer Values { uint values[]; };
uniform uint count;
void main() {
    uint i = linearInvocation();
    if (i < count) values[i] += i + OFFSET;
}
)";

/// Makes a separate shader folder with the shared headers and one shader.
std::filesystem::path shaderFolder(const std::string& shader) {
    const auto folder = test::scratchFolder("shaders");
    std::filesystem::copy(test::testFolder() / ".." / "shaders" / "shared", folder / "shared");
    writeTextFileAtomically(folder / "count.comp", shader);
    return folder;
}

} // namespace

TEST_CASE("a buffer starts at zero and keeps what is written") {
    test::context();
    Buffer buffer("test", 40);
    CHECK(buffer.read<unsigned>(10) == std::vector<unsigned>(10, 0u));
    std::vector<unsigned> values(10);
    std::iota(values.begin(), values.end(), 5u);
    buffer.write(std::span<const unsigned>(values));
    CHECK(buffer.read<unsigned>(10) == values);
    CHECK_THROWS_AS(buffer.read<unsigned>(11), RuntimeFault);
    CHECK_THROWS_AS(buffer.write(std::span<const unsigned>(values), 4), RuntimeFault);
}

TEST_CASE("a buffer of another size keeps its bytes as far as they reach and is zero behind them") {
    test::context();
    const std::vector<unsigned> values{3, 1, 4, 1, 5};
    for (const bool onlyGpu : {false, true}) {
        Buffer source("source", std::span<const unsigned>(values));
        Buffer buffer = onlyGpu ? Buffer::gpuOnly("test", 20) : Buffer("test", 20);
        source.copyTo(buffer, 20);
        buffer.resize(32);
        CHECK(buffer.bytes() == 32);
        CHECK(buffer.read<unsigned>(8) == std::vector<unsigned>{3, 1, 4, 1, 5, 0, 0, 0});
        buffer.resize(8);
        CHECK(buffer.bytes() == 8);
        CHECK(buffer.read<unsigned>(2) == std::vector<unsigned>{3, 1});
        if (onlyGpu)
            CHECK_THROWS_AS(buffer.writeValue(1U), RuntimeFault);
        else
            CHECK_NOTHROW(buffer.writeValue(1U));
    }
}

TEST_CASE("a buffer of any number of bytes has whole words and is cleared without a complaint of the driver") {
    test::context();
    while (glGetError() != GL_NO_ERROR) {
    }
    const std::vector<std::uint8_t> odd{1, 2, 3, 4, 5};
    const gl::Buffer buffer("odd", std::span<const std::uint8_t>(odd));
    CHECK(glGetError() == GL_NO_ERROR);
    CHECK(buffer.bytes() == 8);
    CHECK(buffer.read<std::uint8_t>(8) == std::vector<std::uint8_t>{1, 2, 3, 4, 5, 0, 0, 0});
}

TEST_CASE("every dispatch is counted, and an indirect one takes its group counts from the buffer") {
    test::context();
    ShaderLibrary library(shaderFolder(kCountShader));
    const Program& program = library.compute("count.comp", {{"OFFSET", "7u"}});
    const Buffer values("values", 256 * 4);
    values.bindStorage(0);
    program.set("count", 256U);
    const std::vector<unsigned> groups{99, 99, 99, 2, 1, 1}; // the second command: two groups of 64
    const Buffer commands("commands", std::span<const unsigned>(groups));
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, commands.name());
    const std::uint64_t before = dispatchCount();
    program.dispatchIndirect(3 * sizeof(unsigned));
    CHECK(dispatchCount() == before + 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    const auto read = values.read<unsigned>(256);
    CHECK(read[127] == 127 + 7);
    CHECK(read[128] == 0);
    program.dispatch(256, 64);
    program.dispatch(0, 64); // no work
    CHECK(dispatchCount() == before + 2);
}

TEST_CASE("where dispatches end at once, a thread of its own reaches buffers without the driver, which sees the same") {
    test::context();
    if (!dispatchIsSynchronous()) return; // a card's driver guarantees nothing here
    ShaderLibrary library(shaderFolder(kCountShader));
    const Program& program = library.compute("count.comp", {{"OFFSET", "7u"}});
    program.set("count", 256U);
    std::vector<unsigned> ten(10);
    std::iota(ten.begin(), ten.end(), 5u);
    Buffer values("values", 256 * 4), written("written", 40), copied("copied", 40), filled("filled", 40),
        commands("commands", 24);
    Readback readback("readback", 40);
    CHECK(directMemory(values.name()) == nullptr);
    {
        const BarrierFreeThread barrierFree;
        REQUIRE(directMemory(values.name()) != nullptr);
        written.write(std::span<const unsigned>(ten));
        written.copyTo(copied, 36, 4, 0);
        filled.fill(9);
        fillWords(filled.name(), 8, 12, 3);
        const std::vector<unsigned> groups{99, 99, 99, 2, 1, 1};
        commands.write(std::span<const unsigned>(groups));
        values.bindStorage(0);
        glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, commands.name());
        program.dispatchIndirect(3 * sizeof(unsigned));
        CHECK(values.read<unsigned>(129)[127] == 127 + 7);
        CHECK(values.read<unsigned>(129)[128] == 0);
        readback.request(written);
    }
    CHECK(written.read<unsigned>(10) == ten);
    CHECK(copied.read<unsigned>(10) == std::vector<unsigned>{6, 7, 8, 9, 10, 11, 12, 13, 14, 0});
    CHECK(filled.read<unsigned>(10) == std::vector<unsigned>{9, 9, 3, 3, 3, 9, 9, 9, 9, 9});
    CHECK(values.read<unsigned>(256)[127] == 127 + 7);
    const auto taken = readback.poll<std::array<unsigned, 10>>();
    REQUIRE(taken);
    CHECK(std::equal(ten.begin(), ten.end(), taken->begin()));
}

TEST_CASE("a dispatch covers every index once, also beyond one axis") {
    test::context();
    ShaderLibrary library(shaderFolder(kCountShader));
    const Program& program = library.compute("count.comp", {{"OFFSET", "7u"}});
    for (const size_t count : {size_t(1), size_t(63), size_t(65), size_t(20032), size_t(5'000'011)}) {
        const Buffer buffer("values", count * 4);
        buffer.bindStorage(0);
        program.set("count", static_cast<unsigned>(count));
        program.dispatch(count, 64);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
        const auto values = buffer.read<unsigned>(count);
        size_t wrong = 0;
        for (size_t i = 0; i < count; ++i)
            wrong += values[i] != i + 7 ? 1u : 0u;
        CHECK(wrong == 0);
    }
}

TEST_CASE("a shader error names the file and the line, and a failed reload keeps the old program") {
    test::context();
    const auto folder = shaderFolder(kCountShader);
    ShaderLibrary library(folder);
    const Program& program = library.compute("count.comp", {{"OFFSET", "7u"}});
    const GLuint before = program.name();
    std::string broken = kCountShader;
    broken.replace(broken.find("i + OFFSET"), 10, "j + OFFSET");
    writeTextFileAtomically(folder / "count.comp", broken);
    std::filesystem::last_write_time(folder / "count.comp",
                                     std::filesystem::file_time_type::clock::now() + std::chrono::seconds(5));
    const auto failures = library.reloadChanged();
    REQUIRE(failures.size() == 1);
    CHECK_THAT(failures[0], test::containsText("count.comp:9"));
    CHECK(program.name() == before);
    CHECK(library.reloadChanged().empty());
    CHECK(library.standingFaults() == failures);
    writeTextFileAtomically(folder / "count.comp", kCountShader);
    std::filesystem::last_write_time(folder / "count.comp",
                                     std::filesystem::file_time_type::clock::now() + std::chrono::seconds(10));
    CHECK(library.reloadChanged().empty());
    CHECK(library.standingFaults().empty());
    CHECK_THROWS_AS(library.compute("missing.comp"), InputError);
}

TEST_CASE("the profiler reports nested passes without being asked to wait") {
    test::context();
    Profiler profiler;
    const Buffer buffer("work", 1 << 20);
    for (int frame = 0; frame < 10; ++frame) {
        profiler.beginFrame();
        {
            const Scope whole(&profiler, "whole");
            for (int part = 0; part < 2; ++part) {
                const Scope inner(&profiler, "part");
                buffer.clear();
            }
        }
        profiler.endFrame();
    }
    profiler.finish();
    REQUIRE(profiler.passes().size() == 2);
    CHECK(profiler.find("whole")->frames == 10);
    CHECK(profiler.find("part")->depth == 1);
    CHECK(profiler.find("part")->totalMs <= profiler.find("whole")->totalMs + 1e-3);
}

} // namespace meltpool::gl
