#pragma once

#include <QDialog>
#include <QStringList>

#include <functional>

class QAction;

namespace berg {

/** The numbers of a chart as text, row by row. */
struct ChartValues
{
    QString title;
    QStringList columns;
    int rows = 0;
    std::function<QString(int row, int column)> text; ///< owns what it needs
};

/**
 * A chart as a table in a window of its own, for those who read rather than see it. Shows what was
 * so when it was opened; a copy is tab-separated.
 */
class ValueTable : public QDialog
{
    Q_OBJECT

public:
    ValueTable(const ChartValues& values, QWidget* parent);

    /** In a window that deletes itself when it is closed. */
    static void open(const ChartValues& values, QWidget* parent);
};

/** "Show values as a table" of a chart: by its key, and to screen readers one of its actions. */
[[nodiscard]] QAction* addValueAction(QWidget& chart);

} // namespace berg
