#pragma once

#include "core/geometry/geometry.h"
#include "widgets/theme/mission_clock.h"

#include <QList>
#include <QPointF>
#include <QString>

#include <optional>
#include <vector>

namespace berg {

/** Meaning of a line; decides its colour and width. */
enum class LineRole
{
    Accumulated, ///< zeta, distance flown, means over the mission
    Momentary,   ///< sum of sigma, with a light area below it; >= 0
    Weighted,    ///< weighted sum of sigma, dashed
    Signed,      ///< a signed reading such as the turn rate
    Sigma,       ///< sigma of one iceberg, coloured by its value
    Bound,       ///< lower bound; no line falls below it
    Uav,         ///< line of one UAV of a fleet, in its colour
    Wind,
    Gust, ///< dashed, in the colour of the wind
    Current
};

/** Emphasis relative to the other lines. */
enum class LineEmphasis
{
    None,
    Strong, ///< thick, and named before all others
    Faint
};

/** One line of a chart over time. */
struct TimeLine
{
    QString label;         ///< name written beside the line
    QList<QPointF> points; ///< x in seconds, ascending; y in the unit of its axis
    LineRole role = LineRole::Momentary;
    bool onRightAxis = false;
    std::optional<QString> name{}; ///< name in lists and readouts, if it differs from `label`
    QString unit{};                ///< unit of the values in readouts
    QString key{}; ///< identifies the line in every language: id of the iceberg, column
    int uav = 0;   ///< index in the scenario, for `LineRole::Uav`
    LineEmphasis emphasis = LineEmphasis::None;
    bool hidden = false;
    /** Whether it continues the line before it after a gap; it has that line's key and name. */
    bool isContinued = false;

    /** Name in lists and readouts. */
    [[nodiscard]] const QString& shownName() const { return name ? *name : label; }
    /** Returns whether the line is visible and has points. */
    [[nodiscard]] bool isShown() const { return !hidden && !points.isEmpty(); }
};

/** A dashed horizontal line across the chart, with a value of the left axis. */
struct ReferenceLine
{
    double value = 0;
    QString label;
};

/** Velocity at a time, towards east and north. */
struct TimeVelocity
{
    double time_s = 0;
    Point velocity_mps = Point::Zero();
};

/** Velocities of the weather, whose directions a chart shows; times rise. */
struct TimeDirections
{
    std::vector<TimeVelocity> wind;    ///< shown as barbs
    std::vector<TimeVelocity> current; ///< shown as arrows on its line
    bool isSouthern = false;           ///< barbs are those of the southern hemisphere

    /** Direction of a line at a time, such as "from 245°"; empty if it has none. */
    [[nodiscard]] QString textAt(LineRole role, double time_s) const;
};

/** Content of a chart over time, as plain values. */
struct TimeChartContent
{
    QString title;
    QString leftTitle;  ///< quantity and unit
    QString rightTitle; ///< with %1 for the unit of zeta, if it is; empty without a right axis
    double duration_s = 1000;
    MissionClock clock; ///< formats the times
    std::vector<TimeLine> lines;
    bool isThinned = false; ///< lines have at most two points per pixel column, all finite
    std::vector<ReferenceLine> references;
    std::vector<double> marks_s; ///< times of small ticks below the plot, e.g. visits
    QString marksTitle;
    TimeDirections directions;
    std::optional<double> followed_s; ///< end of the window that follows; nullopt: `duration_s`
    double sigmaFull_m2 = 10;         ///< end of the colour scale for `LineRole::Sigma`
    std::optional<double> cursor_s;   ///< instant being viewed
    QString emptyText;                ///< shown if no line has a point
    QString summary;                  ///< newest values in a sentence, for screen readers
};

} // namespace berg
