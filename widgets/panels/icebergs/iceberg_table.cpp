#include "widgets/panels/icebergs/iceberg_table.h"

#include "widgets/document/iceberg_clipboard.h"
#include "widgets/panels/icebergs/iceberg_table_delegate.h"
#include "widgets/panels/icebergs/iceberg_table_model.h"
#include "widgets/panels/icebergs/iceberg_table_view.h"
#include "widgets/tables/dock_table.h"
#include "widgets/theme/quantity_text.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QScopedValueRollback>
#include <QScrollBar>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <set>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kMargin_px = 6;
constexpr int kCellMargins_px = 10;
constexpr int kSortMark_px = 14;
constexpr int kFilterFrom = 15; ///< number of icebergs from which the filter is shown

/** Returns a text as wide as usual contents, so that columns keep their width in flight. */
QString widestText(IcebergColumn column, double sigmaFull_m2, const MissionClock& clock,
                   const QLocale& locale)
{
    switch (column) {
    case IcebergColumn::Name:
    case IcebergColumn::Uav:
        return u"berg-100"_s;
    case IcebergColumn::State:
        return stateText({.id = {}, .state = IcebergStanding::Planned}) + u"0"_s;
    case IcebergColumn::Arrival:
        return TimesAhead{.clock = clock}.text(3599);
    case IcebergColumn::AssetDistance:
        return u"00 000"_s;
    case IcebergColumn::East:
    case IcebergColumn::North:
        return u"−0 000.0"_s;
    case IcebergColumn::Latitude:
        return latitudeText(-88.888, 3, locale);
    case IcebergColumn::Longitude:
        return longitudeText(-188.888, 3, locale);
    case IcebergColumn::AssetTime:
    case IcebergColumn::Unseen:
        return u"00:00"_s;
    case IcebergColumn::Sigma:
        return widestSigmaText(sigmaFull_m2, locale);
    case IcebergColumn::Radius95:
        return u"88.88 km"_s;
    case IcebergColumn::Visits:
    case IcebergColumn::Speed:
    case IcebergColumn::Direction:
    case IcebergColumn::DriftEast:
    case IcebergColumn::DriftNorth:
    case IcebergColumn::Sigma0:
    case IcebergColumn::Growth:
    case IcebergColumn::Observed:
    case IcebergColumn::Appears:
        break;
    }
    return u"0.000"_s;
}

} // namespace

IcebergTable::IcebergTable(ScenarioDocument& document, Selection& selection, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_selection(selection)
    , m_model(new IcebergTableModel(document, locale(), this))
    , m_delegate(new IcebergTableDelegate(this))
    , m_table(new IcebergTableView(this))
    , m_filter(new QLineEdit(this))
    , m_fault(new QLabel(this))
    , m_empty(newTableNote(*m_table, u"icebergsEmpty"_s, kMargin_px))
{
    setUpTable();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_filter);
    column->addWidget(m_fault);
    column->addWidget(m_table, 1);

    m_filter->setObjectName(u"icebergFilter"_s);
    m_filter->setPlaceholderText(tr("Find by name or id"));
    m_filter->setAccessibleName(tr("Find by name or id"));
    m_filter->setClearButtonEnabled(true);
    m_fault->setObjectName(u"icebergFault"_s);
    m_fault->setWordWrap(true);
    m_fault->setMargin(kMargin_px);
    connectTable();
    say({});
    setTheme(Theme::light());
    refresh();
}

/** An open editor commits when it loses the focus; by then only the base class is left. */
IcebergTable::~IcebergTable()
{
    m_model->disconnect(this);
    m_delegate->disconnect(this);
}

void IcebergTable::setUpTable()
{
    m_table->setObjectName(u"icebergTable"_s);
    m_table->setAccessibleName(tr("Icebergs"));
    m_table->setAccessibleDescription(
        tr("A row for each iceberg. Before take-off Return edits a cell, Ctrl+Return sets it in "
           "all rows selected, Ctrl+C and Ctrl+V exchange rows with a spreadsheet. In flight "
           "Return shows the iceberg on the map."));
    m_table->setModel(m_model);
    m_table->setItemDelegate(m_delegate);
    m_table->setSortingEnabled(true);
    m_table->setContextMenuPolicy(Qt::CustomContextMenu);
    m_table->horizontalHeader()->setContextMenuPolicy(Qt::CustomContextMenu);
    if (shownUnits().uncertainty == UncertaintyForm::Radius95)
        m_table->horizontalHeader()->swapSections(static_cast<int>(IcebergColumn::Sigma),
                                                  static_cast<int>(IcebergColumn::Radius95));
}

