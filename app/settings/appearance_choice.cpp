#include "app/settings/appearance_choice.h"

#include "widgets/theme/contrast_style.h"
#include "widgets/theme/palette.h"

#include <QApplication>
#include <QEvent>
#include <QMainWindow>
#include <QSettings>

using namespace Qt::StringLiterals;

namespace berg {

AppearanceChoice::AppearanceChoice(WindowContext& context) : WindowPart(context)
{
    connect(&m_system, &SystemAppearance::changed, this, &AppearanceChoice::followSystem);
    window().installEventFilter(this);
    if (qobject_cast<ContrastStyle*>(QApplication::style()) == nullptr)
        QApplication::setStyle(new ContrastStyle); // the application's
}

/** The desktop has changed its colours, e.g. at sunset. */
bool AppearanceChoice::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::ThemeChange)
        followSystem();
    return WindowPart::eventFilter(watched, event);
}

void AppearanceChoice::setAppearance(Appearance appearance)
{
    settings().setValue("view/appearance", static_cast<int>(appearance));
    m_appearance = appearance;
    switch (appearance) {
    case Appearance::System:
        return followSystem();
    case Appearance::Light:
        break;
    case Appearance::Dark:
        return applyTheme(Theme::dark());
    case Appearance::HighContrastLight:
        return applyTheme(Theme::highContrast(false));
    case Appearance::HighContrastDark:
        return applyTheme(Theme::highContrast(true));
    case Appearance::Night:
        return applyTheme(Theme::night());
    }
    applyTheme(Theme::light());
}

void AppearanceChoice::followSystem()
{
    if (m_appearance == Appearance::System)
        applyTheme(m_system.wantsContrast() ? Theme::highContrast(m_system.isDark())
                   : m_system.isDark()      ? Theme::dark()
                                            : Theme::light());
}

void AppearanceChoice::applyTheme(const Theme& theme)
{
    context().theme = theme;
    QApplication::setPalette(paletteOf(theme));
    emit themeChanged(theme);
}

} // namespace berg
