// Tests the running menus, the window's sizes, shader reload, and pictures of every screen, mode and material.
#include "core/base/image.hpp"
#include "core/base/text.hpp"
#include "tests/desktop/driven/driver.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/places.hpp"

#include <csignal>
#include <set>

namespace meltpool::test {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// Controls in the menus' order, from top to bottom: numbers with a slider to pull, and switches to click.
struct Control {
    const char* name;
    bool isSwitch = false;
};
const std::vector<Control> kViewControls{{"view.point_size"},
                                         {"view.show_box", true},
                                         {"view.show_sky", true},
                                         {"view.show_source", true},
                                         {"view.ambient"},
                                         {"view.diffuse"},
                                         {"view.specular"},
                                         {"view.shininess"},
                                         {"view.exposure"},
                                         {"surface.influence"},
                                         {"surface.iso_level"},
                                         {"surface.caps", true},
                                         {"controls.source_step"},
                                         {"controls.source_mouse_speed"},
                                         {"controls.look_speed"},
                                         {"controls.camera_speed"},
                                         {"controls.invert_look", true}};
const std::vector<std::string> kSimulationNumbers{
    "simulation.heat_radius",        "simulation.heat_temperature", "simulation.viscosity",
    "simulation.gas_stiffness",      "simulation.rest_density",     "simulation.particle_mass",
    "simulation.support_radius",     "simulation.solidify_rate",    "simulation.wall_restitution",
    "simulation.acceleration_limit", "simulation.time_step"};

std::string valueOf(const json& state, const std::string& name) {
    const size_t dot = name.find('.');
    return parameterIn(state, name.substr(0, dot), name.substr(dot + 1));
}

/// Acts until the value changes.
void changes(TrainerWindow& window, const std::string& name, const std::function<void()>& act) {
    const size_t dot = name.find('.');
    window.change(name.substr(0, dot), name.substr(dot + 1), act);
}

size_t colourCount(const Image& image) {
    std::set<unsigned> colours;
    for (size_t i = 0; i + 2 < image.rgb.size(); i += 3)
        colours.insert(image.rgb[i] * 65536u + image.rgb[i + 1] * 256u + image.rgb[i + 2]);
    return colours.size();
}

} // namespace

TEST_CASE("everything in the view menu is live") {
    TrainerWindow window("view-menu", {});
    window.start();
    window.key("F3");
    window.click("bar.view");
    for (const char* folded : {"view.group.Light", "surface.group.Expert: surface", "controls.group.Mouse and keys"})
        window.click(folded);
    for (const Control& control : kViewControls) {
        INFO(control.name);
        changes(window, control.name,
                [&] { control.isSwitch ? window.click(control.name) : window.pull(control.name, 0.75); });
    }
    for (const char* mode : {"wireframe", "points", "surface"})
        changes(window, "view.mode", [&] { window.click(std::string("view.mode.") + mode); });
    CHECK(window.settle().at("metal").at("stopped") == false);
    changes(window, "view.ambient", [&] { window.click("view.ambient.back"); });
    CHECK(valueOf(window.settle(), "view.ambient") == "0.4");
}

TEST_CASE("the picture is as coarse as the view menu says, the window tells, and the next start remembers") {
    TrainerWindow window("picture-level", {.settings = kSmallSettings});
    window.start();
    window.key("F3");
    window.click("bar.view");
    window.click("window.group.Window");
    for (const auto& [level, told] :
         {std::pair("coarse", "coarsest picture"), {"full", ""}, {"medium", "coarser picture"}}) {
        changes(window, "window.picture", [&, name = level] { window.click(std::string("window.picture.") + name); });
        CHECK(window.settle().at("picture") == told);
    }
    window.process().signal(SIGTERM);
    CHECK(window.finish() == 0);
    CHECK_THAT(readTextFile(window.settingsFile()), containsText("picture = \"medium\""));
}

TEST_CASE("everything in the machine menu and its expert drawer is live") {
    TrainerWindow window("simulation-menu", {});
    window.start();
    CHECK_FALSE(window.settle().at("places").contains("simulation.viscosity")); // only in the expert drawer
    window.click("simulation.group.Expert");
    for (const std::string& name : kSimulationNumbers) {
        INFO(name);
        changes(window, name, [&] { window.pull(name, 0.62); });
        window.click(name + ".back");
    }
    changes(window, "simulation.wall_slip", [&] { window.click("simulation.wall_slip"); });
    const auto [left, top, width, height] = window.place("simulation.gravity");
    changes(window, "simulation.gravity", [&, x = left + width / 2, y = top + height / 2] {
        window.moveMouse(x, y);
        window.settle();
        window.xdotool({"mousedown", "1"});
        window.settle();
        window.moveMouse(x + 60, y);
        window.settle();
        window.xdotool({"mouseup", "1"});
    });
}

