#pragma once

#include <QtGlobal>

#ifdef Q_OS_LINUX
#include <sys/resource.h>
#endif

namespace berg {

/**
 * Lowers the priority of the calling thread under Linux, where QThread's priorities have no effect
 * with the usual scheduler; does nothing on other systems.
 */
inline void lowerPriority()
{
#ifdef Q_OS_LINUX
    constexpr int kNice = 10;
    setpriority(PRIO_PROCESS, 0, kNice); // 0 is the calling thread alone; a refusal is harmless
#endif
}

} // namespace berg
