// The ghost as drawn: its words leave the pool free, face the eye and stay in the picture.
#include "core/training/feedback/ghost_shapes.hpp"

#include "core/scene/ghost_model.hpp"
#include "tests/support/catch.hpp"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

using namespace meltpool;

namespace {

struct Stage {
    Stage() {
        hand.place = 0.005;
        hand.direction = 1;
        hand.from = -0.04;
        hand.to = 0.04;
        moment.place = hand.place;
        moment.height = 3e-3;
        moment.torch.tip = {0.005F, 3e-3F, 0};
        moment.torch.orientation = glm::angleAxis(-glm::radians(90.0F), glm::vec3(1, 0, 0));
        gmaw.choose<Gmaw>();
        pool = glm::vec3(seam.at(hand.place).point);
    }

    CueEye eyeAt(float azimuth, float elevation, float distance) const {
        const float a = glm::radians(azimuth), e = glm::radians(elevation);
        return {pool + distance * glm::vec3(std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a)),
                {0, 1, 0}};
    }

    Seam seam = Seam::line({}, {1, 0, 0}, {0, 1, 0}, -0.05, 0.05);
    CuePose hand;
    GhostMoment moment;
    ProcessSettings gmaw;
    glm::vec3 pool;
    GhostWords words{{2e-3, -0.2, 0.1, 0}, GhostPace::place};
};

/// Returns the number of torch parts, which precede the words.
size_t partsOfTorch(std::span<const Marker> markers) {
    size_t count = 0;
    while (count < markers.size() && markers[count].face < 1)
        ++count;
    return count;
}

} // namespace

TEST_CASE("the ghost's words hide no part of the pool's disc from a camera or from either of two eyes", "[training]") {
    Stage stage;
    GhostShapes shapes;
    for (const int direction : {-1, 0, 1})
        for (const float azimuth : {-70.0F, 0.0F, 40.0F})
            for (const float elevation : {15.0F, 45.0F, 75.0F})
                for (const float distance : {0.06F, 0.25F, 0.45F}) {
                    INFO(direction << ", eye at " << azimuth << " " << elevation << " " << distance);
                    stage.hand.direction = direction;
                    const CueEye eye = stage.eyeAt(azimuth, elevation, distance);
                    const auto markers = shapes.build(stage.moment, stage.words, stage.gmaw, stage.seam,
                                                      {1, 1, stage.hand, "expert"}, eye, glm::mat4(1));
                    const size_t torch = partsOfTorch(markers);
                    CHECK(torch >= 3);
                    CHECK(markers.size() > torch + 50);
                    const glm::vec3 apart =
                        glm::normalize(glm::cross(eye.up, eye.position - stage.pool)) * (0.128F * distance);
                    int covering = 0;
                    for (const Marker& marker : markers.subspan(torch))
                        for (const float x : {-0.5F, 0.5F})
                            for (const float y : {-0.5F, 0.0F, 0.5F})
                                for (const float side : {-1.0F, 0.0F, 1.0F})
                                    covering += coversDisc(eye.position + apart * side,
                                                           glm::vec3(marker.toWorld * glm::vec4(x, y, 0, 1)),
                                                           stage.pool, {0, 1, 0}, static_cast<float>(kPoolDisc))
                                                    ? 1
                                                    : 0;
                    CHECK(covering == 0);
                }
}

TEST_CASE("the words stand where the torch came from, and on the other side where the picture ends", "[training]") {
    Stage stage;
    GhostShapes shapes;
    CueEye eye = stage.eyeAt(0, 40, 0.2F);
    const auto middleOf = [&](float turn) {
        const glm::mat4 look = glm::lookAt(eye.position, stage.pool + glm::vec3(turn, 0, 0), eye.up);
        eye.toClip = glm::perspective(0.7F, 1.5F, 0.01F, 10.0F) * look;
        const auto markers =
            shapes.build(stage.moment, stage.words, stage.gmaw, stage.seam, {1, 1, stage.hand}, eye, glm::mat4(1));
        return (glm::vec3(markers[partsOfTorch(markers)].toWorld[3]) - stage.pool).x; // place of the words' background
    };
    CHECK(middleOf(0) < -5e-3F);
    CHECK(middleOf(0.06F) > 5e-3F);
    stage.hand.direction = -1;
    CHECK(middleOf(0) > 5e-3F);
}

TEST_CASE("the words stand above the cues' board if that is on their side", "[training]") {
    const Stage stage;
    GhostShapes shapes;
    const CueEye eye = stage.eyeAt(0, 40, 0.2F);
    // Returns the lower edge of the words' background over the pool, as a share of the eye's distance.
    const auto lowerEdge = [&](float boardSide) {
        const GhostLook look{1, 1, stage.hand, {}, boardSide};
        const auto markers = shapes.build(stage.moment, stage.words, stage.gmaw, stage.seam, look, eye, glm::mat4(1));
        const glm::mat4& ground = markers[partsOfTorch(markers)].toWorld;
        const glm::vec3 toEye = glm::normalize(eye.position - stage.pool);
        const glm::vec3 up = glm::cross(toEye, glm::normalize(glm::cross(eye.up, toEye)));
        return glm::dot(glm::vec3(ground * glm::vec4(0, -0.5F, 0, 1)) - stage.pool, up) / 0.2F;
    };
    CHECK(std::abs(lowerEdge(0)) < 0.01F);
    CHECK(std::abs(lowerEdge(1)) < 0.01F);
    CHECK(lowerEdge(-1) > kCueBoardHeight);
}

