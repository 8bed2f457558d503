#include "core/base/table_reader.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <array>
#include <set>

namespace meltpool {

namespace {

constexpr std::array<char, 3> kSeparators{'\t', ';', ','}; ///< the likelier first, for equal counts
constexpr int kMostLinesAbove = 100;                       ///< lines searched for the header
constexpr std::string_view kSeparatorLine = "sep=";

bool isBlank(char c) {
    return c == ' ' || c == '\t';
}

std::string_view withoutQuotes(std::string_view cell) {
    cell = trimText(cell);
    return cell.size() >= 2 && cell.front() == '"' && cell.back() == '"' ? cell.substr(1, cell.size() - 2) : cell;
}

std::string separatorName(char separator) {
    if (separator == ',') return phrase("table_form.commas");
    if (separator == ';') return phrase("table_form.semicolons");
    return separator == '\t' ? phrase("table_form.tabs") : quote(std::string(1, separator));
}

} // namespace

std::string TableForm::text() const {
    const std::string between = separatorName(separator), lines = std::to_string(linesAbove);
    const std::string_view coded = encodingName(encoding);
    if (linesAbove > 0)
        return phraseOfCount(decimalComma ? "table_form.comma_below_lines" : "table_form.point_below_lines", linesAbove,
                             {{"encoding", coded}, {"separator", between}, {"lines", lines}});
    return phrase(decimalComma ? "table_form.comma" : "table_form.point",
                  {{"encoding", coded}, {"separator", between}});
}

TableReader::TableReader(std::string bytes, std::filesystem::path file, const NameTest& knows)
    : file_(std::move(file)) {
    DecodedText decoded = decodeText(std::move(bytes), file_);
    text_ = std::move(decoded.text);
    form_.encoding = decoded.encoding;
    takeSeparatorLine();
    findHeader(knows);
    place_ = begin_;
}

void TableReader::fail(int line, const std::string& sentence) const {
    throw InputError(file_, line, sentence);
}

/// Returns the line at `place` and moves `place` behind it.
std::string_view TableReader::takeLine(Place& place) const {
    const size_t end = std::min(text_.find_first_of("\r\n", place.at), text_.size());
    const std::string_view line = std::string_view(text_).substr(place.at, end - place.at);
    if (line.size() > kLongestRow)
        fail(place.line, "the line is too long; expected at most " + std::to_string(kLongestRow) + " bytes");
    place.at = std::min(end + (text_.compare(end, 2, "\r\n") == 0 ? 2 : 1), text_.size());
    ++place.line;
    return line;
}

void TableReader::takeSeparatorLine() {
    Place place = begin_;
    if (text_.size() > kLongestRow && text_.find_first_of("\r\n") > kLongestRow) return; // reported with the header
    const std::string_view line = withoutQuotes(takeLine(place));
    // The separator may be a blank that trimming removes: a tab.
    if (line == kSeparatorLine) given_ = '\t';
    if (line.size() == kSeparatorLine.size() + 1 && line.starts_with(kSeparatorLine)) given_ = line.back();
    if (given_) begin_ = place;
}

size_t TableReader::knownNames(std::string_view line, char separator, const NameTest& knows) const {
    std::set<std::string_view> names;
    for (const std::string_view cell : splitText(line, separator))
        if (knows(withoutQuotes(cell))) names.insert(cell);
    return names.size();
}

void TableReader::findHeader(const NameTest& knows) {
    std::vector<char> separators(kSeparators.begin(), kSeparators.end());
    if (given_) separators = {*given_};
    std::optional<Place> first;
    char firstSeparator = separators.front();
    int above = 0;
    for (Place place = begin_; place.at < text_.size() && above < kMostLinesAbove;) {
        const Place start = place;
        const std::string_view line = takeLine(place);
        const std::string_view content = trimText(line);
        if (content.empty() || content.starts_with('#')) continue;
        const auto best = std::max_element(separators.begin(), separators.end(), [&](char a, char b) {
            return knownNames(line, a, knows) < knownNames(line, b, knows);
        });
        if (knownNames(line, *best, knows) >= 2) {
            form_.linesAbove = above;
            return takeHeader(start, *best);
        }
        ++above;
        if (first) continue;
        first = start;
        firstSeparator = *std::max_element(separators.begin(), separators.end(), [&](char a, char b) {
            return std::count(line.begin(), line.end(), a) < std::count(line.begin(), line.end(), b);
        });
    }
    form_.separator = firstSeparator;
    if (first) takeHeader(*first, firstSeparator);
}

void TableReader::takeHeader(Place place, char separator) {
    form_.separator = separator;
    headerLine_ = place.line;
    readRow(place);
    while (!cells_.empty() && cells_.back().empty())
        cells_.pop_back();
    columns_.assign(cells_.begin(), cells_.end());
}

TableReader::Item TableReader::next() {
    while (place_.at < text_.size()) {
        Place ahead = place_;
        line_ = place_.line;
        const size_t start = text_.find_first_not_of(' ', place_.at);
        if (start != std::string::npos && text_[start] == '#') {
            comment_ = trimText(takeLine(ahead));
            place_ = ahead;
            while (!comment_.empty() && (comment_.back() == form_.separator || isBlank(comment_.back())))
                comment_.remove_suffix(1);
            return Item::comment;
        }
        if (place_.line < headerLine_) {
            takeLine(place_);
            continue;
        }
        readRow(place_);
        if (line_ == headerLine_) continue;
        const bool empty = std::all_of(cells_.begin(), cells_.end(), [](std::string_view c) { return c.empty(); });
        if (empty) continue;
        while (cells_.size() > columns_.size() && cells_.back().empty())
            cells_.pop_back();
        return Item::row;
    }
    return Item::end;
}

bool TableReader::atRowEnd(const Place& place) const {
    return place.at >= text_.size() || text_[place.at] == '\n' || text_[place.at] == '\r';
}

/// Reads the row at `place` and moves `place` behind it.
void TableReader::readRow(Place& place) {
    cells_.clear();
    unquoted_.clear();
    const Place start = place;
    for (;;) {
        while (!atRowEnd(place) && isBlank(text_[place.at]) && text_[place.at] != form_.separator)
            ++place.at;
        const bool quoted = !atRowEnd(place) && text_[place.at] == '"';
        cells_.push_back(quoted ? quotedCell(place) : plainCell(place));
        if (place.at - start.at > kLongestRow)
            fail(start.line, "the line is too long; expected at most " + std::to_string(kLongestRow) + " bytes");
        if (atRowEnd(place)) break;
        ++place.at; // the separator
    }
    takeLine(place); // the line's end
}

std::string_view TableReader::plainCell(Place& place) const {
    const size_t start = place.at;
    while (!atRowEnd(place) && text_[place.at] != form_.separator)
        ++place.at;
    return trimText(std::string_view(text_).substr(start, place.at - start));
}

std::string_view TableReader::quotedCell(Place& place) {
    const Place start = place;
    std::string cell;
    for (++place.at;; ++place.at) {
        if (place.at >= text_.size() || place.at - start.at > kLongestRow)
            fail(start.line, "a quote in cell " + std::to_string(cells_.size() + 1) +
                                 " does not end; expected a second '\"', and '\"\"' for one within the text");
        const char c = text_[place.at];
        if (c == '"' && text_.compare(place.at, 2, "\"\"") != 0) break;
        if (c == '"') ++place.at;
        if (c == '\n' || (c == '\r' && text_.compare(place.at, 2, "\r\n") != 0)) ++place.line;
        cell += c;
    }
    ++place.at;
    while (!atRowEnd(place) && isBlank(text_[place.at]) && text_[place.at] != form_.separator)
        ++place.at;
    if (!atRowEnd(place) && text_[place.at] != form_.separator)
        fail(start.line, "text follows the closing quote of cell " + std::to_string(cells_.size() + 1) +
                             "; expected the next separator, and '\"\"' for a quote within the text");
    return trimText(unquoted_.emplace_back(std::move(cell)));
}

void TableReader::requireWidth() const {
    if (cells_.size() == columns_.size()) return;
    // Detects numbers such as 1,5 in a table whose columns are separated by commas too.
    const bool torn = form_.separator == ',' && cells_.size() > columns_.size();
    fail(line_, "has " + std::to_string(cells_.size()) + " cells; expected " + std::to_string(columns_.size()) +
                    ", one for each column of the header" +
                    (torn ? "; numbers with a decimal comma need quotes or semicolons between the columns" : ""));
}

std::optional<double> TableReader::number(std::string_view cell) {
    const size_t comma = cell.find(',');
    const bool point = cell.find('.') != std::string_view::npos;
    if (comma == std::string_view::npos && !point) return parseDouble(cell);
    std::string text(cell);
    if (comma != std::string_view::npos) text[comma] = '.';
    if (comma != std::string_view::npos && (point || cell.find(',', comma + 1) != std::string_view::npos)) {
        std::erase_if(text, [](char c) { return c == '.' || c == ','; });
        if (!parseDouble(text)) return std::nullopt; // no number with either mark
        fail(line_, "has the number " + quote(cell) + "; expected one without a thousands separator");
    }
    const std::optional<double> value = parseDouble(text);
    if (!value) return value;
    if (decimalComma_.value_or(!point) == point)
        fail(line_, "has the number " + quote(cell) + " below numbers with a decimal " + (point ? "comma" : "point") +
                        "; expected the same decimal sign in the whole table, and no thousands separator");
    decimalComma_ = !point;
    form_.decimalComma = !point;
    return value;
}

} // namespace meltpool
