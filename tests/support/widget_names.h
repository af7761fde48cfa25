#pragma once

#include <QList>
#include <QString>
#include <QWidget>

namespace berg::test {

inline QList<QWidget*> visibleWidgets(const QWidget& window)
{
    QList<QWidget*> visible;
    for (QWidget* widget : window.findChildren<QWidget*>())
        if (!widget->visibleRegion().isEmpty()) // docks behind a tab are visible for Qt
            visible << widget;
    return visible;
}

/** "QLabel planState in PlanReadoutView": enough to find it. */
inline QString nameOf(const QWidget& widget)
{
    const QWidget* parent = widget.parentWidget();
    return QStringLiteral("%1 %2 in %3 %4")
        .arg(QString::fromLatin1(widget.metaObject()->className()), widget.objectName(),
             parent != nullptr ? QString::fromLatin1(parent->metaObject()->className()) : QString(),
             parent != nullptr ? parent->objectName() : QString());
}

} // namespace berg::test
