#include "widgets/panels/plan/plan_model.h"

#include "widgets/panels/fields/panel_labels.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/plan_text.h"

#include <QMimeData>

#include <algorithm>
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

/** Returns why a UAV is not planned. */
QString modeText(FlightMode mode)
{
    switch (mode) {
    case FlightMode::Home:
        return PlanModel::tr("Returning home");
    case FlightMode::Ground:
        return PlanModel::tr("On the ground");
    case FlightMode::Hold:
        return PlanModel::tr("Holding");
    case FlightMode::Idle:
    case FlightMode::Leg:
    case FlightMode::RunOut:
    case FlightMode::Circle:
    case FlightMode::Search:
        break;
    }
    return missingValueText();
}

} // namespace

struct PlanModel::Lines
{
    QLocale locale;
    TimesAhead times{};
    std::vector<PlanLine> lines{};

    [[nodiscard]] const PlanLine& at(int row) const
    {
        return lines.at(static_cast<std::size_t>(row));
    }
    [[nodiscard]] const PlanLine& uavOf(int row) const;
    [[nodiscard]] QString text(int row, Column column) const;
    [[nodiscard]] QString uavText(const PlanLine& line, Column column) const;
    [[nodiscard]] QString toolTip(int row, Column column) const;
    [[nodiscard]] QString searchesText(const std::vector<PlannedSearch>& searches) const;
    [[nodiscard]] QString uavToolTip(const PlanLine& line) const;
    [[nodiscard]] static std::vector<CellColumn> columns(const std::shared_ptr<const Lines>& lines);
};

PlanModel::PlanModel(const QLocale& locale, QObject* parent)
    : CellModel(parent), m_locale(locale), m_lines(std::make_shared<Lines>(Lines{locale}))
{
    resetSheet({.columns = Lines::columns(m_lines)});
}

void PlanModel::setPlan(const std::vector<PlanSection>& sections, const TimesAhead& times)
{
    const auto lines = std::make_shared<const Lines>(
        Lines{.locale = m_locale, .times = times, .lines = linesOf(sections)});
    const auto before = std::exchange(m_lines, lines);
    if (lines->lines == before->lines && times == before->times)
        return;
    const CellSheet sheet{
        .columns = Lines::columns(lines),
        .rows = static_cast<int>(lines->lines.size()),
        .toolTip = [lines](int row,
                           int column) { return lines->toolTip(row, static_cast<Column>(column)); },
        .other = [this, lines](int row, int column,
                               int role) { return lineData(*lines, row, column, role); },
        .speaksTips = true};
    updateSheet(sheet, [&](int row) {
        const PlanLine& one = before->at(row);
        const PlanLine& other = lines->at(row);
        return one.uav == other.uav && one.row.isAssigned == other.row.isAssigned &&
               hasTextsOf(sheet, row);
    });
}

void PlanModel::setHighlight(const std::string& id)
{
    if (id == m_highlight)
        return;
    const std::optional<int> before = rowOf(m_highlight);
    m_highlight = id;
    for (const std::optional<int> row : {before, rowOf(id)})
        if (row)
            reportRows(*row, *row, {HighlightRole});
}

void PlanModel::setDropUav(std::optional<int> uav)
{
    if (uav == m_dropUav)
        return;
    m_dropUav = uav;
    reportRows(0, rowCount() - 1, {DropRole});
}

bool PlanModel::mayMiss() const
{
    return std::ranges::any_of(m_lines->lines, [](const PlanLine& line) {
        return line.row.chance && *line.row.chance < kSurelySeen;
    });
}

