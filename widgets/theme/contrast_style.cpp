#include "widgets/theme/contrast_style.h"

#include "widgets/theme/painter_state.h"
#include "widgets/theme/theme.h"

#include <QPainter>
#include <QStyleOptionSlider>

namespace berg {
namespace {

constexpr double kInk = 0.55; // share of the text's colour, the rest is what it stands on
constexpr double kGroove_px = 4;

QPen outlinePen(const QStyleOption& option)
{
    const QColor ground = option.palette.color(QPalette::Window);
    return {mixed(ground, option.palette.color(QPalette::WindowText), kInk), 1};
}

} // namespace

void ContrastStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
                                  QPainter* painter, const QWidget* widget) const
{
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    const bool isCircle = element == PE_IndicatorRadioButton;
    if (!isCircle && element != PE_IndicatorCheckBox && element != PE_IndicatorItemViewItemCheck)
        return;
    const PainterState saved(*painter);
    painter->setPen(outlinePen(*option));
    painter->setBrush(Qt::NoBrush);
    const QRectF edge = QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5);
    if (isCircle) {
        painter->setRenderHint(QPainter::Antialiasing);
        painter->drawEllipse(edge);
    } else {
        painter->drawRect(edge);
    }
}

/** The groove up to the handle in the colour of what is chosen. */
void ContrastStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                       QPainter* painter, const QWidget* widget) const
{
    const auto* slider = qstyleoption_cast<const QStyleOptionSlider*>(option);
    if (control != CC_Slider || slider == nullptr ||
        !slider->subControls.testFlag(SC_SliderGroove) || slider->orientation != Qt::Horizontal) {
        QProxyStyle::drawComplexControl(control, option, painter, widget);
        return;
    }
    const QRectF room = subControlRect(CC_Slider, slider, SC_SliderGroove, widget);
    const QPointF handle = subControlRect(CC_Slider, slider, SC_SliderHandle, widget).center();
    QRectF groove(room.left(), room.center().y() - kGroove_px / 2, room.width(), kGroove_px);
    {
        const PainterState saved(*painter);
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setPen(Qt::NoPen);
        painter->setBrush(outlinePen(*option).color());
        painter->drawRoundedRect(groove, kGroove_px / 2, kGroove_px / 2);
        if (slider->upsideDown)
            groove.setLeft(handle.x());
        else
            groove.setRight(handle.x());
        painter->setBrush(slider->palette.color(QPalette::Highlight));
        painter->drawRoundedRect(groove, kGroove_px / 2, kGroove_px / 2);
    }
    QStyleOptionSlider rest(*slider);
    rest.subControls &= ~SC_SliderGroove;
    QProxyStyle::drawComplexControl(control, &rest, painter, widget);
}

} // namespace berg
