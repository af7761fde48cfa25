#include "widgets/model/export_worker.h"

#include "widgets/model/work_failure.h"

namespace berg {

void ExportWorker::write(const std::shared_ptr<const ExportJob>& job)
{
    const auto failure = failureOf([&] {
        emit written(std::make_shared<const std::vector<ExportFile>>(exportedFiles(job->prepared)),
                     job->order.generation);
    });
    if (failure)
        emit refused(failure->report);
}

void ExportWorker::look(const std::shared_ptr<const ExportJob>& job)
{
    const ExportOrder& order = job->order;
    std::optional<ExportPreview> preview;
    if (const auto failure =
            failureOf([&] { preview = exportPreview(job->prepared, order.stop); })) {
        preview.emplace();
        preview->request = order.request;
        preview->error = failure->error;
    }
    if (preview && !order.stop.stop_requested())
        emit looked(std::make_shared<const ExportPreview>(std::move(*preview)), order.generation);
}

} // namespace berg
