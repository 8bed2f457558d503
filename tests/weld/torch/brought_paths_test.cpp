// Torch paths from spreadsheets, robots and motion capture: each file of tests/data/brought/ has one oddity, and yields
// the path of plain.csv or a refusal that names the fault.
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/weld/torch/torch_path.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <set>

using namespace meltpool;
using meltpool::test::containsText;

namespace {

namespace fs = std::filesystem;

fs::path brought(const std::string& name) {
    return test::testFolder() / "data" / "brought" / name;
}

struct Taken {
    const char* name;
    const char* form; ///< description of its form
};

const std::vector<Taken> kTaken{
    {"plain.csv", "UTF-8, columns separated by commas, decimal point, times in s"},
    {"excel-german.csv", "Windows-1252, columns separated by semicolons, decimal comma, times in s"},
    {"excel-unicode-text.txt", "UTF-16, columns separated by tabs, decimal comma, times in s"},
    {"tabs.tsv", "UTF-8, columns separated by tabs, decimal point, times in s"},
    {"tabs-decimal-comma.txt", "UTF-8, columns separated by tabs, decimal comma, times in s"},
    {"utf-16-big-endian.csv", "UTF-16, columns separated by commas, decimal point, times in s"},
    {"utf-8-mark.csv", "UTF-8 with a mark, columns separated by commas, decimal point, times in s"},
    {"lone-cr.csv", "UTF-8, columns separated by commas, decimal point, times in s"},
    {"sep-line.csv", "UTF-8, columns separated by semicolons, decimal comma, times in s"},
    {"sep-line-strange.csv", "UTF-8, columns separated by '|', decimal point, times in s"},
    {"trailing-separators.csv", "UTF-8, columns separated by semicolons, decimal point, times in s"},
    {"quoted-cells.csv", "UTF-8, columns separated by commas, decimal comma, times in s"},
    {"header-in-capitals.csv", "UTF-8, columns separated by commas, decimal point, times in s"},
    {"header-with-spaces.csv", "UTF-8, columns separated by commas, decimal point, times in s"},
    {"header-without-units.csv", "decimal point, times in s, positions taken to be mm"},
    {"header-in-metres.csv", "decimal point, times in s"},
    {"CAPITALS.CSV", "decimal point, times in s"},
    {"epoch-seconds.csv", "times in s from 1764244800 s on"},
    {"epoch-milliseconds.csv", "times in ms, judged by their size, from 1764244800 s on"},
    {"epoch-microseconds.csv", "times in us, judged by their size, from 1764244800 s on"},
    {"epoch-nanoseconds.csv", "times in ns, judged by their size, from 1764244800 s on"},
    {"milliseconds.csv", "times in ms, judged by their size"},
    {"milliseconds-in-header.csv", "times in ms"},
    {"microseconds.csv", "times in us, judged by their size"},
    {"microseconds-in-header.csv", "times in us"},
    {"begins-below-zero.csv", "times in s from -1.5 s on"},
    {"rows-without-pose.csv", "times in s, 4 rows without a pose"},
    {"hash-in-cell.csv", "decimal point, times in s"},
    {"robot-controller.txt",
     "separated by semicolons, decimal point, 4 lines above the header left out, times in ms from 48213 s on"},
    {"motion-capture.tsv", "separated by tabs, decimal point, 5 lines above the header left out, times in s, positions "
                           "taken to be mm, 4 rows without a pose"},
};

struct Refused {
    const char* name;
    const char* place;
    const char* sentence;
};

const std::vector<Refused> kRefused{
    {"refused-motion-capture-two-headers.csv", ".csv:4: ", "the column 'X' occurs twice"},
    {"refused-robot-angles.csv", ".csv:1: ", "the column 'qx' is missing (and qy, qz, qw)"},
    {"refused-robot-angles.csv", ".csv:1: ", "found 't;X;Y;Z;A;B;C;trigger'. Angles are no orientation here"},
    {"refused-utf-16-without-mark.csv", ".csv: ", "looks like UTF-16 without a byte order mark"},
    {"refused-utf-32.csv", ".csv: ", "is UTF-32"},
    {"refused-mixed-decimals.csv", ".csv:7: ", "has the number '0.10' below numbers with a decimal comma"},
    {"refused-thousands.csv", ".csv:5: ", "has the number '-1,234.5'; expected one without a thousands separator"},
    {"refused-decimal-comma-and-commas.csv", ".csv:2: ",
     "has 15 cells; expected 9, one for each column of the header; "
     "numbers with a decimal comma need quotes"},
    {"refused-spaces.txt", ".txt:1: ", "parted by commas, semicolons or tabs, and found 'time_s x_mm"},
    {"refused-quote-without-end.csv", ".csv:14: ", "a quote in cell 2 does not end"},
    {"refused-inches.csv", ".csv:1: ", "the column 'x [in]' has the unit 'in'; expected one of mm, cm, m"},
    {"refused-no-pose.csv", ".csv: ", "has no row with a pose"},
    {"refused-part-of-a-pose.csv", ".csv:5: ", "z_mm is 'nan'"},
    {"refused-without-trigger.csv", ".csv:1: ", "the column 'trigger' is missing"},
};

void requireSamePath(const TorchPath& path, const TorchPath& plain) {
    REQUIRE(path.samples().size() == plain.samples().size());
    for (size_t i = 0; i < plain.samples().size(); ++i) {
        const TorchSample &got = path.samples()[i], &wanted = plain.samples()[i];
        INFO("row " << i + 1);
        CHECK(got.time == Approx(wanted.time).margin(1e-6));
        if (!got.seen) continue;
        CHECK(glm::distance(got.tip, wanted.tip) < 1e-7F);
        CHECK(glm::length(got.orientation - wanted.orientation) < 1e-5F);
        CHECK(got.trigger == wanted.trigger);
    }
}

} // namespace

