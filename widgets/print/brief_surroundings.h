#pragma once

#include "widgets/print/brief_layout.h"

#include <QStringList>

namespace berg {

// Text layout for printed pages.

inline constexpr BriefType kBriefTitle{.size_px = 20, .isBold = true};
inline constexpr BriefType kBriefHead{.size_px = 12};
inline constexpr BriefType kBriefCaption{.size_px = 10, .isMuted = true};
inline constexpr BriefType kBriefFoot{.size_px = 9, .isMuted = true};

/** Returns the line height for a font size; a text's box has this height. */
[[nodiscard]] double linePitch_px(int size_px);

/** Returns the width of a text in the brief's font, px. */
[[nodiscard]] double widthOf_px(const QString& text, const BriefType& type);

/** Adds one line of text in a box, elided if it is too long; an empty text adds nothing. */
void setText(BriefLayout& layout, const QRectF& rect, const QString& text, const BriefType& type);

/** Wraps text to at most `mostLines` lines; the last one contains the rest. */
[[nodiscard]] QStringList wrapped(const QString& text, const BriefType& type, double width_px,
                                  int mostLines);

/** A page that is filled from top to bottom with blocks. */
struct PageComposer
{
    BriefLayout layout;
    QRectF free;

    /** Begins an empty page of this size, at 96 per inch; the margins are not free. */
    explicit PageComposer(const QSizeF& page);

    /** Takes a strip of this height from the top of the free area and returns it. */
    QRectF takeStrip(double height_px);
    /** Adds one line of text. */
    void line(const QString& text, const BriefType& type);
    /** Adds a horizontal line with some space around it. */
    void rule(bool isStrong);
    /** Adds facts in a grid; a wide fact spans several columns. */
    void setFacts(const std::vector<BriefFact>& facts, int columns);
    /** Adds a table of UAVs (captions first) in a font that fits; a large fleet is cut, and a line
     * gives the number of UAVs left out. */
    void setUavTable(const std::vector<QStringList>& rows);
};

} // namespace berg
