#include "widgets/panels/study/study_tables.h"

#include "widgets/charts/study_content.h"
#include "widgets/panels/fields/panel_labels.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/policy_words.h"

#include <QCoreApplication>

#include <limits>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kMark_px = 12;

struct StudyTables
{
    Q_DECLARE_TR_FUNCTIONS(StudyTables)
};

/** Results of a study by rows of its table of settings. */
struct SettingRows
{
    StudyPointer result;
    QLocale locale;

    [[nodiscard]] const StudySummary& summary() const { return result->summary; }
    [[nodiscard]] bool isSetting(int row) const
    {
        return static_cast<std::size_t>(row) < summary().settings.size();
    }
    [[nodiscard]] const SettingSummary& setting(int row) const
    {
        return summary().settings[static_cast<std::size_t>(row)];
    }
    [[nodiscard]] const Summary& zeta(int row) const
    {
        return isSetting(row) ? setting(row).zeta_m2s : summary().bestTau->zeta_m2s;
    }
    [[nodiscard]] const MeanInterval& difference(int row) const
    {
        return isSetting(row) ? summary().differences[static_cast<std::size_t>(row)].relative
                              : summary().bestTau->relative;
    }
    [[nodiscard]] bool isReference(int row) const
    {
        return static_cast<std::size_t>(row) == summary().reference;
    }
    [[nodiscard]] double bestIn(int row) const
    {
        return static_cast<double>(result->bestIn[static_cast<std::size_t>(row)]);
    }
    [[nodiscard]] double cases() const { return static_cast<double>(summary().cases.size()); }
    [[nodiscard]] QString number(double value) const { return significantText(value, 4, locale); }

    [[nodiscard]] QString text(int row, int column) const
    {
        const bool hasSpread = summary().cases.size() > 1;
        switch (column) {
        case SettingName:
            return isSetting(row) ? settingText(setting(row).setting, locale)
                                  : StudyTables::tr("Best τ of each case");
        case SettingMean:
            return number(zeta(row).mean);
        case SettingMedian:
            return number(zeta(row).median);
        case SettingQuartiles:
            return hasSpread ? StudyTables::tr("%1 – %2", "from, to")
                                   .arg(number(zeta(row).quartile1), number(zeta(row).quartile3))
                             : missingValueText();
        case SettingDifference:
            return isReference(row) ? StudyTables::tr("reference")
                                    : changeText(difference(row).mean, locale);
        case SettingInterval:
            return hasSpread && !isReference(row)
                       ? StudyTables::tr("%1 to %2")
                             .arg(changeText(difference(row).low, locale),
                                  changeText(difference(row).high, locale))
                       : missingValueText();
        case SettingBestIn:
            return isSetting(row) ? fixedText(bestIn(row), 0, locale) : QString();
        default:
            return isSetting(row) ? fixedText(setting(row).stuckShare * cases(), 0, locale)
                                  : QString();
        }
    }
    [[nodiscard]] CellKey key(int row, int column) const
    {
        // Sorted by tau, then by name.
        constexpr double kLast = std::numeric_limits<double>::infinity();
        switch (column) {
        case SettingName:
            return {.number = isSetting(row) ? setting(row).setting.tau.value_or(kLast) : kLast,
                    .text = text(row, column)};
        case SettingMean:
            return {.number = zeta(row).mean};
        case SettingMedian:
            return {.number = zeta(row).median};
        case SettingQuartiles:
            return {.number = zeta(row).quartile1};
        case SettingDifference:
            return {.number = difference(row).mean};
        case SettingInterval:
            return {.number = difference(row).low};
        case SettingBestIn:
            return {.number = isSetting(row) ? std::optional<double>(bestIn(row)) : std::nullopt};
        default:
            return {.number =
                        isSetting(row) ? std::optional(setting(row).stuckShare) : std::nullopt};
        }
    }
    [[nodiscard]] QString toolTip(int row) const
    {
        if (!isSetting(row)) {
            const Summary& tau = summary().bestTau->tau;
            return StudyTables::tr("The τ of lowest ζ of each case, chosen in hindsight: median "
                                   "%1, quartiles %2 and %3.")
                .arg(fixedText(tau.median, 2, locale), fixedText(tau.quartile1, 2, locale),
                     fixedText(tau.quartile3, 2, locale));
        }
        const PairedDifference& paired = summary().differences[static_cast<std::size_t>(row)];
        return StudyTables::tr("Less than the reference in %1 of %2 cases, worst %3. On average "
                               "%4 visits.")
            .arg(fixedText(paired.lowerShare * cases(), 0, locale), fixedText(cases(), 0, locale),
                 changeText(paired.worst, locale),
                 significantText(setting(row).meanVisits, 3, locale));
    }
};

