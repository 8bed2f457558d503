#include "core/weld/workpiece/simulated_size.hpp"

#include "core/base/text.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr double kWhole = 1e-3; ///< spacings: a number nearer to a whole one than this is whole
constexpr double kFinest = 0.2; ///< mm, the least spacing that describe() allows

/// A length in spacings, and the whole number of them that it becomes.
struct Spacings {
    double count, whole;

    Spacings(double lengthMm, double spacingMm, double least)
        : count(lengthMm / spacingMm), whole(std::max(std::floor(count + 0.5 + kWhole), least)) {}

    bool isWhole() const { return std::abs(count - whole) < kWhole; }
    bool isHalf() const { return std::abs(count - std::floor(count) - 0.5) < kWhole; }
};

/// Layers of a spacing that is no binary fraction add up to a length with a long tail of digits.
float toMicrometre(float lengthMm) {
    return static_cast<float>(std::round(static_cast<double>(lengthMm) * 1e3) / 1e3);
}

float wholeLength(float lengthMm, float spacingMm, double least = 1) {
    const auto spacing = static_cast<double>(spacingMm);
    const Spacings spacings(static_cast<double>(lengthMm), spacing, least);
    return spacings.isWhole() ? lengthMm : static_cast<float>(spacings.whole * spacing);
}

/// Returns the length of the part on one side of a gap.
Spacings besideGap(const WorkpieceParameters& p) {
    return {0.5 * (static_cast<double>(p.widthMm) - static_cast<double>(p.gapMm)), static_cast<double>(p.spacingMm), 1};
}

void fitGap(WorkpieceParameters& p) {
    const float asked = p.gapMm;
    p.gapMm = wholeLength(asked, p.spacingMm, 0);
    const Spacings part = besideGap(p);
    if (p.gapMm <= 0 || part.isWhole() || (part.isHalf() && p.gapMm == asked)) return;
    p.widthMm = p.gapMm + static_cast<float>(2 * part.whole * static_cast<double>(p.spacingMm));
}

} // namespace

WorkpieceParameters simulatedWorkpiece(const WorkpieceParameters& asked) {
    WorkpieceParameters p = asked;
    const auto kind = static_cast<WorkpieceKind>(p.kind);
    const auto fit = [&](float& length) { length = wholeLength(length, p.spacingMm); };
    fit(kind == WorkpieceKind::Cube ? p.lengthMm : p.thicknessMm);
    switch (kind) {
    case WorkpieceKind::Corner:
    case WorkpieceKind::Bridge:
        fit(p.heightMm);
        if (kind == WorkpieceKind::Bridge) break;
        [[fallthrough]];
    case WorkpieceKind::Tee:
    case WorkpieceKind::Lap:
        p.widthMm = 2 * wholeLength(p.widthMm / 2, p.spacingMm);
        break;
    case WorkpieceKind::Butt:
    case WorkpieceKind::Pipe:
        fitGap(p);
        p.rootFaceMm = asked.rootFaceMm >= asked.thicknessMm ? p.thicknessMm : std::min(p.rootFaceMm, p.thicknessMm);
        break;
    case WorkpieceKind::Plate:
    case WorkpieceKind::Cube:
        break;
    }
    return p;
}

float gapBesideMiddle(const WorkpieceParameters& simulated) {
    const auto kind = static_cast<WorkpieceKind>(simulated.kind);
    const bool parted = (kind == WorkpieceKind::Butt || kind == WorkpieceKind::Pipe) && simulated.gapMm > 0;
    return parted && besideGap(simulated).isHalf() ? simulated.spacingMm / 2 : 0;
}

std::vector<SimulatedSize> simulatedSizes(const WorkpieceParameters& asked) {
    WorkpieceParameters before = asked, after = simulatedWorkpiece(asked);
    const ParameterList askedList = describe(before), list = describe(after);
    std::vector<SimulatedSize> sizes;
    for (size_t i = 0; i < list.size(); ++i) {
        const auto* was = std::get_if<float*>(&askedList[i].value);
        const auto* is = std::get_if<float*>(&list[i].value);
        if (was != nullptr && is != nullptr && **was != **is)
            sizes.push_back({list[i].key, list[i].label, **was, toMicrometre(**is)});
    }
    return sizes;
}

std::string simulatedSizesText(const WorkpieceParameters& asked) {
    const std::vector<SimulatedSize> sizes = simulatedSizes(asked);
    if (sizes.empty()) return {};
    const auto mm = [](float length) { return formatNumber(length) + " mm"; };
    std::string text = phrase("joint.whole_layers", {{"spacing", mm(asked.spacingMm)}});
    for (const SimulatedSize& size : sizes)
        text += " " + phrase("joint.simulated." + std::string(size.key),
                             {{"simulated", mm(size.simulated)}, {"asked", mm(size.asked)}});
    if (std::none_of(sizes.begin(), sizes.end(), [](const auto& size) { return size.key == "thickness_mm"; }))
        return text;
    const double thickness = static_cast<double>(asked.thicknessMm);
    const double layers = std::ceil(thickness / static_cast<double>(asked.spacingMm));
    const double spacing = std::round(thickness / layers * 1e4) * 1e-4;
    if (spacing >= kFinest)
        text += " " + phrase("joint.keeps_thickness", {{"spacing", mm(static_cast<float>(spacing))}});
    return text;
}

} // namespace meltpool
