#pragma once

#include "widgets/aircraft/link_status.h"
#include "widgets/theme/theme.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace berg {

/**
 * The telemetry log: the choice to write one, with its place, and the replay of a recorded one with
 * its progress and speed.
 */
class LogRows : public QWidget
{
    Q_OBJECT

public:
    explicit LogRows(QWidget* parent = nullptr);

    void setTheme(const Theme& theme) { m_theme = theme; }
    /** Shows whether a log is to be written, and in which folder. */
    void setChoice(bool isOn, const QString& folder);
    void showStatus(const LinkStatus& status);
    /** Returns the speed chosen for replays, in seconds of the log in each second. */
    [[nodiscard]] double speed() const;

signals:
    void logEdited(bool isOn);
    void openRequested();
    void speedEdited(double speed);

private:
    QCheckBox* m_write;
    QPushButton* m_open;
    QLabel* m_file;
    QProgressBar* m_progress;
    QComboBox* m_speed;
    Theme m_theme;
};

} // namespace berg
