#pragma once

#include "widgets/print/brief_content.h"

#include <QFont>
#include <QLineF>
#include <QRectF>

namespace berg {

/** Style of a text on the page. */
struct BriefType
{
    int size_px = 12;
    bool isBold = false;
    bool isMuted = false;
    bool isRight = false; ///< aligned to the right edge of its box
    bool operator==(const BriefType&) const = default;
};

/** One line of text in a box that is at least as wide. */
struct BriefText
{
    QRectF rect;
    QString text;
    BriefType type;
};

/** A line on the page. */
struct BriefRule
{
    QLineF line;
    bool isStrong = false;
};

/** A square in the colour of a UAV. */
struct BriefSign
{
    QRectF rect;
    std::size_t uav = 0; ///< index in the content
};

/** Positions of all parts of a page, at 96 per inch. */
struct BriefLayout
{
    QSizeF page;
    QRectF map;
    std::vector<BriefText> texts;
    std::vector<BriefRule> rules;
    std::vector<BriefSign> signs;
};

/** Distance from the paper's edges: 12.7 mm. */
inline constexpr double kBriefMargin_px = 48;
/** Smallest font size: 6.75 pt. */
inline constexpr int kSmallestBriefType_px = 9;

/**
 * Returns the font of a text. It has no hinting, so that texts are equally wide on every device and
 * at every size.
 */
[[nodiscard]] QFont briefFont(const BriefType& type);

/**
 * Lays out the brief on one A4 or Letter page. A long table is set in a smaller font and in two
 * columns; if it still does not fit, it is cut, and a line gives the number of rows left out. Runs
 * on any thread with a QGuiApplication (fonts).
 */
[[nodiscard]] BriefLayout layOutBrief(const BriefContent& content, const QSizeF& page);

} // namespace berg
