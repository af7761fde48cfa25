// Studies: the dock, its files, and the way from a study to flights on the map.

#include "app/file_names.h"
#include "app/main_window.h"
#include "core/io/results/result_json.h"
#include "core/io/study/study_json.h"
#include "core/io/text/atomic_file.h"
#include "core/study/paper_figures.h"
#include "widgets/model/error_text.h"
#include "widgets/panels/flight/chart_panel.h"
#include "widgets/panels/study/solve_time_panel.h"
#include "widgets/panels/study/study_panel.h"
#include "widgets/panels/study/study_results.h"

#include <QDockWidget>
#include <QFile>
#include <QFileInfo>
#include <QScreen>
#include <QStatusBar>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

constexpr int kMessage_ms = 8000;
constexpr QSize kStudyFrame_px(24, 48); ///< title and edges of the window of a study

QString studyFilter()
{
    return MainWindow::tr("Studies (*.bergstudy);;All files (*)");
}

/** The run of the world flown with these settings from start to end. */
std::optional<std::size_t> findRun(const RunList& list, const Scenario& world,
                                   const PlannerSettings& planner)
{
    const std::vector<RunPointer>& runs = list.runs();
    const auto found = std::find_if(runs.rbegin(), runs.rend(), [&](const RunPointer& run) {
        return !run->wasChanged && run->flown_s >= world.duration_s && run->worldChanges.empty() &&
               isSamePlanner(run->scenario.planner, planner) && isSameWorld(run->scenario, world);
    });
    if (found == runs.rend())
        return std::nullopt;
    return static_cast<std::size_t>(runs.rend() - found) - 1;
}

} // namespace

bool MainWindow::isStudyFile(const QString& path)
{
    return QFileInfo(path).suffix().toLower() == u"bergstudy"_s;
}

void MainWindow::connectStudy()
{
    StudyFiles& files = m_workspace.studyFiles();
    connect(m_study, &StudyPanel::startRequested, this,
            [this](const StudySpec& spec, bool compares) {
                replaceStudy([spec, compares](MainWindow& window) {
                    window.m_study->start(spec, compares);
                });
            });
    connect(m_study, &StudyPanel::solveTimesRequested, this, [this] {
        m_solveTime->showSpec(figure3(benchmarkSolvers()));
        openStudyDock(u"solveTimeDock"_s, m_solveTime->sizeHint());
    });
    connect(m_solveTime, &SolveTimePanel::startRequested, this, [this] {
        if (maySettleSolveTimes())
            m_solveTime->start();
    });
    connect(m_solveTime, &SolveTimePanel::saveRequested, this, [this] { saveSolveTimes(); });
    connect(m_study, &StudyPanel::openRunRequested, this, [this](const Scenario& scenario) {
        if (flyOnMap(scenario, tr("Fly as in the study")))
            statusBar()->showMessage(tr("Flown as in the study, which is under View, Study."),
                                     kMessage_ms);
    });
    connect(m_study, &StudyPanel::comparisonRequested, this, &MainWindow::compareFlights);
    connect(&m_workspace.runs(), &RunList::changed, this, &MainWindow::finishComparison);
    connect(m_study, &StudyPanel::openRequested, this, [this] {
        const QString path = m_interaction.openPath(
            this, tr("Studies and their reports (*.bergstudy *.json *.html);;All files (*)"));
        if (!path.isEmpty())
            m_workspace.studyFiles().open(path);
    });
    connect(m_study, &StudyPanel::saveRequested, this, [this] { saveStudy(); });
    connect(m_study, &StudyPanel::reportRequested, this, [this] {
        const QString path = studyPath(u"html"_s, tr("Reports (*.html);;All files (*)"));
        if (!path.isEmpty())
            m_workspace.studyFiles().writeReport(m_workspace.study().result(),
                                                 m_workspace.study().elapsed_s(), path);
    });
    connect(m_study, &StudyPanel::tableRequested, this, [this] {
        const QString path = studyPath(u"csv"_s, tr("Tables (*.csv);;All files (*)"));
        if (!path.isEmpty())
            m_workspace.studyFiles().writeTable(m_workspace.study().result(), path);
    });
    connect(m_study, &StudyPanel::pictureRequested, this, &MainWindow::saveStudyPicture);
    connect(&files, &StudyFiles::opened, this, [this](const std::shared_ptr<const Study>& study) {
        replaceStudy([study](MainWindow& window) {
            window.m_study->showNote({}); // of the one before
            window.m_workspace.study().show(*study);
            window.showStudy();
        });
    });
    connect(&m_workspace.studyKeeper(), &StudyKeeper::found, this,
            [this](const std::shared_ptr<const Study>& study) {
                m_workspace.study().restore(*study);
                showStudy();
                m_study->showNote(tr("Bergwatch ended unexpectedly. This unsaved study was kept. "
                                     "Save it, or fly the rest."));
            });
    connect(&m_workspace.studyKeeper(), &StudyKeeper::damaged, this, &MainWindow::showDamaged);
    connect(&m_workspace.studyKeeper(), &StudyKeeper::failed, this, [this](const QString& report) {
        statusBar()->showMessage(tr("Autosaving failed: %1").arg(report.section(u'\n', 0, 0)),
                                 kMessage_ms);
    });
    connect(&files, &StudyFiles::written, this,
            [this](const QString& path) { m_study->showNote(tr("Saved %1").arg(path)); });
    connect(&files, &StudyFiles::saved, this, [this](const QString& path) {
        m_study->showNote(tr("Saved %1").arg(path));
        if (const AfterStudy then = std::exchange(m_carried.afterStudySaved, {}))
            then(*this);
    });
    connect(&files, &StudyFiles::failed, this, [this](const QString& report) {
        m_carried.afterStudySaved = {};
        m_interaction.showError(this, report);
    });
}

