// Changes variables of the environment while a test runs.
#pragma once

#include <cstdlib>
#include <string>

namespace meltpool::test {

/// Gives the variable this value, or unsets it if null, during its lifetime. Linux only.
class EnvironmentChange {
  public:
    EnvironmentChange(const char* name, const char* value) : name_(name) {
        const char* before = std::getenv(name);
        wasSet_ = before != nullptr;
        if (wasSet_) before_ = before;
        set(value);
    }
    ~EnvironmentChange() { set(wasSet_ ? before_.c_str() : nullptr); }
    EnvironmentChange(const EnvironmentChange&) = delete;
    EnvironmentChange& operator=(const EnvironmentChange&) = delete;

  private:
    void set(const char* value) const {
        if (value == nullptr)
            unsetenv(name_);
        else
            setenv(name_, value, 1);
    }

    const char* name_;
    bool wasSet_ = false;
    std::string before_;
};

} // namespace meltpool::test
