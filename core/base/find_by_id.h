#pragma once

#include <algorithm>
#include <iterator>

namespace berg {

/**
 * Returns a pointer to the first object whose member `id` equals this id, or null if there is none.
 */
template <class Objects, class Id>
[[nodiscard]] auto* findById(Objects& objects, const Id& id)
{
    const auto found =
        std::ranges::find_if(objects, [&](const auto& object) { return object.id == id; });
    return found == std::ranges::end(objects) ? nullptr : &*found;
}

} // namespace berg
