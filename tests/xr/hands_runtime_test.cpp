// Tests the torch in the hand on a real runtime: the tip of each process's own torch is at the joint, and both eyes see
// torch and hands with medium and high detail.
#include "core/base/text.hpp"
#include "core/training/lesson/lesson.hpp"
#include "tests/support/catch.hpp"
#include "tests/xr/trainee.hpp"

#include <glm/geometric.hpp>

#include <string>

using namespace meltpool;
using namespace meltpool::test;
using nlohmann::json;

namespace {

namespace fs = std::filesystem;

/// Writes the plate's lesson for another process.
fs::path plateWith(const fs::path& folder, const std::string& process) {
    const fs::path file = plateLesson(folder);
    std::string text = readTextFile(file);
    const size_t from = text.find("process = \"gmaw\""), to = text.find("[surface]");
    REQUIRE(from < to);
    if (process != "gmaw")
        writeTextFileAtomically(file, text.replace(from, to - from, "process = \"" + process + "\"\n"));
    return file;
}

/// Returns a torch that leans 10 degrees to the welder, its handle to the right and back.
glm::quat heldFromTheRight() {
    const glm::vec3 back = glm::normalize(glm::vec3(0, 1, 0.18f)), aside(0.75f, 0, 0.65f);
    const glm::vec3 down = -glm::normalize(aside - back * glm::dot(aside, back));
    return glm::quat_cast(glm::mat3(glm::cross(down, back), down, back));
}

} // namespace

TEST_CASE("the tip of each process's own torch is at the joint, and both eyes see torch and hands", "[runtime]") {
    handGeometry();
    const std::string process = GENERATE("gmaw", "gtaw", "smaw");
    const std::string detail = process == "gmaw" ? "medium" : "high";
    const fs::path folder = runFolder() / ("hands-" + process);
    const fs::path file = plateWith(folder, process);
    Trainee trainee;
    trainee.bottom = makeWorkpiece(readLesson(file).workpiece).low.y;
    trainee.zoom = 1;
    trainee.take(process);
    trainee.held = heldFromTheRight();
    // The left hand is palm down, with the rod to the joint.
    const glm::vec3 back = glm::normalize(glm::vec3(-1, 0.35f, 0.2f));
    const glm::vec3 up = glm::normalize(glm::cross(glm::cross(back, glm::vec3(0, 1, 0)), back));
    const xr::Pose rod{glm::quat_cast(glm::mat3(-up, glm::cross(back, -up), back)),
                       trainee.inRoom({-0.004f, 0.001f, 0}) + back * 0.30f};
    trainee.state.hands[0].pose = rod * handGeometry().grip.inverse();
    TrainerProcess trainer(folder, {"--headset", "--lesson", file.string()}, {}, {}, "detail = \"" + detail + "\"\n");
    REQUIRE(trainer.waitFor(ready));
    trainee.state.head.position = {0, 1.55f, 0};
    trainee.state.head.orientation = glm::angleAxis(-0.85f, glm::vec3(1, 0, 0));
    const Image before = settledEye(trainer, 0);
    trainee.aim({0, 0.003f, 0}, 0.0f);
    CHECK(trainer.waitFor([](const json& row) {
        const json& mm = row["torch"]["tip_mm"];
        return glm::length(glm::vec3(mm[0], mm[1].get<float>() - 3, mm[2])) < 0.5f;
    }));
    CHECK(eyeComesTo(trainer, 0, before, [](double share) { return share > 0.05; }));
    settledEye(trainer, 0);
    keepPicture(screenshot(), "hands-" + process + ".png");
    CHECK(trainer.stop() == 0);
    CHECK(trainer.misuses() == "");
}
