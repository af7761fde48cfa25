#pragma once

#include "core/io/export/export_notes.h"

#include <QLocale>
#include <QString>

namespace berg {

/** Groups of formats with similar readers. */
enum class ExportGroup
{
    Autopilots,
    Maps,
    Pages, ///< images and print
    Tables
};

/** Description of an export format for the user. */
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

/** Effect of an export on requested content. */
enum class ExportEffect
{
    Check,   ///< the mission may not fly as planned
    Note,    ///< nothing is lost
    Changed, ///< changed by the tool or the format
    LeftOut
};

/** Returns the effect that a note reports. */
[[nodiscard]] ExportEffect effectOf(ExportNoteKind kind);
[[nodiscard]] QString exportEffectText(ExportEffect effect);

/** Returns a note as a sentence with its numbers. */
[[nodiscard]] QString exportNoteText(const ExportNote& note, const QLocale& locale);

/**
 * Returns why an export is impossible, from the `Error` of `exportContent`: the option and the
 * reason.
 */
[[nodiscard]] QString exportRefusalText(const Error& error);

} // namespace berg
