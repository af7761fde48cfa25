#pragma once

#include "widgets/print/brief_layout.h"

#include <QStringList>

namespace berg {

// Texts into boxes of the brief.

inline constexpr BriefType kBriefTitle{.size_px = 20, .isBold = true};
inline constexpr BriefType kBriefHead{.size_px = 12};
inline constexpr BriefType kBriefCaption{.size_px = 10, .isMuted = true};
inline constexpr BriefType kBriefFoot{.size_px = 9, .isMuted = true};

/** From one line of this type to the next, and the height of its box. */
[[nodiscard]] double linePitch_px(int size_px);

[[nodiscard]] double widthOf_px(const QString& text, const BriefType& type);

/** Sets one line into the box, cut with an ellipsis where it is too long; nothing of no text. */
void setText(BriefLayout& layout, const QRectF& rect, const QString& text, const BriefType& type);

/** The text in at most so many lines of this width, the last one cut. */
[[nodiscard]] QStringList wrapped(const QString& text, const BriefType& type, double width_px,
                                  int mostLines);

/** A page that is set from the top: one block after the other into what is still free of it. */
struct PageSetting
{
    BriefLayout layout;
    QRectF free;

    explicit PageSetting(const QSizeF& page);

    /** A strip of this height from the top of what is free. */
    QRectF taken(double height_px);
    void line(const QString& text, const BriefType& type);
    /** With some room above and below. */
    void rule(bool isStrong);
    /** In columns, each fact as many of them wide as it needs. */
    void setFacts(const std::vector<BriefFact>& facts, int columns);
    /** Captions and rows of the UAVs, in smaller type where they are too wide; of many UAVs the
     * first. */
    void setUavTable(const std::vector<QStringList>& rows);
};

} // namespace berg
