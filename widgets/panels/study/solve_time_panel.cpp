#include "widgets/panels/study/solve_time_panel.h"

#include "widgets/charts/solve_time_chart.h"
#include "widgets/panels/fields/number_field.h"
#include "widgets/panels/fields/panel_labels.h"
#include "widgets/theme/quantity_text.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include <algorithm>
#include <array>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr std::array kSizes{2, 6, 10, 12, 16, 20, 25, 30, 40, 50, 60, 80, 100};
constexpr int kMargin_px = 10;
constexpr int kGap_px = 10;
constexpr int kBarSteps = 1000;
constexpr int kBar_px = 6;
constexpr double kLargest = 40;
constexpr double kRepeat = 5;
constexpr double kBudget_s = 30;
constexpr int kDot_px = 10; ///< coloured dot of a line beside its name

QIcon lineIcon(const BenchmarkSolver& solver, const Theme& theme)
{
    QPixmap pixmap(kDot_px, kDot_px);
    pixmap.fill(benchmarkSolverColour(solver, theme));
    QIcon icon(pixmap);
    icon.addPixmap(pixmap, QIcon::Disabled);
    return icon;
}

QString solverToolTip(const BenchmarkSolver& solver)
{
    switch (solver.backend) {
    case Backend::Auto:
        return {};
    case Backend::Exact:
        return SolveTimePanel::tr(
            "Proves the optimum by dynamic programming or by the bound of Bergwatch's engine.");
    case Backend::Heuristic:
        return SolveTimePanel::tr("Searches, and proves as much as about a second of work allows.");
    case Backend::Cbc:
        break;
    }
    switch (solver.formulation) {
    case Formulation::Position:
        return SolveTimePanel::tr("COIN-OR CBC on a MILP with a variable for each leg and "
                                  "position. Independent of Bergwatch's engine.");
    case Formulation::Printed:
        return SolveTimePanel::tr("COIN-OR CBC on the MILP as the paper prints it. Slow beyond 8 "
                                  "icebergs.");
    case Formulation::Reduced:
        return SolveTimePanel::tr(
            "COIN-OR CBC on the few legs that the bound of Bergwatch's engine leaves.");
    }
    return {};
}

} // namespace

SolveTimePanel::SolveTimePanel(BenchmarkRunner& runner, QWidget* parent)
    : QWidget(parent), m_runner(runner)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kMargin_px, kMargin_px, kMargin_px, kMargin_px);
    column->setSpacing(kGap_px);
    addInputs();
    m_chart = new SolveTimeChart(Theme::light());
    m_chart->setObjectName(u"solveTimeChart"_s);
    column->addWidget(m_chart, 1);
    addRun();

    constexpr int kSecond_ms = 1000;
    m_second.setInterval(kSecond_ms);
    connect(&m_second, &QTimer::timeout, this, &SolveTimePanel::showTimeLeft);
    connect(m_start, &QPushButton::clicked, this, &SolveTimePanel::startOrCancel);
    connect(m_save, &QPushButton::clicked, this, &SolveTimePanel::saveRequested);
    connect(&m_runner, &BenchmarkRunner::progress, this, &SolveTimePanel::showProgress);
    connect(&m_runner, &BenchmarkRunner::updated, this, &SolveTimePanel::showRows);
    connect(&m_runner, &BenchmarkRunner::finished, this, &SolveTimePanel::showEnd);
    setTheme(Theme::light());
    showRows();
    if (m_runner.isRunning()) // started by another window
        m_second.start();
}

void SolveTimePanel::addInputs()
{
    auto* row = new QHBoxLayout;
    row->setSpacing(kGap_px);
    qobject_cast<QVBoxLayout*>(layout())->addLayout(row);
    const auto number = [row](const QString& name, const QString& label, double low, double high,
                              double value, const QString& unit) {
        auto* field = new NumberField;
        field->setObjectName(name);
        field->setAccessibleName(label);
        field->setRange(low, high);
        field->setNumberFormat({}, unit);
        field->showValue(value);
        auto* caption = new CaptionLabel(label);
        caption->setWordWrap(false);
        caption->setBuddy(field);
        auto* pair = new QVBoxLayout;
        pair->setSpacing(1);
        pair->addWidget(caption);
        pair->addWidget(withRemark(field));
        row->addLayout(pair);
        return field;
    };
    m_largest = number(u"largestSize"_s, tr("Icebergs, up to"), kSizes.front(), kSizes.back(),
                       kLargest, {});
    m_largest->setToolTip(tr("Largest number of icebergs. The paper went to 20."));
    m_repeat = number(u"repeat"_s, tr("Problems of each size"), 1, 100, kRepeat, {});
    m_repeat->setToolTip(tr("Random problems as in Table 1 of the paper, the same at every run."));
    m_budget = number(u"budget"_s, tr("Total time limit"), 1, 3600, kBudget_s, u" s"_s);
    m_budget->setToolTip(tr("A solver that does not finish a size skips the larger ones."));
    row->addStretch();

    auto* solvers = new QHBoxLayout;
    solvers->setSpacing(kGap_px);
    for (const BenchmarkSolver& solver : benchmarkSolvers()) {
        auto* box = new QCheckBox(benchmarkSolverName(solver));
        box->setObjectName(QString::fromStdString(nameOf(kBenchmarkSolverNames, solver)));
        box->setChecked(solver.formulation != Formulation::Printed);
        box->setToolTip(solverToolTip(solver));
        connect(box, &QCheckBox::toggled, this, &SolveTimePanel::updateEnabled);
        solvers->addWidget(box);
        m_solvers.emplace_back(solver, box);
    }
    solvers->addStretch();
    qobject_cast<QVBoxLayout*>(layout())->addLayout(solvers);
}

