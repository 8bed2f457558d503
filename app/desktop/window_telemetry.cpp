#include "app/desktop/window_telemetry.hpp"

#include "app/platform/call_counters.hpp"
#include "core/base/error.hpp"
#include "core/base/output_file.hpp"

#include <nlohmann/json.hpp>

namespace meltpool {

namespace {

using nlohmann::json;

constexpr double kRowSeconds = 0.05;

json numbers(const glm::vec3& v) {
    return {v.x, v.y, v.z};
}

json camera(const Controls& controls) {
    const OrbitCamera& orbit = controls.orbitCamera();
    const FreeCamera& free = controls.freeCamera();
    return {{"eye", numbers(controls.eye())}, {"forward", numbers(controls.forward())},
            {"azimuth", orbit.azimuth()},     {"elevation", orbit.elevation()},
            {"distance", orbit.distance()},   {"yaw", free.yaw()},
            {"pitch", free.pitch()},          {"free_position", numbers(free.position())}};
}

/// Torch of the last step, mm in the workpiece's frame.
json torch(const TorchSample& torch) {
    json object{{"tip_mm", numbers(torch.tip * 1000.0f)}, {"axis", numbers(torch.axis())}, {"trigger", torch.trigger}};
    if (torch.rod) object["rod_mm"] = numbers(torch.rod->tip * 1000.0f);
    return object;
}

json metal(const TelemetryRow& row) {
    const LessonFigures& f = row.figures;
    return {{"time", f.time},     {"steps", row.steps},   {"particles", f.particles},
            {"molten", f.molten}, {"hottest", f.hottest}, {"stopped", f.stopped},
            {"lost", f.lost},     {"refused", f.refused}, {"speed", f.speed}};
}

json parameters(const TelemetryRow& row) {
    json all = json::object();
    for (const ParameterSection* section : row.sections)
        for (const Parameter& p : section->parameters)
            all[section->name][std::string(p.key)] = parameterText(p);
    return all;
}

json places(const ui::Context& context) {
    json all = json::object();
    for (const auto& [name, place] : context.places)
        if (context.shown(place)) all[name] = {place.x, place.y, place.width, place.height};
    return all;
}

json tip(const TipStatus& status) {
    return {{"action", status.action},       {"ahead_mm", status.aheadMm},  {"nearest_mm", status.nearestMm},
            {"liquid", status.liquid},       {"touching", status.touching}, {"amplitude", status.amplitude},
            {"frequency", status.frequency}, {"touches", status.touches},   {"pulses", status.pulses}};
}

json headset(const HeadsetStatus& status) {
    json places = json::object();
    for (const auto& [name, place] : status.places)
        places[name] = {place.x, place.y, place.width, place.height};
    return {{"state", status.state},
            {"mode", status.mode},
            {"mirrored", status.mirrored},
            {"tip_report", status.tipReport},
            {"warning", status.warning},
            {"notice", status.notice},
            {"notice_at", numbers(status.noticeAt)},
            {"end_at", numbers(status.endAt)},
            {"openings", status.openings},
            {"tracked", status.tracked},
            {"panel", status.panel},
            {"panel_pose",
             {status.panelAt.x, status.panelAt.y, status.panelAt.z, status.panelTurn.w, status.panelTurn.x,
              status.panelTurn.y, status.panelTurn.z}},
            {"tip", tip(status.tip)},
            {"trigger_locked", status.triggerLocked},
            {"display_hz", status.displayHz},
            {"busy_ms", status.busyMs},
            {"places", places}};
}

/// Processor time of the work, ms.
json frameWork(const FrameMeter& meter, FrameWork work) {
    return {{"last", meter.lastMs(work)}, {"least", meter.leastMs(work)}, {"median", meter.medianMs(work)}};
}

/// Costs of a frame. `counted`: call counters are loaded; without them the values that only they see are left out.
json frameCosts(const FrameMeter& meter, bool counted) {
    const FrameMeter::Totals& totals = meter.totals();
    json costs{{"frames", totals.frames},
               {"counted", counted},
               {"own_ms", frameWork(meter, FrameWork::own)},
               {"runtime_cpu_ms", frameWork(meter, FrameWork::runtime)},
               {"outside_ms", frameWork(meter, FrameWork::outside)},
               {"runtime_ms", meter.lastMs(WorkPlace::runtime)},
               {"waiting_ms", meter.lastMs(WorkPlace::waiting)}};
    if (!counted) return costs;
    costs["driver_ms"] = meter.lastMs(WorkPlace::driver);
    costs["allocations"] = totals.allocations;
    costs["allocating_frames"] = totals.framesThatAllocated;
    costs["stalls"] = totals.stalls;
    costs["last_stall"] = totals.lastStall;
    return costs;
}

/// First lines of the result panel; null without a judgement.
json judgement(const std::optional<JudgedAttempt>& judged) {
    if (!judged) return nullptr;
    json cures = json::array();
    for (const CureRow& cure : judged->rows.cures)
        cures.push_back(cure.sentence);
    return {{"time", judged->time},
            {"cures", cures},
            {"score", judged->rows.score},
            {"note", judged->rows.scoreNote},
            {"verdict", judged->rows.verdict},
            {"corrections", judged->rows.corrections}};
}

/// State of the demonstration; null during another activity.
json demonstration(const Activities& activities) {
    const Demonstration& shown = activities.demonstration;
    if (!activities.at(shown)) return nullptr;
    return {
        {"time", shown.time()}, {"duration", shown.duration()}, {"playing", shown.playing()}, {"welds", shown.welds()}};
}

/// State of the replay; null during another activity. `same` is null before the end and if there is nothing to compare
/// with.
json replay(const Activities& activities) {
    const AttemptReplay& shown = activities.replay;
    if (!activities.at(shown)) return nullptr;
    const ReplayTimeline& line = shown.line();
    json same = nullptr;
    if (const auto& end = shown.comparison(); end && end->verdict != ReplayEnd::Verdict::unknown)
        same = end->verdict == ReplayEnd::Verdict::same;
    return {{"time", line.time()},   {"duration", line.duration()}, {"playing", line.playing()},
            {"speed", line.speed()}, {"seeking", line.seeking()},   {"over", line.over()},
            {"same", same}};
}

/// State of the cut; null unless the weld is cut open.
json cut(const CutView& shown) {
    if (!shown.shown()) return nullptr;
    json measures = json::array();
    for (const SectionMark& mark : shown.marks())
        measures.push_back(mark.label);
    return {{"place_mm", shown.place() * 1e3}, {"judged", shown.judged()}, {"measures", measures}};
}

/// Letters that the keyboard shows on the letter keys, which are named after a US keyboard.
json keyNames(const KeyNames& names) {
    json all;
    for (size_t i = 0; i < static_cast<size_t>(Key::left); ++i) {
        const Key key = static_cast<Key>(i);
        all[std::string(KeyNames::usual().of(key))] = names.of(key);
    }
    return all;
}

json messageTexts(const Messages& messages) {
    json all = json::array();
    for (const Message& message : messages.shown())
        all.push_back(message.text);
    return all;
}

} // namespace

WindowTelemetry::WindowTelemetry(const std::filesystem::path& file) : name_(file) {
    if (file.empty()) return;
    file_.open(file, std::ios::trunc);
    if (!file_) throw InputError(file, 0, "the telemetry cannot be written here; expected a file in a writable folder");
}

void WindowTelemetry::countCalls() {
    if (enabled()) callsCounted_ = joinCallCounters();
}

void WindowTelemetry::endFrame(const WorkCosts& beside, bool another) {
    meter_.add(beside);
    meter_.end();
    if (another) meter_.restart();
}

bool WindowTelemetry::due(double now) {
    if (!enabled() || now < next_) return false;
    next_ = now + kRowSeconds;
    meter_.pause();
    return true;
}

void WindowTelemetry::write(const TelemetryRow& row) {
    writeLine(row);
    meter_.resume();
}

/// Frees the row's JSON before it returns, since freeing takes memory too.
void WindowTelemetry::writeLine(const TelemetryRow& row) {
    const Controls& c = row.controls;
    const json object{
        {"page", row.page},
        {"seconds", row.seconds},
        {"frame", row.frame},
        {"mode", c.mode() == Mode::interact ? "interact" : "view"},
        {"captured", c.captured()},
        {"camera", camera(c)},
        {"source",
         {{"position", numbers(c.source().position())}, {"on", c.source().on()}, {"cold", c.source().cold()}}},
        {"panels",
         {{"view", row.panels.view},
          {"simulation", row.panels.simulation},
          {"timings", row.panels.timings},
          {"result", row.panels.result},
          {"help", row.panels.help},
          {"settings", row.panels.settings},
          {"hidden", row.panels.hidden}}},
        {"torch", torch(row.torch)},
        {"metal", metal(row)},
        {"passes", row.passes},
        {"parameters", parameters(row)},
        {"window",
         {{"size", {row.size.x, row.size.y}}, {"pixels", {row.pixels.x, row.pixels.y}}, {"scale", row.context.scale}}},
        {"frames_per_second", row.figures.framesPerSecond},
        {"picture", row.figures.picture},
        {"steps_beside", row.stepsBeside},
        {"messages", messageTexts(row.messages)},
        {"keys", keyNames(*row.context.keys)},
        {"places", places(row.context)},
        {"focus", row.context.focus},
        {"by_gamepad", row.context.byGamepad},
        {"screenshot", row.screenshot},
        {"judgement", judgement(row.judged)},
        {"demonstration", demonstration(row.activities)},
        {"replay", replay(row.activities)},
        {"cut", cut(row.cut)},
        {"headset", headset(row.headset)},
        {"frame_costs", frameCosts(meter_, callsCounted_)},
    };
    // Bytes of a message need not be UTF-8 (a path, a driver's log); they are replaced, not refused.
    file_ << object.dump(-1, ' ', false, json::error_handler_t::replace) << std::endl;
    if (!file_) {
        fault_ = name_.string() + ": the telemetry cannot be continued; " + writeExpectation(errno);
        file_.close();
    }
}

} // namespace meltpool
