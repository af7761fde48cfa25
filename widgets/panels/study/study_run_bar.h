#pragma once

#include "widgets/study/study_runner.h"
#include "widgets/theme/theme.h"

#include <QTimer>
#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace berg {

/**
 * Start, Stop and Continue of a study, its size and expected duration, and its progress. Shows and
 * controls a runner that it borrows.
 */
class StudyRunBar : public QWidget
{
    Q_OBJECT

public:
    explicit StudyRunBar(StudyRunner& runner, QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    /** Sets the study that Start would fly; `fault` is why it cannot be flown, or empty. */
    void setSpec(const StudySpec& spec, const QString& fault);
    /** Shows a note until the next flight. */
    void showNote(const QString& text);

signals:
    void startRequested();

private:
    void startOrCancel();
    void showState();
    void showProgress();
    void showEnd(const QString& failure);
    [[nodiscard]] QString flownText() const;

    StudyRunner& m_runner;
    QString m_fault;
    QString m_failure; ///< failure of the last flight
    QString m_note;    ///< note since the last flight
    QLabel* m_estimate = nullptr;
    QPushButton* m_start = nullptr;
    QPushButton* m_carryOn = nullptr;
    QProgressBar* m_bar = nullptr;
    QLabel* m_state = nullptr;
    bool m_cancelled = false;
    QTimer m_second; ///< updates the remaining time while single missions take long
};

/** Returns a rough time: "under a second", "about 12 s", "about 3 min". */
[[nodiscard]] QString roughTimeText(double time_s, const QLocale& locale);

} // namespace berg
