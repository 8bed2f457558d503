// README and handbook as the tests read them: commands, example files, tables, links.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace meltpool::test {

/// A command of the program that a page shows.
struct ShownCommand {
    std::string arguments; ///< behind `meltpool` or `./run.sh`
    std::string notRun;    ///< the reason of a comment "not run: REASON"; empty: the command is run
    std::filesystem::path page;
    size_t line = 0;
};

/// A file that a page shows behind a comment "read as: KIND".
struct ShownFile {
    std::string kind;
    std::string text;
    std::filesystem::path page;
    size_t line = 0;
};

/// A table: heads and cells as written.
struct ShownTable {
    std::vector<std::string> heads;
    std::vector<std::vector<std::string>> rows;
    std::filesystem::path page;
    size_t line = 0;

    /// Code spans in a row's cell.
    std::vector<std::string> code(size_t row, size_t column) const;
    /// Code spans of a whole column.
    std::set<std::string> column(size_t index) const;
};

/// A link or picture: where it leads, as written.
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
    std::set<std::string> anchors; ///< of its headings, as links name them
};

/// Reads one page of Markdown. Throws InputError when it cannot be read.
Page readPage(const std::filesystem::path& file);

/// README.md of `folder` and every page of its app/handbook/.
std::vector<Page> readPages(const std::filesystem::path& folder);

/// A line of Markdown without its comments `<!-- ... -->`.
std::string withoutComments(const std::string& line);

/// Code spans (`...`) of a line of Markdown.
std::vector<std::string> codeSpans(const std::string& line);

/// A sentence for each link of the pages that leads to no file or to no heading; nothing for links to the net.
std::vector<std::string> brokenLinks(const std::vector<Page>& pages);

} // namespace meltpool::test