void SolveTimePanel::addRun()
{
    auto* row = new QHBoxLayout;
    row->setSpacing(kGap_px);
    m_start = new QPushButton;
    m_start->setObjectName(u"startBenchmark"_s);
    m_state = new QLabel;
    m_state->setObjectName(u"benchmarkState"_s);
    m_state->setWordWrap(true);
    m_bar = new QProgressBar;
    m_bar->setObjectName(u"benchmarkProgress"_s);
    m_bar->setAccessibleName(tr("Progress of the measurement"));
    m_bar->setRange(0, kBarSteps);
    m_bar->setTextVisible(false);
    m_bar->setFixedHeight(kBar_px);
    m_save = new QPushButton(tr("Save CSV…"));
    m_save->setObjectName(u"saveBenchmark"_s);
    m_save->setToolTip(tr("Saves the measured times as a table."));
    auto* middle = new QVBoxLayout;
    middle->setSpacing(3);
    middle->addWidget(m_state);
    middle->addWidget(m_bar);
    row->addWidget(m_start);
    row->addLayout(middle, 1);
    row->addWidget(m_save);
    qobject_cast<QVBoxLayout*>(layout())->addLayout(row);
}

void SolveTimePanel::setTheme(const Theme& theme)
{
    setCaptionTheme(*this, theme);
    m_chart->setTheme(theme);
    for (const auto& [solver, box] : m_solvers) {
        box->setIcon(lineIcon(solver, theme));
        box->setIconSize({kDot_px, kDot_px});
    }
    m_state->setFont(theme.small());
    QPalette colours = m_bar->palette();
    colours.setColor(QPalette::Highlight, theme.plan);
    m_bar->setPalette(colours);
}

BenchmarkSpec SolveTimePanel::spec() const
{
    BenchmarkSpec spec{.repeat = static_cast<int>(m_repeat->value()),
                       .budget_s = m_budget->value()};
    const int largest = static_cast<int>(m_largest->value());
    for (const int size : kSizes)
        if (size < largest)
            spec.sizes.push_back(size);
    spec.sizes.push_back(largest);
    for (const auto& [solver, box] : m_solvers)
        if (box->isChecked())
            spec.solvers.push_back(solver);
    return spec;
}

void SolveTimePanel::showSpec(const BenchmarkSpec& spec)
{
    m_largest->showValue(*std::max_element(spec.sizes.begin(), spec.sizes.end()));
    m_repeat->showValue(spec.repeat);
    m_budget->showValue(spec.budget_s);
    for (const auto& [solver, box] : m_solvers)
        box->setChecked(std::find(spec.solvers.begin(), spec.solvers.end(), solver) !=
                        spec.solvers.end());
    showTimeLeft();
}

void SolveTimePanel::startOrCancel()
{
    m_cancelled = m_runner.isRunning();
    if (m_cancelled) {
        m_runner.cancel();
        m_start->setEnabled(false); // until the measurement has ended
        return;
    }
    emit startRequested();
}

void SolveTimePanel::start()
{
    m_done = 0;
    m_bar->setValue(0);
    m_second.start();
    m_runner.start(spec());
    showTimeLeft();
}

void SolveTimePanel::showProgress(qulonglong done, qulonglong count)
{
    m_done = count > 0 ? static_cast<double>(done) / static_cast<double>(count) : 0;
    m_bar->setValue(static_cast<int>(m_done * kBarSteps));
    showTimeLeft();
}

void SolveTimePanel::showTimeLeft()
{
    if (!m_runner.isRunning())
        return;
    // At most what the budget leaves, less if the sizes so far were fast.
    const double elapsed_s = m_runner.elapsed_s();
    const double budget_s = std::max(0.0, m_budget->value() - elapsed_s);
    const double left_s =
        m_done > 0 ? std::min(budget_s, elapsed_s * (1 - m_done) / m_done) : budget_s;
    m_state->setText(tr("Measuring, about %1 left").arg(clockText(std::max(left_s, 0.0))));
}

void SolveTimePanel::showRows()
{
    m_chart->setRows(m_runner.rows());
    updateEnabled();
    if (!m_runner.isRunning() && m_runner.rows().empty())
        m_state->setText(tr("Start measures this machine on the problems of the paper, for "
                            "comparison with the paper's times."));
}

void SolveTimePanel::showEnd(const QString& failure)
{
    m_second.stop();
    m_start->setEnabled(true);
    updateEnabled();
    m_bar->setValue(failure.isEmpty() && !m_cancelled ? kBarSteps : m_bar->value());
    if (!failure.isEmpty())
        m_state->setText(failure);
    else if (m_cancelled)
        m_state->setText(tr("Stopped. The times measured so far are kept."));
    else
        m_state->setText(tr("Measured in %1.").arg(clockText(m_runner.elapsed_s())));
    m_cancelled = false;
}

void SolveTimePanel::updateEnabled()
{
    const bool running = m_runner.isRunning();
    for (NumberField* field : {m_largest, m_repeat, m_budget})
        field->setEnabled(!running);
    for (const auto& [solver, box] : m_solvers)
        box->setEnabled(!running);
    const bool any = std::any_of(m_solvers.begin(), m_solvers.end(),
                                 [](const auto& one) { return one.second->isChecked(); });
    m_start->setText(running ? tr("Stop") : tr("Start"));
    m_start->setToolTip(any ? QString() : tr("Choose a solver first."));
    m_start->setEnabled((running && !m_cancelled) || (!running && any));
    m_save->setEnabled(!running && !m_runner.rows().empty());
}

} // namespace berg
