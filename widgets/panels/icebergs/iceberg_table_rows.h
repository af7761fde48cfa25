#pragma once

#include "widgets/flight/flight_record.h"
#include "widgets/panels/icebergs/iceberg_table_columns.h"

#include <string>
#include <vector>

namespace berg {

/** State of an iceberg in the mission, in sorting order. */
enum class IcebergStanding
{
    InView,
    Target,
    Planned,   ///< later in the visiting order
    Searched,  ///< lost; a UAV is searching for it
    Lost,      ///< lost; not seen where it was expected
    GivenUp,   ///< lost; the search was abandoned
    Unplanned, ///< known, not in the order
    Later,     ///< not appeared yet
    Left       ///< left the monitored area, or removed
};

/** Values of one iceberg. */
struct IcebergTableRow
{
    std::string id;
    QString name; ///< empty if it has no name
    IcebergStanding state = IcebergStanding::Unplanned;
    /** By column; nullopt for an empty cell. */
    std::array<std::optional<double>, kIcebergColumns> values{};
    QString uav;      ///< the UAV that has it in its order, if there are several; may be empty
    TimesAhead times; ///< formats the instants of the row
    /** Time until it enters the inner ring of the asset, s; 0 if inside. */
    std::optional<double> ringEntry_s;
    bool operator==(const IcebergTableRow&) const = default;

    [[nodiscard]] std::optional<double> value(IcebergColumn column) const
    {
        return values[static_cast<std::size_t>(column)];
    }
    /** Returns the name, or the id if it has no name. */
    [[nodiscard]] QString label() const
    {
        return name.isEmpty() ? QString::fromStdString(id) : name;
    }
};

/** Returns the editable values, in the order of the scenario. */
[[nodiscard]] std::vector<IcebergTableRow> editorRows(const Scenario& scenario);

/**
 * Returns the icebergs at the time shown, by index; those that have not appeared or have left have
 * only a name. `State` holds the place in the visiting order, from 1. Cost: linear in icebergs and
 * events.
 */
[[nodiscard]] std::vector<IcebergTableRow> flightRows(const FlightRecord& record);

/** Returns "in view", "number 3 in the order", or with several UAVs "number 3 of uav-2". */
[[nodiscard]] QString stateText(const IcebergTableRow& row);

/** Returns the text of a cell; in flight running metres have no decimals. */
[[nodiscard]] QString cellText(const IcebergTableRow& row, IcebergColumn column, bool inFlight,
                               const QLocale& locale);

/** Returns details of a cell; may be empty. */
[[nodiscard]] QString cellToolTip(const IcebergTableRow& row, IcebergColumn column,
                                  const QLocale& locale);

} // namespace berg
