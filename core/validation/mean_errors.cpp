#include "core/validation/mean_errors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace meltpool {

namespace {

void add(MeanError& error, const ValidationResult& result, const ValidationNumber& number) {
    const bool finite = std::isfinite(number.errorPercent);
    const double percent = finite ? std::copysign(number.errorPercent, number.ours - number.reference) : -100;
    const double difference = finite ? std::abs(number.ours - number.reference) : std::abs(number.reference);
    ++error.count;
    error.percent += std::abs(percent);
    error.bias += percent;
    error.difference += difference;
    error.worstDifference = std::max(error.worstDifference, difference);
    if (error.count > 1 && std::abs(percent) <= error.worstPercent) return;
    error.worstPercent = std::abs(percent);
    error.worstCase = result.name;
}

} // namespace

std::vector<MeanError> meanErrors(std::span<const ValidationResult> results) {
    std::vector<MeanError> errors;
    for (const ValidationResult& result : results)
        for (const ValidationNumber& number : result.numbers) {
            if (number.origin != "measured") continue;
            auto found = std::ranges::find(errors, number.name, &MeanError::name);
            if (found == errors.end()) {
                errors.emplace_back().name = number.name;
                found = errors.end() - 1;
            }
            add(*found, result, number);
        }
    std::erase_if(errors, [](const MeanError& error) { return error.count < 2; });
    for (MeanError& error : errors) {
        const auto count = static_cast<double>(error.count);
        error.percent /= count;
        error.bias /= count;
        error.difference /= count;
    }
    return errors;
}

std::string meanErrorsText(std::span<const MeanError> errors) {
    std::string text;
    for (const MeanError& error : errors) {
        std::array<char, 300> line{};
        std::snprintf(line.data(), line.size(),
                      "mean error of %zu measured %s: %.1f %% (%.2f), on average %+.1f %%; worst %.1f %% in %s\n",
                      error.count, error.name.c_str(), error.percent, error.difference, error.bias, error.worstPercent,
                      error.worstCase.c_str());
        text += line.data();
    }
    return text;
}

} // namespace meltpool
