#include "widgets/tables/dock_table.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QTableView>
#include <QVBoxLayout>

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
        const bool isHandledHere = event->type() == QEvent::ShortcutOverride &&
                                   m_isMine(static_cast<const QKeyEvent&>(*event));
        if (isHandledHere)
            event->accept();
        return isHandledHere;
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

QLabel* newTableNote(QTableView& table, const QString& name, int margin_px)
{
    auto* note = new QLabel(table.viewport());
    note->setObjectName(name);
    note->setAlignment(Qt::AlignCenter);
    note->setWordWrap(true);
    note->setMargin(margin_px);
    auto* over = new QVBoxLayout(table.viewport());
    over->setContentsMargins(0, 0, 0, 0);
    over->addWidget(note);
    return note;
}

void setDockTableTheme(QTableView& table, const Theme& theme)
{
    table.setFont(theme.body());
    table.horizontalHeader()->setFont(theme.small());
    for (QLabel* note : table.viewport()->findChildren<QLabel*>()) {
        QPalette muted = note->palette();
        muted.setColor(QPalette::WindowText, theme.mutedText);
        note->setPalette(muted);
        note->setFont(theme.body());
    }
}

} // namespace berg
