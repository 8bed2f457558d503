#include "app/desktop/desktop_sound.hpp"

namespace meltpool {

namespace {

constexpr int kChips = 3; ///< strokes of the chipping hammer

} // namespace

void DesktopSound::update(LessonSession& session, const Controls& controls, const WindowHeadset* headset) {
    std::optional<glm::vec3> place = headset != nullptr ? headset->arcFromHead(session) : std::nullopt;
    if (!place)
        if (const auto seen = session.picture().arcFrom(controls.view(1).worldToEye))
            place = SoundOutput::atDesk(*seen);
    output_.update(session.sound().parameters.volume, place.value_or(glm::vec3(0, 0, -1)));
    if (told_ || !output_.known()) return;
    told_ = true;
    device_ = output_.sentence();
    session.help().sound.parameters = describe(session.sound().parameters, device_);
}

void DesktopSound::judged(LessonSession& session) const {
    const bool slag = traitsOf(session.lesson().process).shielding == Shielding::slag;
    if (slag && session.attempt().judged()) session.sound().soundSteps.chip(kChips);
}

} // namespace meltpool
