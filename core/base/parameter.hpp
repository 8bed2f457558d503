// Descriptions of adjustable values; menus, TOML files, `--set` and the printed help are made from them.
#pragma once

#include <glm/vec3.hpp>

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace meltpool {

/// A value of a parameter struct and all that a user needs to change it. Its default is the value in a
/// default-constructed struct.
struct Parameter {
    std::string_view key;   ///< name in files and on the command line, snake_case
    std::string_view label; ///< name in menus
    std::string_view unit;  ///< "" for none
    std::variant<float*, int*, bool*, glm::vec3*, std::string*> value;
    double minimum = 0;    ///< smallest allowed value (each component of a vector)
    double maximum = 1;    ///< largest allowed value
    std::string_view note; ///< cost or damage of raising it
    /// The names of an `int` that is a choice, in order; files hold the name. Empty for plain numbers.
    std::span<const std::string_view> choices = {};
    bool onlyAtStart = false; ///< true: takes effect at the next start, not while running
    /// Names of `choices` for people, which no translation changes: "Deutsch". Empty, or an empty one: a phrase.
    std::span<const std::string_view> choiceNames = {};
};

using ParameterList = std::vector<Parameter>;

/// The parameter with this key, or nullptr.
const Parameter* findParameter(const ParameterList& list, std::string_view key);

/// Sets a value from text ("0.3", "true", "ice", "0,-9.81,0"). Throws InputError, beginning with `where`, if the key is
/// unknown, the text is not of the parameter's type, or the value is out of range; then the value is unchanged.
void setParameter(const ParameterList& list, std::string_view key, std::string_view text, std::string_view where);

/// The value as text from which setParameter() restores the same bits.
std::string parameterText(const Parameter& parameter);

/// True if both hold the same value of the same type. Allocates only for texts.
bool sameValue(const Parameter& a, const Parameter& b);

/// The values that the parameter accepts, for messages and help: "a number from 0 to 1 (m)", "one of metal, ice".
std::string expectation(const Parameter& parameter);

/// Label and explanation of a parameter in the chosen language. `table` holds its words: parameter.TABLE.KEY.label, or
/// parameter.KEY.label for all tables. Allocates nothing.
std::string_view translatedLabel(std::string_view table, const Parameter& parameter);
std::string_view translatedNote(std::string_view table, const Parameter& parameter);

} // namespace meltpool
