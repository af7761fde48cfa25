#pragma once

#include <QIcon>
#include <QProxyStyle>

class QStyleOptionToolButton;

namespace berg {

/**
 * The desktop's style with a contrast of at least 3 : 1 (WCAG 2.1, 1.4.11) for outlines of check
 * boxes and radio buttons, fields on dark backgrounds, grooves of sliders, and buttons in dock
 * titles. Names on dock tabs are not elided.
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
    /** Icons of message boxes, in the red of the text in the night theme. */
    [[nodiscard]] QIcon standardIcon(StandardPixmap which, const QStyleOption* option,
                                     const QWidget* widget) const override;

private:
    void drawTitleButton(const QStyleOptionToolButton& button, QPainter* painter,
                         const QWidget& widget) const;
};

} // namespace berg
