// Solves the pivot calibration by least squares, and reads and writes its file.
#include "xr/pivot.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/base/words.hpp"

#include <glm/gtc/constants.hpp>
#include <glm/gtx/quaternion.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace meltpool::xr {

namespace {

constexpr size_t kFewestPoses = 20;
constexpr float kLeastTurnDegrees = 15.0f;
constexpr float kLargestResidualMm = 5.0f;

/// With the mean rotation M and mean position m over the poses, the best point is M x + m; the remaining problem is min
/// |(R_i - M) x - (m - p_i)|^2, whose normal matrix N = sum (R_i - M)^T (R_i - M) is 3 by 3.
struct NormalEquations {
    glm::dmat3 matrix{0.0};
    glm::dvec3 right{0.0};
    glm::dmat3 meanRotation{0.0};
    glm::dvec3 meanPosition{0.0};
};

NormalEquations normalEquations(std::span<const Pose> poses) {
    NormalEquations sum;
    const double n = static_cast<double>(poses.size());
    for (const Pose& pose : poses) {
        sum.meanRotation += glm::dmat3(glm::mat3_cast(pose.orientation)) / n;
        sum.meanPosition += glm::dvec3(pose.position) / n;
    }
    for (const Pose& pose : poses) {
        const glm::dmat3 d = glm::dmat3(glm::mat3_cast(pose.orientation)) - sum.meanRotation;
        sum.matrix += glm::transpose(d) * d / n;
        sum.right += glm::transpose(d) * (sum.meanPosition - glm::dvec3(pose.position)) / n;
    }
    return sum;
}

/// Smallest eigenvalue of a symmetric 3 by 3 matrix (trigonometric solution of the characteristic cubic).
double smallestEigenvalue(const glm::dmat3& a) {
    const double q = (a[0][0] + a[1][1] + a[2][2]) / 3.0;
    const double off = a[1][0] * a[1][0] + a[2][0] * a[2][0] + a[2][1] * a[2][1];
    const double p2 =
        (a[0][0] - q) * (a[0][0] - q) + (a[1][1] - q) * (a[1][1] - q) + (a[2][2] - q) * (a[2][2] - q) + 2.0 * off;
    if (p2 <= 0) return q;
    const double p = std::sqrt(p2 / 6.0);
    const glm::dmat3 b = (a - q * glm::dmat3(1.0)) / p;
    const double r = std::clamp(glm::determinant(b) / 2.0, -1.0, 1.0);
    return q + 2.0 * p * std::cos(std::acos(r) / 3.0 + 2.0 * glm::pi<double>() / 3.0);
}

PivotResult refuse(PivotResult result, std::string reason) {
    result.reason = std::move(reason);
    return result;
}

} // namespace

PivotResult solvePivot(std::span<const Pose> poses) {
    PivotResult result;
    if (poses.size() < kFewestPoses)
        return refuse(result, phrase("headset.tip.pivot.few_poses", {{"poses", std::to_string(poses.size())}}));
    const NormalEquations sum = normalEquations(poses);
    // For turns of standard deviation s about an axis, the matrix has s^2 in both directions across it, so the smallest
    // eigenvalue is the turning across the worst-known direction.
    const double weakest = std::max(0.0, smallestEigenvalue(sum.matrix));
    result.turnDegrees = static_cast<float>(glm::degrees(2.0 * std::asin(std::min(1.0, std::sqrt(weakest)))));
    if (result.turnDegrees < kLeastTurnDegrees) return refuse(result, phrase("headset.tip.pivot.hardly_turned"));
    result.offset = glm::vec3(glm::inverse(sum.matrix) * sum.right);
    result.point = glm::vec3(sum.meanRotation * glm::dvec3(result.offset) + sum.meanPosition);
    double squares = 0;
    for (const Pose& pose : poses) {
        const glm::vec3 miss = pose * result.offset - result.point;
        squares += static_cast<double>(glm::dot(miss, miss));
    }
    result.residualMm = static_cast<float>(1000.0 * std::sqrt(squares / static_cast<double>(poses.size())));
    // Cov(x) = s² (n N)^-1 with s² the variance of a coordinate: 3 n equations minus 6 unknowns.
    const double n = static_cast<double>(poses.size());
    const double variance = squares / (3 * n - 6);
    const glm::dmat3 spread = glm::inverse(sum.matrix) * (variance / n);
    result.errorMm = static_cast<float>(1000.0 * std::sqrt(spread[0][0] + spread[1][1] + spread[2][2]));
    if (result.residualMm > kLargestResidualMm)
        return refuse(result, phrase("headset.tip.pivot.slid",
                                     {{"distance", PhraseNumber(static_cast<double>(result.residualMm), 1)}}));
    if (result.errorMm > kPivotError)
        return refuse(result, phrase("headset.tip.pivot.uncertain",
                                     {{"error", PhraseNumber(static_cast<double>(result.errorMm), 1)}}));
    result.accepted = true;
    return result;
}

