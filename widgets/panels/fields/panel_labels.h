#pragma once

#include "widgets/theme/theme.h"

#include <QLabel>

namespace berg {

/** Small, muted text that labels or explains an input or a figure. */
class CaptionLabel : public QLabel
{
    Q_OBJECT

public:
    explicit CaptionLabel(const QString& text = {}, QWidget* parent = nullptr);
    void setTheme(const Theme& theme);

    /** Returns the size of the text on one line; a wrapping QLabel would ask for two. */
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;
};

/**
 * A number with its unit on one line. Digits have equal width, so that a running number does not
 * jump; with too little room the text shrinks and is never cut.
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

/**
 * Returns the height of two lines of a wrapping label; twice `QFontMetrics::height` is rounded
 * twice.
 */
[[nodiscard]] int heightOfTwoLines_px(const QFont& font);

/** Sets the theme of every caption below `panel`. */
void setCaptionTheme(QWidget& panel, const Theme& theme);

/**
 * Shows a value, and sets it as the accessible description, which screen readers read after the
 * name.
 */
void showValue(QLabel& label, const QString& text);

/** Returns the text for a missing value. */
[[nodiscard]] QString missingValueText();

} // namespace berg
