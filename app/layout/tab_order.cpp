#include "app/layout/tab_order.h"

#include <QDockWidget>

namespace berg {
namespace {

/** Tab bars that Qt keeps for later are visible, but beyond the edges of the window. */
bool isInside(const QWidget& widget, const QWidget& window)
{
    return widget.parentWidget() != &window || window.rect().intersects(widget.geometry());
}

bool takesTab(const QWidget& widget, const QWidget& window)
{
    return (widget.focusPolicy() & Qt::TabFocus) != 0 && widget.focusProxy() == nullptr &&
           widget.isEnabled() && widget.window() == &window && widget.isVisibleTo(&window) &&
           isInside(widget, window) && !isBehindATab(widget);
}

} // namespace

bool isBehindATab(const QWidget& widget)
{
    const QWidget* at = &widget;
    while (at != nullptr && qobject_cast<const QDockWidget*>(at) == nullptr)
        at = at->parentWidget();
    return at != nullptr && at->isVisible() && at->visibleRegion().isEmpty();
}

QWidget* nextInSight(const QWidget& window, bool next)
{
    const QWidget* from = window.focusWidget() != nullptr ? window.focusWidget() : &window;
    const auto after = [next](const QWidget* widget) {
        return next ? widget->nextInFocusChain() : widget->previousInFocusChain();
    };
    for (QWidget* to = after(from); to != from; to = after(to))
        if (takesTab(*to, window))
            return to;
    return nullptr;
}

} // namespace berg
