#pragma once

#include <QTimer>
#include <QWidget>

namespace berg {

/**
 * Tells screen readers what happens without their user having gone there: a notification of AT-SPI.
 * Is not seen itself. What comes within a second is told together, and of very much only the last.
 */
class Announcer : public QWidget
{
    Q_OBJECT

public:
    explicit Announcer(QWidget* parent = nullptr);

    void say(const QString& text);

signals:
    void told(const QString& text);

private:
    void tell();

    QStringList m_due;
    QTimer m_timer; ///< running: something was told a moment ago
};

} // namespace berg
