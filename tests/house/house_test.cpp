// The rules of the source tree: permitted includes, units per folder, lengths of functions, sizes of classes, named
// members of blocks that C++ and GLSL share, and questions to a process's traits.
#include "tests/house/source_scan.hpp"
#include "tests/house/thermometers.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/places.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace meltpool {

namespace {

using test::SourceFile;

constexpr int kMostUnits = 50;
constexpr int kMostLines = 70;
constexpr int kMostPublicFunctions = 40;
constexpr int kMostMembers = 30;

/// A class beyond the bounds, with the counts permitted until it is divided. The counts only ever decrease.
struct LargeClass {
    std::string_view name;
    int publicFunctions;
    int members;
};

constexpr std::array<LargeClass, 0> kLargeClasses{};

/// True for a record of values without functions, such as WeldStation. More values do not give it more jobs.
bool isRecord(const test::ClassSize& size) {
    return size.publicFunctions == 0;
}

bool isBeyond(const test::ClassSize& size) {
    return size.publicFunctions > kMostPublicFunctions || (!isRecord(size) && size.members > kMostMembers);
}

const std::vector<SourceFile>& programSources() {
    static const std::vector<SourceFile> files =
        test::readSources(test::sourceFolder(), {"core", "xr", "app"}, {".cpp", ".hpp"});
    return files;
}

const std::vector<SourceFile>& shaderSources() {
    static const std::vector<SourceFile> files =
        test::readSources(test::sourceFolder(), {"shaders"}, {".comp", ".vert", ".frag", ".geom", ".glsl", ".h"});
    return files;
}

/// Returns the layer of a file: "core/metal" for "core/metal/heat/x.cpp", "app" for "app/desktop/x.cpp".
std::string floorOf(const std::string& path) {
    const size_t first = path.find('/');
    if (first == std::string::npos || path.compare(0, 5, "core/") != 0) return path.substr(0, first);
    return path.substr(0, path.find('/', first + 1));
}

/// The layers that each layer may include apart from itself; app may include all.
const std::map<std::string, std::set<std::string>>& floorsBelow() {
    static const std::map<std::string, std::set<std::string>> below{
        {"core/base", {}},
        {"core/gl", {"core/base"}},
        {"core/metal", {"core/base", "core/gl"}},
        {"core/weld", {"core/base", "core/gl", "core/metal"}},
        {"core/validation", {"core/base", "core/gl", "core/metal", "core/weld"}},
        {"core/surface", {"core/base", "core/gl", "core/metal"}},
        {"core/render", {"core/base", "core/gl", "core/metal", "core/weld", "core/surface"}},
        {"core/scene", {"core/base", "core/gl", "core/metal", "core/weld", "core/surface", "core/render"}},
        {"core/training",
         {"core/base", "core/gl", "core/metal", "core/weld", "core/surface", "core/render", "core/scene"}},
        {"xr", {"core/base", "core/gl"}}};
    return below;
}

bool mayInclude(const std::string& from, const std::string& included) {
    if (from == included || from == "app" || included == "shaders") return true;
    const auto below = floorsBelow().find(from);
    return below != floorsBelow().end() && below->second.count(included) > 0;
}

std::string place(const SourceFile& file, int line) {
    return file.path.generic_string() + ":" + std::to_string(line);
}

/// Includes between folders, with the file and line of one such include.
using FolderGraph = std::map<std::string, std::map<std::string, std::string>>;

FolderGraph folderGraph(const std::vector<SourceFile>& files) {
    FolderGraph graph;
    for (const SourceFile& file : files)
        for (const test::Include& include : test::findIncludes(file.text)) {
            const std::string from = file.path.parent_path().generic_string();
            const std::string to = std::filesystem::path(include.path).parent_path().generic_string();
            if (from != to) graph[from].emplace(to, place(file, include.line) + " includes \"" + include.path + "\"");
        }
    return graph;
}

/// Finds a cycle of includes that begins at `folder`, by depth first search; its result is empty without one.
class CircleSearch {
  public:
    explicit CircleSearch(const FolderGraph& graph) : graph_(graph) {}

    std::vector<std::string> from(const std::string& folder) {
        visited_.clear();
        way_.clear();
        start_ = folder;
        return reaches(folder) ? way_ : std::vector<std::string>();
    }

  private:
    bool reaches(const std::string& folder) {
        const auto node = graph_.find(folder);
        if (node == graph_.end()) return false;
        for (const auto& [next, include] : node->second) {
            way_.push_back(include);
            if (next == start_) return true;
            if (visited_.insert(next).second && reaches(next)) return true;
            way_.pop_back();
        }
        return false;
    }

