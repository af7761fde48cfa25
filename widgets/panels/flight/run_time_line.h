#pragma once

#include "core/sim/recorder.h"
#include "widgets/theme/mission_clock.h"
#include "widgets/theme/theme.h"

#include <QAbstractSlider>

#include <optional>
#include <vector>

namespace berg {

/** An event as the time line marks it. */
struct TimeMark
{
    double time_s = 0;
    EventKind kind = EventKind::Reached;
    QString text; ///< for the tool tip
};

/**
 * The run from its start to its end: what is flown, where one looks, and ticks for the events.
 * Dragged or by keys one goes to any instant that was flown. The value is the time in
 * milliseconds, the maximum what has been flown.
 */
class RunTimeLine : public QAbstractSlider
{
    Q_OBJECT

public:
    explicit RunTimeLine(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    void setClock(const MissionClock& clock) { m_clock = clock; }
    /** Emits nothing. `time_s` is shown, `newest_s` flown, `duration_s` to be flown. */
    void showTime(double time_s, double newest_s, double duration_s);
    /** In order of time. */
    void setMarks(std::vector<TimeMark> marks);
    /** From when on the plan cannot be left for home with the reserve whole; none: always. */
    void setNoReturn(std::optional<double> time_s);
    [[nodiscard]] const std::vector<TimeMark>& marks() const { return m_marks; }

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    /** The user went to this instant. */
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
