#include "widgets/panels/flight/message_list.h"

#include "widgets/tables/dock_table.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QScrollBar>
#include <QTime>

namespace berg {
namespace {

constexpr int kMost = 1000;

} // namespace

MessageList::MessageList(QWidget* parent) : QListWidget(parent)
{
    setObjectName(QStringLiteral("messageList"));
    setAccessibleName(tr("Messages"));
    setFrameShape(QFrame::NoFrame);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setWordWrap(true);
    keepKeys(*this, [](const QKeyEvent& key) {
        return key.matches(QKeySequence::Copy) || key.matches(QKeySequence::SelectAll);
    });
}

void MessageList::setTheme(const Theme& theme)
{
    setFont(theme.body());
}

void MessageList::add(const QString& text)
{
    const QScrollBar& bar = *verticalScrollBar();
    const bool follows = bar.value() >= bar.maximum();
    addItem(QTime::currentTime().toString(QStringLiteral("HH:mm:ss  ")) + text);
    if (count() > kMost)
        delete takeItem(0);
    if (follows)
        scrollToBottom();
}

void MessageList::takeOver(const MessageList& other)
{
    clear(); // the present messages are repeated in another language
    for (int row = 0; row < other.count(); ++row)
        addItem(other.item(row)->text());
}

void MessageList::keyPressEvent(QKeyEvent* event)
{
    if (!event->matches(QKeySequence::Copy))
        return QListWidget::keyPressEvent(event);
    QStringList lines;
    for (int row = 0; row < count(); ++row)
        if (item(row)->isSelected())
            lines << item(row)->text();
    QGuiApplication::clipboard()->setText(lines.join(u'\n'));
}

} // namespace berg
