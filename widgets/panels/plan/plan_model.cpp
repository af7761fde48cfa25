#include "widgets/panels/plan/plan_model.h"

#include "widgets/panels/fields/panel_labels.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/plan_text.h"

#include <QMimeData>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

/** Lower chances are at most "99 %". */
constexpr double kSurelySeen = 0.995;

constexpr auto kIcebergType = "application/x-bergwatch-planned-iceberg"_L1;

bool isSigmaFirst()
{
    return shownUnits().uncertainty == UncertaintyForm::Sigma;
}

/** Returns sigma or its radius without a unit, which is in the title; the tool tip has both. */
QString firstUncertainty(double sigma_m2, const QLocale& locale)
{
    return isSigmaFirst() ? significantText(sigma_m2, 3, locale) : radius95Text(sigma_m2, locale);
}

QVariant optionalData(std::optional<int> value)
{
    return value ? QVariant(*value) : QVariant();
}

std::vector<PlanLine> linesOf(const std::vector<PlanSection>& sections)
{
    std::vector<PlanLine> lines;
    for (const PlanSection& section : sections) {
        const std::optional<int> uav =
            section.name.isEmpty() ? std::nullopt : std::optional(section.place);
        if (uav)
            lines.push_back(
                {.row = {.id = section.uav,
                         .name = section.name,
                         .leg_m = section.length_m(),
                         .arrival_s = section.lastArrival_s(),
                         .isSeen = section.isPlanned},
                 .uav = uav,
                 .isUav = true,
                 .visits = static_cast<int>(std::ranges::count_if(
                     section.rows, [](const PlanRow& row) { return row.number.has_value(); })),
                 .mode = section.isPlanned ? FlightMode::Idle : section.mode,
                 .isIdle = section.rows.empty()});
        for (const PlanRow& row : section.rows)
            lines.push_back({.row = row, .uav = uav});
    }
    return lines;
}

} // namespace

PlanModel::PlanModel(const QLocale& locale, QObject* parent)
    : QAbstractTableModel(parent), m_locale(locale)
{
}

void PlanModel::setPlan(const std::vector<PlanSection>& sections, const TimesAhead& times)
{
    setLines(linesOf(sections), times);
}

void PlanModel::setLines(std::vector<PlanLine> lines, const TimesAhead& times)
{
    if (lines == m_lines && times == m_times)
        return;
    m_times = times;
    const int before = rowCount();
    const int after = static_cast<int>(lines.size());

    // Lines are added and removed at the end, so that the ones above keep their place in the view.
    if (after < before) {
        beginRemoveRows({}, after, before - 1);
        m_lines.resize(static_cast<std::size_t>(after));
        endRemoveRows();
    } else if (after > before) {
        beginInsertRows({}, before, after - 1);
        m_lines.insert(m_lines.end(), lines.begin() + before, lines.end());
        endInsertRows();
    }
    m_lines = std::move(lines);
    updateContents(std::min(before, after));
}

/** Reports the changed ones of the first `remaining` lines as one span. */
void PlanModel::updateContents(int remaining)
{
    const std::vector<LineContent> before = std::exchange(m_contents, {});
    m_contents.reserve(m_lines.size());
    int first = remaining;
    int last = -1;
    for (int row = 0; row < rowCount(); ++row) {
        LineContent& content = m_contents.emplace_back();
        content.uav = line(row).uav;
        content.isAssigned = line(row).row.isAssigned;
        for (int column = 0; column < ColumnCount; ++column)
            content.texts[static_cast<std::size_t>(column)] =
                text(row, static_cast<Column>(column));
        if (row < remaining && content != before[static_cast<std::size_t>(row)]) {
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
    const std::optional<int> before = rowOf(m_highlight);
    m_highlight = id;
    for (const std::optional<int> row : {before, rowOf(id)})
        if (row)
            emit dataChanged(index(*row, 0), index(*row, ColumnCount - 1), {HighlightRole});
}

void PlanModel::setDropUav(std::optional<int> uav)
{
    if (uav == m_dropUav)
        return;
    m_dropUav = uav;
    if (!m_lines.empty())
        emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1), {DropRole});
}

bool PlanModel::mayMiss() const
{
    return std::ranges::any_of(m_lines, [](const PlanLine& line) {
        return line.row.chance && *line.row.chance < kSurelySeen;
    });
}

bool PlanModel::isPatrol() const
{
    return std::ranges::any_of(m_lines,
                               [](const PlanLine& line) { return line.row.again_s.has_value(); });
}

QString PlanModel::widestText(Column column) const
{
    constexpr double kWidest_mps = 88.8;
    if (column == GroundSpeed)
        return speedText(kWidest_mps, m_locale, 3);
    const bool isTrueAlone = shownUnits().north == NorthForm::True;
    return courseText(0, isTrueAlone ? std::nullopt : std::optional<double>(0));
}

const PlanLine& PlanModel::line(int row) const
{
    return m_lines.at(static_cast<std::size_t>(row));
}

