// Tests the persons who share one account: names, the folder that two programs use, and what a pupil finds of another.
#include "app/library/best_kept.hpp"
#include "app/library/kept_attempts.hpp"
#include "app/library/persons.hpp"
#include "app/session/home.hpp"
#include "app/session/person_settings.hpp"
#include "core/base/error.hpp"
#include "core/base/resources.hpp"
#include "core/base/text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <map>
#include <string>
#include <thread>

namespace meltpool {

namespace {

namespace fs = std::filesystem;

/// Contents of all files of a folder, by path.
std::map<std::string, std::string> filesIn(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        files[fs::relative(entry.path(), folder).generic_string()] =
            entry.is_regular_file() ? readTextFile(entry.path()) : std::string();
    return files;
}

std::string refusalOf(const std::string& name) {
    try {
        return "taken: " + personName(name);
    } catch (const InputError& fault) {
        return fault.what();
    }
}

CueSkill skillOf(int good) {
    CueSkill skill;
    skill.setGood(TechniqueQuantity::travelSpeed, good);
    return skill;
}

/// Attempt of the person who welds, as the window counts it.
void weld(Home& home, double score, int good) {
    home.scores.beginAttempt("gmaw-bead");
    home.scores.offer("gmaw-bead", {score, true});
    home.scores.practise("gmaw-bead", skillOf(good));
}

void enter(Home& home, const std::string& name) {
    REQUIRE(home.who.take(name));
    home.takeScores();
}

} // namespace

TEST_CASE("a name keeps its spaces, umlauts and slashes; one that is empty, too long or unreadable is refused") {
    CHECK(personName("  Anna \t Maria  ") == "Anna Maria");
    CHECK(personName("J\xC3\xBCrgen O'Neill-\xC3\x9Fmann") == "J\xC3\xBCrgen O'Neill-\xC3\x9Fmann");
    CHECK(personName("../../etc/passwd") == "../../etc/passwd");
    CHECK(personName("a\\b:c*?\"<>|") == "a\\b:c*?\"<>|");
    CHECK(personName("CON") == "CON");
    std::string longest;
    for (size_t i = 0; i < kLongestName; ++i)
        longest += "\xC3\xBC"; // letters are counted, not bytes
    CHECK(personName(longest) == longest);
    CHECK(refusalOf("") == "The name is empty; expected 1 to 40 letters.");
    CHECK(refusalOf(" \t\n") == "The name is empty; expected 1 to 40 letters.");
    CHECK_THAT(refusalOf(longest + "x"), test::containsText("has 41 letters; expected 40 at most."));
    CHECK_THAT(refusalOf("a\x1B[31mb"), test::containsText("signs that cannot be shown"));
    CHECK_THAT(refusalOf("\xFF\xFE"), test::containsText("signs that cannot be shown"));
    CHECK_THAT(refusalOf("a\xE2\x80\xAE"
                         "b"),
               test::containsText("signs that cannot be shown"));
    CHECK(sameName("J\xC3\x9CRGEN", "j\xC3\xBCrgen"));
    CHECK_FALSE(sameName("Anna", "Ana"));
}

TEST_CASE("two programs by turns with one folder of persons know each other's names, and a name has one folder") {
    const fs::path folder = test::scratchFolder("persons-two") / "persons";
    Persons one(folder), other(folder);
    CHECK(one.all().empty());
    CHECK_FALSE(fs::exists(folder)); // looking leaves nothing behind
    const KnownPerson anna = one.signIn("Anna");
    const KnownPerson bert = other.signIn("B\xC3\xA9rt / 2");
    CHECK(anna.id != bert.id);
    CHECK(anna.id.size() == 16);
    CHECK(other.signIn("  ANNA ").id == anna.id); // it reads the folder again, and the name stays as typed first
    CHECK(other.find("anna")->name == "Anna");
    one.refresh();
    REQUIRE(one.all().size() == 2);
    CHECK(one.all()[0].id == anna.id); // here last
    CHECK(one.find("b\xC3\x89rt / 2") != nullptr);
    CHECK(one.find("b\xC3\x89rt") == nullptr);
    CHECK(one.scoresFile(anna).parent_path() == folder / anna.id);
    CHECK_THROWS_AS(one.signIn("  "), InputError);
    CHECK(Persons(folder).all().size() == 2);
    CHECK_THROWS_AS(Persons({}).signIn("Anna"), InputError);
}

TEST_CASE("two programs that take one new name at one moment give it one folder") {
    const fs::path folder = test::scratchFolder("persons-moment") / "persons";
    std::array<std::string, 4> ids;
    {
        std::vector<std::jthread> programs;
        for (std::string& id : ids)
            programs.emplace_back([&id, &folder] { id = Persons(folder).signIn("Carla").id; });
    }
    for (const std::string& id : ids)
        CHECK(id == ids.front());
    CHECK(Persons(folder).all().size() == 1);
}

TEST_CASE("a faulty file of a person is reported and left alone; the other persons stay") {
    const fs::path folder = test::scratchFolder("persons-faulty") / "persons";
    Persons persons(folder);
    const KnownPerson anna = persons.signIn("Anna"), bert = persons.signIn("Bert");
    writeTextFileAtomically(folder / anna.id / "person.toml", "name = 5\n");
    fs::create_directories(folder / "notes");
    persons.refresh();
    REQUIRE(persons.all().size() == 1);
    CHECK(persons.all()[0].id == bert.id);
    REQUIRE(persons.faults().size() == 1);
    CHECK_THAT(persons.faults()[0], test::containsText("person.toml:1: "));
    CHECK(persons.signIn("Anna").id != anna.id);
    CHECK(readTextFile(folder / anna.id / "person.toml") == "name = 5\n");
}

TEST_CASE("two pupils by turns at one computer: neither has the other's cues or scores, and a guest leaves no trace") {
    const fs::path folder = test::scratchFolder("persons-turns");
    const fs::path lessons = resourceFolder() / "data" / "lessons";
    Home home(lessons, folder / "best-scores.toml", folder / "persons");
    weld(home, 40, 1); // the account, as before there were names
    enter(home, "Anna");
    CHECK(home.scores.find("gmaw-bead") == nullptr);
    CHECK(home.scores.skill("gmaw-bead") == CueSkill());
    weld(home, 97, CueSkill::kMastered);
    enter(home, "Bert");
    CHECK(home.scores.find("gmaw-bead") == nullptr);
    CHECK(home.scores.skill("gmaw-bead") == CueSkill()); // all cues at full strength
    CHECK(home.standing(*home.find("gmaw-bead")).find("97") == std::string::npos);
    weld(home, 61, 2);

    const auto before = filesIn(folder);
    REQUIRE(home.who.take("guest"));
    home.takeScores();
    CHECK(home.who.welder().kind == AttemptOwner::Kind::guest);
    CHECK(home.scores.find("gmaw-bead") == nullptr);
    weld(home, 99, 3);
    CHECK(home.scores.find("gmaw-bead")->score == 99); // until the next person
    home.who.takeGuest();
    home.takeScores();
    CHECK(home.scores.find("gmaw-bead") == nullptr);
    CHECK(filesIn(folder) == before);

    Home again(lessons, folder / "best-scores.toml", folder / "persons"); // the next start
    CHECK(again.scores.find("gmaw-bead")->score == 40);
    CHECK(again.scores.skill("gmaw-bead") == skillOf(1));
    enter(again, "anna");
    CHECK(again.scores.find("gmaw-bead")->score == 97);
    CHECK(again.scores.skill("gmaw-bead") == skillOf(CueSkill::kMastered));
    enter(again, "Bert");
    CHECK(again.scores.find("gmaw-bead")->score == 61);
    CHECK(again.scores.skill("gmaw-bead") == skillOf(2));
    again.who.takeAccount();
    again.takeScores();
    CHECK(again.scores.find("gmaw-bead")->score == 40);
}

TEST_CASE("text size and hand come and go with the person, and the account has its own again") {
    const fs::path folder = test::scratchFolder("persons-settings");
    float size = 1;
    int hand = 0;
    const ParameterList both{{"interface_size", "Size", "", &size, 0.7, 2, ""},
                             {"hand", "Hand", "", &hand, 0, 1, "", handChoices()}};
    PersonSettings settings;
    settings.use(both);
    CHECK(settings.leave().empty()); // the account has no file here
    CHECK(settings.enter(folder / "anna" / "settings.toml").empty());
    size = 1.5f;
    hand = 1;
    CHECK(settings.leave().empty());
    CHECK(size == 1);
    CHECK(hand == 0);
    CHECK(settings.enter(folder / "bert" / "settings.toml").empty());
    CHECK(size == 1);
    CHECK(settings.leave().empty());
    CHECK(settings.enter({}).empty()); // a guest
    size = 2;
    CHECK(settings.leave().empty());
    CHECK(size == 1);
    CHECK(settings.enter(folder / "anna" / "settings.toml").empty());
    CHECK(size == 1.5f);
    CHECK(hand == 1);
    CHECK(settings.leave().empty());

    PersonSettings atDesk; // without a headset the hand is not in use, and stays as it was
    atDesk.use({both.front()});
    CHECK(atDesk.enter(folder / "anna" / "settings.toml").empty());
    size = 1.25f;
    CHECK(atDesk.leave().empty());
    CHECK_THAT(readTextFile(folder / "anna" / "settings.toml"),
               test::containsText("hand = \"left\"") && test::containsText("interface_size = 1.25"));
}

} // namespace meltpool
