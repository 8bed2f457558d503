// The person who welds now, and the home page's question for their name.
#pragma once

#include "app/library/persons.hpp"

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

namespace meltpool {

class WhoWelds {
  public:
    /// `folder`: see Persons. At first the account welds.
    explicit WhoWelds(std::filesystem::path folder) : persons_(std::move(folder)) {}

    const AttemptOwner& welder() const { return welder_; }
    /// Name for menus: the person's, the word for a guest, empty for the account.
    std::string name() const;
    const Persons& persons() const { return persons_; }

    /// Asks for the name on the home page. The field offers the person who was here last, other than the one who welds.
    void ask();
    bool asked() const { return asked_; }
    /// Closes the question without an answer.
    void close() { asked_ = false; }

    /// Answers, which close the question. False if the name is refused: refusal() says why, and the question stays. An
    /// empty field names the account, the word for a guest a guest.
    bool takeTyped();
    bool take(std::string_view name);
    void takePerson(std::size_t index); ///< index in persons().all()
    void takeGuest() { answer({AttemptOwner::Kind::guest, {}}); }
    void takeAccount() { answer({AttemptOwner::Kind::account, {}}); }
    const std::string& refusal() const { return refusal_; }

    /// Returns true once after ask(), so that the field takes the keyboard.
    bool takeOpened() { return std::exchange(opened_, false); }

    std::array<char, 200> typed{}; ///< content of the field, ends with 0
    std::size_t page = 0;          ///< page of the names as last drawn

  private:
    void answer(AttemptOwner welder);

    Persons persons_;
    AttemptOwner welder_;
    bool asked_ = false;
    bool opened_ = false;
    std::string refusal_;
};

} // namespace meltpool
