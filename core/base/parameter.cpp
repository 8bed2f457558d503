#include "core/base/parameter.hpp"

#include "core/base/error.hpp"
#include "core/base/likely_name.hpp"
#include "core/base/short_text.hpp"
#include "core/base/text.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace meltpool {

namespace {

bool inRange(const Parameter& p, double value) {
    return std::isfinite(value) && value >= p.minimum && value <= p.maximum;
}

/// Writes the parsed text through the pointer; returns false if the text does not fit the type or the range.
struct Assign {
    const Parameter& p;
    std::string_view text;

    bool operator()(float* target) const {
        const auto value = parseDouble(text);
        if (!value || !inRange(p, *value)) return false;
        *target = static_cast<float>(*value);
        return true;
    }
    bool operator()(int* target) const {
        if (!p.choices.empty()) {
            const auto found = std::find(p.choices.begin(), p.choices.end(), text);
            if (found == p.choices.end()) return false;
            *target = static_cast<int>(found - p.choices.begin());
            return true;
        }
        const auto value = parseInteger(text);
        if (!value || !inRange(p, static_cast<double>(*value))) return false;
        *target = static_cast<int>(*value);
        return true;
    }
    bool operator()(bool* target) const {
        if (text != "true" && text != "false") return false;
        *target = text == "true";
        return true;
    }
    bool operator()(glm::vec3* target) const {
        const auto parts = splitText(text, ',');
        if (parts.size() != 3) return false;
        glm::vec3 value{};
        for (int i = 0; i < 3; ++i) {
            const auto component = parseDouble(trimText(parts[static_cast<size_t>(i)]));
            if (!component || !inRange(p, *component)) return false;
            value[i] = static_cast<float>(*component);
        }
        *target = value;
        return true;
    }
    bool operator()(std::string* target) const {
        *target = std::string(text);
        return true;
    }
};

struct Print {
    const Parameter& p;

    std::string operator()(const float* value) const { return formatNumber(*value); }
    std::string operator()(const int* value) const {
        if (p.choices.empty()) return std::to_string(*value);
        return std::string(p.choices[static_cast<size_t>(*value)]);
    }
    std::string operator()(const bool* value) const { return *value ? "true" : "false"; }
    std::string operator()(const glm::vec3* v) const {
        return formatNumber(v->x) + "," + formatNumber(v->y) + "," + formatNumber(v->z);
    }
    std::string operator()(const std::string* value) const { return *value; }
};

std::vector<std::string> knownKeys(const ParameterList& list) {
    std::vector<std::string> keys;
    for (const Parameter& p : list)
        keys.emplace_back(p.key);
    return keys;
}

} // namespace

const Parameter* findParameter(const ParameterList& list, std::string_view key) {
    const auto found = std::find_if(list.begin(), list.end(), [key](const Parameter& p) { return p.key == key; });
    return found == list.end() ? nullptr : &*found;
}

void setParameter(const ParameterList& list, std::string_view key, std::string_view text, std::string_view where) {
    const Parameter* p = findParameter(list, key);
    if (p == nullptr)
        throw InputError(std::string(where) + ": unknown key " + quote(key) + expectedNames(key, knownKeys(list)));
    if (!std::visit(Assign{*p, text}, p->value))
        throw InputError(std::string(where) + ": '" + std::string(key) + "' is " + quote(text) + "; expected " +
                         expectation(*p));
}

std::string parameterText(const Parameter& parameter) {
    return std::visit(Print{parameter}, parameter.value);
}

bool sameValue(const Parameter& a, const Parameter& b) {
    return std::visit(
        [](const auto* x, const auto* y) {
            if constexpr (std::is_same_v<decltype(x), decltype(y)>)
                return *x == *y;
            else
                return false;
        },
        a.value, b.value);
}

std::string expectation(const Parameter& p) {
    if (!p.choices.empty()) {
        std::string text = "one of ";
        for (size_t i = 0; i < p.choices.size(); ++i)
            text += (i ? ", " : "") + std::string(p.choices[i]);
        return text;
    }
    if (std::holds_alternative<bool*>(p.value)) return "true or false";
    if (std::holds_alternative<std::string*>(p.value)) return "a text";
    std::string text = "a number";
    if (std::holds_alternative<int*>(p.value)) text = "a whole number";
    if (std::holds_alternative<glm::vec3*>(p.value)) text = "three numbers x,y,z, each";
    text += " from " + formatNumber(p.minimum) + " to " + formatNumber(p.maximum);
    if (!p.unit.empty()) text += " (" + std::string(p.unit) + ")";
    return text;
}

namespace {

/// The table's own sentence for the parameter, the one for all tables that have its key, or the English one.
std::string_view translated(std::string_view table, const Parameter& p, std::string_view part,
                            std::string_view english) {
    return phraseOr(ShortText{"parameter.", table, ".", p.key, part},
                    phraseOr(ShortText{"parameter.", p.key, part}, english));
}

} // namespace

std::string_view translatedLabel(std::string_view table, const Parameter& parameter) {
    return translated(table, parameter, ".label", parameter.label);
}

std::string_view translatedNote(std::string_view table, const Parameter& parameter) {
    return translated(table, parameter, ".tooltip", parameter.note);
}

} // namespace meltpool
