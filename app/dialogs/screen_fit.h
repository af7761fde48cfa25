#pragma once

#include <QSize>

class QWidget;

namespace berg {

/** Returns true if a window of this size, with its frame, fits the screen. */
[[nodiscard]] bool fitsScreen(const QSize& window_px, const QSize& available_px);

/**
 * Maximises a window that is larger than its screen: its saved size may come from another screen or
 * smaller text. Call it before the window is shown.
 */
void keepOnScreen(QWidget& window);

/**
 * Shrinks a dialog that is larger than its screen to the screen, with its frame, even below the
 * sizes that its parts prefer. Call it before the dialog is shown.
 */
void boundToScreen(QWidget& dialog);

/** Returns the size of a dialog on a screen: `size_px` if there is room, but at least `least_px`.
 */
[[nodiscard]] QSize boundedDialog(const QSize& size_px, const QSize& least_px,
                                  const QSize& available_px);

} // namespace berg
