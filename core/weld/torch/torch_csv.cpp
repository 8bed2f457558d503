#include "core/weld/torch/torch_csv.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace meltpool {

namespace {

constexpr std::array<std::string_view, 9> kColumns{"time_s", "x_mm", "y_mm", "z_mm", "qx", "qy", "qz", "qw", "trigger"};

struct Range {
    double minimum, maximum;
    std::string_view text;
};

/// What a number of the required columns may be; a torch path of a day or of 100 m is a mistake in the units.
constexpr Range kTimes{0, 86400, "a time from 0 to 86400 s"};
constexpr Range kPlaces{-1e5, 1e5, "a position from -100000 to 100000 mm"};
constexpr Range kQuaternionParts{-1.1, 1.1, "a part of a unit quaternion"};
constexpr Range kTriggers{0, 1, "a number from 0 to 1"};

/// Recorders round; farther from 1 than this the four numbers are no orientation.
constexpr double kQuaternionSlack = 0.1;

constexpr size_t kLongestLine = 65536; ///< bytes

const Range& rangeOf(size_t column) {
    if (column == 0) return kTimes;
    if (column <= 3) return kPlaces;
    return column <= 7 ? kQuaternionParts : kTriggers;
}

/// Where each required column stands in the file's rows, and which others there are.
struct Header {
    std::array<size_t, kColumns.size()> places{};
    std::vector<size_t> further;
    size_t width = 0;
};

class Reader {
  public:
    Reader(const std::filesystem::path& file, FurtherColumns further)
        : file_(file), keepsFurther_(further == FurtherColumns::kept) {}

    TorchRecording read() {
        const std::string text = readTextFile(file_);
        std::string_view rest = text;
        if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3); // the mark that some spreadsheets put first
        while (!rest.empty()) {
            const std::string_view row = rest.substr(0, rest.find('\n'));
            rest.remove_prefix(std::min(row.size() + 1, rest.size()));
            readLine(row);
        }
        if (header_.width == 0) fail(0, "is empty; expected a header row with the columns " + columnList());
        if (recording_.samples.empty()) fail(0, "has a header but no rows; expected at least one");
        return std::move(recording_);
    }

  private:
    [[noreturn]] void fail(int line, const std::string& sentence) const { throw InputError(file_, line, sentence); }

    static std::string columnList() {
        std::string list;
        for (const std::string_view name : kColumns)
            list += (list.empty() ? "" : ",") + std::string(name);
        return list;
    }

    void readLine(std::string_view row) {
        ++line_;
        if (row.size() > kLongestLine)
            fail(line_, "the line is too long; expected at most " + std::to_string(kLongestLine) + " bytes");
        const std::string_view content = trimText(row.substr(0, row.find('#')));
        if (content.empty()) return;
        if (header_.width == 0)
            readHeader(content);
        else
            readRow(content);
    }

    void readHeader(std::string_view content) {
        const auto names = splitText(content, ',');
        std::set<std::string_view> seen;
        for (size_t i = 0; i < names.size(); ++i) {
            const std::string_view name = trimText(names[i]);
            if (name.empty()) fail(line_, "column " + std::to_string(i + 1) + " has no name; expected one");
            if (!seen.insert(name).second)
                fail(line_, "the column " + quote(name) + " stands twice; expected each name once");
            const auto required = std::find(kColumns.begin(), kColumns.end(), name);
            if (required != kColumns.end()) {
                header_.places[static_cast<size_t>(required - kColumns.begin())] = i;
            } else {
                header_.further.push_back(i);
                recording_.furtherColumns.emplace_back(name);
            }
        }
        for (const std::string_view name : kColumns)
            if (!seen.contains(name))
                fail(line_,
                     "the column '" + std::string(name) + "' is missing; expected a header row with " + columnList());
        header_.width = names.size();
    }

    double number(std::string_view cell, size_t column) const {
        const Range& range = rangeOf(column);
        const auto value = parseDouble(cell);
        if (!value || !std::isfinite(*value) || *value < range.minimum || *value > range.maximum)
            fail(line_, std::string(kColumns[column]) + " is " + quote(cell) + "; expected " + std::string(range.text));
        return *value;
    }

    glm::quat orientation(const std::array<double, kColumns.size()>& v) const {
        const double length = std::sqrt(v[4] * v[4] + v[5] * v[5] + v[6] * v[6] + v[7] * v[7]);
        if (std::abs(length - 1) > kQuaternionSlack)
            fail(line_, "the quaternion qx,qy,qz,qw has the length " + formatNumber(static_cast<float>(length)) +
                            "; expected 1");
        const glm::quat q(static_cast<float>(v[7]), static_cast<float>(v[4]), static_cast<float>(v[5]),
                          static_cast<float>(v[6]));
        // What this program wrote is of unit length to the last bit or two and must come back unchanged.
        return std::abs(length - 1) < 1e-6 ? q : glm::normalize(q);
    }

    void readRow(std::string_view content) {
        const auto cells = splitText(content, ',');
        if (cells.size() != header_.width)
            fail(line_, "has " + std::to_string(cells.size()) + " cells; expected " + std::to_string(header_.width) +
                            ", one for each column of the header");
        std::array<double, kColumns.size()> v{};
        for (size_t i = 0; i < v.size(); ++i)
            v[i] = number(trimText(cells[header_.places[i]]), i);
        if (!recording_.samples.empty() && v[0] < recording_.samples.back().time)
            fail(line_, "time_s is " + formatNumber(v[0]) + ", before the row above; expected at least " +
                            formatNumber(recording_.samples.back().time));
        const auto metres = [](double mm) { return static_cast<float>(mm * 1e-3); };
        recording_.samples.push_back(
            {v[0], {metres(v[1]), metres(v[2]), metres(v[3])}, orientation(v), static_cast<float>(v[8])});
        if (!keepsFurther_) return;
        auto& further = recording_.furtherCells.emplace_back();
        for (const size_t place : header_.further)
            further.emplace_back(trimText(cells[place]));
    }

    std::filesystem::path file_;
    bool keepsFurther_;
    int line_ = 0;
    Header header_;
    TorchRecording recording_;
};

/// Millimetres that readTorchCsv() turns back into the same float of metres.
double millimetres(float metres) {
    return static_cast<double>(metres) * 1e3;
}

} // namespace

std::span<const std::string_view> torchColumns() {
    return kColumns;
}

TorchRecording readTorchCsv(const std::filesystem::path& file, FurtherColumns further) {
    return Reader(file, further).read();
}

void appendTorchRow(std::string& text, const TorchSample& s) {
    appendNumber(text, s.time);
    for (const float place : {s.tip.x, s.tip.y, s.tip.z}) {
        text += ',';
        appendNumber(text, millimetres(place));
    }
    for (const float number : {s.orientation.x, s.orientation.y, s.orientation.z, s.orientation.w, s.trigger}) {
        text += ',';
        appendNumber(text, number);
    }
}

void writeTorchCsv(const std::filesystem::path& file, const TorchRecording& recording) {
    std::string text;
    for (const std::string_view name : kColumns)
        text += (text.empty() ? "" : ",") + std::string(name);
    for (const std::string& name : recording.furtherColumns)
        text += "," + name;
    text += "\n";
    for (size_t i = 0; i < recording.samples.size(); ++i) {
        appendTorchRow(text, recording.samples[i]);
        if (i < recording.furtherCells.size())
            for (const std::string& cell : recording.furtherCells[i])
                text += "," + cell;
        text += "\n";
    }
    writeTextFileAtomically(file, text);
}

} // namespace meltpool
