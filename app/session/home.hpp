// The home page that window and headset share: the lessons, the chosen one, the best scores.
#pragma once

#include "app/library/best_scores.hpp"
#include "app/library/lesson_catalogue.hpp"
#include "app/library/lesson_pictures.hpp"
#include "app/library/replay_list.hpp"
#include "app/session/who_welds.hpp"
#include "core/training/lesson/lesson.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool {

class Home {
  public:
    /// Reads the lessons. `scores`: the account's file of best scores. `persons`: folder of the persons, see Persons.
    /// Throws InputError when the shipped lessons cannot be read.
    Home(LessonFolders lessons, const std::filesystem::path& scores, const std::filesystem::path& persons = {});

    bool open = false; ///< true: the page is shown instead of a lesson

    const std::vector<CataloguedLesson>& lessons() const { return lessons_; }
    /// Reads the lessons again, because files may have changed; the choice stays if its lesson does.
    void refresh();
    /// One sentence for each folder of lessons that cannot be read.
    const std::vector<std::string>& faults() const { return faults_; }

    /// Lessons below one heading; no group is empty.
    struct Group {
        LessonOrigin origin;
        size_t begin, end; ///< range in lessons()
    };
    std::vector<Group> groups() const;
    /// Lesson of a key; null if the catalogue has none.
    const CataloguedLesson* find(std::string_view key) const;
    /// Catalogue's entry of a lesson; null if it was read from a file elsewhere.
    const CataloguedLesson* find(const Lesson& lesson) const;

    /// Lesson that a request to open one means; the first at first.
    const CataloguedLesson& chosen() const { return lessons_[chosen_]; }
    size_t chosenIndex() const { return chosen_; }
    void choose(size_t index);
    void choose(std::string_view key);
    /// Moves the choice by places to the right and rows down in a page of `columns` columns, like the arrow keys. Each
    /// group begins a row.
    void move(int right, int down);
    size_t columns = 1; ///< columns of the window's page as last drawn
    size_t page = 0;    ///< page of the headset's list
    /// Returns true once after move(), so that the page scrolls to the chosen lesson.
    bool takeMoved();

    /// Line below a lesson's title: "Level 2 of 5 · Best 84, accepted".
    std::string standing(const CataloguedLesson& lesson) const;

    WhoWelds who;
    /// Reads the best scores of who.welder(): the person's, the account's, or none for a guest.
    void takeScores();
    BestScores scores; ///< of the person who welds
    LessonPictures pictures;
    ReplayList attempts;

  private:
    /// Index one row further, in this column or at the row's end; `index` itself if there is no such row.
    size_t rowBeyond(size_t index, int down) const;

    std::filesystem::path accountScores_;
    LessonFolders folders_;
    std::vector<std::string> faults_;
    std::vector<CataloguedLesson> lessons_;
    size_t chosen_ = 0;
    bool moved_ = false;
};

} // namespace meltpool