    const FolderGraph& graph_;
    std::string start_;
    std::set<std::string> visited_;
    std::vector<std::string> way_;
};

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines)
        text += "\n    " + line;
    return text;
}

} // namespace

TEST_CASE("the scanner finds includes with their lines") {
    const auto includes = test::findIncludes("#pragma once\n#include <a.hpp>\n  # include \"core/x.hpp\" // why\n");
    REQUIRE(includes.size() == 1);
    CHECK(includes[0].line == 3);
    CHECK(includes[0].path == "core/x.hpp");
}

TEST_CASE("the scanner measures functions of C++ and GLSL") {
    const auto lines = [](std::string_view text) {
        std::vector<int> lengths;
        for (const auto& function : test::findFunctions(text))
            lengths.push_back(function.lines);
        return lengths;
    };
    CHECK(lines("int f() {\n    return 1;\n}\n") == std::vector{3});
    CHECK(lines("int f();\nint x = g();\n").empty());
    CHECK(lines("namespace a {\nstruct B {\n    int g() const { return 1; }\n    int h;\n};\n}\n") == std::vector{1});
    CHECK(lines("std::string\nlong_(int a,\n      int b = 2) {\n    if (a) {\n    }\n}\n") == std::vector{6});
    CHECK(lines("A::A() : a{1}, b(2), c{} {\n    f();\n}\nint g() {\n}\n") == std::vector{3, 2});
    CHECK(lines("bool operator==(A a, B b) {\n    return true;\n}\n") == std::vector{3});
    CHECK(lines("void f() {\n    auto g = [](int i) {\n        return i;\n    };\n}\n") == std::vector{5});
    CHECK(lines("const std::array<int, 2> a{\n    f(1), f(2)};\n").empty());
    CHECK(lines("const A a = {\n    f(1), {f(2)}};\n").empty());
    CHECK(lines("template <class T = int>\nvoid f(T t) {\n}\n") == std::vector{3});
    CHECK(lines("layout(std430, binding = 1) buffer A { uint a[]; };\nvoid main() {\n}\n") == std::vector{2});
    CHECK(lines("// f() {\n/* g() {\n*/ #define X {\nconst char* a = \"h() {\"; char b = '{';\n").empty());
    CHECK(lines("#define F() {\\\n  {\nint f() {\n    int i = 1'000;\n}\n") == std::vector{3});
    CHECK(lines("const char* a = R\"x(f() {\")x\";\nint f() {\n}\n") == std::vector{2});
    CHECK(lines("for_each(int i) noexcept -> std::vector<int> {\n}\n") == std::vector{2});

    std::string text = "// why\n\nvoid tooLong(int i) {\n";
    for (int line = 0; line < kMostLines; ++line)
        text += "    if (i) { f(); }\n";
    const auto functions = test::findFunctions(text + "}\n");
    REQUIRE(functions.size() == 1);
    CHECK(functions[0].line == 3);
    CHECK(functions[0].lines == kMostLines + 2);
    CHECK(functions[0].head == "void tooLong(int i) ");
}

