#include "core/gl/shader_source.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace meltpool::gl {

namespace {

namespace fs = std::filesystem;

class Assembler {
  public:
    Assembler(fs::path root, const Defines& defines) : root_(std::move(root)), defines_(defines) {}

    void append(const fs::path& file) {
        const size_t number = source_.files.size();
        source_.files.push_back(file);
        std::istringstream lines(readTextFile(file));
        if (number > 0) appendLineMark(1, number);
        int lineNumber = 0;
        for (std::string line; std::getline(lines, line);) {
            ++lineNumber;
            const auto code = trimText(line);
            if (code.starts_with("#version")) {
                source_.text += line + "\n";
                for (const auto& [name, value] : defines_)
                    source_.text += "#define " + name + " " + value + "\n";
                appendLineMark(lineNumber + 1, number);
            } else if (code.starts_with("#extension GL_GOOGLE_include_directive")) {
                source_.text += "\n"; // only glslangValidator needs the line
            } else if (code.starts_with("#include <")) {
                source_.text += "\n"; // a C++ header in a shared header
            } else if (code.starts_with("#include")) {
                include(file, code, lineNumber);
                appendLineMark(lineNumber + 1, number);
            } else {
                source_.text += line + "\n";
            }
        }
    }

    ShaderSource take() { return std::move(source_); }

  private:
    void include(const fs::path& from, std::string_view code, int lineNumber) {
        const size_t open = code.find('"');
        const size_t close = code.rfind('"');
        if (open == std::string_view::npos || close <= open)
            throw InputError(from, lineNumber, "expected #include \"file\"");
        const fs::path name(code.substr(open + 1, close - open - 1));
        fs::path file = (from.parent_path() / name).lexically_normal();
        if (!fs::exists(file)) file = (root_ / name).lexically_normal();
        if (!fs::exists(file))
            throw InputError(from, lineNumber,
                             "the included file '" + name.string() +
                                 "' does not exist; expected it next to this file or in the folder shaders");
        const auto& files = source_.files;
        if (std::find(files.begin(), files.end(), file) == files.end()) append(file);
    }

    void appendLineMark(int line, size_t file) {
        source_.text += "#line " + std::to_string(line) + " " + std::to_string(file) + "\n";
    }

    fs::path root_;
    const Defines& defines_;
    ShaderSource source_;
};

} // namespace

ShaderSource loadShaderSource(const fs::path& root, const std::string& name, const Defines& defines) {
    Assembler assembler(root, defines);
    assembler.append((root / name).lexically_normal());
    return assembler.take();
}

std::string readableShaderLog(const ShaderSource& source, const std::string& log) {
    std::istringstream lines(log);
    std::string text;
    for (std::string line; std::getline(lines, line);) {
        size_t digits = 0;
        while (digits < line.size() && std::isdigit(static_cast<unsigned char>(line[digits])) != 0)
            ++digits;
        const bool marked = digits > 0 && digits < line.size() && (line[digits] == '(' || line[digits] == ':');
        const auto number = parseInteger(std::string_view(line).substr(0, digits));
        if (marked && number && static_cast<size_t>(*number) < source.files.size())
            line = source.files[static_cast<size_t>(*number)].string() + line.substr(digits);
        text += line + "\n";
    }
    return text;
}

} // namespace meltpool::gl
