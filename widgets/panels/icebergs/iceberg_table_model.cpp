#include "widgets/panels/icebergs/iceberg_table_model.h"

#include "widgets/document/scenario_edits.h"
#include "widgets/flight/asset_approach.h"
#include "widgets/panels/inspector/inspector_row_makers.h"
#include "widgets/words/iceberg_table_text.h"
#include "widgets/words/object_names.h"

#include <QCollator>

#include <algorithm>
#include <numeric>
#include <utility>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr IcebergColumn columnOf(int column)
{
    return static_cast<IcebergColumn>(column);
}

bool isText(IcebergColumn column)
{
    return column == IcebergColumn::Name || column == IcebergColumn::State ||
           column == IcebergColumn::Uav;
}

} // namespace

IcebergTableModel::IcebergTableModel(ScenarioDocument& document, const QLocale& locale,
                                     QObject* parent)
    : CellModel(parent), m_document(document), m_locale(locale)
{
    showScenario();
}

void IcebergTableModel::showScenario()
{
    const Scenario& scenario = m_document.scenario();
    setRows(editorRows(scenario), {.hasAsset = scenario.asset.has_value()});
}

void IcebergTableModel::showRecord(const FlightRecord& record)
{
    setRows(flightRows(record), {.isInFlight = true,
                                 .hasAsset = record.shown().asset.has_value(),
                                 .hasFleet = areDistinguished(record.scenario.uavs)});
}

void IcebergTableModel::setRows(std::vector<IcebergTableRow> rows, const TableState& state)
{
    const bool hasOtherColumns = std::exchange(m_state, state) != state;
    const std::vector<IcebergTableRow> before = std::exchange(m_rows, std::move(rows));
    const auto isSameIn = [&](auto part) {
        return std::ranges::equal(before, m_rows, {}, part, part);
    };
    const bool hasSameIcebergs = isSameIn(&IcebergTableRow::id);
    if (!hasSameIcebergs || !isSameIn(&IcebergTableRow::name))
        rankNames();
    if (!hasSameIcebergs)
        return resetSheet(sheet());
    updateSheet(sheet(), [&](int row) {
        return before[static_cast<std::size_t>(row)] == m_rows[static_cast<std::size_t>(row)];
    });
    if (hasOtherColumns)
        emit columnsChanged();
}

void IcebergTableModel::rankNames()
{
    // The C locale compares bytes, even within numbers.
    QCollator collator(m_locale == QLocale::c() ? QLocale(QLocale::English) : m_locale);
    collator.setNumericMode(true); // sorts berg-2 before berg-10
    std::vector<int> order(m_rows.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return collator.compare(m_rows[static_cast<std::size_t>(a)].label(),
                                m_rows[static_cast<std::size_t>(b)].label()) < 0;
    });
    m_nameRanks.assign(m_rows.size(), 0);
    for (std::size_t rank = 0; rank < order.size(); ++rank)
        m_nameRanks[static_cast<std::size_t>(order[rank])] = static_cast<int>(rank);
}

CellSheet IcebergTableModel::sheet()
{
    const auto iceberg = [this](int row) -> const IcebergTableRow& {
        return m_rows[static_cast<std::size_t>(row)];
    };
    CellSheet sheet{
        .columns = {},
        .rows = total(),
        .toolTip =
            [=, this](int row, int column) {
                return cellToolTip(iceberg(row), columnOf(column), m_locale);
            },
        .other = [=, this](int row, int column,
                           int role) { return rowData(iceberg(row), columnOf(column), role); },
        .speaksTips = true};
    for (std::size_t column = 0; column < kIcebergColumns; ++column)
        sheet.columns.push_back(cellColumn(static_cast<IcebergColumn>(column)));
    if (!m_filter.isEmpty())
        sheet.isShown = [=, this](int row) {
            return iceberg(row).name.contains(m_filter, Qt::CaseInsensitive) ||
                   QString::fromStdString(iceberg(row).id).contains(m_filter, Qt::CaseInsensitive);
        };
    return sheet;
}

