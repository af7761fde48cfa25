#pragma once

#include "core/earth/geodesy.h"
#include "core/geometry/geometry.h"
#include "core/io/import/fields/import_scene.h"
#include "core/io/import/fields/import_time.h"
#include "core/plan/solve/names.h"
#include "core/scenario/utc_time.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/**
 * Standard deviation, along an axis, of a place whose source is not stated: that of satellite
 * navigation. For known sources see `errorOf`.
 */
inline constexpr double kMarkedPlace_m = 20;

/** Field of a sighting that a column of a table, or a property of a feature, can give. */
enum class SightingField
{
    Id,
    Name,
    Date, ///< only if the time of day is in another column
    Time,
    Latitude,
    Longitude,
    Speed,
    Direction, ///< direction of drift, clockwise from north
    Sigma,
    Growth,
    Length,
    Radius,
    Area,
    SizeClass,
    Remarks,
    Source ///< source of the position; see `sourceInWords`
};

/** Names of fields for `--map` and the dialog. */
inline constexpr std::array<Named<SightingField>, 16> kSightingFieldNames{{
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
    {SightingField::Source, "source"},
}};

/** Change of an iceberg's drift, as in Bergwatch exports. */
struct SightedDriftChange
{
    double velocitySd_mps = 0;
    double velocitySpread_mps = 0;
    double velocityTime_s = 0;
};

/** A text of a row that may be the id of its iceberg. */
struct IdText
{
    std::size_t rank = 0; ///< rank of the column; see `idTrust`
    std::string text;
};

/**
 * One row of a file: an iceberg was at this place. Members that the file does not give are empty.
 */
struct Sighting
{
    std::size_t line = 0;    ///< line of the file; see `Rejections::place`
    std::string id;          ///< empty if the file names no iceberg
    std::vector<IdText> ids; ///< all candidates, until `decideIdentity` has chosen one
    std::string name;
    std::optional<UtcTime> time;
    LatLon place; ///< longitude in [-180, 180)
    std::optional<double> speed_mps;
    std::optional<double> direction_deg;      ///< direction of drift, clockwise from north
    std::optional<Point> drift_mps;           ///< true east and north, from Bergwatch exports
    std::optional<double> appearsIn_s;        ///< counted from `time`, from Bergwatch exports
    std::optional<SightedDriftChange> change; ///< from Bergwatch exports
    std::optional<double> sigma_m2;
    std::optional<double> q_m2ps;
    std::optional<double> radius_m;
    bool grounded = false;
    std::optional<std::uint32_t> track; ///< number of its track in the file, from 1
    std::uint32_t part = 1;             ///< number of the place among those of its feature
};

/** A rejected row or iceberg, and why. */
struct RejectedRow
{
    std::size_t line = 0;
    IssueId fault = IssueId::RowWidth;
    std::string detail; ///< the text in question, shortened; may be empty
    bool operator==(const RejectedRow&) const = default;
};

/** Returns the reason with the text in question: `latitude is no number from -90 to 90: "91"`. */
[[nodiscard]] IssueReason reasonOf(const RejectedRow& row);

/** Rejected rows: all are counted, and the first thousand stored. */
struct Rejections
{
    std::vector<RejectedRow> first;
    std::size_t count = 0;
    /** Unit of `RejectedRow::line`: "line", "feature", "packet" or "photograph". */
    std::string_view place = "line";

    void add(RejectedRow row);
    /** Removes the rows that were added after the first `from` ones. */
    void forget(std::size_t from);
};

/** Returns "line 3", "feature 3", "packet 3" or "photograph 3". */
[[nodiscard]] std::string placeOf(const Rejections& rejected, std::size_t line);

/** Column of the file that is used for a field. */
struct FieldColumn
{
    SightingField field = SightingField::Id;
    std::string column; ///< its name in the file
    bool operator==(const FieldColumn&) const = default;
};
using ColumnMapping = std::vector<FieldColumn>;

/** Content of a file of sightings. */
struct SightingTable
{
    std::string format;             ///< id of the format as which it was read
    std::deque<Sighting> sightings; ///< a deque, because a growing vector would copy many entries
    FileScene scene;
    Rejections rejected; ///< rows and objects that are not used at all
    Rejections noted;    ///< rows that are used without a part of them, or changed
    std::optional<std::size_t> headerLine; ///< line of the header of a table
    std::vector<std::string> columns;      ///< names of the columns of the file
    ColumnMapping mapping;                 ///< mapping that was used
    std::vector<std::string> unused;       ///< columns that are not used
    double positionSd_m = kMarkedPlace_m;  ///< for sightings without their own
    /** Whether rows without ids are one iceberg (a beacon's track) and not one each. */
    bool oneIceberg = false;
    /**
     * Whether the file does not show which rows are one iceberg, so that the user must decide
     * (`ReadOptions::rows`, or a column for `SightingField::Id`). Ids and `oneIceberg` are then a
     * guess.
     */
    bool isIdentityUnclear = false;
    std::vector<std::string> idCandidates; ///< further columns that may hold ids
    /**
     * A date that was read month first although the file does not show its order; empty if none.
     */
    std::string guessedDate;
    std::size_t guessedLine = 0;         ///< line of that date
    std::optional<DateOrder> shownOrder; ///< by the first unambiguous date
};

// Limits for hostile or faulty files.
inline constexpr std::size_t kMostColumns = 1000;
inline constexpr std::size_t kLongestId = 64;    ///< bytes
inline constexpr std::size_t kLongestName = 200; ///< bytes; longer ones are cut

} // namespace berg
