// The console that Windows starts the program from, and the words of its command line.
#pragma once

#include <string>
#include <vector>

namespace meltpool {

/// Console that shows UTF-8 and understands cursor sequences during this object's lifetime.
class Utf8Console {
  public:
    Utf8Console();
    ~Utf8Console();
    Utf8Console(const Utf8Console&) = delete;
    Utf8Console& operator=(const Utf8Console&) = delete;

  private:
    unsigned codePage_ = 0;
    unsigned long errorMode_ = 0;
    bool errorIsConsole_ = false;
};

/// Words of the command line as UTF-8, the program's own name first.
std::vector<std::string> commandLineWords();

} // namespace meltpool
