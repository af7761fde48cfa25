#pragma once

#include <QTimer>
#include <QWidget>

namespace berg {

/**
 * Announces events to screen readers as AT-SPI notifications; the widget itself is invisible.
 * Sentences within a second are announced together, and of many only the last.
 */
class Announcer : public QWidget
{
    Q_OBJECT

public:
    explicit Announcer(QWidget* parent = nullptr);

    /** Announces a sentence, at once or with others within a second. */
    void say(const QString& text);

signals:
    /** These sentences were announced. */
    void announced(const QString& text);

private:
    void announce();

    QStringList m_due;
    QTimer m_timer; ///< running for a second after an announcement
};

} // namespace berg
