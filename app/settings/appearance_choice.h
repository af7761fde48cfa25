#pragma once

#include "app/layout/window_part.h"
#include "app/settings/system_appearance.h"

namespace berg {

/** Appearance by the user's choice. */
enum class Appearance
{
    System,
    Light,
    Dark,
    HighContrastLight,
    HighContrastDark,
    Night
};

/** Which theme the window has: what the user chose, or what the desktop has. */
class AppearanceChoice : public WindowPart
{
    Q_OBJECT

public:
    explicit AppearanceChoice(WindowContext& context);

    void setAppearance(Appearance appearance);
    /** Applies a theme now; `setAppearance` decides it in daily use. */
    void applyTheme(const Theme& theme);

signals:
    void themeChanged(const berg::Theme& theme);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void followSystem();

    SystemAppearance m_system;
    Appearance m_appearance = Appearance::System;
};

} // namespace berg
