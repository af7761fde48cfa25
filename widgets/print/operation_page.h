#pragma once

#include "widgets/print/brief_layout.h"

namespace berg {

/** What the page about the operation says, in the language and the units of the user. */
struct OperationContent
{
    QString title;                 ///< that it is a proposal
    QString about;                 ///< name of the scenario
    std::vector<BriefFact> volume; ///< heights and widths
    QStringList formulas;          ///< how they come about, and after whom
    std::vector<QStringList> uavs; ///< captions, then reserve and weather limits of each
    std::vector<BriefFact> papers; ///< crew, call sign, ...; empty values are filled in by hand
    QStringList checklist;         ///< its items; none: blank lines
};

[[nodiscard]] OperationContent operationContent(const ExportContent& content,
                                                const QLocale& locale);

/** The page that follows the flight brief; what does not fit is cut, with a line that says so. */
[[nodiscard]] BriefLayout layOutOperation(const OperationContent& content, const QSizeF& page);

} // namespace berg
