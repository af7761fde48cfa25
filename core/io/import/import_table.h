#pragma once

#include "core/base/geodesy.h"
#include "core/base/geometry.h"
#include "core/io/import/import_scene.h"
#include "core/io/import/import_time.h"
#include "core/io/text/utc_time.h"
#include "core/plan/solve/names.h"

#include <array>
#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** Standard deviation of a position along an axis, by how it was got. */
inline constexpr double kGps_m = 20;
inline constexpr double kArgos_m = 300;     ///< as the fixes of a beacon by Argos scatter
inline constexpr double kAircraft_m = 1852; ///< a nautical mile: reports in whole minutes
inline constexpr double kRadar_m = 100;     ///< some pixels of a satellite's radar picture
inline constexpr std::array<Named<double>, 4> kPositionErrorNames{
    {{kGps_m, "gps"}, {kArgos_m, "argos"}, {kAircraft_m, "aircraft"}, {kRadar_m, "radar"}}};

/** What a column of a table, or a property of a feature, can tell about a sighting. */
enum class SightingField
{
    Id,
    Name,
    Date, ///< only where the time of day has a column of its own
    Time,
    Latitude,
    Longitude,
    Speed,
    Direction, ///< that it drifts towards, clockwise from north
    Sigma,
    Growth,
    Length,
    Radius,
    Area,
    SizeClass,
    Remarks
};

/** Names for `--map` and the dialog. */
inline constexpr std::array<Named<SightingField>, 15> kSightingFieldNames{{
    {SightingField::Id, "id"},
    {SightingField::Name, "name"},
    {SightingField::Date, "date"},
    {SightingField::Time, "time"},
    {SightingField::Latitude, "latitude"},
    {SightingField::Longitude, "longitude"},
    {SightingField::Speed, "speed"},
    {SightingField::Direction, "direction"},
    {SightingField::Sigma, "sigma"},
    {SightingField::Growth, "q"},
    {SightingField::Length, "length"},
    {SightingField::Radius, "radius"},
    {SightingField::Area, "area"},
    {SightingField::SizeClass, "size"},
    {SightingField::Remarks, "remarks"},
}};

/** How the drift of an iceberg changes, as exports of our own have it. */
struct SightedChange
{
    double velocitySd_mps = 0;
    double velocitySpread_mps = 0;
    double velocityTime_s = 0;
};

/** One row of a file: an iceberg was at this place. What the file does not tell is empty. */
struct Sighting
{
    std::size_t line = 0; ///< of the file; see `Rejections::place`
    std::string id;       ///< empty: the file names no iceberg
    std::string name;
    std::optional<UtcTime> time;
    LatLon place; ///< longitude in [-180, 180)
    std::optional<double> speed_mps;
    std::optional<double> direction_deg; ///< drifts towards, clockwise from north
    std::optional<Point> drift_mps;      ///< true east and north, as exports of our own have it
    std::optional<double> appearsIn_s;   ///< from its time on; likewise
    std::optional<SightedChange> change; ///< likewise
    std::optional<double> sigma_m2;
    std::optional<double> q_m2ps;
    std::optional<double> radius_m;
    bool grounded = false;
};

/** A row, or an iceberg, that is not taken, and why. */
struct RejectedRow
{
    std::size_t line = 0;
    IssueId fault = IssueId::RowWidth;
    std::string detail; ///< the text in question, shortened; may be empty
    bool operator==(const RejectedRow&) const = default;
};

/** Why, with the text in question: `latitude is no number from -90 to 90: "91"`. */
[[nodiscard]] IssueReason reasonOf(const RejectedRow& row);

/** Rejected rows: all are counted, the first thousand kept. */
struct Rejections
{
    std::vector<RejectedRow> first;
    std::size_t count = 0;
    std::string_view place = "line"; ///< what `RejectedRow::line` counts: or "feature", "packet"

    void add(RejectedRow row);
};

/** "line 3", "feature 3" or "packet 3". */
[[nodiscard]] std::string placeOf(const Rejections& rejected, std::size_t line);

/** Which column of the file serves as which field. */
struct FieldColumn
{
    SightingField field = SightingField::Id;
    std::string column; ///< its name in the file
    bool operator==(const FieldColumn&) const = default;
};
using ColumnMapping = std::vector<FieldColumn>;

/** What a file of sightings holds. */
struct SightingTable
{
    std::string format;             ///< id of the format it was read as
    std::deque<Sighting> sightings; ///< many: a vector would have to copy them to grow
    FileScene scene;
    Rejections rejected;
    std::vector<std::string> columns; ///< of the file by name; empty where there are none
    ColumnMapping mapping;            ///< as used
    std::vector<std::string> unused;  ///< columns of which nothing is taken
    double positionSd_m = kGps_m;     ///< of such files, where a sighting does not tell
    /** Without ids the rows are one iceberg (a beacon's track) rather than one each. */
    bool oneIceberg = false;
    /** A date that was read month first although nothing in the file tells; empty: none. */
    std::string guessedDate;
    std::size_t guessedLine = 0;        ///< where that date is
    std::optional<DateOrder> toldDates; ///< by the first date that can only be read one way
};

// Hostile or mistaken files end here.
inline constexpr std::size_t kMostColumns = 1000;
inline constexpr std::size_t kLongestId = 64;    ///< bytes
inline constexpr std::size_t kLongestName = 200; ///< bytes; longer ones are cut

} // namespace berg
