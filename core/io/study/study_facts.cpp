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

std::string counted(double count, const std::string& one, const std::string& many)
{
    return printedNumber(count, 0) + ' ' + (count == 1 ? one : many);
}

/** "72.4 s", "12 min 5 s", "3 h 7 min" */
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

std::string scenarioHtml(const Scenario& scenario)
{
    const std::string name =
        scenario.name.empty() ? "a scenario without a name" : htmlName(scenario.name);
    return name + ": " +
           counted(static_cast<double>(scenario.icebergs.size()), "iceberg", "icebergs") +
           ", seed " + std::to_string(scenario.seed) + ", " + numberText(scenario.duration_s) +
           " s in steps of " + numberText(scenario.dt_s) + " s" +
           (scenario.noise ? "" : ", without noise");
}

std::string regimeHtml(FieldRegime regime)
{
    switch (regime) {
    case FieldRegime::Published:
        return {};
    case FieldRegime::Measured:
        return ", measured with noise, velocities known";
    case FieldRegime::UnknownVelocity:
        return ", measured with noise, velocities not known by 0.1 m/s";
    case FieldRegime::FittedDrift:
        return ", measured with noise, with unknown velocities that change as those of icebergs do";
    }
    return {};
}

std::string randomHtml(const StudySpec& spec)
{
    const FieldSpec& field = spec.field;
    const std::int64_t last = spec.firstSeed + spec.random - 1;
    return counted(spec.random, "random field", "random fields") + ", " +
           (spec.random == 1
                ? "seed " + std::to_string(spec.firstSeed)
                : "seeds " + std::to_string(spec.firstSeed) + " to " + std::to_string(last)) +
           ": " + counted(field.icebergs, "iceberg", "icebergs") + " in " +
           numberText(field.size_m.x()) + " m × " + numberText(field.size_m.y()) +
           " m, drifting at up to " + numberText(field.speedMax_mps) + " m/s, σ at first " +
           numberText(field.sigmaMin_m2) + " to " + numberText(field.sigmaMax_m2) +
           " m², growing by q = " + numberText(field.q_m2ps) + " m²/s" + regimeHtml(field.regime);
}

std::string scenariosHtml(const StudySpec& spec)
{
    std::string html;
    for (const Scenario& scenario : spec.scenarios)
        html += "<dd>" + scenarioHtml(scenario) + "</dd>\n";
    if (spec.random > 0)
        html += "<dd>" + randomHtml(spec) + "</dd>\n";
    return "<dt>Scenarios</dt>\n" + html;
}

std::string fact(const std::string& term, const std::string& html)
{
    return html.empty() ? html : "<dt>" + term + "</dt>\n<dd>" + html + "</dd>\n";
}

std::string policiesHtml(const StudySpec& spec)
{
    std::string html = "<dt>Policies</dt>\n";
    for (const PolicyKind policy : std::set(spec.policies.begin(), spec.policies.end()))
        html += "<dd><strong>" + std::string(traitsOf(policy).name) +
                "</strong>: " + std::string(traitsOf(policy).meaning) + "</dd>\n";
    return html;
}

std::string noiseHtml(const StudySpec& spec)
{
    if (spec.runs == 1)
        return "the scenario’s own seed, the same for every setting";
    return std::to_string(spec.runs) +
           " seeds for each scenario, its own first, the same for every setting";
}

/** Step of evenly spaced ascending values, none when they are not. */
std::optional<double> evenStep(const std::vector<double>& taus)
{
    constexpr double kSame = 1e-9;
    constexpr std::size_t kFewest = 4; // fewer are shorter as they are
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

std::string listed(const std::vector<double>& taus, const std::string& separator)
{
    std::string text;
    for (const double tau : taus)
        text += (text.empty() ? "" : separator) + numberText(tau);
    return text;
}

/** "0 to 4 by 0.1 (41 values)", or the values themselves. */
std::string tausInWords(const std::vector<double>& taus)
{
    const std::optional<double> step = evenStep(taus);
    if (!step)
        return listed(taus, ", ");
    return numberText(taus.front()) + " to " + numberText(taus.back()) + " by " +
           numberText(*step) + " (" + std::to_string(taus.size()) + " values)";
}

std::string tausFlown(const StudySpec& spec)
{
    const bool isFlown = std::ranges::any_of(
        spec.policies, [](PolicyKind policy) { return traitsOf(policy).usesTau; });
    return isFlown ? tausInWords(spec.taus) : std::string();
}

/** The value of --tau. */
std::string tauArgument(const std::vector<double>& taus)
{
    const std::optional<double> step = evenStep(taus);
    if (!step)
        return listed(taus, ",");
    return numberText(taus.front()) + ':' + numberText(taus.back()) + ':' + numberText(*step);
}

/** The command that flies the same missions; the study does not know the names of its files. */
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
    std::string policies;
    for (const PolicyKind policy : spec.policies)
        policies += (policies.empty() ? "" : ",") + nameOf(kPolicyNames, policy);
    command += " --policies " + policies;
    if (spec.runs > 1)
        command += " --runs " + std::to_string(spec.runs);
    return command;
}

} // namespace

std::string titleOf(const StudySpec& spec)
{
    if (!spec.name.empty())
        return spec.name;
    const std::size_t scenarios = spec.scenarios.size() + static_cast<std::size_t>(spec.random);
    if (scenarios == 1 && !spec.scenarios.empty() && !spec.scenarios.front().name.empty())
        return spec.scenarios.front().name;
    if (spec.scenarios.empty())
        return counted(spec.random, "random field", "random fields") + " of " +
               counted(spec.field.icebergs, "iceberg", "icebergs");
    return "Study of " + counted(static_cast<double>(scenarios), "scenario", "scenarios");
}

std::string reportFacts(const Study& study, const ReportOrigin& origin)
{
    const StudySpec& spec = study.spec;
    return "<section>\n<h2>What was flown</h2>\n<dl>\n" + scenariosHtml(spec) +
           fact("Trade-off τ", tausFlown(spec)) + policiesHtml(spec) +
           fact("Noise", noiseHtml(spec)) +
           fact("Missions", printedNumber(static_cast<double>(flownCount(study)), 0) + " of " +
                                printedNumber(static_cast<double>(missionCount(spec)), 0)) +
           fact("Program", htmlText(origin.program)) + fact("Machine", htmlText(origin.machine)) +
           fact("Made", htmlText(origin.madeUtc)) +
           fact("Last run took",
                origin.elapsed_s ? durationText(*origin.elapsed_s) : std::string()) +
           "</dl>\n</section>\n";
}

std::string reportRecipe(const StudySpec& spec)
{
    std::string html =
        "<section>\n<h2>How to make it again</h2>\n"
        "<p>This page holds the whole study, with every scenario, seed and result, "
        "and can be given to Bergwatch as a study file. From the results in it:</p>\n"
        "<pre><code>bergwatch-cli study REPORT.html --report AGAIN.html"
        "</code></pre>\n";
    // The command line has no other fields.
    if (spec.random == 0 || spec.field == FieldSpec{.regime = spec.field.regime})
        html += "<p>Flown anew" +
                std::string(spec.scenarios.empty() ? "" : ", with the scenario files by name") +
                "; the numbers depend neither on the machine nor on how many threads fly "
                "them:</p>\n<pre><code>" +
                htmlText(sweepCommand(spec)) + " --report AGAIN.html</code></pre>\n";
    return html + "</section>\n";
}

} // namespace berg
