// README and handbook as data for tests: commands, example files, tables, links.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace meltpool::test {

/// A command of the program that a page shows.
struct ShownCommand {
    std::string arguments; ///< text after `meltpool` or `./run.sh`
    std::string notRun;    ///< reason in a comment "not run: REASON"; empty if the command is run
    std::filesystem::path page;
    size_t line = 0;
};

/// A file that a page shows after a comment "read as: KIND".
struct ShownFile {
    std::string kind;
    std::string text;
    std::filesystem::path page;
    size_t line = 0;
};

/// A table with heads and cells as written.
struct ShownTable {
    std::vector<std::string> heads;
    std::vector<std::vector<std::string>> rows;
    std::filesystem::path page;
    size_t line = 0;

    /// Returns the code spans in a row's cell.
    std::vector<std::string> code(size_t row, size_t column) const;
    /// Returns the code spans of a whole column.
    std::set<std::string> column(size_t index) const;
};

/// A link or picture with its target as written.
struct ShownLink {
    std::string target;
    size_t line = 0;
};

struct Page {
    std::filesystem::path file;
    std::vector<std::string> lines;
    std::vector<ShownCommand> commands;
    std::vector<ShownFile> files;
    std::vector<ShownTable> tables;
    std::vector<ShownLink> links;
    std::vector<std::string> code; ///< code spans outside fences
    std::set<std::string> anchors; ///< anchors of its headings, as links name them
};

/// Reads one page of Markdown. Throws InputError when it cannot be read.
Page readPage(const std::filesystem::path& file);

/// README.md of `folder` and every page of its app/handbook/.
std::vector<Page> readPages(const std::filesystem::path& folder);

/// Returns a line of Markdown without its comments `<!-- ... -->`.
std::string withoutComments(const std::string& line);

/// Returns the code spans (`...`) of a line of Markdown.
std::vector<std::string> codeSpans(const std::string& line);

/// Returns a sentence for each link of the pages that leads to no file or to no heading. Links to the net are not
/// checked.
std::vector<std::string> brokenLinks(const std::vector<Page>& pages);

} // namespace meltpool::test
