#include "widgets/panels/study/study_panel.h"

#include "core/study/paper_figures.h"
#include "widgets/panels/fields/panel_labels.h"
#include "widgets/panels/study/study_results.h"
#include "widgets/panels/study/study_run_bar.h"
#include "widgets/panels/study/study_setup.h"

#include <QBoxLayout>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kMargin_px = 10;
constexpr int kGap_px = 6;
constexpr int kColumns_px = 14; ///< gap between setup and results
constexpr int kSection_px = 10;
constexpr QSize kBest_px(1140, 690);

PlannerSettings plannerOf(const Scenario& scenario, const StudySetting& setting)
{
    PlannerSettings planner = scenario.planner;
    planner.policy = setting.policy;
    planner.tau = setting.tau.value_or(planner.tau);
    return planner;
}

} // namespace

StudyPanel::StudyPanel(StudyRunner& runner, QWidget* parent) : QWidget(parent), m_runner(runner)
{
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(kMargin_px, kMargin_px, kMargin_px, kMargin_px);
    row->setSpacing(kColumns_px);
    row->addWidget(makeSetup());
    m_results = new StudyResults(m_runner);
    row->addWidget(m_results, 1);
    connect(m_setup, &StudySetup::edited, this, &StudyPanel::showSpec);
    connect(m_run, &StudyRunBar::startRequested, this, &StudyPanel::requestStart);
    connect(&m_runner, &StudyRunner::finished, this, &StudyPanel::compareIfWanted);
    setTheme(Theme::light());
    showSpec();
}

QWidget* StudyPanel::makeSetup()
{
    auto* inside = new QWidget;
    auto* column = new QVBoxLayout(inside);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kGap_px);
    addFigures(*column);
    column->addSpacing(kSection_px);
    m_setup = new StudySetup;
    column->addWidget(m_setup);
    column->addSpacing(kSection_px);
    m_run = new StudyRunBar(m_runner);
    column->addWidget(m_run);
    column->addStretch();
    auto* scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(inside);
    scroll->setFixedWidth(inside->sizeHint().width() +
                          scroll->verticalScrollBar()->sizeHint().width());
    return scroll;
}

void StudyPanel::addFigures(QBoxLayout& column)
{
    auto* caption = new CaptionLabel(tr("As in the paper"));
    column.addWidget(caption);
    auto* row = new QHBoxLayout;
    row->setSpacing(kGap_px);
    const auto add = [&](const QString& name, const QString& text, const QString& toolTip) {
        auto* button = new QPushButton(text);
        button->setObjectName(name);
        button->setToolTip(toolTip);
        row->addWidget(button, 1);
        return button;
    };
    const QPushButton* third =
        add(u"figure3"_s, tr("Figure 3"),
            tr("Solution times by number of icebergs: opens the solve time study with the sizes "
               "of the paper."));
    m_figure4 = add(u"figure4"_s, tr("Figure 4"),
                    tr("ζ of this scenario for τ = 0, 0.1 … 4, and of the shortest path."));
    m_figure5 =
        add(u"figure5"_s, tr("Figure 5"),
            tr("Two flights of this scenario over the map: with the τ of lowest ζ, and along the "
               "shortest path."));
    column.addLayout(row);
    connect(third, &QPushButton::clicked, this, &StudyPanel::solveTimesRequested);
    connect(m_figure4, &QPushButton::clicked, this,
            [this] { emit startRequested(figure4(m_setup->scenario()), false); });
    connect(m_figure5, &QPushButton::clicked, this, &StudyPanel::startFigure5);
}

QSize StudyPanel::sizeHint() const
{
    return kBest_px;
}

void StudyPanel::setTheme(const Theme& theme)
{
    setCaptionTheme(*this, theme);
    m_setup->setTheme(theme);
    m_run->setTheme(theme);
    m_results->setTheme(theme);
}

void StudyPanel::setScenario(const Scenario& scenario)
{
    m_setup->setScenario(scenario);
    for (QPushButton* figure : {m_figure4, m_figure5})
        figure->setEnabled(!scenario.icebergs.empty());
}

void StudyPanel::showNote(const QString& text)
{
    m_run->showNote(text);
}

void StudyPanel::showSpec()
{
    m_run->setSpec(m_setup->spec(), m_setup->fault());
}

void StudyPanel::requestStart()
{
    m_setup->finishTyping();
    emit startRequested(m_setup->spec(), false);
}

void StudyPanel::start(const StudySpec& spec, bool compares)
{
    if (spec != m_setup->spec())
        m_setup->showSpec(spec);
    m_comparesThen = compares;
    m_runner.start(spec);
}

void StudyPanel::showAs(const StudyPanel& other)
{
    m_setup->showSpec(other.m_setup->spec());
    m_comparesThen = other.m_comparesThen;
}

/** Figure 5 uses the tau of lowest zeta in Figure 4, which is flown first if needed. */
void StudyPanel::startFigure5()
{
    const StudyPointer& result = m_runner.result();
    const bool isKnown = !m_runner.isRunning() && m_runner.isComplete() && result &&
                         result->study.spec == figure4(m_setup->scenario());
    if (!isKnown) {
        emit startRequested(figure4(m_setup->scenario()), true);
        return;
    }
    m_comparesThen = true;
    compareIfWanted({});
}

void StudyPanel::compareIfWanted(const QString& failure)
{
    if (!std::exchange(m_comparesThen, false) || !failure.isEmpty() || !m_runner.isComplete())
        return;
    const StudyResult& result = *m_runner.result();
    if (const std::optional<Figure5> figure = figure5(result.summary)) {
        const Scenario& scenario = result.study.spec.scenarios.front();
        emit comparisonRequested(scenario, plannerOf(scenario, figure->best),
                                 plannerOf(scenario, figure->tsp));
    }
}

} // namespace berg
