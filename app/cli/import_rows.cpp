#include "app/cli/import_rows.h"

#include "app/cli/console.h"
#include "app/cli/language.h"
#include "app/cli/usage.h"
#include "core/base/number_text.h"
#include "core/scenario/text_checks.h"
#include "core/tracking/position_error.h"

namespace berg::cli {

std::string sourceNames()
{
    std::string names;
    for (const SightingSource source : kSightingSources)
        names += (names.empty() ? "" : ", ") + std::string(errorOf(source).name);
    return names;
}

std::string saidPlace(const Rejections& rejected, std::size_t number)
{
    if (rejected.place == "feature")
        return said(QT_TRANSLATE_NOOP("CommandLine", "feature %1"), {countOf(number)});
    if (rejected.place == "packet")
        return said(QT_TRANSLATE_NOOP("CommandLine", "packet %1"), {countOf(number)});
    if (rejected.place == "photograph")
        return said(QT_TRANSLATE_NOOP("CommandLine", "photograph %1"), {countOf(number)});
    return placeOf(rejected, number);
}

void printRows(const std::string& file, const Rejections& rows)
{
    std::size_t printed = 0;
    for (const RejectedRow& row : rows.first)
        if (printed++ < kMostListedRows)
            printMessage(word(file) + ": " +
                         said(Issue{Severity::Error, saidPlace(rows, row.line), reasonOf(row)}));
    if (rows.count > kMostListedRows)
        printMessage(word(file) + ": " +
                     said(QT_TRANSLATE_NOOP("CommandLine", "and %1 more"),
                          {countOf(rows.count - kMostListedRows)}));
}

} // namespace berg::cli
