// What the window keeps in the settings file from one start to the next.
#pragma once

#include "app/session/lesson_session.hpp"
#include "app/session/settings.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace meltpool {

/// What the window itself remembers.
struct WindowParameters {
    int width = 1280; ///< points at an ordinary density
    int height = 720; ///< the same
    bool maximised = false;
    float interfaceSize = 1; ///< factor on what the desktop asks for
    int picture = 0;         ///< see pictureChoices()
    int detail = 0;          ///< see detailChoices(), in the headset too
};
ParameterList describe(WindowParameters& parameters);

/// Keeps the values of the default lesson and of sections that belong to no lesson. Another lesson's values are not
/// kept.
class DesktopSettings {
  public:
    /// `file`: empty: settings.toml in the user's settings folder.
    explicit DesktopSettings(const std::filesystem::path& file);

    /// Reads the file into `others` and its own copy of the default lesson. Answers one sentence for each fault in the
    /// file, and one where save() will fail.
    std::vector<std::string> load(const std::vector<ParameterSection*>& others);
    /// Writes what has changed since load() into the file. Answers one sentence for each fault that has come into the
    /// file meanwhile. Throws InputError or RuntimeFault when writing fails.
    std::vector<std::string> save(const std::vector<ParameterSection*>& others);

    /// Where the lesson is the default one, sets its values to the kept ones.
    void giveTo(const Lesson& lesson, LessonSections& sections);
    /// Where the lesson is the default one, keeps its values from now on.
    void takeFrom(const Lesson& lesson, LessonSections& sections);

  private:
    std::vector<SettingsSection> sections(const std::vector<ParameterSection*>& others);

    std::filesystem::path file_;
    Lesson lesson_; ///< the default one
    LessonSections lessonSections_;
    SettingsValues loaded_; ///< as they were after load(), or as they were saved since
};

} // namespace meltpool
