#pragma once

#include "widgets/panels/icebergs/iceberg_table_columns.h"

#include <QString>

#include <string>
#include <vector>

namespace berg {

/** Target of a paste. */
struct PasteTarget
{
    std::vector<std::string> ids;       ///< rows from the current one downwards
    std::vector<IcebergColumn> columns; ///< columns from the current one to the right
    std::vector<IcebergColumn> shown;   ///< all columns that a line of titles may name
    Iceberg added{};                    ///< pattern of icebergs added below the last row
};

/** Result of a paste. */
struct PasteOutcome
{
    QString fault;                  ///< a sentence; if it is empty, `scenario` is the result
    std::vector<std::string> ids{}; ///< icebergs changed, then those added
    Scenario scenario{};
};

/**
 * Returns the scenario with the pasted cells of a spreadsheet. If the first of several lines holds
 * column titles, they determine the columns. Empty cells change nothing. Lines below the last row
 * add icebergs; a name that is an unused id becomes the id. A name equal to the id is ignored. A
 * cell that cannot be read, or is outside the Inspector's limits, rejects the whole paste.
 */
[[nodiscard]] PasteOutcome pasteCells(const Scenario& scenario, const QString& text,
                                      const PasteTarget& target, const IcebergColumnSpecs& specs,
                                      const QLocale& locale);

} // namespace berg
