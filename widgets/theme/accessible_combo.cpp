#include "widgets/theme/accessible_combo.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QLineEdit>

namespace berg {

AccessibleCombo::AccessibleCombo(QComboBox* combo) : QAccessibleWidget(combo, QAccessible::ComboBox)
{
}

QComboBox& AccessibleCombo::combo() const
{
    return *static_cast<QComboBox*>(widget());
}

QString AccessibleCombo::text(QAccessible::Text kind) const
{
    const QString label = combo().accessibleName();
    if (kind == QAccessible::Value || (kind == QAccessible::Name && label.isEmpty()))
        return combo().currentText();
    if (kind == QAccessible::Name)
        return QStringLiteral("%1: %2").arg(label, combo().currentText());
    return QAccessibleWidget::text(kind);
}

QAccessible::State AccessibleCombo::state() const
{
    QAccessible::State state = QAccessibleWidget::state();
    state.expandable = true;
    state.expanded = combo().view()->isVisible();
    state.editable = combo().isEditable();
    return state;
}

int AccessibleCombo::childCount() const
{
    return combo().isEditable() ? 2 : 1;
}

QAccessibleInterface* AccessibleCombo::child(int index) const
{
    if (index == 0)
        return QAccessible::queryAccessibleInterface(combo().view());
    if (index == 1 && combo().isEditable())
        return QAccessible::queryAccessibleInterface(combo().lineEdit());
    return nullptr;
}

int AccessibleCombo::indexOfChild(const QAccessibleInterface* child) const
{
    for (int index = 0; index < childCount(); ++index)
        if (this->child(index)->object() == child->object())
            return index;
    return -1;
}

QStringList AccessibleCombo::actionNames() const
{
    QStringList names = QAccessibleWidget::actionNames();
    if (combo().isEnabled())
        names = QStringList{showMenuAction(), increaseAction(), decreaseAction()} + names;
    return names;
}

void AccessibleCombo::doAction(const QString& name)
{
    const bool isNext = name == increaseAction();
    if (name == showMenuAction())
        combo().view()->isVisible() ? combo().hidePopup() : combo().showPopup();
    else if (isNext || name == decreaseAction()) // as the user does it, so that it is acted upon
        QCoreApplication::postEvent(
            &combo(),
            new QKeyEvent(QEvent::KeyPress, isNext ? Qt::Key_Down : Qt::Key_Up, Qt::NoModifier));
    else
        QAccessibleWidget::doAction(name);
}

} // namespace berg
