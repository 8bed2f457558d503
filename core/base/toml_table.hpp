// A strict view of a TOML table: every fault, also an unknown key, is an InputError with file and line.
#pragma once

#include <toml++/toml.h>

#include <array>
#include <filesystem>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool {

/// Allowed values of a number, both ends included.
struct NumberRange {
    double minimum = -std::numeric_limits<double>::infinity();
    double maximum = std::numeric_limits<double>::infinity();
};

/// A limit above any TOML file of this program.
inline constexpr std::size_t kLargestTomlFile = std::size_t(1) << 20;

/// Reads a TOML file. Throws InputError with the line of the first syntax error or of the first byte that is not UTF-8,
/// with sentences of its own for typographic quotes and a decimal comma; also if the file cannot be read, or is larger
/// than kLargestTomlFile or nested so deeply that nested tables would exhaust the stack.
toml::table parseTomlFile(const std::filesystem::path& file);

/// Reads a text that came from `file`; throws as parseTomlFile().
toml::table parseToml(std::string_view text, const std::filesystem::path& file);

/// The names, without their ending, of a folder's TOML files in alphabetical order. Throws InputError that names
/// `expected` ("a folder with ...") for a folder that cannot be read.
std::vector<std::string> tomlFileNames(const std::filesystem::path& folder, const std::string& expected);

/// One table of a file. Read every key that is allowed, then call finish().
class TomlTable {
  public:
    /// `table` must outlive this view. `where` names the table in messages, such as "[case]"; empty for the whole file.
    TomlTable(const toml::table& table, std::filesystem::path file, std::string where = {});

    bool has(std::string_view key) const { return table_.contains(key); }
    bool isFlag(std::string_view key) const { return has(key) && table_.get(key)->is_boolean(); }
    bool isList(std::string_view key) const { return has(key) && table_.get(key)->is_array(); }

    /// Allows a key without reading it.
    void allow(std::string_view key) { asked_.emplace(key); }

    /// A number inside the range. Without a fallback the key is required.
    double number(std::string_view key, NumberRange range = {});
    double number(std::string_view key, NumberRange range, double fallback);
    bool flag(std::string_view key, bool fallback);
    std::string text(std::string_view key);
    std::string text(std::string_view key, std::string_view fallback);

    /// A list of at least `least` numbers, each inside the range.
    std::vector<double> numbers(std::string_view key, NumberRange range = {}, std::size_t least = 1);

    /// A list of texts, which may be empty.
    std::vector<std::string> texts(std::string_view key);

    /// A list of at least `least` rows of exactly `width` numbers.
    std::vector<std::vector<double>> rows(std::string_view key, std::size_t width, std::size_t least = 1);

    /// The table `key`; it is required. Call finish() on the result too.
    TomlTable table(std::string_view key);

    /// The tables written as [[key]]; none when the key is missing. Call finish() on each.
    std::vector<TomlTable> tables(std::string_view key);

    /// A text, number, flag or list of numbers as text for setParameter().
    std::string valueText(std::string_view key);

    /// All keys of this table, in the order of their names.
    std::vector<std::string> keys() const;

    /// The line of a key's value, or of the table itself if the key is missing.
    int lineOf(std::string_view key) const;
    int line() const;
    const std::filesystem::path& file() const { return file_; }

    /// Throws InputError at the key's line with "[where] key: sentence".
    [[noreturn]] void fail(std::string_view key, std::string_view sentence) const;

    /// Throws InputError for the first key that was neither read nor allowed; the message lists the allowed keys.
    void finish() const;

  private:
    const toml::node& need(std::string_view key, std::string_view expected);
    double checked(std::string_view key, const toml::node& node, NumberRange range) const;
    [[noreturn]] void failAt(int line, std::string_view key, std::string_view sentence) const;

    const toml::table& table_;
    std::filesystem::path file_;
    std::string where_;
    std::set<std::string, std::less<>> asked_;
};

} // namespace meltpool
