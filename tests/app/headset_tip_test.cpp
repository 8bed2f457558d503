// The tip of the torch in the hand: each process's own one in every controller, the measured one, and back again.
#include "app/headset/headset_hands.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "xr/hold.hpp"

#include <glm/geometric.hpp>

using namespace meltpool;

namespace {

constexpr double kTipFrame = 1.0 / 90;

/// A controller whose grip leans by this angle (rad) from its pointer.
struct LeaningController {
    float lean;
    bool right;

    xr::HandInput held(const xr::Pose& grip) const {
        xr::HandInput hand;
        hand.present = hand.tracked = true;
        hand.grip = hand.aim = hand.hold = grip;
        hand.aim.orientation = glm::normalize(grip.orientation * glm::angleAxis(lean, glm::vec3(1, 0, 0)));
        hand.hold.orientation = glm::normalize(grip.orientation * xr::holdRotation(hand.grip, hand.aim));
        return hand;
    }
};

/// The person with this controller in the torch's hand, and nothing in the other.
class TipWearer {
  public:
    TipWearer(const LeaningController& controller, const std::filesystem::path& folder)
        : controller_(controller), hands_(parameters_, folder) {
        parameters_.hand = controller.right ? HeadsetParameters::kRight : HeadsetParameters::kLeft;
    }

    HeadsetHands& hands() { return hands_; }
    const xr::Pose& hold(const xr::Pose& grip, const TorchGeometry& torch, double seconds = kTipFrame) {
        held_ = controller_.held(grip);
        for (double time = 0; time < seconds; time += kTipFrame)
            hands_.update({controller_.right ? &none_ : &held_, controller_.right ? &held_ : &none_}, {}, Workshop(),
                          torch, kTipFrame);
        return hands_.torch().tip();
    }
    /// True if the tip is that of this torch's drawn form, held along the hand.
    bool isOwn(const TorchGeometry& torch) const {
        const xr::Pose own = Workshop().toWorkshop(held_.hold) * xr::Pose{torch.tipOrientation(), torch.tip()};
        const xr::Pose& tip = hands_.torch().tip();
        return glm::distance(own.position, tip.position) < 1e-5f &&
               std::abs(glm::dot(own.orientation, tip.orientation)) > 0.99999f;
    }

  private:
    LeaningController controller_;
    HeadsetParameters parameters_;
    HeadsetHands hands_;
    xr::HandInput held_, none_;
};

TorchGeometry torchOfKind(int kind) {
    ProcessSettings process;
    process.kind = kind;
    return torchGeometry(process);
}

} // namespace

TEST_CASE("each process's torch has its own tip in every controller of either hand, until another is measured by "
          "holding still",
          "[app]") {
    const LeaningController controller{GENERATE(0.0f, 0.35f, 0.7f, 1.05f), GENERATE(true, false)};
    const std::filesystem::path folder = test::scratchFolder("own-tip");
    const xr::Pose grip{glm::angleAxis(-0.4f, glm::normalize(glm::vec3(1, 0.2f, 0))), {0.1f, 1.1f, 0.1f}};
    const xr::Pose upright{glm::angleAxis(-1.2f, glm::vec3(1, 0, 0)), {0.1f, 1.2f, 0.1f}};
    for (int kind = 0; kind < int(AllProcesses::kCount); ++kind) {
        INFO(AllProcesses::kNames[static_cast<size_t>(kind)] << ", lean " << controller.lean);
        const TorchGeometry torch = torchOfKind(kind);
        TipWearer person(controller, folder);
        person.hold(grip, torch);
        CHECK_FALSE(person.hands().tipMeasured());
        CHECK(person.isOwn(torch));

        person.hands().measureAxis();
        person.hold(upright, torch, 9);
        CHECK_THAT(person.hands().tipReport(), test::containsText("direction was found"));
        REQUIRE(person.hands().tipMeasured());
        const xr::Pose measured = person.hold(upright, torch);
        CHECK(glm::dot(measured.orientation * glm::vec3(0, 0, -1), glm::vec3(0, -1, 0)) > 0.9999f);
        CHECK(glm::distance(person.hold(upright, torchOfKind((kind + 1) % int(AllProcesses::kCount))).position,
                            measured.position) < 1e-5f); // one measured tip for all torches
        CHECK(std::filesystem::exists(folder / "torch-tip.txt"));
        CHECK(TipWearer(controller, folder).hands().tipMeasured()); // the next start of the program

        person.hands().useOwnTip();
        CHECK_THAT(person.hands().tipReport(), test::containsText("its own tip again"));
        CHECK_FALSE(person.hands().tipMeasured());
        CHECK_FALSE(std::filesystem::exists(folder / "torch-tip.txt"));
        for (int other = 0; other < int(AllProcesses::kCount); ++other) {
            person.hold(grip, torchOfKind(other));
            CHECK(person.isOwn(torchOfKind(other)));
        }
    }
}

TEST_CASE("a torch that was not held still keeps the tip it had", "[app]") {
    const std::filesystem::path folder = test::scratchFolder("own-tip-moved");
    const TorchGeometry torch = torchOfKind(0);
    TipWearer person({0.7f, true}, folder);
    person.hands().measureAxis();
    for (int frame = 0; frame < 9 * 90; ++frame) // turned to and fro by a radian
        person.hold({glm::angleAxis(std::sin(0.1f * float(frame)), glm::vec3(1, 0, 0)), {0, 1.2f, 0}}, torch);
    CHECK_THAT(person.hands().tipReport(), test::containsText("not held still"));
    CHECK_FALSE(person.hands().tipMeasured());
    CHECK(person.isOwn(torch));
}

TEST_CASE("only the other hand's controller: the missing one is named, with the way to change hands", "[app]") {
    HeadsetParameters parameters;
    HeadsetHands hands(parameters, test::scratchFolder("other-alone"));
    xr::HandInput left, right;
    const auto frame = [&] { hands.update({&left, &right}, {}, Workshop(), kPlainTorch, kTipFrame); };
    frame();
    CHECK(hands.warning().empty()); // none is there yet
    left.present = left.tracked = true;
    frame();
    CHECK_THAT(std::string(hands.warning()), test::containsText("right hand, whose controller is off"));
    CHECK_THAT(std::string(hands.warning()), test::containsText("choose the left hand"));
    parameters.hand = HeadsetParameters::kLeft;
    frame();
    CHECK(hands.warning().empty());
    parameters.hand = HeadsetParameters::kRight;
    right.present = right.tracked = true;
    frame();
    CHECK(hands.warning().empty());
    right.present = right.tracked = false;
    frame();
    CHECK_THAT(std::string(hands.warning()), !test::containsText("controller is off")); // it was there: out of sight
}
