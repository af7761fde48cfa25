#include "widgets/panels/plan_model.h"

#include "widgets/panels/panel_labels.h"
#include "widgets/theme/quantity_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

using namespace Qt::StringLiterals;

namespace berg {

PlanModel::PlanModel(const QLocale& locale, QObject* parent)
    : QAbstractTableModel(parent), m_locale(locale)
{
}

QString PlanModel::arrivalText(double arrival_s)
{
    return tr("in %1").arg(clockText(arrival_s));
}

void PlanModel::setRows(std::vector<PlanRow> rows)
{
    if (rows == m_rows)
        return;
    const int before = rowCount();
    const int after = static_cast<int>(rows.size());

    // Rows come and go at the end, so that the ones above stay where the view has them.
    if (after < before) {
        beginRemoveRows({}, after, before - 1);
        m_rows.resize(static_cast<std::size_t>(after));
        endRemoveRows();
    } else if (after > before) {
        beginInsertRows({}, before, after - 1);
        m_rows.insert(m_rows.end(), rows.begin() + before, rows.end());
        endInsertRows();
    }
    m_rows = std::move(rows);
    takeTexts(std::min(before, after));
}

/** Tells which of the first `kept` rows read otherwise than before, as one span. */
void PlanModel::takeTexts(int kept)
{
    const std::vector<Texts> before = std::exchange(m_texts, {});
    m_texts.reserve(m_rows.size());
    int first = kept;
    int last = -1;
    for (int row = 0; row < rowCount(); ++row) {
        Texts& texts = m_texts.emplace_back();
        for (int column = 0; column < ColumnCount; ++column)
            texts[static_cast<std::size_t>(column)] = text(row, static_cast<Column>(column));
        if (row < kept && texts != before[static_cast<std::size_t>(row)]) {
            first = std::min(first, row);
            last = row;
        }
    }
    if (last >= first)
        emit dataChanged(index(first, 0), index(last, ColumnCount - 1));
}

void PlanModel::setHighlight(const std::string& id)
{
    if (id == m_highlight)
        return;
    const int before = rowOf(m_highlight);
    m_highlight = id;
    for (const int row : {before, rowOf(id)})
        if (row >= 0)
            emit dataChanged(index(row, 0), index(row, ColumnCount - 1), {HighlightRole});
}

int PlanModel::rowOf(const std::string& id) const
{
    const auto it = std::find_if(m_rows.begin(), m_rows.end(),
                                 [&](const PlanRow& row) { return row.id == id; });
    return it == m_rows.end() ? -1 : static_cast<int>(it - m_rows.begin());
}

int PlanModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int PlanModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QString PlanModel::text(int row, Column column) const
{
    const PlanRow& planned = m_rows[static_cast<std::size_t>(row)];
    if (!planned.isSeen && column == Arrival)
        return tr("later");
    if (!planned.isSeen && (column == Leg || column == ArrivalSigma))
        return noFigure();
    switch (column) {
    case Number:
        return fixedText(row + 1, 0, m_locale);
    case Name:
        return planned.name;
    case Leg:
        // Planned as one point with the one above: there is no way between the two.
        return planned.leg_m > 0 ? distanceText(planned.leg_m, m_locale) : noFigure();
    case Arrival:
        return arrivalText(planned.arrival_s);
    case Sigma:
        return significantText(planned.sigma_m2, 3, m_locale); // its unit is in the header
    case ArrivalSigma:
        return significantText(planned.arrivalSigma_m2, 3, m_locale);
    case ColumnCount:
        break;
    }
    return {};
}

QString PlanModel::toolTip(int row, Column column) const
{
    const PlanRow& planned = m_rows[static_cast<std::size_t>(row)];
    if (column == Name)
        return tr("%1 (id %2)").arg(planned.name, QString::fromStdString(planned.id));
    if (!planned.isSeen && column != Sigma)
        return tr("The plan ends before this iceberg is seen.");
    if (column != Sigma && column != ArrivalSigma)
        return {};
    return tr("σ is %1 m² now, a standard deviation of %2 m; at arrival it is %3 m², if the "
              "iceberg is not seen before")
        .arg(significantText(planned.sigma_m2, 3, m_locale),
             significantText(std::sqrt(planned.sigma_m2), 3, m_locale),
             significantText(planned.arrivalSigma_m2, 3, m_locale));
}

QVariant PlanModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const auto column = static_cast<Column>(index.column());
    const PlanRow& planned = m_rows[static_cast<std::size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole:
        return text(index.row(), column);
    case Qt::ToolTipRole:
        return toolTip(index.row(), column);
    case Qt::TextAlignmentRole:
        return QVariant::fromValue((column == Name ? Qt::AlignLeft : Qt::AlignRight) |
                                   Qt::AlignVCenter);
    case SigmaRole:
        return planned.sigma_m2;
    case HighlightRole:
        return planned.id == m_highlight;
    default:
        return {};
    }
}

QVariant PlanModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    const auto column = static_cast<Column>(section);
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue((column == Name ? Qt::AlignLeft : Qt::AlignRight) |
                                   Qt::AlignVCenter);
    const bool isText = role == Qt::DisplayRole;
    if (!isText && role != Qt::ToolTipRole && role != Qt::AccessibleTextRole)
        return {};
    switch (column) {
    case Number:
        return isText ? u"#"_s : tr("Place in the visiting order");
    case Name:
        return isText ? tr("Iceberg") : tr("Name of the iceberg");
    case Leg:
        return isText ? tr("Leg") : tr("Distance from the one before, the first from the UAV");
    case Arrival:
        return isText ? tr("Arrival") : tr("Time from now until the UAV is there");
    case Sigma:
        return isText ? u"σ, m²"_s : tr("Uncertainty of the position now");
    case ArrivalSigma:
        return isText ? tr("σ at arrival")
                      : tr("Uncertainty of the position when the UAV is there, m²");
    case ColumnCount:
        break;
    }
    return {};
}

} // namespace berg
