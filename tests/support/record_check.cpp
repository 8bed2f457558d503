#include "tests/support/record_check.hpp"

#include "core/base/text.hpp"

#include <algorithm>

namespace meltpool::test {

RecordCheck checkRecord(const std::filesystem::path& file) {
    constexpr std::string_view kEnded = "# ended ";
    RecordCheck check;
    const std::string text = readTextFile(file);
    check.endsWhole = text.empty() || text.back() == '\n';
    size_t cells = 0; // number of cells of the header, which is the first line without #
    int number = 0;
    for (const std::string_view line : splitText(text, '\n')) {
        ++number;
        if (line.substr(0, kEnded.size()) == kEnded) check.ended = line.substr(kEnded.size());
        if (line.empty() || line.front() == '#') continue;
        const size_t found = splitText(line, ',').size();
        if (cells == 0) {
            cells = found;
            continue;
        }
        const auto time = parseDouble(line.substr(0, line.find(',')));
        const bool empty = line.find(",,") != std::string_view::npos || line.back() == ',';
        if (found != cells || !time || empty) {
            check.broken.push_back(std::to_string(number) + ": " + std::string(line));
            continue;
        }
        ++check.rows;
        check.lastTime = *time;
    }
    return check;
}

} // namespace meltpool::test