/** Cases of one setting, by row. */
struct CaseRows
{
    StudyPointer result;
    std::size_t setting = 0;
    QLocale locale;

    [[nodiscard]] const StudySummary& summary() const { return result->summary; }
    [[nodiscard]] StudyCase of(int row) const
    {
        return studyCase(result->study.spec, summary().cases[static_cast<std::size_t>(row)]);
    }
    [[nodiscard]] const MissionOutcome& outcome(int row, std::size_t of) const
    {
        const std::size_t place =
            summary().cases[static_cast<std::size_t>(row)] * summary().settings.size() + of;
        return *result->study.outcomes[place]; // complete cases have all outcomes
    }
    [[nodiscard]] const MissionOutcome& outcome(int row) const { return outcome(row, setting); }
    [[nodiscard]] double zeta(int row) const { return outcome(row).metrics.zeta_m2s; }
    [[nodiscard]] double difference(int row) const
    {
        const double reference = outcome(row, summary().reference).metrics.zeta_m2s;
        return zeta(row) == reference ? 0 : zeta(row) / reference - 1;
    }
    [[nodiscard]] std::size_t best(int row) const
    {
        return result->bestByCase[static_cast<std::size_t>(row)];
    }
    [[nodiscard]] std::optional<double> bestTau(int row) const
    {
        const auto& best = summary().bestTau;
        return best ? std::optional(best->byCase[static_cast<std::size_t>(row)]) : std::nullopt;
    }

    [[nodiscard]] QString text(int row, int column) const
    {
        switch (column) {
        case CaseName:
            return of(row).scenario;
        case CaseSeed:
            return QString::number(of(row).seed);
        case CaseZeta:
            return significantText(zeta(row), 4, locale);
        case CaseDifference:
            return setting == summary().reference ? StudyTables::tr("reference")
                                                  : changeText(difference(row), locale);
        case CaseBestTau:
            return bestTau(row) ? fixedText(*bestTau(row), 2, locale) : missingValueText();
        case CaseBest:
            return settingText(summary().settings[best(row)].setting, locale);
        default:
            return outcome(row).stuck ? StudyTables::tr("stuck") : QString();
        }
    }
    [[nodiscard]] CellKey key(int row, int column) const
    {
        switch (column) {
        case CaseZeta:
            return {.number = zeta(row)};
        case CaseDifference:
            return {.number = difference(row)};
        case CaseBestTau:
            return {.number = bestTau(row)};
        case CaseBest:
            return {.number = static_cast<double>(best(row))};
        case CaseStuck:
            return {.number = outcome(row).stuck ? 1.0 : 0.0};
        default:
            return {.number = static_cast<double>(row)};
        }
    }
    [[nodiscard]] QString toolTip(int row) const
    {
        const Metrics& metrics = outcome(row).metrics;
        return StudyTables::tr("%1 visits, %2 plans, %3 flown. Return or a double click opens "
                               "this run.")
            .arg(metrics.visits)
            .arg(metrics.replans)
            .arg(distanceText(metrics.flown_m, locale));
    }
};

} // namespace

