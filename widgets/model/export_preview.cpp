#include "widgets/model/export_preview.h"

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

std::vector<ExportFile> filesOf(const ExportContent& content, const ExportRequest& request,
                                const ExportPaint& paint)
{
    return exportFiles(formatOf(request), content, QFile::encodeName(request.path).toStdString(),
                       paint.file);
}

/** Whole lines where there are any, never half a character. */
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

std::vector<ExportFile> exportedFiles(const ExportSource& source, const ExportRequest& request,
                                      const ExportPaint& paint)
{
    return filesOf(exportContent(source, request.options), request, paint);
}

ExportPreview exportPreview(const ExportSource& source, const ExportRequest& request,
                            const ExportPaint& paint)
{
    const ExportFormat& format = formatOf(request);
    ExportPreview preview;
    preview.request = request;
    preview.content = exportContent(source, request.options);
    const std::vector<ExportFile> files = filesOf(preview.content, request, paint);
    preview.notes = exportNotes(format, preview.content);
    for (const ExportFile& file : files) {
        preview.paths << QFile::decodeName(QByteArray::fromStdString(file.path));
        preview.bytes += file.content.size();
    }
    if (format.holds.painted)
        preview.picture = paint.look(format, preview.content);
    else
        addHead(preview, request.formatId == "kmz" ? findExportFormat("kml")->text(preview.content)
                                                   : files.front().content);
    preview.content.mission = nullptr; // flies on, and may end
    return preview;
}

} // namespace berg
