// Drives the running trainer as a person would: a display of its own, xdotool for hands, the telemetry for eyes.
#pragma once

#include "tests/desktop/driven/process.hpp"
#include "tests/support/telemetry_rows.hpp"

#include <nlohmann/json.hpp>

#include <functional>
#include <memory>
#include <optional>

namespace meltpool::test {

/// Runs Xvfb on a free display number. A missing Xvfb fails the test.
class VirtualDisplay {
  public:
    explicit VirtualDisplay(int dotsPerInch, int width = 1600, int height = 1000);
    const std::string& name() const { return name_; }
    /// Kills the server, as in a crash or the loss of its machine.
    void kill();

  private:
    std::string name_;
    std::unique_ptr<Process> server_;
};

/// Returns the display that the tests share, of ordinary density.
VirtualDisplay& sharedDisplay();

/// Settings with few particles on a coarse grid in a small window, so that frames are quick on any machine.
extern const char* const kSmallSettings;

class TrainerWindow {
  public:
    struct Options {
        std::string settings = kSmallSettings; ///< content of the settings file at the start; empty: no file
        std::string lesson = "classic";        ///< lesson on the command line; empty: none
        std::vector<std::string> arguments = {};
        std::filesystem::path data = {}; ///< shaders and data; empty: those of the build
        VirtualDisplay* display = nullptr;
        std::map<std::string, std::string> environment = {};
    };

    /// Starts the program in the scratch folder `name` and waits for its first telemetry.
    TrainerWindow(const std::string& name, const Options& options);

    /// Returns true if a row within the next `frames` frames fulfils the condition.
    bool comesTrue(int frames, const std::function<bool(const nlohmann::json&)>& condition);

    /// Newest row of the telemetry.
    nlohmann::json state() const;
    /// Waits for the first row that fulfils `condition`, among all rows since the last call of xdotool or the row of
    /// the last such wait, whichever is later, and returns it. It sees states of a moment as well, however long this
    /// test pauses. Fails the test with `what` if no such row comes.
    nlohmann::json waitFor(const std::string& what, const std::function<bool(const nlohmann::json&)>& condition);
    /// Waits until a few whole frames have passed after the last action.
    nlohmann::json settle();
    /// Repeats `act`, such as click(), until the parameter has another text than before: a press can fall between two
    /// frames if they are slow, and a person would press again.
    void change(const std::string& section, const std::string& key, const std::function<void()>& act);

    /// Makes a change other than by xdotool; later waits see only rows from then on.
    void act(const std::function<void()>& change) const;
    /// Calls xdotool with these words. A missing xdotool fails the test.
    void xdotool(std::vector<std::string> words) const;
    void key(const std::string& name) { xdotool({"key", name}); }
    void type(const std::string& text) { xdotool({"type", text}); }
    /// Holds a key until `condition` is fulfilled.
    void holdKey(const std::string& name, const std::string& what,
                 const std::function<bool(const nlohmann::json&)>& condition);
    void moveMouse(double x, double y) const;
    /// Clicks the control of that name, scrolling its panel until it is in sight.
    void click(const std::string& place);
    /// Pulls a slider's handle to a share of its length.
    void pull(const std::string& place, double share);
    /// Returns the place of a control; fails the test if it cannot be brought into sight.
    std::array<double, 4> place(const std::string& name);

    /// Starts the lesson with its current values, and waits until the metal runs.
    void start();
    /// Takes a picture by F10, moves it to the build folder's desktop-pictures/NAME.png and returns its file.
    std::filesystem::path takePicture(const std::string& name);

    /// Closes the window as its cross does.
    void closeWindow();
    /// Waits for the end; returns the exit code.
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
    mutable std::streamoff since_ = 0; ///< position of the first row that waitFor() reads
    std::string display_;
    std::unique_ptr<Process> process_;
};

/// Returns a parameter's text in the telemetry.
std::string parameterIn(const nlohmann::json& state, const std::string& section, const std::string& key);

} // namespace meltpool::test
