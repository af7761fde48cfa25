#include "widgets/sightings/import_runner.h"

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kPause_ms = 200;

} // namespace

ImportRunner::ImportRunner(QObject* parent)
    : QObject(parent)
    , m_task(u"import"_s,
             {.work =
                  [this](const ImportRequest& request, const std::stop_token& stop,
                         const auto& deliver) {
                      if (auto preview = m_loader.preview(request, stop))
                          deliver(std::make_shared<const ImportPreview>(std::move(*preview)));
                  },
              .deliver =
                  [this](const Preview& preview) {
                      m_busy = false;
                      emit ready(preview);
                  }})
{
    m_pause.setSingleShot(true);
    connect(&m_pause, &QTimer::timeout, this, [this] { m_task.start(m_request); });
}

/** Stops current work; its result would be outdated. */
void ImportRunner::dropWork()
{
    m_task.drop();
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
    m_task.post([this] { m_loader.forget(); });
}

} // namespace berg