/** Where the user wants it; empty: nowhere. */
QString MainWindow::studyPath(const QString& extension, const QString& filter)
{
    const QString name =
        fileNameOf(QString::fromStdString(m_workspace.study().result()->study.spec.name));
    const QString path = m_interaction.savePath(this, name + u'.' + extension, filter);
    return path.isEmpty() ? path : withExtension(path, extension);
}

bool MainWindow::saveStudy()
{
    const QString path = studyPath(u"bergstudy"_s, studyFilter());
    if (path.isEmpty())
        return false;
    const StudyRunner& study = m_workspace.study();
    m_workspace.studyFiles().save(study.result(), study.savePoint(), path);
    return true;
}

/** When the program has no time left; the window waits. */
bool MainWindow::saveStudyNow()
{
    const QString path = studyPath(u"bergstudy"_s, studyFilter());
    if (path.isEmpty())
        return false;
    StudyRunner& study = m_workspace.study();
    try {
        berg::saveStudy(study.result()->study, QFile::encodeName(path).toStdString());
        study.noteSaved(study.savePoint());
        return true;
    } catch (const Error& error) {
        m_interaction.showError(this, errorReport(error));
        return false;
    }
}

/** Discard as well when there is nothing that would take long to fly again. */
Interaction::Unsaved MainWindow::askAboutStudy()
{
    const StudyRunner& study = m_workspace.study();
    if (!study.result() || !isWorthSaving(study.unsaved_s()))
        return Interaction::Unsaved::Discard;
    const QString name = QString::fromStdString(study.result()->study.spec.name);
    return m_interaction.askUnsaved(this, {.name = tr("Study: %1").arg(name)});
}

/** Work that took so long and is in no file. */
bool MainWindow::isWorthSaving(double unsaved_s) const
{
    return unsaved_s > 0 && unsaved_s >= m_settings.value(kStudyWorthKey, 60).toDouble();
}

/** Asks about what would be lost of the study there is. False: not now; `then` follows once the
 * study is in a file, where the user wants that. */
bool MainWindow::maySettleStudy(AfterStudy then)
{
    switch (askAboutStudy()) {
    case Interaction::Unsaved::Save:
        if (saveStudy())
            m_carried.afterStudySaved = std::move(then);
        return false;
    case Interaction::Unsaved::Discard:
        return true;
    case Interaction::Unsaved::Cancel:
        return false;
    }
    return false;
}

void MainWindow::replaceStudy(const AfterStudy& replace)
{
    if (maySettleStudy(replace))
        replace(*this);
}

