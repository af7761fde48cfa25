#include "widgets/panels/icebergs/iceberg_table_view.h"

#include "widgets/panels/icebergs/iceberg_table_model.h"
#include "widgets/tables/dock_table.h"

#include <QHeaderView>
#include <QKeyEvent>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kRow_px = 24;
constexpr int kSmallestColumn_px = 36;

bool isReturn(const QKeyEvent& key)
{
    return (key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter) &&
           !key.modifiers().testFlag(Qt::ControlModifier);
}

} // namespace

IcebergTableView::IcebergTableView(QWidget* parent) : QTableView(parent)
{
    setUpDockTable(*this, kRow_px);
    keepKeys(*this, [this](const QKeyEvent& key) { return isMine(key); });
    setSelectionMode(ExtendedSelection);
    setEditTriggers(DoubleClicked | EditKeyPressed | AnyKeyPressed);
    setMouseTracking(true);
    setHorizontalScrollMode(ScrollPerPixel);
    QHeaderView* header = horizontalHeader();
    header->setMinimumSectionSize(kSmallestColumn_px);
    header->setSortIndicatorClearable(true); // the third click restores the order of the scenario
    header->setSortIndicator(-1, Qt::AscendingOrder);
    connect(this, &QTableView::entered, this, &IcebergTableView::pointedAt);
    connect(this, &QTableView::viewportEntered, this, [this] { emit pointedAt({}); });
    connect(this, &QTableView::doubleClicked, this, [this](const QModelIndex& index) {
        if (!index.flags().testFlag(Qt::ItemIsEditable))
            emit chosen(index);
    });
}

std::vector<int> IcebergTableView::shownColumns() const
{
    std::vector<int> columns;
    for (int column = 0; column < model()->columnCount(); ++column)
        if (!isColumnHidden(column))
            columns.push_back(column);
    return columns;
}

std::vector<int> IcebergTableView::selectedRows() const
{
    std::vector<int> rows;
    for (const QModelIndex& index : selectionModel()->selectedRows())
        rows.push_back(index.row());
    std::sort(rows.begin(), rows.end());
    return rows;
}

/** Returns whether this key begins a number in the current cell. */
bool IcebergTableView::startsNumber(const QKeyEvent& key) const
{
    const QModelIndex current = currentIndex();
    if (!current.flags().testFlag(Qt::ItemIsEditable) ||
        current.column() == static_cast<int>(IcebergColumn::Name) || key.text().size() != 1 ||
        (key.modifiers() & ~Qt::KeypadModifier) != Qt::NoModifier)
        return false;
    const QChar c = key.text().front();
    return c.isDigit() || u"+-.,"_s.contains(c);
}

/** Returns whether the table handles this key before the window does. */
bool IcebergTableView::isMine(const QKeyEvent& key) const
{
    return key.matches(QKeySequence::SelectStartOfDocument) ||
           key.matches(QKeySequence::SelectEndOfDocument) || key.matches(QKeySequence::Copy) ||
           key.matches(QKeySequence::Paste) || key.matches(QKeySequence::SelectAll) ||
           startsNumber(key);
}

void IcebergTableView::keyPressEvent(QKeyEvent* event)
{
    const QModelIndex current = currentIndex();
    // Otherwise an editor has sent it.
    const bool isChoice = state() != EditingState && isReturn(*event);
    if (event->matches(QKeySequence::Copy))
        emit copyRequested();
    else if (event->matches(QKeySequence::Paste))
        emit pasteRequested();
    else if (isChoice && current.flags().testFlag(Qt::ItemIsEditable))
        edit(current);
    else if (isChoice && current.isValid())
        emit chosen(current);
    else
        QTableView::keyPressEvent(event);
}

void IcebergTableView::leaveEvent(QEvent* event)
{
    emit pointedAt({});
    QTableView::leaveEvent(event);
}

bool IcebergTableView::edit(const QModelIndex& index, EditTrigger trigger, QEvent* event)
{
    if (trigger == AnyKeyPressed &&
        (event->type() != QEvent::KeyPress || !startsNumber(*static_cast<QKeyEvent*>(event))))
        return false;
    return QTableView::edit(index, trigger, event);
}

} // namespace berg
