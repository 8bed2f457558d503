// Tables of other programs: lines, quotes, separators, encodings and decimal commas.
#include "core/base/table_reader.hpp"

#include "core/base/error.hpp"
#include "tests/support/catch.hpp"

using namespace meltpool;
using meltpool::test::containsText;

namespace {

TableReader tableOf(std::string text) {
    return TableReader(std::move(text), "t.csv", [](std::string_view name) { return name == "a" || name == "b"; });
}

/// Returns all rows and comments as "LINE:cell|cell".
std::vector<std::string> itemsOf(TableReader table) {
    std::vector<std::string> items;
    for (TableReader::Item item = table.next(); item != TableReader::Item::end; item = table.next()) {
        std::string text = std::to_string(table.line()) + ":";
        if (item == TableReader::Item::comment) text += table.comment();
        if (item == TableReader::Item::row)
            for (size_t i = 0; i < table.cells().size(); ++i)
                text += (i > 0 ? "|" : "") + std::string(table.cells()[i]);
        items.push_back(text);
    }
    return items;
}

using Items = std::vector<std::string>;

std::string refusalOf(const std::string& text) {
    try {
        TableReader table = tableOf(text);
        while (table.next() != TableReader::Item::end)
            if (!table.cells().empty()) table.requireWidth();
    } catch (const InputError& error) {
        return error.what();
    }
    return "taken";
}

} // namespace

TEST_CASE("a table's lines end as on any system, and each row knows its line", "[base]") {
    for (const char* text : {"# c\na,b\n\n1,2\n3,4", "# c\r\na,b\r\n\r\n1,2\r\n3,4\r\n", "# c\ra,b\r\r1,2\r3,4\r"}) {
        INFO(text);
        CHECK(tableOf(text).columns() == Items{"a", "b"});
        CHECK(tableOf(text).headerLine() == 2);
        CHECK(itemsOf(tableOf(text)) == Items{"1:# c", "4:1|2", "5:3|4"});
    }
    CHECK(tableOf("").columns().empty());
    CHECK(tableOf("# only\n\n").headerLine() == 0);
}

TEST_CASE("quoted cells hold separators, quotes and ends of line", "[base]") {
    CHECK(itemsOf(tableOf("a;b\n\"1;\"\"x\"\"\";\"two\nlines\"\n 3 ; \"4\" \n")) ==
          Items{"2:1;\"x\"|two\nlines", "4:3|4"});
    CHECK_THAT(refusalOf("a,b\n1,\"2\n3,4\n"), containsText("t.csv:2: a quote in cell 2 does not end"));
    CHECK_THAT(refusalOf("a,b\n\"1\"2,3\n"), containsText("t.csv:2: text follows the closing quote of cell 1"));
    CHECK(itemsOf(tableOf("a,b\n1\",2\n")) == Items{"2:1\"|2"}); // inches: no quote begins inside a cell
}

TEST_CASE("separator and header are found by the names, or by what is most frequent", "[base]") {
    CHECK(tableOf("a\tb\n").form().separator == '\t');
    CHECK(tableOf("sep=|\na|b\n").form().separator == '|');
    CHECK(tableOf("a;b, in mm\n1;2").columns() == Items{"a", "b, in mm"});
    TableReader table = tableOf("by;robot;7\n# c\na,b\n1,2\n");
    CHECK(table.form().linesAbove == 1);
    CHECK(itemsOf(std::move(table)) == Items{"2:# c", "4:1|2"});
    CHECK(tableOf("x;y;z\n1;2;3\n").columns() == Items{"x", "y", "z"});
    CHECK(itemsOf(tableOf("a;b;;\n# c;;;\n1;2;;\n;;;\n")) == Items{"2:# c", "3:1|2"});
    CHECK_THAT(refusalOf("a,b\n1,2,3\n"), containsText("t.csv:2: has 3 cells; expected 2"));
}

TEST_CASE("numbers have a point or a comma, one of them in the whole table", "[base]") {
    TableReader comma = tableOf("a;b\n1,5;2\n");
    comma.next();
    CHECK(comma.number(comma.cells()[0]) == 1.5);
    CHECK(comma.number("-2,5E-1") == -0.25);
    CHECK(comma.number("7") == 7.0);
    CHECK(comma.form().decimalComma);
    CHECK_FALSE(comma.number("word"));
    CHECK_FALSE(comma.number("a,b.c"));
    CHECK_THROWS_WITH(comma.number("0.5"), containsText("t.csv:2: has the number '0.5' below numbers with a decimal "
                                                        "comma"));
    TableReader point = tableOf("a;b\n");
    CHECK(point.number("0.5") == 0.5);
    CHECK_THROWS_AS(point.number("0,5"), InputError);
    CHECK_THROWS_WITH(point.number("1,234.5"), containsText("without a thousands separator"));
}

TEST_CASE("texts are UTF-8, UTF-16 with a byte order mark or Windows-1252", "[base]") {
    const auto decoded = [](std::string_view bytes) { return decodeText(std::string(bytes), "t.txt"); };
    CHECK(decoded("\xEF\xBB\xBFgr\xC3\xBCn").text == "gr\xC3\xBCn");
    CHECK(decoded("gr\xFCn \x80").text == "gr\xC3\xBCn \xE2\x82\xAC");
    CHECK(decoded("gr\xFCn").encoding == TextEncoding::windows1252);
    CHECK(decoded(std::string_view("\xFF\xFE\x61\x00\xAC\x20\x3D\xD8\x00\xDE", 10)).text ==
          "a\xE2\x82\xAC\xF0\x9F\x98\x80");
    CHECK(decoded(std::string_view("\xFE\xFF\x00\x61\xD8\x3D", 6)).text == "a\xEF\xBF\xBD"); // half of a surrogate pair
    CHECK_THROWS_WITH(decoded("\xFF\xFE\x61"), containsText("t.txt: is UTF-16 and ends with half a character"));
    CHECK_THROWS_WITH(decoded(std::string_view("a\0b\0c\0", 6)),
                      containsText("looks like UTF-16 without a byte order mark"));
    CHECK(utf8Length("a\xC3\xBC\xC3") == 3);
    CHECK(utf8Length("\xC0\x80") == 0);         // overlong
    CHECK(utf8Length("\xED\xA0\x80") == 0);     // half of a surrogate pair
    CHECK(utf8Length("\xF4\x90\x80\x80") == 0); // beyond U+10FFFF
}
