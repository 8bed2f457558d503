// What the window keeps in the settings file from one start to the next.
#pragma once

#include "app/session/lesson_session.hpp"
#include "app/session/settings.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace meltpool {

/// What the window itself remembers.
struct WindowParameters {
    int width = 1280; ///< screen points
    int height = 720; ///< screen points
    bool maximised = false;
    float interfaceSize = 1; ///< factor on what the desktop asks for
};
ParameterList describe(WindowParameters& parameters);

/// Keeps the values of the default lesson and of sections that belong to no lesson. Another lesson's values are not
/// kept.
class DesktopSettings {
  public:
    /// `file`: empty: settings.toml in the user's settings folder. `lesson`: the one that runs.
    DesktopSettings(const std::filesystem::path& file, const std::string& lesson);

    /// Reads the file into `running` (or the default lesson's own copy) and `others`. Answers one sentence for each
    /// fault in the file, and one where save() will fail.
    std::vector<std::string> load(LessonSections& running, const std::vector<ParameterSection*>& others);
    /// Writes the file. Throws InputError when that fails.
    void save(LessonSections& running, const std::vector<ParameterSection*>& others);

  private:
    std::vector<SettingsSection> sections(LessonSections& running, const std::vector<ParameterSection*>& others);

    std::filesystem::path file_;
    std::optional<Lesson> lesson_; ///< the default one, where another one runs
    std::optional<LessonSections> lessonSections_;
};

} // namespace meltpool
