#include "widgets/panels/fields/panel_labels.h"

#include "widgets/map/paint/map_symbols.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kSmallestFigure_px = 9;
constexpr int kNarrowest_px = 40;

} // namespace

CaptionLabel::CaptionLabel(const QString& text, QWidget* parent) : QLabel(text, parent)
{
    setWordWrap(true);
}

void CaptionLabel::setTheme(const Theme& theme)
{
    QPalette colours = palette();
    colours.setColor(QPalette::WindowText, theme.mutedText);
    setPalette(colours);
    setFont(theme.small());
}

QSize CaptionLabel::sizeHint() const
{
    return fontMetrics().size(0, text());
}

QSize CaptionLabel::minimumSizeHint() const
{
    return {std::min(kNarrowest_px, sizeHint().width()), sizeHint().height()};
}

FigureLabel::FigureLabel(QWidget* parent) : QLabel(parent)
{
    setTextFormat(Qt::PlainText);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

QSize FigureLabel::sizeHint() const
{
    const QFontMetricsF metrics(font());
    return {static_cast<int>(std::ceil(tabularWidth(metrics, text()))),
            static_cast<int>(std::ceil(metrics.height()))};
}

QSize FigureLabel::minimumSizeHint() const
{
    return {std::min(kNarrowest_px, sizeHint().width()), sizeHint().height()};
}

void FigureLabel::paintEvent(QPaintEvent*)
{
    QFont fitted = font();
    double width_px = tabularWidth(QFontMetricsF(fitted), text());
    while (width_px > width() && fitted.pixelSize() > kSmallestFigure_px) {
        fitted.setPixelSize(fitted.pixelSize() - 1);
        width_px = tabularWidth(QFontMetricsF(fitted), text());
    }
    const QFontMetricsF metrics(fitted);
    double left_px = 0;
    if (alignment().testFlag(Qt::AlignRight))
        left_px = width() - width_px;
    else if (alignment().testFlag(Qt::AlignHCenter))
        left_px = (width() - width_px) / 2;
    QPainter painter(this);
    painter.setFont(fitted);
    painter.setPen(palette().color(foregroundRole()));
    const double baseline_px = (height() + metrics.ascent() - metrics.descent()) / 2;
    drawTabular(painter, {left_px, baseline_px}, text());
}

int heightOfTwoLines_px(const QFont& font)
{
    constexpr QRect kRoom(0, 0, 1000, 1000);
    return QFontMetrics(font).boundingRect(kRoom, Qt::TextWordWrap, u"X\nX"_s).height();
}

void setCaptionTheme(QWidget& panel, const Theme& theme)
{
    for (CaptionLabel* caption : panel.findChildren<CaptionLabel*>())
        caption->setTheme(theme);
}

void showValue(QLabel& label, const QString& text)
{
    label.setText(text);
    label.setAccessibleName(u"%1: %2"_s.arg(label.accessibleDescription(), text));
}

QString missingValueText()
{
    return u"–"_s;
}

} // namespace berg
