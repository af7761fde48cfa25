#pragma once

#include "core/io/export/content/export_content.h"

#include <QCoreApplication>
#include <QLocale>
#include <QString>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace berg {

/** Translation context of all parts of the flight brief. */
struct FlightBrief
{
    Q_DECLARE_TR_FUNCTIONS(FlightBrief)
};

/** Columns of the brief's table, from the left. */
enum class BriefColumn : std::uint8_t
{
    Number,
    Name,
    Latitude,
    Longitude,
    Course,   ///< true, from the previous place
    Magnetic, ///< magnetic; empty if only true north is selected or known
    Leg,      ///< over ground; along the route for a path or track
    LegTime,
    GroundSpeed,      ///< mean ground speed of the leg
    Arrival,          ///< UTC, or time since the start of the run
    FirstUncertainty, ///< uncertainty at arrival; for a track, the present one
    SecondUncertainty ///< the other of `sigmaColumn` and `radiusColumn`
};
inline constexpr std::size_t kBriefColumns = 12;

/** Returns the column of sigma; the user chooses whether it is the first or the second. */
[[nodiscard]] BriefColumn sigmaColumn();
/** Returns the column of the 95 % radius. */
[[nodiscard]] BriefColumn radiusColumn();

/** Texts of one row. */
using BriefCells = std::array<QString, kBriefColumns>;

/** Returns the index of a column. */
[[nodiscard]] inline std::size_t placeOf(BriefColumn column)
{
    return static_cast<std::size_t>(column);
}

/** Route of one UAV: its start, each visit, and its end. */
struct BriefRoute
{
    std::size_t uav = 0; ///< index of the UAV in the content
    QString name;        ///< name of the UAV; empty for a single one
    std::vector<BriefCells> rows;
};

/** Column captions, in two lines. */
struct BriefCaptions
{
    BriefCells names;
    BriefCells units;
};

/** Returns the magnetic declination at the first UAV's start, degrees, positive east. Returns
 * nullopt if courses are by true north only (`shownDeclination_deg`). */
[[nodiscard]] std::optional<double> briefDeclination_deg(const ExportContent& content);

/** Returns the captions of the route tables; columns without captions are unused. */
[[nodiscard]] BriefCaptions briefCaptions(const ExportContent& content);
/** Returns the table of the route of UAV `uav` of the content. Throws `std::out_of_range` if there
 * is no such UAV. */
[[nodiscard]] BriefRoute briefRoute(const ExportContent& content, std::size_t uav,
                                    const QLocale& locale);

/** Returns a time such as "12:03:20", on a later day "00:03:20 +1"; `time_s` is seconds since the
 * start of the run. If the run has no date, returns the text of `clockText`. */
[[nodiscard]] QString briefClock(const ExportContent& content, double time_s);

/** Length over ground, duration and end of a UAV's route. */
struct PathTotals
{
    double length_m = 0;
    double time_s = 0;
    double end_s = 0;
};
/** Returns the totals of a UAV's route. */
[[nodiscard]] PathTotals pathTotals(const ExportUav& uav);

} // namespace berg
