#include "core/training/judging/score.hpp"

#include "core/base/text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace meltpool {

namespace {

constexpr double kMm = 1e3; // mm in a metre
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

bool isWanted(double place, const TechniqueBands& bands) {
    return place * kMm > std::round(bands.lengthFromMm) && place * kMm < std::round(bands.lengthToMm);
}

/// The millimetres of the wanted seam that were welded with a hand that is known.
std::vector<const SeamMillimetre*> weldedPart(const std::vector<SeamMillimetre>& seam, const TechniqueBands& bands) {
    std::vector<const SeamMillimetre*> part;
    for (const SeamMillimetre& mm : seam)
        if (mm.known && isWanted(mm.place, bands)) part.push_back(&mm);
    return part;
}

ParameterScore scoreParameter(const std::vector<const SeamMillimetre*>& part, const TechniqueBands& bands,
                              const TechniqueBand& band) {
    ParameterScore result;
    result.quantity = band.quantity;
    double count = 0, points = 0, sum = 0, off = 0, worst = -1;
    for (const SeamMillimetre* mm : part) {
        const double value = bands.judged(mm->values, mm->direction, band.quantity);
        if (!mm->judged || std::isnan(value)) continue;
        result.least = count > 0 ? std::min(result.least, value) : value;
        result.most = count > 0 ? std::max(result.most, value) : value;
        count += 1;
        points += band.points(value);
        sum += value;
        off += std::abs(value - band.ideal);
        if (std::abs(value - band.ideal) > worst) {
            worst = std::abs(value - band.ideal);
            result.worstPlaceMm = mm->place * kMm;
        }
    }
    if (count > 0) {
        result.score = points / count;
        result.mean = sum / count;
        result.deviation = result.mean - band.ideal;
        result.spread = off / count;
    } else {
        result.mean = result.deviation = result.spread = result.least = result.most = result.worstPlaceMm = kUnknown;
    }
    return result;
}

std::string tellNumber(double value, int digits = 1) {
    const double scale = std::pow(10.0, digits);
    const double rounded = std::round(value * scale) / scale;
    return formatNumber(rounded == 0 ? 0.0 : rounded);
}

std::string reasonAgainst(const TechniqueFaults& faults, const TechniqueScore& score) {
    if (score.unknownMm > 0 && score.unknownMm >= kMostUnknownShare * score.wantedMm) {
        std::string reason;
        if (faults.lostSeconds > 0)
            reason = "Tracking of the torch was lost for " + tellNumber(faults.lostSeconds, 2) +
                     " s from a moment when the arc burned. ";
        if (faults.dropped > 0)
            reason += tellNumber(static_cast<double>(faults.dropped)) +
                      (faults.dropped == 1 ? " sample of the torch was" : " samples of the torch were") +
                      " missing while the arc burned. ";
        return reason + "The hand is not known on " + tellNumber(score.unknownMm) + " of " +
               tellNumber(score.wantedMm) + " mm of the seam. From " + tellNumber(kMostUnknownShare * 100) +
               " % on an attempt has no score.";
    }
    if (faults.arcSeconds <= 0) return "The arc was never lit, so there is nothing to score.";
    if (score.judgedMm <= 0)
        return "The arc burned too short a way on the wanted seam (" + tellNumber(score.weldedMm) +
               " mm, with strike and crater), so there is nothing to score.";
    return {};
}

std::optional<TechniqueQuantity> lowestOf(const TechniqueScore& score, const TechniqueBands& bands) {
    const ParameterScore* lowest = nullptr;
    for (size_t i = 0; i < bands.bands.size(); ++i)
        if (bands.bands[i].weight > 0 && (lowest == nullptr || score.parameters[i].score < lowest->score))
            lowest = &score.parameters[i];
    return lowest != nullptr ? std::optional(lowest->quantity) : std::nullopt;
}

void sumUp(TechniqueScore& score, const TechniqueBands& bands) {
    const double weights = std::accumulate(bands.bands.begin(), bands.bands.end(), 0.0,
                                           [](double sum, const TechniqueBand& each) { return sum + each.weight; });
    score.lowest = lowestOf(score, bands);
    double points = 100;
    for (size_t i = 0; i < bands.bands.size() && weights > 0; ++i) {
        ParameterScore& parameter = score.parameters[i];
        const double share = (1 - kLowestShare) * bands.bands[i].weight / weights +
                             (parameter.quantity == score.lowest ? kLowestShare : 0.0);
        const double lost = (100 - parameter.score) * share;
        parameter.lost = lost * score.coverage;
        points -= lost;
    }
    score.total = std::clamp(points * score.coverage, 0.0, 100.0);
    score.lostToLength = 100 * (1 - score.coverage);
}

/// What to do about a value that is too high or too low.
std::string_view advice(const TechniqueBand& band, bool tooMuch) {
    switch (band.quantity) {
    case TechniqueQuantity::aim:
        return tooMuch ? "Aim farther away from you" : "Aim closer to you";
    case TechniqueQuantity::height:
    case TechniqueQuantity::distance:
        return tooMuch ? "Hold the torch closer" : "Hold the torch farther away";
    case TechniqueQuantity::workAngle:
        return tooMuch ? "Lean the torch less towards you" : "Lean the torch more towards you";
    case TechniqueQuantity::travelAngle:
        if (tooMuch) return band.ideal < 0 ? "Drag more" : "Push less";
        return band.ideal > 0 ? "Push more" : "Drag less";
    case TechniqueQuantity::travelSpeed:
        return tooMuch ? "Travel slower" : "Travel faster";
    case TechniqueQuantity::weaveWidth:
        return tooMuch ? "Weave narrower" : "Weave wider";
    case TechniqueQuantity::weaveFrequency:
        return tooMuch ? "Weave slower" : "Weave faster";
    case TechniqueQuantity::weaveDwell:
        return tooMuch ? "Stay shorter at the toes" : "Stay longer at the toes";
    case TechniqueQuantity::whipLength:
        return tooMuch ? "Whip less far" : "Whip farther";
    case TechniqueQuantity::whipPeriod:
        return tooMuch ? "Whip faster" : "Whip slower";
    case TechniqueQuantity::whipDwell:
        return tooMuch ? "Stay shorter in the pool" : "Stay longer in the pool";
    case TechniqueQuantity::rodAngle:
        return tooMuch ? "Lay the rod flatter" : "Hold the rod steeper";
    case TechniqueQuantity::rodFrequency:
        return tooMuch ? "Dip the rod slower" : "Dip the rod faster";
    }
    return "";
}

std::string sentenceOf(const ParameterScore& parameter, const TechniqueBand& band, const QuantityInfo& info) {
    const std::string words(info.words);
    const std::string unit = info.unit == "°" ? "°" : " " + std::string(info.unit);
    const auto tell = [&](double value) { return tellNumber(value) + unit; };
    if (std::isnan(parameter.mean)) return "The " + words + " could not be measured anywhere on the seam.";
    const double off = std::abs(parameter.deviation);
    // Values on both sides of the ideal have a mean near it: then it is the unevenness that costs.
    if (off < 0.5 * parameter.spread || tellNumber(off) == "0")
        return "Keep the " + words + " even: it went from " + tell(parameter.least) + " to " + tell(parameter.most) +
               "; asked for is " + tell(band.ideal) + ".";
    const bool tooMuch = parameter.deviation > 0;
    std::string sentence(advice(band, tooMuch));
    if (parameter.quantity == TechniqueQuantity::travelSpeed && parameter.mean < 0)
        return "Weld in the other direction: the torch went against the one asked for, at " + tell(-parameter.mean) +
               " on average.";
    if (parameter.quantity == TechniqueQuantity::aim)
        return sentence + ": the aim was " + tell(off) + " off " + (band.ideal == 0 ? "" : "the line asked for ") +
               "on average, " + (tooMuch ? "on your side." : "on the side away from you.");
    return sentence + ": the " + words + " was " + tell(parameter.mean) + " on average, " + tell(off) +
           (tooMuch ? " above the " : " below the ") + tell(band.ideal) + " asked for.";
}

} // namespace

