#pragma once

#include "widgets/flight/planned_sorties.h"
#include "widgets/panels/plan/plan_rows.h"
#include "widgets/theme/mission_clock.h"
#include "widgets/theme/theme.h"

#include <QWidget>

#include <tuple>

class QContextMenuEvent;
class QLabel;
class QTableView;

namespace berg {

class PlanModel;
class PlanDelegate;

/**
 * The present plan as a list, grouped by UAV if there are several. Updates keep scroll position and
 * current row. Dragging an iceberg onto another UAV requests its assignment.
 */
class PlanPanel : public QWidget
{
    Q_OBJECT

public:
    explicit PlanPanel(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    /** Sets sigma at the end of the colour scale, as on the map; 0 uses the largest in the list. */
    void setSigmaFull(double full_m2);

    /** Shows a plan; `times` formats instants. */
    void showPlan(std::vector<PlanSection> sections, const TimesAhead& times = {});
    /** Sets whether there is no plan because the scenario cannot be planned. */
    void setFaulty(bool isFaulty);
    /** Shows the outlook of the plan; nullopt shows only its length. */
    void showOutlook(std::optional<PlanOutlook> outlook);
    /** Shows the sorties of the plan, by UAV: margins on return, time without radio contact. */
    void showSorties(std::vector<std::optional<PlannedSortie>> sorties);
    /** Selects the rows of these ids, also those that enter the plan later. */
    void showSelection(const std::vector<std::string>& ids);
    /**
     * Highlights the row of this iceberg, e.g. while the pointer is on it on the map; an empty id
     * clears it.
     */
    void setHighlight(const std::string& id);

signals:
    /**
     * Emitted when the pointer moves to the row of this iceberg or UAV, or with an empty id when it
     * leaves.
     */
    void hovered(const std::string& id);
    /** Emitted by a click, by moving with the keys, or by Return. */
    void activated(const std::string& id);
    /** Requests the context menu of this iceberg or UAV, by mouse or keyboard. */
    void menuRequested(const QPoint& globalPos, const std::string& id);
    /** Emitted when the iceberg was dragged onto this UAV. */
    void assignRequested(const std::string& iceberg, const std::string& uav);

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
    /** Marks the drop target while an iceberg is dragged over the table. */
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
    std::vector<int> m_spannedRows; ///< rows of UAVs
    std::string m_hovered;
    std::vector<std::string> m_selected; ///< remembered while it is not in the plan
    bool m_isSelecting = false;          ///< whether the panel, not the user, changes the selection
    double m_sigmaFull_m2 = 0;
    /** Whether icebergs may be missed, whether the plan is a patrol, and the room for names, px. */
    std::tuple<bool, bool, int> m_columnsFor;
    QString m_widestArrival;
};

} // namespace berg
