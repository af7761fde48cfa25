#include "app/window/screen_fit.h"

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
