// GLSL programs, and the library that loads them by file name and reloads changed ones while the program runs.
#pragma once

#include "core/gl/handle.hpp"
#include "core/gl/shader_source.hpp"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace meltpool::gl {

/// Direct and indirect dispatches issued by this thread so far. Callers compare two readings.
std::uint64_t dispatchCount();

class Program {
  public:
    GLuint name() const { return handle_.name(); }
    void use() const { glUseProgram(name()); }

    /// Runs a compute program with enough groups of `groupSize` for `count` invocations; none for 0. Counts beyond one
    /// dispatch dimension are folded into y: shaders take their index from `linearInvocation()` in
    /// shaders/shared/dispatch.h.
    void dispatch(size_t count, unsigned groupSize) const;
    void dispatchGroups(unsigned x, unsigned y = 1, unsigned z = 1) const;
    /// Runs a compute program with the group counts at byte `offset` of the bound GL_DISPATCH_INDIRECT_BUFFER.
    void dispatchIndirect(size_t offset) const;

    /// Sets a uniform outside of blocks by name; ignores names that the compiler removed.
    void set(const char* uniform, int value) const { glProgramUniform1i(name(), find(uniform), value); }
    void set(const char* uniform, unsigned value) const { glProgramUniform1ui(name(), find(uniform), value); }
    void set(const char* uniform, float value) const { glProgramUniform1f(name(), find(uniform), value); }
    void set(const char* uniform, glm::vec2 v) const { glProgramUniform2f(name(), find(uniform), v.x, v.y); }
    void set(const char* uniform, glm::vec3 v) const { glProgramUniform3f(name(), find(uniform), v.x, v.y, v.z); }
    void set(const char* uniform, glm::vec4 v) const { glProgramUniform4f(name(), find(uniform), v.x, v.y, v.z, v.w); }
    void set(const char* uniform, const glm::mat4& m) const {
        glProgramUniformMatrix4fv(name(), find(uniform), 1, GL_FALSE, &m[0][0]);
    }

  private:
    friend class ShaderLibrary;
    /// Locations are read once after linking: frames set hundreds of uniforms.
    struct Uniform {
        std::string name;
        GLint location = -1;
    };
    void listUniforms();
    GLint find(const char* uniform) const;
    static void destroy(GLuint name) { glDeleteProgram(name); }
    Handle<destroy> handle_;
    std::vector<Uniform> uniforms_;
};

/// Loads programs from a shader folder. The library owns the programs for its lifetime; a reload replaces their
/// content.
class ShaderLibrary {
  public:
    explicit ShaderLibrary(std::filesystem::path root) : root_(std::move(root)) {}

    /// Loads a program from files relative to the root; the stage follows from the ending (.comp, .vert, .frag, .geom).
    /// Throws InputError if one does not compile or link, or has a block with another layout than its C++ struct.
    const Program& load(std::vector<std::string> files, Defines defines = {});
    const Program& compute(std::string file, Defines defines = {}) {
        return load({std::move(file)}, std::move(defines));
    }

    /// Rebuilds the programs of which a file changed. A failed one continues with its old version. Returns the messages
    /// of the failed ones.
    std::vector<std::string> reloadChanged();

    /// The messages of all programs that still run an old version because their files do not build.
    std::vector<std::string> standingFaults() const;

    const std::filesystem::path& root() const { return root_; }

  private:
    struct Entry {
        std::vector<std::string> files;
        Defines defines;
        Program program;
        std::vector<std::filesystem::path> sources;
        std::filesystem::file_time_type newest;
        std::string fault; ///< message of the last reload; empty: it succeeded
    };

    void build(Entry& entry) const;

    std::filesystem::path root_;
    std::vector<std::unique_ptr<Entry>> entries_;
};

} // namespace meltpool::gl
