#pragma once

#include "widgets/theme/theme.h"

#include <QLabel>

namespace berg {

/** Small, muted text: names an input or a figure, or explains one. */
class CaptionLabel : public QLabel
{
    Q_OBJECT

public:
    explicit CaptionLabel(const QString& text = {}, QWidget* parent = nullptr);
    void setTheme(const Theme& theme);

    /** Of the text on one line: a wrapping QLabel asks for the height of two. */
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;
};

/**
 * A number with its unit on one line. All digits are equally wide, so that a running number stands
 * still; where there is too little room the text gets smaller, never cut.
 */
class FigureLabel : public QLabel
{
    Q_OBJECT

public:
    explicit FigureLabel(QWidget* parent = nullptr);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
};

/** Height of two lines of a label that wraps; twice `QFontMetrics::height` is rounded down twice.
 */
[[nodiscard]] int heightOfTwoLines_px(const QFont& font);

/** Gives the theme to every caption below `panel`. */
void setCaptionTheme(QWidget& panel, const Theme& theme);

/** Shows a value, which screen readers hear after what it is: the accessible description. */
void showValue(QLabel& label, const QString& text);

/** What stands for a number that there is none of. */
[[nodiscard]] QString noFigure();

} // namespace berg
