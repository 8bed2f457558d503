#include "core/training/judging/score.hpp"

#include "core/base/text.hpp"
#include "core/base/words.hpp"

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

/// The millimetres of the wanted seam that were welded with a known hand.
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
    return withDecimalMark(formatNumber(rounded == 0 ? 0.0 : rounded));
}

std::string unknownHandReason(const TechniqueFaults& faults, const TechniqueScore& score) {
    std::string reason;
    if (faults.lostSeconds > 0)
        reason = phrase("score.tracking_lost", {{"seconds", tellNumber(faults.lostSeconds, 2)}}) + " ";
    if (faults.dropped > 0)
        reason += phraseOfCount("score.samples_missing", static_cast<long long>(faults.dropped),
                                {{"count", tellNumber(static_cast<double>(faults.dropped))}}) +
                  " ";
    return reason + phrase("score.hand_unknown", {{"unknown", tellNumber(score.unknownMm)},
                                                  {"wanted", tellNumber(score.wantedMm)},
                                                  {"share", tellNumber(kMostUnknownShare * 100)}});
}

std::string reasonAgainst(const TechniqueFaults& faults, const TechniqueScore& score) {
    if (score.unknownMm > 0 && score.unknownMm >= kMostUnknownShare * score.wantedMm)
        return unknownHandReason(faults, score);
    if (faults.arcSeconds <= 0) return phrase("score.arc_never_lit");
    if (score.judgedMm <= 0) return phrase("score.too_short", {{"welded", tellNumber(score.weldedMm)}});
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

/// Case of the parameter's sentence, see [correction] of the words file.
std::string_view caseOf(const ParameterScore& parameter, const TechniqueBand& band, bool tee) {
    if (std::isnan(parameter.mean)) return "unknown";
    const double off = std::abs(parameter.deviation);
    // A mean near the ideal has full points: then the unevenness costs the points.
    if (off < 0.5 * parameter.spread || !band.readsBeyond(parameter.mean)) return "uneven";
    const bool tooMuch = parameter.deviation > 0;
    switch (band.quantity) {
    case TechniqueQuantity::travelSpeed:
        if (parameter.mean < 0) return "against";
        break;
    case TechniqueQuantity::rodFrequency:
        if (parameter.most <= 0) return "none";
        break;
    case TechniqueQuantity::aim:
        if (tee) return tooMuch ? "above_tee" : "below_tee";
        if (band.ideal != 0) return tooMuch ? "above_line" : "below_line";
        break;
    case TechniqueQuantity::travelAngle:
        if (tooMuch && band.ideal < 0) return "above_drag";
        if (!tooMuch && band.ideal > 0) return "below_push";
        break;
    default:
        break;
    }
    return tooMuch ? "above" : "below";
}

/// True if all of a parameter reads as within its tolerance: a correction would ask for what the reader sees allowed.
bool readsAllowed(const ParameterScore& parameter, const TechniqueBand& band) {
    return !std::isnan(parameter.mean) && !band.readsBeyond(parameter.least) && !band.readsBeyond(parameter.most);
}

} // namespace

ParameterScore scoreStretch(const std::vector<SeamMillimetre>& seam, double from, double to,
                            const TechniqueBands& bands, const TechniqueBand& band) {
    std::vector<const SeamMillimetre*> part;
    for (const SeamMillimetre& mm : seam)
        if (mm.known && mm.place >= from && mm.place <= to) part.push_back(&mm);
    return scoreParameter(part, bands, band);
}

std::string correctionSentence(const ParameterScore& parameter, const TechniqueBand& band,
                               const TechniqueBands& bands) {
    std::string key = "correction.";
    key += quantityInfo(parameter.quantity, bands.distance).key;
    key += '.';
    key += caseOf(parameter, band, bands.tee);
    return phrase(key, {{"mean", tellNumber(parameter.mean)},
                        {"off", tellNumber(std::abs(parameter.deviation))},
                        {"ideal", tellNumber(band.ideal)},
                        {"least", tellNumber(parameter.least)},
                        {"most", tellNumber(parameter.most)},
                        {"speed", tellNumber(std::abs(parameter.mean))}});
}

const ParameterScore* TechniqueScore::find(TechniqueQuantity quantity) const {
    const auto found = std::find_if(parameters.begin(), parameters.end(),
                                    [&](const ParameterScore& each) { return each.quantity == quantity; });
    return found == parameters.end() ? nullptr : &*found;
}

std::string unknownSentence(const TechniqueScore& score) {
    if (score.unknownMm <= 0) return {};
    return phrase("score.left_out", {{"length", tellNumber(score.unknownMm)}});
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
                       phrase("correction.whole_seam",
                              {{"welded", tellNumber(score.weldedMm)}, {"wanted", tellNumber(score.wantedMm)}})});
    for (const ParameterScore& parameter : score.parameters) {
        const TechniqueBand* band = bands.find(parameter.quantity);
        if (band == nullptr || parameter.lost < kLeastLoss || readsAllowed(parameter, *band)) continue;
        all.push_back({parameter.quantity, parameter.lost, correctionSentence(parameter, *band, bands)});
    }
    std::stable_sort(all.begin(), all.end(), [](const Correction& a, const Correction& b) { return a.lost > b.lost; });
    if (all.size() > most) all.resize(most);
    return all;
}

} // namespace meltpool
