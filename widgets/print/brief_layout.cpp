#include "widgets/print/brief_layout.h"

#include "widgets/print/brief_surroundings.h"
#include "widgets/print/brief_table_layout.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr BriefType kHeading{.size_px = 11, .isBold = true};
constexpr BriefType kWords{.size_px = 10};

constexpr double kBlockGap_px = 10;
constexpr double kTextGap_px = 12; // distance of texts on one line
constexpr int kFactColumns = 12;
constexpr int kLinesOfWarning = 2;

BriefType right(BriefType type)
{
    type.isRight = true;
    return type;
}

/** Limits for the parts of the page, the most generous first. */
struct BriefShares
{
    int warningLines = 0;
    int noteLines = 0;
    double map_px = 0; ///< smallest height
};
constexpr std::array<BriefShares, 3> kShares{{{10, 5, 360}, {7, 3, 300}, {5, 1, 240}}};

constexpr std::array<BriefTableStyle, 5> kTableStyles{
    {{12, 1}, {11, 1}, {10, 1}, {10, 2}, {kSmallestBriefType_px, 2}}};

/** Lays out the blocks of a page from top to bottom. */
class Page
{
public:
    Page(const BriefContent& content, const QSizeF& page) : m_content(content), m_composer(page) {}

    BriefLayout laidOut()
    {
        setHead();
        m_composer.setFacts(m_content.flight, kFactColumns);
        m_composer.setFacts(m_content.planning, kFactColumns);
        m_composer.takeStrip(4);
        setUavs();
        setFoot();
        setBody();
        return std::move(m_composer.layout);
    }

private:
    void rule(double y, bool isStrong)
    {
        m_composer.layout.rules.push_back(
            {QLineF(m_composer.free.left(), y, m_composer.free.right(), y), isStrong});
    }

    /** Sets two texts on one line; the second one is shortened last. */
    void setPair(const QRectF& strip, const QString& first, const BriefType& firstType,
                 const QString& second, const BriefType& secondType)
    {
        const double second_px =
            std::min(std::ceil(widthOf_px(second, secondType)) + 1, 0.6 * strip.width());
        setText(m_composer.layout, strip.adjusted(0, 0, -second_px - kTextGap_px, 0), first,
                firstType);
        setText(m_composer.layout, strip.adjusted(strip.width() - second_px, 0, 0, 0), second,
                right(secondType));
    }

    void setHead()
    {
        setPair(m_composer.takeStrip(linePitch_px(kBriefTitle.size_px)), m_content.title,
                kBriefTitle, u"Bergwatch"_s, kBriefCaption);
        setPair(m_composer.takeStrip(linePitch_px(kBriefHead.size_px)),
                u"%1 · %2"_s.arg(FlightBrief::tr("Flight brief: %1").arg(m_content.about),
                                 m_content.origin),
                kBriefHead, m_content.start, {.size_px = kBriefHead.size_px, .isBold = true});
        rule(m_composer.takeStrip(4).bottom(), true);
        m_composer.takeStrip(5);
    }

    void setUavs()
    {
        rule(m_composer.free.top(), false);
        m_composer.takeStrip(3);
        m_composer.setUavTable(m_content.uavs);
        if (!m_content.sorties.empty())
            m_composer.setUavTable(m_content.sorties);
        m_composer.takeStrip(6);
    }

    void setFoot()
    {
        const double height_px = linePitch_px(kBriefFoot.size_px);
        const QRectF strip(m_composer.free.left(), m_composer.free.bottom() - height_px,
                           m_composer.free.width(), height_px);
        m_composer.free.setBottom(strip.top() - 3);
        rule(m_composer.free.bottom(), false);
        setText(m_composer.layout, strip, m_content.foot, kBriefFoot);
    }

    [[nodiscard]] QStringList warningLines(int most) const
    {
        QStringList lines;
        for (qsizetype i = 0; i < m_content.warnings.size(); ++i) {
            const QStringList more = wrapped(u"– "_s + m_content.warnings[i], kWords,
                                             m_composer.free.width(), kLinesOfWarning);
            const qsizetype left = m_content.warnings.size() - i;
            // If there are more warnings, the last line says so.
            if (lines.size() + more.size() > most - (left > 1 ? 1 : 0)) {
                lines << FlightBrief::tr("and %1 more").arg(left);
                break;
            }
            lines << more;
        }
        return lines;
    }

    [[nodiscard]] static double heightOf_px(const QStringList& lines)
    {
        return lines.isEmpty()
                   ? 0
                   : linePitch_px(kHeading.size_px) + kBlockGap_px +
                         static_cast<double>(lines.size()) * linePitch_px(kWords.size_px);
    }

    void setLines(const QString& heading, const QStringList& lines)
    {
        if (lines.isEmpty())
            return;
        m_composer.takeStrip(kBlockGap_px);
        setText(m_composer.layout, m_composer.takeStrip(linePitch_px(kHeading.size_px)), heading,
                kHeading);
        for (const QString& line : lines)
            setText(m_composer.layout, m_composer.takeStrip(linePitch_px(kWords.size_px)), line,
                    kWords);
    }

    [[nodiscard]] QStringList noteLines(int most) const
    {
        return m_content.notes.isEmpty()
                   ? QStringList()
                   : wrapped(m_content.notes, kWords, m_composer.free.width(), most);
    }

    /** Height of the texts below the table. */
    [[nodiscard]] double words_px(const BriefShares& shares) const
    {
        const QStringList warnings = warningLines(shares.warningLines);
        return (warnings.isEmpty() ? kBlockGap_px + linePitch_px(kHeading.size_px)
                                   : heightOf_px(warnings)) +
               heightOf_px(noteLines(shares.noteLines)) + kBlockGap_px;
    }

    /** Space left for the table. */
    [[nodiscard]] QSizeF tableRoom(const BriefShares& shares) const
    {
        return {m_composer.free.width(),
                m_composer.free.height() - words_px(shares) - shares.map_px - kBlockGap_px};
    }

    /** Sets map, table and texts with the first limits that fit the whole table, or the last. */
    void setBody()
    {
        const BriefTable table(m_content);
        for (const BriefShares& shares : kShares)
            for (const BriefTableStyle& style : kTableStyles)
                if (table.fitsInto(tableRoom(shares), style))
                    return setBody(table, style, shares);
        setBody(table, kTableStyles.back(), kShares.back());
    }

    void setBody(const BriefTable& table, const BriefTableStyle& style, const BriefShares& shares)
    {
        const double table_px = table.heightIn_px(tableRoom(shares).height(), style);
        m_composer.layout.map = m_composer.takeStrip(m_composer.free.height() - words_px(shares) -
                                                     table_px - kBlockGap_px);
        m_composer.takeStrip(kBlockGap_px);
        table.setInto(m_composer.layout, m_composer.takeStrip(table_px), style);
        const QStringList warnings = warningLines(shares.warningLines);
        if (warnings.isEmpty()) {
            m_composer.takeStrip(kBlockGap_px);
            setText(m_composer.layout, m_composer.takeStrip(linePitch_px(kHeading.size_px)),
                    FlightBrief::tr("No warnings"), kHeading);
        }
        setLines(FlightBrief::tr("Warnings (%1)").arg(m_content.warnings.size()), warnings);
        setLines(FlightBrief::tr("Notes"), noteLines(shares.noteLines));
    }

    const BriefContent& m_content;
    PageComposer m_composer;
};

} // namespace

BriefLayout layOutBrief(const BriefContent& content, const QSizeF& page)
{
    return Page(content, page).laidOut();
}

} // namespace berg
