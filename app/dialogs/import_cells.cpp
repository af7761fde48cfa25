#include "app/dialogs/import_cells.h"

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

/** Returns the direction of the drift, degrees clockwise from north; nullopt without a drift. */
std::optional<double> directionOfDrift(const ImportRow& row)
{
    if (!row.taken || row.velocity_mps.norm() == 0)
        return std::nullopt;
    return headingFromPsi(std::atan2(row.velocity_mps.y(), row.velocity_mps.x()));
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
    const auto rowOf = [preview](int row) -> const ImportRow& {
        return preview->rows[static_cast<std::size_t>(row)];
    };
    const auto words = [&](const QString& title, auto text) -> CellColumn {
        return {.title = title, .text = [rowOf, text](int row) { return text(rowOf(row)); }};
    };
    const auto numbers = [&](const QString& title, auto number, auto text) -> CellColumn {
        static constexpr double kLast = std::numeric_limits<double>::infinity();
        return {.title = title,
                .text =
                    [rowOf, number, text](int row) {
                        const std::optional<double> value = number(rowOf(row));
                        return value ? text(*value) : QString();
                    },
                .key = [rowOf, number](int row) { return number(rowOf(row)).value_or(kLast); }};
    };
    const auto taken = [](auto number) {
        return [number](const ImportRow& row) {
            return row.taken ? std::optional<double>(number(row)) : std::nullopt;
        };
    };
    const auto fixed = [locale](int decimals) {
        return [=](double value) { return fixedText(value, decimals, locale); };
    };
    const auto significant = [locale](double value) { return significantText(value, 3, locale); };
    CellColumn seen =
        numbers(ImportCells::tr("Last seen, UTC"),
                taken([](const ImportRow& row) { return -row.report.age_s; }), fixed(0));
    seen.text = [preview, rowOf](int row) {
        const std::optional<UtcTime> time = lastSeen(*preview, rowOf(row));
        return time ? utcTimeText(*time) : QString();
    };
    return {
        .columns =
            {words(ImportCells::tr("Id"),
                   [](const ImportRow& row) { return QString::fromStdString(row.report.id); }),
             words(ImportCells::tr("Result"),
                   [](const ImportRow& row) { return importOutcomeWord(row.report.outcome); }),
             numbers(
                 ImportCells::tr("Sightings"),
                 [](const ImportRow& row) { return std::optional<double>(row.report.sightings); },
                 fixed(0)),
             seen,
             numbers(ImportCells::tr("Age"),
                     taken([](const ImportRow& row) { return row.report.age_s; }),
                     [locale](double age_s) { return ageText(age_s, locale); }),
             numbers(ImportCells::tr("Speed, m/s"),
                     taken([](const ImportRow& row) { return row.velocity_mps.norm(); }), fixed(2)),
             numbers(ImportCells::tr("Direction, °"), directionOfDrift, fixed(0)),
             words(ImportCells::tr("Velocity from"),
                   [locale](const ImportRow& row) {
                       return row.taken ? velocitySourceText(row.report, locale) : QString();
                   }),
             numbers(ImportCells::tr("σ, m²"),
                     taken([](const ImportRow& row) { return row.sigma_m2; }), significant),
             numbers(ImportCells::tr("q, m²/s"),
                     taken([](const ImportRow& row) { return row.q_m2ps; }), significant),
             words(ImportCells::tr("Notes"),
                   [](const ImportRow& row) { return notesText(row.report); })},
        .rows = static_cast<int>(preview->rows.size())};
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
    const auto line = [rowOf](int row) { return static_cast<double>(rowOf(row).line); };
    return {
        .columns = {{.title = place,
                     .text = [=](int row) { return fixedText(line(row), 0, locale); },
                     .key = line},
                    {.title = ImportCells::tr("Reason"),
                     .text = [rowOf](int row) { return issueWords(rowOf(row).fault); }},
                    {.title = ImportCells::tr("Text"),
                     .text =
                         [rowOf](int row) { return QString::fromStdString(rowOf(row).detail); }}},
        .rows = static_cast<int>(rows.first.size())};
}

CellSheet headSheet(const PreviewPointer& preview)
{
    const TableHead& head = preview->head;
    CellSheet sheet{.columns = {}, .rows = static_cast<int>(head.rows.size())};
    for (qsizetype i = 0; i < head.columns.size(); ++i) {
        const QString field = fieldOf(*preview, head.columns[i]);
        sheet.columns.push_back(
            {.title = head.columns[i] + u'\n' + (field.isEmpty() ? u"\u2013"_s : field),
             .text =
                 [preview, i](int row) {
                     return preview->head.rows[static_cast<std::size_t>(row)].value(i);
                 },
             .key = [](int row) { return double(row); }});
    }
    return sheet;
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
