// Tests a full disk for the telemetry: the window says so and continues, and its exit code reports it.
#include "core/base/image.hpp"
#include "core/base/text.hpp"
#include "tests/desktop/driven/driver.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/places.hpp"

#include <chrono>
#include <csignal>
#include <thread>

namespace meltpool::test {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// Time limit, s, far beyond any run of these tests.
constexpr double kPatience = 300;

void waitUntil(const std::string& what, const std::function<bool()>& condition) {
    const auto end = Clock::now() + std::chrono::duration<double>(kPatience);
    while (!condition()) {
        INFO("waited in vain for " << what);
        REQUIRE(Clock::now() < end);
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
}

/// Window whose telemetry goes to `telemetry`, with its scratch folder `name`; the test reads no rows of it.
struct BlindWindow {
    BlindWindow(const std::string& name, const std::string& telemetry)
        : folder(scratchFolder(name)),
          display({{"DISPLAY", sharedDisplay().name()}}),
          process(options(folder, telemetry)) {}

    static Process::Options options(const fs::path& folder, const std::string& telemetry) {
        fs::create_directories(folder / "home" / "Pictures");
        fs::create_directories(folder / "config" / "meltpool");
        writeTextFileAtomically(folder / "config" / "meltpool" / "settings.toml", kSmallSettings);
        Process::Options start;
        start.command = {MELTPOOL_PROGRAM, "--telemetry", telemetry};
        start.environment = {{"DISPLAY", sharedDisplay().name()},
                             {"HOME", (folder / "home").string()},
                             {"XDG_CONFIG_HOME", (folder / "config").string()},
                             {"XDG_DATA_HOME", (folder / "data").string()},
                             {"XDG_PICTURES_DIR", ""},
                             {"WAYLAND_DISPLAY", ""},
                             {"MELTPOOL_DATA", (test::buildFolder() / "share" / "meltpool").string()}};
        start.folder = folder;
        start.output = folder / "output.txt";
        return start;
    }

    std::vector<fs::path> pictures() const {
        std::vector<fs::path> found;
        for (const auto& entry : fs::recursive_directory_iterator(folder / "home"))
            if (entry.path().extension() == ".png") found.push_back(entry.path());
        return found;
    }

    /// Takes a picture of the window as it is now.
    Image picture() {
        waitUntil("the window", [&] {
            runCommand({"xdotool", "mousemove", "5", "635"}, display);
            return runCommand({"xdotool", "search", "--onlyvisible", "--name", "Meltpool"}, display) == 0;
        });
        for (const fs::path& older : pictures())
            fs::remove(older);
        waitUntil("a picture", [&] {
            if (pictures().empty()) runCommand({"xdotool", "key", "F10"}, display);
            std::this_thread::sleep_for(std::chrono::milliseconds(500));
            return !pictures().empty();
        });
        return readPng(pictures().front());
    }

    /// Takes a picture of the window once two in a row are alike: its first frames lack some parts.
    Image settledPicture() {
        Image last, now = picture();
        waitUntil("two pictures that are alike", [&] {
            last = std::move(now);
            now = picture();
            return last.rgb == now.rgb;
        });
        return now;
    }

    fs::path folder;
    std::map<std::string, std::string> display;
    Process process;
};

/// Counts the pixels of the upper quarter, the place of messages, that are not alike.
size_t differentAbove(const Image& a, const Image& b) {
    REQUIRE(a.width == b.width);
    REQUIRE(a.height == b.height);
    const size_t bytes = a.rgb.size() / 4;
    size_t different = 0;
    for (size_t i = 0; i < bytes; ++i)
        different += std::abs(int(a.rgb[i]) - int(b.rgb[i])) > 24;
    return different;
}

} // namespace

TEST_CASE("a full disk under the telemetry is told in the window, which goes on, and by the exit code") {
    if (!fs::exists("/dev/full")) return;
    BlindWindow whole("telemetry-whole", "telemetry.jsonl");
    const Image without = whole.settledPicture();
    whole.process.signal(SIGTERM);
    CHECK(whole.process.wait(kPatience) == 0);

    BlindWindow full("telemetry-full", "/dev/full");
    const std::string kSentence = "/dev/full: the telemetry cannot be continued; expected free space";
    // A busy machine takes seconds to its first row.
    waitUntil("the sentence", [&] {
        return fs::exists(full.folder / "output.txt") &&
               readTextFile(full.folder / "output.txt").find(kSentence) != std::string::npos;
    });
    waitUntil("the sentence over the picture", [&] { return differentAbove(without, full.picture()) > 1000; });
    CHECK(full.process.running());
    full.process.signal(SIGTERM);
    CHECK(full.process.wait(kPatience) == 1);
    const std::string words = readTextFile(full.folder / "output.txt");
    const size_t sentence = words.find(kSentence);
    CHECK(sentence != std::string::npos);
    CHECK(words.find("/dev/full", sentence + 1) == std::string::npos); // only once
}

} // namespace meltpool::test
