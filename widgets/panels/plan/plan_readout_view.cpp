#include "widgets/panels/plan/plan_readout_view.h"

#include "widgets/panels/fields/panel_labels.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/quantity_text.h"

#include <QGridLayout>
#include <QLabel>
#include <QToolButton>

#include <array>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kMark_px = 16;
constexpr int kColumnGap_px = 12;
constexpr int kRowGap_px = 6; ///< gap between a caption and the figure of the next row

template <class Text>
void showFigure(FigureLabel& label, const std::optional<double>& value, const Text& text)
{
    showValue(label, value ? text(*value) : missingValueText());
}

} // namespace

PlanReadoutView::PlanReadoutView(QWidget* parent) : QWidget(parent)
{
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(kColumnGap_px);
    grid->setVerticalSpacing(0);
    grid->setColumnStretch(0, 1);
    grid->setColumnStretch(1, 1);
    grid->setRowMinimumHeight(2, kRowGap_px);

    m_distance = addFigure(
        *grid, {0, 0}, u"planDistance"_s, tr("Whole order"),
        tr("Planned length of the whole order through the air, with turns; in wind the mean of "
           "both directions. The solver weighs this length and the trade-off chart shows it. The "
           "plan panel shows the length of this sortie over ground."));
    m_reward = addFigure(*grid, {1, 0}, u"planReward"_s, tr("Uncertainty reward"),
                         tr("Sum of each iceberg's σ times the number of places after it in the "
                            "order: larger if uncertain icebergs come early."));

    auto* stateRow = new QHBoxLayout;
    stateRow->setSpacing(6);
    m_mark = new QLabel(this);
    m_mark->setFixedSize(kMark_px, kMark_px);
    m_state = new QLabel(this);
    m_state->setObjectName(u"planState"_s);
    m_state->setWordWrap(true);
    m_state->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    connect(m_state, &QLabel::linkActivated, this, &PlanReadoutView::checksRequested);
    stateRow->addWidget(m_mark, 0, Qt::AlignTop);
    stateRow->addWidget(m_state, 1);
    grid->addLayout(stateRow, 3, 0, 1, 2);
    addDetails(*grid);
    setTheme(m_theme);
    showPlan({}, PolicyKind::Visitation);
}

/** Adds the solver's figures, folded by default. */
void PlanReadoutView::addDetails(QGridLayout& grid)
{
    QToolButton* button = m_details = new QToolButton(this);
    button->setObjectName(u"planDetails"_s);
    button->setText(tr("Details"));
    button->setToolTip(tr("Objective and distance weight of the plan"));
    button->setCheckable(true);
    button->setAutoRaise(true);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setArrowType(Qt::RightArrow);
    auto* details = new QWidget(this);
    auto* figures = new QGridLayout(details);
    figures->setContentsMargins(0, 0, 0, 0);
    figures->setHorizontalSpacing(kColumnGap_px);
    figures->setVerticalSpacing(0);
    figures->setColumnStretch(0, 1);
    figures->setColumnStretch(1, 1);
    m_objective = addFigure(
        *figures, {0, 0}, u"planObjective"_s, tr("Objective"),
        tr("Distance cost minus uncertainty reward: the objective that the solver minimises."));
    m_mu = addFigure(*figures, {1, 0}, u"planMu"_s, tr("Distance weight μ"),
                     tr("Uncertainty that one metre of path must be worth; follows from τ."));
    details->hide();
    grid.addWidget(button, 4, 0, 1, 2, Qt::AlignLeft);
    grid.addWidget(details, 5, 0, 1, 2);
    connect(button, &QToolButton::toggled, details, [button, details](bool isOpen) {
        button->setArrowType(isOpen ? Qt::DownArrow : Qt::RightArrow);
        details->setVisible(isOpen);
    });
    connect(button, &QToolButton::toggled, this, &PlanReadoutView::detailsToggled);
}

void PlanReadoutView::setDetailsShown(bool isShown)
{
    m_details->setChecked(isShown);
}

/** Adds a figure with its caption below. `place` is column and row of the figure. */
FigureLabel* PlanReadoutView::addFigure(QGridLayout& grid, QPoint place, const QString& name,
                                        const QString& caption, const QString& toolTip)
{
    auto* figure = new FigureLabel(this);
    figure->setObjectName(name);
    figure->setAccessibleDescription(caption);
    figure->setToolTip(toolTip);
    auto* below = new CaptionLabel(caption, this);
    below->setToolTip(toolTip);
    grid.addWidget(figure, place.y(), place.x());
    grid.addWidget(below, place.y() + 1, place.x(), Qt::AlignTop);
    return figure;
}

void PlanReadoutView::setTheme(const Theme& theme)
{
    m_theme = theme;
    setCaptionTheme(*this, theme);
    for (FigureLabel* figure : {m_distance, m_reward})
        figure->setFont(theme.figure());
    for (FigureLabel* figure : {m_objective, m_mu})
        figure->setFont(theme.strong());
    m_state->setFont(theme.body());
    m_state->setMinimumHeight(heightOfTwoLines_px(theme.body())); // the text gets longer in flight
    drawMark();
}

void PlanReadoutView::drawMark()
{
    // Icons by PlanVerdict, from Proven on.
    constexpr std::array kMarks{IconName::Proven, IconName::Estimate, IconName::Warning,
                                IconName::Fault};
    if (m_verdict != PlanVerdict::None)
        m_mark->setPixmap(icon(kMarks.at(static_cast<std::size_t>(m_verdict) - 1), m_theme)
                              .pixmap(QSize(kMark_px, kMark_px), devicePixelRatioF()));
    m_mark->setVisible(m_verdict != PlanVerdict::None);
}

void PlanReadoutView::showPlan(const PlanReadout& readout, PolicyKind policy)
{
    const PlanFigures figures = planFigures(readout, policy);
    showFigure(*m_distance, figures.distance_m,
               [&](double value_m) { return distanceText(value_m, locale()); });
    showFigure(*m_reward, figures.reward_m2,
               [&](double value_m2) { return sigmaText(value_m2, locale()); });
    showFigure(*m_objective, figures.objective_m2, [&](double value_m2) {
        return tr("%1 m²").arg(significantText(value_m2, 4, locale()));
    });
    showFigure(*m_mu, figures.mu_m, [&](double value_m) {
        return tr("%1 m²/m").arg(significantText(value_m, 3, locale()));
    });

    const PlanState state = planState(readout, locale());
    const bool hasLink = state.verdict == PlanVerdict::Fault;
    m_state->setTextInteractionFlags( // without a link there is nothing to focus
        hasLink ? Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard
                : Qt::TextInteractionFlags(Qt::NoTextInteraction));
    if (hasLink)
        m_state->setText(u"%1 <a href=\"checks\">%2</a>"_s.arg(state.text.toHtmlEscaped(),
                                                               tr("Show the checks")));
    else
        m_state->setText(state.text);
    m_state->setAccessibleName(tr("State of the plan: %1").arg(state.text));
    m_state->setToolTip(state.details);
    m_mark->setToolTip(state.details);
    if (state.verdict != m_verdict) {
        m_verdict = state.verdict;
        drawMark();
    }
}

} // namespace berg
