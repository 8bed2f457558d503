#include "tests/house/source_scan.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

namespace meltpool::test {

namespace {

/// Replaces a range by spaces except for its line ends, so that lines keep their numbers.
void blank(std::string& text, size_t begin, size_t end) {
    for (size_t i = begin; i < std::min(end, text.size()); ++i)
        if (text[i] != '\n') text[i] = ' ';
}

size_t endOfQuoted(const std::string& text, size_t begin) {
    const char quote = text[begin];
    for (size_t i = begin + 1; i < text.size(); ++i) {
        if (text[i] == '\\')
            ++i;
        else if (text[i] == quote || text[i] == '\n')
            return i + 1;
    }
    return text.size();
}

/// Returns the end of a raw string whose first quote is at `begin`.
size_t endOfRawString(const std::string& text, size_t begin) {
    const size_t open = text.find('(', begin);
    if (open == std::string::npos) return text.size();
    const std::string close = ")" + text.substr(begin + 1, open - begin - 1) + "\"";
    const size_t end = text.find(close, open);
    return end == std::string::npos ? text.size() : end + close.size();
}

/// Returns the end of a preprocessor directive with its continued lines.
size_t endOfDirective(const std::string& text, size_t begin) {
    size_t end = text.find('\n', begin);
    while (end != std::string::npos && end > 0 && text[end - 1] == '\\')
        end = text.find('\n', end + 1);
    return end == std::string::npos ? text.size() : end;
}

bool startsLine(const std::string& text, size_t at) {
    while (at > 0 && (text[at - 1] == ' ' || text[at - 1] == '\t'))
        --at;
    return at == 0 || text[at - 1] == '\n';
}

/// True for an apostrophe between digits, which separates groups of digits: 1'000.
bool separatesDigits(const std::string& text, size_t at) {
    return at > 0 && at + 1 < text.size() && std::isxdigit(static_cast<unsigned char>(text[at - 1])) != 0 &&
           std::isxdigit(static_cast<unsigned char>(text[at + 1])) != 0;
}

/// Returns the text without comments, literals and preprocessor lines.
std::string onlyCode(std::string_view source) {
    std::string text(source);
    for (size_t i = 0; i < text.size();) {
        size_t end = i;
        if (text.compare(i, 2, "//") == 0)
            end = std::min(text.find('\n', i), text.size());
        else if (text.compare(i, 2, "/*") == 0)
            end = std::min(text.find("*/", i + 2), text.size() - 2) + 2;
        else if (text[i] == '#' && startsLine(text, i))
            end = endOfDirective(text, i);
        else if (text[i] == '"')
            end = i > 0 && text[i - 1] == 'R' ? endOfRawString(text, i) : endOfQuoted(text, i);
        else if (text[i] == '\'' && !separatesDigits(text, i))
            end = endOfQuoted(text, i);
        blank(text, i, end);
        i = std::max(end, i + 1);
    }
    return text;
}

int lineOf(std::string_view text, size_t at) {
    return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

std::string onOneLine(std::string_view text) {
    std::string line;
    for (const char c : text) {
        const bool space = std::isspace(static_cast<unsigned char>(c)) != 0;
        if (!space)
            line += c;
        else if (!line.empty() && line.back() != ' ')
            line += ' ';
    }
    return line;
}

/// True if the text has a `wanted` outside all parentheses.
bool hasOutsideParentheses(std::string_view text, char wanted) {
    int depth = 0;
    for (const char c : text) {
        if (c == wanted && depth == 0) return true;
        depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    }
    return false;
}

enum class Brace { function, scope, initialiser };

/// Returns the kind of the scope that a brace after this declaration opens. Scopes contain further declarations;
/// initialisers contain none.
Brace kindOf(std::string head) {
    static const std::regex parameters(R"(template\s*<[^>]*>)");
    static const std::regex scope(
        R"(^\s*((static|const|constexpr|inline|typedef)\s+)*(namespace|class|struct|union|enum|extern)\b)");
    static const std::regex block(R"(\b(uniform|buffer|in|out)\s+\w+\s*$)"); // GLSL
    head = std::regex_replace(head, parameters, "");
    if (std::regex_search(head, scope) || std::regex_search(head, block)) return Brace::scope;
    if (head.find("operator") != std::string::npos) return Brace::function;
    if (head.find('(') == std::string::npos || hasOutsideParentheses(head, '=')) return Brace::initialiser;
    return Brace::function;
}

/// Walks over the braces of a text without comments.
class FunctionScanner {
  public:
    explicit FunctionScanner(std::string_view source) : code_(onlyCode(source)) {}

    std::vector<FunctionLength> scan() {
        for (size_t i = 0; i < code_.size(); ++i) {
            if (code_[i] == '{') open(i);
            if (code_[i] == '}') close(i);
            if (code_[i] == ';' && parentheses_ == 0 && bodyDepth_ == 0) headBegin_ = i + 1;
            parentheses_ += code_[i] == '(' ? 1 : code_[i] == ')' ? -1 : 0;
        }
        return found_;
    }

  private:
    void open(size_t at) {
        ++depth_;
        if (ignoredDepth_ != 0 || bodyDepth_ != 0) return;
        switch (kindOf(onOneLine(std::string_view(code_).substr(headBegin_, at - headBegin_)))) {
        case Brace::function:
            bodyDepth_ = depth_;
            break;
        case Brace::initialiser:
            ignoredDepth_ = depth_;
            break;
        case Brace::scope:
            headBegin_ = at + 1;
            break;
        }
    }

    void close(size_t at) {
        const int closed = depth_--;
        if (ignoredDepth_ != 0) {
            if (closed == ignoredDepth_) ignoredDepth_ = 0;
            return;
        }
        if (bodyDepth_ != 0 && closed != bodyDepth_) return;
        // A constructor's body follows the braces of its member initialiser.
        const size_t next = code_.find_first_not_of(" \t\n", at + 1);
        const bool member = bodyDepth_ != 0 && next != std::string::npos && (code_[next] == ',' || code_[next] == '{');
        if (bodyDepth_ != 0 && !member) report(at);
        bodyDepth_ = 0;
        if (!member) headBegin_ = at + 1;
    }

    void report(size_t end) {
        const size_t begin = code_.find_first_not_of(" \t\n", headBegin_);
        const int first = lineOf(code_, begin);
        const std::string head = onOneLine(std::string_view(code_).substr(begin, code_.find('{', begin) - begin));
        found_.push_back({first, lineOf(code_, end) - first + 1, head});
    }

    std::string code_;
    std::vector<FunctionLength> found_;
    size_t headBegin_ = 0;
    int depth_ = 0;
    int bodyDepth_ = 0;    ///< depth of braces inside the open function; 0 outside functions
    int ignoredDepth_ = 0; ///< depth of braces inside an initialiser
    int parentheses_ = 0;
};

/// Returns the text without the word `template` and without <..>, whose parentheses and commas do not count.
std::string withoutTemplateArguments(const std::string& text) {
    static const std::regex innermost(R"(([A-Za-z0-9_])\s*<[^<>;]*>)"), word(R"(\btemplate\b\s*)");
    std::string before, after = text;
    while (after != before) {
        before = after;
        after = std::regex_replace(before, innermost, "$1");
    }
    return std::regex_replace(after, word, "");
}

/// The declarations of one class, counted.
class ClassBody {
  public:
    explicit ClassBody(bool isPublic) : public_(isPublic) {}

    void setPublic(bool isPublic) { public_ = isPublic; }
    int publicFunctions() const { return publicFunctions_; }
    int members() const { return members_; }

    /// Counts a function with its body.
    void takeFunction() { publicFunctions_ += public_ ? 1 : 0; }

    /// Counts a declaration on one line, without the contents of braces; after a nested type it holds only the names
    /// behind the type.
    void take(const std::string& declaration, bool behindType) {
        static const std::regex none(R"(\s*((using|typedef|friend|static_assert|enum)\b.*)?)");
        static const std::regex forward(R"(\s*(class|struct|union)\s+\w+\s*)");
        static const std::regex aside(R"(\[\[[^\]]*\]\]|\balignas\s*\([^)]*\))");
        static const std::regex deleted(R"(=\s*delete\s*$)");
        const std::string text = std::regex_replace(withoutTemplateArguments(declaration), aside, "");
        if (std::regex_match(text, none) || std::regex_match(text, forward)) return;
        if (!behindType && isFunction(text)) {
            if (!std::regex_search(text, deleted)) takeFunction();
            return;
        }
        static const std::regex shared(R"(^[^=]*\bstatic\b)");
        if (!std::regex_search(text, shared)) members_ += 1 + commasOutside(text);
    }

  private:
    static bool isFunction(const std::string& text) {
        if (text.find("operator") != std::string::npos) return true;
        const size_t open = text.find('(');
        return open != std::string::npos && open < text.find('=') && text.compare(open, 2, "(*") != 0;
    }

    static int commasOutside(const std::string& text) {
        int depth = 0, commas = 0;
        for (const char c : text) {
            commas += c == ',' && depth == 0 ? 1 : 0;
            depth += c == '(' ? 1 : c == ')' ? -1 : 0;
        }
        return commas;
    }

    bool public_;
    int publicFunctions_ = 0;
    int members_ = 0;
};

/// Walks over the declarations of a text without comments, from scope to scope.
class ClassScanner {
  public:
    explicit ClassScanner(std::string_view source) : code_(onlyCode(source)) {}

    std::vector<ClassSize> scan() {
        declarations(0, code_.size(), "", nullptr);
        return found_;
    }

  private:
    /// Walks the declarations from `begin` to `end`, in the class `inside` of the name `outer` or, where that is null,
    /// in a namespace.
    void declarations(size_t begin, size_t end, const std::string& outer, ClassBody* inside) {
        std::string head; // text of the declaration from its begin
        bool behindType = false;
        const auto finish = [&] {
            head.clear();
            behindType = false;
        };
        for (size_t i = begin; i < end; ++i) {
            const char c = code_[i];
            if (c == '{') {
                const size_t close = closingBrace(i);
                switch (kindOfHead(head)) {
                case Brace::scope:
                    behindType = scope(i, close, onOneLine(head), outer, inside);
                    head.clear();
                    break;
                case Brace::function:
                    if (continues(close)) break; // braces of a member's initialiser
                    if (inside != nullptr && !onOneLine(head).starts_with("friend ")) inside->takeFunction();
                    finish();
                    break;
                case Brace::initialiser:
                    break;
                }
                i = close;
            } else if (c == ';') {
                if (inside != nullptr) inside->take(onOneLine(head), behindType);
                finish();
            } else if (c == ':' && inside != nullptr && setsAccess(head, i, *inside)) {
                finish();
            } else {
                head += c;
            }
        }
    }

    /// Walks a class, namespace or enumeration between two braces. Returns true for a type, after which names may
    /// follow.
    bool scope(size_t open, size_t close, const std::string& head, const std::string& outer, ClassBody* inside) {
        static const std::regex type(R"((?:^|[^\w])(class|struct|union)\s+((?:alignas\s*\([^)]*\)\s*)?)([\w:]*))");
        static const std::regex enumeration(R"(\benum\b)");
        std::smatch match;
        if (std::regex_search(head, enumeration)) return true;
        const std::string plain = withoutTemplateArguments(head);
        if (!std::regex_search(plain, match, type)) {
            declarations(open + 1, close, outer, nullptr);
            return inside != nullptr;
        }
        const std::string own = match[3].length() > 0 ? match[3].str() : std::string("(unnamed)");
        const std::string name = outer.empty() ? own : outer + "::" + own;
        ClassBody body(match[1] != "class");
        declarations(open + 1, close, name, &body);
        found_.push_back({lineOf(code_, open), name, body.publicFunctions(), body.members()});
        return true;
    }

    static Brace kindOfHead(const std::string& head) {
        const auto open = std::count(head.begin(), head.end(), '('), closed = std::count(head.begin(), head.end(), ')');
        if (open != closed) return Brace::initialiser; // inside a default argument
        return kindOf(withoutTemplateArguments(onOneLine(head)));
    }

    /// True if an access label ends at `at`; the label then applies to the following members.
    bool setsAccess(const std::string& head, size_t at, ClassBody& body) const {
        if (code_.compare(at, 2, "::") == 0 || (at > 0 && code_[at - 1] == ':')) return false;
        const std::string word = onOneLine(head);
        const size_t end = word.find_last_not_of(' ');
        const std::string label = end == std::string::npos ? std::string() : word.substr(0, end + 1);
        if (label != "public" && label != "protected" && label != "private") return false;
        body.setPublic(label == "public");
        return true;
    }

    size_t closingBrace(size_t open) const {
        int depth = 0;
        for (size_t i = open; i < code_.size(); ++i) {
            depth += code_[i] == '{' ? 1 : code_[i] == '}' ? -1 : 0;
            if (depth == 0) return i;
        }
        return code_.size();
    }

    /// True if a constructor continues after the brace at `close`.
    bool continues(size_t close) const {
        const size_t next = code_.find_first_not_of(" \t\n", close + 1);
        return next != std::string::npos && (code_[next] == ',' || code_[next] == '{');
    }

    std::string code_;
    std::vector<ClassSize> found_;
};

/// Returns the distinct component names in a comment: "xyz position, w temperature" has two.
std::set<std::string> componentsNamed(const std::string& comment) {
    static const std::regex product(R"([0-9)]\s*x\s*[0-9(])"); // a product such as 4 x 4
    static const std::regex component(R"(\b(x|y|z|w|xy|yz|zw|xyz|yzw|rgb|rg|ba)\b(?!-))");
    const std::string text = std::regex_replace(comment, product, "");
    std::set<std::string> names;
    for (std::sregex_iterator i(text.begin(), text.end(), component), end; i != end; ++i)
        names.insert(i->str());
    return names;
}

} // namespace

std::vector<SourceFile> readSources(const std::filesystem::path& root, const std::vector<std::string_view>& folders,
                                    const std::vector<std::string_view>& extensions) {
    std::vector<SourceFile> files;
    for (const std::string_view folder : folders)
        for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
            const std::string extension = entry.path().extension().string();
            if (std::find(extensions.begin(), extensions.end(), extension) == extensions.end()) continue;
            std::ifstream in(entry.path(), std::ios::binary);
            files.push_back({std::filesystem::relative(entry.path(), root).generic_string(),
                             {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()}});
        }
    std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
    return files;
}

std::vector<Include> findIncludes(std::string_view text) {
    static const std::regex include(R"rx(^\s*#\s*include\s*"([^"]+)")rx");
    std::vector<Include> found;
    int line = 1;
    for (size_t begin = 0; begin < text.size(); ++line) {
        const size_t end = std::min(text.find('\n', begin), text.size());
        const std::string one(text.substr(begin, end - begin));
        std::smatch match;
        if (std::regex_search(one, match, include)) found.push_back({line, match[1]});
        begin = end + 1;
    }
    return found;
}

std::vector<FunctionLength> findFunctions(std::string_view text) {
    return FunctionScanner(text).scan();
}

std::vector<ClassSize> findClasses(std::string_view text) {
    return ClassScanner(text).scan();
}

std::vector<int> findMixedVectors(std::string_view text) {
    static const std::regex declared(R"(\b[iu]?vec[234]\s+\w+\s*(\[[^\]]*\])?\s*;[^/]*//(.*)$)");
    std::vector<int> found;
    int line = 1;
    for (size_t begin = 0; begin < text.size(); ++line) {
        const size_t end = std::min(text.find('\n', begin), text.size());
        const std::string one(text.substr(begin, end - begin));
        std::smatch match;
        if (std::regex_search(one, match, declared) && componentsNamed(match[2]).size() > 1) found.push_back(line);
        begin = end + 1;
    }
    return found;
}

} // namespace meltpool::test
