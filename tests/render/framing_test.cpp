// Framing: a camera moves no more than it must to show points beside the panels.
#include "core/render/framing.hpp"
#include "tests/support/catch.hpp"

#include <glm/vec4.hpp>

#include <array>

namespace meltpool {

TEST_CASE("a camera that shows all points stays; others move aside first, and away only if that is not enough") {
    const OrbitCamera wanted(0.5f, 0.4f, 3);
    const Lens lens;
    const std::array<glm::vec3, 2> small{glm::vec3(-0.1f, 0, 0), glm::vec3(0.1f, 0, 0)};
    CHECK(framed(wanted, lens, 1.5f, {}, small) == wanted);
    CHECK(framed(wanted, lens, 1.5f, {}, {}) == wanted);
    CHECK(framed(wanted, lens, 1.5f, {0.5f, 0.5f, 0, 0}, small) == wanted); // nothing is uncovered

    const std::array<glm::vec3, 2> aside{glm::vec3(-0.1f, 2, 0), glm::vec3(0.1f, 2, 0)};
    const OrbitCamera raised = framed(wanted, lens, 1.5f, {}, aside);
    CHECK(raised.distance() == wanted.distance());
    CHECK(raised.target() != wanted.target());

    const std::array<glm::vec3, 2> wide{glm::vec3(-4, 0, 0), glm::vec3(4, 0, 0)};
    const OrbitCamera back = framed(wanted, lens, 1.5f, {0, 0.3f, 0.1f, 0.1f}, wide);
    CHECK(back.distance() > wanted.distance());
    const View view = back.view(lens, 1.5f);
    for (const glm::vec3& point : wide) {
        const glm::vec4 clip = view.eyeToClip * view.worldToEye * glm::vec4(point, 1);
        const float x = clip.x / clip.w - 0.3f; // the picture's middle is that of the uncovered part
        CHECK(x > -1);
        CHECK(x < 1 - 2 * 0.3f);
    }

    const CoveredEdges replay{0, 0, 0.5f, 0.1f}; // a panel covers the lower half
    const std::array<glm::vec3, 2> tall{glm::vec3(0, -1, 0), glm::vec3(0, 1, 0)};
    const View over = framed(wanted, lens, 1.5f, replay, tall).view(lens, 1.5f);
    for (const glm::vec3& point : tall) {
        const glm::vec4 clip = over.eyeToClip * over.worldToEye * glm::vec4(point, 1);
        const float y = clip.y / clip.w + replay.lift();
        CHECK(y > -1 + 2 * replay.bottom);
        CHECK(y < 1 - 2 * replay.top);
    }
}

TEST_CASE("the uncovered part of a picture is the whole of its own clip space") {
    const CoveredEdges covered{0.1f, 0.3f, 0.25f, 0.05f};
    const glm::vec4 low = covered.uncovered() * (2.0f * glm::vec4(-1 + 2 * 0.1f, -1 + 2 * 0.25f, 0, 1));
    CHECK(low.x / low.w == Approx(-1));
    CHECK(low.y / low.w == Approx(-1));
    const glm::vec4 high = covered.uncovered() * glm::vec4(1 - 2 * 0.3f, 1 - 2 * 0.05f, 0.5f, 1);
    CHECK(high.x == Approx(1));
    CHECK(high.y == Approx(1));
    CHECK(high.z == 0.5f);
    CHECK(CoveredEdges{0.5f, 0.5f, 0, 0}.uncovered() == glm::mat4(1)); // nothing is uncovered
}

} // namespace meltpool
