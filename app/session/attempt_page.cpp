#include "app/session/attempt_page.hpp"

#include "app/platform/program_info.hpp"
#include "app/report/attempt_pictures.hpp"
#include "app/report/report_page.hpp"
#include "core/base/error.hpp"
#include "core/base/resources.hpp"

#include <algorithm>

namespace meltpool {

namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 960, kHeight = 540, kSamples = 4;

/// The picture "metal", else the first that is no section.
const PictureLook* outsideOf(const std::vector<PictureLook>& pictures) {
    const auto named = std::find_if(pictures.begin(), pictures.end(), [](const auto& p) { return p.name == "metal"; });
    if (named != pictures.end()) return &*named;
    const auto first = std::find_if(pictures.begin(), pictures.end(), [](const auto& p) { return !p.sectionAt; });
    return first == pictures.end() ? nullptr : &*first;
}

std::vector<ReportPicture> picturesOf(Trainer& trainer, Renderer& renderer) {
    std::vector<ReportPicture> taken;
    const std::vector<PictureLook>& pictures = trainer.lesson().pictures;
    const PictureLook* outside = outsideOf(pictures);
    const PictureTarget target(kWidth, kHeight, kSamples);
    trainer.updateSurface(nullptr);
    for (const PictureLook& picture : pictures)
        if (&picture == outside || picture.sectionAt)
            taken.push_back({picture.name, pngBytes(takePicture(renderer, target, trainer, picture))});
    return taken;
}

fs::path freeName(const fs::path& wanted) {
    fs::path name = wanted;
    std::error_code failure;
    for (int number = 2; fs::exists(fs::symlink_status(name, failure)); ++number)
        name.replace_filename(wanted.stem().string() + " (" + std::to_string(number) + ")" +
                              wanted.extension().string());
    return name;
}

} // namespace

std::string attemptPage(Trainer& trainer, Renderer& renderer, const Judgement& judgement, const AttemptFacts& facts,
                        const std::string& driver) {
    ResultContext context;
    context.version = programVersion();
    context.commit = programCommit();
    context.renderer = driver;
    context.date = facts.head.date;
    context.attempt = facts;
    context.section = trainer.section();
    context.judgement = judgement;
    const LessonResult result = trainer.result();
    Lesson lesson = trainer.lesson();
    lesson.torchFile.clear(); // the person led the torch
    RunResults results = resultsOf(resultEntries(lesson, &result, context), judgement);
    results.pictures = picturesOf(trainer, renderer);
    return reportPage(results);
}

fs::path attemptPageName(const fs::path& record, const std::string& lesson, const std::string& date) {
    if (!record.empty()) {
        fs::path page = record;
        return freeName(page.replace_extension(".html"));
    }
    const fs::path folder = keptFolder() / "pages";
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure || !fs::is_directory(folder, failure))
        throw InputError(folder, 0, "cannot be made; expected a place where a folder may be made and written");
    std::string name = lesson + " " + date + ".html";
    std::replace(name.begin(), name.end(), ':', '.');
    return freeName(folder / name);
}

} // namespace meltpool
