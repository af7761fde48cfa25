#pragma once

#include "widgets/model/import_preview.h"
#include "widgets/model/mailbox.h"

#include <QObject>
#include <QThread>
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
    /** Stops what is under way and waits for the thread: well under a second. */
    ~ImportRunner() override;

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
    struct Result
    {
        std::uint64_t generation = 0;
        std::shared_ptr<const ImportPreview> preview;
    };
    void dropWork();
    void send();
    void take();

    ImportRequest m_request;
    bool m_busy = false;
    std::uint64_t m_generation = 0;
    std::stop_source m_stop; ///< of the generation under way
    QTimer m_pause;          ///< runs out when changes have come to rest
    Mailbox<Result> m_results;
    ImportLoader m_loader; ///< of the thread of the runner
    QThread m_thread;
    QObject* m_onThread; ///< what is invoked on it runs on `m_thread`
};

} // namespace berg
