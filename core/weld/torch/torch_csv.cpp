#include "core/weld/torch/torch_csv.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace meltpool {

namespace {

struct Range {
    double minimum, maximum;
    std::string_view text;
};

/// Ranges of the numbers in the required columns; a torch path of a day or of 100 m is a mistake in the units.
constexpr Range kTimes{-1e19, 1e19, "a time as a number"};
constexpr Range kPlaces{-1e5, 1e5, "a position from -100000 to 100000 mm"};
constexpr Range kQuaternionParts{-1.1, 1.1, "a part of a unit quaternion"};
constexpr Range kTriggers{0, 1, "a number from 0 to 1"};
constexpr Range kFeeds{0, 1000, "a speed from 0 to 1000 mm/s"};
constexpr double kDay = 86400; ///< s

/// Recorders round; farther from 1 than this the four numbers are no orientation.
constexpr double kQuaternionSlack = 0.1;

constexpr size_t kTime = 0, kFirstOfPose = 1, kTrigger = 8; ///< indices in torchColumns()

/// Mark in a record whose attempt went back to the row of this number and on to another end.
constexpr std::string_view kRedo = "# event redo";
/// A table that begins with this is a record of this program.
constexpr std::string_view kRecordMark = "# meltpool record";

float metres(double millimetres) {
    return static_cast<float>(millimetres * 1e-3);
}

const Range& rangeOf(size_t column) {
    if (column == kTime) return kTimes;
    if (column <= 3) return kPlaces;
    return column <= 7 ? kQuaternionParts : kTriggers;
}

const Range& rangeOfRod(size_t column) {
    if (column < 3) return kPlaces;
    return column < 7 ? kQuaternionParts : kFeeds;
}

/// Returns true for the cells by which programs mark a missing number.
bool isMissing(std::string_view cell) {
    const std::string word = lowerCase(cell);
    return word.empty() || word == "nan" || word == "n/a" || word == "#n/a" || word == "null";
}

class Reader {
  public:
    Reader(const std::filesystem::path& file, FurtherColumns further)
        : file_(file),
          keepsFurther_(further == FurtherColumns::kept),
          table_(readTextFile(file), file, isTorchColumn) {}

    TorchRecording read() {
        if (table_.columns().empty()) {
            std::string names;
            for (const std::string_view name : torchColumns())
                names += (names.empty() ? "" : ",") + std::string(name);
            fail(0, "is empty; expected a header row with the columns " + names);
        }
        header_ = findTorchColumns(table_, file_);
        for (const size_t place : header_.further)
            recording_.furtherColumns.push_back(table_.columns()[place]);
        for (TableReader::Item item = table_.next(); item != TableReader::Item::end; item = table_.next())
            if (item == TableReader::Item::comment)
                readComment(table_.comment());
            else
                readRow();
        if (recording_.samples.empty()) fail(0, "has a header but no rows; expected at least one");
        standWhereUnseen();
        settle();
        return std::move(recording_);
    }

  private:
    [[noreturn]] void fail(int line, const std::string& sentence) const { throw InputError(file_, line, sentence); }

    void readComment(std::string_view comment) {
        if (comment.starts_with(kRecordMark)) recording_.form.ours = true;
        if (!comment.starts_with(kRedo)) return;
        const std::string_view step = comment.substr(kRedo.size());
        if (step.empty() || step.front() == ' ') goBack(trimText(step));
    }

    /// Drops the rows behind an earlier one from which the attempt went on to another end.
    void goBack(std::string_view step) {
        const auto rows = parseDouble(step);
        if (!rows || *rows != std::floor(*rows) || *rows < 0 || *rows > static_cast<double>(recording_.samples.size()))
            fail(table_.line(), "goes back to row " + quote(step) + "; expected a whole number from 0 to " +
                                    std::to_string(recording_.samples.size()) + ", the rows above");
        recording_.samples.resize(static_cast<size_t>(*rows));
        if (keepsFurther_) recording_.furtherCells.resize(recording_.samples.size());
    }

