#include "core/weld/torch/torch_columns.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"

#include <algorithm>
#include <set>

namespace meltpool {

namespace {

constexpr std::array<std::string_view, kTorchColumns> kTorchNames{"time_s", "x_mm", "y_mm", "z_mm",   "qx",
                                                                  "qy",     "qz",   "qw",   "trigger"};
constexpr std::array<std::string_view, kRodColumns> kRodNames{"rod_x_mm", "rod_y_mm", "rod_z_mm", "rod_qx",
                                                              "rod_qy",   "rod_qz",   "rod_qw",   "rod_feed"};

/// A name without case, blanks and unit.
struct PlainName {
    std::string base; ///< "x", "rod_qx"
    std::string unit; ///< "mm", "ms"; empty: none
};

struct Unit {
    std::string_view name;
    double factor;
};

constexpr std::array<Unit, 8> kTimeUnits{
    {{"s", 1}, {"sec", 1}, {"second", 1}, {"seconds", 1}, {"sekunden", 1}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}}};
constexpr std::array<Unit, 3> kLengthUnits{{{"mm", 1}, {"cm", 10}, {"m", 1e3}}};
constexpr std::array<Unit, 4> kShareUnits{{{"-", 1}, {"1", 1}, {"0_1", 1}, {"%", 0.01}}}; ///< 0_1: `0..1`
constexpr std::array<Unit, 2> kPartUnits{{{"-", 1}, {"1", 1}}};
constexpr std::array<Unit, 2> kFeedUnits{{{"mm/s", 1}, {"m/s", 1e3}}};

enum class Kind { time, length, part, share, feed };

Kind kindOf(std::string_view base) {
    if (base == "time") return Kind::time;
    if (base == "trigger") return Kind::share;
    if (base == "rod_feed") return Kind::feed;
    return base.find('q') != std::string_view::npos ? Kind::part : Kind::length;
}

std::span<const Unit> unitsOf(Kind kind) {
    switch (kind) {
    case Kind::time:
        return kTimeUnits;
    case Kind::length:
        return kLengthUnits;
    case Kind::part:
        return kPartUnits;
    case Kind::share:
        return kShareUnits;
    default:
        return kFeedUnits;
    }
}

const Unit* findUnit(Kind kind, std::string_view name) {
    for (const Unit& unit : unitsOf(kind))
        if (unit.name == name) return &unit;
    return nullptr;
}

std::string listOf(std::span<const std::string_view> names) {
    std::string list;
    for (const std::string_view name : names)
        list += (list.empty() ? "" : ",") + std::string(name);
    return list;
}

/// Returns the text in small letters, with one `_` for any blanks, hyphens and points; the micro sign is a u.
std::string lowered(std::string_view text) {
    std::string plain;
    for (size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const std::string_view rest = text.substr(i);
        if (rest.starts_with("\xC2\xB5") || rest.starts_with("\xCE\xBC")) {
            plain += 'u';
            ++i;
        } else if (c == ' ' || c == '_' || c == '-' || c == '.') {
            if (!plain.empty() && plain.back() != '_') plain += '_';
        } else {
            plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        }
    }
    while (!plain.empty() && plain.back() == '_')
        plain.pop_back();
    return plain;
}

/// Cuts the unit in brackets off the end of a name and returns it as written.
std::string takeUnit(std::string_view& name) {
    const size_t open = name.find_first_of("[(");
    if (open == std::string_view::npos || open == 0 || (name.back() != ']' && name.back() != ')')) return {};
    const std::string_view inside = trimText(name.substr(open + 1, name.size() - open - 2));
    name = trimText(name.substr(0, open));
    return inside == "-" ? "-" : lowered(inside);
}

PlainName plainName(std::string_view name) {
    PlainName plain;
    plain.unit = takeUnit(name);
    plain.base = lowered(name);
    // The unit may be the last word, as in our own names.
    if (const size_t cut = plain.base.rfind('_'); cut != std::string::npos && plain.unit.empty()) {
        const std::string_view word = std::string_view(plain.base).substr(cut + 1);
        if (findUnit(Kind::time, word) != nullptr || findUnit(Kind::length, word) != nullptr) {
            plain.unit = word;
            plain.base.resize(cut);
        }
    }
    for (const std::string_view time : {"t", "timestamp", "zeit"})
        if (plain.base == time) plain.base = "time";
    return plain;
}

/// Returns one of our names without its unit.
std::string_view baseOf(std::string_view own) {
    if (own == "time_s") return "time";
    return own.ends_with("_mm") ? own.substr(0, own.size() - 3) : own;
}

bool is(const PlainName& plain, std::string_view own) {
    if (plain.base == baseOf(own)) return true;
    return plain.base == own; // `x_mm [mm]`
}

/// Search through the names of one header.
class Finder {
  public:
    Finder(const TableReader& table, const std::filesystem::path& file) : table_(table), file_(file) {
        for (const std::string& name : table.columns())
            plain_.push_back(plainName(name));
    }

