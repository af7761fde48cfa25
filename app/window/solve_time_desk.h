#pragma once

#include "app/window/window_part.h"

namespace berg {

class Docks;

/** Solve times that are measured here: their dock, their file, and the question about them. */
class SolveTimeDesk : public WindowPart
{
    Q_OBJECT

public:
    SolveTimeDesk(WindowContext& context, const Docks& docks);

    void show();
    /** Asks about what would be lost of the measured times. False: not now. */
    [[nodiscard]] bool maySettle();

private:
    bool save();

    const Docks& m_docks;
};

} // namespace berg
