#pragma once

#include "app/layout/window_part.h"

namespace berg {

class Docks;
class ScenarioFiles;
class StartPage;
class Tour;

/** The start page, which covers everything except the menus, and the tour. */
class StartPageController : public WindowPart
{
    Q_OBJECT

public:
    StartPageController(WindowContext& context, ScenarioFiles& files, const Docks& docks);

    /** Whether the user wants it when no file is named. */
    [[nodiscard]] static bool wantsStartPage(const QSettings& settings);

    /** Opening anything closes it. */
    void showPage();
    [[nodiscard]] bool pageIsShown() const { return m_page != nullptr; }
    void closePage();
    void startTour();
    void setTheme(const Theme& theme);

signals:
    void importRequested();
    void newRequested();

private:
    void connectPage(StartPage& page);
    [[nodiscard]] QString fileToContinue() const;

    ScenarioFiles& m_files;
    const Docks& m_docks;
    StartPage* m_page = nullptr; ///< while it is shown
    Tour* m_tour = nullptr;      ///< while it goes on
};

} // namespace berg
