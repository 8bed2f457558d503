// The printed and written comparison of two attempts.
#pragma once

#include "app/report/comparison_page.hpp"

#include <filesystem>

namespace meltpool {

/// Prints the difference in words and the score lost by each quantity, and writes comparison.html into `folder` unless
/// `page` is false. Throws whatever comparisonPage() and writeFile() throw.
void tellComparison(const ComparedRun& first, const ComparedRun& second, const std::filesystem::path& folder,
                    bool page);

} // namespace meltpool
