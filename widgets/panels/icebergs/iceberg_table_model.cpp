#include "widgets/panels/icebergs/iceberg_table_model.h"

#include "widgets/model/asset_approach.h"
#include "widgets/model/scenario_edits.h"
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

bool isSameIcebergs(const std::vector<IcebergTableRow>& a, const std::vector<IcebergTableRow>& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const IcebergTableRow& one, const IcebergTableRow& other) {
                          return one.id == other.id;
                      });
}

} // namespace

IcebergTableModel::IcebergTableModel(ScenarioDocument& document, const QLocale& locale,
                                     QObject* parent)
    : QAbstractTableModel(parent), m_document(document), m_locale(locale)
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
    if (isSameIcebergs(rows, m_rows)) {
        updateRows(std::move(rows));
        if (hasOtherColumns)
            emit columnsChanged();
        return;
    }
    beginResetModel();
    m_rows = std::move(rows);
    rankNames();
    m_shown = arranged();
    endResetModel();
}

void IcebergTableModel::updateRows(std::vector<IcebergTableRow> rows)
{
    std::vector<bool> hasChanged(rows.size());
    bool hasOtherName = false;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        hasChanged[i] = rows[i] != m_rows[i];
        hasOtherName = hasOtherName || rows[i].name != m_rows[i].name;
    }
    m_rows = std::move(rows);
    if (hasOtherName)
        rankNames();
    rearrange();
    reportChanges(hasChanged);
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

bool IcebergTableModel::isBefore(int a, int b) const
{
    const auto i = static_cast<std::size_t>(a);
    const auto j = static_cast<std::size_t>(b);
    const bool isAscending = m_sortOrder == Qt::AscendingOrder;
    const IcebergColumn column = columnOf(m_sortColumn);
    if (column == IcebergColumn::Name)
        return isAscending ? m_nameRanks[i] < m_nameRanks[j] : m_nameRanks[i] > m_nameRanks[j];
    const std::optional<double> first = m_rows[i].value(column);
    const std::optional<double> second = m_rows[j].value(column);
    if (!first || !second)
        return first && !second;
    return isAscending ? *first < *second : *first > *second;
}

/** Returns the icebergs to show, filtered and sorted. */
std::vector<int> IcebergTableModel::arranged() const
{
    std::vector<int> shown;
    shown.reserve(m_rows.size());
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const IcebergTableRow& row = m_rows[i];
        if (m_filter.isEmpty() || row.name.contains(m_filter, Qt::CaseInsensitive) ||
            QString::fromStdString(row.id).contains(m_filter, Qt::CaseInsensitive))
            shown.push_back(static_cast<int>(i));
    }
    if (m_sortColumn >= 0)
        std::stable_sort(shown.begin(), shown.end(),
                         [this](int a, int b) { return isBefore(a, b); });
    return shown;
}

void IcebergTableModel::rearrange()
{
    std::vector<int> shown = arranged();
    if (shown == m_shown)
        return;
    if (shown.size() != m_shown.size()) {
        beginResetModel();
        m_shown = std::move(shown);
        endResetModel();
        return;
    }
    // Views take the same number of rows for the same icebergs in another order; a renamed iceberg
    // that the filter now hides loses its row.
    emit layoutAboutToBeChanged({}, VerticalSortHint);
    std::vector<std::optional<int>> rowOfIceberg(m_rows.size());
    for (std::size_t row = 0; row < shown.size(); ++row)
        rowOfIceberg[static_cast<std::size_t>(shown[row])] = static_cast<int>(row);
    const QModelIndexList before = persistentIndexList();
    QModelIndexList after;
    after.reserve(before.size());
    for (const QModelIndex& at : before) {
        const int iceberg = m_shown[static_cast<std::size_t>(at.row())];
        const std::optional<int> row = rowOfIceberg[static_cast<std::size_t>(iceberg)];
        after << (row ? index(*row, at.column()) : QModelIndex());
    }
    m_shown = std::move(shown);
    changePersistentIndexList(before, after);
    emit layoutChanged({}, VerticalSortHint);
}