StudyCase studyCase(const StudySpec& spec, std::size_t caseIndex)
{
    const auto runs = static_cast<std::size_t>(spec.runs);
    const std::size_t scenario = caseIndex / runs;
    StudyCase out{.run = static_cast<int>(caseIndex % runs)};
    if (scenario < spec.scenarios.size()) {
        out.scenario = QString::fromStdString(spec.scenarios[scenario].name);
        out.seed = seedOfRun(spec.scenarios[scenario].seed, out.run);
        return out;
    }
    const std::int64_t seed =
        spec.firstSeed + static_cast<std::int64_t>(scenario - spec.scenarios.size());
    out.scenario = StudyTables::tr("Random %1", "scenario drawn from a seed").arg(seed);
    out.seed = seedOfRun(seed, out.run);
    return out;
}

CellSheet studySettings(const StudyPointer& result, const Theme& theme, const QLocale& locale)
{
    const SettingRows of{.result = result, .locale = locale};
    const std::size_t cases = result ? result->summary.cases.size() : 0;
    const bool hasBest = cases > 1 && result->summary.bestTau;
    const std::size_t rows = cases > 0 ? result->summary.settings.size() + (hasBest ? 1 : 0) : 0;
    return {
        .titles = {StudyTables::tr("Setting"), StudyTables::tr("Mean ζ"),
                   StudyTables::tr("Median ζ"), StudyTables::tr("Quartiles"),
                   StudyTables::tr("vs reference"), StudyTables::tr("95 % interval"),
                   StudyTables::tr("Best in"), StudyTables::tr("Stuck")},
        .rows = static_cast<int>(rows),
        .text = [of](int row, int column) { return of.text(row, column); },
        .key = [of](int row, int column) { return of.key(row, column); },
        .titleTips = {StudyTables::tr("How the next iceberg is chosen."),
                      StudyTables::tr(
                          "Accumulated uncertainty in m² s, mean of all cases: less is better."),
                      StudyTables::tr("Half of the cases have less."),
                      StudyTables::tr(
                          "A quarter of the cases has less than the first, a quarter more than "
                          "the second."),
                      StudyTables::tr("Mean of the differences, case by case, in per cent of the "
                                      "reference."),
                      StudyTables::tr("Confidence interval of the mean difference by Student's t."),
                      StudyTables::tr("Cases in which no other setting has less ζ."),
                      StudyTables::tr("Cases that visit at most two icebergs in the second half.")},
        .toolTip = [of](int row) { return of.toolTip(row); },
        .icon = [of, theme](int row) -> QVariant {
            return of.isSetting(row) ? policyMark(of.setting(row).setting.policy, theme, kMark_px)
                                     : QVariant();
        },
        .hasNumbers = true};
}

CellSheet studyCases(const StudyPointer& result, std::optional<std::size_t> setting,
                     const QLocale& locale)
{
    const bool hasCases = result && setting && *setting < result->summary.settings.size();
    const CaseRows of{.result = result, .setting = setting.value_or(0), .locale = locale};
    return {
        .titles = {StudyTables::tr("Case"), StudyTables::tr("Noise seed"),
                   StudyTables::tr("ζ, m² s"), StudyTables::tr("vs reference"),
                   StudyTables::tr("Best τ"), StudyTables::tr("Best of all"),
                   StudyTables::tr("Stuck")},
        .rows = hasCases ? static_cast<int>(result->summary.cases.size()) : 0,
        .text = [of](int row, int column) { return of.text(row, column); },
        .key = [of](int row, int column) { return of.key(row, column); },
        .titleTips = {StudyTables::tr("Name of the scenario, or the seed it was drawn from."),
                      StudyTables::tr("Seed of the true drift, the same for every setting."),
                      StudyTables::tr("Accumulated uncertainty of this flight: less is better."),
                      StudyTables::tr("Compared with the flight of this case with the reference."),
                      StudyTables::tr("The τ with the lowest ζ in this case, in hindsight."),
                      StudyTables::tr("The setting with the lowest ζ in this case."),
                      StudyTables::tr("Visits at most two icebergs in the second half.")},
        .toolTip = [of](int row) { return of.toolTip(row); },
        .hasNumbers = true};
}

} // namespace berg
