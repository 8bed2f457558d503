// A check of HTML pages: every tag is closed.
#pragma once

#include <string>

namespace meltpool::test {

/// Returns the name of the first tag that HTML requires to be closed and is not; empty if all are. Names are in lower
/// case.
std::string firstUnclosed(const std::string& html);

} // namespace meltpool::test
