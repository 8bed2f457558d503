#include "tests/desktop/driven/driver.hpp"

#include "core/base/text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/places.hpp"

#include <X11/Xatom.h>
#include <X11/Xlib.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <sstream>
#include <thread>
#include <unistd.h>

namespace meltpool::test {

namespace fs = std::filesystem;
using nlohmann::json;
using Clock = std::chrono::steady_clock;

namespace {

/// Time limit, s, far beyond any run of these tests: only a hang reaches it.
constexpr double kPatience = 300;

void nap(double seconds) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

std::string readAll(const fs::path& file) {
    std::ifstream in(file);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

/// Reads the line that the other end writes; empty if it closes first.
std::string readLine(int descriptor) {
    std::string line;
    char c = 0;
    while (read(descriptor, &c, 1) == 1 && c != '\n')
        line += c;
    return line;
}

/// Returns true if a control is whole, not cut off by the edge of a scrolling part of the page.
bool isWhole(const json& places, const std::array<double, 4>& control) {
    for (const char* part : {"start.values", "home.lessons"}) {
        if (!places.contains(part)) continue;
        const auto area = places.at(part).get<std::array<double, 4>>();
        const double top = control[1], bottom = control[1] + control[3], end = area[1] + area[3];
        if (bottom > area[1] && top < end && (top < area[1] - 1 || bottom > end + 1)) return false;
    }
    return true;
}

} // namespace

const char* const kSmallSettings = "[start]\nparticles = 1000\ncells = 16\n"
                                   "[view]\nmode = \"points\"\nshow_sky = false\n[window]\nwidth = 960\nheight = 640\n";

VirtualDisplay::VirtualDisplay(int dotsPerInch, int width, int height) {
    std::array<int, 2> ends{};
    REQUIRE(pipe(ends.data()) == 0);
    server_ = std::make_unique<Process>(Process::Options{
        .command = {"Xvfb", "-displayfd", "3", "-screen", "0",
                    std::to_string(width) + "x" + std::to_string(height) + "x24", "-noreset", "-nolisten", "tcp"},
        .passedPipe = ends[1]});
    close(ends[1]);
    const std::string number = readLine(ends[0]);
    close(ends[0]);
    INFO("the desktop tests need Xvfb; install the package xvfb");
    REQUIRE_FALSE(number.empty());
    name_ = ":" + number;
    // Resources of a desktop that give the density of its screen.
    Display* display = XOpenDisplay(name_.c_str());
    REQUIRE(display != nullptr);
    const std::string resources = "Xft.dpi:\t" + std::to_string(dotsPerInch) + "\n";
    XChangeProperty(display, DefaultRootWindow(display), XA_RESOURCE_MANAGER, XA_STRING, 8, PropModeReplace,
                    reinterpret_cast<const unsigned char*>(resources.data()), static_cast<int>(resources.size()));
    // A key struck by xdotool stays down while the machine keeps xdotool waiting, and would be repeated.
    XAutoRepeatOff(display);
    XCloseDisplay(display);
}

void VirtualDisplay::kill() {
    server_->signal(SIGKILL);
}

VirtualDisplay& sharedDisplay() {
    static VirtualDisplay only(96);
    return only;
}

TrainerWindow::TrainerWindow(const std::string& name, const Options& options)
    : folder_(scratchFolder(name)),
      rows_(folder_ / "telemetry.jsonl"),
      display_((options.display == nullptr ? sharedDisplay() : *options.display).name()) {
    fs::create_directories(folder_ / "home" / "Pictures");
    fs::create_directories(settingsFile().parent_path());
    if (!options.settings.empty()) writeTextFileAtomically(settingsFile(), options.settings);
    Process::Options process;
    process.command = {MELTPOOL_PROGRAM, "--telemetry", (folder_ / "telemetry.jsonl").string()};
    if (!options.lesson.empty()) process.command.insert(process.command.end(), {"--lesson", options.lesson});
    process.command.insert(process.command.end(), options.arguments.begin(), options.arguments.end());
    const fs::path data = options.data.empty() ? test::buildFolder() / "share" / "meltpool" : options.data;
    process.environment = {{"DISPLAY", display_},
                           {"HOME", (folder_ / "home").string()},
                           {"XDG_CONFIG_HOME", (folder_ / "config").string()},
                           {"XDG_DATA_HOME", (folder_ / "data").string()},
                           {"XDG_PICTURES_DIR", ""},
                           {"WAYLAND_DISPLAY", ""},
                           // Mesa's compiled shaders, which every window's own home would compile again.
                           {"MESA_SHADER_CACHE_DIR", (test::buildFolder() / "tests" / "shader-cache").string()},
                           {"MELTPOOL_DATA", data.string()}};
    for (const auto& [variable, value] : options.environment)
        process.environment[variable] = value;
    process.folder = folder_;
    process.output = folder_ / "output.txt";
    process_ = std::make_unique<Process>(process);
    moveMouse(5, 635);
    waitFor("the window's first frames", [](const json& s) { return s.at("frame") > 2; });
    since_ = 0; // rows of the window's start count as well
}

json TrainerWindow::state() const {
    return rows_.newest();
}

json TrainerWindow::firstRow(std::streamoff& from, const std::string& what,
                             const std::function<bool(const json&)>& condition) {
    const auto end = Clock::now() + std::chrono::duration<double>(kPatience);
    json last;
    for (bool over = false; !over; nap(0.01)) {
        over = !process_->running() || Clock::now() >= end; // read first, so that no row is left out
        for (std::streamoff next = from;; from = next) {
            json row = rows_.read(next);
            if (!row.is_object()) break;
            if (condition(row)) return row;
            last = std::move(row);
        }
    }
    if (last.is_object()) last.erase("places");
    FAIL("waited in vain for " << what << (process_->running() ? "" : "; the program has ended")
                               << "\nits words: " << output() << "\nlast telemetry: " << last.dump());
    return last;
}

json TrainerWindow::waitFor(const std::string& what, const std::function<bool(const json&)>& condition) {
    return firstRow(since_, what, condition);
}

bool TrainerWindow::comesTrue(int frames, const std::function<bool(const json&)>& condition) {
    const long long last = state().at("frame").get<long long>() + frames;
    bool came = false;
    waitFor("frames to pass", [&](const json& now) {
        came = condition(now);
        return came || now.at("frame").get<long long>() > last;
    });
    return came;
}

json TrainerWindow::settle() {
    // The frame of the next row may have begun before the action; those after it have not.
    std::streamoff from = rows_.end();
    long long next = -1;
    return firstRow(from, "a few frames", [&](const json& row) {
        const long long frame = row.at("frame").get<long long>();
        if (next < 0) next = frame;
        return frame >= next + 2;
    });
}

void TrainerWindow::change(const std::string& section, const std::string& key, const std::function<void()>& act) {
    const std::string before = parameterIn(settle(), section, key);
    const auto changed = [&](const json& row) { return parameterIn(row, section, key) != before; };
    for (int attempt = 0; attempt < 3; ++attempt) {
        act();
        if (comesTrue(60, changed)) return;
    }
    waitFor(section + "." + key + " to change", changed);
}

void TrainerWindow::act(const std::function<void()>& change) const {
    since_ = rows_.end();
    change();
}

void TrainerWindow::xdotool(std::vector<std::string> words) const {
    words.insert(words.begin(), "xdotool");
    since_ = rows_.end();
    const int code = runCommand(words, {{"DISPLAY", display_}});
    INFO("the desktop tests need xdotool; install the package xdotool");
    REQUIRE(code == 0);
}

void TrainerWindow::holdKey(const std::string& name, const std::string& what,
                            const std::function<bool(const json&)>& condition) {
    xdotool({"keydown", name});
    waitFor(what, condition);
    xdotool({"keyup", name});
    settle();
}

void TrainerWindow::moveMouse(double x, double y) const {
    xdotool({"mousemove", std::to_string(static_cast<int>(x)), std::to_string(static_cast<int>(y))});
}

std::array<double, 4> TrainerWindow::place(const std::string& name) {
    const auto find = [&](const json& s) -> std::optional<std::array<double, 4>> {
        const json& places = s.at("places");
        if (!places.contains(name)) return std::nullopt;
        return places.at(name).get<std::array<double, 4>>();
    };
    json now = settle();
    const bool left = name.rfind("simulation.", 0) != 0;
    const double width = now.at("window").at("size").at(0);
    bool overPanel = false;
    // The scrolling part of a page is lower than three notches of the wheel: it would jump over a control.
    const char* const clicks = now.at("page") == "running" ? "3" : "1";
    constexpr int kDown = 60, kAll = 130;
    for (int notch = 0; notch < kAll; ++notch) {
        // A control at the panel's edge is in sight but not in reach: it must be whole, above the status bar.
        const double low = now.at("window").at("size").at(1).get<double>() - (now.at("page") == "running" ? 65 : 0);
        if (const auto found = find(now);
            found && (*found)[1] + (*found)[3] < low && isWhole(now.at("places"), *found)) {
            // A notch of the wheel still in progress would move the control away from the mouse.
            now = settle();
            if (find(now) == found) return *found;
            continue;
        }
        if (!overPanel) moveMouse(now.at("page") != "running" ? width / 2 : (left ? 200 : width - 200), 300);
        overPanel = true;
        xdotool({"click", "--repeat", clicks, "--delay", "5", notch < kDown ? "5" : "4"});
        now = settle();
    }
    FAIL("no control '" << name << "' can be brought in sight; in sight: " << now.at("places").dump());
    return {};
}

void TrainerWindow::click(const std::string& name) {
    const auto [x, y, width, height] = place(name);
    moveMouse(x + width / 2, y + height / 2);
    settle();
    xdotool({"mousedown", "1"});
    settle();
    xdotool({"mouseup", "1"});
    settle();
}

void TrainerWindow::pull(const std::string& name, double share) {
    const auto [x, y, width, height] = place(name);
    moveMouse(x + width / 2, y + height / 2);
    settle();
    xdotool({"mousedown", "1"});
    settle();
    moveMouse(x + width * share, y + height / 2);
    settle();
    xdotool({"mouseup", "1"});
    settle();
}

void TrainerWindow::start() {
    click("start.start");
    waitFor("the metal to run", [](const json& s) {
        return s.at("page") == "running" && s.at("metal").at("steps") > 0 && s.at("metal").at("particles") > 0;
    });
}

fs::path TrainerWindow::takePicture(const std::string& name) {
    const std::string before = state().at("screenshot");
    key("F10");
    const json now = waitFor("a picture", [&](const json& s) { return s.at("screenshot") != before; });
    const fs::path kept = test::buildFolder() / "desktop-pictures" / (name + ".png");
    fs::create_directories(kept.parent_path());
    fs::copy_file(now.at("screenshot").get<std::string>(), kept, fs::copy_options::overwrite_existing);
    return kept;
}

void TrainerWindow::closeWindow() {
    Display* display = XOpenDisplay(display_.c_str());
    REQUIRE(display != nullptr);
    Window root = 0;
    Window parent = 0;
    Window* children = nullptr;
    unsigned count = 0;
    XQueryTree(display, DefaultRootWindow(display), &root, &parent, &children, &count);
    const Atom protocols = XInternAtom(display, "WM_PROTOCOLS", False);
    const Atom farewell = XInternAtom(display, "WM_DELETE_WINDOW", False);
    for (unsigned i = 0; i < count; ++i) {
        XEvent event;
        std::memset(&event, 0, sizeof event);
        event.xclient.type = ClientMessage;
        event.xclient.window = children[i];
        event.xclient.message_type = protocols;
        event.xclient.format = 32;
        event.xclient.data.l[0] = static_cast<long>(farewell);
        XSendEvent(display, children[i], False, NoEventMask, &event);
    }
    XFree(children);
    XCloseDisplay(display);
}

int TrainerWindow::finish() {
    return process_->wait(kPatience);
}

std::string TrainerWindow::output() const {
    return readAll(folder_ / "output.txt");
}

std::string parameterIn(const json& state, const std::string& section, const std::string& key) {
    return state.at("parameters").at(section).at(key);
}

} // namespace meltpool::test
