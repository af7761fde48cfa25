#pragma once

#include "widgets/print/brief_layout.h"

namespace berg {

/** Content of the page about the operation volume, in the user's language and units. */
struct OperationContent
{
    QString title;                 ///< marks the page as a proposal
    QString about;                 ///< name of the scenario
    std::vector<BriefFact> volume; ///< heights and widths
    QStringList formulas;          ///< derivation of the values, with source
    std::vector<QStringList> uavs; ///< captions, then reserve and weather limits per UAV
    std::vector<BriefFact> papers; ///< crew, call sign etc.; empty values are filled in by hand
    QStringList checklist;         ///< items; if empty, blank lines are printed
};

/** Returns the content of the page; the export must have an operation volume. */
[[nodiscard]] OperationContent operationContent(const ExportContent& content,
                                                const QLocale& locale);

/** Lays out the page that follows the flight brief. Checklist items that do not fit are left out,
 * and a line gives their number. */
[[nodiscard]] BriefLayout layOutOperation(const OperationContent& content, const QSizeF& page);

} // namespace berg
