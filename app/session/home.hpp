// The home page that window and headset share: which lessons there are, which one is chosen, the best scores.
#pragma once

#include "app/library/best_scores.hpp"
#include "app/library/lesson_catalogue.hpp"
#include "app/library/lesson_pictures.hpp"
#include "app/library/replay_list.hpp"
#include "core/training/lesson/lesson.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool {

class Home {
  public:
    /// `scores`: the file of best scores. Throws InputError where the shipped lessons cannot be read.
    Home(LessonFolders lessons, const std::filesystem::path& scores);

    bool open = false; ///< the page is shown instead of a lesson

    const std::vector<CataloguedLesson>& lessons() const { return lessons_; }
    /// Reads the lessons again, which somebody may have changed meanwhile; the choice stays where it can.
    void refresh();
    /// A sentence for each folder of lessons that cannot be read.
    const std::vector<std::string>& faults() const { return faults_; }

    /// Lessons that stand together below a heading; none is empty.
    struct Group {
        LessonOrigin origin;
        size_t begin, end; ///< in lessons()
    };
    std::vector<Group> groups() const;
    /// Null where the catalogue has no such lesson.
    const CataloguedLesson* find(std::string_view key) const;
    /// The same of a lesson that was read; null for one from a file elsewhere.
    const CataloguedLesson* find(const Lesson& lesson) const;

    /// The lesson that a request to open one means; the default lesson at first.
    const CataloguedLesson& chosen() const { return lessons_[chosen_]; }
    size_t chosenIndex() const { return chosen_; }
    void choose(size_t index);
    void choose(std::string_view key);
    /// Moves the choice by places to the right and rows down in a page of `columns` columns, as the arrow keys do. Each
    /// group begins a row.
    void move(int right, int down);
    size_t columns = 1; ///< of the window's page as last drawn
    size_t page = 0;    ///< of the headset's list
    /// True once after move(): the page brings the chosen lesson in sight.
    bool takeMoved();

    /// "Level 2 of 5 · Best 84, accepted": what stands below a lesson's title.
    std::string standing(const CataloguedLesson& lesson) const;

    BestScores scores;
    LessonPictures pictures;
    ReplayList attempts;

  private:
    /// The index a row further, at the same column or the row's end; the same index where there is no such row.
    size_t rowBeyond(size_t index, int down) const;

    LessonFolders folders_;
    std::vector<std::string> faults_;
    std::vector<CataloguedLesson> lessons_;
    size_t chosen_ = 0;
    bool moved_ = false;
};

} // namespace meltpool
