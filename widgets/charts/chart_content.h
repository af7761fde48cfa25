#pragma once

#include "widgets/theme/mission_clock.h"

#include <QList>
#include <QPointF>
#include <QString>

#include <optional>
#include <vector>

namespace berg {

/** What a line stands for; decides colour and width. */
enum class LineRole
{
    Accumulated, ///< zeta, distance flown, means over the mission
    Momentary,   ///< sum of sigma, with a light area below; >= 0
    Weighted,    ///< the same with weights, dashed
    Signed,      ///< a reading with sign, such as the turn rate
    Sigma,       ///< sigma of one iceberg, coloured by its value
    Bound,       ///< what no other line gets below
    Uav          ///< one of several, in its colour
};

/** Beside the other lines. */
enum class LineEmphasis
{
    None,
    Strong, ///< thick, and named before all others
    Faint
};

struct TimeLine
{
    QString label;         ///< written beside the line
    QList<QPointF> points; ///< x seconds, ascending, y in the unit of its axis
    LineRole role = LineRole::Momentary;
    bool onRightAxis = false;
    QString name{}; ///< in lists and read-outs; empty: `label`
    QString unit{}; ///< of its values, for read-outs
    QString key{};  ///< tells lines apart whatever the language: id of the iceberg, column
    int uav = 0;    ///< place in the scenario, for `LineRole::Uav`
    LineEmphasis emphasis = LineEmphasis::None;
    bool hidden = false;

    [[nodiscard]] const QString& shownName() const { return name.isEmpty() ? label : name; }
    /** Visible, and with points. */
    [[nodiscard]] bool isShown() const { return !hidden && !points.isEmpty(); }
};

/** A dashed line across the chart, on the left axis. */
struct ReferenceLine
{
    double value = 0;
    QString label;
};

/** Everything a chart over time shows, as plain values. */
struct TimeChartContent
{
    QString title;
    QString leftTitle;  ///< quantity and unit
    QString rightTitle; ///< empty: no right axis
    double duration_s = 1000;
    MissionClock clock; ///< writes the instants
    std::vector<TimeLine> lines;
    bool isThinned = false; ///< at most two points for each column of the view already, all finite
    std::vector<ReferenceLine> references;
    std::vector<double> marks_s; ///< small ticks below the plot, e.g. visits
    QString marksTitle;
    double sigmaFull_m2 = 10;       ///< end of the colour scale for `LineRole::Sigma`
    std::optional<double> cursor_s; ///< the instant looked back at
    QString emptyText;              ///< shown when no line has a point
    QString summary;                ///< the newest values in a sentence, for screen readers
};

} // namespace berg
