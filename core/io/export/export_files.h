#pragma once

#include "core/io/export/formats.h"
#include "core/io/text/file_set.h"

#include <functional>
#include <string>
#include <vector>

namespace berg {

using ExportFile = NewFile;

/** Makes the file of a painted format, for which the core has neither fonts nor paper. Throws
 * `Error`. */
using ExportPainter = std::function<std::string(const ExportFormat&, const ExportContent&)>;

/** Which UAV of the scenario an export holds. */
struct ExportUavId
{
    std::size_t row = 0;
    std::string id;
};

/** 1, or one for each UAV when the format holds one only. */
[[nodiscard]] std::size_t fileCount(const ExportFormat& format, const ExportContent& content);

/**
 * Where an export to `path` is written, with the UAVs of these ids and rows. Several files have the
 * ids of the UAVs in their names: `survey.plan` becomes `survey-uav-1.plan`, `survey-uav-2.plan`,
 * ...; characters that file names should not have become `_`.
 */
[[nodiscard]] std::vector<std::string> exportPaths(const ExportFormat& format,
                                                   const std::vector<ExportUavId>& uavs,
                                                   const std::string& path);

/**
 * The files of an export at `exportPaths`. Nothing is written. Throws `Error{Unsupported}` for a
 * painted format without a painter.
 */
[[nodiscard]] std::vector<ExportFile> exportFiles(const ExportFormat& format,
                                                  const ExportContent& content,
                                                  const std::string& path,
                                                  const ExportPainter& painter = {});

} // namespace berg
