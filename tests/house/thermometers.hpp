// Counts that show how the source tree changes. A better reason beats each of them: only the house test's own bounds
// are refused.
#pragma once

#include "tests/house/source_scan.hpp"

#include <map>
#include <string>
#include <vector>

namespace meltpool::test {

/// Something of the tree and how many it has of what is counted.
struct NamedCount {
    std::string name;
    int count = 0;
};

/// A class with the file of its body.
struct LocatedClass {
    ClassSize size;
    std::string place; ///< "core/surface/surface.cpp:40"
};

/// Units of each folder; a header and a source of one name are one unit.
std::map<std::string, int> unitsOfFolders(const std::vector<SourceFile>& files);

/// Files of fewer than `lines` lines in units whose header only one other unit includes, with their lines. The name is
/// "core/base/x.hpp, of core/gl/y".
std::vector<NamedCount> smallFilesOfOneUser(const std::vector<SourceFile>& files, int lines);

/// Every class of the files.
std::vector<LocatedClass> classesOf(const std::vector<SourceFile>& files);

/// The `most` classes that have the most of either: public functions over `functions`, members over `members`.
std::vector<LocatedClass> largestClasses(std::vector<LocatedClass> classes, size_t most, int functions, int members);

/// For every header the number of source files (.cpp) that include it, directly or through other headers.
std::map<std::string, int> dependentsOfHeaders(const std::vector<SourceFile>& files);

/// Questions of the kind is<Gmaw>() outside of core/weld/process, which a new process would have to answer too.
int processChecks(const std::vector<SourceFile>& files);

/// Names of drivers that draw on the processor, in code and comments outside of core/gl/software_driver.
int softwareDriverWords(const std::vector<SourceFile>& files);

} // namespace meltpool::test
