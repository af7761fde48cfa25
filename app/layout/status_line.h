#pragma once

#include "app/layout/window_part.h"
#include "core/geometry/geometry.h"
#include "widgets/words/issue_text.h"

class QLabel;
class QToolButton;

namespace berg {

class CaptionLabel;

/** The status bar: what the tool expects, findings, state of the mission, cursor, autosaving. */
class StatusLine : public WindowPart
{
    Q_OBJECT

public:
    explicit StatusLine(WindowContext& context);

    void showState(const QString& text);
    void showAutosaved(const QString& text);
    /** Counts errors and warnings, where there are any. */
    void showFindings(const IssueCounts& counts);
    void setTheme(const Theme& theme);

signals:
    void findingsRequested();

private:
    void showCursor(const Point& position_m);

    QLabel* m_hint; ///< what the tool expects
    QLabel* m_cursor;
    QLabel* m_state;
    QToolButton* m_findings;
    CaptionLabel* m_autosaved;
    IssueCounts m_counts;
};

} // namespace berg
