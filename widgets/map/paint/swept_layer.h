#pragma once

#include "widgets/map/picture/swept_mask.h"

class QPainter;

namespace berg {

/**
 * Water seen so far, below a moving map. After a long flight a new view is painted over several
 * frames, a few milliseconds in each; until it is complete the last one is shown, moved and scaled.
 */
class SweptLayer
{
public:
    /** Continues painting for a few milliseconds and draws the best image available. */
    void paint(QPainter& painter, const std::vector<SweptTrail>& trails, const SweptStyle& style);

    /** Returns false if painting again would show more. */
    [[nodiscard]] bool isDone() const { return m_isDone; }

private:
    SweptMask m_shown;
    SweptMask m_next;          ///< next view, while it is incomplete
    bool m_isUnderWay = false; ///< whether `m_next` is in progress
    bool m_isDone = true;
};

} // namespace berg
