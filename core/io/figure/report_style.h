#pragma once

#include "core/io/text/html_text.h"

#include <string>
#include <string_view>

namespace berg {

/**
 * Style sheet of reports and their charts: light or dark as the reader's system, light in print.
 */
inline constexpr std::string_view kReportStyle = R"css(
:root { color-scheme: light dark;
  --text: #16222b; --muted: #4c5e6a; --page: #ffffff; --panel: #f3f7f9; --rule: #cbd8e0;
  --grid: #e3eaee; --axis: #84949e; --plan: #1769aa; --warn: #b3263a; }
@media screen and (prefers-color-scheme: dark) { :root {
  --text: #e8eff3; --muted: #9cb0bc; --page: #111e28; --panel: #182a36; --rule: #2c4150;
  --grid: #223441; --axis: #6b7f8c; --plan: #5fb3f2; --warn: #ff7a8a; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 1.5rem 1.25rem 3rem; max-width: 56rem; color: var(--text);
  background: var(--page); font: 15px/1.5 system-ui, "Segoe UI", "Noto Sans", sans-serif;
  overflow-wrap: anywhere; }
h1 { font-size: 1.6rem; line-height: 1.25; margin: 0 0 .25rem; }
h2 { font-size: 1.15rem; margin: 2rem 0 .5rem; padding-top: .75rem;
  border-top: 1px solid var(--rule); }
p { margin: .4rem 0; max-width: 46rem; }
.lead, figcaption, caption, .muted { color: var(--muted); }
.incomplete { border-left: 4px solid var(--warn); background: var(--panel); padding: .5rem .8rem; }
ul.findings { padding-left: 1.2rem; }
code { font: 13px/1.5 ui-monospace, "DejaVu Sans Mono", monospace; background: var(--panel);
  padding: .1rem .3rem; }
pre { background: var(--panel); padding: .6rem .8rem; margin: .5rem 0; white-space: pre-wrap; }
pre code { padding: 0; }
dl { display: grid; grid-template-columns: 8rem minmax(0, 1fr); gap: .3rem 1.2rem; }
dt { grid-column: 1; color: var(--muted); }
dd { grid-column: 2; margin: 0; }
figure { margin: .8rem 0 1.4rem; overflow-x: auto; }
figcaption { font-size: .9rem; max-width: 46rem; }
.wide { overflow-x: auto; margin: .8rem 0 1.4rem; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: .87rem;
  width: 100%; overflow-wrap: normal; }
caption { text-align: left; padding-bottom: .3rem; }
th, td { padding: .15rem .5rem; text-align: right; white-space: nowrap; }
th:first-child { text-align: left; padding-left: 0; }
thead th { font-weight: 600; vertical-align: bottom; white-space: normal;
  border-bottom: 1px solid var(--axis); }
tbody th { font-weight: 400; }
tbody tr { border-bottom: 1px solid var(--grid); }
.facts td { text-align: left; padding: .2rem 1rem .2rem 0; white-space: normal; }
.facts tr { border: 0; }
tr.marked th, tr.marked td { font-weight: 700; }
svg { display: block; width: 100%; height: auto; }
svg .text { --ink: var(--text); }
svg .muted { --ink: var(--muted); }
svg .axis { --ink: var(--axis); }
svg .grid { --ink: var(--grid); }
svg .plan, svg .p-visitation { --ink: var(--plan); }
svg text { font: 12px system-ui, "Segoe UI", "Noto Sans", sans-serif; fill: var(--ink);
  font-variant-numeric: tabular-nums; }
svg polyline { fill: none; stroke: var(--ink); stroke-linejoin: round; }
svg polygon, svg circle { fill: var(--ink); }
svg .hollow { fill: var(--page); stroke: var(--ink); stroke-width: 1.5; }
@media screen { svg { min-width: 34rem; } }
@page { size: A4; margin: 15mm 14mm; }
@media print {
  body { padding: 0; max-width: none; font-size: 10pt; print-color-adjust: exact;
    -webkit-print-color-adjust: exact; }
  table { font-size: 7.5pt; }
  th, td { padding: .1rem .3rem; }
  .wide, figure { overflow: visible; }
  h2 { break-after: avoid; }
  figure, tr, dd, .incomplete, pre { break-inside: avoid; }
}
)css";

/** Content of the head of a page. */
struct ReportHead
{
    std::string title;
    std::string program;
    std::string language = "en"; ///< language tag for browsers
};

/**
 * Returns the start of a page, from the doctype to the end of its head, in `kReportStyle` followed
 * by `style`.
 */
[[nodiscard]] inline std::string reportHead(const ReportHead& head, const std::string& style = {})
{
    // The policy forbids loading and running anything, whatever else the page contains.
    return "<!DOCTYPE html>\n"
           "<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"" +
           htmlText(head.language) +
           "\">\n<head>\n"
           "<meta charset=\"utf-8\"/>\n"
           "<meta http-equiv=\"Content-Security-Policy\" "
           "content=\"default-src 'none'; style-src 'unsafe-inline'\"/>\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
           "<meta name=\"generator\" content=\"" +
           htmlText(head.program) + "\"/>\n<title>" + htmlText(head.title) + "</title>\n<style>" +
           std::string(kReportStyle) + style + "</style>\n</head>\n";
}

} // namespace berg