void IcebergTable::connectTable()
{
    m_table->viewport()->installEventFilter(this);
    connect(&m_document, &ScenarioDocument::scenarioChanged, this, &IcebergTable::showDocument);
    connect(&m_selection, &Selection::changed, this, [this] {
        if (m_isSelecting)
            return; // the change comes from this table
        showSelection();
        scrollToSelection();
    });
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &IcebergTable::acceptSelection);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& current) {
                if (current.isValid())
                    m_current = m_model->rowAt(current.row()).id;
            });
    connect(m_model, &QAbstractItemModel::modelReset, this, &IcebergTable::refresh);
    connect(m_model, &IcebergTableModel::columnsChanged, this, [this] {
        showColumns();
        setColumnWidths();
    });
    connect(m_filter, &QLineEdit::textChanged, m_model, &IcebergTableModel::setFilter);
    connect(m_model, &IcebergTableModel::edited, this, &IcebergTable::say);
    connect(m_delegate, &IcebergTableDelegate::allEdited, this, &IcebergTable::editAll);
    connect(m_table, &IcebergTableView::copyRequested, this, &IcebergTable::copy);
    connect(m_table, &IcebergTableView::pasteRequested, this, &IcebergTable::paste);
    connect(m_table, &IcebergTableView::chosen, this,
            [this](const QModelIndex& index) { emit chosen(m_model->rowAt(index.row()).id); });
    connect(m_table, &IcebergTableView::pointedAt, this, [this](const QModelIndex& index) {
        setHovered(index.isValid() ? m_model->rowAt(index.row()).id : std::string());
    });
    connect(m_table, &QWidget::customContextMenuRequested, this, &IcebergTable::showCellMenu);
    connect(m_table->horizontalHeader(), &QWidget::customContextMenuRequested, this,
            &IcebergTable::showColumnMenu);
}

void IcebergTable::setTheme(const Theme& theme)
{
    m_delegate->setTheme(theme);
    setDockTableTheme(*m_table, theme);
    m_filter->setFont(theme.body());
    m_fault->setFont(theme.body());
    setColumnWidths();
    m_table->viewport()->update();
}

void IcebergTable::setSigmaFull(double full_m2)
{
    const bool isWider =
        widestSigmaText(full_m2, locale()) != widestSigmaText(m_sigmaFull_m2, locale());
    m_sigmaFull_m2 = full_m2;
    m_delegate->setSigmaFull(full_m2);
    if (isWider) // otherwise columns keep the user's widths
        setColumnWidths();
}

void IcebergTable::showRecord(const FlightRecord& record)
{
    const bool wasInFlight = m_model->isInFlight();
    if (record.inFlight())
        m_model->showRecord(record);
    else if (wasInFlight || isVisible())
        m_model->showScenario();
    if (m_model->isInFlight() == wasInFlight)
        return;
    say({});
    refresh();
}

void IcebergTable::showDocument()
{
    if (!m_model->isInFlight() && isVisible())
        m_model->showScenario();
}

void IcebergTable::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    showDocument();
}

/** Keeps the selection in sight; a list without a layout cannot scroll yet. */
bool IcebergTable::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize)
        QTimer::singleShot(0, this, &IcebergTable::scrollToSelection);
    return QWidget::eventFilter(watched, event);
}

/** Updates the view after a reset of the rows or a change between editing and flight. */
void IcebergTable::refresh()
{
    showColumns();
    showFilter();
    showEmpty();
    if (const std::optional<int> row = m_model->rowOf(m_current)) {
        const QScopedValueRollback selecting(m_isSelecting, true);
        const int column = std::max(0, m_table->currentIndex().column());
        m_table->selectionModel()->setCurrentIndex(m_model->index(*row, column),
                                                   QItemSelectionModel::NoUpdate);
    }
    showSelection();
}

