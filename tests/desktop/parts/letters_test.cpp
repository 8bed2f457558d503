// Tests the letters of the interface's fonts, and the report of letters that no font has.
#include "app/ui/letters.hpp"
#include "app/ui/theme.hpp"
#include "tests/support/catch.hpp"

namespace meltpool::test {

namespace {

/// Loads the interface's fonts without a window.
class LoadedFonts {
  public:
    LoadedFonts() {
        ImGui::CreateContext();
        fonts_ = ui::loadFonts(1, 1);
        ImGui::GetIO().Fonts->Build();
    }
    ~LoadedFonts() { ImGui::DestroyContext(); }
    LoadedFonts(const LoadedFonts&) = delete;
    LoadedFonts& operator=(const LoadedFonts&) = delete;

    const ui::Fonts& fonts() const { return fonts_; }

  private:
    ui::Fonts fonts_;
};

} // namespace

TEST_CASE("the alphabets of Europe, Vietnamese and the signs of the trade are drawn, in every size of text") {
    const LoadedFonts loaded;
    for (ImFont* font : {loaded.fonts().body, loaded.fonts().strong, loaded.fonts().small})
        for (const char* text : {"Γωνιακή ραφή, Ύψος", "Угловой шов, Зварювання їжак", "Sudură de colț: ăâîșț ȘȚ",
                                 "Hàn góc: ơưạệữ ĐỆ", "Köşe kaynağı İıŞğ", "Schweißen, soudé à l’œil, spawać źdźbło",
                                 "12 € ≤ 3 ≥ 2 ≈ 2,5 → ⌀ 1,2 ∠ 90° ✓ ✗ ½ ‰ Ω"}) {
            ui::MissingLetters missing;
            INFO("the tests need the packages fonts-open-sans and fonts-dejavu-core");
            missing.look(*font, text);
            CHECK_FALSE(missing.take());
        }
    ui::MissingLetters missing;
    missing.look(*loaded.fonts().title, "Ergebnis: 87 – Đạt");
    CHECK_FALSE(missing.take());
}

TEST_CASE("letters that no font has are told once, whatever else the text holds") {
    const LoadedFonts loaded;
    ImFont& font = *loaded.fonts().body;
    ui::MissingLetters missing;
    missing.look(font, "溶接 of 溶");
    missing.look(font, " and ق");
    const auto told = missing.take();
    REQUIRE(told);
    CHECK_THAT(told->terminal, containsText(": 溶 接 ق;"));
    CHECK_THAT(told->window, containsText("3 of the letters used here (U+6EB6 U+63A5 U+0642)"));
    missing.look(font, "溶接");
    CHECK_FALSE(missing.take());
    missing.look(font, "溶接機\xF0\x9F\x94\xA5"); // the last letter is beyond 16 bits
    CHECK_THAT(missing.take()->window, containsText("2 of the letters used here (U+6A5F U+1F525)"));
    missing.look(font, "あいうえおかきく");
    CHECK_THAT(missing.take()->window,
               containsText("8 of the letters used here (U+3042 U+3044 U+3046 U+3048 U+304A U+304B ..)"));
    // Control characters, marks that draw nothing and broken bytes do not count as missing letters.
    missing.look(font, "a\tb\n\xE2\x80\x8B\xEF\xBB\xBF \xFF\xC3");
    CHECK_FALSE(missing.take());
}

} // namespace meltpool::test
