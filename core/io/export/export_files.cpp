#include "core/io/export/export_files.h"

#include <algorithm>
#include <string_view>

namespace berg {

namespace {

/** Keeps letters of any script, digits, and characters that every file system and shell accepts. */
std::string fileNamePart(std::string_view id)
{
    std::string part;
    for (const char c : id) {
        const bool plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') ||
                           (c >= 'a' && c <= 'z') || c == '-' || c == '.' || c == '_';
        part += plain || static_cast<unsigned char>(c) >= 0x80U ? c : '_';
    }
    return part;
}

std::string withId(const std::string& path, const std::string& id)
{
    const std::size_t slash = path.rfind('/');
    const std::size_t nameAt = slash == std::string::npos ? 0 : slash + 1;
    const std::size_t dot = path.rfind('.');
    const bool hasEnding = dot != std::string::npos && dot > nameAt;
    const std::size_t end = hasEnding ? dot : path.size();
    return path.substr(0, end) + '-' + id + path.substr(end);
}

std::string fileText(const ExportFormat& format, const ExportContent& content,
                     const ExportPainter& painter)
{
    if (!format.holds.painted)
        return format.text(content);
    if (!painter)
        throw Error(ErrorCode::Unsupported, "format",
                    {IssueId::NeedsWindow, {std::string(format.id)}});
    return painter(format, content);
}

} // namespace

std::size_t fileCount(const ExportFormat& format, const ExportContent& content)
{
    return format.holds.fleet ? 1 : content.uavs.size();
}

std::vector<std::string> exportPaths(const ExportFormat& format,
                                     const std::vector<ExportUavId>& uavs, const std::string& path)
{
    if (format.holds.fleet || uavs.size() == 1)
        return {path};
    std::vector<std::string> paths;
    for (const ExportUavId& uav : uavs) {
        const std::string plain = withId(path, fileNamePart(uav.id));
        std::string name = plain;
        for (std::size_t n = uav.row + 1; std::ranges::find(paths, name) != paths.end(); ++n)
            name = withId(plain, std::to_string(n));
        paths.push_back(std::move(name));
    }
    return paths;
}

std::vector<ExportFile> exportFiles(const ExportFormat& format, const ExportContent& content,
                                    const std::string& path, const ExportPainter& painter)
{
    if (fileCount(format, content) == 1)
        return {{.path = path, .content = fileText(format, content, painter)}};
    std::vector<ExportUavId> uavs;
    for (const ExportUav& uav : content.uavs)
        uavs.push_back({.row = uav.row, .id = uav.uav.id});
    const std::vector<std::string> paths = exportPaths(format, uavs, path);
    std::vector<ExportFile> files;
    ExportContent one = content;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        one.uavs = {content.uavs[i]};
        files.push_back({.path = paths[i], .content = fileText(format, one, painter)});
    }
    return files;
}

} // namespace berg
