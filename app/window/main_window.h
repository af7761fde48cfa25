#pragma once

#include "app/layout/panels.h"
#include "app/layout/window_part.h"

#include <QMainWindow>

#include <memory>
#include <optional>

namespace berg {

struct WindowParts;

/**
 * The window: menus, tool bar, map in the middle, panels round it. Composition only: each part owns
 * its state; what is shown is in the workspace, which outlives the window.
 */
class MainWindow : public QMainWindow
{
    Q_OBJECT

public:
    MainWindow(Workspace& workspace, Interaction& interaction, QSettings& settings);
    ~MainWindow() override;

    [[nodiscard]] WindowParts& parts() { return *m_parts; }
    /** Carries on in place of another window of the same workspace: what that one shows and awaits,
     * and what was last chosen in it. */
    void takeOver(MainWindow& other);
    /** Shows the same part of the map, and the start page, as `other`; after this is laid out. */
    void showAs(MainWindow& other);
    [[nodiscard]] MapView& mapView() const { return *m_panels.map; }
    /** Waits until all the land last painted can be painted: for pictures. */
    void finishLand() const;

signals:
    /** Emitted when another language was chosen; the owner makes a new window. */
    void languageChosen(const std::optional<QString>& language);
    /** Other units were chosen, and are in the settings: as another language. */
    void unitsChosen();

protected:
    void changeEvent(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool focusNextPrevChild(bool next) override;

private:
    void showTheme(const Theme& theme);
    void showTitle();

    Panels m_panels;
    WindowContext m_context;
    std::unique_ptr<WindowParts> m_parts;
};

} // namespace berg
