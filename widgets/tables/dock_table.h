#pragma once

#include "widgets/theme/theme.h"

#include <functional>

class QKeyEvent;
class QLabel;
class QTableView;
class QWidget;

namespace berg {

/** Gives a widget with the focus the keys that `isMine` accepts, before shortcuts of the window. */
void keepKeys(QWidget& widget, std::function<bool(const QKeyEvent&)> isMine);

/**
 * Sets up a table in a dock: rows of equal height, single selection, no editing, frame or grid; Tab
 * leaves the table, Home and End go to its first and last row.
 */
void setUpDockTable(QTableView& table, int row_px);

/** Returns a label in the middle of the table, for a table without rows. */
[[nodiscard]] QLabel* newTableNote(QTableView& table, const QString& name, int margin_px);

/** Sets the theme of the table, its header and its note. */
void setDockTableTheme(QTableView& table, const Theme& theme);

} // namespace berg