CellColumn IcebergTableModel::cellColumn(IcebergColumn column)
{
    const IcebergColumnSpec& spec = specOf(m_specs, column);
    const auto at = [](int row) { return static_cast<std::size_t>(row); };
    CellColumn shown{.title = spec.title,
                     .tip = spec.toolTip,
                     .text =
                         [=, this](int row) {
                             return cellText(m_rows[at(row)], column, m_state.isInFlight, m_locale);
                         },
                     .key =
                         [=, this](int row) {
                             return column == IcebergColumn::Name
                                        ? CellKey(double(m_nameRanks[at(row)]))
                                        : CellKey(m_rows[at(row)].value(column));
                         },
                     .isNumber = !isText(column)};
    if (!m_state.isInFlight && spec.isEditable())
        shown.edit = [=, this](int row, const QVariant& value) {
            return setAll({shownRow(row).value()}, column, value);
        };
    if (column == IcebergColumn::Name)
        shown.value = [=, this](int row) { return m_rows[at(row)].name; };
    else if (!spec.half)
        shown.value = [=, this, unit = spec.unit](int row) {
            return unit.fromSi(m_rows[at(row)].value(column).value_or(0));
        };
    return shown;
}

void IcebergTableModel::setFilter(const QString& text)
{
    if (text == m_filter)
        return;
    m_filter = text;
    resetSheet(sheet());
}

void IcebergTableModel::setHighlight(const std::string& id)
{
    const std::optional<int> before = rowOf(m_highlight);
    m_highlight = id;
    for (const std::optional<int> row : {before, rowOf(id)})
        if (row)
            reportRows(*row, *row, {HighlightRole});
}

const IcebergTableRow& IcebergTableModel::rowAt(int row) const
{
    return m_rows.at(static_cast<std::size_t>(sourceRow(row)));
}

std::optional<int> IcebergTableModel::rowOf(const std::string& id) const
{
    const auto it = std::ranges::find(m_rows, id, &IcebergTableRow::id);
    if (it == m_rows.end())
        return std::nullopt;
    return shownRow(static_cast<int>(it - m_rows.begin()));
}

const IcebergColumnSpec& IcebergTableModel::spec(int column) const
{
    return m_specs.at(static_cast<std::size_t>(column));
}

bool IcebergTableModel::hasColumn(int column) const
{
    const IcebergColumnSpec& one = spec(column);
    return (m_state.isInFlight ? one.isInFlight : one.isInEditor) &&
           (m_state.hasAsset || !one.isOfAsset) && (m_state.hasFleet || !one.isOfFleet);
}

QVariant IcebergTableModel::rowData(const IcebergTableRow& row, IcebergColumn column,
                                    int role) const
{
    switch (role) {
    case Qt::AccessibleTextRole:
        return column == IcebergColumn::Name && row.ringEntry_s
                   ? QVariant(ringEntryText(row.label(), *row.ringEntry_s, m_locale, row.times))
                   : QVariant();
    case SigmaRole:
        return row.value(IcebergColumn::Sigma).value_or(0);
    case StateRole:
        return static_cast<int>(row.state);
    case AlarmRole:
        return row.ringEntry_s.has_value();
    case HighlightRole:
        return row.id == m_highlight;
    default:
        return {};
    }
}

bool IcebergTableModel::setAll(const std::vector<int>& rows, IcebergColumn column,
                               const QVariant& value)
{
    if (m_state.isInFlight || !specOf(m_specs, column).isEditable())
        return false;
    std::vector<std::string> ids;
    for (const int row : rows)
        ids.push_back(rowAt(row).id);
    const IcebergColumnSpec& kind = specOf(m_specs, column);
    QString fault;
    if (kind.half) {
        fault = setPlaces(rows, column, value.toString());
    } else if (column == IcebergColumn::Name) {
        m_document.edit(InspectorRows::tr("Change name"), [&](Scenario& scenario) {
            for (const std::string& id : ids)
                findById(scenario.icebergs, id)->name = value.toString().toStdString();
        });
    } else {
        setNumbers(ids, column, value.toDouble());
    }
    emit edited(fault);
    return fault.isEmpty();
}

