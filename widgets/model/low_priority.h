#pragma once

#include <QtGlobal>

#ifdef Q_OS_LINUX
#include <sys/resource.h>
#endif

namespace berg {

/** Of the calling thread: QThread's priorities mean nothing under Linux's usual scheduler. */
inline void lowerPriority()
{
#ifdef Q_OS_LINUX
    constexpr int kNice = 10;
    setpriority(PRIO_PROCESS, 0, kNice); // 0: this thread alone; harmless when refused
#endif
}

} // namespace berg