void IcebergTableModel::reportChanges(const std::vector<bool>& hasChanged)
{
    int first = rowCount();
    int last = -1;
    for (int row = 0; row < rowCount(); ++row)
        if (hasChanged[static_cast<std::size_t>(m_shown[static_cast<std::size_t>(row)])]) {
            first = std::min(first, row);
            last = row;
        }
    if (last >= first)
        emit dataChanged(index(first, 0), index(last, columnCount() - 1));
}

void IcebergTableModel::setFilter(const QString& text)
{
    if (text == m_filter)
        return;
    beginResetModel();
    m_filter = text;
    m_shown = arranged();
    endResetModel();
}

void IcebergTableModel::sort(int column, Qt::SortOrder order)
{
    m_sortColumn = column;
    m_sortOrder = order;
    rearrange();
}

void IcebergTableModel::setHighlight(const std::string& id)
{
    const std::optional<int> before = rowOf(m_highlight);
    m_highlight = id;
    for (const std::optional<int> row : {before, rowOf(id)})
        if (row)
            emit dataChanged(index(*row, 0), index(*row, columnCount() - 1), {HighlightRole});
}

const IcebergTableRow& IcebergTableModel::rowAt(int row) const
{
    return m_rows.at(static_cast<std::size_t>(m_shown.at(static_cast<std::size_t>(row))));
}

std::optional<int> IcebergTableModel::rowOf(const std::string& id) const
{
    const auto it = std::find_if(m_shown.begin(), m_shown.end(), [&](int iceberg) {
        return m_rows[static_cast<std::size_t>(iceberg)].id == id;
    });
    if (it == m_shown.end())
        return std::nullopt;
    return static_cast<int>(it - m_shown.begin());
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

int IcebergTableModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_shown.size());
}

int IcebergTableModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(kIcebergColumns);
}

QVariant IcebergTableModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const IcebergColumn column = columnOf(index.column());
    const IcebergTableRow& row = rowAt(index.row());
    switch (role) {
    case Qt::DisplayRole:
        return cellText(row, column, m_state.isInFlight, m_locale);
    case Qt::EditRole:
        return column == IcebergColumn::Name ? QVariant(row.name)
               : spec(index.column()).half
                   ? QVariant(cellText(row, column, m_state.isInFlight, m_locale))
                   : QVariant(spec(index.column()).unit.fromSi(row.value(column).value_or(0)));
    case Qt::ToolTipRole:
        return cellToolTip(row, column, m_locale);
    case Qt::AccessibleTextRole:
        return column == IcebergColumn::Name && row.ringEntry_s
                   ? QVariant(ringEntryText(row.label(), *row.ringEntry_s, m_locale, row.times))
                   : QVariant();
    case Qt::TextAlignmentRole:
        return QVariant::fromValue((isText(column) ? Qt::AlignLeft : Qt::AlignRight) |
                                   Qt::AlignVCenter);
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

QVariant IcebergTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section >= columnCount())
        return {};
    switch (role) {
    case Qt::DisplayRole:
        return spec(section).title;
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole:
        return spec(section).toolTip;
    case Qt::TextAlignmentRole:
        return QVariant::fromValue((isText(columnOf(section)) ? Qt::AlignLeft : Qt::AlignRight) |
                                   Qt::AlignVCenter);
    default:
        return {};
    }
}

Qt::ItemFlags IcebergTableModel::flags(const QModelIndex& index) const
{
    Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    flags.setFlag(Qt::ItemIsEditable,
                  index.isValid() && !m_state.isInFlight && spec(index.column()).isEditable());
    return flags;
}

bool IcebergTableModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    return role == Qt::EditRole && setAll({index.row()}, columnOf(index.column()), value);
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
