#pragma once

// Private to core/io: objects of a file that share an id although they are different icebergs.

#include "core/io/import/fields/import_table.h"
#include "core/io/text/read_budget.h"

namespace berg {

/**
 * Gives a separate id to each iceberg that shares one with another object of the file, using
 * `Sighting::track` and `Sighting::part`; call it when the ids are decided.
 *
 * Several places of one feature at one time are an iceberg each: "A", "A 2", "A 3", in their order,
 * so that features at other times continue them. Tracks of one name are one iceberg if every step
 * from one to the next needs no more than 1.5 m/s, apart from position errors of 200 m; they may
 * overlap. The others become "A 2", "A 3" and are noted. No such id is that of another object of
 * the file.
 */
void separateSharedIds(SightingTable& table, ReadBudget& budget);

} // namespace berg
