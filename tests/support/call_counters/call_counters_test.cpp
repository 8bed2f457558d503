// Tests the counting library that frame tests load before the program: it sees every OpenGL call of the program and
// every request to the heap.
#include "app/platform/call_counters.hpp"
#include "app/platform/frame_meter.hpp"
#include "core/base/text.hpp"
#include "core/gl/buffer.hpp"
#include "tests/support/call_counters/gl_calls.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/places.hpp"

#include <algorithm>
#include <cctype>
#include <memory>
#include <set>
#include <span>

namespace meltpool {

namespace {

namespace fs = std::filesystem;

/// Collects the words of a text that look like calls of OpenGL: "glClear(".
void collectCalls(const std::string& text, std::set<std::string>& calls) {
    for (size_t at = text.find("gl"); at != std::string::npos; at = text.find("gl", at + 1)) {
        const auto letter = [&](size_t i) { return static_cast<unsigned char>(i < text.size() ? text[i] : ' '); };
        if (at > 0 && (std::isalnum(letter(at - 1)) != 0 || letter(at - 1) == '_')) continue;
        if (std::isupper(letter(at + 2)) == 0 || letter(at + 2) == 'X') continue; // glX belongs to the window system
        size_t end = at + 2;
        while (std::isalnum(letter(end)) != 0)
            ++end;
        if (letter(end) == '(') calls.insert(text.substr(at, end - at));
    }
}

std::set<std::string> callsOfTheProgram() {
    std::set<std::string> calls;
    for (const char* folder : {"core", "xr", "app"})
        for (const auto& entry : fs::recursive_directory_iterator(test::sourceFolder() / folder))
            if (entry.path().extension() == ".cpp" || entry.path().extension() == ".hpp")
                collectCalls(readTextFile(entry.path()), calls);
    return calls;
}

} // namespace

TEST_CASE("every OpenGL call in the program's text is counted") {
    const std::span<const std::string_view> watched = test::kCountedGlCalls;
    const std::set<std::string> calls = callsOfTheProgram();
    CHECK(calls.size() > 80);
    for (const std::string& call : calls) {
        INFO(call << " is missing in tests/support/call_counters/gl_calls.hpp");
        CHECK(std::find(watched.begin(), watched.end(), call) != watched.end());
    }
}

TEST_CASE("a frame's meter hears the heap and calls that wait, and leaves out what it is told to") {
    test::context();
    REQUIRE(joinCallCounters()); // false: this program runs without LD_PRELOAD of the library
    gl::Buffer buffer("meter", 64);
    FrameMeter meter;
    std::unique_ptr<int> number;
    const auto frame = [&meter](auto work) {
        meter.restart();
        meter.begin();
        work();
        meter.end();
        return meter.totals();
    };
    const auto quiet = frame([&] { buffer.fill(1); });
    CHECK(quiet.frames == 1);
    CHECK(quiet.allocations == 0);
    CHECK(quiet.stalls == 0);
    CHECK(meter.lastMs(WorkPlace::driver) > 0);
    CHECK(frame([&] { number = std::make_unique<int>(1); }).framesThatAllocated == 1);
    const auto outside = frame([&] {
        const InWork driver(WorkPlace::driver);
        number = std::make_unique<int>(2);
    });
    CHECK(outside.allocations == 0);
    CHECK(frame([&] { glFinish(); }).stalls == 1);
    CHECK(std::string(meter.totals().lastStall) == "glFinish");
    GLuint word = 0;
    CHECK(frame([&] { glGetNamedBufferSubData(buffer.name(), 0, 4, &word); }).stalls == 1);
    CHECK(std::string(meter.totals().lastStall) == "glGetNamedBufferSubData");
    const auto paused = frame([&] {
        meter.pause();
        glFinish();
        number = std::make_unique<int>(3);
        meter.resume();
    });
    CHECK(paused.stalls == 0);
    CHECK(paused.allocations == 0);
    glFinish(); // no listener between frames
    CHECK(meter.totals().stalls == 0);
}

} // namespace meltpool
