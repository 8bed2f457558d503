#include "app/desktop/error_window.hpp"

#include "app/platform/other_program.hpp"
#include "app/ui/letters.hpp"
#include "app/ui/theme.hpp"
#include "core/base/environment.hpp"
#include "core/base/text.hpp"

#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/keysym.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>

namespace meltpool {

namespace {

constexpr float kWidth = 560, kPad = 28, kButtonWidth = 110, kButtonHeight = 36, kGap = 22; // points
constexpr ImU32 kGround = ui::colour::kPanel, kInk = ui::colour::kText;

/// A picture in memory that X shows: 4 bytes a pixel, blue first.
class Canvas {
  public:
    Canvas(int width, int height) : width_(width), height_(height), pixels_(size_t{4} * width * height) {}

    void fill(int left, int top, int right, int bottom, ImU32 tint) {
        for (int y = std::max(top, 0); y < std::min(bottom, height_); ++y)
            for (int x = std::max(left, 0); x < std::min(right, width_); ++x)
                blend(x, y, tint, 1);
    }
    void blend(int x, int y, ImU32 tint, float cover) {
        if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
        char* pixel = &pixels_[size_t{4} * (size_t(y) * size_t(width_) + size_t(x))];
        const std::array<ImU32, 3> shares{tint >> IM_COL32_B_SHIFT & 0xFF, tint >> IM_COL32_G_SHIFT & 0xFF,
                                          tint >> IM_COL32_R_SHIFT & 0xFF};
        for (size_t i = 0; i < 3; ++i) {
            const float before = static_cast<float>(static_cast<unsigned char>(pixel[i]));
            pixel[i] = static_cast<char>(
                static_cast<unsigned char>(std::lround(before + (static_cast<float>(shares[i]) - before) * cover)));
        }
    }
    int width() const { return width_; }
    int height() const { return height_; }
    char* data() { return pixels_.data(); }

  private:
    int width_, height_;
    std::vector<char> pixels_;
};

/// Draws the interface's fonts on the processor.
class Lettering {
  public:
    explicit Lettering(float scale) : scale_(scale) {
        ImGui::CreateContext();
        fonts_ = ui::loadFonts(scale, 1);
        ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&atlas_, &atlasWidth_, &atlasHeight_);
    }
    ~Lettering() { ImGui::DestroyContext(); }
    Lettering(const Lettering&) = delete;
    Lettering& operator=(const Lettering&) = delete;

    ImFont& body() const { return *fonts_.body; }
    ImFont& strong() const { return *fonts_.strong; }
    float points(float size) const { return size * scale_; }

    /// Breaks the text into lines of at most `room` pixels.
    std::vector<std::string> lines(ImFont& font, const std::string& text, float room) const {
        std::vector<std::string> all;
        for (const std::string_view paragraph : splitText(text, '\n')) {
            const char *from = paragraph.data(), *const end = from + paragraph.size();
            while (from < end) {
                const char* stop = font.CalcWordWrapPositionA(1, from, end, room);
                if (stop == from) stop = end;
                all.emplace_back(from, stop);
                from = stop;
                while (from < end && *from == ' ')
                    ++from;
            }
        }
        return all;
    }
    float width(ImFont& font, const std::string& line) const {
        return font.CalcTextSizeA(ui::loadedSize(font), 1e6f, 0, line.c_str()).x;
    }
    void draw(Canvas& canvas, ImFont& font, float x, float y, const std::string& line, ImU32 tint) const {
        std::string_view rest = line;
        while (!rest.empty()) {
            const ui::DecodedLetter next = ui::decodeLetter(rest);
            rest.remove_prefix(next.bytes);
            const ImFontGlyph* glyph = glyphOf(font, static_cast<ImWchar>(next.letter > 0xFFFF ? 0xFFFD : next.letter));
            if (glyph == nullptr) continue;
            drawGlyph(canvas, *glyph, x, y, tint);
            x += glyph->AdvanceX;
        }
    }

