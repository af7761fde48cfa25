#include "core/io/study/study_report.h"

#include "core/io/figure/policy_looks.h"
#include "core/io/figure/report_style.h"
#include "core/io/study/study_charts.h"
#include "core/io/study/study_json.h"
#include "core/io/study/study_report_parts.h"
#include "core/io/text/html_text.h"

namespace berg {

namespace {

constexpr std::string_view kStudyOpens = R"(<script type="application/json" id="study">)";
constexpr std::string_view kStudyCloses = "</script>";

/** Colours of the policies in drawings, light and dark. */
std::string policyStyle()
{
    std::string light;
    std::string dark;
    for (const PolicyLook& look : kPolicyLooks) {
        if (look.light.empty())
            continue;
        const std::string rule = "svg .p-" + nameOf(kPolicyNames, look.policy) + " { --ink: ";
        light += rule + std::string(look.light) + "; }\n";
        dark += rule + std::string(look.dark) + "; }\n";
    }
    return light + "@media screen and (prefers-color-scheme: dark) {\n" + dark + "}\n";
}

std::string figureHtml(const std::string& heading, const std::string& drawing,
                       const std::string& caption)
{
    if (drawing.empty())
        return {};
    return "<section>\n<h2>" + heading + "</h2>\n<figure>\n" + drawing + "<figcaption>" + caption +
           "</figcaption>\n</figure>\n</section>\n";
}

std::string zetaCaption(const StudySummary& summary, const ReportWords& words)
{
    const std::string caption =
        words.html(QT_TRANSLATE_NOOP("Report", "ζ is the integral over the flight of the "
                                               "uncertainty σ of all icebergs together: less is "
                                               "better.")) +
        ' ';
    if (summary.cases.size() == 1)
        return caption + words.html(QT_TRANSLATE_NOOP("Report", "One case, so there is no spread "
                                                                "to show."));
    return caption +
           words.html(QT_TRANSLATE_NOOP("Report",
                                        "The line is the mean over the cases (%1), the bands hold "
                                        "the middle half and 80 % of them. Lines across are the "
                                        "means of policies that have no τ."),
                      {std::to_string(summary.cases.size())});
}

std::string differenceCaption(const StudySummary& summary, const ReportWords& words)
{
    std::string caption = words.html(
        QT_TRANSLATE_NOOP("Report", "Each case is compared with itself, on the same icebergs and "
                                    "the same noise; the bars are 95 % intervals of the mean "
                                    "(Student’s t). Left of 0 is better than the reference."));
    if (drawnDifferences(summary).size() < summary.settings.size())
        caption += ' ' + words.html(QT_TRANSLATE_NOOP("Report", "Not every τ is drawn; all are in "
                                                                "the table."));
    return caption;
}

std::string figuresHtml(const StudySummary& summary, const ReportWords& words)
{
    return figureHtml(words.html(QT_TRANSLATE_NOOP("Report", "ζ against τ")),
                      zetaChart(summary, words), zetaCaption(summary, words)) +
           figureHtml(words.html(QT_TRANSLATE_NOOP("Report", "Differences vs the reference")),
                      differenceChart(summary, words), differenceCaption(summary, words)) +
           figureHtml(words.html(QT_TRANSLATE_NOOP("Report", "Best τ of each case")),
                      bestTauChart(summary, words),
                      words.html(QT_TRANSLATE_NOOP(
                          "Report", "The τ with the lowest ζ of a case, chosen in hindsight: "
                                    "nobody knows it before the flight. Of equal ones the "
                                    "smallest counts.")));
}

} // namespace

std::string studyReportHtml(const Study& study, const StudySummary& summary,
                            const ReportOrigin& origin)
{
    const ReportWords& words = origin.words;
    const std::string title = titleOf(study.spec, words);
    return reportHead({.title = title, .program = origin.program, .language = words.tag()},
                      policyStyle()) +
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
