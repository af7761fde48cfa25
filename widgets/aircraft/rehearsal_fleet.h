#pragma once

#include "core/sim/rehearsal_vehicle.h"

#include <QObject>
#include <QThread>

#include <vector>

namespace berg {

/**
 * Simulated aircraft of a rehearsal. Each sends its telemetry by UDP to a port of this computer,
 * like a real one. They fly on a thread of their own until the
 * fleet is destroyed. GUI thread.
 */
class RehearsalFleet : public QObject
{
    Q_OBJECT

public:
    /** Starts one aircraft for each of `aircraft`; ids on the link must differ. */
    RehearsalFleet(std::vector<RehearsalOptions> aircraft, int port);
    /** Waits for the thread, well under a second. */
    ~RehearsalFleet() override;

    /** Switches the mode of an aircraft, by its index, as its pilot does; for tests. */
    void setMode(std::size_t aircraft, std::uint32_t mode);
    /** Cuts or restores the link of all aircraft. They fly on. */
    void setSilent(bool isSilent);

private:
    class Worker;

    QThread m_thread;
    Worker* m_worker; ///< lives on `m_thread`
};

} // namespace berg
