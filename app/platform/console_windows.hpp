// The console that Windows starts the program from, and the words it was started with.
#pragma once

#include <string>
#include <vector>

namespace meltpool {

/// While it lives the console shows UTF-8 and understands the signs that move the cursor.
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

/// The program's words as UTF-8, the program's own name first.
std::vector<std::string> commandLineWords();

} // namespace meltpool