void IcebergTable::showColumns()
{
    for (int column = 0; column < m_model->columnCount(); ++column)
        m_table->setColumnHidden(column, !m_model->hasColumn(column) ||
                                             m_hiddenColumns.contains(m_model->spec(column).key));
}

void IcebergTable::setHiddenColumns(const QStringList& keys)
{
    m_hiddenColumns = keys;
    showColumns();
}

/** Returns the width of marks beside the text of a cell. */
int IcebergTable::markWidth(IcebergColumn column) const
{
    if (column == IcebergColumn::Sigma)
        return IcebergTableDelegate::barWidth();
    const bool hasAlarms = m_model->hasColumn(static_cast<int>(IcebergColumn::AssetDistance));
    return column == IcebergColumn::Name && hasAlarms ? IcebergTableDelegate::alarmWidth() : 0;
}

void IcebergTable::setColumnWidths()
{
    const QFontMetrics metrics(m_table->font());
    const QFontMetrics headerMetrics(m_table->horizontalHeader()->font());
    const MissionClock clock = clockOf(m_document.scenario());
    for (int column = 0; column < m_model->columnCount(); ++column) {
        const auto kind = static_cast<IcebergColumn>(column);
        const int extra_px = markWidth(kind);
        const int cell_px =
            metrics.horizontalAdvance(widestText(kind, m_sigmaFull_m2, clock, locale())) + extra_px;
        const int title_px =
            headerMetrics.horizontalAdvance(m_model->spec(column).title) + kSortMark_px;
        const bool isHidden = m_table->isColumnHidden(column);
        m_table->setColumnWidth(column, std::max(cell_px, title_px) + kCellMargins_px);
        m_table->setColumnHidden(column, isHidden);
    }
}

void IcebergTable::showFilter()
{
    m_filter->setVisible(m_model->total() >= kFilterFrom || !m_filter->text().isEmpty());
}

void IcebergTable::showEmpty()
{
    m_empty->setVisible(m_model->rowCount() == 0);
    if (m_model->total() > 0)
        m_empty->setText(tr("No iceberg has this in its name or id."));
    else if (m_model->isInFlight())
        m_empty->setText(tr("There are no icebergs in this flight."));
    else
        m_empty->setText(tr("No icebergs yet: press I and click on the map, or copy rows of a "
                            "spreadsheet (name, east, north, speed, direction, σ₀ ...) and "
                            "paste them here with Ctrl+V."));
}

void IcebergTable::showSelection()
{
    if (m_isSelecting)
        return;
    const QScopedValueRollback selecting(m_isSelecting, true);
    const std::set<std::string> ids(m_selection.ids().begin(), m_selection.ids().end());
    QItemSelection rows;
    std::optional<int> last;
    for (int row = 0; row < m_model->rowCount(); ++row)
        if (ids.contains(m_model->rowAt(row).id)) {
            rows.select(m_model->index(row, 0), m_model->index(row, m_model->columnCount() - 1));
            last = row;
        }
    QItemSelectionModel* chosenRows = m_table->selectionModel();
    chosenRows->select(rows, QItemSelectionModel::ClearAndSelect);
    const QModelIndex current = m_table->currentIndex();
    if (last && !chosenRows->isRowSelected(current.row()))
        chosenRows->setCurrentIndex(m_model->index(*last, std::max(0, current.column())),
                                    QItemSelectionModel::NoUpdate);
}

/** Scrolls to the iceberg selected last. */
void IcebergTable::scrollToSelection()
{
    if (m_selection.isEmpty())
        return;
    for (int row = 0; row < m_model->rowCount(); ++row)
        if (m_model->rowAt(row).id == m_selection.ids().back())
            m_table->scrollTo(m_model->index(row, std::max(0, m_table->currentIndex().column())));
}

/** Passes the selection on; icebergs that stay selected keep their order in front. */
void IcebergTable::acceptSelection()
{
    if (m_isSelecting)
        return;
    const QScopedValueRollback selecting(m_isSelecting, true);
    std::set<std::string> chosenIds;
    std::vector<std::string> ids;
    for (const int row : m_table->selectedRows())
        chosenIds.insert(m_model->rowAt(row).id);
    for (const std::string& id : m_selection.ids())
        if (chosenIds.contains(id))
            ids.push_back(id);
    for (const int row : m_table->selectedRows())
        ids.push_back(m_model->rowAt(row).id);
    m_selection.set(std::move(ids));
}

