#pragma once

#include "app/layout/window_part.h"

namespace berg {

/** The trade-off: settings of the planner in force, its curve, forecasts of the policies. */
class PlannerView : public WindowPart
{
    Q_OBJECT

public:
    explicit PlannerView(WindowContext& context);

    void show();

private:
    void showPlanner();
    void showCurve();
    void showForecasts();
};

} // namespace berg
