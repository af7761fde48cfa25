#include "widgets/panels/dialogs/import_cells.h"

#include "core/base/angles.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/iceberg_table_text.h"
#include "widgets/words/import_text.h"
#include "widgets/words/issue_text.h"

#include <QAction>
#include <QClipboard>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QHeaderView>
#include <QTableView>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct ImportCells
{
    Q_DECLARE_TR_FUNCTIONS(ImportCells)
};

constexpr int kRow_px = 22;
constexpr int kRowsMeasured = 50; ///< rows measured for the width of a column

enum IcebergCell
{
    Id,
    Outcome,
    Sightings,
    LastSeen,
    Age,
    Speed,
    Direction,
    VelocityFrom,
    Sigma,
    Growth,
    Notes
};

QString notesText(const ImportedIceberg& report)
{
    QStringList notes;
    for (const ImportNote note : report.notes)
        if (note != ImportNote::VelocityGiven && note != ImportNote::VelocityUnknown)
            notes << importNoteSentence(note); // a separate column states the source of velocities
    return notes.join(u", "_s);
}

std::optional<UtcTime> lastSeen(const ImportPreview& preview, const ImportRow& row)
{
    if (!preview.result.at || !row.taken)
        return std::nullopt;
    return *preview.result.at -
           std::chrono::milliseconds(static_cast<std::int64_t>(row.report.age_s * 1000));
}

/** Returns the number of a cell, or nullopt if the cell has text or is empty. */
std::optional<double> numberOfCell(const ImportRow& row, int cell)
{
    const bool drifts = row.taken && row.velocity_mps.norm() > 0;
    switch (cell) {
    case Sightings:
        return static_cast<double>(row.report.sightings);
    case LastSeen:
        return row.taken ? std::optional(-row.report.age_s) : std::nullopt;
    case Age:
        return row.taken ? std::optional(row.report.age_s) : std::nullopt;
    case Speed:
        return row.taken ? std::optional(row.velocity_mps.norm()) : std::nullopt;
    case Direction:
        return drifts ? std::optional(
                            headingFromPsi(std::atan2(row.velocity_mps.y(), row.velocity_mps.x())))
                      : std::nullopt;
    case Sigma:
        return row.taken ? std::optional(row.sigma_m2) : std::nullopt;
    case Growth:
        return row.taken ? std::optional(row.q_m2ps) : std::nullopt;
    default:
        return std::nullopt;
    }
}

QString icebergText(const ImportPreview& preview, const ImportRow& row, int cell,
                    const QLocale& locale)
{
    if (cell == Id)
        return QString::fromStdString(row.report.id);
    if (cell == Outcome)
        return importOutcomeWord(row.report.outcome);
    if (cell == Notes)
        return notesText(row.report);
    if (cell == VelocityFrom)
        return row.taken ? velocitySourceText(row.report, locale) : QString();
    if (cell == LastSeen) {
        const std::optional<UtcTime> time = lastSeen(preview, row);
        return time ? utcTimeText(*time) : QString();
    }
    const std::optional<double> number = numberOfCell(row, cell);
    if (!number)
        return {};
    switch (cell) {
    case Age:
        return ageText(*number, locale);
    case Speed:
        return fixedText(*number, 2, locale);
    case Direction:
        return fixedText(*number, 0, locale);
    case Sigma:
    case Growth:
        return significantText(*number, 3, locale);
    default:
        return fixedText(*number, 0, locale);
    }
}

/** Returns the name of the field that a column is used for; empty if it is unused. */
QString fieldOf(const ImportPreview& preview, const QString& column)
{
    if (preview.file)
        for (const FieldColumn& mapped : preview.file->mapping)
            if (QString::fromStdString(mapped.column).simplified() == column)
                return sightingFieldName(mapped.field);
    return {};
}

/**
 * Returns the selected rows, or all without a selection, with titles; cells are separated by tabs.
 */
QString copiedRows(const QTableView& table)
{
    const QAbstractItemModel& model = *table.model();
    std::vector<int> rows;
    for (const QModelIndex& index : table.selectionModel()->selectedRows())
        rows.push_back(index.row());
    std::sort(rows.begin(), rows.end());
    if (rows.empty())
        for (int row = 0; row < model.rowCount(); ++row)
            rows.push_back(row);
    std::vector<std::vector<QString>> cells(1);
    for (int column = 0; column < model.columnCount(); ++column)
        cells.front().push_back(
            model.headerData(column, Qt::Horizontal).toString().section(u'\n', 0, 0));
    for (const int row : rows) {
        cells.emplace_back();
        for (int column = 0; column < model.columnCount(); ++column)
            cells.back().push_back(model.index(row, column).data().toString());
    }
    return tabSeparated(cells);
}

} // namespace