TEST_CASE("the scanner counts public functions and members of classes") {
    struct Counts {
        std::string name;
        int functions, members;
        bool operator==(const Counts& other) const {
            return name == other.name && functions == other.functions && members == other.members;
        }
    };
    const auto classes = [](std::string_view text) {
        std::vector<Counts> counts;
        for (const test::ClassSize& size : test::findClasses(text))
            counts.push_back({size.name, size.publicFunctions, size.members});
        return counts;
    };
    using Found = std::vector<Counts>;
    CHECK(classes("class A {\n    int f();\n  public:\n    A();\n    int g() const { return x_; }\n  private:\n"
                  "    void h() {}\n    int x_ = 0, y_{1};\n};\n") == Found{{"A", 2, 2}});
    CHECK(classes("struct A : B<int> {\n    int a;\n    virtual void f() = 0;\n};\n") == Found{{"A", 1, 1}});
    CHECK(classes("class A final : public B {\n  protected:\n    int f();\n};") == Found{{"A", 0, 0}});
    // Parentheses and commas outside functions and member lists do not count.
    CHECK(classes("struct A {\n    std::function<void(int, int)> a;\n    std::map<int, B<C>> b = f(1, 2);\n"
                  "    int (*c)(int);\n    std::function<int()> d{};\n    glm::vec3 e{1, f(2), 3};\n"
                  "    alignas(16) int g;\n    unsigned h : 3;\n};\n") == Found{{"A", 0, 7}});
    // Members that belong to no object, or that no object may use, do not count.
    CHECK(classes("struct A {\n    static constexpr int a = f(1);\n    static int b;\n    using C = int;\n"
                  "    friend bool operator==(A, A) = default;\n    friend void g(A) {}\n    class D;\n"
                  "    enum class E { one, two };\n    A(const A&) = delete;\n    static A make();\n};\n") ==
          Found{{"A", 1, 0}});
    CHECK(classes(
              "struct A {\n    bool operator<(const std::vector<int>& b) const;\n    explicit operator bool() const {\n"
              "        return true;\n    }\n    bool operator()(int) const;\n};\n") == Found{{"A", 3, 0}});
    CHECK(classes("struct A {\n    A(int a) : b{a}, c(f({1})) {\n        if (a) { g(); }\n    }\n    void f(B b = {}, "
                  "int = 3);\n"
                  "    int b, c;\n};\n") == Found{{"A", 2, 2}});
    CHECK(classes("namespace a {\ntemplate <class T, int N = 3>\nclass A {\n  public:\n    template <class U>\n    "
                  "void f(U u) {}\n"
                  "};\n}\nstruct B::C {\n    int a;\n};\n") == Found{{"A", 1, 0}, {"B::C", 0, 1}});
    // Nested types count for themselves.
    CHECK(classes("class A {\n    struct B {\n        int c;\n    };\n    struct {\n        int d;\n    } e, f;\n    "
                  "enum { g } h;\n"
                  "    union U {\n        int i;\n        float j;\n    };\n};\n") ==
          Found{{"A::B", 0, 1}, {"A::(unnamed)", 0, 1}, {"A::U", 0, 2}, {"A", 0, 3}});
    CHECK(
        classes("enum class A : int { one };\nvoid f() {\n    struct Inside {\n        int a;\n    };\n}\nstruct B;\n")
            .empty());

    const auto sizes = test::findClasses("// why\n\nclass A\n{\n    int a;\n};\n");
    REQUIRE(sizes.size() == 1);
    CHECK(sizes[0].line == 4);
}

TEST_CASE("the scanner finds vectors whose components mean different things") {
    CHECK(test::findMixedVectors("vec4 origin; // xyz position, w spacing\nvec3 a; // metres\n") == std::vector{1});
    CHECK(test::findMixedVectors("\nuniform vec2 still; ///< x: cells, y: share\n") == std::vector{2});
    CHECK(test::findMixedVectors("layout(location = 1) out vec2 s; // x shine, y dullness\n") == std::vector{1});
    CHECK(test::findMixedVectors("vec3 origin; ///< low corner, x along the seam\n").empty());
    CHECK(test::findMixedVectors("ivec3 tiles; // 4 x 4 cells each\nfloat w; // x and y\n").empty());
}

TEST_CASE("the search finds circles of folders of any length") {
    FolderGraph graph{{"a", {{"b", "1"}}}, {"b", {{"c", "2"}, {"d", "3"}}}, {"d", {{"a", "4"}}}};
    CircleSearch search(graph);
    CHECK(search.from("a") == std::vector<std::string>{"1", "3", "4"});
    CHECK(search.from("c").empty());
    graph.at("d").clear();
    CHECK(search.from("a").empty());
}

TEST_CASE("window and headset meet in app/session only") {
    for (const SourceFile& file : programSources())
        for (const test::Include& include : test::findIncludes(file.text)) {
            const std::string path = file.path.generic_string();
            INFO(place(file, include.line) << " includes \"" << include.path << "\"");
            CHECK_FALSE((path.starts_with("app/desktop/") && include.path.starts_with("app/headset/")));
            CHECK_FALSE((path.starts_with("app/headset/") && include.path.starts_with("app/desktop/")));
        }
}

TEST_CASE("nothing includes upward") {
    CHECK_FALSE(mayInclude("core/metal", "core/weld"));
    CHECK_FALSE(mayInclude("core/training", "xr"));
    CHECK_FALSE(mayInclude("xr", "core/weld"));
    REQUIRE(programSources().size() > 100);
    for (const SourceFile& file : programSources())
        for (const test::Include& include : test::findIncludes(file.text)) {
            const std::string from = floorOf(file.path.generic_string()), to = floorOf(include.path);
            INFO(place(file, include.line) << ": " << from << " includes " << to);
            CHECK(mayInclude(from, to));
        }
}

