#include "app/report/svg_text.hpp"

#include <cstdio>

namespace meltpool {

namespace {

std::string attribute(const char* name, std::string_view value) {
    return " " + std::string(name) + "=\"" + std::string(value) + "\"";
}

std::string attribute(const char* name, double value) {
    return attribute(name, SvgText::coordinate(value));
}

} // namespace

std::string escaped(std::string_view text) {
    std::string safe;
    for (const char c : text) {
        if (c == '&')
            safe += "&amp;";
        else if (c == '<')
            safe += "&lt;";
        else if (c == '>')
            safe += "&gt;";
        else if (c == '"')
            safe += "&quot;";
        else if (c == '\'')
            safe += "&#39;";
        else if (static_cast<unsigned char>(c) >= 0x20 && c != 0x7F)
            safe += c;
    }
    return safe;
}

std::string rounded(double value, int decimals) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    std::string number(text);
    if (number.find_first_not_of("-0.") == std::string::npos && number.front() == '-') number.erase(0, 1);
    return number;
}

SvgText::SvgText(double width, double height, std::string_view description)
    : text_("<svg viewBox=\"0 0 " + rounded(width, 0) + " " + rounded(height, 0) + "\" role=\"img\" aria-label=\"" +
            escaped(description) + "\">") {}

void SvgText::rectangle(double left, double top, double right, double bottom, std::string_view style) {
    if (!(right > left) || !(bottom > top)) return;
    text_ += "<rect" + attribute("class", style) + attribute("x", left) + attribute("y", top) +
             attribute("width", right - left) + attribute("height", bottom - top) + "/>";
}

void SvgText::line(double x1, double y1, double x2, double y2, std::string_view style) {
    text_ += "<line" + attribute("class", style) + attribute("x1", x1) + attribute("y1", y1) + attribute("x2", x2) +
             attribute("y2", y2) + "/>";
}

void SvgText::word(double x, double y, std::string_view anchor, std::string_view word, std::string_view style) {
    text_ += "<text" + (style.empty() ? std::string() : attribute("class", style)) + attribute("x", x) +
             attribute("y", y) + attribute("text-anchor", anchor) + ">" + escaped(word) + "</text>";
}

void SvgText::polyline(std::string_view points, std::string_view style) {
    text_ += "<polyline" + attribute("class", style) + attribute("points", points) + "/>";
}

void SvgText::dot(double x, double y, std::string_view style, std::string_view tooltip) {
    constexpr double kRadius = 2.5;
    text_ += "<circle" + attribute("class", style) + attribute("cx", x) + attribute("cy", y) + attribute("r", kRadius) +
             "><title>" + escaped(tooltip) + "</title></circle>";
}

void SvgText::path(std::string_view commands, std::string_view style) {
    text_ += "<path" + attribute("class", style) + attribute("d", commands) + "/>";
}

} // namespace meltpool
