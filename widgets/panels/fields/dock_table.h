#pragma once

class QTableView;

namespace berg {

/** The look and feel of a table in a dock: rows of one height, chosen one at a time and not edited,
 * without frame and grid; the tab key leaves it. */
void setUpDockTable(QTableView& table, int row_px);

} // namespace berg
