#include "app/session/parameter_section.hpp"

#include <utility>

namespace meltpool {

ParameterSection::ParameterSection(std::string theName, ParameterList list)
    : name(std::move(theName)), parameters(std::move(list)) {
    for (const Parameter& p : parameters)
        defaults[std::string(p.key)] = parameterText(p);
}

} // namespace meltpool
