#include "widgets/model/export_worker.h"

#include "widgets/model/work_failure.h"

namespace berg {

void ExportWorker::write(const ExportOrder& order, const PreparedExport& prepared)
{
    const auto failure =
        failureOf([&] { emit written(exportedFiles(prepared), order.generation); });
    if (failure)
        emit refused(failure->report);
}

void ExportWorker::look(const ExportOrder& order, const PreparedExport& prepared)
{
    std::optional<ExportPreview> preview;
    if (const auto failure = failureOf([&] { preview = exportPreview(prepared, order.stop); })) {
        preview.emplace();
        preview->request = order.request;
        preview->error = failure->error;
    }
    if (preview && !order.stop.stop_requested())
        emit looked(std::make_shared<const ExportPreview>(std::move(*preview)), order.generation);
}

} // namespace berg
