#pragma once

#include <algorithm>
#include <iterator>

namespace berg {

/** The first of these objects whose member `id` is this; nullptr when there is none. */
template <class Objects, class Id>
[[nodiscard]] auto* findById(Objects& objects, const Id& id)
{
    const auto found =
        std::ranges::find_if(objects, [&](const auto& object) { return object.id == id; });
    return found == std::ranges::end(objects) ? nullptr : &*found;
}

} // namespace berg