    double number(const FoundColumn& column, const Range& range) {
        const std::string_view cell = table_.cells()[column.place];
        const auto value = table_.number(cell);
        const double scaled = value.value_or(0) * (&range == &kTimes ? 1 : column.factor);
        if (!value || !std::isfinite(scaled) || scaled < range.minimum || scaled > range.maximum)
            fail(table_.line(),
                 printable(column.name, 60) + " is " + quote(cell) + "; expected " + std::string(range.text));
        return scaled;
    }

    /// Reads an orientation. `v`: x, y, z and w in the columns qx to qw, whose names begin with `prefix`.
    glm::quat orientation(std::span<const double, 4> v, const std::string& prefix) const {
        const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + v[3] * v[3]);
        if (std::abs(length - 1) > kQuaternionSlack)
            fail(table_.line(), "the quaternion " + prefix + "qx," + prefix + "qy," + prefix + "qz," + prefix +
                                    "qw has the length " + formatNumber(static_cast<float>(length)) + "; expected 1");
        const glm::quat q(static_cast<float>(v[3]), static_cast<float>(v[0]), static_cast<float>(v[1]),
                          static_cast<float>(v[2]));
        // A quaternion that this program wrote is of unit length to the last bit or two and must come back unchanged.
        return std::abs(length - 1) < 1e-6 ? q : glm::normalize(q);
    }

    std::optional<RodSample> readRod() {
        if (!header_.hasRod) return std::nullopt;
        const bool none = std::all_of(header_.rod.begin(), header_.rod.end(), [&](const FoundColumn& column) {
            return isMissing(table_.cells()[column.place]);
        });
        if (none) return std::nullopt;
        std::array<double, kRodColumns> v{};
        for (size_t i = 0; i < v.size(); ++i)
            v[i] = number(header_.rod[i], rangeOfRod(i));
        return RodSample{{metres(v[0]), metres(v[1]), metres(v[2])},
                         orientation(std::span(v).subspan<3, 4>(), "rod_"),
                         metres(v[7])};
    }

    /// Returns true if the row has a pose; a row with a part of one is refused when its numbers are read.
    bool hasPose() const {
        return std::any_of(header_.torch.begin() + kFirstOfPose, header_.torch.begin() + kTrigger,
                           [&](const FoundColumn& column) { return !isMissing(table_.cells()[column.place]); });
    }

    void readRow() {
        table_.requireWidth();
        std::array<double, kTorchColumns> v{};
        v[kTime] = number(header_.torch[kTime], kTimes);
        const std::vector<TorchSample>& above = recording_.samples;
        if (!above.empty() && v[kTime] < above.back().time)
            fail(table_.line(), printable(header_.torch[kTime].name, 60) + " is " +
                                    quote(table_.cells()[header_.torch[kTime].place]) +
                                    ", before the row above; expected at least " + formatNumber(above.back().time));
        TorchSample sample;
        sample.time = v[kTime];
        sample.seen = hasPose();
        for (size_t i = kFirstOfPose; sample.seen && i < v.size(); ++i)
            v[i] = number(header_.torch[i], rangeOf(i));
        if (sample.seen) {
            sample.tip = {metres(v[1]), metres(v[2]), metres(v[3])};
            sample.orientation = orientation(std::span(v).subspan<4, 4>(), "");
            sample.trigger = static_cast<float>(v[kTrigger]);
        }
        sample.rod = readRod();
        recording_.samples.push_back(sample);
        lastLine_ = table_.line();
        if (!keepsFurther_) return;
        auto& further = recording_.furtherCells.emplace_back();
        for (const size_t place : header_.further)
            further.emplace_back(table_.cells()[place]);
    }

