#include "tests/app/markup.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <vector>

namespace meltpool::test {

std::string firstUnclosed(const std::string& html) {
    constexpr std::array<std::string_view, 5> kVoid{"meta", "input", "img", "br", "!doctype"};
    std::vector<std::string> open;
    for (size_t at = html.find('<'); at != std::string::npos; at = html.find('<', at + 1)) {
        const size_t end = html.find('>', at);
        if (end == std::string::npos) return "<";
        std::string name = html.substr(at + 1, html.find_first_of(" />\n", at + 2) - at - 1);
        std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
        if (name.starts_with('/')) {
            if (open.empty() || open.back() != name.substr(1)) return name;
            open.pop_back();
        } else if (html[end - 1] != '/' && std::find(kVoid.begin(), kVoid.end(), name) == kVoid.end()) {
            open.push_back(name);
        }
    }
    return open.empty() ? std::string() : open.back();
}

} // namespace meltpool::test
