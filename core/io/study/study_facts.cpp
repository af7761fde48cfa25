#include "core/base/number_text.h"
#include "core/io/results/result_csv.h"
#include "core/io/study/study_report_parts.h"
#include "core/io/text/html_text.h"
#include "core/plan/policy/policy.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace berg {

namespace {

std::string counted(double count)
{
    return printedNumber(count, 0);
}

/** Duration as "72.4 s", "12 min 5 s" or "3 h 7 min". */
std::string durationText(double seconds)
{
    constexpr double kMinute_s = 60;
    constexpr double kHour_s = 3600;
    if (seconds < 2 * kMinute_s)
        return fixedText(seconds, 1) + " s";
    const double whole = std::round(seconds);
    if (whole < kHour_s)
        return fixedText(std::floor(whole / kMinute_s), 0) + " min " +
               fixedText(std::fmod(whole, kMinute_s), 0) + " s";
    return printedNumber(std::floor(whole / kHour_s), 0) + " h " +
           fixedText(std::floor(std::fmod(whole, kHour_s) / kMinute_s), 0) + " min";
}

std::string scenarioHtml(const Scenario& scenario, const ReportWords& words)
{
    const std::string name =
        scenario.name.empty() ? words.html(QT_TRANSLATE_NOOP("Report", "a scenario without a name"))
                              : htmlName(scenario.name);
    return words.html(
               QT_TRANSLATE_NOOP("Report", "%1: icebergs: %2, seed %3, %4 s in steps of %5 s"),
               {name, counted(static_cast<double>(scenario.icebergs.size())),
                std::to_string(scenario.seed), numberText(scenario.duration_s),
                numberText(scenario.dt_s)}) +
           (scenario.noise ? std::string()
                           : ", " + words.html(QT_TRANSLATE_NOOP("Report", "without noise")));
}

std::string regimeHtml(FieldRegime regime, const ReportWords& words)
{
    switch (regime) {
    case FieldRegime::Published:
        return {};
    case FieldRegime::Measured:
        return ", " +
               words.html(QT_TRANSLATE_NOOP("Report", "measured with noise, velocities known"));
    case FieldRegime::UnknownVelocity:
        return ", " + words.html(QT_TRANSLATE_NOOP(
                          "Report", "measured with noise, velocities uncertain by 0.1 m/s"));
    case FieldRegime::FittedDrift:
        return ", " +
               words.html(QT_TRANSLATE_NOOP("Report", "measured with noise, unknown velocities "
                                                      "that change like those of real icebergs"));
    }
    return {};
}

std::string randomHtml(const StudySpec& spec, const ReportWords& words)
{
    const FieldSpec& field = spec.field;
    const std::int64_t last = spec.firstSeed + spec.random - 1;
    return words.html(QT_TRANSLATE_NOOP("Report",
                                        "Random fields: %1, seeds %2 to %3. Icebergs in each: "
                                        "%4, in %5 m × %6 m, drifting at up to %7 m/s"),
                      {counted(spec.random), std::to_string(spec.firstSeed), std::to_string(last),
                       counted(field.icebergs), numberText(field.size_m.x()),
                       numberText(field.size_m.y()), numberText(field.speedMax_mps)}) +
           ", " +
           words.html(
               QT_TRANSLATE_NOOP("Report", "initial σ of %1 to %2 m², growing by q = %3 m²/s"),
               {numberText(field.sigmaMin_m2), numberText(field.sigmaMax_m2),
                numberText(field.q_m2ps)}) +
           regimeHtml(field.regime, words);
}

std::string fact(const std::string& term, const std::string& html)
{
    return html.empty() ? html : "<dt>" + term + "</dt>\n<dd>" + html + "</dd>\n";
}

std::string scenariosHtml(const StudySpec& spec, const ReportWords& words)
{
    std::string html;
    for (const Scenario& scenario : spec.scenarios)
        html += "<dd>" + scenarioHtml(scenario, words) + "</dd>\n";
    if (spec.random > 0)
        html += "<dd>" + randomHtml(spec, words) + "</dd>\n";
    return "<dt>" + words.html(QT_TRANSLATE_NOOP("Report", "Scenarios")) + "</dt>\n" + html;
}

std::string policiesHtml(const StudySpec& spec, const ReportWords& words)
{
    std::string html = "<dt>" + words.html(QT_TRANSLATE_NOOP("Report", "Policies")) + "</dt>\n";
    for (const PolicyKind policy : std::set(spec.policies.begin(), spec.policies.end()))
        html += "<dd><strong>" + std::string(traitsOf(policy).name) +
                "</strong>: " + words.html(traitsOf(policy).about) + "</dd>\n";
    return html;
}

std::string noiseHtml(const StudySpec& spec, const ReportWords& words)
{
    if (spec.runs == 1)
        return words.html(
            QT_TRANSLATE_NOOP("Report", "the scenario’s own seed, the same for every setting"));
    return words.html(
        QT_TRANSLATE_NOOP(
            "Report",
            "seeds for each scenario: %1, starting with its own, the same for every setting"),
        {std::to_string(spec.runs)});
}

/** Returns the step of evenly spaced ascending values, or nullopt if they are not evenly spaced. */
std::optional<double> evenStep(const std::vector<double>& taus)
{
    constexpr double kSame = 1e-9;
    constexpr std::size_t kFewest = 4; // a list of fewer values is shorter
    if (taus.size() < kFewest)
        return std::nullopt;
    const double step =
        std::round((taus.back() - taus.front()) / static_cast<double>(taus.size() - 1) / kSame) *
        kSame;
    for (std::size_t i = 0; i < taus.size(); ++i)
        if (!(step > 0) || std::abs(taus.front() + static_cast<double>(i) * step - taus[i]) > kSame)
            return std::nullopt;
    return step;
}

/** Text "0 to 4 by 0.1 (41 values)", or the list of values. */
std::string tausInWords(const std::vector<double>& taus, const ReportWords& words)
{
    const std::optional<double> step = evenStep(taus);
    if (!step)
        return joined(taus, ", ", numberText);
    return words.html(QT_TRANSLATE_NOOP("Report", "%1 to %2 by %3 (%4 values)"),
                      {numberText(taus.front()), numberText(taus.back()), numberText(*step),
                       std::to_string(taus.size())});
}

std::string tausFlown(const StudySpec& spec, const ReportWords& words)
{
    const bool isFlown = std::ranges::any_of(
        spec.policies, [](PolicyKind policy) { return traitsOf(policy).usesTau; });
    return isFlown ? tausInWords(spec.taus, words) : std::string();
}

/** Value of the option --tau. */
std::string tauArgument(const std::vector<double>& taus)
{
    const std::optional<double> step = evenStep(taus);
    if (!step)
        return joined(taus, ",", numberText);
    return numberText(taus.front()) + ':' + numberText(taus.back()) + ':' + numberText(*step);
}

/** Command that flies the same missions; the study does not store the names of its files. */
std::string sweepCommand(const StudySpec& spec)
{
    std::string command = "bergwatch-cli sweep";
    if (!spec.scenarios.empty())
        command += " SCENARIO...";
    if (spec.random > 0)
        command += " --random " + std::to_string(spec.random) + " --first-seed " +
                   std::to_string(spec.firstSeed);
    if (spec.random > 0 && spec.field.regime != FieldRegime::Published)
        command += " --regime " + nameOf(kFieldRegimeNames, spec.field.regime);
    if (!spec.taus.empty())
        command += " --tau " + tauArgument(spec.taus);
    const auto name = [](PolicyKind policy) { return nameOf(kPolicyNames, policy); };
    command += " --policies " + joined(spec.policies, ",", name);
    if (spec.runs > 1)
        command += " --runs " + std::to_string(spec.runs);
    return command;
}

} // namespace

