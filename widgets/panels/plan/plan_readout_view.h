#pragma once

#include "widgets/theme/theme.h"
#include "widgets/words/plan_text.h"

#include <QWidget>

class QGridLayout;
class QLabel;
class QToolButton;

namespace berg {

class FigureLabel;

/** Result of the last planning: the terms of Eq. (1) in large figures and the plan's quality. */
class PlanReadoutView : public QWidget
{
    Q_OBJECT

public:
    explicit PlanReadoutView(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    void showPlan(const PlanReadout& readout, PolicyKind policy);

    /** Shows or hides objective and distance weight. */
    void setDetailsShown(bool isShown);

signals:
    void checksRequested();
    void detailsToggled(bool isShown);

private:
    [[nodiscard]] FigureLabel* addFigure(QGridLayout& grid, QPoint place, const QString& name,
                                         const QString& caption, const QString& toolTip);
    void addDetails(QGridLayout& grid);
    void drawMark();

    Theme m_theme = Theme::light();
    PlanVerdict m_verdict = PlanVerdict::None;
    FigureLabel* m_distance = nullptr;
    FigureLabel* m_reward = nullptr;
    FigureLabel* m_objective = nullptr;
    FigureLabel* m_mu = nullptr;
    QToolButton* m_details = nullptr;
    QLabel* m_mark = nullptr;  ///< icon of the verdict
    QLabel* m_state = nullptr; ///< text of the verdict
};

} // namespace berg
