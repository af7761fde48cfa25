#pragma once

#include "widgets/theme/sigma_scale.h"

#include <QFont>

class QPainter;

namespace berg {

/**
 * Colours and fonts of one appearance. Text has a contrast of at least 4.5 : 1 and meaningful lines
 * have 3 : 1 against their background (WCAG 2.1); `tst_theme` measures both. Chart grids are
 * deliberately fainter.
 */
struct Theme
{
    bool isDark = false;
    bool isNight = false; ///< all colours are reds

    // Map
    QColor sea;
    QColor land;
    QColor coast;
    QColor graticule;
    QColor graticuleText;
    QColor ice;        ///< lit facet of an iceberg
    QColor ink;        ///< outlines of symbols, drift arrows
    QColor uav;        ///< UAV and its field of view
    QColor plan;       ///< planned order
    QColor planText;   ///< number in an order circle
    QColor formerPlan; ///< plan before the last change
    QColor track;      ///< newest part of a flown track
    QColor swept;      ///< translucent tint of water seen so far
    QColor comparison;
    QColor alarm;   ///< action is required now
    QColor warning; ///< deviation from the plan

    // Text and panels
    QColor text;
    QColor mutedText;
    QColor panel; ///< background of overlays on the map
    QColor panelLine;

    // Charts
    QColor chart; ///< background
    QColor chartGrid;
    QColor chartAxis;
    QColor accumulated; ///< zeta
    QColor momentary;   ///< sum of sigma

    SigmaScale sigma{SigmaScale::Ground::Light};
    QFont font; ///< system font; sizes are in pixels, so that they are equal on every paint device

    [[nodiscard]] static Theme light();
    [[nodiscard]] static Theme dark();
    /** High contrast: text keeps 7 : 1 (WCAG 2.1, 1.4.6), lines of a single UAV 4.5 : 1. */
    [[nodiscard]] static Theme highContrast(bool isDark);

    /**
     * Reds on black, which preserve dark adaptation. Text keeps 4.5 : 1 and lines 3 : 1; meanings
     * differ in lightness and shape.
     */
    [[nodiscard]] static Theme night();

    /** Converts a foreign colour for this theme: in the night theme a red of equal lightness. */
    [[nodiscard]] QColor toned(const QColor& colour) const;

    [[nodiscard]] QFont body() const;   ///< 13 px
    [[nodiscard]] QFont small() const;  ///< 11 px
    [[nodiscard]] QFont strong() const; ///< 13 px, bold
    [[nodiscard]] QFont figure() const; ///< 22 px, for prominent numbers
};

/** WCAG 2.1 relative luminance of an opaque colour, from 0 (black) to 1 (white). */
[[nodiscard]] double relativeLuminance(const QColor& colour);

/** WCAG 2.1 contrast ratio of two opaque colours, 1 to 21. */
[[nodiscard]] double contrastRatio(const QColor& a, const QColor& b);

/** Mixture of two colours, linear in sRGB with alpha; `fraction` is the share of `to`. */
[[nodiscard]] QColor mixed(const QColor& from, const QColor& to, double fraction);

} // namespace berg
