// The picture of the running lesson in the window, drawn as finely as the setting says or as the metal leaves time for.
#pragma once

#include "app/desktop/background_steps.hpp"
#include "app/desktop/picture_quality.hpp"
#include "app/desktop/scaled_picture.hpp"
#include "app/session/lesson_session.hpp"

#include <optional>

namespace meltpool {

/// What the window knows of a picture to be drawn.
struct PictureWish {
    glm::ivec2 pixels{0};      ///< of the window
    float middle = 0;          ///< of what the panels leave free, see DesktopMenus::middleOfPicture()
    double seconds = 0;        ///< of the last frame
    int setting = 0;           ///< of pictureChoices()
    bool whole = false;        ///< with all pixels whatever the setting: it is to be kept
    bool surfaceLater = false; ///< the metal's surface is made in draw()
};

class WindowPicture {
  public:
    explicit WindowPicture(gl::ShaderLibrary& shaders) : scaled_(shaders) {}

    /// Counts the last frame, which took `seconds`. `beside`: empty where the steps were made before the picture. To be
    /// called before the next steps are made. From then on the picture of this frame is not prepared().
    void count(const LessonSession& session, double seconds, const std::optional<StepsBeside>& beside);
    /// Takes what the picture shows from the lesson as it is now. The metal moves smoothly to the middle wished for.
    void prepare(LessonSession& session, const Controls& controls, const PictureWish& wish, gl::Profiler* profiler);
    /// This frame has a picture of the lesson.
    bool prepared() const { return prepared_; }
    /// Draws that. Leaves the window's frame buffer bound.
    void draw(LessonSession& session, gl::Profiler* profiler);
    /// The same moment without panels and with all detail, 4K or as much of that as has the window's shape. Waits for
    /// the driver: seconds where the processor draws. Throws RuntimeFault when it cannot draw it.
    Image large(LessonSession& session);
    /// What the last picture was drawn at, see pictureSentence().
    std::string_view sentence() const { return sentence_; }
    /// Neither metal nor camera moved lately: the next picture is the same as the last.
    bool stands() const { return stands_; }

  private:
    PictureBudget budget_;
    StillPicture still_;
    ScaledPicture scaled_;
    DeskPicture shown_;
    PictureLevel level_ = PictureLevel::full; ///< of shown_
    glm::ivec2 pixels_{0};
    float shift_ = 0; ///< of shown_, see LessonPicture::atDesk()
    std::string_view sentence_;
    bool counts_ = false; ///< the last picture was drawn at the budget's level
    bool stands_ = false;
    bool prepared_ = false;
};

} // namespace meltpool
