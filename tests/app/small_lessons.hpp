// Lessons of the catalogue on workpieces so small that a session welds them within seconds.
#pragma once

#include "core/training/lesson/lesson.hpp"
#include "tests/support/gl_fixture.hpp"

namespace meltpool::test {

inline std::filesystem::path shippedLessons() {
    return testFolder().parent_path() / "app" / "data" / "lessons";
}

/// Returns a bead on a plate of 30 x 18 mm, judged over 20 mm; its demonstration goes from -36 to 36 mm at 8 mm/s and
/// pushes 10 degrees.
inline Lesson smallBead() {
    Lesson lesson = findLesson("gmaw-bead", shippedLessons());
    lesson.workpiece.lengthMm = 30;
    lesson.workpiece.widthMm = 18;
    lesson.workpiece.thicknessMm = 4;
    lesson.technique->lengthFromMm = -10;
    lesson.technique->lengthToMm = 10;
    lesson.surface.cells = 32;
    return lesson;
}

/// Returns a bead on a plate of 24 x 14 mm, without values to choose.
inline Lesson plainBead() {
    Lesson lesson = findLesson("gmaw-bead", shippedLessons());
    lesson.choose.clear();
    lesson.workpiece.lengthMm = 24;
    lesson.workpiece.widthMm = 14;
    lesson.workpiece.thicknessMm = 4;
    lesson.surface.cells = 24;
    return lesson;
}

} // namespace meltpool::test
