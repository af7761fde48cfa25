#pragma once

#include "widgets/manual/markdown.h"

#include <array>
#include <optional>

namespace berg {

/** Chapters in order: names of the files in resources/manual/LANGUAGE without ".md". */
inline constexpr std::array kManualChapters{
    "start",   "window", "planning",  "policies", "zeta",  "world",  "safety",
    "studies", "field",  "autopilot", "commands", "files", "fields", "trouble"};

/** A parsed chapter. */
struct ManualChapter
{
    QString name; ///< "planning"
    std::vector<MarkdownBlock> blocks;

    [[nodiscard]] QString title() const; ///< its first heading
    /** HTML of the chapter. Pictures are taken from that folder; missing ones are left out. */
    [[nodiscard]] QString html(const QString& pictureFolder, bool anchors) const;
};

/** A search result. */
struct ManualHit
{
    QString place;   ///< "planning.html#block-12"
    QString heading; ///< heading of the section
    QString line;    ///< matching line as plain text
};

/** The manual of one language. */
struct Manual
{
    std::vector<ManualChapter> chapters;

    /** Chapter of a place such as "planning#tau" or "planning.html#tau"; null if unknown. */
    [[nodiscard]] const ManualChapter* chapterAt(const QString& place) const;
    /** Lines that contain all the words, ignoring case, in the order of the manual. */
    [[nodiscard]] std::vector<ManualHit> search(const QString& words) const;
};

/** Manual folder for the window's language: "en", "nb". */
[[nodiscard]] QString manualLanguage();

/** Reads the manual of a language from the program's resources. */
[[nodiscard]] Manual readManual(const QString& language);

/** Folder of the pictures of a language, installed or built; it may be missing. */
[[nodiscard]] QString manualPictures(const QString& language);

} // namespace berg
