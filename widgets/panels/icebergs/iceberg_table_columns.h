#pragma once

#include "widgets/panels/inspector/inspector_rows.h"
#include "widgets/places/places.h"
#include "widgets/theme/quantity_text.h"

#include <array>
#include <optional>

namespace berg {

/** Columns of the iceberg table, from left to right. */
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

/** Description of a column. */
struct IcebergColumnSpec
{
    QString key;    ///< key in the settings
    QString title;  ///< title with the unit
    QString copied; ///< title over copied numbers
    QString toolTip;
    bool isInEditor = false; ///< shown before take-off
    bool isInFlight = false; ///< shown in flight
    bool isOfAsset = false;  ///< shown only with an asset
    bool isOfFleet = false;  ///< shown only with several UAVs
    /** Editor as in the Inspector; nullopt if it is not an editable number. */
    std::optional<NumberRow> number{};
    std::optional<PlaceHalf> half{}; ///< half of the position that it holds
    ShownUnit unit{};                ///< unit in which numbers are shown, edited and copied

    /** Returns whether it can be edited before take-off; columns about the asset are derived. */
    [[nodiscard]] bool isEditable() const { return isInEditor && !isOfAsset; }
};

using IcebergColumnSpecs = std::array<IcebergColumnSpec, kIcebergColumns>;

/** Returns the columns by `IcebergColumn`, in the current language. */
[[nodiscard]] IcebergColumnSpecs icebergColumnSpecs();

[[nodiscard]] inline const IcebergColumnSpec& specOf(const IcebergColumnSpecs& specs,
                                                     IcebergColumn column)
{
    return specs[static_cast<std::size_t>(column)];
}

/**
 * Returns the number that an editor column holds for an iceberg; nullopt if there is none, e.g. the
 * direction of a stationary one.
 */
[[nodiscard]] std::optional<double> icebergNumber(const Iceberg& iceberg, IcebergColumn column);

/** Returns whether a typed or pasted number equals the one shown, so that nothing is set. */
[[nodiscard]] bool isShownAs(const Iceberg& iceberg, IcebergColumn column,
                             const IcebergColumnSpec& spec, double shown);

/** Sets the number of an editor column; a drift component keeps the other component. */
void setIcebergNumber(Iceberg& iceberg, IcebergColumn column, double value);

/**
 * Known drift as speed and direction, degrees clockwise from north; nullopt keeps the present
 * value.
 */
struct Drift
{
    std::optional<double> speed_mps;
    std::optional<double> direction_deg;
};

/**
 * Sets the drift. A stationary iceberg starts to the north. Unchanged speed and direction leave the
 * velocity unchanged to the last bit; a velocity beyond the largest allowed one is shortened.
 */
void setDrift(Iceberg& iceberg, const Drift& drift);

} // namespace berg
