#pragma once

#include "widgets/model/cell_model.h"

#include <QDialog>

class QAction;

namespace berg {

/**
 * A chart as a table in a window of its own, for those who read rather than see it. Shows what was
 * so when it was opened; a copy is tab-separated.
 */
class ValueTable : public QDialog
{
    Q_OBJECT

public:
    /** The numbers of the chart of this name. */
    ValueTable(const QString& chart, const CellSheet& values, QWidget* parent);

    /** In a window that deletes itself when it is closed. */
    static void open(const QString& chart, const CellSheet& values, QWidget* parent);
};

/** "Show values as a table" of a chart: by its key, and to screen readers one of its actions. */
[[nodiscard]] QAction* addValueAction(QWidget& chart);

} // namespace berg
