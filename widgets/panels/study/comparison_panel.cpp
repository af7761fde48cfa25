#include "widgets/panels/study/comparison_panel.h"

#include "widgets/panels/fields/number_field.h"
#include "widgets/panels/study/comparison_tables.h"
#include "widgets/panels/study/run_table.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/quantity_text.h"

#include <QBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QTabWidget>
#include <QToolButton>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kMargin_px = 8;
constexpr int kGap_px = 6;
constexpr int kCellMargins_px = 10;
constexpr int kBar_px = 6;
/** A row and the header: docks may move from the side to the bottom. */
constexpr int kLowestTable_px = 44;
constexpr int kBarSteps = 1000;
constexpr int kLowFrom_px = 125;    ///< list and tables are side by side if wider than high by this
constexpr int kBesideFrom_px = 640; ///< width with room for the columns of both, else tabs

bool isTour(const ComparedRun& run)
{
    return run.planner.policy == PolicyKind::Tour && !run.wasChanged;
}

} // namespace

ComparisonPanel::ComparisonPanel(RunList& list, QWidget* parent) : QWidget(parent), m_list(list)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kMargin_px, kMargin_px, kMargin_px, kMargin_px);
    column->setSpacing(kGap_px);
    addTables();
    m_state = new QLabel;
    m_state->setObjectName(u"comparisonState"_s);
    m_state->setWordWrap(true);
    m_state->hide();
    column->addWidget(m_state);
    addActions();

    connect(&m_list, &RunList::changed, this, &ComparisonPanel::showRuns);
    connect(&m_list, &RunList::progress, this, &ComparisonPanel::showProgress);
    connect(&m_list, &RunList::finished, this, &ComparisonPanel::showEnd);
    setTheme(Theme::light());
    showRuns();
    arrange();
}

void ComparisonPanel::addTables()
{
    m_runs = new RunTable(m_list);
    connect(m_runs->selectionModel(), &QItemSelectionModel::currentChanged, this,
            &ComparisonPanel::updateEnabled);
    m_figures = new ComparisonTable(u"comparedFigures"_s, tr("Figures of the comparison"));
    m_unseen = new ComparisonTable(u"comparedIcebergs"_s, tr("Longest time unseen"));
    m_tabs = new QTabWidget;
    m_tabs->setObjectName(u"comparisonTabs"_s);
    m_tabs->setDocumentMode(true);
    m_tabs->addTab(m_figures, tr("Figures"));
    m_tabs->addTab(m_unseen, tr("Unseen"));
    m_tabs->setTabToolTip(1, tr("Longest time for which each iceberg was out of view."));
    for (QTableView* table : std::initializer_list<QTableView*>{m_runs, m_figures, m_unseen})
        table->setMinimumHeight(kLowestTable_px);
    m_content = new QBoxLayout(QBoxLayout::TopToBottom);
    m_content->setSpacing(kGap_px);
    m_content->addWidget(m_runs, 2);
    m_content->addWidget(m_tabs, 3);
    qobject_cast<QVBoxLayout*>(layout())->addLayout(m_content, 1);
}

QWidget* ComparisonPanel::progressOfFlight()
{
    m_progressText = new QLabel;
    m_progressText->setObjectName(u"comparisonProgressText"_s);
    m_bar = new QProgressBar;
    m_bar->setObjectName(u"comparisonProgress"_s);
    m_bar->setAccessibleName(tr("Progress of the flight in the background"));
    m_bar->setRange(0, kBarSteps);
    m_bar->setTextVisible(false);
    m_bar->setFixedHeight(kBar_px);
    auto* cancel = new QPushButton(tr("Cancel"));
    cancel->setObjectName(u"cancelComparison"_s);
    auto* under = new QVBoxLayout;
    under->setSpacing(2);
    under->addWidget(m_progressText);
    under->addWidget(m_bar);
    auto* progress = new QWidget;
    auto* progressRow = new QHBoxLayout(progress);
    progressRow->setContentsMargins(0, 0, 0, 0);
    progressRow->setSpacing(kGap_px);
    progressRow->addLayout(under, 1);
    progressRow->addWidget(cancel);
    connect(cancel, &QPushButton::clicked, &m_list, &RunList::cancel);
    return progress;
}

