// Names and sentences for OpenXR's result codes.
#include "xr/check.hpp"

#include <openxr/openxr_reflection.h>

#include <string_view>

namespace meltpool::xr {

namespace {

/// The file's path from the source root on, independent of the machine that compiled it.
std::string_view placeInSource(std::string_view file) {
    const size_t at = file.rfind("xr/");
    return at == std::string_view::npos ? file : file.substr(at);
}

/// Only the function's name out of "xrCreateSession(instance_, ...)".
std::string_view functionOf(std::string_view expression) {
    return expression.substr(0, expression.find('('));
}

} // namespace

std::string resultName(XrResult result) {
    switch (result) {
#define MELTPOOL_NAME(name, value)                                                                                     \
    case name:                                                                                                         \
        return #name;
        XR_LIST_ENUM_XrResult(MELTPOOL_NAME)
#undef MELTPOOL_NAME
                default : return "XrResult " +
                          std::to_string(static_cast<int>(result));
    }
}

XrResult check(XrResult result, const char* expression, const char* file, int line) {
    if (XR_SUCCEEDED(result)) return result;
    throw XrFault(std::string(functionOf(expression)) + " returned " + resultName(result) + " (" + expression + ", " +
                      std::string(placeInSource(file)) + ":" + std::to_string(line) + ")",
                  result);
}

} // namespace meltpool::xr