/** Asks about what would be lost of the measured times. False: not now. */
bool MainWindow::maySettleSolveTimes()
{
    if (!isWorthSaving(m_workspace.benchmark().unsaved_s()))
        return true;
    switch (m_interaction.askUnsaved(this, {.name = tr("Solve time")})) {
    case Interaction::Unsaved::Save:
        return saveSolveTimes();
    case Interaction::Unsaved::Discard:
        return true;
    case Interaction::Unsaved::Cancel:
        return false;
    }
    return false;
}

bool MainWindow::saveSolveTimes()
{
    const QString chosen =
        m_interaction.savePath(this, u"solve-time.csv"_s, tr("Tables (*.csv);;All files (*)"));
    if (chosen.isEmpty())
        return false;
    const QString path = withExtension(chosen, u"csv"_s);
    BenchmarkRunner& benchmark = m_workspace.benchmark();
    try {
        writeFileAtomically(QFile::encodeName(path).toStdString(), benchmarkCsv(benchmark.rows()));
    } catch (const Error& error) {
        m_interaction.showError(this, errorReport(error));
        return false;
    }
    benchmark.noteSaved();
    statusBar()->showMessage(tr("Saved %1").arg(path), kMessage_ms);
    return true;
}

void MainWindow::saveStudyPicture()
{
    const QString path = m_interaction.savePath(this, m_study->results().pictureName(),
                                                ChartPanel::pictureFilters().join(u";;"_s));
    if (path.isEmpty())
        return;
    try {
        m_study->results().writePicture(withExtension(path, u"png"_s));
        m_study->showNote(tr("Saved %1").arg(path));
    } catch (const Error& error) {
        m_interaction.showError(this, errorReport(error));
    }
}

/** A study wants more room than the docks have: a window of its own, as long as one wants it. */
void MainWindow::openStudyDock(const QString& name, const QSize& best_px)
{
    auto* dock = findChild<QDockWidget*>(name);
    if (!dock->isVisible()) {
        dock->setFloating(true);
        dock->resize((best_px + kStudyFrame_px).boundedTo(screen()->availableSize()));
        dock->move(geometry().center() - dock->rect().center());
    }
    dock->show();
    dock->raise();
}

void MainWindow::showStudy()
{
    openStudyDock(u"studyDock"_s, m_study->sizeHint());
}

/** False: the user does not want to give up what is unsaved, or the flight under way. */
bool MainWindow::flyOnMap(const Scenario& scenario, const QString& text)
{
    finishTyping();
    constexpr auto kWhy = Interaction::FlightEnd::Other;
    if (!(m_workspace.isVariant(scenario) ? mayEndFlight(kWhy) : mayLeaveScene(kWhy)))
        return false;
    m_workspace.flyScenario(scenario, text);
    if (auto* dock = findChild<QDockWidget*>(u"studyDock"_s); dock->isFloating())
        dock->hide(); // it is over the map
    activateWindow();
    return true;
}

/** Figure 5 of the paper: the one is flown on the map, the other beside it. */
void MainWindow::compareFlights(const Scenario& scenario, const PlannerSettings& best,
                                const PlannerSettings& tsp)
{
    Scenario first = scenario;
    first.planner = best;
    if (!flyOnMap(first, tr("Fly Figure 5 of the paper")))
        return;
    m_carried.compared = ComparedPair{.world = first, .reference = best, .other = tsp};
    m_workspace.runs().addFlown(first, tsp);
    for (const QString& name : {u"comparisonDock"_s, u"comparisonChartDock"_s}) {
        auto* dock = findChild<QDockWidget*>(name);
        dock->show();
        dock->raise();
    }
}

/** Sets the two flights beside each other once both have ended. */
void MainWindow::finishComparison()
{
    if (!m_carried.compared)
        return;
    RunList& runs = m_workspace.runs();
    const std::optional<std::size_t> reference =
        findRun(runs, m_carried.compared->world, m_carried.compared->reference);
    const std::optional<std::size_t> other =
        findRun(runs, m_carried.compared->world, m_carried.compared->other);
    if (!reference || !other)
        return;
    m_carried.compared.reset();
    runs.setReference(*reference);
    runs.setOther(*other);
}

} // namespace berg
