#include "core/io/study/study_report.h"

#include "core/io/figure/figure_layout.h"
#include "core/io/figure/figure_svg.h"
#include "core/io/figure/policy_style.h"
#include "core/io/figure/report_style.h"
#include "core/io/study/study_figures.h"
#include "core/io/study/study_json.h"
#include "core/io/study/study_report_parts.h"
#include "core/io/text/html_text.h"

#include <algorithm>

namespace berg {

namespace {

constexpr double kFigure_px = 760; // width

constexpr std::string_view kStudyOpens = R"(<script type="application/json" id="study">)";
constexpr std::string_view kStudyCloses = "</script>";

/** Style rules for the colours of the policies in charts, light and dark. */
std::string policyStyleRules()
{
    std::string light;
    std::string dark;
    for (const PolicyStyle& style : kPolicyStyles) {
        if (style.light.empty())
            continue;
        const std::string rule = "svg .p-" + nameOf(kPolicyNames, style.policy) + " { --ink: ";
        light += rule + std::string(style.light) + "; }\n";
        dark += rule + std::string(style.dark) + "; }\n";
    }
    return light + "@media screen and (prefers-color-scheme: dark) {\n" + dark + "}\n";
}

std::string figureHtml(const std::string& heading, const Figure& figure, double height_px,
                       const std::string& caption)
{
    return "<section>\n<h2>" + heading + "</h2>\n<figure>\n" +
           figureSvg(figure, kFigure_px, height_px) + "<figcaption>" + caption +
           "</figcaption>\n</figure>\n</section>\n";
}

std::string zetaCaption(const StudySummary& summary, const ReportWords& words)
{
    const std::string caption =
        words.html(QT_TRANSLATE_NOOP("Report", "ζ is the total uncertainty σ of all icebergs, "
                                               "integrated over the flight. Lower is better.")) +
        ' ';
    if (summary.cases.size() == 1)
        return caption + words.html(QT_TRANSLATE_NOOP(
                             "Report", "There is only one case, so there is no spread to show."));
    return caption +
           words.html(
               QT_TRANSLATE_NOOP(
                   "Report",
                   "The line is the mean over the cases (%1), dashed their median; the band "
                   "contains the middle half of them. Horizontal lines are the means of policies "
                   "without τ."),
               {std::to_string(summary.cases.size())});
}

std::string differenceCaption(bool areAllDrawn, const ReportWords& words)
{
    std::string caption = words.html(QT_TRANSLATE_NOOP(
        "Report", "Differences are taken case by case, with the same icebergs and the same noise; "
                  "the bars are 95 % intervals of the mean (Student’s t). Values left of 0 are "
                  "better than the reference."));
    if (!areAllDrawn)
        caption += ' ' + words.html(QT_TRANSLATE_NOOP(
                             "Report", "Not every τ is drawn; the table contains all of them."));
    return caption;
}

std::string figuresHtml(const StudySummary& summary, const ReportWords& words)
{
    constexpr double kRow_px = 18;
    constexpr std::size_t kMostRows = 48;
    const StudyFigureFormat format{.words = words};
    const auto hasTau = [](const SettingSummary& s) { return s.setting.tau.has_value(); };
    std::string html;
    if (!summary.cases.empty() && std::ranges::count_if(summary.settings, hasTau) > 1)
        html =
            figureHtml(words.html(QT_TRANSLATE_NOOP("Report", "ζ against τ")),
                       zetaFigure(summary, format, kFigure_px), 420, zetaCaption(summary, words));
    if (summary.cases.size() < 2)
        return html;
    if (summary.settings.size() > 1) {
        const std::vector<std::size_t> rows = differenceRows(summary, kMostRows);
        html += figureHtml(words.html(QT_TRANSLATE_NOOP("Report", "Differences vs the reference")),
                           differenceFigure(summary, rows, format),
                           kFigureTop_px + kRow_px * static_cast<double>(rows.size()) +
                               kFigureBottom_px,
                           differenceCaption(rows.size() == summary.settings.size(), words));
    }
    if (summary.bestTau)
        html += figureHtml(
            words.html(QT_TRANSLATE_NOOP("Report", "Best τ of each case")),
            bestTauFigure(summary, format), 260,
            words.html(QT_TRANSLATE_NOOP(
                "Report", "The τ with the lowest ζ of a case, chosen in hindsight; it is not known "
                          "before the flight. If several are equal, the smallest counts.")));
    return html;
}

} // namespace

std::string studyReportHtml(const Study& study, const StudySummary& summary,
                            const ReportOrigin& origin)
{
    const ReportWords& words = origin.words;
    const std::string title = titleOf(study.spec, words);
    return reportHead({.title = title, .program = origin.program, .language = words.tag()},
                      policyStyleRules()) +
           "<body>\n<header>\n<h1>" + htmlName(title) + "</h1>\n" + "<p class=\"lead\">" +
           htmlText(origin.program) + ", " + htmlText(origin.madeUtc) +
           "</p>\n</header>\n<main>\n" + reportFindings(study, summary, words) +
           figuresHtml(summary, words) + reportTables(summary, words) + reportFacts(study, origin) +
           reportRecipe(study.spec, words) + "</main>\n" + std::string(kStudyOpens) + '\n' +
           scriptJson(studyToJson(study)) + std::string(kStudyCloses) + "\n</body>\n</html>\n";
}

bool isReport(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    return first != std::string_view::npos && text[first] == '<';
}

std::string studyOfReport(std::string_view html, const std::string& subject)
{
    const std::size_t opens = html.find(kStudyOpens);
    const std::size_t first = opens == std::string_view::npos ? opens : opens + kStudyOpens.size();
    const std::size_t closes = html.find(kStudyCloses, first);
    if (opens == std::string_view::npos || closes == std::string_view::npos)
        throw Error(ErrorCode::WrongFormat, subject, {IssueId::NoStudyInPage});
    return std::string(html.substr(first, closes - first));
}

} // namespace berg
