#pragma once

class QWidget;

namespace berg {

/**
 * The widget that Tab leads to (`next`), or Shift+Tab, from the one with the focus: as Qt orders
 * them, but without what is in docks behind another tab, which Qt holds to be visible. Null: there
 * is none.
 */
[[nodiscard]] QWidget* nextInSight(const QWidget& window, bool next);

/** In a dock that is there, but behind the tab of another one. */
[[nodiscard]] bool isBehindATab(const QWidget& widget);

} // namespace berg
