#pragma once

#include "core/base/error.h"
#include "core/io/export/export_files.h"
#include "core/io/export/export_notes.h"

#include <QImage>
#include <QString>
#include <QStringList>

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>

namespace berg {

/** What is to be exported, how and where to. */
struct ExportRequest
{
    std::string formatId; ///< of `exportFormats`
    ExportOptions options = {};
    QString path = {};
    bool operator==(const ExportRequest&) const = default;
};

/** A page that holds all it shows; both take a while. Thread: any. */
struct ExportPainting
{
    std::function<std::string()> file;
    std::function<QImage()> look; ///< to be shown
};

/** Makes the exports that are pictures or pages. Thread: any. */
struct ExportPaint
{
    ExportPainter file;
    /** Takes what it needs of the content and its mission: quick. */
    std::function<ExportPainting(const ExportFormat&, const ExportContent&)> prepare;
};

/** An export that has taken what it needs of the mission, which may fly on. */
struct PreparedExport
{
    ExportRequest request;
    ExportContent content;                  ///< without its mission
    std::optional<std::string> table;       ///< of a format that is about a flight
    std::optional<ExportPainting> painting; ///< of a painted format
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

/** Of a format of the table. Solves nothing. Throws as `exportContent`. */
[[nodiscard]] PreparedExport prepareExport(const ExportSource& source, const ExportRequest& request,
                                           const ExportPaint& paint);

/** Throws as `exportFiles`. */
[[nodiscard]] std::vector<ExportFile> exportedFiles(const PreparedExport& prepared);

/** The same looked at; throws the same. None when stopped before it is complete. */
[[nodiscard]] std::optional<ExportPreview> exportPreview(const PreparedExport& prepared,
                                                         const std::stop_token& stop = {});

} // namespace berg
