// Every text format under random damage: a reader accepts an input and its result is sound, or it refuses the input
// with one printable sentence. All other outcomes are faults.
//
// An input depends on its format and number alone. A failure names both and leaves the input in the build folder;
// MELTPOOL_FUZZ_FIRST=NUMBER begins there. MELTPOOL_FUZZ_SECONDS sets the time for each format.
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "tests/fuzz/formats.hpp"
#include "tests/fuzz/mutator.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/places.hpp"

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>

using namespace meltpool;

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

struct Report {
    std::uint64_t inputs = 0, taken = 0, refused = 0;
    std::string fault; ///< empty without a fault
};

double environmentNumber(const char* name, double otherwise) {
    const char* text = std::getenv(name);
    return text == nullptr ? otherwise : parseDouble(text).value_or(otherwise);
}

/// Writes without syncing, unlike writeFile(): a sync for each input would take all the time.
void put(const fs::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary | std::ios::trunc) << text;
}

std::string faultOfSentence(const std::string& sentence) {
    if (sentence.empty()) return "an empty sentence";
    if (sentence.size() > 2000) return "a sentence of " + std::to_string(sentence.size()) + " bytes";
    return printable(sentence, 3000) == sentence ? "" : "a sentence that is not printable: " + printable(sentence, 300);
}

/// Returns the fault in the reader's answer to this input; empty if there is none.
std::string faultOf(const test::Format& format, const fs::path& file, Report& report) {
    try {
        ++(format.read(file) == test::Answer::taken ? report.taken : report.refused);
    } catch (const InputError& refusal) {
        ++report.refused;
        return faultOfSentence(refusal.what());
    } catch (const std::exception& fault) {
        return std::string(fault.what());
    }
    return "";
}

Report fuzz(const test::Format& format, const fs::path& folder, double seconds) {
    test::Mutator mutator(format.corpus());
    const fs::path file = folder / format.fileName;
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    Report report;
    auto index = static_cast<std::uint64_t>(environmentNumber("MELTPOOL_FUZZ_FIRST", 0));
    for (; Clock::now() < end && report.fault.empty(); ++index) {
        const std::string text = mutator.input(index);
        put(file, text);
        ++report.inputs;
        const std::string fault = faultOf(format, file, report);
        if (fault.empty()) continue;
        const fs::path kept = test::buildFolder() / ("fuzz-" + std::string(format.fileName));
        put(kept, text);
        report.fault = std::string(format.name) + ", input " + std::to_string(index) + " (kept as " + kept.string() +
                       "): " + fault;
    }
    return report;
}

/// Runs all formats in parallel for `seconds`.
void fuzzAll(double seconds) {
    const auto formats = test::formats();
    std::vector<Report> reports(formats.size());
    std::vector<std::thread> threads;
    for (size_t i = 0; i < formats.size(); ++i) {
        const fs::path folder = test::scratchFolder("fuzz-" + std::to_string(i));
        threads.emplace_back([&, i, folder] { reports[i] = fuzz(formats[i], folder, seconds); });
    }
    for (std::thread& thread : threads)
        thread.join();
    for (size_t i = 0; i < formats.size(); ++i) {
        const Report& report = reports[i];
        WARN(formats[i].name << ": " << report.inputs << " inputs, " << report.taken << " taken, " << report.refused
                             << " refused");
        CHECK(report.fault == "");
        // Both answers must occur.
        CHECK(report.taken > 0);
        CHECK(report.refused > 0);
    }
}

} // namespace

TEST_CASE("every text of the corpus is taken or refused in a sentence", "[fuzz]") {
    for (const test::Format& format : test::formats()) {
        const fs::path file = test::scratchFolder("corpus") / format.fileName;
        Report report;
        for (const std::string& text : format.corpus()) {
            INFO(format.name << ": " << printable(text, 300));
            put(file, text);
            CHECK(faultOf(format, file, report) == "");
        }
        INFO(format.name);
        CHECK(report.taken > 0);
    }
}

TEST_CASE("inputs depend on their number alone", "[fuzz]") {
    test::Mutator first({"a = 1\nb = [1, 2]\n", "c = 'x'\n"});
    test::Mutator second({"a = 1\nb = [1, 2]\n", "c = 'x'\n"});
    first.input(7);
    CHECK(first.input(1234) == second.input(1234));
    CHECK(first.input(1234) != first.input(1235));
}

TEST_CASE("no damage to a text makes a reader crash, hang, or take what is unsound", "[fuzz]") {
    fuzzAll(environmentNumber("MELTPOOL_FUZZ_SECONDS", 30));
}

TEST_CASE("ten minutes of damage to every text", "[fuzz][long]") {
    fuzzAll(environmentNumber("MELTPOOL_FUZZ_SECONDS", 600));
}