void ComparisonPanel::addActions()
{
    m_tour = new QPushButton(tr("Compare with the round tour"));
    m_tour->setObjectName(u"compareTour"_s);
    m_tour->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_flight = new QStackedWidget;
    m_flight->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_flight->addWidget(m_tour);
    m_flight->addWidget(progressOfFlight());

    m_tauLabel = new QLabel(tr("τ"));
    m_tau = new NumberField;
    m_tau->setObjectName(u"comparedTau"_s);
    m_tau->setAccessibleName(tr("Trade-off τ to fly"));
    m_tau->setToolTip(tr("0: most uncertain first; the larger, the shorter the route."));
    m_tau->setNumberFormat({.least = 2, .most = 4}, {});
    m_tau->setSingleStep(0.25);
    m_tau->setRange(limits::kTau.low, limits::kTau.high);
    m_tau->showValue(0.5);
    m_tauLabel->setBuddy(m_tau);
    m_fly = new QPushButton(tr("Fly"));
    m_fly->setObjectName(u"compareTau"_s);
    m_fly->setToolTip(tr("Flies the same scenario with this τ in the background."));
    m_open = new QToolButton;
    m_open->setObjectName(u"openComparedRun"_s);
    m_open->setAccessibleName(tr("Open run…"));
    m_open->setToolTip(tr("Open run…"));
    m_open->setAutoRaise(true);
    m_remove = new QPushButton(tr("Remove"));
    m_remove->setObjectName(u"removeComparedRun"_s);
    m_remove->setToolTip(tr("Removes the chosen run from the list."));
    for (QPushButton* button : {m_fly, m_remove}) {
        const int text_px = button->fontMetrics().horizontalAdvance(button->text());
        button->setMinimumWidth(1); // the style's minimum width is for dialogs
        button->setMaximumWidth(text_px + 3 * kCellMargins_px);
    }
    auto* row = new QHBoxLayout;
    row->setSpacing(kGap_px);
    row->addWidget(m_tauLabel);
    row->addWidget(withRemark(m_tau));
    row->addWidget(m_fly);
    row->addStretch();
    row->addWidget(m_open);
    row->addWidget(m_remove);
    m_actions = new QBoxLayout(QBoxLayout::TopToBottom);
    m_actions->setSpacing(kGap_px);
    m_actions->addWidget(m_flight, 1);
    m_actions->addLayout(row);
    qobject_cast<QVBoxLayout*>(layout())->addLayout(m_actions);

    connect(m_tour, &QPushButton::clicked, this, [this] {
        flyBeside([](PlannerSettings& planner) { planner.policy = PolicyKind::Tour; });
    });
    connect(m_fly, &QPushButton::clicked, this, [this] {
        m_tau->finishTyping();
        flyBeside([tau = m_tau->value()](PlannerSettings& planner) {
            planner.policy = PolicyKind::Visitation;
            planner.tau = tau;
        });
    });
    connect(m_open, &QToolButton::clicked, this, &ComparisonPanel::openRunRequested);
    connect(m_remove, &QPushButton::clicked, this, [this] { m_runs->removeCurrent(); });
}

void ComparisonPanel::setTheme(const Theme& theme)
{
    m_runs->setTheme(theme);
    m_figures->setTheme(theme);
    m_unseen->setTheme(theme);
    m_state->setFont(theme.small());
    m_progressText->setFont(theme.small());
    QPalette bar = m_bar->palette();
    bar.setColor(QPalette::Highlight, theme.plan);
    m_bar->setPalette(bar);
    m_open->setIcon(icon(IconName::Open, theme));
    showRuns();
    arrange();
}

void ComparisonPanel::setScenario(const Scenario& scenario)
{
    m_scenario = scenario;
    updateEnabled();
}

QSize ComparisonPanel::sizeHint() const
{
    return {480, 210};
}

bool ComparisonPanel::isOfThisWorld(const RunPointer& run) const
{
    return run && (!m_scenario || isSameWorld(run->scenario, *m_scenario));
}

