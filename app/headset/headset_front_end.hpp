// Drives the headset in parallel with the window: one object that the window's frame calls, with a headset present,
// asleep, lost or in use.
#pragma once

#include "app/headset/again_hold.hpp"
#include "app/headset/headset_changes.hpp"
#include "app/headset/headset_menu.hpp"
#include "app/headset/headset_notice.hpp"
#include "app/headset/mirror.hpp"
#include "app/headset/panel_pointer.hpp"
#include "app/headset/stereo_view.hpp"
#include "app/headset/torch_feedback.hpp"
#include "app/headset/workshop_placing.hpp"
#include "app/session/lesson_session.hpp"
#include "app/session/window_headset.hpp"
#include "xr/headset_connection.hpp"

#include <array>
#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>

namespace meltpool {

class HeadsetFrontEnd final : public WindowHeadset {
  public:
    /// Looks for a headset from the first begin() on. `folder`: stores the torch's calibrations.
    explicit HeadsetFrontEnd(const std::filesystem::path& folder);

    ParameterSection& section() override { return section_; }
    bool begin(LessonSession& session, const Home& home, double elapsed) override;
    TorchSource torch() override;
    const TriggerLock& triggerLock() const override { return hands_.torch().triggerLock(); }
    MenuRequest draw(LessonSession& session, Home& home, const LessonFigures& figures, const Messages& messages,
                     double elapsed, gl::Profiler* profiler) override;
    std::optional<glm::vec3> arcFromHead(const LessonSession& session) const override;
    float zoom() const override { return place_.zoom; }
    void end() override;
    void ask(Question* question) override { question_ = question; }
    bool mirror(glm::ivec2 pixels, gl::ShaderLibrary& shaders) override;
    std::string_view nextDeskView() override;
    bool hopeless() const override { return connection_.hopeless(); }
    int openings() const override { return connection_.openings(); }
    std::string sentence() const override;
    std::string_view warning() const override;
    HeadsetStatus status() const override;

  private:
    using Clock = std::chrono::steady_clock;

    void guarded(FunctionRef<void()> work);
    /// Hand of the welder; none while no headset is in use.
    std::optional<WeldingHand> weldingHand(bool runs) const;
    void readHands(LessonSession& session, const Home& home, double elapsed);
    /// Page that the person has before them; none before the first frame.
    enum class Page { none, home, lesson, work, result };

    /// Head of the last drawn frame, in the session's space.
    xr::Pose head() const;
    static Page pageOf(const LessonSession& session, const Home& home);
    void followPage(const LessonSession& session, const Home& home);
    bool heats(const LessonSession& session) const;
    bool torchWorks(const LessonSession& session) const;
    void movePanel(const LessonSession& session, double elapsed);
    void holdAgain(const LessonSession& session, const xr::Input& input, double elapsed);
    void placeWorkshop(LessonSession& session, double elapsed);
    bool handsAct(const xr::Input& input);
    bool leadsTorch() const { return inFrame_ && changes_.lessonRuns() && hands_.torch().known(); }
    void drawEyes(LessonSession& session, double elapsed, gl::Profiler* profiler);
    void recordPerson(LessonSession& session);
    std::string_view quietSentence(const LessonSession& session) const;
    /// Sentence for eyes that look away from the work, or from a result; empty where they look there.
    std::string_view whereToLook(const LessonSession& session) const;
    std::optional<glm::vec3> torchEnd(const LessonSession& session) const;
    void drawNotice(const LessonSession& session, const LessonFigures& figures, const Messages& messages,
                    double elapsed);
    MenuRequest drawMenu(LessonSession& session, Home& home, const LessonFigures& figures, double elapsed);
    bool wantsMirror() const;

    HeadsetParameters parameters_;
    ParameterSection section_;
    xr::HeadsetConnection connection_;
    Workshop workshop_;
    WorkshopPlacing placing_;
    std::array<glm::vec3, 2> handPlaces_{}; ///< grips in the last frame, session space
    WorkpiecePlace place_;
    HeadsetHands hands_;
    HeadsetChanges changes_;
    PanelPointer panel_;
    StereoView view_;
    TorchFeedback feedback_;
    HeadsetMenu menu_;
    HeadsetNotice notice_;
    Mirror mirror_;
    AgainHold again_;
    Question* question_ = nullptr; ///< see ask()
    xr::FrameTiming timing_;
    bool inFrame_ = false;
    int focusedOpening_ = 0;      ///< opening in which the runtime first gave the trainer its input
    size_t judgements_ = 0;       ///< judgements for which the panel has opened
    bool openedByResult_ = false; ///< a result opened the panel
    bool resultSeen_ = false;     ///< the person has faced the panel since the judgement
    bool arcBurned_ = false;      ///< the arc has burned in this attempt
    Page page_ = Page::none;      ///< page of the last frame
    bool drawn_ = false;          ///< the eyes hold a picture that the runtime shows
    bool mirrored_ = false;       ///< the window shows the eyes' picture too
    double sinceDark_ = 1e9;      ///< s since the visor was dark
    double busy_ = 0;             ///< s of the last frame's begin() and draw() without waiting for the runtime
};

} // namespace meltpool