bool PlanModel::isPatrol() const
{
    return std::ranges::any_of(m_lines->lines,
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
    return m_lines->at(row);
}

const std::string& PlanModel::idOf(int row) const
{
    return line(row).row.id;
}

std::optional<int> PlanModel::rowOf(const std::string& id) const
{
    const auto it =
        std::ranges::find(m_lines->lines, id, [](const PlanLine& line) { return line.row.id; });
    if (it == m_lines->lines.end())
        return std::nullopt;
    return static_cast<int>(it - m_lines->lines.begin());
}

/**
 * Returns the line of the UAV that visits the iceberg, or the line itself for a UAV; fleets only.
 */
const PlanLine& PlanModel::Lines::uavOf(int row) const
{
    while (!at(row).isUav)
        --row;
    return at(row);
}

QString PlanModel::Lines::text(int row, Column column) const
{
    if (at(row).isUav)
        return uavText(at(row), column);
    const PlanRow& planned = at(row).row;
    if (!planned.isSeen && column == Arrival)
        return planned.again_s ? times.text(*planned.again_s) : PlanModel::tr("later");
    if (!planned.isSeen && (column == Leg || column == ArrivalSigma || column == Chance))
        return missingValueText();
    if ((column == Course || column == GroundSpeed) && !planned.course)
        return missingValueText();
    switch (column) {
    case Number:
        return planned.number ? fixedText(*planned.number, 0, locale) : QString();
    case Name:
        return planned.searches.empty() ? planned.name
                                        : PlanModel::tr("%1 (search)").arg(planned.name);
    case Leg:
        // It is planned as one point with the iceberg above, so there is no leg between the two.
        return planned.leg_m > 0 ? distanceText(planned.leg_m, locale) : missingValueText();
    case Course:
        return courseText(planned.course->true_deg, planned.course->declination_deg);
    case GroundSpeed:
        return speedText(planned.course->groundSpeed_mps, locale, 3);
    case Arrival:
        return times.text(planned.arrival_s);
    case Again:
        return planned.again_s && planned.isSeen ? times.text(*planned.again_s)
                                                 : missingValueText();
    case Sigma:
        return firstUncertainty(planned.sigma_m2, locale);
    case ArrivalSigma:
        return firstUncertainty(planned.arrivalSigma_m2, locale);
    case Chance:
        return planned.chance ? chanceText(*planned.chance, locale) : missingValueText();
    case ColumnCount:
        break;
    }
    return {};
}

QString PlanModel::Lines::uavText(const PlanLine& line, Column column) const
{
    switch (column) {
    case Name:
        return line.row.name;
    case Leg:
        return !line.isIdle ? distanceText(line.row.leg_m, locale) : missingValueText();
    case Arrival:
        if (!line.row.isSeen)
            return modeText(line.mode);
        return !line.isIdle ? times.text(line.row.arrival_s) : missingValueText();
    case Sigma:
        return line.row.isSeen ? PlanModel::tr("%n visits", nullptr, line.visits)
                               : missingValueText();
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

QString PlanModel::Lines::uavToolTip(const PlanLine& line) const
{
    const QString name =
        PlanModel::tr("%1 (id %2)").arg(line.row.name, QString::fromStdString(line.row.id));
    if (!line.row.isSeen)
        return name + u'\n' + heldPlanText();
    if (line.isIdle)
        return name + u'\n' + PlanModel::tr("It has no iceberg to visit.");
    return name + u'\n' +
           (times.clock.isUtc() ? PlanModel::tr("%1, flown by %2", "length and end of a path, UTC")
                                : PlanModel::tr("%1, flown %2", "length and end of a way"))
               .arg(distanceText(line.row.leg_m, locale), times.text(line.row.arrival_s));
}

QString PlanModel::Lines::toolTip(int row, Column column) const
{
    if (at(row).isUav)
        return uavToolTip(at(row));
    const PlanRow& planned = at(row).row;
    if (column == Name) {
        const QString name =
            PlanModel::tr("%1 (id %2)").arg(planned.name, QString::fromStdString(planned.id));
        if (!planned.searches.empty())
            return name + u'\n' + searchesText(planned.searches);
        return planned.isAssigned
                   ? name + u'\n' + PlanModel::tr("Assigned to %1").arg(uavOf(row).row.name)
                   : name;
    }
    if (column == Chance && !planned.searches.empty())
        return searchesText(planned.searches);
    const bool isLater = planned.isLater || (!planned.isSeen && planned.again_s);
    if (isLater && column != Sigma && column != ArrivalSigma && column != Again)
        return PlanModel::tr(
                   "A later visit of the patrol, %1. Its path is planned when its turn comes.")
            .arg(times.text(planned.isSeen ? planned.arrival_s : *planned.again_s));
    if (column == Again)
        return planned.again_s ? times.toolTip(*planned.again_s) : QString();
    if (!planned.isSeen && column != Sigma)
        return PlanModel::tr("The plan ends before this iceberg is seen.");
    if (column == Arrival)
        return times.toolTip(planned.arrival_s);
    if (planned.course && column != Sigma && column != ArrivalSigma && column != Chance)
        return PlanModel::tr("Course over ground %1, ground speed %2")
            .arg(courseText(planned.course->true_deg, planned.course->declination_deg),
                 speedText(planned.course->groundSpeed_mps, locale, 3));
    if (column != Sigma && column != ArrivalSigma)
        return {};
    return PlanModel::tr("Now %1; at arrival %2, if the iceberg is not seen before")
        .arg(uncertaintyText(planned.sigma_m2, locale),
             uncertaintyText(planned.arrivalSigma_m2, locale));
}

QString PlanModel::Lines::searchesText(const std::vector<PlannedSearch>& searches) const
{
    QStringList places;
    for (const PlannedSearch& search : searches)
        places << u"%1 (%2)"_s.arg(times.text(search.time_s), chanceText(search.chance, locale));
    return PlanModel::tr("Lost: searched for %1", "times and chances of finding it")
        .arg(places.join(u", "_s));
}

QVariant PlanModel::lineData(const Lines& lines, int row, int column, int role) const
{
    const PlanLine& line = lines.at(row);
    switch (role) {
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

std::vector<CellColumn> PlanModel::Lines::columns(const std::shared_ptr<const Lines>& lines)
{
    std::vector<CellColumn> columns;
    const auto add = [&](const QString& title, const QString& tip) {
        const auto column = static_cast<Column>(columns.size());
        columns.push_back({.title = title,
                           .tip = tip,
                           .text = [lines, column](int row) { return lines->text(row, column); },
                           .isNumber = column != Name});
    };
    add(u"#"_s, PlanModel::tr("Place in the visiting order"));
    add(PlanModel::tr("Iceberg"), PlanModel::tr("Name of the iceberg"));
    add(PlanModel::tr("Leg"), PlanModel::tr("Distance from the previous iceberg, or from the UAV"));
    add(PlanModel::tr("Course"), PlanModel::tr("Course over ground at the start of the leg"));
    add(PlanModel::tr("Speed", "over ground"), PlanModel::tr("Ground speed in the present wind"));
    add(PlanModel::tr("Arrival"), PlanModel::tr("Arrival of the UAV"));
    add(PlanModel::tr("Again"), PlanModel::tr("When the patrol comes back to the iceberg"));
    add(isSigmaFirst() ? PlanModel::tr("σ now") : PlanModel::tr("95 % now"),
        PlanModel::tr("Uncertainty of the position now"));
    add(isSigmaFirst() ? u"σ, m²"_s : u"95 %"_s,
        PlanModel::tr("Uncertainty of the position on arrival"));
    add(PlanModel::tr("In view"),
        PlanModel::tr("Probability that the iceberg is in view when the UAV reaches its estimate"));
    return columns;
}

Qt::ItemFlags PlanModel::flags(const QModelIndex& index) const
{
    Qt::ItemFlags flags = CellModel::flags(index);
    if (m_lines->lines.empty() || !m_lines->lines.front().uav)
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
    emit assignRequested(data->data(kIcebergType).toStdString(),
                         m_lines->uavOf(parent.row()).row.id);
    return true;
}

} // namespace berg
