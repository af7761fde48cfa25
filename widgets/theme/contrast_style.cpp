#include "widgets/theme/contrast_style.h"

#include "widgets/theme/painter_state.h"
#include "widgets/theme/theme.h"

#include <QImage>
#include <QMainWindow>
#include <QPainter>
#include <QPlainTextEdit>
#include <QStyleOptionDockWidget>
#include <QStyleOptionSlider>
#include <QTabBar>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kInk = 0.55; // share of the text colour; the rest is the background
constexpr double kGroove_px = 4;
constexpr int kTabSpace_px = 14; // space beside the name on a dock tab

QPen outlinePen(const QStyleOption& option)
{
    const QColor ground = option.palette.color(QPalette::Window);
    return {mixed(ground, option.palette.color(QPalette::WindowText), kInk), 1};
}

/** Returns whether the palette is that of the night theme: texts have almost no blue. */
bool isNight(const QPalette& palette)
{
    const QColor text = palette.color(QPalette::WindowText);
    return text.redF() > 2 * text.blueF() && text.redF() > 2 * text.greenF();
}

/** Returns whether a field's outline is invisible: Fusion draws it darker than a dark window. */
bool lacksOutline(const QStyleOption& option)
{
    constexpr int kDark = 64; // on a scale of 255
    return option.palette.color(QPalette::Window).lightness() < kDark &&
           !option.state.testFlag(QStyle::State_HasFocus);
}

void drawFieldOutline(const QStyleOption& option, QPainter& painter)
{
    constexpr double kRadius_px = 2;
    const PainterState saved(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    constexpr double kNightInk = 0.8; // red on black is fainter
    painter.setPen(isNight(option.palette)
                       ? QPen(mixed(option.palette.color(QPalette::Window),
                                    option.palette.color(QPalette::WindowText), kNightInk),
                              1)
                       : outlinePen(option));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5), kRadius_px,
                            kRadius_px);
}

/** Marks a button that is switched on, which Fusion only draws a little darker. */
void drawSwitchedOn(const QStyleOption& option, QPainter& painter)
{
    constexpr double kRadius_px = 2;
    constexpr float kFill = 0.25F;
    const PainterState saved(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    QColor fill = option.palette.color(QPalette::Highlight);
    painter.setPen(QPen(fill, 1));
    fill.setAlphaF(kFill);
    painter.setBrush(fill);
    painter.drawRoundedRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5), kRadius_px,
                            kRadius_px);
}

/** Redraws an image in shades of one colour. */
QPixmap inShadesOf(const QColor& colour, const QPixmap& pixmap)
{
    QImage image = pixmap.toImage().convertToFormat(QImage::Format_ARGB32);
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const QColor was = image.pixelColor(x, y);
            QColor shade = mixed(Qt::black, colour, static_cast<double>(was.lightnessF()));
            shade.setAlphaF(was.alphaF());
            image.setPixelColor(x, y, shade);
        }
    QPixmap shaded = QPixmap::fromImage(image);
    shaded.setDevicePixelRatio(pixmap.devicePixelRatio());
    return shaded;
}

/** Draws the handle between docks, whose dots are always white and black in Fusion. */
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

/** Draws the size grip towards the lower right corner, its place in widget windows. */
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

/** Draws a line below a tool bar instead of Fusion's white and black ones. */
void drawToolBar(const QStyleOption& option, QPainter& painter)
{
    const PainterState saved(painter);
    painter.fillRect(option.rect, option.palette.color(QPalette::Window));
    painter.setPen(option.palette.color(QPalette::Mid));
    painter.drawLine(option.rect.bottomLeft(), option.rect.bottomRight());
}

/** Returns whether the widget is a tab bar of docks. */
bool isOfDocks(const QWidget* widget)
{
    return qobject_cast<const QTabBar*>(widget) != nullptr &&
           qobject_cast<const QMainWindow*>(widget->parentWidget()) != nullptr;
}

} // namespace

/** Dock tabs are scrolled rather than elided if there is no room. */
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
    if (element == PE_PanelButtonCommand && option->state.testFlag(State_On))
        return drawSwitchedOn(*option, *painter);
    const bool isField = element == PE_FrameLineEdit ||
                         (element == PE_Frame && qobject_cast<const QPlainTextEdit*>(widget));
    if (isField && lacksOutline(*option))
        return drawFieldOutline(*option, *painter);
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

/** Leaves out the title of a dock that is a window, because the window frame shows it. */
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

/** Draws the buttons of dock titles in the text colour; Qt's own are black or white. */
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

/** Draws a slider's groove, with the part up to the handle in the highlight colour. */
void ContrastStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                       QPainter* painter, const QWidget* widget) const
{
    const auto* button = qstyleoption_cast<const QStyleOptionToolButton*>(option);
    if (button != nullptr && widget != nullptr && !button->icon.isNull() &&
        widget->objectName().startsWith(u"qt_dockwidget_"_s))
        return drawTitleButton(*button, painter, *widget);
    if (const auto* number = qstyleoption_cast<const QStyleOptionSpinBox*>(option);
        number != nullptr && number->frame && lacksOutline(*option)) {
        QProxyStyle::drawComplexControl(control, option, painter, widget);
        return drawFieldOutline(*option, *painter);
    }
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

QIcon ContrastStyle::standardIcon(StandardPixmap which, const QStyleOption* option,
                                  const QWidget* widget) const
{
    QIcon usual = QProxyStyle::standardIcon(which, option, widget);
    const bool isOfBox = which == SP_MessageBoxInformation || which == SP_MessageBoxWarning ||
                         which == SP_MessageBoxCritical || which == SP_MessageBoxQuestion;
    if (!isOfBox || widget == nullptr || !isNight(widget->palette()))
        return usual;
    const int size_px = pixelMetric(PM_MessageBoxIconSize, option, widget);
    return inShadesOf(widget->palette().color(QPalette::WindowText),
                      usual.pixmap(QSize(size_px, size_px), widget->devicePixelRatioF()));
}

} // namespace berg