  private:
    static const ImFontGlyph* glyphOf(ImFont& font, ImWchar letter) {
#if IMGUI_VERSION_NUM >= 19200
        return font.GetFontBaked(ui::loadedSize(font))->FindGlyph(letter);
#else
        return font.FindGlyph(letter);
#endif
    }
    void drawGlyph(Canvas& canvas, const ImFontGlyph& glyph, float x, float y, ImU32 tint) const {
        const float left = std::round(x + glyph.X0), top = std::round(y + glyph.Y0);
        const float wide = glyph.X1 - glyph.X0, high = glyph.Y1 - glyph.Y0;
        for (int row = 0; static_cast<float>(row) < high; ++row)
            for (int column = 0; static_cast<float>(column) < wide; ++column) {
                const float u = glyph.U0 + (glyph.U1 - glyph.U0) * (static_cast<float>(column) + 0.5f) / wide;
                const float v = glyph.V0 + (glyph.V1 - glyph.V0) * (static_cast<float>(row) + 0.5f) / high;
                canvas.blend(static_cast<int>(left) + column, static_cast<int>(top) + row, tint, cover(u, v));
            }
    }
    /// Interpolates between the two nearest texels of the row: letters are twice as wide in the atlas.
    float cover(float u, float v) const {
        const float along = u * static_cast<float>(atlasWidth_) - 0.5f;
        const int column = static_cast<int>(std::floor(along));
        const int row = std::clamp(static_cast<int>(v * static_cast<float>(atlasHeight_)), 0, atlasHeight_ - 1);
        const auto texel = [&](int x) {
            return static_cast<float>(atlas_[row * atlasWidth_ + std::clamp(x, 0, atlasWidth_ - 1)]) / 255;
        };
        const float share = along - static_cast<float>(column);
        return texel(column) * (1 - share) + texel(column + 1) * share;
    }

