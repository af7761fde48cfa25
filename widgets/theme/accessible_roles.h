#pragma once

#include <QAccessible>

class QAbstractItemView;
class QWidget;

namespace berg {

/**
 * What a screen reader calls a widget that is painted by us, of which Qt knows only that it is one.
 * Its context menu and its actions become what can be done with it.
 */
void setAccessibleRole(QWidget& widget, QAccessible::Role role);

/**
 * What becomes selected in a list of single selection becomes the current one too: screen readers
 * do only the former, keys and pointer both.
 */
void followSelection(QAbstractItemView& list);

/**
 * From now on widgets have the role that `setAccessibleRole` gave them, those that only hold others
 * are groups, which Qt leaves without a role, and lists to choose from say what they are of. Once
 * per program, when there is an application.
 */
void installAccessibleRoles();

} // namespace berg