TEST_CASE("the timings panel names the passes, the help page opens and closes by mouse") {
    TrainerWindow window("timings", {});
    window.start();
    window.click("bar.timings");
    const json s = window.waitFor("GPU passes", [](const json& t) { return t.at("passes").size() > 4; });
    CHECK(s.at("frames_per_second") > 0);
    window.click("bar.help");
    window.waitFor("help", [](const json& t) { return t.at("panels").at("help") == true; });
    window.takePicture("help");
    window.click("help.close");
    window.waitFor("no help", [](const json& t) { return t.at("panels").at("help") == false; });
}

TEST_CASE(
    "the detail is low without a graphics card, as the view menu says where it is set, and the next start remembers") {
    TrainerWindow window("detail", {.settings = "[start]\nparticles = 1000\ncells = 16\n[view]\nshow_sky = false\n"
                                                "[window]\nwidth = 960\nheight = 640\n"});
    window.start();
    const auto beside = [](const json& s) { return s.at("steps_beside") == true; };
    window.waitFor("steps beside the picture at low detail", beside);
    window.key("F4"); // the timings panel shows each pass alone
    window.waitFor("steps before the picture", [&](const json& s) { return !beside(s); });
    window.key("F4");
    window.waitFor("steps beside the picture again", beside);
    window.key("F3");
    window.click("bar.view");
    window.click("window.group.Window");
    CHECK(valueOf(window.settle(), "window.detail") == "automatic");
    changes(window, "window.detail", [&] { window.click("window.detail.high"); });
    window.waitFor("steps beside the picture at high detail", beside);
    for (const char* level : {"low", "medium"})
        changes(window, "window.detail", [&] { window.click(std::string("window.detail.") + level); });
    window.takePicture("medium-detail");
    window.process().signal(SIGTERM);
    CHECK(window.finish() == 0);
    CHECK_THAT(readTextFile(window.settingsFile()), containsText("detail = \"medium\""));
}

TEST_CASE("F12 saves the metal without panels, as large as fits into 4K in the window's shape; F10 the window") {
    TrainerWindow window("large-picture", {.settings = kSmallSettings});
    window.start();
    const auto pixels = window.state().at("window").at("pixels").get<std::array<int, 2>>();
    const Image small = readPng(window.takePicture("window"));
    CHECK(small.width == pixels[0]);
    CHECK(small.height == pixels[1]);
    const std::string before = window.state().at("screenshot");
    window.key("F12");
    const json now = window.waitFor("the large picture", [&](const json& s) { return s.at("screenshot") != before; });
    const fs::path file = now.at("screenshot").get<std::string>();
    const Image large = readPng(file);
    fs::copy_file(file, test::buildFolder() / "desktop-pictures" / "large.png", fs::copy_options::overwrite_existing);
    CHECK((large.width == 3840 || large.height == 2160));
    CHECK(large.width <= 3840);
    CHECK(large.height <= 2160);
    CHECK(double(large.width) / large.height == Approx(double(pixels[0]) / pixels[1]).epsilon(1e-3));
    CHECK(window.state().at("page") == "running");
}

TEST_CASE("the window can be resized and goes full screen and back") {
    TrainerWindow window("resize", {});
    window.start();
    for (const auto& [width, height] : {std::pair{1400, 900}, {700, 500}, {1001, 777}}) {
        window.xdotool({"search", "--name", "^Meltpool$", "windowsize", std::to_string(width), std::to_string(height)});
        window.waitFor("the new size", [w = width, h = height](const json& s) {
            return s.at("window").at("pixels") == json({w, h}) && s.at("places").contains("bar.help");
        });
        const Image picture = readPng(window.takePicture("resized"));
        CHECK(picture.width == width);
        CHECK(picture.height == height);
        // The bar's last button is at the new right edge.
        const auto place = window.state().at("places").at("bar.help").get<std::array<double, 4>>();
        CHECK(place[0] + place[2] == Approx(width - 14).margin(8));
    }
    window.key("F11");
    window.waitFor("full screen", [](const json& s) { return s.at("window").at("size") == json({1600, 1000}); });
    window.key("F11");
    window.waitFor("the window again", [](const json& s) { return s.at("window").at("size") == json({1001, 777}); });
}

