#pragma once

#include "widgets/flight/export_preview.h"

#include <QObject>

namespace berg {

/** A requested export, valid for the mission of one generation only. */
struct ExportTask
{
    ExportRequest request;
    std::uint64_t generation = 0;
    /** Zeta predicted before take-off; nullopt if unknown. */
    std::optional<ZetaPrediction> predicted = {};
    std::stop_token stop = {}; ///< stops a preview
};

/**
 * Job of the export thread. It is passed by pointer because Qt loses its copies when memory runs
 * out.
 */
struct ExportJob
{
    ExportTask task;
    PreparedExport prepared;
};

/**
 * Makes the files and previews of exports on its own thread, so that the mission they are prepared
 * from flies on meanwhile. Results carry their generation.
 */
class ExportWorker : public QObject
{
    Q_OBJECT

public:
    /** Makes the files; `written` follows, or `refused` with an error text for the user. */
    void write(const std::shared_ptr<const ExportJob>& job);
    /** Makes the preview; `previewed` follows, also with an error, unless the job is stopped. */
    void makePreview(const std::shared_ptr<const ExportJob>& job);

signals:
    void written(const std::shared_ptr<const std::vector<berg::ExportFile>>& files,
                 quint64 generation);
    void previewed(const std::shared_ptr<const berg::ExportPreview>& preview, quint64 generation);
    void refused(const QString& message);
};

} // namespace berg
