#include "widgets/charts/study_content.h"
#include "widgets/panels/fields/panel_labels.h"
#include "widgets/panels/study/study_tables.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/policy_words.h"

#include <limits>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kMark_px = 12;

} // namespace

StudySettingsModel::StudySettingsModel(const QLocale& locale, QObject* parent)
    : StudyTableModel(
          locale,
          {{tr("Setting"), tr("How the next iceberg is chosen.")},
           {tr("Mean ζ"),
            tr("Accumulated uncertainty in m² s, mean of all cases: less is better.")},
           {tr("Median ζ"), tr("Half of the cases have less.")},
           {tr("Quartiles"),
            tr("A quarter of the cases has less than the first, a quarter more than "
               "the second.")},
           {tr("vs reference"), tr("Mean of the differences, case by case, in per cent of the "
                                   "reference.")},
           {tr("95 % interval"), tr("Of the mean difference: confidence interval by Student's t.")},
           {tr("Best in"), tr("Cases in which no other setting has less ζ.")},
           {tr("Stuck"), tr("Cases that fly to two icebergs at most in the second half.")}},
          parent)
    , m_theme(Theme::light())
{
}

void StudySettingsModel::setTheme(const Theme& theme)
{
    m_theme = theme;
    if (rowCount() > 0)
        emit dataChanged(index(0, 0), index(rowCount() - 1, 0), {Qt::DecorationRole});
}

void StudySettingsModel::setResult(StudyPointer result)
{
    m_result = std::move(result);
    const bool hasCases = m_result && !m_result->summary.cases.empty();
    const bool hasBest =
        hasCases && m_result->summary.bestTau && m_result->summary.cases.size() > 1;
    setRows(hasCases ? settings() + (hasBest ? 1 : 0) : 0);
}

std::size_t StudySettingsModel::settings() const
{
    return m_result->summary.settings.size();
}

std::optional<std::size_t> StudySettingsModel::settingAt(int row) const
{
    const std::size_t setting = unsorted(row);
    return setting < settings() ? std::optional(setting) : std::nullopt;
}

const Summary& StudySettingsModel::zetaOf(std::size_t row) const
{
    const StudySummary& summary = m_result->summary;
    return row < settings() ? summary.settings[row].zeta_m2s : summary.bestTau->zeta_m2s;
}

const MeanInterval& StudySettingsModel::differenceOf(std::size_t row) const
{
    const StudySummary& summary = m_result->summary;
    return row < settings() ? summary.differences[row].relative : summary.bestTau->relative;
}

StudyTableModel::SortKey StudySettingsModel::sortKey(std::size_t row, int column) const
{
    const bool isSetting = row < settings();
    switch (column) {
    case Mean:
        return {.number = zetaOf(row).mean};
    case Median:
        return {.number = zetaOf(row).median};
    case Quartiles:
        return {.number = zetaOf(row).quartile1};
    case Difference:
        return {.number = differenceOf(row).mean};
    case Interval:
        return {.number = differenceOf(row).low};
    case BestIn:
        return {.number = isSetting ? static_cast<double>(m_result->bestIn[row]) : -1};
    case Stuck:
        return {.number = isSetting ? m_result->summary.settings[row].stuckShare : -1};
    default:
        break;
    }
    // By tau, then by name.
    constexpr double kLast = std::numeric_limits<double>::infinity();
    if (!isSetting)
        return {.number = kLast, .text = text(row, Setting)};
    const StudySetting& setting = m_result->summary.settings[row].setting;
    return {.number = setting.tau.value_or(kLast), .text = text(row, Setting)};
}

QString StudySettingsModel::text(std::size_t row, int column) const
{
    const StudySummary& summary = m_result->summary;
    const auto number = [this](double value) { return significantText(value, 4, m_locale); };
    const bool isSetting = row < settings();
    const bool hasSpread = summary.cases.size() > 1;
    switch (column) {
    case Setting:
        return isSetting ? settingText(summary.settings[row].setting, m_locale)
                         : tr("Best τ of each case");
    case Mean:
        return number(zetaOf(row).mean);
    case Median:
        return number(zetaOf(row).median);
    case Quartiles:
        return hasSpread ? tr("%1 – %2", "from, to")
                               .arg(number(zetaOf(row).quartile1), number(zetaOf(row).quartile3))
                         : noFigure();
    case Difference:
        return row == summary.reference ? tr("reference")
                                        : changeText(differenceOf(row).mean, m_locale);
    case Interval:
        return hasSpread && row != summary.reference
                   ? tr("%1 to %2")
                         .arg(changeText(differenceOf(row).low, m_locale),
                              changeText(differenceOf(row).high, m_locale))
                   : noFigure();
    case BestIn:
        return isSetting ? fixedText(static_cast<double>(m_result->bestIn[row]), 0, m_locale)
                         : QString();
    case Stuck:
        return isSetting ? fixedText(summary.settings[row].stuckShare *
                                         static_cast<double>(summary.cases.size()),
                                     0, m_locale)
                         : QString();
    default:
        return {};
    }
}

QString StudySettingsModel::toolTip(std::size_t row) const
{
    const StudySummary& summary = m_result->summary;
    const auto figure = [this](double tau) { return fixedText(tau, 2, m_locale); };
    if (row >= settings()) {
        const Summary& tau = summary.bestTau->tau;
        return tr("The τ of lowest ζ of each case, chosen in hindsight: median %1, quartiles %2 "
                  "and %3.")
            .arg(figure(tau.median), figure(tau.quartile1), figure(tau.quartile3));
    }
    const PairedDifference& difference = summary.differences[row];
    return tr("Less than the reference in %1 of %2 cases, worst %3. On average %4 visits.")
        .arg(fixedText(difference.lowerShare * static_cast<double>(summary.cases.size()), 0,
                       m_locale),
             fixedText(static_cast<double>(summary.cases.size()), 0, m_locale),
             changeText(difference.worst, m_locale),
             significantText(summary.settings[row].meanVisits, 3, m_locale));
}

QVariant StudySettingsModel::data(const QModelIndex& index, int role) const
{
    if (role != Qt::DecorationRole || index.column() != Setting || index.row() >= rowCount())
        return StudyTableModel::data(index, role);
    const std::optional<std::size_t> setting = settingAt(index.row());
    return setting
               ? policyMark(m_result->summary.settings[*setting].setting.policy, m_theme, kMark_px)
               : QVariant();
}

} // namespace berg
