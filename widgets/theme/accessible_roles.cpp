#include "widgets/theme/accessible_roles.h"

#include <QAbstractItemView>
#include <QAccessibleWidget>
#include <QAction>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QVariant>

namespace berg {
namespace {

constexpr const char* kRole = "accessibleRole";

/** Reads the role on demand, because the interface may be created before the role is set. */
class RoleInterface : public QAccessibleWidget
{
public:
    using QAccessibleWidget::QAccessibleWidget;

    [[nodiscard]] QAccessible::Role role() const override
    {
        if (hasOwn())
            return static_cast<QAccessible::Role>(widget()->property(kRole).toInt());
        return widget()->isWindow() ? QAccessible::Window : QAccessibleWidget::role();
    }

    /** A focusable widget without a name takes the name of its nearest named ancestor. */
    [[nodiscard]] QString text(QAccessible::Text kind) const override
    {
        QString name = QAccessibleWidget::text(kind);
        if (kind != QAccessible::Name || widget()->focusPolicy() == Qt::NoFocus)
            return name;
        for (const QWidget* in = widget(); name.isEmpty() && in != nullptr; in = in->parentWidget())
            name = in->accessibleName().isEmpty() ? in->windowTitle() : in->accessibleName();
        return name.remove(QStringLiteral("[*]")); // placeholder of the mark of changes in a title
    }

    [[nodiscard]] QStringList actionNames() const override
    {
        QStringList names = QAccessibleWidget::actionNames();
        if (!hasOwn() || !widget()->isEnabled())
            return names;
        names << showMenuAction();
        for (const QAction* action : widget()->actions())
            if (action->isEnabled())
                names << action->text();
        return names;
    }

    void doAction(const QString& name) override
    {
        for (QAction* action : widget()->actions())
            if (action->text() == name)
                QMetaObject::invokeMethod(action, &QAction::trigger, Qt::QueuedConnection);
        if (name != showMenuAction())
            return QAccessibleWidget::doAction(name);
        const QPoint middle = widget()->rect().center();
        QCoreApplication::postEvent( // posted, because a menu may stay open while the caller waits
            widget(), new QContextMenuEvent(QContextMenuEvent::Keyboard, middle,
                                            widget()->mapToGlobal(middle)));
    }

private:
    [[nodiscard]] bool hasOwn() const { return widget()->property(kRole).isValid(); }
};

/**
 * A combo box for screen readers: named "label: value", with actions that choose. Qt reports only
 * the value and offers no choice except by keys and pointer.
 */
class AccessibleCombo : public QAccessibleWidget
{
public:
    explicit AccessibleCombo(QComboBox* combo) : QAccessibleWidget(combo, QAccessible::ComboBox) {}

    [[nodiscard]] QString text(QAccessible::Text kind) const override
    {
        const QString label = combo().accessibleName();
        if (kind == QAccessible::Value || (kind == QAccessible::Name && label.isEmpty()))
            return combo().currentText();
        if (kind == QAccessible::Name)
            return QStringLiteral("%1: %2").arg(label, combo().currentText());
        return QAccessibleWidget::text(kind);
    }

    [[nodiscard]] QAccessible::State state() const override
    {
        QAccessible::State state = QAccessibleWidget::state();
        state.expandable = true;
        state.expanded = combo().view()->isVisible();
        state.editable = combo().isEditable();
        return state;
    }

    [[nodiscard]] int childCount() const override { return combo().isEditable() ? 2 : 1; }

    [[nodiscard]] QAccessibleInterface* child(int index) const override
    {
        if (index == 0)
            return QAccessible::queryAccessibleInterface(combo().view());
        if (index == 1 && combo().isEditable())
            return QAccessible::queryAccessibleInterface(combo().lineEdit());
        return nullptr;
    }

    [[nodiscard]] int indexOfChild(const QAccessibleInterface* child) const override
    {
        for (int index = 0; index < childCount(); ++index)
            if (this->child(index)->object() == child->object())
                return index;
        return -1;
    }

    [[nodiscard]] QStringList actionNames() const override
    {
        QStringList names = QAccessibleWidget::actionNames();
        if (combo().isEnabled())
            names = QStringList{showMenuAction(), increaseAction(), decreaseAction()} + names;
        return names;
    }

    void doAction(const QString& name) override
    {
        const bool isNext = name == increaseAction();
        if (name == showMenuAction())
            combo().view()->isVisible() ? combo().hidePopup() : combo().showPopup();
        else if (isNext ||
                 name == decreaseAction()) // by key, so that the combo box emits its signals
            QCoreApplication::postEvent(&combo(), new QKeyEvent(QEvent::KeyPress,
                                                                isNext ? Qt::Key_Down : Qt::Key_Up,
                                                                Qt::NoModifier));
        else
            QAccessibleWidget::doAction(name);
    }

private:
    [[nodiscard]] QComboBox& combo() const { return *static_cast<QComboBox*>(widget()); }
};

/** Creates the interface of an object; Qt calls it for its class, then for the base classes. */
QAccessibleInterface* interfaceOf(const QString& className, QObject* object)
{
    auto* const widget = qobject_cast<QWidget*>(object);
    if (widget == nullptr)
        return nullptr;
    if (className == QLatin1String("QComboBox"))
        return new AccessibleCombo(static_cast<QComboBox*>(object));
    for (const char* holder : {"QWidget", "QScrollArea", "QAbstractScrollArea"})
        if (className == QLatin1String(holder))
            return new RoleInterface(widget, QAccessible::Grouping);
    for (const char* edge : {"QSizeGrip", "QSplitterHandle"})
        if (className == QLatin1String(edge))
            return new RoleInterface(widget, QAccessible::Separator);
    return nullptr;
}

} // namespace

void setAccessibleRole(QWidget& widget, QAccessible::Role role)
{
    widget.setProperty(kRole, static_cast<int>(role));
}

void followSelection(QAbstractItemView& list)
{
    // Queued, because a selection made through the current item has not set that yet.
    QObject::connect(
        list.selectionModel(), &QItemSelectionModel::selectionChanged, &list,
        [&list] {
            const QModelIndexList selected = list.selectionModel()->selectedIndexes();
            if (!selected.isEmpty() && selected.front() != list.currentIndex())
                list.setCurrentIndex(selected.front());
        },
        Qt::QueuedConnection);
}

void installAccessibleRoles()
{
    QAccessible::installFactory(&interfaceOf);
}

} // namespace berg