TEST_CASE("a ghost fades as a whole, and is gone in the end; without words only its torch is drawn", "[training]") {
    const Stage stage;
    GhostShapes shapes;
    const CueEye eye = stage.eyeAt(0, 40, 0.2F);
    const auto built = [&](double strength, const GhostWords& words) {
        const auto markers =
            shapes.build(stage.moment, words, stage.gmaw, stage.seam, {strength, 1, stage.hand}, eye, glm::mat4(1));
        return std::vector<Marker>(markers.begin(), markers.end());
    };
    const auto full = built(1, stage.words), half = built(0.5, stage.words);
    REQUIRE(full.size() == half.size());
    for (size_t i = 0; i < full.size(); ++i)
        CHECK(half[i].opacity == Approx(full[i].opacity / 2));
    CHECK(full.front().opacity <= kGhostOpacity);
    CHECK(built(0, stage.words).empty());
    const auto bare = built(1, {});
    CHECK(bare.size() == partsOfTorch(bare));
}

TEST_CASE("a ghost has its name beside its torch, to be read from both sides; a ghost that is gone has none",
          "[training]") {
    Stage stage;
    stage.moment.torch.tip.x = -0.02F; // the ghost goes its own way
    GhostShapes shapes;
    const auto built = [&](const CueEye& eye, std::string_view name, double strength = 1) {
        const auto markers =
            shapes.build(stage.moment, {}, stage.gmaw, stage.seam, {strength, 1, stage.hand, name}, eye, glm::mat4(1));
        return std::vector<Marker>(markers.begin(), markers.end());
    };
    for (const float azimuth : {0.0F, 60.0F, 180.0F})
        for (const float distance : {0.12F, 0.45F}) {
            INFO("eye at " << azimuth << " degrees, " << distance << " m");
            const CueEye eye = stage.eyeAt(azimuth, 40, distance);
            const std::vector<Marker> named = built(eye, "expert");
            const size_t torch = partsOfTorch(named);
            REQUIRE(named.size() > torch + 10);
            const glm::vec3 tip = stage.moment.torch.tip, toEye = glm::normalize(eye.position - tip);
            const glm::vec3 right = glm::normalize(glm::cross(eye.up, toEye)), up = glm::cross(toEye, right);
            for (size_t i = torch; i < named.size(); ++i) {
                const glm::vec3 off = glm::vec3(named[i].toWorld[3]) - tip;
                CHECK(glm::length(off) < 0.5F * distance);
                CHECK(glm::dot(off, up) > 0.1F * distance);
            }
            // It reads from left to right.
            const glm::vec3 first = named[torch + 1].toWorld[3], last = named.back().toWorld[3];
            CHECK(glm::dot(last - first, right) > 0.03F * distance);
        }
    const CueEye eye = stage.eyeAt(0, 40, 0.2F);
    CHECK(built(eye, "expert", 0).empty());
    const std::vector<Marker> nameless = built(eye, "");
    CHECK(nameless.size() == partsOfTorch(nameless));
}

TEST_CASE("a ghost's name is above the words beside the pool", "[training]") {
    Stage stage;
    GhostShapes shapes;
    const CueEye eye = stage.eyeAt(0, 40, 0.4F);
    const auto markers = shapes.build(stage.moment, stage.words, stage.gmaw, stage.seam, {1, 1, stage.hand, "expert"},
                                      eye, glm::mat4(1));
    std::vector<glm::mat4> grounds;
    for (const Marker& marker : markers.subspan(partsOfTorch(markers)))
        if (marker.colour.g < 0.1F) grounds.push_back(marker.toWorld);
    REQUIRE(grounds.size() == 2);
    const glm::vec3 up = glm::normalize(glm::vec3(grounds[0][1]));
    const auto edge = [&](const glm::mat4& ground, float side) {
        return glm::dot(glm::vec3(ground * glm::vec4(0, side / 2, 0, 1)), up);
    };
    CHECK(edge(grounds[1], -1) > edge(grounds[0], 1));
}

TEST_CASE("a covered electrode of a ghost ends over the seam however much of it its path has burned", "[training]") {
    Stage stage;
    GhostShapes shapes;
    ProcessSettings smaw;
    smaw.choose<Smaw>();
    for (const float below : {-2e-3F, 0.0F, 0.1F}) {
        stage.moment.torch.tip.y = -below; // tip of a whole electrode
        stage.moment.height = -static_cast<double>(below);
        float lowest = 1;
        for (const Marker& part : shapes.build(stage.moment, {}, smaw, stage.seam, {1, 1, stage.hand},
                                               stage.eyeAt(0, 40, 0.2F), glm::mat4(1)))
            for (const float end : {-0.5F, 0.5F})
                lowest = std::min(lowest, (part.toWorld * glm::vec4(0, 0, end, 1)).y);
        INFO(below);
        CHECK(lowest > 1e-3F);
        CHECK(lowest < 6e-3F);
    }
}
