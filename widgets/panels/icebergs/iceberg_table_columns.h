#pragma once

#include "widgets/model/places.h"
#include "widgets/panels/inspector/inspector_rows.h"
#include "widgets/theme/quantity_text.h"

#include <array>
#include <optional>

namespace berg {

/** Columns of the table of icebergs, from left to right. */
enum class IcebergColumn
{
    Name,
    Sigma,
    Radius95,
    AssetDistance,
    AssetTime,
    State,
    Uav,
    Unseen,
    Arrival,
    Visits,
    East,
    North,
    Speed,
    Direction,
    DriftEast,
    DriftNorth,
    Sigma0,
    Growth,
    Observed,
    Appears,
    Latitude,
    Longitude
};
inline constexpr std::size_t kIcebergColumns =
    static_cast<std::size_t>(IcebergColumn::Longitude) + 1;

/** What one column is, whatever the rows are. */
struct IcebergColumnSpec
{
    QString key;    ///< names it in the settings
    QString title;  ///< with the unit
    QString copied; ///< title over copied numbers
    QString toolTip;
    bool isInEditor = false;           ///< there before take-off
    bool isInFlight = false;           ///< there in flight
    bool isOfAsset = false;            ///< there only with an asset
    bool isOfFleet = false;            ///< there only with several UAVs
    std::optional<NumberRow> number{}; ///< how the inspector edits it; none: no number to be edited
    std::optional<PlaceHalf> half{};   ///< it holds an angle of the place
    ShownUnit unit{};                  ///< its numbers are shown, edited and copied in this

    /** Before take-off; what tells of the asset follows from the rest. */
    [[nodiscard]] bool isEditable() const { return isInEditor && !isOfAsset; }
};

using IcebergColumnSpecs = std::array<IcebergColumnSpec, kIcebergColumns>;

/** By `IcebergColumn`, in the language of now. */
[[nodiscard]] IcebergColumnSpecs icebergColumnSpecs();

[[nodiscard]] inline const IcebergColumnSpec& specOf(const IcebergColumnSpecs& specs,
                                                     IcebergColumn column)
{
    return specs[static_cast<std::size_t>(column)];
}

/**
 * What an editor column holds of an iceberg alone; none: no number, e.g. the direction of one that
 * stands still.
 */
[[nodiscard]] std::optional<double> icebergNumber(const Iceberg& iceberg, IcebergColumn column);

/** Whether a number typed or pasted is the one an editor column shows: then nothing is to be set.
 */
[[nodiscard]] bool isShownAs(const Iceberg& iceberg, IcebergColumn column,
                             const IcebergColumnSpec& spec, double shown);

/** Sets what an editor column holds; that of drift keeps the other half of it. */
void setIcebergNumber(Iceberg& iceberg, IcebergColumn column, double value);

/** Known drift as a speed and the way it goes, degrees clockwise from north; none: as it is. */
struct Drift
{
    std::optional<double> speed_mps;
    std::optional<double> direction_deg;
};

/**
 * One that stands still starts to the north. Nothing changes, not even by rounding, when speed and
 * direction are what they were; a velocity beyond the largest allowed is shortened.
 */
void setDrift(Iceberg& iceberg, const Drift& drift);

} // namespace berg