const ParameterScore* TechniqueScore::find(TechniqueQuantity quantity) const {
    const auto found = std::find_if(parameters.begin(), parameters.end(),
                                    [&](const ParameterScore& each) { return each.quantity == quantity; });
    return found == parameters.end() ? nullptr : &*found;
}

std::string unknownSentence(const TechniqueScore& score) {
    if (score.unknownMm <= 0) return {};
    return "Left out of the score: " + tellNumber(score.unknownMm) +
           " mm of the seam, where the hand is not known because the picture stood still or tracking was lost.";
}

TechniqueScore scoreTechnique(const TechniqueFaults& faults, const std::vector<SeamMillimetre>& seam,
                              const std::vector<double>& unknown, const TechniqueBands& bands) {
    TechniqueScore score;
    const std::vector<const SeamMillimetre*> part = weldedPart(seam, bands);
    score.wantedMm = std::round(bands.lengthToMm) - std::round(bands.lengthFromMm);
    score.weldedMm = static_cast<double>(part.size());
    score.judgedMm = static_cast<double>(
        std::count_if(part.begin(), part.end(), [](const SeamMillimetre* each) { return each->judged; }));
    score.unknownMm = static_cast<double>(
        std::count_if(unknown.begin(), unknown.end(), [&](double place) { return isWanted(place, bands); }));
    const double asked = score.wantedMm - score.unknownMm;
    const double needed = std::max(1.0, asked - 2 * std::min(kFreeEndMm, kFreeEndShare * score.wantedMm));
    score.coverage = std::min(score.weldedMm / needed, 1.0);
    for (const TechniqueBand& band : bands.bands)
        score.parameters.push_back(scoreParameter(part, bands, band));
    score.reason = reasonAgainst(faults, score);
    score.scored = score.reason.empty();
    if (score.scored) sumUp(score, bands);
    return score;
}

std::vector<Correction> corrections(const TechniqueScore& score, const TechniqueBands& bands, size_t most) {
    constexpr double kLeastLoss = 0.5;
    std::vector<Correction> all;
    if (!score.scored) return all;
    if (score.lostToLength >= kLeastLoss)
        all.push_back({{},
                       score.lostToLength,
                       "Weld the whole seam: " + tellNumber(score.weldedMm) + " of " + tellNumber(score.wantedMm) +
                           " mm are welded."});
    for (const ParameterScore& parameter : score.parameters) {
        const TechniqueBand* band = bands.find(parameter.quantity);
        if (band == nullptr || parameter.lost < kLeastLoss) continue;
        const QuantityInfo& info = quantityInfo(parameter.quantity, bands.distance);
        all.push_back({parameter.quantity, parameter.lost, sentenceOf(parameter, *band, info)});
    }
    std::stable_sort(all.begin(), all.end(), [](const Correction& a, const Correction& b) { return a.lost > b.lost; });
    if (all.size() > most) all.resize(most);
    return all;
}

} // namespace meltpool
