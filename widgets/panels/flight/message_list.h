#pragma once

#include "widgets/theme/theme.h"

#include <QListWidget>

namespace berg {

/** Past messages of the window, newest last, each with its time of day. */
class MessageList : public QListWidget
{
    Q_OBJECT

public:
    explicit MessageList(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    void add(const QString& text);
    /** Inserts the messages of another list before its own. */
    void takeOver(const MessageList& other);

protected:
    void keyPressEvent(QKeyEvent* event) override;
};

} // namespace berg
