// The persons who weld at this computer. Each has a folder for best scores and settings, so that one account serves
// many.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool {

inline constexpr std::size_t kLongestName = 40; ///< letters of a person's name

struct KnownPerson {
    std::string id;   ///< name of the person's folder, 16 hexadecimal digits; recordings hold it next to the name
    std::string name; ///< as the person typed it first
    std::string seen; ///< moment when the name was last chosen, see utcText()
};

/// Owner of the next attempts.
struct AttemptOwner {
    enum class Kind {
        account, ///< the account of the computer, without a name
        person,
        guest ///< leaves nothing behind
    };
    Kind kind = Kind::account;
    KnownPerson person = {}; ///< empty unless kind is `person`
};

/// A typed name without blanks at its ends, and with single ones inside. Throws InputError with one sentence for a name
/// that is empty, longer than kLongestName, or has signs that cannot be shown.
std::string personName(std::string_view typed);

/// True if both name one person: A to Z and the letters of Latin-1 may be capitals in one and small in the other.
bool sameName(std::string_view a, std::string_view b);

/// Folder of the user's persons. It need not exist.
std::filesystem::path personsFolder();

/// Persons in a folder. Other programs may use the folder too, on other machines: signIn() reads it again.
class Persons {
  public:
    /// Reads `folder`; a missing one has no persons. An empty path has no place for names: signIn() then throws.
    explicit Persons(std::filesystem::path folder);

    /// Reads the folder again. Never throws: a faulty file is left alone and reported in faults().
    void refresh();
    /// Persons, the one who was here last first.
    const std::vector<KnownPerson>& all() const { return all_; }
    /// A sentence for each person's file that cannot be used.
    const std::vector<std::string>& faults() const { return faults_; }
    /// Person of a name; null if the folder has none.
    const KnownPerson* find(std::string_view name) const;

    /// Person of a name, who gets a folder if the name is new, and is here last from now on. Throws InputError as
    /// personName() does, and whatever FileTurn and writeFile() throw.
    KnownPerson signIn(std::string_view name);

    /// Files of a person; they need not exist.
    std::filesystem::path scoresFile(const KnownPerson& person) const;
    std::filesystem::path settingsFile(const KnownPerson& person) const;

  private:
    std::filesystem::path folder_;
    std::vector<KnownPerson> all_;
    std::vector<std::string> faults_;
};

} // namespace meltpool
