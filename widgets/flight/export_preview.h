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

/** An export: format, options and target path. */
struct ExportRequest
{
    std::string formatId; ///< of `exportFormats`
    ExportOptions options = {};
    QString path = {};
    bool operator==(const ExportRequest&) const = default;
};

/**
 * Deferred painting of an export, which holds all data it shows. Both functions are slow. Thread:
 * any.
 */
struct ExportPainting
{
    std::function<std::string()> file;
    std::function<QImage()> image; ///< image for the preview
};

/** Paints the exports that are images or pages. Thread: any. */
struct ExportPaint
{
    ExportPainter file;
    /** Copies what it needs from the content and its mission; fast. */
    std::function<ExportPainting(const ExportFormat&, const ExportContent&)> prepare;
};

/** An export with its own copy of the mission's data, so that the mission may fly on. */
struct PreparedExport
{
    ExportRequest request;
    ExportContent content;                  ///< without its mission
    std::optional<std::string> table;       ///< text of a format about a flight
    std::optional<ExportPainting> painting; ///< set for painted formats
};

/** Preview of an export before it is written. */
struct ExportPreview
{
    ExportRequest request;
    std::optional<Error> error; ///< reason for which there is no preview; then the rest is empty
    ExportContent content;      ///< without its mission
    std::vector<ExportNote> notes;
    QStringList paths;     ///< paths of the files that would be written
    QString head;          ///< beginning of the first file; contents of a packed one
    bool isWhole = false;  ///< whether `head` is the whole file
    std::size_t bytes = 0; ///< size of all files
    QImage image;          ///< image of the first file, if it is painted
};

/**
 * Prepares an export. Solves nothing. Throws as `exportContent` and the writer of a format about a
 * flight, and `std::logic_error` for an unknown format id.
 */
[[nodiscard]] PreparedExport prepareExport(const ExportSource& source, const ExportRequest& request,
                                           const ExportPaint& paint);

/** Returns the files of a prepared export. Throws as `exportFiles`. */
[[nodiscard]] std::vector<ExportFile> exportedFiles(const PreparedExport& prepared);

/**
 * Returns a preview of a prepared export, or nullopt if it was stopped. Throws as `exportFiles`.
 */
[[nodiscard]] std::optional<ExportPreview> exportPreview(const PreparedExport& prepared,
                                                         const std::stop_token& stop = {});

} // namespace berg
