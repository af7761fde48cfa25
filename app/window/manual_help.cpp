#include "app/window/manual_help.h"

#include "widgets/manual/manual_places.h"
#include "widgets/manual/manual_window.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMainWindow>

using namespace Qt::StringLiterals;

namespace berg {

ManualHelp::ManualHelp(WindowContext& context) : WindowPart(context)
{
    qApp->installEventFilter(this);
}

void ManualHelp::open()
{
    const QWidget* focus = QApplication::focusWidget();
    if (focus != nullptr && m_manual != nullptr && focus->window() == m_manual)
        return; // one is reading it
    // While a dialog is open only its own children can be used.
    QWidget* dialog = QApplication::activeModalWidget();
    QWidget* parent = dialog != nullptr ? dialog : &window();
    if (dialog != nullptr && (focus == nullptr || focus->window() != dialog))
        focus = dialog;
    if (m_manual == nullptr || m_manual->parentWidget() != parent) {
        delete m_manual;
        m_manual = new ManualWindow(parent);
        m_manual->setAttribute(Qt::WA_QuitOnClose, false);
    }
    m_manual->showPlace(manualPlaceOf(focus));
    m_manual->show();
    m_manual->raise();
    m_manual->activateWindow();
}

/** Handles F1 in dialogs and floating panels, which the menu's action does not receive. */
bool ManualHelp::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::KeyPress && watched->isWidgetType()) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        if (key.key() == Qt::Key_F1 && key.modifiers() == Qt::NoModifier) {
            open();
            return true;
        }
    }
    return WindowPart::eventFilter(watched, event);
}

} // namespace berg
