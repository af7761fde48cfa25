#include "app/cli/photo_files.h"

#include "app/cli/console.h"
#include "app/cli/language.h"
#include "app/cli/options.h"
#include "app/cli/usage.h"
#include "core/base/error.h"
#include "core/base/find_by_id.h"
#include "core/io/files/run_json.h"
#include "core/io/import/import_formats.h"
#include "core/io/text/atomic_file.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace berg::cli {

namespace {

bool isNamedAsPhoto(const std::filesystem::path& path)
{
    std::string suffix = path.extension().string();
    std::ranges::transform(suffix, suffix.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return suffix == ".jpg" || suffix == ".jpeg";
}

/** Returns the files with those of the folders among them. */
std::vector<std::string> photoPaths(const std::vector<std::string>& files)
{
    std::vector<std::string> paths;
    for (const std::string& file : files) {
        std::error_code error;
        if (!std::filesystem::is_directory(file, error)) {
            paths.push_back(file);
            continue;
        }
        std::vector<std::string> inside;
        std::filesystem::directory_iterator entry(file, error);
        for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error))
            if (isNamedAsPhoto(entry->path()) && entry->is_regular_file(error))
                inside.push_back(entry->path().string());
        if (error)
            throw Error(ErrorCode::FileUnreadable, file, error.message());
        std::ranges::sort(inside);
        paths.insert(paths.end(), inside.begin(), inside.end());
    }
    return paths;
}

PhotoYield compared(const std::vector<Photo>& photos, const PhotoRunArguments& run,
                    const std::stop_token& stop)
{
    if (run.runFile.empty())
        return photoYield(photos, {}, stop);
    const RunFile file = loadRun(run.runFile, stop);
    std::optional<std::size_t> uav;
    for (std::size_t row = 0; row < file.scenario.uavs.size(); ++row)
        if (file.scenario.uavs[row].id == run.uav)
            uav = row;
    if (!run.uav.empty() && !uav)
        throw UsageError(QT_TRANSLATE_NOOP("CommandLine", "--uav: the run has no UAV %1"),
                         {run.uav});
    const Mission mission = replay(file, stop);
    throwIfStopped(stop);
    return photoYield(photos, {.mission = &mission, .uav = uav}, stop);
}

} // namespace

bool arePhotos(const std::vector<std::string>& files)
{
    std::error_code error;
    if (files.size() > 1 || std::filesystem::is_directory(files.front(), error))
        return true;
    if (!std::filesystem::is_regular_file(files.front(), error))
        return false;
    std::ifstream file(files.front(), std::ios::binary);
    std::array<char, 3> start{};
    file.read(start.data(), start.size());
    return isPhotograph({start.data(), static_cast<std::size_t>(file.gcount())});
}

PhotoYield readPhotoFiles(const std::vector<std::string>& files, const PhotoRunArguments& run,
                          const std::stop_token& stop)
{
    std::vector<Photo> photos;
    std::vector<std::size_t> numbers; // of `photos` among all files
    Rejections damaged;
    const std::vector<std::string> paths = photoPaths(files);
    for (std::size_t i = 0; i < paths.size(); ++i) {
        const std::string bytes = readFile(paths[i], stop);
        const std::string name = std::filesystem::path(paths[i]).filename().string();
        try {
            if (!isPhotograph(bytes))
                throw Error(ErrorCode::InvalidInput, paths[i], {IssueId::PhotoDamaged});
            photos.push_back({.name = name, .data = photoData(bytes, paths[i])});
            numbers.push_back(i + 1);
        } catch (const Error& error) {
            if (error.code() != ErrorCode::InvalidInput)
                throw;
            damaged.add({.line = i + 1, .fault = IssueId::PhotoDamaged, .detail = name});
        }
    }
    PhotoYield yield = compared(photos, run, stop);
    yield.photos += damaged.count;
    for (RejectedRow& row : yield.table.rejected.first)
        row.line = numbers.at(row.line - 1);
    for (Sighting& sighting : yield.table.sightings)
        sighting.line = numbers.at(sighting.line - 1);
    for (PlacedPhoto& photo : yield.placed)
        photo.line = numbers.at(photo.line - 1);
    for (RejectedRow& row : damaged.first)
        yield.table.rejected.add(std::move(row));
    requireSightings(yield.table, files.front());
    return yield;
}

std::string photoSummary(const PhotoYield& yield)
{
    std::string text;
    const auto add = [&text](const char* what, std::size_t count, const char* of) {
        if (count > 0)
            text += rowLabel(what) + grouped(static_cast<double>(count)) + ' ' + of + '\n';
    };
    add("read", yield.photos, "photographs");
    add("", yield.positioned, "with a position");
    add("", yield.onTrack, "placed on the flown track by their time");
    add("", yield.near, "near an iceberg of the run");
    add("", yield.fresh, "near none");
    add("", yield.newIcebergs, "new icebergs");
    return text;
}

} // namespace berg::cli
