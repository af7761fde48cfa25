#pragma once

#include "widgets/panels/plan_rows.h"
#include "widgets/theme/theme.h"

#include <QWidget>

class QLabel;
class QTableView;

namespace berg {

class PlanModel;
class PlanDelegate;

/** The present plan as a list, updated in place: scroll position and chosen row stay. */
class PlanPanel : public QWidget
{
    Q_OBJECT

public:
    explicit PlanPanel(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    /** sigma at the end of the colour scale, the same as on the map; 0: the largest in the list. */
    void setSigmaFull(double full_m2);

    /** `isHomeward`: on its way home or on the ground, where nothing is planned. */
    void showPlan(std::vector<PlanRow> rows, bool isHomeward = false);
    /** Of the plan shown; none: only its length is told. */
    void showOutlook(std::optional<PlanOutlook> outlook);
    /** Marks this iceberg's row, e.g. while the pointer is on it on the map; empty: none. */
    void setHighlight(const std::string& id);

signals:
    /** The pointer is on this iceberg's row; empty: on none any more. */
    void hovered(const std::string& id);
    /** Clicked, or Return pressed. */
    void activated(const std::string& id);

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void setUpTable();
    void setColumnWidths();
    void chooseColumns();
    void updateSummary();
    [[nodiscard]] QStringList summaryLines() const;
    [[nodiscard]] QString summaryToolTip() const;
    [[nodiscard]] QString boundText(const PlanOutlook& outlook) const;
    void setHovered(const std::string& id);
    void choose(const QModelIndex& index);

    PlanModel* m_model;
    PlanDelegate* m_delegate;
    QTableView* m_table;
    QLabel* m_empty;
    QLabel* m_summary;
    std::optional<PlanOutlook> m_outlook;
    std::string m_hovered;
    std::string m_chosen; ///< kept while it is not in the plan
    double m_sigmaFull_m2 = 0;
    bool m_hasHours = false; ///< of arrival times
};

} // namespace berg
