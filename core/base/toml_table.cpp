#include "core/base/toml_table.hpp"

#include "core/base/error.hpp"
#include "core/base/likely_name.hpp"
#include "core/base/text.hpp"
#include "core/base/text_encoding.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace meltpool {

namespace {

constexpr size_t kLongestKey = 60; ///< bytes, in messages

int lineAt(const toml::node& node) {
    return static_cast<int>(node.source().begin.line);
}

std::string rangeText(NumberRange range) {
    const bool low = std::isfinite(range.minimum);
    const bool high = std::isfinite(range.maximum);
    if (low && high) return "a number from " + formatNumber(range.minimum) + " to " + formatNumber(range.maximum);
    if (low) return "a number of at least " + formatNumber(range.minimum);
    if (high) return "a number of at most " + formatNumber(range.maximum);
    return "a number";
}

/// Looks for keys of too many parts and values in too many brackets before the parser makes nested tables: parser and
/// tables recurse for every level.
class DepthScan {
  public:
    DepthScan(std::string_view text, const std::filesystem::path& file) : text_(text), file_(file) {}

    /// Checks the text. Up to the first syntax error it finds strings and comments where the parser does.
    void check() {
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (c == '"' || c == '\'')
                skipString(c);
            else if (c == '#')
                at_ = std::min(text_.find('\n', at_), text_.size());
            else
                take(c);
        }
    }

  private:
    void take(char c) {
        ++at_;
        if (c == '.') ++dots_;
        if (c == '[' || c == '{') ++brackets_;
        if (c == ']' || c == '}') brackets_ = std::max(brackets_ - 1, 0);
        if (c == '\n') ++line_;
        if (c == '\n' || c == '=' || c == ',' || c == '[' || c == ']' || c == '{' || c == '}') dots_ = 0;
        if (dots_ >= kMostParts)
            throw InputError(file_, line_,
                             "the key has too many parts; expected at most " + std::to_string(kMostParts) +
                                 " between its dots");
        if (brackets_ > kMostBrackets)
            throw InputError(file_, line_,
                             "the brackets are nested too deeply; expected at most " + std::to_string(kMostBrackets) +
                                 " levels");
    }

    void skipString(char mark) {
        const std::string three(3, mark);
        const bool several = text_.substr(at_, 3) == three;
        at_ += several ? 3 : 1;
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (several && text_.substr(at_, 3) == three) {
                at_ += 3;
                // One or two more marks belong to the string.
                for (int i = 0; i < 2 && at_ < text_.size() && text_[at_] == mark; ++i)
                    ++at_;
                return;
            }
            if (c == '\n' && !several) return; // a syntax error
            if (c == '\n') ++line_;
            at_ += c == '\\' && mark == '"' && at_ + 1 < text_.size() && text_[at_ + 1] != '\n' ? 2 : 1;
            if (c == mark && !several) return;
        }
    }

    static constexpr int kMostParts = 16;
    static constexpr int kMostBrackets = 32;

    std::string_view text_;
    const std::filesystem::path& file_;
    size_t at_ = 0;
    int line_ = 1;
    int dots_ = 0; ///< dots since the last sign that ends a key
    int brackets_ = 0;
};

/// The line of this number, counted from 1; empty if there is none.
std::string_view lineOf(std::string_view text, int number) {
    for (int line = 1; line < number && !text.empty(); ++line)
        text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
    return text.substr(0, text.find('\n'));
}

/// A line of TOML without its comment and without the text between straight quotes.
std::string withoutStrings(std::string_view line) {
    std::string rest;
    char quoted = 0;
    for (const char c : line) {
        if (quoted == 0 && c == '#') break;
        if (quoted == 0 && (c == '"' || c == '\''))
            quoted = c;
        else if (c == quoted)
            quoted = 0;
        else if (quoted == 0)
            rest += c;
    }
    return rest;
}

/// The first typographic quote, as word processors write it; empty: none.
std::string_view typographicQuote(std::string_view text) {
    constexpr std::array<std::string_view, 9> kQuotes{"\u201C", "\u201D", "\u201E", "\u201F", "\u2018",
                                                      "\u2019", "\u201A", "\u00AB", "\u00BB"};
    std::string_view first;
    for (const std::string_view quote : kQuotes)
        if (text.find(quote) < text.find(first.empty() ? "\n" : first)) first = quote;
    return first;
}

