#include "core/training/attempt/record_text.hpp"

#include "core/base/text.hpp"

namespace meltpool {

namespace {

void appendPlain(std::string& text, std::string_view part) {
    for (const char c : part)
        text += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? ' ' : c;
}

} // namespace

void appendRecordLine(std::string& text, std::string_view prefix, std::string_view word, std::string_view name,
                      std::string_view value) {
    bool first = true;
    for (const std::string_view part : {prefix, word, name, value}) {
        if (part.empty()) continue;
        if (!first) text += ' ';
        appendPlain(text, part);
        first = false;
    }
    text += '\n';
}

void appendCell(std::string& text, float value) {
    text += ',';
    appendNumber(text, value);
}

void appendCell(std::string& text, double value) {
    text += ',';
    appendNumber(text, value);
}

void appendCell(std::string& text, std::uint64_t value) {
    text += ',';
    appendNumber(text, value);
}

void appendArcCells(std::string& text, const ArcState& arc) {
    appendCell(text, static_cast<double>(arc.length) * 1e3);
    appendCell(text, static_cast<double>(arc.current));
    appendCell(text, static_cast<double>(arc.voltage));
    text += ',';
    text += arcActionName(arc.action);
    appendCell(text, static_cast<double>(arc.distance) * 1e3);
    appendCell(text, static_cast<double>(arc.extension) * 1e3);
    appendCell(text, arc.power);
}

} // namespace meltpool
