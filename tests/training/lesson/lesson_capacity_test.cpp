// Lessons too large for memory or for the driver's buffers, refused in a sentence before any allocation.
#include "core/base/error.hpp"
#include "core/training/lesson/lesson_capacity.hpp"
#include "shaders/shared/flow.h"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

using namespace meltpool;
using meltpool::test::containsText;

namespace {

constexpr double kGiga = 1024.0 * 1024 * 1024;
constexpr double kTexelsOfParticle = FLOW_NEIGHBOUR_CAPACITY + 2; // texels of a particle's neighbour lists

/// Returns a lesson with 300,000 steel particles in the plate and capacity for the wire's.
Lesson fineBead() {
    Lesson lesson = findLesson("gmaw-bead", test::testFolder().parent_path() / "app" / "data" / "lessons");
    for (const auto& [key, value] :
         {std::pair{"length_mm", "50"}, {"width_mm", "25"}, {"thickness_mm", "30"}, {"spacing_mm", "0.5"}})
        lesson.set(key, value, "test");
    return lesson;
}

std::string refusal(const Lesson& lesson, const MetalCapacity& room) {
    try {
        requireCapacity(lesson, room);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST_CASE("a weld lesson beyond the driver's buffers is told how many particles these hold", "[training]") {
    const std::string told = refusal(fineBead(), {64 * kGiga, 100e3 * kTexelsOfParticle});
    CHECK_THAT(told, containsText("the lesson gmaw-bead would be 0.302 million particles in "));
    CHECK_THAT(told, containsText("the graphics driver's buffers hold 0.1 million; expected a larger spacing_mm"));
    CHECK(refusal(fineBead(), {64 * kGiga, 330e3 * kTexelsOfParticle}).empty());
}

TEST_CASE("a lesson beyond the free memory is told how much may be taken", "[training]") {
    const std::string told = refusal(fineBead(), {0.25 * kGiga, 1e12});
    CHECK_THAT(told, containsText("GiB, and 0.25 GiB may be taken; expected a larger spacing_mm"));
    Lesson classic = findLesson("classic", test::testFolder().parent_path() / "app" / "data" / "lessons");
    classic.set("particles", "4000000", "test");
    CHECK_THAT(refusal(classic, {0.25 * kGiga, 1}), containsText("4 million particles"));
    CHECK_THAT(refusal(classic, {0.25 * kGiga, 1}), containsText("expected fewer particles"));
    CHECK(refusal(classic, {64 * kGiga, 1}).empty()); // its buffers are no buffer textures
}

TEST_CASE("this machine has room for every shipped lesson, and its driver says its limit", "[training]") {
    test::context();
    const MetalCapacity room = machineCapacity();
    CHECK(room.bytes > 0);
    CHECK(room.bufferTexels >= 65536); // OpenGL's minimum for every driver
    for (const std::string& name : lessonNames(test::testFolder().parent_path() / "app" / "data" / "lessons"))
        CHECK_NOTHROW(
            requireCapacity(findLesson(name, test::testFolder().parent_path() / "app" / "data" / "lessons"), room));
}