void ComparisonPanel::flyBeside(const std::function<void(PlannerSettings&)>& change)
{
    m_state->hide();
    const RunPointer reference = m_list.reference();
    const bool beside = isOfThisWorld(reference);
    if (!beside && !m_scenario)
        return;
    PlannerSettings planner = beside ? reference->planner : m_scenario->planner;
    change(planner);
    if (beside) {
        m_list.addVariant(*reference, planner);
        return;
    }
    if (planner != m_scenario->planner)
        m_list.addFlown(*m_scenario, m_scenario->planner);
    m_list.addFlown(*m_scenario, planner);
}

void ComparisonPanel::showRuns()
{
    m_runs->showRuns();
    showFigures();
    arrange();
    updateEnabled();
}

void ComparisonPanel::showFigures()
{
    const RunPointer& reference = m_list.reference();
    m_tabs->setVisible(reference != nullptr);
    if (!reference)
        return;
    m_figures->showRows(figureRows(*reference, m_list.other().get(), locale()));
    m_unseen->showRows(unseenRows(*reference, m_list.other().get(), locale()));
}

void ComparisonPanel::showProgress(double flown_s, double duration_s)
{
    m_bar->setValue(duration_s > 0 ? static_cast<int>(kBarSteps * flown_s / duration_s) : 0);
    const QString name = m_list.flying(locale());
    m_progressText->setText(
        duration_s > 0
            ? tr("Flying %1: %2 of %3").arg(name, clockText(flown_s), clockText(duration_s))
            : tr("Opening %1").arg(name));
    updateEnabled();
}

void ComparisonPanel::showEnd(const QString& failure)
{
    m_state->setText(failure);
    m_state->setVisible(!failure.isEmpty());
    updateEnabled();
    arrangeActions();
}

void ComparisonPanel::updateEnabled()
{
    const bool flying = m_list.isFlying();
    const RunPointer& reference = m_list.reference();
    const bool beside = isOfThisWorld(reference);
    const bool hasWorld = beside || (m_scenario && !m_scenario->icebergs.empty());
    const bool isTourAlready = beside && isTour(*reference);
    m_flight->setCurrentIndex(flying ? 1 : 0);
    for (QWidget* part : std::initializer_list<QWidget*>{m_tauLabel, m_tau, m_fly})
        part->setVisible(!flying); // their room is used for the progress
    m_tour->setEnabled(hasWorld && !isTourAlready);
    m_tour->setToolTip(
        isTourAlready ? tr("The reference A is the tour itself: choose another one as A.")
                      : tr("Flies the same scenario along the shortest closed tour through all "
                           "icebergs, as in Figure 5 of the paper, in the background."));
    m_tau->setEnabled(hasWorld);
    m_fly->setEnabled(hasWorld);
    m_open->setEnabled(!flying);
    m_remove->setEnabled(m_runs->currentIndex().isValid());
}

/** Arranges side by side or on tabs in a low dock, one below the other in a narrow one. */
void ComparisonPanel::arrange()
{
    const bool isLow = width() > height() + kLowFrom_px;
    const bool isAlone = !m_list.reference();
    placeRuns(isLow && !isAlone && width() < kBesideFrom_px);
    m_content->setDirection(isLow ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    const bool isBeside = isLow && !isAlone && width() >= kBesideFrom_px;
    m_runs->arrange(isBeside ? width() * 2 / 5 : width());
    arrangeActions();
}

void ComparisonPanel::placeRuns(bool onTab)
{
    const bool isOnTab = m_tabs->indexOf(m_runs) >= 0;
    if (onTab == isOnTab)
        return;
    if (onTab) {
        m_tabs->insertTab(0, m_runs, m_runs->accessibleName());
        m_tabs->setCurrentIndex(0);
    } else {
        m_tabs->removeTab(0);
        m_content->insertWidget(0, m_runs, 2);
        m_runs->show();
    }
}

/** Arranges the actions on one line if the button has room there. */
void ComparisonPanel::arrangeActions()
{
    if (m_list.isFlying())
        return; // some buttons are hidden now
    const int needed_px = m_tour->fontMetrics().horizontalAdvance(m_tour->text()) + kCellMargins_px;
    const int beside_px =
        width() - 2 * kMargin_px - kGap_px - m_actions->itemAt(1)->sizeHint().width();
    m_actions->setDirection(beside_px >= needed_px ? QBoxLayout::LeftToRight
                                                   : QBoxLayout::TopToBottom);
}

void ComparisonPanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    arrange();
}

} // namespace berg