TEST_CASE("on a screen of double density everything is twice as large") {
    VirtualDisplay dense(192);
    TrainerWindow window("density",
                         {.settings = "[start]\nparticles = 1000\ncells = 16\n[window]\nwidth = 1500\nheight = 960\n",
                          .display = &dense});
    CHECK(window.state().at("window").at("scale") == 2.0);
    window.takePicture("double-density-start");
    window.start();
    CHECK(window.place("bar.reset")[2] == Approx(192));
    window.takePicture("double-density");
}

TEST_CASE("a changed shader is taken over; a broken one is told and the old one runs on until it is mended") {
    const fs::path share = scratchFolder("shader-copy");
    const fs::path source = test::buildFolder() / "share" / "meltpool";
    fs::copy(fs::canonical(source / "shaders"), share / "shaders", fs::copy_options::recursive);
    fs::create_directory_symlink(fs::canonical(source / "data"), share / "data");
    TrainerWindow window("shaders", {.arguments = {"--watch-shaders"}, .data = share});
    window.start();
    const fs::path shader = share / "shaders" / "render" / "box.frag";
    const std::string good = readTextFile(shader);
    const auto write = [&](const std::string& text, int seconds) {
        writeTextFileAtomically(shader, text);
        fs::last_write_time(shader, fs::file_time_type::clock::now() + std::chrono::seconds(seconds));
    };
    write(good + "\nthis is no shader\n", 5);
    const auto told = [](const json& s) { return s.at("messages").dump().find("box.frag") != std::string::npos; };
    window.waitFor("the fault on the screen", told);
    const auto steps = window.settle().at("metal").at("steps").get<int>();
    window.takePicture("shader-fault");
    window.waitFor("the metal to run on",
                   [&](const json& s) { return s.at("metal").at("steps").get<int>() > steps + 3; });
    write(good, 10);
    window.waitFor("the fault to go", [&](const json& s) { return !told(s); });
}

TEST_CASE("pictures of every screen, render mode, colour and material from the running window") {
    TrainerWindow window("pictures", {.settings = "[start]\nparticles = 8192\n[simulation]\nsolidify_rate = 0.001\n"
                                                  "[window]\nwidth = 1280\nheight = 720\n"});
    const Image first = readPng(window.takePicture("start-menu"));
    CHECK(colourCount(first) > 300);
    window.start();
    for (int i = 0; i < 8; ++i)
        window.key("Next");
    for (int i = 0; i < 10; ++i)
        window.key("Up");
    window.moveMouse(300, 400);
    window.xdotool({"mousedown", "1"});
    window.waitFor("a molten corner", [](const json& s) {
        return s.at("metal").at("molten") > 150 && s.at("metal").at("hottest") > 0.95;
    });
    window.xdotool({"mouseup", "1"});
    window.takePicture("simulation-menu");
    window.key("v");
    window.waitFor("view mode", [](const json& s) { return s.at("mode") == "view"; });
    window.key("F3");
    window.key("F2");
    window.waitFor("the view menu", [](const json& s) { return s.at("panels").at("view") == true; });
    window.moveMouse(900, 400);
    window.settle();

    std::vector<std::pair<std::string, Image>> taken;
    const auto take = [&](const std::string& group, const std::string& choice) {
        window.click("view." + group + "." + choice);
        window.waitFor(choice, [&](const json& s) { return parameterIn(s, "view", group) == choice; });
        window.moveMouse(900, 400);
        // The picture's glide next to a panel has ended, so that only the choice makes the difference.
        for (int i = 0; i < 4; ++i)
            window.settle();
        taken.emplace_back(choice, readPng(window.takePicture(group + "-" + choice)));
    };
    for (const char* material : {"copper", "gold", "wax", "ice", "solder"})
        take("material", material);
    for (const char* colours : {"temperature", "even", "grey"})
        take("colours", colours);
    window.click("view.colours.material");
    for (const char* mode : {"wireframe", "points"})
        take("mode", mode);
    for (size_t i = 0; i < taken.size(); ++i)
        for (size_t j = i + 1; j < taken.size(); ++j) {
            INFO(taken[i].first << " and " << taken[j].first);
            CHECK(compareImages(taken[i].second, taken[j].second, 24).farPixels > 0.01);
        }
}

} // namespace meltpool::test
