#pragma once

#include <QList>
#include <QString>
#include <QWidget>

namespace berg::test {

inline QList<QWidget*> visibleWidgets(const QWidget& window)
{
    QList<QWidget*> visible;
    for (QWidget* widget : window.findChildren<QWidget*>())
        if (!widget->visibleRegion().isEmpty()) // Qt considers docks behind a tab visible
            visible << widget;
    return visible;
}

/** Returns "QLabel planState in PlanReadoutView", which is enough to find the widget. */
inline QString nameOf(const QWidget& widget)
{
    const QWidget* parent = widget.parentWidget();
    return QStringLiteral("%1 %2 in %3 %4")
        .arg(QString::fromLatin1(widget.metaObject()->className()), widget.objectName(),
             parent != nullptr ? QString::fromLatin1(parent->metaObject()->className()) : QString(),
             parent != nullptr ? parent->objectName() : QString());
}

} // namespace berg::test
