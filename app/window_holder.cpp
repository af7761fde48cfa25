#include "app/window_holder.h"

#include "app/window_run.h"
#include "widgets/map/map_view.h"
#include "widgets/panels/playback_bar.h"

namespace berg {

WindowHolder::WindowHolder(Workspace& workspace, Interaction& interaction, QSettings& settings)
    : m_workspace(workspace), m_interaction(interaction), m_settings(settings)
{
    make();
}

WindowHolder::~WindowHolder() = default;

void WindowHolder::make()
{
    m_window = std::make_unique<MainWindow>(m_workspace, m_interaction, m_settings);
    connect(
        m_window.get(), &MainWindow::languageChosen, this,
        [this](const QString& language) { change(language); }, Qt::QueuedConnection);
}

void WindowHolder::change(const QString& language)
{
    const QByteArray geometry = m_window->saveGeometry();
    const QByteArray state = m_window->saveState();
    const std::unique_ptr<MainWindow> old = std::move(m_window);
    installLanguage(language);
    make();
    m_window->restoreGeometry(geometry);
    m_window->restoreState(state);
    m_window->show();
    m_window->mapView().showAs(old->mapView());
    m_window->findChild<PlaybackBar*>()->setRate(old->findChild<PlaybackBar*>()->rate());
}

} // namespace berg
