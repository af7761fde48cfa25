#pragma once

#include <QProxyStyle>

namespace berg {

/**
 * The style of the desktop with what can be told apart at 3 : 1 (WCAG 2.1, 1.4.11): outlines of
 * boxes and circles to be ticked, and grooves of sliders.
 */
class ContrastStyle : public QProxyStyle
{
    Q_OBJECT

public:
    using QProxyStyle::QProxyStyle;

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                            QPainter* painter, const QWidget* widget) const override;
};

} // namespace berg
