#include "core/base/number_text.h"
#include "core/io/study/study_charts.h"
#include "core/io/study/study_report_parts.h"
#include "core/io/text/html_text.h"

#include <algorithm>
#include <map>

namespace berg {

namespace {

constexpr int kZetaDigits = 5;
const std::string kStuckMeans =
    "Stuck: two icebergs at most as targets in the last half of the flight.";

/** The same for a whole column: digits of the reference. */
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

/** One case has no spread: zeta and the differences in one table. */
std::string oneCaseTable(const StudySummary& summary)
{
    const int decimals = zetaDecimals(summary);
    HtmlTable table("ζ of the case and its difference to " +
                        settingName(summary.settings[summary.reference].setting) + ". " +
                        kStuckMeans,
                    {"Setting", "ζ, m² s", "Difference, m² s", "Difference, %", "Visits", "Stuck"});
    for (std::size_t i = 0; i < summary.settings.size(); ++i) {
        const SettingSummary& s = summary.settings[i];
        const PairedDifference& d = summary.differences[i];
        table.addRow({settingName(s.setting), printedNumber(s.zeta_m2s.mean, decimals),
                      signedNumber(d.zeta_m2s.mean, decimals),
                      signedNumber(100 * d.relative.mean, 2), printedNumber(s.meanVisits, 0),
                      s.stuckShare > 0 ? "yes" : "no"},
                     i == summary.reference);
    }
    return table.html();
}

std::string settingsTable(const StudySummary& summary)
{
    const int decimals = zetaDecimals(summary);
    const auto zeta = [decimals](double value_m2s) { return printedNumber(value_m2s, decimals); };
    HtmlTable table("ζ in m² s over " + std::to_string(summary.cases.size()) + " cases. " +
                        kStuckMeans,
                    {"Setting", "Mean", "Standard error", "10 %", "25 %", "Median", "75 %", "90 %",
                     "Visits", "Stuck"});
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

std::string differencesTable(const StudySummary& summary)
{
    const int decimals = zetaDecimals(summary);
    HtmlTable table("Differences of ζ to " +
                        settingName(summary.settings[summary.reference].setting) +
                        ", case by case, with 95 % intervals of the mean. Worst: the largest "
                        "difference of a case.",
                    {"Setting", "Mean, m² s", "95 % interval", "Mean, %", "95 % interval",
                     "Cases below", "Worst"});
    for (std::size_t i = 0; i < summary.differences.size(); ++i) {
        const PairedDifference& d = summary.differences[i];
        if (i == summary.reference) {
            table.addRow({settingName(d.setting), "reference", "", "", "", "", ""}, true);
            continue;
        }
        table.addRow({settingName(d.setting), signedNumber(d.zeta_m2s.mean, decimals),
                      interval(d.zeta_m2s, 1, decimals), signedNumber(100 * d.relative.mean, 2),
                      interval(d.relative, 100, 2), percent(d.lowerShare), change(d.worst)});
    }
    if (const auto& best = summary.bestTau)
        table.addRow({"best τ of each case", "", "", signedNumber(100 * best->relative.mean, 2),
                      interval(best->relative, 100, 2), "", ""});
    return table.html();
}

std::string bestTauTable(const BestTau& best)
{
    std::map<double, std::size_t> counts;
    for (const double tau : best.byCase)
        ++counts[tau];
    HtmlTable table("Best τ of each case, chosen in hindsight", {"Setting", "Cases", "Share"});
    for (const auto& [tau, count] : counts)
        table.addRow(
            {settingName({.tau = tau}), std::to_string(count),
             percent(static_cast<double>(count) / static_cast<double>(best.byCase.size()))});
    return table.html();
}

/** The policy to fly by these cases, where one is surely the best. */
std::string recommendedText(const StudySummary& summary)
{
    const Recommendation& best = *summary.recommendation;
    if (!best.next)
        return {};
    const auto name = [&](std::size_t s) { return settingName(summary.settings[s].setting); };
    if (summary.cases.size() == 1)
        return "<li>One case recommends no policy: fly more of them.</li>\n";
    const std::string against =
        change(best.relative.mean) + " (" + interval(best.relative, 100, 1) + ") against ";
    if (best.isSure)
        return "<li>Recommended: <strong>" + name(best.setting) + "</strong>, " + against +
               name(*best.next) + ", the best of another policy.</li>\n";
    return "<li>No policy is surely the best: " + name(best.setting) + " is " + against +
           name(*best.next) + ".</li>\n";
}

/** The setting of lowest mean zeta, and how it compares. */
std::string lowestText(const StudySummary& summary)
{
    const std::size_t index = summary.recommendation->setting;
    const SettingSummary& lowest = summary.settings[index];
    const bool isOneCase = summary.cases.size() == 1;
    std::string text = (isOneCase ? "Lowest ζ: <strong>" : "Lowest mean ζ: <strong>") +
                       settingName(lowest.setting) + "</strong>, " +
                       printedNumber(lowest.zeta_m2s.mean, zetaDecimals(summary)) + " m² s";
    const MeanInterval& relative = summary.differences[index].relative;
    if (index != summary.reference)
        text += ", " + change(relative.mean) +
                (isOneCase ? std::string() : " (" + interval(relative, 100, 1) + ")") +
                " against " + settingName(summary.settings[summary.reference].setting);
    return "<li>" + text + ".</li>\n";
}

std::string bestTauText(const StudySummary& summary)
{
    if (!summary.bestTau)
        return {};
    const BestTau& best = *summary.bestTau;
    if (summary.cases.size() == 1)
        return "<li>Best τ of this case: <strong>" + settingName({.tau = best.tau.mean}) +
               "</strong>.</li>\n";
    return "<li>Best τ of each case, chosen in hindsight: median " +
           printedNumber(best.tau.median, 2) + ", 80 % of the cases between " +
           printedNumber(best.tau.decile1, 2) + " and " + printedNumber(best.tau.decile9, 2) +
           "; its mean ζ is " + change(best.relative.mean) + " (" +
           interval(best.relative, 100, 1) + ") against " +
           settingName(summary.settings[summary.reference].setting) + ".</li>\n";
}

} // namespace

std::string reportFindings(const Study& study, const StudySummary& summary)
{
    const std::size_t flown = flownCount(study);
    const std::size_t missions = missionCount(study.spec);
    const auto count = [](std::size_t n) { return printedNumber(static_cast<double>(n), 0); };
    std::string html;
    if (flown < missions)
        html = "<p class=\"incomplete\"><strong>Not complete:</strong> " + count(flown) + " of " +
               count(missions) + " missions are flown. Everything below is of the " +
               count(summary.cases.size()) + " of " + count(caseCount(study.spec)) +
               " cases that every setting has flown.</p>\n";
    else
        html = "<p>" + count(missions) + (missions == 1 ? " mission: " : " missions: ") +
               count(summary.cases.size()) + (summary.cases.size() == 1 ? " case" : " cases") +
               ", each flown with " + count(summary.settings.size()) +
               (summary.settings.size() == 1 ? " setting" : " settings") + ".</p>\n";
    if (summary.cases.empty())
        return html;
    return html + "<ul class=\"findings\">\n" + recommendedText(summary) + lowestText(summary) +
           bestTauText(summary) + "</ul>\n";
}

std::string reportTables(const StudySummary& summary)
{
    if (summary.cases.empty())
        return {};
    const std::string opens = "<section>\n<h2>The numbers</h2>\n";
    const std::string closes = "</section>\n";
    if (summary.cases.size() == 1)
        return opens + oneCaseTable(summary) + closes;
    return opens + settingsTable(summary) +
           (summary.settings.size() > 1 ? differencesTable(summary) : std::string()) +
           (summary.bestTau ? bestTauTable(*summary.bestTau) : std::string()) + closes;
}

} // namespace berg
