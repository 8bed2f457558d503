// Torch files with random damage: refused with file and sentence, or read as a path whose every sample is sound.
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/weld/torch/torch_path.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <cmath>
#include <fstream>
#include <random>

using namespace meltpool;

namespace {

/// Cuts, doubles, swaps or overwrites a few bytes.
std::string damaged(std::string text, std::mt19937& random) {
    const std::string alphabet = "0123456789.,;-+e#\n\r\t \"[]=nainf\\\xff\x01";
    const auto below = [&](size_t limit) { return random() % std::max<size_t>(1, limit); };
    for (size_t wounds = 1 + below(4); wounds > 0; --wounds) {
        const size_t at = below(text.size());
        switch (below(4)) {
        case 0:
            text.erase(at, 1 + below(6));
            break;
        case 1:
            text.insert(at, text.substr(below(text.size()), below(30)));
            break;
        case 2:
            text.insert(at, 1, alphabet[below(alphabet.size())]);
            break;
        default:
            if (!text.empty()) text[at] = alphabet[below(alphabet.size())];
        }
    }
    return text;
}

void checkSound(const TorchPath& path) {
    REQUIRE(std::isfinite(path.duration()));
    for (int i = -1; i <= 21; ++i) {
        const TorchSample s = path.sample(path.duration() * i / 20);
        REQUIRE(std::isfinite(s.tip.x + s.tip.y + s.tip.z));
        REQUIRE(glm::length(s.orientation) == Approx(1).margin(1e-3));
        REQUIRE(s.trigger >= 0);
        REQUIRE(s.trigger <= 1);
    }
}

/// Returns the number of damaged files that are accepted.
int survivors(const char* folder, const char* name, int tries) {
    const std::string whole = readTextFile(test::testFolder() / folder / name);
    const auto file = test::scratchFolder("fuzz") / name;
    std::mt19937 random(20);
    int taken = 0;
    for (int i = 0; i < tries; ++i) {
        const std::string text = damaged(whole, random);
        std::ofstream(file, std::ios::binary) << text; // not synced to the disk thousands of times
        INFO(text);
        try {
            checkSound(TorchPath::read(file));
            ++taken;
        } catch (const InputError& error) {
            REQUIRE_THAT(error.what(), test::containsText(name));
        }
    }
    return taken;
}

} // namespace

TEST_CASE("damaged torch files never give an unsound path", "[weld]") {
    for (const char* name : {"recorded.csv", "authored.toml"}) {
        const int taken = survivors("paths", name, 1500);
        // Both outcomes must occur.
        CHECK(taken > 10);
        CHECK(taken < 1490);
    }
}

TEST_CASE("damaged tables of other programs never give an unsound path", "[weld]") {
    for (const char* name : {"excel-german.csv", "excel-unicode-text.txt", "quoted-cells.csv", "sep-line.csv",
                             "lone-cr.csv", "motion-capture.tsv", "epoch-microseconds.csv", "rows-without-pose.csv"}) {
        INFO(name);
        const int taken = survivors("data/brought", name, 400);
        CHECK(taken > 5);
        CHECK(taken < 395);
    }
}
