// The cell-sorted grid: every particle once, cells in order, a fixed order inside a cell, and no missed neighbour.
#include "core/base/text.hpp"
#include "core/gl/buffer_view.hpp"
#include "core/metal/classic/cell_order.hpp"
#include "shaders/shared/classic.h"
#include "shaders/shared/dispatch.h"
#include "tests/metal/classic/classic_twin.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

namespace meltpool {

namespace {

/// The buffers that a sort reads and writes, without a model.
struct SortBench {
    SortBench(const ClassicMetal::Snapshot& state, const std::vector<uint>& numbers, float h)
        : count(numbers.size()),
          order(test::shaders(), count),
          step("step", sizeof(ClassicStep)),
          positions("positions", std::span(state.positions)),
          velocities("velocities", std::span(state.velocities)),
          moved("numbers", std::span(numbers)),
          sortedPositions("sorted positions", count * sizeof(vec4)),
          sortedVelocities("sorted velocities", count * sizeof(vec4)),
          sorted("sorted", count * sizeof(uint)) {
        order.setGrid(CellGrid::forRadius(h, count));
        ClassicStep values{};
        values.supportRadius = h;
        values.cellsPerUnit = order.grid().cellsPerUnit;
        values.cellsPerAxis = order.grid().perAxis;
        values.particles = uint(count);
        step.writeValue(values);
        step.bindUniform(CLASSIC_STEP);
        positions.bindStorage(CLASSIC_MOVED_POSITIONS);
        velocities.bindStorage(CLASSIC_MOVED_VELOCITIES);
        moved.bindStorage(CLASSIC_MOVED_NUMBERS);
        sortedPositions.bindStorage(CLASSIC_SORTED_POSITIONS);
        sortedVelocities.bindStorage(CLASSIC_SORTED_VELOCITIES);
        sorted.bindStorage(CLASSIC_SORTED_NUMBERS);
        order.bind();
        order.sort(nullptr);
    }

    size_t count;
    CellOrder order;
    gl::Buffer step, positions, velocities, moved, sortedPositions, sortedVelocities, sorted;
};

uint cellOf(const glm::vec4& place, const CellGrid& grid) {
    uint index = 0;
    for (int axis = 2; axis >= 0; --axis) {
        const int cell = std::clamp(int((place[axis] + 1.0F) * grid.cellsPerUnit), 0, int(grid.perAxis) - 1);
        index = index * grid.perAxis + uint(cell);
    }
    return index;
}

std::vector<uint> shuffledNumbers(size_t count) {
    std::vector<uint> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0U);
    std::shuffle(numbers.begin(), numbers.end(), std::mt19937(5));
    return numbers;
}

/// Adds up the neighbours, each by its place in cell order, in the walk that density and forces use.
const char* kNeighbourShader = R"(#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "metal/classic/neighbours.glsl"
layout(local_size_x = GROUP_SIZE) in;
layout(std430, binding = 14) writeonly buffer Found { uvec2 found[]; };
void main() {
    const uint i = linearInvocation();
    if (i >= now.particles) return;
    const vec3 place = texelFetch(positionTexels, int(i)).xyz;
    uvec2 sum = uvec2(0);
    for (int row = 0; row < kRows; ++row) {
        const uvec2 range = rangeOfRow(cellOf(place), row);
        for (uint j = range.x; j < range.y; ++j)
            if (distance(place, texelFetch(positionTexels, int(j)).xyz) <= now.supportRadius)
                sum += uvec2(1u, (j + 1u) * (j + 1u));
    }
    found[i] = sum;
}
)";

std::vector<uvec2> neighboursOnGpu(const SortBench& bench, const gl::Defines& defines) {
    const auto folder = test::scratchFolder("neighbour shader");
    std::filesystem::copy(test::shaders().root(), folder, std::filesystem::copy_options::recursive);
    writeTextFileAtomically(folder / "neighbours.comp", kNeighbourShader);
    gl::ShaderLibrary library(folder);
    const gl::BufferView texels("positions", bench.sortedPositions, GL_RGBA32F, sizeof(vec4));
    texels.bind(CLASSIC_POSITION_TEXELS);
    const gl::Buffer found("found", bench.count * sizeof(uvec2));
    found.bindStorage(14);
    library.compute("neighbours.comp", defines).dispatch(bench.count, GROUP_SIZE);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    return found.read<uvec2>(bench.count);
}

} // namespace

