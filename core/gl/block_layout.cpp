#include "core/gl/block_layout.hpp"

#include "core/base/text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

namespace meltpool::gl {

namespace {

/// Reads GLSL word by word; blanks and line comments separate words.
class WordReader {
  public:
    WordReader(std::string_view text, size_t at) : text_(text), at_(at) {}

    /// The next identifier; empty if something else follows.
    std::string_view identifier() {
        skipBlanks();
        const size_t begin = at_;
        while (at_ < text_.size() && isLetter(text_[at_]))
            ++at_;
        return text_.substr(begin, at_ - begin);
    }

    bool take(char sign) {
        skipBlanks();
        if (at_ == text_.size() || text_[at_] != sign) return false;
        ++at_;
        return true;
    }

    /// Skips up to and including `sign`.
    void skipTo(char sign) { at_ = std::min(text_.find(sign, at_), text_.size() - 1) + 1; }

    static bool isLetter(char letter) { return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_'; }

  private:
    void skipBlanks() {
        while (at_ < text_.size()) {
            if (text_.compare(at_, 2, "//") == 0)
                skipTo('\n');
            else if (std::isspace(static_cast<unsigned char>(text_[at_])) != 0)
                ++at_;
            else
                return;
        }
    }

    std::string_view text_;
    size_t at_;
};

/// The block whose keyword ends at byte `at`.
std::optional<BlockDeclaration> blockAt(std::string_view glsl, size_t at, bool storage) {
    WordReader reader(glsl, at);
    BlockDeclaration block;
    block.storage = storage;
    block.name = reader.identifier();
    if (block.name.empty() || !reader.take('{')) return std::nullopt;
    block.type = reader.identifier();
    block.variable = reader.identifier();
    if (storage && reader.take('[')) reader.skipTo(']');
    if (block.variable.empty() || !reader.take(';') || !reader.take('}') || !reader.take(';')) return std::nullopt;
    return block;
}

/// True if a `//` precedes byte `at` on its line.
bool inComment(std::string_view glsl, size_t at) {
    const std::string_view before = glsl.substr(0, at);
    return before.substr(before.rfind('\n') + 1).find("//") != std::string_view::npos;
}

void findBlocksOf(std::string_view glsl, std::string_view keyword, bool storage, std::vector<BlockDeclaration>& found) {
    for (size_t at = glsl.find(keyword); at != std::string_view::npos; at = glsl.find(keyword, at + 1)) {
        if ((at > 0 && WordReader::isLetter(glsl[at - 1])) || inComment(glsl, at)) continue;
        if (std::optional<BlockDeclaration> block = blockAt(glsl, at + keyword.size(), storage))
            found.push_back(std::move(*block));
    }
}

const SharedStruct* findStruct(std::span<const SharedStruct> known, std::string_view name) {
    const auto found = std::find_if(known.begin(), known.end(), [&](const SharedStruct& s) { return s.name == name; });
    return found == known.end() ? nullptr : &*found;
}

/// A step in OpenGL's name of a variable: "views[1].eye" is member "views", element 1, then "eye".
struct NameStep {
    std::string_view member;
    size_t element = 0;
    std::string_view rest;
};

NameStep firstStep(std::string_view path) {
    const size_t dot = std::min(path.find('.'), path.size());
    NameStep step{path.substr(0, dot), 0, path.substr(std::min(dot + 1, path.size()))};
    const size_t bracket = step.member.find('[');
    if (bracket == std::string_view::npos) return step;
    const size_t digits = step.member.find(']') - bracket - 1;
    step.element = static_cast<size_t>(parseInteger(step.member.substr(bracket + 1, digits)).value_or(0));
    step.member = step.member.substr(0, bracket);
    return step;
}

/// The byte in the C++ struct `within` of the member that OpenGL calls `path`; none if there is no such member.
std::optional<size_t> placeOf(std::string_view path, const SharedStruct* within, std::span<const SharedStruct> known) {
    size_t place = 0;
    while (within != nullptr) {
        const NameStep step = firstStep(path);
        const auto member = std::find_if(within->members.begin(), within->members.end(),
                                         [&](const SharedMember& m) { return m.name == step.member; });
        if (member == within->members.end()) return std::nullopt;
        place += member->offset + step.element * member->bytes;
        if (step.rest.empty()) return place;
        within = findStruct(known, member->type);
        path = step.rest;
    }
    return std::nullopt;
}

/// A block of a linked program, as OpenGL describes it.
class LinkedBlock {
  public:
    LinkedBlock(GLuint program, const BlockDeclaration& block)
        : program_(program),
          blocks_(block.storage ? GL_SHADER_STORAGE_BLOCK : GL_UNIFORM_BLOCK),
          variables_(block.storage ? GL_BUFFER_VARIABLE : GL_UNIFORM),
          index_(glGetProgramResourceIndex(program, blocks_, block.name.c_str())) {}

