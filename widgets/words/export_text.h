#pragma once

#include "core/io/export/export_notes.h"

#include <QLocale>
#include <QString>

namespace berg {

/** What readers of a format have in common. */
enum class ExportGroup
{
    Autopilots,
    Maps,
    Pages, ///< pictures and print
    Tables
};

/** What one format is for, in the user's words. */
struct ExportFormatText
{
    ExportGroup group = ExportGroup::Tables;
    QString name; ///< "GPX"
    QString tool; ///< that it is meant for
    QString about;
};

[[nodiscard]] QString exportGroupText(ExportGroup group);
[[nodiscard]] ExportFormatText exportFormatText(const ExportFormat& format);

/** What becomes of something that was asked for. */
enum class ExportEffect
{
    Told,    ///< nothing is lost
    Changed, ///< by the tool or the format
    LeftOut
};

[[nodiscard]] ExportEffect effectOf(ExportNoteKind kind);
[[nodiscard]] QString exportEffectText(ExportEffect effect);

/** A note as a sentence with its numbers. */
[[nodiscard]] QString exportNoteText(const ExportNote& note, const QLocale& locale);

/** Why an export cannot be, from what `exportContent` threw: the option and the reason. */
[[nodiscard]] QString exportRefusalText(const Error& error);

} // namespace berg
