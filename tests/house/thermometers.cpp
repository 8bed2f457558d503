#include "tests/house/thermometers.hpp"

#include <algorithm>
#include <iterator>
#include <regex>
#include <set>

namespace meltpool::test {

namespace {

/// Returns the unit of a file: "core/base/text" for "core/base/text.cpp".
std::string unitOf(const std::filesystem::path& file) {
    return (file.parent_path() / file.stem()).generic_string();
}

bool isHeader(const std::filesystem::path& file) {
    return file.extension() != ".cpp";
}

int countOf(const std::string& text, const std::regex& pattern) {
    return static_cast<int>(
        std::distance(std::sregex_iterator(text.begin(), text.end(), pattern), std::sregex_iterator()));
}

/// The headers that each header includes, itself included, directly or through others.
class Reach {
  public:
    explicit Reach(const std::vector<SourceFile>& files) {
        for (const SourceFile& file : files)
            for (const Include& include : findIncludes(file.text))
                included_[file.path.generic_string()].push_back(include.path);
    }

    void add(const std::string& file, std::set<std::string>& reached) const {
        const auto found = included_.find(file);
        if (found == included_.end()) return;
        for (const std::string& next : found->second)
            if (reached.insert(next).second) add(next, reached);
    }

  private:
    std::map<std::string, std::vector<std::string>> included_;
};

} // namespace

std::map<std::string, int> unitsOfFolders(const std::vector<SourceFile>& files) {
    std::map<std::string, std::set<std::string>> units;
    for (const SourceFile& file : files)
        units[file.path.parent_path().generic_string()].insert(file.path.stem().string());
    std::map<std::string, int> counts;
    for (const auto& [folder, names] : units)
        counts[folder] = static_cast<int>(names.size());
    return counts;
}

std::vector<NamedCount> smallFilesOfOneUser(const std::vector<SourceFile>& files, int lines) {
    std::map<std::string, std::set<std::string>> users;
    for (const SourceFile& file : files)
        for (const Include& include : findIncludes(file.text))
            if (unitOf(include.path) != unitOf(file.path)) users[unitOf(include.path)].insert(unitOf(file.path));
    std::vector<NamedCount> small;
    for (const SourceFile& file : files) {
        const auto length = static_cast<int>(std::count(file.text.begin(), file.text.end(), '\n'));
        const auto own = users.find(unitOf(file.path));
        if (length < lines && own != users.end() && own->second.size() == 1)
            small.push_back({file.path.generic_string() + ", of " + *own->second.begin(), length});
    }
    return small;
}

std::vector<LocatedClass> classesOf(const std::vector<SourceFile>& files) {
    std::vector<LocatedClass> all;
    for (const SourceFile& file : files)
        for (const ClassSize& size : findClasses(file.text))
            all.push_back({size, file.path.generic_string() + ":" + std::to_string(size.line)});
    return all;
}

std::vector<LocatedClass> largestClasses(std::vector<LocatedClass> classes, size_t most, int functions, int members) {
    const auto share = [=](const LocatedClass& each) {
        return std::max(static_cast<double>(each.size.publicFunctions) / functions,
                        static_cast<double>(each.size.members) / members);
    };
    std::stable_sort(classes.begin(), classes.end(), [&](const auto& a, const auto& b) { return share(a) > share(b); });
    classes.resize(std::min(most, classes.size()));
    return classes;
}

std::map<std::string, int> dependentsOfHeaders(const std::vector<SourceFile>& files) {
    const Reach reach(files);
    std::map<std::string, int> dependents;
    for (const SourceFile& file : files) {
        if (isHeader(file.path)) continue;
        std::set<std::string> reached;
        reach.add(file.path.generic_string(), reached);
        for (const std::string& header : reached)
            ++dependents[header];
    }
    return dependents;
}

int processChecks(const std::vector<SourceFile>& files) {
    static const std::regex check(R"(\bis<\s*(Gmaw|Gtaw|Smaw|Flame|SolderingIron)\s*>)");
    int count = 0;
    for (const SourceFile& file : files)
        if (!file.path.generic_string().starts_with("core/weld/process/")) count += countOf(file.text, check);
    return count;
}

int softwareDriverWords(const std::vector<SourceFile>& files) {
    static const std::regex word(R"(llvmpipe|softpipe|swrast|SwiftShader|\bMesa\b|[Ss]oftware (driver|device))");
    int count = 0;
    for (const SourceFile& file : files)
        if (!file.path.generic_string().starts_with("core/gl/software_driver/")) count += countOf(file.text, word);
    return count;
}

} // namespace meltpool::test
