#include "app/window/window_part.h"

#include <QMainWindow>
#include <QStatusBar>

namespace berg {

QLocale WindowPart::locale() const
{
    return window().locale();
}

void WindowPart::showMessage(const QString& text, int duration_ms) const
{
    window().statusBar()->showMessage(text, duration_ms);
}

} // namespace berg
