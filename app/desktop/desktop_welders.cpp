#include "app/desktop/desktop_welders.hpp"

#include <utility>

namespace meltpool {

void DesktopWelders::enter(double now) {
    const AttemptOwner& welder = home_.who.welder();
    std::vector<std::string> faults = settings_.leave();
    const auto add = [&](const std::vector<std::string>& more) {
        faults.insert(faults.end(), more.begin(), more.end());
    };
    if (welder.kind == AttemptOwner::Kind::person)
        add(settings_.enter(home_.who.persons().settingsFile(welder.person)));
    else if (welder.kind == AttemptOwner::Kind::guest)
        add(settings_.enter({}));
    home_.takeScores();
    add(home_.scores.faults());
    session_.attempt().cues().setSkill({});
    session_.log().weldedBy(welder);
    for (std::string& fault : faults)
        messages_.warn(std::move(fault), now);
}

} // namespace meltpool
