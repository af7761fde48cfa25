#include "widgets/panels/fields/dock_table.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QTableView>

#include <utility>

namespace berg {
namespace {

class KeyKeeper final : public QObject
{
public:
    KeyKeeper(QWidget& widget, std::function<bool(const QKeyEvent&)> isMine)
        : QObject(&widget), m_isMine(std::move(isMine))
    {
        widget.installEventFilter(this);
    }

    bool eventFilter(QObject* /*watched*/, QEvent* event) override
    {
        const bool isKept = event->type() == QEvent::ShortcutOverride &&
                            m_isMine(static_cast<const QKeyEvent&>(*event));
        if (isKept)
            event->accept();
        return isKept;
    }

private:
    std::function<bool(const QKeyEvent&)> m_isMine;
};

} // namespace

void keepKeys(QWidget& widget, std::function<bool(const QKeyEvent&)> isMine)
{
    new KeyKeeper(widget, std::move(isMine));
}

void setUpDockTable(QTableView& table, int row_px)
{
    table.setSelectionBehavior(QAbstractItemView::SelectRows);
    table.setSelectionMode(QAbstractItemView::SingleSelection);
    table.setEditTriggers(QAbstractItemView::NoEditTriggers);
    table.setShowGrid(false);
    table.setWordWrap(false);
    table.setFrameShape(QFrame::NoFrame);
    table.setTabKeyNavigation(false);
    table.setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    table.verticalHeader()->hide();
    table.verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    table.verticalHeader()->setDefaultSectionSize(row_px);
    table.horizontalHeader()->setHighlightSections(false);
    keepKeys(table, [](const QKeyEvent& key) {
        return (key.key() == Qt::Key_Home || key.key() == Qt::Key_End) &&
               (key.modifiers() & ~Qt::KeypadModifier) == Qt::ControlModifier;
    });
}

} // namespace berg
