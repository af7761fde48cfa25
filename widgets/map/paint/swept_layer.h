#pragma once

#include "widgets/map/paint/swept_mask.h"

class QPainter;

namespace berg {

/**
 * The water seen so far below a map that moves. After a long flight a new view is painted over
 * several frames, a few milliseconds in each; until then the last one is shown, moved and scaled.
 */
class SweptLayer
{
public:
    void paint(QPainter& painter, const std::vector<SweptTrail>& trails, const SweptLook& look);

    /** False: painting again shows more. */
    [[nodiscard]] bool isDone() const { return m_isDone; }

private:
    SweptMask m_shown;
    SweptMask m_next;          ///< of a view wanted, while there is more to paint of it
    bool m_isUnderWay = false; ///< `m_next`
    bool m_isDone = true;
};

} // namespace berg
