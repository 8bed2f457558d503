// A hidden window of Windows: OpenGL contexts exist there only with a window's device context.
#pragma once

namespace meltpool::gl {

/// May be destroyed on any thread; the thread that made it must handle its messages until then.
class HiddenWindow {
  public:
    /// `pixelFormat`: of another window's device context, so that contexts made there may be used here; 0: one with 32
    /// bits of colour. Throws InputError if Windows refuses.
    explicit HiddenWindow(int pixelFormat = 0);
    ~HiddenWindow();
    HiddenWindow(const HiddenWindow&) = delete;
    HiddenWindow& operator=(const HiddenWindow&) = delete;

    /// An HDC that belongs to this window until its destruction.
    void* deviceContext() const { return deviceContext_; }

    /// A context of OpenGL 4.5 core (HGLRC) for this window. It shares objects with `sharedWith` unless that is
    /// nullptr; a context must be current, so that the driver's functions can be found. nullptr on failure.
    void* makeContext(bool debug, void* sharedWith) const;

  private:
    void* window_ = nullptr;
    void* deviceContext_ = nullptr;
};

} // namespace meltpool::gl
