#include "app/layout/window_part.h"

#include "app/dialogs/interaction.h"
#include "app/layout/panels.h"
#include "core/base/error.h"
#include "widgets/panels/flight/message_list.h"
#include "widgets/theme/announcer.h"
#include "widgets/words/error_text.h"

#include <QMainWindow>
#include <QStatusBar>

namespace berg {

namespace {

void tell(const Panels& panels, const QString& text)
{
    panels.messages->add(text);
    panels.announcer->say(text);
}

} // namespace

void showMessage(const WindowContext& context, const QString& text, int duration_ms)
{
    context.window.statusBar()->showMessage(text, duration_ms);
    tell(context.panels, text);
}

QLocale WindowPart::locale() const
{
    return window().locale();
}

QWidget* WindowPart::windowOf(const QWidget& panel) const
{
    return panel.isVisible() ? panel.window() : &window();
}

bool WindowPart::attempt(const std::function<void()>& work) const
{
    try {
        work();
        return true;
    } catch (const Error& error) {
        interaction().showError(&window(), errorReport(error));
        return false;
    }
}

void WindowPart::announce(const QString& text) const
{
    tell(panels(), text);
}

} // namespace berg
