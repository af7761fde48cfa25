#pragma once

#include "core/base/find_by_id.h"
#include "core/scenario/fields.h"
#include "widgets/document/selection.h"
#include "widgets/panels/inspector/inspector_rows.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/object_names.h"

#include <QCoreApplication>

#include <iterator>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace berg {

// Helpers for the rows of icebergs, UAVs and the scenario.

/** Translation context. */
struct InspectorRows
{
    Q_DECLARE_TR_FUNCTIONS(InspectorRows)
};

/**
 * Returns the object of this type with this id in a scenario, const or not; null if there is none.
 */
template <class Object, class S>
[[nodiscard]] auto* objectIn(S& scenario, [[maybe_unused]] const std::string& id)
{
    if constexpr (std::is_same_v<Object, Iceberg>)
        return findById(scenario.icebergs, id);
    else if constexpr (std::is_same_v<Object, Uav>)
        return findById(scenario.uavs, id);
    else if constexpr (std::is_same_v<Object, NoFlyArea>) {
        const std::optional<std::size_t> place = noFlyPlace(id);
        return place && *place < scenario.noFly.size() ? &scenario.noFly[*place] : nullptr;
    } else if constexpr (std::is_same_v<Object, Asset>)
        return scenario.asset ? &*scenario.asset : nullptr;
    else if constexpr (std::is_same_v<Object, Operation>)
        return scenario.operation ? &*scenario.operation : nullptr;
    else if constexpr (std::is_same_v<Object, GroundStation>)
        return scenario.groundStation ? &*scenario.groundStation : nullptr;
    else if constexpr (std::is_same_v<Object, Weather>)
        return &scenario.weather;
    else if constexpr (std::is_same_v<Object, LatLon>)
        return &scenario.origin;
    else if constexpr (std::is_same_v<Object, ObserverSpec>)
        return &scenario.observer;
    else
        return &scenario;
}

/** Returns a range that does not depend on the scenario. */
inline auto always(const Limits& limits)
{
    return [limits](const Scenario&) { return limits; };
}

/** Returns the row under another key and undo text. */
template <class AnyRow>
[[nodiscard]] AnyRow named(AnyRow row, const QString& key, const QString& undoText)
{
    row.words.key = key;
    row.words.undoText = undoText;
    return row;
}

/** Returns the undo text of a field with this label. */
[[nodiscard]] QString changeText(const QString& label);

/** Returns the unit of a number in SI, or an empty text if the user chooses the unit. */
[[nodiscard]] QString siUnitText(Quantity quantity);

/** Returns a row in SI converted to the user's unit of the quantity. */
[[nodiscard]] NumberRow inUserUnit(NumberRow row, Quantity quantity);

/**
 * Returns whether icebergs are measured and filtered; settings of the filter are hidden otherwise.
 */
inline bool isFiltered(const Scenario& scenario, const std::string& /*id*/)
{
    return scenario.observer.model == ObserverModel::Kalman;
}

/** Returns whether the endurance of the UAV is limited. */
inline bool isLimited(const Scenario& scenario, const std::string& id)
{
    const Uav* uav = findById(scenario.uavs, id);
    return uav != nullptr && uav->spec.endurance_s > 0;
}

/** Returns whether the scenario has several UAVs. */
inline bool hasSeveralUavs(const Scenario& scenario, const std::string& /*id*/)
{
    return areDistinguished(scenario.uavs);
}

/** Returns the rows of the landing place; part of `uavRows`. */
[[nodiscard]] std::vector<InspectorRow> homeRows();

/** Returns the rows of the aircraft profile; part of `uavRows`. */
[[nodiscard]] std::vector<InspectorRow> aircraftRows();

/** Returns the rows of operation volume, permit and airspace; part of `scenarioRows`. */
[[nodiscard]] std::vector<InspectorRow> permitRows();
/** Returns the rows of weather and ground station; part of `scenarioRows`. */
[[nodiscard]] std::vector<InspectorRow> surroundingsRows();

/**
 * Returns the rows of east and north and of the geographic position; `kind` is the prefix of the
 * keys.
 */
template <class Object>
[[nodiscard]] std::vector<InspectorRow> positionRows(const QString& kind, const char* path);

/** Rows of a velocity: components in SI, and the texts for speed and direction. */
struct VelocityRows
{
    NumberRow east;
    NumberRow north;
    QString key; ///< prefix of the keys of speed and direction
    QString speedLabel;
    QString speedToolTip;
    QString directionLabel;
    QString directionToolTip;
    bool isFrom = false;                   ///< whether the direction is where it comes from
    double componentLimit_mps = 0;         ///< largest magnitude of a component
    std::optional<double> finest_mps = {}; ///< components are rounded to multiples of it
    std::function<Limits(const Scenario&)> speeds_mps;
    InfoRow direction{}; ///< shown beside components; hidden without `text`
};

/**
 * Returns the rows in the form of `shownUnits`. The direction is shown only for a nonzero speed.
 */
[[nodiscard]] std::vector<InspectorRow> velocityRows(const VelocityRows& given);

/** Returns "0.32 m/s towards 072°", as for currents. */
[[nodiscard]] QString towardsText(const Point& velocity_mps, const QLocale& locale);

/** Returns a range of SI numbers in a unit, rounded inwards to the decimals. */
[[nodiscard]] Limits shownLimits(const Limits& limits, const ShownUnit& unit, int decimals);

/**
 * Converts a row of metres or m/s to the present unit, including `unit`. Typed numbers are
 * converted exactly; SI units need no conversion.
 */
[[nodiscard]] NumberRow asDistance(NumberRow row);
[[nodiscard]] NumberRow asHeight(NumberRow row);
[[nodiscard]] NumberRow asSpeed(NumberRow row);

inline void beginGroup(std::vector<InspectorRow>& rows, const QString& key, const QString& title,
                       bool isFolded = false)
{
    rows.emplace_back(GroupRow{.key = key, .title = title, .isFolded = isFolded});
}

inline void append(std::vector<InspectorRow>& rows, std::vector<InspectorRow> more)
{
    std::move(more.begin(), more.end(), std::back_inserter(rows));
}

} // namespace berg
