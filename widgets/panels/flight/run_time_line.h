#pragma once

#include "core/mission/recorder.h"
#include "widgets/theme/mission_clock.h"
#include "widgets/theme/theme.h"

#include <QAbstractSlider>

#include <optional>
#include <vector>

namespace berg {

/** A mark of an event on the time line. */
struct TimeMark
{
    double time_s = 0;
    EventKind kind = EventKind::Reached;
    QString text; ///< tool tip
};

/**
 * Time line of the run: the flown part, the instant shown, and marks for events. The user moves to
 * any flown instant by dragging or by keys. The value is the time in milliseconds, the maximum the
 * flown time.
 */
class RunTimeLine : public QAbstractSlider
{
    Q_OBJECT

public:
    explicit RunTimeLine(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    void setClock(const MissionClock& clock) { m_clock = clock; }
    /** Shows `time_s` of a run flown up to `newest_s` out of `duration_s`. Emits nothing. */
    void showTime(double time_s, double newest_s, double duration_s);
    /** Sets the marks, in order of time. */
    void setMarks(std::vector<TimeMark> marks);
    /**
     * Sets the time after which a return home uses the reserve; nullopt if there is no such time.
     */
    void setNoReturn(std::optional<double> time_s);
    [[nodiscard]] const std::vector<TimeMark>& marks() const { return m_marks; }

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    /** Emitted when the user moved to this instant. */
    void scrubbed(double time_s);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

private:
    [[nodiscard]] double toPixel(double time_s) const;
    [[nodiscard]] double toTime(double x_px) const;
    [[nodiscard]] const TimeMark* markAt(double x_px) const;
    void goTo(double x_px);
    void paintMarks(QPainter& painter) const;
    void paintNoReturn(QPainter& painter) const;

    Theme m_theme = Theme::light();
    MissionClock m_clock;
    double m_duration_s = 1;
    std::vector<TimeMark> m_marks;
    std::optional<double> m_noReturn_s;
};

} // namespace berg
