#pragma once

#include <functional>

class QKeyEvent;
class QTableView;
class QWidget;

namespace berg {

/** Keys that are this widget's while it has the focus, whatever they are to the window. */
void keepKeys(QWidget& widget, std::function<bool(const QKeyEvent&)> isMine);

/** The look and feel of a table in a dock: rows of one height, chosen one at a time and not edited,
 * without frame and grid; the tab key leaves it, the usual keys go to its first and last row. */
void setUpDockTable(QTableView& table, int row_px);

} // namespace berg
