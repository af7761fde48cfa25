#pragma once

#include "app/window/window_part.h"

#include <cstdint>

namespace berg {

class Docks;
class FlightCard;
class ResultFiles;

/** The card at the end of a run: when it is shown, and what it leads to. */
class RunEnd : public WindowPart
{
    Q_OBJECT

public:
    RunEnd(WindowContext& context, const Docks& docks, ResultFiles& results);

    void setTheme(const Theme& theme);
    /** What was closed in the other window stays closed. */
    void takeOver(const RunEnd& other);

private:
    void showEnd();
    void tell();

    FlightCard* m_card;
    bool m_isClosed = false;        ///< by the user, for this run
    std::uint64_t m_generation = 0; ///< the run that is told of
};

} // namespace berg
