#pragma once

#include "widgets/tables/cell_model.h"

#include <QDialog>

class QAction;

namespace berg {

/**
 * A chart as a table in a window of its own, for users who cannot see it. It shows the values at
 * the time it was opened; copies are tab-separated.
 */
class ValueTable : public QDialog
{
    Q_OBJECT

public:
    /** Shows `values`, the data of the chart named `chart`. */
    ValueTable(const QString& chart, const CellSheet& values, QWidget* parent);

    /** Opens a window that deletes itself when closed. */
    static void open(const QString& chart, const CellSheet& values, QWidget* parent);
};

/** Adds the action "Show values as a table" with shortcut V to a chart; returns it for its menu. */
[[nodiscard]] QAction* addValueAction(QWidget& chart);

} // namespace berg
