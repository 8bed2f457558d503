#include "app/sound/openal_device.hpp"

#include "core/base/environment.hpp"
#include "core/base/error.hpp"

#include <AL/al.h>
#include <AL/alc.h>
#include <AL/alext.h>

#include <array>
#include <utility>

#ifdef __linux__
#include <dlfcn.h>
#endif

namespace meltpool {

namespace {

#ifdef __linux__
using AlsaMessage = void (*)(const char* file, int line, const char* function, int error, const char* format, ...);

void ignoreMessage(const char*, int, const char*, int, const char*, ...) {}

/// Silences ALSA, which prints a page of errors if there is no sound card.
void quietAlsa() {
    void* library = dlopen("libasound.so.2", RTLD_LAZY);
    if (library == nullptr) return;
    using SetHandler = int (*)(AlsaMessage);
    if (const auto set = reinterpret_cast<SetHandler>(dlsym(library, "snd_lib_error_set_handler"))) set(ignoreMessage);
}
#else
void quietAlsa() {}
#endif

/// Function of an extension of the library.
template <class Function>
Function extension(ALCdevice* device, const char* name) {
    return reinterpret_cast<Function>(alcGetProcAddress(device, name));
}

} // namespace

struct OpenAlDevice::Handles {
    explicit Handles(ALCdevice* opened) : device(opened) {}

    ALCdevice* device;
    ALCcontext* context = nullptr;
};

OpenAlDevice::OpenAlDevice(std::unique_ptr<Handles> handles) : handles_(std::move(handles)) {}

void OpenAlDevice::quietLibrary() {
    setEnvironmentDefault("ALSOFT_LOGLEVEL", "0");
}

std::unique_ptr<OpenAlDevice> OpenAlDevice::openDefault() {
    quietAlsa();
    ALCdevice* device = alcOpenDevice(nullptr);
    if (device == nullptr) throw RuntimeFault("no sound device found");
    std::unique_ptr<OpenAlDevice> made(new OpenAlDevice(std::make_unique<Handles>(device)));
    constexpr std::array<ALCint, 5> kWanted{ALC_FREQUENCY, kRate, ALC_HRTF_SOFT, ALC_TRUE, 0};
    made->open(kWanted.data());
    return made;
}

std::unique_ptr<OpenAlDevice> OpenAlDevice::openLoopback() {
    const auto openDevice = extension<LPALCLOOPBACKOPENDEVICESOFT>(nullptr, "alcLoopbackOpenDeviceSOFT");
    if (openDevice == nullptr) throw RuntimeFault("this OpenAL has no loopback device");
    ALCdevice* device = openDevice(nullptr);
    if (device == nullptr) throw RuntimeFault("the loopback device cannot be opened");
    std::unique_ptr<OpenAlDevice> made(new OpenAlDevice(std::make_unique<Handles>(device)));
    constexpr std::array<ALCint, 9> kWanted{ALC_FREQUENCY,
                                            kRate,
                                            ALC_FORMAT_CHANNELS_SOFT,
                                            ALC_STEREO_SOFT,
                                            ALC_FORMAT_TYPE_SOFT,
                                            ALC_SHORT_SOFT,
                                            ALC_HRTF_SOFT,
                                            ALC_TRUE,
                                            0};
    made->open(kWanted.data());
    return made;
}

void OpenAlDevice::open(const int* attributes) {
    ALCdevice* const device = handles_->device;
    ALCcontext*& context = handles_->context;
    context = alcCreateContext(device, attributes);
    if (context == nullptr || alcMakeContextCurrent(context) == ALC_FALSE)
        throw RuntimeFault("the sound device does not play");
    ALCint model = ALC_FALSE;
    alcGetIntegerv(device, ALC_HRTF_SOFT, 1, &model);
    headModel_ = model == ALC_TRUE;
    if (const ALCchar* name = alcGetString(device, ALC_ALL_DEVICES_SPECIFIER)) name_ = name;
    alGenSources(1, &source_);
    alGenBuffers(kBlocks, buffers_);
    alDistanceModel(AL_INVERSE_DISTANCE_CLAMPED);
    alSourcef(source_, AL_REFERENCE_DISTANCE, kReferenceDistance);
    alSourcef(source_, AL_ROLLOFF_FACTOR, 1);
    alSourcef(source_, AL_MAX_DISTANCE, 20);
    if (alGetError() != AL_NO_ERROR) throw RuntimeFault("the sound device has no free source");
}

OpenAlDevice::~OpenAlDevice() {
    if (handles_->context != nullptr) {
        if (source_ != 0) {
            alSourceStop(source_);
            alDeleteSources(1, &source_);
            alDeleteBuffers(kBlocks, buffers_);
        }
        alcMakeContextCurrent(nullptr);
        alcDestroyContext(handles_->context);
    }
    alcCloseDevice(handles_->device);
}

void OpenAlDevice::place(const glm::vec3& metres) {
    alSource3f(source_, AL_POSITION, metres.x, metres.y, metres.z);
}

void OpenAlDevice::volume(float factor) {
    alSourcef(source_, AL_GAIN, factor);
}

size_t OpenAlDevice::room() {
    ALint state = AL_INITIAL;
    alGetSourcei(source_, AL_SOURCE_STATE, &state);
    if (state == AL_STOPPED) { // underrun: the queue is filled again before it plays
        alSourceRewind(source_);
        alSourcei(source_, AL_BUFFER, 0);
        queued_ = 0;
    }
    ALint played = 0;
    alGetSourcei(source_, AL_BUFFERS_PROCESSED, &played);
    return kBlocks - queued_ + static_cast<size_t>(played);
}

void OpenAlDevice::queue(std::span<const std::int16_t> samples) {
    ALuint buffer = 0;
    if (queued_ < kBlocks)
        buffer = buffers_[queued_++];
    else
        alSourceUnqueueBuffers(source_, 1, &buffer);
    alBufferData(buffer, AL_FORMAT_MONO16, samples.data(), static_cast<ALsizei>(samples.size_bytes()), kRate);
    alSourceQueueBuffers(source_, 1, &buffer);
    ALint state = AL_INITIAL;
    alGetSourcei(source_, AL_SOURCE_STATE, &state);
    if (state == AL_INITIAL && queued_ == kBlocks) alSourcePlay(source_);
}

void OpenAlDevice::render(std::span<std::int16_t> leftAndRight) {
    const auto renderSamples = extension<LPALCRENDERSAMPLESSOFT>(handles_->device, "alcRenderSamplesSOFT");
    renderSamples(handles_->device, leftAndRight.data(), static_cast<ALCsizei>(leftAndRight.size() / 2));
}

} // namespace meltpool
