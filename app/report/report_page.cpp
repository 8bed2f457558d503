#include "app/report/report_page.hpp"

#include "app/report/page_parts.hpp"
#include "core/base/words.hpp"

namespace meltpool {

namespace {

constexpr const char* kStyle = R"(
@page { size: A4; margin: 11mm 13mm }
body { font: 10pt/1.3 "Open Sans", "Noto Sans", sans-serif; color: #1c1f24; background: #fff; max-width: 186mm;
  margin: 6mm auto; padding: 0 4mm }
h1 { font-size: 16pt; margin: 0 } h2 { font-size: 11.5pt; margin: 4mm 0 1.5mm; break-after: avoid }
table { border-collapse: collapse; width: 100% }
td, th { padding: 0.5mm 2mm; text-align: left; vertical-align: top; border-bottom: 1px solid #d4d9df }
td.n { text-align: right; white-space: nowrap } .quiet { color: #4a525d } p { margin: 1.5mm 0 }
ol { margin: 1mm 0; padding-left: 6mm } li { margin: 0.5mm 0 }
.top { display: flex; gap: 8mm; align-items: center } .score { font-size: 30pt; font-weight: bold; line-height: 1 }
.pass { color: #14602a } .fail { color: #a3201a; font-weight: bold } .not_resolved, .estimated { color: #5a4500 }
.pair { display: grid; grid-template-columns: 1fr 1fr; gap: 1mm 5mm; align-items: start }
.columns { columns: 2; column-gap: 5mm } tr { break-inside: avoid }
.facts { columns: 2; column-gap: 6mm; margin: 1mm 0; padding: 0; list-style: none; font-size: 9pt }
.facts li { break-inside: avoid } .facts b { font-weight: normal; color: #4a525d }
figure { margin: 0; break-inside: avoid } figcaption { font-size: 8.5pt; color: #4a525d }
img, svg { width: 100%; height: auto; display: block } svg { break-inside: avoid }
svg text { font: 9px "Open Sans", "Noto Sans", sans-serif; fill: #2c333b } svg .title { font-weight: bold }
.outer { fill: #f1ead0 } .inner { fill: #cfe5d2 } .ideal { stroke: #1f6b38; stroke-dasharray: 5 4 }
.limit { stroke: #8a6d00; stroke-width: 0.7; stroke-dasharray: 1 2 }
.axis { stroke: #7a828c } .curve { fill: none; stroke: #174a9c; stroke-width: 1.4 }
.seam { fill: #ccd1d7 } .fault { fill: #e8a29b } .hatch { stroke: #a3201a; stroke-width: 1 }
.mark-fail { stroke: #a3201a; stroke-width: 2 } .mark-other { stroke: #5a4500; stroke-width: 1; stroke-dasharray: 3 2 }
.letter-fail { font-weight: bold }
.plate { fill: #ccd1d7 } .weld { fill: #b98a4a; stroke: #6d4a15; stroke-width: 1 }
.fused { fill: #dcc39a; stroke: #6d4a15; stroke-width: 1; stroke-dasharray: 3 2 }
.turn { break-before: page }
input[name=unit] { accent-color: #174a9c } .in { display: none }
#inch:checked ~ main .in { display: inline } #inch:checked ~ main .mm { display: none }
@media print {
  body { font-size: 8.5pt; line-height: 1.22; margin: 0; padding: 0; max-width: none }
  input, label { display: none } h2 { margin: 2.5mm 0 1mm } td, th { padding: 0.25mm 1.5mm }
  .score { font-size: 24pt } figure img { max-height: 52mm; object-fit: contain; object-position: left }
  .fault, .outer, .inner, .plate, .weld, .fused, .seam { print-color-adjust: exact; -webkit-print-color-adjust: exact }
}
)";

} // namespace

std::string reportPage(const RunResults& results) {
    const std::string lesson = textIn(results.result, "lesson");
    const std::string weld = verdictPart(results) + figurePart(results);
    return "<!DOCTYPE html>\n<html lang=\"" + std::string(language()) +
           "\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width\">\n<title>" +
           lesson + " \xE2\x80\x93 Meltpool</title>\n<style>" + kStyle + "</style>\n</head>\n<body>\n" + unitSwitch() +
           "<main>\n" + headPart(results) + scorePart(results) + picturePart(results) + techniquePart(results) +
           curvePart(results) + (weld.empty() ? "" : "<div class=\"turn\"></div>\n") + weld +
           "</main>\n</body>\n</html>\n";
}

} // namespace meltpool