TEST_CASE("the sort keeps every particle and puts cells and numbers in order") {
    test::context();
    for (const size_t count : {size_t(1), size_t(63), size_t(65), size_t(1234), size_t(20032)}) {
        const auto state = test::livelyState(count, 2.0, 3);
        const auto numbers = shuffledNumbers(count);
        SortBench bench(state, numbers, 0.05F);
        const auto positions = bench.sortedPositions.read<glm::vec4>(count);
        const auto velocities = bench.sortedVelocities.read<glm::vec4>(count);
        const auto sorted = bench.sorted.read<uint>(count);

        std::vector<size_t> expected(count);
        std::iota(expected.begin(), expected.end(), size_t(0));
        const CellGrid grid = bench.order.grid();
        std::sort(expected.begin(), expected.end(), [&](size_t a, size_t b) {
            return std::pair(cellOf(state.positions[a], grid), numbers[a]) <
                   std::pair(cellOf(state.positions[b], grid), numbers[b]);
        });
        size_t wrong = 0;
        for (size_t slot = 0; slot < count; ++slot) {
            const size_t from = expected[slot];
            const bool right = sorted[slot] == numbers[from] && positions[slot] == state.positions[from] &&
                               velocities[slot] == state.velocities[from];
            wrong += right ? 0U : 1U;
        }
        CHECK(wrong == 0);

        const auto starts = bench.order.cellStarts().read<uint>(grid.cells() + 1);
        std::vector<uint> expectedStarts(grid.cells() + 1, 0U);
        for (const glm::vec4& place : state.positions)
            ++expectedStarts[cellOf(place, grid) + 1];
        std::partial_sum(expectedStarts.begin(), expectedStarts.end(), expectedStarts.begin());
        CHECK(starts == expectedStarts);
    }
}

TEST_CASE("a cell may hold everyone") {
    test::context();
    auto state = test::livelyState(1234, 0.001, 4);
    const auto numbers = shuffledNumbers(1234);
    SortBench bench(state, numbers, 1.0F);
    auto sorted = bench.sorted.read<uint>(1234);
    CHECK(std::set<uint>(sorted.begin(), sorted.end()).size() == 1234);
}

TEST_CASE("the grid finds the neighbours that all pairs find") {
    test::context();
    for (const size_t count : {size_t(1), size_t(63), size_t(65), size_t(1234), size_t(20032)})
        for (const float h : {0.05F, 0.11F}) {
            if (count > 2000 && h > 0.1F) continue;
            SortBench bench(test::livelyState(count, count > 2000 ? 1.0 : 2.0, 9), shuffledNumbers(count), h);
            const auto byGrid = neighboursOnGpu(bench, {});
            CHECK(byGrid == neighboursOnGpu(bench, {{"ALL_PAIRS", "1"}}));
            CHECK(std::all_of(byGrid.begin(), byGrid.end(), [](uvec2 found) { return found.x >= 1; }));
        }
}

TEST_CASE("neighbours on the faces of cells and of the box are found") {
    test::context();
    ClassicMetal::Snapshot state; // a lattice with rows on the cells' faces and on the walls
    for (int z = -4; z <= 4; ++z)
        for (int y = -4; y <= 4; ++y)
            for (int x = -4; x <= 4; ++x)
                state.positions.emplace_back(0.25F * glm::vec3(x, y, z), 0.0F);
    state.velocities.resize(state.positions.size(), glm::vec4(0));
    SortBench bench(state, shuffledNumbers(state.positions.size()), 0.25F);
    const auto byGrid = neighboursOnGpu(bench, {});
    CHECK(byGrid == neighboursOnGpu(bench, {{"ALL_PAIRS", "1"}}));
    const auto most = std::max_element(byGrid.begin(), byGrid.end(), [](uvec2 a, uvec2 b) { return a.x < b.x; });
    CHECK(most->x == 7);
}

} // namespace meltpool
