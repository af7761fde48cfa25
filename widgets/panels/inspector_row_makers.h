#pragma once

#include "widgets/panels/inspector_rows.h"

#include <QCoreApplication>

#include <algorithm>
#include <iterator>
#include <type_traits>

namespace berg {

// What the rows of icebergs, UAVs and the scenario have in common.

/** Context of the translations. */
struct InspectorRows
{
    Q_DECLARE_TR_FUNCTIONS(InspectorRows)
};

// Ranges of `validate`; what it wants above 0 starts at the smallest number that can be typed.
inline constexpr Limits kVelocity_mps{.low = -kLargestVelocity_mps, .high = kLargestVelocity_mps};
inline constexpr Limits kExtent_m{.low = 0.1, .high = 1e6};
inline constexpr Limits kTime_s{.low = 0, .high = 1e9};

// Steps of the arrows.
inline constexpr double kVelocityStep_mps = 0.05;

/** nullptr when there is none. */
template <class Object>
[[nodiscard]] const Object* objectOf(const std::vector<Object>& objects, const std::string& id)
{
    const auto it = std::find_if(objects.begin(), objects.end(),
                                 [&](const Object& object) { return object.id == id; });
    return it == objects.end() ? nullptr : &*it;
}

/** The list of a scenario that holds objects of this kind. */
template <class Object, class S>
auto& listOf(S& scenario)
{
    if constexpr (std::is_same_v<Object, Iceberg>)
        return scenario.icebergs;
    else
        return scenario.uavs;
}

// Closures of a row about one number of an object.

/** Reads a number of an object: `number(object)` gives a reference to it. */
template <class Object, class Number>
auto reading(Number number)
{
    return [number](const Scenario& scenario, const std::string& id) -> double {
        const Object* object = objectOf(listOf<Object>(scenario), id);
        return object == nullptr ? 0 : number(*object);
    };
}

template <class Object, class Number>
auto writing(Number number)
{
    return [number](Scenario& scenario, const std::string& id, double value) {
        for (Object& object : listOf<Object>(scenario))
            if (object.id == id)
                number(object) = value;
    };
}

inline auto always(const Limits& limits)
{
    return [limits](const Scenario&) { return limits; };
}

template <class Object>
[[nodiscard]] TextRow nameRow(const QString& key);

/** East and north in metres, and the place on the globe they are; `kind` begins the keys. */
template <class Object>
[[nodiscard]] std::vector<InspectorRow> positionRows(const QString& kind);

/** "0.32 m/s towards 072°": the way it goes, as for currents. */
[[nodiscard]] QString towardsText(const Point& velocity_mps, const QLocale& locale);

inline void append(std::vector<InspectorRow>& rows, std::vector<InspectorRow> more)
{
    std::move(more.begin(), more.end(), std::back_inserter(rows));
}

} // namespace berg
