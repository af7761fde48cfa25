#pragma once

#include "app/window/main_window.h"

#include <QObject>

#include <functional>
#include <memory>

namespace berg {

/** Holds the window, which is made anew for each language and choice of units; what it works on
 * stays. GUI thread. */
class MainWindowHost : public QObject
{
    Q_OBJECT

public:
    /** All are borrowed and must outlive the holder. */
    MainWindowHost(Workspace& workspace, Interaction& interaction, QSettings& settings);
    ~MainWindowHost() override;

    /** The present one: another after each change of language or units. */
    [[nodiscard]] MainWindow& window() { return *m_window; }

private:
    void make();
    void remake(const std::function<void()>& change);

    Workspace& m_workspace;
    Interaction& m_interaction;
    QSettings& m_settings;
    std::unique_ptr<MainWindow> m_window;
};

} // namespace berg
