// Numbers and words of the page of an attempt, and what is read of result.json for them.
#pragma once

#include <nlohmann/json.hpp>

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace meltpool {

/// Bytes as base64 (RFC 4648), with padding.
std::string base64(std::string_view bytes);

/// The number under a key; none where there is no number, or `object` is no object.
std::optional<double> numberIn(const nlohmann::json& object, const char* key);
/// The text under a key, as written in the file; empty where there is none.
std::string rawIn(const nlohmann::json& object, const char* key);
/// The same for HTML.
std::string textIn(const nlohmann::json& object, const char* key);
/// The object or array under a key; null where there is none.
const nlohmann::json& partIn(const nlohmann::json& object, const char* key);

/// A number for a reader, with the language's decimal mark. `sign`: a plus before numbers above 0.
std::string numberText(double value, int decimals, bool sign = false);

/// Lengths, areas, speeds and heat inputs in both systems, of which the page shows one (1 in = 25.4 mm); others with
/// their unit. "deg" and the sign mean degrees. A dash for what is not known. HTML.
std::string measure(std::optional<double> value, std::string_view unit);

/// "toe_width_mm" as "toe width" and "mm"; the words are HTML.
struct NamedUnit {
    std::string words, unit;
};
NamedUnit namedUnit(const std::string& key);

/// A table's row of a name and a value, both HTML.
std::string tableRow(const std::string& name, const std::string& value);
/// The heads of a table's columns, sentences of these keys.
std::string headCells(std::initializer_list<std::string_view> keys);
/// A cell that is aligned as numbers are.
std::string numberCell(const std::string& value);

/// What stands for something that is not there.
inline constexpr const char* kDash = "\xE2\x80\x93";

} // namespace meltpool