    TorchHeader find() {
        requireNames();
        TorchHeader header;
        std::set<size_t> used;
        const auto take = [&](std::string_view own, FoundColumn& found) {
            const std::optional<size_t> place = placeOf(own);
            if (!place) return false;
            found = {*place, table_.columns()[*place], factorOf(*place, own)};
            used.insert(*place);
            return true;
        };
        for (size_t i = 0; i < kTorchColumns; ++i)
            if (!take(kTorchNames[i], header.torch[i])) missing(kTorchNames[i]);
        std::vector<std::string_view> missed;
        for (size_t i = 0; i < kRodColumns; ++i)
            if (!take(kRodNames[i], header.rod[i])) missed.push_back(kRodNames[i]);
        header.hasRod = missed.size() < kRodColumns;
        if (header.hasRod && !missed.empty())
            fail("the column '" + std::string(missed.front()) +
                 "' is missing; expected all eight columns of a rod, rod_x_mm to rod_feed, or none");
        for (size_t i = 0; i < plain_.size(); ++i)
            if (!used.contains(i)) header.further.push_back(i);
        const std::string& unit = plain_[header.torch[0].place].unit;
        if (!unit.empty()) header.timeUnit = header.torch[0].factor == 1 ? TimeUnitName::seconds : TimeUnitName::other;
        for (size_t i = 1; i <= 3; ++i)
            header.placesWithoutUnit = header.placesWithoutUnit || plain_[header.torch[i].place].unit.empty();
        return header;
    }

  private:
    [[noreturn]] void fail(const std::string& sentence) const {
        throw InputError(file_, table_.headerLine(), sentence);
    }

    void requireNames() const {
        std::set<std::string_view> seen;
        for (size_t i = 0; i < table_.columns().size(); ++i) {
            const std::string& name = table_.columns()[i];
            if (name.empty()) fail("column " + std::to_string(i + 1) + " has no name; expected one");
            if (!seen.insert(name).second) fail("the column " + quote(name) + " occurs twice; expected each name once");
        }
    }

    /// Returns the index of the column with this name or, without one, of the column that means it.
    std::optional<size_t> placeOf(std::string_view own) const {
        const std::vector<std::string>& names = table_.columns();
        const auto exact = std::find(names.begin(), names.end(), own);
        if (exact != names.end()) return static_cast<size_t>(exact - names.begin());
        std::optional<size_t> found;
        for (size_t i = 0; i < names.size(); ++i) {
            if (!is(plain_[i], own)) continue;
            if (found)
                fail("the columns " + quote(names[*found]) + " and " + quote(names[i]) + " are both " +
                     std::string(own) + "; expected one of them");
            found = i;
        }
        return found;
    }

    double factorOf(size_t place, std::string_view own) const {
        const PlainName& plain = plain_[place];
        if (plain.unit.empty()) return 1;
        const Kind kind = kindOf(baseOf(own));
        if (const Unit* unit = findUnit(kind, plain.unit)) return unit->factor;
        std::string known;
        for (const Unit& unit : unitsOf(kind))
            known += (known.empty() ? "" : ", ") + std::string(unit.name);
        fail("the column " + quote(table_.columns()[place]) + " has the unit " + quote(plain.unit) +
             "; expected one of " + known);
    }

    /// Returns true for a header with a robot's angles instead of a quaternion.
    bool hasAngles() const {
        constexpr std::array<std::string_view, 9> kAngles{"a", "b", "c", "rx", "ry", "rz", "roll", "pitch", "yaw"};
        return std::count_if(plain_.begin(), plain_.end(), [&](const PlainName& plain) {
                   return std::find(kAngles.begin(), kAngles.end(), plain.base) != kAngles.end();
               }) >= 2;
    }

    /// `first`: the first of our columns that is missing.
    [[noreturn]] void missing(std::string_view first) const {
        std::string others, found;
        for (const std::string_view own : kTorchNames)
            if (own != first && !placeOf(own)) others += (others.empty() ? "" : ", ") + std::string(own);
        for (const std::string& name : table_.columns())
            found += (found.empty() ? std::string() : std::string(1, table_.form().separator)) + name;
        fail("the column '" + std::string(first) + "' is missing" +
             (others.empty() ? std::string() : " (and " + others + ")") + "; expected a header row with " +
             listOf(kTorchNames) + ", parted by commas, semicolons or tabs, and found " + quote(found) +
             (hasAngles() ? ". Angles are no orientation here: make a quaternion of them" : ""));
    }

    const TableReader& table_;
    const std::filesystem::path& file_;
    std::vector<PlainName> plain_;
};

} // namespace

std::span<const std::string_view> torchColumns() {
    return kTorchNames;
}

std::span<const std::string_view> rodColumns() {
    return kRodNames;
}

bool isTorchColumn(std::string_view name) {
    const PlainName plain = plainName(name);
    const auto meant = [&](std::string_view own) { return is(plain, own); };
    return std::any_of(kTorchNames.begin(), kTorchNames.end(), meant) ||
           std::any_of(kRodNames.begin(), kRodNames.end(), meant);
}

TorchHeader findTorchColumns(const TableReader& table, const std::filesystem::path& file) {
    return Finder(table, file).find();
}

} // namespace meltpool
