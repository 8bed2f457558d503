// Drives the running trainer as a person would: a display of its own, xdotool for hands, the telemetry for eyes.
#pragma once

#include "tests/desktop/driven/process.hpp"
#include "tests/support/telemetry_rows.hpp"

#include <nlohmann/json.hpp>

#include <functional>
#include <memory>
#include <optional>

namespace meltpool::test {

/// Xvfb on a display number that was free. A missing Xvfb fails the test.
class VirtualDisplay {
  public:
    explicit VirtualDisplay(int dotsPerInch, int width = 1600, int height = 1000);
    const std::string& name() const { return name_; }
    /// Kills the server, as one that crashes or whose machine goes away.
    void kill();

  private:
    std::string name_;
    std::unique_ptr<Process> server_;
};

/// The display that the tests share, of ordinary density.
VirtualDisplay& sharedDisplay();

/// Few particles on a coarse grid in a small window, so that frames are quick on any machine.
extern const char* const kSmallSettings;

class TrainerWindow {
  public:
    struct Options {
        std::string settings = kSmallSettings; ///< what the settings file holds at the start; empty: there is none
        std::string lesson = "classic";        ///< named on the command line; empty: none is
        std::vector<std::string> arguments = {};
        std::filesystem::path data = {}; ///< shaders and data; empty: those of the build
        VirtualDisplay* display = nullptr;
        std::map<std::string, std::string> environment = {};
    };

    /// Starts the program in the scratch folder `name` and waits for its first telemetry.
    TrainerWindow(const std::string& name, const Options& options);

    /// Whether a row within so many frames from now fulfils the condition.
    bool comesTrue(int frames, const std::function<bool(const nlohmann::json&)>& condition);

    /// The newest telemetry.
    nlohmann::json state() const;
    /// The first row that fulfils `condition` among all since the last word to xdotool or the row of the last such
    /// wait, whichever is the later; waits for it. What holds for a moment only is seen too, however long this test
    /// stands still. Fails the test, saying `what`, when there never is one.
    nlohmann::json waitFor(const std::string& what, const std::function<bool(const nlohmann::json&)>& condition);
    /// Waits for a few whole frames after what was done until now.
    nlohmann::json settle();
    /// Acts, such as by click(), until the parameter has another text than before: a press can fall between two frames
    /// where they are slow, and a person would press again.
    void change(const std::string& section, const std::string& key, const std::function<void()>& act);

    /// xdotool with these words. A missing xdotool fails the test.
    void xdotool(std::vector<std::string> words) const;
    void key(const std::string& name) { xdotool({"key", name}); }
    /// Holds a key until `condition` is fulfilled.
    void holdKey(const std::string& name, const std::string& what,
                 const std::function<bool(const nlohmann::json&)>& condition);
    void moveMouse(double x, double y) const;
    /// Clicks the control of that name, scrolling its panel until it is in sight.
    void click(const std::string& place);
    /// Pulls a slider's handle to a share of its length.
    void pull(const std::string& place, double share);
    /// Where a control is; fails the test when it cannot be brought in sight.
    std::array<double, 4> place(const std::string& name);

    /// Start with the values as they stand, and wait until the metal runs.
    void start();
    /// F10; the picture goes to the build folder's desktop-pictures/NAME.png. Returns where.
    std::filesystem::path takePicture(const std::string& name);

    /// As the cross of the window does.
    void closeWindow();
    /// Waits for the end; the exit code.
    int finish();
    Process& process() { return *process_; }

    const std::filesystem::path& folder() const { return folder_; }
    std::filesystem::path recordingsFolder() const { return folder_ / "data" / "meltpool" / "recordings"; }
    std::filesystem::path settingsFile() const { return folder_ / "config" / "meltpool" / "settings.toml"; }
    std::string output() const;

  private:
    /// Waits for the first row from `from` on that fulfils the condition; moves `from` to its begin.
    nlohmann::json firstRow(std::streamoff& from, const std::string& what,
                            const std::function<bool(const nlohmann::json&)>& condition);

    std::filesystem::path folder_;
    TelemetryRows rows_;
    mutable std::streamoff since_ = 0; ///< where the rows begin that waitFor() looks at
    std::string display_;
    std::unique_ptr<Process> process_;
};

/// A parameter's text in the telemetry.
std::string parameterIn(const nlohmann::json& state, const std::string& section, const std::string& key);

} // namespace meltpool::test
