#pragma once

#include <QString>

namespace berg {

/** What the user reads of an iceberg or a UAV: its name, or its id where it has none. */
template <class Named>
[[nodiscard]] QString shownName(const Named& named)
{
    return QString::fromStdString(named.name.empty() ? named.id : named.name);
}

} // namespace berg
