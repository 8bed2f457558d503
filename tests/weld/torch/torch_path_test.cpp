// Torch paths: interpolation, the effect of each move, equal bits after writing and reading, and bad input.
#include "core/weld/torch/torch_path.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/gtc/constants.hpp>

#include <random>

using namespace meltpool;
using meltpool::test::containsText;

namespace {

const std::string kHeader = "time_s,x_mm,y_mm,z_mm,qx,qy,qz,qw,trigger\n";

std::filesystem::path written(const std::string& name, const std::string& text) {
    const auto file = test::scratchFolder("weld") / name;
    writeTextFileAtomically(file, text);
    return file;
}

/// Returns the sentence that refuses a file; empty if the file is accepted.
std::string refusal(const std::string& name, const std::string& text) {
    try {
        TorchPath::read(written(name, text));
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TorchPath shipped(const char* name) {
    return TorchPath::read(test::testFolder() / "paths" / name);
}

/// Returns the angle between two directions, rad.
double between(const glm::vec3& a, const glm::vec3& b) {
    return std::acos(std::clamp(static_cast<double>(glm::dot(a, b)), -1.0, 1.0));
}

} // namespace

TEST_CASE("a recorded path is linear in place, slerped in rotation, and holds the trigger", "[weld]") {
    const TorchPath path = shipped("recorded.csv");
    CHECK(path.duration() == 2);
    const TorchSample middle = path.sample(0.5);
    CHECK(middle.tip.x == Approx(0.015));
    CHECK(middle.tip.y == Approx(0.020));
    CHECK(middle.trigger == 0);
    CHECK(between(middle.axis(), {0, 0, -1}) == Approx(0).margin(1e-4));
    const TorchSample turned = path.sample(1.5);
    CHECK(turned.trigger == 1);
    CHECK(between(turned.axis(), {0, 0, -1}) == Approx(glm::quarter_pi<double>()).margin(1e-4));
    CHECK(path.sample(2).trigger == 0.5f);
    CHECK(path.sample(2.001).trigger == 0);
    CHECK(path.sample(99).tip.y == Approx(0.030));
}

TEST_CASE("further columns and comments of a recording are kept apart", "[weld]") {
    const TorchRecording recording = readTorchCsv(test::testFolder() / "paths" / "recorded.csv");
    REQUIRE(recording.furtherColumns == std::vector<std::string>{"operator"});
    CHECK(recording.furtherCells.front() == std::vector<std::string>{"anna"});
    CHECK(recording.furtherCells.back() == std::vector<std::string>{"ben"});
}

TEST_CASE("columns may stand in any order and lines may end as on Windows", "[weld]") {
    const auto file = written("order.csv", "\xEF\xBB\xBFtrigger,qw,qz,qy,qx,z_mm,y_mm,x_mm,note,time_s\r\n"
                                           "1,1,0,0,0,3,2,1,hello,0.25\r\n");
    const TorchRecording recording = readTorchCsv(file);
    REQUIRE(recording.samples.size() == 1);
    CHECK(recording.samples[0].time == 0.25);
    CHECK(recording.samples[0].tip.z == Approx(0.003));
    CHECK(recording.samples[0].trigger == 1);
}

TEST_CASE("a written recording reads back to the same bits, with and without a filler rod", "[weld]") {
    const bool rods = GENERATE(false, true);
    std::mt19937 random(7);
    std::uniform_real_distribution<float> any(-1.0f, 1.0f);
    TorchRecording recording;
    recording.furtherColumns = {"molten"};
    double time = 0;
    for (int i = 0; i < 300; ++i) {
        time += 1.0 / 60;
        const glm::quat q = glm::normalize(glm::quat(any(random), any(random), any(random), any(random)));
        recording.samples.push_back({time, {any(random), any(random), any(random)}, q, std::abs(any(random))});
        if (rods && i % 3 > 0) // the hand drops the rod now and then
            recording.samples.back().rod =
                RodSample{{any(random), any(random), any(random)}, glm::conjugate(q), std::abs(any(random))};
        recording.furtherCells.push_back({std::to_string(i)});
    }
    const auto file = test::scratchFolder("weld") / "again.csv";
    writeTorchCsv(file, recording);
    const TorchRecording again = readTorchCsv(file);
    REQUIRE(again.samples.size() == recording.samples.size());
    const TorchPath path(again.samples);
    for (size_t i = 0; i < again.samples.size(); ++i) {
        const TorchSample& wanted = recording.samples[i];
        const TorchSample got = path.sample(wanted.time);
        REQUIRE(got.time == wanted.time);
        REQUIRE(got.tip == wanted.tip);
        REQUIRE(got.orientation == wanted.orientation);
        REQUIRE(got.trigger == wanted.trigger);
        REQUIRE(got.rod.has_value() == wanted.rod.has_value());
        if (!wanted.rod) continue;
        REQUIRE(got.rod->tip == wanted.rod->tip);
        REQUIRE(got.rod->orientation == wanted.rod->orientation);
        REQUIRE(got.rod->feed == wanted.rod->feed);
    }
    CHECK(again.furtherCells == recording.furtherCells);
    CHECK(again.furtherColumns == recording.furtherColumns);
}

TEST_CASE("authored moves take the time that their speed asks for", "[weld]") {
    const TorchPath path = shipped("authored.toml");
    CHECK(path.duration() == Approx(0.5 + 5 + 1 + 5));
    CHECK(path.sample(0.4).trigger == 0);
    CHECK(path.sample(0.5).trigger == Approx(0.8f));
    CHECK(path.sample(0.5 + 2.5).tip.x == Approx(0.025));
    CHECK(path.sample(path.duration()).trigger == 0);
    CHECK(path.sample(path.duration()).tip.x == Approx(0.080));
    CHECK(path.sample(path.duration()).tip.z == Approx(0).margin(1e-6));
}

TEST_CASE("work and travel angle lean the torch as welders count them", "[weld]") {
    const glm::vec3 x(1, 0, 0);
    const auto axis = [](double work, double travel, glm::vec3 along) {
        return heldOrientation(glm::radians(work), glm::radians(travel), along) * glm::vec3(0, 0, -1);
    };
    CHECK(between(axis(90, 0, x), {0, -1, 0}) == Approx(0).margin(1e-3));
    // The angle is 45 degrees in a fillet: the handle leans to the welder, the torch points down and away.
    CHECK(between(axis(45, 0, x), glm::normalize(glm::vec3(0, -1, -1))) == Approx(0).margin(1e-3));
    // A pushed torch points in the travel direction, either way; a dragged one points back.
    CHECK(axis(90, 15, x).x == Approx(std::sin(glm::radians(15.0))));
    CHECK(axis(90, 15, -x).x == Approx(-std::sin(glm::radians(15.0))));
    CHECK(axis(90, -15, x).x == Approx(-std::sin(glm::radians(15.0))));
    const glm::quat q = heldOrientation(1.0, 0.2, glm::normalize(glm::vec3(1, 0, 1)));
    CHECK(glm::length(q) == Approx(1));
    CHECK(glm::determinant(glm::mat3_cast(q)) == Approx(1));
}

TEST_CASE("a torch that comes from the side strikes at the angles asked for, and keeps them along the seam", "[weld]") {
    struct Seam {
        const char* path;
        double work, travel, strike; ///< degrees; degrees; s
    };
    const double tee = std::hypot(25 - 3.4, 25 - 3.7) / 80, thin = std::hypot(25 - 2.1, 25 - 2.3) / 80,
                 lap = std::hypot(25 - 2.1, 25 - 2.4) / 80, stick = (25.0 - 4) / 80;
    for (const Seam& seam : {Seam{"tee-fillet.toml", 45, 20, tee + 0.3}, Seam{"tee-thin.toml", 45, 15, thin + 0.3},
                             Seam{"lap-2f.toml", 45, 15, lap + 0.3}, Seam{"smaw-tee.toml", 42, -15, stick}}) {
        INFO(seam.path);
        const auto folder = test::testFolder().parent_path() / "app" / "data" / "paths";
        const TorchPath path = TorchPath::read(folder / seam.path);
        const glm::vec3 asked =
            heldOrientation(glm::radians(seam.work), glm::radians(seam.travel), {1, 0, 0}) * glm::vec3(0, 0, -1);
        CHECK(path.sample(seam.strike - 0.01).trigger == 0);
        CHECK(path.sample(seam.strike + 0.01).trigger == 1);
        for (const double time : {0.0, seam.strike - 0.15, seam.strike, seam.strike + 0.2, seam.strike + 1.0}) {
            INFO(time);
            CHECK(glm::degrees(between(path.sample(time).axis(), asked)) < 0.5);
        }
    }
}

TEST_CASE("between two seams a released torch is held for the second, after the last it stays as it is", "[weld]") {
    const auto line = [](const char* to) {
        return std::string("[[move]]\nkind = 'line'\nspeed_mm_s = 10\nto_mm = ") + to + "\n";
    };
    const std::string on = "[[move]]\nkind = 'arc_on'\n", off = "[[move]]\nkind = 'arc_off'\n";
    const std::string start = "start_mm = [0, 20, 20]\ntravel_angle_deg = 30\n";
    const auto axis = [](const TorchPath& path, double time) { return path.sample(time).axis(); };
    const auto asked = [](glm::vec3 along) {
        return heldOrientation(glm::half_pi<double>(), glm::radians(30.0), along) * glm::vec3(0, 0, -1);
    };
    const TorchPath path = TorchPath::read(written("seams.toml", start + line("[0, 0, 20]") + on + line("[10, 0, 20]") +
                                                                     off + line("[10, 0, 10]") + on +
                                                                     line("[20, 0, 0]") + off + line("[0, 0, 0]")));
    const glm::vec3 second = glm::normalize(glm::vec3(1, 0, -1));
    CHECK(between(axis(path, 1), asked({1, 0, 0})) == Approx(0).margin(1e-3));
    CHECK(between(axis(path, 2.5), asked({1, 0, 0})) == Approx(0).margin(1e-3));
    CHECK(between(axis(path, 3.5), asked(second)) == Approx(0).margin(1e-3));
    CHECK(between(axis(path, 4.5), asked(second)) == Approx(0).margin(1e-3));
    CHECK(between(axis(path, 6), asked(second)) == Approx(0).margin(1e-3));
    // Without a welded line there is no seam: the torch turns in its travel direction.
    const TorchPath spot = TorchPath::read(
        written("spot.toml", start + line("[0, 20, 10]") + on + "[[move]]\nkind = 'hold'\nseconds = 1\n"));
    CHECK(between(axis(spot, 1.5), asked({0, 0, -1})) == Approx(0).margin(1e-3));
}

TEST_CASE("a weave reaches both toes, rests there, and ends on the seam", "[weld]") {
    CHECK(weaveOffset(0, 0.1) == 0);
    CHECK(weaveOffset(0.25, 0.1) == 1);
    CHECK(weaveOffset(0.25 + 0.049, 0.1) == 1);
    CHECK(weaveOffset(0.25 + 0.06, 0.1) < 1);
    CHECK(weaveOffset(0.75, 0.1) == -1);
    CHECK(weaveOffset(0.5, 0.1) == Approx(0).margin(1e-9));
    const TorchPath path = shipped("authored.toml");
    float widest = 0, narrowest = 0, highest = 0;
    double fastest = 0;
    for (double t = 6.5; t < 11.5; t += 0.001) {
        const glm::vec3 tip = path.sample(t).tip;
        widest = std::max(widest, tip.z);
        narrowest = std::min(narrowest, tip.z);
        highest = std::max(highest, tip.y);
        fastest = std::max(fastest, static_cast<double>(glm::length(path.sample(t + 0.001).tip - tip)));
    }
    // The torch leans at 45 degrees, and the swing of 8 mm is perpendicular to it.
    CHECK(widest == Approx(0.004 * std::sqrt(0.5)).margin(1e-5));
    CHECK(narrowest == Approx(-0.004 * std::sqrt(0.5)).margin(1e-5));
    CHECK(highest == Approx(0.015 + 0.004 * std::sqrt(0.5)).margin(1e-5));
    CHECK(fastest < 0.001 * 0.1); // no jumps: below 100 mm/s throughout
}

TEST_CASE("a path on a pipe goes around it at the speed and the angles that are told on its face", "[weld]") {
    const double radius = 20e-3, quarter = glm::half_pi<double>() * radius, height = 3e-3, lean = glm::radians(10.0);
    const std::string text = "start_mm = [" + std::to_string(2 * quarter * 1e3) + ", 3, 0]\npipe_diameter_mm = 40\n" +
                             "travel_angle_deg = 10\n[rod]\nangle_deg = 20\nahead_mm = 3\nbelow_mm = 2\n" +
                             "rest_mm = 0\ndepth_mm = 0\n[[move]]\nkind = 'line'\nto_mm = [" +
                             std::to_string(4 * quarter * 1e3) + ", 3, 0]\nspeed_mm_s = 5\n";
    const TorchPath path = TorchPath::read(written("pipe.toml", text));
    CHECK(path.duration() == Approx(2 * quarter / 5e-3));
    for (const double share : {0.0, 0.3, 0.5, 1.0}) { // from the bottom along the left side to the top
        const double angle = glm::pi<double>() * (1 + share);
        const TorchSample torch = path.sample(share * path.duration());
        const glm::dvec2 out(std::sin(angle), std::cos(angle)), along(std::cos(angle), -std::sin(angle));
        const glm::dvec2 tip = (radius + height) * out - glm::dvec2(0, radius);
        INFO(share);
        CHECK(glm::distance(glm::dvec2(torch.tip.x, torch.tip.y), tip) < 1e-6);
        CHECK(torch.tip.z == Approx(0).margin(1e-7));
        const glm::dvec2 axis = std::sin(lean) * along - std::cos(lean) * out; // points in the travel direction
        CHECK(between(torch.axis(), glm::vec3(float(axis.x), float(axis.y), 0)) == Approx(0).margin(1e-3));
        // The rod's end is before the electrode and under its tip, according to the handle's lean.
        const glm::dvec2 rod = tip + 3e-3 * along - 2e-3 * out;
        CHECK(glm::distance(glm::dvec2(torch.rod->tip.x, torch.rod->tip.y), rod) < 1e-6);
    }
    CHECK_THAT(refusal("pipe.toml", "start_mm = [0, 0, 0]\npipe_diameter_mm = 0\n[[move]]\nkind = 'hold'\n"),
               containsText("pipe.toml:2: ") && containsText("pipe_diameter_mm"));
}

TEST_CASE("a bad recording is refused in one sentence with file, line and expectation", "[weld]") {
    const std::string good = "0,1,2,3,0,0,0,1,1\n";
    struct Case {
        std::string text, place, expectation;
    };
    const std::vector<Case> cases{
        {"", "bad.csv: ", "expected a header row"},
        {kHeader, "bad.csv: ", "expected at least one"},
        {"time_s,x_mm\n0,1\n", "bad.csv:1: ", "'y_mm' is missing"},
        {"time_s,time_s,x_mm,y_mm,z_mm,qx,qy,qz,qw,trigger\n", "bad.csv:1: ", "occurs twice"},
        {kHeader + good + "1,2,3\n", "bad.csv:3: ", "expected 9"},
        {kHeader + good + "1,2,3,oops,0,0,0,1,0\n", "bad.csv:3: ", "z_mm is 'oops'"},
        {kHeader + good + "1,nan,3,4,0,0,0,1,0\n", "bad.csv:3: ", "x_mm is 'nan'"},
        {kHeader + good + "inf,2,3,4,0,0,0,1,0\n", "bad.csv:3: ", "time_s is 'inf'"},
        {kHeader + "# remark\n\n" + good + "-1,2,3,4,0,0,0,1,0\n", "bad.csv:5: ", "time_s is '-1'"},
        {kHeader + "2,1,2,3,0,0,0,1,1\n1,1,2,3,0,0,0,1,1\n", "bad.csv:3: ", "expected at least 2"},
        {kHeader + "0,1,2,3,0,0,0,0,1\n", "bad.csv:2: ", "length 0; expected 1"},
        {kHeader + "0,1,2,3,0,0,0,1,1.5\n", "bad.csv:2: ", "expected a number from 0 to 1"},
        {kHeader + "0,1,,3,0,0,0,1,1\n", "bad.csv:2: ", "y_mm is ''"},
    };
    for (const Case& bad : cases) {
        INFO(bad.text);
        const std::string sentence = refusal("bad.csv", bad.text);
        CHECK_THAT(sentence, containsText(bad.place));
        CHECK_THAT(sentence, containsText(bad.expectation));
        CHECK_THAT(sentence, containsText("expected"));
        CHECK(sentence.find('\n') == std::string::npos);
    }
}

TEST_CASE("bad moves are refused in one sentence with file, line and expectation", "[weld]") {
    const std::string start = "start_mm = [0, 0, 0]\n";
    struct Case {
        std::string text, place, expectation;
    };
    const std::vector<Case> cases{
        {"", "bad.toml", "start_mm"},
        {start, "bad.toml", "[[move]]"},
        {"start_mm = [0, 0]\n", "bad.toml:1: ", "3"},
        {start + "speed = 3\n[[move]]\nkind = 'hold'\nseconds = 1\n", "bad.toml:2: ", "unknown key"},
        {start + "[[move]]\nkind = 'fly'\n", "bad.toml:3: ", "expected one of hold"},
        {start + "[[move]]\nkind = 'hold'\n", "bad.toml:2: ", "seconds"},
        {start + "[[move]]\nkind = 'hold'\nseconds = -1\n", "bad.toml:4: ", "from 0 to 3600"},
        {start + "[[move]]\nkind = 'hold'\nseconds = nan\n", "bad.toml:4: ", "expected"},
        {start + "[[move]]\nkind = 'hold'\nseconds = 1\nwidth_mm = 1\n", "bad.toml:5: ", "unknown key"},
        {start + "[[move]]\nkind = 'line'\nto_mm = [0, 0, 0]\nspeed_mm_s = 5\n", "bad.toml:4: ", "another place"},
        {start + "[[move]]\nkind = 'line'\nto_mm = [9, 0, 0]\nspeed_mm_s = 0\n", "bad.toml:5: ", "expected"},
        {start + "[[move]]\nkind = 'arc_on'\ntrigger = 2\n", "bad.toml:4: ", "from 0 to 1"},
        {start + "[[move]\n", "bad.toml:2: ", ""},
    };
    for (const Case& bad : cases) {
        INFO(bad.text);
        const std::string sentence = refusal("bad.toml", bad.text);
        CHECK_THAT(sentence, containsText(bad.place));
        CHECK_THAT(sentence, containsText(bad.expectation));
        CHECK(sentence.find('\n') == std::string::npos);
    }
}

TEST_CASE("a path that is neither CSV nor TOML, or not there, is refused by name", "[weld]") {
    CHECK_THAT(refusal("path.doc", "hello"), containsText("path.doc: is no torch path; expected"));
    CHECK_THROWS_WITH(TorchPath::read("nowhere/path.csv"), containsText("nowhere/path.csv: "));
    CHECK_THROWS_AS(TorchPath::read("nowhere/path.toml"), InputError);
}

TEST_CASE("a torch path's line without end is refused, and what it quotes is short and fit for a terminal", "[weld]") {
    const auto folder = test::scratchFolder("torch-attacks");
    const std::string header = "time_s,x_mm,y_mm,z_mm,qx,qy,qz,qw,trigger";
    const auto refusal = [&](const std::string& text) {
        writeTextFileAtomically(folder / "path.csv", text);
        try {
            TorchPath::read(folder / "path.csv");
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("taken");
    };
    CHECK_THAT(refusal(header + "\n" + std::string(70000, '1')),
               test::containsText("path.csv:2: the line is too long"));
    CHECK_THAT(refusal(header + std::string(70000, ',')), test::containsText("path.csv:1: the line is too long"));
    const std::string escape = refusal(header + "\n\x1b[31m" + std::string(5000, 'x') + ",0,0,0,0,0,0,1,1\n");
    CHECK_THAT(escape,
               test::containsText("path.csv:2: time_s is '\\x1b[31mxxx") && test::containsText("expected a time"));
    CHECK(escape.size() < 400);
    CHECK_THAT(refusal(header + ",\xff,\xff\n"), test::containsText("path.csv:1: the column '\u00FF' occurs twice"));
}

TEST_CASE("a torch path is the same with and without the columns that it does not need", "[weld]") {
    const auto file = test::testFolder() / "paths" / "recorded.csv";
    const TorchRecording bare = readTorchCsv(file, FurtherColumns::dropped);
    CHECK(bare.furtherCells.empty());
    CHECK(bare.samples.size() == readTorchCsv(file).samples.size());
}

TEST_CASE("a rod moves evenly between rows, and a table has all of its columns or none", "[weld]") {
    const std::string header = "time_s,x_mm,y_mm,z_mm,qx,qy,qz,qw,trigger,rod_x_mm,rod_y_mm,rod_z_mm,"
                               "rod_qx,rod_qy,rod_qz,rod_qw,rod_feed\n";
    const TorchPath path = TorchPath::read(written("rod.csv", header + "0,0,0,0,0,0,0,1,1,10,0,0,0,0,0,1,2\n"
                                                                       "1,0,0,0,0,0,0,1,1,20,4,0,0,0,0,1,3\n"
                                                                       "2,0,0,0,0,0,0,1,1,,,,,,,,\n"));
    REQUIRE(path.sample(0.5).rod);
    CHECK(path.sample(0.5).rod->tip.x == Approx(0.015));
    CHECK(path.sample(0.5).rod->tip.y == Approx(0.002));
    CHECK(path.sample(0.5).rod->feed == Approx(0.002));
    CHECK(path.sample(1.5).rod->tip.x == Approx(0.02)); // until the row without a rod
    CHECK_FALSE(path.sample(2).rod);
    CHECK_THAT(refusal("rod.csv", "time_s,x_mm,y_mm,z_mm,qx,qy,qz,qw,trigger,rod_x_mm\n0,0,0,0,0,0,0,1,1,2\n"),
               containsText("rod.csv:1: the column 'rod_y_mm' is missing"));
    CHECK_THAT(refusal("rod.csv", header + "0,0,0,0,0,0,0,1,1,10,,0,0,0,0,1,2\n"), containsText("rod_y_mm"));
    CHECK_THAT(refusal("rod.csv", header + "0,0,0,0,0,0,0,1,1,10,0,0,0,0,0,0.5,2\n"),
               containsText("rod_qx,rod_qy,rod_qz,rod_qw has the length 0.5"));
    CHECK_THAT(refusal("rod.csv", header + "0,0,0,0,0,0,0,1,1,10,0,0,0,0,0,1,-2\n"), containsText("rod_feed"));
}

TEST_CASE("an authored rod dips in front of the electrode, and the hand follows what burns off", "[weld]") {
    const std::string text = "start_mm = [0, 2, 0]\n[rod]\nangle_deg = 20\nahead_mm = 3\nbelow_mm = 2\n"
                             "rest_mm = 12\ndepth_mm = 1\nfeed_mm_s = 1.5\n"
                             "[[move]]\nkind = 'hold'\nseconds = 1\n"
                             "[[move]]\nkind = 'line'\nto_mm = [20, 2, 0]\nspeed_mm_s = 2\ndips_hz = 1\n";
    const TorchPath path = TorchPath::read(written("rod.toml", text));
    const double c = std::cos(glm::radians(20.0)), s = std::sin(glm::radians(20.0));
    const RodSample rest = *path.sample(0.5).rod;
    CHECK(double(rest.tip.x) * 1e3 == Approx(3 + 12 * c));
    CHECK(double(rest.tip.y) * 1e3 == Approx(12 * s));
    CHECK(rest.feed == Approx(1.5e-3));
    CHECK(between(rest.axis(), {-float(c), -float(s), 0}) == Approx(0).margin(1e-3));
    const RodSample dipped = *path.sample(1.5).rod; // half a swing into the line, 1 mm farther on
    CHECK(double(dipped.tip.x) * 1e3 == Approx(1 + 3 - c).margin(1e-3));
    CHECK(double(dipped.tip.y) * 1e3 == Approx(-s).margin(1e-3));
    CHECK(double(path.sample(2).rod->tip.x) * 1e3 == Approx(2 + 3 + 12 * c).margin(1e-3));
    CHECK_THAT(refusal("dips.toml", "start_mm = [0, 2, 0]\n[[move]]\nkind = 'hold'\nseconds = 1\ndips_hz = 1\n"),
               containsText("expected a table [rod]"));

    const TorchPath follows = TorchPath::read(
        written("follow.toml", "start_mm = [0, 3, 0]\n[[move]]\nkind = 'hold'\nseconds = 1\n"
                               "[[move]]\nkind = 'line'\nto_mm = [20, 3, 0]\nspeed_mm_s = 4\nfollow_mm_s = 3\n"
                               "[[move]]\nkind = 'hold'\nseconds = 1\n"));
    CHECK(double(follows.sample(1).tip.y) * 1e3 == Approx(3));
    CHECK(double(follows.sample(3).tip.y) * 1e3 == Approx(3 - 2 * 3));
    CHECK(double(follows.sample(7).tip.y) * 1e3 == Approx(3 - 5 * 3)); // then stays at its depth
    CHECK(double(follows.sample(7).tip.x) * 1e3 == Approx(20));
}
