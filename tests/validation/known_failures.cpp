#include "tests/validation/known_failures.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"

namespace meltpool::test {

KnownFailures readKnownFailures(const std::filesystem::path& file, const std::filesystem::path& cases) {
    KnownFailures known;
    const std::string text = readTextFile(file);
    size_t number = 0;
    for (const std::string_view whole : splitText(text, '\n')) {
        const int line = static_cast<int>(++number);
        const std::string_view content = trimText(whole.substr(0, whole.find('#')));
        if (content.empty()) continue;
        const size_t colon = content.find(':');
        const std::string name(trimText(content.substr(0, colon)));
        const std::string reason(colon == std::string_view::npos ? "" : trimText(content.substr(colon + 1)));
        if (name.empty() || reason.empty()) throw InputError(file, line, "expected NAME: REASON");
        if (!std::filesystem::is_regular_file(cases / (name + ".toml")))
            throw InputError(file, line,
                             "there is no case '" + name + "'; expected the name of a file of " + cases.string() +
                                 " without .toml");
        if (!known.emplace(name, reason).second) throw InputError(file, line, "'" + name + "' stands twice");
    }
    return known;
}

std::string surpriseOf(const std::string& name, bool passed, const KnownFailures& known) {
    const auto found = known.find(name);
    if (found == known.end()) return passed ? "" : name + " fails and is no known failure";
    if (!passed) return "";
    return name + " passes, but known_failures.txt names it (" + found->second + "); remove its line";
}

} // namespace meltpool::test
