#pragma once

#include "widgets/print/brief_content.h"

#include <QFont>
#include <QLineF>
#include <QRectF>

namespace berg {

/** How one text of the page is set. */
struct BriefType
{
    int size_px = 12;
    bool isBold = false;
    bool isMuted = false;
    bool isRight = false; ///< to the right edge of its box
    bool operator==(const BriefType&) const = default;
};

/** One line of text; the box is as wide as it, or wider. */
struct BriefText
{
    QRectF rect;
    QString text;
    BriefType type;
};

struct BriefRule
{
    QLineF line;
    bool isStrong = false;
};

/** A sign in the colour of a UAV. */
struct BriefSign
{
    QRectF rect;
    std::size_t uav = 0; ///< place among those of the content
};

/** Where everything of the page goes, at 96 to the inch. */
struct BriefLayout
{
    QSizeF page;
    QRectF map;
    std::vector<BriefText> texts;
    std::vector<BriefRule> rules;
    std::vector<BriefSign> signs;
};

/** From the edges of the paper: 12.7 mm. */
inline constexpr double kBriefMargin_px = 48;
/** The smallest type, 6.75 pt. */
inline constexpr int kSmallestBriefType_px = 9;

/** Without hinting, so that texts are as wide on each paint device and at each size. */
[[nodiscard]] QFont briefFont(const BriefType& type);

/**
 * Everything on one page of this size, which is A4 or Letter: a long table in smaller type and in
 * two columns; what then does not fit is cut, with a line that says how much. Thread: any with a
 * QGuiApplication (fonts).
 */
[[nodiscard]] BriefLayout layOutBrief(const BriefContent& content, const QSizeF& page);

} // namespace berg
