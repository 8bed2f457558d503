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

/// The format of a table, as its reader detected it.
struct TableForm {
    TextEncoding encoding = TextEncoding::utf8;
    char separator = ',';
    bool decimalComma = false; ///< mark of the numbers read so far
    int linesAbove = 0;        ///< skipped lines above the header that are neither comments nor blank

    /// A description: "UTF-8, columns parted by commas, decimal point".
    std::string text() const;
};

/// Reads a table line by line. A line ends with LF, CR LF or CR; blank lines and rows with only empty cells are
/// skipped; a line that begins with '#' is a comment. Cells may be quoted as in RFC 4180 and then hold separators and
/// ends of line. A first line `sep=;` gives the separator; otherwise it is the comma, semicolon or tab by which the
/// header's names are recognised.
class TableReader {
  public:
    enum class Item { comment, row, end };
    using NameTest = std::function<bool(std::string_view)>;

    /// The longest row, longer than any that this program writes.
    static constexpr std::size_t kLongestRow = 65536; ///< bytes

    /// `bytes`: the whole file. The header is the first row with two names that `knows` or, if there is none, the first
    /// row. Throws as decodeText().
    TableReader(std::string bytes, std::filesystem::path file, const NameTest& knows);

    /// The names of the header, without empty ones behind the last; none if the table has no row.
    const std::vector<std::string>& columns() const { return columns_; }
    /// The line of the header, counted from 1; 0 if there is none.
    int headerLine() const { return headerLine_; }

    /// Goes to the next comment, or to the next row below or above the header; skips the header itself. Throws
    /// InputError with file and line for a row longer than kLongestRow and for a quote without its end.
    Item next();
    /// The first line of the comment or row, counted from 1.
    int line() const { return line_; }
    /// The comment from its '#' on, without separators that a spreadsheet appended.
    std::string_view comment() const { return comment_; }
    /// The row's cells, trimmed and without quotes; empty ones beyond the last column are left out.
    const std::vector<std::string_view>& cells() const { return cells_; }
    /// Throws InputError if the row's number of cells differs from the table's number of columns.
    void requireWidth() const;

    /// The number in a cell, with a decimal comma if the table has one; nothing for any other text. Throws InputError
    /// if commas and points are mixed, in this number or in the table.
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
    std::optional<char> given_;        ///< set by a first line `sep=`
    std::optional<bool> decimalComma_; ///< empty before the first number with either mark
    std::vector<std::string> columns_;
    int headerLine_ = 0;
    Place begin_; ///< start of the table, behind a line `sep=`
    Place place_; ///< start of the next line
    int line_ = 0;
    std::string_view comment_;
    std::vector<std::string_view> cells_;
    std::deque<std::string> unquoted_; ///< storage of cells that differ from the text in the file
};

} // namespace meltpool
