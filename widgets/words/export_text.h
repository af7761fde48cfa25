#pragma once

#include "core/io/export/export_notes.h"

#include <QLocale>
#include <QString>

namespace berg {

/** Words of an export format (`ExportWords`) in the user's language. */
struct ExportFormatText
{
    ExportGroup group = ExportGroup::Tables;
    QString name; ///< "GPX"
    QString tool; ///< program or device the format is meant for
    QString about;
};

/** Returns the title of a group. */
[[nodiscard]] QString exportGroupText(ExportGroup group);
/** Returns the description of a format. */
[[nodiscard]] ExportFormatText exportFormatText(const ExportFormat& format);

/** Returns the title of an effect. */
[[nodiscard]] QString exportEffectText(ExportEffect effect);

/** Returns a note as a sentence with its numbers. */
[[nodiscard]] QString exportNoteText(const ExportNote& note, const QLocale& locale);

/**
 * Returns why an export is impossible, from the `Error` of `exportContent`: the option and the
 * reason.
 */
[[nodiscard]] QString exportRefusalText(const Error& error);

} // namespace berg