std::string titleOf(const StudySpec& spec, const ReportWords& words)
{
    if (!spec.name.empty())
        return spec.name;
    const std::size_t scenarios = spec.scenarios.size() + static_cast<std::size_t>(spec.random);
    if (scenarios == 1 && !spec.scenarios.empty() && !spec.scenarios.front().name.empty())
        return spec.scenarios.front().name;
    if (spec.scenarios.empty())
        return words.text(QT_TRANSLATE_NOOP("Report", "Random fields: %1, icebergs in each: %2"),
                          {counted(spec.random), counted(spec.field.icebergs)});
    return words.text(QT_TRANSLATE_NOOP("Report", "Study, scenarios: %1"),
                      {counted(static_cast<double>(scenarios))});
}

std::string reportFacts(const Study& study, const ReportOrigin& origin)
{
    const StudySpec& spec = study.spec;
    const ReportWords& words = origin.words;
    const auto term = [&](std::string_view english, const std::string& html) {
        return fact(words.html(english), html);
    };
    return "<section>\n<h2>" + words.html(QT_TRANSLATE_NOOP("Report", "What was flown")) +
           "</h2>\n<dl>\n" + scenariosHtml(spec, words) +
           term(QT_TRANSLATE_NOOP("Report", "Trade-off τ"), tausFlown(spec, words)) +
           policiesHtml(spec, words) +
           term(QT_TRANSLATE_NOOP("Report", "Noise"), noiseHtml(spec, words)) +
           term(QT_TRANSLATE_NOOP("Report", "Missions"),
                words.html(QT_TRANSLATE_NOOP("Report", "%1 of %2"),
                           {counted(static_cast<double>(flownCount(study))),
                            counted(static_cast<double>(missionCount(spec)))})) +
           term(QT_TRANSLATE_NOOP("Report", "Program"), htmlText(origin.program)) +
           term(QT_TRANSLATE_NOOP("Report", "Machine"), htmlText(origin.machine)) +
           term(QT_TRANSLATE_NOOP("Report", "Created"), htmlText(origin.madeUtc)) +
           term(QT_TRANSLATE_NOOP("Report", "Last run took"),
                origin.elapsed_s ? durationText(*origin.elapsed_s) : std::string()) +
           "</dl>\n</section>\n";
}

std::string reportRecipe(const StudySpec& spec, const ReportWords& words)
{
    std::string html =
        "<section>\n<h2>" +
        words.html(QT_TRANSLATE_NOOP("Report", "How to reproduce this report")) + "</h2>\n<p>" +
        words.html(QT_TRANSLATE_NOOP(
            "Report",
            "This page contains the whole study with every scenario, seed and result, and "
            "Bergwatch opens it as a study file. To make the page again from these results:")) +
        "</p>\n<pre><code>bergwatch-cli study REPORT.html --report AGAIN.html</code></pre>\n";
    // The command line cannot set other parameters of random fields.
    if (spec.random == 0 || spec.field == FieldSpec{.regime = spec.field.regime})
        html +=
            "<p>" +
            words.html(spec.scenarios.empty()
                           ? QT_TRANSLATE_NOOP("Report",
                                               "To fly the study again; the results depend neither "
                                               "on the machine nor on the number of threads:")
                           : QT_TRANSLATE_NOOP(
                                 "Report",
                                 "To fly the study again with your scenario files; the results "
                                 "depend neither on the machine nor on the number of threads:")) +
            "</p>\n<pre><code>" + htmlText(sweepCommand(spec)) +
            " --report AGAIN.html</code></pre>\n";
    return html + "</section>\n";
}

} // namespace berg