TEST_CASE("torch paths that people bring are read, and what was assumed of them is told", "[weld]") {
    const TorchPath plain = TorchPath::read(brought("plain.csv"));
    CHECK(plain.duration() == Approx(0.22));
    for (const Taken& each : kTaken) {
        INFO(each.name);
        const TorchPath path = TorchPath::read(brought(each.name));
        requireSamePath(path, plain);
        REQUIRE(path.form());
        CHECK_THAT(path.form()->text(), containsText(each.form));
        CHECK(path.form()->text().find('\n') == std::string::npos);
    }
}

TEST_CASE("torch paths that cannot be read are refused with the fault that they have", "[weld]") {
    for (const Refused& each : kRefused) {
        INFO(each.name);
        std::string sentence = "taken";
        try {
            TorchPath::read(brought(each.name));
        } catch (const InputError& error) {
            sentence = error.what();
        }
        CHECK_THAT(sentence, containsText(each.place));
        CHECK_THAT(sentence, containsText(each.sentence));
        CHECK_THAT(sentence, containsText("expected"));
    }
}

TEST_CASE("every file of tests/data/brought is tried", "[weld]") {
    std::set<std::string> tried;
    for (const Taken& each : kTaken)
        tried.insert(each.name);
    for (const Refused& each : kRefused)
        tried.insert(each.name);
    for (const auto& entry : fs::directory_iterator(brought(""))) {
        INFO(entry.path());
        const std::string name = entry.path().filename().string();
        if (!name.starts_with("record-") && entry.is_regular_file()) CHECK(tried.contains(name));
    }
}

TEST_CASE("a torch that is not seen stays where it was seen last, its trigger released", "[weld]") {
    const TorchPath path = TorchPath::read(brought("rows-without-pose.csv"));
    const auto& rows = path.samples();
    CHECK_FALSE(path.sample(0).seen);
    CHECK(path.sample(0).tip == rows[1].tip); // before the first seen pose the torch is already there
    CHECK(path.sample(0.07).seen);
    CHECK(path.sample(0.07).trigger == 1);
    CHECK(path.sample(0.07).tip == rows[3].tip); // no motion leads to a row without a pose
    for (const double time : {0.08, 0.1, 0.13}) {
        const TorchSample lost = path.sample(time);
        CHECK_FALSE(lost.seen);
        CHECK(lost.trigger == 0);
        CHECK(lost.tip == rows[3].tip);
    }
    CHECK(path.sample(0.14).seen);
    CHECK(path.sample(0.14).trigger == 1);
}

TEST_CASE("times that are seconds stay as they are, slow paths and pauses too", "[weld]") {
    const auto clockOf = [](std::vector<double> times, float step) {
        std::vector<TorchSample> samples;
        for (const double time : times)
            samples.push_back({time, {step * static_cast<float>(samples.size()), 0, 0}});
        const TorchClock clock = settleTimes(samples, 1, true);
        return std::pair(clock, samples);
    };
    const auto [paused, later] = clockOf({9.5, 9.7, 9.9}, 1e-3F);
    CHECK_FALSE(paused.shifted);
    CHECK(later.back().time == 9.9);
    const auto [sparse, same] = clockOf({0, 10, 20}, 1e-3F); // three places of a slow path, typed by a person
    CHECK(sparse.unit == "s");
    CHECK(same.back().time == 20);
    const auto [still, standing] = clockOf({0, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100}, 0);
    CHECK(still.unit == "s");
    CHECK(standing.back().time == 100);
    const auto [begun, shifted] = clockOf({312.25, 312.5, 313.25}, 1e-3F);
    CHECK(begun.shifted);
    CHECK(begun.begin == 312.25);
    CHECK(shifted.back().time == 1);
}

TEST_CASE("a recording with further columns that hold separators and quotes reads back", "[weld]") {
    TorchRecording recording;
    recording.samples.resize(1);
    recording.furtherColumns = {"a, \"b\""};
    recording.furtherCells = {{"two\nlines, \"quoted\""}};
    const fs::path file = test::scratchFolder("brought") / "cells.csv";
    writeTorchCsv(file, recording);
    const TorchRecording again = readTorchCsv(file);
    CHECK(again.furtherColumns == recording.furtherColumns);
    CHECK(again.furtherCells == recording.furtherCells);
}