const std::string& PlanModel::idOf(int row) const
{
    return line(row).row.id;
}

std::optional<int> PlanModel::rowOf(const std::string& id) const
{
    const auto it = std::find_if(m_lines.begin(), m_lines.end(),
                                 [&](const PlanLine& line) { return line.row.id == id; });
    if (it == m_lines.end())
        return std::nullopt;
    return static_cast<int>(it - m_lines.begin());
}

/**
 * Returns the line of the UAV that visits the iceberg, or the line itself for a UAV; fleets only.
 */
const PlanLine& PlanModel::uavOf(int row) const
{
    while (!line(row).isUav)
        --row;
    return line(row);
}

int PlanModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_lines.size());
}

int PlanModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QString PlanModel::text(int row, Column column) const
{
    if (line(row).isUav)
        return uavText(line(row), column);
    const PlanRow& planned = line(row).row;
    if (!planned.isSeen && column == Arrival)
        return planned.again_s ? m_times.text(*planned.again_s) : tr("later");
    if (!planned.isSeen && (column == Leg || column == ArrivalSigma || column == Chance))
        return missingValueText();
    if ((column == Course || column == GroundSpeed) && !planned.course)
        return missingValueText();
    switch (column) {
    case Number:
        return planned.number ? fixedText(*planned.number, 0, m_locale) : QString();
    case Name:
        return planned.searches.empty() ? planned.name : tr("%1 (search)").arg(planned.name);
    case Leg:
        // It is planned as one point with the iceberg above, so there is no leg between the two.
        return planned.leg_m > 0 ? distanceText(planned.leg_m, m_locale) : missingValueText();
    case Course:
        return courseText(planned.course->true_deg, planned.course->declination_deg);
    case GroundSpeed:
        return speedText(planned.course->groundSpeed_mps, m_locale, 3);
    case Arrival:
        return m_times.text(planned.arrival_s);
    case Again:
        return planned.again_s && planned.isSeen ? m_times.text(*planned.again_s)
                                                 : missingValueText();
    case Sigma:
        return firstUncertainty(planned.sigma_m2, m_locale);
    case ArrivalSigma:
        return firstUncertainty(planned.arrivalSigma_m2, m_locale);
    case Chance:
        return planned.chance ? chanceText(*planned.chance, m_locale) : missingValueText();
    case ColumnCount:
        break;
    }
    return {};
}

QString PlanModel::uavText(const PlanLine& line, Column column) const
{
    switch (column) {
    case Name:
        return line.row.name;
    case Leg:
        return !line.isIdle ? distanceText(line.row.leg_m, m_locale) : missingValueText();
    case Arrival:
        if (!line.row.isSeen)
            return modeText(line.mode);
        return !line.isIdle ? m_times.text(line.row.arrival_s) : missingValueText();
    case Sigma:
        return line.row.isSeen ? tr("%n visits", nullptr, line.visits) : missingValueText();
    case Number:
    case Course:
    case GroundSpeed:
    case Again:
    case ArrivalSigma:
    case Chance:
    case ColumnCount:
        break;
    }
    return {};
}

QString PlanModel::modeText(FlightMode mode)
{
    switch (mode) {
    case FlightMode::Home:
        return tr("Returning home");
    case FlightMode::Ground:
        return tr("On the ground");
    case FlightMode::Hold:
        return tr("Holding");
    case FlightMode::Idle:
    case FlightMode::Leg:
    case FlightMode::RunOut:
    case FlightMode::Circle:
    case FlightMode::Search:
        break;
    }
    return missingValueText();
}

QString PlanModel::uavToolTip(const PlanLine& line) const
{
    const QString name = tr("%1 (id %2)").arg(line.row.name, QString::fromStdString(line.row.id));
    if (!line.row.isSeen)
        return name + u'\n' +
               tr("No plan while the UAV returns, is on the ground or holds. A new one is made "
                  "when it resumes.");
    if (line.isIdle)
        return name + u'\n' + tr("It has no iceberg to visit.");
    return name + u'\n' +
           (m_times.clock.isUtc() ? tr("%1, flown by %2", "length and end of a path, UTC")
                                  : tr("%1, flown %2", "length and end of a way"))
               .arg(distanceText(line.row.leg_m, m_locale), m_times.text(line.row.arrival_s));
}