    float scale_;
    ui::Fonts fonts_;
    unsigned char* atlas_ = nullptr;
    int atlasWidth_ = 0, atlasHeight_ = 0;
};

struct Button {
    int left = 0, top = 0, right = 0, bottom = 0;
    bool holds(int x, int y) const { return x >= left && x < right && y >= top && y < bottom; }
};

/// Paints the whole window as a picture; returns it with the place of its button.
std::pair<Canvas, Button> paint(const Lettering& letters, const std::string& sentence) {
    const float pad = letters.points(kPad), line = ui::loadedSize(letters.body()) * 1.3f;
    const float room = letters.points(kWidth) - 2 * pad;
    const std::vector<std::string> lines = letters.lines(letters.body(), sentence, room);
    const float words = line * static_cast<float>(lines.size() + 1) + letters.points(8);
    const float height = 2 * pad + words + letters.points(kGap + kButtonHeight);
    Canvas canvas(static_cast<int>(letters.points(kWidth)), static_cast<int>(height));
    canvas.fill(0, 0, canvas.width(), canvas.height(), kGround);
    letters.draw(canvas, letters.strong(), pad, pad, "Meltpool has stopped", ui::colour::kAccent);
    float y = pad + line + letters.points(8);
    for (const std::string& each : lines) {
        letters.draw(canvas, letters.body(), pad, y, each, kInk);
        y += line;
    }
    Button button;
    button.right = canvas.width() - static_cast<int>(pad);
    button.bottom = canvas.height() - static_cast<int>(pad);
    button.left = button.right - static_cast<int>(letters.points(kButtonWidth));
    button.top = button.bottom - static_cast<int>(letters.points(kButtonHeight));
    canvas.fill(button.left, button.top, button.right, button.bottom, ui::colour::kAccent);
    const std::string close = "Close";
    const float middle = static_cast<float>(button.left + button.right) / 2;
    letters.draw(canvas, letters.strong(), middle - letters.width(letters.strong(), close) / 2,
                 static_cast<float>(button.top + button.bottom) / 2 - ui::loadedSize(letters.strong()) / 2, close,
                 ui::colour::kOnAccent);
    return {std::move(canvas), button};
}

/// Scale of the window, 1 at an ordinary density: from the desktop's setting, as the main window has it.
float scaleOf(Display* display) {
    const char* dpi = XGetDefault(display, "Xft", "dpi");
    const auto number = dpi == nullptr ? std::nullopt : parseDouble(dpi);
    return number ? std::clamp(static_cast<float>(*number / 96), 0.5f, 4.0f) : 1.0f;
}

/// Opens a window of fixed size in the middle of the screen.
Window openWindow(Display* display, const Canvas& canvas, Atom farewell) {
    const int screen = DefaultScreen(display);
    const int x = std::max((DisplayWidth(display, screen) - canvas.width()) / 2, 0);
    const int y = std::max((DisplayHeight(display, screen) - canvas.height()) / 2, 0);
    const Window window =
        XCreateSimpleWindow(display, DefaultRootWindow(display), x, y, static_cast<unsigned>(canvas.width()),
                            static_cast<unsigned>(canvas.height()), 0, 0, 0);
    XStoreName(display, window, "Meltpool");
    std::array<char, 9> name{"meltpool"};
    XClassHint hint{name.data(), name.data()};
    XSetClassHint(display, window, &hint);
    XSizeHints size{};
    size.flags = PMinSize | PMaxSize | PPosition;
    size.x = x;
    size.y = y;
    size.min_width = size.max_width = canvas.width();
    size.min_height = size.max_height = canvas.height();
    XSetWMNormalHints(display, window, &size);
    XSetWMProtocols(display, window, &farewell, 1);
    XSelectInput(display, window, ExposureMask | KeyPressMask | ButtonReleaseMask);
    XMapRaised(display, window);
    return window;
}

/// Returns true for the button, its keys or the window's cross.
bool closes(XEvent& event, const Button& button, Atom farewell) {
    if (event.type == ClientMessage) return static_cast<Atom>(event.xclient.data.l[0]) == farewell;
    if (event.type == ButtonRelease) return button.holds(event.xbutton.x, event.xbutton.y);
    if (event.type != KeyPress) return false;
    const KeySym key = XLookupKeysym(&event.xkey, 0);
    return key == XK_Return || key == XK_KP_Enter || key == XK_Escape || key == XK_space;
}

bool showOnX(const std::string& sentence) {
    const std::unique_ptr<Display, int (*)(Display*)> display(XOpenDisplay(nullptr), XCloseDisplay);
    if (!display) return false;
    const int screen = DefaultScreen(display.get()), depth = DefaultDepth(display.get(), screen);
    Visual* visual = DefaultVisual(display.get(), screen);
    if (depth != 24 && depth != 32) return false;
    const Lettering letters(scaleOf(display.get()));
    auto [canvas, button] = paint(letters, sentence);
    Atom farewell = XInternAtom(display.get(), "WM_DELETE_WINDOW", False);
    const Window window = openWindow(display.get(), canvas, farewell);
    XImage* image = XCreateImage(display.get(), visual, static_cast<unsigned>(depth), ZPixmap, 0, canvas.data(),
                                 static_cast<unsigned>(canvas.width()), static_cast<unsigned>(canvas.height()), 32, 0);
    if (image == nullptr) return false;
    image->byte_order = LSBFirst;
    for (bool open = true; open;) {
        XEvent event;
        XNextEvent(display.get(), &event);
        if (event.type == Expose)
            XPutImage(display.get(), window, DefaultGC(display.get(), screen), image, 0, 0, 0, 0,
                      static_cast<unsigned>(canvas.width()), static_cast<unsigned>(canvas.height()));
        open = !closes(event, button, farewell);
    }
    image->data = nullptr; // the canvas owns the pixels
    XDestroyImage(image);
    return true;
}

} // namespace

std::vector<DialogCommand> dialogCommands(const std::string& sentence, const std::string& desktop) {
    const DialogCommand zenity{"zenity",
                               {"--error", "--title=Meltpool", "--no-markup", "--width=420", "--text=" + sentence}};
    const DialogCommand kdialog{"kdialog", {"--title", "Meltpool", "--error", sentence}};
    const bool kde = desktop.find("KDE") != std::string::npos;
    return kde ? std::vector{kdialog, zenity} : std::vector{zenity, kdialog};
}

bool showErrorWindow(const std::string& sentence) {
    if (showOnX(sentence)) return true;
    for (const DialogCommand& command : dialogCommands(sentence, environmentVariable("XDG_CURRENT_DESKTOP"))) {
        const std::filesystem::path program = findProgram(command.program);
        // Dialog programs return 1 if the person closes them by the window's cross.
        if (!program.empty() && runToItsEnd(program, command.words) >= 0) return true;
    }
    return false;
}

} // namespace meltpool
