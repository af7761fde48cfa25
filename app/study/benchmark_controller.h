#pragma once

#include "app/layout/window_part.h"

namespace berg {

class Docks;

/** Solve times that are measured here: their dock, their file, and the question about them. */
class BenchmarkController : public WindowPart
{
    Q_OBJECT

public:
    BenchmarkController(WindowContext& context, const Docks& docks);

    void show();
    /** Asks about what would be lost of the measured times. False: not now. */
    [[nodiscard]] bool confirmDiscardBenchmark();

private:
    bool save();

    const Docks& m_docks;
};

} // namespace berg