/// The value that is a number but for its comma, such as 5,5 in `speed = 5,5`; empty: none.
std::string_view decimalComma(std::string_view line) {
    const size_t equals = line.find('=');
    if (equals == std::string_view::npos) return {};
    const std::string_view value = trimText(line.substr(equals + 1));
    const size_t comma = value.find(',');
    if (comma == std::string_view::npos || !parseInteger(value.substr(0, comma))) return {};
    const std::string_view decimals = value.substr(comma + 1);
    const bool digits = std::all_of(decimals.begin(), decimals.end(), [](char c) { return c >= '0' && c <= '9'; });
    return digits && !decimals.empty() ? value : std::string_view{};
}

/// A sentence for the most frequent mistakes in TOML written by hand; else the parser's message.
std::string syntaxSentence(std::string_view text, const toml::parse_error& error) {
    const std::string line = withoutStrings(lineOf(text, static_cast<int>(error.source().begin.line)));
    if (const std::string_view mark = typographicQuote(line); !mark.empty())
        return "has the typographic quote " + std::string(mark) + "; expected straight ones, as in \"text\"";
    if (const std::string_view number = decimalComma(line); !number.empty())
        return "has the number " + quote(number) + "; expected a decimal point, as in 5.5";
    return std::string(error.description());
}

void requireUtf8(std::string_view text, const std::filesystem::path& file) {
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        throw InputError(file, 1, "is UTF-16; expected the file saved as UTF-8");
    const size_t length = utf8Length(text);
    if (length == text.size()) return;
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(length), '\n');
    throw InputError(
        file, static_cast<int>(line),
        "has a character that is not UTF-8, such as one of Latin-1 or Windows-1252; expected the file saved "
        "as UTF-8");
}

} // namespace

toml::table parseTomlFile(const std::filesystem::path& file) {
    return parseToml(readTextFile(file, kLargestTomlFile), file);
}

std::vector<std::string> tomlFileNames(const std::filesystem::path& folder, const std::string& expected) {
    std::vector<std::string> names;
    std::error_code fault;
    for (const auto& entry : std::filesystem::directory_iterator(folder, fault))
        if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
    if (fault) throw InputError(folder, 0, "cannot be read; expected " + expected);
    std::sort(names.begin(), names.end());
    return names;
}

toml::table parseToml(std::string_view text, const std::filesystem::path& file) {
    requireUtf8(text, file);
    DepthScan(text, file).check();
    try {
        return toml::parse(text, file.string());
    } catch (const toml::parse_error& error) {
        throw InputError(file, static_cast<int>(error.source().begin.line), syntaxSentence(text, error));
    }
}

TomlTable::TomlTable(const toml::table& table, std::filesystem::path file, std::string where)
    : table_(table), file_(std::move(file)), where_(std::move(where)) {}

int TomlTable::line() const {
    return lineAt(table_);
}

int TomlTable::lineOf(std::string_view key) const {
    const toml::node* node = table_.get(key);
    return node ? lineAt(*node) : line();
}

void TomlTable::failAt(int line, std::string_view key, std::string_view sentence) const {
    std::string text = where_;
    if (!text.empty()) text += " ";
    throw InputError(file_, line, text + printable(key, kLongestKey) + ": " + std::string(sentence));
}

void TomlTable::fail(std::string_view key, std::string_view sentence) const {
    failAt(lineOf(key), key, sentence);
}

const toml::node& TomlTable::need(std::string_view key, std::string_view expected) {
    asked_.emplace(key);
    const toml::node* node = table_.get(key);
    if (!node) failAt(line(), key, "is missing; expected " + std::string(expected));
    return *node;
}

double TomlTable::checked(std::string_view key, const toml::node& node, NumberRange range) const {
    const auto value = node.is_number() ? node.value<double>() : std::nullopt;
    const bool inside = value && std::isfinite(*value) && *value >= range.minimum && *value <= range.maximum;
    if (!inside) failAt(lineAt(node), key, "expected " + rangeText(range));
    return *value;
}

double TomlTable::number(std::string_view key, NumberRange range) {
    return checked(key, need(key, rangeText(range)), range);
}

double TomlTable::number(std::string_view key, NumberRange range, double fallback) {
    asked_.emplace(key);
    return has(key) ? number(key, range) : fallback;
}

bool TomlTable::flag(std::string_view key, bool fallback) {
    asked_.emplace(key);
    const toml::node* node = table_.get(key);
    if (!node) return fallback;
    const auto value = node->value_exact<bool>();
    if (!value) failAt(lineAt(*node), key, "expected true or false");
    return *value;
}

std::string TomlTable::text(std::string_view key) {
    const toml::node& node = need(key, "a text in quotes");
    const auto value = node.value_exact<std::string>();
    if (!value || value->empty()) failAt(lineAt(node), key, "expected a text in quotes");
    return *value;
}

