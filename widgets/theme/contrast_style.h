#pragma once

#include <QProxyStyle>

class QStyleOptionToolButton;

namespace berg {

/**
 * The style of the desktop with what can be told apart at 3 : 1 (WCAG 2.1, 1.4.11): outlines of
 * boxes and circles to be ticked, grooves of sliders, and buttons in the titles of docks. Names on
 * the tabs of docks are whole.
 */
class ContrastStyle : public QProxyStyle
{
    Q_OBJECT

public:
    using QProxyStyle::QProxyStyle;

    using QProxyStyle::polish;
    void polish(QWidget* widget) override;
    [[nodiscard]] int pixelMetric(PixelMetric metric, const QStyleOption* option,
                                  const QWidget* widget) const override;
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
    void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                            QPainter* painter, const QWidget* widget) const override;

private:
    void drawTitleButton(const QStyleOptionToolButton& button, QPainter* painter,
                         const QWidget& widget) const;
};

} // namespace berg
