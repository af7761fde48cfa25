#pragma once

class QDialog;

namespace berg {

/**
 * Escape closes the dialog even where a widget in it takes that key, as the map does. An open list
 * is closed first, and the dialog stays.
 */
void closeOnEscape(QDialog& dialog);

} // namespace berg