std::string TomlTable::text(std::string_view key, std::string_view fallback) {
    asked_.emplace(key);
    return has(key) ? text(key) : std::string(fallback);
}

std::vector<double> TomlTable::numbers(std::string_view key, NumberRange range, std::size_t least) {
    const std::string expected = "a list of " + std::to_string(least) + " or more numbers";
    const toml::node& node = need(key, expected);
    const toml::array* array = node.as_array();
    if (!array || array->size() < least) failAt(lineAt(node), key, "expected " + expected);
    std::vector<double> values;
    for (const toml::node& element : *array)
        values.push_back(checked(key, element, range));
    return values;
}

std::vector<std::string> TomlTable::texts(std::string_view key) {
    constexpr std::string_view kExpected = "a list of texts, such as [\"speed\", \"aim\"]";
    const toml::node& node = need(key, kExpected);
    const toml::array* array = node.as_array();
    if (!array) failAt(lineAt(node), key, "expected " + std::string(kExpected));
    std::vector<std::string> values;
    for (const toml::node& element : *array) {
        const auto* text = element.as_string();
        if (!text) failAt(lineAt(element), key, "expected " + std::string(kExpected));
        values.push_back(text->get());
    }
    return values;
}

std::vector<std::vector<double>> TomlTable::rows(std::string_view key, std::size_t width, std::size_t least) {
    const std::string expected = "a list of " + std::to_string(least) + " or more rows of " + std::to_string(width) +
                                 " numbers, such as [[..], [..]]";
    const toml::node& node = need(key, expected);
    const toml::array* array = node.as_array();
    if (!array || array->size() < least) failAt(lineAt(node), key, "expected " + expected);
    std::vector<std::vector<double>> result;
    for (const toml::node& element : *array) {
        const toml::array* row = element.as_array();
        if (!row || row->size() != width) failAt(lineAt(element), key, "expected " + expected);
        auto& values = result.emplace_back();
        for (const toml::node& number : *row)
            values.push_back(checked(key, number, {}));
    }
    return result;
}

TomlTable TomlTable::table(std::string_view key) {
    // TOML writes a table inside a table of a list, "[[item]]", as "[item.key]".
    const size_t brackets = where_.starts_with("[[") ? 2 : 1;
    const std::string name =
        where_.empty() ? "[" + std::string(key) + "]"
                       : "[" + where_.substr(brackets, where_.size() - 2 * brackets) + "." + std::string(key) + "]";
    const toml::node& node = need(key, "a table");
    const toml::table* inner = node.as_table();
    if (!inner) failAt(lineAt(node), key, "expected a table");
    return {*inner, file_, name};
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) {
    asked_.emplace(key);
    if (!has(key)) return {};
    const toml::array* array = table_.get(key)->as_array();
    const std::string name = "[[" + (where_.empty() ? "" : where_ + ".") + std::string(key) + "]]";
    if (!array) fail(key, "expected tables that begin with " + name);
    std::vector<TomlTable> result;
    for (const toml::node& element : *array) {
        const toml::table* inner = element.as_table();
        if (!inner) failAt(lineAt(element), key, "expected tables that begin with " + name);
        result.emplace_back(*inner, file_, name);
    }
    return result;
}

std::string TomlTable::valueText(std::string_view key) {
    const std::string expected = "a text, a number, true or false, or a list of numbers";
    const toml::node& node = need(key, expected);
    if (const auto flag = node.value_exact<bool>()) return *flag ? "true" : "false";
    if (const auto whole = node.value_exact<std::int64_t>()) return std::to_string(*whole);
    if (const auto number = node.value_exact<double>()) return formatNumber(*number);
    if (const auto words = node.value_exact<std::string>()) return *words;
    if (!node.is_array()) failAt(lineAt(node), key, "expected " + expected);
    std::string list;
    for (const double value : numbers(key))
        list += (list.empty() ? "" : ",") + formatNumber(value);
    return list;
}

std::vector<std::string> TomlTable::keys() const {
    std::vector<std::string> names;
    for (const auto& [key, node] : table_)
        names.emplace_back(key.str());
    return names;
}

void TomlTable::finish() const {
    for (const auto& [key, node] : table_) {
        if (asked_.contains(key.str())) continue;
        const std::vector<std::string> known(asked_.begin(), asked_.end());
        failAt(static_cast<int>(key.source().begin.line), key.str(),
               "unknown key" + expectedNames(key.str(), known, "known here: "));
    }
}

} // namespace meltpool
