#pragma once

class QWidget;

namespace berg {

/**
 * Lets the wheel change the input only while it has the keyboard focus; otherwise the enclosing
 * area scrolls. This prevents accidental changes while scrolling.
 */
void guardWheel(QWidget& input);

} // namespace berg