void IcebergTableModel::setNumbers(const std::vector<std::string>& ids, IcebergColumn column,
                                   double value)
{
    const IcebergColumnSpec& kind = specOf(m_specs, column);
    m_document.edit(kind.number->words.undoText, [&](Scenario& scenario) {
        for (const std::string& id : ids) {
            Iceberg& iceberg = *findById(scenario.icebergs, id);
            if (isShownAs(iceberg, column, kind, value))
                continue;
            const Limits limits = kind.number->range(scenario);
            setIcebergNumber(iceberg, column,
                             kind.unit.toSi(std::clamp(value, limits.low, limits.high)));
        }
    });
}

/** Sets the typed position. Returns the reason if nothing was set, or an empty text. */
QString IcebergTableModel::setPlaces(const std::vector<int>& rows, IcebergColumn column,
                                     const QString& text)
{
    const PlaceHalf half = *specOf(m_specs, column).half;
    if (rows.size() > 1)
        if (QString fault = faultForSeveral(text, half); !fault.isEmpty())
            return fault;
    Scenario after = m_document.scenario();
    for (const int row : rows) {
        if (text == cellText(rowAt(row), column, m_state.isInFlight, m_locale))
            continue; // the cell shows fewer digits than the number has
        QString fault = applyTypedPlace(findById(after.icebergs, rowAt(row).id)->position_m, text,
                                        half, after.origin, m_locale);
        if (!fault.isEmpty())
            return fault;
    }
    m_document.edit(InspectorRows::tr("Change position"),
                    [&](Scenario& scenario) { scenario = std::move(after); });
    return {};
}

QString IcebergTableModel::copiedCell(const IcebergTableRow& row, int column) const
{
    if (isText(columnOf(column)))
        return cellText(row, columnOf(column), m_state.isInFlight, m_locale);
    const std::optional<double> value = row.value(columnOf(column));
    if (!value)
        return {};
    return spec(column).half ? copiedAngle(*value, m_locale)
                             : exactText(spec(column).unit.fromSi(*value), m_locale);
}

QString IcebergTableModel::copied(const std::vector<int>& rows,
                                  const std::vector<int>& columns) const
{
    std::vector<std::vector<QString>> cells(1);
    for (const int column : columns)
        cells.front().push_back(spec(column).copied);
    for (const int row : rows) {
        std::vector<QString>& line = cells.emplace_back();
        for (const int column : columns)
            line.push_back(copiedCell(rowAt(row), column));
    }
    return tabSeparated(cells);
}

PasteOutcome IcebergTableModel::paste(const QString& text, int row, int column,
                                      const std::vector<int>& columns)
{
    if (!spec(column).isEditable())
        return {.fault = tr("The column \"%1\" is computed from others. Nothing was pasted.")
                             .arg(spec(column).title)};
    PasteTarget target{.added = m_document.newIceberg()};
    for (int at = row; at < rowCount(); ++at)
        target.ids.push_back(rowAt(at).id);
    for (const int one : columns) {
        target.shown.push_back(columnOf(one));
        if (one >= column && spec(one).isEditable())
            target.columns.push_back(columnOf(one));
    }
    PasteOutcome outcome = pasteCells(m_document.scenario(), text, target, m_specs, m_locale);
    if (outcome.fault.isEmpty())
        m_document.edit(tr("Paste icebergs"),
                        [&](Scenario& scenario) { scenario = outcome.scenario; });
    return outcome;
}

} // namespace berg
