#pragma once

#include "widgets/model/study_runner.h"
#include "widgets/theme/theme.h"

#include <QTimer>
#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace berg {

/**
 * Start, Cancel and Carry on of a study, how much it is and how long it takes, and how far it has
 * come. Shows and steers a runner that it borrows.
 */
class StudyRunBar : public QWidget
{
    Q_OBJECT

public:
    explicit StudyRunBar(StudyRunner& runner, QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    /** What Start would fly, and why it cannot; empty: it can. */
    void setSpec(const StudySpec& spec, const QString& fault);
    /** What else there is to say, until the next flight. */
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
    QString m_failure; ///< of the last flight
    QString m_note;    ///< since then
    QLabel* m_estimate = nullptr;
    QPushButton* m_start = nullptr;
    QPushButton* m_carryOn = nullptr;
    QProgressBar* m_bar = nullptr;
    QLabel* m_state = nullptr;
    bool m_cancelled = false;
    QTimer m_second; ///< keeps the time left going while single missions take long
};

/** "under a second", "about 12 s", "about 3 min": a time that is not known well. */
[[nodiscard]] QString roughTimeText(double time_s, const QLocale& locale);

} // namespace berg
