#pragma once

#include "widgets/theme/theme.h"

#include <functional>

class QKeyEvent;
class QLabel;
class QTableView;
class QWidget;

namespace berg {

/** Keys that are this widget's while it has the focus, whatever they are to the window. */
void keepKeys(QWidget& widget, std::function<bool(const QKeyEvent&)> isMine);

/** The look and feel of a table in a dock: rows of one height, chosen one at a time and not edited,
 * without frame and grid; the tab key leaves it, the usual keys go to its first and last row. */
void setUpDockTable(QTableView& table, int row_px);

/** A text in the middle of the table, for while there are no rows. */
[[nodiscard]] QLabel* newTableNote(QTableView& table, const QString& name, int margin_px);

/** Of the table, its header and its note. */
void setDockTableTheme(QTableView& table, const Theme& theme);

} // namespace berg
