#pragma once

#include "widgets/print/brief_layout.h"

namespace berg {

/**
 * Sets the captions and rows of the UAVs from the top of `room`, in smaller type where they are too
 * wide; of many UAVs the first. Returns where the table ends.
 */
double setUavTable(BriefLayout& layout, const std::vector<QStringList>& rows, const QRectF& room);

} // namespace berg
