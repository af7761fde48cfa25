#pragma once

#include "core/scenario/scenario.h"

#include <QString>

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

/** Returns the name of the UAV with this index; empty for an invalid index or a single UAV. */
[[nodiscard]] inline QString nameInFleet(const std::vector<Uav>& uavs, int uav)
{
    const auto place = static_cast<std::size_t>(uav);
    return areDistinguished(uavs) && uav >= 0 && place < uavs.size() ? shownName(uavs[place])
                                                                     : QString();
}

} // namespace berg
