#include "app/session/home.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace meltpool {

Home::Home(LessonFolders lessons, const std::filesystem::path& scoresFile, const std::filesystem::path& persons)
    : who(persons),
      scores(scoresFile),
      accountScores_(scoresFile),
      folders_(std::move(lessons)),
      lessons_(readCatalogue(folders_, faults_)) {
    if (lessons_.empty())
        throw InputError(folders_.folders().front().path, 0, "holds no lesson; expected files that end in .toml");
    choose(size_t(0));
}

void Home::refresh() {
    const std::string key = chosen().key;
    faults_.clear();
    std::vector<CataloguedLesson> fresh = readCatalogue(folders_, faults_);
    if (fresh.empty()) return;
    lessons_ = std::move(fresh);
    choose(chosen_); // the list may have become shorter
    choose(key);
}

void Home::takeScores() {
    switch (who.welder().kind) {
    case AttemptOwner::Kind::account:
        scores = BestScores(accountScores_);
        break;
    case AttemptOwner::Kind::person:
        scores = BestScores(who.persons().scoresFile(who.welder().person));
        break;
    case AttemptOwner::Kind::guest:
        scores = BestScores();
        break;
    }
}

std::vector<Home::Group> Home::groups() const {
    std::vector<Group> groups;
    for (size_t i = 0; i < lessons_.size(); ++i) {
        if (groups.empty() || groups.back().origin != lessons_[i].origin) groups.push_back({lessons_[i].origin, i, i});
        groups.back().end = i + 1;
    }
    return groups;
}

const CataloguedLesson* Home::find(std::string_view key) const {
    const auto found =
        std::find_if(lessons_.begin(), lessons_.end(), [&](const CataloguedLesson& l) { return l.key == key; });
    return found == lessons_.end() ? nullptr : &*found;
}

const CataloguedLesson* Home::find(const Lesson& lesson) const {
    const CataloguedLesson* known = find(lesson.key);
    if (known == nullptr) return nullptr;
    std::error_code missing;
    return known->file == lesson.file || std::filesystem::equivalent(known->file, lesson.file, missing) ? known
                                                                                                        : nullptr;
}

void Home::choose(size_t index) {
    chosen_ = std::min(index, lessons_.size() - 1);
}

void Home::choose(std::string_view key) {
    if (const CataloguedLesson* lesson = find(key)) choose(static_cast<size_t>(lesson - lessons_.data()));
}

size_t Home::rowBeyond(size_t index, int down) const {
    const std::vector<Group> all = groups();
    const auto own = std::find_if(all.begin(), all.end(), [&](const Group& group) { return index < group.end; });
    const size_t column = (index - own->begin) % columns;
    const size_t row = index - column;
    if (down > 0) {
        if (row + columns < own->end) return std::min(index + columns, own->end - 1);
        if (own + 1 == all.end()) return own->end - 1;
        const Group& following = own[1];
        return std::min(following.begin + column, following.end - 1);
    }
    if (row >= own->begin + columns) return index - columns;
    if (own == all.begin()) return index;
    const Group& before = own[-1];
    const size_t lastRow = before.end - 1 - (before.end - 1 - before.begin) % columns;
    return std::min(lastRow + column, before.end - 1);
}

void Home::move(int right, int down) {
    const size_t before = chosen_;
    size_t place = before;
    for (int i = 0; i < std::abs(down); ++i)
        place = rowBeyond(place, down);
    const auto last = static_cast<int>(lessons_.size()) - 1;
    chosen_ = static_cast<size_t>(std::clamp(static_cast<int>(place) + right, 0, last));
    moved_ = moved_ || chosen_ != before;
}

bool Home::takeMoved() {
    return std::exchange(moved_, false);
}

std::string Home::standing(const CataloguedLesson& lesson) const {
    std::string text = levelText(lesson.level);
    for (const BestScore* best : {scores.find(lesson.key), scores.findTest(lesson.key)})
        if (best != nullptr) text += (text.empty() ? "" : " \xC2\xB7 ") + bestScoreText(*best);
    return text;
}

} // namespace meltpool