    bool used() const { return index_ != GL_INVALID_INDEX; }
    size_t bytes() const { return static_cast<size_t>(property(blocks_, index_, GL_BUFFER_DATA_SIZE)); }

    std::vector<GLint> variables() const {
        std::vector<GLint> all(static_cast<size_t>(property(blocks_, index_, GL_NUM_ACTIVE_VARIABLES)));
        const GLenum what = GL_ACTIVE_VARIABLES;
        glGetProgramResourceiv(program_, blocks_, index_, 1, &what, static_cast<GLsizei>(all.size()), nullptr,
                               all.data());
        return all;
    }
    std::string nameOf(GLint variable) const {
        std::array<char, 256> name{}; // names of our own are far shorter
        glGetProgramResourceName(program_, variables_, static_cast<GLuint>(variable), static_cast<GLsizei>(name.size()),
                                 nullptr, name.data());
        return name.data();
    }
    size_t offsetOf(GLint variable) const { return ofVariable(variable, GL_OFFSET); }
    /// Bytes between elements of the storage block's array; 0: it holds no array.
    size_t strideOf(GLint variable) const {
        return variables_ == GL_UNIFORM ? 0 : ofVariable(variable, GL_TOP_LEVEL_ARRAY_STRIDE);
    }

  private:
    size_t ofVariable(GLint variable, GLenum what) const {
        return static_cast<size_t>(property(variables_, static_cast<GLuint>(variable), what));
    }
    GLint property(GLenum interface_, GLuint index, GLenum what) const {
        GLint value = 0;
        glGetProgramResourceiv(program_, interface_, index, 1, &what, 1, nullptr, &value);
        return value;
    }

    GLuint program_;
    GLenum blocks_, variables_;
    GLuint index_;
};

/// Compares sizes: drivers count the bytes of a block up to its last member, or whole vectors of 16.
bool sameSize(size_t counted, size_t bytes) {
    return counted >= bytes && counted <= (bytes + 15) / 16 * 16;
}

std::string byteCounts(size_t here, size_t inProgram, const char* each) {
    return " has " + std::to_string(here) + " bytes" + each + ", but " + std::to_string(inProgram) + " in this program";
}

} // namespace

std::vector<BlockDeclaration> findBlocks(std::string_view glsl) {
    std::vector<BlockDeclaration> found;
    findBlocksOf(glsl, "uniform", false, found);
    findBlocksOf(glsl, "buffer", true, found);
    return found;
}

std::string blockDifference(GLuint program, const BlockDeclaration& block, std::span<const SharedStruct> known) {
    const SharedStruct* expected = findStruct(known, block.type);
    if (expected == nullptr) return {};
    const LinkedBlock linked(program, block);
    if (!linked.used()) return {};
    const std::vector<GLint> variables = linked.variables();
    if (variables.empty()) return {};
    const std::string named = "block '" + block.name + "' (struct " + block.type + ")";
    if (const size_t stride = linked.strideOf(variables.front()); stride != 0) {
        if (stride != expected->bytes) return named + byteCounts(stride, expected->bytes, " an element");
    } else if (!sameSize(linked.bytes(), expected->bytes)) {
        return named + byteCounts(linked.bytes(), expected->bytes, "");
    }
    for (const GLint variable : variables) {
        const std::string name = linked.nameOf(variable);
        const std::string_view member = firstStep(name).rest;
        const auto place = placeOf(member, expected, known);
        if (!place) return named + " has a member '" + std::string(member) + "' that this program does not know";
        const size_t offset = linked.offsetOf(variable);
        if (offset != *place)
            return named + " has '" + std::string(member) + "' at byte " + std::to_string(offset) + ", but at byte " +
                   std::to_string(*place) + " in this program";
    }
    return {};
}

} // namespace meltpool::gl
