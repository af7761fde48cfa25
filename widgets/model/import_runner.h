#pragma once

#include "widgets/model/import_preview.h"
#include "widgets/model/latest_task.h"

#include <QObject>
#include <QTimer>

namespace berg {

/**
 * Computes what an import would do, on a thread of its own and a moment after the last change. The
 * newest request wins; a preview of another one is never shown. GUI thread.
 */
class ImportRunner : public QObject
{
    Q_OBJECT

public:
    explicit ImportRunner(QObject* parent = nullptr);

    /** Now, or after a moment in which nothing else is requested. */
    void start(ImportRequest request, bool atOnce = false);
    /** Nothing is wanted any more; lets the file go. */
    void clear();
    /** A preview is wanted and not there yet. */
    [[nodiscard]] bool isBusy() const { return m_busy; }

signals:
    /** Of the newest request. */
    void ready(const std::shared_ptr<const berg::ImportPreview>& preview);

private:
    void dropWork();

    ImportRequest m_request;
    bool m_busy = false;
    QTimer m_pause;        ///< runs out when changes have come to rest
    ImportLoader m_loader; ///< of the thread of the runner
    using Preview = std::shared_ptr<const ImportPreview>;
    LatestTask<ImportRequest, Preview> m_task; ///< last: it ends before the rest
};

} // namespace berg
