#include "core/io/export_files.h"

#include <algorithm>
#include <string_view>

namespace berg {

namespace {

/** Letters of any script, digits, and marks that every file system and shell takes. */
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

bool isTaken(const std::vector<ExportFile>& files, const std::string& name)
{
    return std::ranges::find(files, name, &ExportFile::path) != files.end();
}

std::string fileText(const ExportFormat& format, const ExportContent& content,
                     const ExportPainter& painter)
{
    if (!format.holds.painted)
        return format.text(content);
    if (!painter)
        throw Error(ErrorCode::Unsupported, "format",
                    std::string(format.id) + " is painted, which needs the program bergwatch");
    return painter(format, content);
}

} // namespace

std::size_t fileCount(const ExportFormat& format, const ExportContent& content)
{
    return format.holds.fleet ? 1 : content.uavs.size();
}

std::vector<ExportFile> exportFiles(const ExportFormat& format, const ExportContent& content,
                                    const std::string& path, const ExportPainter& painter)
{
    if (fileCount(format, content) == 1)
        return {{.path = path, .content = fileText(format, content, painter)}};
    std::vector<ExportFile> files;
    ExportContent one = content;
    for (const ExportUav& uav : content.uavs) {
        one.uavs = {uav};
        const std::string plain = withId(path, fileNamePart(uav.uav.id));
        std::string name = plain;
        for (std::size_t n = uav.row + 1; isTaken(files, name); ++n)
            name = withId(plain, std::to_string(n));
        files.push_back({.path = std::move(name), .content = fileText(format, one, painter)});
    }
    return files;
}

} // namespace berg
