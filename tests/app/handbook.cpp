#include "tests/app/handbook.hpp"

#include "core/base/text.hpp"

#include <algorithm>
#include <regex>

namespace meltpool::test {

namespace {

namespace fs = std::filesystem;

/// Returns the name by which links reach a heading: lower case, dashes for spaces, without punctuation.
std::string anchorOf(const std::string& heading) {
    std::string anchor;
    for (const char c : heading) {
        if (c >= 'A' && c <= 'Z')
            anchor += static_cast<char>(c - 'A' + 'a');
        else if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_')
            anchor += c;
        else if (c == ' ')
            anchor += '-';
    }
    return anchor;
}

/// Returns the comment `<!-- KEY: WORDS -->` of a line; "" for a line without one.
std::string comment(const std::string& line, const std::string& key) {
    const std::string begin = "<!-- " + key + ": ";
    const size_t from = line.find(begin), to = line.find(" -->", from);
    if (from == std::string::npos || to == std::string::npos) return "";
    return line.substr(from + begin.size(), to - from - begin.size());
}

std::vector<std::string> cellsOf(const std::string& line) {
    std::vector<std::string> cells;
    const std::string_view inner = trimText(line);
    for (const std::string_view cell : splitText(inner.substr(1, inner.size() - 2), '|'))
        cells.emplace_back(trimText(cell));
    return cells;
}

/// Walks over the lines of a page; a comment on a line of its own applies to the block below it.
class Reader {
  public:
    explicit Reader(Page& page) : page_(page) {}

    void read() {
        for (size_t i = 0; i < page_.lines.size(); ++i)
            line(page_.lines[i], i + 1);
        closeTable();
    }

  private:
    void line(const std::string& text, size_t number) {
        if (text.starts_with("```")) {
            fence(text, number);
        } else if (inFence_) {
            fenced(text, number);
        } else if (trimText(text).empty()) {
            closeTable();
            if (!freshComment_) blockNotRun_.clear();
            if (!freshComment_) blockKind_.clear();
        } else if (trimText(withoutComments(text)).empty()) {
            aloneComment(text);
            return;
        } else {
            prose(text, number);
        }
        freshComment_ = false;
    }

    void aloneComment(const std::string& text) {
        blockNotRun_ = comment(text, "not run");
        blockKind_ = comment(text, "read as");
        freshComment_ = true;
    }

    void fence(const std::string& text, size_t number) {
        inFence_ = !inFence_;
        if (!inFence_) {
            if (!shown_.kind.empty()) page_.files.push_back(shown_);
            blockNotRun_.clear();
            blockKind_.clear();
            return;
        }
        closeTable();
        language_ = text.substr(3);
        shown_ = {blockKind_, "", page_.file, number};
    }

    void fenced(const std::string& text, size_t number) {
        shown_.text += text + "\n";
        if (language_ != "sh") return;
        const std::string command(trimText(text.substr(0, text.find(" #"))));
        addCommand(command, blockNotRun_, number);
    }

    void prose(const std::string& text, size_t number) {
        static const std::regex kLink(R"(\]\(([^)\s]+)\))");
        if (text.starts_with("#")) page_.anchors.insert(anchorOf(std::string(trimText(text.substr(text.find(' '))))));
        for (std::sregex_iterator link(text.begin(), text.end(), kLink), end; link != end; ++link)
            page_.links.push_back({(*link)[1], number});
        const std::string own = comment(text, "not run");
        for (const std::string& span : codeSpans(text)) {
            page_.code.push_back(span);
            addCommand(span, own.empty() ? blockNotRun_ : own, number);
        }
        if (text.starts_with("|"))
            tableLine(text, number);
        else
            closeTable();
    }

    void addCommand(const std::string& text, const std::string& notRun, size_t number) {
        for (const std::string program : {"meltpool ", "./run.sh "})
            if (text.starts_with(program))
                page_.commands.push_back({text.substr(program.size()), notRun, page_.file, number});
    }

    void tableLine(const std::string& text, size_t number) {
        const std::vector<std::string> cells = cellsOf(withoutComments(text));
        if (table_.heads.empty())
            table_ = {cells, {}, page_.file, number};
        else if (!cells.front().starts_with("---"))
            table_.rows.push_back(cells);
    }

    void closeTable() {
        if (!table_.heads.empty()) page_.tables.push_back(table_);
        table_ = {};
    }

    Page& page_;
    bool inFence_ = false;
    bool freshComment_ = false; ///< the line above is a comment on a line of its own
    std::string language_, blockNotRun_, blockKind_;
    ShownFile shown_;
    ShownTable table_;
};

} // namespace

std::string withoutComments(const std::string& line) {
    static const std::regex kComment("<!--.*?-->");
    return std::regex_replace(line, kComment, "");
}

std::vector<std::string> codeSpans(const std::string& line) {
    std::vector<std::string> spans;
    const auto pieces = splitText(line, '`');
    for (size_t i = 1; i + 1 < pieces.size(); i += 2)
        spans.emplace_back(pieces[i]);
    return spans;
}

std::vector<std::string> ShownTable::code(size_t row, size_t column) const {
    return column < rows[row].size() ? codeSpans(rows[row][column]) : std::vector<std::string>();
}

std::set<std::string> ShownTable::column(size_t index) const {
    std::set<std::string> all;
    for (size_t row = 0; row < rows.size(); ++row)
        for (const std::string& span : code(row, index))
            all.insert(span);
    return all;
}

Page readPage(const fs::path& file) {
    Page page;
    page.file = file;
    const std::string text = readTextFile(file);
    for (const std::string_view line : splitText(text, '\n'))
        page.lines.emplace_back(line);
    if (page.lines.back().empty()) page.lines.pop_back();
    Reader(page).read();
    return page;
}

std::vector<Page> readPages(const fs::path& folder) {
    std::vector<fs::path> files{folder / "README.md"};
    for (const auto& entry : fs::directory_iterator(folder / "app" / "handbook"))
        if (entry.path().extension() == ".md") files.push_back(entry.path());
    std::sort(files.begin() + 1, files.end());
    std::vector<Page> pages;
    for (const fs::path& file : files)
        pages.push_back(readPage(file));
    return pages;
}

std::vector<std::string> brokenLinks(const std::vector<Page>& pages) {
    std::vector<std::string> broken;
    for (const Page& page : pages)
        for (const ShownLink& link : page.links) {
            if (link.target.starts_with("http")) continue;
            const size_t hash = link.target.find('#');
            const std::string name = link.target.substr(0, hash);
            const fs::path file = name.empty() ? page.file : page.file.parent_path() / name;
            const std::string where = page.file.string() + ":" + std::to_string(link.line) + ": " + link.target;
            if (!fs::is_regular_file(file))
                broken.push_back(where + " leads to no file");
            else if (hash != std::string::npos && !readPage(file).anchors.contains(link.target.substr(hash + 1)))
                broken.push_back(where + " leads to no heading");
        }
    return broken;
}

} // namespace meltpool::test