void IcebergTable::setHighlight(const std::string& id)
{
    m_model->setHighlight(id);
}

void IcebergTable::setHovered(const std::string& id)
{
    if (id == m_hovered)
        return;
    m_hovered = id;
    emit hovered(id);
}

void IcebergTable::finishTyping()
{
    if (auto* editor = m_table->indexWidget(m_table->currentIndex()))
        emit m_delegate->commitData(editor);
}

void IcebergTable::editAll(const QModelIndex& index, const QVariant& value)
{
    m_model->setAll(m_table->selectedRows(), static_cast<IcebergColumn>(index.column()), value);
}

/** Copies the selected rows, or all without a selection. */
void IcebergTable::copy()
{
    std::vector<int> rows = m_table->selectedRows();
    if (rows.empty())
        for (int row = 0; row < m_model->rowCount(); ++row)
            rows.push_back(row);
    QApplication::clipboard()->setText(m_model->copied(rows, m_table->shownColumns()));
}

void IcebergTable::paste()
{
    if (m_model->isInFlight()) {
        say(tr("In flight the icebergs cannot be edited. Stop the flight to paste."));
        return;
    }
    // Null without clipboard contents.
    const QMimeData* clipboard = QApplication::clipboard()->mimeData();
    if (clipboard != nullptr && clipboard->hasFormat(QLatin1String(kIcebergMimeType))) {
        say({});
        emit mapPasteRequested();
        return;
    }
    const QModelIndex current = m_table->currentIndex();
    const PasteOutcome outcome =
        m_model->paste(QApplication::clipboard()->text(), std::max(0, current.row()),
                       std::max(0, current.column()), m_table->shownColumns());
    say(outcome.fault);
    if (outcome.fault.isEmpty())
        m_selection.set(outcome.ids);
}

void IcebergTable::say(const QString& fault)
{
    m_fault->setText(fault);
    m_fault->setAccessibleName(fault);
    m_fault->setVisible(!fault.isEmpty());
}

void IcebergTable::showColumnMenu(const QPoint& at)
{
    auto* menu = new QMenu(this);
    menu->setObjectName(u"icebergColumnMenu"_s);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (int column = 1; column < m_model->columnCount(); ++column) { // the name is always shown
        if (!m_model->hasColumn(column))
            continue;
        const QString key = m_model->spec(column).key;
        QAction* action = menu->addAction(m_model->spec(column).title);
        action->setCheckable(true);
        action->setChecked(!m_hiddenColumns.contains(key));
        connect(action, &QAction::toggled, this, [this, key](bool isShown) {
            m_hiddenColumns.removeAll(key);
            if (!isShown)
                m_hiddenColumns << key;
            showColumns();
            emit hiddenColumnsChanged(m_hiddenColumns);
        });
    }
    menu->popup(m_table->horizontalHeader()->mapToGlobal(at));
}

void IcebergTable::showCellMenu(const QPoint& at)
{
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const QModelIndex cell =
        m_table->indexAt(at).isValid() ? m_table->indexAt(at) : m_table->currentIndex();
    menu->setObjectName(u"icebergCellMenu"_s);
    const auto withKey = [](const QString& text, QKeySequence::StandardKey key) {
        return text + u'\t' + QKeySequence(key).toString(QKeySequence::NativeText);
    };
    menu->addAction(withKey(tr("&Copy"), QKeySequence::Copy), this, &IcebergTable::copy);
    QAction* pasting =
        menu->addAction(withKey(tr("&Paste"), QKeySequence::Paste), this, &IcebergTable::paste);
    pasting->setEnabled(!m_model->isInFlight());
    if (cell.isValid()) {
        const QString text = cell.data().toString();
        menu->addAction(tr("Copy \"%1\"").arg(QString(text).replace(u'&', u"&&"_s)), this,
                        [text] { QApplication::clipboard()->setText(text); });
        menu->addSeparator();
        menu->addAction(tr("Show on the map"), this,
                        [this, id = m_model->rowAt(cell.row()).id] { emit chosen(id); });
    }
    menu->popup(m_table->viewport()->mapToGlobal(at));
}

} // namespace berg
