#pragma once

#include "core/base/error.h"
#include "core/io/export_files.h"
#include "core/io/export_notes.h"

#include <QImage>
#include <QString>
#include <QStringList>

#include <functional>
#include <memory>
#include <optional>

namespace berg {

/** What is to be exported, how and where to. */
struct ExportRequest
{
    std::string formatId; ///< of `exportFormats`
    ExportOptions options = {};
    QString path = {};
    bool operator==(const ExportRequest&) const = default;
};

/** Makes the exports that are pictures or pages. Thread: any. */
struct ExportPaint
{
    ExportPainter file;
    std::function<QImage(const ExportFormat&, const ExportContent&)> look; ///< to be shown
};

/** What an export comes to, before it is written. */
struct ExportPreview
{
    ExportRequest request;
    std::optional<Error> error; ///< why there is none; then the rest is empty
    ExportContent content;      ///< without its mission
    std::vector<ExportNote> notes;
    QStringList paths;     ///< of the files that would be written
    QString head;          ///< how the first file begins; of a packed one what is in it
    bool isWhole = false;  ///< the head is all of it
    std::size_t bytes = 0; ///< of all files
    QImage picture;        ///< of the first file, when it is painted
};

/** Of a format of the table. Throws as `exportContent` and `exportFiles`. */
[[nodiscard]] std::vector<ExportFile>
exportedFiles(const ExportSource& source, const ExportRequest& request, const ExportPaint& paint);

/** The same looked at; throws the same. */
[[nodiscard]] ExportPreview exportPreview(const ExportSource& source, const ExportRequest& request,
                                          const ExportPaint& paint);

} // namespace berg
