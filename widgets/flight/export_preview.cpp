#include "widgets/flight/export_preview.h"

#include <QFile>

#include <stdexcept>

namespace berg {

namespace {

constexpr std::size_t kHeadBytes = 6000;

const ExportFormat& formatOf(const ExportRequest& request)
{
    const ExportFormat* format = findExportFormat(request.formatId);
    if (format == nullptr)
        throw std::logic_error("exportPreview: no such format");
    return *format;
}

/**
 * Returns the length of the preview, which ends at a line break if there is one, and never within a
 * UTF-8 character.
 */
std::size_t headLength(std::string_view text)
{
    if (text.size() <= kHeadBytes)
        return text.size();
    const std::size_t line = text.rfind('\n', kHeadBytes);
    if (line != std::string_view::npos)
        return line;
    std::size_t end = kHeadBytes;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U)
        --end;
    return end;
}

void addHead(ExportPreview& preview, const std::string& text)
{
    const std::size_t length = headLength(text);
    preview.head = QString::fromUtf8(text.data(), static_cast<qsizetype>(length));
    preview.isWhole = length == text.size();
}

} // namespace

PreparedExport prepareExport(const ExportSource& source, const ExportRequest& request,
                             const ExportPaint& paint)
{
    const ExportFormat& format = formatOf(request);
    PreparedExport prepared{.request = request,
                            .content = format.content(source, request.options),
                            .table = {},
                            .painting = {}};
    if (format.holds.painted)
        prepared.painting = paint.prepare(format, prepared.content);
    else if (format.holds.flownOnly)
        prepared.table = format.text(prepared.content);
    prepared.content.mission = nullptr; // the mission flies on and may end
    return prepared;
}

std::vector<ExportFile> exportedFiles(const PreparedExport& prepared)
{
    const std::string path = QFile::encodeName(prepared.request.path).toStdString();
    if (prepared.table)
        return {{.path = path, .content = *prepared.table}};
    const auto painter = [&prepared](const ExportFormat&, const ExportContent&) {
        return prepared.painting->file();
    };
    return exportFiles(formatOf(prepared.request), prepared.content, path, painter);
}

std::optional<ExportPreview> exportPreview(const PreparedExport& prepared,
                                           const std::stop_token& stop)
{
    const ExportFormat& format = formatOf(prepared.request);
    if (stop.stop_requested())
        return std::nullopt;
    ExportPreview preview;
    preview.request = prepared.request;
    preview.content = prepared.content;
    const std::vector<ExportFile> files = exportedFiles(prepared);
    if (stop.stop_requested())
        return std::nullopt;
    preview.notes = exportNotes(format, preview.content);
    for (const ExportFile& file : files) {
        preview.paths << QFile::decodeName(QByteArray::fromStdString(file.path));
        preview.bytes += file.content.size();
    }
    if (prepared.painting)
        preview.image = prepared.painting->image();
    else
        addHead(preview, format.id == "kmz" ? findExportFormat("kml")->text(preview.content)
                                            : files.front().content);
    return preview;
}

} // namespace berg
