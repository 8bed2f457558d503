// `meltpool doctor`: parts that the machine has, parts that are missing, and how to get them.
#include "app/commands/doctor.hpp"

#include "app/commands/commands.hpp"
#include "app/commands/headset_doctor.hpp"
#include "app/commands/speed_doctor.hpp"
#include "app/desktop/window_system.hpp"
#include "app/platform/program_info.hpp"
#include "app/sound/openal_device.hpp"
#include "core/base/error.hpp"
#include "core/base/resources.hpp"
#include "core/gl/context.hpp"
#include "core/gl/software_driver/software_driver.hpp"
#include "core/render/view_submission.hpp"
#include "core/training/lesson/lesson.hpp"

#include <GLFW/glfw3.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <optional>

namespace meltpool {

namespace {

using State = Finding::State;

/// Limit of the driver that a lesson of full size needs; OpenGL itself may guarantee less.
struct Limit {
    const char* name;
    GLenum query;
    GLint64 needed;
};

constexpr std::array<Limit, 6> kLimits{{
    {"invocations of a compute group", GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS, 256},
    {"shared memory of a compute group", GL_MAX_COMPUTE_SHARED_MEMORY_SIZE, 16384},
    {"storage buffers of a compute shader", GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, 8},
    {"size of a storage buffer", GL_MAX_SHADER_STORAGE_BLOCK_SIZE, 1 << 27},
    {"edge of a 3D texture", GL_MAX_3D_TEXTURE_SIZE, 256},
    {"edge of a picture", GL_MAX_TEXTURE_SIZE, 8192},
}};

void inspectDriver(std::vector<Finding>& findings) {
    const gl::ContextSystem system = gl::contextSystem();
    findings.push_back({system.name, State::good, system.version, ""});
    try {
        const gl::HeadlessContext context(false);
        const gl::ContextInfo& info = context.info();
        findings.push_back({"OpenGL", State::good, info.version + " on " + info.renderer, ""});
        if (info.software)
            findings.push_back({"graphics card", State::note, "none in use: the processor draws",
                                "install the graphics card's driver for larger lessons and a headset"});
        if (const auto advice = gl::newerDriver(info.renderer, info.version))
            findings.push_back({advice->about, State::note, advice->found, advice->remedy});
        findings.push_back(
            {"automatic detail of pictures", State::good,
             info.software ? "low, as the processor draws" : "measured at the start of each lesson, from high to low",
             ""});
        for (const Limit& limit : kLimits) {
            GLint64 value = 0;
            glGetInteger64v(limit.query, &value);
            const bool enough = value >= limit.needed;
            findings.push_back({limit.name, enough ? State::good : State::missing,
                                std::to_string(value) + (enough ? "" : ", needed " + std::to_string(limit.needed)),
                                enough ? "" : "a newer graphics driver"});
        }
        const SubmissionChoice eyes = chooseSubmission(std::nullopt, submissionOffer(), 2);
        const bool best = eyes.submission == ViewSubmission::viewports;
        findings.push_back({"both eyes of a headset", best ? State::good : State::note, eyes.sentence,
                            best ? "" : "a newer graphics driver"});
    } catch (const std::exception& error) {
        findings.push_back({"OpenGL", State::missing, error.what(), system.remedy});
    }
}

void inspectDisplay(std::vector<Finding>& findings) {
    if (startWindowSystem()) {
        int count = 0;
        GLFWmonitor** monitors = glfwGetMonitors(&count);
        std::string found = std::to_string(count) + (count == 1 ? " monitor" : " monitors");
        if (count > 0)
            if (const GLFWvidmode* mode = glfwGetVideoMode(monitors[0]))
                found += ", " + std::to_string(mode->width) + "x" + std::to_string(mode->height) + " at " +
                         std::to_string(mode->refreshRate) + " Hz";
        findings.push_back({"display", State::good, found + "; GLFW " + glfwGetVersionString(), ""});
        glfwTerminate();
        return;
    }
    findings.push_back(
        {"display", State::note, "none: lessons run without a window", "start from a desktop session, or set DISPLAY"});
}

void inspectFiles(std::vector<Finding>& findings) {
    try {
        const std::filesystem::path folder = resourceFolder();
        findings.push_back({"program's files", State::good, folder.string(), ""});
        const auto names = lessonNames(folder / "data" / "lessons");
        for (const std::string& name : names)
            findLesson(name, folder / "data" / "lessons");
        findings.push_back({"lessons", names.empty() ? State::missing : State::good, std::to_string(names.size()),
                            names.empty() ? "install the program again" : ""});
    } catch (const InputError& error) {
        findings.push_back({"program's files", State::missing, error.what(),
                            "install the program again, or set MELTPOOL_DATA to the folder with shaders and data"});
    }
    findings.push_back({"settings", State::good, settingsFolder().string(), ""});
}

void inspectSound(std::vector<Finding>& findings) {
    try {
        const std::unique_ptr<OpenAlDevice> device = OpenAlDevice::openDefault();
        findings.push_back(
            {"sound", State::good,
             "device " + device->name() +
                 (device->hasHeadModel() ? ", with a model of the head (HRTF)" : ", without a model of the head"),
             ""});
    } catch (const std::exception& error) {
        findings.push_back({"sound", State::note, error.what(),
                            "a sound card or sound server; without one the "
                            "trainer is silent, and captions describe the sounds"});
    }
}

const char* stateWord(State state) {
    if (state == State::good) return "ok";
    return state == State::note ? "note" : "MISSING";
}

} // namespace

bool printFindings(const std::vector<Finding>& findings) {
    bool complete = true;
    for (const Finding& f : findings) {
        complete = complete && f.state != State::missing;
        std::printf("%-8s %-36s %s\n", stateWord(f.state), f.what.c_str(), f.found.c_str());
        if (!f.remedy.empty()) std::printf("%-8s %-36s to get it: %s\n", "", "", f.remedy.c_str());
    }
    return complete;
}

bool runDoctor(bool speed) {
    std::printf("meltpool %s\n", programBuild().c_str());
    gl::runDriverSingleThreaded(); // a weld must run at the window's speed
    std::vector<Finding> findings;
    inspectDriver(findings);
    inspectDisplay(findings);
    inspectFiles(findings);
    inspectSound(findings);
    inspectHeadset(findings);
    if (speed) inspectSpeed(findings);
    const bool complete = printFindings(findings);
    std::printf(complete ? "Everything that a lesson needs is here.\n"
                         : "Something that every lesson needs is missing.\n");
    return complete;
}

} // namespace meltpool
