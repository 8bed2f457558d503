#include "core/gl/program.hpp"

#include "core/base/error.hpp"
#include "core/gl/block_layout.hpp"
#include "core/gl/order.hpp"

#include <algorithm>

namespace meltpool::gl {

namespace {

namespace fs = std::filesystem;

/// Counted per thread: a context is current on one thread.
thread_local std::uint64_t dispatches = 0;

void deleteShader(GLuint name) {
    glDeleteShader(name);
}
using Shader = Handle<deleteShader>;

GLenum stageOf(const std::string& file) {
    const std::string ending = fs::path(file).extension().string();
    if (ending == ".comp") return GL_COMPUTE_SHADER;
    if (ending == ".vert") return GL_VERTEX_SHADER;
    if (ending == ".frag") return GL_FRAGMENT_SHADER;
    if (ending == ".geom") return GL_GEOMETRY_SHADER;
    throw InputError(file, 0, "is not a shader; expected the ending .comp, .vert, .frag or .geom");
}

std::string compileLog(GLuint shader) {
    GLint length = 0;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<size_t>(std::max(length, 1)), '\0');
    glGetShaderInfoLog(shader, length, nullptr, log.data());
    return log.c_str();
}

std::string linkLog(GLuint program) {
    GLint length = 0;
    glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<size_t>(std::max(length, 1)), '\0');
    glGetProgramInfoLog(program, length, nullptr, log.data());
    return log.c_str();
}

Shader compile(const std::string& file, const ShaderSource& source) {
    Shader shader(glCreateShader(stageOf(file)));
    const char* text = source.text.c_str();
    glShaderSource(shader.name(), 1, &text, nullptr);
    glCompileShader(shader.name());
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_FALSE)
        throw InputError(source.files.front(), 0,
                         "the shader does not compile: " + readableShaderLog(source, compileLog(shader.name())));
    return shader;
}

/// Throws InputError if a block of the linked `program` that the stage `source` declares has a layout other than the
/// one here.
void checkBlocks(GLuint program, const ShaderSource& source) {
    for (const BlockDeclaration& block : findBlocks(source.text)) {
        const std::string difference = blockDifference(program, block, sharedStructs());
        if (!difference.empty())
            throw InputError(source.files.front(), 0,
                             difference +
                                 "; the shaders belong to another version of the program: install it again, or "
                                 "set MELTPOOL_DATA to the folder that belongs to this version");
    }
}

fs::file_time_type newestTime(const std::vector<fs::path>& files) {
    fs::file_time_type newest = fs::file_time_type::min();
    std::error_code missing; // a file may be missing for a moment during saving
    for (const fs::path& file : files) {
        const auto time = fs::last_write_time(file, missing);
        if (!missing) newest = std::max(newest, time);
    }
    return newest;
}

} // namespace

void Program::listUniforms() {
    GLint count = 0, longest = 0;
    glGetProgramiv(name(), GL_ACTIVE_UNIFORMS, &count);
    glGetProgramiv(name(), GL_ACTIVE_UNIFORM_MAX_LENGTH, &longest);
    std::string text(static_cast<size_t>(longest) + 1, '\0');
    for (GLint i = 0; i < count; ++i) {
        GLint size = 0;
        GLenum type = GL_NONE;
        glGetActiveUniform(name(), static_cast<GLuint>(i), longest + 1, nullptr, &size, &type, text.data());
        Uniform uniform{text.c_str(), glGetUniformLocation(name(), text.c_str())};
        if (uniform.name.ends_with("[0]")) uniform.name.resize(uniform.name.size() - 3);
        if (uniform.location >= 0) uniforms_.push_back(std::move(uniform)); // others belong to a block
    }
}

GLint Program::find(const char* uniform) const {
    for (const Uniform& known : uniforms_)
        if (known.name == uniform) return known.location;
    return -1;
}

std::uint64_t dispatchCount() {
    return dispatches;
}

void Program::dispatchGroups(unsigned x, unsigned y, unsigned z) const {
    use();
    ++dispatches;
    glDispatchCompute(x, y, z);
}

void Program::dispatchIndirect(size_t offset) const {
    use();
    ++dispatches;
    gl::dispatchIndirect(offset);
}

void Program::dispatch(size_t count, unsigned groupSize) const {
    if (count == 0) return;
    constexpr size_t kMostGroupsPerAxis = 65535; // the minimum that OpenGL guarantees
    const size_t groups = (count + groupSize - 1) / groupSize;
    const size_t rows = (groups + kMostGroupsPerAxis - 1) / kMostGroupsPerAxis;
    const size_t perRow = (groups + rows - 1) / rows;
    dispatchGroups(static_cast<unsigned>(perRow), static_cast<unsigned>(rows));
}

const Program& ShaderLibrary::load(std::vector<std::string> files, Defines defines) {
    for (const auto& entry : entries_)
        if (entry->files == files && entry->defines == defines) return entry->program;
    auto entry = std::make_unique<Entry>();
    entry->files = std::move(files);
    entry->defines = std::move(defines);
    build(*entry);
    entries_.push_back(std::move(entry));
    return entries_.back()->program;
}

std::vector<std::string> ShaderLibrary::reloadChanged() {
    std::vector<std::string> failures;
    for (const auto& entry : entries_) {
        const auto newest = newestTime(entry->sources);
        if (newest <= entry->newest) continue;
        entry->newest = newest;
        entry->fault.clear();
        try {
            build(*entry);
        } catch (const InputError& error) {
            entry->fault = error.what();
            failures.push_back(entry->fault);
        }
    }
    return failures;
}

std::vector<std::string> ShaderLibrary::standingFaults() const {
    std::vector<std::string> faults;
    for (const auto& entry : entries_)
        if (!entry->fault.empty()) faults.push_back(entry->fault);
    return faults;
}

void ShaderLibrary::build(Entry& entry) const {
    std::vector<Shader> stages;
    std::vector<ShaderSource> sources;
    for (const std::string& file : entry.files) {
        sources.push_back(loadShaderSource(root_, file, entry.defines));
        stages.push_back(compile(file, sources.back()));
    }
    Program program;
    program.handle_ = Handle<Program::destroy>(glCreateProgram());
    for (const Shader& stage : stages)
        glAttachShader(program.name(), stage.name());
    glLinkProgram(program.name());
    for (const Shader& stage : stages)
        glDetachShader(program.name(), stage.name());
    GLint linked = GL_FALSE;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
    if (linked == GL_FALSE)
        throw InputError(root_ / entry.files.front(), 0,
                         "the shader program does not link: " + linkLog(program.name()));
    for (const ShaderSource& source : sources)
        checkBlocks(program.name(), source);
    program.listUniforms();
    labelObject(GL_PROGRAM, program.name(), entry.files.back());
    entry.program = std::move(program);
    entry.sources.clear();
    for (const ShaderSource& source : sources)
        entry.sources.insert(entry.sources.end(), source.files.begin(), source.files.end());
    entry.newest = newestTime(entry.sources);
}

} // namespace meltpool::gl
