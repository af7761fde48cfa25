#include "widgets/charts/study_content.h"
#include "widgets/panels/fields/panel_labels.h"
#include "widgets/panels/study/study_tables.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/policy_words.h"

namespace berg {

StudyCasesModel::StudyCasesModel(const QLocale& locale, QObject* parent)
    : StudyTableModel(
          locale,
          {{tr("Case"), tr("Name of the scenario, or the seed it was drawn from.")},
           {tr("Noise seed"),
            tr("What the true drift was drawn from: the same for every setting.")},
           {tr("ζ, m² s"), tr("Accumulated uncertainty of this flight: less is better.")},
           {tr("vs reference"), tr("Compared with the flight of this case with the reference.")},
           {tr("Best τ"), tr("The τ with the lowest ζ in this case, in hindsight.")},
           {tr("Best of all"), tr("The setting with the lowest ζ in this case.")},
           {tr("Stuck"), tr("Flies to two icebergs at most in the second half.")}},
          parent)
{
}

void StudyCasesModel::setCases(StudyPointer result, std::optional<std::size_t> setting)
{
    m_result = std::move(result);
    m_setting = setting.value_or(0);
    const bool hasCases = m_result && setting && m_setting < m_result->summary.settings.size();
    setRows(hasCases ? m_result->summary.cases.size() : 0);
}

std::size_t StudyCasesModel::caseAt(int row) const
{
    return m_result->summary.cases[unsorted(row)];
}

const MissionOutcome& StudyCasesModel::outcome(std::size_t row, std::size_t setting) const
{
    const std::size_t place =
        m_result->summary.cases[row] * m_result->summary.settings.size() + setting;
    return *m_result->study.outcomes[place]; // complete cases have them all
}

double StudyCasesModel::difference(std::size_t row) const
{
    const double reference = outcome(row, m_result->summary.reference).metrics.zeta_m2s;
    const double zeta_m2s = outcome(row, m_setting).metrics.zeta_m2s;
    return zeta_m2s == reference ? 0 : zeta_m2s / reference - 1;
}

StudyTableModel::SortKey StudyCasesModel::sortKey(std::size_t row, int column) const
{
    switch (column) {
    case Zeta:
        return {.number = outcome(row, m_setting).metrics.zeta_m2s};
    case Difference:
        return {.number = difference(row)};
    case BestTau:
        return {.number = m_result->summary.bestTau ? m_result->summary.bestTau->byCase[row] : 0};
    case Best:
        return {.number = static_cast<double>(m_result->bestByCase[row])};
    case Stuck:
        return {.number = outcome(row, m_setting).stuck ? 1.0 : 0.0};
    default:
        return {.number = static_cast<double>(row)};
    }
}

QString StudyCasesModel::text(std::size_t row, int column) const
{
    const StudySummary& summary = m_result->summary;
    const auto of = [&] { return studyCase(m_result->study.spec, summary.cases[row]); };
    switch (column) {
    case Case:
        return of().scenario;
    case Seed:
        return QString::number(of().seed);
    case Zeta:
        return significantText(outcome(row, m_setting).metrics.zeta_m2s, 4, m_locale);
    case Difference:
        return m_setting == summary.reference ? tr("reference")
                                              : changeText(difference(row), m_locale);
    case BestTau:
        return summary.bestTau ? fixedText(summary.bestTau->byCase[row], 2, m_locale) : noFigure();
    case Best:
        return settingText(summary.settings[m_result->bestByCase[row]].setting, m_locale);
    case Stuck:
        return outcome(row, m_setting).stuck ? tr("stuck") : QString();
    default:
        return {};
    }
}

QString StudyCasesModel::toolTip(std::size_t row) const
{
    const Metrics& metrics = outcome(row, m_setting).metrics;
    return tr("%1 visits, %2 plans, %3 flown. Return or a double click opens this run.")
        .arg(metrics.visits)
        .arg(metrics.replans)
        .arg(distanceText(metrics.flown_m, m_locale));
}

} // namespace berg
