// OpenAL for Windows, which has none of its own: its functions are taken from OpenAL32.dll or soft_oal.dll, in the
// program's folder or installed, when the first is called. Without either there is no device.
#include <AL/al.h>
#include <AL/alc.h>

#include <windows.h>

namespace {

HMODULE library() {
    static const HMODULE loaded = [] {
        const HMODULE soft = LoadLibraryW(L"soft_oal.dll");
        return soft != nullptr ? soft : LoadLibraryW(L"OpenAL32.dll");
    }();
    return loaded;
}

/// Calls the library's function; returns 0 without a library.
template <class Answer, class... Values>
Answer call(const char* name, Values... values) {
    using Function = Answer (*)(Values...);
    const HMODULE from = library();
    const auto function =
        from == nullptr ? nullptr : reinterpret_cast<Function>(reinterpret_cast<void*>(GetProcAddress(from, name)));
    if (function == nullptr) return Answer();
    return function(values...);
}

} // namespace

extern "C" {

ALCdevice* alcOpenDevice(const ALCchar* name) {
    return call<ALCdevice*>("alcOpenDevice", name);
}
ALCboolean alcCloseDevice(ALCdevice* device) {
    return call<ALCboolean>("alcCloseDevice", device);
}
ALCcontext* alcCreateContext(ALCdevice* device, const ALCint* attributes) {
    return call<ALCcontext*>("alcCreateContext", device, attributes);
}
ALCboolean alcMakeContextCurrent(ALCcontext* context) {
    return call<ALCboolean>("alcMakeContextCurrent", context);
}
void alcDestroyContext(ALCcontext* context) {
    call<void>("alcDestroyContext", context);
}
void alcGetIntegerv(ALCdevice* device, ALCenum what, ALCsizei size, ALCint* values) {
    call<void>("alcGetIntegerv", device, what, size, values);
}
const ALCchar* alcGetString(ALCdevice* device, ALCenum what) {
    return call<const ALCchar*>("alcGetString", device, what);
}
void* alcGetProcAddress(ALCdevice* device, const ALCchar* name) {
    return call<void*>("alcGetProcAddress", device, name);
}
void alGenSources(ALsizei count, ALuint* sources) {
    call<void>("alGenSources", count, sources);
}
void alDeleteSources(ALsizei count, const ALuint* sources) {
    call<void>("alDeleteSources", count, sources);
}
void alGenBuffers(ALsizei count, ALuint* buffers) {
    call<void>("alGenBuffers", count, buffers);
}
void alDeleteBuffers(ALsizei count, const ALuint* buffers) {
    call<void>("alDeleteBuffers", count, buffers);
}
void alDistanceModel(ALenum model) {
    call<void>("alDistanceModel", model);
}
void alSourcef(ALuint source, ALenum what, ALfloat value) {
    call<void>("alSourcef", source, what, value);
}
void alSource3f(ALuint source, ALenum what, ALfloat x, ALfloat y, ALfloat z) {
    call<void>("alSource3f", source, what, x, y, z);
}
void alSourcei(ALuint source, ALenum what, ALint value) {
    call<void>("alSourcei", source, what, value);
}
void alGetSourcei(ALuint source, ALenum what, ALint* value) {
    call<void>("alGetSourcei", source, what, value);
}
void alSourcePlay(ALuint source) {
    call<void>("alSourcePlay", source);
}
void alSourceStop(ALuint source) {
    call<void>("alSourceStop", source);
}
void alSourceRewind(ALuint source) {
    call<void>("alSourceRewind", source);
}
void alSourceQueueBuffers(ALuint source, ALsizei count, const ALuint* buffers) {
    call<void>("alSourceQueueBuffers", source, count, buffers);
}
void alSourceUnqueueBuffers(ALuint source, ALsizei count, ALuint* buffers) {
    call<void>("alSourceUnqueueBuffers", source, count, buffers);
}
void alBufferData(ALuint buffer, ALenum format, const ALvoid* data, ALsizei bytes, ALsizei rate) {
    call<void>("alBufferData", buffer, format, data, bytes, rate);
}
ALenum alGetError() {
    return call<ALenum>("alGetError");
}

} // extern "C"
