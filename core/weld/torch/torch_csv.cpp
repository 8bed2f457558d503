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
/// A filler rod; a table has all of these columns or none, a row all of their cells or none.
constexpr std::array<std::string_view, 8> kRodColumns{"rod_x_mm", "rod_y_mm", "rod_z_mm", "rod_qx",
                                                      "rod_qy",   "rod_qz",   "rod_qw",   "rod_feed"};

struct Range {
    double minimum, maximum;
    std::string_view text;
};

/// What a number of the required columns may be; a torch path of a day or of 100 m is a mistake in the units.
constexpr Range kTimes{0, 86400, "a time from 0 to 86400 s"};
constexpr Range kPlaces{-1e5, 1e5, "a position from -100000 to 100000 mm"};
constexpr Range kQuaternionParts{-1.1, 1.1, "a part of a unit quaternion"};
constexpr Range kTriggers{0, 1, "a number from 0 to 1"};
constexpr Range kFeeds{0, 1000, "a speed from 0 to 1000 mm/s"};

/// Recorders round; farther from 1 than this the four numbers are no orientation.
constexpr double kQuaternionSlack = 0.1;

constexpr size_t kLongestLine = 65536; ///< bytes
/// Of a record whose attempt went back to the row of this number and on to another end.
constexpr std::string_view kRedo = "# event redo ";

float metres(double millimetres) {
    return static_cast<float>(millimetres * 1e-3);
}

const Range& rangeOf(size_t column) {
    if (column == 0) return kTimes;
    if (column <= 3) return kPlaces;
    return column <= 7 ? kQuaternionParts : kTriggers;
}

const Range& rangeOfRod(size_t column) {
    if (column < 3) return kPlaces;
    return column < 7 ? kQuaternionParts : kFeeds;
}

/// Where each required column stands in the file's rows, and which others there are.
struct Header {
    std::array<size_t, kColumns.size()> places{};
    std::array<size_t, kRodColumns.size()> rodPlaces{};
    bool rod = false;
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
        if (row.starts_with(kRedo)) return goBack(trimText(row.substr(kRedo.size())));
        const std::string_view content = trimText(row.substr(0, row.find('#')));
        if (content.empty()) return;
        if (header_.width == 0)
            readHeader(content);
        else
            readRow(content);
    }

    /// The attempt went on from an earlier row as another end: the rows behind that one are those of the first end.
    void goBack(std::string_view step) {
        const auto rows = parseDouble(step);
        if (!rows || *rows != std::floor(*rows) || *rows < 0 || *rows > static_cast<double>(recording_.samples.size()))
            fail(line_, "goes back to row " + quote(step) + "; expected a whole number from 0 to " +
                            std::to_string(recording_.samples.size()) + ", the rows above");
        recording_.samples.resize(static_cast<size_t>(*rows));
        if (keepsFurther_) recording_.furtherCells.resize(recording_.samples.size());
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
            const auto rod = std::find(kRodColumns.begin(), kRodColumns.end(), name);
            if (required != kColumns.end()) {
                header_.places[static_cast<size_t>(required - kColumns.begin())] = i;
            } else if (rod != kRodColumns.end()) {
                header_.rodPlaces[static_cast<size_t>(rod - kRodColumns.begin())] = i;
                header_.rod = true;
            } else {
                header_.further.push_back(i);
                recording_.furtherColumns.emplace_back(name);
            }
        }
        for (const std::string_view name : kColumns)
            if (!seen.contains(name))
                fail(line_,
                     "the column '" + std::string(name) + "' is missing; expected a header row with " + columnList());
        for (const std::string_view name : kRodColumns)
            if (header_.rod && !seen.contains(name))
                fail(line_, "the column '" + std::string(name) +
                                "' is missing; expected all eight columns of a rod, rod_x_mm to rod_feed, or none");
        header_.width = names.size();
    }

    double number(std::string_view cell, std::string_view column, const Range& range) const {
        const auto value = parseDouble(cell);
        if (!value || !std::isfinite(*value) || *value < range.minimum || *value > range.maximum)
            fail(line_, std::string(column) + " is " + quote(cell) + "; expected " + std::string(range.text));
        return *value;
    }

    /// `v`: x, y, z and w in the columns qx to qw, whose names begin with `prefix`.
    glm::quat orientation(std::span<const double, 4> v, const std::string& prefix) const {
        const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + v[3] * v[3]);
        if (std::abs(length - 1) > kQuaternionSlack)
            fail(line_, "the quaternion " + prefix + "qx," + prefix + "qy," + prefix + "qz," + prefix +
                            "qw has the length " + formatNumber(static_cast<float>(length)) + "; expected 1");
        const glm::quat q(static_cast<float>(v[3]), static_cast<float>(v[0]), static_cast<float>(v[1]),
                          static_cast<float>(v[2]));
        // What this program wrote is of unit length to the last bit or two and must come back unchanged.
        return std::abs(length - 1) < 1e-6 ? q : glm::normalize(q);
    }

    std::optional<RodSample> readRod(const std::vector<std::string_view>& cells) const {
        if (!header_.rod) return std::nullopt;
        const auto cell = [&](size_t i) { return trimText(cells[header_.rodPlaces[i]]); };
        size_t empty = 0;
        for (size_t i = 0; i < kRodColumns.size(); ++i)
            if (cell(i).empty()) ++empty;
        if (empty == kRodColumns.size()) return std::nullopt;
        std::array<double, kRodColumns.size()> v{};
        for (size_t i = 0; i < v.size(); ++i)
            v[i] = number(cell(i), kRodColumns[i], rangeOfRod(i));
        return RodSample{{metres(v[0]), metres(v[1]), metres(v[2])},
                         orientation(std::span(v).subspan<3, 4>(), "rod_"),
                         metres(v[7])};
    }

    void readRow(std::string_view content) {
        const auto cells = splitText(content, ',');
        if (cells.size() != header_.width)
            fail(line_, "has " + std::to_string(cells.size()) + " cells; expected " + std::to_string(header_.width) +
                            ", one for each column of the header");
        std::array<double, kColumns.size()> v{};
        for (size_t i = 0; i < v.size(); ++i)
            v[i] = number(trimText(cells[header_.places[i]]), kColumns[i], rangeOf(i));
        if (!recording_.samples.empty() && v[0] < recording_.samples.back().time)
            fail(line_, "time_s is " + formatNumber(v[0]) + ", before the row above; expected at least " +
                            formatNumber(recording_.samples.back().time));
        recording_.samples.push_back({v[0],
                                      {metres(v[1]), metres(v[2]), metres(v[3])},
                                      orientation(std::span(v).subspan<4, 4>(), ""),
                                      static_cast<float>(v[8]),
                                      readRod(cells)});
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

void appendPose(std::string& text, const glm::vec3& place, const glm::quat& orientation) {
    for (const float each : {place.x, place.y, place.z}) {
        appendNumber(text, millimetres(each));
        text += ',';
    }
    for (const float each : {orientation.x, orientation.y, orientation.z, orientation.w}) {
        appendNumber(text, each);
        text += ',';
    }
}

} // namespace

