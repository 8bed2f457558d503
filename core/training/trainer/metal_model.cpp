#include "core/training/trainer/metal_model.hpp"

#include "core/training/lesson/lesson.hpp"
#include "core/training/trainer/classic_model.hpp"
#include "core/training/trainer/weld_model.hpp"

namespace meltpool {

std::unique_ptr<MetalModel> makeMetalModel(gl::ShaderLibrary& shaders, const Lesson& lesson) {
    if (lesson.model == LessonModel::Weld) return std::make_unique<WeldModel>(shaders, lesson);
    return std::make_unique<ClassicModel>(shaders, lesson);
}

} // namespace meltpool
