// Reads tables of any program that writes rows of cells: CSV, tab-separated text and their relatives.
#pragma once

#include "core/base/text_encoding.hpp"

#include <deque>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool {

/// How a table is written, as its reader has found out.
struct TableForm {
    TextEncoding encoding = TextEncoding::utf8;
    char separator = ',';
    bool decimalComma = false; ///< of the numbers that have been read so far
    int linesAbove = 0;        ///< left out, as they stand above the header and are neither comments nor blank

    /// "UTF-8, columns parted by commas, decimal point".
    std::string text() const;
};

/// Goes through a table line by line. A line ends with LF, CR LF or CR; blank lines, and rows whose cells are all
/// empty, are left out; a line that begins with '#' is a comment. Cells may be quoted as RFC 4180 says and then hold
/// separators and ends of line. A first line `sep=;` gives the separator; else it is the comma, semicolon or tab by
/// which the header's names are recognised.
class TableReader {
  public:
    enum class Item { comment, row, end };
    using NameTest = std::function<bool(std::string_view)>;

    /// More than any row of this program has.
    static constexpr std::size_t kLongestRow = 65536; ///< bytes

    /// `bytes`: the whole file. The header is the first row with two names that `knows` or, where none is, the first
    /// row. Throws what decodeText() throws.
    TableReader(std::string bytes, std::filesystem::path file, const NameTest& knows);

    /// The names of the header, without the empty ones behind the last; none where the table has no row.
    const std::vector<std::string>& columns() const { return columns_; }
    /// Line of the header, counted from 1; 0 where there is none.
    int headerLine() const { return headerLine_; }

    /// Goes to the next comment or row below or above the header; the header itself is none. Throws InputError naming
    /// file and line for a row longer than kLongestRow and for a quote without its end.
    Item next();
    /// Of the comment or row: its first line, counted from 1.
    int line() const { return line_; }
    /// Of the comment: from its '#' on, without separators that a spreadsheet has put behind it.
    std::string_view comment() const { return comment_; }
    /// Of the row: trimmed and without quotes; empty ones beyond the last column are left out.
    const std::vector<std::string_view>& cells() const { return cells_; }
    /// Throws InputError where the row has not as many cells as the table has columns.
    void requireWidth() const;

    /// The number that a cell spells, with a decimal comma where the table has one; nothing for anything else. Throws
    /// InputError where commas and points are mixed, in this number or in the table.
    std::optional<double> number(std::string_view cell);

    const TableForm& form() const { return form_; }

  private:
    struct Place {
        std::size_t at = 0;
        int line = 1;
    };

    [[noreturn]] void fail(int line, const std::string& sentence) const;
    std::string_view takeLine(Place& place) const;
    void takeSeparatorLine();
    void findHeader(const NameTest& knows);
    void takeHeader(Place place, char separator);
    void readRow(Place& place);
    std::string_view quotedCell(Place& place);
    std::string_view plainCell(Place& place) const;
    bool atRowEnd(const Place& place) const;
    std::size_t knownNames(std::string_view line, char separator, const NameTest& knows) const;

    std::filesystem::path file_;
    std::string text_;
    TableForm form_;
    std::optional<char> given_;        ///< by a first line `sep=`
    std::optional<bool> decimalComma_; ///< nothing before the first number with either
    std::vector<std::string> columns_;
    int headerLine_ = 0;
    Place begin_; ///< of the table, behind a line `sep=`
    Place place_; ///< of what comes next
    int line_ = 0;
    std::string_view comment_;
    std::vector<std::string_view> cells_;
    std::deque<std::string> unquoted_; ///< what cells_ shows of cells that are not in the text as they are meant
};

} // namespace meltpool
