#include "app/dialogs/screen_fit.h"

#include <QScreen>
#include <QWidget>

namespace berg {

namespace {

constexpr QSize kFrame_px(0, 40); ///< title of a window, at least

} // namespace

bool fitsScreen(const QSize& window_px, const QSize& available_px)
{
    const QSize whole_px = window_px + kFrame_px;
    return whole_px.width() <= available_px.width() && whole_px.height() <= available_px.height();
}

QSize boundedDialog(const QSize& size_px, const QSize& least_px, const QSize& available_px)
{
    return size_px.expandedTo(least_px).boundedTo(available_px - kFrame_px);
}

void boundToScreen(QWidget& dialog)
{
    const QSize available_px = dialog.screen()->availableSize();
    const QSize least_px = dialog.minimumSizeHint();
    if (!fitsScreen(least_px, available_px))
        dialog.setMinimumSize(boundedDialog({}, least_px, available_px));
    dialog.resize(boundedDialog(dialog.size(), least_px, available_px));
}

void keepOnScreen(QWidget& window)
{
    const QSize available_px = window.screen()->availableSize();
    const bool isWhole = window.windowState() & (Qt::WindowMaximized | Qt::WindowFullScreen);
    if (isWhole || fitsScreen(window.size(), available_px))
        return;
    window.resize(window.size().boundedTo(available_px - kFrame_px)); // once it is not maximized
    window.setWindowState(Qt::WindowMaximized);
}

} // namespace berg
