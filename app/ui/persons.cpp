// Draws the question for the name of the person who welds: a field, the known names, and ways without a name.
#include "app/ui/panels.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <optional>
#include <string>

namespace meltpool::ui {

namespace {

constexpr size_t kNamesAPage = 12;
constexpr float kFieldWidth = 320; ///< points

/// Draws the field for the name and the button that takes it; returns true if it was taken.
bool nameField(Context& context, WhoWelds& who) {
    bool taken = false;
    ImGui::TextUnformatted(phrase("persons.name").c_str());
    ImGui::SetNextItemWidth(std::min(context.points(kFieldWidth), ImGui::GetContentRegionAvail().x));
    if (who.takeOpened()) ImGui::SetKeyboardFocusHere();
    const bool entered = ImGui::InputText("##person", who.typed.data(), who.typed.size(),
                                          ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    markItem(context, "persons.name");
    if (ImGui::GetContentRegionAvail().x > context.points(kFieldWidth + 150)) ImGui::SameLine(0, context.points(10));
    const bool pressed = button(context, "persons.accept", phrase("persons.accept").c_str(), ButtonKind::main, 120,
                                phrase("persons.accept_tip").c_str());
    if (pressed || entered) taken = who.takeTyped();
    if (!who.refusal().empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, colour::kWarning);
        wrappedText(who.refusal());
        ImGui::PopStyleColor();
        markItem(context, "persons.refusal");
    }
    ImGui::Dummy({0, context.points(8)});
    return taken;
}

/// Draws the known names as buttons; returns true if one was pressed.
bool nameButtons(Context& context, WhoWelds& who) {
    const std::vector<KnownPerson>& all = who.persons().all();
    if (all.empty()) return false;
    const size_t pages = (all.size() + kNamesAPage - 1) / kNamesAPage;
    who.page = std::min(who.page, pages - 1);
    std::optional<size_t> chosen;
    ButtonRow row(context, 10);
    for (size_t i = who.page * kNamesAPage; i < std::min(all.size(), (who.page + 1) * kNamesAPage); ++i)
        if (row.add("persons.known." + std::to_string(i), all[i].name.c_str(),
                    all[i].id == who.welder().person.id ? ButtonKind::lit : ButtonKind::plain, 120))
            chosen = i;
    if (pages > 1 && row.add("persons.more", phrase("persons.more").c_str(), ButtonKind::plain, 120))
        who.page = (who.page + 1) % pages;
    ImGui::Dummy({0, context.points(8)});
    if (!chosen) return false;
    who.takePerson(*chosen);
    return !who.asked();
}

/// The name's first `most` letters, with a mark if it has more.
std::string shortened(const std::string& name, size_t most) {
    size_t letters = 0;
    for (size_t i = 0; i < name.size(); ++i)
        if ((static_cast<unsigned char>(name[i]) & 0xC0) != 0x80 && ++letters > most) return name.substr(0, i) + "..";
    return name;
}

} // namespace

MenuRequest personsPart(Context& context, WhoWelds& who, bool typing) {
    bool taken = typing && nameField(context, who);
    taken = nameButtons(context, who) || taken;
    ButtonRow others(context, 10);
    if (others.add("persons.guest", phrase("persons.guest").c_str(), ButtonKind::plain, 120,
                   phrase("persons.guest_tip").c_str())) {
        who.takeGuest();
        taken = true;
    }
    if (others.add("persons.account", phrase("persons.account").c_str(), ButtonKind::plain, 120,
                   phrase("persons.account_tip").c_str())) {
        who.takeAccount();
        taken = true;
    }
    if (others.add("persons.back", phrase("persons.back").c_str(), ButtonKind::plain, 120)) who.close();
    return taken ? MenuRequest::welder : MenuRequest::none;
}

void personsButton(Context& context, WhoWelds& who, bool atRight) {
    constexpr float kWidth = 100, kMargin = 6; // points
    const std::string name = who.name();
    ShortText text, note;
    if (name.empty())
        appendPhrase(text, "persons.heading", {});
    else
        appendPhrase(text, "persons.welder", {{"name", shortened(name, narrowerThan(context, 480) ? 10 : 24)}});
    appendPhrase(note, "persons.next_tip", {{"key", context.key(Key::n)}});
    if (atRight) {
        const float wide =
            std::max(context.points(kWidth), ImGui::CalcTextSize(text.c_str()).x + 2 * context.points(kMargin));
        const float taken = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x + context.points(14);
        const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
        if (taken + wide <= right) ImGui::SameLine(right - wide);
    }
    if (button(context, "home.persons", text.c_str(), name.empty() ? ButtonKind::plain : ButtonKind::lit, kWidth,
               note.c_str()))
        who.ask();
}

} // namespace meltpool::ui
