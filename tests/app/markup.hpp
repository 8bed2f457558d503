// Whether a page's tags are as HTML wants them.
#pragma once

#include <string>

namespace meltpool::test {

/// The name of the first tag that is not closed as HTML wants it; empty where all are. Names are in lower case here.
std::string firstUnclosed(const std::string& html);

} // namespace meltpool::test
