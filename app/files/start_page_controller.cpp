#include "app/files/start_page_controller.h"

#include "app/files/scenario_files.h"
#include "app/layout/docks.h"
#include "app/layout/panels.h"
#include "app/start/start_page.h"
#include "app/start/tour.h"
#include "core/presets/presets.h"
#include "widgets/map/view/map_view.h"
#include "widgets/panels/flight/playback_bar.h"
#include "widgets/workspace/workspace.h"

#include <QAction>
#include <QDockWidget>
#include <QFileInfo>
#include <QMainWindow>
#include <QMenuBar>
#include <QSettings>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

constexpr const char* kShowAtStartKey = "start/show"; ///< on by default
constexpr const char* kTourSeenKey = "start/tourSeen";

} // namespace

StartPageController::StartPageController(WindowContext& context, ScenarioFiles& files,
                                         const Docks& docks)
    : WindowPart(context), m_files(files), m_docks(docks)
{
}

bool StartPageController::wantsStartPage(const QSettings& settings)
{
    return settings.value(kShowAtStartKey, true).toBool();
}

void StartPageController::showPage()
{
    if (m_page != nullptr)
        return;
    const QString file = fileToContinue();
    const QString name = file.isEmpty()
                             ? QString::fromStdString(workspace().document().scenario().name)
                             : QFileInfo(file).fileName();
    m_page = new StartPage(name.isEmpty() ? tr("Untitled") : name, wantsStartPage(settings()),
                           !settings().value(kTourSeenKey, false).toBool(), &window());
    m_page->setTheme(theme());
    m_page->setRecent(m_files.recent());
    const QMenuBar& menus = *window().menuBar();
    m_page->setTop(menus.isVisible() ? menus.geometry().bottom() + 1 : 0);
    connectPage(*m_page);
    m_page->show();
}

/** Returns the last recent file if the program still has its initial scenario; else an empty path.
 */
QString StartPageController::fileToContinue() const
{
    const ScenarioDocument& document = workspace().document();
    if (!document.isClean() || !document.filePath().isEmpty() || workspace().inFlight() ||
        !(document.scenario() == defaultScenario()))
        return {};
    const QStringList files = m_files.recent();
    const auto file = std::find_if(files.begin(), files.end(),
                                   [](const QString& path) { return QFileInfo::exists(path); });
    return file == files.end() ? QString() : *file;
}

void StartPageController::connectPage(StartPage& page)
{
    const auto proceed = [this] {
        closePage();
        if (!settings().value(kTourSeenKey, false).toBool())
            startTour();
    };
    connect(&page, &StartPage::dismissed, this, proceed);
    connect(&page, &StartPage::continueRequested, this, [this, proceed] {
        const QString file = fileToContinue();
        if (file.isEmpty() || m_files.openFile(file))
            proceed();
    });
    connect(&page, &StartPage::newRequested, this, &StartPageController::newRequested);
    connect(&page, &StartPage::openRequested, &m_files, &ScenarioFiles::openScenario);
    connect(&page, &StartPage::importRequested, this, &StartPageController::importRequested);
    connect(&page, &StartPage::tourRequested, this, &StartPageController::startTour);
    connect(&page, &StartPage::fileChosen, &m_files, &ScenarioFiles::openFile);
    connect(&page, &StartPage::exampleChosen, &m_files, &ScenarioFiles::openExample);
    connect(&page, &StartPage::removeRequested, this, [this](const QString& path) {
        m_files.forget(path);
        m_page->setRecent(m_files.recent());
    });
    connect(&page, &StartPage::showAtStartEdited, this,
            [this](bool show) { settings().setValue(kShowAtStartKey, show); });
    // Whatever is opened, or flown, from the menus is to be seen.
    connect(&workspace().document(), &ScenarioDocument::replaced, &page, [this] { closePage(); });
    connect(&workspace(), &Workspace::inFlightChanged, &page, [this] { closePage(); });
}

void StartPageController::closePage()
{
    if (m_page == nullptr)
        return;
    m_page->hide();
    m_page->deleteLater();
    m_page = nullptr;
    panels().map->setFocus();
}

void StartPageController::startTour()
{
    closePage();
    if (m_tour != nullptr)
        return;
    settings().setValue(kTourSeenKey, true);
    m_docks.raise(Dock::Tradeoff);
    QDockWidget* tradeoff = m_docks.dock(Dock::Tradeoff);
    m_tour = new Tour({{panels().map, tr("1. Place icebergs"),
                        tr("After this tour, press I and click on the map to place an iceberg. "
                           "Drag it to move it, double-click it to set its drift and the "
                           "uncertainty of its position. The plan follows at once.")},
                       {tradeoff, tr("2. Drag τ"),
                        tr("Drag left to visit the most uncertain icebergs first, right for a "
                           "shorter route. Ticks mark where another order becomes optimal.")},
                       {panels().playback, tr("3. Press Space"),
                        tr("Press Space to fly and to pause. Drag the time line to look back. Stop "
                           "and edit returns to the start."),
                        true}},
                      theme(), &window());
    connect(m_tour, &Tour::finished, this, [this] {
        m_tour->hide();
        m_tour->deleteLater();
        m_tour = nullptr;
        panels().map->setFocus();
    });
    connect(m_tour, &Tour::flightRequested, this,
            [this] { window().findChild<QAction*>(u"playAction"_s)->trigger(); });
}

void StartPageController::setTheme(const Theme& theme)
{
    if (m_page != nullptr)
        m_page->setTheme(theme);
    if (m_tour != nullptr)
        m_tour->setTheme(theme);
}

} // namespace berg