AxisResult solveAxis(std::span<const Pose> poses, const glm::vec3& down) {
    constexpr float kLargestSpread = 3.0f;
    AxisResult result;
    if (poses.size() < kFewestPoses) {
        result.reason = phrase("headset.tip.axis.few_poses", {{"poses", std::to_string(poses.size())}});
        return result;
    }
    glm::dvec3 sum(0.0);
    for (const Pose& pose : poses)
        sum += glm::dvec3(glm::conjugate(pose.orientation) * down);
    const double length = glm::length(sum);
    if (length > 0) result.direction = glm::vec3(sum / length);
    double squares = 0;
    for (const Pose& pose : poses) {
        const double cosine = glm::dot(glm::dvec3(pose.orientation * result.direction), glm::dvec3(down));
        squares += std::pow(std::acos(std::clamp(cosine, -1.0, 1.0)), 2.0);
    }
    result.spreadDegrees = static_cast<float>(glm::degrees(std::sqrt(squares / static_cast<double>(poses.size()))));
    result.accepted = result.spreadDegrees <= kLargestSpread;
    if (!result.accepted) result.reason = phrase("headset.tip.axis.not_still");
    return result;
}

void TipCalibration::pointAlong(const glm::vec3& direction) {
    orientation = glm::rotation(glm::vec3(0, 0, -1), glm::normalize(direction));
}

namespace {

constexpr std::array<const char*, 8> kKeys{"x_mm", "y_mm", "z_mm", "qx", "qy", "qz", "qw", "residual_mm"};
constexpr size_t kLargestFile = 65536;    ///< bytes
constexpr double kFarthest = 2000;        ///< mm; no tip is farther from the hand
constexpr double kLargestResidual = 1000; ///< mm

/// Throws InputError for a number outside the range of any measurement.
void checkRange(const std::filesystem::path& file, int line, const std::string& key, double value) {
    const bool place = key.ends_with("_mm") && key != "residual_mm";
    const double least = key == "residual_mm" ? 0 : place ? -kFarthest : -1.01;
    const double most = key == "residual_mm" ? kLargestResidual : -least;
    if (value < least || value > most)
        throw InputError(file, line,
                         key + " is out of range; expected a number from " + formatNumber(least) + " to " +
                             formatNumber(most));
}

} // namespace

TipCalibration readCalibration(const std::filesystem::path& file) {
    std::map<std::string, double, std::less<>> values;
    const std::string text = readTextFile(file, kLargestFile);
    int line = 0;
    for (const std::string_view raw : splitText(text, '\n')) {
        ++line;
        const std::string_view content = trimText(raw.substr(0, raw.find('#')));
        if (content.empty()) continue;
        const size_t equals = content.find('=');
        const std::string key(trimText(content.substr(0, equals)));
        const double value = equals == std::string_view::npos
                                 ? std::nan("")
                                 : parseDouble(trimText(content.substr(equals + 1))).value_or(std::nan(""));
        if (std::find(kKeys.begin(), kKeys.end(), key) == kKeys.end() || !std::isfinite(value))
            throw InputError(file, line,
                             "expected one of x_mm, y_mm, z_mm, qx, qy, qz, qw, residual_mm, '=' and a number");
        checkRange(file, line, key, value);
        values[key] = value;
    }
    for (const char* key : kKeys)
        if (!values.contains(key)) throw InputError(file, 0, std::string("expected a line '") + key + " = NUMBER'");
    const auto of = [&](const char* key) { return static_cast<float>(values.find(key)->second); };
    TipCalibration calibration;
    calibration.offset = glm::vec3(of("x_mm"), of("y_mm"), of("z_mm")) / 1000.0f;
    const glm::quat q(of("qw"), of("qx"), of("qy"), of("qz"));
    if (std::abs(glm::length(q) - 1.0f) > 0.01f)
        throw InputError(file, 0, "expected a quaternion qx, qy, qz, qw of length 1");
    calibration.orientation = glm::normalize(q);
    calibration.residualMm = of("residual_mm");
    return calibration;
}

void writeCalibration(const std::filesystem::path& file, const TipCalibration& c) {
    const std::array<float, kKeys.size()> values{c.offset.x * 1000, c.offset.y * 1000, c.offset.z * 1000,
                                                 c.orientation.x,   c.orientation.y,   c.orientation.z,
                                                 c.orientation.w,   c.residualMm};
    std::string text =
        "# Position and orientation of the torch's tip relative to the hand's grip, and the measurement's error.\n";
    for (size_t i = 0; i < kKeys.size(); ++i)
        text += std::string(kKeys[i]) + " = " + formatNumber(values[i]) + "\n";
    writeTextFileAtomically(file, text);
}

} // namespace meltpool::xr
