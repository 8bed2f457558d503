// The head of a file of measurements, and its place by machine and commit.
#pragma once

#include "core/gl/context.hpp"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <string_view>

namespace meltpool {

/// Name of the processor; "unknown" where the system does not give one.
std::string processorName();

/// Machine and program of a measurement that begins now: renderer, driver, processor, threads, load average, version,
/// commit, date.
nlohmann::ordered_json resultHead(const gl::ContextInfo& driver);

/// Name of a machine from the head of a result: processor, threads, renderer, and the driver's version, in lower-case
/// letters, digits, points and "-". One name, one history.
std::string machineOf(const nlohmann::json& head);

/// Place that a person has chosen for a result. Both empty: none is kept.
struct ResultPlace {
    std::filesystem::path named;  ///< file
    std::filesystem::path folder; ///< folder of results, which get names of their own

    bool empty() const { return named.empty() && folder.empty(); }
    /// Returns `named`, or FOLDER/MACHINE/COMMIT-NAME.json, whose folder is made; empty if there is no place. Throws
    /// RuntimeFault if the folder cannot be made.
    std::filesystem::path file(const gl::ContextInfo& driver, std::string_view name) const;
};

} // namespace meltpool
