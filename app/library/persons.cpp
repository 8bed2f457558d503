#include "app/library/persons.hpp"

#include "core/base/error.hpp"
#include "core/base/file_lock.hpp"
#include "core/base/moment.hpp"
#include "core/base/resources.hpp"
#include "core/base/text.hpp"
#include "core/base/toml_table.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <cctype>
#include <random>
#include <utility>

namespace meltpool {

namespace fs = std::filesystem;

namespace {

constexpr const char* kPersonFile = "person.toml";
constexpr size_t kIdDigits = 16;
constexpr size_t kMostBytes = 2000; ///< bytes of a fault's sentence
constexpr size_t kMostSeen = 40;    ///< bytes of a moment

/// Count of code points of a UTF-8 text.
size_t letters(std::string_view text) {
    return static_cast<size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

/// The text with small letters for A to Z and for the capitals of Latin-1.
std::string folded(std::string_view text) {
    std::string low = lowerCase(text);
    for (size_t i = 1; i < low.size(); ++i) {
        const auto c = static_cast<unsigned char>(low[i]);
        if (static_cast<unsigned char>(low[i - 1]) == 0xC3 && c >= 0x80 && c <= 0x9E && c != 0x97)
            low[i] = static_cast<char>(c + 0x20);
    }
    return low;
}

bool isId(const std::string& text) {
    return text.size() == kIdDigits && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

std::string newId() {
    std::random_device random;
    return formatHexadecimal((static_cast<std::uint64_t>(random()) << 32) | random());
}

KnownPerson readPerson(const fs::path& folder) {
    const fs::path file = folder / kPersonFile;
    const toml::table parsed = parseTomlFile(file);
    TomlTable table(parsed, file);
    KnownPerson person;
    person.id = folder.filename().string();
    try {
        person.name = personName(table.text("name"));
    } catch (const InputError& fault) {
        throw InputError(file, table.lineOf("name"), fault.what());
    }
    person.seen = printable(table.text("seen", ""), kMostSeen);
    table.finish();
    return person;
}

std::string tomlText(const std::string& text) {
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += c;
    }
    return quoted + "\"";
}

void writePerson(const fs::path& folder, const KnownPerson& person) {
    std::error_code failure;
    fs::create_directories(folder / person.id, failure);
    if (failure)
        throw InputError(folder / person.id, 0,
                         "the person's folder cannot be created: " + failure.message() +
                             "; expected a parent folder with write permission");
    writeTextFileAtomically(folder / person.id / kPersonFile,
                            "# A person of the Meltpool trainer; written when the name is chosen.\nname = " +
                                tomlText(person.name) + "\nseen = " + tomlText(person.seen) + "\n");
}

} // namespace

std::string personName(std::string_view typed) {
    std::string name;
    for (const char c : typed) {
        const bool blank = c == ' ' || (c >= '\t' && c <= '\r');
        if (!blank)
            name += c;
        else if (!name.empty() && name.back() != ' ')
            name += ' ';
    }
    if (!name.empty() && name.back() == ' ') name.pop_back();
    if (name.empty()) throw InputError(phrase("persons.refused.empty", {{"most", std::to_string(kLongestName)}}));
    if (printable(name, std::max(kMostBytes, 8 * name.size())) != name)
        throw InputError(phrase("persons.refused.signs", {{"name", quote(name)}}));
    if (letters(name) > kLongestName)
        throw InputError(phrase(
            "persons.refused.long",
            {{"name", quote(name)}, {"count", std::to_string(letters(name))}, {"most", std::to_string(kLongestName)}}));
    return name;
}

bool sameName(std::string_view a, std::string_view b) {
    return folded(a) == folded(b);
}

fs::path personsFolder() {
    return keptFolder() / "persons";
}

Persons::Persons(fs::path folder) : folder_(std::move(folder)) {
    refresh();
}

void Persons::refresh() {
    all_.clear();
    faults_.clear();
    if (folder_.empty()) return;
    std::error_code failure;
    for (fs::directory_iterator each(folder_, failure), end; !failure && each != end; each.increment(failure)) {
        std::error_code missing;
        if (!isId(each->path().filename().string()) || !fs::exists(each->path() / kPersonFile, missing)) continue;
        try {
            all_.push_back(readPerson(each->path()));
        } catch (const std::exception& fault) {
            faults_.push_back(printable(fault.what(), kMostBytes));
        }
    }
    std::sort(all_.begin(), all_.end(), [](const KnownPerson& a, const KnownPerson& b) {
        return std::pair(a.seen, a.name) > std::pair(b.seen, b.name);
    });
    std::sort(faults_.begin(), faults_.end());
}

const KnownPerson* Persons::find(std::string_view name) const {
    const auto found =
        std::find_if(all_.begin(), all_.end(), [&](const KnownPerson& person) { return sameName(person.name, name); });
    return found == all_.end() ? nullptr : &*found;
}

KnownPerson Persons::signIn(std::string_view typed) {
    KnownPerson person{{}, personName(typed), {}};
    if (folder_.empty()) throw InputError("there is no folder for persons; expected one");
    const FileTurn turn(folder_ / "persons");
    refresh();
    if (const KnownPerson* known = find(person.name))
        person = *known;
    else
        person.id = newId();
    // Later than everybody's, also within one millisecond and after the clock was set back.
    Moment now = momentNow();
    for (const KnownPerson& each : all_)
        if (const auto seen = parseMoment(each.seen)) now = std::max(now, *seen + std::chrono::milliseconds(1));
    person.seen = utcText(now);
    writePerson(folder_, person);
    refresh();
    return person;
}

fs::path Persons::scoresFile(const KnownPerson& person) const {
    return folder_ / person.id / "best-scores.toml";
}

fs::path Persons::settingsFile(const KnownPerson& person) const {
    return folder_ / person.id / "settings.toml";
}

} // namespace meltpool
