#pragma once

// Private to core/io: corrects times that a wrong clock has produced.

#include "core/io/import/fields/import_table.h"

namespace berg {

/**
 * Moves times that are 1,024 weeks from the others, once or twice, back among them, because
 * receivers of satellite navigation cannot know how often that period has passed. Other times more
 * than 512 weeks from all the rest are removed. Both are noted. Nothing is changed unless most of
 * the times are together. The decision depends only on the file, never on the clock of the
 * computer. Cost: that of sorting the times.
 */
void correctTimes(SightingTable& table);

} // namespace berg
