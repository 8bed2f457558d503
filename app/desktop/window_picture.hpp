// Draws the picture of the running lesson in the window, as finely as the setting says or the metal leaves time for.
#pragma once

#include "app/desktop/background_steps.hpp"
#include "app/desktop/picture_quality.hpp"
#include "app/desktop/scaled_picture.hpp"
#include "app/session/lesson_session.hpp"

#include <optional>

namespace meltpool {

/// Request of the window for a picture.
struct PictureWish {
    glm::ivec2 pixels{0};      ///< size of the window
    glm::vec2 middle{0};       ///< middle of the uncovered part: CoveredEdges::shift(), lift()
    double seconds = 0;        ///< duration of the last frame
    int setting = 0;           ///< index into pictureChoices()
    bool whole = false;        ///< draw all pixels whatever the setting: the picture is to be saved
    bool surfaceLater = false; ///< draw() makes the metal's surface
};

class WindowPicture {
  public:
    explicit WindowPicture(gl::ShaderLibrary& shaders) : scaled_(shaders) {}

    /// Counts the last frame, which took `seconds`. `beside`: empty if the steps ran before the picture. Call it before
    /// the next steps. After it, the picture of this frame is not prepared().
    void count(const LessonSession& session, double seconds, const std::optional<StepsBeside>& beside);
    /// Takes the picture's content from the lesson's current state. The metal moves smoothly to the requested middle.
    void prepare(LessonSession& session, const Controls& controls, const PictureWish& wish, gl::Profiler* profiler);
    /// Returns true if this frame has a picture of the lesson.
    bool prepared() const { return prepared_; }
    /// Draws the prepared picture. Leaves the window's frame buffer bound.
    void draw(LessonSession& session, gl::Profiler* profiler);
    /// Returns the prepared moment without panels and with all detail, in 4K or as much of that as fits the window's
    /// shape. Waits for the driver: seconds if the processor draws. Throws RuntimeFault if it cannot draw it.
    Image large(LessonSession& session);
    /// Level of the last picture as a sentence, see pictureSentence().
    std::string_view sentence() const { return sentence_; }
    /// Returns true if neither metal nor camera moved lately: the next picture is equal to the last.
    bool stands() const { return stands_; }

  private:
    PictureBudget budget_;
    StillPicture still_;
    ScaledPicture scaled_;
    DeskPicture shown_;
    PictureLevel level_ = PictureLevel::full; ///< level of shown_
    glm::ivec2 pixels_{0};
    glm::vec2 shift_{0}; ///< shift of shown_, see LessonPicture::atDesk()
    std::string_view sentence_;
    bool counts_ = false; ///< the last picture was drawn at the budget's level
    bool stands_ = false;
    bool prepared_ = false;
};

} // namespace meltpool
