// Errors of many cases together: mean and worst error of a number that was measured in several cases.
#pragma once

#include "core/validation/validation.hpp"

#include <span>
#include <string>
#include <vector>

namespace meltpool {

/// One number that at least two cases measured.
struct MeanError {
    std::string name;           ///< name such as toe_width_mm
    size_t count = 0;           ///< number of measurements
    double percent = 0;         ///< mean of the errors' sizes
    double bias = 0;            ///< %, mean of the errors with their signs
    double difference = 0;      ///< mean size of ours less the reference, in the number's unit
    double worstPercent = 0;    ///< size of the worst error
    std::string worstCase;      ///< name of the worst case
    double worstDifference = 0; ///< largest size, in the number's unit
};

/// Returns the errors of all numbers with the origin "measured", in the order in which they first appear. Those that
/// are not finite count as an error of 100 %, as the case did not yield them.
std::vector<MeanError> meanErrors(std::span<const ValidationResult> results);

/// Returns lines for people, one a number; empty if no number was measured twice.
std::string meanErrorsText(std::span<const MeanError> errors);

} // namespace meltpool
