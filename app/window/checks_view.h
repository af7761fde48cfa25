#pragma once

#include "app/layout/window_part.h"

namespace berg {

class Docks;
class StatusLine;
struct Issue;

/** Shows the findings about the scenario and leads to their fields. */
class ChecksView : public WindowPart
{
    Q_OBJECT

public:
    ChecksView(WindowContext& context, const Docks& docks, StatusLine& status);

    void showChecks();
    void openChecks();
    /** Closes the list where it is in front, else opens it. */
    void toggleChecks();

private:
    void showCulprit(const Issue& issue);

    const Docks& m_docks;
    StatusLine& m_status;
};

} // namespace berg
