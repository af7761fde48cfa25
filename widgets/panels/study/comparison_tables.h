#pragma once

#include "widgets/study/run_list.h"
#include "widgets/theme/theme.h"

#include <QLocale>
#include <QTableView>

#include <vector>

namespace berg {

class CellModel;

/** Which of the two runs has the better value. */
enum class Better
{
    Neither,
    Reference,
    Other
};

/** A quantity of both runs, as texts. */
struct ComparisonRow
{
    QString label;
    QString reference;
    QString other{};
    QString difference{}; ///< other minus reference
    Better better = Better::Neither;
    QString toolTip;
};

/**
 * Returns zeta, visits, distance and other quantities at the common time; if `other` is null, of
 * the reference alone.
 */
[[nodiscard]] std::vector<ComparisonRow>
figureRows(const ComparedRun& reference, const ComparedRun* other, const QLocale& locale);
/** Returns the longest time out of view of each iceberg. */
[[nodiscard]] std::vector<ComparisonRow>
unseenRows(const ComparedRun& reference, const ComparedRun* other, const QLocale& locale);

/** Returns the relative difference, "+8.0 %" or "−0.4 %", or a dash for a reference of 0. */
[[nodiscard]] QString percentText(double value, double reference, const QLocale& locale);

/**
 * Table with a quantity a row, columns for the two runs and their difference; the better value is
 * bold.
 */
class ComparisonTable : public QTableView
{
    Q_OBJECT

public:
    explicit ComparisonTable(const QString& name, const QString& title, QWidget* parent = nullptr);
    void setTheme(const Theme& theme);
    void showRows(std::vector<ComparisonRow> rows);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void setColumnWidths();

    CellModel* m_model;
};

/** Applies the settings common to all tables of the panel, which must have their model. */
void setUpComparisonTable(QTableView& table, const QString& name, const QString& title);
/** Returns the width, px, of the longest text of a column, and at least that of `least`. */
[[nodiscard]] int widestText_px(const QTableView& table, int column, const QFont& font,
                                const QString& least);

} // namespace berg
