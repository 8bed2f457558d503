// The head of an attempt names the lesson, its values, the time and the program. Recordings, CSV records, results,
// pages and lists all carry it.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meltpool {

/// An empty text means unknown.
struct AttemptHead {
    std::string lesson;                                      ///< key of the lesson
    std::string lessonFile;                                  ///< file of a lesson outside the catalogue; else empty
    std::string lessonHash;                                  ///< fileHash() of the lesson's file
    int attempt = 1;                                         ///< counted from the program's start
    std::string person;                                      ///< name of the person who welds; empty: not named
    std::string personId;                                    ///< equal for all attempts of this person
    std::string date;                                        ///< local time of the start
    std::string utc;                                         ///< start in UTC, see utcText(); empty in old recordings
    std::string program;                                     ///< version and commit
    std::string driver;                                      ///< graphics driver: another one may round differently
    std::vector<std::pair<std::string, std::string>> values; ///< values of metal and process at the start
    std::vector<std::string> chosen;                         ///< keys of values that the trainee chose
    bool arc = false;                                        ///< the metal has an arc
    bool rod = false;                                        ///< the process melts a filler rod
};

/// Appends lines `PREFIX WORD TEXT` for lesson, attempt, person, date, program and driver. Unknown texts get no line,
/// except program and driver.
void appendHeadLines(std::string& text, std::string_view prefix, const AttemptHead& head);
/// Appends lines `PREFIX value KEY TEXT` and `PREFIX chosen KEY`.
void appendStartValues(std::string& text, std::string_view prefix, const AttemptHead& head);

/// Reads one such line, without its prefix; lines of values are not read here. False if `word` is not a word of a head.
/// Throws InputError, naming the line alone, if the attempt is not a number.
bool readHeadLine(AttemptHead& head, std::string_view word, std::string_view text);

} // namespace meltpool
