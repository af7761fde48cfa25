#pragma once

#include "core/scenario/scenario.h"

#include <QString>

#include <optional>

namespace berg {

/** Returns the name of an iceberg or UAV on screen: its name, or its id if it has none. */
template <class Object>
[[nodiscard]] QString shownName(const Object& object)
{
    return QString::fromStdString(object.name.empty() ? object.id : object.name);
}

/**
 * Returns whether UAVs have names, colours and icebergs of their own on screen, which a single UAV
 * does not need.
 */
template <class Uav>
[[nodiscard]] bool areDistinguished(const std::vector<Uav>& uavs)
{
    return uavs.size() > 1;
}

/** Returns the name of the UAV with this index; empty without a valid index or for a single UAV. */
[[nodiscard]] inline QString nameInFleet(const std::vector<Uav>& uavs, std::optional<int> uav)
{
    const auto place = static_cast<std::size_t>(uav.value_or(0));
    return areDistinguished(uavs) && uav && place < uavs.size() ? shownName(uavs[place])
                                                                : QString();
}

} // namespace berg
