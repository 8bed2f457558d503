#include "core/weld/torch/torch_moves.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/base/toml_table.hpp"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace meltpool {

namespace {

constexpr NumberRange kSeconds{0, 3600};
constexpr NumberRange kSpeeds{0.01, 10000}; ///< mm/s
constexpr NumberRange kWorkAngles{0, 180};
constexpr NumberRange kTravelAngles{-80, 80}; ///< degrees; beyond, the torch would be in the seam
constexpr NumberRange kWidths{0, 1000};       ///< mm
constexpr NumberRange kFrequencies{0.01, 50}; ///< Hz
constexpr NumberRange kFollows{0, 100};       ///< mm/s
constexpr NumberRange kRodAngles{0, 90};
constexpr NumberRange kRodPlaces{-100, 100}; ///< mm
constexpr NumberRange kDiameters{1, 1e4};    ///< mm, of pipes
constexpr double kMostHalfSwings = 1e6;
constexpr float kShortest = 1e-6f; ///< m; a line shorter than this has no direction

glm::vec3 metres(const std::vector<double>& mm) {
    return glm::vec3(static_cast<float>(mm[0] * 1e-3), static_cast<float>(mm[1] * 1e-3),
                     static_cast<float>(mm[2] * 1e-3));
}

glm::vec3 place(TomlTable& table, std::string_view key) {
    const auto values = table.numbers(key, {-1e5, 1e5}, 3);
    if (values.size() != 3) table.fail(key, "expected three numbers [x, y, z] in mm, with decimal points");
    return metres(values);
}

/// Turns the file's moves into stretches of time, one after the other.
class Author {
  public:
    std::vector<TorchMove> read(const std::filesystem::path& file) {
        const toml::table parsed = parseTomlFile(file);
        TomlTable root(parsed, file);
        tip_ = place(root, "start_mm");
        readAngles(root);
        readPipe(root);
        readRod(root);
        std::vector<TomlTable> moves = root.tables("move");
        findSeams(moves);
        takeSeam(0);
        orientation_ = held();
        for (size_t i = 0; i < moves.size(); ++i) {
            takeSeam(i);
            readMove(moves[i]);
            moves[i].finish();
        }
        root.finish();
        if (moves_.empty()) root.fail("move", "is missing; expected at least one table that begins with [[move]]");
        return std::move(moves_);
    }

  private:
    void readAngles(TomlTable& table) {
        work_ = table.number("work_angle_deg", kWorkAngles, work_);
        travel_ = table.number("travel_angle_deg", kTravelAngles, travel_);
    }

    /// Finds for each move the direction of the next welded line, which depends only on later moves.
    void findSeams(std::vector<TomlTable>& moves) {
        seams_.resize(moves.size());
        glm::vec3 tip = tip_;
        float trigger = 0;
        size_t first = 0; // first of the moves that wait for a seam
        for (size_t i = 0; i < moves.size(); ++i) {
            const std::string kind = moves[i].text("kind");
            if (kind == "arc_on" || kind == "arc_off") trigger = readTrigger(moves[i], kind);
            if (kind != "line" && kind != "weave") continue;
            const glm::vec3 to = place(moves[i], "to_mm");
            const std::optional<glm::vec3> seam = directionOf(to - tip);
            tip = to;
            if (trigger == 0 || !seam) continue;
            for (; first <= i; ++first)
                seams_[first] = seam;
            hasSeams_ = true;
        }
    }

    /// Holds a torch with released trigger for the next seam, so that it strikes as it goes on to weld.
    void takeSeam(size_t move) {
        if (trigger_ == 0 && move < seams_.size() && seams_[move]) direction_ = *seams_[move];
    }

    void readPipe(TomlTable& root) {
        root.allow("pipe_diameter_mm");
        if (root.has("pipe_diameter_mm")) pipeRadius_ = root.number("pipe_diameter_mm", kDiameters) * 0.5e-3;
    }

    void readRod(TomlTable& root) {
        root.allow("rod");
        if (!root.has("rod")) return;
        TomlTable table = root.table("rod");
        RodHold rod;
        rod.angle = glm::radians(table.number("angle_deg", kRodAngles, glm::degrees(rod.angle)));
        rod.ahead = table.number("ahead_mm", kRodPlaces, rod.ahead * 1e3) * 1e-3;
        rod.below = table.number("below_mm", kRodPlaces, rod.below * 1e3) * 1e-3;
        rod.rest = table.number("rest_mm", {0, 200}, rod.rest * 1e3) * 1e-3;
        rod.depth = table.number("depth_mm", {0, 20}, rod.depth * 1e3) * 1e-3;
        rod.feed = table.number("feed_mm_s", {0, 100}, rod.feed * 1e3) * 1e-3;
        table.finish();
        rod_ = rod;
    }

    /// Reads the keys that every kind of move may have in addition to its own.
    void readBesides(TomlTable& table) {
        follow_ = table.number("follow_mm_s", kFollows, 0.0) * 1e-3;
        table.allow("dips_hz");
        if (!table.has("dips_hz")) return;
        if (!rod_) table.fail("dips_hz", "needs a rod; expected a table [rod] before the moves");
        rod_->frequency = table.number("dips_hz", {0, 20});
    }