    /// Gives an unseen torch its last seen place, and before the first seen row the place of that row.
    void standWhereUnseen() {
        std::vector<TorchSample>& samples = recording_.samples;
        const auto first = std::find_if(samples.begin(), samples.end(), [](const TorchSample& s) { return s.seen; });
        if (first == samples.end()) fail(0, "has no row with a pose; expected numbers under x_mm to qw in some row");
        TorchSample last = *first;
        for (TorchSample& sample : samples) {
            if (sample.seen) {
                last = sample;
                continue;
            }
            sample.tip = last.tip;
            sample.orientation = last.orientation;
            ++recording_.form.unseenRows;
        }
    }

    void settle() {
        TorchForm& form = recording_.form;
        form.table = table_.form();
        form.placesWithoutUnit = header_.placesWithoutUnit;
        if (form.ours) return requireDay();
        form.clock =
            settleTimes(recording_.samples, header_.torch[kTime].factor, header_.timeUnit != TimeUnitName::other);
        requireDay();
    }

    void requireDay() const {
        const double end = recording_.samples.back().time;
        if (end > kDay)
            fail(lastLine_, "is " + formatNumber(static_cast<float>(end / 3600)) +
                                " hours behind the beginning; expected a path of at most a day");
    }

    std::filesystem::path file_;
    bool keepsFurther_;
    TableReader table_;
    int lastLine_ = 0; ///< line of the last row
    TorchHeader header_;
    TorchRecording recording_;
};

/// Returns a cell that a TableReader reads back unchanged.
std::string writtenCell(std::string_view cell) {
    if (cell.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(cell);
    std::string quoted = "\"";
    for (const char c : cell)
        quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

/// Returns millimetres that readTorchCsv() turns back into the identical float of metres.
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

std::string TorchForm::text() const {
    const std::string& separator = phrase("list.separator");
    const std::string begin = formatNumber(std::round(clock.begin * 1e3) / 1e3);
    const char* const times = clock.shifted ? "run.path_form.times_from" : "run.path_form.times";
    const char* const judged = clock.shifted ? "run.path_form.judged_times_from" : "run.path_form.judged_times";
    std::string text =
        table.text() + separator + phrase(clock.judged ? judged : times, {{"unit", clock.unit}, {"begin", begin}});
    if (placesWithoutUnit) text += separator + phrase("run.path_form.positions");
    if (unseenRows > 0)
        text += separator + phraseOfCount("run.path_form.unseen", static_cast<long long>(unseenRows),
                                          {{"rows", std::to_string(unseenRows)}});
    return text;
}

bool isTorchTable(const std::filesystem::path& file) {
    const std::string ending = lowerExtension(file);
    return ending == ".csv" || ending == ".tsv" || ending == ".txt";
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
        text.append(kRodColumns - 1, ',');
        return;
    }
    appendPose(text, rod->tip, rod->orientation);
    appendNumber(text, millimetres(rod->feed));
}

void writeTorchCsv(const std::filesystem::path& file, const TorchRecording& recording) {
    std::string text;
    for (const std::string_view name : torchColumns())
        text += (text.empty() ? "" : ",") + std::string(name);
    const bool rod = std::any_of(recording.samples.begin(), recording.samples.end(),
                                 [](const TorchSample& sample) { return sample.rod.has_value(); });
    if (rod)
        for (const std::string_view name : rodColumns())
            text += "," + std::string(name);
    for (const std::string& name : recording.furtherColumns)
        text += "," + writtenCell(name);
    text += "\n";
    for (size_t i = 0; i < recording.samples.size(); ++i) {
        appendTorchRow(text, recording.samples[i]);
        if (rod) {
            text += ',';
            appendRodCells(text, recording.samples[i].rod);
        }
        if (i < recording.furtherCells.size())
            for (const std::string& cell : recording.furtherCells[i])
                text += "," + writtenCell(cell);
        text += "\n";
    }
    writeTextFileAtomically(file, text);
}

} // namespace meltpool
