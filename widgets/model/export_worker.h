#pragma once

#include "widgets/model/export_preview.h"

#include <QObject>

namespace berg {

/** An export asked for: of the mission of one generation, and no other. */
struct ExportOrder
{
    ExportRequest request;
    std::uint64_t generation = 0;
    std::optional<ZetaPrediction> predicted = {}; ///< before take-off; nullopt: not known
    std::stop_token stop = {};                    ///< of a preview
};

/** What is handed to the thread of exports. Qt loses its copies when memory runs out: one only. */
struct ExportJob
{
    ExportOrder order;
    PreparedExport prepared;
};

/**
 * Makes the files and the looks of exports on a thread of its own, so that the mission, from which
 * they are prepared, flies on meanwhile. Answers carry the generation they are of.
 */
class ExportWorker : public QObject
{
    Q_OBJECT

public:
    void write(const std::shared_ptr<const ExportJob>& job);
    void look(const std::shared_ptr<const ExportJob>& job);

signals:
    void written(const std::shared_ptr<const std::vector<berg::ExportFile>>& files,
                 quint64 generation);
    void looked(const std::shared_ptr<const berg::ExportPreview>& preview, quint64 generation);
    void refused(const QString& message);
};

} // namespace berg