    /// Returns the hold of the rod: it comes from ahead of the torch and is in the plane of seam and handle.
    std::optional<RodHold> heldRod() const {
        if (!rod_) return std::nullopt;
        RodHold rod = *rod_;
        const glm::vec3 handle = orientation_ * glm::vec3(0, 0, 1);
        rod.travel = direction_;
        rod.up = glm::normalize(handle - glm::dot(handle, direction_) * direction_);
        return rod;
    }

    /// Returns the direction of a weave from toe to toe, at right angles to the torch: in a fillet from plate to plate.
    glm::vec3 acrossHandle() const {
        const glm::vec3 across = glm::normalize(glm::cross(direction_, orientation_ * glm::vec3(0, 0, 1)));
        return across.z < 0 ? -across : across;
    }

    glm::quat held() const { return heldOrientation(glm::radians(work_), glm::radians(travel_), direction_); }

    TorchMove& add(double duration, const glm::vec3& to) {
        TorchMove move;
        move.begin = time_;
        move.duration = duration;
        move.from = tip_;
        move.to = to;
        move.fromOrientation = orientation_;
        move.toOrientation = orientation_;
        move.trigger = trigger_;
        move.followed = followed_;
        move.follow = follow_;
        move.rod = heldRod();
        move.pipeRadius = pipeRadius_;
        time_ += duration;
        tip_ = to;
        followed_ += follow_ * duration;
        return moves_.emplace_back(move);
    }

    void readMove(TomlTable& table) {
        const std::string kind = table.text("kind");
        readBesides(table);
        if (kind == "hold") return readHold(table);
        if (kind == "line") return static_cast<void>(readLine(table));
        if (kind == "weave") return readWeave(table);
        if (kind == "arc_on" || kind == "arc_off") {
            trigger_ = readTrigger(table, kind);
            add(0, tip_);
            return;
        }
        table.fail("kind", "is " + quote(kind) + "; expected one of hold, line, weave, arc_on, arc_off");
    }

    static float readTrigger(TomlTable& table, const std::string& kind) {
        return kind == "arc_off" ? 0.0f : static_cast<float>(table.number("trigger", {0, 1}, 1.0));
    }

    void readHold(TomlTable& table) {
        readAngles(table);
        const double seconds = table.number("seconds", kSeconds);
        TorchMove& move = add(seconds, tip_);
        orientation_ = held();
        move.toOrientation = orientation_;
    }

    /// Returns a unit vector; nothing straight up or down, where there is no seam and the torch stays at its former
    /// direction.
    static std::optional<glm::vec3> directionOf(const glm::vec3& way) {
        const float length = glm::length(way);
        if (length < kShortest) return std::nullopt;
        const glm::vec3 along = way / length;
        if (glm::length(glm::vec2(along.x, along.z)) <= 1e-3f) return std::nullopt;
        return along;
    }

    TorchMove& readLine(TomlTable& table) {
        const glm::vec3 to = place(table, "to_mm");
        const double speed = table.number("speed_mm_s", kSpeeds) * 1e-3;
        readAngles(table);
        const glm::vec3 way = to - tip_;
        const float length = glm::length(way);
        if (length < kShortest) table.fail("to_mm", "is where the torch already stands; expected another place");
        const std::optional<glm::vec3> along = directionOf(way);
        // On its way to a seam, or from the last one, the torch does not turn to its direction of movement.
        const bool aside = trigger_ == 0 && hasSeams_;
        if (along && !aside) direction_ = *along;
        orientation_ = held();
        return add(static_cast<double>(length) / speed, to);
    }

    void readWeave(TomlTable& table) {
        TorchMove& move = readLine(table);
        move.weaveSide = acrossHandle();
        move.weaveWidth = table.number("width_mm", kWidths) * 1e-3;
        const double frequency = table.number("frequency_hz", kFrequencies);
        const double halfSwings = std::round(2 * move.duration * frequency);
        if (halfSwings > kMostHalfSwings) table.fail("frequency_hz", "gives too many swings; expected a lower number");
        // A whole number of half swings brings the torch back to the seam at the end of the move.
        move.weaveHalfSwings = std::max(1, static_cast<int>(halfSwings));
        const double swing = 2 * move.duration / move.weaveHalfSwings;
        move.weaveDwell = table.number("dwell_s", kSeconds, 0.0);
        if (move.weaveDwell > 0.45 * swing)
            table.fail("dwell_s", "leaves no time to swing; expected at most 0.45 of a swing's time");
    }

    std::vector<TorchMove> moves_;
    std::vector<std::optional<glm::vec3>> seams_; ///< direction of the next welded line, for each move
    bool hasSeams_ = false;
    double time_ = 0;
    glm::vec3 tip_{0.0f};
    double work_ = 90;
    double travel_ = 0;
    glm::vec3 direction_{1.0f, 0.0f, 0.0f};
    glm::quat orientation_{1.0f, 0.0f, 0.0f, 0.0f};
    float trigger_ = 0;
    double followed_ = 0; ///< m
    double follow_ = 0;   ///< m/s
    std::optional<RodHold> rod_;
    double pipeRadius_ = 0; ///< m
};

} // namespace

