#pragma once

#include "core/scenario/scenario.h"

#include <QString>

namespace berg {

/** What an iceberg or a UAV is called on screen: its name, or the id where it has none. */
template <class Object>
[[nodiscard]] QString shownName(const Object& object)
{
    return QString::fromStdString(object.name.empty() ? object.id : object.name);
}

/** Whether UAVs have names, colours and icebergs of their own on screen: the only one needs none.
 */
template <class Uav>
[[nodiscard]] bool areToldApart(const std::vector<Uav>& uavs)
{
    return uavs.size() > 1;
}

/** Of the UAV of that number; empty: UAVs are not told apart, or there is none of that number. */
[[nodiscard]] inline QString nameInFleet(const std::vector<Uav>& uavs, int uav)
{
    const auto place = static_cast<std::size_t>(uav);
    return areToldApart(uavs) && uav >= 0 && place < uavs.size() ? shownName(uavs[place])
                                                                 : QString();
}

} // namespace berg
