#pragma once

#include "widgets/panels/icebergs/iceberg_table_columns.h"

#include <QString>

#include <string>
#include <vector>

namespace berg {

/** Where pasted cells go. */
struct PasteTarget
{
    std::vector<std::string> ids;       ///< rows from the chosen one downwards
    std::vector<IcebergColumn> columns; ///< from the chosen one to the right
    std::vector<IcebergColumn> shown;   ///< all that a line of titles may name
    Iceberg added{};                    ///< what a line below the last row starts from
};

struct PasteOutcome
{
    QString fault;                  ///< a sentence; empty: `scenario` is what comes of it
    std::vector<std::string> ids{}; ///< of the icebergs pasted onto, the added ones last
    Scenario scenario{};
};

/**
 * The scenario with the cells of a spreadsheet in it. Where the first of several lines holds
 * titles of columns, they say which column goes where. An empty cell leaves what is there. Lines
 * below the last row add icebergs; one that comes with a name that is no id yet gets it as its id.
 * A name that is the id of its iceberg is none. A cell that cannot be read, or not be taken in the
 * limits of the inspector, is a fault of the whole.
 */
[[nodiscard]] PasteOutcome pasteCells(const Scenario& scenario, const QString& text,
                                      const PasteTarget& target, const IcebergColumnSpecs& specs,
                                      const QLocale& locale);

} // namespace berg
