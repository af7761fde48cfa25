#pragma once

#include "app/layout/window_part.h"

#include <cstdint>

namespace berg {

class Docks;
class FlightCard;
class ResultFiles;

/** The card at the end of a run: when it is shown, and what it leads to. */
class RunSummaryController : public WindowPart
{
    Q_OBJECT

public:
    RunSummaryController(WindowContext& context, const Docks& docks, ResultFiles& results);

    void setTheme(const Theme& theme);
    /** Keeps the card closed if it was closed in the other window. */
    void takeOver(const RunSummaryController& other);

private:
    void showEnd();
    void showSummary();

    FlightCard* m_card;
    bool m_isClosed = false;        ///< by the user, for this run
    std::uint64_t m_generation = 0; ///< the run on the card
};

} // namespace berg
