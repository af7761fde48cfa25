#pragma once

#include <QAccessible>

class QAbstractItemView;
class QWidget;

namespace berg {

/**
 * Sets the role that screen readers report for a custom-painted widget. Its context menu and its
 * actions become accessible actions.
 */
void setAccessibleRole(QWidget& widget, QAccessible::Role role);

/**
 * Makes the selected item of a single-selection list its current one as well: screen readers only
 * select, while keys and pointer do both.
 */
void followSelection(QAbstractItemView& list);

/**
 * Installs the accessibility interfaces: widgets get the role set by `setAccessibleRole`, pure
 * containers become groups, which Qt leaves without a role, and combo boxes report their label.
 * Call it once per program, after the application was created.
 */
void installAccessibleRoles();

} // namespace berg