CellSheet icebergSheet(const PreviewPointer& preview, const QLocale& locale)
{
    return {.titles = {ImportCells::tr("Id"), ImportCells::tr("Result"),
                       ImportCells::tr("Sightings"), ImportCells::tr("Last seen, UTC"),
                       ImportCells::tr("Age"), ImportCells::tr("Speed, m/s"),
                       ImportCells::tr("Direction, °"), ImportCells::tr("Velocity from"),
                       ImportCells::tr("σ, m²"), ImportCells::tr("q, m²/s"),
                       ImportCells::tr("Notes")},
            .rows = static_cast<int>(preview->rows.size()),
            .text =
                [preview, locale](int row, int column) {
                    return icebergText(*preview, preview->rows[static_cast<std::size_t>(row)],
                                       column, locale);
                },
            .key = [preview, locale](int row, int column) -> CellKey {
                const ImportRow& iceberg = preview->rows[static_cast<std::size_t>(row)];
                if (column == Id || column == Outcome || column == VelocityFrom || column == Notes)
                    return {.text = icebergText(*preview, iceberg, column, locale)};
                constexpr double kLast = std::numeric_limits<double>::infinity();
                return {.number = numberOfCell(iceberg, column).value_or(kLast)};
            }};
}

CellSheet rowSheet(const PreviewPointer& preview, Rejections ImportResult::*list,
                   const QLocale& locale)
{
    const auto rowOf = [preview, list](int row) -> const RejectedRow& {
        return (preview->result.*list).first[static_cast<std::size_t>(row)];
    };
    const Rejections& rows = preview->result.*list;
    const std::string_view counted = rows.place;
    const QString place = counted == "feature"  ? ImportCells::tr("Feature")
                          : counted == "packet" ? ImportCells::tr("Packet")
                                                : ImportCells::tr("Line");
    return {.titles = {place, ImportCells::tr("Reason"), ImportCells::tr("Text")},
            .rows = static_cast<int>(rows.first.size()),
            .text = [rowOf, locale](int row, int column) -> QString {
                const RejectedRow& listed = rowOf(row);
                if (column == 0)
                    return fixedText(static_cast<double>(listed.line), 0, locale);
                return column == 1 ? issueWords(listed.fault)
                                   : QString::fromStdString(listed.detail);
            },
            .key = [rowOf](int row, int column) -> CellKey {
                const RejectedRow& listed = rowOf(row);
                if (column == 0)
                    return {.number = static_cast<double>(listed.line)};
                return {.text = column == 1 ? issueWords(listed.fault)
                                            : QString::fromStdString(listed.detail)};
            }};
}

CellSheet headSheet(const PreviewPointer& preview)
{
    const TableHead& head = preview->head;
    QStringList titles;
    for (const QString& column : head.columns) {
        const QString field = fieldOf(*preview, column);
        titles << column + u'\n' + (field.isEmpty() ? u"\u2013"_s : field);
    }
    return {.titles = titles,
            .rows = static_cast<int>(head.rows.size()),
            .text =
                [preview](int row, int column) {
                    return preview->head.rows[static_cast<std::size_t>(row)].value(column);
                },
            .key = [](int row, int) { return CellKey{.number = static_cast<double>(row)}; }};
}

QTableView* newCellTable(CellModel& model, const QString& name, const QString& accessibleName)
{
    auto* table = new QTableView;
    table->setModel(&model);
    table->setObjectName(name);
    table->setAccessibleName(accessibleName);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setTabKeyNavigation(false);
    table->setShowGrid(false);
    table->setWordWrap(false);
    table->verticalHeader()->hide();
    table->verticalHeader()->setDefaultSectionSize(kRow_px);
    table->verticalHeader()->setMinimumSectionSize(kRow_px);
    table->horizontalHeader()->setHighlightSections(false);
    table->horizontalHeader()->setResizeContentsPrecision(kRowsMeasured);
    table->horizontalHeader()->setSortIndicator(-1, Qt::AscendingOrder);
    table->setSortingEnabled(true);
    auto* copy = new QAction(ImportCells::tr("Copy"), table);
    copy->setShortcut(QKeySequence::Copy);
    copy->setShortcutContext(Qt::WidgetShortcut);
    QObject::connect(copy, &QAction::triggered, table,
                     [table] { QGuiApplication::clipboard()->setText(copiedRows(*table)); });
    table->addAction(copy);
    table->setContextMenuPolicy(Qt::ActionsContextMenu);
    return table;
}

} // namespace berg
