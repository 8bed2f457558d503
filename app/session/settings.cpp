#include "app/session/settings.hpp"

#include "app/platform/aside_file.hpp"
#include "core/base/error.hpp"
#include "core/base/file_lock.hpp"
#include "core/base/output_file.hpp"
#include "core/base/text.hpp"
#include "core/base/toml_table.hpp"

#include <algorithm>
#include <deque>
#include <system_error>
#include <utility>
#include <variant>

namespace meltpool {

namespace fs = std::filesystem;

namespace {

std::string place(const fs::path& file, const toml::node& node) {
    return file.string() + ":" + std::to_string(node.source().begin.line);
}

/// Value as the text that setParameter() reads; "" for a type that no parameter has.
std::string valueText(const toml::node& node) {
    if (const auto* text = node.as_string()) return text->get();
    if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
    if (const auto* whole = node.as_integer()) return std::to_string(whole->get());
    if (const auto* number = node.as_floating_point()) return formatNumber(number->get());
    std::string joined;
    if (const auto* list = node.as_array())
        for (const toml::node& item : *list)
            joined += (joined.empty() ? "" : ",") + valueText(item);
    return joined;
}

void readSection(const fs::path& file, const toml::table& table, const SettingsSection& section,
                 std::vector<std::string>& faults) {
    for (const auto& [key, node] : table) {
        try {
            setParameter(section.parameters, key.str(), valueText(node), place(file, node));
        } catch (const InputError& fault) {
            faults.emplace_back(fault.what());
        }
    }
}

void readSections(const fs::path& file, const toml::table& root, const std::vector<SettingsSection>& sections,
                  std::vector<std::string>& faults) {
    for (const auto& [key, node] : root) {
        const std::string_view name = key.str(); // Clang's lambdas take no structured binding
        const auto known =
            std::find_if(sections.begin(), sections.end(), [&](const SettingsSection& s) { return s.name == name; });
        if (known != sections.end() && node.is_table()) {
            readSection(file, *node.as_table(), *known, faults);
            continue;
        }
        std::string names;
        for (const SettingsSection& s : sections)
            names += (names.empty() ? "[" : ", [") + s.name + "]";
        faults.push_back(place(file, node) + ": unknown entry " + quote(name) + "; expected a table of " + names);
    }
}

std::string tomlText(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    return out + "\"";
}

/// Number with a decimal point or exponent, so that a reader takes it as a real number.
std::string realText(float value) {
    const std::string text = formatNumber(value);
    return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

std::string tomlValue(const Parameter& p) {
    if (!p.choices.empty() || std::holds_alternative<std::string*>(p.value)) return tomlText(parameterText(p));
    if (const auto* number = std::get_if<float*>(&p.value)) return realText(**number);
    if (const auto* vector = std::get_if<glm::vec3*>(&p.value)) {
        const glm::vec3 v = **vector;
        return "[" + realText(v.x) + ", " + realText(v.y) + ", " + realText(v.z) + "]";
    }
    return parameterText(p);
}

/// Reads the file. `again`: reports only faults that were not reported before.
std::vector<std::string> readSettings(const fs::path& file, const std::vector<SettingsSection>& sections, bool again) {
    std::vector<std::string> faults;
    std::error_code unreadable;
    if (!fs::exists(file, unreadable)) return faults;
    bool broken = false;
    try {
        // A pipe would block until its writer opens it.
        if (!isPlainFile(file)) throw InputError(file, 0, "is not a settings file; expected a text file");
        readSections(file, parseTomlFile(file), sections, faults);
    } catch (const std::exception& fault) {
        faults.push_back(fault.what() + std::string("; the program uses its defaults instead"));
        broken = true;
    }
    if (faults.empty()) return faults;
    AsideFile aside = keepAside(file, broken);
    if (again && aside.before) return {};
    faults.push_back(std::move(aside.sentence));
    return faults;
}

/// Sections of these values with storage of their own.
class SettingsCopy {
  public:
    explicit SettingsCopy(const std::vector<SettingsSection>& sections) : sections_(sections) {
        for (SettingsSection& section : sections_)
            for (Parameter& p : section.parameters)
                std::visit([&](auto* value) { p.value = copied(*value); }, p.value);
    }
    SettingsCopy(const SettingsCopy&) = delete;
    SettingsCopy& operator=(const SettingsCopy&) = delete;

    const std::vector<SettingsSection>& sections() const { return sections_; }

  private:
    using Value = std::variant<float, int, bool, glm::vec3, std::string>;

    template <class T>
    T* copied(const T& value) {
        return &std::get<T>(values_.emplace_back(std::in_place_type<T>, value));
    }

    std::vector<SettingsSection> sections_;
    std::deque<Value> values_; ///< a deque, because the sections point to the values
};

} // namespace

SettingsValues valuesOf(const std::vector<SettingsSection>& sections) {
    SettingsValues values;
    for (const SettingsSection& section : sections)
        for (const Parameter& p : section.parameters)
            values.emplace(std::pair(section.name, std::string(p.key)), parameterText(p));
    return values;
}

std::vector<std::string> loadSettings(const fs::path& file, const std::vector<SettingsSection>& sections) {
    return readSettings(file, sections, false);
}

std::string settingsText(const std::vector<SettingsSection>& sections) {
    std::string text = "# Settings of the Meltpool desktop trainer. The program saves them when the window closes.\n";
    for (const SettingsSection& section : sections) {
        text += "\n[" + section.name + "]\n";
        for (const Parameter& p : section.parameters)
            text +=
                std::string(p.key) + " = " + tomlValue(p) + " # " + std::string(p.label) + ": " + expectation(p) + "\n";
    }
    return text;
}

std::string requireSavableSettings(const fs::path& file) {
    std::error_code failed;
    fs::create_directories(file.parent_path(), failed);
    if (failed)
        throw InputError(file.parent_path(), 0,
                         "the settings folder cannot be created: " + failed.message() +
                             "; expected a parent folder with write permission");
    requireWritable(file);
    return FileTurn(file).warning();
}

std::vector<std::string> saveSettings(const fs::path& file, const std::vector<SettingsSection>& sections,
                                      const SettingsValues& before) {
    requireSavableSettings(file);
    const FileTurn turn(file);
    const SettingsCopy written(sections);
    std::vector<std::string> faults = readSettings(file, written.sections(), true);
    for (size_t i = 0; i < sections.size(); ++i)
        for (const Parameter& p : sections[i].parameters) {
            const auto known = before.find({sections[i].name, std::string(p.key)});
            const std::string value = parameterText(p);
            if (known == before.end() || known->second != value)
                setParameter(written.sections()[i].parameters, p.key, value, file.string());
        }
    writeTextFileAtomically(file, settingsText(written.sections()));
    return faults;
}

} // namespace meltpool
