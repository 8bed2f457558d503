// Tests the automatic choice of detail for a machine's pictures.
#include "app/desktop/detail_choice.hpp"
#include "tests/support/catch.hpp"

#include <array>

namespace meltpool {

namespace {

constexpr double kFrame = 1.0 / 60;

/// Returns the level for a card whose pictures take these shares of the frame at each level, and the number of pictures
/// until then.
std::pair<PictureDetail, int> foundBy(DetailTrial& trial, const std::array<double, 3>& shares) {
    int pictures = 0;
    for (; !trial.settled() && pictures < 1000; ++pictures)
        trial.add(shares[static_cast<size_t>(trial.level())] * kFrame, kFrame);
    return {trial.level(), pictures};
}

} // namespace

TEST_CASE("on a software driver the automatic detail is low from the first picture on") {
    DetailTrial trial(true);
    CHECK(trial.level() == kLowDetail);
    CHECK(trial.settled());
    trial.restart();
    CHECK(trial.settled());
}

TEST_CASE("a card gets the highest detail of which a picture takes its share of the frame") {
    DetailTrial trial(false);
    CHECK(trial.level() == kHighDetail);
    CHECK_FALSE(trial.settled());
    CHECK(foundBy(trial, {0.05, 0.1, 0.3}).first == kHighDetail);
    trial.restart();
    CHECK(foundBy(trial, {0.1, 0.3, 0.5}).first == kMediumDetail);
    trial.restart();
    const auto [level, pictures] = foundBy(trial, {2, 3, 4});
    CHECK(level == kLowDetail);
    CHECK(pictures < 60); // within a second
}

TEST_CASE("the first pictures of a level and slow ones among the others do not count") {
    DetailTrial trial(false);
    for (int i = 0; i < 5; ++i)
        trial.add(10 * kFrame, kFrame); // the driver compiles its programs
    for (int i = 0; !trial.settled(); ++i)
        trial.add((i % 2 == 0 ? 0.2 : 0.9) * kFrame, kFrame);
    CHECK(trial.level() == kHighDetail);
}

TEST_CASE("a detail that is set is taken, and the trial begins again with the next lesson") {
    DetailChoice choice(true);
    CHECK(choice.level() == kLowDetail);
    for (const PictureDetail level : {kLowDetail, kMediumDetail, kHighDetail}) {
        choice.update(1 + level, true, false);
        CHECK(choice.level() == level);
    }
    choice.update(0, true, false);
    CHECK(choice.level() == kLowDetail);
    CHECK(detailChoices().size() == 4);
    CHECK(detailSentence(kHighDetail).empty());
    CHECK(detailSentence(kLowDetail) == "low detail");
}

} // namespace meltpool
