#pragma once

class QWidget;

namespace berg {

/**
 * Lets the wheel change the input only while it has the keyboard focus; otherwise the wheel goes
 * on to what scrolls. Keeps a value from changing because the pointer happened to pass over it.
 */
void guardWheel(QWidget& input);

} // namespace berg
