#include "core/base/number_text.h"
#include "core/io/study/study_figures.h"
#include "core/io/study/study_report_parts.h"
#include "core/io/text/html_text.h"

#include <algorithm>
#include <map>

namespace berg {

namespace {

constexpr int kZetaDigits = 5;
constexpr std::string_view kStuckMeans = QT_TRANSLATE_NOOP(
    "Report", "Stuck: at most two icebergs were targets in the second half of the flight.");

/** Decimals for a whole column, so that the reference has `kZetaDigits` digits. */
int zetaDecimals(const StudySummary& summary)
{
    return decimalsFor(summary.settings[summary.reference].zeta_m2s.mean, kZetaDigits);
}

std::string percent(double share)
{
    return printedNumber(100 * share, 1) + " %";
}

std::string change(double share)
{
    return signedNumber(100 * share, 1) + " %";
}

std::string interval(const MeanInterval& values, double scale, int decimals)
{
    return signedNumber(scale * values.low, decimals) + " … " +
           signedNumber(scale * values.high, decimals);
}

std::string strong(const std::string& html)
{
    return "<strong>" + html + "</strong>";
}

std::string item(const std::string& html)
{
    return "<li>" + html + "</li>\n";
}

/** Table for a single case, which has no spread: zeta and differences together. */
std::string oneCaseTable(const StudySummary& summary, const ReportWords& words)
{
    const int decimals = zetaDecimals(summary);
    HtmlTable table(
        words.html(QT_TRANSLATE_NOOP("Report", "ζ of the case and its difference vs %1."),
                   {settingName(summary.settings[summary.reference].setting)}) +
            ' ' + words.html(kStuckMeans),
        words.heads({QT_TRANSLATE_NOOP("Report", "Setting"), "ζ, m² s",
                     QT_TRANSLATE_NOOP("Report", "Difference, m² s"),
                     QT_TRANSLATE_NOOP("Report", "Difference, %"),
                     QT_TRANSLATE_NOOP("Report", "Visits"), QT_TRANSLATE_NOOP("Report", "Stuck")}));
    for (std::size_t i = 0; i < summary.settings.size(); ++i) {
        const SettingSummary& s = summary.settings[i];
        const PairedDifference& d = summary.differences[i];
        table.addRow({settingName(s.setting), printedNumber(s.zeta_m2s.mean, decimals),
                      signedNumber(d.zeta_m2s.mean, decimals),
                      signedNumber(100 * d.relative.mean, 2), printedNumber(s.meanVisits, 0),
                      words.html(s.stuckShare > 0 ? QT_TRANSLATE_NOOP("Report", "yes")
                                                  : QT_TRANSLATE_NOOP("Report", "no"))},
                     i == summary.reference);
    }
    return table.html();
}

std::string settingsTable(const StudySummary& summary, const ReportWords& words)
{
    const int decimals = zetaDecimals(summary);
    const auto zeta = [decimals](double value_m2s) { return printedNumber(value_m2s, decimals); };
    HtmlTable table(
        words.html(QT_TRANSLATE_NOOP("Report", "ζ in m² s. Cases: %1."),
                   {std::to_string(summary.cases.size())}) +
            ' ' + words.html(kStuckMeans),
        words.heads({QT_TRANSLATE_NOOP("Report", "Setting"), QT_TRANSLATE_NOOP("Report", "Mean"),
                     QT_TRANSLATE_NOOP("Report", "Standard error"), "10 %", "25 %",
                     QT_TRANSLATE_NOOP("Report", "Median"), "75 %", "90 %",
                     QT_TRANSLATE_NOOP("Report", "Visits"), QT_TRANSLATE_NOOP("Report", "Stuck")}));
    for (std::size_t i = 0; i < summary.settings.size(); ++i) {
        const SettingSummary& s = summary.settings[i];
        const Summary& z = s.zeta_m2s;
        table.addRow({settingName(s.setting), zeta(z.mean), zeta(z.standardError), zeta(z.decile1),
                      zeta(z.quartile1), zeta(z.median), zeta(z.quartile3), zeta(z.decile9),
                      printedNumber(s.meanVisits, 1), percent(s.stuckShare)},
                     i == summary.reference);
    }
    return table.html();
}

std::string differencesTable(const StudySummary& summary, const ReportWords& words)
{
    const int decimals = zetaDecimals(summary);
    HtmlTable table(
        words.html(QT_TRANSLATE_NOOP("Report",
                                     "Differences of ζ vs %1, case by case, with 95 % intervals of "
                                     "the mean. Worst: the largest difference of a case."),
                   {settingName(summary.settings[summary.reference].setting)}),
        words.heads(
            {QT_TRANSLATE_NOOP("Report", "Setting"), QT_TRANSLATE_NOOP("Report", "Mean, m² s"),
             QT_TRANSLATE_NOOP("Report", "95 % interval"), QT_TRANSLATE_NOOP("Report", "Mean, %"),
             QT_TRANSLATE_NOOP("Report", "95 % interval"),
             QT_TRANSLATE_NOOP("Report", "Cases below"), QT_TRANSLATE_NOOP("Report", "Worst")}));
    for (std::size_t i = 0; i < summary.differences.size(); ++i) {
        const PairedDifference& d = summary.differences[i];
        if (i == summary.reference) {
            table.addRow({settingName(d.setting),
                          words.html(QT_TRANSLATE_NOOP("Report", "reference")), "", "", "", "", ""},
                         true);
            continue;
        }
        table.addRow({settingName(d.setting), signedNumber(d.zeta_m2s.mean, decimals),
                      interval(d.zeta_m2s, 1, decimals), signedNumber(100 * d.relative.mean, 2),
                      interval(d.relative, 100, 2), percent(d.lowerShare), change(d.worst)});
    }
    if (const auto& best = summary.bestTau)
        table.addRow({words.html(QT_TRANSLATE_NOOP("Report", "best τ of each case")), "", "",
                      signedNumber(100 * best->relative.mean, 2), interval(best->relative, 100, 2),
                      "", ""});
    return table.html();
}

std::string bestTauTable(const BestTau& best, const ReportWords& words)
{
    std::map<double, std::size_t> counts;
    for (const double tau : best.byCase)
        ++counts[tau];
    HtmlTable table(
        words.html(QT_TRANSLATE_NOOP("Report", "Best τ of each case, chosen in hindsight")),
        words.heads({QT_TRANSLATE_NOOP("Report", "Setting"), QT_TRANSLATE_NOOP("Report", "Cases"),
                     QT_TRANSLATE_NOOP("Report", "Share")}));
    for (const auto& [tau, count] : counts)
        table.addRow(
            {settingName({.tau = tau}), std::to_string(count),
             percent(static_cast<double>(count) / static_cast<double>(best.byCase.size()))});
    return table.html();
}

/** Names of the settings, shortened after the first few. */
std::string contendersText(const StudySummary& summary, const ReportWords& words)
{
    constexpr std::size_t kMost = 4;
    const std::vector<std::size_t>& settings = summary.recommendation->contenders;
    std::string names;
    for (std::size_t i = 0; i < std::min(kMost, settings.size()); ++i)
        names += (i > 0 ? ", " : "") + strong(settingName(summary.settings[settings[i]].setting));
    if (settings.size() <= kMost)
        return names;
    return words.html(QT_TRANSLATE_NOOP("Report", "%1 and %2 more"),
                      {names, std::to_string(settings.size() - kMost)});
}

/** Names the recommended setting, or the candidates if none is clearly the best. */
std::string recommendedText(const StudySummary& summary, const ReportWords& words)
{
    const Recommendation& found = *summary.recommendation;
    if (summary.settings.size() == 1)
        return {};
    if (summary.cases.size() == 1)
        return item(words.html(QT_TRANSLATE_NOOP(
            "Report", "One case is too few to recommend a policy. Fly more cases.")));
    if (!found.best)
        return item(words.html(
            QT_TRANSLATE_NOOP("Report", "No clear winner. These settings may be the best: %1."),
            {contendersText(summary, words)}));
    const auto name = [&](std::size_t s) { return settingName(summary.settings[s].setting); };
    return item(words.html(
        QT_TRANSLATE_NOOP("Report", "Recommended: %1, %2 against %3, the closest other setting."),
        {strong(name(*found.best)),
         change(found.relative.mean) + " (" + interval(found.relative, 100, 1) + ")",
         name(*found.next)}));
}

/**
 * Names the setting of lowest mean zeta. Its difference from the reference is reported for a single
 * case only: over several cases the mean of the differences may contradict the means.
 */
std::string lowestText(const StudySummary& summary, const ReportWords& words)
{
    const std::size_t index = summary.recommendation->lowest;
    const SettingSummary& lowest = summary.settings[index];
    const bool isOneCase = summary.cases.size() == 1;
    std::vector<std::string> arguments{strong(settingName(lowest.setting)),
                                       printedNumber(lowest.zeta_m2s.mean, zetaDecimals(summary))};
    if (!isOneCase)
        return item(
            words.html(QT_TRANSLATE_NOOP("Report", "Lowest mean ζ: %1, %2 m² s."), arguments));
    if (index == summary.reference)
        return item(words.html(QT_TRANSLATE_NOOP("Report", "Lowest ζ: %1, %2 m² s."), arguments));
    arguments.push_back(change(summary.differences[index].relative.mean));
    arguments.push_back(settingName(summary.settings[summary.reference].setting));
    return item(words.html(QT_TRANSLATE_NOOP("Report", "Lowest ζ: %1, %2 m² s, %3 against %4."),
                           arguments));
}

std::string bestTauText(const StudySummary& summary, const ReportWords& words)
{
    if (!summary.bestTau)
        return {};
    const BestTau& best = *summary.bestTau;
    if (summary.cases.size() == 1)
        return item(words.html(QT_TRANSLATE_NOOP("Report", "Best τ of this case: %1."),
                               {strong(settingName({.tau = best.tau.mean}))}));
    return item(words.html(
        QT_TRANSLATE_NOOP("Report", "Best τ of each case, chosen in hindsight: median %1, 80 % of "
                                    "the cases between %2 and %3; its mean ζ is %4 against %5."),
        {printedNumber(best.tau.median, 2), printedNumber(best.tau.decile1, 2),
         printedNumber(best.tau.decile9, 2),
         change(best.relative.mean) + " (" + interval(best.relative, 100, 1) + ")",
         settingName(summary.settings[summary.reference].setting)}));
}

} // namespace

std::string reportFindings(const Study& study, const StudySummary& summary,
                           const ReportWords& words)
{
    const std::size_t flown = flownCount(study);
    const std::size_t missions = missionCount(study.spec);
    const auto count = [](std::size_t n) { return printedNumber(static_cast<double>(n), 0); };
    std::string html;
    if (flown < missions)
        html = "<p class=\"incomplete\">" +
               strong(words.html(QT_TRANSLATE_NOOP("Report", "Not complete."))) + ' ' +
               words.html(QT_TRANSLATE_NOOP("Report",
                                            "Missions flown: %1 of %2. The results below use only "
                                            "the cases that every setting has flown: %3 of %4."),
                          {count(flown), count(missions), count(summary.cases.size()),
                           count(caseCount(study.spec))}) +
               "</p>\n";
    else
        html = "<p>" +
               words.html(
                   QT_TRANSLATE_NOOP("Report", "Missions: %1. Cases: %2, each flown with "
                                               "every setting. Settings: %3."),
                   {count(missions), count(summary.cases.size()), count(summary.settings.size())}) +
               "</p>\n";
    if (summary.cases.empty())
        return html;
    return html + "<ul class=\"findings\">\n" + recommendedText(summary, words) +
           lowestText(summary, words) + bestTauText(summary, words) + "</ul>\n";
}

std::string reportTables(const StudySummary& summary, const ReportWords& words)
{
    if (summary.cases.empty())
        return {};
    const std::string opens =
        "<section>\n<h2>" + words.html(QT_TRANSLATE_NOOP("Report", "The numbers")) + "</h2>\n";
    const std::string closes = "</section>\n";
    if (summary.cases.size() == 1)
        return opens + oneCaseTable(summary, words) + closes;
    return opens + settingsTable(summary, words) +
           (summary.settings.size() > 1 ? differencesTable(summary, words) : std::string()) +
           (summary.bestTau ? bestTauTable(*summary.bestTau, words) : std::string()) + closes;
}

} // namespace berg
