#include "app/desktop/desktop_settings.hpp"

#include "app/desktop/detail_choice.hpp"
#include "app/desktop/picture_quality.hpp"
#include "core/base/resources.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace meltpool {

namespace {

/// Copies values between two sections of one lesson. A test is chosen for each attempt.
void copyValues(LessonSections& from, LessonSections& to) {
    const std::vector<ParameterSection*> sources = from.all();
    const std::vector<ParameterSection*> targets = to.all();
    for (size_t i = 0; i < sources.size(); ++i)
        for (const Parameter& p : sources[i]->parameters)
            if (p.key != "for_score") setParameter(targets[i]->parameters, p.key, parameterText(p), sources[i]->name);
}

/// Languages of the settings. The first is the system's.
struct LanguageList {
    LanguageList() : users(usersLanguage()), keys(languages()) {
        keys.insert(keys.begin(), "system");
        names.emplace_back(); // a phrase, in the language that is spoken
        for (size_t i = 1; i < keys.size(); ++i)
            names.push_back(languageName(keys[i]));
        choices.assign(keys.begin(), keys.end());
        shownNames.assign(names.begin(), names.end());
    }
    LanguageList(const LanguageList&) = delete; // views of its own texts
    LanguageList& operator=(const LanguageList&) = delete;

    std::string_view wanted(int choice) const { return choice == 0 ? users : keys[static_cast<size_t>(choice)]; }

    std::string users; ///< without a choice
    std::vector<std::string> keys, names;
    std::vector<std::string_view> choices, shownNames;
};

const LanguageList& languageList() {
    static const LanguageList list;
    return list;
}

constexpr std::array<std::string_view, 2> kUnitChoices{"millimetres", "inches"}; // in the order of UnitSystem

} // namespace

ParameterList describe(WindowParameters& w) {
    return {
        {"width", "Width", "points", &w.width, 640, 16384,
         "Width of the window at the next start. It grows with the desktop's scale and fits the screen."},
        {"height", "Height", "points", &w.height, 480, 16384,
         "Height of the window at the next start. It grows with the desktop's scale and fits the screen."},
        {"maximised", "Maximised", "", &w.maximised, 0, 1, "The window fills the screen at the next start."},
        {"interface_size", "Size of text and menus", "", &w.interfaceSize, 0.7, 2,
         "Factor on the desktop's own scale. Large menus cover more of the picture."},
        {"language", "Language", "", &w.language, 0, static_cast<double>(languageChoices().size() - 1),
         "Of window, headset and pages. Sentences that a language lacks are in English.", languageChoices(), false,
         languageList().shownNames},
        {"units", "Lengths", "", &w.units, 0, 1,
         "Speeds and areas follow. Files and results on the terminal stay metric.", kUnitChoices},
        {"picture", "Picture", "", &w.picture, 0, kPictureLevels,
         "Fineness of the picture. Automatic leaves enough time for the metal. Text and menus are always full.",
         pictureChoices()},
        {"detail", "Detail", "", &w.detail, 0, 3,
         "Detail in window and headset. Automatic is low without a graphics card, else as high as it draws in time.",
         detailChoices()},
    };
}

std::span<const std::string_view> languageChoices() {
    return languageList().choices;
}

bool speakChosenLanguage(int choice) {
    const std::string_view wanted = languageList().wanted(choice);
    if (wanted == language()) return false;
    chooseLanguage(wanted);
    return true;
}

int spokenLanguageChoice() {
    const auto& keys = languageList().keys;
    const auto found = std::find(keys.begin() + 1, keys.end(), language());
    return found == keys.end() ? 0 : static_cast<int>(found - keys.begin());
}

DesktopSettings::DesktopSettings(const std::filesystem::path& file)
    : file_(file.empty() ? settingsFolder() / "settings.toml" : file),
      lesson_(loadLesson(std::string(kDefaultLesson))),
      lessonSections_(lesson_) {}

std::vector<SettingsSection> DesktopSettings::sections(const std::vector<ParameterSection*>& others) {
    std::vector<ParameterSection*> all = lessonSections_.all();
    all.insert(all.end(), others.begin(), others.end());
    std::vector<SettingsSection> made;
    ParameterList kept;
    for (const ParameterSection* each : all) {
        made.push_back({each->name, {}});
        for (const Parameter& p : each->parameters) {
            // Stores a value of two menus only once, in the first of their sections.
            const bool known =
                std::any_of(kept.begin(), kept.end(), [&p](const Parameter& k) { return k.value == p.value; });
            if (known) continue;
            kept.push_back(p);
            made.back().parameters.push_back(p);
        }
    }
    return made;
}

std::vector<std::string> DesktopSettings::load(const std::vector<ParameterSection*>& others) {
    std::vector<std::string> faults = loadSettings(file_, sections(others));
    loaded_ = valuesOf(sections(others));
    try {
        if (std::string warning = requireSavableSettings(file_); !warning.empty()) faults.push_back(std::move(warning));
    } catch (const std::exception& fault) {
        faults.push_back(phrase("desk.message.settings_not_saved", {{"reason", fault.what()}}));
    }
    return faults;
}

std::vector<std::string> DesktopSettings::save(const std::vector<ParameterSection*>& others) {
    const std::vector<SettingsSection> all = sections(others);
    std::vector<std::string> faults = saveSettings(file_, all, loaded_);
    loaded_ = valuesOf(all);
    return faults;
}

void DesktopSettings::giveTo(const Lesson& lesson, LessonSections& sections) {
    if (lesson.file == lesson_.file) copyValues(lessonSections_, sections);
}

void DesktopSettings::takeFrom(const Lesson& lesson, LessonSections& sections) {
    if (lesson.file == lesson_.file) copyValues(sections, lessonSections_);
}

} // namespace meltpool
