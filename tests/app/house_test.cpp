// The handbook's table of folders against the includes of the tree; tests/house checks the rules that need no table.
#include "core/base/text.hpp"
#include "tests/app/handbook.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/places.hpp"

#include <algorithm>
#include <regex>

using namespace meltpool;
using namespace meltpool::test;

namespace {

namespace fs = std::filesystem;

/// An include of one folder by another.
struct Include {
    std::string from, to; ///< folders, with a slash at their end
    std::string file, included;
};

/// Returns every include of core, xr and app by another folder.
std::vector<Include> readIncludes() {
    static const std::regex kInclude("#include \"((?:core|xr|app|shaders|tests)/[^\"]*)\"");
    std::vector<Include> includes;
    for (const char* top : {"core", "xr", "app"})
        for (const auto& entry : fs::recursive_directory_iterator(sourceFolder() / top)) {
            if (entry.path().extension() != ".hpp" && entry.path().extension() != ".cpp") continue;
            const std::string file = fs::relative(entry.path(), sourceFolder()).generic_string();
            const std::string folder = file.substr(0, file.rfind('/') + 1);
            const std::string text = readTextFile(entry.path());
            for (std::sregex_iterator found(text.begin(), text.end(), kInclude), end; found != end; ++found) {
                const std::string included = (*found)[1];
                const std::string other = included.substr(0, included.rfind('/') + 1);
                if (other != folder) includes.push_back({folder, other, file, included});
            }
        }
    return includes;
}

/// Returns the folders of the handbook's table, from the top down.
std::vector<std::string> tableOfFolders() {
    for (const ShownTable& table : readPage(sourceFolder() / "app/handbook/architecture.md").tables)
        if (table.heads.front() == "folder") {
            std::vector<std::string> folders;
            for (size_t row = 0; row < table.rows.size(); ++row)
                folders.push_back(table.code(row, 0).at(0));
            return folders;
        }
    return {};
}

/// Returns the row of the table for a folder: its own, or that of the nearest parent folder; the table's size if none
/// matches.
size_t rowOf(const std::vector<std::string>& table, const std::string& folder) {
    size_t best = table.size();
    for (size_t row = 0; row < table.size(); ++row)
        if (folder.starts_with(table[row]) && (best == table.size() || table[row].size() > table[best].size()))
            best = row;
    return best;
}

} // namespace

TEST_CASE("includes lead down the handbook's table of folders", "[app][house]") {
    const std::vector<std::string> table = tableOfFolders();
    REQUIRE(table.size() > 20);
    for (const std::string& folder : table) {
        INFO(folder);
        CHECK(fs::is_directory(sourceFolder() / folder));
    }
    const std::vector<Include> includes = readIncludes();
    CHECK(includes.size() > 200);
    for (const Include& include : includes) {
        if (include.from == "app/") continue; // main.cpp is above the table
        INFO(include.file << " includes " << include.included);
        REQUIRE(rowOf(table, include.from) < table.size());
        REQUIRE(rowOf(table, include.to) < table.size());
        CHECK(rowOf(table, include.from) <= rowOf(table, include.to));
        CHECK_FALSE(include.to.starts_with("tests/"));
    }
}
