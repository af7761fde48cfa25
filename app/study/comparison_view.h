#pragma once

#include "app/layout/window_part.h"

namespace berg {

class Docks;

/** Two runs beside each other: their table, their chart, and runs opened for it. */
class ComparisonView : public WindowPart
{
    Q_OBJECT

public:
    ComparisonView(WindowContext& context, const Docks& docks);

    void show();

private:
    void showComparison();
    void showCursor();
    void openRun();

    const Docks& m_docks;
};

} // namespace berg
