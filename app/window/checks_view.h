#pragma once

#include "app/window/window_part.h"

namespace berg {

class Docks;
class StatusLine;
struct Issue;

/** What is found about the scenario, and where it is found. */
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
