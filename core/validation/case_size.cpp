#include "core/validation/case_size.hpp"

#include "core/base/error.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace meltpool {

namespace {

std::string figure(double value) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.3g", value);
    return text.data();
}

} // namespace

void requireCapacity(const ValidationCase& from, const MetalSize& size) {
    if (const std::string fault = capacityFault(size, machineCapacity()); !fault.empty())
        throw InputError(from.file, 0,
                         "spacing_mm: the case " + fault + "; expected a larger spacing or a smaller case");
}

void requireSteps(const ValidationCase& from, double steps) {
    constexpr double kMost = 2e7; // an hour at the least duration of a step
    if (steps > kMost)
        throw InputError(from.file, 0,
                         "spacing_mm: the case would take " + figure(steps * 1e-6) +
                             " million steps; expected a larger spacing or a shorter time");
}

void requireSpacings(const ValidationCase& from, std::string_view key, double length, double least) {
    if (length >= (least - 1e-6) * from.spacing) return;
    throw InputError(from.file, 0,
                     "[case] " + std::string(key) + ": " + figure(length * 1e3) +
                         " mm is too little for particles of " + figure(from.spacing * 1e3) +
                         " mm; expected at least " + figure(least) + " times spacing_mm");
}

} // namespace meltpool
