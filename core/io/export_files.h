#pragma once

#include "core/io/formats.h"

#include <functional>
#include <string>
#include <vector>

namespace berg {

struct ExportFile
{
    std::string path;
    std::string content;
};

/** Makes the file of a painted format, for which the core has neither fonts nor paper. Throws
 * `Error`. */
using ExportPainter = std::function<std::string(const ExportFormat&, const ExportContent&)>;

/** 1, or one for each UAV when the format holds one only. */
[[nodiscard]] std::size_t fileCount(const ExportFormat& format, const ExportContent& content);

/**
 * The files of an export to `path`. Several have the ids of the UAVs in their names: `survey.plan`
 * becomes `survey-uav-1.plan`, `survey-uav-2.plan`, ...; characters that file names should not have
 * become `_`. Nothing is written. Throws `Error{Unsupported}` for a painted format without a
 * painter.
 */
[[nodiscard]] std::vector<ExportFile> exportFiles(const ExportFormat& format,
                                                  const ExportContent& content,
                                                  const std::string& path,
                                                  const ExportPainter& painter = {});

} // namespace berg
