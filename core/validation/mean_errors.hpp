// Errors of many cases together: how far a number that was measured in several cases is off on average, and at worst.
#pragma once

#include "core/validation/validation.hpp"

#include <span>
#include <string>
#include <vector>

namespace meltpool {

/// One number that at least two cases measured.
struct MeanError {
    std::string name;           ///< such as toe_width_mm
    size_t count = 0;           ///< how often it was measured
    double percent = 0;         ///< mean of the errors' sizes
    double bias = 0;            ///< %, mean of the errors with their signs
    double difference = 0;      ///< mean size of ours less the reference, in the number's unit
    double worstPercent = 0;    ///< size
    std::string worstCase;      ///< its name
    double worstDifference = 0; ///< largest size, in the number's unit
};

/// Of all numbers with the origin "measured", in the order in which they first appear. Those that are not finite count
/// as an error of 100 %, as the case did not yield them.
std::vector<MeanError> meanErrors(std::span<const ValidationResult> results);

/// Lines for people, one a number; empty where no number was measured twice.
std::string meanErrorsText(std::span<const MeanError> errors);

} // namespace meltpool
