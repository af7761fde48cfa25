#pragma once

#include "core/io/import/photo_yield.h"

#include <stop_token>
#include <string>
#include <vector>

namespace berg::cli {

/** The flight that photographs were taken on, as the command line names it. */
struct PhotoRunArguments
{
    std::string runFile; ///< empty for none
    std::string uav;     ///< id of the UAV with the camera; empty for the first
};

/** Returns true for several files, a folder, or a regular file that begins as a photograph. */
[[nodiscard]] bool arePhotos(const std::vector<std::string>& files);

/**
 * Reads the photographs, of a folder those named *.jpg or *.jpeg in the order of their names, and
 * compares them with the run. One that is damaged is a rejected row. Throws `Error` as `readFile`
 * and `loadRun`, InvalidInput if none can be used, Unsupported in a build without libexiv2;
 * `UsageError` for an unknown UAV.
 */
[[nodiscard]] PhotoYield readPhotoFiles(const std::vector<std::string>& files,
                                        const PhotoRunArguments& run, const std::stop_token& stop);

/** Returns the lines about photographs of the summary of an import. */
[[nodiscard]] std::string photoSummary(const PhotoYield& yield);

} // namespace berg::cli