TEST_CASE("no folders include each other") {
    const FolderGraph graph = folderGraph(programSources());
    CircleSearch search(graph);
    for (const auto& [folder, included] : graph) {
        const std::vector<std::string> circle = search.from(folder);
        INFO(folder << " is part of a circle of includes:" << joined(circle));
        CHECK(circle.empty());
    }
}

TEST_CASE("no folder holds more than 50 units") {
    for (const auto& [folder, units] : test::unitsOfFolders(programSources())) {
        INFO(folder << " holds " << units << " units");
        CHECK(units <= kMostUnits);
    }
}

TEST_CASE("no class has more than 40 public functions, and none with functions more than 30 members") {
    CHECK_FALSE(isBeyond({1, "Record", 0, kMostMembers + 1}));
    CHECK(isBeyond({1, "A", 1, kMostMembers + 1}));
    const std::vector<test::LocatedClass> classes = test::classesOf(programSources());
    CHECK(classes.size() > 500);
    for (const test::LocatedClass& each : classes) {
        const test::ClassSize& size = each.size;
        const auto large = std::find_if(kLargeClasses.begin(), kLargeClasses.end(),
                                        [&](const LargeClass& known) { return known.name == size.name; });
        const bool listed = large != kLargeClasses.end();
        INFO(each.place << ": " << size.name << " has " << size.publicFunctions << " public functions and "
                        << size.members << " members" << (listed ? "; a class of kLargeClasses may only shrink" : ""));
        CHECK(size.publicFunctions <= std::max(kMostPublicFunctions, listed ? large->publicFunctions : 0));
        if (isRecord(size)) continue;
        CHECK(size.members <= std::max(kMostMembers, listed ? large->members : 0));
    }
}

TEST_CASE("the list of large classes holds no class that has become small") {
    const std::vector<test::LocatedClass> classes = test::classesOf(programSources());
    for (const LargeClass& large : kLargeClasses) {
        INFO(large.name << " is within the bounds or gone: take it off kLargeClasses");
        CHECK(std::any_of(classes.begin(), classes.end(), [&](const test::LocatedClass& each) {
            return each.size.name == large.name && isBeyond(each.size);
        }));
    }
}

TEST_CASE("no function is longer than 70 lines") {
    std::vector<SourceFile> files = programSources();
    files.insert(files.end(), shaderSources().begin(), shaderSources().end());
    const auto tests = test::readSources(test::sourceFolder(), {"tests"}, {".cpp", ".hpp"});
    files.insert(files.end(), tests.begin(), tests.end());
    size_t functions = 0;
    for (const SourceFile& file : files)
        for (const test::FunctionLength& function : test::findFunctions(file.text)) {
            if (function.head.rfind("TEST_CASE", 0) == 0) continue; // a test case is a list of checks
            ++functions;
            INFO(place(file, function.line) << ": " << function.head << "has " << function.lines << " lines");
            CHECK(function.lines <= kMostLines);
        }
    CHECK(functions > 1000);
}

TEST_CASE("tests are left out by [long] and [by_hand], for Catch2 2 and 3 hide tests differently") {
    int cases = 0;
    for (const SourceFile& file : test::readSources(test::sourceFolder(), {"tests"}, {".cpp"})) {
        std::istringstream lines(file.text);
        int number = 0;
        for (std::string line; std::getline(lines, line);) {
            ++number;
            if (line.rfind("TEST_CASE", 0) != 0) continue;
            ++cases;
            const bool hidden = line.find("\"[.") != std::string::npos || line.find("][.") != std::string::npos;
            INFO(file.path.generic_string() << ":" << number << ": " << line << "; expected the tag [by_hand]");
            CHECK_FALSE(hidden);
        }
    }
    CHECK(cases > 1000);
}

TEST_CASE("nothing outside core/weld/process asks which process it is: others ask the traits") {
    const std::regex question(R"((\.|->)is<[A-Z]\w*>\(\))");
    REQUIRE(std::regex_search("if (process.is<Gmaw>()) return;", question));
    for (const SourceFile& file : programSources()) {
        if (file.path.parent_path() == "core/weld/process") continue;
        const std::sregex_iterator begin(file.text.begin(), file.text.end(), question);
        INFO(file.path << ": see core/weld/process/process_traits.hpp");
        CHECK(std::distance(begin, std::sregex_iterator()) == 0);
    }
}

TEST_CASE("shared blocks and shaders name their quantities instead of giving components meanings") {
    for (const SourceFile& file : shaderSources())
        for (const int line : test::findMixedVectors(file.text)) {
            INFO(place(file, line) << ": one vector carries different quantities");
            CHECK(line == 0);
        }
}

} // namespace meltpool
