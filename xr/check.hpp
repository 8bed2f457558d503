// Checks every OpenXR call by MELTPOOL_XR: a failure names the call, its result and its place in the source.
#pragma once

#include "core/base/error.hpp"
#include "core/base/work_meter.hpp"

#include <openxr/openxr.h>

#include <string>

namespace meltpool::xr {

/// An OpenXR call that failed.
class XrFault : public RuntimeFault {
  public:
    XrFault(const std::string& sentence, XrResult result) : RuntimeFault(sentence), result_(result) {}
    XrResult result() const { return result_; }

  private:
    XrResult result_;
};

/// "XR_ERROR_INSTANCE_LOST", or the number of an unknown result.
std::string resultName(XrResult result);

/// Returns success codes; throws XrFault for the rest.
XrResult check(XrResult result, const char* expression, const char* file, int line);

} // namespace meltpool::xr

// A WorkMeter counts the time of the call as the runtime's.
#define MELTPOOL_XR(expression)                                                                                        \
    ::meltpool::xr::check((static_cast<void>(::meltpool::InWork(::meltpool::WorkPlace::runtime)), (expression)),       \
                          #expression, __FILE__, __LINE__)
