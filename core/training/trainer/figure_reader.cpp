#include "core/training/trainer/figure_reader.hpp"

#include "core/gl/state_archive.hpp"

namespace meltpool {

namespace {

/// Simulated time between two readings of the whole metal, s: a person reads no faster.
constexpr double kPeriod = 0.1;

MetalStatistics statisticsOf(const LessonMetal& metal) {
    return metal.run([](MetalModel& model) { return model.statistics(); });
}

} // namespace

FigureReader::FigureReader(LessonMetal& metal, AttemptRecorder& recorder) : metal_(metal), recorder_(recorder) {
    readAgain();
}

void FigureReader::readAgain() {
    newest_ = statisticsOf(metal_);
}

void FigureReader::reset() {
    next_ = 0;
    readAgain();
}

void FigureReader::update(double time) {
    if (wait_) {
        finish();
        take(statisticsOf(metal_));
        return;
    }
    while (const auto fresh = asked_ > 0 ? metal_.run([](MetalModel& metal) { return metal.pollStatistics(); }) : std::nullopt) {
        --asked_;
        take(*fresh);
    }
    if (recorder_.writesCsv())
        await(kStatisticsInFlight - 1); // each row has its own reading of the metal
    else if (asked_ > 0 || time < next_)
        return;
    metal_.run([](MetalModel& metal) { metal.requestStatistics(); });
    ++asked_;
    next_ = time + kPeriod;
}

void FigureReader::take(const MetalStatistics& figures) {
    newest_ = figures;
    recorder_.complete(figures);
}

/// Takes answers until at most `left` are pending.
void FigureReader::await(size_t left) {
    for (; asked_ > left; --asked_)
        take(*metal_.run([](MetalModel& metal) { return metal.awaitStatistics(); }));
}

void FigureReader::transfer(gl::StateArchive& archive) {
    archive.values(next_);
}

} // namespace meltpool
