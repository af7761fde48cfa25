#pragma once

#include "app/layout/window_part.h"

class QAction;

namespace berg {

/**
 * Undo and Redo. Undo takes back the last point of what is drawn on the map; else, in flight, the
 * last change of the flight, and before it the last edit of the scenario.
 */
class HistoryActions : public WindowPart
{
    Q_OBJECT

public:
    explicit HistoryActions(WindowContext& context);

    [[nodiscard]] QAction* undo() const { return m_undo; }
    [[nodiscard]] QAction* redo() const { return m_redo; }

private:
    void update();
    void undoLast();
    /** Asks first where time was flown since the change. */
    void undoChange();

    QAction* m_undo;
    QAction* m_redo;
};

} // namespace berg
