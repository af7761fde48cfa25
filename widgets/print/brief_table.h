#pragma once

#include "core/io/export/export_content.h"

#include <QCoreApplication>
#include <QLocale>
#include <QString>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace berg {

/** What all parts of the flight brief are translated as. */
struct FlightBrief
{
    Q_DECLARE_TR_FUNCTIONS(FlightBrief)
};

/** Of the table of the flight brief, from the left. */
enum class BriefColumn : std::uint8_t
{
    Number,
    Name,
    Latitude,
    Longitude,
    Course,   ///< true, from the place before
    Magnetic, ///< the same by magnetic north; empty where true north alone is wanted or known
    Leg,      ///< over ground; of a path or track along it
    LegTime,
    GroundSpeed,      ///< mean of the leg
    Arrival,          ///< UTC, or since the start of the run
    FirstUncertainty, ///< at arrival; of a track, now
    SecondUncertainty ///< the other of `sigmaColumn` and `radiusColumn`
};
inline constexpr std::size_t kBriefColumns = 12;

/** The columns of sigma and of the radius of 95 %: which comes first is the user's choice. */
[[nodiscard]] BriefColumn sigmaColumn();
[[nodiscard]] BriefColumn radiusColumn();

using BriefCells = std::array<QString, kBriefColumns>;

[[nodiscard]] inline std::size_t placeOf(BriefColumn column)
{
    return static_cast<std::size_t>(column);
}

/** The way of one UAV: its start, each visit, and where it ends. */
struct BriefRoute
{
    std::size_t uav = 0; ///< place among the UAVs of the content
    QString name;        ///< of the UAV
    std::vector<BriefCells> rows;
};

/** What is above the columns, in two lines. */
struct BriefCaptions
{
    BriefCells names;
    BriefCells units;
};

/** Magnetic declination where the first UAV starts, degrees, positive east; nullopt if courses are
 * given by true north alone (`shownDeclination_deg`). */
[[nodiscard]] std::optional<double> briefDeclination_deg(const ExportContent& content);

[[nodiscard]] BriefCaptions briefCaptions(const ExportContent& content);
[[nodiscard]] BriefRoute briefRoute(const ExportContent& content, std::size_t uav,
                                    const QLocale& locale);

/** "12:03:20", on a later day than the start "00:03:20 +1"; without a start as `clockText`. */
[[nodiscard]] QString briefClock(const ExportContent& content, double time_s);

/** Of the way of one UAV, over ground, and how long it takes. */
struct PathTotals
{
    double length_m = 0;
    double time_s = 0;
    double end_s = 0;
};
[[nodiscard]] PathTotals pathTotals(const ExportUav& uav);

} // namespace berg
