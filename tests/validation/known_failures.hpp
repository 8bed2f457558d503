// The validation cases known to fail, and the check of a case's verdict against them.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace meltpool::test {

/// Case file names without their ending, each with the reason of its failure.
using KnownFailures = std::map<std::string, std::string, std::less<>>;

/// Reads lines `NAME: REASON`; `#` begins a comment, blank lines are skipped. Throws InputError with the line for one
/// without a name or a reason, for a repeated name and for one without a file NAME.toml in `cases`.
KnownFailures readKnownFailures(const std::filesystem::path& file, const std::filesystem::path& cases);

/// Returns a sentence if the verdict is unexpected: an unknown failure, or a known failure that passes. "" if the
/// verdict is expected.
std::string surpriseOf(const std::string& name, bool passed, const KnownFailures& known);

} // namespace meltpool::test
