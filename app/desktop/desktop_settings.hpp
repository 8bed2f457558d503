// Stores the window's settings in a file from one start to the next.
#pragma once

#include "app/session/lesson_session.hpp"
#include "app/session/settings.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool {

/// Values that the window itself remembers.
struct WindowParameters {
    int width = 1280; ///< points at an ordinary density
    int height = 720; ///< points at an ordinary density
    bool maximised = false;
    float interfaceSize = 1; ///< factor on the desktop's own scale
    int language = 0;        ///< index into languageChoices()
    int units = 0;           ///< index into UnitSystem
    int picture = 0;         ///< index into pictureChoices()
    int detail = 0;          ///< index into detailChoices(), in the headset too
};
ParameterList describe(WindowParameters& parameters);

/// The system's language, then each that has a words file: "system", "en", "de". Read once.
std::span<const std::string_view> languageChoices();

/// Speaks the language of this choice from now on; returns true if it was another before. Throws InputError if its
/// words file has a fault; the language stays as it was.
bool speakChosenLanguage(int choice);
/// The choice of the language that is spoken.
int spokenLanguageChoice();

/// Stores the values of the default lesson and of sections that belong to no lesson. Another lesson's values are not
/// stored.
class DesktopSettings {
  public:
    /// `file`: the settings file; empty: settings.toml in the user's settings folder.
    explicit DesktopSettings(const std::filesystem::path& file);

    /// Reads the file into `others` and its own copy of the default lesson. Returns one sentence for each fault in the
    /// file, and one if save() will fail.
    std::vector<std::string> load(const std::vector<ParameterSection*>& others);
    /// Writes the changes since load() into the file. Returns one sentence for each fault that has come into the file
    /// meanwhile. Throws InputError or RuntimeFault if writing fails.
    std::vector<std::string> save(const std::vector<ParameterSection*>& others);

    /// Sets the values of the default lesson to the stored ones; no-op for another lesson.
    void giveTo(const Lesson& lesson, LessonSections& sections);
    /// Stores the values of the default lesson from now on; no-op for another lesson.
    void takeFrom(const Lesson& lesson, LessonSections& sections);

  private:
    std::vector<SettingsSection> sections(const std::vector<ParameterSection*>& others);

    std::filesystem::path file_;
    Lesson lesson_; ///< the default lesson
    LessonSections lessonSections_;
    SettingsValues loaded_; ///< values after load() or the last save()
};

} // namespace meltpool
