#pragma once

#include "widgets/theme/theme.h"

#include <QListWidget>

namespace berg {

/** What the window has said and shows no longer, the newest below, each with its time of day. */
class MessageList : public QListWidget
{
    Q_OBJECT

public:
    explicit MessageList(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    void add(const QString& text);
    /** What another one has comes before. */
    void takeOver(const MessageList& other);

protected:
    void keyPressEvent(QKeyEvent* event) override;
};

} // namespace berg
