#pragma once

#include "widgets/model/run_list.h"
#include "widgets/theme/theme.h"

#include <QLocale>
#include <QTableWidget>

#include <vector>

namespace berg {

/** Which of the two runs is better off. */
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
    QString difference{}; ///< other less reference
    Better better = Better::Neither;
    QString toolTip;
};

/** zeta, visits, way and so on at the common time; `other` null: of the reference alone. */
[[nodiscard]] std::vector<ComparisonRow>
figureRows(const ComparedRun& reference, const ComparedRun* other, const QLocale& locale);
/** Longest time out of view of each iceberg. */
[[nodiscard]] std::vector<ComparisonRow>
unseenRows(const ComparedRun& reference, const ComparedRun* other, const QLocale& locale);

/** "+8.0 %", "−0.4 %"; of nothing: a dash. */
[[nodiscard]] QString percentText(double value, double reference, const QLocale& locale);

/** A quantity a row, columns for the two runs and their difference; the better number is bold. */
class ComparisonTable : public QTableWidget
{
    Q_OBJECT

public:
    explicit ComparisonTable(const QString& name, const QString& title, QWidget* parent = nullptr);
    void setTheme(const Theme& theme);
    void showRows(const std::vector<ComparisonRow>& rows);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void setColumnWidths();
};

/** What all tables of the panel have in common. */
void setUpComparisonTable(QTableWidget& table, const QString& name, const QString& title);

} // namespace berg