std::vector<TorchMove> readTorchMoves(const std::filesystem::path& file) {
    return Author().read(file);
}

glm::vec3 acrossSeam(const glm::vec3& direction) {
    const glm::vec3 across = glm::normalize(glm::cross(direction, glm::vec3(0.0f, 1.0f, 0.0f)));
    return across.z < 0 ? -across : across;
}

glm::quat heldOrientation(double workAngle, double travelAngle, const glm::vec3& direction) {
    const glm::vec3 across = acrossSeam(direction);
    const auto work = static_cast<float>(workAngle);
    const auto travel = static_cast<float>(travelAngle);
    const glm::vec3 handle = std::sin(work) * glm::vec3(0.0f, 1.0f, 0.0f) + std::cos(work) * across;
    const glm::vec3 along = glm::normalize(direction - glm::dot(direction, handle) * handle);
    const glm::vec3 back = std::cos(travel) * handle - std::sin(travel) * along;
    // One side of the torch faces forward whichever way it travels along the seam.
    const glm::vec3 side = along.x < 0 ? -along : along;
    const glm::vec3 right = glm::normalize(side - glm::dot(side, back) * back);
    return glm::normalize(glm::quat_cast(glm::mat3(right, glm::cross(back, right), back)));
}

double weaveOffset(double phase, double dwellShare) {
    // One quarter: from the centre to the toe in (0.5 - dwellShare) / 2 of a swing, then half of the dwell.
    const double whole = phase - std::floor(phase);
    const double sign = whole < 0.5 ? 1 : -1;
    const double half = whole < 0.5 ? whole : whole - 0.5;
    const double fromCentre = std::min(half, 0.5 - half);
    const double rise = (0.5 - dwellShare) / 2;
    if (fromCentre >= rise) return sign;
    return sign * std::sin(glm::half_pi<double>() * fromCentre / rise);
}

RodSample RodHold::sample(const glm::vec3& tip, double passed) const {
    const double swing = frequency > 0 ? (1 - std::cos(glm::two_pi<double>() * frequency * passed)) / 2 : 0.0;
    return at(tip, std::lerp(rest, -depth, swing));
}

RodSample RodHold::at(const glm::vec3& tip, double back) const {
    const glm::vec3 out = static_cast<float>(std::cos(angle)) * travel + static_cast<float>(std::sin(angle)) * up;
    const glm::vec3 place = tip + static_cast<float>(ahead) * travel - static_cast<float>(below) * up;
    const glm::vec3 right = glm::normalize(glm::cross(up, travel));
    RodSample rod;
    rod.tip = place + static_cast<float>(back) * out;
    rod.orientation = glm::normalize(glm::quat_cast(glm::mat3(right, glm::cross(out, right), out)));
    rod.feed = static_cast<float>(feed);
    return rod;
}

TorchSample aroundPipe(TorchSample torch, double place, double radius) {
    const auto angle = static_cast<float>(place / radius);
    const glm::quat turn = glm::angleAxis(-angle, glm::vec3(0.0f, 0.0f, 1.0f));
    const glm::vec3 rolledOut(static_cast<float>(place), 0.0f, 0.0f);
    const glm::vec3 face = static_cast<float>(radius) * glm::vec3(std::sin(angle), std::cos(angle) - 1.0f, 0.0f);
    const auto bring = [&](glm::vec3& tip, glm::quat& orientation) {
        tip = face + turn * (tip - rolledOut);
        orientation = glm::normalize(turn * orientation);
    };
    bring(torch.tip, torch.orientation);
    if (torch.rod) bring(torch.rod->tip, torch.rod->orientation);
    return torch;
}

TorchSample TorchMove::sample(double time) const {
    const TorchSample torch = rolledOut(time);
    if (pipeRadius <= 0) return torch;
    const double share = duration > 0 ? std::clamp((time - begin) / duration, 0.0, 1.0) : 1.0;
    return aroundPipe(torch, std::lerp(static_cast<double>(from.x), static_cast<double>(to.x), share), pipeRadius);
}

/// Returns the torch on a pipe's face rolled out, or on a workpiece that is no pipe.
TorchSample TorchMove::rolledOut(double time) const {
    const double passed = time - begin;
    const double share = duration > 0 ? std::clamp(passed / duration, 0.0, 1.0) : 1.0;
    TorchSample result;
    result.time = time;
    result.tip = glm::mix(from, to, static_cast<float>(share));
    result.orientation = glm::normalize(glm::slerp(fromOrientation, toOrientation, static_cast<float>(share)));
    result.trigger = trigger;
    if (weaveHalfSwings > 0) {
        const double swing = 2 * duration / weaveHalfSwings;
        const double offset = weaveOffset(passed / swing, weaveDwell / swing) * weaveWidth / 2;
        result.tip += static_cast<float>(offset) * weaveSide;
    }
    if (rod) result.rod = rod->sample(result.tip, passed);
    result.tip += static_cast<float>(followed + follow * std::clamp(passed, 0.0, duration)) * result.axis();
    return result;
}

} // namespace meltpool
