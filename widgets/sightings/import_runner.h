#pragma once

#include "widgets/sightings/import_preview.h"
#include "widgets/tasks/latest_task.h"

#include <QObject>
#include <QTimer>

namespace berg {

/**
 * Computes import previews on its own thread, a moment after the last change. The newest request
 * wins; results of older ones are dropped. GUI thread.
 */
class ImportRunner : public QObject
{
    Q_OBJECT

public:
    explicit ImportRunner(QObject* parent = nullptr);

    /** Requests a preview, computed at once or after a pause without further requests. */
    void start(ImportRequest request, bool atOnce = false);
    /** Drops the request and releases the file. */
    void clear();
    /** Returns whether a requested preview is still missing. */
    [[nodiscard]] bool isBusy() const { return m_busy; }

signals:
    /** Emitted with the preview of the newest request. */
    void ready(const std::shared_ptr<const berg::ImportPreview>& preview);

private:
    void dropWork();

    ImportRequest m_request;
    bool m_busy = false;
    QTimer m_pause;        ///< restarted by each change
    ImportLoader m_loader; ///< used on the runner's thread only
    using Preview = std::shared_ptr<const ImportPreview>;
    /** Last member: its thread ends before the others are destroyed. */
    LatestTask<ImportRequest, Preview> m_task;
};

} // namespace berg
