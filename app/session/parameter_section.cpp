#include "app/session/parameter_section.hpp"

#include <algorithm>
#include <utility>

namespace meltpool {

ParameterSection::ParameterSection(std::string theName, ParameterList list)
    : name(std::move(theName)), words(name), parameters(std::move(list)) {
    for (const Parameter& p : parameters)
        defaults[std::string(p.key)] = parameterText(p);
}

bool ParameterSection::isGiven(const Parameter& parameter) const {
    return fixed != nullptr && *fixed && std::find(chosen.begin(), chosen.end(), parameter.key) == chosen.end();
}

bool ParameterSection::isExpert(const Parameter& parameter) const {
    return !everyday.empty() && std::find(everyday.begin(), everyday.end(), parameter.key) == everyday.end();
}

bool ParameterSection::shows(const Parameter& parameter) const {
    return std::find(idle.begin(), idle.end(), parameter.key) == idle.end();
}

} // namespace meltpool
