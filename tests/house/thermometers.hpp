// Counts that show how the source tree changes; a good reason overrides them, and only the house test's bounds are
// enforced.
#pragma once

#include "tests/house/source_scan.hpp"

#include <map>
#include <string>
#include <vector>

namespace meltpool::test {

/// A part of the tree with its count.
struct NamedCount {
    std::string name;
    int count = 0;
};

/// A class with the file of its body.
struct LocatedClass {
    ClassSize size;
    std::string place; ///< place in the form "core/surface/surface.cpp:40"
};

/// Returns the number of units of each folder; a header and a source of one name are one unit.
std::map<std::string, int> unitsOfFolders(const std::vector<SourceFile>& files);

/// Returns files of fewer than `lines` lines, with their lines, in units whose header only one other unit includes. The
/// name has the form "core/base/x.hpp, of core/gl/y".
std::vector<NamedCount> smallFilesOfOneUser(const std::vector<SourceFile>& files, int lines);

/// Returns every class of the files.
std::vector<LocatedClass> classesOf(const std::vector<SourceFile>& files);

/// Returns the `most` classes that have the most of either: public functions over `functions`, members over `members`.
std::vector<LocatedClass> largestClasses(std::vector<LocatedClass> classes, size_t most, int functions, int members);

/// Returns for every header the number of source files (.cpp) that include it, directly or through other headers.
std::map<std::string, int> dependentsOfHeaders(const std::vector<SourceFile>& files);

/// Returns the number of checks like is<Gmaw>() outside core/weld/process, which a new process would need too.
int processChecks(const std::vector<SourceFile>& files);

/// Returns the number of names of software drivers, in code and comments outside core/gl/software_driver.
int softwareDriverWords(const std::vector<SourceFile>& files);

} // namespace meltpool::test
