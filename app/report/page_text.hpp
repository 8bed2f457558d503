// Numbers and words of the page of an attempt, and the reading of result.json for them.
#pragma once

#include <nlohmann/json.hpp>

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace meltpool {

/// Bytes as base64 (RFC 4648), with padding.
std::string base64(std::string_view bytes);

/// Number under a key; nothing if there is no number, or `object` is no object.
std::optional<double> numberIn(const nlohmann::json& object, const char* key);
/// Text under a key, as written in the file; empty if there is none.
std::string rawIn(const nlohmann::json& object, const char* key);
/// Text under a key, escaped for HTML.
std::string textIn(const nlohmann::json& object, const char* key);
/// Object or array under a key; null if there is none.
const nlohmann::json& partIn(const nlohmann::json& object, const char* key);

/// Number for a reader, with the language's decimal mark. `sign`: a plus before positive numbers.
std::string numberText(double value, int decimals, bool sign = false);

/// Lengths, areas, speeds and heat inputs in both systems, of which the page shows one (1 in = 25.4 mm); others with
/// their unit. "deg" and the sign mean degrees. A dash for unknown values. HTML.
std::string measure(std::optional<double> value, std::string_view unit);

/// Name of a metric unit and of its inch unit, of which the page shows one. HTML.
std::string unitName(std::string_view unit);

/// The page's switch between millimetres and inches, set to the chosen units. HTML.
std::string unitSwitch();

/// Words and unit of a key: "toe_width_mm" as "toe width" and "mm"; the words are HTML.
struct NamedUnit {
    std::string words, unit;
};
NamedUnit namedUnit(const std::string& key);

/// Row of a table with a name and a value, both HTML.
std::string tableRow(const std::string& name, const std::string& value);
/// Heads of a table's columns, sentences of these keys.
std::string headCells(std::initializer_list<std::string_view> keys);
/// Cell that is aligned like a number.
std::string numberCell(const std::string& value);

/// Text for a missing value.
inline constexpr const char* kDash = "\xE2\x80\x93";

} // namespace meltpool
