#pragma once

#include "core/io/export/formats.h"
#include "core/io/text/file_set.h"

#include <functional>
#include <string>
#include <vector>

namespace berg {

/** A file of an export with its path. */
using ExportFile = NewFile;

/**
 * Makes the file of a painted format, for which the core has neither fonts nor paper. Throws
 * `Error`.
 */
using ExportPainter = std::function<std::string(const ExportFormat&, const ExportContent&)>;

/** Index and id of a UAV in an export. */
struct ExportUavId
{
    std::size_t row = 0;
    std::string id;
};

/** Returns the number of files: 1, or one for each UAV if the format holds only one. */
[[nodiscard]] std::size_t fileCount(const ExportFormat& format, const ExportContent& content);

/**
 * Returns the paths of the files of an export to `path`. If there are several, their names contain
 * the ids of the UAVs: `survey.plan` becomes `survey-uav-1.plan`, `survey-uav-2.plan`, ...;
 * characters unsuitable for file names become `_`.
 */
[[nodiscard]] std::vector<std::string> exportPaths(const ExportFormat& format,
                                                   const std::vector<ExportUavId>& uavs,
                                                   const std::string& path);

/**
 * Returns the files of an export at `exportPaths` without writing them. Throws `Error{Unsupported}`
 * for a painted format without a painter, `Error{InvalidInput}` for a `flownOnly` format without a
 * mission, and as the painter and the writer of the format.
 */
[[nodiscard]] std::vector<ExportFile> exportFiles(const ExportFormat& format,
                                                  const ExportContent& content,
                                                  const std::string& path,
                                                  const ExportPainter& painter = {});

} // namespace berg
