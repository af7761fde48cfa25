#pragma once

#include "widgets/manual/markdown.h"

#include <array>
#include <optional>

namespace berg {

/** Chapters in their order: names of the files in resources/manual/LANGUAGE, without ".md". */
inline constexpr std::array kManualChapters{
    "start",   "window", "planning",  "policies", "zeta",  "world",  "safety",
    "studies", "field",  "autopilot", "commands", "files", "fields", "trouble"};

/** A chapter, read. */
struct ManualChapter
{
    QString name; ///< "planning"
    std::vector<MarkdownBlock> blocks;

    [[nodiscard]] QString title() const; ///< its first heading
    /** Its pictures come from that folder; those that are not there are left out. */
    [[nodiscard]] QString html(const QString& pictureFolder, bool anchors) const;
};

/** Where a search has found something. */
struct ManualHit
{
    QString place;   ///< "planning.html#block-12"
    QString heading; ///< of the section
    QString line;    ///< that holds the words, without marks
};

/** The manual of one language. */
struct Manual
{
    std::vector<ManualChapter> chapters;

    /** The chapter of a place such as "planning#tau" or "planning.html#tau"; none: no such one. */
    [[nodiscard]] const ManualChapter* chapterAt(const QString& place) const;
    /** Lines that hold all the words, whatever their case, in the order of the manual. */
    [[nodiscard]] std::vector<ManualHit> search(const QString& words) const;
};

/** Folder of the language of the window: "en", "nb". */
[[nodiscard]] QString manualLanguage();

/** From the resources of the program. */
[[nodiscard]] Manual readManual(const QString& language);

/** Where the pictures of a language are installed or built; the folder may be missing. */
[[nodiscard]] QString manualPictures(const QString& language);

} // namespace berg
