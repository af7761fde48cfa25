#include "widgets/panels/study/study_tables.h"

#include "widgets/charts/study_chart.h"
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
    /** Returns the number of cases in which a setting is best; nullopt for the best of each. */
    [[nodiscard]] std::optional<double> bestIn(int row) const
    {
        if (!isSetting(row))
            return std::nullopt;
        return static_cast<double>(result->bestIn[static_cast<std::size_t>(row)]);
    }
    [[nodiscard]] double cases() const { return static_cast<double>(summary().cases.size()); }
    [[nodiscard]] QString number(double value) const { return significantText(value, 4, locale); }

    [[nodiscard]] QString name(int row) const
    {
        return isSetting(row) ? settingText(setting(row).setting, locale)
                              : StudyTables::tr("Best τ of each case");
    }
    /** Sorts names by tau, then by text. */
    [[nodiscard]] CellKey nameKey(int row) const
    {
        constexpr double kLast = std::numeric_limits<double>::infinity();
        return {isSetting(row) ? setting(row).setting.tau.value_or(kLast) : kLast, name(row)};
    }
    [[nodiscard]] bool hasSpread() const { return summary().cases.size() > 1; }
    [[nodiscard]] QString quartiles(int row) const
    {
        return hasSpread() ? StudyTables::tr("%1 – %2", "from, to")
                                 .arg(number(zeta(row).quartile1), number(zeta(row).quartile3))
                           : missingValueText();
    }
    [[nodiscard]] QString interval(int row) const
    {
        return hasSpread() && !isReference(row) ? StudyTables::tr("%1 to %2")
                                                      .arg(changeText(difference(row).low, locale),
                                                           changeText(difference(row).high, locale))
                                                : missingValueText();
    }
    [[nodiscard]] QString count(const std::optional<double>& number) const
    {
        return number ? fixedText(*number, 0, locale) : QString();
    }
    [[nodiscard]] std::optional<double> stuck(int row) const
    {
        return isSetting(row) ? std::optional(setting(row).stuckShare * cases()) : std::nullopt;
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
        .columns = withNumbers(
            {{.title = StudyTables::tr("Setting"),
              .tip = StudyTables::tr("How the next iceberg is chosen."),
              .text = [of](int row) { return of.name(row); },
              .key = [of](int row) { return of.nameKey(row); }},
             {.title = StudyTables::tr("Mean ζ"),
              .tip = StudyTables::tr(
                  "Accumulated uncertainty in m² s, mean of all cases: less is better."),
              .text = [of](int row) { return of.number(of.zeta(row).mean); },
              .key = [of](int row) { return of.zeta(row).mean; }},
             {.title = StudyTables::tr("Median ζ"),
              .tip = StudyTables::tr("Half of the cases have less."),
              .text = [of](int row) { return of.number(of.zeta(row).median); },
              .key = [of](int row) { return of.zeta(row).median; }},
             {.title = StudyTables::tr("Quartiles"),
              .tip = StudyTables::tr("A quarter of the cases has less than the first, a "
                                     "quarter more than the second."),
              .text = [of](int row) { return of.quartiles(row); },
              .key = [of](int row) { return of.zeta(row).quartile1; }},
             {.title = StudyTables::tr("vs reference"),
              .tip = StudyTables::tr("Mean of the differences, case by case, in per cent of "
                                     "the reference."),
              .text =
                  [of](int row) {
                      return of.isReference(row) ? StudyTables::tr("reference")
                                                 : changeText(of.difference(row).mean, of.locale);
                  },
              .key = [of](int row) { return of.difference(row).mean; }},
             {.title = StudyTables::tr("95 % interval"),
              .tip = StudyTables::tr("Confidence interval of the mean difference by Student's t."),
              .text = [of](int row) { return of.interval(row); },
              .key = [of](int row) { return of.difference(row).low; }},
             {.title = StudyTables::tr("Best in"),
              .tip = StudyTables::tr("Cases in which no other setting has less ζ."),
              .text = [of](int row) { return of.count(of.bestIn(row)); },
              .key = [of](int row) { return of.bestIn(row); }},
             {.title = StudyTables::tr("Stuck"),
              .tip = StudyTables::tr("Cases that visit at most two icebergs in the second half."),
              .text = [of](int row) { return of.count(of.stuck(row)); },
              .key = [of](int row) { return of.stuck(row); }}}),
        .rows = static_cast<int>(rows),
        .toolTip = [of](int row, int) { return of.toolTip(row); },
        .other = [of, theme](int row, int column, int role) -> QVariant {
            return role == Qt::DecorationRole && column == 0 && of.isSetting(row)
                       ? policyPixmap(of.setting(row).setting.policy, theme, kMark_px)
                       : QVariant();
        }};
}

CellSheet studyCases(const StudyPointer& result, std::optional<std::size_t> setting,
                     const QLocale& locale)
{
    const bool hasCases = result && setting && *setting < result->summary.settings.size();
    const CaseRows of{.result = result, .setting = setting.value_or(0), .locale = locale};
    const auto byRow = [](int row) { return double(row); };
    return {
        .columns = withNumbers(
            {{.title = StudyTables::tr("Case"),
              .tip = StudyTables::tr("Name of the scenario, or the seed it was drawn from."),
              .text = [of](int row) { return of.of(row).scenario; },
              .key = byRow},
             {.title = StudyTables::tr("Noise seed"),
              .tip = StudyTables::tr("Seed of the true drift, the same for every setting."),
              .text = [of](int row) { return QString::number(of.of(row).seed); },
              .key = byRow},
             {.title = StudyTables::tr("ζ, m² s"),
              .tip = StudyTables::tr("Accumulated uncertainty of this flight: less is better."),
              .text = [of](int row) { return significantText(of.zeta(row), 4, of.locale); },
              .key = [of](int row) { return of.zeta(row); }},
             {.title = StudyTables::tr("vs reference"),
              .tip = StudyTables::tr("Compared with the flight of this case with the reference."),
              .text =
                  [of](int row) {
                      return of.setting == of.summary().reference
                                 ? StudyTables::tr("reference")
                                 : changeText(of.difference(row), of.locale);
                  },
              .key = [of](int row) { return of.difference(row); }},
             {.title = StudyTables::tr("Best τ"),
              .tip = StudyTables::tr("The τ with the lowest ζ in this case, in hindsight."),
              .text =
                  [of](int row) {
                      return of.bestTau(row) ? fixedText(*of.bestTau(row), 2, of.locale)
                                             : missingValueText();
                  },
              .key = [of](int row) { return of.bestTau(row); }},
             {.title = StudyTables::tr("Best of all"),
              .tip = StudyTables::tr("The setting with the lowest ζ in this case."),
              .text =
                  [of](int row) {
                      return settingText(of.summary().settings[of.best(row)].setting, of.locale);
                  },
              .key = [of](int row) { return double(of.best(row)); }},
             {.title = StudyTables::tr("Stuck"),
              .tip = StudyTables::tr("Visits at most two icebergs in the second half."),
              .text =
                  [of](int row) {
                      return of.outcome(row).stuck ? StudyTables::tr("stuck") : QString();
                  },
              .key = [of](int row) { return double(of.outcome(row).stuck); }}}),
        .rows = hasCases ? static_cast<int>(result->summary.cases.size()) : 0,
        .toolTip = [of](int row, int) { return of.toolTip(row); }};
}

} // namespace berg
