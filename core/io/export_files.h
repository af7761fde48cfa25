#pragma once

#include "core/io/formats.h"

#include <string>
#include <vector>

namespace berg {

struct ExportFile
{
    std::string path;
    std::string content;
};

/** 1, or one for each UAV when the format holds one only. */
[[nodiscard]] std::size_t fileCount(const ExportFormat& format, const ExportContent& content);

/**
 * The files of an export to `path`. Several have the ids of the UAVs in their names: `survey.plan`
 * becomes `survey-uav-1.plan`, `survey-uav-2.plan`, ...; characters that file names should not have
 * become `_`. Nothing is written.
 */
[[nodiscard]] std::vector<ExportFile>
exportFiles(const ExportFormat& format, const ExportContent& content, const std::string& path);

} // namespace berg
