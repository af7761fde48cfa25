#include "widgets/tasks/latest_task.h"

#include "widgets/tasks/low_priority.h"

namespace berg {

WorkThread::WorkThread(const QString& name, WorkPriority priority) : m_onThread(new QObject)
{
    m_thread.setObjectName(name);
    m_onThread->moveToThread(&m_thread);
    QObject::connect(&m_thread, &QThread::finished, m_onThread, &QObject::deleteLater);
    m_thread.start();
    if (priority == WorkPriority::Low) // threads that it starts inherit it
        post([] { lowerPriority(); });
}

WorkThread::~WorkThread()
{
    m_thread.quit();
    m_thread.wait();
}

void WorkThread::waitForPosted()
{
    QMetaObject::invokeMethod(
        m_onThread, [] {}, Qt::BlockingQueuedConnection);
}

void WorkThread::finish()
{
    post([this] { m_thread.quit(); });
    m_thread.wait();
}

} // namespace berg
