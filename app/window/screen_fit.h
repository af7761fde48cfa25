#pragma once

#include <QSize>

class QWidget;

namespace berg {

/** Whether a window of this size, with its frame, is within what a screen has to offer. */
[[nodiscard]] bool fitsScreen(const QSize& window_px, const QSize& available_px);

/**
 * Lets a window that is larger than its screen take all of it. What was left may be of another
 * screen or of smaller text. To be called before the window is shown.
 */
void keepOnScreen(QWidget& window);

} // namespace berg
