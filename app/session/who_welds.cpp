#include "app/session/who_welds.hpp"

#include "core/base/text.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <exception>

namespace meltpool {

std::string WhoWelds::name() const {
    if (welder_.kind == AttemptOwner::Kind::guest) return phrase("persons.guest");
    return welder_.person.name;
}

void WhoWelds::ask() {
    persons_.refresh();
    asked_ = opened_ = true;
    page = 0;
    refusal_.clear();
    typed.fill(0);
    const auto& all = persons_.all();
    const auto offered =
        std::find_if(all.begin(), all.end(), [&](const KnownPerson& p) { return p.id != welder_.person.id; });
    if (offered != all.end())
        std::copy_n(offered->name.begin(), std::min(offered->name.size(), typed.size() - 1), typed.begin());
}

bool WhoWelds::takeTyped() {
    const std::string_view name = trimText(typed.data());
    if (!name.empty()) return take(name);
    takeAccount();
    return true;
}

bool WhoWelds::take(std::string_view name) {
    if (sameName(trimText(name), phrase("persons.guest"))) {
        takeGuest();
        return true;
    }
    try {
        answer({AttemptOwner::Kind::person, persons_.signIn(name)});
        return true;
    } catch (const std::exception& fault) {
        refusal_ = fault.what();
        return false;
    }
}

void WhoWelds::takePerson(std::size_t index) {
    take(std::string(persons_.all()[index].name)); // a copy: signing in reads the list again
}

void WhoWelds::answer(AttemptOwner welder) {
    welder_ = std::move(welder);
    asked_ = false;
    refusal_.clear();
}

} // namespace meltpool
