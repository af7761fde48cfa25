#include "widgets/theme/accessible_roles.h"

#include "widgets/theme/accessible_combo.h"

#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QCoreApplication>
#include <QVariant>

namespace berg {
namespace {

constexpr const char* kRole = "accessibleRole";

/** Asks for the role when it is wanted: a widget may be known before it has been given its own. */
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

    /** What can be scrolled with the keys, but has no name, is called as what it is in. */
    [[nodiscard]] QString text(QAccessible::Text kind) const override
    {
        QString name = QAccessibleWidget::text(kind);
        if (kind != QAccessible::Name || widget()->focusPolicy() == Qt::NoFocus)
            return name;
        for (const QWidget* in = widget(); name.isEmpty() && in != nullptr; in = in->parentWidget())
            name = in->accessibleName().isEmpty() ? in->windowTitle() : in->accessibleName();
        return name.remove(QStringLiteral("[*]")); // the place for the mark of changes in a title
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
        QCoreApplication::postEvent( // a menu may be open for long, and who asked waits
            widget(), new QContextMenuEvent(QContextMenuEvent::Keyboard, middle,
                                            widget()->mapToGlobal(middle)));
    }

private:
    [[nodiscard]] bool hasOwn() const { return widget()->property(kRole).isValid(); }
};

/** Called for the class of the object, then for those it comes from, until one is known. */
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
    // Queued: what selects by making current has not done that yet.
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
