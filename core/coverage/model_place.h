#pragma once

#include "core/base/index.h"

namespace berg {

/**
 * A place that is predicted: the icebergs of a request in its order, so that place 0 is node 1,
 * then further places of those that are lost. `placeOf` and `nodeOf` lead from nodes to places and
 * back.
 */
using ModelPlace = Index<class ModelPlaceKind>;
/** Places up to a count. */
using ModelPlaceRange = IndexRange<class ModelPlaceKind>;

/** Returns the place of an iceberg's node. */
[[nodiscard]] constexpr ModelPlace placeOf(NodeIndex node)
{
    return ModelPlace::of(node.number() - 1);
}
/** Returns the node of an iceberg that is a place. */
[[nodiscard]] constexpr NodeIndex nodeOf(ModelPlace iceberg)
{
    return NodeIndex::of(iceberg.number() + 1);
}

} // namespace berg