std::span<const std::string_view> torchColumns() {
    return kColumns;
}

std::span<const std::string_view> rodColumns() {
    return kRodColumns;
}

TorchRecording readTorchCsv(const std::filesystem::path& file, FurtherColumns further) {
    return Reader(file, further).read();
}

void appendTorchRow(std::string& text, const TorchSample& s) {
    appendNumber(text, s.time);
    text += ',';
    appendPose(text, s.tip, s.orientation);
    appendNumber(text, s.trigger);
}

void appendRodCells(std::string& text, const std::optional<RodSample>& rod) {
    if (!rod) {
        text.append(kRodColumns.size() - 1, ',');
        return;
    }
    appendPose(text, rod->tip, rod->orientation);
    appendNumber(text, millimetres(rod->feed));
}

void writeTorchCsv(const std::filesystem::path& file, const TorchRecording& recording) {
    std::string text;
    for (const std::string_view name : kColumns)
        text += (text.empty() ? "" : ",") + std::string(name);
    const bool rod = std::any_of(recording.samples.begin(), recording.samples.end(),
                                 [](const TorchSample& sample) { return sample.rod.has_value(); });
    if (rod)
        for (const std::string_view name : kRodColumns)
            text += "," + std::string(name);
    for (const std::string& name : recording.furtherColumns)
        text += "," + name;
    text += "\n";
    for (size_t i = 0; i < recording.samples.size(); ++i) {
        appendTorchRow(text, recording.samples[i]);
        if (rod) {
            text += ',';
            appendRodCells(text, recording.samples[i].rod);
        }
        if (i < recording.furtherCells.size())
            for (const std::string& cell : recording.furtherCells[i])
                text += "," + cell;
        text += "\n";
    }
    writeTextFileAtomically(file, text);
}

} // namespace meltpool
