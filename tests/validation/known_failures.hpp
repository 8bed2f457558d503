// The validation cases that fail at present, and what is expected of a case's verdict.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace meltpool::test {

/// Case file names without their ending, each with the reason of its failure.
using KnownFailures = std::map<std::string, std::string, std::less<>>;

/// Reads lines `NAME: REASON`; `#` begins a comment, blank lines are skipped. Throws InputError with the line for one
/// without a name or a reason, for a name that stands twice and for one without a file NAME.toml in `cases`.
KnownFailures readKnownFailures(const std::filesystem::path& file, const std::filesystem::path& cases);

/// A sentence where the verdict is not the expected one: a case fails that is not known to, or a known one passes. ""
/// where all is as expected.
std::string surpriseOf(const std::string& name, bool passed, const KnownFailures& known);

} // namespace meltpool::test
