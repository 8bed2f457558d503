// Tests a start from the menu entry: a window shows why the trainer ended.
#include "core/base/text.hpp"
#include "tests/desktop/driven/driver.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/places.hpp"

#include <X11/Xlib.h>

#include <array>
#include <chrono>
#include <memory>
#include <thread>

namespace meltpool::test {

namespace {

namespace fs = std::filesystem;

/// Runs the program as the menu entry starts it, on a display of its own.
class IconStart {
  public:
    IconStart(const std::string& name, int dotsPerInch, std::vector<std::string> words,
              std::map<std::string, std::string> environment)
        : folder_(scratchFolder(name)), display_(dotsPerInch) {
        words.insert(words.begin(), {MELTPOOL_PROGRAM, "--error-window"});
        environment["DISPLAY"] = display_.name();
        environment["WAYLAND_DISPLAY"] = "";
        environment["XDG_CONFIG_HOME"] = folder_.string();
        environment["XDG_DATA_HOME"] = folder_.string();
        process_ = std::make_unique<Process>(Process::Options{
            .command = words, .environment = environment, .output = folder_ / "output.txt", .folder = folder_});
    }

    int xdotool(std::vector<std::string> words) const {
        words.insert(words.begin(), "xdotool");
        return runCommand(words, {{"DISPLAY", display_.name()}});
    }
    /// Waits for a window of this class and saves a picture of the display.
    void waitForWindow(const std::string& picture) const {
        REQUIRE(xdotool({"search", "--sync", "--onlyvisible", "--class", "^meltpool$"}) == 0);
        std::this_thread::sleep_for(std::chrono::seconds(1)); // time until it is drawn
        const fs::path file = test::buildFolder() / "desktop-pictures" / picture;
        fs::create_directories(file.parent_path());
        CHECK(runCommand({"import", "-window", "root", file.string()}, {{"DISPLAY", display_.name()}}) == 0);
    }
    /// Returns place and size of the one window, pixels.
    std::array<int, 4> window() const {
        Display* display = XOpenDisplay(display_.name().c_str());
        REQUIRE(display != nullptr);
        Window root = 0, parent = 0;
        Window* children = nullptr;
        unsigned count = 0;
        XQueryTree(display, DefaultRootWindow(display), &root, &parent, &children, &count);
        REQUIRE(count == 1);
        XWindowAttributes found;
        XGetWindowAttributes(display, children[0], &found);
        XFree(children);
        XCloseDisplay(display);
        return {found.x, found.y, found.width, found.height};
    }
    std::string output() const { return readTextFile(folder_ / "output.txt"); }
    Process& process() { return *process_; }

  private:
    fs::path folder_;
    VirtualDisplay display_;
    std::unique_ptr<Process> process_;
};

} // namespace

TEST_CASE("too little OpenGL is told in a window, which Return closes; the exit code stays") {
    IconStart start("icon-gl", 96, {}, {{"MESA_GL_VERSION_OVERRIDE", "3.1"}, {"LIBGL_ALWAYS_SOFTWARE", ""}});
    start.waitForWindow("error-window.png");
    CHECK_THAT(start.output(), containsText("LIBGL_ALWAYS_SOFTWARE=1"));
    CHECK(start.process().running());
    CHECK(start.xdotool({"key", "Return"}) == 0);
    CHECK(start.process().wait(60) == 2);
}

TEST_CASE("on a dense screen the window with the error is larger, and its button closes it") {
    IconStart start("icon-dense", 192, {"--lesson", "Сварка-溶接"}, {});
    start.waitForWindow("error-window-dense.png");
    CHECK_THAT(start.output(), containsText("Сварка"));
    const auto [x, y, width, height] = start.window();
    CHECK(width == 1120);
    const auto click = [&, x = x, y = y](int right, int down) {
        start.xdotool({"mousemove", std::to_string(x + right), std::to_string(y + down), "click", "1"});
        std::this_thread::sleep_for(std::chrono::seconds(1));
    };
    click(100, height - 80); // next to the button
    CHECK(start.process().running());
    click(width - 56 - 20, height - 56 - 20); // the margin to both edges, and a little into the button
    CHECK(start.process().wait(60) == 2);
}

} // namespace meltpool::test
