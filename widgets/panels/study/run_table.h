#pragma once

#include "widgets/model/run_list.h"
#include "widgets/theme/theme.h"

#include <QStyledItemDelegate>
#include <QTableWidget>

class QLabel;

namespace berg {

/** Columns of the list of runs. */
enum RunColumn
{
    RunReference,
    RunOther,
    RunName,
    RunZeta,
    RunDifference,
    RunColumnCount
};

/** How a cell of the first two columns stands: `Qt::UserRole`. */
enum class RunMark
{
    None,   ///< cannot be chosen
    Choice, ///< can be
    Chosen
};

/** The disks A and B with which the list of runs says what is compared. */
class RunMarkDelegate : public QStyledItemDelegate
{
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;
    void setTheme(const Theme& theme) { m_theme = theme; }
    void paint(QPainter* painter, const QStyleOptionViewItem& given,
               const QModelIndex& index) const override;

private:
    Theme m_theme;
};

/**
 * The runs there are, with the circles by which A and B are chosen; keys A, B and Delete do the
 * same, F2 renames. Shows and steers a list that it borrows.
 */
class RunTable : public QTableWidget
{
    Q_OBJECT

public:
    explicit RunTable(RunList& list, QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    void showRuns();
    void removeCurrent();
    /** Columns as they suit this width; zeta only where there is room for it. */
    void arrange(int width_px);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void commitData(QWidget* editor) override;

private:
    void renameCurrent();
    void showRun(int row);
    void choose(int row, int column);

    RunList& m_list;
    Theme m_theme;
    RunMarkDelegate* m_marks = nullptr;
    QLabel* m_empty = nullptr;
};

} // namespace berg
