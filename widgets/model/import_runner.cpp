#include "widgets/model/import_runner.h"

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kPause_ms = 200;

} // namespace

ImportRunner::ImportRunner(QObject* parent) : QObject(parent), m_onThread(new QObject)
{
    m_pause.setSingleShot(true);
    connect(&m_pause, &QTimer::timeout, this, &ImportRunner::send);
    m_thread.setObjectName(u"import"_s);
    m_onThread->moveToThread(&m_thread);
    connect(&m_thread, &QThread::finished, m_onThread, &QObject::deleteLater);
    m_thread.start(QThread::LowPriority);
}

ImportRunner::~ImportRunner()
{
    m_stop.request_stop();
    m_thread.quit();
    m_thread.wait();
}

/** What is under way is of no use any more. */
void ImportRunner::dropWork()
{
    m_stop.request_stop();
    ++m_generation;
    m_pause.stop();
}

void ImportRunner::start(ImportRequest request, bool atOnce)
{
    dropWork();
    m_request = std::move(request);
    m_busy = true;
    m_pause.start(atOnce ? 0 : kPause_ms);
}

void ImportRunner::clear()
{
    dropWork();
    m_busy = false;
    m_request = {};
    QMetaObject::invokeMethod(
        m_onThread, [this] { m_loader.forget(); }, Qt::QueuedConnection);
}

void ImportRunner::send()
{
    m_stop = std::stop_source();
    QMetaObject::invokeMethod(
        m_onThread,
        [this, generation = m_generation, request = m_request, stop = m_stop.get_token()] {
            std::optional<ImportPreview> preview = m_loader.preview(request, stop);
            if (!preview || stop.stop_requested())
                return;
            if (m_results.put(
                    {.generation = generation,
                     .preview = std::make_shared<const ImportPreview>(std::move(*preview))}))
                QMetaObject::invokeMethod(this, &ImportRunner::take, Qt::QueuedConnection);
        },
        Qt::QueuedConnection);
}

void ImportRunner::take()
{
    const std::optional<Result> result = m_results.take();
    if (!result || result->generation != m_generation)
        return;
    m_busy = false;
    emit ready(result->preview);
}

} // namespace berg
