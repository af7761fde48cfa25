#pragma once

#include "widgets/model/planned_sorties.h"
#include "widgets/panels/plan/plan_rows.h"
#include "widgets/theme/mission_clock.h"
#include "widgets/theme/theme.h"

#include <QWidget>

#include <utility>

class QContextMenuEvent;
class QLabel;
class QTableView;

namespace berg {

class PlanModel;
class PlanDelegate;

/**
 * The present plan as a list, of several UAVs by UAV, updated in place: scroll position and chosen
 * row stay. An iceberg that is dragged to another UAV is handed over to it.
 */
class PlanPanel : public QWidget
{
    Q_OBJECT

public:
    explicit PlanPanel(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    /** sigma at the end of the colour scale, the same as on the map; 0: the largest in the list. */
    void setSigmaFull(double full_m2);

    /** Instants are written by `times`. */
    void showPlan(std::vector<PlanSection> sections, const TimesAhead& times = {});
    /** Whether there is no plan because the scenario cannot be planned. */
    void setFaulty(bool isFaulty);
    /** Of the plan shown; none: only its length is told. */
    void showOutlook(std::optional<PlanOutlook> outlook);
    /** Of the plan shown, by UAV: margins at home, time without contact. */
    void showSorties(std::vector<std::optional<PlannedSortie>> sorties);
    /** The rows of what is selected elsewhere; those that come into the plan later, too. */
    void showSelection(const std::vector<std::string>& ids);
    /** Marks the row of this iceberg, e.g. while the pointer is on it on the map; empty: none. */
    void setHighlight(const std::string& id);

signals:
    /** The pointer is on the row of this iceberg or UAV; empty: on none any more. */
    void hovered(const std::string& id);
    /** Clicked, gone to by the keys, or Return pressed. */
    void activated(const std::string& id);
    /** By the mouse or the keyboard, for this iceberg or UAV. */
    void menuRequested(const QPoint& globalPos, const std::string& id);
    /** The iceberg was dragged to this UAV. */
    void handedOver(const std::string& iceberg, const std::string& uav);

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void setUpTable();
    void setColumnWidths();
    void chooseColumns();
    [[nodiscard]] int nameRoom_px() const;
    void updateSummary();
    [[nodiscard]] QString flownText() const;
    [[nodiscard]] QStringList summaryLines() const;
    [[nodiscard]] QString summaryToolTip() const;
    [[nodiscard]] QStringList sortieLines() const;
    [[nodiscard]] QString boundText(const PlanOutlook& outlook) const;
    void setHovered(const std::string& id);
    void choose(const QModelIndex& index);
    void selectRows();
    void requestMenu(const QContextMenuEvent& event);
    void updateEmpty();
    void updateSpans();
    /** While an iceberg is dragged over the table. */
    void showDropUav(const QPoint& at);

    PlanModel* m_model;
    PlanDelegate* m_delegate;
    QTableView* m_table;
    QLabel* m_empty;
    QLabel* m_summary;
    std::vector<PlanSection> m_sections;
    TimesAhead m_times;
    bool m_isFaulty = false;
    std::optional<PlanOutlook> m_outlook;
    std::vector<std::optional<PlannedSortie>> m_sorties;
    std::vector<int> m_spannedRows; ///< lines of UAVs
    std::string m_hovered;
    std::vector<std::string> m_selected; ///< kept while it is not in the plan
    bool m_isSelecting = false;          ///< here, not by the user
    double m_sigmaFull_m2 = 0;
    std::pair<bool, int> m_columnsFor; ///< what may be missed, and room for names, px
    QString m_widestArrival;
};

} // namespace berg
