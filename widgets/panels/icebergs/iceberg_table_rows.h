#pragma once

#include "widgets/model/flight_record.h"
#include "widgets/panels/icebergs/iceberg_table_columns.h"

#include <string>
#include <vector>

namespace berg {

/** How an iceberg stands in the mission; sorted, the former ones stand further up. */
enum class IcebergStanding
{
    InView,
    Target,
    Planned,   ///< further on in the visiting order
    Searched,  ///< lost, and the UAV is searching for it
    Lost,      ///< not where it should be
    GivenUp,   ///< the search for it has ended without it
    Unplanned, ///< known, not in the order
    Later,     ///< not there yet
    Left       ///< of the area that is monitored
};

/** One iceberg as numbers. */
struct IcebergTableRow
{
    std::string id;
    QString name; ///< empty: it has none
    IcebergStanding state = IcebergStanding::Unplanned;
    std::array<std::optional<double>, kIcebergColumns> values{}; ///< by column; none: nothing there
    QString uav;      ///< of several UAVs the one that has it in its order; empty: none has
    TimesAhead times; ///< writes its instants
    std::optional<double> ringEntry_s; ///< from now, into the inner ring of the asset, 0: inside
    bool operator==(const IcebergTableRow&) const = default;

    [[nodiscard]] std::optional<double> value(IcebergColumn column) const
    {
        return values[static_cast<std::size_t>(column)];
    }
    /** Name, or the id where it has none. */
    [[nodiscard]] QString label() const
    {
        return name.isEmpty() ? QString::fromStdString(id) : name;
    }
};

/** What can be edited, in the order of the scenario. */
[[nodiscard]] std::vector<IcebergTableRow> editorRows(const Scenario& scenario);

/**
 * The icebergs at the time shown, by index; of those that are not there yet, or have left the
 * area, nothing but the name.
 * `State` holds the place in the visiting order, from 1. Cost: linear in icebergs and events.
 */
[[nodiscard]] std::vector<IcebergTableRow> flightRows(const FlightRecord& record);

/** "in view", "number 3 in the order", of several UAVs "number 3 of uav-2". */
[[nodiscard]] QString stateText(const IcebergTableRow& row);

/** What a cell shows; metres without decimals in flight, where they run. */
[[nodiscard]] QString cellText(const IcebergTableRow& row, IcebergColumn column, bool inFlight,
                               const QLocale& locale);

/** More about a cell; empty: nothing. */
[[nodiscard]] QString cellToolTip(const IcebergTableRow& row, IcebergColumn column,
                                  const QLocale& locale);

} // namespace berg
