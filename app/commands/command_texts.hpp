// Texts about every command, for --help and the manual page.
#pragma once

#include <array>
#include <string_view>

namespace meltpool {

struct NamedText {
    std::string_view name;
    std::string_view text;
};

inline constexpr std::array<NamedText, 3> kExitCodes{{
    {"0", "The command is done."},
    {"1",
     "Something failed on this machine, a check or validation case is not as expected, or a recording is damaged."},
    {"2", "The input is wrong; one sentence names the file, the line and what was expected."},
}};

inline constexpr std::array<NamedText, 6> kVariables{{
    {"MELTPOOL_LANGUAGE",
     "Language of the program, such as de; else the system's if there is a file for it, else English"},
    {"MELTPOOL_LESSONS", "Folder of a school's lessons"},
    {"MELTPOOL_DATA", "Folder of the program's shaders and data, if they are not next to the program"},
    {"XDG_CONFIG_HOME", "Settings and best scores are in its folder meltpool; else in ~/.config/meltpool"},
    {"XDG_DATA_HOME",
     "Recordings, pages, persons and own lessons are in its folder meltpool; else in ~/.local/share/meltpool"},
    {"XDG_CACHE_HOME", "Compiled shaders are in its folder meltpool; else in ~/.cache/meltpool"},
}};

/// Command lines for a start, each with its result.
inline constexpr std::array<NamedText, 6> kExamples{{
    {"meltpool --lesson gmaw-bead", "Open the trainer's window on the first weld."},
    {"meltpool run tee-fillet --out fillet --pictures 1",
     "Weld the demonstration of a lesson without a screen, with a picture each second, into the folder fillet."},
    {"meltpool run gmaw-bead --out slow --torch path.csv --set voltage=22",
     "Weld your own torch path with another voltage."},
    {"meltpool lessons gmaw-bead", "List the values that --set takes."},
    {"meltpool replay weld.meltrec --out faster --what-if speed=1.2",
     "Weld a recorded attempt again, then a fifth faster, and compare both."},
    {"meltpool recordings --csv class.csv", "Write all attempts with their scores into one table."},
}};

} // namespace meltpool
