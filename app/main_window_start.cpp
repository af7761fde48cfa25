#include "app/main_window.h"
#include "app/start_page.h"
#include "app/tour.h"
#include "core/scenario/presets.h"
#include "widgets/map/map_view.h"
#include "widgets/model/error_text.h"
#include "widgets/panels/flight/playback_bar.h"
#include "widgets/panels/plan/tradeoff_panel.h"

#include <QDockWidget>
#include <QFileInfo>
#include <QMenuBar>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {

bool MainWindow::wantsStartPage(const QSettings& settings)
{
    return settings.value(kShowAtStartKey, true).toBool();
}

void MainWindow::showStartPage()
{
    if (m_startPage != nullptr)
        return;
    const QString file = fileToContinue();
    const QString name = file.isEmpty()
                             ? QString::fromStdString(m_workspace.document().scenario().name)
                             : QFileInfo(file).fileName();
    m_startPage = new StartPage(name.isEmpty() ? tr("Untitled") : name, wantsStartPage(m_settings),
                                !m_settings.value(kTourSeenKey, false).toBool(), this);
    m_startPage->setTheme(m_theme);
    m_startPage->setRecent(m_settings.value(kRecentFilesKey).toStringList());
    m_startPage->setTop(menuBar()->isVisible() ? menuBar()->geometry().bottom() + 1 : 0);
    connectStartPage(*m_startPage);
    m_startPage->show();
}

/** The last one, as long as there is only what the program begins with; empty: what is there. */
QString MainWindow::fileToContinue() const
{
    const ScenarioDocument& document = m_workspace.document();
    if (!document.isClean() || !document.filePath().isEmpty() || m_workspace.inFlight() ||
        !(document.scenario() == defaultScenario()))
        return {};
    const QStringList files = m_settings.value(kRecentFilesKey).toStringList();
    const auto file = std::find_if(files.begin(), files.end(),
                                   [](const QString& path) { return QFileInfo::exists(path); });
    return file == files.end() ? QString() : *file;
}

void MainWindow::connectStartPage(StartPage& page)
{
    const auto goOn = [this] {
        closeStartPage();
        if (!m_settings.value(kTourSeenKey, false).toBool())
            startTour();
    };
    connect(&page, &StartPage::dismissed, this, goOn);
    connect(&page, &StartPage::continueRequested, this, [this, goOn] {
        const QString file = fileToContinue();
        if (file.isEmpty() || openFile(file))
            goOn();
    });
    connect(&page, &StartPage::newRequested, this, &MainWindow::newScenario);
    connect(&page, &StartPage::openRequested, this, &MainWindow::openScenario);
    connect(&page, &StartPage::importRequested, this, &MainWindow::chooseSightings);
    connect(&page, &StartPage::tourRequested, this, &MainWindow::startTour);
    connect(&page, &StartPage::fileChosen, this, &MainWindow::openFile);
    connect(&page, &StartPage::exampleChosen, this, &MainWindow::openExample);
    connect(&page, &StartPage::removeRequested, this, [this](const QString& path) {
        QStringList files = m_settings.value(kRecentFilesKey).toStringList();
        files.removeAll(path);
        m_settings.setValue(kRecentFilesKey, files);
        m_startPage->setRecent(files);
    });
    connect(&page, &StartPage::showAtStartEdited, this,
            [this](bool show) { m_settings.setValue(kShowAtStartKey, show); });
    // Whatever is opened, or flown, from the menus is to be seen.
    connect(&m_workspace.document(), &ScenarioDocument::replaced, &page,
            [this] { closeStartPage(); });
    connect(&m_workspace, &Workspace::inFlightChanged, &page, [this] { closeStartPage(); });
}

void MainWindow::closeStartPage()
{
    if (m_startPage == nullptr)
        return;
    m_startPage->hide();
    m_startPage->deleteLater();
    m_startPage = nullptr;
    m_map->setFocus();
}

void MainWindow::openExample(const QString& path)
{
    if (!mayLeaveScene(Interaction::FlightEnd::Other))
        return;
    try {
        m_workspace.document().reset(loadExample(path));
    } catch (const Error& error) {
        m_interaction.showError(this, errorReport(error));
    }
}

void MainWindow::startTour()
{
    closeStartPage();
    if (m_tour != nullptr)
        return;
    m_settings.setValue(kTourSeenKey, true);
    auto* tradeoff = findChild<QDockWidget*>(u"tradeoffDock"_s);
    tradeoff->show();
    tradeoff->raise();
    m_tour = new Tour(
        {{m_map, tr("1. Place icebergs"),
          tr("Press I and click on the map: an iceberg. Drag it to move it, double-click it to "
             "set its drift and how uncertain its place is. The plan follows at once.")},
         {tradeoff, tr("2. Drag τ"),
          tr("To the left the most uncertain icebergs come first, to the right the route gets "
             "shorter. Ticks mark where another order becomes the best one.")},
         {m_playback, tr("3. Press Space"),
          tr("Space flies the plan and pauses it; drag along the time line to look back. Stop and "
             "edit goes back to the start.")}},
        m_theme, this);
    connect(m_tour, &Tour::finished, this, [this] {
        m_tour->hide();
        m_tour->deleteLater();
        m_tour = nullptr;
        m_map->setFocus();
    });
}

} // namespace berg
