#pragma once

#include "widgets/study/run_list.h"
#include "widgets/theme/theme.h"

#include <QStyledItemDelegate>
#include <QTableView>

class QLabel;

namespace berg {

class CellModel;

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

/** State of a cell in the first two columns: `Qt::UserRole`. */
enum class RunMark
{
    None,   ///< cannot be chosen
    Choice, ///< can be chosen
    Chosen
};

/** Draws the disks A and B that mark the compared runs. */
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
 * List of runs, with circles that choose A and B; keys A, B and Delete do the same, F2 renames.
 * Shows and controls a list that it borrows.
 */
class RunTable : public QTableView
{
    Q_OBJECT

public:
    explicit RunTable(RunList& list, QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    void showRuns();
    void removeCurrent();
    /** Sizes the columns for this width; zeta is shown only if there is room. */
    void arrange(int width_px);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    [[nodiscard]] int currentRow() const { return currentIndex().row(); }
    void goTo(int row);
    void renameCurrent();
    void choose(int row, int column);

    RunList& m_list;
    Theme m_theme;
    CellModel* m_model;
    RunMarkDelegate* m_marks = nullptr;
    QLabel* m_empty = nullptr;
};

} // namespace berg