QString PlanModel::toolTip(int row, Column column) const
{
    if (line(row).isUav)
        return uavToolTip(line(row));
    const PlanRow& planned = line(row).row;
    if (column == Name) {
        const QString name = tr("%1 (id %2)").arg(planned.name, QString::fromStdString(planned.id));
        if (!planned.searches.empty())
            return name + u'\n' + searchesText(planned.searches);
        return planned.isAssigned ? name + u'\n' + tr("Assigned to %1").arg(uavOf(row).row.name)
                                  : name;
    }
    if (column == Chance && !planned.searches.empty())
        return searchesText(planned.searches);
    const bool isLater = planned.isLater || (!planned.isSeen && planned.again_s);
    if (isLater && column != Sigma && column != ArrivalSigma && column != Again)
        return tr("A later visit of the patrol, %1. Its path is planned when its turn comes.")
            .arg(m_times.text(planned.isSeen ? planned.arrival_s : *planned.again_s));
    if (column == Again)
        return planned.again_s ? m_times.toolTip(*planned.again_s) : QString();
    if (!planned.isSeen && column != Sigma)
        return tr("The plan ends before this iceberg is seen.");
    if (column == Arrival)
        return m_times.toolTip(planned.arrival_s);
    if (planned.course && column != Sigma && column != ArrivalSigma && column != Chance)
        return tr("Course over ground %1, ground speed %2")
            .arg(courseText(planned.course->true_deg, planned.course->declination_deg),
                 speedText(planned.course->groundSpeed_mps, m_locale, 3));
    if (column != Sigma && column != ArrivalSigma)
        return {};
    return tr("Now %1; at arrival %2, if the iceberg is not seen before")
        .arg(uncertaintyText(planned.sigma_m2, m_locale),
             uncertaintyText(planned.arrivalSigma_m2, m_locale));
}

QString PlanModel::searchesText(const std::vector<PlannedSearch>& searches) const
{
    QStringList places;
    for (const PlannedSearch& search : searches)
        places << u"%1 (%2)"_s.arg(m_times.text(search.time_s),
                                   chanceText(search.chance, m_locale));
    return tr("Lost: searched for %1", "times and chances of finding it").arg(places.join(u", "_s));
}

QVariant PlanModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const auto column = static_cast<Column>(index.column());
    const PlanLine& line = this->line(index.row());
    switch (role) {
    case Qt::DisplayRole:
        return text(index.row(), column);
    case Qt::ToolTipRole:
        return toolTip(index.row(), column);
    case Qt::TextAlignmentRole:
        return QVariant::fromValue((column == Name ? Qt::AlignLeft : Qt::AlignRight) |
                                   Qt::AlignVCenter);
    case SigmaRole:
        if (column == Sigma)
            return line.row.sigma_m2;
        return column == ArrivalSigma && line.row.isSeen ? QVariant(line.row.arrivalSigma_m2)
                                                         : QVariant();
    case HighlightRole:
        return line.row.id == m_highlight;
    case UavRole:
        return optionalData(line.uav);
    case IsUavRole:
        return line.isUav;
    case NumberRole:
        return optionalData(line.row.number);
    case AssignedRole:
        return line.row.isAssigned;
    case LaterRole:
        return !line.isUav && (!line.row.isSeen || line.row.isLater);
    case DropRole:
        return line.uav && line.uav == m_dropUav;
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
        return isText ? tr("Leg") : tr("Distance from the previous iceberg, or from the UAV");
    case Course:
        return isText ? tr("Course") : tr("Course over ground at the start of the leg");
    case GroundSpeed:
        return isText ? tr("Speed", "over ground") : tr("Ground speed in the present wind");
    case Arrival:
        return isText ? tr("Arrival") : tr("Arrival of the UAV");
    case Again:
        return isText ? tr("Again") : tr("When the patrol comes back to the iceberg");
    case Sigma:
        return isText ? isSigmaFirst() ? tr("σ now") : tr("95 % now")
                      : tr("Uncertainty of the position now");
    case ArrivalSigma:
        return isText ? isSigmaFirst() ? u"σ, m²"_s : u"95 %"_s
                      : tr("Uncertainty of the position on arrival");
    case Chance:
        return isText ? tr("In view")
                      : tr("Probability that the iceberg is in view when the UAV reaches its "
                           "estimate");
    case ColumnCount:
        break;
    }
    return {};
}

Qt::ItemFlags PlanModel::flags(const QModelIndex& index) const
{
    Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    if (m_lines.empty() || !m_lines.front().uav)
        return flags; // there is no other UAV to assign an iceberg to
    // Also on the root, else a view without an indicator refuses drops.
    flags |= Qt::ItemIsDropEnabled;
    flags.setFlag(Qt::ItemIsDragEnabled, index.isValid() && !line(index.row()).isUav);
    return flags;
}

QStringList PlanModel::mimeTypes() const
{
    return {kIcebergType};
}

QMimeData* PlanModel::mimeData(const QModelIndexList& indexes) const
{
    if (indexes.isEmpty())
        return nullptr;
    auto* data = new QMimeData; // owned by the caller
    data->setData(kIcebergType, QByteArray::fromStdString(idOf(indexes.front().row())));
    return data;
}

bool PlanModel::dropMimeData(const QMimeData* data, Qt::DropAction action, int /*row*/,
                             int /*column*/, const QModelIndex& parent)
{
    if (action != Qt::MoveAction || !parent.isValid() || !line(parent.row()).uav ||
        data == nullptr || !data->hasFormat(kIcebergType))
        return false;
    emit assignRequested(data->data(kIcebergType).toStdString(), uavOf(parent.row()).row.id);
    return true;
}

} // namespace berg
