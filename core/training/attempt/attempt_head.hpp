// The head of an attempt: which lesson with which values, when and by which program. Recordings, CSV records, results,
// pages and lists all carry this one.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meltpool {

/// An empty text is unknown.
struct AttemptHead {
    std::string lesson;                                      ///< key
    std::string lessonFile;                                  ///< of a lesson outside of the catalogue; else empty
    std::string lessonHash;                                  ///< fileHash() of the lesson's file
    int attempt = 1;                                         ///< counted from the program's start
    std::string date;                                        ///< local time of its begin
    std::string utc;                                         ///< its begin, see utcText(); empty in old recordings
    std::string program;                                     ///< version and commit
    std::string driver;                                      ///< of the graphics: another may round otherwise
    std::vector<std::pair<std::string, std::string>> values; ///< of the metal and the process, at the start
    std::vector<std::string> chosen;                         ///< keys of values that the trainee chose
    bool arc = false;                                        ///< the metal has an arc
    bool rod = false;                                        ///< the process melts a filler rod
};

/// Lines `PREFIX WORD TEXT` of lesson, attempt, date, program and driver; an unknown text other than program and driver
/// has none.
void appendHeadLines(std::string& text, std::string_view prefix, const AttemptHead& head);
/// Lines `PREFIX value KEY TEXT` and `PREFIX chosen KEY`.
void appendStartValues(std::string& text, std::string_view prefix, const AttemptHead& head);

/// Takes one such line without its prefix, other than those of values; false where the word is none of a head's. Throws
/// InputError about the line alone where the attempt is no number.
bool readHeadLine(AttemptHead& head, std::string_view word, std::string_view text);

} // namespace meltpool
