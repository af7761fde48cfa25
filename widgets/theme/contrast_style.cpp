#include "widgets/theme/contrast_style.h"

#include "widgets/theme/painter_state.h"
#include "widgets/theme/theme.h"

#include <QMainWindow>
#include <QPainter>
#include <QStyleOptionDockWidget>
#include <QStyleOptionSlider>
#include <QTabBar>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kInk = 0.55; // share of the text's colour, the rest is what it stands on
constexpr double kGroove_px = 4;
constexpr int kTabSpace_px = 14; // beside the name of a dock on its tab

QPen outlinePen(const QStyleOption& option)
{
    const QColor ground = option.palette.color(QPalette::Window);
    return {mixed(ground, option.palette.color(QPalette::WindowText), kInk), 1};
}

/** Fusion's dots between docks are white and black, whatever the palette. */
void drawGrip(const QStyleOption& option, QPainter& painter)
{
    constexpr int kGrip_px = 16;
    const QPoint centre = option.rect.center();
    const bool isUpright = option.rect.height() > option.rect.width();
    const QPoint half = isUpright ? QPoint(0, kGrip_px / 2) : QPoint(kGrip_px / 2, 0);
    const PainterState saved(painter);
    painter.setPen(QPen(outlinePen(option).color(), 1, Qt::DotLine));
    painter.drawLine(centre - half, centre + half);
}

/** Towards the lower right corner, where windows of widgets have it. */
void drawSizeGrip(const QStyleOption& option, QPainter& painter)
{
    constexpr int kStep_px = 4;
    constexpr int kLines = 3;
    const PainterState saved(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(outlinePen(option));
    const QPoint corner = option.rect.bottomRight();
    for (int line = 1; line <= kLines; ++line)
        painter.drawLine(corner - QPoint(line * kStep_px, 0), corner - QPoint(0, line * kStep_px));
}

/** A line below, in the place of Fusion's white and black ones. */
void drawToolBar(const QStyleOption& option, QPainter& painter)
{
    const PainterState saved(painter);
    painter.fillRect(option.rect, option.palette.color(QPalette::Window));
    painter.setPen(option.palette.color(QPalette::Mid));
    painter.drawLine(option.rect.bottomLeft(), option.rect.bottomRight());
}

/** Of docks. */
bool isOfDocks(const QWidget* widget)
{
    return qobject_cast<const QTabBar*>(widget) != nullptr &&
           qobject_cast<const QMainWindow*>(widget->parentWidget()) != nullptr;
}

} // namespace

/** Tabs that have no room are scrolled. */
void ContrastStyle::polish(QWidget* widget)
{
    QProxyStyle::polish(widget);
    if (isOfDocks(widget))
        qobject_cast<QTabBar*>(widget)->setElideMode(Qt::ElideNone);
}

int ContrastStyle::pixelMetric(PixelMetric metric, const QStyleOption* option,
                               const QWidget* widget) const
{
    const int usual = QProxyStyle::pixelMetric(metric, option, widget);
    return metric == PM_TabBarTabHSpace && isOfDocks(widget) ? std::min(usual, kTabSpace_px)
                                                             : usual;
}

void ContrastStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
                                  QPainter* painter, const QWidget* widget) const
{
    if (element == PE_IndicatorDockWidgetResizeHandle)
        return drawGrip(*option, *painter);
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

/** A dock that is a window with a frame has its title there. */
void ContrastStyle::drawControl(ControlElement element, const QStyleOption* option,
                                QPainter* painter, const QWidget* widget) const
{
    if (element == CE_ToolBar)
        return drawToolBar(*option, *painter);
    if (element == CE_SizeGrip)
        return drawSizeGrip(*option, *painter);
    const auto* title = qstyleoption_cast<const QStyleOptionDockWidget*>(option);
    if (element != CE_DockWidgetTitle || title == nullptr || widget == nullptr ||
        widget->windowType() != Qt::Window)
        return QProxyStyle::drawControl(element, option, painter, widget);
    QStyleOptionDockWidget bare(*title);
    bare.title.clear();
    QProxyStyle::drawControl(element, &bare, painter, widget);
}

/** The buttons of a dock's title are in the colour of its text: Qt's own are black or white. */
void ContrastStyle::drawTitleButton(const QStyleOptionToolButton& button, QPainter* painter,
                                    const QWidget& widget) const
{
    QPixmap mask = button.icon.pixmap(button.iconSize, widget.devicePixelRatioF());
    {
        QPainter inks(&mask);
        inks.setCompositionMode(QPainter::CompositionMode_SourceIn);
        inks.fillRect(mask.rect(), button.palette.color(QPalette::WindowText));
    }
    QStyleOptionToolButton inked(button);
    inked.icon = QIcon(mask);
    QProxyStyle::drawComplexControl(CC_ToolButton, &inked, painter, &widget);
}

/** The groove up to the handle in the colour of what is chosen. */
void ContrastStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                       QPainter* painter, const QWidget* widget) const
{
    const auto* button = qstyleoption_cast<const QStyleOptionToolButton*>(option);
    if (button != nullptr && widget != nullptr && !button->icon.isNull() &&
        widget->objectName().startsWith(u"qt_dockwidget_"_s))
        return drawTitleButton(*button, painter, *widget);
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
