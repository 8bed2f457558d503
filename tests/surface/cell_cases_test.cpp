// The 256 cases of a cell and the 16 of a face: closed towards every neighbour, turned outward, without loose
// triangles.
#include "core/surface/cell_cases.hpp"
#include "tests/support/catch.hpp"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <bit>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

namespace meltpool {

namespace {

using Segment = std::pair<CellEdge, CellEdge>;

unsigned lowCorner(CellEdge edge) {
    return edge & 7;
}
unsigned highCorner(CellEdge edge) {
    return lowCorner(edge) | 1U << (edge >> 3);
}

/// Returns every directed side of the case's triangles, with its count.
std::map<Segment, int> sidesOf(unsigned inside) {
    std::map<Segment, int> sides;
    for (const CellTriangle& t : cellTriangles(inside))
        for (std::size_t i = 0; i < 3; ++i)
            ++sides[{t[i], t[(i + 1) % 3]}];
    return sides;
}

/// Returns the sides that no other triangle of the cell has in the other direction.
std::set<Segment> openSides(unsigned inside) {
    const std::map<Segment, int> sides = sidesOf(inside);
    std::set<Segment> open;
    for (const auto& [side, times] : sides)
        if (!sides.contains({side.second, side.first})) open.insert(side);
    return open;
}

bool liesInFace(const Segment& side, unsigned axis, bool far) {
    for (const CellEdge edge : {side.first, side.second})
        for (const unsigned corner : {lowCorner(edge), highCorner(edge)})
            if (((corner >> axis & 1U) != 0) != far) return false;
    return true;
}

/// Returns the open sides in a face, named as from the near side of it.
std::set<Segment> sidesInFace(unsigned inside, unsigned axis, bool far) {
    std::set<Segment> found;
    const unsigned shift = far ? 1U << axis : 0U;
    for (const Segment& side : openSides(inside))
        if (liesInFace(side, axis, far)) found.insert({side.first & ~shift, side.second & ~shift});
    return found;
}

/// Returns the pattern of the face's corners, as bits of the near face's corners.
unsigned faceOf(unsigned inside, unsigned axis, bool far) {
    unsigned face = 0;
    for (unsigned corner = 0; corner < 8; ++corner)
        if (((corner >> axis & 1U) != 0) == far && (inside >> corner & 1U) != 0) face |= 1U << (corner & ~(1U << axis));
    return face;
}

glm::vec3 cornerPlace(unsigned corner) {
    return {float(corner & 1U), float(corner >> 1 & 1U), float(corner >> 2 & 1U)};
}

glm::vec3 areaVector(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    return glm::cross(b - a, c - a) * 0.5f;
}

} // namespace

TEST_CASE("every case has a vertex on each crossing edge and none elsewhere") {
    for (unsigned inside = 0; inside < 256; ++inside) {
        std::set<CellEdge> used;
        for (const CellTriangle& t : cellTriangles(inside))
            used.insert(t.begin(), t.end());
        for (unsigned axis = 0; axis < 3; ++axis)
            for (unsigned corner = 0; corner < 8; ++corner) {
                if ((corner >> axis & 1U) != 0) continue;
                const CellEdge edge = corner | axis << 3;
                const bool crossing = ((inside >> lowCorner(edge) ^ inside >> highCorner(edge)) & 1U) != 0;
                REQUIRE(used.contains(edge) == crossing);
            }
    }
}

TEST_CASE("no case repeats a directed side, and what a cell leaves open lies in its faces") {
    for (unsigned inside = 0; inside < 256; ++inside) {
        for (const auto& [side, times] : sidesOf(inside))
            REQUIRE(times == 1);
        for (const Segment& side : openSides(inside)) {
            int faces = 0;
            for (unsigned axis = 0; axis < 3; ++axis)
                faces += int(liesInFace(side, axis, false)) + int(liesInFace(side, axis, true));
            REQUIRE(faces == 1);
        }
        REQUIRE(cellTriangles(inside).size() <= kMostCellTriangles);
    }
}

TEST_CASE("no inner side lies in a face, where the neighbour could have the same one") {
    for (unsigned inside = 0; inside < 256; ++inside) {
        const std::set<Segment> open = openSides(inside);
        for (const auto& [side, times] : sidesOf(inside)) {
            if (open.contains(side)) continue;
            for (unsigned axis = 0; axis < 3; ++axis)
                REQUIRE_FALSE((liesInFace(side, axis, false) || liesInFace(side, axis, true)));
        }
    }
}

TEST_CASE("two cells agree on the segments in their common face, in opposite directions") {
    for (unsigned axis = 0; axis < 3; ++axis) {
        std::map<unsigned, std::set<Segment>> seen; // sides by the face's pattern, as in the cell before the face
        for (unsigned inside = 0; inside < 256; ++inside) {
            const auto [known, isNew] = seen.try_emplace(faceOf(inside, axis, true), sidesInFace(inside, axis, true));
            REQUIRE(known->second == sidesInFace(inside, axis, true));
        }
        REQUIRE(seen.size() == 16);
        for (unsigned inside = 0; inside < 256; ++inside) {
            std::set<Segment> reversed;
            for (const Segment& side : sidesInFace(inside, axis, false))
                reversed.insert({side.second, side.first});
            REQUIRE(seen.at(faceOf(inside, axis, false)) == reversed);
        }
    }
}

TEST_CASE("the surface around a single inside corner turns away from it") {
    for (unsigned corner = 0; corner < 8; ++corner) {
        const auto triangles = cellTriangles(1U << corner);
        REQUIRE(triangles.size() == 1);
        std::array<glm::vec3, 3> p{};
        for (std::size_t i = 0; i < 3; ++i)
            p[i] = (cornerPlace(lowCorner(triangles[0][i])) + cornerPlace(highCorner(triangles[0][i]))) * 0.5f;
        CHECK(glm::dot(areaVector(p[0], p[1], p[2]), p[0] - cornerPlace(corner)) > 0);
    }
}

TEST_CASE("a cell without thickness covers the inside part of its face: the 16 cases of a cap") {
    // The area depends on the number of inside corners with edges crossed in the middle; two opposite corners make two
    // triangles.
    const auto expectedArea = [](unsigned face) {
        const bool opposite = face == 0b0110 || face == 0b1001;
        const std::array<float, 5> areas{0.0f, 0.125f, opposite ? 0.25f : 0.5f, 0.875f, 1.0f};
        return areas[static_cast<std::size_t>(std::popcount(face))];
    };
    for (unsigned axis = 0; axis < 3; ++axis)
        for (const bool far : {false, true})
            for (unsigned face = 0; face < 16; ++face) {
                const unsigned u = 1U << (axis + 1) % 3, v = 1U << (axis + 2) % 3, side = far ? 1U << axis : 0U;
                unsigned inside = 0;
                for (unsigned i = 0; i < 4; ++i)
                    if ((face >> i & 1U) != 0) inside |= 1U << (side | ((i & 1U) != 0 ? u : 0U) | (i > 1 ? v : 0U));
                glm::vec3 sum(0.0f);
                float area = 0;
                for (const CellTriangle& t : cellTriangles(inside)) {
                    std::array<glm::vec3, 3> p{};
                    for (std::size_t i = 0; i < 3; ++i) {
                        p[i] = (cornerPlace(lowCorner(t[i])) + cornerPlace(highCorner(t[i]))) * 0.5f;
                        p[i][static_cast<int>(axis)] = float(far);
                    }
                    sum += areaVector(p[0], p[1], p[2]);
                    area += glm::length(areaVector(p[0], p[1], p[2]));
                }
                glm::vec3 outward(0.0f); // the empty layer is on the other side of the cell
                outward[static_cast<int>(axis)] = far ? -1.0f : 1.0f;
                REQUIRE(area == Approx(expectedArea(face)));
                REQUIRE(glm::dot(sum, outward) == Approx(expectedArea(face)));
            }
}

TEST_CASE("the packed table holds the same triangles") {
    const std::vector<std::uint32_t> table = cellCaseTable();
    for (unsigned inside = 0; inside < 256; ++inside) {
        const auto triangles = cellTriangles(inside);
        REQUIRE((table[inside] & 7U) == triangles.size());
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            const std::uint32_t word = table[(table[inside] >> 3) + i];
            REQUIRE(CellTriangle{word & 31U, word >> 5 & 31U, word >> 10 & 31U} == triangles[i]);
        }
    }
}

} // namespace meltpool
