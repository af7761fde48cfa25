#pragma once

#include "widgets/theme/sigma_scale.h"

#include <QFont>

class QPainter;

namespace berg {

/**
 * Colours and fonts of one appearance. Every text colour keeps at least 4.5 : 1 and every line that
 * carries meaning 3 : 1 against what it is drawn on (WCAG 2.1); `tst_theme` measures both. Grids
 * of charts are fainter on purpose.
 */
struct Theme
{
    bool isDark = false;
    bool isNight = false; ///< all in red

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
    QColor formerPlan; ///< what the plan took the place of
    QColor track;      ///< flown track where it is newest
    QColor swept;      ///< over water seen so far, translucent
    QColor comparison;
    QColor alarm;   ///< act now
    QColor warning; ///< something is not as planned

    // Text and panels
    QColor text;
    QColor mutedText;
    QColor panel; ///< behind overlays on the map
    QColor panelLine;

    // Charts
    QColor chart; ///< background
    QColor chartGrid;
    QColor chartAxis;
    QColor accumulated; ///< zeta
    QColor momentary;   ///< sum of sigma

    SigmaScale sigma{SigmaScale::Ground::Light};
    QFont font; ///< system font; sizes are in pixels so that they are alike on every paint device

    [[nodiscard]] static Theme light();
    [[nodiscard]] static Theme dark();
    /** For those who need more: text keeps 7 : 1 (WCAG 2.1, 1.4.6), lines of one UAV 4.5 : 1. */
    [[nodiscard]] static Theme highContrast(bool isDark);

    /**
     * Reds on black, which leave eyes used to the dark as they are. Text keeps 4.5 : 1 and lines
     * 3 : 1; meanings are told apart by lightness, and by the shapes that they have anyway.
     */
    [[nodiscard]] static Theme night();

    /** A colour that is not of the theme as it is shown in it: by night a red of its lightness. */
    [[nodiscard]] QColor toned(const QColor& colour) const;

    [[nodiscard]] QFont body() const;   ///< 13 px
    [[nodiscard]] QFont small() const;  ///< 11 px
    [[nodiscard]] QFont strong() const; ///< 13 px, bold
    [[nodiscard]] QFont figure() const; ///< 22 px: numbers that matter
};

/** WCAG 2.1 relative luminance of an opaque colour, 0 black to 1 white. */
[[nodiscard]] double relativeLuminance(const QColor& colour);

/** WCAG 2.1 contrast ratio of two opaque colours, 1 to 21. */
[[nodiscard]] double contrastRatio(const QColor& a, const QColor& b);

/** `fraction` 0: `from`; 1: `to`; linear in sRGB between, alpha included. */
[[nodiscard]] QColor mixed(const QColor& from, const QColor& to, double fraction);

} // namespace berg
