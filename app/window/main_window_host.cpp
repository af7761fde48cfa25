#include "app/window/main_window_host.h"

#include "app/dialogs/interaction.h"
#include "widgets/flight/sigma_end.h"
#include "widgets/theme/declination.h"
#include "widgets/theme/language.h"
#include "widgets/theme/unit_settings.h"

#include <QTimer>

#include <chrono>

namespace berg {

MainWindowHost::MainWindowHost(Workspace& workspace, Interaction& interaction, QSettings& settings)
    : m_workspace(workspace), m_interaction(interaction), m_settings(settings)
{
    make();
}

MainWindowHost::~MainWindowHost() = default;

void MainWindowHost::make()
{
    setShownUnits(readUnits(m_settings));
    setTypedDeclination(readDeclination_deg(m_settings));
    chooseSigmaEnd(readSigmaEnd_m2(m_settings));
    m_window = std::make_unique<MainWindow>(m_workspace, m_interaction, m_settings);
    connect(
        m_window.get(), &MainWindow::languageChosen, this,
        [this](const std::optional<QString>& language) {
            remake([language] { installLanguage(language); });
        },
        Qt::QueuedConnection);
    connect(
        m_window.get(), &MainWindow::unitsChosen, this, [this] { remake([] {}); },
        Qt::QueuedConnection);
}

/** Makes a window after a change of what all its texts depend on. */
void MainWindowHost::remake(const std::function<void()>& change)
{
    constexpr auto kSoon = std::chrono::milliseconds(50);
    if (m_interaction.isAwaited) {
        QTimer::singleShot(kSoon, this, [this, change] { remake(change); });
        return;
    }
    const QByteArray geometry = m_window->saveGeometry();
    const QByteArray state = m_window->saveState();
    const std::unique_ptr<MainWindow> old = std::move(m_window);
    change();
    make();
    m_window->restoreGeometry(geometry);
    m_window->restoreState(state);
    // Hidden, because a widget that appears lays out a visible window at once, and Qt 6.4 crashes
    // if the docks of a maximised one are still being restored.
    m_window->takeOver(*old);
    if (old->isVisible()) // else it has been closed since the change was asked for
        m_window->show();
    m_window->showAs(*old);
}

} // namespace berg
