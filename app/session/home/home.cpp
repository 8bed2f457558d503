#include "app/session/home/home.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <utility>

namespace meltpool {

Home::Home(const std::filesystem::path& lessons, const std::filesystem::path& scoresFile)
    : scores(scoresFile), lessons_(readCatalogue(lessons)) {
    if (lessons_.empty()) throw InputError(lessons, 0, "holds no lesson; expected files that end in .toml");
    choose(kDefaultLesson);
}

const CataloguedLesson* Home::find(std::string_view key) const {
    const auto found =
        std::find_if(lessons_.begin(), lessons_.end(), [&](const CataloguedLesson& l) { return l.key == key; });
    return found == lessons_.end() ? nullptr : &*found;
}

const CataloguedLesson* Home::find(const Lesson& lesson) const {
    const CataloguedLesson* known = find(lesson.key);
    return known != nullptr && known->file == lesson.file ? known : nullptr;
}

void Home::choose(size_t index) {
    chosen_ = std::min(index, lessons_.size() - 1);
}

void Home::choose(std::string_view key) {
    if (const CataloguedLesson* lesson = find(key)) choose(static_cast<size_t>(lesson - lessons_.data()));
}

void Home::move(int right, int down) {
    const auto last = static_cast<int>(lessons_.size()) - 1;
    const auto before = static_cast<int>(chosen_);
    const int row = before + down * static_cast<int>(columns);
    const int place = std::clamp((row < 0 ? before : row) + right, 0, last);
    chosen_ = static_cast<size_t>(place);
    moved_ = moved_ || place != before;
}

bool Home::takeMoved() {
    return std::exchange(moved_, false);
}

std::string Home::standing(const CataloguedLesson& lesson) const {
    std::string text = levelText(lesson.level);
    if (const BestScore* best = scores.find(lesson.key))
        text += (text.empty() ? "" : " \xC2\xB7 ") + bestScoreText(*best);
    return text;
}

} // namespace meltpool
